"""The sign beside a point and towards infinity: on all of the neighbourhood named, or none."""

from __future__ import annotations

import pytest
from flint import arb, ctx, fmpq

from tresym.reals.balls.ends import sign_beside
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.values import evaluate

SIGNS = [
    # (function, point or infinity, sign above or at +oo, sign below or at -oo)
    ("sin(x) - x", "0", -1, 1),
    ("sin(x) - x + x**3/6 - x**5/120", "0", -1, 1),
    ("sqrt(x) - x", "0", 1, None),
    ("cbrt(x) + x**2", "0", 1, -1),
    ("x**(1/6) - 2*x**(1/2)", "0", 1, None),
    ("log(x) + 1/sqrt(x)", "0", 1, None),
    ("x*log(x)", "0", -1, None),
    ("exp(1/x) - 1/x**20", "0", 1, -1),
    ("1/x + 10**6", "0", 1, -1),
    ("1 - x*exp(-1/x**2)", "0", 1, 1),
    ("acos(x)", "1", None, 1),
    ("acos(x) - sqrt(2 - 2*x)", "1", None, None),
    ("tan(x)", "pi/2", -1, 1),
    ("cos(x) + x - pi/2", "pi/2", 1, -1),
    ("abs(x - 1) - (x - 1)", "1", 0, 1),
    ("sin(x)**2 + cos(x)**2 - 1", "0", None, None),
    ("atan(x) - pi/2 + 1/x", "oo", 1, -1),
    ("atan(x) - pi/2 + 1/x - 1/(3*x**3)", "oo", -1, -1),
    ("x - 100*log(x)", "oo", 1, None),
    ("x**5*exp(-x) - 1/x", "oo", -1, -1),
    ("sqrt(x**2 + 1) - x", "oo", 1, 1),
    ("sqrt(x**2 + 1) - x - 1/(2*x)", "oo", -1, 1),
    ("tanh(x) - 1 + 3*exp(-2*x)", "oo", 1, 1),
    ("x - x", "oo", 0, 0),
    # what oscillates, or is not defined, has no sign
    ("sin(1/x)", "0", None, None),
    ("x*sin(1/x) + x**2", "0", None, None),
    ("sin(x)", "oo", None, None),
    ("1 + sin(x)", "oo", None, None),
    ("sqrt(x)", "0", 1, None),
    ("log(-1 - x**2)", "0", None, None),
    ("x + 2*x*sin(x**2)", "oo", None, None),
]


@pytest.mark.parametrize(("text", "at", "above", "below"), SIGNS)
def test_the_sign_beside_a_point(text: str, at: str, above: int | None, below: int | None) -> None:
    e, point = parse(text), None if at == "oo" else parse(at)
    before = ctx.prec, ctx.cap
    for side, expected in ((1, above), (-1, below)):
        found = sign_beside(e, "x", point, side)
        assert (None if found is None else found[0]) == expected
        if found is None:
            continue
        sign, reach = found
        with ball_precision(3000):
            for k in range(1, 17):
                t = arb(reach * fmpq(k, 16))
                x = side / t if point is None else evaluate(point, {}) + side * t
                value = evaluate(e, {"x": x})
                assert sign * value > 0 or (sign == 0 and value.contains(0))
    assert (ctx.prec, ctx.cap) == before


@pytest.mark.parametrize("gap", ["1/10", "1/100", "1/1000"])
@pytest.mark.parametrize("side", [1, -1])
def test_the_neighbourhood_ends_before_the_next_zero(gap: str, side: int) -> None:
    found = sign_beside(parse(f"x**2*(x - {gap})*(x + {gap})"), "x", parse("0"), side)
    assert found is not None
    assert found[0] == -1
    assert found[1] < fmpq(*map(int, gap.split("/")))


@pytest.mark.parametrize("digits", [5, 9, 20, 60])
def test_a_zero_near_by_is_not_passed_over(digits: int) -> None:
    zero = fmpq(1, 10**digits)
    for text, at in ((f"x - 10**(-{digits})", parse("0")), (f"x - 10**{digits}", None)):
        found = sign_beside(parse(text), "x", at, 1)
        assert found is None or (found[1] < zero and found[0] == (-1 if at else 1))
