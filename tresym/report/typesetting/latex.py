r"""Write statements in LaTeX in the paper's notation.

Expressions are written by the walk of :mod:`tresym.reals.language.typesetting`. The paper has names
of its own for symbols, an order of terms and factors (``a + b \sin^2\psi``, ``1 - b \sin^2\psi``,
``(a + b \sin^2\psi) \cos\theta``), no brackets around the argument of ``\sin\theta``, and slanted
fractions in exponents.
"""

from __future__ import annotations

from decimal import Decimal
from functools import lru_cache
from itertools import pairwise
from typing import Any

from flint import fmpq

from tresym.ledger.formulas import EqualMatrices, Rounded, Tending, Under, in_trees
from tresym.ledger.paper import racket
from tresym.reals.functions.table import CONSTANTS, TABLE
from tresym.reals.language.binders import outermost
from tresym.reals.language.compound import (
    Equivalent,
    Together,
    formula_in_latex,
    path_in_latex,
)
from tresym.reals.language.expression import (
    BINDERS,
    DOTS,
    FUNCTIONS,
    HALF,
    ONE,
    ORDERS,
    Expr,
    add,
    factors_in,
    opened,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.typesetting import (
    LATEX,
    POWER,
    PRODUCT,
    Printer,
    fraction,
    is_negative,
    opposite,
    reciprocal,
)
from tresym.reals.numbers.exact import printed

PAPER = {
    **LATEX,
    "plus": "+",
    "minus": "-",
    "of": "{}{}",
    "index": "{}_{}",
    "power": "{}^{}",
    "integral": r"\int_{low}^{high} {body}\,d{x}",
    "root": r"(\text{{the }}{x} \in ({low}, {high}):\ {body})",
}

MOST_FRACTIONS = 2
"""In an exponent that is raised; one with more stands on the line."""

_TALL = (r"\frac", r"\begin", r"\int", r"\sum")


def bracketed(body: str) -> str:
    """Return ``body`` in round brackets, which grow only if something tall is inside."""
    if any(mark in body for mark in _TALL):
        return rf"\left({body}\right)"
    return f"({body})"


class PaperPrinter(Printer):
    """The walk with products, sums, powers and functions as the paper writes them."""

    enclosing = ("root", "at")

    def __init__(self) -> None:
        """Take the templates of the paper."""
        super().__init__(PAPER)

    def put(self, template: str, *args: str, **named: str) -> str:
        """Fill in a template; a single letter that is raised or lowered needs no braces."""
        if template in ("power", "index"):
            args = args[0], _script(args[1])
        elif template == "integral":
            named |= {end: _script(named[end]) for end in ("low", "high")}
        return super().put(template, *args, **named)

    def bracketed(self, text: str) -> str:
        """A formula in brackets."""
        return bracketed(text)

    def written(self, e: Expr) -> tuple[str, int]:
        """The formula, and how strongly it binds."""
        text, strength = super().written(e)
        if e.op == "abs":
            tall = any(mark in text for mark in _TALL)
            return (text if tall else f"|{self.shown(e.args[0])}|"), strength
        # a rate is a fraction, and an exponent behind a prime would be a second one
        fragile = e.op == "symbol" and (text.startswith(r"\frac") or "'" in text)
        called = e.op in FUNCTIONS or e.op == "unknown"
        if e.op in BINDERS - {"root"}:  # each encloses what it binds
            return text, POWER if text.startswith(r"\left.") else PRODUCT
        return text, min(strength, POWER) if fragile or called else strength

    def terms(self, terms: tuple[Expr, ...]) -> tuple[Expr, ...]:
        """The terms in the order of the paper."""
        return tuple(sorted(terms, key=_term_rank))

    def over(self, above: list[Expr], below: list[Expr]) -> str:
        """A number before a function or a sum is a fraction of its own, and 1/(1/x) is x."""
        twice = [f for f in below if f.op == "^" and fraction(f)[1]]
        above, below = above + [reciprocal(f) for f in twice], [f for f in below if f not in twice]
        rest = [f for f in above if f.op != "number"]
        if below and all(f.op == "number" for f in below) and any(map(_stands_alone, rest)):
            head = [f for f in above if f.op == "number"]
            share = self.put("fraction", self.factors(head), self.factors(below))
            return share + self._joined(rest)
        return super().over(above, below)

    def factors(self, factors: list[Expr]) -> str:
        """The factors in the order of the paper."""
        return super().factors(factors) if len(factors) < 2 else self._joined(factors)

    def _joined(self, factors: list[Expr]) -> str:
        *first, last = sorted(factors, key=_factor_rank)
        parts = [self.shown(f, POWER if f.op in BINDERS else PRODUCT) for f in first]
        parts.append(self.shown(last, PRODUCT))
        parts = [bracketed(part) if part.startswith("-") else part for part in parts]
        text = parts[0]
        for before, part in pairwise(parts):
            if before[-1].isdigit() and part[0].isdigit():
                text += r"\cdot "
            elif before[-1].isalpha() and part[0].isalpha():
                text += " "
            text += part
        return text

    def exponent(self, e: Expr) -> str:
        """An exponent with its fraction slanted: e^{-b/2}."""
        sign, e = ("-", opposite(e)) if is_negative(e) else ("", e)
        above, below = fraction(e)
        if len(above) == 1 and above[0].op == "+" and all(map(is_negative, above[0].args)):
            sign = "" if sign else "-"
            above = [Expr("+", tuple(map(opposite, above[0].args)))]
        top = self.shown(above[0], PRODUCT) if (sign or below) and len(above) == 1 else ""
        top = top or self.factors(above)
        if not below:
            return sign + top
        bottom = self.factors(below)
        plain = len(below) == 1 and below[0].op != "+"
        return f"{sign}{top}/{bottom if plain else bracketed(bottom)}"

    def binder(self, e: Expr) -> str:
        """A root is that of an equation, whose sides have no term with a minus sign."""
        if e.op != "root":
            return super().binder(e)
        (name,), body = opened(e)
        terms = self.terms(body.args) if body.op == "+" else (body,)
        left = [term for term in terms if not is_negative(term)]
        right = [opposite(term) for term in terms if is_negative(term)]
        equation = " = ".join(self.shown(add(*side)) for side in (left, right))
        low, high = map(self.shown, e.args[1:])
        return self.put("root", x=self.name(name), low=low, high=high, body=equation)

    def exponential(self, exponent: Expr) -> tuple[str, int]:
        """The power of e, on the line if its exponent is tall."""
        shown = self.shown(exponent)
        if shown.count(r"\frac") > MOST_FRACTIONS:
            return rf"\exp\left({shown}\right)", POWER
        return super().exponential(exponent)

    def called(self, op: str, head: str, args: tuple[Expr, ...]) -> str:
        """A function at its arguments; a letter needs no brackets."""
        if op not in FUNCTIONS or args[0].op not in ("symbol", "pi"):
            return super().called(op, head, args)
        body = self.shown(args[0])
        return head + (body if body.startswith("\\") else f" {body}")

    def differentiated(self, e: Expr) -> str:
        """What is differentiated, always in brackets."""
        return bracketed(self.shown(e))

    def name(self, name: str) -> str:
        """A symbol as the paper writes it."""
        return racket().written.latex.get(name) or super().name(name)


def _script(text: str) -> str:
    return text if len(text) == 1 else f"{{{text}}}"


def _stands_alone(e: Expr) -> bool:
    """Whether a factor is a function, a sum or contains an integral."""
    applied = e.op in ("+", "unknown", "exp") or (bool(e.args) and e.op in TABLE)
    return applied or any(node.op == "integral" for node in outermost(e))


def _term_rank(e: Expr) -> tuple[Any, ...]:
    """Sort key: positive terms first, then simple ones: a + b sin²ψ, 1 - b sin²ψ; orders last."""
    atoms = {"number": 0, "symbol": 1, "pi": 1}
    size = 1 if e.op in CONSTANTS else atoms.get(e.op, 2)
    return e.op in ORDERS or e == DOTS, is_negative(e), size, _paper_place(e), _key(e)


def _factor_rank(e: Expr) -> tuple[Any, ...]:
    """Sort key: numbers, π, symbols, roots, squares of sines, sums, functions."""
    base = e.args[0] if e.op == "^" else e
    place, function = _paper_place(base), ""
    if e.op == "number":
        rank = 0
    elif e.op == "pi" or e.op in CONSTANTS:
        rank = 1
    elif base.op == "symbol":
        rank = 2
    elif e.op == "^" and e.args[1] == HALF:
        rank = 3
    elif base.op == "exp":
        rank = 7
    elif base.op in TABLE or base.op == "unknown":
        # sin²θ (a + b sin²ψ), but (a + b sin²ψ) cos θ and (1 + r²) sinh²T
        rank = 4 if e.op == "^" and base.op in ("sin", "cos") else 6
        place = 1 if symbols(base).isdisjoint(racket().written.first) else 0
        function = base.op
    else:
        rank = 8 if base.op in BINDERS else 5
    return rank, place, function not in ("", "sin", "sinh"), _key(e)


_PAPER_ORDER = {"M": -3, "S": -2, "S2": -2, "gamma": -1, "E": 1}


def _paper_place(e: Expr) -> int:
    """Return the place of a symbol among its kind."""
    return _PAPER_ORDER.get(str(e.args[0]), 0) if e.op == "symbol" else 0


@lru_cache(maxsize=1 << 14)
def _key(e: Expr) -> tuple[Any, ...]:
    """Sort key of what is alike otherwise: by the base, then its exponent, then a number before."""
    first, *rest = factors_in(e)
    coefficient = first.args[0] if first.op == "number" else fmpq(1)
    if first.op == "number" and rest:
        e = rest[0] if len(rest) == 1 else Expr("*", tuple(rest))
    base, exponent = e.args if e.op == "^" else (e, ONE)
    kinds = {"number": 1, "symbol": 2, "pi": 2, "*": 3, "^": 3, "+": 4}
    kind = kinds.get(base.op, 5), base.op
    inner = [_key(a) for a in base.args if isinstance(a, Expr)]
    if base.op in ("+", "*"):
        inner.sort()
    own = str(base) if not inner else ""
    power = () if exponent == ONE else _key(exponent)
    return kind, len(inner), own, tuple(inner), (bool(power), power), float(coefficient)


PRINTER = PaperPrinter()


def expression_latex(e: Any) -> str:
    r"""Return an expression in LaTeX as a mathematician would write it.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> expression_latex(parse("b*cos(theta)**2"))
        'b\\cos^2\\theta'
    """
    return PRINTER.shown(in_trees(e))


def says_latex(says: Any) -> str:
    """Return the statement of a claim: a sentence unchanged, a formula in LaTeX."""
    if isinstance(says, str):
        return says
    says = in_trees(says)
    write = PRINTER.shown
    match says:
        case Expr():
            return write(says)
        case Relation():
            return PRINTER.chain((says,))
        case Together(parts=parts):
            return r",\quad ".join(map(says_latex, parts))
        case Equivalent(parts=parts):
            return r" \iff ".join(map(says_latex, parts))
        case EqualMatrices(left=left, right=right):
            return f"{side_latex(left)} = {side_latex(right)}"
        case Under(formula=inner, given=given):
            under = ",\\ ".join(map(says_latex, given))
            return says_latex(inner) + (rf"\quad({under})" if under else "")
        case Rounded():
            half = printed(says.text).width / 2 * says.half_units
            within = decimal_latex(f"{Decimal(int(half.p)) / int(half.q):f}")
            return rf"{write(says.term)} = {decimal_latex(says.text)} \pm {within}"
        case Tending(relation=inner, path=path):
            return rf"{says_latex(inner)}\quad({path_in_latex(path, PRINTER)})"
    return formula_in_latex(says, writer=PRINTER)


def side_latex(side: Any) -> str:
    """Return a side of an equation, or a step: an expression, an equation, the rows of a matrix.

    The fractions in a matrix are slanted, since those of two rows would touch.
    """
    rows = side.tolist() if hasattr(side, "tolist") else in_trees(side)
    if isinstance(rows, Expr | Relation):
        return says_latex(rows)
    shown = (" & ".join(PRINTER.exponent(in_trees(entry)) for entry in row) for row in rows)
    return r"\begin{pmatrix}" + r"\\".join(shown) + r"\end{pmatrix}"


def decimal_latex(text: str) -> str:
    """Return a decimal as it is printed in the paper."""
    mantissa, _, exponent = text.partition("e")
    return mantissa + (rf" \cdot 10^{{{int(exponent)}}}" if exponent else "")
