"""Whether a printed remainder follows from the formula that is decided beside it.

A paper prints ``ε = ε₀ + O(ε₀²)``; what is decided is a bound with its constant and its region.
The printed order follows where the bound is one of the difference of the two sides, where its
gauge is the order that is printed, and where the region reaches the point that is tended to.
An order that is refuted by its slope, ``y = y₀ + s·x + O(x²)``, is one that claims the slope s.
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
"""Higher orders that are left out, of a size that the formula does not say."""


@dataclass(frozen=True)
class Remainder:
    """How a printed order is read, where a bound with its constant is decided beside it.

    Attributes:
        tends: the symbol that tends to 0, from above.
        held: symbols that the order holds fixed: its constant may depend on them.
        reading: what symbols of the printed formula are in the bound, as the reader is told.
    """

    tends: Symbol
    held: tuple[Symbol, ...] = ()
    reading: tuple[tuple[Basic, Basic], ...] = ()


def is_open(says: Basic) -> bool:
    """Whether a formula leaves open what is left out, as O(…), o(…) and "hot" do."""
    return HOT in says.free_symbols or bool(_orders(says))


def _orders(says: Basic) -> list[AppliedUndef]:
    return [node for node in says.atoms(AppliedUndef) if str(node.func) in ("O", "o")]


def _remainder(claim: Claim) -> Remainder | None:
    meant = getattr(claim.proof, "meant", None)
    found = getattr(meant or claim.proof, "remainder", None)
    return found if isinstance(found, Remainder) else None


def as_printed(claim: Claim) -> bool:
    """Whether the printed order follows from what is decided with nothing read into it."""
    if isinstance(claim.means, As):
        return True
    remainder = _remainder(claim)
    if remainder is None or remainder.reading:
        return False
    return remainder.tends.name not in defined(claim)


def untied(claim: Claim) -> str | None:
    """Why the formula that is decided says nothing of the order that is printed, or None."""
    says, means = claim.says, claim.means
    if isinstance(says, str) or means is None:
        return None
    if isinstance(means, As):
        other = means.args[0] != says
        return "the order that is meant is not the one that is said" if other else None
    if not isinstance(says, Eq) or len(_orders(says)) + (HOT in says.free_symbols) != 1:
        return "a formula has one order"
    try:
        if isinstance(means, Eq):
            return _no_slope(says, means)
        remainder = _remainder(claim)
        if remainder is None or not isinstance(means, Le) or not isinstance(means.lhs, Abs):
            return "nothing says what the formula has to do with the order that is printed"
        return _no_bound(says, means, remainder, claim)
    except (InputError, TypeError, ValueError) as error:
        return str(error)


def _no_slope(says: Eq, means: Eq) -> str | None:
    """Why the printed order y = p(x) + O(x²) does not claim the slope that is decided."""
    order = next(iter(_orders(says)), None)
    if order is None or not isinstance(says.lhs, Symbol) or str(order.func) != "O":
        return "that is no expansion of a symbol"
    x, rest = next(iter(order.args[0].free_symbols), says.lhs), says.rhs - order
    if order.args[0] != x**2 or order in rest.atoms(AppliedUndef):
        return "that is no expansion to the first order"
    slope = rest.diff(x)
    claimed = x not in slope.free_symbols and _equal(slope, means.rhs, ())
    return None if claimed else "what is decided is not the slope that the expansion claims"


def _no_bound(says: Eq, means: Le, remainder: Remainder, claim: Claim) -> str | None:
    given = conditions(claim.given)
    x, (size, gauge) = remainder.tends, (means.lhs.args[0], means.rhs)
    said = says.xreplace(dict(remainder.reading))
    stated = ordered(said)
    rest = (
        (said.lhs - said.rhs).xreplace({HOT: Integer(0)}) if stated is None else stated.difference
    )
    if not (_equal(rest, size, given) or _equal(rest, -size, given)):
        return "the bound is not one of what the formula leaves out"
    why = unreached(x.name, given)
    if why is not None:
        return why
    if stated is None:
        (lead,) = (side - HOT for side in said.args if HOT in side.free_symbols)
        small = HOT not in lead.free_symbols and (gauge / lead).subs(x, 0) == 0
        return None if small else "what is left out is not shown to be of higher order"
    if stated.kind == "o":
        return "a bound shows O, and no o"
    if why := unfit_to_tend(x, stated.gauge, said):
        return why
    factor = (gauge / stated.gauge).free_symbols
    if x in remainder.held or not factor <= {*remainder.held}:
        return "the gauge is not the order that the formula names"
    return None


def unfit_to_tend(x: Symbol, order: Expr, says: Basic) -> str | None:
    """Why ``x`` is not what tends in a printed order, or None."""
    if order.free_symbols <= {x} and x in says.free_symbols:
        return None
    return f"{x} is not what tends in the order that is printed"


def unreached(x: str, given: Conditions, both: bool = False) -> str | None:
    """A condition that does not hold where ``x`` is small enough and positive, or None.

    Args:
        both: whether it must hold where ``x`` is negative, too.
    """
    others = tuple(c for c in given if x not in symbols(c.left) | symbols(c.right))
    for condition in given:
        up = condition.upward
        positive = (up.left, up.right) == (symbol(x), ZERO)
        if condition in others or (positive and not both):
            continue
        room = substitute(up.left - up.right, {x: ZERO})
        if not is_manifest(Relation(room, ">", ZERO), others):
            return f"the region does not reach the point: {condition} is not shown near it"
    return None


def _equal(left: Expr, right: Expr, given: Conditions) -> bool:
    one, other = tree(left), tree(right)
    return one == other or (decide_continuous(one, other, known(given)).verdict is Verdict.PROVED)
