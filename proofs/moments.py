"""Near the separatrix: how the integral F is split, and how large its fourth moment is.

√(ab) F is the sum of a logarithm and of an integral with sin²ψ in its numerator (`split_integrand`,
`split_logarithm`); a part of that integral is elementary (`split_rest`).

The second derivative of F along a candidate contains ∫ sin⁴ψ (u + sin²ψ)^{−5/2} dψ from e to π/2,
with u = γ/b. For u > 0 its integrand is at most 1/sin ψ (`moment_below_cosecant`). For u ≤ 0 the
integrand decreases as sin ψ increases, and so does cos ψ. With z, the mean of cos ψ, the integral
is therefore at most 1/z times the integral with the weight cos ψ (`mean_of_the_product`), which is
elementary (`moment_over_sine`). Below, y is cos ψ, and c is cos e: dψ = −dy/√(1 − y²), and
z = (1 − √(1 − c²))/arcsin c.
"""

from tresym.proofs.conditions import shape

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

y, c, z = (Symbol(name, real=True) for name in ("y", "c", "z"))
"""cos ψ, cos e, and a number between 0 and cos e: the mean of cos ψ."""

_falling = (c > 0, c < 1, u <= 0, u + 1 - c**2 > 0, z > 0, z <= c)
_on_the_way = (*_falling, y >= 0, y <= c)
_ends = (y, 0, c)

mean_below_the_first = Claim(
    says=c * asin(c) - (1 - sqrt(1 - c**2)) >= 0,
    given=(c > 0, c < 1),
    proof=manifest,
    note="The mean of cos ψ from e to π/2 is at most cos e.",
)

mean_is_positive = Claim(says=1 - sqrt(1 - c**2) > 0, given=(c > 0, c < 1), proof=manifest)

_root, _mean_root = sqrt(u + 1 - y**2), sqrt(u + 1 - z**2)
_cosecant = 1 / sqrt(1 - y**2)


def _moment(root: Expr) -> Expr:
    """sin⁴ψ (u + sin²ψ)^{−5/2} by powers of ``root`` = √(u + sin²ψ)."""
    return u**2 / root**5 - 2 * u / root**3 + 1 / root


moment_by_powers = Claim(
    says=equal((1 - y**2) ** 2 / _root**5, _moment(_root)), given=_on_the_way, proof=by(roots)
)

_powers: tuple[tuple[int, Expr], ...] = ((1, Integer(1)), (3, -2 * u), (5, u**2))
_less = sum(factor * (1 / _root**power - 1 / _mean_root**power) for power, factor in _powers)
"""The moment less its value at the mean."""
_steep = (y - z) ** 2 * (y + z) / (_root * _mean_root * (_root + _mean_root))

moment_falls = Claim(
    says=_less * (y - z) * _cosecant >= 0,
    given=(*(y >= 0, z > 0, u <= 0, 1 - y**2 > 0), *(u + 1 - y**2 > 0, u + 1 - z**2 > 0)),
    proof=(
        step(
            _steep
            * _cosecant
            * sum(
                factor / (_root**i * _mean_root ** (power - 1 - i))
                for power, factor in _powers
                for i in range(power)
            ),
            roots,
        ),
    ),
    note="The difference of the moment and its value at the mean has the sign of cos ψ − z.",
)

_weighted = Integral(_moment(_root) * (y - z) * _cosecant, _ends)
_at_mean = _moment(_mean_root)

mean_of_the_product = Claim(
    says=_weighted - _at_mean * (1 - sqrt(1 - c**2) - z * asin(c)) >= 0,
    given=_falling,
    knowing=(
        u + 1 - z**2 > 0,
        Under(1 - y**2 > 0, (y >= 0, y <= c)),
        Under(u + 1 - y**2 > 0, (y >= 0, y <= c)),
    ),
    proof=(
        step(
            _weighted - Integral(_at_mean * (y - z) * _cosecant, _ends),
            integrating(_at_mean * (-sqrt(1 - y**2) - z * asin(y))),
            inverses,
            roots,
        ),
        step(Integral(_less * (y - z) * _cosecant, _ends), collecting(), citing(moment_falls)),
    ),
    note="With the mean for z the second term is 0: the integral of the moment with the weight "
    "cos ψ is at least z times that without. (Chebyshev's inequality for two falling functions.)",
)

_sum = sqrt(u + x**2)
_primitive = log(x + _sum) - x / _sum - x**3 / (3 * _sum**3)

moment_over_sine = Claim(
    says=equal(
        Integral(x**4 / _sum**5, (x, x0, 1)), _primitive.subs(x, 1) - _primitive.subs(x, x0)
    ),
    given=(x0 > 0, x0 < 1, u + x0**2 > 0),
    proof=by(integrating(_primitive)),
    note="x is sin ψ, and x₀ is sin e.",
)

moment_below_cosecant = Claim(
    says=1 / x - x**4 / _sum**5 >= 0, given=(x > 0, u > 0), proof=manifest
)

_sine_root, _cosine = sqrt(1 + b / a * x**2), sqrt(1 - x**2)
_bounded = 1 / (1 + _cosine) - b / _sine_root - b / a / (_sine_root * (1 + _sine_root))
"""j(ψ), with x for sin ψ."""
_at_zero = Rational(1, 2) - b - b / a / 2
_inside = (x > 0, x < 1)

split_integrand = Claim(
    says=equal((1 - b * x**2) / _sine_root, _cosine + x**2 * _bounded),
    given=(*shape, *_inside),
    proof=by(roots),
)

_gap = (1 - b / a + b / a * x**2) / (1 + _sine_root * _cosine)

split_rest = Claim(
    says=equal(
        _bounded - _at_zero * _cosine,
        x**2
        * (
            (2 + _cosine) / (2 * (1 + _cosine) ** 2)
            - b * _gap / _sine_root
            - b
            / a
            * (_gap + 1 / (1 + _cosine) - b / a * _cosine)
            / (2 * _sine_root * (1 + _sine_root))
        ),
    ),
    given=(*shape, *_inside),
    proof=by(roots),
    note="The remainder after subtracting its value at ψ = 0 times cos ψ has sin²ψ as a factor.",
)

split_logarithm = Claim(
    says=equal(Integral(1 / _sum, (x, x0, 1)), log((1 + sqrt(1 + u)) / (x0 + sqrt(u + x0**2)))),
    given=(x0 > 0, x0 < 1, u + x0**2 > 0),
    proof=by(integrating(log(x + _sum)), exponentials),
)

fourth_moment = (
    split_integrand,
    split_rest,
    split_logarithm,
    mean_below_the_first,
    mean_is_positive,
    moment_by_powers,
    mean_of_the_product,
    moment_over_sine,
    moment_below_cosecant,
)
"""What the enclosure of the second derivative rests on."""

label_claims(globals())
