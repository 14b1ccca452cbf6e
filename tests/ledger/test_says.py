"""What orders and bounds are judged by, against what they say: balls at points, symbol by symbol.

The evidence for an order is a plain function, which a reader compares with the statement. Where
the statement is a formula, so do balls: the formula's remainder at the exact ε₀, over its gauge,
is what the margins on the box bound.
"""

import random
from collections.abc import Callable

import pytest
import sympy
from flint import arb, fmpq
from sympy import Basic, Function, Symbol, sqrt
from tresym.proofs.printed import exact_defect

from tresym.ledger.evidence.balls import Boxes
from tresym.ledger.paper import all_claims
from tresym.ledger.second_look import value
from tresym.racket.formulas import printed
from tresym.racket.notation import S, a, b, epsilon0, lam, mu
from tresym.reals.numbers.arithmetic import ball_precision, balls

BITS, FINE = 160, 400
SHAPES = tuple(
    (fmpq(*p), fmpq(*q))
    for p, q in (((9, 2), (1, 2)), ((12, 1), (1, 4)), ((5, 4), (7, 8)), ((40, 1), (9, 10)))
)
"""Shapes with ab ≥ 1/4 and b ≤ 4a, strictly inside every box."""
CLAIMS = {claim.label: claim for claim in all_claims()}
TINY = arb(2) ** -60

Values = dict[Symbol, arb]


def at_shape(p: fmpq, q: fmpq) -> Values:
    """Every symbol that the statements use, at a shape and its exact ε₀."""
    point = {a: arb(p), b: arb(q), S: arb(1)}
    point[epsilon0] = exact_defect(point[a], point[b], balls)
    point[lam], point[mu] = printed.small_parameters(point[a], point[b], balls)
    return point


def without_orders(e: Basic) -> Basic:
    """The formula with every O(…) and o(…) left out, and ``hot`` too."""
    orders = {node: sympy.Integer(0) for node in e.atoms(Function) if str(node.func) in ("O", "o")}
    return e.xreplace({**orders, Symbol("hot", real=True): sympy.Integer(0)})


def same(x: arb, y: arb) -> bool:
    return abs(x - y) < TINY * (1 + abs(x))


# -- bounds that are said in words ----------------------------------------------------------------

star = 2 * sqrt(a / (a + b)) * sympy.exp(-sqrt(a * b) * (sympy.pi + sympy.asin(sqrt(b / (a + b)))))
"""ε*."""
leading = printed.asymptotic_defect(a, b, sympy)
_c1 = (6 * b + 3 * b / a - 1) / 12
_excess = epsilon0 / star - 1
_u = -sympy.log(epsilon0 / star)
"""u/λ."""
_defect_F = printed.defect_per_turn(epsilon0, a, b, 1, sympy)
_F_gamma = printed.turn_slope(epsilon0, a, b, 1, sympy)
_root_ab = sqrt(a * b)


def swept(start: Basic) -> Basic:
    """ε of one sweep from this phase."""
    time = _root_ab * (sympy.pi + sympy.atan(sqrt(b / a) * sympy.tanh(_root_ab * start)))
    return sympy.atan(sqrt(a / (a + b)) / sympy.sinh(time))


def both_sides(e: Basic, gauge: Basic, constant: str) -> tuple[Basic, tuple[Basic, ...]]:
    """|e| ≤ constant · gauge, as its two relations, and the gauge."""
    limit = sympy.Rational(constant) * gauge
    return gauge, (sympy.Le(e, limit, evaluate=False), sympy.Ge(e, -limit, evaluate=False))


def between(low: str, e: Basic, high: str, gauge: Basic) -> tuple[Basic, tuple[Basic, ...]]:
    """low · gauge < e < high · gauge."""
    least, most = (sympy.Rational(text) * gauge for text in (low, high))
    return gauge, (sympy.Gt(e, least, evaluate=False), sympy.Lt(e, most, evaluate=False))


def above_only(e: Basic, constant: str, gauge: Basic) -> tuple[Basic, tuple[Basic, ...]]:
    """e ≤ constant · gauge."""
    return gauge, (sympy.Le(e, sympy.Rational(constant) * gauge, evaluate=False),)


_per_ab = 1 / (a * b)
_slope = -_defect_F * _F_gamma
_off_slope = _slope + 1 / (4 * b * epsilon0)
_off_turn = 4 * b * _root_ab * _F_gamma + 1 / epsilon0**2
_slope_gauge = _root_ab * epsilon0 / b
_second = _excess - _c1 * star**2
_error = sympy.log(leading / epsilon0)
_relative = leading / epsilon0 - 1
_from_pi, _from_4 = (swept(s) / epsilon0 - 1 for s in (sympy.pi, sympy.Integer(4)))
_one = sympy.Integer(1)
_decay = epsilon0 * sympy.exp(sympy.pi * _root_ab)
_cube = (star / (2 * sqrt(a / (a + b)))) ** 3

FORMAL: dict[str, tuple[Basic, tuple[Basic, ...]]] = {
    "printed_error": both_sides(_error, _per_ab, "17/100"),
    "printed_error_too_small": both_sides(_error, _per_ab, "166/1000"),
    "printed_relative_error": between("133/1000", _relative, "168/1000", b**2 / a),
    "printed_relative_too_small": above_only(_relative, "166/1000", b**2 / a),
    "repaired": both_sides(_excess, star**2, "1451/1000"),
    "repaired_too_small": both_sides(_excess, star**2, "145/100"),
    "second_order": both_sides(_second, star**4, "298/100"),
    "second_order_too_small": both_sides(_second, star**4, "296/100"),
    "everywhere_too_small": both_sides(epsilon0 - star, _cube, "333/100"),
    "u_exponentially_small": both_sides(-_u, star**2, "144/100"),
    "u_flat_order": both_sides(-_u / _root_ab, _per_ab, "9/1000"),
    "slope_leading_term": both_sides(-_off_slope, _slope_gauge / 4, "63/5"),
    "slope_constant_too_small": both_sides(-_off_slope, _slope_gauge / 4, "62/5"),
    "d52_true_order": between(
        "1/4", -_defect_F - _root_ab * epsilon0, "29/10", _root_ab * epsilon0**3
    ),
    "d56_true_order": between("3/2", _off_turn, "18", _root_ab),
    "d57_true_order": between("3/2", _off_slope, "63/5", _slope_gauge / 4),
    "remark1": between("52/100", _decay, "201/100", _one),
    "one_line": above_only(_from_pi, "28/1000", _one),
    "one_line_too_small": above_only(_from_pi, "27/1000", _one),
    "balanced_line": both_sides(_from_4, _one, "65/10000"),
}
"""What the sentence says: a gauge, and one relation for each margin, which is the difference of
its sides over the gauge."""
FORMAL = {label: said for label, said in FORMAL.items() if isinstance(CLAIMS[label].proof, Boxes)}


Chart = Callable[[fmpq, fmpq], tuple[fmpq, fmpq]]


def charts(label: str) -> tuple[Chart, ...]:
    """For each margin the shape (a, b) that its two coordinates stand for."""
    if CLAIMS[label].proof.names[1] == "k":
        return 2 * (lambda b, k: (k * k / b, b),)
    return 2 * (lambda b, kappa: (1 / (b * kappa * kappa), b),)


def disagreements(label: str, gauge: Basic, relations: tuple[Basic, ...]) -> list[str]:
    """Margins that are not the difference of the sides over the gauge, at points of their box."""
    draw, wrong = random.Random(label), []
    bounds = CLAIMS[label].proof.bounds
    assert len(bounds) == len(relations)
    for bound, relation, chart in zip(bounds, relations, charts(label), strict=False):
        for _ in range(3):
            coordinates = [
                side.low + side.width * fmpq(draw.randint(50, 98), 100) for side in bound.box
            ]
            p, q = chart(*coordinates)
            with ball_precision(FINE):
                point = {a: arb(p), b: arb(q)}
                point[epsilon0] = exact_defect(point[a], point[b], balls)
                room = (value(relation.gts, point) - value(relation.lts, point)) / value(
                    gauge, point
                )
                found = bound.margin(*(arb(x) for x in coordinates), balls)
            assert room.rad() < arb("1e-9")
            if not (found.overlaps(room) and found.rad() < arb("1e-4") * (1 + abs(found))):
                wrong.append(f"{label} at a = {p}, b = {q}: {found} and {room}")
    return wrong


@pytest.mark.parametrize("label", [*FORMAL])
def test_the_margins_are_what_the_sentence_says(label: str) -> None:
    assert disagreements(label, *FORMAL[label]) == []


def test_a_planted_discrepancy_is_noticed() -> None:
    for label, (gauge, relations) in FORMAL.items():
        first = relations[0]
        other = first.func(first.lhs, first.rhs + gauge / 1000, evaluate=False)
        assert disagreements(label, gauge, (other, *relations[1:])), label


UNREAD = {
    "sufficient": ("everywhere",),
}
"""Bounds and orders in words that are compared by reading only, by the reason: it only shrinks."""


def test_what_is_compared_by_reading_only_is_listed() -> None:
    in_words = {
        claim.label
        for claim in CLAIMS.values()
        if isinstance(claim.says, str) and isinstance(claim.proof, Boxes)
    }
    listed = {label for labels in UNREAD.values() for label in labels}
    assert in_words - {*FORMAL} == listed
