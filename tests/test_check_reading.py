"""Text as people write it: what is read, and what is refused with advice."""

import pytest

import tresym
from tresym.checking.typography import plain
from tresym.exact import InputError
from tresym.verdict import Verdict

READ = [
    "sin(π) == 0",
    "x² + 1 > 0",
    "x·y ≤ (x² + y²)/2",
    "x × 3 ÷ 3 == x",
    "√(x²) == |x|",
    "||x| − |y|| ≤ |x − y|",
    "|x·(−2)| == 2·|x|",
    "α + β₁ == β₁ + α",
    "x⁻² == 1/x²",
    "x ≥ −1 given x > 0 and y > 0",
    "x ≥ −1 given x > 0; y > 0",
    "exp(−x) == o(1/x) as x → ∞",
    "max(x, y, z) >= x",
    "min(x, y) == (x + y - abs(x - y))/2",
    "$x^2 \\ge 0$",
    r"\frac{x}{y} + \frac{y}{x} \geq 2 given x > 0, y > 0",
]


@pytest.mark.parametrize("claim", READ)
def test_printed_signs_are_read(claim: str) -> None:
    assert tresym.check(claim)


@pytest.mark.parametrize(
    ("claim", "advice"),
    [
        ("sin x == x", r"sin\(x\)"),
        ("√x >= 0", r"sqrt\(x\)"),
        ("2x == x + x", r"2\*x"),
        ("2π > 6", r"2\*pi"),
        ("x²y == y", r"\*y"),
        ("3sin(x) == 1", r"3\*sin"),
        ("sin(x)cos(x) == 1", r"\)\*cos"),
        ("(x + 1)(x - 1) == x**2 - 1", r"write \* between factors"),
        ("x(x + 1) == 1", r"x is no function; for a product write x\*"),
        ("log10(x) == 1", r"log\(x, 10\)"),
        ("sinus(x) == 1", "unknown function sinus"),
        ("arcsine(x) == 1", "did you mean arcsin"),
        ("floor(x) <= x", "outside what is decided"),
        ("integrate(x, x) == x", r"diff\(F, x\) == f"),
        ("sin^2(x) == 1", r"sin\(x\)\*\*2"),
        ("d/dx x**2 == 2*x", r"diff\(f, x\)"),
        ("x! >= 1", "factorials"),
        ("sin[x] == 1", "parentheses"),
        ("(x + 1 == 1", "character 1 is not closed"),
        ("x + 1) == 1", "character 6 was not opened"),
        ("|x == 1", "no partner"),
        ("x => 1", "write >="),
        ("x =< 1", "write <="),
        ("x <> 1", "write !="),
        ("x = 1", "write =="),
        ("x >= ", "one side"),
        ("1,5 == 3/2", "decimals have a point"),
        ("x > 0 and y > 0", "one claim at a time"),
        ("x**2 >= 0 for all x", "after the word given"),
        ("x > 0 given x = 1", "a condition uses"),
        ("x > 0 given x in [0, 1]", "0 < x <= 1"),
        ("x > 0 given", "missing after the word given"),
        ("sin(30°) == 1/2", "degree sign"),
        ("lambda == 1", "lambda_"),
        ("x^^2 == 1", r"one \^"),
        ("O(x) == x as x -> 0", "right end"),
        ("x == 1 as x -> 0", "path belongs to"),
    ],
)
def test_a_slip_is_told_in_one_line(claim: str, advice: str) -> None:
    with pytest.raises(InputError, match=advice) as found:
        tresym.check(claim)
    assert "\n" not in str(found.value)
    assert len(str(found.value)) < 350


@pytest.mark.parametrize("name", ["e", "Pi", "i"])
def test_variables_that_look_like_numbers_are_named(name: str) -> None:
    answer = tresym.check(f"{name}**2 == x")
    assert answer.verdict is Verdict.REFUTED
    assert f"{name} is a variable here" in answer.why
    assert "is a variable here" not in tresym.check(f"{name} == {name}").why


def test_bars_open_where_an_operand_is_expected() -> None:
    assert plain("|x|*|y + |z||") == "abs(x)*abs(y + abs(z))"


def test_points_can_be_read_where_the_ends_are_irrational() -> None:
    for claim in ("x <= 1 given 0 <= x <= sqrt(2)", "sin(x) <= 1/2 given pi/7 < x < pi/5"):
        answer = tresym.check(claim)
        assert answer.witness is not None
        assert len(answer.witness["x"]) < 10


def test_an_irrational_witness_is_exact() -> None:
    assert tresym.check("3 + 4*cos(x) + cos(2*x) > 0").witness in ({"x": "pi"}, {"x": "-pi"})
