"""Integer variables: angles and signs by residues, refuted at integers alone."""

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.integer_variables import residues
from tresym.reals.domain.conditions import Given
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")
FAIL = cases(__file__, "FAIL")
OPEN = [
    "n == 1 given n integer, n > 1/4, n < 3/4",  # no integer
    "n == 1 given 2*n == 3, n integer",
    "sin(n*sqrt(2)*pi) != 0 given n integer, n >= 1",
    "abs(n - 1/2) >= 1/2 given n integer, n > 10**6, n < 10**6 + 1",
]


@pytest.mark.parametrize("claim", HOLD)
def test_what_holds_of_integers(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.ENCLOSED)


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_of_them_fails_at_an_integer(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
    assert int(answer.witness["n"]) is not None


@pytest.mark.parametrize("claim", OPEN)
def test_what_is_open(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


def test_without_the_condition_a_variable_is_real() -> None:
    assert tresym.check("sin(n*pi) == 0").verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("(-1)**(n**2) == (-1)**n given n integer", "PROVED"),
        ("(-1)**(n**2) == (-1)**(n + 1) given n integer", "REFUTED"),
        ("(-1)**(n*(n + 1)) == 1 given n integer", "PROVED"),
        ("(-1)**(n*(n + 1)/2) == (-1)**n given n integer", "REFUTED"),
        ("cos(n**2*pi) == (-1)**n given n integer", "PROVED"),
        ("sin(n*(n + 1)*pi/2) == 0 given n integer", "PROVED"),
        ("sin(n*(n + 1)*pi/4) == 0 given n integer", "REFUTED"),
        ("(-1)**(n**2/3) == 1 given n integer", "REFUTED"),
        ("cos(n**2*pi*x) == 1 given n integer", "REFUTED"),
        ("n**2 - 3*m**2 != 2 given n integer, m integer", "PROVED"),
        ("n**2 - 3*m**2 != 1 given n integer, m integer", "REFUTED"),
        ("n**2 - 3*m**2 != 2 given n integer", "REFUTED"),  # m is real
        ("n**2 - 2*m**2 != 1 given n integer, m integer, m > 0", "REFUTED"),
        ("n**2 - 61*m**2 != 1 given n integer, m integer, m > 0", "UNDECIDED"),  # far away
        ("n**2 + m**2 != 4*k + 3 given n integer, m integer, k integer", "PROVED"),
        ("n**2 + m**2 != 4*k + 2 given n integer, m integer, k integer", "REFUTED"),
        ("n**3 + m**3 != 4 given n integer, m integer", "PROVED"),
        ("n**2/2 + n/2 != 1/3 given n integer", "PROVED"),
        ("n**2/2 + n/2 != 3 given n integer", "REFUTED"),
        ("2*n != 2*m + 1 given n integer, m integer, n > 3, n < 2", "UNDECIDED"),
    ],
)
def test_polynomials_in_integers(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict


@pytest.mark.parametrize(("angle", "count"), [("6", 42), ("8", None)])
def test_a_claim_is_split_into_all_residue_classes_or_into_none(
    angle: str, count: int | None
) -> None:
    statement = read(f"cos(2*pi*n/7)*cos(2*pi*m/{angle}) == 1 given n integer, m integer")
    cases = residues(statement.comparisons[0], statement, ("n", "m"), Given())
    assert (cases and len(cases)) == count
