"""Check that a claim says what its display says: read the LaTeX, and compare in balls.

A display consists of chains of relations. Every link of every chain must agree with a relation of a
claim on this display: both sides are compared in ball arithmetic at exact points that satisfy the
claim's conditions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import product, zip_longest
from typing import Any

from tresym.ledger.audit.tree_comparison import of_claim, of_display, same
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.formulas import EqualMatrices, Rounded, in_trees
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, ordered
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.compound import Equivalent, Together
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import MIRRORED, Relation
from tresym.reals.language.latex import Relations, read_latex
from tresym.reals.language.latex_author import Author, Function
from tresym.reals.language.parsing import as_written, parse_claim
from tresym.reals.numbers.exact import InputError, printed


@dataclass(frozen=True)
class Reading:
    """How a display is interpreted; stored in the index beside its hash.

    Attributes:
        reads: replacements for notation that the claims write differently, as text of the
            expression grammar.
        functions: functions defined in the paper's sentences: ``f(s)`` and its value.
        variable: the variable of an evaluation bracket with limits.
        sentence: why no claim can state the display as it is printed; empty if one can.
        again: a second transcription of such a display, made independently of the claims, in the
            expression grammar.
    """

    reads: Mapping[str, str] = field(default_factory=dict)
    functions: Mapping[str, str] = field(default_factory=dict)
    variable: str = ""
    sentence: str = ""
    again: tuple[str, ...] = ()

    @property
    def otherwise(self) -> str:
        """The differences between the interpretation and the printed display, in words."""
        pairs = {**self.functions, **self.reads}.items()
        return ", ".join(f"{name} read as {meant}" for name, meant in pairs)

    def author(self, functions: Mapping[str, Function]) -> Author:
        """The author's functions as they are used in other displays."""
        own = {}
        for head, value in self.functions.items():
            name, _, parameters = head.rstrip(")").partition("(")
            own[name] = Function(tuple(parameters.split(", ")), as_written(value))
        return Author({**functions, **own}, self.variable)


@dataclass(frozen=True)
class Link:
    """Two neighbouring expressions of a chain.

    Attributes:
        digits: the digits of the right side, if it is a decimal.
        defines: whether the left side is a function at its parameters.
        under: the conditions that the display states for the link.
    """

    left: Expr
    op: str
    right: Expr
    digits: str = ""
    defines: bool = False
    under: frozenset[tuple[Expr, str, Expr]] = frozenset()

    def __str__(self) -> str:
        return f"{self.left} {self.op} {self.digits or self.right}"


def functions_of(displays: Iterable[str]) -> dict[str, Function]:
    """Return the functions of several arguments that the paper defines, ``f(a, b) = …``."""
    found: dict[str, Function] = {}
    for text in displays:
        try:
            chains = read_latex(text, Author(found))
        except InputError:
            continue
        for chain in chains:
            if chain.defines and chain.ops[0] == "==":
                name, parameters = chain.defines
                if name not in symbols(chain.terms[1]):
                    found.setdefault(name, Function(parameters, chain.terms[1]))
    return found


def unmet(
    chains: Iterable[Relations],
    claims: Iterable[Claim],
    functions: Mapping[str, Function],
    reads: Mapping[str, str] | None = None,
) -> list[Link]:
    """Return the links of a display that no claim on it states, in order."""
    statements = [statement for claim in claims for statement in _statements(claim)]
    otherwise = {as_written(name): as_written(meant) for name, meant in (reads or {}).items()}
    ways = [*product([{}, otherwise] if otherwise else [{}], [None, functions])]
    left = []
    for link in (link for chain in chains for link in _links(chain)):
        seen = dict.fromkeys(
            (of_display(link.left, *way), of_display(link.right, *way)) for way in ways
        )
        if not any(_says(statement, link, *sides) for statement in statements for sides in seen):
            left.append(link)
    return left


def differing(chains: Iterable[Relations], again: Iterable[str]) -> str | None:
    """Return the first relation in which a display and its second transcription differ, or None."""
    links = [link for chain in chains for link in _links(chain)]
    twice = [relation for text in again for relation in parse_claim(text)]
    for link, second in zip_longest(links, twice):
        if link is None or second is None:
            return str(link or " ".join(map(str, second)))
        left, op, right = second
        pairs = ((link.left, left), (link.right, right))
        if link.op != op or not all(same(p, q, Given()) for p, q in pairs):
            return str(link)
    return None


def _links(chain: Relations) -> list[Link]:
    """Yield the links; a bound by infinity is skipped, and f(…) = body is a definition."""
    digits = chain.printed[1:] or ("",) * len(chain.ops)
    under = frozenset(chain.condition.links if chain.condition else ())
    links = [
        Link(*link, number, bool(chain.defines), under)
        for link, number in zip(chain.links, digits, strict=True)
        if not {INFINITY, -INFINITY} & {link[0], link[2]}
    ]
    return links[1:] if chain.defines and len(links) > 1 else links


@dataclass
class _Statement:
    """What a claim states: its relations as trees, and its printed numbers."""

    given: Given
    relations: list[tuple[Expr, str, Expr]]
    numbers: list[str]


def _statements(claim: Claim) -> Iterator[_Statement]:
    """Yield the claim's relations with its conditions; parts of a conjunction have their own."""
    says: list[Any] = [claim.says]
    numbers: list[str] = []
    whole = claim.statement
    if isinstance(whole, Rounded):
        numbers = [whole.text]
    if isinstance(claim.says, str):
        says = [claim.means] if isinstance(claim.proof, Decided) else []
    if isinstance(claim.proof, AllOf):
        for part in claim.proof.claims:
            yield from _statements(part)
    trees = [
        (of_claim(left), sign, of_claim(right))
        for statement in says
        for left, sign, right in _relations(in_trees(statement))
    ]
    yield _Statement(_conditions(claim), trees, numbers)


def _conditions(claim: Claim) -> Given:
    """Return the claim's conditions that are comparisons of elementary expressions."""
    given = Given()
    for condition in claim.given:
        for relation in _relations(in_trees(condition)):
            if relation.sign != "==" and elementary(relation.left, relation.right):
                given = given & Given((relation,))
    return given


def _relations(says: Any) -> Iterator[Relation]:
    """Yield the relations in a conjunction or an equivalence, those of the entries of matrices."""
    if isinstance(says, Relation):
        yield says
    elif isinstance(says, EqualMatrices):
        yield from says.entries
    elif isinstance(says, Together | Equivalent):
        for part in says.parts:
            yield from _relations(part)


def _says(statement: _Statement, link: Link, left: Expr, right: Expr) -> bool:
    """Return whether a claim states the link."""
    if link.digits and any(printed(link.digits) == printed(n) for n in statement.numbers):
        return True
    given, relations = statement.given, statement.relations
    under = {(ordered(x), sign, ordered(y)) for x, sign, y in link.under}
    if not under <= {(ordered(x), sign, ordered(y)) for x, sign, y in given.comparisons}:
        return False
    if link.defines and left == right:
        # The display defines a function: the claim must say its value somewhere.
        return any(same(right, side, given) for p, _, q in relations for side in (p, q))
    for p, op, q in relations:
        if op == link.op and same(left, p, given) and same(right, q, given):
            return True
        if MIRRORED[op] == link.op and same(left, q, given) and same(right, p, given):
            return True
    return False
