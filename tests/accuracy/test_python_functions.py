"""Python functions read from their source: formulas, bounds of rounding, and what is refused."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest

import tresym
from tresym.accuracy.largest_error import errors_at
from tresym.accuracy.python_functions import read_function, rounding
from tresym.commands import main

COEFFICIENTS = [0.9999966, -0.16664824, 0.00830629, -0.00018363]


def horner(x: float) -> float:
    z = x * x
    r = 0.0
    for c in reversed(COEFFICIENTS):
        r = r * z + c
    return r * x


def rational(x: float) -> float:
    t = 1 / (1 + 0.47047 * x)
    t -= 0.25
    return -t / (abs(x) + 2) + math.sqrt(x + 1)


def with_exp(x: float) -> float:
    return math.exp(-x * x) * x**2


def branches(x: float) -> float:
    if x > 0:
        return x
    return -x


def unknown(x: float) -> float:
    return random.gauss(x)


def two(x: float, y: float) -> float:
    return x + y


@pytest.mark.parametrize("function", [horner, rational])
def test_a_bound_of_rounding_holds(function: Callable[[float], float]) -> None:
    found = tresym.largest_error("0*x", function, "0 <= x <= 2").rounding
    assert found is not None
    assert found.bounded
    bound = Fraction(found.size)
    assert bound < Fraction(1, 10**14)
    at = random.Random(7)
    for _ in range(200):
        x = at.uniform(0, 2)
        z = Fraction(x)
        if function is horner:
            exact = z * sum(Fraction(c) * z ** (2 * k) for k, c in enumerate(COEFFICIENTS))
            assert abs(Fraction(horner(x)) - exact) <= bound
        else:
            import mpmath

            with mpmath.workdps(40):
                t = 1 / (1 + mpmath.mpf(0.47047) * x) - mpmath.mpf("0.25")
                value = -t / (mpmath.mpf(x) + 2) + mpmath.sqrt(mpmath.mpf(x) + 1)
                assert abs(mpmath.mpf(rational(x)) - value) <= mpmath.mpf(found.size)


def test_other_functions_are_sampled_and_it_is_said() -> None:
    found = tresym.largest_error("x**2*exp(-x**2)", with_exp, "0 <= x <= 2")
    assert found.absolute.high == "0"
    assert found.rounding is not None
    assert not found.rounding.bounded
    assert "sampled, no bound" in str(found)


def test_constants_are_those_that_are_stored() -> None:
    program = read_function(horner)
    assert str(Fraction(0.9999966)) in str(program.expression("x"))
    single = read_function(horner, "single")
    assert str(Fraction(0.9999966)) not in str(single.expression("x"))


@pytest.mark.parametrize("function", [branches, unknown, two, math.sin])
def test_refused(function: Callable[..., float]) -> None:
    with pytest.raises(tresym.InputError):
        tresym.largest_error("sin(x)", function, "0 <= x <= 1")


def test_division_by_a_ball_around_zero_has_no_bound(tmp_path: Path) -> None:
    file = tmp_path / "mine.py"
    file.write_text("def f(x):\n    return 1/(x - 0.5)\n")
    program = read_function(f"{file}:f")
    found = rounding(program, *_ends(), "double")
    assert found is None or not found.bounded


def _ends() -> tuple[object, object]:
    from flint import arb

    return arb(0), arb(1)


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "mine.py"
    file.write_text("A = -1/6\n\ndef f(x):\n    return x + A*x*x*x\n")
    assert main(["error", "sin(x)", f"{file}:f", "--on", "0 <= x <= 1"]) == 0
    assert "rounding adds           at most" in capsys.readouterr().out
    for x, error in errors_at("sin(x)", f"{file}:f", "0 <= x <= 1", "exact", 4):
        assert error == pytest.approx(math.sin(x) - x + x**3 / 6, abs=1e-12)


@pytest.mark.night
def test_picture(tmp_path: Path) -> None:
    picture = tmp_path / "error.svg"
    asked = ["error", "sin(x)", "[0, 1]", "--on", "0 <= x <= 1", "--chart", str(picture)]
    assert main(asked) == 0
    assert picture.read_text().startswith("<?xml")
    assert main([*asked[:4], "x >= 1", *asked[5:]]) == 2
