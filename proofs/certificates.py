"""Stored box proofs: found once, re-checked in every run, found anew by `tresym verify --full`."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import lru_cache
from importlib.resources import files

from tresym.claims.enclosure import BoxProof

FILE = "certificates.json"


@lru_cache(maxsize=1)
def _trees() -> dict[str, list[str]]:
    path = files("tresym.proofs") / FILE
    return json.loads(path.read_text("utf-8")) if path.is_file() else {}


def certificate(label: str) -> Callable[[], tuple[BoxProof, ...] | None]:
    """The stored proofs of the claim ``label``, one for each bound; None if there are none."""

    def stored() -> tuple[BoxProof, ...] | None:
        trees = _trees().get(label)
        return None if trees is None else tuple(BoxProof(tree) for tree in trees)

    return stored
