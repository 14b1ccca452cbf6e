"""Orders as something tends to a point: shown by a bound, refuted by expansions along a path.

An order in one variable is shown by an inequality on the whole side of the point, which the prover
of signs proves; expansions show none here, and only refute. One in several variables is never
shown along a path; where it fails along one, the path is evidence: every condition must hold on it,
and what tends must tend there. A symbol that stands for the one root of a function has no expansion
of its own; on the path it is above, or below, a candidate where the function has the sign of that
end.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import ClassVar, NamedTuple

from sympy import Basic, Eq, Expr, Rational, Symbol, Tuple, oo
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import conditions, defined, definitions, tree
from tresym.ledger.evidence.integrals import NotShownError, need
from tresym.ledger.evidence.sign_prover import is_manifest, undefined
from tresym.ledger.finding import Finding, Ruling
from tresym.ledger.statements import As, ExactlyOne
from tresym.reals.decisions.asymptotics.leading_terms import sign_towards
from tresym.reals.decisions.asymptotics.order_claims import decide_order
from tresym.reals.decisions.claim_parsing import Comparison, Path
from tresym.reals.language.binders import elementary, worked_out
from tresym.reals.language.expression import ONE, ZERO, substitute, symbols
from tresym.reals.language.expression import Expr as Tree
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import parse_number
from tresym.reals.signs.interior import PROVING
from tresym.reals.verdict import Verdict

t = Symbol("t", real=True)
"""The small parameter of a path."""
SIDES = {1: (1,), -1: (-1,), 0: (1, -1)}


@dataclass(frozen=True)
class Asymptotics:
    """Expansions that refute an order, of one variable or along a path; they show none.

    Attributes:
        along: what each symbol is on the path, in the small parameter ``t`` from above.
        beside: for a symbol that is one root, on which side of a candidate it lies there.
        claims: the definition of that symbol, and equations put in for the function of the root.
    """

    along: Mapping[Symbol, Expr] = field(default_factory=dict)
    beside: Relational | None = None
    claims: tuple[Claim, ...] = ()
    kind: ClassVar[str] = "order"
    expect: ClassVar[Ruling] = Verdict.REFUTED


@dataclass(frozen=True)
class Squeezed:
    """The difference is at most ``constant``·rᵏ times the gauge, k the ``power``, in size.

    r is the distance from the point, or 1/|x|, and what is shown holds for all r > 0.
    """

    constant: Expr
    power: Fraction | int = 1
    kind: ClassVar[str] = "order"
    expect: ClassVar[Ruling] = Verdict.PROVED


class Ordered(NamedTuple):
    """``difference`` is O or o of ``gauge``."""

    difference: Expr
    kind: str
    gauge: Expr


class NotAlongError(ValueError):
    """What the path was to show is not shown on it."""


def failing_order(claim: Claim) -> Finding | None:
    """REFUTED, where expansions show that the order fails; None otherwise."""
    proof = claim.proof if isinstance(claim.proof, Asymptotics) else Asymptotics()
    found = _expanded(claim, proof)
    return found if found.verdict is Verdict.REFUTED else None


def judge_squeezed(claim: Claim, proof: Squeezed) -> Finding:
    """PROVED where the inequality is, on the whole side of the point.

    Raises:
        NotShownError: it is not, or the statement is no such order.
    """
    says = claim.statement
    stated = ordered(says.args[0]) if isinstance(says, As) else None
    if stated is None or not isinstance(says, As) or not isinstance(says.args[1], Symbol):
        raise NotShownError("the statement is not an equation with one order in a variable")
    _, x, point, side = says.args
    infinite = point in (oo, -oo)
    away = (x if point == oo else -x) if infinite else side * (x - point)
    distance = 1 / away if infinite else away
    need(x not in point.free_symbols, "it has no side of a point")
    need(not claim.given, "the conditions decide nothing here")
    small = isinstance(proof.power, int | Fraction) and not proof.constant.free_symbols
    enough = proof.power > 0 if stated.kind == "o" else proof.power >= 0
    need(small and enough, "the bound does not make it that small")
    near = conditions((away > 0,))
    rises = is_manifest(Relation(tree(stated.gauge), ">=", ZERO), near)
    size = proof.constant * distance**proof.power * (stated.gauge if rises else -stated.gauge)
    most = tree(size)
    for e in (tree(stated.difference), tree(-stated.difference)):
        gap = undefined(e, near) or undefined(most, near)
        need(gap is None and elementary(e, most), f"nothing shows that {gap or e} is a number")
        need(is_manifest(Relation(e, "<=", most), near), f"{e} <= {most} is not shown")
    why = f"±({stated.difference}) <= {size} for all {x} on that side"
    return Finding(Verdict.PROVED, why, region=f"{away} > 0")


def _expanded(claim: Claim, proof: Asymptotics) -> Finding:
    """What expansions say of an order."""
    says = claim.statement
    stated = ordered(says.args[0]) if isinstance(says, As) else None
    if stated is None or not isinstance(says, As):
        return Finding(Verdict.UNDECIDED, "the statement is not an equation with one order")
    try:
        if proof.along:
            return _along(claim, proof, says, stated)
        return _in_one_variable(claim, says, stated)
    except NotAlongError as error:
        return Finding(Verdict.UNDECIDED, str(error))


def ordered(says: Basic) -> Ordered | None:
    """An equation that is linear in its one O(…) or o(…), solved for it."""
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
    _, x, point, side = says.args
    if not isinstance(x, Symbol) or point.free_symbols:
        return Finding(Verdict.UNDECIDED, "several variables tend, and no path is given")
    if claim.given or claim.uses:
        return Finding(Verdict.UNDECIDED, "the conditions decide nothing here")
    end = None if point in (oo, -oo) else _tree(point)
    return _decided(stated, Path(x.name, end, SIDES[int(side)]))


def _decided(stated: Ordered, path: Path) -> Finding:
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
    """REFUTED where the order fails on the path; a path shows no order."""
    path = {name: _tree(e) for name, e in proof.along.items()}
    names = {symbol.name: e for symbol, e in zip(proof.along, path.values(), strict=True)}
    _need_path(claim, says, stated, names)
    difference, gauge = (
        substitute(_tree(e), names) for e in (_beyond(proof, stated, names), stated.gauge)
    )
    if (symbols(difference) | symbols(gauge)) - {t.name}:
        raise NotAlongError("the path leaves a symbol open")
    found = decide_order(Comparison(difference, stated.kind, gauge), Path(t.name, ZERO, (1,)))
    if found.verdict is not Verdict.REFUTED or found.witness is None:
        return Finding(Verdict.UNDECIDED, f"the order does not fail on the path: {found.why}")
    where = ", ".join(f"{name} = {e}" for name, e in sorted(names.items()))
    here = {t: Rational(found.witness[t.name])}
    point = {symbol.name: e.subs(here) for symbol, e in ((t, t), *proof.along.items())}
    witness = {name: parse_number(str(e)) for name, e in point.items() if e.is_Rational}
    beyond = f", where {proof.beside}, at that bound" if proof.beside is not None else ""
    why = f"along {where}{beyond} {found.why}"
    return Finding(Verdict.REFUTED, why, parameter=f"t -> 0+, {where}", witness=witness)


def _need_path(claim: Claim, says: As, stated: Ordered, names: Mapping[str, Tree]) -> None:
    """That the path is one of the statement: in its conditions, to its end, of free symbols.

    Raises:
        NotAlongError: it is not.
    """
    spoken_of = says.free_symbols.union(*(c.free_symbols for c in claim.given))
    if t in spoken_of:
        raise NotAlongError("the path is not in a parameter of its own")
    if {*names} & (defined(claim) | {t.name}):
        raise NotAlongError("the path gives a value to what is defined")
    _need(claim.given, names)
    what, ends = (e.args if isinstance(e, Tuple) else (e,) for e in says.args[1:3])
    if len(what) != len(ends):
        raise NotAlongError("what tends, and to where, is not told of each")
    for e, end in zip(what, ends, strict=True):
        here, side = substitute(_tree(e), names), int(says.args[3])
        if end in (oo, -oo):
            side, off = (1 if end == oo else -1), ONE / here
        else:
            off = here - _tree(end)
        vanishing = decide_order(Comparison(off, "o", ONE), Path(t.name, ZERO, (1,)))
        if not vanishing.verdict.holds or side not in (0, _sign(off)):
            raise NotAlongError(f"{e} does not tend there on the path")


def _need(given: tuple[Basic, ...], names: Mapping[str, Tree]) -> None:
    for condition in conditions(given):
        up = condition.upward
        sign = _sign(substitute(up.left - up.right, names))
        shown = {1: "+", -1: "-", 0: "0", None: None}[sign]
        if shown not in PROVING[up.sign]:
            raise NotAlongError(f"{condition} is not shown on the path")


def _beyond(proof: Asymptotics, stated: Ordered, names: Mapping[str, Tree]) -> Expr:
    """The difference at the candidate, which is smaller in size than at the root.

    Raises:
        NotAlongError: where that is not shown.
    """
    if proof.beside is None:
        return stated.difference
    root = next((c.proof for c in proof.claims if isinstance(c.proof, Root)), None)
    unique = None if root is None else root.unique.statement
    symbol, candidate = proof.beside.args
    if root is None or not isinstance(unique, ExactlyOne) or symbol != root.symbol:
        raise NotAlongError(f"{symbol} is not defined as one root")
    side = {">": 1, "<": -1}.get(proof.beside.rel_op)
    if side is None:
        raise NotAlongError(f"{proof.beside} is no bound to one side")
    at_candidate = {**names, unique.variable.name: substitute(_tree(candidate), names)}
    _need(root.unique.given, names)
    for low, high in ((unique.low, candidate), (candidate, unique.high)):
        if _sign(substitute(_tree(high - low), names)) != 1:
            raise NotAlongError("the candidate is not between the ends")
    vanishing = _tree(unique.difference)
    end = substitute(_tree(unique.low if side == 1 else unique.high), names)
    here = _sign(substitute(_put_in(vanishing, proof, at_candidate), at_candidate))
    there = _sign(substitute(vanishing, {**names, unique.variable.name: end}))
    if {here, there} not in ({1}, {-1}):
        raise NotAlongError(f"{proof.beside} is not shown on the path")
    slope, beyond = stated.difference.diff(symbol), stated.difference.xreplace({symbol: candidate})
    signs = [_sign(substitute(_tree(e), names)) for e in (slope * side, beyond)]
    if signs not in ([1, 1], [-1, -1]):
        raise NotAlongError("the difference may be smaller at the root than at the candidate")
    return beyond


def _put_in(e: Tree, proof: Asymptotics, names: Mapping[str, Tree]) -> Tree:
    """``e`` by the equation that is claimed of it, where its conditions hold on the path."""
    for claim in proof.claims:
        rules = {} if isinstance(claim.proof, Root) else definitions((claim,))
        if e in rules:
            _need(claim.given, names)
            return rules[e]
    return e


def _sign(e: Tree) -> int | None:
    """The sign of ``e`` for small t, 0 where it is 0 there; None where that is open.

    Raises:
        NotAlongError: it speaks of more than t.
    """
    if symbols(e) - {t.name}:
        raise NotAlongError("the path leaves a symbol open")
    found = sign_towards(e, t.name, ZERO, 1)
    return None if found is None else found[0]


def _tree(e: Basic) -> Tree:
    return worked_out(tree(e))
