"""What passes speaks of a point, and the terms of its sums are defined at every index."""

import pytest
from cases import cases

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions import definedness_check
from tresym.reals.decisions.answer import Answer
from tresym.reals.verdict import Verdict

NOWHERE = cases(__file__, "NOWHERE")


@pytest.mark.parametrize("claim", NOWHERE)
def test_nothing_is_proved_of_what_is_defined_nowhere(
    monkeypatch: pytest.MonkeyPatch, claim: str
) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED
    monkeypatch.setattr(dispatch, "_decide", lambda *_: Answer(Verdict.PROVED, "so it is said"))
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.UNDECIDED
    monkeypatch.setattr(definedness_check, "unspoken", lambda *_: None)
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.UNDECIDED)
