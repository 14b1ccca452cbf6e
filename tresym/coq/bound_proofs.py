"""Find Coq proofs of claims about integrals, sums and limits.

An integral is proved through an antiderivative, a sum by induction, a limit by the limits of its
parts and L'Hôpital's rule. Equations on the way are lemmas for the provers of equations.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from tresym.coq.bound_statements import (
    AND,
    MINUS_INFINITY,
    BoundTheorem,
    count_of,
    ends_of,
    natural_parts,
    naturally,
    sums_in,
)
from tresym.coq.claim_export import theorem
from tresym.coq.constant_proofs import constant_proofs
from tresym.coq.equations import exchanged, nodes
from tresym.coq.limit_proofs import Limits, StuckLimitError
from tresym.coq.order_proofs import path_proofs
from tresym.coq.statement import ATOM, Theorem, term, variable
from tresym.coq.sum_proofs import sum_proofs
from tresym.coq.theorem_trees import inside
from tresym.reals.decisions.antiderivatives import suggested
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison, Derivative
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path

Prove = Callable[[Theorem], "str | None"]


def bound_proofs(theorem: BoundTheorem, prove: Prove) -> Iterator[str]:
    """Yield proofs to try.

    Args:
        theorem: the theorem.
        prove: a prover of elementary relations; None if it finds no proof.
    """
    claim = theorem.claim
    if no_search(theorem) is not None:
        return
    if theorem.bounded is not None:
        yield from constant_proofs(theorem, _intros(theorem), prove)
        return
    if theorem.statement.path is not None and sums_in(claim.left):
        yield from sum_proofs(theorem, _intros(theorem), prove)
        return
    if theorem.statement.path is not None:
        yield from path_proofs(theorem, _intros(theorem))
        return
    (node,) = _bound_nodes(theorem)
    value = claim.right if node == claim.left else claim.left
    if node.op == "integral":
        yield from _of_integral(theorem, node, value, prove)
    else:
        yield from _of_sum(theorem, node, value, prove)


def _bound_nodes(theorem: BoundTheorem) -> list[Expr]:
    """Return the integrals and sums of a theorem, each once."""
    found = dict.fromkeys(outermost(theorem.claim.left, theorem.claim.right))
    return [e for e in found if e.op != "unknown"]


def no_search(theorem: Theorem | BoundTheorem) -> str | None:
    """Return why no proof of this kind of theorem is searched for, or None if one is."""
    if isinstance(theorem, Theorem) or theorem.statement.path is not None:
        return None
    claim, nodes = theorem.claim, _bound_nodes(theorem)
    if any(node.op == "sum" and node.args[2] == INFINITY for node in nodes):
        return "the file states the claim; tresym does not search for Coq proofs about series"
    if len(nodes) != 1 or claim.relation != "==" or nodes[0] not in (claim.left, claim.right):
        return (
            "the file states the claim; tresym searches for Coq proofs only where an integral or a "
            "finite sum is one side of an equation"
        )
    return None


def _intros(theorem: BoundTheorem) -> str:
    names = [*map(variable, (*theorem.reals, *theorem.naturals))]
    names += [f"G_{n}" for n in range(len(theorem.premises))]
    return f"intros {' '.join(names)}.\n" if names else ""


def _split(theorem: BoundTheorem, tactic: str, rest: str) -> str:
    """Return a script for the conclusions: that parts are defined, and the last of them."""
    text = rest
    for _ in theorem.says[:-1]:
        text = f"split. {{ {tactic} }}\n{text}"
    return text


def _of_sum(bound: BoundTheorem, node: Expr, value: Expr, prove: Prove) -> Iterator[str]:
    """Yield proofs by induction over the number of terms."""
    head = _intros(bound)
    defined = "intros; whole_numbers; repeat split; nonzero_whole."
    if not bound.naturals:
        closed = "cbn [terms Nat.add]; rewrite ?INR_IZR_INZ; cbn; first [lra | field; side]."
        yield head + _split(bound, defined, closed)
        return
    low = int(node.args[1].args[0].p)
    up, down = natural_parts(count_of(node))
    (n,) = symbols(up) if len(symbols(up)) == 1 else ("",)
    if not n or symbols(down):
        return
    less, more = (int(substitute(e, {n: ZERO}).args[0].p) for e in (down, up))
    if less:
        return
    (k,), body = inside(node)
    names, v = {n, k}, variable(n)
    shown, total = (term(naturally(e, names)) for e in (body, value))
    functions = f"(fun {variable(k)} : nat => {shown}) {low} (fun {v} : nat => {total})"
    # Conditions on n itself are not needed: the sum is proved for every natural n.
    about = [i for i, text in enumerate(bound.premises) if re.search(rf"\b{v}\b", text)]
    gone = f"clear {' '.join(f'G_{i}' for i in about)}; " if about else ""
    whole = f"{gone}apply (sum_induction {more} {functions}); clear {v}; "
    whole += f"[equal_terms | intros {v}; "
    found = _step(node, value, n, more, bound, prove)
    if found is not None:
        lemma, step = found
        yield f"{lemma}{head}" + _split(bound, defined, f"{whole}{step}].")
    yield head + _split(bound, defined, f"{whole}equal_terms].")


def _step(
    node: Expr, value: Expr, n: str, more: int, bound: BoundTheorem, prove: Prove
) -> tuple[str, str] | None:
    """Return the step of the induction as a lemma on real numbers, and how it is applied."""
    (k,), body = inside(node)
    low = int(node.args[1].args[0].p)
    if not elementary(body, value) or {k, n} & symbols(_exponents(body) + _exponents(value)):
        return None

    def last(index: Expr) -> Expr:
        return Expr("+", (index, number(low + more))) if low + more else index

    left = exchanged(value, {symbol(n): Expr("+", (symbol(n), ONE))})
    right = Expr("+", (value, exchanged(body, {symbol(k): last(symbol(n))})))
    others = (
        c for c in bound.statement.given.comparisons if n not in symbols(c[0]) | symbols(c[2])
    )
    given = (*others, (symbol(n), ">=", ZERO))
    lemma = theorem(Comparison(left, "==", right), given, "step")
    script = prove(lemma)
    if script is None:
        return None
    v, index = variable(n), term(last(Expr("natural", (symbol(n),))))
    applied = (
        f"replace (INR (S {v})) with (INR {v} + 1) by (rewrite S_INR; ring); "
        f"replace (INR ({low} + ({more} + {v}))) with ({index}) "
        f"by (rewrite !plus_INR; cbn [INR]; ring); pose proof (pos_INR {v}); apply step; inside_"
    )
    return f"assert (step : {lemma.body.strip()}).\n{{ {script} }}\n", applied


def _exponents(e: Expr) -> Expr:
    """Return the sum of the exponents in ``e`` that are not numbers."""
    found = [node.args[1] for node in nodes([e]) if node.op == "^" and node.args[1].op != "number"]
    return Expr("+", (ZERO, *found))


def _of_integral(bound: BoundTheorem, node: Expr, value: Expr, prove: Prove) -> Iterator[str]:
    """Yield proofs through antiderivatives."""
    (x,), f = inside(node)
    given = bound.statement.given
    positive = frozenset(
        str(c[0]) for c in given.comparisons if c[1] == ">" and c[0].op == "symbol"
    )
    for whole in suggested(f, x, positive):
        slope = _slope(bound, node, whole, prove)
        if slope is None:
            continue
        texts = [f"(fun {variable(x)} : R => {term(e)})" for e in (f, whole)]
        if any(ends_of(node)):
            yield from _improper(bound, node, whole, texts, slope)
            continue
        ends = [exchanged(whole, {symbol(x): end}) for end in node.args[2:0:-1]]
        gap = Expr("+", (ends[0], Expr("*", (MINUS_ONE, ends[1]))))
        equal = theorem(Comparison(gap, "==", value), given.comparisons, "value")
        script = prove(equal)
        last, lemma = "cbv beta; equal_numbers", ""
        if script is not None:
            lemma = f"assert (value : {equal.body.strip()}).\n{{ {script} }}\n"
            same = f"transitivity ({term(gap)})"
            last = f"first [{same}; [{last} | apply value; inside_] | {last}]"
        proof = (
            f"apply (by_antiderivative {texts[0]} {texts[1]}).\n"
            "{ continues_inside. }\n{ continues_inside. }\n"
            f"{{ intros {variable(x)} X; apply slope; inside_. }}\n{{ {last}. }}"
        )
        yield slope + lemma + _intros(bound) + _split(bound, "inside.", proof)


def _slope(bound: BoundTheorem, node: Expr, whole: Expr, prove: Prove) -> str | None:
    """Return a proof that the derivative is the integrand, between the ends if they are numbers."""
    (x,), f = inside(node)
    low, high = node.args[1:]
    given, opened = bound.statement.given.comparisons, ends_of(node)
    derived = differentiate(whole, x)
    named = Comparison(derived, "==", f, (Derivative(whole, x, 1, derived),))
    weak = ["=" if any(opened) and not is_open else "" for is_open in opened]
    inner = [(symbol(x), f">{weak[0]}", low)] if low != MINUS_INFINITY else []
    inner += [(symbol(x), f"<{weak[1]}", high)] if high != INFINITY else []
    ordered = any(opened) or not symbols(high - low)
    for region in [(*given, *inner)] * ordered + [given]:
        lemma = theorem(named, region, "slope")
        script = prove(lemma)
        if script is not None:
            return f"assert (slope : {lemma.body.strip()}).\n{{ {script} }}\n"
    return None


def _improper(
    bound: BoundTheorem, node: Expr, whole: Expr, texts: list[str], head: str
) -> Iterator[str]:
    """Yield proofs through the limits of the antiderivative at the ends."""
    (x,), _ = inside(node)
    low, high = node.args[1:]
    v = variable(x)
    opened = ends_of(node)
    bounds = [] if low == MINUS_INFINITY else [f"{term(low)} {'<' if opened[0] else '<='} {v}"]
    bounds += [] if high == INFINITY else [f"{v} {'<' if opened[1] else '<='} {term(high)}"]
    region = f"(fun {v} : R => {AND.join(bounds) or 'True'})"
    inner, limits, values = [], [], []
    for end, is_open, side in ((low, opened[0], 1), (high, opened[1], -1)):
        if not is_open:
            inner.append("{ hnf; lra. }")
            values.append(substitute(whole, {x: end}))
            limits.append(f"{{ apply (t_point_value {texts[1]}). equal_numbers. }}")
            continue
        infinite = end in (INFINITY, MINUS_INFINITY)
        path = Path(x, None if infinite else end, (-side if infinite else side,))
        search = Limits(bound.statement.given, "(1 / 4)", "5")
        try:
            found = limit_of(whole, x, path.point, path.sides[0], bound.statement.given)
            if found is None or found in (INFINITY, MINUS_INFINITY):
                return
            limits.append(f"{{ {search.along(whole, path, found)} }}")
        except StuckLimitError:
            return
        values.append(found)
        if infinite:
            other = low if end == INFINITY else high
            at = "0" if other in (INFINITY, MINUS_INFINITY) else term(other)
            inner.append(f"{{ exists ({at}); intros; hnf; lra || (split; lra). }}")
        else:
            other = high if side > 0 else low
            size = "1" if other in (INFINITY, MINUS_INFINITY) else term(high - low)
            inner.append(
                f"{{ exists (mkposreal ({size}) ltac:(lra)); intros u B U; "
                f"change (Rabs (u - {term(end, ATOM)}) < {size}) in B; "
                "apply Rabs_def2 in B; lra. }"
            )
    shown = " ".join(f"({term(e)})" for e in values)
    proof = (
        f"apply (improper {texts[0]} {texts[1]} _ _ {shown}).\n"
        f"{{ apply (Filter_prod _ _ _ {region} {region}).\n" + "\n".join(inner) + "\n"
        "cbv beta; intros u w U W z Z; simpl in Z; "
        "(split; [apply slope; inside_ | unfold Rpower; continues; inside_]). }\n"
        + "\n".join(limits)
        + "\n{ equal_numbers. }"
    )
    yield head + _intros(bound) + _split(bound, "inside.", proof)
