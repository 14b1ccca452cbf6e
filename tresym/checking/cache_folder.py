"""The user's folder for what was computed before, and the version of the code that computed it.

What is kept there is found again only by the same code: a hash of :mod:`tresym` and of the versions
of the libraries under it.
"""

from __future__ import annotations

import hashlib
import os
import sys
from functools import cache
from importlib import metadata
from pathlib import Path

_NO_CACHE = ("", "off")
LIBRARIES = ("python-flint", "sympy", "mpmath", "numpy")
"""Libraries that can change an answer or a suggestion, beside the FLINT that python-flint links."""


def cache_folder() -> Path | None:
    """``TRESYM_CACHE``, else the user's cache folder; None for ``off``."""
    folder = os.environ.get("TRESYM_CACHE")
    if folder is not None:
        return None if folder in _NO_CACHE else Path(folder)
    base = os.environ.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(base):  # the specification says to ignore a relative one
        base = os.path.expanduser("~/.cache")
    return Path(base) / "tresym"


@cache
def version() -> bytes:
    """A hash of the code that decides, and of the libraries under it."""
    import flint

    libraries = [f"{name} {_installed(name)}" for name in LIBRARIES]
    libraries += [f"FLINT {flint.__FLINT_VERSION__}", f"Python {sys.version_info[:3]}"]
    found = hashlib.sha256("\n".join(libraries).encode())
    root = Path(__file__).parents[1]
    for path in sorted(root.rglob("*.py")):
        found.update(str(path.relative_to(root)).encode() + b"\0" + path.read_bytes())
    return found.digest()


def _installed(name: str) -> str:
    """Return the version of a library, which is not imported for that."""
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "none"
