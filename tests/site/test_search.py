"""The site's search shows first the page that a reader most likely wants."""

import json
from pathlib import Path

from tresym.ledger.paper import all_claims, racket
from tresym.site import sources
from tresym.site.search import FIRST, LISTS, wanted_pages, words_that_lead_to, write_scorer

DOCS = Path(__file__).resolve().parents[2] / "docs"
CLAIMS = {
    "prop1": {"alias": "main_theorem", "place": "Theorem 6.1"},
    "d24": {"alias": "main_theorem_remainder", "place": "Theorem 6.1"},
    "energy": {"alias": None, "place": None},
}


def test_every_page_that_words_lead_to_exists() -> None:
    labels = {claim.label for claim in all_claims()}
    for page in {*FIRST.values(), *LISTS}:
        folder, _, name = page.partition("/")
        written = ("index", "the-paper", "quoted-theorems", "commands")
        known = name in (*labels, *written) if folder in ("claims", "reference") else False
        assert known or (DOCS / f"{page}.md").is_file(), page


def test_names_places_and_usual_words_lead_to_a_page() -> None:
    found = wanted_pages(CLAIMS)
    assert found["main_theorem_remainder"] == found["d24"] == "claims/d24"
    assert found["theorem 6.1"] == "claims/prop1"
    assert found["remainder"] == "claims/d24"
    assert found["stirling"] == "pages/integrals-and-sums"
    assert found["eps0"] == "claims/flip_defect"
    assert "eps0" in words_that_lead_to("claims/flip_defect")


def test_the_script_holds_the_pages_and_is_written_once(tmp_path: Path) -> None:
    path = tmp_path / "scorer.js"
    write_scorer(path, CLAIMS)
    text = path.read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.startswith("const FIRST"))
    assert json.loads(line.removeprefix("const FIRST = ").removesuffix(";")) == wanted_pages(CLAIMS)
    before = path.stat().st_mtime_ns
    write_scorer(path, CLAIMS)
    assert path.stat().st_mtime_ns == before


def test_each_file_of_the_proofs_has_a_page_whose_lines_have_addresses() -> None:
    pages = dict(sources.pages())
    assert set(pages) == {f"{module}.html" for module in racket().modules}
    text = racket().file_of("orders.tresym").read_text(encoding="utf-8")
    for n in (1, len(text.splitlines())):
        assert f'id="L-{n}"' in pages["orders.html"] or f'name="L-{n}"' in pages["orders.html"]
