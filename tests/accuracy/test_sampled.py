"""Errors of a function of the user at points, against mpmath, and what is refused."""

import json
import math
from pathlib import Path

import mpmath
import pytest

import tresym
from tresym.accuracy.error_table import error_table
from tresym.accuracy.sampled import names_function, sampled_table
from tresym.commands import main

MINE = """\
import math
def series(x):
    if x > 3: raise ValueError("too large")
    return 2/math.sqrt(math.pi)*(x - x**3/3 + x**5/10)
def scaled(x, c): return c*x
def nothing(x): return float("nan")
"""


@pytest.fixture
def mine(tmp_path: Path) -> str:
    (tmp_path / "mine.py").write_text(MINE)
    return str(tmp_path / "mine.py")


def test_errors_are_those_at_the_double(mine: str) -> None:
    found = sampled_table(f"{mine}:series", "erf(x)", ["1/10", "1/3", "2", "5"])
    with mpmath.workdps(50):
        for row in found.rows[:3]:
            x = float(mpmath.mpf(row.double))
            series = 2 / math.sqrt(math.pi) * (x - x**3 / 3 + x**5 / 10)
            error = mpmath.mpf(series) - mpmath.erf(mpmath.mpf(x))
            assert row.error is not None
            assert abs(mpmath.mpf(row.error.mid) / error - 1) < 1e-6
            assert row.ulps == pytest.approx(
                float(abs(error)) / math.ulp(float(mpmath.erf(mpmath.mpf(x)))), rel=1e-6
            )
    assert found.rows[3].note == "raises ValueError: too large"
    assert found.worst is found.rows[2]
    assert "sampled" in found.caption


def test_parameters_and_what_is_no_number(mine: str) -> None:
    found = sampled_table(f"{mine}:scaled", "c*x", ["3"], given="c == 1/4")
    assert found.rows[0].error is not None
    assert found.rows[0].error.mid == "0"
    assert sampled_table(f"{mine}:nothing", "x", [1]).rows[0].note == "returns nan"
    assert sampled_table("math:erf", "erf(x)", ["1/2"]).rows[0].ulps < 1
    for name, exact, at, given in (
        ("scaled", "c*x", ["3"], ""),
        ("none", "x", ["3"], ""),
        ("series", "erf(x)", [], ""),
        ("series", "log(x)", ["-1"], ""),
    ):
        with pytest.raises(tresym.InputError):
            sampled_table(f"{mine}:{name}", exact, at, given=given)
    assert names_function("a/b.py:f")
    assert not names_function("x/y")


def test_the_command_takes_the_function_on_either_side(
    mine: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["table", f"{mine}:series", "erf(x)", "--at", "1/2", "--json"]) == 0
    one = json.loads(capsys.readouterr().out)
    assert main(["table", "erf(x)", f"{mine}:series", "--at", "1/2", "--json"]) == 0
    other = json.loads(capsys.readouterr().out)
    assert one["rows"] == other["rows"]
    assert one["sampled"] is True
    assert main(["table", "erf(x)", f"{mine}:series", "--at", "1/2", "--order", "x"]) == 2


def test_a_region_is_used_or_refused() -> None:
    """Of Watson's integral the constant on x >= 1 is at least that at x = 10, and at most 1.02."""
    found = error_table(
        "integral(exp(-x*t)/(1+t), t, 0, oo)", "1/x", "x -> oo", [10], order="1/x**2",
        region="x >= 1",
    )  # fmt: skip
    assert found.constant is not None
    assert found.constant.region == "x >= 1"
    with mpmath.workdps(20):
        exact = mpmath.quad(lambda t: mpmath.exp(-10 * t) / (1 + t), [0, mpmath.inf])
    assert float(found.constant.low) <= float(abs(exact - 0.1) * 100) + 1e-6
    assert float(found.constant.high) < 1.02
    for region in ("0 < y <= 1", "1/2 < x <= 1"):
        with pytest.raises(tresym.InputError, match="region"):
            error_table("exp(x)", "1 + x", "x -> 0", region=region)
    with pytest.raises(tresym.InputError, match="--order"):
        error_table("sin(1/x)", "1", "x -> 0+", ["1/3", "1/7"], region="0 < x <= 1/2")


def test_digits_are_not_cut_and_factorials_are_read() -> None:
    found = error_table("n!", "n**n", "n -> oo", [20], digits=30)
    assert found.rows[0].exact_text == "2432902008176640000.00000000000"
    assert "2432902008176640000.00000000000" in found.latex()


def test_points_are_exact_expressions_and_formulas_typeset() -> None:
    at = ["1-1/10**10", "sqrt(2)/2", "1e-5000"]
    found = error_table("sqrt(x)", "x", "x -> 0+", at, decide=False)
    assert [row[0] for row in found.table.rows] == [
        "9999999999/10000000000",
        "sqrt(2)/2",
        "1.00000e-5000",
    ]
    assert r"$x$ compared with $\sqrt{x}$, $x \to 0^+$" in found.latex()
    assert r"$\frac{\sqrt{2}}{2}$" in found.latex()
    assert "<msqrt>" in found.html()
