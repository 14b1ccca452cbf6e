"""Wrong words on the command line: one line that says what was meant, and status 2."""

from pathlib import Path

import pytest

import tresym
from tresym.commands import main

WRONG = [
    (["chek", "x > 0"], "there is no command 'chek'; did you mean check?"),
    (["vrify"], "did you mean verify?"),
    (["zzz"], "there is no command 'zzz'; known: verify,"),
    (["check", "--gven", "x > 0", "x > 1"], "'--gven'; did you mean --given? (see tresym check"),
    (["verify", "--ful"], "did you mean --full?"),
    (["docs", "nonsense"], "there is no argument 'nonsense' (see tresym docs"),
    (["completion", "fish"], "there is no choice 'fish'; known: bash, zsh"),
    (["check", "-f", "nofile"], "nofile: no such file"),
    (["sweep", "-o", "t.csv", "--a", "1", "--b", "1/2"], "write -o TABLE.sqlite --export t.csv"),
]


@pytest.mark.parametrize(("words", "says"), WRONG)
def test_a_wrong_word_is_told_in_one_line(
    words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    found = capsys.readouterr()
    assert found.out == ""
    assert says in found.err
    assert found.err.count("\n") == 1


def test_a_binary_file_is_no_list_of_claims(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "picture.png"
    path.write_bytes(b"\x89PNG\x00\x00\x01" * 100)
    assert main(["check", "-f", str(path)]) == 2
    assert capsys.readouterr().err.strip().endswith("this is a binary file, not a list of claims")


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["--nosuch"], "there is no option '--nosuch' before the command"),
        (["expand", "x", "--as", "x -> 0", "--terms", "-3"], "'-3' is not a number of terms"),
        (["table", "x", "y", "--as", "x -> 0", "--digits", "9999999"], "from 1 to 10000"),
        (["verify", "nosuch.tresym"], "nosuch.tresym: no such file"),
        (["verify", "main_theorm"], "did you mean main_theorem?"),
        (["chekc", "x > 0"], "did you mean check?"),
    ],
)
def test_a_wrong_input_gets_a_line_that_says_what_to_write(
    words: list[str], line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    shown = capsys.readouterr().err
    assert line in shown
    assert shown.count("\n") == 1


def test_the_witness_is_named_once() -> None:
    sentence, rows = tresym.check("sin(2*x) == sin(x)").in_text()
    assert "x = 441/388" in sentence
    assert "witness" not in dict(rows)
    assert tresym.check("sin(2*x) == sin(x)").as_json()["witness"] == {"x": "441/388"}
