"""Differentiate by forward automatic differentiation in ball arithmetic.

A formula that accepts balls is called here unchanged, with ``gradients`` as its last argument. It
returns its value together with enclosures of all partial derivatives on the box. The mean-value
form and the monotonicity test of :mod:`tresym.reals.balls.branch_and_bound` use them. Where a
derivative does not exist on the box, such as that of a square root at 0, its enclosure is not
finite, and nothing is concluded.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from flint import arb, arb_series, ctx, fmpq_series

from tresym.reals.balls.tracing import Traced, program
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import ZERO, Expr, number, trees
from tresym.reals.numbers.arithmetic import balls


class Gradient:
    """A ball together with the balls of its partial derivatives."""

    __slots__ = ("slopes", "value")

    def __init__(self, value: arb, slopes: tuple[arb, ...]) -> None:
        self.value = value
        self.slopes = slopes

    def chain(self, value: arb, slope: arb) -> Gradient:
        """Return the composition with a function that has this ``value`` and derivative ``slope``
        here.
        """
        return Gradient(value, tuple(slope * s for s in self.slopes))

    def __neg__(self) -> Gradient:
        return Gradient(-self.value, tuple(-s for s in self.slopes))

    def __add__(self, other: Any) -> Gradient:
        if not isinstance(other, Gradient):
            return Gradient(self.value + other, self.slopes)
        pairs = zip(self.slopes, other.slopes, strict=True)
        return Gradient(self.value + other.value, tuple(s + t for s, t in pairs))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Gradient:
        return self + -other

    def __rsub__(self, other: Any) -> Gradient:
        return (-self) + other

    def __mul__(self, other: Any) -> Gradient:
        if not isinstance(other, Gradient):
            return Gradient(self.value * other, tuple(s * other for s in self.slopes))
        x, y = self.value, other.value
        pairs = zip(self.slopes, other.slopes, strict=True)
        return Gradient(x * y, tuple(s * y + x * t for s, t in pairs))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Gradient:
        if not isinstance(other, Gradient):
            return Gradient(self.value / other, tuple(s / other for s in self.slopes))
        y = other.value
        quotient = self.value / y
        pairs = zip(self.slopes, other.slopes, strict=True)
        return Gradient(quotient, tuple((s - quotient * t) / y for s, t in pairs))

    def __rtruediv__(self, other: Any) -> Gradient:
        quotient = other / self.value
        return self.chain(quotient, -quotient / self.value)

    def __pow__(self, power: int) -> Gradient:
        if power == 0:
            return Gradient(self.value**0, tuple(s * 0 for s in self.slopes))
        return self.chain(self.value**power, power * self.value ** (power - 1))

    def __abs__(self) -> Gradient:
        x = self.value
        sign = arb(1) if x >= 0 else arb(-1) if x <= 0 else arb(0, 1)
        return self.chain(abs(x), sign)


def _lifted(
    value: Callable[[arb], arb], slope: Callable[[arb, arb], arb]
) -> Callable[[Any, Any], Any]:
    """Return a method that applies a function to a ball, or to a gradient by the chain rule."""

    def method(_: Any, x: Any) -> Any:
        if isinstance(x, Gradient):
            y = value(x.value)
            return x.chain(y, slope(x.value, y))
        return value(x)

    return method


class Gradients:
    """The arithmetic of :class:`Gradient`, with the function names of the array API standard."""

    @property
    def pi(self) -> arb:
        """π at the working precision."""
        return arb.pi()

    sqrt = _lifted(balls.sqrt, lambda x, y: 1 / (2 * y))
    expm1 = _lifted(balls.expm1, lambda x, y: x.exp())
    log1p = _lifted(balls.log1p, lambda x, y: 1 / (1 + x))

    if TYPE_CHECKING:  # the other functions come from their rows

        def __getattr__(self, name: str) -> Callable[[Any], Any]: ...


for _row in TABLE.values():
    if _row.slope is not None:
        setattr(Gradients, _row.name, _lifted(_row.ball, _row.slope))

gradients = Gradients()


def coordinates(point: tuple[arb, ...]) -> tuple[Gradient, ...]:
    """Return the coordinates of a box as gradients; the i-th has derivative 1 in direction i.

    Example:
        >>> from flint import arb
        >>> x, y = coordinates((arb(2), arb(3)))
        >>> (x * y).slopes[0] == 3
        True
    """
    n = len(point)
    return tuple(
        Gradient(x, tuple(arb(int(i == j)) for j in range(n))) for i, x in enumerate(point)
    )


CANCELLED = 6
"""For |x| > 2^−CANCELLED the quotient may be used instead of the Taylor form."""


@dataclass(frozen=True)
class Divided:
    """The function (h(x) − T(x))/xᵖ, with T the Taylor polynomial of h at 0 of degree < p.

    The function is regular at 0. Near 0 the quotient would lose all digits, so the Taylor
    polynomial of degree < n of the quotient is used there. Its remainder is xⁿ·h_{n+p}, where h_j
    is the j-th Taylor coefficient of h enclosed on the hull of 0 and x. This follows from the
    integral form of the remainder, (1/(p−1)!) ∫₀¹ (1−t)^{p−1} h^{(p)}(tx) dt, by differentiation.

    Args:
        series: h as a function of an ``arb_series``.
        power: p ≥ 1.
        near: the Taylor form is used for |x| up to this value, and the quotient elsewhere.
        terms: n, the number of terms.
    """

    series: Callable[[Any], Any]
    power: int = 1
    near: float = 0.25
    terms: int = 12

    def __call__(self, x: Any) -> Any:
        """Return the value at a ball, the value and slopes at a gradient, or a step if traced."""
        if isinstance(x, Traced):
            return Traced(self, (x,))
        if isinstance(x, Gradient):
            value, slope = self._jet(x.value)
            return x.chain(value, slope)
        middle = x.mid()
        value = self._point(middle)
        return value if x.is_exact() else value + self._rough(x) * (x - middle)

    def meaning(self, x: Expr) -> Expr:
        """Return the quotient as a tree, which has a value where x is not 0."""
        h = program(self.series(Traced(None, (0,))), 1).run((x,), trees, lambda *_: None)
        start = self.series(fmpq_series([0, 1], 1, self.power + 1)).coeffs()[: self.power]
        terms = (number(c) * (x**j if j else 1) for j, c in enumerate(start) if c)
        return (h - sum(terms, ZERO)) / x**self.power

    def _point(self, x: arb) -> arb:
        """Return the value at an exact point; the quotient loses at most p times ``CANCELLED``
        bits.
        """
        if not abs(x) > arb(2) ** -CANCELLED:
            return self._direct(x)[0]
        start = _expansion(self, ctx.prec)[: self.power]
        return (taylor_coefficients(self.series, x, 1)[0] - horner(start, x)) / x**self.power

    def _rough(self, x: arb) -> arb:
        """Return the slope over a ball from few coefficients: h_{p+1} on the hull of 0 and x."""
        rough = taylor_coefficients(self.series, x.union(arb(0)), self.power + 2)[self.power + 1]
        if not abs(x) > self.near / 4:
            return rough
        slope = self._direct(x)[1]
        if not rough.is_finite():
            return slope
        return slope.intersection(rough) if slope.is_finite() else rough

    def _jet(self, x: arb) -> tuple[arb, arb]:
        """Return value and slope over the ball, the value by the mean value theorem from its
        middle.
        """
        middle = x.mid()
        value, slope = self._direct(middle)
        if x.is_exact():
            return value, slope
        slope, rough = self._direct(x)[1], self._rough(x)
        if rough.is_finite():
            slope = slope.intersection(rough) if slope.is_finite() else rough
        return value + slope * (x - middle), slope

    def _direct(self, x: arb) -> tuple[arb, arb]:
        """Return value and slope, by the Taylor form near 0 and by the quotient elsewhere."""
        p, n = self.power, self.terms
        start = _expansion(self, ctx.prec)
        if abs(x) > self.near:
            h = taylor_coefficients(self.series, x, 2)
            value = h[0] - horner(start[:p], x)
            slope = h[1] - horner([j * c for j, c in enumerate(start[:p])][1:], x)
            return value / x**p, (slope - p * value / x) / x**p
        rest = taylor_coefficients(self.series, x.union(arb(0)), p + n + 1)[p + n]
        terms = [*start[p:], rest]
        return horner(terms, x), horner([j * c for j, c in enumerate(terms)][1:], x)


@lru_cache(maxsize=256)
def _expansion(function: Divided, precision: int) -> list[arb]:
    """Return the Taylor coefficients at 0 that ``function`` needs, at this ``precision``."""
    return taylor_coefficients(function.series, arb(0), function.power + function.terms)


def taylor_coefficients(
    function: Callable[[arb_series], arb_series], x: arb, length: int
) -> list[arb]:
    """Return the Taylor coefficients h⁽ʲ⁾(ξ)/j!, enclosed for all ξ in the ball ``x``.

    FLINT truncates every series at a global length, which is raised here and restored.

    Args:
        function: h as a function of an ``arb_series``.
        x: a ball.
        length: the number of coefficients.

    Returns:
        The coefficients for j < ``length``; all NaN if h is not defined on all of ``x``.

    Raises:
        RuntimeError: ``function`` returned a shorter series than requested.
    """
    before = ctx.cap
    ctx.cap = length
    try:
        series = function(arb_series([x, 1], length))
    except (ValueError, ZeroDivisionError):  # a divisor that may vanish
        return [arb.nan()] * length
    finally:
        ctx.cap = before
    if series.prec < length:
        raise RuntimeError(f"a series of length {series.prec} where {length} terms are needed")
    return [series[j] for j in range(length)]


def horner(coefficients: Sequence[arb], x: arb, total: arb = arb(0)) -> arb:  # noqa: B008
    """Return Σ cⱼ xʲ + ``total``·xⁿ for n coefficients, by Horner's rule."""
    for c in reversed(coefficients):
        total = total * x + c
    return total
