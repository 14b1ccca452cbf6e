"""The paper's claims in order, and the files beside them."""

import pytest
from sympy import Ge, Symbol

from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.paper import (
    Paper,
    all_claims,
    display_lines,
    file_of,
    index,
    racket,
    sections,
)
from tresym.ledger.verification import graph, verify
from tresym.reals.numbers.exact import InputError
from tresym.report.pages import fragments
from tresym.report.pages.ledger_rows import report_json


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


X, Y = Symbol("x", real=True), Symbol("y", real=True)
HOLDS = Claim(label="square", says=Ge(X**2, 0, evaluate=False), proof=Decided())
OPEN = Claim(label="open", says=X > 2, given=(X > 1, X < 0), proof=Decided())


def _parts(names: tuple[str, ...] = ()) -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    return (("Part one", (HOLDS, OPEN)),)


def test_another_paper_is_passed_and_needs_nothing_but_its_claims() -> None:
    own = Paper("own", _parts)
    report = verify(of=own)
    assert [row.claim.label for row in report.rows] == ["square", "open"]
    assert report["square"].finding.verdict.value == "PROVED"
    assert [row.claim.label for row in verify("square", of=own).rows] == ["square"]
    assert "square" in graph(of=own)
    assert own.index == {"displays": [], "others": [], "sections": []}
    assert own.titles == {}
    assert own.corrections() == ()
    assert own.written.latex == {}


def test_an_undecided_claim_is_typeset_as_not_proved() -> None:
    report = verify(of=Paper("own", _parts))
    assert report["open"].finding.verdict.value == "UNDECIDED"
    for style in ("article", "markdown"):
        text = fragments.written([report["open"]], style)
        assert "Not proved" in text
        assert "Reason: " in text
        assert "Not proved" not in fragments.written([report["square"]], style)


def test_readable_names_stand_for_claims_of_the_ledger_and_for_one_claim_each() -> None:
    aliases, labels = racket().aliases, {claim.label for claim in all_claims()}
    assert set(aliases) <= labels
    assert not labels & set(aliases.values())
    assert len(set(aliases.values())) == len(aliases)


def test_a_readable_name_finds_the_claim_that_its_label_finds() -> None:
    report = verify("main_theorem_remainder")
    assert report["main_theorem_remainder"] is report["d24"]
    assert [row.claim.label for row in report.rows if row.requested] == ["d24"]
    assert graph(("main_theorem_remainder",)) == graph(("d24",))
    rows = {row["label"]: row["alias"] for row in report_json(report)["claims"]}
    assert rows["d24"] == "main_theorem_remainder"
    with pytest.raises(InputError, match="did you mean main_theorem_remainder"):
        verify("main_theorem_remaindr")
