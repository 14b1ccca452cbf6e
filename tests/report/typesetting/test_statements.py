"""A claim is quoted with its conditions: in every place where it is quoted, and by nobody else."""

import ast
import json
from collections.abc import Callable
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

import pytest
from derivations import by
from sympy import Symbol
from sympy_statements import equal

import tresym
from tresym.commands.verify import show_verification
from tresym.ledger.claim import (
    AllOf,
    Claim,
    all_of,
)
from tresym.ledger.paper import all_claims
from tresym.ledger.verification import Report
from tresym.report.pages import fragments
from tresym.report.pages.corrections import corrections
from tresym.report.pages.derivation import in_dollars as dollars
from tresym.report.pages.derivation import prose
from tresym.report.pages.ledger_document import ledger_document
from tresym.report.pages.site_data import record
from tresym.report.typesetting.markdown import sentence
from tresym.report.typesetting.plain_text import plain
from tresym.report.typesetting.statements import (
    Said,
    conditions,
    in_dollars,
    in_letters,
    in_line,
    in_plain_text,
    of_record,
    on_lines,
    quoted,
    said,
)
from tresym.site import claims as pages
from tresym.site.markdown import inline, link, statement

QUOTED = ("each_eps0_one_a", "monotonicity", "eq_gamma", "d24", "printed_error", "eq_borne_psi")
"""Of every kind one that has conditions: of its own, of its parts, of its boxes."""


@pytest.fixture(scope="module")
def report(judged: Callable[..., Report]) -> Report:
    claims = {claim.label: claim for claim in all_claims()}
    return judged(*QUOTED, *(t.label for label in QUOTED for t in claims[label].amended_by))


def _in_markdown(claim: Claim) -> str:
    return conditions(said(claim), in_dollars, sentence)


def _by_name(claim: Claim) -> str:
    return conditions(said(claim), in_dollars, sentence, link)


def _in_latex(claim: Claim) -> str:
    return conditions(said(claim), dollars, prose)


def _in_a_fragment(claim: Claim) -> str:
    return fragments._opening(claim, fragments._LATEX)


def _in_the_document(claim: Claim) -> str:
    def named(label: str) -> str:
        return rf"\texttt{{{prose(label)}}}"

    return conditions(said(claim), dollars, prose, named)


def _in_plain_text(claim: Claim) -> str:
    return conditions(said(claim), plain)


def _on_the_page(report: Report, label: str) -> str:
    return dict(pages.pages(_saved(report), {}))[f"{label}.md"]


def _saved(report: Report) -> pages.Record:
    if not _records:
        _records.append(json.loads(json.dumps(record(report))))
    return _records[0]


_records: list[pages.Record] = []
"""What is saved of the one report of these tests."""


def _at_the_terminal(report: Report, label: str) -> str:
    with redirect_stdout(StringIO()) as shown:
        show_verification((label,), width=10_000)
    return shown.getvalue()


PLACES: dict[str, tuple[Callable[[Report, str], str], Callable[[Claim], str]]] = {
    "the corrections": (lambda r, label: corrections(r), _in_markdown),
    "the ledger as a document": (lambda r, label: ledger_document(r), _in_the_document),
    "a statement to paste": (
        lambda r, label: fragments.written([r[label]], "article"),
        _in_a_fragment,
    ),
    "the list of the site": (lambda r, label: pages.index(_saved(r)), _in_markdown),
    "the page of a claim": (_on_the_page, _by_name),
    "a frame, as in the theory": (
        lambda r, label: statement(_saved(r)["claims"][label]),
        _in_markdown,
    ),
    "an entry of a list": (
        lambda r, label: inline(_saved(r)["claims"][label]),
        _in_markdown,
    ),
    "the terminal": (_at_the_terminal, _in_plain_text),
}
"""Where a claim's sentence is quoted, and how its conditions are set there."""

DOCUMENTS = (
    *("the ledger as a page", "the corrections", "the ledger as a document"),
    "the list of the site",
)
"""The places that are one text for all claims, which is written once."""
_written: dict[str, str] = {}

ONLY_CORRECTIONS = ("each_eps0_one_a", "monotonicity", "d24", "printed_error")
"""Of the claims above those that are refuted, or true instead."""


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("label", QUOTED)
@pytest.mark.slow
def test_the_conditions_stand_where_the_claim_is_quoted(
    place: str, label: str, report: Report
) -> None:
    if place == "the corrections" and label not in ONLY_CORRECTIONS:
        pytest.skip("it is neither refuted nor true instead of what is")
    text, words = PLACES[place]
    asked = words(report[label].claim)
    assert asked.startswith(("Given ", "Let ", "Each part holds under its own hypotheses"))
    if place not in DOCUMENTS or place not in _written:
        _written[place] = text(report, label)
    assert asked in _written[place]


def test_what_uses_a_claim_quotes_it_with_its_conditions(report: Report) -> None:
    page = _on_the_page(report, "eq_gamma")
    for used in report["eq_gamma"].claim.uses:
        assert quoted(used) in page


READ_BY = {
    "tresym/report/pages/ledger_rows.py": "the JSON, which has the conditions beside it",
    "tresym/report/typesetting/chains.py": "the chain, below the statement",
    "tresym/report/typesetting/statements.py": "the one room",
    "tresym/report/pages/found_repairs.py": "the search for a repair, which reads the conditions",
    "tresym/report/pages/symbols.py": "an assumption, whose conditions have a column",
    "tresym/report/pages/article.py": "the article, with the conditions; what is true instead",
    "tresym/report/pages/ledger_document.py": "what a quoted theorem says, which is no claim",
    "tresym/report/pages/templates.py": "a sentence of the article; its conditions are in the text",
    "tresym/report/pages/derivation.py": "what a quoted theorem says, which is no claim",
    "tresym/report/pages/site_data.py": "the same",
    "tresym/report/pages/fragments.py": "a claim to paste, after its conditions",
    "tresym/report/pages/coq_page.py": "what a theorem of Coq says",
    "tresym/commands/claims_file.py": "what Coq answers, which is no claim of the ledger",
    "tresym/commands/check.py": "what `check` answers, which is no claim of the ledger",
}
"""The files that read what a claim says, and why these may."""


def test_nobody_else_reads_what_a_claim_says() -> None:
    home = Path(tresym.__file__).parent
    found = set()
    for room in ("report", "site", "commands"):
        for path in (home / room).rglob("*.py"):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            if any(isinstance(n, ast.Attribute) and n.attr == "says" for n in ast.walk(tree)):
                found.add(f"tresym/{path.relative_to(home).as_posix()}")
    found -= {"tresym/site/claims.py"}  # of a record, by way of `of_record`
    assert found <= set(READ_BY)


@pytest.mark.slow
def test_every_condition_of_every_claim_is_said() -> None:
    for claim in all_claims():
        found = said(claim)
        asked = claim.given or (isinstance(claim.proof, AllOf) and any(p.given for p in claim.uses))
        if asked:
            assert _in_markdown(claim), claim.label
        assert of_record(json.loads(json.dumps(found.as_record()))) == found
        assert on_lines(found).endswith(_in_markdown(claim))


x, y = (Symbol(name, real=True) for name in "xy")


def _claim(label: str, *given: object) -> Claim:
    return Claim(label, equal(x, x), by(), given=given)


def test_a_conjunction_says_what_its_parts_share_once_and_the_rest_by_part() -> None:
    parts = (_claim("one", x > 0), _claim("two", x > 0, y > 0), _claim("three", x > 0, y < 1))
    both = said(Claim("both", "Both.", all_of(*parts)))
    assert both.given == ("x > 0",)
    assert [part.labels for part in both.parts] == [("two",), ("three",)]
    assert in_plain_text(both) == "Both. Given x > 0; for some parts also: y > 0; y < 1."
    named = conditions(both, str, name=str)
    assert named == "Given x > 0; for two also: y > 0; for three also: y < 1."


def test_conditions_that_another_part_has_too_are_left_to_it() -> None:
    parts = (_claim("one", x > 0), _claim("two", x > 0, y > 0), _claim("three", y < 1))
    whole = said(Claim("whole", "All.", all_of(*parts)))
    assert in_plain_text(whole) == "All. Given part by part: x > 0, y > 0; y < 1."
    assert "for one: x > 0" in conditions(whole, str, name=str)


def test_parts_of_parts_are_asked_too() -> None:
    inner = Claim("inner", "Inner.", all_of(_claim("one", x > 0)))
    assert in_plain_text(said(Claim("outer", "Outer.", all_of(inner)))) == "Outer. Given x > 0."


def test_without_conditions_nothing_is_said_of_them() -> None:
    assert in_plain_text(Said("So it is.", None, ())) == "So it is."
    assert in_line(Said(None, "|a|,\\quad b", ()), "") == r"$\vert a\vert$, $b$."


def test_what_the_bounds_of_a_symbol_show_is_not_said_again() -> None:
    from sympy import pi, sin

    found = said(_claim("one", x > 0, x < pi, sin(x) > 0, sin(y) > 0))
    assert found.given == (r"0 < x < \pi", r"\sin y > 0")


def test_what_was_found_is_set_in_letters_for_a_terminal() -> None:
    found = "along a = t**(-2) the left side behaves like -t**2*exp(pi/t)/3"
    assert in_letters(found) == "along a = t⁻² the left side behaves like −t² · exp(π/t)/3"
