"""Long hunts in pieces that can be resumed: which piece this is, and what is done already.

``TRESYM_CHUNK=7`` seeds examples of its own for every test that asks :func:`seed_of`. With
``TRESYM_RECORD=FILE`` each test that ends adds a line to the file, and one that has passed in this
chunk is not run again. ``tests/deep.py`` goes through the chunks.
"""

import json
import os
from collections import Counter
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

CHUNK = int(os.environ.get("TRESYM_CHUNK") or 0)
RECORD = os.environ.get("TRESYM_RECORD")
if RECORD is not None:
    RECORD = os.path.abspath(RECORD)  # tests change their folder
IN_CHUNKS = "TRESYM_CHUNK" in os.environ
DEEP = os.environ.get("HYPOTHESIS_PROFILE") == "deep"

EXAMPLES: Counter[str] = Counter()
"""How many examples each test has passed since its name was recorded last."""
DECIDED: Counter[str] = Counter()
"""Of those that are claims, how many got a verdict other than UNDECIDED."""


def seed_of(number: int) -> int:
    """A seed of this chunk, another one for each ``number`` below 1000."""
    return 1000 * CHUNK + number


def done() -> set[str]:
    """The tests that have passed in this chunk."""
    if RECORD is None or not Path(RECORD).exists():
        return set()
    lines = map(json.loads, Path(RECORD).read_text(encoding="utf-8").splitlines())
    return {x["test"] for x in lines if x["chunk"] == CHUNK and x["outcome"] == "passed"}


def record(test: str, outcome: str, seconds: float) -> None:
    """Add the end of a test to the record, if there is one."""
    if RECORD is None:
        return
    name = test.rpartition("::")[2].partition("[")[0]
    line: dict[str, Any] = {
        "test": test,
        "chunk": CHUNK,
        "outcome": outcome,
        "examples": EXAMPLES.pop(name, 0),
        "seconds": round(seconds, 2),
        "commit": os.environ.get("TRESYM_COMMIT", ""),
        "day": datetime.now(UTC).date().isoformat(),
    }
    if name in DECIDED:
        line["decided"] = DECIDED.pop(name)
    with open(RECORD, "a", encoding="utf-8") as file:
        file.write(json.dumps(line) + "\n")
