"""What `tresym verify` found is read again by the next run, and by nothing that differs."""

import json
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest
from flint import fmpq

from tresym.commands import main
from tresym.ledger import kept_findings, verification
from tresym.ledger.evidence.box_bounds import finding_anew
from tresym.ledger.finding import Finding, Premise, StepFinding
from tresym.reals.numbers.exact import Decimal
from tresym.reals.verdict import Verdict


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("TRESYM_CACHE", str(tmp_path / "cache"))
    return tmp_path


def _refuse(*_: object) -> NoReturn:
    raise AssertionError("judged again")


def test_what_was_found_is_not_judged_again(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["verify", "--json", "eq_gamma"]) == 0
    first = capsys.readouterr().out
    monkeypatch.setattr(verification, "judge_evidence", _refuse)
    assert main(["verify", "--json", "eq_gamma"]) == 0
    assert capsys.readouterr().out == first
    assert json.loads(first)["counts"]["PROVED"]


def test_it_is_found_by_the_same_paper_and_the_same_code_only(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    verification.verify("eq_gamma")
    monkeypatch.setattr(verification, "judge_evidence", _refuse)
    verification.verify("eq_gamma")
    for name in ("_hash_of", "version"):
        with monkeypatch.context() as changed:
            changed.setattr(kept_findings, name, lambda *_: b"another")
            with pytest.raises(AssertionError, match="judged again"):
                verification.verify("eq_gamma")
    with finding_anew(), pytest.raises(AssertionError, match="judged again"):
        verification.verify("eq_gamma")


def test_a_finding_is_read_as_it_was_written(folder: Path) -> None:
    full = Finding(
        Verdict.REFUTED, "why", Decimal("1.5", "1e-9"), Decimal("2", "0"), "0 < x", "e -> 0",
        {"x": fmpq(-1, 3)}, (StepFinding(Verdict.PROVED, "", 0.5),), trees=("01b",), boxes=3,
        follows_from=("part",), along="a = b", stopped=True, seconds=1.25,
    )  # fmt: skip
    plain = Finding(Premise.DEFINED, "new symbols")
    with kept_findings.kept_findings(folder) as kept:
        for label, finding in (("full", full), ("plain", plain)):
            kept.put(label, finding)
            assert kept.get(label) == finding
        kept.put("open", replace(plain, verdict=Verdict.UNDECIDED))
        assert kept.get("open") is None
