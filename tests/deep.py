"""The long hunt: ``python tests/deep.py laws`` (also cheap, hostile, classes, kills; show).

Each hunt is a number of chunks; each chunk is a run of pytest with seeds of its own. What has
passed is in ``build/deep.jsonl`` and is not run again: an interrupted hunt goes on when it is
started again. A failure stays in the record, its output in ``build/deep-HUNT-CHUNK.txt``.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
RECORD = ROOT / "build" / "deep.jsonl"


class Hunt(NamedTuple):
    """What pytest is asked for, in how many chunks."""

    words: tuple[str, ...]
    chunks: int


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
    "kills": Hunt(("tests/sweep/test_sweep.py", "-k", "kill"), 1),
}


def hunt(name: str) -> int:
    """Go through the chunks of a hunt; returns how many of them have failed."""
    RECORD.parent.mkdir(exist_ok=True)
    failed = 0
    for chunk in range(HUNTS[name].chunks):
        print(f"{name} {chunk + 1}/{HUNTS[name].chunks}", flush=True)
        done = subprocess.run(
            [sys.executable, "-m", "pytest", "-n", "0", "-o", "timeout=7200", *HUNTS[name].words],
            cwd=ROOT,
            env={
                **os.environ,
                "HYPOTHESIS_PROFILE": "deep",
                "TRESYM_CHUNK": str(chunk),
                "TRESYM_RECORD": str(RECORD),
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
    """Examples, seconds, chunks and failures of every test in the record."""
    found: dict[str, dict[str, Any]] = defaultdict(
        lambda: {"examples": 0, "seconds": 0.0, "chunks": 0, "failures": 0}
    )
    for line in map(json.loads, RECORD.read_text(encoding="utf-8").splitlines()):
        at = found[line["test"].partition("[")[0]]
        at["seconds"] = round(at["seconds"] + line["seconds"], 2)
        if line["outcome"] == "passed":
            at["examples"] += line["examples"]
            at["chunks"] += 1
        elif line["outcome"] == "failed":
            at["failures"] += 1
    return dict(sorted(found.items()))


def main() -> int:
    """Run the hunts named, or show the totals as JSON."""
    names = sys.argv[1:] or list(HUNTS)
    if names == ["show"]:
        print(json.dumps(totals(), indent=1))
        return 0
    return min(1, sum(map(hunt, names)))


if __name__ == "__main__":
    sys.exit(main())
