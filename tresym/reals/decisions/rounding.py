"""Floors and ceilings as integer variables.

``floor(x)`` is the integer k with k <= x < k + 1, and ``ceiling(x)`` is -floor(-x). A claim about
floor(x) for all x is the claim about k for all x and integers k with these inequalities, so that
nothing need be continuous. For an integer n, floor(n/2) is m or m where n = 2 m or n = 2 m + 1.

Along a path x -> a the integer depends on x, and the claim is refused; so it is where an integral,
a sum or a derivative binds x. As the argument of a sequence, T(floor(n/2)), it is left to the
recurrence.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from math import lcm

from tresym.reals.decisions.answer import Answer, worst
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.calls import ROUNDED
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    BINDERS,
    ZERO,
    Expr,
    fresh,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.formula import Compared
from tresym.reals.normal.polynomials import as_expression, polynomial
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MOST_RESIDUES = 12


def is_rounded(e: Expr) -> bool:
    """Return whether ``e`` is a floor or a ceiling."""
    return e.op == "unknown" and e.args[0].args[0] in ROUNDED


def without_rounding(statement: Statement) -> Statement:
    """Return the statement with integer variables for floors and ceilings.

    Raises:
        InputError: one stands where it has no such variable.
    """
    sides = [side for c in statement.comparisons for side in (c.left, c.right, *c.differentiated)]
    sides += statement.said
    whole = dict.fromkeys(node for e in sides for node in functions(e) if is_rounded(node))
    if not whole:
        return statement
    in_sequences = any(map(_in_sequence, sides))
    whole = dict.fromkeys(node for e in sides for node in _loose(e))
    if whole and in_sequences:
        raise InputError(f"{next(iter(whole))} is not supported beside a sequence at such a value")
    put: dict[Expr, Expr] = {}
    ks: dict[Expr, Expr] = {}
    links: list[Compared] = []
    path = statement.path
    for node in whole:
        (name, orders), e = node.args[0].args, node.args[1]
        inner = replaced(e, put)
        if any(orders) or any(map(is_rounded, functions(inner))):
            raise InputError(f"{node} is not supported inside another operation")
        if path is not None and path.name in symbols(e):
            raise InputError(
                f"{node} has jumps on the way to the end of the path, and is supported there as "
                "the argument of a sequence, as in T(floor(n/2))"
            )
        up = name == "ceiling"
        # the ceiling of e is -floor(-e), and integers may be taken out of a floor
        argument = tidied(normal_form(-inner if up else inner, Given()))
        whole_part, argument = _whole_part(argument, statement.integers)
        value = _value(argument)
        if value is None:
            k = ks.setdefault(argument, symbol(str(unknown("floor", (argument,)))))
            value = k
        value = value + whole_part
        put[node] = -value if up else value
    for argument, k in ks.items():
        links += [(k, "<=", argument), (argument, "<", k + 1)]
        side = sign(argument, statement.given)
        if side in ("+", ">=0"):
            links.append((k, ">=", ZERO))
        for other, j in ks.items():
            total = tidied(normal_form(argument + other, Given()))
            if total.op == "number" and total.args[0].q == 1 and j is not k:
                links += [(k + j, "<=", total), (k + j, ">=", total - 1)]
    changed = statement.mapped(partial(replaced, known=put))
    parts = tuple(c.mapped(partial(replaced, known=put)) for c in statement.comparisons)
    found = replace(
        changed,
        comparisons=parts,
        given=changed.given & Given(tuple(links)),
        integers=(*statement.integers, *(k.args[0] for k in ks.values())),
    )
    after = [side for c in parts for side in (c.left, c.right, *c.differentiated)]
    for e in (*after, *found.said):
        bound = next((node for node in _bound(e) if is_rounded(node)), None)
        if bound is not None:
            raise InputError(f"{bound} is supported outside of integrals, sums and derivatives")
    return found


def residues(statement: Statement) -> tuple[str, str, list[Statement]] | None:
    """Return an integer variable n, another m, and the statement for n = M m + r, r = 0, …, M - 1.

    None where no floor has a fraction of one integer variable alone.
    """
    sides = [side for c in statement.comparisons for side in (c.left, c.right)]
    nodes = {node for e in (*sides, *statement.said) for node in _loose(e)}
    arguments = [node.args[1] for node in nodes]
    names = sorted({n for e in arguments for n in symbols(e)} & {*statement.integers})
    if len(names) != 1 or any(c.derivatives for c in statement.comparisons):
        return None
    (n,) = names
    slopes = [tidied(normal_form(differentiate(e, n), Given())) for e in arguments if not e.hidden]
    modulus = lcm(*(int(e.args[0].q) for e in slopes if e.op == "number"))
    if not 1 < modulus <= MOST_RESIDUES:
        return None
    m, cases = fresh("m", {n for e in (*sides, *statement.said) for n in symbols(e)}), []
    whole = tuple(m if name == n else name for name in statement.integers)
    for r in range(modulus):
        put = partial(substitute, mapping={n: modulus * symbol(m) + r})
        parts = tuple(c.mapped(put) for c in statement.comparisons)
        cases.append(replace(statement.mapped(put), comparisons=parts, integers=whole))
    return n, m, cases


def of_residues(n: str, m: str, answers: list[Answer]) -> Answer:
    """Return the answer for all n from those for n = M m + r."""
    found = worst(answers)
    r, modulus = answers.index(found), len(answers)
    why = f"for {n} = {modulus}*{m} + {r}: {found.why}"
    if found:
        why = f"for {n} = {modulus}*{m} + r with each r separately: {found.why}"
    if found.verdict is not Verdict.REFUTED:
        return replace(found, why=why, region=None)
    at = {name: v for name, v in (found.witness or {}).items() if "(" not in name}
    value = at.pop(m, "0")
    if not value.lstrip("-").isdigit():
        return Answer(Verdict.UNDECIDED, why)
    return replace(found, why=why, witness={n: str(modulus * int(value) + r)} | at)


def _whole_part(e: Expr, integers: Iterable[str]) -> tuple[Expr, Expr]:
    """Return the terms of ``e`` that are integers, and ``e`` without them."""
    terms = {} if e.hidden or e.loose else polynomial(e) or {}
    whole = ZERO
    for m, c in terms.items():
        if not m:
            whole = whole + number(c.floor())
        elif c.q == 1 and all(name in integers for name, _ in m):
            whole = whole + number(c) * as_expression(m)
    return whole, tidied(normal_form(e - whole, Given()))


def _value(e: Expr) -> Expr | None:
    """Return the floor of a number that balls tell from the integers, or that is rational."""
    if e.op == "number":
        return number(e.args[0].floor())
    if symbols(e) or e.hidden:
        return None
    with ball_precision():
        found = evaluate(e, {}).floor().unique_fmpz()
    return None if found is None else number(int(found))


def rounded_numbers(e: Expr) -> Expr:
    """Return ``e`` with the values of floors and ceilings of numbers."""
    for node in [node for node in functions(e) if is_rounded(node) and not node.loose]:
        side = number(1 if node.args[0].args[0] == "floor" else -1)
        value = _value(tidied(side * node.args[1]))
        if value is not None:
            return rounded_numbers(replaced(e, {node: tidied(side * value)}))
    return e


def _loose(e: Expr) -> list[Expr]:
    """Return the floors and ceilings of ``e`` that are no arguments of sequences, inner ones first.

    Those under an operation that binds a variable are not among them.
    """
    if not e.hidden or e.op in BINDERS or (e.op == "unknown" and not is_rounded(e)):
        return []
    inner = [node for arg in e.args for node in _loose(arg)]
    return [*inner, e] if is_rounded(e) else inner


def _in_sequence(e: Expr) -> bool:
    """Return whether ``e`` has a floor in the argument of a sequence, and none bound elsewhere."""
    if not e.hidden or e.op in BINDERS:
        return False
    if e.op == "unknown" and not is_rounded(e):
        return any(is_rounded(node) for arg in e.args for node in functions(arg))
    return any(map(_in_sequence, e.args))


def _bound(e: Expr) -> Iterator[Expr]:
    """Yield the applied functions in ``e`` that are no arguments of sequences."""
    if e.hidden and (e.op != "unknown" or is_rounded(e)):
        if e.op == "unknown":
            yield e
        for arg in e.args:
            yield from _bound(arg)
