"""Text as people write it: what is read, and what is refused with advice."""

import contextlib
import json
from pathlib import Path

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import Derivative, Eq, Symbol, log, sqrt

import tresym
from tresym.checking.time_limited import Task, check_within
from tresym.commands import main
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language import paths
from tresym.reals.language.expression import number
from tresym.reals.language.paths import read_path
from tresym.reals.language.readings import read_as
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize(
    ("claim", "advice"),
    [
        ("sinus(x) == 1", "unknown function sinus"),
        ("arcsine(x) == 1", "did you mean arcsin"),
        ("(x + 1 == 1", "character 1 is not closed"),
        ("x + 1) == 1", "character 6 was not opened"),
        ("|x == 1", "no partner"),
        ("x => 1", "write x >= 1"),
        ("x >= ", "one side"),
        ("1,5 == 3/2", "decimals have a point"),
        ("x > 0 given", "missing after the word given"),
        ("lambda == 1", "lambda_"),
        ("x^^2 == 1", r"one \^"),
        ("O(x) == x as x -> 0", "right side"),
        ("x == 1 as x -> 0", "a path is only for"),
        ("x == 1or 2", "one claim at a time"),
        ("x == 0x1for", "is not an expression"),
        ("x == x given x > 1or 2", "is not a condition"),
        ("x > 0 given diff(log(x), x) > 0", "write it out"),
        ("diff(pi*x, pi) == x", "not a variable"),
        ("integral(x, x) > 1/2", "compared with an antiderivative"),
        ("at(y, x, 3) == y", "substitute the point"),
        ("limit(x, x, y) > 1", "stand alone on one side"),
        ("limit(x, x, 0) == 0 as x -> 0", "states its own path"),
        ("x + O(x) + o(x) == 1", "right side"),
        (r"x \le \infty", "oo is not a real number"),
        (r"x = \pm 1", "write x == 1 and x == -1"),
        (r"x\to 0", "needs its path"),
        (r"x\ll 1", "<< does not make a claim"),
        (r"x\sim x\sim x as x\to 0", "part of a chain"),
        ("x == x == x + O(x) as x -> 0", "part of a chain"),
        (r"\text{for } x > 0", "relation such as a = b"),
        (r"x = y, y = z", "one claim at a time"),
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
    assert f"{name} is read as a variable" in answer.why
    assert "is read as a variable" not in tresym.check(f"{name} == {name}").why


def test_bars_open_where_an_operand_is_expected() -> None:
    assert plain("|x|*|y + |z||") == "abs(x)*abs(y + abs(z))"


def test_points_can_be_read_where_the_ends_are_irrational() -> None:
    for claim in ("x <= 1 given 0 <= x <= sqrt(2)", "sin(x) <= 1/2 given pi/7 < x < pi/5"):
        answer = tresym.check(claim)
        assert answer.witness is not None
        assert len(answer.witness["x"]) < 10


def test_an_irrational_witness_is_exact() -> None:
    assert tresym.check("3 + 4*cos(x) + cos(2*x) > 0").witness in ({"x": "pi"}, {"x": "-pi"})


SHOWN = {
    r"\sin\frac12 x = y": "sin(x/2) == y",
    r"$\frac{x}{2} \le |x|$ given x\ge 0": "x/2 <= abs(x) given x >= 0",
    r"\cos x \sim 1 as x\to 0^{+}": "cos(x) ~ 1 as x -> 0+",
    r"x\sin\frac1x \sim 1 as x\to\infty": "x*sin(1/x) ~ 1 as x -> oo",
    r"\sin\theta = o(1) as \theta\to -\frac{\pi}{2}": "sin(theta) == o(1) as theta -> -pi/2",
    r"\sin x = x+O(x^3) as x \to 0": "sin(x) == x + O(x**3) as x -> 0",
    "x² ≥ 0": "x**2 >= 0",
    "√(x) ≤ π given 0 < x ≤ 1": "sqrt(x) <= pi given 0 < x <= 1",
    "e^2 > 0": "e**2 > 0",
    "a = b = a": "a == b == a",
    r"\sqrt{x^2} = x \text{ for } x>0": "sqrt(x**2) == x given x > 0",
    r"\sin x = x + O(x^3) \text{ as } x\to 0": "sin(x) == x + O(x**3) as x -> 0",
    r"\sin x = x+O(x^3),\quad x\to 0^-": "sin(x) == x + O(x**3) as x -> 0-",
    r"\text{for } x > 0, x = |x|": "x == abs(x) given x > 0",
    r"x = |x| \quad\forall x > 0": "x == abs(x) given x > 0",
    r"\lim_{x\to 0^+} x\ln x = 0": "limit(x*log(x), x, 0, 1) == 0",
    "limit(atan(x), x, oo) == pi/2": "limit(atan(x), x, oo) == pi/2",
    r"\max(x, 0) \ge x": "(x + abs(x))/2 >= x",
    "diff(x**3, x, 2) == 6*x": "diff(x**3, x, 2) == 6*x",
    "at(x**2, x, y) == y**2": "at(x**2, x, y) == y**2",
    "x > 0 given x > 1 and y > 0": "x > 0 given x > 1, y > 0",
    "sin(x) == O(x) as x -> 0": "sin(x) == O(x) as x -> 0",
}


@pytest.mark.parametrize("claim", SHOWN)
def test_what_was_read_is_said_in_the_grammar(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.read_as == SHOWN[claim]
    assert answer.as_json()["read_as"] == SHOWN[claim]
    again = tresym.check(answer.read_as)
    assert (again.verdict, again.witness) == (answer.verdict, answer.witness)


def test_what_was_read_is_shown_where_it_is_not_what_was_written() -> None:
    latex = tresym.check(r"\sin^2 x = 1-\cos^2 x", given=r"x\geq 0")
    assert ("read as", "sin(x)**2 == 1 - cos(x)**2 given x >= 0") in latex.rows()
    assert "sin(x)**2 == 1" in latex._repr_html_()
    assert ("read as", "e**2 > 0") in tresym.check("e^2 > 0").rows()
    for text, under in (("x**2>=0", ""), ("x >= 0 given x > 1", ""), ("x >= 0", "x > 1")):
        answer = tresym.check(text, under)
        assert answer.read_as
        assert "read as" not in dict(answer.rows())


def test_a_claim_of_sympy_is_said_with_its_derivatives() -> None:
    x = Symbol("x", positive=True)
    claim = Eq(Derivative(log(x), x), 1 / x, evaluate=False)
    shown = tresym.check(claim).read_as
    assert shown == "diff(log(x), x) == 1/x given x > 0, x >= 0, x != 0"
    claim = Eq(Derivative(sqrt(x), (x, 2)), -1 / (4 * x * sqrt(x)), evaluate=False)
    answer = tresym.check(claim)
    assert tresym.check(answer.read_as).verdict is answer.verdict is Verdict.PROVED


@pytest.mark.slow
def test_what_was_read_is_said_where_time_is_over() -> None:
    for claim in (r"\sin\frac12 x = y", read(r"\sin\frac12 x = y")):
        assert check_within(Task(claim), 1e-9).read_as == "sin(x/2) == y"


@pytest.mark.slow
def test_every_line_of_a_file_says_what_was_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "claims"
    path.write_text("\\sin\\frac12 x = y\nx² >= 0\n\\sin x/2 = 1\n", encoding="utf-8")
    assert main(["check", "-f", str(path), "--json"]) == 2
    captured = capsys.readouterr()
    found = [json.loads(line)["read_as"] for line in captured.out.splitlines()]
    assert found == ["sin(x/2) == y", "x**2 >= 0", None]
    assert "write sin(x/2) or sin(x)/2" in captured.err
    assert main(["check", "-f", str(path)]) == 2
    assert "read as    sin(x/2) == y" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.parametrize(
    "claim", [r"\sin x/2 = 1", r"x(0) = 0\cdot x", r"e^{i\pi} = -1", r"\dot x = \frac{dx}{dt}"]
)
def test_a_refusal_is_bad_input(claim: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", claim]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1


ATOMS = st.sampled_from(["x", "y", r"\theta", r"\pi", "2", "7", r"\lambda_1", r"\frac12", "e"])


def _larger(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    pairs = st.tuples(inner, inner)
    names = st.sampled_from([r"\sin", r"\cos^2", r"\ln", r"\arctan", r"\cosh", r"\exp"])
    return st.one_of(
        pairs.map(" ".join),
        pairs.map(lambda p: rf"{p[0]}+{p[1]}"),
        pairs.map(lambda p: rf"\left({p[0]}-{p[1]}\right)"),
        pairs.map(lambda p: rf"\frac{{{p[0]}}}{{{p[1]}}}"),
        pairs.map(lambda p: rf"{p[0]}\cdot {p[1]}"),
        st.tuples(names, inner).map(" ".join),
        st.tuples(names, inner).map(lambda p: rf"{p[0]}({p[1]})"),
        inner.map(lambda e: rf"({e})^{{2}}"),
        inner.map(lambda e: rf"\sqrt{{{e}}}"),
        inner.map(lambda e: rf"\sqrt[5]{{{e}}}"),
        inner.map(lambda e: rf"\left|{e}\right|"),
        inner.map(lambda e: rf"\frac{{d}}{{dx}}({e})"),
    )


@given(st.recursive(ATOMS, _larger, max_leaves=8), st.sampled_from(["=", r"\le", r"\neq"]))
def test_what_was_read_is_read_again_as_the_same(left: str, relation: str) -> None:
    try:
        first = read(rf"{left} {relation} \frac{{x}}{{2}}", r"x \ge -\frac12")
    except InputError:
        return
    second = read(first.read_as)
    assert second.comparisons == first.comparisons
    assert second.given == first.given
    assert second.read_as == first.read_as == read_as(first)


@pytest.mark.parametrize(
    "end", [" ", "^", "+", "-", "^+", "0+-", "0--", "+-oo", "oo+", "1or 2", "2^"]
)
def test_a_path_without_one_end_is_refused(end: str) -> None:
    with pytest.raises(InputError) as found:
        read_path(f"x -> {end}")
    assert "\n" not in str(found.value)


def test_paths_are_read_as_they_are_written() -> None:
    assert read_path("x -> 0^+") == read_path("x -> 0+") == paths.Path("x", number(0), (1,))
    assert read_path("x -> 2^3") == paths.Path("x", number(8), (1, -1))
    assert read_path("x -> -oo") == paths.Path("x", None, (-1,))
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
