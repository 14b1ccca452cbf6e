"""Orders of difference formulas, quadratures and methods for differential equations.

By Taylor's theorem with remainder a scheme is, up to every power of h, a polynomial in h whose
coefficients are polynomials in the derivatives at x of the functions in it: see
:mod:`tresym.asymptotics.jets`. These derivatives are arbitrary for smooth functions: the scheme is
O(h**p) for all of them if and only if all coefficients below h**p are zero. If one is not, values
of the derivatives at which it differs from 0 give a counterexample, a polynomial. The functions in
differential equations are their solutions; what is arbitrary then is the right side f and where the
solution starts.

Examples: ``(f(x+h) - 2*f(x) + f(x-h))/h**2 == diff(f(x), x, 2) + O(h**2) as h -> 0``, and the
midpoint rule ``y(t+h) == y(t) + h*k + O(h**3) as h -> 0 given diff(y(t), t) == f(t, y(t)),
k == f(t + h/2, y(t) + h/2*f(t, y(t)))``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import islice, product
from math import factorial, prod

from flint import arb, fmpq

from tresym.asymptotics.jets import PERIODIC, Jets, Polynomial, Series, UnreadError, Variable
from tresym.asymptotics.systems_of_jets import SystemJets
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.readable_witnesses import constants_hold
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    multiply,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

LEMMA = "Taylor's theorem with remainder at one point (DLMF 1.4(vi))"
FURTHER = 12
"""Powers of h beyond the claimed one in which the leading error is looked for."""
FURTHER_OF_SOLUTIONS = 1
"""The same where functions of functions occur, whose coefficients grow fast."""
SHOWN = 12
"""A leading error with more terms is not shown."""
TRIED = 2_000
"""Values of derivatives and parameters that are tried for a counterexample."""
_VALUES = (1, 2, -1, 3, 5)
POINTS = 5


def decide_scheme(claim: Comparison, statement: Statement) -> Answer:
    """Decide that a scheme is O(h**p) or o(h**p) for all smooth functions in it."""
    try:
        return _decide(claim, statement)
    except UnreadError as reason:
        why = f"integrals, limits and orders of arbitrary functions need a scheme in h: {reason}"
        return Answer(Verdict.UNDECIDED, why)


def true_order(claim: Comparison, statement: Statement) -> Expr | None:
    """Return h**p where a scheme is claimed to be O(h**(p + 1)) or o(h**p) and is O(h**p)."""
    path = statement.path
    if path is None or not any(True for e in (claim.left, *statement.said) for _ in functions(e)):
        return None
    try:
        scheme, p, small = _claimed(claim, path.name)
        found = _known(Jets(path.name, statement.equations), scheme, p + small)
    except UnreadError:
        return None
    return _power(symbol(path.name), p + small - 1) if found.first == p + small - 1 else None


def _decide(claim: Comparison, statement: Statement) -> Answer:
    path = statement.path
    if path is None or path.point != ZERO or path.expression is not None or path.together:
        raise UnreadError("its path must be h -> 0")
    if statement.integers or statement.uniformly or path.reach is not None or path.region:
        raise UnreadError("integers, ranges and uniformity are not supported")
    scheme, p, small = _claimed(claim, path.name)
    jets = Jets(path.name, statement.equations)
    for e in (d.function for d in claim.derivatives):  # what is read is smooth
        _known(jets, e, 1)
    least = p + small
    found = _known(jets, scheme, least)
    if not found.terms:
        further = FURTHER_OF_SOLUTIONS if _grows(jets, scheme) else FURTHER
        why = _proved(jets, scheme, least, p + further + 1)
        systems = _of_systems(scheme, statement, least) if jets.rules else ""
        return Answer(Verdict.PROVED, why + systems, lemma=LEMMA)
    q = found.first
    error = f"the error is {_term(jets, found.terms[q], q)}"
    example = _Counterexample.of(jets, found.terms[q], statement)
    if example is None:
        return Answer(Verdict.UNDECIDED, f"{error}, but no example was found")
    why = f"{error}, so the true order is {_power(symbol(path.name), q)}"
    return Answer(Verdict.REFUTED, f"{why}; for example {example}", witness={}, lemma=LEMMA)


def _claimed(claim: Comparison, h: str) -> tuple[Expr, int, bool]:
    """Return what is claimed to be O(h**p), the exponent, and whether o(h**p) is claimed."""
    if claim.relation == "->":
        return claim.left - claim.right, 0, True
    if claim.relation not in ("O", "o"):
        raise UnreadError("only limits, O and o are decided")
    right = replaced(claim.right, {apply("abs", symbol(h)): symbol(h)})
    found = _known(Jets(h), right, 1 + 2 * _largest_exponent(right))
    if len(found.terms) != 1 or not found.terms[found.first].is_constant():
        raise UnreadError(f"the order {claim.right} is not a power of {h}")
    return claim.left, found.first, claim.relation == "o"


def _largest_exponent(e: Expr) -> int:
    """Return a bound of the exponent of h in a power of h."""
    n = integer(e.args[1]) if e.op == "^" else None
    if n is not None:
        return abs(n)
    return sum(map(_largest_exponent, e.args)) if e.op in ("*", "+") else 1


def _known(jets: Jets, scheme: Expr, least: int) -> Series:
    """Return the terms of a scheme below h**least."""
    top = max(least, 1)
    for further in (1, 3, 0):
        try:
            jets.solve(top)
            found = jets.reduced(jets.read(scheme))
        except UnreadError:  # a denominator may begin with a higher power of h
            if not further:
                raise
            top += further
            continue
        if found.known >= least:
            return found.upto(least)
        top += least - found.known
    raise UnreadError("its terms cancel further than was looked at")


def _grows(jets: Jets, scheme: Expr) -> bool:
    """Return whether coefficients grow fast, by functions of values of functions."""
    trees = (scheme, *jets.equations.values(), *jets.definitions.values())
    nodes = (f for e in trees for f in functions(e))
    return bool(jets.rules) or any(any(functions(arg)) for f in nodes for arg in f.args[1:])


def _proved(jets: Jets, scheme: Expr, least: int, most: int) -> str:
    """Return for which functions and where an order is proved, and the leading error."""
    error = "no term of the error was found"
    for top in range(max(least, 1), most + 1):
        try:
            found = _known(jets, scheme, top)
        except UnreadError:  # too many terms: what is proved does not need them
            break
        if found.terms:
            error = f"the error is {_term(jets, found.terms[found.first], found.first)}"
            break
    free = sorted({v.name for v in jets.variables if v.orders} - set(jets.rules) - set(PERIODIC))
    trees = (scheme, *jets.equations.values(), *jets.definitions.values())
    who = [f"all smooth {', '.join(free)}"] if free else []
    who += [f"every solution {', '.join(sorted(jets.rules))}"] if jets.rules else []
    own = {jets.h, *jets.equations, *jets.definitions}
    fixed = sorted(frozenset().union(*map(symbols, trees)) - own)
    at = f" at each fixed {', '.join(fixed)}" if fixed else ""
    stages = ", with stages that stay bounded" if jets.implicit else ""
    defined = " where the denominators are not 0" if jets.divisors else ""
    where = f"for {' and '.join(who) or 'all values'}{at}{defined}{stages}"
    return f"{where}, by Taylor's theorem with remainder: {error}"


def _of_systems(scheme: Expr, statement: Statement, least: int) -> str:
    """Return whether the order holds for systems of equations too; empty if that is not known."""
    assert statement.path is not None
    jets = SystemJets(statement.path.name, statement.equations)
    try:
        found = _known(jets, scheme, least)
        if not found.terms:
            return "; also for systems of equations" if jets.has_trees else ""
        term = jets.spoken(found.terms[found.first])
    except UnreadError:
        return ""
    q = _power(symbol(jets.h), found.first)
    return f"; but for systems of equations the error is of order {q}: {term} does not cancel"


def _power(base: Expr, n: int) -> Expr:
    return ONE if n == 0 else power(base, number(n))


def _term(jets: Jets, coefficient: Polynomial, q: int) -> str:
    """Return the leading term of the error as text."""
    h = _power(symbol(jets.h), q)
    if len(coefficient) > SHOWN:
        return f"{h} times a polynomial of {len(coefficient)} terms in derivatives + …"
    used = [v for v in jets.behind(coefficient) if v.orders and v.name not in PERIODIC]
    short = {v: _index_name(jets, v) for v in used if not _is_plain(jets, v)}
    known = {jets.meaning(v): symbol(name) for v, name in short.items()}
    shown = str(multiply(h, replaced(jets.expression(coefficient), known)))
    places = {f"{v.name} at ({', '.join(map(str, jets.place(v)))})": None for v in short}
    return f"{shown} + …" + (f" (derivatives of {' and '.join(places)})" if places else "")


def _is_plain(jets: Jets, which: Variable) -> bool:
    return all(e.op in ("symbol", "number") for e in jets.place(which))


def _index_name(jets: Jets, which: Variable) -> str:
    """Return f_ty for the derivative of f(t, y) by t and y, at a point such as (t, y(t))."""
    letters = jets.letters(which)
    index = "".join(letter * n for letter, n in zip(letters, which.orders, strict=True))
    return f"{which.name}_{index}" if index else which.name


class _Counterexample:
    """Values of derivatives and parameters at which the leading error is not zero."""

    def __init__(self, jets: Jets, values: Mapping[Variable, Fraction]) -> None:
        self.jets = jets
        self.values = values

    @classmethod
    def of(cls, jets: Jets, lead: Polynomial, statement: Statement) -> _Counterexample | None:
        """Return a counterexample that satisfies the conditions, or None."""
        used = [v for p in (lead, *jets.divisors.values()) for v in jets.behind(p)]
        known = {*jets.divisors, *(Variable(name) for name in jets.constants)}
        behind = [v for v in dict.fromkeys(used) if v not in known and v.name not in PERIODIC]
        said = statement.given.names - {jets.h}
        if not _are_independent(jets, behind) or said & set(jets.equations):
            return None
        behind += [Variable(name) for name in sorted(said - {v.name for v in behind})]
        terms = [[k for k, n in enumerate(m) if n] for m in lead.monoms()]
        chosen_terms = min(terms, key=len)
        wanted = [jets.variables[k] for k in chosen_terms]
        wanted += [v for p in jets.divisors.values() for v in jets.behind(p)]
        needed = [v for v in dict.fromkeys(wanted) if v in behind]
        inside: list[dict[Variable, Fraction]] = [{}]
        if said:
            with ball_precision():
                points = list(statement.given.points(sorted(said), POINTS))
            inside += [{Variable(x): _fraction(value) for x, value in p.items()} for p in points]
        tried = (
            {v: Fraction(0 if any(v.orders) else rest) for v in behind}
            | dict(zip(needed, map(Fraction, chosen), strict=True))
            | point
            for point in inside
            for rest in (0, 1)
            for chosen in product(_VALUES, repeat=len(needed))
        )
        for values in islice(tried, TRIED):
            found = cls(jets, values)
            if found.differs(lead) and _satisfy(values, statement):
                return found
        return None

    def differs(self, lead: Polynomial) -> bool:
        """Return whether a coefficient is not zero here."""
        values = map(self._at, (lead, *self.jets.divisors.values()))
        return all(_holds((value, "!=", ZERO)) for value in values)

    def __str__(self) -> str:
        names = sorted({v.name for v in self.values if v.orders})
        shown = [part for name in names for part in self._of_function(name)]
        fixed = [f"{v.name} = {n}" for v, n in self.values.items() if not v.orders]
        return ", ".join(shown + fixed)

    def _of_function(self, name: str) -> Iterator[str]:
        """Yield a function as a polynomial, or the values with which a solution starts."""
        own = [v for v in self.values if v.name == name and v.orders]
        place = [self._at(p) for p in self.jets.bases[own[0]]]
        if name in self.jets.rules:
            for v in own:
                at = ", ".join(map(str, place))
                orders = ", ".join(map(str, v.orders))
                marks = "'" * v.orders[0] if len(v.orders) == 1 else f"^({orders})" * any(v.orders)
                if self.values[v] or not marks:
                    yield f"{name}{marks}({at}) = {self.values[v]}"
            return
        letters = self.jets.letters(own[0])
        steps = [symbol(x) - b for x, b in zip(letters, place, strict=True)]
        terms = [
            multiply(
                number(self.values[v] / prod(map(factorial, v.orders))),
                *(_power(step, n) for step, n in zip(steps, v.orders, strict=True)),
            )
            for v in own
            if self.values[v]
        ]
        yield f"{name}({', '.join(letters)}) = {add(*terms) if terms else ZERO}"

    def _at(self, p: Polynomial) -> Expr:
        """Return the number that a coefficient is here."""
        numbers = {
            f"v{k}": fmpq(*self.values[v].as_integer_ratio())
            for k, v in enumerate(self.jets.variables)
            if v in self.values
        }
        at = {v.name: number(n) for v, n in self.values.items() if not v.orders}
        known = {self.jets.meaning(v): number(n) for v, n in self.values.items() if v.orders}
        return substitute(replaced(self.jets.expression(p.subs(numbers)), known), at)


def _fraction(value: arb | fmpq) -> Fraction:
    """Return a number near a value."""
    if isinstance(value, fmpq):
        return Fraction(int(value.p), int(value.q))
    return Fraction(float(value.mid())).limit_denominator(100)


def _are_independent(jets: Jets, variables: Iterable[Variable]) -> bool:
    """Return whether derivatives at the points that occur can have any values.

    They can where every function occurs at one point, and solutions with all initial values exist:
    for ordinary differential equations, and for linear ones with constant coefficients.
    """
    places: dict[str, tuple[str, ...]] = {}
    for which in variables:
        if which.orders and places.setdefault(which.name, which.base) != which.base:
            return False
    ordinary = all(len(rule.names) == 1 for rule in jets.rules.values())
    return ordinary or all(map(jets.is_linear, jets.rules))


def _satisfy(values: Mapping[Variable, Fraction], statement: Statement) -> bool:
    """Return whether the conditions hold at these values of the parameters."""
    at = {v.name: number(n) for v, n in values.items() if not v.orders}
    links = statement.given.mapped(lambda e: substitute(e, at)).comparisons
    return all(map(_holds, links))


def _holds(link: Compared) -> bool:
    """Return whether a comparison of constants holds."""
    left, _, right = link
    plain = not (left.hidden or right.hidden or symbols(left) | symbols(right))
    return plain and constants_hold([link]) is not None
