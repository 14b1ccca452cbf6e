"""Verdicts on files of claims; each false one passes if its guard is removed."""

import pytest

from tresym.papers.reading import read_paper
from tresym.papers.verification import PaperReport, verify_paper

KEPLER = """\
M, e real; given 0 <= e < 1
u := root(x - e*sin(x) - M, x, M - 2, M + 2)
near: abs(u - M) <= e
equation: u - e*sin(u) == M
value: u ~= 1.1853 at e == 1/5, M == 1
wrong: u ~= 1.1854 at e == 1/5, M == 1 expect refuted
slope: diff(u, M) == 1/(1 - e*cos(u))
"""


def verified(text: str, *labels: str) -> PaperReport:
    paper = read_paper(text)
    assert not paper.problems
    return verify_paper(paper, labels, processes=1, cached=False, suggest=False)


def verdicts(text: str) -> dict[str, str]:
    return {row.label: row.verdict.value for row in verified(text).rows}


def test_kepler() -> None:
    found = verified(KEPLER)
    assert {row.label: row.verdict.value for row in found.rows} == {
        "u": "DEFINED",
        "near": "PROVED",
        "equation": "PROVED",
        "value": "ENCLOSED",
        "wrong": "REFUTED",
        "slope": "PROVED",
    }
    assert found.as_expected


@pytest.mark.parametrize(
    "definition",
    [
        "u := root(3*x - 1/x, x, -1, 1)",  # increasing between signs, with a pole: two roots
        "u := root(x**2 + 1, x, -1, 1)",  # none
        "u := root(x**2 - 1, x, -2, 2)",  # two
        "u := root(x - sign(x), x, -3, 3)",  # three, at jumps
        "u := root(x - a, x, -1, 1)",  # none for a > 1
    ],
)
@pytest.mark.slow
def test_a_root_that_does_not_exist_or_is_not_the_only_one(definition: str) -> None:
    found = verdicts(f"a real\n{definition}\nbound: u**2 <= 4\ncopy := 2*u\n")
    assert set(found.values()) == {"UNDECIDED"}


def test_a_derivative_is_that_of_the_definition() -> None:
    assert verdicts("a real\nu := a**2\nd: diff(u, a) == 0 expect refuted\n")["d"] == "REFUTED"


def test_a_root_inside_an_integral_and_a_derivative_moves_with_their_variable() -> None:
    """As a fixed number W the integral is E*W, and the derivative is 0; Lambert's W is E - 1."""
    text = "x real; given x > 0\nW := root(w*exp(w) - x, w, 0, oo)\n"
    text += "area: integral(W, x, 0, E) == E - 1\nfixed: integral(W, x, 0, E) == E*W\n"
    text += "constant: diff(W, x) == 0 expect refuted\n"
    found = verdicts(text)
    assert found["area"] != "REFUTED"
    assert found["fixed"] not in ("PROVED", "ENCLOSED")
    assert found["constant"] not in ("PROVED", "ENCLOSED")


def test_a_root_that_is_alone_although_its_function_is_not_monotone() -> None:
    text = "peak := root(3*(1 - exp(-z)) - z, z, 1, 4)\nwien: peak ~= 2.821439\n"
    assert verdicts(text) == {"peak": "DEFINED", "wien": "ENCLOSED"}


def test_a_derivative_at_a_point_is_taken_before_the_value_is_put_in() -> None:
    """The sign function has no derivative at 0, where the formal one has the value 0."""
    text = "x real\nf(t) := sign(t)\njump: diff(f(x), x) == 0 at x == 0\n"
    text += "smooth: diff(x**2, x) == 6 at x == 3\nconstant: diff(x**2, x) == 0 at x == 3\n"
    found = verdicts(text)
    assert found["jump"] == "UNDECIDED"
    assert found["smooth"] == "PROVED"
    assert found["constant"] == "REFUTED"


def test_values_must_satisfy_the_declared_conditions() -> None:
    text = "e real; given 0 <= e < 1\ninside: e < 3/4 at e == 1/2\noutside: e > 1 at e == 2\n"
    assert verdicts(text) == {"inside": "PROVED", "outside": "UNDECIDED"}


def test_a_path_on_which_a_condition_fails_decides_nothing() -> None:
    """|e| = e for e >= 0 only: the claim is neither proved nor refuted from both sides."""
    text = "e real; given e >= 0\nright: abs(e) == e + O(e**3) as e -> 0+\n"
    text += "both: abs(e) == e + O(e**3) as e -> 0\n"
    assert verdicts(text) == {"right": "ENCLOSED", "both": "UNDECIDED"}


def test_what_is_used_must_hold_and_under_the_same_conditions() -> None:
    text = "x real\nfirst: x**2 > 1 given x > 2\nsecond: x**2 > 1/2 given x > 2 using first\n"
    assert verdicts(text) == {"first": "PROVED", "second": "PROVED"}
    false = "x real\nfirst: x > 1 expect refuted\n"
    paper = read_paper(f"{false}second: x > 0 using first\n")
    assert "cannot be used" in paper.problems[0].message
    paper = read_paper("x real\nfirst: x > 1 given x > 2\nsecond: x > 0 using first\n")
    assert "add this condition" in paper.problems[0].message
    assert verdicts("x real\nfirst: x > 1\nsecond: x > 0 using first\n")["second"] == "UNDECIDED"


def test_what_is_used_must_have_a_value_where_it_is_used() -> None:
    """log(x) <= x is true where log(x) has a value; as a condition it would say that x > 0."""
    text = "x real\nknown: log(x) <= x\n"
    paper = read_paper(f"{text}false: x > -5 using known\n")
    assert "says nothing where log(x) has no value" in paper.problems[0].message
    found = verdicts(f"{text}inside: log(x) <= x + 1 given x > 0 using known\n")
    assert found["inside"] in ("PROVED", "ENCLOSED")


def test_a_quoted_claim_is_assumed_only_if_it_is_not_decided() -> None:
    text = (
        "x real\nknown: x**2 >= 0 quoted from (Euclid)\n"
        "false: x > 0 quoted from (Nobody 1900)\n"
        "deep: f(x)**2 + 1/f(x)**2 > 1.9 quoted from (Author 2000)\n"
    )
    found = verdicts(text)
    assert found["known"] == "PROVED"
    assert found["false"] == "REFUTED"
    assert found["deep"] in ("ASSUMED", "PROVED", "ENCLOSED")


def test_a_derivation_has_the_verdict_of_its_weakest_step() -> None:
    found = verified("x real\nc: (x - 1)**2 == x**2 - 2*x + 1 == x**2 + 1 expect refuted\n")
    assert [answer.verdict.value for answer in found["c"].answers] == ["PROVED", "REFUTED"]
    assert found["c"].why.startswith("step 2 of 2")


def test_only_what_is_asked_for_and_what_it_uses_is_decided() -> None:
    text = "x real\na := x**2\nb := a + 1\nc := x\none: b > 0\ntwo: c**2 >= 0\n"
    assert [row.label for row in verified(text, "one").rows] == ["a", "b", "one"]


def test_json_has_every_key() -> None:
    found = verified(KEPLER, "near").as_json()
    keys = {"label", "requested", "kind", "says", "means", "formal", "given", "verdict", "expect"}
    keys |= {"value", "constant", "region", "parameter", "steps", "where", "witness", "amended_by"}
    keys |= {"uses", "axioms", "coq", "seconds"}
    assert keys <= set(found["claims"][0]) == set(found["claims"][1])
