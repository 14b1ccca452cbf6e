"""Claims about a function or a motion as a whole, each under its name in the textbooks.

- ``infimum(f, x) == v``, ``supremum``: v is the greatest lower bound, the least upper bound, of f
  over all x that the conditions allow; ``minimum`` and ``maximum``: f attains it besides. Several
  variables stand in brackets; without them, as in ``infimum(x**2 + y**2) == 0``, all variables are
  meant.
- ``conserved(f) along (x, y)' == (y, -x)``: f is constant along every solution of this system of
  differential equations, as long as the conditions hold.
- ``stable (x, y) == (0, 0) along (x, y)' == (y, -x)``: the point is an equilibrium, and for every
  neighbourhood of it there is one from which no solution leaves the former (Lyapunov);
  ``unstable``: an equilibrium of which this is not so; ``asymptotically stable``: stable, and
  solutions that begin nearby tend to it. ``by V`` names a function that may show it.
"""

from __future__ import annotations

import re
from typing import NamedTuple, TypeAlias

from tresym.reals.language.brackets import closing, encloses, split
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.claims import read_claim
from tresym.reals.language.expression import ZERO, Expr, symbol, symbols
from tresym.reals.language.formula import Compared
from tresym.reals.language.typesetting import PLAIN, Printer
from tresym.reals.numbers.exact import InputError

EXTREMA = ("infimum", "supremum", "minimum", "maximum")
STABLE, UNSTABLE, ASYMPTOTICALLY = "stable", "unstable", "asymptotically stable"
_FORMS = {
    "conserved": "conserved(f) along (x, y)' == (F, G)",
    "stable": "stable (x, y) == (p, q) along (x, y)' == (F, G)",
}
_NAME = re.compile(r"[A-Za-z]\w*")
_BEGINNING = re.compile(
    rf"(?:(?P<extremum>{'|'.join(EXTREMA)})\s*\(|(?P<conserved>conserved)\s*\("
    r"|(?P<stable>asymptotically\s+stable|stable|unstable)\s+(?=[A-Za-z(]))"
)
WORDS = rf"\b(?:{'|'.join(EXTREMA)}|conserved|stable|unstable)\b"
"""What a claim of this kind contains."""
_EQUALS = r"(?<![<>=!~:])={1,2}(?![=<>])"


class Extremum(NamedTuple):
    """That v is the infimum, supremum, minimum or maximum of a function.

    Attributes:
        how: one of :data:`EXTREMA`.
        function: the function.
        names: its variables; empty if all are meant.
        value: what is claimed, which may be infinite.
        given: the conditions.
    """

    how: str
    function: Expr
    names: tuple[str, ...]
    value: Expr
    given: tuple[Compared, ...]


class Conserved(NamedTuple):
    """That a function is constant along the solutions of ``names' == rates``."""

    function: Expr
    names: tuple[str, ...]
    rates: tuple[Expr, ...]
    given: tuple[Compared, ...]


class Equilibrium(NamedTuple):
    """That a point is a stable or an unstable equilibrium of ``names' == rates``.

    Attributes:
        how: ``stable``, ``unstable`` or ``asymptotically stable``.
        names: the variables.
        point: the equilibrium.
        rates: the derivatives of the variables by time.
        by: a function that may show it; None if none is named.
        given: the conditions.
    """

    how: str
    names: tuple[str, ...]
    point: tuple[Expr, ...]
    rates: tuple[Expr, ...]
    by: Expr | None
    given: tuple[Compared, ...]


Named: TypeAlias = Extremum | Conserved | Equilibrium


def begins_named(text: str) -> bool:
    """Return whether a text is a claim of this module, by its beginning."""
    found = _BEGINNING.match(text.strip())
    if found is None or found["extremum"] is None:
        return found is not None
    return len(split(text, rf"{_EQUALS}|[<>]")) > 1


def read_named(text: str, given: tuple[Compared, ...]) -> Named:
    """Read a claim that :func:`begins_named`, under conditions that were read.

    Raises:
        InputError: it cannot be read; the message says what to write.
    """
    found = _BEGINNING.match(text)
    assert found is not None
    if found["stable"]:
        return _equilibrium(" ".join(found["stable"].split()), text[found.end() :], given)
    opening = found.end() - 1
    end = closing(text[opening:])
    if end is None:
        raise InputError(f"a bracket of '{text}' is not closed")
    inner, rest = text[opening + 1 : opening + end], text[opening + end + 1 :].strip()
    if found["conserved"]:
        return _conserved(inner, rest, given)
    return _extremum(found["extremum"], inner, rest, given)


def names_of(claim: Named) -> tuple[str, ...]:
    """The variables of the function or motion, where the claim names them."""
    return claim.names


def sides_of(claim: Named) -> tuple[Compared, ...]:
    """What stands in a claim, as comparisons; a function alone stands as f == f."""
    if isinstance(claim, Extremum):
        own = tuple((symbol(n), "==", symbol(n)) for n in claim.names)
        return ((claim.function, "==", claim.value), *own)
    alone = [*claim.rates, *map(symbol, claim.names)]
    alone += [claim.function] if isinstance(claim, Conserved) else [*claim.point]
    if isinstance(claim, Equilibrium) and claim.by is not None:
        alone.append(claim.by)
    return tuple((e, "==", e) for e in alone)


def _extremum(how: str, inner: str, rest: str, given: tuple[Compared, ...]) -> Extremum:
    equals, *value = split(rest, _EQUALS)
    if equals.strip() or len(value) != 1:
        raise InputError(f"write {how}(f, x) == v, with one value")
    function, *names = split(inner, ",")
    if len(names) > 1:
        raise InputError(f"write {how}(f, (x, y)) == v, with the variables in brackets")
    variables = _names(names[0], how) if names else ()
    bound = _expression(value[0], how, infinite=True)
    where = symbols(bound) - {INFINITY.args[0]}
    if not names and where:
        raise InputError(
            f"{', '.join(sorted(where))} may be a variable of the function or a parameter: "
            f"write {how}(f, x) == v with the variables of the function"
        )
    if where & {*variables}:
        raise InputError(f"the value of {how}(f, x) cannot contain the variable")
    if bound in (INFINITY, -INFINITY) and how in ("minimum", "maximum"):
        raise InputError(f"no function has the {how} oo: write infimum or supremum")
    read = Extremum(how, _expression(function, how), variables, bound, given)
    unbounded = {"infimum": INFINITY, "supremum": -INFINITY}
    if bound == unbounded.get(how):
        raise InputError(f"the {how} is {bound} only where no point satisfies the conditions")
    return read


def _conserved(inner: str, rest: str, given: tuple[Compared, ...]) -> Conserved:
    names, rates = _motion(rest, "conserved")
    return Conserved(_expression(inner, "conserved"), names, rates, given)


def _equilibrium(how: str, text: str, given: tuple[Compared, ...]) -> Equilibrium:
    parts = split(text, r"\balong\b")
    if len(parts) != 2:
        raise InputError(f"write {_FORMS['stable']}")
    motion, *function = split(parts[1], r"\bby\b")
    if len(function) > 1:
        raise InputError("one function can be named after by")
    names, rates = _motion(f"along {motion}", "stable")
    left, *right = split(parts[0], _EQUALS)
    if len(right) != 1 or _names(left, "stable") != names:
        raise InputError(f"write {_FORMS['stable']}, with the same variables twice")
    point = _entries(right[0], "stable")
    if len(point) != len(names):
        raise InputError("each variable needs one coordinate of the equilibrium")
    if any(symbols(p) & {*names} for p in point):
        raise InputError("the coordinates of an equilibrium cannot depend on the variables")
    by = _expression(function[0], "stable") if function else None
    return Equilibrium(how, names, point, rates, by, given)


def _motion(text: str, kind: str) -> tuple[tuple[str, ...], tuple[Expr, ...]]:
    """Read ``along (x, y)' == (F, G)``."""
    text = text.strip()
    if not re.match(r"along\b", text):
        raise InputError(f"write {_FORMS[kind]}")
    left, *right = split(text.removeprefix("along"), _EQUALS)
    if len(right) != 1 or not left.strip().endswith("'"):
        raise InputError(f"write {_FORMS[kind]}")
    names = _names(left.strip().removesuffix("'"), kind)
    rates = _entries(right[0], kind)
    if len(rates) != len(names):
        raise InputError("each variable needs one derivative: (x, y)' == (F, G)")
    return names, rates


def _names(text: str, kind: str) -> tuple[str, ...]:
    text = text.strip()
    parts = split(text[1:-1], ",") if encloses(text) else [text]
    names = tuple(part.strip() for part in parts)
    if not all(_NAME.fullmatch(name) for name in names):
        raise InputError(f"'{text}' is not a list of variables: write {_form(kind)}")
    if len(set(names)) < len(names):
        raise InputError(f"a variable stands twice in '{text}'")
    if any(symbols(_expression(name, kind)) != {name} for name in names):
        raise InputError(f"'{text}' is not a list of variables: it contains a constant")
    return names


def _form(kind: str) -> str:
    return _FORMS.get(kind, f"{kind}(f, (x, y)) == v")


def _entries(text: str, kind: str) -> tuple[Expr, ...]:
    text = text.strip()
    parts = split(text[1:-1], ",") if encloses(text) else [text]
    return tuple(_expression(part, kind) for part in parts)


def _expression(text: str, kind: str, infinite: bool = False) -> Expr:
    bare = text.replace(" ", "")
    if infinite and bare in ("oo", "+oo", "-oo"):
        return -INFINITY if bare[0] == "-" else INFINITY
    found = read_claim(f"{text} == 0").comparisons
    if len(found) != 1 or found[0][1] != "==" or found[0][2] != ZERO:
        raise InputError(f"'{text.strip()}' is not an expression: write {_form(kind)}")
    return found[0][0]


# Text and print


def named_text(claim: Named) -> str:
    """A claim without its conditions, as text that is read again."""
    if isinstance(claim, Extremum):
        names = f", {_listed(claim.names)}" if claim.names else ""
        return f"{claim.how}({claim.function}{names}) == {claim.value}"
    motion = f"along {_listed(claim.names)}' == {_listed(claim.rates)}"
    if isinstance(claim, Conserved):
        return f"conserved({claim.function}) {motion}"
    by = "" if claim.by is None else f" by {claim.by}"
    return f"{claim.how} {_listed(claim.names)} == {_listed(claim.point)} {motion}{by}"


def _listed(items: tuple[object, ...]) -> str:
    texts = ", ".join(map(str, items))
    return f"({texts})" if len(items) > 1 else texts


def named_in_latex(claim: Named, writer: Printer = PLAIN) -> str:
    """A claim without its conditions, in LaTeX as ``writer`` writes expressions."""
    if isinstance(claim, Extremum):
        below = ", ".join(map(writer.name, claim.names))
        operator = rf"\{claim.how[:3]}" + (f"_{{{below}}}" if below else "")
        alone = claim.function.op == "symbol"
        function = writer.shown(claim.function)
        function = function if alone else rf"\left( {function} \right)"
        return rf"{operator} {function} = {writer.shown(claim.value)}"
    variables = [*map(writer.name, claim.names)]
    rates = zip(variables, map(writer.shown, claim.rates), strict=True)
    motion = r",\ ".join(rf"\dot{{{name}}} = {rate}" for name, rate in rates)
    if isinstance(claim, Conserved):
        return rf"{writer.shown(claim.function)} \text{{ is conserved along }} {motion}"
    place = f"{_row(variables, writer)} = {_row([*map(writer.shown, claim.point)], writer)}"
    article = "a" if claim.how == STABLE else "an"
    return rf"{place} \text{{ is {article} {claim.how} equilibrium of }} {motion}"


def _row(parts: list[str], writer: Printer) -> str:
    return parts[0] if len(parts) == 1 else writer.bracketed(", ".join(parts))
