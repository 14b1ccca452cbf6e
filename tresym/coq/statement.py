"""Statements in Coq: what a referee reads, beside Coq itself and the statements.

A claim becomes ``forall symbols, given -> defined -> says`` over Coq's real numbers. The functions
of Coq are total, so that what makes the parts defined stands among the premises. A derivative that
is one side of an equation is ``is_derive``; its premises ask that the function be defined at the
point and beside it: strictly inside, where a root or an inverse function has an edge. What Coq's
library lacks is defined at the head of ``Tresym.v``.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from flint import fmpq

from tresym.reals.decisions.reading import ORDERS, Comparison, Statement
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.places.domain import needs

FUNCTIONS = {
    **{name: name for name in ("sign", "exp", "sin", "cos", "tan", "cot", "sec", "csc")},
    **{name: name for name in ("asin", "acos", "atan", "sinh", "cosh", "tanh", "coth", "sech")},
    **{"abs": "Rabs", "log": "ln", "cbrt": "root 3", "csch": "csch", "asinh": "arcsinh"},
    **{"acosh": "acosh", "atanh": "atanh", "atan2": "atan2"},
}
"""The functions of the language by their names in Coq."""
RELATIONS = {"==": "=", "!=": "<>", ">": ">", ">=": ">=", "<": "<", "<=": "<="}
_PLAIN = re.compile(
    r"[a-z]\d*|(alpha|beta|gamma|delta|epsilon|zeta|eta|theta|kappa|lambda|mu|nu|xi|rho|sigma|tau"
    r"|phi|chi|psi|omega)\d*"
)
SUM, PRODUCT, POWER, ATOM = range(4)


class NotExportedError(Exception):
    """A kind of claim that has no statement in Coq yet; the text is a sentence that says which."""


def variable(name: str) -> str:
    """The name of a variable in Coq: different ones for different names, and no word of Coq's."""
    if _PLAIN.fullmatch(name):
        return name
    return "v_" + re.sub(r"\W", lambda found: f"'{ord(found[0]):x}'", name, flags=re.ASCII)


def term(e: Expr, level: int = SUM) -> str:
    """The expression as a real number of Coq, in brackets where ``level`` asks for them.

    Raises:
        NotExportedError: an operation that has no translation.
    """
    if e.op == "number":
        return _number(e.args[0], level)
    if e.op == "symbol":
        return variable(e.args[0])
    if e.op == "pi":
        return "PI"
    if e.op == "+":
        return _in_brackets(" + ".join(term(arg, PRODUCT) for arg in e.args), SUM, level)
    if e.op == "*":
        return _in_brackets(" * ".join(term(arg, POWER) for arg in e.args), PRODUCT, level)
    if e.op == "^":
        return _power(e.args[0], e.args[1], level)
    if e.op in FUNCTIONS:
        args = " ".join(term(arg, ATOM) for arg in e.args)
        return _in_brackets(f"{FUNCTIONS[e.op]} {args}", POWER, level)
    raise NotExportedError(f"{e.op} is not exported to Coq yet")


def _in_brackets(text: str, own: int, level: int) -> str:
    return f"({text})" if own < level else text


def _number(value: fmpq, level: int) -> str:
    p, q = int(value.p), int(value.q)
    if q != 1:
        return _in_brackets(f"{p} / {q}" if p >= 0 else f"({p}) / {q}", PRODUCT, level)
    return str(p) if p >= 0 else f"({p})"


def _power(base: Expr, exponent: Expr, level: int) -> str:
    """Whole powers are repeated products; roots are those of Coq; all others are exponentials."""
    if exponent.op != "number":
        return _in_brackets(f"Rpower {term(base, ATOM)} {term(exponent, ATOM)}", POWER, level)
    r = exponent.args[0]
    n, q = abs(int(r.p)), int(r.q)
    if q == 1:
        text, own = (term(base, ATOM), ATOM) if n == 1 else (f"{term(base, ATOM)} ^ {n}", POWER)
    else:
        root = "sqrt" if q == 2 else f"root {q}"
        text = f"{root} {term(base, ATOM)}"
        text, own = (text, POWER) if n == 1 else (f"({text}) ^ {n}", POWER)
    if r < 0:
        return _in_brackets(f"/ {text if own == ATOM else f'({text})'}", POWER, level)
    return _in_brackets(text, own, level)


@dataclass(frozen=True)
class Theorem:
    """``forall variables, premises -> says``, or that there is a point where all of it holds.

    Attributes:
        name: the theorem's name in Coq.
        variables: the symbols in it, sorted.
        given: the claim's conditions.
        defined: what makes all parts defined.
        left, relation, right: the conclusion; with ``by``, that the derivative of ``left`` by the
            symbol ``by`` is ``right``.
    """

    name: str
    variables: tuple[str, ...]
    given: tuple[tuple[Expr, str, Expr], ...]
    defined: tuple[tuple[Expr, str], ...]
    left: Expr
    relation: str
    right: Expr
    by: str | None = None
    exists: bool = False

    @property
    def text(self) -> str:
        """The statement."""
        names = " ".join(map(variable, self.variables))
        quantifier, join = ("exists", "/\\") if self.exists else ("forall", "->")
        lines = [f"Theorem {self.name} :", *([f"  {quantifier} {names} : R,"] if names else [])]
        lines += [f"  {comparison(*condition)} {join}  (* given *)" for condition in self.given]
        lines += [f"  {condition(*part)} {join}  (* defined *)" for part in self.defined]
        return "\n".join([*lines, f"  {self.says}."])

    @property
    def says(self) -> str:
        """The conclusion."""
        if self.by is None:
            return comparison(self.left, self.relation, self.right)
        x = variable(self.by)
        return f"is_derive (fun {x} : R => {term(self.left)}) {x} {term(self.right, ATOM)}"


def comparison(left: Expr, relation: str, right: Expr) -> str:
    """A relation of two expressions."""
    return f"{term(left)} {RELATIONS[relation]} {term(right)}"


def condition(e: Expr, relation: str) -> str:
    """``e relation 0``, with 0 on the left of an order."""
    return f"{term(e)} <> 0" if relation == "!=" else f"0 {relation.replace('>', '<')} {term(e)}"


def theorems(statement: Statement, name: str = "claim") -> list[Theorem]:
    """A theorem for each comparison of a claim.

    Raises:
        NotExportedError: a kind of claim that has no statement yet.
    """
    if statement.comparisons[0].relation in ORDERS:
        raise NotExportedError("orders are not exported to Coq yet")
    count = len(statement.comparisons)
    names = [name] if count == 1 else [f"{name}_{n + 1}" for n in range(count)]
    return [
        theorem(comparison, statement.given.comparisons, name)
        for comparison, name in zip(statement.comparisons, names, strict=True)
    ]


def theorem(
    claim: Comparison, given: tuple[tuple[Expr, str, Expr], ...] = (), name: str = "claim"
) -> Theorem:
    """One comparison under conditions.

    Raises:
        NotExportedError: derivatives other than one side of an equation.
    """
    left, right, by = claim.left, claim.right, None
    parts = needs([left, right, *(side for x, _, y in given for side in (x, y))])
    if claim.derivatives:
        found, *others = claim.derivatives
        side = {left: right, right: left}.get(found.value) if claim.relation == "==" else None
        if others or found.order != 1 or side is None:
            raise NotExportedError(
                "only a first derivative that is one side of an equation is exported to Coq yet"
            )
        inside = [
            (e, ">" if sign == ">=" and found.by in symbols(e) else sign)
            for e, sign in needs([found.function])
        ]
        parts, left, right, by = [*inside, *parts], found.function, side, found.by
    parts = [part for part in dict.fromkeys(parts) if not _plain(*part)]
    used = [left, right, *(e for e, _ in parts), *(e for x, _, y in given for e in (x, y))]
    variables = frozenset().union(*map(symbols, used), {by} if by else ())
    return Theorem(
        name, tuple(sorted(variables)), given, tuple(parts), left, claim.relation, right, by
    )


def _plain(e: Expr, relation: str) -> bool:
    """Whether it says of a rational number what is seen."""
    return e.op == "number" and bool(e.args[0] > 0 or (relation == ">=" and e.args[0] == 0))
