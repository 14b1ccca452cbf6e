"""Claims made of claims in files: scope of conditions, labels, regions, what is printed."""

import pytest

from tresym.papers.reading import read_paper
from tresym.papers.verification import PaperReport, verify_paper
from tresym.report.pages.own_paper import statement_latex

TEXT = """\
a real; given 0 < a < 1
x, y real
t positive
u := a + 1
f(z) := z**2 + u
both: f(x) >= 1 and u > 1
not_both: f(x) >= 1 and u > 3/2 expect refuted
same: f(x) == u <=> x == 0
not_same: f(x) == u + 1 <=> x == 1 expect refuted
one: exactly one x in (0, 2): f(x) == u + 1
not_one: exactly one x in (-2, 2): f(x) == u + 1 expect refuted
positive_one: exactly one t in (0, 2): t**2 == 1
outside: exactly one t in (-1, 2): t**3 == 1
rises: increasing(f(x), x) given x >= 0
falls: increasing(f(x), x) expect refuted
vectors: (x, y) == (1, a) given x == 1, y == a
no_vectors: (x, y) == (1, a) given x == 1 expect refuted
near: sin(x) == x + O(x**3) as x -> 0 on abs(x) <= 1/2
at_a_half: exactly one x in (0, oo): x*exp(x) == a at a == 1/2
at_two: exactly one x in (0, oo): x*exp(x) == a at a == 2
own_path: (sin(t) ~ t as t -> 0+) and t > 0
all: both and same and one
with_more: both and x**2 >= 0
with_false: both and x**2 > 0 expect refuted
with_open: both and outside
some: at some point: f(x) ~= 5.5 given x ~= 2.0
printed: u ~= 1.5 and x > 0 given x > 1 at a == 1/2
used: f(x) > 1 given x > 0 using both
"""


@pytest.fixture(scope="module")
def report() -> PaperReport:
    paper = read_paper(TEXT)
    assert not paper.problems
    return verify_paper(paper, processes=1, cached=False, suggest=False)


def test_each_claim_has_its_verdict(report: PaperReport) -> None:
    unexpected = [row.label for row in report.rows if not row.as_expected]
    assert unexpected == ["outside", "at_two", "with_open"]
    assert "t > 0" in report["outside"].why
    assert "2 < 1" in report["at_two"].why
    assert report["with_open"].why.startswith("outside: ")


def test_json_says_what_was_decided(report: PaperReport) -> None:
    assert report["one"].as_json()["means"] == [
        "exactly one x in (0, 2): x**2 + a + 1 == a + 2 given 0 < a < 1"
    ]
    assert report["all"].as_json()["uses"] == ["both", "same", "one"]
    assert report["near"].as_json()["region"] == "0 < |x| <= 1/2"
    assert set(report["falls"].as_json()["witness"]) == {"a", "x_1", "x_2"}


def test_the_article_prints_the_words(report: PaperReport) -> None:
    shown = {label: statement_latex(claim) for label, claim in report.paper.claims.items()}
    assert shown["same"] == r"f(x) = u \iff x = 0"
    assert shown["one"] == r"\exists!\, x \in (0, 2):\ f(x) = u + 1"
    assert shown["with_more"] == r"\text{both} \quad\text{and}\quad x^{2} \ge 0"
    assert r"\left|x\right| \le \frac{1}{2}" in shown["near"]
    assert r"t \to 0^+" in shown["own_path"]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("bad: exactly one u in (0, 1): u == 1/2", "u is defined on line 4"),
        ("bad: both and not_both", "expected to be refuted"),
        ("bad: a > 0 using one", "no comparison"),
        ("bad: exactly one x in (0, 1): x == eps", "eps is not declared"),
        ("bad: exactly one x in (0, 1): x == y at x == 1", "has no fixed value"),
        ("increasing := 3", "has a meaning of its own"),
        ("bad: (x > 0 given y > 0) <=> x > 1", "the same conditions"),
    ],
)
def test_what_cannot_be_meant_is_refused(line: str, message: str) -> None:
    (problem,) = read_paper(TEXT + line).problems
    assert message in problem.message
