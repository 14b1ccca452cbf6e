"""Section 3: the motion of M in Jacobi's elliptic functions.

With the amplitude χ and the parameter m, sn = sin χ, cn = cos χ, dn = √(1 − m sin²χ) and
dχ/dt = p dn, for every 0 < m < 1. Substituted into Euler's equations:

- `rotating_solution` (2I₁E < M² < 2I₂E): M₁, M₂, M₃ are proportional to dn, sn, cn;
- `oscillating_solution` (2I₂E < M² < 2I₃E): they are proportional to cn, sn, dn;
- `separatrix_solution` (2I₂E = M²): they are proportional to sech, tanh, sech;
- `rotating_start`, `oscillating_start`, `separatrix_start`: each M with the given energy and
  length lies on one of these curves, for some χ and some signs; `motions_part_slowly`: each start
  determines the motion uniquely;
- `meeting_point`: the energy ellipsoid and the momentum sphere intersect if 2I₁E ≤ M² ≤ 2I₃E;
  `momentum_between`: only then.
"""

from tresym.proofs import momentum
from tresym.proofs.axioms import AMPLITUDE, MOTION
from tresym.proofs.conditions import ordered_moments

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

chi = Symbol("chi", real=True)
"""The amplitude of the elliptic functions."""

up = 2 * I3 * E - M**2
"""2I₃E − M², positive unless M lies along e₃."""
down = M**2 - 2 * I1 * E
"""M² − 2I₁E, positive unless M lies along e₁."""

_rotating = (*ordered_moments, I3 - I1 > 0, up > 0, down > 0, 2 * I2 * E - M**2 > 0)
_oscillating = (*ordered_moments, I3 - I1 > 0, up > 0, down > 0, M**2 - 2 * I2 * E > 0)

_first = sqrt(I1 * up / (I3 - I1))
_third = sqrt(I3 * down / (I3 - I1))
_second_rotating = sqrt(I2 * down / (I2 - I1))
_second_oscillating = sqrt(I2 * up / (I3 - I2))

_speed_rotating = sqrt((I2 - I1) * up / (I1 * I2 * I3))
_speed_oscillating = sqrt((I3 - I2) * down / (I1 * I2 * I3))

_m_rotating = (I3 - I2) * down / ((I2 - I1) * up)
_m_oscillating = (I2 - I1) * up / ((I3 - I2) * down)


def _delta(m: Expr) -> Expr:
    """dn."""
    return sqrt(1 - m * sin(chi) ** 2)


def _solves(motion: tuple[Expr, Expr, Expr], speed: Expr) -> Tuple:
    """Euler's equations for ``motion`` when dχ/dt = ``speed``."""
    rates = printed.euler_equations(*motion, I1, I2, I3)
    return Tuple(
        *(
            equal(m.diff(chi, evaluate=False) * speed, rate)
            for m, rate in zip(motion, rates, strict=True)
        )
    )


rotating_motion = (_first * _delta(_m_rotating), _second_rotating * sin(chi), _third * cos(chi))

oscillating_motion = (
    _first * cos(chi),
    _second_oscillating * sin(chi),
    _third * _delta(_m_oscillating),
)

_opening = (differentiation, roots)

rotating_solution = Claim(
    says=_solves(rotating_motion, _speed_rotating * _delta(_m_rotating)),
    given=_rotating,
    proof=by(*_opening),
)

oscillating_solution = Claim(
    says=_solves(oscillating_motion, _speed_oscillating * _delta(_m_oscillating)),
    given=_oscillating,
    proof=by(*_opening),
)

_separatrix = (*ordered_moments, I3 - I1 > 0)
_rate = M * sqrt((I2 - I1) * (I3 - I2) / (I1 * I3)) / I2

separatrix_motion = (
    M * sqrt(I1 * (I3 - I2) / (I2 * (I3 - I1))) / cosh(chi),
    M * tanh(chi),
    M * sqrt(I3 * (I2 - I1) / (I2 * (I3 - I1))) / cosh(chi),
)

separatrix_solution = Claim(
    says=_solves(separatrix_motion, _rate),
    given=_separatrix,
    proof=by(*_opening, exponentials),
    note=(
        "M tends to −e₂ backward in time and to +e₂ forward in time; "
        "neither is reached in finite time."
    ),
)

_first_integrals = tuple(
    Tuple(
        equal(printed.energy(*motion, I1, I2, I3), E),
        equal(printed.momentum_squared(*motion), M**2),
    )
    for motion in (rotating_motion, oscillating_motion)
)

rotating_amplitudes = Claim(says=_first_integrals[0], given=_rotating, proof=by(trigonometry))

oscillating_amplitudes = Claim(says=_first_integrals[1], given=_oscillating, proof=by(trigonometry))

separatrix_amplitudes = Claim(
    says=Tuple(
        equal(printed.energy(*separatrix_motion, I1, I2, I3), M**2 / (2 * I2)),
        equal(printed.momentum_squared(*separatrix_motion), M**2),
    ),
    given=_separatrix,
    proof=by(exponentials),
)

_by_integrals = by(substituting(momentum.energy_of_momentum, momentum.eq_first_int))

rotating_start = Claim(
    says=Tuple(
        equal((M2 / _second_rotating) ** 2 + (M3 / _third) ** 2, 1),
        equal(M1**2, _first**2 * (1 - _m_rotating * (M2 / _second_rotating) ** 2)),
    ),
    given=_rotating,
    proof=_by_integrals,
    note="M₂ over its amplitude and the ratio of the other are the sine and the cosine of some χ, "
    "and the third component is dn but for its sign.",
)

oscillating_start = Claim(
    says=Tuple(
        equal((M2 / _second_oscillating) ** 2 + (M1 / _first) ** 2, 1),
        equal(M3**2, _third**2 * (1 - _m_oscillating * (M2 / _second_oscillating) ** 2)),
    ),
    given=_oscillating,
    proof=_by_integrals,
    note="As for the rotating motion, in `rotating_start`.",
)

_off_separatrix = I1 * I3 * (2 * I2 * E - M**2) / (I2 * (I3 - I1))
_shares = I1 * (I3 - I2) / (I2 * (I3 - I1)), I3 * (I2 - I1) / (I2 * (I3 - I1))

separatrix_start = Claim(
    says=Tuple(
        equal(M1**2 - _shares[0] * (M**2 - M2**2), _off_separatrix),
        equal(M3**2 - _shares[1] * (M**2 - M2**2), -_off_separatrix),
    ),
    given=_separatrix,
    proof=_by_integrals,
    note="Where 2I₂E = M² the right sides are 0, and with M₂/M for tanh χ the other two are the "
    "amplitudes over cosh χ, but for their signs.",
)

N1, N2, N3 = _others = tuple(Symbol(f"N{n}", real=True) for n in (1, 2, 3))
_apart = [p - q for p, q in zip((M1, M2, M3), _others, strict=True)]
_rates_apart = [
    p - q
    for p, q in zip(
        printed.euler_equations(M1, M2, M3, I1, I2, I3),
        printed.euler_equations(N1, N2, N3, I1, I2, I3),
        strict=True,
    )
]
_sums = [p + q for p, q in zip((M1, M2, M3), _others, strict=True)]
_squares = [e**2 for e in _apart]


def _coupling(factor: Expr, i: int, j: int, k: int, side: int) -> Expr:
    """factor · (M/2 (dᵢ² + dⱼ²) − side/2 sₖ dᵢ dⱼ), by two squares."""
    room = 2 * M - side * _sums[k], 2 * M + side * _sums[k]
    squares = (_apart[i] + _apart[j]) ** 2, (_apart[i] - _apart[j]) ** 2
    return factor / 8 * (room[0] * squares[0] + room[1] * squares[1])


_rest = (1 / I2 + 1 / I3, 1 / I1 + 1 / I3, (I2 - I1) / (I1 * I2) + 2 / I3)

motions_part_slowly = Claim(
    says=M / I1 * sum(_squares)
    - sum(e * rate for e, rate in zip(_apart, _rates_apart, strict=True))
    >= 0,
    given=(*ordered_moments, *(2 * M + side * s >= 0 for s in _sums for side in (1, -1))),
    proof=(
        step(
            _coupling((I3 - I2) / (I2 * I3), 1, 2, 0, 1)
            + _coupling((I3 - I1) / (I1 * I3), 0, 2, 1, -1)
            + _coupling((I2 - I1) / (I1 * I2), 0, 1, 2, 1)
            + M / 2 * sum(share * square for share, square in zip(_rest, _squares, strict=True))
        ),
    ),
    note="N is another motion with a momentum as long as M. The square of their distance grows at "
    "most as e^{2Mt/I₁}, forward and, by the same bound for −M and −N, backward in time: two "
    "motions that meet are one.",
)

jacobi_solutions = Claim(
    **jointly(
        rotating_solution,
        rotating_amplitudes,
        oscillating_solution,
        oscillating_amplitudes,
        separatrix_solution,
        separatrix_amplitudes,
        rotating_start,
        oscillating_start,
        separatrix_start,
        motions_part_slowly,
    ),
    where=line(90),
    note=(
        "On the separatrix they are hyperbolic functions. The signs "
        "of two components may be changed together."
    ),
    quotes=(
        MOTION,
        AMPLITUDE,
    ),
)

momentum_between = Claim(
    says=Tuple(2 * I3 * E - M**2 >= 0, M**2 - 2 * I1 * E >= 0),
    given=ordered_moments,
    proof=by(substituting(momentum.energy_of_momentum, momentum.eq_first_int)),
)

meeting_point = Claim(
    says=Tuple(
        equal(printed.energy(_first, 0, _third, I1, I2, I3), E),
        equal(printed.momentum_squared(_first, 0, _third), M**2),
    ),
    given=(*ordered_moments, I3 - I1 > 0, up >= 0, down >= 0),
    proof=by(),
    note="Between the two bounds the surfaces intersect in the plane of e₁ and e₃.",
)

intersection_condition = Claim(
    **jointly(momentum_between, meeting_point),
    where=line(96),
    quotes=(MOTION,),
)

solution_on_intersection = Claim(
    **jointly(momentum.two_first_integrals),
    where=line(96),
)

label_claims(globals())
