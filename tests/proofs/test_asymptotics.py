"""The theorem judged and repaired: margins against roots, verdicts, planted falsehoods."""

from dataclasses import replace

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from tresym.proofs import asymptotics, constants, exponent, monotonicity, orders, rigid_bodies
from tresym.proofs import charts as stored_charts

from tresym.commands import main
from tresym.ledger import certificates, verification
from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.evidence.box_bounds import Boxes, finding_anew
from tresym.ledger.evidence.chart_bounds import Charted
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.racket.bounds import bending, charts
from tresym.racket.comparison.constants import CONSTANTS, excesses
from tresym.racket.comparison.errors import slope_at
from tresym.racket.flip import defect, series, uniform
from tresym.racket.flip.separatrix import solve
from tresym.racket.formulas import printed, stable
from tresym.racket.motion.quadrature import rigorous
from tresym.reals.balls.branch_and_bound import (
    Bound,
    BoxProof,
    CertificateError,
    box,
    decide_bound,
    leaf_boxes,
    recheck,
    value_at,
)
from tresym.reals.balls.tracing import traced
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.numbers.exact import InputError, as_rational
from tresym.reals.verdict import Verdict

SHAPES = [
    (fmpq(1, 4), fmpq(1)),
    (fmpq(16380, 1210) - 1, 1 - fmpq(16380, 17480)),
    (fmpq(1, 2), fmpq(1, 2)),
    (fmpq(100), fmpq(1, 400)),
    (fmpq(1, 100), fmpq(9, 10)),
]
SIX = [shape for shape in SHAPES if shape[0] * shape[1] >= fmpq(1, 4)]


def stated(module):
    named = getattr(module, "claims", None) or vars(module)
    values = [v if isinstance(v, tuple) else (v,) for v in named.values()]
    claims = dict.fromkeys(v for several in values for v in several if isinstance(v, Claim))
    return [c for c in claims if isinstance(c.proof, Boxes | Charted)]


PARTS = (asymptotics, constants, exponent, monotonicity, orders, rigid_bodies)
CLAIMS = list(dict.fromkeys(claim for part in PARTS for claim in stated(part)))


EVERY = 8
"""Of so many claims one is searched for anew in every run, and all of them every night."""
ANEW = [
    pytest.param(claim, id=claim.label, marks=pytest.mark.night if n % EVERY else ())
    for n, claim in enumerate(CLAIMS)
]


@pytest.mark.slow
@pytest.mark.parametrize("claim", ANEW)
def test_every_claim_gets_its_verdict_when_found_anew(claim):
    settled = {used.label: Finding(Verdict.PROVED, "") for used in claim.uses}
    with finding_anew():
        finding = judge(claim, settled)
    assert finding.verdict is claim.expect
    if finding.verdict is Verdict.REFUTED:
        assert finding.witness


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.label)
def test_stored_proofs_are_those_of_the_enclosed_bounds(claim):
    if not isinstance(claim.proof, Boxes | Charted) or claim.proof.stored is None:
        return
    proofs = claim.proof.stored()
    assert (proofs is not None) is (claim.expect is Verdict.ENCLOSED)
    if proofs is not None:
        assert len(proofs) == len(claim.proof.bounds)


def test_a_tampered_certificate_is_refused():
    proof = asymptotics.repaired.proof
    with pytest.raises(CertificateError):
        decide_bound(proof.bounds[0], stored=BoxProof("b"))


def test_what_is_found_anew_is_what_is_stored(tmp_path, monkeypatch):
    kept = certificates.checkout_file().read_text(encoding="utf-8")
    with finding_anew():
        report = verification.verify(["printed_error"])
    (tmp_path / "proofs").mkdir()
    (tmp_path / "pyproject.toml").touch()
    copy = tmp_path / "proofs" / certificates.FILE
    monkeypatch.setattr(certificates, "checkout_file", lambda: copy)
    assert verification.save_certificates(report) == 1
    assert copy.read_text(encoding="utf-8") == kept


def test_stored_proofs_are_written_in_a_checkout_only(tmp_path, monkeypatch):
    monkeypatch.setattr(certificates, "file_of", lambda name: tmp_path / "proofs" / name)
    with pytest.raises(InputError, match="checkout"):
        certificates.checkout_file()


def test_saving_needs_a_full_search(capsys):
    assert main(["verify", "--save-certificates", "rigid_body_floor"]) == 2
    assert "--full" in capsys.readouterr().err


def balls_of(a, b):
    k, r = arb(a * b).sqrt(), arb(b / a).sqrt()
    exact = solve(a, b, 60).defect
    return arb(a), arb(b), k, r, exact


@pytest.mark.parametrize(("a", "b"), SHAPES)
def test_the_exponent_rate_is_that_of_the_exact_root(a, b):
    with ball_precision(256):
        _, b_, k, r, exact = balls_of(a, b)
        rate = charts.exponent_rate(exact, b_, r, balls)
        expected = (exact / stable.leading_term(k, r, balls)).log() / exact**2
        assert abs(rate - expected) < 1e-9


@pytest.mark.parametrize(("a", "b"), SHAPES)
def test_the_charts_are_the_same_shape(a, b):
    with ball_precision(256):
        _, b_, k, r, _ = balls_of(a, b)
        star = stable.leading_term(k, r, balls)
        for shape in (
            charts.by_kappa(b_, 1 / k, balls),
            charts.by_root(b_, k, balls),
        ):
            assert abs(shape.leading / star - 1) < 1e-9
            assert shape.b.overlaps(b_)
            assert abs(shape.r - r) < 1e-60


@pytest.mark.parametrize(("a", "b"), SHAPES)
@pytest.mark.parametrize("start", ["pi", "4"])
def test_the_errors_of_the_uniform_formulas_are_the_true_ones(a, b, start):
    with ball_precision(256):
        a_, b_, k, _, exact = balls_of(a, b)
        begin = balls.pi if start == "pi" else arb(4)
        line = uniform.one_line if start == "pi" else uniform.balanced
        error = charts.sweep_error(b_, k, begin, balls)
        assert abs(error - (line(a_, b_, balls) / exact - 1)) < 1e-9
        newton = charts.newton_error(b_, k, begin, balls)
        true = uniform.one_step(a_, b_, balls, begin) / exact - 1
        assert true <= 0
        assert newton.contains(true) or abs(newton - true) < 1e-12
        assert abs(error) < (0.028 if start == "pi" else 0.0065)
        assert -true < (1e-4 if start == "pi" else 4e-6)


@pytest.mark.parametrize(("a", "b"), SIX)
def test_the_slope_at_the_separatrix(a, b):
    with ball_precision(256):
        a_, b_, k, _, exact = balls_of(a, b)
        slope = stable.turn_slope(exact, a_, b_, balls) / printed.integrand(
            exact, a_, b_, arb(0), 1, balls
        )
        rest = (-4 * b_ * exact * slope - 1) / exact**2 / k
        found = charts.slope_rest(b_, 1 / k, balls)
        assert found.overlaps(rest) or abs(found - rest) < 1e-6
        assert abs(slope + 1 / (4 * b_ * exact)) < arb("3.15") * k * exact / b_


@pytest.mark.parametrize(("a", "b"), SIX)
def test_the_printed_error_is_as_enclosed(a, b):
    with ball_precision(256):
        a_, b_, k, _, exact = balls_of(a, b)
        true = (printed.asymptotic_defect(a_, b_, balls) / exact).log() * k * k
        assert abs(true - stored_charts.printed_logarithm(b_, 1 / k, balls)) < 1e-9


SIDES, CHART = ((0, 1), (0, 2)), ((0, 1), (0, "7/4"))
"""The charts (b, κ) of ab ≥ 1/4 and (b, k) of k ≤ 7/4."""


def within_numbers(error, constant):
    """The two margins of |error| < constant."""
    limit = as_rational(constant)
    return tuple(lambda x, y, m, s=s: arb(limit) - s * error(x, y, m) for s in (1, -1))


def from_pi(error):
    return lambda b, k, m: error(b, k, m.pi, m)


def from_four(error):
    return lambda b, k, m: error(b, k, arb(4), m)


WRONG = [
    (within_numbers(stored_charts.EXCESS[0], "1.4506"), SIDES),
    (within_numbers(stored_charts.EXCESS[1], "2.97"), SIDES),
    (within_numbers(stored_charts.EXCESS[0], "0.083"), ((0, "1/2"), (0, "1/4"))),
    (within_numbers(from_pi(charts.sweep_error), "0.0271"), CHART),
    (within_numbers(from_four(charts.sweep_error), "0.006"), CHART),
    (within_numbers(from_pi(charts.newton_error), "7e-5"), CHART),
    (within_numbers(from_four(charts.newton_error), "2.5e-6"), CHART),
    (within_numbers(stored_charts.quadratic_u, "0.0086"), SIDES),
    (within_numbers(stored_charts.turn_slope_times_defect, "0.95"), SIDES),
    (within_numbers(stored_charts.slope_times_defect, "0.17"), SIDES),
]


@pytest.mark.parametrize(("margins_", "sides"), WRONG)
@pytest.mark.slow
def test_constants_beyond_the_supremum_are_never_enclosed(margins_, sides):
    verdicts = {
        decide_bound(Bound(margin, box(*sides)), budget=1500).verdict for margin in margins_
    }
    assert verdicts != {Verdict.ENCLOSED}


def test_a_range_too_long_is_never_enclosed():
    """The constant of ab ≥ 1/4 fails on ab ≥ 1/5."""
    parts = within_numbers(stored_charts.EXCESS[0], "1.451")
    verdicts = {decide_bound(Bound(p, box((0, 1), (0, "9/4"))), budget=1500).verdict for p in parts}
    assert verdicts != {Verdict.ENCLOSED}


def test_the_floor_is_not_higher():
    """At u = 1/8 (a = 7) a planar body is above the floor, and at a = 10⁶ within 10⁻⁶ of it."""
    with ball_precision(200):
        floor = 2 * (-balls.pi).exp().atan()
        assert abs(floor - arb("0.0863740970495643")) < 1e-15
        for a in (fmpq(1, 1000), fmpq(1), fmpq(7), fmpq(10**6)):
            exact = solve(a, 1 / (a + 2), 40).defect
            assert exact > floor
            if a >= 7:
                assert exact < floor + 1 / arb(a + 1)


@pytest.mark.parametrize(("a", "b"), SHAPES)
@pytest.mark.parametrize("order", [0, 1])
def test_the_excesses_are_those_of_the_exact_root(a, b, order):
    with ball_precision(256):
        _, b_, k, _, _ = balls_of(a, b)
        expected = excesses(a, b, 12)[order]
        ratio = stored_charts.EXCESSES[order]
        assert abs(ratio(charts.root_by_k(k, 1 / arb(a), balls), balls) - expected) < 1e-9
        assert abs(ratio(charts.root_by_kappa(b_, 1 / k, balls), balls) - expected) < 1e-9
        gap, power = charts.gap_over(arb(a), b_.sqrt(), order, balls)
        assert abs(gap / power - expected) < 1e-9
    with ball_precision(64):
        wide = arb(b, fmpq(1, 1000)), 1 / arb(a * b).sqrt() * arb(1, fmpq(1, 1000))
        assert ratio(charts.root_by_kappa(*wide, balls), balls).contains(expected)


@pytest.mark.parametrize(("a", "b"), SIX)
def test_the_third_excess_is_that_of_the_exact_root(a, b):
    exact = solve(a, b, 80).defect
    with ball_precision(256):
        _, b_, k, r, _ = balls_of(a, b)
        star = stable.leading_term(k, r, balls)
        square = star * star
        c = series.coefficient_values(2, b_, r * r, balls)
        expected = (exact / star - 1 - c[1] * square - c[2] * square**2) / square**3
        found = charts.third_excess(charts.root_by_kappa(b_, 1 / k, balls), balls)
        assert found.overlaps(expected)
        assert found.rad() < 1e-2


def test_the_coefficients_of_the_exponent_are_those_of_its_logarithm():
    """exp((2n + 1) Q) has c_n (2n + 1) at wⁿ, here for n = 1, 2 by hand."""
    q = series.exponent_coefficients(2)
    c = series.coefficients(2)
    assert q[0] == 0
    assert q[1] == c[1]
    assert 5 * c[2] == 5 * q[2] + (5 * q[1]) ** 2 / 2


def bounds_of(charts_):
    pairs = [(on.box, shown) for on in charts_ for shown in on.shown]
    return [Bound(traced(s.margin, len(region)), region, s.slopes) for region, s in pairs]


@pytest.mark.parametrize("row", CONSTANTS, ids=lambda row: row.least)
@pytest.mark.parametrize("order", [0, 1])
def test_constants_against_the_least_a_are_within_one_per_cent(row, order):
    """At a = a₀, b = 1 the ratio exceeds 99 % of the constant, and boxes find that out."""
    a0, constant = as_rational(row.least), as_rational(row[1 + order])
    least = excesses(a0, fmpq(1))[order]
    assert least < arb(constant)
    assert least > arb(constant) * arb("0.99")
    short = constant * fmpq(99, 100)
    proofs = [stored_charts.region_beyond(order, a0, short)]
    if a0 < stored_charts.LEAST:
        proofs.append((stored_charts.slab(order, a0, 2 * a0, short),))
    for bounds in map(bounds_of, proofs):
        assert Verdict.REFUTED in {decide_bound(bound, budget=50).verdict for bound in bounds}


@pytest.mark.parametrize("order", [0, 1])
@pytest.mark.parametrize(("a0", "row"), [("1/5", 3), ("9/10", 5), ("9", 8)])
def test_a_constant_does_not_reach_below_its_least_a(order, a0, row):
    constant = as_rational(CONSTANTS[row][1 + order])
    bounds = bounds_of(stored_charts.region_beyond(order, as_rational(a0), constant))
    assert Verdict.REFUTED in {decide_bound(bound, budget=50).verdict for bound in bounds}


@given(
    st.fractions(min_value="1/100", max_value=50, max_denominator=10**4),
    st.fractions(min_value="1/1000", max_value=1, max_denominator=10**4),
)
@pytest.mark.slow
def test_the_constants_hold_at_every_shape(a, b):
    shape = fmpq(a.numerator, a.denominator), fmpq(b.numerator, b.denominator)
    first, second = excesses(*shape)
    for row in CONSTANTS:
        if shape[0] >= as_rational(row.least):
            assert abs(first) < arb(as_rational(row.first))
            assert abs(second) < arb(as_rational(row.second))
    assert first > -arb(fmpq(1, 12))


def test_a_claim_without_bounds_shows_nothing():
    assert Boxes((), (), "nowhere").judge().verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(("a", "b"), SHAPES)
def test_half_the_leading_term_is_below_the_tangent_of_half_the_defect(a, b):
    with ball_precision(200):
        _, _, k, r, exact = balls_of(a, b)
        star = stable.leading_term(k, r, balls)
        assert (exact / 2).tan() > star / 2
        assert exact / star > 1 - star**2 / 12


@pytest.mark.parametrize(("a", "b"), SIX)
@pytest.mark.parametrize("v", ["-1", "-1/3", "1/2", "1"])
def test_the_defect_stays_near_its_tangent_and_near_the_printed_line(a, b, v):
    """On |γ| ≤ bε₀², at γ = bε₀²v rounded to a rational."""
    with ball_precision(200):
        _, b_, k, _, exact = balls_of(a, b)
        slope, leading = slope_at(a, b, 40)
        level = fmpq(int((b_ * exact**2 * arb(as_rational(v)) * 2**90).mid().floor().unique_fmpz()))
        gamma = arb(level / 2**90)
    found = defect.solve(a, b, level / 2**90, 30).defect
    with ball_precision(200):
        rest = found - exact - gamma * slope
        assert abs(rest) < 2 * k * gamma**2 / (b_**2 * exact)
        off = found - exact - gamma * leading
        assert abs(off) < arb("5.15") * k * exact * abs(gamma) / b_


@pytest.mark.parametrize(("a", "b"), SIX)
@pytest.mark.parametrize("v", ["-9/10", "1/4", "3/4"])
@pytest.mark.parametrize("constant", ["2", "-2", "1/2"])
def test_the_curvature_is_a_second_difference_of_the_turn(a, b, v, constant):
    """The closed form of H″/λ contains the second difference of H by rigorous quadrature."""
    step = fmpq(1, 10**10)
    with ball_precision(256):
        a_, b_, k, _, exact = balls_of(a, b)
        scale, limit = k * exact**2, arb(as_rational(constant))
        p = slope_at(a, b, 60)[0] * b_ * exact

        def turn(at):
            x = arb(at)
            candidate = exact * (1 + p * x + limit * scale * x * x)
            return k * rigorous(candidate, a_, b_, b_ * exact**2 * x)

        at = as_rational(v)
        second = (turn(at + step) - 2 * turn(at) + turn(at - step)) / arb(step) ** 2
        closed = bending.curvature(b_, 1 / k, arb(at), limit, balls)
        assert abs(closed.mid() - second / scale) < closed.rad() + 1e-6
        assert closed.rad() < 3


@pytest.mark.parametrize(("b", "R"), [("1", "4"), ("1/2", "1/3"), ("1/1000", "0"), ("1/4", "2")])
def test_the_rest_of_the_numerator_is_enclosed(b, R):
    with ball_precision(100):
        b_, R_ = arb(as_rational(b)), arb(as_rational(R))
        hull = bending.second_order_rest(b_, R_)
        for n in range(1, 63):
            psi = arb(fmpq(n, 40))
            x, c = psi.sin() ** 2, psi.cos()
            j = ((1 - b_ * x) / (1 + R_ * x).sqrt() - c) / x
            assert hull.overlaps((j - (arb(1) / 2 - b_ - R_ / 2) * c) / x)


@pytest.mark.parametrize("constant", ["1/2", "-1/20"])
def test_too_small_a_curvature_shows_nothing_and_refutes_nothing(constant):
    assert decide_bound(stored_charts.bending(constant), budget=300).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(("a", "b"), [(fmpq(4), fmpq(1)), (fmpq(1000), fmpq(1, 50))])
@pytest.mark.parametrize("start", ["pi", "4"])
def test_the_errors_far_out_are_the_true_ones(a, b, start):
    with ball_precision(300):
        a_, b_, k, _, _ = balls_of(a, b)
        exact = solve(a, b, 80).defect
        begin = balls.pi if start == "pi" else arb(4)
        line = uniform.one_line if start == "pi" else uniform.balanced
        for error, formula in (
            (charts.far_sweep_error, line(a_, b_, balls)),
            (charts.far_newton_error, uniform.one_step(a_, b_, balls, begin)),
        ):
            true = formula / exact - 1
            assert abs(error(b_, 1 / k, begin, balls) - true) < abs(true) * 1e-4


BOUNDS = [
    pytest.param(bound, proof, id=f"{claim.label}-{i}")
    for claim in CLAIMS
    if isinstance(claim.proof, Boxes) and claim.proof.stored is not None
    for i, (bound, proof) in enumerate(
        zip(claim.proof.bounds, claim.proof.stored() or (), strict=False)
    )
]


@pytest.mark.parametrize(("bound", "proof"), BOUNDS)
def test_a_bound_a_little_stronger_than_the_truth_is_never_enclosed(bound, proof):
    """The margin less a little more than its value somewhere is negative there.

    So it is for every bound that is enclosed: neither a search nor the stored tree may close it.
    """
    leaves = [leaf for leaf, _ in leaf_boxes(bound.box, proof)]
    sample = [leaves[n * len(leaves) // 40] for n in range(40)] if len(leaves) > 40 else leaves
    with ball_precision(bound.precision):
        points = [tuple(side.middle for side in leaf) for leaf in sample]
        values = [value_at(bound.margin, point) for point in points]
        least = min((v.upper() for v in values if v.is_finite()), key=float)
        taken = least + abs(least) * arb("1e-6")

    def falsified(*at):
        return bound.margin(*at) - taken

    false = replace(bound, margin=falsified)
    assert decide_bound(false, budget=150).verdict is not Verdict.ENCLOSED
    with pytest.raises(CertificateError):
        recheck(false, proof)


@pytest.mark.parametrize(("bound", "proof"), BOUNDS)
def test_a_tree_cut_short_or_grown_proves_nothing(bound, proof):
    """Even of a margin that is 1 everywhere."""
    for tree in (proof.tree[:-1], proof.tree + "b", ""):
        with pytest.raises(CertificateError):
            recheck(Bound(lambda *at: arb(1), bound.box), BoxProof(tree.replace("m", "b")))


def _wrong_exponent(order, power, constant):
    """|ε₀/ε* − …| ≤ C ε*^{2·order + 2 + power} where the right power is 2·order + 2."""

    def margin(b, kappa, m):
        star = charts.by_kappa(b, kappa, m).leading
        excess = stored_charts.EXCESSES[order](charts.root_by_kappa(b, kappa, m), m)
        return arb(constant) * star**power - excess

    return margin


@pytest.mark.parametrize("order", [0, 1])
@pytest.mark.parametrize("power", [1, 2])
@pytest.mark.parametrize("sides", [SIDES, (("9/10", 1), (0, "1/10")), ((0, 1), (0, 0))])
def test_a_wrong_exponent_at_the_flat_edge_is_refuted(order, power, sides):
    """At κ = 0 every power of ε* vanishes while the excess tends to c₁ or c₂."""
    found = decide_bound(Bound(_wrong_exponent(order, power, 1000), box(*sides)), budget=400)
    assert found.verdict is Verdict.REFUTED


@pytest.mark.parametrize("constant", ["2", "100", "1000000"])
@pytest.mark.parametrize("order", [0, 1])
def test_no_constant_serves_the_corner_where_a_vanishes(order, constant):
    """The chart (a, √b) up to a = 0: ε₀ tends to a positive limit at b = 1, and ε* to 0."""
    bounds = bounds_of((stored_charts.slab(order, fmpq(0), fmpq(1, 10), as_rational(constant)),))
    verdicts = {decide_bound(bound, budget=600).verdict for bound in bounds}
    assert verdicts != {Verdict.ENCLOSED}
    assert constant == "1000000" or Verdict.REFUTED in verdicts


@pytest.mark.parametrize(
    ("claim", "sides"),
    [
        ("printed_relative_error", ((0, 1), (0, "1/2"))),
        ("d56_true_order", ((0, 1), (0, 2))),
        ("u_exponentially_small", ((0, 1), (0, "5/2"))),
    ],
)
def test_a_range_beyond_the_stated_one_is_never_enclosed(claim, sides):
    proof = next(c for c in CLAIMS if c.label == claim).proof
    bounds = [replace(bound, box=box(*sides)) for bound in proof.bounds]
    verdicts = {decide_bound(bound, budget=300).verdict for bound in bounds}
    assert verdicts != {Verdict.ENCLOSED}
