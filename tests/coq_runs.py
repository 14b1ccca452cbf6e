"""Run ``coqc`` on a text that contains all that it needs."""

import subprocess
import tempfile
from pathlib import Path


def run(text: str, seconds: float) -> tuple[bool, str]:
    """Return whether Coq accepts the text, and what it prints or its error."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "claim.v"
        path.write_text(text, encoding="utf-8")
        done = subprocess.run(
            ["coqc", "-q", path.name],
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=seconds,
            check=False,
        )
    return done.returncode == 0, done.stdout if done.returncode == 0 else done.stderr
