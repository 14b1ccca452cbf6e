"""Laws of the formulas, each written once: equations whose terms add up to 0 in every arithmetic.

A point is a dictionary of numbers of the arithmetic ``m``: θ, ψ, a, b, M, I₁ < I₂ < I₃, a factor c
and a sign S. What the law says is in its docstring.
"""

from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any

from tresym.racket.formulas import printed, stable

Point = SimpleNamespace
Equations = Sequence[Sequence[Any]]
Law = Callable[[Point, Any], Equations]


def _system(theta: Any, psi: Any, x: Point, m: Any) -> list[Any]:
    """(dθ/dφ, dψ/dφ, γ): what the symmetries carry into itself."""
    rates = printed.planar_rates(theta, psi, x.a, x.b, m)
    return [*rates, printed.depth(theta, psi, x.a, x.b, m)]


def _image(x: Point, m: Any, theta: Any, psi: Any, signs: tuple[int, int]) -> Equations:
    """The system at the image is what it is here, (dθ/dφ, dψ/dφ) with these signs."""
    here, there = _system(x.theta, x.psi, x, m), _system(theta, psi, x, m)
    return [(new, -sign * old) for old, new, sign in zip(here, there, (*signs, 1), strict=True)]


def psi_plus_pi(x: Point, m: Any) -> Equations:
    """ψ → ψ + π changes nothing."""
    return _image(x, m, x.theta, x.psi + m.pi, (1, 1))


def psi_reversed(x: Point, m: Any) -> Equations:
    """ψ → −ψ with the direction of φ reversed: dθ/dφ changes its sign, dψ/dφ keeps it."""
    return _image(x, m, x.theta, -x.psi, (-1, 1))


def theta_reflected(x: Point, m: Any) -> Equations:
    """θ → π − θ with φ reversed (time reversal): dθ/dφ keeps its sign, dψ/dφ changes it."""
    return _image(x, m, m.pi - x.theta, x.psi, (1, -1))


def central(x: Point, m: Any) -> Equations:
    """(θ, ψ) → (π − θ, −ψ): the symmetry about the unstable points."""
    return _image(x, m, m.pi - x.theta, -x.psi, (-1, -1))


def gamma_is_conserved(x: Point, m: Any) -> Equations:
    """∂γ/∂θ dθ/dφ + ∂γ/∂ψ dψ/dφ = 0."""
    rate_theta, rate_psi = printed.planar_rates(x.theta, x.psi, x.a, x.b, m)
    along_theta = -2 * m.sin(x.theta) * m.cos(x.theta) * (x.a + x.b * m.sin(x.psi) ** 2)
    along_psi = -2 * x.b * m.sin(x.theta) ** 2 * m.sin(x.psi) * m.cos(x.psi)
    return [(along_theta * rate_theta, along_psi * rate_psi)]


def momentum_is_conserved(x: Point, m: Any) -> Equations:
    """M · dM/dt = 0."""
    M = printed.momentum(x.theta, x.psi, x.M, m)
    rates = printed.euler_equations(*M, x.I1, x.I2, x.I3)
    return [[a * b for a, b in zip(M, rates, strict=True)]]


def energy_is_conserved(x: Point, m: Any) -> Equations:
    """Ω · dM/dt = 0."""
    M = printed.momentum(x.theta, x.psi, x.M, m)
    rates = printed.euler_equations(*M, x.I1, x.I2, x.I3)
    moments = (x.I1, x.I2, x.I3)
    return [[a * b / c for a, b, c in zip(M, rates, moments, strict=True)]]


def angles_keep_the_momentum(x: Point, m: Any) -> Equations:
    """|M(θ, ψ)|² = M²."""
    M = printed.momentum(x.theta, x.psi, x.M, m)
    return [(printed.momentum_squared(*M), -(x.M**2))]


def gamma_of_the_momentum(x: Point, m: Any) -> Equations:
    """γ by the momentum is γ by the angles, printed or stable."""
    M = printed.momentum(x.theta, x.psi, x.M, m)
    here = printed.depth(x.theta, x.psi, x.a, x.b, m)
    return [
        (here, -stable.depth_from_momentum(*M, x.a, x.b)),
        (here, -stable.depth(x.theta, x.psi, x.a, x.b, m)),
    ]


def scaling(x: Point, m: Any) -> Equations:
    """The unit of the moments does not matter to the shape, nor to dψ/dφ and dθ/dφ."""
    moments = (x.I1, x.I2, x.I3)
    scaled = [x.c * moment for moment in moments]
    one, two = printed.shape(*moments), printed.shape(*scaled)
    slow = printed.angle_rates(x.theta, x.psi, x.c * x.M, *scaled, m)
    fast = printed.angle_rates(x.theta, x.psi, x.M, *moments, m)
    pairs = [*zip(one, two, strict=True), *zip(slow, fast, strict=True)]
    return [(a, -b) for a, b in pairs]


def either_end(x: Point, m: Any) -> Equations:
    """f(π − ψ) = f(ψ): ε(γ) is read from either end of the trajectory."""
    gamma = x.a / 2
    ends = (x.psi, m.pi - x.psi)
    one, two = (printed.integrand(psi, x.a, x.b, gamma, x.S, m) for psi in ends)
    return [(one, -two)]


def gamma_above_minus_b(x: Point, m: Any) -> Equations:
    """γ + b = (a + b) cos²θ + b sin²θ cos²ψ ≥ 0."""
    terms = [
        printed.depth(x.theta, x.psi, x.a, x.b, m) + x.b,
        -(x.a + x.b) * m.cos(x.theta) ** 2,
        -x.b * (m.sin(x.theta) * m.cos(x.psi)) ** 2,
    ]
    return [terms]


def gamma_below_a(x: Point, m: Any) -> Equations:
    """a − γ = sin²θ (a + b sin²ψ) ≥ 0."""
    square = m.sin(x.theta) ** 2
    terms = [
        x.a - printed.depth(x.theta, x.psi, x.a, x.b, m),
        -square * x.a,
        -square * x.b * m.sin(x.psi) ** 2,
    ]
    return [terms]


def psi_is_bounded(x: Point, m: Any) -> Equations:
    """γ + b sin²ψ = (a + b sin²ψ) cos²θ ≥ 0 (eq_borne_psi)."""
    square = m.sin(x.psi) ** 2
    terms = [
        printed.depth(x.theta, x.psi, x.a, x.b, m) + x.b * square,
        -(x.a + x.b * square) * m.cos(x.theta) ** 2,
    ]
    return [terms]


def theta_is_bounded(x: Point, m: Any) -> Equations:
    """γ + b − (a+b) cos²θ = b sin²θ cos²ψ ≥ 0: cos²θ ≤ (γ+b)/(a+b) (eq_borne_theta)."""
    gamma = printed.depth(x.theta, x.psi, x.a, x.b, m)
    terms = [
        gamma + x.b,
        -(x.a + x.b) * m.cos(x.theta) ** 2,
        -x.b * (m.sin(x.theta) * m.cos(x.psi)) ** 2,
    ]
    return [terms]


def no_crossing(x: Point, m: Any) -> Equations:
    """a cos²θ − γ = b sin²θ sin²ψ ≥ 0: cos²θ ≥ γ/a, so cos θ keeps its sign when γ > 0."""
    terms = [
        x.a * m.cos(x.theta) ** 2,
        -printed.depth(x.theta, x.psi, x.a, x.b, m),
        -x.b * (m.sin(x.theta) * m.sin(x.psi)) ** 2,
    ]
    return [terms]


def rigid(x: Point, m: Any) -> Equations:
    """1/(a+2) − b = I₂ (I₁ + I₂ − I₃)/(I₃ (I₁ + I₂)): I₃ ≤ I₁ + I₂ is b ≤ 1/(a+2)."""
    a, b = printed.shape(x.I1, x.I2, x.I3)
    rest = x.I2 * (x.I1 + x.I2 - x.I3) / (x.I3 * (x.I1 + x.I2))
    return [(1 / (a + 2), -b, -rest)]


LAWS: tuple[Law, ...] = (
    psi_plus_pi,
    psi_reversed,
    theta_reflected,
    central,
    scaling,
    either_end,
    gamma_is_conserved,
    momentum_is_conserved,
    energy_is_conserved,
    angles_keep_the_momentum,
    gamma_of_the_momentum,
    gamma_above_minus_b,
    gamma_below_a,
    psi_is_bounded,
    theta_is_bounded,
    no_crossing,
    rigid,
)
