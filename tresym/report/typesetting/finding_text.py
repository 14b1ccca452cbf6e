"""Write findings with typeset signs and letters."""

from __future__ import annotations

import re

_GREEK = {
    "alpha": "α", "gamma": "γ", "epsilon": "ε", "theta": "θ", "lambda": "λ", "mu": "μ",
    "kappa": "κ", "tau": "τ", "pi": "π", "phi": "φ", "chi": "χ", "psi": "ψ", "Psi": "Ψ",
    "Phi": "Φ", "Omega": "Ω",
}  # fmt: skip
_NAMES = "|".join(_GREEK)
_NAME = re.compile(
    rf"\b(?:({_NAMES})([0-9]?)(_f|_max|_min|_start|prime)?|([A-Za-z])([0-9]?)(_f|_dt)?(?=\s*(?:=|->)))(?![\w])"
)
"""A Greek name, or a single letter before ``=`` or ``->``."""
_RATE = re.compile(rf"\bd({_NAMES})_dt\b")
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def readable(text: str) -> str:
    """Return a finding with Greek letters, indices and mathematical signs; powers keep their ``^``.

    Example:
        >>> readable("violated at psi1 = -1/2")
        'violated at ψ₁ = −1/2'
    """
    text = re.sub(r"\[([^\s\[]+) \+/- ([^\s\]]+)\]", r"\1 ± \2", text)
    text = re.sub(r"\bEq\((\w+), ([^()]+)\)", r"\1 = \2", text)
    text = re.sub(r"(?:\^|\*\*)\((-?[\d/]+)\)|\*\*(\d+)", lambda m: f"^{{{m[1] or m[2]}}}", text)
    text = re.sub(r"\bsqrt\(", "√(", text)
    text = re.sub(r" \* |(?<=[\w)}])\*(?=[\w(√-])", " · ", text)
    named = rf"(?!(?:{_NAMES})\b)"
    text = re.sub(rf"(?:(?<=[\d)])|(?<=\bpi)) · (?={named}[A-Za-z(√])", "", text)
    text = re.sub(r"(?<=\b[a-z]) · (?=[a-z]\b|\()", "", text)
    text = re.sub(r"(?<![\w)])-(?=[\w.(√])|(?<=[\w)]) - (?=[\w(√])", _minus, text)
    text = re.sub(r"-> (0|oo)([+-]?)", lambda m: f"-> {m[1]}{_SIDES[m[2]]}", text)
    text = re.sub(r"\boo\b", "∞", text)
    text = re.sub(r"(?<![\w.])(\d[\d.]*)e([−-]?)\+?0*(\d+)\b", _power_of_ten, text)
    text = _RATE.sub(lambda m: f"{_GREEK[m[1]]}\u0307", text)
    text = _NAME.sub(_named, text)
    for typed, set_ in (("->", "→"), (">=", "≥"), ("<=", "≤")):
        text = text.replace(typed, set_)
    return text


_SIDES = {"": "", "+": "⁺", "-": "⁻"}


def _power_of_ten(found: re.Match[str]) -> str:
    return f"{found[1]} · 10^{{{'−' if found[2] else ''}{found[3]}}}"


def _minus(found: re.Match[str]) -> str:
    return " − " if found[0].startswith(" ") else "−"


def _named(found: re.Match[str]) -> str:
    name, index, rest = found.groups()[:3] if found[1] else found.groups()[3:]
    rest = {"prime": "′", "_start": "₀"}.get(rest, rest or "")
    return _GREEK.get(name, name) + index.translate(_LOWERED) + rest
