"""sign(0) is 0 and atan2 is total but at the origin: what a proof at almost all points omits."""

from itertools import product

import pytest
import sympy
from cases import cases
from flint import arb, fmpq
from hypothesis import given as over
from hypothesis import settings
from hypothesis import strategies as st

import tresym
from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import angle, number, substitute
from tresym.reals.language.parsing import parse
from tresym.reals.language.sympy import from_sympy
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.normal.field import Field
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

PROVED, ENCLOSED = Verdict.PROVED, Verdict.ENCLOSED
REFUTED, UNDECIDED = Verdict.REFUTED, Verdict.UNDECIDED

VALUES = cases(__file__, "VALUES")


@pytest.mark.parametrize(("left", "right"), VALUES)
def test_values(left: str, right: str) -> None:
    assert decide(parse(left), parse(right)).verdict is PROVED
    with ball_precision(100):
        assert evaluate(parse(left), {}).overlaps(evaluate(parse(right), {}))


def test_values_of_balls() -> None:
    around = arb(0, fmpq(1, 100))
    with ball_precision(64):
        for value in (-1, 0, 1):
            assert evaluate(parse("sign(x)"), {"x": around}).contains(value)
        assert evaluate(parse("sign(x)"), {"x": arb(0)}) == 0
        for value in (-3, 3):
            assert evaluate(parse("atan2(x, -1)"), {"x": around}).contains(value)
        assert evaluate(parse("atan2(x, x)"), {"x": around}).is_nan()
        assert evaluate(parse("atan2(0, 0)"), {}).is_nan()


def test_sympy_means_the_same() -> None:
    x, y = sympy.symbols("x y", real=True)
    assert from_sympy(sympy.atan2(y, x)) == parse("atan2(y, x)") == angle(parse("y"), parse("x"))
    assert to_sympy(parse("atan2(y, x)")) == sympy.atan2(y, x)
    assert parse(str(parse("1 + 2*atan2(y, x - 1)"))) == parse("1 + 2*atan2(y, x - 1)")
    assert str(differentiate(parse("atan2(y, x)"), "y")) == str(parse("(x*1 - y*0)/(x**2 + y**2)"))
    assert tresym.check(sympy.Eq(sympy.sign(x) ** 2, 1, evaluate=False)).verdict is REFUTED


CLAIMS = [
    ("sign(x)**2 == 1", "", REFUTED),
    ("sign(x)**2 == 1", "x >= 0", REFUTED),
    ("sign(x)**2 == 1", "x > 0", PROVED),
    ("sign(x)**2 == 1", "x != 0", PROVED),
    ("sign(x)**3 == sign(x)", "", PROVED),
    ("sign(x)*abs(x) == x", "", PROVED),
    ("sign(x) == abs(x)/x", "", PROVED),  # defined where x is not 0
    ("sign(x)*log(x) == log(x)", "", PROVED),
    ("sign(x)**2*log(1 + x) == log(1 + x)", "", PROVED),
    ("sign(x)**2*log(2 + x) == log(2 + x)", "", REFUTED),
    ("sign(x)*sqrt(x - 1) == sqrt(x - 1)", "", PROVED),
    ("sign(x)*sqrt(x + 1) == sqrt(x + 1)", "x >= 0", REFUTED),
    ("sign(x*y) == sign(x)*sign(y)", "", PROVED),
    ("sign(x)**2 == 1", "x != 1", REFUTED),
    ("sign(x)**2 == 1", "x != -1", REFUTED),
    ("sign(x**2*(x - 1)) == sign(x - 1)", "x != 3", REFUTED),
    ("sign(abs(x - sin(1))) == 1", "x != 1", UNDECIDED),  # false at x = sin(1)
    ("sign(abs(x - sin(1))) == 1", "x != sin(1)", PROVED),
    ("sign(abs(x - sin(1))) == 1", "x > sin(1)", PROVED),
    ("sign(x**3 - x)**2 == 1", "x > 0", REFUTED),
    ("sign(x**3 - x)**2 == 1", "x > 1", PROVED),
    ("sign(tan(atan(x)))*cbrt(x**3) == abs(x)", "", PROVED),
    ("sign(x**2 - 2)**2 == 1", "", REFUTED),
    ("sign(x*y*sign(y)**2) == sign(x*y)", "", PROVED),
    ("sign(x*y)**2 == sign(x)**2", "", REFUTED),
    ("sign(x - y) == -sign(y - x)", "", PROVED),
    ("sign(x - y)**2 == 1", "x >= y", REFUTED),
    ("sign(x - y)**2 == 1", "x > y", PROVED),
    ("abs(x**2 - 2) == sign(x**2 - 2)*(x**2 - 2)", "", PROVED),
    ("sign(sin(x))**2 == 1", "", REFUTED),
    ("sign(t - pi)**2 == 1", "", UNDECIDED),  # false at no rational point
    ("sign(sin(x))**2 == 1", "0 < x < 3", PROVED),
    ("abs(x)*sign(x)**2 == abs(x)", "", PROVED),
    ("(1 + abs(x))*sign(x)**2 == 1 + abs(x)", "", REFUTED),
    ("atan2(y, x) + atan2(-y, x) == 0", "", REFUTED),
    ("atan2(y, x) + atan2(-y, x) == 0", "y > 0", PROVED),
    ("atan2(y, x) + atan2(-y, x) == 0", "x > 0", PROVED),
    ("atan2(y, x) + atan2(-y, x) == 0", "y >= 0", REFUTED),
    ("atan2(a*y, a*x) == atan2(y, x)", "a > 0", PROVED),
    ("atan2(y, x) == 2*atan(y/(sqrt(x**2 + y**2) + x))", "", PROVED),
    ("atan2(y, x) == atan(y/x)", "x > 0", PROVED),
    ("atan2(y, x) == pi/2 - atan(x/y)", "y > 0", PROVED),
    ("atan2(y, x) == sign(y)*acos(x/sqrt(x**2 + y**2))", "", UNDECIDED),  # false where y = 0
    ("sin(atan2(y, x)) == y/sqrt(x**2 + y**2)", "", PROVED),
    ("cos(atan2(y, x)/2)**2 == (1 + x/sqrt(x**2 + y**2))/2", "", PROVED),
    ("sin(atan2(y, x)/2) + sin(atan2(-y, x)/2) == 0", "", REFUTED),
    ("atan2(sin(t), cos(t)) == t", "-pi < t <= pi", PROVED),
    ("atan2(sin(t), cos(t)) == t", "-pi < t < pi", PROVED),
    ("atan2(sin(t), cos(t)) == t", "-pi <= t <= pi", UNDECIDED),
    ("atan2(sin(t), cos(t)) == t", "", REFUTED),
    ("atan2(y + abs(y), x) == 0", "y < 0", UNDECIDED),  # false where x < 0
    ("sign(x)**2 >= 1", "", REFUTED),
    ("2*sign(x)**2 >= 1", "x > 0", PROVED),
    ("sign(x)*x > 0", "", REFUTED),
    ("sign(x) != 0", "", REFUTED),
    ("sign(x - y) != 0", "", REFUTED),
    ("sign(x) > 0", "x >= 0", REFUTED),
    ("sign(x) >= 0", "x >= 0", PROVED),
    ("sign(x) + sign(-x) >= 0", "", PROVED),
    ("sign(x)**2 <= 1", "", PROVED),
    ("atan2(y, x) <= pi", "", ENCLOSED),
    ("atan2(y, x) < pi", "", REFUTED),
    ("atan2(y, x)**2 <= 10", "", ENCLOSED),
    ("abs(1 - 2*y) == 1 - 2*y", "sign(x)**2*y < 1/2", UNDECIDED),  # false where x = 0 and y = 1
]


@pytest.mark.parametrize(("claim", "given", "verdict"), CLAIMS)
def test_claims_that_jump(claim: str, given: str, verdict: Verdict) -> None:
    answer = tresym.check(claim, given=given)
    assert answer.verdict is verdict, answer
    assert (answer.witness is not None) is (verdict is REFUTED)


def test_the_witness_is_exact_and_inside_the_conditions() -> None:
    witness = tresym.check("atan2(x + 2*y - 1, y) < pi", given="x > 5").witness
    assert witness is not None
    x, y = (parse(witness[name]).args[0] for name in "xy")
    assert x > 5
    assert x + 2 * y - 1 == 0


def test_an_argument_that_vanishes_on_a_region_is_not_divided_by() -> None:
    field = Field(Given())
    (value,) = field.normal(parse("atan2(y + abs(y), x)"))
    assert [field.ring.at(i).kind for i in field.ring.used(value.num)] == ["opaque"]


def test_a_sign_on_the_open_domain_is_weak_at_jumps() -> None:
    assert sign(parse("sign(x)**2 - 1"), Given()) == "<=0"
    assert sign(parse("sign(x)**2 - 1"), Given.parse("x > 0")) == "0"
    assert sign(parse("x*sign(x) - abs(x)"), Given()) == "0"


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("sign(y)**2", "1"),
        ("abs(x - 1)*(1 - sign(y)**2)", "(x - 1)*(1 - sign(y)**2)"),  # false at the origin alone
    ],
)
def test_single_points_of_conditions_at_a_jump(left: str, right: str) -> None:
    """Where y is 0, x = 0 satisfies the condition and is no limit of other points."""
    found = decide(parse(left), parse(right), Given.parse("x**2*(x - 1) >= y"))
    assert found.verdict is UNDECIDED


ARGUMENTS = st.sampled_from(
    ("x", "y", "-x", "x - 1", "x + y", "x*y", "x**2 - 1", "abs(x)", "y + abs(y)", "1", "0", "-1")
)
JUMPING = st.one_of(
    st.builds("sign({})".format, ARGUMENTS),
    st.builds("atan2({}, {})".format, ARGUMENTS, ARGUMENTS),
    st.sampled_from(("x", "abs(x)", "y", "2", "sqrt(x)", "1/x", "log(abs(y))")),
)
PRODUCTS = st.builds("{}*{}".format, JUMPING, JUMPING)
REWRITTEN = st.sampled_from(
    (
        ("sign(", "-sign(-"),
        ("sign(", "1/sign("),
        ("sign(", "2 - 2*sign(x)**2 + sign("),
        ("atan2(", "-atan2(-"),
        ("atan2(", "sign(y)**2*atan2("),
        ("atan2(", "pi - sign(x)**2*pi + atan2("),
        ("sqrt(x)", "sign(x)*sqrt(x)"),
        ("abs(x)", "x*sign(x)"),
    )
)
GRID = [fmpq(p, 2) for p in (0, 2, -2, 1, -1, 4, -5)]


@over(
    PRODUCTS,
    PRODUCTS,
    REWRITTEN,
    st.sampled_from(("", "x >= 0", "x > 0", "y >= 0", "-1 <= x <= 1")),
)
@settings(max_examples=40)
def test_what_holds_holds_at_zeros_too(
    one: str, two: str, rule: tuple[str, str], given: str
) -> None:
    left = f"{one} + {two}"
    right = left.replace(*rule)
    answer = tresym.check(f"{left} == {right}", given=given)
    for x, y in product(GRID, repeat=2):
        at = {"x": number(x), "y": number(y)}
        with ball_precision(100):
            balls = {name: evaluate(value, {}) for name, value in at.items()}
            inside = all(c.holds_exactly(balls) for c in Given.parse(given).conditions)
            u, v = (evaluate(substitute(parse(side), at), {}) for side in (left, right))
        if answer and inside and u.is_finite() and v.is_finite():
            assert u.overlaps(v), (left, right, x, y)


def test_a_polynomial_that_is_zero_where_its_range_is_a_point_has_no_sign() -> None:
    angle = "atan2(x*abs(y), y+1)*sign(x**2-1)*sign(-x)"
    other = "sign(x*abs(y))*(pi/2-atan((y+1)/abs(x*abs(y))))*sign(x**2-1)*sign(-x)"
    assert tresym.check(f"atan({angle}) <= atan({other})", given="y <= 0, x < 0") is not None


@pytest.mark.parametrize("right", ["sign(x)**2", "sign(y)**2"])
def test_each_zero_of_a_product_is_a_jump(right: str) -> None:
    """Both sides are 0 where the one is zero, and not where the other is alone."""
    assert decide(parse("sign(x*y)**2"), parse(right)).verdict is not PROVED
    assert decide(parse("sign(x*y)"), parse("sign(x)*sign(y)")).verdict is PROVED
