"""The paper's claims in order, and the files beside them."""

from tresym.ledger.paper import all_claims, display_lines, file_of, index, sections


def test_every_claim_comes_after_all_that_it_rests_on() -> None:
    seen = set()
    for claim in all_claims():
        assert seen.issuperset(claim.rests_on)
        assert claim not in seen
        seen.add(claim)


def test_sections_state_claims_of_the_ledger_once() -> None:
    stated = [claim for _, claims in sections() for claim in claims]
    assert len(stated) == len(set(stated))
    assert set(stated) <= set(all_claims())


def test_claims_lie_on_displays_that_the_index_has() -> None:
    lines = display_lines()
    numbers = [c.where.display for c in all_claims() if c.where and c.where.display]
    assert numbers
    assert set(numbers) <= set(lines)
    assert list(lines.values()) == sorted(lines.values())


def test_the_index_holds_hashes_and_no_text() -> None:
    assert file_of("index.json").is_file()
    for display in index()["displays"]:
        assert len(display["sha256"]) == 64
        assert "text" not in display
