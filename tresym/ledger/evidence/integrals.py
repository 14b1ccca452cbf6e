"""Integrals in chains: each rule checked where it is used, until only algebra is left.

A rule replaces integrals, on both sides of a step, by what it shows them equal to. It asks for
continuity, or smoothness, on the whole interval of integration, whatever a claim assumes of a
symbol that has the name of the variable.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from sympy import Basic, Derivative, Eq, Expr, Integer, Integral, Rel, Subs, Symbol

from tresym.ledger.claim import Claim, Reason, parts_of
from tresym.ledger.evidence.defined import Conditions, continuous_on
from tresym.ledger.evidence.manifest import NON_NEGATIVE, is_stated, manifest_sign
from tresym.ledger.meaning import defined, to_expression, to_given
from tresym.ledger.reasons import citing
from tresym.reals.decisions.identity import decide
from tresym.reals.language.expression import Expr as Tree
from tresym.reals.verdict import Verdict

Sides = tuple[Basic, Basic]

FRESH = Symbol("[of the sum]", real=True)
"""The variable of integrals that are added: no claim can name it."""


class NotShownError(ValueError):
    """What a rule asks for is not shown; the text says what."""


def with_bounds(given: Conditions, reasons: tuple[Reason, ...]) -> Conditions:
    """The conditions, and the cited bounds whose own conditions are among them."""
    bounds = list(given)
    for reason in reasons:
        if reason.name == "citing":
            for claim in reason.claims:
                if set(claim.given) <= set(bounds):
                    parts = parts_of(claim.says)
                    bounds += (p for p in parts if isinstance(p, Rel) and not isinstance(p, Eq))
    return tuple(bounds)


def without_integrals(
    before: Basic, after: Basic, reasons: tuple[Reason, ...], given: Conditions
) -> Sides:
    """Both sides of a step after the rules for integrals that its reasons name.

    Raises:
        NotShownError: a rule does not apply, or what it asks for is not shown.
    """
    for reason in reasons:
        rule = RULES.get(reason.name)
        if rule is not None:
            replaced = rule(before, after, reason, given)
            for side in (before, after):
                _need_free(side, replaced)
            before, after = before.xreplace(replaced), after.xreplace(replaced)
    return before, after


def sign_of_integral(integral: Basic, bounds: tuple[Claim, ...], given: Conditions) -> str | None:
    """The sign of the integral of a continuous integrand that is not negative, its ends in order.

    ``+`` where the interval has a length and the integrand is positive at one of its ends, and so
    next to it; ``>=0`` otherwise; None where the integrand or the order of the ends is not shown.

    Raises:
        NotShownError: the integrand is not shown to be continuous.
    """
    variable, low, high = _plain(integral)
    conditions = _inside(integral, bounds, given)
    f = integral.function
    if f.has(Derivative):
        raise NotShownError("a derivative is not shown to be continuous")
    _need_continuous((f,), conditions)
    length = manifest_sign(high - low, given)
    if length not in NON_NEGATIVE:
        return None
    if not is_stated(f, conditions) and manifest_sign(f, conditions, ">=") not in NON_NEGATIVE:
        return None
    ends = [f.xreplace({variable: end}) for end in (low, high)]
    positive = (manifest_sign(end, given) == "+" for end in ends)
    return "+" if length == "+" and any(positive) else ">=0"


def need_smooth(e: Basic, bounds: tuple[Claim, ...], given: Conditions) -> None:
    """That ``e`` is smooth near every point of ``given``, in all its symbols together.

    Raises:
        NotShownError: that is not shown, or ``e`` hides a derivative.
    """
    stand_ins: dict[Basic, Basic] = {}
    for n, integral in enumerate(_ordered(e.atoms(Integral))):
        _, low, high = _plain(integral)
        if integral.function.has(Integral):
            raise NotShownError("an integral inside another")
        _need_continuous((low, high), given)
        _need_continuous((integral.function,), _inside(integral, bounds, given))
        stand_ins[integral] = Symbol(f"[integral {n}]", real=True)
    if e.has(Derivative, Subs):
        raise NotShownError("a derivative is not shown to be smooth")
    _need_continuous((e.xreplace(stand_ins),), given)


# The rules


def _integrate(before: Basic, after: Basic, reason: Reason, given: Conditions) -> Mapping:
    """The integral by its antiderivative, smooth on the interval."""
    integral = _one_of(_apart(before, after))
    variable, low, high = _plain(integral)
    primitive = _expression(reason)
    conditions = _inside(integral, reason.claims, given)
    slope = primitive.diff(variable, evaluate=False)
    _need_equal(slope, integral.function, conditions)
    _need_continuous((primitive, integral.function), conditions)
    return {integral: primitive.subs(variable, high) - primitive.subs(variable, low)}


def _substitute(before: Basic, after: Basic, reason: Reason, given: Conditions) -> Mapping:
    """∫ g(u(ψ)) u′(ψ) dψ = ∫ g dx: integrands, limits and continuity."""
    change = _expression(reason)
    apart = _apart(before, after)
    if len(apart) != 2:
        raise NotShownError("the step needs one integral on each side")
    old, new = apart if _plain(apart[0])[0] in change.free_symbols else apart[::-1]
    variable, low, high = _plain(old)
    fresh, start, end = _plain(new)
    if variable in new.free_symbols or fresh in old.free_symbols | change.free_symbols - {variable}:
        raise NotShownError("the variable of one integral is free in the other")
    conditions = _inside(old, reason.claims, given)
    pulled = new.function.subs(fresh, change)
    slope = to_expression(change.diff(variable, evaluate=False), open_derivatives=True)
    first, last = (to_expression(change.subs(variable, end)) for end in (low, high))
    forward = _equal(first, to_expression(start), conditions)
    if not forward:
        start, end, slope = end, start, -slope  # the new integral runs backwards
    _need(_equal(first, to_expression(start), conditions), "the ends are not those")
    _need(_equal(last, to_expression(end), conditions), "the ends are not those")
    integrand = to_expression(pulled) * slope
    _need(_equal(to_expression(old.function), integrand, conditions), "other integrands")
    _need_continuous((old.function, change, pulled), conditions)
    same = Symbol("[the integral]", real=True)
    return dict.fromkeys(apart, same)


def _cut(before: Basic, after: Basic, reason: Reason, given: Conditions) -> Mapping:
    """∫ from low to high is the sum of the integrals to a point between and from it."""
    at = _expression(reason)
    sides = [_ordered(side.atoms(Integral)) for side in (before, after)]
    whole = _one_of(next((side for side in sides if len(side) == 1), []))
    variable, low, high = _plain(whole)
    for room in (at - low, high - at):
        if manifest_sign(room, given) not in NON_NEGATIVE:
            raise NotShownError(f"{at} is not shown to lie in the interval of integration")
    if variable in at.free_symbols:
        raise NotShownError("an integral is not cut at its own variable")
    _need_continuous((whole.function,), _inside(whole, reason.claims, given))
    f = whole.function
    return {whole: Integral(f, (variable, low, at)) + Integral(f, (variable, at, high))}


def _collect(before: Basic, after: Basic, reason: Reason, given: Conditions) -> Mapping:
    """A sum of multiples of integrals over one interval is the integral of the sum.

    Their variables are renamed to one that is free nowhere.
    """
    sides = [_ordered(side.atoms(Integral)) for side in (before, after)]
    single = 0 if len(sides[0]) == 1 else 1
    whole, parts = _one_of(sides[single]), sides[1 - single]
    own, low, high = _plain(whole)
    total: Basic = Integer(0)
    integrand: Basic = Integer(0)
    for part in parts:
        variable, *ends = _plain(part)
        if tuple(ends) != (low, high):
            raise NotShownError("the integrals are not over one interval")
        share = (before, after)[1 - single].coeff(part)
        if share.has(Integral):
            raise NotShownError(f"the factor of {part} is no constant")
        total += share * part
        integrand += share * part.function.xreplace({variable: FRESH})
        _need_continuous((part.function,), _inside(part, reason.claims, given))
    conditions = _inside(whole, reason.claims, given)
    _need_continuous((whole.function,), conditions)
    fresh = tuple(c.xreplace({own: FRESH}) for c in conditions)
    _need_equal(whole.function.xreplace({own: FRESH}), integrand, fresh)
    return {whole: total}


def _differentiate(before: Basic, after: Basic, reason: Reason, given: Conditions) -> Mapping:
    """Leibniz's rule: the derivative of an integral by a parameter, or by an end of it.

    The integrand must be smooth on the closed interval (hence near it), as a function of the
    variable and of the parameter together.
    """
    slope = _expression(reason)
    node = _one_of(_ordered({n for e in (before, after) for n in _slopes_of_integrals(e)}))
    derivative = node.expr if isinstance(node, Subs) else node
    integral, parameter = derivative.expr, derivative.variables[0]
    variable, low, high = _plain(integral)
    f = integral.function
    if variable == parameter or f.has(Integral, Derivative, Subs):
        raise NotShownError("the integrand hides its parameter")
    put: dict[Basic, Basic] = {}
    outside, derived = given, f.diff(parameter, evaluate=False)
    if isinstance(node, Subs):
        put = {parameter: node.point[0]}
        if parameter in slope.free_symbols | node.point[0].free_symbols:
            raise NotShownError(f"{parameter} is bound")
        outside = tuple(c for c in given if parameter not in c.free_symbols)
        outside = (*outside, parameter >= node.point[0], parameter <= node.point[0])
        derived = Subs(derived, parameter, node.point[0])
    conditions = _inside(integral, reason.claims, outside, frozenset(put))
    elsewhere = tuple(c for c in conditions if parameter not in c.free_symbols)
    _need_equal(derived, slope, elsewhere if isinstance(node, Subs) else conditions)
    _need_continuous((f, slope), conditions)
    value: Basic = Integral(slope, (variable, low, high)) if slope != 0 else Integer(0)
    for end, way in ((high, 1), (low, -1)):
        if end == parameter:
            value += way * f.xreplace({variable: end})
        elif parameter in end.free_symbols:
            raise NotShownError(f"the end {end} is not the parameter itself")
    return {node: value.xreplace(put)}


Rule = Callable[[Basic, Basic, Reason, Conditions], Mapping]

RULES: dict[str, Rule] = {
    "integrating": _integrate,
    "changing the variable": _substitute,
    "cutting": _cut,
    "collecting": _collect,
    "differentiating the integral": _differentiate,
}


# What they ask for


def _expression(reason: Reason) -> Expr:
    assert reason.expression is not None
    return reason.expression


def _ordered(nodes: set[Basic]) -> list[Basic]:
    return sorted(nodes, key=lambda node: node.sort_key())


def _apart(before: Basic, after: Basic) -> list[Basic]:
    """The integrals that stand on one side only, those of the left side first."""
    left, right = (side.atoms(Integral) for side in (before, after))
    return [*_ordered(left - right), *_ordered(right - left)]


def _one_of(nodes: list[Basic]) -> Basic:
    if len(nodes) != 1:
        raise NotShownError("the step needs exactly one integral to work on")
    return nodes[0]


def _plain(integral: Basic) -> tuple[Symbol, Expr, Expr]:
    """Variable and ends of a definite integral over one variable, which its ends do not name."""
    if len(integral.limits) != 1 or len(integral.limits[0]) != 3:
        raise NotShownError("an integral has one variable and two ends")
    variable, low, high = integral.limits[0]
    if variable in low.free_symbols | high.free_symbols:
        raise NotShownError(f"{variable} is bound")
    return variable, low, high


def _slopes_of_integrals(e: Basic) -> list[Basic]:
    """Derivatives of integrals by one symbol, and their values at a point, in ``e``."""
    if isinstance(e, Subs) and len(e.variables) == 1 and _is_slope(e.expr):
        return [e] if e.variables == e.expr.variables else []
    if _is_slope(e):
        return [e]
    return [node for argument in e.args for node in _slopes_of_integrals(argument)]


def _is_slope(e: Basic) -> bool:
    return isinstance(e, Derivative) and isinstance(e.expr, Integral) and len(e.variables) == 1


def _need_free(side: Basic, replaced: Mapping) -> None:
    """A rule was shown for the symbols of the claim, not where another node binds their names."""
    for node in side.atoms(Integral, Derivative, Subs):
        for left in replaced:
            if node != left and set(node.variables) & left.free_symbols and node.has(left):
                raise NotShownError(f"{left} stands where its symbols are bound")


def _inside(
    integral: Basic,
    bounds: tuple[Claim, ...],
    given: Conditions,
    parameter: frozenset[Basic] = frozenset(),
) -> Conditions:
    """The conditions on the interval of integration, with the bounds cited for it.

    Conditions on the variable of integration are dropped: it runs over the whole interval,
    whatever a claim assumes of a symbol of that name. Nor is a bound cited that rests on what the
    variable, or a ``parameter`` that is bound too, is defined to be.
    """
    variable, low, high = _plain(integral)
    for claim in bounds:
        if defined(claim) & {variable, *parameter}:
            raise NotShownError(f"{claim.label} is about a symbol that is bound here")
    outside = tuple(c for c in given if variable not in c.free_symbols)
    inside = (*outside, (variable - low) * (high - variable) >= 0)
    if manifest_sign(high - low, outside) in NON_NEGATIVE:
        inside = (*inside, variable >= low, variable <= high)
    return with_bounds(inside, (citing(*bounds),))


def _need_continuous(expressions: tuple[Basic, ...], conditions: Conditions) -> None:
    for e in expressions:
        gap = continuous_on(e, conditions)
        if gap is not None:
            raise NotShownError(f"nothing shows that {gap} stays off its singularity")


def _need_equal(left: Basic, right: Basic, conditions: Conditions) -> None:
    """Both are equal where the conditions hold, derivatives on the left opened."""
    opened = to_expression(left, open_derivatives=True)
    _need(_equal(opened, to_expression(right), conditions), f"{right} is not shown to be {left}")


def _equal(left: Tree, right: Tree, conditions: Conditions) -> bool:
    return decide(left, right, to_given(conditions)).verdict is Verdict.PROVED


def _need(shown: bool, why: str) -> None:
    if not shown:
        raise NotShownError(why)
