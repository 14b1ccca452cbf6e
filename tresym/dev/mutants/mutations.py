"""Mutations of an expression: one typical slip at a time.

A mutation reverses a sign, changes a coefficient by one or an exponent by one or by the factor 2,
swaps two symbols or sine and cosine, drops a term or a factor, or reverses an inequality.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from sympy import (
    Add,
    Basic,
    Derivative,
    Equivalent,
    I,
    Integral,
    MatrixBase,
    Mul,
    Pow,
    Rational,
    Subs,
    Symbol,
    Tuple,
    cos,
    nan,
    oo,
    sin,
    zoo,
)
from sympy.core.relational import Relational

from tresym.ledger.statements import Binding

Path = tuple[int, ...]
Changes = Callable[[Basic], Iterable[Basic]]


SLIPS = 12
"""Number of typical slips that are tried before other constants."""


def mutations(e: Basic, alike: tuple[Symbol, Symbol]) -> Iterator[Basic]:
    """Return variants of ``e`` with one change each; the first few are of all kinds.

    Args:
        e: the expression.
        alike: the two symbols of the paper that are most easily confused; they are swapped, too.
    """
    a, b = alike
    slips = scattered([((), e.xreplace({a: b, b: a})), *_edits(e, (), _here)])
    further = [*(((), changed) for changed in _further(e)), *scattered(_edits(e, (), _further))]
    seen = {e}
    for path, changed in (*slips[:SLIPS], *further[:SLIPS], *slips[SLIPS:], *further[SLIPS:]):
        whole = _replaced(e, path, changed)
        if _is_alike(e, whole) and whole not in seen and not whole.has(nan, oo, zoo, I):
            seen.add(whole)
            yield whole


def _is_alike(e: Basic, changed: Basic) -> bool:
    """Return whether the changed relation is still one; SymPy evaluates some to true or false."""
    for kind in (Relational, Equivalent):
        if isinstance(e, kind):
            return isinstance(changed, kind) and len(changed.args) == len(e.args)
    return True


def _edits(e: Basic, path: Path, here: Changes) -> Iterator[tuple[Path, Basic]]:
    """Yield every node of ``e`` with its possible replacements."""
    for changed in here(e):
        yield path, changed
    for n in _changeable(e):
        yield from _edits(e.args[n], (*path, n), here)


def _replaced(e: Basic, path: Path, changed: Basic) -> Basic:
    if not path:
        return changed
    n = path[0]
    return _rebuilt(e, (*e.args[:n], _replaced(e.args[n], path[1:], changed), *e.args[n + 1 :]))


def _changeable(e: Basic) -> range:
    """Return the indices of the arguments that may be changed (not bound variables)."""
    if isinstance(e, Derivative):
        return range(1)
    if isinstance(e, Subs):
        return range(0, 3, 2)
    if isinstance(e, Binding):
        return range(1, 4)
    if isinstance(e, MatrixBase):
        return range(2, 3)
    if isinstance(e, Tuple) and len(e.args) == 3 and isinstance(e.args[0], Symbol):
        return range(1, 3)
    return range(len(e.args))


def _rebuilt(e: Basic, args: tuple[Basic, ...]) -> Basic:
    if isinstance(e, Relational):
        return e.func(*args, evaluate=False)
    if isinstance(e, MatrixBase):
        return type(e)(*args[:2], list(args[2]))
    if isinstance(e, Integral):
        return Integral(*args)
    return e.func(*args)


def _here(e: Basic) -> Iterator[Basic]:
    """Yield changes of the outermost operation of ``e``."""
    match e:
        case Add():
            for n, term in enumerate(e.args):
                rest = (*e.args[:n], *e.args[n + 1 :])
                yield from (Add(*rest), Add(*rest, -term), Add(*rest, 2 * term))
        case Mul():
            for n in range(len(e.args)):
                yield Mul(*e.args[:n], *e.args[n + 1 :])
            yield -e
        case Pow():
            for exponent in (e.exp + 1, e.exp - 1, 2 * e.exp):
                yield e.base**exponent
        case Rational():
            yield from (e + 1, e - 1, -e, 2 * e)
        case Symbol():
            yield from (2 * e, -e)
        case sin():
            yield from (cos(*e.args), -e)
        case cos():
            yield from (sin(*e.args), -e)
        case Relational():
            if e.rel_op in (">", ">=", "<", "<="):
                yield e.reversedsign.func(*e.args, evaluate=False)


def _further(e: Basic) -> Iterator[Basic]:
    """Yield other constants, for expressions with too few typical slips."""
    match e:
        case Rational():
            yield from (e + 2, e - 2, 3 * e)
        case Symbol():
            yield from (3 * e, e / 2, e + 1)
        case Relational() if not isinstance(e.lhs, MatrixBase):
            for more in (1, -1, 2, -2, 3, -3):
                yield e.func(e.lhs, e.rhs + more, evaluate=False)


def of_relations(says: Basic) -> Iterator[Basic]:
    """Yield ``says`` with one relation reversed, or with another number on its right side."""
    parts = says.args if isinstance(says, Tuple) else (says,)
    for change in (_here, _further):
        for n, part in enumerate(parts):
            for changed in change(part) if isinstance(part, Relational) else ():
                whole = Tuple(*parts[:n], changed, *parts[n + 1 :])
                yield whole if isinstance(says, Tuple) else changed


def scattered(variants: Iterable[Any]) -> list[Any]:
    """Reorder the variants so that the first few are of different kinds."""
    numbered = enumerate(variants)
    return [v for _, v in sorted(numbered, key=lambda item: item[0] * 2654435761 % 2**32)]
