"""Variables that take the values of integers alone.

For n = M m + r with r = 0, …, M − 1, where M makes whole turns of the angles in which n stands and
even numbers of the exponents of what may be negative, an expression loses these angles, and
b^(s m + t) is (b²)^(s m/2) b^t: so sin(nπ) is 0, cos(nπ) and (−1)^n are 1 and −1 in turn. What then
holds for every real m holds for every integer n; where it does not, n is looked at for small
numbers one by one, and beyond them. A power x^n is one of x ≠ 0.

A refutation is one at integers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from itertools import islice, product
from math import lcm

from flint import fmpq

from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.claim_parsing import Comparison, Statement
from tresym.reals.decisions.readable_witnesses import constants_hold
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import outermost
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    differentiate,
    multiply,
    number,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

PERIODIC = frozenset(("sin", "cos", "tan", "cot", "sec", "csc"))
MOST_RESIDUES = 48
SMALL = 3
"""Up to where, on both sides of 0, integers are looked at one by one."""
LOOKED_AT = (1, 2, 0, 3, -1, 4, -2, 5, 7, -3, 10, 20, 100)
MOST_POINTS, SHOWN = 120, 14


def decide_whole(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """The answer where some variables are integers.

    Args:
        decided: decides what holds for real values.
    """
    sides = claim.left, claim.right, *statement.said
    spoken_of = frozenset().union(*map(symbols, sides))
    names = [name for name in statement.integers if name in spoken_of]
    plain = replace(statement, integers=())
    if not names:
        return decided(claim, plain)
    seen = False
    for at in _small(names, statement.given):
        given = _given_at(plain.given, at)
        if given is None:
            continue
        put_in = partial(substitute, mapping=at)
        try:
            moved, fixed = claim.mapped(put_in), plain.mapped(put_in)
        except InputError:  # a number on the way is too long
            continue
        found = decided(moved, replace(fixed, given=given))
        if found.verdict is Verdict.REFUTED:
            where = {name: str(value) for name, value in at.items()}
            shown = ", ".join(f"{name} = {value}" for name, value in where.items())
            return replace(
                found, why=f"at {shown}: {found.why}", witness=where | dict(found.witness or {})
            )
        seen = seen or bool(found)
    if not seen:
        why = f"it was shown at no integer {', '.join(names)}, and nothing is proved vacuously"
        return Answer(Verdict.UNDECIDED, why)
    found = _by_residues(claim, plain, names, decided)
    if not found and len(names) == 1:
        beyond = _beyond(claim, statement, names[0], decided)
        found = found if beyond is None else beyond
    if found.verdict is Verdict.REFUTED:  # at what need be no integer
        return Answer(Verdict.UNDECIDED, f"of integers it is open; of real values, {found.why}")
    return replace(found, why=f"for integers {', '.join(names)}: {found.why}", region=None)


def _small(names: list[str], given: Given) -> Iterator[dict[str, Expr]]:
    """Small integers that the conditions on them alone allow."""
    count = 0
    for values in islice(product(LOOKED_AT, repeat=len(names)), MOST_POINTS):
        at = dict(zip(names, map(number, values), strict=True))
        if _given_at(given, at) is not None:
            yield at
            count += 1
            if count == SHOWN:
                return


def _given_at(given: Given, at: dict[str, Expr]) -> Given | None:
    """The conditions at these values; None where one of them fails, or may."""
    return constants_hold(given.mapped(partial(substitute, mapping=at)).comparisons)


# By residues


def _by_residues(
    claim: Comparison, statement: Statement, names: list[str], decided: Decide
) -> Answer:
    """The claim for every residue of every integer, for real values of what remains."""
    trees = (claim.left, claim.right, *claim.differentiated, *statement.said)
    periods = [_period(trees, name, statement.given) for name in names]
    if None in periods:
        return Answer(Verdict.UNDECIDED, "an angle or an exponent has no period in the integers")
    whole = [period for period in periods if period is not None]
    residues = list(islice(product(*map(range, whole)), MOST_RESIDUES + 1))
    if len(residues) > MOST_RESIDUES:
        return Answer(Verdict.UNDECIDED, f"more than {MOST_RESIDUES} residues of the integers")
    answers = []
    holds_integrals = next(outermost(claim.left, claim.right), None) is not None
    for rest in residues:
        at = {
            name: number(period) * symbol(name) + number(r) if period > 1 else symbol(name)
            for name, period, r in zip(names, whole, rest, strict=True)
        }
        given = statement.given.mapped(partial(substitute, mapping=at))
        change = partial(_residue, at=at, names=names, given=given)
        inside = replace(statement.mapped(change), integers=tuple(names) if holds_integrals else ())
        answers.append(decided(claim.mapped(change), inside))
        if not answers[-1]:
            break
    return worst(answers)


def _residue(e: Expr, at: dict[str, Expr], names: list[str], given: Given) -> Expr:
    return reduced_in(substitute(e, at), names, given)


def _period(trees: Iterable[Expr], name: str, given: Given) -> int | None:
    """M such that n = M m + r leaves no angle and no exponent of what may be negative."""
    found = 1
    for node in operations(trees):
        if node.op in PERIODIC and name in symbols(node):
            turns = _ratio(differentiate(node.args[0], name), PI)
        elif _is_alternating(node, name, given):
            turns = _ratio(differentiate(node.args[1], name), ONE)
        else:
            continue
        if turns is None:
            continue  # it is left as it is
        found = lcm(found, int(turns.q) * (1 if int(turns.p) % 2 == 0 else 2))
    return found if found <= MOST_RESIDUES else None


def _is_alternating(node: Expr, name: str, given: Given) -> bool:
    """Whether it is a power of what may be negative, with the integer in its exponent."""
    if node.op != "^" or name not in symbols(node.args[1]):
        return False
    if node.args[0].loose or node.args[0].op == "^":
        return True
    return sign(node.args[0], given, dear=False) != "+"


def alternates(claim: Comparison, statement: Statement) -> bool:
    """Whether a power of what may be negative has an integer in its exponent.

    It must be reduced before its sign is asked for, which is that of a power of what is positive.
    """
    integrals = [n for n in outermost(claim.left, claim.right) if n.op == "integral"]
    trees = integrals or [claim.left, claim.right, *claim.differentiated]
    trees += statement.said
    return any(
        _is_alternating(node, name, Given())
        for node in operations(trees)
        for name in statement.integers
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
                found = fmpq(int(p), q)
                return found if is_zero(e - number(found) * unit, Given()) else None
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
    args = tuple(_reduced(arg, name, names, given) for arg in e.args)
    if e.op in PERIODIC:
        turns = _ratio(differentiate(args[0], name), 2 * PI)
        if turns is not None and turns.q == 1:
            return rebuild(e, (substitute(args[0], {name: ZERO}),))
    if e.op == "^" and _is_alternating(rebuild(e, args), name, given):
        base, exponent = args
        slope = _ratio(differentiate(exponent, name), ONE)
        start = substitute(exponent, {name: ZERO})
        if slope is not None and slope.q == 1 and slope.p % 2 == 0 and symbols(start) <= {*names}:
            square = power(base, number(2))
            even = power(square, multiply(number(slope / 2), symbol(name)))
            even = ONE if square == ONE else even
            return multiply(even, power(base, _as_number(start)))
    return rebuild(e, args)


def _as_number(e: Expr) -> Expr:
    found = _ratio(e, ONE)
    return e if found is None else number(found)


# Beyond small integers


def _beyond(claim: Comparison, statement: Statement, name: str, decided: Decide) -> Answer | None:
    """The claim at each small integer, and for all real values beyond them."""
    n = symbol(name)
    plain = replace(statement, integers=())
    near, far = [], []
    for value in range(-SMALL, SMALL + 1):
        at = {name: number(value)}
        given = _given_at(plain.given, at)
        if given is not None:
            near.append(
                decided(claim.mapped(partial(substitute, mapping=at)), replace(plain, given=given))
            )
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
    said = [f"one by one up to {SMALL} in size"] if near else []
    said += [f"beyond, {worst(far).why}"] if far else []
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
