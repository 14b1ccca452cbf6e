"""Tokens: what does not print is dropped, what prints stays, in order."""

import pytest

from tresym.reals.language.latex_tokens import (
    MAX_CHARACTERS,
    MAX_DEPTH,
    Spaced,
    tokenize,
    with_sign,
)
from tresym.reals.numbers.exact import InputError


@pytest.mark.parametrize(
    ("source", "tokens"),
    [
        ("x+1.50y", "x + 1.50 y"),
        (r"\alpha_{12}", r"\alpha _ { 12 }"),
        (r"\left( x \right)", "( x )"),
        (r"\bigl( x \Bigr)", "( x )"),
        (r"\left| x \right|", r"\left| x \right|"),
        (r"\lvert x \rvert", r"\left| x \right|"),
        (r"\lbrace x \rbrace", r"\{ x \}"),
        (r"x\label{eq:1}=y\tag{2}", "x = y"),
        (r"a \\[2mm] b", r"a \\ b"),
        ("x % not this\n+ y", "x + y"),
        (r"\mathrm{sin} x", r"\sin x"),
        (r"\operatorname{arcsinh}(x)", r"\arcsinh ( x )"),
        (r"\text{ for } x", r"\conditionfor x"),
        (r"\mathrm d x", "d x"),
        (r"3\,\text{rad}", "3"),
        (r"{\sin}x", r"\sin x"),
        (r"{\sin^2}x", r"\sin ^2 x".replace("^2", "^ 2")),
        ("x := y", "x := y"),
        ("x == y", "x == y"),
        (r"\mathcal{O}(x)", "O ( x )"),
        (r"\text{for all } x", r"\conditionfor x"),
        (r"x_{\text{max}}+x_\text{rad}", "x _ { m a x } + x _ { r a d }"),
        (r"\text{max}", r"\text { m a x }"),
        (r"\operatorname{arcoth}x", r"\arcoth x"),
    ],
)
def test_tokens(source: str, tokens: str) -> None:
    assert tokenize(source) == tokens.split()


def test_a_space_that_prints_is_remembered() -> None:
    tokens = tokenize(r"a\,b \! c\quad d e")
    assert tokens == list("abcde")
    assert [isinstance(token, Spaced) for token in tokens] == [False, True, False, True, False]


def test_declared_words_are_one_token() -> None:
    assert tokenize("ab+a b", frozenset({"ab"})) == ["ab", "+", "ab"]
    assert tokenize("ab") == ["a", "b"]


@pytest.mark.parametrize("source", ["x" * (MAX_CHARACTERS + 1), "{" * (MAX_DEPTH + 1)])
def test_what_is_too_much_is_refused(source: str) -> None:
    with pytest.raises(InputError):
        tokenize(source)


def test_a_double_sign_is_one_sign_or_the_other() -> None:
    tokens = tokenize(r"x\pm y\mp z")
    assert [" ".join(with_sign(tokens, sign)) for sign in "+-"] == ["x + y - z", "x - y + z"]
