"""Mutants: false variants of claims, made mechanically, that no evidence may prove.

A sign is flipped, a coefficient changed by one, an exponent by one or by the factor 2, a and b or
sine and cosine are swapped, a term or a factor is dropped, an inequality is turned round, a printed
digit is moved: in what a claim says (the ends of its chains follow), and in each step alone. What a
claim says is also put to the judge without its chain.

A mutant counts only where balls show it violated: γ ≤ 2a differs from γ ≤ a and is true. What a
definition says cannot be false, and a conjunction is as false as its parts: neither has mutants.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice, product
from typing import Any, cast

from flint import arb
from sympy import (
    Add,
    Basic,
    Derivative,
    Eq,
    Equivalent,
    I,
    Integral,
    MatrixBase,
    Mul,
    Pow,
    Rational,
    Subs,
    Symbol,
    Tuple,
    cos,
    nan,
    oo,
    sin,
    zoo,
)
from sympy.core.relational import Relational

from tresym.arithmetic import ball_precision, balls
from tresym.claims.bounds import Asymptotics, Boxes
from tresym.claims.claim import (
    Chain,
    Claim,
    Formally,
    Printed,
    Step,
    Together,
    UniqueRoot,
    equal,
    formally,
    parts_of,
)
from tresym.claims.enclosure import Bound, Box, Point, value_at
from tresym.claims.judge import refute
from tresym.claims.violation import rootless, scalars
from tresym.exact import Interval, fraction_text, printed
from tresym.notation import a, b

Variant = Any
"""A changed expression, relation or printed text."""

BITS = 128
SPLITS = (1, 4, 16)
CELLS = 16
"""Pieces that each input of a printed number is cut into, and the most cells they may make."""


@dataclass(frozen=True)
class Mutant:
    """A false claim made from ``origin`` by one change at one place."""

    origin: Claim
    place: str
    change: str
    claim: Claim


@dataclass(frozen=True)
class _Spot:
    """A place where a claim can be changed."""

    name: str
    variants: Iterable[Variant]
    claims: Callable[[Variant], tuple[Claim, ...]]
    violated: Callable[[Claim], bool]


def mutants(claim: Claim, wanted: int) -> Iterator[Mutant]:
    """Mutants of ``claim`` that balls show violated, the same ones in every run.

    Args:
        wanted: changes to each claim, spread over its places, one or more at each.
    """
    spots = list(_spots(claim))
    for spot in spots:
        changed = ((v, spot.claims(v)) for v in spot.variants)
        counted = ((v, claims) for v, claims in changed if spot.violated(claims[0]))
        for variant, claims in islice(counted, math.ceil(wanted / len(spots))):
            for mutated in claims:
                yield Mutant(claim, spot.name, str(variant), mutated)


def _scattered(variants: Iterable[Any]) -> list[Any]:
    """The same in an order in which the first few are of all kinds."""
    numbered = enumerate(variants)
    return [v for _, v in sorted(numbered, key=lambda item: item[0] * 2654435761 % 2**32)]


def _spots(claim: Claim) -> Iterator[_Spot]:
    match claim.proof:
        case Printed():
            yield from _printed_spots(claim, claim.proof)
        case Boxes():
            yield from _box_spots(claim, claim.proof)
        case Asymptotics(statement=statement) if statement.kind == "~" and claim.expect.holds:
            yield _equivalence_spot(claim, claim.proof)
        case UniqueRoot():
            yield from _root_spots(claim, claim.proof)
        case Formally(relations=relations):
            for n, relation in enumerate(relations, 1):
                yield _formal_spot(claim, relation, f"relation {n}")
        case Together(chains):
            for n, (part, chain) in enumerate(zip(parts_of(claim.says), chains, strict=True), 1):
                yield from _chain_spots(claim, part, chain, f"part {n}: ")
        case tuple():
            yield from _chain_spots(claim, claim.says, claim.proof, "")


def _is_violated(claim: Claim) -> bool:
    says = claim.proof.relations[0] if isinstance(claim.proof, Formally) else claim.says
    return refute(says, claim) is not None


def _formal_spot(claim: Claim, relation: Basic, name: str) -> _Spot:
    def claims(changed: Variant) -> tuple[Claim, ...]:
        return (replace(claim, proof=formally(changed, using=claim.uses)),)

    return _Spot(name, mutations(relation), claims, _is_violated)


def _chain_spots(claim: Claim, says: Basic, chain: Chain, prefix: str) -> Iterator[_Spot]:
    def claims(changed: Variant) -> tuple[Claim, ...]:
        follows = replace(claim, says=changed, proof=_following(chain, says, changed))
        if isinstance(changed, Equivalent):
            return (follows,)
        alone = formally(*scalars(changed), using=claim.uses)
        return follows, replace(claim, says=changed, proof=alone)

    yield _Spot(prefix + "statement", mutations(says), claims, _is_violated)
    yield from _step_spots(claim, _start(says), chain, prefix)


def _following(chain: Chain, says: Any, changed: Any) -> Chain:
    """The chain with its last expression, where that is an end of ``says``, changed along."""
    last = chain[-1]
    ends = dict(zip(says.args, changed.args, strict=True))
    return (*chain[:-1], Step(ends.get(last.expression, last.expression), last.reasons))


def _start(says: Any) -> Basic:
    if isinstance(says, Eq | Equivalent):
        return says.args[0]
    return says.gts - says.lts


def _step_spots(claim: Claim, start: Basic, chain: Chain, prefix: str) -> Iterator[_Spot]:
    """Each expression of a chain, changed alone and claimed to follow from the one before."""
    before = start
    for n, link in enumerate(chain, 1):
        if link.expression is None:
            return

        def claims(changed: Variant, before: Basic = before, link: Step = link) -> tuple[Claim]:
            relate = Equivalent if isinstance(changed, Eq) else equal
            says, proof = relate(before, changed), (Step(changed, link.reasons),)
            return (replace(claim, says=says, proof=proof),)

        yield _Spot(f"{prefix}step {n}", mutations(link.expression), claims, _is_violated)
        before = link.expression


def _root_spots(claim: Claim, proof: UniqueRoot) -> Iterator[_Spot]:
    """The function, the ends, and the chain of the derivative."""

    def violated(mutated: Claim) -> bool:
        root: Any = mutated.proof
        ends = root.low, root.high
        return rootless(root.function, root.variable, ends, mutated.given) is not None

    for name in ("function", "low", "high"):

        def claims(changed: Variant, name: str = name) -> tuple[Claim, ...]:
            change: Any = {name: changed}
            return (replace(claim, proof=replace(proof, **change)),)

        yield _Spot(name, mutations(getattr(proof, name)), claims, violated)
    v = proof.variable
    inside = replace(claim, given=(*claim.given, v > proof.low, v < proof.high))
    slope = proof.function.diff(v, evaluate=False)
    yield from _step_spots(inside, slope, proof.derivative, "derivative: ")


# Printed numbers


def _printed_spots(claim: Claim, proof: Printed) -> Iterator[_Spot]:
    def with_text(text: Variant) -> tuple[Claim, ...]:
        return (replace(claim, proof=replace(proof, text=text)),)

    yield _Spot("printed number", _moved_digits(proof.text), with_text, _no_inputs_give_it)
    for name, text in proof.inputs.items():
        if not isinstance(text, str):
            continue

        def with_input(text: Variant, name: str = name) -> tuple[Claim, ...]:
            return (replace(claim, proof=replace(proof, inputs={**proof.inputs, name: text})),)

        yield _Spot(f"input {name}", _moved_digits(text), with_input, _no_inputs_give_it)


def _moved_digits(text: str) -> Iterator[str]:
    """Each digit before the exponent one up and one down, leading ones first, and the sign."""
    for n, digit in enumerate(text):
        if not digit.isdigit():
            if digit in "eE":
                break
            continue
        for moved in (int(digit) + 1, int(digit) - 1):
            if 0 <= moved <= 9:
                yield f"{text[:n]}{moved}{text[n + 1 :]}"
    yield text[1:] if text.startswith("-") else "-" + text


def _no_inputs_give_it(claim: Claim) -> bool:
    """Whether balls over pieces of the box of inputs all miss the printed interval."""
    number: Any = claim.proof
    low, high = printed(number.text)
    half = (high - low) / 2 * number.half_units
    target = Interval((low + high) / 2 - half, (low + high) / 2 + half)
    box = [printed(v) if isinstance(v, str) else Interval(v, v) for v in number.inputs.values()]
    return any(_missed(number, box, target, pieces) for pieces in SPLITS)


def _missed(number: Printed, box: list[Interval], target: Interval, pieces: int) -> bool:
    sides = [_pieces(side, pieces if side.low < side.high else 1) for side in box]
    if math.prod(map(len, sides)) > CELLS:
        return False
    with ball_precision(BITS):
        for cell in product(*sides):
            value = number.formula(*cell, balls)
            if not (value.is_finite() and (value > target.high or value < target.low)):
                return False
    return True


def _pieces(side: Interval, pieces: int) -> list[arb]:
    width = (side.high - side.low) / pieces
    ends = [(side.low + n * width, side.low + (n + 1) * width) for n in range(pieces)]
    return [Interval(*pair).ball() for pair in ends]


# Bounds on boxes, and orders


@dataclass(frozen=True)
class _Named:
    """A changed function, with the change in words."""

    text: str
    function: Callable[..., Any]

    def __str__(self) -> str:
        return self.text


def _box_spots(claim: Claim, proof: Boxes) -> Iterator[_Spot]:
    """Each margin negated, or lowered by twice its value at the centre or at a corner."""

    def violated(mutated: Claim) -> bool:
        bounds = cast(Boxes, mutated.proof).bounds
        with ball_precision(BITS):
            return any(bound_fails(bound, p) for bound in bounds for p in _places(bound.box))

    for n, bound in enumerate(proof.bounds):

        def claims(changed: Variant, n: int = n, bound: Bound = bound) -> tuple[Claim, ...]:
            margin = replace(bound, margin=changed.function)
            bounds = (*proof.bounds[:n], margin, *proof.bounds[n + 1 :])
            return (replace(claim, proof=replace(proof, bounds=bounds, stored=lambda: None)),)

        yield _Spot(f"bound {n + 1}", _lowered(bound), claims, violated)


def bound_fails(bound: Bound, point: Point) -> bool:
    """Whether a ball shows the bound violated at ``point``."""
    return bool(value_at(bound.margin, point) < 0)


def _places(region: Box) -> list[Point]:
    """The centre of the box, then points near its corners."""
    inward = [(s.low + (s.high - s.low) / 2**32, s.high - (s.high - s.low) / 2**32) for s in region]
    centre = tuple((low + high) / 2 for low, high in region)
    return list(dict.fromkeys((centre, *product(*inward))))


def _lowered(bound: Bound) -> Iterator[_Named]:
    margin = bound.margin
    yield _Named("the margin negated", lambda *x: -margin(*x))
    for point in _places(bound.box):
        where = ", ".join(fraction_text(x) for x in point)
        with ball_precision(BITS):
            excess = 2 * value_at(margin, point)
        if excess.is_finite():
            yield _Named(f"2 x its value at {where} less", lambda *x, e=excess: margin(*x) - e)


def _equivalence_spot(claim: Claim, proof: Asymptotics) -> _Spot:
    """f ~ g, where it holds, denies f ~ h for every h that is not ~ g."""
    gauge = proof.statement.gauge

    def claims(changed: Variant) -> tuple[Claim, ...]:
        statement = replace(proof.statement, gauge=changed.function)
        return (replace(claim, proof=replace(proof, statement=statement)),)

    variants = (
        _Named("-g", lambda x, m: -gauge(x, m)),
        _Named("2 g", lambda x, m: 2 * gauge(x, m)),
        _Named("g/2", lambda x, m: gauge(x, m) / 2),
        _Named("x g", lambda x, m: x * gauge(x, m)),
        _Named("g/x", lambda x, m: gauge(x, m) / x),
    )
    return _Spot("gauge", variants, claims, lambda mutated: True)


# Changes of an expression


Path = tuple[int, ...]


def mutations(e: Basic) -> Iterator[Basic]:
    """``e`` with one change anywhere in it, or with a and b swapped; the first few of all kinds."""
    edits = [((), e.xreplace({a: b, b: a})), *_edits(e, ())]
    seen = {e}
    for path, changed in _scattered(edits):
        whole = _replaced(e, path, changed)
        if _is_alike(e, whole) and whole not in seen and not whole.has(nan, oo, zoo, I):
            seen.add(whole)
            yield whole


def _is_alike(e: Basic, changed: Basic) -> bool:
    """Whether a changed relation is still one: SymPy evaluates some to true or false."""
    for kind in (Relational, Equivalent):
        if isinstance(e, kind):
            return isinstance(changed, kind) and len(changed.args) == len(e.args)
    return True


def _edits(e: Basic, path: Path) -> Iterator[tuple[Path, Basic]]:
    """Every node of ``e`` with what it can be changed to."""
    for changed in _here(e):
        yield path, changed
    for n in _changeable(e):
        yield from _edits(e.args[n], (*path, n))


def _replaced(e: Basic, path: Path, changed: Basic) -> Basic:
    if not path:
        return changed
    n = path[0]
    return _rebuilt(e, (*e.args[:n], _replaced(e.args[n], path[1:], changed), *e.args[n + 1 :]))


def _changeable(e: Basic) -> range:
    """Which arguments of ``e`` may be changed: not the variables that it binds."""
    if isinstance(e, Derivative | Subs):
        return range(1)
    if isinstance(e, MatrixBase):
        return range(2, 3)
    if isinstance(e, Tuple) and len(e.args) == 3 and isinstance(e.args[0], Symbol):
        return range(1, 3)
    return range(len(e.args))


def _rebuilt(e: Basic, args: tuple[Basic, ...]) -> Basic:
    if isinstance(e, Relational):
        return e.func(*args, evaluate=False)
    if isinstance(e, MatrixBase):
        return type(e)(*args[:2], list(args[2]))
    if isinstance(e, Integral):
        return Integral(*args)
    return e.func(*args)


def _here(e: Basic) -> Iterator[Basic]:
    """Changes of the outermost operation of ``e``."""
    match e:
        case Add():
            for n, term in enumerate(e.args):
                rest = (*e.args[:n], *e.args[n + 1 :])
                yield from (Add(*rest), Add(*rest, -term), Add(*rest, 2 * term))
        case Mul():
            for n in range(len(e.args)):
                yield Mul(*e.args[:n], *e.args[n + 1 :])
            yield -e
        case Pow():
            for exponent in (e.exp + 1, e.exp - 1, 2 * e.exp):
                yield e.base**exponent
        case Rational():
            yield e + 1
            yield -e
        case Symbol():
            yield from (2 * e, -e)
        case sin():
            yield from (cos(*e.args), -e)
        case cos():
            yield from (sin(*e.args), -e)
        case Relational():
            if e.rel_op in (">", ">=", "<", "<="):
                yield e.reversedsign.func(*e.args, evaluate=False)
