"""Claims in the comments of a program, beside the code that they are about.

``# tresym: abs(sin(x) - x) <= x**3/6 on 0 <= x <= 1`` is such a comment in Python, Julia, R or a
shell script; C, C++, GLSL, Rust and JavaScript have ``//`` or ``/* … */``, Fortran has ``!``, and
MATLAB has ``%``. Of a program only these comments are read. The name of the file says which sign
begins a comment. In Python a string that contains such a text is no comment; in the other languages
the sign counts wherever it stands.
"""

from __future__ import annotations

import re
import tokenize
from collections.abc import Iterator
from pathlib import PurePath

from tresym.reals.numbers.exact import InputError

_SIGNS = {
    r"#+:?": ("#", "py pyi pyx jl r sh bash zsh pl rb"),
    r"//[/!]*<?|/\*[*!]*<?|^\s*\*+": (
        "//",
        "c h cc cpp cxx hh hpp cu cl glsl vert frag geom comp hlsl wgsl metal rs js mjs ts go java "
        "cs kt scala swift zig",
    ),
    r"!+[<>]?": ("!", "f90 f95 f03 f08"),
    r"%+": ("%", "m"),
}
_SIGN = {f".{end}": (s, shown) for s, (shown, ends) in _SIGNS.items() for end in ends.split()}
"""By the ending of a file: the pattern of the sign that begins a comment, and the sign to show."""


def is_code(file: str) -> bool:
    """Return whether the name of a file is that of a program."""
    return _ending(file) in _SIGN


def how_to_write(file: str) -> str:
    """Return how a claim is written in a program, for a message."""
    return f"{_SIGN[_ending(file)][1]} tresym: CLAIM"


def claims_in_comments(file: str, lines: Iterator[str]) -> Iterator[str]:
    """Yield for every line of a program the claim in its comment, or an empty text.

    Raises:
        InputError: a comment does not have one whole claim after ``tresym:``, or the file has an
            ending of Python and is not Python.
    """
    mark = re.compile(rf"(?:{_SIGN[_ending(file)][0]})\s*tresym:(.*)", re.IGNORECASE)
    if _ending(file) in (".py", ".pyi"):
        lines = _python_comments(file, lines)
    for number, line in enumerate(lines, 1):
        found = mark.search(line)
        if found is None:
            yield ""
            continue
        claim, ends, _ = found[1].partition("*/" if "*" in found[0][:2] else "#")
        if "tresym:" in found[1].lower():
            raise InputError(f"{file}, line {number}: write one claim in a line")
        if not claim.strip():
            raise InputError(f"{file}, line {number}: write a claim after tresym:")
        if found[0].startswith("/*") and not ends:
            raise InputError(f"{file}, line {number}: end the comment with */ in this line")
        yield claim


def _ending(file: str) -> str:
    return PurePath(file).suffix.lower()


def _python_comments(file: str, lines: Iterator[str]) -> Iterator[str]:
    """Yield for every line its comment, or an empty text; strings are no comments."""
    at = 0
    try:
        for token in tokenize.generate_tokens(lambda: next(lines) + "\n"):
            if token.type == tokenize.COMMENT:
                yield from [""] * (token.start[0] - at - 1)
                at = token.start[0]
                yield token.string
    except (tokenize.TokenError, SyntaxError) as error:
        raise InputError(f"{file}: this is not Python ({error.args[0]})") from None
