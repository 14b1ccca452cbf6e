"""The long hunts: ``python tests/deep.py known`` (or another of ``HUNTS``).

Each hunt is a number of chunks, each with seeds of its own: a run of pytest, or of a script.
What has passed is in ``build/deep.jsonl`` and is not run again: an interrupted hunt goes on when it
is started again. A failure stays in the record, its output in ``build/deep-HUNT-CHUNK.txt``.
``--seconds N`` begins no chunk after N seconds; ``show`` prints the totals, and ``save`` puts them
into docs/measurements/hunts.json, where rows of tests that were not run again stay as they are.
"""

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
RECORD = ROOT / "build" / "deep.jsonl"
SAVED = ROOT / "docs" / "measurements" / "hunts.json"
PYTEST = ("-m", "pytest", "-n", "0", "-o", "timeout=7200", "-m", "")


class Hunt(NamedTuple):
    """What Python is asked for, in how many chunks."""

    words: tuple[str, ...]
    chunks: int
    start: tuple[str, ...] = PYTEST


CHEAPEST = " or ".join(
    (
        "test_numbers_survive_text",
        "test_the_unit_of_the_moments_does_not_matter",
        "test_the_defect_on_the_separatrix_is_between_0_and_a_right_angle",
        "test_no_rigid_body_is_nearer_to_a_perfect_flip_than_the_floor",
        "test_the_defect_falls_in_a_and_in_b",
    )
)

GENERATED = "readers or api or number_that or command_lines or whole_processes or ctrl_c"

HUNTS = {
    "laws": Hunt(("tests/laws",), 10),
    "cheap": Hunt(("tests/laws", "-k", CHEAPEST), 100),
    "hostile": Hunt(("tests/commands/test_hostile.py", "-k", GENERATED), 10),
    "classes": Hunt(("tests/commands/test_hostile.py", "-k", f"not ({GENERATED})"), 1),
    "kills": Hunt(("tests/commands/test_kills.py", "tests/sweep/test_sweep.py", "-k", "kill"), 5),
    "claims": Hunt((), 2000, ("tests/hunt.py",)),
    "asymptotic": Hunt((), 20, ("tests/asymptotic_claims.py",)),
    "exceptional": Hunt((), 40, ("tests/exceptional_claims.py",)),
    "finite": Hunt((), 1000, ("tests/finite_claims.py",)),
    "known": Hunt((), 200, ("tests/known.py",)),
    "spellings": Hunt((), 200, ("tests/spellings.py",)),
}


def hunt(name: str, until: float) -> int:
    """Go through the chunks of a hunt; returns how many of them have failed."""
    RECORD.parent.mkdir(exist_ok=True)
    failed, found = 0, HUNTS[name]
    commit = subprocess.check_output(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, text=True)
    for chunk in range(found.chunks):
        if time.monotonic() > until:
            break
        print(f"{name} {chunk + 1}/{HUNTS[name].chunks}", flush=True)
        done = subprocess.run(
            [sys.executable, *found.start, *found.words],
            cwd=ROOT,
            env={
                **os.environ,
                "HYPOTHESIS_PROFILE": "deep",
                "TRESYM_CHUNK": str(chunk),
                "TRESYM_RECORD": str(RECORD),
                "TRESYM_COMMIT": commit.strip(),
            },
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            check=False,
        )
        # 5: nothing was left to run
        if done.returncode not in (0, 5):
            failed += 1
            (RECORD.parent / f"deep-{name}-{chunk}.txt").write_bytes(done.stdout)
            print(f"  failed: build/deep-{name}-{chunk}.txt", flush=True)
    return failed


def totals() -> dict[str, dict[str, Any]]:
    """Of every test in the record: examples, seconds, chunks and failures; when, at which commit.

    What failed in a chunk and passed in it later was mended, and counts once, as what passed.
    """
    last: dict[tuple[str, int], dict[str, Any]] = {}
    for line in map(json.loads, RECORD.read_text(encoding="utf-8").splitlines()):
        if line["outcome"] != "skipped":
            last[line["test"], line["chunk"]] = line
    found: dict[str, dict[str, Any]] = {}
    for (test, _), line in last.items():
        zero = {"examples": 0, "seconds": 0.0, "chunks": 0, "failures": 0}
        at = found.setdefault(test.partition("[")[0], zero)
        passed = line["outcome"] == "passed"
        at["seconds"] = round(at["seconds"] + line["seconds"], 2)
        at["examples"] += line["examples"] if passed else 0
        at["chunks" if passed else "failures"] += 1
        if "decided" in line:
            at["decided"] = at.get("decided", 0) + line["decided"]
        at |= {"day": line.get("day", ""), "commit": line.get("commit", "")}
    return dict(sorted(found.items()))


def save() -> None:
    """Put the totals into the stored summary, a line a test."""
    before = json.loads(SAVED.read_text(encoding="utf-8"))["tests"] if SAVED.exists() else {}
    rows = sorted({**before, **totals()}.items())
    lines = (f"  {json.dumps(test)}: {json.dumps(row)}" for test, row in rows)
    text = '{\n "workload": "hunts",\n "tests": {\n' + ",\n".join(lines) + "\n }\n}\n"
    SAVED.write_text(text, encoding="utf-8")


def main() -> int:
    """Run the hunts named, or show or save the totals."""
    words, until = sys.argv[1:], float("inf")
    if "--seconds" in words:
        at = words.index("--seconds")
        until = time.monotonic() + float(words[at + 1])
        del words[at : at + 2]
    if words == ["show"]:
        print(json.dumps(totals(), indent=1))
        return 0
    if words == ["save"]:
        save()
        return 0
    return min(1, sum(hunt(name, until) for name in words or HUNTS))


if __name__ == "__main__":
    sys.exit(main())
