"""How the work grows: with digits, with the number of starts (and its memory), and with claims."""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterator
from functools import partial
from importlib.util import find_spec
from typing import Any

import numpy as np
from flint import fmpq

from tresym.bench import flipmap as starts
from tresym.bench import peers
from tresym.bench.run import (
    Contender,
    Keep,
    Measurement,
    Pace,
    Rising,
    Tables,
    Timing,
    forget,
    interleave,
)
from tresym.ledger.paper import all_claims
from tresym.ledger.verification import verify
from tresym.racket.body import named_body
from tresym.racket.flip.ladder import climb
from tresym.racket.floats.flipmap import CHUNK, LARGE, flip_map
from tresym.reals.numbers.exact import parse_number

STR = named_body("str").shape
DIGITS = (50, 100, 200, 500, 1000, 2000, 5000, 10_000)
STARTS = tuple(10**n for n in range(8))
PIECE = 100_000
"""Starts handed over at a time; what is kept of each piece is one number."""
CLAIMS = (1, 3, 10, 30, 100, 300)

BY_DIGITS = "time against digits"
BY_STARTS = "time against starts"
BY_CLAIMS = "time against claims"

PACE = Pace(rounds=5, limit=2.5, patience=0.3)
LONG = Pace(rounds=3, limit=120.0, patience=0.5)


def measure(keep: Keep = forget, pace: Pace = PACE, most: int = STARTS[-1]) -> Measurement:
    """The workload ``scaling``; ``most`` starts at the most."""
    counts = [n for n in STARTS if n <= most]
    timings, complete = interleave(_by_digits(), pace, keep)
    if complete:
        known = list(timings)

        def keep_all(timings: list[Timing], tables: Tables | None = None) -> None:
            keep(known + timings)

        more = (*_by_starts(counts), *_by_claims())
        rest, complete = interleave(more, LONG, keep_all)
        timings += rest
    memory = [{"starts": n, "megabytes": round(peak(n) / 1e6, 2)} for n in counts]
    says = "time against digits, starts and claims; memory against starts"
    notes = {"chunk": CHUNK, "piece": PIECE, "compiled from": LARGE if find_spec("numba") else None}
    tables = {"memory": memory}
    return Measurement("scaling", says, timings, notes=notes, tables=tables, complete=complete)


def _by_digits() -> Iterator[Contender]:
    """ε(γ) of the racket; a peer that was too slow is not tried at more digits."""
    methods: dict[str, tuple[peers.Method, str]] = {
        "tresym, γ = 0": (_climb, "0"),
        "tresym, γ = 1e-8": (_climb, "1e-8"),
        "tresym, γ = -0.01 (turned)": (_climb, "-1/100"),
        "mpmath findroot, printed equation, γ = 0": (peers.findroot_printed, "0"),
        "mpmath findroot over R_F, R_J, γ = 1e-8": (peers.findroot_carlson, "1e-8"),
        "mpmath findroot over quad, γ = 1e-8": (peers.findroot_quad, "1e-8"),
    }
    for name, (method, gamma) in methods.items():
        run = partial(_at, method, parse_number(gamma))
        rising, ours = Rising(), name.startswith("tresym")
        for digits in DIGITS:
            yield Contender(BY_DIGITS, name, rising.work(run, digits), ours=ours, asked=digits)


def _at(method: peers.Method, gamma: fmpq, digits: int) -> Any:
    return method(STR, gamma, digits)


def _climb(shape: Any, gamma: fmpq, digits: int) -> Any:
    return climb(shape, gamma, digits).defect


def flips(count: int) -> float:
    """The largest |Δψ| of ``count`` starts of the racket, a piece at a time."""
    a, b, _ = peers.floats(STR, fmpq(0))
    psi, rate = starts.starts(min(count, PIECE))
    largest = 0.0
    for begin in range(0, count, PIECE):
        size = min(PIECE, count - begin)
        # No name for the piece: it is let go before the next is made.
        largest = max(largest, float(np.abs(flip_map(a, b, psi[:size], rate[:size])).max()))
    return largest


def peak(count: int) -> float:
    """The most memory in bytes that Python and numpy held at once for ``flips(count)``.

    As every piece is the same work, more than ten pieces are not repeated under the tracer, which
    slows them down.
    """
    starts.starts(1)  # made before, as they are no part of the map
    tracemalloc.start()
    try:
        flips(min(count, 10 * PIECE))
        return float(tracemalloc.get_traced_memory()[1])
    finally:
        tracemalloc.stop()


def _by_starts(counts: list[int]) -> Iterator[Contender]:
    for count in counts:
        yield Contender(
            BY_STARTS,
            "tresym flip map",
            partial(flips, count),
            ours=True,
            asked=count,
            pieces=count,
        )


def _by_claims() -> Iterator[Contender]:
    """The first claims of the proofs, and all; what they rest on is judged with them."""
    claims = all_claims()
    for count in (*CLAIMS, len(claims)):
        labels = [claim.label for claim in claims[:count]]
        work = partial(verify, labels)
        yield Contender(BY_CLAIMS, "tresym verify", work, ours=True, asked=count)
