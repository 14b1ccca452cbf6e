"""The flip defect ε₀ near its leading term: symbols, and what the steps of margins are in them.

- `flip_defect` (in `separatrix`) defines ε₀; `phase` its phase P = T/√(ab), `leading_term` ε*,
  `exponent_of_defect` Q = log(ε₀/ε*), `first_coefficient` c₁, `second_coefficient` c₂;
- `phase_equation`, `defect_by_phase`, `leading_by_defect`: the relations between them;
- the readings identify the steps of the formulas in `tresym.racket.bounds` with these symbols, in
  the two charts (b, κ), κ = 1/√(ab), and (b, k), k = √(ab);
- `half_tangent_at_root`: tan(ε₀/2) by ε*, hence `leading_below`: ε₀ > 2 arctan(ε*/2), and
  ε₀/ε* > 1 − ε*²/12, for every shape;
- `cotangent_at_root`: cot ε₀ by the phase, hence `b_to_zero`: ε₀ → π/2 as b → 0.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from sympy import Mul, Pow
from tresym.proofs import exponent, on_the_separatrix, separatrix, sweeps
from tresym.proofs.conditions import shape

from tresym.ledger.evidence.chart_bounds import Reading
from tresym.ledger.evidence.remainders import Remainder
from tresym.ledger.vocabulary import *
from tresym.racket.bounds import charts
from tresym.racket.flip.series import coefficients_sympy
from tresym.racket.notation import *
from tresym.reals.numbers.exact import as_rational

_mu = sqrt(b / (a + b))
_ratio = sqrt(b / a)
_sine, _cosine = sin(epsilon0), cos(epsilon0)
_root = sqrt(1 + b / a * _sine**2)

_tangent = tanh(sqrt(a * b) * P)
_at_root = citing(separatrix.flip_defect)
"""That ε₀ lies between 0 and π/2."""

phase = Claim(says=equal(P, pi + asin(_mu * _cosine)), given=shape, proof=Definition())

phase_equation = Claim(
    says=equal(P, pi + atan(_ratio * tanh(sqrt(a * b) * P))),
    given=shape,
    proof=(
        step(pi + asin(_mu * _cosine), substituting(phase)),
        step(pi + atan(_ratio * _cosine / _root), inverses, roots, trigonometry),
        step(None, substituting(phase, separatrix.flip_defect)),
    ),
)
phase_range = Claim(
    says=Tuple(pi <= P, 3 * pi / 2 >= P),
    given=shape,
    proof=by(substituting(phase), citing(separatrix.flip_defect)),
)

angle_of_tangent = Claim(
    says=equal(atan(tan(epsilon0)), epsilon0),
    given=(epsilon0 > 0, epsilon0 < pi / 2),
    proof=by(inverses, trigonometry),
)

defect_by_phase = Claim(
    says=equal(epsilon0, atan(1 / (sqrt(1 + b / a) * sinh(sqrt(a * b) * P)))),
    given=shape,
    proof=(
        step(atan(tan(epsilon0)), _at_root, substituting(angle_of_tangent)),
        step(
            atan(sqrt(1 - (_cosine / _root) ** 2) / (sqrt(1 + b / a) * (_cosine / _root))),
            *(_at_root, roots, trigonometry),
        ),
        step(
            atan(sqrt(1 - _tangent**2) / (sqrt(1 + b / a) * _tangent)),
            *(substituting(phase, separatrix.flip_defect), _at_root, roots),
        ),
        step(None, citing(phase_range), exponentials, roots),
    ),
)

_sinh = _tangent / sqrt(1 - _tangent**2)
_share = _cosine / _root

phase_by_defect = Claim(
    says=equal(P, asinh(sqrt(a / (a + b)) * _cosine / _sine) / sqrt(a * b)),
    given=shape,
    proof=(
        step(asinh(_sinh) / sqrt(a * b), exponentials, inverses, roots),
        step(
            asinh(_share / sqrt(1 - _share**2)) / sqrt(a * b),
            *(substituting(phase, separatrix.flip_defect), _at_root, roots),
        ),
        step(None, _at_root, roots, trigonometry),
    ),
)

quarter = (*shape, a * b >= Rational(1, 4))
"""ab ≥ 1/4, 0 < b ≤ 1."""
_wait = pi + asin(_mu * _cosine)
_time = asinh(sqrt(a / (a + b)) * _cosine / _sine)
_in_range = citing(separatrix.flip_defect, separatrix.defect_range)

ratio_bounded = Claim(
    says=_ratio <= 2 * b,
    given=quarter,
    proof=(
        step(2 * _ratio * (sqrt(a * b) - Rational(1, 2)), roots),
        step(2 * _ratio * (a * b - Rational(1, 4)) / (sqrt(a * b) + Rational(1, 2)), roots),
    ),
)

kappa_bounded = Claim(
    says=1 / sqrt(a * b) <= 2,
    given=quarter,
    proof=(
        step(2 * (a * b - Rational(1, 4)) / (sqrt(a * b) * (sqrt(a * b) + Rational(1, 2))), roots),
    ),
)

time_by_b = Claim(
    says=b * _wait <= _ratio * _time,
    given=shape,
    proof=(
        step(_ratio * sqrt(a * b) * P - b * _wait, substituting(phase_by_defect), roots, _in_range),
        step(b * (P - _wait), roots),
        step(Integer(0), substituting(phase)),
    ),
    note="Both sides are equal; this half bounds ε₀ from above.",
)

time_is_long = Claim(
    says=_wait / 2 <= _time,
    given=quarter,
    proof=(
        step(sqrt(a * b) * P - _wait / 2, substituting(phase_by_defect), roots, _in_range),
        step(
            (a * b - Rational(1, 4)) * _wait / (sqrt(a * b) + Rational(1, 2)),
            *(substituting(phase), roots),
        ),
    ),
)

turn_logarithm = Claim(
    says=equal(
        log((sqrt(a) * _cosine + sqrt(a + b * _sine**2)) / _sine),
        sqrt(a * b) * _wait + log(sqrt(a + b)),
    ),
    given=shape,
    proof=(
        step(
            log(sqrt(a / (a + b)) * (_cosine + _root) / _sine) + log(sqrt(a + b)),
            *(exponentials, roots, _in_range),
        ),
        step(_time + log(sqrt(a + b)), exponentials, inverses, roots, trigonometry, _in_range),
        step(sqrt(a * b) * P + log(sqrt(a + b)), substituting(phase_by_defect), roots, _in_range),
        step(None, substituting(phase)),
    ),
)

BY_RATIO = InVariables({r: _ratio}, {a: b / r**2}, (r > 0, r <= 2 * b))
"""Statements in b and r = √(b/a), on ab ≥ 1/4."""
BY_LAMBDA = InVariables({kappa: 1 / sqrt(a * b)}, {a: 1 / (b * kappa**2)}, (kappa > 0, kappa <= 2))
"""Statements in b and κ = 1/√(ab), on ab ≥ 1/4."""

defect_bounded = Claim(
    says=epsilon0 <= Rational(21, 50) - Rational(31, 100) * b,
    given=quarter,
    proof=Decided(
        cited=(
            separatrix.flip_defect,
            separatrix.defect_range,
            ratio_bounded,
            time_is_long,
            time_by_b,
        ),
        variables=BY_RATIO,
    ),
    kind="bound",
)
defect_between = Claim(
    says=Tuple(epsilon0 > 0, epsilon0 <= Rational(21, 50) - Rational(31, 100) * b),
    given=quarter,
    proof=follows(by(citing(separatrix.flip_defect)), all_of(defect_bounded)),
)

_turn = asin(_ratio * _sine**2 / (_cosine + _root))

leading_term = Claim(
    says=equal(epsilon_star, 2 * sqrt(a / (a + b)) * exp(-sqrt(a * b) * (pi + asin(_mu)))),
    given=shape,
    proof=Definition(),
)

exponent_of_defect = Claim(
    says=equal(Q, log(epsilon0 / _sine) + log((_cosine + _root) / 2) + sqrt(a * b) * _turn),
    given=(*shape, epsilon0 > 0, epsilon0 < pi / 2, _sine > 0, _cosine > 0),
    proof=Definition(),
)
turn_by_cosine = Claim(
    says=equal(
        asin(_mu), asin(_mu * x) + asin(_ratio * (1 - x**2) / (x + sqrt(1 + b / a * (1 - x**2))))
    ),
    given=(*shape, x > 0, x < 1),
    proof=by(inverses, roots, trigonometry),
)

_turn_at_root = Instance(turn_by_cosine, ((x, _cosine),), (separatrix.flip_defect,))

turn_at_root = Claim(says=_turn_at_root.says, given=shape, proof=_turn_at_root)

turn_as_one = Claim(
    says=equal(asin(_mu), asin(_mu * _cosine) + _turn),
    given=shape,
    proof=by(substituting(turn_at_root), _at_root, trigonometry),
)

decay_at_root = Claim(
    says=equal(exp(-sqrt(a * b) * P), sqrt(1 + b / a) * _sine / (_cosine + _root)),
    given=shape,
    proof=(
        step(sqrt((1 - _tangent) / (1 + _tangent)), exponentials, roots),
        step(
            sqrt((1 - _cosine / _root) / (1 + _cosine / _root)),
            substituting(phase, separatrix.flip_defect),
            _at_root,
        ),
        step(None, _at_root, roots, trigonometry),
    ),
)

_over = sqrt(1 + b / a) * _sine / (_cosine + _root)
_time = sqrt(a * b) * (pi + asin(_mu * _cosine))

decay_once = Claim(
    says=equal(exp(-_time), _over),
    given=shape,
    proof=(
        step(exp(-sqrt(a * b) * P), substituting(phase)),
        step(None, substituting(decay_at_root), _at_root),
    ),
)

decay_by_defect = Claim(
    says=Tuple(decay_once.says, equal(exp(-2 * _time), _over**2)),
    given=shape,
    proof=together(
        by(substituting(decay_once), _at_root),
        (
            step(Pow(exp(-_time), 2, evaluate=False), exponentials),
            step(None, substituting(decay_once), _at_root, roots),
        ),
    ),
)

leading_by_defect = Claim(
    says=equal(epsilon_star, epsilon0 * exp(-Q)),
    given=shape,
    proof=(
        step(
            2 * sqrt(a / (a + b)) * exp(-sqrt(a * b) * P) * exp(-sqrt(a * b) * _turn),
            substituting(leading_term, phase, turn_as_one),
            *(_at_root, exponentials),
        ),
        step(
            2 * _sine / (_cosine + _root) * exp(-sqrt(a * b) * _turn),
            substituting(decay_at_root),
            *(_at_root, roots),
        ),
        step(None, substituting(exponent_of_defect), _at_root, exponentials),
    ),
)

first_coefficient = Claim(
    says=equal(c1, (6 * b - 1 + 3 * b / a) / 12), given=shape, proof=Definition()
)

second_coefficient = Claim(
    says=equal(c2, coefficients_sympy(2)[2].as_expr(b, b / a)), given=shape, proof=Definition()
)

exponent_is_logarithm = Claim(
    says=equal(Q, log(epsilon0 / epsilon_star)),
    given=shape,
    proof=by(substituting(leading_by_defect), _at_root, exponentials),
)

ROOT = (separatrix.flip_defect, separatrix.defect_range)
BY_KAPPA = (b, 1 / sqrt(a * b))
"""The chart (b, κ): a = 1/(bκ²)."""
AT_ROOT = (epsilon0, b, sqrt(b / a))

phase_in_kappa = Reading(
    charts.phase_by_kappa, BY_KAPPA, P, shape, (phase_equation,), (phase_range,)
)
defect_in_kappa = Reading(
    charts.defect_by_kappa,
    BY_KAPPA,
    epsilon0,
    shape,
    (defect_by_phase,),
    (phase_range,),
    (phase_in_kappa,),
)
rate_at_root = Reading(
    charts.exponent_rate, AT_ROOT, Q / epsilon0**2, shape, (exponent_of_defect,), ROOT
)
bend_at_root = Reading(
    charts.exponent_bend,
    AT_ROOT,
    (Q / epsilon0**2 - c1) / epsilon0**2,
    shape,
    (exponent_of_defect, first_coefficient),
    ROOT,
)
_q2 = (
    50 * b**2 + 40 * b * (b / a) + 5 * (b / a) ** 2 - 20 * b - 10 * b / a + 1
) / 80 - c1**2 * 5 / 2
twist_at_root = Reading(
    charts.exponent_twist,
    AT_ROOT,
    ((Q / epsilon0**2 - c1) / epsilon0**2 - _q2) / epsilon0**2,
    shape,
    (exponent_of_defect, first_coefficient),
    ROOT,
)
leading_in_kappa = Reading(
    charts.leading_square_over,
    BY_KAPPA,
    epsilon_star**2 * a * b,
    (*shape, a * b >= Rational(1, 9)),
    (leading_term,),
)
BY_K = (b, sqrt(a * b))
"""The chart (b, k): a = k²/b."""
phase_in_k = Reading(charts.phase_over, BY_K, P, shape, (phase_equation,), (phase_range,))
defect_in_k = Reading(
    charts.defect_by_k, BY_K, epsilon0, shape, (defect_by_phase,), (phase_range,), (phase_in_k,)
)
_sweep_turn = atan(_ratio * tanh(sqrt(a * b) * P))
_w = sqrt(1 + b / a) * sinh(sqrt(a * b) * P)

turn_of_phase = Claim(
    says=equal(_sweep_turn, P - pi),
    given=shape,
    proof=(
        step(atan(_ratio * (_cosine / _root)), substituting(phase, separatrix.flip_defect)),
        step(asin(_mu * _cosine), inverses, roots, trigonometry),
        step(None, substituting(phase)),
    ),
)

_share_in_k = Mul(b, Pow(sqrt(a * b), -1, evaluate=False), evaluate=False)
"""r, as it is written in the chart (b, k)."""

turn_in_k = Claim(
    says=equal(atan(Mul(_share_in_k, tanh(sqrt(a * b) * P), evaluate=False)), P - pi),
    given=shape,
    proof=(step(_sweep_turn, roots), step(None, substituting(turn_of_phase))),
)

_rate_in_kappa = Mul(P, Pow(1 / sqrt(a * b), -1, evaluate=False), evaluate=False)

turn_in_kappa = Claim(
    says=equal(atan(b / sqrt(a * b) * tanh(_rate_in_kappa)), P - pi),
    given=shape,
    proof=(step(_sweep_turn, roots), step(None, substituting(turn_of_phase))),
)

difference_of_turns = Claim(
    says=equal(atan((x - x0) / (1 + x * x0)), atan(x) - atan(x0)),
    given=(x > 0, x0 > 0),
    knowing=(pi / 2 - atan(x) + atan(x0) > 0, pi / 2 + atan(x) - atan(x0) > 0),
    proof=by(inverses, trigonometry),
)

angle_and_cotangent = Claim(
    says=equal(atan(1 / x), pi / 2 - atan(x)), given=(x > 0,), proof=by(inverses)
)
_complement = Instance(angle_and_cotangent, ((x, _w),), (phase_range,))
complement_at_root = Claim(says=_complement.says, given=shape, proof=_complement)

defect_by_cotangent = Claim(
    says=equal(epsilon0, pi / 2 - atan(_w)),
    given=shape,
    proof=by(substituting(defect_by_phase, complement_at_root)),
)

cotangent_in_k = Reading(charts.cotangent, (*BY_K, P), _w, shape, cited=(phase_range,))
angle_in_k = Reading(charts.angle_of, (_w,), epsilon0, shape, (defect_by_phase,), (phase_range,))


def _sweep(
    start: Expr, swept: Claim, ends: Symbol
) -> tuple[tuple[Reading, ...], tuple[Claim, ...]]:
    """The steps of the error of a sweep, and the differences of angles in it."""
    k_ = sqrt(a * b)
    turn = _ratio * tanh(k_ * start)
    known: dict[str, Any] = {"given": shape, "cited": (phase_range,)}
    turns = Instance(difference_of_turns, ((x, _ratio * _tangent), (x0, turn)), (phase_range,))
    one = Claim(f"turns_from_{start}", turns.says, turns, given=shape)
    left = turns.says.args[0]
    gap = P - pi - atan(turn)
    gained = Claim(
        f"sweep_from_{start}_misses",
        equal(left, gap),
        by(substituting(one, turn_of_phase)),
        given=shape,
    )
    end = sqrt(1 + b / a) * sinh(k_ * (pi + atan(turn)))
    angles = Instance(difference_of_turns, ((x, 1 / end), (x0, 1 / _w)), (phase_range,))
    two = Claim(f"angles_from_{start}", angles.says, angles, given=shape)
    apart = angles.says.args[0]
    beyond = Claim(
        f"sweep_from_{start}_exceeds",
        equal(apart, ends - epsilon0),
        by(substituting(two, swept, defect_by_phase), citing(phase_range)),
        given=shape,
    )
    error = sinh(k_ * P) / sinh(k_ * (pi + atan(turn))) - 1
    readings = (
        Reading(charts.sweep_difference, (*BY_K, P, start), left, **known),
        Reading(charts.tangent_error, (left, P, k_), error, claims=(gained,), **known),
        Reading(charts.angle_difference, (error, _w), apart, **known),
        Reading(charts.far_difference, (*BY_KAPPA, P, start), k_ * left, **known),
        Reading(charts.far_error, (k_ * left, P, 1 / k_), error, claims=(gained,), **known),
        Reading(
            charts.far_angle_error,
            (error, 1 / _w),
            apart / epsilon0,
            claims=(defect_by_phase,),
            **known,
        ),
    )
    return readings, (one, gained, two, beyond)


_from_pi, misses_from_pi = _sweep(pi, sweeps.sweep_from_pi, epsilon_pi)
_from_four, misses_from_four = _sweep(Integer(4), sweeps.sweep_from_four, epsilon_4)

tangent_in_kappa = Reading(
    charts.tangent_by_kappa, (*BY_KAPPA, P), 1 / _w, shape, cited=(phase_range,)
)

READINGS = (
    cotangent_in_k,
    angle_in_k,
    tangent_in_kappa,
    *_from_pi,
    *_from_four,
    phase_in_k,
    defect_in_k,
    phase_in_kappa,
    defect_in_kappa,
    rate_at_root,
    bend_at_root,
    twist_at_root,
    leading_in_kappa,
)

KAPPA = box((0, 1), (0, 2))
"""The chart (b, κ) of it."""


def within(
    error: Callable[..., Any], limit: fmpq, over: Expr, slopes: bool = False
) -> tuple[Shown, ...]:
    """The two margins of |error| ≤ limit, multiplied by ``over``."""
    return (
        Shown(lambda *at: limit - error(*at), over, slopes=slopes),
        Shown(lambda *at: limit + error(*at), over, slopes=slopes),
    )


def bound(
    label: str,
    says: Basic,
    *on: On,
    put: tuple[Claim, ...] = (leading_by_defect,),
    also: tuple[Claim, ...] = (),
    cited: tuple[Claim, ...] = (),
    readings: tuple[Reading, ...] = READINGS,
    constant: str | None = None,
    remainder: Remainder | None = None,
    **rest: Any,
) -> Claim:
    """A bound shown by the charts ``on``, with the claims ``put`` substituted."""
    proof = Charted(on, readings, put, (*ROOT, phase_range, *cited), certificate(label), also=also)
    proof = replace(proof, remainder=remainder)
    if constant is not None:
        proof = replace(proof, constant=as_rational(constant))
    return Claim(label=label, says=says, proof=proof, **rest)


def below(
    label: str,
    size: Expr,
    limit: str,
    gauge: Expr,
    error: Callable[..., Any],
    given: tuple[Basic, ...] = quarter,
    chart: tuple[tuple[Expr, ...], Any] = (BY_KAPPA, KAPPA),
    slopes: bool = False,
    printed_as: Basic | None = None,
    remainder: Remainder | None = None,
    **rest: Any,
) -> Claim:
    """|size| ≤ limit · gauge, where ``error`` is size/gauge in the chart.

    ``printed_as`` is the paper's version, if it leaves an order open, and ``remainder`` says how
    that is interpreted.
    """
    shown = within(error, as_rational(limit), gauge, slopes)
    says = Abs(size) <= Rational(limit) * gauge
    if printed_as is not None:
        rest["means"], says = says, printed_as
    on = On(*chart, shown)
    return bound(label, says, on, given=given, constant=limit, remainder=remainder, **rest)


def between(
    label: str,
    size: Expr,
    limits: tuple[str, str],
    gauge: Expr,
    ratio: Callable[..., Any],
    given: tuple[Basic, ...] = quarter,
    chart: tuple[tuple[Expr, ...], Any] = (BY_KAPPA, KAPPA),
    **rest: Any,
) -> Claim:
    """low · gauge < size < high · gauge, where ``ratio`` is size/gauge in the chart."""
    low, high = map(as_rational, limits)
    least, most = (Rational(limit) * gauge for limit in limits)
    shown = (
        Shown(lambda *at: ratio(*at) - low, gauge),
        Shown(lambda *at: high - ratio(*at), gauge),
    )
    says = Tuple(Gt(size, least, evaluate=False), Lt(size, most, evaluate=False))
    return bound(label, says, On(*chart, shown), given=given, constant=limits[1], **rest)


def too_small(
    amended: Claim,
    limit: str,
    says: Callable[[Expr], Basic],
    label: str = "",
    using: tuple[Claim, ...] = (separatrix.flip_defect, leading_term, first_coefficient),
    **point: Any,
) -> Claim:
    """``says`` with a smaller constant, which fails for some shape."""
    at = {name: as_rational(x) for name, x in point.items()}
    return Claim(
        label=label or f"{amended.label}_too_small",
        says=says(Rational(limit)),
        given=amended.given,
        proof=Counterexample(at, using),
        amended_by=(amended,),
    )


NEAR_CHART, FAR_CHART = box((0, 1), (0, "7/4")), box((0, 1), (0, "4/7"))
"""The charts (b, k) and (b, κ), which meet at k = 7/4, and hold every shape."""
NEARER, FARTHER = (a * b <= Rational(49, 16),), (a * b >= Rational(49, 16),)


def everywhere_shown(near: tuple[Shown, ...], far: tuple[Shown, ...]) -> tuple[On, On]:
    """Charts that together cover all shapes."""
    return On(BY_K, NEAR_CHART, near, NEARER), On(BY_KAPPA, FAR_CHART, far, FARTHER)


def _newton(
    label: str,
    start: Expr,
    begin: Callable[[Any], Any],
    from_sweep: tuple[tuple[Reading, ...], Claim],
    improved: tuple[Claim, Claim],
) -> tuple[tuple[Reading, ...], tuple[Claim, ...]]:
    """As ``_sweep``, for a step of Newton's method from there; its phase stays above 3."""
    (difference, *_, far_difference, _, _), gained = from_sweep
    k_, (later, last) = sqrt(a * b), (parts_of(claim.says)[0].args[0] for claim in improved)
    known: dict[str, Any] = {"given": shape, "cited": (phase_range,)}
    excess = Reading(
        charts.newton_excess,
        (*BY_K, P, start),
        later - P,
        claims=(gained, improved[0], turn_in_k),
        inner=(difference,),
        **known,
    )
    far_excess = Reading(
        charts.far_newton_excess,
        (*BY_KAPPA, P, start),
        k_ * (later - P),
        claims=(gained, improved[0], turn_in_kappa),
        inner=(far_difference,),
        **known,
    )

    def near_phase(b: Any, k: Any, m: Any) -> Any:
        phase = charts.phase_over(b, k)
        return phase + charts.newton_excess(b, k, phase, begin(m), m) - 3

    def far_phase(b: Any, kappa: Any, m: Any) -> Any:
        phase = charts.phase_by_kappa(b, kappa)
        return phase + kappa * charts.far_newton_excess(b, kappa, phase, begin(m), m) - 3

    goes_on = bound(
        f"{label}_goes_on",
        later > 3,
        *everywhere_shown((Shown(near_phase),), (Shown(far_phase),)),
        put=(),
        readings=(*READINGS, excess, far_excess),
        given=shape,
    )
    w = sqrt(1 + b / a) * sinh(k_ * later)
    angles = Instance(difference_of_turns, ((x, _w), (x0, w)), (phase_range, goes_on))
    two = Claim(f"{label}_angles", angles.says, angles, given=shape)
    apart = angles.says.args[0]
    beyond = Claim(
        f"{label}_exceeds",
        equal(apart, last - epsilon0),
        by(substituting(two, improved[1], defect_by_cotangent)),
        given=shape,
    )
    known["cited"] = (phase_range, goes_on)
    error = sinh(k_ * P) / sinh(k_ * later) - 1
    readings = (
        excess,
        far_excess,
        Reading(charts.tangent_error, (P - later, P, k_), error, **known),
        Reading(charts.angle_difference, (error, _w), apart, **known),
        Reading(charts.far_error, (k_ * (P - later), P, 1 / k_), error, **known),
        Reading(
            charts.far_angle_error,
            (error, 1 / _w),
            apart / epsilon0,
            claims=(defect_by_phase,),
            **known,
        ),
    )
    return (*READINGS, *readings), (two, goes_on, beyond)


pi_readings, newton_beyond_pi = _newton(
    "newton_pi",
    pi,
    lambda m: m.pi,
    (_from_pi, misses_from_pi[1]),
    (sweeps.phase_from_pi, sweeps.defect_from_pi),
)
four_readings, newton_beyond_four = _newton(
    "newton_four",
    Integer(4),
    lambda m: fmpq(4),
    (_from_four, misses_from_four[1]),
    (sweeps.phase_from_four, sweeps.defect_from_four),
)

# -- bounds for every shape ----------------------------------------------------------------------

_everywhere = citing(separatrix.flip_defect, separatrix.defect_range)
_sine0, _cosine0 = sin(epsilon0), cos(epsilon0)
_root0 = sqrt(1 + b / a * _sine0**2)
_turn0 = asin(sqrt(b / a) * _sine0**2 / (_cosine0 + _root0))

leading_positive = Claim(says=epsilon_star > 0, given=shape, proof=by(substituting(leading_term)))

half_tangent_everywhere = Claim(
    says=equal(
        tan(epsilon0 / 2),
        epsilon_star / 2 * (_cosine0 + _root0) / (1 + _cosine0) * exp(sqrt(a * b) * _turn0),
    ),
    given=shape,
    proof=(
        step(_sine0 / (1 + _cosine0), trigonometry, _everywhere),
        step(
            epsilon0
            * exp(-Q)
            / 2
            * (_cosine0 + _root0)
            / (1 + _cosine0)
            * exp(sqrt(a * b) * _turn0),
            *(substituting(exponent_of_defect), exponentials, _everywhere),
        ),
        step(None, substituting(leading_by_defect), _everywhere),
    ),
)

half_tangent_above = Claim(
    says=tan(epsilon0 / 2) > epsilon_star / 2,
    given=shape,
    proof=(
        step(
            epsilon_star
            / 2
            * (
                (_root0 - 1) / (1 + _cosine0) * exp(sqrt(a * b) * _turn0)
                + (exp(sqrt(a * b) * _turn0) - 1)
            ),
            *(substituting(half_tangent_everywhere), citing(leading_positive), _everywhere),
        ),
    ),
)

_half = Instance(exponent.arctangent_above, ((x, epsilon_star / 2),), (leading_positive,))
arctangent_at_half = Claim(says=_half.says, given=shape, proof=_half)

half_angle_above = Claim(
    says=epsilon0 / 2 > atan(epsilon_star / 2),
    given=shape,
    proof=(
        step(
            tan(epsilon0 / 2) - epsilon_star / 2,
            *(
                applying("tan"),
                inverses,
                trigonometry,
                citing(half_tangent_above, leading_positive),
                _everywhere,
            ),
        ),
    ),
)

leading_below = Claim(
    says=Tuple(
        epsilon0 / 2 > atan(epsilon_star / 2), epsilon0 / epsilon_star > 1 - epsilon_star**2 / 12
    ),
    given=shape,
    proof=follows(
        all_of(half_angle_above),
        (
            step(
                2
                / epsilon_star
                * (
                    (epsilon0 / 2 - atan(epsilon_star / 2))
                    + (epsilon_star**3 / 24 - epsilon_star / 2 + atan(epsilon_star / 2))
                ),
                citing(half_angle_above, arctangent_at_half, leading_positive),
            ),
        ),
    ),
    note="Equality would be attained in the limit b → 0, b/a → 0, where tan(ε₀/2) = e^{−π√(ab)}.",
)


_late = 3 * pi / 2 * sqrt(a * b)
_soon = sqrt(a * b) * P
_bounded = (*shape, a * b <= 1)

cotangent_at_root = Claim(
    says=equal(cos(epsilon0) / sin(epsilon0), sqrt(1 + b / a) * sinh(_soon)),
    given=shape,
    proof=(
        step(
            sqrt(1 + b / a)
            * sinh(
                sqrt(a * b)
                * (asinh(sqrt(a / (a + b)) * cos(epsilon0) / sin(epsilon0)) / sqrt(a * b))
            ),
            *(roots, citing(separatrix.flip_defect, separatrix.defect_range)),
        ),
        step(
            None,
            *(substituting(phase_by_defect), exponentials, inverses, roots),
            citing(separatrix.flip_defect, separatrix.defect_range),
        ),
    ),
)

hyperbolic_sine_rises = Claim(
    says=sinh(T + x) - sinh(T) >= 0, given=(T > 0, x >= 0), proof=manifest
)

_rises = Instance(hyperbolic_sine_rises, ((T, _soon), (x, _late - _soon)), (phase_range,))
sine_of_the_time = Claim(says=_rises.says, given=shape, proof=_rises)

_small = Instance(on_the_separatrix.hyperbolic_sine_at_most, ((k, sqrt(a * b)),))
sine_of_the_late = Claim(says=_small.says, given=_bounded, proof=_small)

_below = Instance(
    on_the_separatrix.angle_below_tangent,
    ((epsilon, epsilon0),),
    (separatrix.flip_defect, separatrix.defect_range),
)
defect_below_tangent = Claim(says=_below.says, given=shape, proof=_below)

b_to_zero = Claim(
    says=Tuple(pi / 2 - epsilon0 > 0, pi / 2 - epsilon0 <= 56 * sqrt(1 + b / a) * sqrt(a * b)),
    given=_bounded,
    proof=follows(
        by(citing(separatrix.flip_defect)),
        (
            step(
                (cos(epsilon0) / sin(epsilon0) - (pi / 2 - epsilon0))
                + sqrt(1 + b / a) * (sinh(_late) - sinh(_soon))
                + sqrt(1 + b / a) * (56 * sqrt(a * b) - sinh(_late)),
                substituting(cotangent_at_root),
                citing(
                    sine_of_the_time,
                    sine_of_the_late,
                    defect_below_tangent,
                    separatrix.defect_range,
                ),
            ),
        ),
    ),
    where=line(249),
    note="0 < π/2 − ε₀ ≤ cot ε₀ ≤ √(1 + b/a) sinh(3π√(ab)/2) ≤ 56 √(1 + b/a) √(ab): ε₀ → π/2 as "
    "b → 0 at fixed a.",
)

label_claims(globals())

_MORE = (*misses_from_pi, *misses_from_four, *newton_beyond_pi, *newton_beyond_four)
globals().update({claim.label: claim for claim in _MORE})
