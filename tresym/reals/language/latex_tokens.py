"""Tokenise LaTeX mathematics; spacing, sizes and labels are dropped."""

from __future__ import annotations

import re

from tresym.reals.functions.table import SPECIAL, TABLE, upright, written_after
from tresym.reals.numbers.exact import InputError

MAX_CHARACTERS = 10_000
MAX_DEPTH = 60


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_ELEMENTARY = [row for row in TABLE.values() if row.theory and row.arity == 1]
_NAMED = [row for row in _ELEMENTARY if written_after(row)]
FUNCTIONS = {
    **{word: row.name for row in _NAMED for word in (row.name, upright(row), *row.reads)},
    **{alias: row.name for row in _NAMED for alias in row.aliases if alias.startswith("arc")},
    **{word: row.of_reciprocal[0] for row in _NAMED for word in row.of_reciprocal},
    **{f"ar{a[1:]}": a for row in _NAMED for a in row.of_reciprocal[:1] if a.endswith("h")},
    "gd": "gd",
    **{
        upright(row): name
        for name, row in TABLE.items()
        if name in SPECIAL and row.arity == 1 and not row.internal and "operatorname" in row.latex
        if upright(row).isalpha()
    },
}
"""Commands and upright words that apply a function, and the function."""
WITH_ORDER = {
    row.latex.strip("\\").removeprefix("operatorname{").rstrip("}"): name
    for name, row in TABLE.items()
    if row.subscripted
}
"""Letters and words that denote a special function where a subscript gives its order."""
OF_GREEK = {"\\Gamma": "gamma", "\\zeta": "zeta"}
"""Greek letters that denote a special function before an argument in brackets."""
GREEK = _words(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau "
    "upsilon phi chi psi omega varepsilon vartheta varphi varpi varrho varsigma "
    "Gamma Theta Lambda Xi Sigma Upsilon Phi Psi Omega ell hbar"
)
EXTREMES = {"\\max": 1, "\\min": -1}
RELATIONS = {
    **dict.fromkeys(("=", "==", ":=", "\\equiv"), "=="),
    **dict.fromkeys(("<", "\\lt"), "<"),
    **dict.fromkeys((">", "\\gt"), ">"),
    **dict.fromkeys(("\\le", "\\leq", "\\leqslant"), "<="),
    **dict.fromkeys(("\\ge", "\\geq", "\\geqslant"), ">="),
    **dict.fromkeys(("\\ne", "\\neq"), "!="),
    **dict.fromkeys(("\\simeq", "\\approx", "\\sim"), "~"),
    **dict.fromkeys(("\\to", "\\rightarrow"), "->"),
    "\\ll": "<<",
    "\\gg": ">>",
    "\\in": "in",
}
"""Relations as they are written, and as they are read."""
LETTERS_OF_FUNCTIONS = _words("f g h F G Gamma zeta")
RESERVED = _words("E I lambda pi") | frozenset(FUNCTIONS.values())
_GAPS = {"\\ "} | _words("\\, \\; \\: \\quad \\qquad ~")
_SPACES = _GAPS | _words("\\! \\displaystyle \\textstyle \\limits \\nonumber \\notag")
_SIZES = frozenset(
    f"\\{size}{side}" for size in _words("big Big bigg Bigg") for side in ("", *"lrm")
)
_LETTER = r"([A-Za-z]|\\(?:" + "|".join(sorted(GREEK)) + r")(?![a-zA-Z]))"
_SUBSCRIPT = r"(?:\s*_\s*(?:\{([^{}]*)\}|([a-zA-Z0-9])))?"
_ACCENT = re.compile(
    r"\\(bar|hat|tilde|check|breve|widehat|widetilde|overline|mathcal|mathscr|mathfrak)(?![a-zA-Z])"
    rf"\s*(?:\{{\s*{_LETTER}{_SUBSCRIPT}\s*\}}|{_LETTER}){_SUBSCRIPT}"
)
_STAR = re.compile(
    rf"{_LETTER}{_SUBSCRIPT}\s*\^\s*(?:\{{\s*(?:\*|\\ast|\\star)\s*\}}|\*|\\ast|\\star)"
)
_OVER = re.compile(r"\{([^{}]*)\\over(?![a-zA-Z])([^{}]*)\}")
_CHOOSE = re.compile(r"\{((?:[^{}]|\{[^{}]*\})*?)\\choose(?![a-zA-Z])((?:[^{}]|\{[^{}]*\})*)\}")
ARRAYS = _words("array aligned align align* gathered cases equation equation* split")
STOPS = (",", ".", ";", "\\Rightarrow", "\\Longrightarrow", "\\implies")
CLOSING = _words("+ - ) ] \\} } \\rfloor \\rceil & : / | ^ !")
CONDITION = "\\conditionfor"
"""The token for upright words that open a condition."""
_CONDITIONS = frozenset(("for", "for all", "if", "when", "whenever", "as", "given", "provided"))

ELLIPSIS = "\\ldots"
GOES_ON = "digits that go on are not read: write the limit or a fraction"
"""Why a decimal with dots behind its digits, as ``0.999\\ldots``, is refused."""
_SAME = dict.fromkeys(("\\cdots", "\\dots", "\\dotsb", "\\dotsc"), ELLIPSIS)
_SAME |= {"\\forall": CONDITION, "\\lbrace": "\\{", "\\rbrace": "\\}", "\\vert": "|"} | {
    "\\lvert": "\\left|",
    "\\rvert": "\\right|",
}


class Called(str):
    """A token that names a sequence, whose index stands in the bracket behind it."""

    __slots__ = ()


class Spaced(str):
    """A token before which the author put a space that prints."""

    __slots__ = ()


_BRACED = re.compile(
    rf"\{{\s*(\\(?:{'|'.join(FUNCTIONS)})\s*(?:\^\s*(?:[\da-z]|\{{[^{{}}]*\}}))?)\s*\}}"
)
_TOKEN = re.compile(
    r"""(?P<space>\s+|%[^\n]*\n?)
      | (?P<command>\\(?:begin|end)\{[a-zA-Z*]+\}|\\[a-zA-Z]+|\\.)
      | (?P<number>\d+(?:\.\d+)?|\.\d+)
      | (?P<other>:=|==|.)""",
    re.VERBOSE | re.DOTALL,
)


def tokenize(source: str, words: frozenset[str] = frozenset()) -> list[str]:
    """The tokens of a formula; ``words`` are runs of letters that are one name.

    Raises:
        InputError: too long, or nested too deeply.
    """
    if len(source) > MAX_CHARACTERS:
        raise InputError(f"LaTeX: {len(source)} characters are beyond the limit {MAX_CHARACTERS}")
    raw = _merged(
        [m[0] for m in _TOKEN.finditer(_prepared(source)) if m.lastgroup != "space"], words
    )
    depth = 0
    for token in raw:
        depth += (token in "{([") - (token in "})]")
        if depth > MAX_DEPTH:
            raise InputError(f"LaTeX: nested deeper than {MAX_DEPTH} levels")
    return raw


def _prepared(source: str) -> str:
    """Without labels, the optional space after a line's end, and braces around a function's name;
    upright text as commands.
    """
    source = re.sub(r"\\(?:label|tag|color)\s*\{[^{}]*\}", " ", source)
    source = re.sub(r"\\\\\s*\[[^\[\]]*\]", r"\\\\ ", source)
    source = re.sub(r"\\mathrm\s+([dei])|\\mathcal\s*\{?\s*([Oo])\b\s*\}?", r" \1\2 ", source)
    source = re.sub(
        r"(\\(?:text|textrm|mathrm|operatorname|mbox|textup))\s*\{([^{}]*)\}", _text, source
    )
    source = _OVER.sub(r"\\frac{\1}{\2}", source)
    source = _CHOOSE.sub(r"\\binom{\1}{\2}", source)
    source = _STAR.sub(lambda m: _marked(m[1], m[2], m[3], "star"), source)
    source = _ACCENT.sub(lambda m: _marked(m[2] or m[5], m[3], m[4], m[6], m[7], m[1]), source)
    return _BRACED.sub(r"\1 ", source)


def _marked(letter: str, *marks: str | None) -> str:
    """A letter with an accent, a script or a star: they are the end of its name."""
    return f"{letter}_{{{''.join(mark for mark in marks if mark)}}}"


def _text(match: re.Match[str]) -> str:
    """Upright text: a function's name, the letters d, e and i, radians, or a condition's "for".

    Of a subscript it is the letters. What else it may be, no text is dropped: it is refused.
    """
    word = match[2].strip()
    if match.string[: match.start()].rstrip().endswith(("_", "_{")):
        return f"{{{word}}}" if match.string[match.start() - 1] == "_" else f"{word} "
    if word in FUNCTIONS or word in WITH_ORDER:
        return f"\\{word} "
    if word in ("d", "e", "i"):
        return f" {word} "
    if word == "rad":
        return " "
    if word.lower() in _CONDITIONS:
        return f" {CONDITION} "
    return match[0]


def _merged(raw: list[str], words: frozenset[str]) -> list[str]:
    """Tokens without spacing and sizes; declared words become one token."""
    kept = _without_spaces([t for t in raw if t not in _SIZES])
    result: list[str] = []
    i = 0
    while i < len(kept):
        word = next((w for w in words if kept[i : i + len(w)] == list(w)), None)
        if word:
            result.append(word)
            i += len(word)
        elif kept[i] in ("\\left", "\\right"):
            delimiter = kept[i + 1] if i + 1 < len(kept) else ""
            delimiter = {"\\vert": "|", "\\lvert": "|", "\\rvert": "|"}.get(delimiter, delimiter)
            # "\left." and "\right." are invisible partners of an evaluation bar.
            result.append(f"{kept[i]}{delimiter}" if delimiter in (".", "|") else delimiter)
            i += 2
        else:
            result.append(_SAME.get(kept[i], kept[i]))
            i += 1
    return result


def _without_spaces(raw: list[str]) -> list[str]:
    """The tokens but for spaces; one behind a space that prints is :class:`Spaced`."""
    kept: list[str] = []
    gap = False
    for token in raw:
        if token not in _SPACES:
            kept.append(Spaced(token) if gap else token)
            gap = False
        elif token in _GAPS:
            gap = True
    return kept


def with_sign(tokens: list[str], sign: str) -> list[str]:
    """The tokens with ``\\pm`` as this sign, and ``\\mp`` as the other."""
    signs = {"\\pm": sign, "\\mp": "-" if sign == "+" else "+"}
    return [signs.get(token, token) for token in tokens]
