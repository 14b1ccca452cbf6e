"""Write the trust page: what must be correct for a verdict to be correct, counted and measured.

``trust`` answers the question in a paragraph and a few tables. ``trust_details`` is its appendix:
the functions that are left out of the count, the libraries, and the results of testing the tests.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from inspect import signature
from typing import Any

from tresym.ledger.axioms import RULES
from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.paper import racket
from tresym.ledger.sentences import sentence_of
from tresym.ledger.verification import MUTANTS, Report
from tresym.reals.balls.gradient import Divided
from tresym.reals.balls.tracing import Named
from tresym.reals.language.expression import symbol
from tresym.reals.verdict import Verdict
from tresym.report.pages import coq_page
from tresym.report.pages.trusted_code import trusted


def trust(
    report: Report,
    guards: Mapping[str, Any] | None,
    hunts: Mapping[str, Any] | None = None,
    mutants: Mapping[str, Any] | None = None,
) -> str:
    """Write the tables of the trust page.

    Args:
        report: verdicts on the whole ledger.
        guards: what ``python tests/guards.py save`` wrote, or None if there is no such file.
        hunts: what ``python tests/deep.py save`` wrote, or None.
        mutants: what ``tresym verify --mutants --json`` wrote, or None.
    """
    parts = (
        _answer(report),
        _safeguards(guards, hunts, mutants),
        _quoted(report),
        _sentences(report),
    )
    return "\n".join(line for part in parts for line in (*part, ""))


def trust_details(
    guards: Mapping[str, Any] | None,
    hunts: Mapping[str, Any] | None = None,
    mutants: Mapping[str, Any] | None = None,
) -> str:
    """Write the appendix of the trust page; the arguments are those of :func:`trust`."""
    parts = [
        _programs(),
        _few(mutants) if mutants else (),
        _guards(guards) if guards else (),
        _hunts(hunts["tests"]) if hunts else (),
    ]
    return "\n".join(line for part in parts for line in (*part, ""))


def _answer(report: Report) -> list[str]:
    """The answer in one paragraph."""
    labels = tuple(row.claim.label for row in report.rows)
    known = coq_page.found(labels)
    marks = [coq_page.mark(row, known) for row in report.rows]
    whole = [mark for mark in marks if mark is not None and mark["status"] == "proved"]
    checked, quoting = len(whole), sum(bool(mark["quoted"]) for mark in whole)
    statements = trusted(coq_page.STATEMENTS)
    return [
        f"**For {checked} of {len(labels)} claims** you have to trust Coq, its libraries, and the "
        f"{statements:,} lines of Python that turn a claim into a Coq statement; such a statement "
        "says nothing about points at which one of its parts is undefined"
        + (
            f", and {quoting} of these claims also quote theorems that are not proved"
            * bool(quoting)
        )
        + ". **For the other "
        f"{len(labels) - checked}** you have to trust Python, the library python-flint for "
        "polynomials and ball arithmetic, and tresym. **For all of them** you have to agree that "
        "the formula shown beside a sentence of the paper says what the sentence says.",
        "",
        f"Code that issues verdicts can reach {trusted():,} lines of tresym. Comments, docstrings "
        "and blank lines do not count. Much of that code only searches, and code that is short "
        "checks what it finds; it is counted all the same.",
    ]


def _table(heads: Sequence[str], rows: Iterable[Sequence[object]], right: int = 99) -> list[str]:
    """A Markdown table; columns from number ``right`` on are aligned to the right."""
    rule = ["--:" if k >= right else "---" for k in range(len(heads))]
    return [f"| {' | '.join(map(str, row))} |" for row in (heads, rule, *rows)]


def _names(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _quoted(report: Report) -> list[str]:
    """The theorems that are quoted without proof, for claims and for the rules of proof."""
    resting = {axiom: len(claims) for axiom, claims in report.axioms.items()}
    whole = {row.claim.label for row in report.rows if row.claim.axioms}
    return [
        "## Quoted theorems",
        "",
        f"{len(whole) or 'No'} claims depend on theorems that are quoted and not proved here:",
        "",
        *_table(
            ("theorem", "source", "claims"),
            ((axiom.name, axiom.source, number) for axiom, number in resting.items()),
            2,
        ),
        "",
        "The rules of proof are sound by these textbook theorems:",
        "",
        *_table(("rule", "theorem", "source"), ((a.rule, a.name, a.source) for a in RULES)),
    ]


def _sentences(report: Report) -> list[str]:
    prose = [row.claim.label for row in report.rows if not is_formal(row.claim)]
    worded = [row for row in report.rows if sentence_of(row.claim) is not None]
    functions = [row.claim.label for row in report.rows if isinstance(row.claim.proof, Boxes)]
    return [
        "## What is left to the reader",
        "",
        f"For {len(prose)} claims, sentences or asymptotic formulas, no single formula expresses "
        f"the whole statement: {_names(prose) or 'none'}. Compare the evidence with the sentence. "
        "They do not count as proved in Coq.",
        "",
        f"{len(worded)} claims have a sentence beside their formula. Somebody compared the two; a "
        "claim becomes UNDECIDED when either is changed. The statements of all other "
        "claims are printed from their formulas.",
        "",
        "Claims whose evidence contains a Python function in place of a formula: "
        f"{_names(functions) or 'none'}. Tests compare the two at sample points.",
    ]


def _programs() -> Iterator[str]:
    """The functions that are evaluated in balls by separate programs, with their meaning."""
    rows = []
    for name, function in racket().programs().items():
        if isinstance(function, Divided):
            rows.append((f"`{name}`", f"`{function.meaning(symbol('x'))}`"))
        elif isinstance(function, Named):
            names = [symbol(x) for x in "xyzw"[: len(signature(function.program).parameters)]]
            if function.meaning is not None:
                rows.append((f"`{name}`", f"`{function.meaning(*names)}`"))
            elif function.image is not None:
                rows.append((f"`{name}`", f"`p = {function.image(symbol('p'), *names)}`"))
    yield "## Functions evaluated by programs of their own"
    yield ""
    yield (
        "A bound is evaluated from the same expression that is compared with the statement. The "
        "functions below, which occur in such expressions, are evaluated by separate programs. The "
        "ball that a program returns must contain the true value (the limit where a quotient is "
        "undefined), or every solution p of the equation between π and 3π/2. Tests compare each "
        "program with its meaning."
    )
    yield ""
    yield from _table(("function", "what its ball contains"), rows)


def _safeguards(
    guards: Mapping[str, Any] | None,
    hunts: Mapping[str, Any] | None,
    mutants: Mapping[str, Any] | None,
) -> list[str]:
    """The safeguards against mistakes in that code, with what was measured for each."""
    rows = [
        (
            "Searches are checked by plain code",
            "A factorisation is multiplied out, a counterexample evaluated, a stored bisection "
            "replayed.",
        ),
        (
            "Independent numerical check",
            "Before a verdict PROVED or ENCLOSED, code that shares nothing with the provers tries "
            "to falsify the statement with ball arithmetic at points it chooses itself.",
        ),
    ]
    if guards:
        whole = _all_files(guards)
        died, tried = _died(whole), _tried(whole)
        rows.append(
            (
                "Tests of the tests",
                f"The checking code was changed in {tried:,} places, one at a time, mostly so that "
                f"it accepts more. The quick tests notice {died:,} of the changes "
                f"({100 * died / max(tried, 1):.1f} %).",
            )
        )
    if mutants:
        counts = mutants["counts"]
        total, refuted = sum(counts.values()), counts[Verdict.REFUTED.value]
        held = len(mutants["survivors"]) + len(mutants["stopped"])
        changed = sum(row["changes"] > 0 for row in mutants["claims"])
        rows.append(
            (
                "False variants of the claims",
                f"{total:,} false variants of {changed:,} claims, made by a change of their line "
                "at one place, a sign, a number, an exponent, a function, a variable, a relation "
                "or a condition: "
                f"{refuted:,} are refuted with a counterexample "
                f"({100 * refuted / max(total, 1):.1f} %), {held or 'none'} passed. "
                "`tresym verify --mutants` repeats this.",
            )
        )
    if hunts:
        tests = hunts["tests"].values()
        examples = sum(row["examples"] or row["chunks"] for row in tests)
        failures = sum(row["failures"] for row in tests)
        rows.append(
            (
                "Randomised tests",
                f"{examples:,} random inputs and claims whose truth is known; "
                f"{failures or 'no'} failures in the last run.",
            )
        )
    return [
        "## Safeguards against mistakes in that code",
        "",
        *_table(("safeguard", "what was measured"), rows),
    ]


def _few(mutants: Mapping[str, Any]) -> list[str]:
    """Claims for which only few false variants can be made."""
    few = [row for row in mutants["few"] if row["changes"] < MUTANTS]
    if not few:
        return []
    lines = [f"- `{row['label']}`, {row['changes']}: {row['why']}." for row in few]
    return [f"## Claims with fewer than {MUTANTS} false variants", "", *lines]


def _all_files(guards: Mapping[str, Any]) -> Counter[str]:
    return sum((Counter[str](counts) for counts in guards["files"].values()), Counter[str]())


def _tried(counts: Counter[str]) -> int:
    return counts.total() - counts["not tried"] - counts["equivalent"]


def _guards(guards: Mapping[str, Any]) -> Iterator[str]:
    """How many changes of the checking code the tests notice, by package; the equivalent ones."""
    packages: dict[str, Counter[str]] = {}
    for file, counts in guards["files"].items():
        package = file.rpartition("/")[0].removeprefix("tresym/")
        packages.setdefault(package, Counter()).update(counts)
    yield "## Tests of the tests"
    yield ""
    yield (
        "Each change deletes a check, negates a test, drops a condition or widens a bound. "
        "A change is *equivalent* if it has no observable effect."
    )
    yield ""
    rows = [
        (f"`{name}`", _tried(c), _died(c), _tried(c) - _died(c), c["equivalent"], c["not tried"])
        for name, c in sorted(packages.items())
    ]
    heads = ("package", "tried", "noticed", "not noticed", "equivalent", "not tried")
    yield from _table(heads, rows, 1)
    reasons: dict[str, list[str]] = {}
    for mutant in guards["alive"]:
        if mutant["why"]:
            where = f"`{mutant['piece']}`: {mutant['kind']}, `{mutant['was']}`"
            reasons.setdefault(mutant["why"], []).append(where)
    if reasons:
        yield ""
        yield "Equivalent changes, with the reason:"
        yield ""
        yield from (f"- {why}: {'; '.join(places)}." for why, places in reasons.items())


def _hunts(tests: Mapping[str, Any]) -> Iterator[str]:
    """The results of the long randomised tests: how many examples, when, and at which commit."""
    yield "## Randomised tests"
    yield ""
    yield (
        "Besides the tests that every change must pass, there are tests that run for hours with "
        "new seeds (`python tests/deep.py`). An example is a random input, or a claim that is "
        "known to be true or false; for claims the table says how many were decided within the "
        "time limit."
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
    yield from _table(("test", "last run", "examples", "decided", "failures"), rows, 2)


def _died(counts: Counter[str]) -> int:
    return counts["killed"] + counts["stopped"]
