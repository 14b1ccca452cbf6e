"""From the SymPy expressions that claims say to the expression trees that are decided.

Derivatives and integrals are symbols of their own until a reason opens them; definitions are put
in here, and only those that a reason names.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from sympy import Basic, Derivative, Eq, Integer, Integral, MatrixBase, Subs, Symbol, srepr

from tresym.ledger.claim import Claim, Definition, ImplicitFunction, parts_of
from tresym.reals.language.expression import Expr, differentiate, substitute
from tresym.reals.language.sympy import from_sympy
from tresym.reals.places.conditions import Given

Rules = dict[Basic, Basic]

MAX_PASSES = 20
BOUND = Symbol("[bound]", real=True)
"""The name of every variable of integration: ∫ f(x) dx and ∫ f(y) dy are one number."""
DEFINING = (Definition, ImplicitFunction)
"""Evidence that introduces symbols."""
REMEMBERED = 4096
"""Translations and signs kept: the same conditions come back at every step of a chain."""


class CircularError(ValueError):
    """Definitions that define a symbol by itself, or reach a variable that is bound."""


def definitions(claims: Iterable[Claim]) -> Rules:
    """The equations that the claims say, as replacements of left sides, entry by entry."""
    rules: Rules = {}
    for claim in claims:
        for part in parts_of(claim.says):
            if isinstance(part, Eq):
                rules.update(_rules_of(part))
    return rules


def defined(claim: Claim) -> frozenset[Basic]:
    """The symbols that are no variables of ``claim``: what it rests on says what they are.

    An equation for an integral may define any symbol in it.
    """
    behind = (c for c in (claim, *claim.rests_on) if isinstance(c.proof, DEFINING))
    return frozenset().union(*(left.free_symbols for c in behind for left in definitions((c,))))


def _rules_of(equation: Eq) -> Rules:
    left, right = equation.args
    if isinstance(left, MatrixBase) and isinstance(right, MatrixBase):
        return {s: e for s, e in zip(left, right, strict=True) if isinstance(s, Symbol)}
    return {left: right}


def put_in(expression: Basic, rules: Rules) -> Basic:
    """Replace left sides by right sides until none is left.

    Raises:
        CircularError: a symbol is defined by itself, or by a variable that is bound where it is.
    """
    for _ in range(MAX_PASSES):
        _keep_bound_variables(expression, rules)
        replaced = expression.xreplace(rules)
        if replaced == expression:
            return expression
        expression = replaced
    raise CircularError(f"definitions of {sorted(map(str, rules))} never end")


def _keep_bound_variables(expression: Basic, rules: Rules) -> None:
    """What is said of a variable under conditions is not said where another takes its name."""
    for node in expression.atoms(Integral, Derivative, Subs):
        bound = set(node.variables)
        for left, right in rules.items():
            if node == left:  # it is replaced as it stands, where nothing binds its point
                continue
            if bound & (left.free_symbols | right.free_symbols) and node.has(left):
                raise CircularError(f"a definition reaches {left}, where a variable is bound")


@lru_cache(maxsize=REMEMBERED)
def to_given(conditions: tuple[Basic, ...]) -> Given:
    """SymPy conditions as the conditions that are decided under."""
    return Given.from_sympy(*conditions)


@lru_cache(maxsize=REMEMBERED)
def to_expression(e: Basic, open_derivatives: bool = False) -> Expr:
    """The expression tree of ``e``; with ``open_derivatives`` its derivatives are carried out."""
    opaque: dict[Basic, Basic] = {}
    opened: dict[str, Expr] = {}
    for node in _outermost(e):
        factor, kept = _normal(node)
        symbol = Symbol(f"[{srepr(kept)}]", real=True)
        opaque[node] = factor * symbol
        if open_derivatives and _opens(node):
            opened[symbol.name] = _carried_out(node)
    tree = from_sympy(e.xreplace(opaque) if opaque else e)
    return substitute(tree, opened) if opened else tree


def _normal(node: Basic) -> tuple[Basic, Basic]:
    """An integral as a constant times one over the variable ``BOUND``; anything else as it is."""
    if not isinstance(node, Integral) or len(node.limits) != 1 or len(node.limits[0]) != 3:
        return Integer(1), node
    variable, low, high = node.limits[0]
    factor, rest = node.function.as_independent(variable, as_Add=False)
    return factor, Integral(rest.xreplace({variable: BOUND}), (BOUND, low, high))


def _opens(node: Basic) -> bool:
    """Whether a derivative or substitution sees all that depends on its variables."""
    if isinstance(node, Integral):
        return False
    return not any(set(node.variables) & kept.free_symbols for kept in _kept(node.expr))


def _kept(e: Basic) -> list[Basic]:
    """What stays a symbol of its own in ``e`` when its derivatives are carried out."""
    kept: list[Basic] = []
    for node in _outermost(e):
        if not _opens(node):
            kept.append(node)
            continue
        kept += _kept(node.expr)
        kept += [n for p in getattr(node, "point", ()) for n in _outermost(p)]
    return kept


def _carried_out(node: Basic) -> Expr:
    if isinstance(node, Derivative):
        tree = to_expression(node.expr, open_derivatives=True)
        for variable in node.variables:
            tree = differentiate(tree, variable.name)
        return tree
    inner = to_expression(node.expr, open_derivatives=True)
    return substitute(
        inner,
        {v.name: to_expression(p) for v, p in zip(node.variables, node.point, strict=True)},
    )


def _outermost(e: Basic) -> list[Basic]:
    """Derivatives, substitutions and integrals that no other such node contains."""
    if isinstance(e, Derivative | Subs | Integral):
        return [e]
    return [node for argument in e.args for node in _outermost(argument)]
