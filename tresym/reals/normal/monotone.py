"""Find signs of inverse functions from their arguments.

An arc tangent has the sign of its argument, ``±π/2 + r·atan u`` with ``|r| ≤ 1`` has the sign of
its first term, and ``Σ nᵢ log|fᵢ|`` has that of ``Π |fᵢ|^nᵢ − 1``.
"""

from __future__ import annotations

from flint import fmpz

from tresym.reals.normal.ring import Poly
from tresym.reals.normal.sign_equations import SignedRing
from tresym.reals.numbers.factoring import TooLargeError

MAX_MULTIPLE = 12


def same_sign(ring: SignedRing, p: Poly) -> Poly | None:
    """Return a polynomial with the sign of ``p`` everywhere, without its outermost inverse
    functions.

    None is returned if ``p`` does not have one of these forms, or if the sign of an ``fᵢ`` is not
    known.
    """
    kinds = {ring.at(i).kind for i in ring.used(p)}
    found = None
    if kinds == {"log"} and p.total_degree() == 1:
        found = _of_logarithms(ring, p)
    elif len(p) <= 2 and "atan" in kinds and kinds <= {"atan", "pi", "sign"}:
        found = _of_arc_tangents(ring, p)
    return None if found is None else ring.reduce(found)


def _of_logarithms(ring: SignedRing, p: Poly) -> Poly | None:
    content = p.content()
    product = ring.one
    for monomial, value in p.terms():
        if not any(monomial) or abs(value) > MAX_MULTIPLE * content:
            return None
        inner = ring.at(next(i for i, k in enumerate(monomial) if k)).data[0]
        sign = ring.sign(inner, 1)
        if not sign:
            return None
        try:
            product = product * ring.fraction(sign * inner) ** int(value // content)
        except TooLargeError:
            return None
    known = ring.product_sign(product.den, 1)
    return known * (product.num - product.den) if known else None


def _of_arc_tangents(ring: SignedRing, p: Poly) -> Poly | None:
    alone: Poly | None = None
    parts: dict[str, tuple[Poly, fmpz]] = {}
    for monomial, value in p.terms():
        used = [(i, k) for i, k in enumerate(monomial) if k and ring.at(i).kind != "sign"]
        if len(used) != 1 or used[0][1] != 1:
            return None
        generator = ring.at(used[0][0])
        signs = ring.context.from_dict({tuple(map(int, monomial)): 1}) // ring.variable(generator)
        parts[generator.kind] = (signs, value)
        if generator.kind == "atan":
            alone = generator.data[0].num * generator.data[0].den * signs * value
    if len(parts) != len(p):
        return None
    if "pi" not in parts:
        return alone
    signs, value = parts["pi"]
    return signs * value if abs(parts["atan"][1]) <= 2 * abs(value) else None
