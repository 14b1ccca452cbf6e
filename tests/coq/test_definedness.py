"""Premises of definedness: proved where the conditions imply them, and stated where they stay."""

import re
from pathlib import Path

import pytest

from tresym.coq import export
from tresym.coq.coqtop import Dialogue
from tresym.coq.definedness import satisfiable, strengthen, trial
from tresym.coq.ledger_proofs import Memory, premised_points
from tresym.coq.ledger_statements import Joint, stem
from tresym.coq.statement import Theorem
from tresym.reals.language.expression import ZERO, apply, symbol
from tresym.reals.language.formula import Relation
from tresym.report.pages import coq_page

STORE = export.stored()
X, A = symbol("x"), symbol("a")
NEEDS = Theorem(
    "claim_needs",
    ("a", "x"),
    (),
    ((A, ">", ZERO),),
    ((A, "!="), (apply("sin", X), "!="), (A * apply("sin", X), "!=")),
    Relation(X / A, "==", X / A),
)


def stronger() -> dict[str, export.Entry]:
    return {label: e for label, e in coq_page.found().items() if e.stronger is not None}


def test_a_stronger_theorem_states_exactly_the_premises_that_stay() -> None:
    assert len(stronger()) > 100
    for entry in stronger().values():
        assert entry.stronger
        assert entry.left is not None
        assert entry.stronger.body.count("(* defined *)") == len(entry.left)
        assert isinstance(entry.theorem, Theorem)
        assert len(entry.left) < len(entry.theorem.defined)
        assert len(entry.undefined) == len(entry.left)


def test_a_premise_that_was_dropped_by_hand_is_not_proved() -> None:
    label = next(label for label, entry in stronger().items() if entry.left)
    row = STORE["claims"][label]
    dropped = row | {"defined": row["defined"] | {"left": []}}
    store = {**STORE, "claims": {**STORE["claims"], label: dropped}}
    assert export.entries(store, [label])[label].status == "none"


@pytest.mark.slow
def test_the_theorem_of_a_claim_is_the_stronger_one(tmp_path: Path) -> None:
    joint = next(
        label
        for label, e in coq_page.found().items()
        if isinstance(e.theorem, Joint) and export.strengthened(label, coq_page.found())
    )
    label = next(label for label, e in stronger().items() if e.status == "proved")
    export.write(tmp_path, [label, joint], STORE)
    said = (tmp_path / "Statements.v").read_text(encoding="utf-8")
    closed = (tmp_path / "Ledger.v").read_text(encoding="utf-8")
    assert f"Definition stronger_{stem(label)} : Prop :=" in said
    assert f"Theorem claim_{stem(label)} : stronger_{stem(label)}." in closed
    assert re.search(rf"Definition stronger_{stem(joint)} : Prop :=\n.*stronger_\w+", said)
    assert f"Theorem claim_{stem(joint)} : stronger_{stem(joint)}." in closed


def test_definitions_conditions_and_premises_hold_together_somewhere() -> None:
    bodies = {row["body"] for row in STORE["possible"].values()}
    wholes = {
        label: e.stronger or e.theorem for label, e in coq_page.found().items() if e.undefined
    }
    left = [
        label
        for label, whole in wholes.items()
        if isinstance(whole, Theorem) and satisfiable(whole).body not in bodies
    ]
    assert set(left) <= {
        "d27",  # these depend on values that integrals, or equations for several symbols, fix
        "d36",
        "inverse_of_slope",
        "time_of_a_turn",
        "newton_four_exceeds",  # and these on a root and on Newton's step from another point
        "newton_pi_exceeds",
        "newton_four_angles",  # for these no point is stored yet
        "newton_pi_angles",
        "terms_decrease",
        "arcsine_above",
        "d15",
        "eq_dthetadphi",
        "exponent_left_out",
        "planar_constraint",
    }


@pytest.mark.coq
def test_only_what_the_conditions_imply_is_dropped() -> None:
    with Dialogue() as coq:
        found = strengthen("needs", NEEDS, coq)
        assert found
        assert found["left"] == [1]  # the sine may be 0; the product follows from it
        assert coq.accepts(trial("needs", NEEDS, found).replace("@", "1"), 20)
        false = trial("needs", NEEDS, found | {"left": []})
        assert not coq.accepts(false.replace("@", "2"), 20)
    memory = Memory(None)
    try:
        (row,) = premised_points([NEEDS], memory).values()
        assert row["body"].startswith("  exists a x : R,")
        contradictory = Theorem(
            "claim_none", ("x",), (), ((X, "==", ZERO),), ((X, "!="),), Relation(X, "==", X)
        )
        assert premised_points([contradictory], memory) == {}
    finally:
        memory.close()
