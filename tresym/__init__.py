"""tresym takes one physics paper apart, statement by statement, and gives each a verdict.

The paper: L. Van Damme, P. Mardešić, D. Sugny, *The tennis racket effect in a three-dimensional
rigid body*, Physica D 338 (2017) 17. Importing this package imports nothing heavy; names are
loaded when first used.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any

__version__ = "0.1.0"

_HOMES = {
    "Body": "tresym.body",
    "InputError": "tresym.exact",
    "Verdict": "tresym.verdict",
    "check": "tresym.checking",
    "flip_angle": "tresym.flip",
    "flip_defect": "tresym.flip",
    "flip_map": "tresym.flip.flipmap",
    "verify": "tresym.verification",
}

__all__ = ["Body", "InputError", "Verdict", "__version__", "check", "flip_defect", "verify"]

# In a wheel the proofs lie inside the package; in a checkout they lie beside it.
_checkout = Path(__file__).resolve().parent.parent
if not (Path(__file__).parent / "proofs").is_dir() and (_checkout / "proofs").is_dir():
    __path__.append(str(_checkout))


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'tresym' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
