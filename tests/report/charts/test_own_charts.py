"""Charts of a user's own expressions: each is drawn, says what it shows, and refuses the rest."""

from pathlib import Path

import pytest

from tresym.commands import main

DRAWN = (
    ["error", "tan(x)", "x", "x + x**3/3", "--as", "x -> 0+"],
    ["error", "exp(1/x)", "1 + 1/x", "--as", "x -> oo", "--at", "10,20,40"],
    ["stability", "(1 - cos(x))/x**2", "--given", "0 < x <= 1"],
    ["stability", "sqrt(x + y) - sqrt(x)", "--given", "1 <= x <= 2, 0 < y <= 1"],
    ["work-precision", "exp(x)", "--given", "x == 1/3"],
)


@pytest.mark.parametrize("asked", DRAWN)
@pytest.mark.slow
def test_it_is_drawn(asked: list[str], tmp_path: Path) -> None:
    path = tmp_path / "chart.svg"
    assert main(["chart", *asked, "-o", str(path)]) == 0
    text = path.read_text(encoding="utf-8")
    assert "<desc>" in text
    assert "<title>" in text


def test_the_bound_is_in_the_legend_and_holds(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["chart", "error", "tan(x)", "x", "--as", "x -> 0+", "--on", "0 < x <= 1"]) == 0
    assert "between 0.557407 and 0.557603" in capsys.readouterr().out


@pytest.mark.parametrize(
    "asked",
    [
        ["error", "tan(x)"],
        ["error", "tan(x)", "x"],
        ["error", "tan(x)", "x", "--as", "y -> 0"],
        ["error", "x", "x", "--as", "x -> 0"],
        ["stability", "x"],
        ["stability", "x", "y", "--given", "x > 0"],
        ["work-precision", "x", "--given", "x > 0"],
        ["work-precision", "log(x)", "--given", "x == -1"],
        ["honesty", "x"],
        ["nosuch", "x"],
    ],
)
def test_what_cannot_be_drawn_is_refused_in_a_line(
    asked: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["chart", *asked]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.strip().count("\n") == 0
