"""Prove inequalities in Coq: by polynomials, Taylor's theorem about a point, or intervals."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, islice, product
from math import lcm

from tresym.coq.equations import (
    LEAVES,
    Script,
    as_root,
    exchanged,
    is_root,
    nodes,
    quotient,
    unfolded,
)
from tresym.coq.linear_dependence import as_expression, expanded
from tresym.coq.polynomial_certificates import Span, cone_lines
from tresym.coq.reductions import Reduction, known, reductions
from tresym.coq.statement import Theorem, formula, term, variable
from tresym.coq.sums_of_squares import square_proofs
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.sample_points import Range
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    factors_in,
    multiply,
    number,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import numerator
from tresym.reals.signs.interior import sign_inside
from tresym.reals.signs.sign import directly, sign
from tresym.reals.signs.taylor import opened

MAX_ORDER = 5
MAX_SIZE = 300
MAX_BASES = 6
MAX_EXPANSIONS = 2
QUICK = "intros; saturate; absolute; facts; first [lra | nra]."
POINT = symbol("point")
UP, DOWN = ("+", ">=0", "0"), ("-", "<=0", "0")


def inequality_proofs(theorem: Theorem, depth: int = 3) -> Iterator[str]:
    """Yield proofs to try: as the sign prover argues, by reductions, by Coq's automation."""
    left, right, relation = theorem.left, theorem.right, theorem.relation
    d = left - right if relation in (">", ">=", "!=") else right - left
    strict = relation in (">", "<", "!=")
    given = known(theorem)
    for difference in (d, -d) if relation == "!=" else (d,):
        if depth > 1:
            yield from square_proofs(theorem, difference, strict)
        yield from expected(theorem, difference, strict, given)
    if relation != "!=" and depth:
        for way in reductions(theorem):
            yield from _reduced(way, depth - 1)
    for difference in (d, -d) if relation == "!=" else (d,):
        yield from by_taylor(theorem, difference, given)
        yield from (by_polynomials(theorem, difference, strict, hints) for hints in (False, True))
        yield from by_intervals(theorem, given)


def expected(theorem: Theorem, d: Expr, strict: bool, given: Given) -> Iterator[str]:
    """Yield the proofs that correspond to the methods of the sign prover."""
    reason = directly(d, ">" if strict else ">=", given)
    if reason is None or any(e.op == "abs" for e in nodes([d])):
        yield QUICK
        if reason is None:
            yield from by_intervals(theorem, given)
    elif "concave" in reason:
        yield from by_concavity(theorem, d, given)
    elif "about" in reason:
        yield from by_taylor(theorem, d, given)
    else:
        if len({e.args[0] for e in nodes([d]) if e.op in ("sin", "cos")}) > 1:
            yield by_polynomials(theorem, d, strict, hints=False)
        yield QUICK
        if not strict:
            yield from cone_proofs(theorem, d)
        if d.size < MAX_SIZE:
            yield by_polynomials(theorem, d, strict, hints=False)
            yield by_polynomials(theorem, d, strict, hints=True)


def _reduced(way: Reduction, depth: int) -> Iterator[str]:
    """Combine a reduction with proofs of the inequalities that remain."""
    most = 5 if len(way.steps) == 1 else 3
    found = [list(islice(inequality_proofs(step, depth), most)) for step in way.steps]
    for proofs in product(*found):
        lines = ["intros; saturate.", way.before] if way.before else ["intros; saturate."]
        for n, (step, proof) in enumerate(zip(way.steps, proofs, strict=True), 1):
            only = f"{way.only[n - 1]} -> " if way.only else ""
            lines.append(f"assert (step{depth}_{n} : {only}{formula(step.says)}).\n{{ {proof} }}")
        yield "\n".join([*lines, way.after.replace("step_", f"step{depth}_")])


def order(strict: bool) -> str:
    """Return the sign of the relation."""
    return "<" if strict else "<="


def by_polynomials(theorem: Theorem, d: Expr, strict: bool, hints: bool) -> str:
    """Yield proofs by ``nra`` for the numerator and by structure for the denominator."""
    return "\n".join(["intros; saturate; laws.", *shown(theorem, d, strict, hints), "lra."])


def shown(theorem: Theorem, d: Expr, strict: bool, hints: bool, expand: bool = True) -> list[str]:
    """Return sentences after which ``0 <= d`` or ``0 < d`` is a premise."""
    u = unfolded(d)
    top, bottom = quotient(u)
    rel = order(strict)
    script = Script(theorem, splits=False)
    top = script.in_factors(collected(top)) if expand else top
    script.lines = []
    script.prepared([d, *(e for e, _ in theorem.defined)])
    lines = ["facts.", f"assert (main : 0 {rel} {term(top)}).", "{", "facts.", *script.lines]
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
    lines.append(
        f"assert (den : 0 < {term(bottom)}) by (first [positive | facts; first [positive | nra]])."
    )
    lines.append(f"assert (0 {rel} {term(u)}).")
    lines.append(
        f"{{ replace ({term(u)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
        f"{'now apply Rdiv_lt_0_compat' if strict else 'now apply Rdiv_le_0_compat'}. }}"
    )
    return lines


def cone_proofs(theorem: Theorem, d: Expr) -> Iterator[str]:
    """Yield proofs by a tree of comparisons (`polynomial_certificates`), with roots replaced."""
    lines = ["intros; saturate."]
    roots = [e for e in nodes([d]) if is_root(e)]
    put: dict[Expr, Expr] = {}
    degrees: dict[Expr, int] = {}
    for e in roots:
        u, q, _ = as_root(e)
        factors = factors_in(u)
        if all(f.op == "symbol" or _is_power(f) for f in factors):
            for f in factors:
                x = f if f.op == "symbol" else f.args[0]
                degrees[x] = lcm(degrees.get(x, 1), q)
    premises = known(theorem)
    for x, q in sorted(degrees.items(), key=str):
        found = sign(x, premises)
        if found not in ("+", ">=0"):
            return
        new = symbol(f"root{x.args[0]}")
        law = "some_root_lt" if found == "+" else "some_root"
        put[x] = Expr("^", (new, number(q)))
        lines.append(
            f"destruct ({law} {q} {term(x)} ltac:(lia) ltac:(lra)) as "
            f"[{term(new)} [pos_{term(new)} eq_{term(new)}]]; subst {term(x)}."
        )
    values: dict[Expr, Expr] = {}
    for e in roots:
        u, q, odd = as_root(e)
        if u.op != "symbol" and not all(f.op == "symbol" or _is_power(f) for f in factors_in(u)):
            continue
        shape = (
            Expr("cbrt", (exchanged(u, put),))
            if odd
            else Expr("^", (exchanged(u, put), number(Fraction(1, q))))
        )
        value = _root_value(u, q, put)
        if value is None:
            return
        law = "sqrt_unique" if q == 2 else "root_unique_le"
        lines.append(
            f"rewrite ({law} {'' if q == 2 else q} {term(exchanged(u, put), 3)} {term(value, 3)} "
            f"{'' if q == 2 else 'ltac:(lia) '}ltac:(positive) ltac:(ring)) in *."
        )
        values[shape] = value
    e = exchanged(unfolded(exchanged(d, put)), values)
    e = _roots_out(e, values)
    top, bottom = quotient(e)
    lines.append("laws.")
    spans: dict[Expr, Span] = {}
    names: dict[Expr, Expr] = {}
    try:
        parts = sorted(
            {part for m in expanded(top) for part, _ in m}, key=lambda p: (-p.size, str(p))
        )
    except OverflowError:
        return
    for part in parts:
        low, high = _span(part, premises, put)
        if part.op != "symbol":
            name = symbol(f"part{len(names)}")
            fact = FACTS.get("sqrt" if is_root(part) else part.op)
            if fact is None:
                return
            lines.append(f"pose proof ({fact.format(term(part.args[0], 3))}).")
            lines.append(f"set ({term(name)} := {term(part)}) in *; clearbody {term(name)}.")
            names[part] = name
            part = name
        spans[part] = Span(low, high)
    top, bottom, e = (exchanged(x, names) for x in (top, bottom, e))
    total = _total(theorem, put)
    tree = cone_lines(top, spans, total) or (cone_lines(top, spans) if total else None)
    if tree is None:
        return
    lines += [f"assert (main : 0 <= {term(top)}).", "{", *tree, "}"]
    if bottom == ONE:
        yield "\n".join([*lines, "first [lra | nra]."])
        return
    lines += [
        f"assert (den : 0 < {term(bottom)}) by (first [positive | facts; first [positive | nra]]).",
        f"assert (0 <= {term(e)}).",
        f"{{ replace ({term(e)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
        "now apply from_quotient. }",
        "lra.",
    ]
    yield "\n".join(lines)


FACTS = {
    "exp": "exp_pos {}",
    "sin": "SIN_bound {}",
    "cos": "COS_bound {}",
    "sqrt": "sqrt_pos {}",
    "abs": "Rabs_pos {}",
}


def _is_power(e: Expr) -> bool:
    """Return whether the expression is an integer power of a symbol."""
    whole = e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1
    return whole and e.args[0].op == "symbol" and bool(e.args[1].args[0] > 0)


def _root_value(u: Expr, q: int, put: Mapping[Expr, Expr]) -> Expr | None:
    """Return the root of a product of powers of the substituted symbols."""
    factors = []
    for f in factors_in(u):
        x, n = (f, 1) if f.op == "symbol" else (f.args[0], int(f.args[1].args[0].p))
        new, degree = put[x].args[0], int(put[x].args[1].args[0].p)
        if degree * n % q:
            return None
        factors.append(power(new, number(degree * n // q)))
    return multiply(*factors)


def _roots_out(e: Expr, values: Mapping[Expr, Expr]) -> Expr:
    """Replace powers of roots by powers of their values."""
    if e.op in LEAVES:
        return e
    if is_root(e) and e.op == "^":
        p, q = int(e.args[1].args[0].p), int(e.args[1].args[0].q)
        value = values.get(Expr("^", (e.args[0], number(Fraction(1, q)))))
        if value is not None:
            return Expr("^", (value, number(p))) if p != 1 else value
    return Expr(e.op, tuple(_roots_out(arg, values) for arg in e.args))


def _span(
    part: Expr, known: Given, put: Mapping[Expr, Expr]
) -> tuple[Fraction | None, Fraction | None]:
    """Return numbers between which a part lies."""
    if part.op == "exp" or part.op == "abs" or is_root(part):
        return Fraction(0), None
    if part.op in ("sin", "cos"):
        return Fraction(-1), Fraction(1)
    if any(part == value.args[0] for value in put.values()):
        return Fraction(0), None
    where = known.box.get(part.args[0] if part.op == "symbol" else "", Range())
    ends = [
        None if c is None or c.q > 2**40 else Fraction(int(c.p), int(c.q))
        for c in (where.low, where.high)
    ]
    if ends[0] is None and sign(part, known) in ("+", ">=0"):
        ends[0] = Fraction(0)
    return ends[0], ends[1]


def _total(theorem: Theorem, put: Mapping[Expr, Expr]) -> Expr | None:
    """Return 1 − x − y − z for a condition 1 >= x + y + z."""
    if put:
        return None
    for x, relation, y in theorem.given:
        e = y - x if relation in ("<", "<=") else x - y
        if relation in ("<", "<=", ">", ">=") and len(symbols(e)) > 1:
            try:
                terms = expanded(e)
            except OverflowError:
                continue
            linear = all(sum(n for _, n in m) <= 1 for m in terms)
            c = terms.get(frozenset(), Fraction(0))
            if linear and c > 0 and all(v < 0 for m, v in terms.items() if m):
                return e / number(c)
    return None


def by_concavity(theorem: Theorem, d: Expr, given: Given) -> Iterator[str]:
    """Yield proofs that a function is concave between two ends at which it is not negative."""
    names = symbols(d)
    if len(names) != 1:
        return
    (name,) = names
    ends: list[Expr | None] = [None, None]
    for left, relation, right in theorem.given:
        if right == symbol(name):
            left, relation, right = (
                right,
                {"<": ">", "<=": ">=", ">": "<", ">=": "<="}.get(relation, relation),
                left,
            )
        if left == symbol(name) and not symbols(right):
            if relation in (">", ">="):
                ends[0] = right
            elif relation in ("<", "<="):
                ends[1] = right
    low, high = ends
    if low is None or high is None:
        return
    x, chain = variable(name), [d, differentiate(d, name)]
    chain.append(differentiate(chain[1], name))
    a, b = term(low, 3), term(high, 3)
    for mode in range(2):
        lines = ["intros; saturate; pose proof pi_between."]
        lines += [f"pose (fun_{k} := (fun {x} : R => {term(f)}))." for k, f in enumerate(chain)]
        between = ((POINT, ">=", low), (POINT, "<=", high))
        last = last_step(theorem, chain[2], name, False, mode, between)
        lines += [
            f"assert (sig_0 : 0 <= fun_0 {x}).",
            f"{{ apply (concave fun_0 fun_1 fun_2 {a} {b} {x}); "
            "[lra | | | | unfold fun_0; base_value | unfold fun_0; base_value].",
            "{ intros v_next ?; unfold fun_0, fun_1; eapply d_eq; [derive; hard | tidy; slope]. }",
            "{ intros v_next ?; unfold fun_1, fun_2; eapply d_eq; [derive; hard | tidy; slope]. }",
            f"intros v_point ?; unfold fun_2; saturate. {last} }}",
            "unfold fun_0 in sig_0; lra.",
        ]
        yield "\n".join(lines)


def squares(texts: Sequence[str], theorem: Theorem) -> str:
    """Return squares that often occur in certificates."""
    texts = texts[:4]
    found = [f"({x} - {y})" for x, y in combinations(texts, 2)]
    found += [f"({x} + {y})" for x, y in combinations(texts, 2)][:2]
    found += [f"({x} ^ 2 - {y} ^ 2)" for x, y in combinations(texts, 2)][:2]
    found += [f"({x} - {c})" for x in texts[:2] for c in ("1", "1 / 2")]
    if len(texts) == 4:
        a, b, c, d = texts
        pairs = [((a, b), (c, d)), ((a, c), (b, d)), ((a, d), (b, c))]
        found += [f"({p} * {q} {sign_} {r} * {s})" for (p, q), (r, s) in pairs for sign_ in "-+"]
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
    """Expand the polynomial, if it is small."""
    try:
        terms = expanded(e)
    except OverflowError:
        return e
    return as_expression(terms)


def by_intervals(theorem: Theorem, given: Given) -> Iterator[str]:
    """Yield proofs by interval arithmetic with bisection."""
    names = theorem.variables
    box = given.box
    bounded = all(
        (r := box.get(name, Range())).low is not None and r.high is not None for name in names
    )
    if bounded:
        bisect = [f"i_bisect {variable(name)}" for name in names]
        taylor = [f"i_taylor {variable(name)}" for name in names[:1]]
        for options in (bisect, [*taylor, *bisect]) if names else ([],):
            asked = f" with ({', '.join([*options, 'i_depth 20'])})" if options else ""
            yield f"intros; first [interval{asked} | spell; interval{asked}]."
    elif not names:
        yield "intros. interval with (i_prec 100)."


def by_taylor(theorem: Theorem, d: Expr, given: Given) -> Iterator[str]:
    """Yield proofs by Taylor's theorem: signs of the low-order terms and of the last derivative."""
    count = 0
    for name in sorted(symbols(d)):
        where = given.box.get(name, Range())
        bases = [number(c) for c in (where.low, where.high) if c is not None and c.q < 2**64]
        bases += [ZERO, ONE, *map(symbol, sorted(symbols(d) - {name}))]
        slope = differentiate(d, name)
        bases += solutions(slope, name) or solutions(numerator(slope, given), name)
        for c in list(dict.fromkeys(map(_by_e, bases)))[:MAX_BASES]:
            found = _about(theorem, d, given, name, c)
            yield from found
            count += bool(found)
            if count == MAX_EXPANSIONS:
                return


def _by_e(c: Expr) -> Expr:
    """Write a point exp(r) as a power of e."""
    if c.op == "exp" and c.args[0].op == "number" and c.args[0].args[0].q == 1:
        return power(Expr("exp", (ONE,)), c.args[0])
    return c


def _about(theorem: Theorem, d: Expr, given: Given, name: str, c: Expr) -> list[str]:
    """Yield the proofs about ``name = c`` whose signs are suitable."""
    beside = sign_inside(symbol(name) - c, given)
    inside = opened(Given(tuple(c for c in given.comparisons if c[1] != "!=")), name)
    sides = [1] * (beside not in ("-", "<=0")) + [-1] * (beside not in ("+", ">=0"))
    strict, apart = theorem.relation not in ("<=", ">="), beside in ("+", "-")
    chain, start, weak = [d], None, list[str]()
    for k in range(MAX_ORDER + 1):
        fit = [UP if side > 0 or k % 2 == 0 else DOWN for side in sides]
        last = sign_inside(chain[k], inside)
        if k and all(last in signs for signs in fit):
            if strict and start is None:
                start = k if apart and all(last == signs[0] for signs in fit) else -1
            first = start if strict and start is not None else -1
            found = [_chain(theorem, chain, mode, name, c, sides, first) for mode in range(4)]
            if first >= 0 or not (strict and apart):
                return found
            start, weak = None, weak or found  # a higher derivative may show that it is strict
        at = sign_inside(substitute(chain[k], {name: c}), inside)
        if not all(at in signs for signs in fit):
            return weak
        if start is None and (apart or not k) and all(at == signs[0] for signs in fit):
            start = k
        chain.append(differentiate(chain[k], name))
        if chain[-1].size > MAX_SIZE:
            return weak
    return weak


def last_step(
    theorem: Theorem,
    e: Expr,
    name: str,
    up: bool,
    mode: int,
    between: tuple[tuple[Expr, str, Expr], ...],
    strict: bool = False,
) -> str:
    """Return the sign of the last derivative at another point."""
    if mode == 0:
        sine = f"pose proof pi_between; apply sin_g{'t' if strict else 'e'}_0; lra"
        return f"facts; first [positive | lra | nra{' | beside' * strict} | {sine}]."
    theorem = replace(theorem, given=(*theorem.given, *between))
    moved = substitute(e if up else -e, {name: POINT})
    if mode == 3:
        t = replace(theorem, says=Relation(ZERO, order(strict), moved))
        proof = next(cone_proofs(t, moved), None) or next(
            (p for way in reductions(t) for p in _reduced(way, 0)), "fail."
        )
        goal = f"assert (last : 0 {order(strict)} {term(moved)})."
        return f"{goal} {{ {proof} }} lra."
    return " ".join(["laws.", *shown(theorem, moved, strict, mode == 2), "lra."])


def _chain(
    theorem: Theorem,
    chain: list[Expr],
    mode: int,
    name: str,
    c: Expr,
    sides: list[int],
    start: int = -1,
) -> str:
    """Integrate signs from the last derivative down; they are strict, except at the point."""
    x, base, n = variable(name), term(c, 3), len(chain) - 1
    lines = ["intros; saturate."]
    if sign(c, Given()) == "+":
        lines.append(f"assert (0 < {base}) by (first [positive | interval]).")
    functions = [f"(fun {x} : R => {term(f)})" for f in chain]
    for k, f in enumerate(functions):
        lines.append(f"pose (fun_{k} := {f}).")
    whole = []
    for side in sides:
        way = order(start > 0)
        ends = f"{base} {way} {x}" if side > 0 else f"{x} {way} {base}"
        block = [f"assert (way : {ends}) by (first [assumption | lra])."]
        for k in range(n, -1, -1):
            up, rel = side > 0 or k % 2 == 0, order(k <= start)
            open_ = order(k < start or k == start == n)
            here = (
                f"{base} {open_} v_point <= {x}" if side > 0 else f"{x} <= v_point {open_} {base}"
            )
            says = f"0 {rel} fun_{k} v_point" if up else f"fun_{k} v_point {rel} 0"
            block.append(f"assert (sig_{k} : forall v_point, {here} -> {says}).")
            if k == n:
                over, under = (c, symbol(name)) if side > 0 else (symbol(name), c)
                signs = (open_.replace("<", ">"), "<=") if side > 0 else (">=", open_)
                between = ((POINT, signs[0], over), (POINT, signs[1], under))
                proof = last_step(theorem, chain[n], name, up, mode, between, k <= start)
                block.append(f"{{ intros v_point ?; unfold fun_{k}; saturate. {proof} }}")
                continue
            lemma = "from_left" if side > 0 else "from_right"
            lemma += "_start" if k == start else ""
            lemma += ("_gt" if up else "_lt") if k <= start else "_ge" if up else "_le"
            block.append(
                f"{{ intros v_point ?; apply ({lemma} fun_{k} fun_{k + 1} {base} v_point); "
                f"[lra | | | unfold fun_{k}; first [base_value | base_powers]]; intros v_next ?; "
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
