"""Damaged files of claims: each line is read or told in one line, and nothing else happens."""

import random
from pathlib import Path

import chunks
import pytest

from tresym.papers.reading import read_paper

FILES = sorted((Path(__file__).resolve().parents[2] / "docs" / "examples").glob("*.tresym"))
SIGNS = "()[]{}*/^+-=<>~,;:.%#>|'\"\\$`_ 0123456789abcxyzeIOuf\t\x00\x1b\u00e9\u2264\U0001f600"
PIECES = [
    "given", "as", "at", "using near", "expect refuted", "quoted from (X)", "x -> 0", ":=", "==",
    "table", "chart", "real", "root(", "integral(", "diff(", "O(", "oo", "1e999999999", "9" * 5000,
    "(" * 200, "f(x)", "~=", "->", "digits 10", "u := ",
]  # fmt: skip
COUNT = 4000 if chunks.DEEP else 300


def damaged(text: str, dice: random.Random) -> str:
    for _ in range(dice.randint(1, 6)):
        place = dice.randrange(len(text))
        kind = dice.random()
        if kind < 0.4:
            text = text[:place] + dice.choice(SIGNS) + text[place + dice.randint(0, 3) :]
        elif kind < 0.7:
            text = text[:place] + f" {dice.choice(PIECES)} " + text[place:]
        elif kind < 0.9:
            text = text[:place] + text[place + dice.randint(1, 30) :]
        else:
            other = dice.randrange(len(text))
            text = text[:place] + text[other : other + 40] + text[place:]
    return text


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_damaged_file_is_read_or_told(path: Path) -> None:
    dice, text = random.Random(chunks.seed_of(3)), path.read_text(encoding="utf-8")
    lines = text.split("\n")
    for _ in range(COUNT // len(FILES)):
        start = dice.randrange(len(lines))
        part = "\n".join(lines[:3] + lines[start : start + 6])
        found = read_paper(damaged(part, dice))
        for line, column, message in found.problems:
            assert line >= 1
            assert column >= 1
            assert message
            assert "\n" not in message
