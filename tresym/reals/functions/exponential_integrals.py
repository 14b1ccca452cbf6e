"""Exponential, logarithmic, sine and cosine integrals.

Source: DLMF 6 and 8.19. E₁ and the auxiliary functions of Si and Ci have enveloping expansions for
x > 0 (DLMF 6.12(i) and 6.12(ii)); the remainder of Ei is bounded by integration.
"""

from __future__ import annotations

from math import factorial
from typing import Any

from flint import acb, arb, fmpq

from tresym.reals.functions.enclosures import (
    NAN,
    composed,
    factor,
    is_wide,
    literal,
    monotone,
    on_the_right,
    with_slope,
)
from tresym.reals.functions.row import Conditions, Function
from tresym.reals.numbers.exact import Interval


def _positive(x: Any, m: Any) -> Conditions:
    return ((x, ">"),)


def _expint(n: arb, x: arb) -> arb:
    if not x > 0:
        return NAN
    return monotone(lambda y: y.expint(n))(x)


def _expint_value(n: Any, x: Any, m: Any) -> Any:
    r = literal(n)
    if r == 0:
        return m.exp(-x) / x
    if r == fmpq(1, 2):
        return m.sqrt(m.pi) / m.sqrt(x) * (1 - m.erf(m.sqrt(x)))
    return None


def _expint_jets(n: arb) -> Any:
    def jets(x: arb, length: int) -> list[arb]:
        return [
            (-1) ** k * _expint(n - k, x) / factorial(k) if k else _expint(n, x)
            for k in range(length)
        ]

    return jets


def _e1_exact(v: arb) -> arb:
    x = 1 / v
    return x * x.exp() * x.expint(arb(1))


def _ei_exact(v: arb) -> arb:
    x = 1 / v
    return x * (-x).exp() * x.ei()


def _ei_rest(s: arb, n: int) -> arb:
    """Bound the remainder of x e^(−x) Ei(x), v = 1/x, on 0 < v ≤ s.

    R(x) = Ei(x) − e^x/x Σ_{k<n} k!/x^k has R' = n! e^x/x^(n+1), and for x ≥ 2(n+1) the derivative
    of 2 e^x/x^(n+1) is at least e^x/x^(n+1). So |R| ≤ |R(x₀)| + 2 n! e^x/x^(n+1) from x₀ = 1/s on,
    where e^x/x^(n+1) increases.
    """
    low = 1 / s
    if not low >= 2 * (n + 1):
        return NAN
    total = arb(0)
    for k in reversed(range(n)):
        total = total * s + factorial(k)
    start = abs(_ei_exact(s) - total) * low**n
    return start + 2 * factorial(n)


def _ei(x: arb) -> arb:
    if x.contains(0):
        return NAN
    return monotone(lambda y: y.ei())(x)  # its derivative e^x/x has one sign on either side


def _ein_taylor(k: int, m: Any) -> Any:
    """Σ_{k≥1} x^k/(k·k!), which is Ei(x) − γ − ln|x|."""
    return fmpq(1, k * factorial(k)) if k else fmpq(0)


def _ein(x: arb) -> arb:
    """Return Σ_{k≥1} x^k/(k·k!) = x ₂F₂(1, 1; 2, 2; x)."""
    one, two = arb(1), arb(2)
    return monotone(lambda y: y * y.hypgeom([one, one], [two, two]))(x)


def _li(x: arb) -> arb:
    if not x > 0 or x.contains(1):
        return NAN
    return monotone(lambda y: y.log().ei())(x)


def _si_taylor(k: int, m: Any) -> Any:
    return fmpq((-1) ** (k // 2), k * factorial(k)) if k % 2 else fmpq(0)


def _cin_taylor(k: int, m: Any) -> Any:
    """Ci(x) − γ − ln x."""
    return fmpq((-1) ** (k // 2), k * factorial(k)) if k and k % 2 == 0 else fmpq(0)


def _cin(x: arb) -> arb:
    one, two, half = arb(1), arb(2), arb(fmpq(3, 2))
    inner = -x * x / 4
    rough = inner * inner.hypgeom([one, one], [half, two, two])
    if not is_wide(x):
        return rough
    middle = x.mid()
    inner = -middle * middle / 4
    finer = inner * inner.hypgeom([one, one], [half, two, two]) + (x - middle) * arb(0, 1)
    return finer.intersection(rough) if rough.is_finite() else finer  # |(cos x − 1)/x| < 1


def _cin_jets(x: arb, n: int) -> list[arb]:
    """Return Taylor coefficients: the derivative is −∫ sin(xt) dt over [0, 1]."""
    return [_cin(x), *(arb(0, 1) / (k * factorial(k)) for k in range(1, n))]


def _auxiliary(which: str) -> Any:
    def exact(v: arb) -> arb:
        x = 1 / v
        s, c = arb.pi() / 2 - x.si(), x.ci()
        if which == "f":
            return x * (c * x.sin() + s * x.cos())
        return x * (s * x.sin() - c * x.cos())

    return exact


def _f_coefficient(k: int) -> fmpq:
    return fmpq(0) if k % 2 else fmpq((-1) ** (k // 2) * factorial(k))


def _g_coefficient(k: int) -> fmpq:
    return fmpq((-1) ** (k // 2) * factorial(k)) if k % 2 else fmpq(0)


def _parts(x: Any, m: Any) -> tuple[Any, Any]:
    return m.si_tail(1 / x) / x, m.ci_tail(1 / x) / x


def _si_far(side: int) -> Any:
    def formula(x: Any, m: Any) -> Any:
        f, g = _parts(side * x, m)
        return side * (m.pi / 2 - f * m.cos(x) - g * m.sin(side * x))

    return formula


def _ci_far(x: Any, m: Any) -> Any:
    f, g = _parts(x, m)
    return f * m.sin(x) - g * m.cos(x)


def _ei_value(x: Any, m: Any) -> Any:
    """Ei(−x) = −E₁(x) where the sign of a literal shows; see ``mirror``."""
    r = literal(x)
    return None if r is None or r > 0 else -m.expint(1, -x)


def _small_ei(x: Any, m: Any) -> Any:
    return m.EulerGamma(1) + m.log(abs(x)) + m.ein(x)


def _sinc(x: arb) -> arb:
    return x.sinc()


def _holomorphic_ei(z: Any) -> acb:
    """Ei in complex balls: left of 0 it is −E₁(−z), which is real on the negative axis."""
    z = acb(z)
    if z.real > 0:
        return z.ei()
    return -(-z).expint(acb(1)) if z.real < 0 else acb(NAN)


EXPONENTIAL_INTEGRALS = (
    Function(
        name="expint", family="exponential integrals", arity=2, source="DLMF 8.19.3",
        definition=r"E_n(x) = \int_1^\infty e^{-xt} t^{-n}\,dt,\ x > 0",
        needs=lambda n, x, m: ((x, ">"),), range=Interval(fmpq(0), None, True),
        derivatives=(None, lambda n, x, m: -m.expint(n - 1, x)), ball=_expint,
        series=lambda n, s: composed(_expint_jets(n[0]), s), rewritten=_expint_value, start=1,
        holomorphic=on_the_right(lambda n, z: z.expint(n)),
        recurrence=lambda n, x, m: (m.exp(-x) - x * m.expint(n - 1, x)) / (n - 1),
        raising=lambda n, x, m: (m.exp(-x) - n * m.expint(n + 1, x)) / x,
        near={
            "oo": lambda n, x, m: m.exp(-x) / x * m.uppergamma_tail(1 - n, 1 / x),
            "0+": lambda n, x, m: -m.EulerGamma(1) - m.log(x) - m.ein(-x)
            if literal(n) == 1 else None,
        },
        latex=r"E", mathml="E", subscripted=True, mathematica="ExpIntegralE", maple="Ei",
        sympy="expint", aliases=("ExpIntegralE",),
        theorems=("DLMF 6.12(i): the expansion is enveloping",),
        falsehoods=("expint(1, x) <= exp(-x)*log(1 + 1/x)/2 given x > 0",
                    "diff(expint(1, x), x) == exp(-x)/x"),
    ),
    factor("e1_tail", lambda k: fmpq((-1) ** k * factorial(k)), _e1_exact, source="DLMF 6.12.1"),
    factor("ei_tail", lambda k: fmpq(factorial(k)), _ei_exact, _ei_rest,
           source="DLMF 6.12.2, the bound by integration"),
    Function(
        name="Ei", family="exponential integrals", source="DLMF 6.2.5",
        definition=r"\operatorname{Ei} x = -\!\!\!\!\int_{-\infty}^x e^t/t\,dt,\ x \ne 0",
        needs=lambda x, m: ((x, "!="),), derivatives=(lambda x, m: m.exp(x) / x,), ball=_ei,
        series=lambda s: s.ei() if not s[0].contains(0) else s * NAN, rewritten=_ei_value,
        holomorphic=_holomorphic_ei,
        near={
            "oo": lambda x, m: m.exp(x) / x * m.ei_tail(1 / x),
            "-oo": lambda x, m: m.exp(x) / x * m.e1_tail(-1 / x),
            "0+": _small_ei, "0-": _small_ei,
        },
        latex=r"\operatorname{Ei}", mathematica="ExpIntegralEi", maple="Ei", sympy="Ei",
        aliases=("ExpIntegralEi",), mirror=lambda x, m: -m.expint(1, -x),
        falsehoods=("Ei(x) <= exp(x)/x given x > 0", "diff(Ei(x), x) == exp(-x)/x"),
    ),
    Function(
        name="ein", family="exponential integrals", source="DLMF 6.6.2", internal=True,
        latex=r"\operatorname{Ein}^{*}",
        definition=r"\sum_{k \ge 1} x^k/(k\,k!)", rising=True, vanishes_with_argument=True,
        derivatives=(lambda x, m: (m.exp(x) - 1) / x,), ball=_ein, taylor=_ein_taylor, entire=True,
        series=lambda s: composed(_ein_jets, s),
    ),
    Function(
        name="li", family="exponential integrals", source="DLMF 6.2.8",
        definition=r"\operatorname{li} x = -\!\!\!\!\int_0^x dt/\ln t,\ x \ne 1",
        needs=lambda x, m: ((x, ">"), (x - 1, "!=")), derivatives=(lambda x, m: 1 / m.log(x),),
        ball=_li, rewritten=lambda x, m: m.Ei(m.log(x)),
        series=lambda s: s.log().ei() if s[0] > 0 and not s[0].contains(1) else s * NAN,
        latex=r"\operatorname{li}", mathematica="LogIntegral", maple="Li", sympy="li",
        aliases=("LogIntegral",),
        falsehoods=("li(x) <= x/log(x) given x > 3", "diff(li(x), x) == log(x)"),
    ),
    Function(
        name="Si", family="exponential integrals", source="DLMF 6.2.9", odd=True,
        definition=r"\operatorname{Si} x = \int_0^x \sin t/t\,dt", vanishes_with_argument=True,
        range=Interval(fmpq(-13, 7), fmpq(13, 7), True, True),
        derivatives=(lambda x, m: m.sin(x) / x,), ball=with_slope(lambda x: x.si(), _sinc),
        series=lambda s: s.si(), taylor=_si_taylor, entire=True,
        holomorphic=lambda z: acb(z).si(),
        near={"oo": _si_far(1), "-oo": _si_far(-1)}, latex=r"\operatorname{Si}",
        mathematica="SinIntegral", maple="Si", sympy="Si", aliases=("SinIntegral",),
        theorems=("DLMF 6.12(ii): the expansions of f and g are enveloping",),
        falsehoods=("Si(x) <= pi/2 given x > 0", "diff(Si(x), x) == cos(x)/x"),
    ),
    Function(
        name="Ci", family="exponential integrals", source="DLMF 6.2.11", needs=_positive,
        definition=r"\operatorname{Ci} x = -\int_x^\infty \cos t/t\,dt,\ x > 0",
        derivatives=(lambda x, m: m.cos(x) / x,),
        ball=with_slope(lambda x: x.ci() if x > 0 else NAN, lambda x: x.cos() / x),
        series=lambda s: s.ci() if s[0] > 0 else s * NAN,
        holomorphic=on_the_right(lambda z: z.ci()),
        near={"oo": _ci_far, "0+": lambda x, m: m.EulerGamma(1) + m.log(x) + m.cin(x)},
        latex=r"\operatorname{Ci}", mathematica="CosIntegral", maple="Ci", sympy="Ci",
        aliases=("CosIntegral",),
        theorems=("DLMF 6.12(ii): the expansions of f and g are enveloping",),
        falsehoods=("Ci(x) <= 2/5 given x > 0", "diff(Ci(x), x) == sin(x)/x"),
    ),
    Function(
        name="cin", family="exponential integrals", source="DLMF 6.6.6", internal=True, even=True,
        latex=r"\operatorname{Cin}^{*}",
        definition=r"\operatorname{Ci} x - \gamma - \ln x", ball=_cin, taylor=_cin_taylor,
        derivatives=(lambda x, m: (m.cos(x) - 1) / x,), entire=True,
        series=lambda s: composed(_cin_jets, s),
    ),
    factor("si_tail", _f_coefficient, _auxiliary("f"), source="DLMF 6.12.3"),
    factor("ci_tail", _g_coefficient, _auxiliary("g"), source="DLMF 6.12.4"),
)  # fmt: skip


def _ein_jets(x: arb, n: int) -> list[arb]:
    """Return the Taylor coefficients: those of (e^x − 1)/x by its series with positive terms."""
    from tresym.reals.functions.enclosures import jets_of

    if x.contains(0):
        size = arb(abs(x).upper())
        top = size.exp()
        return [_ein(x), *(top * arb(0, 1) / (k * factorial(k)) for k in range(1, n))]
    known = jets_of("ei")(x, n)
    logs = [abs(x).log(), *((-1) ** (k + 1) / (k * x**k) for k in range(1, n))]
    return [_ein(x), *(known[k] - logs[k] for k in range(1, n))]
