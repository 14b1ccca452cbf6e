r"""Whether a symbol under an integral, a derivative or a limit may depend on its variable.

In ``\int_0^1 f\,dx`` print does not say that f is a constant. A symbol is taken for one where a
condition or words say that it is a number, where it is defined without the variable, or where its
letter is usual for constants.
"""

from __future__ import annotations

import re

from tresym.manuscript.terms import base_of
from tresym.reals.language.expression import FUNCTIONS, Expr, symbols
from tresym.reals.language.latex_cursor import INDICES, WORDS_BELOW

_LETTER = re.compile(r"(Delta_)?((?:var)?[A-Za-z][a-z]+(?=_|\d|\Z)|[A-Za-z])(?:_?(\w+))?")
_OF_FUNCTIONS = frozenset(
    (*"fghuvwyFGHPQUVWY", "phi", "psi", "varphi", "rho", "varrho", "Phi", "Psi", "chi", "eta")
)
_PHASES = frozenset(("phi", "psi", "varphi", "theta", "vartheta", "chi", "eta"))
"""Letters that are usual for functions, and for constants inside the argument of one."""
_CONSTANTS = frozenset(
    (
        *"abckmnpqABCKLMNR",
        "alpha",
        "beta",
        "gamma",
        "delta",
        "epsilon",
        "varepsilon",
        "kappa",
        "Delta",
    )
) | frozenset(
    ("lambda", "mu", "nu", "omega", "sigma", "tau", "Omega", "Lambda", "ell", "hbar", "zeta")
)
_WITH_TIME = frozenset((*"xyzrqs", "theta", "phi", "varphi", "psi"))
"""What changes with the time t under ``d/dt``."""
_VARY_WITH_TIME = frozenset("aApqLNRI")
"""Constants of formulas in space that are mostly functions where the time is the variable."""
_PLACES = frozenset((*"xyztrsuvw", "theta", "phi", "varphi", "xi", "eta"))
"""Letters of coordinates: a partial derivative by one of them holds the others fixed."""


def may_depend(name: str, node: Expr, body: Expr, partial: bool) -> bool:
    """Whether a symbol in the body of a derivative, an integral, a limit or a sum may change there.

    Args:
        partial: whether derivatives are written with ∂.
    """
    variable = node.names[0]
    found = _LETTER.fullmatch(base_of(name))
    if found is None:
        return False
    letter, below = found[2], (found[3] or "").strip("_")
    if _numbers(variable, below):
        return True
    if node.op not in ("derivative", "nth", "integral", "antiderivative", "limit") or below == "0":
        return False
    if partial and node.op == "derivative" and letter in _PLACES and variable in _PLACES:
        return letter in "uvw" and variable not in "uvw"
    if node.op == "limit" and variable == "t" and letter in _WITH_TIME:
        return _is_outside(name, variable, body)
    if node.op == "limit":
        return letter in _OF_FUNCTIONS - {*"hyPQvw", "rho", "eta"}
    if node.op == "derivative" and variable == "t" and letter in _WITH_TIME - _PHASES:
        return True
    if letter in _PHASES:
        return _is_outside(name, variable, body)
    alone = node.op != "derivative" and variable not in symbols(body)
    constants = _CONSTANTS - _VARY_WITH_TIME if variable == "t" else _CONSTANTS
    return letter in _OF_FUNCTIONS or (alone and letter not in constants)


def _numbers(variable: str, below: str) -> bool:
    """Whether a subscript counts by the variable: k in ``a_k``, ``a_{k+1}`` and ``a_{ik}``."""
    letters = {*re.sub(r"plus|minus|bar|hat|tilde|star|over|prime|\d|_", "", below)}
    return below not in WORDS_BELOW and variable in letters and letters <= INDICES


def _is_outside(name: str, variable: str, e: Expr) -> bool:
    """Whether a symbol stands outside of functions of the variable."""
    if e.op == "symbol":
        return str(e) == name
    if e.op in FUNCTIONS and variable in symbols(e):
        return False
    return any(_is_outside(name, variable, arg) for arg in e.args if isinstance(arg, Expr))
