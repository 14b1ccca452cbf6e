"""The proofs: one file for each part of the paper, in its order. Read from top to bottom.

A part is a file of claims, such as ``slope.tresym``. What it states is asked for as
``from tresym.proofs import slope``, and then ``slope.d51``. The modules of Python beside them hold
what files take from elsewhere: laws of mechanics, charts, tables.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from tresym.ledger.claim import Claim
    from tresym.ledger.paper import Correction, Notation

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

FORMULAS = {"printed_formulas": "printed", "stable_formulas": "stable"}
"""Names under which files use the formulas of the programs, with their modules."""

BESIDE = ("conditions",)
"""Files that name what the parts take from them, and state nothing."""

NOT_MATHEMATICS = {
    "not_elementary": "what functions are elementary is said of formulas, and none says it",
    "said_in_section_3": "on which lines of the source a section stands: two numbers are compared",
    "reference_to_section_2": "as before; the reference is to another section",
}
"""Claims whose matter is not mathematics, with what it is."""


def parts(names: tuple[str, ...] = PARTS) -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    """Return for each part its title and the claims it states."""
    return tuple(
        (file.title.strip().splitlines()[0].rstrip("."), tuple(file.claims.values()))
        for file in map(_file, names)
    )


@cache
def _file(part: str) -> Any:
    """The part that a file states."""
    from pathlib import Path

    from tresym.papers.ledger_claims import read_part

    return read_part(Path(__file__).parent / f"{part}.tresym", _values_of)


def _values_of(part: str) -> Mapping[str, Any]:
    """What another part of the paper names, or the formulas that programs run."""
    from importlib import import_module

    if part in FORMULAS:
        return vars(import_module(f"tresym.racket.formulas.{FORMULAS[part]}"))
    if part in (*PARTS, *BESIDE):
        return _file(part).values
    return vars(import_module(f"tresym.proofs.{part}"))


def written_in(labels: Iterable[str]) -> tuple[str, ...]:
    """Return the modules whose text contains one of the labels."""
    import re
    from pathlib import Path

    words = "|".join(map(re.escape, labels))
    stands = re.compile(rf"^(?:let |assume )?(?:{words})\b", re.MULTILINE)
    folder = Path(__file__).parent
    texts = {part: (folder / f"{part}.tresym").read_text("utf-8") for part in PARTS}
    return tuple(part for part in PARTS if stands.search(texts[part]))


def _corrections() -> tuple[Correction, ...]:
    from tresym.proofs.corrections import CORRECTIONS

    return CORRECTIONS


def _notation() -> Notation:
    from tresym.ledger.paper import Notation
    from tresym.racket import notation as own

    return Notation(own.LATEX, own.WORDS, own.WORDS_OF_PROOFS, first=("theta",))


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


def _derivations() -> Any:
    from tresym.proofs import sympy_derivations

    return sympy_derivations.routes()


def __getattr__(name: str) -> Any:
    """Make ``PAPER`` when it is first asked for, since it loads the ledger and SymPy.

    The parts are read when they are first asked for.
    """
    if name in PARTS:
        return _file(name)
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
        _values_of,
        _derivations,
    )
    return made
