"""Printed numbers: compare what the paper prints with what its inputs allow.

Inputs and outputs are intervals of half a unit in their last printed place. A printed value is
REFUTED only if no inputs that round to the printed inputs give it, and accepted (ENCLOSED) only
with exact inputs, inside those intervals, whose value is inside the printed interval.

The statement says all: the printed number, its term, and under `given` its inputs as they are
printed. What the other symbols are is said by the claims that the evidence names; what these ask
for is shown at the inputs, or the term has no value there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import product

from flint import arb, ctx, fmpq
from sympy import Basic, Eq, Symbol

from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import (
    DEFINING,
    Conditions,
    conditions,
    defined,
    definitions,
    known,
    tree,
)
from tresym.ledger.evidence.at_point import one_root, roots_of
from tresym.ledger.finding import Finding
from tresym.ledger.statements import Rounds
from tresym.reals.balls.branch_and_bound import halves
from tresym.reals.domain.binder_values import At, Enclosing, bracketed, shown, value
from tresym.reals.domain.evaluation import UndefinedError, stands
from tresym.reals.language import expression
from tresym.reals.language.binders import ordered, outermost
from tresym.reals.language.expression import Expr, symbol, symbols
from tresym.reals.language.formula import Relation, names
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError, Interval, decimal_ball, printed
from tresym.reals.verdict import Verdict

DIGITS = 50
BITS = 128
GRID = 12
"""Inputs are tried on a grid of this many steps along each side of their box."""
HALVINGS = 40
WIDEST = 2
"""A printed value is taken to half a unit of its last place, or where it says so to a whole one."""
CELLS = 4096
"""At most this many cells when the range over the box of inputs is enclosed."""

Box = tuple[Interval, ...]
Point = tuple[fmpq, ...]


@dataclass(frozen=True)
class Rule:
    """What a symbol is, or that a root is the only one: where the conditions hold."""

    meaning: Expr
    given: Conditions
    claim: Claim | None


@dataclass(frozen=True)
class Term:
    """A term, over which box its inputs are, and what its symbols are by them."""

    term: Expr
    inputs: Mapping[str, Interval]
    rules: Mapping[str, Rule]
    roots: Mapping[Expr, Rule]
    given: Conditions
    others: Mapping[str, fmpq] = field(default_factory=dict)
    """Values for the variables of the claims that are used of which nothing here speaks."""

    constants: dict[int, Place] = field(default_factory=dict, compare=False)
    """By precision, what does not depend on the inputs."""

    def value(self, sides: tuple[arb, ...]) -> arb:
        """The term at the inputs; NaN where it, or a condition, is not shown."""
        inputs = dict(zip(self.inputs, sides, strict=True))
        others = {name: arb(x) for name, x in self.others.items()}
        fixed = {name: rule for name, rule in self.rules.items() if name not in inputs}
        constant = self.constants.setdefault(ctx.prec, Place(others, fixed, self.roots))
        place = (
            Place({**inputs, **others}, self.rules, self.roots, constant) if inputs else constant
        )
        return place.value(self.term) if place.meets(self.given) else arb.nan()


@dataclass(frozen=True)
class Number:
    """A printed number: its term, and what is printed for it."""

    of: Term
    text: str
    half_units: int
    target: Interval

    @property
    def inputs(self) -> Mapping[str, Interval]:
        """Where the inputs are."""
        return self.of.inputs

    def value(self, sides: tuple[arb, ...]) -> arb:
        """The term at the inputs."""
        return self.of.value(sides)


class Place(dict[str, arb]):
    """What each symbol is at some inputs; what is defined is worked out when it is asked for."""

    def __init__(
        self,
        inputs: Mapping[str, arb],
        rules: Mapping[str, Rule],
        roots: Mapping[Expr, Rule],
        constant: Place | None = None,
    ) -> None:
        """The inputs, what is said of other symbols and of roots, and what is so without inputs."""
        super().__init__(inputs)
        self.rules, self.roots, self.constant = rules, roots, constant
        self._walker = Enclosing(self, partial(bracketed, self._is_one))

    def __missing__(self, name: str) -> arb:
        if self.constant is not None and name in self.rules and self.constant[name].is_finite():
            return self.constant[name]
        rule = self.rules.get(name)
        if rule is None:
            raise UndefinedError
        self[name] = arb.nan()  # what is defined by itself
        if self.meets(rule.given):
            self[name] = self.value(rule.meaning)
        return self[name]

    def value(self, e: Expr) -> arb:
        """``e`` here; NaN where it is not shown to have a value."""
        return shown(e, self._walker)

    def meets(self, given: Conditions) -> bool:
        """Whether balls show the conditions."""
        return all(stands(self.value(c.left - c.right), c.sign) for c in given)

    def _is_one(self, node: Expr, at: At) -> bool:
        """Whether the claim that a root is one says so ``at`` the values that it is asked for."""
        rule = self.roots.get(ordered(node))
        differences = ((c.left - c.right, c.sign) for c in rule.given) if rule else ()
        return rule is not None and all(
            stands(value(e, at, self._is_one), sign) for e, sign in differences
        )


def number_of(claim: Claim) -> Number:
    """The printed number that a claim states.

    Raises:
        InputError: it states none, or a symbol, or that a root is one, is not said by its claims.
    """
    says = claim.statement
    if not isinstance(says, Rounds):
        raise InputError("no printed number is stated")
    return Number(term_of(claim, tree(says.term)), says.text, says.half_units, _target(says))


def term_of(claim: Claim, term: Expr, box: Mapping[str, Interval] | None = None) -> Term:
    """A term that a claim speaks of, under its conditions.

    Args:
        box: where inputs are of which no condition says how they are printed.

    Raises:
        InputError: as for a printed number.
    """
    inputs, rules, plain = _inputs(claim.given)
    twice = {*inputs, *rules} & {*(box or {})}
    if twice:
        raise InputError(f"{min(twice)} is given twice")
    inputs |= box or {}
    known, roots = {**_rules(claim), **rules}, _roots(claim)
    return _grounded(Term(term, inputs, known, roots, conditions(tuple(plain))))


def _inputs(given: tuple[Basic, ...]) -> tuple[dict[str, Interval], dict[str, Rule], list[Basic]]:
    """The inputs as printed, the symbols that are set to a term, and the other conditions."""
    inputs: dict[str, Interval] = {}
    rules: dict[str, Rule] = {}
    plain: list[Basic] = []
    for part in given:
        name = part.args[0]
        if not isinstance(part, Rounds | Eq):
            plain.append(part)
            continue
        if not isinstance(name, Symbol) or name.name in {*inputs, *rules}:
            raise InputError(f"{name} is no symbol of which one thing is given")
        if isinstance(part, Rounds):
            inputs[name.name] = _target(part)
        else:
            rules[name.name] = Rule(tree(part.args[1]), (), None)
    return inputs, rules, plain


def _target(says: Rounds) -> Interval:
    if not 1 <= says.half_units <= WIDEST:
        raise InputError(f"{says.half_units} half units are no last place")
    interval = printed(says.text)
    half = interval.width / 2 * says.half_units
    return Interval(interval.middle - half, interval.middle + half)


def _rules(claim: Claim) -> dict[str, Rule]:
    """What symbols are by the equations that the evidence names, and the definitions behind it."""
    behind = (c for c in claim.rests_on if isinstance(c.proof, (*DEFINING, Root)))
    rules: dict[str, Rule] = {}
    for used in dict.fromkeys((*claim.uses, *behind)):
        meanings = definitions((used,))
        if isinstance(used.proof, Root):
            meanings = {tree(used.proof.symbol): one_root(used.proof.unique)}
        for left, right in meanings.items():
            if left.op == "symbol":
                rule = Rule(right, conditions(used.given), used)
                rules.setdefault(left.args[0], rule)
    return rules


def _roots(claim: Claim) -> dict[Expr, Rule]:
    """The roots of which the claims behind the evidence say that there is one at most."""
    found = roots_of(claim.rests_on)
    return {ordered(node): Rule(node, given, used) for node, given, used in found}


def _grounded(number: Term) -> Term:
    """The term, if all that its term comes to is given, or said by a claim.

    The variables of a claim that nothing here speaks of, such as the length of M, may have any
    values that its conditions allow: some are found.
    """
    pinned = {*number.inputs, *(n for n, rule in number.rules.items() if rule.claim is None)}
    pending = [number.term, *_sides(number.given)]
    used, asked = set[str](), list(number.given)

    def follow(rule: Rule) -> None:
        twice = frozenset() if rule.claim is None else defined(rule.claim) & pinned
        if twice:
            raise InputError(f"{min(twice)} is given, and defined by what is used")
        asked.extend(rule.given)
        pending.append(rule.meaning)
        pending.extend(symbol(n) for c in rule.given for n in names(c) if n in number.rules)

    while pending:
        e = pending.pop()
        for node in outermost(e):
            if node.op == "root" and str(node) not in used:
                used.add(str(node))
                if ordered(node) not in number.roots:
                    raise InputError(f"no claim says that {node} is one at most")
                follow(number.roots[ordered(node)])
        for name in symbols(e) - used:
            used.add(name)
            if name not in number.inputs:
                if name not in number.rules:
                    raise InputError(f"nothing says what {name} is")
                follow(number.rules[name])
    idle = {*number.inputs} - used
    if idle:
        raise InputError(f"{min(idle)} is given, and plays no part")
    return replace(number, others=_others(number, tuple(asked)))


def _others(number: Term, asked: Conditions) -> dict[str, fmpq]:
    """Values for the symbols of the conditions of which nothing else speaks."""
    others = frozenset().union(*map(names, asked)) - {*number.inputs, *number.rules}
    here = tuple(c for c in asked if names(c) <= others | {*number.inputs})
    ends = (
        Relation(symbol(name), sign, expression.number(end))
        for name, side in number.inputs.items()
        for sign, end in ((">=", side.low), ("<=", side.high))
    )
    point = known((*here, *ends)).satisfying_point()
    if point is None:
        raise InputError("no exact point is found that satisfies the conditions")
    return {name: point.get(name, fmpq(1)) for name in others}


def _sides(given: Conditions) -> list[Expr]:
    return [side for c in given for side in (c.left, c.right)]


def judge_printed(claim: Claim) -> Finding:
    """The verdict on one printed number, with its value at the inputs as printed."""
    number = number_of(claim)
    box = tuple(number.inputs.values())
    centre = tuple(side.middle for side in box)
    with ball_precision(bits(DIGITS, 64)):
        there = number.value(tuple(map(arb, centre)))
        if not there.is_finite():
            return Finding(Verdict.UNDECIDED, "no value is shown at the inputs as printed")
        value, inside = decimal_ball(there, DIGITS), _side(number, there) == 0
    # The whole box at once: cheap, and no inputs need be looked for where it misses.
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
    return Finding(Verdict.UNDECIDED, "neither inputs nor an exclusion were found", value=value)


def _near(number: Number) -> str:
    if number.half_units == 1:
        return f"rounds to {number.text}"
    return f"is {number.text} to within {number.half_units} half units of its last place"


def _find_inputs(number: Number, box: Box) -> Point | None:
    """Exact inputs in the box whose value lies in the printed interval.

    Where one point has its value below and another above, the segment between them is halved.
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
    for _ in range(HALVINGS):
        # Not halved: the value at a half may well lie on an end of the printed interval.
        middle = tuple((5 * p + 4 * q) / 9 for p, q in zip(*ends.values(), strict=True))
        side = _side_at(number, middle)
        if side == 0:
            return middle
        ends[-1 if side == -1 else 1] = middle
    return None


def _side_at(number: Number, point: Point) -> int | None:
    with ball_precision(BITS):
        return _side(number, number.value(tuple(map(arb, point))))


def _side(number: Number, value: arb) -> int | None:
    """0 inside the printed interval, −1 below it, 1 above it, None where a ball cannot tell."""
    low, high = number.target[:2]
    if value > low and value < high:
        return 0
    return -1 if value < low else 1 if value > high else None


def _grid(box: Box) -> Iterator[Point]:
    """The corners of the box, and points between."""
    for steps in (1, GRID if len(box) <= 2 else 4):
        sides = (
            [s.low + s.width * n / steps for n in range(steps + 1)] if s.width else [s.low]
            for s in box
        )
        yield from product(*sides)


def _excluded(number: Number, box: Box) -> bool:
    """True when balls over the whole box of inputs stay outside the printed interval."""
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
    """True when the ball over a box of inputs stays outside the printed interval."""
    with ball_precision(BITS):
        value = number.value(tuple(side.ball() for side in cell))
        return bool(value.is_finite() and _side(number, value) in (1, -1))
