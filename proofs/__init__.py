"""The proofs: one module for each part of the paper, in its order. Read from top to bottom."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from types import ModuleType
    from typing import Any

    from tresym.ledger.claim import Claim
    from tresym.ledger.paper import Correction, Notation, Paper

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
    "sweeps",
    "near",
    "power_series",
    "asymptotics",
    "constants",
    "moments",
    "orders",
    "limits",
    "rigid_bodies",
    "turning",
    "numbers_in_text",
    "starts",
    "levels",
    "table_of_objects",
    "book",
    "conclusion",
    "bibliography",
    "promises",
)

NOT_MATHEMATICS = {
    "not_elementary": "what functions are elementary is said of formulas, and none says it",
    "said_in_section_3": "on which lines of the source a section stands: two numbers are compared",
    "reference_to_section_2": "as before; the reference is to another section",
}
"""Claims whose matter is not mathematics, with what it is."""


def parts(names: tuple[str, ...] = PARTS) -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    """Return for each module its title (first line of its docstring) and the claims it states."""
    import sys
    from importlib import import_module

    modules = [import_module(f"tresym.proofs.{part}") for part in names]
    # The file that states a claim is done before any that takes it from there, whatever the order
    # of the parts; `sys.modules` has them in the order in which they were done.
    done = {name: n for n, name in enumerate(sys.modules)}
    stated: dict[Claim, str] = {}
    for module in sorted(modules, key=lambda m: done[m.__name__]):
        for claim in _named_in(module):
            stated.setdefault(claim, module.__name__)
    return tuple(
        (
            (module.__doc__ or module.__name__).strip().splitlines()[0].rstrip("."),
            tuple(c for c in _named_in(module) if stated[c] == module.__name__),
        )
        for module in modules
    )


def _named_in(module: ModuleType) -> dict[Claim, None]:
    """Yield the claims that a module names, its own and imported ones, in order."""
    from tresym.ledger.claim import Claim

    several = (v if isinstance(v, tuple) else (v,) for v in vars(module).values())
    return dict.fromkeys(v for vs in several for v in vs if isinstance(v, Claim))


def written_in(labels: Iterable[str]) -> tuple[str, ...]:
    """Return the modules whose text contains one of the labels."""
    import re
    from pathlib import Path

    words = "|".join(map(re.escape, labels))
    stands = re.compile(rf"^(?:{words})\b|label=\"(?:{words})\"", re.MULTILINE)
    folder = Path(__file__).parent
    return tuple(
        part for part in PARTS if stands.search((folder / f"{part}.py").read_text("utf-8"))
    )


def _corrections() -> tuple[Correction, ...]:
    from tresym.proofs.corrections import CORRECTIONS

    return CORRECTIONS


def _notation() -> Notation:
    from tresym.ledger.paper import Notation
    from tresym.racket import notation as own

    return Notation(
        own.LATEX, own.WORDS, own.WORDS_OF_PROOFS, alike=(own.a, own.b), first=(own.theta,)
    )


def _figures() -> Any:
    from tresym.proofs import figures

    return figures


def _tables() -> Any:
    from tresym.proofs import tables

    return tables


def _numbers() -> dict[str, str]:
    from tresym.proofs.page_numbers import named_numbers

    return named_numbers()


def _programs() -> Mapping[str, Any]:
    from tresym.racket.bounds import charts

    return vars(charts)


def _coq_files() -> Mapping[str, str]:
    from tresym.proofs.coq_numbers import numbers

    return {"Numbers.v": numbers()}


def _enclosed(a: Any, b: Any) -> tuple[str, str]:
    from tresym.proofs.coq_numbers import between

    return between(a, b)


def __getattr__(name: str) -> Paper:
    """Make ``PAPER`` when it is first asked for, since it loads the ledger and SymPy."""
    if name != "PAPER":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from pathlib import Path

    from tresym.ledger.paper import Paper

    made = globals()["PAPER"] = Paper(
        __name__,
        parts,
        PARTS,
        written_in,
        Path(__file__).parent,
        _corrections,
        _notation,
        _figures,
        _tables,
        _numbers,
        _programs,
        _coq_files,
        _enclosed,
    )
    return made
