"""Bounds that are decided as they stand, over the box that the conditions are."""

from functools import partial

import pytest
from flint import fmpq
from sympy import (
    Basic,
    Eq,
    Ge,
    Gt,
    Integer,
    Integral,
    Le,
    Lt,
    Ne,
    Rational,
    Symbol,
    Tuple,
    exp,
    sqrt,
)
from sympy_statements import AtMostOne, TheRoot

from tresym.ledger.claim import (
    Claim,
    label_claims,
)
from tresym.ledger.evidence.interval_evaluation import Evaluated, judge_evaluated
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

equal = partial(Eq, evaluate=False)

x, y, z = (Symbol(name, real=True) for name in "xyz")
UNIT = (x >= 0, x <= 1)
AREA = Integral(exp(x * y), (y, 0, 1))
"""(eˣ − 1)/x."""
END = AREA.xreplace({x: 1})


def found(says: Basic, *given: Basic, claims: tuple[Claim, ...] = ()) -> Finding:
    holds = {claim.label: Finding(claim.expect, "") for claim in claims}
    return judge(Claim("bound", says, Evaluated(claims), given=given), holds)


def verdict(says: Basic, *given: Basic) -> Verdict:
    return found(says, *given).verdict


def test_what_holds_on_all_of_the_box_is_enclosed() -> None:
    assert verdict(Rational("1.72") > AREA, *UNIT) is Verdict.ENCLOSED
    assert verdict(Tuple(AREA < 2, Rational("0.99") < AREA), *UNIT) is Verdict.ENCLOSED
    assert verdict(Gt(END, Rational("1.7182"), evaluate=False)) is Verdict.ENCLOSED
    assert verdict(AREA < 2, equal(x, 1)) is Verdict.ENCLOSED


def test_what_fails_somewhere_is_refuted_there() -> None:
    refuted = found(Rational("1.71") > AREA, *UNIT)
    assert refuted.verdict is Verdict.REFUTED
    assert refuted.witness is not None
    assert fmpq(99, 100) < refuted.witness["x"] <= 1
    assert verdict(Tuple(AREA < 2, Rational("1.01") < AREA), *UNIT) is Verdict.REFUTED
    assert verdict(Gt(END, Rational("1.7183"), evaluate=False)) is Verdict.REFUTED
    assert verdict(AREA < 2, equal(x, 2)) is Verdict.REFUTED


@pytest.mark.parametrize(
    ("says", "given"),
    [
        (AREA < 2, (x >= 0,)),
        (AREA < 2, ()),
        (AREA < 2, (x >= 1, x <= 0)),
        (AREA < 2, (*UNIT, x > 2)),
        (AREA < 2, (*UNIT, equal(x, 0))),
        (AREA < 2, (*UNIT, z >= 0, z <= 1)),
        (equal(AREA, AREA), UNIT),
        (sqrt(x - 1) > -1, UNIT),
        (1 / (x - Rational(1, 2)) ** 2 > 0, UNIT),
        (Integral(1 / y, (y, x, 1)) > -1, UNIT),
        (x**2 >= 0, UNIT),
    ],
)
def test_nothing_is_decided_off_a_box_nor_of_what_is_undefined(
    says: Basic, given: tuple[Basic, ...]
) -> None:
    assert verdict(says, *given) is Verdict.UNDECIDED


def test_what_is_equal_is_not_larger_and_not_refuted() -> None:
    one = Integer(1)
    for relation in (Gt, Lt, Ge, Le):
        assert verdict(relation(one, one, evaluate=False)) is Verdict.UNDECIDED
        assert verdict(relation(AREA, AREA, evaluate=False), *UNIT) is Verdict.UNDECIDED


def test_the_first_bound_of_a_symbol_counts_with_those_behind_it() -> None:
    half = Rational(1, 2)
    assert verdict(Rational("1.2") < AREA, x >= half, x <= 1, x >= 0) is not Verdict.REFUTED
    assert verdict(Rational("1.3") > AREA, x >= 0, x <= half, x <= 1) is not Verdict.REFUTED
    for given in ((*UNIT, x**2 <= 2), (*UNIT, x >= y), (*UNIT, y >= x)):
        assert verdict(AREA < 2, *given) in (Verdict.ENCLOSED, Verdict.UNDECIDED)


def test_only_bounds_are_decided() -> None:
    """5 more is more, and so it is not equal; neither is shown by one being larger."""
    for says in (equal(AREA + 5, AREA), Ne(AREA, 5)):
        claim = Claim("bound", says, Evaluated(), given=UNIT)
        with pytest.raises(InputError, match="is not an inequality with"):
            judge_evaluated(claim, claim.proof)


def test_a_root_has_a_value_where_a_claim_says_that_it_is_one() -> None:
    where = y, 0, 2, equal(y**2, x)
    one = Claim(says="One.", means=AtMostOne(*where), given=(x > 0,))
    label_claims({"one": one})
    root = TheRoot(*where)
    inside = (x >= 1, x <= 2)
    assert found(root < Rational("1.415"), *inside, claims=(one,)).verdict is Verdict.ENCLOSED
    assert found(root < Rational("1.414"), *inside, claims=(one,)).verdict is Verdict.REFUTED
    assert found(root < Rational("1.415"), *inside).verdict is Verdict.UNDECIDED
    assert found(root < 2, *UNIT, claims=(one,)).verdict is Verdict.UNDECIDED
