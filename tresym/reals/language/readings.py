"""What a claim is read as, whether it is one comparison or made of several: text, LaTeX, names.

``x^2 = 4 <=> x = 2`` is read as ``x**2 == 4 <=> x == 2``, and shown in print as the formula of it.
"""

from __future__ import annotations

import re
from typing import Any

from tresym.reals.language.claims import Written, as_written, parts_of
from tresym.reals.language.compound import (
    claimed,
    formula_in_latex,
    path_in_latex,
    path_in_mathml,
    read_compound,
)
from tresym.reals.language.typesetting import to_latex, to_mathml
from tresym.reals.language.variable_names import explain, without_declaration
from tresym.reals.numbers.exact import InputError


def read_as(claim: Any, given: Any = "", path: str | None = None) -> str:
    """Return the claim with conditions and path in the grammar of text; empty if unreadable.

    Nothing is worked out of it, so that it is at hand also where deciding did not end.
    """
    try:
        whole = read_compound(claim, given, path)
        if whole is not None:
            return str(whole)
        return getattr(claim, "read_as", None) or str(as_written(claim, given, path))
    except InputError:
        return ""


def in_latex(text: str) -> str:
    """Return a claim in the grammar of text as LaTeX; empty if it cannot be read."""
    try:
        whole = read_compound(text)
        comparisons, given, path, _, _ = as_written(text, "", None) if whole is None else _NOTHING
    except InputError:
        return ""
    if whole is not None:
        shown, given, path = (
            formula_in_latex(whole.formula, len(whole.given), str(whole.path)),
            *whole[1:3],
        )
    else:
        shown = to_latex(comparisons)
    shown += rf" \quad ({to_latex(given)})" if given else ""
    return shown if path is None else rf"{shown} \quad ({path_in_latex(path)})"


def in_mathml(text: str) -> str:
    """Return a claim, or conditions, in the grammar of text as MathML in a line.

    It is empty for a claim that is made of claims, and for what cannot be read.
    """
    try:
        if read_compound(text) is not None:
            return ""
        comparisons, given, path, _, _ = as_written(text, "", None)
    except InputError:
        return ""
    shown = to_mathml(comparisons, block=False)
    shown += f" given {to_mathml(given, block=False)}" if given else ""
    return shown if path is None else f"{shown} as {path_in_mathml(path)}"


_NOTHING = Written((), (), None)


def need_variables(claim: Any, given: Any = "", path: str | None = None) -> None:
    """Check that all names in typed text are variables or known.

    Names in LaTeX, SymPy relations and conditions that are no text are taken as they are.

    Raises:
        InputError: a name is no variable; the message says what to write. Text that cannot be read
            at all is not this function's concern.
    """
    if not (isinstance(claim, str) and isinstance(given, str)) or re.search(
        r"[\\{}]", claim + given
    ):
        return
    try:
        parts = claimed(claim, given, path) or [(as_written(claim, given, path), ())]
    except InputError:
        return
    names: list[str] = []
    for written, counted in parts:
        known = [*counted, *(() if written.path is None else (written.path.name,))]
        under = f"{given} {parts_of(claim)[1] if len(parts) == 1 else claim}"
        names += without_declaration(written.comparisons, written.given, known, under)
    if names:
        raise InputError(explain(f"{claim} {given}", names))
