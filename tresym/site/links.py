"""Check the links of the built site: ``python -m tresym.site.links build/site``.

Every link within the site must lead to an existing file and anchor, every image must have an
alternative text, and no page may load anything from a network. Links to other sites are allowed and
not followed.
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
    """The anchors of a page, its links, what it loads, and its images without alternative text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.places: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.wordless: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect the data of one element."""
        found = {name: value or "" for name, value in attrs}
        self.places.update(found[name] for name in ("id", "name") if name in found)
        if tag == "a" and "href" in found:
            self.links.append(found["href"])
        if _LOADED.get(tag) in found and found.get("rel") not in ("canonical", "alternate"):
            self.loads.append(found[_LOADED[tag]])
        if tag == "img" and not found.get("alt"):
            self.wordless.append(found.get("src", ""))


def faults(site: Path) -> Iterator[str]:
    """Yield one line for each fault of the site."""
    pages = {
        path.resolve(): _Page(path.read_text(encoding="utf-8"))
        for path in sorted(site.rglob("*.html"))
    }
    for path, page in pages.items():
        name = path.relative_to(site.resolve())
        for target in (*page.links, *page.loads):
            if not _leads_somewhere(path, target, pages):
                yield f"{name}: the link {target} is broken"
        for target in page.loads:
            if _OUTSIDE.match(target):
                yield f"{name}: {target} is loaded from a network"
        for picture in page.wordless:
            yield f"{name}: the image {picture} has no alternative text"
    for path in sorted(site.rglob("*.css")):
        if _IN_STYLE.search(path.read_text(encoding="utf-8")):
            yield f"{path.relative_to(site)}: a style is loaded from a network"


def _leads_somewhere(path: Path, target: str, pages: dict[Path, _Page]) -> bool:
    """Whether the target of a link exists; links to other sites count as existing."""
    split = urlsplit(target)
    if split.scheme or split.netloc:
        return True
    goal = (path.parent / unquote(split.path)).resolve() if split.path else path
    if not goal.is_file():
        return False
    place = unquote(split.fragment)
    return not place or goal not in pages or place in pages[goal].places


def main(arguments: list[str]) -> int:
    """Print every fault.

    Returns:
        The exit status: 1 if there is a fault, 2 if there is no site.
    """
    site = Path(arguments[0] if arguments else "build/site")
    if not (site / "index.html").is_file():
        print(f"{site}: there is no index.html here; build the site first", file=sys.stderr)
        return 2
    found = list(faults(site))
    pages = sum(1 for _ in site.rglob("*.html"))
    print("\n".join(found) or f"{pages} pages: no broken link, nothing is loaded from a network")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
