"""Equations as conditions: every case of the variable counts, and none that has no point."""

import pytest

import tresym
from tresym.reals.language.expression import substitute
from tresym.reals.language.parsing import parse
from tresym.reals.normal.at_point import equal_at
from tresym.reals.verdict import Verdict

NEAR_ONE = f"({10**40 - 1}/{10**40})"
ROOT = (
    "root(tanh(sqrt(a*b)*(pi + asin(sqrt(b/(a+b))*cos(x))))"
    " - cos(x)/sqrt(1 + b/a*sin(x)**2), x, 0, pi/2)"
)
FAIL = [
    # 0 to the power 0, where no point was found before the signs of parts were asked
    f"y**2*x**0 + {NEAR_ONE}*x*y**0 != y**2*x**0 + {NEAR_ONE}*x*y**0 + 3 - y given x*y == 0",
    "cos(x) == sqrt(3)/2 given sin(x) == 1/2, 0 < x, x < pi",  # not the one angle
    "tan(x) == 1 given sin(x) == 1/2",
    "exp(x)*cos(x) <= 1 given cos(x) == 1",  # a turn further
    "x == pi/4 given tan(x) == 1",
    "a*b <= 1/5 given a + b == 1",
    "a**2 + b**2 + c**2 > 1/3 given a + b + c == 1",  # equal at one point
    "x + y <= 1 given x**2 + y**2 == 1",
    "x == y given x**2 == y**2",  # the other root
    "a == 0 given a*b == 0",  # b = 0
    "x + y >= 2 given x*y == 1",
    "x == 1 given abs(x) == 1",
    "x == 1 given x**2 == 1",
    "x == 1 given x**(-2) == 1",
    "x > 0 given x**2 + x == 1",
    "integral(x, x, 0, a) == 1 given a == 1",
    "x < 10 given sin(x) == 1/2",  # two turns further
    "v**2 == u**2 + a*s given v == u + a*t, s == u*t + a*t**2/2",
    "x**2 + 1/x**2 == 8 given x + 1/x == 3",
    "L**2 == M**2 - N**2 given M == L*cos(t), N == L*sin(t)",
    "h*(A - B) == a + b given a == h*A + k, b == h*B + k",
    "A - B == a - b given a == h*A + k, b == h*B + k",
    "cos(x) == 1 given sin(x) == 0",
    "x == y given x*z == y*z",  # z = 0
    "sqrt(x**2) == x given x**2 == y**2",
    "x + y == 3 given x**2 + 2*x*y + y**2 == 9",
    "sin(x) == sin(y) given cos(x) == cos(y)",
    "x*y + y*z + z*x <= 9/10 given x**2 + y**2 + z**2 == 1",
    "a*b*c <= 99/100 given a + b + c == 3, a > 0, b > 0, c > 0",
    "a + b + c >= 31/10 given a*b*c == 1, a > 0, b > 0, c > 0",
    "a + b + c >= 3 given a*b*c == 1",  # two of them negative
    "x + y <= 1 given x*y == 1/4",  # of one degree only where both are positive
]
FAIL += [
    "root(y**2 - a, y, 0, oo) > 2 given a == 4",  # equal
    "root(y**2 - a, y, 0, oo) == c given a == c**2",  # -c
    "root(exp(y) + y - a, y, -1, 1) < -0.5672 given a == 0",  # -0.56714…
    f"{ROOT} > 0.1150 given a == 1517/121, b == 55/874",  # 0.1149…
]


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_has_a_witness_that_satisfies_the_equation_exactly(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
    at = {name: parse(value) for name, value in answer.witness.items()}
    equation = next(part for part in claim.split(" given ")[1].split(",") if "==" in part)
    left, right = (substitute(parse(side), at) for side in equation.split("=="))
    assert equal_at(left, right, {})
