"""Lists of claims that were written without sight of the code: how many are held and refuted.

``python tests/unseen.py [LIST ...]`` prints, for each list of ``data/claims``, how many true claims
are PROVED or ENCLOSED, how many false ones REFUTED, and the median and 99th percentile of the
milliseconds of processor time that an answer takes; what is open, and what is wrong, is named.
``python tests/unseen.py save`` keeps the counts for the page on deciding.
"""

import json
import sys
import time
from pathlib import Path
from statistics import median, quantiles
from typing import Any

from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.answer import Answer
from tresym.reals.processes import Processes

HOME = Path(__file__).parent
LISTS = HOME / "data" / "claims"
SAVED = HOME.parent / "docs" / "measurements" / "kinds.json"
LIMIT = 60.0


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


def timed(claim: str) -> tuple[Answer, float]:
    """The answer, and the milliseconds of processor time it took."""
    start = time.process_time()
    return decide_claim(claim), 1000 * (time.process_time() - start)


def measured(name: str) -> dict[str, Any]:
    """The counts of a list; what is open or wrong is printed."""
    listed = claims(name)
    times, right, wrong = [], {True: 0, False: 0}, 0
    with Processes(1, LIMIT, deaths=1, forked=True) as pool:
        answers = pool.in_order(timed, ((claim,) for _, claim in listed))
        for (truth, claim), future in zip(listed, answers, strict=True):
            try:
                answer, spent = future.result()
                found, why = is_right(truth, answer), answer.why
            except TimeoutError as error:
                found, spent, why = None, 1000 * LIMIT, str(error)
            times.append(spent)
            right[truth] += found is True
            wrong += found is False
            if found is not True:
                print(f"  {'open' if found is None else 'WRONG'}, {truth}: {claim}: {why}")
    true = sum(truth for truth, _ in listed)
    return {
        "true": true,
        "held": right[True],
        "false": len(listed) - true,
        "refuted": right[False],
        "wrong": wrong,
        "median": round(median(times), 1),
        "p99": round(quantiles(times, n=100)[98]),
    }


def said(name: str, counts: dict[str, Any]) -> str:
    """The counts in a line."""
    return (
        "{name}: {held} of {true} held, {refuted} of {false} refuted, {wrong} wrong; "
        "median {median} ms, 99th percentile {p99} ms"
    ).format(name=name, **counts)


if __name__ == "__main__":
    asked = [word for word in sys.argv[1:] if word != "save"]
    found: dict[str, Any] = {"workload": "kinds"}
    for each in asked or sorted(path.stem for path in LISTS.glob("*.txt")):
        found[each] = measured(each)
        print(said(each, found[each]), flush=True)
    if "save" in sys.argv:
        SAVED.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
