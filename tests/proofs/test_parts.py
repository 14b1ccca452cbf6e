"""A part reads like its section: each display of the paper is named at the top of its file."""

import re
from importlib import import_module

import pytest
from tresym.proofs import PARTS, parts

from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.paper import racket

STATED = dict(zip(PARTS, (claims for _, claims in parts()), strict=True))


@pytest.mark.parametrize("part", [p for p in PARTS if racket().source_of(p).suffix == ".py"])
def test_each_display_is_named_in_the_docstring_of_its_part(part: str) -> None:
    module = import_module(f"tresym.proofs.{part}")
    names = {value: name for name, value in vars(module).items() if isinstance(value, Claim)}
    for claim in STATED[part]:
        if claim.where is not None and claim.where.display is not None:
            named = {claim.label, names.get(claim, claim.label)}
            assert any(f"`{name}`" in str(module.__doc__) for name in named), claim.label


def test_a_file_uses_only_parts_before_it() -> None:
    place = {part: n for n, part in enumerate(PARTS)}
    for part in PARTS:
        path = racket().source_of(part)
        used = re.findall(r"^use .* from (\w+)$", path.read_text(encoding="utf-8"), re.MULTILINE)
        assert path.suffix == ".py" or used, part
        assert all(place.get(other, -1) < place[part] for other in used), (part, used)


def test_a_claim_of_a_part_has_a_label() -> None:
    labels = [claim.label for claims in STATED.values() for claim in claims]
    assert all(labels)
    assert len(labels) == len({*labels})
