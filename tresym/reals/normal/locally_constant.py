"""Prove identities between inverse functions by a zero derivative and one value per region.

The difference of the two sides is analytic except at its singularities: zeros of denominators, of
radicands, of arguments of logarithms, and so on. Where its gradient vanishes identically, it is
constant on each connected region between them. The singularities that can change sign must be
polynomials in the symbols. A cylindrical decomposition then gives an exact point of every region,
and the difference is decided exactly at that point.

The singular sets, called walls in this module, are found from the normal form. This needs care:
where a generator jumps or is infinite, a singularity may vanish although no factor of its normal
form does. So each operation that can hide zeros adds walls of its own, or is shown to be harmless
under the conditions:

- t = tan(u/2) is infinite where u is an odd multiple of π, and 1 + cos u = 2/(1 + t²) vanishes
  there. Either the conditions exclude such values of u, or the leading coefficient in t shows that
  there is no zero. The latter does not help for a t inside another generator, as in log(3 + t²) −
  log(1 + t²).
- A sign σ_f, which comes from abs, from even roots and from atan u = ±π/2 − atan(1/u), jumps where
  f is 0. The cases f > 0 and f < 0 do not cover these points, so the zeros of f are walls.
- log|f|, a root of |f|, and exp, atan, cos and sin of a fraction are defined only off the zeros of
  f and of the denominator. These may cancel in the expression but not in the generators, so they
  are walls.
- A sum of squares may vanish at single points without changing its sign, and such a point divides a
  line. So a factor is omitted from the walls only if it is shown to be nonzero at every point.
- The conditions themselves may have singularities, which are walls like those of the sides.

If the only walls are bounds of single variables, the region is convex and one point is enough. An
irrational bound, such as x < π/2, is not a rational polynomial. With one variable, the line is then
cut at rational points on both sides of the bound, so close that no wall lies between them.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import Ordering, arb, fmpq, fmpz_mpoly, fmpz_mpoly_ctx

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.cylindrical_decomposition import sample_points
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import singularities
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import PI, Expr, number, substitute, symbols
from tresym.reals.normal.constants import settled, vanishes
from tresym.reals.normal.factors import factor_fraction, factor_polynomial
from tresym.reals.normal.field import Field
from tresym.reals.normal.polynomials import terms_in_symbols
from tresym.reals.normal.ring import Fraction, Poly, UndefinedError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import Interval, near, rational_ends
from tresym.reals.numbers.factoring import TooLargeError

MAX_POINTS = 400
MAX_SYMBOLS = 4


def equal_by_derivative(
    left: Expr, right: Expr, given: Given, theories: frozenset[str], size: int
) -> str | None:
    """Prove that two sides are equal, by equal derivatives and one exact value in each region.

    Args:
        left: one side.
        right: the other side.
        given: the conditions.
        theories: the function families that the normal form interprets.
        size: the maximal number of generators.

    Returns:
        A sentence that names the base points, or None if this gives no proof.

    Raises:
        TooLargeError: a normal form or the number of regions is too large.
        UndefinedError: a normal form is nowhere defined.
    """
    names = sorted(symbols(left) | symbols(right) | given.names)
    if not 0 < len(names) <= MAX_SYMBOLS:
        return None
    field = Field(given, theories, size)
    gradient = []
    for name in names:
        slopes = [differentiate(side, name) for side in (left, right)]
        gradient += slopes
        *_, dx, dy = field.normal(left, right, *slopes)
        if not vanishes(field.ring, (dx - dy).num):
            return None
    if any(generator.kind == "opaque" for generator in field.ring.generators):
        return None
    walls = _walls(left, right, given, field, names)
    if walls is None:
        return None
    bases = []
    for point in _candidates(walls, _loose_ends(left, right, given, field, names), given, names):
        inside = None if point is None else _inside(left, right, given, point)
        if inside is None or point is None:
            return None
        if inside:
            if not _are_real(gradient, point) or not _equal_at(left, right, point, theories):
                return None
            bases.append(point)
    if not bases:
        return None
    shown = "; ".join(
        ", ".join(f"{name} = {value}" for name, value in point.items()) for point in bases[:4]
    )
    return f"all derivatives of the difference have normal form 0, and it is exactly 0 at {shown}"


def _candidates(
    walls: list[fmpz_mpoly], ends: list[Expr], given: Given, names: list[str]
) -> Iterator[dict[str, Expr] | None]:
    """Yield a point of every region between the walls that extends inside ``ends``; None if it
    fails.
    """
    if not walls:
        simple = {name: _middle(given, name) for name in names}
        with ball_precision():
            at = {name: evaluate(value, {}) for name, value in simple.items()}
            inside = all(condition.holds(at) for condition in given.conditions)
        yield simple if inside else _as_numbers(next(given.points(names, 1), None))
        return
    gaps = []
    for end in ends:
        gap = _gap(end, names, walls)
        if gap is None:
            yield None
            return
        gaps.append(gap)
    context = walls[0].context()
    x = context.gens()[0]
    cuts = [x * int(cut.q) - int(cut.p) for gap in gaps for cut in gap]
    for count, values in enumerate(sample_points([*walls, *cuts], context)):
        if count == MAX_POINTS:
            yield None
            return
        if not any(low < values[0] < high for low, high in gaps):
            yield _as_numbers(dict(zip(names, values, strict=True)))


def _as_numbers(point: dict[str, fmpq] | None) -> dict[str, Expr] | None:
    return None if point is None else {name: number(value) for name, value in point.items()}


def _middle(given: Given, name: str) -> Expr:
    """Return 0, or a multiple of π in an interval whose ends are multiples of π."""
    turns = given.half_turns.get(name, Interval())
    if turns.low is None or turns.high is None or turns.low < 0 < turns.high:
        return number(0)
    return number(near(turns.middle, turns.width / 4)) * PI


def _loose_ends(
    left: Expr, right: Expr, given: Given, field: Field, names: list[str]
) -> list[Expr]:
    """Return the bounds of single variables that are not walls, as expressions x − c or c − x."""
    return [
        condition.expression
        for condition in given.conditions
        if condition not in given.beyond_box
        and any(
            _in_symbols(field, end, names) is None
            for end in _irreducible_factors(field, left, right, [condition.expression])
        )
    ]


def _gap(end: Expr, names: list[str], walls: list[fmpz_mpoly]) -> tuple[fmpq, fmpq] | None:
    """Return rational numbers on both sides of the zero of ``end``, without a wall between, or
    None.
    """
    if len(names) != 1:
        return None
    half = WORKING
    with ball_precision(2 * WORKING):
        at0, at1 = (evaluate(end, {names[0]: arb(x)}) for x in (0, 1))
        place = at0 / (at0 - at1) * (1 << half)
        below, above = rational_ends(place)[:2]
        if below is None or above is None:
            return None
        low, high = fmpq(below.floor() - 1, 1 << half), fmpq(above.ceil() + 1, 1 << half)
        between = arb(low).union(arb(high))
        for wall in walls:
            value = sum((arb(c) * between ** int(m[0]) for m, c in wall.terms()), arb(0))
            if value.contains(0) or not value.is_finite():
                return None
    return low, high


def _walls(
    left: Expr, right: Expr, given: Given, field: Field, names: list[str]
) -> list[fmpz_mpoly] | None:
    """Return the singularities that can change sign as polynomials in ``names``.

    Returns:
        The polynomials; an empty list if only bounds of single variables limit the region; None if
            some singularity is not such a polynomial.
    """
    expressions = [e for e, _ in [*singularities(left), *singularities(right)]]
    for condition in given.beyond_box:
        expressions += [condition.expression, *(e for e, _ in singularities(condition.expression))]
    walls = _zeros(left, right, expressions, field, names)
    if walls:
        for end in _irreducible_factors(
            field, left, right, [c.expression for c in given.conditions]
        ):
            wall = _in_symbols(field, end, names)
            if wall is not None:
                walls.append(wall)
    return walls


def _zeros(
    left: Expr, right: Expr, expressions: list[Expr], field: Field, names: list[str]
) -> list[fmpz_mpoly] | None:
    """Return polynomials whose zeros contain those of ``expressions`` on the common domain."""
    walls = []
    edges = _edges(field, field.normal(left, right, *expressions)[2:])
    if edges is None:
        return None
    for part in {
        str(p): p for p in [*_irreducible_factors(field, left, right, expressions), *edges]
    }.values():
        if part.is_constant() or field.signs.definite(part):
            continue
        for inner in _algebraic_walls(field, part) or [part]:
            if inner.is_constant() or field.signs.definite(inner):
                continue
            wall = _in_symbols(field, inner, names)
            if wall is None:
                return None
            walls.append(wall)
    return walls


def nonzero_inside(e: Expr, given: Given) -> bool:
    """Return whether ``e`` is shown to vanish nowhere inside the box of the conditions."""
    try:
        field = Field(given, size=64)
        return _zeros(e, e, [e], field, sorted(symbols(e))) == []
    except (TooLargeError, UndefinedError):
        return False


def _irreducible_factors(
    field: Field, left: Expr, right: Expr, expressions: list[Expr]
) -> list[Poly]:
    """Return the irreducible factors of ``expressions``, on the domain of both sides."""
    factors: dict[str, Poly] = {}
    for value in field.normal(left, right, *expressions)[2:]:
        factors |= {key: part for key, (part, _) in factor_fraction(field.ring, value)[1].items()}
    return list(factors.values())


def _edges(field: Field, values: list[Fraction]) -> list[Poly] | None:
    """Return polynomials off whose zeros the generators in ``values`` are continuous.

    None if one of the values may vanish where a half angle is π/2, or if this is not decided.
    """
    polynomials = [p for value in values for p in _at_poles(field, value)]
    for position in set().union(*map(field.ring.involved, values)):
        generator = field.ring.at(position)
        if generator.kind in ("root", "sign", "log"):
            polynomials.append(generator.data[0])
        elif generator.kind in ("exp", "tan", "cos", "sin", "atan"):
            polynomials.append(generator.data[-1].den)
    if any(p.is_zero() for p in polynomials):
        return None
    return [part for p in polynomials for part, _ in factor_polynomial(field.ring, p)[1]]


def _at_poles(field: Field, value: Fraction) -> list[Poly]:
    """Return polynomials that must not vanish, so that ``value`` is nonzero at infinite half
    tangents.

    The zero polynomial is returned if this cannot be decided.
    """
    used = field.ring.used(value)
    within = {j for i in used for p in field.ring.inside(i) for j in field.ring.involved(p)}
    leading = [value.num]
    for i in within.union(used):
        if (
            field.ring.at(i).kind != "tan"
            or not field.ring.support(i)
            or field.signs.has_no_pole(field.ring.at(i))
        ):
            continue
        n = int(value.num.degrees()[i])
        if i in within or value.den.degrees()[i] > n:
            return [field.ring.zero_poly]
        leading += [field.ring.split(p, i).get(n, field.ring.zero_poly) for p in leading]
    return leading[1:]


def _algebraic_walls(field: Field, p: Poly) -> list[Poly] | None:
    """Return polynomials without roots whose zeros contain those of ``p`` and of its radicands."""
    for position, _, rule in field.ring.relations:
        if p.degrees()[position] <= 0:
            continue
        if field.ring.at(position).kind not in ("root", "sign"):
            return None
        norm = p.resultant(rule, position)
        if norm.is_zero():
            return None
        walls = _algebraic_walls(field, norm)
        inner = _algebraic_walls(field, field.ring.at(position).data[0])
        if walls is None or inner is None:
            return None
        return [*walls, *inner]
    return [p]


def _in_symbols(field: Field, p: Poly, names: list[str]) -> fmpz_mpoly | None:
    """Return ``p`` as a polynomial in ``names`` alone, or None."""
    terms = terms_in_symbols(field.ring, p)
    if terms is None or not {name for powers in terms for name, _ in powers} <= set(names):
        return None
    context = fmpz_mpoly_ctx.get([f"v{i}" for i in range(len(names))], Ordering.lex)
    return context.from_dict(
        {tuple(dict(powers).get(name, 0) for name in names): c.p for powers, c in terms.items()}
    )


def _inside(left: Expr, right: Expr, given: Given, point: dict[str, Expr]) -> bool | None:
    """Return whether ``point`` satisfies ``given`` and both sides are defined there; None if
    unknown.
    """
    with ball_precision():
        at = {name: evaluate(value, {}) for name, value in point.items()}
        needed = [
            (condition.expression, condition.relation != "!=") for condition in given.conditions
        ]
        for e, positive in [*needed, *singularities(left), *singularities(right)]:
            value = evaluate(e, at)
            if positive and value < 0:
                return False
        values = [evaluate(left, at), evaluate(right, at)]
        conditions = all(condition.holds(at) for condition in given.conditions)
    return True if conditions and all(v.is_finite() for v in values) else None


def _are_real(slopes: list[Expr], point: dict[str, Expr]) -> bool:
    """Return whether every derivative has a value at ``point``, so that its normal form applies
    there.
    """
    with ball_precision():
        at = {name: evaluate(value, {}) for name, value in point.items()}
        return all(evaluate(slope, at).is_finite() for slope in slopes)


def _equal_at(left: Expr, right: Expr, point: dict[str, Expr], theories: frozenset[str]) -> bool:
    """Return whether both sides are exactly equal at ``point``."""
    return equal_constants(substitute(left, point), substitute(right, point), theories)


def equal_constants(left: Expr, right: Expr, theories: frozenset[str]) -> bool:
    """Return whether two expressions without symbols are proved to be equal."""
    field = Field(Given(), theories, 64)
    try:
        x, y = field.normal(left, right)
        return vanishes(field.ring, settled(field, x - y).num)
    except (TooLargeError, UndefinedError):
        return False
