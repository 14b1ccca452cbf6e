"""Test your own numerical functions against certified values.

:func:`points` is a Hypothesis strategy for exact points of a region, simple ones, ones near every
edge and near singular sets. :func:`assert_close` fails with the simplest point at which a function
is wrong. :func:`accuracy` reports where it loses digits. The true value is a ball at exactly the
numbers that the function received, so that only its own error counts. These functions sample: they
find errors, and what they do not find may still be there. :func:`assert_claim` decides a claim, and
fails unless it is proved.

Example::

    from tresym.testing import assert_close

    def test_sinc():
        assert_close(sinc, "sin(x)/x", given="0 < x <= 3", rtol=1e-14)

Needs hypothesis: ``pip install 'tresym[testing]'``.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq

from tresym.accuracy.other_libraries import InDoubles
from tresym.accuracy.values import read
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.domain.operation_domains import singularities
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.parsing import condition, parse_given
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, Interval

if TYPE_CHECKING:
    from hypothesis.strategies import DrawFn, SearchStrategy

Point = dict[str, Fraction]
Function = Callable[..., Any]

EXAMPLES = 200
PRECISIONS = (160, 640, 2560)
NEAREST = 50
"""Points lie as near to an edge or a singular set as 2 to the power of minus this."""
FARTHEST = 30
"""Points of an unbounded range lie as far out as 2 to this power."""
MOST_INTEGER = 1000
"""Integer variables are drawn up to this distance from an end of their range, or from 0."""
STEPS = 200
WORST = 5
"""The number of worst points that a report shows."""
_SIMPLE = tuple(
    Fraction(p, q) for p, q in ((1, 1), (1, 2), (2, 1), (3, 1), (1, 3), (3, 2), (1, 10), (10, 1))
)


def points(
    given: str | Given = "", names: Iterable[str] = (), near: str | Expr | None = None
) -> SearchStrategy[Point]:
    """Return a Hypothesis strategy for exact points that satisfy conditions.

    Args:
        given: the conditions, such as ``"a > 0, 0 < b <= 1, a + b < 3"`` or ``"n integer, n > 2"``.
        names: further variables, which are unbounded.
        near: an expression; points near the sets where it is singular are drawn as well.

    Returns:
        A strategy for dictionaries from names to fractions. Simple points come first, to which
        Hypothesis shrinks. Others lie near an edge, far out, or near a singular set.

    Raises:
        InputError: the conditions cannot be read, or no point satisfies them.

    Example:
        >>> from tresym.testing import points
        >>> sorted(points("0 < b <= 1, a > 2").example())  # doctest: +SKIP
        ['a', 'b']
    """
    st = _hypothesis().strategies

    region, integers = _region(given)
    e = None if near is None else read(near)
    free = symbols(e) if e is not None else frozenset()
    wanted = sorted(region.names | integers | set(names) | free)
    if region.satisfying_point(wanted) is None:
        raise InputError(f"no point satisfies {region}")
    ranges = {name: region.box.get(name, Interval()) for name in wanted}
    within = {name: _whole(ranges[name], name) for name in integers}
    singular = [] if e is None or not elementary(e) else [part for part, _ in singularities(e)]
    singular = [part for part in singular if symbols(part) - integers]

    @st.composite
    def drawn(draw: DrawFn) -> Point:
        point = {
            name: Fraction(draw(st.integers(*within[name])))
            if name in integers
            else draw(_coordinate(ranges[name]))
            for name in wanted
        }
        if singular and draw(st.integers(0, 3)) == 3:
            part = draw(st.sampled_from(singular))
            name = draw(st.sampled_from(sorted(symbols(part) - integers)))
            zero = _zero(part, name, point, region.box.get(name, Interval()))
            if zero is not None:
                side = draw(st.sampled_from((1, -1)))
                step = Fraction(1, 2 ** draw(st.integers(1, NEAREST)))
                point[name] = zero + side * step * max(abs(zero), Fraction(1, 2**20))
        return point

    return drawn().filter(lambda point: _holds(region, point))


def _region(given: str | Given) -> tuple[Given, frozenset[str]]:
    """Return the conditions without those of the form ``n integer``, and the integer variables."""
    if isinstance(given, Given):
        return given, frozenset()
    parts = parse_given(given)
    integers = frozenset(left.args[0] for left, relation, _ in parts if relation == "in")
    return Given(tuple(condition(*part) for part in parts if part[1] != "in")), integers


def _whole(where: Interval, name: str) -> tuple[int, int]:
    """Return the least and the greatest integer that are drawn from a range.

    Raises:
        InputError: the range contains no integer.
    """
    low = None if where.low is None else int(where.low.ceil())
    high = None if where.high is None else int(where.high.floor())
    if low is None:
        low = -MOST_INTEGER if high is None else min(-MOST_INTEGER, high - MOST_INTEGER)
    if high is None:
        high = max(MOST_INTEGER, low + MOST_INTEGER)
    if low > high:
        raise InputError(f"no integer {name} lies in the range that the conditions leave")
    return low, high


def _coordinate(where: Interval) -> SearchStrategy[Fraction]:
    """Return a strategy for one coordinate: simple values, values near the ends, and far ones."""
    st = _hypothesis().strategies

    low, high = (None if end is None else Fraction(int(end.p), int(end.q)) for end in where[:2])
    small = st.integers(1, NEAREST).map(lambda k: Fraction(1, 2**k))
    if low is not None and high is not None:
        width = high - low
        inside = st.fractions(0, 1, max_denominator=64).map(lambda r: low + width * r)
        ends = small.flatmap(lambda s: st.sampled_from((low + width * s, high - width * s)))
        return st.one_of(inside, ends, st.sampled_from((low, high)))
    scale = st.integers(-NEAREST, FARTHEST).map(lambda k: Fraction(2) ** k)
    steps = st.one_of(st.sampled_from(_SIMPLE), st.fractions(0, 10, max_denominator=64), scale)
    if low is not None:
        return steps.map(lambda s: low + s)
    if high is not None:
        return steps.map(lambda s: high - s)
    return st.builds(lambda s, sign: s * sign, steps, st.sampled_from((1, -1)))


def _holds(region: Given, point: Mapping[str, Fraction]) -> bool:
    exact = {name: fmpq(x.numerator, x.denominator) for name, x in point.items()}
    with ball_precision():
        return all(c.holds_exactly(exact) for c in region.conditions)


def _zero(part: Expr, name: str, point: Point, where: Interval) -> Fraction | None:
    """Return a number near which a part vanishes along one coordinate, in double precision."""
    low = -10.0 if where.low is None else float(Fraction(int(where.low.p), int(where.low.q)))
    high = 10.0 if where.high is None else float(Fraction(int(where.high.p), int(where.high.q)))
    at = {n: float(x) for n, x in point.items()}

    def value(x: float) -> float:
        try:
            import numpy as np

            with np.errstate(all="ignore"):
                return float(InDoubles(np, at | {name: x}).value(part))
        except (ArithmeticError, ValueError):
            return math.nan

    a, b = low, high
    for end in (a, b):
        if value(end) == 0:
            return Fraction(end)
    x, y = value(a), value(b)
    if not x * y < 0:
        return None
    for _ in range(STEPS):
        middle = (a + b) / 2
        z = value(middle)
        if z == 0 or not a < middle < b:
            return Fraction(middle)
        if x * z < 0:
            b = middle
        else:
            a, x = middle, z
    return Fraction((a + b) / 2)


def _hypothesis() -> Any:
    """Return the package that chooses the points.

    Raises:
        InputError: it is not installed.
    """
    try:
        import hypothesis
    except ImportError:
        what = "tresym.testing chooses points with Hypothesis: pip install 'tresym[testing]'"
        raise InputError(what) from None
    return hypothesis


class _Raised(float):
    """No number, with the error that a function raised instead of returning one."""

    def __new__(cls, error: ArithmeticError) -> _Raised:
        found = super().__new__(cls, "nan")
        found.error = error
        return found

    error: ArithmeticError

    def __repr__(self) -> str:
        return f"{type(self.error).__name__} ({self.error})"


class _MissError(AssertionError):
    """A function differs from the certified value."""


def assert_close(
    function: Function,
    expression: str | Expr,
    given: str = "",
    rtol: float = 1e-12,
    atol: float = 0.0,
    examples: int = EXAMPLES,
) -> None:
    """Fail if a function differs from an expression somewhere on a region.

    Args:
        function: called with the variables of the expression as keywords, in double precision;
            integer variables are passed as integers. A function without keywords, such as
            ``math.sin``, is called by position if it has one variable or names its parameters.
        expression: the exact expression; it may contain integrals, roots and series.
        given: the region; ``n integer`` may be a condition.
        rtol: the largest relative error allowed.
        atol: the largest absolute error allowed besides.
        examples: the number of points.

    Raises:
        AssertionError: it differs; the message names the simplest point that Hypothesis found, the
            value there, the true value and the error.
        InputError: something cannot be read, or the expression has a proved value at no point, so
            that nothing was compared.

    Example:
        >>> import math
        >>> from tresym.testing import assert_close
        >>> assert_close(lambda x: math.exp(x), "exp(x)", "0 <= x <= 1", rtol=1e-15)
        >>> assert_close(lambda x: (1 - math.cos(x))/x**2, "(1 - cos(x))/x**2", "0 < x <= 1")
        Traceback (most recent call last):
        AssertionError
    """
    hypothesis = _hypothesis()

    e = read(expression)
    compared = 0

    def checked(point: Point) -> None:
        nonlocal compared
        found = _compared(function, e, given, point)
        if found is None:
            return
        compared += 1
        x, true, at = found
        with ball_precision(PRECISIONS[-1]):
            error = abs(_exact(x) - true) if math.isfinite(x) else arb("inf")
            allowed = rtol * abs(true) + atol
            if error > allowed:
                relative = (error / abs(true)).str(3, radius=False)
                where = ", ".join(f"{name}={value!r}" for name, value in at.items())
                raise _MissError(
                    f"f({where}) = {x!r}, but {e} is {true.str(20, radius=False)} there: "
                    f"relative error {relative}, allowed {rtol:g}"
                )

    settings = hypothesis.settings(
        max_examples=examples,
        derandomize=True,
        deadline=None,
        database=None,
        report_multiple_bugs=False,
        suppress_health_check=list(hypothesis.HealthCheck),
        verbosity=hypothesis.Verbosity.quiet,
    )
    test = settings(hypothesis.given(points(given, symbols(e), e))(checked))
    __tracebackhide__ = True  # the report of pytest shows the test, and no line of ours
    try:
        test()
    except _MissError as miss:
        raise AssertionError(str(miss)) from None
    except hypothesis.errors.Unsatisfiable:
        raise InputError(f"no point was found that satisfies {given}") from None
    if not compared:
        raise InputError(f"{e} has no proved value at any point of {given or 'its domain'}")


def assert_claim(claim: str, given: str = "", path: str | None = None, limit: float = 20.0) -> None:
    """Fail unless a claim holds: PROVED or ENCLOSED, which is more than agreement at points.

    Args:
        claim: the claim, as for :func:`tresym.check`.
        given: its conditions.
        path: the limit process of an order or a limit, unless the claim says it.
        limit: seconds of processor time.

    Raises:
        AssertionError: the claim is REFUTED, with the counterexample, or UNDECIDED.
        InputError: it cannot be read.

    Example:
        >>> assert_claim("exp(x) >= 1 + x")
        >>> assert_claim("sqrt(x**2) == x")
        Traceback (most recent call last):
        ...
        AssertionError: sqrt(x**2) == x is REFUTED: the two sides differ at x = -83/220
    """
    __tracebackhide__ = True
    from tresym.repair import check

    answer = check(claim, given, path, limit=limit, suggest=False)
    if not answer:
        raise AssertionError(f"{claim} is {answer.verdict.value}: {answer.in_text()[0]}")


def _compared(
    function: Function, e: Expr, given: str, point: Point
) -> tuple[float, arb, dict[str, float]] | None:
    """Return the value of a function, the true one and the numbers it received."""
    region, integers = _region(given)
    at: dict[str, float] = {
        name: int(x) if name in integers else float(x)
        for name, x in point.items()
        if name in symbols(e)
    }
    received = {name: Fraction(x) for name, x in at.items()}
    if not _holds(region, {**point, **received}):
        return None  # rounding has left the region
    true = true_value(e, received)
    if true is None:
        return None
    try:
        return float(_called(function, at)), true, at
    except ArithmeticError as error:
        return _Raised(error), true, at


def _called(function: Function, at: dict[str, float]) -> Any:
    """Return the value of a function, called with keywords or, where it takes none, by position.

    Raises:
        InputError: it takes no keywords, and the order of its parameters cannot be known.
    """
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):  # written in C, without a description of its parameters
        parameters = []
    named = {p.name for p in parameters if p.kind in (p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY)}
    fixed = [p.name for p in parameters if p.kind is p.POSITIONAL_ONLY]
    if len(at) == 1 and not at.keys() <= named and (named or fixed or not parameters):
        return function(*at.values())
    if set(fixed) & at.keys():
        first = [at[name] for name in fixed if name in at]
        return function(*first, **{name: x for name, x in at.items() if name not in fixed})
    if not parameters:
        raise InputError("the order of the function's parameters is unknown; wrap it in a lambda")
    return function(**at)


def true_value(e: Expr, at: Mapping[str, Fraction]) -> arb | None:
    """Return a ball around an expression at exact numbers; None if it has no proved value."""
    exact = {name: fmpq(x.numerator, x.denominator) for name, x in at.items()}
    for precision in PRECISIONS:
        with ball_precision(precision):
            try:
                found = certified_evaluation(exact).value(e)
            except UndefinedError:
                return None
            if found.rel_accuracy_bits() > 80 or found.is_zero():
                return found
    return None


def _exact(x: float) -> arb:
    numerator, denominator = x.as_integer_ratio()
    return arb(fmpq(numerator, denominator))


@dataclass(frozen=True)
class AccuracyReport:
    """Where a function is accurate and where it loses digits.

    Attributes:
        expression, given: what the function was compared with, and on which region.
        points: the number of points.
        digits: true digits at each point, sorted.
        worst: the points with the fewest true digits, with the value and the true one.
    """

    expression: str
    given: str
    points: int
    digits: tuple[float, ...]
    worst: tuple[tuple[dict[str, float], float, str, float], ...]

    def quantile(self, share: float) -> float:
        """Return the number of true digits that this share of the points does not reach."""
        return self.digits[min(int(share * len(self.digits)), len(self.digits) - 1)]

    def rows(self) -> list[tuple[str, str]]:
        """Return the report as names and text."""
        shares = ", ".join(f"{self.quantile(s):.1f} ({s:.0%})" for s in (0, 0.1, 0.5, 1))
        rows = [("points", str(self.points)), ("true digits", shares)]
        for at, x, true, digits in self.worst:
            where = ", ".join(f"{name} = {value!r}" for name, value in at.items())
            rows.append((f"{digits:.1f} digits", f"at {where}: {x!r}, true {true}"))
        return rows

    def __str__(self) -> str:
        head = f"{self.expression}{f' on {self.given}' if self.given else ''}"
        return "\n".join([head, *(f"  {name:<12}{text}" for name, text in self.rows())])

    def __repr__(self) -> str:
        return in_one_line(
            f"AccuracyReport({self.expression}: {self.quantile(0):.1f} to "
            f"{self.quantile(1):.1f} true digits at {self.points} points)"
        )

    def _repr_html_(self) -> str:
        return html_table(f"{self.expression} on {self.given}", self.rows())


def accuracy(
    function: Function, expression: str | Expr, given: str = "", examples: int = EXAMPLES
) -> AccuracyReport:
    """Report the true digits of a function over a region, with the points where it is worst.

    Args:
        function, expression, given: as for :func:`assert_close`.
        examples: the number of points.

    Raises:
        InputError: something cannot be read, or no point has a true value.

    Example:
        >>> import math
        >>> from tresym.testing import accuracy
        >>> accuracy(lambda x: math.cosh(x) - 1, "cosh(x) - 1", "0 < x <= 1").quantile(0) < 3
        True
    """
    hypothesis = _hypothesis()

    e = read(expression)
    found: dict[tuple[float, ...], tuple[dict[str, float], float, arb]] = {}

    def note(point: Point) -> None:
        one = _compared(function, e, given, point)
        if one is not None:
            x, true, at = one
            found[tuple(at.values())] = at, x, true

    hypothesis.settings(
        max_examples=examples,
        derandomize=True,
        deadline=None,
        database=None,
        suppress_health_check=list(hypothesis.HealthCheck),
        phases=[hypothesis.Phase.generate],
    )(hypothesis.given(points(given, symbols(e), e))(note))()
    if not found:
        raise InputError(f"{e} has no value at any point of {given or 'its domain'}")
    rated = sorted(
        ((_digits(x, true), at, x, true) for at, x, true in found.values()), key=lambda r: r[0]
    )
    worst = tuple(
        (at, x, true.str(17, radius=False), digits) for digits, at, x, true in rated[:WORST]
    )
    return AccuracyReport(str(e), given, len(rated), tuple(r[0] for r in rated), worst)


def _digits(x: float, true: arb) -> float:
    """Return the true digits of a number, at most those of double precision."""
    most = 53 * math.log10(2)
    if not math.isfinite(x):
        return 0.0
    with ball_precision(PRECISIONS[-1]):
        if true.is_zero():
            return most if x == 0 else 0.0
        error = (abs(_exact(x) - true) / abs(true)).upper()
        if error < arb((1, -53)):
            return most
        return max(0.0, -float(error.log().mid()) / math.log(10))
