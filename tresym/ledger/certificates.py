"""Stored box proofs: checked in every run, searched for again by ``tresym verify --full``."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from functools import lru_cache
from pathlib import Path

from tresym.ledger.paper import file_of
from tresym.reals.balls.branch_and_bound import BoxProof, CertificateError
from tresym.reals.numbers.exact import InputError

FILE = "certificates.json"


@lru_cache(maxsize=1)
def _trees() -> dict[str, list[str]]:
    path = file_of(FILE)
    return json.loads(path.read_text("utf-8")) if path.is_file() else {}


def certificate(label: str) -> Callable[[], tuple[BoxProof, ...] | None]:
    """The stored proofs of the claim ``label``, one for each bound; None if there are none.

    What it gives raises a CertificateError where the file holds something else.
    """

    def stored() -> tuple[BoxProof, ...] | None:
        trees = _trees().get(label)
        if trees is None:
            return None
        if not isinstance(trees, list) or not all(isinstance(tree, str) for tree in trees):
            raise CertificateError(f"{FILE} has no list of trees for {label}")
        return tuple(BoxProof(tree) for tree in trees)

    return stored


def save(found: Mapping[str, tuple[str, ...]]) -> None:
    """Write the trees of these claims over the stored ones.

    Args:
        found: for each label the tree of each of its bounds.

    Raises:
        InputError: the proofs are installed and not a checkout's.
    """
    path = checkout_file()
    kept = {**_trees(), **{label: list(trees) for label, trees in found.items()}}
    text = json.dumps(dict(sorted(kept.items())), ensure_ascii=False, indent=1)
    path.write_text(text + "\n", encoding="utf-8")
    _trees.cache_clear()


def checkout_file() -> Path:
    """The file of the stored proofs, in a checkout.

    Raises:
        InputError: the proofs are installed and not a checkout's.
    """
    path = file_of(FILE)
    if not (path.parent.parent / "pyproject.toml").is_file():
        raise InputError("stored proofs can only be written in a checkout")
    return path
