"""Refuse names in typed text that are no variables, such as ``xy``, ``mod``, ``cm`` or ``dy``.

A letter is a variable without further notice, also with digits or an index: ``x``, ``x1``, ``k_0``,
and so is the name of a Greek letter. A longer name is one if a condition is about it alone, as in
``kr > 0``. Every other name is more likely a product, a unit, a derivative or a word, and a claim
that reads it as a variable would be decided as another claim: ``30 Degree`` as 30 times an unknown
number.

Example:
    >>> explain("2/dx", ["dx"])
    'dx is no known name: a derivative is written diff(f, x), an integral integral(f, x)'
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from difflib import get_close_matches

from tresym.reals.language.calls import KNOWN, NAMED_CONSTANTS, SPECIAL_NAMES
from tresym.reals.language.expression import symbols
from tresym.reals.language.formula import Compared

_GREEK = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa"),
    *("lambda", "mu", "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi"),
    *("omega", "varepsilon", "vartheta", "varphi", "varrho", "varsigma", "varkappa", "eps", "lam"),
)
_USUAL = re.compile(
    rf"(?:[A-Za-z]|{'|'.join((*_GREEK, *(name.capitalize() for name in _GREEK)))})"
    r"\d*(?:_\w*)?"
)
_MEANT = {
    **dict.fromkeys(("Degree", "degree", "deg"), "an angle in degrees is written 30*pi/180"),
    **dict.fromkeys(("mod", "Mod"), "remainders of a division are not supported"),
    **dict.fromkeys(("approx", "approximately"), "write abs(a - b) <= 0.005, or a ~ b with a path"),
    **dict.fromkeys(("div", "rem"), "division with a remainder is not supported"),
    **dict.fromkeys(
        ("and", "or", "not", "xor"), "conditions are separated by commas, claims go one by one"
    ),
    **dict.fromkeys(("cm", "mm", "km", "kg", "ms", "Hz", "nm"), "units are not supported"),
    **dict.fromkeys(("euler_gamma", "eulergamma"), "Euler's constant is written EulerGamma"),
    **dict.fromkeys(("Infinity", "infty"), "infinity is written oo"),
    "uniformly": "it stands after the claim, as in sin(a*x) == O(x) uniformly as x -> 0",
    **dict.fromkeys(("True", "False", "None"), "it is no number"),
    **dict.fromkeys(("a", "an", "the", "is", "of", "to", "be"), "words are not read here"),
}


def is_usual(name: str) -> bool:
    """Return whether a name is that of a variable without further notice."""
    return _USUAL.fullmatch(name) is not None


def declared(conditions: Iterable[Compared]) -> set[str]:
    """Return the names that conditions are about: those that are a side, or its absolute value."""
    found = set()
    for left, _, right in conditions:
        for side in (left, right):
            inner = side.args[0] if side.op == "abs" else side
            if inner.op == "symbol":
                found.add(str(inner.args[0]))
    return found


def is_factor(name: str, text: str) -> bool:
    """Return whether a name follows a number or a parenthesis, as ``cm`` in ``3 cm``."""
    return re.search(rf"[\d).]\s*{re.escape(name)}\b", text) is not None


def explain(text: str, names: Iterable[str]) -> str:
    """Return what to write instead of the first of ``names``, which are no variables."""
    name = min(names, key=lambda found: (text.find(found), found))
    return f"{name} is no known name: {_advice(name)}"


def _advice(name: str) -> str:
    if name in _MEANT:
        return _MEANT[name]
    if re.fullmatch(r"d[A-Za-z]", name):
        return f"a derivative is written diff(f, {name[1]}), an integral integral(f, {name[1]})"
    if name in SPECIAL_NAMES:
        return f"as a function it needs its argument, {name}(x); for a variable state {name} > 0"
    near = get_close_matches(name, [*sorted({*KNOWN, *NAMED_CONSTANTS}), "pi"], 1, 0.8)
    if near:
        return f"did you mean {near[0]}?"
    variable = f"for a variable, state a condition on it, such as {name} > 0, or write"
    index = f"{variable} {name[0]}_{name[1:]}"
    if name.isalpha() and len(name) < 4:
        return f"write {'*'.join(name)} for a product; {index}"
    return index


def without_declaration(
    comparisons: Iterable[Compared],
    conditions: Iterable[Compared],
    known: Iterable[str] = (),
    text: str = "",
) -> list[str]:
    """Return the names in a claim and its conditions that are no variables.

    Args:
        comparisons: the claim.
        conditions: its conditions, which declare names.
        known: further names that are declared, such as the variable of a path.
        text: the conditions as typed: "x > 1 an" declares no variable.
    """
    conditions = list(conditions)
    names = frozenset().union(
        *(symbols(side) for link in (*comparisons, *conditions) for side in (link[0], link[2]))
    )
    fine = {name for name in declared(conditions) if not is_factor(name, text)} | {
        *known,
        "oo",
        "...",
        "ZZ",
    }
    return sorted(name for name in names - fine if not is_usual(name))
