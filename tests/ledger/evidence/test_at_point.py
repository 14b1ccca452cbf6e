"""Values of defined symbols at exact points."""

from functools import partial

import pytest
from derivations import by
from flint import arb, fmpq
from sympy import Eq, Symbol
from sympy_statements import AtMostOne, TheRoot
from tresym.proofs import near, separatrix

from tresym.ledger.claim import (
    Claim,
    Counterexample,
    Definition,
)
from tresym.ledger.evidence.at_point import place_of
from tresym.ledger.judge import judge_evidence
from tresym.racket.flip.separatrix import solve
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

equal = partial(Eq, evaluate=False)

x, y = (Symbol(name, real=True) for name in "xy")
SHAPES = [(fmpq(1, 4), fmpq(1)), (fmpq(400), fmpq(1, 2)), (fmpq(1, 100), fmpq(9, 10))]


@pytest.mark.parametrize(("a", "b"), SHAPES)
def test_the_flip_defect_is_the_root(a: fmpq, b: fmpq) -> None:
    with ball_precision(256):
        claims = (
            *separatrix.flip_defect.rests_on,
            separatrix.flip_defect,
            near.leading_term,
            near.first_coefficient,
        )
        found = place_of({"a": a, "b": b}, claims)
        exact = solve(a, b, 50).defect
        assert found["epsilon0"].overlaps(exact)
        assert abs(found["epsilon0"] / exact - 1) < 1e-30
        assert found["c1"].overlaps(arb((6 * b - 1 + 3 * b / a) / 12))


def test_what_is_defined_has_no_other_value() -> None:
    point = {"a": fmpq(1, 4), "b": fmpq(1), "epsilon0": fmpq(100)}
    with ball_precision(128):
        claims = (*separatrix.flip_defect.rests_on, separatrix.flip_defect)
        assert place_of(point, claims)["epsilon0"] < 2
    outside = place_of({"a": fmpq(1, 4), "b": fmpq(2)}, claims)
    assert not outside["epsilon0"].is_finite()


def test_a_point_denies_with_what_is_defined_there() -> None:
    twice = Claim("twice", equal(y, 2 * x), Definition(), given=(x > 0,))
    point = Counterexample({"x": fmpq(1)}, (twice,))
    assert judge_evidence(Claim("c", y < 2, point, given=(x > 0,))).verdict is Verdict.REFUTED
    for says, at in ((y <= 2, point), (y < 2, Counterexample({"y": fmpq(3)}, (twice,)))):
        assert judge_evidence(Claim("c", says, at)).verdict is Verdict.UNDECIDED
    outside = Counterexample({"x": fmpq(-1)}, (twice,))
    assert judge_evidence(Claim("c", y > 0, outside)).verdict is Verdict.UNDECIDED
    assert judge_evidence(Claim("c", y > 0, outside, given=(x > 0,))).verdict is Verdict.UNDECIDED


def test_a_point_denies_nothing_of_a_root_that_may_be_one_of_many() -> None:
    many, one = equal(y**3, 4 * x * y), equal(y**3, 2 - x * y)
    for equation, used, expected in (
        (many, (), Verdict.UNDECIDED),
        (one, (), Verdict.UNDECIDED),
        (one, (Claim("one", AtMostOne(y, -3, 3, one), by()),), Verdict.REFUTED),
        (one, (Claim("one", AtMostOne(y, -3, 3, one), by(), given=(x > 5,)),), Verdict.UNDECIDED),
    ):
        claim = Claim("c", TheRoot(y, -3, 3, equation) > 2, Counterexample({"x": fmpq(1)}, used))
        assert judge_evidence(claim).verdict is expected
