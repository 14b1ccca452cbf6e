"""Whether a printed remainder follows from the formula that is decided beside it.

A paper prints ``ε = ε₀ + O(ε₀²)``; what is decided is a bound with an explicit constant on a
region. The printed order follows from the bound if three conditions hold: the bound is on the
difference of the two printed sides, its right side (the gauge) is a constant times the printed
order, and its region contains a neighbourhood of the limit point. An expansion
``y = y₀ + s·x + O(x²)`` may also be refuted by its slope, because it implies y′(0) = s.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Abs, Basic, Eq, Expr, Integer, Le, Symbol
from sympy.core.function import AppliedUndef

from tresym.ledger.claim import Claim
from tresym.ledger.conversion import Conditions, conditions, defined, known, tree
from tresym.ledger.evidence.asymptotics import ordered
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.statements import As
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.expression import ZERO, substitute, symbol, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

HOT = Symbol("hot", real=True)
"""Stands for higher-order terms whose size the formula does not state ("h.o.t.")."""


@dataclass(frozen=True)
class Remainder:
    """How a printed order is interpreted if a bound with an explicit constant is decided instead.

    Attributes:
        tends: the symbol that tends to 0 from above.
        held: symbols that stay fixed in the limit; the constant of the order may depend on them.
        reading: substitutions from the printed formula to the bound, which are shown to the reader.
    """

    tends: Symbol
    held: tuple[Symbol, ...] = ()
    reading: tuple[tuple[Basic, Basic], ...] = ()


def is_open(says: Basic) -> bool:
    """Return whether a formula contains O(…), o(…) or unspecified higher-order terms."""
    return HOT in says.free_symbols or bool(_orders(says))


def _orders(says: Basic) -> list[AppliedUndef]:
    return [node for node in says.atoms(AppliedUndef) if str(node.func) in ("O", "o")]


def _remainder(claim: Claim) -> Remainder | None:
    meant = getattr(claim.proof, "meant", None)
    found = getattr(meant or claim.proof, "remainder", None)
    return found if isinstance(found, Remainder) else None


def as_printed(claim: Claim) -> bool:
    """Return whether the printed order follows from the decided formula without interpretation."""
    if isinstance(claim.means, As):
        return True
    remainder = _remainder(claim)
    if remainder is None or remainder.reading:
        return False
    return remainder.tends.name not in defined(claim)


def untied(claim: Claim) -> str | None:
    """Return why the printed order does not follow from the decided formula, or None if it does.

    Args:
        claim: a claim; only one with a formula in both ``says`` and ``means`` is examined.
    """
    says, means = claim.says, claim.means
    if isinstance(says, str) or means is None:
        return None
    if isinstance(means, As):
        other = means.args[0] != says
        return "the order in `means` differs from the order in `says`" if other else None
    if not isinstance(says, Eq) or len(_orders(says)) + (HOT in says.free_symbols) != 1:
        return "the formula must be an equation with exactly one order"
    try:
        if isinstance(means, Eq):
            return _no_slope(says, means)
        remainder = _remainder(claim)
        if remainder is None or not isinstance(means, Le) or not isinstance(means.lhs, Abs):
            return "the evidence does not relate the decided formula to the printed order"
        return _no_bound(says, means, remainder, claim)
    except (InputError, TypeError, ValueError) as error:
        return str(error)


def _no_slope(says: Eq, means: Eq) -> str | None:
    """Return why the printed expansion y = p(x) + O(x²) does not imply the decided slope."""
    order = next(iter(_orders(says)), None)
    if order is None or not isinstance(says.lhs, Symbol) or str(order.func) != "O":
        return "the formula is not an expansion of a single symbol"
    x, rest = next(iter(order.args[0].free_symbols), says.lhs), says.rhs - order
    if order.args[0] != x**2 or order in rest.atoms(AppliedUndef):
        return "the formula is not an expansion with the remainder O(x²)"
    slope = rest.diff(x)
    claimed = x not in slope.free_symbols and _equal(slope, means.rhs, ())
    return None if claimed else "the decided slope is not the slope of the printed expansion"


def _no_bound(says: Eq, means: Le, remainder: Remainder, claim: Claim) -> str | None:
    """Return why the printed order does not follow from the decided bound, or None."""
    given = conditions(claim.given)
    x, (size, gauge) = remainder.tends, (means.lhs.args[0], means.rhs)
    printed = says.xreplace(dict(remainder.reading))
    stated = ordered(printed)
    rest = (
        (printed.lhs - printed.rhs).xreplace({HOT: Integer(0)})
        if stated is None
        else stated.difference
    )
    if not (_equal(rest, size, given) or _equal(rest, -size, given)):
        return "the bound is not on the difference of the two printed sides"
    why = unreached(x.name, given)
    if why is not None:
        return why
    if stated is None:
        (lead,) = (side - HOT for side in printed.args if HOT in side.free_symbols)
        small = HOT not in lead.free_symbols and (gauge / lead).subs(x, 0) == 0
        return (
            None if small else "the bound does not show that the omitted terms are of higher order"
        )
    if stated.kind == "o":
        return "a bound with a constant proves O(…), but the formula states o(…)"
    if why := unfit_to_tend(x, stated.gauge, printed):
        return why
    factor = (gauge / stated.gauge).free_symbols
    if x in remainder.held or not factor <= {*remainder.held}:
        return "the right side of the bound is not a constant times the printed order"
    return None


def unfit_to_tend(x: Symbol, order: Expr, says: Basic) -> str | None:
    """Return why ``x`` is not the variable of the printed order, or None if it is."""
    if order.free_symbols <= {x} and x in says.free_symbols:
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


def _equal(left: Expr, right: Expr, given: Conditions) -> bool:
    """Return whether two expressions are proved equal under the conditions."""
    one, other = tree(left), tree(right)
    return one == other or (decide_continuous(one, other, known(given)).verdict is Verdict.PROVED)
