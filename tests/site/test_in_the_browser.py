"""In a real browser: no letter of a picture lies beyond its rim, and the ledger's filter works."""

import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

playwright = pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

GENERATED = Path(__file__).resolve().parents[2] / "docs" / "generated"
PICTURES = sorted((*GENERATED.glob("figures/*.svg"), *GENERATED.glob("charts/*.svg")))
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
CUT_OFF = """() => {
  const rim = document.documentElement.getBoundingClientRect();
  return [...document.querySelectorAll('g[id^=text_]')].filter((words) => {
    const at = words.getBoundingClientRect();
    return at.width && (at.left < rim.left - 0.5 || at.top < rim.top - 0.5
      || at.right > rim.right + 0.5 || at.bottom > rim.bottom + 0.5);
  }).map((words) => words.id);
}"""


@pytest.fixture(scope="module")
def page() -> Iterator[Any]:
    if CHROMIUM is None:
        assert not os.environ.get("CI"), "Chromium must be there in CI"
        pytest.skip("Chromium is not installed (Debian: chromium)")
    with playwright.sync_playwright() as started:
        browser = started.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser.new_page()
        browser.close()


@pytest.mark.slow
def test_nothing_is_cut_off(page: Any) -> None:
    assert len(PICTURES) > 20
    for picture in PICTURES:
        page.goto(picture.as_uri())
        assert page.evaluate(CUT_OFF) == [], picture.name


def test_what_is_cut_off_is_seen(page: Any, tmp_path: Path) -> None:
    planted = tmp_path / "planted.svg"
    box = '<g id="text_1"><rect x="90" y="10" width="20" height="5"/></g>'
    root = '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100">'
    planted.write_text(f"{root}{box}</svg>", encoding="utf-8")
    page.goto(planted.as_uri())
    assert page.evaluate(CUT_OFF) == ["text_1"]


LEDGER = """<section><h2>One</h2><div class="ledger">
<p><a>eq_one</a> <span class="verdict proved">PROVED</span> <span class="place">eq. (1)</span>
<span class="mark coq">Coq</span> ε₀ &gt; 0</p>
<p><a>lemma_two</a> <span class="verdict refuted">REFUTED</span> ψ = 0</p></div></section>
<section><h2>Two</h2><div class="ledger">
<p><a>eq_three</a> <span class="verdict refuted">REFUTED</span> <span class="place">eq. (2)</span>
<math><mi>ϵ</mi></math> = 1</p></div></section>"""


@pytest.fixture
def ledger(page: Any, tmp_path: Path) -> Callable[[str], list[str]]:
    script = GENERATED.parent / "_static" / "ledger.js"
    path = tmp_path / "ledger.html"
    body = f'<main><section>{LEDGER}</section></main><script src="{script.as_uri()}"></script>'
    path.write_text(f'<!doctype html><meta charset="utf-8">{body}', encoding="utf-8")

    def shown(fragment: str) -> list[str]:
        page.goto("about:blank")
        page.goto(path.as_uri() + fragment)
        labels: list[str] = page.locator(".ledger > p:not([hidden]) a").all_text_contents()
        return labels

    return shown


@pytest.mark.parametrize(
    ("fragment", "labels"),
    [
        ("", ["eq_one", "lemma_two", "eq_three"]),
        ("#q=epsilon", ["eq_one", "eq_three"]),
        ("#q=%CE%B5", ["eq_one", "eq_three"]),
        ("#q=EPSILON0", ["eq_one"]),
        ("#q=psi", ["lemma_two"]),
        ("#only=refuted", ["lemma_two", "eq_three"]),
        ("#only=refuted,proved", ["eq_one", "lemma_two", "eq_three"]),
        ("#only=refuted,paper", ["eq_three"]),
        ("#only=lemma", ["lemma_two"]),
        ("#only=coq", ["eq_one"]),
        ("#q=epsilon&only=refuted", ["eq_three"]),
        ("#only=axioms", []),
    ],
)
def test_the_filter_reads_its_address(ledger: Any, fragment: str, labels: list[str]) -> None:
    assert ledger(fragment) == labels


def test_the_filter_keeps_its_state_in_the_address(ledger: Any, page: Any) -> None:
    ledger("")
    page.get_by_role("button", name="REFUTED").click()
    page.get_by_role("searchbox").fill("ϵ")
    assert page.locator(".ledger > p:not([hidden])").count() == 1
    assert "only=refuted" in page.url
    assert "q=" in page.url
    page.reload()
    assert page.locator(".ledger > p:not([hidden])").count() == 1
    page.get_by_role("button", name="REFUTED").click()
    page.get_by_role("searchbox").fill("")
    assert "#" not in page.url


ATLAS = """<input type="search" id="atlas-search"><span id="atlas-count"></span><ul class="atlas">
<li data-words="erfc-lead erfc for large arguments -> oo"><a>one</a></li>
<li data-words="mills-gordon mills ratio bound -> oo"><a>two</a></li>
<li data-words="sin-small sine near zero -> 0"><a>three</a></li></ul>"""


@pytest.mark.parametrize(
    ("words", "shown"),
    [
        ("erfc(x)", ["one"]),
        ("x → ∞", []),
        ("→ ∞", ["one", "two"]),
        ("Mills' ratio", ["two"]),
        ("", ["one", "two", "three"]),
    ],
)
def test_the_search_of_the_atlas(page: Any, tmp_path: Path, words: str, shown: list[str]) -> None:
    script = GENERATED.parent / "_static" / "atlas.js"
    path = tmp_path / "atlas.html"
    body = f'<main>{ATLAS}</main><script src="{script.as_uri()}"></script>'
    path.write_text(f'<!doctype html><meta charset="utf-8">{body}', encoding="utf-8")
    page.goto("about:blank")
    page.goto(path.as_uri())
    page.fill("#atlas-search", words)
    assert page.locator("ul.atlas > li:not([hidden]) a").all_text_contents() == shown
