"""Notice when a stored proof is no longer the one that Coq checked.

A stamp is a hash of everything that Coq's answer depends on: Coq's version, the day, the statement,
the lemmas and the script stored with it, the statements of the theorems it applies, and every
lemma, definition and tactic of ``Tresym.v`` and ``Racket.v`` that is named there, directly or
through others. A lemma that is added to these files leaves the stamps of other proofs valid.
"""

from __future__ import annotations

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from functools import cache
from hashlib import sha256
from typing import Any

_COMMENT = re.compile(r"\(\*.*?\*\)", re.DOTALL)
_SENTENCE = re.compile(r"\S.*?\.(?=\s|$)", re.DOTALL)
_NAMED = re.compile(
    r"(?:Local |Global |#\[\w+\] ?)*(?:Lemma|Theorem|Corollary|Definition|Fixpoint|Function|Ltac|"
    r"Inductive|Record)\s+([\w']+)"
)
_ALSO = re.compile(r"\bwith\s+([\w']+)\b[^|;]*?:=")
_PROOF = re.compile(r"(Proof|Qed|Defined)\b|[^A-Z]")
_WORD = re.compile(r"[A-Za-z_][\w']*")
_MACHINE = re.compile(r"\b(interval|integral_intro)\b")


class Library:
    """The named pieces of Coq text, and which of them each piece names.

    Attributes:
        common: the commands outside the named pieces, which act on all that follows.
        pieces: the text of each lemma, definition or tactic, by name.
    """

    def __init__(self, text: str) -> None:
        found: dict[str, list[str]] = defaultdict(list)
        contexts: list[list[str]] = [[]]
        names: list[str] = []
        for sentence in _SENTENCE.findall(_COMMENT.sub(" ", text)):
            plain = " ".join(sentence.split())
            if named := _NAMED.match(plain):
                names = [named[1], *_ALSO.findall(plain)]
                if re.search(r"\b(Inductive|Record)\b", plain):  # constructors and fields
                    names = [*dict.fromkeys(_WORD.findall(plain))]
                own = [*(line for context in contexts[1:] for line in context), plain]
                for name in names:
                    found[name] += own
            elif _PROOF.match(plain):
                for name in names:
                    found[name].append(plain)
            elif plain.startswith("Section "):
                contexts.append([])
            elif plain.startswith("End "):
                contexts.pop()
            else:
                contexts[-1].append(plain)
        self.common = "\n".join(contexts[0])
        self.pieces = {name: "\n".join(lines) for name, lines in found.items()}
        self._named = {name: self._in(piece) - {name} for name, piece in self.pieces.items()}

    def _in(self, text: str) -> frozenset[str]:
        return frozenset(_WORD.findall(text)) & self.pieces.keys()

    def behind(self, text: str) -> dict[str, str]:
        """Return the pieces that the text names, directly or through other pieces."""
        seen: set[str] = set()
        waiting = [*self._in(text)]
        while waiting:
            name = waiting.pop()
            if name not in seen:
                seen.add(name)
                waiting += self._named[name]
        return {name: self.pieces[name] for name in sorted(seen)}


@cache
def library(text: str) -> Library:
    """Return the pieces of Coq text."""
    return Library(text)


def by_machine(text: str, lemmas: str) -> bool:
    """Return whether a proof, or a lemma or tactic behind it, may use Coq's machine arithmetic."""
    return any(map(_MACHINE.search, (text, *library(lemmas).behind(text).values())))


def digest(parts: Iterable[object]) -> str:
    """Return a hash of a list of texts."""
    return sha256(json.dumps([*parts]).encode()).hexdigest()[:16]


def stamp(row: Mapping[str, Any], applied: Iterable[str], coq: str, day: str, text: str) -> str:
    """Return the stamp of a stored proof.

    Args:
        row: the stored proof; everything in it counts, except what was recorded about the check.
        applied: the hashes of the statements of the theorems it applies.
        coq: Coq's version.
        day: when Coq checked it.
        text: ``Tresym.v`` and the lemmas of the paper.
    """
    own = {key: x for key, x in row.items() if key not in ("checked", "assumptions")}
    written = json.dumps(own, sort_keys=True)
    words = written.replace("\\n", "\n")  # where a name may follow a line break
    pieces = library(text)
    return digest([coq, day, written, *applied, pieces.common, pieces.behind(words)])


def checked(row: Mapping[str, Any], applied: Iterable[str], text: str) -> str:
    """Return "checked with VERSION, DAY" if the stamp of a stored proof holds, else ``""``."""
    found = row.get("checked")
    if not found:
        return ""
    coq, day = found["coq"], found["day"]
    if stamp(row, applied, coq, day, text) != found["stamp"]:
        return ""
    return f"checked with {coq}, {day}"
