"""Collect like terms and factors, to recognise trivial equalities.

Sums and products are sorted and collected, numbers are multiplied into sums, and equal factors
cancel. Products of sums are not expanded, and no laws of functions are used. So ``(x + 1)**2 ==
x**2 + 2*x + 1`` and ``sin(-x) == -sin(x)`` do not count as trivial.
"""

from __future__ import annotations

from functools import cache

from flint import fmpq

from tresym.reals.decisions.statement import functions
from tresym.reals.language.binders import ordered, worked_out
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ORDERS,
    ZERO,
    Expr,
    add,
    multiply,
    number,
    power,
    rebuild,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.exact import InputError


def is_trivial(old: Compared, new: Compared, mistaken: str = "") -> bool:
    """Return whether a repaired comparison is trivial, or no longer depends on some variable.

    Args:
        old: the comparison before the repair.
        new: the repaired comparison.
        mistaken: a variable that was printed in place of another one, and may disappear.
    """
    left, right = (collected(_without_orders(side)) for side in new[::2])
    names = symbols(old[0]) | symbols(old[2])
    if left == right or loses_names(old, new, mistaken):
        return True
    if new[1] not in ("==", "<=", ">=", "<", ">"):
        return False
    try:
        gap, share = collected(left - right), collected(left / right)
    except InputError:
        return False
    return (not symbols(gap) and bool(names)) or (not symbols(share) and bool(names))


def _without_orders(e: Expr) -> Expr:
    """Return a sum without its terms O(...): ``y == y + O(x)`` says as little as ``y == y``."""
    if e.op != "+" or not any(part.op in ORDERS for part in e.args):
        return e
    return add(ZERO, *(part for part in e.args if part.op not in ORDERS))


def loses_names(old: Compared, new: Compared, mistaken: str = "") -> bool:
    """Return whether a repaired comparison no longer contains some variable or function."""
    before, after = (
        frozenset().union(*(_named(collected(worked_out(side))) for side in link[::2]))
        for link in (old, new)
    )
    return not before - {mistaken} <= after


def _named(e: Expr) -> frozenset[str]:
    """Return the variables and the arbitrary functions in an expression."""
    return symbols(e) | {str(node.args[0].args[0]) for node in functions(e)}


@cache
def collected(e: Expr) -> Expr:
    """Return ``e`` with like terms and factors collected."""
    if e.op in LEAVES:
        return e
    args = tuple(collected(arg) if isinstance(arg, Expr) else arg for arg in e.args)
    if e.op == "+":
        return _sum(args)
    if e.op == "*":
        return _product(args)
    if e.op == "^":
        return ONE if args[0] == ONE else _product((power(*args),))
    return rebuild(e, args)


def over_one_bar(e: Expr) -> Expr:
    """Return a product as it is printed: ``3/(4*x**2)`` for 3/4 x⁻²; anything else as it is."""
    above: list[Expr] = []
    below: list[Expr] = []
    for part in e.args if e.op == "*" else (e,):
        if part.op == "number":
            p, q = part.args[0].p, part.args[0].q
            above += [number(int(p))] if p != 1 else []
            below += [number(int(q))] if q != 1 else []
        elif part.op == "^" and part.args[1].op == "number" and part.args[1].args[0] < 0:
            below.append(power(part.args[0], number(-part.args[1].args[0])))
        else:
            above.append(part)
    return multiply(ONE, *above) / multiply(ONE, *below) if below else e


def _sum(terms: tuple[Expr, ...]) -> Expr:
    found: dict[Expr, fmpq] = {}
    for term in terms:
        for part in term.args if term.op == "+" else (term,):
            number_, rest = _split(part)
            found[rest] = found.get(rest, fmpq(0)) + number_
    return ordered(add(*(multiply(number(c), rest) for rest, c in found.items() if c != 0)))


def _split(e: Expr) -> tuple[fmpq, Expr]:
    """Return the coefficient of a term and the rest."""
    if e.op == "number":
        return e.args[0], ONE
    if e.op == "*" and e.args[0].op == "number":
        return e.args[0].args[0], multiply(*e.args[1:])
    return fmpq(1), e


def _product(factors: tuple[Expr, ...]) -> Expr:
    constant, found = fmpq(1), dict[Expr, fmpq]()
    for base, exponent in _powers(factors):
        if base.op == "number" and exponent.q == 1 and (base.args[0] != 0 or exponent > 0):
            constant *= base.args[0] ** int(exponent.p)
        elif base != ONE:
            found[base] = found.get(base, fmpq(0)) + exponent
    parts = [power(base, number(c)) for base, c in found.items() if c != 0]
    if constant == 0:
        return number(0)
    if len(parts) == 1 and parts[0].op == "+" and constant != 1:
        return _sum(tuple(multiply(number(constant), term) for term in parts[0].args))
    return ordered(multiply(number(constant), *parts))


def _powers(factors: tuple[Expr, ...]) -> list[tuple[Expr, fmpq]]:
    """Return the bases and exponents of a product; integer powers of products are split."""
    found: list[tuple[Expr, fmpq]] = []
    for factor in factors:
        for part in factor.args if factor.op == "*" else (factor,):
            if part.op == "^" and part.args[1].op == "number":
                base, r = part.args[0], part.args[1].args[0]
                if base.op in ("*", "^") and r.q == 1:
                    found += [(inner, s * r) for inner, s in _powers((base,))]
                    continue
                found.append((base, r))
            else:
                found.append((part, fmpq(1)))
    return found
