"""Decide any claim: dispatch to the deciders, cross-check, limits of time, and stored answers.

:func:`check` decides one claim in this process; :mod:`tresym.checking.time_limited`
many, each within a limit of time.
"""

from __future__ import annotations

from numbers import Real
from typing import Any

from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.readings import need_variables
from tresym.reals.numbers.exact import InputError

MAX_SECONDS = 86_400

__all__ = ["Answer", "check"]


def check(
    claim: Any, given: Any = "", path: str | None = None, limit: float | None = None
) -> Answer:
    """Decide a claim about real elementary expressions.

    Args:
        claim: text such as ``"diff(F, x) == f"``, ``"exp(x) >= 1 + x"`` or
            ``"sin(x) == x + O(x**3)"``; LaTeX of the same; or a SymPy relation such as
            ``Eq(f, g)``, whose symbols are taken as real.
        given: conditions: text such as ``"a > 0, 0 < b <= 1"``, LaTeX, or SymPy relations.
        path: for an order claim, such as ``"x -> 0+"``.
        limit: seconds of processor time after which the answer is UNDECIDED; the work is then
            done in a process of its own. Without it the claim is decided here.

    Raises:
        InputError: the claim is not read, or the limit is no number of seconds; one line says why.

    Example:
        >>> import tresym
        >>> tresym.check("sqrt(x**2) == x", given="x > 0").verdict.value
        'PROVED'
        >>> tresym.check("sqrt(x**2) == x").verdict.value
        'REFUTED'
    """
    if not (path is None or isinstance(path, str)):
        raise InputError("path: give text such as x -> 0+")
    if not (limit is None or _is_limit(limit)):
        raise InputError(f"limit: give a number of seconds above 0 and at most {MAX_SECONDS}")
    if not (isinstance(claim, str) and isinstance(given, str)):
        claim, given, path = read(claim, given, path), "", None  # SymPy evaluates what it copies
    need_variables(claim, given, path)
    if limit is None:
        return decide_claim(claim, given, path)
    from tresym.checking.time_limited import Task, check_within

    return check_within(Task(claim, given, path), float(limit))


def _is_limit(limit: object) -> bool:
    """Whether it is a number of seconds, of numpy's smallest kinds as well."""
    if not isinstance(limit, Real) or isinstance(limit, bool):
        return False
    try:
        return 0 < float(limit) <= MAX_SECONDS
    except OverflowError:
        return False
