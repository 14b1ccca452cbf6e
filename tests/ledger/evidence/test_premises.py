"""Derivations of the ledger, and the conditions of what they use: no falsehood is proved."""

import pytest
from derivations import by, derived, manifest, step
from sympy import (
    Abs,
    Basic,
    Derivative,
    Eq,
    Equivalent,
    Ge,
    Gt,
    ImmutableMatrix,
    Integer,
    Integral,
    Lt,
    Matrix,
    Subs,
    Symbol,
    cos,
    cosh,
    exp,
    log,
    sin,
    sinh,
    sqrt,
)
from sympy_statements import equal

from tresym.ledger.claim import (
    Claim,
    Definition,
    Reason,
)
from tresym.ledger.conversion import conditions, definitions, formula
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.integrals import NotShownError
from tresym.ledger.evidence.premises import instantiated, unmet_condition
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import (
    adding,
    algebra,
    applying,
    differentiation,
    evaluating,
    exponentials,
    multiplying,
    roots,
    substituting,
    trigonometry,
)
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

x, y, z = (Symbol(name, real=True) for name in "xyz")


def proved(says: Basic, proof: Decided, given: tuple[Basic, ...] = ()) -> bool:
    """Whether a claim holds if all that it uses does."""
    claim = Claim("asked", says, proof, given=given)
    found = {used.label: Finding(Verdict.PROVED, "assumed") for used in claim.rests_on}
    return judge(claim, found).verdict.holds


square = Claim("square", equal(y, x**2), Definition())
positive_x = Claim("positive_x", equal(z, sqrt(x)), Definition(), given=(x > 0,))

# a statement, a reason that proves it, conditions; and a near falsehood
STEPS: list[tuple[Basic, Reason, tuple[Basic, ...], Basic]] = [
    (equal((x + 1) ** 2, x**2 + 2 * x + 1), algebra, (), equal((x + 1) ** 2, x**2 + 2 * x)),
    (equal(sin(2 * x), 2 * sin(x) * cos(x)), trigonometry, (), equal(sin(2 * x), sin(x) * cos(x))),
    (equal(sqrt(x**2 + 2 * x + 1), Abs(x + 1)), roots, (), equal(sqrt(x**2 + 2 * x + 1), x + 1)),
    (equal(exp(x + 1), exp(x) * exp(1)), exponentials, (), equal(exp(x + 1), exp(x) + exp(1))),
    (equal(cosh(x) ** 2 - sinh(x) ** 2, 1), exponentials, (), equal(cosh(x) ** 2, sinh(x) ** 2)),
    (equal(Derivative(x**3, x), 3 * x**2), differentiation, (), equal(Derivative(x**3, x), x**2)),
    (equal(Subs(x**2, x, 3), 9), evaluating, (), equal(Subs(x**2, x, 3), 6)),
    (equal(y + 1, x**2 + 1), substituting(square), (), equal(y + 1, x**2)),
    (equal(x / x**2, 1 / x), algebra, (x > 0,), equal(x / x**2, 1 / x**2)),
]


@pytest.mark.parametrize(("true", "reason", "given", "_"), STEPS, ids=[str(s[0]) for s in STEPS])
def test_a_reason_proves_its_step(
    true: Basic, reason: Reason, given: tuple[Basic, ...], _: Basic
) -> None:
    assert proved(true, by(reason), given)


@pytest.mark.parametrize(("_", "reason", "given", "false"), STEPS, ids=[str(s[3]) for s in STEPS])
def test_a_near_falsehood_is_not_proved(
    _: Basic, reason: Reason, given: tuple[Basic, ...], false: Basic
) -> None:
    assert not proved(false, by(reason, trigonometry, roots, exponentials), given)


def test_every_link_and_the_arrival_are_checked() -> None:
    says = equal(sin(x) ** 2 + cos(x) ** 2 + x, 1 + x)
    assert proved(says, derived(step(1 + x, trigonometry)))
    assert not proved(says, derived(step(2 + x, trigonometry)))
    assert not proved(says, derived(step(2 + x, trigonometry), step(1 + x, algebra)))
    assert not proved(equal(x, 2 * x), derived(step(x, algebra)))
    assert not proved(says, ())


UNDEFINED = [
    (equal(1 + 1 / (x + 1), (x + 2) / (x + 1)), (), False),
    (equal(1 + 1 / (x + 1), (x + 2) / (x + 1)), (x > 0,), True),
    (equal(log(2 * x), log(2) + log(x)), (x >= 0,), False),
    (equal(log(2 * x), log(2) + log(x)), (x > 0,), True),
    (equal(sqrt(x**3), x * sqrt(x)), (), False),
    (equal(sqrt(x**3), x * sqrt(x)), (x >= 0,), True),
]


@pytest.mark.parametrize(("says", "given", "found"), UNDEFINED, ids=str)
def test_operations_must_be_shown_harmless(
    says: Basic, given: tuple[Basic, ...], found: bool
) -> None:
    assert proved(says, by(roots, exponentials), given) is found


def _from(before: Basic, after: Basic, reason: Reason, given: tuple[Basic, ...] = ()) -> bool:
    """One step of equations, as part of an equivalence."""
    return proved(Equivalent(before, after), derived(step(after, reason)), given)


@pytest.mark.parametrize(
    ("before", "after", "reason", "given", "found"),
    [
        (Eq(x, y), Eq(2 * x, 2 * y), multiplying(x / x * 2), (), True),
        (Eq(x, y), Eq(x * z, y * z), multiplying(z), (z > 0,), True),
        (Eq(x, y), Eq(x * z, y * z), multiplying(z), (), False),
        (Eq(x, y), Eq(x + z, y + z), adding(z), (), True),
        (Eq(x, y), Eq(x + z, y - z), adding(z), (), False),
        (Eq(x, y), Eq(exp(x), exp(y)), applying("exp"), (), True),
        (Eq(x, y), Eq(x**2, y**2), applying("square"), (x > 0, y > 0), True),
        (Eq(x, y), Eq(x**2, y**2), applying("square"), (x > 0,), False),
        (Eq(x, y), Eq(x**2, y**2), applying("square"), (x > 0, y < 0), False),
        (Eq(x, y), Eq(x**2, y**2), applying("square"), (x >= 0, y <= 0), False),
        (Eq(x, y), Eq(x**2, y**2), applying("square"), (x > 0, y <= 0), False),
        (Eq(x, y), Eq(log(x), log(y)), applying("log"), (x > 0, y > 0), True),
        (Eq(x, y), Eq(log(x), log(y)), applying("log"), (x >= 0, y >= 0), False),
        (Eq(x, y), Eq(sin(x), sin(y)), applying("sin"), (), False),
        (Eq(x, y), Eq(cosh(x), cosh(y)), applying("cosh"), (), False),
    ],
    ids=str,
)
def test_equations_are_kept_by_what_is_one_to_one(
    before: Basic, after: Basic, reason: Reason, given: tuple[Basic, ...], found: bool
) -> None:
    assert _from(before, after, reason, given) is found


@pytest.mark.parametrize(
    ("says", "given", "found"),
    [
        (Ge(x**2 + 1, 2 * x), (), True),
        (Gt(x**2 + 1, 2 * x), (), False),
        (Gt(x**2 + 2, 2 * x), (), True),
        (Lt(2 * x, x**2 + 2), (), True),
        (Gt(x, y), (), False),
        (Gt(x * y, 0), (x > 0, y > 0), True),
        (Gt(x**2, y**2), (x > y, y > 0), True),
    ],
    ids=str,
)
def test_an_inequality_is_proved_where_it_holds(
    says: Basic, given: tuple[Basic, ...], found: bool
) -> None:
    assert proved(says, manifest, given) is found


def test_a_monotone_function_keeps_or_turns_an_inequality_on_its_interval() -> None:
    inside = (x >= 0, y > x, y <= 1)
    chain = derived(step(cos(x) - cos(y), applying("cos")))
    assert not proved(Gt(x, y), chain, inside)
    assert not proved(Gt(y, x), derived(step(cos(y) - cos(x), applying("cos"))), inside)
    outside = Gt(Integer(1), Integer(7), evaluate=False)  # cos 7 > cos 1, beyond pi
    assert not proved(outside, derived(step(cos(7) - cos(1), applying("cos"))))
    for name in ("square", "tan", "abs"):
        assert not proved(Gt(y, x), derived(step(y - x, applying(name))), inside)


def test_matrices_entry_by_entry() -> None:
    two, other = Matrix([x + x, 1]), Matrix([2 * x, 1])
    assert proved(Eq(two, other, evaluate=False), by(algebra))
    assert not proved(Eq(two, Matrix([3 * x, 1]), evaluate=False), by(algebra))
    with pytest.raises(InputError, match="different sizes"):
        proved(equal(Matrix([x]), Matrix([[x, x]])), by(algebra))
    with pytest.raises(InputError, match="outside the expressions"):
        derived(step(ImmutableMatrix([x, x]), algebra))


def test_what_is_put_in_brings_its_conditions() -> None:
    rules = definitions((positive_x,))
    assert unmet_condition(positive_x, rules, ()) == formula(x > 0)
    for enough in (x > 0, x > 1):
        assert unmet_condition(positive_x, rules, conditions((enough,))) is None
    assert not proved(equal(z**2, x), by(substituting(positive_x), roots))
    assert proved(equal(z**2, x), by(substituting(positive_x), roots), (x > 0,))


positive = Claim("positive", equal(y, Abs(y)), by(roots), given=(y >= 0,))
root = Claim("root", equal(x, sqrt(x**2)), by(roots), given=(x >= 0,))
LENT = {
    "its own": (equal(y, Abs(y)), (positive,), ()),
    "its own, against what is given": (equal(y, Abs(y)), (positive,), (y < 0,)),
    "its own, in a product": (equal(x * y, x * Abs(y)), (positive,), (y < 0,)),
    "its own root": (equal(x, sqrt(x**2)), (root,), (x < 0,)),
    "that of another that waits": (
        equal(z, Abs(x)),
        (
            Claim("one", equal(z, Abs(z)), by(roots), given=(z >= 0,)),
            Claim("two", equal(z, x), by(), given=(z >= 0, z**2 - x**2 <= 0)),
        ),
        (),
    ),
}


@pytest.mark.parametrize(("says", "used", "given"), LENT.values(), ids=LENT)
def test_no_claim_shows_its_own_condition(
    says: Basic, used: tuple[Claim, ...], given: tuple[Basic, ...]
) -> None:
    with pytest.raises(NotShownError):
        instantiated(used, conditions(given))
    assert not proved(says, by(substituting(*used)), given)


def test_a_condition_is_shown_by_what_a_definition_says() -> None:
    above = Claim("above", equal(sqrt(y**2), y), by(roots), given=(y >= 0,))
    says = equal(sqrt(y**2), x**2)
    for used in ((square, above), (above, square)):
        assert proved(says, by(substituting(*used)))
    assert not proved(says, by(substituting(above)))


def test_an_integral_is_not_opened_by_algebra() -> None:
    assert not proved(equal(Integral(x, (x, 0, 1)), Integral(x, (x, 0, 2))), by(algebra))
    assert proved(equal(Integral(x, (x, 0, 1)), Integral(y, (y, 0, 1))), by(algebra))


# A step that names no form: an inequality whose sign is proven with what its reasons put in.
# What is said, the reasons that are needed, conditions; and a falsehood
SIGNS: list[tuple[Basic, tuple[Reason, ...], tuple[Basic, ...], Basic]] = [
    (Gt(x**2 + 1, 2 * x - 1), (), (), Gt(x**2 + 1, 2 * x)),
    (Ge(y, 0), (substituting(square),), (), Gt(y, 0)),
    (Gt(z + 1, 1), (substituting(positive_x),), (x > 0,), Gt(z, 1)),
    (Gt(Derivative(x**3, x), 0), (differentiation,), (x > 0,), Gt(Derivative(x**3, x), x)),
    (Lt(Subs(x**2, x, 2), 5), (evaluating,), (), Lt(Subs(x**2, x, 3), 5)),
]


@pytest.mark.parametrize(("true", "why", "given", "false"), SIGNS, ids=[str(s[0]) for s in SIGNS])
def test_a_sign_is_proven_with_what_its_reasons_put_in(
    true: Basic, why: tuple[Reason, ...], given: tuple[Basic, ...], false: Basic
) -> None:
    assert proved(true, by(*why), given)
    assert not proved(false, by(*why), given)


def test_a_sign_needs_both_sides_defined_and_what_is_used_its_conditions() -> None:
    assert proved(Ge(sqrt(x), 0), manifest, (x >= 0,))
    assert not proved(Ge(sqrt(x), 0), manifest)
    assert not proved(Gt(z + 1, 0), by(substituting(positive_x)), (x >= 0,))
