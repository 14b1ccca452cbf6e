"""Bounds, monotone dependence, infima and orders derived from claims, and what must not be."""

from dataclasses import replace
from typing import Any

from derivations import by, manifest
from planted_claims import claim, judged, x, y
from planted_claims import verdict_on as verdict
from sympy import (
    Derivative,
    Eq,
    Function,
    Gt,
    Integer,
    Lt,
    Rational,
    Symbol,
    Tuple,
    oo,
)
from sympy_statements import (
    ExactlyOne,
    Infimum,
    StrictlyDecreasing,
    StrictlyIncreasing,
    Under,
    at,
    equal,
    order,
)

from tresym.ledger.claim import (
    Claim,
    Definition,
    Dominated,
    FromSlope,
    FromTheEdge,
    InfimumBy,
    MonotoneOf,
    Root,
    RootBound,
    RootMonotone,
    all_of,
    follows,
    in_words,
    jointly,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.judge import judge
from tresym.ledger.reasons import differentiation, evaluating
from tresym.reals.verdict import Verdict

z, t, c = (Symbol(name, real=True) for name in ("z", "t", "c"))
BIG, small = Function("O"), Function("o")
PROVED, REFUTED, UNDECIDED = Verdict.PROVED, Verdict.REFUTED, Verdict.UNDECIDED


def one_root(equation: Any, _slope: Any, low: Any, high: Any, *given: Any) -> Claim:
    """The claim that defines z as the root of an equation for y."""
    unique = Claim(
        "unique", ExactlyOne(y, low, high, equation), Decided(), expect=PROVED, given=given
    )
    root = Root(z, unique)
    return Claim("root", root.says, root, given=given)


SMALL = (x > 0, x < 3)
CUBIC = one_root(equal(y**3 + y, x), 3 * y**2 + 1, Integer(0), Integer(3), *SMALL)
"""z³ + z = x: between 0 and 3 for 0 < x < 3."""
RISES = Claim("rises", StrictlyIncreasing(z, x), RootMonotone(CUBIC, Decided()), given=SMALL)


def test_a_root_is_monotone_in_a_parameter() -> None:
    assert judged(RISES).verdict is PROVED
    falls = judged(replace(RISES, says=StrictlyDecreasing(z, x)))
    assert falls.verdict is REFUTED
    assert falls.witness
    assert falls.witness["x"] < falls.witness["x'"]


def test_where_the_parameter_ranges_over_two_intervals_nothing_follows() -> None:
    """x³ − 3x rises where x > 1 and where x < −1, and yet it is larger at −6/5 than at 6/5."""
    apart = (x**2 - 1 > 0, x < 4, x > -4)
    root = one_root(equal(y, x**3 - 3 * x), Integer(1), Integer(-1000), Integer(1000), *apart)
    proof = RootMonotone(root, Decided())
    assert verdict(StrictlyIncreasing(z, x), proof, *apart) is not PROVED
    right = (x > 1, x < 4)
    root = one_root(equal(y, x**3 - 3 * x), Integer(1), Integer(-1000), Integer(1000), *right)
    proof = RootMonotone(root, Decided())
    assert verdict(StrictlyIncreasing(z, x), proof, *right) is PROVED


def test_a_parameter_must_be_free() -> None:
    """With x = c² it is no parameter; nor is it if the function has a symbol that x defines."""
    defined = Claim("defined", equal(x, c**2 + 1), Definition())
    assert verdict(RISES.says, RootMonotone(CUBIC, Decided(also=(defined,))), *SMALL) is (UNDECIDED)
    by_x = Claim("by_x", equal(c, 1 - 2 * x), Definition())
    root = one_root(equal(y, x + c), Integer(1), Integer(-9), Integer(9), *SMALL, c > -5, c < 1)
    proof = RootMonotone(root, Decided(also=(by_x,)))
    assert verdict(StrictlyIncreasing(z, x), proof, *SMALL, c > -5, c < 1) is UNDECIDED


def test_a_bound_on_a_root() -> None:
    assert verdict(z < x, RootBound(CUBIC, Decided()), *SMALL) is PROVED
    assert verdict(z > x, RootBound(CUBIC, Decided()), *SMALL) is REFUTED
    assert verdict(z > x / 10, RootBound(CUBIC, Decided()), *SMALL) is PROVED
    assert verdict(z > 1, RootBound(CUBIC, Decided()), *SMALL) is REFUTED
    at_two = RootBound(CUBIC, Decided())
    assert verdict(z > Rational(1, 2), at_two, Eq(x, 2)) is PROVED
    assert verdict(z > Rational(1, 2), at_two, *SMALL) is REFUTED


def test_a_bound_outside_the_ends_says_nothing() -> None:
    """y² = x has the root √x; at v = −6 the function is positive, and √x is not below it."""
    root = one_root(equal(y**2, x), 2 * y, Integer(0), Integer(6), *SMALL)
    found = judged(claim(z < -6, RootBound(root, Decided()), SMALL))
    assert found.verdict is not PROVED
    assert not found.stopped  # by the rule itself, not by the independent check


def test_a_root_is_defined_only_under_its_conditions() -> None:
    assert verdict(z > 1, RootBound(CUBIC, Decided()), x > 2, x < 3) is PROVED
    found = judged(claim(z > 1, RootBound(CUBIC, Decided()), (x > 2, x < 100)))
    assert found.verdict is UNDECIDED
    assert not found.stopped


def test_a_function_of_a_root_is_monotone() -> None:
    assert verdict(StrictlyDecreasing(1 / z, x), MonotoneOf(RISES, (CUBIC,)), *SMALL) is PROVED
    assert verdict(StrictlyIncreasing(1 / z, x), MonotoneOf(RISES, (CUBIC,)), *SMALL) is REFUTED
    assert verdict(StrictlyIncreasing(z - x, x), MonotoneOf(RISES, (CUBIC,)), *SMALL) is UNDECIDED
    assert verdict(StrictlyIncreasing((z - 1) ** 2, x), MonotoneOf(RISES), *SMALL) is UNDECIDED


def test_a_function_that_jumps_has_no_values_between() -> None:
    """A claim that z increases is not enough: 1/z rises where z jumps over 0."""
    jumps = Claim("jumps", StrictlyIncreasing(z, x), all_of(RISES), given=SMALL)
    assert verdict(StrictlyDecreasing(1 / z, x), MonotoneOf(jumps, (CUBIC,)), *SMALL) is UNDECIDED


def test_a_bound_for_all_values_from_one() -> None:
    """z > 1/2 at x = 1, and so for all larger x; not for smaller ones."""
    half = Rational(1, 2)
    edge = Claim("edge", z > half, RootBound(CUBIC, Decided()), given=(Eq(x, 1),))
    proof = FromTheEdge(RISES, edge, Integer(1))
    assert verdict(z > half, proof, x >= 1, x < 3) is PROVED
    found = judged(claim(z > half, proof, (x > 0, x < 3)))
    assert found.verdict is not PROVED
    assert not found.stopped
    assert verdict(z > half, FromTheEdge(RISES, edge, Integer(2)), x >= 2, x < 3) is UNDECIDED
    assert verdict(z > half, proof, x >= 1) is UNDECIDED  # beyond 3 nothing is known
    moving = Claim("moving", z > x / 3, RootBound(CUBIC, Decided()),
                   given=(Eq(x, 1),))  # fmt: skip
    assert verdict(z > x / 3, FromTheEdge(RISES, moving, Integer(1)), x >= 1, x < 3) is not PROVED


def test_what_starts_at_zero_and_rises_is_positive() -> None:
    from_one = Claim("from_one", Derivative(x**2 - x, x) > 0, by(differentiation), given=(x >= 1,))
    start = Claim("start", equal(at(x**2 - x, {x: 1}), 0), by(evaluating))
    assert verdict(x**2 - x > 0, FromSlope(from_one, start), x > 1) is PROVED
    assert verdict(x**2 - x > 0, FromSlope(from_one, start), x > 0) is not PROVED
    assert verdict(x**2 - x > 0, FromSlope(from_one, start), x >= 1) is not PROVED
    at_zero = Claim("at_zero", equal(at(x**2 - x, {x: 0}), 0), by(evaluating))
    # x² − x rises only from 1/2 on, and at 1/2 it is negative.
    assert verdict(x**2 - x > 0, FromSlope(from_one, at_zero), x >= 1) is not PROVED
    assert verdict(x**3 - x > 0, FromSlope(from_one, start), x > 1) is UNDECIDED


def test_an_infimum_is_bounded_and_approached() -> None:
    e = 1 + 1 / (x + 1)
    lower = Claim("lower", Gt(e, 1, evaluate=False), manifest, given=(x > 0,))
    upper = Claim("upper", Lt(e, 1 + 1 / x, evaluate=False), manifest, given=(x > 0,))
    path = ((x, 1 / t),)
    assert verdict(Infimum(e, Integer(1)), InfimumBy(lower, upper, path), x > 0) is Verdict.ENCLOSED
    less = Claim("less", Gt(e, Rational(1, 2), evaluate=False), manifest, given=(x > 0,))
    assert verdict(Infimum(e, Rational(1, 2)), InfimumBy(less, upper, path), x > 0) is not PROVED
    assert verdict(Infimum(e, Rational(3, 2)), InfimumBy(lower, upper, path), x > 0) is not PROVED
    away = InfimumBy(lower, upper, ((x, 1 + t),))
    assert verdict(Infimum(e, Integer(1)), away, x > 0) is UNDECIDED
    beyond = InfimumBy(lower, upper, ((x, -1 / t),))
    assert verdict(Infimum(e, Integer(1)), beyond, x > 0) is UNDECIDED
    # Under x < 5 the values 1/t are not allowed: the infimum is 7/6.
    assert verdict(Infimum(e, Integer(1)), InfimumBy(lower, upper, path), x > 0, x < 5) is UNDECIDED


def test_an_order_must_be_that_of_its_bound() -> None:
    size = Claim("size", x * y <= 2 / x, manifest, given=(x > 1, y > 0, y <= 1 / x**2))
    low = Claim("low", x * y >= 0, manifest, given=(x > 1, y > 0, y <= 1 / x**2))
    given = (y > 0, y <= 1 / x**2)
    for gauge, holds in ((BIG(1 / x), True), (small(Integer(1)), True), (small(1 / x), False),
                         (BIG(1 / x**2), False)):  # fmt: skip
        says = order(equal(x * y, gauge), x, oo)
        assert verdict(says, Dominated(size, low), *given).holds is holds, gauge
    assert not verdict(order(equal(x * y, BIG(1 / x)), x, oo), Dominated(size), *given).holds
    assert not verdict(order(equal(x * y, BIG(1 / x)), x, 0), Dominated(size, low), *given).holds
    less = Tuple(x * y <= 2 / x, x * y >= 0, Under(x * y <= 1 / x**2, Tuple(y <= 1 / x**3)))
    parts = Claim("parts", less, follows(manifest, manifest, manifest), given=size.given)
    assert verdict(order(equal(x * y, BIG(1 / x)), x, oo), Dominated(parts), *given).holds
    assert not verdict(order(equal(x * y, BIG(1 / x**2)), x, oo), Dominated(parts), *given).holds
    near = Claim("near", x * y <= 2 / x, manifest, given=(x > 1, x < 9, y > 0, y <= 1 / x**2))
    assert not verdict(order(equal(x * y, BIG(1 / x)), x, oo), Dominated(near, low), *given).holds


def test_a_bound_depends_on_what_tends_alone() -> None:
    """1/x is no O(1/(xy)): at x = 2 it does not tend to 0."""
    given = (x > 1, y > 1)
    above = Claim("above", 1 / x <= 2 / x, manifest, given=given)
    below = Claim("below", 1 / x >= 0, manifest, given=given)
    says = order(equal(1 / x, BIG(1 / (x * y))), x * y, oo)
    assert not verdict(says, Dominated(above, below), *given).holds
    above = Claim("above", 1 / (x * y) <= 2 / (x * y), manifest, given=given)
    below = Claim("below", 1 / (x * y) >= 0, manifest, given=given)
    says = order(equal(1 / (x * y), BIG(1 / (x * y))), x * y, oo)
    assert verdict(says, Dominated(above, below), *given).holds


def test_a_part_is_cited_under_its_conditions_only() -> None:
    whole = Claim("whole", Tuple(x**2 > 0, x > -1), manifest, given=(x > 0,))
    assert verdict(x**2 > 0, all_of(whole), x > 1) is PROVED
    assert verdict(x**2 > 0, all_of(whole)) is UNDECIDED
    assert verdict(x**2 > 0, all_of(whole), x > -1) is UNDECIDED
    assert verdict(x**2 > 1, all_of(whole), x > 0) is UNDECIDED
    assert verdict(Tuple(x**2 > 0, Under(x > -1, Tuple(x > 3))), all_of(whole), x > 2) is PROVED
    assert verdict(Tuple(Under(x**2 > 0, Tuple(x > 3)), x > -1), all_of(whole)) is UNDECIDED


def test_each_part_needs_evidence_of_its_own() -> None:
    assert verdict(Tuple(x > 0, x**2 > 0), follows(manifest, manifest), x > 1) is PROVED
    assert verdict(Tuple(x > 0, x**2 > 2), follows(manifest, manifest), x > 1) is REFUTED
    assert verdict(Tuple(x > 0, x**2 > 0), follows(manifest), x > 1) is UNDECIDED
    under = Tuple(Under(x > 2, Tuple(x > 3)), x > 0)
    assert verdict(under, follows(manifest, manifest), x > 1) is PROVED
    assert verdict(
        Tuple(Under(x > 2, Tuple(x > 3)), x > 2), follows(manifest, manifest), x > 1
    ) is (REFUTED)


def test_a_refuted_claim_refutes_only_what_contains_it() -> None:
    true = Claim("true", x**2 > 0, manifest, given=(x > 0,))
    false = Claim("false", x > 1, manifest, given=(x > 0,))
    found = {one.label: judge(one, {}) for one in (true, false)}
    assert found["false"].verdict is REFUTED
    both = Claim("both", **jointly(true, false))
    assert judge(both, found).verdict is REFUTED
    one = Claim("one", x**2 > 0, all_of(true, false), given=(x > 0,))
    assert judge(one, found).verdict is UNDECIDED
    words = Claim("words", "x is not small.", in_words(true, false))
    assert judge(words, found).verdict is UNDECIDED
