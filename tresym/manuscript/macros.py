"""Expand an author's LaTeX macros."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from tresym.reals.numbers.exact import InputError

MAX_GROUP = 50_000
MAX_STEPS = 4_000
MAX_WRITTEN_OUT = 60_000

DEFINITIONS = re.compile(
    r"\\(?:(?:re|provide)?newcommand|DeclareRobustCommand|DeclareMathOperator"
    r"|DeclarePairedDelimiter|newenvironment|renewenvironment)\*?(?![a-zA-Z])"
    r"|\\(?:[gex]?def|let)(?![a-zA-Z])"
)
_NAME = re.compile(r"\s*(?:\{\s*(\\[a-zA-Z@]+|\\.|[a-zA-Z]+\*?)\s*\}|(\\[a-zA-Z@]+|\\.))")
_COUNT = re.compile(r"\s*\[(\d)\]")
_PARAMETERS = re.compile(r"((?:#\d)*)\s*(?=\{)")
_BETWEEN = re.compile(r"\s*#1\s*(\\[a-zA-Z@]+)\s*(?=\{)")
"""The parameters of ``\\def\\be#1\\ee``: what stands between two commands."""
_BRACE = re.compile(r"\\.|[{}]", re.DOTALL)
_COMMAND = re.compile(r"\\(?:[a-zA-Z@]+|.)", re.DOTALL)
_SPACE = re.compile(r"\s*")
_POWER = re.compile(r"(?<=[\d.])[eEdD]([-+]?\d+)\Z")


class Macro(NamedTuple):
    """The definition of a command; ``#1`` to ``#9`` in its body are its arguments.

    Attributes:
        takes: the number of arguments.
        body: the replacement text; None for a definition that is not supported.
        default: the default of an optional first argument; None if there is none.
        starred: whether a star and a size in brackets behind it are skipped.
    """

    takes: int
    body: str | None
    default: str | None = None
    starred: bool = False


USUAL = {
    "\\abs": Macro(1, r"\left|#1\right|", starred=True),
    "\\dd": Macro(0, r"\,\mathrm{d}"),
    "\\d": Macro(0, r"\,\mathrm{d}"),
    "\\md": Macro(0, r"\mathrm{d}"),
    "\\me": Macro(0, r"\mathrm{e}"),
    "\\mi": Macro(0, r"\mathrm{i}"),
    "\\diff": Macro(0, r"\,\mathrm{d}"),
    "\\eval": Macro(1, r"\left.#1\right|", starred=True),
    "\\answer": Macro(2, "#2", default=""),
    "\\nicefrac": Macro(2, r"\frac{#1}{#2}"),
    "\\sfrac": Macro(2, r"\frac{#1}{#2}"),
    "\\norm": Macro(1, r"\left\|#1\right\|", starred=True),
    "\\num": Macro(1, "#1"),
    "\\coloneqq": Macro(0, ":="),
    "\\ensuremath": Macro(1, "#1"),
    "\\mathstrut": Macro(0, ""),
    "\\textcolor": Macro(3, "#3", default=""),
    "\\mathcolor": Macro(3, "#3", default=""),
    "\\colorbox": Macro(2, "#2"),
    "\\phantom": Macro(1, ""),
    "\\hphantom": Macro(1, ""),
    "\\vphantom": Macro(1, ""),
    "\\strut": Macro(0, ""),
    "\\arcosh": Macro(0, r"\operatorname{arcosh}"),
    "\\arsinh": Macro(0, r"\operatorname{arsinh}"),
    "\\artanh": Macro(0, r"\operatorname{artanh}"),
    **{f"\\{letter}": Macro(0, rf"\mathbb{{{letter}}}") for letter in "RNZQC"},
}
"""Commands of usual packages, and usual names of sets of numbers, for documents (a chapter alone,
say) that do not define them."""


def group(text: str, at: int) -> tuple[str, int]:
    """Return the group in braces at ``at``, or the single token, and where to continue.

    Raises:
        InputError: the group is not closed.
    """
    at = _skip(text, at)
    if text[at : at + 1] != "{":
        found = _COMMAND.match(text, at)
        end = found.end() if found else at + 1
        return text[at:end], end
    depth = 0
    for mark in _BRACE.finditer(text, at, at + MAX_GROUP):
        depth += (mark[0] == "{") - (mark[0] == "}")
        if depth == 0:
            return text[at + 1 : mark.start()], mark.end()
    raise InputError(f"a brace {{ is not closed within {MAX_GROUP} characters")


def _skip(text: str, at: int) -> int:
    found = _SPACE.match(text, at)
    return found.end() if found else at


def _optional(text: str, at: int) -> tuple[str | None, int]:
    start = _skip(text, at)
    if text[start : start + 1] != "[":
        return None, at
    end = text.find("]", start, start + MAX_GROUP)
    if end < 0:
        raise InputError("a bracket [ is not closed")
    return text[start + 1 : end], end + 1


def definition(text: str, command: re.Match[str]) -> tuple[dict[str, Macro], int]:
    """Return the macros that the definition at ``command`` defines, and where to continue.

    An environment is defined by two macros, ``\\begin{name}`` and ``\\end{name}``.

    Raises:
        InputError: the definition is not closed.
    """
    word, at = command[0].rstrip("*"), command.end()
    named = _NAME.match(text, at)
    if named is None:
        return {}, at
    name, at = named[1] or named[2], named.end()
    if word == "\\let":
        at = _skip(text, at)
        value, at = group(text, at + (text[at : at + 1] == "="))
        return {name: Macro(0, value)}, at
    if word.endswith("def"):
        parameters = _PARAMETERS.match(text, at)
        if pair := _BETWEEN.match(text, at):
            body, at = group(text, pair.end())
            if body.count("#") == 1:
                before, _, after = body.partition("#1")
                return {name: Macro(0, before), pair[1]: Macro(0, after)}, at
            return {name: Macro(0, None)}, at
        if parameters is None:  # delimited parameters
            opening = text.find("{", at, at + 200)
            _, at = group(text, opening) if opening >= 0 else ("", at)
            return {name: Macro(0, None)}, at
        body, at = group(text, parameters.end())
        return {name: Macro(len(parameters[1]) // 2, body)}, at
    if word == "\\DeclareMathOperator":
        body, at = group(text, at)
        return {name: Macro(0, rf"\operatorname{{{body}}}")}, at
    if word == "\\DeclarePairedDelimiter":
        left, at = group(text, at)
        right, at = group(text, at)
        return {name: Macro(1, rf"\left{left} #1\right{right}", starred=True)}, at
    found = _COUNT.match(text, at)
    count, at = (int(found[1]), found.end()) if found else (0, at)
    default, at = _optional(text, at)
    body, at = group(text, at)
    if not word.endswith("environment"):
        return {name: Macro(count, body, default)}, at
    closing, at = group(text, at)
    return {
        f"\\begin{{{name}}}": Macro(count, body, default),
        f"\\end{{{name}}}": Macro(0, closing),
    }, at


def written_out(text: str, macros: Mapping[str, Macro]) -> str:
    """Return ``text`` with the macros expanded.

    Raises:
        InputError: a macro expands without end, or its definition is not supported.
    """
    done: list[str] = []
    steps = size = at = 0
    while (mark := _COMMAND.search(text, at)) is not None:
        macro = macros.get(mark[0]) or USUAL.get(mark[0])
        if macro is None:
            done.append(text[at : mark.end()])
            at = mark.end()
            continue
        done.append(text[at : mark.start()])
        steps, size = steps + 1, size + mark.start() - at
        if macro.body is None:
            raise InputError(f"the definition of the macro {mark[0]} is not supported")
        value, at = _applied(macro, mark[0], text, mark.end())
        text, at = _joined(value, text[at:]), 0
        if steps > MAX_STEPS or size + len(text) > MAX_WRITTEN_OUT:
            raise InputError(f"the macro {mark[0]} does not end, or its expansion is too long")
    return "".join(done) + text[at:]


def _applied(macro: Macro, name: str, text: str, at: int) -> tuple[str, int]:
    """Return the body with its arguments inserted, and where to continue."""
    given: list[str] = []
    if macro.starred:
        at += text[at : at + 1] == "*"
        _, at = _optional(text, at)
    if macro.default is not None:
        value, at = _optional(text, at)
        given.append(macro.default if value is None else value)
    while len(given) < macro.takes:
        if _skip(text, at) >= len(text):
            raise InputError(f"the macro {name} lacks an argument")
        value, at = group(text, at)
        given.append(value)
    if name == "\\num":
        given = [_POWER.sub(r"\\times10^{\1}", value) for value in given]
    pieces = re.split(r"#(\d)", macro.body or "")
    result = pieces[0]
    for digit, piece in zip(pieces[1::2], pieces[2::2], strict=True):
        value = given[int(digit) - 1] if 0 < int(digit) <= len(given) else ""
        result = _joined(_joined(result, value), piece)
    return result, at


def _joined(first: str, second: str) -> str:
    """Join two texts, with a space if a command would otherwise run into letters."""
    apart = second[:1].isalpha() and re.search(r"\\[a-zA-Z@]+\Z", first)
    return f"{first} {second}" if apart else first + second
