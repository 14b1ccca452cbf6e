"""Floating point values at several points: those of every operation, and none where none is."""

import math

import pytest

from tresym.reals.language.parsing import parse, parse_claim
from tresym.repair.floating import Points, UnsupportedError


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("integral(x**3*exp(-x), x, 0, oo)", 6),
        ("integral(exp(-x**2), x, -oo, oo)", math.sqrt(math.pi)),
        ("integral(exp(x), x, -oo, 0)", 1),
        ("integral(1/(1 + x**2), x, 0, oo)", math.pi / 2),
        ("integral(log(x), x, 0, 1)", -1),
        ("integral(x, x, 2, 0)", -2),
        ("integral(integral(x*y, x, 0, y), y, 0, 1)", 1 / 8),
        ("sum(1/k**2, k, 1, oo)", math.pi**2 / 6),
        ("sum((-1)**k/k, k, 1, oo)", -math.log(2)),
        ("sum(k/2**k, k, 0, oo)", 2),
        ("sum((k - 2)/factorial(k), k, 0, oo)", -math.e),
        ("sum(0*k, k, 0, oo)", 0),
        ("sum(k**2, k, 1, 5)", 55),
        ("sum(k, k, 1, 0)", 0),
        ("product(k, k, 1, 5)", 120),
        ("diff(x**2, x)*0 + atan2(1, -1)", 3 * math.pi / 4),
    ],
)
def test_values(text: str, value: float) -> None:
    (found,) = Points({"x": [1.0]}).values(parse(text))
    assert found == pytest.approx(value, rel=1e-7)


@pytest.mark.parametrize(
    "text",
    [
        *("sqrt(-x)", "log(-x)", "1/(x - 1)", "asin(x + 1)", "(-x)**(1/3)"),
        *("exp(1000*x) - exp(1000*x)", "integral(exp(t), t, 0, oo)"),
        *("sum(1/k, k, 1, oo)", "sum(k, k, 1, x/2)", "sum(1/k**2, k, -oo, oo)"),
    ],
)
def test_no_value_where_there_is_none(text: str) -> None:
    (found,) = Points({"x": [1.0]}).values(parse(text))
    assert math.isnan(found)


@pytest.mark.parametrize("text", ["limit(sin(x)/x, x, 0)", "y + 1"])
def test_what_is_not_computed_is_refused(text: str) -> None:
    with pytest.raises(UnsupportedError):
        Points({"x": [1.0]}).values(parse(text))


def test_derivatives_of_an_unknown_function_belong_to_it() -> None:
    points = Points({"x": [0.3, 0.3 + 1e-6]})
    ((value, _, slope),) = parse_claim("f(x) == diff(f(x), x)")
    (low, high), (slope, _) = points.values(value), points.values(slope)
    assert (high - low) / 1e-6 == pytest.approx(slope, rel=1e-4)
