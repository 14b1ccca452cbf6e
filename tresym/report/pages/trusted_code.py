"""Count the lines of code that verdicts depend on, by a call graph of the sources.

A *piece* is a function, method, class or constant. The roots are the functions that issue verdicts.
A piece is reached if a reached piece names it. A method is also reached if its class is reached and
a reached piece uses an attribute of that name, or if a method of its class or of a base of it looks
up attributes of ``self`` by computed names. Code that only searches, so that its results are
checked by counted code, is left out by name, each with a reason (:data:`RECHECKED`).

``python -m tresym.report.pages.trusted_code`` prints the count.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Collection, Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import flint

import tresym

LEDGER = ("ledger.judge.judge", "ledger.judge.judge_evidence")
"""The functions that issue verdicts on claims of the ledger."""
CHECK = ("checking.dispatch.decide_claim",)
"""The functions that issue verdicts on a user's claim."""
ROOTS = (*LEDGER, *CHECK)

ENCLOSING = (
    "reals.balls",
    "reals.decisions.inequalities_on_regions",
    "asymptotics.order_claims",
    "reals.expansions.leading_terms",
    *(
        "reals.expansions.truncated_series.Enclosure",
        "reals.expansions.truncated_series.Size",
    ),
    "reals.expansions.scale.Scale.written",
    *(
        f"reals.expansions.series_arithmetic.SeriesArithmetic.{name}"
        for name in ("enclosure", "_enclosed", "largest")
    ),
    *(
        f"reals.expansions.series_arithmetic.SeriesArithmetic._{name}"
        for name in ("height", "along_chain", "element")
    ),
    *(
        f"reals.expansions.series_arithmetic.SeriesArithmetic.{name}"
        for name in ("size", "_size", "_raised")
    ),
    *(
        f"reals.expansions.series_arithmetic.SeriesArithmetic._{name}"
        for name in ("times", "total", "term", "whole")
    ),
    "reals.expansions.series_arithmetic.SeriesArithmetic._bounded",
    *("reals.decisions.inequalities._apart", "reals.decisions.inequalities._one_period"),
    "reals.decisions.inequalities._shown_under",
    *("reals.decisions.integrals._by_quadrature", "asymptotics.path_claims._theta"),
    *(
        "ledger.evidence.box_bounds",
        "ledger.evidence.chart_bounds",
        "ledger.evidence.interval_evaluation",
    ),
    "ledger.evidence.printed_numbers",
    *(f"reals.domain.binder_values.{name}" for name in ("bracketed", "bracket", "value")),
    "ledger.evidence.allowed_evidence._other_meaning",
)
"""Packages, modules and functions on which no verdict PROVED depends."""

RECHECKED = {
    "it translates input into the text grammar; the text is shown, parsed again and decided": (
        *("reals.language.latex", "reals.language.latex_cursor", "reals.language.latex_grammar"),
        *("reals.language.latex_ambiguity", "reals.language.latex_author"),
        *("reals.language.latex_operands", "reals.language.latex_tokens"),
        *("reals.language.unicode_input", "reals.language.claims.as_written"),
        *("reals.language.expression._text", "reals.language.expression.Expr.__str__"),
        "reals.language.expression.Expr.__repr__",
    ),
    "the independent numerical check can withdraw a verdict but never gives one": (
        *("checking.claim_cross_check", "reals.cross_check", "ledger.judge._attacked"),
        "reals.decisions.definedness_check",
    ),
    "it proposes sample points; a point counts only after its conditions are verified there": (
        *("reals.domain.sample_points._sample", "reals.domain.sample_points.corners"),
        *(
            "reals.domain.narrow_regions",
            "reals.domain.local_search",
            "ledger.counterexamples.somewhere",
        ),
        *("reals.domain.conditions.Given._far", "reals.normal.locally_constant._middle"),
    ),
    "its result is checked: products multiplied out, subdivisions replayed, steps proved": (
        *("reals.normal.denesting", "reals.balls.branch_and_bound._found"),
        "reals.signs.transformations.equivalents",
        *("reals.signs.structural.Parts._ways", "reals.signs.structural.Parts._multiples"),
        *("reals.domain.binder_values._approximation", "reals.domain.binder_values._change"),
        "reals.decisions.antiderivatives",
        *(
            "ledger.evidence.printed_numbers._find_inputs",
            "ledger.evidence.printed_numbers._between",
        ),
        "ledger.evidence.chain._as_meant",
        *(f"reals.normal.powers.Powers.{n}" for n in ("_multiples", "_share")),
        "reals.normal.rational_basis.RationalBasis._solution",
        *("reals.normal.angles.Angles._signed_multiples", "reals.normal.constants._groups"),
    ),
    "it proposes a point or a split; where it lies and what holds there is verified": (
        *(
            "reals.signs.taylor._bases",
            "reals.language.solve",
            "reals.balls.simplest_constants.candidates",
        ),
        *("reals.normal.to_expression.numerator",),
        *("reals.decisions.integration_pieces._cuts", "reals.decisions.integration_pieces._roots"),
        *("reals.decisions.integration_pieces._turns", "reals.signs.polynomials._least"),
        "reals.numbers.exact.Interval.simplest",
    ),
    "it only skips a search that would fail, or estimates the cost of one": (
        "reals.normal.sign_proofs.SignProver._changes_sign",
        *("reals.decisions.identity._generator_count", "reals.signs.taylor._seen"),
    ),
    "it can only refute": (
        "checking.point_check",
        "asymptotics.refutation_check",
        "asymptotics.numerical_evidence",
        *(f"reals.expansions.leading_terms.{name}" for name in ("_fails_at_a_phase", "_phases")),
        "asymptotics.path_claims._at_integers",
        "reals.decisions.waves.differ",
        *("reals.decisions.identity._refutation", "reals.decisions.answer.refuted"),
        *("reals.signs.discontinuities.Case.point", "checking.dispatch._exact"),
        *("reals.decisions.inequalities._at_corners", "reals.decisions.inequalities._refuted_at"),
        *("reals.decisions.inequalities._in_cells", "reals.decisions.algebraic_witnesses"),
        *("reals.decisions.inequalities._zero_between", "ledger.refutations.refute"),
        "ledger.evidence.refutation",
        "ledger.evidence.deductions._refuted",
        *("ledger.evidence.asymptotics._expanded", "ledger.refutations.refuted_part"),
        "ledger.judged_roots._refuted_slope",
        *("reals.decisions.equations._with_value", "reals.decisions.algebraic_witnesses"),
        *(
            "asymptotics.path_claims._fails_beside",
            "asymptotics.periodic_counterexamples.failure_where_waves_return",
        ),
        *(
            "reals.decisions.unknown_functions._realised",
            "reals.decisions.readable_witnesses.exact_witness",
        ),
    ),
    "it records the place and kind of a claim, and the expected verdict": (
        *(f"ledger.claim.{name}" for name in ("Place", "display", "line", "Fault", "_kind")),
        *("ledger.claim._expected", "ledger.claim.AllOf.expect", "ledger.claim.asked_by"),
    ),
    "it prints an answer": (
        *("reals.decisions.answer.Answer.rows", "reals.decisions.answer.Answer.__str__"),
        *("reals.decisions.answer.ball_text", "reals.signs.discontinuities.Case.__str__"),
        "reals.decisions.identity._counted",
    ),
    "it writes error messages": (
        "ledger.definitions._where",
        *("reals.language.suggestions", "reals.decisions.identity.no_point"),
        *("reals.decisions.identity._obstacle", "checking.dispatch._mistaken"),
    ),
}
"""Packages, modules and pieces that are left out of the count, by the reason."""

Piece = tuple[str, str]


class Count(NamedTuple):
    """Lines of code by module, and the names of libraries that this code calls."""

    lines: dict[str, int]
    flint: tuple[str, ...]
    sympy: tuple[str, ...]

    @property
    def total(self) -> int:
        """The sum over all modules."""
        return sum(self.lines.values())


@cache
def trusted(roots: Collection[str] = ROOTS) -> tuple[Count, Count]:
    """Count the code that verdicts depend on.

    Args:
        roots: full names of the functions that issue verdicts, without the leading ``tresym.``.

    Returns:
        What must be correct for PROVED, and what must be correct in addition for ENCLOSED.
    """
    found = {name for names in RECHECKED.values() for name in names}
    proving = reached({*found, *ENCLOSING}, roots)
    return counted(proving), counted(reached(found, roots) - proving)


def reached(without: Collection[str], roots: Collection[str] = ROOTS) -> set[Piece]:
    """Return all pieces that can be reached from ``roots`` without passing through ``without``."""
    seen: set[Piece] = set()
    found: set[Piece] = set()
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
            if not any(_within(".".join(piece), name) for name in without):
                found.add(piece)
                waiting += _named_in(*piece)
                attributes |= _attributes(*piece)
        picking = {(file, name.rpartition(".")[0]) for file, name in found if _picks(file, name)}
        picking |= {piece for piece in found if not picking.isdisjoint(_bases(*piece))}
        named = {m for m in _methods(found) if _is_meant(m[1], attributes)}
        waiting = [*({*_methods(picking), *named} - seen)]
    return found


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


def counted(pieces: Collection[Piece]) -> Count:
    """Count lines without comments, docstrings and blank lines; collect the library names used."""
    lines: dict[str, set[int]] = {}
    flint_names: set[str] = set()
    sympy_names: set[str] = set()
    for file, name in pieces:
        source = _file(file)
        node = source.pieces[name]
        whole = _lines(node)
        for _, method in _methods({(file, name)}):
            whole -= _lines(source.pieces[method])
        lines.setdefault(file, set()).update(whole & source.code)
        flint_names |= _flint_names(node, source)
        sympy_names |= {n for n in _names(node) if source.imported.get(n, "").startswith("sympy.")}
    per_file = {file: len(found) for file, found in sorted(lines.items())}
    return Count(per_file, tuple(sorted(flint_names)), tuple(sorted(sympy_names)))


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


def _flint_names(node: ast.stmt, source: _File) -> set[str]:
    """Types of python-flint that are named, and attributes that are methods of such types."""
    types = {n for n in _names(node) if source.imported.get(n, "").startswith("flint.")}
    methods = {n.attr for n in _nodes(node) if isinstance(n, ast.Attribute)}
    return types | {f".{name}" for name in methods & _flint_methods()}


@cache
def _flint_methods() -> frozenset[str]:
    """Public methods of python-flint's types, except those that Python's own types have too."""
    types = [t for t in vars(flint).values() if isinstance(t, type)]
    own = {name for t in (str, dict, list, set, tuple, int, Counter) for name in dir(t)}
    return frozenset(n for t in types for n in dir(t) if not n.startswith("_")) - own


def _within(name: str, whole: str) -> bool:
    """Whether a piece is ``whole`` or part of it."""
    return name == whole or name.startswith(f"{whole}.")


@cache
def _is_file(name: str) -> bool:
    path = _home().joinpath(*name.split("."))
    return path.with_suffix(".py").is_file() or (path / "__init__.py").is_file()


@cache
def _home() -> Path:
    return Path(tresym.__file__).resolve().parent


def main() -> None:
    """Print the count, module by module."""
    for whose, roots in (("the ledger", LEDGER), ("check", CHECK)):
        proved, enclosed = trusted(roots)
        print(f"{proved.total:5} PROVED, {enclosed.total} additional for ENCLOSED: {whose} alone")
    for verdict, count in zip(("PROVED", "ENCLOSED, additional"), trusted(), strict=True):
        print(f"{count.total:5} {verdict}")
        for file, lines in sorted(count.lines.items(), key=lambda item: -item[1]):
            print(f"{lines:5}   {file}")


if __name__ == "__main__":
    main()
