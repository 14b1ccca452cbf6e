"""What a point denies, and that a denial is worth what the claims it rests on are worth."""

from derivations import by
from flint import fmpq
from sympy import Equivalent, Symbol, Tuple, sqrt
from sympy_statements import ExactlyOne, Under, equal

from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.evidence.at_point import place_of
from tresym.ledger.evidence.refutation import Denied, denied_at, denied_somewhere, not_denied
from tresym.ledger.formulas import in_trees
from tresym.ledger.judge import judge
from tresym.ledger.reasons import roots
from tresym.reals.verdict import Verdict

x, y = (Symbol(name, real=True) for name in "xy")
CASE = {"x": fmpq(1)}
HERE = place_of(CASE, ())
RIGHT = Claim("right", equal(sqrt(x**2), x), by(roots), given=(x > 0,))
WRONG = Claim("wrong", equal(sqrt(x**2), x), by(roots))


def verdict(*claims: Claim, case: dict[str, fmpq] | None = None) -> Verdict:
    found = {claim.label: judge(claim, {}) for claim in claims}
    denial = Claim("never", "It never happens.", Denied(claims, CASE if case is None else case))
    return judge(denial, found).verdict


def test_an_instance_that_holds_denies() -> None:
    assert verdict(RIGHT) is Verdict.REFUTED


def test_nothing_is_denied_by_what_does_not_hold() -> None:
    assert verdict(WRONG) is Verdict.UNDECIDED
    assert verdict(RIGHT, WRONG) is Verdict.UNDECIDED


def test_a_denial_needs_a_claim_and_a_case() -> None:
    assert verdict() is Verdict.UNDECIDED
    assert verdict(RIGHT, case={}) is Verdict.UNDECIDED


def test_a_point_denies_the_part_that_fails_after_what_holds_there() -> None:
    over = Under(x > 3, Tuple(equal(x, 1)))
    one, above, positive = map(in_trees, (equal(x, 1), x > 3, x > 0))
    found = {
        over: ((one,), above),
        Tuple(x > 0, over): ((one,), above),
        Equivalent(x > 0, x > 3): ((positive,), above),
        Equivalent(x > 3, x > 0): ((positive,), above),
    }
    for says, expected in found.items():
        assert denied_at(in_trees(says), HERE) == expected
    for held in (x > 0, Under(x > 3, Tuple(x > 2)), Equivalent(x > 3, x > 4), Tuple()):
        assert denied_at(in_trees(held), HERE) is None


def test_what_is_denied_is_a_formula_where_all_its_conditions_hold() -> None:
    planted = Claim("planted", x > 3, by(), given=(x > 0, x < 2))
    assert not_denied(planted, CASE) is None
    assert (
        not_denied(planted, {"x": fmpq(3)}) == "could not confirm the condition x < 2 at the point"
    )
    assert (
        not_denied(planted, {"x": fmpq(-1)}) == "could not confirm the condition x > 0 at the point"
    )
    words = Claim("words", "It is more than three.", by())
    assert not_denied(words, CASE) == "the claim has no formula, so a point cannot contradict it"
    for given in ((x > 0, x > 2), (x > 2, x > 0)):
        assert denied_at(Under(x > 3, Tuple(*given)), HERE) is None


def test_a_point_is_looked_for_that_denies() -> None:
    found = denied_somewhere(Claim("planted", x**2 < 5, by(), given=(x > 1, x < 3)))
    assert found is not None
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    assert 5 <= found.witness["x"] ** 2 < 9
    assert denied_somewhere(Claim("right", x**2 < 9, by(), given=(x > 1, x < 3))) is None


def test_a_point_denies_nothing_of_other_symbols_nor_of_what_has_no_value() -> None:
    for says in (y > 2, Tuple(x > 0, y > x), Under(x > 3, Tuple(y > 0)), sqrt(-x) > 5):
        assert denied_at(says, HERE) is None
    assert denied_at(ExactlyOne(x, 0, 1, equal(x, 2)), HERE) is None
