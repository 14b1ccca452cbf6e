"""Decide claims along a path about functions of which only an order is known.

Example: ``log(y) == log(x) + O(1/x) given y == x + O(1) as x -> oo``. The claim is meant for every
function y(x) with y = x + O(1). The error is carried through the claim
(:mod:`tresym.asymptotics.approximation`): log y is log x + O(1/x) for every such function.

A claim is refuted by one function of this kind, such as y = x + 1, with which it is explicit. The
premise ``y == x + o(g)`` is tried with g/log x and the like, and ``y ~ x`` means y = x + o(x).

Source: N. G. de Bruijn, *Asymptotic Methods in Analysis*, 1958, sections 1.2 and 1.3.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import islice, product

from tresym.asymptotics.approximation import size
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.asymptotics.lemma_claims import decide_with_expansions
from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    apply,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import without_order
from tresym.reals.language.paths import Path
from tresym.reals.verdict import Verdict

LEMMA = "orders carried through the expression (de Bruijn 1958, chapter 1)"
MOST_TRIED = 24
"""Functions with which a refutation is looked for."""


class Premise(Expansion):
    """An unknown with y = A + O(g), or o(g), which is assumed."""

    lemma = LEMMA

    def __init__(self, main: Expr, error: Expr, small: bool) -> None:
        """Assume that the unknown is ``main`` + O(``error``), or o(``error``)."""
        self.main, self.error, self.is_little_o = main, error, small

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the approximation; there is no longer one."""
        return (self.main, self.error) if order == 1 else None

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Nothing is to be proved; the constant is not known."""
        return Bound()


class _OpenError(Exception):
    """The premises are of a kind that is not supported; the text says what to write."""


def decide_under_premises(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim along a path under premises such as ``y == x + O(1)``.

    Args:
        claim: the comparison.
        statement: its conditions, premises and path.
        decided: decides explicit claims.
    """
    try:
        path = statement.path
        if path is None or path.together or path.expression is not None:
            raise _OpenError("a condition with O or ~ needs a path of one variable")
        sides = [replace(path, sides=(side,)) for side in path.sides]
        answers = []
        for side in sides:
            answers.append(_on_one_side(claim, replace(statement, path=side), side, decided))
            if answers[-1].verdict is Verdict.REFUTED:
                break
        return worst(answers)
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))


def _on_one_side(claim: Comparison, statement: Statement, path: Path, decided: Decide) -> Answer:
    if claim.derivatives:
        raise _OpenError(
            "an order must not be differentiated: a bound of y says nothing of its derivative"
        )
    if len(statement.premises) < len(statement.equations):
        raise _OpenError("equations beside conditions with O or ~ are not supported")
    names = [_unknown(pair, path) for pair in statement.premises]
    links = statement.given.comparisons
    fixed = Given(tuple(x for x in links if not {*names} & (symbols(x[0]) | symbols(x[2]))))
    if path.name in fixed.names or any(name in statement.integers for name in names):
        raise _OpenError(
            f"conditions on {path.name} beside conditions with O or ~ are not supported"
        )
    taken = frozenset().union(*map(symbols, (claim.left, claim.right)))
    end = End(path.name, path.point, path.sides[0], fixed, taken)
    known: dict[Expr, Premise] = {}
    for name, pair in zip(names, statement.premises, strict=True):
        found = _premise(name, pair, {*names}, end)
        old = known.get(symbol(name))
        known[symbol(name)] = found if old is None else _both(old, found, end)
    rest = replace(statement, equations=(), given=fixed)
    answer = decide_with_expansions(claim, rest, decided, known)
    if answer and len(fixed.comparisons) < len(links):
        choices = [[(node, f) for f in _functions(p, end)] for node, p in known.items()]
        tried = islice(product(*choices), MOST_TRIED)
        if not any(_satisfied(statement, rest, chosen, end, decided) for chosen in tried):
            raise _OpenError(
                "no function was found that satisfies the conditions, so there may be nothing to "
                "prove"
            )
    if answer.verdict is not Verdict.UNDECIDED:
        return replace(answer, region=None, constant=None)
    against = _refuted(claim, statement, rest, known, end, decided)
    return answer if against is None else against


def _unknown(pair: tuple[Expr, Expr], path: Path) -> str:
    """Return the variable of which a premise speaks."""
    left = pair[0]
    if left.op == "symbol" and left.args[0] != path.name:
        return str(left.args[0])
    raise _OpenError(
        "a condition with O or ~ must have one variable on its left side, as in y == x + O(1)"
    )


def _premise(name: str, pair: tuple[Expr, Expr], names: set[str], end: End) -> Premise:
    right = pair[1]
    main = tidied(without_order(right))
    terms = right.args if right.op == "+" else (right,)
    (order,) = (term for term in terms if term.op in ("O", "o"))
    gauge = order.args[0]
    if not elementary(main, gauge):
        raise _OpenError(f"the condition on {name} must be explicit")
    if names & (symbols(main) | symbols(gauge)):
        raise _OpenError(f"the condition on {name} must not contain another unknown")
    if gauge == ZERO:
        raise _OpenError(f"O(0) in the condition on {name} says that it is equal: write ==")
    return Premise(main, size(gauge, end), order.op == "o")


def _both(first: Premise, second: Premise, end: End) -> Premise:
    """Return the stronger of two premises on the same unknown."""
    if tidied(first.main - second.main) != ZERO:
        raise _OpenError("two different conditions with O or ~ on one unknown are not supported")
    return second if end.limit(second.error / first.error) == ZERO else first


def _refuted(
    claim: Comparison,
    statement: Statement,
    rest: Statement,
    known: dict[Expr, Premise],
    end: End,
    decided: Decide,
) -> Answer | None:
    """Return a refutation by functions that satisfy the premises, or None."""
    choices = [[(node, f) for f in _functions(premise, end)] for node, premise in known.items()]
    for chosen in islice(product(*choices), MOST_TRIED):
        if not _satisfied(statement, rest, chosen, end, decided):
            continue
        values = {str(node.args[0]): f for node, f in chosen}
        put = partial(substitute, mapping=values)
        answer = decided(claim.mapped(put), rest)
        if answer.verdict is Verdict.REFUTED:
            shown = ", ".join(f"{name} = {value}" for name, value in values.items())
            texts = {name: str(value) for name, value in values.items()}
            why = f"it fails for {shown}, which satisfies the conditions: {answer.why}"
            witness = dict(answer.witness or {}) | texts
            return replace(answer, why=why, witness=witness, values=None, lemma=LEMMA)
    return None


def _satisfied(
    statement: Statement,
    rest: Statement,
    chosen: tuple[tuple[Expr, Expr], ...],
    end: End,
    decided: Decide,
) -> bool:
    """Return whether functions in place of the unknowns satisfy the conditions near the end."""
    put = partial(substitute, mapping={str(node.args[0]): f for node, f in chosen})
    links = statement.given.mapped(put).comparisons
    return all(
        decided(Comparison(*link), rest) for link in links if link not in rest.given.comparisons
    )


def _functions(premise: Premise, end: End) -> Iterator[Expr]:
    """Yield functions that satisfy a premise, the likeliest counterexamples first."""
    main, error = premise.main, premise.error
    if not premise.is_little_o:
        yield from (main + number(c) * error for c in (1, -1, 3, 0))
        return
    x = symbol(end.name)
    large = end.side * x if end.point is None else 1 / (end.side * (x - end.point))
    for slow in (apply("log", large), apply("log", apply("log", large)), sqrt(large)):
        yield from (main + error / slow, main - error / slow)
    yield main
