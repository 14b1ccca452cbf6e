"""False claims of every kind of evidence, made through the Python API: none of them is accepted.

Each attacks one guard. `FALSE` are statements that do not hold, `UNFOUNDED` are refutations of
statements that hold, or that their evidence does not touch.
"""

from dataclasses import replace
from typing import Any

import pytest
from derivations import by, derived, manifest, step
from flint import arb, fmpq
from sympy import (
    Abs,
    Derivative,
    Equivalent,
    Function,
    Gt,
    ImmutableMatrix,
    Integer,
    Integral,
    Ne,
    Or,
    Rational,
    Subs,
    Symbol,
    Tuple,
    atan,
    cos,
    log,
    oo,
    pi,
    sin,
    sqrt,
    tan,
)
from sympy_statements import (
    AtMostOne,
    ExactlyOne,
    ForSome,
    Rounds,
    TheRoot,
    Under,
    at,
    equal,
    order,
)

from tresym.ledger import judge as judging
from tresym.ledger.claim import (
    Claim,
    Counterexample,
    Definition,
    ImplicitFunction,
    Instance,
    Monotone,
    Printed,
    Root,
    all_of,
)
from tresym.ledger.evidence import allowed_evidence, integrals, remainders
from tresym.ledger.evidence.allowed_evidence import Meant
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted, On, Shown
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.evidence.remainders import Remainder
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import (
    adding,
    algebra,
    applying,
    changing_variable,
    citing,
    collecting,
    cutting,
    differentiating_integral,
    differentiation,
    evaluating,
    exponentials,
    integrating,
    inverses,
    multiplying,
    roots,
    substituting,
    trigonometry,
)
from tresym.reals.balls.branch_and_bound import Bound, box
from tresym.reals.language import binders
from tresym.reals.language.expression import number
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.quick

x, y, z, a, b, c, k, p, q, t, u, v, w = (Symbol(name, real=True) for name in "xyzabckpqtuvw")
O, o = Function("O"), Function("o")  # noqa: E741
HOT = Symbol("hot", real=True)
ZERO, ONE, TWO = Integer(0), Integer(1), Integer(2)
HALF = Rational(1, 2)
FALSEHOOD = equal(ZERO, ONE)
whole, hidden = Symbol("n", integer=True), Symbol("m", positive=True)


def defines(label: str, says: Any, *given: Any, assumes: str = "") -> Claim:
    return Claim(label, says, Definition(assumes), given=given)


def says(label: str, formula: Any, proof: Any, *given: Any, **rest: Any) -> Claim:
    return Claim(label, formula, proof, given=given, **rest)


def judged(claim: Claim) -> Finding:
    found: dict[str, Finding] = {}
    for used in claim.rests_on:
        found[used.label] = judge(used, found)
    return judge(claim, found)


# -- what the false claims are made of: all of it holds -------------------------------------------

square = defines("square", equal(y, x**2))
shifted = defines("shifted", equal(z, y + 1))
pair = defines("pair", Tuple(equal(u, x), equal(v, x + 1)))
reciprocal = defines("reciprocal", equal(w, 1 / x), x > 0)
half = defines("half", equal(a, HALF))
to_two = defines("to_two", equal(Integral(x * p, (x, 0, k)), 2), k > 0, assumes="such an end")
to_m = defines("to_m", equal(Integral(x, (x, 0, k)), q), k > 0, q > 0, assumes="such an end")
expanded = says("expanded", equal(y + 2 * x + 1, (x + 1) ** 2), by(substituting(square)))
square_above = says("square_above", y >= 0, by(substituting(square)))
below_square = says("below_square", x**2 <= y, by(substituting(square)))
square_small = says("square_small", y < 1, by(substituting(square)), x > -1, x < 1)
binomial = says("binomial", equal((x + 1) ** 2, x**2 + 2 * x + 1), by(algebra))
root = says("root", equal(sqrt(x**2), x), by(roots), x > 0)
above = says("above", x**3 > 0, manifest, x > 0)
twice = says("twice", equal(x + x, 2 * x), by(algebra))
next_above = says("next_above", Gt(x + 1, x, evaluate=False), manifest)
less = says("less", x < 1, manifest, x < HALF)
cubic = Claim(
    "cubic",
    "One root.",
    Decided(),
    expect=Verdict.PROVED,
    given=(k > 0,),
    means=ExactlyOne(x, 0, 1, equal(x**3 + k * x, 1)),
)
line = Claim(
    "line",
    "One root.",
    Decided(),
    expect=Verdict.PROVED,
    given=(k > 0,),
    means=ExactlyOne(x, 0, k + 1, equal(x, k)),
)
at_k = Root(c, line)
root_of_line = Claim("root_of_line", at_k.says, at_k, given=(k > 0,))
turn = defines("turn", equal(Integral(w * x, (x, 0, u)), 1), w > 0, u > 0, assumes="such a turn")

HOLD = (
    *(square, shifted, pair, reciprocal, half, to_two, to_m, expanded, square_above),
    *(below_square, square_small, binomial, root, above, twice, less, line),
    *(root_of_line, turn),
)


@pytest.mark.parametrize("claim", HOLD, ids=lambda claim: claim.label)
def test_what_the_false_claims_are_made_of_holds(claim: Claim) -> None:
    assert judged(claim).verdict.holds


def instance(claim: Claim, *values: Any, cited: tuple[Claim, ...] = ()) -> Instance:
    return Instance(claim, values, cited)


def said_by(label: str, proof: Any, *given: Any) -> Claim:
    """The claim that says what its evidence, an instance or a root, says."""
    return Claim(label, proof.says, proof, given=given)


y_is_0 = said_by("y_is_0", instance(square, (x, ZERO)))
y_is_1 = said_by("y_is_1", instance(square, (x, ONE)))
c_is_1 = said_by("c_is_1", instance(root_of_line, (k, ONE)), k > 0)
c_is_2 = said_by("c_is_2", instance(root_of_line, (k, TWO)), k > 0)


held = Integral(y * v, (v, 0, u))
by_p = defines("by_p", equal(y, p**2))
turned = defines(
    "turned", equal(Integral(p**2 * v, (v, 0, u)), 1), p > 0, u > 0, assumes="such a turn"
)
with_square = says(
    "with_square",
    equal(held, 1),
    derived(
        step(Integral(p**2 * v, (v, 0, u)), substituting(by_p)), step(None, substituting(turned))
    ),
    *(p > 0, u > 0),
)


def order_claim(formula: Any, means: Any, proof: Any, *given: Any) -> Claim:
    return Claim("order", formula, proof, given=given, means=means)


def charted(margin: Any, ends: tuple[str, str]) -> Charted:
    return Charted((On((x,), box(ends), (Shown(margin),)),))


def bounded(formula: Any, remainder: Any, low: str = "0", means: Any = None) -> Claim:
    """An order beside |x + x²| <= 3x on [low, 1]."""
    margins = (lambda s, m: 3 - (1 + s), lambda s, m: 3 + (1 + s))
    shown = tuple(Shown(margin, x) for margin in margins)
    proof = Charted((On((x,), box((low, "1")), shown),), remainder=remainder)
    given = (x > 0, x >= Rational(low), x < 1) if low != "0" else (x > 0, x < 1)
    return order_claim(formula, SUM_BOUND if means is None else means, proof, *given)


SUM = x + x**2
SUM_BOUND = Abs(SUM) <= 3 * x


def remainder_boxes(low: str, high: str, coordinate: Any = x, tends: Any = x) -> Boxes:
    """x − sin x is at most x⁴ in size on a box that does not reach 0."""
    margins = (
        lambda s, m: 1 - (s - m.sin(s)) / s**4,
        lambda s, m: 1 + (s - m.sin(s)) / s**4,
    )
    bounds = tuple(Bound(margin, box((low, high)), sufficient=True) for margin in margins)

    def samples() -> Any:
        s = (arb(low) + arb(high)) / 2
        yield (s,), {x: s}

    meant = Meant(samples, x**4, (coordinate,), Remainder(tends))
    return Boxes(bounds, ("x",), "everywhere", constant=fmpq(1), meant=meant)


fifth_power = Boxes(
    tuple(
        Bound(margin, box(("-1/2", "1/2")), sufficient=True)
        for margin in (lambda s, m: 1 - s, lambda s, m: 1 + s)
    ),
    ("x",),
    "near 0",
    constant=fmpq(1),
    meant=Meant(lambda: [((arb(1) / 8,), {x: arb(1) / 8})], x**4, (x,), Remainder(x)),
)
"""x⁵ is at most x⁴ in size near 0."""

small_sine = equal(sin(x), x + O(x**4))

FALSE: dict[str, Claim] = {
    # instances under which a defined symbol keeps its name
    "instance-value-of-a-defined-symbol": y_is_0,
    "instance-another-value": y_is_1,
    "instance-chain-of-two": says(
        "f", FALSEHOOD, derived(step(y, substituting(y_is_0)), step(None, substituting(y_is_1)))
    ),
    "instance-two-variables": said_by("f", instance(square, (x, z))),
    "instance-through-a-lemma": said_by("f", instance(expanded, (x, ZERO))),
    "instance-of-a-bound": said_by("f", instance(square_small, (x, ZERO)), x > 5),
    "instance-through-another-definition": said_by("f", instance(shifted, (y, ZERO))),
    "instance-by-way-of-two-definitions": said_by(
        "f",
        instance(says("g", equal(z, x**2 + 1), by(substituting(shifted, square))), (x, ZERO)),
    ),
    "instance-of-a-system": said_by("f", instance(pair, (x, ZERO))),
    "instance-of-a-root": c_is_1,
    "instances-of-a-root": says(
        "f",
        equal(ONE, 2),
        derived(step(c, substituting(c_is_1)), step(None, substituting(c_is_2))),
        k > 0,
    ),
    "instance-of-a-root-by-its-end": said_by(
        "f", instance(says("g", c < k + 1, by(citing(root_of_line)), k > 0), (k, ONE)), k > 5
    ),
    "instance-of-an-assumed-equation": said_by("f", instance(to_m, (q, ONE)), k > 0),
    "instance-of-what-follows-from-it": said_by(
        "f",
        instance(
            says(
                "g",
                equal(k**2 / 2, q),
                derived(
                    step(Integral(x, (x, 0, k)), integrating(x**2 / 2)),
                    step(None, substituting(to_m)),
                ),
                *(k > 0, q > 0),
            ),
            (q, TWO),
        ),
        k > 0,
    ),
    "instance-without-its-condition": said_by("f", instance(root, (x, z))),
    "instance-against-its-condition": said_by("f", instance(root, (x, z)), z < 0),
    "instance-of-a-condition-by-a-false-citation": said_by(
        "f", instance(root, (x, z), cited=(above,)), z < 0
    ),
    "instance-of-a-derivative": says(
        "f",
        equal(Derivative(x**2, x), 0),
        instance(says("g", equal(Derivative(x**2, x), 2 * x), by(differentiation)), (x, ZERO)),
    ),
    "instance-captured-by-an-integral": said_by(
        "f",
        instance(
            says(
                "g",
                equal(Integral(z, (x, 0, 1)), z),
                by(integrating(z * x)),
            ),
            (z, x),
        ),
    ),
    "instance-of-something-else": says("f", equal(z**2, z), instance(binomial, (x, z))),
    "instance-of-a-number": said_by("f", instance(twice, (TWO, Integer(3)))),
    "instance-of-an-expression": said_by("f", instance(binomial, (x**2, ZERO))),
    "instance-at-infinity": said_by("f", instance(next_above, (x, oo))),
    "instance-of-an-order": says(
        "f",
        equal(sin(z), O(z**5)),
        instance(order_claim(equal(sin(x), O(x**5)), equal(x, x), by(algebra)), (x, z)),
    ),
    "instance-without-a-value": said_by(
        "f", instance(says("g", equal(x / x, 1), by(algebra), Ne(x, 0)), (x, ZERO))
    ),
    # a slope with something held that varies
    "slope-with-a-square-held": says(
        "f",
        equal(z, -at(Derivative(held, p), {p: ONE}) / Derivative(held, u)),
        ImplicitFunction(with_square, u, p, ONE),
        *(u > 0, y > 0),
    ),
    "slope-of-a-sentence": says(
        "f",
        equal(z, 0),
        ImplicitFunction(Claim("g", "words", all_of(twice)), u, p, ONE),
    ),
    # bounds that are cited under a binder
    "bound-of-a-defined-symbol-under-an-integral": says(
        "f",
        Gt(Integral(1 - x**2, (x, 0, 3)), 0, evaluate=False),
        by(citing(below_square)),
        y < 1,
    ),
    "bound-of-the-variable-outside": says(
        "f",
        Gt(Integral(1 - u, (u, 0, 3)), 0, evaluate=False),
        by(citing(less)),
        x < HALF,
    ),
    "bound-whose-condition-is-dropped": says("f", x**3 > 0, by(citing(above)), x > -1),
    "bound-of-a-sentence": says("f", x > 1, by(citing(Claim("g", "x > 1", all_of(twice))))),
    # conjunctions with a formula of their own
    "conjunction-with-a-formula": Claim("f", "x is 2x.", all_of(twice), means=equal(x, 2 * x)),
    "conjunction-that-drops-a-condition": Claim(
        "f", "x³ is positive.", all_of(above), means=x**3 > 0
    ),
    "conjunction-with-another-condition": Claim(
        "f", "x³ is positive.", all_of(above), given=(x < 0,)
    ),
    "conjunction-of-one-root": Claim(
        "f", "One root.", all_of(twice), means=AtMostOne(x, -3, 3, equal(x**2, 1))
    ),
    "conjunction-of-exactly-one-root": Claim(
        "f", "One root.", all_of(twice), means=ExactlyOne(x, -3, 3, equal(x**2, 1))
    ),
    "root-of-a-false-uniqueness": says(
        "f",
        TheRoot(x, -3, 3, equal(x**2, 1)) < 0,
        Evaluated((Claim("g", "One.", all_of(twice), means=AtMostOne(x, -3, 3, equal(x**2, 1))),)),
    ),
    "conjunction-for-a-formula": says("f", FALSEHOOD, all_of(twice)),
    "conjunction-of-nothing": Claim("f", "Everything.", all_of()),
    "conjunction-with-what-is-false": Claim(
        "f", "All.", all_of(twice, says("g", equal(x, x + 1), by(algebra)))
    ),
    "conjunction-of-an-order": Claim(
        "f", "sin x is small.", all_of(twice), means=order(equal(sin(x), o(x)), x)
    ),
    "boxes-with-a-formula": Claim(
        "f",
        "x is 2x.",
        Boxes((Bound(lambda s, m: s, box(("1", "2"))),), ("x",), "…"),
        means=equal(x, 2 * x),
    ),
    "boxes-with-a-uniqueness": Claim(
        "f",
        "One root.",
        Boxes((Bound(lambda s, m: s, box(("1", "2"))),), ("x",), "…"),
        means=AtMostOne(x, -3, 3, equal(x**2, 1)),
    ),
    "denial-with-a-formula": Claim(
        "f", "x is 2x.", Denied((twice,), {"x": fmpq(1)}), means=equal(x, 2 * x)
    ),
    "definition-with-a-formula": Claim("f", equal(y, x + O(x)), Definition(), means=FALSEHOOD),
    "definition-in-words": Claim("f", "y is 2.", Definition(), means=equal(y, 2)),
    "instance-with-a-formula": Claim(
        "f", equal(x, x + O(x)), instance(twice, (x, z)), means=equal(z, 2 * z)
    ),
    # orders beside formulas that have nothing to do with them
    "order-beside-an-identity": order_claim(
        equal(sin(x), O(x**5)), equal(x + x, 2 * x), by(algebra)
    ),
    "order-beside-a-formal-identity": order_claim(
        equal(sin(x), o(x**5)), equal(x + x, 2 * x), Decided()
    ),
    "order-beside-a-true-bound": order_claim(
        equal(sin(x), O(x**5)), Gt(x**2 + 1, 0, evaluate=False), manifest
    ),
    "order-beside-another-order": order_claim(
        equal(sin(x), O(x**5)), order(equal(sin(x), O(x)), x), Decided()
    ),
    "higher-orders-beside-an-identity": order_claim(
        equal(sin(x), 3 * x + HOT), equal(x, x), by(algebra)
    ),
    "order-beside-a-slope-that-is-right": order_claim(
        equal(u, 3 * x + O(x**2)), equal(ONE + 2, 3), by(algebra)
    ),
    "bound-of-another-difference": bounded(equal(sin(x), 3 + O(x)), Remainder(x)),
    "bound-by-a-smaller-gauge": bounded(equal(SUM, O(x**2)), Remainder(x)),
    "bound-with-the-variable-held": bounded(equal(SUM, O(x**2)), Remainder(x, (x,))),
    "bound-with-another-variable": bounded(equal(SUM, O(x**2)), Remainder(y, (x,))),
    "bound-with-a-factor-of-the-order": bounded(equal(SUM, x * O(x)), Remainder(x)),
    "bound-away-from-the-point": bounded(equal(SUM, 2 * O(x)), Remainder(x), "1/2"),
    "bound-for-a-small-order": bounded(equal(SUM, o(x)), Remainder(x)),
    "bound-of-higher-orders-that-are-not": bounded(equal(x**2 + HOT, x + 2 * x**2), Remainder(x)),
    "bound-of-higher-orders-with-a-factor": bounded(equal(HOT * x + 1, 1 + SUM), Remainder(x)),
    "bound-without-a-reading": bounded(equal(SUM, O(x)), None),
    "bound-that-is-no-bound": bounded(
        equal(SUM, O(x**2)), Remainder(x), means=Gt(3 * x, -SUM, evaluate=False)
    ),
    # orders from boxes that do not reach the point
    "boxes-away-from-the-point": Claim(
        "f", small_sine, remainder_boxes("1/2", "1"), kind="order", given=(x >= HALF, x <= 1)
    ),
    "boxes-smaller-than-the-region": Claim(
        "f", small_sine, remainder_boxes("1/2", "1"), kind="order", given=(x >= -1, x <= 1)
    ),
    "boxes-on-one-side": Claim(
        "f",
        equal(x - x**2, x + O(x**4)),
        replace(
            fifth_power,
            bounds=(Bound(lambda s, m: 1 + s**2, box(("-1/2", "1/2")), sufficient=True),),
            constant=fmpq(100),
        ),
        kind="order",
        given=(x >= -HALF / 2, x <= HALF / 2),
    ),
    "boxes-without-an-order": Claim(
        "f", equal(x + x**5, x), fifth_power, kind="order", given=(x >= -HALF / 2, x <= HALF / 2)
    ),
    "boxes-without-a-region": Claim("f", small_sine, remainder_boxes("1/2", "1"), kind="order"),
    "boxes-of-other-coordinates": Claim(
        "f",
        small_sine,
        remainder_boxes("1/2", "1", HALF + x**2 / 4),
        kind="order",
        given=(x >= -1, x <= 1),
    ),
    "boxes-where-something-else-tends": Claim(
        "f", small_sine, remainder_boxes("1/2", "1", x, y), kind="order", given=(x >= HALF, x <= 1)
    ),
    # orders by their own evidence
    "order-with-a-negative-power": Claim("f", order(equal(1 / x, O(ONE)), x), Decided()),
    "order-o-without-a-power": Claim("f", order(equal(x, o(x)), x), Decided()),
    "order-by-a-variable": Claim("f", order(equal(x, O(x**2)), x), Decided()),
    "order-from-the-other-side": Claim("f", order(equal(sqrt(x), O(x)), x, 0, -1), Decided()),
    "order-too-tight": Claim("f", order(equal(2 * x, O(x**2)), x), Decided()),
    # chains
    "chain-empty": says("f", FALSEHOOD, ()),
    "chain-that-ends-elsewhere": says("f", equal(x, x + 1), derived(step(x, algebra))),
    "chain-by-squares": says(
        "f", equal(x, -x), derived(step(equal(x**2, x**2), applying("square")), step(None))
    ),
    "chain-multiplied-by-zero": says(
        "f", equal(x, y), derived(step(equal(ZERO, ZERO), multiplying(ZERO)), step(equal(x, y)))
    ),
    "chain-multiplied-by-what-may-vanish": says(
        "f", equal(x, 1), derived(step(equal(x**2, x), multiplying(x)), step(equal(x, 1))), x >= 0
    ),
    "chain-with-an-undefined-term": says(
        "f",
        Equivalent(equal(x, y), equal(x + 1 / z, y + 1 / z)),
        derived(step(equal(x + 1 / z, y + 1 / z), adding(1 / z))),
        z > -1,
    ),
    "chain-with-a-term-of-one-side": says("f", equal(x, x + 1), by(adding(ONE))),
    "chain-of-matrices": says(
        "f",
        equal(ImmutableMatrix([[x, 0], [0, 1]]), ImmutableMatrix([[x, 0], [0, 2]])),
        by(algebra),
    ),
    "chain-of-a-system": says("f", Tuple(equal(x, x), equal(x, 2 * x)), by(algebra)),
    "chains-for-fewer-parts": says(
        "f", Tuple(equal(x, x), FALSEHOOD), Decided(steps=((step(None),),))
    ),
    "chain-to-an-equivalence": says(
        "f", Equivalent(equal(x**2, 1), equal(x, 1)), derived(step(equal(x, 1), algebra))
    ),
    "chain-with-impossible-conditions": says("f", FALSEHOOD, by(algebra), x > 0, x < -1),
    "chain-with-a-condition-that-is-an-equation": says("f", equal(x, 1), by(algebra), equal(x, 1)),
    "chain-cosine-applied-off-its-range": says("f", x < y, by(applying("cos")), cos(x) > cos(y)),
    "chain-logarithm-of-negatives": says(
        "f", equal(log(x**2), 2 * log(x)), by(exponentials), x < 0
    ),
    "chain-arctangent-of-tangent": says("f", equal(atan(tan(x)), x), by(inverses), x > 2, x < 3),
    "chain-root-of-a-square": says("f", equal(sqrt(x**2), x), by(roots), x > -1),
    "chain-of-a-wrong-trigonometric-identity": says(
        "f", equal(sin(x) ** 2 + cos(x) ** 2, 2), by(trigonometry)
    ),
    # integrals, derivatives and values
    "integral-over-a-pole": says(
        "f", equal(Integral(1 / x**2, (x, -1, 1)), -2), by(integrating(-1 / x))
    ),
    "integral-cut-at-a-pole": says(
        "f",
        equal(
            Integral(1 / (x - 2) ** 2, (x, 0, 1)),
            Integral(1 / (x - 2) ** 2, (x, 0, 3)) + Integral(1 / (x - 2) ** 2, (x, 3, 1)),
        ),
        by(cutting(Integer(3))),
    ),
    "integral-collected-with-its-variable": says(
        "f",
        equal(x * Integral(1, (x, 0, 1)), Integral(x, (x, 0, 1))),
        by(collecting()),
    ),
    "integral-in-a-variable-that-stays": says(
        "f",
        equal(Integral(x, (x, 0, 1)), x),
        derived(step(Integral(x, (u, 0, 1)), changing_variable(x)), step(None)),
    ),
    "integral-differentiated-with-a-wrong-slope": says(
        "f",
        equal(Derivative(Integral(x * p, (x, 0, 1)), p), 1),
        by(differentiating_integral(TWO * x)),
    ),
    "integral-differentiated-at-its-end": says(
        "f",
        equal(Derivative(Integral(x, (x, 0, p)), p), 0),
        by(differentiating_integral(ZERO)),
    ),
    "derivative-of-a-defined-symbol": says(
        "f", equal(Derivative(y, x), 0), by(substituting(square), differentiation)
    ),
    "value-of-a-defined-symbol": says(
        "f", equal(at(y + x, {x: ZERO}), y), by(substituting(square), evaluating)
    ),
    "value-where-there-is-none": Claim(
        "f", Relation(binders.at(as_written("x/x"), {"x": number(0)}), "==", number(1)), Decided()
    ),
    "slope-of-a-root-at-zero": says(
        "f", equal(Subs(Derivative(sqrt(x), x), x, 0), 0), by(differentiation, evaluating)
    ),
    # definitions
    "defined-by-two-values": says(
        "f",
        equal(1, 2),
        derived(
            step(a, substituting(defines("d", equal(a, 1)))),
            step(None, substituting(defines("e", equal(a, 2)))),
        ),
    ),
    "defined-by-itself": says(
        "f", equal(a, a + 1), by(substituting(defines("d", equal(a, a + 1))))
    ),
    "defined-where-it-has-no-value": says(
        "f", FALSEHOOD, by(substituting(defines("d", equal(a, 1 / x))))
    ),
    "defined-by-an-unnamed-assumption": says(
        "f",
        equal(Integral(x, (x, 0, 1)), 2),
        by(substituting(defines("d", equal(Integral(x, (x, 0, 1)), 2)))),
    ),
    "assumed-against-the-truth": says(
        "f",
        equal(Integral(x, (x, 0, 1)), 2),
        by(substituting(defines("d", equal(Integral(x, (x, 0, 1)), 2), assumes="so it is"))),
    ),
    "definition-of-a-sum": defines("f", equal(x + 1, 2)),
    "definition-of-a-number": defines("f", equal(TWO, 3)),
    "definition-that-is-a-bound": defines("f", x > 2),
    "definition-used-without-its-condition": says(
        "f", equal(w * x, 1), by(substituting(reciprocal)), x < 0
    ),
    "root-that-another-claim-has": Claim(
        "f", Tuple(equal(c, 2), c > 0, c < k + 1), at_k, given=(k > 0,)
    ),
    "root-under-other-conditions": Claim("f", at_k.says, at_k, given=(k > -5,)),
    "root-with-a-used-name": said_by("f", Root(k, line), k > 0),
    # roots
    "two-roots-as-one": Claim(
        "f",
        "One root.",
        Decided(),
        expect=Verdict.PROVED,
        given=(k > 0,),
        means=ExactlyOne(x, -3, 3, equal(x**2, 1)),
    ),
    "no-root-as-one": Claim(
        "f",
        "One root.",
        Decided(),
        expect=Verdict.PROVED,
        given=(k > 0,),
        means=ExactlyOne(x, 0, 1, equal(x + 1, 0)),
    ),
    "a-jump-as-a-root": Claim(
        "f",
        "One root.",
        Decided(),
        expect=Verdict.PROVED,
        given=(k > 0,),
        means=ExactlyOne(x, -1, 1, equal(1 / x, 0)),
    ),
    "one-root-at-most-of-a-square": Claim(
        "f",
        "One at most.",
        Monotone(derived(step(2 * x))),
        given=(k > 0,),
        means=AtMostOne(x, -3, 3, equal(x**2, 1)),
    ),
    "one-root-at-most-between-ends-that-move": Claim(
        "f",
        "One at most.",
        Monotone(derived(step(2 * x))),
        given=(k > 0,),
        means=AtMostOne(x, 0, x + 1, equal(x**2, 1)),
    ),
    # numbers, boxes, charts
    "number-with-a-wide-half-unit": Claim(
        "f", "π = 4.00.", Printed(), means=Rounds(pi, "4.00", 200)
    ),
    "number-that-is-off": Claim("f", "π = 3.15.", Printed(), means=Rounds(pi, "3.15")),
    "number-of-what-nothing-defines": Claim("f", "x = 1.", Printed(), means=Rounds(x, "1.0")),
    "number-by-a-false-instance": Claim(
        "f", "y = 1.0.", Printed((y_is_1, y_is_0)), means=Rounds(y, "1.0")
    ),
    "value-on-another-box": says("f", x > 0, Evaluated(), x >= -1, x <= 1),
    "value-on-no-box": says("f", x > 0, Evaluated(), x >= 1),
    "value-of-an-equation": says("f", equal(x, 1), Evaluated(), x >= 0, x <= 2),
    "chart-that-does-not-cover": says(
        "f", x**2 <= x, charted(lambda s, m: s - s * s, ("0", "1")), x > 0, x <= 2
    ),
    "chart-of-another-margin": says(
        "f", x <= 0, charted(lambda s, m: 1 + s, ("0", "1")), x > 0, x <= 1
    ),
    "chart-of-a-false-instance": says(
        "f",
        y <= HALF,
        Charted(
            (On((x,), box(("0", "1")), (Shown(lambda s, m: fmpq(1, 2) + 0 * s),)),), put=(y_is_0,)
        ),
        *(x > 0, x <= 1),
    ),
    "chart-without-a-chart": says("f", x**2 <= x, Charted(()), x > 0, x <= 1),
    # relations decided as they stand
    "decided-of-a-false-claim": says(
        "f", equal(x, x + 1), Decided((says("g", equal(x, x + 1), by(algebra)),))
    ),
    "decided-nothing": Claim("f", "Everything.", Decided()),
    "decided-a-conjunction-under-conditions": says("f", Under(x > 1, Tuple(x > 0)), Decided()),
    "decided-there-is-none": says("f", ForSome(x**2 < 0), Decided()),
    "decided-unequal": says("f", Ne(x, 2), Decided(), x > 0),
    "decided-touching": says("f", x**2 > 0, Decided()),
}

UNFOUNDED: dict[str, Claim] = {
    "a-condition-in-words": Claim("f", FALSEHOOD, Decided(), given=("x > 0",)),
    "a-point-outside-the-conditions": says("f", x > 0, Counterexample({"x": fmpq(-1)}), x > 0),
    "a-point-that-satisfies-it": says("f", x**2 >= 0, Counterexample({"x": fmpq(2)})),
    "a-point-without-a-value": says("f", equal(x / x, 1), Counterexample({"x": fmpq(0)})),
    "a-value-of-what-is-defined": says(
        "f", y >= 0, Counterexample({"x": fmpq(1), "y": fmpq(-1)}, (square,))
    ),
    "a-point-of-smoothness": Claim(
        "f", "x² is smooth.", Counterexample({"x": fmpq(1)}), means=x**2 < 0
    ),
    "a-slope-that-is-not-claimed": order_claim(
        equal(u, 3 * x + O(x**2)), equal(ONE, 2), by(algebra)
    ),
    "a-slope-beside-a-function": order_claim(
        equal(sin(x), x + O(x**3)), equal(x, x + 1), by(algebra)
    ),
    "a-formula-beside-an-order": order_claim(equal(sin(x), O(x)), FALSEHOOD, Decided()),
    "a-path-to-another-point": Claim("f", order(equal(sin(x), O(x)), x), Asymptotics({x: 1 + t})),
    "a-path-outside-the-conditions": Claim(
        "f", order(equal(x * y, O(x)), x), Asymptotics({x: t, y: 1 / t}), given=(y < 1, y > 0)
    ),
    "a-denial-without-a-case": Claim("f", "Something.", Denied((twice,), {})),
    "a-denial-without-a-claim": Claim("f", "Something.", Denied((), {"x": fmpq(1)})),
    "a-denial-by-what-does-not-hold": Claim(
        "f", "Something.", Denied((says("g", equal(x, x + 1), by(algebra)),), {"x": fmpq(1)})
    ),
    "a-conjunction-with-an-unfounded-part": Claim(
        "f", "All.", all_of(says("g", x > 0, Counterexample({"x": fmpq(-1)}), x > 0))
    ),
}


def guarded(name: str, monkeypatch: pytest.MonkeyPatch, *gone: tuple[Any, str, Any]) -> bool:
    """Whether a false claim is still stopped with these guards gone."""
    for where, guard, without in gone:
        monkeypatch.setattr(where, guard, without)
    return not judged(FALSE[name]).verdict.holds


NO_CROSS_CHECK = (judging, "_attacked", lambda claim, finding: finding)
BY_NOTHING = (judging, "refuted_part", lambda claim: None)


@pytest.mark.parametrize(
    ("name", "where", "guard", "without"),
    [
        ("instance-value-of-a-defined-symbol", judging, "dependent", lambda *asked: None),
        ("instance-of-a-root", judging, "dependent", lambda *asked: None),
        ("order-beside-a-true-bound", allowed_evidence, "untied", lambda claim: None),
        ("bound-by-a-smaller-gauge", allowed_evidence, "untied", lambda claim: None),
        ("bound-away-from-the-point", remainders, "unreached", lambda *asked: None),
        ("bound-of-another-difference", remainders, "_equal", lambda *asked: True),
        ("conjunction-with-a-formula", allowed_evidence, "DECIDING", (object,)),
        ("boxes-away-from-the-point", allowed_evidence, "_elsewhere", lambda *asked: None),
        (
            "boxes-where-something-else-tends",
            allowed_evidence,
            "unfit_to_tend",
            lambda *asked: None,
        ),
    ],
)
def test_without_its_guard_a_false_claim_holds(
    name: str, where: Any, guard: str, without: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    gone = (NO_CROSS_CHECK, BY_NOTHING, (where, guard, without))
    assert guarded(name, monkeypatch, *gone[:2])
    assert not guarded(name, monkeypatch, *gone)


@pytest.mark.parametrize(
    "name",
    [
        "instance-value-of-a-defined-symbol",
        "instance-two-variables",
        "instance-of-a-root",
        "instance-through-a-lemma",
        "bound-of-a-defined-symbol-under-an-integral",
    ],
)
def test_the_independent_check_stops_it_without_the_guard(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for where in (judging, integrals):
        monkeypatch.setattr(where, "dependent", lambda *asked: None)
    assert guarded(name, monkeypatch, BY_NOTHING)


def test_there_are_many() -> None:
    assert len(FALSE) + len(UNFOUNDED) >= 120


@pytest.mark.parametrize("name", FALSE)
def test_no_false_claim_holds(name: str) -> None:
    finding = judged(FALSE[name])
    assert not finding.verdict.holds, finding.why


@pytest.mark.parametrize("name", UNFOUNDED)
def test_no_unfounded_refutation_stands(name: str) -> None:
    assert judged(UNFOUNDED[name]).verdict is Verdict.UNDECIDED


SECRETS = [
    equal(sin(pi * whole) + whole, whole),
    equal(Abs(hidden), hidden),
    equal(Symbol("x", positive=True), x),
    Gt(Symbol("a", positive=True), 1, evaluate=False),
    whole**2 >= whole,
]


@pytest.mark.parametrize("written", SECRETS, ids=str)
def test_what_sympy_assumes_of_a_symbol_is_no_condition(written: Any) -> None:
    with pytest.raises(InputError, match="SymPy assumes more"):
        says("f", written, Decided())


def test_a_condition_is_a_relation() -> None:
    with pytest.raises(InputError, match="Or is outside"):
        Claim("f", FALSEHOOD, Decided(), given=(Or(x > 0, y > 0),))
