"""Sentences in words, each compared once with the formula that stands for it.

Most claims state a formula, and what a reader sees is printed from it. A claim in words has a
formula beside its sentence, or, if no formula says the whole, the claims that support it. That the
two agree cannot be computed: somebody has to compare them. The package of proofs stores a hash of
each pair in ``sentences.json``. If the sentence or the formula is changed, the hash no longer fits,
and `tresym.ledger.verification` lets the claim count as UNDECIDED until they are compared again and
``tresym verify --save-sentences LABEL`` is run.

Example: "ε₀ = 0.1150 by the exact equation" beside ``Rounded(epsilon0, "0.1150")``. With 0.1151 in
either place the claim is UNDECIDED.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from functools import lru_cache
from hashlib import sha256
from pathlib import Path

from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.paper import file_of

STORE = "sentences.json"


def meaning(claim: Claim) -> str:
    """Return the formula of a claim with its conditions, or those of the claims it rests on."""
    if claim.statement is not None and not isinstance(claim.proof, AllOf):
        return f"{claim.statement!r} given {claim.given!r}"
    parts = claim.uses if claim.statement is None or isinstance(claim.proof, AllOf) else ()
    return "; ".join(f"{part.label}: {meaning(part)}" for part in parts)


def digest(sentence: str, claim: Claim) -> str:
    """Return a hash of a sentence and of the formula that stands for it."""
    return sha256(json.dumps([sentence, meaning(claim)]).encode()).hexdigest()[:12]


def stored() -> dict[str, str] | None:
    """Return the hashes of the sentences that were compared, by label; None without such a file."""
    return _read(file_of(STORE))


@lru_cache(maxsize=4)
def _read(path: Path) -> dict[str, str] | None:
    if not path.is_file():
        return None
    found: dict[str, str] = json.loads(path.read_text(encoding="utf-8"))
    return found


def sentence_of(claim: Claim) -> str | None:
    """Return the sentence of a claim in words, or None if it states a formula."""
    return claim.says if isinstance(claim.says, str) else None


def uncompared(claim: Claim) -> str | None:
    """Return why the sentence of a claim does not count, or None if it was compared."""
    sentence = sentence_of(claim)
    return None if sentence is None else changed(claim.label, sentence, claim)


def changed(key: str, sentence: str, claim: Claim) -> str | None:
    """Return why a sentence stored under ``key`` does not count beside the claim, or None."""
    known = stored()
    if known is None or known.get(key) == digest(sentence, claim):
        return None
    what = "was changed" if key in known else "has not been compared"
    return (
        f"the sentence, or the formula that stands for it, {what}: compare the two, and run "
        f"tresym verify --save-sentences {claim.label}"
    )


def updated(hashes: dict[str, str], gone: Iterable[str] = ()) -> str:
    """Return the text of the file with more sentences compared, without those that are gone."""
    known = stored() or {}
    kept = {label: found for label, found in known.items() if label not in {*gone}}
    return json.dumps(kept | hashes, indent=0, ensure_ascii=False, sort_keys=True) + "\n"
