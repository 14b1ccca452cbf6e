"""Constants of orders: the supremum on a region, against a computation with mpmath."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from statistics import median

import mpmath
import pytest
from cases import cases

import tresym
from tresym.asymptotics.constants import constant
from tresym.reals.numbers.exact import InputError

DATA = Path(__file__).parent.parent / "data" / "asymptotics" / "constants.txt"
POINTS, DIGITS = 60, 60


def _rows() -> list[tuple[str, str, str, str]]:
    rows = []
    for line in DATA.read_text().splitlines():
        if line and not line.startswith("#"):
            difference, gauge, path, region = (part.strip() for part in line.split(";"))
            rows.append((difference, gauge, path, region))
    return rows


def _supremum(difference: str, gauge: str, path: str, region: str) -> mpmath.mpf:
    """The largest ratio on a grid that is refined around its maximum, in high precision."""
    name, _, end = path.partition("->")
    name, end = name.strip(), end.strip()
    names = {k: getattr(mpmath, k) for k in dir(mpmath)} | {"E": mpmath.e}
    names["abs"] = abs
    with mpmath.workdps(DIGITS):
        sides = [compile(e.replace("^", "**"), "", "eval") for e in (difference, gauge)]

        def ratio(x: mpmath.mpf) -> mpmath.mpf:
            f, g = (eval(side, names, {name: x}) for side in sides)
            return abs(f / g) if abs(f) > mpmath.mpf(10) ** -(DIGITS - 20) else mpmath.mpf(0)

        reach = mpmath.mpf(eval(region.split()[-1].replace("/", "*1.0/"), {}))
        if end == "oo":
            spots = [partial(lambda s, u: s * reach / u, 1)]
        else:
            point = mpmath.mpf(end.rstrip("+-"))
            sides_ = (1,) if end.endswith("+") else (-1,) if end.endswith("-") else (1, -1)
            spots = [partial(lambda s, u: point + s * reach * u, s) for s in sides_]
        best = mpmath.mpf(0)
        for spot in spots:
            grid = [mpmath.mpf(k) / POINTS for k in range(1, POINTS + 1)]
            grid += [mpmath.mpf(2) ** -k for k in range(6, 24)]
            top = max(grid, key=lambda u: ratio(spot(u)))
            step = top / 8 if top < mpmath.mpf(1) / POINTS else mpmath.mpf(1) / POINTS
            for _ in range(12):
                near = [top + step * k / 4 for k in range(-4, 5) if 0 < top + step * k / 4 <= 1]
                top = max(near, key=lambda u: ratio(spot(u)))
                step /= 4
            best = max(best, ratio(spot(top)))
        return best


ROWS = _rows()


@pytest.mark.parametrize("row", ROWS[::4], ids=str)
def test_a_constant_is_the_supremum_to_two_per_cent(row: tuple[str, str, str, str]) -> None:
    found, truth = constant(*row), _supremum(*row)
    assert found is not None
    with mpmath.workdps(DIGITS):
        assert mpmath.mpf(found.low) <= truth * (1 + mpmath.mpf("1e-4"))
        assert truth * (1 - mpmath.mpf("1e-12")) <= mpmath.mpf(found.high) <= truth * 1.021


@pytest.mark.night
def test_all_constants() -> None:
    ratios = []
    for row in ROWS:
        found, truth = constant(*row), _supremum(*row)
        assert found is not None, row
        assert mpmath.mpf(found.low) <= truth * (1 + mpmath.mpf("1e-4")), row
        assert mpmath.mpf(found.high) >= truth * (1 - mpmath.mpf("1e-12")), row
        ratios.append(float(mpmath.mpf(found.high) / truth))
    assert median(ratios) <= 1.05
    assert max(ratios) <= 1.5


def test_hyperbolic_functions_have_small_constants() -> None:
    answer = tresym.check("tanh(x) == x - x**3/3 + 2*x**5/15 + O(x**7) as x -> 0")
    assert answer.constant is not None
    assert answer.region == "0 < |x| <= 1"
    assert answer.constant.mid.startswith("0.0540")


def test_a_region_may_be_asked_for() -> None:
    answer = tresym.check("tan(x) == x + O(x**3) as x -> 0 on abs(x) <= 1/2")
    assert answer.region == "0 < |x| <= 1/2"
    assert answer.constant is not None
    assert answer.constant.mid.startswith("0.37041")
    again = tresym.check(answer.read_as)
    assert again.read_as == answer.read_as


@pytest.mark.parametrize(
    "claim",
    cases(__file__, "a_region_reaches_the_end_of_the_path_of_an_order"),
)
def test_a_region_reaches_the_end_of_the_path_of_an_order(claim: str) -> None:
    with pytest.raises(InputError):
        tresym.check(claim)


SMALLEST = Path(__file__).parent.parent / "data" / "smallest_constants.txt"


@pytest.mark.parametrize(
    "line",
    [line for line in SMALLEST.read_text().splitlines() if not line.startswith("#")],
    ids=lambda line: line.partition(" |")[0],
)
def test_the_constant_is_the_smallest_to_two_per_cent(line: str) -> None:
    (claim, rest), true = line.split(" | ", 1), float(line.rsplit("|", 1)[1])
    region = rest.rsplit("|", 1)[0].strip()
    found = tresym.check(claim, limit=20)
    assert found
    assert region in ("", found.region)
    assert found.constant is not None
    middle, radius = map(float, found.constant)
    assert (middle - radius) * 0.999999 <= true <= (middle + radius) * 1.000001
    assert middle + radius <= 1.02 * true


@pytest.mark.parametrize(
    "claim",
    [
        "x*log(x) == O(x**2) as x -> oo on x > 0",  # unbounded at 0
        "exp(x) == 1 + O(x) as x -> 0+ on x > 0",  # unbounded at oo
        "tan(x) == x + O(x**3) as x -> 0 on -1 <= x <= 2",  # a pole at pi/2
        "sqrt(1 + x) == 1 + O(x) as x -> 0 on -2 <= x <= 2",  # not real below -1
        "1/(1 - x) == 1 + O(x) as x -> 0 on abs(x) <= 1",  # a pole at the closed end
    ],
)
def test_no_constant_serves_on_these_regions(claim: str) -> None:
    assert not tresym.check(claim, limit=10)
