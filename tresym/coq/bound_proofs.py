"""Find Coq proofs of claims about integrals, sums and limits.

An integral is proved through an antiderivative, a sum by induction, a limit by the limits of its
parts and L'Hôpital's rule. Equations on the way are lemmas for the provers of equations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from tresym.coq.bound_statements import (
    MINUS_INFINITY,
    BoundTheorem,
    count_of,
    ends_of,
    natural_parts,
    naturally,
)
from tresym.coq.equations import exchanged, nodes
from tresym.coq.claim_export import theorem
from tresym.coq.limit_proofs import Limits, StuckLimitError
from tresym.coq.statement import ATOM, Theorem, comparison, term, variable
from tresym.coq.theorem_trees import inside
from tresym.reals.decisions.antiderivatives import suggested, summed
from tresym.reals.decisions.claim_parsing import Comparison, Derivative
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    differentiate,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import INFINITY

Prove = Callable[[Theorem], "str | None"]


def bound_proofs(theorem: BoundTheorem, prove: Prove) -> Iterator[str]:
    """Yield proofs to try.

    Args:
        theorem: the theorem.
        prove: a prover of elementary relations; None if it finds no proof.
    """
    claim = theorem.claim
    if theorem.statement.path is not None:
        yield from _of_limit(theorem)
        return
    nodes = [e for e in dict.fromkeys(outermost(claim.left, claim.right)) if e.op != "unknown"]
    if len(nodes) != 1 or claim.relation != "==" or nodes[0] not in (claim.left, claim.right):
        return
    (node,) = nodes
    value = claim.right if node == claim.left else claim.left
    if node.op == "integral":
        yield from _of_integral(theorem, node, value, prove)
    elif node.args[2] == INFINITY:
        yield from _of_series(theorem, node, value)
    else:
        yield from _of_sum(theorem, node, value, prove)


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
    (k,), body = inside(node)
    names = {n, k}
    shown, total = naturally(body, names), naturally(value, names)
    start = f"destruct (natural_minus {less} {variable(n)} ltac:(assumption)) as [m ->]. " if less else ""
    if less:
        return
    text = f"(fun {variable(k)} : nat => {term(shown)}) {low} (fun {variable(n)} : nat => {term(total)})"
    whole = f"apply (sum_induction {more} {text}); clear {variable(n)}; [unfold_whole; equal_whole | intros {variable(n)}; "
    script = _step(node, value, n, more, low, bound, prove)
    if script is not None:
        yield f"{script[0]}{head}" + _split(bound, defined, f"{start}{whole}{script[1]}].")
    yield head + _split(bound, defined, f"{start}{whole}unfold_whole; equal_whole].")


def _step(
    node: Expr, value: Expr, n: str, more: int, low: int, bound: BoundTheorem, prove: Prove
) -> tuple[str, str] | None:
    """Return the step of the induction as a lemma on real numbers, and how it is applied."""
    (k,), body = inside(node)
    if symbols(_exponents(body)) & {k} or symbols(_exponents(value)) & {n} or outermost_any(body, value):
        return None
    at = Expr("+", (symbol(n), number(low + more))) if low + more else symbol(n)
    left = exchanged(value, {symbol(n): Expr("+", (symbol(n), ONE))})
    right = Expr("+", (value, exchanged(body, {symbol(k): at})))
    given = (*bound.statement.given.comparisons, (symbol(n), ">=", ZERO))
    lemma = theorem(Comparison(left, "==", right), given, "step")
    script = prove(lemma)
    if script is None:
        return None
    v = variable(n)
    apply_ = (
        f"replace (INR (S {v})) with (INR {v} + 1) by (rewrite S_INR; ring); "
        f"replace (INR ({low} + ({more} + {v}))) with ({term(Expr('+', (Expr('natural', (symbol(n),)), number(low + more))) if low + more else Expr('natural', (symbol(n),)))}) by (rewrite !plus_INR; cbn [INR]; ring); "
        f"pose proof (pos_INR {v}); apply step; inside_"
    )
    return f"assert (step : {lemma.body.strip()}).\n{{ {script} }}\n", apply_


def _exponents(e: Expr) -> Expr:
    """Return the sum of the exponents in ``e`` that are not numbers."""
    found = [node.args[1] for node in nodes([e]) if node.op == "^" and node.args[1].op != "number"]
    return Expr("+", (ZERO, *found))


def outermost_any(*trees: Expr) -> bool:
    """Return whether the trees contain factorials or other functions without a real counterpart."""
    return not elementary(*trees)


def _of_series(theorem: BoundTheorem, node: Expr, value: Expr) -> Iterator[str]:
    """Through the closed form of the partial sums."""
    (k,), body = inside(node)
    return
    yield


def _of_limit(theorem: BoundTheorem) -> Iterator[str]:
    claim, path = theorem.claim, theorem.statement.path
    assert path is not None
    head = _intros(theorem)
    for radius in ("1", "(1 / 4)", "(1 / 100)"):
        beyond = {"1": "1", "(1 / 4)": "5", "(1 / 100)": "100"}[radius]
        limits = Limits(theorem.statement.given, radius, beyond)
        try:
            script = limits.along(claim.left, path, claim.right)
        except StuckLimitError:
            continue
        defined = f"{limits.defined(path)} repeat split; apart_."
        yield head + _split(theorem, defined, script)


def _of_integral(bound: BoundTheorem, node: Expr, value: Expr, prove: Prove) -> Iterator[str]:
    (x,), f = inside(node)
    low, high = node.args[1:]
    given = bound.statement.given
    positive = frozenset(str(c[0]) for c in given.comparisons if c[1] == ">" and c[0].op == "symbol")
    opened = ends_of(node)
    for whole in suggested(f, x, positive):
        derived = differentiate(whole, x)
        slope = Comparison(whole, "==", f)
        named = Comparison(derived, "==", f, (Derivative(whole, x, 1, derived),))
        regions = [given.comparisons]
        inner = [(symbol(x), ">", low)] if low != MINUS_INFINITY else []
        inner += [(symbol(x), "<", high)] if high != INFINITY else []
        regions.append((*given.comparisons, *inner))
        found = None
        for region in regions[::-1] if any(opened) or not symbols(high - low) else regions[:1]:
            lemma = theorem(named, region, "slope")
            script = prove(lemma)
            if script is not None:
                found = f"assert (slope : {lemma.body.strip()}).\n{{ {script} }}\n"
                break
        if found is None:
            continue
        v = variable(x)
        function = f"(fun {v} : R => {term(f)})"
        whole_text = f"(fun {v} : R => {term(whole)})"
        head = found
        if not any(opened):
            ends = [substitute(whole, {x: end}) for end in (high, low)]
            equal = theorem(Comparison(ends[0] - ends[1], "==", value), given.comparisons, "value")
            script = prove(equal)
            if script is None:
                continue
            head += f"assert (value : {equal.body.strip()}).\n{{ {script} }}\n{_intros(bound)}"
            proof = (
                f"apply (by_antiderivative {function} {whole_text}).\n"
                "{ continues_inside. }\n{ continues_inside. }\n"
                f"{{ intros {v} X; try ends_of X; apply slope; inside_. }}\n"
                f"{{ transitivity ({term(ends[0] - ends[1])}); "
                "[cbv beta; equal_numbers | apply value; inside_]. }"
            )
            yield head + _split(bound, "inside.", proof)
