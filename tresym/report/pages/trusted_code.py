"""Count the lines of code that verdicts depend on, by a call graph of the sources.

A *piece* is a function, method, class or constant. The roots are the functions that issue verdicts.
A piece is reached if a reached piece names it. A method is also reached if its class is reached and
a reached piece uses an attribute of that name, or if a method of its class or of a base of it looks
up attributes of ``self`` by computed names. Code that only searches, so that other code checks what
it finds, is counted with the rest.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import tresym

ROOTS = ("ledger.judge.judge", "ledger.judge.judge_evidence", "checking.dispatch.decide_claim")
"""The functions that issue verdicts, on claims of the ledger and on a user's claim."""

Piece = tuple[str, str]


@cache
def trusted(roots: Collection[str] = ROOTS) -> int:
    """Return the number of lines of code that functions depend on.

    Args:
        roots: full names of the functions, without the leading ``tresym.``.
    """
    return counted(reached(roots))


def reached(roots: Collection[str] = ROOTS) -> set[Piece]:
    """Return all pieces that can be reached from ``roots``."""
    seen: set[Piece] = set()
    attributes: set[str] = set()
    waiting = [piece_of(name) for name in roots]
    # A newly reached attribute name may make methods of classes reached earlier count, so the
    # inner search is repeated until nothing new is found.
    while waiting:
        while waiting:
            piece = waiting.pop()
            if piece in seen:
                continue
            seen.add(piece)
            waiting += _named_in(*piece)
            attributes |= _attributes(*piece)
        picking = {(file, name.rpartition(".")[0]) for file, name in seen if _picks(file, name)}
        picking |= {piece for piece in seen if not picking.isdisjoint(_bases(*piece))}
        named = {m for m in _methods(seen) if _is_meant(m[1], attributes)}
        waiting = [*({*_methods(picking), *named} - seen)]
    return seen


def _methods(found: Collection[Piece]) -> Iterator[Piece]:
    """The methods of those pieces that are classes."""
    for file, owner in found:
        yield from _methods_of(file, owner)


@cache
def _methods_of(file: str, owner: str) -> tuple[Piece, ...]:
    """The methods of a piece, if it is a class."""
    return tuple((file, name) for name in _file(file).pieces if name.startswith(f"{owner}."))


@cache
def _bases(file: str, name: str) -> tuple[Piece, ...]:
    """The classes from which a piece inherits, if it is a class."""
    node = _file(file).pieces[name]
    bases = node.bases if isinstance(node, ast.ClassDef) else []
    found = (_piece(file, base.id) for base in bases if isinstance(base, ast.Name))
    return tuple(piece for piece in found if piece is not None)


@cache
def _attributes(file: str, name: str) -> frozenset[str]:
    """The names of attributes that a piece uses."""
    nodes = _nodes(_file(file).pieces[name])
    return frozenset(node.attr for node in nodes if isinstance(node, ast.Attribute))


@cache
def _picks(file: str, name: str) -> bool:
    """Whether a piece looks up an attribute of ``self`` by a computed name."""
    calls = (n for n in _nodes(_file(file).pieces[name]) if isinstance(n, ast.Call))
    return any(
        isinstance(call.func, ast.Name)
        and call.func.id == "getattr"
        and isinstance(call.args[0], ast.Name)
        and call.args[0].id == "self"
        for call in calls
    )


def _is_meant(method: str, attributes: Collection[str]) -> bool:
    """Whether a method may be called: it is named as an attribute, or Python itself calls it."""
    name = method.rpartition(".")[2]
    return name in attributes or name.startswith("__")


def piece_of(name: str) -> Piece:
    """Return the module and the name within it of a piece, from its full name."""
    file, _, rest = name.rpartition(".")
    while not _is_file(file):
        file, _, more = file.rpartition(".")
        rest = f"{more}.{rest}"
    return file, rest


def counted(pieces: Collection[Piece]) -> int:
    """Return the number of lines of pieces, without comments, docstrings and blank lines."""
    lines: dict[str, set[int]] = {}
    for file, name in pieces:
        source = _file(file)
        whole = _lines(source.pieces[name])
        for _, method in _methods({(file, name)}):
            whole -= _lines(source.pieces[method])
        lines.setdefault(file, set()).update(whole & source.code)
    return sum(map(len, lines.values()))


def _lines(node: ast.stmt) -> set[int]:
    first = min(n.lineno for n in (node, *getattr(node, "decorator_list", ())))
    return set(range(first, (node.end_lineno or first) + 1))


class _File(NamedTuple):
    pieces: dict[str, ast.stmt]
    imported: dict[str, str]
    """What each imported name is, in full."""
    code: set[int]


@cache
def _file(name: str) -> _File:
    """Parse a module, given by its import name without the leading ``tresym.``."""
    path = _home().joinpath(*name.split("."))
    path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    pieces: dict[str, ast.stmt] = {}
    for node in tree.body:
        pieces |= dict.fromkeys(_given_by(node), node)
        if isinstance(node, ast.ClassDef):
            pieces |= {f"{node.name}.{m.name}": m for m in _functions(node)}
    imported: dict[str, str] = {}
    inside = [n for n in ast.walk(tree) if isinstance(n, ast.ImportFrom | ast.Expr)]
    for inner in inside:
        if isinstance(inner, ast.ImportFrom):
            imported |= {a.asname or a.name: f"{inner.module}.{a.name}" for a in inner.names}
    strings = (n.value for n in inside if isinstance(n, ast.Expr))
    notes = {
        line
        for n in strings
        if isinstance(n, ast.Constant) and isinstance(n.value, str)
        for line in range(n.lineno, (n.end_lineno or n.lineno) + 1)
    }
    rows = enumerate(map(str.strip, text.splitlines()), 1)
    code = {n for n, row in rows if row and not row.startswith("#")} - notes
    return _File(pieces, imported, code)


def _functions(owner: ast.AST) -> list[ast.FunctionDef]:
    """The methods of a class; none for other nodes."""
    body = owner.body if isinstance(owner, ast.ClassDef) else []
    return [node for node in body if isinstance(node, ast.FunctionDef)]


@cache
def _nodes(piece: ast.AST) -> tuple[ast.Name | ast.Attribute | ast.Call, ...]:
    """The names, attributes and calls in a piece; in a class without its methods."""
    methods, kinds = _functions(piece), (ast.Name, ast.Attribute, ast.Call)
    inner = (node for node in ast.iter_child_nodes(piece) if node not in methods)
    return tuple(node for part in inner for node in ast.walk(part) if isinstance(node, kinds))


def _given_by(node: ast.stmt) -> Iterator[str]:
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        yield node.name
    elif isinstance(node, ast.Assign | ast.AnnAssign):
        targets = node.targets if isinstance(node, ast.Assign) else [node.target]
        yield from (n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name))


@cache
def _named_in(file: str, name: str) -> tuple[Piece, ...]:
    """The pieces that a piece names."""
    found = (_piece(file, used) for used in _names(_file(file).pieces[name]))
    return tuple(dict.fromkeys(piece for piece in found if piece is not None))


def _piece(file: str, name: str) -> Piece | None:
    """The piece that a name, or ``module.name``, refers to in a module; None if it is not ours."""
    first, _, rest = name.partition(".")
    source = _file(file)
    if first in source.pieces:
        return file, first
    whole = source.imported.get(first, "")
    if not whole.startswith("tresym."):
        return None
    there, _, last = whole.removeprefix("tresym.").rpartition(".")
    if _is_file(f"{there}.{last}"):
        return _piece(f"{there}.{last}", rest) if rest else None
    return _piece(there, last)


@cache
def _names(node: ast.AST) -> frozenset[str]:
    """Every name in ``node``, and every ``name.attribute``."""
    attributes = (n for n in _nodes(node) if isinstance(n, ast.Attribute))
    return frozenset(n.id for n in _nodes(node) if isinstance(n, ast.Name)) | {
        f"{n.value.id}.{n.attr}" for n in attributes if isinstance(n.value, ast.Name)
    }


@cache
def _is_file(name: str) -> bool:
    path = _home().joinpath(*name.split("."))
    return path.with_suffix(".py").is_file() or (path / "__init__.py").is_file()


@cache
def _home() -> Path:
    return Path(tresym.__file__).resolve().parent
