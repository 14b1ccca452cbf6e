"""Leading terms: the suites of others' limits by hand, and what must not be rewritten."""

import pytest
from cases import cases

from tresym.reals.expansions.gruntz import Rewritten
from tresym.reals.expansions.scale import UnresolvedError
from tresym.reals.language.expression import number, substitute, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

LIMITS = cases(__file__, "LIMITS")


@pytest.mark.quick
@pytest.mark.parametrize(("text", "limit"), LIMITS)
def test_limits_at_infinity(text: str, limit: str) -> None:
    found = Rewritten("t")
    with ball_precision():
        f = found.of(substitute(parse(text), {"x": 1 / symbol("t")}) - parse(limit))
        assert found.expansions.growth(f) < 0
        g = found.of(substitute(parse(text), {"x": 1 / symbol("t")}) - parse(f"{limit} + 1/10**40"))
        assert found.expansions.growth(g) == 0


@pytest.mark.quick
@pytest.mark.parametrize(
    "text",
    cases(__file__, "what_has_no_leading_term_gets_none"),
)
def test_what_has_no_leading_term_gets_none(text: str) -> None:
    """It is not defined near 0, may vanish again and again, or a wave grows."""
    found = Rewritten("t")
    with ball_precision(), pytest.raises(UnresolvedError):
        found._way(found.of(parse(text)))


def test_what_keeps_its_sign_near_zero_alone_is_noted() -> None:
    found = Rewritten("t")
    with ball_precision():
        assert found.of(parse("abs(t - 1/100)")) == -parse("_t - 1/100")
        assert found.signed == {parse("_t - 1/100")}


def test_a_phase_is_that_of_one_argument() -> None:
    found = Rewritten("t")
    with ball_precision():
        assert found.of(parse("sin(1/t)")) == parse("sin(_u0)")
        assert found.of(parse("cos(3/t + t)")) == parse("cos(3*_u0 + _t)")
        assert found.of(parse("sin(1/t**2)")) == parse("sin(_u1)")
        assert found.of(parse("sin(sqrt(2)/t)")) == parse("sin(_u2)")
        assert found.of(parse("sin(t)")) == parse("sin(_t)")
        halves = found.all_of(*map(parse, ("sin(1/t)", "sin(1/(2*t))", "sin(2/(3*t))")))
        assert halves == [parse("sin(6*_u0)"), parse("sin(3*_u0)"), parse("sin(4*_u0)")]
    assert found.of(number(3)) == number(3)
