"""Every claim of ``tests/data/verdicts`` has the verdict that its line begins with.

A file of that folder belongs to a module of the package. Its sections are named in brackets, with
``slow`` or ``night`` where they take long. A line is the verdict, the claim, and what else the
answer has, separated by `` | ``::

    [what fails is refuted at some n]
    REFUTED | sum(n, k, 1, n) == n*(n - 1)/2 | witness
    # from 22 on nothing follows, since nothing is said at 20 and 21
    NEVER | sum(k, k, 1, n) == n given n >= 1

Beside the four verdicts there are HOLDS (proved or enclosed), NEVER (neither of these), OPEN
(anything but refuted) and ``*`` (any). After the claim stand ``witness``, and texts that the
reasons have (``why:``) or have not (``not:``). No answer may be laid at the door of a fault.
"""

from pathlib import Path

import pytest

import tresym
from tresym.reals.decisions.answer import Answer

DATA = Path(__file__).parent / "data" / "verdicts"
MEANT = {
    "HOLDS": "PROVED/ENCLOSED",
    "NEVER": "REFUTED/UNDECIDED",
    "OPEN": "PROVED/ENCLOSED/UNDECIDED",
    "*": "PROVED/ENCLOSED/REFUTED/UNDECIDED",
}
"""What a word allows that is no verdict."""


def sections() -> list[object]:
    """The lines of each section, as parameters of a test that have its name and its mark."""
    found: list[object] = []
    for file in sorted(DATA.glob("**/*.txt")):
        inner = file.relative_to(DATA).with_suffix("").as_posix()
        for part in file.read_text(encoding="utf-8").removeprefix("[").split("\n["):
            head, _, rest = part.partition("]\n")
            mark = head.partition(" | ")[2]
            lines = [line for line in rest.splitlines() if line and not line.startswith("#")]
            marks = [getattr(pytest.mark, mark)] if mark else []
            found.append(pytest.param(lines, id=f"{inner}: {head}", marks=marks))
    return found


def _has(answer: Answer, what: str) -> bool:
    """Whether an answer has what stands in a column after the claim."""
    word, _, text = what.partition(": ")
    if word == "witness":
        return bool(answer.witness)
    assert word in ("why", "not"), what
    return (text in answer.why) is (word == "why")


def told(line: str) -> str:
    """What is wrong with the answer to a claim of a list; empty where nothing is."""
    verdict, claim, *more = line.split(" | ")
    answer = tresym.check(claim)
    right = answer.verdict.value in MEANT.get(verdict, verdict).split("/")
    if right and all(_has(answer, what) for what in more) and "please report" not in answer.why:
        return ""
    return f"{line}\n    {answer.verdict.value}: {answer.why}"


@pytest.mark.parametrize("lines", sections())
def test_each_claim_has_its_verdict(lines: list[str]) -> None:
    assert lines
    wrong = [problem for line in lines if (problem := told(line))]
    assert not wrong, "\n".join(wrong)
