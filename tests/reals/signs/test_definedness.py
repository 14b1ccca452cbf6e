"""Where expressions are defined, or smooth, at every point: what is shown, and what is not."""

import pytest

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.signs.definedness import continuous_on, is_lasting, undefined
from tresym.reals.signs.sign import proof

# an expression, conditions that show it defined, and weaker ones that do not
TABLE = [
    ("1/x", "x > 0", "x >= 0"),
    ("1/(x**2 + 1)", "", None),
    ("1/(x - y)", "x > y", "x >= y"),
    ("sqrt(x)", "x >= 0", ""),
    ("1/sqrt(x)", "x > 0", "x >= 0"),
    ("log(1 - x)", "x < 1", "x <= 1"),
    ("x**y", "x > 0", "x >= 0"),
    ("asin(x)", "x <= 1, x >= -1", "x <= 1"),
    ("acos(x*y)", "x**2*y**2 <= 1", "x*y <= 1"),
    ("atanh(x)", "x < 1, x > -1", "x <= 1, x > -1"),
    ("atanh(x)", "x**2 < 1", "x**2 <= 1"),
    ("acosh(x)", "x >= 1", "x >= 0"),
    ("sign(x)", "", None),
    ("coth(x)", "x > 0", "x >= 0"),
    ("1/(2 + cos(x))", "", None),
    ("tan(x)", "cos(x) != 0", "sin(x) != 0"),
    ("cot(x)", "sin(x) != 0", "x > 0"),
    ("sec(x)", "cos(x) > 0", "x > 0"),
    ("sin(log(x))", "x > 0", "x >= 0"),
    ("sin(1/(1 + sqrt(x)))", "x >= 0", ""),
    ("atan2(y, x)", "y > 0", "x**2 >= y**2"),
    ("1/(x*y)", "x > 0, y < 0", "x > 0, y <= 0"),
    ("1/(x**2 - 2*x + 1)", "x != 1", "x != -1"),
    ("1/(x**2 - 1)", "x != 1, x != -1", "x != 1"),
    ("1/(x**2 - 1)", "x**2 != 1", None),
    # what is shown of almost all points says nothing of each one
    ("1/(sqrt(x**2) + x)", None, "x != 0"),
    ("1/(sin(x)**2 + cos(x)**2 - y)", None, "y != 1"),
    ("x**(y - 1)", None, "y > 1"),
    ("exp(1/log(x))", None, "x > 0"),
    ("sqrt(x - 1)", None, "x**2*(x - 1) >= 0"),
]


@pytest.mark.parametrize(("text", "enough", "_"), TABLE)
def test_what_is_defined(text: str, enough: str | None, _: object) -> None:
    assert enough is None or undefined(parse(text), Given.parse(enough)) is None


@pytest.mark.parametrize(("text", "_", "weaker"), TABLE)
def test_what_is_not_shown(text: str, _: object, weaker: str | None) -> None:
    for prover in (None, proof):
        assert weaker is None or undefined(parse(text), Given.parse(weaker), prover) is not None


def test_every_method_may_be_asked() -> None:
    """That exp(x) is above 1 + x is a matter for Taylor's theorem."""
    e, given = parse("log(exp(x) - 1 - x)"), Given.parse("0 < x < 1")
    assert undefined(e, given) is not None
    assert undefined(e, given, proof) is None


@pytest.mark.parametrize(
    ("text", "conditions", "smooth"),
    [
        ("sqrt(x)", "x > 0", True),
        ("sqrt(x)", "x >= 0", False),
        ("x**(1/3)", "x >= 0", False),
        ("cbrt(x)", "", False),
        ("1/x", "x > 0", True),
        ("1/x", "x >= 0", False),
        ("abs(x)", "x > 0", True),
        ("abs(x)", "", False),
        ("sign(x)", "x > 0", True),
        ("sign(x)", "", False),
        ("asin(x)", "x < 1, x > -1", True),
        ("asin(x)", "x <= 1, x >= -1", False),
        ("acosh(x)", "x >= 1", False),
        ("atan2(y, x)", "x > 0", True),
        ("atan2(y, x)", "x**2 + y**2 > 0", False),
        ("exp(sin(x))", "", True),
    ],
)
def test_smooth_is_more_than_defined(text: str, conditions: str, smooth: bool) -> None:
    assert (continuous_on(parse(text), Given.parse(conditions)) is None) is smooth


@pytest.mark.parametrize(
    ("e", "lasting"),
    [
        ("1/(n + 1)", True),
        ("1/(n - 5)", False),
        ("1/(x - 5)", True),  # for all n, or for none
        ("x**n/(1 - x)", True),
        ("x**n/(n + x + 1)", False),  # x may be negative
        ("(n - 5)**n", False),
        ("(-1)**n", True),
        ("1/S", False),
        ("sqrt(n - x)", False),
        ("log(factorial(n))", True),
        ("1/(factorial(n) - 1)", False),
        ("factorial(n + 1)/(n + 1)", True),
        ("factorial(n - 2)", False),
        ("1/(factorial(n + 1) - factorial(n))", False),
        ("f(n)", True),
        ("log(f(n))", False),
        ("1/f(n + 1)", False),
        ("f(sqrt(n - 5))", False),
        ("f(x)", True),
        ("integral(t**n, t, 0, 1)", False),
        ("integral(t*x, t, 0, 1)", True),
    ],
)
def test_whether_something_is_said_of_every_n(e: str, lasting: bool) -> None:
    given = Given(((parse("n"), ">=", parse("0")),))
    (claim,) = read(f"{e} == 0").comparisons
    assert is_lasting((claim.left,), given, "n", "S") is lasting


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("asin(R/R) == pi/2", "PROVED"),
        ("asin(R/R) == pi", "REFUTED"),
        ("acosh(x/x) == 0", "PROVED"),
        ("sqrt(x - x) + y == y", "PROVED"),
        ("sqrt(x - abs(x)) == 0 given x > 0", "PROVED"),
        ("sqrt(x - abs(x)) == 1", "UNDECIDED"),
        ("asin(x/x + 1/10) == pi/2", "UNDECIDED"),
        ("asin(x/x)/(y - y) == pi/2", "UNDECIDED"),  # still nowhere defined
        ("sqrt(x - x)/sqrt(x - x) == 1", "UNDECIDED"),
        ("acos(x/x) == 0 given x < 0, x > 0", "UNDECIDED"),
        ("asin(sign(x)) == pi/2", "REFUTED"),  # 1 on one side alone
        ("asin(x/x) >= 2", "REFUTED"),
        ("integral(sqrt(R**2 - x**2), x, 0, R) == pi*R**2/4 given R > 0", "PROVED"),
        ("integral(sqrt(R**2 - x**2), x, 0, R) == pi*R**2/2 given R > 0", "REFUTED"),
    ],
)
def test_an_operand_at_the_end_of_the_domain_everywhere(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict
