"""Create nodes that bind a variable: integrals, derivatives, limits, sums, products, roots.

In the body of such a node the variable is a de Bruijn index, while free variables have names. So
substitution needs no renaming, and ``∫ f(x) dx`` and ``∫ f(y) dy`` are the same tree. To inspect a
body, call :func:`tresym.reals.language.expression.opened`, which gives its variables fresh names.
Source: A. Charguéraud, *The locally nameless representation*, J. Automated Reasoning 49 (2012) 363.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ORDERS,
    UNWORKED,
    Expr,
    add,
    bind,
    factors_in,
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
    """Return ∫ f from ``low`` to ``high`` over the variable ``name``, which is not bound in the
    ends.

    Example:
        >>> str(integral(symbol("x"), "x", number(0), number(1)))
        'integral(x, x, 0, 1)'
    """
    return Expr("integral", (bind(f, (name,)), low, high), (name,))


def antiderivative(f: Expr, name: str) -> Expr:
    """Return the indefinite integral of f: any function of ``name`` whose derivative is ``f``."""
    return Expr("antiderivative", (bind(f, (name,)), symbol(name)), (name,))


def total(kind: str, f: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """Return the ``"sum"`` or ``"product"`` of ``f`` over the integers from ``low`` to ``high``.

    Args:
        kind: ``"sum"`` or ``"product"``.
        f: the term.
        name: the index, which is not bound in the ends.
        low: the first index.
        high: the last index; for ``low - 1`` the sum is 0 and the product 1.
    """
    return Expr(kind, (bind(f, (name,)), low, high), (name,))


def is_infinite(e: Expr) -> bool:
    """Return whether ``e`` is a sum or product of infinitely many terms."""
    ends = (symbol("oo"), -symbol("oo"))
    return e.op in ("sum", "product") and any(end in ends for end in e.args[1:])


def under_the_integral(node: Expr, name: str) -> Expr:
    """Return the derivative of an integral by a variable, as Leibniz's rule has it.

    Whether the rule holds, and the result exists, is for the caller to show.
    """
    (t,), f = opened(node, (name,))
    low, high = node.args[1:]
    ends = [
        sign * substitute(f, {t: end}) * differentiate(end, name)
        for sign, end in ((1, high), (-1, low))
        if name in symbols(end)
    ]
    slope = differentiate(f, name)
    inner = integral(slope, t, low, high) if t in symbols(slope) else slope * (high - low)
    return add(*ends, inner)


def derivative(f: Expr, name: str, point: Expr | None = None) -> Expr:
    """Return the derivative of ``f`` by the variable ``name``, at ``point`` or at the variable."""
    place = symbol(name) if point is None else point
    return Expr("derivative", (bind(f, (name,)), place), (name,))


def repeated_derivative(f: Expr, name: str, times: int) -> Expr:
    """Return the derivative of ``f`` by ``name``, taken ``times`` times one after another."""
    for _ in range(times):
        f = derivative(f, name)
    return f


def nth_derivative(f: Expr, name: str, order: Expr) -> Expr:
    """Return the derivative of ``f`` by ``name`` of integer order ``order``."""
    return Expr("nth", (bind(f, (name,)), symbol(name), order), (name,))


def at(f: Expr, values: Mapping[str, Expr]) -> Expr:
    """Return ``f`` at these values of its variables, as a node that is not evaluated.

    The value of a derivative with respect to the same variable is the derivative at that point.
    """
    names = tuple(values)
    if f.op == "derivative" and len(names) == 1 and f.args[1] == symbol(names[0]):
        inner, (point,) = f.args[0], values.values()
        if names[0] not in symbols(inner):
            return Expr("derivative", (inner, point), f.names)
    return Expr("at", (bind(f, names), *values.values()), names)


def limit(f: Expr, name: str, point: Expr, side: int = 0) -> Expr:
    """Return the limit of ``f`` as ``name`` tends to ``point``, from above (1), below (−1) or both
    (0).
    """
    return Expr("limit", (bind(f, (name,)), point, number(side)), (name,))


def root(f: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """Return the unique zero of ``f`` in the variable ``name`` strictly between the ends.

    The node has a value only if there is exactly one such zero. The variable is not bound in the
    ends.
    """
    return Expr("root", (bind(f, (name,)), low, high), (name,))


def coefficient(f: Expr, name: str, n: Expr) -> Expr:
    """Return the coefficient of zⁿ of the Taylor series of ``f`` at 0, where z is the variable."""
    return Expr("coefficient", (bind(f, (name,)), n), (name,))


def order(kind: str, gauge: Expr) -> Expr:
    """Return the Landau symbol ``O(gauge)``, ``o(gauge)``, ``Theta(gauge)`` or ``omega(gauge)``.

    Raises:
        InputError: ``kind`` is another name.
    """
    if kind not in ORDERS:
        raise InputError(f"{kind} is not an order symbol; use O, o, Theta or omega")
    return Expr(kind, (gauge,))


def outermost(*trees: Expr) -> Iterator[Expr]:
    """Yield the integrals, derivatives, values, limits and orders not contained in another such
    node.
    """
    for e in trees:
        if e.op in UNWORKED:
            yield e
        elif e.hidden:
            yield from outermost(*e.args)


def elementary(*trees: Expr) -> bool:
    """Return whether the trees contain no such node."""
    return not any(e.hidden for e in trees)


def worked_out(e: Expr) -> Expr:
    """Return ``e`` with values substituted and derivatives carried out where possible.

    A derivative by a variable inside an integral, a limit or a sum remains a node. Derivatives of
    arbitrary functions are carried out.
    """
    if e.op in LEAVES or elementary(e):
        return e
    if e.op not in ("at", "derivative"):
        if e.op not in UNWORKED or e.op == "unknown":
            return rebuild(e, tuple(map(worked_out, e.args)))
        if e.op == "root":
            (name,), body = opened(e)
            return root(worked_out(body), name, *map(worked_out, e.args[1:]))
        return _slopes_worked_out(e) if e.op == "integral" else e
    place = e.args[1]
    if e.op == "derivative" and place.op == "symbol" and symbols(e.args[0]).isdisjoint(place.args):
        body = instantiate(e.args[0], (place,))
        if elementary(body):  # the usual case, in which no fresh name is needed
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
    """Return an integral with f' for the derivatives of arbitrary functions in its integrand."""
    inner = [node for node in outermost(e.args[0]) if node.op == "derivative"]
    while any(node.op == "derivative" for node in inner):
        inner = [node.args[0] if node.op == "derivative" else node for node in inner]
    if not inner or any(node.op != "unknown" for node in inner):
        return e
    (name,), body = opened(e)
    return integral(worked_out(body), name, *e.args[1:])


def _hides(e: Expr, name: str) -> bool:
    """Return whether the dependence of ``e`` on the variable is inside a node other than a
    function or a root.
    """
    return any(
        any(_hides(arg, name) for arg in node.args) if node.op in ("unknown", "root") else True
        for node in outermost(e)
        if name in symbols(node)
    )


def ordered(e: Expr, place: Callable[[str, Expr], Any] = lambda op, arg: 0) -> Expr:
    """Return ``e`` with the operands of sums and products sorted, so that their order does not
    matter.

    The order is independent of the names of bound variables.

    Args:
        e: the expression.
        place: the place of an operand of ``"+"`` or ``"*"`` among the others.
    """
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
        if node.op in ("+", "*"):
            args = tuple(sorted(args, key=lambda arg: (place(node.op, arg), key(arg))))
        return rebuild(node, args)

    return walk(e)


def generalised(*trees: Expr) -> tuple[Expr, ...]:
    """Replace each binding node by a variable, equal nodes by the same variable.

    A statement that holds for all values of the variables holds for the values of the nodes. Users
    cannot write the names of these variables. Nodes are compared up to the order of terms and
    factors, after constant factors of integrands have been moved out of the integrals.
    """
    if elementary(*trees):
        return trees
    trees = tuple(ordered(_factors_out(e)) for e in trees)
    nodes = dict.fromkeys(outermost(*trees))
    variables = {node: symbol(f"[{n}: {node}]") for n, node in enumerate(nodes)}
    return tuple(replaced(e, variables) for e in trees)


def _factors_out(e: Expr) -> Expr:
    """Write ``∫ c f dx`` as ``c ∫ f dx`` for factors c that do not contain the variable."""
    if e.op in LEAVES or (e.op in UNWORKED and e.op != "integral"):
        return e
    if e.op != "integral":
        return rebuild(e, tuple(map(_factors_out, e.args)))
    body, low, high = e.args
    factors = factors_in(body)
    outside = [factor for factor in factors if not factor.loose]
    inside = multiply(*(factor for factor in factors if factor.loose))
    return multiply(*outside, Expr("integral", (inside, low, high), e.names))
