"""Print statements in Coq: the code a referee must read, beside Coq itself.

A claim becomes ``forall symbols, definitions -> given -> defined -> says`` over Coq's real numbers.
Coq's functions are total (1/0 and sqrt(-1) have values), so the conditions under which all parts
are defined are premises; integrals and derivatives are values that are stated to exist. Inside a
function that is differentiated, the arguments of roots and inverse functions must lie in the
interior of their domains. A definition that holds only under conditions of its own has these as
premises. Functions that Coq's library lacks are defined in ``Tresym.v``.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from flint import fmpq

from tresym.coq.theorem_trees import (
    Condition,
    Every,
    Fails,
    Formula,
    One,
    Part,
    Single,
    Some,
    Wherever,
    inside,
    values_of,
)
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Conjunction, Equivalence, Relation

FUNCTIONS = {name: row.coq for name, row in TABLE.items() if row.coq is not None}
"""The functions of the language by their names in Coq."""
RELATIONS = {"==": "=", "!=": "<>", ">": ">", ">=": ">=", "<": "<", "<=": "<="}
VALUES = {"integral": "RInt", "derivative": "Derive", "at": ""}
SAID = {"integral": "is_RInt", "derivative": "is_derive", "root": "is_root"}
_PLAIN = re.compile(
    r"[a-z]\d*|(alpha|beta|gamma|delta|epsilon|zeta|eta|theta|kappa|lambda|mu|nu|xi|rho|sigma|tau"
    r"|phi|chi|psi|omega)\d*"
)
SUM, PRODUCT, POWER, ATOM = range(4)


class NotExportedError(Exception):
    """This kind of claim cannot be exported to Coq yet; the text is a sentence that says why."""


def variable(name: str) -> str:
    """Return the name of a variable in Coq: injective, and never a keyword of Coq."""
    if _PLAIN.fullmatch(name):
        return name
    return "v_" + re.sub(r"\W", lambda found: f"'{ord(found[0]):x}'", name, flags=re.ASCII)


def term(e: Expr, level: int = SUM) -> str:
    """Return the expression as a Coq term, in parentheses if the context ``level`` requires them.

    Raises:
        NotExportedError: the expression contains an operation without a translation.
    """
    if e.op == "number":
        return _number(e.args[0], level)
    if e.op in ("symbol", "pi"):
        return variable(e.args[0]) if e.args else "PI"
    if e.op == "+":
        return _in_brackets(" + ".join(term(arg, PRODUCT) for arg in e.args), SUM, level)
    if e.op == "*":
        return _in_brackets(" * ".join(term(arg, POWER) for arg in e.args), PRODUCT, level)
    if e.op == "^":
        return _power(e.args[0], e.args[1], level)
    if e.op in FUNCTIONS:
        args = " ".join(term(arg, ATOM) for arg in e.args)
        return _in_brackets(f"{FUNCTIONS[e.op]} {args}", POWER, level)
    if e.op in ("natural", "factorial", "power", "count"):
        return _naturals(e, level)
    if e.op in VALUES:
        return _in_brackets(f"{VALUES[e.op]} {_function(e)}".lstrip(), POWER, level)
    raise NotExportedError(f"{e.op} is not exported to Coq yet")


def _naturals(e: Expr, level: int) -> str:
    """Translate a natural number as a real one, its factorial, a power with it, or as it is."""
    if e.op == "count":
        return _natural(e.args[0], level)
    if e.op == "power":
        return _in_brackets(f"{term(e.args[0], ATOM)} ^ {_natural(e.args[1], ATOM)}", POWER, level)
    inside = _natural(e.args[0], ATOM)
    return _in_brackets(f"INR {inside if e.op == 'natural' else f'(fact {inside})'}", POWER, level)


def _natural(e: Expr, level: int) -> str:
    """Translate a sum of natural numbers; what is added to it is written as successors."""
    if e.op == "number":
        return str(int(e.args[0].p))
    if e.op == "+":
        added = sum(int(arg.args[0].p) for arg in e.args if arg.op == "number")
        names = [_natural(arg, PRODUCT) for arg in e.args if arg.op != "number"]
        text = " + ".join(names)
        for _ in range(added):
            text = f"S {text if text.isidentifier() else f'({text})'}"
        return _in_brackets(text, SUM, level)
    if e.op == "*":
        return _in_brackets(" * ".join(_natural(arg, POWER) for arg in e.args), PRODUCT, level)
    return variable(e.args[0])


def _function(e: Expr) -> str:
    """Return the function that a binder node stands for, applied to the node's other arguments."""
    names, body = inside(e)
    function = f"(fun {' '.join(map(variable, names))} : R => {term(body)})"
    return " ".join([function, *(term(arg, ATOM) for arg in e.args[1:])])


def _in_brackets(text: str, own: int, level: int) -> str:
    return f"({text})" if own < level else text


def _number(value: fmpq, level: int) -> str:
    p, q = int(value.p), int(value.q)
    if q != 1:
        return _in_brackets(f"{p} / {q}" if p >= 0 else f"({p}) / {q}", PRODUCT, level)
    return str(p) if p >= 0 else f"({p})"


def _power(base: Expr, exponent: Expr, level: int) -> str:
    """Translate a power: repeated products, Coq's roots, or ``Rpower`` for other exponents."""
    if exponent.op != "number":
        return _in_brackets(f"Rpower {term(base, ATOM)} {term(exponent, ATOM)}", POWER, level)
    r = exponent.args[0]
    n, q = abs(int(r.p)), int(r.q)
    text, own = term(base, ATOM), ATOM
    if q != 1:
        text, own = f"{'sqrt' if q == 2 else f'root {q}'} {text}", POWER
    if n != 1:
        text, own = f"{_in_brackets(text, own, ATOM)} ^ {n}", POWER
    if r < 0:
        return _in_brackets(f"/ {_in_brackets(text, own, ATOM)}", POWER, level)
    return _in_brackets(text, own, level)


def comparison(left: Expr, relation: str, right: Expr) -> str:
    """Return the relation of two expressions as Coq text."""
    return f"{term(left)} {RELATIONS[relation]} {term(right)}"


def condition(e: Expr, relation: str) -> str:
    """Return ``e relation 0`` as Coq text; orders are written with 0 on the left."""
    return f"{term(e)} <> 0" if relation == "!=" else f"0 {relation.replace('>', '<')} {term(e)}"


def has_value(node: Expr, value: str) -> str:
    """Return that an integral or derivative exists, or a root is unique, with this value."""
    if node.op not in SAID:
        raise NotExportedError(f"{node.op} is not exported to Coq yet")
    return f"{SAID[node.op]} {_function(node)} {value}"


def formula(f: Formula) -> str:
    """Return the formula as a Coq proposition."""
    if isinstance(f, Conjunction):
        return " /\\ ".join(f"({formula(part)})" for part in f.parts) or "True"
    if isinstance(f, Equivalence):
        return f"({formula(f.first)}) <-> ({formula(f.second)})"
    if isinstance(f, Wherever):
        return "".join(f"{comparison(*c)} -> " for c in f.conditions) + formula(f.says)
    if isinstance(f, One):
        return f"exists ! {variable(f.name)} : R, {formula(f.says)}"
    if isinstance(f, Fails):
        return f"~ ({formula(f.says)})"
    if isinstance(f, Some):
        return f"exists {' '.join(map(variable, f.names))} : R, {formula(f.says)}"
    if isinstance(f, Every):
        return f"forall {' '.join(map(variable, f.names))} : R, {formula(f.says)}"
    bare, names = values_of(f)
    if f.sign == "==" and len(names) == 1:
        ((node, name),) = names.items()
        for side, other in ((bare.left, bare.right), (bare.right, bare.left)):
            if side == name and name.args[0] not in symbols(other):
                return has_value(node, term(other, ATOM))
    says = [has_value(node, term(name)) for node, name in names.items()] + [comparison(*bare)]
    exists = f"exists {' '.join(map(term, names.values()))} : R, " if names else ""
    return exists + " /\\ ".join(says)


@dataclass(frozen=True)
class Theorem(Single):
    """``forall variables, premises -> says``, or the existence of a point where all of it holds.

    ``definitions`` are equations, each with the conditions under which it holds.
    """

    name: str
    variables: tuple[str, ...]
    definitions: tuple[tuple[tuple[Condition, ...], Relation], ...]
    given: tuple[Condition, ...]
    defined: tuple[Part, ...]
    says: Formula
    exists: bool = False

    @property
    def body(self) -> str:
        """The proposition as Coq text."""
        names = " ".join(map(variable, self.variables))
        quantifier, join = ("exists", "/\\") if self.exists else ("forall", "->")
        lines = [f"  {quantifier} {names} : R,"] if names else []
        for conditions, meaning in self.definitions:
            before = "".join(f"{comparison(*c)} -> " for c in conditions)
            lines.append(f"  ({before}{formula(meaning)}) {join}  (* definition *)")
        lines += [f"  {comparison(*c)} {join}  (* given *)" for c in self.given]
        lines += [f"  {condition(*part)} {join}  (* defined *)" for part in self.defined]
        return "\n".join([*lines, f"  {formula(self.says)}"])

    @property
    def text(self) -> str:
        """The statement as a sentence of Coq."""
        return f"Theorem {self.name} :\n{self.body}."
