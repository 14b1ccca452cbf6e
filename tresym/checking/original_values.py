"""Attack a claim about integrals or sums itself, by quadrature and summation at points of its path.

A lemma turns such a claim into obligations, and these are attacked where they are decided. This
module attacks the lemma: it computes both sides of the original claim at a few points, far from the
end as well, and compares them with the constant that was found, or looks whether what should tend
to 0 stays constant instead. Integrals are computed by FLINT in balls, piece by piece between
distances from the ends that are powers of 2; pieces nearer to an end or farther out than the last
are left out. So values are not enclosures, and only a clear contradiction counts: it turns the
answer into UNDECIDED, and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from flint import arb

from tresym.asymptotics.numerical_evidence import follows_a_law, quantity
from tresym.reals.cross_check import Program, program, said
from tresym.reals.language.binders import integral, outermost
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, opened, replaced, symbol, symbols
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision

BITS = 160
ORDERS = (10, 7, 4)
"""Binary orders of the distances at which a claim is looked at, the farthest first."""
NEAREST, FARTHEST = 100, 40
"""Up to 2^−100 of a length from a finite end, and up to 2^40 at infinity, pieces are added."""
SMALL = arb((1, -80))
"""What is smaller than this part of the sum ends it."""
CLEAR = arb("1.000001")
"""By how much a bound must be exceeded."""
NOISE = arb((1, -30))
"""What is smaller may be the error of the pieces that are left out."""
MOST_TERMS = 4000
At = Mapping[str, arb]


def has_numbers(*sides: Expr) -> bool:
    """Return whether there is an integral, a sum or a factorial to compute, and nothing else."""
    nodes = list(outermost(*sides))
    known = ("integral", "sum", "product")
    return bool(nodes) and all(
        node.op in known or (node.op == "unknown" and node.args[0].args[0] == FACTORIAL)
        for node in nodes
    )


def value(e: Expr, at: At) -> arb | None:
    """Return ``e`` at a point, about; None where it cannot be computed."""
    marks: dict[Expr, Expr] = {}
    known = dict(at)
    for n, node in enumerate(dict.fromkeys(outermost(e))):
        found = _node(node, at)
        if found is None:
            return None
        marks[node] = symbol(f"[{n}]")
        known[f"[{n}]"] = found
    names = sorted(known)
    computed = program([replaced(e, marks)], names)([known[name] for name in names])
    return None if computed is None else computed[0]


def _node(node: Expr, at: At) -> arb | None:
    if node.op == "unknown":
        n = value(node.args[1], at)
        return None if n is None or not n > -1 else (n + 1).gamma()
    (name,), body = opened(node, at)
    if body.hidden:
        return None
    ends = []
    for e in node.args[1:]:
        infinite = 1 if e == INFINITY else -1 if e == -INFINITY else 0
        ends.append(arb.pos_inf() * infinite if infinite else value(e, at))
    low, high = ends
    if low is None or high is None:
        return None
    if node.op == "integral":
        return _integral(body, name, low, high, at)
    return _sum(node.op, body, name, low, high, at)


def _sum(op: str, body: Expr, name: str, low: arb, high: arb, at: At) -> arb | None:
    first, last = low.unique_fmpz(), high.unique_fmpz()
    if first is None:
        return None
    names = sorted({*at, name})
    run = program([body], names, [name])
    result, k = arb(0 if op == "sum" else 1), int(first)
    while last is None or k <= int(last):
        found = run([arb(k) if n == name else at[n] for n in names])
        if found is None or k - int(first) > MOST_TERMS:
            return None
        result = result + found[0] if op == "sum" else result * found[0]
        k += 1
        if last is None and abs(found[0]) < SMALL * abs(result) and k - int(first) > 20:
            return result
    return result


def _integral(body: Expr, name: str, low: arb, high: arb, at: At) -> arb | None:
    if low > high:
        back = _integral(body, name, high, low, at)
        return None if back is None else -back
    names = sorted(at)
    lower, upper = symbol("[a]"), symbol("[b]")
    run = program([integral(body, name, lower, upper)], [*names, "[a]", "[b]"])
    fixed = [at[n] for n in names]
    if not low.is_finite() and not high.is_finite():
        parts = [_half(run, fixed, arb(0), side) for side in (1, -1)]
    elif not high.is_finite():
        parts = [_half(run, fixed, low, 1)]
    elif not low.is_finite():
        parts = [_half(run, fixed, high, -1)]
    else:
        middle = ((low + high) / 2).mid()
        parts = [_towards(run, fixed, middle, end) for end in (low.mid(), high.mid())]
    result = arb(0)
    for part in parts:
        if part is None:
            return None
        result += part
    return result


def _half(run: Program, fixed: Sequence[arb], start: arb, side: int) -> arb | None:
    """Return the integral from ``start`` to infinity on a side."""
    near = (start + side).mid()
    first = _towards(run, fixed, near, start.mid())
    return None if first is None else _added(run, fixed, _outward(start, side), first)


def _towards(run: Program, fixed: Sequence[arb], start: arb, end: arb) -> arb | None:
    """Return the integral between an inner point and an end, which may be singular."""
    return _added(run, fixed, _inward(start, end), arb(0))


def _outward(start: arb, side: int) -> Iterator[tuple[arb, arb]]:
    for k in range(FARTHEST):
        for part in range(4):
            far = [start + side * arb(2) ** k * (1 + arb(p) / 4) for p in (part, part + 1)]
            yield far[0].mid(), far[1].mid()


def _inward(start: arb, end: arb) -> Iterator[tuple[arb, arb]]:
    far = start
    for k in range(1, NEAREST):
        near = (end + (start - end) * arb((1, -k))).mid()
        yield far, near
        far = near


def _added(
    run: Program, fixed: Sequence[arb], pieces: Iterator[tuple[arb, arb]], begin: arb
) -> arb | None:
    result, small = begin, 0
    for one, other in pieces:
        ends = (one, other) if one < other else (other, one)
        found = run([*fixed, *ends])
        if found is None:
            return result if small > 2 else None
        result += found[0]
        small = small + 1 if abs(found[0]) < SMALL * abs(result) or found[0] == 0 else 0
        if small > 8:
            break
    return result


def against(claim: Comparison, path: Path, at: At, bound: arb | None, reach: arb | None) -> str:
    """Return in words where numbers contradict a proof along a path; empty where they do not.

    Args:
        at: the values of the parameters.
        bound: the constant of an O.
        reach: where its region begins, in the variable or as a distance from the end.
    """
    with ball_precision(BITS):
        for side in path.sides:
            sizes = []
            for order in ORDERS:
                x = _place(path, side, order, at)
                found = None if x is None else _sides(claim, {**at, path.name: x})
                if x is None or found is None:
                    continue
                if bound is not None and _is_inside(path, x, order, reach):
                    left, right = found
                    if abs(left) > bound * abs(right) * CLEAR:
                        return (
                            f"at {path.name} near {said(x.mid())} the sides of the claim are "
                            f"{said(left.mid())} and {said(right.mid())}, beyond the constant C"
                        )
                size = quantity(claim, found)
                if size is not None and size.is_finite():
                    sizes.append(abs(size.mid()))
            sizes = [size for size in sizes if size > NOISE]
            strict = claim.relation in ("o", "~", "->", "omega")
            if (
                strict
                and len(sizes) == len(ORDERS)
                and follows_a_law(list(map(arb, ORDERS)), sizes)
            ):
                return "numerical integration along the path contradicts it"
    return ""


def _place(path: Path, side: int, order: int, at: At) -> arb | None:
    if path.point is None:
        return side * arb(2) ** order
    point = value(path.point, at) if symbols(path.point) <= set(at) else None
    return None if point is None else (point + side * arb((1, -order))).mid()


def _is_inside(path: Path, x: arb, order: int, reach: arb | None) -> bool:
    if reach is None or reach == 0:
        return True
    return bool(abs(x) >= abs(reach)) if path.point is None else bool(arb((1, -order)) <= reach)


def _sides(claim: Comparison, at: At) -> tuple[arb, arb] | None:
    infinite = (INFINITY, -INFINITY)
    found = []
    for e in (claim.left, claim.right):
        size = arb(0) if e in infinite else value(e, at)
        if size is None or not size.is_finite() or not size.rad() < SMALL.sqrt() * (1 + abs(size)):
            return None
        found.append(size)
    return found[0], found[1]
