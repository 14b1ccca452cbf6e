"""Benchmark of scaling: time against digits, number of starts (and memory), and claims."""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
from flint import fmpq

from tresym.dev.bench import flipmap as starts
from tresym.dev.bench import peers
from tresym.dev.bench.run import Contender, Pace, Rising, Workload, row
from tresym.ledger.paper import all_claims
from tresym.ledger.verification import verify
from tresym.racket.body import named_body
from tresym.racket.flip import flip_defect
from tresym.racket.floats.flipmap import CHUNK, flip_map
from tresym.reals.numbers.exact import parse_number

STR = named_body("str").shape
DIGITS = (50, 100, 200, 500, 1000, 2000, 5000, 10_000)
STARTS = tuple(10**n for n in range(8))
PIECE = 100_000
"""Starts per call; only one number is kept of each."""
CLAIMS = (1, 3, 10, 30, 100, 300)

BY_DIGITS = "time against digits"
BY_STARTS = "time against starts"
BY_CLAIMS = "time against claims"

LONG = Pace(rounds=3, limit=120.0, patience=0.5)


def contenders(_: Any) -> Iterator[Contender]:
    """Yield ε(γ) by digits, the flip map by starts, and the ledger by claims."""
    methods: dict[str, tuple[peers.Method, str]] = {
        "tresym, γ = 0": (_public, "0"),
        "tresym, γ = 1e-8": (_public, "1e-8"),
        "tresym, γ = -0.01 (turned)": (_public, "-1/100"),
        "mpmath findroot, printed equation, γ = 0": (peers.findroot_printed, "0"),
        "mpmath findroot over R_F, R_J, γ = 1e-8": (peers.findroot_carlson, "1e-8"),
        "mpmath findroot over quad, γ = 1e-8": (peers.findroot_quad, "1e-8"),
    }
    for name, (method, gamma) in methods.items():
        run, rising = partial(method, STR, parse_number(gamma)), Rising()
        for digits in DIGITS:
            yield from row(BY_DIGITS, {name: rising.work(run, digits)}, asked=digits)
    for count in STARTS:
        work = {"tresym flip map": partial(flips, count)}
        yield from row(BY_STARTS, work, asked=count, pieces=count, pace=LONG)
    labels = [claim.label for claim in all_claims()]
    for count in (*CLAIMS, len(labels)):
        judged = {"tresym verify": partial(verify, labels[:count])}
        yield from row(BY_CLAIMS, judged, asked=count, pace=LONG)


def memory(_: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the largest amount of memory against the number of starts."""
    for count in STARTS:
        yield "memory", {"starts": count, "megabytes": round(peak(count) / 1e6, 2)}


def sizes(*_: Any) -> dict[str, Any]:
    """Return how many starts are passed at a time, and how many are computed at a time."""
    return {"chunk": CHUNK, "piece": PIECE}


WORKLOAD = Workload(contenders, Pace(rounds=5, limit=2.5, patience=0.3), tables=memory, notes=sizes)


def _public(shape: Any, gamma: fmpq, digits: int) -> Any:
    return flip_defect(shape, None, gamma, digits).defect


def flips(count: int) -> float:
    """Return the largest |Δψ| of ``count`` starts of the racket, computed piece by piece."""
    a, b, _ = peers.floats(STR, fmpq(0))
    psi, rate = starts.starts(min(count, PIECE))
    largest = 0.0
    for begin in range(0, count, PIECE):
        size = min(PIECE, count - begin)
        # The piece is not bound to a name, so that it is freed before the next one is made.
        largest = max(largest, float(np.abs(flip_map(a, b, psi[:size], rate[:size])).max()))
    return largest


def peak(count: int) -> float:
    """Return the most memory in bytes that Python and numpy use at once for ``flips(count)``.

    Since all pieces are the same work, at most ten are run under the tracer, which slows them down.
    """
    starts.starts(1)  # made before, as they are no part of the map
    tracemalloc.start()
    try:
        flips(min(count, 10 * PIECE))
        return float(tracemalloc.get_traced_memory()[1])
    finally:
        tracemalloc.stop()
