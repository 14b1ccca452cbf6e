"""Every committed picture in a real browser: no letter of it lies beyond its rim."""

import os
import shutil
from collections.abc import Iterator
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
