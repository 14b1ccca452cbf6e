"""Does every guard of every checker have its test? ``python tests/guards.py [FILE ...]``

Each mutant of mutations.py is applied in a process of its own, where those quick tests run that go
through the changed line, until one fails. What was found is in ``build/guards.jsonl``: a run that
is interrupted goes on when it is started again, a function that has not changed is not tried
again, but for its survivors that no reason excuses. ``show`` prints these; ``save`` writes
docs/measurements/guards.json.
"""

import gc
import hashlib
import json
import os
import resource
import signal
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from itertools import accumulate
from pathlib import Path
from typing import Any

import pytest
from _pytest.runner import runtestprotocol
from hypothesis import Phase, settings
from mutations import ROOT, Mutant, apply, mutants

DECISIONS = (
    *("identity", "inequalities", "equalities", "inequalities_on_regions", "dispatch"),
    *("integration_pieces", "statement"),
    *("inverse_branches", "variable_reduction", "algebraic_witnesses", "integrals"),
    *("induction", "integer_variables", "equations", "unknown_functions"),
    *("exceptional_values", "removable_holes"),
    *("readable_witnesses", "variable_exponents", "ellipsis_series", "hypergeometric"),
    *("power_series", "known_values", "factorials"),
    *("derivative_domains", "point_check", "definedness_check", "asymptotics/*"),
)
CHECKERS = (
    *("ledger/judge*.py", "ledger/refutations.py", "ledger/sample_points.py"),
    *("ledger/definitions.py", "ledger/conversion.py", "ledger/evidence/*.py"),
    *("reals/normal/*.py", "reals/signs/*.py", "reals/cross_check.py"),
    *("reals/domain/binder_values.py", "reals/domain/compiled.py"),
    *("reals/balls/branch_and_bound.py", "reals/balls/simplest_constants.py"),
    *(f"reals/decisions/{name}.py" for name in DECISIONS),
    *("reals/language/*.py", "manuscript/*.py"),
)
"""What issues verdicts, and what decides which sentence of a manuscript they are about."""
RECORD, REACHED = ROOT / "build" / "guards.jsonl", ROOT / "build" / "guards-reached.json"
EQUIVALENT = ROOT / "tests" / "data" / "equivalent.json"
SAVED = ROOT / "docs" / "measurements" / "guards.json"
MOST, SHARE = float(os.environ.get("MOST", "inf")), int(os.environ.get("SHARE", "1"))
"""Seconds of tests for each mutant; of so many mutants one is tried. ``TESTS`` names fewer."""
SECONDS, BYTES, JOBS = 5, 6 << 30, int(os.environ.get("JOBS", "2"))


def files() -> list[str]:
    """All checkers, from the root of the checkout."""
    found = (path for pattern in CHECKERS for path in sorted((ROOT / "tresym").glob(pattern)))
    return [str(path.relative_to(ROOT)) for path in found if path.name != "__init__.py"]


def record() -> dict[str, dict[str, Any]]:
    """What was found before, by the key of the mutant."""
    lines = RECORD.read_text(encoding="utf-8").splitlines() if RECORD.exists() else []
    return {line["key"]: line for line in map(json.loads, lines)}


def add(mutant: Mutant, outcome: str, by: str = "", tests: int = 0) -> None:
    """Add what became of a mutant to the record."""
    line = {"key": mutant.key, **mutant._asdict(), "outcome": outcome, "by": by, "tests": tests}
    with open(RECORD, "a", encoding="utf-8") as file:
        file.write(json.dumps(line) + "\n")


def forked(work: Iterable[Any], run: Any, jobs: int = JOBS) -> Iterator[tuple[Any, int]]:
    """Each piece of work in a process of its own, and the status with which that has ended."""
    running: dict[int, Any] = {}
    left = iter(work)
    while True:
        for item in left:
            pid = os.fork()
            if pid == 0:
                silent = os.open(os.devnull, os.O_WRONLY)
                os.dup2(silent, 1)
                os.dup2(silent, 2)
                resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
                try:
                    run(item)
                finally:
                    os._exit(0)
            running[pid] = item
            if len(running) >= jobs:
                break
        if not running:
            return
        pid, status = os.wait()
        yield running.pop(pid), status


class Guards:
    """The plugin that asks pytest for its tests and runs them in its own way."""

    def __init__(self, wanted: list[Mutant]) -> None:
        self.wanted = wanted
        self.files = sorted({mutant.file for mutant in wanted})

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        self.items = {item.nodeid: item for item in session.items}
        state = [(ROOT / f).read_bytes() for f in self.files]
        state += [path.read_bytes() for path in sorted({item.path for item in session.items})]
        stamp = hashlib.sha1(b"".join(state)).hexdigest()
        saved = json.loads(REACHED.read_text()) if REACHED.exists() else {}
        if saved.get("stamp") != stamp:
            saved = {"stamp": stamp, "tests": self.traced()}
            REACHED.write_text(json.dumps(saved))
        self.reached = saved["tests"]
        self.lines: dict[tuple[str, int], list[str]] = defaultdict(list)
        for test, (_, lines) in self.reached.items():
            for file, numbers in lines.items():
                for number in numbers:
                    self.lines[file, number].append(test)
        gc.freeze()
        done = Counter[str]()
        for mutant, status in forked(self.wanted, self.tried):
            if os.WIFSIGNALED(status):
                add(mutant, "stopped")
            done["all"] += 1
            if done["all"] % 50 == 0:
                print(f"{done['all']}/{len(self.wanted)} {mutant.file}", flush=True)
        return True

    def traced(self) -> dict[str, Any]:
        """Seconds of each test that passes, and the lines of the checkers it goes through."""
        rooms = sorted({item.path for item in self.items.values()})
        part = {path: RECORD.with_name(f"guards-{n}.json") for n, path in enumerate(rooms)}
        own = {str(ROOT / file): file for file in self.files}
        lines: dict[str, set[int]] = defaultdict(set)

        def line(frame: Any, event: str, _: Any) -> Any:
            lines[own[frame.f_code.co_filename]].add(frame.f_lineno)
            return line

        def call(frame: Any, event: str, arg: Any) -> Any:
            return line(frame, event, arg) if frame.f_code.co_filename in own else None

        def run(path: Path) -> None:
            found = {}
            items = [item for item in self.items.values() if item.path == path]
            for item, after in zip(items, [*items[1:], None], strict=True):
                lines.clear()
                began = time.process_time()
                sys.settrace(call)
                passed = _passes(item, after)
                sys.settrace(None)
                if passed:
                    reached = {file: sorted(numbers) for file, numbers in lines.items()}
                    found[item.nodeid] = time.process_time() - began, reached
            part[path].write_text(json.dumps(found))

        found: dict[str, Any] = {}
        for path, _ in forked(rooms, run):
            if part[path].exists():
                found |= json.loads(part[path].read_text())
                part[path].unlink()
        return found

    def tried(self, mutant: Mutant) -> None:
        """Run the tests that reach the mutant, those of its own file first."""
        tests = self.lines[mutant.file, mutant.line]
        if mutant.kind.startswith("sign") and not tests:  # a table, read when it was imported
            tests = list(self.reached)
        rooms = Counter[str]()
        for test in tests:
            rooms[test.partition("::")[0]] += self.reached[test][0]
        own = f"test_{Path(mutant.file).name}"

        def rank(test: str) -> tuple[Any, ...]:
            room = test.partition("::")[0]
            return not room.endswith(own), rooms[room], room, self.reached[test][0]

        ranked = sorted(tests, key=rank)
        so_far = accumulate(self.reached[test][0] for test in ranked)
        chosen = [self.items[t] for t, spent in zip(ranked, so_far, strict=True) if spent < MOST]
        seconds = int(SECONDS + 5 * min(MOST, rooms.total()))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        signal.signal(signal.SIGXCPU, signal.SIG_DFL)
        try:
            apply(mutant)
        except ValueError:
            return add(mutant, "none")
        for item, after in zip(chosen, [*chosen[1:], None], strict=True):
            if not _passes(item, after):
                return add(mutant, "killed", item.nodeid)
        return add(mutant, "survived" if chosen else "not reached", tests=len(chosen))


def _passes(item: pytest.Item, after: pytest.Item | None) -> bool:
    return not any(report.failed for report in runtestprotocol(item, log=False, nextitem=after))


def equivalent() -> list[dict[str, str]]:
    """The mutants that change nothing that could be seen, each with the reason."""
    return json.loads(EQUIVALENT.read_text(encoding="utf-8")) if EQUIVALENT.exists() else []


def is_meant(reason: dict[str, str], mutant: Mutant) -> bool:
    """Whether the reason is given for the mutant: for its piece, or for what is changed there."""
    at = mutant._asdict()
    return all(at[name] == value for name, value in reason.items() if name != "why")


def summary() -> dict[str, Any]:
    """The mutants of today's files: how many by file and outcome, and the survivors."""
    known, reasons = record(), equivalent()
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    alive = []
    for file in files():
        for m in mutants(file):
            outcome = known.get(m.key, {}).get("outcome", "not tried")
            if outcome == "none":
                continue
            if outcome in ("survived", "not reached"):
                reason = next((r["why"] for r in reasons if is_meant(r, m)), None)
                outcome = "equivalent" if reason else outcome
                alive.append({**m._asdict(), "outcome": outcome, "why": reason})
            counts[file][outcome] += 1
    return {"workload": "guards", "files": counts, "alive": alive}


def merged(stored: dict[str, Any], found: dict[str, Any]) -> dict[str, Any]:
    """What is found, and what is stored of the files in which nothing was tried since."""
    before, after = stored.get("files", {}), found["files"]
    kept = {file for file, counts in after.items() if {*counts} <= {"not tried"}} & {*before}
    files = {file: before[file] if file in kept else counts for file, counts in after.items()}
    alive = [m for m in stored.get("alive", ()) if m["file"] in kept]
    return {**found, "files": files, "alive": alive + found["alive"]}


FOLDERS = "tests/reals tests/ledger tests/dev tests/manuscript tests/test_verdicts.py"


def main() -> int:
    """Try the mutants of the files named, or of all; or ``show``, or ``save``."""
    names = sys.argv[1:]
    if names[:1] == ["save"]:
        stored = json.loads(SAVED.read_text(encoding="utf-8")) if SAVED.exists() else {}
        SAVED.write_text(json.dumps(merged(stored, summary()), indent=1) + "\n", encoding="utf-8")
        return 0
    if names[:1] == ["show"]:
        found = summary()
        for m in found["alive"]:
            if m["outcome"] != "equivalent" and (not names[1:] or m["file"] in names[1:]):
                print(f"{m['file']}:{m['line']} {m['piece']}: {m['kind']} {m['part']}: {m['was']}")
        for file, count in found["files"].items():
            print(file, dict(count))
        there = [mutant for file in files() for mutant in mutants(file)]
        for reason in equivalent():
            if not any(is_meant(reason, mutant) for mutant in there):
                print("a reason for nothing:", reason)
        return 0
    known = record()
    wanted = [m for file in names or files() for m in mutants(file)]
    again = ("not tried", "survived", "not reached")
    wanted = [m for m in wanted if known.get(m.key, {}).get("outcome", "not tried") in again]
    excused = [m for m in wanted if any(is_meant(reason, m) for reason in equivalent())]
    wanted = [m for m in wanted if m not in excused or m.key not in known]
    wanted = [m for m in wanted if int(m.key, 16) % SHARE == 0]
    RECORD.parent.mkdir(exist_ok=True)
    settings.register_profile(
        "guards",
        max_examples=25,
        deadline=None,
        derandomize=True,
        phases=[Phase.explicit, Phase.generate],
    )
    os.environ["HYPOTHESIS_PROFILE"] = "guards"
    words = ["-n", "0", "-q", "-s", "-p", "no:cacheprovider", "-o", "timeout=0"]
    words += ["-m", "not coq and not night and not slow"]
    words += ["-W", "ignore:Module already imported", "-o", "addopts=--import-mode=importlib"]
    words += os.environ.get("TESTS", FOLDERS).split()
    return int(pytest.main(words, plugins=[Guards(wanted)]))


if __name__ == "__main__":
    os.chdir(ROOT)
    sys.exit(main())
