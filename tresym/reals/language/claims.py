"""Read a claim with its conditions and its path, from text, LaTeX or SymPy relations, as trees.

``sin(x) == x + O(x^3) given a > 0 as x -> 0+`` is the comparison of two trees, the condition a > 0
and the path. Text goes through the strict grammar; text that this rejects is first spelled in it
(:mod:`tresym.reals.language.sentences`). What is shown as ``read as`` is read again, so that just
that is decided. Nothing is worked out here.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from typing import Any, NamedTuple

from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, ORDERS
from tresym.reals.language.differential_notation import with_differential_notation
from tresym.reals.language.expression import ZERO, symbol, symbols
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.parsing import parse_claim, parse_given, sequences_of
from tresym.reals.language.paths import MAX_PATH, Path, path_in_latex, read_path
from tresym.reals.language.sentences import spelled, spelled_conditions
from tresym.reals.language.sympy import (
    RELATIONS,
    conditions_from_sympy,
    order_paths,
    relation_from_sympy,
    unworked,
)
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.exact import InputError

MAX_CHARACTERS = 30_000
NO_CHAIN = "a limit or an order claim cannot be part of a chain: write one relation at a time"
_WORD = re.compile(r"(?<!\{)\s(?:--)?(given|as|on|at(?=\s+[A-Za-z]\w*\s*=))\s(?!\s*\})")
_LATEX = re.compile(r"[\\{}]")
_NO_LETTERS = re.compile(
    r"\\(?:mathrm|operatorname|text\w*|exp)\s*(?:\{[^{}]*\})?|\\[A-Za-z]+|_\{?\w+"
)
_LETTER_E = re.compile(r"(?<![A-Za-z])e(?![A-Za-z])")
_AND = re.compile(r"\band\b|;|&&?|∧")
_DANGLING = re.compile(r"\b(and|or)\s*$")
_MEANT = re.compile(r",\s*\((\w+),\s*([\w./+-]+)\)\s*\)\s*$")
"""The end of an order as SymPy prints it: O(x**(-4), (x, oo))."""
UNIFORMLY = re.compile(
    r"\suniformly\b(?:\s+in\s+([A-Za-z]\w*(?:(?:\s*,\s*|\s+and\s+)[A-Za-z]\w*)*))?"
)
"""The word that asks for one constant, and the variables in which, if they are named."""


class Written(NamedTuple):
    """A claim as it was written, nothing of it worked out."""

    comparisons: tuple[Compared, ...]
    given: tuple[Compared, ...]
    path: Path | None
    on: tuple[Compared, ...] = ()
    uniformly: bool = False

    def __str__(self) -> str:
        parts = (("", chained(self.comparisons)), (" given ", chained(self.given)))
        text = "".join(word + part for word, part in parts if part)
        text += " uniformly" if self.uniformly else ""
        text = text if self.path is None else f"{text} as {self.path}"
        return f"{text} on {chained(self.on)}" if self.on else text


def read_claim(claim: Any, given: Any = "", path: str | None = None) -> Written:
    """Read a claim with its conditions and its path; what is not typed plainly is read twice.

    Args:
        claim: text, LaTeX or a SymPy relation. Text may end in ``given CONDITIONS`` and
            ``as PATH``.
        given: text, LaTeX, SymPy relations, or a :class:`~tresym.reals.domain.conditions.Given`.
        path: such as ``"x -> 0+"``.

    Raises:
        InputError: the input cannot be read; the message is one line and says what to write.
    """
    written = as_written(claim, given, path)
    for _, relation, _ in written.comparisons:
        if relation not in (*RELATIONS.values(), *ORDERS, LIMIT):
            raise InputError(
                f"{relation} does not make a claim: use one of == != > >= < <= ~ or ->"
            )
        if relation in (*ORDERS, LIMIT) and len(written.comparisons) > 1:
            raise InputError(NO_CHAIN)
    if all(isinstance(part, str) and _is_plain(part) for part in (claim, given, path or "")):
        return written
    return _read_again(str(written))


def as_written(claim: Any, given: Any, path: str | None) -> Written:
    """Read a claim once, as :func:`read_claim` does where it is typed plainly."""
    uniformly = UNIFORMLY.search(claim) if isinstance(claim, str) else None
    if uniformly is None:
        return _without_uniformly(claim, given, path)
    found = _without_uniformly(UNIFORMLY.sub("", claim), given, path)
    _need_all_parameters(found, uniformly[1])
    return found._replace(uniformly=True)


def _need_all_parameters(claim: Written, named: str | None) -> None:
    """Refuse ``uniformly in a`` where other variables than those named vary with it."""
    if named is None:
        return
    names = set(re.split(r"\s*,\s*|\s+and\s+", named))
    own = {"" if claim.path is None else claim.path.name, *symbols(INFINITY)}
    there = {n for link in claim.comparisons for e in link[::2] for n in symbols(e)} - own
    if there != names:
        all_, one = ", ".join(sorted(there)), ", ".join(sorted(names))
        raise InputError(
            f"uniformly in {one}: one constant is asked for all variables beside that of the path, "
            f"here {all_ or 'none'}; write uniformly" + (f" in {all_}" if all_ else "")
        )


def _without_uniformly(claim: Any, given: Any, path: str | None) -> Written:
    if not isinstance(claim, str):
        comparison, conditions = relation_from_sympy(claim)
        tends = _path(path) or _path_of_orders(claim)
        if tends is not None:
            conditions, tends = _without_sign(conditions, tends)
        return Written((comparison,), (*_given(given), *conditions), tends)
    if isinstance(given, str) and not _LATEX.search(claim + given):
        claim, given = with_differential_notation(claim, given)
    # A region after a path, "as n -> oo on n >= 1", is said in the grammar.
    typed, word, region = claim.partition(" on ") if " as " in claim else (claim, "", "")
    try:
        return _strictly(claim, given, path)
    except InputError:
        found = spelled(typed, given if isinstance(given, str) else "")
        if found is None:
            raise
    end = found.path or path
    more = f" given {found.given}" if found.given else ""
    again = _strictly(f"{found.claim}{more}{word}{region}", given, end)
    return _read_again(str(again))


def _strictly(claim: str, given: Any, path: str | None) -> Written:
    """A claim of text or LaTeX in the grammar as it stands."""
    text, own, own_path, region = parts_of(claim)
    meant = _MEANT.search(text)
    if meant is not None and not (own_path or path):
        own_path = f"{meant[1]} -> {meant[2]}"
    text = text if meant is None else f"{text[: meant.start()]})"
    under, end, on = (*_given(given), *_given(own)), _path(own_path or path), _given(region)
    if not _LATEX.search(text):
        sequences = _sequences(f"{given if isinstance(given, str) else ''}, {own}")
        written = Written(tuple(parse_claim(plain(text), sequences)), under, end, on)
        return _with_one_e(written, given, own)
    from tresym.reals.language.latex import read_latex

    if "\\" not in text and re.search(r"[A-Z]\w*\[.*{", text):
        raise InputError(
            "braces are read as LaTeX; write an expansion as sin(x) == x + O(x**3) as x -> 0, a "
            "sum as sum(f, k, 1, n), and an integral as integral(f, x, a, b)"
        )
    chains = read_latex(text.strip().strip("$"), None, _sequences(given, own, text))
    last = chains[-1] if chains[1:] and chains[-1].ops[0].startswith("->") else None
    said = last or chains[0].condition
    if len(chains) != (2 if last else 1):
        raise InputError(
            "LaTeX: give one claim at a time; put its conditions after "
            "\\text{for} or give them separately"
        )
    if said is not None and said.ops[0].startswith("->"):
        end = path_in_latex(said)
    elif said is not None:
        parse_given(chained((*under, *said.links)))
        under = (*under, *said.links)
    written = Written(tuple(chains[0].links), under, end, on)
    return _with_one_e(written, text, given, own)


def _with_one_e(written: Written, *parts: Any) -> Written:
    """The claim, unless e is Euler's number in a part in LaTeX and a variable in another one."""
    latex = (part for part in parts if isinstance(part, str) and _LATEX.search(part))
    if not any(_LETTER_E.search(_NO_LETTERS.sub(" ", part)) for part in latex):
        return written
    links, path = (*written.comparisons, *written.given, *written.on), written.path
    names = {path.name, *path.together} if path is not None else set()
    if path is not None and path.expression is not None:
        names |= symbols(path.expression)
    if "e" in names.union(*(symbols(side) for left, _, right in links for side in (left, right))):
        raise InputError(
            "two readings remain: e is Euler's number in LaTeX, and a variable in plain text; call "
            "the variable by another name, or write \\exp or \\mathrm{e} for the number"
        )
    return written


def parts_of(text: str) -> tuple[str, str, str, str]:
    """Return the claim, its conditions, path and region, quotes around the latter three dropped.

    Values, as in ``diff(x**2, x) == 2 at x == 1``, are conditions.
    """
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"the claim has {len(text)} characters; the limit is {MAX_CHARACTERS}")
    claim, *rest = _WORD.split(text)
    found = {"given": "", "as": "", "on": "", "at": ""}
    for word, part in zip(rest[::2], rest[1::2], strict=True):
        if found[word]:
            raise InputError(f"a claim can have only one part that begins with the word {word}")
        found[word] = part.strip().strip("'\"")
    given = ", ".join(filter(None, (found["given"], found["at"])))
    return claim.strip(), given, found["as"], found["on"]


def _read_again(shown: str) -> Written:
    """What is written in the text that is shown: of LaTeX and of SymPy just that is decided."""
    uniformly = UNIFORMLY.search(shown) is not None
    shown, _, on = UNIFORMLY.sub("", shown).partition(" on ")
    claim, _, end = shown.partition(" as ")
    claim, _, under = claim.partition(" given ")
    path = read_path(end) if end else None
    parts = tuple(parse_claim(claim, sequences_of(under))), tuple(parse_given(under))
    return Written(*parts, path, _given(on), uniformly)


def _is_plain(text: str) -> bool:
    """Whether text is in the grammar as it stands, neither LaTeX nor with signs of print."""
    return text.isascii() and not _LATEX.search(text)


def _path_of_orders(claim: Any) -> Path | None:
    """Return where the orders of a SymPy relation are meant, as in O(r**(-5), (r, oo))."""
    found = order_paths(claim)
    if len(found) > 1:
        raise InputError("the orders of a claim must belong to one path")
    if not found:
        return None
    ((name, point, sign),) = found
    return Path(name, point, (sign,) if point is None else (1, -1))


def _without_sign(
    conditions: tuple[Compared, ...], path: Path
) -> tuple[tuple[Compared, ...], Path]:
    """Use the assumption that the variable of the path is positive for its side."""
    x = symbol(path.name)
    signs = [link for link in conditions if link[0] == x and link[1] != "in"]
    for link in signs:
        if link[1] == "!=":
            continue  # so it is beside the end
        side = 1 if link[1][0] == ">" else -1
        if path.point == ZERO and side in path.sides:
            path = replace(path, sides=(side,))
        elif path.sides != (side,) and path.point is None:
            return conditions, path
    inside = path.point is None or path.point.op == "number"
    return (tuple(x for x in conditions if x not in signs), path) if inside else (conditions, path)


def _path(path: str | None) -> Path | None:
    if not path:
        return None
    if len(path) > MAX_PATH or not _LATEX.search(path):
        return read_path(path)
    from tresym.reals.language.latex import read_latex

    return path_in_latex(read_latex(path.strip().strip("$").replace("->", "\\to"))[0])


def _given(given: Any) -> tuple[Compared, ...]:
    if hasattr(given, "comparisons"):
        known: tuple[Compared, ...] = given.comparisons
        return known
    if isinstance(given, str) and _LATEX.search(given):
        from tresym.reals.language.latex import read_latex

        source = given.strip().strip("$")
        chains = read_latex(source, None, _sequences(source))
        links = tuple(link for chain in chains for link in chain.links)
        parse_given(chained(links))  # if they can be conditions
        return links
    if isinstance(given, str):
        if word := _DANGLING.search(given):
            raise InputError(f"a condition is missing after the word {word[1]}")
        try:
            return tuple(parse_given(_AND.sub(",", plain(given)).strip()))
        except InputError:
            again = spelled_conditions(given)
            if again is None:
                raise
            return tuple(parse_given(again))
    if isinstance(given, Iterable) and getattr(given, "ndim", None) != 0:
        return tuple(link for part in given for link in _given(part))
    if type(given).__name__ == "Equality":
        return (_condition((unworked(given.lhs), "==", unworked(given.rhs))),)
    return conditions_from_sympy(given)


def _sequences(*parts: Any) -> frozenset[str]:
    """Return the letters of sequences for which a part states a recurrence, in text or LaTeX."""
    from tresym.reals.language.latex import sequences_in

    found: frozenset[str] = frozenset()
    for part in parts:
        if isinstance(part, str) and part.strip():
            latex = _LATEX.search(part)
            found |= sequences_in(part.strip().strip("$")) if latex else sequences_of(part)
    return found


def _condition(link: Compared) -> Compared:
    """A condition from elsewhere, if it can be one."""
    parse_given(chained((link,)))
    return link
