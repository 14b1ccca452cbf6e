"""Inequalities and orders: lists of true and nearly true claims, and random ones."""

import json
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

import tresym
from tresym.dev.corpus.lists import Known, known
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import with_domain
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse
from tresym.reals.language.solve import solutions
from tresym.reals.signs.polynomials import sign_of_polynomial
from tresym.reals.verdict import Verdict

SAVED = Path(__file__).resolve().parents[3] / "docs" / "measurements"
PROVED, ENCLOSED = Verdict.PROVED, Verdict.ENCLOSED
REFUTED, UNDECIDED = Verdict.REFUTED, Verdict.UNDECIDED

LISTED = [pair for name in ("inequalities", "orders") for pair in known(name)]
SAMPLED = [pair for n, pair in enumerate(LISTED) if not (pair.truth and n % 7)]
"""All that are false, and some that are true."""


@pytest.mark.slow
@pytest.mark.parametrize("pair", SAMPLED, ids=lambda pair: pair.claim)
def test_no_claim_of_the_lists_is_decided_wrongly(pair: Known) -> None:
    answer = tresym.check(pair.claim)
    assert answer.verdict in ((PROVED, ENCLOSED, UNDECIDED) if pair.truth else (REFUTED, UNDECIDED))


def test_what_is_measured_of_the_lists_has_nothing_wrong() -> None:
    notes = json.loads((SAVED / "check.json").read_text(encoding="utf-8"))["notes"]
    for name in ("inequalities", "orders"):
        assert notes[f"true {name}"].get("REFUTED", 0) == 0
        assert not notes[f"false {name}"].keys() & {"PROVED", "ENCLOSED"}


SMALL = st.integers(-3, 4)
MONOMIALS = st.tuples(st.integers(0, 3), st.integers(0, 3))
CONDITIONS = st.sampled_from(
    [
        "",
        "x > 0, y > 0",
        "x >= 0, y >= 0",
        "x >= 0, y >= 0, x + y <= 1",
        "x > y, y > 0",
        "x*y > 0",
        "0 <= x <= 1, 0 <= y <= 1",
        "x >= -1",
        "x + y > 0",
        "x**2 + y**2 <= 1",
    ]
)
GRID = [Fraction(p, q) for q in (1, 2, 3) for p in range(-4, 5)] + [Fraction(7), Fraction(1, 50)]
POINTS = [{"x": x, "y": y} for x, y in product(sorted(set(GRID)), repeat=2)]


@given(
    st.dictionaries(MONOMIALS, SMALL, min_size=1, max_size=5),
    st.booleans(),
    CONDITIONS,
    st.sampled_from([">=", ">", "!="]),
)
@pytest.mark.slow
def test_signs_of_polynomials_hold_at_every_point(
    terms: dict[tuple[int, int], int], squared: bool, conditions: str, relation: str
) -> None:
    text = " + ".join(f"({c})*x**{i}*y**{j}" for (i, j), c in terms.items())
    difference = parse(f"({text})**2 + x**2*y**2 - y**2*x**2" if squared else text)
    region = with_domain(Given.parse(conditions), difference)
    if region.satisfying_point(["x", "y"]) is None:
        return
    if sign_of_polynomial(difference, relation, region) is None:
        return
    for point in POINTS:
        if all(_holds(c.expression, c.relation, point) for c in region.conditions):
            assert _holds(difference, relation, point), point


def _holds(e: Expr, relation: str, point: dict[str, Fraction]) -> bool:
    value = _value(e, point)
    return {">": value > 0, ">=": value >= 0, "!=": value != 0}[relation]


def _value(e: Expr, point: dict[str, Fraction]) -> Fraction:
    """A polynomial at a rational point."""
    if e.op == "number":
        value: fmpq = e.args[0]
        return Fraction(int(value.p), int(value.q))
    if e.op == "symbol":
        return point[e.args[0]]
    values = [_value(arg, point) for arg in e.args]
    if e.op == "^":
        return values[0] ** int(values[1])
    total = values[0]
    for other in values[1:]:
        total = total + other if e.op == "+" else total * other
    return total


@pytest.mark.parametrize(
    ("slope", "zero"),
    [("log(x) + 1", "exp(-1)"), ("exp(x) - y", "log(y)"), ("1/E - 1/x", "E"), ("x - 2*y", "2*y")],
)
def test_where_a_derivative_vanishes(slope: str, zero: str) -> None:
    (found,) = solutions(parse(slope), "x")
    assert tresym.check(f"{found} == {zero}", given="y > 0")


def test_a_symbol_in_several_terms_has_no_solution() -> None:
    assert solutions(differentiate(parse("x*exp(x)"), "x"), "x") == []


@given(
    st.tuples(*(st.integers(-3, 3) for _ in range(6))),
    st.sampled_from(["x + y <= 1", "x + y >= 1", "x*y >= 1", "x**2 + y**2 <= 1", "x + 2*y < 2"]),
    st.sampled_from(["x > 0, y > 0", "x > 0, y < 0", "x >= 0", ""]),
)
def test_what_is_shown_in_cells_holds_at_points(
    coefficients: tuple[int, ...], condition: str, signs: str
) -> None:
    """Polynomials of degree 2 under a condition: a proof holds at all points of a grid."""
    parts = zip(coefficients, ("x**2", "x*y", "y**2", "x", "y", "1"), strict=True)
    polynomial = " + ".join(f"({c})*{monomial}" for c, monomial in parts)
    region = Given.parse(f"{signs}, {condition}" if signs else condition)
    proof = sign_of_polynomial(parse(polynomial), ">=", region)
    if proof is not None:
        difference = parse(polynomial)
        for x, y in product(range(-12, 13), repeat=2):
            at = {"x": arb(fmpq(x, 4)), "y": arb(fmpq(y, 4))}
            if all(c.holds_exactly(at) for c in region.conditions):
                assert evaluate(difference, at) >= 0
