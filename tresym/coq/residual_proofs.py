"""Prove in Coq that a number is near a root of an equation, by its residual.

Where f(x) = 0 and f' >= m > 0 between x and h, the mean value theorem gives |x - h| <= |f(h)|/m.
For `abs(x - (e - e^3)) <= 3*e^5 given x + x^3 == e, 0 < e <= 1` the function is f(x) = x + x³ - e
with f' >= 1, and |f(e - e³)| <= 3 e⁵ is an inequality in e alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from flint import fmpq

from tresym.coq.claim_export import theorem as plain_theorem
from tresym.coq.statement import ATOM, Theorem, comparison, term, variable
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    apply,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision

Prove = Callable[[Theorem], "str | None"]
POINTS, MOST_SLOPES = 40, 3
SLOPES = tuple(fmpq(n, d) for n, d in ((8, 1), (4, 1), (2, 1), (1, 1), (1, 2), (1, 4), (1, 10)))
"""Lower bounds of the slope that are tried."""


def has_residual(theorem: Theorem) -> bool:
    """Return whether a theorem bounds an absolute value, under an equation."""
    side = {"<=": theorem.left, ">=": theorem.right}.get(theorem.relation)
    return side is not None and side.op == "abs" and any(c[1] == "==" for c in theorem.given)


def residual_proofs(theorem: Theorem, prove: Prove) -> Iterator[str]:
    """Yield proofs of ``abs(x - h) <= g`` for a root x of an equation among the conditions.

    Args:
        theorem: the theorem.
        prove: a prover of inequalities; None if it finds no proof.
    """
    left, right, relation = theorem.left, theorem.right, theorem.relation
    if relation == ">=":
        left, right = right, left
    if relation not in ("<=", ">=") or left.op != "abs":
        return
    equations = [c for c in theorem.given if c[1] == "=="]
    for name in sorted(symbols(left)):
        x = symbol(name)
        h = _other(left.args[0], x)
        if h is None or name in symbols(right):
            continue
        for equation in equations:
            f = equation[0] - equation[2]
            if name in symbols(f):
                given = tuple(c for c in theorem.given if c != equation)
                yield from _by_slope(theorem, x, h, (f, right), given, prove)


def _other(u: Expr, x: Expr) -> Expr | None:
    """Return h if ``u`` is x - h or h - x."""
    name = x.args[0]
    slope, rest = differentiate(u, name), substitute(u, {name: ZERO})
    return {ONE: -rest, MINUS_ONE: rest}.get(slope)


def _by_slope(
    theorem: Theorem,
    x: Expr,
    h: Expr,
    sides: tuple[Expr, Expr],
    given: tuple[tuple[Expr, str, Expr], ...],
    prove: Prove,
) -> Iterator[str]:
    name, (f, g) = x.args[0], sides
    if differentiate(h, name) != ZERO:
        return
    others = tuple(c for c in given if name not in symbols(c[0]) | symbols(c[2]))
    about = tuple(c for c in given if c not in others)
    slope = differentiate(f, name)
    lows = _lowest(slope, given)
    if not lows:
        f, slope = -f, -slope
        lows = _lowest(slope, given)
    m = None
    for low in lows[:MOST_SLOPES]:
        lemma = plain_theorem(Comparison(slope, ">=", number(low)), (*others, *about), "slope")
        script = prove(lemma)
        if script is not None:
            m, lemmas = number(low), [_asserted(lemma, script)]
            break
    if m is None:
        return
    near = {name: h}

    def at_h(e: Expr) -> Expr:
        return substitute(e, near)

    asked = [
        ("rest", Comparison(apply("abs", at_h(f)), "<=", multiply(m, g)), others),
        *(
            (
                f"inside_{n}",
                Comparison(substitute(a, {name: h}), sign, substitute(b, {name: h})),
                others,
            )
            for n, (a, sign, b) in enumerate(about)
        ),
    ]
    for label, claim, conditions in asked:
        lemma = plain_theorem(claim, conditions, label)
        script = prove(lemma)
        if script is None:
            return
        lemmas.append(_asserted(lemma, script))
    v = variable(name)
    texts = [f"(fun {v} : R => {term(e)})" for e in (f, slope)]
    ends = " ".join(
        f"assert (E_{n} : {comparison(at_h(a), sign, at_h(b))}) by (apply inside_{n}; inside_)."
        for n, (a, sign, b) in enumerate(about)
    )
    bars = theorem.left if theorem.relation == "<=" else theorem.right
    inner = term(at_h(f))
    shown, gap = term(bars.args[0]), f"{term(x)} - {term(h, ATOM)}"
    yield "\n".join(
        [
            *lemmas,
            f"intros; {ends} try apply Rle_ge.",
            f"assert (near : Rabs ({term(x)} - {term(h, ATOM)}) <= {term(g)}).",
            f"{{ apply (root_by_residual {texts[0]} {texts[1]} {term(x)} {term(h, ATOM)} "
            f"{term(m, ATOM)} {term(g, ATOM)}); [lra | | | cbv beta; lra | ].",
            "{ intros y Y; cbv beta; assert (B := between _ _ _ Y); "
            "eapply d_eq; [derive; inside_ | tidy; first [ring | field; inside_]]. }",
            "{ intros y Y; cbv beta; assert (B := between _ _ _ Y); "
            "apply Rge_le, slope; between_. }",
            f"{{ cbv beta; assert (Q : Rabs ({inner}) <= {term(multiply(m, g))}) "
            "by (apply rest; inside_); match goal with |- Rabs ?u <= _ => "
            f"replace u with ({inner}) by (first [ring | field; inside_]) end; lra. }} }}",
            f"first [exact near | replace ({shown}) with ({gap}) by field; exact near | "
            f"replace ({shown}) with (- ({gap})) by field; rewrite Rabs_Ropp; exact near | lra].",
        ]
    )


def _asserted(lemma: Theorem, script: str) -> str:
    return f"assert ({lemma.name} : {lemma.body.strip()}).\n{{ {script} }}"


def _lowest(slope: Expr, given: tuple[tuple[Expr, str, Expr], ...]) -> list[fmpq]:
    """Return numbers that the slope seems to exceed under the conditions."""
    inequalities = Given(tuple(c for c in given if c[1] != "=="))
    names = tuple(sorted(symbols(slope).union(*(symbols(c[0]) | symbols(c[2]) for c in given))))
    with ball_precision():
        values = [evaluate(slope, dict(p)) for p in inequalities.points(names, POINTS, 0)]
    return [m for m in SLOPES if values and all(v > m * fmpq(999, 1000) for v in values)]
