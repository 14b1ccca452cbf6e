"""Orders of growth of linear recurrences from the largest root of the characteristic polynomial.

Example: the sum of the three values before has roots 1.839… and a pair of absolute value 0.737….

If ρ > 0 is a simple root, larger than the absolute value of every other one, a(n) ~ c ρⁿ with a
number c, which is found by dividing the characteristic polynomial p by x − ρ: with the quotient
Σ bⱼ xʲ, c p′(ρ) = Σ bⱼ a(m + j), as the quotient annihilates what belongs to the other roots. Here
roots of any degree are enclosed by balls, so that claims about powers of numbers are decided where
these differ from ρ.
"""

from __future__ import annotations

from itertools import islice

from flint import acb, arb, fmpq, fmpz_poly

from tresym.asymptotics.linear_recurrences import Solved
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, number, power, symbol
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

LEMMA = "the largest root of the characteristic polynomial"
DIGITS = 10**6


def decide_by_largest_root(
    claim: Comparison, statement: Statement, sequence: Solved, decided: Decide
) -> Answer | None:
    """Decide an order of a(n), or return None where no root is the largest.

    Args:
        claim: the comparison.
        statement: its path n -> oo.
        sequence: the recurrence with its values.
        decided: decides explicit claims.
    """
    node = Expr("unknown", (sequence.name, symbol(sequence.n)))
    if claim.left != node or not elementary(claim.right):
        return None
    if claim.relation not in ("O", "o", "Theta", "omega", "~"):
        return None
    found = largest_root(sequence)
    if found is None:
        return None
    low, high = (power(number(x), symbol(sequence.n)) for x in found)
    whole = tuple(dict.fromkeys((*statement.integers, sequence.n)))
    plain = Statement(
        statement.comparisons, statement.given, statement.path, statement.text, integers=whole
    )

    def holds(left: Expr, relation: str) -> bool:
        return bool(decided(Comparison(left, relation, claim.right), plain))

    below, above = holds(high, "o"), holds(low, "omega")
    said = f"{node} ~ c*r**{sequence.n} with c != 0 and {found[0]} < r < {found[1]}"
    verdict = Verdict.UNDECIDED
    if (claim.relation in ("O", "o") and below) or (claim.relation == "omega" and above):
        verdict = Verdict.ENCLOSED
    elif below or above:
        verdict = Verdict.REFUTED
    order = "of smaller order than" if below else "of larger order than" if above else "compared to"
    return Answer(verdict, f"{said}, {order} {claim.right}", lemma=LEMMA)


def largest_root(sequence: Solved) -> tuple[fmpq, fmpq] | None:
    """Return numbers below and above the largest root, where a(n) ~ c ρⁿ with c ≠ 0."""
    raised = [*(-c for c in sequence.coefficients), fmpq(1)]
    if sequence.constant:
        raised = [a - b for a, b in zip([fmpq(0), *raised], [*raised, fmpq(0)], strict=True)]
    scale = 1
    for c in raised:
        scale *= int(c.q)
    p = fmpz_poly([int((c * scale).p) for c in raised])
    with ball_precision(256):
        roots = [(acb(place), int(k)) for place, k in p.complex_roots()]
        largest = max(roots, key=lambda root: float(abs(root[0])))
        rho = largest[0].real
        others = [abs(place) for place, _ in roots if place is not largest[0]]
        if largest[1] != 1 or not largest[0].imag.contains(0) or not rho > 0:
            return None
        if not all(size < rho for size in others):  # so that it is its own conjugate
            return None
        quotient: list[arb] = []
        rest = arb(0)
        for c in reversed(raised):  # Horner's scheme
            rest = rest * rho + c
            quotient.insert(0, rest)
        values = islice(sequence.terms(), len(raised) - 1)
        total = sum((b * arb(v) for b, v in zip(quotient[1:], values, strict=False)), arb(0))
        if total.contains(0):
            return None
        low = fmpq(int((rho.lower() * DIGITS).floor().lower().unique_fmpz() or 0) - 1, DIGITS)
        high = fmpq(int((rho.upper() * DIGITS).ceil().upper().unique_fmpz() or 0) + 1, DIGITS)
        return (low, high) if arb(low) < rho < arb(high) and low > 0 else None
