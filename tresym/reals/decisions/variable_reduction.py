"""Reduce inequalities in several variables to one variable.

- *Homogeneity.* If d(ty, y) = yᵏ d(t, 1) for y > 0, and the conditions and the domain are
  homogeneous as well, the claim at (x, y) is the claim at (x/y, 1).
- *Dependence on a sum.* If d(x, y) = f(x + y), the claim is one about f where x + y may be.
- *Monotonicity.* g(x) ≥ g(y) for x < y holds if g′ ≤ 0 on an interval that contains both.
- *Absolute values.* Π gᵢ(xᵢ) ≥ Π hᵢ(xᵢ) with left side ≥ 0 holds if gᵢ² ≥ hᵢ² for all i.

The remaining claims in one variable go to the procedure for one variable.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import needs, with_domain
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    factors_in,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

Decide = Callable[[Expr, str, Expr, Given], Answer]
DEGREES = tuple(fmpq(n, 2) for n in (0, 2, 4, -2, 6, 8, 1, -4, 3))
Comparison = tuple[Expr, str, Expr]
STARTS = 8


def by_one_variable(
    left: Expr, relation: str, right: Expr, given: Given, decide: Decide
) -> Answer | None:
    """Decide ``>=`` or ``>`` by claims in one variable; None if no reduction applies.

    Expressions with jumps (sign, atan2) are not reduced, since the normal form ignores jumps.
    """
    if _jumps((left, right, *(c.expression for c in given.conditions))):
        return None
    for method in (_scaled, _of_one_part, _monotone, _by_sizes):
        answer = method(left, relation, right, given, decide)
        if answer is not None:
            return answer
    return None


def _jumps(expressions: Iterable[Expr]) -> bool:
    return any(
        e.op in ("sign", "atan2") or (e.op not in LEAVES and _jumps(e.args)) for e in expressions
    )


# -- scaling ------------------------------------------------------------------------------------


def _scaled(left: Expr, relation: str, right: Expr, given: Given, ask: Decide) -> Answer | None:
    names = sorted(symbols(left - right) | given.names)
    if len(names) != 2:
        return None
    for x, y in (names, names[::-1]):
        if sign(symbol(y), given) != "+":
            continue
        parts = [left - right, *(c.expression for c in given.conditions)]
        parts += [e for e, _ in needs((left, right))]
        if not all(_is_homogeneous(e, x, y, given) for e in parts):
            continue
        put_in = partial(substitute, mapping={y: ONE})
        one = tuple(c for c in given.mapped(put_in).comparisons if symbols(c[0] - c[2]))
        answer = ask(put_in(left), relation, put_in(right), Given(one))
        if answer.verdict is Verdict.UNDECIDED:
            return None
        if answer.witness is not None:
            return replace(answer, witness={**answer.witness, y: "1"})
        return replace(
            answer,
            why=(
                f"the claim is homogeneous, so it is enough to prove it for {y} = 1: {answer.why}"
            ),
            region=None,
        )
    return None


def _is_homogeneous(e: Expr, x: str, y: str, given: Given) -> bool:
    """Whether e(xy, y) = yᵏ e(x, 1) for x of the same sign and y > 0."""
    left, right = substitute(e, {x: symbol(x) * symbol(y)}), substitute(e, {y: ONE})
    signs = {"+": (">",), "-": ("<",)}.get(sign(symbol(x), given) or "", ())
    free = Given(((symbol(y), ">", ZERO), *((symbol(x), s, ZERO) for s in signs)))
    with ball_precision():
        at = {x: arb(fmpq(5, 7)) * (-1 if signs == ("<",) else 1)}
        values = [evaluate(left, at | {y: arb(n)}) for n in (3, 1)]
        for degree in DEGREES:
            wrong = values[0] - values[1] * arb(3) ** arb(degree)
            if wrong.is_finite() and not wrong.contains(0):
                continue
            if is_zero(left - symbol(y) ** number(degree) * right, free):
                return True
    return False


# -- sums and products of two -------------------------------------------------------------------


def _of_one_part(
    left: Expr, relation: str, right: Expr, given: Given, ask: Decide
) -> Answer | None:
    difference, names = left - right, sorted(symbols(left - right))
    if len(names) != 2:
        return None
    part = add(*map(symbol, names))
    f = substitute(difference, {names[1]: ZERO})
    there, region = substitute(f, {names[0]: part}), with_domain(given, left, right)
    if _differ(difference, there, given) or not is_zero(difference - there, region):
        return None
    if not all(sign(e, region, r) in PROVING[r] for e, r in needs((there,))):
        return None  # the difference may be real where the function of the sum is not
    values = _sum(*(given.box.get(name, Interval()) for name in names))
    answer = ask(f, relation, ZERO, Given(tuple(_within(symbol(names[0]), values))))
    if not answer:
        return None
    return replace(answer, why=f"the difference depends only on {part}: {answer.why}", region=None)


def _differ(e: Expr, other: Expr, given: Given) -> bool:
    """Return whether two expressions differ at one of a few sample points."""
    with ball_precision():
        for point in given.points(sorted(symbols(e)), STARTS):
            at = {name: arb(value) for name, value in point.items()}
            wrong = evaluate(e, at) - evaluate(other, at)
            if wrong.is_finite():
                return not wrong.contains(0)
    return False


def _sum(one: Interval, other: Interval) -> Interval:
    low = None if one.low is None or other.low is None else one.low + other.low
    high = None if one.high is None or other.high is None else one.high + other.high
    return Interval(low, high, one.low_open or other.low_open, one.high_open or other.high_open)


def _within(x: Expr, where: Interval) -> Iterator[Comparison]:
    if where.low is not None:
        yield x, ">" if where.low_open else ">=", number(where.low)
    if where.high is not None:
        yield x, "<" if where.high_open else "<=", number(where.high)


# -- one function at two places -----------------------------------------------------------------


def _monotone(left: Expr, relation: str, right: Expr, given: Given, ask: Decide) -> Answer | None:
    names = sorted(symbols(left - right))
    if len(names) != 2:
        return None
    x, y = names
    g = _at_two_points(collected(left - right), x, y, given)
    if g is None:
        return None
    order = sign(symbol(y) - symbol(x), given)
    if order not in ("+", "-"):
        return None
    first, last = (x, y) if order == "+" else (y, x)
    where = Given((*_bounds(first, 1, x, given), *_bounds(last, -1, x, given)))
    slope = differentiate(g, x)
    if not all(sign(e, where, r) in PROVING[r] for e, r in needs((g, slope))):
        return None  # a jump or a pole between the two
    sides = (ZERO, slope) if order == "+" else (slope, ZERO)
    answer = ask(sides[0], relation, sides[1], where)
    if not answer:
        return None
    why = (
        f"the difference is that of {g} at two points, and its "
        f"derivative has constant sign: {answer.why}"
    )
    return replace(answer, why=why, region=None)


def _at_two_points(difference: Expr, x: str, y: str, given: Given) -> Expr | None:
    """Return g if the difference is g(x) − g(y), or one of two terms with quotient g(x)/g(y)."""
    terms = difference.args if difference.op == "+" else (difference,)
    g, other = add(*(term for term in terms if symbols(term) == {x})), {x: symbol(y)}
    if is_zero(difference - g + substitute(g, other), Given()):
        return g
    for up, down in (terms, terms[::-1]) if len(terms) == 2 else ():
        if sign(up, given) == sign(-down, given) == "+":
            over, under = (factors_in(e) for e in (up, -down))
            factors = (*over, *(1 / factor for factor in under))
            g = multiply(*(factor for factor in factors if symbols(factor) == {x}))
            there = substitute(g, other)
            if sign(there, given) == "+" and is_zero(up / -down - g / there, given):
                return g
    return None


def _bounds(name: str, side: int, x: str, given: Given) -> Iterator[Comparison]:
    """The bounds of a variable from below (``side`` 1) or above, as such of ``x``."""
    for condition in given.conditions:
        e = condition.expression
        if symbols(e) == {name} and condition.relation != "!=":
            slope = differentiate(e, name)
            if slope.op == "number" and slope.args[0] * side > 0:
                bound = collected(substitute(e, {name: ZERO}) / -slope)
                relation = condition.relation if side > 0 else condition.relation.replace(">", "<")
                yield symbol(x), relation, bound


# -- products -----------------------------------------------------------------------------------


def _by_sizes(left: Expr, relation: str, right: Expr, given: Given, ask: Decide) -> Answer | None:
    difference = collected(left - right)
    if difference.op != "+" or len(difference.args) != 2:
        return None
    for above, below in (difference.args, difference.args[::-1]):
        pairs = [
            _by_variable(*_factors_and_reciprocals(above, 1)),
            _by_variable(*_factors_and_reciprocals(below, 1)),
        ]
        names = sorted({*(pairs[0] or ()), *(pairs[1] or ())} - {""})
        if None in pairs or len(names) < 2 or sign(above, given, ">=") not in PROVING[">="]:
            continue
        answers = []
        for n, name in enumerate(names):
            sides = [
                (part.get(name, ONE) * (ONE if n else part.get("", ONE))) ** 2
                for part in pairs
                if part is not None
            ]
            own = Given(tuple(dict.fromkeys(_alone(name, given))))
            answers.append(ask(sides[0], relation, sides[1], own))
            if not answers[-1]:
                break
        if all(answers):
            return _weakest(answers, "proved for the absolute value of each factor separately")
    return None


def _by_variable(*factors: Expr) -> dict[str, Expr] | None:
    """The factors, multiplied by variable, what has none under ""; None where one has several."""
    parts: dict[str, Expr] = {}
    for factor in factors:
        names = symbols(factor)
        if len(names) > 1:
            return None
        name = next(iter(names), "")
        parts[name] = parts.get(name, ONE) * factor
    return parts


def _factors_and_reciprocals(e: Expr, power: int) -> Iterator[Expr]:
    """The factors of a product to a power, 1 or −1."""
    if e.op == "*":
        for factor in e.args:
            yield from _factors_and_reciprocals(factor, power)
    elif e.op == "^" and e.args[1] == -ONE:
        yield from _factors_and_reciprocals(e.args[0], -power)
    else:
        yield e if power > 0 else 1 / e


def _alone(name: str, given: Given) -> Iterator[Comparison]:
    """What the conditions say of one variable: its own, and ends of others that bound it too."""
    for comparison, condition in zip(given.comparisons, given.conditions, strict=True):
        e = condition.expression
        if symbols(e) == {name}:
            yield comparison
        elif len(symbols(e)) == 1:
            (other,) = symbols(e)
            for side in (1, -1):
                for _, relation, end in _bounds(other, side, name, given):
                    if (
                        sign(side * (symbol(name) - end), given)
                        in PROVING[relation.replace("<", ">")]
                    ):
                        yield symbol(name), relation, end


def _weakest(answers: list[Answer], what: str) -> Answer:
    """Combine several answers that hold into one."""
    weakest = next((a for a in answers if a.verdict is Verdict.ENCLOSED), answers[0])
    return replace(weakest, why=f"{what}: {weakest.why}", region=None)
