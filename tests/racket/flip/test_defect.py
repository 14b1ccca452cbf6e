"""ε(γ) everywhere, its slopes, the levels at which it changes character, and the inverse."""

from fractions import Fraction
from itertools import pairwise, product

import pytest
from cases import cases
from differences import defect_slope
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

from tresym.racket.angle import parse_angle
from tresym.racket.body import named_body
from tresym.racket.comparison import routes
from tresym.racket.flip import defect, flip_defect, separatrix
from tresym.racket.flip.defect import corrected, defect_on, inverted, quick, solve, unfolded
from tresym.racket.flip.levels import level_of, turning_level
from tresym.racket.flip.phase_folding import Fold, folded
from tresym.racket.motion import quadrature
from tresym.racket.motion.jacobi import functions
from tresym.racket.motion.orbit import exact_level, orbit, slope, time_of
from tresym.racket.motion.orbit import phase_at as phase_of
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError, parse_number

STR = named_body("str").shape
RACKET = named_body("racket-1").shape
CASES = cases(__file__, "CASES")


def test_two_precisions_nest_and_the_digits_are_there() -> None:
    for gamma, body in product(CASES, ["str", "racket-1"]):
        shape, level = named_body(body).shape, parse_number(gamma)
        if level > shape.a:
            pytest.skip("beyond a")
        few, many = solve(*shape, level, 30), inverted(*shape, level, 60)
        with ball_precision(bits(80)):
            for rough, fine in zip(few, many, strict=True):
                assert rough.overlaps(fine)
                assert rough.rel_accuracy_bits() >= bits(30, 0)
                assert fine.rel_accuracy_bits() >= bits(60, 0)


@pytest.mark.slow
@pytest.mark.parametrize(("body", "gamma"), routes.CASES)
def test_rigorous_integration_and_quadrature_agree_to_fifty_digits(body, gamma):
    shape, level = named_body(body).shape, parse_number(gamma)
    truth = routes.carlson(shape, level)
    integrated = routes.flint_integration(shape, level)
    assert integrated.overlaps(truth)
    assert routes.agreement(integrated, truth) == 50
    assert routes.agreement(routes.mpmath_quadrature(shape, level), truth) == 50
    assert routes.agreement(routes.float_map(shape, level), truth) >= 12
    assert routes.agreement(routes.scipy_solver(shape, level), truth) >= 10


@pytest.mark.night
def test_the_table_of_routes():
    for row in routes.compare():
        for route, digits in zip(routes.ROUTES[1:], row.digits, strict=True):
            assert digits == route.digits, (row, route.name)


def test_a_wrong_value_agrees_on_few_digits():
    truth = routes.carlson(STR, fmpq(0))
    with ball_precision(200):
        assert routes.agreement(truth * (1 + arb("1e-20")), truth) in (19, 20)
    assert routes.agreement(0.0, truth) == 0


def test_where_several_turns_are_made_the_phase_is_still_a_half_turn():
    level = fmpq(12)
    found = solve(*STR, level, 30).defect
    assert found < -38
    with ball_precision(160):
        phi = quadrature.rigorous(found, arb(STR.a), arb(STR.b), arb(level))
        assert phi.overlaps(arb.pi())


def test_at_both_ends_of_the_range():
    assert solve(*STR, -STR.b, 20).flip.is_zero()
    top = solve(*STR, STR.a, 20).defect
    with ball_precision(200):
        # γ = a: dψ/dφ = (a + b sin²ψ)/(1 − b sin²ψ), elementary: F = −ψ' part below.
        phi = quadrature.rigorous(top, arb(STR.a), arb(STR.b), arb(STR.a))
        assert phi.overlaps(arb.pi())
    for gamma in ("-0.07", "12.6"):
        with pytest.raises(InputError, match="between -b and a"):
            flip_defect(*STR, gamma)


@pytest.mark.parametrize("gamma", ["1e-300", "-1e-300"])
def test_next_to_the_separatrix_it_is_continuous(gamma):
    near = flip_defect(*STR, gamma, digits=50).defect
    assert near.overlaps(flip_defect(*STR, digits=50).defect)
    apart = flip_defect(*STR, gamma, digits=330).defect
    with ball_precision(1300):
        step = (apart - flip_defect(*STR, digits=330).defect) / arb(parse_number(gamma))
        assert abs(step / defect_slope(*STR) - 1) < 1e-15


def test_a_thousand_digits():
    for gamma in ("1e-3", "-1/50", "1"):
        answer = flip_defect(*STR, gamma, digits=1000)
        assert answer.defect.rel_accuracy_bits() >= bits(1000, 0)
        assert answer.defect.overlaps(flip_defect(*STR, gamma, digits=60).defect)


def test_extreme_shapes() -> None:
    for shape, part in product(
        [
            ("1e-9", "1"),
            ("1e-9", "1e-12"),
            ("1e6", "1"),
            ("1e6", "1e-12"),
            ("3", "1"),
            ("100", "1/102"),
        ],
        ["1e-300", "0.5", "-0.5", "-1e-300", "-0.999999"],
    ):
        a, b = map(parse_number, shape)
        factor = parse_number(part)
        gamma = factor * (a if factor > 0 else b)
        found = inverted(a, b, gamma, 25)
        assert found.defect.rel_accuracy_bits() >= bits(25, 0)
        fast = quick(a, b, gamma, 25)
        if fast is not None:
            assert fast.defect.overlaps(found.defect)


positive = st.fractions("1/100", 40)
parts = st.fractions("-999/1000", "999/1000")


@pytest.mark.slow
@given(positive, st.fractions("1/100", 1), parts)
@example(Fraction(2), Fraction(1), Fraction(-1, 2))
def test_the_quick_route_never_disagrees_with_the_other(a, b, part):
    p, q, x = (fmpq(*v.as_integer_ratio()) for v in (a, b, part))
    gamma = x * (p if x > 0 else q)
    fast = quick(p, q, gamma, 20)
    with ball_precision(160):
        slow = defect_on(p, q, exact_level(p, q, gamma))
        assert fast is None or fast.defect.overlaps(slow)


def test_the_quick_route_folds_every_orbit_into_its_first_quarter() -> None:
    for shape, part, digits in product(
        [STR, RACKET, (fmpq(3), fmpq(1)), (fmpq(100), fmpq(1, 102))],
        ["0.9", "0.1", "1e-3", "1e-20", "-1e-20", "-0.1", "-0.9", "-0.99"],
        [5, 50, 400],
    ):
        a, b = shape
        factor = parse_number(part)
        gamma = factor * (a if factor > 0 else b)
        fast, slow = quick(a, b, gamma, digits), inverted(a, b, gamma, digits)
        assert fast is not None
        with ball_precision(bits(digits, 64)):
            for ours, other in zip(fast, slow, strict=True):
                assert ours.overlaps(other)
                assert proves(ours, digits)


@pytest.mark.slow
@given(
    st.fractions("1/100", 100),
    st.fractions("1/100", 1),
    parts,
    st.integers(0, 12),
    st.booleans(),
    st.integers(0, 40),
)
def test_no_fold_and_no_start_gives_a_wrong_answer(a, b, part, halves, back, shift):
    """Any number of half periods and a start off by 2^−shift: the ball is right, or there is none.

    The branch rests on float64, the answer does not.
    """
    p, q, x = (fmpq(*v.as_integer_ratio()) for v in (a, b, part))
    gamma = x * (p if x > 0 else q)
    found = folded(*(float(arb(v)) for v in (p, q, gamma)))
    if found is None or not gamma:
        return
    level = exact_level(p, q, gamma)
    for fold, precision in ((found[0], 80), (Fold(gamma > 0, halves, back), 80)):
        with ball_precision(precision):
            start = arb(found[1]) * (1 + arb((1, -shift)))
            try:
                angle = corrected(arb(p), arb(q), arb(gamma), start.mid(), fold)
            except ArithmeticError:
                continue
            answer = unfolded(angle, fold)
        with ball_precision(160):
            assert answer.defect.overlaps(defect_on(p, q, level))


def test_planted_errors_in_the_quick_route_are_seen(monkeypatch):
    """The phase of the quarter off by 1e-40; the third order of the flow left out; one sign."""
    level = fmpq(1)
    truth = inverted(*STR, level, 50).defect
    right = solve(*STR, level, 50).defect
    assert right.overlaps(truth)
    fold, start = folded(*(float(arb(x)) for x in (*STR, level)))
    assert not unfolded(arb(start), fold._replace(back=False)).defect.overlaps(truth)
    whole, flow = defect.quarter_phase, defect.flow
    with monkeypatch.context() as planted:
        planted.setattr(defect, "quarter_phase", lambda *x: whole(*x) + arb("1e-40"))
        assert not solve(*STR, level, 50).defect.overlaps(truth)
    with ball_precision(200):
        near = (arb(start) + arb("1e-6")).mid()
        exact = corrected(arb(STR.a), arb(STR.b), arb(level), near, fold)
        assert unfolded(exact, fold).defect.overlaps(truth)
        monkeypatch.setattr(defect, "flow", lambda *x: (flow(*x)[0], arb(0)))
        wrong = corrected(arb(STR.a), arb(STR.b), arb(level), near, fold)
        assert not unfolded(wrong, fold).defect.overlaps(truth)


def test_the_phase_increases_and_inverts():
    for gamma in (fmpq(1, 100), fmpq(-1, 100), fmpq(0)):
        with ball_precision(200):
            on = orbit(*STR, exact_level(*STR, gamma))
            for phi in ("0.1", "1.5", "-2.9"):
                place = time_of(on, arb(phi))
                whole = 2 * place.halves * on.quarter_phase if place.halves else 0
                assert (phase_of(on, place.time) + whole).overlaps(arb(phi))
                assert slope(on, functions(on.elliptic, place.time)) > 0


def test_beyond_the_far_end_the_phase_goes_on_by_reflection():
    with ball_precision(200):
        on = orbit(*STR, exact_level(*STR, fmpq(1, 100)))
        d = arb("0.01")
        before, after = (phase_of(on, on.quarter_time + s * d) for s in (-1, 1))
        assert (before + after).overlaps(2 * on.quarter_phase)
        assert after > on.quarter_phase > before


def test_the_slope_on_the_separatrix_is_the_paper_s_integral():
    from tresym.racket.formulas import stable
    from tresym.reals.numbers.arithmetic import balls

    with ball_precision(200):
        a, b = arb(STR.a), arb(STR.b)
        exact = separatrix.solve(STR.a, STR.b, 60).defect
        sine = exact.sin()
        inverse = b.sqrt() * sine * (a + b * sine * sine).sqrt() / (1 - b * sine * sine)
        slope = stable.turn_slope(exact, a, b, balls) * inverse
        assert abs(defect_slope(*STR) / slope - 1) < 1e-50


def test_the_turning_level():
    level = turning_level(*STR, 40)
    assert level is not None
    assert level.overlaps(arb("-0.00347861294195168831987", "1e-22"))
    with ball_precision(200):
        for side, turned in ((1, False), (-1, True)):
            gamma = fmpq(int((level.mid() * 10**30).floor().unique_fmpz()), 10**30)
            gamma += side * fmpq(1, 10**20)
            on = orbit(*STR, exact_level(*STR, gamma))
            assert (on.quarter_phase < arb.pi()) is turned
    assert turning_level(*STR, 20, 3) is None
    below = turning_level(*RACKET, 20, 3)
    assert below is not None
    assert below < turning_level(*RACKET, 20)
    assert turning_level(fmpq(1, 100), fmpq(1, 100), 20) is None


@pytest.mark.parametrize("shape", [STR, RACKET])
@pytest.mark.parametrize("value", ["pi/12", "-pi/12", "0", "1.3", "-10"])
def test_the_inverse(shape, value):
    gamma = level_of(*shape, parse_angle(value), 30)
    assert gamma.rel_accuracy_bits() >= bits(30, 0)
    with ball_precision(160):
        unit = fmpq(1, 10**25)
        here = fmpq(int((gamma.mid() * 10**25).floor().unique_fmpz()), 10**25)
        target = parse_angle(value).ball()
        below = defect_on(*shape, exact_level(*shape, here - unit))
        above = defect_on(*shape, exact_level(*shape, here + 2 * unit))
        assert above < target < below


@pytest.mark.parametrize("a", [fmpq(1, 1000), fmpq(1000)])
def test_the_inverse_passes_over_levels_of_many_turns(a):
    """Below γ** the same value is taken again: the level looked for is above."""
    b, target = fmpq(1), parse_angle("pi/12")
    gamma, lowest = level_of(a, b, target, 30), turning_level(a, b, 20, 3)
    assert lowest is not None
    assert gamma > lowest
    man, exp = gamma.mid().man_exp()
    here = fmpq(man) * fmpq(2) ** int(exp)
    with ball_precision(600):
        values = [
            defect_on(a, b, exact_level(a, b, here * (1 + k * fmpq(1, 10**25)))) for k in (1, -1)
        ]
        assert values[0] > target.ball() > values[1]


def test_values_that_are_not_taken():
    for value, limit in (("3", "less than"), ("-1000", "more than")):
        with pytest.raises(InputError, match=limit):
            level_of(*STR, parse_angle(value), 20)


def test_below_the_last_turning_level_the_same_value_comes_again():
    """ε(γ) is not monotone down there: a long body comes back to π/2 again."""
    a, b = fmpq(1000), fmpq(1, 2)
    with ball_precision(128):
        values = [
            defect_on(a, b, exact_level(a, b, fmpq(-k, 100))) - arb.pi() / 2 for k in range(1, 50)
        ]
    signs = [bool(x > 0) for x in values]
    assert sum(x != y for x, y in pairwise(signs)) >= 3


def test_the_chooser_names_the_model_and_says_when_one_cannot():
    assert flip_defect(*STR, "1e-3").model == "carlson"
    assert flip_defect(*STR, "1/100").model == "carlson"
    assert flip_defect(*STR, "-1/100").model == "carlson"
    assert flip_defect(*STR, STR.a).model == "planar"
    assert flip_defect(*STR, -STR.b).model == "planar"
    assert flip_defect(*STR, 0, digits=3).model == "asymptotic"
    for model in ("separatrix", "carlson", "planar"):
        answer = flip_defect(*STR, 0, digits=40, model=model)
        assert answer.model == model
        assert answer.defect.overlaps(flip_defect(*STR, digits=60).defect)
    for gamma, model, says in (
        ("1", "separatrix", "gamma = 0, only"),
        ("1", "asymptotic", "gamma = 0, only"),
        (STR.a, "carlson", "an end of the range of gamma; try planar"),
        (-STR.b, "carlson", "try planar"),
        ("1", "attitude", "is not known"),
    ):
        with pytest.raises(InputError, match=says):
            flip_defect(*STR, gamma, model=model)
