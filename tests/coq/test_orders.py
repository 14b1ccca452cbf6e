"""Orders and sequences along a path in Coq: what they say, and that no false one is proved.

``tests/data/lists/coq/orders.txt`` holds the claims, and ``constants.txt`` those that are proved
with the constant of tresym's answer; nine tenths of the largest value of the ratio are too little.
``stamps.json`` beside this file holds of each true claim a hash of all that Coq read when it
accepted a proof. Where a statement or a lemma changed since,
``PYTHONPATH=tests python tests/coq/test_orders.py`` asks Coq again.
"""

import json
import time
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import pytest
from cases import cases

from tresym.checking.time_limited import Task, check_within
from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.candidate_search import bound, found_by
from tresym.coq.claim_export import theorems
from tresym.coq.constant_proofs import constant_theorem
from tresym.coq.coqtop import HEAD, Dialogue
from tresym.coq.statement import NotExportedError, term
from tresym.output import write_text
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.expression import number
from tresym.reals.numbers.exact import parse_number

STAMPS = Path(__file__).with_name("stamps.json")
TRUE, FALSE = cases(__file__, "TRUE"), cases(__file__, "FALSE")
CONSTANTS = cases(str(Path(__file__).with_name("constants.py")), "TRUE")
ON = " | with its constant"
ALL = [*TRUE, *(claim + ON for claim in CONSTANTS)]
QUICK = 3
"""How many of each are asked by ``pytest -m coq``; the others every night."""


def theorem_of(claim: str) -> BoundTheorem:
    if claim.endswith(ON):
        return with_its_constant(claim.removesuffix(ON))
    (found,) = theorems(read(claim))
    assert isinstance(found, BoundTheorem)
    return found


def with_its_constant(claim: str) -> BoundTheorem:
    return constant_theorem(read(claim), check_within(Task(claim, "", None), 20))


def with_less(claim: str) -> BoundTheorem:
    """The theorem with a constant that is too small: the answer encloses the smallest one."""
    found = with_its_constant(claim)
    answer = check_within(Task(claim, "", None), 20)
    assert answer.constant is not None
    low = parse_number(answer.constant.mid) - parse_number(answer.constant.rad)
    assert found.bounded is not None
    constant = number(low * 9 / 10)
    said = found.says[-1].replace(term(found.bounded.constant, 3), term(constant, 3))
    assert said != found.says[-1]
    return replace(
        found,
        says=(*found.says[:-1], said),
        bounded=found.bounded._replace(constant=constant),
    )


def stamp(claim: str) -> str:
    found = theorem_of(claim)
    return sha256((bound([found]) + found.text).encode()).hexdigest()[:16]


def proved(claim: str | BoundTheorem, coq: Dialogue, seconds: float = 100) -> bool:
    found = theorem_of(claim) if isinstance(claim, str) else claim
    return found_by(found, coq, time.monotonic() + seconds) is not None


def dialogue() -> Dialogue:
    return Dialogue(lemmas=HEAD + bound([theorem_of(TRUE[0])]))


def test_every_statement_is_the_one_that_coq_accepted() -> None:
    """Needs no Coq. If it fails, have Coq check the claims again: see above."""
    stored = json.loads(STAMPS.read_text(encoding="utf-8"))
    assert {claim: stamp(claim) for claim in ALL} == stored


@pytest.mark.parametrize(
    ("claim", "premises", "says"),
    [
        (
            "1/(1 - x) == 1 + x + O(x^2) as x -> 0",
            ("x <> 0", "Rabs (x - 0) <= 1 / 2"),
            "Rabs (/ ((-1) * x + 1) + (-1) * (x + 1)) <= (201 / 100) * Rabs (x ^ 2)",
        ),
        (
            "log(1 + 1/n) == 1/n + O(1/n^2) as n -> oo given n in integers",
            ("1 <= INR n",),
            "Rabs (ln (/ (INR n) + 1) + (-1) * / (INR n)) <= (501 / 1000) * Rabs (/ ((INR n) ^ 2))",
        ),
        (
            "x/(x + y) == O(x) uniformly given y > 1 as x -> 0+",
            ("y > 1", "0 < x", "x <= 1"),
            "Rabs (x * / (x + y)) <= (51 / 50) * Rabs (x)",
        ),
        (
            "exp(1/x) == 1 + 1/x + O(1/x^2) as x -> -oo",
            ("x <= (-1)",),
            "Rabs (exp (/ x) + (-1) * (/ x + 1)) <= (253 / 500) * Rabs (/ (x ^ 2))",
        ),
    ],
)
def test_a_constant_is_stated_with_its_region(
    claim: str, premises: tuple[str, ...], says: str
) -> None:
    found = with_its_constant(claim)
    assert found.premises == premises
    assert found.says[-1] == says


@pytest.mark.parametrize(
    "claim",
    [
        "sin(x) == o(1) as x -> 0",  # no constant
        "exp(a*x) == 1 + O(x) as x -> 0",  # the constant depends on a
        "sin(x) == x + O(x^3) as x -> 0 on abs(x) <= pi/2",  # a region of another kind
    ],
)
def test_without_one_constant_there_is_no_such_theorem(claim: str) -> None:
    with pytest.raises(NotExportedError):
        with_its_constant(claim)


@pytest.mark.coq
def test_a_smaller_constant_is_not_proved() -> None:
    with dialogue() as coq:
        assert all(proved(claim + ON, coq) for claim in CONSTANTS[:QUICK])
        assert not [claim for claim in CONSTANTS[:QUICK] if proved(with_less(claim), coq, 20)]


@pytest.mark.coq
@pytest.mark.night
def test_of_all_constants_those_of_the_answers_are_proved() -> None:
    with dialogue() as coq:
        assert not [c for c in CONSTANTS[QUICK:] if proved(with_less(c), coq, 20)]
        assert not [c for c in CONSTANTS[QUICK:] if not proved(c + ON, coq)]


@pytest.mark.coq
@pytest.mark.parametrize("claim", TRUE[:QUICK])
def test_a_true_order_is_proved(claim: str) -> None:
    with dialogue() as coq:
        assert proved(claim, coq)


@pytest.mark.coq
def test_no_false_order_is_proved() -> None:
    with dialogue() as coq:
        assert not [claim for claim in FALSE[:QUICK] if proved(claim, coq, 20)]


@pytest.mark.coq
@pytest.mark.night
def test_of_all_orders_the_true_ones_are_proved() -> None:
    with dialogue() as coq:
        assert not [claim for claim in FALSE[QUICK:] if proved(claim, coq)]
        assert not [claim for claim in TRUE[QUICK:] if not proved(claim, coq)]


def main() -> None:
    """Have Coq check every true claim, and store the hashes of those that it accepts."""
    stored = json.loads(STAMPS.read_text(encoding="utf-8")) if STAMPS.is_file() else {}
    with dialogue() as coq:
        for claim in ALL:
            if stored.get(claim) != stamp(claim):
                ok = proved(claim, coq)
                print("accepted" if ok else "NOT accepted", claim, flush=True)
                stored = {k: v for k, v in stored.items() if k != claim and k in ALL}
                stored |= {claim: stamp(claim)} if ok else {}
                write_text(STAMPS, json.dumps(stored, indent=1, sort_keys=True) + "\n")


if __name__ == "__main__":
    main()
