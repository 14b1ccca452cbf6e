"""Write formulas, as they were read, in MathML."""

from __future__ import annotations

import re
from html import escape, unescape

from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import DOTS, Expr, number, opened
from tresym.reals.language.latex_tokens import GREEK
from tresym.reals.language.parsing import Compared
from tresym.reals.numbers.exact import fraction_text

_RELATIONS = {"==": "=", "!=": "≠", "<=": "≤", ">=": "≥", "<": "&lt;", ">": "&gt;", "~": "∼"}
_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln"}
_SUM, _PRODUCT, _POWER, _ATOM = range(4)


def relation(compared: Compared, block: bool = True) -> str:
    """``left relation right`` as a formula of its own, or in the line."""
    left, sign, right = compared
    shown = _RELATIONS.get(sign, escape(sign))
    start = '<math display="block">' if block else "<math>"
    return f"{start}{_row(left)}<mo>{shown}</mo>{_row(right)}</math>"


def expression(e: Expr) -> str:
    """An expression as a formula in the line."""
    return f"<math>{_row(e)}</math>"


def _row(e: Expr) -> str:
    return f"<mrow>{_shown(e, _SUM)}</mrow>"


def _shown(e: Expr, around: int) -> str:
    """In brackets where what stands around it binds more strongly."""
    text, strength = _written(e)
    return f"<mrow><mo>(</mo>{text}<mo>)</mo></mrow>" if strength < around else text


def _written(e: Expr) -> tuple[str, int]:
    """The formula, and how strongly it binds."""
    match e.op:
        case "number":
            return _number(e)
        case "symbol":
            marks = {INFINITY: "<mi>∞</mi>", DOTS: "<mo>⋯</mo>"}
            return marks.get(e) or _symbol(str(e.args[0])), _ATOM
        case "pi":
            return "<mi>π</mi>", _ATOM
        case "+":
            return _sum(e), _SUM
        case "*":
            return _product(e)
        case "^":
            return _power(e)
        case "exp":
            return f"<msup><mi>e</mi>{_row(e.args[0])}</msup>", _POWER
        case "abs":
            return f"<mrow><mo>|</mo>{_row(e.args[0])}<mo>|</mo></mrow>", _ATOM
        case "integral" | "antiderivative" | "sum" | "product" | "limit" | "derivative" | "at":
            return _binder(e), _PRODUCT
        case "unknown":
            name, orders = e.args[0].args
            primes = "".join("<mo>′</mo>" * n for n in orders[:1])
            return f"{_symbol(name)}{primes}{_list(e.args[1:])}", _ATOM
    name = escape(_NAMES.get(e.op, e.op))
    return f"<mrow><mi>{name}</mi>{_list(e.args)}</mrow>", _ATOM


def _list(args: tuple[Expr, ...]) -> str:
    return f"<mrow><mo>(</mo>{'<mo>,</mo>'.join(map(_row, args))}<mo>)</mo></mrow>"


def _number(e: Expr) -> tuple[str, int]:
    value = e.args[0]
    if value.q == 1:
        return f"<mn>{value.p}</mn>", _ATOM if value >= 0 else _SUM
    sign = "<mo>−</mo>" if value < 0 else ""
    text = f"{sign}<mfrac><mn>{abs(value.p)}</mn><mn>{value.q}</mn></mfrac>"
    return text, _SUM if sign else _PRODUCT


def _letter(name: str) -> str:
    """A Greek letter by its name, and any other as it is."""
    return unescape(f"&{name};") if name in GREEK else escape(name)


def _symbol(name: str) -> str:
    """``psi0`` with its subscript, ``theta_`` by its letter, ``dx_dt`` as a fraction."""
    slope = re.fullmatch(r"(d|partial)(\d?)([A-Za-z]\w*?)_(?:d|partial)([A-Za-z]\w*?)\2", name)
    if slope:
        d = {"d": "d", "partial": "∂"}[slope[1]]
        order = f"<msup><mi>{d}</mi><mn>{slope[2]}</mn></msup>" if slope[2] else f"<mi>{d}</mi>"
        below = _symbol(slope[4])
        below = f"<msup>{below}<mn>{slope[2]}</mn></msup>" if slope[2] else below
        above, below = f"{order}{_symbol(slope[3])}", f"<mi>{d}</mi>{below}"
        return f"<mfrac><mrow>{above}</mrow><mrow>{below}</mrow></mfrac>"
    primed = re.fullmatch(r"(\w+?)_prime(\d?)", name)
    if primed:
        return f"<msup>{_symbol(primed[1])}<mo>{'′' * int(primed[2] or 1)}</mo></msup>"
    head, _, rest = name.rstrip("_").partition("_")
    letters = re.fullmatch(r"([A-Za-z]+)(\d+)", head)
    head, rest = (letters[1], letters[2] + rest) if letters else (head, rest)
    base = f"<mi>{_letter(head)}</mi>"
    if not rest:
        return base
    return f"<msub>{base}<mi>{_letter(rest)}</mi></msub>"


def _sum(e: Expr) -> str:
    shown = []
    for n, term in enumerate(sorted(e.args, key=_is_negative)):  # 1 − x before −x + 1
        negative = _is_negative(term)
        sign = "<mo>−</mo>" if negative else ("<mo>+</mo>" if n else "")
        shown.append(sign + _shown(-term if negative else term, _PRODUCT))
    return "".join(shown)


def _is_negative(e: Expr) -> bool:
    first = e.args[0] if e.op == "*" else e
    return bool(first.op == "number" and first.args[0] < 0)


def _product(e: Expr) -> tuple[str, int]:
    if _is_negative(e):
        return f"<mo>−</mo>{_shown(-e, _PRODUCT)}", _SUM
    above: list[Expr] = []
    below: list[Expr] = []
    for factor in e.args:
        if factor.op == "number" and factor.args[0].q != 1:
            above += [number(factor.args[0].p)] if factor.args[0].p != 1 else []
            below.append(number(factor.args[0].q))
        elif factor.op == "^" and factor.args[1].op == "number" and factor.args[1].args[0] < 0:
            below.append(factor.args[0] ** number(-factor.args[1].args[0]))
        else:
            above.append(factor)
    if not below:
        return _factors(above), _PRODUCT
    return f"<mfrac><mrow>{_factors(above)}</mrow><mrow>{_factors(below)}</mrow></mfrac>", _PRODUCT


def _factors(factors: list[Expr]) -> str:
    if len(factors) == 1:
        return _shown(factors[0], _SUM)
    shown = [_shown(factor, _PRODUCT if n else _POWER) for n, factor in enumerate(factors)]
    return "<mo>&#x2062;</mo>".join(shown) or "<mn>1</mn>"


def _power(e: Expr) -> tuple[str, int]:
    base, exponent = e.args
    if exponent.op == "number":
        value = exponent.args[0]
        if value < 0:
            return f"<mfrac><mn>1</mn>{_row(base ** number(-value))}</mfrac>", _PRODUCT
        if fraction_text(value) == "1/2":
            return f"<msqrt>{_row(base)}</msqrt>", _ATOM
    return f"<msup><mrow>{_shown(base, _ATOM)}</mrow>{_row(exponent)}</msup>", _POWER


def _binder(e: Expr) -> str:
    (name, *_), body = opened(e)
    variable = _symbol(name)
    if e.op == "limit":
        side = {1: "<mo>+</mo>", -1: "<mo>−</mo>"}.get(int(e.args[2].args[0].p), "")
        under = f"<mrow>{variable}<mo>→</mo>{_row(e.args[1])}{side}</mrow>"
        return f"<munder><mo>lim</mo>{under}</munder>{_shown(body, _PRODUCT)}"
    if e.op == "derivative":
        slope = f"<mfrac><mi>d</mi><mrow><mi>d</mi>{variable}</mrow></mfrac>{_shown(body, _POWER)}"
        if e.args[1].op == "symbol" and e.args[1].args[0] == name:
            return slope
        return _at(slope, f"{variable}<mo>=</mo>{_row(e.args[1])}")
    if e.op == "at":
        names, body = opened(e)
        pairs = (f"{_symbol(n)}<mo>=</mo>{_row(v)}" for n, v in zip(names, e.args[1:], strict=True))
        return _at(_shown(body, _SUM), "<mo>,</mo>".join(pairs))
    if e.op == "antiderivative":
        return f"<mo>∫</mo>{_shown(body, _PRODUCT)}<mi>d</mi>{variable}"
    low, high = _row(e.args[1]), _row(e.args[2])
    if e.op == "integral":
        ends = f"<msubsup><mo>∫</mo>{low}{high}</msubsup>"
        return f"{ends}{_shown(body, _PRODUCT)}<mi>d</mi>{variable}"
    sign = "∑" if e.op == "sum" else "∏"
    under = f"<mrow>{variable}<mo>=</mo>{low}</mrow>"
    return f"<munderover><mo>{sign}</mo>{under}{high}</munderover>{_shown(body, _PRODUCT)}"


def _at(formula: str, place: str) -> str:
    return f"<msub><mrow><mo>[</mo>{formula}<mo>]</mo></mrow><mrow>{place}</mrow></msub>"
