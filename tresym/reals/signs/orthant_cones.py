"""Prove the exact sign of a polynomial on an orthant, by cones on which all coefficients agree.

The difference of the two sides is written as a fraction of polynomials in the variables, or in
roots, exponentials and other functions whose ranges are known intervals. Möbius maps take every
range to [0, ∞). A polynomial without negative coefficients is not negative there. Otherwise the
orthant is cut into the n! cones on which the coordinates have a fixed order u ≤ v ≤ w. The
substitution u, v = u + v′, w = v + w′ maps each cone to a whole orthant, and the test is repeated.
All arithmetic is exact. Points of equality where the coordinates have rational ratios, such as a =
b = c, come to lie on an edge of a cone and do no harm.

The subdivision is that of successive difference substitution (L. Yang, 2005).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations, islice, pairwise, permutations, product
from math import factorial, gcd

from flint import Ordering, fmpq, fmpz, fmpz_mpoly, fmpz_mpoly_ctx

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.sample_points import Range
from tresym.reals.language.expression import Expr
from tresym.reals.normal.field import Field
from tresym.reals.normal.moebius import on_orthant
from tresym.reals.normal.ring import Poly, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import Ask, without_powers

MAX_VARIABLES = 4
MAX_CONES = {2: 40, 3: 80, 4: 160, 5: 480}
"""The maximal number of cones, by the number of coordinates."""
MAX_CHARTS = 16


def sign_on_cones(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Cones: the coefficients of a polynomial have one sign on every cone of a cover of the region.

    On a cone the variables, or roots and exponentials of them, have a fixed order. Equality at
    points with rational ratios, such as ``a = b = c``, is allowed.

    Decides ``a/(b + c) + b/(a + c) + c/(a + b) >= 3/2 given a > 0, b > 0, c > 0``.

    Limits: at most four variables are allowed, and equality at other points makes the method
    fail.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        region: conditions that hold wherever the claim speaks, strictly at one point at least.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
    """
    strict = relation != ">="
    try:
        field = Field(region)
        value, *others = field.normal(difference, *(c.expression for c in region.beyond_box))
        if value.num.is_zero():
            return None
        if strict and any(generator.kind != "symbol" for generator in field.generators):
            return None  # the normal form proves nothing at isolated points
        sign, rest = open_factors(field, (value.num, value.den), strict)
        conditions = [
            (other.num, condition.relation)
            for condition, other in zip(region.beyond_box, others, strict=True)
            if other.den.is_one()
            or (other.den.is_constant() and other.den.leading_coefficient() > 0)
        ]
        ways = (1, -1) if relation == "!=" else (sign,)
        count = _count(field, rest, conditions, strict, ways)
    except (TooLargeError, UndefinedError):
        return None
    if count is None:
        return None
    return f"the difference has coefficients of one sign on {count} cones that cover the region"


def open_factors(field: Field, polys: tuple[Poly, Poly], strict: bool) -> tuple[int, Poly]:
    """Return the known sign of a product, and the product of the factors whose sign is not known.

    Args:
        field: the ring of the polynomials.
        polys: the numerator and the denominator.
        strict: whether the claim excludes that a factor vanishes; if so, even powers are kept.
    """
    sign, rest = 1, field.one_poly
    for p in polys:
        content, factors = field.factor(without_powers(field, p))
        sign *= 1 if content > 0 else -1
        for factor, multiplicity in factors:
            known = 0 if strict else field.sign(factor)
            if multiplicity % 2:
                sign *= known or 1
            if not known and (strict or multiplicity % 2):
                rest = rest * factor ** (1 if multiplicity % 2 else 2)
    return sign, rest


@dataclass(frozen=True)
class _Cone:
    """Represent a cone as an orthant, in coordinates of which the original ones are sums.

    Attributes:
        target: the polynomial whose sign is sought.
        conditions: polynomials that are positive at the points of interest.
        rows: for each original coordinate that is positive there, the new ones it is a sum of.
    """

    target: fmpz_mpoly
    conditions: tuple[fmpz_mpoly, ...]
    rows: tuple[frozenset[int], ...]


def _count(
    field: Field,
    p: Poly,
    conditions: list[tuple[Poly, str]],
    strict: bool,
    ways: tuple[int, ...],
) -> int | None:
    """Return the number of cones on which ``p`` is proved to have one of the signs; None if it
    fails.
    """
    used = field.used(p)
    kept = [q for q, relation in conditions if _excludes(q, relation, strict)]
    wider = sorted({i for q in (p, *kept) for i in field.used(q)})
    if len(wider) <= MAX_VARIABLES and all(field.at(i).kind == "symbol" for i in wider):
        used = wider
    else:
        kept = []
    if len(used) > MAX_VARIABLES:
        return None
    sides = [_sides(field, i, bool(kept)) for i in used]
    if kept:
        kept += _upper_ends(field, used, sides, strict)
    charts = list(islice(product(*sides), MAX_CHARTS + 1))
    bounded = any(None not in side for chart in charts for side in chart)
    if len(charts) > MAX_CHARTS or (strict and bounded):
        return None  # where two variables are infinite, a limit proves no strict inequality
    for sign in ways:
        count = 0
        for chart in charts:
            cones = _proved(_mapped([p * sign, *kept], used, chart), strict)
            if cones is None:
                break
            count += cones
        else:
            return count
    return None


def _excludes(q: Poly, relation: str, strict: bool) -> bool:
    """Return whether a cone on which ``q`` is nowhere positive may be omitted.

    For a claim that allows equality, half-spaces may be closed. A region of half-spaces and open
    sets that has an interior point is the closure of its interior, to which the claim extends by
    continuity.
    """
    return relation == ">" or (relation == ">=" and not strict and q.total_degree() == 1)


Side = tuple[fmpq | None, fmpq | None, bool]
"""The ends of a range, one of which may be infinite, and whether the end that becomes 0 is open."""


def _sides(field: Field, position: int, one_ended: bool) -> list[Side]:
    """Return the range of a generator, or its two halves; only the lower end if ``one_ended``."""
    generator = field.at(position)
    low, high = field.ends(position)
    is_open = False
    if generator.kind == "symbol":
        where = field.given.box.get(generator.data[0], Range())
        low, high = where.low, where.high
        is_open = where.low_open if low is not None else where.high_open
    if low is None and high is None:
        return [(fmpq(0), None, False), (None, fmpq(0), False)]
    return [(low, None if one_ended and low is not None else high, is_open)]


def _upper_ends(field: Field, used: list[int], sides: list[list[Side]], strict: bool) -> list[Poly]:
    """Return ``high − x`` for every range with two ends, as a condition in place of that end."""
    found = []
    for i in used:
        where = field.given.box.get(field.at(i).data[0], Range())
        if where.low is not None and where.high is not None and (where.high_open or not strict):
            found.append(where.high.p - where.high.q * field.variables[i])
    return found


def _mapped(polys: list[Poly], used: list[int], chart: tuple[Side, ...]) -> _Cone:
    """Return the first cone: ranges are mapped to [0, ∞), and the polynomials homogenised."""
    last = len(used)
    context = fmpz_mpoly_ctx.get([f"u{i}" for i in range(last + 1)], Ordering.lex)
    moved = _without_common_powers([_moved(q, used, chart, context) for q in polys], context)
    homogeneous = all(len({sum(map(int, m)) for m in q.monoms()}) <= 1 for q in moved)
    if not homogeneous:
        moved = [_homogenised(q, last, context) for q in moved]
    rows = [frozenset((i,)) for i, (_, _, is_open) in enumerate(chart) if is_open]
    rows += [] if homogeneous else [frozenset((last,))]
    return _Cone(moved[0], tuple(moved[1:]), tuple(rows))


def _moved(
    p: Poly, used: list[int], chart: tuple[Side, ...], context: fmpz_mpoly_ctx
) -> fmpz_mpoly:
    """Return ``p`` times a positive factor, in coordinates that range over [0, ∞)."""
    result = context.from_dict({(*(int(m[i]) for i in used), 0): c for m, c in p.terms()})
    for i, (low, high, _) in enumerate(chart):
        result = on_orthant(result, i, low, high)
    return result


def _without_common_powers(moved: list[fmpz_mpoly], context: fmpz_mpoly_ctx) -> list[fmpz_mpoly]:
    """Replace a coordinate that occurs only in g-th powers by that power."""
    width = context.nvars()
    steps = [gcd(*(int(m[i]) for q in moved for m in q.monoms())) or 1 for i in range(width)]
    return [
        context.from_dict(
            {tuple(int(k) // g for k, g in zip(m, steps, strict=True)): c for m, c in q.terms()}
        )
        for q in moved
    ]


def _homogenised(q: fmpz_mpoly, last: int, context: fmpz_mpoly_ctx) -> fmpz_mpoly:
    """Homogenise ``q`` with the last coordinate."""
    degree = int(q.total_degree())
    return context.from_dict(
        {(*map(int, m[:last]), degree - sum(map(int, m[:last]))): c for m, c in q.terms()}
    )


def _proved(start: _Cone, strict: bool) -> int | None:
    """Return the number of cones that prove the claim, or None."""
    stack, count = [start], 0
    most = MAX_CONES.get(start.target.context().nvars(), 0)
    while stack:
        cone = stack.pop()
        count += 1
        if any(all(c <= 0 for c in q.coeffs()) for q in cone.conditions):
            continue
        if all(c >= 0 for c in cone.target.coeffs()):
            if strict and not _vanishes_nowhere(cone):
                return None
            continue
        if _fails_at_vertex(cone) or count + len(stack) + factorial(len(_used(cone))) > most:
            return None
        stack.extend(_parts(cone))
    return count


def _fails_at_vertex(cone: _Cone) -> bool:
    """Return whether the polynomial is negative on an edge where all conditions hold."""
    width = cone.target.context().nvars()
    for i in range(width):
        unit = tuple(int(j == i) for j in range(width))
        ends = [_at(q, unit) for q in (cone.target, *cone.conditions)]
        if ends[0] < 0 and all(end > 0 for end in ends[1:]):
            return True
    return False


def _at(q: fmpz_mpoly, unit: tuple[int, ...]) -> fmpz:
    """Return the coefficient of the pure power of highest degree in one coordinate."""
    degree = 0 if q.is_zero() else int(q.total_degree())
    return fmpz(q[tuple(k * degree for k in unit)])


def _vanishes_nowhere(cone: _Cone) -> bool:
    """Return whether a polynomial without negative coefficients is positive wherever the rows are.

    Every face that the rows allow, given by the coordinates that are positive there, must retain a
    term.
    """
    width = cone.target.context().nvars()
    supports = [frozenset(i for i in range(width) if m[i]) for m in cone.target.monoms()]
    for size in range(1, width + 1):
        for face in map(frozenset, combinations(range(width), size)):
            if all(row & face for row in cone.rows) and not any(s <= face for s in supports):
                return False
    return True


def _used(cone: _Cone) -> list[int]:
    """Return the coordinates that occur."""
    degrees = [q.degrees() for q in (cone.target, *cone.conditions)]
    return [i for i, powers in enumerate(zip(*degrees, strict=True)) if max(powers) > 0]


def _parts(cone: _Cone) -> list[_Cone]:
    """Return one cone for each order of the coordinates: each is the previous one plus a rest."""
    polys = (cone.target, *cone.conditions)
    gens = cone.target.context().gens()
    found = []
    for order in permutations(_used(cone)):
        sums = list(gens)
        for before, after in pairwise(order):
            sums[after] = sums[before] + gens[after]
        sources = {i: frozenset(order[: k + 1]) for k, i in enumerate(order)}
        rows = tuple(frozenset().union(*(sources.get(i, {i}) for i in row)) for row in cone.rows)
        target, *conditions = (q.compose(*sums) for q in polys)
        found.append(_Cone(target, tuple(conditions), rows))
    return found
