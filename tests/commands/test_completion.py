"""What a shell completes, and what `tresym` alone says."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tresym.commands import COMMANDS, main


def script(shell: str, capsys: pytest.CaptureFixture[str]) -> str:
    assert main(["completion", shell]) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (["fl"], ["flip"]),
        (["verify", "eq_gam"], ["eq_gamma"]),
        (["derive", "--ref"], ["--refuted"]),
        (["flip", "--body", "ethy"], ["ethylene"]),
        (["table", "obj"], ["objects"]),
        (["figure", "flip-m"], ["flip-map"]),
        (["nonsense", "eq"], []),
    ],
)
def test_bash_completes(
    words: list[str], found: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bash = shutil.which("bash")
    if bash is None:
        pytest.skip("bash is not installed")
    path = tmp_path / "completion.bash"
    path.write_text(script("bash", capsys), encoding="utf-8")
    line = " ".join(("tresym", *words))
    asked = f'COMP_WORDS=({line}); COMP_CWORD={len(words)}; _tresym; echo "${{COMPREPLY[@]}}"'
    run = subprocess.run(
        [bash, "--norc", "-c", f"source {path}; {asked}"], capture_output=True, text=True
    )
    assert run.stderr == ""
    assert run.stdout.split() == found


def test_zsh_reads_the_same(capsys: pytest.CaptureFixture[str]) -> None:
    assert script("zsh", capsys).endswith(script("bash", capsys))


def test_every_command_is_completed(capsys: pytest.CaptureFixture[str]) -> None:
    text = script("bash", capsys)
    assert all(f"      {name}) words=" in text for name in COMMANDS)


def test_alone_it_says_how_to_begin(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    assert "tresym flip --body wilson" in capsys.readouterr().out
