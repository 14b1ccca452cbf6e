"""Orders and sequences along a path in Coq: what they say, and that no false one is proved.

``tests/data/lists/coq/orders.txt`` holds the claims; ``stamps.json`` beside this file, of each true
claim, a hash of all that Coq read when it accepted a proof. Where a statement or a lemma changed
since, ``PYTHONPATH=tests python tests/coq/test_orders.py`` asks Coq again.
"""

import json
import time
from hashlib import sha256
from pathlib import Path

import pytest
from cases import cases

from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.candidate_search import bound, found_by
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import HEAD, Dialogue
from tresym.output import write_text
from tresym.reals.decisions.claim_parsing import read

STAMPS = Path(__file__).with_name("stamps.json")
TRUE, FALSE = cases(__file__, "TRUE"), cases(__file__, "FALSE")
QUICK = 3
"""How many of each are asked by ``pytest -m coq``; the others every night."""


def theorem_of(claim: str) -> BoundTheorem:
    (found,) = theorems(read(claim))
    assert isinstance(found, BoundTheorem)
    return found


def stamp(claim: str) -> str:
    found = theorem_of(claim)
    return sha256((bound([found]) + found.text).encode()).hexdigest()[:16]


def proved(claim: str, coq: Dialogue, seconds: float = 100) -> bool:
    return found_by(theorem_of(claim), coq, time.monotonic() + seconds) is not None


def dialogue() -> Dialogue:
    return Dialogue(lemmas=HEAD + bound([theorem_of(TRUE[0])]))


def test_every_statement_is_the_one_that_coq_accepted() -> None:
    """Needs no Coq. If it fails, have Coq check the claims again: see above."""
    stored = json.loads(STAMPS.read_text(encoding="utf-8"))
    assert {claim: stamp(claim) for claim in TRUE} == stored


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
        for claim in TRUE:
            if stored.get(claim) != stamp(claim):
                ok = proved(claim, coq)
                print("accepted" if ok else "NOT accepted", claim, flush=True)
                stored = {k: v for k, v in stored.items() if k != claim and k in TRUE}
                stored |= {claim: stamp(claim)} if ok else {}
                write_text(STAMPS, json.dumps(stored, indent=1, sort_keys=True) + "\n")


if __name__ == "__main__":
    main()
