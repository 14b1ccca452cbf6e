"""Section 6: near and on the separatrix, and what becomes of it for a symmetric top.

- `level_of_a_start`: γ from the initial flip angle and rate;
- `turn_to_the_middle`, `time_of_a_turn`: reaching the unstable points takes infinite time, and they
  are never crossed;
- `cotangent_form`, `hyperbolic_sine_at_most`, `angle_below_tangent`: ε₀ → π/2
  as b → 0;
- `separatrix_horizontal`, `separatrix_equilibria`: the separatrix of a top with I₂ = I₃.
"""

from __future__ import annotations

from tresym.proofs import euler_angles, flip_dynamics, phase_portraits, regimes
from tresym.proofs.axioms import MOTION
from tresym.proofs.conditions import defect, ordered_moments, shape, shape_of_a_body, tilted

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

_square = sin(psi) ** 2
_slow, _fast = 1 - b * _square, a + b * _square

# -- near and on the separatrix -------------------------------------------------------------------

level_of_a_start = Claim(
    says=equal(dpsi_dphi**2 * _slow**2 / _fast - b * _square, gamma),
    given=(*tilted, *flip_dynamics.moving),
    proof=by(substituting(flip_dynamics.eq_dpsidphi, flip_dynamics.sign_of_tilt), roots),
    where=line(198),
    note="γ tends to 0 with ψ₀ and the initial rate: such starts are close to the separatrix.",
)

level_is_small = Claim(
    says=Tuple(
        dpsi_dphi**2 / a - (dpsi_dphi**2 * _slow**2 / _fast - b * _square) >= 0,
        dpsi_dphi**2 * _slow**2 / _fast - b * _square + b * _square >= 0,
    ),
    given=shape_of_a_body,
    proof=manifest,
    note="The level of a start, by `level_of_a_start`, between its two bounds.",
)

near_separatrix = Claim(
    **jointly(level_of_a_start, level_is_small),
    where=line(164),
    note="The starts near the separatrix are those from which the racket flips (`two_rectangles`).",
)

separatrix_is_followed = Claim(
    says=Tuple(
        regimes.planar_system.says, Under(regimes.separatrix_case.says, Tuple(*ordered_moments))
    ),
    given=(*tilted, *shape_of_a_body),
    proof=all_of(regimes.planar_system, regimes.separatrix_case),
    where=line(198),
    note="γ is conserved, and it is 0 on the separatrix.",
)

_on_separatrix = _slow / (sqrt(_fast) * sqrt(b) * sin(psi))
_cotangent = _slow * cos(psi) / (sqrt(b) * sqrt(a + b) * sin(psi))

turn_to_the_middle = Claim(
    says=Integral(_on_separatrix, (psi, epsilon, pi / 2))
    >= (-log(sin(epsilon)) - b * cos(epsilon) ** 2 / 2) / (sqrt(b) * sqrt(a + b)),
    given=(*shape_of_a_body, *defect),
    proof=(
        step(
            Integral(_on_separatrix, (psi, epsilon, pi / 2))
            - Integral(_cotangent, (psi, epsilon, pi / 2)),
            integrating((log(sin(psi)) - b * _square / 2) / (sqrt(b) * sqrt(a + b))),
            trigonometry,
            exponentials,
        ),
        step(
            Integral(
                _slow
                * ((a + b) * _square + b * cos(psi) ** 4)
                / (
                    sqrt(b)
                    * sqrt(a + b)
                    * sqrt(_fast)
                    * sin(psi)
                    * (sqrt(a + b) + cos(psi) * sqrt(_fast))
                ),
                (psi, epsilon, pi / 2),
            ),
            collecting(),
        ),
    ),
    note="f is at least (1 − b sin²ψ) cot ψ/√(b(a+b)) on the separatrix. The turn exceeds every "
    "bound as ε → 0.",
)

time_of_a_turn = Claim(
    says=1 / dphi_dt >= I2 / M,
    given=(*ordered_moments, *tilted, *shape_of_a_body),
    proof=by(substituting(euler_angles.precession_rate)),
    note="Hence infinitely many turns take infinite time.",
)

separatrix_infinite_time = Claim(
    **jointly(turn_to_the_middle, time_of_a_turn),
    where=line(198),
    note="From ε to π/2, and so back, it takes at least log(1/sin ε)/√(b(a+b)) − 1, whatever ε.",
    quotes=(MOTION,),
)

cannot_cross = Claim(
    **jointly(separatrix_infinite_time, phase_portraits.separatrix_moves),
    where=line(334),
    note="In between the rate is not 0.",
    quotes=(MOTION,),
)

# -- tops -----------------------------------------------------------------------------------------

_time = sqrt(a * b) * (pi + asin(sqrt(b / (a + b)) * cos(epsilon)))
_cotangent_of_root = sqrt(1 + b / a) * sinh(_time)

cotangent_form = Claim(
    says=Equivalent(
        equal(sqrt(a / (a + b)) / sinh(_time), tan(epsilon)),
        equal(cos(epsilon) / sin(epsilon), _cotangent_of_root),
    ),
    given=(*shape, *defect),
    proof=by(
        multiplying(sqrt((a + b) / a) * sinh(_time) * cos(epsilon) / sin(epsilon)),
        *(roots, trigonometry),
    ),
    note="The reciprocal of the stable equation.",
)

hyperbolic_sine_at_most = Claim(
    says=sinh(3 * pi * k / 2) <= 56 * k, given=(k > 0, k <= 1), proof=manifest
)

angle_below_tangent = Claim(
    says=cos(epsilon) / sin(epsilon) - (pi / 2 - epsilon) >= 0,
    given=defect,
    proof=(
        step(
            Integral(cos(psi) ** 2 / sin(psi) ** 2, (psi, epsilon, pi / 2)),
            integrating(-cos(psi) / sin(psi) - psi),
            trigonometry,
        ),
    ),
    note="x ≤ tan x for x = π/2 − ε between 0 and π/2.",
)


separatrix_horizontal = Claim(
    says=equal(at(printed.psi_rate(psi, a, b, 0, S, sympy), {b: 0}), 0),
    given=(a > 0,),
    proof=by(evaluating, roots),
    where=line(249),
    note="On γ = 0, for b = 0: the line dψ/dφ = 0.",
)

separatrix_equilibria = Claim(
    says=Tuple(
        *(
            equal(at(rate, {theta: pi / 2, b: 0}), 0)
            for rate in printed.planar_rates(theta, psi, a, b, sympy)
        )
    ),
    given=(a > 0,),
    proof=by(evaluating, trigonometry),
    where=line(249),
    note="For b = 0 every point of the separatrix, θ = π/2, is an equilibrium.",
)

only_way_half_pi = Claim(
    says=Equivalent(equal(pi - epsilon, epsilon), equal(pi / 2, epsilon)),
    proof=(
        step(equal(pi, 2 * epsilon), adding(epsilon)),
        step(equal(pi / 2, epsilon), multiplying(sympy.Rational(1, 2))),
    ),
    where=line(249),
    note="At the equilibrium ψ_f = ψ₀; the symmetric motion then starts at π/2.",
)

label_claims(globals())
