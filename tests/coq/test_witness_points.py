"""Points of which Coq is told: all variables have values, the defect lies between decimals."""

from fractions import Fraction

from flint import fmpq
from tresym.proofs.coq_numbers import between

from tresym.coq.ledger_statements import theorem_of
from tresym.coq.statement import Theorem
from tresym.coq.witness_points import chosen, point_proofs
from tresym.ledger.paper import all_claims
from tresym.racket.flip.separatrix import solve
from tresym.reals.numbers.arithmetic import ball_precision


def test_the_defect_lies_between() -> None:
    a, b = fmpq(25, 2), fmpq(1, 16)
    low, high = (
        Fraction(int(t[1:].split(" / ")[0]), 10 ** int(t[:-1].split("^ ")[1]))
        for t in between(a, b)
    )
    defect = solve(a, b, 40).defect
    with ball_precision(200):
        assert fmpq(low.numerator, low.denominator) < defect
        assert defect < fmpq(high.numerator, high.denominator)
    assert high - low < low / 10**15


def test_a_witness_satisfies_what_it_is_not_told() -> None:
    claim = next(c for c in all_claims() if c.label == "wilson_b")
    whole = theorem_of(claim)
    assert isinstance(whole, Theorem)
    values = chosen(whole, {"I2": fmpq(819, 50000), "I3": fmpq(437, 25000)}, "")
    assert values["I1"].args[0] < fmpq(819, 50000)  # the least moment, which nobody gave
    assert "exists" in next(point_proofs(claim, whole))
