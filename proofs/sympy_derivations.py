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
    """A step of a derivation: what is derived, in LaTeX, what results, and how."""

    name: str
    result: Expr
    how: str

    @property
    def written(self) -> Expr:
        """The result in symbols of which nothing is assumed, as it is printed."""
        return self.result.xreplace({s: Symbol(s.name) for s in self.result.atoms(Symbol)})


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


def tidied(e: Expr) -> Expr:
    """A product with the factors 1 − b sin²ψ and 1 − x in place of b sin²ψ − 1 and x − 1."""
    sign, found = 1, []
    for factor in sympy.Mul.make_args(sympy.factor(e)):
        base, n = factor.as_base_exp()
        turned = base.is_Add and n.is_Integer and base.as_coeff_Add()[0] < 0
        sign *= (-1) ** n if turned else 1
        found.append((-base) ** n if turned else factor)
    return sign * sympy.Mul(*found)


def reduced(e: Expr) -> Expr:
    """A polynomial in sines and cosines with cos² replaced by 1 − sin², for each angle."""
    for angle in (theta, phi, psi):
        e = sympy.expand(sympy.expand(e).subs(cos(angle) ** 2, 1 - sin(angle) ** 2))
    return e


@cache
def planar_system() -> tuple[Step, ...]:
    """The rates of the Euler angles, and dθ/dφ and dψ/dφ in terms of the shape."""
    rates = symbols("dtheta_dt dphi_dt dpsi_dt", real=True)
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
    spins = (
        Step(rf"\Omega_{n}", e, "an entry of RᵀdR/dt, with R = R_z(φ) R_y(θ) R_z(ψ)")
        for n, e in enumerate(by_rates, 1)
    )
    moments = (
        Step(f"M_{n}", e, "a component of Rᵀ(0, 0, M)ᵀ") for n, e in enumerate(momentum(), 1)
    )
    return (
        *spins,
        *moments,
        Step(r"\dot\theta", theta_dot, "from I₂Ω₂ = M₂ and I₃Ω₃ = M₃, without dφ/dt"),
        Step(r"\dot\phi", phi_dot, "from the same two equations, without dθ/dt"),
        Step(r"\dot\psi", sympy.factor(psi_dot), "from I₁Ω₁ = M₁"),
        Step(
            r"\frac{d\theta}{d\phi}",
            tidied(by_shape[0] / by_shape[1]),
            "their quotient, with I₁ = I₂/(1 + a) and I₃ = I₂/(1 − b)",
        ),
        Step(r"\frac{d\psi}{d\phi}", tidied(by_shape[2] / by_shape[1]), "likewise"),
    )


def constant_of_motion() -> tuple[Step, ...]:
    """γ = 2I₂E/M² − 1 in terms of the angles, and its derivative along the planar system."""
    energy = sum(m**2 / moment for m, moment in zip(momentum(), (I1, I2, I3), strict=True)) / 2
    level = reduced((2 * I2 * energy / M**2 - 1).subs(SHAPE))
    *_, along_theta, along_psi = planar_system()
    along = diff(level, theta) * along_theta.result + diff(level, psi) * along_psi.result
    return (
        Step("E", energy, "from E = M₁²/(2I₁) + M₂²/(2I₂) + M₃²/(2I₃)"),
        Step(r"\gamma", level, "from γ = 2I₂E/M² − 1, in terms of a and b"),
        Step(r"\frac{d\gamma}{d\phi}", sympy.factor(along), "by the chain rule along the system"),
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
        Step(r"-bf(\psi)\frac{d\psi}{dx}", tidied(in_s), "with s for sin ψ"),
        Step(r"a+bs^2", tidied(root), "as s² = 1 − x²(a + b)/b"),
        Step(r"\frac{1-bs^2}{s^2}", rational, "likewise"),
        Step(
            r"-bf(\psi)\frac{d\psi}{dx}",
            sympy.expand(outside * rational) / sqrt(1 - x**2),
            "the integrand in x",
        ),
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
    log_t = log((sqrt(a) * t + sqrt(square)) / sqrt(1 - t**2))
    ansatz = first * t * sqrt(square) / (1 - t**2) + second * log_t
    root = sqrt(a + b * sin(psi) ** 2)
    logarithm = log((sqrt(a) * cos(psi) + root) / sin(psi))
    return (
        Step(
            r"\left.\frac{\partial f}{\partial\gamma}\right|_{\gamma=0}",
            tidied(slope),
            "with s for sin ψ",
        ),
        Step("g", ansatz, "an antiderivative with t for cos ψ, if A and B are right"),
        Step("A", size, "so that dg/dψ is this slope: the powers of t are compared"),
        Step("B", factor, "likewise"),
        Step(
            r"\int\left.\frac{\partial f}{\partial\gamma}\right|_{\gamma=0}d\psi",
            size * cos(psi) * root / sin(psi) ** 2 + factor * logarithm,
            "g with these coefficients",
        ),
    )


def routes() -> tuple[tuple[str, tuple[Step, ...]], ...]:
    """The derivations in the order of the paper, each with a title."""
    return (
        ("The planar system", planar_system()),
        ("The constant of motion", constant_of_motion()),
        ("The integral in x = √(b/(a + b)) cos ψ", integral_in_x()),
        ("The antiderivative of ∂f/∂γ", antiderivative_of_slope()),
    )


__all__ = [
    "antiderivative_of_slope",
    "constant_of_motion",
    "integral_in_x",
    "planar_system",
    "routes",
]
