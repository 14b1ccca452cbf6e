"""Hold every answer to what was asked: a region needs a constant on it, ``uniformly`` one for all.

The methods that decide claims along a path look at the end of the path. A claim may ask for more:
``sum(1/k, k, 1, n) == O(log(n)) as n -> oo on n >= 1`` for a constant that serves at n = 1 too,
where the right side is 0, and ``sin(a*x) == O(x) given a > 0 uniformly as x -> 0`` for one that
serves for all a. Whatever method decided, here its answer holds only if it says that it did that.
"""

from __future__ import annotations

from flint import fmpq

from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.path_regions import conditions_of, reach_of
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.claims import chained
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Compared
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


def as_asked(answer: Answer, comparison: Comparison, statement: Statement) -> Answer:
    """Return an answer that holds, or UNDECIDED where it does not give all that was asked for.

    Args:
        answer: what a method decided.
        comparison: the claim.
        statement: its conditions, and its path with the region that was asked for.
    """
    path = statement.path
    if not answer or path is None:
        return answer
    if path.region and not (answer.constant and answer.region == chained(path.region)):
        why = "the order holds near the end of the path, but no constant was found on the region"
        return Answer(Verdict.UNDECIDED, f"{why} {chained(path.region)}")
    if path.reach is not None and not (answer.constant and _covers(answer.region, statement)):
        why = "the order holds near the end of the path, but no constant was found on the region"
        found = f"; one was found on {answer.region}" if answer.constant and answer.region else ""
        return Answer(Verdict.UNDECIDED, f"{why} asked for{found}")
    if statement.uniformly and answer.uniform is not True:
        names = parameters(comparison, statement)
        if names:
            shown = ", ".join(names)
            why = f"it holds for each fixed {shown}, but no constant was found that serves for all"
            return Answer(Verdict.UNDECIDED, f"{why} {shown}")
    return answer


def parameters(comparison: Comparison, statement: Statement) -> list[str]:
    """Return the variables beside that of the path; none where equations determine all of them.

    An equation determines one variable, as ``y**3 + y == x`` determines y. One for an unknown
    function determines the function.
    """
    path = statement.path
    trees = [comparison.left, comparison.right, *comparison.differentiated, *statement.said]
    names = frozenset().union(*map(symbols, trees))
    if path is not None:
        names -= {path.name, *path.together}
        names |= symbols(path.point) if path.point is not None else frozenset()
    plain = [pair for pair in statement.equations if not any(map(_is_of_functions, pair))]
    return [] if len(names) <= len(plain) else sorted(names)


def _is_of_functions(e: Expr) -> bool:
    return any(node.args[0].args[0] != FACTORIAL for node in functions(e))


def reach_on(region: str, path: Path) -> fmpq | None:
    """Return how far from the end of its path a region of an answer reaches; None if not all ways.

    Example:
        >>> from tresym.reals.language.paths import read_path
        >>> reach_on("0 < |x| <= 1/2", read_path("x -> 0"))
        1/2

    Raises:
        InputError: the text is no region of this path.
    """
    if path.point is None and region == f"{path.name} > 0" and path.sides == (1,):
        return None
    return reach_of(_links(region, path)[0], path)


def _links(region: str, path: Path) -> tuple[list[Compared], list[Compared]]:
    """Return the conditions of a region on the variable of the path, and the others."""
    links = conditions_of(region)
    on = [link for link in links if path.name in symbols(link[0]) | symbols(link[2])]
    return on, [link for link in links if link not in on]


def _covers(region: str | None, statement: Statement) -> bool:
    """Return whether the region of an answer holds all points that were asked for."""
    path = statement.path
    if region is None or path is None or path.reach is None:
        return False
    try:
        reach = reach_on(region, path)
        others = _links(region, path)[1] if reach is not None else []
    except InputError:
        return False
    said = statement.given.comparisons
    return (reach is None or reach >= path.reach) and all(link in said for link in others)
