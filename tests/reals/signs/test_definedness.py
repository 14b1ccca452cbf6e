"""Where expressions are defined, or smooth, at every point: what is shown, and what is not."""

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.signs.definedness import continuous_on, is_lasting, undefined
from tresym.reals.signs.sign import proof

# an expression, conditions that show it defined, and weaker ones that do not
TABLE = cases(__file__, "TABLE")


@pytest.mark.parametrize(("text", "enough", "_"), TABLE)
def test_what_is_defined(text: str, enough: str | None, _: object) -> None:
    assert enough is None or undefined(parse(text), Given.parse(enough)) is None


@pytest.mark.parametrize(("text", "_", "weaker"), TABLE)
def test_what_is_not_shown(text: str, _: object, weaker: str | None) -> None:
    for prover in (None, proof):
        assert weaker is None or undefined(parse(text), Given.parse(weaker), prover) is not None


def test_every_method_may_be_asked() -> None:
    """That exp(x) is above 1 + x is a matter for Taylor's theorem."""
    e, given = parse("log(exp(x) - 1 - x)"), Given.parse("0 < x < 1")
    assert undefined(e, given) is not None
    assert undefined(e, given, proof) is None


@pytest.mark.parametrize(
    ("text", "conditions", "smooth"),
    cases(__file__, "smooth_is_more_than_defined"),
)
def test_smooth_is_more_than_defined(text: str, conditions: str, smooth: bool) -> None:
    assert (continuous_on(parse(text), Given.parse(conditions)) is None) is smooth


@pytest.mark.parametrize(
    ("e", "lasting"),
    cases(__file__, "whether_something_is_said_of_every_n"),
)
def test_whether_something_is_said_of_every_n(e: str, lasting: bool) -> None:
    given = Given(((parse("n"), ">=", parse("0")),))
    (claim,) = read(f"{e} == 0").comparisons
    assert is_lasting((claim.left,), given, "n", "S") is lasting


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("asin(R/R) == pi/2", "PROVED"),
        ("asin(R/R) == pi", "REFUTED"),
        ("acosh(x/x) == 0", "PROVED"),
        ("sqrt(x - x) + y == y", "PROVED"),
        ("sqrt(x - abs(x)) == 0 given x > 0", "PROVED"),
        ("sqrt(x - abs(x)) == 1", "UNDECIDED"),
        ("asin(x/x + 1/10) == pi/2", "UNDECIDED"),
        ("asin(x/x)/(y - y) == pi/2", "UNDECIDED"),  # still nowhere defined
        ("sqrt(x - x)/sqrt(x - x) == 1", "UNDECIDED"),
        ("acos(x/x) == 0 given x < 0, x > 0", "UNDECIDED"),
        ("asin(sign(x)) == pi/2", "REFUTED"),  # 1 on one side alone
        ("asin(x/x) >= 2", "REFUTED"),
        ("integral(sqrt(R**2 - x**2), x, 0, R) == pi*R**2/4 given R > 0", "PROVED"),
        ("integral(sqrt(R**2 - x**2), x, 0, R) == pi*R**2/2 given R > 0", "REFUTED"),
    ],
)
def test_an_operand_at_the_end_of_the_domain_everywhere(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict
