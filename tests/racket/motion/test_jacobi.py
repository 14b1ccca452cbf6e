"""Jacobi's functions: mpmath's, their laws, the elementary ends, and what the series leaves out."""

from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.motion.jacobi import functions, parameter, thetas
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision

moduli = st.one_of(
    st.fractions("1/1000", "999/1000"),
    st.integers(3, 40).map(lambda n: fmpq(1, 10**n)),
    st.integers(3, 40).map(lambda n: 1 - fmpq(1, 10**n)),
)


def exact(x: Any) -> fmpq:
    return x if isinstance(x, fmpq) else fmpq(*x.as_integer_ratio())


def quarter(complement: arb) -> arb:
    """K = π/(2 agm(1, k′))."""
    return arb.pi() / (2 * arb(1).agm(complement.sqrt()))


@given(moduli, st.fractions(-1, 1))
def test_they_are_mpmath_s(modulus: Any, part: Any) -> None:
    m = exact(modulus)
    with ball_precision(200), mp_precision(110) as mp:
        u = quarter(arb(1 - m)) * arb(exact(part)) * arb("0.999")
        found = functions(parameter(arb(m), arb(1 - m)), u)
        number = mp.mpf(int(m.p)) / int(m.q)
        for name, ball in (("sn", found.sn), ("cn", found.cn), ("dn", found.dn)):
            truth = mp.ellipfun(name, mp.mpf(u.mid().str(60, radius=False)), m=number)
            assert abs(ball - arb(mpmath.nstr(truth, 60))) < 1e-40
            assert ball.rad() < 1e-40


@given(moduli, st.fractions("1/100", "99/100"))
def test_the_laws(modulus: Any, part: Any) -> None:
    """Squares, sn′ = cn dn as a difference, and K − u (DLMF 22.4.3)."""
    m = exact(modulus)
    with ball_precision(400):
        of, whole = parameter(arb(m), arb(1 - m)), quarter(arb(1 - m))
        u = (whole * arb(exact(part))).mid()
        at, step = functions(of, u), arb((1, -120))
        assert (at.sn**2 + at.cn**2).contains(1)
        assert (at.dn**2 + arb(m) * at.sn**2).contains(1)
        slope = (functions(of, u + step).sn - functions(of, u - step).sn) / (2 * step)
        assert abs(slope - at.cn * at.dn) < 1e-60
        other = functions(of, whole - u)
        assert other.sn.overlaps(at.cn / at.dn)
        assert other.dn.overlaps(arb(1 - m).sqrt() / at.dn)
        assert not other.sn.overlaps(at.cn / at.dn * (1 + arb("1e-30")))


def test_at_the_far_end_of_the_quarter() -> None:
    for m in (fmpq(1, 10), fmpq(1, 2), fmpq(9, 10), 1 - fmpq(1, 10**30)):
        with ball_precision(300):
            at = functions(parameter(arb(m), arb(1 - m)), quarter(arb(1 - m)))
            assert at.sn.contains(1)
            assert at.cn.contains(0)
            assert at.dn.overlaps(arb(1 - m).sqrt())
            assert at.cn.rad() < 1e-50


@pytest.mark.parametrize("u", ["0", "0.3", "-2", "40"])
def test_the_elementary_ends(u: str) -> None:
    with ball_precision(300):
        x = arb(u)
        circular = functions(parameter(arb(0), arb(1)), x)
        assert circular.sn.overlaps(x.sin())
        assert circular.cn.overlaps(x.cos())
        assert circular.dn == 1
        hyperbolic = functions(parameter(arb(1), arb(0)), x)
        assert hyperbolic.sn.overlaps(x.tanh())
        assert hyperbolic.cn.overlaps(1 / x.cosh())
        assert hyperbolic.dn.overlaps(1 / x.cosh())
        # And their neighbours go over into them.
        tiny = arb(10) ** -60
        near = functions(parameter(tiny, 1 - tiny), x) if abs(x) < 1 else circular
        assert abs(near.sn - circular.sn) < 1e-55
        near = functions(parameter(1 - tiny, tiny), x)
        assert abs(near.dn - hyperbolic.dn) < 1e-20


@pytest.mark.parametrize("q", ["0.001", "0.04", "0.3", "0.49"])
@pytest.mark.parametrize("z", ["0", "0.7", "1.5", "0.1j", "1.3j"])
def test_the_theta_series(q: str, z: str) -> None:
    with ball_precision(150), mp_precision(45) as mp:
        hyperbolic = z.endswith("j")
        y = arb(z.rstrip("j"))
        sin, cos = y.sinh_cosh() if hyperbolic else y.sin_cos()
        found = thetas(arb(q), sin, cos, hyperbolic)
        point, nome = mp.mpf(z.rstrip("j")) * (mp.j if hyperbolic else 1), mp.mpf(q)
        for n, ball in enumerate(found, start=1):
            truth = mp.jtheta(n, point, nome) / (nome ** mp.mpf("0.25") if n < 3 else 1)
            truth = mp.im(truth) if n == 1 and hyperbolic else mp.re(truth)
            assert abs(ball - arb(mpmath.nstr(truth, 42))) < 1e-35
            assert ball.rad() < 1e-35


@pytest.mark.parametrize("precision", [24, 53, 64])
@pytest.mark.parametrize("hyperbolic", [False, True])
def test_what_the_series_leaves_out_is_in_the_ball(precision: int, hyperbolic: bool) -> None:
    """At q = 2⁻⁴ and argument 0 every term is exact: nothing but the rest makes the ball wide."""
    for exponent in (-3, -4, -6, -9):
        with ball_precision(precision):
            found = thetas(arb((1, exponent)), arb(0), arb(1), hyperbolic)
        with ball_precision(600):
            truth = thetas(arb((1, exponent)), arb(0), arb(1), hyperbolic)
            for ball, fine in zip(found, truth, strict=True):
                assert ball.contains(fine)


@pytest.mark.parametrize("q", ["0.5", "0.6", "0.4 +/- 0.2", "nan", "1"])
def test_a_nome_that_is_too_large_is_refused(q: str) -> None:
    with ball_precision(64), pytest.raises(ArithmeticError, match="too wide"):
        thetas(arb(q), arb(0), arb(1), False)


def test_an_uncertain_modulus_holds_all_of_its_functions() -> None:
    """Balls around k² and 1 − k²: the functions of every k² in them."""
    for middle in (fmpq(3, 10), fmpq(1, 2), fmpq(8, 10)):
        with ball_precision(120):
            wide = arb(arb(middle).mid(), "1e-6")
            found = functions(parameter(wide, 1 - wide), arb(1))
            for shift in (-1, 0, 1):
                m = middle + shift * fmpq(9, 10**7)
                inner = functions(parameter(arb(m), arb(1 - m)), arb(1))
                assert found.sn.contains(inner.sn)
                assert found.cn.contains(inner.cn)
                assert found.dn.contains(inner.dn)
            out = functions(parameter(arb(middle + fmpq(1, 10)), arb(fmpq(9, 10) - middle)), arb(1))
            assert not found.sn.overlaps(out.sn)
