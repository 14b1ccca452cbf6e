"""Prove a claim from lemmas, each of which is one relation that a tactic closes.

Three plans are tried. The first, for a claim that is another one with values put in, applies the
theorem of that claim. The second substitutes the definitions and lets the tactics prove the
statement directly. The third follows the claim's own chain: each step is a lemma, with the
equations of the claims it names as premises; these premises follow from the theorems of those
claims.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import islice
from typing import Any

from tresym.coq.candidate_search import proofs
from tresym.coq.equations import exchanged, nodes, quarters
from tresym.coq.export import conjoined
from tresym.coq.implicit_statements import Implicit
from tresym.coq.inequalities import QUICK, by_intervals
from tresym.coq.ledger_statements import (
    Exported,
    Joint,
    free,
    in_one_form,
    name_of,
    read,
    relations,
    stem,
    theorem_of,
)
from tresym.coq.reductions import known
from tresym.coq.solution_statements import Along, constancy
from tresym.coq.statement import (
    ATOM,
    FUNCTIONS,
    Formula,
    NotExportedError,
    Some,
    Theorem,
    formula,
    term,
    variable,
)
from tresym.coq.structural_signs import manifest_proofs
from tresym.coq.theorem_form import arranged
from tresym.coq.theorem_trees import defined, inside, put_at, values_of
from tresym.coq.witness_points import point_proofs
from tresym.ledger.claim import Chain, Claim, Definition, Instance, Reason, Root
from tresym.ledger.conversion import stage
from tresym.ledger.paper import file_of
from tresym.reals.language.binders import elementary, worked_out
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, apply, number, sqrt, symbol, symbols
from tresym.reals.language.formula import Conjunction, Equivalence, Relation
from tresym.reals.numbers.exact import InputError


@dataclass(frozen=True)
class Plan:
    """A proof plan: lemmas, a script that uses them, labels of claims whose theorems it applies."""

    lemmas: tuple[Theorem, ...]
    script: str
    uses: tuple[str, ...] = ()


def plans(claim: Claim, whole: Exported) -> Iterator[Plan]:
    """Yield the plans to try for a claim, the most likely first.

    A hand-written script in ``proofs/coq`` comes before the generated ones.
    """
    if isinstance(whole, Joint):
        labels = tuple(part.label for part in whole.parts)
        yield Plan((), f"exact {conjoined([name_of(label) for label in labels])}.", labels)
        return
    path = file_of("coq") / f"{claim.label}.v"
    if path.is_file():
        script = path.read_text(encoding="utf-8").rstrip()
        found = dict.fromkeys(re.findall(r"\bclaim_(\w+)", script))
        yield Plan(
            (), script, tuple(used.label for used in claim.rests_on if stem(used.label) in found)
        )
    if isinstance(whole, Implicit):
        return  # none is generated
    if isinstance(whole, Along):
        yield Plan((), constancy(whole))
        return
    if whole.exists:
        yield from (Plan((), script) for script in point_proofs(claim, whole))
    else:
        for steps, every in ((False, False), (True, False), (True, True)):
            try:
                if isinstance(claim.proof, Instance) and not steps:
                    yield _Planner(claim, whole, steps, every).instance(claim.proof)
                yield _Planner(claim, whole, steps, every).plan()
            except (NotExportedError, InputError, OverflowError, RecursionError, _NoPlanError):
                continue


def _pattern(says: Formula, name: str) -> str:
    """Return the intro pattern that destructs a conjunction, but none of its equations."""
    if not isinstance(says, Conjunction):
        return name
    first, *rest = (_pattern(part, f"{name}_{n}") for n, part in enumerate(says.parts, 1))
    for n, part in enumerate(rest, 1):
        first += f" {'[' if n < len(rest) else ''}{part}"
    return f"[{first}{']' * len(rest)}"


class _NoPlanError(Exception):
    """This plan does not apply to the claim."""


@dataclass
class _Planner:
    """The state of a plan under construction."""

    claim: Claim
    whole: Theorem
    steps: bool
    every: bool = False
    """Whether a step has all definitions and not only those that it names."""
    lemmas: list[Theorem] = field(default_factory=list)
    uses: dict[str, None] = field(default_factory=dict)
    facts: dict[str, tuple[Relation, ...]] = field(default_factory=dict)
    head: list[str] = field(default_factory=list)
    posed: list[str] = field(default_factory=list)

    def instance(self, proof: Instance) -> Plan:
        """Return the plan that applies the theorem of a general claim to values."""
        general = theorem_of(proof.claim)
        values = {str(x): term(in_one_form(e), ATOM) for x, e in proof.values}
        if not isinstance(general, Theorem) or general.exists:
            raise _NoPlanError
        if not {*general.variables} <= {*values, *self.whole.variables}:
            raise _NoPlanError
        for used in proof.cited:
            self.fact(used)
        self.uses[proof.claim.label] = None
        places = [values.get(name, variable(name)) for name in general.variables]
        asked = len(general.definitions) + len(general.given) + len(general.defined)
        lines = [
            *self.beginning(),
            f"pose proof ({' '.join([name_of(proof.claim.label), *places])}) as W_0.",
            *["specialize (W_0 ltac:(first [give | reflexivity]))."] * asked,
            "first [exact W_0 | lra | match goal with |- ?G => let T := type of W_0 in "
            "replace G with T; "
            "[exact W_0 | repeat first [reflexivity | ring | (field; side) | f_equal]] end].",
        ]
        return Plan((), "\n".join(lines), tuple(self.uses))

    def beginning(self) -> list[str]:
        """Return the sentences that introduce the premises and the facts of the used claims."""
        whole = self.whole
        names = [*map(variable, whole.variables)]
        counts = (len(whole.definitions), len(whole.given), len(whole.defined))
        for letter, count in zip("DGN", counts, strict=True):
            names += [f"{letter}_{n + 1}" for n in range(count)]
        cases = [
            f"try pose proof (D_{n}{' ltac:(give)' * len(asked)})."
            for n, (asked, _) in enumerate(whole.definitions, 1)
            if asked
        ]
        first = [f"intros {' '.join(names)}."] if names else []
        return [*first, *cases, *self.head, *cases]

    def plan(self) -> Plan:
        """Return the complete plan."""
        whole = self.whole
        body = self.shown(whole.says, ())
        text = "\n".join([*self.beginning(), body])
        return Plan(tuple(self.lemmas), text, tuple(self.uses))

    def shown(self, says: Formula, chain: Chain, entry: int = 0) -> str:
        """Return a script that proves the formula."""
        match says:
            case Conjunction(parts):
                return _split([self.shown(part, chain, n) for n, part in enumerate(parts)])
            case Relation():
                return self.relation(says, chain, entry)
            case Equivalence(Relation() as first, Relation() as second):
                return self.equivalence(first, second, chain)
            case Some(names, inner):
                return self.witness(names, inner)
        raise _NoPlanError

    def witness(self, names: tuple[str, ...], says: Formula) -> str:
        """Return a script for the existence of a defined value."""
        parts = says.parts if isinstance(says, Conjunction) else (says,)
        values: dict[str, Expr] = {}
        for part in parts:
            if not isinstance(part, Relation) or part.left.op != "symbol":
                raise _NoPlanError
            if part.right.op == "integral":
                values[part.left.args[0]] = part.right
                continue
            if not elementary(part.right):
                raise _NoPlanError
            values[part.left.args[0]] = exchanged(
                part.right, {symbol(n): v for n, v in values.items()}
            )
        texts = ", ".join(f"({term(values[name])})" for name in names)
        return f"exists {texts}; repeat split; first [reflexivity | integrable]."

    def relation(self, says: Relation, chain: Chain, entry: int) -> str:
        """Return a script for a relation whose integrals and derivatives must be shown to exist."""
        bare, names = values_of(says)
        if not names:
            return self.bare(says, chain, entry)
        values, scripts = {}, []
        for node, name in names.items():
            if node.op != "derivative":
                raise _NoPlanError
            value, script = self.derivative(node)
            values[name] = value
            scripts.append(script)
        related = Relation(exchanged(bare.left, values), says.sign, exchanged(bare.right, values))
        direct = says.sign == "==" and len(names) == 1
        for side, other in ((bare.left, bare.right), (bare.right, bare.left)):
            ((node, name), *_) = names.items()
            if direct and side == name and name.args[0] not in symbols(other):
                equal = Relation(values[name], "==", other)
                text = self.bare(equal, chain, entry)
                return f"apply (d_eq _ _ ({term(values[name])})).\n{{ {scripts[0]} }}\n{{ {text} }}"
        text = self.bare(related, chain, entry)
        for script in reversed(scripts):
            text = f"split.\n{{ {script} }}\n{{ {text} }}"
        given = ", ".join(f"({term(values[name])})" for name in names.values())
        return f"exists {given}.\n{text}"

    def derivative(self, node: Expr) -> tuple[Expr, str]:
        """Return the value of a derivative, and a script that proves it."""
        (bound,), body = inside(node)
        place = node.args[1]
        if not elementary(body):
            raise _NoPlanError
        value = differentiate(body, bound)
        at = symbol(bound)
        says = Relation(Expr("derivative", (node.args[0], at), node.names), "==", value)
        parts = [(e, ">" if sign == ">=" else sign) for e, sign in defined(says.left)]
        parts += defined(value)
        lemma = self.lemma(says, extra=parts)
        actual = {bound: f"({term(place)})"}
        return exchanged(value, {at: place}), self.applied(lemma, actual)

    def bare(self, says: Relation, chain: Chain, entry: int) -> str:
        """Return a script for a relation without integrals and derivatives."""
        if not elementary(put_at(says.left), put_at(says.right)):
            says = Relation(worked_out(says.left), says.sign, worked_out(says.right))
            text = self.bare(says, chain, entry)
            return f"enough (W : {formula(says)}) by (worked_out W).\n{text}"
        if self.steps and chain:
            return self.chain(says, chain, entry)
        return self.applied(self.lemma(says))

    def lemma(
        self,
        says: Relation,
        extra: Iterable[tuple[Expr, str]] = (),
        rules: Iterable[Relation] | None = None,
        more: Iterable[Relation] = (),
    ) -> Theorem:
        """Add a lemma under the claim's conditions and definitions, or under ``rules``."""
        whole = self.whole
        if rules is None:
            rules = [
                meaning
                for _, meaning in whole.definitions
                if meaning.left.op == "symbol" and elementary(meaning.left, meaning.right)
            ]
        once = {rule.left: rule for rule in reversed([*rules]) if rule.sign == "=="}
        ranges = [m for asked, m in whole.definitions if m.sign != "==" and not asked]
        given = tuple(dict.fromkeys((*more, *ranges, *whole.given)))
        parts = tuple(dict.fromkeys((*(p for p in extra if symbols(p[0])), *whole.defined)))
        sides = [e for x, _, y in given for e in (x, y)] + [e for e, _ in parts]
        used = frozenset().union(free(says), *map(symbols, sides))
        retained: list[Relation] = []
        for rule in reversed([*once.values()]):
            if symbols(rule.left) & used:
                used |= symbols(rule.right)
                retained.insert(0, rule)
        name = f"{stem(self.claim.label)}_{len(self.lemmas) + 1}"
        lemma = Theorem(
            name, tuple(sorted(used)), tuple(((), rule) for rule in retained), given, parts, says
        )
        self.lemmas.append(lemma)
        return lemma

    def applied(self, lemma: Theorem, actual: Mapping[str, str] | None = None) -> str:
        """Return a script that applies the lemma and proves its premises."""
        actual = actual or {}
        names = [actual.get(name, variable(name)) for name in lemma.variables]
        return f"apply ({' '.join([lemma.name, *names])}); give."

    def chain(self, says: Relation, chain: Chain, entry: int) -> str:
        """Return a script that follows the claim's steps; an inequality ends at a provable sign."""
        equal = says.sign == "=="
        upward = says.upward
        current = says.left if equal else upward.left - upward.right
        goal = says.right if equal else None
        lines: list[str] = []
        names: list[str] = []
        reasons: tuple[Reason, ...] = ()

        def move(after: Expr) -> None:
            nonlocal current
            if term(current) != term(after):
                rules, facts = self.reasons(reasons)
                lemma = self.lemma(Relation(current, "==", after), rules=rules, more=facts)
                names.append(f"E_{len(names) + 1}")
                lines.append(
                    f"assert ({names[-1]} : {term(current)} = {term(after)}) "
                    f"by ({self.applied(lemma)[:-1]})."
                )
            current = after

        for link in chain:
            reasons = link.reasons
            if any(r.function is not None for r in reasons) and not equal:
                raise _NoPlanError
            if link.expression is None:
                if goal is not None:
                    move(goal)
                continue
            found = _stage(link.expression)
            if isinstance(found, Relation):
                raise _NoPlanError
            move(worked_out(found[entry]))
        if goal is not None:
            move(goal)
            if not names:
                return "reflexivity."
            return "\n".join([*lines, f"exact {_transitive(names)}."])
        rules, facts = self.reasons(reasons)
        sign = ">=" if upward.sign == ">=" else ">" if upward.sign == ">" else upward.sign
        lemma = self.lemma(Relation(current, sign, ZERO), rules=rules, more=facts)
        lines.append(f"assert (S : {formula(lemma.says)}) by ({self.applied(lemma)[:-1]}).")
        return "\n".join([*lines, "lra."])

    def reasons(self, reasons: Iterable[Reason]) -> tuple[list[Relation], list[Relation]]:
        """Return what the named claims state: equations for symbols, and other relations."""
        rules: list[Relation] = []
        facts: list[Relation] = []
        for reason in reasons:
            for used in reason.claims:
                for part in self.fact(used):
                    if not elementary(part.left, part.right):
                        continue
                    if part.sign == "==" and part.left.op == "symbol":
                        rules.append(part)
                    else:
                        facts.append(part)
        if self.every:
            meanings = (m for _, m in self.whole.definitions if elementary(m.left, m.right))
            rules += [m for m in meanings if m.left.op == "symbol" and m.sign == "=="]
        return rules, facts

    def fact(self, used: Claim) -> tuple[Relation, ...]:
        """Return what a used claim states; its proof is put at the head of the script."""
        if used.label in self.facts:
            return self.facts[used.label]
        self.facts[used.label] = ()
        if isinstance(used.proof, Definition | Root):
            parts = [
                meaning
                for _, meaning in self.whole.definitions
                if used.statement is not None and meaning in [*relations(read(used.statement))]
            ]
            self.facts[used.label] = tuple(parts)
            return self.facts[used.label]
        try:
            theorem = theorem_of(used)
        except NotExportedError:
            return ()
        if not isinstance(theorem, Theorem) or theorem.exists:
            return ()
        says = [*relations(theorem.says)]
        if not says:
            return ()
        known = {*self.whole.variables, *self.posed}
        for name in theorem.variables:
            if name not in known:
                meaning = next(
                    (m.right for _, m in theorem.definitions if m.left == symbol(name)), None
                )
                if meaning is None or not elementary(meaning) or not symbols(meaning) <= known:
                    return ()
                self.head.append(f"pose ({variable(name)} := {term(meaning)}).")
                self.posed.append(name)
                known.add(name)
        names = " ".join([name_of(used.label), *map(variable, theorem.variables)])
        fact = f"F_{len(self.facts)}"
        self.head.append(f"assert ({fact} : {formula(theorem.says)}) by (apply ({names}); give).")
        if len(says) > 1:
            self.head.append(f"destruct {fact} as {_pattern(theorem.says, fact)}.")
        self.uses[used.label] = None
        self.facts[used.label] = tuple(says)
        return tuple(says)

    def equivalence(self, first: Relation, second: Relation, chain: Chain) -> str:
        """Return a script that transforms one equation into the other by injective operations."""
        if not chain:
            raise _NoPlanError
        last = chain[-1].expression
        turned = last is not None and _stage(last) == first
        current, goal = (second, first) if turned else (first, second)
        lines: list[str] = []
        names: list[str] = []
        steps = [(link.reasons, link.expression) for link in chain]
        if turned or steps[-1][1] is None or _stage(steps[-1][1]) == goal:
            pass
        else:
            steps.append(((), None))
        for reasons, expression in steps:
            after = goal if expression is None else _stage(expression)
            if not isinstance(after, Relation):
                raise _NoPlanError
            rules, facts = self.reasons(reasons)
            hole, left, right, back = "z", current.left, current.right, []
            for reason in reasons:
                if reason.term is not None:
                    t = in_one_form(reason.term)
                    left, right = Expr("+", (left, t)), Expr("+", (right, t))
                    hole = f"({hole} + {term(t, 1)})"
                    back.append("apply Rplus_eq_reg_r in K_0.")
                if reason.factor is not None:
                    c = in_one_form(reason.factor)
                    left, right = Expr("*", (left, c)), Expr("*", (right, c))
                    hole = f"({hole} * {term(c, 2)})"
                    unlike = self.lemma(Relation(c, "!=", ZERO), rules=rules, more=facts)
                    back.append(f"apply Rmult_eq_reg_r in K_0; [| {self.applied(unlike)[:-1]}].")
                if reason.function is not None:
                    if reason.function not in INJECTIVE:
                        raise _NoPlanError
                    name, asks = INJECTIVE[reason.function]
                    shown = ""
                    for side in (left, right) if asks else ():
                        lemma = self.lemma(Relation(side, asks, ZERO), rules=rules, more=facts)
                        shown += (
                            f" | apply Rgt_lt; {self.applied(lemma)[:-1]}"
                            if asks == ">"
                            else (f" | apply Rge_le; {self.applied(lemma)[:-1]}")
                        )
                    left_over = f"; [{shown}]" if asks else ""
                    back.append(f"apply {name} in K_0{left_over}.")
                    if reason.function == "square":
                        left, right, hole = left**2, right**2, f"(({hole}) ^ 2)"
                    else:
                        f = {"sqrt": sqrt}.get(reason.function, partial(apply, reason.function))
                        left, right = f(left), f(right)
                        coq = "sqrt" if reason.function == "sqrt" else FUNCTIONS[reason.function]
                        hole = f"({coq} {hole})"
            equal = []
            for side, arrived in ((left, after.left), (right, after.right)):
                if term(side) == term(arrived):
                    equal.append("eq_refl")
                    continue
                lemma = self.lemma(Relation(side, "==", arrived), rules=rules, more=facts)
                name = f"E_{len(self.lemmas)}"
                lines.append(
                    f"assert ({name} : {term(side)} = {term(arrived)}) "
                    f"by ({self.applied(lemma)[:-1]})."
                )
                equal.append(name)
            there = f"(f_equal (fun z : R => {hole}) H_0)"
            names.append(f"I_{len(names) + 1}")
            lines.append(
                f"assert ({names[-1]} : {formula(current)} <-> {formula(after)}).\n"
                f"{{ split; intro H_0.\n"
                f"  {{ exact (eq_trans (eq_sym {equal[0]}) (eq_trans {there} {equal[1]})). }}\n"
                f"  {{ pose proof (eq_trans {equal[0]} (eq_trans H_0 (eq_sym {equal[1]})))"
                f" as K_0.\n    {' '.join(reversed(back))} exact K_0. }} }}"
            )
            current = after
        if current != goal:
            raise _NoPlanError
        whole = names[-1]
        for name in reversed(names[:-1]):
            whole = f"(iff_trans {name} {whole})"
        return "\n".join([*lines, f"exact {f'(iff_sym {whole})' if turned else whole}."])


INJECTIVE = {
    "exp": ("same_exp", ""),
    "sinh": ("same_sinh", ""),
    "tanh": ("same_tanh", ""),
    "atan": ("same_atan", ""),
    "log": ("same_ln", ">"),
    "sqrt": ("same_sqrt", ">="),
    "square": ("same_square", ">="),
}
"""That a function is one-to-one, and the sign that both sides must have."""


def _split(scripts: list[str]) -> str:
    """Return a script that proves a conjunction part by part."""
    if not scripts:
        return "exact I."
    text = scripts[-1]
    for one in reversed(scripts[:-1]):
        text = f"split.\n{{ {one} }}\n{{ {text} }}"
    return text


def _transitive(names: list[str]) -> str:
    first, *rest = names
    return f"(eq_trans {first} {_transitive(rest)})" if rest else first


def candidates(lemma: Theorem) -> Iterator[str]:
    """Yield proofs of a lemma to try: a hand-written one, then others without definitions."""
    path = file_of("coq") / f"{lemma.name}.v"
    if path.is_file():
        yield path.read_text(encoding="utf-8").rstrip()
    if lemma.definitions:
        plain, intros = without_definitions(lemma)
        for proof in candidates(plain):
            yield proof.replace("intros", intros, 1)
        return
    rewritten = {
        x: y
        for x, relation, y in lemma.given
        if relation == "==" and (x.op in FUNCTIONS or x.op == "^") and x not in nodes([y])
    }
    if rewritten and lemma.by is None:
        lines = "".join(
            f" match goal with H : {term(e)} = _ |- _ => try rewrite H in *; clear H end."
            for e in rewritten
        )
        retained = replace(lemma, given=tuple(c for c in lemma.given if c[0] not in rewritten))
        for proof in islice(candidates(_put_in(retained, rewritten)), 4):
            yield f"intros.{lines} {proof}"
    turns = turned(lemma)
    if turns and lemma.by is None:
        lines = " ".join(
            f"try (assert (T_0 : {term(e)} = {term(value)}) by ({by}); "
            "rewrite T_0 in *; clear T_0)."
            for e, value, by in turns
        )
        values = {e: value for e, value, _ in turns}
        for proof in islice(candidates(_put_in(lemma, values)), 3):
            yield f"intros. {lines} {proof}"
    if lemma.relation != "==":
        if next(by_intervals(lemma, known(lemma)), None):
            yield "intros; saturate; weakly; numeric."
        yield QUICK
        yield from islice(manifest_proofs(lemma), 4)
    yield from proofs(lemma)


def without_definitions(lemma: Theorem) -> tuple[Theorem, str]:
    """Substitute the definitions of a lemma; return it with the tactic that does the same."""
    meanings = {meaning.left: meaning.right for _, meaning in lemma.definitions}
    if not meanings:
        return lemma, "intros"
    return _put_in(lemma, meanings), f"intros; subst {' '.join(map(term, meanings))}"


def turned(lemma: Theorem) -> list[tuple[Expr, Expr, str]]:
    """Return rules for sines and cosines of angles shifted by multiples of π/2, with proofs."""
    found = []
    sides = [lemma.left, lemma.right, *(e for e, _ in lemma.defined)]
    for e in nodes(sides):
        if e.op not in ("sin", "cos"):
            continue
        v, n = quarters(e.args[0])
        turned_back = v.op == "*" and v.args[0] == number(-1)
        base = -v if turned_back else v
        if (not n and not turned_back) or base.op in ("+", "number"):
            continue
        sine, cosine = apply("sin", base), apply("cos", base)
        sine = -sine if turned_back else sine
        for _ in range(n % 4):
            sine, cosine = cosine, -sine
        whole = ("- " if turned_back else "") + term(base, 3)
        whole += (" + PI / 2" if n > 0 else " + - (PI / 2)") * abs(n)
        by = f"replace {term(e.args[0], 3)} with ({whole}) by field; angles"
        found.append((e, sine if e.op == "sin" else cosine, by))
    return found


def _put_in(lemma: Theorem, meanings: Mapping[Expr, Expr]) -> Theorem:
    """Return the lemma with its definitions substituted, keeping parentheses."""

    def whole(e: Expr) -> Expr:
        for _ in range(20):
            after = exchanged(e, dict(meanings))
            if after == e:
                break
            e = after
        return e

    given = tuple(Relation(whole(x), relation, whole(y)) for x, relation, y in lemma.given)
    parts = tuple((whole(e), sign) for e, sign in lemma.defined)
    names = tuple(name for name in lemma.variables if symbol(name) not in meanings)
    conclusion = lemma.says
    assert isinstance(conclusion, Relation)
    if lemma.by is None:
        conclusion = Relation(whole(conclusion.left), conclusion.sign, whole(conclusion.right))
    else:
        conclusion = Relation(
            exchanged_under(conclusion.left, whole), conclusion.sign, whole(conclusion.right)
        )
    return Theorem(f"{lemma.name}_put", names, (), given, parts, conclusion)


def exchanged_under(node: Expr, whole: object) -> Expr:
    """Substitute definitions into the function under a derivative."""
    body = node.args[0]
    return Expr(node.op, (whole(body), *node.args[1:]), node.names)  # type: ignore[operator]


def _stage(e: Any) -> Relation | tuple[Expr, ...]:
    """Return the stage that a step states, each expression in one form."""
    found = stage(e)
    if isinstance(found, Relation):
        return Relation(arranged(found.left), found.sign, arranged(found.right))
    return tuple(map(arranged, found))
