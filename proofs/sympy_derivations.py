"""The main formulas derived once more, step by step, by SymPy alone.

Nothing here knows the engine, the ledger or the formulas that programs run: each function begins
with what a textbook gives and ends with a formula of the paper, which tests compare with that of
its claim. For example, :func:`planar_system` begins with three rotation matrices and Ω_i = M_i/I_i,
and ends with dθ/dφ and dψ/dφ in terms of a and b.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import sympy
from sympy import Expr, Matrix, Symbol, cos, diff, log, sin, sqrt, symbols

I1, I2, I3, M, a, b = symbols("I1 I2 I3 M a b", positive=True)
theta, phi, psi, S, x, t, gamma = symbols("theta phi psi S x t gamma", real=True)
SHAPE = {I1: I2 / (1 + a), I3: I2 / (1 - b)}
"""The moments by the shape: a = I₂/I₁ − 1 and b = 1 − I₂/I₃."""


class Step(NamedTuple):
    """A step of a derivation: what is done, and what results."""

    words: str
    result: Expr


def rotation() -> Matrix:
    """R = R_z(φ) R_y(θ) R_z(ψ), from components along (e₂, e₃, e₁) to those along (X, Y, Z)."""

    def about_z(angle: Symbol) -> Matrix:
        return Matrix([[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]])

    about_y = Matrix([[cos(theta), 0, sin(theta)], [0, 1, 0], [-sin(theta), 0, cos(theta)]])
    return about_z(phi) * about_y * about_z(psi)


def momentum() -> tuple[Expr, Expr, Expr]:
    """(M₁, M₂, M₃): the vector M along Z has the components M Rᵀ(0, 0, 1)ᵀ in the body."""
    second, third, first = M * rotation().T * Matrix([0, 0, 1])
    return first, second, third


def reduced(e: Expr) -> Expr:
    """A polynomial in sines and cosines with cos² replaced by 1 − sin², for each angle."""
    for angle in (theta, phi, psi):
        e = sympy.expand(sympy.expand(e).subs(cos(angle) ** 2, 1 - sin(angle) ** 2))
    return e


@cache
def planar_system() -> tuple[Step, ...]:
    """The rates of the Euler angles, and dθ/dφ and dψ/dφ in terms of the shape."""
    rates = symbols("thetadot phidot psidot", real=True)
    turned = rotation()
    moved = sum(
        (turned.diff(angle) * rate for angle, rate in zip((theta, phi, psi), rates, strict=True)),
        sympy.zeros(3, 3),
    )
    spin = turned.T * moved
    by_rates = [reduced(spin[row, column]) for row, column in ((1, 0), (2, 1), (0, 2))]
    by_momentum = [m / moment for m, moment in zip(momentum(), (I1, I2, I3), strict=True)]

    def solved(combine: Callable[..., Expr], rate: Symbol) -> Expr:
        """The rate for which a combination of Ω₁, Ω₂, Ω₃ has the value that M gives it."""
        left = reduced(combine(*by_rates)) - combine(*by_momentum)
        slope = sympy.factor(diff(left, rate))
        return sympy.factor(-left.subs(rate, 0) / slope)

    theta_dot = solved(lambda _, w2, w3: w2 * sin(psi) + w3 * cos(psi), rates[0])
    phi_dot = solved(lambda _, w2, w3: w3 * sin(psi) - w2 * cos(psi), rates[1])
    psi_dot = solved(lambda w1, *_: w1, rates[2]).subs(rates[1], phi_dot)
    by_shape = [reduced(rate.subs(SHAPE)) for rate in (theta_dot, phi_dot, psi_dot)]
    return (
        Step("dθ/dt, from RᵀdR/dt and Ω = M/I", theta_dot),
        Step("dφ/dt", phi_dot),
        Step("dψ/dt", sympy.factor(psi_dot)),
        Step("dθ/dφ", sympy.factor(by_shape[0] / by_shape[1])),
        Step("dψ/dφ", sympy.factor(by_shape[2] / by_shape[1])),
    )


def constant_of_motion() -> tuple[Step, ...]:
    """γ = 2I₂E/M² − 1 in terms of the angles, and its derivative along the planar system."""
    energy = sum(m**2 / moment for m, moment in zip(momentum(), (I1, I2, I3), strict=True)) / 2
    level = reduced((2 * I2 * energy / M**2 - 1).subs(SHAPE))
    *_, along_theta, along_psi = planar_system()
    along = diff(level, theta) * along_theta.result + diff(level, psi) * along_psi.result
    return (
        Step("γ = 2I₂E/M² − 1", level),
        Step("dγ/dφ", sympy.factor(along)),
    )


def integral_in_x() -> tuple[Step, ...]:
    """The integrand −b f(ψ) dψ/dx of the turn on the separatrix, with x = √(b/(a + b)) cos ψ."""
    mu = sqrt(b / (a + b))
    s = Symbol("s", positive=True)  # sin ψ
    turn = (1 - b * s**2) / (sqrt(b) * sqrt(a + b * s**2) * s)
    slope = -mu * s  # dx/dψ
    in_s = sympy.factor(-b * turn / slope)
    square = 1 - x**2 / mu**2  # sin²ψ
    rational = sympy.apart(sympy.cancel((1 - b * square) / square), x)
    root = sympy.factor(sympy.expand(a + b * square))
    outside = sympy.powsimp(sqrt(b) / mu) / sqrt(sympy.cancel(root / (1 - x**2)))
    return (
        Step("−b f(ψ) dψ/dx by s = sin ψ", in_s),
        Step("a + b sin²ψ by x", root),
        Step("(1 − b sin²ψ)/sin²ψ by x", rational),
        Step("the integrand in x", sympy.expand(outside * rational) / sqrt(1 - x**2)),
    )


def antiderivative_of_slope() -> tuple[Step, ...]:
    """∂f/∂γ at γ = 0, and its antiderivative in ψ.

    With t = cos ψ it is A t√(a + b − bt²)/(1 − t²) + B log((√a t + √(a + b − bt²))/√(1 − t²)); the
    two coefficients follow by comparing powers of t.
    """
    sine = Symbol("s", positive=True)
    turn = S * (1 - b * sine**2) / (sqrt(a + b * sine**2) * sqrt(gamma + b * sine**2))
    slope = diff(turn, gamma).subs(gamma, 0)
    w = Symbol("w", positive=True)  # √(a + b − bt²), whose derivative by t is −bt/w
    first, second = symbols("A B")
    square = a + b - b * t**2
    along = [
        diff(t * w / (1 - t**2), t) - b * t / w * t / (1 - t**2),
        (sqrt(a) - b * t / w) / (sqrt(a) * t + w) + t / (1 - t**2),
        -(slope / sine).subs(sine, sqrt(1 - t**2)).subs(sqrt(square), w),
    ]
    left = first * along[0] + second * along[1] - along[2].subs(a + b * (1 - t**2), w**2)
    numerator = sympy.Poly(sympy.numer(sympy.together(left)), w)
    cleared = sum(c * square ** (n // 2) * w ** (n % 2) for (n,), c in numerator.terms())
    powers = sympy.Poly(sympy.expand(cleared), t, w).coeffs()
    found = sympy.solve(powers, (first, second), dict=True)[0]
    size, factor = (sympy.factor(found[c]) for c in (first, second))
    root = sqrt(a + b * sin(psi) ** 2)
    logarithm = log((sqrt(a) * cos(psi) + root) / sin(psi))
    return (
        Step("∂f/∂γ at γ = 0, by s = sin ψ", sympy.factor(slope)),
        Step("A", size),
        Step("B", factor),
        Step("the antiderivative", size * cos(psi) * root / sin(psi) ** 2 + factor * logarithm),
    )


__all__ = [
    "antiderivative_of_slope",
    "constant_of_motion",
    "integral_in_x",
    "planar_system",
]
