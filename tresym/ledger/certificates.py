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
    """Return a function that reads the stored proofs of a claim when it is called.

    Args:
        label: the label of the claim.

    Returns:
        A function without arguments that returns one proof per bound, or None if none are stored,
        and raises CertificateError if the file is malformed.
    """

    def stored() -> tuple[BoxProof, ...] | None:
        trees = _trees().get(label)
        if trees is None:
            return None
        if not isinstance(trees, list) or not all(isinstance(tree, str) for tree in trees):
            raise CertificateError(f"the entry for {label} in {FILE} is not a list of strings")
        return tuple(BoxProof(tree) for tree in trees)

    return stored


def save(found: Mapping[str, tuple[str, ...]]) -> None:
    """Store the bisection trees of these claims, replacing their old ones.

    Args:
        found: for each label, one tree per bound.

    Raises:
        InputError: tresym does not run from a checkout of its repository.
    """
    path = checkout_file()
    merged = {**_trees(), **{label: list(trees) for label, trees in found.items()}}
    text = json.dumps(dict(sorted(merged.items())), ensure_ascii=False, indent=1)
    path.write_text(text + "\n", encoding="utf-8")
    _trees.cache_clear()


def checkout_file() -> Path:
    """Return the path of the stored proofs in a checkout of the repository.

    Raises:
        InputError: tresym does not run from a checkout of its repository.
    """
    path = file_of(FILE)
    if not (path.resolve().parent.parent / "pyproject.toml").is_file():
        raise InputError("stored proofs can only be written in a checkout")
    return path
