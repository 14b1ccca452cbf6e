"""Best constants and ends of regions: the true number, by mpmath, lies in the bracket."""

from fractions import Fraction

import mpmath
import pytest

import tresym
from tresym.accuracy.bracketing import best, holds_from
from tresym.commands import main
from tresym.reals.numbers.exact import InputError


def ends(found: object) -> tuple[Fraction, Fraction]:
    assert found is not None
    low, high = sorted((Fraction(found.holds), Fraction(found.fails)))  # type: ignore[attr-defined]
    return low, high


@pytest.mark.slow
@pytest.mark.parametrize(
    ("claim", "given", "truth"),
    [
        ("log(x) <= c*sqrt(x)", "x > 0", float(2 / mpmath.e)),
        ("x*exp(-x) <= c", "", float(1 / mpmath.e)),
    ],
)
def test_the_best_constant_lies_in_the_bracket(claim: str, given: str, truth: float) -> None:
    found = best(claim, "c", given)
    low, high = ends(found)
    assert low <= truth <= high
    assert high - low <= max(high, -low) / 100
    assert found is not None
    assert found.monotone
    assert tresym.check(found.claim)
    assert tresym.check(found.refuted).verdict is tresym.Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(
    ("claim", "path", "truth"),
    [
        # the root of 1 - sin(x)/x = 1/1000
        ("abs(sin(x) - x) <= x/1000", "x -> 0+", 0.0774713),
        ("1 - tanh(x) <= 1/1000", "x -> oo", float(mpmath.atanh(mpmath.mpf(999) / 1000))),
        ("abs(x - 1) <= 1/8", "x -> 1", 0.125),
    ],
)
def test_the_end_of_the_region_lies_in_the_bracket(claim: str, path: str, truth: float) -> None:
    found = holds_from(claim, path)
    low, high = ends(found)
    assert low <= truth <= high
    assert found is not None
    assert (Fraction(found.holds) > Fraction(found.fails)) == path.endswith("oo")


def test_without_monotony_no_best_constant_is_named() -> None:
    found = best("(c - 1)**2 + x**2 >= 1/2", "c")
    assert found is not None
    assert found.monotone is None
    assert "monotony in c is not shown" in str(found)


@pytest.mark.parametrize(("claim", "path"), [("x >= 10", "x -> 0+"), ("x**2 >= 0", "x -> oo")])
def test_nothing_is_found_where_a_claim_never_changes(claim: str, path: str) -> None:
    assert holds_from(claim, path) is None


@pytest.mark.parametrize(
    ("claim", "given", "says"),
    [
        ("x <= d", "", "does not contain c"),
        ("x <= c", "c > 0", "would restrict"),
        ("x <= c as x -> 0", "", "without a path or region"),
        ("x <= c on x > 1", "", "without a path or region"),
    ],
)
def test_what_cannot_be_sought_is_refused(claim: str, given: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        best(claim, "c", given)


def test_the_command_asks_for_one_of_both(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["best", "x <= c"]) == 2
    assert main(["best", "x <= c", "--of", "c", "--as", "x -> 0"]) == 2
    capsys.readouterr()
    assert main(["best", "abs(x) >= c", "--of", "c", "--json"]) == 0
    assert '"monotone": true' in capsys.readouterr().out
