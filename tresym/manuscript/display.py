"""A display taken apart: its rows and cells, the statements in them, and the terms of each chain.

Terms stay lists of tokens here and are not parsed, so one that cannot be read does not affect the
others.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from tresym.manuscript.display_text import AND, FORALL, GAP, OR, OTHERWISE, WORDS, prepared
from tresym.reals.language.latex_tokens import (
    CONDITION,
    RELATIONS,
    Spaced,
    tokenize,
    with_sign,
)
from tresym.reals.numbers.exact import InputError

MAX_RELATIONS = 500
ARROWS = frozenset(
    (
        *(
            "\\Rightarrow",
            "\\Longrightarrow",
            "\\implies",
            "\\impliedby",
            "\\leadsto",
            "\\therefore",
        ),
        *("\\iff", "\\Leftrightarrow", "\\Longleftrightarrow", "\\because"),
    )
)
STRANGE = frozenset(
    (
        *("\\propto", "\\cong", "\\subset", "\\subseteq", "\\gtrsim", "\\lesssim", "\\asymp"),
        *("\\perp", "\\parallel", "\\notin", "\\longrightarrow", "\\xrightarrow"),
        *("\\mapsto", "\\longmapsto", "\\questioned"),
    )
)
"""Relations that are recognised, but not supported."""
_TWO = ["_", "{", "1", ",", "2", "}"]
_STOPS = frozenset((",", ";", ".", AND, OR, GAP, CONDITION)) | ARROWS
_NESTED = frozenset(
    ("aligned", "alignedat", "gathered", "split", "array", "cases", "dcases", "rcases", "multlined")
)
_CASES = frozenset(("cases", "dcases", "rcases"))
_OPEN, _CLOSE = (
    frozenset(("(", "[", "{", "\\{", "\\langle")),
    frozenset(")]}") | {"\\}", "\\rangle"},
)
_IN_VALUES = frozenset(("-", "\\ldots", "\\pm", "\\mp", "\\pi", "\\frac", "\\tfrac", "{", "}", "/"))
_OPERATORS = frozenset(("+", "-", "\\pm", "\\mp", "\\cdot", "\\times", "*", "/"))


@dataclass(frozen=True)
class Said:
    """A chain of terms, as tokens: ``terms[0] ops[0] terms[1] …``.

    Attributes:
        ops: the relations as they are written.
        before: the arrow or word before it, such as ``\\implies`` or ``or``.
        values: further values after commas, as in ``n = 0, 1, 2``.
        conditions: conditions stated with a word such as "for".
        words: the upright text in it.
        remarks: the number of texts behind it that are not understood and may be conditions.
        universal: whether it is stated "for all".
        row: the row of the display in which it ends, from 0.
        opens: whether it begins in the first column of its row.
        worked: whether its terms are components that were calculated.
    """

    terms: tuple[tuple[str, ...], ...]
    ops: tuple[str, ...] = ()
    before: str = ""
    values: tuple[tuple[str, ...], ...] = ()
    conditions: tuple[Said, ...] = ()
    words: tuple[str, ...] = field(default=())
    remarks: int = 0
    universal: bool = False
    row: int = 0
    opens: bool = False
    worked: bool = False

    @property
    def tokens(self) -> tuple[str, ...]:
        """All tokens of the chain, in order."""
        found = [*self.terms[0]]
        for op, term in zip(self.ops, self.terms[1:], strict=True):
            found += [op, *term]
        return tuple(found)

    @property
    def either(self) -> bool:
        """Whether only one side begins with ``\\pm`` or ``\\mp``: ``\\cos x = \\pm\\sqrt{…}``."""
        signs = {"\\pm", "\\mp"}
        leads = [bool(signs & {*term[:1]}) for term in self.terms]
        inside = any(signs & {*term[1:]} for term in self.terms)
        return not inside and any(leads) and not all(leads)

    def signed(self, sign: str) -> Said:
        """Return the chain with this sign for ``\\pm``; for +, ``x_{1,2}`` becomes x_1."""
        terms = (_one_of_two(list(term), "1" if sign == "+" else "2") for term in self.terms)
        return replace(self, terms=tuple(tuple(with_sign(term, sign)) for term in terms))


def _one_of_two(tokens: list[str], which: str) -> list[str]:
    at = next((n for n in range(len(tokens)) if tokens[n : n + 6] == _TWO), -1)
    return tokens if at < 0 else [*tokens[: at + 1], which, *_one_of_two(tokens[at + 6 :], which)]


def statements(text: str) -> list[Said]:
    """Return the chains of a display, in order.

    Raises:
        InputError: an environment is not closed, or the display is too long.
    """
    words: list[str] = []
    tokens = tokenize(prepared(text, words), frozenset({"hot"}))
    if sum(token in RELATIONS for token in tokens) > MAX_RELATIONS:
        raise InputError(
            f"the display has more than {MAX_RELATIONS} signs such as = or <; split it"
        )
    found: list[Said] = []
    for cell in _rows(tokens):
        chains = _chains(cell.tokens)
        found += (replace(c, row=cell.row, opens=cell.opens and c is chains[0]) for c in chains)
    if WORDS in tokens:
        found = list(_with_words(found, words))
    return [chain for chain in found if chain.ops or any(chain.terms)]


def _with_words(found: list[Said], words: list[str]) -> Iterator[Said]:
    left = iter(words)

    def named(chain: Said) -> Said:
        count = chain.tokens.count(WORDS) + sum(v.count(WORDS) for v in chain.values)
        count += chain.remarks
        own = tuple(next(left, "") for _ in range(count))
        return replace(chain, words=own, conditions=tuple(map(named, chain.conditions)))

    return map(named, found)


def _environment(token: str) -> str:
    return token[token.index("{") + 1 : -1].rstrip("*") if "{" in token else ""


def _levels(tokens: list[str]) -> Iterator[tuple[int, str, int]]:
    """Yield each token with its index and its depth in brackets and environments."""
    depth = 0
    for n, token in enumerate(tokens):
        if token in _CLOSE or token.startswith("\\end{"):
            depth = max(depth - 1, 0)
        yield n, token, depth
        if token in _OPEN or token.startswith("\\begin{"):
            depth += 1


class _Cell(NamedTuple):
    """The tokens of a statement, the row it ends in, and whether it begins in the first column."""

    tokens: list[str]
    row: int = 0
    opens: bool = False


def _rows(tokens: list[str]) -> list[_Cell]:
    """Return the statements of a display: one per cell, unless a cell continues another."""
    tokens = _unwrapped(tokens)
    tokens = _without_brace(tokens)
    start = next((n for n, t, d in _levels(tokens) if d == 0 and t.startswith("\\begin{")), None)
    if start is not None:
        name = _environment(tokens[start])
        end = _end_of(tokens, start)
        if name in _CASES and start:
            return _cases(tokens, start, end)
        if name in _NESTED:
            inner, rest = _body(tokens[start + 1 : end], name), tokens[end + 1 :]
            if _relation_in(rest) and rest[0] in (",", GAP, CONDITION):  # it applies to all rows
                rest = ["\\\\", "&", *rest]
            return _rows([*tokens[:start], *inner, *rest])
    cells: list[_Cell] = []
    heads: dict[int, list[str]] = {}
    columns: list[int] = []
    rows = _split(tokens, "\\\\")
    for n, row in enumerate(rows):
        raw = _split(row, "&")
        split = [_without_gaps(cell) for cell in raw]
        heading = [cell[:1] == [CONDITION] for cell in split if cell]
        if all(heading) and len(heading) > bool(cells) and any(rows[1:]):
            heads = {n: [t for t in cell if t != ":"] for n, cell in enumerate(split) if cell}
            continue
        for column, cell in enumerate(split):
            if not cell:
                continue
            after = split[column + 1] if column + 1 < len(split) else []
            own = _of_column(cells, columns, column, n) if cell[0] in RELATIONS else -1
            if own >= 0:  # it goes on below its own equation, of several beside each other
                cells[own] = _Cell(cells[own].tokens + cell, n, cells[own].opens)
            elif column and raw[column - 1][-1:] == [GAP] and _begins_anew(cells, cell):
                cells.append(_Cell(cell, n, column == 0))
                columns.append(column)
            elif cells and _goes_on(cells[-1].tokens, cell, after, column, row):
                cells[-1] = _Cell(cells[-1].tokens + cell, n, cells[-1].opens)
            else:
                cells.append(_Cell(cell, n, column == 0))
                columns.append(column)
    pairs = zip(cells, columns, strict=True)
    return [cell._replace(tokens=cell.tokens + heads.get(c, [])) for cell, c in pairs]


def _begins_anew(cells: list[_Cell], cell: list[str]) -> bool:
    """Whether a cell behind a gap begins a statement, as the one before it is complete."""
    complete = bool(cells) and _relation_in(cells[-1].tokens)
    return complete and (cell[0][:1].isalnum()) and cell[0] != CONDITION


def _of_column(cells: list[_Cell], columns: list[int], column: int, row: int) -> int:
    """Return which statement of several in one row a cell goes on, by its column; -1 if that is
    the last one."""
    last = cells[-1].row if cells else row
    if last >= row and not any(cell.row < row for cell in cells):
        return -1
    first = max((cell.row for cell in cells if cell.row < row), default=-1)
    beside = [k for k, cell in enumerate(cells) if cell.row in (first, row)]
    of_pair = [k for k in beside if columns[k] // 2 == column // 2]
    if len({columns[k] // 2 for k in beside}) < 2 or not of_pair or of_pair[-1] == len(cells) - 1:
        return -1
    return of_pair[-1]


_SIGNS = frozenset(("-", "\\pm", "\\mp"))
"""What an equation may begin with; one that begins with + goes on from the line before."""


def _goes_on(
    before: list[str], cell: list[str], after: list[str], column: int, row: list[str]
) -> bool:
    """Whether a cell continues the statement before it."""
    if cell[0] in RELATIONS or cell[0] in STRANGE:
        return True
    if before[-1] in _OPERATORS or before[-1] in RELATIONS:
        return True
    starts = after[:1] and after[0] in RELATIONS and _relation_in(before)
    if cell[0] in _OPERATORS:  # an equation begins in an even column of an align
        alone = column == 0 and _relation_in(row) and _relation_in(before) and cell[0] in _SIGNS
        return not (starts and column % 2 == 0) and not alone
    return column > 0 and not starts and not _relation_in(cell) and cell[0] != CONDITION


def _without_brace(tokens: list[str]) -> list[str]:
    """Return the tokens without a left brace whose right partner is invisible."""
    starts = [
        n
        for n in range(len(tokens) - 1)
        if tokens[n] == "\\{" and tokens[n + 1].startswith("\\begin{")
    ]
    for n in reversed(starts):
        end = _end_of(tokens, n + 1)
        if tokens[end + 1 : end + 2] == ["\\right."]:
            tokens = [*tokens[:n], *tokens[n + 1 : end + 1], *tokens[end + 2 :]]
    return tokens


def _without_gaps(cell: list[str]) -> list[str]:
    while cell[:1] == [GAP]:
        cell = cell[1:]
    while cell[-1:] == [GAP]:
        cell = cell[:-1]
    return cell


def _relation_in(tokens: list[str]) -> bool:
    return any(t in RELATIONS or t in STRANGE for _, t, depth in _levels(tokens) if depth == 0)


def _unwrapped(tokens: list[str]) -> list[str]:
    """Return the tokens without braces around everything."""
    tokens = _without_gaps(tokens)
    while tokens[:1] == ["{"] and tokens[-1] == "}":
        closing = next((n for n, t, d in _levels(tokens) if n and t == "}" and d == 0), -1)
        if closing != len(tokens) - 1:
            break
        tokens = _without_gaps(tokens[1:-1])
    return tokens


def _end_of(tokens: list[str], start: int) -> int:
    depth = 0
    for n in range(start, len(tokens)):
        depth += tokens[n].startswith("\\begin{")
        depth -= tokens[n].startswith("\\end{")
        if depth == 0:
            return n
    raise InputError(f"{tokens[start]} is not closed")


def _body(tokens: list[str], name: str) -> list[str]:
    if name == "array" and tokens[:1] == ["["]:
        tokens = tokens[tokens.index("]") + 1 :] if "]" in tokens else tokens
    if name in ("array", "alignedat") and tokens[:1] == ["{"]:
        end = next((n for n, t, d in _levels(tokens) if n and t == "}" and d == 0), 0)
        return tokens[end + 1 :]
    if tokens[:1] == ["["] and tokens[2:3] == ["]"]:
        return tokens[3:]
    return tokens


def _cases(tokens: list[str], start: int, end: int) -> list[_Cell]:
    """``f = \\begin{cases} g & x > 0 \\\\ … \\end{cases}``: a statement for each row."""
    head, rest = tokens[:start], _without_gaps(tokens[end + 1 :])
    if rest and rest[0] not in (".", ",", ";", CONDITION):
        raise InputError("something follows the cases")
    found: list[_Cell] = []
    for row in _split(tokens[start + 1 : end], "\\\\"):
        value, *when = (_without_gaps(cell) for cell in _split(row, "&"))
        while value[-1:] in ([","], [";"], ["."]):
            value = value[:-1]
        said = [t for cell in when for t in cell]
        if not value:
            continue
        marked = said if said[:1] == [CONDITION] or not said else [CONDITION, *said]
        found.append(_Cell([*head, *value, *marked], len(found)))
    return found


def _split(tokens: list[str], separator: str) -> list[list[str]]:
    parts: list[list[str]] = [[]]
    for _, token, depth in _levels(tokens):
        if token == separator and depth == 0:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _parts(tokens: list[str]) -> list[tuple[str, list[str]]]:
    """Return the parts between stops, each with the stop before it; gaps in brackets are spaces.

    A comma with a gap behind it is :class:`Spaced`.
    """
    parts: list[tuple[str, list[str]]] = [("", [])]
    spaced = False
    for n, token, depth in _levels(tokens):
        if (
            token in _STOPS
            and depth == 0
            and not (token == "." and n + 1 < len(tokens) and tokens[n + 1][:1].isdigit())
        ):
            before, here = parts[-1]
            if here or token not in (GAP, ","):
                parts.append((token if here or token != GAP else before, []))
            elif token == GAP and before == ",":
                parts[-1] = (Spaced(","), [])
        elif token == GAP:
            spaced = True
        else:
            parts[-1][1].append(Spaced(token) if spaced else token)
            spaced = False
    return [part for part in parts if part[1]]


def _chains(tokens: list[str]) -> list[Said]:
    """Return the chains of one row."""
    found: list[Said] = []
    pending: list[list[str]] = []
    ahead: list[Said] = []
    told: dict[int, tuple[Said, ...]] = {}
    under = colon = False
    for stop, part in _parts(tokens):
        while part[:1] == [WORDS] and stop == GAP and found and found[-1].ops and not pending:
            found[-1] = replace(found[-1], remarks=found[-1].remarks + 1)
            del part[0]
        if not part:
            continue
        if stop == CONDITION:
            under = True
        elif colon or stop in ARROWS or stop in (OR, ";", "."):
            under = False
        colon = under and part[-1] == ":" and len(part) > 1
        part = part[:-1] if colon else part
        part, inner = _without_bracket(part)
        if inner:
            behind = tuple(said for said in _chains(inner) if said.ops)
            if part:
                told[len(found)] = behind
            elif found:
                found[-1] = replace(found[-1], conditions=(*found[-1].conditions, *behind))
                continue
            else:
                ahead += behind
                continue
        chain = _chain(part)
        apart = stop == GAP or isinstance(stop, Spaced)
        if apart and "=" in chain.ops and len(chain.terms[0]) > 2:
            under = False  # a separate equality is a statement of its own
        if not chain.ops:
            if colon:
                continue
            if part == [FORALL]:
                found = [replace(one, universal=True) for one in found]
            elif found and under and (part == [OTHERWISE] or WORDS in part):
                found[-1] = replace(found[-1], conditions=(*found[-1].conditions, chain))
            elif stop in (GAP, "") and found and part[0] in _OPERATORS:
                found[-1] = _extended(found[-1], [part])
            elif found and found[-1].ops and stop == "," and _plain(part):
                found[-1] = replace(found[-1], values=(*found[-1].values, tuple(part)))
            else:
                pending.append(part)
            continue
        if not chain.terms[0] and (found or pending):
            if pending:
                chain = replace(chain, terms=(tuple(pending.pop()), *chain.terms[1:]))
            else:
                found[-1] = _extended(found[-1], chain.terms, chain.ops)
                continue
        several = [replace(chain, terms=(tuple(p), *chain.terms[1:])) for p in pending]
        if any(p[0][0].isdigit() for p in pending):  # a number with a comma, or a list
            several, chain = [], replace(chain, values=tuple(map(tuple, pending)))
        pending = []
        for one in (*several, chain):
            if under and found:
                found[-1] = replace(found[-1], conditions=(*found[-1].conditions, one))
            elif under:
                ahead.append(one)
            else:
                before = stop if stop in ARROWS or stop == OR else ""
                found.append(replace(one, before=before, conditions=tuple(ahead)))
    if found and found[-1].universal and under:  # "for all x"
        pending = [part for part in pending if len(part) > 1]
    found += [Said((tuple(part),)) for part in pending]
    for n, behind in told.items():
        if n < len(found):
            found[n] = replace(found[n], conditions=(*found[n].conditions, *behind))
    return found or ahead


def _without_bracket(part: list[str]) -> tuple[list[str], list[str]]:
    """Split off a bracket with a relation at the end of a part: ``a = b (x > 0)``."""
    if part[-1] not in (")", "]"):
        return part, []
    start = max((n for n, t, depth in _levels(part) if depth == 0 and t in ("(", "[")), default=-1)
    if start < 0 or not _relation_in(part[start + 1 : -1]):
        return part, []
    return part[:start], part[start + 1 : -1]


def _plain(part: list[str]) -> bool:
    """Whether a part is a value in a list, such as ``2`` or ``\\ldots``."""
    return all(t[0].isdigit() or t in _IN_VALUES or t[0] == "." for t in part)


def _extended(chain: Said, terms: Sequence[Sequence[str]], ops: tuple[str, ...] = ()) -> Said:
    first, *rest = terms
    joined = (*chain.terms[:-1], (*chain.terms[-1], *first), *map(tuple, rest))
    return replace(chain, terms=joined, ops=(*chain.ops, *ops))


def _chain(tokens: list[str]) -> Said:
    terms: list[list[str]] = [[]]
    ops: list[str] = []
    for _, token, depth in _levels(tokens):
        if depth == 0 and (token in RELATIONS or token in STRANGE):
            ops.append(str(token))
            terms.append([])
        else:
            terms[-1].append(token)
    return Said(tuple(map(tuple, terms)), tuple(ops))
