"""Order statements: decided with constants on ranges, wrong ones refuted with the true order."""

from dataclasses import replace

import pytest
from flint import arb, fmpq

from tresym.ledger.claim import Claim
from tresym.ledger.evidence.balls import Boxes
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.reals.balls.boxes import Bound, box, decide_bound
from tresym.reals.balls.germ import Germs, UnresolvedError, as_ball
from tresym.reals.balls.gradient import Divided
from tresym.reals.balls.order import Order, Size, judge_order
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.verdict import Verdict

ENCLOSED, REFUTED, UNDECIDED = Verdict.ENCLOSED, Verdict.REFUTED, Verdict.UNDECIDED
INFINITY = None


def sine_defect(x, m):
    return m.sin(x) - x


def verdict(kind, function, gauge, **rest):
    return judge_order(Order(kind, function, gauge, **rest)).verdict


def power(n):
    return lambda x, m: x**n


@pytest.mark.parametrize(
    ("kind", "exponent", "expected"),
    [
        ("O", 2, ENCLOSED),
        ("O", 3, ENCLOSED),
        ("O", 4, REFUTED),
        ("o", 2, ENCLOSED),
        ("o", 3, REFUTED),
        ("~", 3, REFUTED),
        ("~", 2, REFUTED),
    ],
)
def test_exponents_of_sin_x_minus_x(kind, exponent, expected):
    found = judge_order(Order(kind, sine_defect, power(exponent)))
    assert found.verdict is expected
    assert found.true_order.power == 3
    assert found.true_order.coefficient.overlaps(arb(-1) / 6)
    if expected is REFUTED:
        assert found.points["t"] > 0


def test_the_constant_is_a_ball_around_the_supremum():
    found = judge_order(Order("O", sine_defect, power(3)))
    assert found.upto == 1
    assert found.constant.contains(arb(1) / 6)
    assert found.constant.rad() < 0.01


@pytest.mark.parametrize(
    ("constant", "upto", "expected"),
    [
        (fmpq(1, 6), fmpq(1), ENCLOSED),  # attained in the limit only
        (fmpq(1, 6), None, ENCLOSED),  # for all x > 0
        (fmpq(1, 7), fmpq(1), REFUTED),
        (fmpq(1, 7), None, REFUTED),
        (fmpq(166666, 1000000), fmpq(1), REFUTED),
        (fmpq(1, 6) - fmpq(1, 10**20), fmpq(1), REFUTED),
    ],
)
def test_constants_and_ranges(constant, upto, expected):
    statement = Order("<=", sine_defect, power(3), constant=constant, upto=upto)
    found = judge_order(statement)
    assert found.verdict is expected
    if expected is REFUTED:
        t = found.points["t"]
        with ball_precision(300):
            assert abs(sine_defect(arb(t), balls)) > arb(constant) * arb(t) ** 3


def test_a_constant_may_hold_near_the_point_and_fail_on_the_range():
    def function(x, m):
        return x * (1 + x * x)

    def holds(constant, upto):
        return verdict("<=", function, power(1), constant=fmpq(constant), upto=upto)

    assert holds("2", fmpq(1, 2)) is ENCLOSED
    assert holds("2", fmpq(3)) is REFUTED
    assert holds("2", None) is REFUTED
    assert holds("10", fmpq(3)) is not ENCLOSED  # equality at the end: boxes cannot close it
    assert holds("11", fmpq(3)) is ENCLOSED


@pytest.mark.parametrize(
    ("kind", "function", "gauge", "rest", "expected"),
    [
        ("~", lambda x, m: m.sqrt(x + x * x), lambda x, m: m.sqrt(x), {}, ENCLOSED),
        ("o", lambda x, m: x * m.log(x), lambda x, m: 1, {}, ENCLOSED),
        ("O", lambda x, m: m.log(x), lambda x, m: 1, {}, REFUTED),
        ("o", lambda x, m: m.log(x), lambda x, m: x, {"at": INFINITY}, ENCLOSED),
        ("o", lambda x, m: x**50, lambda x, m: m.exp(x), {"at": INFINITY}, ENCLOSED),
        ("O", lambda x, m: m.exp(x), lambda x, m: x**50, {"at": INFINITY}, REFUTED),
        ("o", lambda x, m: m.exp(-1 / x), power(9), {}, ENCLOSED),
        ("O", power(9), lambda x, m: m.exp(-1 / x), {}, REFUTED),
        ("~", lambda x, m: m.tanh(1 / x), lambda x, m: 1, {}, ENCLOSED),
        ("~", lambda x, m: m.atan(x), lambda x, m: m.pi / 2, {"at": INFINITY}, ENCLOSED),
        ("~", lambda x, m: m.atan(x), lambda x, m: m.pi / 2, {"at": INFINITY, "side": -1}, REFUTED),
        ("O", lambda x, m: m.log(x), lambda x, m: x - 1, {"at": fmpq(1)}, ENCLOSED),
        ("~", lambda x, m: m.log(x), lambda x, m: x - 1, {"at": fmpq(1), "side": -1}, ENCLOSED),
        ("~", lambda x, m: m.tan(x), lambda x, m: 2 * x, {}, REFUTED),
        ("O", lambda x, m: x * m.sin(1 / x), power(1), {}, ENCLOSED),
        ("o", lambda x, m: m.sinh(x) / m.cosh(x) - m.tanh(x), power(50), {}, UNDECIDED),
        ("~", lambda x, m: m.exp(m.log(2 + x) - m.log(2 + 0 * x)), lambda x, m: 1, {}, UNDECIDED),
        ("O", lambda x, m: m.sqrt(-x), power(1), {}, UNDECIDED),
        ("O", lambda x, m: m.asin(2 + x), lambda x, m: 1, {}, UNDECIDED),
    ],
)
def test_statements_of_every_kind(kind, function, gauge, rest, expected):
    assert verdict(kind, function, gauge, **rest) is expected


def test_a_statement_needs_a_constant_exactly_when_it_states_one():
    with pytest.raises(ValueError, match="constant"):
        Order("O", sine_defect, power(3), constant=fmpq(1))
    with pytest.raises(ValueError, match="constant"):
        Order("<=", sine_defect, power(3))
    with pytest.raises(ValueError, match="one of"):
        Order("Theta", sine_defect, power(3))


FORMULAS = [
    lambda x, m: m.exp(-m.sqrt(4 + x) / x) + m.sin(x) ** 2 / x - m.atan(x * x),
    lambda x, m: m.tanh(1 / x) * m.cosh(x) - m.asinh(x) / (1 + m.sinh(x)),
    lambda x, m: m.log(3 + m.cos(x)) * m.atanh(x / 2) + m.expm1(-x) * m.log1p(x),
    lambda x, m: m.acos(x / 3) - m.asin(x / 3) + m.tan(x) / (x + 2) - abs(x - 2),
    lambda x, m: (1 + x) ** fmpq(1, 3) * m.sinh(1 / x) + m.acosh(2 + x) + m.atan(1 / x),
    lambda x, m: m.exp(1 / x + x) * m.log(m.exp(1 / x) * (1 + x)),
]


@pytest.mark.parametrize("formula", FORMULAS)
@pytest.mark.parametrize("order", [2, 3, 8])
def test_a_germ_encloses_its_function_on_the_whole_range(formula, order):
    with ball_precision(100):
        m = Germs(fmpq(1, 4), order)
        germ = formula(m.x, m)
        assert germ.range().is_finite()
        for k in range(1, 40):
            x = arb(fmpq(k, 160))
            total = germ.rest
            for c in reversed(germ.terms):
                total = total * x + as_ball(c)
            exponent = sum((as_ball(p) / x**j for j, p in enumerate(germ.exponent)), start=arb(0))
            assert (total * x**germ.power * exponent.exp()).overlaps(formula(x, balls))


def test_a_germ_is_not_formed_where_a_sign_is_not_certain():
    with ball_precision(100):
        m = Germs(fmpq(1))
        for bad in (
            lambda: 1 / m.bounded(arb(0, 1)),
            lambda: abs(m.x - fmpq(1, 2)),
            lambda: m.log(m.x - 1),
            lambda: m.exp(m.exp(1 / m.x)),
            lambda: m.exp(m.bounded(arb(0, 1)) / m.x),
        ):
            with pytest.raises(UnresolvedError):
                bad()


PLANTED = {
    "an oscillation over too high a power": ("O", lambda x, m: x * m.sin(1 / x), power(2), {}),
    "an oscillation that has no limit": ("o", lambda x, m: m.sin(1 / x), lambda x, m: 1, {}),
    "~ up to an oscillation": ("~", lambda x, m: x + x * m.sin(1 / x), power(1), {}),
    "~ up to 10^-30": ("~", lambda x, m: m.sin(x) * (1 + fmpq(1, 10**30)), power(1), {}),
    "~ with the other sign": (
        "~",
        lambda x, m: m.sqrt(x * x + 1),
        power(1),
        {"at": None, "side": -1},
    ),
    "flat functions of one exponent": (
        "O",
        lambda x, m: m.exp(-1 / x),
        lambda x, m: x**20 * m.exp(-1 / x),
        {},
    ),
    "flat functions of two exponents": (
        "O",
        lambda x, m: m.exp(m.exp(-1 / x)) - 1,
        lambda x, m: m.exp(-2 / x),
        {},
    ),
    "a flat term beside a power": ("o", lambda x, m: m.exp(-1 / x) + x**9, power(9), {}),
    "a difference of large numbers": (
        "O",
        lambda x, m: m.exp(1 / x) - m.exp(1 / x + x),
        lambda x, m: m.exp(1 / x) * x**2,
        {},
    ),
    "a power against a logarithm": ("O", lambda x, m: x ** fmpq(-1, 3), lambda x, m: m.log(x), {}),
    "a gauge that vanishes": ("O", power(1), lambda x, m: x - x, {}),
    "a thin bump on the range": (
        "<=",
        lambda x, m: m.exp(-((x - fmpq(355, 113)) ** 2) * 10**8),
        power(1),
        {"constant": fmpq(1, 20), "upto": fmpq(20)},
    ),
    "a thin bump on the half line": (
        "<=",
        lambda x, m: m.exp(-((x - fmpq(355, 113)) ** 2) * 10**8),
        power(1),
        {"constant": fmpq(1, 20), "upto": None},
    ),
    "undefined at the end of the range": (
        "<=",
        lambda x, m: m.sqrt(fmpq(1, 2) - x) * x,
        power(1),
        {"constant": fmpq(1)},
    ),
    "a pole in the range": (
        "<=",
        lambda x, m: x / (x * x - fmpq(1, 2)),
        lambda x, m: 1 + 0 * x,
        {"constant": fmpq(10**6)},
    ),
    "a pole of the tangent": (
        "<=",
        lambda x, m: m.tan(x),
        power(1),
        {"constant": fmpq(10**6), "upto": fmpq(2)},
    ),
    "larger in the middle only": (
        "<=",
        lambda x, m: m.exp(-1 / x),
        power(3),
        {"constant": fmpq(1)},
    ),
    "larger far out only": ("<=", power(2), power(1), {"constant": fmpq(1), "upto": None}),
    "a kink below the line": (
        "<=",
        lambda x, m: abs(x - fmpq(1, 3)),
        power(1),
        {"constant": fmpq(1)},
    ),
}
"""False statements: wrong exponents, constants and ranges, and formulas undefined on the way."""


@pytest.mark.parametrize("name", PLANTED)
def test_planted_falsehoods_are_never_enclosed(name):
    kind, function, gauge, rest = PLANTED[name]
    assert verdict(kind, function, gauge, **rest) is not ENCLOSED


# -- other scenes: nothing below has to do with rackets ---------------------------------------


def stirling_step(x, m):
    """r(n) − r(n+1) for r(n) = log n! − (n + ½) log n + n − ½ log 2π, with x = 1/n."""
    return (1 / x + fmpq(1, 2)) * m.log1p(x) - 1


def test_stirling_remainder_has_the_constant_one_twelfth():
    """0 < r(n) ≤ 1/(12n) for all n ≥ 1: the steps telescope, and r(n) → 0."""
    upper = {"kind": "<=", "function": stirling_step, "gauge": lambda x, m: x - x / (1 + x)}
    assert judge_order(Order(**upper, constant=fmpq(1, 12))).verdict is ENCLOSED
    assert judge_order(Order(**upper, constant=fmpq(83, 1000))).verdict is REFUTED

    def below(x, m):
        """1/(12n+1) − 1/(12n+13), the step of the lower bound 1/(12n+1)."""
        return x / (12 + x) - x / (12 + 13 * x)

    assert verdict("<=", below, stirling_step, constant=fmpq(1)) is ENCLOSED
    assert verdict("O", stirling_step, power(3)) is REFUTED
    found = judge_order(Order("O", stirling_step, power(2)))
    assert found.verdict is ENCLOSED
    assert found.ratio.coefficient.overlaps(arb(1) / 12)


def kepler(mean, m, eccentricity, rounds=10):
    """The eccentric anomaly E = M + e sin E as a germ in e: each sweep encloses one order more."""
    anomaly = mean + eccentricity * m.bounded(arb(0, 1))
    for _ in range(rounds):
        anomaly = mean + eccentricity * m.sin(anomaly)
    return anomaly


def test_kepler_equation_along_a_path():
    """E − M = e sin M + O(e²), not o(e²), at mean anomaly 1."""
    with ball_precision(128):
        m = Germs(fmpq(1, 4))
        second = kepler(1, m, m.x) - 1 - m.x * m.sin(m.germ(1))
        # The coefficient of e is a ball around 0: a bound of order e² needs the exact zero.
        assert second.terms[0].contains(0)
        assert second.terms[1].overlaps(m.sin(m.germ(2)).leading / 2)

    def anomaly_at_origin(e, m):
        """M = e itself: E = M + e sin E with M = e, where every coefficient is rational."""
        return kepler(e, m, e)

    with ball_precision(128):
        m = Germs(fmpq(1, 4))
        assert [as_ball(c) for c in anomaly_at_origin(m.x, m).terms[:2]] == [1, 1]


COSINE = Divided(lambda s: s.cos(), 2)
SINE = Divided(lambda s: s.sin(), 3)


def kepler_margin(constant, side):
    """e⁻³ times the residual of Kepler's equation at M + e sin M + (e²/2) sin 2M ± C e³."""

    def margin(e, mean, m):
        s, c = m.sin(mean), m.cos(mean)
        delta = s + e * s * c + e * e * (constant * side)
        z = e * delta
        # (z − sin z)/z³ and (1 − cos z)/z², regular at 0; sin(M + z) expanded by addition.
        cubic, square = -SINE(z), -COSINE(z)
        residual = (
            s * delta**2 * square + c * e * delta**3 * cubic - c * (s * c + e * constant * side)
        )
        return side * residual + constant

    return margin


@pytest.mark.parametrize(("constant", "expected"), [("2/3", ENCLOSED), ("3/10", REFUTED)])
def test_kepler_equation_uniformly_in_the_mean_anomaly(constant, expected):
    """|E − M − e sin M − (e²/2) sin 2M| ≤ C e³ for 0 < e ≤ 1/5 and every M."""
    number = fmpq(*map(int, constant.split("/")))
    region = box((0, "1/5"), (0, "6284/1000"))
    found = {
        decide_bound(Bound(kepler_margin(arb(number), side), region, slopes=True)).verdict
        for side in (1, -1)
    }
    assert (found == {ENCLOSED}) is (expected is ENCLOSED)
    assert (REFUTED in found) is (expected is REFUTED)


def pendulum_correction(x, m):
    """K(k) − log(4/k'), k' = x the complementary modulus (DLMF 19.12.1), three terms and a tail.

    K(k) = Σ ((1/2)_n/n!)² k'^{2n} (log(1/k') + d(n)), with d(0) = log 4 and 0 < d(n) ≤ d(1);
    the coefficients are at most 1/4, so the tail from n = 3 is at most x⁶ (log(1/x) + d(1))/4
    times 1/(1 − x²) ≤ 4/3 for x ≤ 1/2.
    """
    log = -m.log(x)
    four = m.log(4 + 0 * x)
    first = x * x / 4 * (log + four - 1)
    second = x**4 * fmpq(9, 64) * (log + four - 1 - fmpq(1, 6))
    tail = x**6 * (log + 1) * arb(fmpq(1, 6), fmpq(1, 6))
    return first + second + tail


def test_pendulum_period_near_its_separatrix():
    """The period 4K/ω₀: K = log(4/k') + O(k'² log(1/k')), sharp, and not O(k'²)."""

    def gauge(x, m):
        return -(x * x) * m.log(x)

    found = judge_order(Order("O", pendulum_correction, gauge, upto=fmpq(1, 4)))
    assert found.verdict is ENCLOSED
    assert found.ratio.coefficient.contains(arb(1) / 4)
    assert found.constant.upper() < 2
    assert verdict("~", pendulum_correction, lambda x, m: gauge(x, m) / 4) is ENCLOSED
    assert verdict("O", pendulum_correction, power(2)) is REFUTED
    assert verdict("o", pendulum_correction, gauge) is REFUTED
    assert verdict("o", pendulum_correction, power(1)) is ENCLOSED


def test_the_pendulum_series_is_the_elliptic_integral():
    with ball_precision(200):
        for k in range(2, 12):
            x = arb(fmpq(1, k))
            exact = balls.pi / 2 / arb(1).agm(x) - (4 / x).log()

            assert pendulum_correction(x, balls).contains(exact)


def test_orders_of_other_scenes_are_claims_like_any_other():
    """Stirling, Kepler and the pendulum through the ledger's own judge, held and refuted."""
    no_claims: dict[str, Finding] = {}

    def judged(label, says, proof):
        return judge(Claim(label, says, proof, kind="order"), no_claims).verdict

    stirling = Order("<=", stirling_step, lambda x, m: x - x / (1 + x), constant=fmpq(1, 12))
    assert judge_order(stirling).verdict is ENCLOSED
    sharper = replace(stirling, constant=fmpq(83, 1000))
    assert judge_order(sharper).verdict is REFUTED

    def gauge(x, m):
        return -(x * x) * m.log(x)

    period = Order("O", pendulum_correction, gauge, upto=fmpq(1, 4))
    assert judge_order(period).verdict is ENCLOSED
    square = replace(period, gauge=power(2))
    assert judge_order(square).verdict is REFUTED

    for constant, expected in ((fmpq(2, 3), ENCLOSED), (fmpq(3, 10), REFUTED)):
        region = box((0, "1/5"), (0, "6284/1000"))
        margins = [kepler_margin(arb(constant), side) for side in (1, -1)]
        bounds = tuple(Bound(margin, region, slopes=True) for margin in margins)
        assert judged("kepler", "E", Boxes(bounds, ("e", "M"), "e <= 1/5")) is expected


SUPREMA = [
    (lambda x, m: m.exp(-x), power(0), lambda: arb(1)),
    (lambda x, m: x * x * m.exp(-3 * x), power(1), lambda: arb(-1).exp() / 3),
    (lambda x, m: x + 3 * x**3, power(1), lambda: arb(4)),
    (lambda x, m: x * (1 - x) * (1 - x), power(0), lambda: arb(4) / 27),
    (lambda x, m: 0 * x, power(1), lambda: arb(0)),
]
"""Functions, gauges, and the supremum of the ratio on (0, 1]: in the limit, inside, at the end."""


@pytest.mark.parametrize(("function", "gauge", "expected"), SUPREMA)
def test_the_supremum_lies_in_the_constant(function, gauge, expected):
    found = judge_order(Order("O", function, gauge))
    assert (found.verdict, found.upto) == (ENCLOSED, 1)
    assert found.constant.overlaps(expected())
    assert found.constant.rad() <= 0.01 * found.constant.mid()


def test_an_expansion_reaches_no_further_than_its_function():
    found = judge_order(Order("O", lambda x, m: m.log(1 - 4 * x), power(1)))
    assert found.verdict is ENCLOSED
    assert found.upto < fmpq(1, 4)
    assert found.constant.is_finite()
    found = judge_order(Order("O", power(1), lambda x, m: m.sqrt(1 - 4 * x)))
    assert found.upto < fmpq(1, 4)


def near_the_point(x, m):
    return 2 * x if isinstance(x, arb) and x < arb(1) / 32 else x


def by_floats(x, m):
    return float(x) if isinstance(x, arb) else x


def nothing_by_floats(x, m):
    return 0 * float(x.mid()) if isinstance(x, arb) else 0 * x


@pytest.mark.parametrize("function", [near_the_point, by_floats, nothing_by_floats])
def test_a_function_that_goes_by_what_it_is_given_is_not_judged(function):
    kind = "o" if function is nothing_by_floats else "~"
    assert judge_order(Order(kind, function, power(1))).verdict is UNDECIDED


def test_two_functions_that_are_zero_have_no_ratio():
    assert verdict("~", lambda x, m: 0 * x, lambda x, m: 0 * x) is not ENCLOSED


TEXTS = [
    (Size(arb(2), fmpq(3)), "2.00000 * t^(3)"),
    (Size(arb(2), fmpq(0)), "2.00000"),
    (Size(arb(2), fmpq(1, 2), (arb(0), arb(-1))), "2.00000 * t^(1/2) * exp(-1.00000/t^1)"),
    (Size(arb(2), fmpq(0), (arb(3), arb(0))), "2.00000 * exp(3.00000)"),
    (Size(arb(2), fmpq(2), (), True), "2.00000 * log(1/t)^(-2)"),
    (Size(arb(2), fmpq(0), (arb(0), arb(-2)), True), "2.00000 * t^(2)"),
    (Size(arb(2), fmpq(0), (arb(0), arb("-0.5")), True), "2.00000 * t^(0.500000)"),
    (Size(arb(2), fmpq(0), (arb(1), arb(0), arb(4)), True), ("2.00000 * exp(1.00000)", "4.00000")),
]


@pytest.mark.parametrize(("size", "expected"), TEXTS)
def test_a_leading_term_is_written_as_it_is(size, expected):
    first, *more = expected if isinstance(expected, tuple) else (expected,)
    assert size.text().startswith(first)
    assert all(part in size.text() for part in more)
    if not more:
        assert size.text() == first


def test_far_away_a_leading_term_is_written_in_the_variable():
    assert Size(arb(1), fmpq(1), (arb(0), arb(2)), True).text("(1/x)") == (
        "1.00000 * log(x)^(-1) * x^(2)"
    )
