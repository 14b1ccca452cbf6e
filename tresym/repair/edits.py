"""Generate all statements one edit away from a given one: likely misprints.

An edit changes one place of one side: a sign, a number, an exponent, a function, a variable or a
factor. Its rank says how common it is as a misprint; 0 is the most common.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from itertools import permutations
from typing import NamedTuple

from flint import fmpq

from tresym.reals.functions.table import TABLE
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    BINDERS,
    DOTS,
    FUNCTIONS,
    HALF,
    LEAVES,
    MINUS_ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    bind,
    instantiate,
    multiply,
    number,
    opened,
    power,
    rebuild,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.exact import InputError

SIGN, NUMBER, FUNCTION, VARIABLE, FACTOR, WRAPPED, OTHER = range(7)
"""The ranks of edits."""
MAX_DIGITS = 6
"""The maximal number of digits of a number whose digits are changed one by one."""

STRICTNESS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
RELATIONS: dict[str, tuple[str, ...]] = {
    "<": ("<=", ">"),
    "<=": ("<", ">="),
    ">": (">=", "<"),
    ">=": (">", "<="),
}
"""The relations that a misprint may have replaced."""
RELATIONS |= {"O": ("o",), "o": ("O",), "!=": ("==",)}


class Change(NamedTuple):
    """A tree with one place changed: the rank, the old and new text of the place, and the tree."""

    rank: float
    old: str
    new: str
    tree: Expr


class Edit(NamedTuple):
    """A chain of comparisons with one place changed.

    Attributes:
        rank: how common such a misprint is; 0 is the most common.
        old: the text of the place before the change.
        new: the text after the change.
        terms: the terms of the changed chain.
        relations: the relations of the changed chain.
    """

    rank: float
    old: str
    new: str
    terms: tuple[Expr, ...]
    relations: tuple[str, ...]

    @property
    def says(self) -> str:
        """Return the edit in words."""
        return f"{self.new or 'nothing'} in place of {self.old or 'nothing'}"

    @property
    def links(self) -> list[Compared]:
        """Return the comparisons of the chain."""
        return [*zip(self.terms, self.relations, self.terms[1:], strict=False)]


def edits(
    terms: tuple[Expr, ...],
    relations: tuple[str, ...],
    indices: Sequence[str] = (),
    free: bool = True,
) -> list[Edit]:
    """Return every chain one edit away, sorted by rank; changes at the right end come first.

    Args:
        terms: the terms of the chain.
        relations: the relations between them.
        indices: integer variables, which may be replaced by n ± 1.
        free: whether the symbols are free variables without definitions.
    """
    names = sorted(frozenset().union(*map(symbols, terms)) - symbols(INFINITY))
    found = [
        Edit(
            SIGN if STRICTNESS.get(relation) == other else NUMBER,
            *(relation, other, terms, (*relations[:n], other, *relations[n + 1 :])),
        )
        for n, relation in enumerate(relations)
        for other in RELATIONS.get(relation, ())
    ]
    plain = free and {*relations} == {"=="} and elementary(*terms)
    lone = plain and bool(lone_variables(terms, indices))
    for n in reversed(range(len(terms))):
        for rank, old, new, tree in changes(terms[n], names, indices):
            chain = (*terms[:n], tree, *terms[n + 1 :])
            if lone and rank != VARIABLE:
                continue
            if n == 0 and tree == multiply(MINUS_ONE, terms[0]):
                rank = FACTOR  # a changed sign of the whole left side is unlikely
            if tree == ZERO and terms[n].op == "number":
                rank = _later(0)  # it counts as another value, not as an omitted term
            if rank == WRAPPED and tree.op in ("^", "abs") and tree.args[0] == terms[n]:
                rank = OTHER  # a power or absolute value of a whole side is unlikely
            found.append(Edit(rank, old, new, chain, relations))
    unique = {(terms, relations): found[0]} if found else {}
    for edit in sorted(found, key=lambda edit: edit.rank):
        unique.setdefault((edit.terms, edit.relations), edit)
    return list(unique.values())[1:]


def lone_variables(terms: Sequence[Expr], indices: Sequence[str] = ()) -> set[str]:
    """Return the variables that occur exactly once in a chain.

    An equality with such a variable is not an identity, and only an edit of variables can repair
    it.
    """
    counts = Counter(name for term in terms for name in _leaves(term))
    apart = {*indices, *symbols(INFINITY), *symbols(DOTS)}
    return {name for name, n in counts.items() if n == 1} - apart


def _leaves(e: Expr) -> Iterator[str]:
    """Yield the variables of a tree, with repetitions."""
    if e.op == "symbol":
        yield str(e.args[0])
    elif e.op not in LEAVES:
        for arg in e.args:
            yield from _leaves(arg)


def is_one_edit(first: Expr, second: Expr) -> bool:
    """Return whether two trees differ in one place, as by a misprint."""
    names = sorted(symbols(first) | symbols(second))
    return first != second and any(
        change.tree == second and change.rank < OTHER for change in changes(first, names)
    )


def changes(e: Expr, names: Sequence[str], indices: Sequence[str] = ()) -> Iterator[Change]:
    """Yield every tree one edit away from ``e``, possibly with repetitions."""
    if e in (INFINITY, DOTS):
        return
    yield from _numbers(e)
    if e.op == "number":
        return
    yield from _wrapped(e)
    yield from _here(e, names, indices)
    if e.op in LEAVES:
        return
    if e.op in BINDERS:
        yield from _inside(e, names, indices)
        return
    signed = e.op == "*" and e.args[0].op == "number"
    for n, arg in enumerate(e.args):
        if not isinstance(arg, Expr) or (signed and n == 0) or arg.op == "function":
            continue
        if e.op == "^" and n == 1:
            yield from _exponents(e, names, indices)
            continue
        for change in changes(arg, names, indices):
            yield from _built(change, e, n)


def _built(change: Change, e: Expr, n: int) -> Iterator[Change]:
    try:
        tree = rebuild(e, (*e.args[:n], change.tree, *e.args[n + 1 :]))
    except InputError:
        return
    yield change._replace(tree=tree)


def _try(
    rank: float, old: str, new: str, make: Callable[..., Expr], *args: Expr
) -> Iterator[Change]:
    """Yield a change, unless the tree would be too large."""
    try:
        yield Change(rank, old, new, make(*args))
    except InputError:
        return


def _inside(e: Expr, names: Sequence[str], indices: Sequence[str]) -> Iterator[Change]:
    """Yield changes of the body and of the ends of a node that binds a variable."""
    bound: tuple[str, ...]
    if e.op in ("antiderivative", "derivative", "nth") and e.args[1].op == "symbol":
        bound, body = (str(e.args[1]),), instantiate(e.args[0], (e.args[1],))
    else:
        bound, body = opened(e, names)
    counted = (*indices, *bound) if e.op in ("sum", "product") else indices
    for change in changes(body, (*names, *bound), counted):
        tree = Expr(e.op, (bind(change.tree, bound), *e.args[1:]), e.names)
        yield change._replace(tree=tree)
    if e.op in ("antiderivative", "derivative", "nth"):
        return
    ends = e.args[1:3] if e.op != "limit" else e.args[1:2]
    for n, end in enumerate(ends, 1):
        if end in (INFINITY, -INFINITY):
            continue
        for change in changes(end, names, sorted(symbols(end))):
            tree = Expr(e.op, (*e.args[:n], change.tree, *e.args[n + 1 :]), e.names)
            yield change._replace(tree=tree)


def _here(e: Expr, names: Sequence[str], indices: Sequence[str]) -> Iterator[Change]:
    """Yield other functions, variables, terms and factors at the root of ``e``."""
    if e.op == "symbol":
        name = str(e.args[0])
        for other in names:
            if other != name:
                yield Change(VARIABLE, name, other, symbol(other))
        for step in (1, -1) if name in indices else ():
            yield Change(VARIABLE, name, str(e + step), e + step)
    if (row := TABLE.get(e.op)) is not None:
        for other in row.confused:
            yield Change(FUNCTION, e.op, other, apply(other, *e.args))
        for other, kin in TABLE.items():
            same = kin.family == row.family and kin.arity == row.arity and not kin.internal
            if same and other != e.op:
                yield Change(WRAPPED, e.op, other, apply(other, *e.args))
    if e.op == "log":
        for base in (b for b in (10, 2) if e.args[0] != number(b)):
            based = e / apply("log", number(base))
            yield Change(FUNCTION, "log", f"the logarithm to base {base}", based)
    if e.op == "+":
        yield from _terms(e)
    if e.op == "*":
        yield from _other_factors(e)
    if e.op == "^" and e.args[1].op != "number":
        yield from _try(OTHER, str(e), str(power(*e.args[::-1])), power, *e.args[::-1])
    if e.op == "abs":
        yield Change(WRAPPED, str(e), str(e.args[0]), e.args[0])


def _terms(e: Expr) -> Iterator[Change]:
    """Yield the sum with the sign of a term changed, or a term omitted."""
    for n, term in enumerate(e.args):
        rest = (*e.args[:n], *e.args[n + 1 :])
        other = multiply(MINUS_ONE, term)
        tree = add(*e.args[:n], other, *e.args[n + 1 :])
        yield Change(_signs(e, tree), _signed(term), _signed(other), tree)
        yield Change(OTHER, _signed(term), "", add(*rest))
        if term.op == "number" or (term.op == "*" and term.args[0].op == "number"):
            continue
        for value in range(3, 10):  # a coefficient 1 is not printed
            more = add(*e.args[:n], multiply(number(value), term), *e.args[n + 1 :])
            yield Change(_later(value), str(term), f"{value}*{term}", more)
    product = multiply(*e.args)
    yield Change(WRAPPED if len(e.args) == 2 else OTHER, str(e), str(product), product)


def _signs(old: Expr, new: Expr) -> float:
    """Return the rank of a changed sign; a new leading sign is less common."""
    if old.op == "+" and new.op != "+":
        return FACTOR
    return SIGN + (0.6 if str(new).startswith("-") and not str(old).startswith("-") else 0)


def _signed(term: Expr) -> str:
    """Return a term with its sign: ``- x`` or ``+ x``."""
    text = str(term)
    return f"- {text[1:]}" if text.startswith("-") else f"+ {text}"


def _other_factors(e: Expr) -> Iterator[Change]:
    """Yield the product with a factor omitted or inverted."""
    for n, factor in enumerate(e.args):
        rest = (*e.args[:n], *e.args[n + 1 :])
        if factor.op == "number":
            if factor != MINUS_ONE:
                rank = OTHER if abs(factor.args[0]) not in (2, fmpq(1, 2)) else FACTOR
                yield Change(rank, str(factor), "", multiply(*rest))
            continue
        yield Change(OTHER, str(factor), "", multiply(*rest))
    total = add(*e.args)
    yield Change(OTHER, str(e), str(total), total)
    for n, m in permutations(range(len(e.args)), 2):
        above, below = e.args[n], e.args[m]
        if below.op == "^" and below.args[1] == MINUS_ONE and above.op != "number":
            others = [factor for k, factor in enumerate(e.args) if k not in (n, m)]
            try:
                turned = multiply(below.args[0], power(above, MINUS_ONE))
                yield Change(WRAPPED, str(above * below), str(turned), multiply(*others, turned))
            except InputError:
                continue


def _wrapped(e: Expr) -> Iterator[Change]:
    """Yield ``e`` with an added sign, factor, power or absolute value."""
    old, negative = str(e), multiply(MINUS_ONE, e)
    yield Change(_signs(e, negative), old, str(negative), negative)
    for factor, rank in (
        (number(2), FACTOR),
        (HALF, FACTOR),
        (PI, OTHER),
        (power(PI, MINUS_ONE), OTHER),
    ):
        tree = multiply(factor, e)
        yield Change(rank, old, str(tree), tree)
    if e.op == "^" and e.args[1].op == "number":  # its exponent is changed elsewhere
        if e.args[1] != HALF:
            yield from _try(WRAPPED, old, f"sqrt({old})", power, e, HALF)
        return
    plain = e.op == "symbol" or e.op in FUNCTIONS
    square: float = NUMBER + 0.5 if plain else WRAPPED
    for exponent, usual in ((number(2), square), (HALF, WRAPPED), (MINUS_ONE, WRAPPED)):
        tree = power(e, exponent)
        yield Change(usual, old, str(tree), tree)
    yield Change(square + 0.4, old, str(power(e, number(3))), power(e, number(3)))
    if e.op != "abs":
        yield Change(WRAPPED, old, f"abs({old})", apply("abs", e))


def _exponents(e: Expr, names: Sequence[str], indices: Sequence[str]) -> Iterator[Change]:
    base, exponent = e.args
    if exponent.op != "number":
        for change in changes(exponent, names, indices):
            yield from _built(change, e, 1)
        return
    r = exponent.args[0]
    for n, value in enumerate(v for v in _near(r, beside=True) if v != 0):
        rank = WRAPPED if value == -r or fmpq(1, 2) in (r, value) else _later(n)
        for change in _try(rank, str(e), "", power, base, number(value)):
            yield change._replace(new=str(change.tree))


def _numbers(e: Expr) -> Iterator[Change]:
    """Yield ``e`` with its number, leading factor or numerator 1 changed."""
    rest: tuple[Expr, ...]
    if e.op == "number":
        own, rest = e.args[0], ()
    elif e.op == "*" and e.args[0].op == "number":
        own, rest = e.args[0].args[0], e.args[1:]
    elif e.op == "*" and any(f.op == "^" and f.args[1] == MINUS_ONE for f in e.args):
        own, rest = fmpq(1), e.args
    elif e.op == "^" and e.args[1] == MINUS_ONE:
        own, rest = fmpq(1), (e,)
    else:
        return
    for n, value in enumerate(v for v in _near(own, beside=False) if v != 0 or not rest):
        tree, rank = multiply(number(value), *rest), _later(n) if value != 0 else OTHER
        yield Change(rank, str(number(own)), str(number(value)), tree)
    sign = multiply(number(-own), *rest)
    yield Change(_signs(e, sign), str(number(own)), str(number(-own)), sign)


def _later(n: int) -> float:
    """Return the rank of the n-th of several numbers."""
    return NUMBER + min(n, 40) / 50


def _near(r: fmpq, beside: bool) -> list[fmpq]:
    """Return the likely misprints of ``r``, the nearest first; an exponent may also change its
    sign.
    """
    p, q = int(r.p), int(r.q)
    values = [fmpq(n, q) for n in _misprints(p)]
    below = [fmpq(p, n) for n in _misprints(q) if n] if q > 1 else []
    values = below + values if abs(p) == 1 else values + below  # 1/7 is nearer to 1/6 than to 2/7
    values += [fmpq(p, n) for n in (2, 3, 4)] if q == 1 and p else []
    values += [-r] if beside else []
    found = dict.fromkeys(v for v in values if v != r)
    return list(found)


def _misprints(n: int) -> list[int]:
    sign, size = (-1 if n < 0 else 1), abs(n)
    found = [size + 1, size - 1, size + 2, size - 2, 2 * size]
    found += [size // 2] if size % 2 == 0 else []
    text = str(size)
    if len(text) <= MAX_DIGITS:
        for k, digit in enumerate(text):
            found += [int(f"{text[:k]}{other}{text[k + 1 :]}") for other in "0123456789"]
            if k + 1 < len(text):
                found.append(int(f"{text[:k]}{text[k + 1]}{digit}{text[k + 2 :]}"))
    near = sorted({m for m in found if m != size}, key=lambda m: (abs(m - size), m))
    return [sign * m for m in near]
