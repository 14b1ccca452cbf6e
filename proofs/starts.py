"""Section 7, continued: which starts show a flip.

- `faster_at_higher_level`: f = dφ/dψ falls as γ grows, and `level_grows_with_the_rate`: γ grows
  with the initial rate, so that a bound at one end of a range of rates holds on all of it;
- `near_flip_close`: near enough to the unstable point no start flips; `likely_near`: in a rectangle
  about it most do;
- `far_from_separatrix`: where the standard racket shows no effect from any start, and
  `no_tre_far`: the same, read literally.
"""

from __future__ import annotations

from typing import Any

from tresym.proofs.conditions import defect, shape_of_a_body
from tresym.proofs.flip_definition import symmetric_is_extreme
from tresym.proofs.flip_dynamics import precession_integrand
from tresym.proofs.numbers_in_text import A, B, central_symmetry, lower_exact, upper_exact_value
from tresym.proofs.on_the_separatrix import level_of_a_start
from tresym.proofs.phase_portraits import flip_between
from tresym.proofs.regimes import oscillating

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.motion.quadrature import rigorous
from tresym.racket.notation import *

_square = sin(psi) ** 2
_rate = Symbol("v", real=True)
"""dψ/dφ at the start."""

faster_at_higher_level = Claim(
    says=Derivative(printed.integrand(psi, a, b, gamma, 1, sympy), gamma) < 0,
    given=(*shape_of_a_body, gamma + b * _square > 0),
    proof=by(differentiation),
    note="The flip angle turns faster, at every ψ, the larger γ is.",
)

level_grows_with_the_rate = Claim(
    says=Derivative(_rate**2 * (1 - b * _square) ** 2 / (a + b * _square) - b * _square, _rate) > 0,
    given=(*shape_of_a_body, _rate > 0),
    proof=by(differentiation),
    note="γ of a start, by `level_of_a_start`.",
)


def _level(start: Any, rate: Any, m: Any) -> Any:
    """γ of the start (ψ₀, dψ/dφ) of the standard racket."""
    square = arb(B) * m.sin(start) ** 2
    return rate * rate * (1 - square) ** 2 / (arb(A) + square) - square


def _time(start: Any, turn: Any, level: Any) -> Any:
    """Δφ in which ψ goes from ``start`` to ``start + turn``."""
    p, q = arb(A), arb(B)
    return rigorous(start, p, q, level) - rigorous(start + turn, p, q, level)


def _can_flip(reach: Any, m: Any) -> Any:
    """Positive if a start with |ψ₀| and |dψ/dφ| up to ``reach`` might flip by 5π/6 in one turn.

    It passes from ``reach`` to 5π/6 − ``reach`` on its way, at a level of reach²/a at most.
    """
    return 2 * m.pi - _time(reach, 5 * m.pi / 6 - 2 * reach, reach * reach / arb(A))


_USED = (faster_at_higher_level, level_grows_with_the_rate, level_of_a_start, central_symmetry)


def _turns_enough(rate: str) -> Any:
    """Positive if the start flips by 5π/6 at least."""
    speed = arb(rate)
    return lambda psi0, m: 2 * m.pi - _time(psi0, 5 * m.pi / 6, _level(psi0, speed, m))


def _turns_too_much(psi0: Any, m: Any) -> Any:
    """Positive if the start with dψ/dφ = 3/10 flips by 7π/6 at most."""
    return _time(psi0, 7 * m.pi / 6, _level(psi0, arb("0.3"), m)) - 2 * m.pi


two_rectangles = Claim(
    says="The standard racket flips by π within π/6 from |ψ₀| ≤ 1/10 with 3/20 ≤ dψ/dφ ≤ 3/10, and "
    "from −1/20 ≤ ψ₀ ≤ 1/10 with 1/10 ≤ dψ/dφ ≤ 3/20.",
    proof=Boxes(
        (
            Bound(_turns_enough("0.15"), box(("-1/10", "1/10"))),
            Bound(_turns_enough("0.1"), box(("-1/20", "1/10"))),
            Bound(_turns_too_much, box(("-1/10", "1/10"))),
        ),
        ("psi0",),
        "the standard racket",
        claims=_USED,
    ),
    note="At the least rate a start flips enough, and at the largest not too much.",
)

_width, _height, _whole = (Symbol(name, real=True) for name in ("width", "height", "whole"))
_share = _width * _height / _whole
_whole_half = {_whole: Rational(2, 10) * Rational(3, 10)}

share_of_the_rectangles = Claim(
    says=equal(
        at(_share, {_width: Rational(2, 10), _height: Rational(3, 20), **_whole_half})
        + at(_share, {_width: Rational(3, 20), _height: Rational(1, 20), **_whole_half}),
        Rational(5, 8),
    ),
    proof=by(evaluating),
    note="Of the half of the rectangle with dψ/dφ > 0; the other is its image.",
)

likely_near = Claim(
    says="Of the starts with |ψ₀| ≤ 1/10 and |dψ/dφ| ≤ 3/10 five in eight or more flip by π within "
    "π/6, for the standard racket.",
    proof=all_of(two_rectangles, share_of_the_rectangles, central_symmetry),
    where=line(283),
    note="A rectangle about the unstable point, such as the figure marks; likely is read as the "
    "share of its area.",
)

near_flip_close = Claim(
    label="near_flip_likely",
    says="However near the unstable point the starts are, a near flip may happen: within 1/100 of "
    "it the standard racket flips by 5π/6 or more from some.",
    paper_says="“When we consider initial conditions close to this point, Fig. 10 shows that a "
    "near flip is very likely to happen.” Read as: from most starts in a rectangle about it.",
    proof=Boxes(
        (Bound(_can_flip, box(("1/100", "1/100")), precision=128),),
        ("reach",),
        "the standard racket, |psi0| and |dpsi/dphi| up to reach",
        claims=_USED[:3],
    ),
    where=line(283),
    expect=Verdict.REFUTED,
    amended_by=(likely_near,),
    note="The point itself is at rest, and so nearly are the starts next to it: none flips in one "
    "turn. In a rectangle that is not too small most do.",
)

narrow_swing = Claim(
    says=asin(sqrt(-gamma / b)) > epsilon,
    given=(*oscillating, *defect, -gamma - b * sin(epsilon) ** 2 > 0),
    proof=(
        step(
            (-gamma - b * sin(epsilon) ** 2) / (b * (sqrt(-gamma / b) + sin(epsilon))),
            applying("sin"),
            inverses,
            roots,
            trigonometry,
        ),
    ),
    note="With ε = π/12, ψ_max − ψ_min = π − 2 arcsin √(|γ|/b) < 5π/6: no start flips enough.",
)


def _overshoots(level: Any, m: Any) -> Any:
    """Positive if the symmetric start flips by more than 7π/6."""
    return m.pi - rigorous(-m.pi / 12, arb(A), arb(B), level)


every_start_overshoots = Claim(
    says="At γ = 0.0104 the standard racket flips by more than 7π/6 from every start.",
    proof=Boxes(
        (Bound(_overshoots, box(("13/1250", "13/1250"))),),
        ("gamma",),
        "the standard racket",
        claims=(symmetric_is_extreme, faster_at_higher_level),
    ),
    note="The symmetric start flips least there; and all flip by more at every larger γ.",
)

far_from_separatrix = Claim(
    says="Far from the separatrix, at γ ≥ 0.0104 and at γ ≤ −0.0043, the standard racket shows no "
    "effect from any start.",
    proof=all_of(every_start_overshoots, faster_at_higher_level, narrow_swing, flip_between),
    where=line(272),
    note="Both are near the 10⁻² of the paper, which says approximately; b sin²(π/12) is 0.00422.",
)


def _misses(gamma: Any, m: Any) -> Any:
    """Positive if the symmetric motion of the standard racket misses the tolerance at ``gamma``.

    F falls with ε, so −π/12 < ε < π/12 exactly when F(π/12, γ) < π < F(−π/12, γ).
    """
    below, above = (rigorous(side * m.pi / 12, arb(A), arb(B), gamma) for side in (-1, 1))
    return (m.pi - below).max(above - m.pi)


no_tre_far = Claim(
    says="The standard racket shows no effect where |γ| > 10⁻², exactly.",
    paper_says="“the TRE does not occur far from the separatrix, approximately when |γ| > "
    "10^{−2}.” Read as: where |γ| is larger by 4 % or more.",
    proof=Boxes(
        (Bound(_misses, box(("51/5000", "51/5000"))),),
        ("gamma",),
        "the standard racket, symmetric start",
        claims=(precession_integrand,),
    ),
    where=line(272),
    expect=Verdict.REFUTED,
    amended_by=(far_from_separatrix, upper_exact_value, lower_exact),
    note="The symmetric start flips for −0.00418 ≤ γ ≤ 0.01035.",
)

label_claims(globals())
