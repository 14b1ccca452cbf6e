"""Strategies of exact points, and tests of functions against certified values."""

import math
from fractions import Fraction

import pytest
from hypothesis import find, given, settings
from hypothesis import strategies as st

import tresym
from tresym.testing import accuracy, assert_claim, assert_close, points

REGION = "a > 0, 0 < b <= 1, a + b < 3"


@given(points(REGION))
def test_points_satisfy_the_conditions(point: dict[str, Fraction]) -> None:
    a, b = point["a"], point["b"]
    assert a > 0
    assert 0 < b <= 1
    assert a + b < 3


def test_points_lie_at_every_edge_and_near_singular_sets() -> None:
    seen: list[dict[str, Fraction]] = []

    @settings(max_examples=400, derandomize=True)
    @given(points("0 < x <= 1, y >= 2", near="1/(x - 1/3) + log(y - 2)"))
    def look(point: dict[str, Fraction]) -> None:
        seen.append(point)

    look()
    x = [point["x"] for point in seen]
    assert any(0 < v < Fraction(1, 10**6) for v in x)
    assert any(1 - Fraction(1, 10**6) < v < 1 for v in x)
    assert 1 in x
    assert any(0 < abs(v - Fraction(1, 3)) < Fraction(1, 10**5) for v in x)
    assert any(0 < point["y"] - 2 < Fraction(1, 10**5) for point in seen)
    assert any(point["y"] > 1000 for point in seen)


def test_points_shrink_to_simple_ones() -> None:
    found = find(points("x > 0"), lambda point: point["x"] > 2)
    assert found["x"].denominator == 1
    assert found["x"] <= 10


def test_a_good_function_passes() -> None:
    assert_close(lambda x: math.exp(x), "exp(x)", "-5 <= x <= 5", rtol=1e-15)
    assert_close(lambda x: math.erf(x), "2/sqrt(pi)*integral(exp(-t**2), t, 0, x)", "0 < x <= 3",
                 rtol=1e-14, examples=40)  # fmt: skip


@pytest.mark.parametrize(
    ("function", "expression", "region"),
    [
        (lambda x: (1 - math.cos(x)) / x**2, "(1 - cos(x))/x**2", "0 < x <= 1"),
        (lambda x, y: math.sqrt(x + y) - math.sqrt(x), "sqrt(x + y) - sqrt(x)", "x > 0, y > 0"),
        (lambda x: x, "sin(x)", "0 < x <= 1"),
        (lambda x: 1 / (x - 1 / 3), "1/(x - 1/3)", "0 < x <= 1"),  # 1/3 is rounded
        (lambda x: math.nan, "x", "x > 1"),
    ],
)
@pytest.mark.slow
def test_a_bad_function_fails_at_a_point_that_is_named(
    function: object, expression: str, region: str
) -> None:
    with pytest.raises(AssertionError, match=r"f\(x=.*relative error") as error:
        assert_close(function, expression, region)  # type: ignore[arg-type]
    assert "\n" not in str(error.value)


def test_only_the_error_of_the_function_counts() -> None:
    """Far from 0 the sine of a rounded number is another one; the function got the rounded one."""
    assert_close(lambda x: math.sin(x), "sin(x)", "1 <= x <= 1000000", rtol=1e-14)


def test_a_report_finds_where_digits_are_lost() -> None:
    report = accuracy(lambda x: (1 - math.cos(x)) / x**2, "(1 - cos(x))/x**2", "0 < x <= 1")
    assert report.quantile(0) < 1
    assert report.quantile(1) > 14
    assert report.worst[0][0]["x"] < 1e-4
    assert "true digits" in str(report)
    assert repr(report).startswith("AccuracyReport((1 - cos(x))")
    good = accuracy(math.exp and (lambda x: math.exp(x)), "exp(x)", "0 <= x <= 1")
    assert good.quantile(0) > 15


@pytest.mark.parametrize("conditions", ["x > 1, x < 0", "x >", "x == 2"])
def test_regions_without_points_are_refused(conditions: str) -> None:
    with pytest.raises(tresym.InputError):
        points(conditions)


def test_the_strategy_is_one_of_hypothesis() -> None:
    assert isinstance(points("x > 0"), st.SearchStrategy)


def test_an_expression_without_values_passes_nothing() -> None:
    with pytest.raises(tresym.InputError, match="no proved value"):
        assert_close(lambda x: 0.0, "log(x)", "-2 < x, x < -1", examples=20)


def test_integer_variables_are_integers() -> None:
    seen: list[int] = []

    def power(n: int, x: float) -> float:
        assert isinstance(n, int)
        seen.append(n)
        return math.pow(x, n)

    assert_close(power, "x**n", "n integer, 2 <= n <= 9, 1/2 < x < 1", rtol=1e-14, examples=40)
    assert set(seen) <= set(range(2, 10))
    assert len(set(seen)) > 3
    assert find(points("n integer"), lambda point: True)["n"].denominator == 1
    with pytest.raises(AssertionError, match="n="):
        assert_close(lambda n: n * n + 1, "n**2", "n integer, n > 3", examples=20)
    for empty in ("n integer, 1/3 < n < 2/3", "n integer, 0 < n < 1"):
        with pytest.raises(tresym.InputError, match="no "):
            assert_close(lambda n: n, "n", empty, examples=20)


def test_functions_without_keywords_are_called_by_position() -> None:
    assert_close(math.sin, "sin(x)", "0 < x <= 1", rtol=1e-15, examples=15)
    assert_close(math.sin, "sin(t)", "0 < t <= 1", rtol=1e-15, examples=15)
    assert_close(math.atan2, "atan(y/x)", "x > 0, 0 < y <= 5", rtol=1e-14, examples=15)
    with pytest.raises(AssertionError, match="relative error"):
        assert_close(math.cos, "sin(x)", "0 < x <= 1", examples=15)
    with pytest.raises(AssertionError, match="relative error"):
        assert_close(math.atan2, "atan(x/y)", "x > 1, 0 < y <= 1", examples=15)


def test_a_claim_is_asserted_by_its_verdict() -> None:
    assert_claim("exp(x) >= 1 + x")
    assert_claim("log(x) <= x - 1", given="x > 0")
    assert_claim("sin(x) ~ x", path="x -> 0")
    with pytest.raises(AssertionError, match="is REFUTED: the two sides differ at x = "):
        assert_claim("sqrt(x**2) == x")
    with pytest.raises(AssertionError, match="is UNDECIDED"):
        assert_claim("log(-1 - x**2) == 0")
    with pytest.raises(tresym.InputError):
        assert_claim("x +")


def test_an_arithmetic_error_is_named() -> None:
    with pytest.raises(AssertionError, match=r"= ZeroDivisionError \(.*\), but"):
        assert_close(lambda x: 1 / 0, "sin(x)", "0 < x, x < 1")
