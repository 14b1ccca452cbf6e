"""State and prove in Coq that an order holds with a constant on a region.

`sin(x) == x + O(x^3)` with the constant 0.168 on 0 < |x| <= 1 is |sin(x) - x| <= 0.168 |x^3| there.
On each side of the end, with t > 0 the distance from it, the function has a power tᵏ taken out so
that its first derivatives vanish at 0; where the next one is small the inequality follows by
Taylor's theorem, and on the rest of the region by interval arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from math import factorial

from flint import arb, fmpq

from tresym.checking.asked_for import reach_on
from tresym.coq.bound_statements import AND, Bounded, BoundTheorem, naturally, whole_filter
from tresym.coq.claim_export import theorem as plain_theorem
from tresym.coq.claim_export import theorems
from tresym.coq.expansion_proofs import BY_DEFINITION, T, placed
from tresym.coq.order_proofs import End, ends
from tresym.coq.statement import (
    ATOM,
    NotExportedError,
    Theorem,
    comparison,
    condition,
    term,
    variable,
)
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.path_regions import conditions_of
from tresym.reals.decisions.statement import Statement, implied_integers
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    HALF,
    LEAVES,
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    multiply,
    number,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal, InputError, parse_number
from tresym.reals.signs.sign import sign

MOST_ORDER, MOST_SHIFT, PARTS = 9, 4, 64
"""The highest derivative, the highest power of t that is taken out, and points that are tried."""
Prove = Callable[[Theorem], "str | None"]


def constant_theorem(statement: Statement, answer: Answer, name: str = "claim") -> BoundTheorem:
    """Return the theorem that an order holds with the constant of its answer, on its region.

    The constant is rounded up to three digits.

    Raises:
        NotExportedError: the answer has no constant, or not one on a region about the end.
    """
    path, comparisons = statement.path, statement.comparisons
    if path is None or len(comparisons) != 1 or comparisons[0].relation != "O":
        raise NotExportedError("only an order O has a constant that is exported to Coq yet")
    if answer.constant is None or answer.region is None:
        raise NotExportedError("the answer has no constant on a region")
    if path.together or path.expression is not None or statement.equations:
        raise NotExportedError("a constant along several variables cannot be exported to Coq yet")
    try:
        reach = reach_on(answer.region, path)
        others = [c for c in conditions_of(answer.region) if path.name not in _names(c)]
    except InputError:
        raise NotExportedError("the region of the constant is not exported to Coq yet") from None
    if path.region or (reach is None and path.reach is not None):
        raise NotExportedError("the constant on this region is not exported to Coq yet")
    claim = comparisons[0]
    x, sides = path.name, (claim.left, claim.right)
    given = (
        *statement.given.comparisons,
        *(c for c in others if c not in statement.given.comparisons),
    )
    if others and any(c not in statement.given.comparisons for c in others):
        raise NotExportedError("a region of parameters is not exported to Coq yet")
    parameters = (symbols(claim.left) | symbols(claim.right)) - {x}
    if parameters and not answer.uniform:
        raise NotExportedError("the constant is not one for all values of the parameters")
    if any(x in _names(c) for c in given):
        raise NotExportedError("conditions on the variable of the path cannot be exported to Coq")
    whole = {
        e
        for e in implied_integers(sides, statement.integers)
        if e in symbols(claim.left) | symbols(claim.right)
    }
    if whole - {x}:
        raise NotExportedError("orders with integers as parameters cannot be exported to Coq yet")
    whole_filter(path, whole)
    if reach is None and whole:
        reach = fmpq(1)  # of natural numbers n > 0 is n >= 1
    shown = [naturally(e, whole) for e in sides]
    parts = [condition(*p) for p in needs(shown) if x in symbols(p[0])]
    others_ = [condition(*p) for p in needs(sides) if symbols(p[0]) and x not in symbols(p[0])]
    constant = rounded_up(answer.constant)
    inequality = f"Rabs ({term(shown[0])}) <= {term(constant, ATOM)} * Rabs ({term(shown[1])})"
    premises = [comparison(*c) for c in given] + others_ + region_of(path, reach, bool(whole))
    used = (symbols(claim.left) | symbols(claim.right)).union(*map(_names, given), {x})
    return BoundTheorem(
        name,
        claim,
        statement,
        tuple(sorted(used - whole)),
        tuple(sorted(whole)),
        tuple(dict.fromkeys(premises)),
        (*([AND.join(parts)] if parts else []), inequality),
        Bounded(constant, reach, answer.region),
    )


def with_constant(
    statement: Statement, answer: Answer, name: str = "claim"
) -> tuple[list[Theorem] | list[BoundTheorem], BoundTheorem | None]:
    """Return the theorems of a claim, and the one with the constant of its answer if there is one.

    Where the claim asks for a region or for one constant, that is its only theorem.

    Raises:
        NotExportedError: this kind of claim cannot be exported yet.
    """
    try:
        constant = constant_theorem(statement, answer, name)
    except NotExportedError:
        return theorems(statement, name), None
    try:
        return theorems(statement, name), replace(constant, name=f"{name}_constant")
    except NotExportedError:
        return [constant], None


def _names(link: tuple[Expr, str, Expr]) -> frozenset[str]:
    return symbols(link[0]) | symbols(link[2])


def rounded_up(ball: Decimal) -> Expr:
    """Return a number of three digits above a ball, by at least a thousandth part of it."""
    above = sum(map(parse_number, ball), fmpq(0)) * fmpq(1001, 1000)
    unit = fmpq(1)
    while above >= 1000 * unit:
        unit *= 10
    while above < 100 * unit and above > 0:
        unit /= 10
    return number(fmpq((above / unit).ceil()) * unit)


def region_of(path: Path, reach: fmpq | None, whole: bool) -> list[str]:
    """Return the region as premises: where |x - a|, or 1/|x|, is at most ``reach``, without a."""
    x = f"INR {variable(path.name)}" if whole else variable(path.name)
    if path.point is None:
        side = path.sides[0]
        if reach is None:
            return [f"0 < {x}" if side > 0 else f"{x} < 0"]
        end = term(number(side / reach))
        return [f"{end} <= {x}" if side > 0 else f"{x} <= {end}"]
    a = term(path.point)
    size = term(number(reach)) if reach is not None else ""
    if len(path.sides) > 1:
        return [
            f"{x} <> {a}",
            *([f"Rabs ({x} - {term(path.point, ATOM)}) <= {size}"] if size else []),
        ]
    if path.sides[0] > 0:
        return [f"{a} < {x}", *([f"{x} <= {term(path.point + number(reach))}"] if size else [])]
    return [*([f"{term(path.point - number(reach))} <= {x}"] if size else []), f"{x} < {a}"]


def constant_proofs(theorem: BoundTheorem, head: str, prove: Prove) -> Iterator[str]:
    """Yield proofs that an order holds with a constant on a region.

    Args:
        theorem: the theorem.
        head: the sentence that introduces its variables and premises.
        prove: a prover of inequalities; None if it finds no proof.
    """
    path, bounded = theorem.statement.path, theorem.bounded
    assert path is not None
    assert bounded is not None
    if not _parameters(theorem) and bounded.reach is not None:
        pairs = zip(ends(path, squared=False), path.sides, strict=True)
        sides = [_side(theorem, end, side, bounded) for end, side in pairs]
        lines = [script for script in sides if script is not None]
        if len(lines) == len(sides):
            yield "\n".join([*lines, head + _together(theorem, path)])
    yield from _by_inequality(theorem, head, prove)


def _parameters(theorem: BoundTheorem) -> frozenset[str]:
    path = theorem.statement.path
    assert path is not None
    return frozenset(theorem.reals) - {path.name}


def _side(theorem: BoundTheorem, end: End, side: int, bounded: Bounded) -> str | None:
    """Return the proof on one side, as a statement about all t > 0 up to the reach."""
    path = theorem.statement.path
    assert path is not None
    assert bounded.reach is not None
    f, g = (placed(e, path.name, end.at) for e in (theorem.claim.left, theorem.claim.right))
    walk = Simplified(path.name, end.at)
    simple_f, simple_g = walk.of(theorem.claim.left), walk.of(theorem.claim.right)
    power_of_g = monomial(simple_g)
    if power_of_g is None:
        return None
    c, m = power_of_g
    size = bounded.constant.args[0] * abs(evaluate(c, {}))
    for k in range(max(0, -m), max(0, -m) + MOST_SHIFT):
        n = m + k
        h = spread(simple_f, k)
        slopes = _slopes(h, n) if n <= MOST_ORDER else None
        if slopes is not None:
            break
    else:
        return None
    radius = _radius(slopes[-1], size * factorial(n), bounded.reach)
    if radius is None:
        return None
    reach, text = term(number(bounded.reach)), term(bounded.constant, ATOM)
    parts = [condition(placed(e, path.name, end.at), sign) for e, sign in _defined(theorem)]
    shown = f"Rabs ({term(f)}) <= {text} * Rabs ({term(g)})"
    chain = _cases([term(substitute(d, {"t": symbol("u")})) for d in slopes])
    asked = "i_bisect t, i_taylor t, i_degree 8, i_depth 14"
    near = (
        f"apply (taylor_within {n} {chain} ({text} * Rabs ({term(c)})) ({term(number(radius))}));\n"
        f"[w_slopes | w_values | intros u U; cbv beta iota; cbn [whole_fact Z.of_nat "
        "Pos.of_succ_nat Pos.succ]; interval with (i_bisect u, i_depth 12) | lra]."
    )
    far = (
        f"apply two_sides; try inverse_sines; first [interval with ({asked}) | "
        "interval with (i_bisect t, i_depth 20)]."
    )
    last = (
        near
        if radius == bounded.reach
        else (
            f"destruct (Rle_or_lt t ({term(number(radius))})) as [S | S].\n"
            f"{{ {near} }}\n{{ {far} }}"
        )
    )
    says = f"({AND.join(parts)}){AND}{shown}" if parts else shown
    defined = "split.\n{ repeat split; w_side. }\n" if parts else ""
    name = f"side_{'above' if side > 0 else 'below'}"
    steps = f"unfold tan, tanh. {walk.script}"
    return (
        f"assert ({name} : forall t : R, 0 < t <= {reach} -> "
        f"{says}).\n"
        f"{{ intros t T. {defined}"
        f"apply (scaled ({term(f)}) ({term(g)}) ({term(h)}) ({term(c)}) {text} t {n} {k}).\n"
        f"{{ lra. }}\n{{ {steps} w_equal. }}\n{{ {steps} w_equal. }}\n{last} }}"
    )


def _together(theorem: BoundTheorem, path: Path) -> str:
    """Return the end of the proof: where the variable lies on which side."""
    x = variable(path.name)
    if theorem.naturals:
        x = f"(INR {x})"
    proofs = {}
    for side in path.sides:
        name = f"side_{'above' if side > 0 else 'below'}"
        if path.point is None:
            assert theorem.bounded is not None
            assert theorem.bounded.reach is not None
            end = term(number(1 / theorem.bounded.reach))
            t = f"(/ {x})" if side > 0 else f"(/ (- {x}))"
            back = f"/ {t}" if side > 0 else f"(-1) * / {t}"
            proofs[side] = (
                f"pose proof ({name} {t} ltac:(apply (far_side _ ({end})); "
                "first [lra | field])) as W; cbv beta in W; "
                f"replace ({back}) with {x} in W by (rewrite Rinv_inv; ring); exact W."
            )
            continue
        a = term(path.point, ATOM)
        zero = path.point == ZERO
        t = f"({x} - {a})" if side > 0 else f"({a} - {x})"
        if zero and side > 0:
            proofs[side] = f"exact ({name} {x} ltac:(split_Rabs; lra))."
            continue
        back = f"{a} + {t}" if side > 0 else f"{a} + (-1) * {t}"
        proofs[side] = (
            f"pose proof ({name} {t} ltac:(split_Rabs; lra)) as W; cbv beta in W; "
            f"replace ({back}) with {x} in W by ring; exact W."
        )
    if len(proofs) == 1 or path.point is None:
        return next(iter(proofs.values()))
    return (
        f"destruct (Rtotal_order {x} {term(path.point, ATOM)}) as [L | [L | L]].\n"
        f"{{ {proofs[-1]} }}\n{{ contradiction. }}\n{{ {proofs[1]} }}"
    )


def _by_inequality(theorem: BoundTheorem, head: str, prove: Prove) -> Iterator[str]:
    """Yield a proof by the provers of inequalities between real numbers."""
    path, bounded, claim = theorem.statement.path, theorem.bounded, theorem.claim
    assert path is not None
    assert bounded is not None
    given = (*theorem.statement.given.comparisons, *_region(path, bounded.reach))
    bare = [sign(e, Given(given)) == "+" for e in (claim.left, claim.right)]
    barred = [apply("abs", e) for e in (claim.left, claim.right)]
    free = [
        e if is_bare else other
        for e, is_bare, other in zip((claim.left, claim.right), bare, barred, strict=True)
    ]
    split = "split.\n{ repeat split; w_region. }\n" if len(theorem.says) > 1 else ""
    for left, right in dict.fromkeys([(free[0], free[1]), (barred[0], barred[1])]):
        whole = Comparison(left, "<=", Expr("*", (bounded.constant, right)))
        lemma = plain_theorem(whole, given, "whole")
        script = prove(lemma)
        if script is None:
            continue
        shown = [term(naturally(e, theorem.naturals)) for e in (left, right)]
        yield (
            f"assert (whole : {lemma.body.strip()}).\n{{ {script} }}\n{head}{split}"
            f"apply (without_signs _ _ _ ({shown[0]}) ({shown[1]})); "
            "[first [reflexivity | apply Rabs_pos_eq; w_positive] | "
            "first [reflexivity | apply Rabs_pos_eq; w_positive] | apply whole; inside_]."
        )


def _region(path: Path, reach: fmpq | None) -> list[tuple[Expr, str, Expr]]:
    x = symbol(path.name)
    if path.point is None:
        side = path.sides[0]
        end, relation = (ZERO, ">") if reach is None else (number(side / reach), ">=")
        return [(x, relation, end) if side > 0 else (x, MIRROR[relation], end)]
    gap = x - path.point
    if len(path.sides) > 1:
        return [
            (gap, "!=", ZERO),
            *([(apply("abs", gap), "<=", number(reach))] if reach is not None else []),
        ]
    away = multiply(number(path.sides[0]), gap)
    return [
        (away, ">", ZERO),
        *([(away, "<=", number(reach))] if reach is not None else []),
    ]


MIRROR = {">": "<", ">=": "<="}


def _defined(theorem: BoundTheorem) -> list[tuple[Expr, str]]:
    path, claim = theorem.statement.path, theorem.claim
    assert path is not None
    return [p for p in needs([claim.left, claim.right]) if path.name in symbols(p[0])]


def monomial(e: Expr) -> tuple[Expr, int] | None:
    """Return the constant c and the whole number m of a tidy expression ``c*t**m``."""
    rest, m = _parted(e)
    return None if "t" in symbols(rest) else (rest, m)


def _parted(e: Expr) -> tuple[Expr, int]:
    """Return the other factors of a tidy product, and the power of t in it."""
    others, m = [], 0
    for factor in factors_in(e):
        base, exponent = factor.args if factor.op == "^" else (factor, ONE)
        if base == T and exponent.op == "number" and exponent.args[0].q == 1:
            m += int(exponent.args[0].p)
        else:
            others.append(factor)
    return multiply(*others), m


def tidied(e: Expr) -> Expr:
    """Return ``e`` with the powers of t in products, and the numbers in sums, put together."""
    if e.op in LEAVES:
        return e
    args = tuple(map(tidied, e.args))
    if e.op == "+":
        sums: dict[Expr, Expr] = {}
        for part in (one for arg in args for one in (arg.args if arg.op == "+" else (arg,))):
            first, *others = factors_in(part)
            c, kind = (first, multiply(*others)) if first.op == "number" else (ONE, part)
            sums[kind] = add(sums.get(kind, ZERO), c)
        return add(*(multiply(c, kind) for kind, c in sums.items() if c != ZERO))
    if e.op == "*":
        others_, m = _parted(multiply(*args))
        return multiply(others_, _power_of_t(m))
    if e.op == "^" and args[1].op == "number" and args[1].args[0].q == 1:
        rest, m = _parted(args[0])
        if args[0].op != "+" and m:
            n = int(args[1].args[0].p)
            return multiply(power(rest, args[1]), _power_of_t(m * n))
    return power(*args) if e.op == "^" else apply(e.op, *args)


def _power_of_t(m: int) -> Expr:
    return ONE if m == 0 else T if m == 1 else power(T, number(m))


def spread(e: Expr, k: int) -> Expr:
    """Return ``e * t**k`` with powers of t multiplied into its terms."""
    if e.op == "+":
        return tidied(add(*(spread(part, k) for part in e.args)))
    if e.op == "*":
        sums = [part for part in e.args if part.op == "+"]
        others = [part for part in e.args if part.op != "+"]
        if len(sums) == 1 and monomial(multiply(*others)) is not None:
            return tidied(add(*(spread(multiply(*others, part), k) for part in sums[0].args)))
    return tidied(multiply(e, _power_of_t(k)))


def _slopes(h: Expr, n: int) -> list[Expr] | None:
    """Return ``h`` and its n derivatives if all but the last are 0 at 0; else None."""
    found = [h]
    for k in range(n + 1):
        with ball_precision():
            value = evaluate(found[k], {"t": arb(0)})
        if not value.is_finite() or (k < n and not value.contains(0)):
            return None
        if k < n:
            found.append(tidied(differentiate(found[k], "t")))
    return found


def _radius(slope: Expr, size: arb, reach: fmpq) -> fmpq | None:
    """Return up to where the last derivative stays below a number, at points and in small balls."""
    for part in (fmpq(1), fmpq(3, 4), fmpq(1, 2), fmpq(1, 4), fmpq(1, 8), fmpq(1, 16), fmpq(1, 64)):
        radius, inside = reach * part, True
        for i in range(PARTS):
            middle = arb(radius * (2 * i + 1) / (2 * PARTS))
            piece = arb(middle.mid(), arb(radius / (2 * PARTS)))
            with ball_precision():
                inside = bool(abs(evaluate(slope, {"t": piece})) < size)
            if not inside:
                break
        if inside:
            return radius
    return None


@dataclass
class Simplified:
    """Expressions at a place ``x = a + t`` or ``1/t``, and the steps of Coq that lead there.

    Attributes:
        name: the variable x.
        at: its value in terms of t.
        steps: replacements of arguments of functions, the inner ones first.
    """

    name: str
    at: Expr
    steps: list[str] = field(default_factory=list)

    @property
    def script(self) -> str:
        """The steps as sentences."""
        return " ".join(dict.fromkeys(self.steps))

    def of(self, e: Expr) -> Expr:
        """Return an expression in t, worked out."""
        return tidied(self.walk(e))

    def walk(self, e: Expr) -> Expr:
        """Return an expression in t whose functions have arguments that are worked out."""
        if e.op in LEAVES or self.name not in symbols(e):
            return placed(e, self.name, self.at)
        if e.op in BY_DEFINITION:
            return self.walk(BY_DEFINITION[e.op](e.args[0]))
        args = tuple(map(self.walk, e.args))
        whole = e.op == "^" and args[1].op == "number" and args[1].args[0].q == 1
        if e.op in ("+", "*") or whole:
            return Expr(e.op, args, e.names)
        simple = tuple(map(tidied, args))
        for before, after in zip(args, simple, strict=True):
            if term(before) != term(after):
                self.steps.append(f"try replace ({term(before)}) with ({term(after)}) by w_equal.")
        first = factors_in(simple[0])[0]
        if e.op == "asin" and first.op == "number" and first.args[0] < 0:
            opposite = Expr("*", (MINUS_ONE, Expr("asin", (tidied(-simple[0]),))))
            self.steps.append(
                f"try replace ({term(Expr('asin', simple))}) with ({term(opposite)}) "
                "by (rewrite <- asin_turned; apply f_equal; ring)."
            )
            return opposite
        root = e.op == "^" and args[1] == HALF
        pole = next((j for j in (1, 2) if _starts_at(simple[0], 2 * j)), None) if root else None
        if pole is None:
            return Expr(e.op, simple, e.names)
        under = spread(simple[0], 2 * pole)
        self.steps.append(
            f"try rewrite (sqrt_pull t {pole} ({term(simple[0])}) ({term(under)})) "
            "by (cbn [Nat.add]; first [lra | w_equal])."
        )
        return Expr("*", (Expr("^", (under, HALF)), Expr("^", (T, number(-pole)))))


def _starts_at(e: Expr, pole: int) -> bool:
    """Return whether an expression has a pole of this order at 0, with a positive factor."""
    with ball_precision():
        if evaluate(e, {"t": arb(0)}).is_finite():
            return False
        return bool(evaluate(spread(e, pole), {"t": arb(0)}) > 0)


def _cases(texts: list[str]) -> str:
    """Return the functions of a list as one of a number k and of u."""
    *first, last = texts
    cases = " ".join(f"| {k}%nat => {text}" for k, text in enumerate(first))
    return f"(fun (k : nat) (u : R) => match k with {cases} | _ => {last} end)"
