"""Reading a claim: text in the expression grammar, LaTeX, or SymPy's relations."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from tresym.reals.language.expression import Expr, differentiate, number, symbol, symbols
from tresym.reals.language.parsing import Derivative, parse, parse_claim, tidy
from tresym.reals.language.sympy import RELATIONS, atoms, from_sympy
from tresym.reals.language.typography import plain
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given

ORDERS = ("O", "o", "~")
MAX_CHARACTERS = 30_000
MAX_PATH = 200

_WORD = re.compile(r"\s(?:--)?(given|as)\s")
_LATEX = re.compile(r"[\\{}]")
_PATH = re.compile(r"\s*([A-Za-z_]\w*)\s*(?:->|\\to)\s*(.+?)\s*")
_ARROW = re.compile(r"(.+?)(?:->|\\to\b|\\rightarrow\b)(.+)", re.DOTALL)
_SIDE = re.compile(r"\^?\s*\{?\s*([+-])\s*\}?\s*$")
_AND = re.compile(r"\band\b|;|&&?|∧")
_INFINITE = re.compile(r"([-+]?)(?:oo|inf|infinity|\\infty)")
_ASSUMPTIONS = {
    "is_extended_positive": ">",
    "is_extended_negative": "<",
    "is_extended_nonnegative": ">=",
    "is_extended_nonpositive": "<=",
    "is_extended_nonzero": "!=",
}


@dataclass(frozen=True)
class Comparison:
    """``left relation right``; for ``O`` and ``o`` the right side is the gauge.

    Attributes:
        derivatives: those that were written: a derivative is one where its function is real, there
            and beside it.
    """

    left: Expr
    relation: str
    right: Expr
    derivatives: tuple[Derivative, ...] = ()

    @property
    def differentiated(self) -> tuple[Expr, ...]:
        """The functions whose derivatives were written."""
        return tuple(dict.fromkeys(found.function for found in self.derivatives))

    @property
    def by(self) -> frozenset[str]:
        """The variables by which."""
        return frozenset(found.by for found in self.derivatives)


@dataclass(frozen=True)
class Path:
    """A variable that tends to a point.

    Attributes:
        name: the variable.
        point: where it tends, None for infinity.
        sides: +1 for from above or to +∞, −1 for from below or to −∞.
    """

    name: str
    point: Expr | None
    sides: tuple[int, ...]


@dataclass(frozen=True)
class Statement:
    """A claim as it was read.

    Attributes:
        comparisons: all of them are claimed.
        given: the conditions.
        path: for an order statement.
        text: how it was written.
        read_as: the same in the grammar of expressions, conditions and path included.
    """

    comparisons: tuple[Comparison, ...]
    given: Given
    path: Path | None
    text: str
    read_as: str = ""

    def __str__(self) -> str:
        return self.text


def read(claim: Any, given: Any = "", path: str | None = None) -> Statement:
    """A claim with its conditions.

    Args:
        claim: text, LaTeX or a SymPy relation. Text may end in ``given CONDITIONS`` and
            ``as PATH``.
        given: text, LaTeX, SymPy relations, or a :class:`~tresym.reals.Given`.
        path: such as ``"x -> 0+"``.

    Raises:
        InputError: what is not read; one line says why.
    """
    if isinstance(claim, str):
        said, under, where = _texts(claim, given, path)
        text = _split(claim)[0]
        comparisons = tuple(Comparison(*part) for part in parse_claim(said))
        conditions = Given.parse(under)
    else:
        text = str(claim)
        comparisons, conditions = _from_sympy(claim)
        conditions = _given(given) & conditions
        said, under, where = _written(claim), str(conditions), _path_text(path)
    found = read_path(where) if where else None
    return _checked(Statement(comparisons, conditions, found, text, _joined(said, under, where)))


def read_as(claim: Any, given: Any = "", path: str | None = None) -> str:
    """The claim with its conditions and path in the grammar; nothing where it is not read.

    Nothing is built of it, so that it is at hand also where deciding did not end.
    """
    try:
        return (
            claim.read_as if isinstance(claim, Statement) else _joined(*_texts(claim, given, path))
        )
    except InputError:
        return ""


def _joined(claim: str, given: str, path: str) -> str:
    parts = (("", claim), (" given ", given), (" as ", path))
    return "".join(word + tidy(part) for word, part in parts if part.strip())


def _texts(claim: str, given: Any, path: str | None) -> tuple[str, str, str]:
    """A claim, its conditions and its path, each in the grammar of expressions."""
    text, own, own_path = _split(claim)
    conditions = [_given_text(given), _given_text(own)]
    return _plain(text), ", ".join(filter(None, conditions)), _path_text(own_path or path)


def _split(text: str) -> tuple[str, str, str]:
    """The claim, its conditions and its path, quotes around the latter two dropped."""
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"{len(text)} characters are beyond the limit of {MAX_CHARACTERS}")
    claim, *rest = _WORD.split(text)
    found = {"given": "", "as": ""}
    for word, part in zip(rest[::2], rest[1::2], strict=True):
        if found[word]:
            raise InputError(f"a claim has one part that begins with the word {word}")
        found[word] = part.strip().strip("'\"")
    return claim.strip(), found["given"], found["as"]


def _plain(text: str) -> str:
    """``text`` in the characters of the grammar, translated where it is LaTeX."""
    if not _LATEX.search(text):
        return plain(text)
    from tresym.reals.language.latex import read_latex

    chains = read_latex(text.strip().strip("$").replace("==", "="))
    if len(chains) != 1 or chains[0].condition is not None:
        raise InputError("LaTeX: one claim at a time; conditions are given apart")
    return str(chains[0]).replace(" = ", " == ")


def _given_text(given: Any) -> str:
    """Conditions in the grammar of expressions."""
    if not isinstance(given, str):
        return str(_given(given))
    if _LATEX.search(given):
        from tresym.reals.language.latex import read_latex

        given = ", ".join(str(chain) for chain in read_latex(given.strip().strip("$")))
    return _AND.sub(",", plain(given)).strip()


def _path_text(path: str | None) -> str:
    """A path in the grammar of expressions, as ``x -> 0+``."""
    if not path or len(path) > MAX_PATH:
        return path or ""
    match = _ARROW.fullmatch(path.strip().strip("$"))
    if match is None or not _LATEX.search(path):
        return plain(path)
    from tresym.reals.language.latex import read_expression

    side = _SIDE.search(match[2])
    end = match[2][: side.start()] if side else match[2]
    return f"{read_expression(match[1])} -> {read_expression(end)}{side[1] if side else ''}"


def _given(given: Any) -> Given:
    if isinstance(given, Given):
        return given
    if isinstance(given, str):
        return Given.parse(_given_text(given))
    if isinstance(given, Iterable):
        result = Given()
        for part in given:
            result = result & _given(part)
        return result
    return Given.from_sympy(given)


def _from_sympy(claim: Any) -> tuple[tuple[Comparison, ...], Given]:
    """A SymPy relation, and the assumptions its symbols carry."""
    name = type(claim).__name__
    if name not in RELATIONS:
        hint = "; SymPy evaluated it: pass evaluate=False" if name.startswith("Boolean") else ""
        raise InputError(f"{name} is not a claim: give text or a relation such as Eq(f, g){hint}")
    sides = from_sympy(claim.lhs), RELATIONS[name], from_sympy(claim.rhs)
    comparison = Comparison(*sides, _derivatives(claim))
    conditions = []
    names: set[str] = set()
    for variable in _variables(claim):
        if variable.name in names:
            raise InputError(f"two different symbols are called {variable.name}")
        names.add(variable.name)
        for assumption, sign in _ASSUMPTIONS.items():
            if getattr(variable, assumption):
                conditions.append((symbol(variable.name), sign, number(0)))
    return (comparison,), Given(tuple(conditions))


def _written(claim: Any) -> str:
    """A SymPy relation in the grammar, its derivatives as they were written."""

    def derivative(node: Any, walk: Any) -> Expr:
        text = str(walk(node.expr))
        for variable, order in node.variable_count:
            text = f"diff({text}, {variable.name}, {order})"
        return symbol(text)

    left, right = (from_sympy(side, derivative) for side in (claim.lhs, claim.rhs))
    return f"{left} {RELATIONS[type(claim).__name__]} {right}"


def _variables(claim: Any) -> list[Any]:
    """The symbols of a relation, those of its derivatives too, all of them real variables.

    Raises:
        InputError: a symbol that may not take every real value that its sign allows.
    """
    found = atoms(claim, "Symbol")
    for variable in found:
        if variable.is_extended_real is False or variable.is_finite is False:
            raise InputError(f"{variable.name} is not a real variable, and all variables here are")
        for kind in ("integer", "rational", "algebraic"):
            if variable.assumptions0.get(kind) is not None:
                raise InputError(
                    f"whether {variable.name} is {kind} is assumed, and variables here take every "
                    "real value that their sign allows"
                )
    return found


def _derivatives(claim: Any) -> tuple[Derivative, ...]:
    """The derivatives that a SymPy relation, read already, holds: one variable after the other."""
    found: dict[Derivative, None] = {}
    for part in atoms(claim, "Derivative"):
        function = from_sympy(part.expr)
        for variable, count in part.variable_count:
            slope = function
            for _ in range(count):
                slope = differentiate(slope, variable.name)
            found[Derivative(function, variable.name, int(count), slope)] = None
            function = slope
    return tuple(found)


def read_path(text: str) -> Path:
    """``x -> 0``, ``0+``, ``0-``, ``pi/2``, ``oo`` or ``-oo``, for any variable and any constant.

    Raises:
        InputError: anything else.
    """
    match = _PATH.fullmatch(plain(text)) if len(text) <= MAX_PATH else None
    if match is None:
        raise InputError("a path is written like x -> 0+ (or 0, 0-, 1/2, pi, oo, -oo)")
    name, end = match[1], match[2].replace(" ", "")
    infinite = _INFINITE.fullmatch(end)
    if infinite:
        return Path(name, None, (-1 if infinite[1] == "-" else 1,))
    side = end[-1:] if end.endswith(("+", "-")) else ""
    point = parse(end.removesuffix(side).removesuffix("^") if side else end)
    if symbols(point):
        raise InputError("a path ends at a constant or at oo")
    return Path(name, point, {"+": (1,), "-": (-1,)}.get(side, (1, -1)))


def _checked(statement: Statement) -> Statement:
    """The statement, if its parts belong together."""
    order = statement.comparisons[0].relation in ORDERS
    if not order:
        if statement.path is not None:
            raise InputError("a path belongs to O, o and ~ alone; use given for conditions")
        return statement
    if statement.path is None:
        raise InputError("an order claim needs its path, such as --as 'x -> 0+'")
    if statement.given.comparisons:
        raise InputError("an order claim takes no conditions; its path says where it holds")
    (comparison,) = statement.comparisons
    others = (symbols(comparison.left) | symbols(comparison.right)) - {statement.path.name}
    if others:
        raise InputError(
            f"an order claim has one variable, {statement.path.name}; "
            f"{', '.join(sorted(others))} must be numbers"
        )
    return statement
