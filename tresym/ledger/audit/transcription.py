"""Is a claim what the paper's display says? Read from the LaTeX and compared in balls.

A display is a few chains of relations. Every link of every chain must be met by a relation that a
claim on this display says, side by side, at exact points that satisfy the claim's conditions.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from itertools import zip_longest
from typing import Any

from tresym.ledger.audit.terms import Function, Terms
from tresym.ledger.claim import AllOf, Claim, Formally, Printed
from tresym.reals.language.expression import Expr
from tresym.reals.language.latex import Relations
from tresym.reals.language.latex_tokens import CALLS
from tresym.reals.numbers.exact import InputError, printed
from tresym.reals.places.conditions import Given

_DECIMAL = re.compile(r"-?\d+(\.\d+)?(e-?\d+)?")
_DEFINED = re.compile(r"([A-Za-z]\w*)\(([\w, ]+)\)")
_SWAPPED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "=": "=", "!=": "!="}


@dataclass(frozen=True)
class Reading:
    """How a display is to be read, kept in the index beside its hash.

    Attributes:
        reads: names that the claims write otherwise, as text of the expression grammar.
        variable: of a bracket with limits.
        sentence: why no claim can say the display as it stands, if so.
        again: a second transcription of such a display, made apart from the claims: relations as
            text, each with spaces around its sign.
    """

    reads: Mapping[str, str] = field(default_factory=dict)
    variable: str = ""
    sentence: str = ""
    again: tuple[str, ...] = ()

    @property
    def otherwise(self) -> str:
        """What is read otherwise than it is printed, in words."""
        return ", ".join(f"{name} read as {meant}" for name, meant in self.reads.items())


@dataclass(frozen=True)
class Link:
    """Two neighbours of a chain."""

    left: str
    op: str
    right: str

    def __str__(self) -> str:
        return f"{self.left} {self.op} {self.right}"


def functions_of(readings: Iterable[tuple[Relations, ...]]) -> dict[str, Function]:
    """The functions of several arguments that the paper defines, ``f(a, b) = …``."""
    found: dict[str, Function] = {}
    for chains in readings:
        for chain in chains:
            defined = _DEFINED.fullmatch(chain.terms[0])
            if defined and "," in defined[2] and chain.ops[0] == "=":
                if defined[1] in CALLS or f"{defined[1]}(" in chain.terms[1]:
                    continue
                parameters = tuple(p.strip().rstrip("_") for p in defined[2].split(","))
                found.setdefault(defined[1], Function(parameters, chain.terms[1]))
    return found


def unmet(
    chains: Iterable[Relations],
    claims: Iterable[Claim],
    functions: Mapping[str, Function],
    reading: Reading,
) -> list[Link]:
    """The links of a display that no claim on it says, in order; empty when all are met."""
    blank = Terms(functions, variable=reading.variable)
    ways = [blank, replace(blank, reads=reading.reads)] if reading.reads else [blank]
    statements = [s for way in ways for claim in claims for s in _statements(claim, way)]
    return [link for chain in chains for link in _links(chain) if not _is_met(link, statements)]


def differing(chains: Iterable[Relations], again: Iterable[str]) -> str | None:
    """The first relation in which a display and its second transcription differ, or None."""
    links = [link for chain in chains for link in _links(chain)]
    twice = [tuple(text.split(" ", 2)) for text in again]
    terms = Terms()
    for link, second in zip_longest(links, twice):
        if link is None or second is None or len(second) != 3 or link.op != second[1]:
            return " ".join(second) if link is None else str(link)
        pairs = ((link.left, second[0]), (link.right, second[2]))
        if not all(terms.same(terms.from_text(p), terms.from_text(q)) for p, q in pairs):
            return str(link)
    return None


def _links(chain: Relations) -> list[Link]:
    """Neighbours; a bound by infinity says nothing, and f(…) = body defines."""
    pairs = zip(chain.terms, chain.ops, chain.terms[1:], strict=False)
    links = [Link(p, op, q) for p, op, q in pairs if "inf" not in (p, q, q.lstrip("-"))]
    defined = _DEFINED.fullmatch(chain.terms[0])
    if defined and "," in defined[2] and len(links) > 1:
        return links[1:]
    return links


@dataclass
class _Statement:
    """What one claim says: its relations as trees, its printed numbers."""

    terms: Terms
    relations: list[tuple[Expr, str, Expr]]
    numbers: list[str]


def _statements(claim: Claim, blank: Terms) -> list[_Statement]:
    """The claim's relations under its own conditions; a conjunction's parts under theirs."""
    terms = replace(blank, given=_conditions(claim), stands=[])
    relations = [_tree(terms, r) for r in _relations(claim.says)]
    numbers: list[str] = []
    parts: list[_Statement] = []
    if isinstance(claim.says, str):
        match claim.proof:
            case Formally(relations=said):
                relations = [_tree(terms, r) for s in said for r in _relations(s)]
            case Printed(text=text):
                numbers = [text]
            case AllOf(claims):
                parts = [s for part in claims for s in _statements(part, blank)]
    elif isinstance(claim.proof, Printed):
        numbers = [claim.proof.text]
    own = [_Statement(terms, [r for r in relations if r is not None], numbers)]
    return own + parts


def _conditions(claim: Claim) -> Given:
    """The claim's conditions, as far as they are comparisons of elementary expressions."""
    given = Given()
    for condition in claim.given:
        try:
            given = given & Given.from_sympy(condition)
        except InputError:
            continue
    return given


def _relations(says: Any) -> list[Any]:
    """The SymPy relations in a statement: of a tuple, a conjunction, an equivalence."""
    from sympy import And, Equivalent, MatrixBase, Tuple
    from sympy.core.relational import Relational

    if isinstance(says, Relational):
        if isinstance(says.lhs, MatrixBase):
            pairs = zip(says.lhs, says.rhs, strict=True)
            return [says.func(p, q, evaluate=False) for p, q in pairs]
        return [says]
    if isinstance(says, Tuple | And | Equivalent):
        return [r for part in says.args for r in _relations(part)]
    return []


def _tree(terms: Terms, relation: Any) -> tuple[Expr, str, Expr] | None:
    op = "=" if relation.rel_op == "==" else relation.rel_op
    try:
        return terms.from_sympy(relation.lhs), op, terms.from_sympy(relation.rhs)
    except InputError:
        return None


def _is_met(link: Link, statements: list[_Statement]) -> bool:
    return any(_says(statement, link) for statement in statements)


def _says(statement: _Statement, link: Link) -> bool:
    if _DECIMAL.fullmatch(link.right) and any(
        printed(link.right) == printed(number) for number in statement.numbers
    ):
        return True
    terms = statement.terms
    try:
        left, right = terms.from_text(link.left), terms.from_text(link.right)
    except InputError:
        return False
    if _DEFINED.fullmatch(link.left) and left == right:
        # The display defines a function: the claim must say its value somewhere.
        return any(terms.same(right, side) for p, _, q in statement.relations for side in (p, q))
    for p, op, q in statement.relations:
        if op == link.op and terms.same(left, p) and terms.same(right, q):
            return True
        if _SWAPPED.get(op) == link.op and terms.same(left, q) and terms.same(right, p):
            return True
    return False
