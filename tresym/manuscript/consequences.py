r"""Find the equations and definitions of a section from which a link follows.

After ``y'' + y = \epsilon y^2`` and ``y = y_0 + \epsilon y_1 + \dots`` the equation
``y_1'' + y_1 = y_0^2`` is no new one: it is the order ε of the first with the second put in. After
``(1+x) y_0 = a`` the line ``y_0 = a/(1+x)`` solves it, and after ``S = \ln u`` the line
``S' = u'/u`` is its derivative. What is sought here are candidates of such steps:

- a solution: the value makes an earlier equation, or its order in ε, an identity;
- a consequence: where one or two earlier equations hold, so does this one. An equation that is
  linear in a symbol is solved for it, and the result is put in;
- a series: each order in ε that is printed agrees with the equation of the series put in.

The equations may be differentiated, and earlier definitions put in. Candidates are found in
floating point, at random points; each is an exact claim, which is then decided like any other, so
that nothing here proves anything.
"""

from __future__ import annotations

import cmath
import math
import random
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

from tresym.manuscript.multiples import multiple_of
from tresym.reals.language.binders import outermost, worked_out
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    DOTS,
    ONE,
    ORDERS,
    ZERO,
    Expr,
    add,
    factors_in,
    multiply,
    number,
    power,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import Compared
from tresym.reals.numbers.exact import InputError

MOST_ORDERS = 3
"""The highest order in the small parameter that is collected."""
MOST_PREMISES = 10
"""The equations before a link that are tried."""
LARGEST = 400
"""The nodes of a formula that is looked at."""
SMALL = ("epsilon", "varepsilon", "delta", "eta", "mu", "lambda_", "kappa", "h")
"""Letters of small parameters, the usual ones first."""
VARIABLES = ("t", "x", "s", "tau", "X", "T", "z", "r", "theta", "xi", "phi")
"""Letters by which functions marked with primes are differentiated, the usual ones first."""
_PLAIN = re.compile(r"d(\d?)([A-Za-z]\w*?)_d([A-Za-z]\w*?)\d?")
_BELOW = re.compile(r"([A-Za-z]+\d?)_(([A-Za-z])\3*)")
_PRIMES = re.compile(r"(\w+?)_prime(\d?)")
_DERIVED = re.compile(r"(?:d|partial)\d?[A-Za-z]\w*_(?:d|partial)[A-Za-z]")
CONSTANT = re.compile(r"[CcAaBbKkDE]_?\d*")
"""Symbols for constants of integration."""
_COUNTED = re.compile(r"[A-Z]|[A-Za-z]+_?\d+")
"""Symbols for which a number may be put in: constants, not variables."""
_EVALUATED = frozenset(
    (
        "+",
        "*",
        "^",
        "abs",
        "exp",
        "log",
        "sin",
        "cos",
        "tan",
        "sinh",
        "cosh",
        "tanh",
        "asin",
        "acos",
    )
) | {"atan"}
_FAILS = (InputError, LookupError, ZeroDivisionError, RecursionError)
"""What keeps a step from being tried."""
_SEED = 7
REST = "leftout"
"""The first letters of symbols for what is left out of a series."""
_POINTS = 3


@dataclass(frozen=True)
class Fact:
    """What an earlier link states.

    Attributes:
        line: its line in the source.
        zero: the difference of its sides.
        sides: its sides.
        name, value: the symbol that it defines, and its value; no name for an equation.
        by: the variable of the defined function, if the text names it.
        series: whether terms are left out of it.
    """

    line: int
    zero: Expr
    sides: tuple[Expr, Expr]
    name: str = ""
    value: Expr = ZERO
    by: str = ""
    series: bool = False


class Step(NamedTuple):
    """A candidate: the claims that prove the link, and what it follows from, in words."""

    claims: tuple[str, ...]
    why: str


@dataclass
class Context:
    """The facts before a link, and the names of what is not elementary in them.

    Attributes:
        facts: the equations and definitions of the section, in order.
        values: stated values of functions at points: line, name, order, point, value.
        hidden: names that stand for integrals and the like.
        by: the variable by which a symbol is differentiated, if there is one.
        apart: symbols with derivatives by several variables, or values at several arguments; these
            are kept apart.
        below: symbols whose derivatives are marked by subscripts: ``Y_XX`` stands beside ``Y``.
        moving: letters that the text differentiates somewhere.
    """

    facts: list[Fact] = field(default_factory=list)
    values: list[tuple[int, str, int, Expr, Expr]] = field(default_factory=list)
    hidden: dict[Expr, str] = field(default_factory=dict)
    by: dict[str, str] = field(default_factory=dict)
    apart: frozenset[str] = frozenset()
    below: frozenset[str] = frozenset()
    moving: frozenset[str] = frozenset()

    def contains(self, e: Expr, name: str) -> bool:
        """Whether a symbol stands in what is hidden in an expression."""
        own = symbols(e)
        return any(name in symbols(node) for node, hid in self.hidden.items() if hid in own)


# Reading


def flattened(e: Expr, context: Context) -> Expr | None:
    """Return an expression in which functions, derivatives and integrals are symbols.

    ``y(x)`` becomes ``y``, ``y'(x)`` and ``dy/dx`` become ``y_prime``, and an integral a name of
    its own. None if it is too large, or has an order inside.
    """
    if e.size > LARGEST:
        return None
    put: dict[Expr, Expr] = {}
    try:
        e = worked_out(e)
    except InputError:
        return None
    for node in outermost(e):
        if node.op in ORDERS:
            return None
        if node.op == "unknown":
            name, orders = node.args[0].args
            args = node.args[1:]
            alone = all(arg.op == "symbol" for arg in args) and not any(orders[1:])
            if alone and name not in context.apart:
                put[node] = symbol(_primed(name, orders[0]))
                continue
        put[node] = symbol(context.hidden.setdefault(node, f"hidden{len(context.hidden) + 1}"))
    e = replaced(e, put) if put else e
    names = {n: _canonical(n, context) for n in symbols(e)}
    return substitute(e, {n: symbol(m) for n, m in names.items() if n != m})


def _canonical(name: str, context: Context) -> str:
    """Return ``y_prime2`` for ``d2y_dx2`` and for ``Y_XX``; of other names the name."""
    found = _PLAIN.fullmatch(name)
    if found and found[2] not in context.apart:
        return _primed(found[2], int(found[1] or 1))
    below = _BELOW.fullmatch(name)
    if below and below[1] in context.below - context.apart:
        return _primed(below[1], len(below[2]))
    return name


def _primed(name: str, times: int) -> str:
    return name if times == 0 else f"{name}_prime{times if times > 1 else ''}"


def learn(context: Context, trees: Iterable[Expr]) -> None:
    """Collect by which variables the symbols of formulas are differentiated, and their arguments.

    A symbol with several variables, or with values at several arguments, is kept apart.
    """
    by: dict[str, set[str]] = {}
    at: dict[str, set[str]] = {}
    trees = list(trees)
    names = frozenset().union(*map(symbols, trees))
    twice = {m[1] for n in names if (m := _BELOW.fullmatch(n)) and len(m[2]) > 1 and m[1] in names}
    for name in names:
        if (below := _BELOW.fullmatch(name)) is not None and below[1] in twice:
            by.setdefault(below[1], set()).add(below[2][0])
    context.below = frozenset(twice)
    for e in trees:
        for name in symbols(e):
            if (found := _PLAIN.fullmatch(name)) is not None:
                by.setdefault(found[2], set()).add(found[3])
        for node in outermost(e):
            if node.op == "unknown" and all(arg.op == "symbol" for arg in node.args[1:2]):
                at.setdefault(node.args[0].args[0], set()).add(str(node.args[1]))
    for name, first in at.items():
        by[name] = by.get(name, set()) | first
    context.apart = frozenset(name for name, found in by.items() if len(found) > 1)
    context.by = {name: min(found) for name, found in by.items() if len(found) == 1}


def fact(compared: Compared, line: int, shown: str, context: Context) -> Fact | None:
    """Return what a link states, for use by later ones; None if that is not used."""
    left, _, right = compared
    series = False
    sides: list[Expr] = []
    for side in (left, right):
        bare, cut = _without_orders(side)
        series |= cut or DOTS.args[0] in symbols(bare)
        flat = flattened(bare, context)
        if flat is None:
            return None
        sides.append(flat)
    one, other = sides
    name = str(one) if one.op == "symbol" else ""
    if name and (name in symbols(other) or _PRIMES.fullmatch(name)):
        name = ""
    head = re.match(rf"{re.escape(name)}\((\w+)[,)]", shown) if name else None
    if head and head[1] == "oo":
        return None  # a value at infinity
    by = head[1] if head else context.by.get(name, "")
    return Fact(line, one - other, (one, other), name, other, by, series)


def _without_orders(e: Expr) -> tuple[Expr, bool]:
    """Return an expression with dots in place of ``O(...)``, and whether there was one."""
    orders = {node: DOTS for node in outermost(e) if node.op in ORDERS}
    return (replaced(e, orders) if orders else e), bool(orders)


# Numbers


def _number(e: Expr, at: Mapping[str, complex]) -> complex:
    """Return the value of an expression in floating point.

    Raises:
        ArithmeticError, ValueError, KeyError: it has none.
    """
    op, args = e.op, e.args
    if op == "number":
        return complex(int(args[0].p) / int(args[0].q))
    if op == "symbol":
        return at[args[0]]
    if op == "pi":
        return complex(math.pi)
    if op not in _EVALUATED:
        raise KeyError(op)
    values = [_number(arg, at) for arg in args]
    if op == "+":
        return sum(values)
    if op == "*":
        return math.prod(values)
    if op == "^":
        return values[0] ** values[1]
    return complex(abs(values[0]) if op == "abs" else getattr(cmath, op)(values[0]))


def _vanishes(e: Expr, at: Mapping[str, complex]) -> bool | None:
    """Whether an expression is 0 at a point, up to rounding; None if it has no value there."""
    terms = e.args if e.op == "+" else (e,)
    try:
        values = [_number(term, at) for term in terms]
        size = sum(map(abs, values))
        return abs(sum(values)) <= 1e-9 * size if len(values) > 1 else size < 1e-12
    except (ArithmeticError, ValueError, KeyError, RecursionError):
        return None


def _points(names: Iterable[str]) -> Iterator[dict[str, complex]]:
    r = random.Random(_SEED)
    ordered = sorted(names)
    for _ in range(_POINTS):
        yield {name: complex(r.uniform(0.3, 1.9)) for name in ordered}


def is_zero(e: Expr) -> bool | None:
    """Whether an expression vanishes at random points; None if it has no values there."""
    for at in _points(symbols(e)):
        if not (found := _vanishes(e, at)):
            return found
    return True


# Solving


def _linear_in(e: Expr, name: str) -> tuple[Expr, Expr] | None:
    """Return slope and rest of an expression that is linear in a symbol; None of another."""
    try:
        slope = differentiate(e, name)
        rest = substitute(e, {name: ZERO})
    except _FAILS:
        return None
    return None if name in symbols(slope) else (slope, rest)


def _divides(name: str, *parts: Expr) -> bool:
    """Whether a symbol is a factor of all parts."""
    try:
        return all(is_zero(substitute(part, {name: ZERO})) for part in parts)
    except (InputError, ZeroDivisionError):
        return False


def _solved(
    e: Expr,
    wanted: frozenset[str],
    barred: frozenset[str],
    barred_factors: frozenset[str] = frozenset(),
) -> tuple[str, Expr] | None:
    """Return a symbol in which an equation is linear, and the value that it gives it.

    Derivatives come first, the highest ones first, then symbols of the wanted ones. An equation
    with one of the ``barred_factors`` as a factor is not divided by it.
    """

    def rank(name: str) -> tuple[int, int, str]:
        marked = _PRIMES.fullmatch(name)
        return (-int(marked[2] or 1) if marked else 0, name not in wanted, name)

    names = sorted((n for n in symbols(e) - barred if not n.startswith(REST)), key=rank)
    for name in names:
        found = _linear_in(e, name)
        if found is None or is_zero(found[0]) is not False:
            continue
        slope, rest = found
        if symbols(slope) and is_zero(rest) is not False:
            continue  # a product: the other factor may vanish as well
        if any(_divides(factor, slope, rest) for factor in symbols(slope) & barred_factors):
            continue
        return name, (-rest if slope == ONE else -rest / slope)
    return None


# functions of a variable


def _base(name: str) -> str:
    """The symbol that is differentiated in the name of a derivative, else the name."""
    marked = _PRIMES.fullmatch(name)
    return marked[1] if marked else name


def _slope(e: Expr, by: str, moving: frozenset[str]) -> Expr:
    """Return the derivative of an expression by ``by``, on which the moving symbols depend.

    Raises:
        LookupError: what depends on the variable is not known.
    """
    terms = []
    for name in sorted(symbols(e)):
        if name.startswith("hidden") or _DERIVED.match(name):
            raise LookupError(name)
        if name == by:
            terms.append(differentiate(e, name))
            continue
        marked = _PRIMES.fullmatch(name)
        base = marked[1] if marked else name
        if base in moving or base.startswith(REST):
            more = symbol(_primed(base, (int(marked[2] or 1) if marked else 0) + 1))
            terms.append(differentiate(e, name) * more)
    return add(*terms) if terms else ZERO


def _moving(zeros: Iterable[Expr]) -> frozenset[str]:
    """Return the symbols of which derivatives occur."""
    names = frozenset().union(*map(symbols, zeros))
    return frozenset(m[1] for n in names if (m := _PRIMES.fullmatch(n)))


def _variable(value: Expr, by: str, moving: frozenset[str]) -> str:
    """Return the variable of a defined function, or ``""``."""
    if by:
        return by
    return next((v for v in VARIABLES if v in symbols(value) and v not in moving), "")


def put_in(e: Expr, definitions: Sequence[Fact], moving: frozenset[str]) -> Expr:
    """Return an expression with definitions, and with derivatives of what they define."""
    for _ in range(4):
        names = symbols(e)
        put: dict[str, Expr] = {}
        for one in definitions:
            for name in names:
                marked = _PRIMES.fullmatch(name)
                if (marked[1] if marked else name) != one.name:
                    continue
                value = one.value
                for _ in range(int(marked[2] or 1) if marked else 0):
                    value = _slope(value, _variable(value, one.by, moving), moving)
                put[name] = value
        if not put:
            break
        e = substitute(e, put)
        if e.size > 10 * LARGEST:
            raise InputError("too large")
    return e


# orders of a small parameter


def parameter_of(e: Expr) -> str:
    """Return the small parameter of a sum with dots, ``""`` if it is not seen."""
    for name in SMALL:
        if name in symbols(e):
            return name
    return ""


def _exponent(e: Expr, name: str) -> float | None:
    """Return the exponent of a symbol in a product; None if that is not seen."""
    if name not in symbols(e):
        return 0.0
    if e.op == "symbol":
        return 1.0
    if e.op == "^" and e.args[0] == symbol(name) and e.args[1].op == "number":
        return int(e.args[1].args[0].p) / int(e.args[1].args[0].q)
    if e.op == "*":
        found = [_exponent(arg, name) for arg in e.args]
        known = [one for one in found if one is not None]
        return sum(known) if len(known) == len(found) else None
    return None


class _Cut:
    """Replace dots by a symbol times the power of the parameter that follows."""

    def __init__(self, name: str) -> None:
        self.name, self.count = name, 0

    def walk(self, e: Expr) -> Expr:
        """Return an expression without dots.

        Raises:
            LookupError: which power follows is not seen.
        """
        if DOTS.args[0] not in symbols(e):
            return e
        if e.op != "+":
            if e == DOTS:
                raise LookupError(self.name)
            return rebuild(e, tuple(self.walk(arg) for arg in e.args))
        others = [self.walk(arg) for arg in e.args if arg != DOTS]
        if DOTS not in e.args:
            return add(*others)
        found = [_exponent(arg, self.name) for arg in e.args if arg != DOTS]
        known = sorted({one for one in found if one is not None})
        if not known:
            raise LookupError(self.name)
        gaps = [b - a for a, b in pairwise(known)]
        step = min(gaps) if gaps else 1.0
        if abs(4 * step - round(4 * step)) > 1e-9:
            raise LookupError(self.name)
        self.count += 1
        above = number(round(4 * (known[-1] + step))) / number(4)
        rest = symbol(f"{REST}{self.count}")
        return add(*others, multiply(rest, power(symbol(self.name), above)))


def _scaled(e: Expr, name: str) -> tuple[Expr, int]:
    """Return an expression in a root of the parameter in which its powers are whole, and which
    root that is."""
    found: set[int] = {1}
    nodes, seen = [e], set()
    while nodes:
        node = nodes.pop()
        if node in seen or name not in symbols(node):
            continue
        seen.add(node)
        if node.op == "^" and node.args[0] == symbol(name) and node.args[1].op == "number":
            found.add(int(node.args[1].args[0].q))
        nodes += [arg for arg in node.args if isinstance(arg, Expr)]
    root = math.lcm(*found)
    if root == 1:
        return e, 1

    def walk(node: Expr) -> Expr:
        if node == symbol(name):
            return symbol(name) ** root
        if node.op == "^" and node.args[0] == symbol(name) and node.args[1].op == "number":
            return symbol(name) ** number(node.args[1].args[0] * root)
        if name not in symbols(node):
            return node
        return rebuild(node, tuple(walk(arg) for arg in node.args))

    return walk(e), root


def orders(e: Expr, name: str, most: int = MOST_ORDERS) -> list[Expr]:
    """Return the coefficients of the powers of the parameter, up to the first with what is left
    out. A parameter below the line is multiplied off first."""
    e, root = _scaled(e, name)
    for shift in range(5):
        coefficients: list[Expr] = []
        term, factor = e * symbol(name) ** shift if shift else e, 1
        if shift:
            term = _distributed(e, name, shift)
        for k in range(root * most + 1):
            try:
                at_zero = substitute(term, {name: ZERO})
            except _FAILS:
                break
            value = is_zero(at_zero)
            if value is None:
                break
            if _depends_on_rest(at_zero):
                return coefficients
            coefficients.append(ZERO if value else at_zero / factor)
            factor *= k + 1
            term = differentiate(term, name)
            if term.size > 10 * LARGEST:
                return coefficients
        if coefficients:
            return coefficients
    return []


def _depends_on_rest(e: Expr) -> bool:
    """Whether the value of an expression depends on what is left out of a series."""
    rest = [name for name in symbols(e) if name.startswith(REST)]
    if not rest:
        return False
    at, *_ = _points(symbols(e))
    try:
        first = _number(e, at)
        moved = {name: at[name] + math.sqrt(n + 2) for n, name in enumerate(sorted(rest))}
        second = _number(e, {**at, **moved})
    except (ArithmeticError, ValueError, KeyError):
        return True
    return abs(first - second) > 1e-12 * abs(first)


def _distributed(e: Expr, name: str, shift: int) -> Expr:
    """Return each term of a sum times a power of the parameter, with powers joined."""
    terms = e.args if e.op == "+" else (e,)
    result = []
    for term in terms:
        factors = factors_in(term)
        total, rest = shift, []
        for one in factors:
            exponent = _exponent(one, name)
            if exponent and exponent == int(exponent) and one.op in ("symbol", "^"):
                total += int(exponent)
            else:
                rest.append(one)
        result.append(multiply(*rest, symbol(name) ** total) if total else multiply(*rest, ONE))
    return add(*result)


# steps


class Search:
    """Find the steps by which one link may follow from the facts before it."""

    def __init__(
        self, context: Context, near: Sequence[Fact], goal: Fact, ahead: Sequence[Fact] = ()
    ) -> None:
        self.context = context
        self.spoken = {_base(n) for n in symbols(goal.zero)}
        self.near = list(near)
        self.ahead = [one for one in ahead if one.name and one.name != goal.name]
        self.moving = _moving(one.zero for one in self.near)
        self.moving |= context.moving
        for one in self.near:
            if one.series and one.name:
                self.moving |= self._parts(one)

    def _parts(self, one: Fact) -> frozenset[str]:
        """The terms of a series for a function that is differentiated."""
        if one.name not in self.moving:
            return frozenset()
        return symbols(one.value) - {*SMALL, *VARIABLES, DOTS.args[0]}

    def definitions(self, without: Iterable[str] = ()) -> list[Fact]:
        """Return the latest definition of each symbol."""
        found: dict[str, Fact] = {}
        barred = {*without}
        for one in self.near:
            if not one.name or one.series or one.name in barred:
                continue
            if not symbols(one.value) and not _COUNTED.fullmatch(one.name):
                continue
            found[one.name] = one
        return list(found.values())

    def implied(self, without: str) -> Iterator[Fact]:
        """Yield the symbols that equations without derivatives determine: ``(1 + x) y = a``."""
        for one in reversed(self.near):
            left, right = one.sides
            if one.name or one.series or any(_PRIMES.fullmatch(n) for n in symbols(one.zero)):
                continue
            for name in sorted(symbols(left) & self.moving - {without}):
                found = _linear_in(one.zero, name)
                if found is not None and name not in symbols(right):
                    value = -found[1] / found[0]
                    yield Fact(one.line, symbol(name) - value, (symbol(name), value), name, value)

    def equations(self) -> Iterator[tuple[Fact, Expr, str]]:
        """Yield the equations before a link with their words, the nearest first; also their
        orders in the small parameter, and the values of functions at points."""
        count = 0
        series = {one.name: one for one in self.near if one.series and one.name}
        for one in reversed(self.near):
            if one.series or one.name:
                continue
            yield one, one.zero, f"the equation of line {one.line}"
            count += 1
            if count == MOST_PREMISES:
                break
        yield from self._at_points()
        for one in reversed(self.near):
            if one.name:
                continue
            yield from self._orders(one, series)

    def _orders(self, one: Fact, series: Mapping[str, Fact]) -> Iterator[tuple[Fact, Expr, str]]:
        found = self.in_series(one, series)
        if found is None:
            return
        e, name, told = found
        parts = frozenset().union(*(symbols(s.value) for s in series.values()))
        others = {_base(n) for n in symbols(e)} & self.moving - parts
        others = {n for n in others if not n.startswith(REST) and not n[-1].isdigit()}
        if self.context.contains(e, name) or others:
            return  # what is no series may depend on the parameter
        try:
            collected = orders(e, name)
        except _FAILS:
            return
        for k, coefficient in enumerate(collected):
            if coefficient != ZERO:
                yield one, coefficient, f"order {k} in {name} of line {one.line}{told}"

    def in_series(self, one: Fact, series: Mapping[str, Fact]) -> tuple[Expr, str, str] | None:
        """Return an equation with the series put in, the parameter, and words; None if there is
        none to put in and it has no dots."""
        used = [s for s in series.values() if self._speaks_of(one.zero, s.name)]
        if not used and not one.series:
            used = self._usual_series(one)
        if not used and not one.series:
            return None
        name = next((p for p in map(parameter_of, [*(s.value for s in used), one.zero]) if p), "")
        if not name:
            return None
        try:
            cut = _Cut(name)
            facts = [Fact(s.line, ZERO, s.sides, s.name, cut.walk(s.value), s.by) for s in used]
            return (
                put_in(cut.walk(one.zero), facts, self.moving),
                name,
                "".join(f", with line {s.line} put in" for s in used if s.line),
            )
        except _FAILS:
            return None

    def _usual_series(self, one: Fact) -> list[Fact]:
        """The series ``y = y_0 + \\epsilon y_1 + \\dots`` that a leading order stands for.

        It is meant where the equation has a small parameter and the section speaks of y_0.
        """
        names = {_base(n) for n in symbols(one.zero)}
        small = next((n for n in SMALL[:2] if n in symbols(one.zero)), "")
        spoken = self.spoken | {_base(n) for f in self.near for n in symbols(f.zero)}
        leading = [n for n in sorted(names) if f"{n}0" in spoken and f"{n}0" not in names]
        if not small or len(leading) != 1 or leading[0] not in self.moving:
            return []
        (name,) = leading
        parts = symbol(f"{name}0"), symbol(small) * symbol(f"{name}1"), DOTS
        self.moving |= {f"{name}0", f"{name}1"}
        return [Fact(0, ZERO, (ZERO, ZERO), name, add(*parts), "", True)]

    def _speaks_of(self, e: Expr, name: str) -> bool:
        return any(n == name or ((m := _PRIMES.fullmatch(n)) and m[1] == name) for n in symbols(e))

    def _at_points(self) -> Iterator[tuple[Fact, Expr, str]]:
        """The values of functions at points, with the latest definition of the function."""
        known = {one.name: one for one in self.definitions()}
        for line, name, times, point, value in self.context.values[-8:]:
            one = known.get(name)
            if one is None:
                continue
            by = _variable(one.value, one.by, self.moving)
            if not by or any(n.startswith("hidden") for n in symbols(one.value)):
                continue
            try:
                slope = one.value
                for _ in range(times):
                    slope = _slope(slope, by, self.moving)
                at = substitute(slope, {by: point}) - value
            except _FAILS:
                continue
            yield one, at, f"the value of line {line} of the function of line {one.line}"

    # the three kinds of steps

    def solution(self, name: str, value: Fact) -> Step | None:
        """Return how a value of a symbol solves an equation before it."""
        others = self.definitions((name,))
        for one, zero, words in self.equations():
            if {*one.sides} == {*value.sides}:
                continue
            if not self._speaks_of(zero, name) or is_zero(zero) is not False:
                continue
            system = [*others, *self.ahead] if self.ahead else []
            ways = [way for way in (others, [*others, *self.implied(name)], system) if way]
            for known in ((), *ways):
                try:
                    before = put_in(zero, known, self.moving)
                    after = put_in(zero, [*known, value], self.moving)
                except _FAILS:
                    continue
                if not self._speaks_of(before, name) or is_zero(before) is not False:
                    continue
                if not symbols(value.value) and _linear_in(before, name) is None:
                    continue  # one of several numbers
                if is_zero(after) and self._contradicts(one, [*known, value], zero):
                    continue
                if is_zero(after):
                    told = _told([d for d in known if self._speaks_of(zero, d.name)])
                    return Step((f"{after} == 0",), f"it solves {words}{told}")
        return None

    def _contradicts(self, one: Fact, put: Sequence[Fact], zero: Expr) -> bool:
        """Whether another equation of the same line fails where all its unknowns are put in."""
        parameters = frozenset().union(*(symbols(d.value) for d in put))
        parameters -= {d.name for d in put}
        for other in self.near:
            if other.line != one.line or other.name or other.series or other.zero == zero:
                continue
            try:
                after = put_in(other.zero, put, self.moving)
            except _FAILS:
                continue
            if symbols(after) <= parameters and is_zero(after) is False:
                return True
        return False

    def consequence(self, goal: Expr, sides: tuple[Expr, Expr], line: int) -> Step | None:
        """Return how an equation follows from one or two before it."""
        if is_zero(goal) is not False:
            return None
        others = self.definitions()
        found = []
        for one, zero, words in self.equations():
            if one.line == line and one.sides == sides:
                continue
            if {*one.sides} == {*sides} or is_zero(zero) is not False:
                continue
            if symbols(zero).isdisjoint(symbols(goal)) and not others:
                continue
            found.append((one, zero, words))
            for known in ((), others) if others else ((),):
                step = self._by_one(goal, zero, known, words)
                if step is not None:
                    return step
        return (
            self._by_slopes(goal, sides, found)
            or self._by_two(goal, found, others)
            or self._integrated(goal, found, others)
        )

    def _integrated(
        self, goal: Expr, found: Sequence[tuple[Fact, Expr, str]], others: Sequence[Fact]
    ) -> Step | None:
        """An equation whose derivative holds, with a constant that was not there before."""
        constants = [n for n in symbols(goal) if CONSTANT.fullmatch(n) and n not in self.moving]
        for name in sorted(constants):
            linear = _linear_in(goal, name)
            if linear is None or linear[0].op != "number":
                continue
            for one, zero, words in found[:4]:
                if name in symbols(zero):
                    continue
                by = _variable(one.zero, one.by, self.moving) or _variable(goal, "", self.moving)
                try:
                    slope = _slope(goal, by, self.moving)
                except _FAILS:
                    break
                if is_zero(slope) is not False:
                    break  # it says what the constant is
                for known in ((), others) if others else ((),):
                    step = self._by_one(slope, zero, known, words)
                    if step is not None:
                        why = f"its derivative, in which {name} is constant, is zero: {step.why}"
                        return Step(step.claims, why)
        return None

    def _by_one(self, goal: Expr, zero: Expr, known: Sequence[Fact], words: str) -> Step | None:
        try:
            e = put_in(zero, known, self.moving) if known else zero
            g = put_in(goal, known, self.moving) if known else goal
            if known and (is_zero(g) is not False or is_zero(e) is not False):
                return None
            if symbols(e).isdisjoint(symbols(g)):
                return None
            if g in (e, -e):  # a restatement, or terms brought to the other side
                same = f"{g} - ({e if g == e else -e}) == 0"
                return None if known else Step((same,), f"it follows from {words}")
            solved = _solved(e, symbols(g), frozenset(), self.moving)
            if solved is None or solved[0] not in symbols(g):
                solved = _solved(e, symbols(g), symbols(e) - symbols(g), self.moving)
            if solved is None:
                candidate = multiple_of((e, "==", ZERO), (g, "==", ZERO))
                told = _told([d for d in known if self._speaks_of(goal, d.name)])
                return candidate and Step((candidate.claim,), f"it follows from {words}{told}")
            after = substitute(g, {solved[0]: solved[1]})
        except _FAILS:
            return None
        if not is_zero(after):
            return None
        used = [d for d in known if self._speaks_of(goal, d.name) or self._speaks_of(zero, d.name)]
        return Step((f"{after} == 0",), f"it follows from {words}{_told(used)}")

    def _by_slopes(
        self, goal: Expr, sides: tuple[Expr, Expr], found: Sequence[tuple[Fact, Expr, str]]
    ) -> Step | None:
        """The derivative of an equation or of a definition before it, once or twice."""
        if not any(_PRIMES.fullmatch(n) for n in symbols(goal)):
            return None
        sources = [(one, zero, words) for one, zero, words in found[:4]]
        for one in reversed(self.near):
            if one.name and not one.series and {*one.sides} != {*sides}:
                moved = one.name in self.moving or self._speaks_of(goal, one.name)
                sources += [(one, one.zero, f"line {one.line}")] if moved else []
        for one, zero, words in sources[:8]:
            moving = self.moving | _moving([goal]) | ({one.name} if one.name else set())
            by = _variable(zero, one.by, moving)
            slopes = [zero]
            try:
                for times in (1, 2):
                    slopes.append(_slope(slopes[-1], by, moving))
                    if is_zero(slopes[-1]) is not False:
                        break
                    step = self._by_one(goal, slopes[-1], (), f"the derivative of {words}")
                    if step is not None:
                        return step
                    if times == 2 or not symbols(slopes[0]) & symbols(goal):
                        continue
                    claims = self._from_pair(goal, slopes[0], slopes[1])
                    if claims is not None:
                        return Step(claims, f"it follows from {words} and its derivative")
            except _FAILS:
                continue
        return None

    def _by_two(
        self, goal: Expr, found: Sequence[tuple[Fact, Expr, str]], others: Sequence[Fact]
    ) -> Step | None:
        near = found[:5]
        for n, (_, one, first) in enumerate(near):
            for _, other, second in near[n + 1 :]:
                if one == other:
                    continue
                try:
                    claims = self._from_pair(goal, one, other)
                except _FAILS:
                    continue
                if claims is not None:
                    return Step(claims, f"it follows from {first} and {second}")
        return None

    def _from_pair(self, goal: Expr, one: Expr, other: Expr) -> tuple[str, ...] | None:
        """The claim that an equation holds where two others do, if it seems true."""
        first = _solved(one, symbols(goal), frozenset(), self.moving)
        if first is None:
            return None
        rest = substitute(other, {first[0]: first[1]})
        if is_zero(rest) is not False:
            return None
        second = _solved(rest, symbols(goal), frozenset((first[0],)), self.moving)
        if second is None:
            return None
        after = substitute(goal, {first[0]: first[1]})
        if second[0] not in symbols(after):
            return None
        after = substitute(after, {second[0]: second[1]})
        return (f"{after} == 0",) if after.size < 4 * LARGEST and is_zero(after) else None

    def agreement(self, goal: Fact) -> Step | None:
        """Return how the printed orders of a series agree with those of what is put in."""
        series = {one.name: one for one in self.near if one.series and one.name}
        if goal.name:
            one = series.get(goal.name)
            sources = [one] if one is not None else []
        else:
            sources = [one for one in reversed(self.near) if not one.name]
        others = self.definitions((goal.name,) if goal.name else ())
        for one in sources[:MOST_PREMISES]:
            if {*one.sides} == {*goal.sides}:
                continue
            step = self._agrees(goal, one, series, others)
            if step is not None:
                return step
        return None

    def _agrees(
        self, goal: Fact, one: Fact, series: Mapping[str, Fact], others: Sequence[Fact]
    ) -> Step | None:
        name = parameter_of(goal.zero) or parameter_of(one.zero)
        if not name:
            return None
        try:
            cut = _Cut(name)
            own = cut.walk(goal.value if goal.name else goal.zero)
            if goal.name:
                source, told = cut.walk(one.value), f"line {one.line}"
            else:
                found = self.in_series(one, series)
                if found is None or found[1] != name:
                    return None
                source, told = found[0], f"line {one.line}{found[2]}"
                source = _renamed(source)
            source = put_in(source, others, self.moving)
            own = put_in(own, others, self.moving) if not goal.name else own
            if self.context.contains(own + source, name):
                return None
            for sign in (1, -1):
                gaps = orders(own - source if sign == 1 else own + source, name)
                needed = _printed_order(goal, name)
                if needed is None or len(gaps) <= needed:
                    return None
                if all(gap == ZERO or is_zero(gap) for gap in gaps):
                    if all(c == ZERO for c in orders(own, name)[: needed + 1]):
                        return None
                    claims = _order_claims(own - source if sign == 1 else own + source, name)
                    used = [d for d in others if self._speaks_of(one.zero, d.name)]
                    return Step(claims[: len(gaps)], f"its orders are those of {told}{_told(used)}")
        except _FAILS:
            return None
        return None


def _renamed(e: Expr) -> Expr:
    """Keep what is left out of two series apart."""
    names = {n: symbol(f"{n}b") for n in symbols(e) if n.startswith(REST)}
    return substitute(e, names) if names else e


def _printed_order(goal: Fact, name: str) -> int | None:
    """The highest power of the parameter that is printed, of whole powers."""
    e = goal.value if goal.name else goal.zero
    _, root = _scaled(e, name)
    found = [0.0]
    nodes = [e]
    while nodes:
        node = nodes.pop()
        if node.op == "+" and DOTS in node.args:
            powers = [_exponent(arg, name) for arg in node.args if arg != DOTS]
            found += [p for p in powers if p is not None]
        nodes += [arg for arg in node.args if isinstance(arg, Expr)]
    if DOTS.args[0] not in symbols(e):
        found.append(1.0)
    return round(max(found) * root)


def _order_claims(e: Expr, name: str) -> tuple[str, ...]:
    e, _ = _scaled(e, name)
    claims = []
    for _ in range(12):
        try:
            at_zero = substitute(e, {name: ZERO})
        except _FAILS:
            break
        if _depends_on_rest(at_zero):
            break
        claims.append(f"{at_zero} == 0")
        e = differentiate(e, name)
    return tuple(claims)


def _told(used: Sequence[Fact]) -> str:
    """The definitions that were put in, in words."""
    named = [f"{one.name} of line {one.line}" for one in used]
    return f", with {', '.join(named)} put in" if named else ""


class Difference(NamedTuple):
    """A term that keeps an equation from being a multiple of an earlier one.

    Attributes:
        claim: the claim that the factor times the earlier one differs by that term only.
        factor: what the earlier one is multiplied by.
        expected, printed: the term as it should be, and as it stands.
        right: the equation as it should be, as a claim.
    """

    claim: str
    factor: Expr
    expected: Expr
    printed: Expr
    right: str


LEAST_ALIKE = 3
"""The terms that must agree before another one is said to be wrong."""


def difference(goal: Fact, one: Fact) -> Difference | None:
    """Return the one term by which an equation is no multiple of an earlier one.

    At least :data:`LEAST_ALIKE` terms agree with those of the earlier one times one factor, and one
    of each is left, with the same symbols but for the powers of those in the factor.
    """
    first, second = _terms(one.zero), _terms(goal.zero)
    if len(first) != len(second) or len(first) <= LEAST_ALIKE:
        return None
    names = symbols(goal.zero) | symbols(one.zero)
    points = list(_points(names))
    try:
        before = [[_number(term, at) for at in points] for term in first]
        after = [[_number(term, at) for at in points] for term in second]
    except (ArithmeticError, ValueError, KeyError):
        return None
    for n in range(2):  # one of two terms is right
        for m, term in enumerate(second):
            try:
                ratio = [b / a for a, b in zip(before[n], after[m], strict=True)]
            except ZeroDivisionError:
                continue
            left, found = [*range(len(second))], []
            for k, values in enumerate(before):
                wanted = [a * r for a, r in zip(values, ratio, strict=True)]
                place = next((j for j in left if _alike(wanted, after[j])), None)
                if place is None:
                    found.append(k)
                else:
                    left.remove(place)
            if len(found) != 1 or len(left) != 1:
                continue
            factor = _tidy(term / first[n])
            expected, printed = _tidy(factor * first[found[0]]), second[left[0]]
            moved = {_base(name) for name in symbols(first[found[0]]) ^ symbols(printed)}
            if not moved <= {_base(name) for name in symbols(first[n]) ^ symbols(term)}:
                continue
            claim = f"{factor * one.zero} - ({goal.zero}) == {expected} - ({printed})"
            terms = [expected if m == left[0] else term for m, term in enumerate(second)]
            return Difference(claim, factor, expected, printed, f"{add(*terms)} == 0")
    return None


def _alike(first: Sequence[complex], second: Sequence[complex]) -> bool:
    return all(abs(a - b) <= 1e-9 * abs(a) for a, b in zip(first, second, strict=True))


def _tidy(e: Expr) -> Expr:
    """A product with the powers of each symbol joined; it is used off the zeros of the symbols."""
    exponents: dict[Expr, Expr] = {}
    nodes = list(e.args) if e.op == "*" else [e]
    rest = []
    while nodes:
        node = nodes.pop()
        base, exponent = node.args if node.op == "^" else (node, ONE)
        if base.op == "*" and exponent.op == "number":
            nodes += [power(part, exponent) for part in base.args]
        elif base.op == "number" or exponent.op != "number":
            rest.append(node)
        else:
            exponents[base] = exponents.get(base, ZERO) + exponent
    powers = [power(base, n) for base, n in exponents.items() if n != ZERO]
    return multiply(*rest, *powers[::-1])


def _terms(e: Expr) -> list[Expr]:
    """The terms of a sum, with products of sums multiplied out."""
    if e.op == "+":
        return [term for arg in e.args for term in _terms(arg)]
    if e.op == "*":
        inner = next((arg for arg in e.args if arg.op == "+"), None)
        if inner is not None:
            rest = [arg for arg in e.args if arg is not inner]
            return [term for arg in inner.args for term in _terms(multiply(*rest, arg))]
    return [e]
