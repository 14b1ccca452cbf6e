"""Branches, domains and planted falsehoods: what must be proved, refuted, or neither."""

import pytest

from tresym.reals.decisions.identity import decide, decide_continuous
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.verdict import Verdict

TRUE = [
    ("sqrt(x^2)", "x", "x>=0"),
    ("sqrt(x^2)", "-x", "x<0"),
    ("sqrt(x^4)", "x^2", ""),
    ("(x^2)**(1/4)", "sqrt(abs(x))", ""),
    ("(x^3)**(1/3)", "x", ""),
    ("cbrt(x^3)", "x", ""),
    ("cbrt(x)^3", "x", ""),
    ("abs(x)^3", "(x^2)**(3/2)", ""),
    ("sqrt(x-1)*sqrt(x-2)", "sqrt((x-1)*(x-2))", ""),
    ("sqrt(1-x)*sqrt(2-x)", "sqrt((x-1)*(x-2))", ""),
    ("sqrt((x-1)*(x-2))/(x-1)", "sqrt((x-2)/(x-1))", "x>2"),
    ("sqrt((x-1)*(x-2))/(x-1)", "-sqrt((x-2)/(x-1))", "x<1"),
    ("log(x^2)", "2*log(x)", ""),
    ("log(x^2)", "2*log(abs(x))", ""),
    ("log(x*y)", "log(x)+log(y)", ""),
    ("log(x*y)", "log(-x)+log(-y)", ""),
    ("atan(x)+atan(1/x)", "pi/2", "x>0"),
    ("atan(x)+atan(1/x)", "-pi/2", "x<0"),
    ("atan(x)+atan(1/x)", "pi/2*abs(x)/x", ""),
    ("2*atan(x)", "atan(2*x/(1-x^2))", "-1<x<1"),
    ("2*atan(x)", "atan(2*x/(1-x^2))+pi", "x>1"),
    ("2*atan(x)", "atan(2*x/(1-x^2))-pi", "x<-1"),
    ("asin(x)", "acos(sqrt(1-x^2))", "x>=0"),
    ("asin(2*x*sqrt(1-x^2))", "2*asin(x)", "-7/10<x<7/10"),
    ("acos(x)", "pi-acos(-x)", ""),
    ("acos(2*x^2-1)", "2*acos(x)", "x>=0"),
    ("acos(2*x^2-1)", "2*pi-2*acos(x)", "x<0"),
    ("atan(tan(x))", "x", "-pi/2<x<pi/2"),
    ("sin(asin(x))", "x", ""),
    ("cos(acos(x))", "x", ""),
    ("tan(atan(x))", "x", ""),
    ("asin(3*x-4*x^3)", "3*asin(x)", "-1/2<x<1/2"),
    ("atan(x)+atan(y)", "atan((x+y)/(1-x*y))", "x>0,y>0,x*y<1"),
    ("atan(x)+atan(y)", "atan((x+y)/(1-x*y))+pi", "x>0,y>0,x*y>1"),
    ("x/x", "1", ""),
    ("exp(log(x))", "x", ""),
    ("log(exp(x))", "x", ""),
    ("sqrt(a^2*b)", "a*sqrt(b)", "a>0"),
    ("sqrt(b/a)", "sqrt(a*b)/a", "a>0"),
    ("sqrt(b/a)", "sqrt(a*b)/abs(a)", ""),
    ("sqrt(b^2+2*a*b+a^2)", "a+b", "b>0,a>0"),
    ("sqrt((a-b)^2)", "b-a", "a<b"),
    ("x**(1/2)*x**(1/3)", "x**(5/6)", ""),
    ("(x*y)**(1/3)", "x**(1/3)*y**(1/3)", ""),
    ("(x*y)**a", "x**a*y**a", ""),
    ("(x**a)**b", "x**(a*b)", ""),
    ("exp(x)**a", "exp(a*x)", ""),
    ("(x^2)**a", "x**(2*a)", ""),
    ("(x^2)**a", "abs(x)**(2*a)", ""),
    ("asinh(sinh(x))", "x", ""),
    ("atanh(tanh(x))", "x", ""),
    ("acosh(cosh(x))", "x", "x>0"),
    ("acosh(x)", "-log(x-sqrt(x^2-1))", ""),
    ("sqrt(1-sin(x)^2)", "cos(x)", "-pi/2<x<pi/2"),
    ("sqrt(1-sin(x)^2)", "abs(cos(x))", ""),
    ("sqrt((1-cos(x))/2)", "abs(sin(x/2))", ""),
    ("sqrt((1-cos(x))/2)", "sin(x/2)", "0<x<2*pi"),
    ("sin(pi*abs(x)/x)", "0", ""),
    ("cos(pi*abs(x)/x)", "-1", ""),
    ("cos(pi*abs(x)/x/2)", "0", ""),
    ("sign(x)*abs(x)", "x", ""),
    ("abs(x)+x", "0", "x<0"),
    ("(x^2-1)/(x-1)", "x+1", ""),
    ("16*atan(1/5)-4*atan(1/239)", "pi", ""),
    ("atan(1/2)+atan(1/3)", "pi/4", ""),
    ("atan(1)+atan(2)+atan(3)", "pi", ""),
    ("sqrt(5+2*sqrt(6))", "sqrt(2)+sqrt(3)", ""),
    ("cbrt(2+sqrt(5))+cbrt(2-sqrt(5))", "1", ""),
    ("sqrt(2+sqrt(3))", "(sqrt(6)+sqrt(2))/2", ""),
    ("cos(pi/7)*cos(2*pi/7)*cos(3*pi/7)", "1/8", ""),
    ("cos(2*pi/5)", "(sqrt(5)-1)/4", ""),
    ("tan(pi/5)", "sqrt(5-2*sqrt(5))", ""),
    ("tan(3*pi/11)+4*sin(2*pi/11)", "sqrt(11)", ""),
    ("sin(pi/5+x)", "sin(pi/5)*cos(x)+cos(pi/5)*sin(x)", ""),
    ("log(3)+log(5)", "log(15)", ""),
    ("log(8)/log(2)", "3", ""),
    ("log(sqrt(2)+1)+log(sqrt(2)-1)", "0", ""),
    ("2*asinh(1/2)", "asinh(sqrt(5)/2)", ""),
    ("sqrt(x^2*(x-1))", "x*sqrt(x-1)", ""),
    ("sqrt(x+1)-sqrt(x)", "1/(sqrt(x+1)+sqrt(x))", ""),
    ("1/(sqrt(x^2)-x)", "-1/(2*x)", ""),
    ("1/(sqrt(x^2)+x)", "1/(2*x)", ""),
    ("abs(log(x))", "log(x)", "x>1"),
    ("abs(sin(x))", "sin(x)", "0<x<pi"),
    ("abs(atan(x))", "atan(abs(x))", ""),
    ("asin(x)+asin(sqrt(1-x^2))", "pi/2", "x>0"),
    ("atan(x/sqrt(1-x^2))", "asin(x)", ""),
    ("acos(x)", "atan(sqrt(1-x^2)/x)", "x>0"),
    ("2*atan(exp(x))-pi/2", "atan(sinh(x))", ""),
    ("2*atan(tanh(x/2))", "asin(tanh(x))", ""),
    ("atan(exp(x))+atan(exp(-x))", "pi/2", ""),
    ("atan((1+x)/(1-x))", "atan(x)+pi/4", "x<1"),
    ("atan((1+x)/(1-x))", "atan(x)-3*pi/4", "x>1"),
    ("atan(2*tan(x))", "atan(2*tan(x))+0*x", ""),
    ("asin((x-1)/(x+1))", "2*atan(sqrt(x))-pi/2", ""),
    ("log((1+sin(x))/(1-sin(x)))/2", "log(abs(sec(x)+tan(x)))", ""),
    ("log(abs(tan(x/2+pi/4)))", "log(abs(sec(x)+tan(x)))", ""),
    ("x**0", "1", ""),
    ("2**x*3**x", "6**x", ""),
    ("4**x", "2**(2*x)", ""),
    ("x**(1/2)", "sqrt(x)", ""),
    ("sqrt(x*y)*sqrt(y*z)*sqrt(x*z)", "abs(x*y*z)", ""),
    ("sqrt(3+sqrt(5))", "(1+sqrt(5))/sqrt(2)", ""),
    ("sqrt(x+1-2*sqrt(x))", "abs(sqrt(x)-1)", ""),
    ("sqrt(x+2*sqrt(x-1))", "1+sqrt(x-1)", ""),
    ("sqrt(a+sqrt(a^2-b^2))", "(sqrt(a+b)+sqrt(a-b))/sqrt(2)", "a>b,b>0"),
    ("sqrt(asinh(2))", "sqrt(atanh(2/sqrt(5)))", ""),
    ("acos(sqrt(6*x/5))", "2*atan(sqrt((1-sqrt(6*x/5))/(1+sqrt(6*x/5))))", ""),
    ("abs(acos(x))", "acos(x)", ""),
    ("abs(2*pi-3*asin(x))", "2*pi-3*asin(x)", ""),
    ("exp(abs(x)-1)*exp(1)", "exp(abs(x)/2)^2", ""),
    ("sin(abs(x)+y)", "sin(abs(x))*cos(y)+cos(x)*sin(y)", ""),
    ("sin(pi/2-x/(2+2*x))", "cos(x/(x+1)/2)", ""),
    ("sign(abs(x)*x)", "sign(x)", ""),
    ("diff(x*cos(b*log(c*x**n))+b*n*x*sin(b*log(c*x**n)),x)/(1+b^2*n^2)", "cos(b*log(c*x**n))", ""),
    ("diff(x*(a*(b*x**n)**p)**q,x)", "(1+n*p*q)*(a*(b*x**n)**p)**q", ""),
    ("tan(atan(sqrt(pi+x)))*cos(atan(sqrt(pi+x)))", "sqrt(pi+x)/sqrt(pi+x+1)", ""),
    ("log(log(x)+log(y))", "log(log(x*y))", "x>1,y>1"),
    ("sin(log(x)*log(y))^2+cos(log(x)*log(y))^2", "1", ""),
    ("cos(atan(x)*log(y)+pi)", "-cos(atan(x)*log(y))", ""),
]
"""Proved: the two sides are equal wherever both are defined."""

FALSE = [
    ("sqrt(x^2-2*x+1)", "x-1", "x>=1-1/10^30"),  # on a short stretch alone
    ("sqrt(x^2)", "x", ""),
    ("(x^2)**(3/2)", "x^3", ""),
    ("sqrt((x-1)*(x-2))/(x-1)", "sqrt((x-2)/(x-1))", ""),
    ("log(x/y)", "log(x)-log(y)+1/10^50", ""),
    ("log(2*x)", "log(x)", ""),
    ("log(x+1)", "log(x)+1", ""),
    ("atan(x)+atan(1/x)", "pi/2", ""),
    ("2*atan(x)", "atan(2*x/(1-x^2))", ""),
    ("2*atan(x)", "atan(2*x/(1-x^2))", "x>1"),
    ("asin(x)", "acos(sqrt(1-x^2))", ""),
    ("asin(2*x*sqrt(1-x^2))", "2*asin(x)", ""),
    ("asin(2*x*sqrt(1-x^2))", "2*asin(x)", "0<x<8/10"),
    ("acos(-x)", "acos(x)", ""),
    ("acos(2*x^2-1)", "2*acos(x)", ""),
    ("asin(sin(x))", "x", ""),
    ("atan(tan(x))", "x", ""),
    ("asin(3*x-4*x^3)", "3*asin(x)", ""),
    ("atan(x)+atan(y)", "atan((x+y)/(1-x*y))", ""),
    ("atan(x)+atan(y)", "atan((x+y)/(1-x*y))", "x>0,y>0"),
    ("x", "x+1/10^60", ""),
    ("sin(x)^2+cos(x)^2", "1+1/10^60", ""),
    ("exp(x)", "(1+x/10^40)**(10)", ""),
    ("sqrt(a^2*b)", "a*sqrt(b)", ""),
    ("sqrt(b/a)", "sqrt(a*b)/a", ""),
    ("sqrt(b^2+2*a*b+a^2)", "a+b", "b>0"),
    ("sqrt((a-b)^2)", "a-b", "a<b"),
    ("acosh(cosh(x))", "x", ""),
    ("acosh(x)", "log(x-sqrt(x^2-1))", ""),
    ("sqrt(1-sin(x)^2)", "cos(x)", ""),
    ("sqrt(1-sin(x)^2)", "cos(x)", "0<x<pi"),
    ("sqrt((1-cos(x))/2)", "sin(x/2)", ""),
    ("sin(pi*abs(x)/x/2)", "1", ""),
    ("sign(x)", "1", ""),
    ("4*atan(1/5)-atan(1/239)", "pi/2", ""),
    ("atan(1)+atan(2)+atan(3)", "0", ""),
    ("sqrt(2)+sqrt(3)", "sqrt(10)", ""),
    ("exp(pi*sqrt(163))", "640320^3+744", ""),
    ("1/(sqrt(x^2)-x)", "1/(2*x)", ""),
    ("abs(log(x))", "log(x)", ""),
    ("asin(x)+asin(sqrt(1-x^2))", "pi/2", ""),
    ("acos(x)", "atan(sqrt(1-x^2)/x)", ""),
    ("atan((1+x)/(1-x))", "atan(x)+pi/4", ""),
    ("sqrt(x*y)*sqrt(y*z)*sqrt(x*z)", "x*y*z", ""),
    ("sqrt(3+sqrt(5))", "(1-sqrt(5))/sqrt(2)", ""),
    ("sqrt(x+1-2*sqrt(x))", "sqrt(x)-1", ""),
    ("sqrt(x+1-2*sqrt(x))", "1-sqrt(x)", ""),
    ("sqrt(a+sqrt(a^2-b^2))", "(sqrt(a+b)-sqrt(a-b))/sqrt(2)", "a>b,b>0"),
    ("abs(pi-3*atan(x))", "pi-3*atan(x)", ""),
    ("atan(1/(sqrt(x+1)-1))+atan(sqrt(x+1)-1)", "pi/2", ""),
    ("atan((x+2-2*sqrt(x+1))/x)+atan(x/(x+2-2*sqrt(x+1)))", "pi/2", ""),
    ("cos(atan(x)+atan(1/x))", "1", ""),
    ("sin(atan(x)+atan(1/x)+log(y)-log(2*y))", "cos(log(2*y)-log(y))", ""),
    ("exp(abs(x)-1)", "exp(x-1)", ""),
]
"""Refuted, with a witness."""

NEITHER = [
    ("1/(x-x)", "1/(x-x)", ""),
    ("sqrt(-1-x^2)", "sqrt(-1-x^2)", ""),
    ("log(-1-x^2)", "x", ""),
    ("x", "x+1", "x>0, x<0"),
    ("x", "x", "x>0, x<0"),
    ("sqrt(-x^2)", "0", ""),
    ("x", "x", "x>=0, x<=0"),
    ("sqrt(x)*sqrt(-x)", "0", ""),
    ("sqrt(atan(x)+atan(1/x)-pi/2)", "0", ""),
    ("(-x)**(1/3)", "-(x**(1/3))", ""),
]
"""Nowhere defined, conditions that nothing satisfies, or outside the procedure: never proved."""


def claim(left: str, right: str, given: str) -> Verdict:
    return decide(parse(left), parse(right), Given.parse(given)).verdict


@pytest.mark.parametrize(("left", "right", "given"), TRUE)
def test_proved(left: str, right: str, given: str) -> None:
    assert claim(left, right, given) is Verdict.PROVED


@pytest.mark.parametrize(("left", "right", "given"), FALSE)
def test_refuted(left: str, right: str, given: str) -> None:
    decision = decide(parse(left), parse(right), Given.parse(given))
    assert decision.verdict is Verdict.REFUTED
    assert decision.witness is not None
    assert decision.values is not None
    assert not decision.values[0].overlaps(decision.values[1])


@pytest.mark.parametrize(("left", "right", "given"), NEITHER)
def test_never_vacuously_proved(left: str, right: str, given: str) -> None:
    assert claim(left, right, given) is Verdict.UNDECIDED


VANISHING = [
    "1 + abs(x)/x",
    "abs(x) + x",
    "pi/2 - atan(x) - atan(1/x)",
    "sqrt(x - 2*sqrt(x - 1)) - sqrt(x - 1) + 1",
    "asin(sin(x)) - x",
    "pi/2 - x - atan(cot(x))",
    "atan(x + abs(x))",
    "log(1 + x + abs(x))",
    "1 + cos(2*(x + atan(cot(x)))/3)",
    "4*atan(1/2) + 4*atan(1/3) - pi",
    "exp(atan(1/2)*x + atan(1/3)*x) - exp(pi*x/4)",
]
"""Zero on a whole region, and not zero: a radicand with it says nothing of its other factors."""


@pytest.mark.slow
@pytest.mark.parametrize("factor", VANISHING)
def test_a_factor_that_vanishes_on_a_region_implies_nothing(factor: str) -> None:
    roots = f"sqrt(({factor})*y) + sqrt(({factor})*z)"
    assert claim(f"{roots} + abs(y*z)", f"{roots} + y*z", "") is not Verdict.PROVED
    assert claim(f"{roots} + abs(y)", f"{roots} + y", "") is not Verdict.PROVED
    # nor does an even power, or a root, whose sign is known
    for even in (f"({factor})**2", f"sqrt({factor})"):
        root = f"sqrt({even}*y)"
        assert claim(f"{root} + abs(y)", f"{root} + y", "") is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right"),
    [
        # what is inverted on the way is no denominator of the claim
        ("atan(x + 50 + abs(x + 50))", "atan(2*x + 100)"),
        ("abs(x - 9)", "9 - x + 0*atan(abs(x - 9) + 9 - x)"),
        ("asec(1 + (x + 5) + abs(x + 5))", "asec(1 + 2*(x + 5))"),
        ("asin(1 - x - abs(x)) + x", "asin(1 - x - abs(x)) + abs(x)"),
        ("sqrt(atan(x + abs(x))) + x", "sqrt(atan(x + abs(x))) + abs(x)"),
        # the slopes have no value where the claim fails
        *(
            (f"{root} + (abs(x + 50) - x - 50)*(x + 51)", root)
            for root in (
                "sqrt(x + 50 + abs(x + 50))",
                "cbrt(x + 50 + abs(x + 50))",
                "acosh(1 + x + 50 + abs(x + 50))",
                "abs(x + 50 + abs(x + 50))",
            )
        ),
    ],
)
def test_nothing_is_learnt_where_the_claim_is_defined_and_a_slope_is_not(
    left: str, right: str
) -> None:
    assert claim(left, right, "") is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right", "given", "verdict"),
    [
        ("2*atan(x)", "atan(2*x/(1 - x**2))", "-1 < x < E/2", None),
        ("atan(x) + atan(2)", "atan((x + 2)/(1 - 2*x))", "x < log(2)", None),
        ("2*atan(x)", "atan(2*x/(1 - x**2))", "-1 < x < E/3", Verdict.PROVED),
        ("atan(x) + atan(2)", "atan((x + 2)/(1 - 2*x))", "x < log(3/2)", Verdict.PROVED),
        ("2*atan(x) + pi", "atan(2*x/(1 - x**2))", "-E < x < -sqrt(3)/2, x != -1", None),
        ("atan(x) + atan(1/x)", "pi/2", "0 < x < E", Verdict.PROVED),
        ("atan(x) + atan(1/x)", "pi/2", "-1/E < x", None),
        ("atan(x) + atan(y)", "atan((x + y)/(1 - x*y))", "x < E, y < E", None),
        ("atan(x) + atan(y)", "atan((x + y)/(1 - x*y))", "x < log(2), y < log(2)", None),
        ("acos(cos(x))", "x", "0 <= x <= pi", Verdict.PROVED),
        ("acos(cos(x))", "-x", "-pi <= x <= 0", Verdict.PROVED),
        ("atan(cot(x))", "pi/2 - x", "0 < x < pi", Verdict.PROVED),
        ("acos(cos(x))", "x", "0 <= x <= 3*pi/2", None),
    ],
)
def test_a_bound_that_is_not_rational(
    left: str, right: str, given: str, verdict: Verdict | None
) -> None:
    """It cuts regions too; None is whatever is not PROVED."""
    found = claim(left, right, given)
    assert found is verdict if verdict else found is not Verdict.PROVED


def test_a_constant_is_as_wide_as_its_ball() -> None:
    """exp(25) − 72004899337 loses most of the digits of the ball it is first seen in."""
    constant = "log(exp(25) - 72004899337) + 0.9522484"
    left, right = f"abs(x - ({constant}))", f"x - ({constant})"
    assert claim(left, right, "x > 0") is not Verdict.PROVED
    assert claim(left, right, "x > 1") is Verdict.PROVED


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("x + 2 - 2*sqrt(x + 1)", 0),  # a square that vanishes at 0
        ("x + 3 - 2*sqrt(x + 1)", 1),
        ("(x - y)**2*(1 + x**2)", 0),
        ("1 + x**2 + y**2", 1),
    ],
)
def test_what_may_vanish_on_a_wall_is_not_definite(text: str, sign: int) -> None:
    field = Field(Given.parse("x > -1"))
    (value,) = field.normal(parse(text))
    assert field.definite(value.num) == sign


AT_JUMPS = [
    ("sign(x)**2", "1"),
    ("sign(x)**2*y", "y"),
    ("sign(x)**2 + sign(y)**2", "2"),
    ("x*sign(x) + sign(y)**2", "abs(x) + 1"),
    ("y*sign(y) + sign(x)**2", "abs(y) + 1"),
    ("sign(x*y)**2", "1"),
    ("atan2(y, x) + atan2(-y, x)", "0"),
    ("sign(x - 1/3)*sign(x - 1/3)", "1"),
    ("sign(x)*sign(x - 1)*sign(x)*sign(x - 1)", "1"),
]
"""True but where a function jumps, at one place or at one of several."""


@pytest.mark.parametrize(("left", "right"), AT_JUMPS)
def test_what_holds_off_the_jumps_alone_is_not_proved(left: str, right: str) -> None:
    for decider in (decide, decide_continuous):
        assert decider(parse(left), parse(right)).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right"), [("x*sign(x)", "abs(x)"), ("sign(x)**3", "sign(x)"), ("sign(x)*abs(x)", "x")]
)
def test_what_holds_at_the_jumps_too_is(left: str, right: str) -> None:
    assert decide(parse(left), parse(right)).verdict is Verdict.PROVED


def test_where_a_side_may_jump_the_ledger_has_no_answer() -> None:
    asked = parse("sign(x - sqrt(2))**3"), parse("sign(x - sqrt(2))")
    assert decide_continuous(*asked).verdict is Verdict.UNDECIDED
    assert decide_continuous(*asked, Given.parse("x < 1")).verdict is Verdict.PROVED


ALONE = ["x**2*(x - 1) >= 0", "sqrt(x**2*(x - 1)) < 5", "x**2*(x - 1) >= 0, y**2*(y - 1) >= 0"]


@pytest.mark.parametrize("given", ALONE)
def test_conditions_that_hold_at_a_point_alone_prove_nothing_by_what_holds_beside_it(
    given: str,
) -> None:
    """At x = 0 the left side is 1 and the right side −1."""
    for decider in (decide, decide_continuous):
        found = decider(parse("sqrt((x - 1)**2)"), parse("x - 1"), Given.parse(given))
        assert found.verdict is Verdict.UNDECIDED
        assert "isolated points" in found.why


@pytest.mark.parametrize("given", ALONE)
def test_such_conditions_do_no_harm_where_the_others_are_enough(given: str) -> None:
    for left, right, more in (("sqrt((x - 1)**2)", "x - 1", ", x > 1"), ("x + x", "2*x", "")):
        found = decide(parse(left), parse(right), Given.parse(given + more))
        assert found.verdict is Verdict.PROVED


def test_one_such_condition_is_not_left_in_when_the_others_are_dropped() -> None:
    given = Given.parse("sign(x)**2*(x - 5) > -1/2, x**2*(x - 2) >= 0")
    found = decide(parse("sqrt((x - 1)**2)"), parse("x - 1"), given)
    assert found.verdict is Verdict.UNDECIDED
