"""Charts for bounds that hold on a region: coordinates, margins, and what their steps mean.

A file of claims names them by ``shown by charts NAME``. The bound |ε₀/ε* − 1| ≤ 1.451 ε*² on
ab ≥ 1/4 holds, since in the coordinates b and κ = 1/√(ab), which lie between 0 and 1 and between 0
and 2, both sides differ by ε*² times a function that is positive there; `first_order_chart` has
that function, as a program that runs in balls. That it is the function is compared exactly, step
by step: a reading says which symbol of the claim a step of the program is, with the claims that
say so, which the file must have stated.

Nothing here is trusted: charts that do not fit leave their claim undecided.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import pairwise
from typing import Any

from flint import arb, fmpq

from tresym.ledger.evidence.allowed_evidence import Meant
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted, Charts, On, Reading, Shown, Stated
from tresym.ledger.evidence.remainders import Remainder
from tresym.racket.bounds import charts
from tresym.racket.bounds.bending import curvature
from tresym.racket.bounds.samples import in_bent_chart
from tresym.racket.comparison.constants import CONSTANTS
from tresym.racket.notation import *
from tresym.reals.balls.branch_and_bound import Bound, box
from tresym.reals.language.expression import (
    ONE,
    PI,
    ZERO,
    Expr,
    Number,
    as_expr,
    number,
    sqrt,
    symbol,
    trees,
)
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import as_rational

_k, _ratio = sqrt(a * b), sqrt(b / a)


def _at_most(e: Expr, value: Expr | Number) -> Relation:
    return Relation(e, "<=", as_expr(value))


def _at_least(e: Expr, value: Expr | Number) -> Relation:
    return Relation(e, ">=", as_expr(value))


shape = (Relation(a, ">", ZERO), Relation(b, ">", ZERO), _at_most(b, 1))
"""The closed range of shapes on which the paper's formulas are studied."""

BY_KAPPA = (b, 1 / sqrt(a * b))
"""The chart (b, κ): a = 1/(bκ²)."""
BY_K = (b, sqrt(a * b))
"""The chart (b, k): a = k²/b."""
_AT_ROOT = (epsilon0, b, _ratio)
KAPPA = box((0, 1), (0, 2))
"""The region ab ≥ 1/4 in the chart (b, κ)."""
NEAR_CHART, FAR_CHART = box((0, 1), (0, "7/4")), box((0, 1), (0, "4/7"))
"""The charts (b, k) and (b, κ), which meet at k = 7/4, and hold every shape."""
_NEARER, _FARTHER = (_at_most(a * b, fmpq(49, 16)),), (_at_least(a * b, fmpq(49, 16)),)

# -- what the steps of the programs are in the paper's symbols ------------------------------------

_ROOT = ("flip_defect", "defect_range")
FOUR = number(4)
_w = sqrt(1 + b / a) * trees.sinh(_k * P)
"""cot ε₀."""


def _read(claims: Stated, step: Any, at: tuple[Any, ...], value: Any, *by: str) -> Reading:
    """A step whose meaning the claims ``by`` say; the phase lies in its range."""
    return Reading(step, at, value, shape, claims(*by), claims("phase_range"))


def _difference(one: Expr, other: Expr) -> Expr:
    """The angle of which the tangent is that of the difference of two others."""
    return trees.atan((one - other) / (1 + one * other))


def _sweep(claims: Stated, start: Expr, ends: Expr) -> tuple[Reading, ...]:
    """The steps of the error of a sweep, and the differences of angles in it."""
    turn = _ratio * trees.tanh(_k * start)
    left = _difference(_ratio * trees.tanh(_k * P), turn)
    end = sqrt(1 + b / a) * trees.sinh(_k * (PI + trees.atan(turn)))
    apart = _difference(1 / end, 1 / _w)
    error = trees.sinh(_k * P) / trees.sinh(_k * (PI + trees.atan(turn))) - 1
    gained = f"sweep_from_{start}_misses"
    return (
        _read(claims, charts.sweep_difference, (*BY_K, P, start), left),
        _read(claims, charts.tangent_error, (left, P, _k), error, gained),
        _read(claims, charts.angle_difference, (error, _w), apart),
        _read(claims, charts.far_difference, (*BY_KAPPA, P, start), _k * left),
        _read(claims, charts.far_error, (_k * left, P, 1 / _k), error, gained),
        _read(claims, charts.far_angle_error, (error, 1 / _w), apart / epsilon0, "defect_by_phase"),
    )


_q2 = (
    50 * b**2 + 40 * b * (b / a) + 5 * (b / a) ** 2 - 20 * b - 10 * b / a + 1
) / 80 - c1**2 * 5 / 2


@cache
def _readings(claims: Stated) -> tuple[Reading, ...]:
    rate, root = Q / epsilon0**2, claims(*_ROOT)
    expanded = claims("exponent_of_defect", "first_coefficient")
    phase_in_k = _read(claims, charts.phase_over, BY_K, P, "phase_equation")
    phase_in_kappa = _read(claims, charts.phase_by_kappa, BY_KAPPA, P, "phase_equation")
    defect_in_k = _read(claims, charts.defect_by_k, BY_K, epsilon0, "defect_by_phase")
    defect_in_kappa = _read(claims, charts.defect_by_kappa, BY_KAPPA, epsilon0, "defect_by_phase")
    return (
        _read(claims, charts.cotangent, (*BY_K, P), _w),
        _read(claims, charts.angle_of, (_w,), epsilon0, "defect_by_phase"),
        _read(claims, charts.tangent_by_kappa, (*BY_KAPPA, P), 1 / _w),
        *_sweep(claims, PI, epsilon_pi),
        *_sweep(claims, FOUR, epsilon_4),
        phase_in_k,
        replace(defect_in_k, inner=(phase_in_k,)),
        phase_in_kappa,
        replace(defect_in_kappa, inner=(phase_in_kappa,)),
        Reading(charts.exponent_rate, _AT_ROOT, rate, shape, expanded[:1], root),
        Reading(charts.exponent_bend, _AT_ROOT, (rate - c1) / epsilon0**2, shape, expanded, root),
        Reading(
            charts.exponent_twist,
            _AT_ROOT,
            ((rate - c1) / epsilon0**2 - _q2) / epsilon0**2,
            shape,
            expanded,
            root,
        ),
        Reading(
            charts.leading_square_over,
            BY_KAPPA,
            epsilon_star**2 * a * b,
            (*shape, _at_least(a * b, fmpq(1, 9))),
            claims("leading_term"),
        ),
    )


def _excess(claims: Stated, start: Expr, later: Expr, improved: str) -> tuple[Reading, ...]:
    """By how much the phase after a step of Newton's method behind a sweep exceeds the true one."""
    near, *_, far, _, _ = _sweep(claims, start, epsilon0)
    gained = f"sweep_from_{start}_misses"
    excess = _read(
        claims, charts.newton_excess, (*BY_K, P, start), later - P, gained, improved, "turn_in_k"
    )
    far_excess = _read(
        claims,
        charts.far_newton_excess,
        (*BY_KAPPA, P, start),
        _k * (later - P),
        *(gained, improved, "turn_in_kappa"),
    )
    return replace(excess, inner=(near,)), replace(far_excess, inner=(far,))


def _newton(claims: Stated, later: Expr, goes_on: str) -> tuple[Reading, ...]:
    """The steps of the error of a step of Newton's method, whose phase stays above 3."""
    cited = claims("phase_range", goes_on)
    w = sqrt(1 + b / a) * trees.sinh(_k * later)
    apart = _difference(_w, w)
    error = trees.sinh(_k * P) / trees.sinh(_k * later) - 1
    return (
        Reading(charts.tangent_error, (P - later, P, _k), error, shape, cited=cited),
        Reading(charts.angle_difference, (error, _w), apart, shape, cited=cited),
        Reading(charts.far_error, (_k * (P - later), P, 1 / _k), error, shape, cited=cited),
        Reading(
            charts.far_angle_error,
            (error, 1 / _w),
            apart / epsilon0,
            shape,
            claims("defect_by_phase"),
            cited,
        ),
    )


# -- charts ---------------------------------------------------------------------------------------


def _charts(*on: On, readings: Callable[[Stated], tuple[Reading, ...]] = _readings) -> Charts:
    return Charts(lambda claims: Charted(on, readings(claims)))


def _within(
    error: Callable[..., Any], limit: str, over: Expr, slopes: bool = False
) -> tuple[Shown, ...]:
    """The two margins of |error| ≤ limit, multiplied by ``over``."""
    most = as_rational(limit)
    return (
        Shown(lambda *at: most - error(*at), over, slopes=slopes),
        Shown(lambda *at: most + error(*at), over, slopes=slopes),
    )


def _between(ratio: Callable[..., Any], low: str, high: str, gauge: Expr) -> tuple[Shown, ...]:
    """The two margins of low · gauge < size < high · gauge, where ``ratio`` is size/gauge."""
    least, most = as_rational(low), as_rational(high)
    return (
        Shown(lambda *at: ratio(*at) - least, gauge),
        Shown(lambda *at: most - ratio(*at), gauge),
    )


def _below(error: Callable[..., Any], limit: str, gauge: Expr) -> Charts:
    """|size| ≤ limit · gauge on ab ≥ 1/4, where ``error`` is size/gauge in the chart (b, κ)."""
    return _charts(On(BY_KAPPA, KAPPA, _within(error, limit, gauge)))


def _every(
    near: Callable[..., Any],
    far: Callable[..., Any],
    limit: str,
    begin: Callable[[Any], Any],
    slopes: bool = False,
) -> tuple[On, On]:
    """|ε/ε₀ − 1| ≤ limit for every shape, by the margin of either chart."""

    def margins(error: Callable[..., Any], slopes: bool) -> tuple[Shown, ...]:
        return _within(lambda x, y, m: error(x, y, begin(m), m), limit, ONE, slopes)

    return (
        On(BY_K, NEAR_CHART, margins(near, slopes), _NEARER),
        On(BY_KAPPA, FAR_CHART, margins(far, False), _FARTHER),
    )


# -- the theorem as printed


def _printed_parts(b: Any, kappa: Any, m: Any) -> tuple[Any, Any]:
    """log(printed/ε₀) = b³κ² p − κ² q in the chart (b, κ): p and q, from ε* and from Q(ε₀)."""
    root = charts.root_by_kappa(b, kappa, m)
    rate = charts.exponent_rate(*root, m)
    growth = m.exp(2 * root.defect * root.defect * rate)
    star = charts.leading_square_over(b, kappa, m)
    # log(printed/ε*) = b (arctan r/r − 1/√(1 + r²)), which is b r² p.
    return charts.printed_excess(root.r, m), star * rate * growth


def printed_logarithm(b: Any, kappa: Any, m: Any) -> Any:
    """log(printed/ε₀) · ab in the chart (b, κ)."""
    algebraic, flat = _printed_parts(b, kappa, m)
    return b * b * b * algebraic - flat


def _printed_relative(b: Any, kappa: Any, m: Any) -> Any:
    """(printed/ε₀ − 1) a/b² in the chart (b, κ), away from b = 0; a/b² = (1/κ²)/b³."""
    algebraic, flat = _printed_parts(b, kappa, m)
    cube = b * b * b
    scaled = algebraic - flat / cube
    return scaled * charts.expm1_over(cube * kappa * kappa * scaled)


printed_chart = _below(printed_logarithm, "0.17", 1 / (a * b))
beside_chart = _charts(
    On(
        BY_KAPPA,
        box(("1/4", 1), (0, "1/2")),
        _between(_printed_relative, "0.133", "0.168", b**2 / a),
    )
)

# -- the theorem repaired

EXCESS: tuple[Callable[..., Any], ...] = (
    lambda b, kappa, m: charts.first_excess(charts.root_by_kappa(b, kappa, m), m),
    lambda b, kappa, m: charts.second_excess(charts.root_by_kappa(b, kappa, m), m),
    lambda b, kappa, m: charts.third_excess(charts.root_by_kappa(b, kappa, m), m),
)
"""(ε₀/ε* − Σ_{n≤N} c_n ε*^{2n})/ε*^{2N+2} for N = 0, 1, 2, in the chart (b, κ)."""

first_order_chart = _below(EXCESS[0], "1.451", epsilon_star**2)
second_order_chart = _below(EXCESS[1], "2.98", epsilon_star**4)
third_order_chart = _below(EXCESS[2], "7.36", epsilon_star**6)

growth_chart = _charts(
    On(
        BY_KAPPA,
        KAPPA,
        (
            Shown(lambda *at: fmpq(1, 4) - charts.growth(*at)[0]),
            Shown(lambda *at: fmpq(13, 5) - charts.growth(*at)[1]),
        ),
    )
)

# -- one bound for all shapes

_TEN_THIRDS = fmpq(10, 3)
_rate = -_k * (PI + trees.asin(sqrt(b / (a + b))))
_decay = trees.exp(_rate)
"""q, where ε* is 2 cos θ q."""
_square, _cube = trees.exp(2 * _rate), trees.exp(3 * _rate)
_squared, _cubed = trees.exp(-3 * PI * _k), trees.exp(fmpq(-9, 2) * PI * _k)


def _gap(side: int) -> Callable[..., Any]:
    """(10/3) q³ ∓ (ε₀ − ε*) in the chart (b, k)."""

    def margin(b: Any, k: Any, m: Any) -> Any:
        gap, cube = charts.cubic_gap(b, k, m)
        return _TEN_THIRDS * cube - side * gap

    return margin


def _cubic(side: int) -> Callable[..., Any]:
    """The same over (1 + R) ε*³, in the chart (b, κ)."""

    def margin(b: Any, kappa: Any, m: Any) -> Any:
        root = charts.root_by_kappa(b, kappa, m)
        stretched = 1 + root.r * root.r
        return m.sqrt(stretched) * 5 / 12 - side * charts.first_excess(root, m) / stretched

    return margin


def _corner(b: Any, kappa: Any, m: Any) -> Any:
    """3/8 less what the next term of the series takes, over κ²."""
    root = charts.root_by_kappa(b, kappa, m)
    return fmpq(3, 8) - charts.leading_square_over(b, kappa, m) * charts.second_excess(root, m)


_stretch = epsilon_star**3 * (1 + b / a)
_at_corner = (
    fmpq(5, 12) * (1 + b / a) * sqrt(1 + b / a) - (6 * b - 1 + 3 * b / a) / 12 - 3 / (8 * a * b)
)
"""What the claim `corner` says is not negative."""
_least, _small = fmpq(1, 400), fmpq(1, 16)


def _everywhere(claims: Stated) -> Charted:
    tiny = On(
        BY_K,
        box((0, 1), (0, "1/20")),
        (
            Shown(
                lambda b, k, m: _TEN_THIRDS * m.exp(-9 * m.pi * k / 2) - m.pi / 2,
                spare=_TEN_THIRDS * (_cube - _cubed) + (PI / 2 - epsilon0) + epsilon_star,
            ),
            Shown(
                lambda b, k, m: _TEN_THIRDS * m.exp(-3 * m.pi * k) - 2,
                _decay,
                _TEN_THIRDS * _decay * (_square - _squared)
                + (2 * _decay - epsilon_star)
                + epsilon0,
            ),
        ),
        (_at_most(a * b, _least),),
        claims("decay_at_least"),
    )
    near = On(
        BY_K,
        box((0, 1), ("1/20", "1/4")),
        (Shown(_gap(1), slopes=True), Shown(_gap(-1), slopes=True)),
        (_at_least(a * b, _least), _at_most(a * b, _small)),
    )
    far = On(
        BY_KAPPA,
        box((0, 1), ("1/2", 4)),
        (Shown(_cubic(1), _stretch), Shown(_cubic(-1), _stretch)),
        (_at_least(a * b, _small), _at_most(a * b, 4)),
    )
    corner = On(
        BY_KAPPA,
        box((0, 1), (0, "1/2")),
        (
            Shown(_corner, epsilon_star**3 / (a * b), spare=epsilon_star**3 * _at_corner),
            Shown(_cubic(-1), _stretch),
        ),
        (_at_least(a * b, 4),),
        claims("corner"),
    )
    return Charted((tiny, near, far, corner), _readings(claims))


all_shapes_charts = Charts(_everywhere)

# -- what the paper leaves out by its orders


def _log_ratio(b: Any, kappa: Any, m: Any) -> Any:
    """log(ε₀/ε*)/ε*² = −u/(λε*²), u = −λ log(ε₀/ε*)."""
    root = charts.root_by_kappa(b, kappa, m)
    rate = charts.exponent_rate(*root, m)
    return rate * m.exp(2 * root.defect * root.defect * rate)


def quadratic_u(b: Any, kappa: Any, m: Any) -> Any:
    """u/λ² in the chart (b, κ), up to its sign."""
    return kappa * charts.leading_square_over(b, kappa, m) * _log_ratio(b, kappa, m)


def _turn_slope_rest(b: Any, kappa: Any, m: Any) -> Any:
    """κ · 4b√(ab) · −(∂F/∂γ + 1/(4b√(ab) ε₀²)) at γ = 0; κT is the phase P."""
    e, _, r = charts.root_by_kappa(b, kappa, m)
    sinc, half = charts.sine_over(e), charts.sine_over(e / 2)
    root = m.sqrt(1 + r * r * e * e * sinc * sinc)
    # (c√(1 + Rs²)/s² − 1/e²): the differences c − 1, √ − 1 and e²/s² − 1, each over e².
    cosine, stretched = -half * half / 2, r * r * sinc * sinc / (1 + root)
    algebraic = (m.cos(e) * stretched + cosine - charts.sine_rest(e) * (1 + sinc)) / (sinc * sinc)
    return kappa * algebraic + (1 - r * r - 2 * b) * charts.phase_by_kappa(b, kappa)


def turn_slope_times_defect(b: Any, kappa: Any, m: Any) -> Any:
    """The remainder of ∂F/∂γ over 1/(4b√(ab) ε₀), up to its sign."""
    return charts.defect_over_kappa(b, kappa, m) * _turn_slope_rest(b, kappa, m)


def slope_times_defect(b: Any, kappa: Any, m: Any) -> Any:
    """The remainder of dε/dγ over 1/b, up to its sign."""
    return charts.defect_over_kappa(b, kappa, m) * charts.slope_rest(b, kappa, m) / 4


def _decay_rate(b: Any, kappa: Any, m: Any) -> Any:
    """ε₀ e^{π√(ab)} = 2 cos θ e^{−b arctan(r)/r} ε₀/ε*."""
    root = charts.root_by_kappa(b, kappa, m)
    exponent = root.defect * root.defect * charts.exponent_rate(*root, m)
    cosine = 1 / m.sqrt(1 + root.r * root.r)
    return 2 * cosine * m.exp(exponent - b * charts.arctangent_over(root.r))


_LARGE_B = box(("3/4", 1), (0, 2))

u_chart = _below(_log_ratio, "1.44", lam * epsilon_star**2)
flat_u_chart = _below(quadratic_u, "0.009", lam**2)
turn_slope_chart = _below(turn_slope_times_defect, "0.96", 1 / (4 * b * _k * epsilon0))
defect_slope_chart = _below(slope_times_defect, "0.18", 1 / b)
exact_turn_slope_chart = _charts(
    On(
        BY_KAPPA,
        _LARGE_B,
        _between(lambda b, k, m: -_turn_slope_rest(b, k, m), "3/2", "18", 1 / (4 * b)),
    )
)
exact_defect_slope_chart = _charts(
    On(
        BY_KAPPA,
        _LARGE_B,
        _between(
            lambda b, k, m: -charts.slope_rest(b, k, m), "3/2", "12.6", _k * epsilon0 / (4 * b)
        ),
    )
)
decay_chart = _charts(On(BY_KAPPA, KAPPA, _between(_decay_rate, "0.52", "2.01", ONE)))

BENT = ((0, 1), (0, 2), (-1, 1))
"""The chart (b, κ, v) of ab ≥ 1/4, γ = bε₀²v."""


def bending(constant: str) -> Bound:
    """ε is below (for a negative constant: above) its tangent + constant · √(ab) γ²/(b²ε₀)."""
    limit = as_rational(constant)

    def margin(b: Any, kappa: Any, v: Any, m: Any) -> Any:
        found = curvature(b, kappa, v, arb(limit), m)
        return -found if limit > 0 else found

    return Bound(margin, box(*BENT), sufficient=True)


def _bent(claims: Stated) -> Boxes:
    return Boxes(
        (bending("2"), bending("-2")),
        ("b", "kappa", "v"),
        "ab >= 1/4, 0 < b <= 1, |gamma| <= b epsilon0^2",
        meant=Meant(
            in_bent_chart(),
            _k * gamma**2 / (b**2 * epsilon0),
            (b, 1 / _k, gamma / (b * epsilon0**2)),
            Remainder(gamma, (a, b, epsilon0)),
        ),
    )


bent_chart = Charts(_bent)

# -- one formula for every body

sweep_from_pi_charts = _charts(
    *_every(charts.sweep_error, charts.far_sweep_error, "0.028", lambda m: m.pi, slopes=True)
)
sweep_from_four_charts = _charts(
    *_every(charts.sweep_error, charts.far_sweep_error, "0.0065", lambda m: fmpq(4), slopes=True)
)


def _stays_above_3(later: str, start: Expr, begin: Callable[[Any], Any], improved: str) -> Charts:
    """The phase after a step of Newton's method behind a sweep is more than 3."""

    def near(b: Any, k: Any, m: Any) -> Any:
        phase = charts.phase_over(b, k)
        return phase + charts.newton_excess(b, k, phase, begin(m), m) - 3

    def far(b: Any, kappa: Any, m: Any) -> Any:
        phase = charts.phase_by_kappa(b, kappa)
        return phase + kappa * charts.far_newton_excess(b, kappa, phase, begin(m), m) - 3

    on = (
        On(BY_K, NEAR_CHART, (Shown(near),), _NEARER),
        On(BY_KAPPA, FAR_CHART, (Shown(far),), _FARTHER),
    )
    name = symbol(later)
    return _charts(
        *on, readings=lambda claims: (*_readings(claims), *_excess(claims, start, name, improved))
    )


newton_pi_stays_charts = _stays_above_3("P_pi", PI, lambda m: m.pi, "phase_from_pi")
newton_four_stays_charts = _stays_above_3("P_4", FOUR, lambda m: fmpq(4), "phase_from_four")


@cache
def _readings_pi(claims: Stated) -> tuple[Reading, ...]:
    later = symbol("P_pi")
    excess = _excess(claims, PI, later, "phase_from_pi")
    return (*_readings(claims), *excess, *_newton(claims, later, "newton_pi_goes_on"))


@cache
def _readings_four(claims: Stated) -> tuple[Reading, ...]:
    later = symbol("P_4")
    excess = _excess(claims, FOUR, later, "phase_from_four")
    return (*_readings(claims), *excess, *_newton(claims, later, "newton_four_goes_on"))


newton_from_pi_charts = _charts(
    *_every(charts.newton_error, charts.far_newton_error, "0.0001", lambda m: m.pi),
    readings=_readings_pi,
)
newton_from_four_charts = _charts(
    *_every(charts.newton_error, charts.far_newton_error, "0.000004", lambda m: fmpq(4)),
    readings=_readings_four,
)

# -- the constants against the least a ------------------------------------------------------------

EXCESSES = (charts.first_excess, charts.second_excess)
UNIT = box((0, 1), (0, 1))
LEAST = fmpq(1, 10)
"""Below this a₀ slabs are used."""


def region_beyond(order: int, a0: fmpq, constant: fmpq) -> tuple[On, On]:
    """The bounds on the whole region a ≥ a₀: in (b, κ√a₀) and in (k/√a₀, a₀/a)."""
    least = number(a0)

    def near(b: Any, scaled: Any, m: Any) -> charts.Root:
        return charts.root_by_kappa(b, scaled / m.sqrt(a0), m)

    def far(scaled: Any, alpha: Any, m: Any) -> charts.Root:
        return charts.root_by_k(scaled * m.sqrt(a0), alpha / a0, m)

    def shown(chart: Callable[..., charts.Root]) -> tuple[Shown, ...]:
        def margin(side: int) -> Callable[..., Any]:
            return lambda x, y, m: constant - side * EXCESSES[order](chart(x, y, m), m)

        return tuple(Shown(margin(side), epsilon_star ** (2 * order + 2)) for side in (1, -1))

    beyond = (_at_least(a, least),)
    return (
        On((b, sqrt(least / (a * b))), UNIT, shown(near), (*beyond, _at_least(a * b, least))),
        On((sqrt(a * b / least), least / a), UNIT, shown(far), (*beyond, _at_most(a * b, least))),
    )


def slab(order: int, a0: fmpq, a1: fmpq, constant: fmpq) -> On:
    """The bounds on a₀ ≤ a ≤ a₁, in the chart (a, √b)."""

    def margin(side: int) -> Callable[..., Any]:
        def upper(a: Any, root_b: Any, m: Any) -> Any:
            gap, power = charts.gap_over(a, root_b, order, m)
            return power * constant - side * gap

        return upper

    shown = tuple(Shown(margin(side), 1 / epsilon_star, slopes=True) for side in (1, -1))
    return On((a, sqrt(b)), box((a0, a1), (0, 1)), shown, (_at_least(a, a0), _at_most(a, a1)))


def _from(order: int, least: str) -> Charts:
    """The bound from a ≥ ``least`` on: on slabs up to 1/10, and on the remaining region."""
    rows = [row for row in CONSTANTS if as_rational(row.least) >= as_rational(least)]
    a0, constant = as_rational(least), as_rational(rows[0][1 + order])
    ends = [as_rational(row.least) for row in rows if as_rational(row.least) <= LEAST]
    slabs = (slab(order, low, high, constant) for low, high in pairwise(ends))
    return _charts(*slabs, *region_beyond(order, max(a0, LEAST), constant))


repaired_from_1_100_charts = _from(0, "1/100")
repaired_from_1_30_charts = _from(0, "1/30")
repaired_from_1_10_charts = _from(0, "1/10")
repaired_from_1_4_charts = _from(0, "1/4")
repaired_from_1_2_charts = _from(0, "1/2")
repaired_from_1_charts = _from(0, "1")
repaired_from_2_charts = _from(0, "2")
repaired_from_5_charts = _from(0, "5")
repaired_from_10_charts = _from(0, "10")
second_order_from_1_100_charts = _from(1, "1/100")
second_order_from_1_30_charts = _from(1, "1/30")
second_order_from_1_10_charts = _from(1, "1/10")
second_order_from_1_4_charts = _from(1, "1/4")
second_order_from_1_2_charts = _from(1, "1/2")
second_order_from_1_charts = _from(1, "1")
second_order_from_2_charts = _from(1, "2")
second_order_from_5_charts = _from(1, "5")
second_order_from_10_charts = _from(1, "10")
