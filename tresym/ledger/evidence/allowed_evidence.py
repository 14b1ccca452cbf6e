"""Decide which kinds of evidence may support which kinds of statement.

A formula may only be proved by evidence about that very formula. Whether a sentence in words
follows from its evidence has to be judged by the reader; such claims are marked ``formal: false``
in the ledger.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from flint import arb

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
from tresym.ledger.conversion import conditions
from tresym.ledger.evidence.asymptotics import Asymptotics, solved_for_order
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
from tresym.ledger.formulas import Rounded, Tending, in_order, in_trees, mapped, names_of
from tresym.reals.domain.binder_values import enclosed
from tresym.reals.domain.evaluation import stands
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.normal.to_expression import in_lowest_terms
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

    samples: Callable[[], Iterable[tuple[tuple[arb, ...], Mapping[Any, arb]]]]
    gauge: Any
    coordinates: tuple[Any, ...]
    remainder: Remainder


def is_formal(claim: Claim) -> bool:
    """Return whether the evidence decides the claim's statement itself.

    False for prose, and for evidence that is compared with the statement by the reader or at
    sample points only.
    """
    if isinstance(claim.proof, AllOf):
        if not isinstance(claim.says, str):
            return True
        return not claim.proof.words and all(map(is_formal, claim.proof.claims))
    stated = isinstance(claim.says, str | Tending)
    if not stated and is_open(claim.says) and not as_printed(claim):
        return False
    return claim.statement is not None and not isinstance(claim.proof, HOLDS_FUNCTIONS)


def unfit(claim: Claim) -> str | None:
    """Return why this evidence cannot support this statement, or None if it can.

    The answer depends only on the types and formulas involved, not on whether the evidence checks.
    """
    proof, says = claim.proof, claim.says
    in_words = isinstance(says, str)
    match proof:
        case _ if type(proof) not in KINDS:
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
    """Return the first condition that is neither a relation nor a printed number, or None."""
    odd = (c for c in (*claim.given,) if not isinstance(c, Relation | Rounded))
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
    if meant is None or not isinstance(says, Relation) or says.sign != "==":
        return UNRELATED
    if claim.means is not None and not _is_stated(claim.means, proof):
        return "the stated bound differs from the bound that the boxes prove"
    order, gauge = solved_for_order(says), in_trees(meant.gauge)
    if order is None or order.relation != "O":
        return "bounds on boxes show an equation with exactly one order, O(…)"
    factor = in_lowest_terms(gauge / order.right)
    if symbols(factor) & symbols(order.right):
        return "the gauge of the evidence is not a multiple of the order in the formula"
    gap = _elsewhere(claim, proof, meant, order.right)
    if gap is not None:
        return gap
    if len(proof.bounds) != 2:
        return "an order needs two bounds, from above and from below"
    with ball_precision(BITS):
        samples = list(meant.samples())
    for at, known in samples:
        with ball_precision(BITS):
            named = {in_trees(e): ball for e, ball in known.items()}
            names = {e: symbol(f"[{e}]") for e in named if e.op != "symbol"}
            point = {str(names.get(e, e)): ball for e, ball in named.items()}
            put = partial(replaced, known=names)
            plain, size, *given = (mapped(e, put) for e in (order.left, gauge, *claim.given))
            if not names_of(plain, size, *given) <= {*point}:
                return "a symbol of the formula has no value at a sample point of the evidence"
            if not all(_met(condition, point) for condition in given):
                return "the conditions do not hold at a sample point of the evidence"
            remainder = enclosed(plain, point) / enclosed(size, point)
            if not _is_bounded(proof, at, remainder):
                return "at a sample point, the bounds do not bound the remainder of the formula"
    return None if samples else UNRELATED


def _is_stated(means: Any, proof: Boxes) -> bool:
    """Return whether ``means`` states |…| ≤ constant · gauge, with those of the box proof."""
    if proof.constant is None or not isinstance(means, Relation) or means.sign != "<=":
        return False
    bound = in_order(number(proof.constant) * in_trees(proof.meant.gauge))
    return means.right == bound and means.left.op == "abs"


def _elsewhere(claim: Claim, proof: Boxes, meant: Meant, order: Expr) -> str | None:
    """Return why the boxes do not contain the region or the limit point, or None if they do."""
    given, x = conditions(claim.given), str(meant.remainder.tends)
    coordinates = tuple(map(in_trees, meant.coordinates))
    why = unfit_to_tend(x, order, claim.says) or unreached(x, given, both=True)
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


def _met(condition: Any, point: Mapping[str, arb]) -> bool:
    """Return whether balls confirm the condition at the point."""
    if not isinstance(condition, Relation):
        return False
    return stands(enclosed(condition.left - condition.right, point), condition.sign)


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
