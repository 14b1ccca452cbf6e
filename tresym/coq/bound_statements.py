"""Print claims about integrals, sums and limits as theorems of Coq: statements, not proofs.

An integral is ``is_RInt`` (``is_RInt_gen`` where an end is infinite, or the integrand is not
defined at an end), a sum is ``terms`` of ``Bound.v``, a series the limit of these, a limit
``filterlim``. What makes the parts defined is part of the conclusion, except for conditions on
parameters alone, which are premises. Integer variables are natural numbers.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from flint import fmpq

from tresym.coq.statement import ATOM, NotExportedError, comparison, condition, term, variable
from tresym.coq.theorem_trees import inside
from tresym.reals.decisions.statement import Statement, implied_integers
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    fresh,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path

MINUS_INFINITY = -INFINITY
AND = " /\\ "


class Bounded(NamedTuple):
    """That an order holds with a constant where |x - a|, or 1/|x|, is at most ``reach``.

    Attributes:
        constant: the constant, a rational number.
        reach: None for all x > 0, or x < 0.
        region: the region as the answer says it.
    """

    constant: Expr
    reach: fmpq | None
    region: str


@dataclass(frozen=True)
class BoundTheorem:
    """A theorem about integrals, sums or a limit.

    Attributes:
        claim: the comparison.
        statement: the claim with its conditions.
        naturals: the variables that are natural numbers.
        premises: the conditions as Coq text.
        says: the conclusions as Coq text.
        bounded: for an order with a constant on a region, these.
    """

    name: str
    claim: Comparison
    statement: Statement
    reals: tuple[str, ...]
    naturals: tuple[str, ...]
    premises: tuple[str, ...]
    says: tuple[str, ...]
    bounded: Bounded | None = None

    @property
    def body(self) -> str:
        """The proposition as Coq text."""
        kinds = ((self.reals, "R"), (self.naturals, "nat"))
        lines = [f"  forall {' '.join(map(variable, n))} : {kind}," for n, kind in kinds if n]
        lines += [f"  {premise} ->" for premise in self.premises]
        return "\n".join([*lines, "  " + " /\\\n  ".join(f"({part})" for part in self.says)])

    @property
    def text(self) -> str:
        """The statement as a sentence of Coq."""
        return f"Theorem {self.name} :\n{self.body}."


def bound_theorem(claim: Comparison, statement: Statement, name: str) -> BoundTheorem:
    """Return the theorem for a comparison of integrals or sums, or for a limit.

    Raises:
        NotExportedError: this kind of claim cannot be exported yet.
    """
    if claim.derivatives:
        raise NotExportedError("derivatives of integrals, sums and limits are not exported to Coq")
    nodes = [*dict.fromkeys(outermost(claim.left, claim.right))]
    for node in nodes:
        if node.op not in ("integral", "sum"):
            what = "factorials and unknown functions" if node.op == "unknown" else node.op
            if node.op != "unknown" or node.args[0].args[0] != FACTORIAL:
                raise NotExportedError(f"{what} cannot be exported to Coq yet")
    if statement.path is None and all(node.op == "unknown" for node in nodes):
        raise NotExportedError("factorials outside of sums cannot be exported to Coq yet")
    conditions = statement.given.comparisons
    sides = [e for x, _, y in conditions for e in (x, y)]
    implied = implied_integers([claim.left, claim.right, *sides], statement.integers)
    whole = {name for name in implied if name in symbols(claim.left) | symbols(claim.right)}
    path = statement.path
    if path is not None and _alternates(claim, path.name):
        whole.add(path.name)
    if path is not None and whole - {path.name}:
        raise NotExportedError("limits with integers as parameters cannot be exported to Coq yet")
    if path is not None and (path.expression is not None or path.together):
        raise NotExportedError(
            "a path of an expression or of several variables cannot be exported to Coq yet"
        )
    if path is not None and (path.reach is not None or path.region):
        raise NotExportedError("the constant of an order on a region cannot be exported to Coq yet")
    if statement.uniformly:
        raise NotExportedError("one constant for all parameters cannot be exported to Coq yet")
    says = _along(claim, path, whole) if path is not None else _related(claim, frozenset(whole))
    other = [e for e in (claim.left, claim.right) if path is None or path.name not in symbols(e)]
    names = {node: ZERO for node in nodes if node.op != "unknown"}
    other = [replaced(e, names) for e in other if e not in (INFINITY, MINUS_INFINITY)]
    if path is not None and path.point is not None:
        other.append(path.point)
    if path is not None and any(path.name in symbols(e) for e in sides):
        raise NotExportedError("conditions on the variable of the path cannot be exported to Coq")
    parts = needs([naturally(e, whole) for e in (*other, *sides)])
    premises = [
        comparison(naturally(x, whole), sign, naturally(y, whole)) for x, sign, y in conditions
    ]
    premises += [condition(*p) for p in parts if symbols(p[0]) and not symbols(p[0]) & whole]
    premises += [p for node in nodes if node.op == "sum" for p in _counted(node, frozenset(whole))]
    used = symbols(claim.left) | symbols(claim.right) | frozenset().union(*map(symbols, sides))
    used |= symbols(path.point) if path is not None and path.point is not None else frozenset()
    bound = {path.name} if path is not None else set()
    reals = used - whole - {"oo"} - bound
    return BoundTheorem(
        name,
        claim,
        statement,
        tuple(sorted(reals)),
        tuple(sorted(whole - bound)),
        tuple(dict.fromkeys(premises)),
        tuple(says),
    )


def naturally(e: Expr, whole: Iterable[str]) -> Expr:
    """Return ``e`` with marks at what is a natural number or a power with such an exponent."""
    names = frozenset(whole)
    if e.op == "symbol" and e.args[0] in names:
        return Expr("natural", (e,))
    if e.op in LEAVES or not names:
        return e
    if e.op == "unknown" and e.args[0].args[0] == FACTORIAL:
        return Expr("factorial", (e.args[1],))
    if e.op == "^" and symbols(e.args[1]) and symbols(e.args[1]) <= names:
        up, down = natural_parts(e.args[1])
        base = naturally(e.args[0], names)
        powers = [Expr("power", (base, up))] if up != ZERO else []
        powers += [Expr("^", (Expr("power", (base, down)), number(-1)))] if down != ZERO else []
        return powers[0] if len(powers) == 1 else Expr("*", tuple(powers))
    return Expr(e.op, tuple(naturally(arg, names) for arg in e.args), e.names)


def natural_parts(e: Expr) -> tuple[Expr, Expr]:
    """Return natural numbers whose difference is the whole linear expression ``e``."""
    up, down = ZERO, ZERO
    for name in (*sorted(symbols(e)), None):
        zero = dict.fromkeys(symbols(e), ZERO)
        slope = substitute(e, zero) if name is None else differentiate(e, name)
        if slope.op != "number" or slope.args[0].q != 1:
            raise NotExportedError("an exponent that is not linear cannot be exported to Coq yet")
        size = slope if slope.args[0] >= 0 else -slope
        part = size if name is None else size * symbol(name)
        up, down = (up + part, down) if slope.args[0] >= 0 else (up, down + part)
    return up, down


def count_of(node: Expr) -> Expr:
    """Return how many terms a sum has."""
    return node.args[2] - node.args[1] + ONE


def _counted(node: Expr, whole: frozenset[str]) -> list[str]:
    """Return the condition that a sum has no negative number of terms, where that is not plain."""
    if node.args[2] == INFINITY:
        return []
    up, down = natural_parts(count_of(node))
    return (
        [f"(({term(Expr('count', (down,)))} <= {term(Expr('count', (up,)))})%nat)"]
        if down != ZERO
        else []
    )


def _sum(node: Expr, whole: frozenset[str]) -> tuple[str, list[str]]:
    """Return the sum as text, of ``n`` terms if it is infinite, and that its terms are defined."""
    (k,), body = inside(node)
    if not elementary(*(e for e in outermost(body) if e.op != "unknown")):
        raise NotExportedError("a sum or an integral within a sum cannot be exported to Coq yet")
    low, high = node.args[1:]
    if low.op != "number" or low.args[0].q != 1 or low.args[0] < 0:
        raise NotExportedError("a sum must begin at a natural number to be exported to Coq")
    names = whole | {k}
    if high == INFINITY:
        count = "n"
    else:
        up, down = natural_parts(count_of(node))
        up_text, down_text = (term(Expr("count", (e,)), ATOM) for e in (up, down))
        count = up_text if down == ZERO else f"({up_text} - {down_text})"
    body = naturally(body, names)
    parts = [p for p in needs([body]) if k in symbols(p[0])]
    said = []
    if parts:
        held = AND.join(condition(*p) for p in parts)
        upper = "" if high == INFINITY else f" -> ({variable(k)} < {low} + {count})%nat"
        said = [f"forall {variable(k)} : nat, ({low} <= {variable(k)})%nat{upper} -> {held}"]
    return f"terms (fun {variable(k)} : nat => {term(body)}) {low} {count}", said


def _related(claim: Comparison, whole: frozenset[str]) -> list[str]:
    """Return a comparison of integrals and sums, and that what is under them is defined."""
    said: list[str] = []
    values: dict[Expr, Expr] = {}
    exists: list[str] = []
    taken = symbols(claim.left) | symbols(claim.right)
    nodes = [e for e in dict.fromkeys(outermost(claim.left, claim.right)) if e.op != "unknown"]
    for n, node in enumerate(nodes, 1):
        alone = claim.relation == "==" and len(nodes) == 1
        side = {claim.left: claim.right, claim.right: claim.left}.get(node) if alone else None
        name = symbol(fresh(f"value{n}", taken))
        value = term(name if side is None else naturally(side, whole), ATOM)
        if node.op == "sum":
            text, parts = _sum(node, whole)
            infinite = node.args[2] == INFINITY
            now = (
                f"is_lim_seq (fun n : nat => {text}) (Finite {value})"
                if infinite
                else f"{text} = {value}"
            )
        else:
            now, parts = _integral(node, value)
        said += parts
        exists.append(now)
        values[node] = name if side is None else node
    if len(nodes) == 1 and values[nodes[0]] == nodes[0]:
        return [*said, *exists]
    left, right = (naturally(replaced(e, values), whole) for e in (claim.left, claim.right))
    names = " ".join(term(name) for name in values.values())
    return [
        *said,
        f"exists {names} : R, " + " /\\ ".join([*exists, comparison(left, claim.relation, right)]),
    ]


def is_open_at(body: Expr, name: str, end: Expr) -> bool:
    """Return whether the integrand is not defined at the end."""
    for part, sign in needs([body]):
        at_end = substitute(part, {name: end})
        if sign != ">=" and at_end.op == "number" and at_end.args[0] == 0:
            return True
        if sign != ">=" and not symbols(at_end) and evaluate(at_end, {}).contains(0):
            return True
    return False


def ends_of(node: Expr) -> tuple[bool, bool]:
    """Return whether the integral is improper at its lower and at its upper end."""
    (x,), body = inside(node)
    low, high = node.args[1:]
    opened = [end in (INFINITY, MINUS_INFINITY) or is_open_at(body, x, end) for end in (low, high)]
    return opened[0], opened[1]


def _integral(node: Expr, value: str) -> tuple[str, list[str]]:
    """Return that the integral has the value, and that its integrand is defined inside."""
    (x,), body = inside(node)
    if not elementary(body):
        raise NotExportedError("an integral within an integral cannot be exported to Coq yet")
    low, high = node.args[1:]
    v, function = variable(x), f"(fun {variable(x)} : R => {term(body)})"
    parts = [condition(*p) for p in needs([body]) if x in symbols(p[0])]
    ends = ends_of(node)
    if not any(ends):
        a, b = term(low, ATOM), term(high, ATOM)
        region = f"Rmin {a} {b} < {v} < Rmax {a} {b}"
        text = f"is_RInt {function} {a} {b} {value}"
    else:
        if low == INFINITY or high == MINUS_INFINITY or not _in_order(low, high):
            raise NotExportedError("the ends of an improper integral must be in order")
        filters = _filter(low, ends[0], 1), _filter(high, ends[1], -1)
        text = f"is_RInt_gen {function} {filters[0]} {filters[1]} {value}"
        bounds = [] if low == MINUS_INFINITY else [f"{term(low)} < {v}"]
        bounds += [] if high == INFINITY else [f"{v} < {term(high)}"]
        region = " -> ".join(bounds)
    arrow = f"{region} -> " if region else ""
    return text, [f"forall {v} : R, {arrow}{AND.join(parts)}"] if parts else []


def _in_order(low: Expr, high: Expr) -> bool:
    if low == MINUS_INFINITY or high == INFINITY:
        return True
    gap = high - low
    return not symbols(gap) and bool(evaluate(gap, {}) > 0)


def _filter(end: Expr, is_open: bool, side: int) -> str:
    if end in (INFINITY, MINUS_INFINITY):
        return f"(Rbar_locally {'p' if end == INFINITY else 'm'}_infty)"
    kind = "at_point" if not is_open else "at_right" if side > 0 else "at_left"
    return f"({kind} {term(end, ATOM)})"


def filter_of(path: Path) -> str:
    """Return the filter of a path as Coq text."""
    if path.point is None:
        return f"(Rbar_locally {'p' if path.sides[0] > 0 else 'm'}_infty)"
    kind = "locally'" if len(path.sides) > 1 else "at_right" if path.sides[0] > 0 else "at_left"
    return f"({kind} {term(path.point, ATOM)})"


def extended(e: Expr) -> str:
    """Return a limit as a number of ``Rbar``."""
    infinite = {INFINITY: "p_infty", MINUS_INFINITY: "m_infty"}
    return infinite.get(e) or f"(Finite {term(e, ATOM)})"


ORDERS = {
    "O": ("exists C : R, ", "Rabs ({f}) <= C * Rabs ({g})"),
    "o": ("forall eps : R, 0 < eps -> ", "Rabs ({f}) <= eps * Rabs ({g})"),
    "~": ("forall eps : R, 0 < eps -> ", "Rabs ({f} - ({g})) <= eps * Rabs ({g})"),
    "Theta": (
        "exists c C : R, 0 < c /\\ ",
        "c * Rabs ({g}) <= Rabs ({f}) /\\ Rabs ({f}) <= C * Rabs ({g})",
    ),
    "omega": ("forall C : R, ", "C * Rabs ({g}) < Rabs ({f})"),
}
"""What an order says: for which constants, and the inequality near the end of the path."""


def whole_filter(path: Path, whole: Iterable[str]) -> tuple[str, str]:
    """Return the filter of a path, and the kind of its variable; sequences have natural numbers."""
    if path.name not in whole:
        return filter_of(path), "R"
    if path.point is not None or path.sides[0] < 0:
        raise NotExportedError("a sequence must tend to infinity to be exported to Coq")
    return "eventually", "nat"


def _alternates(claim: Comparison, name: str) -> bool:
    """Return whether a power is real only where the variable is an integer, such as (-1)**n."""
    return any(
        e.op == "^"
        and e.args[0].op == "number"
        and e.args[0].args[0] < 0
        and name in symbols(e.args[1])
        for e in _nodes([claim.left, claim.right])
    )


def _nodes(expressions: Iterable[Expr]) -> Iterator[Expr]:
    """Yield all parts of expressions."""
    for e in expressions:
        yield e
        if e.op not in LEAVES:
            yield from _nodes(arg for arg in e.args if isinstance(arg, Expr))


def sums_in(e: Expr) -> list[Expr]:
    """Return the sums in an expression, each once."""
    return [node for node in dict.fromkeys(outermost(e)) if node.op == "sum"]


def sides_of(theorem: BoundTheorem) -> tuple[str, str]:
    """Return the two sides of an order of sequences as Coq text."""
    whole = {theorem.statement.path.name} if theorem.statement.path is not None else set()
    sides = theorem.claim.left, theorem.claim.right
    nodes = [node for node in dict.fromkeys(outermost(*sides)) if node.op != "unknown"]
    numbers = {node: symbol(fresh(f"sum{i}", symbols(sides[0]))) for i, node in enumerate(nodes)}
    left, right = (
        _with_sums(term(naturally(replaced(e, numbers), whole)), numbers, whole) for e in sides
    )
    return left, right


def _with_sums(text: str, numbers: Mapping[Expr, Expr], whole: Iterable[str]) -> str:
    """Return Coq text with sums in the place of their names."""
    for node, name in numbers.items():
        shown = f"({_sum(node, frozenset(whole))[0]})"
        text = re.sub(rf"\b{re.escape(term(name))}\b", lambda _, s=shown: s, text)  # type: ignore[misc]
    return text


def _counted_from(node: Expr, name: str, whole: Iterable[str]) -> list[str]:
    """Return that the terms of a sum up to the variable of a path are defined.

    Raises:
        NotExportedError: it is another sum, or an integral.
    """
    if node.op != "sum" or name not in whole or node.args[2] != symbol(name):
        raise NotExportedError(
            "a limit of integrals or sums of this kind is not exported to Coq yet"
        )
    (k,), body = inside(node)
    if name in symbols(body) or node.args[1] not in (ZERO, ONE):
        raise NotExportedError("a limit of such sums is not exported to Coq yet")
    _sum(node, frozenset(whole))
    parts = [condition(*p) for p in needs([naturally(body, {*whole, k})]) if k in symbols(p[0])]
    low = f"({node.args[1]} <= {variable(k)})%nat"
    return [f"forall {variable(k)} : nat, {low} -> {AND.join(parts)}"] if parts else []


def _along(claim: Comparison, path: Path, whole: Iterable[str]) -> list[str]:
    """Return a limit or an order, and that both sides are defined near the end of the path."""
    sides = [claim.left] if claim.relation == LIMIT else [claim.left, claim.right]
    if claim.relation not in (*ORDERS, LIMIT):
        raise NotExportedError(f"{claim.relation} along a path cannot be exported to Coq yet")
    x, (where, kind) = variable(path.name), whole_filter(path, whole)
    nodes = [node for node in dict.fromkeys(outermost(*sides)) if node.op != "unknown"]
    terms_said = [said for node in nodes for said in _counted_from(node, path.name, whole)]
    numbers = {node: symbol(fresh(f"sum{i}", symbols(sides[0]))) for i, node in enumerate(nodes)}
    sides = [naturally(replaced(e, numbers), whole) for e in sides]
    parts = [condition(*p) for p in needs(sides) if path.name in symbols(p[0])]
    said = [f"{where} (fun {x} : {kind} => {AND.join(parts)})"] if parts else []
    said = [*terms_said, *said]
    f, *g = (_with_sums(term(e), numbers, whole) for e in sides)
    if not g:
        tends = f"filterlim (fun {x} : {kind} => {f}) {where} "
        return [*said, f"{tends}(Rbar_locally {extended(claim.right)})"]
    if {"C", "c", "eps"} & (symbols(claim.left) | symbols(claim.right)):
        raise NotExportedError("a variable with this name cannot be exported to Coq in an order")
    constants, inequality = ORDERS[claim.relation]
    near = inequality.format(f=f, g=g[0])
    return [*said, f"{constants}{where} (fun {x} : {kind} => {near})"]
