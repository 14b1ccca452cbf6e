"""What is constant along the solutions of a system, and what is not."""

from dataclasses import replace

import pytest
from flint import arb

from tresym.coq.coqtop import Dialogue
from tresym.coq.ledger_statements import theorem_of
from tresym.coq.solution_statements import Along, constancy
from tresym.ledger.paper import all_claims
from tresym.reals.language.expression import number, symbol


def printed(label: str) -> Along:
    found = theorem_of(next(claim for claim in all_claims() if claim.label == label))
    assert isinstance(found, Along)
    return found


def test_the_unknowns_are_functions_that_solve_the_system_where_the_conditions_hold() -> None:
    text = printed("planar_system").text
    assert "forall a b : R,\n  a > 0 ->" in text
    assert "forall (theta psi : R -> R) (v_start v_stop : R)" in text
    assert "(fun theta psi : R => sin theta > 0) (theta v_time) (psi v_time) /\\" in text
    assert "is_derive psi v_time ((fun theta psi : R => " in text


def test_what_makes_numbers_defined_is_asked_once_and_the_rest_at_every_time() -> None:
    found = printed("planar_system")
    assert not found.constants
    assert "sin psi) ^ 2 + 1 <> 0) (theta v_time) (psi v_time)" in found.body
    constants = [part for part, _ in printed("two_first_integrals").constants]
    assert sorted(map(str, constants)) == ["I1", "I2", "I3"]


def test_each_quantity_has_the_rate_zero_in_balls() -> None:
    """The rates of the momentum and of the energy, with numbers and not from tresym."""
    m1, m2, m3, i1, i2, i3 = map(arb, ("1.25", "-0.5", "2.75", "1.5", "2", "3.25"))
    rates = (m2 * m3 * (1 / i3 - 1 / i2), m1 * m3 * (1 / i1 - 1 / i3), m1 * m2 * (1 / i2 - 1 / i1))
    assert (m1 * rates[0] + m2 * rates[1] + m3 * rates[2]).contains(0)
    assert not (m1 * rates[0] + m2 * rates[1] - m3 * rates[2]).contains(0)
    text = printed("two_first_integrals").text
    assert "(-1) * v_M2 * v_M3 * (/ v_I2 + (-1) * / v_I3)" in text


@pytest.mark.coq
def test_no_other_quantity_is_constant() -> None:
    whole = printed("two_first_integrals")
    m1, m2, m3 = (symbol(f"M{n}") for n in (1, 2, 3))
    two = number(2)
    false = [replace(whole, quantities=(e,)) for e in (m1, m1**2 + m2**2, m1**2 + m2**2 - m3**2)]
    false.append(replace(whole, rates=(whole.rates[0], whole.rates[1], two * whole.rates[2])))
    with Dialogue() as coq:
        for theorem, truth in ((whole, True), *((theorem, False) for theorem in false)):
            text = f"Theorem trial :\n{theorem.body}.\nProof.\n{constancy(theorem)}\nQed."
            assert coq.accepts(text, 60) is truth
