"""Benchmark of F(ε, γ) to 50 digits: balls in Carlson's form against mpmath.

Digits are counted against a more precise ball. mpmath runs in this process, with the backend that
it finds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from flint import arb, fmpq

from tresym.dev.bench.peers import from_text
from tresym.dev.bench.run import Contender, Pace, Workload, row
from tresym.dev.bench.truth import by_digits
from tresym.racket.body import named_body
from tresym.racket.flip.defect import solve
from tresym.racket.motion import quadrature
from tresym.racket.motion.carlson import Amplitude, Integrals, amplitude, by_flint, turn
from tresym.racket.motion.gauss import ball_ending, turn_by_gauss
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number

DIGITS = 50
SHAPE = named_body("str").shape
SCENES = ("1e-2", "1e-4", "1e-8", "1e-16", "1e-30", "0", "-1/1000")
"""The γ that are timed; the last one from its turning point, the others from ε = 1/10."""
OURS = "tresym, Gauss transformation"


def contenders(_: Any = None) -> Iterator[Contender]:
    """Yield F(ε, γ) of the racket; the public function computes ε(γ), with one or two F."""
    for text in SCENES:
        gamma = parse_number(text)
        truth = flint_turn(gamma, 2 * DIGITS)
        works: dict[str, Callable[[], Any]] = {
            OURS: partial(_gauss_turn, gamma),
            "tresym, FLINT's R_F and R_J": partial(flint_turn, gamma, DIGITS),
            "mpmath R_F and R_J": partial(_mp_carlson, gamma),
            "mpmath quad, tanh-sinh": partial(_by_quad, gamma, "tanh-sinh"),
            "mpmath quad, Gauss-Legendre": partial(_by_quad, gamma, "gauss-legendre"),
            "mpmath quad of our substitution": partial(_mp_substituted, gamma),
        }
        where = f"γ = {text}" if gamma >= 0 else f"γ = {text}, at the turning point"
        yield from row(where, works, by_digits(truth, DIGITS, DIGITS), asked=DIGITS)
        public = {"tresym.flip_defect, ε(γ) from text": partial(from_text, "str", text, DIGITS)}
        found = by_digits(solve(*SHAPE, gamma, 2 * DIGITS).defect, DIGITS, DIGITS)
        yield from row(where, public, found, asked=DIGITS)


WORKLOAD = Workload(contenders, Pace(rounds=7, limit=5.0, patience=0.6), OURS)


def _place(gamma: fmpq, m: Any, number: Callable[[fmpq], Any]) -> Amplitude:
    """The amplitude of a scene in balls or mpmath; z = 0 exactly at the turning point."""
    a, b, g = (number(x) for x in (*SHAPE, gamma))
    if gamma < 0:
        return amplitude(m.sqrt(-g / b), m.sqrt(1 + g / b), 0 * g, a, b, g, m)
    psi = number(fmpq(1, 10))
    sine, cosine = m.sin(psi), m.cos(psi)
    return amplitude(sine, cosine, g + b * sine * sine, a, b, g, m)


def _gauss_turn(gamma: fmpq) -> arb:
    with ball_precision(bits(DIGITS, 12)):
        a, b, g = arb(SHAPE.a), arb(SHAPE.b), arb(gamma)
        if gamma < 0:
            tangent, rest = (-g / (g + b)).sqrt(), arb(0)
        else:
            tangent = arb(fmpq(1, 10)).tan()
            rest = g + (g + b) * tangent * tangent
        return turn_by_gauss(tangent, rest, a, b, g, balls, ball_ending())


def flint_turn(gamma: fmpq, digits: int) -> arb:
    """Return F of a scene in balls, by FLINT's R_F and R_J."""
    with ball_precision(bits(digits)):
        a, b, g = arb(SHAPE.a), arb(SHAPE.b), arb(gamma)
        return turn(by_flint(_place(gamma, balls, arb), b / a), a, b, g, balls)


def _mp_carlson(gamma: fmpq) -> Any:
    with mp_precision(DIGITS + 5) as mp:
        a, b, g = (to_mp(x, mp) for x in (*SHAPE, gamma))
        at = _place(gamma, mp, lambda x: to_mp(x, mp))
        return turn(by_library(at, b / a, mp), a, b, g, mp)


def by_library(at: Amplitude, n: Any, m: Any) -> Integrals:
    """Return the two integrals by R_F and R_J of scipy.special or mpmath."""
    x, y = at.cn**2, at.dn**2
    third = at.sn**3 * m.elliprj(x, y, 1, 1 + n * at.sn**2) / 3
    return Integrals(at.sn * m.elliprf(x, y, 1), third)


def mp_quad(gamma: fmpq, method: str, digits: int) -> tuple[Any, Any]:
    """Return F of a scene by mpmath's ``quad``, and the error that it claims."""
    with mp_precision(digits) as mp:
        a, b, g = (to_mp(x, mp) for x in (*SHAPE, gamma))
        start = mp.asin(mp.sqrt(-g / b)) if gamma < 0 else mp.mpf(1) / 10
        value, error = quadrature.printed(start, a, b, g, mp, method)
        return mp.re(value), mp.re(error)


def _by_quad(gamma: fmpq, method: str) -> Any:
    return mp_quad(gamma, method, DIGITS)[0]


def _mp_substituted(gamma: fmpq) -> Any:
    with mp_precision(DIGITS + 5) as mp:
        a, b, g = (to_mp(x, mp) for x in (*SHAPE, gamma))
        t = quadrature.parameter(mp.mpf(1) / 10, b, g, mp) if gamma >= 0 else mp.mpf(0)
        return quadrature.substituted(t, a, b, g, mp)
