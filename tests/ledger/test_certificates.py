"""Stored box proofs: read by label, written over, and only in a checkout."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from tresym.ledger import certificates
from tresym.ledger.certificates import FILE, certificate, checkout_file, save
from tresym.ledger.paper import all_claims
from tresym.reals.balls.branch_and_bound import BoxProof
from tresym.reals.numbers.exact import InputError


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    (tmp_path / "proofs").mkdir()
    (tmp_path / "pyproject.toml").touch()
    monkeypatch.setattr(certificates, "file_of", lambda name: tmp_path / "proofs" / name)
    certificates._trees.cache_clear()
    yield tmp_path
    certificates._trees.cache_clear()


def test_without_a_file_there_are_no_proofs(checkout: Path) -> None:
    assert certificate("a")() is None


def test_what_is_saved_is_read_and_the_rest_is_kept(checkout: Path) -> None:
    save({"b": ("tree", "other"), "a": ("first",)})
    save({"a": ("second",)})
    assert certificate("a")() == (BoxProof("second"),)
    assert certificate("b")() == (BoxProof("tree"), BoxProof("other"))
    assert certificate("c")() is None
    assert list(json.loads((checkout / "proofs" / FILE).read_text())) == ["a", "b"]


def test_an_installed_package_is_not_written_to(checkout: Path) -> None:
    (checkout / "pyproject.toml").unlink()
    with pytest.raises(InputError):
        save({"a": ("tree",)})
    with pytest.raises(InputError):
        checkout_file()
    assert not (checkout / "proofs" / FILE).exists()


def test_who_looks_for_a_stored_proof_has_one() -> None:
    looking = {c.label for c in all_claims() if getattr(c.proof, "stored", None) is not None}
    assert looking == certificates._trees().keys()
