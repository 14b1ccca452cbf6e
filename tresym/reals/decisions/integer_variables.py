"""Integer variables: cases modulo M, and counterexamples among small integers.

For n = M m + r with r = 0, …, M − 1, where M makes whole turns of the angles in which n stands and
even numbers of the exponents of what may be negative, an expression loses these angles, and
b^(s m + t) is (b²)^(s m/2) b^t: so sin(nπ) is 0, cos(nπ) and (−1)^n are 1 and −1 in turn. What then
holds for every real m holds for every integer n; where it does not, n is looked at for small
numbers one by one, and beyond them. A power x^n is one of x ≠ 0.

A refutation is one at integers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice, product
from math import lcm, prod

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Decide, exact_text, exactly, refuted, worst
from tresym.reals.decisions.exceptional_values import may_be_defined
from tresym.reals.decisions.readable_witnesses import constants_hold, decided_at, exact_witness
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import integral, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    integer,
    multiply,
    number,
    opened,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.polynomials import Monomial, as_expression, polynomial
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

PERIODIC = frozenset(("sin", "cos", "tan", "cot", "sec", "csc"))
MOST_RESIDUES = 48
SMALL = 3
"""Up to where, on both sides of 0, integers are looked at one by one."""
LOOKED_AT = (1, 2, 0, 3, -1, 4, -2, 5, 7, -3, 10, 20, 100)
MOST_POINTS, SHOWN = 120, 14
AT_AN_END, BESIDE = 4, 2
"""How many integers are looked at from the end of a range, and beside a real counterexample."""
MODULI = (2, 3, 4, 5, 7, 8, 9, 11, 13, 16, 25, 27)
MOST_TRIED, MOST_SIZE = 5000, 200


def decide_whole(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim in which some variables are integers.

    Args:
        decided: the procedure for claims about real variables.
    """
    sides = [claim.left, claim.right, *statement.said]
    if statement.path is not None and statement.path.point is not None:
        sides.append(statement.path.point)
    spoken_of = frozenset().union(*map(symbols, sides))
    names = [name for name in statement.integers if name in spoken_of]
    plain = replace(statement, integers=())
    if not names:
        return decided(claim, plain)
    answer, proved = decided_at(_small(names, statement.given), claim, plain, decided)
    if answer is not None:
        return answer
    if not proved:
        why = f"the claim could not be proved at any small integer {', '.join(names)}"
        return Answer(Verdict.UNDECIDED, why)
    exact = _by_divisors(claim, statement, names)
    if exact is not None:
        return exact
    answer = _by_residues(claim, plain, names, decided)
    if not answer and len(names) == 1:
        beyond = _beyond(claim, statement, names[0], decided)
        answer = answer if beyond is None else beyond
    if answer.verdict is Verdict.REFUTED:  # at what need be no integer
        near = decided_at(_beside(answer, names, statement.given), claim, plain, decided)[0]
        if near is not None:
            return near
        return Answer(
            Verdict.UNDECIDED,
            (f"undecided for integers; it is false for real values: {answer.why}"),
        )
    return replace(answer, why=f"for integers {', '.join(names)}: {answer.why}", region=None)


def with_integer_bounds(given: Given, integers: Iterable[str]) -> Given:
    """Return the conditions with integer bounds for the integers: n > 1/2 becomes n >= 1."""
    links = []
    for name in integers:
        low, high = given.box.get(name, Interval())[:2]
        strict = {c.expression for c in given.conditions if c.relation == ">"}
        n = symbol(name)
        if low is not None:
            end = int(low.ceil())
            links.append((n, ">=", number(end + (n - number(low) in strict and end == low))))
        if high is not None:
            end = int(high.floor())
            links.append((n, "<=", number(end - (number(high) - n in strict and end == high))))
    return given & Given(tuple(links))


def _small(names: list[str], given: Given) -> Iterator[dict[str, Expr]]:
    """Small integers that the conditions on them alone allow."""
    count = 0
    ends = [_from_end(name, given) for name in names]
    for values in islice(product(*ends), MOST_POINTS):
        at = dict(zip(names, map(number, values), strict=True))
        if _given_at(given, at) is not None:
            yield at
            count += 1
            if count == SHOWN:
                return


def _from_end(name: str, given: Given) -> list[int]:
    """Integers that are looked at, the first ones from an end of a range among them."""
    low, high = given.box.get(name, Interval())[:2]
    values: list[int] = []
    if low is not None and abs(low) > LOOKED_AT[3]:
        start = int(low.ceil())
        values += range(start, start + AT_AN_END)
    if high is not None and abs(high) > LOOKED_AT[3]:
        start = int(high.floor())
        values += range(start, start - AT_AN_END, -1)
    return list(dict.fromkeys((*values, *LOOKED_AT)))


def _beside(found: Answer, names: list[str], given: Given) -> Iterator[dict[str, Expr]]:
    """Integers next to the point of a refutation for real values, the nearest first."""
    point = exact_witness(found) or {}
    if not all(name in point and point[name].op == "number" for name in names):
        return
    values = [point[name].args[0] for name in names]
    for near in islice(product(*map(_around, values)), MOST_POINTS):
        at = dict(zip(names, map(number, near), strict=True))
        if _given_at(given, at) is not None:
            yield at


def _around(x: fmpq) -> list[int]:
    """Return the integers next to ``x``, the nearest first."""
    near = range(int(x.floor()) - BESIDE, int(x.ceil()) + BESIDE + 1)
    return sorted(near, key=lambda k: abs(k - x))


def _given_at(given: Given, at: dict[str, Expr]) -> Given | None:
    """The conditions at these values; None where one of them fails, or may."""
    return constants_hold(given.mapped(partial(substitute, mapping=at)).comparisons)


# Polynomials


def _by_divisors(claim: Comparison, statement: Statement, names: list[str]) -> Answer | None:
    """The answer where it is claimed that a polynomial in integers has no zero; else None.

    It has none where it has none modulo some number; a zero is looked for among small integers.
    """
    given, left, right = statement.given, claim.left, claim.right
    terms = _terms(left - right, ONE) if claim.relation == "!=" and not claim.derivatives else {}
    if not terms or symbols(left) | symbols(right) != {*names} or statement.equations:
        return None
    scale = lcm(*(int(c.q) for c in terms.values()))
    whole = [(int((c * scale).p), [dict(m).get(n, 0) for n in names]) for m, c in terms.items()]

    def value(at: tuple[int, ...], m: int) -> int:
        powers = (c * prod(pow(x, k, m) for x, k in zip(at, ks, strict=True)) for c, ks in whole)
        return sum(powers) % m

    for m in MODULI:
        if m ** len(names) <= MOST_TRIED and all(
            value(at, m) for at in product(range(m), repeat=len(names))
        ):
            return Answer(
                Verdict.PROVED,
                f"for integers {', '.join(names)}: the difference is never 0 modulo {m}",
            )
    size = max(k for k in range(MOST_SIZE) if (2 * k + 1) ** len(names) <= MOST_TRIED)
    for at in sorted(product(range(-size, size + 1), repeat=len(names)), key=_size):
        exact = dict(zip(names, map(number, at), strict=True))
        if sum(c * prod(x**k for x, k in zip(at, ks, strict=True)) for c, ks in whole) == 0 and (
            _given_at(given, exact) is not None
        ):
            point = {name: fmpq(x) for name, x in zip(names, at, strict=True)}
            balls = [arb(evaluate(side, point)) for side in (left, right)]
            return refuted(exactly("both sides are equal", point), point, *balls)
    return None


def _size(at: tuple[int, ...]) -> tuple[int, int, tuple[int, ...]]:
    """Small integers first, positive ones among them."""
    return max(map(abs, at)), sum(x < 0 for x in at), at


# By residues


def _by_residues(
    claim: Comparison, statement: Statement, names: list[str], decided: Decide
) -> Answer:
    """The claim for every residue of every integer, for real values of what remains."""
    cases = residues(claim, statement, names, statement.given)
    if cases is None:
        why = f"the integers could not be split into at most {MOST_RESIDUES} residue classes"
        return Answer(Verdict.UNDECIDED, f"{why} in which the claim simplifies")
    nodes = outermost(claim.left, claim.right)
    integers = tuple(names) if any(node.op != "unknown" for node in nodes) else ()
    answers = []
    for number_of, (case, inside) in enumerate(cases):
        answers.append(decided(case, replace(inside, integers=integers)))
        if not answers[-1]:
            answers[-1] = _in_class(answers[-1], claim, statement, names, number_of)
            break
    return worst(answers)


def _in_class(
    found: Answer, claim: Comparison, statement: Statement, names: Sequence[str], place: int
) -> Answer:
    """Return a refutation in one of the residue classes with its values of the integers."""
    point = exact_witness(found)
    if found.verdict is not Verdict.REFUTED or point is None:
        return found
    moved = _moduli(claim, statement, names, statement.given)
    rests = list(product(*map(range, moved)))[place]
    witness = dict(found.witness or {})
    for name, period, rest in zip(names, moved, rests, strict=True):
        if name in point:
            witness[name] = exact_text(point[name] * period + rest)
    return replace(found, witness=witness, why=found.why if max(moved) == 1 else "it fails")


def residues(
    claim: Comparison, statement: Statement, names: Sequence[str], given: Given
) -> list[tuple[Comparison, Statement]] | None:
    """Return the claim and its conditions in each residue class, or None if they are too many.

    Args:
        names: the integers, n = M m + r, whose names then stand for the numbers m.
        given: what is known of them.
    """
    periods = _moduli(claim, statement, names, given)
    if prod(periods) > MOST_RESIDUES:
        return None
    cases = []
    for rest in product(*map(range, periods)):
        parts = zip(names, periods, rest, strict=True)
        at = {n: number(p) * symbol(n) + number(r) if p > 1 else symbol(n) for n, p, r in parts}
        moved = given.mapped(partial(substitute, mapping=at))
        change = partial(residue_of, at=at, names=names, given=moved)
        cases.append((claim.mapped(change), statement.mapped(change)))
    return cases


def _moduli(
    claim: Comparison, statement: Statement, names: Sequence[str], given: Given
) -> list[int]:
    """Return the modulus M of each integer; more than the largest one where there is none."""
    ends = (INFINITY, -INFINITY)
    trees = [e for e in (claim.left, claim.right) if e not in ends]
    trees += [*claim.differentiated, *statement.said]
    return [period_of(trees, name, given) or MOST_RESIDUES + 1 for name in names]


def residue_of(e: Expr, at: dict[str, Expr], names: Sequence[str], given: Given) -> Expr:
    """``e`` at integers of a residue: see :func:`reduced_in`."""
    return reduced_in(substitute(e, at), names, given)


def period_of(trees: Iterable[Expr], name: str, given: Given) -> int | None:
    """M such that n = M m + r leaves no angle and no exponent of what may be negative."""
    period = 1
    for node, inside in _operations(trees, given):
        if node.op in PERIODIC and name in symbols(node):
            inner, unit = node.args[0], PI
        elif _is_alternating(node, name, inside):
            inner, unit = node.args[1], ONE
        else:
            continue
        turns = _ratio(differentiate(inner, name), unit)
        if turns is not None:
            period = lcm(period, int(turns.q) * (1 if int(turns.p) % 2 == 0 else 2))
        else:  # (2 q m + r)^k - r^k is a multiple of 2 q; what is no polynomial is left as it is
            terms = _terms(inner, unit)
            period = lcm(period, *(2 * int(c.q) for m, c in terms.items() if name in dict(m)))
    return period if period <= MOST_RESIDUES else None


def _is_alternating(node: Expr, name: str, given: Given) -> bool:
    """Whether it is a power of what may be negative, with the integer in its exponent."""
    if node.op != "^" or name not in symbols(node.args[1]):
        return False
    base = node.args[0]
    if base.loose:
        return True
    if base.op == "^":
        power_of = integer(base.args[1])
        return power_of is None or power_of % 2 == 1
    return sign(base, _without_powers(given), dear=False) not in ("+", ">=0")


def _without_powers(given: Given) -> Given:
    """The conditions without variable exponents: a**n != 0 would be taken to require a >= 0."""
    links = (
        link
        for link in given.comparisons
        if not any(e.op == "^" and symbols(e.args[1]) for e in operations(link[::2]))
    )
    return Given(tuple(links))


def _operations(trees: Iterable[Expr], given: Given) -> Iterator[tuple[Expr, Given]]:
    """Yield the operations once, with what is known of their variables: 0 <= x in ∫₀¹ f(x) dx."""
    seen: set[Expr] = set()
    stack = list(trees)
    while stack:
        node = stack.pop()
        if node in seen or node.op in LEAVES:
            continue
        seen.add(node)
        if node.op == "integral":
            _, body, inside = _under_the_integral(node, given)
            stack.extend(node.args[1:])
            yield from _operations((body,), inside)
        else:
            stack.extend(node.args)
            yield node, given


def _under_the_integral(node: Expr, given: Given) -> tuple[str, Expr, Given]:
    """Return the variable of an integral, the integrand, and the conditions with its range."""
    (x,), body = opened(node, given.names)
    low, high = node.args[1:]
    if not {low, high} & {INFINITY, -INFINITY}:
        if sign(low - high, given, dear=False) in ("+", ">=0"):
            low, high = high, low
        elif sign(high - low, given, dear=False) not in ("+", ">=0"):
            return x, body, given
    elif low == INFINITY or high == -INFINITY:
        return x, body, given
    ends = [(symbol(x), ">=", low)] if low != -INFINITY else []
    ends += [(symbol(x), "<=", high)] if high != INFINITY else []
    return x, body, given & Given(tuple(ends))


def alternates(claim: Comparison, statement: Statement) -> bool:
    """Whether a power of what may be negative has an integer in its exponent.

    It must be reduced before its sign is asked for, which is that of a power of what is positive.
    """
    sides = [claim.left, claim.right, *claim.differentiated]
    integrals = [n for n in outermost(*sides) if n.op == "integral"]
    trees = [*integrals, *statement.said] if integrals else [*sides, *statement.said]
    return any(
        _is_alternating(node, name, inside)
        for name in statement.integers
        for node, inside in _operations(trees, statement.given)
    ) or any(
        # beside an integral (-1)**n may wait, but a**n would be taken to be real only for a > 0
        node.op == "^" and symbols(node.args[0]) and _is_alternating(node, name, inside)
        for name in statement.integers
        for node, inside in _operations(sides if integrals else (), statement.given)
    )


def _ratio(e: Expr, unit: Expr) -> fmpq | None:
    """The rational r with ``e = r unit``, of a small denominator; None if there is none."""
    if symbols(e) or e.loose:
        return None
    with ball_precision():
        ball = evaluate(e / unit, {})
        if not ball.is_finite():
            return None
        for q in range(1, MOST_RESIDUES + 1):
            p = (ball * q).unique_fmpz()
            if p is not None:
                ratio = fmpq(int(p), q)
                return ratio if is_zero(e - number(ratio) * unit, Given()) else None
    return None


def reduced_in(e: Expr, names: Iterable[str], given: Given) -> Expr:
    """``e`` without whole turns and with even powers apart, for integer values of ``names``."""
    names = list(names)
    for name in names:
        e = _reduced(e, name, names, given)
    return e


def _reduced(e: Expr, name: str, names: list[str], given: Given) -> Expr:
    if e.op in LEAVES or name not in symbols(e):
        return e
    if e.op == "integral":
        x, body, inside = _under_the_integral(e, given)
        ends = (_reduced(end, name, names, given) for end in e.args[1:])
        return integral(_reduced(body, name, names, inside), x, *ends)
    args = tuple(_reduced(arg, name, names, given) for arg in e.args)
    if e.op in PERIODIC:
        turns = _ratio(differentiate(args[0], name), 2 * PI)
        if turns is not None and turns.q == 1:
            return rebuild(e, (substitute(args[0], {name: ZERO}),))
        parts = _without_even(args[0], PI, names) if turns is None else None
        if parts is not None:
            return rebuild(e, (PI * parts[1],))
    if e.op == "^" and _is_alternating(rebuild(e, args), name, given):
        base, exponent = args
        slope = _ratio(differentiate(exponent, name), ONE)
        start = substitute(exponent, {name: ZERO})
        if slope is not None and slope.q == 1 and slope.p % 2 == 0 and symbols(start) <= {*names}:
            square = power(base, number(2))
            even = power(square, multiply(number(slope / 2), symbol(name)))
            even = ONE if square == ONE else even
            return multiply(even, power(base, _as_number(start)))
        parts = _without_even(exponent, ONE, names) if slope is None else None
        if parts is not None:
            square = power(base, number(2))
            return multiply(
                ONE if square == ONE else power(square, parts[0]), power(base, parts[1])
            )
    return rebuild(e, args)


def _terms(e: Expr, unit: Expr) -> dict[Monomial, fmpq]:
    """The terms of ``e`` over the unit, a polynomial in symbols; nothing of what is none."""
    return {} if e.loose or e.hidden else polynomial(e / unit) or {}


def _without_even(e: Expr, unit: Expr, names: list[str]) -> tuple[Expr, Expr] | None:
    """Half of the terms that are even for all integers, and the others; None without such ones."""
    terms = _terms(e, unit)
    even = {
        m: c for m, c in terms.items() if m and (c / 2).q == 1 and {n for n, _ in m} <= {*names}
    }
    if not even:
        return None
    half = add(ZERO, *(number(c / 2) * as_expression(m) for m, c in even.items()))
    others = (number(c) * as_expression(m) for m, c in terms.items() if m not in even)
    return half, add(ZERO, *others)


def _as_number(e: Expr) -> Expr:
    ratio = _ratio(e, ONE)
    return e if ratio is None else number(ratio)


# Beyond small integers


def _beyond(claim: Comparison, statement: Statement, name: str, decided: Decide) -> Answer | None:
    """The claim at each small integer, and for all real values beyond them."""
    n = symbol(name)
    plain = replace(statement, integers=())
    near, far = [], []
    for value in range(-SMALL, SMALL + 1):
        at = {name: number(value)}
        given = _given_at(plain.given, at)
        there = claim.mapped(partial(substitute, mapping=at))
        if given is not None:
            if may_be_defined(there):
                near.append(decided(there, replace(plain, given=given)))
        elif _may_hold(plain.given, at):
            return None
    for side in (((n, ">=", number(SMALL + 1)),), ((n, "<=", number(-SMALL - 1)),)):
        inside = replace(plain, given=plain.given & Given(side))
        low, high = inside.given.box[name][:2]
        if low is not None and high is not None and low > high:
            continue
        far.append(_by_residues(claim, inside, [name], decided))
    answers = near + far
    if not answers or not all(answers):
        return None
    said = [f"each integer up to {SMALL} in absolute value separately"] if near else []
    said += [f"for all larger ones: {worst(far).why}"] if far else []
    return replace(worst(answers), why="; ".join(said))


def _may_hold(given: Given, at: dict[str, Expr]) -> bool:
    """Whether the conditions are not shown to fail at the value."""
    with ball_precision():
        for condition in given.conditions:
            value = substitute(condition.expression, at)
            if not symbols(value):
                ball = evaluate(value, {})
                if ball < 0 or (condition.relation == ">" and ball <= 0):
                    return False
                if condition.relation == "!=" and ball.is_zero():
                    return False
    return True
