"""Judge claims about roots: that there is one, at most one, and what depends on it."""

from __future__ import annotations

from dataclasses import replace

from tresym.checking.dispatch import decide_claim
from tresym.ledger.claim import Claim, ImplicitFunction, Monotone
from tresym.ledger.conversion import Conditions, conditions, definitions
from tresym.ledger.evidence.decided import Decided, judge_decided
from tresym.ledger.evidence.integrals import NotShownError, need, need_smooth, under_binder
from tresym.ledger.evidence.premises import unmet_condition
from tresym.ledger.evidence.satisfiability import satisfiable
from tresym.ledger.evidence.sign_prover import manifest_sign, undefined
from tresym.ledger.finding import Finding, StepFinding
from tresym.ledger.formulas import names_of
from tresym.ledger.refutations import PROVED, UNDECIDED, need_possible, refute
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import stated
from tresym.reals.decisions.root_values import by_leibniz
from tresym.reals.language.binders import derivative, worked_out
from tresym.reals.language.compound import Count
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, substitute, symbol, symbols
from tresym.reals.language.formula import Compared, Relation


def _need_bound(claim: Claim, says: Count) -> None:
    """Require that the ends do not depend on the bound variable and the conditions are possible."""
    x = says.name
    free = x not in symbols(says.low) | symbols(says.high)
    need(free, f"the ends of the interval must not depend on the bound variable {x}")
    need_possible(claim)


def judge_at_most_one(claim: Claim, proof: Monotone) -> Finding:
    """Return PROVED if left minus right side is smooth and increasing between the ends."""
    says = claim.statement
    counted = isinstance(says, Count) and says.how == "at most one"
    if not isinstance(says, Count) or not counted or says.equation[1] != "==":
        raise NotShownError(
            "this evidence proves that an equation has at most one root, but the claim states "
            "something else"
        )
    _need_bound(claim, says)
    name, difference = says.name, says.equation[0] - says.equation[2]
    given = without(name, conditions(claim.given))
    ends = (
        Relation(symbol(name), ">", says.low),
        Relation(symbol(name), "<", says.high),
    )
    inside = (*given, *ends)
    need_smooth(difference, inside)
    slope = differentiate(difference, name)
    need(isinstance(proof.slope, Decided), "the sign of the derivative is what the engine decides")
    rising = Relation(slope, ">", ZERO)
    plain = tuple(c for c in claim.given if name not in names_of(c))
    asked = replace(
        claim, says=rising, means=None, given=(*plain, *ends), proof=proof.slope, knowing=()
    )
    found = judge_decided(asked, proof.slope)
    need(found.verdict is PROVED, f"could not show that {slope} > 0: {found.why}")
    steps = found.steps or (StepFinding(PROVED, found.why),)
    return Finding(PROVED, "left side minus right side is increasing on the interval", steps=steps)


def without(name: str, given: Conditions) -> Conditions:
    """Return the conditions in which the symbol ``name`` does not occur."""
    return tuple(c for c in given if name not in symbols(c.left) | symbols(c.right))


def judge_implicit_function(claim: Claim, proof: ImplicitFunction) -> Finding:
    """Return PROVED if the implicit function theorem applies and gives the stated derivative."""
    needs_equations = "implicit differentiation needs an equation and states an equation"
    equation, says = proof.equation.decided, claim.says
    if not isinstance(equation, Relation) or not isinstance(says, Relation):
        raise NotShownError(needs_equations)
    need(equation.sign == says.sign == "==", needs_equations)
    u, p, at = proof.unknown, proof.parameter, proof.at
    left, right = equation.left, equation.right
    fixed = u != p and not {u, p} & (symbols(right) | symbols(at))
    need(fixed, "the right side of the equation must not depend on the unknown or on the parameter")
    new = says.left.op == "symbol" and says.left not in definitions(claim.rests_on)
    need(new and not symbols(says.left) & symbols(left), f"{says.left} is not a new symbol")
    outside = without(p, conditions(claim.given))
    there = substitute(left, {p: at})
    by_unknown = derivative(there, u)
    slope = -derivative(left, p, at) / by_unknown
    if not under_binder(says.right, slope, outside) and not _holds(says.right, slope, outside):
        why = "the stated derivative differs from the derivative of the implicit function"
        other = Finding(UNDECIDED, why)
        return _refuted_slope(claim, proof) or other
    need_possible(claim)
    place = symbol(p)
    near = (*outside, Relation(place, ">=", at), Relation(place, "<=", at))
    unmet = unmet_condition(proof.equation, {}, near)
    need(unmet is None, f"the equation holds only under {unmet}, which could not be shown")
    need_smooth(left, near)
    if manifest_sign(by_leibniz(by_unknown), outside) in ("+", "-"):
        steps: tuple[StepFinding, ...] = ()
    else:
        steps = _apart_from_zero(by_unknown, outside)
    written = tuple(c for c in claim.given if p not in names_of(c))
    on_curve = (Relation(substitute(left, {p: at}), "==", right),)
    need(satisfiable(written, on_curve), "no point was found that satisfies the equation", steps)
    why = f"the equation is smooth and its derivative with respect to {u} is not zero"
    return Finding(PROVED, why, steps=steps)


def _apart_from_zero(slope: Expr, given: Conditions) -> tuple[StepFinding, ...]:
    """Require that a derivative has no zero, as the engine decides.

    Raises:
        NotShownError: it was not proved.
    """
    answer = _asked((slope, "!=", ZERO), given)
    need(answer.verdict is PROVED, f"could not show that {slope} is not 0: {answer.why}")
    return (StepFinding(PROVED, str(answer)),)


def _holds(one: Expr, other: Expr, given: Conditions) -> bool:
    """Whether the engine proves two expressions equal, of which the first is defined."""
    defined = undefined(worked_out(one), given) is None
    return defined and _asked((one, "==", other), given).verdict is PROVED


def _asked(link: Compared, given: Conditions) -> Answer:
    return decide_claim(stated((link,), tuple((c.left, c.sign, c.right) for c in given)))


def _refuted_slope(claim: Claim, proof: ImplicitFunction) -> Finding | None:
    """Return REFUTED with a point of the curve where the stated derivative is wrong, or None."""
    says, equation = claim.says, proof.equation.decided
    assert isinstance(says, Relation)
    assert isinstance(equation, Relation)
    p = proof.parameter
    by_unknown = derivative(substitute(equation.left, {p: proof.at}), proof.unknown)
    slope = -derivative(equation.left, p, proof.at) / by_unknown
    by_equation = Decided((proof.equation,))
    return refute(Relation(says.right, "==", slope), replace(claim, proof=by_equation))
