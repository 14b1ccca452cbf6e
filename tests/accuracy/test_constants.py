"""Best constants of roots and integrals: the true supremum lies between the bounds."""

from collections.abc import Callable

import mpmath
import pytest
from cases import cases

import tresym

Of = Callable[[mpmath.mpf], mpmath.mpf]

KNOWN: tuple[tuple[tuple[str, str, str, str, str], Of], ...] = (
    (
        ("root(y - e*sin(y) - 1, y, -oo, oo)", "1 + e*sin(1)", "e**2", "e -> 0+", "0 < e <= 1/2"),
        lambda e: mpmath.findroot(lambda y: y - e * mpmath.sin(y) - 1, 1.3) - 1
        - e * mpmath.sin(1),
    ),
    (
        ("root(y**3 + e*y - 1, y, 0, oo)", "1 - e/3", "e**3", "e -> 0+", "0 < e <= 1/4"),
        lambda e: mpmath.findroot(lambda y: y**3 + e * y - 1, 1) - 1 + e / 3,
    ),
    (
        (
            "2/pi*integral(1/sqrt(1 - k**2*sin(t)**2), t, 0, pi/2)",
            "1 + k**2/4", "k**4", "k -> 0+", "0 < k <= 1/2",
        ),
        lambda k: 2 / mpmath.pi * mpmath.ellipk(k**2) - 1 - k**2 / 4,
    ),
    (
        ("integral(exp(-x**2*t**2), t, 0, 1)", "1 - x**2/3", "x**4", "x -> 0+", "0 < x <= 1"),
        lambda x: mpmath.sqrt(mpmath.pi) / 2 * mpmath.erf(x) / x - 1 + x**2 / 3,
    ),
)  # fmt: skip


@pytest.mark.parametrize(("asked", "difference"), KNOWN)
@pytest.mark.slow
def test_the_supremum_is_enclosed(asked: tuple[str, ...], difference: Of) -> None:
    found = tresym.constant(*asked)
    assert found is not None
    low, high = float(found.low), float(found.high)
    assert 0 < low <= high <= 1.02 * low
    power, end = int(asked[2][-1]), eval(asked[4].split("<=")[1])
    with mpmath.workdps(60):
        points = [mpmath.mpf(end) * n / 60 for n in range(1, 61)] + [mpmath.mpf(10) ** -9]
        ratios = [abs(difference(x)) / x**power for x in points]
    assert low * 0.999 <= max(ratios) <= high
    assert max(ratios) >= low * 0.99


@pytest.mark.parametrize(
    "asked",
    cases(__file__, "no_constant_without_a_proof"),
)  # fmt: skip
@pytest.mark.slow
def test_no_constant_without_a_proof(asked: tuple[str, ...]) -> None:
    assert tresym.constant(*asked) is None


@pytest.mark.parametrize(
    ("asked", "smallest"),
    [
        (("sin(x)", "x", "x**3", "x -> 0", "abs(x) <= pi/2"), 0.1666666667),
        (("log(1 + x)", "x", "x**2", "x -> 0+", "x > 0"), 0.5),
        (("atan(x)", "pi/2 - 1/x", "1/x**3", "x -> oo", "x > 0"), 0.3333333333),
        (("asin(x)", "x", "x**3", "x -> 0", "-1 <= x <= 1"), 0.5707963268),
    ],
)
def test_natural_regions(asked: tuple[str, ...], smallest: float) -> None:
    found = tresym.constant(*asked)
    assert found is not None
    assert float(found.low) <= smallest <= float(found.high) <= 1.02 * smallest


def test_no_constant_where_the_ratio_is_not_bounded() -> None:
    assert tresym.constant("exp(x)", "1", "x", "x -> 0+", "x > 0") is None
    with pytest.raises(tresym.InputError):
        tresym.constant("exp(x)", "1", "x", "x -> 0+", "x > 1")
