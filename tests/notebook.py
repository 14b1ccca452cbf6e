"""A notebook run without a server: ``python tests/notebook.py PATH`` stores what its cells show.

A cell is run as a notebook runs it: its statements, and what its last expression shows of itself as
text, HTML and LaTeX. Anything that runs notebooks opens the file.
"""

import ast
import json
import sys
from pathlib import Path
from typing import Any

SHOWN = {"text/html": "_repr_html_", "text/latex": "_repr_latex_"}


def run(book: dict[str, Any]) -> dict[str, Any]:
    """The notebook with the outputs that its cells have now, run in their order."""
    names: dict[str, Any] = {}
    cells = []
    for cell in book["cells"]:
        if cell["cell_type"] == "code":
            cell = cell | {"outputs": _outputs("".join(cell["source"]), names)}
        cells.append(cell)
    return book | {"cells": cells}


def _outputs(source: str, names: dict[str, Any]) -> list[dict[str, Any]]:
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "<cell>", "exec"), names)
    if not isinstance(last, ast.Expr):
        return []
    value = eval(compile(ast.Expression(last.value), "<cell>", "eval"), names)
    data = {kind: getattr(value, name)() for kind, name in SHOWN.items() if hasattr(value, name)}
    return [
        {
            "output_type": "execute_result",
            "execution_count": None,
            "metadata": {},
            "data": {"text/plain": repr(value)} | data,
        }
    ]


if __name__ == "__main__":
    path = Path(sys.argv[1])
    found = run(json.loads(path.read_text(encoding="utf-8")))
    path.write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
