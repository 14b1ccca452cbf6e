"""Benchmark of ``tresym check``: antiderivatives, false variants of them, and random identities.

The pairs of antiderivatives.txt are claims ``diff(F, x) == f`` with parameters without assumptions.
A mutant is a pair whose integrand was changed so that the claim is numerically false. SymPy is
asked as a user would: whether ``simplify(diff(F, x) - f)`` is 0, and ``diff(F, x).equals(f)``. The
random identities are those of rewriting.py, decided like a file of claims, each within a time
limit. The inequalities and orders are lists of true claims and of false ones close to them.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from random import Random
from typing import Any

import sympy
from sympy.core.cache import clear_cache

from tresym.checking import check
from tresym.checking.dispatch import decide_claim
from tresym.checking.time_limited import Task, check_all
from tresym.dev.bench.run import (
    FAILED,
    RIGHT,
    WRONG,
    Contender,
    Judged,
    Pace,
    Timing,
    Workload,
    tally,
)
from tresym.dev.corpus.lists import Pair, known, pairs
from tresym.dev.corpus.rewriting import (
    changed,
    false_identity,
    far_apart,
    points,
    real_value,
    true_identity,
)
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

OURS = "tresym check"
PACE = Pace(rounds=3, limit=20.0, patience=0.5)
EVERY = 16
"""SymPy gets every pair whose number is a multiple of this."""
TRIALS = 10_000
CHUNK = 500
CHANGES = 20
LIMIT = 10.0


def contenders(_: Any) -> Iterator[Contender]:
    """Yield one pair in ``EVERY``: tresym through its public function and internally, and SymPy."""
    for pair in pairs()[::EVERY]:
        left, right = (sympy.sympify(side, locals=_names(side)) for side in pair)
        works: dict[str, Callable[[], Any]] = {
            OURS: partial(_proved, pair.claim),
            "tresym, once it is read": partial(_proved, read(pair.claim)),
            "sympy simplify": partial(_simplify, left, right),
            "sympy equals": partial(_equals, left, right),
        }
        for name, work in works.items():
            judge = partial(_judge, name)
            yield Contender(pair.claim, name, work, judge, name.startswith("tresym"))


def notes(timings: list[Timing], _: Any) -> dict[str, Any]:
    """Return the verdicts on all pairs, mutants, lists and random identities."""
    everything = pairs()
    found: dict[str, Any] = {
        "pairs": decided([pair.claim for pair in everything]),
        "mutants": mutants(everything),
    }
    for name in ("inequalities", "orders"):
        for truth, key in ((True, "true"), (False, "false")):
            claims = [claim for is_true, claim in known(name) if is_true is truth]
            found[f"{key} {name}"] = decided(claims)
    found["peers"] = tally(timings, OURS, PACE.limit, "pairs")
    found["trial"] = {"true": trial(true_identity, TRIALS), "false": trial(false_identity, TRIALS)}
    return found


WORKLOAD = Workload(contenders, PACE, OURS, notes=notes)


def decided(claims: list[str]) -> dict[str, Any]:
    """Return how often each verdict occurred, and the processor time."""
    check(claims[0])  # what is done once in a process is not counted
    verdicts: Counter[str] = Counter()
    seconds = []
    for claim in claims:
        start = time.process_time()
        verdicts[check(claim).verdict.value] += 1
        seconds.append(time.process_time() - start)
    seconds.sort()
    return {
        "claims": len(claims),
        **verdicts,
        "median": _short(seconds[len(seconds) // 2]),
        "p99": _short(seconds[int(0.99 * len(seconds))]),
        "longest": _short(seconds[-1]),
    }


def mutants(everything: list[Pair]) -> dict[str, Any]:
    """Return the verdicts on one mutant of each pair that is false at some point, by mpmath."""
    verdicts: Counter[str] = Counter()
    for number, pair in enumerate(everything):
        mutant = _false_mutant(pair, Random(number))
        if mutant is not None:
            claim = Pair(pair.antiderivative, str(mutant)).claim
            verdicts[check(claim).verdict.value] += 1
    return {"claims": verdicts.total(), **verdicts, "wrong": verdicts[Verdict.PROVED.value]}


def _false_mutant(pair: Pair, random: Random) -> Expr | None:
    """A changed integrand that differs from the original at some point, or None."""
    function, right = parse(pair.antiderivative), parse(pair.integrand)
    left = differentiate(function, "x")
    names = sorted(symbols(function) | symbols(right) | {"x"})
    inside = [point for _ in range(5) for point in points(random, names)]
    real = [point for point in inside if real_value(function, point) is not None]
    for _ in range(CHANGES):
        other = changed(right, random)
        if symbols(other) <= set(names) and any(
            far_apart(left, other, point) for point in real or inside
        ):
            return other
    return None


def _proved(claim: Any) -> bool:
    decide = check if isinstance(claim, str) else decide_claim
    return decide(claim).verdict is Verdict.PROVED


def _simplify(left: Any, right: Any) -> bool:
    clear_cache()  # SymPy's memory of earlier answers, as a claim is asked once
    return bool(sympy.simplify(sympy.diff(left, sympy.Symbol("x")) - right) == 0)


def _equals(left: Any, right: Any) -> Any:
    clear_cache()
    return sympy.diff(left, sympy.Symbol("x")).equals(right)


def _names(text: str) -> dict[str, Any]:
    """The variables as SymPy symbols, even if SymPy uses the letter otherwise."""
    return {name: sympy.Symbol(name) for name in symbols(parse(text))}


def _judge(method: str, answer: Any) -> Judged:
    if answer is True:
        return Judged(outcome=RIGHT)
    if answer is False and method == "sympy equals":
        return Judged(outcome=WRONG, why="says False")
    return Judged(outcome=FAILED, why="not decided")


def trial(make: Callable[[Random], tuple[Expr, Expr]], count: int) -> dict[str, int]:
    """Return the verdicts on ``count`` random identities, from the generators 0, 1, 2, …"""
    verdicts: Counter[str] = Counter()
    for first in range(0, count, CHUNK):
        last = min(first + CHUNK, count)
        sides = [make(Random(seed)) for seed in range(first, last)]
        tasks = [Task(f"{left} == {right}") for left, right in sides]
        for _, found in check_all(tasks, LIMIT, 1):
            verdicts["not read" if isinstance(found, InputError) else found.verdict.value] += 1
    return {"identities": count, **verdicts}


def _short(x: float) -> float:
    return float(f"{x:.3g}")
