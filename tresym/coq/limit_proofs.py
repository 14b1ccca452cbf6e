"""Prove limits in Coq by the limits of the parts, or by L'Hôpital's rule.

Only the ends 0 from above and infinity are treated; others are reduced to them by substitution. The
limits of parts are computed by tresym; Coq proves each step.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from tresym.coq.bound_statements import MINUS_INFINITY, extended
from tresym.coq.statement import ATOM, term
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ZERO,
    Expr,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.language.sympy import from_sympy

INFINITE = (INFINITY, MINUS_INFINITY)
FAR = {
    ("exp", INFINITY): "t_exp_infinity",
    ("exp", MINUS_INFINITY): "t_exp_below",
    ("log", INFINITY): "t_ln_infinity",
    ("atan", INFINITY): "t_atan_infinity",
    ("tanh", INFINITY): "t_tanh_infinity",
}
"""Lemmas on functions whose argument tends to infinity."""
MOST = 400


class StuckLimitError(Exception):
    """No proof of the limit was found."""


@dataclass
class Limits:
    """The search for a proof of a limit.

    Attributes:
        given: conditions on the parameters.
        radius: up to where a function is considered near 0, as Coq text.
        beyond: from where it is considered near infinity.
    """

    given: Given
    radius: str
    beyond: str
    far: bool = False
    count: int = 0

    @property
    def filter(self) -> str:
        """The filter of the end as Coq text."""
        return "(Rbar_locally p_infty)" if self.far else "(at_right 0)"

    @property
    def near(self) -> str:
        """Return the tactic that proves what holds near the end from what holds at points."""
        if self.far:
            return f"apply (near_infinity _ {self.beyond}); intros t T."
        return f"apply (near_right _ {self.radius} ltac:(lra)); intros t T."

    def defined(self, path: Path) -> str:
        """Return the tactic that reduces what holds near the end of a path to points."""
        if path.point is None:
            sign = "" if path.sides[0] > 0 else "-"
            return f"exists ({sign}{self.beyond}); intros v_x v_X; cbv beta."
        ball = (
            f"exists (mkposreal {self.radius} ltac:(lra)); intros v_x B v_X; "
            f"apply Rabs_def2 in B; unfold minus, plus, opp in B; simpl in B; cbv beta;"
        )
        two = "apply Rdichotomy in v_X; destruct v_X;" if len(path.sides) > 1 else ""
        return f"{ball} {two}"

    def along(self, e: Expr, path: Path, value: Expr) -> str:
        """Return a proof that the function tends to the value along the path."""
        t = symbol("t")
        scripts = []
        for side in path.sides:
            self.far = path.point is None
            if path.point is None:
                moved = t if side > 0 else Expr("*", (MINUS_ONE, t))
                start = "" if side > 0 else "apply ends_below.\n"
            elif path.point == ZERO and side > 0:
                moved, start = t, ""
            else:
                step = t if side > 0 else Expr("*", (MINUS_ONE, t))
                moved = Expr("+", (path.point, step))
                start = f"apply ends_{'right' if side > 0 else 'left'}.\n"
            plain = substitute(e, {path.name: moved})
            if path.point is None and side < 0:
                plain = simplified(plain)
            body = self.tends(plain, value)
            fun = f"(fun t : R => {term(plain)})"
            scripts.append(
                f"{start}apply (t_beside {self.filter} {fun} _ {extended(value)}).\n"
                f"{{ {self.near} equal_near. }}\n{body}"
            )
        if len(scripts) == 1:
            return scripts[0]
        return f"apply ends_both.\n{{ {scripts[0]} }}\n{{ {scripts[1]} }}"

    def limit(self, e: Expr) -> Expr:
        """Return the limit of ``e``."""
        found = limit_of(e, "t", None if self.far else ZERO, 1, self.given)
        if found is None:
            raise StuckLimitError
        return found

    def tends(self, e: Expr, value: Expr | None = None) -> str:
        """Return a proof that ``e`` tends to its limit, written as ``value``."""
        self.count += 1
        if self.count > MOST:
            raise StuckLimitError
        value = self.limit(e) if value is None else value
        shown, script = self.shown(e, value)
        if shown == extended(value):
            return script
        goal = f"{shown} {extended(value)}"
        return f"apply (t_value {self.filter} _ {goal}); [| equal_limits].\n{script}"

    def beside(self, text: str, value: Expr) -> str:
        """Return the step to another function that is equal near the end."""
        step = f"apply (t_beside {self.filter} {text} _ {extended(value)}).\n"
        return f"{step}{{ {self.near} equal_near. }}\n"

    def shown(self, e: Expr, value: Expr) -> tuple[str, str]:
        """Return the limit as the rules write it, and the proof that ``e`` tends to it."""
        f = self.filter
        if "t" not in symbols(e):
            return extended(e), f"apply (t_const {f})."
        if e.op == "symbol":
            return (
                (extended(INFINITY), "exact t_infinity.")
                if self.far
                else (extended(ZERO), "exact t_right.")
            )
        if e.op in ("+", "*"):
            return self.operation(e, value)
        if e.op == "^":
            return self.power(e, value)
        (arg,) = e.args
        inner = self.limit(arg)
        fun = f"(fun t : R => {term(arg)})"
        head = term(Expr(e.op, (symbol("u"),)))
        outer = f"(fun u : R => {head})"
        if inner in INFINITE:
            if (e.op, inner) not in FAR:
                raise StuckLimitError
            at = "(Finite (PI / 2))" if e.op == "atan" else extended(value)
            return at, (
                f"apply (t_far {f} {outer} {fun} {extended(inner)}); "
                f"[| exact {FAR[e.op, inner]}].\n{self.tends(arg)}"
            )
        if e.op == "log" and inner == ZERO:
            return extended(MINUS_INFINITY), (
                f"apply (t_ln_0 {f} {fun}); [| {self.near[:-1]}; apart_].\n{self.tends(arg)}"
            )
        at = extended(Expr(e.op, (inner,)))
        return (
            at,
            f"apply (t_outer {f} {outer} {fun} {term(inner, ATOM)}); [| continues; apart_].\n"
            f"{self.tends(arg)}",
        )

    def power(self, e: Expr, value: Expr) -> tuple[str, str]:
        """Return the proof for a power."""
        f, (base, exponent) = self.filter, e.args
        fun = f"(fun t : R => {term(base)})"
        if exponent.op != "number":
            whole = Expr("exp", (Expr("*", (exponent, Expr("log", (base,)))),))
            shown = f"(fun t : R => {term(whole)})"
            return extended(
                value
            ), f"change (filterlim {shown} {f} (Rbar_locally {extended(value)})).\n" + self.tends(
                whole, value
            )
        r = exponent.args[0]
        inner = self.limit(base)
        if r < 0:
            under = base if r == -1 else Expr("^", (base, number(-r)))
            text, limit = f"(fun t : R => {term(under)})", self.limit(under)
            if limit == ZERO:
                side = "above" if value == INFINITY else "below"
                return extended(value), (
                    f"apply (t_inv_{side} {f} {text}); [| {self.near[:-1]}; apart_].\n"
                    f"{self.tends(under)}"
                )
            if limit in INFINITE:
                return extended(ZERO), (
                    f"apply (t_inv_infinite {f} {text} {extended(limit)}); "
                    f"[| reflexivity | easy].\n{self.tends(under)}"
                )
            at = f"(Finite (/ {term(limit, ATOM)}))"
            return at, (
                f"apply (t_inv {f} {text} {extended(limit)}); "
                f"[| intros v_E; injection v_E; apart_].\n{self.tends(under)}"
            )
        u = Expr("^", (symbol("u"), exponent))
        outer = f"(fun u : R => {term(u)})"
        if inner in INFINITE:
            if inner == MINUS_INFINITY:
                raise StuckLimitError
            lemma = (
                "t_sqrt_infinity"
                if r == number(1).args[0] / 2
                else f"(t_pow_infinity {int(r.p) - 1})"
            )
            if r.q not in (1, 2) or (r.q == 2 and r.p != 1):
                raise StuckLimitError
            return extended(INFINITY), (
                f"apply (t_far {f} {outer} {fun} p_infty); [| exact {lemma}].\n{self.tends(base)}"
            )
        at = term(Expr("^", (inner, exponent)), ATOM)
        return f"(Finite {at})", (
            f"apply (t_outer {f} {outer} {fun} {term(inner, ATOM)}); [| continues; apart_].\n"
            f"{self.tends(base)}"
        )

    def operation(self, e: Expr, value: Expr) -> tuple[str, str]:
        """Return the proof for a sum or a product, two operands at a time."""
        f = self.filter
        *before, last = e.args
        first = before[0] if len(before) == 1 else Expr(e.op, tuple(before))
        try:
            a, b = self.limit(first), self.limit(last)
        except StuckLimitError:
            if e.op == "*":
                return self.squeezed(e)
            raise
        infinite = a in INFINITE, b in INFINITE
        clash = any(infinite) and (a != b and all(infinite) if e.op == "+" else ZERO in (a, b))
        if clash:
            return extended(value), self.rewritten(e, value)
        if all(infinite) or any(infinite):
            shown = extended(value)
        else:
            shown = f"(Finite ({term(a, ATOM)} {e.op} {term(b, ATOM)}))"
        texts = [f"(fun t : R => {term(arg)})" for arg in (first, last)]
        name, side = ("t_plus", "reflexivity") if e.op == "+" else ("t_mult", "product_value")
        return shown, (
            f"apply ({name} {f} {texts[0]} {texts[1]} {extended(a)} {extended(b)}); [| | {side}].\n"
            f"{{ {self.tends(first, a)} }}\n{{ {self.tends(last, b)} }}"
        )

    def squeezed(self, e: Expr) -> tuple[str, str]:
        """Return the proof for a product of a bounded function and one that tends to 0."""
        wave = next((arg for arg in e.args if arg.op in ("sin", "cos")), None)
        if wave is None:
            raise StuckLimitError
        rest = multiply(*(arg for arg in e.args if arg is not wave))
        whole = Expr("*", (wave, rest))
        texts = [f"(fun t : R => {term(arg)})" for arg in (wave, rest, whole)]
        return extended(ZERO), (
            f"apply (t_beside {self.filter} {texts[2]}).\n{{ {self.near} equal_near. }}\n"
            f"apply (t_bounded {self.filter} {texts[0]} {texts[1]} 1).\n"
            f"{{ {self.near} bounded_near. }}\n{self.tends(rest, ZERO)}"
        )

    def rewritten(self, e: Expr, value: Expr) -> str:
        """Return the proof for an undetermined sum or product."""
        if e.op == "+":
            return self.by(self.leading(e), value)
        return self.hopital(*self.quotient(e), value)

    def by(self, after: Expr, value: Expr) -> str:
        """Return the proof through another expression that is equal near the end."""
        text = f"(fun t : R => {term(after)})"
        return f"{self.beside(text, value)}{self.tends(after, value)}"

    def leading(self, e: Expr) -> Expr:
        """Return a sum with its largest term taken out as a factor."""
        for part in e.args:
            others = [multiply(arg, Expr("^", (part, MINUS_ONE))) for arg in e.args]
            try:
                limits = [self.limit(arg) for arg in map(simplified, others)]
            except StuckLimitError:
                continue
            if not any(limit in INFINITE for limit in limits) and sum(map(_size, limits)) != 0:
                return Expr("*", (part, Expr("+", tuple(map(simplified, others)))))
        raise StuckLimitError

    def quotient(self, e: Expr) -> tuple[Expr, Expr]:
        """Return a product as a quotient to which L'Hôpital's rule applies."""
        over = [arg for arg in e.args if not _under(arg)]
        under = [
            Expr("^", (arg.args[0], number(-arg.args[1].args[0])))
            if arg.args[1] != MINUS_ONE
            else arg.args[0]
            for arg in e.args
            if _under(arg)
        ]
        n, d = multiply(*over), multiply(*under)
        ends = self.limit(n), self.limit(d)
        if (
            under
            and ends[1] in (*INFINITE, ZERO)
            and (ends[0] in INFINITE) == (ends[1] in INFINITE)
        ):
            return n, d
        decays = [arg for arg in over if arg.op == "exp" and self.limit(arg) == ZERO]
        if decays:
            d = multiply(*(Expr("exp", (-arg.args[0],)) for arg in decays), *under)
            return multiply(*(arg for arg in over if arg not in decays)), d
        logs = [arg for arg in over if _has(arg, "log")]
        rest = [arg for arg in over if arg not in logs]
        if logs and rest:
            return multiply(*logs), multiply(*(Expr("^", (arg, MINUS_ONE)) for arg in rest), *under)
        small = [arg for arg in e.args if self.limit(arg) == ZERO]
        large = [arg for arg in e.args if arg not in small]
        if small and large:
            return multiply(*small), simplified(Expr("^", (multiply(*large), MINUS_ONE)))
        raise StuckLimitError

    def hopital(self, n: Expr, d: Expr, value: Expr) -> str:
        """Return the proof by L'Hôpital's rule."""
        if value in INFINITE:
            return self.inverted(n, d, value)
        if self.limit(d) == MINUS_INFINITY:
            n, d = -n, -d
        large = self.limit(d) in INFINITE
        dn, dd = differentiate(n, "t"), differentiate(d, "t")
        after = simplified(multiply(dn, Expr("^", (dd, MINUS_ONE))))
        texts = " ".join(f"(fun t : R => {term(part)})" for part in (n, d, dn, dd))
        whole = f"(fun t : R => {term(n, 2)} * / {term(d, ATOM)})"
        rule = f"hopital_{'infinite' if large else '0'}{'_far' if self.far else ''}"
        radius = self.beyond if self.far else self.radius
        inner = f"(fun t : R => {term(after)})"
        lines = [
            self.beside(whole, value),
            f"apply ({rule} {texts} {term(value, ATOM)} {radius}).",
            "{ lra. }",
            "{ intros t T; slope_near. }\n{ intros t T; slope_near. }\n{ intros t T; apart_. }",
            f"{{ {self.beside(inner, value)}{self.tends(after, value)} }}",
        ]
        if large:
            lines.append(f"{{ {self.tends(d, INFINITY)} }}")
        else:
            lines.append("{ intros t T; apart_. }")
            lines += [f"{{ {self.tends(part, ZERO)} }}" for part in (n, d)]
        return "\n".join(lines)

    def inverted(self, n: Expr, d: Expr, value: Expr) -> str:
        """Return the proof that a quotient is infinite, because its inverse tends to 0."""
        inverse = Expr("*", (d, Expr("^", (n, MINUS_ONE))))
        whole = f"(fun t : R => / ({term(inverse)}))"
        side = "above" if value == INFINITY else "below"
        return (
            f"{self.beside(whole, value)}"
            f"apply (t_inv_{side} {self.filter} (fun t : R => {term(inverse)})); "
            f"[| {self.near[:-1]}; apart_].\n{self.tends(inverse, ZERO)}"
        )


def _under(e: Expr) -> bool:
    return e.op == "^" and e.args[1].op == "number" and e.args[1].args[0] < 0


def _size(e: Expr) -> Fraction | int:
    return Fraction(str(e.args[0])) if e.op == "number" else 1


def _has(e: Expr, op: str) -> bool:
    return e.op == op or (e.op not in LEAVES and any(_has(arg, op) for arg in e.args))


def simplified(e: Expr) -> Expr:
    """Return ``e`` as SymPy simplifies it; Coq proves that it is equal."""
    import sympy

    from tresym.reals.decisions.antiderivatives import _InSympy

    names = {s: sympy.Symbol(s, real=True, positive=s == "t") for s in symbols(e)}
    try:
        value = _InSympy(sympy, names).value(e)
        return from_sympy(sympy.powsimp(sympy.cancel(sympy.together(value))))
    except Exception:  # SymPy's own faults are not ours to name
        return e
