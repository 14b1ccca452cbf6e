"""``tresym flip`` as a user meets it: answers, files, bad input, start-up."""

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from flint import arb
from hangs import HANGS

from tresym.commands import main
from tresym.commands.flip import _told
from tresym.output import colour_wanted
from tresym.racket.flip import flip_defect
from tresym.reals.numbers.arithmetic import ball_precision

ROOT = Path(__file__).resolve().parents[2]


def run_python(*words: str, **options: object) -> subprocess.CompletedProcess[str]:
    """A fresh interpreter, without colour, that sees this checkout."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1"}
    return subprocess.run(
        [sys.executable, *words],
        capture_output=True,
        encoding="utf-8",
        env=environment,
        check=False,
        **options,  # type: ignore[call-overload]
    )


def test_json_has_the_ball_in_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flip", "--body", "str", "--digits", "30", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert list(answer)[:3] == ["a", "b", "gamma"]
    assert (answer["a"], answer["b"], answer["digits"]) == ("1517/121", "55/874", 30)
    with ball_precision(200):
        mid, rad = arb(answer["defect"]["mid"]), arb(answer["defect"]["rad"])
        truth = flip_defect("1517/121", "55/874", digits=50).defect
        assert abs(truth - mid) <= rad
        assert rad <= mid * arb("1e-30")


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["--psi0", "0.3", "--rate", "0.2"],
        ["--psi0", "0.1", "--rate", "0.4", "--digits", "40"],
        ["--gamma", "12345/1234567", "--digits", "40"],
    ],
)
def test_fifty_digits_fit_a_terminal(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flip", "--body", "str", *words]) == 0
    assert max(map(len, capsys.readouterr().out.splitlines())) <= 80


def test_numbers_are_shown_as_they_were_given(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flip", "--shape", "12.5372", "0.0629", "--gamma", "0.001"]) == 0
    assert "a = 12.5372,   b = 0.0629,   γ = 0.001\n" in capsys.readouterr().out


def test_a_long_number_is_one_word_that_can_be_copied(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flip", "--body", "str", "--digits", "200"]) == 0
    assert any(len(word) > 200 for word in capsys.readouterr().out.split())


def test_the_three_ways_to_name_a_body_agree(capsys: pytest.CaptureFixture[str]) -> None:
    defects = set()
    for words in (
        ["--body", "str"],
        ["--inertia", "1210", "16380", "17480"],
        ["--inertia", "0.121e-2", "1.638e-2", "1.748e-2"],
        ["--shape", "1517/121", "55/874"],
    ):
        assert main(["flip", *words, "--json"]) == 0
        defects.add(json.loads(capsys.readouterr().out)["defect"]["mid"])
    assert len(defects) == 1


def _never_a_thousand(args: argparse.Namespace, digits: int, colour: bool) -> str:
    if digits == 1000:
        time.sleep(HANGS)
    return _told(args, digits, colour)


@pytest.mark.slow
def test_what_is_known_when_time_is_over(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("tresym.commands.flip._told", _never_a_thousand)
    monkeypatch.setattr("tresym.commands.flip.PATIENCE", 0.5)
    words = ["flip", "--body", "str", "--digits", "1000", "--json", "--limit", "1.5"]
    assert main(words) == 1
    out, err = capsys.readouterr()
    found = json.loads(out)
    assert found["digits"] in (5, 50, 500)
    assert found["defect"]["mid"].startswith("0.1149441")
    assert err == (
        "tresym: flip: still computing, for 1 s more at most; see --limit\n"
        f"tresym: flip: after 1.5 s {found['digits']} of 1000 digits are known; see --limit\n"
    )


def test_nothing_is_written_where_nothing_is_known(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "answer"
    extreme = ["flip", "--shape", "1e-9999", "1", "--digits", "9999", "--gamma", "1e-9999"]
    assert main([*extreme, "--limit", "0.001", "-o", str(target)]) == 1
    assert capsys.readouterr().err.count("no digits are known") == 1
    assert not target.exists()


def test_a_limit_changes_no_answer_and_no_complaint(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("tresym.commands.flip.PATIENCE", 4000.0)
    for words in (["--rung", "asymptotic"], ["--rung", "carlson"], ["--psi0", "1", "--rate", "2"]):
        asked = ["flip", "--body", "str", "--json", *words]
        status, (out, err) = main(asked), capsys.readouterr()
        assert main([*asked, "--limit", "3000"]) == status
        again, complaint = capsys.readouterr()
        assert (_untimed(again), complaint) == (_untimed(out), err)


def _untimed(text: str) -> dict[str, object] | None:
    return json.loads(text) | {"seconds": 0} if text else None


def test_the_text_says_what_a_person_wants_to_know(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flip", "--body", "racket-1"]) == 0
    text = capsys.readouterr().out
    for part in ("racket 1", "0.0251", "π(1 − ", "°", "separatrix", "no: b > 1/(a+2)", "formula"):
        assert part in text
    assert "\x1b" not in text
    assert main(["flip", "--shape", "1e40", "1", "--digits", "20"]) == 0
    assert "0 ± " in capsys.readouterr().out


BAD = [
    (["--shape", "-1", "0.5"], "shape parameter a: must be positive"),
    (["--shape", "-1e5", "0.5"], "shape parameter a: must be positive"),
    (["--shape", "-inf", "0.5"], "'-inf' is not a number"),
    (["--shape", "1", "0"], "symmetric top"),
    (["--shape", "1", "-1/3"], "shape parameter b: must be in (0, 1]"),
    (["--shape", "1", ""], "shape parameter b: '' is not a number"),
    (["--shape", "__import__('os')", "1"], "is not a number"),
    (["--shape", "1" * 10_001, "1"], "beyond the limit of 10000"),
    (["--shape", "1"], "expected 2 arguments"),
    (["--inertia", "-1", "2", "3"], "moment I1: must be positive"),
    (["--inertia", "0", "2", "3"], "moment I1: must be positive"),
    (["--inertia", "nan", "2", "3"], "is not a number"),
    (["--inertia", "3", "1", "2"], "expected order is I1 < I2 < I3"),
    (["--body", "rackett-1"], "did you mean racket-1"),
    (["--body", ""], "known: str,"),
    (["--body", "str", "--shape", "1", "1"], "not allowed with"),
    (["--body", "str", "--digits", "0"], "integer from 1 to 10000"),
    (["--body", "str", "--digits", "-5"], "integer from 1 to 10000"),
    (["--body", "str", "--digits", "1000000000"], "integer from 1 to 10000"),
    (["--body", "str", "--digits", "٣"], "integer from 1 to 10000"),
    (["--body", "str", "--digits", "9" * 5000], "integer from 1 to 10000"),
    (["--body", "str", "--rung", "lift"], "model: 'lift' is not known"),
    (["--body", "str", "--nonsense"], "there is no argument '--nonsense'"),
    (["--body", "str", "-o", "/nonexistent/folder/x"], "cannot be written"),
    ([], "is required"),
]


@pytest.mark.parametrize(("words", "says"), BAD)
def test_bad_input_is_one_line_and_status_2(
    words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["flip", *words]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert says in err
    assert err.startswith("tresym: ")
    assert err.count("\n") == 1


def test_a_file_is_written_whole_or_not_at_all(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "answer.json"
    assert main(["flip", "--body", "book", "--json", "-o", str(path)]) == 0
    assert capsys.readouterr().out == ""
    assert json.loads(path.read_text(encoding="utf-8"))["realizable"] is True
    assert main(["flip", "--body", "book", "-o", str(tmp_path)]) == 2
    assert [p.name for p in tmp_path.iterdir()] == ["answer.json"]


def test_python_dash_m_and_ascii_terminals_work() -> None:
    done = run_python("-m", "tresym", "flip", "--body", "book")
    assert (done.returncode, done.stderr) == (0, "")
    assert "Goldstein" in done.stdout
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONIOENCODING": "ascii"}
    plain = subprocess.run(
        [sys.executable, "-m", "tresym", "flip", "--body", "book"],
        capture_output=True,
        env=environment,
        check=True,
    )
    assert b"0.2118" in plain.stdout


def test_flip_loads_flint_and_nothing_heavy() -> None:
    code = (
        "import sys; from tresym.commands import main; "
        "main(['flip', '--shape', '12.5372', '0.0629']); "
        "print([m for m in ('numpy', 'sympy', 'mpmath', 'scipy', 'matplotlib', "
        "'dataclasses', 'json') if m in sys.modules])"
    )
    done = run_python("-c", code)
    assert done.stdout.splitlines()[-1] == "[]"


def test_importing_tresym_loads_nothing() -> None:
    code = "import sys, tresym; print([m for m in ('flint', 'numpy', 'sympy') if m in sys.modules])"
    assert run_python("-c", code).stdout == "[]\n"


def test_a_closed_pipe_is_quiet() -> None:
    command = f"'{sys.executable}' -m tresym flip --body str --digits 10000 | head -c 10 >/dev/null"
    done = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command],
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        check=False,
    )
    assert done.stderr == b""


@pytest.mark.parametrize(
    ("words", "status"),
    [("check 'sin(x) == x'", 1), ("check 'x == x'", 0), ("verify eq_gamma", 0)],
)
def test_a_closed_pipe_does_not_change_the_exit_status(words: str, status: int) -> None:
    command = f"'{sys.executable}' -m tresym {words} | true; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(
        ["bash", "-c", command],
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        check=False,
    )
    assert (done.returncode, done.stderr) in ((status, b""), (141, b""))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_one_line() -> None:
    command = f"'{sys.executable}' -m tresym flip --body str >/dev/full"
    done = subprocess.run(
        ["bash", "-c", command],
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr == b"tresym: output: No space left on device\n"


def test_colour_is_for_terminals_only(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert colour_wanted()
    monkeypatch.setenv("NO_COLOR", "1")
    assert not colour_wanted()


def test_ctrl_c_ends_with_130(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr("tresym.racket.flip.model_selection.climb", interrupted)
    assert main(["flip", "--body", "str"]) == 130
