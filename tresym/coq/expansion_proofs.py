"""Prove limits and orders in Coq by expansions in powers of a variable t > 0 that tends to 0.

`sin(t) - t` is -t³/6 + O(t⁵): every part of an expression gets a polynomial with which it agrees up
to O(tⁿ), after division by a power of t. ``Orders.v`` has a lemma for each operation; that the
products and Taylor polynomials are those is left to Coq's ``field``.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache
from math import factorial

from tresym.coq.statement import ATOM, PRODUCT, term
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.normal.to_expression import written
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.sign import sign

T, U = symbol("t"), symbol("u")
Coefficients = tuple[Expr, ...]
LENGTHS = range(2, 11)
MOST_LINES = 400


class NoExpansionError(Exception):
    """No expansion in whole powers was found, or none that is long enough."""


@dataclass(frozen=True)
class Expansion:
    """What is known of an expression: ``e / t**shift`` is a polynomial, up to O(t**n).

    Attributes:
        name: of the hypothesis in Coq.
        shift: the power of t that was divided out.
        coefficients: of the polynomial, n of them.
    """

    name: str
    shift: int
    coefficients: Coefficients

    @property
    def order(self) -> int:
        """The n of O(t**n)."""
        return len(self.coefficients)


def placed(e: Expr, name: str, by: Expr) -> Expr:
    """Return ``e`` with ``by`` in the place of a variable, and nothing worked out."""
    if e.op == "symbol":
        return by if e.args[0] == name else e
    if e.op in LEAVES or name not in symbols(e):
        return e
    return Expr(e.op, tuple(placed(arg, name, by) for arg in e.args), e.names)


def shifted(text: str, shift: int) -> str:
    """Return an atom of Coq divided by a power of t."""
    if not shift:
        return text
    return f"{text} * / t ^ {shift}" if shift > 0 else f"{text} * t ^ {-shift}"


def polynomial(coefficients: Iterable[Expr]) -> str:
    """Return a polynomial in t as Coq text."""
    parts = []
    for k, c in enumerate(coefficients):
        if c == ZERO:
            continue
        if k == 0:
            parts.append(term(c, PRODUCT))
        else:
            parts.append(f"{term(c, ATOM)} * t" + (f" ^ {k}" if k > 1 else ""))
    return " + ".join(parts) or "0"


def function(text: str) -> str:
    """Return a function of t as Coq text."""
    return f"(fun t : R => {text})"


@dataclass
class Expansions:
    """The search for expansions, and the Coq text that proves them.

    Attributes:
        given: conditions on the parameters.
        order: how many coefficients are computed.
        lines: assertions, each with its proof.
    """

    given: Given
    order: int
    lines: list[str] = field(default_factory=list)
    known: dict[Expr, Expansion] = field(default_factory=dict)
    levels: dict[Expr, Expansion] = field(default_factory=dict)

    # Polynomials.

    def plain(self, e: Expr) -> Expr:
        """Return a coefficient, as 0 if it is."""
        e = folded(e)
        return e if e.op in LEAVES else _rational(e, self.given) or e

    def product(self, a: Coefficients, b: Coefficients) -> Coefficients:
        """Return all coefficients of a product."""
        sums: list[list[Expr]] = [[] for _ in range(len(a) + len(b) - 1)]
        for i, x in enumerate(a):
            for j, y in enumerate(b):
                if ZERO not in (x, y):
                    sums[i + j].append(multiply(x, y))
        return tuple(self.plain(add(*parts)) for parts in sums)

    def cut(self, whole: Coefficients, n: int) -> tuple[Coefficients, str]:
        """Return the first n coefficients, and the last arguments of lemmas that cut there."""
        first = (*whole[:n], *[ZERO] * (n - len(whole)))
        return first, f"{function(polynomial(first))} {function(polynomial(whole[n:]))}"

    # Assertions.

    def stated(
        self, e: Expr, shift: int, coefficients: Coefficients, proof: str, keep: bool = True
    ) -> Expansion:
        """Assert an expansion of an expression with its proof."""
        name = f"E{len(self.lines)}"
        if len(self.lines) > MOST_LINES or not coefficients:
            raise NoExpansionError
        text = function(shifted(term(e, ATOM), shift))
        self.lines.append(
            f"assert ({name} : germ {len(coefficients)} {text} "
            f"{function(polynomial(coefficients))}).\n{{ {proof} }}"
        )
        found = Expansion(name, shift, coefficients)
        if keep:
            self.known[e] = found
        return found

    def beside(self, n: int, inner: str, law: str, *parts: Expr) -> str:
        """Return the step to a function that is equal near 0, by a law of numbers in its parts."""
        names = [f"x{k}" for k in range(len(parts))]
        shown = law.format(*names)
        values = " ".join(term(part, ATOM) for part in parts)
        law = f"forall {' '.join(names)} : R, {shown}"
        return (
            f"apply (g_ext {n} _ {function(inner)}).\n"
            f"{{ g_near; assert (E : {law}) by (intros; field; lra); exact (E {values}). }}\n"
        )

    # Expressions.

    def of(self, e: Expr) -> Expansion:
        """Return an expansion of an expression in t.

        Raises:
            NoExpansionError: there is none, or its leading coefficients are not known.
        """
        if e not in self.known:
            self._expand(e)
        return self.known[e]

    def _expand(self, e: Expr) -> None:
        n = self.order
        if "t" not in symbols(e):
            whole = (self.plain(e) if e.op != "number" else e, *[ZERO] * (n - 1))
            proof = f"apply (g_const {n})."
            if whole[0] != e:
                same = f"apply (g_ext {n} _ {function(term(whole[0]))})."
                proof = f"{same}\n{{ g_near; g_field. }}\n{proof}"
            self.stated(e, 0, whole, proof)
        elif e == T:
            proof = (
                f"apply (g_ext {n} _ (fun t : R => 1)).\n{{ g_near; field; lra. }}\n"
                f"apply (g_const {n})."
            )
            self.stated(e, 1, (ONE, *[ZERO] * (n - 1)), proof)
        elif e.op == "+":
            self._sum(e)
        elif e.op == "*":
            self._product(e)
        elif e.op == "^":
            self._power(e)
        elif e.op in BY_DEFINITION:
            found = self.of(BY_DEFINITION[e.op](e.args[0]))
            self.stated(e, found.shift, found.coefficients, f"exact {found.name}.")
        elif e.op in DERIVATIVES:
            self._function(e)
        else:
            raise NoExpansionError

    def _sum(self, e: Expr) -> None:
        *before, last = e.args
        first = before[0] if len(before) == 1 else Expr("+", tuple(before))
        a, b = self.of(first), self.of(last)
        shift = min(a.shift, b.shift)
        n = min(a.order + a.shift, b.order + b.shift) - shift
        proofs, inner, whole = [], [], []
        for part, x in ((first, a), (last, b)):
            j = x.shift - shift
            w = shifted(term(part, ATOM), x.shift)
            p = polynomial(x.coefficients)
            done = f"exact {x.name}."
            if j:
                done = f"apply (g_raise {x.order} {j} {function(w)} {function(p)}); {done}"
                w, p = f"{w} * t ^ {j}", f"({p}) * t ^ {j}"
            proofs.append(f"{{ apply (g_less {n} {x.order + j}); [lia |]. {done} }}")
            inner.append((w, p))
            whole.append((*[ZERO] * j, *x.coefficients))
        length = max(map(len, whole))
        both = (tuple(x[k] if k < len(x) else ZERO for x in whole) for k in range(length))
        sums, cut = self.cut(tuple(self.plain(add(*pair)) for pair in both), n)
        law = "{} = {}".format(
            shifted("({0} + {1})", shift),
            " + ".join(
                shifted(f"{{{k}}}", x.shift)
                + (f" * t ^ {x.shift - shift}" if x.shift > shift else "")
                for k, x in enumerate((a, b))
            ),
        )
        (w1, p1), (w2, p2) = inner
        proof = self.beside(n, f"{w1} + {w2}", law, first, last)
        proof += (
            f"apply (g_cut {n} {n} _ {function(f'{p1} + ({p2})')} {cut}); "
            "[lia | | g_continues | g_continues | g_poly].\n"
            f"apply (g_plus {n} {function(w1)} {function(w2)} {function(p1)} {function(p2)}).\n"
            + "\n".join(proofs)
        )
        self.stated(e, shift, sums, proof)

    def _product(self, e: Expr) -> None:
        *before, last = e.args
        first = before[0] if len(before) == 1 else Expr("*", tuple(before))
        self._times(e, first, last, "({0} * {1})")

    def _times(self, e: Expr, first: Expr, last: Expr, law: str) -> None:
        """Expand a product; by the law it is one of its two factors."""
        a, b = self.of(first), self.of(last)
        n, shift = min(a.order, b.order), a.shift + b.shift
        sums, cut = self.cut(self.product(a.coefficients, b.coefficients), n)
        left, right = (shifted(f"{{{k}}}", x.shift) for k, x in enumerate((a, b)))
        inner = " * ".join(
            f"({shifted(term(part, ATOM), x.shift)})" for part, x in ((first, a), (last, b))
        )
        proof = self.beside(n, inner, f"{shifted(law, shift)} = {left} * ({right})", first, last)
        p, q = (function(polynomial(x.coefficients)) for x in (a, b))
        w1, w2 = (
            function(shifted(term(part, ATOM), x.shift)) for part, x in ((first, a), (last, b))
        )
        less = [f"{{ apply (g_less {n} {x.order}); [lia | exact {x.name}]. }}" for x in (a, b)]
        proof += (
            f"apply (g_product {n} {w1} {w2} {p} {q} {cut}); "
            "[| | g_continues | g_continues | g_poly].\n" + "\n".join(less)
        )
        self.stated(e, shift, sums, proof)

    def _power(self, e: Expr) -> None:
        base, exponent = e.args
        if exponent.op != "number":
            found = self.of(Expr("exp", (Expr("*", (exponent, Expr("log", (base,)))),)))
            self.stated(e, found.shift, found.coefficients, f"exact {found.name}.")
            return
        r = exponent.args[0]
        p, q = int(r.p), int(r.q)
        if r < 0:
            under = base if r == -1 else Expr("^", (base, number(-r)))
            self._inverse(e, under)
        elif p > 1:
            one = base if q == 1 else Expr("^", (base, power(number(q), MINUS_ONE)))
            less = one if p == 2 else Expr("^", (base, exponent - exponent / p))
            name = "{1} ^ " + str(p - 1) if p > 2 else "{1}"
            self._squared(e, less, one, p, name)
        elif q == 2:
            self._root(e, base)
        else:
            raise NoExpansionError

    def _squared(self, e: Expr, less: Expr, one: Expr, p: int, name: str) -> None:
        """Expand ``one ^ p`` as ``one ^ (p - 1)`` by ``one``."""
        b = self.leading(one)
        a = self.leading(less)
        n, shift = min(a.order, b.order), a.shift + b.shift
        sums, cut = self.cut(self.product(a.coefficients, b.coefficients), n)
        w1, w2 = (shifted(term(part, ATOM), x.shift) for part, x in ((less, a), (one, b)))
        x1 = f"(x0 ^ {p - 1})" if p > 2 else "x0"
        law = (
            f"{shifted(f'(x0 ^ {p})', shift)} = {shifted(x1, a.shift)} * ({shifted('x0', b.shift)})"
        )
        proof = self.beside(n, f"({w1}) * ({w2})", law.replace("x0", "{0}"), one)
        p1, q1 = (function(polynomial(x.coefficients)) for x in (a, b))
        less_ = [f"{{ apply (g_less {n} {x.order}); [lia | exact {x.name}]. }}" for x in (a, b)]
        proof += (
            f"apply (g_product {n} {function(w1)} {function(w2)} {p1} {q1} {cut}); "
            "[| | g_continues | g_continues | g_poly].\n" + "\n".join(less_)
        )
        self.stated(e, shift, sums, proof)

    def leading(self, e: Expr) -> Expansion:
        """Return the expansion of ``e`` whose first coefficient is not 0."""
        found = self.of(e)
        zeros = next((k for k, c in enumerate(found.coefficients) if c != ZERO), None)
        if zeros is None:
            raise NoExpansionError
        if zeros == 0:
            return found
        return self._shift(e, found, zeros)

    def _shift(self, e: Expr, found: Expansion, zeros: int) -> Expansion:
        rest = found.coefficients[zeros:]
        n = len(rest)
        shift = found.shift + zeros
        inner = shifted(term(e, ATOM), found.shift)
        law = f"{shifted('{0}', shift)} = {shifted('{0}', found.shift)} * / t ^ {zeros}"
        proof = self.beside(n, f"{inner} * / t ^ {zeros}", law, e)
        proof += (
            f"apply (g_shift {n} {zeros} {function(inner)} "
            f"{function(polynomial(found.coefficients))} {function(polynomial(rest))}); "
            f"[exact {found.name} | g_continues | g_poly]."
        )
        return self.stated(e, shift, rest, proof)

    def level(self, e: Expr) -> Expansion:
        """Return the expansion of ``e`` itself, with no power divided out."""
        found = self.of(e)
        if found.shift < 0:
            found = self.leading(e)
        if found.shift < 0:
            raise NoExpansionError
        if found.shift == 0:
            return found
        if e in self.levels:
            return self.levels[e]
        k, n = found.shift, found.order
        m = min(n + k, max(self.order, k + 1))
        whole, cut = self.cut((*[ZERO] * k, *found.coefficients), m)
        inner = shifted(term(e, ATOM), k)
        p = polynomial(found.coefficients)
        proof = self.beside(m, f"{inner} * t ^ {k}", f"{{0}} = {{0}} * / t ^ {k} * t ^ {k}", e)
        proof += (
            f"apply (g_cut {m} {n + k} _ {function(f'({p}) * t ^ {k}')} {cut}); "
            "[lia | | g_continues | g_continues | g_poly].\n"
            f"apply (g_raise {n} {k} {function(inner)} {function(p)}); exact {found.name}."
        )
        self.levels[e] = self.stated(e, 0, whole, proof, keep=False)
        return self.levels[e]

    def _inverse(self, e: Expr, under: Expr) -> None:
        found = self.leading(under)
        inner = shifted(term(under, ATOM), found.shift)
        whole, proof = self.outer("inverse", found, inner)
        law = f"{shifted('(/ x)', -found.shift)} = / ({shifted('x', found.shift)})"
        step = "" if not found.shift else "rewrite Rinv_mult, ?Rinv_inv; "
        before = (
            f"apply (g_ext {found.order} _ {function(f'/ ({inner})')}).\n"
            f"{{ g_near; assert (E : forall x : R, {law}) by (intros; {step}reflexivity); "
            f"exact (E {term(under, ATOM)}). }}\n"
        )
        self.stated(e, -found.shift, whole, before + proof)

    def _root(self, e: Expr, base: Expr) -> None:
        found = self.leading(base)
        if found.shift % 2 or sign(found.coefficients[0], self.given) != "+":
            raise NoExpansionError
        inner = shifted(term(base, ATOM), found.shift)
        whole, proof = self.outer("sqrt", found, inner)
        half = found.shift // 2
        law = "sqrt_out" if half > 0 else "sqrt_in"
        step = (
            f"exact ({law} t {abs(half)} {term(base, ATOM)} ltac:(lra))" if half else "reflexivity"
        )
        before = (
            f"apply (g_ext {found.order} _ {function(f'sqrt ({inner})')}).\n{{ g_near; {step}. }}\n"
        )
        self.stated(e, half, whole, before + proof)

    def _far_arctangent(self, e: Expr, arg: Expr) -> None:
        """Expand ``atan(x)`` for large x as ``pi/2 - atan(1/x)``."""
        turned = Expr("*", (MINUS_ONE, Expr("atan", (Expr("^", (arg, MINUS_ONE)),))))
        other = Expr("+", (Expr("*", (PI, number(1) / 2)), turned))
        above, found = self.holds(arg, ">"), self.of(other)
        proof = (
            f"assert (Q : at_right 0 (fun t : R => 0 < {term(arg)})).\n{{ {above} }}\n"
            f"apply (g_ext {found.order} _ {function(term(other))}).\n"
            "{ revert Q; apply filter_imp; intros t Q; rewrite (atan_left _ Q); lra. }\n"
            f"exact {found.name}."
        )
        self.stated(e, found.shift, found.coefficients, proof)

    def _function(self, e: Expr) -> None:
        (arg,) = e.args
        if e.op == "atan" and self.of(arg).shift < 0 and self.leading(arg).shift < 0:
            self._far_arctangent(e, arg)
            return
        found = self.leading(arg) if e.op == "log" else self.level(arg)
        if e.op == "log" and (found.shift or sign(found.coefficients[0], self.given) != "+"):
            raise NoExpansionError
        whole, proof = self.outer(e.op, found, term(arg))
        self.stated(e, 0, whole, proof)

    def outer(self, name: str, found: Expansion, inner: str) -> tuple[Coefficients, str]:
        """Return the expansion of a function of an expansion, by Taylor's theorem."""
        n, (a, *rest) = found.order, found.coefficients
        derivatives = [DERIVATIVES[name](k) for k in range(n + 1)]
        values = [substitute(d, {"u": a}) for d in derivatives[:n]]
        own = [self.plain(value * number(1) / factorial(k)) for k, value in enumerate(values)]
        step = (ZERO, *rest)
        total: Coefficients = (ZERO,)
        now: Coefficients = (ONE,)
        for k, c in enumerate(own):
            if k:
                now = self.product(now, step)
            size = max(len(total), len(now))
            pairs = (
                add(
                    total[i] if i < len(total) else ZERO,
                    multiply(c, now[i]) if i < len(now) and ZERO not in (c, now[i]) else ZERO,
                )
                for i in range(size)
            )
            total = tuple(self.plain(pair) for pair in pairs)
        whole, cut = self.cut(total, n)
        radius = RADIUS.get(name, "1")
        if radius == "near":
            radius = term(a) if sign(a, self.given) == "+" else f"- {term(a, ATOM)}"
        chain = _cases([term(d) for d in derivatives], "(k : nat) (u : R)")
        series = _cases([*map(term, own), "0"], "(k : nat)")
        return whole, (
            f"apply (g_outer {n} {chain} {series} {term(a, ATOM)} ({radius}) {function(inner)} "
            f"{function(polynomial(found.coefficients))} {function(polynomial(rest))} {cut}).\n"
            "{ g_side. }\n{ g_slopes. }\n{ g_continues. }\n{ g_values. }\n"
            f"{{ exact {found.name}. }}\n{{ g_continues. }}\n{{ g_poly. }}\n"
            "{ g_continues. }\n{ g_continues. }\n{ g_poly. }\n{ lia. }"
        )

    # Limits.

    def tends(self, e: Expr) -> tuple[Expr, str]:
        """Return the limit of ``e`` as t -> 0 from above, and the end of the proof."""
        found = self.of(e)
        whole = next((k for k, c in enumerate(found.coefficients) if c != ZERO), None)
        if whole is None and found.shift + found.order > 0 and found.shift <= 0:
            whole = -found.shift
        if whole is None:
            raise NoExpansionError
        shift = found.shift + whole
        if shift >= 0:
            if found.shift > 0:
                found = self.level(e)
            elif found.shift < 0:
                found = self._shift(e, found, -found.shift)
            value = found.coefficients[0]
            p = function(polynomial(found.coefficients))
            return value, (
                f"apply (t_value (at_right 0) {function(term(e))} (Finite ({p} 0))).\n"
                f"{{ apply (g_limit {found.order - 1} _ {p} {found.name}); g_continues. }}\n"
            )
        found = self.leading(e)
        c = sign(found.coefficients[0], self.given)
        if c not in ("+", "-"):
            raise NoExpansionError
        p = function(polynomial(found.coefficients))
        law = "g_infinite" if c == "+" else "g_infinite_below"
        return (INFINITY if c == "+" else -INFINITY), (
            f"apply ({law} {found.order - 1} {-found.shift - 1} _ {p} {found.name}); "
            "[g_continues | g_side]."
        )

    def holds(self, e: Expr, relation: str) -> str:
        """Return the proof of ``e relation 0`` near 0.

        Raises:
            NoExpansionError: the first coefficient does not show it.
        """
        found = self.leading(e)
        p = function(polynomial(found.coefficients))
        text = function(shifted(term(e, ATOM), found.shift))
        above = relation in (">", ">=")
        if above and sign(found.coefficients[0], self.given) != "+":
            raise NoExpansionError
        law = f"g_above {found.order - 1}" if above else f"g_apart {found.order - 1}"
        power_ = f"t ^ {abs(found.shift)}" if found.shift else "1"
        if above:
            last = (
                f"assert (0 < {power_}) by (try apply pow_lt; lra); cbv beta in A |- *; "
                f"{'apply Rlt_le; ' if relation == '>=' else ''}" + _positive(found.shift, power_)
            )
        else:
            last = "intros Z; apply A; cbv beta in Z |- *; rewrite Z; ring."
        return (
            f"assert (A : at_right 0 (fun t : R => {'0 < ' if above else ''}{text} t"
            f"{'' if above else ' <> 0'})) by (apply ({law} {text} {p} {found.name}); "
            "[g_continues | g_side]).\n"
            f"generalize (filter_and _ _ A right_small); clear A; apply filter_imp; "
            f"intros t [A S]; {last}"
        )


def _positive(shift: int, power_: str) -> str:
    """Return the step from a quotient by a power of t, or a product with one."""
    if not shift:
        return "exact A."
    if shift > 0:
        return f"apply (Rmult_lt_reg_r (/ {power_})); [now apply Rinv_0_lt_compat | lra]."
    return f"apply (Rmult_lt_reg_r ({power_})); [assumption | lra]."


def folded(e: Expr) -> Expr:
    """Return ``e`` with the functions of numbers worked out that have rational values."""
    if e.op in LEAVES:
        return e
    args = tuple(folded(arg) for arg in e.args)
    match e.op:
        case "+":
            return add(*args)
        case "*":
            return multiply(*args)
    whole = power(*args) if e.op == "^" else Expr(e.op, args, e.names)
    return whole if whole.op == "number" or symbols(whole) else _rational(whole, Given()) or whole


@cache
def _rational(e: Expr, given: Given) -> Expr | None:
    """Return the rational number that an expression is, by its normal form."""
    try:
        field = Field(given)
        (value,) = field.normal(e)
        found = multiply(
            written(field, value.num) or e, power(written(field, value.den) or e, MINUS_ONE)
        )
    except (TooLargeError, UndefinedError, InputError):
        return None
    return found if found.op == "number" else None


def _cases(texts: list[str], arguments: str) -> str:
    """Return a Coq function of a number of a case."""
    last = len(texts) - 1
    cases = " ".join(f"| {k}%nat => {text}" for k, text in enumerate(texts[:last]))
    return f"(fun {arguments} => match k with {cases} | _ => {texts[last]} end)"


def _derivative_of_root(k: int) -> Expr:
    c = ONE
    for i in range(k):
        c = c * (number(1) / 2 - i)
    return c * power(U, number(1) / 2 - k)


def _over_square(k: int, s: int, start: int, twice: int) -> Expr:
    """Return the derivatives of a function with the slope (1 + s u²)**(-start/2), for k > 0.

    ``twice`` is by how much the exponent grows with each derivative, in halves: always 2.
    """
    q = ONE + number(s) * power(U, number(2))
    n: dict[int, int] = {0: 1}
    exponent = start
    for _ in range(k - 1):  # (N q^(-m/2))' = (N' q - m s u N) q^(-m/2 - 1)
        new: dict[int, int] = {}
        for i, c in n.items():
            if i:
                new[i - 1] = new.get(i - 1, 0) + i * c
                new[i + 1] = new.get(i + 1, 0) + i * c * s
            new[i + 1] = new.get(i + 1, 0) - exponent * s * c
        n = {i: c for i, c in new.items() if c}
        exponent += twice
    top = add(*(number(c) * power(U, number(i)) for i, c in sorted(n.items())))
    return multiply(top, power(q, number(-exponent) / 2))


def _sine(k: int, first: str, second: str, turns: bool) -> Expr:
    name = (first, second)[k % 2]
    negative = turns and (k % 4 in ((2, 3) if first == "sin" else (1, 2)))
    return -apply(name, U) if negative else apply(name, U)


DERIVATIVES = {
    "exp": lambda k: apply("exp", U),
    "sin": lambda k: _sine(k, "sin", "cos", turns=True),
    "cos": lambda k: _sine(k, "cos", "sin", turns=True),
    "sinh": lambda k: _sine(k, "sinh", "cosh", turns=False),
    "cosh": lambda k: _sine(k, "cosh", "sinh", turns=False),
    "log": lambda k: (
        number((-1) ** (k - 1) * factorial(k - 1)) * power(U, number(-k)) if k else apply("log", U)
    ),
    "inverse": lambda k: number((-1) ** k * factorial(k)) * power(U, number(-k - 1)),
    "sqrt": _derivative_of_root,
    "atan": lambda k: _over_square(k, 1, 2, 2) if k else apply("atan", U),
    "asin": lambda k: _over_square(k, -1, 1, 2) if k else apply("asin", U),
    "asinh": lambda k: _over_square(k, 1, 1, 2) if k else apply("asinh", U),
}
"""The derivatives of functions of u, in forms that Coq compares quickly."""
RADIUS = {"log": "near", "inverse": "near", "sqrt": "near"}
"""How far from a point, beside 1: to where the function is not defined."""
BY_DEFINITION = {
    "tan": lambda u: _quotient("sin", "cos", u),
    "tanh": lambda u: _quotient("sinh", "cosh", u),
    "cot": lambda u: _quotient("cos", "sin", u),
    "coth": lambda u: _quotient("cosh", "sinh", u),
    "sec": lambda u: Expr("^", (Expr("cos", (u,)), MINUS_ONE)),
    "csc": lambda u: Expr("^", (Expr("sin", (u,)), MINUS_ONE)),
    "sech": lambda u: Expr("^", (Expr("cosh", (u,)), MINUS_ONE)),
    "csch": lambda u: Expr("^", (Expr("sinh", (u,)), MINUS_ONE)),
}
"""Functions that Coq defines by others."""


def _quotient(above: str, below: str, u: Expr) -> Expr:
    return Expr("*", (Expr(above, (u,)), Expr("^", (Expr(below, (u,)), MINUS_ONE))))
