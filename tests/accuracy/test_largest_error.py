"""Largest errors of approximations: bounds on both sides of values that mpmath found."""

import json
from fractions import Fraction
from pathlib import Path

import pytest
from flint import arb, fmpq

import tresym
from tresym.accuracy.largest_error import as_stored, interval, largest_error
from tresym.accuracy.stored_numbers import nearest
from tresym.commands import main
from tresym.reals.balls.circle import over_a_ball
from tresym.reals.domain.compiled import Compiled
from tresym.reals.expansions.maxima import largest
from tresym.reals.language.expression import ONE
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

DATA = Path(__file__).parent.parent / "data" / "largest_errors.txt"
LINES = [line for line in DATA.read_text().splitlines() if not line.startswith("#")]


@pytest.mark.parametrize("line", LINES, ids=lambda line: line.partition(" ")[0])
def test_the_largest_error_lies_between_the_bounds(line: str) -> None:
    exact, approx, on, *true = (part.strip() for part in line.split("|"))
    found = largest_error(exact, approx, on)
    for bounds, value in zip((found.absolute, found.relative), true, strict=True):
        if value == "oo":
            assert bounds.high == "oo"
        else:
            x = float(value)
            low, high = float(bounds.low), float(bounds.high)
            assert low <= x * 1.000001 <= high * 1.000002
            assert high <= 1.01 * x


@pytest.mark.parametrize(
    ("exact", "approx", "on", "absolute", "relative"),
    [
        ("sin(x)", "x", "abs(x) <= pi/2", 0.570797, 0.570797),  # 0/0 at 0, and irrational ends
        ("log(x)", "x - 1", "1/2 <= x <= 2", 0.306853, 0.442696),  # 0/0 inside
        ("1 - cos(x)", "x**2/2", "abs(x) <= 1", 0.0403024, 0.0876713),  # a double zero
        ("sqrt(x)", "(1 + x)/2", "0 <= x <= 2", 0.5, float("inf")),  # the root of 0
        ("sqrt(1 - x)", "1 - x/2", "0 <= x < 1", 0.5, float("inf")),
        ("sqrt(pi/2 - x)", "1", "0 <= x <= pi/2", 1, float("inf")),  # singular at irrational end
        ("exp(-x)", "0", "x >= 0", 1, 1),
        ("erfc(x)", "exp(-x**2)/(x*sqrt(pi))", "x >= 1", 0.0502548, 0.319480),
        ("1/x", "1", "0 < x <= 1", float("inf"), 1),
        ("exp(x)", "1", "x >= 0", float("inf"), 1),
        ("abs(x)", "x**2", "-1 <= x <= 1", 0.25, 1),
        ("x/2 + x/2", "x", "0 <= x <= 1", 0, 0),
    ],
)
def test_ends_and_zeros(exact: str, approx: str, on: str, absolute: float, relative: float) -> None:
    found = largest_error(exact, approx, on)
    for bounds, true in ((found.absolute, absolute), (found.relative, relative)):
        high = float("inf") if bounds.high == "oo" else float(bounds.high)
        if high != true:
            assert float(bounds.low) <= true * 1.00001 <= high * 1.00002 <= true * 1.01


def test_a_jump_at_an_excluded_end_is_no_error() -> None:
    """On 0 < x <= 1 the sign is 1, though it is 0 at 0."""
    found = largest(parse("sign(x) - 1 + x/10"), ONE, "x", fmpq(0), fmpq(1))
    assert float(found.low.mid()) <= 0.1


def test_roots_and_integrals() -> None:
    found = largest_error("integral(exp(-x*t)/(1 + t**2), t, 0, 1)", "157/200 - 3*x/10", "0<=x<=1")
    assert found.absolute.low.startswith("0.0397")
    assert found.absolute.where == "x = 1"
    found = largest_error("root(y - x*sin(y) - 1, y, 0, 4)", "1 + x*sin(1)", "0 <= x <= 1/2")
    assert 0.0779 < float(found.absolute.low) <= float(found.absolute.high) < 0.0781


@pytest.mark.parametrize(
    ("text", "bits", "hexadecimal"),
    [("0.1", 53, "0x1.999999999999ap-4"), ("0.1", 24, "0x1.99999ap-4"), ("-2.5e-1", 24, "-0x1p-2"),
     ("16777217", 24, "0x1p24"), ("16777219", 24, "0x1.000004p24"), ("0", 53, "0x0p0")],
)  # fmt: skip
def test_decimals_as_they_are_stored(text: str, bits: int, hexadecimal: str) -> None:
    least = {53: -1074, 24: -149}[bits]
    assert nearest(Fraction(text), bits, least) == Fraction(float.fromhex(hexadecimal))


def test_coefficients() -> None:
    assert as_stored("[0, 1, 0, -1/6]", "exact", "x") == "(1)*x**1 + (-1/6)*x**3"
    assert as_stored("0x1.8p1*x + 0.5f", "single", "x") == "(3)*x + (1/2)"
    assert as_stored("x1.5 + E", "double", "x") == "x1.5 + E"
    exact, stored = (
        largest_error("x/10", "0.1*x", "0 <= x <= 1", how) for how in ("exact", "double")
    )
    assert exact.absolute.high == "0"
    assert stored.absolute.low == "5.55111e-18"  # 0.1 in binary64 is too large by 5.55e-18


def test_regions() -> None:
    for text in ("abs(x) <= 1", "-1 <= x <= 1", "x >= -1, x <= 1", "x >= -3, abs(x) <= 1"):
        _, low, high = interval(text)
        assert (str(low), str(high)) == ("-1", "1")
    assert interval("abs(x - 2) < 1")[1:] == interval("1 < x < 3")[1:]
    for text in ("x + y <= 1", "x != 0", "x**2 <= 1/4 + x", "x >= 2, x <= 1"):
        with pytest.raises(tresym.InputError):
            interval(text)


def test_a_function_without_power_series_is_bounded_by_a_circle() -> None:
    f = Compiled(parse("besselj(0, x) - 1 + x**2/4"), ["x"])
    with ball_precision(128):
        found = over_a_ball(f, arb(1, 1) / 2)
        assert abs(found) < 0.016
        assert found.contains(arb(1).bessel_j(0) - arb(3) / 4)
        assert not over_a_ball(Compiled(parse("sqrt(x)"), ["x"]), arb(1, 1)).is_finite()
    claim = "abs(besselj(0, x) - (1 - x**2/4 + x**4/64)) <= {} given 0 <= x <= 1"
    assert tresym.check(claim.format("0.00043"))
    assert not tresym.check(claim.format("0.00042"))


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["error", "sin(x)", "x - x**3/6", "--on", "0 <= x <= 1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["absolute"]["where"] == "x = 1"
    assert main(["error", "sin(x)", "x - x**3/6", "--on", "0 <= x <= 1"]) == 0
    assert "0.00813765 to 0.00813766, at x = 1" in capsys.readouterr().out
    assert main(["error", "sin(x)", "y", "--on", "0 <= x <= 1"]) == 2
    assert main(["error", "sin(x)", "x"]) == 2
