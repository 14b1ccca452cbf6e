"""Files of claims in pytest and in an editor."""

import json
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path

# In an environment where tresym is installed pytest has loaded the plugin already.
NAMES = {point.name for point in entry_points(group="pytest11")}
PYTEST = ("-m", "pytest", *(() if "tresym" in NAMES else ("-p", "tresym.pytest_plugin")))
TEXT = "x real\ntrue: x**2 >= 0\nfalse: x > 0\nknown: x > 1 expect refuted\nbad: x** > 0\n"


def test_pytest_runs_a_test_for_each_claim_and_each_bad_line(tmp_path: Path) -> None:
    (tmp_path / "own.tresym").write_text(TEXT)
    done = subprocess.run(
        [sys.executable, *PYTEST, "own.tresym"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert "2 failed, 2 passed" in done.stdout, done.stdout
    assert "own.tresym:3: false is REFUTED" in done.stdout
    assert "own.tresym:5:" in done.stdout
    assert "Traceback" not in done.stdout


def test_pytest_runs_a_file_of_single_claims(tmp_path: Path) -> None:
    text = "# facts\nexp(x) >= 1 + x\nx**2 > 0\nsin(x) == x + O(x**3) as x -> 0\nx** > 0\n"
    (tmp_path / "own.claims").write_text(text)
    (tmp_path / "own.c").write_text("int a;\n// tresym: 1 < 2\nint b; /* tresym: 2 < 1 */\n")
    done = subprocess.run(
        [sys.executable, *PYTEST, "-v", "own.claims", "own.c"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert "3 failed, 3 passed" in done.stdout, done.stdout
    assert "own.c:3: REFUTED" in done.stdout
    assert "own.claims::2: exp(x) >= 1 + x PASSED" in done.stdout
    assert "own.claims:3: REFUTED" in done.stdout
    assert "own.claims:5:" in done.stdout
    assert "Traceback" not in done.stdout


def test_an_editor_sees_verdicts_and_bad_lines() -> None:
    asked = json.dumps({"path": "own.tresym", "text": TEXT, "limit": 2})
    done = subprocess.run(
        [sys.executable, "-m", "tresym.manuscript.editor_rows"],
        input=asked,
        capture_output=True,
        text=True,
        check=True,
    )
    *coming, last = map(json.loads, done.stdout.splitlines())
    assert [one["row"]["line"] for one in coming] == [2, 3, 4]  # as they are decided
    found = {row["line"]: row["status"] for row in last["rows"]}
    assert found == {2: "PROVED", 3: "REFUTED", 4: "EXPECTED", 5: "UNREADABLE"}
