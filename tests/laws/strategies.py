"""What the laws are tried on: shapes, levels and starts, exact, with the hard places among them."""

import functools
import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import chunks
from flint import arb, fmpq
from hypothesis import given, seed, settings
from hypothesis import strategies as st

from tresym import flip_angle
from tresym.racket.body import Shape
from tresym.racket.result import Journey
from tresym.reals.numbers.arithmetic import ball_precision

DIGITS = 30
WORK = 400
"""Bits in which the laws are checked."""

# Beyond this √(ab)·2π a start of sixty digits says little about its end.
TAME = 3


def law(*strategies: Any, each: int = 1, **named: Any) -> Callable[[Any], Any]:
    """``given``, checked in balls of ``WORK`` bits, counted, with the seed of the chunk.

    A test that tries ``each`` examples at once is called for as many times fewer.
    """

    def wrap(test: Any) -> Any:
        @functools.wraps(test)
        def in_balls(*values: Any, **more: Any) -> None:
            with ball_precision(WORK):
                test(*values, **more)
            chunks.EXAMPLES[test.__name__] += each

        checked = given(*strategies, **named)(in_balls)
        if each > 1:
            checked = settings(max_examples=max(4, settings.default.max_examples // each))(checked)
        return seed(chunks.seed_of(0))(checked) if chunks.IN_CHUNKS else checked

    return wrap


def fraction(x: fmpq) -> Fraction:
    return Fraction(int(x.p), int(x.q))


def rational(x: Fraction | int) -> fmpq:
    return fmpq(x.numerator, x.denominator)


def magnitudes(low: int, high: int) -> st.SearchStrategy[Fraction]:
    """Positive rationals, even in the logarithm, of few digits."""
    return st.builds(
        lambda digits, power: Fraction(digits) * Fraction(10) ** (power - 3),
        st.integers(1000, 9999),
        st.integers(low, high - 1),
    )


shares = st.one_of(
    st.sampled_from([Fraction(1), Fraction(1, 2), Fraction(999_999, 1_000_000)]),
    st.fractions(Fraction(1, 1000), 1, max_denominator=10**6),
    magnitudes(-12, 0),
)


@st.composite
def shapes(draw: st.DrawFn, low: int = -6, high: int = 4) -> Shape:
    """Shapes even in log(ab), with b from 1e-12 to 1."""
    b, product = draw(shares), draw(magnitudes(low, high))
    return Shape(rational(product / b), rational(b))


def tame_shapes() -> st.SearchStrategy[Shape]:
    """Shapes whose flow keeps digits: b from 1e-3 on and √(ab) below 3."""
    b = st.fractions(Fraction(1, 1000), Fraction(99, 100), max_denominator=10**4)
    return st.builds(
        lambda b, ab: Shape(rational(ab / b), rational(b)),
        b,
        st.fractions(Fraction(1, 1000), TAME**2, max_denominator=10**4),
    )


@st.composite
def levels(draw: st.DrawFn, a: fmpq, b: fmpq) -> fmpq:
    """γ from −b to a: the ends, the separatrix, log-near each of the three, and between."""
    kind = draw(st.sampled_from(["0", "near 0", "near -b", "near a", "between", "-b", "a"]))
    if kind in ("0", "-b", "a"):
        return {"0": fmpq(0), "-b": -b, "a": a}[kind]
    small = rational(draw(magnitudes(-30, -1)))
    side = draw(st.sampled_from([-1, 1]))
    if kind == "near 0":
        return small * (a if side > 0 else -b)
    if kind == "between":
        part = rational(draw(st.fractions(0, 1, max_denominator=1000)))
        return part * (a if side > 0 else -b)
    return a * (1 - small) if kind == "near a" else -b * (1 - small)


@st.composite
def bodies_and_levels(draw: st.DrawFn, low: int = -6, high: int = 2) -> tuple[Shape, fmpq]:
    shape = draw(shapes(low, high))
    return shape, draw(levels(shape.a, shape.b))


Start = tuple[Shape, Fraction, Fraction]
"""A shape, ψ₀ in radians, dψ/dφ there."""


@st.composite
def starts(draw: st.DrawFn) -> Start:
    """A tame shape, ψ₀ and a rate that such a body can have there, also near the saddle."""
    shape = draw(tame_shapes())
    psi = draw(st.one_of(
        st.fractions(-4, 4, max_denominator=10**4),
        magnitudes(-20, -1),
        magnitudes(-20, -1).map(lambda x: -x),
    ))  # fmt: skip
    a, b = float(fraction(shape.a)), float(fraction(shape.b))
    sine2 = math.sin(psi) ** 2
    largest = Fraction(int((a + b * sine2) / (1 - b * sine2) * 10**6), 10**6)
    part = draw(st.one_of(
        st.fractions(Fraction(-99, 100), Fraction(99, 100), max_denominator=1000),
        magnitudes(-20, -1),
    ))  # fmt: skip
    return shape, psi, largest * part


turns = st.fractions(Fraction(1, 100), Fraction(63, 10), max_denominator=1000)


def fly(start: Start, precession: Fraction | str = "2*pi", digits: int = DIGITS) -> Journey:
    shape, psi, rate = start
    return flip_angle(*shape, psi, rate, digits, precession=precession)


def same(x: arb, y: arb, digits: int = DIGITS - 2) -> bool:
    """Two balls overlap, and are narrow enough that this says something."""
    with ball_precision(WORK):
        small = arb(fmpq(1, 10) ** digits) * (1 + abs(x))
        return bool(x.overlaps(y) and x.rad() < small and y.rad() < small)


def rational_near(x: arb) -> fmpq:
    """A rational number within 10^−75 of the middle of a ball."""
    return fmpq((x * arb(2) ** 260).mid().floor().unique_fmpz(), 2**260)
