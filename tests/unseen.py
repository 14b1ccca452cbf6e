"""Lists of claims that were written without sight of the code: how many are held and refuted.

``python tests/unseen.py [LIST ...]`` prints, for each list of ``data/claims``, how many true claims
are PROVED or ENCLOSED, how many false ones REFUTED, and the median and 99th percentile of the
milliseconds that an answer takes; what is open, and what is wrong, is named.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from statistics import median, quantiles

from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.limits import Task, check_all
from tresym.reals.numbers.exact import InputError

LISTS = Path(__file__).parent / "data" / "claims"
LIMIT = 5.0


def claims(name: str) -> list[tuple[bool, str]]:
    """Whether each is true, and the claim."""
    lines = (LISTS / f"{name}.txt").read_text(encoding="utf-8").splitlines()
    parts = (line.split(" | ", 1) for line in lines if line and not line.startswith("#"))
    return [(truth == "true", claim) for truth, claim in parts]


def is_right(truth: bool, answer: Answer) -> bool | None:
    """Whether the verdict is that of the claim; None where it is open."""
    if answer.verdict.name == "UNDECIDED":
        return None
    return (answer.verdict.name != "REFUTED") is truth


def measured(name: str) -> Iterator[str]:
    """The lines that are printed of a list."""
    listed = claims(name)
    times, right = [], {True: 0, False: 0}
    answers = check_all((Task(claim) for _, claim in listed), LIMIT, 1)
    for (truth, claim), (_, answer) in zip(listed, answers, strict=True):
        if isinstance(answer, InputError):
            yield f"  not read: {claim}: {answer}"
            continue
        times.append(1000 * answer.seconds)
        found = is_right(truth, answer)
        right[truth] += found is True
        if found is not True:
            yield f"  {'open' if found is None else 'WRONG'}, {truth}: {claim}: {answer.why}"
    count = sum(truth for truth, _ in listed)
    yield (
        f"{name}: {right[True]} of {count} held, {right[False]} of {len(listed) - count} refuted; "
        f"median {median(times):.1f} ms, 99th percentile {quantiles(times, n=100)[98]:.0f} ms"
    )


if __name__ == "__main__":
    for name in sys.argv[1:] or sorted(path.stem for path in LISTS.glob("*.txt")):
        for line in measured(name):
            print(line, flush=True)
