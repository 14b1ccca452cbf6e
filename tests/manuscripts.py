"""A text as a manuscript of one file, with what is decided about its relations."""

from pathlib import Path

from hangs import HANGS

from tresym.manuscript.deciding import Row, decided
from tresym.manuscript.links import Link, read_links
from tresym.manuscript.source import read_manuscript


def links_of(folder: Path, text: str) -> list[Link]:
    """The relations of a text, which is written into the folder."""
    (folder / "m.tex").write_text(text)
    return read_links(read_manuscript(folder / "m.tex"))


def read(folder: Path, text: str) -> list[Row]:
    """What is decided about them, in one process."""
    return decided(links_of(folder, text), HANGS, 1)


def statuses(folder: Path, text: str) -> list[str]:
    """The status of each."""
    return [row.status for row in read(folder, text)]
