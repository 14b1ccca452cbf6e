"""The gamma function and its relatives: logarithm, digamma, polygamma, incomplete gamma functions.

Source: DLMF 5 and 8. The expansions at infinity are enveloping for x > 0: the error is at most the
first omitted term and has its sign (DLMF 5.11(ii)).
"""

from __future__ import annotations

import math
from typing import Any

from flint import acb, arb, fmpq, fmpz

from tresym.reals.functions.enclosures import (
    NAN,
    composed,
    derived,
    factor,
    is_wide,
    jets_of,
    literal,
    monotone,
    on_the_right,
    parametric,
    real_part,
    whole,
)
from tresym.reals.functions.row import Conditions, Function
from tresym.reals.numbers.exact import Interval

LOWEST = arb("1.4616321449683623412")
"""Near the positive number at which the gamma function is least (DLMF 5.4.20)."""


def bernoulli(n: int) -> fmpq:
    """Return the Bernoulli number Bₙ."""
    found = fmpq.bernoulli(n)
    return found


def no_pole(x: Any, m: Any) -> Conditions:
    """Return where the gamma function is defined: x is not 0, −1, −2, …."""
    return ((m.rgamma(x), "!="),)


def _positive(x: Any, m: Any) -> Conditions:
    return ((x, ">"),)


def _gamma(x: arb) -> arb:
    if x > 0 and is_wide(x):
        ends = x.lower().gamma().union(x.upper().gamma())
        if x.overlaps(LOWEST + arb(0, arb("1e-9"))):
            ends = ends.union(arb("0.8856031944108887"))
        return ends
    return x.gamma()


def _loggamma(x: arb) -> arb:
    if not x > 0:
        return NAN
    if is_wide(x):
        ends = x.lower().lgamma().union(x.upper().lgamma())
        if x.overlaps(LOWEST + arb(0, arb("1e-9"))):
            ends = ends.union(arb("-0.1214862905358496081"))
        return ends
    return x.lgamma()


def _digamma(x: arb) -> arb:
    if x > 0:
        return monotone(lambda y: y.digamma())(x)
    return x.digamma()


def _polygamma(n: arb, x: arb) -> arb:
    order = whole(n)
    if order is None or order < 0:
        return NAN

    def value(y: arb) -> arb:
        return real_part(acb(y).polygamma(acb(order)))

    return monotone(value)(x) if x > 0 else value(x)


def _gamma_value(x: Any, m: Any) -> Any:
    r = literal(x)
    if r is None:
        return None
    if r.q == 1 and 0 < r <= 150:
        return fmpq(fmpz.fac_ui(int(r.p) - 1))
    if r == fmpq(1, 2):
        return m.sqrt(m.pi)
    if fmpq(1, 2) < r < 1:
        return m.pi / (m.sin(m.pi * r) * m.gamma(x * 0 + (1 - r)))
    return None


def _digamma_value(x: Any, m: Any) -> Any:
    r = literal(x)
    if r is None:
        return None
    if r == 1:
        return -m.EulerGamma(1)
    if r == fmpq(1, 2):
        return -m.EulerGamma(1) - 2 * m.log(2)
    if fmpq(1, 2) < r < 1:
        return m.digamma(x * 0 + (1 - r)) - m.pi * m.cos(m.pi * r) / m.sin(m.pi * r)
    return None


def _polygamma_value(n: Any, x: Any, m: Any) -> Any:
    order, r = whole(n), literal(x)
    if order == 0:
        return m.digamma(x)
    if order is None or r is None:
        return None
    sign = 1 if order % 2 else -1
    if r == 1:
        return sign * fmpq(fmpz.fac_ui(order)) * m.zeta(n + 1)
    if r == fmpq(1, 2):
        return sign * fmpq(fmpz.fac_ui(order)) * (fmpz(2) ** (order + 1) - 1) * m.zeta(n + 1)
    return None


def _power_of(order: int) -> Any:
    return lambda x: (-1) ** order * fmpq(fmpz.fac_ui(order)) / x ** (order + 1)


def _polygamma_down(n: Any, x: Any, m: Any) -> Any:
    """ψ⁽ⁿ⁾(x) by ψ⁽ⁿ⁾(x − 1)."""
    order = whole(n)
    return None if order is None else m.polygamma(n, x - 1) + _power_of(order)(x - 1)


def _polygamma_up(n: Any, x: Any, m: Any) -> Any:
    order = whole(n)
    return None if order is None else m.polygamma(n, x + 1) - _power_of(order)(x)


def _gamma_multiplied(n: int, x: Any, m: Any) -> Any:
    """Gauss's multiplication formula (DLMF 5.5.6)."""
    found = (2 * m.pi) ** fmpq(1 - n, 2) * (0 * x + n) ** (x - fmpq(1, 2))
    for k in range(n):
        found = found * m.gamma((x + k) / n)
    return found


def _digamma_multiplied(n: int, x: Any, m: Any) -> Any:
    """DLMF 5.5.9."""
    found = m.log(n)
    for k in range(n):
        found = found + m.digamma((x + k) / n) / n
    return found


def _polygamma_multiplied(n: int, order: Any, x: Any, m: Any) -> Any:
    times = whole(order)
    if times is None:
        return None
    found = 0 * x
    for k in range(n):
        found = found + m.polygamma(order, (x + k) / n) / fmpq(n) ** (times + 1)
    return found


def _stirling(k: int) -> fmpq:
    if k % 2 == 0:
        return fmpq(0)
    return bernoulli(k + 1) / (k * (k + 1))


def _stirling_exact(v: arb) -> arb:
    x = 1 / v
    return x.lgamma() - (x - fmpq(1, 2)) * x.log() + x - (2 * arb.pi()).log() / 2


def _digamma_coefficient(k: int) -> fmpq:
    if k == 0:
        return fmpq(0)
    if k == 1:
        return fmpq(-1, 2)
    return fmpq(0) if k % 2 else -bernoulli(k) / k


def _digamma_exact(v: arb) -> arb:
    return (1 / v).digamma() + v.log()


def polygamma_tail_coefficient(order: int, k: int) -> fmpq:
    """Return the coefficient of v^k of (−1)^(n−1) ψ⁽ⁿ⁾(1/v)/vⁿ, n = ``order`` ≥ 1."""
    if k == 0:
        return fmpq(fmpz.fac_ui(order - 1))
    if k == 1:
        return fmpq(fmpz.fac_ui(order), 2)
    if k % 2:
        return fmpq(0)
    return bernoulli(k) * fmpq(fmpz.fac_ui(k + order - 1), fmpz.fac_ui(k))


def _tails(order: int) -> Function:
    sign = 1 if order % 2 else -1
    return factor(
        f"polygamma_tail{order}", lambda k: polygamma_tail_coefficient(order, k),
        lambda v: sign * real_part(acb(1 / v).polygamma(acb(order))) / v**order,
        source="DLMF 5.15.8 and 5.11(ii)", first=2,
    )  # fmt: skip


MOST_TAILS = 5


def _polygamma_far(n: Any, x: Any, m: Any) -> Any:
    order = whole(n)
    if order is None or not 1 <= order <= MOST_TAILS:
        return None
    sign = 1 if order % 2 else -1
    return sign * getattr(m, f"polygamma_tail{order}")(1 / x) / x**order


def _polygamma_sign(n: Any, x: Any, m: Any) -> Any:
    order = whole(n)
    return x if order is not None and order % 2 else x * 0 - 1


def _polygamma_minus(n: Any, x: Any, m: Any) -> Any:
    order = whole(n)
    return x if order is not None and order > 0 and order % 2 == 0 else x * 0 - 1


def _tail_term(s: Any, k: int) -> Any:
    """(s − 1)(s − 2) … (s − k) (DLMF 8.11.1)."""
    found = fmpq(1)
    for j in range(1, k + 1):
        found = found * (s - j)
    return found


def _tail_rest(s: arb, v: arb, n: int) -> arb:
    """The first omitted term bounds the remainder after k ≥ s − 1 terms (DLMF 8.11(i))."""
    total = arb(0)
    for k in range(n, n + 60):
        total += abs(arb(1) * _tail_term(s, k)) * v ** (k - n)
        if arb(k) >= s - 1:
            return total
    return NAN


def _upper_exact(s: arb, v: arb) -> arb:
    x = 1 / v
    return x ** (1 - s) * x.exp() * x.gamma_upper(s)


def _upper_value(s: Any, x: Any, m: Any) -> Any:
    r = literal(s)
    if r == 0:
        return m.expint(s + 1, x)
    if r == 1:
        return m.exp(-x)
    if r == fmpq(1, 2):
        return m.sqrt(m.pi) * (1 - m.erf(m.sqrt(x)))
    return None


def _lower_value(s: Any, x: Any, m: Any) -> Any:
    return m.gamma(s) - m.uppergamma(s, x)


def _lower_near(s: Any, x: Any, m: Any) -> Any:
    """x^s Σ (−x)^k/(k!(s + k)) (DLMF 8.7.1)."""
    return x**s * m.lower_series(s, x)


def _upper_near(s: Any, x: Any, m: Any) -> Any:
    r = literal(s)
    if r is not None and r.q == 1 and r <= 0:
        return None
    return m.gamma(s) - _lower_near(s, x, m)


def _lower_series_term(s: Any, k: int) -> Any:
    return fmpq((-1) ** k, fmpz.fac_ui(k)) / (s + k)


def _lower_series(s: arb, x: arb) -> arb:
    found: arb = (-x).hypgeom_1f1(s, s + 1) / s
    return found


def _gamma_upper(s: arb, x: arb) -> arb:
    if not x > 0:
        return NAN
    return monotone(lambda y: y.gamma_upper(s))(x)


def _gamma_lower(s: arb, x: arb) -> arb:
    if not (s > 0 and x >= 0):
        return NAN
    if is_wide(x):
        low, high = arb(x.lower()), arb(x.upper())
        first = low.gamma_lower(s) if low > 0 else arb(0)
        return first.union(high.gamma_lower(s))
    return x.gamma_lower(s)


GAMMA = (
    Function(
        name="gamma", family="gamma", definition=r"\Gamma(x) = \int_0^\infty t^{x-1} e^{-t}\,dt",
        source="DLMF 5.2.1", needs=no_pole, derivatives=(lambda x, m: m.gamma(x) * m.digamma(x),),
        ball=_gamma, series=lambda s: s.gamma(), double=math.gamma, never_zero=True,
        holomorphic=lambda z: acb(z).gamma(), positive_where=lambda x, m: x,
        rewritten=_gamma_value, recurrence=lambda x, m: (x - 1) * m.gamma(x - 1),
        raising=lambda x, m: m.gamma(x + 1) / x,
        mirror=lambda x, m: m.pi / (m.sin(m.pi * x) * m.gamma(1 - x)),
        near={"oo": lambda x, m: m.exp(m.loggamma(x))}, poles=True,
        multiplied=_gamma_multiplied,
        latex=r"\Gamma", mathml="Γ", mathematica="Gamma", maple="GAMMA", sympy="gamma",
        aliases=("Gamma", "GAMMA", "tgamma"),
        theorems=("DLMF 5.11(ii): Stirling's series is enveloping",),
        falsehoods=("gamma(x) >= 1 given x > 0", "gamma(x + 1) == (x + 1)*gamma(x)"),
    ),
    Function(
        name="rgamma", family="gamma", definition=r"1/\Gamma(x)", source="DLMF 5.2(i)",
        derivatives=(lambda x, m: -m.digamma(x) / m.gamma(x),), ball=lambda x: x.rgamma(),
        series=lambda s: s.rgamma(), positive_where=lambda x, m: x,
        rewritten=lambda x, m: 1 / m.gamma(x), sympy="", latex=r"\operatorname{rgamma}",
        near={"oo": lambda x, m: m.exp(-m.loggamma(x))}, internal=True,
    ),
    Function(
        name="loggamma", family="gamma", definition=r"\ln\Gamma(x),\ x > 0", source="DLMF 5.2(i)",
        needs=_positive, derivatives=(lambda x, m: m.digamma(x),), ball=_loggamma,
        series=lambda s: s.lgamma() if s[0] > 0 else s.lgamma() * NAN,
        holomorphic=on_the_right(lambda z: z.lgamma()), double=math.lgamma,
        rewritten=lambda x, m: m.log(m.gamma(x)),
        near={
            "oo": lambda x, m: (x - fmpq(1, 2)) * m.log(x) - x + m.log(2 * m.pi) / 2
            + m.gamma_tail(1 / x),
            "0+": lambda x, m: m.loggamma(1 + x) - m.log(x),
        },
        latex=r"\operatorname{loggamma}", mathematica="LogGamma", maple="lnGAMMA",
        sympy="loggamma", aliases=("lgamma", "lnGAMMA", "LogGamma", "gammaln"),
        theorems=("DLMF 5.11(ii): Stirling's series is enveloping",),
        falsehoods=("loggamma(x) >= 0 given x > 0",
                    "loggamma(x) <= (x - 1/2)*log(x) - x + log(2*pi)/2 given x > 0"),
    ),
    factor("gamma_tail", _stirling, _stirling_exact, source="DLMF 5.11.1 and 5.11(ii)"),
    Function(
        name="digamma", family="gamma", definition=r"\psi(x) = \Gamma'(x)/\Gamma(x)",
        source="DLMF 5.2.2", needs=no_pole, derivatives=(lambda x, m: m.polygamma(1, x),),
        ball=_digamma, series=lambda s: composed(derived(jets_of("lgamma"), 1), s)
        if s[0] > 0 else s * NAN,
        holomorphic=lambda z: acb(z).digamma(),
        rewritten=_digamma_value, recurrence=lambda x, m: m.digamma(x - 1) + 1 / (x - 1),
        raising=lambda x, m: m.digamma(x + 1) - 1 / x,
        mirror=lambda x, m: m.digamma(1 - x) - m.pi * m.cos(m.pi * x) / m.sin(m.pi * x),
        near={
            "oo": lambda x, m: m.log(x) + m.digamma_tail(1 / x),
        }, poles=True, multiplied=_digamma_multiplied,
        latex=r"\psi", mathml="ψ", mathematica="PolyGamma", maple="Psi", sympy="digamma",
        aliases=("psi_function", "PolyGamma"),
        theorems=("DLMF 5.11(ii): the expansion is enveloping",),
        falsehoods=("digamma(x) <= log(x) - 1/x given x > 0", "digamma(x + 1) == digamma(x) - 1/x"),
    ),
    factor("digamma_tail", _digamma_coefficient, _digamma_exact, source="DLMF 5.11.2",
           first=2),
    Function(
        name="polygamma", family="gamma", arity=2, definition=r"\psi^{(n)}(x)", source="DLMF 5.15",
        needs=lambda n, x, m: no_pole(x, m),
        derivatives=(None, lambda n, x, m: m.polygamma(n + 1, x)), ball=_polygamma,
        series=lambda n, s: composed(derived(jets_of("lgamma"), int(n[0].unique_fmpz()) + 1), s)
        if s[0] > 0 else s * NAN,
        positive_where=_polygamma_sign, negative_where=_polygamma_minus,
        rewritten=_polygamma_value,
        recurrence=_polygamma_down, raising=_polygamma_up,
        near={"oo": _polygamma_far}, poles=True, shifted=1, multiplied=_polygamma_multiplied,
        latex=r"\operatorname{polygamma}", mathematica="PolyGamma", maple="Psi",
        sympy="polygamma", theorems=("DLMF 5.15.8: the expansion is enveloping",),
        falsehoods=("polygamma(1, x) <= 1/x + 1/(3*x**2) given x > 0", "polygamma(2, x) > 0"),
    ),
    *(_tails(n) for n in range(1, MOST_TAILS + 1)),
    Function(
        name="uppergamma", family="incomplete gamma", arity=2, source="DLMF 8.2.2",
        definition=r"\Gamma(s, x) = \int_x^\infty t^{s-1} e^{-t}\,dt",
        needs=lambda s, x, m: ((x, ">"),), range=Interval(fmpq(0), None, True),
        derivatives=(None, lambda s, x, m: -(x ** (s - 1)) * m.exp(-x)), ball=_gamma_upper,
        rewritten=_upper_value, series=lambda n, s: composed(
            lambda y, k: jets_of_upper(n[0], y, k), s),
        recurrence=lambda s, x, m: (s - 1) * m.uppergamma(s - 1, x) + x ** (s - 1) * m.exp(-x),
        raising=lambda s, x, m: (m.uppergamma(s + 1, x) - x**s * m.exp(-x)) / s,
        near={
            "oo": lambda s, x, m: x ** (s - 1) * m.exp(-x) * m.uppergamma_tail(s, 1 / x),
            "0+": _upper_near,
        },
        near_needs=lambda s, x, m: s if literal(s) is None else None,
        theorems=("DLMF 8.11(i): the expansion is enveloping from the term s − 1 on",),
        latex=r"\Gamma", mathml="Γ", mathematica="Gamma", maple="GAMMA", sympy="uppergamma",
        falsehoods=("uppergamma(2, x) <= exp(-x) given x > 0",
                    "diff(uppergamma(s, x), x) == x**s*exp(-x)"),
    ),
    parametric("uppergamma_tail", _tail_term, _upper_exact, _tail_rest, "DLMF 8.11.1"),
    Function(
        name="lower_series", family="incomplete gamma", arity=2, internal=True,
        source="DLMF 8.7.1", derivatives=(None, None), entire=True, ball=_lower_series,
        taylor=lambda s, k, m: _lower_series_term(s, k), latex=r"\gamma^{*}",
        series=lambda n, s: composed(lambda y, k: _lower_jets(n[0], y, k), s),
    ),
    Function(
        name="lowergamma", family="incomplete gamma", arity=2, source="DLMF 8.2.1",
        definition=r"\gamma(s, x) = \int_0^x t^{s-1} e^{-t}\,dt",
        needs=lambda s, x, m: ((s, ">"), (x, ">=")), singular=lambda s, x, m: ((s, ">"), (x, ">")),
        smooth=False, range=Interval(fmpq(0)),
        derivatives=(None, lambda s, x, m: x ** (s - 1) * m.exp(-x)), ball=_gamma_lower,
        near={"0+": _lower_near},
        rewritten=_lower_value, latex=r"\gamma", mathml="γ", mathematica="Gamma", maple="GAMMA",
        sympy="lowergamma", falsehoods=("lowergamma(2, x) >= x**2/2 given x > 0",
                                        "lowergamma(1, x) == exp(-x)"),
    ),
)  # fmt: skip


def _lower_jets(s: arb, x: arb, n: int) -> list[arb]:
    """Return Taylor coefficients of Σ (−x)^k/(k!(s + k)) = ∫₀¹ t^(s−1) e^(−xt) dt for s > 0."""
    if not s > 0:
        return [NAN] * n
    size = arb(abs(x).upper()).exp()
    return [
        _lower_series(s, x),
        *(size * arb(0, 1) / (arb(fmpz.fac_ui(k)) * (s + k)) for k in range(1, n)),
    ]


def jets_of_upper(s: arb, x: arb, n: int) -> list[arb]:
    """Return the Taylor coefficients of Γ(s, x) in x."""
    from flint import arb_series, ctx

    before, ctx.cap = ctx.cap, n
    try:
        y = arb_series([x, 1], n)
        slope = -((y.log() * (s - 1) - y).exp())
        known = [slope[k] for k in range(n)]
    finally:
        ctx.cap = before
    return [_gamma_upper(s, x), *(known[k] / (k + 1) for k in range(n - 1))]
