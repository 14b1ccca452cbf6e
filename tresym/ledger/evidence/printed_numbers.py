"""Printed numbers: compare what the paper prints with what its inputs allow.

A printed decimal stands for the interval of half a unit in its last place around it. A printed
value is accepted (ENCLOSED) if exact inputs in the intervals of the printed inputs are found whose
value lies in the printed interval. It is REFUTED only if balls show that no inputs in these
intervals give such a value.

The statement contains the printed number and the term that it is computed from; the conditions
(`given`) contain the printed inputs. The claims named by the evidence define the other symbols.
Their conditions are checked at the inputs: where one is not confirmed, the term has no value.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any

from flint import arb, ctx, fmpq

from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import DEFINING, Conditions, conditions, defined, known
from tresym.ledger.evidence.at_point import Place, Rule, Rules, roots_by, rules_by
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import Rounded, in_order, in_trees, is_equation
from tresym.reals.balls.branch_and_bound import halves
from tresym.reals.language import expression
from tresym.reals.language.binders import outermost
from tresym.reals.language.expression import Expr, symbol, symbols
from tresym.reals.language.formula import Relation, names
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError, Interval, decimal_ball, printed
from tresym.reals.verdict import Verdict

DIGITS = 50
BITS = 128
GRID = 12
"""Number of grid steps along each side of the box of inputs."""
HALVINGS = 40
WIDEST = 2
"""Largest tolerance in half units of the last place: 1 is the default, 2 means a whole unit."""
CELLS = 4096
"""Maximal number of cells when the range over the box of inputs is enclosed."""

Box = tuple[Interval, ...]
Point = tuple[fmpq, ...]


@dataclass(frozen=True)
class Term:
    """A term, the intervals of its inputs, and rules for its other symbols and roots."""

    term: Expr
    inputs: Mapping[str, Interval]
    rules: Rules
    roots: Mapping[Expr, Rule]
    given: Conditions
    others: Mapping[str, fmpq] = field(default_factory=dict)
    """Values for variables of the used claims that are neither inputs nor defined."""

    constants: dict[int, Place] = field(default_factory=dict, compare=False)
    """Cache, by precision, of the values that do not depend on the inputs."""

    def value(self, sides: tuple[arb, ...]) -> arb:
        """Return a ball for the term at the inputs; NaN if it or a condition is not confirmed."""
        inputs = dict(zip(self.inputs, sides, strict=True))
        others = {name: arb(x) for name, x in self.others.items()}
        fixed = {name: cases for name, cases in self.rules.items() if name not in inputs}
        constant = self.constants.setdefault(ctx.prec, Place(others, fixed, self.roots))
        place = (
            Place({**inputs, **others}, self.rules, self.roots, constant) if inputs else constant
        )
        return place.value(self.term) if place.meets(self.given) else arb.nan()


@dataclass(frozen=True)
class Number:
    """A printed number: its term, the printed text, the tolerance and the resulting interval."""

    of: Term
    text: str
    half_units: int
    target: Interval

    @property
    def inputs(self) -> Mapping[str, Interval]:
        """The intervals of the inputs, by symbol name."""
        return self.of.inputs

    def value(self, sides: tuple[arb, ...]) -> arb:
        """Return a ball for the term at the inputs."""
        return self.of.value(sides)


def number_of(claim: Claim) -> Number:
    """Return the printed number that a claim states.

    Raises:
        InputError: the claim states no printed number, or its claims do not define a symbol or do
            not prove that a root is unique.
    """
    says = claim.statement
    if not isinstance(says, Rounded):
        raise InputError("the claim must state a printed number (Rounds)")
    return Number(term_of(claim, says.term), says.text, says.half_units, _target(says))


def term_of(claim: Claim, term: Expr, box: Mapping[str, Interval] | None = None) -> Term:
    """Return ``term`` with its inputs, rules and conditions as the claim gives them.

    Args:
        claim: the claim; its conditions give printed inputs or exact values.
        term: the expression to evaluate.
        box: intervals of inputs that no condition gives; None if there are none.

    Raises:
        InputError: a symbol has two values or none, or a root is not proved to be unique.
    """
    inputs, rules, plain = _inputs(claim.given)
    twice = {*inputs, *rules} & {*(box or {})}
    if twice:
        raise InputError(f"{min(twice)} is given two values; remove one of the conditions")
    inputs |= box or {}
    known, roots = {**_rules(claim), **rules}, roots_by(claim.rests_on)
    return _grounded(Term(term, inputs, known, roots, conditions(tuple(plain))))


def _inputs(given: tuple[Any, ...]) -> tuple[dict[str, Interval], Rules, list[Any]]:
    """Split the conditions into printed inputs, equations for symbols, and other conditions."""
    inputs: dict[str, Interval] = {}
    rules: dict[str, tuple[Rule, ...]] = {}
    plain: list[Any] = []
    for condition in given:
        part = in_trees(condition)
        if not (isinstance(part, Rounded) or is_equation(part)):
            plain.append(condition)
            continue
        left = part.term if isinstance(part, Rounded) else part.left
        name = str(left)
        if not isinstance(left, Expr) or left.op != "symbol" or name in {*inputs, *rules}:
            raise InputError(f"{part} must give a value to a symbol that has no other value")
        if isinstance(part, Rounded):
            inputs[name] = _target(part)
        else:
            rules[name] = (Rule(part.right, (), None),)
    return inputs, rules, plain


def _target(says: Rounded) -> Interval:
    """Return the interval that a printed decimal stands for."""
    if not 1 <= says.half_units <= WIDEST:
        raise InputError(
            f"the tolerance is {says.half_units} half units of the last place, but only 1 or 2 are "
            "allowed"
        )
    interval = printed(says.text)
    half = interval.width / 2 * says.half_units
    return Interval(interval.middle - half, interval.middle + half)


def _rules(claim: Claim) -> Rules:
    """Return the first rule for each symbol, from the claims used and the definitions behind."""
    behind = (c for c in claim.rests_on if isinstance(c.proof, (*DEFINING, Root)))
    rules = rules_by(dict.fromkeys((*claim.uses, *behind)))
    return {name: cases[:1] for name, cases in rules.items()}


def _grounded(number: Term) -> Term:
    """Return the term after checking that every symbol in it has a value.

    Variables of the used claims that do not occur here, such as the length of M, may have any
    values allowed by the conditions; some such values are chosen.

    Raises:
        InputError: a symbol has no value or two values, a root is not proved to be unique, or an
            input is unused.
    """
    pinned = {*number.inputs, *(n for n, (rule, *_) in number.rules.items() if rule.claim is None)}
    pending = [number.term, *_sides(number.given)]
    used, asked = set[str](), list(number.given)

    def follow(rule: Rule) -> None:
        twice = frozenset() if rule.claim is None else defined(rule.claim) & pinned
        if twice:
            raise InputError(f"{min(twice)} is given a value, but a used claim defines it")
        asked.extend(rule.given)
        pending.append(rule.meaning)
        pending.extend(symbol(n) for c in rule.given for n in names(c) if n in number.rules)

    while pending:
        e = pending.pop()
        for node in outermost(e):
            if node.op == "root" and str(node) not in used:
                used.add(str(node))
                if in_order(node) not in number.roots:
                    raise InputError(f"no claim proves that {node} is unique")
                follow(number.roots[in_order(node)])
        for name in symbols(e) - used:
            used.add(name)
            if name not in number.inputs:
                if name not in number.rules:
                    raise InputError(f"{name} has no value: give it as an input or define it")
                follow(number.rules[name][0])
    idle = {*number.inputs} - used
    if idle:
        raise InputError(f"{min(idle)} is given, but the number does not depend on it")
    return replace(number, others=_others(number, tuple(asked)))


def _others(number: Term, asked: Conditions) -> dict[str, fmpq]:
    """Choose values for symbols of the conditions that are neither inputs nor defined."""
    others = frozenset().union(*map(names, asked)) - {*number.inputs, *number.rules}
    here = tuple(c for c in asked if names(c) <= others | {*number.inputs})
    ends = (
        Relation(symbol(name), sign, expression.number(end))
        for name, side in number.inputs.items()
        for sign, end in ((">=", side.low), ("<=", side.high))
    )
    point = known((*here, *ends)).satisfying_point()
    if point is None:
        raise InputError(
            "no exact point was found that satisfies the conditions; check the conditions"
        )
    return {name: point.get(name, fmpq(1)) for name in others}


def _sides(given: Conditions) -> list[Expr]:
    return [side for c in given for side in (c.left, c.right)]


def judge_printed(claim: Claim) -> Finding:
    """Return the finding on a printed number, with its value at the inputs as printed.

    Raises:
        InputError: as :func:`number_of`.
    """
    number = number_of(claim)
    box = tuple(number.inputs.values())
    centre = tuple(side.middle for side in box)
    with ball_precision(bits(DIGITS, 64)):
        there = number.value(tuple(map(arb, centre)))
        if not there.is_finite():
            why = "the number could not be evaluated at the inputs as printed"
            return Finding(Verdict.UNDECIDED, why)
        value, inside = decimal_ball(there, DIGITS), _side(number, there) == 0
    # One evaluation on the whole box is cheap, and a miss makes the search for inputs superfluous.
    missed = not inside and misses(number, box)
    witness = centre if inside else None if missed else _find_inputs(number, box)
    if witness is not None:
        exact = "the inputs as printed" if witness == centre else "inputs that round to them"
        why = f"{exact} give a value that {_near(number)}"
        point = dict(zip(number.inputs, witness, strict=True))
        return Finding(Verdict.ENCLOSED, why, value=value, witness=point)
    if missed or _excluded(number, box):
        point = dict(zip(number.inputs, centre, strict=True))
        why = f"no inputs that round to the printed ones give {number.text}; as printed they give "
        return Finding(Verdict.REFUTED, why + value.mid[:12], value=value, witness=point)
    why = (
        f"no inputs were found that give {number.text}, but it could not be shown either that "
        "there are none"
    )
    return Finding(Verdict.UNDECIDED, why, value=value)


def _near(number: Number) -> str:
    """Return the words for "the value agrees with the printed number"."""
    if number.half_units == 1:
        return f"rounds to {number.text}"
    return f"is {number.text} to within {number.half_units} half units of its last place"


def _find_inputs(number: Number, box: Box) -> Point | None:
    """Return exact inputs in the box whose value lies in the printed interval, or None.

    If the value is too small at one grid point and too large at another, a point between them is
    found by bisection.
    """
    ends: dict[int, Point] = {}
    for point in _grid(box):
        side = _side_at(number, point)
        if side == 0:
            return point
        if side is not None:
            ends[side] = point
        if len(ends) == 2:
            return _between(number, ends)
    return None


def _between(number: Number, ends: dict[int, Point]) -> Point | None:
    """Find inputs between one with too small and one with too large a value."""
    for _ in range(HALVINGS):
        # Divided 5 : 4, since the value at the midpoint may lie exactly on an end of the interval.
        middle = tuple((5 * p + 4 * q) / 9 for p, q in zip(*ends.values(), strict=True))
        side = _side_at(number, middle)
        if side == 0:
            return middle
        ends[-1 if side == -1 else 1] = middle
    return None


def _side_at(number: Number, point: Point) -> int | None:
    """Return `_side` of the value at exact inputs."""
    with ball_precision(BITS):
        return _side(number, number.value(tuple(map(arb, point))))


def _side(number: Number, value: arb) -> int | None:
    """Return 0 inside the printed interval, −1 below, 1 above, None if the ball is too wide."""
    low, high = number.target[:2]
    if value > low and value < high:
        return 0
    return -1 if value < low else 1 if value > high else None


def _grid(box: Box) -> Iterator[Point]:
    """Yield the corners of the box, then the points of a finer grid."""
    for steps in (1, GRID if len(box) <= 2 else 4):
        sides = (
            [s.low + s.width * n / steps for n in range(steps + 1)] if s.width else [s.low]
            for s in box
        )
        yield from product(*sides)


def _excluded(number: Number, box: Box) -> bool:
    """Return whether bisection shows that no inputs in the box give a value as printed."""
    pending, seen = [box], 0
    while pending:
        cell = pending.pop()
        seen += 1
        if misses(number, cell):
            continue
        widest = max(range(len(cell)), key=lambda n: cell[n].width, default=None)
        if widest is None or not cell[widest].width or seen > CELLS:
            return False
        pending.extend(halves(cell, widest))
    return True


def misses(number: Number, cell: Box) -> bool:
    """Return whether the ball over ``cell`` lies outside the printed interval."""
    with ball_precision(BITS):
        value = number.value(tuple(side.ball() for side in cell))
        return bool(value.is_finite() and _side(number, value) in (1, -1))
