"""The proofs, one file per part of the paper, in its order. Read from top to bottom."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tresym.claims.claim import Claim

PARTS = (
    "model",
    "momentum",
    "frames",
    "stability",
    "jacobi",
    "euler_angles",
    "regimes",
    "symmetric_tops",
    "flip_dynamics",
    "phase_portraits",
    "separatrix",
    "flip_definition",
    "on_the_separatrix",
    "implicit_function",
    "slope",
    "turn_integral",
    "monotonicity",
    "exponent",
    "asymptotics",
    "constants",
    "orders",
    "limits",
    "rigid_bodies",
    "numbers_in_text",
    "starts",
    "turning",
    "levels",
    "table_of_objects",
    "book",
    "conclusion",
    "bibliography",
    "promises",
)


def parts() -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    """For every file its title (the first line of its docstring) and the claims it states."""
    from importlib import import_module

    from tresym.claims.claim import Claim

    stated: set[Claim] = set()
    found = []
    for part in PARTS:
        module = import_module(f"tresym.proofs.{part}")
        several = (v if isinstance(v, tuple) else (v,) for v in vars(module).values())
        here = dict.fromkeys(v for vs in several for v in vs if isinstance(v, Claim))
        title = (module.__doc__ or part).strip().splitlines()[0].rstrip(".")
        found.append((title, tuple(claim for claim in here if claim not in stated)))
        stated |= here.keys()
    return tuple(found)


def claims() -> tuple[Claim, ...]:
    """Every claim, in the order of the files and of the lines in them."""
    return tuple(claim for _, stated in parts() for claim in stated)
