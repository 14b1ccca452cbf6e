"""Measure methods in interleaved rounds, and report medians, ratios and spread.

In each round every method is sampled once, so that other load on the machine affects all of them
equally. Only ratios within one run are worth quoting; they are formed round by round, relative to
one method of the same scene. A method that is wrong, fails or takes too long stays in the data,
with the reason.
"""

from __future__ import annotations

import math
import os
import platform
import statistics
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, NamedTuple, Protocol

from tresym.reals.resource_limits import TimeUp, time_limit

SAMPLE_SECONDS = 0.004
"""The duration of a sample in seconds; fast work is repeated until it takes this long."""

PACKAGES = ("python-flint", "mpmath", "gmpy2", "numpy", "scipy", "heyoka", "sympy")

RIGHT, WRONG, TIMED_OUT, FAILED = OUTCOMES = ("right", "wrong", "timed out", "failed")


class TooSlowError(Exception):
    """Raised for work that is skipped because a smaller amount of it was too slow."""


class Rising:
    """A method at increasing sizes; once it is too slow, larger sizes are skipped."""

    def __init__(self) -> None:
        """Start with no size that was too slow."""
        self.slow: float | None = None

    def work(self, run: Callable[[Any], Any], size: Any) -> Callable[[], Any]:
        """Return ``run(size)`` as the work of a contender."""

        def once() -> Any:
            if self.slow is not None and size > self.slow:
                raise TooSlowError(f"too slow at {self.slow:g} already")
            try:
                return run(size)
            except TimeUp:
                self.slow = size
                raise

        return once


class Judged(NamedTuple):
    """The assessment of a result: its correct digits, the digits it claims, the outcome and why.

    ``digits`` and ``claimed`` are None if no number was asked for.
    """

    digits: float | None = None
    claimed: float | None = None
    outcome: str = RIGHT
    why: str = ""


Judge = Callable[[Any], Judged]


@dataclass(frozen=True)
class Contender:
    """One method for the work of a scene.

    ``work`` does it once, and ``judge`` assesses its value. ``sample`` returns the seconds for one
    piece, by default the processor time of ``work``; if it is ``work`` itself, the first run counts
    as a sample too. ``pieces`` is the number of results of one call. ``pace`` replaces the pace of
    the workload.
    """

    scene: str
    method: str
    work: Callable[[], Any]
    judge: Judge = lambda _: Judged()
    ours: bool = False
    asked: float | None = None
    sample: Callable[[], float] | None = None
    pieces: int = 1
    pace: Pace | None = None


def row(
    scene: str,
    works: Mapping[str, Callable[[], Any]],
    judge: Judge = lambda _: Judged(),
    **more: Any,
) -> Iterator[Contender]:
    """Yield the contenders of a scene by name; names of our methods begin with tresym or our."""
    for name, work in works.items():
        yield Contender(scene, name, work, judge, name.startswith(("tresym", "our")), **more)


@dataclass
class Timing:
    """The times of one contender: seconds per piece, one entry for each round it took part in."""

    contender: Contender
    judged: Judged
    seconds: list[float] = field(default_factory=list)

    @property
    def quartiles(self) -> tuple[float, float, float]:
        """Return the lower quartile, the median and the upper quartile in seconds."""
        if len(self.seconds) == 1:
            return (self.seconds[0],) * 3
        low, median, high = statistics.quantiles(self.seconds, n=4, method="inclusive")
        return low, median, high

    def ratio(self, reference: Timing) -> float | None:
        """Return the median over the rounds of this time divided by that of the reference."""
        pairs = list(zip(self.seconds, reference.seconds, strict=False))
        return statistics.median(mine / other for mine, other in pairs) if pairs else None

    def as_json(self, reference: Timing | None) -> dict[str, Any]:
        """Return one row of the saved data; ``seconds`` is None if nothing was timed."""
        who, judged = self.contender, self.judged
        timed: dict[str, Any] = {"seconds": None, "quartiles": None, "samples": 0, "ratio": None}
        if self.seconds:
            low, median, high = map(_short, self.quartiles)
            ratio = None if reference is None else self.ratio(reference)
            timed = {
                "seconds": median,
                "quartiles": [low, high],
                "samples": len(self.seconds),
                "ratio": None if ratio is None else _short(ratio),
            }
        return {
            "scene": who.scene,
            "method": who.method,
            "ours": who.ours,
            "asked": who.asked,
            "digits": None if judged.digits is None else round(judged.digits, 1),
            "claimed": None if judged.claimed is None else round(judged.claimed, 1),
            "outcome": judged.outcome,
            "why": judged.why,
            **timed,
        }


Tables = dict[str, Any]
"""Results of a workload other than times, by name: lists of rows, or a dictionary."""


@dataclass
class Measurement:
    """The timings of a workload; ratios in a scene are relative to the method ``reference``.

    ``notes`` are results other than times, such as counts, and ``tables`` lists of rows by name;
    ``complete`` is False if the run was interrupted.
    """

    workload: str
    says: str
    timings: list[Timing]
    reference: str = ""
    clock: str = "processor time"
    notes: dict[str, Any] = field(default_factory=dict)
    tables: Tables = field(default_factory=dict)
    complete: bool = True

    def base(self, scene: str) -> Timing | None:
        """Return the timing relative to which the ratios of a scene are formed."""
        for timing in self.timings:
            who = timing.contender
            if who.scene == scene and who.method == self.reference and timing.seconds:
                return timing
        return None

    def as_json(self) -> dict[str, Any]:
        """Return the measurement as JSON data, with the machine and the versions."""
        return {
            "workload": self.workload,
            "says": self.says,
            "complete": self.complete,
            "clock": self.clock,
            "reference": self.reference,
            "machine": machine(),
            "versions": versions(),
            **({"notes": self.notes} if self.notes else {}),
            "rows": [t.as_json(self.base(t.contender.scene)) for t in self.timings],
            **self.tables,
        }


class Pace(NamedTuple):
    """How long to measure: the number of rounds, and processor seconds for each contender.

    A first run that takes ``limit`` seconds is timed out; one that takes more than ``patience`` is
    the only sample.
    """

    rounds: int = 7
    limit: float = 10.0
    patience: float = 1.0


PACE = Pace()


class Keep(Protocol):
    """Called after each sample with everything measured so far, timings or tables."""

    def __call__(self, timings: list[Timing], tables: Tables | None = None) -> None:
        """Save the measurement so far."""


def forget(timings: list[Timing], tables: Tables | None = None) -> None:
    """Save nothing."""


@dataclass(frozen=True)
class Workload:
    """Contenders to be measured; resources that they have opened stay open until all are timed.

    ``tables`` yields rows other than times after the timing, each with the name of its table, and
    ``notes`` is computed from both. ``reference`` and ``clock`` are as in :class:`Measurement`.
    """

    contenders: Callable[[ExitStack], Iterable[Contender]] = lambda _: ()
    pace: Pace = PACE
    reference: str = ""
    clock: str = "processor time"
    tables: Callable[[list[Timing]], Iterable[tuple[str, Any]]] = lambda _: ()
    notes: Callable[[list[Timing], Tables], dict[str, Any]] = lambda *_: {}

    def measure(
        self, name: str, says: str, keep: Keep = forget, pace: Pace | None = None
    ) -> Measurement:
        """Run the workload, at its own pace unless another one is given."""
        tables: Tables = {}
        notes: dict[str, Any] = {}
        with ExitStack() as opened:
            timings, complete = interleave(self.contenders(opened), pace or self.pace, keep)
            try:
                for title, found in self.tables(timings) if complete else ():
                    tables.setdefault(title, []).append(found)
                    keep(timings, tables)
                notes = self.notes(timings, tables) if complete else {}
            except KeyboardInterrupt:
                complete = False
        return Measurement(name, says, timings, self.reference, self.clock, notes, tables, complete)


def interleave(
    contenders: Iterable[Contender], pace: Pace = PACE, keep: Keep = forget
) -> tuple[list[Timing], bool]:
    """Run and judge every contender once, then sample each once per round, in rotating order.

    Returns:
        The timings, and whether the run was completed; an interrupt ends it with the data so far.
    """
    timings: list[Timing] = []
    waiting: list[tuple[Timing, int]] = []
    try:
        for contender in contenders:
            timing, rounds = _first(contender, contender.pace or pace)
            timings.append(timing)
            waiting.append((timing, rounds))
            keep(timings)
        for i in range(max([rounds for _, rounds in waiting], default=0)):
            turn = i % max(1, len(waiting))
            for timing, rounds in waiting[turn:] + waiting[:turn]:
                if i < rounds and timing.judged.outcome in (RIGHT, WRONG):
                    _add_sample(timing)
                    keep(timings)
    except KeyboardInterrupt:
        return timings, False
    return timings, True


def _first(contender: Contender, pace: Pace) -> tuple[Timing, int]:
    """The first run with its assessment, and how many rounds the contender is sampled."""
    start, used = time.perf_counter(), time.process_time()
    try:
        with time_limit(pace.limit):
            value = contender.work()
    except TooSlowError as error:
        return Timing(contender, Judged(outcome=TIMED_OUT, why=str(error))), 0
    except TimeUp:
        why = f"more than {pace.limit:g} s of processor time"
        return Timing(contender, Judged(outcome=TIMED_OUT, why=why)), 0
    except Exception as error:
        return Timing(contender, Judged(outcome=FAILED, why=reason(error))), 0
    took, used = time.perf_counter() - start, time.process_time() - used
    timing = Timing(contender, contender.judge(value))
    if contender.sample is contender.work:
        timing.seconds.append(value)
    if took > pace.patience and contender.sample is None:
        timing.seconds.append(used / contender.pieces)
        return timing, 0
    rounds = min(pace.rounds, int(pace.patience / max(took, 1e-9)))
    return timing, rounds if timing.seconds else max(1, rounds)


def tally(
    timings: list[Timing],
    reference: str,
    limit: float,
    counted: str,
    named: Callable[[Contender], str] = lambda who: who.method,
) -> dict[str, dict[str, Any]]:
    """Count outcomes by name, with the geometric mean of the ratios.

    Args:
        timings: the timings.
        reference: the method relative to which ratios are formed, in the same scene.
        limit: the seconds that count for a method that timed out; its mean is then a lower bound.
        counted: the key of the number of timings in the result.
        named: returns the name under which a contender is counted.
    """
    by = {t.contender.scene: t for t in timings if t.contender.method == reference}
    found: dict[str, dict[str, Any]] = {}
    for name in dict.fromkeys(named(t.contender) for t in timings):
        some = [t for t in timings if named(t.contender) == name]
        ratios = [
            limit / other.quartiles[1] if t.judged.outcome == TIMED_OUT else t.ratio(other) or 0.0
            for t in some
            if (other := by[t.contender.scene]).seconds
        ]
        logs = [math.log(r) for r in ratios if r > 0]
        mean = float(f"{math.exp(statistics.fmean(logs)):.3g}") if logs else None
        outcomes = Counter(t.judged.outcome for t in some)
        found[name] = {counted: len(some), **outcomes, "ratio": mean}
    return found


def reason(error: Exception) -> str:
    """Return an exception as one line of at most 160 characters."""
    text = " ".join(str(error).split())
    line = f"{type(error).__name__}: {text}" if text else type(error).__name__
    return line if len(line) <= 160 else line[:157] + "..."


def _add_sample(timing: Timing) -> None:
    """Take one more sample; a contender that fails now is removed, with the reason."""
    who = timing.contender
    try:
        seconds = who.sample() if who.sample else time_once(who.work) / who.pieces
    except Exception as error:
        timing.judged = timing.judged._replace(outcome=FAILED, why=reason(error))
        return
    timing.seconds.append(seconds)


def time_once(work: Callable[[], Any], seconds: float = SAMPLE_SECONDS) -> float:
    """Return the processor seconds of one call, averaged over calls that fill ``seconds``.

    Processor time is used, since other programs do not affect it.
    """
    calls = 1
    while True:
        start = time.process_time()
        for _ in range(calls):
            work()
        elapsed = time.process_time() - start
        if elapsed >= seconds:
            return elapsed / calls
        calls *= 4


def versions() -> dict[str, str]:
    """Return the versions of Python and of the libraries that affect the timings."""
    found = {"python": platform.python_version()}
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found


def machine() -> dict[str, Any]:
    """Return the name of the processor, and the number of cores that this process may use."""
    return {
        "processor": _processor(),
        "cores": len(os.sched_getaffinity(0))
        if hasattr(os, "sched_getaffinity")
        else os.cpu_count(),
        "system": platform.system(),
    }


def _processor() -> str:
    with_names = Path("/proc/cpuinfo")
    if with_names.is_file():
        for line in with_names.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return f"{line.partition(':')[2].strip()} ({platform.machine()})"
    return platform.processor() or platform.machine()


def _short(x: float) -> float:
    return float(f"{x:.4g}")
