"""Integrals in derivations: check every rule where it is used, until only algebra is left.

The rules are the fundamental theorem of calculus, the change of variable, splitting at a point,
linearity, and Leibniz's rule (W. Rudin, Principles of Mathematical Analysis, 3rd ed., chapters 6
and 9). A rule proves that an integral equals another expression and replaces it on both sides of a
step; the step is then decided by the normal form. Each rule requires continuity or smoothness on
the whole interval of integration.

The bound variable of an integral is replaced by a fresh symbol. Reasons, and the bounds they cite,
refer to it by the name it has in the written integral.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from types import MappingProxyType
from typing import NamedTuple

from tresym.ledger.claim import Claim, Reason
from tresym.ledger.conversion import (
    REMEMBERED,
    Conditions,
    conditions,
    conjuncts,
    defined,
    dependencies,
    dependent,
    formula,
    known,
)
from tresym.ledger.evidence.sign_prover import (
    NON_NEGATIVE,
    continuous_on,
    is_stated,
    manifest_sign,
    undefined,
)
from tresym.ledger.finding import StepFinding
from tresym.ledger.formulas import in_order, in_trees, is_equation
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import (
    elementary,
    generalised,
    integral,
    outermost,
    worked_out,
)
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    ONE,
    ZERO,
    Expr,
    instantiate,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.verdict import Verdict

Replaced = Mapping[Expr, Expr]
NOTHING: Mapping[str, Expr] = MappingProxyType({})


class NotShownError(ValueError):
    """A side condition could not be shown; the text says which."""

    def __init__(self, why: str, steps: tuple[StepFinding, ...] = ()) -> None:
        """Store the reason, and the findings on the steps checked so far."""
        super().__init__(why)
        self.steps = steps


def need(shown: bool, why: str, steps: tuple[StepFinding, ...] = ()) -> None:
    """Require a side condition.

    Args:
        shown: whether it has been shown.
        why: the message if it has not.
        steps: findings on the steps checked so far.

    Raises:
        NotShownError: ``shown`` is false.
    """
    if not shown:
        raise NotShownError(why, steps)


def with_bounds(
    given: Conditions, reasons: tuple[Reason, ...], put: Mapping[str, Expr] = NOTHING
) -> Conditions:
    """Return the conditions together with the cited bounds whose own conditions are among them.

    Args:
        given: the conditions.
        reasons: the reasons; only ``citing`` adds bounds.
        put: replacements for variables of the cited claims, by name.
    """
    bounds = {_in_order(condition): condition for condition in given}
    for claim in (c for reason in reasons if reason.name == "citing" for c in reason.claims):
        if any(map(is_equation, map(in_trees, claim.given))):
            continue
        if all(_in_order(_put(c, put)) in bounds for c in conditions(claim.given)):
            for part in conjuncts(formula(claim.decided)) if claim.in_formulas else ():
                if isinstance(part, Relation) and part.sign != "==":
                    spoken_of = symbols(part.left) | symbols(part.right)
                    behind = dependencies((*claim.rests_on, claim)) if put else {}
                    if dependent(spoken_of, put, behind) is not None:
                        continue  # a symbol defined by the variable would not be replaced
                    bound = _put(part, put)
                    bounds.setdefault(_in_order(bound), bound)
    return tuple(bounds.values())


@lru_cache(maxsize=REMEMBERED)
def _in_order(relation: Relation) -> Relation:
    """Return the relation with its operands in a canonical order, for comparison."""
    return Relation(in_order(relation.left), relation.sign, in_order(relation.right))


def _put(relation: Relation, put: Mapping[str, Expr]) -> Relation:
    """Substitute into both sides of a relation."""
    if not put:
        return relation
    left, right = (substitute(side, put) for side in (relation.left, relation.right))
    return Relation(left, relation.sign, right)


def without_integrals(
    before: Expr, after: Expr, reasons: tuple[Reason, ...], given: Conditions
) -> tuple[Expr, Expr]:
    """Apply the rules for integrals that the reasons of a step name to both of its sides.

    Args:
        before: the left side of the step.
        after: the right side of the step.
        reasons: the reasons, applied in order.
        given: the conditions.

    Raises:
        NotShownError: a rule does not apply, a side condition of a rule could not be shown, or a
            remaining integral could not be shown to exist.
    """
    shown: set[Expr] = set()
    for reason in reasons:
        rule = RULES.get(reason.name)
        if rule is not None:
            before, after = in_order(before), in_order(after)
            found = rule(before, after, reason, given)
            before, after = replaced(before, found), replaced(after, found)
            shown.update(outermost(*found.values()))
    need_integrals(set(outermost(before, after)) - shown, given)
    return before, after


def sign_of_integral(
    node: Expr, bounds: tuple[Claim, ...], given: Conditions, strict: bool
) -> str | None:
    """Return the sign of an integral whose integrand is continuous and non-negative.

    Args:
        node: the integral.
        bounds: claims whose bounds on the integrand may be used.
        given: the conditions.
        strict: whether to look for a strict sign.

    Returns:
        ``"+"`` if ``strict``, the interval has positive length and the integrand is positive at one
        of its ends, hence also near it; otherwise ``">=0"``. None if the sign of the integrand or
        the order of the ends could not be shown.

    Raises:
        NotShownError: the integrand could not be shown to be continuous.
    """
    inside = _inside(node, bounds, given)
    f, low, high = inside.integrand, *node.args[1:]
    _need_continuous((f,), inside.conditions)
    length = manifest_sign(high - low, given)
    if length not in NON_NEGATIVE:
        return None
    shown = manifest_sign(f, inside.conditions, ">=") in NON_NEGATIVE
    if not shown and not is_stated(f, inside.conditions):
        return None
    ends = (instantiate(node.args[0], (end,)) for end in (low, high))
    positive = (manifest_sign(end, given) == "+" for end in ends)
    return "+" if strict and length == "+" and any(positive) else ">=0"


def need_smooth(e: Expr, given: Conditions) -> None:
    """Require that ``e`` is smooth near every point of ``given``, jointly in all its symbols.

    Raises:
        NotShownError: smoothness could not be shown, or ``e`` contains an unevaluated derivative.
    """
    integrals = _integrals(e)
    for node in integrals:
        inside = _inside(node, (), given)
        _need_continuous(node.args[1:], given)
        _need_continuous((inside.integrand,), inside.conditions)
    variables = {node: symbol(f"[{n}]") for n, node in enumerate(integrals)}
    _need_continuous((replaced(e, variables),), given)


def need_integrals(trees: Iterable[Expr], given: Conditions) -> None:
    """Require that all integrals in ``trees`` exist and have smooth integrands under ``given``.

    This includes integrals inside derivatives and substitutions.

    Raises:
        NotShownError: the existence of an integral could not be shown.
    """
    for node in outermost(*trees):
        if node.op == "integral":
            need_smooth(node, given)
        elif node.op in ("at", "derivative") and holds_integral(node):
            need_value(node, given)


def holds_integral(e: Expr) -> bool:
    """Return whether ``e`` contains an integral."""
    return any(
        node.op == "integral" or any(map(holds_integral, node.args)) for node in outermost(e)
    )


def need_value(e: Expr, given: Conditions) -> None:
    """Require that ``e``, with its integrals and derivatives, is defined under ``given``.

    Raises:
        NotShownError: this could not be shown.
    """
    nodes = [*dict.fromkeys(outermost(e))]
    for node in nodes:
        if node.op == "integral":
            need_smooth(node, given)
            continue
        need(node.op in ("derivative", "at"), f"could not show that {node} exists")
        for point in node.args[1:]:
            need_value(point, given)
        body, near, _ = _near(node, given)
        (need_smooth if node.op == "derivative" else need_value)(body, near)
    variables = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    gap = undefined(replaced(e, variables), given)
    need(gap is None, f"could not show that {gap} lies in the domain of its operation")


def _near(
    node: Expr, given: Conditions, avoid: Iterable[str] = ()
) -> tuple[Expr, Conditions, Mapping[str, Expr]]:
    """Open a derivative or substitution at its point.

    Returns:
        The body with its bound variables replaced by fresh symbols, the conditions extended by the
        values of these symbols, and the symbols by the written names of the variables. If the point
        is a symbol that does not occur in the body, that symbol itself replaces the variable, and
        the names are empty.
    """
    points = node.args[1:]
    if (
        len(points) == 1
        and points[0].op == "symbol"
        and not symbols(points[0]) & symbols(node.args[0])
    ):
        return instantiate(node.args[0], points), given, NOTHING
    names, body = opened(node, {*_names(given), *avoid})
    variables = tuple(map(symbol, names))
    pairs = zip(variables, points, strict=True)
    there = (Relation(x, sign, p) for x, p in pairs for sign in (">=", "<="))
    return body, (*given, *there), dict(zip(node.names, variables, strict=True))


def under_binder(one: Expr, other: Expr, given: Conditions) -> bool:
    """Return whether two expressions are proved equal, comparing operand by operand.

    Integrands are compared on the interval of integration, the bodies of other binders for all
    values of the bound variable.
    """
    return _alike(in_order(one), in_order(other), given)


def _alike(one: Expr, other: Expr, given: Conditions) -> bool:
    """Compare two expressions with operands in canonical order; see `under_binder`."""
    if one == other:
        return True
    if elementary(one, other):
        return _equal(one, other, given)
    if one.op != other.op or len(one.args) != len(other.args) or one.op in LEAVES:
        return False
    if one.op not in BINDERS:
        return all(_alike(p, q, given) for p, q in zip(one.args, other.args, strict=True))
    names, f = opened(one, {*_names(given), *symbols(other)})
    variables = tuple(map(symbol, names))
    if one.op == "integral":
        low, high = one.args[1:]
        x = variables[0]
        inside = (*given, Relation((x - low) * (high - x), ">=", ZERO))
    else:
        inside = given
    points = zip(one.args[1:], other.args[1:], strict=True)
    if not all(_alike(p, q, given) for p, q in points):
        return False
    return _alike(f, instantiate(other.args[0], variables), inside)


# The rules


def _integrate(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """Fundamental theorem of calculus: ∫ f = F(high) − F(low), with F smooth on the interval."""
    node = _one_of(_apart(before, after))
    inside = _inside(node, reason.claims, given, reason)
    primitive = inside.of(_expression(reason))
    slope = differentiate(primitive, inside.name)
    _need_equal(slope, inside.integrand, inside.conditions)
    _need_continuous((primitive, inside.integrand), inside.conditions)
    low, high = (substitute(primitive, {inside.name: end}) for end in node.args[1:])
    return {node: high - low}


def _substitute(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """Change of variable: ∫ g(u(ψ)) u′(ψ) dψ = ∫ g(x) dx, with one integral on each side."""
    sides = (_integrals(before), _integrals(after))
    why = "a change of variable needs one integral on each side of the step"
    for old in _apart(before, after):
        for new in sides[old in sides[0]]:
            if old.names[0] in symbols(_expression(reason)):
                try:
                    _need_change(old, new, reason, given)
                except NotShownError as error:
                    why = str(error)
                else:
                    return {old: new}
    raise NotShownError(why)


def _need_change(old: Expr, new: Expr, reason: Reason, given: Conditions) -> None:
    """Require that ``new`` is ``old`` in the new variable: integrands, ends and continuity."""
    inside = _inside(old, reason.claims, given, reason, new)
    change = inside.of(_expression(reason))
    pulled = in_order(instantiate(new.args[0], (change,)))
    slope = worked_out(differentiate(change, inside.name))
    first, last = (substitute(change, {inside.name: end}) for end in old.args[1:])
    start, end = new.args[1:]
    outside = tuple(  # the ends do not contain the variable
        c for c in inside.conditions if inside.name not in symbols(c.left) | symbols(c.right)
    )
    if not _equal(first, start, outside):
        start, end, slope = end, start, -slope  # the new variable is decreasing
    ends = "could not show that the ends of the two integrals correspond under the new variable"
    need(_equal(first, start, outside), ends)
    need(_equal(last, end, outside), ends)
    need(
        _equal(inside.integrand, pulled * slope, inside.conditions),
        "could not show that the two integrands correspond under the new variable",
    )
    _need_continuous((inside.integrand, change, pulled), inside.conditions)


def _cut(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """Split an integral: from low to high = from low to the point + from the point to high."""
    place = _expression(reason)
    sides = [_integrals(side) for side in (before, after)]
    whole = _one_of(next((side for side in sides if len(side) == 1), []))
    body, low, high = whole.args
    for distance in (place - low, high - place):
        lies = manifest_sign(distance, given) in NON_NEGATIVE
        need(lies, f"could not show that {place} lies in the interval of integration")
    inside = _inside(whole, reason.claims, given)
    _need_continuous((inside.integrand,), inside.conditions)
    ends = (low, place), (place, high)
    first, second = (Expr("integral", (body, *pair), whole.names) for pair in ends)
    return {whole: first + second}


def _collect(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """Linearity: a linear combination of integrals over one interval is one integral."""
    sides = [_integrals(side) for side in (before, after)]
    single = 0 if len(sides[0]) == 1 else 1
    whole, parts = _one_of(sides[single]), sides[1 - single]
    inside = _inside(whole, reason.claims, given, None, *parts)
    _need_continuous((inside.integrand,), inside.conditions)
    total, integrand = ZERO, ZERO
    for part in parts:
        need(part.args[1:] == whole.args[1:], "the integrals must have the same interval")
        own = _inside(part, reason.claims, given)
        _need_continuous((own.integrand,), own.conditions)
        share = _share((before, after)[1 - single], part)
        total += share * part
        integrand += share * instantiate(part.args[0], (symbol(inside.name),))
    over = -ONE if _share((before, after)[single], whole) == -ONE else ONE
    _need_equal(inside.integrand, over * integrand, inside.conditions)
    return {whole: over * total}


def _share(e: Expr, node: Expr) -> Expr:
    """Return the coefficient of the integral ``node`` in ``e``, in which it must be linear."""
    name = "[share]"
    found = differentiate(replaced(e, {node: symbol(name)}), name)
    need(name not in symbols(found), f"{e} is not a linear combination of integrals")
    return found


def _differentiate(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """Leibniz's rule: the derivative of an integral with respect to a parameter or to an end.

    The integrand must be smooth on the closed interval (and hence near it), jointly in the variable
    and in the parameter.
    """
    why = "Leibniz's rule needs the derivative of an integral in the step"
    for node in dict.fromkeys(outermost(before, after)):
        if node.op == "derivative" and node.args[0].op == "integral":
            try:
                return {node: _derived(node, reason, given)}
            except NotShownError as error:
                why = str(error)
    raise NotShownError(why)


def _derived(node: Expr, reason: Reason, given: Conditions) -> Expr:
    """Return the derivative of an integral; the stated derivative of its integrand is checked."""
    point = node.args[1]
    whole, outside, bound = _near(node, given, symbols(_expression(reason)))
    (name,) = node.names
    parameter = str((bound[name] if bound else point).args[0])
    put = {parameter: point}
    inside = _inside(whole, reason.claims, outside, reason, bound=bound)
    f, (low, high) = inside.integrand, whole.args[1:]
    need(elementary(f), "the integrand must not contain integrals, derivatives or limits")
    slope = inside.of(_expression(reason))
    derived = substitute(differentiate(f, parameter), put)
    # A condition that fixes the parameter at one value leaves no open set of sample points.
    free = tuple(c for c in inside.conditions if not bound or parameter not in _names((c,)))
    _need_equal(derived, slope, free)
    _need_continuous((f, slope), inside.conditions)
    value = ZERO
    if slope != ZERO:
        value = integral(slope, inside.name, *(substitute(end, put) for end in (low, high)))
    for end, way in ((high, 1), (low, -1)):
        if parameter in symbols(end):
            _need_continuous((end,), outside)
            moved = differentiate(end, parameter) * instantiate(whole.args[0], (end,))
            value += way * substitute(moved, put)
    return value


Rule = Callable[[Expr, Expr, Reason, Conditions], Replaced]

RULES: dict[str, Rule] = {
    "integrating": _integrate,
    "changing the variable": _substitute,
    "cutting": _cut,
    "collecting": _collect,
    "differentiating the integral": _differentiate,
}


# Side conditions of the rules


class Inside(NamedTuple):
    """An opened integral: names of its variable (fresh and as written), integrand, conditions.

    The conditions hold for all values of the variable in the interval of integration.
    """

    name: str
    written: str
    integrand: Expr
    conditions: Conditions

    def of(self, e: Expr) -> Expr:
        """Return an expression from a reason with the fresh name of the variable."""
        return substitute(e, {self.written: symbol(self.name)})


def _inside(
    node: Expr,
    bounds: tuple[Claim, ...],
    given: Conditions,
    reason: Reason | None = None,
    *others: Expr,
    bound: Mapping[str, Expr] = NOTHING,
) -> Inside:
    """Open an integral: return its integrand and the conditions on the interval of integration.

    Conditions on a symbol with the same name as the bound variable are not used, because the
    variable runs over the whole interval. A bound is not cited if it depends on the definition of
    a symbol with that name, or of another symbol that is ``bound``.
    """
    (written,), (_, low, high) = node.names, node.args
    for claim in bounds:
        apart = defined(claim).isdisjoint({written, *bound})
        need(apart, f"{claim.label} cannot be cited: it is about a symbol that is bound here")
    spoken = () if reason is None else symbols(_expression(reason)) - {written}
    (name,), integrand = opened(node, {*_names(given), *spoken, *_names_of(others)})
    x = symbol(name)
    inside = (*given, Relation((x - low) * (high - x), ">=", ZERO))
    if manifest_sign(high - low, given) in NON_NEGATIVE:
        inside = (*inside, Relation(x, ">=", low), Relation(x, "<=", high))
    cited = Reason("citing", claims=bounds)
    return Inside(name, written, integrand, with_bounds(inside, (cited,), {**bound, written: x}))


def _names(given: Conditions) -> frozenset[str]:
    """Return the symbols of the conditions."""
    return _names_of(side for c in given for side in (c.left, c.right))


def _names_of(trees: Iterable[Expr]) -> frozenset[str]:
    """Return the symbols of the expressions."""
    return frozenset().union(*map(symbols, trees))


def _expression(reason: Reason) -> Expr:
    """Return the expression that a reason carries."""
    assert reason.expression is not None
    return in_trees(reason.expression)


def _integrals(*sides: Expr) -> list[Expr]:
    """Return the outermost integrals, without repetition."""
    return [*dict.fromkeys(node for node in outermost(*sides) if node.op == "integral")]


def _apart(before: Expr, after: Expr) -> list[Expr]:
    """Return the integrals that occur on one side only, those of the left side first."""
    left, right = _integrals(before), _integrals(after)
    return [n for n in left if n not in right] + [n for n in right if n not in left]


def _one_of(nodes: list[Expr]) -> Expr:
    """Return the only element; require that there is exactly one."""
    need(len(nodes) == 1, "this rule needs exactly one integral that the step changes")
    return nodes[0]


def _need_continuous(expressions: tuple[Expr, ...], conditions: Conditions) -> None:
    """Require that the expressions are continuous under the conditions."""
    for e in expressions:
        gap = continuous_on(e, conditions)
        need(gap is None, f"could not show that {gap} stays away from its singularity")


def _need_equal(left: Expr, right: Expr, conditions: Conditions) -> None:
    """Require equality under the conditions, after carrying out the derivatives on the left."""
    need(_equal(worked_out(left), right, conditions), f"could not show {left} = {right}")


def _equal(left: Expr, right: Expr, conditions: Conditions) -> bool:
    """Return whether equality is proved under the conditions."""
    left, right = generalised(left, right)
    return decide_continuous(left, right, known(conditions)).verdict is Verdict.PROVED
