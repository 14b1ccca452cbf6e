"""Every claim stands in the lines of the proofs that its page names."""

from tresym.ledger.paper import all_claims, racket
from tresym.report.pages.places_of_proofs import lines_of_claims


def test_every_claim_stands_in_its_lines() -> None:
    found = lines_of_claims()
    assert set(found) == {claim.label for claim in all_claims()}
    unnamed = 0
    for label, at in found.items():
        lines = racket().file_of(at.file).read_text(encoding="utf-8").splitlines()
        assert 1 <= at.first <= at.last <= len(lines)
        unnamed += label not in "\n".join(lines[at.first - 1 : at.last])
    assert unnamed < len(found) / 7  # cells of tables and rows of data have no name of their own
