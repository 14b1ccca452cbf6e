"""Signs that follow from premises and from products of sines and cosines.

A sum that contains the terms of a premise is written as the premise plus the remaining terms. A
polynomial in sines and cosines is rewritten without the squares of one of them and factored until
the sign of each factor is evident.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from tresym.coq.equations import irreducible, nodes, quotient, unfolded
from tresym.coq.linear_dependence import as_expression, expanded, without_squares
from tresym.coq.reductions import known
from tresym.coq.statement import Theorem, term
from tresym.reals.language.expression import Expr, add, multiply, number
from tresym.reals.signs.sign import sign

MAX_ANGLES = 3


def manifest_proofs(theorem: Theorem) -> Iterator[str]:
    """Yield proofs of an inequality to try."""
    if theorem.relation in ("!=", "=="):
        return
    up = theorem.relation in (">", ">=")
    d = theorem.left - theorem.right if up else theorem.right - theorem.left
    order = "<" if theorem.relation in (">", "<") else "<="
    premises = premise_lines(theorem, d)
    if premises:
        lines = [f"assert (main : 0 {order} {term(d)}).", "{ first [positive | lra | nra]. }"]
        yield "\n".join(["intros; saturate.", *premises, *lines, "lra."])
    for top, bottom in factored(d):
        yield "\n".join(
            [
                "intros; saturate; laws.",
                *(line.replace("saturate.", "") for line in premises),
                "facts.",
                f"assert (main : 0 {order} {term(top)}) by (first [positive | nra]).",
                f"assert (den : 0 < {term(bottom)}) by (first [positive | nra]).",
                f"assert (whole : 0 {order} {term(d)}).",
                f"{{ replace ({term(d)}) with ({term(top, 3)} / {term(bottom, 3)}) by "
                f"(field{_known([d])}; side).",
                f"  now apply {'Rdiv_lt_0_compat' if order == '<' else 'Rdiv_le_0_compat'}. }}",
                "lra.",
            ]
        )


def premise_lines(theorem: Theorem, d: Expr) -> list[str]:
    """Return the signs of sums that contain a premise or have an evident sign, smallest first."""
    given, premises = known(theorem), []
    for x, relation, y in theorem.given:
        if relation in (">", ">=", "<", "<="):
            e = x - y if relation in (">", ">=") else y - x
            if e.op == "+":
                premises.append(e)
    lines: list[str] = []
    for e in sorted({e for e in nodes([d]) if e.op == "+"}, key=lambda e: (e.size, str(e))):
        left = Counter(e.args)
        used = []
        for premise in premises:
            own = Counter(premise.args)
            if own <= left:
                left -= own
                used.append(premise)
        if used and left:
            whole = " + ".join(term(part, 2) for part in (*used, *left.elements()))
            lines.append(
                f"try (assert (0 <= {term(e)}) by (replace ({term(e)}) with ({whole}) by ring; "
                "first [positive | nra]))."
            )
        elif not used and (order := {"+": "<", ">=0": "<="}.get(sign(e, given) or "")):
            lines.append(f"try (assert (0 {order} {term(e)}) by (first [positive | facts; nra])).")
    return lines


def factored(d: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Factor the numerator without squares of sines or cosines; return it with the denominator."""
    u = unfolded(d)
    top, bottom = quotient(u)
    angles = list(dict.fromkeys(e.args[0] for e in nodes([u]) if e.op in ("sin", "cos")))
    if len(angles) > MAX_ANGLES:
        return
    found: dict[Expr, None] = {}
    try:
        for reduced in without_squares(expanded(top), angles):
            e = as_expression(reduced)
            powers = (Expr("^", (f, number(n))) if n > 1 else f for f, n in irreducible(e))
            whole = multiply(*powers)
            if expanded(whole) != reduced:
                whole = multiply(number(-1), whole)
            found[_signed(whole)] = None
    except OverflowError:
        return
    for whole in sorted(found, key=lambda e: (str(e).count("-"), e.size)):
        yield whole, bottom


def _signed(e: Expr) -> Expr:
    """Return a product with a positive coefficient, if one of its factors can absorb the sign."""
    factors = list(e.args) if e.op == "*" else [e]
    if factors[0].op == "number" and factors[0].args[0] < 0 and len(factors) > 1:
        for n, part in enumerate(factors):
            if part.op == "+" and sum(_is_negative(t) for t in part.args) * 2 >= len(part.args):
                factors[n] = add(*(-t for t in part.args))
                factors[0] = -factors[0]
                return multiply(*factors)
    return e


def _is_negative(e: Expr) -> bool:
    first = e.args[0] if e.op == "*" else e
    return first.op == "number" and bool(first.args[0] < 0)


def _known(parts: list[Expr]) -> str:
    angles = dict.fromkeys(e.args[0] for e in nodes(map(unfolded, parts)) if e.op in ("sin", "cos"))
    if not angles:
        return ""
    return f" [{' '.join(f'(sin_square {term(u, 3)})' for u in angles)}]"
