"""Every link of a display must be said by a claim: met where it is, left over where it is not."""

from dataclasses import replace

import pytest
from sympy import Basic, Eq, Equivalent, Matrix, Symbol, Tuple, cos, sin, sqrt
from sympy_statements import Rounds, equal

from tresym.ledger.audit.transcription import Reading, differing, functions_of, unmet
from tresym.ledger.claim import (
    Claim,
    Definition,
    Printed,
    all_of,
)
from tresym.ledger.evidence.decided import Decided
from tresym.reals.language.latex import read_latex
from tresym.reals.language.latex_author import Author, Function
from tresym.reals.language.parsing import parse

x, y, z = (Symbol(name, real=True) for name in "xyz")


def claim(says: Basic | str, proof: object = Definition(), given: tuple = ()) -> Claim:
    return Claim(str(says), says, proof, given=given)


AS_IT_STANDS = Reading()


def left_over(latex: str, *claims: Claim, reading: Reading = AS_IT_STANDS) -> list[str]:
    chains = read_latex(latex, reading.author({}))
    return [str(link) for link in unmet(chains, claims, {}, reading.reads)]


DISPLAYS = [
    ("y = x^2 + 1", equal(y, x**2 + 1), equal(y, x**2 - 1)),
    ("x^2 + 1 = y", equal(y, x**2 + 1), equal(y, 1 - x**2)),
    (r"x \le y", x <= y, x < y),
    (r"y \ge x", x <= y, y <= x),
    (r"0 < x < 1", Tuple(x > 0, x < 1), Tuple(x > 0, x <= 1)),
    (r"y = (x+1)^2 = x^2 + 2x + 1", equal(y, (x + 1) ** 2), equal(y, (x + 2) ** 2)),
    (r"y = \sin x", Tuple(equal(y, sin(x)), x > 0), Tuple(equal(y, cos(x)), x > 0)),
    (
        r"y = \sqrt{x^2}",
        Equivalent(Eq(y, sqrt(x**2)), Eq(z, 1)),
        Equivalent(Eq(y, x), Eq(z, 1)),
    ),
    (
        "y = x",
        Eq(Matrix([y, z]), Matrix([x, 1]), evaluate=False),
        Eq(Matrix([z, y]), Matrix([x, 1]), evaluate=False),
    ),
]


@pytest.mark.parametrize(("latex", "says", "_"), DISPLAYS, ids=[d[0] for d in DISPLAYS])
def test_a_display_that_is_said(latex: str, says: Basic, _: Basic) -> None:
    extra = [claim(equal((x + 1) ** 2, x**2 + 2 * x + 1))]
    assert left_over(latex, claim(says), *extra) == []


@pytest.mark.parametrize(("latex", "_", "wrong"), DISPLAYS, ids=[d[0] for d in DISPLAYS])
def test_a_slip_is_left_over(latex: str, _: Basic, wrong: Basic) -> None:
    assert left_over(latex, claim(wrong))
    assert left_over(latex)


def test_agreement_is_asked_under_the_conditions_of_the_claim_alone() -> None:
    says = equal(y, sqrt(x**2))
    assert left_over("y = x", claim(says, given=(x > 0,))) == []
    assert left_over("y = x", claim(says)) == ["y == x"]


def test_a_condition_above_a_column_is_one_of_the_claim() -> None:
    display = r"\begin{array}{l}\textrm{For }x>0: \\ y=\sqrt{x}\end{array}"
    says = equal(y, sqrt(x))
    assert left_over(display, claim(says, given=(x > 0, y > 0))) == []
    for other in ((), (x > 1,), (x < 0,)):
        assert left_over(display, claim(says, given=other)) == ["y == sqrt(x)"]


def test_sentences_numbers_and_conjunctions() -> None:
    number = replace(claim("a number", Printed()), means=Rounds(y, "1.25"))
    assert left_over("y = 1.25", number) == []
    assert left_over("y = 1.26", number) == ["y == 1.26"]
    sentence = replace(claim("in words", Decided()), means=equal(y, x))
    both = claim("both", all_of(sentence, number))
    assert left_over("y = x", sentence) == left_over("y = x", both) == []
    assert left_over("y = x", claim("in words", Definition())) == ["y == x"]


def test_names_may_be_read_otherwise() -> None:
    says = claim(equal(y, x**2))
    assert left_over("y = q", says) == ["y == q"]
    assert left_over("y = q", says, reading=Reading(reads={"q": "x**2"})) == []
    assert left_over("y = q", says, reading=Reading(reads={"q": "x**3"})) == ["y == q"]


def test_functions_of_several_arguments_are_found() -> None:
    found = functions_of(["f(a, b) = a + b^2", "g(x, y) = f(x, 2y)", "h(x, y) = h + x", r"\oops"])
    assert found == {
        "f": Function(("a", "b"), parse("a + b**2")),
        "g": Function(("x", "y"), parse("x + (2*y)**2")),
    }
    (chain,) = read_latex("g(1, z) = 3", Author(found))
    assert chain.terms[0] == parse("1 + (2*z)**2")


def test_functions_of_a_sentence_are_read_in_their_display() -> None:
    says = claim(equal(y, (x + 1) ** 2))
    told = Reading(functions={"q(s)": "s**2"})
    assert left_over("y = q(x+1)", says, reading=told) == []
    assert left_over("y = q(x-1)", says, reading=told) == ["y == (x - 1)**2"]
    assert told.otherwise == "q(s) read as s**2"


@pytest.mark.parametrize(
    ("again", "same"),
    [
        (("y == 1 + x**2",), True),
        (("y == 1 - x**2",), False),
        (("y < 1 + x**2",), False),
        ((), False),
        (("y == 1 + x**2", "y > 0"), False),
    ],
)
def test_a_second_transcription(again: tuple[str, ...], same: bool) -> None:
    assert (differing(read_latex("y = x^2 + 1"), again) is None) is same
