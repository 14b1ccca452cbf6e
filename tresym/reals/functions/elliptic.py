"""Elliptic integrals in Legendre's form, with the parameter m = k².

Source: DLMF 19. Near m = 1 the series of DLMF 19.12.1 and 19.12.2 converge; their terms decrease,
so that the remainder is at most the first omitted term over 1 − s.
"""

from __future__ import annotations

from collections.abc import Callable
from math import factorial
from typing import Any

from flint import acb, acb_series, arb, ctx, fmpq

from tresym.reals.functions.enclosures import (
    NAN,
    composed,
    is_wide,
    literal,
    monotone,
    positive,
    real_part,
)
from tresym.reals.functions.error import half_rising
from tresym.reals.functions.row import Conditions, Function
from tresym.reals.numbers.exact import Interval


def _below_one(x: Any, m: Any) -> Conditions:
    return ((1 - x, ">"),)


def _square(k: int) -> fmpq:
    found = half_rising(k) / factorial(k)
    return found * found


def _left_of_one(f: Callable[[acb], acb]) -> Callable[[Any], acb]:
    """Return K or E in complex balls; the cut is [1, ∞)."""
    return lambda z: f(acb(z)) if acb(z).real < 1 else acb(NAN)


def _k(x: arb) -> arb:
    return real_part(acb(x).elliptic_k()) if x < 1 else NAN


def _e(x: arb) -> arb:
    if x < 1:
        return real_part(acb(x).elliptic_e())
    return arb(1) if x == 1 else NAN


def _k_jets(x: arb, n: int) -> list[arb]:
    """Return Taylor coefficients; as functions of m < 1 all are positive and increase."""
    if not x < 1:
        return [NAN] * n
    if is_wide(x):
        ends = _k_jets(arb(x.lower()), n), _k_jets(arb(x.upper()), n)
        return [low.union(high) for low, high in zip(*ends, strict=True)]
    before, ctx.cap = ctx.cap, n
    try:
        found = acb_series([acb(x), 1], n).elliptic_k()
    finally:
        ctx.cap = before
    return [real_part(found[k]) for k in range(n)]


def _e_jets(x: arb, n: int) -> list[arb]:
    """E = (1 − m)(2m K' + K) (DLMF 19.4.1); all coefficients but the first fall."""
    if is_wide(x):
        ends = _e_jets(arb(x.lower()), n), _e_jets(arb(x.upper()), n)
        return [low.union(high) for low, high in zip(*ends, strict=True)]
    known = _k_jets(x, n + 1)
    inner = []
    for k in range(n):  # coefficients of 2mK' + K about m = x
        value = known[k] + 2 * x * (k + 1) * known[k + 1] + 2 * k * known[k]
        inner.append(value)
    return [(1 - x) * inner[k] - (inner[k - 1] if k else 0) for k in range(n)]


def _gap(k: int) -> fmpq:
    """d(k) − 2 ln 2, d(k) = ψ(1 + k) − ψ(1/2 + k)."""
    found = fmpq(0)
    for j in range(k):
        found -= fmpq(2, (2 * j + 1) * (2 * j + 2))
    return found


def _logs(k: int, m: Any) -> Any:
    return 2 * m.log(2) + _gap(k)


def _b_term(k: int, m: Any) -> Any:
    return _square(k) * _logs(k, m)


def _e_factor(k: int) -> fmpq:
    """The coefficient of w^k of A₂, (1/2)_j (3/2)_j/((2)_j j!) with j = k − 1."""
    if k == 0:
        return fmpq(0)
    j = k - 1
    three = half_rising(j + 1) * 2  # (3/2)_j = 2 (1/2)_{j+1}
    return half_rising(j) * three / (factorial(j + 1) * factorial(j))


def _e_term(k: int, m: Any) -> Any:
    if k == 0:
        return fmpq(0)
    j = k - 1
    return _e_factor(k) * (_logs(j, m) - fmpq(1, (2 * j + 1) * (2 * j + 2)))


def _decreasing(name: str, term: Callable[[int, Any], Any]) -> Function:
    """A power series whose coefficients are positive and decrease."""

    class _Logs:
        @staticmethod
        def log(n: int) -> arb:
            return arb(n).log()

    def coefficient(k: int) -> arb:
        return arb(1) * term(k, _Logs)

    def bound(s: arb, n: int) -> arb:
        return coefficient(max(n, 1)) / (1 - s) if s < 1 else NAN

    def value(w: arb) -> arb:
        top = arb(w.upper())
        if not (top < 1 and (w >= 0 or w.contains(0))):
            return NAN
        inside = arb(0).union(top) if w.contains(0) else w
        n = 2
        while n < 400 and not top**n < arb((1, -ctx.prec)):
            n += n // 2
        total = arb(0)
        for k in reversed(range(n)):
            total = total * inside + coefficient(k)
        return total + arb(0, 1) * bound(top, n) * inside**n

    return Function(
        name=name, family="factors of expansions", needs=positive, derivatives=(None,), ball=value,
        taylor=term, remainder=bound, internal=True, source="DLMF 19.12",
        latex=rf"T_{{\mathrm{{{name.replace('_', ' ')}}}}}",
    )  # fmt: skip


def _k_near_one(x: Any, m: Any) -> Any:
    w = 1 - x
    return m.elliptic_k_regular(w) - m.log(w) / m.pi * m.elliptic_k(w)


def _e_near_one(x: Any, m: Any) -> Any:
    w = 1 - x
    return 1 + m.elliptic_e_regular(w) / 2 - m.log(w) / 4 * m.elliptic_e_log(w)


def _k_value(x: Any, m: Any) -> Any:
    """K(0), K(1/2) and K(−1) (DLMF 19.6.1 and 23.22(ii), the lemniscatic case)."""
    r, quarter = literal(x), fmpq(1, 4)
    if r == fmpq(1, 2):
        return m.gamma(quarter) ** 2 / (4 * m.sqrt(m.pi))
    if r == -1:
        return m.gamma(quarter) ** 2 / (4 * m.sqrt(2 * m.pi))
    return m.pi / 2 if r == 0 else None


def _e_value(x: Any, m: Any) -> Any:
    """E(0), E(1), and E(1/2) by Legendre's relation."""
    r, quarter = literal(x), fmpq(1, 4)
    if r == fmpq(1, 2):
        square = m.gamma(quarter) ** 2
        return square / (8 * m.sqrt(m.pi)) + m.pi * m.sqrt(m.pi) / square
    return m.pi / 2 if r == 0 else x * 0 + 1 if r == 1 else None


def _incomplete(phi: Any, x: Any, m: Any) -> Conditions:
    return (
        (1 - x * m.sin(phi) ** 2, ">"),
        (m.cos(phi), ">="),
        (m.pi - phi, ">"),
        (m.pi + phi, ">"),
    )


def _incomplete_value(name: str) -> Any:
    def rule(phi: Any, x: Any, m: Any) -> Any:
        if literal(phi) == 0:
            return 0 * x
        if literal(x) == 0:
            return phi
        if phi == m.pi / 2:
            return getattr(m, name)(x)
        return -getattr(m, name)(x) if phi == -m.pi / 2 else None

    return rule


def _f(phi: arb, x: arb) -> arb:
    if not (1 - x * phi.sin() ** 2 > 0 and abs(phi) <= arb.pi() / 2 + arb((1, -30))):
        return NAN
    return real_part(acb.elliptic_f(acb(phi), acb(x)))


def _e_inc(phi: arb, x: arb) -> arb:
    if not (1 - x * phi.sin() ** 2 > 0 and abs(phi) <= arb.pi() / 2 + arb((1, -30))):
        return NAN
    return real_part(acb.elliptic_e_inc(acb(phi), acb(x)))


def _root(phi: Any, x: Any, m: Any) -> Any:
    return m.sqrt(1 - x * m.sin(phi) ** 2)


def _pi(n: arb, x: arb) -> arb:
    return real_part(acb.elliptic_pi(acb(n), acb(x))) if n < 1 and x < 1 else NAN


def _pi_value(n: Any, x: Any, m: Any) -> Any:
    if literal(n) == 0:
        return m.elliptic_k(x)
    if literal(x) == 0:
        return m.pi / (2 * m.sqrt(1 - n))
    return None


def _far(x: Any, m: Any) -> Any:
    return m.elliptic_k(-x / (1 - x)) / m.sqrt(1 - x)


def _e_far(x: Any, m: Any) -> Any:
    return m.elliptic_e(-x / (1 - x)) * m.sqrt(1 - x)


ELLIPTIC = (
    Function(
        name="elliptic_k", family="elliptic integrals", source="DLMF 19.2.8", rising=True,
        definition=r"K(m) = \int_0^{\pi/2} d\theta/\sqrt{1 - m\sin^2\theta},\ m < 1",
        needs=_below_one, range=Interval(fmpq(0), None, True),
        derivatives=(
            lambda x, m: m.elliptic_e(x) / (2 * x * (1 - x)) - m.elliptic_k(x) / (2 * x),),
        ball=monotone(_k), series=lambda s: composed(_k_jets, s),
        holomorphic=_left_of_one(lambda z: z.elliptic_k()),
        taylor=lambda k, m: _square(k) * m.pi / 2, rewritten=_k_value,
        near={"1-": _k_near_one, "-oo": _far}, latex="K", mathematica="EllipticK",
        maple="EllipticK", sympy="elliptic_k", aliases=("ellipk",),
        falsehoods=("elliptic_k(m) <= pi/2 + m/2 given 0 < m < 1",
                    "diff(elliptic_k(m), m) == elliptic_e(m)/(2*m*(1 - m))"),
    ),
    Function(
        name="elliptic_e", family="elliptic integrals", source="DLMF 19.2.8", falling=True,
        definition=r"E(m) = \int_0^{\pi/2} \sqrt{1 - m\sin^2\theta}\,d\theta,\ m \le 1",
        needs=lambda x, m: ((1 - x, ">="),), smooth=False, ends=(1,), range=Interval(fmpq(1)),
        derivatives=(lambda x, m: (m.elliptic_e(x) - m.elliptic_k(x)) / (2 * x),),
        ball=monotone(_e), series=lambda s: composed(_e_jets, s),
        holomorphic=_left_of_one(lambda z: z.elliptic_e()),
        taylor=lambda k, m: -_square(k) / (2 * k - 1) * m.pi / 2, rewritten=_e_value,
        near={"1-": _e_near_one, "-oo": _e_far}, latex="E", mathematica="EllipticE",
        maple="EllipticE", sympy="elliptic_e", aliases=("ellipe",),
        falsehoods=("elliptic_e(m) <= pi/2 given m < 1",
                    "diff(elliptic_e(m), m) == (elliptic_k(m) - elliptic_e(m))/(2*m)"),
    ),
    _decreasing("elliptic_k_regular", _b_term),
    _decreasing("elliptic_e_regular", _e_term),
    _decreasing("elliptic_e_log", lambda k, m: _e_factor(k)),
    Function(
        name="elliptic_f", family="elliptic integrals", arity=2, source="DLMF 19.2.4",
        definition=r"F(\phi, m) = \int_0^\phi d\theta/\sqrt{1 - m\sin^2\theta},\ |\phi| \le \pi/2",
        needs=_incomplete, smooth=False, ball=_f, rewritten=_incomplete_value("elliptic_k"),
        derivatives=(
            lambda phi, x, m: 1 / _root(phi, x, m),
            lambda phi, x, m: m.elliptic_e_inc(phi, x) / (2 * x * (1 - x))
            - m.elliptic_f(phi, x) / (2 * x) - m.sin(2 * phi) / (4 * (1 - x) * _root(phi, x, m)),
        ),
        latex="F", mathematica="EllipticF", maple="EllipticF", sympy="elliptic_f",
        falsehoods=("elliptic_f(t, m) >= t + m*t**3/4 given 0 < m < 1/2, 0 < t < 1",
                    "diff(elliptic_f(t, m), t) == 1/sqrt(1 - m*sin(t))"),
    ),
    Function(
        name="elliptic_e_inc", family="elliptic integrals", arity=2, source="DLMF 19.2.5",
        definition=r"E(\phi, m) = \int_0^\phi \sqrt{1 - m\sin^2\theta}\,d\theta,\ |\phi| \le \pi/2",
        needs=_incomplete, smooth=False, ball=_e_inc,
        rewritten=_incomplete_value("elliptic_e"),
        derivatives=(
            lambda phi, x, m: _root(phi, x, m),
            lambda phi, x, m: (m.elliptic_e_inc(phi, x) - m.elliptic_f(phi, x)) / (2 * x),
        ),
        latex="E", mathematica="EllipticE", maple="EllipticE", sympy="elliptic_e",
        aliases=("ellipeinc",),
        falsehoods=("elliptic_e_inc(t, m) >= t given 0 < m < 1/2, 0 < t < 1",
                    "diff(elliptic_e_inc(t, m), t) == 1/sqrt(1 - m*sin(t)**2)"),
    ),
    Function(
        name="elliptic_pi", family="elliptic integrals", arity=2, source="DLMF 19.2.8",
        definition=r"\Pi(n, m) = \int_0^{\pi/2}"
        r"\frac{d\theta}{(1 - n\sin^2\theta)\sqrt{1 - m\sin^2\theta}}",
        needs=lambda n, x, m: ((1 - n, ">"), (1 - x, ">")), range=Interval(fmpq(0), None, True),
        derivatives=(
            lambda n, x, m: (m.elliptic_e(x) + (x - n) * m.elliptic_k(x) / n
                             + (n**2 - x) * m.elliptic_pi(n, x) / n) / (2 * (x - n) * (n - 1)),
            lambda n, x, m: (m.elliptic_e(x) / (x - 1) + m.elliptic_pi(n, x)) / (2 * (n - x)),
        ),
        ball=_pi, rewritten=_pi_value, latex=r"\Pi", mathml="Π", mathematica="EllipticPi",
        maple="EllipticPi", sympy="elliptic_pi",
        falsehoods=("elliptic_pi(n, m) <= pi/2 given 0 < n < 1, 0 < m < 1",
                    "elliptic_pi(n, 0) == pi/sqrt(1 - n)"),
    ),
)  # fmt: skip
