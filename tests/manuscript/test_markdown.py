"""Markdown pages are read as LaTeX, with the same lines."""

from pathlib import Path

from tresym.manuscript.deciding import decided
from tresym.manuscript.links import read_links
from tresym.manuscript.markdown import as_latex
from tresym.manuscript.source import read_manuscript

PAGE = r"""---
title: $$ 1 = 2 $$
---
# First

Let $w = x^2$ in 50% of the cases.

```python
$$ 1 + 1 = 3 $$
```

| $\|x\|$ | b |

$$ x^2 - 1 = (x-1)(x+1) $$

**Example 1.** Let $w = x^3$.

**Example 2.** Now

$$ w^2 = x^6 $$

> Differentiate $x^2$:

$$ = 2x $$

Expand $(x+1)^2$.

$$ = x^2 + 2x + 1 $$

$$ = x^2 + 2x - 1 $$

<!-- tresym: given u > 0 -->
$$ \sqrt{u^2} = u $$

It is said that

$$ = u + 1 $$
"""


def test_a_page_is_read(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text(PAGE)
    rows = decided(read_links(read_manuscript(tmp_path / "page.md")), 5.0, 1)
    found = [(row.link.display.line, row.status) for row in rows]
    assert found[:2] == [(14, "PROVED"), (20, "EQUATION")]
    assert found[2:5] == [(24, "UNREAD"), (28, "PROVED"), (30, "REFUTED")]
    assert found[5:] == [(33, "PROVED"), (37, "UNREAD")]


def test_lines_stay_where_they_are() -> None:
    latex = as_latex(PAGE).split("\n")
    assert len(latex) == len(PAGE.split("\n"))
    assert latex[3] == r"\section{First}"
    assert latex[11] == r"| $|x|$ | b |"
    assert r"50\% of" in latex[5]


BLOCKS = r"""
````{admonition} Fact
:class: tip

:::{math}
1 + 1 = 2
:::
```python
$$ 1 + 1 = 4 $$
```
$$ 1 + 1 = 3 $$
````

```{exercise}
:label: one
Let $h(t) = e^{2t}$.
$$ h'(t) = 2 h(t) $$
```

```{prf:example}
$$ h'(t) = 2 h(t) $$
```

```{code-cell} python
$$ 1 + 1 = 5 $$
```
"""


def test_blocks_of_text_are_read_and_blocks_of_code_are_not(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text(BLOCKS)
    rows = decided(read_links(read_manuscript(tmp_path / "page.md")), 5.0, 1)
    found = [(row.link.display.line, row.status) for row in rows]
    assert found[:2] == [(5, "PROVED"), (11, "REFUTED")]
    assert found[2:] == [(17, "PROVED"), (21, "EQUATION")]
