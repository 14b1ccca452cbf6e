"""Benchmark of values to 50 digits: integrals, roots and special functions, against mpmath.

The other methods are what a user of mpmath would write: ``quad`` over the integrand, ``findroot``
between the ends, and the function itself. Their digits are counted against a ball of 100 digits;
ours are proved.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

from tresym.accuracy.values import certified, read
from tresym.dev.bench.run import Contender, Pace, Timing, Workload, row
from tresym.dev.bench.truth import by_digits
from tresym.reals.numbers.arithmetic import mp_precision

DIGITS = 50
OURS = "tresym, certified"


class Scene(NamedTuple):
    """An expression, and the same for mpmath."""

    kind: str
    text: str
    by_mpmath: Callable[[Any], Any]


SCENES = (
    Scene("integral", "integral(1/sqrt(1 - sin(t)**2/4), t, 0, pi/2)",
          lambda m: m.quad(lambda t: 1 / m.sqrt(1 - m.sin(t) ** 2 / 4), [0, m.pi / 2])),
    Scene("integral", "integral(exp(-3*t)/(1 + t), t, 0, oo)",
          lambda m: m.quad(lambda t: m.exp(-3 * t) / (1 + t), [0, m.inf])),
    Scene("integral", "integral(exp(-t**2)*cos(t), t, -oo, oo)",
          lambda m: m.quad(lambda t: m.exp(-(t**2)) * m.cos(t), [-m.inf, m.inf])),
    Scene("integral", "integral(1/sqrt(t*(1 - t)), t, 0, 1)",
          lambda m: m.quad(lambda t: 1 / m.sqrt(t * (1 - t)), [0, 1])),
    Scene("integral", "integral(1/(1 + t**3), t, 0, oo)",
          lambda m: m.quad(lambda t: 1 / (1 + t**3), [0, m.inf])),
    Scene("integral", "integral(t/(exp(t) - 1), t, 0, oo)",
          lambda m: m.quad(lambda t: t / (m.exp(t) - 1), [0, m.inf])),
    Scene("integral", "integral(exp(-cosh(t)), t, 0, oo)",
          lambda m: m.quad(lambda t: m.exp(-m.cosh(t)), [0, m.inf])),
    Scene("integral", "integral(1/sqrt(cos(t) - cos(2)), t, 0, 2)",
          lambda m: m.quad(lambda t: 1 / m.sqrt(m.cos(t) - m.cos(2)), [0, 2])),
    Scene("integral", "integral(log(t)/(1 + t), t, 0, 1)",
          lambda m: m.quad(lambda t: m.log(t) / (1 + t), [0, 1])),
    Scene("root", "root(y - sin(y)/2 - 1, y, 0, 3)",
          lambda m: m.findroot(lambda y: y - m.sin(y) / 2 - 1, (0, 3), solver="anderson")),
    Scene("root", "root(y*exp(y) - 3, y, 0, 3)",
          lambda m: m.findroot(lambda y: y * m.exp(y) - 3, (0, 3), solver="anderson")),
    Scene("root", "root(y**5 + y - 3, y, 0, 2)",
          lambda m: m.findroot(lambda y: y**5 + y - 3, (0, 2), solver="anderson")),
    Scene("root", "root(cos(y) - y, y, 0, 1)",
          lambda m: m.findroot(lambda y: m.cos(y) - y, (0, 1), solver="anderson")),
    Scene("function", "loggamma(17/5)", lambda m: m.loggamma(m.mpf(17) / 5)),
    Scene("function", "erfc(3/2)", lambda m: m.erfc(m.mpf(3) / 2)),
    Scene("function", "besselj(0, 5/2)", lambda m: m.besselj(0, m.mpf(5) / 2)),
    Scene("function", "zeta(7/2)", lambda m: m.zeta(m.mpf(7) / 2)),
    Scene("function", "E1(4/3)", lambda m: m.e1(m.mpf(4) / 3)),
    Scene("function", "elliptic_k(1/3)", lambda m: m.ellipk(m.mpf(1) / 3)),
    Scene("function", "lambertw(5)", lambda m: m.lambertw(5)),
    Scene("function", "airyai(2)", lambda m: m.airyai(2)),
)  # fmt: skip


def _by_mpmath(scene: Scene) -> Any:
    with mp_precision(DIGITS) as mp:
        return mp.mpf(scene.by_mpmath(mp).real)


def contenders(_: Any) -> Iterator[Contender]:
    """Yield both methods for every scene."""
    for scene in SCENES:
        e = read(scene.text)
        judge = by_digits(certified(e, 2 * DIGITS), DIGITS)
        works = {
            OURS: partial(certified, e, DIGITS),
            "mpmath": partial(_by_mpmath, scene),
        }
        yield from row(scene.text, works, judge, asked=DIGITS)


def notes(timings: list[Timing], _: Any) -> dict[str, Any]:
    """Return for each kind the median factor by which mpmath is slower, and its wrong results."""
    kinds = {scene.text: scene.kind for scene in SCENES}
    seconds: dict[str, dict[str, float]] = {}
    wrong: dict[str, int] = {}
    for timing in timings:
        if timing.seconds:
            seconds.setdefault(timing.contender.scene, {})[timing.contender.method] = (
                timing.quartiles[1]
            )
        if timing.judged.outcome != "right":
            kind = kinds[timing.contender.scene]
            wrong[kind] = wrong.get(kind, 0) + 1
    found: dict[str, Any] = {}
    for kind in dict.fromkeys(kinds.values()):
        ratios = sorted(
            both["mpmath"] / both[OURS]
            for scene, both in seconds.items()
            if kinds[scene] == kind and {"mpmath", OURS} <= both.keys()
        )
        if ratios:
            found[kind] = {
                "median": ratios[len(ratios) // 2],
                "least": ratios[0],
                "most": ratios[-1],
                "wrong": wrong.get(kind, 0),
            }
    return {"factors": found}


WORKLOAD = Workload(contenders, Pace(rounds=9, patience=0.5), OURS, notes=notes)
