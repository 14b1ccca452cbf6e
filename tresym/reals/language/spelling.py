"""Expressions as people type them, written in the grammar: ``2x`` as ``2*x``.

A recursive descent over :mod:`tresym.reals.language.typed_text`, one function for each production:
of ``2 sin^2 x`` :func:`spell_product` reads the factors 2 and ``sin^2 x``, and for the second
:func:`spell_function` writes ``sin(x)**2``. It knows implicit products, functions without
parentheses, powers of functions, factorials, degrees, and integrals, sums, limits and derivatives
by hand and in SymPy, Mathematica and Maple. What can be read in two ways is refused, with both
written out. Nothing is evaluated: the result is text, which the strict reader of
:mod:`tresym.reals.language.parsing` reads.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from tresym.reals.language.calls import KNOWN, MODULUS, UNKNOWN
from tresym.reals.language.expression import ORDERS
from tresym.reals.language.operators import SIGNS, WORDS, Range, is_complete, written
from tresym.reals.language.spelling_tokens import SUB, Token
from tresym.reals.language.typed_text import (
    CLOSING,
    FUNCTIONS,
    INFINITE,
    RESERVED,
    NotSpelledError,
    Typed,
    bare,
    two,
)
from tresym.reals.numbers.exact import InputError

SIDES = {"+": "1", "-": "-1", "+-": "0", "right": "1", "left": "-1"}
_CHOOSE = frozenset(("binomial", "Binomial", "binom", "choose", "comb", "nCr", "C"))
_LOGARITHMS = frozenset(("log", "ln", "Log", "Ln"))
_DERIVED = frozenset(("D", "diff", "Derivative"))


# Sums and products


def spell_sum(typed: Typed) -> str:
    """An expression."""
    text = spell_product(typed)
    while typed.peek().text in ("+", "-"):
        sign = typed.next().text
        text += f" {sign} {spell_product(typed)}"
    return text


def spell_product(typed: Typed) -> str:
    """Factors, between some of which the sign is left out."""
    text = last = spell_unary(typed)
    slash = ""
    while True:
        if typed.peek().text in ("*", "/"):
            sign = typed.next().text
            if sign == "/":
                slash = text
            last = spell_unary(typed)
            text = f"{text}{sign}{last}"
            slash = slash if sign == "/" else ""
        elif typed.starts_factor():
            after = typed.tokens[typed.at + 1 : typed.at + 2]
            compares = bool(after) and after[0].text[:1] in ("<", ">", "=", "≤", "≥")
            if last in ("0", "1") and typed.peek().spaced and compares:  # as in x > 0 y > 0
                raise InputError(
                    f"a comma or a sign is missing between {last} and {typed.peek().text}"
                )
            factor = spell_power(typed)
            if slash:
                raise two(f"({slash}/{last})*{factor}", f"{slash}/({last}*{factor})")
            text = f"{text}*{factor}"
        else:
            return text


def spell_unary(typed: Typed) -> str:
    """A power with its signs."""
    if typed.peek().text in ("+", "-"):
        sign = typed.next().text
        inner = spell_unary(typed)
        return f"(-{inner})" if sign == "-" else inner
    return spell_power(typed)


def spell_power(typed: Typed) -> str:
    """``a^b``, with what stands behind ``a``."""
    base = spell_behind(typed, spell_atom(typed))
    if not typed.take("^", "**"):
        return base
    first = typed.peek()
    exponent = spell_unary(typed)
    after, closed = typed.peek(), first.text == "("
    last = typed.tokens[typed.at - 1]
    plain = last.kind in ("number", "name") and not closed
    glued = not after.spaced and "name" in (after.kind, last.kind)
    if plain and glued and typed.starts_factor():
        factor = spell_power(typed)
        raise two(f"{base}**{exponent}*{factor}", f"{base}**({exponent}*{factor})")
    return f"{base}**{exponent}"


def spell_behind(typed: Typed, text: str) -> str:
    """What stands behind an operand: ``!``, ``°``, ``'``."""
    while True:
        if typed.peek().text == "!":
            typed.next()
            if typed.peek().text == "!" and not typed.peek().spaced:
                typed.next()
                text = f"factorial2({bare(text)})"
                continue
            text = f"factorial({bare(text)})"
        elif typed.peek().text == "°" or typed.peek().text in ("deg", "degrees"):
            typed.next()
            text = f"({text}*pi/180)"
        elif typed.peek().text == "'":
            typed.next()
            text = f"diff({bare(text)}, {only_variable(text)})"
        else:
            return text


def only_variable(text: str) -> str:
    """The one variable of a text, by which a derivative without a name is."""
    names = set(re.findall(r"[A-Za-z_]\w*(?!\w*\()", text)) - {"pi", "E", "e"}
    if len(names) != 1:
        raise InputError("a derivative is written diff(f, x), with the variable it is by")
    return names.pop()


# Operands


def spell_atom(typed: Typed) -> str:
    """A number, a name, a function at its arguments, or what is in parentheses."""
    token = typed.next()
    if token.kind == "number" or token.text == "...":
        return token.text
    if token.text in SIGNS:
        return spell_operator(typed, token)
    if token.text == "[" and typed.peek(1).text in ("^", "**"):
        return spell_coefficient(typed)
    if token.text in ("(", "["):
        return f"({spell_inside(typed, CLOSING[token.text])})"
    if token.text == "|":
        typed.bars += 1
        text = spell_sum(typed)
        typed.need("|")
        typed.bars -= 1
        return f"abs({text})"
    if token.kind != "name" or token.text in RESERVED:
        raise NotSpelledError
    return spell_named(typed, token)


def spell_coefficient(typed: Typed) -> str:
    """``[z^n] f``, behind its bracket: the coefficient of a product or of what is in brackets."""
    name = typed.next().text
    typed.next()
    n = spell_inside(typed, "]")
    body = spell_product(typed)
    if typed.peek().text in ("+", "-") and not typed.peek(1).text.startswith("O"):
        raise two(f"coefficient({body}, {name}, {n}) + …", f"coefficient({body} + …, {name}, {n})")
    return f"coefficient({body}, {name}, {n})"


def spell_inside(typed: Typed, close: str) -> str:
    """The expression up to a closing bracket, which bars and big operators do not cross."""
    bars, typed.bars, under, typed.under = typed.bars, 0, typed.under, []
    text = spell_sum(typed)
    typed.need(close)
    typed.bars, typed.under = bars, under
    return text


def spell_named(typed: Typed, token: Token) -> str:
    """What begins with a name."""
    name, after = token.text, typed.peek().text
    if name in INFINITE:
        return "oo"
    if name == "d" and (found := spell_derivative(typed)):
        return found
    if re.fullmatch("d[a-zA-Z]", name) and after == "/" and typed.peek(1).text[:1] == "d":
        raise InputError(f"a derivative is written diff(f, x): write {name[1:]} out")
    opens = after in ("(", "[") and not (after == "[" and typed.peek().spaced)
    if name in WORDS and typed.is_operator(name):
        return spell_operator(typed, token)
    if name in _DERIVED and opens:
        return spell_derived(typed)
    if name in _CHOOSE and opens and (name != "C" or typed.has_comma()):
        n, k = spell_arguments(typed, 2)
        return f"(factorial({n})/(factorial({k})*factorial({n} - ({k}))))"
    if base := re.fullmatch(r"log_?(\d+|[a-z])", name):
        return spell_logarithm(typed, base[1])
    if name in ("lg", "ld") and opens:
        (x,) = spell_arguments(typed, 1)
        raise two(f"log({x}, 10)", f"log({x}, 2)")
    if name in ("pow", "Power") and opens:
        x, y = spell_arguments(typed, 2)
        return f"({x})**({y})"
    if name == "Rational" and opens:
        p, q = spell_arguments(typed, 2)
        return f"({p}/{q})"
    if name in _LOGARITHMS and opens and (found := spell_to_base(typed, name)):
        return found
    if name in MODULUS and typed.brackets:
        return spell_function(typed, MODULUS[name])
    if name in FUNCTIONS:
        return spell_function(typed, FUNCTIONS[name])
    if after == "'":
        return spell_primed(typed, name)
    if opens:
        return spell_letter(typed, name, token)
    return spell_constant(typed, name)


def spell_constant(typed: Typed, name: str) -> str:
    """A name that stands by itself."""
    if name == "Pi":
        if typed.brackets or typed.maple:
            return "pi"
        raise InputError("two readings remain: write pi, or the variable Pi by another name")
    if name == "I":
        raise InputError("complex numbers are not read: all variables are real")
    letters = set(name)
    short = 1 < len(name) < 4 and name.isalpha() and name not in KNOWN | {"pi"}
    if short and letters <= typed.alone:
        raise InputError(
            f"two readings remain: write {'*'.join(name)}, or the variable {name} by another name"
        )
    return name


def spell_letter(typed: Typed, name: str, token: Token) -> str:
    """A letter before parentheses: a function that is left unknown, or a factor."""
    if name in typed.sequences and name not in typed.alone:
        return f"{name}({', '.join(spell_arguments(typed))})"
    if name in typed.alone or name in ("pi", "E", "e"):
        check_product(typed, name)
        return spell_constant(typed, name)
    if UNKNOWN.fullmatch(name) or name in ORDERS:
        return f"{name}({', '.join(spell_arguments(typed))})"
    if len(name) == 1:
        raise InputError(
            f"{name} is no function; for a product write {name}*(…), for a function f(…)"
        )
    return f"{name}({', '.join(spell_arguments(typed))})"


def check_product(typed: Typed, name: str) -> None:
    """That no value of a function is meant by what is read as a product."""
    inside = typed.peek(1)
    if inside.kind == "number" and typed.peek(2).text in (")", "]"):
        raise InputError(
            f"two readings remain: write {name}*{inside.text}, or the value of the function "
            f"{name} as at(f, x, {inside.text})"
        )
    closing = next((n for n, t in enumerate(typed.tokens) if n > typed.at and t.text == ")"), 0)
    if UNKNOWN.fullmatch(name) and name not in {t.text for t in typed.tokens[typed.at : closing]}:
        raise NotSpelledError


def spell_primed(typed: Typed, name: str) -> str:
    """``f'(x)`` of a function that is left unknown, behind its name."""
    start = typed.at
    while typed.take("'"):
        pass
    times = typed.at - start
    if not UNKNOWN.fullmatch(name) or typed.peek().text != "(":
        raise InputError(f"a derivative is written diff(f, x): write {name} out, or {name}(x)")
    (x,) = spell_arguments(typed, 1)
    if not x.isidentifier():
        raise InputError(f"a derivative at a point is written at(diff({name}(x), x), x, {x})")
    return f"diff({name}({x}), {x}{f', {times}' if times > 1 else ''})"


# Functions and their arguments


def spell_function(typed: Typed, name: str) -> str:
    """A function of the grammar with its argument, in parentheses or not, its power between."""
    exponent = ""
    if typed.peek().text in ("^", "**"):
        typed.next()
        sign = typed.take("-")
        closed = typed.take("(")
        exponent = (sign or typed.take("-")) + typed.next().text
        if closed:
            typed.need(")")
        if not re.fullmatch(r"-?(?:\d+|[a-z])", exponent):
            raise NotSpelledError
    prime = typed.take("'")
    if typed.peek().text in ("(", "["):
        args = spell_arguments(typed)
    elif typed.peek().kind == "number" or typed.starts_factor() or typed.peek().text == "-":
        args = [spell_bare_argument(typed, name, exponent)]
    else:
        raise NotSpelledError
    text = f"{name}({', '.join(args)})"
    if prime:
        text = f"diff({text}, {only_variable(args[0])})"
    if exponent.startswith("-"):
        other = f"a{name}({args[0]})" if f"a{name}" in KNOWN else f"the inverse of {name}"
        raise two(f"1/{text}" if exponent == "-1" else f"{text}**({exponent})", other)
    return f"{text}**{exponent}" if exponent else text


def spell_bare_argument(typed: Typed, name: str, exponent: str) -> str:
    """The argument of a function that stands without parentheses, as in ``sin 2x``."""
    sign = "-" if typed.take("-") else ""
    factors = [spell_factor(typed)]
    while typed.starts_factor() and not is_function(typed.peek()):
        before = typed.tokens[typed.at - 1]
        if typed.peek().text in ("(", "|") and before.kind != "number":
            break
        factors.append(spell_factor(typed))
    text = sign + "*".join(factors)
    power = f"**{exponent}" if exponent else ""
    if len(factors) > 1 and name in ("sqrt", "cbrt"):
        rest = "*".join(factors[1:])
        raise two(f"{name}({factors[0]})*{rest}", f"{name}({text})")
    after = typed.peek().text
    if after == "(":
        raise two(f"{name}({text}){power}*(…)", f"{name}({text}*(…)){power}")
    if after in ("^", "**"):
        typed.next()
        k = spell_unary(typed)
        raise two(f"{name}({text}**{k}){power}", f"{name}({text})**{k}")
    ended = name in ("sqrt", "cbrt") or is_function(typed.peek(1))
    if after in ("*", "/") and not ended:
        typed.next()
        factor = spell_unary(typed)
        inner = f"{name}({text}{after}{factor}){power}"
        raise two(f"{name}({text}){power}{after}{factor}", inner)
    return text


def spell_factor(typed: Typed) -> str:
    """One factor of a bare argument."""
    return spell_behind(typed, spell_atom(typed))


def is_function(token: Token) -> bool:
    """Whether a token begins a function or a big operator."""
    return token.text in FUNCTIONS or token.text in WORDS


def spell_to_base(typed: Typed, name: str) -> str:
    """``Log[2, 8]`` of Mathematica, base first, and ``log[2](8)`` of Maple; else nothing."""
    start, square = typed.at, typed.peek().text == "["
    args = spell_arguments(typed)
    if square and len(args) == 1 and typed.peek().text == "(" and not typed.peek().spaced:
        (x,) = spell_arguments(typed, 1)
        return f"log({x}, {args[0]})"
    if len(args) == 2 and square:
        return f"log({args[1]}, {args[0]})"
    if len(args) == 2 and name[0].isupper():
        raise two(f"log({args[0]}, {args[1]})", f"log({args[1]}, {args[0]})")
    typed.at = start
    return ""


def spell_logarithm(typed: Typed, base: str) -> str:
    """``log2(x)``, ``log_10 x``."""
    if typed.peek().text in ("(", "["):
        (x,) = spell_arguments(typed, 1)
    elif typed.starts_factor():
        x = spell_bare_argument(typed, "log", "")
    else:
        raise NotSpelledError
    return f"log({x}, {base})"


def spell_arguments(typed: Typed, count: int | None = None) -> list[str]:
    """The arguments of a function, expressions all of them."""
    found = spell_items(typed)
    if any(isinstance(item, Range) for item in found):
        raise NotSpelledError
    if count is not None and len(found) != count:
        raise NotSpelledError
    return [str(item) for item in found]


def spell_items(typed: Typed) -> list[str | Range[str]]:
    """What stands in parentheses or brackets, between commas."""
    close = CLOSING[typed.need("(", "[")]
    bars, typed.bars, under, typed.under = typed.bars, 0, typed.under, []
    found: list[str | Range[str]] = []
    while True:
        found.append(spell_item(typed))
        if not typed.take(","):
            break
    typed.need(close)
    typed.bars, typed.under = bars, under
    return found


def spell_item(typed: Typed) -> str | Range[str]:
    """One argument: an expression, a range, or the side of a limit."""
    token, after = typed.peek(), typed.peek(1)
    if token.text == "dir" and after.text == "=":
        typed.at += 2
        token = typed.peek()
    if token.kind == "quoted":
        return Range("", (), SIDES[typed.next().text.strip("'\"")])
    if token.text in ("right", "left"):
        return Range("", (), SIDES[typed.next().text])
    if token.text in ("(", "{") and after.kind == "name" and typed.peek(2).text == ",":
        typed.at += 1
        name = typed.name()
        ends = []
        while typed.take(","):
            ends.append(spell_sum(typed))
        typed.need(CLOSING[token.text])
        return Range(name, tuple(ends))
    if token.kind == "name" and after.text in ("=", "->"):
        typed.at += 2
        return spell_range(typed, token.text, after.text)
    return spell_sum(typed)


# Derivatives


def spell_derivative(typed: Typed) -> str:
    """``d/dx f``, ``d^2/dx^2 f`` and ``d(f)/dx``, behind the d; nothing if it is none."""
    start = typed.at
    times = spell_order(typed)
    if typed.take("/") and re.fullmatch(r"d[a-zA-Z]\w*", typed.peek().text):
        name = typed.next().text[1:]
        if spell_order(typed) != times:
            raise NotSpelledError
        return spell_body_of_derivative(typed, name, times)
    typed.at = start
    if typed.peek().text == "(" and not typed.peek().spaced:
        typed.next()
        body = spell_inside(typed, ")")
        if typed.peek().text == "/" and re.fullmatch(r"d[a-zA-Z]\w*", typed.peek(1).text):
            typed.next()
            return f"diff({body}, {typed.next().text[1:]})"
    typed.at = start
    return ""


def spell_order(typed: Typed) -> str:
    """The order of a derivative, behind its d; nothing if it is the first."""
    if not typed.take("^", "**"):
        return ""
    closed = typed.take("(")
    found = typed.next()
    if closed:
        typed.need(")")
    if found.kind != "number":
        raise NotSpelledError
    return found.text


def spell_body_of_derivative(typed: Typed, name: str, times: str) -> str:
    """What is differentiated: all factors up to a plus, a minus or a relation."""
    order = f", {times}" if times else ""
    closed = typed.peek().text in ("(", "[")
    start = typed.at
    body = spell_product(typed)
    if closed and typed.tokens[start].text == "(" and not _is_closed(body):
        raise two(f"diff({body}, {name}{order})", f"diff(…, {name}{order})*…")
    if not closed and typed.peek().text in ("+", "-"):
        sign = typed.next().text
        rest = spell_sum(typed)
        raise two(
            f"diff({body}, {name}{order}) {sign} {rest}",
            f"diff({body} {sign} {rest}, {name}{order})",
        )
    return f"diff({bare(body)}, {name}{order})"


def spell_derived(typed: Typed) -> str:
    """``D[f, x]``, ``D[f, {x, 2}]``, ``diff(f, x)``, ``Derivative(f, (x, 2))``."""
    body, *by = spell_items(typed)
    if isinstance(body, Range) or not by:
        raise NotSpelledError
    if len(by) == 2 and all(isinstance(item, str) for item in by):
        if not str(by[1]).isdigit():
            return f"diff(diff({body}, {by[0]}), {by[1]})"
        return f"diff({body}, {by[0]}, {by[1]})"
    for item in by:
        if isinstance(item, Range):
            body = f"diff({body}, {', '.join((item.name, *item.ends))})"
        else:
            body = f"diff({body}, {item})"
    return str(body)


# Integrals, sums, products and limits


def spell_operator(typed: Typed, token: Token) -> str:
    """An integral, a sum, a product or a limit."""
    kind = WORDS[token.text]
    if token.text not in SIGNS and typed.peek().text in ("(", "[") and typed.has_comma():
        return spell_called(typed, kind, token.text)
    low = high = ""
    found: Range[str] | None = None
    if typed.take(SUB):
        if kind == "integral":
            low = spell_bound(typed)
        else:
            found = spell_bound_variable(typed, kind)
        if typed.take("^", "**"):
            high = spell_bound(typed)
    if kind == "limit":
        return spell_limit(typed, found)
    if found is not None and high:
        found = Range(found.name, (found.ends[0], high))
    typed.take("of")
    typed.under.append(kind)
    body = spell_sum(typed) if kind == "integral" else spell_product(typed)
    typed.under.pop()
    if kind == "integral":
        return spell_integral(typed, body, tuple(filter(None, (low, high))))
    return spell_total(typed, kind, body, found)


def spell_bound(typed: Typed) -> str:
    """An end of an integral: signed, or in parentheses."""
    if typed.peek().text in ("(", "{"):
        return spell_inside(typed, CLOSING[typed.next().text])
    sign = "-" if typed.take("-") else ""
    token = typed.next()
    if token.kind not in ("number", "name"):
        raise NotSpelledError
    return sign + ("oo" if token.text in INFINITE else token.text)


def spell_bound_variable(typed: Typed, kind: str) -> Range[str]:
    """``k=1`` or ``x->0`` under a sum or a limit."""
    close = CLOSING.get(typed.take("(", "{"), "")
    name = typed.name()
    found = spell_range(typed, name, typed.need("->" if kind == "limit" else "="))
    if close:
        typed.need(close)
    return found


def spell_range(typed: Typed, name: str, sign: str) -> Range[str]:
    """``x = a .. b``, ``x = a`` or ``x -> a+``, behind the sign."""
    low = spell_signed_end(typed) if sign == "->" else spell_sum(typed)
    if typed.take(".."):
        return Range(name, (low, spell_sum(typed)))
    side = ""
    if sign == "->" and typed.peek().text in ("+", "-", "^"):
        typed.take("^")
        side = SIDES[typed.need("+", "-")]
    return Range(name, (low,), side)


def spell_signed_end(typed: Typed) -> str:
    """A point, behind which ``+`` and ``-`` say from which side."""
    sign = "-" if typed.take("-") else ""
    typed.take("+")
    text = sign + spell_behind(typed, spell_atom(typed))
    if typed.peek().text in ("/", "*") and typed.peek(1).kind in ("number", "name"):
        text += typed.next().text + spell_behind(typed, spell_atom(typed))
    return text


def spell_integral(typed: Typed, body: str, ends: tuple[str, ...]) -> str:
    """An integral behind its integrand: ``dx``, and perhaps ``from a to b``."""
    by = typed.peek()
    if re.fullmatch("d[a-zA-Z]", by.text):
        name = typed.next().text[1:]
    else:
        name = only_variable(body)
        if typed.peek().text != "from":
            raise NotSpelledError
    if len(ends) < 2 and typed.take("from"):
        low = spell_sum(typed)
        typed.need("to")
        ends = low, spell_sum(typed)
    bound = Range(name, ends)
    if not is_complete("integral", bound):
        raise NotSpelledError
    return written("integral", bound, body)


def spell_total(typed: Typed, kind: str, body: str, found: Range[str] | None) -> str:
    """A sum or a product behind its term."""
    if found is None:
        typed.need("from", "for")
        name = typed.name()
        typed.need("=", "from")
        low = spell_sum(typed)
        typed.need("to", "..")
        found = Range(name, (low, spell_sum(typed)))
    return spell_reach(typed, kind, found, body)


def spell_limit(typed: Typed, found: Range[str] | None) -> str:
    """``lim x->0 f``, ``lim_(x->0) f``, ``limit of f as x->0``."""
    typed.take("as")
    if found is None and typed.peek().text == "(" and typed.peek(2).text == "->":
        found = spell_bound_variable(typed, "limit")
    elif found is None and typed.peek(1).text == "->":
        found = spell_range(typed, typed.name(), typed.next().text)
    typed.take("of", ",")
    body = spell_product(typed)
    if found is None and typed.take("as"):
        name = typed.name()
        skip_arrow(typed)
        found = spell_range(typed, name, "->")
    if found is None:
        raise NotSpelledError
    return spell_reach(typed, "limit", found, bare(body))


def spell_reach(typed: Typed, kind: str, bound: Range[str], body: str) -> str:
    """A sum, a product or a limit, unless a term that follows may belong to its body."""
    if not is_complete(kind, bound):
        raise NotSpelledError
    text = written(kind, bound, body)
    if typed.peek().text in ("+", "-"):
        sign = typed.next().text
        rest = spell_product(typed)
        raise two(f"{text} {sign} {rest}", written(kind, bound, f"{body} {sign} {rest}"))
    return text


def skip_arrow(typed: Typed) -> None:
    """``->``, or its words."""
    if typed.take("tends", "goes"):
        typed.need("to")
    else:
        typed.need("->", "approaches")


def spell_called(typed: Typed, kind: str, name: str) -> str:
    """An integral, a sum or a limit as a function of SymPy, Mathematica or Maple."""
    mathematica = typed.peek().text == "["
    body, *rest = spell_items(typed)
    if isinstance(body, Range):
        raise NotSpelledError
    if kind == "limit":
        return _called_limit(body, rest, name == "Limit" and not mathematica)
    texts = [item for item in rest if isinstance(item, str)]
    if len(texts) == len(rest) and len(rest) in (1, 3):
        return f"{kind}({', '.join((body, *texts))})"
    ranges = [item if isinstance(item, Range) else Range(item, ()) for item in rest]
    for found in reversed(ranges) if mathematica else ranges:
        ends = found.ends
        if kind != "integral" and len(ends) == 1:
            ends = ("1", *ends)
        if len(ends) == 1:
            raise NotSpelledError
        body = written(kind, Range(found.name, ends), body)
    return body


def _is_closed(text: str) -> bool:
    return bare(text) != text


def _called_limit(body: str, rest: Iterable[str | Range[str]], right: bool) -> str:
    """A limit as a function, at a finite point from the right if ``right`` and no side is given.

    That is what ``Limit`` means in SymPy.
    """
    texts, side = [], ""
    for item in rest:
        if isinstance(item, str):
            texts.append(item)
        elif item.name:
            texts += [item.name, *item.ends]
            side = item.side or side
        else:
            side = item.side
    if len(texts) == 3:
        side = texts.pop()
    if len(texts) != 2:
        raise NotSpelledError
    if right and not side and texts[1].strip("(-)") != "oo":
        side = "1"
    return written("limit", Range(texts[0], (texts[1],), side), bare(body))
