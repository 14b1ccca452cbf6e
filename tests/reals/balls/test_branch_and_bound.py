"""Branch and bound in ball arithmetic: what closes, what must not, what can be stored."""

from itertools import product

import pytest
from flint import arb, ctx, fmpq

from tresym.reals.balls import branch_and_bound
from tresym.reals.balls.branch_and_bound import (
    Bound,
    BoxProof,
    CertificateError,
    Counterexample,
    Open,
    box,
    decide_bound,
    inconsistent,
    leaf_boxes,
    recheck,
    value_at,
)
from tresym.reals.balls.gradient import Divided, coordinates, gradients, taylor_coefficients
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.verdict import Verdict

UNIT = box((0, 1), (0, 1))


def cosine_margin(x, y, m):
    """1 − x²/2 + x⁴/24 − cos x + y/10 + 1/20 > 0."""
    return 1 - x * x / 2 + x**4 / 24 - m.cos(x) + y / 10 + arb(fmpq(1, 20))


def saddle(x, y, m):
    """Smallest value −1/8 at (1/4, 3/4)."""
    u, v = x - arb(fmpq(1, 4)), y - arb(fmpq(3, 4))
    return u * u + v * v - arb(fmpq(1, 8))


@pytest.mark.parametrize("slopes", [False, True])
def test_a_true_bound_closes_rechecks_and_is_found_again(slopes):
    bound = Bound(cosine_margin, UNIT, slopes=slopes)
    proof = decide_bound(bound)
    assert isinstance(proof, BoxProof)
    recheck(bound, proof)
    assert decide_bound(bound) == proof
    assert decide_bound(bound, stored=proof).verdict is Verdict.ENCLOSED
    assert len(list(leaf_boxes(UNIT, proof))) == proof.leaves


def test_leaves_cover_the_box_exactly():
    proof = decide_bound(Bound(cosine_margin, UNIT))
    assert isinstance(proof, BoxProof)
    area = sum((x.width * y.width for (x, y), _ in leaf_boxes(UNIT, proof)), start=fmpq(0))
    assert area == 1


def test_slopes_save_boxes():
    def margin(x, y, m):
        return m.exp(x) - x - x * y / 4 - arb(fmpq(1, 2)) * (1 + x * x * y * y)

    plain = decide_bound(Bound(margin, UNIT))
    sloped = decide_bound(Bound(margin, UNIT, slopes=True))
    assert isinstance(plain, BoxProof)
    assert isinstance(sloped, BoxProof)
    assert sloped.leaves < plain.leaves


@pytest.mark.parametrize("slopes", [False, True])
def test_a_false_bound_is_refuted_with_an_exact_witness(slopes):
    outcome = decide_bound(Bound(saddle, UNIT, slopes=slopes))
    assert isinstance(outcome, Counterexample)
    assert all(0 < x < 1 for x in outcome.point)
    with ball_precision(200):
        assert value_at(saddle, outcome.point) < 0


def test_a_margin_that_touches_zero_is_never_enclosed():
    third = fmpq(1, 3)

    def touching(x, m):
        return (x - arb(third)) ** 2

    for slopes in (False, True):
        outcome = decide_bound(Bound(touching, box((0, 1)), slopes=slopes), budget=3000)
        assert isinstance(outcome, Open)


def test_a_margin_that_vanishes_at_a_corner_is_never_enclosed():
    bound = Bound(lambda x, y, m: x + y, UNIT)
    assert decide_bound(bound, budget=3000).verdict is Verdict.UNDECIDED


def test_an_unbounded_region_by_a_chart():
    """atan a < π/2 on a ≥ 1, with a = 1/α: the edge α = 0 would touch; π/2 − atan a > 1/(2a) not.

    Divided by α the margin is atan(α)/α − 1/2 with its value 1/2 at infinity.
    """
    slope = Divided(lambda s: s.atan())

    def margin(alpha, factor):
        return slope(alpha) - factor

    good = Bound(lambda x, m: margin(x, arb(fmpq(1, 2))), box((0, 1)))
    wrong = Bound(lambda x, m: margin(x, arb("0.79")), box((0, 1)))
    sharp = Bound(lambda x, m: margin(x, m.pi / 4), box((0, 1)))
    assert decide_bound(good).verdict is Verdict.ENCLOSED
    assert decide_bound(wrong).verdict is Verdict.REFUTED
    assert decide_bound(sharp, budget=2000).verdict is Verdict.UNDECIDED


def test_nan_is_never_positive():
    bound = Bound(lambda x, m: m.sqrt(x - 2), box((0, 1)))
    assert decide_bound(bound, budget=200).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "found",
    [BoxProof("b"), BoxProof("xbb"), Counterexample((fmpq(1),), arb(-1))],
)
def test_what_a_search_finds_is_not_believed(found, monkeypatch):
    bound = Bound(lambda x, m: (x + arb(fmpq(1, 2))) * (x - arb(fmpq(1, 2))), box((0, 1)))
    assert isinstance(decide_bound(bound), Counterexample)
    monkeypatch.setattr(branch_and_bound, "_found", lambda *_: found)
    with pytest.raises(CertificateError):
        decide_bound(bound)


def test_a_point_beyond_the_box_refutes_nothing(monkeypatch):
    bound = Bound(lambda x, m: x + arb(fmpq(1, 2)), box((0, 1)))
    monkeypatch.setattr(branch_and_bound, "_found", lambda *_: Counterexample((fmpq(-1),), arb(-1)))
    with pytest.raises(CertificateError):
        decide_bound(bound)


@pytest.mark.parametrize("tree", ["", "x", "xb", "bb", "xbbb", "yb", "q", "mm"])
def test_a_malformed_tree_is_refused(tree):
    with pytest.raises(CertificateError):
        recheck(Bound(lambda x, m: x + 1, box((0, 1))), BoxProof(tree))


def test_a_tree_does_not_prove_another_bound():
    proof = decide_bound(Bound(lambda x, m: x + 1, box((0, 1))))
    assert isinstance(proof, BoxProof)
    for mark in ("b", "m"):
        with pytest.raises(CertificateError):
            recheck(Bound(lambda x, m: x - 1, box((0, 1))), BoxProof(mark))


def test_precision_is_restored():
    before = ctx.prec, ctx.cap
    decide_bound(Bound(cosine_margin, UNIT, precision=200))
    assert (ctx.prec, ctx.cap) == before


def formula(x, y, m):
    """Every function of the gradients at once."""
    u = m.sqrt(1 + x * x) + m.exp(y) - m.expm1(x / 3) + m.log(2 + x) * m.log1p(y)
    v = m.sin(x) * m.cos(y) + m.tan(x / 2) + m.asin(x / 3) - m.acos(y / 3) + m.atan(x * y)
    w = m.sinh(x) / m.cosh(y) + m.tanh(x - y) + m.asinh(x) + m.acosh(2 + y) + m.atanh(y / 2)
    return u * v / (3 + w) + abs(x - 2) ** 3 - 1 / (2 + y) + (1 - x) * m.pi - 2 / (5 - x * y)


def test_gradients_agree_with_difference_quotients():
    with ball_precision(400):
        point, step = (arb(fmpq(3, 7)), arb(fmpq(2, 5))), arb(2) ** -120
        found = formula(*coordinates(point), gradients)
        assert found.value.overlaps(formula(*point, balls))
        for i, slope in enumerate(found.slopes):
            moved = [x + step * (j == i) for j, x in enumerate(point)]
            back = [x - step * (j == i) for j, x in enumerate(point)]
            quotient = (formula(*moved, balls) - formula(*back, balls)) / (2 * step)
            assert abs(quotient - slope) < arb(2) ** -200


def test_divided_functions_are_right_on_both_sides_of_the_seam() -> None:
    for power, x in product([1, 2, 3], ["-1/5", "0", "1/100000000", "1/4", "251/1000", "2"]):
        divided = Divided(lambda s: s.exp(), power)
        at = fmpq(*map(int, x.split("/")))
        with ball_precision(300):
            point = arb(at)
            terms = range(power, power + 60)
            exact = sum((point ** (j - power) / arb(j).gamma() / j for j in terms), start=arb(0))
            steep = [(j - power) * point ** (j - power - 1) / arb(j).gamma() / j for j in terms[1:]]
        with ball_precision(64):
            value, slope = divided(coordinates((arb(at),))[0]).value, None
            slope = divided(coordinates((arb(at),))[0]).slopes[0]
            assert abs(value - exact) < 1e-9
            assert abs(slope - sum(steep, start=arb(0))) < 1e-8
            if abs(at) < 1:
                assert value.overlaps(exact)


def test_divided_function_encloses_over_a_ball():
    divided = Divided(lambda s: (1 + s).log())
    wide = divided(arb(0, 0.2))
    for numerator in range(-19, 20):
        x = arb(fmpq(numerator, 100))
        assert wide.contains(divided(x))


def test_a_short_series_is_refused():
    """FLINT cuts series at a global length: a remainder read beyond it would be a silent 0."""
    with ball_precision(64):
        assert len(taylor_coefficients(lambda s: s.sin(), arb(1), 40)) == 40
        assert taylor_coefficients(lambda s: s.sin(), arb(1), 40)[39] != 0
        with pytest.raises(RuntimeError, match="length"):
            taylor_coefficients(lambda s: s.derivative(), arb(1), 5)


@pytest.mark.parametrize("slopes", [False, True])
def test_a_margin_that_only_suffices_refutes_nothing(slopes):
    """x² ≤ 1 on [0, 1] is true, and x ≤ 1/2 would suffice: that x = 1 fails shows nothing."""
    strong = Bound(lambda x, m: arb(fmpq(1, 2)) - x, box((0, 1)), slopes)
    assert decide_bound(strong).verdict is Verdict.REFUTED
    sufficient = Bound(strong.margin, strong.box, slopes, sufficient=True)
    assert decide_bound(sufficient).verdict is Verdict.UNDECIDED


def test_no_box_becomes_a_needle():
    """A slope that is large along one axis alone must not use up the budget along it."""

    def margin(x, y, m):
        return 1 + arb(10) ** 30 * (x - x) - (y - arb(fmpq(1, 3))) ** 2 / 2

    outcome = decide_bound(Bound(margin, UNIT, slopes=True), budget=4000)
    assert not isinstance(outcome, Counterexample)
    if isinstance(outcome, Open):
        x, y = outcome.worst
        assert (y.high - y.low) <= 2**9 * (x.high - x.low)


FALSEHOODS = {
    "equality on a line": (lambda x, y, m: (x - y) ** 2, UNIT),
    "zero at a corner, flat": (lambda x, y, m: x**4 + y**4, UNIT),
    "zero at an edge": (lambda x, y, m: x * (1 + y), UNIT),
    "negative on a sliver": (
        lambda x, y, m: (x - arb(fmpq(355, 1130))) ** 2 - arb(10) ** -9 + 0 * y,
        UNIT,
    ),
    "a pole inside": (lambda x, y, m: 1 / (x - arb(fmpq(1, 3))) ** 2 - 1, UNIT),
    "a jump of abs": (lambda x, y, m: abs(x - arb(fmpq(1, 3))) - arb(10) ** -12, UNIT),
    "tangent through its pole": (lambda x, y, m: m.tan(3 * x) + 10**6, UNIT),
    "logarithm of a sign change": (lambda x, y, m: m.log((x - y) ** 2) + 50, UNIT),
    "root of a negative number": (lambda x, y, m: 1 + m.sqrt(x - y), UNIT),
    "arcsine beyond one": (lambda x, y, m: 2 - m.asin(x + y), UNIT),
    "below the rounding": (lambda x, y, m: (x - x) + arb(2) ** -80 - arb(2) ** -79, UNIT),
    "cancellation to zero": (lambda x, y, m: m.sin(x) ** 2 + m.cos(x) ** 2 - 1, UNIT),
    "infinite where it matters": (lambda x, y, m: 1 / y - 1 / y + x, UNIT),
}
"""Margins that are not positive everywhere: zero, negative or undefined somewhere."""


@pytest.mark.parametrize("slopes", [False, True])
@pytest.mark.parametrize("name", FALSEHOODS)
def test_planted_falsehoods_are_never_enclosed(name, slopes):
    margin, region = FALSEHOODS[name]
    assert decide_bound(Bound(margin, region, slopes), budget=1500).verdict is not Verdict.ENCLOSED
    for mark in ("b", "m", "xbb", "xmm", "xbm", "ybb", "xyxbbybbb"):
        with pytest.raises(CertificateError):
            recheck(Bound(margin, region), BoxProof(mark))


def test_the_two_forms_of_a_divided_function_agree() -> None:
    """A point near the seam by the quotient and by the Taylor form; a ball contains both."""
    for point, power in product(["1/3", "1/128", "-1/128", "3/2", "1/1000000"], [1, 2, 3, 5]):
        divided = Divided(lambda s: s.sin(), power)
        at = fmpq(*map(int, point.split("/")))
        with ball_precision(200):
            exact = sum(
                (
                    (-1) ** (j // 2) * arb(at) ** (j - power) / (arb(j) + 1).gamma()
                    for j in range(1, 80, 2)
                    if j >= power
                ),
                start=arb(0),
            )
            assert divided(arb(at)).overlaps(exact) or abs(divided(arb(at)) - exact) < 1e-20
            for radius in ("1e-3", "0.1", "2"):
                assert (
                    divided(arb(at, radius)).contains(exact)
                    or not divided(arb(at, radius)).is_finite()
                )


@pytest.mark.parametrize("sides", [[(1, 0)], [(0, 1), (1, 0)], [(1, 0), (0, 1)]])
def test_a_side_whose_ends_are_out_of_order_is_no_side(sides):
    with pytest.raises(ValueError, match="above its upper end"):
        box(*sides)


INCONSISTENT = [
    (lambda x, y, m: 1.0, "not return a ball"),
    (lambda x, y, m: x if x.rad() == 0 else 1.0, "not return a ball"),
    (lambda x, y, m: arb(1), "does not depend"),
    (lambda x, y, m: arb((x + y).mid()), "does not contain"),
    (lambda x, y, m: x + y if x.rad() == 0 else arb(x.mid() + y.mid()), "does not contain"),
    (lambda x, y, m: x if x.rad() == 0 else x.lower(), "does not contain"),
    (lambda x, y, m: x if x.rad() == 0 else x.upper(), "does not contain"),
    (lambda x, y, m: x + (x - y) ** 2 / 1000, None),
    (lambda x, y, m: (x - 5).sqrt(), None),
]
"""Margins that are none, and two that are: one of them is real nowhere."""


@pytest.mark.parametrize(("margin", "expected"), INCONSISTENT)
def test_a_margin_is_a_function_of_its_coordinates(margin, expected):
    with ball_precision(64):
        why = inconsistent(margin, UNIT)
    assert (why is None) == (expected is None)
    assert expected is None or expected in why


def test_slopes_that_are_not_those_of_the_values_are_seen():
    def margin(x, y, m):
        return x * x + y if isinstance(x, arb) else 3 * x + y

    with ball_precision(64):
        assert inconsistent(margin, UNIT) is None
        assert "derivatives" in inconsistent(margin, UNIT, slopes=True)


def test_the_search_ends_open_at_boxes_that_no_precision_can_tell():
    outcome = decide_bound(Bound(lambda x, m: abs(x - arb(1) / 3), box((0, 1))), budget=10_000)
    assert isinstance(outcome, Open)
    assert outcome.worst[0].low <= fmpq(1, 3) <= outcome.worst[0].high


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


@pytest.mark.parametrize(("constant", "expected"), [("2/3", "ENCLOSED"), ("3/10", "REFUTED")])
def test_kepler_equation_uniformly_in_the_mean_anomaly(constant, expected):
    """|E − M − e sin M − (e²/2) sin 2M| ≤ C e³ for 0 < e ≤ 1/5 and every M."""
    number = fmpq(*map(int, constant.split("/")))
    region = box((0, "1/5"), (0, "6284/1000"))
    margins = (kepler_margin(arb(number), side) for side in (1, -1))
    found = {decide_bound(Bound(m, region, slopes=True)).verdict.name for m in margins}
    assert (found == {"ENCLOSED"}) is (expected == "ENCLOSED")
    assert ("REFUTED" in found) is (expected == "REFUTED")
