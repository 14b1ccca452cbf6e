"""The Sphinx extension in a real project: reST and MyST pages, and a build that fails."""

import subprocess
import sys
from pathlib import Path

import pytest

CONF = 'project = "own"\nextensions = ["myst_parser", "tresym.sphinx"]\nexclude_patterns = []\n'
REST = """Own
===

.. tresym-claim:: sin(x) == x + O(x**3)
   :as: x -> 0

.. tresym-claim:: x**2 > 0
   :expect: REFUTED

.. tresym-table:: tan(x)
   :approx: x + x**3/3
   :as: x -> 0+
   :at: 1/10, 1/100
   :order: x**5
   :on: 0 < x <= 1

.. tresym-chart:: tan(x)
   :approx: x; x + x**3/3
   :as: x -> 0+
   :at: 1/10, 1/100

.. toctree::

   other
"""
MYST = """# Other

```{tresym-claim} exp(x) >= 1 + x
```

```{tresym-table} root(y - e*sin(y) - 1, y, 0, 4)
:approx: 1 + e*sin(1)
:as: e -> 0+
:at: 1/10
:digits: 12
```
"""


def built(folder: Path, rest: str = REST, myst: str = MYST) -> "subprocess.CompletedProcess[str]":
    (folder / "conf.py").write_text(CONF)
    (folder / "index.rst").write_text(rest)
    (folder / "other.md").write_text(myst)
    return subprocess.run(
        [
            sys.executable,
            "-m",
            "sphinx",
            "-W",
            "-q",
            "-b",
            "html",
            str(folder),
            str(folder / "out"),
        ],
        capture_output=True,
        text=True,
    )


@pytest.mark.slow
def test_pages_show_verdicts_tables_and_charts(tmp_path: Path) -> None:
    done = built(tmp_path)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    assert "ENCLOSED" in page
    assert "REFUTED" in page
    assert "0.10033467208545054506" in page
    assert "between 0.224074 and 0.224658" in page
    assert '<figure class="tresym-chart"><svg' in page
    other = (tmp_path / "out" / "other.html").read_text(encoding="utf-8")
    assert "PROVED" in other
    assert "1.08859775240" in other
    # a page that did not change is not computed again, and the verdict of a changed one is new
    failed = built(tmp_path, REST, MYST.replace("1 + x", "1 + 2*x"))
    assert failed.returncode == 2
    assert "other.md:3" in failed.stderr
    assert "is REFUTED, expected PROVED or ENCLOSED" in failed.stderr


@pytest.mark.parametrize(
    ("directive", "why"),
    [
        (".. tresym-claim:: x +\n", "not an expression"),
        (".. tresym-claim:: x**2 >= 0\n   :expect: REFUTED\n", "is PROVED, expected REFUTED"),
        (".. tresym-table:: tan(x)\n   :approx: x\n", "needs :approx: and :as:"),
        (".. tresym-table:: tan(x)\n   :approx: y\n   :as: x -> 0\n", "give the value of y"),
    ],
)
@pytest.mark.slow
def test_a_build_ends_with_the_place(directive: str, why: str, tmp_path: Path) -> None:
    done = built(tmp_path, f"Own\n===\n\n{directive}", "# Other\n")
    assert done.returncode == 2
    assert why in done.stderr
    assert "index.rst:4" in done.stderr
