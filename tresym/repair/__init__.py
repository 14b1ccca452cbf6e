"""Suggest true statements close to a refuted claim: other signs, conditions or values.

:func:`check` decides a claim and, if it is refuted, searches for similar claims that hold.
:func:`suggestions` searches for many claims in parallel processes. The search itself is in
:mod:`tresym.repair.search`.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import nullcontext
from dataclasses import replace
from typing import Any

from tresym.checking import check as decided
from tresym.checking.time_limited import current_cache
from tresym.reals.decisions.answer import Alternative, Answer
from tresym.reals.processes import Processes, cores
from tresym.reals.verdict import Verdict
from tresym.repair.agreement import Definitions
from tresym.repair.search import MOST, SECONDS, alternatives

__all__ = ["Alternative", "check", "suggested", "suggestions"]

GRACE = 15.0
"""The wall time in seconds beyond the processor time after which a search is ended."""
SHARE, LEAST = 0.2, 0.01
"""The share of a run over many claims for searches, and the least seconds to begin one."""


def check(
    claim: Any,
    given: Any = "",
    path: str | None = None,
    limit: float | None = None,
    suggest: bool = True,
) -> Answer:
    """Decide a claim about real elementary expressions.

    Args:
        claim: text such as ``"diff(F, x) == f"``, ``"exp(x) >= 1 + x"`` or ``"sin(x) == x +
            O(x**3)"``; LaTeX of the same; or a SymPy relation such as ``Eq(f, g)``, whose symbols
            are taken as real.
        given: conditions: text such as ``"a > 0, 0 < b <= 1"``, LaTeX, or SymPy relations.
        path: the path of an asymptotic claim, such as ``"x -> 0+"``.
        limit: the time limit in seconds, after which the answer is UNDECIDED. The work is then done
            in a process of its own. Without a limit the claim is decided in this process.
        suggest: whether to search for true claims close to a refuted one, for at most half a
            second. They are the attribute ``instead`` of the answer.

    Returns:
        The answer, with its verdict and reason.

    Raises:
        InputError: the claim cannot be parsed, or the limit is not a number of seconds; the message
            is one line.

    Example:
        >>> import tresym
        >>> tresym.check("sqrt(x**2) == x", given="x > 0").verdict.value
        'PROVED'
        >>> found = tresym.check("sqrt(x**2) == x")
        >>> found.verdict.value, found.instead[0].given
        ('REFUTED', 'x >= 0')
    """
    answer = decided(claim, given, path, limit)
    if not suggest or answer.verdict is not Verdict.REFUTED:
        return answer
    if limit is None:
        return replace(answer, instead=alternatives(answer.read_as))
    return replace(answer, instead=next(suggestions([(answer.read_as, (), False, True)], 1)))


def suggestions(
    claims: Iterable[tuple[str, Definitions, bool, bool]],
    processes: int | None = None,
    seconds: float = SECONDS,
) -> Iterator[tuple[Alternative, ...]]:
    """Yield true alternatives to each of several refuted claims, in their order.

    Args:
        claims: tuples of the claim in the text grammar with its conditions and path, the
            definitions of its symbols, whether to be cautious, and whether unusual edits count; see
            :func:`tresym.repair.search.alternatives`.
        processes: the number of processes; by default one for each core.
        seconds: the processor time for each claim.
    """
    asked = [(claim, seconds, MOST, *rest) for claim, *rest in claims]
    cache = current_cache()
    texts = [f"instead of {question[0]} {question[2:]}" for question in asked]
    known = [cache.get(text, "", None, seconds) if cache else None for text in texts]
    new = [question for question, found in zip(asked, known, strict=True) if found is None]
    with _pool(processes or cores(), seconds) if new else nullcontext() as pool:
        futures = pool.in_order(alternatives, new) if pool else iter(())
        for text, found in zip(texts, known, strict=True):
            if found is not None:
                yield found.instead
                continue
            try:
                instead = next(futures).result()
            except Exception:  # a search that fails, or is stopped, finds nothing
                yield ()
                continue
            if cache is not None:
                kept = Answer(Verdict.UNDECIDED, "suggestions", instead=instead)
                cache.put(text, "", None, seconds, kept)
            yield instead


def suggested(answers: Iterable[tuple[Any, Any]]) -> Iterator[tuple[Any, Any]]:
    """Yield the answers to many claims, with suggestions that take at most a fifth of the time."""
    start, spent = time.perf_counter() - time.process_time(), 0.0
    with _pool(1, SECONDS) as pool:
        pool.submit(alternatives, "0 == 0", 0.0).result()  # started before there are other threads
        for task, answer in answers:
            now = time.perf_counter()
            left = (SHARE * (now - start) - spent) / (1 - SHARE)
            if isinstance(answer, Answer) and answer.verdict is Verdict.REFUTED and left > LEAST:
                seconds = min(left, SECONDS)
                try:
                    found = pool.submit(alternatives, answer.read_as, seconds).result()
                except Exception:  # the refutation stands without a suggestion
                    found = ()
                answer = replace(answer, instead=found)
                spent += time.perf_counter() - now
            yield task, answer


def _pool(processes: int, seconds: float) -> Processes:
    return Processes(processes, 2 * seconds + GRACE, deaths=1, forked=True)
