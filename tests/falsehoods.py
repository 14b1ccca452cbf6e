"""Claims as text, for tests of one method at a time, and the exact points that make them false."""

from collections.abc import Callable
from typing import NamedTuple

from flint import ctx

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.parsing import parse, parse_claim
from tresym.reals.normal.at_point import equal_at, satisfies
from tresym.reals.numbers.arithmetic import ball_precision


class Inequality(NamedTuple):
    """``left relation right``, the relation one of ``>``, ``>=`` and ``!=``, under conditions."""

    left: Expr
    relation: str
    right: Expr
    given: Given

    @property
    def difference(self) -> Expr:
        return self.left - self.right


def read(claim: str) -> Inequality:
    """``"x >= y given x > 1, y < 1"``."""
    body, _, given = claim.partition(" given ")
    ((left, relation, right),) = parse_claim(body)
    if relation in ("<", "<="):
        left, relation, right = right, relation.replace("<", ">"), left
    return Inequality(left, relation, right, Given.parse(given))


def is_false_at(claim: str, place: str) -> bool:
    """Whether the point, such as ``"x = 1/2, y = pi"``, is one of the conditions and no example."""
    parts = [part.split("=") for part in place.split(",")] if place else []
    point = {name.strip(): parse(value) for name, value in parts}
    inequality = read(claim)
    assert symbols(inequality.difference) <= point.keys()
    with ball_precision(200):
        at = {name: evaluate(value, {}) for name, value in point.items()}
        assert all(satisfies(c, point, at) for c in inequality.given.conditions), claim
        left, right = evaluate(inequality.left, at), evaluate(inequality.right, at)
        assert left.is_finite(), claim
        assert right.is_finite(), claim
    if inequality.relation == ">=":
        return bool(left < right)
    equal = left.overlaps(right) and equal_at(inequality.left, inequality.right, point)
    return equal or (inequality.relation == ">" and bool(left < right))


def proves(method: Callable[[Expr, str, Given], str | None], claim: str) -> bool:
    """Whether the method, called by itself, proves the claim; it must leave the precision alone."""
    before = ctx.prec
    inequality = read(claim)
    proof = method(inequality.difference, inequality.relation, inequality.given)
    assert ctx.prec == before
    return proof is not None
