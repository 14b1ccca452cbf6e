"""The tool that changes the checkers: what it changes, that it does so, and in memory alone."""

import sys
from pathlib import Path
from types import ModuleType

import guards
import pytest
from mutations import Mutant, apply, mutants

CHECKER = """
ALLOWED = ("+", ">=0")

def holds(sign: str | None, low: int, parts: list[int]) -> bool:
    if sign is None or low < 0:
        return False
    for part in parts:
        if part <= 0:
            return False
    return sign in ALLOWED and low > 2 and all(part < 9 for part in parts)
"""


@pytest.fixture
def checker(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    path = tmp_path / "checker.py"
    path.write_text(CHECKER)
    module = ModuleType("checker")
    module.__dict__["file"] = str(path)
    exec(CHECKER, module.__dict__)
    monkeypatch.setitem(sys.modules, str(path).removesuffix(".py").replace("/", "."), module)
    return module


PASSES = ("+", 3, [1, 2])
FALSE = [
    (None, 3, [1]),
    ("+", -1, [1]),
    ("+", 2, [1]),
    ("-", 3, [1]),
    ("0", 3, [1]),
    ("<=0", 3, [1]),
    ("+", 3, [0]),
    ("+", 3, [1, -1]),
    ("+", 3, [9]),
    ("+", 3, [1, 10]),
]


def test_each_change_lets_something_false_pass_or_refuses_what_is_true(checker: ModuleType) -> None:
    assert checker.holds(*PASSES)
    assert not any(checker.holds(*claim) for claim in FALSE)
    alive = []
    for mutant in mutants(checker.file):
        exec(CHECKER, checker.__dict__)
        apply(mutant)
        try:
            same = checker.holds(*PASSES) and not any(checker.holds(*claim) for claim in FALSE)
        except TypeError:
            same = False
        if same:
            alive.append((mutant.kind, mutant.was))
    # Another guard refuses these too, a sign that is none, or is dropped and was not needed.
    assert sorted(alive) == [
        ("constant", "low < 0"),
        ("dropped", "low < 0"),
        ("dropped", "sign is None"),
        ("guard deleted", "sign is None or low < 0"),
        ("sign dropped", "('+', '>=0')"),
    ]
    assert Path(checker.file).read_text() == CHECKER


@pytest.mark.parametrize(
    "kind",
    [
        *("guard deleted", "negated", "dropped", "bound", "constant", "all or any"),
        *("first turn only", "returned at once", "sign added", "sign dropped"),
    ],
)
def test_there_is_a_mutant_of_each_kind(kind: str, checker: ModuleType) -> None:
    assert kind in {mutant.kind for mutant in mutants(checker.file)}


def test_what_is_equivalent_is_so_of_mutants_that_are_there() -> None:
    there = [mutant for file in guards.files() for mutant in mutants(file)]
    for reason in guards.equivalent():
        assert {"file", "piece", "why"} <= {*reason}
        assert any(guards.is_meant(reason, mutant) for mutant in there), reason


def test_a_mutant_is_known_again_while_its_function_is_the_same(checker: ModuleType) -> None:
    keys = [mutant.key for mutant in mutants(checker.file)]
    assert len({*keys}) == len(keys)
    moved = Mutant(**{**mutants(checker.file)[0]._asdict(), "line": 99})
    assert moved.key == keys[0]
