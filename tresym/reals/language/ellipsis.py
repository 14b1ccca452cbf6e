"""Find the general term of a sum written with an ellipsis.

Dots before the last term, as in ``1 + 3 + ... + (2*n - 1)``, stand for the terms between. The last
term is the general one, and the terms before the dots must be its consecutive values. Dots after
the general term as well make it an infinite series. Dots after at least three numbers, as in ``1 -
1/3 + 1/5 - ...``, stand for a series. Its terms must be reciprocals of powers of a linear function,
reciprocals of factorials, or geometric, with constant or alternating signs. Other dots remain a
term.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import factorial

from flint import fmpq, fmpz

from tresym.reals.language.binders import total
from tresym.reals.language.calls import FACTORIAL, INFINITY, call
from tresym.reals.language.expression import (
    DOTS,
    LEAVES,
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    fresh,
    number,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.exact import InputError

FIRST, SEEN, HIGHEST = 4, 2, 4
"""The number of possible first indices, the terms required, and the highest power tried."""
_UNSEEN = "the general term of the sum with dots was not found: write sum(f, k, 1, n)"


def meant(terms: Sequence[Expr]) -> Expr:
    """Return the sum of these terms, one of which is dots.

    Raises:
        InputError: there are several dots, or the general term is not found.
    """
    at = terms.index(DOTS)
    before, after = list(terms[:at]), list(terms[at + 1 :])
    if DOTS in after[:1] or DOTS in after[2:] or not before:
        raise InputError(_UNSEEN)
    if after[1:] == [DOTS]:  # the general term is between two dots
        *terms, whole = _finite(before, after[0])
        return add(*terms, Expr(whole.op, (*whole.args[:2], INFINITY), whole.names))
    if after:
        return add(*_finite(before, after[0]), *after[1:])
    if all(term.op == "number" for term in before) and len(before) > SEEN:
        return _series([fmpq(term.args[0]) for term in before])
    return add(*before, DOTS)


def _finite(before: list[Expr], last: Expr) -> list[Expr]:
    """Return the terms before the sum, and the sum whose general term is ``last``.

    Two readings may fit the terms shown, as 1 + 1/2 + ... + 1/2**n may have all powers of 1/2 or
    all reciprocals between: then none is chosen.
    """
    fits = [fit for way in _indices(last) if (fit := _fitting(before, *way)) is not None]
    first = min((first for first, _ in fits), default=0)
    found = {whole for n, whole in fits if n == first}
    if len(found) != 1:
        raise InputError(_UNSEEN)
    (whole,) = found
    return [*before[:first], whole]


def _indices(last: Expr) -> Iterator[tuple[Expr, Expr, str]]:
    """Yield what may count the terms up to a last one, which is then its value there: n, or a
    multiple or a power such as 2*n, n**2 and 2**n; with the general term, and its index."""
    k = fresh("k", symbols(last))
    for n in sorted(symbols(last)):
        yield symbol(n), substitute(last, {n: symbol(k)}), k
        for node in dict.fromkeys(_multiples(last, n)):
            turned = node.op == "^" and _falls(node.args[1])
            body = _replaced(last, node, 1 / symbol(k) if turned else symbol(k))
            if n not in symbols(body):
                yield 1 / node if turned else node, body, k


def _multiples(e: Expr, n: str) -> Iterator[Expr]:
    """Yield the parts of an expression that are a multiple or a power of n, or a power to n."""
    if e.op in LEAVES:
        return
    if e.op in ("*", "^") and symbols(e) == {n}:
        known, other = (e.args[0], e.args[-1]) if e.op == "*" else e.args
        if known.op == "number" or (e.op == "^" and other.op == "number" and other != MINUS_ONE):
            yield e
    for arg in e.args:
        yield from _multiples(arg, n)


def _falls(exponent: Expr) -> bool:
    """Whether an exponent is negative, or a negative multiple."""
    factor = exponent.args[0] if exponent.op == "*" else exponent
    return factor.op == "number" and factor.args[0] < 0


def _replaced(e: Expr, part: Expr, by: Expr) -> Expr:
    if e == part:
        return by
    return e if e.op in LEAVES else rebuild(e, tuple(_replaced(arg, part, by) for arg in e.args))


def _fitting(before: list[Expr], index: Expr, body: Expr, k: str) -> tuple[int, Expr] | None:
    """Return the sum of a general term up to an index that begins with the most of the terms
    shown, at least ``SEEN``, and the number of terms before it; None if there is none."""
    shown = [_folded(term) for term in before]
    for count in range(len(before), SEEN - 1, -1):
        for start in range(FIRST):
            terms = (substitute(body, {k: number(start + i)}) for i in range(count))
            if all(_folded(term) == one for term, one in zip(terms, shown[-count:], strict=True)):
                return len(before) - count, total("sum", body, k, number(start), index)
    return None


def _folded(e: Expr) -> Expr:
    """Evaluate powers with exponent 0 and factorials of numbers in ``e``."""
    if e.op in LEAVES:
        return e
    args = tuple(map(_folded, e.args))
    if e.op == "^" and args[1] == ZERO:
        return ONE
    if e.op == "unknown" and args[0].args[0] == FACTORIAL and args[1].op == "number":
        value = args[1].args[0]
        if value.q == 1 and 0 <= value < 100:
            return number(factorial(int(value.p)))
    return rebuild(e, args)


def _series(values: list[fmpq]) -> Expr:
    """Return the series that begins with these numbers."""
    k = symbol("k")
    signs = [value > 0 for value in values]
    alternating = all(one != other for one, other in pairwise(signs))
    if 0 in values or not (alternating or len(set(signs)) == 1):
        raise InputError(_UNSEEN)
    body = _general([abs(value) for value in values], k)
    if body is None:
        raise InputError(_UNSEEN)
    turn = MINUS_ONE**k if alternating else ONE
    return total("sum", (1 if signs[0] else -1) * turn * body, "k", ZERO, INFINITY)


def _general(values: list[fmpq], k: Expr) -> Expr | None:
    """Return the general term of positive numbers, or None."""
    ratios = [other / one for one, other in pairwise(values)]
    if len(set(ratios)) == 1:
        return number(values[0]) * number(ratios[0]) ** k
    steps = [1 / ratio for ratio in ratios]
    if steps[0].q == 1 and all(b - a == 1 for a, b in pairwise(steps)):
        start = int(steps[0].p) - 1
        whole = number(values[0] * factorial(start)) if start >= 0 else None
        if whole is not None and (start or len(values) > SEEN + 1):
            return whole / call(FACTORIAL, [k + start])
    for m in range(1, HIGHEST + 1):
        roots = [_root(1 / value, m) for value in values]
        known = [root for root in roots if root is not None]
        if len(known) == len(values) and len({b - a for a, b in pairwise(known)}) == 1:
            slope = known[1] - known[0]
            return 1 / (number(int(slope)) * k + number(int(known[0]))) ** number(m)
    return None


def _root(value: fmpq, m: int) -> fmpz | None:
    """Return the exact m-th root of an integer, or None."""
    if value.q != 1:
        return None
    root = fmpz(value.p).root(m)
    return root if root**m == value.p else None
