"""How the defect bends: the candidate by differences, its bounds by quadrature, H″ by mpmath."""

from typing import Any

import mpmath
import pytest
from differences import defect_slope
from flint import arb, fmpq

from tresym.racket.bounds.bending import (
    Candidate,
    candidate,
    curvature,
    fourth_moment,
    second_order_rest,
)
from tresym.racket.flip.separatrix import solve
from tresym.reals.numbers.arithmetic import ball_precision, balls, mp_precision, to_mp

SHAPES = [
    (fmpq(1), fmpq(1)),
    (fmpq(3), fmpq(1, 5)),
    (fmpq(25, 2), fmpq(3, 50)),
    (fmpq(9), fmpq(4, 5)),
]
LEVELS = ["-0.9", "-0.3", "0", "0.4", "1"]
WORK = 300


def number(x: arb) -> Any:
    return mpmath.mpf(x.mid().str(75, radius=False))


def line(a: fmpq, b: fmpq, v: str, constant: str) -> tuple[Candidate, Any, Any, Any]:
    """The candidate in balls; ε₀, λ and the candidate as a function of v in mpmath."""
    exact, first = solve(a, b, 75).defect, defect_slope(a, b)
    k = arb(a * b).sqrt()
    lam = k * exact**2
    # e′(0) = bε₀² dε/dγ = ε₀(pλ − 1/4).
    p = (arb(b) * exact * first + arb(1) / 4) / lam
    made = candidate(exact, lam, 1 / k, arb(v), p, arb(constant), balls)
    e0, scale, rate, extra = map(number, (exact, lam, p, arb(constant)))

    def angle(x: Any) -> Any:
        return e0 * (1 + (rate * scale - mpmath.mpf(1) / 4) * x + extra * scale * x * x)

    return made, e0, scale, angle


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("v", LEVELS)
@pytest.mark.parametrize("constant", ["2", "-0.5"])
def test_the_candidate_is_what_it_says(shape: tuple[fmpq, fmpq], v: str, constant: str) -> None:
    with ball_precision(WORK), mp_precision(70) as mp:
        made, e0, lam, angle = line(*shape, v, constant)
        x = mp.mpf(v)

        def sine(t: Any) -> Any:
            return mp.sin(angle(t)) / e0

        def log_sum(t: Any) -> Any:
            return mp.log(sine(t) + mp.sqrt(t + sine(t) ** 2))

        truth = Candidate(
            angle(x),
            angle(x) / e0,
            mp.diff(angle, x) / e0,
            sine(x),
            mp.sqrt(x + sine(x) ** 2),
            mp.exp(log_sum(x)),
            mp.diff(log_sum, x, 2) / lam,
        )
        for name, ball, value in zip(Candidate._fields, made, truth, strict=True):
            assert abs(ball - arb(mp.nstr(value, 40))) < 1e-14, name
            assert ball.rad() < 1e-14


@pytest.mark.slow
@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("v", ["-0.9", "-0.3", "0.4", "1"])
def test_the_curvature_holds_the_second_derivative(shape: tuple[fmpq, fmpq], v: str) -> None:
    """H(v) = √(ab)(F(e(v), bε₀²v) − π), F with tan ψ = κ sinh t or κ cosh t."""
    constant = "1/2"
    with ball_precision(WORK), mp_precision(40) as mp:
        _, e0, lam, angle = line(*shape, v, "0.5")
        a, b = (to_mp(x, mp) for x in shape)

        def turn(x: Any) -> Any:
            g = b * e0**2 * x
            ratio = mp.sqrt(abs(g) / (g + b))
            tangent = mp.tan(angle(x)) / ratio
            start = mp.asinh(tangent) if g > 0 else mp.acosh(tangent)

            def rate(t: Any) -> Any:
                square = (ratio * (mp.sinh(t) if g > 0 else mp.cosh(t))) ** 2
                s = b * square / (1 + square)
                return (1 - s) / mp.sqrt((a + s) * (1 + square) * (g + b))

            middle = -mp.log(ratio)
            return mp.sqrt(a * b) * mp.quad(rate, [start, middle, middle + 4, mp.inf])

        x, h = mp.mpf(v), mp.mpf(10) ** -6
        second = (turn(x + h) - 2 * turn(x) + turn(x - h)) / h**2 / lam
        k = arb(shape[0] * shape[1]).sqrt()
        found = curvature(arb(shape[1]), 1 / k, arb(v), arb(fmpq(1, 2)), balls)
        truth = arb(mp.nstr(second, 20), "1e-7")
        assert found.overlaps(truth), constant
        assert found.rad() < 3
        assert not found.overlaps(truth + 3 * found.rad())


@pytest.mark.parametrize(("b", "R"), [("1", "4"), ("1/3", "1/2"), ("1/1000", "0"), ("1/4", "2")])
def test_the_second_order_rest_is_a_hull(b: str, R: str) -> None:
    with ball_precision(120):
        q, ratio = (arb(fmpq(*map(int, x.split("/")))) if "/" in x else arb(x) for x in (b, R))
        hull = second_order_rest(q, ratio)
        for n in range(1, 100):
            psi = arb(fmpq(n, 100)) * arb.pi() / 2
            x, cosine = psi.sin() ** 2, psi.cos()
            j = ((1 - q * x) / (1 + ratio * x).sqrt() - cosine) / x
            assert hull.overlaps((j - (arb(1) / 2 - q - ratio / 2) * cosine) / x)
        assert hull.is_finite()
        assert hull.rad() < 5


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("v", LEVELS)
def test_the_fourth_moment_is_below_its_bound(shape: tuple[fmpq, fmpq], v: str) -> None:
    with ball_precision(WORK), mp_precision(25) as mp:
        made, e0, _, angle = line(*shape, v, "0.5")
        kappa = 1 / arb(shape[0] * shape[1]).sqrt()
        exact = solve(*shape, 75).defect
        q = (1 + exact**2 * arb(v)).sqrt()
        far = kappa * (2 / exact).log()
        bound = fourth_moment(
            kappa, arb(v), made.angle, q, made.sine / made.root, made.sum, far, made.part
        )
        u, start = e0**2 * mp.mpf(v), angle(mp.mpf(v))

        def part(psi: Any) -> Any:
            s = mp.sin(psi) ** 2
            return s * s / (u + s) ** mp.mpf("2.5")

        ends = [start * (mp.pi / 2 / start) ** (mp.mpf(i) / 8) for i in range(9)]
        truth = number(kappa) * mp.quad(part, ends)
        assert 0 < truth < number(bound)
        # Not far above it: a tenth of the bound is no bound.
        assert truth > number(bound) / 10


def test_over_a_box_the_curvature_holds_those_of_its_points() -> None:
    with ball_precision(100):
        boxes = arb("0.5", "0.01"), arb("0.5", "0.01"), arb("0.2", "0.01")
        whole = curvature(*boxes, arb(1), balls)
        assert whole.is_finite()
        for b, kappa, v in (("0.5", "0.5", "0.2"), ("0.491", "0.509", "0.209")):
            assert whole.contains(curvature(arb(b), arb(kappa), arb(v), arb(1), balls).mid())
