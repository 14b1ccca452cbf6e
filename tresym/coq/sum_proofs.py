"""Prove orders of sums in Coq: by comparison with the integral, or by Stolz's theorem.

Where F' = f and f rises or falls, |f(1) + ... + f(n) - (F(n) - F(1))| <= |f(1)| + |f(n)|. So
`sum(1/k, k, 1, n) == log(n) + O(1)` follows from orders of 1, 1/n and log(n) - log(1) - log(n).
Where f' rises or falls, half of the first and last terms, (f(1) + f(n))/2, belongs to the integral,
and |f'(1)| + |f'(n)| bounds what is left, by the formula of Euler and Maclaurin of first order:
`sum(log(k), k, 1, n) == n*log(n) - n + log(n)/2 + O(1)`.
Where g rises to infinity, the sum divided by g(n) has the limit of f(n + 1)/(g(n + 1) - g(n)):
`sum(k^2, k, 1, n)/n^3 -> 1/3`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from tresym.coq.bound_statements import BoundTheorem, naturally, sides_of, sums_in
from tresym.coq.claim_export import theorem as plain_theorem
from tresym.coq.constant_proofs import tidied
from tresym.coq.expansion_proofs import LENGTHS, NoExpansionError, folded
from tresym.coq.limit_proofs import INFINITE
from tresym.coq.order_proofs import NEEDED, QUOTIENTS, Along
from tresym.coq.statement import ATOM, Theorem, term, variable
from tresym.coq.theorem_trees import inside
from tresym.reals.decisions.antiderivatives import suggested
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison, Derivative
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    factors_in,
    fresh,
    multiply,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError

Prove = Callable[[Theorem], "str | None"]


def sum_proofs(theorem: BoundTheorem, head: str, prove: Prove) -> Iterator[str]:
    """Yield proofs that a sum is O, o or ~ of a function, or differs from one by it.

    Args:
        theorem: the theorem.
        head: the sentence that introduces its variables and premises.
        prove: a prover of relations between real numbers; None if it finds no proof.
    """
    claim, path = theorem.claim, theorem.statement.path
    assert path is not None
    (node, *more) = sums_in(claim.left)
    if more or sums_in(claim.right):
        return
    if claim.relation in ("O", "o", "~"):
        yield from _by_integral(theorem, head, node, prove)
    if node.args[1] == ONE and claim.relation in (*QUOTIENTS, LIMIT):
        yield from _by_stolz(theorem, head, node, prove)


def _by_stolz(theorem: BoundTheorem, head: str, node: Expr, prove: Prove) -> Iterator[str]:
    """Yield a proof through the quotient of the differences, by Stolz's theorem."""
    claim, path = theorem.claim, theorem.statement.path
    assert path is not None
    n, given = path.name, theorem.statement.given
    v, x = variable(n), symbol(path.name)
    if claim.relation == LIMIT:
        parts = [*factors_in(claim.left)]
        linear = node in parts
        g = multiply(*(_inverse(part) for part in parts if part != node))
    else:
        g, linear = claim.right, claim.left == node
    if not linear or claim.relation == "omega":
        return
    (k,), body = inside(node)
    step = substitute(g, {n: x + ONE}) - g
    quotient = Expr("*", (substitute(body, {k: x + ONE}), Expr("^", (step, MINUS_ONE))))
    value = limit_of(quotient, n, None, 1, given)
    if value is None or value in INFINITE or str(value) != NEEDED.get(claim.relation, str(value)):
        return
    rises = plain_theorem(
        Comparison(step, ">", ZERO), (*given.comparisons, (x, ">=", ONE)), "rises"
    )
    script = prove(rises)
    infinite = _limit(theorem, g, INFINITY)
    limit = _limit(theorem, quotient, value)
    if script is None or infinite is None or limit is None:
        return
    terms = f"(fun {variable(k)} : nat => {term(naturally(body, {k}))})"
    shown = [f"(fun {v} : nat => {term(naturally(e, {n}))})" for e in (g, quotient)]
    after = (
        f"exists 1%nat; intros {v} N; apply le_INR in N; cbn [INR] in N; cbv beta; rewrite ?S_INR; "
    )
    stolz = (
        f"apply (stolz_terms {terms} {shown[0]} {shown[1]} {term(value, ATOM)}).\n"
        f"{{ {after}assert (P : {term(naturally(step, {n}))} > 0) by (apply rises; inside_); "
        "lra. }\n"
        f"{{ {infinite} }}\n"
        f"{{ {after}apply f_equal2; [sum_equal | apply f_equal; ring]. }}\n{{ {limit} }}"
    )
    start = f"assert (rises : {rises.body.strip()}).\n{{ {script} }}\n{head}"
    split = "".join(f"split.\n{{ {one} }}\n" for one in _defined(theorem))
    left, right = sides_of(theorem)
    if claim.relation == LIMIT:
        yield (
            f"{start}{split}apply (whole_beside _ (fun {v} : nat => terms {terms} 1 {v} * / "
            f"({term(naturally(g, {n}))}))).\n"
            f"{{ {after}first [ring | field; repeat split; inside_]. }}\n{stolz}"
        )
        return
    f_text, g_text = f"(fun {v} : nat => {left})", f"(fun {v} : nat => {right})"
    law = QUOTIENTS[claim.relation].format(f=f_text, g=g_text, l=term(value, ATOM))
    yield f"{start}{split}{law}\n{{ apply apart_from_infinite. {infinite} }}\n{{ {stolz} }}"


def _inverse(e: Expr) -> Expr:
    base, exponent = e.args if e.op == "^" else (e, ONE)
    return power(base, multiply(MINUS_ONE, exponent))


def _limit(theorem: BoundTheorem, e: Expr, value: Expr) -> str | None:
    """Return the proof of a limit of a function without a sum."""
    part = replace(theorem, claim=Comparison(e, LIMIT, value), says=("eventually",))
    return _found(part)


def _by_integral(theorem: BoundTheorem, head: str, node: Expr, prove: Prove) -> Iterator[str]:
    """Yield proofs by comparison with the integral."""
    claim, path = theorem.claim, theorem.statement.path
    assert path is not None
    given = theorem.statement.given
    (k,), body = inside(node)
    n, low = path.name, node.args[1]
    v, f = variable(n), substitute(body, {k: symbol(path.name)})
    rest = replaced(claim.left, {node: ZERO}) - (claim.right if claim.relation == "~" else ZERO)
    law = "O_sum" if claim.relation == "O" else "o_sum"
    for whole in suggested(f, n, frozenset({n})):
        slope = _slope("slope", whole, f, n, low, given.comparisons, prove)
        if slope is None:
            continue
        for trapezoids in (False, True):
            end = differentiate(f, n) if trapezoids else f
            lemmas = _lemmas(f, end, n, low, given.comparisons, prove)
            if lemmas is None:
                continue
            difference = whole - substitute(whole, {n: low}) + rest
            if trapezoids:
                difference += (f + substitute(f, {n: low})) * number(Fraction(1, 2))
            main = tidied(folded(difference))
            main = ZERO if normal_form(main, given) == ZERO else main
            bounds = (main, folded(substitute(end, {n: low})), end)
            orders = [_order(theorem, e, law[0]) for e in (bounds[1], bounds[2], bounds[0])]
            if None in orders:
                continue
            shown = [
                f"(fun {v} : nat => {term(naturally(e, {n}))})" for e in (*bounds, claim.right)
            ]
            left, right = sides_of(theorem)
            s = (
                f"(fun {v} : nat => {left} - ({right}))"
                if claim.relation == "~"
                else (f"(fun {v} : nat => {left})")
            )
            count = f"({v} - 1)" if low != ZERO else v
            used = "trapezoids_near _ _ _" if trapezoids else "sum_near _ _"
            slopes = "slope_ bend_" if trapezoids else "slope_"
            near = (
                f"exists 1%nat; intros {v} N; cbv beta; "
                f"assert (0 < INR {v}) by (apply lt_0_INR; lia); "
                f"pose proof ({used} {term(low)} {slopes} mono_ {count}%nat {v} ltac:(lia)) as B; "
                f"cbn [INR] in B; cbv beta in B; "
                f"replace (S {count}) with ({v}{' + 1' if low == ZERO else ''})%nat in B by lia; "
                "eapply Rle_trans; [right; apply f_equal | eapply Rle_trans; "
                "[exact B | right; apply f_equal2; apply f_equal]]; sum_equal."
            )
            steps = "".join(f"\n{{ {script} }}" for script in (near, *map(str, orders)))
            last = f"apply ({law} {s} {' '.join(shown)}).{steps}"
            split = "".join(f"split.\n{{ {script} }}\n" for script in _defined(theorem))
            yield f"{slope}\n{lemmas}\n{head}{split}{last}"


Conditions = tuple[tuple[Expr, str, Expr], ...]


def _slope(
    name: str, whole: Expr, f: Expr, n: str, low: Expr, given: Conditions, prove: Prove
) -> str | None:
    """Return the proof that ``whole`` has the derivative f."""
    derived = differentiate(whole, n)
    named = Comparison(derived, "==", f, (Derivative(whole, n, 1, derived),))
    slope = plain_theorem(named, (*given, (symbol(n), ">=", low)), name)
    script = prove(slope)
    if script is None:
        return None
    functions = [f"(fun {variable(n)} : R => {term(e)})" for e in (f, whole)]
    return (
        f"assert ({name} : {slope.body.strip()}).\n{{ {script} }}\n"
        f"assert ({name}_ : forall y, INR {term(low)} <= y -> is_derive {functions[1]} y "
        f"({functions[0]} y)).\n"
        f"{{ intros y Y; cbn [INR] in Y; cbv beta; apply {name}; inside_. }}"
    )


def _lemmas(f: Expr, end: Expr, n: str, low: Expr, given: Conditions, prove: Prove) -> str | None:
    """Return the proofs that ``end``, which is f or its slope, falls or rises."""
    x, bend = symbol(n), ""
    if end != f:
        found = _slope("bend", f, end, n, low, given, prove)
        if found is None:
            return None
        bend = f"{found}\n"
    later = symbol(fresh("later", {n, *symbols(end)}))
    region = (*given, (x, ">=", low))
    ways = [
        ("left", Comparison(substitute(end, {n: later}), "<=", end)),
        ("right", Comparison(end, "<=", substitute(end, {n: later}))),
    ]
    function, at = f"(fun {variable(n)} : R => {term(end)})", term(low)
    for side, way in ways:
        mono = plain_theorem(way, (*region, (later, ">=", x)), "mono")
        script = prove(mono)
        if script is None:
            continue
        a, b = ("y", "x") if side == "left" else ("x", "y")
        return (
            f"{bend}assert (mono : {mono.body.strip()}).\n{{ {script} }}\n"
            f"assert (rises : forall x y, INR {at} <= x -> x <= y -> "
            f"{function} {a} <= {function} {b}).\n"
            "{ intros x y X Y; cbn [INR] in X; cbv beta; apply mono; inside_. }\n"
            f"pose proof (or_{'introl' if side == 'left' else 'intror'} rises : "
            f"(forall x y, INR {at} <= x -> x <= y -> {function} y <= {function} x) \\/ "
            f"(forall x y, INR {at} <= x -> x <= y -> {function} x <= {function} y)) "
            "as mono_."
        )
    return None


def _order(theorem: BoundTheorem, e: Expr, relation: str) -> str | None:
    """Return the proof that a function without a sum is O or o of the right side."""
    if e == ZERO:
        return f"apply {relation}_none."
    claim = replace(theorem.claim, left=e, relation=relation)
    return _found(replace(theorem, claim=claim, says=("eventually",)))


def _found(part: BoundTheorem) -> str | None:
    """Return the proof of a limit or an order without a sum."""
    for way in (Along(part, ""), Along(part, "", squared=True)):
        for order in LENGTHS:
            try:
                return way.by_expansions(order)
            except (NoExpansionError, InputError):
                continue
    return next(Along(part, "", squared=True).by_parts("1"), None)


def _defined(theorem: BoundTheorem) -> list[str]:
    """Return the proofs that parts of the claim are defined."""
    return ["sum_defined."] * (len(theorem.says) - 1)
