"""Claims read from text, LaTeX and SymPy: the same statement, or one clear line."""

from typing import Any

import pytest
import sympy as sp
from cases import cases

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.language import claims, paths
from tresym.reals.language.claims import MAX_CHARACTERS
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import read_path
from tresym.reals.language.readings import read_as
from tresym.reals.numbers.exact import InputError

x, y = sp.symbols("x y", real=True)
p = sp.Symbol("p", positive=True)

SAME = cases(__file__, "SAME")


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


@pytest.mark.parametrize(
    "text", ["", "x", "x ->", "-> 0", "x -> x", "x -> oo+1", "2 -> 0", "x=0", "x -> 0+ in a"]
)
def test_what_is_no_path(text: str) -> None:
    with pytest.raises(InputError):
        read_path(text)


REFUSED = [
    ("x + 1", "", None),
    ("x", "", None),
    ("", "", None),
    ("x > 0 given x > 1 given y > 1", "", None),
    ("x == O(1)", "", None),
    ("x == Theta(1)", "", None),
    ("x == o(x + y) given x > 0, y > 0", "", None),
    ("x ~ x + y given x > 0, y > 0", "", None),
    ("x == 1", "", "x -> 0"),
    ("x -> 1", "", None),
    ("f(x) > f", "", None),
    ("f(x) > 0 given f > 0", "", None),
    ("f(x) > f(x, 1)", "", None),
    ("x > oo", "", None),
    ("x > 0 given x > oo", "", None),
    ("x > 0 given x in y", "", None),
    ("x > 0 given diff(f(x)**2, x) > 0", "", None),
    ("integral(diff(x, x), x, 0, 1) == 1", "", None),
    ("integral(x, x)**2 == x", "", None),
    ("integral(x, x) + integral(y, y) == 1", "", None),
    ("x == O(1) given x > 0", "", "x -> 0"),
    ("x == O(1) as x -> 2*x", "", None),
    ("x > 0 given x", "", None),
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
    for module in (claims, paths):
        monkeypatch.setattr(module, "plain", lambda text: text.translate(wrong).replace("-<", "->"))
    bad = read(claim)
    assert bad.read_as != good.read_as
    monkeypatch.undo()
    again = read(bad.read_as)
    assert (bad.comparisons, bad.given, bad.path) == (again.comparisons, again.given, again.path)


SAID_AGAIN = cases(__file__, "SAID_AGAIN")


@pytest.mark.parametrize("claim", SAID_AGAIN)
def test_what_can_be_claimed_is_said_again_as_it_was_written(claim: str) -> None:
    once = read(claim)
    assert once.read_as == claim
    assert read(once.read_as).comparisons == once.comparisons


def test_conditions_that_are_no_inequalities_are_kept_apart() -> None:
    found = read("a > 0 given a + b = 1, n is an integer, b > 2")
    assert (str(found.given), found.integers) == ("b > 2", ("n",))
    assert found.equations == ((parse("a + b"), parse("1")),)
    assert found.under == "b > 2, a + b == 1, n integer"
    n = sp.Symbol("n", integer=True)
    assert read(sp.Gt(n, x), [sp.Eq(x, 1)]).under == "x == 1, n integer"


def test_conditions_with_a_side_in_common_go_on_in_one_direction_alone() -> None:
    read_as = read("x == x", "x > 0, 0 < y, y < z").read_as
    assert read_as == "x == x given x > 0, 0 < y < z"
