"""From a claim that was read to the statement that is decided: conditions, region and path fixed.

:mod:`tresym.reals.language.claims` reads the claim. Here its conditions become ranges, its region
a bound on the small parameter, and on a path such as ``a*b -> oo`` a variable is put for the
product, which needs the sign of the factor.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.path_regions import reach_of, reaches_end
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import limit_of as value_of_limit
from tresym.reals.language import expression
from tresym.reals.language.binders import derivative, elementary, outermost
from tresym.reals.language.claims import NO_CHAIN, Written, parts_of, read_claim
from tresym.reals.language.comparisons import (
    LIMIT,
    ORDERS,
    Comparison,
    comparison_of,
    is_order,
    limit_of,
    spread,
)
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    number,
    opened,
    replaced,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.paths import Path, ending
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign as sign_of
from tresym.reals.verdict import Verdict

UNIFORM = "uniformly belongs to an order with a path: f == g + O(h) as x -> 0"


def read(claim: Any, given: Any = "", path: str | None = None) -> Statement:
    """Read a claim with its conditions and its path.

    Args:
        claim: text, LaTeX or a SymPy relation. Text may end in ``given CONDITIONS`` and
            ``as PATH``.
        given: text, LaTeX, SymPy relations, or a :class:`~tresym.reals.domain.conditions.Given`.
        path: such as ``"x -> 0+"``.

    Raises:
        InputError: the input cannot be read; the message is one line and says what to write.
    """
    written = read_claim(claim, given, path)
    text = parts_of(claim)[0] if isinstance(claim, str) else str(claim)
    return _checked(_stated(written, text))


def stated(
    parts: Iterable[Compared],
    given: Iterable[Compared] = (),
    path: Path | None = None,
    uniformly: bool = False,
) -> Statement:
    """Return the statement of a claim whose sides are expressions already.

    Args:
        parts: the comparisons; an order is written ``f == g + O(h)``.
        given: the conditions.
        path: where it is claimed.
        uniformly: whether one constant is asked for all values of the parameters.

    Raises:
        InputError: the parts do not belong together.
    """
    return statement_of(Written(tuple(parts), tuple(given), path, (), uniformly))


def statement_of(written: Written) -> Statement:
    """Return the statement of a claim that is written in the grammar already.

    Raises:
        InputError: its parts do not belong together.
    """
    return _checked(_stated(written, str(written)))


def _on_region(path: Path, on: tuple[Compared, ...]) -> Path:
    """Return the path with the region for which a constant is asked."""
    try:
        return replace(path, reach=reach_of(on, path))
    except InputError:
        if not reaches_end(on, path):
            raise
    return replace(path, region=tuple(on))


def _stated(written: Written, text: str) -> Statement:
    """What is decided of what is written."""
    parts, said, path, on, uniformly = written
    if path is None and not any(link[1] in (*ORDERS, LIMIT) for link in parts):
        said, on = (*said, *on), ()  # where a bound holds is a condition
    if path is None:
        parts, said = _with_slopes_at_points(parts, said)
    asked = uniformly
    if uniformly and path is None:
        raise InputError(UNIFORM)
    if path is not None and path.expression is not None:
        whole = path
        parts, said, path = _along_expression(parts, said, path)
        # All variables move along such a path together, so that one constant must serve.
        uniformly = bool({n for link in parts for e in link[::2] for n in symbols(e)} - {path.name})
        if uniformly and not is_order(parts):
            raise InputError(
                f"the path {whole} is supported for orders with a constant, f == g + O(h)"
            )
    if on:
        if path is None or not is_order(parts):
            raise InputError("on REGION belongs to an order with a path: f == g + O(h) as x -> 0")
        path = _on_region(path, on)
    given = Given(tuple(link for link in said if link[1] not in ("==", "in"))).unfolded()
    equations = tuple((left, spread(right)) for left, relation, right in said if relation == "==")
    closed = sum(relation in (">=", "<=") for _, relation, _ in said) > 1
    equations += tuple(
        (symbol(name), number(where.low))
        for name, where in (given.box.items() if closed else ())
        if where.low is not None and where.low == where.high
        if not (where.low_open or where.high_open)
    )
    integers = tuple(dict.fromkeys(str(link[0]) for link in said if link[1] == "in"))
    parts = tuple(_with_limits_worked_out(part, given) for part in parts)
    if len(parts) == 1 and any(side.op == "limit" for side in parts[0][::2]):
        comparison, path = limit_of(*parts[0], path)
        comparisons: tuple[Comparison, ...] = (comparison,)
    else:
        comparisons = tuple(comparison_of(*part) for part in parts)
    _need_apart(comparisons, said)
    found = Statement(comparisons, given, path, text, str(written), equations, integers, uniformly)
    if asked and not is_order(parts):
        tending = all(c.relation in ("o", "->") for c in comparisons)
        if not (tending and found.has_initial_values):
            raise InputError(UNIFORM)
    return found


def _with_limits_worked_out(part: Compared, given: Given) -> Compared:
    """Put values for the limits of a comparison, but for a single one that stands alone."""
    left, relation, right = part
    nodes = [node for node in outermost(left, right) if node.op == "limit"]
    lone = next((side for side in (left, right) if side.op == "limit"), None)
    if not nodes or {*nodes} == {lone} or relation not in ("==", "<", "<=", ">", ">=", "!="):
        return part
    values = {node: value for node in nodes if (value := _limit(node, given)) is not None}
    if lone is not None and {*nodes} - {lone} <= values.keys():
        values.pop(lone, None)
    return replaced(left, values), relation, replaced(right, values)


def _limit(node: Expr, given: Given) -> Expr | None:
    """Return the value of a limit, the same from both sides; None if it is not computed."""
    (name,), body = opened(node, symbols(node))
    path = ending(name, node.args[1], {1: "+", -1: "-"}.get(int(node.args[2].args[0].p), ""))
    found = {value_of_limit(body, name, path.point, side, given) for side in path.sides}
    return found.pop() if len(found) == 1 else None


def _with_slopes_at_points(
    parts: tuple[Compared, ...], said: tuple[Compared, ...]
) -> tuple[tuple[Compared, ...], tuple[Compared, ...]]:
    """Put a variable with a value for the point at which the value of a derivative is written.

    ``at(diff(x**2, x), x, 3) == 6`` is ``diff(y**2, y) == 6 given y == 3``.
    """
    sides = [side for link in parts for side in link[::2]]
    nodes = dict.fromkeys(filter(_is_slope_at_point, outermost(*sides)))
    taken = {n for link in (*parts, *said) for e in link[::2] for n in symbols(e)}
    put: dict[Expr, Expr] = {}
    values: list[Compared] = []
    for node in nodes:
        names = []
        for name in node.names:
            names.append(expression.fresh(name, taken))
            taken.add(names[-1])
        body = expression.instantiate(node.args[0], tuple(map(symbol, names)))
        put[node] = derivative(body, names[0]) if node.op == "derivative" else body
        values += [(symbol(n), "==", v) for n, v in zip(names, node.args[1:], strict=True)]
    if not put:
        return parts, said
    changed = tuple(
        (expression.replaced(x, put), sign, expression.replaced(y, put)) for x, sign, y in parts
    )
    return changed, (*said, *values)


def _is_slope_at_point(node: Expr) -> bool:
    """Whether it is the value of a derivative at a point that is no variable."""
    if node.loose or not elementary(*node.args[1:]):
        return False
    if node.op == "derivative":
        return node.args[1].op != "symbol"
    return node.op == "at" and any(e.op == "derivative" for e in outermost(node.args[0]))


def _need_apart(comparisons: Iterable[Comparison], said: Iterable[Compared]) -> None:
    """That no letter names a variable and a function, or functions of several arities."""
    trees = [side for c in comparisons for side in (c.left, c.right)]
    trees += [side for link in said for side in link[::2]]
    heads = {node.args[0].args[0]: len(node.args) for e in trees for node in functions(e)}
    for e in trees:
        for name in symbols(e) & heads.keys():
            raise InputError(
                f"{name} is used both as a function and as a variable; for a "
                f"product write {name}*(…)"
            )
        for node in functions(e):
            if len(node.args) != heads[node.args[0].args[0]]:
                raise InputError(
                    f"{node.args[0].args[0]} is used with different numbers of arguments"
                )


def _along_expression(
    parts: tuple[Compared, ...], said: tuple[Compared, ...], path: Path
) -> tuple[tuple[Compared, ...], tuple[Compared, ...], Path]:
    """Put s/b for a in a claim as a*b -> oo, so that s is the variable that tends to oo.

    The variable that is eliminated is the first one without an upper bound by a constant.
    """
    assert path.expression is not None
    given = Given(tuple(link for link in said if link[1] not in ("==", "in")))
    taken = {n for left, _, right in (*parts, *said) for n in symbols(left) | symbols(right)}
    for name in sorted(symbols(path.expression)):
        factor = differentiate(path.expression, name)
        bounded = name in given.box and given.box[name].high is not None
        rest = expression.substitute(path.expression, {name: ZERO})
        whole = decide(rest, ZERO, given).verdict is Verdict.PROVED
        if bounded or name in symbols(factor) or not whole or sign_of(factor, given, ">") != "+":
            continue
        s = expression.fresh("s", taken)
        put = {name: symbol(s) / factor}

        def change(link: Compared, put: dict[str, Expr] = put) -> Compared:
            left, relation, right = (
                expression.substitute(link[0], put),
                link[1],
                expression.substitute(link[2], put),
            )
            return left, relation, right

        moved = tuple(map(change, parts)), tuple(map(change, said))
        return *moved, replace(path, name=s)
    raise InputError(
        f"the path {path} is supported if {path.expression} is a variable times a positive factor"
    )


def _checked(statement: Statement) -> Statement:
    """The statement, if its parts belong together."""
    kinds = [c.relation for c in statement.comparisons]
    near = [kind for kind in kinds if kind in (*ORDERS, LIMIT)]
    if near and len(kinds) > 1:
        raise InputError(NO_CHAIN)
    path = statement.path
    if path is None and statement.premises:
        raise InputError("a condition with O or ~ needs a path, such as --as 'x -> oo'")
    if path is None:
        free = bool(near) and near[0] != LIMIT and _without_path(statement)
        if free and near[0] not in ("O", "Theta"):
            raise InputError(
                f"{near[0]} speaks of a limit and needs its path, such as --as 'x -> 0+'; for all "
                "values of the parameters write O or Theta"
            )
        if near and not free:
            raise InputError("an order claim needs its path, such as --as 'x -> 0+'")
        return statement
    if not near and "==" in kinds:
        raise InputError(
            "a path is only for O, o, ~, -> and inequalities; give an equation conditions instead"
        )
    whole = path.name in statement.integers and path.point is not None
    if whole:
        raise InputError(f"{path.name} is an integer, so its path must end at oo or -oo")
    said = [*statement.given.names]
    said += [name for sides in statement.equations for e in sides for name in symbols(e)]
    free = statement.implicit or path.expression is not None
    if path.name in said and not free:
        raise InputError(
            f"leave out the conditions on {path.name}: the path says where the claim holds"
        )
    return statement


def _without_path(statement: Statement) -> bool:
    """Return whether an order without a path is one for all values of its variables.

    It is if something is said of every variable, or if there are several: with one variable of
    which nothing is said a path was forgotten, as in ``sin(x) == x + O(x**3)``.
    """
    (claim,) = statement.comparisons
    names = symbols(claim.left) | symbols(claim.right)
    return len(names) > 1 or (bool(names) and names <= statement.given.names)
