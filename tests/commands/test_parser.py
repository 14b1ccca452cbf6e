"""Wrong words on the command line: one line that says what was meant, and status 2."""

from pathlib import Path

import pytest

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
