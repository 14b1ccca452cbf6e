"""Appendix: the argument for the leading term of ε₀ by an implicit function, step by step.

- display (40), `d40`, `mu_by_lambda`: the parameters λ and μ; (41), `reduced_equation`: ε₀ by them;
- (42), `defect_by_unknown`, `u_flat`: ε₀ by the unknown u; `flat_function`: e^{−1/s} is flat
  from one side only, and so ε₀(u, λ, μ) is smooth for λ ≥ 0;
- (43), `equ`: the equation G = 0; `defect_of_a_product`: the arguments of ε₀ as printed;
- `slope_by_u`, `slope_by_lambda`, `slope_by_mu`: the derivatives of G where ε₀ is e + p·(…), with
  the slope p of ε₀ a symbol; at the origin they are 1, 0 and 0;
- (44), `implicit_rule`, `d44`: du/dλ by the implicit function theorem;
- (45), `d45`, `chain_rule_of_G`: `dmu_dlambda_zero`: ∂μ/∂λ is not 0 as deduced; dG/dλ = 0
  follows from ∂G/∂μ = 0 instead, and with it du/dλ = 0, which (46) shows of u itself.
"""

from __future__ import annotations

from typing import Any

from tresym.proofs.axioms import IMPLICIT_FUNCTION
from tresym.proofs.conditions import STANDARD, shape
from tresym.proofs.separatrix import flip_defect, stable_equation

from tresym.ledger.evidence.asymptotics import t
from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

_small = (mu > -1, mu < 1)

d40 = Claim(
    says=Tuple(equal(lam, 1 / sqrt(a * b)), equal(mu, sqrt(b / (a + b)))),
    given=shape,
    proof=Definition(),
    where=display(40),
)

mu_by_lambda = Claim(
    says=equal(sqrt(b / (a + b)), printed.mu_of_lambda(lam, b, sympy)),
    given=shape,
    proof=by(substituting(d40), roots),
    where=display(40),
)

small_together = Claim(
    says=b * lam - printed.mu_of_lambda(lam, b, sympy) >= 0,
    given=(b > 0, lam > 0),
    proof=manifest,
    where=line(353),
    note="0 < μ ≤ bλ ≤ λ, so μ → 0 with λ because b ≤ 1.",
)

right_sides = Claim(
    says=equal(
        printed.implicit_right_reduced(epsilon0, lam, mu, sympy),
        printed.implicit_right(epsilon0, a, b, sympy),
    ),
    given=shape,
    proof=by(substituting(d40), roots),
    where=line(354),
    note="Only the right side of the previous equation is rewritten.",
)

reduced_equation = Claim(
    label="equation",
    says=equal(epsilon0, printed.implicit_right_reduced(epsilon0, lam, mu, sympy)),
    kind="bound",
    given=shape,
    proof=Counterexample(STANDARD, (flip_defect, d40)),
    where=display(41),
    amended_by=(stable_equation, right_sides),
    note="The higher orders of the equation before are dropped, one part in a thousand for the "
    "standard racket.",
    fault=Fault.ROUNDING,
)

_in_front = 2 * sqrt(1 - mu**2)
_by_u = printed.defect_of_u(u, lam, mu, sympy)

_known_defect = (epsilon0 > 0, lam > 0, *_small)

unknown = Claim(
    says=equal(u, -lam * log(epsilon0 / _in_front) - pi - asin(mu)),
    given=_known_defect,
    proof=Definition(),
    note="The unknown u of the paper, defined from ε₀.",
)

defect_by_unknown = Claim(
    label="u",
    says=equal(epsilon0, _by_u),
    given=_known_defect,
    proof=by(substituting(unknown), exponentials, roots),
    where=display(42),
)

u_flat = Claim(
    says=equal(
        _by_u, _in_front * at(printed.flat_function(x, sympy), {x: lam / (pi + asin(mu) + u)})
    ),
    given=(lam > 0, mu > 0, mu < 1, u > -1, pi + asin(mu) + u > 0),
    proof=by(evaluating),
    where=display(42),
    shown=r"2\sqrt{1-\mu^2}\,e^{-(\pi+u+\arcsin\mu)/\lambda} = "
    r"2\sqrt{1-\mu^2}\,g\left(\frac{\lambda}{\pi+u+\arcsin\mu}\right),\quad g(s) = e^{-1/s}",
)

_arc = asin(mu * cos(epsilon))
_given = (lam > 0, *_small, 1 - mu**2 > 0, 1 - mu**2 * cos(epsilon) ** 2 > 0)

equ = Claim(
    says=Equivalent(
        equal(_by_u, printed.implicit_right_reduced(epsilon, lam, mu, sympy)),
        equal(u + asin(mu) - _arc, 0),
    ),
    given=_given,
    proof=(
        step(
            equal(exp(-(pi + asin(mu) + u) / lam), exp(-(pi + _arc) / lam)),
            multiplying(1 / _in_front),
            roots,
        ),
        step(equal(-(pi + asin(mu) + u) / lam, -(pi + _arc) / lam), applying("log"), exponentials),
        step(equal(pi + asin(mu) + u, pi + _arc), multiplying(-lam)),
        step(equal(u + asin(mu) - _arc, 0), adding(-pi - _arc)),
    ),
    where=display(43),
    note="Exact for the reduced equation, with no higher orders; ε₀ depends on (u, λ, μ), where "
    "the paper prints a product: `defect_of_a_product`.",
)

_twice = [(Symbol(f"lambda{n}", real=True), Symbol(f"mu{n}", real=True)) for n in (1, 2)]

defect_of_a_product = Claim(
    says="ε₀ depends on u and on the product λμ: it is written ε₀(u, λμ).",
    means=Under(
        equal(*(printed.defect_of_u(u, *pair, sympy) for pair in _twice)),
        Tuple(equal(*(sympy.Mul(*pair) for pair in _twice))),
    ),
    given=tuple(part > 0 for pair in _twice for part in pair),
    proof=Counterexample(
        {
            "u": fmpq(0),
            "lambda1": fmpq(1, 2),
            "mu1": fmpq(1, 4),
            "lambda2": fmpq(1, 4),
            "mu2": fmpq(1, 2),
        }
    ),
    where=display(43),
    amended_by=(equ,),
    note="A comma is missing: ε₀ is that of the display before, a function of u, λ and μ.",
    fault=Fault.MISPRINT,
)

# -- the flat function ----------------------------------------------------------------------------

_ORIGIN = Tuple(u, lam, mu), Tuple(0, 0, 0), 0
"""Where u, λ and μ tend to, from any side."""
O, o = Function("O"), Function("o")  # noqa: E741
_flat = printed.flat_function(x, sympy)

flat_from_above = Claim(
    says="e^{−1/s} = o(s¹⁰) as s → 0 from above; with the value 0 for s ≤ 0 it is flat at 0.",
    means=order(equal(_flat, o(x**10)), x),
    proof=Decided(),
    kind="order",
    expect=Verdict.PROVED,
)

flat_function = Claim(
    says="e^{−1/s} with the value 0 at 0 is flat there: from below, too, it is O(s) as s → 0.",
    means=order(equal(_flat, O(x)), x, side=-1),
    proof=Decided(),
    kind="order",
    where=line(358),
    expect=Verdict.REFUTED,
    amended_by=(flat_from_above,),
    note="For s < 0 it is unbounded. The argument needs only s ≥ 0.",
    fault=Fault.REASON,
)

eps0_smooth = Claim(
    says="ε₀(u, λ, μ) is smooth at the origin: it is O(1) near it.",
    means=order(equal(_by_u, O(Integer(1))), *_ORIGIN),
    proof=Decided(),
    kind="order",
    where=line(363),
    expect=Verdict.REFUTED,
    amended_by=(flat_from_above,),
    note="For λ < 0 it is unbounded; on λ ≥ 0 it is smooth, and so is G.",
    fault=Fault.REASON,
)

slopes_of_the_defect = Claim(
    says=Tuple(
        equal(Derivative(_by_u, u), -_by_u / lam),
        equal(Derivative(_by_u, lam), _by_u * (pi + asin(mu) + u) / lam**2),
        equal(Derivative(_by_u, mu), -_by_u * (mu / (1 - mu**2) + 1 / (lam * sqrt(1 - mu**2)))),
    ),
    given=(lam > 0, *_small),
    proof=by(differentiation, roots),
    note="ε₀ times a factor that is at most 6/λ² for λ ≤ 1, 0 ≤ μ ≤ 1/2 and −1 ≤ u ≤ 1.",
)

_path = (lam > 0, mu >= 0, mu < 1, u >= -1)

defect_below_flat = Claim(says=2 * exp(-2 / lam) >= _by_u, given=_path, proof=manifest)

slopes_vanish = Claim(
    says="12 e^{−2/λ}/λ² = o(λ¹⁰) as λ → 0 from above.",
    means=order(equal(12 * exp(-2 / lam) / lam**2, o(lam**10)), lam),
    proof=Decided(),
    kind="order",
    expect=Verdict.PROVED,
)

defect_is_flat = Claim(
    **jointly(slopes_of_the_defect, defect_below_flat, slopes_vanish),
)

# -- the derivatives of G -------------------------------------------------------------------------


def _g_with(defect: Any, mu_: Any = mu) -> Any:
    """G with ε₀ written as ``defect``."""
    return u + asin(mu_) - asin(mu_ * cos(defect))


_root = sqrt(1 - mu**2 * cos(epsilon) ** 2)

slope_by_u = Claim(
    says=equal(
        Subs(Derivative(_g_with(epsilon + x * u), u), u, 0), 1 + mu * sin(epsilon) * x / _root
    ),
    given=_given,
    proof=by(differentiation, roots),
    note="p (here x) is ∂ε₀/∂u.",
)

slope_by_lambda = Claim(
    says=equal(
        Subs(Derivative(_g_with(epsilon + x * lam), lam), lam, 0), mu * sin(epsilon) * x / _root
    ),
    given=_given[1:],
    proof=by(differentiation, roots),
)

slope_by_mu = Claim(
    says=equal(Derivative(_g_with(epsilon), mu), 1 / sqrt(1 - mu**2) - cos(epsilon) / _root),
    given=_given[1:],
    proof=by(differentiation, roots),
    note=(
        "For an ε₀ whose derivative by μ is 0; otherwise that "
        "derivative would appear with the factor μ sin ε₀."
    ),
)

dG_dlambda, dG_du, du_dlambda = (
    Symbol(name, real=True) for name in ("dG_dlambda", "dG_du", "du_dlambda")
)
"""Derivatives at the origin, as symbols of their own."""

at_origin = {mu: Integer(0), epsilon: Integer(0)}
"""μ = 0, and ε₀ = 0 there because e^{−1/s} is."""

G_at_origin = Claim(
    says=equal(at(_g_with(epsilon), {**at_origin, u: Integer(0)}), 0),
    proof=by(evaluating),
    where=line(367),
    shown=r"G(0, 0, 0) = 0",
)


def _at_origin(
    label: str, slope: Claim, value: int, *reasons: Reason, **rest: Any
) -> tuple[Claim, Claim]:
    """The claim that a derivative of G, which ``slope`` states, has this value at the origin."""
    says_value = equal(at(parts_of(slope.says)[0].args[1], at_origin), value)
    name = label.removeprefix("G_").removesuffix("_at_origin")
    letter = name if len(name) == 1 else "\\" + name
    shown = rf"\frac{{\partial G}}{{\partial {letter}}}(0, 0, 0) = {value}"
    proof = by(evaluating, *reasons)
    found = Claim(label=f"{label}_value", says=says_value, proof=proof, shown=shown)
    return found, Claim(label=label, **jointly(slope, found), **rest)


G_is_smooth = Claim(
    says="G is smooth at the origin: ∂G/∂λ is O(1) near it.",
    means=order(
        equal(Derivative(printed.implicit_function(u, lam, mu, sympy), lam), O(Integer(1))),
        *_ORIGIN,
    ),
    proof=Asymptotics({u: Integer(0), lam: -t, mu: t}),
    where=line(367),
    expect=Verdict.REFUTED,
    amended_by=(defect_is_flat,),
    note="G is not smooth for λ < 0, where ε₀ is not small. On λ ≥ 0, which is all that the "
    "argument needs, G is smooth: e^{−1/s} is flat from above.",
)

G_u_value, G_u_at_origin = _at_origin(
    "G_u_at_origin",
    slope_by_u,
    1,
    where=line(375),
)

G_lambda_value, G_lambda_at_origin = _at_origin(
    "G_lambda_at_origin", slope_by_lambda, 0, where=line(379)
)

G_mu_value, G_mu_at_origin = _at_origin(
    "G_mu_at_origin",
    slope_by_mu,
    0,
    trigonometry,
)

_mu_of_lambda = printed.mu_of_lambda(lam, b, sympy)

dmu_dlambda = Claim(
    says=equal(Derivative(_mu_of_lambda, lam), b / sqrt(1 + lam**2 * b**2) ** 3),
    given=(b > 0,),
    proof=by(differentiation, roots),
    note="At λ = 0 it is b, not 0.",
)

dmu_dlambda_zero = Claim(
    says="∂μ/∂λ = 0 at the origin.",
    given=(b > 0,),
    means=equal(parts_of(dmu_dlambda.says)[0].args[1].subs(lam, 0), 0),
    proof=formally(),
    where=line(379),
    expect=Verdict.REFUTED,
    amended_by=(dmu_dlambda, G_mu_at_origin),
    note="The conclusion remains true: in the product (∂G/∂μ)(∂μ/∂λ) the other factor vanishes.",
    fault=Fault.REASON,
)

_G = printed.implicit_function(u, lam, mu, sympy)
_along = printed.implicit_function(u, lam, _mu_of_lambda, sympy)

_by_lambda, _by_mu = (Subs(Derivative(_G, of), mu, _mu_of_lambda) for of in (lam, mu))
_inward = (b > 0, b <= 1, lam > 0)

chain_rule_of_G = Claim(
    says=equal(Derivative(_along, lam), _by_lambda + _by_mu * Derivative(_mu_of_lambda, lam)),
    given=_inward,
    proof=by(differentiation, roots),
    where=display(45),
    note="Along μ = μ(λ), at every λ > 0.",
)

deduced_from_the_chain_rule = Claim(
    says=equal(Derivative(_along, lam) - _by_lambda, _by_mu * Derivative(_mu_of_lambda, lam)),
    given=_inward,
    proof=by(substituting(chain_rule_of_G)),
    where=line(379),
    note="If dG/dλ and ∂G/∂λ vanish, the product vanishes, and hence one of its factors.",
)

d45 = Claim(
    **jointly(chain_rule_of_G, G_lambda_at_origin, G_mu_at_origin, dmu_dlambda),
    where=display(45),
    note="Both terms vanish, the second because ∂G/∂μ does.",
)

implicit_rule = Claim(
    says=Equivalent(
        equal(dG_dlambda + dG_du * du_dlambda, 0), equal(du_dlambda, -dG_dlambda / dG_du)
    ),
    given=(dG_du > 0,),
    proof=by(multiplying(1 / dG_du), adding(-dG_dlambda / dG_du)),
    where=display(44),
    note="On the left G(u(λ), λ, μ(λ)) = 0, differentiated.",
)

d44 = Claim(
    **jointly(implicit_rule, G_at_origin, G_u_at_origin, defect_is_flat),
    where=display(44),
    note="The implicit function theorem, on λ ≥ 0: with |λ| for λ G is smooth on both sides.",
    quotes=(IMPLICIT_FUNCTION,),
)

label_claims(globals())
