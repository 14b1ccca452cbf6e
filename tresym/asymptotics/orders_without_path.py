"""Decide X = O(Y) and X = Theta(Y) for all values of the variables, without a path.

``sqrt(a**2 + b**2) == Theta(a + b) given a > 0, b > 0`` asks for constants that serve for all
values; variables of which nothing is said are real. Sums of monomials of positive variables are
decided by :mod:`tresym.asymptotics.monomials`. Otherwise the ratio is computed at points of several
scales and signs. If it seems to be bounded, a constant above all its values is
tried, and the inequality |X| <= C |Y| is the proof. If it grows along a curve of powers a = ±t**k,
the limit X/Y -> oo along that curve, on which all conditions hold in the end, refutes the order.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, product

from flint import arb, fmpq

from tresym.asymptotics.constants import rounded
from tresym.asymptotics.monomials import decide_monomials
from tresym.reals.decisions.answer import Answer, Decide, constant_ball, exact_text
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import (
    ONE,
    Expr,
    add,
    apply,
    fresh,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.polynomials import as_expression, polynomial
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict

SCALES = tuple(fmpq(*q) for q in ((1, 1000), (1, 20), (2, 3), (1, 1), (3, 2), (20, 1), (1000, 1)))
FEWER = tuple(fmpq(*q) for q in ((1, 300), (1, 1), (3, 2), (300, 1)))
POWERS = (0, 1, -1, 2, -2, 3, -3)
MOST_PARAMETERS = 4
CURVES_TRIED = 3
MARGINS = (fmpq(21, 20), fmpq(2), fmpq(16))
"""By how much a constant exceeds all values of the ratio that were computed."""
_NOT_FOUND = (
    "neither a constant for all values of the parameters nor a curve on which the ratio grows was "
    "found; for a limit give a path, such as x -> 0+"
)


def decide_without_path(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide an O or Theta for all values of the parameters that the conditions allow.

    Where nothing is said of a variable, a path may be meant: then an order that fails for some
    values is not refuted.
    """
    answer = _for_all_values(claim, statement, decided)
    names = symbols(claim.left) | symbols(claim.right)
    free = sorted(names - statement.given.names)
    if answer.verdict is not Verdict.REFUTED or not free:
        return answer
    why = f"it does not hold for all values ({answer.why}): give a path, or conditions on "
    return Answer(Verdict.UNDECIDED, why + ", ".join(free))


def _for_all_values(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide an O or Theta for all values."""
    if claim.relation == "O":
        return _bounded(claim, statement, decided)
    above = _bounded(replace(claim, relation="O"), statement, decided)
    if not above:
        return above
    other = Comparison(claim.right, "O", claim.left)
    below = _bounded(other, statement, decided)
    why = f"with the two sides exchanged: {below.why}"
    if not below:
        return replace(below, why=why)
    verdict = above.verdict if above.verdict is Verdict.ENCLOSED else below.verdict
    return replace(above, verdict=verdict, why=f"{above.why}; and {why}")


def _bounded(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide an O."""
    plain = replace(claim, left=_expanded(claim.left), right=_expanded(claim.right))
    names = sorted(symbols(claim.left) | symbols(claim.right) | statement.given.names)
    signed = _signed(names, statement)
    answer = Answer(Verdict.UNDECIDED, _NOT_FOUND)
    if not signed:
        answer = decide_monomials(plain, statement)
    if statement.equations or statement.integers:
        # A curve of real powers need not satisfy equations, and leaves the integers.
        if answer.verdict is Verdict.REFUTED:
            answer = Answer(Verdict.UNDECIDED, _NOT_FOUND)
        if statement.equations:
            return answer
    if answer.verdict is not Verdict.UNDECIDED or len(names) > MOST_PARAMETERS:
        return answer
    if claim.derivatives or claim.left.hidden or claim.right.hidden:
        return answer
    whole = frozenset(statement.integers)
    statement = _among_reals(statement)
    largest = arb(0)
    with ball_precision():
        scales = SCALES if len(names) + bool(signed) <= 3 else FEWER
        either = (*(-q for q in scales), fmpq(0), *scales)
        for values in product(*(either if name in signed else scales for name in names)):
            at = dict(zip(names, values, strict=True))
            fractions = any(at[name].q != 1 for name in whole if name in at)
            if fractions or not all(c.holds(at) for c in statement.given.conditions):
                continue
            left, right = abs(evaluate(claim.left, at)), abs(evaluate(claim.right, at))
            if right.is_zero() and left > 0:
                witness = {name: exact_text(number(value)) for name, value in at.items()}
                why = "the right side is 0, and the left side is not"
                return Answer(Verdict.REFUTED, why, witness=witness, uniform=False)
            ratio = left / right
            if ratio.is_finite() and ratio.mid() > largest:
                largest = ratio.upper()
    found = _grows(claim, statement, decided, names, whole, signed)
    if found is not None:
        return found
    bounds = [parse_number(rounded(largest * margin, 1)) for margin in MARGINS if largest > 0]
    for bound in sorted({*bounds, fmpq(1)}):
        if bound <= largest:
            continue
        limited = multiply(number(bound), apply("abs", claim.right))
        least = decided(Comparison(apply("abs", claim.left), "<=", limited), statement)
        if least:
            shown = rounded(arb(bound), 1)
            why = f"|left| <= C |right| with C = {shown} for all values allowed: {least.why}"
            return replace(least, why=why, constant=constant_ball(arb(bound)), uniform=True)
    return Answer(Verdict.UNDECIDED, _NOT_FOUND)


def _signed(names: list[str], statement: Statement) -> frozenset[str]:
    """Return the variables that may be negative."""
    box = statement.given.box
    lows = {name: box[name].low if name in box else None for name in names}
    return frozenset(name for name, low in lows.items() if low is None or low < 0)


def _among_reals(statement: Statement) -> Statement:
    """Return the statement for all real values from the first integer on, which is stronger."""
    box = statement.given.box
    least = {name: box[name].first_integer() for name in statement.integers if name in box}
    first = ((symbol(n), ">=", number(low)) for n, low in least.items() if low is not None)
    return replace(statement, integers=(), given=statement.given & Given(tuple(first)))


def _expanded(e: Expr) -> Expr:
    """Return a polynomial as a sum of monomials, and any other expression as it is."""
    found = polynomial(e)
    if not found:
        return e
    return add(*(multiply(number(c), as_expression(m)) for m, c in found.items()))


def _grows(
    claim: Comparison,
    statement: Statement,
    decided: Decide,
    names: list[str],
    whole: frozenset[str],
    signed: frozenset[str],
) -> Answer | None:
    """Refute an O by a curve of powers on which the ratio is proved to tend to infinity.

    Args:
        whole: the names of integers; their exponents are not negative, so that they are integers
            at all integers t.
        signed: the names that may be negative.
    """
    t = fresh("t", names)
    along = replace(statement, given=Given(), path=Path(t, None, (1,)))
    curves = (
        powers
        for powers in _candidates(claim, statement.given, names, signed)
        if all(k >= 0 for n, (_, k) in zip(names, powers, strict=True) if n in whole)
    )
    for powers in islice(curves, CURVES_TRIED):
        curve = {
            n: sign * (symbol(t) ** k if k else ONE)
            for n, (sign, k) in zip(names, powers, strict=True)
        }
        left, right = (substitute(e, curve) for e in (claim.left, claim.right))
        grows = decided(Comparison(apply("abs", left / right), LIMIT, INFINITY), along)
        allowed = (
            Comparison(substitute(low, curve), relation, substitute(high, curve))
            for low, relation, high in statement.given.comparisons
        )
        if grows and all(decided(condition, along) for condition in allowed):
            shown = ", ".join(f"{name} = {value}" for name, value in curve.items())
            why = f"along {shown} the ratio left/right tends to infinity as {t} -> oo"
            return Answer(Verdict.REFUTED, why, witness={}, uniform=False)
    return None


def _candidates(
    claim: Comparison, given: Given, names: list[str], signed: frozenset[str]
) -> Iterator[tuple[tuple[int, int], ...]]:
    """Yield the signs and exponents of curves on which the ratio grows, the simplest first."""
    found = []
    choice = POWERS[: {1: 7, 2: 7, 3: 5}.get(len(names), 3)]
    signs = [(1, -1) if name in signed else (1,) for name in names]
    with ball_precision():
        for powers in product(*(product(sign, choice) for sign in signs)):
            ratios = []
            for scale in (2**8, 2**16):
                at = {n: s * fmpq(scale) ** k for n, (s, k) in zip(names, powers, strict=True)}
                ratios.append(abs(evaluate(claim.left, at) / evaluate(claim.right, at)))
            grows = ratios[0] > 0 and ratios[1] > 2 * ratios[0]
            if grows and all(c.holds(at) for c in given.conditions):
                size = sum(abs(k) + (s < 0) for s, k in powers)
                found.append((size, powers))
    yield from (powers for _, powers in sorted(found))
