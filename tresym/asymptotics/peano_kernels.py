"""Bounds of the error of difference formulas and quadrature rules, with the smallest constant.

A linear rule L that is exact for polynomials of degree below p has a Peano kernel: L f is the
integral of K f⁽ᵖ⁾, where K(s) is L applied to (t − s)₊^{p−1}/(p − 1)!. So |L f| ≤ M ∫|K| for all
f with |f⁽ᵖ⁾| ≤ M, and no smaller constant serves for all of them (G. Peano 1913; P. J. Davis,
*Interpolation and Approximation*, 1963, section 3.7). With a step h the kernel scales by a power of
h. It is a polynomial between the points of the rule, and ∫|K| is a rational number where the zeros
of K are rational, else it is enclosed.

Example: ``abs(integral(f(t), t, x, x+h) - h*f(x+h/2)) <= h**3*M/24 given
abs(diff(f(s), s, 2)) <= M, h > 0``. What is said of the derivative is meant at all points.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from math import factorial
from typing import NamedTuple

from flint import arb, fmpq, fmpq_poly

from tresym.asymptotics.jets import UnreadError
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    fresh,
    multiply,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

LEMMA = "the theorem of Peano on kernels (Davis, Interpolation and Approximation, section 3.7)"
LARGEST = 12
"""The largest power of h in a coefficient."""
CLOSE = fmpq(1, 10**60)
"""How close zeros of kernels are found."""
BITS = 512


class _Bound(NamedTuple):
    """What is said of the derivative of a function: abs(diff(f(x), x, order)) < or <= most."""

    name: str
    order: int
    most: Expr
    strict: bool


class _Term(NamedTuple):
    """A coefficient times (s − place)₊ to a power over its factorial, in the kernel."""

    coefficient: fmpq
    place: fmpq
    derivative: int


class _Rule(NamedTuple):
    """A linear rule: its terms for h = 1, the step, and the power of h that is taken out."""

    terms: list[_Term]
    step: Expr
    exponent: int


def decide_peano(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide a bound of |L f| by a bound of a derivative of f; None for other claims."""
    places = _points(statement)
    if places is None:
        return None
    left, relation, right = substitute(claim.left, places), claim.relation, claim.right
    if relation in (">", ">="):
        left, relation, right = right, relation.replace(">", "<"), left
    found = _bound(statement)
    if relation not in ("<", "<=") or found is None or left.op != "abs" or claim.derivatives:
        return None
    if statement.path is not None or any(functions(right)) or places.keys() & symbols(right):
        return None
    rest = [c for c in statement.given.comparisons if not any(any(functions(e)) for e in c[::2])]
    links = (*rest, (found.most, ">" if found.strict else ">=", ZERO))
    if any(places.keys() & symbols(e) for link in links for e in link[::2]):
        return None
    plain = replace(statement, given=Given(links), equations=())
    rule = next(_rules(left.args[0], found), None)
    if rule is None:
        return None
    seen = decided(Comparison(ONE, "<=", ZERO), plain)  # a point of the conditions refutes this
    k = next((k for k in range(found.order) if _moment(rule, k)), None)
    f, p = found.name, found.order
    if k is not None:
        example = f"t**{k}" if k else "1"
        why = f"it is not exact for {f}(t) = {example}: no bound by the derivative holds"
        if seen.verdict is not Verdict.REFUTED:
            return Answer(Verdict.UNDECIDED, f"{why}, if the conditions can hold")
        return Answer(Verdict.REFUTED, why, witness=seen.witness, lemma=LEMMA)
    try:
        low, high, changes = _norm(rule, p)
    except UnreadError as reason:
        return Answer(Verdict.UNDECIDED, str(reason))
    size = _power(rule, p, plain, decided)

    def compared(constant: fmpq, sign: str) -> Answer:
        """Decide whether the constant serves."""
        return decided(Comparison(multiply(number(constant), size, found.most), sign, right), plain)

    shown = _shown(low, high)
    largest = multiply(number(high), size, found.most) if low == high else f"{shown} times {size}"
    error = f"the largest error is {largest}"
    proved = compared(high, relation)
    if proved:
        why = f"for all smooth {f} with this bound at all points {error}, by its Peano kernel"
        return replace(proved, why=f"{why}: {proved.why}", lemma=LEMMA, values=None)
    attained = relation == "<=" or not (changes or found.strict)
    refuting = compared(low, relation if attained else "<=")
    if refuting.verdict is Verdict.REFUTED:
        nearly = "nearly " if changes or found.strict else ""
        monomial = found.most * power(symbol("t"), number(p)) / factorial(p)
        example = f"{f}(t) = {monomial}" if not changes else "splines"
        why = f"{error} for all smooth {f} with this bound, {nearly}reached by {example}"
        return replace(refuting, why=why, lemma=LEMMA, values=None)
    why = f"{error} for all smooth {f} with this bound, but it was not compared: {proved.why}"
    return Answer(Verdict.UNDECIDED, why)


def _points(statement: Statement) -> dict[str, Expr] | None:
    """Return the points that equations name, as for a derivative at x + h; None for others."""
    named: dict[str, Expr] = {}
    for left, right in statement.equations:
        plain = left.op == "symbol" and left.args[0] not in symbols(right) and not right.hidden
        if not plain or left.args[0] in named:
            return None
        named[left.args[0]] = right
    inside = frozenset().union(*map(symbols, named.values()))
    return None if inside & named.keys() else named


def _bound(statement: Statement) -> _Bound | None:
    """Return the only condition on functions, if it bounds the size of a derivative."""
    found: dict[int, tuple[Expr, Expr, bool]] = {}
    for left, relation, right in statement.given.comparisons:
        if not any(any(functions(e)) for e in (left, right)):
            continue
        if ">" in relation:
            left, right = right, left
        strict = relation in ("<", ">")
        if left.op == "abs":
            links = [(1, left.args[0], right), (-1, left.args[0], right)]
        elif left.op == "unknown":
            links = [(1, left, right)]
        else:  # the condition -M <= diff(f(x), x)
            links = [(-1, right, -left)]
        for side, e, most in links:
            if relation not in ("<", "<=", ">", ">=") or side in found or e.op != "unknown":
                return None
            found[side] = (e, most, strict)
    if len(found) != 2:
        return None
    (e, most, strict), (other, least, also) = found.values()
    if e != other or strict != also or normal_form(most - least, Given()) != ZERO:
        return None
    name, orders = e.args[0].args
    plain = len(e.args) == 2 and e.args[1].op == "symbol" and name != FACTORIAL and orders[0] > 0
    moving = any(functions(most)) or symbols(e.args[1]) & symbols(most)
    return _Bound(name, orders[0], most, strict) if plain and not moving else None


def _rules(e: Expr, bound: _Bound) -> Iterator[_Rule]:
    """Yield the ways to read an expression as a linear rule with a step."""
    atoms = list(dict.fromkeys(outermost(e)))
    moving = frozenset().union(*(symbols(a) for node in atoms for a in node.args[1:]))
    for name in sorted(moving):
        yield from _rule(e, symbol(name), bound)
    fixed = {a for node in atoms for a in node.args[1:] if a.op == "number"}
    for other in sorted(moving):
        for one in (*map(symbol, sorted(moving - {other})), *sorted(fixed, key=str)):
            h = symbol(fresh("h", symbols(e)))
            for rule in _rule(substitute(e, {other: one + h}), h, bound):
                yield rule._replace(step=symbol(other) - one)
    if not moving:
        yield from _rule(e, symbol(fresh("h", symbols(e))), bound, ONE)


def _rule(e: Expr, h: Expr, bound: _Bound, step: Expr | None = None) -> Iterator[_Rule]:
    """Yield an expression as a linear rule with step h, if it is one."""
    atoms = list(dict.fromkeys(outermost(e)))
    names: dict[Expr, Expr] = {}
    for node in atoms:
        names[node] = symbol(fresh("z", {*symbols(e), *(n.args[0] for n in names.values())}))
    linear = replaced(e, names)
    nothing = {variable.args[0]: ZERO for variable in names.values()}
    if not atoms or normal_form(substitute(linear, nothing), Given()) != ZERO:
        return
    terms: list[_Term] = []
    bases: set[Expr] = set()
    exponents: set[int] = set()
    for node, variable in names.items():
        value = _scaled(differentiate(linear, variable.args[0]), h, step is not None)
        read = _places(node, h, bound, bases, step is not None)
        if value is None or read is None:
            return
        (coefficient, n), (places, order) = value, read
        if order >= bound.order:
            return
        exponents.add(n - order)
        terms += [_Term(coefficient * sign, place, order) for sign, place in places]
    if len(bases) == 1 and (len(exponents) == 1 or step is not None):
        yield _Rule(terms, h if step is None else step, 0 if step is not None else exponents.pop())


def _scaled(e: Expr, h: Expr, fixed: bool) -> tuple[fmpq, int] | None:
    """Return c and n of a coefficient c h**n."""
    for n in range(1) if fixed else range(-LARGEST, LARGEST + 1):
        quotient = normal_form(multiply(e, power(h, number(-n))) if n else e, Given())
        if quotient.op == "number":
            return quotient.args[0], n
    return None


def _places(
    node: Expr, h: Expr, bound: _Bound, bases: set[Expr], fixed: bool
) -> tuple[list[tuple[int, fmpq]], int] | None:
    """Return the places of a value or of the ends of an integral, in steps, and its order."""
    f = node.args[0] if node.op == "integral" else node
    if f.op != "unknown" or len(f.args) != 2 or f.args[0].args[0] != bound.name:
        return None
    (order,) = f.args[0].args[1]
    if node.op == "integral" and f.args[1].op != "bound":
        return None
    ends = [(1, node.args[2]), (-1, node.args[1])] if node.op == "integral" else [(1, f.args[1])]
    places = []
    for sign, end in ends:
        if end.hidden:
            return None
        slope = normal_form(differentiate(end, h.args[0]), Given())
        base = normal_form(substitute(end, {h.args[0]: ZERO}), Given())
        if fixed:
            slope, base = base, ZERO
        if slope.op != "number":
            return None
        bases.add(base)
        places.append((sign, slope.args[0]))
    return places, order - (node.op == "integral")


def _moment(rule: _Rule, k: int) -> fmpq:
    """Return the rule applied to t**k/k!, with step 1."""
    total = fmpq(0)
    for coefficient, place, derivative in rule.terms:
        if k >= derivative:
            total += coefficient * place ** (k - derivative) / factorial(k - derivative)
    return total


def _norm(rule: _Rule, p: int) -> tuple[fmpq, fmpq, bool]:
    """Return bounds of the integral of the absolute kernel, and whether the kernel changes sign."""
    knots = sorted({term.place for term in rule.terms})
    signs: set[int] = set()
    low = high = fmpq(0)
    for left, right in itertools.pairwise(knots):
        kernel = fmpq_poly([0])
        for coefficient, place, derivative in rule.terms:
            if place >= right:
                n = p - 1 - derivative
                kernel += coefficient / factorial(n) * fmpq_poly([place, -1]) ** n
        if kernel == 0:
            continue
        near = [x for x in _zeros(kernel) if left - CLOSE < x[0] < right + CLOSE]
        zeros = [zero for zero, _ in near]
        inexact = sum(not exact for _, exact in near)
        cuts = [left, *(zero for zero in zeros if left < zero < right), right]
        primitive = kernel.integral()
        for start, end in itertools.pairwise(cuts):
            size = primitive(end) - primitive(start)
            signs.add(1 if size > 0 else -1)
            low, high = low + abs(size), high + abs(size)
        steepest = (
            sum((abs(c) for c in kernel.coeffs()), fmpq(0)) * (1 + abs(left) + abs(right)) ** p
        )
        error = 2 * inexact * steepest * CLOSE
        low, high = low - error, high + error
    return low, high, len(signs) > 1


def _zeros(kernel: fmpq_poly) -> list[tuple[fmpq, bool]]:
    """Return the real zeros of odd multiplicity, and whether they are exact or within CLOSE."""
    found: list[tuple[fmpq, bool]] = []
    rational = _rational(kernel)
    with ball_precision(BITS):
        for root, multiplicity in kernel.numer().complex_roots():
            if multiplicity % 2 == 0 or not root.imag.contains(0):
                continue
            exact = [(r, True) for r in rational if root.real.overlaps(arb(r))]
            if exact:
                found += exact
                continue
            if root.real.rad() > CLOSE:
                raise UnreadError("a zero of its Peano kernel was not found")
            mantissa, exponent = root.real.mid().man_exp()
            found.append((fmpq(mantissa) * fmpq(2) ** int(exponent), False))
    return sorted(found)


def _rational(kernel: fmpq_poly) -> list[fmpq]:
    """Return the rational zeros."""
    factors = kernel.numer().factor()[1]
    return [fmpq(-int(q[0]), int(q[1])) for q, _ in factors if q.degree() == 1]


def _power(rule: _Rule, p: int, plain: Statement, decided: Decide) -> Expr:
    """Return the power of |h| in the bound."""
    n = rule.exponent + p
    if n == 0:
        return ONE
    positive = n % 2 == 0 or decided(Comparison(rule.step, ">=", ZERO), plain)
    return power(rule.step if positive else apply("abs", rule.step), number(n))


def _shown(low: fmpq, high: fmpq) -> str:
    """Return a constant as a fraction, or its first decimals."""
    return str(low) if low == high else str(Decimal(int(low * 10**12)).scaleb(-12)) + "…"
