"""Claims made of claims: ``A and B``, ``A <=> B``, ``exactly one x in (0, 1): f == g``.

A claim is a comparison, or several of them joined by words. ``cos(x) <= 1 and sin(x) <= 1`` claims
both, ``exp(x) == 1 <=> x == 0`` that each follows from the other, ``at most one x in (0, 1): x**3
== a`` counts the solutions, and ``increasing(exp(x), x)`` speaks of all pairs of points. A vector
equation ``(x, y) == (f, g)`` claims its components, and ``at some point: x**2 == 2`` that such a
point exists. Claims about extrema and motions are read by
:mod:`tresym.reals.language.named_claims`. ``and`` binds more strongly than ``<=>``; what is said
after ``given``, ``as`` or ``on`` belongs to the whole claim, and to one part where brackets enclose
both: ``(1/x > 0 given x > 0) and (1/x < 0 given x < 0)``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias

from tresym.reals.language.brackets import closing, encloses, places, split
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.claims import Written, read_claim
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.named_claims import (
    WORDS,
    Conserved,
    Extremum,
    Named,
    begins_named,
    named_in_latex,
    named_text,
    names_of,
    read_named,
    sides_of,
)
from tresym.reals.language.parsing import as_written
from tresym.reals.language.paths import Path
from tresym.reals.language.typesetting import PLAIN, Printer, to_mathml
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.exact import InputError

SHAPES = ("increasing", "decreasing", "nondecreasing", "nonincreasing", "convex", "concave")
"""What can be said of a function on an interval, as in ``convex(exp(x), x)``."""
COUNTS = ("exactly one", "at most one", "at least one")
OWN_CONDITIONS = (
    "the parts of an equivalence have the same conditions: write A <=> B given CONDITIONS"
)

_LATEX_WORDS = (
    (re.compile(r"\\(?:iff|Leftrightarrow|Longleftrightarrow)(?![A-Za-z])"), " <=> "),
    (re.compile(r"\\(?:land|wedge)(?![A-Za-z])|\\text\{\s*and\s*\}"), " and "),
    (re.compile(r"[⟺⇔]"), " <=> "),
    (re.compile("∧"), " and "),
)
_HINT = re.compile(
    r"<=>|[⟺⇔∧]|\\iff|eftrightarrow|\\land|\\wedge|\b(?:and|iff)\b|&&|\bone\b|\bsome\s+point\b|"
    rf"\b(?:{'|'.join(SHAPES)})\b|^\s*\(|\(\s*\(|{WORDS}"
)
"""What a claim must contain to be made of others."""
_EQUIVALENT = r"<=>|\biff\b"
_AND = r"\band\b|&&"
_IMPLIES = r"(?<![<>=])==?>|\bimplies\b"
_RELATION = r"==|!=|<=(?!>)|>=|(?<![<>=!~:])=(?![=<>])|<(?!=)|(?<![-=])>(?!=)|~=?|->"
_TAIL = (
    r"\b(?:given|as|on|at(?=\s+[A-Za-z]\w*\s*=)|uniformly|if|for(?!\s+some\s+point\b)|forall|when|whenever|where|with|provided|assuming|suppose)"
    r"\b(?!\s*\()"
)
_BEGINS = re.compile(
    r"\s*(?:if|for(?!\s+some\s+point\b)|forall|given|when|where|let|suppose|assuming)\b"
)
_COUNT = re.compile(rf"({'|'.join(COUNTS)})\s+([A-Za-z]\w*)\s+in\s*([\[(])(.*)$", re.DOTALL)
_SOME = re.compile(r"(?:at|for)\s+some\s+point\s*:\s*(.*)$", re.DOTALL)
_SHAPE = re.compile(rf"({'|'.join(SHAPES)})\s*\((.*)\)\s*$", re.DOTALL)
_IN_WORDS = re.compile(
    rf"(.+?)\s+(?:is\s+)?({'|'.join(SHAPES)})\s+in\s+([A-Za-z]\w*)\s*$", re.DOTALL
)
_EULER = re.compile(r"(?<![\w.\\])e(?!\w)")


@dataclass(frozen=True)
class Together:
    """All of the parts are claimed."""

    parts: tuple[Any, ...]


@dataclass(frozen=True)
class Equivalent:
    """Each of the parts follows from each other one."""

    parts: tuple[Any, ...]


class Count(NamedTuple):
    """How many solutions an equation has in an interval.

    Attributes:
        how: one of :data:`COUNTS`.
        name: the unknown.
        low, high: the ends, which may be infinite.
        closed: whether each end belongs to the interval.
        equation: what is solved.
        given: the conditions on the other variables.
    """

    how: str
    name: str
    low: Expr
    high: Expr
    closed: tuple[bool, bool]
    equation: Compared
    given: tuple[Compared, ...]


class Shape(NamedTuple):
    """That a function of one variable is monotone or convex where the conditions hold.

    ``increasing`` and ``decreasing`` are meant strictly, ``convex`` and ``concave`` are not.
    """

    how: str
    function: Expr
    name: str
    given: tuple[Compared, ...]


class Somewhere(NamedTuple):
    """That all comparisons hold at one point of the conditions at least."""

    comparisons: tuple[Compared, ...]
    given: tuple[Compared, ...]


Leaf: TypeAlias = Written | Count | Shape | Somewhere | Named
Formula: TypeAlias = Leaf | Together | Equivalent


class Compound(NamedTuple):
    """A claim made of claims, each with all of its conditions.

    Attributes:
        formula: what is claimed.
        given: the conditions of the whole claim.
        path: its limit process.
        on: the region on which it is claimed.
        text: how it was written.
    """

    formula: Formula
    given: tuple[Compared, ...] = ()
    path: Path | None = None
    on: tuple[Compared, ...] = ()
    text: str = ""

    def __str__(self) -> str:
        text = shown(self.formula, self)
        text += f" given {chained(self.given)}" if self.given else ""
        text = text if self.path is None else f"{text} as {self.path}"
        return f"{text} on {chained(self.on)}" if self.on else text


def read_compound(claim: Any, given: Any = "", path: str | None = None) -> Compound | None:
    """Return a claim that is made of others; None for every other claim.

    Raises:
        InputError: the parts cannot be read, or do not belong together.

    Example:
        >>> str(read_compound("x > 0 and y > 0 given x > 1, y > 1"))
        'x > 0 and y > 0 given x > 1, y > 1'
        >>> read_compound("x > 0") is None
        True
    """
    if not isinstance(claim, str) or not _HINT.search(claim) or _BEGINS.match(claim):
        return None
    text = claim.strip().strip("$") if "\\" in claim else claim
    for pattern, word in _LATEX_WORDS:
        text = pattern.sub(word, text)
    head, tail = _cut(text)
    before, *after = split(head, _IMPLIES)
    if after and (_is_made_of_others(after[0]) or split(before, _AND)[1:]):
        if len(after) > 1:
            raise InputError("write one implication at a time: A => B, or B given A")
        said = ", ".join(part.strip() for part in split(before, _AND))
        given = f"{given}, {said}" if isinstance(given, str) and given else (given or said)
        head = after[0]
    elif not _is_made_of_others(head):
        return None
    shared = read_claim(f"0 <= 1 {tail}", given, path)
    formula = _formula(head, _Around(shared, "uniformly" in tail.split()))
    _need_one_reading(head, formula)
    return Compound(formula, shared.given, shared.path, shared.on, claim.strip())


def is_compound(text: str) -> bool:
    """Return whether a formula is made of others, by its words alone."""
    if not _HINT.search(text) or _BEGINS.match(text):
        return False
    for pattern, word in _LATEX_WORDS:
        text = pattern.sub(word, text)
    head, _ = _cut(text)
    before, *after = split(head, _IMPLIES)
    if after:
        return _is_made_of_others(after[0]) or bool(split(before, _AND)[1:])
    return _is_made_of_others(head)


def under(formula: Formula, conditions: Callable[[Formula], tuple[Compared, ...]]) -> Formula:
    """Return a formula with other conditions, the same for all parts of an equivalence."""
    if isinstance(formula, Together):
        return Together(tuple(under(part, conditions) for part in formula.parts))
    if isinstance(formula, Equivalent):
        common = conditions(formula)
        return Equivalent(tuple(under(part, lambda _: common) for part in formula.parts))
    return formula._replace(given=conditions(formula))


def claimed(claim: str, given: str, path: str | None) -> list[tuple[Written, tuple[str, ...]]]:
    """Return the comparisons of a claim made of others, and the unknown of each that is counted."""
    whole = read_compound(claim, given, path)
    found: list[tuple[Written, tuple[str, ...]]] = []
    for leaf in () if whole is None else leaves(whole.formula):
        counted = bound_names(leaf)
        own = leaf if isinstance(leaf, Written) else Written(comparisons_of(leaf), leaf.given, None)
        found.append((own, counted))
    return found


def bound_names(leaf: Leaf) -> tuple[str, ...]:
    """The variables that a part names as its own: an unknown, those of a function or a motion."""
    if isinstance(leaf, Named):
        return names_of(leaf)
    return () if isinstance(leaf, Written | Somewhere) else (leaf.name,)


def leaves(formula: Formula) -> Iterator[Leaf]:
    """Yield the parts of a formula that are not made of others."""
    if isinstance(formula, Together | Equivalent):
        for part in formula.parts:
            yield from leaves(part)
    else:
        yield formula


def comparisons_of(leaf: Leaf) -> tuple[Compared, ...]:
    """Return the comparisons in a part; a function of which a shape is claimed stands as f == f."""
    if isinstance(leaf, Written | Somewhere):
        return leaf.comparisons
    if isinstance(leaf, Count):
        return (leaf.equation, (leaf.low, "<", leaf.high))
    if isinstance(leaf, Named):
        return sides_of(leaf)
    return ((leaf.function, "==", leaf.function),)


def mapped(formula: Formula, change: Callable[[Expr], Expr]) -> Formula:
    """Return a formula with every side of its comparisons changed, conditions included."""

    done: dict[Expr, Expr] = {}

    def changed(e: Expr) -> Expr:
        if e not in done:  # a side that two comparisons share remains one, as in a < b < c
            done[e] = change(e)
        return done[e]

    def links(parts: Sequence[Compared]) -> tuple[Compared, ...]:
        return tuple((changed(x), sign, y if sign == "in" else changed(y)) for x, sign, y in parts)

    if isinstance(formula, Together):
        return Together(tuple(mapped(part, change) for part in formula.parts))
    if isinstance(formula, Equivalent):
        return Equivalent(tuple(mapped(part, change) for part in formula.parts))
    if isinstance(formula, Count):
        low, high = change(formula.low), change(formula.high)
        (equation,) = links((formula.equation,))
        given = links(formula.given)
        return formula._replace(low=low, high=high, equation=equation, given=given)
    if isinstance(formula, Shape):
        return formula._replace(function=change(formula.function), given=links(formula.given))
    if isinstance(formula, Somewhere):
        return Somewhere(links(formula.comparisons), links(formula.given))
    if isinstance(formula, Named):
        return _mapped_named(formula, changed)._replace(given=links(formula.given))
    return formula._replace(
        comparisons=links(formula.comparisons), given=links(formula.given), on=links(formula.on)
    )


def _mapped_named(claim: Named, change: Callable[[Expr], Expr]) -> Named:
    if isinstance(claim, Extremum):
        return claim._replace(function=change(claim.function), value=change(claim.value))
    rates = tuple(map(change, claim.rates))
    if isinstance(claim, Conserved):
        return claim._replace(function=change(claim.function), rates=rates)
    by = None if claim.by is None else change(claim.by)
    return claim._replace(point=tuple(map(change, claim.point)), rates=rates, by=by)


class _Around(NamedTuple):
    """What surrounds a part: the conditions, path and region of the whole claim."""

    shared: Written
    uniformly: bool = False


def _formula(text: str, around: _Around) -> Formula:
    parts = split(text, _EQUIVALENT)
    if len(parts) > 1:
        found = tuple(_conjunction(part, around) for part in parts)
        for part in found:
            _need_plain(part, around)
        return Equivalent(found)
    return _conjunction(text, around)


def _need_plain(part: Formula, around: _Around) -> None:
    """That a part of an equivalence consists of comparisons under the common conditions."""
    for leaf in leaves(part):
        if not isinstance(leaf, Written) or leaf.path is not None or isinstance(part, Equivalent):
            raise InputError(
                "an equivalence is one of comparisons at points, as in x == 0 <=> y == 0"
            )
        if leaf.given != around.shared.given:
            raise InputError(OWN_CONDITIONS)
        if any(relation not in ("==", "!=", "<", "<=", ">", ">=") for _, relation, _ in leaf[0]):
            raise InputError(
                "an equivalence is one of comparisons at points, as in x == 0 <=> y == 0"
            )


def _conjunction(text: str, around: _Around) -> Formula:
    parts = split(text, _AND)
    found = [_part(part, around) for part in parts]
    flat = [p for part in found for p in (part.parts if isinstance(part, Together) else (part,))]
    return flat[0] if len(flat) == 1 else Together(tuple(flat))


def _part(text: str, around: _Around) -> Formula:
    text = text.strip()
    if not text:
        raise InputError("a claim is missing beside one of the words and, <=>")
    if match := _COUNT.match(text):
        return _count(match, around)
    if (match := _SHAPE.match(text)) and encloses(text[match.start(2) - 1 :].strip()):
        *function, name = split(match[2], ",")
        if not function or not re.fullmatch(r"\s*[A-Za-z]\w*\s*", name):
            raise InputError(f"write {match[1]}(f, x) with the variable of the function")
        return _shape(match[1], ",".join(function), name.strip(), around)
    if match := _SOME.match(text):
        some = _written(match[1], around)
        if some.path is not None or some.on or some.uniformly:
            raise InputError("at some point: … is said of points, and has no path")
        return Somewhere(some.comparisons, some.given)
    if match := _IN_WORDS.match(text):
        return _shape(match[2], match[1], match[3], around)
    if begins_named(text):
        if around.shared.path is not None or around.uniformly:
            raise InputError("what is said of a function or a motion as a whole has no path")
        return read_named(text, (*around.shared.given, *around.shared.on))
    if encloses(text) and split(inner := text[1:-1], _RELATION)[1:]:
        return _bracketed(inner, around)
    components = _components(text)
    if components is not None:
        return Together(tuple(_written(part, around) for part in components))
    found = _written(text, around)
    if split(chained(found.comparisons), ",")[1:]:  # a < b > c is two chains in print
        return Together(tuple(found._replace(comparisons=(link,)) for link in found.comparisons))
    return found


def _bracketed(inner: str, around: _Around) -> Formula:
    """A part in brackets, which may have conditions and a path of its own."""
    head, tail = _cut(inner)
    shared, uniformly = around
    if tail:
        path = None if shared.path is None else str(shared.path)
        on = shared.on
        shared = read_claim(f"0 <= 1 {tail}", chained(shared.given), path)
        if on and shared.on:
            raise InputError("a claim can have only one part that begins with the word on")
        shared = shared._replace(on=shared.on or on)
        uniformly = uniformly or "uniformly" in tail.split()
    return _formula(head, _Around(shared, uniformly))


def _written(text: str, around: _Around) -> Written:
    shared = around.shared
    path = None if shared.path is None else str(shared.path)
    found = read_claim(text, chained(shared.given), path)
    return found._replace(on=shared.on, uniformly=around.uniformly or found.uniformly)


def _count(match: re.Match[str], around: _Around) -> Count:
    how, name, opening, rest = match.groups()
    end = closing(opening + rest)
    if end is None or rest[end:].lstrip()[:1] != ":":
        raise InputError(f"write {how} {name} in (a, b): f == g")
    ends = split(rest[: end - 1], ",")
    if len(ends) != 2:
        raise InputError(
            f"'{rest[: end - 1]}' is no interval: write {how} {name} in (a, b): f == g"
        )
    low, high = (_end(part) for part in ends)
    equation = read_claim(rest[end:].lstrip()[1:].strip()).comparisons
    if len(equation) != 1 or equation[0][1] != "==":
        raise InputError(
            f"{how} solution is counted of one equation: {how} {name} in (a, b): f == g"
        )
    if around.shared.path is not None or around.shared.on or around.uniformly:
        raise InputError(f"{how} {name} in (a, b) has no path")
    if name in symbols(low) | symbols(high):
        raise InputError(f"{name} is counted, so it cannot stand in the ends of its interval")
    given = around.shared.given
    if name in {n for link in given for side in link[::2] for n in symbols(side)}:
        raise InputError(
            f"{name} is counted in its interval, so no condition is about it: use another letter"
        )
    return Count(how, name, low, high, (opening == "[", rest[end - 1] == "]"), equation[0], given)


def _end(text: str) -> Expr:
    bare = text.replace(" ", "")
    infinite = {"oo": INFINITY, "+oo": INFINITY, "-oo": -INFINITY, "∞": INFINITY, "-∞": -INFINITY}
    return infinite[bare] if bare in infinite else as_written(plain(text))


def _shape(how: str, function: str, name: str, around: _Around) -> Shape:
    shared = around.shared
    if shared.path is not None or around.uniformly:
        raise InputError(f"{how}(f, x) is claimed where conditions hold, and has no path")
    found = read_claim(f"{function} == 0").comparisons
    if len(found) != 1 or found[0][1] != "==" or found[0][2] != ZERO:
        raise InputError(f"'{function.strip()}' is not a function: write {how}(f, x)")
    return Shape(how, found[0][0], name, (*shared.given, *shared.on))


def _components(text: str) -> list[str] | None:
    """The components of ``(x, y) == (f, g)``, of matrices too; None for other comparisons."""
    sides = split(text, _RELATION)
    lists = [_entries(side) for side in sides]
    if len(sides) < 2 or all(entries is None for entries in lists):
        return None
    found = [entries for entries in lists if entries is not None]
    if len(found) < len(lists) or len({len(entries) for entries in found}) != 1:
        raise InputError("the sides of a vector equation have the same number of components")
    if any(sign.strip() not in ("==", "=") for sign in _between(text)):
        raise InputError("vectors are compared by == alone; write other relations one by one")
    return [" == ".join(row) for row in zip(*found, strict=True)]


def _between(text: str) -> list[str]:
    """The relations between the sides."""
    return [text[a:b] for a, b in places(text, _RELATION)]


def _entries(side: str) -> list[str] | None:
    """The components of a vector, those of rows in brackets one after the other."""
    side = side.strip()
    if not encloses(side):
        return None
    parts = split(side[1:-1], ",")
    if len(parts) < 2:
        return None
    rows = [_entries(part) for part in parts]
    if all(row is None for row in rows):
        return [part.strip() for part in parts]
    return [x for row, part in zip(rows, parts, strict=True) for x in (row or [part.strip()])]


def _is_made_of_others(head: str) -> bool:
    """Whether a formula consists of others, by its words alone."""
    if len(split(head, f"{_EQUIVALENT}|{_AND}")) > 1:
        return True
    text = head.strip()
    if (
        _COUNT.match(text)
        or _SOME.match(text)
        or (_SHAPE.match(text) and not split(text, _RELATION)[1:])
    ):
        return True
    if _IN_WORDS.match(text) or begins_named(text):
        return True
    if encloses(text) and split(text[1:-1], _RELATION)[1:]:
        return _is_made_of_others(_cut(text[1:-1])[0])
    sides = split(text, _RELATION)
    return len(sides) > 1 and all(_entries(side) is not None for side in sides)


def _need_one_reading(text: str, formula: Formula) -> None:
    """That e is the number in all parts, or a variable in all of them."""
    links = [link for leaf in leaves(formula) for link in comparisons_of(leaf)]
    is_variable = any("e" in symbols(side) for link in links for side in link[::2])
    if not is_variable or not _EULER.search(text):
        return
    letters = len(_EULER.findall(text))
    if letters > sum(len(_EULER.findall(str(side))) for link in links for side in link[::2]):
        raise InputError(
            "two readings remain of e: write E or exp(x) for Euler's number, "
            "or the variable e by another name"
        )


# Text


def _cut(text: str) -> tuple[str, str]:
    """Return the formula and what is said after it: conditions, path and region."""
    found = places(text, _TAIL)
    start = found[0][0] if found else len(text)
    return text[:start].strip().rstrip(","), text[start:].strip()


# Text that is read again


def shown(formula: Formula, whole: Compound) -> str:
    """Return a part of a claim as text, without what is said of the whole claim."""
    if isinstance(formula, Together):
        return " and ".join(
            f"({text})" if isinstance(part, Equivalent) and text[0] != "(" else text
            for part in formula.parts
            for text in (shown(part, whole),)
        )
    if isinstance(formula, Equivalent):
        common = next(leaves(formula)).given
        inner = whole._replace(given=common)
        text = " <=> ".join(shown(part, inner) for part in formula.parts)
        own = common[len(whole.given) :]
        return f"({text} given {chained(own)})" if own else text
    if isinstance(formula, Count):
        own = formula.given[len(whole.given) :]
        left, right = "[" if formula.closed[0] else "(", "]" if formula.closed[1] else ")"
        place = f"{left}{formula.low}, {formula.high}{right}"
        text = f"{formula.how} {formula.name} in {place}: {chained((formula.equation,))}"
        return f"({text} given {chained(own)})" if own else text
    if isinstance(formula, Shape):
        text = f"{formula.how}({formula.function}, {formula.name})"
        own = tuple(c for c in formula.given[len(whole.given) :] if c not in whole.on)
        return f"({text} given {chained(own)})" if own else text
    if isinstance(formula, Named):
        text = named_text(formula)
        own = tuple(c for c in formula.given[len(whole.given) :] if c not in whole.on)
        return f"({text} given {chained(own)})" if own else text
    own = formula.given[len(whole.given) :]
    if isinstance(formula, Somewhere):
        text = f"at some point: {chained(formula.comparisons)}"
        return f"({text} given {chained(own)})" if own else text
    path = None if formula.path == whole.path else formula.path
    on = () if formula.on == whole.on else formula.on
    text = str(formula._replace(given=own, path=path, on=on))
    return f"({text})" if own or path or on or formula.uniformly else text


def renamed(equation: Compared, name: str, other: str) -> Compared:
    """Return an equation for another letter."""
    put = {name: symbol(other)}
    return substitute(equation[0], put), equation[1], substitute(equation[2], put)


# In print


def formula_in_latex(
    formula: Formula, shared: int = 0, path: str | None = None, writer: Printer = PLAIN
) -> str:
    """Return a formula in LaTeX; its first ``shared`` conditions and ``path`` stand elsewhere.

    Args:
        formula: the formula.
        shared: the number of conditions that are left out.
        path: a limit process that is left out, as text.
        writer: writes the expressions.
    """
    if isinstance(formula, Together):
        parts = (formula_in_latex(part, shared, path, writer) for part in formula.parts)
        return r" \quad\text{and}\quad ".join(parts)
    if isinstance(formula, Equivalent):
        parts = (formula_in_latex(part, shared, path, writer) for part in formula.parts)
        return r" \iff ".join(parts)
    own = formula.given[shared:]
    under_own = rf" \ ({writer.chain(own)})" if own else ""
    if isinstance(formula, Count):
        low, high = map(writer.shown, (formula.low, formula.high))
        left, right = "[" if formula.closed[0] else "(", "]" if formula.closed[1] else ")"
        place = rf"{writer.name(formula.name)} \in {left}{low}, {high}{right}"
        how = r"\exists!\, " if formula.how == "exactly one" else rf"\text{{{formula.how} }} "
        return rf"{how}{place}:\ {writer.chain((formula.equation,))}{under_own}"
    if isinstance(formula, Shape):
        strict = {"increasing": "increases strictly", "decreasing": "decreases strictly"}
        how = rf"\text{{ {strict.get(formula.how, f'is {formula.how}')} in }}"
        function = writer.shown(formula.function)
        return rf"{function} {how} {writer.name(formula.name)}{under_own}"
    if isinstance(formula, Named):
        return named_in_latex(formula, writer) + under_own
    if isinstance(formula, Somewhere):
        return rf"\text{{at some point }} {writer.chain(formula.comparisons)}{under_own}"
    tends = formula.path if str(formula.path) != path else None
    ends = "" if tends is None else rf" \ ({path_in_latex(tends, writer)})"
    return writer.chain(formula.comparisons) + under_own + ends


def path_in_latex(path: Path, writer: Printer = PLAIN) -> str:
    """``x \\to 0^+`` for ``x -> 0+``, and the same for several variables or an expression."""
    if path.together:
        names, points = map(writer.name, path.together), map(writer.shown, path.points)
        return rf"({', '.join(names)}) \to ({', '.join(points)})"
    side = "" if path.point is None or len(path.sides) > 1 else "^+" if path.sides[0] > 0 else "^-"
    return writer.chain([_arrow(path)]) + side


def path_in_mathml(path: Path) -> str:
    """The same as MathML in the line."""
    side = "" if path.point is None or len(path.sides) > 1 else "+" if path.sides[0] > 0 else "−"
    shown = to_mathml([_arrow(path)], block=False)
    return shown.replace(
        "</math>", f"<msup><mrow/><mo>{side}</mo></msup></math>" if side else "</math>"
    )


def _arrow(path: Path) -> Compared:
    point = multiply(number(path.sides[0]), INFINITY) if path.point is None else path.point
    return path.expression or symbol(path.name), "->", point
