"""Inequalities: a point that refutes, a proven sign, Taylor's theorem, and then boxes.

A claim ``left >= right`` speaks of every real point of ``given`` where both sides are defined, like
an identity, and nothing is proved where no such point is found.
"""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from tresym.checking.answer import Answer, refuted
from tresym.checking.boxes import search
from tresym.checking.domain import equal_at, with_domain
from tresym.checking.taylor import sign_by_taylor
from tresym.exact import fraction_text
from tresym.identity.bounds import sign
from tresym.identity.decide import sampled_values
from tresym.identity.expression import Expr, number, substitute, symbols
from tresym.identity.given import Given
from tresym.verdict import Verdict

LOOKS = ((128, 40), (700, 10))
_STRICT = {">": ("+",), ">=": ("+", ">=0", "0"), "!=": ("+", "-")}


def decide_inequality(left: Expr, relation: str, right: Expr, given: Given) -> Answer:
    """PROVED, ENCLOSED, REFUTED or UNDECIDED for ``left relation right``."""
    if relation in ("<", "<="):
        found = decide_inequality(right, relation.replace("<", ">"), left, given)
        values = found.values and (found.values[1], found.values[0])
        return replace(found, values=values)
    names = sorted(symbols(left) | symbols(right))
    defined, refutation = _sampled(left, relation, right, given, names)
    if refutation is not None:
        return refutation
    if defined is None:
        return Answer(
            Verdict.UNDECIDED,
            "no exact point was found inside the conditions where both sides are defined, "
            "and nothing is proved vacuously; a condition that bounds the variables may help",
        )
    if not names:
        return _constants(left, relation, right)
    difference = left - right
    region = with_domain(given, left, right)
    found_sign = sign(difference, region)
    if found_sign in _STRICT[relation]:
        return Answer(
            Verdict.PROVED,
            f"the difference {_words(found_sign)} by the signs of its parts; "
            f"both sides are defined at {_shown(defined)}",
        )
    proof = sign_by_taylor(difference, relation, region)
    if proof is not None:
        why = f"Taylor's theorem: {proof}; both sides are defined at {_shown(defined)}"
        return Answer(Verdict.PROVED, why)
    if relation == "!=":
        return _apart(left, right, region, defined)
    return search(left, right, relation == ">", region, given)


def _sampled(
    left: Expr, relation: str, right: Expr, given: Given, names: list[str]
) -> tuple[dict[str, fmpq] | None, Answer | None]:
    """A point where both sides are defined, and a refutation where a point gives one."""
    defined = None
    for bits, count in LOOKS:
        for point, (x, y) in sampled_values(left, right, given, names, count, bits):
            defined = point
            if relation != "!=" and x < y:
                return defined, refuted(f"it fails at {_shown(point)}", point, x, y)
            if relation != ">=" and x.overlaps(y) and equal_at(left, right, point):
                return defined, refuted(f"both sides are equal at {_shown(point)}", point, x, y)
    return defined, None


def _constants(left: Expr, relation: str, right: Expr) -> Answer:
    """Both sides are constants, and no ball refuted the claim."""
    if equal_at(left, right, {}):
        if relation == ">=":
            return Answer(Verdict.PROVED, "the two constants are equal")
        return refuted("the two constants are equal", {})
    found = sign(left - right, Given())
    if found in _STRICT[relation]:
        return Answer(Verdict.ENCLOSED, "the balls of the two constants are apart")
    return Answer(Verdict.UNDECIDED, "the balls of the two constants overlap at 1024 bits")


def _apart(left: Expr, right: Expr, region: Given, defined: dict[str, fmpq]) -> Answer:
    """``left != right``, by one of the strict inequalities."""
    at = {name: number(value) for name, value in defined.items()}
    above = sign(substitute(left - right, at), Given()) == "+"
    pair = (left, right) if above else (right, left)
    found = search(*pair, True, region, region)
    if found.verdict is not Verdict.REFUTED:
        return found
    point = {name: fmpq(*map(int, text.split("/"))) for name, text in (found.witness or {}).items()}
    if equal_at(left, right, point):
        return refuted(f"both sides are equal at {_shown(point)}", point)
    return Answer(
        Verdict.UNDECIDED,
        "the difference changes its sign, so it may vanish; no exact zero of it was found",
    )


def _words(found: str) -> str:
    words = {"+": "is positive", "-": "is negative", "0": "has normal form 0"}
    return words.get(found, "is nowhere negative")


def _shown(point: dict[str, fmpq]) -> str:
    shown = ", ".join(f"{name} = {fraction_text(value)}" for name, value in point.items())
    return shown or "the constants themselves"
