"""How far an operand goes: sure where books agree, in doubt where they differ."""

import pytest

from tresym.reals.language.latex_operands import (
    Ahead,
    Piece,
    Reach,
    after_braces,
    after_bracket,
    after_derivative,
    after_derivative_of_bracket,
    after_nested,
    after_open,
    decimal,
    joined,
    whole,
)
from tresym.reals.language.parsing import parse

NUMBER, LETTER = decimal("2"), Piece(parse("x"), symbol="x")
NESTED, SUM = Piece(parse("sin(x)")), Piece(parse("n + 1"), 0)


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
        (after_nested, NESTED, Ahead("letter"), Reach.DOUBT),
        (after_nested, NESTED, Ahead("function", "*"), Reach.DOUBT),
        (after_nested, NESTED, Ahead(""), Reach.ENDS),
        (after_open, Piece(parse("pi/4")), Ahead("function"), Reach.ENDS),
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
    ("pieces", "operators", "product"),
    [
        (["1 + x", "1 - x"], "**", "(1 + x)*(1 - x)"),
        (["6", "2*x"], "*/", "6/(2*x)"),
        (["2", "-x"], "**", "2*(-x)"),
        (["x**2", None, "2"], "***", "2*x**2"),
        (["x", "y", "z"], "*/*", "x/y*z"),
    ],
)
def test_products_bind_as_they_stand(
    pieces: list[str | None], operators: str, product: str
) -> None:
    factors = [None if text is None else Piece(parse(text)) for text in pieces]
    assert joined(factors, ["", *operators[1:]]).tree == parse(product)


def test_a_printed_power_of_ten_keeps_its_digits() -> None:
    tenth = Piece(parse("10**(-2)"), 3, printed="1e-2")
    found = joined([decimal("1.090"), tenth], ["", "*"])
    assert (found.printed, found.tree) == ("1.090e-2", parse("0.0109"))
    for factors, operators in (([tenth, tenth], "**"), ([decimal("2"), tenth], "*/")):
        assert joined([*factors], ["", operators[1]]).printed == ""


def test_the_variables_of_a_piece() -> None:
    assert Piece(parse("sin(2*x) + pi*y_1 - 1.5e3*E")).names == {"x", "y_1"}
