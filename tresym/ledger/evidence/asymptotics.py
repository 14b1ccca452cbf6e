"""Orders as something tends to a point, refuted by expansions along a path.

`Asymptotics`: the asymptotic expansion of the difference contradicts the order, in one variable or
along a path. On the path all conditions must hold and the limit must be reached. A path never
proves an order in several variables.

A symbol defined as the root of a function has no expansion of its own. On a path it is compared
with a candidate expression: it lies above or below the candidate, depending on the sign of the
function there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from tresym.asymptotics.order_claims import decide_order
from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import conditions, defined, definitions
from tresym.ledger.finding import Finding, Ruling
from tresym.ledger.formulas import Tending, in_order, in_trees, is_equation, names_of
from tresym.reals.expansions.leading_terms import sign_towards
from tresym.reals.language.binders import outermost, worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.compound import Count
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ORDERS,
    ZERO,
    Expr,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.like_terms import collected
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import parse_number
from tresym.reals.signs.interior import PROVING
from tresym.reals.verdict import Verdict

PARAMETER = "t"
"""The parameter of a path; it tends to 0 from above."""
UNASSIGNED = "the path does not give every symbol a value"


@dataclass(frozen=True)
class Asymptotics:
    """Evidence against an order: an asymptotic expansion in one variable or along a path.

    Attributes:
        along: each symbol as a function of the path's parameter ``t``, t → 0+; empty for an order
            in one variable.
        beside: for a symbol defined as a root, the inequality between it and a candidate on the
            path.
        claims: the definition of that symbol, and equations for the function whose root it is.
    """

    along: Mapping[Any, Any] = field(default_factory=dict)
    beside: Any = None
    claims: tuple[Claim, ...] = ()
    kind: ClassVar[str] = "order"
    expect: ClassVar[Ruling] = Verdict.REFUTED


class NotAlongError(ValueError):
    """A requirement on the path of a refutation could not be shown; the text says which."""


def failing_order(claim: Claim) -> Finding | None:
    """Return REFUTED if an asymptotic expansion contradicts the order, else None."""
    proof = claim.proof if isinstance(claim.proof, Asymptotics) else Asymptotics()
    found = _expanded(claim, proof)
    return found if found.verdict is Verdict.REFUTED else None


def _expanded(claim: Claim, proof: Asymptotics) -> Finding:
    """Expand the difference, in one variable or along the path, and compare it with the gauge."""
    says = claim.statement
    stated = solved_for_order(says.relation) if isinstance(says, Tending) else None
    if stated is None or not isinstance(says, Tending):
        return Finding(Verdict.UNDECIDED, "the statement must be an equation with one order")
    try:
        if proof.along:
            return _along(claim, proof, says, stated)
        return _in_one_variable(claim, says.path, stated)
    except NotAlongError as error:
        return Finding(Verdict.UNDECIDED, str(error))


def solved_for_order(says: Any) -> Comparison | None:
    """Solve an equation for its only O(…) or o(…), in which it must be linear.

    Returns:
        The comparison of the difference and the gauge by ``"O"`` or ``"o"``; None if ``says`` is
        not such an equation.

    Example:
        >>> from tresym.reals.language.formula import Relation
        >>> from tresym.reals.language.parsing import parse
        >>> said = Relation(parse("y"), "==", parse("x") + Expr("O", (parse("a"),)))
        >>> found = solved_for_order(said)
        >>> str(found.left), found.relation, str(found.right)
        ('y - x', 'O', 'a')
    """
    if not isinstance(says, Relation) or not is_equation(says):
        return None
    nodes = {node for node in outermost(says.left, says.right) if node.op in ORDERS}
    if len(nodes) != 1 or (node := next(iter(nodes))).op not in ("O", "o"):
        return None
    mark = symbol("[order]")
    gap = replaced(says.left, {node: mark}) - replaced(says.right, {node: mark})
    inner = {e: symbol(f"[{n}]") for n, e in enumerate(dict.fromkeys(outermost(gap)))}
    if _has_order(gap) or any("[order]" in symbols(e) for e in inner):
        return None
    factor = collected(-differentiate(replaced(gap, inner), "[order]"))
    if "[order]" in symbols(factor) or factor == ZERO:
        return None
    factor = substitute(factor, {str(name): e for e, name in inner.items()})
    return Comparison(substitute(gap, {"[order]": ZERO}), node.op, node.args[0] * factor)


def _has_order(e: Expr) -> bool:
    """Return whether an order is left in a tree, within an integral or another such node."""
    return e.op in ORDERS or (e.op not in LEAVES and any(map(_has_order, e.args)))


def _in_one_variable(claim: Claim, path: Path, stated: Comparison) -> Finding:
    """Decide an order in one variable, without conditions, by expansions."""
    if not path.name or path.together or symbols(path.point or ZERO):
        return Finding(
            Verdict.UNDECIDED,
            "the order is in several variables; a refutation needs a path (Asymptotics(along=...))",
        )
    if claim.given or claim.uses:
        return Finding(
            Verdict.UNDECIDED, "expansions in one variable take no conditions and use no claims"
        )
    found = decide_order(
        Comparison(worked_out(stated.left), stated.relation, worked_out(stated.right)), path
    )
    witness = found.witness and {name: parse_number(v) for name, v in found.witness.items()}
    return Finding(
        found.verdict,
        found.why,
        constant=found.constant,
        region=found.region,
        parameter=str(path),
        witness=witness,
    )


# Along a path


def _along(claim: Claim, proof: Asymptotics, says: Tending, stated: Comparison) -> Finding:
    """Return REFUTED if the order fails on the path, else UNDECIDED."""
    names = {str(name): worked_out(in_trees(e)) for name, e in proof.along.items()}
    _need_path(claim, says, names)
    beside = None if proof.beside is None else in_trees(proof.beside)
    smaller = stated.left if beside is None else _beyond(proof, beside, stated, names)
    difference, gauge = (substitute(worked_out(e), names) for e in (smaller, stated.right))
    if (symbols(difference) | symbols(gauge)) - {PARAMETER}:
        raise NotAlongError(UNASSIGNED)
    found = decide_order(
        Comparison(difference, stated.relation, gauge), Path(PARAMETER, ZERO, (1,))
    )
    if found.verdict is not Verdict.REFUTED or found.witness is None:
        return Finding(Verdict.UNDECIDED, f"the order does not fail on the path: {found.why}")
    where = ", ".join(f"{name} = {e}" for name, e in sorted(names.items()))
    here = {PARAMETER: number(parse_number(found.witness[PARAMETER]))}
    path = {PARAMETER: symbol(PARAMETER), **names}
    point = {name: substitute(e, here) for name, e in path.items()}
    witness = {name: e.args[0] for name, e in point.items() if e.op == "number"}
    beyond = f", where {proof.beside}, at that bound" if beside is not None else ""
    why = f"along {where}{beyond} {found.why}"
    return Finding(
        Verdict.REFUTED, why, parameter=f"t -> 0+, {where}", witness=witness, along=where
    )


def _need_path(claim: Claim, says: Tending, names: Mapping[str, Expr]) -> None:
    """Require that the path satisfies the conditions, reaches the limit and sets free symbols only.

    Raises:
        NotAlongError: one of these could not be shown.
    """
    if PARAMETER in names_of(says, *map(in_trees, claim.given)):
        raise NotAlongError(
            f"the parameter {PARAMETER} of the path must not occur in the statement"
        )
    if {*names} & (defined(claim) | {PARAMETER}):
        raise NotAlongError("the path must not give a value to a defined symbol")
    _need(claim.given, names)
    if len(says.path.together) != len(says.path.points):
        raise NotAlongError("the statement must give one limit for each expression that tends")
    for e, end, side in _tending(says.path):
        here = substitute(worked_out(e), names)
        if end in (INFINITY, -INFINITY):
            side, off = (1 if end == INFINITY else -1), ONE / here
        else:
            off = here - worked_out(end)
        vanishing = decide_order(Comparison(off, "o", ONE), Path(PARAMETER, ZERO, (1,)))
        if not vanishing.verdict.holds or side not in (0, _sign(off)):
            raise NotAlongError(f"could not show that {e} tends to {end} on the path")


def _tending(path: Path) -> Iterator[tuple[Expr, Expr, int]]:
    """Yield what tends, to which point, and from which side (0 for both)."""
    if path.expression is not None:
        yield path.expression, INFINITY, 1
    elif path.together:
        yield from ((symbol(x), p, 0) for x, p in zip(path.together, path.points, strict=True))
    else:
        side = path.sides[0] if len(path.sides) == 1 else 0
        far = INFINITY if side > 0 else -INFINITY
        end = far if path.point is None else path.point
        yield symbol(str(path.name)), end, side


def _need(given: tuple[Any, ...], names: Mapping[str, Expr]) -> None:
    """Require that the conditions hold on the path for small t."""
    for condition in conditions(given):
        up = condition.upward
        sign = _sign(substitute(up.left - up.right, names))
        shown = {1: "+", -1: "-", 0: "0", None: None}[sign]
        if shown not in PROVING[up.sign]:
            raise NotAlongError(f"could not show the condition {condition} on the path")


def _beyond(
    proof: Asymptotics, beside: Relation, stated: Comparison, names: Mapping[str, Expr]
) -> Expr:
    """Return the difference with the candidate in place of the root, which makes it smaller.

    Raises:
        NotAlongError: it could not be shown that this makes the difference smaller in size.
    """
    root = next((c.proof for c in proof.claims if isinstance(c.proof, Root)), None)
    unique = None if root is None else root.unique.statement
    written, candidate = beside.left, worked_out(beside.right)
    one = unique if isinstance(unique, Count) and unique.how == "exactly one" else None
    if root is None or one is None or written != symbol(str(root.symbol)):
        raise NotAlongError(f"{written} is not defined as the root of a function")
    side = {">": 1, "<": -1}.get(beside.sign)
    if side is None:
        raise NotAlongError(f"{beside} must be a strict inequality, with > or <")
    low, high = worked_out(one.low), worked_out(one.high)
    at_candidate = {**names, one.name: substitute(candidate, names)}
    _need(root.unique.given, names)
    for below, above in ((low, candidate), (candidate, high)):
        if _sign(substitute(above - below, names)) != 1:
            raise NotAlongError("could not show that the candidate lies between the ends")
    vanishing = worked_out(one.equation[0] - one.equation[2])
    end = substitute(low if side == 1 else high, names)
    here = _sign(substitute(_put_in(vanishing, proof, at_candidate), at_candidate))
    there = _sign(substitute(vanishing, {**names, one.name: end}))
    if {here, there} not in ({1}, {-1}):
        raise NotAlongError(f"could not show {beside} on the path")
    difference, name = worked_out(stated.left), str(root.symbol)
    beyond = substitute(difference, {name: candidate})
    slope = side * differentiate(difference, name)
    signs = [_sign(substitute(e, names)) for e in (slope, beyond)]
    if signs not in ([1, 1], [-1, -1]):
        raise NotAlongError(
            "could not show that the difference is larger in size at the root than at the candidate"
        )
    return beyond


def _put_in(e: Expr, proof: Asymptotics, names: Mapping[str, Expr]) -> Expr:
    """Replace ``e`` by the right side of a used claim's equation for it, if there is one."""
    for claim in proof.claims:
        rules = {} if isinstance(claim.proof, Root) else definitions((claim,))
        known = {in_order(left): right for left, right in rules.items()}
        if in_order(e) in known:
            _need(claim.given, names)
            return known[in_order(e)]
    return e


def _sign(e: Expr) -> int | None:
    """Return the sign of ``e`` for small t > 0 (1, −1 or 0), or None if it is unknown.

    Raises:
        NotAlongError: ``e`` contains a symbol other than t.
    """
    if symbols(e) - {PARAMETER}:
        raise NotAlongError(UNASSIGNED)
    found = sign_towards(e, PARAMETER, ZERO, 1)
    return None if found is None else found[0]
