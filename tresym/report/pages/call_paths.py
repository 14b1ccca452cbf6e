"""Two call paths through the packages, for the page on architecture.

Each call is shown indented below its caller; a test compares the calls with the sources. A path
that entered a package again and again would show that the packages are cut badly.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple


class Call(NamedTuple):
    """A function on the path of a claim, what it does there, and how deep in calls it is."""

    depth: int
    file: str
    """Below ``tresym/``, with dots and without its ending."""
    function: str
    does: str


USER = (
    Call(0, "commands.check", "run", "takes the claim, its conditions and its path as text"),
    Call(1, "commands.check", "one", "asks for one answer"),
    Call(
        2, "reals.decisions.time_limited", "check_within", "hands it to a process with a time limit"
    ),
    Call(3, "reals.decisions.dispatch", "decide_claim", "decides part by part"),
    Call(4, "reals.decisions.claim_parsing", "read", "parses the text"),
    Call(5, "reals.language.parsing", "parse_claim", "text to trees"),
    Call(5, "reals.domain.conditions", "Given", "the conditions, and points that satisfy them"),
    Call(4, "reals.decisions.equalities", "decide_equality", "an equality"),
    Call(5, "reals.decisions.identity", "decide", "decides whether the sides differ"),
    Call(6, "reals.normal.field", "Field", "exact normal form"),
    Call(4, "reals.decisions.inequalities", "decide_inequality", "an inequality"),
    Call(5, "reals.signs.sign", "sign", "the sign of a difference, by exact methods"),
    Call(5, "reals.decisions.inequalities_on_regions", "search", "searches the region by boxes"),
    Call(6, "reals.balls.branch_and_bound", "decide_bound", "bounds it in balls, box by box"),
    Call(4, "reals.decisions.claim_cross_check", "attack", "tries to falsify it before a pass"),
    Call(5, "reals.cross_check", "contradiction", "ball arithmetic at points of its own"),
    Call(2, "commands.check", "answer_text", "prints verdict, reading, witness and time"),
)
"""A user's claim, from the command line to its verdict."""

LEDGER = (
    Call(0, "commands.verify", "_verify_claims", "asks for the report"),
    Call(1, "ledger.verification", "verify", "judges foundations first"),
    Call(2, "ledger.paper", "all_claims", "the claims, each after what it rests on"),
    Call(3, "proofs", "claims", "the proofs, part by part"),
    Call(2, "ledger.judge", "judge", "finds the checker for the kind of evidence"),
    Call(3, "ledger.conversion", "formula", "what is said, as a formula of the one language"),
    Call(4, "reals.language.sympy", "formula", "converts from SymPy"),
    Call(3, "ledger.evidence.chain", "check_chain", "a chain, step by step"),
    Call(
        4, "reals.decisions.identity", "decide_continuous", "a step, by the reasons that it names"
    ),
    Call(5, "reals.normal.field", "Field", "exact normal form"),
    Call(3, "ledger.evidence.sign_prover", "manifest_sign", "a sign shown without a chain"),
    Call(4, "reals.signs.sign", "sign", "by exact methods"),
    Call(3, "ledger.evidence.box_bounds", "Boxes", "a bound on a region"),
    Call(4, "reals.balls.branch_and_bound", "decide_bound", "box by box, or by the stored tree"),
    Call(3, "ledger.counterexamples", "contradiction", "tries to falsify it before a pass"),
    Call(4, "reals.cross_check", "points", "ball arithmetic at points of its own"),
    Call(1, "report.pages.ledger_rows", "report_json", "the row: statement, verdict, witness"),
    Call(2, "report.typesetting.latex", "says_latex", "the statement as the paper writes it"),
)
"""A claim of the paper, from its file to its row in the ledger."""


def package(file: str) -> str:
    """The package of a module, as the list of packages names it."""
    names = file.split(".")
    inner = names[0] == "reals" and len(names) > 2
    return f"{'/'.join(names[: 2 if inner else 1])}/"


def callers(path: tuple[Call, ...]) -> Iterator[tuple[Call, Call]]:
    """Every call but the first, each with its caller."""
    above: list[Call] = []
    for call in path:
        above = above[: call.depth]
        if above:
            yield above[-1], call
        above.append(call)


def entered(path: tuple[Call, ...]) -> dict[str, int]:
    """How often the path enters each package from another, in the order of first entry."""
    found = {package(path[0].file): 1}
    for caller, call in callers(path):
        here = package(call.file)
        found[here] = found.get(here, 0) + (here != package(caller.file))
    return found


def call_paths() -> str:
    """Both paths in Markdown."""
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
