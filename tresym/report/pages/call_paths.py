"""Two walks through the rooms, station by station, for the page of the map.

Each station is a function, indented below the one that calls it; a test reads the calls off the
sources. A walk that entered a room again and again would say that the rooms are cut badly.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple


class Station(NamedTuple):
    """A function on the way of a claim, what it does there, and how deep in calls it is."""

    depth: int
    file: str
    """Below ``tresym/``, with dots and without its ending."""
    function: str
    does: str


USER = (
    Station(0, "commands.check", "run", "takes the claim, its conditions and its path as text"),
    Station(1, "commands.check", "one", "asks for one answer"),
    Station(
        2, "reals.decisions.time_limited", "check_within", "gives it to a process, with a limit"
    ),
    Station(3, "reals.decisions.dispatch", "decide_claim", "decides part by part"),
    Station(4, "reals.decisions.claim_parsing", "read", "has the text read, as it is shown again"),
    Station(5, "reals.language.parsing", "parse_claim", "text becomes trees"),
    Station(5, "reals.domain.conditions", "Given", "the conditions, and points that satisfy them"),
    Station(4, "reals.decisions.equalities", "decide_equality", "an equality"),
    Station(5, "reals.decisions.identity", "decide", "the difference of its sides"),
    Station(6, "reals.normal.field", "Field", "a normal form: it is 0, or it is not"),
    Station(4, "reals.decisions.inequalities", "decide_inequality", "an inequality"),
    Station(5, "reals.signs.sign", "sign", "the sign of a difference, by exact methods"),
    Station(
        5, "reals.decisions.inequalities_on_regions", "search", "where these do not reach, boxes"
    ),
    Station(6, "reals.balls.branch_and_bound", "decide_bound", "a bound in balls, box by box"),
    Station(4, "reals.decisions.claim_cross_check", "attack", "before a pass is said, an attack"),
    Station(5, "reals.cross_check", "contradiction", "balls at points that no prover chose"),
    Station(2, "commands.check", "answer_text", "prints verdict, reading, witness and time"),
)
"""A user's claim, from the command line to its verdict."""

LEDGER = (
    Station(0, "commands.verify", "_verify_claims", "asks for a report"),
    Station(1, "ledger.verification", "verify", "judges foundations first"),
    Station(2, "ledger.paper", "all_claims", "the claims, each after what it rests on"),
    Station(3, "proofs", "claims", "the proofs, part by part"),
    Station(2, "ledger.judge", "judge", "finds the checker for the kind of evidence"),
    Station(3, "ledger.conversion", "formula", "what is said, as a formula of the one language"),
    Station(4, "reals.language.sympy", "formula", "it leaves SymPy here"),
    Station(3, "ledger.evidence.chain", "check_chain", "a chain, step by step"),
    Station(
        4, "reals.decisions.identity", "decide_continuous", "a step, by the reasons that it names"
    ),
    Station(5, "reals.normal.field", "Field", "a normal form: it is 0, or it is not"),
    Station(3, "ledger.evidence.sign_prover", "manifest_sign", "a sign that no chain has to show"),
    Station(4, "reals.signs.sign", "sign", "by exact methods"),
    Station(3, "ledger.evidence.box_bounds", "Boxes", "a bound on a region"),
    Station(4, "reals.balls.branch_and_bound", "decide_bound", "box by box, or by the stored tree"),
    Station(3, "ledger.counterexamples", "contradiction", "before a pass is said, an attack"),
    Station(4, "reals.cross_check", "points", "balls at points that no prover chose"),
    Station(1, "report.pages.ledger_rows", "report_json", "the row: statement, verdict, witness"),
    Station(2, "report.typesetting.latex", "says_latex", "the statement as the paper writes it"),
)
"""A claim of the paper, from its file to its row in the ledger."""


def room(file: str) -> str:
    """The room of a file, as the map names it."""
    names = file.split(".")
    inner = names[0] == "reals" and len(names) > 2
    return f"{'/'.join(names[: 2 if inner else 1])}/"


def callers(walk: tuple[Station, ...]) -> Iterator[tuple[Station, Station]]:
    """Every station but the first, each after the one that calls it."""
    above: list[Station] = []
    for station in walk:
        above = above[: station.depth]
        if above:
            yield above[-1], station
        above.append(station)


def entered(walk: tuple[Station, ...]) -> dict[str, int]:
    """How often the walk enters each room from another, in the order of first entry."""
    found = {room(walk[0].file): 1}
    for caller, station in callers(walk):
        here = room(station.file)
        found[here] = found.get(here, 0) + (here != room(caller.file))
    return found


def walks() -> str:
    """Both walks in Markdown."""
    return "\n".join(
        (
            "## The walk of a user's claim",
            "",
            *_shown(USER),
            "",
            "## The walk of a claim of the paper",
            "",
            *_shown(LEDGER),
            "",
        )
    )


def _shown(walk: tuple[Station, ...]) -> Iterator[str]:
    for station in walk:
        path = f"{station.file.replace('.', '/')}.py" if "." in station.file else station.file
        yield f"{'  ' * station.depth}- `{path}`, `{station.function}`: {station.does}"
    often = ", ".join(f"`{name}` {_times(n)}" for name, n in entered(walk).items())
    yield ""
    yield f"It enters {often}."


def _times(n: int) -> str:
    return {1: "once", 2: "twice"}.get(n, f"{n} times")
