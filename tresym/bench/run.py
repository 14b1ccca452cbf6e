"""One interleaved run: every contender once a round, in turning order; medians, ratios, spread.

The rounds are interleaved so that what the machine does meanwhile falls on all contenders alike;
only ratios within one run are worth quoting.
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
    """What one contender took: seconds per piece of work over all rounds."""

    name: str
    median: float
    low: float
    high: float
    digits: int | None

    def as_json(self, reference: float) -> dict[str, Any]:
        """The timing as JSON; ``ratio`` is by the median ``reference``."""
        return {
            "name": self.name,
            "seconds": self.median,
            "quartiles": [self.low, self.high],
            "digits": self.digits,
            "ratio": self.median / reference,
        }


class Measurement(NamedTuple):
    """A workload's timings; ratios are by the contender ``reference``."""

    workload: str
    says: str
    rounds: int
    timings: list[Timing]
    reference: str

    def as_json(self) -> dict[str, Any]:
        """All of it, with the versions it was measured with."""
        base = next(t.median for t in self.timings if t.name == self.reference)
        return {
            "workload": self.workload,
            "says": self.says,
            "rounds": self.rounds,
            "reference": self.reference,
            "timings": [t.as_json(base) for t in self.timings],
            "versions": versions(),
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
    return [_timing(c, samples[c.name]) for c in order]


def _timing(contender: Contender, seconds: list[float]) -> Timing:
    low, median, high = statistics.quantiles(seconds, n=4, method="inclusive")
    return Timing(contender.name, median, low, high, contender.digits)


def versions() -> dict[str, str]:
    """Python and the libraries that the timings depend on."""
    found = {"python": platform.python_version(), "machine": platform.machine()}
    for name in ("python-flint", "mpmath", "gmpy2", "numpy", "sympy"):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found
