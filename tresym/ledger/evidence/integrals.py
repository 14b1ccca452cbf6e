"""Integrals in derivations: check every rule where it is used, until only algebra is left.

A rule replaces integrals, on both sides of a step, by what it shows them equal to. It asks for
continuity, or smoothness, on the whole interval of integration. The variable of an integral is
opened under a name that nothing else has; reasons, and the bounds they cite, speak of it by the
name it was written with.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from types import MappingProxyType
from typing import NamedTuple

from sympy import Basic

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
    tree,
)
from tresym.ledger.evidence.sign_prover import (
    NON_NEGATIVE,
    continuous_on,
    is_stated,
    manifest_sign,
    undefined,
)
from tresym.ledger.finding import StepFinding
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import (
    elementary,
    generalised,
    integral,
    ordered,
    outermost,
    worked_out,
)
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    ONE,
    ZERO,
    Expr,
    differentiate,
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
    """What a rule asks for is not shown; the text says what."""

    def __init__(self, why: str, steps: tuple[StepFinding, ...] = ()) -> None:
        """What was shown before, and the step that was not, may be said too."""
        super().__init__(why)
        self.steps = steps


def need(shown: bool, why: str, steps: tuple[StepFinding, ...] = ()) -> None:
    """That something is shown.

    Raises:
        NotShownError: it is not.
    """
    if not shown:
        raise NotShownError(why, steps)


def with_bounds(
    given: Conditions, reasons: tuple[Reason, ...], put: Mapping[str, Expr] = NOTHING
) -> Conditions:
    """The conditions, and the cited bounds whose own conditions are among them.

    Args:
        put: what the variables of the claims that are cited are here.
    """
    bounds = {_in_order(condition): condition for condition in given}
    for claim in (c for reason in reasons if reason.name == "citing" for c in reason.claims):
        if all(_in_order(_put(c, put)) in bounds for c in conditions(claim.given)):
            for part in conjuncts(formula(claim.decided)) if claim.in_formulas else ():
                if isinstance(part, Relation) and part.sign != "==":
                    spoken_of = symbols(part.left) | symbols(part.right)
                    behind = dependencies((*claim.rests_on, claim)) if put else {}
                    if dependent(spoken_of, put, behind) is not None:
                        continue  # what is defined by the variable would stay what it was
                    bound = _put(part, put)
                    bounds.setdefault(_in_order(bound), bound)
    return tuple(bounds.values())


@lru_cache(maxsize=REMEMBERED)
def _in_order(relation: Relation) -> Relation:
    return Relation(ordered(relation.left), relation.sign, ordered(relation.right))


def _put(relation: Relation, put: Mapping[str, Expr]) -> Relation:
    if not put:
        return relation
    left, right = (substitute(side, put) for side in (relation.left, relation.right))
    return Relation(left, relation.sign, right)


def without_integrals(
    before: Expr, after: Expr, reasons: tuple[Reason, ...], given: Conditions
) -> tuple[Expr, Expr]:
    """Both sides of a step after the rules for integrals that its reasons name.

    Raises:
        NotShownError: a rule does not apply, or what it asks for is not shown, or that an integral
            exists of which no rule spoke.
    """
    shown: set[Expr] = set()
    for reason in reasons:
        rule = RULES.get(reason.name)
        if rule is not None:
            before, after = ordered(before), ordered(after)
            found = rule(before, after, reason, given)
            before, after = replaced(before, found), replaced(after, found)
            shown.update(outermost(*found.values()))
    need_integrals(set(outermost(before, after)) - shown, given)
    return before, after


def sign_of_integral(
    node: Expr, bounds: tuple[Claim, ...], given: Conditions, strict: bool
) -> str | None:
    """The sign of the integral of a continuous integrand that is not negative, its ends in order.

    ``+``, which is looked for if ``strict``, where the interval has a length and the integrand is
    positive at one of its ends, and so next to it; ``>=0`` otherwise; None where the integrand or
    the order of the ends is not shown.

    Raises:
        NotShownError: the integrand is not shown to be continuous.
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
    """That ``e`` is smooth near every point of ``given``, in all its symbols together.

    Raises:
        NotShownError: that is not shown, or ``e`` hides a derivative.
    """
    integrals = _integrals(e)
    for node in integrals:
        inside = _inside(node, (), given)
        _need_continuous(node.args[1:], given)
        _need_continuous((inside.integrand,), inside.conditions)
    variables = {node: symbol(f"[{n}]") for n, node in enumerate(integrals)}
    _need_continuous((replaced(e, variables),), given)


def need_integrals(trees: Iterable[Expr], given: Conditions) -> None:
    """That the integrals in ``trees`` exist, of smooth integrands at every point of ``given``, also
    those of which values or derivatives are taken.

    Raises:
        NotShownError: one is not shown to.
    """
    for node in outermost(*trees):
        if node.op == "integral":
            need_smooth(node, given)
        elif node.op in ("at", "derivative") and _holds_integral(node):
            need_value(node, given)


def _holds_integral(e: Expr) -> bool:
    return any(
        node.op == "integral" or any(map(_holds_integral, node.args)) for node in outermost(e)
    )


def need_value(e: Expr, given: Conditions) -> None:
    """That ``e`` has a value at every point of ``given``, its integrals and derivatives among it.

    Raises:
        NotShownError: that is not shown.
    """
    nodes = [*dict.fromkeys(outermost(e))]
    for node in nodes:
        if node.op == "integral":
            need_smooth(node, given)
            continue
        need(node.op in ("derivative", "at"), f"{node} is not shown to exist")
        for point in node.args[1:]:
            need_value(point, given)
        body, near, _ = _near(node, given)
        (need_smooth if node.op == "derivative" else need_value)(body, near)
    variables = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    gap = undefined(replaced(e, variables), given)
    need(gap is None, f"nothing shows that {gap} allows its operation")


def _near(
    node: Expr, given: Conditions, avoid: Iterable[str] = ()
) -> tuple[Expr, Conditions, Mapping[str, Expr]]:
    """The body of a derivative or value, what holds at its point, and its variables' new names.

    At a symbol that the body does not speak of, the variable is that symbol.
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
    """Whether two expressions are equal, operand by operand, what is bound at every value it takes.

    Integrands are compared on the interval of integration.
    """
    return _alike(ordered(one), ordered(other), given)


def _alike(one: Expr, other: Expr, given: Conditions) -> bool:
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
    """The integral by its antiderivative, smooth on the interval."""
    node = _one_of(_apart(before, after))
    inside = _inside(node, reason.claims, given, reason)
    primitive = inside.of(_expression(reason))
    slope = differentiate(primitive, inside.name)
    _need_equal(slope, inside.integrand, inside.conditions)
    _need_continuous((primitive, inside.integrand), inside.conditions)
    low, high = (substitute(primitive, {inside.name: end}) for end in node.args[1:])
    return {node: high - low}


def _substitute(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """∫ g(u(ψ)) u′(ψ) dψ = ∫ g dx, of an integral that stands on one side, and one on the other."""
    sides, why = (_integrals(before), _integrals(after)), "the step needs one integral on each side"
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
    """That the integral ``new`` is ``old`` in the new variable: integrands, ends, continuity."""
    inside = _inside(old, reason.claims, given, reason, new)
    change = inside.of(_expression(reason))
    pulled = instantiate(new.args[0], (change,))
    slope = worked_out(differentiate(change, inside.name))
    first, last = (substitute(change, {inside.name: end}) for end in old.args[1:])
    start, end = new.args[1:]
    if not _equal(first, start, inside.conditions):
        start, end, slope = end, start, -slope  # the new integral runs backwards
    need(_equal(first, start, inside.conditions), "the ends are not those")
    need(_equal(last, end, inside.conditions), "the ends are not those")
    need(_equal(inside.integrand, pulled * slope, inside.conditions), "other integrands")
    _need_continuous((inside.integrand, change, pulled), inside.conditions)


def _cut(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """∫ from low to high is the sum of the integrals to a point between and from it."""
    place = _expression(reason)
    sides = [_integrals(side) for side in (before, after)]
    whole = _one_of(next((side for side in sides if len(side) == 1), []))
    body, low, high = whole.args
    for room in (place - low, high - place):
        lies = manifest_sign(room, given) in NON_NEGATIVE
        need(lies, f"{place} is not shown to lie in the interval of integration")
    inside = _inside(whole, reason.claims, given)
    _need_continuous((inside.integrand,), inside.conditions)
    ends = (low, place), (place, high)
    first, second = (Expr("integral", (body, *pair), whole.names) for pair in ends)
    return {whole: first + second}


def _collect(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """A sum of multiples of integrals over one interval is the integral of the sum."""
    sides = [_integrals(side) for side in (before, after)]
    single = 0 if len(sides[0]) == 1 else 1
    whole, parts = _one_of(sides[single]), sides[1 - single]
    inside = _inside(whole, reason.claims, given, None, *parts)
    _need_continuous((inside.integrand,), inside.conditions)
    total, integrand = ZERO, ZERO
    for part in parts:
        need(part.args[1:] == whole.args[1:], "the integrals are not over one interval")
        own = _inside(part, reason.claims, given)
        _need_continuous((own.integrand,), own.conditions)
        share = _share((before, after)[1 - single], part)
        total += share * part
        integrand += share * instantiate(part.args[0], (symbol(inside.name),))
    over = -ONE if _share((before, after)[single], whole) == -ONE else ONE
    _need_equal(inside.integrand, over * integrand, inside.conditions)
    return {whole: over * total}


def _share(e: Expr, node: Expr) -> Expr:
    """The factor of an integral in ``e``; what it is taken for is any number."""
    name = "[share]"
    found = differentiate(replaced(e, {node: symbol(name)}), name)
    need(name not in symbols(found), f"{e} is no sum of multiples of integrals")
    return found


def _differentiate(before: Expr, after: Expr, reason: Reason, given: Conditions) -> Replaced:
    """Leibniz's rule: the derivative of an integral by a parameter, or by an end of it.

    The integrand must be smooth on the closed interval (hence near it), as a function of the
    variable and of the parameter together.
    """
    why = "the step needs the derivative of an integral"
    for node in dict.fromkeys(outermost(before, after)):
        if node.op == "derivative" and node.args[0].op == "integral":
            try:
                return {node: _derived(node, reason, given)}
            except NotShownError as error:
                why = str(error)
    raise NotShownError(why)


def _derived(node: Expr, reason: Reason, given: Conditions) -> Expr:
    """The derivative of an integral where the reason's slope is that of its integrand."""
    point = node.args[1]
    whole, outside, bound = _near(node, given, symbols(_expression(reason)))
    (name,) = node.names
    parameter = str((bound[name] if bound else point).args[0])
    put = {parameter: point}
    inside = _inside(whole, reason.claims, outside, reason, bound=bound)
    f, (low, high) = inside.integrand, whole.args[1:]
    need(elementary(f), "the integrand hides its parameter")
    slope = inside.of(_expression(reason))
    derived = substitute(differentiate(f, parameter), put)
    # That the parameter is its one value leaves no points to look at.
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


# What they ask for


class Inside(NamedTuple):
    """An integral with its variable under a name of its own, and what holds on its interval."""

    name: str
    written: str
    integrand: Expr
    conditions: Conditions

    def of(self, e: Expr) -> Expr:
        """What a reason says of the variable, by the name that it was written with."""
        return substitute(e, {self.written: symbol(self.name)})


def _inside(
    node: Expr,
    bounds: tuple[Claim, ...],
    given: Conditions,
    reason: Reason | None = None,
    *others: Expr,
    bound: Mapping[str, Expr] = NOTHING,
) -> Inside:
    """The integrand and the conditions on the interval of integration, with the bounds cited.

    The variable runs over the whole interval, whatever a claim assumes of a symbol of that name.
    Nor is a bound cited that rests on what that symbol, or another that is ``bound`` too, is
    defined to be.
    """
    (written,), (_, low, high) = node.names, node.args
    for claim in bounds:
        apart = defined(claim).isdisjoint({written, *bound})
        need(apart, f"{claim.label} is about a symbol that is bound here")
    spoken = () if reason is None else symbols(_expression(reason)) - {written}
    (name,), integrand = opened(node, {*_names(given), *spoken, *_names_of(others)})
    x = symbol(name)
    inside = (*given, Relation((x - low) * (high - x), ">=", ZERO))
    if manifest_sign(high - low, given) in NON_NEGATIVE:
        inside = (*inside, Relation(x, ">=", low), Relation(x, "<=", high))
    cited = Reason("citing", claims=bounds)
    return Inside(name, written, integrand, with_bounds(inside, (cited,), {**bound, written: x}))


def _names(given: Conditions) -> frozenset[str]:
    return _names_of(side for c in given for side in (c.left, c.right))


def _names_of(trees: Iterable[Expr]) -> frozenset[str]:
    return frozenset().union(*map(symbols, trees))


def _expression(reason: Reason) -> Expr:
    assert isinstance(reason.expression, Basic)
    return tree(reason.expression)


def _integrals(*sides: Expr) -> list[Expr]:
    return [*dict.fromkeys(node for node in outermost(*sides) if node.op == "integral")]


def _apart(before: Expr, after: Expr) -> list[Expr]:
    """The integrals that stand on one side only, those of the left side first."""
    left, right = _integrals(before), _integrals(after)
    return [n for n in left if n not in right] + [n for n in right if n not in left]


def _one_of(nodes: list[Expr]) -> Expr:
    need(len(nodes) == 1, "the step needs exactly one integral to work on")
    return nodes[0]


def _need_continuous(expressions: tuple[Expr, ...], conditions: Conditions) -> None:
    for e in expressions:
        gap = continuous_on(e, conditions)
        need(gap is None, f"nothing shows that {gap} stays off its singularity")


def _need_equal(left: Expr, right: Expr, conditions: Conditions) -> None:
    """Both are equal where the conditions hold, derivatives on the left opened."""
    need(_equal(worked_out(left), right, conditions), f"{right} is not shown to be {left}")


def _equal(left: Expr, right: Expr, conditions: Conditions) -> bool:
    left, right = generalised(left, right)
    return decide_continuous(left, right, known(conditions)).verdict is Verdict.PROVED
