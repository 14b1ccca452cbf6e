"""Whether conditions hold at no point but limits of inner ones: each way to show it, each guard."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound
from tresym.reals.language.expression import number
from tresym.reals.language.parsing import parse
from tresym.reals.signs.closure import is_regular

REGULAR = {
    "strict alone": "x**2*(x - 1) > 0, x != 3",
    "bounds of variables alone": "0 <= x <= 1, y >= pi",
    "half-spaces": "x + y <= 1, x >= y, 3*x >= sqrt(2)*y - pi",
    "absolute values": "1 - abs(x - y) >= abs(x)",
    "a disc and a half-plane": "x**2 + x*y + y**2 <= 1, x + y >= 0",
    "concave in five variables": "x**2 + y**2 + z**2 + u**2 + v**2 <= 1",
    "simple zeros": "(x - 1)*(x - 2)*(x - 3) >= 0, x <= 4",
    "a threefold zero": "(x - 1)**3*(x + 2) >= 0",
    "an even zero that is excluded": "(x - 1)**2*(x - 2) >= 0, x > 1",
    "two polynomials without common zeros": "x*(x - 1) >= 0, (x - 2)*(x - 3) >= 0",
    "a root of a variable": "sqrt(x) < 5, sqrt(1 - x) > -1",
    "a root of what is never negative": "sqrt(x**2 + y**2 + 1) < 5, sqrt(x**2) < y, x*y >= 1",
    "a root of a quadric": "sqrt(1 - x**2 - y**2) > -1",
    "all rise in one variable": "x >= y**3, x*exp(y) >= 1, y > 0",
    "all fall in one variable": "y >= x + x**3, x + sin(x)/2 + y**3 <= 1",
    "convex in one variable": "b**2 >= a*c**3, a >= 0",
    "an indefinite quadric": "x*y >= z*u",
    "a cone of degree 2": "x**2 + y**2 <= z**2",
}

SINGULAR = {
    "a zero of even order inside": "(x - 1)**2*(x - 2) >= 0",
    "that is not excluded, but nearly": "(x - 1)**2*(x - 2) >= 0, x >= 1",
    "that is irrational": "(x**2 - 2)**2*(x - 3) >= 0, x > 7/5",
    "two that meet in a point": "x*(x - 1) >= 0, x*(x - 2) <= 0",
    "a bound that meets a zero": "x*(x - 1)*(x - 2) <= 0, x >= 2",
    "one and the same bound from both sides": "x*(x - 1) >= 0, x*(1 - x) >= 0",
    "a cusp with a point": "y**2 <= x**2*(x - 1)",
    "a point of three variables": "(x**2 + y**2 + z**2)*(x - 1) >= 0",
    "a line": "x**2*y >= 0",
    "a quadric on a side of itself": "x*y >= 0, x >= 0",
    "two quadrics": "x*y >= 0, x*(y - x) <= 0",
    "a half-space beside a quadric": "x*y >= 0, x + y >= 0",
    "absolute values that are subtracted": "abs(x) - abs(y) >= 0, y - x >= abs(x)",
    "an absolute value of what is not linear": "y - abs(x**2 - 1) >= 0, 1000*y <= x + 1",
    "a derivative that may vanish": "x**3*y >= y, y >= x",
    "one that no step changes": "x >= y**3, z**2*(z - 1) >= 0",
    "a root that ends where it is 0": "x >= y**2*(1 - y), sqrt(-x) > -1",
    "convex in one variable, a point alone in another": "b**2 >= a**3, c**2*(c - 1) >= 0",
    "convex in a variable with a bound": "(x + 1)**2 >= 1 + y**2, x <= 0",
    "convex, and not strictly": "b*(b - 1)*c >= 0, c >= 0",
    "convex in a variable of two conditions": "x**2 >= y**3, x**2 <= y**5",
    "no derivative": "x + abs(y)*abs(x) >= y**3, x + sqrt(y) >= 1",
    "a root that is defined at a point alone": "sqrt(x**2*(x - 1)) < 5",
    "a root within": "log(2 + sqrt((x**2 - 2)**2*(x - 3))) > 0",
    "a power that is": "(x**2*(x - 1))**(3/2) != 7",
    "an inverse function that is": "asin(1 + x**2*(x - 1)**2) > 0",
    "convex but for a kink": "x**2 - 5*abs(x) >= y**2",
    "convex but for a kink in a power": "(1 - abs(x))**3 >= 1 + y**2, -1/2 < x, x < 1/2",
    "convex but for a kink in an exponent": "2**(-abs(x)) >= 1 + y**2",
    "convex but for a kink in an exponential": "exp(-abs(x)) >= 1 + y**2",
    "convex but for a kink in a factor": "(3 + x)*(1 - abs(x)) + 9*x**2 >= 3 + x + y**2",
    "a jump": "3*sign(x)**2 <= x",
    "a jump beside": "x - 3*sign(x)**2 >= y**3",
    "a jump that no case is made of": "y >= 2*sign((x - sqrt(2))**2), y + z <= 10",
    "no polynomial": "sin(x)*sin(2*x) >= 0",
    "many variables": "x**2 + y**2 + z**2 + u**2 + v**2 + w**2 <= 1, x + y >= 0",
}


@pytest.mark.parametrize("name", REGULAR)
def test_conditions_with_no_points_but_limits_of_inner_ones(name: str) -> None:
    assert is_regular(Given.parse(REGULAR[name]))


@pytest.mark.parametrize("name", SINGULAR)
def test_conditions_of_which_it_is_not_shown(name: str) -> None:
    assert not is_regular(Given.parse(SINGULAR[name]))


@pytest.mark.parametrize("integrand", ["sqrt(t*x**2*(x - 1))", "1/sqrt(a + b*sin(t)**2)"])
def test_a_condition_on_a_bound_variable_is_no_condition_on_the_others(integrand: str) -> None:
    """The first has a value at x = 0 and for x >= 1."""
    plain = parse(f"integral({integrand}, t, 0, 1)")
    assert not is_regular(Given((bound(number(5) - plain, ">"),)))


FACTORS = st.lists(st.tuples(st.integers(-3, 3), st.integers(1, 3)), min_size=1, max_size=3)


@given(st.lists(st.tuples(st.sampled_from((1, -1)), FACTORS), min_size=1, max_size=2))
def test_what_is_regular_has_no_point_alone(polynomials: list[tuple[int, list]]) -> None:
    """Polynomials with whole zeros: a zero is a point alone if both sides of it are excluded."""

    def values(x: float) -> list[float]:
        found = []
        for value, factors in polynomials:
            for zero, power in factors:
                value *= (x - zero) ** power
            found.append(value)
        return found

    text = ", ".join(
        " * ".join([str(sign), *(f"(x - ({zero}))**{power}" for zero, power in factors)]) + " >= 0"
        for sign, factors in polynomials
    )
    inside = [min(values(k + 0.5)) > 0 for k in range(-4, 4)]
    zeros = [min(values(k)) >= 0 for k in range(-3, 4)]
    alone = any(at and not any(inside[k : k + 2]) for k, at in enumerate(zeros))
    if any(inside) and alone:  # without a point inside, nothing is proved at all
        assert not is_regular(Given.parse(text))
