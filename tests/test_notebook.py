"""The notebook of the documents shows what its cells show when they are run."""

import json
import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

import pytest
from notebook import run

import tresym

NOTEBOOK = Path(__file__).parents[1] / "docs" / "examples" / "first-steps.ipynb"


def test_the_notebook_shows_what_it_shows_when_it_is_run() -> None:
    book = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    assert book["nbformat"] == 4
    assert run(book) == book
    shown = [cell["outputs"][0]["data"] for cell in book["cells"] if cell.get("outputs")]
    assert all("\n" not in data["text/plain"] for data in shown)
    assert sum("text/html" in data for data in shown) >= 5


def test_a_report_is_a_frame_where_pandas_is(monkeypatch: pytest.MonkeyPatch) -> None:
    report = tresym.verify("eq_gamma")
    if find_spec("pandas") is None:
        with pytest.raises(tresym.InputError, match="needs pandas"):
            report.to_frame()
        frames = SimpleNamespace(DataFrame=list)
        monkeypatch.setitem(sys.modules, "pandas", frames)
        found = report.to_frame()
        assert found[-1]["label"] == "eq_gamma"
        assert found[-1]["verdict"] == "PROVED"
    else:
        assert list(report.to_frame()["label"])[-1] == "eq_gamma"
