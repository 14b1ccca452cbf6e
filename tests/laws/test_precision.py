"""Precision never leaks, and numbers survive text: laws of the border."""

from contextlib import suppress
from fractions import Fraction

import mpmath
from flint import arb, ctx, fmpq
from hypothesis import strategies as st
from strategies import law, rational, shapes

from tresym import InputError, flip_angle, flip_defect
from tresym.racket.body import Shape
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.numbers.exact import fraction_text, parse_number


@law(st.lists(st.tuples(shapes(-3, 2), st.integers(1, 90), st.booleans()), min_size=1, max_size=6))
def test_precision_never_leaks(calls: list[tuple[Shape, int, bool]]) -> None:
    before, places = ctx.prec, mpmath.mp.prec
    alone = [flip_defect(*shape, digits=n).as_json()["defect"] for shape, n, _ in calls]
    for (shape, digits, good), expected in zip(calls, alone, strict=True):
        with ball_precision(37 + digits), mp_precision(digits):
            inside, mp_inside = ctx.prec, mpmath.mp.prec
            if good:
                assert flip_defect(*shape, digits=digits).as_json()["defect"] == expected
                flip_angle(*shape, "1/10", 0, min(digits, 30))
            else:
                for bad in (("1", "2"), ("nan", "1"), ("1", "1", "7")):
                    with suppress(InputError):
                        flip_defect(*bad, digits=digits)
            assert (ctx.prec, mpmath.mp.prec) == (inside, mp_inside)
    assert (ctx.prec, mpmath.mp.prec) == (before, places)


@law(st.fractions(), st.integers(-300, 300))
def test_numbers_survive_text(value: Fraction, power: int) -> None:
    x = rational(value) * fmpq(10) ** power
    assert parse_number(fraction_text(x)) == x
    assert proves(arb(x), 1) or x == 0
