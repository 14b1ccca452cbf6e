"""Judge statements on the solutions of differential equations: conserved, stable, unstable.

A system dx/dt = f(x) is given by its variables and their rates. That an expression is conserved
follows from the chain rule: its derivative along the system is 0. An equilibrium p is stable if a
conserved function has a strict minimum there (Lyapunov's theorem), and unstable if the linearised
system has a positive eigenvalue (instability by the first approximation; both in
H. K. Khalil, Nonlinear Systems, 3rd ed. (2002), Theorems 4.1 and 4.7).

Example: dx/dt = v, dv/dt = −x conserves x² + v², whose minimum at (0, 0) is strict: (0, 0) is
stable. For dx/dt = v, dv/dt = x the eigenvalue 1 at (0, 0) is positive: unstable.
"""

from __future__ import annotations

from sympy import Basic, Tuple

from tresym.ledger.claim import Chain, Claim, Conservation, Growing, Lyapunov, by
from tresym.ledger.conversion import Conditions, conditions, defined, dependencies, dependent, tree
from tresym.ledger.evidence.chain import check_chain
from tresym.ledger.evidence.integrals import need, need_smooth
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.finding import Finding
from tresym.ledger.reasons import exponentials, roots, trigonometry
from tresym.ledger.refutations import PROVED, need_all, need_possible
from tresym.ledger.statements import Conserved, StableEquilibrium, UnstableEquilibrium
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, substitute, symbols
from tresym.reals.language.formula import Relation

THEORIES = (roots, trigonometry, exponentials)


class _System:
    """The variables and rates of a system, under the conditions of a claim."""

    def __init__(self, claim: Claim, variables: Basic, rates: Basic, *also: Basic) -> None:
        """Require distinct free variables on which no defined symbol depends."""
        need(
            isinstance(variables, Tuple) and isinstance(rates, Tuple) and bool(variables.args),
            "a system needs variables and rates",
        )
        need(len(variables.args) == len(rates.args), "each variable needs one rate")
        self.names = [x.name for x in variables.args]
        need(len({*self.names}) == len(self.names), "the variables of a system must differ")
        self.rates = [tree(rate) for rate in rates.args]
        self.given: Conditions = conditions(claim.given)
        spoken = frozenset().union(*map(symbols, (*self.rates, *map(tree, also))))
        need(not {*self.names} & defined(claim), "a variable of the system is a defined symbol")
        name = dependent(spoken, self.names, dependencies((*claim.rests_on, claim)))
        need(name is None, f"{name} is defined in terms of a variable, but would count as constant")
        need_possible(claim)
        for rate in self.rates:
            need_smooth(rate, self.given)

    def along(self, e: Expr) -> Expr:
        """Return the derivative of ``e`` along the system."""
        total = ZERO
        for name, rate in zip(self.names, self.rates, strict=True):
            total = total + differentiate(e, name) * rate
        return total

    def need_conserved(self, e: Expr, chain: Chain) -> None:
        """Require that the derivative of ``e`` along the system is 0."""
        need_smooth(e, self.given)
        need_all(check_chain(Relation(self.along(e), "==", ZERO), chain, self.given))

    def need_zero(self, e: Expr, given: Conditions) -> None:
        """Require that ``e`` is 0."""
        need_all(check_chain(Relation(e, "==", ZERO), by(*THEORIES), given))


def judge_conserved(claim: Claim, proof: Conservation) -> Finding:
    """Return PROVED if the derivative along the system is 0.

    Raises:
        NotShownError: this could not be shown.
    """
    says = claim.statement
    need(isinstance(says, Conserved), "this evidence shows that an expression is conserved")
    assert isinstance(says, Conserved)
    e, variables, rates = says.args
    _System(claim, variables, rates, e).need_conserved(tree(e), proof.derivative or by(*THEORIES))
    return Finding(PROVED, "its derivative along the system is 0")


def _at_rest(
    claim: Claim, says: StableEquilibrium | UnstableEquilibrium, *also: Basic
) -> tuple[_System, dict[str, Expr], Conditions]:
    """Return the system, the equilibrium and the conditions without the variables.

    The conditions on the variables must hold near the equilibrium, since the system is smooth only
    where they do.
    """
    variables, rates, point = says.args
    system = _System(claim, variables, rates, *also)
    need(isinstance(point, Tuple), "an equilibrium needs coordinates")
    need(len(point.args) == len(system.names), "each variable needs one coordinate")
    place = {name: tree(p) for name, p in zip(system.names, point.args, strict=True)}
    need(
        not {*system.names} & frozenset().union(*map(symbols, place.values())),
        "the coordinates of the equilibrium must not depend on the variables",
    )
    outside = tuple(
        c for c in system.given if not {*system.names} & (symbols(c.left) | symbols(c.right))
    )
    for c in system.given:
        if c not in outside:
            sign = c.sign.rstrip("=") if c.sign != "!=" else c.sign
            there = Relation(substitute(c.left, place), sign, substitute(c.right, place))
            need(is_manifest(there, outside), f"could not show {c} near the equilibrium")
    for rate in system.rates:
        system.need_zero(substitute(rate, place), outside)
    return system, place, outside


def judge_stable(claim: Claim, proof: Lyapunov) -> Finding:
    """Return PROVED if the function is conserved and has a strict minimum at the equilibrium.

    Raises:
        NotShownError: one of these could not be shown.
    """
    says = claim.statement
    need(isinstance(says, StableEquilibrium), "a Lyapunov function shows that a point is stable")
    assert isinstance(says, StableEquilibrium)
    system, place, outside = _at_rest(claim, says, proof.function)
    function = tree(proof.function)
    system.need_conserved(function, by(*THEORIES))
    gradient = [differentiate(function, name) for name in system.names]
    for slope in gradient:
        system.need_zero(substitute(slope, place), outside)
    hessian = [
        [substitute(differentiate(slope, name), place) for name in system.names]
        for slope in gradient
    ]
    for size in range(1, len(hessian) + 1):
        minor = _determinant([row[:size] for row in hessian[:size]])
        positive = is_manifest(Relation(minor, ">", ZERO), outside)
        need(positive, f"could not show that the leading minor of order {size} is positive")
    return Finding(PROVED, "a conserved function has a strict minimum there")


def judge_unstable(claim: Claim, proof: Growing) -> Finding:
    """Return PROVED if the system linearised at the equilibrium has a positive eigenvalue.

    Raises:
        NotShownError: this could not be shown.
    """
    says = claim.statement
    need(isinstance(says, UnstableEquilibrium), "a growing solution shows that a point is unstable")
    assert isinstance(says, UnstableEquilibrium)
    system, place, outside = _at_rest(claim, says)
    value = tree(proof.eigenvalue)
    need(
        not {*system.names} & symbols(value) and not defined(claim) & symbols(value),
        "an eigenvalue must not depend on the variables",
    )
    need(is_manifest(Relation(value, ">", ZERO), outside), "the eigenvalue must be positive")
    matrix = [
        [
            substitute(differentiate(rate, name), place) - (value if n == m else ZERO)
            for m, name in enumerate(system.names)
        ]
        for n, rate in enumerate(system.rates)
    ]
    system.need_zero(_determinant(matrix), outside)
    return Finding(PROVED, "the system linearised there has a positive eigenvalue")


def _determinant(rows: list[list[Expr]]) -> Expr:
    """Return the determinant of a small matrix, expanded by its first row."""
    if len(rows) == 1:
        return rows[0][0]
    total = ZERO
    for n, entry in enumerate(rows[0]):
        rest = [row[:n] + row[n + 1 :] for row in rows[1:]]
        term = entry * _determinant(rest)
        total = total + term if n % 2 == 0 else total - term
    return total
