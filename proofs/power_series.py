"""The series for ε₀ in powers of ε*²: what its coefficients are, and how large.

With w = e², the equation log(ε₀/ε*) = Q(w) becomes w = yφ(w), where y = ε*² and φ = exp 2Q.

*Coefficients.* For W(x, y) = x + yφ(W) and any H, ∂W/∂y = φ(W) ∂W/∂x. Applying `lagrange_step` n
times shows that the n-th derivative of H(W) by y is the (n − 1)-th derivative by x of
φ(W)ⁿ H′(W) ∂W/∂x, which is φⁿH′ at y = 0. With H = exp Q the coefficient of yⁿ in ε₀/ε* is
c_n = [wⁿ] exp((2n + 1)Q)/(2n + 1).

*Sizes.* By `exponent_slope` 1 − 2wQ′ is a product of power series. The coefficients of √w/sin √w
are positive: first those of u = 1/x − cot x by `cotangent_series`, then those of v = 1/sin x − 1/x
by `cosecant_series`, by induction, since the right sides contain sums and products of earlier
coefficients. Hence, with sinh² for sin² and −R for R, the coefficients are bounded by those of a
function with positive coefficients, whose value at ρ is 1 + 2q (`majorant` in the code). The
coefficients of Q are at most q/ρⁿ, since each term of a positive series is at most its sum, and
|c_n| ≤ e^q (e^{2q}/ρ)ⁿ/(2n + 1).

*Sum.* If τ = y e^{2q}/ρ ≤ 1/4, the series for w has terms of at most ρτⁿ/n, with a sum below ρ
(`stays_inside`). It may therefore be substituted into the series of Q, and it solves w = yφ(w). It
is real, hence w > 0, and √w solves the equation of ε₀, which has one root. The remainder after N
terms is at most (13/5) τ^{N+1}/((2N + 3)(1 − τ)), and by `geometric_tail` at most τ^N/(2N + 3).
"""

from tresym.proofs.conditions import defect, shape
from tresym.proofs.exponent import exponent

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

phi, phi_slope, H_slope, H_bend, W_x, W_xx, n, t = (
    Symbol(name, real=True)
    for name in ("phi", "phiprime", "Hprime", "Hprimeprime", "W_x", "W_xx", "n", "t")
)
"""Values at W of φ, φ′, H′ and H″; ∂W/∂x and ∂²W/∂x²; a number of derivatives; a step."""


def _along(rate: Expr, rate_of_slope: Expr, power: Expr) -> Derivative:
    """The rate of φ(W)^power H′(W) ∂W/∂x where W changes at ``rate``, and so does ∂W/∂x."""
    moved = (
        (phi + phi_slope * rate * t) ** power
        * (H_slope + H_bend * rate * t)
        * (W_x + rate_of_slope * t)
    )
    return Subs(Derivative(moved, t), t, 0)


lagrange_step = Claim(
    says=equal(_along(phi * W_x, phi_slope * W_x**2 + phi * W_xx, n), _along(W_x, W_xx, n + 1)),
    given=(phi > 0,),
    proof=by(differentiation, exponentials),
    note="By y on the left, where W changes at the rate φ ∂W/∂x, and ∂W/∂x at the rate that this "
    "has by x; by x on the right.",
    shown=r"\frac{\partial}{\partial y}\Bigl(\varphi(W)^n H'(W)\frac{\partial W}{\partial x}\Bigr)"
    r" = \frac{\partial}{\partial x}"
    r"\Bigl(\varphi(W)^{n+1} H'(W)\frac{\partial W}{\partial x}\Bigr)",
)

_u, _v = 1 / x - cos(x) / sin(x), 1 / sin(x) - 1 / x
_half_turn = (x > 0, x < pi, sin(x) > 0)

cotangent_series = Claim(
    says=equal(x * Derivative(_u, x) + 2 * _u, x + x * _u**2),
    given=_half_turn,
    proof=by(differentiation),
    note=(
        "On the left is n + 2 times the coefficient, on the right "
        "are sums of products of earlier coefficients."
    ),
)

cosecant_series = Claim(
    says=equal(x * Derivative(_v, x) + _v, _u + x * _u * _v),
    given=_half_turn,
    proof=by(differentiation),
    note="On the left is n + 1 times the coefficient.",
)

exponent_slope = Claim(
    says=equal(
        epsilon * Derivative(exponent, epsilon),
        1
        - (1 - b * sin(epsilon) ** 2)
        * epsilon
        / (sin(epsilon) * sqrt(1 + b / a * sin(epsilon) ** 2)),
    ),
    given=(*shape, *defect),
    proof=by(differentiation, trigonometry, roots),
    note="2w dQ/dw, w = e².",
)

_quarter = (x > 0, x <= Rational(1, 4))

stays_inside = Claim(says=1 - x / (1 - x) > 0, given=_quarter, proof=manifest)

geometric_tail = Claim(says=1 - Rational(13, 5) * x / (1 - x) > 0, given=_quarter, proof=manifest)

coefficient_sizes = (cotangent_series, cosecant_series, exponent_slope)
"""What bounds the coefficients of Q."""

label_claims(globals())
