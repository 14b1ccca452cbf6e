"""What holds where in a file: lines let, assumptions, sections, and other files."""

from pathlib import Path

import pytest

from tresym.papers.reading import read_file, read_paper
from tresym.papers.verification import PaperReport, verify_paper
from tresym.report.pages.own_paper import document

BASE = """\
a, b real; given a > 0, 0 < b <= 1
mu := sqrt(b/(a + b))
r0 := root(x*exp(x) - a, x, 0, oo)
below: mu < 1
half: r0 < a*(1 + b) using below
"""
TEXT = """\
# Scope
use mu, half from base
I1, I2, I3 positive; given I1 < I2 < I3
let d08 (8): c := I2/I1 - 1, d := 1 - I2/I3
let rounded: I1 ~= 1210, I2 ~= 16380
c, d real
square [line 12]: mu**2 == b/(a + b)
ordered: c > 0 and d > 0 using d08
free: c > 0 expect refuted
number: c ~= 12.5 using d08 given rounded
number_wrong: c ~= 12.54 using d08, rounded expect refuted
without: I2/I1 ~= 13.5 expect refuted
imported: r0 < 2*a
p, q real; given p > 0
twice := 2*p
let small: p := q**2 + 1
inside: twice == 2*q**2 + 2 using small
inside_wrong: twice == 2*q**2 using small expect refuted
## One
u, v real; given u > 0
assume law (9): v == u**2
pos: v > 0
pos_wrong: v >= u expect refuted
at_values: v == 4 at u == 2
f(x) := x*u
at_one: f(1) > 0
## Two
u real
other: u > 0 expect refuted
psi real
g(psi) := exp(psi)*u
assume value: integral(g(psi), psi, 0, v) == 7
used: 2*integral(g(psi), psi, 0, v) == 14 [value]
  == 10 + 4 [by arithmetic]
used_wrong: 2*integral(g(psi), psi, 0, v) == 15 expect refuted instead used
unused: exp(u) > 0
restricted: integral(exp(psi), psi, 0, v) == 7/u
free_again: u*integral(exp(psi), psi, 0, v) == 7
interval: u**2 <= u for all u in [0, 1]
## Three
u, v real
unrestricted: integral(exp(psi), psi, 0, v) == 7/u expect refuted
"""


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> PaperReport:
    folder = tmp_path_factory.mktemp("papers")
    (folder / "base.tresym").write_text(BASE, encoding="utf-8")
    (folder / "main.tresym").write_text(TEXT, encoding="utf-8")
    paper = read_file(folder / "main.tresym")
    assert not paper.problems
    return verify_paper(paper, processes=1, cached=False, suggest=False)


def test_each_claim_holds_in_its_scope(report: PaperReport) -> None:
    unexpected = [row.label for row in report.rows if not row.as_expected]
    assert unexpected == ["restricted", "free_again"]
    assert "where value need not hold" in report["restricted"].why
    verdicts = {label: row.verdict.value for label, row in report.by_label.items()}
    assert verdicts["law"] == verdicts["value"] == "ASSUMED"
    assert verdicts["below"] == "PROVED"  # half uses it, so that it is taken over
    assert verdicts["r0"] == verdicts["mu"] == "DEFINED"


def test_what_rests_on_an_assumption_says_so(report: PaperReport) -> None:
    resting = {label for label, row in report.by_label.items() if row.axioms}
    assert resting == {"pos", "pos_wrong", "at_values", "at_one", "used", "used_wrong"}
    assert report["at_values"].axioms == ("law",)
    assert report["used"].axioms == ("value",)


def test_json_and_article_name_places_and_alternatives(report: PaperReport) -> None:
    assert report["square"].as_json()["place"] == "line 12"
    assert report["law"].as_json()["kind"] == "assumption"
    assert report["used_wrong"].as_json()["amended_by"] == ["used"]
    text = document(report, "markdown")
    assert "Where `d08` (8) is used: $c := \\frac{I_{2}}{I_{1}} - 1$" in text


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("late: f(1) > 0", "declared again since"),
        ("c: x > 0 using d09", "no claim above"),
        ("let d10: mu := 3", "has another meaning"),
        ("n natural\nlet d10: n := 1/2", "declared as an integer"),
        ("assume bad: x > 0 given x > 1", "without clauses"),
        ("assume bad: integral(psi, psi, 0, v) > 3", "is no condition"),
        ("use mu from nowhere", "no such file"),
        ("use nothing from base", "nothing is not in base.tresym"),
        ("use mu from main", "in a circle"),
        ("d08: x > 0", "is the label of line 4"),
        ("a real\n## Four\na real\n", "declared"),
    ],
)
def test_what_has_no_place_is_refused(line: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "base.tresym").write_text(BASE, encoding="utf-8")
    (tmp_path / "main.tresym").write_text(f"{TEXT}{line}\n", encoding="utf-8")
    problems = read_file(tmp_path / "main.tresym").problems
    if message == "declared":  # in a later section it is another variable
        assert not problems
        return
    assert any(message in problem.message for problem in problems), problems


def test_what_stands_before_the_first_section_holds_for_the_whole_file() -> None:
    (problem,) = read_paper("a real; given a > 0\n## One\na real\n").problems
    assert "declared on line 1 already" in problem.message


def test_files_do_not_use_one_another_in_a_circle(tmp_path: Path) -> None:
    (tmp_path / "one.tresym").write_text("use v from two\nu := 1\n", encoding="utf-8")
    (tmp_path / "two.tresym").write_text("use u from one\nv := 1\n", encoding="utf-8")
    (problem,) = read_file(tmp_path / "one.tresym").problems
    assert "in a circle" in problem.message


def test_a_numbered_root_is_selected_by_conditions_on_the_path() -> None:
    text = (
        "n natural\nx real\nr: x == (n + 1/2)*pi + O(exp(-n*pi)) given cos(x)*cosh(x) == 1, "
        "n*pi < x, x < (n + 1)*pi as n -> oo\n"
    )
    claim = read_paper(text).claims["r"]
    assert [str(link[0]) for link in claim.near_end] == ["n"]
    assert len(claim.conditions) == 4
