"""Account for the methods: switch each off in turn, and count the claims that lose their verdict.

``python tests/account.py [--save] [--every N] [METHOD ...]`` decides every claim of the
collections once, or each N-th, noting which methods return something for it. Then each method is
switched off in processes of its own, and those claims are decided again. A claim is lost if it had
a verdict and has none now. The lines of a method are those that no other code of the verdicts
reaches. A small part of the claims is enough for a first look; a method that a claim uses and that
has a substitute loses nothing.

The collections are the lists of :mod:`tresym.dev.corpus`, random identities, the lists in
``tests/data``, the claims read in the manuscripts of ``tests/data`` and ``docs/examples``, and the
ledger. A claim of the ledger is judged as if all others had the verdicts that are expected.
"""

import argparse
import gc
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from methods import METHODS, REASONS

import tresym
from tresym.dev.bench.workloads import json_text
from tresym.dev.corpus.lists import known, pairs
from tresym.dev.corpus.rewriting import false_identity, true_identity
from tresym.ledger import paper
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.manuscript.links import read_links
from tresym.manuscript.source import read_manuscript
from tresym.output import write_text
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.dispatch import decide_claim
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import cores
from tresym.reals.resource_limits import TimeUp, time_limit
from tresym.reals.verdict import Verdict
from tresym.report.pages.trusted_code import ROOTS, counted, reached

ROOT = Path(tresym.__file__).resolve().parent.parent
SAVED = ROOT / "docs" / "measurements" / "account.json"
LIMIT = 20.0
"""Seconds of processor time for a claim."""
RANDOM = 150
"""True and false random identities, of each."""
FEW = 5
"""A method that loses fewer claims per hundred lines needs a reason."""
CHUNKS = 20
"""Processes in which the claims are decided while the methods are observed."""
UNDECIDED = Verdict.UNDECIDED


class Asked(NamedTuple):
    """A claim of a collection, as text, or as the label of a claim of the ledger."""

    collection: str
    claim: str


class Found(NamedTuple):
    """The verdict on a claim, and the methods that returned something for it."""

    number: int
    verdict: str
    used: frozenset[str] = frozenset()


# The collections


def collections() -> Iterator[Asked]:
    """Yield all claims, each once in its collection."""
    for name, claims in _collections():
        yield from (Asked(name, claim) for claim in dict.fromkeys(claims))


def _collections() -> Iterator[tuple[str, Iterable[str]]]:
    yield "antiderivatives", (pair.claim for pair in pairs())
    for name in ("inequalities", "orders"):
        yield name, (claim.claim for claim in known(name))
    for make in (true_identity, false_identity):
        sides = (make(Random(seed)) for seed in range(RANDOM))
        yield make.__name__, (f"{left} == {right}" for left, right in sides)
    data = ROOT / "tests" / "data"
    for path in sorted((data / "claims").glob("*.txt")):
        lines = path.read_text(encoding="utf-8").splitlines()
        yield f"unseen {path.stem}", (line.split(" | ", 1)[1] for line in lines if " | " in line)
    for path in sorted([*data.glob("*.tex"), *ROOT.glob("docs/examples/*.tex")]):
        yield f"manuscript {path.stem}", _claims_of(path)
    yield "ledger", (claim.label for claim in paper.all_claims())


def _claims_of(path: Path) -> Iterator[str]:
    """The claims that are decided for a manuscript."""
    for link in read_links(read_manuscript(path)):
        yield from (str(asked.text) + str(asked.under) for asked in link.claims)


# Deciding, with methods observed or switched off


def verdict_of(asked: Asked, findings: dict[str, Finding]) -> str:
    """Return the verdict, or why there is none."""
    try:
        with time_limit(LIMIT):
            if asked.collection == "ledger":
                claims = {claim.label: claim for claim in paper.all_claims()}
                return str(judge(claims[asked.claim], findings).verdict.value)
            return decide_claim(asked.claim).verdict.value
    except TimeUp:
        return UNDECIDED.value
    except InputError:
        return "not read"
    except Exception as error:
        return type(error).__name__


def replaced(name: str, other: Callable[[Callable[..., Any]], Callable[..., Any]]) -> None:
    """Replace a function in this process, wherever it is named, by ``other(function)``."""
    function = _function(name)
    if function.__closure__ is not None:
        raise ValueError(f"{name}: a closure cannot be replaced")
    copy = type(function)(function.__code__, function.__globals__, name, function.__defaults__)
    copy.__kwdefaults__, copy.__annotations__ = function.__kwdefaults__, function.__annotations__

    def stub(*args: Any, _other: Any, **named: Any) -> Any:
        return _other(*args, **named)

    function.__code__, function.__defaults__ = stub.__code__, None
    function.__kwdefaults__ = {"_other": other(copy)}


def _function(name: str) -> Any:
    """The function of that name, without the caches around it."""
    module, _, rest = name.rpartition(".")
    owners: list[str] = []
    while True:
        try:
            found: Any = import_module(f"tresym.{module}")
            break
        except ModuleNotFoundError:
            module, _, owner = module.rpartition(".")
            owners.insert(0, owner)
    for part in (*owners, rest):
        found = vars(found)[part]
    while hasattr(found, "__wrapped__"):
        found = found.__wrapped__
    return found


def nothing(function: Callable[..., Any]) -> Any:
    """Return what a function returns that finds nothing."""
    returns = str(function.__annotations__["return"])
    if returns.endswith("None"):
        return None
    if returns.endswith("Answer"):
        return Answer(UNDECIDED, "the method is switched off")
    if returns.endswith("Finding"):
        return Finding(UNDECIDED, "the method is switched off")
    if returns.startswith(("tuple", "Iterator", "list")):
        return ()
    return {"bool": False, "int": 0}[returns]


def off(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that finds nothing."""
    found = nothing(function)
    return lambda *args, **named: iter(found) if found == () else found


def observed(name: str, used: set[str]) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Return a wrapper of a function that adds its name to ``used`` when it finds something."""

    def wrapper(function: Callable[..., Any]) -> Callable[..., Any]:
        empty = nothing(function)

        def observing(*args: Any, **named: Any) -> Any:
            found = function(*args, **named)
            open_ = isinstance(found, Answer | Finding) and found.verdict is UNDECIDED
            if not open_ and found is not empty:
                used.add(name)
            return found

        return observing

    return wrapper


_asked: list[Asked] = []
_findings: dict[str, Finding] = {}


def forget() -> None:
    """Empty every cache of functions, so that a claim is decided as if it were the first."""
    for found in gc.get_objects():
        if isinstance(found, type(_all_lines)) and found.__module__.startswith("tresym.reals"):
            found.cache_clear()


def _watched(numbers: list[int]) -> list[Found]:
    """Decide claims in a fresh process, with every method observed."""
    used: set[str] = set()
    for name in METHODS:
        replaced(name, observed(name, used))
    return [Found(n, *_observed(n, used)) for n in numbers]


def _observed(number: int, used: set[str]) -> tuple[str, frozenset[str]]:
    forget()
    used.clear()
    return verdict_of(_asked[number], _findings), frozenset(used)


def _without(work: tuple[str, list[int]]) -> tuple[str, int, list[Found]]:
    """Decide claims in a fresh process, with a method switched off; and count its lines."""
    name, numbers = work
    replaced(name, off)
    return name, lines_of(name), [Found(n, verdict_of(_asked[n], _findings)) for n in numbers]


def _in_processes(function: Callable[[Any], Any], work: list[Any]) -> Iterator[Any]:
    """Yield the results, each computed in a process of its own that has decided nothing before."""
    context = get_context("fork")
    gc.freeze()
    with context.Pool(cores(), _quiet, maxtasksperchild=1) as pool:
        for n, found in enumerate(pool.imap_unordered(function, work, chunksize=1), 1):
            if n % 20 == 0:
                print(f"{function.__name__} {n}/{len(work)}", file=sys.stderr, flush=True)
            yield found


def _quiet() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)


# The account


def account(names: tuple[str, ...] = METHODS, every: int = 1) -> dict[str, Any]:
    """Return the account of the methods named, on each ``every``-th claim.

    Returns:
        The number of claims by collection and verdict, and for each method its lines, how many
        claims it returned something for, and which lost their verdict without it.
    """
    _all_lines()
    _findings.update({c.label: Finding(c.expect, "as expected") for c in paper.all_claims()})
    _asked[:] = [*collections()][::every]
    chunks = [[*range(at, len(_asked), CHUNKS)] for at in range(min(CHUNKS, len(_asked)))]
    watched = [found for some in _in_processes(_watched, chunks) for found in some]
    before = {found.number: found for found in watched}
    used = {name: sorted(n for n in before if name in before[n].used) for name in names}
    lost: dict[str, list[Asked]] = {}
    lines: dict[str, int] = {}
    for name, count, found in _in_processes(_without, [*used.items()]):
        lost[name] = [_asked[n] for n, now, _ in found if _is_lost(before[n].verdict, now)]
        lines[name] = count
    counts: dict[str, dict[str, int]] = {}
    for found in before.values():
        of = counts.setdefault(_asked[found.number].collection, {})
        of[found.verdict] = of.get(found.verdict, 0) + 1
    rows = [_row(name, lines[name], len(used[name]), lost[name], every) for name in names]
    return {"workload": "account", "every": every, "collections": counts, "rows": rows}


def _is_lost(before: str, now: str) -> bool:
    """Whether a claim had a verdict, and has none or another now."""
    settled = before not in (UNDECIDED.value, "not read") and before.isupper()
    return settled and now != before and {before, now} != {"PROVED", "ENCLOSED"}


def _row(name: str, lines: int, used: int, lost: list[Asked], every: int) -> dict[str, Any]:
    per_hundred = 100 * every * len(lost) / max(lines, 1)
    by: dict[str, int] = {}
    for asked in lost:
        by[asked.collection] = by.get(asked.collection, 0) + 1
    return {
        "method": name,
        "lines": lines,
        "used": used,
        "lost": len(lost),
        "per hundred lines": round(per_hundred, 1),
        "lost in": by,
        "examples": [asked.claim for asked in lost[:5]],
        "why": reason(name) if per_hundred < FEW else "",
    }


def reason(name: str) -> str:
    """Why a method is kept that decides little; its own reason, or that of its module."""
    return next((why for start, why in REASONS.items() if name.startswith(start)), "")


@cache
def _all_lines() -> int:
    return counted(reached((), ROOTS)).total


def lines_of(name: str) -> int:
    """Return how many lines of code only this method reaches, of the code of verdicts."""
    return _all_lines() - counted(reached((name,), ROOTS)).total


def text_of(found: dict[str, Any]) -> str:
    """Return the account as a table for a terminal, methods that lose least first."""
    lines = [f"{'lost':>5} {'used':>5} {'lines':>6}  method"]
    rows = sorted(found["rows"], key=lambda row: (row["per hundred lines"], -row["lines"]))
    for row in rows:
        where = ", ".join(f"{name} {n}" for name, n in row["lost in"].items())
        lines.append(f"{row['lost']:5} {row['used']:5} {row['lines']:6}  {row['method']}  {where}")
    return "\n".join(lines)


def main() -> None:
    """Print the account, and store it with ``--save``."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--save", action="store_true", help=f"store it in {SAVED.name}")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="of N claims take one")
    parser.add_argument("methods", nargs="*", metavar="METHOD", help="default: all")
    asked = parser.parse_args()
    found = account(tuple(asked.methods) or METHODS, asked.every)
    print(text_of(found))
    if asked.save:
        write_text(str(SAVED), json_text(found))


if __name__ == "__main__":
    main()
