"""Tokens of typed mathematics: what begins and ends them, and bounds on the text."""

import pytest

from tresym.reals.language.spelling_tokens import MAX_NESTING, MAX_TEXT, SUB, tokens


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2x", ["2", "x"]),
        ("1..n", ["1", "..", "n"]),
        ("1.5e-3x", ["1.5e-3", "x"]),
        ("x²y", ["x", "**", "(", "2", ")", "y"]),
        ("∫_0^1", ["∫", SUB, "0", "^", "1"]),
        ("∑₁", ["∑", SUB, "1"]),
        ("sum_{k=1}", ["sum", SUB, "{", "k", "=", "1", "}"]),
        ("x \\geq 0", ["x", ">=", "0"]),
        ("a <=> b", ["a", "<=>", "b"]),
        ("np.sin(x)", ["sin", "(", "x", ")"]),
        ("∂/∂x", ["d", "/", "dx"]),
        ("'+'", ["'+'"]),
    ],
)
def test_tokens(text: str, expected: list[str]) -> None:
    assert [token.text for token in tokens(text)[1]] == expected


def test_a_token_says_where_it_stands() -> None:
    source, found = tokens("x  + 1")
    assert [(token.at, token.spaced) for token in found] == [(0, False), (3, True), (5, True)]
    assert source[found[1].at] == "+"


@pytest.mark.parametrize(
    "text",
    ["x" * (MAX_TEXT + 1), "(" * (MAX_NESTING + 1), "-" * 50, "sin " * 50, "|" * 70],
)
def test_what_is_too_long_or_too_deep_has_none(text: str) -> None:
    assert tokens(text) == ("", [])
