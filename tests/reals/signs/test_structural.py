"""Signs at every single point, and what is false at one and must not be proved."""

import pytest
from falsehoods import is_false_at, read
from flint import arb

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import symbols
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.structural import Parts

PINNED = "b > 0, y > -b, x >= y, x <= y"
STABLE = "0 < a, a < b, b < c, (b - a)/(a*b)*(u**2 - x**2) + (c - a)/(a*c)*(v**2 - y**2) >= 0"
SIGNS = [
    # conditions taken out of a sum, and multiples of them
    ("x + b", PINNED, "+"),
    ("x + y + 2*b", PINNED, "+"),
    ("b*(x + b)", PINNED, "+"),
    ("y - x", PINNED, ">=0"),
    ("z - x", "y > x, z >= y", "+"),
    ("1 - a*b", "a > 0, b > 0, b*(a + 2) <= 1", "+"),
    ("b/(a + b) - x**2", "a > 0, b > 0, b/(a + b) > y**2, y**2 >= x**2", "+"),
    ("y**2 - x**2", "(x - y)*(-y - x) >= 0", ">=0"),
    ("(c - a)*b/(c*(b - a))*(u**2 + v**2) - x**2 - y**2", STABLE, ">=0"),
    # 0 to the power 0 is 1
    ("(0/y)**0", "y != 0", "+"),
    ("y**2*(x - x)**0", "y != 0", "+"),
    ("x**0", "", "+"),
    # by form, whatever the inner sign; the product of two conditions
    ("(a + b*x)**2 + 1", "", "+"),
    ("(a + b*x)**2 + abs(x)", "", ">=0"),
    ("1 - (a + b*x)**2", "1 - (a + b*x) > 0, 1 + (a + b*x) > 0", "+"),
    ("1 - (a + b*x)**2", "1 - (a + b*x) >= 0, 1 + (a + b*x) >= 0", ">=0"),
    # at once, without the signs of what is squared
    ("a + b*sin(x)**2", "a > 0, b > 0", "+"),
    ("x**2*sin(y)**2 + w*cos(z)**4", "w >= 0", ">=0"),
    ("-a*sqrt(u - v)/b**2", "a > 0", "<=0"),
    ("1/x**3", "x <= 0", "-"),
    ("(x - y)**(-1)", "x >= y", "+"),
    # half turns
    ("sin(x)", "e > 0, e < pi/2, x >= e, x <= pi - e", "+"),
    ("sin(x)", "0 <= x, x <= pi", ">=0"),
    ("sin(x)", "-pi < x, x < 0", "-"),
    ("cos(x)", "pi/2 <= x, x <= pi", "<=0"),
    ("cos(x)", "0 <= x, x <= c, c < pi/2", "+"),
    # squares of sines and cosines, denominators, powers of roots
    ("1 - cos(x)**2", "sin(x) > 0", "+"),
    ("1 - b/(a + b)*cos(x)**2", "a > 0, b > 0, b <= 1", "+"),
    ("1 - a/(a + b)*sqrt(b/a)**2", "a > 0, b > 0", "+"),
    # linear in a square of a sine; values of what rises; quarter turns; conjugates
    ("1 - sin(t)**2*x/y", "y > x, x >= 0", "+"),
    ("y - x*cos(t)**2", "y >= x, x >= 0", ">=0"),
    ("b*sin(x)**2 - b*sin(e)**2", "b > 0, e > 0, x >= e, x <= pi/2", ">=0"),
    ("exp(x) - exp(y)", "x > y", "+"),
    ("sqrt(x) - sqrt(y)", "x < y", "-"),
    ("3*pi/2*k - k*(pi + atan(x))", "k > 0", "+"),
    ("pi - acos(-x)", "x < 1", "+"),
    ("pi - acos(x)", "", ">=0"),
    ("(1 - b)/sqrt(b*(a + b)) - 1", "a > 0, b > 0, b <= 1, b*(a + 2) > 1", "-"),
    ("1 - b + sqrt(b*(a + b))", "a > 0, b > 1, b*(a + 2) > 1", "+"),
    # ranges of functions
    ("sqrt(1 + x**2) - cos(y)", "x > 0", "+"),
    ("exp(x) - 1", "x > 0", "+"),
    ("log(1 + x**2)", "", ">=0"),
    ("2 - acos(x)/2", "", "+"),
    ("tan(x)", "0 < x, x < pi/2", "+"),
    ("acos(x)", "x < 1", "+"),
    ("acos(x)", "x <= 1", ">=0"),
    ("acosh(x)", "x > 1", "+"),
    ("acosh(x)", "x >= 1", ">=0"),
]


@pytest.mark.parametrize(("text", "conditions", "found"), SIGNS)
def test_signs(text: str, conditions: str, found: str) -> None:
    e, given = parse(text), Given.parse(conditions)
    assert Parts(given).sign(e) == found
    with ball_precision(200):
        for point in given.points(symbols(e), 20):
            value = evaluate(e, {name: arb(at) for name, at in point.items()})
            assert not (value > 0 if found in ("-", "<=0") else value < 0)


FALSE = {
    f"u**2 + v**2 - x**2 - y**2 >= 0 given {STABLE}": (
        "a = 1, b = 2, c = 3, u = 0, v = 1, x = 11/10, y = 0"
    ),
    "x - b > 0 given b > 0, y > -b, x >= y, x <= y": "b = 1, x = 0, y = 0",
    "x + b > 0 given b > 0, y >= -b, x >= y, x <= y": "b = 1, x = -1, y = -1",
    "x + b > 0 given b > 0, y > -b, x <= y": "b = 1, x = -2, y = 0",
    "z - x > 0 given y >= x, z >= y": "x = 0, y = 0, z = 0",
    "x - 1 >= 0 given x**2*(x - 1) >= 0": "x = 0",
    "x*y - 1 > 0 given x > 1, x*y >= 1": "x = 2, y = 1/2",
    "a*(x - y) >= 0 given x >= y": "a = -1, x = 1, y = 0",
    "y**2 - x**2 > 0 given (x - y)*(-y - x) >= 0": "x = 1, y = 1",
    "1 - a*b > 0 given a > 0, b > 0, b*(a - 2) <= 1": "a = 2, b = 1",
    "sin(x) > 0 given 0 <= x, x < pi": "x = 0",
    "sin(x) >= 0 given -1 <= x, x < pi": "x = -1",
    "sin(x) > 0 given x > 0, x < 4": "x = 7/2",
    "cos(x) >= 0 given 0 < x, x < 2": "x = 19/10",
    "1 - cos(x)**2 > 0 given cos(x) > 0": "x = 0",
    "1 - b/(a + b)*cos(x)**2 > 0 given a >= 0, b > 0": "a = 0, b = 1, x = 0",
    "sqrt(1 + x**2) - cos(y) > 0": "x = 0, y = 0",
    "1 - sin(t)**2*x/y > 0 given y >= x, x > 0": "t = pi/2, x = 1, y = 1",
    "1 - sin(t)**2*x/y > 0 given y > 0, x > 0": "t = pi/2, x = 2, y = 1",
    "x*sin(t)**2 - y*cos(t) >= 0 given x > 0, y > 0": "t = 0, x = 1, y = 1",
    "sin(x) - sin(e) >= 0 given e > 0, x >= e, x <= pi": "e = 1, x = pi",
    "sin(x) - sin(y) > 0 given x >= y, x <= 1, y > 0": "x = 1, y = 1",
    "cos(x) - cos(y) >= 0 given x > y, x <= 1, y > 0": "x = 1, y = 1/2",
    "sqrt(x) - 2*sqrt(y) >= 0 given x > y, y > 0": "x = 2, y = 1",
    "sqrt(x) - cbrt(y) >= 0 given x > y, y > 0": "x = 1/100, y = 1/200",
    "3*pi/8 - atan(x) > 0": "x = 1000",
    "pi/2 + atan(x) - 2*pi/3 > 0": "x = 0",
    "pi - acos(-x) > 0 given x <= 1": "x = 1",
    "1 - (1 - b)/sqrt(b*(a + b)) > 0 given a > 0, b > 0, b < 1, b*(a + 2) >= 1": "a = 1, b = 1/3",
    "1 - b + sqrt(b*(a + b)) > 0 given a > -2, b > 1, b*(a + 2) < 1": "a = -219/200, b = 11/10",
    "exp(x) - 1 > 0 given x >= 0": "x = 0",
    "sqrt(x) - 1 > 0 given x > 1/2": "x = 3/4",
    "log(x) > 0 given x > 0": "x = 1/2",
    "tan(x) > 0 given 0 < x, x < 2": "x = 19/10",
    "sign(x)**2 > 0 given x >= 0, x <= 0": "x = 0",
    "x/y > 0 given x > 0, y != 0": "x = 1, y = -1",
    "x/y >= 0 given x > 0, y != 0": "x = 1, y = -1",
    "atan2(y, x) > 0 given y >= 0": "x = 1, y = 0",
    "-atan2(y, x) >= 0 given y <= 0": "x = -1, y = 0",
    "sec(x) > 0 given sin(x) > 0": "x = 3*pi/4",
    "csc(x) > 0 given cos(x) > 0": "x = -pi/4",
    "-x**(-2) > 0 given x < 0": "x = -1",
    "1/sqrt(x) - 1 > 0 given x > 1": "x = 4",
    "x + y + sin(z)**2 > 0 given x + y >= 0": "x = 0, y = 0, z = 0",
    "x**(1/3) - 2 > 0 given x > 4": "x = 5",
    "1 + sin(x)**2 + 5*sin(x)**3 > 0": "x = -pi/2",
    "1 + sin(x)**2 - 3*sin(x)**4 > 0": "x = pi/2",
    "sqrt(x/y)**2 - 1 > 0 given x > y, x < 0, y < 0": "x = -1, y = -2",
    "x**2 - 2*x*y + y**2 > 0": "x = 0, y = 0",
    "exp(x) - exp(y) - 1 > 0 given x > y": "x = 1/10, y = 0",
    "sin(x)**2 - sin(y)**2 > 0 given x > y, x < 1, y > -1": "x = 0, y = -1/2",
    "pi - 3*atan(x) > 0": "x = 1000",
    "pi - 2*acos(x) >= 0": "x = -1",
    "sqrt(x) - y**(1/3) >= 0 given x > y, y > 0": "x = 1/100, y = 1/200",
    "x**2*y - x**2*z > 0 given y > z": "x = 0, y = 1, z = 0",
    "1 - abs(x) >= 0 given x >= -1, x <= 2": "x = 2",
    "1/2 - abs(x) >= 0 given x >= -1/4, x <= 1": "x = 1",
    "a + b*sin(x)**2 > 0 given a >= 0, b > 0": "a = 0, b = 1, x = 0",
    "a + b*sin(x) >= 0 given a > 0, b > 0": "a = 1, b = 2, x = -pi/2",
    "b*sin(x)**2 > 0 given b > 0": "b = 1, x = 0",
    "1/x**3 > 0 given x <= 1": "x = -1",
    "x**3 + y**2 >= 0 given y > 0": "x = -2, y = 1",
    "(x + y)**(1/3) > 0 given x + y >= 0": "x = 0, y = 0",
}


@pytest.mark.parametrize("claim", FALSE)
def test_no_sign_is_read_off_where_there_is_none(claim: str) -> None:
    left, relation, _, given = read(claim)
    assert is_false_at(claim, FALSE[claim])
    assert Parts(given).sign(left) not in ("+", *([">=0", "0"] if relation == ">=" else []))


def test_answers_do_not_hang_on_what_was_asked_before() -> None:
    """What is found while a question is open may be less than can be said."""
    given = Given.parse("e > 0, e < pi/2, x >= e, x <= pi - e, sin(x) - e >= 0")
    trees = [parse(text) for text in ("sin(x)", "pi - x", "x", "sin(x) - e", "cos(x)")]
    for first in trees:
        for second in trees:
            parts = Parts(given)
            parts.sign(first)
            assert parts.sign(second) == Parts(given).sign(second)


def test_what_is_zero_is_not_nonzero() -> None:
    parts = Parts(Given.parse("x > 0, y != 0"))
    assert not parts.nonzero(parse("(x + 1)**2 - x**2 - 2*x - 1"))
    assert parts.nonzero(parse("x*y"))
    assert not parts.nonzero(parse("x*(y - 1)"))
    assert parts.nonzero(parse("1/(y - 1)"))
    assert not parts.nonzero(parse("(y - 1)**2"))


@pytest.mark.parametrize("text", ["exp(x)**2 - 2*exp(y)", "sin(x)**2 - 2*sin(y)"])
def test_what_rises_is_compared_with_its_like_alone(text: str) -> None:
    near = Given.parse("x > y, -pi/2 < y < pi/2, -pi/2 < x < pi/2")
    assert Parts(near).sign(parse(text)) is None


def test_what_is_taken_out_is_not_negative_and_known() -> None:
    parts = Parts(Given.parse("x >= y, z > 0"))
    one, gap, z, x = (parts.atoms.of(parse(e)).num for e in ("1", "x - y", "z", "x"))
    (of_gap,) = (n for n, (fact, *_) in enumerate(parts.facts) if fact == gap)
    assert parts._less(gap * z, ((one, z, of_gap),)) == ">=0"
    assert parts._less(gap + z, ((one, one, of_gap),)) == "+"
    assert parts._less(gap * x, ((one, x, of_gap),)) is None
    assert parts._less(-gap, ((one, -one, of_gap),)) is None
    assert parts._less(-one, ((-one, 0 * one, of_gap),)) is None
    assert parts._less(-z, ((0 * one, 0 * one, of_gap),)) is None
    assert parts._less(gap - z, ((one, one, of_gap),)) is None
    strict = Parts(Given.parse("x > y"))
    one, gap, x = (strict.atoms.of(parse(e)).num for e in ("1", "x - y", "x"))
    assert strict._less(gap, ((one, one, 0),)) == "+"
    assert strict._less(gap * x**2, ((one, x**2, 0),)) == ">=0"
    assert strict._less(0 * one, ((one, 0 * one, 0),)) == ">=0"


def test_what_is_linear_in_a_square_has_the_sign_of_its_ends() -> None:
    parts = Parts(Given.parse("a > 0"))
    p = parts.atoms.of(parse("a*cos(t)**2")).num
    assert (parts._at_ends(p), parts._at_ends(-p)) == (">=0", "<=0")
    assert parts._at_ends(p + parts.atoms.of(parse("a")).num) == "+"
