"""Special functions by mpmath, to compare with."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


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
