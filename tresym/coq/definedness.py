"""Prove in Coq that the parts of a claim are defined, from the claim's own conditions.

A theorem has a premise for each condition under which one of its parts is defined. Each premise
that follows from the definitions and conditions is proved; a premise that does not, such as
sin x <> 0 where the claim speaks of 1/sin x, stays, and helps to prove the others. The result is a
stronger theorem, without the premises that were proved.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from tresym.coq.coqtop import Dialogue
from tresym.coq.ledger_statements import stem
from tresym.coq.statement import Theorem, condition, variable

TACTICS = (
    "give",
    "definedness",
    "laws; definedness",
    "values; definedness",
)
"""What is tried on each premise, cheapest first."""
SECONDS = 3


def stronger(theorem: Theorem, left: tuple[int, ...]) -> Theorem:
    """Return the theorem with only those of its premises of definedness, by number from 0."""
    return replace(theorem, defined=tuple(theorem.defined[n] for n in left))


def names_of(theorem: Theorem) -> tuple[list[str], list[str]]:
    """Return the names of variables and of hypotheses before the premises of definedness."""
    definitions = [f"D_{n}" for n in range(1, len(theorem.definitions) + 1)]
    given = [f"G_{n}" for n in range(1, len(theorem.given) + 1)]
    return [*map(variable, theorem.variables)], [*definitions, *given]


def strengthen(label: str, theorem: Theorem, coq: Dialogue) -> dict[str, Any] | None:
    """Return which premises of definedness stay, and a script for the theorem without the others.

    Args:
        label: the label of the claim.
        theorem: its theorem.
        coq: a Coq process.

    Returns:
        ``left``, the numbers of the premises that stay, and ``script``; None if all stay.
    """
    if theorem.exists or not theorem.defined:
        return None
    session = _Session(theorem, coq)
    order = sorted(range(len(theorem.defined)), key=lambda n: len(condition(*theorem.defined[n])))
    open_ = order
    while True:
        rest = [n for n in open_ if not session.shows(n)]
        if len(rest) == len(open_):
            break
        open_ = rest
    left: list[int] = []
    for n in open_:
        if not (left and session.shows(n, left)):
            left.append(n)
    session.end()
    if len(left) == len(theorem.defined):
        return None
    return {"left": sorted(left), "script": session.script(label, sorted(left))}


class _Session:
    """A proof in which all premises are introduced, to try which of them follow from others."""

    def __init__(self, theorem: Theorem, coq: Dialogue) -> None:
        self.theorem, self.coq = theorem, coq
        self.parts = [condition(*part) for part in theorem.defined]
        self.shown: list[tuple[int, str]] = []
        names, before = names_of(theorem)
        premises = [f"N_{n}" for n in range(len(self.parts))]
        self.names, self.before = names, before
        body = theorem.body.rsplit("\n", 1)[0] + "\n  True"
        self.start = [f"Goal\n{body}.", f"intros {' '.join([*names, *before, *premises])}."]
        self.start += _cases(theorem)
        self.begun = False

    def shows(self, n: int, left: list[int] | None = None) -> bool:
        """Whether a tactic proves a premise from the conditions and the premises ``left``."""
        others = {*range(len(self.parts))} - {*(left or ())}
        clear = f"clear {' '.join(f'N_{m}' for m in sorted(others))}; "
        for tactic in TACTICS:
            if not self.begun:
                self.begin()
            if self.coq.holds(f"assert (T_{n} : {self.parts[n]}) by ({clear}{tactic})."):
                self.shown.append((n, tactic))
                return True
            self.begun = self.coq.process is not None
        return False

    def begin(self) -> None:
        """Start the proof, again if Coq had to be ended."""
        self.coq.begin()
        self.coq.holds("Abort All.")
        for sentence in self.start:
            self.coq.holds(sentence)
        for n, _ in self.shown:
            self.coq.holds(f"assert (T_{n} : {self.parts[n]}) by (exact N_{n}).")
        self.begun = True

    def end(self) -> None:
        """Leave the proof."""
        if self.coq.process is not None:
            self.coq.holds("Abort All.")

    def script(self, label: str, left: list[int]) -> str:
        """Return the script of the stronger theorem, from the theorem ``premised_LABEL``."""
        names = [*self.names, *self.before, *(f"N_{n}" for n in left)]
        lines = [f"intros {' '.join(names)}."] if names else []
        lines += _cases(self.theorem)
        lines += [f"assert (N_{n} : {self.parts[n]}) by ({tactic})." for n, tactic in self.shown]
        every = [*self.names, *self.before, *(f"N_{n}" for n in range(len(self.parts)))]
        return "\n".join([*lines, f"exact (premised_{stem(label)} {' '.join(every)})."])


def _cases(theorem: Theorem) -> Iterator[str]:
    """Yield sentences that open the definitions which hold under conditions."""
    for n, (asked, _) in enumerate(theorem.definitions, 1):
        if asked:
            yield f"try pose proof (D_{n}{' ltac:(give)' * len(asked)})."
