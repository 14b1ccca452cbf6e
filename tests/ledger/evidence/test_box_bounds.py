"""Bounds on boxes and orders as evidence, stored proofs looked at and falsehoods refused."""

from typing import Any

import pytest
from flint import arb, fmpq

from tresym.ledger.evidence.box_bounds import Boxes, finding_anew, searching_anew
from tresym.reals.balls.branch_and_bound import Bound, BoxProof, CertificateError, box
from tresym.reals.verdict import Verdict

ENCLOSED, REFUTED, UNDECIDED = Verdict.ENCLOSED, Verdict.REFUTED, Verdict.UNDECIDED


def bound(least: str) -> Bound:
    """x² − x + 1 above ``least`` on [0, 2], where its minimum is 3/4."""
    return Bound(lambda x, m: x * x - x + 1 - arb(least), box((0, 2)))


def boxes(*bounds: Bound, **more: Any) -> Boxes:
    return Boxes(bounds, ("x",), "0 <= x <= 2", **more)


def test_bounds_that_hold_are_closed_with_their_trees() -> None:
    found = boxes(bound("0.7"), bound("0.5"), constant=fmpq(3, 4)).judge()
    assert found.verdict is ENCLOSED
    assert len(found.trees) == 2
    assert found.region == "0 <= x <= 2"
    assert found.constant is not None
    assert found.constant.mid.startswith("0.75")


def test_a_margin_that_forgets_radii_shows_nothing() -> None:
    """By its values at midpoints x² − x + 1 is above 0.7 everywhere, and so is its denial."""
    for sign in (1, -1):
        blind = Bound(lambda x, m, s=sign: arb(1) + s * x.mid() * arb("1e-9"), box((0, 2)))
        for found in (boxes(blind).judge(), boxes(bound("0.7"), blind).judge()):
            assert (found.verdict, found.why) == (
                UNDECIDED,
                "the ball of the formula over a box does not contain its "
                "values at points of the box",
            )


def test_one_that_fails_refutes_all_at_a_point() -> None:
    found = boxes(bound("0.7"), bound("0.8")).judge()
    assert found.verdict is REFUTED
    assert found.witness is not None
    x = found.witness["x"]
    assert x * x - x + 1 < fmpq(8, 10)


def test_open_boxes_and_no_bounds_are_undecided() -> None:
    assert boxes(bound("0.75"), budget=50).judge().verdict is UNDECIDED
    assert boxes().judge().verdict is UNDECIDED


def _tree(least: str) -> tuple[BoxProof, ...]:
    return tuple(BoxProof(tree) for tree in boxes(bound(least)).judge().trees)


def test_a_stored_proof_is_checked_and_not_believed() -> None:
    good = _tree("0.7")
    assert boxes(bound("0.7"), stored=lambda: good).judge().verdict is ENCLOSED
    easy = _tree("-9")
    for forged in (easy, (), good * 2):
        with pytest.raises(CertificateError):
            boxes(bound("0.7"), stored=lambda forged=forged: forged).decisions()


def test_searching_anew_looks_at_no_stored_proof() -> None:
    def stored() -> tuple[BoxProof, ...]:
        raise AssertionError("looked at")

    with finding_anew():
        assert searching_anew()
        assert boxes(bound("0.7"), stored=stored).judge().verdict is ENCLOSED
    assert not searching_anew()


def sine(x: Any, m: Any) -> Any:
    return m.sin(x) - x
