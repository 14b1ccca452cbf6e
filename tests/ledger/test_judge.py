"""Every checker of claims rejects the falsehoods planted for it."""

from dataclasses import replace
from typing import Any

import pytest
import sympy
from derivations import by, derived, manifest, step
from flint import arb
from planted_claims import EVERYTHING, a, b, claim, t, verdict, x, y
from sympy import (
    Abs,
    And,
    Derivative,
    Equivalent,
    Ge,
    Gt,
    Integer,
    Integral,
    Le,
    Lt,
    Rational,
    S,
    Subs,
    Symbol,
    Tuple,
    atan,
    cos,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
    tan,
)
from sympy_statements import ExactlyOne, ForSome, Under, at, equal

from tresym.ledger.claim import (
    Claim,
    Counterexample,
    Definition,
    Instance,
    all_of,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.formulas import in_trees
from tresym.ledger.judge import judge, judge_evidence
from tresym.ledger.reasons import (
    algebra,
    applying,
    changing_variable,
    citing,
    collecting,
    differentiation,
    evaluating,
    integrating,
    inverses,
    multiplying,
    roots,
    substituting,
    trigonometry,
)
from tresym.ledger.refutations import refute
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict

ONE = Integer(1)


def test_division_by_zero_is_not_proved() -> None:
    assert verdict(claim(equal(1 / (a - b) - 1 / (a - b), 0), by())) is not Verdict.REFUTED
    says = equal((a**2 - b**2) / (a - b), a + b)
    assert verdict(claim(says, by())) is Verdict.UNDECIDED
    assert verdict(claim(says, by(), (a - b > 0,))) is Verdict.PROVED


VALUES = {
    "a pole": (equal(at(sin(x) / x, {x: 0}), 1), ()),
    "a pole that may be met": (equal(y * at(1 / x, {x: y}), 1), ()),
    "a root of what may be negative": (equal(at(sqrt(x), {x: y}) ** 2, y), ()),
    "another value": (equal(at(x**2 + y, {x: 3}), 8 + y), ()),
    "values one after the other": (equal(at(x - y, {x: y, y: x}), 0), ()),
}


@pytest.mark.parametrize("name", VALUES)
def test_values_that_are_put_in_are_worked_out(name: str) -> None:
    says, given = VALUES[name]
    assert verdict(claim(says, by(evaluating, roots), given)) is not Verdict.PROVED
    right = equal(at(x**2 + y, {x: 3}), 9 + y)
    assert verdict(claim(right, by(evaluating))) is Verdict.PROVED
    assert verdict(claim(equal(y * at(1 / x, {x: y}), 1), by(evaluating), (y > 0,))).holds


def test_a_derivative_is_not_taken_at_equal_values() -> None:
    with pytest.raises(ValueError, match="get the same value"):
        at(Derivative(x**2 * y, x), {x: 1, y: 1})


def test_right_steps_between_wrong_ends() -> None:
    right = step((a - b) * (a + b), algebra)
    assert verdict(claim(equal(a**2 - b**2, a**2 + b**2), derived(right))) is Verdict.REFUTED
    late = derived(step(a**2 - b**2), step((a - b) * (a + b)))
    assert verdict(claim(equal(a**2 + b**2, (a - b) * (a + b)), late)) is Verdict.REFUTED


def test_bounds_need_a_manifest_sign() -> None:
    squares = manifest
    assert verdict(claim(Ge(a**2, -(b**2), evaluate=False), squares)) is Verdict.PROVED
    assert verdict(claim(Gt(a**2, -(b**2), evaluate=False), squares)) is not Verdict.PROVED
    assert verdict(claim(a**2 >= b**2, manifest)) is Verdict.REFUTED


def test_one_step_shows_each_part_of_a_system() -> None:
    squares = Tuple(Ge(a**2 + 1, 2 * a), Gt(a**2 + 2, 2 * a), equal((a + b) * a, a**2 + a * b))
    assert verdict(claim(squares, manifest)) is Verdict.PROVED
    for false in (Gt(a**2 + 1, 3 * a), equal((a + b) ** 2, a**2 + b**2)):
        assert verdict(claim(Tuple(*squares.args, false), manifest)) is Verdict.REFUTED
        assert verdict(claim(Tuple(false, *squares.args), manifest)) is Verdict.REFUTED


def test_a_cited_bound_counts_only_under_its_own_conditions() -> None:
    lemma = claim(a - b > 0, derived(step(a - b)), (a - b > 0, b > 0))
    held = {"planted": judge(lemma, {})}
    says = equal((a**2 - b**2) / (a - b), a + b)
    user = Claim("user", says, by(citing(lemma)), given=(b > 0,))
    assert judge(user, held).verdict is not Verdict.PROVED


def test_equations_are_transformed_by_one_to_one_functions_only() -> None:
    from sympy import Equivalent

    first, second = equal(a, b), equal(exp(a), exp(b))
    assert verdict(claim(Equivalent(first, second), derived(step(second, applying("exp"))))) is (
        Verdict.PROVED
    )
    squared = equal(a**2, b**2)
    steps = derived(step(squared, applying("square")))
    assert verdict(claim(Equivalent(first, squared), steps)) is Verdict.REFUTED
    assert verdict(claim(Equivalent(first, squared), steps, (a > 0, b > 0))) is Verdict.PROVED
    assert verdict(claim(Equivalent(first, squared), steps, (a > 0, b < 0))) is Verdict.REFUTED
    assert verdict(claim(Equivalent(first, squared), steps, (a >= 0, b >= 0))) is Verdict.PROVED
    for name, function in (("sqrt", sqrt), ("log", log)):
        changed = equal(function(a), function(b))
        steps = derived(step(changed, applying(name)))
        assert verdict(claim(Equivalent(first, changed), steps, (a > 0, b > 0))) is Verdict.PROVED
        assert verdict(claim(Equivalent(first, changed), steps)) is Verdict.UNDECIDED
    cosines = equal(cos(a), cos(b))
    assert verdict(claim(Equivalent(first, cosines), derived(step(cosines, applying("cos"))))) is (
        Verdict.REFUTED
    )
    vanishing = derived(step(equal(a * t, b * t), multiplying(t)))
    assert verdict(claim(Equivalent(first, equal(a * t, b * t)), vanishing)) is Verdict.REFUTED


def test_integrals_need_a_continuous_antiderivative() -> None:
    across_the_pole = equal(Integral(1 / x**2, (x, -1, 1)), -2)
    assert verdict(claim(across_the_pole, by(integrating(-1 / x)))) is Verdict.UNDECIDED
    right = equal(Integral(1 / x**2, (x, 1, 2)), Rational(1, 2))
    assert verdict(claim(right, by(integrating(-1 / x)))) is Verdict.PROVED
    assert verdict(claim(right, by(integrating(-2 / x)))) is not Verdict.PROVED
    wrong_ends = equal(Integral(1 / x**2, (x, 1, 2)), Rational(1, 3))
    assert verdict(claim(wrong_ends, by(integrating(-1 / x)))) is not Verdict.PROVED


def test_a_change_of_variable_needs_its_factor_and_its_limits() -> None:
    old = Integral(2 * x * exp(x**2), (x, 0, a))
    given = (a > 0,)
    right = equal(old, Integral(exp(y), (y, 0, a**2)))
    assert verdict(claim(right, by(changing_variable(x**2)), given)) is Verdict.PROVED
    wrong_limit = equal(old, Integral(exp(y), (y, 0, a)))
    assert verdict(claim(wrong_limit, by(changing_variable(x**2)), given)) is not Verdict.PROVED
    without_factor = equal(Integral(exp(x**2), (x, 0, a)), Integral(exp(y), (y, 0, a**2)))
    assert verdict(claim(without_factor, by(changing_variable(x**2)), given)) is not Verdict.PROVED


def root(function: object, slope: object, low: object, high: object, *given: object) -> Verdict:
    stated = ExactlyOne(x, low, high, equal(function, 0))
    return verdict(claim(stated, Decided(), given))


def test_definitions_introduce_new_symbols_only() -> None:
    assert verdict(claim(equal(x, a + b), Definition())) is Premise.DEFINED
    assert verdict(claim(equal(x, a + b), Definition("so it is"))) is Premise.ASSUMED
    assert verdict(claim(equal(x, x + 1), Definition())) is Verdict.UNDECIDED
    assert verdict(claim("nothing", Definition())) is Verdict.UNDECIDED


def test_conjunctions_are_as_strong_as_their_weakest_part() -> None:
    good = Claim("good", equal(a, a), by())
    bad = Claim("bad", equal(a, b), by())
    found = {c.label: judge(c, {}) for c in (good, bad)}
    both = Claim("both", "both", all_of(good, bad))
    assert judge(both, found).verdict is Verdict.REFUTED
    assert judge(Claim("one", "one", all_of(good)), found).verdict is Verdict.PROVED
    new, put_in = (claim(equal(x, a), Definition(why)) for why in ("", "so it is"))
    new, put_in = replace(new, label="new"), replace(put_in, label="put in", says=equal(t, a))
    found |= {c.label: judge(c, {}) for c in (new, put_in)}
    for parts, expected in (
        ((new,), Premise.DEFINED),
        ((new, put_in), Premise.ASSUMED),
        ((put_in, new, good), Verdict.PROVED),
    ):
        assert judge(Claim("all", "all", all_of(*parts)), found).verdict is expected


def test_each_part_of_a_conjunction_counts_and_is_named() -> None:
    good, bad, open_ = (Claim(name, equal(a, a), by()) for name in ("good", "bad", "open"))
    held = {"good": Finding(Verdict.PROVED, ""), "open": Finding(Verdict.UNDECIDED, "")}
    held["bad"] = Finding(Verdict.REFUTED, "at a = 1", witness={"a": ONE})
    for parts, why in (
        ((good, open_), "open is undecided"),
        ((good, good, bad), "bad is refuted: at a = 1"),
        ((open_, bad), "open is undecided"),
    ):
        assert judge(Claim("all", "all", all_of(*parts)), held).why == why


def test_evidence_is_judged_apart_from_what_it_rests_on() -> None:
    good = Claim("good", equal(a, a), by())
    alone = judge_evidence(good)
    assert alone is not None
    assert alone.verdict is Verdict.PROVED
    assert judge_evidence(Claim("all", "all", all_of(good))) is None


def test_all_that_is_used_was_judged_and_not_another_of_its_name() -> None:
    positive = Claim("positive", Gt(a**2 + 1, 0, evaluate=False), manifest)
    second = Claim("second", equal(t, 2), Definition())
    user = Claim("user", equal(y, y), by(citing(positive), substituting(second)))
    held = {"positive": judge(positive, {}), "second": judge(second, {})}
    assert judge(user, held).verdict is Verdict.PROVED
    held["second"] = judge(replace(second, says=equal(t, 3)), {})
    assert judge(user, held).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("sides", [(tan(x) * cos(x), sin(x)), (sin(x), tan(x) * cos(x))])
def test_both_sides_of_what_needs_no_chain_are_shown_to_exist(sides: tuple[Any, Any]) -> None:
    assert verdict(claim(equal(*sides), Decided())) is Verdict.UNDECIDED
    assert verdict(claim(equal(*sides), Decided(), (x > 0, x < 1))) is Verdict.PROVED


def test_counterexamples_must_satisfy_the_conditions() -> None:
    inside, outside = (Counterexample({"x": parse_number(p)}) for p in ("0.5", "-0.5"))
    assert verdict(claim(sin(x) <= x / 2, inside, (x > 0,))) is Verdict.REFUTED
    assert verdict(claim(sin(x) >= x / 2, outside)) is Verdict.REFUTED
    assert verdict(claim(sin(x) >= x / 2, outside, (x > 0,))) is Verdict.UNDECIDED
    assert verdict(claim(sin(x) <= x, inside, (x > 0,))) is Verdict.UNDECIDED
    assert verdict(claim("sin x ≤ x/2", inside, (x > 0,))) is Verdict.UNDECIDED


def test_a_counterexample_must_be_one_to_a_formal_statement() -> None:
    at_one = Counterexample({"x": parse_number("1")})
    for says in (Ge(x**2, 0, evaluate=False), equal(x, x)):
        assert verdict(claim(says, at_one)) is Verdict.UNDECIDED
    assert verdict(claim(x**2 > 2, at_one)) is Verdict.REFUTED
    assert verdict(claim(Tuple(equal(x, x), x**2 > 2), at_one)) is Verdict.REFUTED
    assert verdict(claim(y > 2, at_one)) is Verdict.UNDECIDED


@pytest.mark.parametrize("statement", [Under, lambda says, given: Equivalent(*given, says)])
def test_what_a_point_denies_of_an_implication(statement: Any) -> None:
    at_one = Counterexample({"x": parse_number("1")})
    for held, verdict_there in ((equal(x**2, 1), Verdict.REFUTED), (x > 1, Verdict.UNDECIDED)):
        says = statement(x < 0, Tuple(held))
        assert verdict(claim(says, at_one)) is verdict_there
    assert verdict(claim(statement(x > 0, Tuple(equal(x, 1))), at_one)) is Verdict.UNDECIDED


def test_that_something_is_somewhere_is_denied_by_its_contrary_everywhere() -> None:
    nowhere = claim(ForSome(Le(x**2 + 1, 0, evaluate=False)), Decided())
    assert judge(nowhere, {}).verdict is Verdict.REFUTED
    assert verdict(claim(ForSome(ForSome(x > 5)), Decided())) is Verdict.UNDECIDED
    assert verdict(claim(ForSome(S.false), Decided())) is Verdict.REFUTED
    assert verdict(replace(nowhere, given=(x > 1, x < 0))) is Verdict.UNDECIDED
    both = claim(ForSome(And(x > 5, x < 1, evaluate=False)), Decided())
    assert not judge(both, {}).verdict.holds


def test_sentences_are_decided_as_written() -> None:
    assert verdict(claim(Gt(x**2, -1, evaluate=False), Decided())) is Verdict.PROVED
    assert verdict(claim(x**2 > x, Decided())) is Verdict.REFUTED
    assert verdict(claim(x**2 > 0, Decided(), (x > 0,))) is Verdict.PROVED
    assert verdict(claim(equal(sqrt(x**2), x), Decided(), (x > 0,))) is Verdict.PROVED
    assert verdict(claim("x² > x", Decided())) is Verdict.UNDECIDED


@pytest.mark.parametrize("n", range(3))
def test_a_sentence_needs_each_of_its_relations(n: int) -> None:
    true = [Gt(x**2 + k, -1, evaluate=False) for k in range(3)]
    assert verdict(claim(Tuple(*true), Decided())) is Verdict.PROVED
    for wrong in (equal(x, Integer(1)), x**2 > x):
        parts = [*true[:n], wrong, *true[n + 1 :]]
        assert not verdict(claim(Tuple(*parts), Decided())).holds


def test_systems_need_a_chain_for_every_part() -> None:
    says = Tuple(equal(a + a, 2 * a), equal(b + b, 2 * b))
    assert verdict(claim(says, Decided(steps=((step(None),), (step(None),))))) is Verdict.PROVED
    assert verdict(claim(says, Decided(steps=((step(None),),)))) is Verdict.UNDECIDED


SMOOTH_NOWHERE = {
    "a logarithm of what is negative": (equal(Derivative(log(x), x), 1 / x), (x < 0,)),
    "atanh beyond 1": (equal(Derivative(sympy.atanh(x), x), 1 / (1 - x**2)), (x > 1,)),
    "a corner": (equal(Derivative(Abs(x), x), sign(x)), ()),
    "a corner that is put in": (equal(at(Derivative(Abs(x), x), {x: y}), sign(y)), ()),
    "a jump": (equal(Derivative(sign(x), x), 0), ()),
    "a constant that is none": (equal(Derivative(log(y) + x, x), 1), ()),
    "inside a value": (equal(at(Derivative(log(x), x) + y, {x: y}), y + 1 / y), (y < 0,)),
    "a second derivative": (equal(Derivative(log(x), x, x), -1 / x**2), (x < 0,)),
}


@pytest.mark.parametrize("name", SMOOTH_NOWHERE)
def test_a_derivative_is_one_where_its_function_is_smooth(name: str) -> None:
    says, given = SMOOTH_NOWHERE[name]
    for proof in (by(evaluating, *EVERYTHING), Decided()):
        assert not verdict(claim(says, proof, given)).holds


def test_a_derivative_of_what_is_shown_to_be_smooth() -> None:
    for says in (
        equal(Derivative(log(x), x), 1 / x),
        equal(Derivative(Abs(x), x), sign(x)),
        equal(Derivative(log(x), x, x), -1 / x**2),
        equal(at(Derivative(log(x), x) + y, {x: y}), y + 1 / y),
    ):
        assert verdict(claim(says, by(evaluating, *EVERYTHING), (x > 0, y > 0))).holds


ACROSS = Integral(1 / x, (x, -1, 1))
NO_INTEGRAL = {
    "one equal to itself": (equal(ACROSS, Integral(1 / y, (y, -1, 1))), ()),
    "a square": (Ge(ACROSS**2, 0, evaluate=False), ()),
    "of what is not real": (Ge(Integral(log(y), (y, -2, -1)) ** 2, 0, evaluate=False), ()),
    "in a derivative": (
        equal(
            Derivative(Integral(1 / t, (t, -1, x)), x) + y,
            y + Derivative(Integral(1 / a, (a, -1, x)), x),
        ),
        (x > 0,),
    ),
}


@pytest.mark.parametrize("name", NO_INTEGRAL)
def test_an_integral_that_does_not_exist_equals_nothing(name: str) -> None:
    says, given = NO_INTEGRAL[name]
    for proof in (by(), Decided(), manifest):
        assert not verdict(claim(says, proof, given)).holds
    there = equal(Integral(1 / x, (x, 1, 2)), Integral(1 / y, (y, 1, 2)))
    assert all(verdict(claim(there, proof)).holds for proof in (by(), Decided()))


def test_circular_definitions_end() -> None:
    one = Claim("one", equal(x, y + 1), Definition())
    two = Claim("two", equal(y, x - 1), Definition())
    found = {c.label: judge(c, {}) for c in (one, two)}
    looped = Claim("looped", equal(x, 0), by(substituting(one, two)))
    assert judge(looped, found).verdict is Verdict.UNDECIDED


def test_conditions_do_not_restrict_the_variable_of_integration() -> None:
    across_the_pole = equal(Integral(1 / x**2, (x, -1, 1)), -2)
    assert verdict(claim(across_the_pole, by(integrating(-1 / x)), (x > 0,))) is Verdict.UNDECIDED
    far = equal(Integral(1 / x**2, (x, -1, 1)), -2)
    assert verdict(claim(far, by(integrating(-1 / x)), (x**2 > 0,))) is Verdict.UNDECIDED


def test_a_variable_of_integration_is_not_replaced() -> None:
    defined = Claim("defined", equal(x, a), Definition())
    found = {"defined": judge(defined, {})}
    says = equal(Integral(x, (x, 0, 1)), a)
    user = Claim("user", says, by(substituting(defined)))
    assert judge(user, found).verdict is Verdict.UNDECIDED


def test_sines_are_positive_strictly_inside_the_half_turn() -> None:
    inside = (x > 0, x < pi)
    assert verdict(claim(sin(x) > 0, derived(step(sin(x))), inside)) is Verdict.PROVED
    assert verdict(claim(cos(x) > 0, derived(step(cos(x))), (x > 0, x < pi / 2))) is Verdict.PROVED
    assert verdict(claim(sin(x) > 0, derived(step(sin(x))), (x >= 0, x < pi))) is not Verdict.PROVED
    assert verdict(claim(cos(x) > 0, derived(step(cos(x))), inside)) is Verdict.REFUTED


def test_an_equation_is_put_in_only_under_its_own_conditions() -> None:
    lemma = Claim("lemma", equal(sqrt(x**2), x), by(roots), given=(x > 0,))
    held = {"lemma": judge(lemma, {})}
    says = equal(sqrt(x**2) + 1, x + 1)
    assert not judge(Claim("user", says, by(substituting(lemma))), held).verdict.holds
    user = Claim("user", says, by(substituting(lemma)), given=(x > 2,))
    assert judge(user, held).verdict is Verdict.PROVED
    sentence = Claim("sentence", "√x² = x", Decided((lemma,)), means=says)
    assert not judge(sentence, held).verdict.holds


def test_the_conditions_of_what_is_used_are_in_the_finding() -> None:
    root = Claim("root", equal(sqrt(a**2), a), by(roots), given=(a > 0, b > 0))
    user = Claim("user", equal(sqrt(a**2), a), by(substituting(root)), given=(a > 1, b > 1))
    said = Claim("said", equal(sqrt(a**2), a), Decided((root,)), given=(a > 1, b > 1))
    found: dict[str, Finding] = {}
    for c in (root, user, said):
        found[c.label] = judge(c, found)
        assert found[c.label].verdict is Verdict.PROVED
    positive = tuple(map(in_trees, (a > 0, b > 0)))
    assert found["root"].conditions == {}
    assert found["user"].conditions == found["said"].conditions == {"root": positive}
    both = Claim("both", "…", all_of(user, root))
    found["both"] = judge(both, found)
    assert found["both"].conditions == {
        "user": tuple(map(in_trees, (a > 1, b > 1))),
        "root": positive,
    }
    assert judge(Claim("all", "…", all_of(both)), found).conditions == found["both"].conditions


def test_the_advocate_does_not_believe_what_holds_elsewhere() -> None:
    """A claim of no definition restricts nothing: its conditions may be what was got wrong."""
    root = Claim("root", equal(sqrt(a**2), a), by(roots), given=(a > 0,))
    user = Claim("user", equal(sqrt(a**2), a), by(substituting(root)))
    found = refute(user.says, user)
    assert found is not None
    assert found.verdict is Verdict.REFUTED


def test_a_condition_on_a_hidden_symbol_is_not_forgotten() -> None:
    factor = Claim("factor", equal(y, x * t / sqrt(t**2)), Definition(), given=(t**2 > 0,))
    up = Claim("up", equal(y, x), by(substituting(factor), roots), given=(t > 0, t**2 > 0))
    down = Claim("down", equal(y, -x), by(substituting(factor), roots), given=(t < 0, t**2 > 0))
    held = {c.label: judge(c, {"factor": judge(factor, {})}) for c in (factor, up, down)}
    assert held["up"].verdict is held["down"].verdict is Verdict.PROVED
    steps = derived(step(y, substituting(up)), step(-x, substituting(down)))
    assert not judge(Claim("both", equal(x, -x), steps), held).verdict.holds


def test_nothing_is_proved_by_nothing() -> None:
    from sympy import Equivalent

    assert verdict(claim(equal(x, x + 1), ())) is not Verdict.PROVED
    assert verdict(claim(Gt(x, 1, evaluate=False), ())) is not Verdict.PROVED
    assert verdict(claim(Equivalent(equal(x, 1), equal(x, 2)), ())) is not Verdict.PROVED
    assert verdict(claim("nothing", all_of())) is Verdict.UNDECIDED
    assert verdict(claim(Tuple(), Decided())) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "says",
    [
        equal(Integer(1), Integer(2)),
        equal(x + 1, x + 2),
        equal(x**2, Integer(-1)),
        equal(x, sqrt(-1 - y**2)),
        Tuple(equal(x, y), equal(x, y + 1)),
        Tuple(equal(x, y + 1), equal(y, x + 1)),
        Tuple(equal(x, y), Gt(x, 0, evaluate=False)),
        equal(Integral(t**2, (t, 0, x)), -1 - x**4),
    ],
    ids=str,
)
def test_what_defines_nothing_is_no_definition(says: object) -> None:
    assert verdict(claim(says, Definition())) is Verdict.UNDECIDED


def test_a_primitive_that_jumps_is_none() -> None:
    jump = equal(Integral(1, (x, -1, 1)), 4)
    assert verdict(claim(jump, by(integrating(x + sign(x))))) is Verdict.REFUTED
    turned = equal(Integral(-1 / (1 + x**2), (x, -1, 1)), pi / 2)
    assert verdict(claim(turned, by(integrating(atan(1 / x)), inverses))) is Verdict.REFUTED


def test_a_factor_must_be_defined() -> None:
    from sympy import Equivalent

    divided = Equivalent(equal(x * y, y), equal(x, 1))
    steps = derived(step(equal(x, 1), multiplying(1 / y)))
    assert verdict(claim(divided, steps, (y >= 0,))) is not Verdict.PROVED
    assert verdict(claim(divided, steps, (y > 0,))) is Verdict.PROVED


def test_definitions_do_not_reach_bound_variables() -> None:
    square = Claim("square", equal(y, x**2), Definition())
    held = {"square": judge(square, {})}
    for says, reason in (
        (equal(Derivative(y, x), 2 * x), differentiation),
        (equal(Integral(y, (x, 0, 1)), Rational(1, 3)), integrating(x**3 / 3)),
    ):
        user = Claim("user", says, by(substituting(square), reason))
        assert judge(user, held).verdict is Verdict.UNDECIDED


def test_coefficients_of_any_size_are_answered() -> None:
    tiny = x**2 - 2 * x * y + y**2 - Rational(1, 10**30)
    assert verdict(claim(equal(Abs(tiny), tiny), by(*EVERYTHING))) is not Verdict.PROVED


def test_the_sign_of_zero_is_not_one() -> None:
    assert verdict(claim(equal(sign(x), 1), by(*EVERYTHING), (x >= 0,))) is not Verdict.PROVED
    assert verdict(claim(equal(sign(x) ** 2, 1), Decided())) is not Verdict.PROVED
    assert verdict(claim(equal(sign(x) ** 2, 1), Decided(), (x < 0,))) is Verdict.PROVED
    unseen = sign(x - sqrt(2)) ** 2  # 0 at a point that nobody tries
    assert verdict(claim(equal(unseen, 1), Decided())) is not Verdict.PROVED
    assert verdict(claim(equal(unseen, 1), by(*EVERYTHING))) is not Verdict.PROVED


def test_only_inequalities_are_cited() -> None:
    bound = Claim("bound", Gt(x, y, evaluate=False), derived(step(x - y)), given=(x - y > 0,))
    prose = Claim("prose", "x is larger", all_of(bound))
    equation = Claim("equation", equal(x, x), by())
    held = {"bound": judge(bound, {})}
    held |= {c.label: judge(c, held) for c in (prose, equation)}
    for cited in (bound, prose, equation):
        user = Claim("user", Gt(x, y, evaluate=False), derived(step(x - y, citing(cited))))
        assert not judge(user, held).verdict.holds


def test_a_conjunction_proves_no_formula() -> None:
    good = Claim("good", equal(sin(a) ** 2 + cos(a) ** 2, 1), by(trigonometry))
    found = {"good": judge(good, {})}
    assert judge(Claim("formula", equal(a, b), all_of(good)), found).verdict is Verdict.UNDECIDED
    assert judge(Claim("sentence", "so it is", all_of(good)), found).verdict is Verdict.PROVED


def test_what_holds_of_a_symbol_does_not_hold_of_a_bound_one() -> None:
    lemma = Claim("lemma", equal(Abs(x), x), by(roots), given=(x > 0,))
    held = {"lemma": judge(lemma, {})}
    assert held["lemma"].verdict is Verdict.PROVED
    for says in (
        equal(Integral(Abs(x), (x, -1, 1)), Integral(x, (x, -1, 1))),
        equal(Subs(Abs(x), x, -1), Subs(x, x, -1)),
    ):
        user = Claim("user", says, by(substituting(lemma), differentiation), given=(x > 0,))
        assert not judge(user, held).verdict.holds


def test_the_name_of_a_variable_of_integration_does_not_matter() -> None:
    renamed = equal(Integral(sin(x), (x, 0, y)), Integral(sin(t), (t, 0, y)))
    assert verdict(claim(renamed, by())) is Verdict.PROVED
    free = equal(Integral(sin(x), (x, 0, x)), Integral(sin(t), (t, 0, t)))
    assert verdict(claim(free, by())) is Verdict.REFUTED
    captured = equal(Integral(x * t, (x, 0, 1)), Integral(t * t, (t, 0, 1)))
    assert verdict(claim(captured, by())) is Verdict.REFUTED


def test_a_stored_proof_that_does_not_hold_leaves_its_claim_undecided() -> None:
    from tresym.ledger.evidence.box_bounds import Boxes
    from tresym.reals.balls.branch_and_bound import Bound, BoxProof, box

    bound = Bound(lambda x, m: x - arb("0.5"), box(("0", "1")))
    for proofs in ((BoxProof("b"),), (BoxProof("?"),), (BoxProof("xb"),), ()):
        stale = Boxes((bound,), ("x",), "0 <= x <= 1", stored=lambda proofs=proofs: proofs)
        finding = judge(claim("x > 1/2", stale), {})
        assert finding.verdict is Verdict.UNDECIDED
        assert "stored proof" in finding.why


def test_what_a_claim_rests_on_is_shown_whether_spoken_of_or_not() -> None:
    below = Claim("below", equal(t, -1), Definition(), given=(y < 0,))
    root = Claim("root", equal(sqrt(y**2), t * y), by(substituting(below), roots), given=(y < 0,))
    held = {"below": judge(below, {})}
    held["root"] = judge(root, held)
    assert held["root"].verdict is Verdict.PROVED
    user = Claim("user", equal(t, -1), by(substituting(below)))
    assert judge(user, held).verdict is Verdict.UNDECIDED
    hidden = Claim("hidden", equal(x, 1), Definition(), given=(y > 0,))
    other = Claim(
        "other", equal(sqrt(y**2), x * y), by(substituting(hidden), roots), given=(y > 0,)
    )
    held["hidden"] = judge(hidden, {})
    held["other"] = judge(other, held)
    assert held["other"].verdict is Verdict.PROVED
    for proof in (
        by(substituting(other), substituting(hidden)),
        Decided((other, hidden)),
    ):
        says = equal(sqrt(y**2), y)
        assert not judge(Claim("up", says, proof, given=(y < 0,)), held).verdict.holds


# -- instances ------------------------------------------------------------------------------------

GENERAL = Claim("general", equal(sqrt(x**2), x), by(roots), given=(x > 0,))
OF_SQUARE = Instance(GENERAL, ((x, y**2 + 1),))
HALF = Claim("x is 1/2", equal(x, Rational(1, 2)), Definition())
ON_HALF = Claim("on 1/2", equal(2 * x, 1), by(substituting(HALF)))
UNDER_INTEGRAL = Claim("integral", equal(Integral(x * t, (t, 0, 1)), x / 2), by())


def found_alone(planted: Claim) -> Verdict:
    finding = judge_evidence(planted)
    assert finding is not None
    return finding.verdict


def test_what_holds_for_all_values_holds_for_these() -> None:
    assert found_alone(claim(OF_SQUARE.says, OF_SQUARE)) is Verdict.PROVED
    beyond = Claim("y is a + 1", equal(y, a + 1), Definition())
    cited = Claim("y > 1", y > 1, by(substituting(beyond)), given=(a > 0,))
    put = Instance(GENERAL, ((x, y),), (cited,))
    assert found_alone(claim(put.says, put, (a > 0,))) is Verdict.PROVED


@pytest.mark.parametrize(
    ("proof", "says"),
    [
        (Instance(GENERAL, ((x, y),)), None),
        (Instance(GENERAL, ((x, -(y**2)),)), None),
        (Instance(GENERAL, ((x, sqrt(y) + 1),)), None),
        (OF_SQUARE, equal(sqrt(y**2), y)),
        (OF_SQUARE, equal(x, x)),
        (Instance(ON_HALF, ((x, y),)), None),
        (Instance(UNDER_INTEGRAL, ((x, t),)), equal(Integral(t * t, (t, 0, 1)), t / 2)),
    ],
)
def test_what_is_no_instance_is_refused(proof: Instance, says: object) -> None:
    """A condition that does not hold, a value that is none, another claim, what is defined, …"""
    planted = claim(proof.says if says is None else says, proof)
    assert found_alone(planted) in (Verdict.UNDECIDED, Verdict.REFUTED)


def test_a_chain_from_what_balls_show_is_no_more_exact_than_they() -> None:
    y = Symbol("y", real=True)
    seen = Claim("seen", sin(y) < 1, by(algebra), given=(y > 0,), expect=Verdict.ENCLOSED)
    told = Claim("told", sin(y) < 2, by(citing(seen)), given=(y > 0,))
    again = Claim("again", sin(y) < 3, by(citing(told)), given=(y > 0,))
    found = {"seen": Finding(Verdict.ENCLOSED, "by balls")}
    found["told"] = judge(told, found)
    assert found["told"].verdict is told.expect is Verdict.ENCLOSED
    assert judge(again, found).verdict is again.expect is Verdict.ENCLOSED
    false = Claim("false", equal(sin(y), 2), by(citing(seen)), given=(y > 0,))
    assert not judge(false, found).verdict.holds
    found["seen"] = Finding(Verdict.PROVED, "exactly")
    assert judge(told, found).verdict is Verdict.PROVED


def test_a_cited_bound_holds_of_the_integral_that_it_names_and_no_other() -> None:
    y = Symbol("y", real=True)
    taken = Integral(exp(sin(y)), (y, 0, 1))
    seen = Claim("seen", Lt(taken, 3, evaluate=False), by(algebra))
    found = {"seen": Finding(Verdict.PROVED, "")}
    for other, most, holds in (
        (taken, 4, True),
        (taken, Rational(3, 2), False),
        (Integral(exp(sin(y)), (y, 0, 9)), 4, False),
        (Integral(2 * exp(sin(y)), (y, 0, 1)), 3, False),
    ):
        claim = Claim("told", Lt(other, most, evaluate=False), by(citing(seen)))
        assert judge(claim, found).verdict.holds is holds, (other, most)


@pytest.mark.parametrize(("share", "holds"), [(1, True), (-1, False), (2, False)])
def test_an_integral_is_collected_with_its_sign(share: int, holds: bool) -> None:
    y = Symbol("y", real=True)
    first, second = Integral(sin(y), (y, 0, 1)), Integral(share * cos(y), (y, 0, 1))
    whole = Integral(sin(y) + cos(y), (y, 0, 1))
    for left, right in ((-whole, -first - second), (whole, first + second)):
        claim = Claim("told", equal(3 + left, 3 + right), by(collecting()))
        assert judge(claim, {}).verdict.holds is holds
