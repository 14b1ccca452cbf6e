"""Reduce an inequality to others that imply it, with the Coq text that completes the proof.

The sign prover uses the same reductions; it is asked first whether the reduced inequality holds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from tresym.coq.equations import exchanged, nodes, primes, quotient, unfolded
from tresym.coq.statement import Theorem, term
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import with_domain
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    multiply,
    number,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import numerator
from tresym.reals.signs.sign import directly, sign


@dataclass(frozen=True)
class Reduction:
    """Inequalities that remain to be shown, named ``step_n``, and how they imply the claim.

    Attributes:
        steps: theorems under the available premises.
        after: sentences that complete the proof.
        before: sentences that precede it.
        only: for each step an additional condition, or None.
    """

    steps: tuple[Theorem, ...]
    after: str
    before: str = ""
    only: tuple[str, ...] = ()


def known(theorem: Theorem) -> Given:
    """Return the premises with the definitions they determine."""
    given = Given(tuple(c for c in theorem.given if c[1] != "=="))
    return with_domain(given, theorem.left, theorem.right)


def stated(theorem: Theorem, left: Expr, relation: str, right: Expr) -> Theorem:
    """Return a theorem with the same premises and another conclusion."""
    return replace(theorem, says=Relation(left, relation, right))


def is_likely(theorem: Theorem) -> bool:
    """Return whether the sign prover proves the theorem."""
    up = theorem.relation in (">", ">=")
    d = theorem.left - theorem.right if up else theorem.right - theorem.left
    relation = ">" if theorem.relation in (">", "<") else ">="
    return directly(d, relation, known(theorem)) is not None


def reductions(theorem: Theorem) -> Iterator[Reduction]:
    """Yield ways to reduce an inequality, the most likely first."""
    if theorem.relation in (">", ">="):
        small, great = theorem.right, theorem.left
    else:
        small, great = theorem.left, theorem.right
    relation = "<" if theorem.relation in ("<", ">") else "<="
    t = stated(theorem, small, relation, great)
    found = [*by_two_sides(t), *by_absolute_values(t)]
    yield from found
    if found:
        return
    for ways in (by_turns, by_logarithms, by_clearing, by_cut):
        for way in ways(t):
            if all(map(is_likely, way.steps)):
                yield way


def by_two_sides(t: Theorem) -> Iterator[Reduction]:
    """Bound an absolute value alone on its side from both sides: -v <= u <= v."""
    if t.left.op != "abs":
        return
    (u,) = t.left.args
    v, law = t.right, "Rabs_le; split" if t.relation == "<=" else "Rabs_def1"
    yield Reduction(
        (stated(t, multiply(number(-1), v), t.relation, u), stated(t, u, t.relation, v)),
        f"assert (sides : {term(t.left)} {t.relation} {term(v)}) by (apply {law}; lra). lra.",
    )


def by_absolute_values(t: Theorem) -> Iterator[Reduction]:
    """Split by the sign of the argument of an absolute value."""
    for e in sorted({e for e in nodes([t.left, t.right]) if e.op == "abs"}, key=lambda e: e.size):
        u = e.args[0]
        if "abs" in {part.op for part in nodes([u])}:
            continue
        cases = []
        for relation, value in ((">=", u), ("<=", multiply(number(-1), u))):
            put = {e: value}
            case = stated(t, exchanged(t.left, put), t.relation, exchanged(t.right, put))
            cases.append(replace(case, given=(*t.given, (u, relation, ZERO))))
        text = term(u)
        yield Reduction(
            tuple(cases),
            f"destruct (Rle_or_lt 0 ({text})); "
            f"[rewrite (Rabs_pos_eq ({text})) in * by lra; specialize (step_1 ltac:(lra)) "
            f"| rewrite (Rabs_left ({text})) in * by lra; specialize (step_2 ltac:(lra))]; "
            "first [lra | nra].",
            only=(f"{text} >= 0", f"{text} <= 0"),
        )
        return


def by_turns(t: Theorem) -> Iterator[Reduction]:
    """Substitute sin or cos of a new variable for the argument of an arcsine or arccosine."""
    found = [e for e in nodes([t.left, t.right]) if e.op in ("asin", "acos")]
    if len(found) != 1 or found[0].args[0].op != "symbol":
        return
    (e,) = found
    x, turn = e.args[0], symbol("turn")
    above = sign(x, known(t)) in ("+", ">=0")
    low = ZERO if above or e.op == "acos" else -PI / 2
    high = PI if e.op == "acos" and not above else PI / 2
    value = apply("sin" if e.op == "asin" else "cos", turn)
    put = {e: turn, x: value}
    own = {x.args[0]}
    given = [c for c in t.given if own != symbols(c[0]) | symbols(c[2])]
    step = Theorem(
        t.name,
        tuple(sorted({*t.variables, "turn"} - own)),
        (),
        (
            *((exchanged(p, put), r, exchanged(q, put)) for p, r, q in given),
            (turn, ">=", low),
            (turn, "<=", high),
        ),
        tuple((exchanged(p, put), r) for p, r in t.defined if symbols(p) != own),
        Relation(exchanged(t.left, put), t.relation, exchanged(t.right, put)),
    )
    law = f"some_{e.op}{'_above' if above else ''}"
    name = term(turn)
    yield Reduction(
        (step,),
        "lra.",
        f"destruct ({law} {term(x)} ltac:(lra) ltac:(lra)) as [{name} [B_turn E_turn]]; "
        f"assert (A_turn : {e.op} {term(x)} = {name}) by "
        f"(rewrite E_turn; apply {e.op}_{value.op}; lra); "
        f"rewrite A_turn in *; clear A_turn; subst {term(x)}; pose proof pi_between.",
    )


def log_of(e: Expr) -> Expr:
    """Return the logarithm of a product of positive factors as a sum."""
    if e.op == "*":
        return add(*map(log_of, e.args))
    if e.op == "exp":
        return e.args[0]
    if e.op == "^":
        return e.args[1] * log_of(e.args[0])
    if e.op == "number":
        p, q = e.args[0].p, e.args[0].q
        parts = [(prime, n) for prime, n in primes(int(p))] + [(b, -n) for b, n in primes(int(q))]
        return add(*(number(n) * apply("log", number(prime)) for prime, n in parts))
    return apply("log", e)


def of_numbers(e: Expr) -> str:
    """Return sentences that write logarithms of numbers in terms of logarithms of primes."""
    lines = []
    for part in dict.fromkeys(nodes([e])) | {e: None}:
        for f in part.args if part.op in ("*", "^") else (part,):
            if (
                f.op != "number"
                or f.args[0] <= 0
                or f == ONE
                or max(f.args[0].p, f.args[0].q) > 10**6
            ):
                continue
            text, value = term(f), term(log_of(f))
            product = " * ".join(
                [f"{b} ^ {n}" for b, n in primes(int(f.args[0].p))]
                + [f"/ {b} ^ {n}" for b, n in primes(int(f.args[0].q))]
            )
            if not product.removesuffix(" ^ 1").isdigit():
                lines.append(
                    f"assert (ln ({text}) = {value}) by "
                    f"(replace ({text}) with ({product}) by field; log_parts; ring)."
                )
    return " ".join(dict.fromkeys(lines))


def by_logarithms(t: Theorem) -> Iterator[Reduction]:
    """Take logarithms of both sides, if one is an exponential and both are positive."""
    given = known(t)
    d = t.left - t.right
    terms = d.args if d.op == "+" else (d,)
    for n, part in enumerate(terms):
        if not any(
            f.op == "exp" or (f.op == "^" and f.args[1].op != "number") for f in factors_in(part)
        ):
            continue
        others = (*terms[:n], *terms[n + 1 :])
        negative = factors_in(part)[0].op == "number" and bool(factors_in(part)[0].args[0] < 0)
        small = add(*others) if negative else part
        great = -part if negative else add(*(-other for other in others))
        if sign(small, given) != "+" or sign(great, given) != "+":
            continue
        step = stated(t, log_of(small), t.relation, log_of(great))
        law = "from_ln_le" if t.relation == "<=" else "from_ln_lt"
        yield Reduction(
            (step,),
            f"{of_numbers(small)} {of_numbers(great)} "
            f"assert (way : {term(small)} {t.relation} {term(great)}). "
            f"{{ unfold Rpower in *; apply {law}; "
            "[first [positive | nra] | first [positive | nra] |]; "
            "log_parts; first [lra | nra]. } first [lra | unfold Rpower in *; lra].",
        )


def by_clearing(t: Theorem) -> Iterator[Reduction]:
    """Multiply by a positive denominator."""
    d = t.right - t.left
    for e in dict.fromkeys((d, unfolded(d))):
        top, bottom = quotient(e)
        if bottom.op == "number":
            continue
        step = stated(t, ZERO, t.relation, top)
        law = "from_quotient" if t.relation == "<=" else "Rdiv_lt_0_compat"
        yield Reduction(
            (step,),
            f"assert (den : 0 < {term(bottom)}) by "
            "(first [positive | facts; first [positive | nra]]). "
            f"assert (0 {t.relation} {term(e)}). "
            f"{{ replace ({term(e)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
            f"now apply {law}. }} lra.",
            "" if e == d else "laws.",
        )


def by_cut(t: Theorem) -> Iterator[Reduction]:
    """Cut the range of the only variable at a rational zero of the slope, or at 2."""
    d, cut = t.right - t.left, " (cut)"
    if t.name.endswith(cut) or len(symbols(d)) != 1:
        return
    (name,), given = symbols(d), known(t)
    slope, x = differentiate(d, name), symbol(name)
    zeros = (*solutions(slope, name), *solutions(numerator(slope, given), name))
    for c in dict.fromkeys((*zeros, number(2))):
        parts = [(x, "<=", c), (x, ">=", c)]
        if c.op != "number" or sign(x - c, given) is not None:
            continue
        text, done = f"Rle_or_lt {term(x, 3)} {term(c, 3)}", "ltac:(lra)); lra"
        yield Reduction(
            tuple(replace(t, name=t.name + cut, given=(*t.given, part)) for part in parts),
            f"destruct ({text}); [specialize (step_1 {done} | specialize (step_2 {done}].",
            only=(f"{term(x)} <= {term(c)}", f"{term(x)} >= {term(c)}"),
        )
