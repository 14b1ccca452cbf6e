"""Whether a printed remainder follows from the formula that is decided beside it.

A paper prints ``ε = ε₀ + O(ε₀²)``; what is decided is a bound with an explicit constant on a
region. The printed order follows from the bound if three conditions hold: the bound is on the
difference of the two printed sides, its right side (the gauge) is a constant times the printed
order, and its region contains a neighbourhood of the limit point. An expansion
``y = y₀ + s·x + O(x²)`` may also be refuted by its slope, because it implies y′(0) = s.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from tresym.ledger.claim import Claim
from tresym.ledger.conversion import Conditions, conditions, defined, known
from tresym.ledger.evidence.asymptotics import solved_for_order
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.formulas import Tending, in_order, in_trees, mapped, names_of, sides_of
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.comparisons import terms
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.like_terms import collected
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

HOT = "hot"
"""Stands for higher-order terms whose size the formula does not state ("h.o.t.")."""


@dataclass(frozen=True)
class Remainder:
    """How a printed order is interpreted if a bound with an explicit constant is decided instead.

    Attributes:
        tends: the symbol that tends to 0 from above.
        held: symbols that stay fixed in the limit; the constant of the order may depend on them.
        reading: substitutions from the printed formula to the bound, which are shown to the reader.
    """

    tends: Any
    held: tuple[Any, ...] = ()
    reading: tuple[tuple[Any, Any], ...] = ()


def is_open(says: Any) -> bool:
    """Return whether a formula contains O(…), o(…) or unspecified higher-order terms."""
    stated = in_trees(says)
    return HOT in names_of(stated) or bool(_orders(sides_of(stated)))


def _orders(sides: Iterable[Expr]) -> list[Expr]:
    """Return the orders O(…) and o(…) in expressions, each once."""
    return [node for node in operations(sides) if node.op in ("O", "o")]


def _remainder(claim: Claim) -> Remainder | None:
    meant = getattr(claim.proof, "meant", None)
    found = getattr(meant or claim.proof, "remainder", None)
    return found if isinstance(found, Remainder) else None


def as_printed(claim: Claim) -> bool:
    """Return whether the printed order follows from the decided formula without interpretation."""
    if isinstance(claim.means, Tending):
        return True
    remainder = _remainder(claim)
    if remainder is None or remainder.reading:
        return False
    return str(remainder.tends) not in defined(claim)


def untied(claim: Claim) -> str | None:
    """Return why the printed order does not follow from the decided formula, or None if it does.

    Args:
        claim: a claim; only one with a formula in both ``says`` and ``means`` is examined.
    """
    if isinstance(claim.says, str) or claim.means is None:
        return None
    says, means = claim.says, claim.means
    if isinstance(means, Tending):
        other = means.relation != says
        return "the order in `means` differs from the order in `says`" if other else None
    equation = isinstance(says, Relation) and says.sign == "=="
    if not equation or len(_orders(sides_of(says))) + (HOT in names_of(says)) != 1:
        return "the formula must be an equation with exactly one order"
    if not isinstance(means, Relation):
        return _UNRELATED
    try:
        if means.sign == "==":
            return _no_slope(says, means)
        remainder = _remainder(claim)
        if remainder is None or means.sign != "<=" or means.left.op != "abs":
            return _UNRELATED
        return _no_bound(says, means, remainder, claim)
    except (InputError, TypeError, ValueError) as error:
        return str(error)


_UNRELATED = "the evidence does not relate the decided formula to the printed order"


def _no_slope(says: Relation, means: Relation) -> str | None:
    """Return why the printed expansion y = p(x) + O(x²) does not imply the decided slope."""
    order = next(iter(_orders(sides_of(says))), None)
    if order is None or says.left.op != "symbol" or order.op != "O":
        return "the formula is not an expansion of a single symbol"
    x = next(iter(symbols(order.args[0])), str(says.left))
    rest = add(*(term for term in terms(says.right) if term != order))
    if order.args[0] != symbol(x) ** 2 or order not in terms(says.right) or _orders((rest,)):
        return "the formula is not an expansion with the remainder O(x²)"
    slope = collected(differentiate(rest, x))
    claimed = x not in symbols(slope) and _equal(slope, means.right, ())
    return None if claimed else "the decided slope is not the slope of the printed expansion"


def _no_bound(says: Relation, means: Relation, remainder: Remainder, claim: Claim) -> str | None:
    """Return why the printed order does not follow from the decided bound, or None."""
    given = conditions(claim.given)
    x, size, gauge = str(remainder.tends), means.left.args[0], means.right
    read = {in_trees(one): in_trees(other) for one, other in remainder.reading}
    printed = mapped(says, lambda e: in_order(replaced(e, read)))
    stated = solved_for_order(printed)
    hidden = [side for side in (printed.left, printed.right) if HOT in symbols(side)]
    rest = substitute(printed.left - printed.right, {HOT: ZERO}) if stated is None else stated.left
    if not (_equal(rest, size, given) or _equal(rest, -size, given)):
        return "the bound is not on the difference of the two printed sides"
    why = unreached(x, given)
    if why is not None:
        return why
    if stated is None:
        if len(hidden) == 1 and _is_smaller(gauge, hidden[0], x):
            return None
        return "the bound does not show that the omitted terms are of higher order"
    if stated.relation == "o":
        return "a bound with a constant proves O(…), but the formula states o(…)"
    if why := unfit_to_tend(remainder.tends, stated.right, printed):
        return why
    factor = symbols(in_lowest_terms(gauge / stated.right))
    held = frozenset(map(str, remainder.held))
    if x in held or not factor <= held:
        return "the right side of the bound is not a constant times the printed order"
    return None


def _is_smaller(gauge: Expr, side: Expr, x: str) -> bool:
    """Return whether ``gauge`` is of higher order, as x → 0, than what HOT is added to."""
    lead = collected(side - symbol(HOT))
    if HOT in symbols(lead) or lead == ZERO:
        return False
    ratio = in_lowest_terms(gauge / lead)
    return in_lowest_terms(substitute(ratio, {x: ZERO})) == ZERO


def unfit_to_tend(x: Any, order: Any, says: Any) -> str | None:
    """Return why ``x`` is not the variable of the printed order, or None if it is."""
    name = str(x)
    if symbols(in_trees(order)) <= {name} and name in names_of(in_trees(says)):
        return None
    return f"{x} is not the variable of the printed order"


def unreached(x: str, given: Conditions, both: bool = False) -> str | None:
    """Return why the region contains no neighbourhood of x = 0, or None if it does.

    Args:
        x: the name of the symbol that tends to 0 from above.
        given: the conditions that describe the region.
        both: whether negative ``x`` must be included, too.
    """
    others = tuple(c for c in given if x not in symbols(c.left) | symbols(c.right))
    for condition in given:
        up = condition.upward
        positive = (up.left, up.right) == (symbol(x), ZERO)
        if condition in others or (positive and not both):
            continue
        margin = substitute(up.left - up.right, {x: ZERO})
        if not is_manifest(Relation(margin, ">", ZERO), others):
            return f"could not show that {condition} holds near {x} = 0"
    return None


def _equal(one: Expr, other: Expr, given: Conditions) -> bool:
    """Return whether two expressions are proved equal under the conditions."""
    return one == other or (decide_continuous(one, other, known(given)).verdict is Verdict.PROVED)
