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


def test_a_reason_is_given_for_mutants_of_its_piece_alone(checker: ModuleType) -> None:
    found = [mutant for mutant in mutants(checker.file) if mutant.kind == "bound"]
    piece = {"file": checker.file, "piece": "holds", "why": "none"}
    assert found
    for mutant in found:
        assert guards.is_meant(piece, mutant)
        assert guards.is_meant({**piece, "kind": "bound", "was": mutant.was}, mutant)
        assert not guards.is_meant({**piece, "was": "another test"}, mutant)
        assert not guards.is_meant({**piece, "piece": "ALLOWED"}, mutant)
    assert all({"file", "piece", "why"} <= {*reason} for reason in guards.equivalent())


def test_a_mutant_is_known_again_while_its_function_is_the_same(checker: ModuleType) -> None:
    keys = [mutant.key for mutant in mutants(checker.file)]
    assert len({*keys}) == len(keys)
    moved = Mutant(**{**mutants(checker.file)[0]._asdict(), "line": 99})
    assert moved.key == keys[0]


def test_a_need_is_dropped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source = """
def need(shown, why):
    if not shown:
        raise ValueError(why)


def holds(low):
    need(low > 0, "it is too low")
    return True
"""
    path = tmp_path / "needing.py"
    path.write_text(source)
    module = ModuleType("needing")
    exec(source, module.__dict__)
    monkeypatch.setitem(sys.modules, str(path).removesuffix(".py").replace("/", "."), module)
    with pytest.raises(ValueError, match="too low"):
        module.holds(0)
    (dropped,) = (mutant for mutant in mutants(str(path)) if mutant.kind == "need dropped")
    assert dropped.was == "low > 0"
    apply(dropped)
    assert module.holds(0)


def test_what_is_stored_of_a_file_stays_until_something_of_it_is_tried() -> None:
    stored = {
        "files": {"a.py": {"killed": 3}, "b.py": {"killed": 5, "survived": 1}, "gone.py": {}},
        "alive": [{"file": "b.py", "node": 1}, {"file": "gone.py"}],
    }
    found = {
        "workload": "guards",
        "files": {"a.py": {"survived": 1}, "b.py": {"not tried": 6}, "new.py": {"not tried": 2}},
        "alive": [{"file": "a.py", "node": 2}],
    }
    assert guards.merged(stored, found) == {
        "workload": "guards",
        "files": {
            "a.py": {"survived": 1},
            "b.py": stored["files"]["b.py"],
            "new.py": {"not tried": 2},
        },
        "alive": [{"file": "b.py", "node": 1}, {"file": "a.py", "node": 2}],
    }
    assert guards.merged({}, found) == found
