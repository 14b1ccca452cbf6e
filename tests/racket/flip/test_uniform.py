"""The explicit formulas for every shape: their definitions, and the errors that are promised."""

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.flip import uniform
from tresym.racket.flip.separatrix import solve
from tresym.reals.numbers.arithmetic import ball_precision, balls, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number

PROMISED = {
    "one_line": (uniform.one_line, "0", "0.028"),
    "balanced": (uniform.balanced, "-0.0065", "0.0065"),
    "one step from pi": (lambda a, b, m: uniform.one_step(a, b, m, m.pi), "-1e-4", "0"),
    "one step": (uniform.one_step, "-4e-6", "0"),
}
"""Each formula, with the least and the largest of formula/ε₀ − 1."""

GRID = [
    (fmpq(k, 1000) ** 2 / fmpq(b, 20), fmpq(b, 20))
    for k in (1, 50, 100, 150, 200, 250, 300)
    for b in (2, 3, 4, 6, 7, 8, 10, 14, 18, 20)
]


def error(name: str, a: fmpq, b: fmpq) -> arb:
    exact = solve(a, b, 40).defect
    with ball_precision(400):
        return PROMISED[name][0](arb(a), arb(b), balls) / exact - 1


@given(
    st.fractions("1/100", 1, max_denominator=10**6),
    st.fractions(1, 1000, max_denominator=10**6),
    st.integers(-6, 2),
)
def test_no_shape_has_a_larger_error_than_promised(b: Fraction, part: Fraction, power: int) -> None:
    a = part * Fraction(10) ** power / b
    shape = fmpq(a.numerator, a.denominator), fmpq(b.numerator, b.denominator)
    for name, (_, low, high) in PROMISED.items():
        found = error(name, *shape)
        assert found > arb(low) or found.overlaps(arb(low))
        assert found < arb(high) or found.overlaps(arb(high))


@pytest.mark.parametrize(
    ("name", "worse"),
    [("one_line", "0.027"), ("balanced", "-0.0064"), ("balanced", "0.0061"),
     ("one step from pi", "-7e-5"), ("one step", "-2.6e-6")],
)  # fmt: skip
def test_less_than_promised_is_not_kept(name: str, worse: str) -> None:
    found = [error(name, *shape) for shape in GRID]
    bound = arb(worse)
    assert any(x > bound if bound > 0 else x < bound for x in found)


@pytest.mark.parametrize(("a", "b"), [("12.5", "0.06"), ("1/100", "1"), ("1", "1/2"), ("400", "1")])
def test_they_are_the_printed_lines(a: str, b: str) -> None:
    """tan ε = √(a/(a+b))/sinh(√(ab) P) with P from one sweep, by mpmath."""
    shape = parse_number(a), parse_number(b)
    with mp_precision(60) as mp:
        p, q = (to_mp(x, mp) for x in shape)
        k, r = mp.sqrt(p * q), mp.sqrt(q / p)
        for formula, start in ((uniform.one_line, mp.pi), (uniform.balanced, mp.mpf(4))):
            phase = mp.pi + mp.atan(r * mp.tanh(start * k))
            tangent = mp.sqrt(p / (p + q)) / mp.sinh(k * phase)
            assert abs(mp.tan(formula(p, q, mp)) / tangent - 1) < mp.mpf(10) ** -50

        def residual(x: object) -> object:
            return x - mp.pi - mp.atan(r * mp.tanh(k * x))

        phase = mp.pi + mp.atan(r * mp.tanh(4 * k))
        step = phase - residual(phase) / mp.diff(residual, phase)
        assert abs(uniform.newton_phase(4, k, r, mp) / step - 1) < mp.mpf(10) ** -20
        tangent = mp.sqrt(p / (p + q)) / mp.sinh(k * step)
        assert abs(mp.tan(uniform.one_step(p, q, mp)) / tangent - 1) < mp.mpf(10) ** -18


@pytest.mark.parametrize(("a", "b"), [("12.5", "0.06"), ("1/100", "1"), ("1", "1/2")])
def test_from_the_phase_itself_nothing_changes(a: str, b: str) -> None:
    p, q = parse_number(a), parse_number(b)
    phase = solve(p, q, 60).phase
    with ball_precision(260):
        k, r = arb(p * q).sqrt(), arb(q / p).sqrt()
        assert uniform.swept_phase(phase, k, r, balls).overlaps(phase)
        assert uniform.newton_phase(phase, k, r, balls).overlaps(phase)
        assert not uniform.swept_phase(phase + arb("1e-9"), k, r, balls).overlaps(phase)
