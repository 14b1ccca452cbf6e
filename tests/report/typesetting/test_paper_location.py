"""Places in the paper: sections and equations as the journal counts them."""

import pytest
from derivations import by
from sympy_statements import equal

from tresym.ledger.claim import (
    Claim,
    Place,
)
from tresym.ledger.paper import all_claims, index
from tresym.report.typesetting.paper_location import place_text


@pytest.mark.parametrize(
    ("where", "text"),
    [
        (Place(display=10), "Sect. 4, eq. (9)"),
        (Place(display=8), "Sect. 4, after eq. (7)"),
        (Place(display=12), "Sect. 5, before eq. (10)"),
        (Place(display=23), "Theorem 6.1, eq. (18)"),
        (Place(display=24), "Theorem 6.1"),
        (Place(display=32), "App. A, eq. (A.1)"),
        (Place(display=58), "App. A, eq. (A.12)"),
        (Place(line=38), "abstract"),
        (Place(line=47), "Sect. 1"),
        (Place(line=49), "Sect. 2, before eq. (1)"),
        (Place(line=243), "Remark 6.2"),
        (Place(line=288), "Sect. 7, Fig. 10"),
        (Place(line=305, cell="b"), "Sect. 7, Table 1, b"),
        (Place(line=461), "references"),
        (None, "—"),
    ],
)
def test_places(where: Place | None, text: str) -> None:
    assert place_text(Claim("one", equal(1, 1), by(), where=where)) == text


def test_every_place_is_told_by_its_section() -> None:
    names = {section["name"] for section in index()["sections"]}
    for claim in all_claims():
        if claim.where is not None:
            text = place_text(claim)
            assert text.split(",")[0] in names or text.startswith(("Theorem 6.", "Remark 6."))
            assert "line" not in text
            assert "display" not in text
