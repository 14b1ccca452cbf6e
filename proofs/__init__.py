"""The proofs: one file for each part of the paper, in its order. Read from top to bottom.

A part is a file of claims, ``slope.tresym``, or a module of Python, ``separatrix.py``. What a file
states is asked for as ``from tresym.proofs import slope``, and then ``slope.d51``.
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

NOT_MATHEMATICS = {
    "not_elementary": "what functions are elementary is said of formulas, and none says it",
    "said_in_section_3": "on which lines of the source a section stands: two numbers are compared",
    "reference_to_section_2": "as before; the reference is to another section",
}
"""Claims whose matter is not mathematics, with what it is."""


def parts(names: tuple[str, ...] = PARTS) -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    """Return for each part its title and the claims it states.

    The title of a module of Python is the first line of its docstring.
    """
    import sys
    from importlib import import_module

    found = {part: _file(part) or import_module(f"tresym.proofs.{part}") for part in names}
    # The file that states a claim is done before any that takes it from there, whatever the order
    # of the parts; `sys.modules` has them in the order in which they were done.
    done = {name.partition("proofs.")[2]: n for n, name in enumerate(sys.modules)}
    stated: dict[Claim, str] = {}
    for part in sorted(found, key=lambda part: done.get(part, -1)):
        for claim in _named_in(found[part]):
            stated.setdefault(claim, part)
    return tuple(
        (
            _title(module).strip().splitlines()[0].rstrip("."),
            tuple(c for c in _named_in(module) if stated[c] == part),
        )
        for part, module in found.items()
    )


def _title(part: Any) -> str:
    return str(getattr(part, "title", "") or part.__doc__ or part.__name__)


def _named_in(part: Any) -> dict[Claim, None]:
    """Yield the claims that a module names, its own and imported ones, or those of a file."""
    from types import ModuleType

    from tresym.ledger.claim import Claim

    named = vars(part) if isinstance(part, ModuleType) else part.claims
    several = (v if isinstance(v, tuple) else (v,) for v in named.values())
    return dict.fromkeys(v for vs in several for v in vs if isinstance(v, Claim))


@cache
def _file(part: str) -> Any:
    """The part that a file states; None if there is no such file."""
    from pathlib import Path

    path = Path(__file__).parent / f"{part}.tresym"
    if not path.is_file():
        return None
    from tresym.papers.ledger_claims import read_part

    return read_part(path, _values_of)


def _values_of(part: str) -> Mapping[str, Any]:
    """What another part of the paper names, or the formulas that programs run."""
    from importlib import import_module

    if part in FORMULAS:
        return vars(import_module(f"tresym.racket.formulas.{FORMULAS[part]}"))
    file = _file(part)
    return vars(import_module(f"tresym.proofs.{part}")) if file is None else file.values


def written_in(labels: Iterable[str]) -> tuple[str, ...]:
    """Return the modules whose text contains one of the labels."""
    import re
    from pathlib import Path

    words = "|".join(map(re.escape, labels))
    stands = re.compile(rf"^(?:let |assume )?(?:{words})\b|label=\"(?:{words})\"", re.MULTILINE)
    folder = Path(__file__).parent
    files = {part: folder / f"{part}.tresym" for part in PARTS}
    texts = {
        part: (path if path.is_file() else folder / f"{part}.py").read_text("utf-8")
        for part, path in files.items()
    }
    return tuple(part for part in PARTS if stands.search(texts[part]))


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


def __getattr__(name: str) -> Any:
    """Make ``PAPER`` when it is first asked for, since it loads the ledger and SymPy.

    The parts that are files of claims are read when they are first asked for.
    """
    if name in PARTS and (part := _file(name)) is not None:
        return part
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
