"""Prove orders and limits along a path in Coq, by the limit of a quotient.

``f == O(g)`` follows from a finite limit of ``f/g``, ``o`` from the limit 0, ``~`` from 1, and so
on. Every end of a path is moved to a variable that tends to 0 from above; there the limit is found
by expansions in its powers, or as `limit_proofs` finds limits. For a sequence the limit is that of
a function of a real number.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from tresym.coq.bound_statements import AND, BoundTheorem, extended, filter_of, naturally
from tresym.coq.equations import nodes
from tresym.coq.expansion_proofs import LENGTHS, Expansions, NoExpansionError, T, placed
from tresym.coq.limit_proofs import INFINITE, Limits, StuckLimitError, simplified
from tresym.coq.statement import ATOM, condition, term, variable
from tresym.reals.domain.operation_domains import needs
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.comparisons import LIMIT
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    multiply,
    number,
    power,
    replaced,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import InputError

QUOTIENTS = {
    "O": "refine (O_of_limit {f} {g} {l} _ _).",
    "o": "intros eps Eps; refine (o_of_limit {f} {g} _ _ eps Eps).",
    "~": "intros eps Eps; refine (like_of_limit {f} {g} _ _ eps Eps).",
    "Theta": "refine (Theta_of_limit {f} {g} {l} _ _ _).\n{{ g_side. }}",
    "omega": "intros C; refine (omega_of_limit {f} {g} _ _ C).",
}
"""How an order follows from the limit of a quotient."""
NEEDED = {"o": "0", "~": "1", "omega": "0"}
"""The limit that it must have."""
EQUAL = "{ apply f_equal; cbv beta; first [g_poly | equal_numbers]. }"
RADII = {"1": "1", "(1 / 4)": "5", "(1 / 100)": "100"}


@dataclass(frozen=True)
class End:
    """One side of a path, as a variable t > 0 that tends to 0.

    Attributes:
        at: the variable of the path, in terms of t.
        limit: what turns a limit there into one as t -> 0.
        near: what turns a statement that holds near there into one for small t.
    """

    at: Expr
    limit: str
    near: str


def ends(path: Path, squared: bool) -> list[End]:
    """Return the sides of a path.

    Args:
        path: the path.
        squared: whether t is the root of the distance from its end.
    """
    found = []
    t = Expr("^", (T, number(2))) if squared else T
    step = ("apply ends_square; ", "apply near_from_square; ") if squared else ("", "")
    for side in path.sides:
        if path.point is None:
            away = Expr("^", (t, MINUS_ONE))
            at = away if side > 0 else Expr("*", (MINUS_ONE, away))
            below = ("", "") if side > 0 else ("apply ends_below; ", "apply near_from_below; ")
            laws = f"{below[0]}apply to_infinity; ", f"{below[1]}apply near_from_infinity; "
        elif path.point == ZERO and side > 0:
            at, laws = t, ("", "")
        else:
            moved = t if side > 0 else Expr("*", (MINUS_ONE, t))
            at = Expr("+", (path.point, moved))
            kind = "right" if side > 0 else "left"
            laws = f"apply ends_{kind}; ", f"apply near_from_{kind}; "
        found.append(End(at, f"{laws[0]}{step[0]}cbv beta.", f"{laws[1]}{step[1]}cbv beta."))
    return found


def _both(proofs: list[str], law: str) -> str:
    """Return the proof for all sides of a path."""
    if not proofs:
        return ""
    return proofs[0] if len(proofs) == 1 else f"apply {law}.\n{{ {proofs[0]} }}\n{{ {proofs[1]} }}"


def path_proofs(theorem: BoundTheorem, head: str) -> Iterator[str]:
    """Yield proofs of a limit or an order.

    Args:
        theorem: the theorem.
        head: the sentence that introduces its variables and premises.
    """
    plain, squared = Along(theorem, head), Along(theorem, head, squared=True)
    together = Along(theorem, head, merged=True)
    for proof in (plain, *([together] if together.logarithms else []), squared):
        quick = theorem.claim.relation == LIMIT and not proof.whole
        if quick and proof == plain:
            yield from proof.by_parts("1")
        for order in LENGTHS:
            try:
                yield proof.by_expansions(order)
                break
            except (NoExpansionError, InputError):
                continue
        if proof.squared:
            for radius in list(RADII)[quick:]:
                yield from proof.by_parts(radius)
            yield from proof.by_waves()


@dataclass(frozen=True)
class Along:
    """The proof of a limit or an order.

    Attributes:
        theorem: the theorem.
        head: the sentence that introduces its variables and premises.
        squared: whether the root of the distance from the end is the variable of expansions.
        merged: whether differences of logarithms are taken as logarithms of quotients.
    """

    theorem: BoundTheorem
    head: str
    squared: bool = False
    merged: bool = False

    @property
    def path(self) -> Path:
        """The path."""
        assert self.theorem.statement.path is not None
        return self.theorem.statement.path

    @property
    def whole(self) -> bool:
        """Whether it is a sequence."""
        return "eventually" in self.theorem.says[-1]

    @property
    def sides(self) -> tuple[Expr, Expr]:
        """What is divided, and by what."""
        claim = self.theorem.claim
        pair = claim.left, claim.right
        return pair[::-1] if claim.relation == "omega" else pair

    @property
    def function(self) -> Expr:
        """The function whose limit is needed."""
        f, g = self.sides
        limit = self.theorem.claim.relation == LIMIT
        return f if limit else Expr("*", (f, Expr("^", (g, MINUS_ONE))))

    @property
    def logarithms(self) -> dict[Expr, tuple[Expr, Expr, Expr]]:
        """What differences ``c log(u) - c log(v)`` become, each with u and v and itself."""
        f = self.theorem.claim.left
        terms = [(_logarithm(e), e) for e in (f.args if f.op == "+" else ())]
        found: dict[Expr, tuple[Expr, Expr, Expr]] = {}
        known = [(c, u, e) for (c, u), e in terms if u is not None]
        while known:
            c, u, e = known.pop(0)
            for d, v, other in known:
                if c == -d:
                    inner = Expr("*", (u, Expr("^", (v, MINUS_ONE))))
                    found[Expr("*", (c, Expr("log", (inner,))))] = (u, v, Expr("+", (e, other)))
                    known.remove((d, v, other))
                    break
        return found

    def together(self) -> Expr:
        """Return the function with its differences of logarithms merged."""
        if not self.merged:
            return self.function
        f = self.theorem.claim.left
        gone = [e for _, _, pair in self.logarithms.values() for e in pair.args]
        rest = [*self.logarithms, *(e for e in f.args if e not in gone)]
        whole = rest[0] if len(rest) == 1 else Expr("+", tuple(rest))
        return replaced(self.function, {f: whole}) if f != self.function else whole

    def _merging(self, found: Expansions, sides: list[End], value: Expr) -> str:
        """Return the step to the function with its differences of logarithms merged."""
        if not self.merged:
            return ""
        x = variable(self.path.name)
        before = [f"(fun {x} : R => {term(e)})" for e in (self.together(), self.function)]
        where = "(Rbar_locally p_infty)" if self.whole else filter_of(self.path)
        near = [self._equal(found, end) for end in sides]
        return (
            f"apply (t_beside {where} {before[0]} {before[1]} {extended(value)}).\n"
            f"{{ {_both(near, 'near_from_both')} }}\n"
        )

    def _equal(self, found: Expansions, end: End) -> str:
        """Return the proof that nothing changes near an end: ``ln (u / v) = ln u - ln v``."""
        script, laws, names = end.near, list[str](), list[str]()
        for u, v, _ in self.logarithms.values():
            there = [placed(e, self.path.name, end.at) for e in (u, v)]
            pair = [f"P{len(names) + k}" for k in range(2)]
            for e, name in zip(there, pair, strict=True):
                script += f"\nassert ({name} : at_right 0 (fun t : R => 0 < {term(e)}))."
                script += f"\n{{ {found.holds(e, '>')} }}"
            laws.append(" ".join(["ln_div", *(term(e, ATOM) for e in there), *pair]))
            names += pair
        both, shape = names[-1], names[-1]
        for name in reversed(names[:-1]):
            both, shape = f"(filter_and _ _ {name} {both})", f"[{name} {shape}]"
        steps = "; ".join(
            f"pose proof ({law}) as L{k}; unfold Rdiv in L{k}; rewrite L{k}"
            for k, law in enumerate(laws)
        )
        return (
            f"{script}\ngeneralize {both}; clear {' '.join(names)}; apply filter_imp; "
            f"intros t {shape}; {steps}; ring."
        )

    def by_expansions(self, order: int) -> str:
        """Return a proof by expansions in powers of t.

        Raises:
            NoExpansionError: there is none of this length.
        """
        claim, name = self.theorem.claim, self.path.name
        if "t" in self.theorem.reals:
            raise NoExpansionError
        found = Expansions(self.theorem.statement.given, order)
        limits, aparts, values = [], [], []
        sides = ends(self.path, self.squared)
        for end in sides:
            value, script = found.tends(placed(self.together(), name, end.at))
            values.append(value)
            equal = "" if value in INFINITE else EQUAL
            limits.append(f"{end.limit}\n{script}{equal}")
            if claim.relation != LIMIT:
                apart = found.holds(placed(self.sides[1], name, end.at), "!=")
                aparts.append(f"{end.near}\n{apart}")
        if len({*values}) > 1 or not self._serves(values[0]):
            raise NoExpansionError
        parts = [
            (
                condition(e, sign),
                [f"{end.near}\n{found.holds(placed(e, name, end.at), sign)}" for end in sides],
            )
            for e, sign in self._parts()
        ]
        shown = _all([(text, _both(near, "near_from_both")) for text, near in parts], name)
        limit = self._merging(found, sides, values[0]) + _both(limits, "ends_both")
        last = self._last(values[0], _both(aparts, "near_from_both"), limit)
        return "\n".join([self.head + "\n".join(found.lines), self._split(shown), last])

    def by_parts(self, radius: str) -> Iterator[str]:
        """Yield a proof by the limits of parts, or by L'Hôpital's rule."""
        claim, path = self.theorem.claim, self.path
        search = Limits(self.theorem.statement.given, radius, RADII[radius])
        try:
            value = self._value()
            if not self._serves(value):
                return
            script = search.along(self._quotient(), path, value)
        except StuckLimitError:
            return
        near = f"{search.defined(path)} repeat split; apart_."
        apart = near if claim.relation != LIMIT else ""
        last = self._last(value, apart, script)
        yield "\n".join([self.head, self._split(near), last])

    def by_waves(self) -> Iterator[str]:
        """Yield a proof of O(g) term by term, with sines and cosines bounded by 1."""
        claim = self.theorem.claim
        summands = claim.left.args if claim.left.op == "+" else (claim.left,)
        split = [_wave(e) for e in summands]
        if claim.relation != "O" or all(wave is None for wave, _ in split):
            return
        x, kind = variable(self.path.name), "nat" if self.whole else "R"
        names = {self.path.name} if self.whole else set()

        def shown(e: Expr) -> str:
            return f"(fun {x} : {kind} => {term(naturally(e, names))})"

        g = shown(claim.right)
        proofs, texts = [], []
        for wave, rest in split:
            proof = self._of(rest)
            if proof is None:
                return
            texts.append(rest if wave is None else Expr("*", (wave, rest)))
            if wave is not None:
                proof = (
                    f"refine (O_bounded {shown(wave)} {shown(rest)} {g} 1 _ _).\n"
                    "{ apply filter_forall; intros; apply Rabs_le; "
                    f"first [apply SIN_bound | apply COS_bound]. }}\n{{ {proof} }}"
                )
            proofs.append(proof)
        whole, script = texts[0], proofs[0]
        for text, proof in zip(texts[1:], proofs[1:], strict=True):
            law = f"refine (O_plus {shown(whole)} {shown(text)} {g} _ _)."
            script = f"{law}\n{{ {script} }}\n{{ {proof} }}"
            whole = Expr("+", (whole, text))
        search = Limits(self.theorem.statement.given, "1", "1")
        near = f"{search.defined(self.path)} repeat split; apart_."
        beside = f"refine (O_beside {shown(claim.left)} {shown(whole)} {g} _ _).\n"
        beside += "{ apply filter_forall; intros; ring. }\n"
        yield "\n".join([self.head, self._split(near), beside + script])

    def _of(self, e: Expr) -> str | None:
        """Return a proof that another function is of the same order."""
        claim = replace(self.theorem.claim, left=e)
        other = Along(replace(self.theorem, claim=claim, says=self.theorem.says[-1:]), "")
        for order in LENGTHS:
            try:
                return other.by_expansions(order)
            except (NoExpansionError, InputError):
                continue
        return next(other.by_parts("1"), None)

    def _quotient(self) -> Expr:
        """Return the function whose limit is needed, with its powers of numbers put together."""
        f, g = self.sides
        if self.theorem.claim.relation == LIMIT:
            return f
        logs, rest = [], []
        for part, sign_ in [*((e, 1) for e in factors_in(f)), *((e, -1) for e in factors_in(g))]:
            if part.op == "^" and part.args[1].op != "number":
                logs.append(multiply(number(sign_), part.args[1], apply("log", part.args[0])))
            else:
                rest.append(part if sign_ > 0 else power(part, MINUS_ONE))
        if logs:
            return multiply(*rest, apply("exp", add(*logs)))
        return simplified(multiply(*rest))

    def _value(self) -> Expr:
        """Return the limit along the path."""
        path = self.path
        if self.theorem.claim.relation == LIMIT:
            return self.theorem.claim.right
        given, whole = self.theorem.statement.given, self._quotient()
        values = {limit_of(whole, path.name, path.point, side, given) for side in path.sides}
        value = values.pop()
        if value is None or values:
            raise StuckLimitError
        return value

    def _serves(self, value: Expr) -> bool:
        """Return whether the order follows from this limit."""
        relation = self.theorem.claim.relation
        if relation == LIMIT:
            return True
        return value not in INFINITE and str(value) == NEEDED.get(relation, str(value))

    def _parts(self) -> list[tuple[Expr, str]]:
        claim = self.theorem.claim
        sides = [claim.left] if claim.relation == LIMIT else [claim.left, claim.right]
        names = {self.path.name} if self.whole else set()
        parts = needs([naturally(e, names) for e in sides])
        return [(_really(e), sign) for e, sign in parts if self.path.name in symbols(e)]

    def _split(self, near: str) -> str:
        """Return the proof that the parts are defined near the end, by that for real numbers."""
        if len(self.theorem.says) == 1:
            return ""
        if self.whole:
            x = variable(self.path.name)
            shown = AND.join(condition(*part) for part in self._parts())
            near = f"apply (along_whole (fun {x} : R => {shown})).\n{near}"
        return f"split.\n{{ {near} }}"

    def _last(self, value: Expr, apart: str, limit: str) -> str:
        """Return the proof of the order, from those that a function is not 0 and has a limit."""
        claim, x = self.theorem.claim, variable(self.path.name)
        names = {self.path.name} if self.whole else set()
        kind = "nat" if self.whole else "R"
        if self.whole:
            natural = naturally(self.function, names)
            real = f"(fun {x} : R => {term(self.function)})"
            limit = f"apply (whole_limit {real}).\n{limit}"
            if any(e.op == "power" for e in nodes([natural])):
                limit = (
                    f"apply (whole_beside _ (fun {x} : nat => {real} (INR {x}))).\n"
                    f"{{ exists 1%nat; intros {x} N; apply le_INR in N; cbn [INR] in N; "
                    f"assert (0 < INR {x}) by lra; cbv beta; rewrite ?whole_power by g_side; "
                    f"reflexivity. }}\n{limit}"
                )
            if apart:
                under = self.sides[1]
                text = term(
                    replaced(
                        under, {symbol(self.path.name): Expr("natural", (symbol(self.path.name),))}
                    )
                )
                apart = (
                    f"apply (filter_imp (fun {x} : nat => {text} <> 0)).\n"
                    f"{{ intros {x}; rewrite ?whole_power by g_side; exact (fun H => H). }}\n"
                    f"apply (along_whole (fun {x} : R => {term(under)} <> 0)).\n{apart}"
                )
        if claim.relation == LIMIT:
            return limit
        f, g = (
            f"(fun {x} : {kind} => {term(naturally(e, names))})" for e in (claim.left, claim.right)
        )
        step = QUOTIENTS[claim.relation].format(f=f, g=g, l=term(value, ATOM))
        return f"{step}\n{{ {apart} }}\n{{ {limit} }}"


def _logarithm(e: Expr) -> tuple[Expr, Expr | None]:
    """Return the factor of a logarithm, and its argument; None if there is not one logarithm."""
    parts = list(factors_in(e))
    logs = [part for part in parts if part.op == "log"]
    if len(logs) != 1:
        return e, None
    parts.remove(logs[0])
    return multiply(*parts), logs[0].args[0]


def _wave(e: Expr) -> tuple[Expr | None, Expr]:
    """Return a sine or cosine that is a factor, if there is one, and the other factors."""
    parts = list(factors_in(e))
    wave = next((part for part in parts if part.op in ("sin", "cos")), None)
    if wave is not None:
        parts.remove(wave)
    return wave, multiply(*parts)


def _all(parts: list[tuple[str, str]], name: str) -> str:
    """Return the proof that all of some conditions hold near an end, from those of each."""
    x, script = variable(name), ""
    for k, (text, proof) in enumerate(parts[:-1], 1):
        rest = AND.join(text for text, _ in parts[k:])
        script += f"apply (filter_and (fun {x} : R => {text}) (fun {x} : R => {rest})).\n"
        script += f"{{ {proof} }}\n"
    return script + parts[-1][1] if parts else ""


def _really(e: Expr) -> Expr:
    """Return an expression with natural numbers as real ones."""
    if e.op in LEAVES:
        return e
    if e.op == "natural":
        return e.args[0]
    return Expr(e.op, tuple(map(_really, e.args)), e.names)
