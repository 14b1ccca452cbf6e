"""A paper of a few lines, in place of the paper on the racket."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tresym.ledger.paper import Paper
from tresym.papers.ledger_claims import read_part

Stated = Callable[[str], Paper]


@pytest.fixture
def stated(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Stated:
    """Take the claims of a text as the paper."""

    def take(text: str) -> Paper:
        (tmp_path / "lines.tresym").write_text(text, encoding="utf-8")
        claims = tuple(read_part(tmp_path / "lines.tresym", lambda name: {}).claims.values())
        made = Paper("lines", lambda *_: (("lines", claims),), ("lines",), folder=tmp_path)
        monkeypatch.setattr("tresym.ledger.paper.racket", lambda: made)
        return made

    return take
