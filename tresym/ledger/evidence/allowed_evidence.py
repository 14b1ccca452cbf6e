"""Decide which kinds of evidence may support which kinds of statement.

A formula may only be proved by evidence about that very formula. Whether a sentence in words
follows from its evidence has to be judged by the reader; such claims are marked ``formal: false``
in the ledger.
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
    Dominated,
    Follows,
    FromSlope,
    FromTheEdge,
    ImplicitFunction,
    InfimumBy,
    Instance,
    Monotone,
    MonotoneOf,
    Printed,
    Root,
    RootBound,
    RootMonotone,
)
from tresym.ledger.conversion import conditions, tree
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.evidence.remainders import (
    Remainder,
    as_printed,
    is_open,
    unfit_to_tend,
    unreached,
    untied,
)
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.statements import As, Rounds
from tresym.reals.domain.binder_values import enclosed
from tresym.reals.domain.evaluation import stands
from tresym.reals.language.expression import ZERO, number, substitute, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision

BITS = 400
IN_WORDS = (Denied,)
"""Evidence for sentences in words; it proves no formula."""
WITHOUT_CONDITIONS = (AllOf, Denied)
"""Evidence that cannot use the conditions of the claim."""
HOLDS_FUNCTIONS = (Boxes, Denied)
"""Evidence whose relation to the statement is only checked at sample points, or by the reader."""
DECIDING = (
    *(Monotone, Printed, Counterexample),
    *(Asymptotics, Charted, Evaluated, Boxes),
    *(RootBound, RootMonotone, MonotoneOf, FromSlope, FromTheEdge, InfimumBy, Dominated),
    *(Follows, Decided),
)
"""Evidence that decides the formula in ``means``, also if ``says`` is different."""
KINDS = (
    *(Definition, Root, Instance, Charted, ImplicitFunction),
    *(Printed, AllOf, Counterexample, Boxes, Asymptotics, Denied, Evaluated),
    *(Monotone, Follows, RootBound, RootMonotone, MonotoneOf, FromSlope, FromTheEdge),
    *(InfimumBy, Dominated, Decided),
)
"""All accepted types of evidence. Subclasses are not accepted: they could judge themselves."""

BESIDE = "this type of evidence cannot decide a formula in `means` that differs from `says`"
UNRELATED = "the evidence does not say how its bounds are related to the formula"

LOCAL = re.compile(
    r"smooth|analytic|holomorph|regular|continu|differentiab|derivative|lipschitz|class C|"
    r"C\^|bounded|\bflat\b|limit|tends?\b|converg|approach|asymptot|vanish|\bnear|neighbou?r|→|\bo\(",
    re.IGNORECASE,
)
"""Words for local properties of functions, which no single point can refute."""


@dataclass(frozen=True)
class Meant:
    """How the symbols of a formula correspond to the coordinates of its box proof.

    Attributes:
        samples: returns sample points of the box, each with balls for the symbols of the formula
            and of its conditions.
        gauge: the quantity by which the remainder of the formula is divided.
        coordinates: the coordinates of the box as functions of the symbols. They map the region
            given by the conditions into the box, and the limit point into its interior.
        remainder: how the printed order is interpreted, and which symbol tends to 0.
    """

    samples: Callable[[], Iterable[tuple[tuple[arb, ...], Mapping[Basic, arb]]]]
    gauge: Basic
    coordinates: tuple[Basic, ...]
    remainder: Remainder


def is_formal(claim: Claim) -> bool:
    """Return whether the evidence decides the claim's statement itself.

    False for prose, and for evidence that is compared with the statement by the reader or at
    sample points only.
    """
    if isinstance(claim.proof, AllOf):
        if isinstance(claim.says, Basic):
            return True
        return not claim.proof.words and all(map(is_formal, claim.proof.claims))
    stated = isinstance(claim.says, As)
    if isinstance(claim.says, Basic) and is_open(claim.says) and not (stated or as_printed(claim)):
        return False
    return claim.statement is not None and not isinstance(claim.proof, HOLDS_FUNCTIONS)


def unfit(claim: Claim) -> str | None:
    """Return why this evidence cannot support this statement, or None if it can.

    The answer depends only on the types and formulas involved, not on whether the evidence checks.
    """
    proof, says = claim.proof, claim.says
    in_words = isinstance(says, str)
    match proof:
        case _ if type(proof) not in KINDS or not (in_words or isinstance(says, Basic)):
            return f"{type(proof).__name__} is not a supported type of evidence for this statement"
        case _ if (odd := _odd_condition(claim)) is not None:
            return f"{odd} is not a condition such as a > 0"
        case _ if not in_words and claim.means is None and _left_open(claim):
            return "the statement contains an order; state the formula that is decided in `means`"
        case _ if claim.means is not None and not (in_words or is_open(claim.says)):
            return "`says` is already a decidable formula, so `means` must not give another one"
        case _ if claim.means is not None and not isinstance(proof, DECIDING):
            return BESIDE
        case _ if (why := untied(claim)) is not None:
            return why
        case AllOf(words=True) if not in_words:
            return "in_words is evidence for a sentence; a formula needs other evidence"
        case _ if isinstance(proof, IN_WORDS) and not in_words:
            return "this evidence is for a sentence in words, but the claim states a formula"
        case _ if isinstance(proof, WITHOUT_CONDITIONS) and in_words and claim.given:
            return "this evidence cannot use conditions; remove `given`"
        case Counterexample() | Denied() if in_words and LOCAL.search(says):
            return "a single point cannot refute a statement about smoothness or a limit"
        case Boxes() if in_words and claim.means is not None:
            return BESIDE
        case Boxes() if in_words and claim.given:
            return "this evidence cannot use conditions, because its box replaces them"
        case Boxes() if not in_words:
            return _other_meaning(claim, proof)
    return None


def _odd_condition(claim: Claim) -> object | None:
    """Return the first condition that is neither a relation nor a `Rounds`, or None."""
    odd = (c for c in (*claim.given,) if not isinstance(c, Relational | Rounds))
    return next(odd, None)


def _left_open(claim: Claim) -> bool:
    """Return whether the statement contains an order but the evidence is not about orders."""
    orders = (Boxes, Asymptotics, Dominated, Follows, AllOf, Decided)
    return is_open(claim.says) and not isinstance(claim.proof, orders)


def _other_meaning(claim: Claim, proof: Boxes) -> str | None:
    """Return why the bounds on boxes do not show the formula, or None.

    The formula's remainder divided by the gauge is compared with the margins at sample points.
    """
    says, meant = claim.says, proof.meant
    if meant is None or not isinstance(says, Equality):
        return UNRELATED
    if claim.means is not None and not _is_stated(claim.means, proof):
        return "the stated bound differs from the bound that the boxes prove"
    orders = {*says.atoms(AppliedUndef)}
    rest, gap = says.args[0] - says.args[1], _gauge_gap(says, orders, meant.gauge)
    gap = gap or _elsewhere(claim, proof, meant)
    if gap is not None:
        return gap
    plain = rest.xreplace(dict.fromkeys(orders, Integer(0)))
    if len(proof.bounds) != 2:
        return "an order needs two bounds, from above and from below"
    with ball_precision(BITS):
        samples = list(meant.samples())
    for at, known in samples:
        with ball_precision(BITS):
            names = {e: Symbol(f"[{e}]", real=True) for e in known if not isinstance(e, Symbol)}
            point = {names.get(e, e): ball for e, ball in known.items()}
            spoken_of = (e.xreplace(names) for e in (plain, meant.gauge, *claim.given))
            if any(not e.free_symbols <= {*point} for e in spoken_of):
                return "a symbol of the formula has no value at a sample point of the evidence"
            if not all(_met(condition.xreplace(names), point) for condition in claim.given):
                return "the conditions do not hold at a sample point of the evidence"
            remainder = _at(plain.xreplace(names), point) / _at(meant.gauge, point)
            if not _is_bounded(proof, at, remainder):
                return "at a sample point, the bounds do not bound the remainder of the formula"
    return None if samples else UNRELATED


def _is_stated(means: Basic, proof: Boxes) -> bool:
    """Return whether ``means`` states |…| ≤ constant · gauge, with those of the box proof."""
    if proof.constant is None or not isinstance(means, Le):
        return False
    constant = Rational(int(proof.constant.p), int(proof.constant.q))
    return bool(means.rhs == constant * proof.meant.gauge and isinstance(means.lhs, Abs))


def _elsewhere(claim: Claim, proof: Boxes, meant: Meant) -> str | None:
    """Return why the boxes do not contain the region or the limit point, or None if they do."""
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
            return f"the box has {len(box)} sides, but there are {len(coordinates)} coordinates"
        for e, side in zip(coordinates, box, strict=True):
            for end, sign in ((number(side.low), ">"), (number(side.high), "<")):
                inside = Relation(e, f"{sign}=", end)
                # Conditions on other symbols can distract the prover, so try without them first.
                own = tuple(c for c in given if symbols(c.left) | symbols(c.right) <= symbols(e))
                if not (is_manifest(inside, own) or is_manifest(inside, given)):
                    return f"the region must lie in the box, but could not show {e} {sign}= {end}"
                there = Relation(substitute(e, {x: ZERO}), sign, end)
                if x in symbols(e) and not is_manifest(there, near):
                    return (
                        "the box must contain the limit point in its interior, but could not show "
                        f"{e} {sign} {end} there"
                    )
    return None


def _gauge_gap(says: Basic, orders: set[Basic], gauge: Basic) -> str | None:
    """Return why the gauge is not a multiple of the order in the formula, or None if it is.

    The factor may depend on symbols that do not occur in the order; they are fixed in the limit.
    """
    if [str(node.func) for node in orders] != ["O"]:
        return "bounds on boxes show an equation with exactly one order, O(…)"
    (node,) = orders
    stand_in = Symbol("[order]", real=True)
    rest = (says.args[0] - says.args[1]).xreplace({node: stand_in})
    if (gauge / (node.args[0] * rest.diff(stand_in))).free_symbols & node.args[0].free_symbols:
        return "the gauge of the evidence is not a multiple of the order in the formula"
    return None


def _met(condition: Basic, point: Mapping[Symbol, arb]) -> bool:
    """Return whether balls confirm the condition at the point."""
    if not isinstance(condition, Relational):
        return False
    return stands(_at(condition.lhs - condition.rhs, point), condition.rel_op)


def _at(e: Basic, point: Mapping[Symbol, arb]) -> arb:
    """Return a ball for ``e`` at the point."""
    return enclosed(tree(e), {symbol.name: value for symbol, value in point.items()})


def _is_bounded(proof: Boxes, at: tuple[arb, ...], remainder: arb) -> bool:
    """Return whether a point lies in the boxes and the remainder there is within the constant.

    The margins must be sufficient for the bound, as `Bound` says; no others are compared with it.
    """
    inside = (
        side.low <= x.upper() and x.lower() <= side.high
        for bound in proof.bounds
        for x, side in zip(at, bound.box, strict=True)
    )
    fit = all(inside) and all(bound.sufficient for bound in proof.bounds)
    return fit and proof.constant is not None and bool(abs(remainder) <= arb(proof.constant))
