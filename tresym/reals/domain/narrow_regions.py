"""Find points of conditions that hold only far away or on narrow sets.

Polynomials divide space into regions, each with a sample point (see
:mod:`tresym.reals.domain.cylindrical_decomposition`). From these points, and from a few others, a
pattern search climbs until every condition holds. Its score counts the conditions that hold first,
and then by how much the others fail.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from math import prod
from typing import Any

from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz_mpoly_ctx, fmpz_poly

from tresym.reals.domain.cylindrical_decomposition import between, sample_points
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.sample_points import ExactPoint
from tresym.reals.language.expression import UNWORKED, Expr, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.factoring import TooLargeError

MAX_NAMES = 2
MAX_DEGREE = 12
MAX_CELLS = 40
MAX_EVALUATIONS = 300
MAX_CLIMBS = 6
SMALLEST_STEP, COARSE = fmpq(1, 2**60), fmpq(1, 2**16)
BESIDE = tuple(fmpq(sign, 2**k) for k in (4, 12, 24, 48, 96) for sign in (1, -1))


def windows(conditions: Sequence[Expr], starts: Sequence[ExactPoint]) -> Iterator[ExactPoint]:
    """Yield candidate points inside the conditions; the caller checks them.

    Args:
        conditions: expressions that shall be positive.
        starts: points from which the search also starts.
    """
    names = sorted(starts[0])
    centres = list(islice(_of_regions(conditions, names, starts[0]), MAX_CELLS))
    yield from centres
    axes = [{name: way} for name in names for way in (1, -1)]
    score, enough = partial(_score, conditions), (len(conditions), 0)
    for centre in [*centres, *starts][:MAX_CLIMBS]:
        point = climbed(score, centre, axes, SMALLEST_STEP, enough)
        yield point
        for name in names:
            for step in BESIDE:
                yield point | {name: point[name] + step}


def _of_regions(
    conditions: Sequence[Expr], names: list[str], other: ExactPoint
) -> Iterator[ExactPoint]:
    """Yield a point of every region between the zeros of the polynomials in the conditions."""
    context = fmpq_mpoly_ctx.get(tuple(names), Ordering.lex)
    found = dict(part for e in conditions for part in _polynomials(e, context))
    used = sorted(frozenset().union(*map(symbols, found)))
    if not 0 < len(used) <= MAX_NAMES or sum(p.total_degree() for p in found.values()) > MAX_DEGREE:
        return
    try:
        for values in _values(list(found.values()), [names.index(name) for name in used], used):
            yield other | dict(zip(used, values, strict=True))
    except TooLargeError:
        return


def _values(
    polynomials: list[fmpq_mpoly], places: list[int], used: list[str]
) -> Iterable[tuple[fmpq, ...]]:
    """Return sample points in the variables at these positions."""
    terms = [_whole(p, places) for p in polynomials]
    if len(used) > 1:
        ring = fmpz_mpoly_ctx.get(tuple(used), Ordering.lex)
        return sample_points([ring.from_dict(part) for part in terms], ring)
    line = fmpz_poly([1])
    for part in terms:
        line *= fmpz_poly([part.get((k,), 0) for k in range(max(part)[0] + 1)])
    return [(value,) for value in between(line)]


def _whole(p: fmpq_mpoly, places: list[int]) -> dict[tuple[int, ...], int]:
    """Return the terms of ``p`` in some of its variables, with denominators cleared."""
    scale = prod(int(c.q) for c in p.coeffs())
    return {tuple(int(m[k]) for k in places): int((c * scale).p) for m, c in p.terms()}


def _polynomials(e: Expr, context: fmpq_mpoly_ctx) -> Iterator[tuple[Expr, fmpq_mpoly]]:
    """Yield the largest polynomial parts of ``e``, at whose zeros its behaviour may change."""
    p = _polynomial(e, context)
    if p is None:
        for arg in () if e.op in UNWORKED else e.args:
            yield from _polynomials(arg, context)
    elif symbols(e) and not p.is_zero():
        yield e, p


def _polynomial(e: Expr, context: fmpq_mpoly_ctx) -> fmpq_mpoly | None:
    """Return ``e`` as a rational polynomial, or None if it is not one of low degree."""
    if e.op == "number":
        return context.constant(e.args[0])
    if e.op == "symbol":
        return context.gen(context.variable_to_index(e.args[0]))
    if e.op == "^":
        base, exponent = e.args
        n = exponent.args[0] if exponent.op == "number" else fmpq(-1)
        inner = _polynomial(base, context) if n.q == 1 and n > 0 else None
        if inner is None or inner.total_degree() * n > MAX_DEGREE:
            return None
        return inner ** int(n.p)
    parts = [_polynomial(arg, context) for arg in e.args] if e.op in ("+", "*") else [None]
    total = parts[0]
    for part in parts[1:]:
        if total is None or part is None or total.total_degree() > MAX_DEGREE:
            return None
        total = total + part if e.op == "+" else total * part
    return total


def climbed(
    score: Callable[[ExactPoint], Any],
    start: ExactPoint,
    directions: Sequence[Mapping[str, int]],
    smallest: fmpq,
    enough: Any = None,
) -> ExactPoint:
    """Return a local maximum of the score by pattern search, or a point with score ``enough``.

    Args:
        score: the function that is maximised; None where it is undefined.
        start: the starting point.
        directions: the directions of the steps.
        smallest: the smallest step.
        enough: a score at which the search stops.
    """
    here, best, step, left = start, score(start), fmpq(1), MAX_EVALUATIONS
    while best is not None and best != enough and step > smallest and left > 0:
        if here is start and step < COARSE:
            break  # no step near the start increases the score
        better = False
        for direction in directions:
            there = {name: x + step * direction.get(name, 0) for name, x in here.items()}
            found = score(there)
            left -= 1
            if found is not None and found > best:
                here, best, better = there, found, True
        step = step * 2 if better else step / 4
    return here


def _score(conditions: Sequence[Expr], point: ExactPoint) -> tuple[int, float]:
    """Return how many conditions hold, and by how much the others fail."""
    with ball_precision():
        known: dict[Expr, arb] = {}
        values = [evaluate(e, point, known) for e in conditions]
        failing = [float(v.mid()) for v in values if v.is_finite() and not v > 0]
        return sum(bool(v > 0) for v in values), sum(failing)
