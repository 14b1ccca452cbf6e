"""What judging found, which is written in plain characters, with signs and letters as we print."""

from __future__ import annotations

import re

_GREEK = {
    "alpha": "α", "gamma": "γ", "epsilon": "ε", "theta": "θ", "lambda": "λ", "mu": "μ",
    "phi": "φ", "chi": "χ", "psi": "ψ",
}  # fmt: skip
_NAMES = "|".join(_GREEK)
_NAME = re.compile(
    rf"\b(?:({_NAMES})([0-9]?)(_f)?|([A-Za-z])([0-9]?)(_f|_dt)?(?=\s*(?:=|->)))(?![\w])"
)
"""A Greek name, or one letter that is given a value."""
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def readable(text: str) -> str:
    """``violated at psi1 = -1/2`` as ``violated at ψ₁ = −1/2``; powers keep their ``^``."""
    text = re.sub(r"(?:\^|\*\*)\((-?[\d/]+)\)|\*\*(\d+)", lambda m: f"^{{{m[1] or m[2]}}}", text)
    text = re.sub(r"\bsqrt\(", "√(", text)
    text = re.sub(r" \* |(?<=[\w)])\*(?=[\w(])", " · ", text)
    text = re.sub(r"\^(?:\{1\}|1\b(?!/))", "", text)
    text = re.sub(r"(?<=\d)\.0{4,}(?!\d)", "", text)
    text = re.sub(r"(?<![\w)])-(?=[\w.])", "−", text)
    text = _NAME.sub(_named, text)
    for typed, set_ in (("->", "→"), (">=", "≥"), ("<=", "≤")):
        text = text.replace(typed, set_)
    return text


def _named(found: re.Match[str]) -> str:
    name, index, rest = found.groups()[:3] if found[1] else found.groups()[3:]
    return _GREEK.get(name, name) + index.translate(_LOWERED) + (rest or "")
