"""Section 7, continued: which starts show a flip.

- `two_rectangles`: rectangles of initial conditions that all flip by π to within π/6;
- `faster_at_higher_level`: f = dφ/dψ decreases as γ increases; `level_grows_with_the_rate`: γ
  increases with the initial rate;
- `near_flip_likely`: sufficiently near the unstable point no start flips; `likely_near`: in a
  rectangle around it most starts flip;
- `far_from_separatrix`: where the standard racket shows no effect from any start;
  `no_tre_far`: the same statement, read literally.
"""

from __future__ import annotations

from tresym.proofs import on_the_separatrix, phase_portraits, regimes
from tresym.proofs.conditions import defect, shape_of_a_body, standard_racket
from tresym.proofs.flip_definition import symmetric_is_extreme
from tresym.proofs.numbers_in_text import lower_level, upper_level_exact

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

_square = sin(psi) ** 2
_rate = Symbol("v", real=True)
"""dψ/dφ at the start."""

faster_at_higher_level = Claim(
    says=Derivative(printed.integrand(psi, a, b, gamma, 1, sympy), gamma) < 0,
    given=(*shape_of_a_body, gamma + b * _square > 0),
    proof=by(differentiation),
    note="At every ψ the flip angle changes faster for larger γ.",
)

level_grows_with_the_rate = Claim(
    says=Derivative(_rate**2 * (1 - b * _square) ** 2 / (a + b * _square) - b * _square, _rate) > 0,
    given=(*shape_of_a_body, _rate > 0),
    proof=by(differentiation),
    note="γ of a start, by `level_of_a_start`.",
)

_level = _rate**2 * (1 - b * sin(psi0) ** 2) ** 2 / (a + b * sin(psi0) ** 2) - b * sin(psi0) ** 2
"""γ of the start (ψ₀, dψ/dφ)."""


def _time(level: Expr, start: Expr, end: Expr) -> Integral:
    """Δφ while ψ goes from ``start`` to ``end``."""
    return Integral(printed.integrand(psi, a, b, level, 1, sympy), (psi, start, end))


def _of_starts(label: str, least: str, low: str, high: str) -> Claim:
    """That starts with ``least`` ≤ ψ₀ ≤ 1/10 and such rates flip by π to within π/6 in one turn."""
    needed = [_time(_level, psi0, psi0 + flip) for flip in (5 * pi / 6, 7 * pi / 6)]
    ends = psi0 >= Rational(least), psi0 <= Rational(1, 10)
    return Claim(
        label=label,
        says=Tuple(needed[0] < 2 * pi, needed[1] > 2 * pi),
        given=(*standard_racket, *ends, _rate >= Rational(low), _rate <= Rational(high)),
        proof=Evaluated(stored=certificate(label)),
        note="5π/6 takes less than a turn of the handle, and 7π/6 more.",
    )


fast_starts_flip = _of_starts("fast_starts_flip", "-1/10", "3/20", "3/10")
slow_starts_flip = _of_starts("slow_starts_flip", "-1/20", "1/10", "3/20")

two_rectangles = Claim(
    **jointly(fast_starts_flip, slow_starts_flip, on_the_separatrix.level_of_a_start),
)

_width, _height, _area = (Symbol(name, real=True) for name in "whA")
_share = _width * _height / _area
_area_half = {_area: Rational(2, 10) * Rational(3, 10)}

share_of_the_rectangles = Claim(
    says=equal(
        at(_share, {_width: Rational(2, 10), _height: Rational(3, 20), **_area_half})
        + at(_share, {_width: Rational(3, 20), _height: Rational(1, 20), **_area_half}),
        Rational(5, 8),
    ),
    proof=by(evaluating),
    note="For the half of the rectangle with dψ/dφ > 0; the other half is its mirror image.",
)

likely_near = Claim(
    **jointly(two_rectangles, share_of_the_rectangles),
    where=line(283),
    note=(
        "The rectangle about the unstable point corresponds to the "
        "region marked in the figure; likely is read as a share of its area."
    ),
)

near_flip_likely = Claim(
    says="However near the unstable point the starts are, a near flip may happen: within 1/100 of "
    "it the standard racket flips by 5π/6 or more from some.",
    paper_says="“When we consider initial conditions close to this point, Fig. 10 shows that a "
    "near flip is very likely to happen.” Read as: from most starts in a rectangle about it.",
    kind="bound",
    means=Le(
        _time(1 / (10**4 * a), Rational(1, 100), 5 * pi / 6 - Rational(1, 100)),
        2 * pi,
        evaluate=False,
    ),
    given=standard_racket,
    proof=Evaluated(
        (faster_at_higher_level, level_grows_with_the_rate, on_the_separatrix.level_of_a_start)
    ),
    where=line(283),
    expect=Verdict.REFUTED,
    amended_by=(likely_near,),
    note=(
        "The point itself is an equilibrium, and starts next to it "
        "move slowly: none of them flips in one turn. In a rectangle "
        "that is not too small most starts do."
    ),
)

narrow_swing = Claim(
    says=asin(sqrt(-gamma / b)) > epsilon,
    given=(*regimes.oscillating, *defect, -gamma - b * sin(epsilon) ** 2 > 0),
    proof=(step(sqrt(-gamma / b) - sin(epsilon), applying("sin"), inverses, trigonometry),),
    note=(
        "With ε = π/12, ψ_max − ψ_min = π − 2 arcsin √(|γ|/b) < 5π/6, so no start flips far enough."
    ),
)

_reached = _time(gamma, -pi / 12, pi / 2), _time(gamma, pi / 12, pi / 2)
"""F(−π/12, γ) and F(π/12, γ)."""

symmetric_overshoots = Claim(
    says=_reached[0].xreplace({gamma: Rational("0.0104")}) < pi,
    given=standard_racket,
    proof=Evaluated(),
)

far_from_separatrix = Claim(
    says="Far from the separatrix, at γ ≥ 0.0104 and at γ ≤ −0.0043, the standard racket shows no "
    "effect from any start.",
    proof=in_words(
        symmetric_overshoots,
        symmetric_is_extreme,
        faster_at_higher_level,
        narrow_swing,
        phase_portraits.flip_between,
    ),
    where=line(272),
    note="Both limits are near the 10⁻² of the paper, which says “approximately”; b sin²(π/12) "
    "is 0.00422.",
)

no_tre_far = Claim(
    says="The standard racket shows no effect where |γ| > 10⁻², exactly.",
    paper_says="“the TRE does not occur far from the separatrix, approximately when |γ| > "
    "10^{−2}.” Read as: where |γ| is larger by 4 % or more.",
    kind="bound",
    means=Ge(
        at((_reached[0] - pi) * (_reached[1] - pi), {x.lhs: x.rhs for x in standard_racket}),
        0,
        evaluate=False,
    ),
    given=(gamma > Rational(1, 100), gamma < 1),
    proof=Counterexample({"gamma": fmpq(51, 5000)}),
    where=line(272),
    amended_by=(far_from_separatrix, upper_level_exact, lower_level),
    note="The symmetric start flips for −0.00418 ≤ γ ≤ 0.01035: F falls with ε, and π is between "
    "F(π/12, γ) and F(−π/12, γ).",
)

label_claims(globals())
