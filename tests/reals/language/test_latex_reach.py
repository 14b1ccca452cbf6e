"""How far an operand goes: sure where books agree, in doubt where they differ."""

from __future__ import annotations

import pytest
from flint import arb

from tresym.reals.language.latex_reach import (
    Ahead,
    Piece,
    Reach,
    after_braces,
    after_bracket,
    after_derivative,
    after_derivative_of_bracket,
    after_open,
    joined,
    whole,
)
from tresym.reals.language.parsing import parse
from tresym.reals.places.values import evaluate

NUMBER, LETTER = Piece("2"), Piece("x", symbol=True)
NESTED, SUM = Piece("sin(x)"), Piece("n + 1", 0)


@pytest.mark.parametrize(
    ("rule", "piece", "ahead", "reach"),
    [
        (after_open, NUMBER, Ahead("letter"), Reach.GOES_ON),
        (after_open, NUMBER, Ahead("bracket"), Reach.GOES_ON),
        (after_open, LETTER, Ahead("letter"), Reach.GOES_ON),
        (after_open, LETTER, Ahead("bracket"), Reach.DOUBT),
        (after_open, LETTER, Ahead("letter", spaced=True), Reach.DOUBT),
        (after_open, LETTER, Ahead("letter", "/"), Reach.DOUBT),
        (after_open, LETTER, Ahead("function"), Reach.ENDS),
        (after_open, LETTER, Ahead("function", "*"), Reach.ENDS),
        (after_open, NUMBER, Ahead("function"), Reach.DOUBT),
        (after_open, LETTER, Ahead("inverse"), Reach.DOUBT),
        (after_open, NESTED, Ahead("letter"), Reach.DOUBT),
        (after_open, LETTER, Ahead(""), Reach.ENDS),
        (after_bracket, SUM, Ahead("letter"), Reach.DOUBT),
        (after_bracket, LETTER, Ahead("letter"), Reach.ENDS),
        (after_bracket, SUM, Ahead("letter", "*"), Reach.ENDS),
        (after_braces, LETTER, Ahead("letter"), Reach.DOUBT),
        (after_braces, LETTER, Ahead("function"), Reach.ENDS),
        (after_derivative, LETTER, Ahead("letter"), Reach.GOES_ON),
        (after_derivative, LETTER, Ahead("letter", "*"), Reach.DOUBT),
        (after_derivative, LETTER, Ahead("derivative"), Reach.DOUBT),
        (after_derivative, LETTER, Ahead(""), Reach.ENDS),
        (after_derivative_of_bracket, SUM, Ahead("letter"), Reach.DOUBT),
        (after_derivative_of_bracket, SUM, Ahead(""), Reach.ENDS),
        (whole, SUM, Ahead("letter"), Reach.ENDS),
    ],
)
def test_reaches(rule: object, piece: Piece, ahead: Ahead, reach: Reach) -> None:
    assert callable(rule)
    assert rule(piece, ahead) is reach


@pytest.mark.parametrize(
    ("pieces", "operators", "value"),
    [
        ([Piece("1 + x", 0), Piece("1 - x", 0)], "**", -8),
        ([Piece("6"), Piece("2*x", 2)], "*/", 1),
        ([Piece("2"), Piece("-x", 1)], "**", -6),
        ([Piece("x**2", 3), None, Piece("2")], "***", 18),
        ([None], "*", 1),
        ([Piece("1.5"), Piece("10**(-2)", 3)], "**", "3/200"),
        ([Piece("8"), Piece("2"), Piece("10**2", 3)], "*/*", 400),
    ],
)
def test_products_bind_as_they_stand(
    pieces: list[Piece | None], operators: str, value: int | str
) -> None:
    text = joined(pieces, ["", *operators[1:]]).text
    gap = evaluate(parse(text) - parse(str(value)), {"x": arb(3)})
    assert abs(gap) < 1e-12


def test_a_printed_power_of_ten_keeps_its_digits() -> None:
    assert joined([Piece("1.090"), Piece("10**(-2)", 3)], ["", "*"]).text == "1.090e-2"


def test_the_variables_of_a_piece() -> None:
    assert Piece("sin(2*x) + pi*y_1 - 1.5e3*E").names == {"x", "y_1"}
