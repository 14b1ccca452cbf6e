"""How far what a manuscript says reaches: theorems, proofs, examples, lists, items, cases.

What is defined or assumed in one of these ends with it. Two things reach further: a proof or a
solution has what the statement before it says, and a symbol of which an item of a list speaks is
restricted from there on, as lists of assumptions are.
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, field
from typing import NamedTuple

from tresym.manuscript.source import CASE, EXAMPLE, ITEM, LIST, PROOF, STATEMENT, Scope
from tresym.reals.language.expression import symbols
from tresym.reals.language.latex_cursor import Function
from tresym.reals.language.parsing import Compared


class Restriction(NamedTuple):
    """Why a symbol is not free for a counterexample.

    Attributes:
        by: the other symbols that it is tied to, if it is to some.
        bounds: bounds that may be meant for it; what fails under them fails in any case.
        within: the only paragraph in which it is tied, 0 for any.
    """

    why: str
    by: frozenset[str] = frozenset()
    bounds: tuple[Compared, ...] = ()
    within: int = 0


@dataclass
class Reach:
    """What is said up to a place, as far as it ends with a scope.

    Attributes:
        functions: what symbols and functions stand for, the latest last.
        lasting: conditions of the prose, to the end of the section or the scope.
        earlier: those of sections before, of symbols that are not spoken of anew.
        recent: what was defined in this section; before it a letter may have been another.
        ambiguous: symbols with two definitions in this scope.
        places: in which paragraph a symbol was defined.
        restricted: symbols that are not free for a counterexample, and why.
        paragraph: the number of the paragraph.
    """

    functions: dict[str, Function] = field(default_factory=dict)
    lasting: list[Compared] = field(default_factory=list)
    earlier: list[Compared] = field(default_factory=list)
    recent: set[str] = field(default_factory=set)
    ambiguous: set[str] = field(default_factory=set)
    places: dict[str, int] = field(default_factory=dict)
    restricted: dict[str, Restriction] = field(default_factory=dict)
    paragraph: int = 0

    def copied(self) -> Reach:
        """Another with the same in it."""
        return Reach(**{name: copy(value) for name, value in vars(self).items()})

    def since(self, before: Reach) -> Reach:
        """What was added to that."""
        functions = before.functions
        return Reach(
            {n: f for n, f in self.functions.items() if functions.get(n) != f},
            [c for c in self.lasting if c not in before.lasting],
            [],
            self.recent - before.recent,
            self.ambiguous - before.ambiguous,
            {n: p for n, p in self.places.items() if before.places.get(n) != p},
            {n: w for n, w in self.restricted.items() if n not in before.restricted},
        )

    def add(self, more: Reach) -> None:
        """Take in what another scope says."""
        for name, function in more.functions.items():
            self.functions.pop(name, None)
            self.functions[name] = function
        self.lasting += more.lasting
        self.recent |= more.recent
        self.ambiguous |= more.ambiguous
        self.places |= more.places
        self.restricted |= more.restricted

    def names(self) -> set[str]:
        """The symbols of which it says something."""
        spoken = {*self.functions, *self.restricted}
        for left, _, right in self.lasting:
            spoken |= symbols(left) | symbols(right)
        return spoken


class Scopes:
    """The scopes that are open at a place, each with what was said before it.

    Attributes:
        now: what is said up to here.
    """

    def __init__(self) -> None:
        self.now = Reach()
        self._paragraphs = 0
        self._open: list[tuple[Scope, Reach]] = []
        self._entered: list[int] = []
        self._section = 0
        self._statement = Reach()

    @property
    def before(self) -> Reach:
        """What was said before the innermost scope."""
        return self._open[-1][1] if self._open else Reach()

    @property
    def path(self) -> tuple[int, ...]:
        """The section and the scopes in it that are open, outermost first."""
        return (self._section, *self._entered)

    def mark(self, scope: Scope) -> None:
        """A scope opens or ends."""
        if scope.name == "heading":
            while self._open and self._open[-1][0].name == "heading":
                if scope.kind == CASE and self._open[-1][0].kind != CASE:
                    break
                self._close()
        elif scope.kind == ITEM:
            lists = [n for n, (one, _) in enumerate(self._open) if one.kind == LIST]
            if not lists:
                return
            self._close_to(lists[-1] + 1)
        elif not scope.opens:
            same = [n for n, (one, _) in enumerate(self._open) if one.name == scope.name]
            if same:
                self._close_to(same[-1])
        if scope.opens:
            self._enter(scope)

    def section(self, chapter: bool) -> None:
        """A section begins: every scope has ended, and so have conditions and restrictions."""
        self._close_to(0)
        now = self.now
        for name in now.ambiguous:
            now.functions.pop(name, None)
        if chapter:
            now.functions.clear()
        now.earlier += now.lasting
        now.lasting, now.restricted, now.ambiguous = [], {}, set()
        now.recent.clear()
        self._statement = Reach()
        self.paragraph()
        self._section = self._paragraphs

    def paragraph(self) -> None:
        """A paragraph begins."""
        self._paragraphs += 1
        self.now.paragraph = self._paragraphs

    def _enter(self, scope: Scope) -> None:
        self._open.append((scope, self.now.copied()))
        self.paragraph()
        self._entered.append(self._paragraphs)
        if scope.kind == PROOF:
            self.now.add(self._statement)
        elif scope.kind in (STATEMENT, EXAMPLE):
            self._statement = Reach()

    def _close_to(self, depth: int) -> None:
        while len(self._open) > depth:
            self._close()

    def _close(self) -> None:
        scope, before = self._open.pop()
        self._entered.pop()
        added, self.now = self.now.since(before), before
        if scope.kind in (STATEMENT, EXAMPLE):
            self._statement = added
        elif scope.kind in (LIST, ITEM):
            why = Restriction("an item of an earlier list is about it")
            before.restricted |= {n: why for n in added.names() if n not in before.restricted}
