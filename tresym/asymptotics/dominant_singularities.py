"""The singularities of a function of z that are nearest to 0, with a proof that none is nearer.

Example: (1 − √(1 − 4z))/(2z) is analytic at 0, and has its nearest singularity at z = 1/4.

A function that is built from z by sums, products, powers, exp, sin, cos, sinh, cosh and logarithms
is continued analytically from 0 along every path on which no denominator, no base of a fractional
power and no argument of a logarithm vanishes. So its singularities are among the zeros of these
*parts*. Those of a polynomial are isolated exactly. Where a part contains square roots of
polynomials, the product of the part over all signs of the roots is a rational function, and it is
seen by continuation in complex balls which of its zeros belong to the part. The zeros of an entire
part within |z| ≤ R are counted by the argument principle, in complex balls on the circle.

Source: P. Flajolet and R. Sedgewick, *Analytic Combinatorics*, 2009, chapters IV and VI.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

from flint import acb, arb, fmpq, fmpz_poly

from tresym.asymptotics.rational_functions import over
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import operations
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    apply,
    multiply,
    number,
    rebuild,
    replaced,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.polynomials import polynomial
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import sign

ENTIRE = frozenset(("exp", "sin", "cos", "sinh", "cosh"))
RADII = tuple(fmpq(k, 20) for k in (60, 56, 50, 40, 34, 30, 25, 22, 21))
"""Circles that are tried, relative to the nearest singularity."""
ARCS, DEEPEST, STEPS = 16, 8, 64
MOST_ROOTS, MOST_DEGREE = 2, 40


class UnsupportedError(Exception):
    """The function is of a kind that is not supported; the text says why."""


class Part(NamedTuple):
    """A denominator, or what has a fractional power or a logarithm.

    Attributes:
        e: the expression.
        branches: whether its zeros are branch points.
    """

    e: Expr
    branches: bool


class Singularity(NamedTuple):
    """A singularity on the real line.

    Attributes:
        point: where.
        pole: whether the function has no branch point there.
    """

    point: Expr
    pole: bool


class Nearest(NamedTuple):
    """The nearest singularities: one, or two at opposite points.

    Attributes:
        points: where they are; none if they are not real.
        radius: the function has no other singularity for |z| up to this radius, which is larger.
    """

    points: tuple[Singularity, ...]
    radius: fmpq


class _Zero(NamedTuple):
    place: acb
    exact: Expr | None
    branches: bool


def nearest_singularities(f: Expr, z: str) -> Nearest | None:
    """Return the nearest singularities of f; None where f is entire.

    Raises:
        UnsupportedError: they are not found.
    """
    if symbols(f) - {z}:
        raise UnsupportedError("generating functions without parameters are supported")
    parts = list(dict.fromkeys(_parts(f, z)))
    with ball_precision(128):
        _need_analytic_at_zero(f, z, parts)
        zeros: list[_Zero] = []
        entire: list[Part] = []
        for part in parts:
            found = _zeros_of_part(part, z)
            if found is None:
                entire.append(part)
                found = [
                    _Zero(acb(evaluate(e, {})), e, part.branches) for e in _real_zeros(part.e, z)
                ]
            zeros += found
        zeros = [x for x in zeros if x.exact is None or not is_zero(x.exact, Given())]
        if not zeros:
            return _disc(None, entire, z) if entire else None
        return _nearest(zeros, entire, z)


def _parts(e: Expr, z: str, inside: bool = False) -> Iterator[Part]:
    """Yield the parts of ``e``; inside of a logarithm or root, poles too are branch points."""
    if e.op in LEAVES or z not in symbols(e):
        return
    branches = inside
    if e.op == "^":
        base, exponent = e.args
        if exponent.op == "number" and z in symbols(base):
            branches = inside or bool(exponent.args[0].q != 1)
            if branches or exponent.args[0] < 0:
                yield Part(base, branches)
        elif z in symbols(base) or sign(base, Given()) != "+":
            raise UnsupportedError(f"{e} is not supported")
    elif e.op == "log":
        branches = True
        yield Part(e.args[0], True)
    elif e.op in ("tan", "sec"):
        yield Part(Expr("cos", e.args), inside)
    elif e.op in ("cot", "csc"):
        yield Part(Expr("sin", e.args), inside)
    elif e.op not in ENTIRE | {"+", "*"}:
        raise UnsupportedError(f"{e} is not supported in a generating function")
    for arg in e.args:
        yield from _parts(arg, z, branches)


def _arguments(e: Expr, z: str) -> Iterator[Expr]:
    """Yield arguments of functions that have an essential singularity where these have a pole."""
    if e.op in LEAVES or z not in symbols(e):
        return
    if e.op in ENTIRE | {"tan", "sec", "cot", "csc"}:
        yield e.args[0]
    elif e.op == "^" and z in symbols(e.args[1]):
        yield e.args[1]
    for arg in e.args:
        yield from _arguments(arg, z)


def stays_regular(f: Expr, z: str, point: Expr) -> bool:
    """Return whether what stands in exponentials, sines and the like is finite at a singularity."""
    side = -1 if sign(point, Given()) == "+" else 1
    for e in _arguments(f, z):
        there = limit_of(e, z, point, side, Given())
        if there is None or there in (INFINITY, -INFINITY):
            return False
    return True


def _need_analytic_at_zero(f: Expr, z: str, parts: list[Part]) -> None:
    """Check that f has a Taylor series at 0, by finite limits of what is meromorphic there."""
    branching = [node.e for node in parts if node.branches and _is_branching(f, z, node.e)]
    for e in (*_arguments(f, z), *branching, f):
        at = [limit_of(e, z, ZERO, side, Given()) for side in (1, -1)]
        if None in at or {*at} & {INFINITY, -INFINITY} or at[0] is None or at[1] is None:
            raise UnsupportedError(f"{e} is not shown to be analytic at {z} = 0")
        if not is_zero(at[0] - at[1], Given()):
            raise UnsupportedError(f"{e} is not shown to be analytic at {z} = 0")
        if e in branching and sign(at[0], Given()) != "+":
            raise UnsupportedError(f"{e} must be positive at {z} = 0")


def _is_branching(f: Expr, z: str, part: Expr) -> bool:
    """Return whether a part is what a fractional power or a logarithm is taken of."""
    if f.op in LEAVES or z not in symbols(f):
        return False
    if f.op == "log" and f.args[0] == part:
        return True
    fractional = f.op == "^" and f.args[1].op == "number" and f.args[1].args[0].q != 1
    if fractional and f.args[0] == part:
        return True
    return any(_is_branching(arg, z, part) for arg in f.args)


# Zeros


def _zeros_of_part(part: Part, z: str) -> list[_Zero] | None:
    """Return all zeros of a part; None where it is entire and not algebraic."""
    e = part.e
    if any(op in ENTIRE | {"log", "tan", "cot", "sec", "csc"} for op in _operations(e)):
        if any(op in ("log", "tan", "cot", "sec", "csc") for op in _operations(e)):
            raise UnsupportedError(f"the zeros of {e} are not found")
        if not _is_entire(e, z):
            raise UnsupportedError(f"the zeros of {e} are not found")
        return None
    roots = list(dict.fromkeys(_roots(e, z)))
    if not roots:
        return [zero._replace(branches=part.branches) for zero in _of_polynomial(_numerator(e, z))]
    if len(roots) > MOST_ROOTS or any(polynomial(node.args[0]) is None for node in roots):
        raise UnsupportedError(f"the zeros of {e} are not found")
    # the numerator, a polynomial in z and the roots, times its values at the other signs
    marks = {r: symbol(f"[{k}]") for k, r in enumerate(roots)}
    above, _ = over(in_lowest_terms(_with_marks(e, marks)))
    conjugates = []
    for signs in product((1, -1), repeat=len(roots)):
        pairs = zip(signs, marks.items(), strict=True)
        conjugates.append(substitute(above, {str(m.args[0]): s * r for s, (r, m) in pairs}))
    norm = multiply(ONE, *conjugates)
    found = []
    for zero in _of_polynomial(_numerator(norm, z)):
        value = _continued(e, z, zero.place)
        if value is None or value.contains(0):
            found.append(zero._replace(branches=part.branches))
    return found


def _operations(e: Expr) -> set[str]:
    if e.op in LEAVES:
        return set()
    return {e.op}.union(*(_operations(arg) for arg in e.args))


def _is_entire(e: Expr, z: str) -> bool:
    if e.op in LEAVES or z not in symbols(e):
        return True
    if e.op == "^":
        base, exponent = e.args
        if exponent.op == "number" and z in symbols(base):
            whole = exponent.args[0].q == 1 and exponent.args[0] > 0
            return bool(whole) and _is_entire(base, z)
        return z not in symbols(base) and _is_entire(exponent, z)
    return e.op in ENTIRE | {"+", "*"} and all(_is_entire(arg, z) for arg in e.args)


def _roots(e: Expr, z: str) -> Iterator[Expr]:
    """Yield the square roots in ``e``, refusing other fractional powers."""
    if e.op in LEAVES or z not in symbols(e):
        return
    if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q != 1:
        if e.args[1].args[0].q != 2:
            raise UnsupportedError(f"the zeros of {e} are not found")
        yield sqrt(e.args[0])
    for arg in e.args:
        yield from _roots(arg, z)


def _numerator(e: Expr, z: str) -> fmpz_poly:
    terms = polynomial(e) or polynomial(over(in_lowest_terms(e))[0])
    if terms is None or any(name != z for m in terms for name, _ in m):
        raise UnsupportedError(f"the zeros of {e} are not found")
    degree = max((dict(m).get(z, 0) for m in terms), default=0)
    if degree > MOST_DEGREE or not terms:
        raise UnsupportedError(f"the zeros of {e} are not found")
    scale = 1
    for c in terms.values():
        scale *= int(c.q)
    coefficients = [0] * (degree + 1)
    for m, c in terms.items():
        coefficients[dict(m).get(z, 0)] = int((c * scale).p)
    return fmpz_poly(coefficients)


def _of_polynomial(p: fmpz_poly) -> list[_Zero]:
    """Return all zeros of a polynomial, those of real factors of degree 1 and 2 exactly."""
    found = []
    for factor, _ in p.factor()[1]:
        a = [fmpq(int(factor[k])) for k in range(factor.degree() + 1)]
        exact: list[Expr] = []
        if len(a) == 2:
            exact = [number(-a[0] / a[1])]
        elif len(a) == 3 and a[1] * a[1] > 4 * a[0] * a[2]:
            inside = sqrt(number(a[1] * a[1] - 4 * a[0] * a[2]))
            exact = [(number(-a[1]) + s * inside) / number(2 * a[2]) for s in (1, -1)]
        if exact:
            found += [_Zero(acb(evaluate(e, {})), e, False) for e in exact]
        else:
            found += [_Zero(place, None, False) for place, _ in factor.complex_roots()]
    return found


def _real_zeros(e: Expr, z: str) -> list[Expr]:
    """Return some real zeros exactly."""
    found = dict.fromkeys(_of_exponential(e, z))
    for k in (1, 2, 3):
        for share in (PI / (2 * k), PI / k, k * PI):
            for point in (share, -share):
                if is_zero(substitute(e, {z: point}), Given()):
                    found[point] = None
    if is_zero(substitute(e, {z: ZERO}), Given()):
        found[ZERO] = None
    different: list[Expr] = []
    for point in found:
        if not symbols(point) and not any(is_zero(point - x, Given()) for x in different):
            different.append(point)
    return different


def _of_exponential(e: Expr, z: str) -> Iterator[Expr]:
    """Yield the real zeros of A + B exp(a z + b)."""
    nodes = {node for node in operations((e,)) if node.op == "exp" and z in symbols(node)}
    if len(nodes) != 1:
        return
    (node,) = nodes
    mark = symbol("[e]")
    terms = polynomial(replaced(e, {node: mark})) or {}
    line = polynomial(node.args[0]) or {}
    if set(terms) != {(), (("[e]", 1),)} or not set(line) <= {(), ((z, 1),)}:
        return
    value = -terms[()] / terms[("[e]", 1),]
    if value > 0:
        yield (apply("log", number(value)) - number(line.get((), fmpq(0)))) / number(line[(z, 1),])


def _nearest(zeros: list[_Zero], entire: list[Part], z: str) -> Nearest:
    closest = min(zeros, key=lambda zero: float(abs(zero.place)))
    rho = abs(closest.place)
    own = [zero for zero in zeros if not (abs(zero.place) > rho or abs(zero.place) < rho)]
    others = [abs(zero.place) for zero in zeros if abs(zero.place) > rho]
    if len(own) + len(others) != len(zeros):
        raise UnsupportedError("the nearest singularity is not found")
    points: list[Singularity] = []
    for zero in own:
        if zero.exact is None:  # they are not real, or of high degree
            return _disc(_below(rho), entire, z)
        same = [k for k, p in enumerate(points) if is_zero(p.point - zero.exact, Given())]
        if same:
            old = points[same[0]]
            points[same[0]] = old._replace(pole=old.pole and not zero.branches)
        else:
            points.append(Singularity(zero.exact, not zero.branches))
    if len(points) > 2 or (
        len(points) == 2 and not is_zero(points[0].point + points[1].point, Given())
    ):
        raise UnsupportedError("the nearest singularity is not found")
    beyond = min((_below(x) for x in others), default=None)
    radii = [_below(rho) * r for r in RADII]
    if beyond is not None:
        radii = [(_below(rho) + beyond) / 2, *radii]
        radii = [r for r in radii if r < beyond]
    for radius in radii:
        if rho < radius and all(_no_others(part, z, radius) for part in entire):
            return Nearest(tuple(points), radius)
    raise UnsupportedError("other singularities are not excluded")


def _disc(limit: fmpq | None, entire: list[Part], z: str) -> Nearest:
    """Return a disc without singularities that is about as large as possible.

    Args:
        limit: where other singularities lie, if anywhere.
        entire: parts whose zeros are not known.
        z: the variable.
    """

    def is_free(radius: fmpq) -> bool:
        return all(_no_others(part, z, radius) for part in entire)

    if limit is not None and is_free(limit * fmpq(4095, 4096)):
        return Nearest((), limit * fmpq(4095, 4096))
    radius = fmpq(64) if limit is None else limit
    for _ in range(16):
        radius = radius / 2
        if is_free(radius):
            break
    else:
        raise UnsupportedError("no disc without singularities is found")
    low, high = radius, radius * 2
    for _ in range(8):
        middle = (low + high) / 2
        low, high = (middle, high) if is_free(middle) else (low, middle)
    return Nearest((), low)


def _below(x: arb) -> fmpq:
    """Return a rational at most ``x``, close to it."""
    found = (x.lower() * 2**30).floor().lower().unique_fmpz()
    if found is None or found <= 0:
        raise UnsupportedError("a singularity is not told from 0")
    return fmpq(int(found), 2**30)


def _no_others(part: Part, z: str, radius: fmpq) -> bool:
    """Return whether all zeros of an entire part up to the radius are known real simple ones."""
    count = _winding(part.e, z, radius)
    known = 0
    for e in _real_zeros(part.e, z):
        place = abs(evaluate(e, {}))
        if not (place < radius or place > radius):
            return False
        if place < radius:
            known += 1
    return count == known


def _winding(e: Expr, z: str, radius: fmpq) -> int | None:
    """Return the number of zeros of an entire function inside a circle, with multiplicity."""
    total = arb(0)
    arcs = [(fmpq(k, ARCS), fmpq(k + 1, ARCS), 0) for k in range(ARCS)]
    while arcs:
        low, high, depth = arcs.pop()
        middle = (arb(low) + arb(high)) / 2
        turn = middle + (arb(high) - arb(low)) / 2 * arb(0, 1)
        whole = complex_value(e, {z: acb(radius) * _unit(turn)})
        first, last = (complex_value(e, {z: acb(radius) * _unit(arb(t))}) for t in (low, high))
        if whole is None or first is None or last is None:
            return None
        if first.contains(0) or not (whole / first).real > 0:
            if depth == DEEPEST:
                return None
            cut = (low + high) / 2
            arcs += [(low, cut, depth + 1), (cut, high, depth + 1)]
            continue
        total += (last / first).log().imag
    count = (total / (2 * arb.pi())).unique_fmpz()
    return None if count is None else int(count)


def _unit(turn: arb) -> acb:
    angle = 2 * arb.pi() * turn
    return acb(angle.cos(), angle.sin())


# Values in complex balls


def complex_value(e: Expr, values: dict[str, acb]) -> acb | None:
    """Return an enclosure of an entire or rational function at a complex ball, or None."""
    if e.op == "symbol":
        return values.get(str(e.args[0]))
    if not symbols(e):
        return acb(evaluate(e, {}))
    args = [complex_value(arg, values) for arg in e.args]
    known = [arg for arg in args if arg is not None]
    if len(known) < len(args):
        return None
    if e.op == "+":
        return sum(known, acb(0))
    if e.op == "*":
        result = acb(1)
        for arg in known:
            result *= arg
        return result
    if e.op == "^":
        exponent = e.args[1]
        if exponent.op == "number" and exponent.args[0].q == 1:
            return known[0] ** int(exponent.args[0].p)
        return (known[1] * known[0].log()).exp() if not symbols(e.args[0]) else None
    if e.op in ENTIRE:
        result = getattr(known[0], e.op)()
        return result if isinstance(result, acb) else None
    return None


def _continued(e: Expr, z: str, place: acb) -> acb | None:
    """Return the value at a point of the continuation of ``e`` along the segment from 0, or None.

    Square roots of polynomials w, positive at 0, are exp(log(w)/2), where log(w) is followed.
    """
    put: dict[Expr, Expr] = {}
    values = {z: place}
    for k, node in enumerate(dict.fromkeys(_roots(e, z))):
        w = node.args[0]
        log = acb(acb(evaluate(substitute(w, {z: ZERO}), {})).log())
        for step in range(STEPS):
            turn = arb(fmpq(2 * step + 1, 2 * STEPS)) + arb(fmpq(1, 2 * STEPS)) * arb(0, 1)
            first = complex_value(w, {z: place * arb(fmpq(step, STEPS))})
            last = complex_value(w, {z: place * arb(fmpq(step + 1, STEPS))})
            whole = complex_value(w, {z: place * turn})
            if whole is None or first is None or last is None:
                return None
            if first.contains(0) or not (whole / first).real > 0 or last.contains(0):
                return None
            log = acb(log + (last / first).log())
        put[node] = symbol(f"[{k}]")
        values[f"[{k}]"] = acb(log / 2).exp()
    return complex_value(_with_marks(e, put), values)


def _with_marks(e: Expr, put: dict[Expr, Expr]) -> Expr:
    """Return ``e`` with powers of the marks for powers of square roots."""
    if e.op in LEAVES:
        return e
    is_half = e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 2
    if is_half and sqrt(e.args[0]) in put:
        return put[sqrt(e.args[0])] ** int(e.args[1].args[0].p)
    return rebuild(e, tuple(_with_marks(arg, put) for arg in e.args))
