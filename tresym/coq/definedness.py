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
from tresym.reals.language.expression import ZERO
from tresym.reals.language.formula import Conjunction

TACTICS = (
    "give",
    "definedness",
    "laws; definedness",
    "values; definedness",
    "values; collected; definedness",
    "by_symmetry",
    "times_cosine",
    "small_share",
)
"""What is tried on each premise, cheapest first."""
SECONDS = 3


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
    open_ = sorted(range(len(theorem.defined)), key=lambda n: len(session.parts[n]))
    while rest := [n for n in open_ if not session.shows(n)]:
        if len(rest) == len(open_):
            break
        open_ = rest
    left: list[int] = []
    for n in rest:  # one that stays may help with those after it
        if not (left and session.shows(n, left)):
            left.append(n)
    session.end()
    if len(left) == len(theorem.defined):
        return None
    return {"left": sorted(left), "script": session.script(label, sorted(left))}


def trial(label: str, theorem: Theorem, found: dict[str, Any]) -> str:
    """Return the stronger theorem with its proof; ``@`` stands for a number."""
    left = tuple(theorem.defined[n] for n in found["left"])
    says = f"({theorem.body}) -> ({replace(theorem, defined=left).body})"
    return (
        f"Theorem trial_@ :\n{says}.\nProof.\nintros premised_{stem(label)}.\n"
        f"{found['script']}\nQed."
    )


def satisfiable(theorem: Theorem) -> Theorem:
    """Return that a point satisfies definitions, conditions and premises together."""
    asked = [c for conditions, _ in theorem.definitions for c in conditions]
    parts = [(e, sign, ZERO) for e, sign in theorem.defined]
    given = tuple(dict.fromkeys((*theorem.given, *asked, *parts)))
    plain = tuple(((), meaning) for _, meaning in theorem.definitions)
    return replace(
        theorem, definitions=plain, given=given, defined=(), says=Conjunction(()), exists=True
    )


class _Session:
    """A proof in which all premises are introduced, to try which of them follow from others."""

    def __init__(self, theorem: Theorem, coq: Dialogue) -> None:
        self.theorem, self.coq = theorem, coq
        self.parts = [condition(*part) for part in theorem.defined]
        self.shown: list[tuple[int, str, bool]] = []
        self.names = [
            *map(variable, theorem.variables),
            *(f"D_{n}" for n in range(1, len(theorem.definitions) + 1)),
            *(f"G_{n}" for n in range(1, len(theorem.given) + 1)),
        ]
        premises = [f"N_{n}" for n in range(len(self.parts))]
        body = replace(theorem, says=Conjunction(())).body
        self.start = [f"Goal\n{body}.", f"intros {' '.join([*self.names, *premises])}."]
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
                self.shown.append((n, tactic, bool(left)))
                return True
            self.begun = self.coq.process is not None
        return False

    def begin(self) -> None:
        """Start the proof, again if Coq had to be ended."""
        self.coq.begin()
        self.coq.holds("Abort All.")
        for sentence in self.start:
            self.coq.holds(sentence)
        for n, *_ in self.shown:
            self.coq.holds(f"assert (T_{n} : {self.parts[n]}) by (exact N_{n}).")
        self.begun = True

    def end(self) -> None:
        """Leave the proof."""
        if self.coq.process is not None:
            self.coq.holds("Abort All.")

    def script(self, label: str, left: list[int]) -> str:
        """Return the script of the stronger theorem, from the theorem ``premised_LABEL``."""
        premises = [f"N_{n}" for n in left]
        names = [*self.names, *premises]
        lines = [f"intros {' '.join(names)}."] if names else []
        lines += _cases(self.theorem)
        for n, tactic, from_left in self.shown:
            before = "" if from_left or not left else f"clear {' '.join(premises)}; "
            lines.append(f"assert (N_{n} : {self.parts[n]}) by ({before}{tactic}).")
        every = [*self.names, *(f"N_{n}" for n in range(len(self.parts)))]
        return "\n".join([*lines, f"exact (premised_{stem(label)} {' '.join(every)})."])


def _cases(theorem: Theorem) -> Iterator[str]:
    """Yield sentences that open the definitions which hold under conditions."""
    for n, (asked, _) in enumerate(theorem.definitions, 1):
        if asked:
            yield f"try pose proof (D_{n}{' ltac:(give)' * len(asked)})."
