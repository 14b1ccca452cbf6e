"""Decide which kinds of evidence may support which kinds of statement.

A formula is proved by evidence that is about that formula; what is said in words is compared with
its evidence by the reader, and is marked as such (``formal: false``).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from flint import arb
from sympy import Abs, Basic, Integer, Le, Rational, Symbol
from sympy.core.function import AppliedUndef
from sympy.core.relational import Equality, Relational

from tresym.ledger.claim import (
    AllOf,
    Claim,
    Counterexample,
    Definition,
    Formally,
    ImplicitFunction,
    Instance,
    Monotone,
    Printed,
    Root,
    Together,
    UniqueRoot,
)
from tresym.ledger.conversion import conditions, tree
from tresym.ledger.evidence.asymptotics import Asymptotics, Squeezed
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.evidence.remainders import (
    HOT,
    Remainder,
    as_printed,
    is_open,
    unfit_to_tend,
    unreached,
    untied,
)
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.statements import Rounds
from tresym.reals.domain.binder_values import enclosed
from tresym.reals.domain.evaluation import stands
from tresym.reals.language.expression import ZERO, number, substitute, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision, balls

BITS = 400
CLOSE = arb("1e-6")
"""How well a remainder and what a margin bounds must agree, where both are known well enough."""
IN_WORDS = (AllOf, Denied)
"""Evidence for sentences: it says nothing of any formula."""
WITHOUT_CONDITIONS = (AllOf, Denied)
"""Evidence that no condition of the claim reaches."""
HOLDS_FUNCTIONS = (Boxes, Denied)
"""Evidence that does not say yet how it decides the statement of its claim."""
DECIDING = (
    *(tuple, Together, UniqueRoot, Monotone, Printed, Formally, Counterexample),
    *(Asymptotics, Squeezed, Charted, Evaluated, Boxes),
)
"""Evidence that decides the formula that is meant, whatever is said beside it."""
KINDS = (
    *(tuple, Definition, Root, Instance, Charted, Together, UniqueRoot, ImplicitFunction),
    *(Printed, AllOf, Formally, Counterexample, Boxes, Asymptotics, Squeezed, Denied, Evaluated),
    Monotone,
)
"""All kinds of evidence there are; a subclass may judge itself, and is none of them."""

LOCAL = re.compile(
    r"smooth|analytic|holomorph|regular|continu|differentiab|derivative|lipschitz|class C|"
    r"C\^|bounded|\bflat\b|limit|tends?\b|converg|approach|asymptot|vanish|\bnear|neighbou?r|→|\bo\(",
    re.IGNORECASE,
)
"""Words for what a function does as it comes near a point, of which no single point tells."""


@dataclass(frozen=True)
class Meant:
    """What a formula's symbols are where its evidence is looked at.

    Attributes:
        samples: for points of the box, or small parameters of an order, what each symbol (or
            value at a point, as it stands) of the formula and of its conditions is there.
        gauge: the quantity by which the formula's remainder is divided, in these symbols.
        coordinates: of the box, in these symbols: they take the region, which the conditions of
            the claim are, into the box, and the point at which the order holds inside it.
        remainder: how the order is read, and what tends to 0 in it.
    """

    samples: Callable[[], Iterable[tuple[tuple[arb, ...], Mapping[Basic, arb]]]]
    gauge: Basic
    coordinates: tuple[Basic, ...]
    remainder: Remainder


def is_formal(claim: Claim) -> bool:
    """Whether the evidence decides the claim's statement, and nothing else.

    Evidence that holds functions is compared with the statement by a reader, or at points.
    """
    if isinstance(claim.proof, AllOf):
        return all(map(is_formal, claim.proof.claims))
    if isinstance(claim.says, Basic) and is_open(claim.says) and not as_printed(claim):
        return False
    return claim.statement is not None and not isinstance(claim.proof, HOLDS_FUNCTIONS)


def unfit(claim: Claim) -> str | None:
    """Why the evidence cannot decide what is said, whatever it comes to; None where it can."""
    proof, says = claim.proof, claim.says
    in_words = isinstance(says, str)
    match proof:
        case _ if type(proof) not in KINDS or not (in_words or isinstance(says, Basic)):
            return "that is no kind of evidence"
        case _ if (odd := _odd_condition(claim)) is not None:
            return f"{odd} is not a condition such as a > 0"
        case _ if not in_words and claim.means is None and _left_open(claim):
            return "what is left open in an order is not said"
        case _ if claim.means is not None and not (in_words or is_open(claim.says)):
            return "two formulas are no statement: what is said is what is meant"
        case _ if claim.means is not None and not isinstance(proof, DECIDING):
            return "this evidence decides no formula beside what is said"
        case _ if (why := untied(claim)) is not None:
            return why
        case AllOf() if not in_words:
            return "a conjunction proves a sentence; a formula needs a chain"
        case _ if isinstance(proof, IN_WORDS) and not in_words:
            return "the evidence is for a sentence and mentions no formula"
        case _ if isinstance(proof, WITHOUT_CONDITIONS) and claim.given:
            return "the conditions decide nothing here"
        case Counterexample() | Denied() if in_words and LOCAL.search(says):
            return "one point tells nothing of smoothness or of a limit"
        case Boxes() if in_words and claim.means is not None:
            return "this evidence decides no formula beside what is said"
        case Boxes() if in_words and claim.given:
            return "the conditions decide nothing here: a box stands for them"
        case Boxes() if not in_words:
            return _other_meaning(claim, proof)
    return None


def _odd_condition(claim: Claim) -> object | None:
    """The first condition that is no relation, and no input as it is printed; or None."""
    odd = (c for c in (*claim.given,) if not isinstance(c, Relational | Rounds))
    return next(odd, None)


def _left_open(claim: Claim) -> bool:
    """Whether an order stands in what is said, and the evidence is for no order."""
    orders = (Boxes, Asymptotics, Squeezed)
    return is_open(claim.says) and not isinstance(claim.proof, orders)


def _other_meaning(claim: Claim, proof: Boxes) -> str | None:
    """Where the formula says something else than its bounds or its order, or None."""
    says, meant = claim.says, proof.meant
    if meant is None or not isinstance(says, Equality):
        return "nothing says what the evidence has to do with the formula"
    if claim.means is not None and not _is_stated(claim.means, proof):
        return "the bound is not the one that the boxes show"
    orders = {*says.atoms(AppliedUndef)}
    rest, gap = says.args[0] - says.args[1], _gauge_gap(says, orders, meant.gauge)
    gap = gap or _elsewhere(claim, proof, meant)
    if gap is not None:
        return gap
    plain = rest.xreplace({**dict.fromkeys(orders, Integer(0)), HOT: Integer(0)})
    if not _is_of_kind(proof, orders, HOT in says.free_symbols):
        return "the evidence is not for a formula with such an order"
    with ball_precision(BITS):
        samples = list(meant.samples())
    for at, known in samples:
        with ball_precision(BITS):
            names = {e: Symbol(f"[{e}]", real=True) for e in known if not isinstance(e, Symbol)}
            point = {names.get(e, e): ball for e, ball in known.items()}
            spoken_of = (e.xreplace(names) for e in (plain, meant.gauge, *claim.given))
            if any(not e.free_symbols <= {*point} for e in spoken_of):
                return "a symbol of the formula has no value where the evidence is"
            if not all(_met(condition.xreplace(names), point) for condition in claim.given):
                return "the conditions do not hold where the evidence is"
            remainder = _at(plain.xreplace(names), point) / _at(meant.gauge, point)
            if not _is_bounded(proof, at, remainder):
                return "the evidence is not about what the formula leaves out"
    return None if samples else "nothing says what the evidence has to do with the formula"


def _is_stated(means: Basic, proof: Boxes) -> bool:
    """Whether a bound is that of the boxes: their constant times their gauge."""
    if proof.constant is None or not isinstance(means, Le):
        return False
    constant = Rational(int(proof.constant.p), int(proof.constant.q))
    return bool(means.rhs == constant * proof.meant.gauge and isinstance(means.lhs, Abs))


def _elsewhere(claim: Claim, proof: Boxes, meant: Meant) -> str | None:
    """Why the boxes do not hold the region, or not the point at which the order is, or None."""
    assert isinstance(claim.says, Basic)
    given, x = conditions(claim.given), meant.remainder.tends.name
    coordinates = tuple(map(tree, meant.coordinates))
    orders = [node.args[0] for node in claim.says.atoms(AppliedUndef)] or [meant.gauge]
    tends = meant.remainder.tends
    why = next(filter(None, (unfit_to_tend(tends, e, claim.says) for e in orders)), None)
    why = why or unreached(x, given, both=True)
    if why is not None:
        return why
    near = tuple(c for c in given if x not in symbols(c.left) | symbols(c.right))
    for box in (bound.box for bound in proof.bounds):
        if len(box) != len(coordinates):
            return "the box has another number of sides than there are coordinates"
        for e, side in zip(coordinates, box, strict=True):
            for end, sign in ((number(side.low), ">"), (number(side.high), "<")):
                inside = Relation(e, f"{sign}=", end)
                # What the coordinate does not speak of may be in the prover's way.
                own = tuple(c for c in given if symbols(c.left) | symbols(c.right) <= symbols(e))
                if not (is_manifest(inside, own) or is_manifest(inside, given)):
                    return f"{e} {sign}= {end} is not shown: the region is not in the box"
                there = Relation(substitute(e, {x: ZERO}), sign, end)
                if x in symbols(e) and not is_manifest(there, near):
                    return f"{e} {sign} {end} is not shown at the point: no box is around it"
    return None


def _gauge_gap(says: Basic, orders: set[Basic], gauge: Basic) -> str | None:
    """Whether the gauge is the order that the formula names, but for a factor without its symbols.

    The factor is what an order leaves open: the other symbols are held.
    """
    if len(orders) > 1 or any(str(node.func) not in ("O", "o") for node in orders):
        return "a formula has one order"
    for node in orders:
        stand_in = Symbol("[order]", real=True)
        named = node.args[0] * (says.args[0] - says.args[1]).xreplace({node: stand_in}).diff(
            stand_in
        )
        if (gauge / named).free_symbols & node.args[0].free_symbols:
            return "the gauge is not the order that the formula names"
    return None


def _is_of_kind(proof: Boxes, orders: set[Basic], hot: bool) -> bool:
    """A bounded remainder shows O or "hot"; one margin denies that there is none; o needs an o."""
    names = {str(node.func) for node in orders}
    return len(proof.bounds) == (2 if hot or orders else 1) and "o" not in names


def _met(condition: Basic, point: Mapping[Symbol, arb]) -> bool:
    if not isinstance(condition, Relational):
        return False
    return stands(_at(condition.lhs - condition.rhs, point), condition.rel_op)


def _at(e: Basic, point: Mapping[Symbol, arb]) -> arb:
    return enclosed(tree(e), {symbol.name: value for symbol, value in point.items()})


def _is_bounded(proof: Boxes, at: tuple[arb, ...], remainder: arb) -> bool:
    """Whether the evidence bounds this remainder, up to its sign.

    Two margins C − e and C + e bound e, one margin −|e| denies that e is 0. Where margins only
    suffice, the remainder must keep to the constant.
    """
    inside = (
        side.low <= x.upper() and x.lower() <= side.high
        for bound in proof.bounds
        for x, side in zip(at, bound.box, strict=True)
    )
    if not all(inside):
        return False
    if any(bound.sufficient for bound in proof.bounds):
        return proof.constant is not None and bool(abs(remainder) <= arb(proof.constant))
    margins = [bound.margin(*at, balls) for bound in proof.bounds]
    if len(margins) == 1:
        return _same(margins[0], remainder) and bool(margins[0] < 0)
    half = (margins[0] + margins[1]) / 2
    same = len(margins) == 2 and _same((margins[1] - margins[0]) / 2, remainder)
    return same and proof.constant is not None and bool(abs(half - arb(proof.constant)) < CLOSE)


def _same(x: arb, y: arb) -> bool:
    """Equal up to the sign, as far as both are known, and that is well enough."""
    sharp = all(ball.is_finite() and ball.rad() < CLOSE * (1 + abs(ball)) for ball in (x, y))
    return bool(sharp and abs(x).overlaps(abs(y)))
