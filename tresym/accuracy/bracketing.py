"""The best constant of a claim, and from where on a claim holds, enclosed from both sides.

A claim with a free constant c, such as ``binomial(2*n, n) <= 4**n/sqrt(pi*(n + c))`` for n >= 1,
holds for some c and fails for others. :func:`best` decides it with numbers in place of c: for
c = 1/4 it is ENCLOSED, for c = 0.252 REFUTED. If the difference of the two sides is monotone in c,
which is a claim as well, the best c lies in between. :func:`holds_from` does the same with the end
of a region: ``abs(sin(x) - x) <= x/1000`` holds for 0 < x <= 0.0774, and fails for a smaller x than
0.0775. There no monotony is needed, since what holds on a region holds on a smaller one.

Both ends are decided claims, which anyone can check again; how they were found does not matter.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import count
from typing import Any

from flint import fmpq

from tresym.checking.time_limited import Task, check_within
from tresym.reals.decisions.answer import Answer
from tresym.reals.language.claims import Written, read_claim
from tresym.reals.language.comparisons import LIMIT, ORDERS
from tresym.reals.language.expression import number, substitute, symbol, symbols
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import read_path
from tresym.reals.language.readings import read_as
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

FIRST = tuple(
    Fraction(text)
    for text in ("1", "0", "2", "-1", "1/2", "10", "1/10", "-10", "100", "1/100", "1000", "-100")
)
"""Where a claim is decided until it holds at one value and fails at another."""
ENDS = tuple(Fraction(4) ** k for k in (0, 1, -1, 2, -2, 3, -3, 5, -5, 8, -8, 12, -12))
"""The same for the end of a region: the distance from the end of the path, or 1/distance."""
CLOSE = Fraction(1, 500)
"""The search ends when both ends differ by at most this share."""
SHARES = (Fraction(1, 2), Fraction(3, 4), Fraction(1, 4), Fraction(7, 8), Fraction(1, 8))
"""Where it goes on, as shares of the interval, if nothing is decided in the middle."""


@dataclass(frozen=True)
class Bracket:
    """A number enclosed by a claim that holds and a claim that fails.

    Attributes:
        name: the constant, or the variable of the path.
        holds: a value with which the claim holds, as text.
        fails: a value with which it fails.
        claim, refuted: the two claims as they were decided.
        verdict: PROVED or ENCLOSED, of the first.
        witness: where the second fails, if a point is known.
        monotone: whether the claim was shown to hold for all values beyond ``holds``, and to fail
            for all beyond ``fails``; None if neither was shown nor is needed.
    """

    name: str
    holds: str
    fails: str
    claim: str
    refuted: str
    verdict: Verdict
    witness: str
    monotone: bool | None

    def __str__(self) -> str:
        low, high = sorted((self.holds, self.fails), key=Fraction)
        word = "smallest" if Fraction(self.holds) > Fraction(self.fails) else "largest"
        what = f"the {word} {self.name} lies between {low} and {high}"
        if self.monotone is None:
            what = f"a change lies between {low} and {high} (monotony in {self.name} is not shown)"
        at = f" at {self.witness}" if self.witness else ""
        return "\n".join(
            [what, f"  {self.verdict.value}   {self.claim}", f"  REFUTED   {self.refuted}{at}"]
        )

    def as_json(self) -> dict[str, Any]:
        """Return the bracket for JSON."""
        return {
            "name": self.name,
            "holds": self.holds,
            "fails": self.fails,
            "claim": self.claim,
            "verdict": self.verdict.value,
            "refuted": self.refuted,
            "witness": self.witness,
            "monotone": self.monotone,
        }


def best(claim: str, name: str, given: str = "", seconds: float = 60.0) -> Bracket | None:
    """Enclose the best constant of a claim from both sides.

    Args:
        claim: a relation with a free constant, such as ``"log(x) <= c*sqrt(x) given x > 0"``.
        name: the constant.
        given: conditions, which do not restrict the constant.
        seconds: when the search ends, apart from a decision under way.

    Returns:
        The bracket; None if the claim is not found both to hold and to fail.

    Raises:
        InputError: the claim cannot be read, or has no such constant.

    Example:
        >>> import tresym
        >>> found = tresym.best("log(x) <= c*sqrt(x)", "c", given="x > 0")
        >>> 0.72 < float(found.fails) < 2/2.71828 < float(found.holds) < 0.75
        True
    """
    written = _read(claim, given)
    if name not in {n for link in written.comparisons for n in _names(link)}:
        raise InputError(f"the claim does not contain {name}: give the constant that is sought")
    if any(name in _names(link) for link in written.given):
        raise InputError(f"conditions on {name} would restrict what is sought: leave them out")

    def stated(value: Fraction) -> str:
        put = {name: number(fmpq(value.numerator, value.denominator))}
        links = tuple((substitute(x, put), sign, substitute(y, put)) for x, sign, y in links_of)
        read = str(written._replace(comparisons=links))
        typed = re.sub(rf"\b{name}\b", f"({_shown(value)})", claim)
        typed += f" given {given}" if given else ""
        return typed if read_as(typed) == read else read

    links_of = written.comparisons
    found = _search(stated, FIRST, seconds, _between)
    if found is None:
        return None
    holds, fails, proved, refuted = found
    monotone = _is_monotone(written, name, holds > fails) or None
    texts = (_shown(holds), _shown(fails), stated(holds), stated(fails))
    return Bracket(name, *texts, proved.verdict, _witness(refuted), monotone)


def holds_from(claim: str, path: str, given: str = "", seconds: float = 60.0) -> Bracket | None:
    """Enclose from where on, towards the end of a path, a claim holds everywhere.

    Args:
        claim: a relation, such as ``"abs(sin(x) - x) <= x/1000"``.
        path: where the variable tends, such as ``"x -> 0+"`` or ``"x -> oo"``.
        given: further conditions.
        seconds: when the search ends, apart from a decision under way.

    Returns:
        The bracket, whose values are ends of a region: ``x >= 22.4``, or ``0 < x <= 0.0774``;
        None if the claim is not found both to hold and to fail.

    Example:
        >>> import tresym
        >>> found = tresym.holds_from("1/x <= 1/1000 + exp(-x)", "x -> oo")
        >>> float(found.fails) <= 1000 <= float(found.holds)
        True
    """
    written, way = _read(claim, given), read_path(path)
    if way.together or not way.name or (len(way.sides) > 1 and way.point is None):
        raise InputError("give a path of one variable, such as x -> 0+ or x -> oo")
    name = way.name
    distance = symbol(name) if way.point is None else symbol(name) - way.point
    side = way.sides[0]

    def stated(value: Fraction) -> str:
        end = number(fmpq(value.numerator, value.denominator))
        region: tuple[Compared, ...]
        if way.point is None:
            region = ((side * distance, ">=", end),)
        elif len(way.sides) == 1:
            region = ((number(0), "<", side * distance), (side * distance, "<=", end))
        else:
            size = parse(f"abs({distance})")
            region = ((number(0), "<", size), (size, "<=", end))
        read = str(written._replace(given=(*written.given, *region)))
        said = str(Written((), region, None)).strip()
        joined = f"{given}, " if given else ""
        typed = f"{claim} given {joined}{said.removeprefix('given ')}"
        return typed if " given " not in claim and read_as(typed) == read else read

    found = _search(stated, ENDS, seconds, _between_positive)
    if found is None:
        return None
    holds, fails, proved, refuted = found
    if (holds > fails) != (way.point is None):
        return None  # what holds on a region would fail on a smaller one: a mistake, never shown
    texts = (_shown(holds), _shown(fails), stated(holds), stated(fails))
    return Bracket(name, *texts, proved.verdict, _witness(refuted), True)


def _read(claim: str, given: str) -> Written:
    written = read_claim(claim, given)
    for _, relation, _ in written.comparisons:
        if relation in (*ORDERS, LIMIT):
            raise InputError("give an inequality, not an order or a limit")
    if written.path is not None or written.on:
        raise InputError("give an inequality and its conditions, without a path or region")
    return written


def _names(link: Compared) -> frozenset[str] | set[str]:
    return symbols(link[0]) | symbols(link[2])


Found = tuple[Fraction, Fraction, Answer, Answer]


def _search(
    stated: Callable[[Fraction], str],
    first: tuple[Fraction, ...],
    seconds: float,
    between: Callable[[Fraction, Fraction, Fraction], Fraction],
) -> Found | None:
    """Find a value with which a claim holds and one with which it fails, and bring them close."""
    start = time.monotonic()
    known: dict[Fraction, Answer] = {}

    def verdict(value: Fraction) -> Verdict:
        known[value] = check_within(Task(stated(value)), max(1.0, seconds / 12))
        return known[value].verdict

    holds: list[Fraction] = []
    fails: list[Fraction] = []
    for value in first:
        decided = verdict(value)
        holds += [value] if decided.holds else []
        fails += [value] if decided is Verdict.REFUTED else []
        if (holds and fails) or time.monotonic() - start > seconds:
            break
    if not (holds and fails):
        return None
    good, bad = min(((a, b) for a in holds for b in fails), key=lambda pair: abs(pair[0] - pair[1]))
    while abs(good - bad) > CLOSE * max(abs(good), abs(bad)) and abs(good - bad) > CLOSE / 1000:
        for share in SHARES:
            value = between(good, bad, share)
            if value in known or time.monotonic() - start > seconds:
                continue
            decided = verdict(value)
            if decided.holds:
                good = value
            elif decided is Verdict.REFUTED:
                bad = value
            else:
                continue
            break
        else:
            break
    return good, bad, known[good], known[bad]


def _between(good: Fraction, bad: Fraction, share: Fraction) -> Fraction:
    """Return a number with a small denominator near a share of the way."""
    middle, reach = good + (bad - good) * share, abs(good - bad) / 10
    return _simplest(middle - reach, middle + reach)


def _between_positive(good: Fraction, bad: Fraction, share: Fraction) -> Fraction:
    """Return the same; in the geometric middle, where the ends differ by more than a factor 4."""
    if max(good, bad) < 4 * min(good, bad):
        return _between(good, bad, share)
    middle = Fraction(float(good) ** float(1 - share) * float(bad) ** float(share))
    return _simplest(middle * Fraction(9, 10), middle * Fraction(11, 10))


def _simplest(low: Fraction, high: Fraction) -> Fraction:
    """Return a fraction with a small denominator, else a decimal with few digits, in between."""
    middle = (low + high) / 2
    for denominator in (1, 2, 3, 4, 5, 6, 8, 10, 12):
        near = Fraction(round(middle * denominator), denominator)
        if low <= near <= high:
            return near
    digits = 2
    while True:
        near = Fraction(round(middle * 10**digits), 10**digits)
        if low <= near <= high:
            return near
        digits += 1


def _shown(value: Fraction) -> str:
    """Return a number as a short fraction, or as a decimal."""
    if value.denominator <= 12:
        return str(value)
    digits = next(n for n in count(1) if (value * 10**n).denominator == 1)
    sign, whole = (
        "-" if value < 0 else "",
        f"{abs(value.numerator * 10**digits // value.denominator)}",
    )
    whole = whole.zfill(digits + 1)
    return f"{sign}{whole[:-digits]}.{whole[-digits:]}"


def _witness(answer: Answer) -> str:
    return ", ".join(f"{name} = {value}" for name, value in (answer.witness or {}).items())


def _is_monotone(written: Written, name: str, smallest: bool) -> bool:
    """Whether the claim, if it holds for one value, holds for all larger (or smaller) ones.

    It does if each side that should be the greater one grows with the constant, and the other one
    does not grow.
    """
    other = symbol(f"{name}_more" if smallest else f"{name}_less")
    under = (*written.given, (symbol(name), "<" if smallest else ">", other))
    for left, sign, right in written.comparisons:
        if sign not in ("<", "<=", ">", ">="):
            return False
        low, high = (left, right) if sign.startswith("<") else (right, left)
        for side, relation in ((high, "<="), (low, ">=")):
            if name not in symbols(side):
                continue
            moved = substitute(side, {name: other})
            claim = str(Written(((side, relation, moved),), under, None))
            if not check_within(Task(claim)).verdict.holds:
                return False
    return True
