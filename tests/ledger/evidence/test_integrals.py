"""The rules for integrals in chains: what each proves, and the falsehoods planted for it."""

import pytest
from derivations import by, derived, step
from flint import arb
from sympy import (
    Abs,
    Basic,
    Derivative,
    Expr,
    Ge,
    Gt,
    Integer,
    Integral,
    Ne,
    Rational,
    Subs,
    Symbol,
    cos,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
)
from sympy_statements import ExactlyOne, equal

from tresym.ledger.ball_evaluation import value
from tresym.ledger.claim import (
    Chain,
    Claim,
    Definition,
    ImplicitFunction,
    Reason,
)
from tresym.ledger.conversion import known
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.integrals import (
    NotShownError,
    need_value,
    under_binder,
    without_integrals,
)
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.formulas import in_trees
from tresym.ledger.judge import judge
from tresym.ledger.reasons import (
    changing_variable,
    citing,
    collecting,
    cutting,
    differentiating_integral,
    differentiation,
    exponentials,
    integrating,
    roots,
    substituting,
)
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import generalised
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

a, r, t, x, y = (Symbol(name, real=True) for name in "artxy")
ZERO, ONE = Integer(0), Integer(1)


def area(f: Expr, low: Expr | int = 0, high: Expr | int = 1) -> Integral:
    return Integral(f, (t, low, high))


def by_parameter(f: Expr, low: Expr | int = 0, high: Expr | int = 1) -> Derivative:
    return Derivative(area(f, low, high), x)


def at_zero(f: Expr, low: Expr | int = 0, high: Expr | int = 1) -> Subs:
    return Subs(by_parameter(f, low, high), x, 0)


def verdict(says: Basic, proof: Chain, given: tuple[Basic, ...] = ()) -> Verdict:
    return judge(Claim("planted", says, proof, given=given), {}).verdict


RIGHT = {
    "cut": (equal(area(exp(t), 0, 2), area(exp(t)) + area(exp(t), 1, 2)), cutting(ONE)),
    "parameter": (
        equal(by_parameter(exp(x * t)), area(t * exp(x * t))),
        differentiating_integral(t * exp(x * t)),
    ),
    "upper end": (equal(by_parameter(exp(t), 0, x), exp(x)), differentiating_integral(ZERO)),
    "lower end": (equal(by_parameter(exp(t), x, 0), -exp(x)), differentiating_integral(ZERO)),
    "both": (
        equal(by_parameter(exp(t * x), 0, x), exp(x**2) + area(t * exp(t * x), 0, x)),
        differentiating_integral(t * exp(t * x)),
    ),
    "at a point": (
        equal(at_zero(1 / (1 + x + t), x, 1), area(-1 / (1 + t) ** 2) - 1),
        differentiating_integral(-1 / (1 + t) ** 2),
    ),
    "sum": (
        equal(2 * area(exp(t)) - area(t), Integral(2 * exp(y) - y, (y, 0, 1))),
        collecting(),
    ),
    "backwards": (
        equal(area(exp(t)), Integral(exp(1 - y), (y, 0, 1))),
        changing_variable(1 - t),
    ),
}


@pytest.mark.parametrize("name", RIGHT)
def test_what_a_rule_proves_it_proves_alone(name: str) -> None:
    says, reason = RIGHT[name]
    assert verdict(says, by(reason)) is Verdict.PROVED


WRONG: dict[str, tuple[Basic, Reason]] = {
    "cut elsewhere": (equal(area(exp(t), 0, 2), area(exp(t)) + area(exp(t), 1, 3)), cutting(ONE)),
    "cut outside": (
        equal(area(1 / (t - 2)), area(1 / (t - 2), 0, 3) + area(1 / (t - 2), 3, 1)),
        cutting(Integer(3)),
    ),
    "cut at a pole": (
        equal(area(1 / t**2, -1, 1), area(1 / t**2, -1, 0) + area(1 / t**2)),
        cutting(ZERO),
    ),
    "cut at its own variable": (
        equal(area(exp(t)), area(exp(t), 0, t) + area(exp(t), t, 1)),
        cutting(t),
    ),
    "wrong slope": (
        equal(by_parameter(exp(x * t)), area(exp(x * t))),
        differentiating_integral(exp(x * t)),
    ),
    "sign of the lower end": (
        equal(by_parameter(exp(t), x, 0), exp(x)),
        differentiating_integral(ZERO),
    ),
    "forgotten end": (
        equal(by_parameter(exp(t * x), 0, x), area(t * exp(t * x), 0, x)),
        differentiating_integral(t * exp(t * x)),
    ),
    "end that depends on it": (
        equal(by_parameter(exp(t), 0, x**2), exp(x**2)),
        differentiating_integral(ZERO),
    ),
    "kink in the parameter": (
        equal(at_zero(Abs(x) * t), ZERO),
        differentiating_integral(ZERO),
    ),
    "kink that moves": (equal(at_zero(Abs(x - t)), -ONE), differentiating_integral(-ONE)),
    "jump": (equal(by_parameter(sign(t), -1, x), sign(x)), differentiating_integral(ZERO)),
    "root at its end": (
        equal(at_zero(sqrt(t**2 + x**2)), ZERO),
        differentiating_integral(ZERO),
    ),
    "pole for one value": (
        equal(at_zero(x / (x**2 + t**2)), ZERO),
        differentiating_integral(1 / t**2),
    ),
    "the point forgotten": (
        equal(at_zero(exp(x * t)), area(t * exp(x * t))),
        differentiating_integral(t * exp(x * t)),
    ),
    "sum of another sign": (
        equal(2 * area(exp(t)) - area(t), area(2 * exp(t) + t)),
        collecting(),
    ),
    "product": (equal(area(exp(t)) * area(t), area(t * exp(t))), collecting()),
    "square": (equal(area(t) ** 2, area(t**2)), collecting()),
    "two intervals": (
        equal(area(exp(t)) + area(exp(t), 1, 2), area(2 * exp(t))),
        collecting(),
    ),
    "factor that varies": (equal(t * area(exp(t)), area(t * exp(t))), collecting()),
    "constant left": (equal(1 + area(exp(t)), area(exp(t))), collecting()),
    "backwards with the sign": (
        equal(area(exp(t)), Integral(-exp(1 - y), (y, 0, 1))),
        changing_variable(1 - t),
    ),
    "half of the interval": (
        equal(area(t**2, -1, 1), Integral(sqrt(y) / 2, (y, 1, 1))),
        changing_variable(t**2),
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_planted_falsehoods(name: str) -> None:
    says, reason = WRONG[name]
    assert not verdict(says, by(reason)).holds
    assert not verdict(says, by(reason), (x > 0,)).holds


def test_conditions_on_the_parameter_do_not_reach_the_point() -> None:
    """At x = −2 the integrand has a pole, whatever a claim assumes of its own x."""
    says = equal(Subs(by_parameter(log(x + 1 + t)), x, -2), 0)
    assert not verdict(says, by(differentiating_integral(1 / (x + 1 + t))), (x > 1,)).holds


def shown(integral: Integral, *given: Basic, strictly: bool = False) -> Verdict:
    """The verdict on a sign of an integral that is read off its integrand."""
    relation = Gt if strictly else Ge
    return verdict(relation(integral, 0, evaluate=False), derived(step(integral)), given)


def test_an_integral_is_not_negative_where_its_integrand_is_not() -> None:
    assert shown(area(t**2)) is Verdict.PROVED
    assert shown(area(exp(t) - 1)) is Verdict.PROVED
    assert shown(area(t**2, 1, 0)) is Verdict.REFUTED
    assert shown(area(t**2, 0, x)) is not Verdict.PROVED
    assert shown(area(1 / t, -1, 2), t > 0) is not Verdict.PROVED
    assert shown(area(t, -2, 1), t > 0) is Verdict.REFUTED


POSITIVE = {
    "at its upper end": (area(t**2), ()),
    "at its lower end": (area((1 - t) ** 2), ()),
    "at an end that varies": (area(t**2, 0, x), (x > 0,)),
    "all over": (area(exp(t), x, x + 1), ()),
}


@pytest.mark.parametrize("name", POSITIVE)
def test_an_integral_is_positive_where_its_integrand_is_next_to_an_end(name: str) -> None:
    integral, given = POSITIVE[name]
    assert shown(integral, *given, strictly=True) is Verdict.PROVED


NOT_POSITIVE = {
    "no length": (area(t**2, 1, 1), ()),
    "perhaps no length": (area(exp(t), 0, x), (x >= 0,)),
    "backwards": (area(exp(t), 1, 0), ()),
    "negative inside": (area(1 - 4 * t * (2 - t)), ()),
    "positive at its end, and nowhere else": (area(1 - sign(t) ** 2), ()),
    "not at its end, but where it is assumed": (area(t * x), (t > 0, x >= 0)),
    "a derivative with a jump": (area(1 - Derivative(Abs(t), t) ** 2), ()),
    "nothing": (area(0 * t), ()),
    "zero at both ends, and perhaps between": (area(x**2 * t * (1 - t)), ()),
}


@pytest.mark.parametrize("name", NOT_POSITIVE)
def test_planted_positive_integrals(name: str) -> None:
    integral, given = NOT_POSITIVE[name]
    assert not shown(integral, *given, strictly=True).holds


def test_integrals_have_their_signs_in_products_and_quotients() -> None:
    def sign(e: Expr, strictly: bool, *given: Basic) -> Verdict:
        return verdict((Gt if strictly else Ge)(e, 0, evaluate=False), derived(step(e)), given)

    assert sign(x * area(t**2), True, x > 0) is Verdict.PROVED
    assert sign(x * area(t**2) - r * area(exp(t)), True, x > 0, r <= 0) is Verdict.PROVED
    assert sign(area(t**2) * area(exp(t)) / x, True, x > 0) is Verdict.PROVED
    perhaps_zero = area(x**2 * t * (1 - t))
    assert sign(r * perhaps_zero, False, r > 0) is Verdict.PROVED
    assert not sign(r * perhaps_zero, True, r > 0).holds
    assert not sign(r / perhaps_zero, False, r > 0).holds
    assert not sign(x * area(1 - 4 * t * (2 - t)), False, x > 0).holds
    assert not sign(x * area(t**2, 1, 0), False, x > 0).holds
    assert not sign(area(t**2) - area(t), False).holds


def test_each_rule_finds_its_own_of_several_derivatives() -> None:
    curved, moved = by_parameter(exp(x * t)), Derivative(area(exp(t), 0, x), x)
    rules = differentiating_integral(t * exp(x * t)), differentiating_integral(ZERO)
    product = area(t * exp(x * t)) * exp(x)
    for reasons in (rules, rules[::-1]):
        assert verdict(equal(curved * moved, product), by(*reasons)) is Verdict.PROVED
        assert not verdict(equal(curved * moved, 2 * product), by(*reasons)).holds


NAMES = {
    "the variable in its own end": (
        equal(area(t, 0, t), t**2 / 2),
        equal(area(t, 0, t), t**2),
        integrating(t**2 / 2),
    ),
    "a factor of the name of the variable": (
        equal(t * area(t), t / 2),
        equal(t * area(t), t**2 / 2),
        integrating(t**2 / 2),
    ),
    "a parameter of the name of the variable": (
        equal(t * by_parameter(exp(x * t)), t * area(t * exp(x * t))),
        equal(t * by_parameter(exp(x * t)), area(t**2 * exp(x * t))),
        differentiating_integral(t * exp(x * t)),
    ),
    "what is known of a symbol of that name": (
        equal(area(Abs(t), -2, -1), Rational(3, 2)),
        equal(area(Abs(t), -2, -1), -Rational(3, 2)),
        integrating(-(t**2) / 2),
    ),
}


@pytest.mark.parametrize(("right", "wrong", "reason"), NAMES.values(), ids=NAMES)
def test_what_is_bound_is_no_symbol_of_that_name(
    right: Basic, wrong: Basic, reason: Reason
) -> None:
    proof = by(reason, roots)
    assert verdict(right, proof, (t > 0,)) is Verdict.PROVED
    assert verdict(wrong, proof, (t > 0,)) is not Verdict.PROVED
    other = by(integrating(t**2 / 2), roots)
    assert verdict(wrong, other, (t > 0,)) is not Verdict.PROVED


def test_bounds_are_cited_inside_only_where_they_hold() -> None:
    lemma = Claim("lemma", t > 0, derived(step(t)), given=(t > 0,))
    held = {"lemma": judge(lemma, {})}
    integral = area(t, -2, 1)
    says = Ge(integral, 0, evaluate=False)
    user = Claim("user", says, by(citing(lemma)), given=(t > 0,))
    assert not judge(user, held).verdict.holds


THREE = Definition("an area of three")
EQUATION = Claim("equation", equal(area(exp(x * t), 0, y), 3), THREE, given=(x > -1, y > 0))
LEFT = area(exp(x * t), 0, y)
SLOPE = -Subs(Derivative(LEFT, x), x, ZERO) / Derivative(LEFT.xreplace({x: ZERO}), y)


def implicit(says: Basic, given: tuple[Basic, ...] = (y > 0,), **changes: object) -> Finding:
    evidence = {
        "equation": EQUATION,
        "unknown": y,
        "parameter": x,
        "at": ZERO,
    }
    proof = ImplicitFunction(**{**evidence, **changes})
    used = {c.label: judge(c, {}) for c in (proof.equation,)}
    return judge(Claim("slope", says, proof, given=given), used)


def test_the_slope_of_an_implicit_function() -> None:
    assert implicit(equal(r, SLOPE)).verdict is Verdict.PROVED


AT_ZERO = Subs(Derivative(LEFT, x), x, ZERO)


def test_the_slope_may_be_written_with_an_equal_integrand() -> None:
    same = -AT_ZERO / Derivative(area(2 - Abs(1 + t**2) / (1 + t**2), 0, y), y)
    assert implicit(equal(r, same)).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    "says",
    [
        equal(r, -SLOPE),
        equal(r, 1 / SLOPE),
        equal(y, SLOPE),
        equal(r, 1),
        r >= SLOPE,
        equal(r, -AT_ZERO / Derivative(area(1 + t, 0, y), y)),
        equal(r, -AT_ZERO / Derivative(area(ONE, 0, 2 * y), y)),
        equal(r, -AT_ZERO / Derivative(area(ONE, 0, t), t)),
        equal(r, -AT_ZERO / Subs(Derivative(area(ONE, 0, y), y), y, 1)),
        equal(r, -AT_ZERO / area(ONE, 0, y)),
    ],
)
def test_any_other_slope_is_none(says: Basic) -> None:
    assert not implicit(says).verdict.holds


def test_the_implicit_function_theorem_needs_its_conditions() -> None:
    says = equal(r, SLOPE)
    assert implicit(says, given=()).verdict is Verdict.UNDECIDED
    far = equal(r, -Subs(Derivative(LEFT, x), x, -3) / Derivative(LEFT.xreplace({x: -3}), y))
    assert implicit(far, at=Integer(-3)).verdict is Verdict.UNDECIDED
    # y − |x| has a kink at 0, and y³ − x no slope there.
    for left in (y - Abs(x), y**3 - x):
        equation = Claim("equation", equal(left, 0), by(), given=(y >= 0,))
        held = {"equation": Finding(Verdict.PROVED, "assumed")}
        says = equal(r, -Subs(Derivative(left, x), x, 0) / Derivative(left.xreplace({x: ZERO}), y))
        proof = ImplicitFunction(equation, y, x, ZERO)
        user = Claim("slope", says, proof, given=(y >= 0,))
        assert judge(user, held).verdict is Verdict.UNDECIDED


def test_the_sign_of_a_slope_is_shown_and_never_refuted_at_another_value_of_it() -> None:
    proof = implicit(equal(r, SLOPE)).of.proof
    slope = Claim("slope", equal(r, SLOPE), proof, given=(y > 0,))
    held = {"slope": judge(slope, {"equation": judge(EQUATION, {})})}

    def found(says: Basic, *reasons: Reason) -> Verdict:
        chain = derived(step(area(t, 0, y), substituting(slope), *reasons))
        return judge(Claim("user", says, chain, given=(y > 0,)), held).verdict

    rules = differentiating_integral(t), differentiating_integral(ZERO), exponentials
    assert found(r < 0) is Verdict.UNDECIDED  # r is no variable, though no definition says it
    assert not found(r > 0, *rules).holds


def test_an_equation_without_solutions_defines_no_function() -> None:
    none = Claim("equation", equal(LEFT, -1), THREE, given=(x > -1, y > 0))
    held = {"equation": Finding(Verdict.PROVED, "assumed")}
    proof = ImplicitFunction(none, y, x, ZERO)
    user = Claim("slope", equal(r, SLOPE), proof, given=(y > 0,))
    assert judge(user, held).verdict is Verdict.UNDECIDED


def test_slopes_and_integrals_work_together() -> None:
    says = equal(at_zero(exp(x * t)), Rational(1, 2))
    chain = derived(step(area(t), differentiating_integral(t)), step(None, integrating(t**2 / 2)))
    assert verdict(says, chain) is Verdict.PROVED
    assert verdict(equal(at_zero(exp(x * t)), Rational(1, 3)), chain) is Verdict.REFUTED


def test_a_condition_that_holds_an_integral_is_met_or_not() -> None:
    defined = Claim("defined", equal(r, Derivative(area(exp(t), 0, x), x)), Definition())
    held = {"defined": judge(defined, {})}
    says = equal(1 / r, exp(-x))
    chain = by(substituting(defined), differentiating_integral(ZERO))
    user = Claim("user", says, chain, given=(Ne(r, 0),))
    assert judge(user, held).verdict in (Verdict.PROVED, Verdict.UNDECIDED)
    false = Claim("user", equal(1 / r, exp(x)), chain, given=(Ne(r, 0),))
    assert not judge(false, held).verdict.holds


def test_balls_differentiate_integrals_by_leibniz_alone() -> None:
    """SymPy's own integrals are never asked for: some of them are wrong."""
    found = value(in_trees(by_parameter(exp(x * t) * cos(t), 0, x)), {"x": arb(1)})
    inside = value(in_trees(area(t * exp(x * t) * cos(t), 0, x)), {"x": arb(1)})
    assert found.overlaps(inside + arb(1).exp() * arb(1).cos())
    assert not value(in_trees(Subs(by_parameter(1 / (t + x), -1, 1), x, 0)), {}).is_finite()
    assert value(in_trees(Subs(sin(x), x, pi)), {}).contains(0)


def test_what_holds_of_one_integral_holds_of_no_other() -> None:
    lemma = Claim(
        "lemma",
        equal(area(Abs(x) * t), x / 2),
        by(integrating(Abs(x) * t**2 / 2), roots),
        given=(x > 0,),
    )
    level = Claim("level", equal(area(exp(x * t)), 3), THREE, given=(x > 0,))
    held = {c.label: judge(c, {}) for c in (lemma, level)}
    assert [f.verdict for f in held.values()] == [Verdict.PROVED, Premise.ASSUMED]
    for says, used in (
        (equal(Subs(area(Abs(x) * t), x, -1), Rational(-1, 2)), lemma),
        (equal(Derivative(area(exp(x * t)), x), 0), level),
        (equal(Subs(area(exp(x * t)), x, 0), 3), level),
        (equal(area(exp(y * t)), 3), level),
    ):
        user = Claim("user", says, by(substituting(used), differentiation), given=(x > 0, y > 0))
        assert not judge(user, held).verdict.holds


def test_a_variable_that_is_free_outside_is_not_bound_inside() -> None:
    """∫₀¹ x dx is 1/2: a new variable, or the sum of several, must not catch a free symbol."""
    change = by(changing_variable(2 * t))
    assert not verdict(equal(area(2 * t), Integral(t, (y, 0, 2))), change).holds
    assert not verdict(equal(area(2 * y), Integral(y, (y, 0, 2))), change).holds
    same = equal(area(t), Integral(t, (x, 0, 1)))
    assert not verdict(same, by(changing_variable(t))).holds
    for says in (
        equal(area(x) + area(t), Integral(2 * x, (x, 0, 1))),
        equal(Integral(2 * x, (x, 0, 1)), area(x) + area(t)),
        equal(2 * area(x), Integral(2 * x, (x, 0, 1))),
        equal(x * area(exp(t)), Integral(x * exp(x), (x, 0, 1))),
    ):
        assert not verdict(says, by(collecting())).holds
    renamed = equal(y * area(exp(t)) + area(y), Integral(y * exp(x) + y, (x, 0, 1)))
    assert verdict(renamed, by(collecting())) is Verdict.PROVED


def defined_bound() -> tuple[Claim, Claim, dict[str, Finding]]:
    half = Claim("half", equal(t, Rational(1, 2)), Definition())
    proof = derived(step(Rational(5, 2), substituting(half)))
    bound = Claim("bound", Gt(3 - t, 0, evaluate=False), proof)
    held = {"half": judge(half, {})}
    held["bound"] = judge(bound, held)
    assert held["bound"].verdict is Verdict.PROVED
    return half, bound, held


def test_a_bound_on_a_defined_symbol_says_nothing_of_a_bound_variable() -> None:
    _, bound, held = defined_bound()
    square, across = area(1 / (3 - t) ** 2, 0, 10), area(3 - t, 0, 10)
    for says, proof in (
        (equal(square, Rational(-10, 21)), by(integrating(1 / (3 - t), bound))),
        (Gt(across, 0, evaluate=False), derived(step(across, citing(bound)))),
        (
            equal(square, area(1 / (3 - t) ** 2) + area(1 / (3 - t) ** 2, 1, 10)),
            by(cutting(ONE, bound)),
        ),
        (
            equal(
                Subs(Derivative(Integral(log(3 - t) * x, (x, 0, 1)), t), t, 5),
                Integral(x / 2, (x, 0, 1)),
            ),
            by(differentiating_integral(x / 2, bound)),
        ),
    ):
        assert not judge(Claim("user", says, proof), held).verdict.holds


def test_no_root_is_looked_for_where_a_symbol_is_defined() -> None:
    half, _, held = defined_bound()
    says = ExactlyOne(t, Rational(-1, 2), Rational(1, 2), equal(t**3, t))
    assert not judge(Claim("root", says, Decided((half,))), held).verdict.holds


def test_sums_of_another_length_are_not_alike() -> None:
    one, other = (in_trees(e) for e in (area(exp(t**2)) + x, area(exp(t**2)) + x + y))
    assert under_binder(one, one, ())
    assert not under_binder(one, other, ())


def test_what_stands_on_both_sides_is_left_alone() -> None:
    kept = Integral(exp(t**2), (t, 0, x))
    says = equal(area(t) + kept, kept + Rational(1, 2))
    assert judge(Claim("both", says, by(integrating(t**2 / 2))), {}).verdict is Verdict.PROVED
    back = equal(kept + Rational(1, 2), kept + area(t))
    assert judge(Claim("back", back, by(integrating(t**2 / 2))), {}).verdict is Verdict.PROVED


def test_rules_are_not_applied_where_another_node_binds_a_symbol() -> None:
    """For y > 0 the integrand is continuous on [y, 2]; at y = −1 it is not."""
    whole, parts = area(1 / t**2, y, 2), area(1 / t**2, y, 1) + area(1 / t**2, 1, 2)
    says = equal(Subs(whole, y, -1), Subs(parts, y, -1))
    assert not verdict(says, by(cutting(ONE)), (y > 0, y < 1)).holds
    says = equal(Subs(whole, y, -1), Subs(1 / y - Rational(1, 2), y, -1))
    assert not verdict(says, by(integrating(-1 / t)), (y > 0, y < 1)).holds


# -- each rule alone: nothing behind it finds what it lets through --------------------------------

ALONE = {
    "ends of which the first is another": (
        area(t),
        Integral(1 - y, (y, 0, 5)),
        changing_variable(1 - t),
        "the ends",
    ),
    "ends of which the last is another": (
        area(4 * t),
        Integral(y, (y, 0, 5)),
        changing_variable(2 * t),
        "the ends",
    ),
    "another integrand": (
        area(5 * t),
        Integral(y, (y, 0, 2)),
        changing_variable(2 * t),
        "integrands correspond",
    ),
    "two intervals": (
        area(t + t**2, 0, 2),
        area(t) + area(t**2, 0, 2),
        collecting(),
        "same interval",
    ),
    "a square of an integral": (
        area(t),
        area(t) ** 2 + area(0 * t + 1),
        collecting(),
        "linear combination",
    ),
    "two integrals": (area(t) * area(t**2), ONE, integrating(t**2 / 2), "exactly one"),
    "a point that is outside": (
        area(t),
        area(t, 0, 2) + area(t, 2, 1),
        cutting(ONE * 2),
        "lies in",
    ),
    "a parameter that is in the point": (
        Subs(Derivative(area(x * y * t), y), y, x),
        x,
        differentiating_integral(2 * x * t),
        "could not show .* = ",
    ),
    "a parameter that hides": (
        by_parameter(Integral(x * y * t, (y, 0, 1))),
        ZERO,
        differentiating_integral(ZERO),
        "must not contain integrals",
    ),
}


@pytest.mark.parametrize(("before", "after", "reason", "why"), ALONE.values(), ids=ALONE)
def test_a_rule_refuses_by_itself(before: Basic, after: Basic, reason: Reason, why: str) -> None:
    with pytest.raises(NotShownError, match=why):
        without_integrals(in_trees(before), in_trees(after), (reason,), ())


def test_a_rule_by_itself_does_what_it_should() -> None:
    for before, after, reason in (
        (area(t), Integral(1 - y, (y, 0, 1)), changing_variable(1 - t)),
        (area(4 * t), Integral(y, (y, 0, 2)), changing_variable(2 * t)),
        (area(t, 0, 2), area(t, 0, 1) + area(t, 1, 2), cutting(ONE)),
        (area(t + 3 * t**2), area(t) + 3 * area(t**2), collecting()),
        (area(t), ONE / 2, integrating(t**2 / 2)),
    ):
        one, other = without_integrals(in_trees(before), in_trees(after), (reason,), ())
        assert decide_continuous(*generalised(one, other), known(())).verdict is Verdict.PROVED


def test_each_part_has_a_value() -> None:
    slope, pole = Subs(Derivative(y**3, y), y, 2), Subs(Derivative(log(y), y), y, 0)
    need_value(in_trees(slope * t), ())
    for hidden in (slope + pole, pole + slope, Subs(1 / y, y, 0) + slope, slope + 1 / (t - t**2)):
        with pytest.raises(NotShownError):
            need_value(in_trees(hidden), ())
    with pytest.raises(NotShownError, match=r"could not show that .* exists"):
        need_value(parse("limit(sin(1/x), x, 0)"), ())


def test_a_bound_of_what_is_defined_is_not_cited_inside() -> None:
    half = Claim("half", equal(t, Rational(1, 2)), Definition())
    below = Claim("below", t < 1, by(substituting(half)))
    says = area((1 - t) ** -2, 0, 5)
    with pytest.raises(NotShownError, match="is about a symbol that is bound here"):
        without_integrals(in_trees(says), in_trees(ONE), (integrating(1 / (1 - t), below),), ())
