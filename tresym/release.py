"""The version, date and commit of this copy of tresym, for citations.

The commit is read from the git folder of a checkout; an installed wheel has none.
"""

from __future__ import annotations

from pathlib import Path

import tresym

RELEASED = "2026-11-27"
"""The day of this version; the year stands in citations."""

PAPER = "arXiv:1606.08237"
"""The paper that the ledger verifies."""


def commit() -> str:
    """Return the first ten digits of the checkout's commit; empty if this is no checkout."""
    git = Path(tresym.__file__).resolve().parent.parent / ".git"
    try:
        if git.is_file():  # a worktree: the file names the folder
            git = Path(git.read_text(encoding="utf-8").removeprefix("gitdir:").strip())
        head = (git / "HEAD").read_text(encoding="utf-8").strip()
        if not head.startswith("ref: "):
            return head[:10]
        common = git / "commondir"
        home = (git / common.read_text(encoding="utf-8").strip()) if common.is_file() else git
        name = head.removeprefix("ref: ")
        if (home / name).is_file():
            return (home / name).read_text(encoding="utf-8").strip()[:10]
        packed = (home / "packed-refs").read_text(encoding="utf-8").splitlines()
        return next((line[:10] for line in packed if line.endswith(f" {name}")), "")
    except OSError:
        return ""


def described() -> str:
    """Return the version, with the commit where it is known: ``0.1.0 (commit 0123456789)``."""
    found = commit()
    return f"{tresym.__version__} (commit {found})" if found else tresym.__version__


def dated() -> str:
    """Return the version with its date, for the title of a document."""
    return f"{tresym.__version__} of {RELEASED}"
