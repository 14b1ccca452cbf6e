"""The closed formula's proved bound: both sides of it at shapes, and balls that hold the root."""

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.flip import asymptotic
from tresym.racket.flip.asymptotic import LARGEST_K, enclose, reach
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number

SHAPES = [
    ("12.5", "0.06"), ("1/10", "1"), ("1", "1"), ("1/3", "9/10"), ("2", "1/2"), ("100", "1"),
    ("1e-2", "1"), ("9", "1/6"), ("1e4", "1/10000"),
]  # fmt: skip


def pair(shape: tuple[str, str]) -> tuple[fmpq, fmpq]:
    return parse_number(shape[0]), parse_number(shape[1])


def root(a: fmpq, b: fmpq, digits: int = 80) -> mpmath.mpf:
    """ε₀ by mpmath: √(ab)(π + arcsin(√(b/(a+b)) cos ε)) = asinh(√(a/(a+b)) cot ε)."""
    with mp_precision(digits) as mp:
        p, q = to_mp(a, mp), to_mp(b, mp)
        k, mu = mp.sqrt(p * q), mp.sqrt(q / (p + q))

        def excess(x: mpmath.mpf) -> mpmath.mpf:
            e = mp.exp(x)
            whole = k * (mp.pi + mp.asin(mu * mp.cos(e)))
            return whole - mp.asinh(mp.sqrt(p / (p + q)) * mp.cot(e))

        ends = (-2 * mp.pi * k - 10, mp.log(mp.pi / 2))
        return mp.exp(mp.findroot(excess, ends, solver="anderson"))


@pytest.mark.parametrize("shape", SHAPES, ids="/".join)
def test_the_logarithm_is_the_integral_and_lies_between_the_bounds(shape: tuple[str, str]) -> None:
    a, b = pair(shape)
    e0 = root(a, b, 120)
    with mp_precision(110) as mp:
        p, q = to_mp(a, mp), to_mp(b, mp)
        k, R = mp.sqrt(p * q), q / p
        leading = 2 / mp.sqrt(1 + R) * mp.exp(-k * (mp.pi + mp.atan(mp.sqrt(R))))

        def integrand(t: mpmath.mpf) -> mpmath.mpf:
            s = mp.sin(t)
            return 1 / t - (1 - q * s * s) / (s * mp.sqrt(1 + R * s * s))

        log = mp.log(e0 / leading)
        assert (
            abs(log - mp.quad(integrand, [0, e0]))
            < mp.mpf(10) ** -90 + abs(log) * mp.mpf(10) ** -20
        )
        c1 = (6 * q - 1 + 3 * R) / 12
        C = to_mp(LARGEST_K, mp) + (q + R / 2) / 24 + (q * R / 2 + 3 * R**2 / 8) / 4
        assert c1 * e0**2 - C * e0**4 < log < c1 * e0**2
        assert abs(C / to_mp(asymptotic._quartic(b, b / a), mp) - 1) < 1e-45


def test_the_constant_is_an_upper_bound_and_near() -> None:
    with ball_precision(200):
        half = arb.pi() / 2
        exact = ((4 / arb.pi()).log() - arb.pi() ** 2 / 48) / half**4
        assert exact < arb(LARGEST_K)
        assert exact > arb(LARGEST_K) * arb("0.9999")
    with mp_precision(30) as mp:
        # (log(tan(e/2)/(e/2)) − e²/12)/e⁴ increases up to π/2, so that it is largest there.
        def part(e: mpmath.mpf) -> mpmath.mpf:
            return (mp.log(mp.tan(e / 2) / (e / 2)) - e * e / 12) / e**4

        values = [part(mp.mpf(i) / 20 * mp.pi / 2) for i in range(1, 21)]
        assert values == sorted(values)
        assert abs(values[-1] - mp.mpf(exact.str(20, radius=False))) < 1e-18


@pytest.mark.parametrize("shape", SHAPES, ids="/".join)
@pytest.mark.parametrize("digits", [1, 10, 60])
def test_the_ball_holds_the_root(shape: tuple[str, str], digits: int) -> None:
    found, truth = enclose(*pair(shape), digits), root(*pair(shape))
    assert found is not None
    with ball_precision(300):
        assert found.overlaps(arb(mpmath.nstr(truth, 75)))
        off = arb(mpmath.nstr(truth, 75)) + 3 * found.rad()
        assert not found.is_finite() or not found.overlaps(off)


@given(st.fractions("1/100", 50), st.fractions("1/100", 1))
def test_the_reach_is_about_the_digits_there_are(a: Fraction, b: Fraction) -> None:
    p, q = (fmpq(*x.as_integer_ratio()) for x in (a, b))
    estimate = reach(float(a), float(b))
    found = enclose(p, q, 200)
    assert found is not None
    had = found.rel_accuracy_bits() / 3.3219
    assert had < max(estimate, 0) + 3
    assert estimate < 5 or had > estimate - 5


@pytest.mark.parametrize("planted", ["0.1", "0.5", "0.9"])
def test_a_smaller_constant_would_leave_the_root_out(
    planted: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At one shape at least the constant is needed to a tenth of itself (b → 0 and R → 0 too)."""
    whole, out = asymptotic._quartic, 0
    monkeypatch.setattr(asymptotic, "_quartic", lambda b, R: whole(b, R) * arb(planted))
    for shape in SHAPES:
        found, truth = enclose(*pair(shape), 60), root(*pair(shape))
        with ball_precision(300):
            out += not found.overlaps(arb(mpmath.nstr(truth, 75)))
    assert out


def test_too_small_a_defect_is_left_to_others() -> None:
    assert enclose(fmpq(10**35), fmpq(1), 10) is None
    assert enclose(fmpq(10**34) - 10**20, fmpq(1), 10) is not None
