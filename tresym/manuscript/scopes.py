"""How far what a manuscript says reaches: theorems, proofs, examples, lists, items, cases.

Definitions and assumptions in one of these end with it, with two exceptions: a proof or a
solution also has those of the statement before it, and a symbol that occurs in a list item is
restricted from there on, since the list may state assumptions.
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, field
from typing import NamedTuple

from tresym.manuscript.source import CASE, EXAMPLE, ITEM, LIST, PROOF, STATEMENT, Scope
from tresym.reals.language.expression import symbols
from tresym.reals.language.formula import Compared
from tresym.reals.language.latex_author import Function


class Restriction(NamedTuple):
    """Why a symbol is not free for a counterexample.

    Attributes:
        by: the other symbols that the restriction involves, if any.
        bounds: bounds that may be meant for it; a claim that fails under them is false.
        within: the only paragraph in which the restriction holds, 0 for any.
    """

    why: str
    by: frozenset[str] = frozenset()
    bounds: tuple[Compared, ...] = ()
    within: int = 0


@dataclass
class Reach:
    """The definitions and conditions at a place that end with a scope.

    Attributes:
        functions: the definitions of symbols and functions, the latest last.
        lasting: conditions of the text, to the end of the section or the scope.
        earlier: conditions of earlier sections, on symbols that were not introduced anew.
        recent: symbols defined in this section.
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
        """Return a copy."""
        return Reach(**{name: copy(value) for name, value in vars(self).items()})

    def since(self, before: Reach) -> Reach:
        """Return what was added since an earlier copy."""
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
        """Add the definitions and conditions of another scope."""
        for name, function in more.functions.items():
            self.functions.pop(name, None)
            self.functions[name] = function
        self.lasting += more.lasting
        self.recent |= more.recent
        self.ambiguous |= more.ambiguous
        self.places |= more.places
        self.restricted |= more.restricted

    def names(self) -> set[str]:
        """Return the symbols that occur in it."""
        spoken = {*self.functions, *self.restricted}
        for left, _, right in self.lasting:
            spoken |= symbols(left) | symbols(right)
        return spoken


class Scopes:
    """The open scopes at a place, each with the definitions and conditions before it.

    Attributes:
        now: the definitions and conditions at this place.
    """

    def __init__(self) -> None:
        self.now = Reach()
        self._paragraphs = 0
        self._open: list[tuple[Scope, Reach]] = []
        self._entered: list[int] = []
        self._section = 0
        self._statement = Reach()
        self._shared: dict[str, Function] | None = None

    @property
    def before(self) -> Reach:
        """The definitions and conditions before the innermost scope."""
        return self._open[-1][1] if self._open else Reach()

    @property
    def path(self) -> tuple[int, ...]:
        """The numbers of the section and of the open scopes in it, outermost first."""
        return (self._section, *self._entered)

    def mark(self, scope: Scope) -> None:
        """Open or close a scope."""
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

    def section(self, chapter: bool, inner: bool = False, example: bool = False) -> None:
        """Begin a section: all scopes, conditions and restrictions end.

        Args:
            inner: whether it is a subsection, such as the solution of an exercise.
            example: whether it is an exercise or an example, whose definitions end with it.
        """
        self._close_to(0)
        now = self.now
        if chapter or example or not inner:
            if self._shared is not None:
                now.functions = self._shared
            self._shared = {**now.functions} if example and not chapter else None
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
        """Begin a paragraph."""
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
