"""The grammar of LaTeX expressions: recursive descent, one function for each production.

Each function reads from the place of the cursor on and leaves the cursor behind what it read. Of
``\\frac{1}{2}x^2 + 1`` :func:`read_sum` reads the term ``\\frac{1}{2}x^2`` by :func:`read_product`,
this its factors ``\\frac{1}{2}`` and ``x^2`` by :func:`read_factor`, and this the base ``x`` by
:func:`read_base`, and the exponent. What is read is a :class:`Piece`, a tree that knows how it
stands in print. What print leaves open is in :mod:`tresym.reals.language.latex_ambiguity`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from math import factorial

from tresym.reals.language.binders import (
    at,
    coefficient,
    derivative,
    limit,
    nth_derivative,
    order,
    outermost,
    repeated_derivative,
)
from tresym.reals.language.calls import INFINITY, call
from tresym.reals.language.expression import (
    DOTS,
    MAX_DERIVATIVES,
    MINUS_ONE,
    ONE,
    ORDERS,
    PI,
    E,
    Expr,
    add,
    apply,
    extreme,
    multiply,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.latex_ambiguity import (
    check_bracket,
    check_name,
    check_power_of_e,
    is_argument,
    is_product,
)
from tresym.reals.language.latex_author import Author, Function
from tresym.reals.language.latex_cursor import (
    BRACKETS,
    CLOSED,
    DIFFERENTIALS,
    FRACTIONS,
    INSTEAD,
    NO_DERIVATIVE,
    OPENING,
    OPERATORS,
    TIME,
    Cursor,
    derived,
    is_derivative,
    is_letter,
    is_number,
)
from tresym.reals.language.latex_operands import (
    Piece,
    Reach,
    Rule,
    after_braces,
    after_bracket,
    after_derivative,
    after_derivative_of_bracket,
    after_nested,
    after_open,
    decimal,
    joined,
    whole,
)
from tresym.reals.language.latex_tokens import (
    CLOSING,
    ELLIPSIS,
    EXTREMES,
    FUNCTIONS,
    GOES_ON,
    OF_GREEK,
    RELATIONS,
    STOPS,
    WITH_ORDER,
    Called,
)
from tresym.reals.language.operators import COMMANDS, Range
from tresym.reals.language.operators import applied as operated
from tresym.reals.language.parsing import sum_of
from tresym.reals.numbers.exact import InputError

OPENING_ARGUMENTS = ("(", "[", "\\{")
VARIABLES = frozenset(("x", "t", "s", "theta"))
"""Letters of what is differentiated by, where a prime behind a bracket does not say by what."""
MAX_FACTORIAL = 100
ROUNDING = {"\\lfloor": "floor", "\\lceil": "ceiling"}


# Sums and products


def read_sum(cursor: Cursor) -> Piece:
    """Terms joined by + and −."""
    first = read_first_term(cursor)
    terms = [first.tree]
    while cursor.peek() in ("+", "-") and not cursor.sides():
        if cursor.peek(1) == ELLIPSIS:
            cursor.at += 2
            terms.append(DOTS)
            continue
        terms.append(
            -read_product(cursor).tree if cursor.take() == "-" else read_product(cursor).tree
        )
        if cursor.bar[0] == cursor.at and cursor.bar[1] in symbols(add(*terms[:-1])):
            cursor.refuse("of the terms before an evaluation bar which are meant? Write brackets")
    return first if len(terms) == 1 else Piece(sum_of(*terms), 0)


def read_first_term(cursor: Cursor) -> Piece:
    """The first term of a sum, perhaps with a sign."""
    if cursor.peek() not in ("+", "-"):
        return read_product(cursor)
    sign, piece = cursor.take(), read_product(cursor)
    if sign == "+":
        return Piece(piece.tree, 1)
    return Piece(-piece.tree, 1, printed=piece.printed and f"-{piece.printed}")


def read_product(cursor: Cursor) -> Piece:
    """Factors side by side; a slash divides by one factor, and what follows it is refused."""
    factors, operators = [read_factor_or_differential(cursor)], [""]
    while (factors in ([None], [None, None]) or factors[-1]) and cursor.continues():
        read_next_factor(cursor, factors, operators)
    if factors[0] is None and len(factors) > 1:
        check_integrand(cursor, factors)
    piece = joined(factors, operators)
    if cursor.at_bar() and cursor.bars == 0:
        cursor.at += 1
        piece = read_values_at(cursor, piece.tree)
    return piece


def check_integrand(cursor: Cursor, factors: list[Piece | None]) -> None:
    """Refuse ``\\int dx x + 1``, where it is in doubt what is integrated."""
    more = cursor.peek() in ("+", "-") and cursor.peek(1) not in ("\\int", "C")
    if None in factors[1:] or more:
        cursor.refuse("what of this is integrated? Write the differential last,")


def read_next_factor(cursor: Cursor, factors: list[Piece | None], operators: list[str]) -> None:
    """One more factor of a product, which a sign may lead in."""
    if cursor.peek() in OPERATORS:
        operators.append("/" if cursor.take() == "/" else "*")
        factors.append(read_factor_or_differential(cursor))
        return
    last = factors[-1] or Piece(ONE)
    if operators[-1] == "/" and not cursor.at_differential():
        cursor.refuse("what is below the slash? Write it with \\frac or in brackets,")
    if is_number(cursor.peek()) and is_number(cursor.tokens[cursor.at - 1]):
        cursor.refuse("two numbers side by side: one with spaces, or a product?")
    opening = cursor.peek(1) if cursor.peek() == "{" else cursor.peek()
    name = "pi" if last.tree == PI else last.symbol
    bracket = cursor.at + (cursor.peek() == "{")
    limits = opening == "[" and cursor.tokens[cursor.partner(bracket) + 1 :][:1] == ["_"]
    if name and opening in OPENING_ARGUMENTS and not limits and not cursor.guesses:
        value = read_factor_in_brackets(cursor, last, name)
        if value is None:
            factors[-1] = read_unknown_value(cursor, name)
            return
        factors.append(value)
    else:
        factors.append(read_factor_or_differential(cursor))
    operators.append("*")
    new = factors[-1]
    if last.symbol == "d" and new and new.symbol and not cursor.guesses:
        cursor.refuse("d before a letter is a differential,")
    if last.printed and new and new.tree.op == "number" and new.strength == 2:
        cursor.two_readings(f"{last.printed} + {new.tree}", f"{last.printed}*({new.tree})")


def read_factor_or_differential(cursor: Cursor) -> Piece | None:
    """A factor, or None where the differential of an integral was stepped over."""
    if not cursor.at_differential():
        return read_factor(cursor)
    cursor.take("d")
    cursor.differentials.append(cursor.symbol())
    return None


def read_factor_in_brackets(cursor: Cursor, last: Piece, name: str) -> Piece | None:
    """The bracket behind a symbol, where a product needs it: x(x + 1), and (a/r)² behind V.

    Without that need, as in x(0) and V(2r), it may hold the argument of a function; so may a
    sum behind a capital, a Greek or a subscripted letter that never stands alone. An author's
    longer reading is the value of the function, for which None is the answer.
    """
    if cursor.is_list():
        cursor.refuse(f"{name}(…) is a function that is not known: write out what it is,")
    start, braced = cursor.at, cursor.peek() == "{"
    if cursor.peek(braced) == "\\{":
        cursor.refuse("braces behind a name may hold the argument of a transform,")
    cursor.at += braced
    inner = read_enclosed(cursor)
    if braced:
        cursor.take("}")
    if name != "pi" and not is_product(cursor, name, inner):
        value = f"{name}_1 for the value of a function {name}"
        if not cursor.author or not (cursor.author.longer or cursor.author.shorter):
            cursor.two_readings(joined([last, inner], ["", "*"]), value)
        if cursor.author.longer:
            cursor.at = start
            return None
    return read_factor(cursor, Piece(inner.tree))


def read_unknown_value(cursor: Cursor, name: str) -> Piece:
    """The value of a function that is left unknown at what the bracket here holds."""
    braced = cursor.peek() == "{"
    cursor.at += braced
    value = Piece(unknown(name, (read_enclosed(cursor).tree,)))
    if braced:
        cursor.take("}")
    return read_factor(cursor, value)


def read_operand(
    cursor: Cursor,
    applied: Callable[[Piece], Piece],
    first: Piece,
    rule: Rule,
    matters: Callable[[Piece], bool] = lambda _: True,
) -> Piece:
    """``applied`` to ``first`` and to what follows, as far as the rule for it goes.

    Where it is in doubt whether the next factor belongs to it, and that matters, both readings
    are written out; an author's is the shorter one, unless a sign is written.
    """
    factors: list[Piece | None] = [first]
    operators = [""]
    telling = first  # the factor that tells the rule of what kind the operand is so far
    while True:
        ahead = cursor.ahead()
        reach = rule(telling, ahead)
        shorter = (
            cursor.guesses or (cursor.author and cursor.author.shorter)
        ) and not ahead.operator
        if reach is Reach.ENDS or (reach is Reach.DOUBT and shorter):
            if rule in (after_open, after_nested, after_derivative):
                cursor.open_end = cursor.at
            return applied(joined(factors, operators))
        read_next_factor(cursor, factors, operators)
        last, both = factors[-1], ["", operators[-1]]
        if last is None:
            continue
        longer = bool(cursor.author and cursor.author.longer)
        if reach is Reach.DOUBT and matters(last) and not longer:
            shorter_one = applied(joined(factors[:-1], operators[:-1]))
            cursor.two_readings(
                applied(joined(factors, operators)), joined([shorter_one, last], both)
            )
        if telling.tree.op == "number" or not telling.names:
            telling = last if last.names or last.tree.op != "number" else telling


# Factors


def read_factor(cursor: Cursor, base: Piece | None = None) -> Piece:
    """A base, here or read already, with its powers, evaluation bars and values at a point."""
    raised = base is None and cursor.is_exponential(cursor.at)
    base = base or read_base(cursor)
    while True:
        if cursor.degrees():
            base = Piece(base.tree * PI / 180, 2)
        elif cursor.peek() == "^" and not cursor.sides():
            if raised:
                cursor.refuse("TeX takes one exponent: write brackets or braces,")
            cursor.at += 1
            raised = True
            exponent = read_script(cursor)
            if cursor.author and cursor.author.letter_e and base.symbol == "e":
                check_power_of_e(cursor, exponent)
            ten = base.printed == "10" and re.fullmatch(r"-?\d+", exponent.printed)
            printed = f"1e{exponent.printed}" if ten else ""
            base = Piece(base.tree**exponent.tree, 3, base.symbol, printed)
        elif cursor.peek() == "!":
            base = read_factorial(cursor, base)
        elif cursor.peek() == "'" and cursor.tokens[cursor.at - 1] == ")" and len(base.names) == 1:
            (name,) = base.names
            if name not in VARIABLES and not cursor.guesses:
                cursor.refuse(f"whether {name} is a function is not said: write \\frac{{d}}{{dx}},")
            base = Piece(derivative(base.tree, name))
            cursor.at += 1
        elif cursor.peek() == "|" and cursor.peek(1) == "_" and not cursor.at_bar():
            cursor.at += 1
            base = read_values_at(cursor, base.tree)
        elif cursor.peek() == "(" and is_derivative(base) and cursor.is_list():
            values = {f"p{n}": value for n, value in enumerate(read_arguments(cursor), 1)}
            base = Piece(at(base.tree, values))
        else:
            return base


def read_factorial(cursor: Cursor, base: Piece) -> Piece:
    """``3!``, ``n!`` and ``(n + 1)!``, and the double factorial ``(2n - 1)!!``."""
    n = natural(base.tree)
    double = cursor.peek(1) == "!"
    if base.strength < 4 or (double and cursor.peek(2) == "!") or (n or 0) > MAX_FACTORIAL:
        cursor.refuse("the factorial is read of a name, a small number or a bracket,")
    cursor.take()
    if double:
        cursor.take()
        return Piece(call("factorial2", [base.tree]))
    return Piece(call("factorial", [base.tree]) if n is None else number(factorial(n)))


def read_script(cursor: Cursor) -> Piece:
    """An exponent or a limit: a group, or one token."""
    inside = cursor.tokens[cursor.at + 1 : cursor.at + 5]
    raised = cursor.tokens[cursor.at - 2]
    braced = cursor.peek() == "{" and inside[0:1] + inside[2:] == ["(", ")", "}"]
    if braced and not (raised == "e" or is_number(raised)):
        cursor.refuse("one thing in brackets above a name counts derivatives: write it without,")
    return read_group(cursor)


def read_group(cursor: Cursor) -> Piece:
    """The argument of a command, an exponent: a group, or one token."""
    if cursor.peek() == "{":
        return read_enclosed(cursor)
    if is_number(cursor.peek()) and len(cursor.peek()) > 1:
        # x^12 is x¹·2 in TeX.
        cursor.refuse("of several digits TeX takes one: what belongs together needs braces")
    if cursor.kind(cursor.at) in ("function", "inverse"):
        cursor.refuse("of a function and its argument TeX takes the name: they need braces")
    return read_base(cursor)


def read_base(cursor: Cursor) -> Piece:
    """A bracket, a command with its arguments, a number or a name."""
    token = cursor.peek()
    word = token.removeprefix("\\")
    is_command = token.startswith("\\")
    if (read := _BEGINNING.get(token)) and (token not in TIME or cursor.author):
        return read(cursor)
    if is_command and word in FUNCTIONS:
        return read_function(cursor)
    if is_command and word in WITH_ORDER:
        value = read_special_function(cursor)
        if value is None:
            cursor.refuse("the order and the argument of this function are missing")
        return value
    if re.fullmatch(r"\d.*|\.\d+", token):
        value = decimal(cursor.take())
        if "." in token and cursor.peek() == ELLIPSIS:
            cursor.refuse(GOES_ON)
        return value
    if is_letter(token) or token in ("\\pi", "\\partial") or token.isalpha():
        return read_name(cursor)
    if not token:
        raise InputError("LaTeX: the formula ends where more is expected")
    cursor.refuse(INSTEAD.get(token, "this is not read"))


def read_infinity(cursor: Cursor) -> Piece:
    """``\\infty``."""
    cursor.take()
    return Piece(INFINITY)


# Brackets, fractions, roots


def read_enclosed(cursor: Cursor) -> Piece:
    """What stands in a bracket, or in braces."""
    opening = cursor.take()
    piece = read_sum(cursor)
    if cursor.peek() not in ("", CLOSED[OPENING.index(opening)]):
        cursor.refuse(f"the bracket {opening} is not closed")
    cursor.take()
    return piece


def read_arguments(cursor: Cursor) -> list[Expr]:
    """What stands in a bracket, apart by commas."""
    opening = cursor.take()
    found = [read_sum(cursor).tree]
    while cursor.peek() == ",":
        cursor.take()
        found.append(read_sum(cursor).tree)
    cursor.take(BRACKETS[opening])
    return found


def read_bracket(cursor: Cursor) -> Piece:
    """A bracket; with limits behind it, the difference of values at its ends."""
    if is_coefficient(cursor):
        return read_coefficient(cursor)
    start, opening, piece = cursor.at, cursor.peek(), read_enclosed(cursor)
    if opening in ROUNDING:
        return Piece(call(ROUNDING[opening], [piece.tree]))
    if opening == "[" and cursor.peek() == "_":
        return read_values_at(cursor, piece.tree)
    if opening != "(" and not cursor.guesses:
        check_bracket(cursor, opening, piece, start)
    return Piece(piece.tree)


def is_coefficient(cursor: Cursor) -> bool:
    """Return whether ``[z^n]`` before a factor begins here, with a letter for n."""
    if cursor.peek() != "[" or cursor.peek(2) != "^":
        return False
    inside = cursor.tokens[cursor.at + 3 : cursor.partner(cursor.at)]
    after = cursor.tokens[cursor.partner(cursor.at) + 1 :][:1]
    ends = (*CLOSING, *RELATIONS, *STOPS, *OPERATORS, "_")
    if cursor.author and len(inside) > 1 and (inside[0], inside[-1]) != ("{", "}"):
        return False
    return bool(after) and after[0] not in ends and bool({*inside} & {"n", "k", "m", "N"})


def read_coefficient(cursor: Cursor) -> Piece:
    """``[z^n] f``: a coefficient of the product that follows."""
    cursor.take("[")
    name = cursor.symbol()
    cursor.take("^")
    n = read_script(cursor).tree
    cursor.take("]")
    body = read_product(cursor).tree
    if cursor.peek() in ("+", "-"):
        cursor.refuse("of what is this the coefficient? Write the sum in brackets,")
    return Piece(coefficient(body, name, n))


def read_absolute(cursor: Cursor) -> Piece:
    """An absolute value."""
    cursor.take()
    cursor.bars += 1
    piece = read_sum(cursor)
    cursor.bars -= 1
    if cursor.peek() not in ("", "|", "\\right|"):
        cursor.refuse("the bar | is not closed")
    cursor.take()
    return Piece(abs(piece.tree))


def read_braces(cursor: Cursor) -> Piece:
    """A factor in braces, which do not print and so must not be needed."""
    before, start = cursor.tokens[cursor.at - 1] if cursor.at else "", cursor.at
    piece = read_enclosed(cursor)
    slashed = "/" in cursor.tokens[start : cursor.at]
    opened = before in ("", "+", "\\left|", *OPENING, *RELATIONS, *STOPS)
    closed = not cursor.continues() and cursor.peek() != "^"
    apart = before == "/" or cursor.peek() == "^" or (slashed and not closed)
    needed = apart if piece.strength > 1 else not (opened and closed)
    needed = needed and piece.strength < 4
    if cursor.open_end == cursor.at - 1:  # as in {\sin x}y
        needed = needed or not (closed or cursor.ahead().kind in ("function", "derivative"))
    if needed and not cursor.guesses:
        cursor.refuse("braces do not print: write brackets around what stands in them,")
    return Piece(piece.tree, symbol=piece.symbol, printed=piece.printed)


def read_fraction(cursor: Cursor) -> Piece:
    """A fraction, unless it is a derivative."""
    if cursor.is_derivative_at(cursor.at):
        return read_derivative(cursor)
    cursor.take()
    if re.fullmatch(r"\d\d", cursor.peek()):
        # TeX's \frac12 is one half.
        top, below = map(decimal, cursor.take())
    else:
        if cursor.peek() == "{" and cursor.peek(1) == "}":
            cursor.refuse("an empty numerator")
        top, below = read_group(cursor), read_group(cursor)
    return Piece(top.tree / below.tree, 2)


def read_root(cursor: Cursor) -> Piece:
    """A square root, or a root with an index; an odd one is real for every real number."""
    cursor.take("\\sqrt")
    if cursor.peek() != "[":
        return Piece(sqrt(read_group(cursor).tree))
    cursor.take()
    index = read_sum(cursor)
    cursor.take("]")
    inside = read_group(cursor).tree
    whole = index.tree.op == "number" and index.tree.args[0].q == 1
    n = int(index.tree.args[0].p) if whole else 0
    if n < 0:
        cursor.refuse("a root with a negative index: write 1 over the root,")
    if n % 2 == 0 or inside.op == "number":
        return Piece(inside ** (1 / index.tree), 3)
    if n == 3:
        return Piece(apply("cbrt", inside))
    return Piece(apply("sign", inside) * abs(inside) ** (1 / index.tree), 2)


def read_binomial(cursor: Cursor) -> Piece:
    """``\\binom{n}{k}``: for a number k the product, else by factorials, 0 ≤ k ≤ n."""
    cursor.take()
    above, below = read_group(cursor).tree, read_group(cursor).tree
    k = natural(below)
    if k is None or k > MAX_FACTORIAL:
        n, m, rest = (call("factorial", [e]) for e in (above, below, above - below))
        return Piece(n / (m * rest))
    factors = [above - n for n in range(k)]
    return Piece(multiply(*factors) / factorial(k)) if k else Piece(ONE)


def read_extreme(cursor: Cursor) -> Piece:
    """``\\max(x, y)``, ``\\min\\{x, y, z\\}``."""
    token = cursor.take()
    if cursor.peek() not in ("(", "\\{") or not cursor.is_list():
        cursor.refuse(f"{token} takes a list in brackets: write {token}(x, y),")
    return Piece(extreme(EXTREMES[token], read_arguments(cursor)))


# Functions and their arguments


def read_function(cursor: Cursor) -> Piece:
    """A function, perhaps with a power of it or the base of a logarithm, and its argument."""
    start = cursor.at
    name = FUNCTIONS[cursor.take()[1:]]
    more: list[Expr] = []
    if name == "log" and cursor.peek() == "_":
        cursor.at += 1
        more = [read_script(cursor).tree]
    exponent = None
    if cursor.peek() == "^":
        cursor.at += 1
        exponent = read_script(cursor).tree

    def applied(argument: Piece) -> Piece:
        tree = call(name, [argument.tree, *more])
        if exponent is None:
            return Piece(tree)
        inverse = cursor.author and (cursor.author.longer or cursor.author.inverses)
        if exponent == MINUS_ONE and inverse:
            return Piece(call(_inverse(name), [argument.tree]))
        if exponent == MINUS_ONE and not (cursor.author and cursor.author.shorter):
            cursor.two_readings(f"{_inverse(name)}({argument.tree})", f"1/{tree}")
        return Piece(tree**exponent, 3)

    return read_argument(cursor, start, applied, after_bracket if name != "exp" else whole)


def read_argument(
    cursor: Cursor, start: int, applied: Callable[[Piece], Piece], rule: Rule
) -> Piece:
    """``applied`` to the argument that follows; ``rule`` says how far one in brackets goes."""
    token = cursor.peek()
    braced = token == "{" and cursor.peek(1) in BRACKETS
    if braced and cursor.partner(cursor.at + 1) + 1 == cursor.partner(cursor.at):
        cursor.take()
        inner = read_enclosed(cursor)
        cursor.take("}")
        return applied(inner)
    if token in BRACKETS:
        inner = read_enclosed(cursor)
        doubtful = rule is not whole and min(inner.strength, applied(inner).strength) < 4
    elif token == "{":
        inner = read_braced_argument(cursor, start, applied)
        rule, doubtful = after_braces, True
    elif token in ("|", "\\left|"):
        inner, rule, doubtful = read_absolute(cursor), after_braces, True
    else:
        nested = cursor.kind(cursor.at) in ("function", "inverse") or cursor.is_exponential(
            cursor.at
        )
        return read_operand(
            cursor, applied, read_factor(cursor), after_nested if nested else after_open
        )
    if cursor.peek() == "^" and doubtful and not cursor.guesses:
        cursor.take()
        exponent = read_script(cursor).tree
        inside = applied(Piece(inner.tree**exponent, 3))
        cursor.two_readings(inside, Piece(applied(inner).tree ** exponent))
    return read_operand(cursor, applied, inner, rule)


def read_braced_argument(cursor: Cursor, start: int, applied: Callable[[Piece], Piece]) -> Piece:
    """The argument in braces of the function at ``start``, if print says the same without."""
    name, inside = (
        cursor.tokens[start : cursor.at],
        cursor.tokens[cursor.at + 1 : cursor.partner(cursor.at)],
    )
    inner = read_enclosed(cursor)
    if inside[0] in ("+", "-"):
        if inner.strength == 0 and not cursor.guesses:
            cursor.refuse("braces do not print: write brackets around what stands in them,")
    elif not cursor.guesses:
        shown = read_sum(Cursor([*name, *inside], Author()))
        if shown.tree != applied(inner).tree:
            cursor.two_readings(applied(inner), shown)
    return inner


def read_special_function(cursor: Cursor) -> Piece | None:
    """``\\Gamma(x)``, ``\\zeta(s)``, ``J_0(x)``, ``\\operatorname{Li}_2(x)``, or None.

    A letter keeps the meaning that it has elsewhere: it must stand before a bracket wherever
    it occurs. Bessel functions are not read in an author's text, where J, K and I are usual
    names of other things.
    """
    start, token = cursor.at, cursor.peek()
    order: list[Expr] = []
    if token in OF_GREEK and cursor.peek(1) in ("(", "^"):
        letter = token.lstrip("\\")
        if cursor.author and (letter in cursor.author.bare or letter in cursor.author.functions):
            return None
        places = [n for n, other in enumerate(cursor.tokens) if other == token]
        if any(cursor.tokens[n + 1 : n + 2] not in (["("], ["^"]) for n in places):
            return None
        name = OF_GREEK[token]
        cursor.at += 1
    elif token.lstrip("\\") in WITH_ORDER and cursor.peek(1) == "_":
        if cursor.author and not token.startswith("\\"):
            return None
        name = WITH_ORDER[token.lstrip("\\")]
        if name == "expint":  # E_1 is usual for energies
            return None
        cursor.at += 2
        order = [read_script(cursor).tree]
    else:
        return None
    exponent = None
    if cursor.peek() == "^":
        cursor.at += 1
        exponent = read_script(cursor).tree
    if cursor.peek() != "(":
        cursor.at = start
        return None
    tree = call(name, [*order, *read_arguments(cursor)])
    return Piece(tree) if exponent is None else Piece(tree**exponent, 3)


# Sums, products, integrals and limits


def read_total(cursor: Cursor) -> Piece:
    """``\\sum_{k=low}^{high}`` and ``\\prod`` of the product that follows."""
    kind = COMMANDS[cursor.take()]
    cursor.take("_")
    cursor.take("{")
    outer = cursor.indices
    cursor.indices = [*outer, cursor.peek()]
    name = cursor.symbol()
    cursor.indices = outer
    cursor.take("=")
    low = read_sum(cursor).tree
    cursor.take("}")
    cursor.take("^")
    high = read_script(cursor).tree
    bound = Range(name, (low, high))
    cursor.indices = [*outer, name]
    factors, operators = [read_factor_or_differential(cursor)], [""]
    while factors[-1] is not None and cursor.continues():
        read_next_factor(cursor, factors, operators)
    cursor.indices = outer
    piece, last = joined(factors, operators), factors[-1]
    if kind == "product" and len(factors) > 1 and last and name not in last.names:
        one = operated(kind, bound, joined(factors[:-1], operators[:-1]).tree)
        both = joined([Piece(one, 2), last], ["", operators[-1]])
        cursor.two_readings(Piece(operated(kind, bound, piece.tree)), both)
    return Piece(operated(kind, bound, piece.tree), 2)


def read_integral(cursor: Cursor) -> Piece:
    """``∫_{low}^{high} … dx``, or without ends: all terms that carry the differential."""
    cursor.take("\\int")
    ends: list[Expr] = []
    named = {""}
    if cursor.peek() in ("_", "^"):
        first = cursor.take()
        one, name = read_end(cursor)
        cursor.take("^" if first == "_" else "_")
        other, second = read_end(cursor)
        named |= {name, second}
        ends = [one, other] if first == "_" else [other, one]
    outer, cursor.differentials = cursor.differentials, []
    cursor.integrals += 1
    body = read_integrand(cursor)
    variables = set(cursor.differentials)
    cursor.integrals -= 1
    cursor.differentials = outer
    if len(variables) != 1 or not named <= variables | {""}:
        cursor.refuse("an integral needs one variable and its differential")
    name = variables.pop()
    return Piece(operated("integral", Range(name, tuple(ends)), body))


def read_integrand(cursor: Cursor) -> Expr:
    """The terms that carry the differential of the integral."""
    terms = [read_first_term(cursor).tree]
    while not cursor.differentials and cursor.peek() in ("+", "-"):  # up to the differential
        terms.append(read_first_term(cursor).tree)
    if not cursor.differentials:
        cursor.refuse("the differential of the integral is missing")
    while cursor.peek() in ("+", "-"):
        before, count = cursor.at, len(cursor.differentials)
        sign = -1 if cursor.take() == "-" else 1
        term = read_product(cursor).tree
        if len(cursor.differentials) == count:
            cursor.at = before
            break
        terms.append(term if sign == 1 else -term)
    return add(*terms)


def read_limit(cursor: Cursor) -> Piece:
    """``\\lim_{x \\to p}`` of the product that follows."""
    cursor.take("\\lim")
    cursor.take("_")
    cursor.take("{")
    name = cursor.symbol()
    if RELATIONS.get(cursor.take()) != "->":
        cursor.refuse("a limit is written \\lim_{x \\to 0},")
    point, side = read_point(cursor)
    cursor.take("}")
    bound = Range(name, (point,), str(side))
    return read_body(cursor, name, lambda e: Piece(operated("limit", bound, e.tree)))


def read_point(cursor: Cursor) -> tuple[Expr, int]:
    """Where a path ends, and the side it comes from: ``0``, ``0^+``, ``\\pi^{-}``, ``0+``."""
    found = read_sum(cursor).tree
    side = cursor.sides()
    cursor.at += len(side)
    return found, ("+" in side) - ("-" in side)


def read_body(cursor: Cursor, name: str, applied: Callable[[Piece], Piece]) -> Piece:
    """``applied`` to the product that follows; what does not know the variable may be left."""
    bracket = cursor.peek() in (*BRACKETS, "{")
    rule = after_derivative_of_bracket if bracket else after_derivative
    return read_operand(
        cursor, applied, read_factor(cursor), rule, lambda e: name in e.names or _has_derivative(e)
    )


def read_values_at(cursor: Cursor, e: Expr) -> Piece:
    """``e`` at the place of a bar, ``_{x = 1}``, or its difference between two, ``_0^1``."""
    ends: dict[str, Expr] = {}
    names: frozenset[str] = frozenset()
    while cursor.peek() in ("_", "^") and cursor.peek() not in ends:
        mark = cursor.take()
        ends[mark], name = read_end(cursor)
        names |= frozenset((name,) if name else ())
    if not names:
        names = symbols(e).difference(*map(symbols, ends.values()))
        own = cursor.author.variable if cursor.author else ""
        names = frozenset((own,)) & names or names
    if len(names) != 1 or "_" not in ends:
        cursor.refuse("a bar or bracket with limits needs its variable: write the values out,")
    (name,) = names
    infinite = ends["_"] in (INFINITY, -INFINITY)
    if infinite and "^" in ends and ends["^"] not in (INFINITY, -INFINITY):
        cursor.bar = cursor.at, name
        return Piece(limit(at(e, {name: ends["^"]}) - e, name, ends["_"]))
    if infinite:
        cursor.refuse("values at both infinities need two limits: write them out,")
    low = at(e, {name: ends["_"]})
    if "^" not in ends:
        return Piece(low)
    cursor.bar = cursor.at, name
    if ends["^"] in (INFINITY, -INFINITY):
        return Piece(limit(e - low, name, ends["^"]))
    return Piece(at(e, {name: ends["^"]}) - low, 0)


def read_end(cursor: Cursor) -> tuple[Expr, str]:
    """An end of an interval, and its variable where that is named, as in ``_{x=0}``."""
    start = cursor.at
    if cursor.peek() == "{" and is_letter(cursor.peek(1)):
        cursor.at += 1
        name = cursor.symbol()
        if cursor.peek() == "=":
            cursor.at += 1
            value = read_sum(cursor).tree
            cursor.take("}")
            return value, name
        cursor.at = start
    return read_script(cursor).tree, ""


def read_barred(cursor: Cursor) -> Piece:
    """``\\left. … \\right|_{x = value}``, and between two values."""
    cursor.take("\\left.")
    piece = read_sum(cursor)
    cursor.take("\\right|")
    return read_values_at(cursor, piece.tree)


# Derivatives


def read_derivative(cursor: Cursor) -> Piece:
    """``\\frac{dy}{dx}``, a symbol of an author's, or ``\\frac{d}{dx}`` of what follows."""
    above, below, cursor.at = cursor.halves(cursor.at)
    kind, above, times = above[0], above[1:], 1
    if "^" in (*above[:1], *below):
        length = 4 if above[1:2] == ["{"] else 2
        order, above = above[:length], above[length:]
        digits = "".join(order).strip("^{}")
        if below[-length:] == order and len(digits) == 1 and is_letter(digits) and not above:
            return read_nth_derivative(cursor, digits, below[:-length])
        if below[-length:] != order or not digits.isdigit():
            cursor.refuse("a derivative of higher order is written \\frac{d^2}{dx^2} f, here")
        if len(digits) > 2 or not 1 <= (times := int(digits)) <= MAX_DERIVATIVES:
            cursor.refuse(f"the order of a derivative goes from 1 to {MAX_DERIVATIVES}")
        below = below[:-length]
    variable = Cursor(below[1:], cursor.author)
    name = variable.symbol()
    if variable.peek():
        variable.refuse("one variable is expected")
    if not above:
        return read_what_is_differentiated(cursor, kind, name, times)
    function = Cursor(above, cursor.author)
    piece = read_product(function)
    if function.peek():
        function.refuse("one product is expected")
    if not (piece.symbol and piece.strength == 4):
        return differentiated(cursor, piece, kind, name, times)
    return derivative_of_symbol(cursor, kind, piece.symbol, name, times)


def read_nth_derivative(cursor: Cursor, order: str, below: list[str]) -> Piece:
    """``\\frac{d^n}{dx^n}`` of what follows."""
    variable = Cursor(below[1:], cursor.author)
    name = variable.symbol()
    if variable.peek():
        variable.refuse("one variable is expected")
    return read_body(cursor, name, lambda e: Piece(nth_derivative(e.tree, name, symbol(order))))


def read_dotted(cursor: Cursor) -> Piece:
    """``\\dot x`` and ``\\ddot x``, derivatives by the time."""
    times = len(cursor.take()) - 3
    name = read_group(cursor).symbol
    if not name:
        cursor.refuse("one letter is expected under the dots,")
    return derivative_of_symbol(
        cursor, "d", name, "" if cursor.author and cursor.author.strict else "t", times
    )


def differentiated(cursor: Cursor, e: Piece, kind: str, name: str, times: int = 1) -> Piece:
    """The derivative of ``e``, in which ``d/dx`` needs the variable: else it is a symbol's."""
    known = name in e.names or not e.names or kind == "\\partial" or _has_derivative(e)
    if not known and not cursor.guesses:
        if e.symbol and e.strength == 4:
            return derivative_of_symbol(cursor, kind, e.symbol, name, times)
        cursor.refuse(NO_DERIVATIVE)
    return Piece(repeated_derivative(e.tree, name, times))


def read_what_is_differentiated(cursor: Cursor, kind: str, name: str, times: int = 1) -> Piece:
    """What follows ``d/dx``, differentiated."""
    return read_body(cursor, name, lambda e: differentiated(cursor, e, kind, name, times))


def derivative_of_symbol(cursor: Cursor, kind: str, above: str, below: str, times: int) -> Piece:
    """The derivative of a symbol of an author's: of what it stands for, or one more symbol."""
    if not cursor.author:
        cursor.refuse(NO_DERIVATIVE)
    known = cursor.author.derivative(above, below, times)
    if cursor.peek() == "(" and not cursor.guesses:
        start, product = cursor.at, read_enclosed(cursor).strength == 0
        cursor.at = start
        if known is not None or not product:
            cursor.refuse("a derivative at a point is not read,")
    return derived(kind, above, below or "t", times) if known is None else Piece(known)


def read_primed(cursor: Cursor, name: str, primes: int) -> Piece:
    """``f'`` and ``f'(x)``: the derivative of what f stands for, or a symbol of its own."""
    known = cursor.author.derivative(name, "", primes) if cursor.author else None
    if known is None or cursor.author is None:
        if cursor.peek() == "(" and not cursor.guesses:
            arguments = tuple(read_arguments(cursor))
            if len(arguments) != 1:
                cursor.refuse("a prime does not say by which of several arguments,")
            return Piece(unknown(name, arguments, (primes,)))
        called = f"{name}_prime{'' if primes == 1 else primes}"
        return Piece(symbol(called), symbol=called)
    if cursor.peek() != "(":
        return Piece(known)
    parameters, values = cursor.author.functions[name].parameters, read_arguments(cursor)
    if len(values) != 1:
        cursor.refuse(f"{name}' takes one argument,")
    return Piece(at(known, {parameters[0]: values[0]}))


# Names and values


def read_name(cursor: Cursor) -> Piece:
    """A symbol, an inline derivative, ``e^{…}``, an order, or an author's function."""
    token, start = cursor.peek(), cursor.at
    if isinstance(token, Called):
        cursor.at += 1
        return Piece(unknown(str(token), tuple(read_arguments(cursor))))
    if token in DIFFERENTIALS and is_letter(cursor.peek(1)):
        cursor.at += 1
        above = cursor.symbol()
        if cursor.peek() == "/" and cursor.peek(1) == token and is_letter(cursor.peek(2)):
            if not cursor.author:
                cursor.refuse(NO_DERIVATIVE)
            cursor.at += 2
            return derived(token, above, cursor.symbol())
        cursor.at = start
    theta = token == "\\Theta" and not cursor.author and cursor.tokens.count(token) == 1
    if (token in ORDERS or theta) and cursor.peek(1) == "(":
        cursor.take()
        return Piece(order(token.removeprefix("\\"), read_enclosed(cursor).tree))
    if not cursor.guesses:
        check_name(cursor)
    if cursor.is_exponential(cursor.at):
        cursor.at += 2
        return Piece(apply("exp", read_script(cursor).tree))
    if token == "\\pi" or (token == "e" and not (cursor.author and cursor.author.letter_e)):
        cursor.take()
        return Piece(E if token == "e" else PI)

    special = None if cursor.guesses else read_special_function(cursor)
    if special is not None:
        return special
    if cursor.author and cursor.is_term():
        return read_term(cursor)
    name = cursor.symbol()
    primes = cursor.primes() if cursor.author else 0
    if primes:
        return read_primed(cursor, name, primes)
    if cursor.author and cursor.peek() == "(" and (cursor.is_list() or is_argument(cursor, name)):
        return read_value(cursor, name, cursor.author.functions.get(name))
    return Piece(symbol(name), symbol=name)


def read_value(cursor: Cursor, name: str, function: Function | None) -> Piece:
    """A function of the author's: what it is at its arguments, ε for ε(γ) of bare symbols."""
    start, values = cursor.at, read_arguments(cursor)
    if function is not None and len(values) == len(function.parameters):
        given = dict(zip(function.parameters, values, strict=True))
        return Piece(substitute(function.body, given))
    if not cursor.guesses and function is not None and not function.parameters:
        return Piece(symbol(name))
    if not cursor.guesses and name not in ("Gamma", "zeta") and function is None:
        return Piece(unknown(name, tuple(values)))
    if any(value.op != "symbol" for value in values) or not cursor.guesses:
        cursor.at = start
        cursor.refuse(f"{name}(…) is a function that is not known: write out what it is,")
    return Piece(symbol(name))


def read_term(cursor: Cursor) -> Piece:
    """``a_k`` as a(k), ``a_{ij}``, ``a_{1j}`` and ``a_{i,j}`` as functions of two indices."""
    letter = cursor.take().removeprefix("\\")
    cursor.take("_")
    cursor.counting = True  # i is an index there
    try:
        indices = read_indices(cursor)
    finally:
        cursor.counting = False
    if cursor.peek() in ("(", "'"):
        cursor.refuse(f"{letter} is a sequence, and what stands behind its term is not read,")
    return Piece(unknown(letter, tuple(indices)))


def read_indices(cursor: Cursor) -> list[Expr]:
    """The indices in the subscript here."""
    inside = (
        cursor.tokens[cursor.at + 1 : cursor.partner(cursor.at)] if cursor.peek() == "{" else []
    )
    letters = [t for t in inside if t.isalpha() and len(t) == 1]
    numbered = len(inside) == 2 and inside[0] in "13456789" and len(letters) == 1
    if len(inside) > 1 and (len(letters) == len(inside) or numbered):  # a_{2n} is an even one
        cursor.at += len(inside) + 2
        indices = [number(int(t)) if t.isdigit() else symbol(t) for t in inside]
    elif "," in inside:
        cursor.at += 1
        indices = [read_sum(cursor).tree]
        while cursor.peek() == ",":
            cursor.take()
            indices.append(read_sum(cursor).tree)
        cursor.take("}")
    else:
        indices = [read_script(cursor).tree]
    return indices


_BEGINNING: dict[str, Callable[[Cursor], Piece]] = {
    **dict.fromkeys(BRACKETS, read_bracket),
    "{": read_braces,
    **dict.fromkeys(("|", "\\left|"), read_absolute),
    "\\left.": read_barred,
    **dict.fromkeys(FRACTIONS, read_fraction),
    "\\sqrt": read_root,
    "\\int": read_integral,
    "\\lim": read_limit,
    **dict.fromkeys(("\\sum", "\\prod"), read_total),
    **dict.fromkeys(("\\binom", "\\tbinom", "\\dbinom"), read_binomial),
    **dict.fromkeys(EXTREMES, read_extreme),
    "\\infty": read_infinity,
    **dict.fromkeys(TIME, read_dotted),
}
"""What begins with a token of its own, and how it is read."""


def natural(e: Expr) -> int | None:
    """The natural number that ``e`` is, or None."""
    is_natural = e.op == "number" and e.args[0].q == 1 and e.args[0] >= 0
    return int(e.args[0].p) if is_natural else None


def _inverse(name: str) -> str:
    return {"log": "exp", "exp": "log"}.get(name) or (name[1:] if name[0] == "a" else f"a{name}")


def _has_derivative(piece: Piece) -> bool:
    return any(node.op == "derivative" for node in outermost(piece.tree))
