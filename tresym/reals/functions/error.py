"""The error functions, Dawson's integral and Fresnel's integrals.

Source: DLMF 7. The expansions of erfc and of Fresnel's auxiliary functions are enveloping for
x > 0: the error is at most the first omitted term (DLMF 7.12(i) and 7.12(ii)).
"""

from __future__ import annotations

import math
from math import factorial
from typing import Any

from flint import acb, arb, fmpq

from tresym.reals.functions.enclosures import NAN, factor, monotone, with_slope
from tresym.reals.functions.row import Function
from tresym.reals.numbers.exact import Interval

ENVELOPING = "DLMF 7.12(i): the expansion of erfc is enveloping"


def _gaussian(sign: int) -> Any:
    """e^(±x²)·2/√π, the derivative of erf and erfi."""
    return lambda x, m: 2 / m.sqrt(m.pi) * m.exp(sign * x**2)


def _erf_taylor(sign: int) -> Any:
    def coefficient(k: int, m: Any) -> Any:
        if k % 2 == 0:
            return fmpq(0)
        j = k // 2
        return fmpq(2 * sign**j, factorial(j) * k) / m.sqrt(m.pi)

    return coefficient


def half_rising(k: int) -> fmpq:
    """Return (1/2)(3/2)…, k factors."""
    found = fmpq(1)
    for j in range(k):
        found *= fmpq(2 * j + 1, 2)
    return found


def _erfc_exact(v: arb) -> arb:
    x = (1 / v).sqrt()
    return arb.pi().sqrt() * x * (x * x).exp() * x.erfc()


def _dawson(x: arb) -> arb:
    return arb.pi().sqrt() / 2 * (-(x * x)).exp() * x.erfi()


def _dawson_slope(x: arb) -> arb:
    return 1 - 2 * x * _dawson(x)


def _erfi_exact(v: arb) -> arb:
    x = (1 / v).sqrt()
    return 2 * x * _dawson(x)


def _erfi_rest(s: arb, n: int) -> arb:
    """Bound the remainder of 2xF(x), v = 1/x², on 0 < v ≤ s.

    With R(x) = e^(x²)·(F(x) − Σ_{k<n} a_k/(2x^(2k+1))), R' = a_n x^(−2n) e^(x²), a_n = (1/2)_n. For
    x² ≥ 2n + 1, (e^(x²)/x^(2n+1))' ≥ e^(x²)/x^(2n), so |R| ≤ |R(x₀)| + a_n e^(x²)/x^(2n+1) from
    x₀ = s^(−1/2) on, where e^(x²)/x^(2n+1) increases.
    """
    low = (1 / s).sqrt()
    if not low * low >= 2 * n + 1:
        return NAN
    total = arb(0)
    for k in reversed(range(n)):
        total = total * s + arb(half_rising(k))
    start = abs(_dawson(low) - total / (2 * low)) * low ** (2 * n + 1)
    return 2 * (start + arb(half_rising(n)))


def _fresnel_f(k: int) -> fmpq:
    return fmpq(0) if k % 2 else (-1) ** (k // 2) * half_rising(k)


def _fresnel_g(k: int) -> fmpq:
    return (-1) ** (k // 2) * half_rising(k) if k % 2 else fmpq(0)


def _auxiliary(which: str) -> Any:
    """π x f(x) or π x g(x) with v = 2/(πx²)."""

    def exact(v: arb) -> arb:
        x = (2 / (arb.pi() * v)).sqrt()
        s, c = arb(fmpq(1, 2)) - x.fresnel_s(), arb(fmpq(1, 2)) - x.fresnel_c()
        turn = arb.pi() * x * x / 2
        if which == "f":
            return arb.pi() * x * (s * turn.cos() - c * turn.sin())
        return arb.pi() * x * (c * turn.cos() + s * turn.sin())

    return exact


def _fresnel_parts(x: Any, m: Any) -> tuple[Any, Any, Any, Any]:
    v = 2 / (m.pi * x**2)
    turn = m.pi * x**2 / 2
    return m.fresnel_f(v) / (m.pi * x), m.fresnel_g(v) / (m.pi * x), m.sin(turn), m.cos(turn)


def _fresnels_far(side: int) -> Any:
    def formula(x: Any, m: Any) -> Any:
        f, g, s, c = _fresnel_parts(side * x, m)
        return side * (fmpq(1, 2) - f * c - g * s)

    return formula


def _fresnelc_far(side: int) -> Any:
    def formula(x: Any, m: Any) -> Any:
        f, g, s, c = _fresnel_parts(side * x, m)
        return side * (fmpq(1, 2) + f * s - g * c)

    return formula


def _fresnel_taylor(odd: int) -> Any:
    """∫ sin(πt²/2) or cos: Σ (−1)^j (π/2)^(2j+odd)/((2j+odd)!(4j+2·odd+1)) x^(4j+2·odd+1)."""

    def coefficient(k: int, m: Any) -> Any:
        j, rest = divmod(k - 2 * odd - 1, 4)
        if rest or j < 0:
            return fmpq(0)
        power = 2 * j + odd
        return fmpq((-1) ** j, factorial(power) * k) * (m.pi / 2) ** power

    return coefficient


def _at_most(slope: Any) -> Any:
    return lambda x: slope(arb.pi() * x * x / 2)


def _erfc_far(x: Any, m: Any) -> Any:
    return m.exp(-(x**2)) / (x * m.sqrt(m.pi)) * m.erfc_tail(1 / x**2)


ERROR = (
    Function(
        name="erf", family="error functions", source="DLMF 7.2.1",
        definition=r"\operatorname{erf} x = \frac{2}{\sqrt{\pi}} \int_0^x e^{-t^2}\,dt", odd=True,
        rising=True, vanishes_with_argument=True, range=Interval(fmpq(-1), fmpq(1), True, True),
        derivatives=(_gaussian(-1),), ball=monotone(lambda x: x.erf()), series=lambda s: s.erf(),
        double=math.erf, holomorphic=lambda z: acb(z).erf(), taylor=_erf_taylor(-1), entire=True,
        near={"oo": lambda x, m: 1 - _erfc_far(x, m), "-oo": lambda x, m: -1 - _erfc_far(x, m)},
        latex=r"\operatorname{erf}", mathematica="Erf", maple="erf", sympy="erf", aliases=("Erf",),
        theorems=(ENVELOPING,),
        falsehoods=("erf(x) <= tanh(x) given x > 0", "diff(erf(x), x) == exp(-x**2)"),
    ),
    Function(
        name="erfc", family="error functions", source="DLMF 7.2.2",
        definition=r"\operatorname{erfc} x = 1 - \operatorname{erf} x", falling=True,
        range=Interval(fmpq(0), fmpq(2), True, True),
        derivatives=(lambda x, m: -_gaussian(-1)(x, m),), ball=monotone(lambda x: x.erfc()),
        series=lambda s: s.erfc(), double=math.erfc, entire=True,
        holomorphic=lambda z: acb(z).erfc(), rewritten=lambda x, m: 1 - m.erf(x), near={
            "oo": _erfc_far, "-oo": lambda x, m: 2 + _erfc_far(x, m)},
        latex=r"\operatorname{erfc}", mathematica="Erfc", maple="erfc", sympy="erfc",
        aliases=("Erfc",), theorems=(ENVELOPING,),
        falsehoods=("erfc(x) <= exp(-x**2)/2 given x > 0", "erfc(-x) == erfc(x)"),
    ),
    factor("erfc_tail", lambda k: (-1) ** k * half_rising(k), _erfc_exact, source="DLMF 7.12.1"),
    Function(
        name="erfi", family="error functions", source="DLMF 7.2.5, 7.5.2", odd=True, rising=True,
        definition=r"\operatorname{erfi} x = \frac{2}{\sqrt{\pi}} \int_0^x e^{t^2}\,dt",
        vanishes_with_argument=True, derivatives=(_gaussian(1),),
        ball=monotone(lambda x: x.erfi()), series=lambda s: s.erfi(), taylor=_erf_taylor(1),
        holomorphic=lambda z: acb(z).erfi(),
        entire=True, near={
            side: lambda x, m: m.exp(x**2) / (x * m.sqrt(m.pi)) * m.erfi_tail(1 / x**2)
            for side in ("oo", "-oo")},
        latex=r"\operatorname{erfi}", mathematica="Erfi", maple="erfi", sympy="erfi",
        aliases=("Erfi",),
        falsehoods=("erfi(x) <= 2*x/sqrt(pi) given x > 0", "diff(erfi(x), x) == exp(x**2)"),
    ),
    factor("erfi_tail", half_rising, _erfi_exact, _erfi_rest, source="DLMF 7.12.2, by integration"),
    Function(
        name="dawson", family="error functions", source="DLMF 7.2.5", odd=True,
        definition=r"F(x) = e^{-x^2} \int_0^x e^{t^2}\,dt", vanishes_with_argument=True,
        range=Interval(fmpq(-11, 20), fmpq(11, 20), True, True),
        derivatives=(lambda x, m: 1 - 2 * x * m.dawson(x),),
        ball=with_slope(_dawson, _dawson_slope),
        series=lambda s: arb.pi().sqrt() / 2 * (-(s * s)).exp() * s.erfi(), entire=True,
        rewritten=lambda x, m: m.sqrt(m.pi) / 2 * m.exp(-(x**2)) * m.erfi(x),
        latex=r"F", mathematica="DawsonF", maple="dawson", sympy="", aliases=("DawsonF",),
        falsehoods=("dawson(x) >= x - x**3/2 given x > 0", "diff(dawson(x), x) == 1 - x*dawson(x)"),
    ),
    Function(
        name="fresnels", family="Fresnel integrals", source="DLMF 7.2.8", odd=True, rising=False,
        definition=r"S(x) = \int_0^x \sin(\pi t^2/2)\,dt", vanishes_with_argument=True,
        range=Interval(fmpq(-18, 25), fmpq(18, 25), True, True),
        derivatives=(lambda x, m: m.sin(m.pi * x**2 / 2),),
        holomorphic=lambda z: acb(z).fresnel_s(),
        ball=with_slope(lambda x: x.fresnel_s(), _at_most(lambda t: t.sin())),
        series=lambda s: s.fresnel_s(), entire=True, taylor=_fresnel_taylor(1),
        near={"oo": _fresnels_far(1), "-oo": _fresnels_far(-1)}, latex="S", mathematica="FresnelS",
        maple="FresnelS", sympy="fresnels", aliases=("FresnelS",),
        theorems=("DLMF 7.12(ii): the expansions of f and g are enveloping",),
        falsehoods=("fresnels(x) <= 1/2 given x > 0", "diff(fresnels(x), x) == sin(x**2)"),
    ),
    Function(
        name="fresnelc", family="Fresnel integrals", source="DLMF 7.2.7", odd=True,
        definition=r"C(x) = \int_0^x \cos(\pi t^2/2)\,dt", vanishes_with_argument=True,
        range=Interval(fmpq(-39, 50), fmpq(39, 50), True, True),
        derivatives=(lambda x, m: m.cos(m.pi * x**2 / 2),),
        holomorphic=lambda z: acb(z).fresnel_c(),
        ball=with_slope(lambda x: x.fresnel_c(), _at_most(lambda t: t.cos())),
        series=lambda s: s.fresnel_c(), entire=True, taylor=_fresnel_taylor(0),
        near={"oo": _fresnelc_far(1), "-oo": _fresnelc_far(-1)}, latex="C", mathematica="FresnelC",
        maple="FresnelC", sympy="fresnelc", aliases=("FresnelC",),
        theorems=("DLMF 7.12(ii): the expansions of f and g are enveloping",),
        falsehoods=("fresnelc(x) <= 3/4 given x > 0", "diff(fresnelc(x), x) == cos(x**2)"),
    ),
    factor("fresnel_f", _fresnel_f, _auxiliary("f"), source="DLMF 7.12.2"),
    factor("fresnel_g", _fresnel_g, _auxiliary("g"), source="DLMF 7.12.3"),
)  # fmt: skip
