"""Write formulas in LaTeX and MathML: one walk over the tree, with a table of templates for each.

The walk decides what is a fraction, a root or a product, and where brackets are needed; a template
says how it is written.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping
from html import unescape

from tresym.reals.functions.table import CONSTANTS, TABLE, names, upright, written_after
from tresym.reals.language.calls import FACTORIAL, INFINITY, ROUNDED
from tresym.reals.language.expression import (
    DOTS,
    HALF,
    ONE,
    Expr,
    factors_in,
    instantiate,
    number,
    opened,
    orders_last,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.latex_tokens import GREEK

SUM, PRODUCT, POWER, ATOM = range(4)
"""How strongly a part binds; it needs brackets where the context binds more strongly."""


def _escaped(text: str) -> str:
    """Return a text as a template without places."""
    return text.replace("{", "{{").replace("}", "}}")


LATEX: Mapping[str, str] = {
    "==": "=", "!=": r"\ne", "<=": r"\le", ">=": r"\ge", "->": r"\to", "~": r"\sim",
    "<": "<", ">": ">", "relation": "{} {} {}", "and": r",\ ", "integer": r"{} \in \mathbb{{Z}}",
    "sum": r"\sum_{{{x}={low}}}^{{{high}}} {body}",
    "product": r"\prod_{{{x}={low}}}^{{{high}}} {body}",
    "integral": r"\int_{{{low}}}^{{{high}}} {body} \, d{x}",
    "antiderivative": r"\int {body} \, d{x}", "limit": r"\lim_{{{x} \to {low}{side}}} {body}",
    "root": r"\operatorname{{root}}_{{{low} < {x} < {high}}}\left({body}\right)",
    "coefficient": r"[{x}^{{{low}}}] \, {body}",
    "above": "^+", "below": "^-", "of": "{} {}", "at": r"\left.{body}\right|_{{{place}}}",
    "pair": "{}={}", "oo": r"\infty", "...": r"\dots", "pi": r"\pi", "e": "e", "d": "d",
    "number": "{}", "word": r"\mathrm{{{}}}", "foot": "{}", "index": "{}_{{{}}}", "prime": "'",
    "plus": " + ", "minus": " - ", "negative": "-", "times": r" \, ", "dot": r" \cdot ",
    "fraction": r"\frac{{{}}}{{{}}}", "power": "{}^{{{}}}", "sqrt": r"\sqrt{{{}}}",
    "cbrt": r"\sqrt[3]{{{}}}", "abs": r"\left|{}\right|", "function": r"\operatorname{{{}}}",
    "brackets": "({})", "tall": r"\left({}\right)", "comma": ", ", "partial": r"\partial ",
    "factorial": "{}!", "binomial": r"\binom{{{}}}{{{}}}",
    "floor": r"\left\lfloor {} \right\rfloor",
    "ceiling": r"\left\lceil {} \right\rceil",
    **{name: _escaped(row.latex) for name, row in TABLE.items() if written_after(row)},
    "O": "O", "o": "o", "Theta": r"\Theta", "omega": r"\omega",
}  # fmt: skip

_ROW = "<mrow>{}</mrow>"
MATHML: Mapping[str, str] = {
    "==": "=", "!=": "≠", "<=": "≤", ">=": "≥", "->": "→", "~": "∼", "<": "&lt;", ">": "&gt;",
    "relation": "{}<mo>{}</mo>{}", "and": "<mo>,</mo>", "integer": "{}<mo>∈</mo><mi>ℤ</mi>",
    **{
        name: f"<munderover><mo>{sign}</mo><mrow>{{x}}<mo>=</mo>{{low}}</mrow>"
        "<mrow>{high}</mrow></munderover>{body}"
        for name, sign in (("sum", "∑"), ("product", "∏"))
    },
    "integral": "<msubsup><mo>∫</mo><mrow>{low}</mrow><mrow>{high}</mrow></msubsup>{body}"
    "<mi>d</mi>{x}",
    "antiderivative": "<mo>∫</mo>{body}<mi>d</mi>{x}",
    "limit": "<munder><mo>lim</mo><mrow>{x}<mo>→</mo>{low}{side}</mrow></munder>{body}",
    "root": "<msub><mi>root</mi><mrow>{low}<mo>&lt;</mo>{x}<mo>&lt;</mo>{high}</mrow></msub>"
    "<mrow><mo>(</mo>{body}<mo>)</mo></mrow>",
    "coefficient": "<mo>[</mo><msup>{x}<mrow>{low}</mrow></msup><mo>]</mo>{body}",
    "above": "<mo>+</mo>", "below": "<mo>−</mo>", "of": "{}{}",
    "at": "<msub><mrow><mo>[</mo>{body}<mo>]</mo></mrow><mrow>{place}</mrow></msub>",
    "pair": "{}<mo>=</mo>{}", "oo": "<mi>∞</mi>", "...": "<mo>⋯</mo>", "pi": "<mi>π</mi>",
    "e": "<mi>e</mi>", "d": "<mi>d</mi>", "number": "<mn>{}</mn>", "word": "<mi>{}</mi>",
    "foot": "<mi>{}</mi>", "index": "<msub>{}{}</msub>", "prime": "<mo>′</mo>",
    "plus": "<mo>+</mo>", "minus": "<mo>−</mo>", "negative": "<mo>−</mo>",
    "times": "<mo>&#x2062;</mo>", "dot": "<mo>·</mo>", "fraction": f"<mfrac>{_ROW}{_ROW}</mfrac>",
    "power": f"<msup>{_ROW}{_ROW}</msup>", "sqrt": f"<msqrt>{_ROW}</msqrt>",
    "cbrt": f"<mroot>{_ROW}<mn>3</mn></mroot>", "abs": "<mrow><mo>|</mo>{}<mo>|</mo></mrow>",
    "function": "<mi>{}</mi>", "factorial": "<mrow>{}<mo>!</mo></mrow>",
    "binomial": "<mrow><mo>(</mo><mfrac linethickness=\"0\"><mrow>{}</mrow><mrow>{}</mrow></mfrac>"
    "<mo>)</mo></mrow>",
    "floor": "<mrow><mo>⌊</mo>{}<mo>⌋</mo></mrow>",
    "ceiling": "<mrow><mo>⌈</mo>{}<mo>⌉</mo></mrow>",
    "brackets": "<mrow><mo>(</mo>{}<mo>)</mo></mrow>",
    "comma": "<mo>,</mo>", "partial": "<mi>∂</mi>",
    **{name: f"<mi>{upright(row)}</mi>" for name, row in TABLE.items() if written_after(row)},
    "O": "<mi>O</mi>", "o": "<mi>o</mi>", "Theta": "<mi>Θ</mi>", "omega": "<mi>ω</mi>",
}  # fmt: skip

RAISED = names(lambda row: row.family in ("trigonometric", "hyperbolic"))
"""Functions whose exponent stands at the name: sin²(x)."""
_SLOPE = re.compile(r"(d|partial)(\d?)([A-Za-z]\w*?)_(?:d|partial)([A-Za-z]\w*?)\2")
_PRIMED = re.compile(r"(\w+?)_prime(\d?)")
_DIGIT = re.compile(r"(?:<m(?:row|sup|n)>)*\d")
"""The start of a text that begins with a digit, which a dot separates from a number before it."""


UPRIGHT = {**LATEX, "e": r"\mathrm{{e}}"}
"""With an upright letter for the base of exponentials, where e may be a variable."""


def to_latex(comparisons: Iterable[Compared], upright: bool = False) -> str:
    r"""Return comparisons in LaTeX, ``0 < x \le 1`` for two with a side in common.

    Args:
        comparisons: the comparisons.
        upright: whether the base of exponentials is an upright e, because e may be a variable.
    """
    return Printer(UPRIGHT if upright else LATEX).chain(comparisons)


def to_mathml(comparisons: Iterable[Compared], block: bool = True) -> str:
    """Return comparisons in MathML, as a formula of its own or in the line."""
    start = '<math display="block">' if block else "<math>"
    return f"{start}{Printer(MATHML).chain(comparisons)}</math>"


class Printer:
    """The walk over a tree with the templates of one language.

    A subclass may have an order of terms and factors of its own, and ways of its own to write
    powers, functions and names.
    """

    enclosing: Container[str] = ("root",)
    """Binders whose signs enclose the body, so that a sum needs no brackets."""

    def __init__(self, templates: Mapping[str, str]) -> None:
        """Take the templates of a language."""
        self.templates = templates

    def put(self, template: str, *args: str, **named: str) -> str:
        """Fill in a template."""
        return self.templates[template].format(*args, **named)

    def chain(self, comparisons: Iterable[Compared]) -> str:
        """Comparisons, where one goes on from the one before it."""
        text = ""
        last: tuple[Expr | None, str] = (None, "")
        for left, relation, right in comparisons:
            goes_on = left is last[0] and relation[0] == last[1][0]
            if not goes_on:
                text += (self.put("and") if text else "") + self.shown(left)
            if relation == "in":
                text = self.put("integer", text)
            else:
                sign = self.templates[relation]
                text = self.put("relation", text, sign, self.shown(right))
            last = right, relation
        return text

    def shown(self, e: Expr, around: int = SUM) -> str:
        """The formula, in brackets if what stands around it binds more strongly."""
        text, strength = self.written(e)
        return text if strength >= around else self.bracketed(text)

    def bracketed(self, text: str) -> str:
        """A formula in brackets."""
        tall = "tall" in self.templates and (r"\frac" in text or r"\int" in text)
        return self.put("tall" if tall else "brackets", text)

    def written(self, e: Expr) -> tuple[str, int]:
        """The formula, and how strongly it binds."""
        match e.op:
            case "number":
                r = e.args[0]
                size, q = self.put("number", str(abs(int(r.p)))), self.put("number", str(r.q))
                text = size if r.q == 1 else self.put("fraction", size, q)
                whole = ATOM if r.q == 1 and r >= 0 else PRODUCT
                return (self.put("negative") + text if r < 0 else text), whole
            case "symbol":
                name = e.args[0]
                if name[0].isdigit():  # a number as it was typed
                    return self.put("number", name), ATOM
                return (self.put(name) if e in (INFINITY, DOTS) else self.name(name)), ATOM
            case "pi":
                return self.put("pi"), ATOM
            case "+":
                return self.sum(e), SUM
            case "*":
                return self.product(e), PRODUCT
            case "^":
                return self.raised(*e.args)
            case "exp" if e.args[0] == ONE:
                return self.put("e"), ATOM
            case "exp":
                return self.exponential(e.args[0])
            case "abs" | "cbrt":
                return self.put(e.op, self.shown(e.args[0])), ATOM
        if e.op == "root":
            return self.binder(e), ATOM
        if e.op == "binomial":
            return self.put(e.op, *map(self.shown, e.args)), ATOM
        return (self.binder(e), SUM) if e.names else (self.applied(e), ATOM)

    def exponential(self, exponent: Expr) -> tuple[str, int]:
        """The power of e, and how strongly it binds."""
        return self.put("power", self.put("e"), self.exponent(exponent)), POWER

    def sum(self, e: Expr) -> str:
        """Terms with their signs; a positive one comes first: 1 − x."""
        terms = self.terms(e.args)
        text = self.shown(terms[0])
        for term in terms[1:]:
            sign, shown = ("minus", opposite(term)) if is_negative(term) else ("plus", term)
            text += self.put(sign) + self.shown(shown, PRODUCT if sign == "minus" else SUM)
        return text

    def terms(self, terms: tuple[Expr, ...]) -> tuple[Expr, ...]:
        """The terms in the order of print."""
        found = orders_last(terms)
        if found is terms and is_negative(terms[0]):
            found = tuple(sorted(terms, key=is_negative))
        return found

    def product(self, e: Expr) -> str:
        """Factors above and below one bar, with a sign before it."""
        if is_negative(e):
            return self.put("negative") + self.shown(opposite(e), PRODUCT)
        return self.over(*fraction(e))

    def over(self, above: list[Expr], below: list[Expr]) -> str:
        """Factors over others."""
        if not below:
            return self.factors(above)
        return self.put("fraction", self.factors(above), self.factors(below))

    def factors(self, factors: list[Expr]) -> str:
        """A product without a fraction; without factors it is 1."""
        if len(factors) < 2:
            return self.shown(factors[0] if factors else ONE)
        text = self.shown(factors[0], PRODUCT)
        for factor in factors[1:]:
            part = self.shown(factor, PRODUCT)
            text += self.put("dot" if _DIGIT.match(part) else "times") + part
        return text

    def raised(self, base: Expr, exponent: Expr) -> tuple[str, int]:
        """A power, a root or a fraction, and how strongly it binds."""
        if exponent.op == "number" and exponent.args[0] < 0:
            below = self.shown(reciprocal(Expr("^", (base, exponent))))
            return self.put("fraction", self.put("number", "1"), below), PRODUCT
        if exponent == HALF:
            return self.put("sqrt", self.shown(base)), ATOM
        shown = self.exponent(exponent)
        if base.op in RAISED:
            name = self.put("power", self.put(base.op), shown)
            return self.called(base.op, name, base.args), POWER
        return self.put("power", self.shown(base, ATOM), shown), POWER

    def exponent(self, e: Expr) -> str:
        """What stands raised."""
        return self.shown(e)

    def called(self, op: str, head: str, args: tuple[Expr, ...]) -> str:
        """A function, whose name is written, at its arguments."""
        return head + self.bracketed(self.put("comma").join(map(self.shown, args)))

    def applied(self, e: Expr) -> str:
        """A function, or a constant."""
        args = e.args
        if e.op == "unknown":
            (name, orders), args = e.args[0].args, e.args[1:]
            if name == FACTORIAL and len(args) == 1:
                return self.put("factorial", self.shown(args[0], ATOM))
            if name in ROUNDED and len(args) == 1:
                return self.put(name, self.shown(args[0]))
            head = self.name(name) + self.put("prime") * sum(orders)
        else:
            head = self.put(e.op) if e.op in self.templates else self.put("function", e.op)
            if e.op in CONSTANTS:
                return head
            if e.op in TABLE and TABLE[e.op].subscripted:
                head, args = self.put("index", head, self.shown(args[0])), args[1:]
        return self.called(e.op, head, args)

    def binder(self, e: Expr) -> str:
        """Integrals, sums, products, limits, derivatives and values at a place."""
        if e.op == "antiderivative":
            shown = self.shown(instantiate(e.args[0], e.args[1:2]), PRODUCT)
            return self.put(e.op, body=shown, x=self.shown(e.args[1]))
        if e.op in ("derivative", "nth"):
            return self.derivative(e)
        names, body = opened(e)
        if e.op == "at" and symbols(e.args[0]).isdisjoint(e.names):  # as in x = x + 1
            names, body = e.names, instantiate(e.args[0], tuple(map(symbol, e.names)))
        around = SUM if e.op in self.enclosing else PRODUCT
        inner, ends = self.shown(body, around), [self.shown(arg) for arg in e.args[1:]]
        if e.op == "at":
            return self.at(inner, names, ends)
        side = {"1": self.put("above"), "-1": self.put("below")}.get(str(e.args[-1]), "")
        named = {"low": ends[0], "high": ends[-1], "side": side, "body": inner}
        return self.put(e.op, x=self.name(names[0]), **named)

    def at(self, body: str, names: Iterable[str], ends: Iterable[str]) -> str:
        """What was written, at values of its variables."""
        pairs = (self.put("pair", self.name(x), y) for x, y in zip(names, ends, strict=True))
        return self.put("at", body=body, place=self.put("comma").join(pairs))

    def derivative(self, e: Expr) -> str:
        """Repeated where it is taken at the variable itself; elsewhere its value at the place."""
        place, times, body = e.args[1], 0, e
        while body.op == e.op and body.args[1] == place and place.op == "symbol":
            if not symbols(body.args[0]).isdisjoint(symbols(place)) or (times and e.op == "nth"):
                break
            times, body = times + 1, instantiate(body.args[0], (place,))
        order = self.put("number", str(times)) if times > 1 else ""
        order = self.shown(e.args[2]) if e.op == "nth" else order
        (name,), inside = opened(e)
        slope = self.slope(
            self.put("d"), "", self.shown(place) if times else self.name(name), order
        )
        shown = self.put("of", slope, self.differentiated(body if times else inside))
        return shown if times else self.at(shown, (name,), (self.shown(place),))

    def differentiated(self, e: Expr) -> str:
        """What stands behind the sign of a derivative."""
        return self.shown(e, PRODUCT)

    def slope(self, d: str, above: str, below: str, order: str) -> str:
        """A derivative as a fraction of differentials."""
        first, last = (self.put("power", x, order) if order else x for x in (d, below))
        return self.put("fraction", first + above, d + last)

    def name(self, name: str) -> str:
        """``psi0`` with its index, ``lambda_`` by its letter, ``dx_dt`` as a fraction."""
        if slope := _SLOPE.fullmatch(name):
            sign, times, above, below = slope.groups()
            order = self.put("number", times) if times else ""
            return self.slope(self.put(sign), self.name(above), self.name(below), order)
        if primed := _PRIMED.fullmatch(name):
            return self.name(primed[1]) + self.put("prime") * int(primed[2] or 1)
        head, _, foot = name.rstrip("_").partition("_")
        stem = head.rstrip("0123456789") or head
        foot = head[len(stem) :] + foot
        shown = self.letter(stem, "word" if len(stem) > 1 else "foot")
        return self.put("index", shown, self.letter(foot, "foot")) if foot else shown

    def letter(self, name: str, template: str) -> str:
        """A Greek letter by its name, and any other name as it is."""
        name = "epsilon" if name == "eps" else name
        if name == "pi":
            return self.put(name)
        if name not in GREEK:
            return self.put(template, name)
        return (
            rf"\{name}" if "tall" in self.templates else self.put(template, unescape(f"&{name};"))
        )


PLAIN = Printer(LATEX)
"""LaTeX with the names of symbols and the order of terms as they are."""


def fraction(e: Expr) -> tuple[list[Expr], list[Expr]]:
    """Return the factors above and below the bar of a product."""
    above: list[Expr] = []
    below: list[Expr] = []
    for f in factors_in(e):
        if f.op == "number":
            p, q = (number(int(x)) for x in (f.args[0].p, f.args[0].q))
            above += [p] if p != ONE else []
            below += [q] if q != ONE else []
        elif f.op == "^" and f.args[1].op == "number" and f.args[1].args[0] < 0:
            below.append(reciprocal(f))
        else:
            above.append(f)
    return above, below


def is_negative(e: Expr) -> bool:
    """Return whether a number or a product is written with a minus sign."""
    first = e.args[0] if e.op == "*" else e
    return bool(first.op == "number" and first.args[0] < 0)


def opposite(e: Expr) -> Expr:
    """Return a negative number or product without its sign, its factors in the order they have."""
    if e.op != "*":
        return -e
    first, *rest = e.args
    size = -first
    if size == ONE:
        return rest[0] if len(rest) == 1 else Expr("*", tuple(rest))
    return Expr("*", (size, *rest))


def reciprocal(e: Expr) -> Expr:
    """Return one divided by a power with a negative exponent, its base in the form it has."""
    base, exponent = e.args
    return base if exponent == number(-1) else Expr("^", (base, -exponent))


def expression_in_mathml(e: Expr) -> str:
    """Return an expression in MathML, in the line."""
    return f"<math>{Printer(MATHML).shown(e)}</math>"


def expression_in_latex(e: Expr, upright: bool = False) -> str:
    r"""Return an expression in LaTeX; ``upright`` as for :func:`to_latex`.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> expression_in_latex(parse("x/2"))
        '\\frac{x}{2}'
    """
    return Printer(UPRIGHT if upright else LATEX).shown(e)
