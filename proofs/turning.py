"""Beyond the paper: an oscillating motion followed through its turning points.

At the turning points f is infinite, so F does not describe the motion beyond them. With

    Q = a + b sin²χ − γ cos²χ,  R = ab cos²χ − γ(b + a sin²χ),
    N = (1−b)(a−γ) cos²χ + (a+b)(1+γ) sin²χ,

none of which is negative for γ < 0, the curve

    cot ψ = √((a+b)(γ+b)/R) sin χ,  cos θ = √((γ+b)/(a+b)) cos χ

is the motion (`unfolded_motion`): it turns at χ = π/2, 3π/2, … and is at ψ = π/2 at χ = 0, π, ….
The precession back from χ = 0 is Φ(χ, γ) = ∫₀^χ N/(Q√R) dx, which equals F until the motion turns
(`unfolded_turn`), and ε(γ) is the ψ at which Φ(χ, γ) = π:

- `longest_turn`: F(e, γ) is less than Φ of the motion that turns at e, for every γ;
- `unfolded_decrease`: χ decreases as γ increases, while 0 < χ < π;
- `turned_decrease`: dε/dγ < 0 for π/2 ≤ χ < π, after the first turning point;
- `beyond_right_angle`: ε > π/2 for π < χ < 2π;
- `slope_at_turns`: dε/dγ is ∓1/(2√(−γ(γ+b))) at χ = π/2 and 3π/2: at the latter ε increases;
- `phase_at_bottom`: Φ(π, −b) = π(1−b)/√(b(a+b)); `body_stays_below`, `others_do_not`: it is at
  least π exactly for b ≤ 1/(a+2).
"""

from __future__ import annotations

from tresym.proofs.conditions import shape

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

c = Symbol("c", real=True)
"""A level, where γ is held."""
chi, chi_rate = (Symbol(name, real=True) for name in ("chi", "chiprime"))
"""The variable in which the motion passes its turning points smoothly, and dχ/dγ."""


class _Unfolded:
    """The motion on ``level`` < 0 as a function of χ = ``angle``; see the module docstring."""

    def __init__(self, level: Expr, angle: Expr) -> None:
        square, rest = sin(angle) ** 2, cos(angle) ** 2
        self.Q = a + b * square - level * rest
        self.R = a * b * rest - level * (b + a * square)
        self.N = (1 - b) * (a - level) * rest + (a + b) * (1 + level) * square
        self.rate = self.N / (self.Q * sqrt(self.R))
        self.growth = (a + b) ** 2 * square / (self.Q**2 * sqrt(self.R)) + self.N * (
            b + a * square
        ) / (2 * self.Q * sqrt(self.R) ** 3)
        self.flip = pi / 2 - atan(sqrt(a + b) * sqrt(level + b) * sin(angle) / sqrt(self.R))
        self.tilt = acos(sqrt((level + b) / (a + b)) * cos(angle))


_here, _end = _Unfolded(gamma, x), _Unfolded(gamma, chi)
oscillating = (*shape, gamma > -b, gamma < 0)
half_time = (chi > 0, chi < pi, sin(chi) > 0)
"""Before the motion is back at ψ = π/2; the last condition says it to the sign procedure."""

_rates = printed.planar_rates(_here.tilt, _here.flip, a, b, sympy)

unfolded_motion = Claim(
    says=Tuple(
        equal(Derivative(_here.tilt, x), -_here.rate * _rates[0]),
        equal(Derivative(_here.flip, x), -_here.rate * _rates[1]),
    ),
    given=(*oscillating, b < 1),
    proof=by(differentiation, trigonometry, roots),
    note=(
        "The curve solves the planar system, with φ decreasing at "
        "the rate N/(Q√R), and passes ψ = π/2 at χ = 0."
    ),
)

phase = Integral(_here.rate, (x, 0, chi))
"""Φ(χ, γ), the precession from χ to ψ = π/2."""

unfolded_turn = Claim(
    says=equal(
        Integral(printed.integrand(psi, a, b, gamma, 1, sympy), (psi, _end.flip, pi / 2)), phase
    ),
    given=(*oscillating, chi > 0, chi < pi / 2),
    knowing=(Under(gamma + b * sin(_here.flip) ** 2 > 0, (x >= 0, x <= chi)),),
    proof=by(changing_variable(_here.flip)),
    note="Before the first turning point Φ equals F.",
)

edge, higher = Symbol("e", real=True), Symbol("d", real=True)
"""Where a motion turns, and how far a level is above its own."""
_level, _edge = higher - b * sin(edge) ** 2, _Unfolded(-b * sin(edge) ** 2, x)
_steep = sqrt(b * (a + b * sin(edge) ** 2) / _edge.Q) * cos(edge) * cos(x)
"""√(γ + b sin²ψ) on the curve that turns at e."""
_room = sqrt(higher + _steep**2)
raised = (*shape, edge > 0, edge < pi / 2, sin(edge) > 0, cos(edge) > 0, higher > 0)

level_on_the_curve = Claim(
    says=_level + b * sin(_edge.flip) ** 2 > 0,
    given=(*raised, x >= 0, x <= pi / 2),
    proof=(step(higher + _steep**2, trigonometry),),
)

longest_turn = Claim(
    says=Integral(printed.integrand(psi, a, b, _level, 1, sympy), (psi, edge, pi / 2))
    <= Integral(_edge.rate, (x, 0, pi / 2)),
    given=raised,
    proof=(
        step(
            Integral(_edge.rate, (x, 0, pi / 2))
            - Integral(_edge.rate * _steep / _room, (x, 0, pi / 2)),
            changing_variable(_edge.flip, level_on_the_curve),
        ),
        step(
            Integral(_edge.rate * higher / (_room * (_room + _steep)), (x, 0, pi / 2)),
            collecting(),
        ),
    ),
    shown=r"\int_e^{\frac{\pi}{2}}f(\psi, \gamma)\,d\psi \le "
    r"\Phi\left(\frac{\pi}{2}, -b\sin^2e\right),\quad \gamma = d-b\sin^2e",
    note="F decreases as the level increases, from Φ of the motion that turns at e.",
)


def _phase(level: Expr, end: Expr = chi) -> Integral:
    return Integral(_Unfolded(level, x).rate, (x, 0, end))


_phase_by_depth = Subs(Derivative(_phase(c), c), c, gamma)

_y = Symbol("y", real=True)

precession_goes_on = Claim(
    says=Tuple(
        (1 - b) * (a - gamma) * (1 - _y) + (a + b) * (1 + gamma) * _y > 0,
        a * b * (1 - _y) - gamma * (b + a * _y) > 0,
    ),
    given=(*oscillating, b < 1, _y >= 0, _y <= 1),
    proof=manifest,
    note="The signs of N and R, with y for sin²χ.",
)

_always = Instance(precession_goes_on, ((_y, sin(chi) ** 2),))
_signs = parts_of(_always.says)
precession_never_stops = Claim(says=_always.says, given=(*oscillating, b < 1), proof=_always)

_one_time = AtMostOne(chi, 0, 8 * pi, equal(phase, pi))

one_time = Claim(
    says="The precession reaches half a turn at one time at most, however often the motion turns.",
    means=_one_time,
    given=(*oscillating, b < 1),
    proof=Monotone(
        (
            step(_end.rate, differentiating_integral(Integer(0))),
            step(
                _signs[0].gts / (_end.Q * sqrt(_signs[1].gts)),
                trigonometry,
                citing(precession_never_stops),
            ),
        )
    ),
    note="Φ increases with χ.",
)

flip_defect_on_level = _end.flip.xreplace({chi: TheRoot(*_one_time.args)})
"""ε(γ) for γ < 0: ψ where Φ(χ, γ) = π."""

_grows = differentiating_integral(_here.growth)
_by_end = differentiating_integral(Integer(0))

phase_rises_in_gamma = Claim(
    says=_phase_by_depth > 0,
    given=(*oscillating, *half_time),
    proof=(step(Integral(_here.growth, (x, 0, chi)), _grows),),
)

half_a_turn_before = Claim(
    says=equal(_phase(c), pi),
    given=(*shape, c > -b, c < 0, *half_time),
    proof=Definition(assumes="half a turn of the handle, at the time chi before psi = pi/2"),
    note="The point at which ε is defined.",
)

unfolded_slope = Claim(
    says=equal(chi_rate, -_phase_by_depth / Derivative(_phase(gamma), chi)),
    given=(*oscillating, *half_time),
    proof=ImplicitFunction(half_a_turn_before, chi, c, gamma, (step(_end.rate, _by_end),)),
)

unfolded_decrease = Claim(
    says=chi_rate < 0,
    given=(*oscillating, *half_time),
    proof=(
        step(
            Integral(_here.growth, (x, 0, chi)) / _end.rate,
            substituting(unfolded_slope),
            *(_grows, _by_end, roots),
        ),
    ),
)

# -- once it has turned ---------------------------------------------------------------------------

slope_of_defect = Derivative(_end.flip, gamma) + Derivative(_end.flip, chi) * chi_rate
"""dε/dγ, as ε = ψ(χ(γ), γ)."""
turned = (*oscillating, chi >= pi / 2, chi < pi, sin(chi) > 0, cos(chi) <= 0, chi > 0)
"""The motion has turned once, and is not yet back at ψ = π/2."""

turned_decrease = Claim(
    says=slope_of_defect < 0, given=turned, proof=by(differentiation, citing(unfolded_decrease))
)

beyond_right_angle = Claim(
    says=_end.flip - pi / 2 > 0, given=(*oscillating, sin(chi) < 0), proof=manifest
)

_steep = 1 / (2 * sqrt(-gamma) * sqrt(b + gamma))

slope_at_turns = Claim(
    says=Tuple(
        equal(at(slope_of_defect, {chi: pi / 2}), -_steep),
        equal(at(slope_of_defect, {chi: 3 * pi / 2}), _steep),
    ),
    given=oscillating,
    proof=by(differentiation, trigonometry, roots),
)

# -- near the bottom ------------------------------------------------------------------------------

_slow = pi * (1 - b) / sqrt(b * (a + b))

phase_at_bottom = Claim(
    says=equal(_phase(-b, pi), _slow),
    given=shape,
    proof=(
        step(Integral((1 - b) / sqrt(b * (a + b)), (x, 0, pi)), collecting()),
        step(None, integrating(x * (1 - b) / sqrt(b * (a + b)))),
    ),
)

body_stays_below = Claim(says=_slow - pi >= 0, given=(*shape, 1 - b * (a + 2) >= 0), proof=manifest)

others_do_not = Claim(says=_slow - pi < 0, given=(*shape, b * (a + 2) - 1 > 0), proof=manifest)

near_right_angle = Claim(
    says=(b + gamma) / -gamma - tan(pi / 2 - _end.flip) ** 2 >= 0,
    given=oscillating,
    proof=manifest,
    note="ε(γ) lies between the turning points, and tends to π/2 as γ tends to −b.",
)

# -- the level at which a flip defect is reached after a turn --------------------------------------

_start, _rest = sin(epsilon) ** 2, cos(epsilon) ** 2
_above = c + b * _start
"""How far the level is above the one that turns at ε."""
_deep = _above + b * _rest
_sines = b * (a - c) * _rest / (_deep * (a + b * _start))
_cosines = (a + b) * _above / (_deep * (a + b * _start))
_last = pi - asin(sqrt(_sines))
"""χ at which the flip angle is ε, after the motion has turned; its squared sine and cosine."""
_on_level, _there = _Unfolded(c, x), _Unfolded(c, _last)
_moves = sqrt(_sines) * (a + b) / (2 * (a - c) * _deep * sqrt(_cosines))
_Q = a + b * _sines - c * _cosines
_R = a * b * _cosines - c * (b + a * _sines)
_N = (1 - b) * (a - c) * _cosines + (a + b) * ((1 - b) + _deep) * _sines
_fall_short = (*shape, epsilon > 0, epsilon < pi / 2, sin(epsilon) > 0, cos(epsilon) > 0)

one_turned_level = Claim(
    says="A flip defect of a motion that has turned once belongs to one γ at most.",
    means=AtMostOne(c, -b * _start, 0, equal(Integral(_on_level.rate, (x, 0, _last)), pi)),
    given=_fall_short,
    knowing=(Under(b + c > 0, (c > -b * _start,)),),
    proof=Monotone(
        (
            step(
                Integral(_on_level.growth, (x, 0, _last)) + _there.rate * _moves,
                differentiating_integral(_on_level.growth),
                *(differentiation, roots, trigonometry, inverses),
            ),
            step(
                Integral(_on_level.growth, (x, 0, _last)) + _N / (_Q * sqrt(_R)) * _moves,
                *(roots, trigonometry, inverses),
            ),
        )
    ),
    note="Φ increases with γ, here c, and so does χ.",
)

label_claims(globals())
