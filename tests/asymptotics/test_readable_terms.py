"""Leading terms are written as short as their value allows, and keep it."""

import pytest
from flint import arb

from tresym.asymptotics.readable_terms import readable
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

TERMS = [
    ("t**2*exp(-1)*exp(pi*pi*sqrt(t**(-2))/(-pi))/5", 1, "t**2*exp((-pi - t)/t)/5"),
    ("exp(-x)*exp(sqrt(x))", 1, "exp(sqrt(x) - x)"),
    ("x*sqrt(x**2)", 0, "x*sqrt(x**2)"),
    ("exp(x)*exp(1/x)*x", -1, None),
]


@pytest.mark.parametrize(("text", "side", "short"), TERMS)
def test_a_term_is_short_and_has_the_same_value(text: str, side: int, short: str | None) -> None:
    name = "t" if "t**" in text else "x"
    term = parse(text)
    found = readable(term, name, side)
    assert len(str(found)) <= len(str(term))
    if short is not None:
        assert str(found) == str(parse(short))
    with ball_precision(128):
        for value in ("0.3", "1.7", "12"):
            at = {name: arb(value) * (side or -1)}
            assert evaluate(term, at).overlaps(evaluate(found, at)), value
