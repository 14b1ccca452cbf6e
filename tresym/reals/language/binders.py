"""Nodes that bind a variable: integrals, derivatives, limits, sums, products, roots.

The variable of a node is a number in its body (de Bruijn's index) and a free variable is a name,
so substitution needs no renaming, and ``∫ f(x) dx`` and ``∫ f(y) dy`` are one tree. A body is
looked at by :func:`tresym.reals.language.expression.opened`, which gives its variables names that
are free nowhere in it. The source of the technique is A. Charguéraud, *The locally nameless
representation*, J. Automated Reasoning 49 (2012) 363.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from tresym.reals.language.expression import (
    LEAVES,
    ORDERS,
    UNWORKED,
    Expr,
    bind,
    differentiate,
    instantiate,
    multiply,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.exact import InputError


def integral(f: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """∫ f from ``low`` to ``high`` over the variable ``name``, which the ends do not know."""
    return Expr("integral", (bind(f, (name,)), low, high), (name,))


def antiderivative(f: Expr, name: str) -> Expr:
    """∫ f of the variable ``name`` without ends: any function of it whose derivative is ``f``."""
    return Expr("antiderivative", (bind(f, (name,)), symbol(name)), (name,))


def total(kind: str, f: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """The ``"sum"`` or ``"product"`` of ``f`` over the integers ``name`` from ``low`` to ``high``.

    The ends do not know the variable. Where ``high`` is ``low - 1`` there is no term: 0, or 1.
    """
    return Expr(kind, (bind(f, (name,)), low, high), (name,))


def is_infinite(e: Expr) -> bool:
    """Whether it is a sum or a product of infinitely many terms."""
    ends = (symbol("oo"), -symbol("oo"))
    return e.op in ("sum", "product") and any(end in ends for end in e.args[1:])


def derivative(f: Expr, name: str, point: Expr | None = None) -> Expr:
    """The derivative of ``f`` by the variable ``name``, at ``point`` or at the variable itself."""
    place = symbol(name) if point is None else point
    return Expr("derivative", (bind(f, (name,)), place), (name,))


def nth_derivative(f: Expr, name: str, order: Expr) -> Expr:
    """The derivative of ``f`` by the variable ``name``, as often as ``order`` says, an integer."""
    return Expr("nth", (bind(f, (name,)), symbol(name), order), (name,))


def at(f: Expr, values: Mapping[str, Expr]) -> Expr:
    """``f`` where its variables have these values, all at once, not yet worked out.

    The value of a derivative by that very variable is the derivative at the point.
    """
    names = tuple(values)
    if f.op == "derivative" and len(names) == 1 and f.args[1] == symbol(names[0]):
        inner, (point,) = f.args[0], values.values()
        if names[0] not in symbols(inner):
            return Expr("derivative", (inner, point), f.names)
    return Expr("at", (bind(f, names), *values.values()), names)


def limit(f: Expr, name: str, point: Expr, side: int = 0) -> Expr:
    """The limit of ``f`` as the variable goes to ``point``: from above (1), below (−1), or both."""
    return Expr("limit", (bind(f, (name,)), point, number(side)), (name,))


def root(f: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """The value of the variable ``name`` between the ends at which ``f`` is 0, where there is one
    and no other; the ends do not count, and do not know the variable."""
    return Expr("root", (bind(f, (name,)), low, high), (name,))


def order(kind: str, gauge: Expr) -> Expr:
    """Landau's term ``O(gauge)``, ``o(gauge)``, ``Theta(gauge)`` or ``omega(gauge)``.

    Raises:
        InputError: another letter.
    """
    if kind not in ORDERS:
        raise InputError(f"{kind} is no order; known are O, o, Theta and omega")
    return Expr(kind, (gauge,))


def outermost(*trees: Expr) -> Iterator[Expr]:
    """Integrals, derivatives, values, limits and orders that no other such node contains."""
    for e in trees:
        if e.op in UNWORKED:
            yield e
        elif e.hidden:
            yield from outermost(*e.args)


def elementary(*trees: Expr) -> bool:
    """Whether there is no such node."""
    return not any(e.hidden for e in trees)


def worked_out(e: Expr) -> Expr:
    """``e`` with values put in and derivatives carried out, but those of what hides its variable.

    An integral, a limit and a sum hide what they depend on; unknown functions do not.
    """
    if e.op in LEAVES or elementary(e):
        return e
    if e.op not in ("at", "derivative"):
        if e.op not in UNWORKED or e.op == "unknown":
            return rebuild(e, tuple(map(worked_out, e.args)))
        return _slopes_worked_out(e) if e.op == "integral" else e
    place = e.args[1]
    if e.op == "derivative" and place.op == "symbol" and symbols(e.args[0]).isdisjoint(place.args):
        body = instantiate(e.args[0], (place,))
        if elementary(body):  # as in nearly all that is written, where no name need be found
            return differentiate(body, place.args[0])
    names, body = opened(e)
    body, points = worked_out(body), tuple(map(worked_out, e.args[1:]))
    values = dict(zip(names, points, strict=True))
    if e.op == "at":
        return worked_out(substitute(body, values))
    if _hides(body, names[0]):
        return derivative(body, names[0], points[0])
    return substitute(differentiate(body, names[0]), values)


def _slopes_worked_out(e: Expr) -> Expr:
    """An integral with f' for the derivatives of unknown functions in its integrand."""
    inner = [node for node in outermost(e.args[0]) if node.op == "derivative"]
    while any(node.op == "derivative" for node in inner):
        inner = [node.args[0] if node.op == "derivative" else node for node in inner]
    if not inner or any(node.op != "unknown" for node in inner):
        return e
    (name,), body = opened(e)
    return integral(worked_out(body), name, *e.args[1:])


def _hides(e: Expr, name: str) -> bool:
    """Whether a node hides how ``e`` depends on the variable."""
    return any(
        any(_hides(arg, name) for arg in node.args) if node.op == "unknown" else True
        for node in outermost(e)
        if name in symbols(node)
    )


def ordered(e: Expr) -> Expr:
    """``e`` with the operands of its sums and products in an order that no name of a bound variable
    has a say in: what was written in another order is one tree."""
    keys: dict[Expr, str] = {}

    def key(node: Expr) -> str:
        if node not in keys:
            inner = (key(arg) if isinstance(arg, Expr) else str(arg) for arg in node.args)
            keys[node] = f"{node.op}({' '.join(inner)})"
        return keys[node]

    def walk(node: Expr) -> Expr:
        if node.op in LEAVES:
            return node
        args = tuple(map(walk, node.args))
        return rebuild(node, tuple(sorted(args, key=key)) if node.op in ("+", "*") else args)

    return walk(e)


def generalised(*trees: Expr) -> tuple[Expr, ...]:
    """The trees with a variable for each node that binds, equal variables for equal nodes.

    What holds for all values of the variables holds for those of the nodes. No text can write the
    names. Nodes are equal up to the order of terms and factors, and constant factors of integrands
    are taken out of the integrals first.
    """
    if elementary(*trees):
        return trees
    trees = tuple(ordered(_factors_out(e)) for e in trees)
    nodes = dict.fromkeys(outermost(*trees))
    variables = {node: symbol(f"[{n}: {node}]") for n, node in enumerate(nodes)}
    return tuple(replaced(e, variables) for e in trees)


def _factors_out(e: Expr) -> Expr:
    """``∫ c f dx`` as ``c ∫ f dx`` for the factors c that do not know the variable."""
    if e.op in LEAVES or (e.op in UNWORKED and e.op != "integral"):
        return e
    if e.op != "integral":
        return rebuild(e, tuple(map(_factors_out, e.args)))
    body, low, high = e.args
    factors = body.args if body.op == "*" else (body,)
    outside = [factor for factor in factors if not factor.loose]
    inside = multiply(*(factor for factor in factors if factor.loose))
    return multiply(*outside, Expr("integral", (inside, low, high), e.names))
