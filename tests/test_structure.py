"""The house: a file imports only from its own package or from floors below it."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

FLOORS = {
    "verdict": 1,
    "exact": 1,
    "arithmetic": 1,
    "notation": 1,
    "body": 1,
    "processes": 1,
    "identity": 2,
    "formulas": 2,
    "claims": 3,
    "flip": 3,
    "report": 4,
    "bench": 4,
    "audit": 4,
    "sweep": 4,
    "verification": 4,
    "checking": 4,
    "proofs": 4,
    "cli": 5,
    "site": 6,
    "__main__": 6,
    "__init__": 0,
}

FILES = sorted([*ROOT.glob("tresym/**/*.py"), *ROOT.glob("proofs/*.py")])


def part_of(path: Path) -> str:
    relative = path.relative_to(ROOT)
    if relative.parts[0] == "proofs":
        return "proofs"
    return relative.parts[1].removesuffix(".py")


def imported(path: Path) -> set[str]:
    """Parts of tresym that a file imports, anywhere in it."""
    parts = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = []
        if isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            names = [node.module or ""]
            if node.module == "tresym":
                names = [f"tresym.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        parts |= {n.split(".")[1] for n in names if n.startswith("tresym.")}
        parts |= {"proofs" for n in names if n.split(".")[0] == "proofs"}
    return parts


@pytest.mark.parametrize("path", FILES, ids=lambda p: str(p.relative_to(ROOT)))
def test_imports_stay_on_or_below_the_floor(path: Path) -> None:
    part = part_of(path)
    for other in imported(path):
        if other == part or FLOORS.get(other, 0) < FLOORS[part]:
            continue
        beside = FLOORS.get(other) == FLOORS[part] and FLOORS[part] in (1, 4)
        assert beside, f"{path} imports tresym.{other}"


def test_only_the_verification_and_the_command_line_import_the_proofs() -> None:
    importers = {part_of(p) for p in FILES if "proofs" in imported(p)}
    assert importers <= {"proofs", "verification", "cli"}
