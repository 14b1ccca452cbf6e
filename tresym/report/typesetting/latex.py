"""Write statements in LaTeX in the paper's notation."""

from __future__ import annotations

import re
from decimal import Decimal
from itertools import pairwise
from typing import Any

from sympy import (
    Add,
    And,
    Basic,
    Equivalent,
    Expr,
    Function,
    Integer,
    Integral,
    Mul,
    Pow,
    Rational,
    Symbol,
    Tuple,
    exp,
    oo,
)
from sympy.core.relational import Relational
from sympy.printing.latex import LatexPrinter

from tresym.ledger.paper import racket
from tresym.ledger.statements import (
    As,
    AtMostOne,
    Conserved,
    ExactlyOne,
    ForSome,
    Infimum,
    Rounds,
    StableEquilibrium,
    StrictlyDecreasing,
    StrictlyIncreasing,
    Under,
    UnstableEquilibrium,
)
from tresym.reals.functions.table import TABLE, names, written_after
from tresym.reals.numbers.exact import printed

_RELATIONS = {"==": "=", ">": ">", ">=": r"\ge", "<": "<", "<=": r"\le", "!=": r"\ne"}

_FUNCTIONS = {name: row.latex for name, row in TABLE.items() if row.theory and written_after(row)}

_RAISED = names(lambda row: row.family in ("trigonometric", "hyperbolic"))
"""Functions whose exponent stands at the name: sin²(x)."""

_RATE = re.compile(r"(d|partial)([A-Za-z]+)_(?:d|partial)([A-Za-z]+[0-3]?)")
"""Names of derivatives that are symbols, such as dG_dlambda."""

_LETTERS = {"eigenvalue": r"\lambda", "hot": r"\mathrm{hot}"}
"""Symbols that single proofs introduce, whose names are words."""

MOST_FRACTIONS = 2
"""In an exponent that is raised; one with more stands on the line."""

_TALL = (r"\frac", r"\begin", r"\int", r"\sum")


def bracketed(body: str) -> str:
    """Return ``body`` in round brackets, which grow only if something tall is inside."""
    if any(mark in body for mark in _TALL):
        return rf"\left({body}\right)"
    return f"({body})"


class PaperPrinter(LatexPrinter):
    """SymPy's LaTeX printer with products, sums, powers and functions as the paper writes them."""

    def _print_Add(self, e: Add, order: str | None = None) -> str:
        terms = sorted(e.args, key=_term_rank)
        text = ""
        for term in terms:
            negative = _is_negative(term)
            body = self._print(-term if negative else term)
            if (-term if negative else term).is_Add:
                body = bracketed(body)
            text += ("-" if negative else "+" if text else "") + body
        return text

    def _print_Mul(self, e: Mul) -> str:
        if _is_negative(e):
            return "-" + self._factor(-e, alone=True)
        above, below = _fraction(e)
        if not below:
            return self._product(above)
        rest = [f for f in above if not f.is_Integer]
        if all(f.is_Integer for f in below) and any(
            f.is_Function or f.is_Add or f.has(Integral) for f in rest
        ):
            head = [f for f in above if f.is_Integer]
            share = rf"\frac{{{self._product(head)}}}{{{self._product(below)}}}"
            return share + self._product(rest, alone=False)
        return rf"\frac{{{self._product(above)}}}{{{self._product(below)}}}"

    def _product(self, factors: list[Expr], alone: bool = True) -> str:
        if not factors:
            return "1"
        alone = alone and len(factors) == 1
        ranked = sorted(factors, key=_factor_rank)
        parts = [
            self._print(f) if f.is_Integer and n == 0 else self._factor(f, alone)
            for n, f in enumerate(ranked)
        ]
        text = parts[0]
        for before, part in pairwise(parts):
            text += (r"\cdot " if before[-1].isdigit() and part[0].isdigit() else "") + (
                " " if before[-1].isalpha() and part[0].isalpha() else ""
            )
            text += part
        return text

    def _factor(self, e: Expr, alone: bool) -> str:
        body = self._print(e)
        signed = e.is_Add or body.startswith("-")
        return bracketed(body) if signed and not alone else body

    def _print_Pow(self, e: Pow, **_: Any) -> str:
        base, power = e.args
        if power.is_Rational and power < 0:
            return rf"\frac{{1}}{{{self._print(Pow(base, -power))}}}"
        if power == Rational(1, 2):
            return rf"\sqrt{{{self._print(base)}}}"
        shown = _inline(power) if power.is_Rational else self._print(power)
        if isinstance(base, Function) and base.func.__name__ in _RAISED:
            return self._applied(base, shown)
        body = self._print(base)
        plain = base.is_Symbol and not body.startswith(r"\frac")
        if not (plain or (base.is_Integer and base >= 0)):
            body = bracketed(body)
        return f"{body}^{_script(shown)}"

    def _applied(self, e: Function, power: str = "") -> str:
        name = e.func.__name__
        head = _FUNCTIONS[name] + (f"^{_script(power)}" if power else "")
        (argument,) = e.args
        body = self._print(argument)
        if argument.is_Symbol:
            return head + (body if body.startswith("\\") else f" {body}")
        return head + bracketed(body)

    def _print_Function(self, e: Function, exp: str | None = None) -> str:
        if len(e.args) == 1 and e.func.__name__ in _FUNCTIONS:
            return self._applied(e)
        name = self._hprint_Function(e.func.__name__)
        head = name + (f"^{_script(exp)}" if exp else "")
        return head + bracketed(", ".join(map(self._print, e.args)))

    _print_log = _print_Function

    def _print_Order(self, e: Basic) -> str:
        return f"O{bracketed(self._print(e.args[0]))}"

    def _print_ExpBase(self, e: exp, exp: str | None = None) -> str:
        shown = self._print(e.args[0])
        if shown.count(r"\frac") > MOST_FRACTIONS:
            return rf"\exp\left({shown}\right)"
        return f"e^{_script(self._slanted(e.args[0]))}"

    def _print_matrix_contents(self, e: Basic) -> str:
        """The rows of a matrix; fractions are slanted, since those of two rows would touch."""
        rows = (" & ".join(map(self._slanted, row)) for row in e.tolist())
        return r"\begin{pmatrix}" + r"\\".join(rows) + r"\end{pmatrix}"

    def _slanted(self, e: Expr) -> str:
        """An exponent with its fraction slanted: e^{-b/2}."""
        sign, e = ("-", -e) if _is_negative(e) else ("", e)
        above, below = _fraction(e)
        if len(above) == 1 and above[0].is_Add and all(map(_is_negative, above[0].args)):
            sign, above = "" if sign else "-", [-above[0]]
        alone = not (sign or below)
        top = self._product(above) if alone or len(above) != 1 else self._factor(above[0], False)
        if not below:
            return sign + top
        bottom = self._product(below)
        plain = len(below) == 1 and not below[0].is_Add
        return f"{sign}{top}/{bottom if plain else bracketed(bottom)}"

    def _print_Abs(self, e: Basic, exp: str | None = None) -> str:
        body = self._print(e.args[0])
        tall = any(mark in body for mark in _TALL)
        shown = rf"\left|{body}\right|" if tall else f"|{body}|"
        return shown + (f"^{_script(exp)}" if exp else "")

    def _print_Symbol(self, e: Symbol, style: str = "plain") -> str:
        rate = _RATE.fullmatch(e.name)
        own = racket().written.latex
        if e in own or e.name in _LETTERS:
            return own.get(e) or _LETTERS[e.name]
        if rate is not None:
            sign = r"\partial " if rate[1] == "partial" else "d"
            above, below = (self._print_Symbol(Symbol(name)) for name in rate.groups()[1:])
            return rf"\frac{{{sign}{above}}}{{{sign}{below}}}"
        return re.sub(r"_\{([0-3])\}", r"_\1", str(super()._print_Symbol(e, style)))

    def _print_Integral(self, e: Basic) -> str:
        ((variable, low, high),) = e.limits
        body = self._print(e.function)
        if e.function.is_Add:
            body = bracketed(body)
        ends = f"_{_script(self._print(low))}^{_script(self._print(high))}"
        return rf"\int{ends} {body}\,d{self._print(variable)}"

    def _print_TheRoot(self, e: Basic) -> str:
        name, low, high = map(self._print, e.args[:3])
        return rf"(\text{{the }}{name} \in ({low}, {high}):\ {says_latex(e.args[3])})"

    def _print_Subs(self, e: Basic) -> str:
        pairs = zip(e.variables, e.point, strict=True)
        at = ", ".join(f"{self._print(v)}={self._print(p)}" for v, p in pairs)
        return rf"\left.{self._print(e.expr)}\right|_{{{at}}}"

    def _print_Derivative(self, e: Basic) -> str:
        variable = self._print(e.variables[0])
        order = len(e.variables)
        top, bottom = (
            ("d", f"d{variable}") if order == 1 else (f"d^{order}", f"d{variable}^{order}")
        )
        return rf"\frac{{{top}}}{{{bottom}}}{bracketed(self._print(e.expr))}"


def _inline(power: Rational) -> str:
    return str(power.p) if power.q == 1 else f"{power.p}/{power.q}"


def _script(text: str) -> str:
    return text if len(text) == 1 else f"{{{text}}}"


def _is_negative(e: Expr) -> bool:
    return bool(e.is_number and e.is_Rational and e < 0) or (
        e.is_Mul and bool(e.args[0].is_Rational and e.args[0] < 0)
    )


def _fraction(e: Expr) -> tuple[list[Expr], list[Expr]]:
    """The factors of numerator and denominator."""
    above: list[Expr] = []
    below: list[Expr] = []
    for factor in Mul.make_args(e):
        if factor.is_Rational:
            above += [Integer(factor.p)] if factor.p != 1 else []
            below += [Integer(factor.q)] if factor.q != 1 else []
        elif factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
            below.append(Pow(factor.base, -factor.exp))
        else:
            above.append(factor)
    return above, below


def _factor_rank(e: Expr) -> tuple[Any, ...]:
    """Sort key: numbers, π, symbols, roots, squares of sines, sums, functions."""
    base = e.base if e.is_Pow else e
    place = _paper_place(base)
    if e.is_Number:
        rank = 0
    elif e.is_NumberSymbol:
        rank = 1
    elif base.is_Symbol:
        rank = 2
    elif e.is_Pow and e.exp == Rational(1, 2):
        rank = 3
    elif isinstance(base, exp):
        rank = 7
    elif isinstance(base, Function):
        # sin²θ (a + b sin²ψ), but (a + b sin²ψ) cos θ and (1 + r²) sinh²T
        rank = 4 if e.is_Pow and base.func.__name__ in ("sin", "cos") else 6
        place = 0 if base.has(*racket().written.first) else 1
        return rank, place, base.func.__name__ != "sin", e.sort_key()
    else:
        rank = 5
    return rank, place, False, e.sort_key()


def _term_rank(e: Expr) -> tuple[Any, ...]:
    """Sort key: positive terms first, then simple ones: a + b sin²ψ, 1 − b sin²ψ."""
    size = 0 if e.is_Number else 1 if e.is_Symbol or e.is_NumberSymbol else 2
    return _is_negative(e), size, _paper_place(e), e.sort_key()


_PAPER_ORDER = {"M": -3, "S": -2, "S2": -2, "gamma": -1, "E": 1}


def _paper_place(e: Expr) -> int:
    """Return the place of a symbol among its kind; printing anything larger would be slow."""
    return _PAPER_ORDER.get(str(e), 0) if e.is_Atom else 0


def expression_latex(e: Basic) -> str:
    r"""Return an expression in LaTeX as a mathematician would write it.

    Example:
        >>> from sympy import Symbol, cos
        >>> expression_latex(cos(Symbol("theta", real=True)) ** 2)
        '\\cos^2\\theta'
    """
    return str(PaperPrinter({"mat_str": "pmatrix", "mat_delim": ""}).doprint(e))


def says_latex(says: Basic | str) -> str:
    """Return the statement of a claim: a sentence unchanged, a formula in LaTeX."""
    if isinstance(says, str):
        return says
    if isinstance(says, Equivalent):
        return r" \iff ".join(says_latex(part) for part in says.args)
    if isinstance(says, Tuple | And):
        return r",\quad ".join(says_latex(part) for part in says.args)
    match says:
        case Under(args=(inner, given)):
            under = ",\\ ".join(map(says_latex, given.args))
            return says_latex(inner) + (rf"\quad({under})" if under else "")
        case ExactlyOne(args=(x, low, high, inner)):
            name, *ends = map(expression_latex, (x, low, high))
            return rf"\exists!\,{name} \in ({ends[0]}, {ends[1]}):\ {says_latex(inner)}"
        case AtMostOne(args=(x, low, high, inner)):
            name, *ends = map(expression_latex, (x, low, high))
            between = rf"{name} \in ({ends[0]}, {ends[1]})"
            return rf"\text{{at most one }}{between}:\ {says_latex(inner)}"
        case Rounds():
            half = printed(says.text).width / 2 * says.half_units
            within = decimal_latex(f"{Decimal(int(half.p)) / int(half.q):f}")
            return rf"{expression_latex(says.term)} = {decimal_latex(says.text)} \pm {within}"
        case ForSome(args=(inner,)):
            names = ", ".join(sorted(map(expression_latex, inner.free_symbols)))
            return rf"\exists\,{names}:\ {says_latex(inner)}"
        case StrictlyIncreasing(args=(e, x)) | StrictlyDecreasing(args=(e, x)):
            way = "increases" if isinstance(says, StrictlyIncreasing) else "decreases"
            return rf"{expression_latex(e)}\text{{ {way} strictly in }}{expression_latex(x)}"
        case Infimum(args=(e, value)):
            return rf"\inf {expression_latex(e)} = {expression_latex(value)}\text{{, not attained}}"
        case Conserved(args=(e, variables, rates)):
            return rf"{expression_latex(e)}\text{{ is constant where }}{_system(variables, rates)}"
        case (
            StableEquilibrium(args=(variables, rates, point))
            | UnstableEquilibrium(args=(variables, rates, point))
        ):
            kind = "a stable" if isinstance(says, StableEquilibrium) else "an unstable"
            place = rf"({', '.join(map(expression_latex, point.args))})"
            names = rf"({', '.join(map(expression_latex, variables.args))})"
            rest = rf"\text{{ is {kind} equilibrium of }}{_system(variables, rates)}"
            return rf"{names} = {place}{rest}"
        case As(args=(inner, x, point, side)):
            mark = "" if point in (oo, -oo) else {1: "^+", -1: "^-"}.get(int(side), "")
            passage = rf"{expression_latex(x)} \to {expression_latex(point)}{mark}"
            return rf"{says_latex(inner)}\quad({passage})"
    if isinstance(says, Relational):
        left, right = map(expression_latex, says.args)
        return f"{left} {_RELATIONS[says.rel_op]} {right}"
    return expression_latex(says)


def _system(variables: Basic, rates: Basic) -> str:
    """Return the equations of motion, with a dot for the derivative."""
    pairs = zip(variables.args, rates.args, strict=True)
    return r",\ ".join(rf"\dot{{{expression_latex(x)}}} = {expression_latex(f)}" for x, f in pairs)


def decimal_latex(text: str) -> str:
    """Return a decimal as it is printed in the paper."""
    mantissa, _, exponent = text.partition("e")
    return mantissa + (rf" \cdot 10^{{{int(exponent)}}}" if exponent else "")


def given_latex(condition: Basic) -> str:
    """Return a condition in LaTeX."""
    return says_latex(condition)
