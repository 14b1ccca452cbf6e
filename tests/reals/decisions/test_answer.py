"""Answers: what holds counts as true, what is shown is apart, and JSON has every key."""

import json
from dataclasses import fields

import pytest
from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Obligation, ball_text, constant_ball, refuted
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal, parse_number
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize("verdict", Verdict)
def test_an_answer_is_true_where_its_verdict_holds(verdict: Verdict) -> None:
    assert bool(Answer(verdict, "why")) is verdict.holds


@pytest.mark.parametrize("exponent", [1, 10, 30, 200, 1000])
def test_a_refutation_shows_the_two_sides_apart(exponent: int) -> None:
    with ball_precision(4000):
        left, right = arb(1), 1 + arb(fmpq(1, 10) ** exponent)
    answer = refuted("it fails", {"x": fmpq(1, 3)}, left, right)
    assert answer.values is not None
    (x, r), (y, s) = (tuple(map(parse_number, ball)) for ball in answer.values)
    assert y - x > r + s
    assert answer.witness == {"x": "1/3"}
    assert not answer


def test_equal_sides_are_shown_briefly() -> None:
    with ball_precision(2000):
        x = arb(2).sqrt()
    answer = refuted("equal", {}, x, x)
    assert answer.values is not None
    assert len(answer.values[0].mid) < 40


def test_values_beyond_the_exponents_that_are_read() -> None:
    with ball_precision(64):
        answer = refuted("why", {}, arb(10) ** 10**6, arb(0))
    assert answer.values is not None
    assert "e+" in answer.values[0].mid or len(answer.values[0].mid) < 2 * 10**6


def test_an_irrational_witness_is_written_exactly() -> None:
    answer = refuted("why", {"x": parse("sqrt(2)/2"), "y": fmpq(-1, 7)})
    assert answer.witness is not None
    assert parse(answer.witness["x"]) == parse("sqrt(2)/2")
    assert answer.witness["y"] == "-1/7"
    assert answer.values is None
    answer = refuted("why", {"x": parse("-sqrt(32/9)/2")})
    assert answer.witness == {"x": "-2*sqrt(2)/3"}


@pytest.mark.parametrize("text", ["pi", "1/3", "10**30*sqrt(2)", "exp(-70)"])
def test_a_constant_is_contained_in_its_decimal(text: str) -> None:
    from tresym.reals.domain.evaluation import evaluate

    with ball_precision(300):
        x = evaluate(parse(text), {})
        shown = constant_ball(x)
        mid, rad = parse_number(shown.mid), parse_number(shown.rad)
        assert arb(mid) - arb(rad) <= x <= arb(mid) + arb(rad)
        assert rad < mid / 10**5


def test_a_ball_in_words() -> None:
    assert ball_text(Decimal("1.5", "0")) == "1.5"
    assert ball_text(Decimal("1.5", "1e-3")) == "1.5 ± 1e-3"


FULL = Answer(
    Verdict.REFUTED,
    "it <fails>",
    statement="x < 1 & y",
    given="x > 0",
    witness={"x": "2"},
    values=(Decimal("2", "0"), Decimal("1", "1e-9")),
    constant=Decimal("3", "1"),
    region="0 < x",
    line=7,
)


def test_json_has_every_key_and_plain_values() -> None:
    for answer in (FULL, Answer(Verdict.UNDECIDED, "why")):
        value = json.loads(json.dumps(answer.as_json()))
        assert value.keys() >= {field.name for field in fields(Answer)}
        assert value["verdict"] == answer.verdict.value
    assert FULL.as_json()["values"][1] == {"mid": "1", "rad": "1e-9"}
    assert FULL.as_json()["witness"] == {"x": "2"}


def test_the_lemma_and_its_obligations_are_shown_and_stored() -> None:
    part = Obligation("x > 0", "x > 1", "PROVED")
    answer = Answer(Verdict.PROVED, "by a lemma", lemma="a lemma (Olver 1974)", obligations=(part,))
    assert answer.as_json()["obligations"] == [part._asdict()]
    assert dict(answer.rows())["lemma"] == "a lemma (Olver 1974)"
    assert "  obligation: x > 0 given x > 1: PROVED" in str(answer).splitlines()


def test_text_shows_what_there_is_and_nothing_empty() -> None:
    rows = dict(FULL.rows())
    assert rows["witness"] == "x = 2"
    assert rows["right side"] == "1 ± 1e-9"
    assert all(rows.values())
    assert str(FULL).splitlines()[0] == "REFUTED: it <fails>"
    assert {name for name, _ in Answer(Verdict.PROVED, "why").rows()} <= {"why", "read as"}


def test_the_first_line_has_the_verdict_and_the_first_clause_of_the_reason() -> None:
    answer = Answer(Verdict.PROVED, "it holds (a; b) everywhere; defined at x = 0", statement="s")
    assert str(answer).splitlines() == [
        "PROVED: it holds (a; b) everywhere; defined at x = 0",
        "  claim: s",
    ]
    answer = Answer(Verdict.PROVED, "it holds; defined at x = 0; and y = 1", statement="s")
    assert str(answer).splitlines() == [
        "PROVED: it holds",
        "  claim: s",
        "  note: defined at x = 0; and y = 1",
    ]


def test_long_numbers_are_abbreviated_in_text_and_whole_in_json() -> None:
    read_as = f"x > 1/{10**1000} + {10**59}"
    answer = Answer(Verdict.PROVED, f"at x = {10**100}", statement="s", read_as=read_as)
    short = f"x > 1/1000000000…[981 digits]…0000000000 + {10**59}"
    assert dict(answer.rows())["read as"] == short
    assert "1000000000…[81 digits]…0000000000" in str(answer)
    assert answer.as_json()["read_as"] == read_as


def test_constants_refute_without_a_point() -> None:
    assert dict(refuted("why", {}).rows())["witness"] == "the claim has no variables"


def test_notebooks_get_text_that_is_escaped() -> None:
    html = FULL._repr_html_()
    assert "<fails>" not in html
    assert "&lt;fails&gt;" in html


def test_time_does_not_tell_answers_apart() -> None:
    assert Answer(Verdict.PROVED, "why", seconds=1) == Answer(Verdict.PROVED, "why", seconds=2)


def test_notebooks_show_formulas_typeset_and_what_has_no_typesetting_as_text() -> None:
    shown = Answer(Verdict.REFUTED, "why", statement="x**2 < 3*x", witness={"x": "4"})._repr_html_()
    assert "<msup>" in shown
    assert 'title="x**2 &lt; 3*x"' in shown
    shown = Answer(Verdict.PROVED, "why", statement="x == 1 <=> <b>")._repr_html_()
    assert "<math>" not in shown
    assert "&lt;b&gt;" in shown
