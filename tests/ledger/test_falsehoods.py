"""False claims of every kind that the judge has once let pass: none of them holds."""

from typing import Any

import pytest
from derivations import by, derived, step
from sympy import (
    Abs,
    Basic,
    Derivative,
    Integral,
    Rational,
    Symbol,
    asin,
    atanh,
    cos,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
    tan,
)
from sympy_statements import equal

from tresym.ledger.claim import (
    Claim,
    Definition,
    Instance,
    all_of,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import (
    algebra,
    applying,
    changing_variable,
    citing,
    collecting,
    differentiation,
    exponentials,
    integrating,
    inverses,
    roots,
    substituting,
    trigonometry,
)
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.quick

x, y, z, a, b, c, u, v, k, m = (Symbol(name, real=True) for name in "xyzabcuvkm")


def defined(label: str, says: Basic, assumes: str = "", given: tuple[Any, ...] = ()) -> Claim:
    return Claim(says=says, given=given, proof=Definition(assumes=assumes), label=label)


half = defined("half", equal(a, Rational(1, 2)))
small = Claim(says=a < 1, proof=by(substituting(half)), label="small")
positive = Claim(says=a > 0, proof=by(substituting(half)), label="positive")
one, two = defined("one", equal(b, 1)), defined("two", equal(b, 2))
there, back = defined("there", equal(c, v)), defined("back", equal(v, c + 1))
to_k = Integral(x, (x, 0, k))
first, second = defined("first", equal(to_k, 2), "two"), defined("second", equal(to_k, 8), "eight")
never = defined("never", equal(Integral(exp(x), (x, 0, k)), -3), "less than nothing", (k > 0,))
third = defined("third", equal(Integral(x**2, (x, 0, 1)), m), "m is a third")
whole = defined("whole", equal(m, 1))
root = Claim(says=equal(sqrt(y**2), y), given=(y > 0,), proof=by(roots), label="root")
logarithm = defined("logarithm", equal(u, log(y)), given=(y > 0,))
mixed = Claim(says=a + x < 1 + x, proof=by(substituting(half)), label="mixed")
product = Claim(
    says=equal(sqrt(x**2) * sqrt(y**2), x * y),
    given=(x > 0, y > 0),
    proof=by(roots),
    label="product",
)
sure = Claim(says=equal(1, 1), proof=by(algebra), label="sure")
wrong = Claim(says=equal(x, x + 1), proof=by(algebra), label="wrong")

unit = (x, 0, 1)


def over(f: Any, *limits: Any) -> Integral:
    return Integral(f, *limits)


FALSE: list[tuple[Any, Any, tuple[Any, ...]]] = [
    # the old variable is free in the new integrand
    (equal(over(x, (x, 0, 2)), 2 * x), derived(step(over(x, (y, 0, 2)), changing_variable(x))), ()),
    (
        equal(over(exp(x), unit), over(exp(x), (y, 0, 1))),
        by(changing_variable(x)),
        (),
    ),
    (
        equal(over(2 * x, unit), over(2 * x, (u, 0, 1))),
        by(changing_variable(x)),
        (),
    ),
    (
        equal(over(x**2, unit), over(x / 2, (u, 0, 1))),
        by(changing_variable(x**2)),
        (),
    ),
    (
        equal(over(cos(x), unit), over(2, (u, 0, sin(1)))),
        by(changing_variable(sin(x))),
        (),
    ),
    # a free symbol is captured
    (equal(over(x * y, unit), x * over(y, unit)), by(collecting()), ()),
    (equal(over(x**2, unit), x * over(x, unit)), by(collecting()), ()),
    (equal(x * over(x, unit), over(x**2, unit)), by(collecting()), ()),
    (equal(x * over(1, unit), over(x, unit)), by(collecting()), ()),
    (
        equal(over(y * sin(x), (y, 0, x)), sin(y) * over(y, (y, 0, x))),
        by(collecting()),
        (),
    ),
    (equal(over(x, unit), over(x, (x, 0, 2))), by(collecting()), ()),
    # a bound on what is defined, under a binder; and poles
    (
        equal(over((1 - a) ** -2, (a, 0, 2)), -2),
        by(integrating(1 / (1 - a)), citing(small)),
        (),
    ),
    (over(1 - a, (a, 0, b)) > 0, by(citing(small)), (b > 9,)),
    (over(a, (a, -b, 1)) > 0, by(citing(positive)), (b > 2,)),
    (1 - a > 0, by(citing(small)), (a > 5,)),
    (a > 0, by(citing(positive)), (a < -1,)),
    (equal(over(x**-2, (x, -1, 1)), -2), by(integrating(-1 / x)), ()),
    (equal(over(1 / x, (x, -1, 2)), log(2)), by(integrating(log(Abs(x)))), ()),
    (equal(over(sign(x), (x, -1, 2)), 1), by(integrating(Abs(x))), ()),
    (
        equal(over((x - 1) ** -2, (x, 0, 3)), -Rational(3, 2)),
        by(integrating(1 / (1 - x))),
        (),
    ),
    (
        equal(over(1 / (1 + cos(x)), (x, 0, 2 * pi)), 0),
        by(integrating(tan(x / 2))),
        (),
    ),
    (equal(over(1 / sqrt(x), (x, -1, 1)), 2), by(integrating(2 * sqrt(x))), ()),
    # two definitions of one symbol, circles, equations that nothing solves
    (equal(1, 2), derived(step(b, substituting(one)), step(None, substituting(two))), ()),
    (equal(c, c + 1), derived(step(v, substituting(there)), step(None, substituting(back))), ()),
    (equal(2, 8), derived(step(to_k, substituting(first)), step(None, substituting(second))), ()),
    (k < 0, by(substituting(never)), (k > 0,)),
    (
        equal(over(x**2, unit), 1),
        derived(step(m, substituting(third)), step(None, substituting(whole))),
        (),
    ),
    # conditions that are dropped
    (equal(sqrt(y**2), y), by(citing(root)), (y < 0,)),
    (equal(sqrt(y**2), y), by(substituting(root)), (y < 0,)),
    (equal(sqrt(z**2), z), Instance(root, ((y, z),)), (z < 0,)),
    (equal(exp(u), y), by(substituting(logarithm), exponentials), (y < 0,)),
    (equal(Derivative(log(x), x), 1 / x), by(differentiation), (x < 0,)),
    (equal(Derivative(sqrt(x**2), x), 1), by(differentiation, roots), ()),
    (equal(Derivative(atanh(x), x), 1 / (1 - x**2)), by(differentiation), (x > 1,)),
    (equal(asin(sin(x)), x), by(trigonometry, inverses), ()),
    (equal(sqrt(x) * sqrt(y), -sqrt(x * y)), by(roots), (x > 0, y > 0)),
    # an instance at a symbol that is defined beside one that is not; a second condition not met
    (z + y < 1 + y, Instance(mixed, ((a, z), (x, y))), (z > 9,)),
    (equal(sqrt(z**2) * sqrt(u**2), z * u), Instance(product, ((x, z), (y, u))), (z > 0, u < 0)),
    (equal(sqrt(z**2) * sqrt(u**2), z * u), Instance(product, ((x, z), (y, u))), (z < 0, u > 0)),
    # evidence for something else
    (equal(1, 2), all_of(sure), ()),
    ("Every body turns over.", Decided((wrong,)), ()),
    (equal(x, x + 1), Decided((sure,)), ()),
    (equal(x, x + 1), Decided((wrong,)), ()),
    ("Every body turns over.", all_of(sure, wrong), ()),
    (equal(x, 2 * x), by(algebra), (x > 0,)),
    # signs and functions that are applied to both sides
    (x**2 > 0, derived(step(None)), ()),
    (sin(x) > 0, derived(step(None)), (x > 0,)),
    (cos(x) < cos(y), by(applying("sin")), (x > 0, y > x)),
    (equal(x, y), derived(step(equal(x**2, y**2), applying("square")), step(None)), ()),
]


@pytest.mark.parametrize(
    ("says", "proof", "given"), FALSE, ids=[f"{n}-{part[0]}" for n, part in enumerate(FALSE)]
)
def test_it_does_not_hold(says: Any, proof: Any, given: tuple[Any, ...]) -> None:
    claim = Claim(says=says, given=given, proof=proof, label="false")
    found: dict[str, Finding] = {}
    for used in claim.rests_on:
        found[used.label] = judge(used, found)
    assert judge(claim, found).verdict in (Verdict.UNDECIDED, Verdict.REFUTED)


def test_what_is_no_evidence_is_none() -> None:
    class Sure:
        claims = ()

        def judge(self) -> Finding:
            return Finding(Verdict.PROVED, "it says so itself")

    claim = Claim(says=equal(0, 1), proof=Sure(), label="zero")  # type: ignore[arg-type]
    assert judge(claim, {}).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("claim", [mixed, product, root, small, positive], ids=lambda c: c.label)
def test_what_they_are_made_of_holds(claim: Claim) -> None:
    found: dict[str, Finding] = {}
    for used in claim.rests_on:
        found[used.label] = judge(used, found)
    assert judge(claim, found).verdict is Verdict.PROVED
