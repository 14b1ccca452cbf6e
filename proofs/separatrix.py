"""Appendix, first part: the exact equation for the flip defect on the separatrix.

- `separatrix_condition`: the integral of f from ε₀ to π − ε₀ is 2π, which defines ε₀ (here ε);
- `substitution`: with x = √(b/(a+b)) cos ψ it becomes an integral in x;
- `integrated`: that integral by inverse functions;
- `exact_equation`: the exponential equation, as printed, equivalent to it;
- `stable_equation`: the exponential equation is equivalent to
  tan ε₀ = √(a/(a+b)) / sinh T, T = √(ab)(π + arcsin(√(b/(a+b)) cos ε₀)), where nothing cancels;
- `auxiliary_angle`: the arcsine is arctan(√(b/a) tanh T), which makes it an equation for T alone;
- `unique_root`, `contraction`: that equation has exactly one root, and its map contracts.
"""

import sympy
from sympy import (
    Equivalent,
    Integral,
    Rational,
    Tuple,
    asin,
    atan,
    atanh,
    cos,
    cosh,
    log,
    pi,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)
from tresym.proofs.conditions import auxiliary, defect, shape

from tresym.claims.claim import (
    Claim,
    Definition,
    Place,
    UniqueRoot,
    adding,
    algebra,
    all_of,
    applying,
    by,
    changing_variable,
    citing,
    differentiation,
    equal,
    exponentials,
    integrating,
    inverses,
    multiplying,
    roots,
    step,
    substituting,
    together,
    trigonometry,
)
from tresym.formulas import printed
from tresym.notation import T, a, b, epsilon, k, psi, r, x, x0

between = (psi > 0, psi < pi, sin(psi) > 0)
"""On the separatrix the flip angle stays between the unstable points."""

_f = printed.integrand(psi, a, b, 0, 1, sympy)
_on_separatrix = _f.subs(sqrt(b * sin(psi) ** 2), sqrt(b) * sin(psi))
_mu = sqrt(b / (a + b))

separatrix_integrand = Claim(
    label="separatrix_integrand",
    says=equal(_f, _on_separatrix),
    given=(*shape, *between),
    proof=by(roots),
)

separatrix_condition = Claim(
    label="d32",
    says=equal(Integral(_on_separatrix, (psi, epsilon, pi - epsilon)), 2 * pi),
    given=(*shape, *defect),
    proof=Definition(),
    where=Place(display=32),
    note="The condition that defines the flip defect on the separatrix.",
)

start_in_x = Claim(
    label="d34",
    says=equal(x0, printed.auxiliary_variable(epsilon, a, b, sympy)),
    given=(*shape, *defect),
    proof=Definition(),
    where=Place(display=34),
)

_in_x = printed.auxiliary_integrand(x, a, b, sympy)

substitution = Claim(
    label="d35",
    says=equal(Integral(_in_x, (x, x0, -x0)), -2 * pi * b),
    given=(*shape, *defect, *between),
    proof=(
        step(
            Integral(-b * _on_separatrix, (psi, epsilon, pi - epsilon)),
            substituting(start_in_x),
            changing_variable(_mu * cos(psi)),
        ),
        step(-b * Integral(_on_separatrix, (psi, epsilon, pi - epsilon)), algebra),
        step(None, substituting(separatrix_condition)),
    ),
    where=Place(display=35),
)


_primitive = sqrt(b / a) * atanh(sqrt(a / b) * x / sqrt(1 - x**2)) - b * asin(x)

root_at_start = Claim(
    label="root_at_start",
    says=1 - x0**2 > 0,
    kind="bound",
    given=(*shape, *defect),
    proof=(
        step(1 - b / (a + b) * cos(epsilon) ** 2, substituting(start_in_x), roots),
        step((a + b * sin(epsilon) ** 2) / (a + b), trigonometry),
    ),
)

artanh_at_start = Claim(
    label="artanh_at_start",
    says=b - (a + b) * x0**2 > 0,
    kind="bound",
    given=(*shape, *defect),
    proof=(
        step(b - b * cos(epsilon) ** 2, substituting(start_in_x), roots),
        step(b * sin(epsilon) ** 2, trigonometry),
    ),
)

_inside = ((x - x0) * (-x0 - x) >= 0,)

root_in_interval = Claim(
    label="root_in_interval",
    says=1 - x**2 > 0,
    kind="bound",
    given=(*shape, *defect, *_inside),
    proof=(step((1 - x0**2) + (x - x0) * (-x0 - x), citing(root_at_start)),),
)

artanh_in_interval = Claim(
    label="artanh_in_interval",
    says=b - (a + b) * x**2 > 0,
    kind="bound",
    given=(*shape, *defect, *_inside),
    proof=(
        step(
            (b - (a + b) * x0**2) + (a + b) * ((x - x0) * (-x0 - x)),
            citing(artanh_at_start),
        ),
    ),
)

integrated = Claim(
    label="d36",
    says=equal(printed.arctanh_left(x0, a, b, sympy), sqrt(a * b) * pi),
    given=(*shape, *defect),
    proof=(
        step(
            -sqrt(a / b) / 2 * Integral(_in_x, (x, x0, -x0)),
            integrating(_primitive, root_in_interval, artanh_in_interval),
            citing(root_at_start, artanh_at_start),
            roots,
        ),
        step(-sqrt(a / b) / 2 * (-2 * pi * b), substituting(substitution)),
        step(None, roots),
    ),
    where=Place(display=36),
)

_root = sqrt(1 + b / a * sin(epsilon) ** 2)
_ratio = printed.separatrix_left(epsilon, a, b, sympy)
_time = sqrt(a * b) * (pi + asin(_mu * cos(epsilon)))
_printed_equation = equal(_ratio, printed.separatrix_right(epsilon, a, b, sympy))
_inverse_form = equal(atanh(cos(epsilon) / _root), _time)
_stable_equation = equal(sqrt(a / (a + b)) / sinh(_time), tan(epsilon))

logarithm_of_artanh = Claim(
    label="artanh_by_logarithm",
    says=equal(atanh(x), log((1 + x) / (1 - x)) / 2),
    given=(x > -1, x < 1),
    proof=by(exponentials, inverses),
    where=Place(line=412),
)

exact_equation = Claim(
    label="d37",
    says=Equivalent(
        equal(
            printed.arctanh_left(_mu * cos(epsilon), a, b, sympy),
            sqrt(a * b) * pi,
        ),
        _printed_equation,
    ),
    given=(*shape, *defect),
    proof=(
        step(_inverse_form, adding(sqrt(a * b) * asin(_mu * cos(epsilon))), roots, trigonometry),
        step(equal(-2 * atanh(cos(epsilon) / _root), -2 * _time), multiplying(-2)),
        step(_printed_equation, applying("exp"), exponentials, inverses, roots),
    ),
    where=Place(display=37),
)

stable_equation = Claim(
    label="stable_equation",
    says=Equivalent(_printed_equation, _stable_equation),
    given=(*shape, *defect),
    proof=(
        step(
            equal(log(_ratio), -2 * _time),
            applying("log"),
            exponentials,
        ),
        step(_inverse_form, multiplying(Rational(-1, 2)), exponentials, inverses, roots),
        step(
            equal(sqrt(a / (a + b)) * cos(epsilon) / sin(epsilon), sinh(_time)),
            applying("sinh"),
            exponentials,
            inverses,
            roots,
            trigonometry,
        ),
        step(
            _stable_equation,
            multiplying(sin(epsilon) / (cos(epsilon) * sinh(_time))),
            trigonometry,
        ),
    ),
)

_map = k * (pi + atan(r * tanh(T)))
_tilt = atan(1 / (sqrt(1 + r**2) * sinh(T)))

auxiliary_angle = Claim(
    label="auxiliary_angle",
    says=equal(asin(r / sqrt(1 + r**2) * cos(_tilt)), atan(r * tanh(T))),
    given=(*auxiliary, T > 0),
    proof=by(exponentials, inverses, roots, trigonometry),
    note="With tan ε = √(a/(a+b))/sinh T and r = √(b/a).",
)

_slope = 1 - k * r / (cosh(T) ** 2 + r**2 * sinh(T) ** 2)

unique_root = Claim(
    label="unique_root",
    says="The equation T = √(ab)(π + arctan(√(b/a) tanh T)) has exactly one root "
    "with 0 < T < 3π√(ab)/2, and none beyond.",
    kind="statement",
    given=(*auxiliary, k * r <= 1),
    proof=UniqueRoot(
        variable=T,
        function=T - _map,
        low=0,
        high=3 * pi / 2 * k,
        derivative=(step(_slope, differentiation, exponentials),),
    ),
    note="b = k r with k = √(ab) and r = √(b/a); the map stays below 3π√(ab)/2.",
)

contraction = Claim(
    label="contraction",
    says=equal(_map.diff(T, evaluate=False), k * r * sin(_tilt) ** 2),
    given=(*auxiliary, T > 0),
    proof=(
        step(
            k * r / (cosh(T) ** 2 + r**2 * sinh(T) ** 2),
            differentiation,
            exponentials,
        ),
        step(None, exponentials, inverses, roots, trigonometry),
    ),
    note="The derivative of the map is b sin²ε, between 0 and b.",
)

contraction_bound = Claim(
    label="contraction_bound",
    says=Tuple(b * sin(epsilon) ** 2 > 0, b * sin(epsilon) ** 2 < 1),
    kind="bound",
    given=(*shape, *defect),
    proof=together(
        (step(b * sin(epsilon) ** 2, algebra),),
        (step((1 - b) + b * cos(epsilon) ** 2, trigonometry),),
    ),
)

one_flip_defect = Claim(
    label="one_flip_defect",
    says="The exact equation has exactly one root ε₀ in (0, π/2), and fixed-point iteration "
    "from any start converges to it.",
    kind="statement",
    proof=all_of(
        exact_equation,
        stable_equation,
        auxiliary_angle,
        unique_root,
        contraction,
        contraction_bound,
    ),
)
