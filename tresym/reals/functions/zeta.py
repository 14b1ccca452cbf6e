"""The zeta function, polylogarithms, Lambert's W, and mathematical constants.

Source: DLMF 25 and 4.13. Near s = 1 the remainder of ζ(s) − 1/(s − 1) is bounded by
|γ_n| ≤ 4 (n − 1)!/πⁿ (B. C. Berndt, Rocky Mountain J. Math. 2 (1972) 151).
"""

from __future__ import annotations

from math import comb, factorial
from typing import Any

from flint import acb, arb, ctx, fmpq

from tresym.reals.functions.enclosures import (
    NAN,
    composed,
    is_wide,
    jets_of,
    literal,
    monotone,
    real_part,
    whole,
)
from tresym.reals.functions.row import Function
from tresym.reals.numbers.exact import Interval


def _zeta(x: arb) -> arb:
    if x.contains(1):
        return NAN
    return monotone(lambda y: y.zeta())(x) if x > 1 else x.zeta()


def _zeta_value(x: Any, m: Any) -> Any:
    n = whole(x)
    if n is None or n == 1 or abs(n) > 60:
        return None
    if n == 0:
        return x * 0 - fmpq(1, 2)
    if n < 0:
        return x * 0 - fmpq.bernoulli(1 - n) / (1 - n)
    if n % 2 == 0:
        return abs(fmpq.bernoulli(n)) * 2 ** (n - 1) / factorial(n) * m.pi**n
    return None


def _zeta_jets(x: arb, n: int) -> list[arb]:
    return jets_of("zeta")(x, n) if not x.contains(1) else [NAN] * n


def _zeta_derivative(n: arb, x: arb) -> arb:
    order = whole(n)
    if order is None or order < 0 or x.contains(1):
        return NAN
    return _zeta_jets(x, order + 1)[order] * factorial(order)


def _zeta_sign(n: Any, x: Any, m: Any) -> Any:
    """(−1)ⁿ ζ⁽ⁿ⁾(s) = Σ lnⁿk/k^s > 0 for s > 1."""
    order = whole(n)
    return x - 1 if order is not None and order % 2 == 0 else x * 0 - 1


def _zetaderiv_value(n: Any, x: Any, m: Any) -> Any:
    """ζ′(0) = −ln(2π)/2 (DLMF 25.6.11)."""
    if whole(n) == 0:
        return m.zeta(x)
    return -m.log(2 * m.pi) / 2 if whole(n) == 1 and literal(x) == 0 else None


def _zeta_minus(n: Any, x: Any, m: Any) -> Any:
    order = whole(n)
    return x - 1 if order is not None and order % 2 else x * 0 - 1


def _regular(v: arb) -> arb:
    if not is_wide(v) and not v.contains(0):
        return (1 + v).zeta() - 1 / v
    size = arb(abs(v).upper())
    if not size < 3:
        return NAN
    total, terms = arb(0), 12
    for k in reversed(range(terms)):
        total = total * v + (-1) ** k * real_part(acb.stieltjes(k)) / factorial(k)
    return total + arb(0, 1) * _regular_rest(size, terms) * size**terms


def _regular_rest(s: arb, n: int) -> arb:
    if not s < 3:
        return NAN
    if n == 0:
        return arb(1) + 2 * s
    return 4 / (n * arb.pi() ** n) / (1 - s / arb.pi())


def _stieltjes(n: arb) -> arb:
    k = whole(n)
    return NAN if k is None or k < 0 else real_part(acb.stieltjes(k))


def _zeta_mirror(x: Any, m: Any) -> Any:
    """The functional equation (DLMF 25.4.1)."""
    return 2 * (2 * m.pi) ** (x - 1) * m.sin(m.pi * x / 2) * m.gamma(1 - x) * m.zeta(1 - x)


def _zeta_far(x: Any, m: Any) -> Any:
    return 1 + m.exp(-x * m.log(2)) * m.zeta_tail(m.exp(-x * m.log(fmpq(3, 2) + 0 * x)))


def _zeta_tail(v: arb) -> arb:
    """Return Σ_{k ≥ 2} (k/2)^(−s) with v = (3/2)^(−s)."""
    if v > 0 and not is_wide(v):
        s = -v.log() / arb(fmpq(3, 2)).log()
        if s > 1:
            return (s.zeta() - 1) * (s * arb(2).log()).exp()
    top = arb(v.upper())
    if not (top > 0 and (v > 0 or v.contains(0))):
        return NAN
    rest = _zeta_tail_rest(top, 1)
    return 1 + arb(0).union(top * rest)


def _zeta_tail_rest(s: arb, n: int) -> arb:
    """Bound Σ_{k≥3} (k/2)^(−s)/v = Σ_{k≥3} (k/3)^(−s), which falls as s grows."""
    x = -s.log() / arb(fmpq(3, 2)).log()
    if n != 1 or not x > 2:
        return NAN
    return (x.zeta() - 1 - (-x * arb(2).log()).exp()) * (x * arb(3).log()).exp()


def _near_one(x: Any, m: Any) -> Any:
    return 1 / (x - 1) + m.zeta_regular(x - 1)


def _polylog(s: arb, x: arb) -> arb:
    def value(y: arb) -> arb:
        if y == 1:
            return s.zeta() if s > 1 else NAN
        return y.polylog(s) if y < 1 else NAN

    return monotone(value)(x) if s >= 1 else value(x)


def _polylog_jets(s: arb) -> Any:
    """Return Taylor coefficients Σ_{k≥n} (k choose n) x^(k−n)/k^s for |x| ≤ 3/4.

    As functions of x < 1 they are positive and increase, for s > 0.
    """

    def coefficient(x: arb, n: int) -> arb:
        total, last = arb(0), 6 * n + 4 * ctx.prec
        for k in reversed(range(max(n, 1), last)):
            total = total * x + comb(k, n) / arb(k) ** s
        total = total * x if n == 0 else total
        rate = arb(fmpq(last, last - n)) * fmpq(3, 4)  # at least the ratio of later terms
        rest = comb(last, n) * abs(x) ** (last - n) / (1 - rate)
        return total + arb(0, 1) * rest

    def jets(x: arb, n: int) -> list[arb]:
        if not (abs(x) <= fmpq(3, 4) and s > 0):
            return [NAN] * n
        if is_wide(x):
            ends = jets(arb(x.lower()), n), jets(arb(x.upper()), n)
            return [low.union(high) for low, high in zip(*ends, strict=True)]
        return [_polylog(s, x), *(coefficient(x, k) for k in range(1, n))]

    return jets


def _polylog_value(s: Any, x: Any, m: Any) -> Any:
    n, r = literal(s), literal(x)
    if r == 0:
        return x * 0
    if r == 1 and n is not None and n > 1:
        return m.zeta(s)
    if r == -1 and n is not None and n > 1 and n.q == 1:
        return -(1 - fmpq(2) ** int(1 - n)) * m.zeta(s)
    if n == 1:
        return -m.log(1 - x)
    if n == 0:
        return x / (1 - x)
    if n == -1:
        return x / (1 - x) ** 2
    if n == 2 and r == fmpq(1, 2):
        return m.pi**2 / 12 - m.log(2) ** 2 / 2
    return None


def _polylog_taylor(s: Any, k: int, m: Any) -> Any:
    n = whole(s)
    if n is None:
        return None
    return fmpq(k) ** -n if k else fmpq(0)


def _polylog_needs(s: Any, x: Any, m: Any) -> Any:
    n = literal(s)
    return ((1 - x, ">=" if n is not None and n > 1 else ">"),)


def _dilog_near_one(s: Any, x: Any, m: Any) -> Any:
    """Li₂(x) + Li₂(1 − x) = π²/6 − ln x ln(1 − x) (DLMF 25.12.6)."""
    if whole(s) != 2:
        return None
    return m.pi**2 / 6 - m.log(x) * m.log(1 - x) - m.polylog(2, 1 - x)


def _dilog_far(s: Any, x: Any, m: Any) -> Any:
    """Li₂(x) + Li₂(1/x) = −π²/6 − ln²(−x)/2 (DLMF 25.12.4)."""
    if whole(s) != 2:
        return None
    return -(m.pi**2) / 6 - m.log(-x) ** 2 / 2 - m.polylog(2, 1 / x)


def _lambert(branch: int) -> Any:
    def value(x: arb) -> arb:
        if branch and not x < 0:
            return NAN
        return real_part(acb(x).lambertw(branch)) if x > -(arb(-1).exp()) else NAN

    return monotone(value)


def _lambert_value(x: Any, m: Any) -> Any:
    r = literal(x)
    if r == 0:
        return x * 0
    if getattr(x, "op", "") == "exp" and literal(x.args[0]) == 1:
        return x.args[0]
    if x == -m.exp(-1):
        return x.args[0] if literal(x.args[0]) == -1 else None
    return None


def _constant(name: str, ball: Any, definition: str, source: str, **facts: Any) -> Function:
    return Function(
        name=name, family="constants", definition=definition, source=source, constant=True,
        derivatives=(lambda x, m: 0 * x,), ball=lambda _: ball(), sympy=name, mathematica=name,
        range=Interval(fmpq(0), fmpq(1), True, True), **facts,
    )  # fmt: skip


ZETA = (
    Function(
        name="zeta", family="zeta functions", source="DLMF 25.2.1",
        definition=r"\zeta(s) = \sum_{n \ge 1} n^{-s},\ s > 1; continued to s \ne 1",
        needs=lambda x, m: ((x - 1, "!="),), derivatives=(lambda x, m: m.zetaderiv(1, x),),
        ball=_zeta, series=lambda s: composed(_zeta_jets, s),
        holomorphic=lambda z: acb(z).zeta(), positive_where=lambda x, m: x - 1,
        mirror=_zeta_mirror,
        rewritten=_zeta_value, near={"1+": _near_one, "1-": _near_one, "oo": _zeta_far},
        latex=r"\zeta", mathml="ζ", mathematica="Zeta", maple="Zeta", sympy="zeta",
        aliases=("Zeta",),
        falsehoods=("zeta(s) <= 2 given s > 1", "zeta(2) == pi**2/8"),
    ),
    Function(
        name="zetaderiv", family="zeta functions", arity=2, source="DLMF 25.2.6",
        definition=r"\zeta^{(n)}(s)", needs=lambda n, x, m: ((x - 1, "!="),),
        derivatives=(None, lambda n, x, m: m.zetaderiv(n + 1, x)), ball=_zeta_derivative,
        rewritten=_zetaderiv_value, positive_where=_zeta_sign, negative_where=_zeta_minus,
        latex=r"\zeta'", mathml="ζ′", mathematica="Zeta'", maple="Zeta", sympy="",
        falsehoods=("zetaderiv(1, s) < -1 given s > 1", "diff(zeta(s), s) == zetaderiv(2, s)"),
    ),
    Function(
        name="zeta_regular", family="factors of expansions", internal=True, source="DLMF 25.2.4",
        derivatives=(None,), ball=_regular, remainder=_regular_rest, latex=r"T_{\gamma}",
        taylor=lambda k, m: fmpq((-1) ** k, factorial(k)) * m.stieltjes(k) if k
        else m.EulerGamma(1),
    ),
    Function(
        name="zeta_tail", family="factors of expansions", internal=True, source="DLMF 25.2.1",
        needs=lambda v, m: ((v, ">"),), derivatives=(None,), ball=_zeta_tail, terms=1,
        taylor=lambda k, m: fmpq(1) if k == 0 else None, remainder=_zeta_tail_rest,
        latex=r"T_{\zeta}",
    ),
    Function(
        name="stieltjes", family="zeta functions", internal=True, source="DLMF 25.2.5",
        derivatives=(None,), ball=_stieltjes, definition=r"\gamma_n", latex=r"\gamma",
        rewritten=lambda n, m: m.EulerGamma(1) if literal(n) == 0 else None,
    ),
    Function(
        name="polylog", family="zeta functions", arity=2, source="DLMF 25.12.10",
        definition=r"\operatorname{Li}_s(x) = \sum_{n \ge 1} x^n/n^s", needs=_polylog_needs,
        smooth=False, derivatives=(None, lambda s, x, m: m.polylog(s - 1, x) / x), ball=_polylog,
        positive_where=lambda s, x, m: x, rewritten=_polylog_value, taylor=_polylog_taylor,
        series=lambda s, x: composed(_polylog_jets(s[0]), x),
        near={"1-": _dilog_near_one, "-oo": _dilog_far}, latex=r"\operatorname{Li}",
        subscripted=True, mathematica="PolyLog", maple="polylog", sympy="polylog",
        aliases=("PolyLog",),
        falsehoods=("polylog(2, x) <= x + x**2/4 given 0 < x < 1",
                    "diff(polylog(2, x), x) == log(1 - x)/x"),
    ),
    Function(
        name="lambertw", family="Lambert W", source="DLMF 4.13.1", rising=True,
        definition=r"W(x) e^{W(x)} = x,\ W \ge -1", needs=lambda x, m: ((x + m.exp(-1), ">="),),
        smooth=False, singular=lambda x, m: ((x + m.exp(-1), ">"),), range=Interval(fmpq(-1)),
        derivatives=(lambda x, m: m.exp(-m.lambertw(x)) / (1 + m.lambertw(x)),),
        vanishes_with_argument=True, sign_of=lambda x, m: x, ball=_lambert(0),
        series=lambda s: s.lambertw() if s[0] > -(arb(-1).exp()) else s * NAN,
        taylor=lambda k, m: fmpq((-k) ** (k - 1), factorial(k)) if k else fmpq(0),
        rewritten=_lambert_value, latex=r"W", mathematica="ProductLog", maple="LambertW",
        sympy="LambertW", aliases=("LambertW", "ProductLog", "lambertw0"),
        falsehoods=("lambertw(x) <= log(x) given x > 2", "diff(lambertw(x), x) == 1/(1 + x)"),
    ),
    Function(
        name="lambertwm1", family="Lambert W", source="DLMF 4.13.1", falling=True,
        definition=r"W e^W = x,\ W \le -1", smooth=False,
        needs=lambda x, m: ((x + m.exp(-1), ">="), (-x, ">")),
        singular=lambda x, m: ((x + m.exp(-1), ">"), (-x, ">")), range=Interval(None, fmpq(-1)),
        derivatives=(lambda x, m: m.exp(-m.lambertwm1(x)) / (1 + m.lambertwm1(x)),),
        ball=_lambert(-1), latex=r"W_{-1}", mathml="W₋₁", mathematica="ProductLog",
        maple="LambertW", sympy="LambertW",
        falsehoods=("lambertwm1(x) >= log(-x) given -1/3 < x < 0",
                    "diff(lambertwm1(x), x) == 1/(1 + x)"),
    ),
    _constant("EulerGamma", arb.const_euler, r"\gamma = -\Gamma'(1)", "DLMF 5.2.3",
              latex=r"\gamma", mathml="γ", maple="gamma",
              falsehoods=("EulerGamma > 578/1000", "EulerGamma == 1/sqrt(3)")),
    _constant("Catalan", arb.const_catalan, r"G = \sum_k (-1)^k/(2k+1)^2", "DLMF 25.11.40",
              latex="G", maple="Catalan",
              falsehoods=("Catalan > 916/1000", "Catalan == 11/12")),
)  # fmt: skip
