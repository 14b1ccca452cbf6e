"""Run contenders in interleaved rounds, and report medians, ratios and spread.

The rounds are interleaved so that what the machine does meanwhile falls on all contenders alike.
Only ratios within one run are worth quoting; they are taken round by round, against one method of
the same scene. A contender that is wrong, fails or takes too long stays in the data, and why.
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
"""A sample of quick work is as many calls as take this long."""

PACKAGES = ("python-flint", "mpmath", "gmpy2", "numpy", "scipy", "numba", "heyoka", "sympy")

RIGHT, WRONG, TIMED_OUT, FAILED = OUTCOMES = ("right", "wrong", "timed out", "failed")


class TooSlowError(Exception):
    """Raised by work that is not tried, as less of the same kind was too slow already."""


class Rising:
    """One method at rising sizes: after one at which it was too slow the next are not tried."""

    def __init__(self) -> None:
        """Nothing was too slow yet."""
        self.slow: float | None = None

    def work(self, run: Callable[[Any], Any], size: Any) -> Callable[[], Any]:
        """``run(size)`` as the work of a contender."""

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
    """What an answer is worth: its true digits, those it claims itself, the outcome and why.

    ``digits`` and ``claimed`` are None where no number was asked for.
    """

    digits: float | None = None
    claimed: float | None = None
    outcome: str = RIGHT
    why: str = ""


Judge = Callable[[Any], Judged]


@dataclass(frozen=True)
class Contender:
    """One way of doing the work of a scene.

    ``work`` does it once and its value is put to ``judge``; ``sample`` returns seconds for one
    piece, by default the processor time of ``work``; where it is ``work`` itself, the first run is
    a sample too. ``pieces`` is how many answers one call gives, ``pace`` its own where the
    workload's does not suit it.
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
    """The contenders of a scene by their names, of which ours begin with tresym or our."""
    for name, work in works.items():
        yield Contender(scene, name, work, judge, name.startswith(("tresym", "our")), **more)


@dataclass
class Timing:
    """What one contender took: seconds a piece, one entry a round it took part in."""

    contender: Contender
    judged: Judged
    seconds: list[float] = field(default_factory=list)

    @property
    def quartiles(self) -> tuple[float, float, float]:
        """Lower quartile, median, upper quartile in seconds."""
        if len(self.seconds) == 1:
            return (self.seconds[0],) * 3
        low, median, high = statistics.quantiles(self.seconds, n=4, method="inclusive")
        return low, median, high

    def ratio(self, reference: Timing) -> float | None:
        """The median over the rounds of this contender's time by the reference's in that round."""
        pairs = list(zip(self.seconds, reference.seconds, strict=False))
        return statistics.median(mine / other for mine, other in pairs) if pairs else None

    def as_json(self, reference: Timing | None) -> dict[str, Any]:
        """One row of the saved data; ``seconds`` is None where nothing was timed."""
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
"""What a workload found that is no timing, by name: lists of rows, or a dictionary."""


@dataclass
class Measurement:
    """A workload's timings; in each scene ratios are by the method ``reference`` starts with.

    ``notes`` is what a workload found beside times, such as counts, and ``tables`` lists of rows by
    name; ``complete`` is False when it was interrupted.
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
        """The timing that the ratios of a scene are by."""
        for timing in self.timings:
            who = timing.contender
            if who.scene == scene and who.method == self.reference and timing.seconds:
                return timing
        return None

    def as_json(self) -> dict[str, Any]:
        """All of it, with the machine and the versions it was measured with."""
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
    """How long to measure: rounds, and processor seconds a contender may use for them.

    A first run that takes ``limit`` seconds is timed out; one that takes more than ``patience`` is
    its own only sample.
    """

    rounds: int = 7
    limit: float = 10.0
    patience: float = 1.0


PACE = Pace()


class Keep(Protocol):
    """Called after each sample with all that has been measured so far, timings or tables."""

    def __call__(self, timings: list[Timing], tables: Tables | None = None) -> None:
        """Keep it."""


def forget(timings: list[Timing], tables: Tables | None = None) -> None:
    """Keep nothing."""


@dataclass(frozen=True)
class Workload:
    """A row of contenders; what they have opened stays open until all are timed.

    ``tables`` are rows of what is found beside times once all are timed, each after the name of its
    table, and ``notes`` what follows from both. ``reference`` and ``clock`` are as in
    :class:`Measurement`.
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
        """Run it, at its own pace unless another is given."""
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
    """Judge every contender once, then sample each once a round, starting one further each round.

    Returns:
        The timings, and whether the run came to its end: an interrupt ends it with what there is.
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
    """The judged first run, and how many rounds its contender is to be sampled."""
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
    """By name: how many were ``counted``, the outcomes, and the geometric mean of the ratios.

    The ratios are by the method ``reference`` of the same scene. One that timed out counts with the
    limit, so that the mean is then too small.
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
    """An exception in one line of at most 160 characters."""
    text = " ".join(str(error).split())
    line = f"{type(error).__name__}: {text}" if text else type(error).__name__
    return line if len(line) <= 160 else line[:157] + "..."


def _add_sample(timing: Timing) -> None:
    """One sample more; a contender that fails now is out, with its reason."""
    who = timing.contender
    try:
        seconds = who.sample() if who.sample else time_once(who.work) / who.pieces
    except Exception as error:
        timing.judged = timing.judged._replace(outcome=FAILED, why=reason(error))
        return
    timing.seconds.append(seconds)


def time_once(work: Callable[[], Any], seconds: float = SAMPLE_SECONDS) -> float:
    """Processor seconds one call takes, over as many calls as fill ``seconds``.

    Processor time, so that what else the machine does is not counted.
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
    """Python and the libraries that the timings depend on."""
    found = {"python": platform.python_version()}
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found


def machine() -> dict[str, Any]:
    """The processor as it calls itself, and how many this process may use."""
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
