"""Section 6, up to the theorem: what a flip is, and which motions are studied.

- display (18), `eq_robust_gen`: Δφ is the integral of f, which is (33), `d33`; `full_turn`:
  the paper considers one full turn;
- `elementary_at_the_top`: for some γ the equation of the flip has an elementary solution;
- (20), `eq_psi0psif`: the symmetric motion; (21), `eqdefect`: its flip is π − 2ε;
- `symmetric_is_extreme`: the symmetric motion is extremal among all motions with the same γ;
- (25), `d25`: ε₀ by an exponential equation;
- (28), `eq_TRE`: when a motion counts as a flip.
"""

from __future__ import annotations

from typing import Any

from tresym.proofs import flip_dynamics, regimes, separatrix
from tresym.proofs.axioms import MOTION
from tresym.proofs.conditions import STANDARD, shape

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

_integrand = printed.integrand(psi, a, b, gamma, S, sympy)
_square = sin(psi) ** 2
_slow, _fast = 1 - b * _square, a + b * _square

eq_robust_gen = Claim(
    says=equal(Delta_phi, Integral(_integrand, (psi, psi0, psi_f))),
    given=(*shape, gamma > 0),
    proof=Definition(),
    where=display(18),
    note="For γ ≤ 0 this holds until the flip angle reaches a turning point; d19 is the integrand.",
)

full_turn = Claim(
    says=equal(Delta_phi, 2 * pi),
    proof=Definition(assumes="the turn that is studied"),
    where=display(18),
    note="The paper considers one turn of the handle.",
)

flip_angle = Claim(says=equal(Delta_psi, psi_f - psi0), proof=Definition())

integrand_of_the_turn = Claim(
    **jointly(flip_dynamics.eq_dpsidphi, flip_dynamics.d19),
    where=line(201),
)

# -- integration in elementary functions ----------------------------------------------------------

_inside = (psi > -pi / 2, psi < pi / 2, cos(psi) > 0)

d33 = Claim(**jointly(flip_dynamics.d19), where=display(33))

elementary_at_the_top = Claim(
    says=equal(
        Derivative((1 + a) / sqrt(a * (a + b)) * atan(sqrt((a + b) / a) * tan(psi)) - psi, psi),
        _slow / _fast,
    ),
    given=(*shape, *_inside),
    proof=by(differentiation, trigonometry, roots),
    note="For γ = a the integrand is (1 − b sin²ψ)/(a + b sin²ψ).",
)

integrand_at_the_top = Claim(
    says=equal(at(_integrand, {gamma: a, S: 1}), _slow / _fast),
    given=shape,
    proof=by(evaluating, roots),
    shown=r"\left.\frac{d\phi}{d\psi}\right|_{\gamma=a,\,S=1} = "
    r"\frac{1-b\sin^2\psi}{a+b\sin^2\psi}",
)

elementary_levels = Claim(
    **jointly(separatrix.d36, integrand_at_the_top, elementary_at_the_top),
)

not_elementary = Claim(
    says="For no γ can the equation of the flip angle be integrated by elementary functions.",
    paper_says="“Eq. (10) cannot be integrated in terms of elementary functions.” Read as: not "
    "for every γ, of which nothing is proved here.",
    proof=Denied((elementary_levels,), {"gamma": fmpq(0)}),
    where=line(198),
    amended_by=(elementary_levels,),
    note="The appendix itself integrates it for γ = 0.",
)

# -- the symmetric motion -------------------------------------------------------------------------

eq_psi0psif = Claim(
    says=Tuple(equal(psi0, epsilon), equal(psi_f, pi - epsilon)),
    proof=Definition(),
    where=display(20),
)

eqdefect = Claim(
    says=equal(Delta_psi, pi - 2 * epsilon),
    proof=by(substituting(flip_angle, eq_psi0psif)),
    where=display(21),
)

symmetric_turn = Claim(
    says=equal(Integral(_integrand, (psi, epsilon, pi - epsilon)), 2 * pi),
    given=(*shape, gamma > 0),
    proof=(
        step(Delta_phi, substituting(eq_psi0psif, eq_robust_gen)),
        step(None, substituting(full_turn)),
    ),
    where=line(213),
    note="The meaning of ε: in one turn of the handle the symmetric motion goes from ε to π − ε.",
)

fig_symtraj = Claim(
    **jointly(symmetric_turn, eqdefect),
    where=line(227),
)

perfect_is_zero = Claim(
    says=Equivalent(equal(epsilon, 0), equal(pi - 2 * epsilon, pi)),
    proof=by(multiplying(Integer(-2)), adding(pi)),
    where=line(217),
)

_start, _turned = Symbol("psi_start", real=True), Symbol("Psi", real=True)
_shifted = _integrand.subs(psi, x)

flip_for_large_range = Claim(
    says=equal(
        Integral(_integrand, (psi, _start, _start + pi)), Integral(_integrand, (psi, 0, pi))
    ),
    given=(*shape, b < 1, gamma > 0, _start > 0, pi - _start > 0),
    proof=(
        step(
            Integral(_integrand, (psi, _start, pi)) + Integral(_integrand, (psi, pi, _start + pi)),
            cutting(pi),
        ),
        step(
            Integral(_integrand, (psi, _start, pi)) + Integral(_shifted, (x, 0, _start)),
            changing_variable(psi - pi),
        ),
        step(None, cutting(_start)),
    ),
    where=line(272),
    note=(
        "At a γ > 0 for which one motion flips by exactly π in one "
        "turn, all motions do; for γ near it, they nearly do."
    ),
)

_rate = printed.psi_rate(psi, a, b, gamma, S, sympy)

equal_rates = Claim(
    says=equal(at(_rate, {psi: pi - psi}), _rate),
    given=(*shape, b < 1, gamma + b * _square > 0),
    proof=by(evaluating, trigonometry),
    shown=r"V(\pi-\psi) = V(\psi),\quad V = \frac{d\psi}{d\phi}",
)

_q = Symbol("q", real=True)


def _by_square(square: Any) -> Any:
    """f for S = 1 as a function of sin²ψ."""
    return (1 - b * square) / (sqrt(a + b * square) * sqrt(gamma + b * square))


def _product(square: Any) -> Any:
    return sqrt(a + b * square) * sqrt(gamma + b * square)


def _steepness(p: Any, q: Any) -> Any:
    """(f(p) − f(q))/(q − p) for two values of sin²ψ."""
    slower = (1 - b * q) ** 2 * (a + gamma + b * (p + q))
    faster = ((1 - b * q) + (1 - b * p)) * (a + b * q) * (gamma + b * q)
    gap = (1 - b * p) * _product(q) + (1 - b * q) * _product(p)
    return b * (slower + faster) / (_product(p) * _product(q) * gap)


_starts, _ends = sin(x) ** 2, sin(x + _turned) ** 2

turn_gap = Claim(
    says=equal(
        _by_square(_starts) - _by_square(_ends),
        sin(2 * x + _turned) * sin(_turned) * _steepness(_starts, _ends),
    ),
    given=(*shape, b < 1, gamma > 0),
    proof=by(roots, trigonometry),
    note="f where a flip by Ψ starts, less f where it ends. At a symmetric start 2x + Ψ is an odd "
    "multiple of π; up to π/2 before it the sine of 2x + Ψ is positive and up to π/2 after it "
    "negative.",
)

turn_is_steep = Claim(
    says=_steepness(_starts, _ends) > 0,
    given=(*shape, b < 1, gamma > 0),
    proof=manifest,
    note="f decreases with sin²ψ, so it is largest at the unstable points.",
)

_turn = Integral(_integrand, (psi, x, _q))

turn_by_ends = Claim(
    says=Tuple(
        equal(Derivative(_turn, x), -_integrand.subs(psi, x)),
        equal(Derivative(_turn, _q), _integrand.subs(psi, _q)),
    ),
    given=(*shape, b < 1, gamma > 0, _q - x > 0),
    proof=by(differentiating_integral(Integer(0))),
    note="For a flip from x to q = x + Ψ the turn changes by f(q) − f(x) with the start: by "
    "`turn_gap` it falls up to the symmetric start and rises after it, or the other way where "
    "sin Ψ < 0.",
)

symmetric_is_extreme = Claim(
    says="At fixed γ > 0 the symmetric start flips most in a given turn of the handle where its "
    "flip is below π, and least where it is between π and 2π, among all starts.",
    proof=in_words(equal_rates, turn_by_ends, turn_gap, turn_is_steep, regimes.rotating_speed),
    note="A flip by Ψ < π needs the least turn from there, and one by π < Ψ < 2π the most; and "
    "every turn grows with its flip.",
    quotes=(MOTION,),
)

symmetric_maximum = Claim(
    says="Among all starts with the same γ the symmetric one has the largest flip in one turn.",
    kind="bound",
    means=Integral(_integrand.subs(S, 1), (psi, _start, _start + _turned)) >= 2 * pi,
    given=(
        *shape,
        gamma > 0,
        Integral(_integrand.subs(S, 1), (psi, (pi - _turned) / 2, (pi + _turned) / 2)) > 2 * pi,
    ),
    proof=Counterexample(
        {**STANDARD, "gamma": fmpq(1, 100), "psi_start": fmpq(47, 50), "Psi": fmpq(21, 5)}
    ),
    where=line(211),
    amended_by=(symmetric_is_extreme,),
    note="Where the symmetric start needs more than a turn for a flip by Ψ, so would all others. "
    "Where the symmetric flip is beyond π it is the smallest. The paper uses such γ itself.",
)

eps0_shape_only = Claim(
    **jointly(separatrix.one_flip_defect),
    where=line(222),
)

d25 = Claim(
    **jointly(separatrix.d37, separatrix.stable_equation, separatrix.one_flip_defect),
    where=display(25),
    note="ε₀ (here ε) is its only root.",
)

# -- when a flip counts ---------------------------------------------------------------------------

eq_TRE = Claim(
    says=Tuple(Ge(Delta_psi, pi - pi / 6), Le(Delta_psi, pi + pi / 6)),
    given=(2 * epsilon <= pi / 6, 2 * epsilon >= -pi / 6),
    proof=by(substituting(eqdefect)),
    where=display(28),
    note="The tolerance of the paper: it holds for −π/12 ≤ ε ≤ π/12.",
)

tre_only_if = Claim(
    says="A flip within π/6 of π has a defect between −π/12 and π/12.",
    given=(pi - 2 * epsilon >= 5 * pi / 6, pi - 2 * epsilon <= 7 * pi / 6),
    means=Tuple(epsilon <= pi / 12, epsilon >= -pi / 12),
    proof=formally(),
    where=line(261),
)

label_claims(globals())
