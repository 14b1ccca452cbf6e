"""Orders as something tends to a point, refuted by expansions along a path.

`Asymptotics`: the asymptotic expansion of the difference contradicts the order, in one variable or
along a path. On the path all conditions must hold and the limit must be reached. A path never
proves an order in several variables.

A symbol defined as the root of a function has no expansion of its own. On a path it is compared
with a candidate expression: it lies above or below the candidate, depending on the sign of the
function there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

from sympy import Basic, Eq, Expr, Rational, Symbol, Tuple, oo
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from tresym.asymptotics.order_claims import decide_order
from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import conditions, defined, definitions, tree
from tresym.ledger.finding import Finding, Ruling
from tresym.ledger.statements import As, ExactlyOne
from tresym.reals.expansions.leading_terms import sign_towards
from tresym.reals.language.binders import worked_out
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import ONE, ZERO, substitute, symbols
from tresym.reals.language.expression import Expr as Tree
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import parse_number
from tresym.reals.signs.interior import PROVING
from tresym.reals.verdict import Verdict

t = Symbol("t", real=True)
"""The parameter of a path; it tends to 0 from above."""
UNASSIGNED = "the path does not give every symbol a value"
SIDES = {1: (1,), -1: (-1,), 0: (1, -1)}


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

    along: Mapping[Symbol, Expr] = field(default_factory=dict)
    beside: Relational | None = None
    claims: tuple[Claim, ...] = ()
    kind: ClassVar[str] = "order"
    expect: ClassVar[Ruling] = Verdict.REFUTED


class Ordered(NamedTuple):
    """The statement that ``difference`` is O(``gauge``) or o(``gauge``), as ``kind`` says."""

    difference: Expr
    kind: str
    gauge: Expr


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
    stated = ordered(says.args[0]) if isinstance(says, As) else None
    if stated is None or not isinstance(says, As):
        return Finding(Verdict.UNDECIDED, "the statement must be an equation with one order")
    try:
        if proof.along:
            return _along(claim, proof, says, stated)
        return _in_one_variable(claim, says, stated)
    except NotAlongError as error:
        return Finding(Verdict.UNDECIDED, str(error))


def ordered(says: Basic) -> Ordered | None:
    """Solve an equation for its only O(…) or o(…), in which it must be linear.

    Returns:
        The difference, the kind (``"O"`` or ``"o"``) and the gauge; None if ``says`` is not such
        an equation.
    """
    orders = [node for node in says.atoms(AppliedUndef) if str(node.func) in ("O", "o")]
    if not isinstance(says, Eq) or len(orders) != 1 or len(orders[0].args) != 1:
        return None
    (node,), stand_in = orders, Symbol("[order]", real=True)
    rest = (says.lhs - says.rhs).xreplace({node: stand_in})
    factor = -rest.diff(stand_in)
    if stand_in in factor.free_symbols or factor == 0:
        return None
    return Ordered(rest.xreplace({stand_in: 0}), str(node.func), node.args[0] * factor)


def _in_one_variable(claim: Claim, says: As, stated: Ordered) -> Finding:
    """Decide an order in one variable, without conditions, by expansions."""
    _, x, point, side = says.args
    if not isinstance(x, Symbol) or point.free_symbols:
        return Finding(
            Verdict.UNDECIDED,
            "the order is in several variables; a refutation needs a path (Asymptotics(along=...))",
        )
    if claim.given or claim.uses:
        return Finding(
            Verdict.UNDECIDED, "expansions in one variable take no conditions and use no claims"
        )
    end = None if point in (oo, -oo) else _tree(point)
    return _decided(stated, Path(x.name, end, SIDES[int(side)]))


def _decided(stated: Ordered, path: Path) -> Finding:
    """Decide the order on a path and convert the result to a finding."""
    left, right = _tree(stated.difference), _tree(stated.gauge)
    found = decide_order(Comparison(left, stated.kind, right), path)
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


def _along(claim: Claim, proof: Asymptotics, says: As, stated: Ordered) -> Finding:
    """Return REFUTED if the order fails on the path, else UNDECIDED."""
    path = {name: _tree(e) for name, e in proof.along.items()}
    names = {symbol.name: e for symbol, e in zip(proof.along, path.values(), strict=True)}
    _need_path(claim, says, stated, names)
    difference, gauge = (
        substitute(_tree(e), names) for e in (_beyond(proof, stated, names), stated.gauge)
    )
    if (symbols(difference) | symbols(gauge)) - {t.name}:
        raise NotAlongError(UNASSIGNED)
    found = decide_order(Comparison(difference, stated.kind, gauge), Path(t.name, ZERO, (1,)))
    if found.verdict is not Verdict.REFUTED or found.witness is None:
        return Finding(Verdict.UNDECIDED, f"the order does not fail on the path: {found.why}")
    where = ", ".join(f"{name} = {e}" for name, e in sorted(names.items()))
    here = {t: Rational(found.witness[t.name])}
    point = {symbol.name: e.subs(here) for symbol, e in ((t, t), *proof.along.items())}
    witness = {name: parse_number(str(e)) for name, e in point.items() if e.is_Rational}
    beyond = f", where {proof.beside}, at that bound" if proof.beside is not None else ""
    why = f"along {where}{beyond} {found.why}"
    return Finding(
        Verdict.REFUTED, why, parameter=f"t -> 0+, {where}", witness=witness, along=where
    )


def _need_path(claim: Claim, says: As, stated: Ordered, names: Mapping[str, Tree]) -> None:
    """Require that the path satisfies the conditions, reaches the limit and sets free symbols only.

    Raises:
        NotAlongError: one of these could not be shown.
    """
    spoken_of = says.free_symbols.union(*(c.free_symbols for c in claim.given))
    if t in spoken_of:
        raise NotAlongError(f"the parameter {t} of the path must not occur in the statement")
    if {*names} & (defined(claim) | {t.name}):
        raise NotAlongError("the path must not give a value to a defined symbol")
    _need(claim.given, names)
    what, ends = (e.args if isinstance(e, Tuple) else (e,) for e in says.args[1:3])
    if len(what) != len(ends):
        raise NotAlongError("the statement must give one limit for each expression that tends")
    for e, end in zip(what, ends, strict=True):
        here, side = substitute(_tree(e), names), int(says.args[3])
        if end in (oo, -oo):
            side, off = (1 if end == oo else -1), ONE / here
        else:
            off = here - _tree(end)
        vanishing = decide_order(Comparison(off, "o", ONE), Path(t.name, ZERO, (1,)))
        if not vanishing.verdict.holds or side not in (0, _sign(off)):
            raise NotAlongError(f"could not show that {e} tends to {end} on the path")


def _need(given: tuple[Basic, ...], names: Mapping[str, Tree]) -> None:
    """Require that the conditions hold on the path for small t."""
    for condition in conditions(given):
        up = condition.upward
        sign = _sign(substitute(up.left - up.right, names))
        shown = {1: "+", -1: "-", 0: "0", None: None}[sign]
        if shown not in PROVING[up.sign]:
            raise NotAlongError(f"could not show the condition {condition} on the path")


def _beyond(proof: Asymptotics, stated: Ordered, names: Mapping[str, Tree]) -> Expr:
    """Return the difference with the candidate in place of the root, which makes it smaller.

    Raises:
        NotAlongError: it could not be shown that this makes the difference smaller in size.
    """
    if proof.beside is None:
        return stated.difference
    root = next((c.proof for c in proof.claims if isinstance(c.proof, Root)), None)
    unique = None if root is None else root.unique.statement
    symbol, candidate = proof.beside.args
    if root is None or not isinstance(unique, ExactlyOne) or symbol != root.symbol:
        raise NotAlongError(f"{symbol} is not defined as the root of a function")
    side = {">": 1, "<": -1}.get(proof.beside.rel_op)
    if side is None:
        raise NotAlongError(f"{proof.beside} must be a strict inequality, with > or <")
    at_candidate = {**names, unique.variable.name: substitute(_tree(candidate), names)}
    _need(root.unique.given, names)
    for low, high in ((unique.low, candidate), (candidate, unique.high)):
        if _sign(substitute(_tree(high - low), names)) != 1:
            raise NotAlongError("could not show that the candidate lies between the ends")
    vanishing = _tree(unique.difference)
    end = substitute(_tree(unique.low if side == 1 else unique.high), names)
    here = _sign(substitute(_put_in(vanishing, proof, at_candidate), at_candidate))
    there = _sign(substitute(vanishing, {**names, unique.variable.name: end}))
    if {here, there} not in ({1}, {-1}):
        raise NotAlongError(f"could not show {proof.beside} on the path")
    slope, beyond = stated.difference.diff(symbol), stated.difference.xreplace({symbol: candidate})
    signs = [_sign(substitute(_tree(e), names)) for e in (slope * side, beyond)]
    if signs not in ([1, 1], [-1, -1]):
        raise NotAlongError(
            "could not show that the difference is larger in size at the root than at the candidate"
        )
    return beyond


def _put_in(e: Tree, proof: Asymptotics, names: Mapping[str, Tree]) -> Tree:
    """Replace ``e`` by the right side of a used claim's equation for it, if there is one."""
    for claim in proof.claims:
        rules = {} if isinstance(claim.proof, Root) else definitions((claim,))
        if e in rules:
            _need(claim.given, names)
            return rules[e]
    return e


def _sign(e: Tree) -> int | None:
    """Return the sign of ``e`` for small t > 0 (1, −1 or 0), or None if it is unknown.

    Raises:
        NotAlongError: ``e`` contains a symbol other than t.
    """
    if symbols(e) - {t.name}:
        raise NotAlongError(UNASSIGNED)
    found = sign_towards(e, t.name, ZERO, 1)
    return None if found is None else found[0]


def _tree(e: Basic) -> Tree:
    """Return the expression tree with derivatives and substitutions carried out."""
    return worked_out(tree(e))
