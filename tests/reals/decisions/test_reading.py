"""Claims read from text, LaTeX and SymPy: the same statement, or one clear line."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from tresym.reals.decisions import reading
from tresym.reals.decisions.reading import MAX_CHARACTERS, read, read_as, read_path
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given

x, y = sp.symbols("x y", real=True)
p = sp.Symbol("p", positive=True)

SAME = [
    ("x**2 >= 0", "", "x^2 >= 0"),
    ("x**2 >= 0 given x > 1", "", "x**2>=0   given x>1"),
    ("x**2 >= 0 given x > 1, y < 2", "", "x**2 >= 0 given x > 1 and y < 2"),
    ("x >= 0 given x > 1, y < 2", "", "x >= 0 given x > 1; y < 2"),
    ("x**2*y >= 0", "", r"x^2 y \geq 0"),
    ("sin(x) == x given x > 0", "x > 0", "sin(x) == x"),
    ("x > 1 given x >= 2", r"x \ge 2", "x > 1"),
]


@pytest.mark.parametrize(("claim", "given", "other"), SAME)
def test_two_ways_to_write_a_claim(claim: str, given: str, other: str) -> None:
    one, two = read(claim), read(other, given)
    assert one.comparisons == two.comparisons
    assert one.given == two.given
    assert one.path == two.path


def test_a_chain_claims_each_of_its_links() -> None:
    found = read("0 < x <= 2*x == y")
    assert [str(c.left) + c.relation + str(c.right) for c in found.comparisons] == [
        "0<x",
        "x<=2*x",
        "2*x==y",
    ]


def test_conditions_of_both_places_are_joined() -> None:
    assert len(read("x > 0 given x > 1", "y > 1").given.comparisons) == 2
    assert read("x > 0", Given.parse("x > 1")).given == Given.parse("x > 1")
    assert read("x > 0", [x > 1, "y > 1"]).given == Given.parse("x > 1, y > 1")


def test_a_derivative_keeps_what_is_differentiated() -> None:
    (comparison,) = read("diff(log(x), x) == 1/x").comparisons
    assert comparison.differentiated == (parse("log(x)"),)
    (comparison,) = read(sp.Eq(sp.Derivative(sp.log(x), x), 1 / x)).comparisons
    assert comparison.differentiated == (parse("log(x)"),)


@pytest.mark.parametrize(
    ("text", "name", "point", "sides"),
    [
        ("x -> 0", "x", "0", (1, -1)),
        ("x -> 0+", "x", "0", (1,)),
        ("x->0-", "x", "0", (-1,)),
        ("t -> 1/2^+", "t", "1/2", (1,)),
        ("x -> pi/2-", "x", "pi/2", (-1,)),
        ("x -> -1", "x", "-1", (1, -1)),
        ("x -> oo", "x", None, (1,)),
        ("x -> +oo", "x", None, (1,)),
        ("x -> -oo", "x", None, (-1,)),
        ("x -> inf", "x", None, (1,)),
    ],
)
def test_paths(text: str, name: str, point: str | None, sides: tuple[int, ...]) -> None:
    found = read_path(text)
    assert (found.name, found.sides) == (name, sides)
    assert found.point == (None if point is None else parse(point))


@pytest.mark.parametrize("path", [r"x \to 0^+", r"$x \rightarrow 0^{+}$", "x → 0+", "x -> 0+"])
def test_paths_as_they_are_printed(path: str) -> None:
    assert read("x == O(1)", path=path).path == read_path("x -> 0+")


@pytest.mark.parametrize("text", ["", "x", "x ->", "-> 0", "x -> y", "x -> oo+1", "2 -> 0", "x=0"])
def test_what_is_no_path(text: str) -> None:
    with pytest.raises(InputError):
        read_path(text)


REFUSED = [
    ("x + 1", "", None),
    ("x", "", None),
    ("", "", None),
    ("x > 0 given x > 1 given y > 1", "", None),
    ("x == O(1)", "", None),
    ("x > 0", "", "x -> 0"),
    ("x == O(1) given x > 0", "", "x -> 0"),
    ("x*y == O(1)", "", "x -> 0"),
    ("x == O(1) as x -> y", "", None),
    ("x > 0 given x", "", None),
    ("x > 0 given x == 1", "", None),
    (r"x = 1, y = 2 \\ z = 3", "", None),
    ("x" * (MAX_CHARACTERS + 1), "", None),
]


@pytest.mark.parametrize(("claim", "given", "path"), REFUSED, ids=[c[0][:30] for c in REFUSED])
def test_what_does_not_belong_together_is_one_line(
    claim: str, given: str, path: str | None
) -> None:
    with pytest.raises(InputError) as caught:
        read(claim, given, path)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 500


@pytest.mark.parametrize(
    ("claim", "given"),
    [
        (sp.Eq(p**2, p * p, evaluate=False), "p > 0"),
        (sp.Gt(sp.Symbol("n", negative=True), 0, evaluate=False), "n < 0"),
        (sp.Ge(sp.Symbol("n", nonnegative=True) + x, 0), "n >= 0"),
        (sp.Ne(sp.Symbol("n", real=True, nonzero=True) + x, 0), "n != 0"),
        (sp.Le(x, y), ""),
        (sp.Eq(sp.Symbol("z"), 1), ""),
    ],
    ids=str,
)
def test_assumptions_on_a_sign_are_conditions(claim: Any, given: str) -> None:
    assert set(read(claim).given.comparisons) >= set(Given.parse(given).comparisons)


@pytest.mark.parametrize(
    "claim",
    [
        sp.true,
        x + 1,
        sp.Gt(sp.Symbol("n", integer=True), 0),
        sp.Gt(sp.Symbol("n", rational=True), 0),
        sp.Eq(sp.Symbol("i", imaginary=True), x),
        sp.Eq(x, sp.Symbol("x", positive=True)),
        sp.Eq(x, 0.1),
        sp.Eq(x, sp.I),
        3,
        None,
    ],
    ids=str,
)
def test_sympy_that_is_no_claim_about_real_numbers(claim: Any) -> None:
    with pytest.raises(InputError):
        read(claim)


@pytest.mark.parametrize("claim", ["sin(x) > 0 given x > 1", r"\frac{x}{2} \le 1", "√(x) ≥ 0"])
def test_what_was_read_is_read_as_the_same(claim: str) -> None:
    once = read(claim)
    again = read(once.read_as)
    assert (again.comparisons, again.given) == (once.comparisons, once.given)
    assert read_as(claim) == once.read_as


def test_nothing_is_said_of_what_is_not_read() -> None:
    assert read_as("x > 0 given x > 1 given y > 1") == ""


@pytest.mark.parametrize("claim", ["x > 1 given y >= 2", "sin(x) == O(x) as x -> 0", "a < b < c"])
def test_what_is_decided_is_read_from_what_is_shown(
    monkeypatch: pytest.MonkeyPatch, claim: str
) -> None:
    """A reader that takes one sign for another shows the other, too."""
    good = read(claim)
    wrong = str.maketrans({"x": "z", ">": "<", "b": "a"})
    monkeypatch.setattr(reading, "plain", lambda text: text.translate(wrong).replace("-<", "->"))
    bad = read(claim)
    assert bad.read_as != good.read_as
    monkeypatch.undo()
    again = read(bad.read_as)
    assert (bad.comparisons, bad.given, bad.path) == (again.comparisons, again.given, again.path)
