"""Sums, products and derivatives of order n: term by term for numbers, by induction in general.

A sum from a to b runs over the integers from a to b. For b = a − 1 it is empty: the sum is 0, the
product 1. For smaller b it is undefined. A claim about a sum with upper end n + c is a claim about
the integers n for which the sum is defined.

1. *Counterexamples.* The claim is refuted at small n, where the sum is written out.
2. *Induction.* The claim is proved at the least n. In the step from n to n + 1, the sum S is an
   arbitrary number for which the claim holds at n; S + f(n + 1 + c) replaces it at n + 1.
3. *Closed forms.* If induction fails, a closed form suggested by SymPy is proved by induction and
   substituted. A series (a sum to ∞) is the limit of such a closed form.

``d^n f/dx^n = g(n, x)`` holds for all n from n0 on if it holds for n0 and if the derivative of
g(n, x) with respect to x is g(n + 1, x). It is refuted at small n by carrying out the derivatives.

Limitations: nested sums and sums with several upper ends are undecided; the last index stands in
the terms of a sum only as in a polynomial.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.equations import is_whole
from tresym.reals.decisions.exceptional_values import also_at_holes, also_at_zeros
from tresym.reals.decisions.hypergeometric import folded
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.known_values import known_value
from tresym.reals.decisions.readable_witnesses import decided_at, exact_witness, tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations, singularities
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.functions.row import everywhere
from tresym.reals.functions.table import names
from tresym.reals.language.binders import elementary, outermost, total
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    fresh,
    instantiate,
    integer,
    is_polynomial,
    multiply,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import is_lasting
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

TERMS = 200
FIRST, FIRST_ORDERS = 8, 4
"""Values of n, and of orders of derivatives, at which a claim is looked at."""
MOST_POWERS = 8
"""The highest power of the last index in a term of a sum."""
INSIDE = ("sum", "product")
SMOOTH = {"+", "*", "^"} | names(lambda row: row.smooth and row.needs is everywhere)
"""Operations that have a derivative wherever they are defined; of powers it is asked apart."""


def decide_totals(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with finite sums and products.

    Args:
        claim: the comparison to decide.
        statement: its conditions.
        decided: the procedure for claims with fewer sums and products, or none.

    Returns:
        PROVED, ENCLOSED or REFUTED, or UNDECIDED with the obstacle as the reason.
    """
    if claim.derivatives or statement.path is not None:
        return Answer(Verdict.UNDECIDED, "derivatives and limits of sums are not supported")
    long = [node for node in _nodes(claim) if _is_long(*map(integer, node.args[1:]))]
    known = _closed_forms(long, claim, statement, decided)
    claim = claim.mapped(partial(replaced, known=known))
    try:
        claim = replace(claim, left=written_out(claim.left), right=written_out(claim.right))
    except InputError as error:
        return Answer(Verdict.UNDECIDED, f"a sum cannot be expanded: {error}")
    claim = claim.mapped(partial(_by_powers, given=statement.given))
    nodes = _nodes(claim)
    if not nodes:
        return decided(claim, statement)
    parts = {node: opened(node, statement.given.names) for node in nodes}
    theorems = {
        node: known_value(node.op, body, k, node.args[1], node.args[2], statement.given)
        for node, ((k,), body) in parts.items()
    }
    known = {node: theorem.value for node, theorem in theorems.items() if theorem is not None}
    if known:
        return with_values(claim, statement, known, _said(known, "by DLMF 4.21.35"), decided)
    ends = list(map(_end, nodes))
    names = {end[0] for end in ends if end is not None}
    if None in ends or len(names) != 1:
        return Answer(
            Verdict.UNDECIDED,
            "sums are supported from an integer to n + c, with the same n in all sums and without "
            "nested sums",
        )
    (n,) = names
    least = max(end[2] - 1 - end[1] for end in ends if end is not None)
    plain, least = from_on(statement, n, least)
    result = _looked_at(claim, statement, n, least, decided)
    if result is not None:
        return result
    answer = _induction(claim, plain, n, least, decided)
    known = {} if answer else _closed_forms(nodes, claim, plain, decided)
    if answer or len(known) < len({*nodes}):
        return answer
    given = statement.given & Given(((symbol(n), ">=", number(least)),))
    said = _said(known, "by induction")
    return with_values(claim, replace(statement, given=given), known, said, decided)


def first_terms(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about series by the limits of closed forms of their partial sums.

    Args:
        decided: the procedure for claims without series.
    """
    nodes = _nodes(claim)
    if any(node.args[2] != INFINITY or integer(node.args[1]) is None for node in nodes):
        return Answer(Verdict.UNDECIDED, "a series must run from an integer to oo")
    known = _closed_forms(nodes, claim, statement, decided)
    if left := [node for node in nodes if node not in known]:
        why = f"{left[0]}: no closed form of its partial sums could be proved"
        return Answer(Verdict.UNDECIDED, why)
    said = _said(known, "the limit of the partial sums")
    return with_values(claim, statement, known, said, decided)


def _said(known: dict[Expr, Expr], how: str) -> str:
    return ", ".join(f"{node} = {value}" for node, value in known.items()) + f", {how}"


def with_values(
    claim: Comparison, statement: Statement, known: dict[Expr, Expr], said: str, decided: Decide
) -> Answer:
    """Decide the claim with the values of sums, which are shown as ``said``.

    Where a value is undefined, the claim is decided with the sums themselves.
    """
    answer = decided(claim.mapped(partial(replaced, known=known)), statement)
    answer = replace(answer, why=f"{said}; {answer.why}", region=None)
    return also_at_holes(answer, known, claim, statement, decided)


def _closed_forms(
    nodes: list[Expr], claim: Comparison, statement: Statement, decided: Decide
) -> dict[Expr, Expr]:
    """Return values of sums by closed forms from SymPy for any end m, proved by induction."""
    from tresym.reals.decisions.antiderivatives import summed

    known: dict[Expr, Expr] = {}
    m = fresh("m", symbols(claim.left) | symbols(claim.right) | statement.given.names)
    whole = replace(statement, integers=(*statement.integers, m))
    for node in dict.fromkeys(nodes):
        (k,), body = opened(node, statement.given.names)
        low, high, least = node.args[1], node.args[2], integer(node.args[1])
        part = total(node.op, body, k, low, symbol(m))
        for form in summed(node.op, body, k, low, symbol(m)) if least is not None else ():
            infinite = high == INFINITY
            value = _tends(form, m, statement.given) if infinite else substitute(form, {m: high})
            same = Comparison(part, "==", form)
            if value is not None and _induction(same, whole, m, (least or 0) - 1, decided):
                known[node] = value
                break
    return known


def _tends(form: Expr, n: str, given: Given) -> Expr | None:
    """Return the finite limit as n → ∞, or None; b^(n + c) with |b| < 1 dominates powers of n."""
    raised = (e for e in operations((form,)) if e.op == "^")
    powers = {e for e in raised if n in symbols(e.args[1]) - symbols(e.args[0])}
    small = symbol(fresh("z", symbols(form)))
    put: dict[Expr, Expr] = {}
    for e in powers:
        base, start = e.args[0], substitute(e.args[1], {n: ZERO})
        slope = differentiate(e.args[1], n)
        near = sign(1 - base**slope, given), sign(1 + base**slope, given)
        if near != ("+", "+") or slope not in (ONE, -ONE) or len(powers) > 1:
            return None
        put[e] = small if start == ZERO else base**start * small
    rest = replaced(form, put)
    slope = differentiate(rest, str(small))
    if put and decide(differentiate(slope, str(small)), ZERO, given).verdict is not Verdict.PROVED:
        return None
    for _ in range(3):
        slope = differentiate(slope, n)
    if put and decide(slope, ZERO, given).verdict is not Verdict.PROVED:
        return None
    value = limit_of(tidied(substitute(rest, {str(small): ZERO})), n, None, 1, given)
    return None if value in (INFINITY, -INFINITY) else value


def _is_long(low: int | None, high: int | None) -> bool:
    return low is not None and high is not None and high - low >= TERMS


def _nodes(claim: Comparison) -> list[Expr]:
    return [node for node in outermost(claim.left, claim.right) if node.op in INSIDE]


def written_out(e: Expr) -> Expr:
    """Return ``e`` with the sums and products between two numbers expanded.

    Raises:
        InputError: a sum has more than ``TERMS`` terms, or its upper end is below a − 1.
    """
    if e.op in LEAVES:
        return e
    if e.op not in INSIDE:
        if e.names:
            return e
        return rebuild(e, tuple(map(written_out, e.args)))
    low, high = (integer(written_out(end)) for end in e.args[1:])
    if low is None or high is None:
        return e
    if not -1 <= high - low < TERMS:
        raise InputError(f"it has {high - low + 1} terms; from 0 to {TERMS} are supported")
    (name,), body = opened(e)
    terms = (written_out(substitute(body, {name: number(k)})) for k in range(low, high + 1))
    return add(ZERO, *terms) if e.op == "sum" else multiply(ONE, *terms)


def _by_powers(e: Expr, given: Given) -> Expr:
    """Return ``e`` with the last index n out of sums whose terms are polynomials in n and 1/n.

    Σ k (n − k) is n Σ k − Σ k². At n = 0 an empty sum of k/n is 0, hence 1/n needs n ≠ 0.
    """
    known = {}
    for node in outermost(e):
        names = symbols(node.args[2]) if node.op == "sum" else frozenset()
        if len(names) != 1 or not names <= symbols(node.args[0]):
            continue
        (n,) = names
        (k,), body = opened(node, given.names)
        r = fresh("r", {k, *symbols(e), *given.names})
        if sign(symbol(n), given, "!=") in PROVING["!="]:
            powers = range(1, MOST_POWERS + 1)
            body = replaced(body, {symbol(n) ** -m: symbol(r) ** m for m in powers})
        split = [_coefficients(part, r) for part in _coefficients(body, n)]
        if split and all(split):
            terms = (
                symbol(n) ** (up - down) * total("sum", term, k, node.args[1], node.args[2])
                for up, parts in enumerate(split)
                for down, term in enumerate(parts)
                if term != ZERO
            )
            known[node] = add(ZERO, *terms)
    return replaced(e, known) if known else e


def _coefficients(e: Expr, n: str) -> list[Expr]:
    """Return the coefficients of n⁰, n¹, … in a polynomial of low degree; none for others."""
    coefficients: list[Expr] = []
    while len(coefficients) <= MOST_POWERS and is_polynomial(e, n):
        coefficients.append(substitute(e, {n: ZERO}))
        e = differentiate(e, n) / len(coefficients)
        if e == ZERO:
            return coefficients
    return []


def _end(node: Expr) -> tuple[str, int, int] | None:
    """Return n, c and a for a sum from a to n + c, and None for other sums."""
    low, high = integer(node.args[1]), node.args[2]
    names = symbols(high)
    if low is None or len(names) != 1 or INFINITY.args[0] in names:
        return None
    (n,) = names
    start = integer(substitute(high, {n: ZERO}))
    inner = opened(node)[1]
    if n in symbols(node.args[0]):  # each of its terms changes with n
        return None
    if (
        differentiate(high, n) != ONE
        or start is None
        or any(part.op in INSIDE or part.names for part in outermost(inner))
    ):
        return None
    return n, start, low


def from_on(statement: Statement, n: str, least: int) -> tuple[Statement, int]:
    """Return the statement without its conditions on ``n``, and the first n that they allow.

    Conditions on n cannot be used in an induction step, since they may fail at n + 1.
    """
    given = statement.given
    low = given.box[n].low if n in given.box else None
    if low is not None:
        first = -int(-low.p // low.q)
        least = max(least, first + (given.box[n].low_open and low.q == 1))
    links = (link for link in given.comparisons if n not in symbols(link[0]) | symbols(link[2]))
    others = (pair for pair in statement.equations if n not in symbols(pair[0]) | symbols(pair[1]))
    return replace(statement, given=Given(tuple(links)), equations=tuple(others)), least


def _at(claim: Comparison, n: str, value: Expr) -> Comparison:
    return claim.mapped(lambda e: written_out(substitute(e, {n: value})))


def _looked_at(
    claim: Comparison, statement: Statement, n: str, least: int, decided: Decide
) -> Answer | None:
    """Return a refutation at a small n, or UNDECIDED if no small n is proved; None otherwise."""
    seen = empty = False
    for value in range(least, least + FIRST):
        no_term = _has_no_term(claim, n, value)
        answer, proved = decided_at([{n: number(value)}], claim, statement, decided)
        if answer is not None and not (n not in statement.given.names and no_term):
            return answer
        empty = empty or answer is not None
        seen = seen or (proved and not no_term)
    if empty:
        why = f"it fails where a sum is empty: add a condition that says from which {n} on it holds"
        return Answer(Verdict.UNDECIDED, why)
    if not seen:
        return Answer(
            Verdict.UNDECIDED,
            f"the claim could not be proved at any small {n}, so induction has no base case",
        )
    return None


def _has_no_term(claim: Comparison, n: str, value: int) -> bool:
    """Return whether a sum of the claim is empty at this n."""
    ends = (_end(node) for node in _nodes(claim))
    return any(end is not None and value + end[1] < end[2] for end in ends)


def _induction(
    claim: Comparison,
    statement: Statement,
    n: str,
    least: int,
    decided: Decide,
) -> Answer:
    fixed = replace(statement, integers=tuple(m for m in statement.integers if m != n))
    base = decided(_at(claim, n, number(least)), fixed)
    if not base:
        why = f"the base case of the induction, {n} = {least}, could not be proved: {base.why}"
        return Answer(Verdict.UNDECIDED, why)
    taken = {*symbols(claim.left), *symbols(claim.right), *statement.given.names}
    now: dict[Expr, Expr] = {}
    later: dict[Expr, Expr] = {}
    up = {n: symbol(n) + 1}
    for node in dict.fromkeys(_nodes(claim)):
        name = fresh("S", taken)
        taken.add(name)
        now[node] = symbol(name)
        (k,), body = opened(node)
        term = substitute(body, {k: node.args[2] + 1})
        later[node] = symbol(name) + term if node.op == "sum" else symbol(name) * term
    left, right = (replaced(side, now) for side in (claim.left, claim.right))
    marks = {node: symbol(f"[{i}]") for i, node in enumerate(now)}
    put = {str(marks[node].args[0]): later[node] for node in now}
    sides = (substitute(replaced(side, marks), up) for side in (claim.left, claim.right))
    first, second = (substitute(side, put) for side in sides)
    after = Comparison(first, claim.relation, second)
    beyond = statement.given & Given(((symbol(n), ">=", number(least)),))
    under = replace(statement, given=beyond)
    if not is_lasting((left, right), beyond, n, *map(str, now.values())):
        why = (
            "induction does not apply: the sides could not be shown to be "
            f"defined at every {n} >= {least}"
        )
        return Answer(Verdict.UNDECIDED, why)
    steps = _smaller_step(Comparison(left, claim.relation, right), after, list(now))
    smaller = [decided(part, under) for part in steps]
    if claim.relation != "==":
        under = replace(under, given=beyond & Given(((left, claim.relation, right),)))
    elif left.op == "symbol":
        after = after.mapped(partial(substitute, mapping={str(left): right}))
    else:
        under = replace(under, equations=(*statement.equations, (left, right)))
    step = worst(smaller) if smaller and all(smaller) else decided(after, under)
    if not step:
        meant = ", ".join(f"{mark} = {node}" for node, mark in now.items())
        answer = _beyond_a_failing_step(claim, statement, n, step, decided)
        if answer is not None:
            return answer
        why = f"the induction step could not be proved (with {meant}: {step.why})"
        if step.verdict is Verdict.REFUTED:
            why = f"the claim at {n} alone does not imply the claim at {n} + 1 (with {meant})"
        return Answer(Verdict.UNDECIDED, why)
    weaker = base if base.verdict is Verdict.ENCLOSED else step
    begin = f"{n} = {least}"
    if _has_no_term(claim, n, least):
        begin += ", where a sum is empty and below which no claim is made"
    why = f"by induction from {begin}: {base.why}; step from {n} to {n} + 1: {step.why}"
    return replace(weaker, why=why, region=None, constant=None)


def _beyond_a_failing_step(
    claim: Comparison, statement: Statement, n: str, step: Answer, decided: Decide
) -> Answer | None:
    """Return a refutation of the claim beside the n at which the induction step fails, or None."""
    point = exact_witness(step) or {}
    start = integer(point[n]) if n in point else None
    if start is None or start > TERMS:
        return None
    near = ({n: number(k)} for k in range(start, start + 3))
    return decided_at(near, claim, statement, decided)[0]


def _smaller_step(now: Comparison, after: Comparison, nodes: list[Expr]) -> list[Comparison]:
    """Return a sufficient condition for the step of S <= g, by monotonicity in S, or nothing."""
    sides = (now.left, now.right) if now.left.op == "symbol" else (now.right, now.left)
    name, bound = str(sides[0]), sides[1]
    is_alone = len(nodes) == 1 and sides[0].op == "symbol" and name not in symbols(bound)
    if now.relation not in ("<", "<=", ">", ">=") or not is_alone:
        return []
    (node,) = nodes
    step = after.mapped(partial(substitute, mapping={name: bound}))
    if node.op == "sum":
        return [replace(step, relation=now.relation[0] + "=")]
    later = after.left if now.left.op == "symbol" else after.right
    return [step, Comparison(differentiate(later, name), ">", ZERO)]


# Derivatives of order n


def decide_repeated(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with a derivative of order n.

    Args:
        decided: the procedure for claims without such a derivative.
    """
    nodes = [n for n in outermost(claim.left, claim.right) if n.op == "nth"]
    solution = claim.solved(nodes[0]) if len(set(nodes)) == 1 else None
    if (
        solution is None
        or claim.relation != "=="
        or claim.derivatives
        or statement.path is not None
    ):
        return Answer(
            Verdict.UNDECIDED,
            ("a derivative of order n is supported only in an equation that is linear in it"),
        )
    g, slope = solution
    answer = _nth_derivative(nodes[0], g, claim, statement, decided)
    return also_at_zeros(answer, [slope], claim, statement, decided, nodes[0]) if answer else answer


def _nth_derivative(
    node: Expr, g: Expr, claim: Comparison, statement: Statement, decided: Decide
) -> Answer:
    """Decide whether the derivative of order n in ``node`` is ``g``."""
    inner, place, order = node.args
    f, x = instantiate(inner, (place,)), str(place)
    if order.op != "symbol" or not elementary(f) or str(order) in symbols(f):
        return Answer(
            Verdict.UNDECIDED,
            "the order of the derivative must be a variable that is not "
            f"in the function, such as n; it is {order}",
        )
    n = str(order)
    plain, least = from_on(statement, n, 0)
    first = Answer(Verdict.UNDECIDED, f"no small value of {n} could be checked")
    for k in range(least, least + FIRST_ORDERS):
        value = folded(substitute(g, {n: number(k)}))
        derivative = f
        for _ in range(k):
            derivative = differentiate(derivative, x)
        if value is None:
            break
        same = Comparison(derivative, "==", value)
        answer, _ = decided_at([{n: number(k)}], same, statement, decided)
        if answer is not None:
            return answer
        first = decided(same, plain) if k == least else first
    if not first:
        why = f"the base case of the induction, {n} = {least}, could not be proved: {first.why}"
        return Answer(Verdict.UNDECIDED, why)
    beyond = plain.given & Given(((order, ">=", number(least)),))
    whole = tuple(dict.fromkeys((*statement.integers, n)))
    if not is_lasting((g,), beyond, n) or not _is_smooth(g, f, x, beyond, whole):
        why = (
            "induction does not apply: the other side could not be shown "
            f"to be smooth for every {n} >= {least}"
        )
        return Answer(Verdict.UNDECIDED, why)
    later = substitute(g, {n: symbol(n) + 1})
    step = decided(
        Comparison(differentiate(g, x), "==", later),
        replace(plain, given=beyond, integers=whole),
    )
    if not step:
        why = f"the induction step from {n} to {n} + 1 could not be proved: {step.why}"
        return Answer(Verdict.UNDECIDED, why)
    why = f"by induction from {n} = {least}: {first.why}; step from {n} to {n} + 1: {step.why}"
    return replace(step, why=why, region=None)


def _is_smooth(g: Expr, f: Expr, x: str, given: Given, integers: tuple[str, ...]) -> bool:
    """Whether ``g`` has a derivative by ``x`` wherever it is defined and ``f`` is smooth."""
    there = ((e, ">" if positive else "!=", ZERO) for e, positive in singularities(f))
    given = given & Given(tuple(there))
    moving = [node for node in operations((g,)) if x in symbols(node)]
    powers = [node.args for node in moving if node.op == "^"]
    return {node.op for node in moving} <= SMOOTH and all(
        is_whole(exponent, integers) or sign(base, given) == "+" for base, exponent in powers
    )
