"""Proofs of inequalities: by polynomials, by Taylor's theorem about one point, by intervals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations, permutations

from tresym.coq.equations import Script, quotient, unfolded
from tresym.coq.linear import as_expression, expanded
from tresym.coq.statement import Theorem, term, variable
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    differentiate,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.inverted import solutions
from tresym.reals.places.conditions import Given
from tresym.reals.places.domain import with_domain
from tresym.reals.places.points import Range
from tresym.reals.signs.sign import sign

MAX_ORDER = 5
MAX_SIZE = 300
MAX_BASES = 6
MAX_EXPANSIONS = 2
POINT = symbol("point")
UP, DOWN = ("+", ">=0", "0"), ("-", "<=0", "0")


def inequality_proofs(theorem: Theorem) -> Iterator[str]:
    """Proofs to try, the likeliest first."""
    left, right, relation = theorem.left, theorem.right, theorem.relation
    d = left - right if relation in (">", ">=", "!=") else right - left
    strict = relation in (">", "<", "!=")
    given = with_domain(Given(theorem.given), left, right)
    for difference in (d, -d) if relation == "!=" else (d,):
        yield "intros; saturate; absolute; facts; first [lra | nra]."
        yield from by_taylor(theorem, difference, given)
        if not strict:
            yield from by_cones(theorem, difference)
        yield by_polynomials(theorem, difference, strict, hints=False)
        yield by_polynomials(theorem, difference, strict, hints=True)
        yield from by_intervals(theorem, given)


def order(strict: bool) -> str:
    """The sign of the relation."""
    return "<" if strict else "<="


def by_polynomials(theorem: Theorem, d: Expr, strict: bool, hints: bool) -> str:
    """The numerator by ``nra``, the denominator by its structure."""
    return "\n".join(["intros; saturate; laws.", *shown(theorem, d, strict, hints), "lra."])


def shown(theorem: Theorem, d: Expr, strict: bool, hints: bool, expand: bool = True) -> list[str]:
    """Sentences after which ``0 <= d``, or ``0 < d``, is among the premises."""
    u = unfolded(d)
    top, bottom = quotient(u)
    rel = order(strict)
    script = Script(theorem, splits=False)
    top = script.in_factors(collected(top)) if expand else top
    script.lines = []
    script.prepared([d, *(e for e, _ in theorem.defined)])
    lines = [f"assert (main : 0 {rel} {term(top)}).", "{", "facts.", *script.lines]
    if hints:
        names = [variable(name) for name in sorted(symbols(d))] + script.names
        lines.append(squares(names, theorem))
        for name in sorted(symbols(d)):
            for c in solutions(differentiate(d, name), name)[:2]:
                square = f"(pow2_ge_0 ({variable(name)} - {term(c, 3)}))"
                lines.append(f"try pose proof {square}.")
                lines.append(
                    f"try pose proof (Rmult_le_pos {variable(name)} _ ltac:(lra) {square})."
                )
    lines.append("first [positive | lra | nra].")
    lines.append("}")
    lines.append(f"assert (den : 0 < {term(bottom)}) by (first [positive | nra]).")
    lines.append(f"assert (0 {rel} {term(u)}).")
    lines.append(
        f"{{ replace ({term(u)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
        f"{'now apply Rdiv_lt_0_compat' if strict else 'now apply Rdiv_le_0_compat'}. }}"
    )
    return lines


def by_cones(theorem: Theorem, d: Expr) -> Iterator[str]:
    """By the order of the variables: the coefficients in their differences have one sign."""
    top, bottom = quotient(d)
    try:
        terms = expanded(top)
    except OverflowError:
        return
    names = sorted({part for m in terms for part, _ in m}, key=str)
    if (
        not 2 <= len(names) <= 4
        or any(e.op != "symbol" for e in names)
        or symbols(bottom) - {e.args[0] for e in names}
    ):
        return
    leaves = []
    for ordering in permutations(names):
        steps = [ordering[0]] + [symbol(f" {k}") for k in range(1, len(ordering))]
        values = {e.args[0]: add(*steps[: k + 1]) for k, e in enumerate(ordering)}
        try:
            cone = expanded(substitute(as_expression(terms), values))
        except OverflowError:
            return
        if any(c < 0 for c in cone.values()):
            return
        back = {f" {k}": ordering[k] - ordering[k - 1] for k in range(1, len(ordering))}
        text = " + ".join(
            term(
                multiply(
                    number(c),
                    *(
                        Expr("^", (substitute(part, back), number(n)))
                        for part, n in sorted(m, key=str)
                    ),
                ),
                1,
            )
            for m, c in cone.items()
        )
        leaves.append(f"(replace ({term(top)}) with ({text}) by ring; positive)")
    pairs = "; ".join(
        f"destruct (Rle_or_lt {variable(x.args[0])} {variable(y.args[0])})"
        for x, y in combinations(names, 2)
    )
    yield "\n".join(
        [
            "intros; saturate.",
            f"assert (main : 0 <= {term(top)}).",
            f"{{ {pairs}; first [exfalso; lra | {' | '.join(leaves)}]. }}",
            f"assert (den : 0 < {term(bottom)}) by (first [positive | nra]).",
            f"assert (0 <= {term(d)}).",
            f"{{ replace ({term(d)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
            "now apply Rdiv_le_0_compat. }",
            "lra.",
        ]
    )


def squares(texts: Sequence[str], theorem: Theorem) -> str:
    """Squares that a certificate is often made of."""
    texts = texts[:4]
    found = [f"({x} - {y})" for x, y in combinations(texts, 2)]
    found += [f"({x} + {y})" for x, y in combinations(texts, 2)][:2]
    found += [f"({x} ^ 2 - {y} ^ 2)" for x, y in combinations(texts, 2)][:2]
    found += [f"({x} - {c})" for x in texts[:2] for c in ("1", "1 / 2")]
    positive_names = [
        variable(x.args[0])
        for x, sign_, y in theorem.given
        if x.op == "symbol" and sign_ in (">", ">=") and y == ZERO
    ]
    lines = [f"pose proof (pow2_ge_0 {s})." for s in found]
    lines += [
        f"try pose proof (Rmult_le_pos {p} _ ltac:(lra) (pow2_ge_0 {s}))."
        for p in positive_names[:3]
        for s in found[: 3 if len(texts) > 1 else 1]
    ]
    return " ".join(lines)


def collected(e: Expr) -> Expr:
    """The polynomial multiplied out, where that is small."""
    try:
        terms = expanded(e)
    except OverflowError:
        return e
    return as_expression(terms)


def by_intervals(theorem: Theorem, given: Given) -> Iterator[str]:
    """Interval arithmetic, by bisection."""
    names = theorem.variables
    box = given.box
    bounded = all(
        (r := box.get(name, Range())).low is not None and r.high is not None for name in names
    )
    if bounded:
        options = [f"i_bisect {variable(name)}" for name in names]
        yield f"intros. interval{' with (' + ', '.join(options) + ')' if options else ''}."
        if len(names) == 1:
            x = variable(names[0])
            yield f"intros. interval with (i_taylor {x}, i_bisect {x})."
    elif not names:
        yield "intros. interval with (i_prec 100)."


def by_taylor(theorem: Theorem, d: Expr, given: Given) -> Iterator[str]:
    """By the signs of the terms below some order about a point, and of the derivative of it."""
    count = 0
    for name in sorted(symbols(d)):
        where = given.box.get(name, Range())
        bases = [number(c) for c in (where.low, where.high) if c is not None and c.q < 2**64]
        bases += [ZERO, ONE, *map(symbol, sorted(symbols(d) - {name}))]
        bases += solutions(differentiate(d, name), name)
        for c in list(dict.fromkeys(bases))[:MAX_BASES]:
            found = _about(theorem, d, given, name, c)
            yield from found
            count += bool(found)
            if count == MAX_EXPANSIONS:
                return


def _about(theorem: Theorem, d: Expr, given: Given, name: str, c: Expr) -> list[str]:
    """The proofs about ``name = c``, where the signs are as they need them."""
    beside = sign(symbol(name) - c, given)
    sides = [1] * (beside not in ("-", "<=0")) + [-1] * (beside not in ("+", ">=0"))
    chain = [d]
    for k in range(MAX_ORDER + 1):
        fit = [UP if side > 0 or k % 2 == 0 else DOWN for side in sides]
        if k and all(sign(chain[k], given) in signs for signs in fit):
            return [_chain(theorem, chain, mode, name, c, sides) for mode in range(3)]
        at = sign(substitute(chain[k], {name: c}), given)
        if not all(at in signs for signs in fit):
            return []
        chain.append(differentiate(chain[k], name))
        if chain[-1].size > MAX_SIZE:
            return []
    return []


def last_step(
    theorem: Theorem,
    e: Expr,
    name: str,
    up: bool,
    mode: int,
    between: tuple[tuple[Expr, str, Expr], ...],
) -> str:
    """The sign of the last derivative at another point."""
    if mode == 0:
        return "facts; first [positive | lra | nra]."
    theorem = replace(theorem, given=(*theorem.given, *between))
    moved = substitute(e if up else -e, {name: POINT})
    return " ".join(["laws.", *shown(theorem, moved, False, mode == 2), "lra."])


def _chain(
    theorem: Theorem, chain: list[Expr], mode: int, name: str, c: Expr, sides: list[int]
) -> str:
    x, base, n = variable(name), term(c, 3), len(chain) - 1
    lines = ["intros; saturate."]
    functions = [f"(fun {x} : R => {term(f)})" for f in chain]
    for k, f in enumerate(functions):
        lines.append(f"pose (fun_{k} := {f}).")
    whole = []
    for side in sides:
        here = f"{base} <= v_point <= {x}" if side > 0 else f"{x} <= v_point <= {base}"
        block = [
            f"assert (way : {base} {'<=' if side > 0 else '>='} {x}) by (first [assumption | lra])."
        ]
        for k in range(n, -1, -1):
            up = side > 0 or k % 2 == 0
            says = "0 <= " + f"fun_{k} v_point" if up else f"fun_{k} v_point <= 0"
            block.append(f"assert (sig_{k} : forall v_point, {here} -> {says}).")
            if k == n:
                ends = (c, symbol(name)) if side > 0 else (symbol(name), c)
                between = ((POINT, ">=", ends[0]), (POINT, "<=", ends[1]))
                proof = last_step(theorem, chain[n], name, up, mode, between)
                block.append(f"{{ intros v_point ?; unfold fun_{k}; saturate. {proof} }}")
                continue
            lemma = ("from_left" if side > 0 else "from_right") + ("_ge" if up else "_le")
            block.append(
                f"{{ intros v_point ?; apply ({lemma} fun_{k} fun_{k + 1} {base} v_point); "
                f"[lra | | | unfold fun_{k}; base_value]; intros v_next ?; "
                f"[unfold fun_{k}, fun_{k + 1}; eapply d_eq; [derive; hard | tidy; slope] "
                f"| apply sig_{k + 1}; lra]. }}"
            )
        block.append(f"specialize (sig_0 {x} ltac:(lra)); unfold fun_0 in sig_0; lra.")
        whole.append("\n".join(block))
    if len(sides) == 2:
        lines.append(f"destruct (Rle_or_lt {base} {x}).")
        lines.append("{ " + whole[0] + " }")
        lines.append("{ " + whole[1] + " }")
    else:
        lines.append(whole[0])
    return "\n".join(lines)
