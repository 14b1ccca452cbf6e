"""The commands of README with their output: ``python tests/readme.py`` stores the output again.

A ``console`` block of README holds one command after ``$`` and what it prints. Times differ from
run to run, so lines that tell them are left out. A block whose last line is ``…`` shows as many
lines as it has, the first ones of the output.
"""

import contextlib
import io
import re
import shlex
from pathlib import Path

from tresym.commands import main

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
BLOCK = re.compile(r"```console\n\$ tresym (.+)\n((?:.*\n)*?)```\n")
_TIME = re.compile(r"^ *time +[\d.]+ m?s$")


def printed(command: str, shown: str) -> str:
    """What the command prints, as README shows it; ``shown`` is what it shows now."""
    out = io.StringIO()
    with contextlib.chdir(ROOT), contextlib.redirect_stdout(out):
        main(shlex.split(command))
    lines = [line.rstrip() for line in out.getvalue().splitlines() if not _TIME.match(line)]
    lines = [line for line in lines if not line.startswith("  read as")]
    if shown.endswith("…\n"):
        lines = [*lines[: shown.count("\n") - 1], "…"]
    return "\n".join(lines).strip() + "\n"


def updated(text: str) -> str:
    """README with the output of today."""
    return BLOCK.sub(lambda m: f"```console\n$ tresym {m[1]}\n{printed(m[1], m[2])}```\n", text)


if __name__ == "__main__":
    README.write_text(updated(README.read_text(encoding="utf-8")), encoding="utf-8")
