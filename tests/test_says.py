"""What orders and bounds are judged by, against what they say: balls at points, symbol by symbol.

The evidence for an order is a plain function, which a reader compares with the statement. Where
the statement is a formula, so do balls: the formula's remainder at the exact ε₀, over its gauge,
is what the margins on the box bound.
"""

from collections.abc import Callable

import pytest
import sympy
from flint import arb, fmpq
from sympy import Basic, Function, Symbol, sqrt
from tresym.proofs.table_of_objects import exact_defect

from tresym.arithmetic import ball_precision, balls
from tresym.claims.claim import Claim
from tresym.claims.violation import value
from tresym.formulas import printed
from tresym.notation import S, a, b, epsilon0, lam, mu
from tresym.verification import all_claims

BITS = 160
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


def measured(claim: Claim, point: Values) -> arb:
    """What the two margins C − e and C + e of a claim bound."""
    names = {"b": point[b], "kappa": point[lam], "R": point[b] / point[a]}
    at = [names.get(name, point[epsilon0]) for name in claim.proof.names]
    first, second = (bound.margin(*at, balls) for bound in claim.proof.bounds)
    return (second - first) / 2


def per_turn(point: Values) -> arb:
    return printed.defect_per_turn(point[epsilon0], point[a], point[b], 1, balls)


def turn_slope(point: Values) -> arb:
    return printed.turn_slope(point[epsilon0], point[a], point[b], 1, balls)


def slope(point: Values) -> arb:
    return -per_turn(point) * turn_slope(point)


ORDERS: dict[str, tuple[Callable[[Values], arb] | None, Basic]] = {
    "d38": (None, (1 + b / a) * epsilon0**4 / 4),
    "eqnew": (None, epsilon0**3),
    "d52": (per_turn, sqrt(a * b) * epsilon0**2),
    "d56": (turn_slope, 1 / (4 * b * sqrt(a * b) * epsilon0)),
    "d57": (slope, 1 / b),
}
"""What the left side is at γ = 0, where it is a symbol, and the gauge with its factor."""


@pytest.mark.parametrize("label", ORDERS)
def test_the_margins_bound_the_remainder_of_the_formula(label: str) -> None:
    claim, (left, gauge) = CLAIMS[label], ORDERS[label]
    for shape in SHAPES:
        with ball_precision(BITS):
            point = at_shape(*shape)
            sides = [without_orders(side) for side in claim.says.args]
            known = value(sides[0], point) if left is None else left(point)
            remainder = (known - value(sides[1], point)) / value(gauge, point)
            found = measured(claim, point)
            assert same(found, remainder) or same(found, -remainder)


def test_the_reduced_equation_is_the_one_that_its_margin_denies() -> None:
    claim = CLAIMS["equation"]
    (bound,) = claim.proof.bounds
    with ball_precision(BITS):
        point = at_shape(*(side.low for side in bound.box))
        left, right = (value(side, point) for side in claim.says.args)
        assert same(bound.margin(point[a], point[b], balls), -abs(right / left - 1))


@pytest.mark.parametrize("label", ["d24", "eps0"])
def test_the_remainder_of_the_theorem_is_the_one_that_is_judged(label: str) -> None:
    claim = CLAIMS[label]
    order = claim.proof.statement
    bracket = claim.says.args[1] * sympy.exp(sympy.pi * sqrt(a * b))
    for t in (fmpq(1, 2), fmpq(1, 4)):
        with ball_precision(BITS):
            point = at_shape(1 / t**2, fmpq(1))
            growth = (balls.pi * balls.sqrt(point[a] * point[b])).exp()
            rest = point[epsilon0] * growth - value(without_orders(bracket), point)
            ratio = order.function(arb(t), balls) / order.gauge(arb(t), balls)
            assert same(ratio, rest * growth)


def test_a_slip_of_the_formula_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ORDERS, "d52", (per_turn, 2 * sqrt(a * b) * epsilon0**2))
    with pytest.raises(AssertionError):
        test_the_margins_bound_the_remainder_of_the_formula("d52")
