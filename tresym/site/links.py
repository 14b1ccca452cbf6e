"""Check the links of the built site: ``python -m tresym.site.links build/site``.

Every link within the site leads to a file and a place that are there, every picture has a text in
its stead, and nothing that a page loads comes from a network. Links for readers to other sites are
allowed and not followed.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

_LOADED = {"link": "href", "script": "src", "img": "src", "iframe": "src", "object": "data"}
_OUTSIDE = re.compile(r"^(?:https?:)?//")
_IN_STYLE = re.compile(r"(?:url\(|@import)\s*['\"]?(?:https?:)?//")


class _Page(HTMLParser):
    """The places of a page, what it links to, what it loads, and its pictures without a text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.places: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.wordless: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect from one element."""
        found = {name: value or "" for name, value in attrs}
        self.places.update(found[name] for name in ("id", "name") if name in found)
        if tag == "a" and "href" in found:
            self.links.append(found["href"])
        if _LOADED.get(tag) in found and found.get("rel") not in ("canonical", "alternate"):
            self.loads.append(found[_LOADED[tag]])
        if tag == "img" and not found.get("alt"):
            self.wordless.append(found.get("src", ""))


def faults(site: Path) -> Iterator[str]:
    """What is wrong, one line each; none when the site is whole."""
    pages = {
        path.resolve(): _Page(path.read_text(encoding="utf-8"))
        for path in sorted(site.rglob("*.html"))
    }
    for path, page in pages.items():
        name = path.relative_to(site.resolve())
        for target in (*page.links, *page.loads):
            if not _leads_somewhere(path, target, pages):
                yield f"{name}: {target} leads nowhere"
        for target in page.loads:
            if _OUTSIDE.match(target):
                yield f"{name}: {target} is loaded from a network"
        for picture in page.wordless:
            yield f"{name}: {picture} has no text in its stead"
    for path in sorted(site.rglob("*.css")):
        if _IN_STYLE.search(path.read_text(encoding="utf-8")):
            yield f"{path.relative_to(site)}: a style is loaded from a network"


def _leads_somewhere(path: Path, target: str, pages: dict[Path, _Page]) -> bool:
    split = urlsplit(target)
    if split.scheme or split.netloc:
        return True
    goal = (path.parent / unquote(split.path)).resolve() if split.path else path
    if not goal.is_file():
        return False
    place = unquote(split.fragment)
    return not place or goal not in pages or place in pages[goal].places


def main(arguments: list[str]) -> int:
    """Print every fault; exit status 1 when there is one, 2 when there is no site."""
    site = Path(arguments[0] if arguments else "build/site")
    if not (site / "index.html").is_file():
        print(f"{site}: there is no site here", file=sys.stderr)
        return 2
    found = list(faults(site))
    pages = sum(1 for _ in site.rglob("*.html"))
    print("\n".join(found) or f"{pages} pages: every link leads somewhere, nothing is fetched")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
