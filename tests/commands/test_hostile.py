"""Hostile input: one line and a status, never a traceback, a hang, a wrong number or half a file.

A few hundred inputs and a few dozen processes in every run. ``HYPOTHESIS_PROFILE=deep`` takes 10⁴
inputs for each reader and 100 processes, others for each chunk (see ``tests/deep.py``): ten chunks
are 10⁵ and 10³.
"""

import json
import os
import random
import resource
import signal
import subprocess
import sys
import time
import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple

import chunks
import numpy as np
import pytest
from cases import cases
from flint import ctx, fmpq, fmpz
from hangs import HANGS

from tresym import (
    Body,
    InputError,
    check,
    flip_angle,
    flip_defect,
    flip_map,
    verify,
)
from tresym.commands import main
from tresym.commands.check import read_tasks
from tresym.racket.angle import parse_angle
from tresym.racket.body import shape
from tresym.reals.language.parsing import parse, parse_conditions
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number

ROOT = Path(__file__).resolve().parents[2]
PAPER = str(ROOT / "tests" / "data" / "pendulum.tex")
INPUTS = 10_000 if chunks.DEEP else 400
PROCESSES = 100 if chunks.DEEP else 12

# The classes of hostile text, each with its worst examples.
CLASSES = {
    "notations": ["0x1p-3", "1_000", "1,5", "1;5", "1.5.2", "1e", ".", "+", "1e+", "--1", "1/2/3"],
    "Unicode digits": ["١٢", "½", "²", "∞", "－１", "１/２", "𝟏", "๓", "1\u00a02", "Ⅳ", "𝟏" * 100],
    "nested quotes": ["'", '"', '"""', "'\"'\"'", "\\'", "`id`", "$(id)", "'" * 999, "\\" * 999],
    "nested brackets": ["(" * 9999, "[" * 9999, "(" * 999 + "1" + ")" * 999, "{0}", "%s",
                        "-" * 9999],
    "10⁶ characters": ["9" * 10**6, "a" * 10**6, "(" * 10**6, "1e" + "9" * 10**6, "é" * 10**6,
                       "1/" * 500_000, " " * 10**6, "\n" * 10**6],
    "NaN payloads": ["nan", "-nan", "NaN(0x7ff)", "nan(123)", "sNaN", "inf", "-Infinity", "1#INF"],
    "subnormals": ["5e-324", "2.2250738585072011e-308", "4.9e-324", "-5e-324", "1e-400"],
    "exponents": ["1e400000", "1e-400000", "1e10001", "1e-10001", "1e" + "0" * 5000 + "1",
                  "1e99999999999999999999", "1e9999/1e-9999"],
    "control characters": ["\0", "\n", "\r", "\t", "\x1b[2J", "\x7f", "\u202e", "\ufeff", "\ud800",
                           "1\n2", "\U0001f3be", "a\u0301", "\u2028"],
    "code": ["__import__('os')", "lambda: 0", "exec('1')", "().__class__", "a.b", "a[0]", "f'{a}'",
             "[x for x in y]", "a := 1", "import os", "1 if a else b", "*a", "not a"],
    "division by zero": ["1/0", "0/0", "1/0.0", "1/0e5", "pi/0", "log(0)", "0**-1", "tan(pi/2)"],
    "towers": ["9**9**9**9", "2**10**10", "x**(10**9)", "factorial(10**6)", "10**10**6*x",
               "exp(exp(exp(exp(9))))", "x" + "**9" * 400, "sin(" * 400 + "x" + ")" * 400],
}  # fmt: skip

PIECES = [
    *(text for texts in CLASSES.values() for text in texts if len(text) < 50),
    "0", "1", "-1", "0.0629", "16380/1210", "1e-10000", "...", "   ", "**", "^", "==", "<=", ",",
    ":", ";", "#", "+", "*", "/", "a", "b", "x", "pi", "E", "I", "sqrt", "sin(", "atan2(", "diff(",
    ")", "e9", "e-9", "9" * 50, "True", "None",
]  # fmt: skip


def texts(count: int, number: int) -> list[str]:
    """``count`` hostile texts; the same for the same ``number`` and chunk."""
    dice = random.Random(chunks.seed_of(number))
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


READERS = [parse_number, parse_angle, parse, parse_conditions]


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("kind", CLASSES)
def test_each_class_is_answered_or_refused(kind: str, reader: Callable[[str], object]) -> None:
    for text in CLASSES[kind]:
        complaint = complaint_of(reader, text)
        assert complaint is None or one_line(complaint), ascii(text[:100])


@pytest.mark.parametrize("reader", READERS)
def test_readers_answer_or_refuse_in_one_line(reader: Callable[[str], object]) -> None:
    before = ctx.prec
    for text in texts(INPUTS, 1):
        complaint = complaint_of(reader, text)
        assert complaint is None or one_line(complaint), ascii(text[:100])
        chunks.EXAMPLES["test_readers_answer_or_refuse_in_one_line"] += 1
    assert ctx.prec == before


def by_decimal(text: str) -> fmpq:
    """The number a text names, by the standard library's decimals: another reader altogether."""
    top, _, bottom = text.strip(" \t").partition("/")
    values = []
    for part in (top, bottom or "1"):
        sign, digits, exponent = Decimal(part.strip(" \t")).as_tuple()
        ten = fmpq(10) ** int(exponent)
        values.append(fmpq(fmpz("".join(map(str, digits)))) * ten * (-1 if sign else 1))
    return values[0] / values[1]


def test_a_number_that_is_read_is_the_number_written() -> None:
    dice = random.Random(chunks.seed_of(7))
    alphabet = "0123456789" * 3 + "..+-eE/ "
    accepted = 0
    for _ in range(10 * INPUTS):
        text = "".join(dice.choices(alphabet, k=dice.randint(1, 9)))
        try:
            found = parse_number(text)
        except InputError:
            continue
        accepted += 1
        assert found == by_decimal(text), text
    assert accepted > INPUTS
    chunks.EXAMPLES["test_a_number_that_is_read_is_the_number_written"] += 10 * INPUTS


def test_the_api_answers_or_refuses_in_one_line() -> None:
    dice = random.Random(chunks.seed_of(2))
    odd = [0.5, None, True, float("nan"), 5e-324, 1j, b"1", 10**400, [], object]
    values = [*texts(60, 3), "1", "1/2", "3", *odd]
    for _ in range(INPUTS):
        a, b, gamma, digits = (dice.choice([*values, "1/2", "1/4"]) for _ in range(4))
        digits = dice.choice([digits, 5, 0, 10**9])
        chunks.EXAMPLES["test_the_api_answers_or_refuses_in_one_line"] += 1
        complaint = complaint_of(flip_defect, a, b, gamma, digits)
        if complaint is not None:
            assert one_line(complaint)
            continue
        with ball_precision(200):
            again = flip_defect(*shape(a, b), gamma, 30)
            assert flip_defect(a, b, gamma, digits).defect.overlaps(again.defect)


ODD = [0.5, None, True, float("nan"), 1j, b"1", 10**400, [], {}, object, "\0x", np.bool_(True),
       np.float64(0.5), np.array(1), np.array([1, 2]), np.datetime64(0, "s")]  # fmt: skip
CALLS: dict[str, Callable[[Any], object]] = {
    "flip_defect a": lambda x: flip_defect(x, "1/2"),
    "flip_defect b": lambda x: flip_defect("1", x),
    "flip_defect gamma": lambda x: flip_defect("1", "1/2", x),
    "flip_defect digits": lambda x: flip_defect("1", "1/2", digits=x),
    "flip_defect rung": lambda x: flip_defect("1", "1/2", rung=x),
    "flip_angle psi0": lambda x: flip_angle("1", "1/2", x, "1"),
    "flip_angle rate": lambda x: flip_angle("1", "1/2", "1", x),
    "flip_angle theta0": lambda x: flip_angle("1", "1/2", "1", theta0=x),
    "flip_angle precession": lambda x: flip_angle("1", "1/2", "1", "1", precession=x),
    "flip_map a": lambda x: flip_map(x, 0.5, 0.1, 0.1),
    "flip_map b": lambda x: flip_map(1, x, 0.1, 0.1),
    "flip_map psi0": lambda x: flip_map(1, 0.5, x, [0.1, 0.2, 0.3]),
    "flip_map rate": lambda x: flip_map(1, 0.5, [0.1, 0.2, 0.3], x),
    "flip_map precession": lambda x: flip_map(1, 0.5, 0.1, [0.1, 0.2, 0.3], x),
    "Body": lambda x: Body(x, 2, 3),
    "check claim": check,
    "check given": lambda x: check("x == x", x),
    "check path": lambda x: check("x == x", path=x),
    "check limit": lambda x: check("x == x", limit=x),
    "verify labels": lambda x: verify([x]),
    "verify label": lambda x: verify(x) if not isinstance(x, list | dict) else None,
    "verify workers": lambda x: verify("eq_gamma", workers=x),
}


@pytest.mark.parametrize("name", CALLS)
def test_every_argument_of_the_api_is_taken_or_refused_in_one_line(name: str) -> None:
    for odd in ODD:
        complaint = complaint_of(CALLS[name], odd)
        assert complaint is None or one_line(complaint), repr(odd)


def test_numbers_of_numpy_are_taken() -> None:
    one = np.int64(1)
    found = flip_defect(one, np.str_("1/2"), np.int8(0), np.int32(20))
    assert found.digits == 20
    assert type(found.digits) is int
    assert str(found.defect) == str(flip_defect(1, "1/2", 0, 20).defect)
    assert flip_map(one, np.float32(0.5), np.float32(1), one) == flip_map(1, 0.5, 1.0, 1.0)
    assert check("x == x", limit=np.int64(5))
    assert check("x == x", limit=np.float16(5))  # 100 000 is no number of its kind
    assert complaint_of(lambda: check("x == x", limit=10**400)) is not None
    assert len(verify("eq_gamma", workers=one).rows) == len(verify(["eq_gamma"]).rows)


@pytest.mark.parametrize("numbers", [("1e-9999", "1/2", 1), ("1", "1e-9999", -1), ("1", "𝟏" * 99)])
def test_a_complaint_does_not_repeat_thousands_of_digits(numbers: tuple[str, ...]) -> None:
    complaint = complaint_of(flip_defect, *numbers)
    assert complaint is not None
    assert one_line(complaint)


@pytest.mark.parametrize(
    "words",
    [["verify"], ["verify", "--mutants"], ["verify", "--graph"], ["verify", "--json"], ["derive"],
     ["table"], ["figure"], ["chart"], ["bench"], ["docs"], ["flip", "--body"]],
)  # fmt: skip
@pytest.mark.parametrize("name", ["xyz", "\u202e" * 60], ids=["short", "long"])
def test_an_unknown_name_is_refused_before_anything_is_said(
    words: list[str], name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*words, name]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert one_line(err.removesuffix("\n"))


# Command lines of every command. Words that would run for minutes, or write where a checkout keeps
# its documents, are not among them: no `verify` without a label, no `docs` that is not refused.

GOOD = ["1", "0.5", "10", "pi/2", "1e-4", "str", "eq_gamma", "objects", "csv"]
OUTPUTS = ["out", "no/such/folder/out", "/", "", ".", "\x1b", "o" * 300, "/dev/full", "/dev/null"]
COMMANDS: dict[str, tuple[list[list[str]], list[str]]] = {
    "flip": (
        [[], ["--shape", "1", "1/2"], ["--body", "str"], ["--inertia", "1", "2", "2.5"]],
        ["--shape", "--inertia", "--body", "--digits", "--gamma", "--psi0", "--rate", "--theta0",
         "--rung", "--precession", "--json", "-o"],
    ),
    "check": (
        [["--limit", "0.2"], ["--limit", "0.2", "sin(x) <= 1"], ["--limit", "0.2", "-f", PAPER]],
        ["--given", "--as", "--limit", "-f", "--json", "-o"],
    ),
    "verify": ([["eq_gamma"], ["xyz"]], ["--graph", "--json", "-o"]),
    "derive": ([["eq_gamma"], ["xyz"]], ["--style", "--ledger", "-o"]),
    "table": ([["objects"], []], ["--format", "--json", "-o"]),
    "audit": ([[PAPER], ["/dev/null"], ["/"], []], ["--json", "-o"]),
    "paper": ([[PAPER], ["/dev/null"], ["/"], []], ["--json", "--strict", "--limit", "-o"]),
    "figure": ([["xyz"]], ["-o"]),
    "chart": ([["xyz"]], ["-o"]),
    "docs": ([["--check", "xyz"], ["xyz"]], []),
    "bench": ([["xyz"]], ["--json", "-o"]),
    "sweep": (
        [["-o", "t", "--a", "1,2", "--b", "1/2"], ["-o", "t", "--csv", PAPER], ["-o", "t"]],
        ["--a", "--b", "--gamma", "--digits", "--float64", "--workers", "--export", "--csv",
         "--json", "-o"],
    ),
}  # fmt: skip


def command_lines(count: int, number: int, commands: list[str]) -> Iterator[list[str]]:
    dice = random.Random(chunks.seed_of(number))
    pieces = [text for text in texts(200, number) if "\0" not in text and len(text) < 100_000]
    pieces = [text.encode(errors="replace").decode() for text in pieces]
    for i in range(count):
        command = commands[i % len(commands)]
        starts, options = COMMANDS[command]
        words = [command, *dice.choice(starts)]
        for _ in range(dice.randint(0, 4)):
            option = dice.choice([*options, "--help", "--", "-", "--dig", ""])
            value = dice.choice([*pieces, *GOOD])
            if option in ("-o", "--export"):
                words += [option, dice.choice(OUTPUTS)]
            elif option == "--workers":
                words += [option, dice.choice(["1", "0", "x", "9" * 50])]
            elif option == "--limit":
                words += [option, dice.choice(["0.1", "0", "-1", "x", "1e-9"])]
            elif option == "--" and command in ("verify", "derive", "bench"):
                continue
            else:
                words += [option, value]
        yield words


# In one process: the commands that neither start others nor last.
IN_PROCESS = ["flip", "flip", "flip", "audit", "figure", "chart", "docs", "bench"]


def test_command_lines_end_with_a_status(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    for words in command_lines(INPUTS // 2, 4, IN_PROCESS):
        try:
            status = main(words)
        except SystemExit as end:  # --help
            status = end.code
        out, err = capsys.readouterr()
        assert status in (0, 1, 2), words
        assert (status == 2) == (err != ""), words
        assert err.count("\n") == (status == 2)
        assert status != 2 or out == ""
        chunks.EXAMPLES["test_command_lines_end_with_a_status"] += 1
    assert not list(tmp_path.glob("*.part"))


@pytest.mark.parametrize("kind", CLASSES)
def test_each_class_in_a_command_line(kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    for i, text in enumerate(CLASSES[kind]):
        requests = [
            ["flip", "--shape", text, "1/2"],
            ["flip", "--body", text],
            ["flip", "--body", "str", "--gamma", text],
            ["flip", "--body", "str", "--digits", text],
            ["table", text],
            ["figure", text],
            ["bench", text],
            ["sweep", "-o", "/nonexistent/t", "--a", text, "--b", "1"],
            ["audit", text],
        ]
        for words in requests if chunks.DEEP else [requests[i % 9], requests[(i + 4) % 9]]:
            status = main(words)
            err = capsys.readouterr().err
            assert status in (0, 2), (words[:-1], ascii(text[:50]))
            assert err.count("\n") == (status == 2), (words[:-1], ascii(text[:50]), err[:300])


def test_a_file_of_claims_may_hold_anything(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = [text for texts in CLASSES.values() for text in texts if "\n" not in text]
    lines = lines if chunks.DEEP else lines[::3]
    (tmp_path / "claims").write_text("\n".join(lines), encoding="utf-8", errors="replace")
    assert main(["check", "-f", str(tmp_path / "claims"), "--limit", "0.3", "--json"]) == 2
    out, err = capsys.readouterr()
    assert all(json.loads(line) for line in out.splitlines())
    assert all(line.startswith("tresym: ") for line in err.splitlines()[:-1])
    assert "Traceback" not in err


def test_a_file_of_claims_is_never_held_as_a_whole(tmp_path: Path) -> None:
    claims = tmp_path / "claims"
    claims.write_text("# a comment\nx == x\n" + f"y == y # {'.' * 190}\n" * 50_000)
    tracemalloc.start()
    try:
        count = sum(1 for _ in read_tasks(str(claims), "", None))
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert count == 50_001
    assert peak < 1_000_000 < claims.stat().st_size / 9


def test_a_line_without_an_end_is_refused_and_a_long_one_passed_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    claims = tmp_path / "claims"
    claims.write_text(f"{'x' * 250_000}\nx == x\n")
    first, second = read_tasks(str(claims), "", None)
    assert (first.line, len(first.claim)) == (1, 100_000)
    assert second == ("x == x", "", None, 2)
    monkeypatch.setattr("tresym.commands.check.LONGEST_REST", 200_000)
    assert complaint_of(lambda: list(read_tasks(str(claims), "", None))) == (
        f"{claims}: a line is too long"
    )


@pytest.mark.parametrize(
    "words",
    [["check", "-f", "in", "-o", "in"], ["chart", "many", "--from", "in", "-o", "./in"],
     ["audit", "in", "-o", "in"], ["paper", "in", "-o", "in"], ["paper", "in", "--marks", "in"],
     ["sweep", "--csv", "in", "-o", "in"],
     ["sweep", "--csv", "in", "-o", "t", "--export", "in"]],
)  # fmt: skip
def test_an_input_is_never_replaced(
    words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("in").write_text("x == x\n")
    assert main(words) == 2
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"in": "x == x\n"}


@pytest.mark.parametrize(
    ("words", "name"),
    [(["paper", PAPER, "--html", "at"], "index.html"),
     (["paper", PAPER, "--marks", "at/marks"], "tresym.sty"),
     (["export", "momentum_along_z", "--coq", "at"], "Tresym.v")],
)  # fmt: skip
@pytest.mark.slow
def test_a_folder_of_others_is_left_as_it_is(
    words: list[str], name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    Path("at").mkdir()
    (Path("at") / name).write_text("theirs")
    assert main(words) == 2
    assert one_line(capsys.readouterr().err.removesuffix("\n"))
    assert {p.name: p.read_text() for p in Path("at").iterdir()} == {name: "theirs"}
    (Path("at") / name).unlink()
    assert main(words) == main(words) == 0


# Whole processes


def run(
    words: list[str], folder: Path, *, limit: int | None = None, **more: str
) -> subprocess.CompletedProcess[bytes]:
    """A command in a process of its own, with a limit on the size of files if one is given."""

    def limited() -> None:
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run(
        [sys.executable, "-m", "tresym", *words],
        capture_output=True,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT), **more},
        preexec_fn=limited,
        check=False,
        timeout=HANGS,
    )


# One request of each command that writes something.
WRITES = {
    "flip": ["flip", "--body", "str"],
    "flip as JSON": ["flip", "--body", "str", "--json"],
    "verify": ["verify", "momentum_along_z"],
    "verify as JSON": ["verify", "momentum_along_z", "--json"],
    "derive": ["derive", "momentum_along_z"],
    "table": ["table", "objects"],
    "check": ["check", "sin(x)**2 + cos(x)**2 == 1"],
    "audit": ["audit", PAPER],
    "paper": ["paper", PAPER],
    "figure": ["figure"],
    "chart": ["chart"],
}


class Fault(NamedTuple):
    """What befalls a process: too little of something, output that fails, or a signal."""

    limit: tuple[int, int] | None = None
    sink: str | None = None
    signal: int | None = None
    after: float = 0.0


def fault(dice: random.Random) -> Fault:
    few = dice.choice(
        [
            (resource.RLIMIT_AS, dice.randint(150, 900) * 2**20),
            (resource.RLIMIT_NOFILE, dice.randint(8, 30)),
            (resource.RLIMIT_FSIZE, dice.choice([0, 10, 1000, 10**5])),
            (resource.RLIMIT_CPU, dice.randint(1, 2)),
        ]
    )
    sinks = dice.choice(["/dev/full", "closed", "left"])
    number = dice.choice([signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGPIPE])
    kind = dice.randrange(4)
    if kind < 3:
        return (Fault(few), Fault(sink=sinks), Fault())[kind]
    return Fault(signal=number, after=dice.uniform(0.3, 2))


def stricken(words: list[str], folder: Path, fault: Fault) -> tuple[int, bytes]:
    """The status of a command that the fault befalls, and what it says."""

    def begun() -> None:
        if fault.limit is not None:
            kind, size = fault.limit
            resource.setrlimit(kind, (size, resource.getrlimit(kind)[1]))
        if fault.sink == "closed":
            os.close(1)

    sink = os.open(fault.sink, os.O_WRONLY) if fault.sink == "/dev/full" else subprocess.PIPE
    process = subprocess.Popen(
        [sys.executable, "-m", "tresym", *words],
        stdin=subprocess.DEVNULL,
        stdout=sink,
        stderr=subprocess.PIPE,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT), "OPENBLAS_NUM_THREADS": "1"},
        preexec_fn=begun,
    )
    if sink != subprocess.PIPE:
        os.close(sink)
    if fault.sink == "left" and process.stdout is not None:
        process.stdout.close()
        process.stdout = None
    if fault.signal is not None:
        time.sleep(fault.after)
        process.send_signal(fault.signal)
    _, err = process.communicate(timeout=HANGS)
    return process.returncode, err


@pytest.mark.slow
def test_whole_processes_of_every_command_end_with_a_status(tmp_path: Path) -> None:
    """Hostile words, and random faults beside them."""
    dice = random.Random(chunks.seed_of(8))
    for words in command_lines(PROCESSES, 5, list(COMMANDS)):
        befallen = fault(dice)
        if dice.random() < 0.3:  # nothing wrong but what befalls it
            words = dice.choice(list(WRITES.values())) + dice.choice([[], ["-o", "out"]])
        status, err = stricken(words, tmp_path, befallen)
        # killed by what was sent, or by the clock of the processor
        killed = {-signal.SIGXCPU, *((-n, 128 + n) if (n := befallen.signal) else ())}
        assert status in {0, 1, 2, 3, 130} | killed, (words, befallen, err)
        assert b"Traceback" not in err, (words, befallen, err)
        chunks.EXAMPLES["test_whole_processes_of_every_command_end_with_a_status"] += 1


@pytest.mark.slow
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize(
    "name", WRITES if chunks.DEEP else ("flip", "flip as JSON", "table", "check", "paper", "figure")
)
def test_output_that_cannot_be_delivered(name: str, tmp_path: Path) -> None:
    """To a full device, to a reader that has left, and to no output at all."""
    words = " ".join(f"'{word}'" for word in [sys.executable, "-m", "tresym", *WRITES[name]])
    sinks = [f"{words} >/dev/full; echo $? >&2", f"{words} | true", f"{words} >&-"]
    turn = list(WRITES).index(name) % len(sinks)
    for script in sinks if chunks.DEEP else [sinks[turn]]:
        done = subprocess.run(
            ["sh", "-c", script],
            capture_output=True,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            cwd=tmp_path,
            check=False,
            timeout=HANGS,
        )
        assert b"Traceback" not in done.stderr, (script, done.stderr)
        assert b"Exception" not in done.stderr, (script, done.stderr)
        if ">/dev/full" in script:
            assert done.stderr.endswith(b"\n2\n"), done.stderr
            assert done.stderr.count(b"\n") == 2, done.stderr


@contextmanager
def small_files(size: int) -> Iterator[None]:
    """No file of this process may grow beyond ``size`` bytes: a disk that is full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("name", WRITES)
def test_a_disk_that_fills_up_leaves_the_old_file(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "out"
    path.write_text("what was there before")
    with small_files(10):
        status = main([*WRITES[name], "-o", str(path)])
    assert status == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert path.read_text() == "what was there before"
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("where", ["no/such/folder/out", "/", "", ".", "x\0y", "x" * 300, "\ud800"])
@pytest.mark.parametrize("name", ["flip", "check", "table", "audit", "figure"])
def test_unwritable_outputs_are_one_line(
    name: str, where: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert main([*WRITES[name], "-o", where]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert not list(tmp_path.iterdir())


def test_a_device_is_written_to_and_stays_one(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    words = ["flip", "--body", "str", "-o", str(tmp_path / "pipe")]
    process = subprocess.Popen(
        [sys.executable, "-m", "tresym", *words], env={**os.environ, "PYTHONPATH": str(ROOT)}
    )
    assert "Wilson" in (tmp_path / "pipe").read_text(encoding="utf-8")
    assert process.wait(HANGS) == 0
    assert (tmp_path / "pipe").is_fifo()


@pytest.mark.slow
@pytest.mark.parametrize("moment", range(20 if chunks.DEEP else 1))
def test_kill_9_never_leaves_half_a_file(moment: int, tmp_path: Path) -> None:
    path = tmp_path / "out"
    words = ["flip", "--body", "str", "--digits", "10000", "--json", "-o", str(path)]
    whole = run(words, tmp_path)
    assert whole.returncode == 0
    size = path.stat().st_size
    path.write_text("old")
    process = subprocess.Popen(
        [sys.executable, "-m", "tresym", *words], env={**os.environ, "PYTHONPATH": str(ROOT)}
    )
    time.sleep(0.05 + 0.02 * moment)
    process.kill()
    process.wait(HANGS)
    assert path.read_text() == "old" or abs(path.stat().st_size - size) < 20


# Ctrl-C

INTERRUPTED = {
    "flip": ["flip", "--body", "str", "--digits", "10000", "--gamma", "1/100"],
    "verify": ["verify", "eq_gamma"],
    "derive": ["derive", "eq_gamma", "-o", "out"],
    "check": ["check", "exp(x) >= 1 + x"],
    "table": ["table", "slope"],
    "audit": ["audit", PAPER],
    "paper": ["paper", PAPER],
    "figure": ["figure", "flip-map", "-o", "out"],
    "sweep": ["sweep", "-o", "t", "--a", "0.1:1:40", "--b", "0.1:1:40", "--workers", "2"],
}


@pytest.mark.slow
@pytest.mark.parametrize("name", INTERRUPTED)
def test_ctrl_c_at_any_time_is_one_line(name: str, tmp_path: Path) -> None:
    """From the moment on at which Python runs the first line of ours, libraries half loaded."""
    dice = random.Random(chunks.seed_of(6))
    for i in range(10 if chunks.DEEP else 1):
        process = subprocess.Popen(
            [sys.executable, "-c", "from tresym.__main__ import main; print(flush=True); main()",
             *INTERRUPTED[name]],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            start_new_session=True,
        )  # fmt: skip
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(dice.uniform(0.002, 0.12) if i % 2 else dice.uniform(0.05, 0.9))
        os.killpg(process.pid, signal.SIGINT)
        _, err = process.communicate(timeout=HANGS)
        assert b"Traceback" not in err
        if process.returncode == 130:
            assert b"tresym: interrupted\n" in err
        else:
            # At its very end, the answer given, Python itself dies of the signal in silence.
            assert process.returncode in (0, -signal.SIGINT), err
        chunks.EXAMPLES["test_ctrl_c_at_any_time_is_one_line"] += 1
    assert not list(tmp_path.glob("*.part"))


# The same on every run

SAME = """
import contextlib, io, json, sys
from tresym.commands import main
for words in (
    ["flip", "--body", "str", "--gamma", "1e-4", "--json"],
    ["flip", "--body", "book", "--psi0", "1/10", "--rate", "0"],
    ["table", "objects", "--format", "latex"],
    ["table", "slope", "--json"],
    ["check", "exp(x) >= 1 + x", "--json"],
    ["check", "sin(2*x) == 2*sin(x)*cos(x)", "--json"],
    ["sweep", "-o", "t", "--a", "1,2", "--b", "1/2", "--gamma=-1e-3,0", "--export", "t.csv"],
    ["sweep", "-o", "f", "--a", "1,2", "--b", "1/2", "--float64", "--export", "f.csv"],
):
    heard = io.StringIO()
    with contextlib.redirect_stdout(heard), contextlib.redirect_stderr(io.StringIO()):
        main(words)
    text = heard.getvalue()
    if "--json" in words:
        answer = json.loads(text)
        answer.pop("seconds", None)
        text = json.dumps(answer)
    sys.stdout.buffer.write(text.encode())
for name in ("t.csv", "f.csv"):
    sys.stdout.buffer.write(open(name, "rb").read())
"""


@pytest.mark.slow
def test_the_same_output_whatever_the_hash_seed_locale_and_time_zone(tmp_path: Path) -> None:
    """Times aside: they are dropped from JSON, and the text of `flip` and `check` ends in them."""
    answers = set()
    for seed, locale, zone in (
        ("0", "C", "UTC"),
        ("77", "de_DE.UTF-8", "America/St_Johns"),
    ):
        folder = tmp_path / seed
        folder.mkdir()
        done = subprocess.run(
            [sys.executable, "-c", SAME],
            capture_output=True,
            cwd=folder,
            env={**os.environ, "PYTHONPATH": str(ROOT), "PYTHONHASHSEED": seed,
                 "LC_ALL": locale, "TZ": zone, "PYTHONUTF8": "1"},
            check=False,
            timeout=HANGS,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        lines = [x for x in done.stdout.decode().splitlines() if " ms" not in x and " s" not in x]
        answers.add("\n".join(lines))
    assert len(answers) == 1
    assert len(next(iter(answers))) > 1000


# Bounds said in advance


@pytest.mark.parametrize("digits", ["1000000000", "1e4", "-1", "10001", "٣", "9" * 5000])
def test_too_many_digits_are_refused_at_once(
    digits: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["flip", "--body", "str", "--digits", digits]) == 2
    assert "from 1 to 10000" in capsys.readouterr().err


@pytest.mark.slow
def test_ten_thousand_digits_take_little_memory(tmp_path: Path) -> None:
    # Its own peak; that of getrusage counts the process it was forked from too.
    code = (
        "import sys; from pathlib import Path; from tresym.commands import main;"
        "main(sys.argv[1:]);"
        "told = Path('/proc/self/status').read_text().split('VmHWM:')[1];"
        "print(told.split()[0], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "flip", "--body", "str", "--digits", "10000"],
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        check=True,
        timeout=HANGS,
    )
    assert int(done.stderr) < 200_000, "kilobytes"


@pytest.mark.parametrize(
    "words",
    cases(__file__, "an_output_is_replaced_by_the_next"),
)
def test_an_output_is_replaced_by_the_next(words: str, tmp_path) -> None:
    target = tmp_path / "out"
    for _ in range(2):
        assert main([*words.split(), "-o", str(target)]) in (0, 1)
    assert target.read_bytes()


@pytest.mark.parametrize(
    "kind",
    ["svg", "png", *(pytest.param(kind, marks=pytest.mark.night) for kind in ("pdf", "gif"))],
)
def test_a_picture_is_replaced_by_the_next(kind: str, tmp_path) -> None:
    target = tmp_path / f"out.{kind}"
    for _ in range(2):
        name = "racket-flip" if kind == "gif" else "euler-angles"
        assert main(["figure", name, "-o", str(target)]) == 0


def test_force_replaces_any_file(tmp_path, capsys) -> None:
    target = tmp_path / "mine.txt"
    target.write_text("notes")
    assert main(["flip", "--body", "str", "-o", str(target)]) == 2
    assert "--force" in capsys.readouterr().err
    assert main(["flip", "--body", "str", "--force", "-o", str(target)]) == 0
    assert "model" in target.read_text()


@pytest.mark.parametrize("change", ["", "edited"])
def test_only_what_was_written_and_not_edited_since_is_replaced(change: str, tmp_path) -> None:
    target = tmp_path / "out"
    assert main(["verify", "d36", "-o", str(target)]) == 0
    target.write_text(target.read_text() + change)
    assert main(["verify", "d36", "-o", str(target)]) == (2 if change else 0)


def test_without_a_record_nothing_is_replaced(tmp_path, monkeypatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "file"))  # no folder can be made there
    target = tmp_path / "out"
    assert main(["verify", "d36", "-o", str(target)]) == 0
    assert main(["verify", "d36", "-o", str(target)]) == 2


@pytest.mark.parametrize("option", ["--marks", "--html"])
def test_marks_and_pages_replace_no_file_of_the_author(option: str, tmp_path) -> None:
    place = tmp_path / ("index.html" if option == "--html" else "two.tex")
    place.write_text("\\section{Mine}\\label{tresym:eq_gamma}")
    where = tmp_path if option == "--html" else place
    paper = ["paper", str(Path(__file__).parents[2] / "docs/examples/kepler.tex")]
    assert main([*paper, option, str(where)]) == 2
    assert place.read_text().startswith("\\section")
    assert main([*paper, option, str(where), "--force"]) == 0


@pytest.mark.parametrize(
    "text",
    [
        "\\documentclass{article}\n\\begin{document}\n$x$\n",
        "\\begin{table}\n\\caption{Mine}\n",
        "\\documentclass{article}\n\\usepackage{tresym}\n\\label{tresym:d36}\n",
        "my notes on tresym\n",
        "a,b\n1,2\n",
        '{"name": 1}\n',
        "<?xml version='1.0'?>\n<svg><title>mine</title><g/></svg>\n",
        "| name | b |\n| --- | --- |\n",
        "\x89PNG...",
        "SQLite format 3\0",
    ],
)
def test_a_file_of_somebody_else_is_not_replaced(text: str, tmp_path, capsys) -> None:
    target = tmp_path / "mine"
    target.write_text(text, encoding="utf-8")
    for words in (["check", "x==x"], ["flip", "--body", "str"], ["figure", "momentum-sphere"]):
        assert main([*words, "-o", str(target)]) == 2
        assert "did not write it" in capsys.readouterr().err
    assert target.read_text(encoding="utf-8") == text
