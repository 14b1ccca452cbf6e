"""Represent expressions as immutable trees of numbers, symbols, operations and functions.

A tree records what was written. Constructors fold numbers and flatten sums and products, but
simplify nothing else: ``0*log(x)`` is not defined everywhere, though ``0`` is, and ``1/0`` is a
tree that is defined nowhere. The domain is real: ``x**(p/q)`` with ``q > 1`` requires ``x ≥ 0``
(``cbrt`` is the real cube root of any number), ``log x`` requires ``x > 0``, ``asin`` and ``acos``
require ``|x| ≤ 1``, ``1/x`` requires ``x ≠ 0``. ``sign 0`` is 0. ``atan2(y, x)``, the angle of the
point ``(x, y)`` in (−π, π], is defined except at the origin: ``atan2(0, x)`` is π for ``x < 0``.

Integrals, derivatives, values at a point, limits and roots are nodes that bind a variable;
:mod:`tresym.reals.language.binders` creates them. In the tree a bound variable has no name, only a
de Bruijn index. The name with which it was written is stored for display. So trees are equal up to
the names of bound variables, and substitution cannot capture a variable.

An arbitrary function ``f(x)`` is a node ``unknown``. Its operands are a leaf ``function`` (its
name, and how often it is differentiated in each argument) and its arguments; see :func:`unknown`.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Mapping
from fractions import Fraction
from functools import lru_cache, reduce
from itertools import count
from typing import Any, TypeAlias

from flint import fmpq, fmpz

from tresym.reals.functions.table import CONSTANTS, TABLE, names
from tresym.reals.numbers.exact import InputError, exact_number, fraction_text

Number: TypeAlias = int | Fraction | fmpq

FUNCTIONS = names(lambda row: row.arity == 1 and row.theory)
"""The elementary functions of one argument. ``sqrt x`` is ``x**(1/2)``."""
LEAVES = frozenset(("number", "symbol", "pi", "bound", "function"))
BINDERS = frozenset(
    (
        *("integral", "antiderivative", "derivative", "nth", "at", "limit", "root"),
        *("sum", "product", "coefficient"),
    )
)
"""Operations that bind variables in their first operand, the body, one for each name."""
ORDERS = frozenset(("O", "o", "Theta", "omega"))
"""Landau symbols of a gauge function; like binders, such nodes cannot be evaluated."""
UNWORKED = BINDERS | ORDERS | {"unknown"}

MAX_DEPTH = 120
MAX_SIZE = 20_000
MAX_BITS = 40_000
MAX_POWER = 1_000
REMEMBERED = 1 << 10
"""The number of cached variables and small integers; identical objects compare fast."""
MAX_DERIVATIVES = 10


class Expr:
    """A node of a tree. Create it with :func:`number`, :func:`symbol`, :func:`apply` and operators.

    Attributes:
        op: ``"number"``, ``"symbol"``, ``"pi"``, ``"+"``, ``"*"``, ``"^"``, ``"atan2"``, the name
            of a function, one of :data:`UNWORKED`, ``"bound"`` or ``"function"``.
        args: the operands. For a number this is an ``fmpq``, and for a symbol a ``str``. For a
            bound variable it is the number of bound variables between it and its binder. For an
            arbitrary function it is its name and the orders of its derivatives.
        names: the display names of the variables that this node binds. They are ignored in
            comparisons.
        loose: the number of variables that must be bound outside this node; 0 except in parts of a
            body.
        size: the number of nodes of the tree, which is bounded.
        depth: the height of the tree, which is bounded.
        hidden: whether the tree contains one of :data:`UNWORKED`.

    Example:
        >>> x = symbol("x")
        >>> str((x + 1) ** 2 / x)
        '(x + 1)**2/x'
    """

    __slots__ = ("_hash", "_symbols", "args", "depth", "hidden", "loose", "names", "op", "size")

    op: str
    args: tuple[Any, ...]

    def __init__(self, op: str, args: tuple[Any, ...], names: tuple[str, ...] = ()) -> None:
        """Create a node and check its bounds; the functions of this module fold and check
        arguments.
        """
        size, depth, loose, hidden = 1, 1, 0, op in UNWORKED
        if op == "bound":
            loose = args[0] + 1
        elif op not in ("number", "symbol", "function"):
            around = len(names)
            for arg in args:
                size += arg.size
                if arg.depth >= depth:
                    depth = arg.depth + 1
                if arg.hidden:
                    hidden = True
                if arg.loose:
                    loose = max(loose, arg.loose - around)
                around = 0  # only the first operand is in the scope of the variables
            if depth > MAX_DEPTH:
                raise InputError(f"the expression is nested deeper than {MAX_DEPTH} levels")
            if size > MAX_SIZE:
                raise InputError(f"the expression has more than {MAX_SIZE} terms and operations")
        self.op = op
        self.args = args
        self.names = names
        self.loose = loose
        self.hidden = hidden
        self.size = size
        self.depth = depth
        self._hash = hash((op, args) if op != "number" else (int(args[0].p), int(args[0].q)))
        self._symbols: frozenset[str] | None = None

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return (
            isinstance(other, Expr)
            and self._hash == other._hash
            and self.op == other.op
            and self.args == other.args
        )

    def __reduce__(self) -> tuple[Any, ...]:
        args = self.args if self.op != "number" else str(self.args[0])
        return (_rebuild, (self.op, args, self.names))

    def __add__(self, other: Expr | Number) -> Expr:
        return add(self, as_expr(other))

    def __radd__(self, other: Number) -> Expr:
        return add(as_expr(other), self)

    def __sub__(self, other: Expr | Number) -> Expr:
        return add(self, -as_expr(other))

    def __rsub__(self, other: Number) -> Expr:
        return add(as_expr(other), -self)

    def __mul__(self, other: Expr | Number) -> Expr:
        return multiply(self, as_expr(other))

    def __rmul__(self, other: Number) -> Expr:
        return multiply(as_expr(other), self)

    def __truediv__(self, other: Expr | Number) -> Expr:
        return multiply(self, power(as_expr(other), MINUS_ONE))

    def __rtruediv__(self, other: Number) -> Expr:
        return multiply(as_expr(other), power(self, MINUS_ONE))

    def __pow__(self, other: Expr | Number) -> Expr:
        return power(self, as_expr(other))

    def __rpow__(self, other: Number) -> Expr:
        return power(as_expr(other), self)

    def __neg__(self) -> Expr:
        return multiply(MINUS_ONE, self)

    def __abs__(self) -> Expr:
        return apply("abs", self)

    def __str__(self) -> str:
        return _text(self, 0)

    def __repr__(self) -> str:
        return f"Expr({_text(self, 0)!r})"


def _rebuild(op: str, args: Any, names: tuple[str, ...]) -> Expr:
    return number(fmpq(*map(fmpz, args.split("/")))) if op == "number" else Expr(op, args, names)


def as_expr(x: Expr | Number) -> Expr:
    """Return an expression unchanged, or an exact number as an expression.

    Raises:
        InputError: ``x`` is a float or of another inexact type.
    """
    return x if isinstance(x, Expr) else number(x)


def number(x: Number) -> Expr:
    """Return an exact rational number as an expression.

    Raises:
        InputError: the number is inexact or has more than about 12 000 digits.
    """
    if type(x) is int and -REMEMBERED < x < REMEMBERED:
        return _small(x)
    value = exact_number(x)
    if value.p.bit_length() > MAX_BITS or value.q.bit_length() > MAX_BITS:
        raise InputError("a number in the expression is too long: at most 12 000 digits")
    if value.q == 1 and -REMEMBERED < value.p < REMEMBERED:
        return _small(int(value.p))
    return Expr("number", (value,))


@lru_cache(REMEMBERED)
def _small(n: int) -> Expr:
    return Expr("number", (fmpq(n),))


@lru_cache(REMEMBERED)
def symbol(name: str) -> Expr:
    """Return a real variable. Equal symbols are one cached object, which makes comparison fast."""
    return Expr("symbol", (name,))


ZERO = number(0)
ONE = number(1)
MINUS_ONE = number(-1)
HALF = number(Fraction(1, 2))
DOTS = symbol("...")
"""The omitted terms of a sum; no variable can have this name."""
PI = Expr("pi", ())
E = Expr("exp", (ONE,))


def add(*terms: Expr) -> Expr:
    """Return the sum; nested sums are flattened and numbers folded."""
    rest: list[Expr] = []
    constant = fmpq(0)
    for term in terms:
        for part in term.args if term.op == "+" else (term,):
            if part.op == "number":
                constant += part.args[0]
            else:
                rest.append(part)
    if constant != 0 or not rest:
        rest.append(number(constant))
    return rest[0] if len(rest) == 1 else Expr("+", tuple(rest))


def multiply(*factors: Expr) -> Expr:
    """Return the product; nested products are flattened and numbers folded, but a zero is kept."""
    rest: list[Expr] = []
    constant = fmpq(1)
    for factor in factors:
        for part in factor.args if factor.op == "*" else (factor,):
            if part.op == "number":
                constant *= part.args[0]
            else:
                rest.append(part)
    if constant != 1 or not rest:
        rest.insert(0, number(constant))
    return rest[0] if len(rest) == 1 else Expr("*", tuple(rest))


def factors_in(e: Expr) -> tuple[Expr, ...]:
    """Return the factors of a product, or the expression alone."""
    return e.args if e.op == "*" else (e,)


def power(base: Expr, exponent: Expr) -> Expr:
    """Return ``base**exponent``. Numeric exponents are bounded, since decision procedures expand
    them.

    Raises:
        InputError: a numeric exponent is beyond ±1000, or a power of a number is too long.
    """
    if exponent.op == "number":
        r = exponent.args[0]
        if r == 1:
            return base
        if abs(r.p) > MAX_POWER or r.q > MAX_POWER:
            raise InputError(
                f"the exponent {_short(r)} is beyond the limit: numerator and denominator "
                f"of an exponent go up to {MAX_POWER}"
            )
        if base.op == "number" and r.q == 1:
            return _number_power(base.args[0], int(r.p))
        if base.op == "^" and r.q == 1 and base.args[1].op == "number":
            inner = base.args[1].args[0]
            if inner.q == 1 and not (inner < 0 and r <= 0):  # at base 0 the two sides differ
                return power(base.args[0], number(inner * r))
    return Expr("^", (base, exponent))


def _number_power(base: fmpq, n: int) -> Expr:
    if n < 0 and base == 0:
        return Expr("^", (ZERO, number(n)))
    if max(base.p.bit_length(), base.q.bit_length()) * abs(n) > MAX_BITS:
        raise InputError("a power of a number in the expression is too long: at most 12 000 digits")
    return number(base**n)


def _short(r: fmpq) -> str:
    if max(r.p.bit_length(), r.q.bit_length()) > 100:
        return f"of {r.p.bit_length()} bits"
    return fraction_text(r)


def apply(name: str, *arguments: Expr) -> Expr:
    """Return the function ``name`` of the table of functions applied to ``arguments``.

    Raises:
        InputError: the function is not known.
    """
    if name not in TABLE:
        raise InputError(f"unknown function {name} of {len(arguments)} arguments")
    return Expr(name, arguments)


def sqrt(x: Expr) -> Expr:
    """Return the square root."""
    return power(x, HALF)


def angle(y: Expr, x: Expr) -> Expr:
    """Return atan2(y, x), the angle of the point (x, y) in (−π, π], undefined at the origin."""
    return Expr("atan2", (y, x))


def unknown(name: str, args: tuple[Expr, ...], orders: tuple[int, ...] = ()) -> Expr:
    """Return an arbitrary function ``name(args)``, or a partial derivative of it.

    Args:
        name: the name of the function.
        args: its arguments.
        orders: how often it is differentiated in each argument: ``f''(u)`` is ``unknown("f", (u,),
            (2,))``. The function is smooth, so that the order of differentiation does not matter.
    """
    return Expr("unknown", (Expr("function", (name, orders or (0,) * len(args))), *args))


def off_the_cut(e: Expr) -> Expr:
    """Return a node ``atan2(y, x)`` as an arc tangent; valid off the nonpositive x-axis."""
    y, x = e.args
    return 2 * apply("atan", y / (sqrt(x**2 + y**2) + x))


def extreme(side: int, values: Iterable[Expr]) -> Expr:
    """Return the largest (``side`` 1) or smallest (−1) of several values, by absolute values."""
    return reduce(lambda x, y: (x + y + side * apply("abs", x - y)) / 2, values)


class Trees:
    """Expressions with the function names of the array API, so that formulas can return trees."""

    pi = PI

    @staticmethod
    def sqrt(x: Expr | Number) -> Expr:
        """Return the square root."""
        return sqrt(as_expr(x))

    def __getattr__(self, name: str) -> Any:
        """Return a function of the table."""
        if name not in TABLE:
            raise AttributeError(name)
        return lambda *args: apply(name, *map(as_expr, args))


trees = Trees()


def symbols(e: Expr) -> frozenset[str]:
    """Return the names of the free variables in ``e``."""
    if e._symbols is None:
        if e.op == "symbol":
            e._symbols = frozenset(e.args)
        elif e.op in LEAVES:
            e._symbols = frozenset()
        elif len(e.args) == 1:
            e._symbols = symbols(e.args[0])
        else:
            e._symbols = frozenset().union(*[symbols(arg) for arg in e.args])
    return e._symbols


def substitute(e: Expr, mapping: Mapping[str, Expr]) -> Expr:
    """Return ``e`` with the free variables of ``mapping`` replaced simultaneously.

    Example:
        >>> x, y = symbol("x"), symbol("y")
        >>> str(substitute(x / y, {"x": y, "y": x}))
        'y/x'
    """
    _need_closed(mapping.values())
    done: dict[Expr, Expr] = {}

    def walk(node: Expr) -> Expr:
        if node.op == "symbol":
            return mapping.get(node.args[0], node)
        if node.op in LEAVES or symbols(node).isdisjoint(mapping):
            return node
        if node not in done:
            done[node] = rebuild(node, tuple(walk(arg) for arg in node.args))
        return done[node]

    return walk(e)


def replaced(e: Expr, known: Mapping[Expr, Expr]) -> Expr:
    """Return ``e`` with subexpressions replaced, outermost first; none has a loose variable."""
    _need_closed(known.keys())
    _need_closed(known.values())

    def walk(node: Expr) -> Expr:
        if node in known:
            return known[node]
        return node if node.op in LEAVES else rebuild(node, tuple(map(walk, node.args)))

    return walk(e)


def _need_closed(trees: Iterable[Expr]) -> None:
    if any(tree.loose for tree in trees):
        raise ValueError("an expression with a bound variable cannot be moved out of its binder")


def rebuild(node: Expr, args: tuple[Expr, ...]) -> Expr:
    """Return the operation of ``node`` applied to other operands."""
    if node.op in UNWORKED:
        return Expr(node.op, args, node.names)
    if node.op == "+":
        return add(*args)
    if node.op == "*":
        return multiply(*args)
    if node.op == "^":
        return power(*args)
    return Expr(node.op, args)


def bind(e: Expr, names: tuple[str, ...]) -> Expr:
    """Return ``e`` as the body of a binder of the variables ``names``."""
    places = {name: n for n, name in enumerate(names)}

    def walk(node: Expr, depth: int) -> Expr:
        if node.op == "symbol" and node.args[0] in places:
            return Expr("bound", (places[node.args[0]] + depth,))
        if node.op in LEAVES or symbols(node).isdisjoint(places):
            return node
        return Expr(node.op, _operands(node, depth, walk), node.names)  # only leaves change

    return walk(e, 0)


def instantiate(body: Expr, values: tuple[Expr, ...]) -> Expr:
    """Return the body of a binder with these values of its variables."""
    _need_closed(values)
    plain = all(value.op == "symbol" for value in values)

    def walk(node: Expr, depth: int) -> Expr:
        if node.loose <= depth:
            return node
        if node.op == "bound":
            return values[node.args[0] - depth]
        operands = _operands(node, depth, walk)
        return Expr(node.op, operands, node.names) if plain else rebuild(node, operands)

    return walk(body, 0)


def _operands(node: Expr, depth: int, walk: Callable[[Expr, int], Expr]) -> tuple[Expr, ...]:
    """Return the operands after ``walk``; the first one is in the scope of the bound variables."""
    if not node.names:
        return tuple([walk(arg, depth) for arg in node.args])
    inside = depth + len(node.names)
    return tuple(walk(arg, depth if n else inside) for n, arg in enumerate(node.args))


def opened(node: Expr, avoid: Iterable[str] = ()) -> tuple[tuple[str, ...], Expr]:
    """Return fresh names for the variables that ``node`` binds, and its body with them.

    Args:
        node: a binder.
        avoid: further names that must not be used.
    """
    taken = {*symbols(node), *avoid}
    names: list[str] = []
    for name in node.names:
        names.append(fresh(name, taken))
        taken.add(names[-1])
    return tuple(names), instantiate(node.args[0], tuple(map(symbol, names)))


def integer(e: Expr) -> int | None:
    """Return the integer that ``e`` is, or None."""
    return int(e.args[0].p) if e.op == "number" and e.args[0].q == 1 else None


def is_polynomial(e: Expr, name: str) -> bool:
    """Return whether ``e`` is written as a polynomial in a variable, with any coefficients.

    Example:
        >>> is_polynomial(symbol("a") * symbol("x") ** 2, "x")
        True
    """
    if name not in symbols(e) or e.op == "symbol":
        return True
    if e.op == "^":
        times = integer(e.args[1])
        return times is not None and times >= 0 and is_polynomial(e.args[0], name)
    return e.op in ("+", "*") and all(is_polynomial(arg, name) for arg in e.args)


def fresh(name: str, taken: Container[str]) -> str:
    """Return ``name``, or the first of ``name_1``, ``name_2``, … that is not taken."""
    return next(found for n in count() if (found := f"{name}_{n}" if n else name) not in taken)


def orders_last(terms: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """Return the terms of a sum in the order of print, a number first and O last, if there is O."""
    if not any(term.op in ORDERS for term in terms):
        return terms
    place = {"number": 0} | dict.fromkeys(ORDERS, 2)
    return tuple(sorted(terms, key=lambda term: place.get(term.op, 1)))


def _text(e: Expr, level: int) -> str:
    """Return the text of ``e`` in the grammar of parsing.py; ``level`` is the surrounding
    precedence.
    """
    if e.op == "number":
        value = e.args[0]
        own = 1 if value < 0 else (2 if value.q != 1 else 4)
        return _wrap(fraction_text(value), own, level)
    if e.op == "symbol":
        return str(e.args[0])
    if e.op == "pi":
        return "pi"
    if e.op == "+":
        terms = orders_last(e.args)
        last = terms[-1]
        if DOTS in terms:  # the dots are written last, and a number first
            numbers = [term for term in terms if term.op == "number"]
            terms = (*numbers, *(t for t in terms if t.op != "number" and t != DOTS), DOTS)
        elif last.op == "number" and last.args[0] > 0 and _text(terms[0], 1).startswith("-"):
            terms = (last, *terms[:-1])  # 1 - x for -x + 1, which is the same tree
        body = _text(terms[0], 1)
        for term in terms[1:]:
            part = _text(term, 1)
            body += f" - {part[1:]}" if part.startswith("-") else f" + {part}"
        return _wrap(body, 1, level)
    if e.op == "*":
        return _product_text(e, level)
    if e.op == "^":
        if e.args[1] == HALF:
            return f"sqrt({_text(e.args[0], 0)})"
        if _is_reciprocal(e):
            return _wrap(f"1/{_text(e.args[0], 3)}", 2, level)
        return _wrap(f"{_text(e.args[0], 4)}**{_text(e.args[1], 4)}", 3, level)
    if e == E:
        return "E"
    if e.op in CONSTANTS:
        return e.op
    if e.op == "bound":
        return f"[{e.args[0]}]"
    if e.op in BINDERS:
        return _binder_text(e)
    if e.op == "unknown":
        return _unknown_text(e)
    return f"{e.op}({', '.join(_text(arg, 0) for arg in e.args)})"


def _unknown_text(e: Expr) -> str:
    """Return ``f(u)``, ``diff(f(x), x, 2)``, or the value of such a derivative at the arguments."""
    (name, orders), args = e.args[0].args, e.args[1:]
    at_symbols = len({arg for arg in args if arg.op == "symbol"}) == len(args)
    shown, names = args, [str(arg.args[0]) for arg in args if arg.op == "symbol"]
    if any(orders) and not at_symbols:
        names = [fresh(f"x_{n}", symbols(e)) for n in range(1, len(args) + 1)]
        shown = tuple(map(symbol, names))
    text = f"{name}({', '.join(_text(arg, 0) for arg in shown)})"
    for times, variable in zip(orders, names, strict=False):
        if times:
            text = f"diff({text}, {variable}{f', {times}' if times > 1 else ''})"
    if shown is args:
        return text
    pairs = (f"{n}, {_text(arg, 0)}" for n, arg in zip(names, args, strict=True))
    return f"at({text}, {', '.join(pairs)})"


def _binder_text(e: Expr) -> str:
    """Return the text of a binder, with names of its variables that capture nothing."""
    if e.loose:  # a part of a body, which is displayed only in error messages
        return f"{e.op}({', '.join(_text(arg, 0) for arg in e.args)})"
    times, body = 0, e
    while body.op == "derivative" and _is_derived_there(body) and body.args[1] == e.args[1]:
        times, body = times + 1, instantiate(body.args[0], (e.args[1],))
    if times:
        return f"diff({body}, {e.args[1]}{f', {times}' if times > 1 else ''})"
    names, body = opened(e)
    if e.op == "nth":
        return f"diff({instantiate(e.args[0], (e.args[1],))}, {e.args[1]}, {e.args[2]})"
    if e.op == "derivative":
        return f"at(diff({body}, {names[0]}), {names[0]}, {e.args[1]})"
    if e.op == "at":
        pairs = (f"{name}, {value}" for name, value in zip(names, e.args[1:], strict=True))
        return f"at({body}, {', '.join(pairs)})"
    if e.op == "antiderivative":
        return f"integral({instantiate(e.args[0], e.args[1:])}, {e.args[1]})"
    rest = e.args[1:-1] if e.op == "limit" and e.args[-1] == ZERO else e.args[1:]
    return f"{e.op}({', '.join(map(str, (body, names[0], *rest)))})"


def _is_derived_there(e: Expr) -> bool:
    """Return whether a derivative is taken at the variable itself."""
    return e.args[1].op == "symbol" and symbols(e.args[0]).isdisjoint(symbols(e.args[1]))


def _product_text(e: Expr, level: int) -> str:
    """Return the factors in their order; a leading fraction is written below if possible."""
    sign, body, below, factors = "", "", "", e.args
    if factors[0].op == "number":
        value, factors = abs(factors[0].args[0]), factors[1:]
        sign = "-" if e.args[0].args[0] < 0 else ""
        if value.q != 1 and not any(_is_reciprocal(factor) for factor in factors):
            value, below = fmpq(value.p), f"/{value.q}"
        body = fraction_text(value) if value != 1 else ""
    for factor in factors:
        if _is_reciprocal(factor):
            body = f"{body or 1}/{_text(factor.args[0], 3)}"
        else:
            body += f"{'*' if body else ''}{_text(factor, 2)}"
    return _wrap(sign + body + below, 1 if sign else 2, level)


def _is_reciprocal(e: Expr) -> bool:
    return e.op == "^" and e.args[1] == MINUS_ONE


def _wrap(text: str, own: int, level: int) -> str:
    return f"({text})" if own < level else text
