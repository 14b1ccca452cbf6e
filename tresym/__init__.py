"""tresym takes one physics paper apart, statement by statement, and gives each a verdict.

The paper: L. Van Damme, P. Mardešić, D. Sugny, *The tennis racket effect in a three-dimensional
rigid body*, Physica D 338 (2017) 17. Importing this package imports nothing heavy; names are
loaded when first used.
"""

from __future__ import annotations

import os

TYPE_CHECKING = False  # typing itself is not loaded: before the command listens, Ctrl-C is Python's
if TYPE_CHECKING:
    from typing import Any

__version__ = "0.1.0"

_HOMES = {
    "Body": "tresym.racket.body",
    "InputError": "tresym.reals.numbers.exact",
    "Verdict": "tresym.reals.verdict",
    "check": "tresym.reals.decisions",
    "flip_angle": "tresym.racket.flip",
    "flip_defect": "tresym.racket.flip",
    "flip_map": "tresym.racket.floats.flipmap",
    "verify": "tresym.ledger.verification",
}

__all__ = ["Body", "InputError", "Verdict", "__version__", "check", "flip_defect", "verify"]

# In a wheel the proofs lie inside the package; in a checkout they lie beside it.
_package = os.path.dirname(os.path.realpath(__file__))
_checkout = os.path.dirname(_package)
if not os.path.isdir(f"{_package}/proofs") and os.path.isdir(f"{_checkout}/proofs"):
    __path__.append(_checkout)


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        from importlib import import_module

        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'tresym' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
