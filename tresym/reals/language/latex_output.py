"""Write trees as LaTeX."""

from __future__ import annotations

from collections.abc import Iterable

from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    HALF,
    ONE,
    ORDERS,
    Expr,
    instantiate,
    number,
    opened,
    power,
    symbols,
)
from tresym.reals.language.latex_tokens import GREEK
from tresym.reals.language.parsing import Compared

RELATIONS = {
    "==": "=",
    "!=": r"\ne",
    "<=": r"\le",
    ">=": r"\ge",
    "->": r"\to",
    "~": r"\sim",
}
_NAMED = {"log": r"\ln", "asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan"}
_PLAIN = frozenset(["sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth"])
_BIG = {"sum": r"\sum", "product": r"\prod"}
SPACED = r",\ "
SUM, PRODUCT, BASE = range(3)
"""What surrounds a part: a sum or nothing, a product, or a power."""


def typeset(comparisons: Iterable[Compared]) -> str:
    """Comparisons in LaTeX, ``0 < x \\le 1`` for two with a side in common."""
    text = ""
    last: tuple[Expr | None, str] = (None, "")
    for left, relation, right in comparisons:
        goes_on = left is last[0] and relation[0] == last[1][0]
        text += "" if goes_on else f"{SPACED if text else ''}{_latex(left, SUM)}"
        shown = RELATIONS.get(relation, relation)
        text += f" {shown} {_latex(right, SUM)}" if relation != "in" else r" \in \mathbb{Z}"
        last = right, relation
    return text


def _latex(e: Expr, around: int) -> str:
    match e.op:
        case "number":
            r = e.args[0]
            size = str(abs(int(r.p))) if r.q == 1 else rf"\frac{{{abs(int(r.p))}}}{{{r.q}}}"
            text = f"-{size}" if r < 0 else size
            return _bracketed(text) if around == BASE and (r < 0 or r.q != 1) else text
        case "symbol":
            return r"\infty" if e == INFINITY else _name(e.args[0])
        case "pi":
            return r"\pi"
        case "+":
            text = _latex(e.args[0], SUM)
            for term in e.args[1:]:
                part = _latex(term, SUM)
                text += f" - {part[1:]}" if part.startswith("-") else f" + {part}"
            return _bracketed(text) if around else text
        case "*":
            text = _product(e)
            return _bracketed(text) if around == BASE else text
        case "^":
            return _power(e.args[0], e.args[1], around)
        case "exp":
            return "e" if e.args[0] == ONE else f"e^{{{_latex(e.args[0], SUM)}}}"
        case "abs":
            return rf"\left|{_latex(e.args[0], SUM)}\right|"
        case "cbrt":
            return rf"\sqrt[3]{{{_latex(e.args[0], SUM)}}}"
    text = _bound(e) if e.names else _applied(e)
    return _bracketed(text) if around and e.names else text


def _product(e: Expr) -> str:
    """Factors above and below one bar, a sign before it."""
    above: list[str] = []
    below: list[Expr] = []
    sign, factors = "", e.args
    if factors[0].op == "number":
        r, factors = factors[0].args[0], factors[1:]
        sign = "-" if r < 0 else ""
        above += [str(abs(int(r.p)))] if abs(r.p) != 1 else []
        below += [number(int(r.q))] if r.q != 1 else []
    for f in factors:
        if f.op == "^" and f.args[1].op == "number" and f.args[1].args[0] < 0:
            below.append(power(f.args[0], -f.args[1]))
        else:
            above.append(_latex(f, PRODUCT))
    text = above[0] if above else "1"
    for part in above[1:]:
        text += (r" \cdot " if part[0].isdigit() else r" \, ") + part
    if below:
        alone = SUM if len(below) == 1 else PRODUCT
        bottom = r" \, ".join(_latex(f, alone) for f in below)
        text = rf"\frac{{{text}}}{{{bottom}}}"
    return sign + text


def _power(base: Expr, exponent: Expr, around: int) -> str:
    if exponent.op == "number" and exponent.args[0] < 0:
        text = rf"\frac{{1}}{{{_latex(power(base, -exponent), SUM)}}}"
        return _bracketed(text) if around == BASE else text
    if exponent == HALF:
        return rf"\sqrt{{{_latex(base, SUM)}}}"
    shown = _latex(exponent, SUM)
    if base.op in _PLAIN:
        return rf"\{base.op}^{{{shown}}}{_bracketed(_latex(base.args[0], SUM))}"
    text = f"{_latex(base, BASE)}^{{{shown}}}"
    return _bracketed(text) if around == BASE else text


def _applied(e: Expr) -> str:
    if e.op == "unknown":
        (name, orders), args = e.args[0].args, e.args[1:]
        head = _name(name) + "'" * sum(orders)
    else:
        args = e.args
        head = rf"\{e.op}" if e.op in _PLAIN else _NAMED.get(e.op, rf"\operatorname{{{e.op}}}")
        head = {"o": "o", "O": "O"}.get(e.op, head) if e.op in ORDERS else head
    return head + _bracketed(", ".join(_latex(arg, SUM) for arg in args))


def _bound(e: Expr) -> str:
    """Integrals, sums, products, limits and derivatives."""
    if e.op == "antiderivative":
        return rf"\int {_inner(e)} \, d{_latex(e.args[1], SUM)}"
    if e.op in ("derivative", "nth"):
        return _derivative(e)
    (name, *_), body = opened(e)
    x, inner, ends = _name(name), _latex(body, PRODUCT), [_latex(arg, SUM) for arg in e.args[1:]]
    if e.op == "integral":
        return rf"\int_{{{ends[0]}}}^{{{ends[1]}}} {inner} \, d{x}"
    if e.op in _BIG:
        return rf"{_BIG[e.op]}_{{{x}={ends[0]}}}^{{{ends[1]}}} {inner}"
    if e.op == "limit":
        side = {"1": "^+", "-1": "^-"}.get(str(e.args[2]), "")
        return rf"\lim_{{{x} \to {ends[0]}{side}}} {inner}"
    return rf"\left.{inner}\right|_{{{x}={ends[0]}}}"


def _inner(e: Expr) -> str:
    """The body of what binds a variable that stands at itself."""
    return _latex(instantiate(e.args[0], e.args[1:2]), PRODUCT)


def _derivative(e: Expr) -> str:
    """At the variable itself, as often as it is so; elsewhere as a value at the place."""
    place, times, body = e.args[1], 0, e
    order = _latex(e.args[2], SUM) if e.op == "nth" else ""
    while body.op == e.op and body.args[1] == place and place.op == "symbol":
        if not symbols(body.args[0]).isdisjoint(symbols(place)):
            break
        times, body = times + 1, instantiate(body.args[0], (place,))
        if order:
            break
    if not times:
        (name,), body = opened(e)
        x, inner = _name(name), _latex(body, PRODUCT)
        shown = f"^{{{order}}}" if order else ""
        return (
            rf"\left.\frac{{d{shown}}}{{d{x}{shown}}} {inner}\right|_{{{x}={_latex(place, SUM)}}}"
        )
    shown = f"^{{{order or times}}}" if order or times > 1 else ""
    return rf"\frac{{d{shown}}}{{d{_latex(place, SUM)}{shown}}} {_latex(body, PRODUCT)}"


def _name(name: str) -> str:
    head, _, foot = name.partition("_")
    stem = head.rstrip("0123456789")
    foot = foot or head[len(stem) :]
    shown = rf"\{stem}" if stem in GREEK else stem if len(stem) == 1 else rf"\mathrm{{{stem}}}"
    return f"{shown}_{{{foot}}}" if foot else shown


def _bracketed(text: str) -> str:
    return rf"\left({text}\right)" if r"\frac" in text or r"\int" in text else f"({text})"
