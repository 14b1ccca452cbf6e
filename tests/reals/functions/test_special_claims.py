"""Claims about special functions, true or false by mpmath at 40 digits: none is decided wrongly."""

from __future__ import annotations

import random
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from in_mpmath import IN_MPMATH

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.expression import Expr, opened, symbols
from tresym.reals.language.parsing import parse_claim, parse_given
from tresym.reals.numbers.arithmetic import mp_precision
from tresym.reals.verdict import Verdict

FILE = Path(__file__).parents[2] / "data" / "claims" / "special.txt"
LINES = [
    (truth.strip() == "true", claim.strip())
    for truth, claim in (
        line.split("|", 1)
        for line in FILE.read_text(encoding="utf-8").splitlines()
        if line.strip() and not line.startswith("#")
    )
]
BY_DEFAULT = LINES[::9]
LEAST = 0.97
"""The share of all claims that must be decided."""
DIGITS, POINTS, TRIED = 40, 8, 400
HOLDS: dict[str, Any] = {
    "==": lambda x, y, tiny: abs(x - y) <= tiny * (1 + abs(x)),
    "<": lambda x, y, tiny: x < y,
    "<=": lambda x, y, tiny: x <= y + tiny,
    ">": lambda x, y, tiny: x > y,
    ">=": lambda x, y, tiny: x >= y - tiny,
    "!=": lambda x, y, tiny: x != y,
}


def value(m: Any, e: Expr, at: Mapping[str, Any]) -> Any:
    """The value of a tree by mpmath alone, with derivatives as limits of differences."""
    args = e.args
    if e.op == "number":
        return m.mpf(int(args[0].p)) / int(args[0].q)
    if e.op == "symbol":
        return at[args[0]]
    if e.op == "pi":
        return +m.pi
    if e.op == "derivative":
        (name,), body = opened(e)
        return m.diff(lambda t: value(m, body, {**at, name: t}), value(m, args[1], at))
    values = [value(m, arg, at) for arg in args]
    if e.op == "+":
        return m.fsum(values)
    if e.op == "*":
        return m.fprod(values)
    if e.op == "^":
        return values[0] ** values[1]
    if e.op in IN_MPMATH:
        return IN_MPMATH[e.op](m, *values)
    return getattr(m, "fabs" if e.op == "abs" else "ln" if e.op == "log" else e.op)(*values)


def is_true_at_points(claim: str) -> bool:
    """Whether mpmath finds the claim true at random points that satisfy its conditions."""
    text, _, conditions = claim.partition(" given ")
    (relation,) = parse_claim(text)
    given = list(parse_given(conditions)) if conditions else []
    left, sign, right = relation
    names = sorted(symbols(left) | symbols(right))
    chance, seen = random.Random(claim), 0
    with mp_precision(DIGITS) as m:
        tiny = m.mpf(10) ** -18 if "diff" in claim else m.mpf(10) ** (6 - DIGITS)
        for _ in range(TRIED if names else 1):
            scale = chance.choice((0.3, 1, 3, 9))
            at = {name: m.mpf(chance.uniform(-1, 1)) * scale for name in names}
            try:
                if not all(HOLDS[r](value(m, x, at), value(m, y, at), 0) for x, r, y in given):
                    continue
                x, y = value(m, left, at), value(m, right, at)
                if any(at[name] * m.e < -1 for name in names if "lambertw" in claim):
                    continue
                if abs(m.im(x)) + abs(m.im(y)) > 0 or not m.isfinite(m.re(x) + m.re(y)):
                    continue
                if not HOLDS[sign](m.re(x), m.re(y), tiny):
                    return False
            except (ValueError, ZeroDivisionError, OverflowError, TypeError, m.NoConvergence):
                continue
            seen += 1
            if seen == POINTS and sign == "==":
                break
    assert seen, claim
    return True


def is_true_along_path(statement: Statement) -> bool:
    """Whether the numbers along the path behave as the claim says."""
    (comparison,), path = statement.comparisons, statement.path
    assert path is not None
    found = []
    with mp_precision(DIGITS) as m:
        for k in (3, 5, 7) if path.point is not None else (2, 4, 6):
            size = m.mpf(2) ** -k / 3 if path.point is not None else m.mpf(3) ** (k / 2) + k
            base = value(m, path.point, {}) if path.point is not None else 0
            at = {path.name: base + path.sides[0] * size}
            x, y = (m.re(value(m, e, at)) for e in (comparison.left, comparison.right))
            match comparison.relation:
                case "O":
                    found.append(abs(x / y))
                case "o":
                    found.append(abs(x / y) ** m.mpf(0.5))
                case "~":
                    found.append(abs(x / y - 1))
                case _:
                    found.append(abs(x - y))
    _, middle, last = found
    if comparison.relation == "O":
        return bool(last < 1.7 * middle + 1e-20)
    return bool(last < 0.7 * middle or last < 1e-12)


BY_DLMF = ("integral(", "li(x) ==", "Ci(x) ->", "besselj(0, x) == sqrt", "besselk(0, x) ~")
"""Claims that no few numbers confirm: integrals, and limits that are approached slowly."""


def is_true(claim: str) -> bool | None:
    """The truth by mpmath; None where the list takes it from DLMF."""
    if claim.startswith(BY_DLMF):
        return None
    if " as " in claim:
        return is_true_along_path(read(claim))
    return is_true_at_points(claim)


def decided(truth: bool, claim: str) -> bool:
    """Whether a claim is decided; it must not be decided wrongly."""
    found = tresym.check(claim).verdict
    assert found is not (Verdict.REFUTED if truth else Verdict.PROVED), claim
    assert truth or found is not Verdict.ENCLOSED, claim
    return found is not Verdict.UNDECIDED


@pytest.mark.parametrize(("truth", "claim"), BY_DEFAULT)
def test_claims_are_decided_as_mpmath_finds_them(truth: bool, claim: str) -> None:
    assert is_true(claim) in (truth, None), claim
    assert decided(truth, claim), claim


@pytest.mark.night
def test_nearly_all_claims_are_decided_and_none_wrongly() -> None:
    wrong = [claim for truth, claim in LINES if is_true(claim) not in (truth, None)]
    assert not wrong
    count = sum(decided(truth, claim) for truth, claim in LINES)
    assert count >= LEAST * len(LINES)


def test_a_third_of_the_claims_is_false() -> None:
    assert len(LINES) >= 200
    assert 3 * sum(not truth for truth, _ in LINES) >= len(LINES) - 3
