"""Proofs of inequalities: by polynomials, by Taylor's theorem about one point, by intervals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from tresym.coq.equations import Script, quotient, unfolded
from tresym.coq.linear import Monomial, Vector, expanded
from tresym.coq.statement import Theorem, term, variable
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    differentiate,
    multiply,
    number,
    power,
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


def inequality_proofs(theorem: Theorem) -> Iterator[str]:
    """Proofs to try, the likeliest first."""
    left, right, relation = theorem.left, theorem.right, theorem.relation
    d = left - right if relation in (">", ">=", "!=") else right - left
    strict = relation in (">", "<", "!=")
    given = with_domain(Given(theorem.given), left, right)
    for difference in (d, -d) if relation == "!=" else (d,):
        yield from by_taylor(theorem, difference, strict, given)
        yield by_polynomials(theorem, difference, strict, hints=False)
        yield by_polynomials(theorem, difference, strict, hints=True)
        yield from by_intervals(theorem, given)


def order(strict: bool) -> str:
    """The sign of the relation."""
    return "<" if strict else "<="


def by_polynomials(theorem: Theorem, d: Expr, strict: bool, hints: bool) -> str:
    """The numerator by ``nra``, the denominator by its structure."""
    script = Script(theorem)
    lines = ["intros; saturate; laws."]
    u = unfolded(d)
    top, bottom = quotient(u)
    top = collected(top)
    rel = order(strict)
    lines.append(f"assert (main : 0 {rel} {term(top)}).")
    lines.append("{")
    script.lines = []
    script.prepared([d, *(e for e, _ in theorem.defined)])
    lines += script.lines
    if hints:
        lines.append(squares(sorted(symbols(d)), theorem))
    lines.append("facts; first [positive | lra | nra].")
    lines.append("}")
    lines.append(f"assert (den : 0 < {term(bottom)}) by (first [positive | nra]).")
    lines.append(f"assert (0 {rel} {term(u)}).")
    lines.append(
        f"{{ replace ({term(u)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
        f"{'now apply Rdiv_lt_0_compat' if strict else 'now apply Rdiv_le_0_compat'}. }}"
    )
    lines.append("lra.")
    return "\n".join(lines)


def squares(names: Sequence[str], theorem: Theorem) -> str:
    """Squares that a certificate is often made of."""
    texts = [variable(name) for name in names][:4]
    found = [f"({x} - {y})" for x, y in combinations(texts, 2)] + [f"({x} - 1)" for x in texts]
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
    return polynomial(terms)


def polynomial(terms: Vector) -> Expr:
    """The expression of a polynomial."""
    parts = sorted(((str(sorted(map(str, m))), m, c) for m, c in terms.items()), key=lambda p: p[0])
    return add(*(monomial(m, c) for _, m, c in parts)) if parts else ZERO


def monomial(m: Monomial, c: Fraction) -> Expr:
    """One term."""
    factors = [power(part, number(n)) for part, n in sorted(m, key=str)]
    return multiply(number(c), *factors)


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


def by_taylor(theorem: Theorem, d: Expr, strict: bool, given: Given) -> Iterator[str]:
    """By the signs of the terms below some order about a point, and of the derivative of it."""
    for name in sorted(symbols(d)):
        where = given.box.get(name, Range())
        bases = [number(c) for c in (where.low, where.high) if c is not None and c.q < 2**64]
        bases += [ZERO, ONE, *map(symbol, sorted(symbols(d) - {name}))]
        bases += solutions(differentiate(d, name), name)
        for c in list(dict.fromkeys(bases))[:MAX_BASES]:
            proof = _about(theorem, d, strict, given, name, c)
            if proof is not None:
                yield proof


def _about(theorem: Theorem, d: Expr, strict: bool, given: Given, name: str, c: Expr) -> str | None:
    """The proof about ``name = c``, where the signs are as it needs them."""
    beside = sign(symbol(name) - c, given)
    sides = [1] * (beside not in ("-", "<=0")) + [-1] * (beside not in ("+", ">=0"))
    chain = [d]
    for k in range(1, MAX_ORDER + 1):
        at = sign(substitute(chain[-1], {name: c}), given)
        if at is None or (at in ("-", "<=0") and k == 1):
            return None
        chain.append(differentiate(chain[-1], name))
        if chain[-1].size > MAX_SIZE:
            return None
        last = sign(chain[-1], given)
        if last is None:
            continue
        if all(
            last in (("+", ">=0", "0") if side > 0 or k % 2 == 0 else ("-", "<=0", "0"))
            for side in sides
        ):
            return _chain(theorem, chain, strict, name, c, sides)
    return None


def _chain(
    theorem: Theorem, chain: list[Expr], strict: bool, name: str, c: Expr, sides: list[int]
) -> str:
    x, base, n = variable(name), term(c, 3), len(chain) - 1
    lines = ["intros; saturate."]
    functions = [f"(fun {x} : R => {term(f)})" for f in chain]
    for k, f in enumerate(functions):
        lines.append(f"pose (f{k} := {f}).")
    whole = []
    for side in sides:
        here = f"{base} <= t <= {x}" if side > 0 else f"{x} <= t <= {base}"
        block = [
            f"assert (way : {base} {'<=' if side > 0 else '>='} {x}) by (first [assumption | lra])."
        ]
        for k in range(n, -1, -1):
            up = side > 0 or k % 2 == 0
            says = "0 <= " + f"f{k} t" if up else f"f{k} t <= 0"
            block.append(f"assert (s{k} : forall t, {here} -> {says}).")
            if k == n:
                block.append(f"{{ intros t ?; unfold f{k}; saturate; top. }}")
                continue
            lemma = ("from_left" if side > 0 else "from_right") + ("_ge" if up else "_le")
            block.append(
                f"{{ intros t ?; apply ({lemma} f{k} f{k + 1} {base} t); "
                f"[lra | | | unfold f{k}; base_value]; intros s ?; "
                f"[unfold f{k}, f{k + 1}; eapply d_eq; [derive; hard | tidy; slope] "
                f"| apply s{k + 1}; lra]. }}"
            )
        block.append(f"specialize (s0 {x} ltac:(lra)); unfold f0 in s0; lra.")
        whole.append("\n".join(block))
    if len(sides) == 2:
        lines.append(f"destruct (Rle_or_lt {base} {x}).")
        lines.append("{ " + whole[0] + " }")
        lines.append("{ " + whole[1] + " }")
    else:
        lines.append(whole[0])
    return "\n".join(lines)
