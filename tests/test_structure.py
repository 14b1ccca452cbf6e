"""The architecture: layers of packages, what each may import and load, and the list of them."""

import ast
import re
import subprocess
import sys
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest
from tresym.proofs import PARTS

ROOT = Path(__file__).resolve().parent.parent

LAYERS = (
    ("reals",),
    ("asymptotics",),
    ("checking",),
    ("repair",),
    ("accuracy",),
    ("racket", "output", "ledger", "release", "entries"),
    ("papers",),
    ("sweep", "coq", "manuscript"),
    ("report",),
    ("proofs", "dev"),
    ("commands", "testing", "sphinx"),
    ("site", "__main__", "pytest_plugin"),
)
"""The layers from the bottom up: a package imports from lower layers, not from its neighbours."""

INSIDE = {
    "reals": (
        ("numbers", "notebook", "verdict"),
        ("functions",),
        ("computed_once", "language", "resource_limits"),
        ("processes",),
        ("domain", "cross_check"),
        ("normal",),
        ("signs", "balls"),
        ("expansions", "values"),
        ("decisions",),
    ),
    "racket": (
        ("notation", "formulas"),
        ("body",),
        ("angle", "result", "floats"),
        ("motion",),
        ("flip",),
        ("bounds", "comparison"),
    ),
    "report": (("typesetting",), ("figures",), ("charts",), ("pages",)),
}
"""The same for the packages inside a package."""

FILES = sorted([*ROOT.glob("tresym/**/*.py"), *ROOT.glob("proofs/**/*.py")])


def name_of(path: Path) -> tuple[str, ...]:
    """The import name of a file, without the leading ``tresym``."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    parts = parts if parts[0] == "proofs" else parts[1:]
    return parts[:-1] if parts[-1] == "__init__" else parts


MODULES = {name_of(path) for path in FILES}


@cache
def imported(path: Path) -> set[tuple[str, ...]]:
    """The modules of tresym that a file imports, anywhere in it, for type checkers too."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = []
        if isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            whole = [f"{node.module}.{alias.name}" for alias in node.names]
            names = [n if tuple(n.split(".")[1:]) in MODULES else str(node.module) for n in whole]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        assert not any(n.split(".")[0] == "proofs" for n in names), f"{path}: say tresym.proofs"
        found |= {tuple(n.split(".")[1:]) for n in names if n.startswith("tresym.")}
    return found


def layer_of(package: str, layers: tuple[tuple[str, ...], ...]) -> int:
    """How high a package lies."""
    (layer,) = (n for n, packages in enumerate(layers) if package in packages)
    return layer


@pytest.mark.slow
def test_a_file_imports_only_from_its_own_package_and_those_below() -> None:
    for path in FILES:
        here = name_of(path)
        for there in imported(path) if here else ():
            if here[0] != there[0]:
                assert layer_of(there[0], LAYERS) < layer_of(here[0], LAYERS), (here, there)
            elif here[0] in INSIDE and len(here) > 1 and len(there) > 1 and here[1] != there[1]:
                layers = INSIDE[here[0]]
                assert layer_of(there[1], layers) < layer_of(here[1], layers), (here, there)


def test_no_modules_import_one_another_in_a_circle() -> None:
    """Not even for type checkers; the package itself names everything that it offers."""
    open_ = {name_of(path): imported(path) - {()} for path in FILES if name_of(path)}
    while leaves := [name for name, used in open_.items() if not used & open_.keys() - {name}]:
        for name in leaves:
            del open_[name]
    assert set(open_) == set()


RACKET = {
    ("racket",), ("sweep",), ("proofs",), ("dev",),
    *(("commands", name) for name in ("flip", "sweep", "figure", "bodies")),
}  # fmt: skip
"""The packages and commands of the paper on the racket; no other module knows it."""


@pytest.mark.slow
def test_only_the_paper_on_the_racket_imports_the_racket() -> None:
    for path in FILES:
        here = name_of(path)
        if here and here[:1] not in RACKET and here[:2] not in RACKET:
            assert ("racket",) not in {there[:1] for there in imported(path)}, here


def test_every_package_has_a_layer() -> None:
    packages = {name[0] for name in MODULES if name}
    assert packages == {package for layer in LAYERS for package in layer}
    for outer, layers in INSIDE.items():
        inner = {name[1] for name in MODULES if name[:1] == (outer,) and len(name) > 1}
        assert inner == {package for layer in layers for package in layer}


def test_the_proofs_are_read_from_top_to_bottom() -> None:
    """No part imports from a later one."""
    place = {("proofs", part): n for n, part in enumerate(PARTS)}
    for path in ROOT.glob("proofs/*.py"):
        here = name_of(path)
        for there in imported(path):
            if there[0] == "proofs" and len(there) > 1:
                assert place.get(there, -1) < place.get(here, len(PARTS)), (here, there)


def test_a_file_of_reals_loads_nothing_but_python_flint() -> None:
    names = [".".join(("tresym", *name)) for name in MODULES if name[:1] == ("reals",)]
    code = f"import {', '.join(sorted(names))}"
    assert loaded(code) & {"sympy", "numpy", "mpmath", "scipy"} == set()
    tresym = {n for n in loaded(code, "tresym.") if n.split(".")[1] != "reals"}
    assert tresym == set()


@pytest.mark.parametrize(
    "code",
    [
        "import tresym",
        "from tresym.commands import main; main(['flip', '--body', 'str'])",
        "from tresym.commands import main; main(['check', 'exp(x) >= 1 + x'])",
    ],
)
def test_what_is_instant_loads_flint_alone(code: str) -> None:
    heavy = {"sympy", "numpy", "mpmath", "scipy", "matplotlib"}
    assert loaded(code) & (heavy | ({"flint"} if code == "import tresym" else set())) == set()


def loaded(code: str, prefix: str = "") -> set[str]:
    """What a new process has loaded after ``code``: top-level names, or those with the prefix."""
    show = "import sys; sys.stderr.write(' '.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", f"{code}\n{show}"], capture_output=True, text=True, check=True
    )
    names = set(done.stderr.split())
    return (
        {n for n in names if n.startswith(prefix)}
        if prefix
        else names & {n.split(".")[0] for n in names}
    )


MAPPED = re.compile(r"^\| `([\w./]+?)/?` \| (.+) \|$", re.MULTILINE)


def test_the_map_shows_every_package_and_says_what_it_says_of_itself() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    shown = dict(MAPPED.findall(text.split("<!-- map -->")[1]))
    packages = [package for layer in LAYERS for package in layer if package != "__main__"]
    packages += [f"reals/{package}" for layer in INSIDE["reals"] for package in layer]
    packages = [r for r in packages if (ROOT / "tresym" / r).is_dir()]
    assert sorted(shown) == sorted(packages)
    for package, says in shown.items():
        doc = import_module(f"tresym.{package.replace('/', '.')}").__doc__ or ""
        assert says == doc.strip().splitlines()[0].rstrip("."), package


def test_the_readme_names_the_packages() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    for package in (
        package
        for layer in LAYERS
        for package in layer
        if package not in ("output", "release", "pytest_plugin", "testing", "sphinx", "__main__")
    ):
        assert f"`{package}/`" in text, package


@pytest.mark.slow
def test_no_generator_waits_while_it_holds_the_precision() -> None:
    """What its caller does meanwhile would run at that precision, and other threads would wait."""
    for path in FILES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [ast.unparse(i) for i in node.items] if isinstance(node, ast.With) else []
            if any("_precision(" in name for name in names):
                inner = [n for n in ast.walk(node) if isinstance(n, ast.Yield | ast.YieldFrom)]
                assert not inner or path.name == "arithmetic.py", (path, node.lineno)
