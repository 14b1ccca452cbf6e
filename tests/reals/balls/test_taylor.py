"""Taylor's theorem over an interval: it holds what the function does there, and little more."""

from itertools import product

import pytest
from cases import cases
from flint import arb, ctx, fmpq

from tresym.reals.balls.taylor import taylor_value
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

pytestmark = pytest.mark.quick

TEXTS = cases(__file__, "TEXTS")


def test_it_contains_the_values() -> None:
    for text, (low, high) in product(TEXTS, [("1/2", "3/4"), ("1", "5/4"), ("1.99", "2")]):
        e = parse(text)
        with ball_precision():
            ends = [evaluate(parse(end), {}) for end in (low, high)]
            x = ends[0].union(ends[1])
            for terms in (1, 2, 8):
                found = taylor_value(e, "x", x, terms)
                assert found.is_finite()
                for k in range(11):
                    at = ends[0] + (ends[1] - ends[0]) * k / 10
                    assert found.overlaps(evaluate(e, {"x": at}))
                    assert not evaluate(e, {"x": at}) > found.upper()
                    assert not evaluate(e, {"x": at}) < found.lower()


def test_what_cancels_is_seen() -> None:
    e = parse("exp(x) - (1 + x + x**2/2 + x**3/6 + x**4/24)")
    with ball_precision():
        x = arb(0).union(arb(fmpq(1, 16)))
        assert abs(taylor_value(e, "x", x)) < arb(fmpq(1, 10**6))
        assert not abs(evaluate(e, {"x": x})) < arb(fmpq(1, 100))


@pytest.mark.parametrize(
    "text", ["log(x)", "1/x", "sqrt(x)", "abs(x)", "cbrt(x)", "sign(x)", "1/x**2"]
)
def test_nothing_is_found_over_what_is_not_smooth(text: str) -> None:
    before = ctx.cap
    with ball_precision():
        assert not taylor_value(parse(text), "x", arb(0, 1)).is_finite()
    assert ctx.cap == before
