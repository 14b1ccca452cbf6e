"""What newcomers type: read and shown in the grammar, or refused with what to write instead."""

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.sentences import spelled, spelled_conditions
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

READ = [
    ("∫_0^∞ e^(-x) dx = 1", "integral(E**(-x), x, 0, oo) == 1"),
    ("1 - e^2 = (1-e)(1+e) given 0 < e < 1", "1 - e**2 == (1 - e)*(e + 1) given 0 < e < 1"),
    ("n! >= 1 given n integer, n >= 0", "factorial(n) >= 1 given n integer, n >= 0"),
    (
        "(n+1)! = (n+1)*n! given n integer, n>=0",
        "factorial(n + 1) == (n + 1)*factorial(n) given n integer, n >= 0",
    ),
    ("sin^2(x) + cos^2(x) = 1", "sin(x)**2 + cos(x)**2 == 1"),
    ("sin²x + cos²x = 1", "sin(x)**2 + cos(x)**2 == 1"),
    ("sin^2 x + cos^2 x = 1", "sin(x)**2 + cos(x)**2 == 1"),
    ("sin(2x) = 2sin(x)cos(x)", "sin(2*x) == 2*sin(x)*cos(x)"),
    ("sin 2x = 2 sin x cos x", "sin(2*x) == 2*sin(x)*cos(x)"),
    ("2x + 3x = 5x", "2*x + 3*x == 5*x"),
    ("e^x >= 1 + x", "E**x >= x + 1"),
    ("e^(2x) = (e^x)^2", "E**(2*x) == (E**x)**2"),
    ("|x| >= x", "abs(x) >= x"),
    ("|x y| = |x||y|", "abs(x*y) == abs(x)*abs(y)"),
    ("2|x| = |2x|", "2*abs(x) == abs(2*x)"),
    ("||x|-|y|| <= |x-y|", "abs(abs(x) - abs(y)) <= abs(x - y)"),
    ("sqrt(x^2) = x for x > 0", "sqrt(x**2) == x given x > 0"),
    ("sqrt(x^2) = |x| for all x", "sqrt(x**2) == abs(x)"),
    ("sqrt(x^2) = |x| for all real x", "sqrt(x**2) == abs(x)"),
    ("x^2 >= 0 for every x in R", "x**2 >= 0"),
    ("x^2 <= 1 for x in [0, 1]", "x**2 <= 1 given x >= 0, x <= 1"),
    ("x^2 <= 1 for all x in [-1,1]", "x**2 <= 1 given x >= -1, x <= 1"),
    ("x <= 1 given x in [0,1]", "x <= 1 given x >= 0, x <= 1"),
    ("x < 1 given x ∈ (0,1)", "x < 1 given x > 0, x < 1"),
    ("1/x < 1 for x in (1, infinity)", "1/x < 1 given x > 1"),
    ("a+b >= 2sqrt(a b) given a,b >= 0", "a + b >= 2*sqrt(a*b) given a >= 0, b >= 0"),
    ("x + y > 0 given x>0 and y>0", "x + y > 0 given x > 0, y > 0"),
    ("if x > 0 then sqrt(x^2) = x", "sqrt(x**2) == x given x > 0"),
    ("if x > 0, then x + 1/x >= 2", "x + 1/x >= 2 given x > 0"),
    ("if x > 0 and y > 0 then x + y > 0", "x + y > 0 given x > 0, y > 0"),
    ("x > 1 => x^2 > 1", "x**2 > 1 given x > 1"),
    ("x > 1 ⇒ x² > 1", "x**2 > 1 given x > 1"),
    ("x =< x + 1", "x <= x + 1"),
    ("x <> x + 1", "x != x + 1"),
    ("sum(1/k^2, k, 1, infinity) = pi^2/6", "sum(k**(-2), k, 1, oo) == pi**2/6"),
    ("limit(1/x, x, infinity) = 0", "limit(1/x, x, oo) == 0"),
    ("∫_0^1 x^2 dx = 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("∫₀¹ x² dx = 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("∫ x dx = x²/2", "integral(x, x) == x**2/2"),
    ("int x^2 dx from 0 to 1 = 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("int_0^1 x^2 dx = 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("√(x²) = |x|", "sqrt(x**2) == abs(x)"),
    ("√2 > 1", "sqrt(2) > 1"),
    ("√2/2 = 1/√2", "sqrt(2)/2 == 1/sqrt(2)"),
    ("2π > 6", "2*pi > 6"),
    ("x ≤ y + 1 given x ≤ y", "x <= y + 1 given x <= y"),
    ("integrate(x**2, (x, 0, 1)) == 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("integrate(x**2, x) == x**3/3", "integral(x**2, x) == x**3/3"),
    (
        "integrate(x*y, (x, 0, 1), (y, 0, 1)) == 1/4",
        "integral(integral(x*y, x, 0, 1), y, 0, 1) == 1/4",
    ),
    ("Integral(x**2, (x, 0, 1)) == Rational(1,3)", "integral(x**2, x, 0, 1) == 1/3"),
    ("Sum(k, (k, 1, n)) == n*(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    ("Product(1+1/k, (k,1,n)) == n+1", "product(1/k + 1, k, 1, n) == n + 1"),
    ("Limit(sin(x)/x, x, 0) == 1", "limit(sin(x)/x, x, 0, 1) == 1"),
    ("limit(1/x, x, 0, '+') == oo", "limit(1/x, x, 0, 1) == oo"),
    ("limit(1/x, x, 0, dir='-') == -oo", "limit(1/x, x, 0, -1) == -oo"),
    ("diff(sin(x), x) = cos x", "diff(sin(x), x) == cos(x)"),
    ("Sin[x]^2 + Cos[x]^2 == 1", "sin(x)**2 + cos(x)**2 == 1"),
    ("Sum[k,{k,1,n}] == n(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    ("Integrate[x^2,{x,0,1}] == 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("Limit[Sin[x]/x, x -> 0] == 1", "limit(sin(x)/x, x, 0) == 1"),
    ("D[x^2, x] == 2x", "diff(x**2, x) == 2*x"),
    ("Sqrt[x^2] == Abs[x]", "sqrt(x**2) == abs(x)"),
    ("Sin[Pi] == 0", "sin(pi) == 0"),
    ("int(x^2, x=0..1) = 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("sum(k, k=1..n) = n*(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    ("limit(sin(x)/x, x=0) = 1", "limit(sin(x)/x, x, 0) == 1"),
    ("lim x->0 sin(x)/x = 1", "limit(sin(x)/x, x, 0) == 1"),
    ("lim(x->0) sin(x)/x = 1", "limit(sin(x)/x, x, 0) == 1"),
    ("lim_(x->0) sin(x)/x = 1", "limit(sin(x)/x, x, 0) == 1"),
    ("lim_{x->0} sin(x)/x = 1", "limit(sin(x)/x, x, 0) == 1"),
    ("lim x→∞ 1/x = 0", "limit(1/x, x, oo) == 0"),
    ("lim x->0+ x ln x = 0", "limit(x*log(x), x, 0, 1) == 0"),
    ("limit of sin(x)/x as x -> 0 is 1", "limit(sin(x)/x, x, 0) == 1"),
    ("lim(sin(x)/x, x, 0) = 1", "limit(sin(x)/x, x, 0) == 1"),
    ("d/dx x^2 = 2x", "diff(x**2, x) == 2*x"),
    ("d/dx (x^3) = 3x^2", "diff(x**3, x) == 3*x**2"),
    ("d/dx sin(x) = cos(x)", "diff(sin(x), x) == cos(x)"),
    ("d^2/dx^2 sin(x) = -sin(x)", "diff(sin(x), x, 2) == -sin(x)"),
    ("d(x^2)/dx = 2x", "diff(x**2, x) == 2*x"),
    ("(x^2)' = 2x", "diff(x**2, x) == 2*x"),
    ("sin'(x) = cos(x)", "diff(sin(x), x) == cos(x)"),
    ("f'(x) = 2*x", "diff(f(x), x) == 2*x"),
    ("sin(30°) = 1/2", "sin(pi/6) == 1/2"),
    ("sin 30° = 1/2", "sin(pi/6) == 1/2"),
    ("log10(100) = 2", "log(100)/log(10) == 2"),
    ("log_10(100) = 2", "log(100)/log(10) == 2"),
    ("log2(8) = 3", "log(8)/log(2) == 3"),
    ("x**2 \\geq 0", "x**2 >= 0"),
    ("sqrt(x) \\geq 0", "sqrt(x) >= 0"),
    ("sum_{k=1}^n k = n(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    ("∑_{k=1}^n k = n(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    ("sum k from k=1 to n = n(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    ("x(x+1) = x^2 + x", "x*(x + 1) == x**2 + x"),
    ("(x+1)(x-1) = x^2 - 1", "(x + 1)*(x - 1) == x**2 - 1"),
    ("a(b+c) = a*b + a*c", "a*(b + c) == a*b + a*c"),
    ("f(2x) = f(x+x)", "f(2*x) == f(x + x)"),
    ("tan x = sin x / cos x", "tan(x) == sin(x)/cos(x)"),
    ("1+2+...+n = n(n+1)/2", "sum(k, k, 1, n) == n*(n + 1)/2"),
    (
        "1 + 2 + … + n = n(n+1)/2 for n positive integer",
        "sum(k, k, 1, n) == n*(n + 1)/2 given n > 0, n integer",
    ),
    ("x^2 > 0 for nonzero x", "x**2 > 0 given x != 0"),
    ("n^2 >= n for all integers n", "n**2 >= n given n integer"),
    ("n^2 >= n for all positive integers n", "n**2 >= n given n > 0, n integer"),
    ("n^2 >= n for n in Z", "n**2 >= n given n integer"),
    ("x^3 > 0 for positive x", "x**3 > 0 given x > 0"),
    ("3sin(x) = 2sin(x) + sin x", "3*sin(x) == 2*sin(x) + sin(x)"),
    ("exp(x)^2 = exp(2x)", "exp(x)**2 == exp(2*x)"),
    ("sin(x)/x -> 1 as x -> 0", "sin(x)/x -> 1 as x -> 0"),
    ("2sin(x)/x -> 2 as x -> 0", "2*sin(x)/x -> 2 as x -> 0"),
    ("2/x -> 0 as x -> infinity", "2/x -> 0 as x -> oo"),
    ("2x = O(x) as x -> 0", "2*x == O(x) as x -> 0"),
    ("np.sin(x)**2 + np.cos(x)**2 == 1", "sin(x)**2 + cos(x)**2 == 1"),
    ("math.sqrt(4) == 2", "sqrt(4) == 2"),
    ("arctan x + arctan(1/x) = π/2 for x > 0", "atan(x) + atan(1/x) == pi/2 given x > 0"),
    ("cosh²x − sinh²x = 1", "cosh(x)**2 - sinh(x)**2 == 1"),
    ("x^(-1)y = y/x", "1/x*y == y/x"),
    ("ln(x y) = ln x + ln y", "log(x*y) == log(x) + log(y)"),
    ("-x^2 <= 0", "-x**2 <= 0"),
    ("x^2 + y^2 >= 2 x y", "x**2 + y**2 >= 2*x*y"),
    ("sin(x)^2 + cos(x)^2 = 1 (for all x)", "sin(x)**2 + cos(x)**2 == 1"),
    ("for all x > 0, ln x <= x - 1", "log(x) <= x - 1 given x > 0"),
    ("for x > 0: ln x <= x - 1", "log(x) <= x - 1 given x > 0"),
    ("for all x, y > 0, (x+y)/2 >= sqrt(x y)", "(x + y)/2 >= sqrt(x*y) given x > 0, y > 0"),
    ("given x > 0, x + 1/x >= 2", "x + 1/x >= 2 given x > 0"),
    ("suppose x > 0; x+1/x >= 2", "x + 1/x >= 2 given x > 0"),
    ("abs(x)<1 => x^2<1", "x**2 < 1 given abs(x) < 1"),
]

REFUSED = cases(__file__, "REFUSED")


@pytest.mark.parametrize(("claim", "shown"), READ)
def test_what_newcomers_type_is_read_and_shown(claim: str, shown: str) -> None:
    assert read(claim).read_as == shown


@pytest.mark.parametrize(("claim", "advice"), REFUSED)
def test_what_can_be_read_in_two_ways_is_refused_with_both(claim: str, advice: str) -> None:
    with pytest.raises(InputError) as found:
        tresym.check(claim)
    assert str(found.value) == advice


def test_the_conditions_apart_are_read_as_the_claim_is() -> None:
    for given in ("x in [0, 1]", "0 <= x and x <= 1", "x ∈ [0,1]"):
        assert tresym.check("x^2 <= x", given).verdict is Verdict.PROVED
    assert tresym.check("a + b >= 0", "a,b >= 0").verdict is Verdict.PROVED
    assert spelled_conditions("n positive integer") == "n > 0, n integer"
    assert spelled_conditions("x") is None


def test_an_echo_is_shown_with_the_answer() -> None:
    assert ("read as", "2*x + 3*x == 5*x") in tresym.check("2x + 3x = 5x").rows()


@pytest.mark.parametrize(
    "text",
    [
        "(" * 5000 + "2x = 1",
        "2x" * 5000,
        "sin " * 500 + "x = 1",
        "||" * 200,
        "2x == " + "2**" * 900 + "2",
    ],
)
def test_long_and_deep_text_is_left_to_the_strict_reader(text: str) -> None:
    assert spelled(text) is None
    with pytest.raises(InputError) as found:
        tresym.check(text)
    assert len(str(found.value)) < 700
