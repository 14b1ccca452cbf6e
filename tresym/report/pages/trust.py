"""What must be right for a pass, as tables in Markdown for the page on trust."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from inspect import signature
from typing import Any

from tresym.ledger.axioms import RULES
from tresym.ledger.evidence.admissible import is_formal
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.mutants.report import MUTANTS
from tresym.ledger.verification import Report
from tresym.racket.bounds import charts
from tresym.reals.balls.gradient import Divided
from tresym.reals.balls.tracing import Named
from tresym.reals.language.expression import symbol
from tresym.reals.verdict import Verdict
from tresym.report.pages.trusted_code import CHECK, LEDGER, RECHECKED, Count, trusted

CALLED = {
    Boxes: "bounds on boxes: the margin, and its slopes",
}
"""Evidence that holds functions in place of formulas."""
WHAT = ("PROVED", "ENCLOSED, more")


def trust(
    report: Report,
    guards: Mapping[str, Any] | None,
    hunts: Mapping[str, Any] | None = None,
    mutants: Mapping[str, Any] | None = None,
) -> str:
    """The tables of the page.

    Args:
        guards: what ``python tests/guards.py save`` wrote, None where it was never run.
        mutants: what ``tresym verify --mutants --json`` wrote, likewise.
        hunts: what ``python tests/deep.py save`` wrote, or None.
    """
    proved, enclosed = trusted()
    parts = [
        _code(proved, enclosed),
        _left_out(),
        _libraries(proved, enclosed),
        _quoted(report),
        _called(report),
        _programs(),
        _mutants(mutants) if mutants else (),
        _guards(guards) if guards else (),
        _hunts(hunts["tests"]) if hunts else (),
    ]
    return "\n".join(line for part in parts for line in (*part, ""))


def _table(heads: Sequence[str], rows: Iterable[Sequence[object]], right: int = 99) -> list[str]:
    """A table; columns from ``right`` on hold numbers."""
    rule = ["--:" if k >= right else "---" for k in range(len(heads))]
    return [f"| {' | '.join(map(str, row))} |" for row in (heads, rule, *rows)]


def _code(proved: Count, enclosed: Count) -> list[str]:
    ledger, check = trusted(LEDGER), trusted(CHECK)
    counts = (*ledger, *check, proved, enclosed)
    sums = [Counter[str]() for _ in counts]
    for total, count in zip(sums, counts, strict=True):
        for file, lines in count.lines.items():
            total[_room(file)] += lines
    rooms = sorted(set().union(*sums))
    rows = [(f"`{room}`", *(total[room] for total in sums)) for room in rooms]
    whole = ("all", *(count.total for count in counts))
    heads = [f"{whose}{what}" for whose in ("ledger: ", "check: ", "both: ") for what in WHAT]
    return [
        "## Code",
        "",
        f"For PROVED in the ledger {ledger[0].total} lines must be right, and for ENCLOSED "
        f"{ledger[1].total} more. What decides claims of your own shares most of them, and has "
        f"deciders that the ledger does without: for PROVED {check[0].total} lines. Comments, "
        "docstrings and blank lines are not counted.",
        "",
        *_table(("room", *heads), (*rows, whole), 1),
    ]


def _room(file: str) -> str:
    return file.rpartition(".")[0].replace(".", "/") or file


def _left_out() -> list[str]:
    """What is reached and not counted, one row for each reason."""
    return [
        "## What only finds",
        "",
        "The deciding functions call this too, and it is not counted: it gives no pass by itself.",
        "",
        *_table(("what", "why"), ((_names(names), why) for why, names in RECHECKED.items())),
    ]


def _libraries(proved: Count, enclosed: Count) -> list[str]:
    more = sorted({*enclosed.flint} - {*proved.flint})
    return [
        "## Libraries",
        "",
        f"Of python-flint, for PROVED: {_names(proved.flint)}.",
        "",
        f"For ENCLOSED also: {_names(more)}.",
        "",
        f"Of SymPy, which holds the claims of the ledger and decides none: {_names(proved.sympy)}.",
        "",
        "Python itself, and the processor.",
    ]


def _names(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _quoted(report: Report) -> list[str]:
    """The theorems that are quoted and not proved, for claims and for the judge's own rules."""
    resting = {axiom: len(claims) for axiom, claims in report.axioms.items()}
    whole = {row.claim.label for row in report.rows if row.claim.axioms}
    return [
        "## Quoted theorems",
        "",
        f"{len(whole)} claims rest on theorems that are quoted and not proved here:",
        "",
        *_table(
            ("theorem", "source", "claims"),
            ((axiom.name, axiom.source, number) for axiom, number in resting.items()),
            2,
        ),
        "",
        "All claims rest on the textbook theorems by which the rules are sound:",
        "",
        *_table(("rule", "theorem", "source"), ((a.rule, a.name, a.source) for a in RULES)),
    ]


def _called(report: Report) -> list[str]:
    kinds = Counter(type(row.claim.proof) for row in report.rows)
    rows = [(f"`{kind.__name__}`", what, kinds[kind]) for kind, what in CALLED.items()]
    prose = sum(not is_formal(row.claim) for row in report.rows)
    return [
        "## Functions and sentences",
        "",
        f"Of {len(report.rows)} claims these hold a function of Python where a formula should "
        "stand. That it computes what the claim says is compared at points, or for the reader.",
        "",
        *_table(("evidence", "functions", "claims"), rows, 2),
        "",
        f"{prose} claims are sentences, or formulas with an order: that the evidence is about what "
        "they say is for the reader.",
    ]


def _programs() -> Iterator[str]:
    """The functions with a program of their own in balls, and what each is about."""
    rows = []
    for name, function in vars(charts).items():
        if isinstance(function, Divided):
            rows.append((f"`{name}`", f"`{function.meaning(symbol('x'))}`"))
        elif isinstance(function, Named):
            names = [symbol(x) for x in "xyzw"[: len(signature(function.program).parameters)]]
            if function.meaning is not None:
                rows.append((f"`{name}`", f"`{function.meaning(*names)}`"))
            elif function.image is not None:
                rows.append((f"`{name}`", f"`p = {function.image(symbol('p'), *names)}`"))
    yield "## Programs in balls"
    yield ""
    yield (
        "Margins of bounds are traced: what runs in balls is what is compared with the statement. "
        "These functions in them have programs of their own, which are trusted to contain the "
        "value, continued to where a quotient has none; or every p between π and 3π/2 that solves "
        "the equation. Tests compare each with what it means."
    )
    yield ""
    yield from _table(("function", "what its ball contains"), rows)


def _mutants(mutants: Mapping[str, Any]) -> list[str]:
    """What became of false variants of the claims."""
    counts, few = mutants["counts"], [row for row in mutants["few"] if row["changes"] < MUTANTS]
    total, refuted = sum(counts.values()), counts[Verdict.REFUTED.value]
    judged = sum(row["changes"] > 0 for row in mutants["claims"])
    held = len(mutants["survivors"]) + len(mutants["stopped"])
    lines = [
        "## False variants of the claims",
        "",
        f"Of {judged} claims {total} false variants were judged, and falsehoods planted for the "
        "guards of the judge: a sign, a constant, a region or an order is changed, balls see that "
        "what is said then is false, and the claim's own evidence is asked to show it. "
        f"{refuted} are refuted with a witness, which is {100 * refuted / max(total, 1):.1f} %, "
        f"{counts[Verdict.UNDECIDED.value]} stay undecided, and {held or 'none'} passed. "
        "`tresym verify --mutants` judges them again.",
    ]
    if few:
        lines += ["", f"Claims with fewer than {MUTANTS} variants:", ""]
        lines += [f"- `{row['label']}`, {row['changes']}: {row['why']}." for row in few]
    return lines


def _guards(guards: Mapping[str, Any]) -> Iterator[str]:
    """How many mutants of the checkers the tests refuse, by room, and which they do not."""
    rooms: dict[str, Counter[str]] = {}
    for file, counts in guards["files"].items():
        room = file.rpartition("/")[0].removeprefix("tresym/")
        rooms.setdefault(room, Counter()).update(counts)
    whole = sum(rooms.values(), Counter[str]())
    died, tried = _died(whole), whole.total() - whole["not tried"] - whole["equivalent"]
    yield "## Tests of the tests"
    yield ""
    yield (
        f"The checkers are changed in {whole.total()} places, mostly the way that lets more pass: "
        "a guard is deleted, a test negated, a condition dropped, a bound widened. Of "
        f"{tried} that were tried the quick tests refuse {died}, which is "
        f"{100 * died / max(tried, 1):.1f} %; {whole['equivalent']} more change nothing that could "
        "be seen."
    )
    yield ""
    rows = [
        (f"`{room}`", c.total(), _died(c), c["survived"] + c["not reached"], c["equivalent"])
        for room, c in sorted(rooms.items())
    ]
    yield from _table(("room", "mutants", "refused", "survive", "equivalent"), rows, 1)
    reasons: dict[str, list[str]] = {}
    for mutant in guards["alive"]:
        if mutant["why"]:
            where = f"`{mutant['piece']}`: {mutant['kind']}, `{mutant['was']}`"
            reasons.setdefault(mutant["why"], []).append(where)
    if reasons:
        yield ""
        yield "Equivalent ones, with the reason:"
        yield ""
        yield from (f"- {why}: {'; '.join(places)}." for why, places in reasons.items())


def _hunts(tests: Mapping[str, Any]) -> Iterator[str]:
    """What the long hunts have come to: of how many examples, when, and at which commit."""
    yield "## Long hunts"
    yield ""
    yield (
        "Beside what every change must pass, tests run for hours with seeds of their own "
        "(`python tests/deep.py`). An example is a random input or claim whose truth is known; of "
        "claims it is counted how many were decided within the time of one."
    )
    yield ""
    rows = [
        (
            f"`{test.rpartition('::')[2].removeprefix('test_')}`",
            f"{row['day']}, `{row['commit']}`" if row["commit"] else row["day"],
            f"{row['examples'] or row['chunks']:,}",
            f"{row['decided']:,}" if "decided" in row else "",
            row["failures"],
        )
        for test, row in tests.items()
    ]
    yield from _table(("hunt", "last run", "examples", "decided", "failures"), rows, 2)


def _died(counts: Counter[str]) -> int:
    return counts["killed"] + counts["stopped"]
