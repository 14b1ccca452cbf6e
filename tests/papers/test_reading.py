"""Files of claims: what is read of each kind of line, and what is refused with which words."""

import re
from pathlib import Path

import pytest

from tresym.papers.reading import OwnPaper, read_file, read_paper
from tresym.reals.numbers.exact import InputError


def test_the_kinds_of_lines() -> None:
    text = (
        "# Title\n% comment\na, b real; given 0 < a < 1\n\n## Part\nprose\n> more: a == b\n"
        "u := a**2\nf(x) := x*u\nsmall: f(a) < 1\n  given b > 0\n"
        "table small: at a == 1/2, 1/3; digits 5\n"
    )
    found = read_paper(text)
    assert not found.problems
    assert found.title == "Title"
    kinds = [type(item).__name__ for item in found.items]
    assert kinds == [
        "Declaration",
        "Section",
        "Prose",
        "Definition",
        "Definition",
        "PaperClaim",
        "Drawn",
    ]
    claim = found.claims["small"]
    assert str(claim.links[0][0]) == "a*a**2"
    assert claim.rests_on == ("f",)
    assert found.drawn("table")[0].digits == 5


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("E := 3", "has a meaning of its own"),
        ("pi real", "has a meaning of its own"),
        ("gamma := 3", "has a meaning of its own"),
        ("a := 3", "declared on line 1 already"),
        ("u := u + 1", "its own definition"),
        ("u := ", "needs an expression"),
        ("a <= 2", "but has no label"),
        ("Note: words", "no relation"),
        ("a > 0", "has no label"),
        ("b, E real; given b > 0\nc: b + E > 2*pi*b given q** > 0", "is not an expression"),
        ("c: a** <= 2", "is not an expression"),
        ("c: eps <= 2", "eps is not declared"),
        ("c: a <= 2 expect proved", "only 'expect refuted'"),
        ("c: a <= 2 using d", "no claim above this line is labelled"),
        ("c: a <= 2 given a > 0 given a > 1", "begins two clauses"),
        ("c: a ~= b", "is not a decimal number"),
        ("c: a == a + O(a)", "needs its path"),
        ("table c: at a == 1/2", "no claim is labelled c"),
        ("c: a >= 0 at a > 1", "write at x == 1/5"),
        ("#", "a heading needs a title"),
        ("u := a\nc: u(a + 1) == a", "u is no function"),
        ("c: g >= 0\ng := a**2", "above its definition"),
        ("c: a == a + O(a) as a -> 0 at a == 1", "the variable of the path"),
        ("given b > \nc: b > 0", "which is not read"),
        ("b real; given b > \nc: b > 0", "which is not read"),
        ("f(x) := x\nc: f(1, 2) == 1", "f takes 1 argument, 2 given"),
        ("u := a**2\nc: integral(u, u, 0, 1) == 1", "cannot be the variable"),
    ],
)
def test_a_wrong_line_is_told_with_its_place_and_stops_no_other(line: str, message: str) -> None:
    found = read_paper(f"a real\n{line}\nlast: a**2 >= 0\n")
    assert found.problems[-1].line == 1 + len(line.split("\n"))
    assert message in found.problems[-1].message
    assert not any("\n" in problem.message for problem in found.problems)
    assert "last" in found.claims


def test_the_place_of_an_error_is_that_of_the_word() -> None:
    (problem,) = read_paper("c: x + 1 <= 2*eps\n").problems
    assert problem.column == 15


def given_of(paper: OwnPaper, label: str) -> int:
    return len(paper.claims[label].conditions)


def test_conditions_are_those_on_the_variables_and_what_they_are_related_to() -> None:
    found = read_paper("x, y, z real; given x > y, y > 5, z > 0\nc: x > 5\nd: z > 0\n")
    assert given_of(found, "c") == 2
    assert given_of(found, "d") == 1


def test_a_definition_is_an_abbreviation_below_a_derivative_and_an_integral() -> None:
    found = read_paper("a real\nu := a**2\nd: diff(u, a) == 2*a\ni: integral(u, a, 0, 1) == 1/3\n")
    assert str(found.claims["d"].links[0][0]) == "diff(a**2, a)"
    assert str(found.claims["i"].links[0][0]) == "integral(a**2, a, 0, 1)"


def test_an_argument_is_not_captured() -> None:
    found = read_paper("f(x) := integral(x*t, t, 0, 1)\nc: f(t) == t/2\n")
    assert str(found.claims["c"].links[0][0]) == "integral(t*t_1, t_1, 0, 1)"


def test_files_that_are_no_text(tmp_path) -> None:  # type: ignore[no-untyped-def]
    bad = tmp_path / "bad.tresym"
    bad.write_bytes(b"x: 1 == 1\n\xff\xfe")
    with pytest.raises(InputError, match=r":2: this is not UTF-8"):
        read_file(bad)
    with pytest.raises(InputError, match="no such file"):
        read_file(tmp_path / "none.tresym")


def test_a_refused_name_leaves_the_others_declared() -> None:
    found = read_paper("b, E real; given b > 0\nc: b > 0\n")
    assert [problem.line for problem in found.problems] == [1]
    assert given_of(found, "c") == 1


DATA = Path(__file__).resolve().parents[1] / "data"
_KIND = re.compile(r"(?:true|false)\s*\|\s*|(?:HOLDS|UNIFORM|FALSE|NONE)\s+")


@pytest.mark.parametrize(
    "name",
    [
        *("claims/inequalities", "claims/orders", "claims/special"),
        *("asymptotics/roots", "asymptotics/initial_values"),
    ],
)
def test_what_check_reads_is_read_in_a_file(name: str) -> None:
    lines = (DATA / f"{name}.txt").read_text(encoding="utf-8").splitlines()
    claims = [_KIND.sub("", line, count=1) for line in lines if _KIND.match(line)][::5]
    found = read_paper("\n".join(f"c{n}: {claim}" for n, claim in enumerate(claims)))
    assert not found.problems
    assert len(found.claims) == len(claims) > 5


@pytest.mark.parametrize("label", ["eq 1", "(3)", "Lemma 1", "α", "erfc.large"])
def test_a_label_as_in_print_is_a_label(label: str) -> None:
    found = read_paper(f"{label}: a < 0")
    assert not found.problems
    assert [str(claim.links[0][0]) for claim in found.chosen([label])] == ["a"]


@pytest.mark.parametrize(
    "line",
    [
        "let f > 0",
        "assume h > 0",
        "a Real",
        "n in NN; given n > 0",
        "let x be real",
        "so a < 0 here",
    ],
)
def test_what_looks_like_a_claim_or_a_declaration_is_no_prose(line: str) -> None:
    found = read_paper(f"some prose\n{line}\nshape: a**2 >= 0")
    assert [problem.line for problem in found.problems] == [2]
    assert list(found.claims) == ["shape"]
    assert not read_paper(f"some prose\n> {line}\nshape: a**2 >= 0").problems


@pytest.mark.parametrize(
    "text",
    [
        "s := a + 1\na := 5",
        "given a > b\nb := 3",
        "u := v + 1\nv := u + 1",
        "a > 0\nf(x) := f(x) + 1",
        "f(x) := x**2\nbare: f == x**2",
        "f(x) := x**2\npower: f^2(x) == x^4",
        "e real; given 0 < e < 1\neuler: e**n == E**n",
    ],
)
def test_a_name_has_one_meaning_in_the_whole_file(text: str) -> None:
    assert 2 in [problem.line for problem in read_paper(text).problems]
