"""Prove polynomial inequalities by subdividing the orthant into cones (certificates for Coq).

A polynomial is written in non-negative coordinates: a square, a distance from a bound, a side of a
simplex. If all coefficients are non-negative, so is the polynomial. Otherwise two coordinates are
compared, and the larger one is replaced by the smaller one plus a difference (successive
subdivision). The tree of comparisons is found by a heuristic search. Coq checks the result leaf by
leaf: a polynomial identity, and a sum of products of non-negative terms.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, product

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from tresym.coq.linear_dependence import Vector, as_expression, expanded
from tresym.coq.statement import term
from tresym.reals.language.expression import ONE, Expr, multiply, number

MAX_LEAVES = 150
MAX_DEPTH = 12
MAX_COORDINATES = 7
MAX_DEGREE = 14


@dataclass(frozen=True)
class Span:
    """A known range of a part: it lies between two numbers."""

    low: Fraction | None = None
    high: Fraction | None = None


@dataclass(frozen=True)
class Leaf:
    """A polynomial without negative coefficients, in coordinates."""

    coordinates: tuple[Expr, ...]
    value: fmpq_mpoly


@dataclass(frozen=True)
class Fork:
    """A comparison of two coordinates, with one subtree for each outcome."""

    one: Expr
    other: Expr
    first: Leaf | Fork
    second: Leaf | Fork


def cone_lines(
    top: Expr, spans: Mapping[Expr, Span], total: Expr | None = None
) -> list[str] | None:
    """Return sentences that prove ``0 <= top``, or None if no tree was found.

    Args:
        top: the polynomial.
        spans: bounds of the parts of the polynomial, which ``lra`` finds among the premises.
        total: a linear expression that is not negative, 1 − Σ c·part with positive c, of parts that
            are not negative.
    """
    try:
        terms = expanded(top)
    except OverflowError:
        return None
    parts = sorted({part for m in terms for part, _ in m}, key=str)
    if not parts or any(n < 0 or n > MAX_DEGREE for m in terms for _, n in m):
        return None
    choices = [
        _coordinates(terms, part, spans.get(part, Span()), total is not None) for part in parts
    ]
    cases = list(product(*choices))
    if len(cases) > 16:
        return None
    lines: list[str] = []
    signs = [part for part, choice in zip(parts, choices, strict=True) if len(choice) > 1]
    blocks = []
    for case in cases:
        found = _in_coordinates(terms, dict(zip(parts, case, strict=True)), total)
        if found is None:
            return None
        coordinates, value = found
        trees = (_tree(coordinates, value, weight, [MAX_LEAVES]) for weight in WEIGHTS)
        tree = next((tree for tree in trees if tree is not None), None)
        if tree is None:
            return None
        facts = [
            f"assert (0 <= {term(c)}) by (first [lra | positive | nra])."
            for c in coordinates
            if c != ONE
        ]
        facts.append("assert (0 <= 1) by lra.")
        blocks.append("\n".join([*facts, *_lines(top, tree)]))
    return [*lines, _split(signs, blocks)]


def _split(signs: Sequence[Expr], blocks: list[str]) -> str:
    """Return the blocks, one for each combination of signs, the first half being non-negative."""
    if not signs:
        return blocks[0]
    half = len(blocks) // 2
    first, *rest = signs
    return (
        f"destruct (Rle_or_lt 0 {term(first, 3)}).\n{{ {_split(rest, blocks[:half])} }}\n"
        f"{{ {_split(rest, blocks[half:])} }}"
    )


Choice = tuple[tuple[Expr, ...], tuple[Fraction, ...], int]
"""Coordinates, and the part as their combination divided by a power: see _coordinates."""


def _coordinates(terms: Vector, part: Expr, span: Span, simplex: bool) -> list[Choice]:
    """Return ways to write a part in coordinates, one for each possible sign.

    A way is a tuple of coordinates with the coefficients of the part in them, and the exponent: 2
    if only even powers occur and the square of the part is used.
    """
    even = all(n % 2 == 0 for m in terms for p, n in m if p == part)
    low, high = span.low, span.high
    if low is not None and high is not None and low < high and not simplex:
        width = high - low
        above, below = part - number(low), number(high) - part
        return [((above, below), (high / width, low / width, 1 / width), 1)]
    if low is not None:
        above = part - number(low) if low else part
        return [((above,), (Fraction(1), low), 1)]
    if even:
        return [((Expr("^", (part, number(2))),), (Fraction(1), Fraction(0)), 2)]
    if high is not None:
        return [((number(high) - part,), (Fraction(-1), high), 1)]
    return [
        ((part,), (Fraction(1), Fraction(0)), 1),
        ((multiply(number(-1), part),), (Fraction(-1), Fraction(0)), 1),
    ]


def _in_coordinates(
    terms: Vector, ways: Mapping[Expr, Choice], total: Expr | None
) -> tuple[tuple[Expr, ...], fmpq_mpoly] | None:
    """The coordinates, and the polynomial in them, homogeneous by 1 or by what is left of it."""
    coordinates = [c for way in ways.values() for c in way[0]]
    last = ONE if total is None else total
    coordinates.append(last)
    if len(coordinates) > MAX_COORDINATES:
        return None
    ring = fmpq_mpoly_ctx.get([f"t{k}" for k in range(len(coordinates))], Ordering.lex)
    gens = dict(zip(coordinates, ring.gens(), strict=True))
    one = gens[last]
    if total is not None:
        for m, c in expanded(total).items():
            if m:
                ((part, n),) = m
                if n != 1 or c >= 0 or part not in ways:
                    return None
                one = one + _q(-c) * gens[ways[part][0][0]]
        constant = expanded(total).get(frozenset(), Fraction(0))
        if constant <= 0:
            return None
        one = one * _q(1 / constant)
    degree = max(sum(n // ways[part][2] for part, n in m if len(ways[part][0]) == 1) for m in terms)
    tops = {part: max((dict(m).get(part, 0) for m in terms), default=0) for part in ways}
    value = ring.from_dict({})
    for m, c in terms.items():
        powers, t, used = dict(m), _q(c) * (one**0), 0
        for part, (own, factors, root) in ways.items():
            n = powers.get(part, 0) // root
            if len(own) == 2:
                x, unit = (
                    gens[own[0]] * _q(factors[0]) + gens[own[1]] * _q(factors[1]),
                    _q(factors[2]) * (gens[own[0]] + gens[own[1]]),
                )
                t = t * x**n * unit ** (tops[part] - n)
            elif n:
                t = t * (_q(factors[0]) * gens[own[0]] + _q(factors[1]) * one) ** n
                used += n
        value = value + t * one ** (degree - used)
    return tuple(coordinates), value


def _q(x: Fraction) -> fmpq:
    return fmpq(x.numerator, x.denominator)


def _count(p: fmpq_mpoly) -> fmpq:
    """Return the number of negative coefficients."""
    return fmpq(sum(1 for c in p.coeffs() if c < 0))


def _share(p: fmpq_mpoly) -> fmpq:
    """Return the share of the negative coefficients in the sum of all absolute values."""
    total = sum((abs(c) for c in p.coeffs()), fmpq(0))
    return sum((-c for c in p.coeffs() if c < 0), fmpq(0)) / total if total else fmpq(0)


def _sum(p: fmpq_mpoly) -> fmpq:
    """Return the sum of the negative coefficients."""
    return sum((-c for c in p.coeffs() if c < 0), fmpq(0))


Weight = Callable[[fmpq_mpoly], fmpq]
WEIGHTS: tuple[Weight, ...] = (_count, _share, _sum)


def _tree(
    coordinates: tuple[Expr, ...], p: fmpq_mpoly, weight: Weight, leaves: list[int], depth: int = 0
) -> Leaf | Fork | None:
    if leaves[0] <= 0:
        return None
    if _count(p) == 0:
        leaves[0] -= 1
        return Leaf(coordinates, p)
    if depth == MAX_DEPTH or _fails_at_vertex(p):
        return None
    gens = p.context().gens()
    best: tuple[fmpq, int, int, fmpq_mpoly, fmpq_mpoly] | None = None
    for i, j in _pairs_of_negative(p):
        ups = list(gens)
        ups[j] = gens[i] + gens[j]
        downs = list(gens)
        downs[i] = gens[i] + gens[j]
        one, other = p.compose(*ups), p.compose(*downs)
        left = weight(one) + weight(other)
        if best is None or left < best[0]:
            best = (left, i, j, one, other)
    if best is None:
        return None
    _, i, j, one, other = best
    x, y = coordinates[i], coordinates[j]
    first = list(coordinates)
    first[j] = _difference(y, x)
    branch = _tree(tuple(first), one, weight, leaves, depth + 1)
    if branch is None:
        return None
    second = list(coordinates)
    second[i] = _difference(x, y)
    other_branch = _tree(tuple(second), other, weight, leaves, depth + 1)
    return None if other_branch is None else Fork(x, y, branch, other_branch)


def _fails_at_vertex(p: fmpq_mpoly) -> bool:
    """Return whether the polynomial is negative on an axis, so that no comparison can help."""
    return any(c < 0 and sum(1 for n in m if n) == 1 for m, c in p.to_dict().items())


def _pairs_of_negative(p: fmpq_mpoly) -> list[tuple[int, int]]:
    """Return pairs of coordinates in terms with negative coefficients."""
    found: dict[tuple[int, int], None] = {}
    for m, c in p.to_dict().items():
        if c < 0:
            for pair in combinations([k for k, n in enumerate(m) if n], 2):
                found[pair] = None
    return list(found)


def _difference(x: Expr, y: Expr) -> Expr:
    return as_expression(expanded(x - y))


def _lines(top: Expr, tree: Leaf | Fork) -> list[str]:
    if isinstance(tree, Fork):
        one, other = term(tree.one), term(tree.other)
        less, more = _difference(tree.other, tree.one), _difference(tree.one, tree.other)
        return [
            f"destruct (Rle_or_lt ({one}) ({other})).",
            "{ " + f"assert (0 <= {term(less)}) by lra.",
            *_lines(top, tree.first),
            "}",
            "{ " + f"assert (0 <= {term(more)}) by lra.",
            *_lines(top, tree.second),
            "}",
        ]
    parts = [
        multiply_raw(
            Fraction(int(c.p), int(c.q)),
            [(tree.coordinates[k], int(n)) for k, n in enumerate(m) if n],
        )
        for m, c in tree.value.to_dict().items()
    ]
    text = " + ".join(parts) or "0"
    return [f"replace ({term(top)}) with ({text}) by (first [ring | field]); cone."]


def multiply_raw(c: Fraction, factors: Sequence[tuple[Expr, int]]) -> str:
    """Return a product of powers as text, without simplification."""
    powers = [term(e, 3) if n == 1 else f"{term(e, 3)} ^ {n}" for e, n in factors if e != ONE]
    return " * ".join([term(number(c), 3), *powers])
