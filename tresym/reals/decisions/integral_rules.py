"""Rules for integrals that hold whatever their values are.

*Leibniz's rule*, for derivatives of integrals with variable ends and parameters: d/dp ∫ f dt
from a to b is f(b) b′ − f(a) a′ + ∫ ∂f/∂p dt where f is analytic at all t from a to b and all p in
question, which is shown, as are a and b; where a value of p is given, at that one, and so near it.
Functions left unknown are smooth. The claim is then decided with the value of the derivative put
in, at all points of the conditions.

*Linearity, and intervals joined.* An integrand is a sum of terms c g, with c independent of the
variable of integration. If each g is proved to be smooth on the interval, ∫ c g from a to b is
c (G(b) − G(a)) for an antiderivative G of g, and a new variable replaces each value of each G. A
claim that holds for all values of these variables is proved. The antiderivative of f′ is f, that of
an arbitrary function f is another arbitrary function. A claim that fails for some values of the
variables is not thereby refuted.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, outermost, under_the_integral
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    bind,
    factors_in,
    fresh,
    instantiate,
    multiply,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.signs.closure import has_inside, is_regular
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict


class _OpenError(Exception):
    """The rule is not shown to apply; the text says why."""


def decide_by_leibniz(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with derivatives of integrals, by differentiation under the integral sign.

    Args:
        decided: the procedure for claims without derivatives of integrals.
    """
    given = statement.given
    at_points = _points(statement.equations)
    if statement.path is not None or at_points is None or statement.integers:
        why = (
            "derivatives of integrals are supported only under conditions that are inequalities or "
            "give variables values"
        )
        return Answer(Verdict.UNDECIDED, why)
    if not (is_regular(given) and has_inside(given)):
        return Answer(
            Verdict.UNDECIDED,
            (
                "the conditions could not be shown to have interior points, "
                "where a derivative makes sense"
            ),
        )
    try:
        there = given & at_points
        left, right = (_worked_out(side, there) for side in (claim.left, claim.right))
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))
    kept = tuple(d for d in claim.derivatives if not _integrals(d.function))
    answer = decided(Comparison(left, claim.relation, right, kept), statement)
    return replace(
        answer, why=f"by Leibniz's rule for differentiation under the integral sign; {answer.why}"
    )


def _points(equations: tuple[tuple[Expr, Expr], ...]) -> Given | None:
    """The conditions of equations that give variables values, as those near the values; or None."""
    given: set[str] = set()
    for x, value in equations:
        if x.op != "symbol" or not elementary(value) or str(x) in given:
            return None
        given.add(str(x))
    if any(symbols(value) & given for _, value in equations):
        return None
    return Given(tuple((x, sign, value) for x, value in equations for sign in (">=", "<=")))


def _integrals(e: Expr) -> list[Expr]:
    return [node for node in outermost(e) if node.op != "unknown"]


def _worked_out(e: Expr, given: Given) -> Expr:
    """``e`` with the derivatives of integrals in it worked out."""
    if e.op in LEAVES or not e.hidden:
        return e
    if e.op != "derivative":
        known = e.op in ("unknown", "integral")
        return e if known else rebuild(e, tuple(_worked_out(arg, given) for arg in e.args))
    place = e.args[1]
    if place.op != "symbol" or symbols(place) & symbols(e.args[0]):
        raise _OpenError(
            "the derivative of an integral at a point is not supported: "
            "differentiate with respect to a variable"
        )
    body = _worked_out(instantiate(e.args[0], (place,)), given)
    return _slope(body, str(place), given)


def _slope(body: Expr, name: str, given: Given) -> Expr:
    """The derivative of an expression with integrals, by the chain rule."""
    nodes = [node for node in dict.fromkeys(_integrals(body)) if name in symbols(node)]
    if any(node.op != "integral" for node in nodes):
        raise _OpenError("derivatives of sums and limits are not supported")
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    plain = replaced(body, marks)
    back = {str(mark): node for node, mark in marks.items()}
    terms = [differentiate(plain, name)]
    for node, mark in marks.items():
        terms.append(differentiate(plain, str(mark)) * _rule(node, name, given))
    return substitute(add(*terms), back)


def _rule(node: Expr, name: str, given: Given) -> Expr:
    """Leibniz's rule for one integral."""
    (t,), f = opened(node, given.names | {name})
    low, high = node.args[1:]
    if not elementary(low, high) or _integrals(f) or "oo" in symbols(low) | symbols(high):
        raise _OpenError(
            f"{node}: its limits and its integrand must be finite elementary expressions"
        )
    if any(continuous_on(end, given, proof) is not None for end in (low, high)):
        raise _OpenError(f"{node}: its limits could not be shown to be differentiable")
    regions = between(t, low, high, given)
    if not (is_smooth(f, Given()) or all(is_smooth(f, inside) for inside in regions)):
        raise _OpenError(
            f"{node}: its integrand could not be shown to be smooth from {low} to {high}"
        )
    return under_the_integral(node, name)


def between(t: str, low: Expr, high: Expr, given: Given) -> list[Given]:
    """The conditions, and that t is from one end to the other, in each order that may be."""
    x, regions = symbol(t), []
    for a, b in ((low, high), (high, low)):
        if sign(b - a, given, "<") != "-":
            regions.append(given & Given(((b, ">=", a), (x, ">=", a), (x, "<=", b))))
    return regions


def is_smooth(f: Expr, given: Given) -> bool:
    """Whether ``f`` is shown to be smooth, for all smooth functions left unknown in it."""
    while found := list(dict.fromkeys(functions(f))):
        inner = [arg for node in found for arg in node.args[1:]]
        marks: dict[Expr, Expr] = {}
        for node in found:
            taken = symbols(f) | given.names | {str(mark) for mark in marks.values()}
            marks[node] = symbol(fresh("u", taken))
        f = add(replaced(f, marks), *(arg * symbol(fresh("v", symbols(f))) for arg in inner))
    return continuous_on(f, given, proof) is None


# Linearity, and intervals joined


@dataclass
class Antiderivatives:
    """Values of antiderivatives, as they are met.

    Attributes:
        known: the integrand as a body, the point, and the variable for the value there.
        any_values: whether none of them stands for the value of an integral that is not worked out.
    """

    given: Given
    known: list[tuple[Expr, Expr, Expr]] = field(default_factory=list)
    any_values: bool = True

    def put_in(self, e: Expr) -> Expr | None:
        """``e`` with variables for the values of its integrals; None where one is not smooth."""
        values: dict[Expr, Expr] = {}
        for node in dict.fromkeys(outermost(e)):
            if node.op == "unknown":
                continue
            value = self._integral(node) if node.op == "integral" else None
            if value is None:
                return None
            values[node] = value
        return replaced(e, values)

    def _integral(self, node: Expr) -> Expr | None:
        (t,), f = opened(node, self.given.names)
        low, high = node.args[1:]
        if not elementary(low, high) or "oo" in symbols(low) | symbols(high):
            return None
        whole, values = collected(f), []
        for term in whole.args if whole.op == "+" else (whole,):
            factors = factors_in(term)
            rest = [factor for factor in factors if t in symbols(factor)]
            scale = multiply(*(factor for factor in factors if t not in symbols(factor)))
            g = multiply(*rest) if rest else ONE
            if any(inner.op != "unknown" for inner in outermost(g, scale)):
                return None
            regions = between(t, low, high, self.given)
            if not (is_smooth(g, Given()) or all(is_smooth(g, inside) for inside in regions)):
                return None
            values.append(scale * (self._at(g, t, high) - self._at(g, t, low)))
        return add(*values)

    def _at(self, g: Expr, t: str, point: Expr) -> Expr:
        """The value of an antiderivative of ``g``, a function of ``t``, at the point."""
        if g == ONE:
            return point
        slope = differentiate(g.args[1], t) if g.op == "unknown" and len(g.args) == 2 else ZERO
        if slope.op == "number" and slope != ZERO:  # of f(c t + d)
            name, (order,) = g.args[0].args
            place = substitute(g.args[1], {t: point})
            if order:
                return unknown(name, (place,), (order - 1,)) / slope
            self.any_values = False  # a point says nothing of the integral of f
            return unknown(f"integral_{name}", (place,)) / slope
        self.any_values = False
        body = bind(g, (t,))
        for other, end, variable in self.known:
            is_there = end == point or _are_equal(end, point)
            if is_there and (other == body or _are_equal(instantiate(other, (symbol(t),)), g)):
                return variable
        self.known.append((body, point, symbol(f"[integral of {g} by {t} at {point}]")))
        return self.known[-1][2]


def _are_equal(one: Expr, other: Expr) -> bool:
    return elementary(one, other) and decide(one, other).verdict is Verdict.PROVED
