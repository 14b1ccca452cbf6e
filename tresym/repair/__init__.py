"""Suggest true statements close to a refuted claim: other signs, conditions or values.

:func:`check` decides a claim and, if it is refuted, searches for similar claims that hold.
:func:`suggestions` searches for many claims in parallel processes. The search itself is in
:mod:`tresym.repair.search`.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future
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

GRACE = 5.0
"""Seconds of processor time after which a search that does not end by itself is stopped."""


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
        limit: the limit on processor time in seconds, after which the answer is UNDECIDED. The
            work is then done in a process of its own. Without a limit the claim is decided in this
            process.
        suggest: whether to search for true claims close to a refuted one, for at most a second
            of processor time. They are the attribute ``instead`` of the answer.

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
    return replace(answer, instead=next(suggestions([(answer.read_as, *AS_ALONE)], 1)))


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
    texts = [_text(question) for question in asked]
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
            _store(text, seconds, instead)
            yield instead


def suggested(answers: Iterable[tuple[Any, Any]]) -> Iterator[tuple[Any, Any]]:
    """Yield the answers to many claims; refuted ones with the suggestions of a single claim.

    The searches run beside the decisions, and their results are stored and found like answers.
    """
    processes, cache = cores(), current_cache()
    under_way: deque[tuple[Any, Any, str, Future[Any] | None]] = deque()
    with _pool(processes, SECONDS) as pool:
        for begun in [pool.submit(alternatives, "0 == 0", 0.0) for _ in range(processes)]:
            begun.result()  # the processes are started before there are other threads
        for task, answer in answers:
            text, search = "", None
            if isinstance(answer, Answer) and answer.verdict is Verdict.REFUTED:
                question = (answer.read_as, SECONDS, MOST, *AS_ALONE)
                text = _text(question)
                known = cache.get(text, "", None, SECONDS) if cache else None
                if known is not None:
                    answer = replace(answer, instead=known.instead)
                else:
                    search = pool.submit(alternatives, *question)
            under_way.append((task, answer, text, search))
            while under_way and (under_way[0][3] is None or len(under_way) > 2 * processes):
                yield _with_suggestions(*under_way.popleft())
        while under_way:
            yield _with_suggestions(*under_way.popleft())


AS_ALONE = ((), False, True)
"""How :func:`alternatives` is called for a claim of its own: no definitions, not cautious, unusual
edits as well."""


def _with_suggestions(
    task: Any, answer: Any, text: str, search: Future[Any] | None
) -> tuple[Any, Any]:
    """Wait for a search, store its result, and return the task with its answer."""
    if search is None:
        return task, answer
    try:
        instead = search.result()
    except Exception:  # the refutation stands without a suggestion
        return task, answer
    _store(text, SECONDS, instead)
    return task, replace(answer, instead=instead)


def _text(question: tuple[Any, ...]) -> str:
    """Return what a search is stored under."""
    return f"instead of {question[0]} {question[2:]}"


def _store(text: str, seconds: float, instead: tuple[Alternative, ...]) -> None:
    cache = current_cache()
    if cache is not None:
        kept = Answer(Verdict.UNDECIDED, "suggestions", instead=instead)
        cache.put(text, "", None, seconds, kept)


def _pool(processes: int, seconds: float) -> Processes:
    return Processes(processes, 2 * seconds + GRACE, deaths=1, forked=True)
