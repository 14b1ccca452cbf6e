"""Version, date and commit, as citations give them."""

import re
from pathlib import Path

import pytest

import tresym
from tresym import release
from tresym.commands import main

ROOT = Path(__file__).resolve().parent.parent


def test_the_version_is_printed_with_its_commit(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith(f"tresym {tresym.__version__}")
    if (ROOT / ".git").exists():
        assert re.search(r"\(commit [0-9a-f]{10}\)", printed)


def test_version_and_date_agree_with_the_citation_file() -> None:
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"version: {tresym.__version__}\n" in text
    assert f"date-released: {release.RELEASED}\n" in text
