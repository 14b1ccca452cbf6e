"""What SymPy derives by itself is what the claims of the paper state."""

from typing import Any

import sympy
from sympy import Derivative, Expr, Integral, Rational, Symbol, sin
from tresym.proofs import euler_angles, separatrix, slope, sympy_derivations

from tresym.ledger.claim import (
    Claim,
)
from tresym.reals.language.to_sympy import to_sympy

OWN = {
    symbol.name: symbol
    for symbol in vars(sympy_derivations).values()
    if isinstance(symbol, Symbol) and symbol.is_positive
}
POINTS = (
    {"I1": 1, "I2": 3, "I3": Rational(7, 2), "M": 2, "a": Rational(5, 4), "b": Rational(2, 7),
     "theta": Rational(3, 5), "psi": Rational(6, 7), "x": Rational(1, 9), "S": 1},
    {"I1": 2, "I2": 5, "I3": 6, "M": 3, "a": 12, "b": Rational(1, 16),
     "theta": Rational(9, 4), "psi": Rational(1, 3), "x": Rational(-1, 30), "S": -1},
)  # fmt: skip


def agree(derived: Expr, claimed: Expr) -> bool:
    """Whether two expressions are equal as formulas, and at points to 30 digits."""
    claimed = claimed.xreplace({s: OWN.get(s.name, s) for s in claimed.free_symbols})
    gap = derived - claimed.doit()
    for point in POINTS:
        values = {s: point[s.name] for s in gap.free_symbols}
        if abs(sympy.N(gap.subs(values), 30)) > Rational(1, 10**25):
            return False
    return bool(sympy.simplify(gap) == 0)


def said(claim: Claim) -> Any:
    return claim.statement


def sides(claim: Claim) -> list[Expr]:
    return [to_sympy(part.right) for part in claim.parts]


def test_the_planar_system() -> None:
    *_, theta, phi, psi, along_theta, along_psi = (
        s.result for s in sympy_derivations.planar_system()
    )
    for derived, claimed in zip((theta, phi, psi), sides(euler_angles.eq_euler_angle), strict=True):
        assert agree(derived, claimed)
    for derived, claimed in zip(
        (along_theta, along_psi), sides(euler_angles.eq_Euler), strict=True
    ):
        assert agree(derived, claimed)


def test_the_constant_of_motion() -> None:
    _, level, along = (s.result for s in sympy_derivations.constant_of_motion())
    assert agree(level, to_sympy(said(euler_angles.eq_gamma).right))
    assert along == 0


def test_the_integral_in_x() -> None:
    in_s, _, _, in_x = (s.result for s in sympy_derivations.integral_in_x())
    (integral,) = to_sympy(said(separatrix.d35).left).atoms(Integral)
    assert [v.name for v in integral.variables] == ["x"]
    assert agree(in_x, integral.function)
    (turn,) = to_sympy(said(separatrix.d32).left).atoms(Integral)
    mu = sympy.sqrt(OWN["b"] / (OWN["a"] + OWN["b"]))
    psi = turn.variables[0]
    own = turn.function.xreplace({s: OWN.get(s.name, s) for s in turn.free_symbols})
    assert agree(
        in_s.subs(Symbol("s", positive=True), sin(psi)), -OWN["b"] * own / (-mu * sin(psi))
    )


def test_the_antiderivative_of_the_slope() -> None:
    derived, *_, antiderivative = (s.result for s in sympy_derivations.antiderivative_of_slope())
    bracket = to_sympy(slope.d55.says.left)
    assert isinstance(bracket, Derivative)
    assert agree(antiderivative, bracket.expr)
    psi = bracket.variables[0]
    assert agree(derived.subs(Symbol("s", positive=True), sin(psi)), to_sympy(slope.d55.says.right))


def test_another_formula_does_not_agree() -> None:
    *_, along_theta, along_psi = (s.result for s in sympy_derivations.planar_system())
    assert not agree(along_psi, sides(euler_angles.eq_Euler)[0])
    assert not agree(-along_theta, sides(euler_angles.eq_Euler)[0])
