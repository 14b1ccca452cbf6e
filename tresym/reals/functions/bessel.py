"""Bessel functions of real order and Airy functions.

Source: DLMF 9 and 10. The expansions of K, J and Y at infinity have remainders of at most the first
omitted term from a stated index on (DLMF 10.40(iii) and 10.17(iii)). The remainder of I is bounded
by its differential equation, see :func:`_i_rest`.
"""

from __future__ import annotations

from math import factorial
from typing import Any

from flint import acb, arb, fmpq

from tresym.reals.functions.enclosures import (
    NAN,
    literal,
    monotone,
    on_the_right,
    parametric,
    whole,
    with_slope,
)
from tresym.reals.functions.row import Conditions, Function
from tresym.reals.numbers.exact import Interval

HALF = fmpq(1, 2)


def _integer_or_positive(nu: Any, x: Any, m: Any) -> Conditions:
    return () if whole(nu) is not None else ((x, ">"),)


def _positive(nu: Any, x: Any, m: Any) -> Conditions:
    return ((x, ">"),)


def coefficient(nu: Any, k: int) -> Any:
    """Return a_k(ν) of DLMF 10.17.1, for a rational number or a ball."""
    found = fmpq(1)
    for j in range(1, k + 1):
        found = found * (4 * nu * nu - (2 * j - 1) ** 2) / (8 * j)
    return found


def _first_index(nu: arb, n: int, step: int, least: int) -> int | None:
    """Return the first index k = n, n + step, … from which the error theorem holds."""
    for k in range(n, n + 60, step):
        if k >= least and arb(k) >= abs(nu) - HALF:
            return k
    return None


def _rest(nu: arb, s: arb, n: int, step: int = 1, least: int = 0) -> arb:
    """Bound the remainder after the terms below n: terms up to the index of the theorem, and one.

    ``n`` is the index of the next term that is not 0.
    """
    last = _first_index(nu, n, step, least)
    if last is None:
        return NAN
    total = arb(0)
    for k in range(n, last + 1, step):
        total += abs(arb(1) * coefficient(nu, k)) * s ** (k - n)
    return total


def _jj(nu: arb, x: arb) -> arb:
    if x > 0 or nu.is_integer():
        return x.bessel_j(nu)
    return NAN


def _cylinder(name: str) -> Any:
    """J or I in complex balls: entire for integers ν, else analytic off the negative axis."""

    def value(nu: Any, z: Any) -> acb:
        nu, z = acb(nu), acb(z)
        if not (nu.real.is_integer() and nu.imag.is_zero()) and not z.real > 0:
            return acb(NAN)
        return getattr(z, name)(nu)

    return value


def _ball_j(nu: arb, x: arb) -> arb:
    def slope(y: arb) -> arb:
        found = (_jj(nu - 1, y) - _jj(nu + 1, y)) / 2
        if nu.is_integer():  # |J_n| ≤ 1 (DLMF 10.14.1)
            found = found.intersection(arb(0, 1)) if found.is_finite() else arb(0, 1)
        return found

    return with_slope(lambda y: _jj(nu, y), slope)(x)


def _ball_y(nu: arb, x: arb) -> arb:
    if not x > 0:
        return NAN
    return with_slope(
        lambda y: y.bessel_y(nu), lambda y: (y.bessel_y(nu - 1) - y.bessel_y(nu + 1)) / 2
    )(x)


def _ball_i(nu: arb, x: arb) -> arb:
    if not (x > 0 or nu.is_integer()):
        return NAN
    if x > 0 and nu >= 0:
        return monotone(lambda y: y.bessel_i(nu))(x)
    return x.bessel_i(nu)


def _ball_k(nu: arb, x: arb) -> arb:
    if not x > 0:
        return NAN
    return monotone(lambda y: y.bessel_k(nu))(x)


def _values(kind: str) -> Any:
    """The values of order 1/2 and 3/2 (DLMF 10.16.1, 10.39.1, 10.39.2)."""

    def rule(nu: Any, x: Any, m: Any) -> Any:
        r = literal(nu)
        if r == 0 and literal(x) == 0 and kind in "ji":
            return x * 0 + 1
        if r is not None and r.q == 1 and r != 0 and literal(x) == 0 and kind in "ji":
            return x * 0
        if r not in (HALF, 3 * HALF):
            return None
        front = m.sqrt(2 / (m.pi * x))
        first = r == HALF
        if kind == "j":
            return front * (m.sin(x) if first else m.sin(x) / x - m.cos(x))
        if kind == "y":
            return -front * (m.cos(x) if first else m.cos(x) / x + m.sin(x))
        if kind == "i":
            return front * (m.sinh(x) if first else m.cosh(x) - m.sinh(x) / x)
        return m.sqrt(m.pi / (2 * x)) * m.exp(-x) * (1 if first else 1 + 1 / x)

    return rule


def _name(kind: str) -> str:
    return f"bessel{kind}"


def _recurrence(kind: str) -> tuple[Any, Any]:
    """The function by the two lower orders, and by the two higher ones (DLMF 10.6.1, 10.29.1)."""
    outer, inner = {"j": (-1, 1), "y": (-1, 1), "i": (1, -1), "k": (1, 1)}[kind]
    above = {"j": (-1, 1), "y": (-1, 1), "i": (1, 1), "k": (1, -1)}[kind]

    def down(nu: Any, x: Any, m: Any) -> Any:
        f = getattr(m, _name(kind))
        return inner * 2 * (nu - 1) / x * f(nu - 1, x) + outer * f(nu - 2, x)

    def up(nu: Any, x: Any, m: Any) -> Any:
        f = getattr(m, _name(kind))
        return above[1] * 2 * (nu + 1) / x * f(nu + 1, x) + above[0] * f(nu + 2, x)

    return down, up


def _slope(kind: str) -> Any:
    first, second = {"j": (1, -1), "y": (1, -1), "i": (1, 1), "k": (-1, -1)}[kind]

    def formula(nu: Any, x: Any, m: Any) -> Any:
        f = getattr(m, _name(kind))
        return (first * f(nu - 1, x) + second * f(nu + 1, x)) / 2

    return formula


def _parity(kind: str) -> Any:
    def formula(nu: Any, x: Any, m: Any) -> Any:
        n = whole(nu)
        if n is None:
            return None
        return (-1) ** n * getattr(m, _name(kind))(nu, -x)

    return formula


def _taylor(sign: int) -> Any:
    def formula(nu: Any, k: int, m: Any) -> Any:
        n = whole(nu)
        if n is None or n < 0:
            return None
        j, odd = divmod(k - n, 2)
        if odd or j < 0:
            return fmpq(0)
        return fmpq(sign**j, 2**k * factorial(j) * factorial(j + n))

    return formula


def _small(sign: int) -> Any:
    """(x/2)^ν/Γ(ν+1) ₀F₁(; ν+1; ∓x²/4) (DLMF 10.2.2, 10.25.2), of order not an integer."""

    def formula(nu: Any, x: Any, m: Any) -> Any:
        if whole(nu) is not None:
            return None
        return (x / 2) ** nu / m.gamma(nu + 1) * m.hyp0f1(nu + 1, sign * x**2 / 4)

    return formula


def _not_minus_one(nu: Any, x: Any, m: Any) -> Any:
    """Of an order that is no number it must be shown that it is not −1, −2, …."""
    return nu + 1 if literal(nu) is None else None


def _log_part(x: Any, m: Any) -> Any:
    return m.log(x / 2) + m.EulerGamma(1)


def _small_k(nu: Any, x: Any, m: Any) -> Any:
    """DLMF 10.31.2 for ν = 0, and its derivative for ν = 1."""
    z = x**2 / 4
    if whole(nu) == 0:
        return m.harmonic_series(z) - _log_part(x, m) * m.besseli(0, x)
    if whole(nu) == 1:
        slope = m.harmonic_slope(z) * x / 2
        return m.besseli(0, x) / x + _log_part(x, m) * m.besseli(1, x) - slope
    r = literal(nu)
    if r is None or r.q == 1:
        return None
    return m.pi / 2 * (m.besseli(-nu, x) - m.besseli(nu, x)) / m.sin(m.pi * nu)


def _small_y(nu: Any, x: Any, m: Any) -> Any:
    """DLMF 10.8.2 for ν = 0, and its derivative for ν = 1."""
    z = x**2 / 4
    if whole(nu) == 0:
        return 2 / m.pi * (_log_part(x, m) * m.besselj(0, x) - m.harmonic_series(-z))
    if whole(nu) == 1:
        slope = m.harmonic_slope(-z) * x / 2
        return -2 / m.pi * (m.besselj(0, x) / x - _log_part(x, m) * m.besselj(1, x) + slope)
    r = literal(nu)
    if r is None or r.q == 1:
        return None
    turn = m.pi * nu
    return (m.besselj(nu, x) * m.cos(turn) - m.besselj(-nu, x)) / m.sin(turn)


def _far(kind: str) -> Any:
    """DLMF 10.17.3, 10.17.4, 10.40.1, 10.40.2, for any real order."""

    def formula(nu: Any, x: Any, m: Any) -> Any:
        if kind == "k":
            return m.sqrt(m.pi / (2 * x)) * m.exp(-x) * m.besselk_tail(nu, 1 / x)
        if kind == "i":
            return m.exp(x) / m.sqrt(2 * m.pi * x) * m.besseli_tail(nu, 1 / x)
        p, q = m.bessel_p(nu, 1 / x), m.bessel_q(nu, 1 / x)
        turn = x - nu * m.pi / 2 - m.pi / 4
        first, second = (m.cos, m.sin) if kind == "j" else (m.sin, m.cos)
        return m.sqrt(2 / (m.pi * x)) * (
            p * first(turn) + (q if kind == "y" else -q) * second(turn)
        )

    return formula


def _bessel(kind: str, **facts: Any) -> Function:
    down, up = _recurrence(kind)
    return Function(
        name=_name(kind), family="Bessel functions", arity=2, derivatives=(None, _slope(kind)),
        rewritten=_values(kind), subscripted=True, recurrence=down, raising=up, base=2,
        latex=kind.upper(), mathml=kind.upper(), sympy=_name(kind),
        mathematica=f"Bessel{kind.upper()}", maple=f"Bessel{kind.upper()}",
        aliases=(f"Bessel{kind.upper()}",), **facts,
    )  # fmt: skip


def _i_rest(nu: arb, s: arb, n: int) -> arb:
    """Bound the remainder of w = √(2πx) e^(−x) I_ν(x), v = 1/x, on 0 < v ≤ s.

    w'' + 2w' = μ w/x² with μ = ν² − 1/4, and the error e of n terms, b_k = (−1)^k a_k(ν), satisfies
    e'' + 2e' = μ e/x² − 2n b_n/x^(n+1). With E = sup x^n |e| on x ≥ x₀ = 1/s, integrating e' from
    x₀ and e from infinity gives
    E ≤ |e'(x₀)| x₀^n/2 + (|μ| E/x₀ + 2n |b_n|)/(n (2 − (n+1)/x₀)), for x₀ > n + 1.
    """
    low = 1 / s
    if n < 1:
        return NAN
    if not low > n + 1:
        return NAN
    mu = nu * nu - fmpq(1, 4)
    root = (2 * arb.pi() * low).sqrt() * (-low).exp()
    value = low.bessel_i(nu)
    slope = (low.bessel_i(nu - 1) + low.bessel_i(nu + 1)) / 2
    rate = root * (slope - value + value / (2 * low))
    for k in range(n):
        rate += k * (-1) ** k * coefficient(nu, k) / low ** (k + 1)
    share = 1 / (n * (2 - (n + 1) / low))
    room = 1 - abs(mu) / low * share
    if not room > 0:
        return NAN
    return (abs(rate) * low**n / 2 + 2 * n * abs(arb(1) * coefficient(nu, n)) * share) / room


def _p_term(nu: Any, k: int) -> Any:
    return fmpq(0) if k % 2 else (-1) ** (k // 2) * coefficient(nu, k)


def _q_term(nu: Any, k: int) -> Any:
    return (-1) ** (k // 2) * coefficient(nu, k) if k % 2 else fmpq(0)


def _p_rest(nu: arb, s: arb, n: int) -> arb:
    k = n + n % 2
    return _rest(nu, s, k, 2, 2) * s ** (k - n)


def _q_rest(nu: arb, s: arb, n: int) -> arb:
    k = n + (n + 1) % 2
    return _rest(nu, s, k, 2, 3) * s ** (k - n)


def _modulus(which: str) -> Any:
    def exact(nu: arb, v: arb) -> arb:
        x = 1 / v
        turn = x - nu * arb.pi() / 2 - arb.pi() / 4
        j, y = x.bessel_j(nu), x.bessel_y(nu)
        front = (arb.pi() * x / 2).sqrt()
        if which == "p":
            return front * (j * turn.cos() + y * turn.sin())
        return front * (y * turn.cos() - j * turn.sin())

    return exact


def _k_exact(nu: arb, v: arb) -> arb:
    x = 1 / v
    return (2 * x / arb.pi()).sqrt() * x.exp() * x.bessel_k(nu)


def _i_exact(nu: arb, v: arb) -> arb:
    x = 1 / v
    return (2 * arb.pi() * x).sqrt() * (-x).exp() * x.bessel_i(nu)


def _rising(b: Any, k: int) -> Any:
    found = fmpq(1)
    for j in range(k):
        found = found * (b + j)
    return found


def _harmonic(k: int) -> fmpq:
    found = fmpq(0)
    for j in range(1, k + 1):
        found += fmpq(1, j)
    return found


def _harmonic_series(times: int) -> Any:
    """Σ H_k z^k/(k!)² and its derivative; H_k ≤ 2^k bounds the remainder."""

    def term(k: int) -> fmpq:
        n = k + times
        found = _harmonic(n) / factorial(n) ** 2
        return found * n if times else found

    def value(z: arb) -> arb:
        size = arb(abs(z).upper())
        n = 10
        while not arb(n * n) > 8 * size:
            n += 5
            if n > 400:
                return NAN
        n += 40  # the terms fall by a factor 4 from here on: the remainder is twice the next one
        total = arb(0)
        for k in reversed(range(n)):
            total = total * z + arb(term(k))
        return total + arb(0, 2) * arb(term(n)) * size**n

    return term, value


def _regular(name: str, times: int) -> Function:
    term, value = _harmonic_series(times)
    return Function(
        name=name, family="factors of expansions", latex="S'" if times else "S", derivatives=(
            (lambda z, m: m.harmonic_slope(z)) if times == 0 else None,), ball=value, entire=True,
        taylor=lambda k, m: term(k), internal=True, source="DLMF 10.31.2",
        remainder=lambda s, n: 2 * arb(term(n)) / (1 - s) if s < 1 else NAN,
    )  # fmt: skip


def _airy_jets(which: str) -> Any:
    def series(s: Any) -> Any:
        return getattr(s, which)()

    return series


def _zeta_of(x: Any, m: Any) -> Any:
    """ζ = (2/3) x^(3/2)."""
    return fmpq(2, 3) * x ** fmpq(3, 2) if isinstance(x, arb) else 2 * x * m.sqrt(x) / 3


THIRD = fmpq(1, 3)


def _third(x: Any) -> Any:
    return x * 0 + THIRD


def _airy(name: str, letter: str, **facts: Any) -> Function:
    return Function(
        name=name, family="Airy functions", latex=rf"\operatorname{{{letter}}}", sympy=name,
        mathematica=f"Airy{letter}", maple=f"Airy{letter}", **facts,
    )  # fmt: skip


def _ai_far(x: Any, m: Any) -> Any:
    return m.sqrt(x / 3) / m.pi * m.besselk(THIRD, _zeta_of(x, m))


def _bi_far(x: Any, m: Any) -> Any:
    z = _zeta_of(x, m)
    return m.sqrt(x / 3) * (m.besseli(THIRD, z) + m.besseli(-THIRD, z))


def _ai_left(x: Any, m: Any) -> Any:
    z = _zeta_of(-x, m)
    return m.sqrt(-x) / 3 * (m.besselj(THIRD, z) + m.besselj(-THIRD, z))


def _bi_left(x: Any, m: Any) -> Any:
    z = _zeta_of(-x, m)
    return m.sqrt(-x / 3) * (m.besselj(-THIRD, z) - m.besselj(THIRD, z))


def _at_zero(kind: str) -> Any:
    """Ai(0), Ai'(0), Bi(0), Bi'(0) (DLMF 9.2.3–9.2.6)."""

    def rule(x: Any, m: Any) -> Any:
        if literal(x) != 0:
            return None
        two = x * 0 + fmpq(2, 3)
        one = x * 0 + THIRD
        three = x * 0 + 3
        if kind == "ai":
            return 1 / (three ** fmpq(2, 3) * m.gamma(two))
        if kind == "bi":
            return 1 / (three ** fmpq(1, 6) * m.gamma(two))
        if kind == "aiprime":
            return -1 / (three**THIRD * m.gamma(one))
        return three ** fmpq(1, 6) / m.gamma(one)

    return rule


BESSEL = (
    _bessel(
        "j", definition=r"J_\nu(x) = \sum_k \frac{(-1)^k (x/2)^{2k+\nu}}{k!\,\Gamma(k+\nu+1)}",
        source="DLMF 10.2.2", needs=_integer_or_positive, ball=_ball_j, mirror=_parity("j"),
        holomorphic=_cylinder("bessel_j"),
        taylor=_taylor(-1), near_needs=_not_minus_one, near={"oo": _far("j"), "0+": _small(-1)},
        theorems=("DLMF 10.17(iii): bounds of the remainders of P and Q",),
        falsehoods=("besselj(0, x) <= 9/10", "diff(besselj(0, x), x) == besselj(1, x)"),
    ),
    _bessel(
        "y", definition=r"Y_\nu(x) = \frac{J_\nu(x)\cos\nu\pi - J_{-\nu}(x)}{\sin\nu\pi},\ x > 0",
        source="DLMF 10.2.3", needs=_positive, ball=_ball_y,
        holomorphic=on_the_right(lambda nu, z: z.bessel_y(nu)),
        near={"oo": _far("y"), "0+": _small_y},
        theorems=("DLMF 10.17(iii): bounds of the remainders of P and Q",),
        falsehoods=("bessely(0, x) <= 1/2 given x > 0",
                    "diff(bessely(0, x), x) == bessely(1, x)"),
    ),
    _bessel(
        "i", definition=r"I_\nu(x) = \sum_k \frac{(x/2)^{2k+\nu}}{k!\,\Gamma(k+\nu+1)}",
        source="DLMF 10.25.2", needs=_integer_or_positive, ball=_ball_i, mirror=_parity("i"),
        holomorphic=_cylinder("bessel_i"),
        taylor=_taylor(1), near_needs=_not_minus_one, near={"oo": _far("i"), "0+": _small(1)},
        positive_where=lambda nu, x, m: x if (literal(nu) or fmpq(-1)) >= 0 or literal(nu) == 0
        else -1 + 0 * x,
        falsehoods=("besseli(0, x) <= cosh(x/2)", "diff(besseli(0, x), x) == -besseli(1, x)"),
    ),
    _bessel(
        "k", definition=r"K_\nu(x) = \int_0^\infty e^{-x \cosh t} \cosh \nu t\,dt,\ x > 0",
        source="DLMF 10.32.9", needs=_positive, ball=_ball_k,
        holomorphic=on_the_right(lambda nu, z: z.bessel_k(nu)),
        range=Interval(fmpq(0), None, True), near={"oo": _far("k"), "0+": _small_k},
        theorems=("DLMF 10.40(iii): the expansion is enveloping from the term |ν| − 1/2 on",),
        falsehoods=("besselk(0, x) <= exp(-x) given x > 0",
                    "diff(besselk(0, x), x) == besselk(1, x)"),
    ),
    parametric("besselk_tail", coefficient, _k_exact, _rest, "DLMF 10.40.2 and 10.40(iii)"),
    parametric("besseli_tail", lambda nu, k: (-1) ** k * coefficient(nu, k), _i_exact, _i_rest,
            "DLMF 10.40.1, the bound by its differential equation"),
    parametric("bessel_p", _p_term, _modulus("p"), _p_rest, "DLMF 10.17.3 and 10.17(iii)"),
    parametric("bessel_q", _q_term, _modulus("q"), _q_rest, "DLMF 10.17.3 and 10.17(iii)"),
    Function(
        name="hyp0f1", family="Bessel functions", arity=2, internal=True, source="DLMF 16.2.1",
        latex=r"{}_0F_1",
        definition=r"{}_0F_1(; b; z) = \sum_k z^k/(k!\,(b)_k)",
        derivatives=(None, lambda b, z, m: m.hyp0f1(b + 1, z) / b), entire=True,
        ball=lambda b, z: z.hypgeom_0f1(b),
        taylor=lambda b, k, m: fmpq(1, factorial(k)) / _rising(b, k),
    ),
    _regular("harmonic_series", 0),
    _regular("harmonic_slope", 1),
    _airy(
        "airyai", "Ai", definition=r"\operatorname{Ai}'' = x \operatorname{Ai}", source="DLMF 9.2",
        derivatives=(lambda x, m: m.airyaiprime(x),), entire=True, positive_where=lambda x, m: x,
        ball=with_slope(lambda x: x.airy_ai(), lambda x: x.airy_ai(derivative=1)),
        series=_airy_jets("airy_ai"), holomorphic=lambda z: acb(z).airy_ai(),
        rewritten=_at_zero("ai"), aliases=("AiryAi",),
        near={"oo": _ai_far, "-oo": _ai_left},
        falsehoods=("airyai(x) <= 1/2", "diff(airyai(x), x, 2) == -x*airyai(x)"),
    ),
    _airy(
        "airyaiprime", "Ai'", definition=r"\operatorname{Ai}'(x)", source="DLMF 9.2",
        derivatives=(lambda x, m: x * m.airyai(x),), entire=True,
        ball=with_slope(lambda x: x.airy_ai(derivative=1), lambda x: x * x.airy_ai()),
        series=_airy_jets("airy_ai_prime"), holomorphic=lambda z: acb(z).airy_ai(derivative=1),
        rewritten=_at_zero("aiprime"),
        falsehoods=("airyaiprime(x) < 0", "diff(airyaiprime(x), x) == airyai(x)"),
    ),
    _airy(
        "airybi", "Bi", definition=r"\operatorname{Bi}'' = x \operatorname{Bi}", source="DLMF 9.2",
        derivatives=(lambda x, m: m.airybiprime(x),), entire=True, positive_where=lambda x, m: x,
        ball=with_slope(lambda x: x.airy_bi(), lambda x: x.airy_bi(derivative=1)),
        series=_airy_jets("airy_bi"), holomorphic=lambda z: acb(z).airy_bi(),
        rewritten=_at_zero("bi"), aliases=("AiryBi",),
        near={"oo": _bi_far, "-oo": _bi_left},
        falsehoods=("airybi(x) >= 0", "diff(airybi(x), x, 2) == -x*airybi(x)"),
    ),
    _airy(
        "airybiprime", "Bi'", definition=r"\operatorname{Bi}'(x)", source="DLMF 9.2",
        derivatives=(lambda x, m: x * m.airybi(x),), entire=True, positive_where=lambda x, m: x,
        ball=with_slope(lambda x: x.airy_bi(derivative=1), lambda x: x * x.airy_bi()),
        series=_airy_jets("airy_bi_prime"), holomorphic=lambda z: acb(z).airy_bi(derivative=1),
        rewritten=_at_zero("biprime"),
        falsehoods=("airybiprime(x) > 0", "diff(airybiprime(x), x) == airybi(x)"),
    ),
)  # fmt: skip
