r"""What each symbol of a manuscript is: a real number, unless something speaks against it.

Evidence are words ("linear operator $T$"), notation (``\hat p``, ``A^T``, ``AB`` beside ``BA``) and
use (``a_k`` under a sum over k, ``\Phi(-x)``). It holds for the same symbol, with the same
subscript, in the whole section, before and behind the place where it stands; what words call a real
number is one from there to the end of the section. Only three kinds of evidence hold longer: words
that introduce a capital letter or one with an accent ("a matrix $A$"), in the whole chapter; what
is said to be complex, from there on; functions and sequences.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from tresym.manuscript import prose
from tresym.manuscript.kinds_in_notation import (
    applied_and_bare,
    declared_by_notation,
    doubts,
    indices,
    noted,
    sequences,
)
from tresym.manuscript.kinds_in_prose import (
    COMPLEX,
    FUNCTION,
    INTEGER,
    INVERSES,
    OF_BARS,
    OPERATOR,
    RANDOM,
    REAL,
    SEQUENCE,
    SET,
    SPEAKERS,
    UNKNOWN,
    VECTOR,
    declared,
    intervals_in,
    of_sentence,
)
from tresym.manuscript.source import Display, Event, Prose, Section
from tresym.manuscript.symbols import STYLES, Mention, mentions, without_upright
from tresym.reals.language.latex_cursor import is_letter
from tresym.reals.language.latex_tokens import RELATIONS, tokenize
from tresym.reals.numbers.exact import InputError

READ = frozenset((REAL, INTEGER, FUNCTION, SEQUENCE))
"""The kinds of symbols that statements may contain to be decided."""
ONLY = "only statements about real numbers, integers, functions and sequences are checked"
_DECLARED_IN_TEXT = re.compile(r"\\(?:text\w*|mbox|intertext)\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_ALGEBRA = frozenset(("+", "-", "^", "{", "}", "_", "\\cdot", "\\times", "\\frac", "/", "\\,"))
_NAMING_RELATIONS = ("=", ":=", "==", "\\equiv", ":", "\\colon", "\\in", "\\sim")
"""Relations that may follow a symbol named by the words before a formula."""
_NAMES_BELOW = (("p",), ("q",), ("r",), ("s",))
"""Subscripts that are names if nothing is summed: ``y_p`` is a particular solution."""
_OF_ALL_SUBSCRIPTS = frozenset((OPERATOR, SET, RANDOM, UNKNOWN))
"""The kinds that a capital letter passes on to ``X_1``, ``X_2``, …; those of a vector or a matrix
are its components, and numbers."""
Key = tuple[str, str, str]
"""A letter, its accent, and its subscript: the same word for all that number terms."""


@dataclass(frozen=True)
class Evidence:
    """Evidence for the kind of a symbol.

    Attributes:
        kind: the kind, such as "a matrix".
        words: the words or the formula that say so.
        line, file: where they stand.
        place: the index of the event in which they stand.
        section: the number of the section; -1 for a directive.
        said: whether it is stated in words or by a directive, not only by notation.
        local: whether it counts in its section only.
        onward: whether it does not count in earlier sections.
    """

    kind: str
    words: str
    line: int
    file: str = ""
    place: int = 0
    section: int = 0
    said: bool = False
    local: bool = False
    onward: bool = False

    @property
    def where(self) -> str:
        """The place and the words, for a reader."""
        file = f"{self.file}, " if self.file else ""
        return f"{file}line {self.line}: '{self.words}'"


class Uses(NamedTuple):
    """How the names of a formula are used in its chapter.

    Attributes:
        numbers: names that the text calls numbers.
        applied: names followed by an argument in brackets, or called functions.
        bare: names that occur without a bracket behind them.
        sequences: letters whose subscripts are indices.
        indices: letters that are indices, or bound by sums, elsewhere.
        functions: names that the text calls functions.
        inverses: whether ``\\sin^{-1}`` is the inverse function.
    """

    numbers: frozenset[str] = frozenset()
    applied: frozenset[str] = frozenset()
    bare: frozenset[str] = frozenset()
    sequences: frozenset[str] = frozenset()
    indices: frozenset[str] = frozenset()
    functions: frozenset[str] = frozenset()
    inverses: bool = False


@dataclass
class Chapter:
    """The evidence on the symbols of one chapter.

    Attributes:
        found: the evidence, by symbol.
        applied: names followed by an argument in brackets, with the line.
        bare: names that occur without a bracket behind them.
        sequences: letters whose subscripts are indices.
        indices: letters that are indices, or bound by a sum or a product.
        inverses: whether it mentions inverse trigonometric functions.
        intervals: letters that the text calls intervals, from there on.
    """

    found: dict[Key, list[Evidence]] = field(default_factory=dict)
    applied: dict[str, int] = field(default_factory=dict)
    bare: set[str] = field(default_factory=set)
    sequences: dict[str, Evidence] = field(default_factory=dict)
    indices: set[str] = field(default_factory=set)
    inverses: bool = False
    intervals: set[str] = field(default_factory=set)


class Kinds:
    """The kinds of the symbols of a manuscript."""

    def __init__(self, events: Sequence[Event]) -> None:
        self.chapters: list[Chapter] = [Chapter()]
        self.chapter_of: list[int] = []
        self.section_of: list[int] = []
        section = 0
        for place, event in enumerate(events):
            if isinstance(event, Section):
                section += not event.inner
                if event.chapter and place:
                    self.chapters.append(Chapter())
            self.chapter_of.append(len(self.chapters) - 1)
            self.section_of.append(section)
            if isinstance(event, Prose):
                self._words(event.text, event.file, event.line, place)
                for formula in prose.INLINE.finditer(event.text):
                    line = event.line + event.text.count("\n", 0, formula.start())
                    tex = formula[1] or formula[2]
                    self._formula(tex, event.file, line, place, False)
            elif isinstance(event, Display):
                for words in _DECLARED_IN_TEXT.finditer(event.text):
                    self._words(words[1], event.file, event.line, place)
                self._formula(event.text, event.file, event.line, place, True)

    def _words(self, text: str, file: str, line: int, place: int) -> None:
        """Collect the evidence in a text."""
        self.chapters[-1].inverses |= bool(INVERSES.search(text))
        self.chapters[-1].intervals |= intervals_in(text)
        for found in declared(text):
            at = line + text.count("\n", 0, found.at)
            for tex in found.formulas:
                evidence = self._evidence(found.kind, found.words, file, at, place, True)
                for key in _named(tex, found.kind):
                    if found.kind == SET and found.loosely and not key[0][0].isupper():
                        continue  # "in 1-D space ($\\xi$)", "the field $b$"
                    onward = found.kind == COMPLEX and not found.loosely
                    onward = onward and key[0] not in ("z", "w")
                    local = not onward and _is_local(found.kind, key)
                    self._add(key, replace(evidence, local=local, onward=onward))

    def _formula(self, tex: str, file: str, line: int, place: int, display: bool) -> None:
        """Collect the evidence in the notation of a formula."""
        try:
            tokens = tokenize(without_upright(tex))
        except InputError:
            return
        found = list(mentions(tokens))
        chapter = self.chapters[-1]
        for kind, one, words in declared_by_notation(tokens, found, chapter.intervals):
            said = kind in (REAL, INTEGER)
            evidence = self._evidence(kind, words, file, line, place, said)
            self._add(_key(one), replace(evidence, local=_is_local(kind, _key(one))))
        for kind, one, words in noted(tokens, found, display):
            evidence = self._evidence(kind, words, file, line, place, False)
            self._add(_key(one), replace(evidence, local=True))
        for letter, words in sequences(tokens, found):
            evidence = self._evidence(SEQUENCE, words, file, line, place, False)
            chapter.sequences.setdefault(letter, evidence)
        chapter.indices |= indices(tokens, found)
        applied, bare = applied_and_bare(tokens, found)
        for name in applied:
            chapter.applied.setdefault(name, line)
        chapter.bare |= bare

    def _evidence(
        self, kind: str, words: str, file: str, line: int, place: int, said: bool
    ) -> Evidence:
        words = " ".join(words.split())
        short = words if len(words) <= 80 else words[:77] + "..."
        return Evidence(kind, short, line, file, place, self.section_of[place], said)

    def _add(self, key: Key, evidence: Evidence, chapter: int = -1) -> None:
        self.chapters[chapter].found.setdefault(key, []).append(evidence)

    def settle(self, names: str, kind: str, words: str, line: int, place: int) -> None:
        """Set the kind of symbols by a directive, to the end of the chapter."""
        evidence = Evidence(kind, words, line, "", place, -1, True)
        for one in mentions(tokenize(names)):
            self._add(_key(one), evidence, self.chapter_of[place])

    def spread(self, left: Sequence[str], right: Sequence[str], place: int, line: int) -> None:
        """Record that a symbol equal to an expression with a non-real one may be non-real."""
        head = _lone(left)
        plain = all(t in _ALGEBRA or t[0].isdigit() or t.lstrip("\\").isalnum() for t in right)
        if head is None or not plain or "(" in right:
            return
        for one in mentions(right):
            of = self.at(one, place)
            if of is not None and of.kind not in READ and of.words:  # not by its accent alone
                words = f"{' '.join(left)} = {' '.join(right)}"
                self._add(
                    _key(head),
                    replace(self._evidence(of.kind, words, "", line, place, False), local=True),
                    self.chapter_of[place],
                )
                return

    def at(self, one: Mention, place: int) -> Evidence | None:
        """Return the evidence for a symbol's kind at a place; None if it is real by default."""
        chapter = self.chapters[self.chapter_of[place]]
        letter, accent, below = _key(one)
        found = [*chapter.found.get((letter, accent, below), ())]
        if below:
            bare = chapter.found.get((letter, accent, ""), ())
            found += (e for e in bare if e.kind in _OF_ALL_SUBSCRIPTS and letter[0].isupper())
        if not found:
            return _weak(one)
        settled = [e for e in found if e.section == -1 and e.place <= place]
        if settled:
            return max(settled, key=lambda e: e.place)
        section = self.section_of[place]
        found = [
            e
            for e in found
            if e.section == section or not (e.local or (e.onward and e.place > place))
        ]
        here = [e for e in found if e.said and e.section == section]
        before = [e for e in here if e.place <= place]
        latest = max(before, key=lambda e: e.place) if before else None
        if latest is not None and latest.kind in (REAL, INTEGER):
            return latest
        against = [e for e in found if e.kind not in (REAL, INTEGER)]
        if against:
            strange = [e for e in against if e.kind not in READ]
            near = [e for e in strange or against if e.section == section]
            return (near or strange or against)[0]
        return latest or here[0] if here else _weak(one) or next(iter(found), None)

    def against_link(
        self, left: list[str], op: str, right: list[str], place: int, words: str = ""
    ) -> str:
        """Return which symbol of a link is not a real number, as a reason; ``""`` if none is.

        Args:
            left, op, right: the tokens of its sides, and its relation.
            place: the index of the event in which it stands.
            words: the sentence around the display.
        """
        head = _lone(left) if RELATIONS.get(op) == "==" else None
        if head is None or self.at(head, place) != _weak(head) or _weak(head) is None:
            return self.against([*left, op, *right], place, words)
        why = self.against(right, place, words)
        if not why and head.name not in {one.name for one in mentions(right)}:
            given = self._evidence(REAL, " ".join([*left, op, *right]), "", 0, place, True)
            self._add(_key(head), given, self.chapter_of[place])
        return why

    def against(self, tokens: list[str], place: int, words: str = "") -> str:
        """Return which symbol of a formula is not a real number, as a reason; ``""`` if none is."""
        found = list(mentions(tokens))
        for one in found:
            evidence = self.at(one, place)
            if evidence is not None and evidence.kind not in READ:
                line = f" ({evidence.where})" if evidence.words else ""
                return f"{one.shown} is {evidence.kind}{line}; {ONLY}"
        for one, kind, word in _spoken_of(found, words, tokens):
            own = self.at(one, place)
            if own is None or own.section != self.section_of[place] or not own.said:
                return f"{one.shown} is {kind} ('{word}'); {ONLY}"
        return doubts(tokens, found, lambda one: self.is_real(one, place))

    def known(self, tokens: Sequence[str], place: int) -> tuple[tuple[str, str, str], ...]:
        """Return the symbols of a formula, each with its kind and the evidence for it."""
        found: dict[str, tuple[str, str, str]] = {}
        chapter = self.chapters[self.chapter_of[place]]
        for one in mentions(list(tokens)):
            if one.letter in ("O", "o") and list(tokens[one.end : one.end + 1]) == ["("]:
                continue  # an order is no symbol
            evidence = self.at(one, place)
            if evidence is None and one.is_index and not one.accent:
                evidence = chapter.sequences.get(one.letter)
            if evidence is None and one.name in chapter.applied:
                line = f"line {chapter.applied[one.name]}: '{one.shown}(...)'"
                found[one.name] = (one.shown, f"{REAL} or {FUNCTION}", line)
                continue
            kind = REAL if evidence is None else evidence.kind
            words = evidence.where if evidence is not None and evidence.words else ""
            found[one.name] = (one.shown, kind, words)
        return tuple(found.values())

    def uses(self, tokens: Sequence[str], place: int) -> Uses:
        """Return how the names of a formula are used, for the LaTeX parser."""
        tokens = list(tokens)
        found, chapter = list(mentions(tokens)), self.chapters[self.chapter_of[place]]
        kinds = {one.name: self.at(one, place) for one in found}
        said = {n for n, e in kinds.items() if e is not None and e.kind == FUNCTION and e.said}
        counts = {"\\sum", "\\prod", "\\lim"} & {*tokens}
        numbered = {
            one.letter
            for one in found
            if one.is_index and not one.accent and (counts or one.subscript not in _NAMES_BELOW)
        }
        return Uses(
            frozenset(n for n, e in kinds.items() if e is not None and e.kind in (REAL, INTEGER)),
            frozenset(chapter.applied.keys() | said),
            frozenset(chapter.bare),
            frozenset(numbered & self.sequences(place)),
            frozenset(chapter.indices & kinds.keys()),
            frozenset(said),
            chapter.inverses,
        )

    def sequences(self, place: int) -> set[str]:
        """Return the letters of the sequences of a chapter."""
        chapter = self.chapters[self.chapter_of[place]]
        said = {k[0] for k, found in chapter.found.items() for e in found if e.kind == SEQUENCE}
        return said | chapter.sequences.keys()

    def is_real(self, one: Mention, place: int) -> bool:
        """Whether the text calls a symbol a number."""
        evidence = self.at(one, place)
        return evidence is not None and evidence.kind in (REAL, INTEGER)


def _lone(tokens: Sequence[str]) -> Mention | None:
    """Return the symbol that the tokens consist of; None if they are more than one symbol."""
    found = list(mentions(tokens))
    return (
        found[0] if len(found) == 1 and (found[0].start, found[0].end) == (0, len(tokens)) else None
    )


def _key(one: Mention) -> Key:
    below = "an index" if one.is_index else "".join(one.subscript)
    return one.letter, one.accent, below


def _is_local(kind: str, key: Key) -> bool:
    """Whether evidence counts in its section only."""
    letter, accent, _ = key
    if kind in READ:
        return False
    kept = letter in ("z", "w") if kind == COMPLEX else letter[0].isupper() or bool(accent)
    return not kept


def _weak(one: Mention) -> Evidence | None:
    """Return the evidence in the accent of a symbol, such as ``\\hat``."""
    if one.accent in ("hat", "widehat", "mathfrak"):
        return Evidence(f"{UNKNOWN}, by its \\{one.accent}", "", 0)
    return None


def _named(tex: str, kind: str) -> Iterator[Key]:
    """Yield the symbols of a formula that the words around it name: the first, or all of a list."""
    try:
        tokens = tokenize(without_upright(tex))
    except InputError:
        return
    stop = next((n for n, t in enumerate(tokens) if t in RELATIONS or t in (":", "\\colon")), None)
    head = tokens[: len(tokens) if stop is None else stop]
    found = list(mentions(head))
    first = next((n for n, t in enumerate(head) if t not in STYLES and t != "{"), 0)
    opens = bool(found) and found[0].start == first
    if kind == SEQUENCE:
        chosen = found[:1]
    elif opens and "," in head and "(" not in head:
        chosen = found
    elif stop is not None and tokens[stop] not in _NAMING_RELATIONS and kind not in (REAL, INTEGER):
        chosen = []
    elif opens and (stop is not None or kind in (REAL, INTEGER) or "(" in head):
        chosen = found[:1]
    elif {*head} & {"(", "[", "\\{", "|"}:
        chosen = []
    else:
        capitals = [one for one in found if one.letter[0].isupper() or one.accent]
        chosen = capitals or (found[:1] if opens else [])
    yield from dict.fromkeys(map(_key, chosen))


def _spoken_of(
    found: Sequence[Mention], words: str, tokens: Sequence[str]
) -> Iterator[tuple[Mention, str, str]]:
    """Yield symbols that a sentence describes without naming them, with kinds and words."""
    named = {
        letter for d in declared(words) for tex in d.formulas for letter, *_ in _named(tex, d.kind)
    }
    for kind, word, several in of_sentence(words):
        capitals = [one for one in found if one.letter[0].isupper() or one.accent]
        every = several and (kind in (VECTOR, COMPLEX) or not capitals)
        for one in found if every else capitals:
            if one.letter not in named:
                yield one, kind, word
    spoken = prose.INLINE.sub(" ", words)
    if match := OF_BARS.search(spoken):
        for one in found:
            between = *tokens[one.start - 1 : one.start], *tokens[one.end : one.end + 1]
            if one.letter[0].isupper() and len(between) == 2 and all("|" in t for t in between):
                yield one, UNKNOWN, match[0]
    for pattern, letter in SPEAKERS:
        for one in found:
            change = letter == "Delta" and is_letter("".join(tokens[one.end : one.end + 1]))
            if one.letter == letter and not change and (match := pattern.search(spoken)):
                yield one, "an operator", match[0]
