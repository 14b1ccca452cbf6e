"""Text as people write it: what is read, and what is refused with advice."""

import contextlib

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

import tresym
from tresym.checking.statement import Path, read, read_path
from tresym.checking.typography import plain
from tresym.exact import InputError
from tresym.identity.expression import number
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
        ("x == 1or 2", "one claim at a time"),
        ("x == 0x1for", "is not an expression"),
        ("x == x given x > 1or 2", "is not a condition"),
        ("x > 0 given diff(log(x), x) > 0", "write it out"),
        ("diff(pi*x, pi) == x", "a variable"),
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


@pytest.mark.parametrize(
    "end", [" ", "^", "+", "-", "^+", "0+-", "0--", "+-oo", "oo+", "1or 2", "2^"]
)
def test_a_path_without_one_end_is_refused(end: str) -> None:
    with pytest.raises(InputError) as found:
        read_path(f"x -> {end}")
    assert "\n" not in str(found.value)


def test_paths_are_read_as_they_are_written() -> None:
    assert read_path("x -> 0^+") == read_path("x -> 0+") == Path("x", number(0), (1,))
    assert read_path("x -> 2^3") == Path("x", number(8), (1, -1))
    assert read_path("x -> -oo") == Path("x", None, (-1,))
    assert tresym.check("1 == O(1)", path="x -> sqrt(2)+").region == "0 < x - sqrt(2) <= 1"


def test_no_derivative_of_sympy_is_a_condition() -> None:
    x = sympy.Symbol("x")
    with pytest.raises(InputError, match="write it out"):
        tresym.check("x == x", given=sympy.Gt(sympy.Derivative(sympy.log(x), x), 0))


PIECES = [
    *"xy012.+-*/^()<>=!~,|eEoO_ &;:'\"jlbafr[]{}$#@%`?\\\n\t\0é²",
    *("1or 2", "0x1for", "1_0", "1e5", "1and", "0b1", " or ", " if ", " else ", " in ", " is "),
    *("lambda", "==", "!=", ">=", "**", "O(", "o(", "sin(", "diff(", "atan2(", "max(", ",x)"),
    *("oo", "pi", "True", "None", "f'", "b'", "'''", "\\x", "\\N{", " given ", " as ", "x -> "),
    *("0+", "x:=", "**x", "await x", "yield", "1__0", "09", "1e+", "\\frac", "\\to", "√", "π"),
]
SHORT = st.lists(st.sampled_from(PIECES), max_size=8).map("".join)


@given(
    st.one_of(SHORT, st.builds("{} == {}".format, SHORT, SHORT)),
    st.one_of(st.just(""), SHORT),
    st.one_of(st.none(), SHORT, st.builds("x -> {}".format, SHORT)),
)
def test_nothing_but_an_input_error_escapes_and_nothing_is_said_beside(
    claim: str, conditions: str, path: str | None
) -> None:
    """Python's own warnings are errors here."""
    with contextlib.suppress(InputError):
        read(claim, conditions, path)
