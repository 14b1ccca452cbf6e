"""The proofs, one file per part of the paper, in its order. Read from top to bottom."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tresym.claims.claim import Claim

PARTS = (
    "model",
    "momentum",
    "euler_angles",
    "flip_dynamics",
    "separatrix",
    "slope",
    "table_of_objects",
)


def claims() -> tuple[Claim, ...]:
    """Every claim, in the order of the files and of the lines in them."""
    from importlib import import_module

    from tresym.claims.claim import Claim

    found: dict[Claim, None] = {}
    for part in PARTS:
        for value in vars(import_module(f"tresym.proofs.{part}")).values():
            several = value if isinstance(value, tuple) else (value,)
            found.update(dict.fromkeys(v for v in several if isinstance(v, Claim)))
    return tuple(found)
