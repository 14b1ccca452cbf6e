"""Verify mathematics: a physics paper statement by statement, your own claims, and manuscripts.

The paper is L. Van Damme, P. Mardešić, D. Sugny, *The tennis racket effect in a three-dimensional
rigid body*, Physica D 338 (2017) 17. Importing this package is fast: names are loaded when first
used.

Example:
    >>> import tresym
    >>> tresym.flip_defect(tresym.bodies["book"]).realizable
    True
    >>> tresym.check("sin(x)^2 + cos(x)^2 == 1").verdict.value
    'PROVED'
"""

from __future__ import annotations

# The module typing is not imported, because until the command handles signals, Ctrl-C would end in
# a traceback; every import here makes that time longer.
TYPE_CHECKING = False
if TYPE_CHECKING:  # for editors and type checkers, which would accept any name without it
    from tresym.proofs.python_api import figure

    from tresym.accuracy.bracketing import best, holds_from
    from tresym.accuracy.constants import constant
    from tresym.accuracy.error_table import error_table
    from tresym.accuracy.expansion import expand
    from tresym.accuracy.largest_error import largest_error
    from tresym.accuracy.scheme_claims import scheme_claims
    from tresym.accuracy.values import value
    from tresym.entries.lookup import atlas
    from tresym.ledger.verification import verify
    from tresym.racket.body import NAMED_BODIES as bodies  # noqa: N811 - the name it is known by
    from tresym.racket.body import Body
    from tresym.racket.flip import flip_angle, flip_defect, flip_defects
    from tresym.racket.floats.flipmap import flip_map
    from tresym.reals.numbers.exact import InputError
    from tresym.reals.verdict import Verdict
    from tresym.repair import check
    from tresym.report.pages.explanation import explain
    from tresym.report.pages.opened import (
        open as open,  # not in __all__: a star would hide the builtin
    )
    from tresym.report.pages.python_api import derive, paper, table

__version__ = "0.1.0"

_HOMES = {
    "Body": "tresym.racket.body",
    "InputError": "tresym.reals.numbers.exact",
    "Verdict": "tresym.reals.verdict",
    "atlas": "tresym.entries.lookup",
    "best": "tresym.accuracy.bracketing",
    "bodies": "tresym.racket.body",
    "check": "tresym.repair",
    "constant": "tresym.accuracy.constants",
    "derive": "tresym.report.pages.python_api",
    "error_table": "tresym.accuracy.error_table",
    "expand": "tresym.accuracy.expansion",
    "explain": "tresym.report.pages.explanation",
    "figure": "tresym.proofs.python_api",
    "flip_angle": "tresym.racket.flip",
    "flip_defect": "tresym.racket.flip",
    "flip_defects": "tresym.racket.flip",
    "flip_map": "tresym.racket.floats.flipmap",
    "holds_from": "tresym.accuracy.bracketing",
    "largest_error": "tresym.accuracy.largest_error",
    "open": "tresym.report.pages.opened",
    "paper": "tresym.report.pages.python_api",
    "scheme_claims": "tresym.accuracy.scheme_claims",
    "table": "tresym.report.pages.python_api",
    "value": "tresym.accuracy.values",
    "verify": "tresym.ledger.verification",
}

__all__ = [
    "Body",
    "InputError",
    "Verdict",
    "__version__",
    "atlas",
    "best",
    "bodies",
    "check",
    "constant",
    "derive",
    "error_table",
    "expand",
    "explain",
    "figure",
    "flip_angle",
    "flip_defect",
    "flip_defects",
    "flip_map",
    "holds_from",
    "largest_error",
    "paper",
    "scheme_claims",
    "table",
    "value",
    "verify",
]

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name in _HOMES:
            from importlib import import_module

            there = "NAMED_BODIES" if name == "bodies" else name
            # Stored, since a new lookup would take a tenth of the time of ``flip_defect``.
            found = globals()[name] = getattr(import_module(_HOMES[name]), there)
            return found
        raise AttributeError(f"module 'tresym' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, *(name for name in globals() if name.startswith("__"))})
