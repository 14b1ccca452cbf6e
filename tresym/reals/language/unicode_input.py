"""Translate Unicode mathematics to the text grammar: π, ², ≤, |x| and the like."""

from __future__ import annotations

import re

from tresym.reals.numbers.exact import InputError

_GREEK = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa"),
    *("lambda_", "mu", "nu", "xi", "omicron", "pi", "rho", "varsigma", "sigma", "tau", "upsilon"),
    *("phi", "chi", "psi", "omega"),
)
_SIGNS = str.maketrans(
    {
        **{chr(0x3B1 + k): f" {name} " for k, name in enumerate(_GREEK)},
        **{
            "Γ": " Gamma ",
            "Θ": " Theta ",
            **{"⌊": " floor(", "⌋": ")", "⌈": " ceiling(", "⌉": ")"},
            "ϕ": " varphi ",
            "ϵ": " varepsilon ",
            "∞": " oo ",
            "√": " sqrt ",
            "′": "'",
        },
        **{"≤": "<=", "⩽": "<=", "≥": ">=", "⩾": ">=", "≠": "!=", "→": "->", "∼": "~", "≡": "=="},
        **dict.fromkeys("·⋅×∙∗", "*"),
        **dict.fromkeys("−–‒", "-"),
        **dict.fromkeys("÷∕", "/"),
        **dict.fromkeys("\u00a0\u2009\u202f\u2062", " "),
        **{"½": "(1/2)", "¼": "(1/4)", "¾": "(3/4)", "‖": "|"},
    }
)
_UPPER = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_LOWER = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_BEFORE_OPENING = frozenset("+-*/^(,<>=~!&")


def plain(text: str) -> str:
    """Return ``text`` in ASCII as far as its signs are unambiguous, with ``|x|`` as ``abs(x)``.

    Other characters are left unchanged, and the grammar rejects them.

    Raises:
        InputError: a bar has no partner.

    Example:
        >>> plain("|x| ≤ π²")
        'abs(x) <=  pi **(2)'
    """
    text = signs(text)
    return _without_bars(text) if "|" in text else text


def signs(text: str) -> str:
    """Return ``text`` as :func:`plain` does, with bars unchanged."""
    if text.isascii():
        return text
    if re.search(r"γ\s*\(", text):
        raise InputError(
            "two readings remain: write γ*(…) for a product, gamma(…) for the gamma function, or "
            "lowergamma(s, x) for the incomplete one"
        )
    text = re.sub("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]+", lambda m: f"**({m[0].translate(_UPPER)})", text)
    text = re.sub("(?<=[A-Za-zα-ω])[₀-₉]+", lambda m: "_" + m[0].translate(_LOWER), text)
    text = re.sub("([α-ω])(?=_)", lambda m: m[0].translate(_SIGNS).strip(), text)
    return text.translate(_SIGNS)


def _without_bars(text: str) -> str:
    """Replace bars: one where an operand is expected opens, and any other closes."""
    written: list[str] = []
    expected, depth = True, 0
    for character in text:
        if character == "|":
            depth += 1 if expected else -1
            written.append("abs(" if expected else ")")
            if depth < 0:
                break
        else:
            written.append(character)
            if not character.isspace():
                expected = character in _BEFORE_OPENING
    if depth:
        raise InputError("a bar | of an absolute value has no partner: write abs(…)")
    return "".join(written)
