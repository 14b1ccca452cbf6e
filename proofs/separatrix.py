"""Appendix, first part: the exact equation for the flip defect on the separatrix.

- display (32), `d32`: the integral of f from ε₀ to π − ε₀ is 2π, which
  defines ε₀ (here ε);
- (34), `d34`, and (35), `d35`: with x = √(b/(a+b)) cos ψ it is an integral in x;
- (36), `d36`: that integral by inverse functions;
- (37), `d37`: the exponential equation, as printed, equivalent to it;
- `stable_equation`: the exponential equation is equivalent to
  tan ε₀ = √(a/(a+b)) / sinh T, T = √(ab)(π + arcsin(√(b/(a+b)) cos ε₀)), where nothing cancels;
- `auxiliary_angle`: the arcsine is arctan(√(b/a) tanh T), which makes it an equation for T alone;
- `unique_root`, `contraction`: that equation has exactly one root, and its map contracts.
"""

from tresym.proofs.conditions import auxiliary, defect, later, shape

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

between = (psi > 0, psi < pi, sin(psi) > 0)
"""On the separatrix the flip angle stays between the unstable points."""

_f = printed.integrand(psi, a, b, 0, 1, sympy)
_on_separatrix = _f.subs(sqrt(b * sin(psi) ** 2), sqrt(b) * sin(psi))
_mu = sqrt(b / (a + b))

d34 = Claim(
    says=equal(x0, printed.auxiliary_variable(epsilon, a, b, sympy)),
    given=(*shape, *defect),
    proof=Definition(),
    where=display(34),
)

_in_x = printed.auxiliary_integrand(x, a, b, sympy)

d32 = Claim(
    says=equal(Integral(_on_separatrix, (psi, epsilon, pi - epsilon)), 2 * pi),
    given=(*shape, *defect),
    proof=Definition("one turn of the handle on the separatrix"),
    where=display(32),
    note=(
        "The condition for the flip defect on the separatrix; "
        "exactly one ε satisfies it (`one_flip_defect`)."
    ),
)

d35 = Claim(
    says=equal(Integral(_in_x, (x, x0, -x0)), -2 * pi * b),
    given=(*shape, *defect),
    proof=(
        step(
            Integral(-b * _on_separatrix, (psi, epsilon, pi - epsilon)),
            substituting(d34),
            changing_variable(_mu * cos(psi)),
        ),
        step(-b * Integral(_on_separatrix, (psi, epsilon, pi - epsilon)), roots),
        step(None, substituting(d32)),
    ),
    where=display(35),
)

_primitive = sqrt(b / a) * atanh(sqrt(a / b) * x / sqrt(1 - x**2)) - b * asin(x)

turn_antiderivative = Claim(
    says=equal(Derivative(_primitive, x), _in_x),
    given=(*shape, b / (a + b) - x**2 > 0),
    proof=by(differentiation, roots),
    note="The turn on the separatrix is an elementary function of x.",
)

d36 = Claim(
    says=equal(printed.arctanh_left(x0, a, b, sympy), sqrt(a * b) * pi),
    given=(*shape, *defect),
    knowing=(b / (a + b) - x0**2 > 0, Under(b / (a + b) - x**2 > 0, ((x - x0) * (-x0 - x) >= 0,))),
    proof=(
        step(
            -sqrt(a / b) / 2 * Integral(_in_x, (x, x0, -x0)),
            integrating(_primitive),
            *(inverses, roots),
        ),
        step(None, substituting(d35), roots),
    ),
    where=display(36),
)

_root = sqrt(1 + b / a * sin(epsilon) ** 2)
_ratio = printed.separatrix_left(epsilon, a, b, sympy)
_time = sqrt(a * b) * (pi + asin(_mu * cos(epsilon)))
_printed_equation = equal(_ratio, printed.separatrix_right(epsilon, a, b, sympy))
_inverse = cos(epsilon) / _root
_inverse_form = equal(atanh(_inverse), _time)
_stable_equation = equal(sqrt(a / (a + b)) / sinh(_time), tan(epsilon))

artanh_by_logarithm = Claim(
    says=equal(atanh(x), log((1 + x) / (1 - x)) / 2),
    given=(x > -1, x < 1),
    proof=by(exponentials, inverses),
    where=line(340),
)

d37 = Claim(
    says=Equivalent(
        equal(printed.arctanh_left(_mu * cos(epsilon), a, b, sympy), sqrt(a * b) * pi),
        _printed_equation,
    ),
    given=(*shape, *defect),
    proof=(
        step(_inverse_form, adding(sqrt(a * b) * asin(_mu * cos(epsilon))), roots, trigonometry),
        step(equal(-2 * atanh(cos(epsilon) / _root), -2 * _time), multiplying(Integer(-2))),
        step(
            equal((1 - _inverse) / (1 + _inverse), _printed_equation.rhs),
            applying("exp"),
            exponentials,
            inverses,
        ),
        step(_printed_equation, roots),
    ),
    where=display(37),
)

stable_equation = Claim(
    says=Equivalent(_printed_equation, _stable_equation),
    given=(*shape, *defect),
    proof=(
        step(equal(log(_ratio), -2 * _time), applying("log"), exponentials),
        step(
            equal(sqrt(a / (a + b)) * cos(epsilon) / sin(epsilon), sinh(_time)),
            *(multiplying(Rational(-1, 2)), applying("sinh")),
            *(roots, trigonometry, exponentials),
        ),
        step(
            _stable_equation, multiplying(sin(epsilon) / (cos(epsilon) * sinh(_time))), trigonometry
        ),
    ),
)

_map = k * (pi + atan(r * tanh(T)))
_tilt = atan(1 / (sqrt(1 + r**2) * sinh(T)))

auxiliary_angle = Claim(
    says=equal(asin(r / sqrt(1 + r**2) * cos(_tilt)), atan(r * tanh(T))),
    given=(*auxiliary, *later),
    proof=by(exponentials, inverses, roots),
    note="With tan ε = √(a/(a+b))/sinh T and r = √(b/a).",
)

_spread = cosh(T) ** 2 + r**2 * sinh(T) ** 2
_end = 3 * pi / 2 * k

unique_root = Claim(
    says="The equation T = √(ab)(π + arctan(√(b/a) tanh T)) has exactly one root "
    "with 0 < T < 3π√(ab)/2.",
    means=ExactlyOne(T, 0, _end, equal(T, _map)),
    given=(*auxiliary, k * r <= 1),
    knowing=(tanh(_end) > 0,),
    proof=UniqueRoot(
        derivative=(
            step(1 - k * r / _spread, differentiation, exponentials),
            step(((1 - k * r) + (1 + r**2) * sinh(T) ** 2) / _spread, exponentials),
        ),
        at_low=(step(-pi * k, exponentials, inverses),),
        at_high=(step(k * atan(1 / (r * tanh(_end))), inverses),),
    ),
    note="b = kr with k = √(ab) and r = √(b/a).",
)

no_root_beyond = Claim(
    says=_end > _map,
    given=(*auxiliary, *later),
    proof=manifest,
    note="The map stays below 3π√(ab)/2, so no root lies there or beyond.",
)

no_root_below = Claim(
    says=_map > k * pi,
    given=(*auxiliary, *later),
    proof=manifest,
    note="The phase T/√(ab) of the root is between π and 3π/2.",
)

contraction = Claim(
    says=equal(_map.diff(T, evaluate=False), k * r * sin(_tilt) ** 2),
    given=(*auxiliary, *later),
    proof=by(differentiation, exponentials),
    note="The derivative of the map is b sin²ε, between 0 and b.",
)

contraction_bound = Claim(
    says=Tuple(b * sin(epsilon) ** 2 > 0, b * sin(epsilon) ** 2 < 1),
    given=(*shape, *defect),
    proof=manifest,
)


_rate = (1 + b / a) * sinh(_time) ** 2 + (1 - b) + b / a * ((1 - b) + b * cos(epsilon) ** 2)

defect_is_one = Claim(
    says="Each shape has exactly one ε between 0 and π/2 with tanh T = cos ε/√(1 + (b/a) sin²ε), "
    "T = √(ab)(π + arcsin(√(b/(a+b)) cos ε)).",
    means=ExactlyOne(epsilon, 0, pi / 2, equal(tanh(_time), _inverse)),
    given=shape,
    proof=UniqueRoot(
        derivative=(
            step(
                sin(epsilon) * _rate / (_root**3 * cosh(_time) ** 2),
                differentiation,
                exponentials,
                roots,
                trigonometry,
            ),
        ),
        at_low=(
            step(
                -2 / (exp(2 * sqrt(a * b) * (pi + asin(_mu))) + 1),
                exponentials,
                roots,
                trigonometry,
            ),
        ),
        at_high=(step(tanh(sqrt(a * b) * pi), exponentials, roots, trigonometry, inverses),),
    ),
    note="The equation is the stable equation, solved for tanh T.",
)

tangent_form = Claim(
    says=Equivalent(_stable_equation, equal(_inverse, tanh(_time))),
    given=(*shape, *defect),
    proof=(
        step(
            equal(asinh(sqrt(a / (a + b)) * cos(epsilon) / sin(epsilon)), _time),
            multiplying(cos(epsilon) * sinh(_time) / sin(epsilon)),
            applying("asinh"),
            *(exponentials, inverses, trigonometry),
        ),
        step(
            equal(_inverse, tanh(_time)),
            applying("tanh"),
            *(exponentials, inverses, roots, trigonometry),
        ),
    ),
)

one_flip_defect = Claim(
    **jointly(defect_is_one, d37, stable_equation, tangent_form, contraction, contraction_bound),
    note="The exact equation has exactly one root, and the map of its stable form contracts.",
)

flip_defect = Claim(
    says=Root(epsilon0, defect_is_one).says,
    given=shape,
    proof=Root(epsilon0, defect_is_one),
    note="The flip defect ε₀ on the separatrix.",
)

vanishing_share = Claim(
    says=equal(
        tanh(_time) - _inverse,
        ((a + b) * sin(epsilon) ** 2 / (a + b * sin(epsilon) ** 2) - 1 / cosh(_time) ** 2)
        / (_inverse + tanh(_time)),
    ),
    given=(*shape, *defect),
    proof=by(exponentials, roots, trigonometry),
    note="The equation for the flip defect in a form without cancellation for small ε.",
)

leading_defect = Claim(
    says=equal(epsilon_printed, printed.asymptotic_defect(a, b, sympy)),
    given=shape,
    proof=Definition(),
    note="The formula of the theorem, without its remainder.",
)

defect_range = Claim(
    says=Tuple(sin(epsilon0) > 0, cos(epsilon0) > 0), given=shape, proof=by(citing(flip_defect))
)

label_claims(globals())
