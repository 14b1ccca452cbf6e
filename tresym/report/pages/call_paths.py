"""Two call paths through the packages, for the page on architecture.

Each call is shown indented below its caller; a test compares the calls with the sources. A path
that entered a package again and again would show that the packages are cut badly.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple


class Call(NamedTuple):
    """A function on a call path, what it does there, and its depth in the calls."""

    depth: int
    file: str
    """The module below ``tresym``, with dots."""
    function: str
    does: str


USER = (
    Call(0, "commands.check", "run", "takes the claim, its conditions and its path as text"),
    Call(1, "commands.check", "one", "asks for one answer"),
    Call(
        2, "reals.decisions.time_limited", "check_within", "hands it to a process with a time limit"
    ),
    Call(3, "reals.decisions.dispatch", "decide_claim", "decides each part of the claim"),
    Call(4, "reals.decisions.claim_parsing", "read", "parses the text"),
    Call(5, "reals.language.parsing", "parse_claim", "turns text into expression trees"),
    Call(5, "reals.domain.conditions", "Given", "the conditions, and points that satisfy them"),
    Call(4, "reals.decisions.equalities", "decide_equality", "decides an equality"),
    Call(5, "reals.decisions.identity", "decide", "decides whether the sides differ"),
    Call(6, "reals.normal.field", "Field", "computes an exact normal form"),
    Call(4, "reals.decisions.inequalities", "decide_inequality", "decides an inequality"),
    Call(5, "reals.signs.sign", "sign", "proves the sign of a difference by exact methods"),
    Call(5, "reals.decisions.inequalities_on_regions", "search", "subdivides the region"),
    Call(6, "reals.balls.branch_and_bound", "decide_bound", "bounds the difference on each box"),
    Call(4, "reals.decisions.claim_cross_check", "attack", "tries to falsify a proved claim"),
    Call(5, "reals.cross_check", "contradiction", "evaluates it in balls at its own points"),
    Call(2, "commands.check", "answer_text", "prints verdict, reading, witness and time"),
)
"""A user's claim, from the command line to its verdict."""

LEDGER = (
    Call(0, "commands.verify", "_verify_claims", "asks for the report"),
    Call(1, "ledger.verification", "verify", "decides each claim after those it depends on"),
    Call(2, "ledger.paper", "all_claims", "returns the claims in order of dependence"),
    Call(3, "proofs", "claims", "collects the claims of all proof files"),
    Call(2, "ledger.judge", "judge", "selects the checker for the kind of evidence"),
    Call(3, "ledger.conversion", "formula", "converts the statement to tresym's expressions"),
    Call(4, "reals.language.sympy", "formula", "converts from SymPy"),
    Call(3, "ledger.evidence.chain", "check_chain", "checks a chain of equalities step by step"),
    Call(4, "reals.decisions.identity", "decide_continuous", "decides a step by its reasons"),
    Call(5, "reals.normal.field", "Field", "computes an exact normal form"),
    Call(3, "ledger.judged_roots", "judge_unique_root", "proves that there is exactly one root"),
    Call(4, "ledger.evidence.sign_prover", "manifest_sign", "proves the sign of a slope"),
    Call(5, "reals.signs.sign", "sign", "applies the exact methods for signs"),
    Call(3, "ledger.evidence.box_bounds", "Boxes", "proves a bound on a region"),
    Call(4, "reals.balls.branch_and_bound", "decide_bound", "bounds it on each box"),
    Call(3, "ledger.counterexamples", "contradiction", "tries to falsify a proved claim"),
    Call(4, "reals.cross_check", "points", "chooses points and evaluates in balls"),
    Call(1, "report.pages.ledger_rows", "report_json", "writes statement, verdict and witness"),
    Call(2, "report.typesetting.latex", "says_latex", "writes the statement in LaTeX"),
)
"""A claim of the paper, from its file to its row in the ledger."""


def package(file: str) -> str:
    """Return the package of a module, as the list of packages names it."""
    names = file.split(".")
    inner = names[0] == "reals" and len(names) > 2
    return f"{'/'.join(names[: 2 if inner else 1])}/"


def callers(path: tuple[Call, ...]) -> Iterator[tuple[Call, Call]]:
    """Yield every call but the first, each with its caller."""
    above: list[Call] = []
    for call in path:
        above = above[: call.depth]
        if above:
            yield above[-1], call
        above.append(call)


def entered(path: tuple[Call, ...]) -> dict[str, int]:
    """Return how often the path enters each package from another, in the order of first entry."""
    found = {package(path[0].file): 1}
    for caller, call in callers(path):
        here = package(call.file)
        found[here] = found.get(here, 0) + (here != package(caller.file))
    return found


def call_paths() -> str:
    """Write both paths in Markdown."""
    return "\n".join(
        (
            "## Calls for a user's claim",
            "",
            *_shown(USER),
            "",
            "## Calls for a claim of the paper",
            "",
            *_shown(LEDGER),
            "",
        )
    )


def _shown(path: tuple[Call, ...]) -> Iterator[str]:
    for call in path:
        file = f"{call.file.replace('.', '/')}.py" if "." in call.file else call.file
        yield f"{'  ' * call.depth}- `{file}`, `{call.function}`: {call.does}"
    often = ", ".join(f"`{name}` {_times(n)}" for name, n in entered(path).items())
    yield ""
    yield f"The path enters {often}."


def _times(n: int) -> str:
    return {1: "once", 2: "twice"}.get(n, f"{n} times")
