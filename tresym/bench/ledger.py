"""The whole ledger: a new process that judges every claim, and the same again in a warm one."""

from __future__ import annotations

from tresym.bench.run import Contender, Judged, Keep, Measurement, Pace, forget, interleave
from tresym.bench.startup import launch
from tresym.ledger.verification import Report, verify

PACE = Pace(rounds=3, limit=120, patience=20)


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``ledger``."""
    cold, sympy = launch(["-m", "tresym", "verify", "--json"]), launch(["-c", "import sympy"])
    contenders = [
        Contender("the ledger", "tresym verify, a new process", cold, ours=True, sample=cold),
        Contender("the ledger", "again in the same process", verify, _judge, ours=True),
        Contender("the ledger", "python -c 'import sympy'", sympy, sample=sympy),
    ]
    timings, complete = interleave(contenders, pace, keep)
    says = "a verdict on every claim"
    clock = "wall clock for a process, processor time within one"
    reference = "again in the same process"
    claims = {row.claim.label: round(row.finding.seconds, 6) for row in verify().rows}
    tables = {"claims": claims}
    return Measurement("ledger", says, timings, reference, clock, tables=tables, complete=complete)


def _judge(report: Report) -> Judged:
    counts = ", ".join(f"{n} {verdict}" for verdict, n in report.counts.items())
    return Judged(outcome="right" if report.as_expected else "wrong", why=counts)
