"""Change the text of a claim at one place, as by a slip of the pen.

What a claim says is cut into the expressions between its relations, commas and words; each is
changed by the edits that the repair of claims tries (:mod:`tresym.repair.edits`): a sign, a number,
an exponent, a function, a variable, a factor. Relations are turned round, conditions are left out
or changed, and of printed decimals a digit or the unit is changed::

    sin(x) <= x given x > 0     cos(x) <= x given x > 0     place "side 1"
                                sin(x) >= x given x > 0     place "relation"
                                sin(x) <= x                 place "conditions"
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain, zip_longest
from typing import Any, NamedTuple, TypeVar
from zlib import crc32

from tresym.papers.changed_lines import Line
from tresym.reals.language.brackets import closing, places, split
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import MIRRORED
from tresym.reals.numbers.exact import InputError
from tresym.repair.edits import RELATIONS, changes

T = TypeVar("T")
_SIGN = r"(?<![<>=!~:-])(?:==|<=|>=|!=|~=|<|>)(?![=<>])"
_WORDS = r"\b(?:and|given|in|along|within|exactly|at\s+most|at\s+least|one|stable|unstable)\b"
_APART = rf":=|<=>|\biff\b|{_SIGN}|->|[,;:']|{_WORDS}"
_REASON = re.compile(r"\s+\[[^\[\]]*\]\s*$")
_DECIMAL = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
SHORT = 60
"""Characters of the longest expression that is quoted whole where it is changed."""


class Span(NamedTuple):
    """A piece of a text."""

    start: int
    end: int

    def of(self, text: str) -> str:
        """Return the piece."""
        return text[self.start : self.end]

    def replaced(self, text: str, new: str) -> str:
        """Return the text with the piece replaced."""
        return text[: self.start] + new + text[self.end :]


@dataclass(frozen=True)
class Slip:
    """A line with one change.

    Attributes:
        old: what stood at the place.
        new: what stands there now.
        text: what the changed line says.
        step: what the line says with the changed step of its derivation alone; "" if it is none.
        conditions: conditions with a name that are changed instead.
    """

    old: str
    new: str
    text: str
    step: str = ""
    conditions: Mapping[str, tuple[Any, ...]] = field(default_factory=dict)

    @property
    def says(self) -> str:
        """The change in words."""
        return f"{self.new or 'nothing'} in place of {self.old or 'nothing'}"


class Place(NamedTuple):
    """A place of a line, and the slips that may be made there, the likeliest first."""

    name: str
    slips: Iterable[Slip]


def slips(line: Line) -> list[Place]:
    """Return the places of a line that can be changed, each with its slips."""
    text = line.text
    behind = {word: span for word, _, span in _clauses(line, text)}
    given = behind.get("given")
    written = [
        *_stages(text, Span(0, _formula_end(line))),
        *([] if given is None else [_Stage(given)]),
    ]
    pieces = [(stage, span) for stage in written for span in _pieces(line, stage.span)]
    names = sorted({*chain.from_iterable(symbols(e) for e in _read(line, pieces))} - {"oo"})
    found: list[Place] = []
    inside: list[Iterable[Slip]] = []
    for stage, span in pieces:
        made = _edited(line, stage, span, names)
        if stage.span == given:
            inside.append(made)
        else:
            found.append(Place(f"{stage.name} {len(found) + 1}", made))
    relations = [_turned(text, stage) for stage in written if stage.span != given]
    found.append(Place("relation", in_turn(relations)))
    if given is not None:
        inside += (_turned(text, _Stage(side)) for side in _cut(text, given, _SIGN)[1:])
        found.append(Place("conditions", sorted(_dropped(line, given), key=_mixed)))
        found.append(Place("condition", in_turn(inside)))
    return found


def in_turn(many: Iterable[Iterable[T]]) -> Iterator[T]:
    """Yield one item of each in turn."""
    for row in zip_longest(*many):
        yield from (item for item in row if item is not None)


class _Stage(NamedTuple):
    """A side of a comparison, or a statement of an equivalence."""

    span: Span
    name: str = "side"
    before: str = ""
    """What a step in the middle of a derivation follows from, with the sign between them."""


def _clauses(line: Line, text: str) -> list[tuple[str, int, Span]]:
    """Return the word of each clause of a text of the line, where it begins, and what follows."""
    begin = places(f"{text} ", line.clause)
    ends = [*(first for first, _ in begin[1:]), len(text)]
    return [
        (text[first:start].strip(), first, Span(start, start + len(text[start:end].rstrip())))
        for (first, start), end in zip(begin, ends, strict=False)
    ]


def _formula_end(line: Line) -> int:
    """Return where the clauses of a line begin."""
    clauses = _clauses(line, line.text)
    return clauses[0][1] if clauses else len(line.text)


def without(line: Line, text: str, *words: str) -> str:
    """Return a text of the line without some of its clauses."""
    for word, first, span in reversed(_clauses(line, text)):
        if word in words:
            text = text[:first] + text[span.end :]
    return text


def _stages(text: str, formula: Span) -> Iterator[_Stage]:
    """Yield the sides of each part; what stands inside of a derivation is one of its steps."""
    for part in _cut(text, formula, r"\band\b"):
        arrows = _cut(text, part, r"<=>|\biff\b")
        sides = arrows if arrows[1:] else _cut(text, part, _SIGN)
        sign = "<=>" if arrows[1:] else "=="
        for n, side in enumerate(sides):
            if 0 < n < len(sides) - 1:
                before = _REASON.sub("", sides[n - 1].of(text).strip())
                yield _Stage(side, "step", f"{before} {sign} ")
            else:
                yield _Stage(side)


def _cut(text: str, span: Span, pattern: str) -> list[Span]:
    """Cut a piece where a pattern matches outside of all brackets."""
    found, start = [], span.start
    for first, end in places(span.of(text), pattern):
        found.append(Span(start, span.start + first))
        start = span.start + end
    return [*found, Span(start, span.end)]


def _pieces(line: Line, span: Span) -> Iterator[Span]:
    """Yield the expressions in a piece; where it is none, those in its brackets."""
    for each in _cut(line.text, span, _APART):
        piece = _trimmed(line.text, each)
        text = piece.of(line.text)
        is_name = line.text[each.end :].startswith(":=") or line.conditions(text)
        if not text or is_name:
            continue
        if _tree(line, text) is not None:
            yield piece
            continue
        for n, sign in enumerate(text):
            if sign == "(" and text[:n].count("(") == text[:n].count(")"):
                end = closing(text[n:])
                if end is not None:
                    at = piece.start + n
                    yield from _pieces(line, Span(at + 1, at + end))


def _trimmed(text: str, span: Span) -> Span:
    """Return the piece without blanks, and without words in brackets behind it."""
    piece = span.of(text)
    reason = _REASON.search(piece)
    end = span.start + (reason.start() if reason else len(piece.rstrip()))
    return Span(min(span.start + len(piece) - len(piece.lstrip()), end), end)


def _tree(line: Line, text: str) -> Expr | None:
    try:
        return line.above.parsed(text)
    except InputError:
        return None


def _read(line: Line, pieces: Iterable[tuple[_Stage, Span]]) -> Iterator[Expr]:
    for _, span in pieces:
        tree = _tree(line, span.of(line.text))
        if tree is not None:
            yield tree


def _edited(line: Line, stage: _Stage, span: Span, names: list[str]) -> Iterator[Slip]:
    """Yield the edits of an expression, of each rank in turn."""
    text, old = line.text, span.of(line.text)
    if text[: span.start].rstrip().endswith("~=") and _DECIMAL.fullmatch(old):
        for new in chain(moved_digits(old), other_units(old)):
            yield Slip(old, new, span.replaced(text, new))
        return
    tree = _tree(line, old)
    ranks: dict[int, list[tuple[float, int, str, str, str]]] = {}
    for change in changes(tree, names) if tree is not None else ():
        new = line.above.printed(change.tree)
        key = crc32(f"{line.label} {new}".encode())
        ranks.setdefault(int(change.rank), []).append(
            (round(change.rank, 1), key, new, change.old, change.new)
        )
    seen = {old} if tree is None else {old, line.above.printed(tree)}
    for row in zip_longest(*(sorted(ranks[rank]) for rank in sorted(ranks))):
        for _, _, new, was, now in filter(None, row):
            if new in seen:
                continue
            seen.add(new)
            whole = span.replaced(text, f"({new})" if _needs_brackets(text, span) else new)
            step = ""
            if stage.before:
                within = Span(span.start - stage.span.start, span.end - stage.span.start)
                step = stage.before + within.replaced(stage.span.of(text), new).strip()
                step += f" {text[_formula_end(line) :]}"
            if max(len(old), len(new)) <= SHORT:
                was, now = old, new
            yield Slip(was, now, whole, step)


def _needs_brackets(text: str, span: Span) -> bool:
    """Whether a factor or a power stands beside the piece, such as a product of matrices."""
    beside = text[: span.start].rstrip()[-1:] + text[span.end :].lstrip()[:1]
    return bool(re.search(r"[*/+^-]", beside))


def _turned(text: str, stage: _Stage) -> Iterator[Slip]:
    """Yield the text with the relation before a side turned round, and made strict or not."""
    before = text[: stage.span.start]
    match = re.search(rf"({_SIGN})$", before)
    if match is None:
        return
    old = match[1]
    for new in sorted(RELATIONS.get(old, ()), key=lambda sign: sign != MIRRORED.get(old)):
        changed = f"{before[: match.start()]}{new}{text[stage.span.start :]}"
        yield Slip(old, new, changed)


def _mixed(slip: Slip) -> int:
    return crc32(slip.says.encode())


def _dropped(line: Line, given: Span) -> Iterator[Slip]:
    """Yield the line without one of its conditions, those behind a name one by one."""
    text = line.text
    parts = [part.strip() for part in split(given.of(text), ",")]
    for n, part in enumerate(parts):
        behind = line.conditions(part)
        for k, condition in enumerate(behind if len(behind) > 1 else ()):
            others = {part: (*behind[:k], *behind[k + 1 :])}
            yield Slip(f"{condition} of {part}", "", text, conditions=others)
        rest = ", ".join((*parts[:n], *parts[n + 1 :]))
        new = given.replaced(text, rest) if rest else without(line, text, "given")
        yield Slip(part, "", new.strip())


# Printed decimals


def other_units(text: str) -> Iterator[str]:
    """Yield the same digits in a unit ten times as large or as small."""
    digits, _, exponent = text.lower().partition("e")
    yield from (f"{digits}e{int(exponent or 0) + by}" for by in (1, -1, 3, -3))


def moved_digits(text: str) -> Iterator[str]:
    """Yield variants of a decimal: each digit changed by one, the sign, then larger changes."""
    at = [n for n, c in enumerate(text.lower().partition("e")[0]) if c.isdigit()]
    for by in range(1, 10):
        for n in reversed(at):
            for moved in (int(text[n]) + by, int(text[n]) - by):
                if 0 <= moved <= 9:
                    yield f"{text[:n]}{moved}{text[n + 1 :]}"
        if by == 1:
            yield text[1:] if text.startswith("-") else "-" + text
