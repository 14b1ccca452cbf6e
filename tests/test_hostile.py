"""Hostile input: one line and a status, never a traceback, a hang or a wrong number.

A few hundred inputs and a few dozen processes in every run; with ``HYPOTHESIS_PROFILE=deep``
10⁵ inputs and 10³ processes.
"""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from flint import ctx

from tresym import InputError, flip_defect
from tresym.arithmetic import ball_precision
from tresym.body import shape
from tresym.cli import main
from tresym.exact import parse_number
from tresym.flip.angle import parse_angle
from tresym.identity.parsing import parse, parse_conditions

ROOT = Path(__file__).resolve().parent.parent
DEEP = os.environ.get("HYPOTHESIS_PROFILE") == "deep"
INPUTS = 100_000 if DEEP else 400
PROCESSES = 1000 if DEEP else 24

PIECES = [
    "0", "1", "-1", "0.0629", "16380/1210", "1e400000", "1e-400000", "1e-10000", "5e-324", "nan",
    "-nan", "inf", "NaN(0x7ff)", "0x1p-3", "1_000", "١٢", "½", "²", "∞", "－１", "1,5", "1;5", "'",
    '"', '"""', "\\", "\n", "\r", "\t", "\0", "\x1b[2J", "\u202e", "\ud800", "\U0001f3be", "(", ")",
    "((((", "[", "]", "{", "}", "+", "-", "*", "/", "**", "^", "==", "<=", ",", ":", ";", "#", "%s",
    "{0}", "$(id)", "__import__('os')", "lambda: 0", "a", "b", "x", "pi", "pi/0", "E", "I", "sqrt",
    "sin(", "log(0)", "atan2(", "diff(", "e9", "e-9", "9" * 50, "." * 3, " " * 5, "True", "None",
]  # fmt: skip


def texts(count: int, number: int) -> list[str]:
    """``count`` hostile texts; the same for the same ``number``."""
    dice = random.Random(number)
    found = []
    for _ in range(count):
        text = "".join(dice.choices(PIECES, k=dice.randint(0, 8)))
        if dice.random() < 0.01:
            text *= dice.choice([100, 5000, 10**5])
        found.append(text)
    return found


def complaint_of(function: Callable[..., object], *values: object) -> str | None:
    """What is said of bad input; any other exception is a failure."""
    try:
        function(*values)
    except InputError as error:
        return str(error)
    return None


def one_line(text: str) -> bool:
    return text.isprintable() and 0 < len(text) < 400


@pytest.mark.parametrize("reader", [parse_number, parse_angle, parse, parse_conditions])
def test_readers_answer_or_refuse_in_one_line(reader: Callable[[str], object]) -> None:
    before = ctx.prec
    for text in texts(INPUTS, 1):
        complaint = complaint_of(reader, text)
        assert complaint is None or one_line(complaint), ascii(text[:100])
    assert ctx.prec == before


def test_the_api_answers_or_refuses_in_one_line() -> None:
    dice = random.Random(2)
    values = [*texts(60, 3), "1", "1/2", "3", 0.5, None, True, float("nan"), 1j, b"1", 10**400]
    for _ in range(INPUTS):
        a, b, gamma, digits = (dice.choice([*values, "1/2", "1/4"]) for _ in range(4))
        digits = dice.choice([digits, 5, 0, 10**9])
        complaint = complaint_of(flip_defect, a, b, gamma, digits)
        if complaint is not None:
            assert one_line(complaint)
            continue
        with ball_precision(200):
            again = flip_defect(*shape(a, b), gamma, 30)
            assert flip_defect(a, b, gamma, digits).defect.overlaps(again.defect)


OPTIONS = [
    "--shape", "--inertia", "--body", "--digits", "--gamma", "--psi0", "--rate", "--theta0",
    "--rung", "--json", "--precession", "-o", "--help", "--", "-", "--dig",
]  # fmt: skip


def command_lines(count: int, number: int) -> list[list[str]]:
    dice = random.Random(number)
    pieces = [text for text in texts(200, number) if "\0" not in text and len(text) < 100_000]
    pieces = [text.encode(errors="replace").decode() for text in pieces]
    found = []
    for _ in range(count):
        words = ["flip", *dice.choice([[], ["--shape", "1", "1/2"], ["--body", "str"]])]
        for _ in range(dice.randint(0, 4)):
            option = dice.choice(OPTIONS)
            if option != "-o":
                words.append(option)
            words.append(dice.choice([*pieces, "1", "0.5", "10", "pi/2"]))
        found.append(words)
    return found


def test_command_lines_end_with_a_status(capsys: pytest.CaptureFixture[str]) -> None:
    for words in command_lines(INPUTS // 4, 4):
        try:
            status = main(words)
        except SystemExit as end:  # --help
            status = end.code
        out, err = capsys.readouterr()
        assert status in (0, 2), words
        assert (status == 0) == (err == ""), words
        assert err.count("\n") == (status == 2)
        assert status == 0 or out == ""


def run(words: list[str], **more: str) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "tresym", *words],
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(ROOT), **more},
        check=False,
        timeout=60,
    )


@pytest.mark.slow
def test_whole_processes_end_with_a_status() -> None:
    for words in command_lines(PROCESSES, 5):
        done = run(words)
        assert done.returncode in (0, 2), words
        assert b"Traceback" not in done.stderr, words


@pytest.mark.slow
@pytest.mark.parametrize("moment", range(PROCESSES // 4))
def test_ctrl_c_at_any_time_after_the_start(moment: int) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", "import tresym.cli; print(flush=True); tresym.cli.main()",
         "flip", "--body", "str", "--digits", "10000", "--gamma", "1/100"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert process.stdout is not None
    process.stdout.readline()
    time.sleep(0.037 * moment)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert b"Traceback" not in err


def test_the_same_json_whatever_the_hash_seed_locale_and_time_zone() -> None:
    answers = []
    for seed, locale, zone in (("0", "C", "UTC"), ("1", "C.UTF-8", "Asia/Tokyo"), ("77", "de", "")):
        done = run(
            ["flip", "--body", "str", "--gamma", "1e-4", "--json"],
            PYTHONHASHSEED=seed,
            LC_ALL=locale,
            TZ=zone,
        )
        answer = json.loads(done.stdout)
        del answer["seconds"]
        answers.append(json.dumps(answer))
    assert len(set(answers)) == 1


@pytest.mark.parametrize("digits", ["1000000000", "1e4", "-1", "10001", "٣", "9" * 5000])
def test_too_many_digits_are_refused_at_once(digits: str) -> None:
    assert main(["flip", "--body", "str", "--digits", digits]) == 2
