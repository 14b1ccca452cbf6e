"""Where expressions are defined, or smooth, at every point: what is shown, and what is not."""

import pytest
from cases import cases

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
