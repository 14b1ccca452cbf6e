"""Write the claims that the coefficients of a numerical method make: its order, and for systems.

A Runge–Kutta method is a tableau (A, b), with nodes c that are the sums of the rows of A. Its order
for one equation is one claim with the stages as equations. For systems of equations the order is p
if and only if an order condition holds for every rooted tree with at most p vertices, such as
Σ bᵢ cᵢ = 1/2: see E. Hairer, S. P. Nørsett and G. Wanner, *Solving Ordinary Differential Equations
I*, section II.2. Multistep methods and difference formulas need one claim.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from tresym.reals.language.expression import ZERO, Expr, add, as_expr, symbol, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError, exact_number

Tree: TypeAlias = tuple["Tree", ...]
"""The branches at the root of a rooted tree, in ascending order."""
LARGEST_ORDER = 8
"""The largest order for which order conditions are written: there are 200."""


def scheme_claims(
    *,
    order: int,
    tableau: tuple[Sequence[Sequence[Any]], Sequence[Any]] | None = None,
    multistep: tuple[Sequence[Any], Sequence[Any]] | None = None,
    stencil: Mapping[Any, Any] | None = None,
    nodes: Sequence[Any] | None = None,
    derivative: int = 1,
    autonomous: bool = False,
) -> list[str]:
    """Return the claims that a method has an order, as text for :func:`tresym.check`.

    Coefficients are integers, fractions or text such as ``"1/2 - sqrt(3)/6"``; no floats. Give one
    of ``tableau``, ``multistep`` and ``stencil``.

    Args:
        order: the order that is claimed.
        tableau: the rows of A and the weights b of a Runge–Kutta method. Rows may be as short as
            their last coefficient that is not 0; rows that are longer are implicit stages.
        multistep: α₀ … αₖ and β₀ … βₖ of Σ αⱼ y(t + j h) = h Σ βⱼ f(t + j h, y(t + j h)).
        stencil: the weights wₛ at the offsets s of Σ wₛ f(x + s h)/hᵈ ≈ the d-th derivative.
        nodes: the nodes c of a tableau, if they are not the sums of the rows.
        derivative: d.
        autonomous: whether the equation is y′ = f(y) instead of y′ = f(t, y).

    Returns:
        One claim for scalar equations; for a tableau also the order conditions for systems.

    Raises:
        InputError: a coefficient is a float or not a constant, or lengths do not agree.

    Example:
        >>> import tresym
        >>> midpoint = tresym.scheme_claims(tableau=([[], ["1/2"]], [0, 1]), order=2)
        >>> midpoint[-1]
        '(1/2) == 1/2'
        >>> all(tresym.check(claim) for claim in midpoint)
        True
        >>> tresym.scheme_claims(stencil={-1: 1, 0: -2, 1: 1}, derivative=2, order=2)
        ['(f(x - h) + -2*f(x) + f(x + h))/h**2 == diff(f(x), x, 2) + O(h**2) as h -> 0']
    """
    given = [kind for kind in (tableau, multistep, stencil) if kind is not None]
    if len(given) != 1:
        raise InputError("give one of tableau, multistep and stencil")
    if type(order) is not int or order < 1:
        raise InputError(f"the order {order!r} is not a positive integer")
    if stencil is not None:
        return [_of_stencil(stencil, derivative, order)]
    if multistep is not None:
        return [_of_multistep(*multistep, order, autonomous)]
    assert tableau is not None
    rows = [[_coefficient(a) for a in row] for row in tableau[0]]
    weights = [_coefficient(b) for b in tableau[1]]
    if len(rows) != len(weights) or any(len(row) > len(rows) for row in rows):
        raise InputError("a tableau has as many rows as weights, and no row is longer than that")
    places = [_total(row) for row in rows] if nodes is None else list(map(_coefficient, nodes))
    if len(places) != len(rows):
        raise InputError("there are as many nodes as rows")
    if order > LARGEST_ORDER:
        raise InputError(f"order conditions are written up to order {LARGEST_ORDER}")
    claims = [_of_tableau(rows, weights, places, order, autonomous)]
    if nodes is not None and not autonomous:  # order conditions are for the system of t and y
        claims += [f"{_total(row)} == {c}" for row, c in zip(rows, places, strict=True)]
    for tree in (tree for n in range(1, order + 1) for tree in rooted_trees(n)):
        weight = _sum(weights, [_product(rows, tree, i) for i in range(len(rows))])
        claims.append(f"{weight} == {Fraction(1, density(tree))}")
    return claims


def _coefficient(value: Any) -> Expr:
    """Return a constant as an expression."""
    e = parse(value) if isinstance(value, str) else as_expr(exact_number(value, "coefficient"))
    if symbols(e) or e.hidden:
        raise InputError(f"the coefficient {value} is not a constant")
    return e


def _text(e: Expr) -> str:
    """Return a coefficient as a factor in text."""
    shown = str(e)
    return f"({shown})" if any(sign in shown[1:] for sign in "+-") else shown


def _total(terms: Sequence[Expr]) -> Expr:
    return add(*terms) if terms else ZERO


def _sum(coefficients: Sequence[Expr], values: Sequence[str]) -> str:
    """Return a sum of products without the terms that are 0, and without factors 1."""
    terms = [
        value if str(c) == "1" else f"{_text(c)}*{value}" if value else _text(c)
        for c, value in zip(coefficients, values, strict=False)
        if str(c) != "0" and value != "0"
    ]
    return " + ".join(term or "1" for term in terms) or "0"


def _at(step: Expr, base: str) -> str:
    """Return the argument base + step*h."""
    return base if step == ZERO else str(symbol(base) + step * symbol("h"))


def _equation(autonomous: bool) -> str:
    return f"diff(y(t), t) == {'f(y(t))' if autonomous else 'f(t, y(t))'}"


def _of_stencil(stencil: Mapping[Any, Any], derivative: int, order: int) -> str:
    steps, weights = map(_coefficient, stencil), map(_coefficient, stencil.values())
    total = _sum(list(weights), [f"f({_at(step, 'x')})" for step in steps])
    if type(derivative) is not int or derivative < 0:
        raise InputError(f"the derivative {derivative!r} is not a natural number")
    value = f"diff(f(x), x, {derivative})" if derivative else "f(x)"
    quotient = f"({total})/h**{derivative}" if derivative else total
    return f"{quotient} == {value} + O(h**{order}) as h -> 0"


def _of_multistep(alpha: Sequence[Any], beta: Sequence[Any], order: int, autonomous: bool) -> str:
    times = [_at(as_expr(j), "t") for j in range(max(len(alpha), len(beta)))]
    slope = "f(y({0}))" if autonomous else "f({0}, y({0}))"
    left = _sum(list(map(_coefficient, alpha)), [f"y({time})" for time in times])
    right = _sum(list(map(_coefficient, beta)), [slope.format(time) for time in times])
    claim = f"{left} == h*({right}) + O(h**{order + 1})"
    return f"{claim} as h -> 0 given {_equation(autonomous)}"


def _of_tableau(
    rows: list[list[Expr]], weights: list[Expr], nodes: list[Expr], order: int, autonomous: bool
) -> str:
    names = [f"k{i}" for i in range(1, len(rows) + 1)]
    stages = []
    for name, row, node in zip(names, rows, nodes, strict=True):
        step = _sum(row, names)
        place = "y(t)" if step == "0" else f"y(t) + h*({step})"
        time = "" if autonomous else f"{_at(node, 't')}, "
        stages.append(f"{name} == f({time}{place})")
    claim = f"y(t + h) == y(t) + h*({_sum(weights, names)}) + O(h**{order + 1})"
    return f"{claim} as h -> 0 given {', '.join((_equation(autonomous), *stages))}"


def _product(rows: list[list[Expr]], tree: Tree, i: int) -> str:
    """Return the weight of the branches of a tree at a stage; "" for 1."""
    factors = []
    for branch in tree:
        inner = [_product(rows, branch, j) for j in range(len(rows))]
        total = str(_total(rows[i])) if not branch else _sum(rows[i], inner)
        if total == "0":
            return "0"
        factors.append(f"({total})" if any(sign in total for sign in "+-*/") else total)
    return "*".join(factors)


def rooted_trees(vertices: int) -> Iterator[Tree]:
    """Yield the rooted trees with a number of vertices.

    Example:
        >>> [len(list(rooted_trees(n))) for n in range(1, 9)]
        [1, 1, 2, 4, 9, 20, 48, 115]
    """
    yield from _forests(vertices - 1, vertices - 1, ())


def _forests(vertices: int, largest: int, least: Tree) -> Iterator[Tree]:
    """Yield multisets of trees, those with more vertices first."""
    if vertices == 0:
        yield ()
        return
    for n in range(min(vertices, largest), 0, -1):
        for first in rooted_trees(n):
            if n == largest and least and first > least:
                continue
            for rest in _forests(vertices - n, n, first):
                yield (first, *rest)


def density(tree: Tree) -> int:
    """Return the product of the numbers of vertices of all subtrees, γ of Butcher."""
    found = size(tree)
    for branch in tree:
        found *= density(branch)
    return found


def size(tree: Tree) -> int:
    """Return the number of vertices."""
    return 1 + sum(map(size, tree))
