"""Expressions and claims by mpmath alone, to compare with."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from typing import Any

from tresym.reals.language.expression import Expr, opened, symbols
from tresym.reals.language.parsing import parse_claim, parse_given
from tresym.reals.numbers.arithmetic import mp_precision

DIGITS, POINTS, TRIED = 40, 8, 400


def _polygamma(m: Any, n: Any, x: Any) -> Any:
    return m.polygamma(int(n), x)


IN_MPMATH: dict[str, Callable[..., Any]] = {
    "gamma": lambda m, x: m.gamma(x),
    "rgamma": lambda m, x: m.rgamma(x),
    "loggamma": lambda m, x: m.loggamma(x),
    "digamma": lambda m, x: m.digamma(x),
    "polygamma": _polygamma,
    "uppergamma": lambda m, s, x: m.gammainc(s, x),
    "lowergamma": lambda m, s, x: m.gammainc(s, 0, x),
    "erf": lambda m, x: m.erf(x),
    "erfc": lambda m, x: m.erfc(x),
    "erfi": lambda m, x: m.erfi(x),
    "dawson": lambda m, x: m.sqrt(m.pi) / 2 * m.exp(-x * x) * m.erfi(x),
    "fresnels": lambda m, x: m.fresnels(x),
    "fresnelc": lambda m, x: m.fresnelc(x),
    "expint": lambda m, n, x: m.expint(n, x),
    "Ei": lambda m, x: m.ei(x),
    "li": lambda m, x: m.li(x),
    "Si": lambda m, x: m.si(x),
    "Ci": lambda m, x: m.ci(x),
    "besselj": lambda m, n, x: m.besselj(n, x),
    "bessely": lambda m, n, x: m.bessely(n, x),
    "besseli": lambda m, n, x: m.besseli(n, x),
    "besselk": lambda m, n, x: m.besselk(n, x),
    "airyai": lambda m, x: m.airyai(x),
    "airyaiprime": lambda m, x: m.airyai(x, derivative=1),
    "airybi": lambda m, x: m.airybi(x),
    "airybiprime": lambda m, x: m.airybi(x, derivative=1),
    "elliptic_k": lambda m, x: m.ellipk(x),
    "elliptic_e": lambda m, x: m.ellipe(x),
    "elliptic_f": lambda m, t, x: m.ellipf(t, x),
    "elliptic_e_inc": lambda m, t, x: m.ellipe(t, x),
    "elliptic_pi": lambda m, n, x: m.ellippi(n, x),
    "zeta": lambda m, x: m.zeta(x),
    "zetaderiv": lambda m, n, x: m.zeta(x, derivative=int(n)),
    "polylog": lambda m, s, x: m.polylog(s, x),
    "lambertw": lambda m, x: m.lambertw(x).real,
    "lambertwm1": lambda m, x: m.lambertw(x, -1).real,
    "EulerGamma": lambda m, _: m.euler,
    "Catalan": lambda m, _: m.catalan,
}

HOLDS: dict[str, Any] = {
    "==": lambda x, y, tiny: abs(x - y) <= tiny * (1 + abs(x)),
    "<": lambda x, y, tiny: x < y,
    "<=": lambda x, y, tiny: x <= y + tiny,
    ">": lambda x, y, tiny: x > y,
    ">=": lambda x, y, tiny: x >= y - tiny,
    "!=": lambda x, y, tiny: x != y,
}


def value(m: Any, e: Expr, at: Mapping[str, Any]) -> Any:
    """The value of a tree by mpmath alone, with derivatives as limits of differences."""
    args = e.args
    if e.op == "number":
        return m.mpf(int(args[0].p)) / int(args[0].q)
    if e.op == "symbol":
        return at[args[0]]
    if e.op == "pi":
        return +m.pi
    if e.op == "derivative":
        (name,), body = opened(e)
        return m.diff(lambda t: value(m, body, {**at, name: t}), value(m, args[1], at))
    values = [value(m, arg, at) for arg in args]
    if e.op == "+":
        return m.fsum(values)
    if e.op == "*":
        return m.fprod(values)
    if e.op == "^":
        return values[0] ** values[1]
    if e.op in IN_MPMATH:
        return IN_MPMATH[e.op](m, *values)
    return getattr(m, "fabs" if e.op == "abs" else "ln" if e.op == "log" else e.op)(*values)


def is_true_at_points(claim: str, tried: int = TRIED) -> bool:
    """Whether mpmath finds the claim true at random points that satisfy its conditions."""
    text, _, conditions = claim.partition(" given ")
    (relation,) = parse_claim(text)
    given = list(parse_given(conditions)) if conditions else []
    left, sign, right = relation
    names = sorted(symbols(left) | symbols(right))
    chance, seen = random.Random(claim), 0
    with mp_precision(DIGITS) as m:
        tiny = m.mpf(10) ** -18 if "diff" in claim else m.mpf(10) ** (6 - DIGITS)
        for _ in range(tried if names else 1):
            scale = chance.choice((0.3, 1, 3, 9))
            at = {name: m.mpf(chance.uniform(-1, 1)) * scale for name in names}
            try:
                if not all(HOLDS[r](value(m, x, at), value(m, y, at), 0) for x, r, y in given):
                    continue
                x, y = value(m, left, at), value(m, right, at)
                if any(at[name] * m.e < -1 for name in names if "lambertw" in claim):
                    continue
                if abs(m.im(x)) + abs(m.im(y)) > 0 or not m.isfinite(m.re(x) + m.re(y)):
                    continue
                if not HOLDS[sign](m.re(x), m.re(y), tiny):
                    return False
            except (ValueError, ZeroDivisionError, OverflowError, TypeError, m.NoConvergence):
                continue
            seen += 1
            if seen == POINTS and sign == "==":
                break
    assert seen, claim
    return True
