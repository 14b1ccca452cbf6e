"""One interleaved run: every contender once a round, in turning order; medians, ratios, spread.

The rounds are interleaved so that what the machine does meanwhile falls on all contenders alike.
Only ratios within one run are worth quoting; they are taken round by round.
"""

from __future__ import annotations

import platform
import statistics
from collections.abc import Callable, Iterable
from importlib.metadata import PackageNotFoundError, version
from typing import Any, NamedTuple


class Contender(NamedTuple):
    """One way of doing the work: ``sample`` does it once or often and returns seconds each."""

    name: str
    sample: Callable[[], float]
    digits: int | None = None


class Timing(NamedTuple):
    """What one contender took: seconds per piece of work, one entry a round."""

    name: str
    seconds: list[float]
    digits: int | None

    @property
    def quartiles(self) -> tuple[float, float, float]:
        """Lower quartile, median, upper quartile in seconds."""
        low, median, high = statistics.quantiles(self.seconds, n=4, method="inclusive")
        return low, median, high

    def ratio(self, reference: Timing) -> float:
        """The median over the rounds of this contender's time by the reference's in that round."""
        pairs = zip(self.seconds, reference.seconds, strict=True)
        return statistics.median(mine / other for mine, other in pairs)


class Measurement(NamedTuple):
    """A workload's timings; ratios are by the contender ``reference``."""

    workload: str
    says: str
    rounds: int
    timings: list[Timing]
    reference: str

    @property
    def base(self) -> Timing:
        """The timing that ratios are by."""
        return next(t for t in self.timings if t.name == self.reference)

    def as_json(self) -> dict[str, Any]:
        """All of it, with the versions it was measured with."""
        return {
            "workload": self.workload,
            "says": self.says,
            "rounds": self.rounds,
            "reference": self.reference,
            "timings": [self._timing_json(t) for t in self.timings],
            "versions": versions(),
        }

    def _timing_json(self, timing: Timing) -> dict[str, Any]:
        low, median, high = timing.quartiles
        return {
            "name": timing.name,
            "seconds": median,
            "quartiles": [low, high],
            "ratio": timing.ratio(self.base),
            "digits": timing.digits,
        }


def interleave(contenders: Iterable[Contender], rounds: int) -> list[Timing]:
    """Sample every contender once a round, starting one further each round."""
    order = list(contenders)
    samples: dict[str, list[float]] = {c.name: [] for c in order}
    for contender in order:
        contender.sample()
    for i in range(rounds):
        turn = i % len(order)
        for contender in order[turn:] + order[:turn]:
            samples[contender.name].append(contender.sample())
    return [Timing(c.name, samples[c.name], c.digits) for c in order]


def versions() -> dict[str, str]:
    """Python and the libraries that the timings depend on."""
    found = {"python": platform.python_version(), "machine": platform.machine()}
    for name in ("python-flint", "mpmath", "gmpy2", "numpy", "sympy"):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found
