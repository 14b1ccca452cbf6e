"""Deciding identities: the appendix's antiderivative against SymPy, and the ledger's slowest step.

The peer is what a reader would type: ``simplify(diff(G, psi) - g)``, with the symbols declared
positive, without which it does not come to 0.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import sympy

from tresym.bench.run import Contender, Measurement, interleave
from tresym.claims.chain import check_chain
from tresym.claims.translate import to_expression
from tresym.formulas import printed
from tresym.identity import Given, decide, parse
from tresym.verdict import Verdict
from tresym.verification import verify

ROUNDS = 7
OURS = "tresym, exact normal form"


def measure(rounds: int = ROUNDS) -> Measurement:
    """The workload ``identities``: one decision each, interleaved."""
    names = ("S", "a", "b", "psi")
    symbols = sympy.symbols(names, positive=True)
    integral, integrand = _appendix(*symbols)
    left = to_expression(sympy.Derivative(integral, symbols[-1]), open_derivatives=True)
    right = to_expression(integrand)
    given = Given.parse("a > 0, b > 0, b <= 1, psi > 0, 2*psi < pi")
    label, slowest = _slowest_step()
    contenders = [
        Contender(OURS, _timed(lambda: _expect(decide(left, right, given).verdict))),
        Contender("sympy.simplify", _timed(lambda: _zero(integral, integrand, symbols[-1]))),
        Contender(f"tresym, slowest chain of the ledger ({label}), warm", _timed(slowest)),
        Contender("tresym, reading the identity from text", _timed(lambda: parse(str(right)))),
    ]
    says = "the derivative of the appendix's antiderivative is the integrand"
    return Measurement("identities", says, rounds, interleave(contenders, rounds), OURS)


def _appendix(S: Any, a: Any, b: Any, psi: Any) -> tuple[Any, Any]:
    return (
        printed.turn_slope_antiderivative(psi, a, b, S, sympy),
        printed.integrand_slope(psi, a, b, S, sympy),
    )


def _expect(verdict: Verdict) -> None:
    if verdict is not Verdict.PROVED:
        raise ArithmeticError(f"the identity came out {verdict.value}")


def _zero(integral: Any, integrand: Any, psi: Any) -> None:
    if sympy.simplify(sympy.diff(integral, psi) - integrand) != 0:
        raise ArithmeticError("simplify did not come to 0")


def _slowest_step() -> tuple[str, Callable[[], Any]]:
    """The chain of one equation between numbers with the slowest step, to be checked again."""
    rows = [
        row
        for row in verify().rows
        if isinstance(row.claim.says, sympy.Eq)
        and isinstance(row.claim.proof, tuple)
        and not row.claim.says.has(sympy.MatrixBase)
    ]
    claim = max(rows, key=lambda row: max(s.seconds for s in row.finding.steps)).claim
    chain: Any = claim.proof
    return claim.label, lambda: check_chain(claim.says, chain, claim.given)


def _timed(work: Callable[[], Any]) -> Callable[[], float]:
    def sample() -> float:
        start = time.process_time()
        work()
        return time.process_time() - start

    return sample
