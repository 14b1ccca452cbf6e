"""The rows of the elementary functions, by family.

Sources: DLMF 4 (exponential, trigonometric and hyperbolic functions and their inverses).
"""

from __future__ import annotations

import math
from typing import Any

from flint import acb, arb, fmpq

from tresym.reals.functions.row import Conditions, Function, method
from tresym.reals.numbers.exact import Interval

_ROOTS = frozenset({"roots"})
_EXPONENTIALS = frozenset({"exponentials"})
_TRIGONOMETRY = frozenset({"trigonometry"})
_INVERSES = frozenset({"inverses"})
_HALF = fmpq(1, 2)


# -- balls -------------------------------------------------------------------------------------


def _sign(x: arb) -> arb:
    if x.contains(0):
        return arb(0, 0 if x.is_zero() else 1)
    return arb(1 if x > 0 else -1)


def root_of_ball(x: arb, n: int) -> arb:
    """Return the n-th root of ``x ≥ 0``; FLINT returns NaN for a ball that contains 0."""
    if x > 0:
        return x.root(n)
    high = x.upper()
    return arb(0).union(high.root(n)) if high > 0 else arb(0)


def _cube_root(x: arb) -> arb:
    """Return the real cube root of any ball."""
    if x >= 0:
        return root_of_ball(x, 3)
    if x < 0:
        return -((-x).root(3))
    return (-root_of_ball(-x.lower(), 3)).union(root_of_ball(x.upper(), 3))


def _angle(y: arb, x: arb) -> arb:
    """Return ``atan2(y, x)``; all of [−π, π] for a ball that crosses the negative x-axis."""
    return arb.nan() if y.contains(0) and x.contains(0) else arb.atan2(y, x)


# -- power series ------------------------------------------------------------------------------


def _sinh_series(s: Any) -> Any:
    return (s.exp() - (-s).exp()) / 2


def _cosh_series(s: Any) -> Any:
    return (s.exp() + (-s).exp()) / 2


def _atanh_series(s: Any) -> Any:
    return ((1 + s) / (1 - s)).log() / 2


def _called(name: str) -> Any:
    return lambda s: getattr(s, name)()


# -- floating point ----------------------------------------------------------------------------


def _float_exp(x: float) -> float:
    return math.exp(x) if x < 700 else (math.inf if x == x else math.nan)


def _float_cosh(x: float) -> float:
    return math.cosh(x) if abs(x) < 700 else (math.inf if x == x else math.nan)


def _float_sinh(x: float) -> float:
    if abs(x) < 700:
        return math.sinh(x)
    return math.copysign(math.inf, x) if x == x else math.nan


def _float_sign(x: float) -> float:
    return x if x != x else float((x > 0) - (x < 0))


def _float_angle(y: float, x: float) -> float:
    return math.atan2(y, x) if x or y else math.nan


# -- domains -----------------------------------------------------------------------------------


def _nonzero(x: Any, m: Any) -> Conditions:
    return ((x, "!="),)


def _positive(x: Any, m: Any) -> Conditions:
    return ((x, ">"),)


def _no_zero_of_cosine(x: Any, m: Any) -> Conditions:
    return ((m.cos(x), "!="),)


def _no_zero_of_sine(x: Any, m: Any) -> Conditions:
    return ((m.sin(x), "!="),)


def _off_imaginary_axis(z: acb) -> bool:
    return not z.real.contains(0) or bool(abs(z.imag) < 1)


def _off_real_axis(z: acb) -> bool:
    return not z.imag.contains(0) or bool(abs(z.real) < 1)


def _off_ray(z: acb) -> bool:
    return not z.imag.contains(0) or bool(z.real > 1)


def _at_most_one(x: Any, m: Any) -> Conditions:
    return ((1 - x, ">="), (1 + x, ">="))


POWERS = (
    Function(
        name="abs", family="absolute value", theory=_ROOTS, singular=_nonzero, smooth=False,
        definition=r"|x| = \max(x, -x)", even=True, vanishes_with_argument=True,
        range=Interval(fmpq(0)), derivatives=(lambda x, m: x / abs(x),), ball=abs, double=abs,
        latex=r"\left|{}\right|", mathematica="Abs", maple="abs", sympy="Abs", coq="Rabs",
        aliases=("Abs",), falsehoods=("abs(x) > 0", "abs(x) <= x"),
    ),
    Function(
        name="sign", family="sign", theory=_ROOTS, singular=_nonzero, smooth=False,
        definition=r"\operatorname{sgn} x = x/|x|,\ \operatorname{sgn} 0 = 0", odd=True,
        vanishes_with_argument=True, range=Interval(fmpq(-1), fmpq(1)),
        derivatives=(lambda x, m: 0 * (1 / x),),  # constant where it is defined
        ball=_sign, double=_float_sign, latex=r"\operatorname{sgn}", mathematica="Sign",
        maple="signum", sympy="sign", coq="sign", aliases=("sgn",),
        falsehoods=("sign(x)**2 == 1", "sign(x) > 0 given x >= 0"),
    ),
    Function(
        name="cbrt", family="roots", theory=_ROOTS, singular=_nonzero, smooth=False,
        definition=r"(\sqrt[3]{x})^3 = x", odd=True, rising=True, vanishes_with_argument=True,
        derivatives=(lambda x, m: fmpq(1, 3) / m.cbrt(x) ** 2,), ball=_cube_root,
        double=lambda x: math.copysign(abs(x) ** (1 / 3), x), latex=r"\sqrt[3]{{{}}}",
        mathematica="CubeRoot", maple="surd", sympy="cbrt", coq="root 3",
        falsehoods=("cbrt(x) <= x given x > 0", "cbrt(x)**2 == x"),
    ),
)  # fmt: skip

EXPONENTIALS = (
    Function(
        name="exp", family="exponential", theory=_EXPONENTIALS, range=Interval(fmpq(0), None, True),
        definition=r"e^x = \sum_{k \ge 0} x^k/k!", source="DLMF 4.2.19", rising=True,
        derivatives=(lambda x, m: m.exp(x),), slope=lambda x, y: y, inverse="log",
        image=lambda m: (0, None, False), entire=True, power_series="y**k/factorial(k)",
        ball=method("exp"), series=_called("exp"), rational_series=_called("exp"),
        double=_float_exp, latex=r"\exp", mathematica="Exp", maple="exp", sympy="exp", coq="exp",
        falsehoods=("exp(x) >= 1 + x + x**2/2", "exp(x) > 1 + 2*x"),
    ),
    Function(
        name="log", family="exponential", theory=_EXPONENTIALS, needs=_positive, rising=True,
        definition=r"e^{\ln x} = x", source="DLMF 4.2.2", derivatives=(lambda x, m: 1 / x,),
        sign_of=lambda x, m: x - 1, slope=lambda x, y: 1 / x, inverse="exp",
        image=lambda m: (None, None, False), ball=method("log"), series=_called("log"),
        rational_series=_called("log"), double=math.log, latex=r"\ln", reads=("ln", "log"),
        mathematica="Log", maple="ln", sympy="log", coq="ln", aliases=("ln",),
        falsehoods=("log(x) <= x - 2", "log(1 + x) >= x given x > 0"),
    ),
)  # fmt: skip


def _circular(name: str, **facts: Any) -> Function:
    return Function(
        name=name, family="trigonometric", theory=_TRIGONOMETRY, ball=method(name),
        source="DLMF 4.14", latex=rf"\{name}", mathematica=name.capitalize(), maple=name,
        sympy=name, coq=name, **facts,
    )  # fmt: skip


TRIGONOMETRIC = (
    _circular(
        "sin", definition=r"\sin x = \sum_{k \ge 0} (-1)^k x^{2k+1}/(2k+1)!", odd=True,
        range=Interval(fmpq(-1), fmpq(1)), derivatives=(lambda x, m: m.cos(x),),
        slope=lambda x, y: x.cos(), entire=True, zeros_apart=fmpq(1),
        branch=("asin", (-1, fmpq(1)), (-_HALF, _HALF)), series=_called("sin"),
        power_series="(-1)**k*y**(2*k + 1)/factorial(2*k + 1)", rational_series=_called("sin"),
        double=math.sin, confused=("cos", "sinh"),
        falsehoods=("sin(x) >= x - x**3/7 given x > 0", "sin(x)**2 < 1"),
    ),
    _circular(
        "cos", definition=r"\cos x = \sum_{k \ge 0} (-1)^k x^{2k}/(2k)!", even=True,
        range=Interval(fmpq(-1), fmpq(1)), derivatives=(lambda x, m: -m.sin(x),),
        slope=lambda x, y: -x.sin(), entire=True, zeros_apart=_HALF,
        branch=("acos", (-1, fmpq(0)), (fmpq(0), fmpq(1))), series=_called("cos"),
        power_series="(-1)**k*y**(2*k)/factorial(2*k)", rational_series=_called("cos"),
        double=math.cos, confused=("sin", "cosh"),
        falsehoods=("cos(x) > -1", "cos(x) >= 1 - x**2/3"),
    ),
    _circular(
        "tan", definition=r"\tan x = \sin x/\cos x", odd=True, needs=_no_zero_of_cosine,
        derivatives=(lambda x, m: 1 + m.tan(x) ** 2,), slope=lambda x, y: 1 + y * y,
        quotient=("sin", "cos"), by_others=lambda u, m: m.sin(u) / m.cos(u), zeros_apart=fmpq(1),
        poles_apart=_HALF, branch=("atan", (1, fmpq(1)), (-_HALF, _HALF)), series=_called("tan"),
        rational_series=_called("tan"), double=math.tan, confused=("cot", "tanh"),
        falsehoods=("tan(x) > x given 0 < x < 2", "diff(tan(x), x) == 1 - tan(x)**2"),
    ),
    _circular(
        "cot", definition=r"\cot x = \cos x/\sin x", odd=True, needs=_no_zero_of_sine,
        derivatives=(lambda x, m: -1 - m.cot(x) ** 2,), quotient=("cos", "sin"), reciprocal="tan",
        by_others=lambda u, m: m.cos(u) / m.sin(u), poles_apart=fmpq(1),
        double=lambda x: math.cos(x) / math.sin(x), confused=("tan", "coth"),
        falsehoods=("cot(x) < 1/x given 0 < x < 4", "cot(x)*tan(x) == 2"),
    ),
    _circular(
        "sec", definition=r"\sec x = 1/\cos x", even=True, needs=_no_zero_of_cosine,
        derivatives=(lambda x, m: m.sec(x) * m.tan(x),), quotient=("", "cos"),
        reciprocal="cos", by_others=lambda u, m: 1 / m.cos(u), poles_apart=_HALF,
        sign_of=lambda x, m: m.cos(x), double=lambda x: 1 / math.cos(x), confused=("csc", "sech"),
        falsehoods=("sec(x) >= 1", "sec(x)**2 == tan(x)**2 - 1"),
    ),
    _circular(
        "csc", definition=r"\csc x = 1/\sin x", odd=True, needs=_no_zero_of_sine,
        derivatives=(lambda x, m: -m.csc(x) * m.cot(x),), quotient=("", "sin"), reciprocal="sin",
        by_others=lambda u, m: 1 / m.sin(u), poles_apart=fmpq(1), sign_of=lambda x, m: m.sin(x),
        double=lambda x: 1 / math.sin(x), confused=("sec", "csch"), reads=("csc", "cosec"),
        falsehoods=("csc(x) >= 1", "csc(x)**2 == cot(x)**2 - 1"),
    ),
)  # fmt: skip


def _hyperbolic(name: str, **facts: Any) -> Function:
    return Function(
        name=name, family="hyperbolic", theory=_EXPONENTIALS, ball=method(name), source="DLMF 4.28",
        mathematica=name.capitalize(), maple=name, sympy=name, coq=name, **facts,
    )  # fmt: skip


HYPERBOLIC = (
    _hyperbolic(
        "sinh", definition=r"\sinh x = (e^x - e^{-x})/2", odd=True, rising=True,
        vanishes_with_argument=True, derivatives=(lambda x, m: m.cosh(x),),
        slope=lambda x, y: x.cosh(), inverse="asinh", image=lambda m: (None, None, False),
        by_others=lambda u, m: m.exp(u) / 2 - m.exp(-u) / 2, entire=True, zeros_apart=fmpq(1),
        power_series="y**(2*k + 1)/factorial(2*k + 1)", series=_sinh_series,
        rational_series=_called("sinh"), double=_float_sinh, latex=r"\sinh",
        confused=("cosh", "sin"), falsehoods=("sinh(x) > x", "cosh(x)**2 + sinh(x)**2 == 1"),
    ),
    _hyperbolic(
        "cosh", definition=r"\cosh x = (e^x + e^{-x})/2", even=True, range=Interval(fmpq(1)),
        derivatives=(lambda x, m: m.sinh(x),), slope=lambda x, y: x.sinh(),
        by_others=lambda u, m: m.exp(u) / 2 + m.exp(-u) / 2, entire=True, zeros_apart=_HALF,
        power_series="y**(2*k)/factorial(2*k)", series=_cosh_series,
        rational_series=_called("cosh"), double=_float_cosh, latex=r"\cosh",
        confused=("sinh", "cos"), falsehoods=("cosh(x) > 1", "cosh(x) <= exp(x)"),
    ),
    _hyperbolic(
        "tanh", definition=r"\tanh x = \sinh x/\cosh x", odd=True, rising=True,
        vanishes_with_argument=True, range=Interval(fmpq(-1), fmpq(1), True, True),
        derivatives=(lambda x, m: 1 - m.tanh(x) ** 2,), slope=lambda x, y: x.sech() ** 2,
        inverse="atanh", image=lambda m: (-1, 1, False), quotient=("sinh", "cosh"),
        by_others=lambda u, m: (m.exp(2 * u) - 1) / (m.exp(2 * u) + 1), zeros_apart=fmpq(1),
        poles_apart=_HALF, rational_series=_called("tanh"), double=math.tanh, latex=r"\tanh",
        confused=("coth", "tan"), falsehoods=("tanh(x) <= 9/10", "tanh(x) >= x - x**3/4"),
    ),
    _hyperbolic(
        "coth", definition=r"\coth x = \cosh x/\sinh x", odd=True, needs=_nonzero,
        derivatives=(lambda x, m: 1 - m.coth(x) ** 2,), quotient=("cosh", "sinh"),
        reciprocal="tanh", by_others=lambda u, m: 1 / m.tanh(u), poles_apart=fmpq(1),
        sign_of=lambda x, m: x, double=lambda x: 1 / math.tanh(x), latex=r"\coth",
        confused=("tanh", "cot"), falsehoods=("coth(x) > 1", "coth(x)*tanh(x) == 2"),
    ),
    _hyperbolic(
        "sech", definition=r"\operatorname{sech} x = 1/\cosh x", even=True,
        range=Interval(fmpq(0), fmpq(1), True), derivatives=(lambda x, m: -m.sech(x) * m.tanh(x),),
        quotient=("", "cosh"), reciprocal="cosh", by_others=lambda u, m: 1 / m.cosh(u),
        poles_apart=_HALF, double=lambda x: 1 / _float_cosh(x), latex=r"\operatorname{sech}",
        confused=("csch", "sec"), falsehoods=("sech(x) < 1", "sech(x)**2 == 1 + tanh(x)**2"),
    ),
    _hyperbolic(
        "csch", definition=r"\operatorname{csch} x = 1/\sinh x", odd=True, needs=_nonzero,
        derivatives=(lambda x, m: -m.csch(x) * m.coth(x),), quotient=("", "sinh"),
        reciprocal="sinh", by_others=lambda u, m: 1 / m.sinh(u), poles_apart=fmpq(1),
        sign_of=lambda x, m: x, double=lambda x: 1 / _float_sinh(x), latex=r"\operatorname{csch}",
        confused=("sech", "csc"), falsehoods=("csch(x) > 0", "csch(x)**2 == coth(x)**2 + 1"),
    ),
)  # fmt: skip


def _inverse(name: str, reciprocal: str, **facts: Any) -> Function:
    letters = name[1:]
    other = "Arc" + letters.capitalize()
    return Function(
        name=name, family="inverse hyperbolic" if name.endswith("h") else "inverse trigonometric",
        theory=_INVERSES, ball=method(name), source="DLMF 4.23, 4.37", mathematica=other,
        maple=f"arc{letters}", sympy=name, double=getattr(math, name), aliases=(f"arc{letters}",),
        of_reciprocal=(reciprocal, f"arc{reciprocal[1:]}"), branched=True, inverse=letters, **facts,
    )  # fmt: skip


INVERSES = (
    _inverse(
        "asin", "acsc", definition=r"\sin(\arcsin x) = x,\ |\arcsin x| \le \pi/2", odd=True,
        rising=True, vanishes_with_argument=True, needs=_at_most_one, smooth=False, ends=(1, -1),
        range=Interval(fmpq(-11, 7), fmpq(11, 7), True, True),
        derivatives=(lambda x, m: 1 / m.sqrt(1 - x**2),), slope=lambda x, y: (1 - x * x).rsqrt(),
        image=lambda m: (-m.pi / 2, m.pi / 2, True),
        by_others=lambda u, m: m.atan(u / m.sqrt(1 - u**2)), series=_called("asin"),
        rational_series=_called("asin"), off_cuts=_off_real_axis,
        latex=r"\arcsin", coq="asin", confused=("acos", "asinh"),
        power_series="factorial(2*k)*y**(2*k + 1)/(4**k*factorial(k)**2*(2*k + 1))",
        falsehoods=("asin(x) <= x given x > 0", "asin(x) + acos(x) == pi"),
    ),
    _inverse(
        "acos", "asec", definition=r"\cos(\arccos x) = x,\ 0 \le \arccos x \le \pi", falling=True,
        needs=_at_most_one, smooth=False, ends=(1, -1), sign_of=lambda x, m: 1 - x,
        range=Interval(fmpq(0), fmpq(22, 7), False, True),
        derivatives=(lambda x, m: -1 / m.sqrt(1 - x**2),),
        slope=lambda x, y: -((1 - x * x).rsqrt()), image=lambda m: (0, m.pi, True),
        by_others=lambda u, m: m.pi / 2 - m.asin(u), series=lambda s: arb.pi() / 2 - s.asin(),
        off_cuts=_off_real_axis,
        latex=r"\arccos", coq="acos", confused=("asin", "acosh"),
        falsehoods=("acos(x) > 0", "acos(-x) == acos(x)"),
    ),
    _inverse(
        "atan", "acot", definition=r"\tan(\arctan x) = x,\ |\arctan x| < \pi/2", odd=True,
        rising=True, vanishes_with_argument=True,
        range=Interval(fmpq(-11, 7), fmpq(11, 7), True, True),
        derivatives=(lambda x, m: 1 / (1 + x**2),), slope=lambda x, y: 1 / (1 + x * x),
        image=lambda m: (-m.pi / 2, m.pi / 2, False), series=_called("atan"),
        rational_series=_called("atan"), power_series="(-1)**k*y**(2*k + 1)/(2*k + 1)",
        off_cuts=_off_imaginary_axis,
        latex=r"\arctan", coq="atan", confused=("atanh",),
        falsehoods=("atan(x) <= 3/2", "atan(x) + atan(1/x) == pi/2"),
    ),
    _inverse(
        "asinh", "acsch", definition=r"\sinh(\operatorname{arsinh} x) = x", odd=True, rising=True,
        vanishes_with_argument=True, derivatives=(lambda x, m: 1 / m.sqrt(x**2 + 1),),
        slope=lambda x, y: (1 + x * x).rsqrt(), image=lambda m: (None, None, False),
        by_others=lambda u, m: m.log(u + m.sqrt(u**2 + 1)),
        series=lambda s: (s + (1 + s * s).sqrt()).log(), rational_series=_called("asinh"),
        power_series="(-1)**k*factorial(2*k)*y**(2*k + 1)/(4**k*factorial(k)**2*(2*k + 1))",
        off_cuts=_off_imaginary_axis,
        latex=r"\operatorname{arsinh}", coq="arcsinh", confused=("acosh", "asin"),
        falsehoods=("asinh(x) <= x - x**3/7 given x > 0", "asinh(x) == log(x + sqrt(x**2 - 1))"),
    ),
    _inverse(
        "acosh", "asech", definition=r"\cosh(\operatorname{arcosh} x) = x \ge 1", rising=True,
        needs=lambda x, m: ((x - 1, ">="),), smooth=False, ends=(1,), range=Interval(fmpq(0)),
        sign_of=lambda x, m: x - 1, derivatives=(lambda x, m: 1 / (m.sqrt(x - 1) * m.sqrt(x + 1)),),
        slope=lambda x, y: (x * x - 1).rsqrt(), image=lambda m: (0, None, True),
        by_others=lambda u, m: m.log(u + m.sqrt(u**2 - 1)),
        series=lambda s: (s + (s * s - 1).sqrt()).log(), off_cuts=_off_ray,
        latex=r"\operatorname{arcosh}",
        coq="acosh", confused=("asinh", "acos"),
        falsehoods=("acosh(x) > 0", "acosh(x) <= log(x)"),
    ),
    _inverse(
        "atanh", "acoth", definition=r"\tanh(\operatorname{artanh} x) = x", odd=True, rising=True,
        vanishes_with_argument=True, needs=lambda x, m: ((1 - x, ">"), (1 + x, ">")),
        derivatives=(lambda x, m: 1 / (1 - x**2),), slope=lambda x, y: 1 / (1 - x * x),
        image=lambda m: (None, None, False), by_others=lambda u, m: m.log((1 + u) / (1 - u)) / 2,
        series=_atanh_series, rational_series=lambda s: ((1 + s).log() - (1 - s).log()) / 2,
        power_series="y**(2*k + 1)/(2*k + 1)", off_cuts=_off_real_axis,
        latex=r"\operatorname{artanh}", coq="atanh",
        confused=("atan",),
        falsehoods=("atanh(x) < x given x > 0", "atanh(x) == log((1 + x)/(1 - x))"),
    ),
    Function(
        name="atan2", family="inverse trigonometric", arity=2, theory=_INVERSES | _ROOTS,
        definition=r"x + iy = \sqrt{x^2 + y^2}\, e^{i \operatorname{atan2}(y, x)}",
        source="the angle of the point (x, y), in (−π, π]", smooth=False,
        needs=lambda y, x, m: ((y**2 + x**2, ">"),),
        singular=lambda y, x, m: ((m.sqrt(x**2 + y**2) + x, "!="),),  # 0 where it jumps
        range=Interval(fmpq(-22, 7), fmpq(22, 7), True, True),
        derivatives=(
            lambda y, x, m: x / (x**2 + y**2),
            lambda y, x, m: -y / (x**2 + y**2),
        ),
        ball=_angle, double=_float_angle, latex=r"\operatorname{atan2}", mathematica="ArcTan",
        maple="arctan", sympy="atan2", coq="atan2",
        falsehoods=("atan2(y, x) < pi", "atan2(y, x) == atan(y/x)"),
    ),
)  # fmt: skip

ELEMENTARY = (*POWERS, *EXPONENTIALS, *TRIGONOMETRIC, *HYPERBOLIC, *INVERSES)

ABBREVIATIONS = {
    ("gd", 1): lambda x, m: 2 * m.atan(m.tanh(x / 2)),
    ("agd", 1): lambda x, m: m.asinh(m.tan(x)),
}
"""The Gudermannian function and its inverse (DLMF 4.23.39 and 4.23.41)."""
