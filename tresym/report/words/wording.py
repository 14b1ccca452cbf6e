"""What judging found, which is written in plain characters, with signs and letters as we print."""

from __future__ import annotations

import math
import re
from fractions import Fraction

_GREEK = {
    "alpha": "α", "gamma": "γ", "epsilon": "ε", "theta": "θ", "lambda": "λ", "mu": "μ",
    "kappa": "κ", "tau": "τ", "pi": "π", "phi": "φ", "chi": "χ", "psi": "ψ", "Psi": "Ψ",
    "Phi": "Φ", "Omega": "Ω",
}  # fmt: skip
_NAMES = "|".join(_GREEK)
_NAME = re.compile(
    rf"\b(?:({_NAMES})([0-9]?)(_f|_max|_min|prime)?|([A-Za-z])([0-9]?)(_f|_dt)?(?=\s*(?:=|->)))(?![\w])"
)
"""A Greek name, or one letter that is given a value."""
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


_SIZE = re.compile(r"(-?\d+\.\d{2,}(?:e[-+]?\d+)?)((?: \* [^ ,;]+)*)(?=[,;]| \*|$)")
"""A leading term: its coefficient, and its factors."""
_DIGITS = re.compile(r"\d+\.\d{2,}(?:e[-+]?\d+)?")
LARGEST = 12
"""Denominators up to this are recognised in a coefficient, which is told to six digits."""


def readable(text: str) -> str:
    """``violated at psi1 = -1/2`` as ``violated at ψ₁ = −1/2``; powers keep their ``^``."""
    text = re.sub(r"\bEq\((\w+), ([^()]+)\)", r"\1 = \2", text)
    start, about, rest = text.partition("about ")
    text = start + about + _SIZE.sub(_size, rest) if about else text
    text = re.sub(r"(?:\^|\*\*)\((-?[\d/]+)\)|\*\*(\d+)", lambda m: f"^{{{m[1] or m[2]}}}", text)
    text = re.sub(r"\bsqrt\(", "√(", text)
    text = re.sub(r" \* |(?<=[\w)}])\*(?=[\w(√-])", " · ", text)
    named = rf"(?!(?:{_NAMES})\b)"
    text = re.sub(rf"(?<=[\d)]) · (?={named}[A-Za-z(√])", "", text)
    text = re.sub(r"(?<=\b[a-z]) · (?=[a-z]\b|\()", "", text)
    text = re.sub(r"\^(?:\{1\}|1\b(?!/))", "", text)
    text = re.sub(r"(?<=\d)\.0{4,}(?!\d)", "", text)
    text = re.sub(r"(?<![\w)])-(?=[\w.(√])|(?<=[\w)]) - (?=[\w(√])", _minus, text)
    text = re.sub(r"-> (0|oo)([+-]?)", lambda m: f"-> {m[1]}{_SIDES[m[2]]}", text)
    text = re.sub(r"\boo\b", "∞", text)
    text = _NAME.sub(_named, text)
    for typed, set_ in (("->", "→"), (">=", "≥"), ("<=", "≤")):
        text = text.replace(typed, set_)
    return text


_SIDES = {"": "", "+": "⁺", "-": "⁻"}


def _minus(found: re.Match[str]) -> str:
    return " − " if found[0].startswith(" ") else "−"


def _size(found: re.Match[str]) -> str:
    """``-0.333333 * t^(2) * exp(-1.00000) * exp(3.14159/t^1)`` as ``−t^{2} e^{π/t}/(3e)``."""
    sign = "−" if found[1].startswith("-") else ""
    above, _, below = _constant(found[1].lstrip("-")).partition("/")
    over, under = [above] if above != "1" else [], [below] if below else []
    for factor in found[2].split(" * ")[1:]:
        exponent = re.fullmatch(r"exp\((.*)\)", factor)
        power = re.fullmatch(r"(\w+|\([^()]*\))\^\(?(-?[\d/]+)\)?", factor)
        if exponent:
            shown = _DIGITS.sub(lambda m: _constant(m[0]), exponent[1]).replace("-", "−")
            shown = re.sub(r"\^1(?!\d)", "", shown)
            over, under = (
                (over, [*under, "e"]) if shown == "−1" else ([*over, f"e^{{{shown}}}"], under)
            )
        elif power:
            base, inverted = re.subn(r"^\(1/(\w+)\)$", r"\1", power[1])
            down = power[2].startswith("-") != bool(inverted)
            raised = power[2].lstrip("-")
            text = base.replace("-", "−") + (f"^{{{raised}}}" if raised != "1" else "")
            over, under = (over, [*under, text]) if down else ([*over, text], under)
        else:
            over = [*over, factor]
    bottom = "".join(under)
    bottom = f"({bottom})" if len(under) > 1 else bottom
    return sign + (" ".join(over) or "1") + (f"/{bottom}" if under else "")


def _constant(digits: str) -> str:
    """A number that is told to six digits, by the fraction or the multiple of π that has them."""
    for unit, name in ((1.0, ""), (math.pi, "π")):
        near = Fraction(float(digits) / unit).limit_denominator(LARGEST)
        if near and f"{float(near) * unit:#.6g}" == f"{float(digits):#.6g}":
            above = name if name and near.numerator == 1 else f"{near.numerator}{name}"
            return above if near.denominator == 1 else f"{above}/{near.denominator}"
    return digits


def _named(found: re.Match[str]) -> str:
    name, index, rest = found.groups()[:3] if found[1] else found.groups()[3:]
    rest = "′" if rest == "prime" else rest or ""
    return _GREEK.get(name, name) + index.translate(_LOWERED) + rest
