"""Solve two sequences that a linear recurrence determines together.

Example: the solutions of x² − 2y² = 1, ``x(n+1) == 3*x(n) + 4*y(n), y(n+1) == 2*x(n) + 3*y(n)``.

With v(n + 1) = M v(n) + c, trace t and determinant d of M, Cayley and Hamilton's theorem gives
v(n + 2) = t v(n + 1) − d v(n) + M c + c − t c, a recurrence of second order for each of the two.
What is claimed of them is claimed of their explicit forms.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import islice

from flint import fmpq

from tresym.asymptotics.linear_recurrences import LINEAR, LOOKED_AT, Solved, sequence_nodes
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import decided_at, tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    integer,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.verdict import Verdict


def decide_system(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide a claim about two sequences, or return None where the conditions are no such system.

    Args:
        claim: the comparison.
        statement: its conditions: two recurrences, two first values, and n integer or n -> oo.
        decided: decides explicit claims.
    """
    nodes = set(sequence_nodes(claim))
    path = statement.path
    indices = {name for node in nodes for e in node.args[1:] for name in symbols(e)}
    if len(indices) != 1 or claim.derivatives or len(statement.equations) != 4:
        return None
    (n,) = indices
    system = _system(statement, n)
    if system is None or not {node.args[0] for node in nodes} <= system.keys():
        return None
    sequence = next(iter(system.values()))
    shifts = {
        node: integer(tidied(normal_form(node.args[1] - symbol(n), Given()))) for node in nodes
    }
    if None in shifts.values():
        return None
    forms = {name: one.closed() for name, one in system.items()}
    if None in forms.values():
        return Answer(Verdict.UNDECIDED, "the roots of the system are not supported")
    put = {
        node: tidied(substitute(forms[node.args[0]] or ZERO, {n: node.args[1]})) for node in nodes
    }
    explicit = claim.mapped(partial(replaced, known=put))
    rest = replace(statement, equations=())
    if path is None:
        least = statement.given.box[n].first_integer() if n in statement.given.box else None
        if n not in statement.integers or least is None:
            return None
        if least + min(0, *(k for k in shifts.values() if k is not None)) < sequence.first:
            return Answer(Verdict.UNDECIDED, f"values before {n} = {sequence.first} are not given")
        if least + sequence.lowest > sequence.first:
            return Answer(Verdict.UNDECIDED, f"the recurrence for {n} >= {least} does not reach it")
        found = _refuted(claim, rest, system, n, least, decided)
        if found is not None:
            return found
    elif path.name != n or n in statement.given.names:
        return None
    else:
        rest = replace(rest, integers=tuple(dict.fromkeys((*statement.integers, n))))
    answer = decided(explicit, rest)
    said = "; ".join(f"{node} = {form}" for node, form in put.items())
    return replace(answer, why=f"{said}: {answer.why}", lemma=LINEAR, region=None, constant=None)


def _refuted(
    claim: Comparison,
    statement: Statement,
    system: dict[Expr, Solved],
    n: str,
    least: int,
    decided: Decide,
) -> Answer | None:
    """Return a refutation at one of the first values of n, which are computed."""
    first = next(iter(system.values())).first
    count = least - first + LOOKED_AT + 6
    values = {name: list(islice(one.terms(), count)) for name, one in system.items()}

    def called(name: Expr, k: int) -> Expr:
        return Expr("unknown", (name, number(k)))

    for m in range(least, least + LOOKED_AT):
        at = {}
        for node in sequence_nodes(claim):
            k = integer(tidied(normal_form(substitute(node.args[1], {n: number(m)}), Given())))
            if k is None or not 0 <= k - first < count:
                return None
            at[node] = number(values[node.args[0]][k - first])
        explicit = claim.mapped(partial(replaced, known=at))
        answer, _ = decided_at([{n: number(m)}], explicit, statement, decided)
        if answer is not None:
            low = m + next(iter(system.values())).lowest
            used = {
                first,
                low,
                low + 1,
                *(integer(substitute(e.args[1], {n: number(m)})) for e in at),
            }
            shown = {
                str(called(name, k)): str(number(row[k - first]))
                for name, row in values.items()
                for k in sorted(k for k in used if k is not None and 0 <= k - first < count)
            }
            return replace(answer, witness=shown | dict(answer.witness or {}), lemma=LINEAR)
    return None


def _system(statement: Statement, n: str) -> dict[Expr, Solved] | None:
    """Return both sequences, each with its recurrence of second order."""
    rows: dict[Expr, tuple[dict[Expr, fmpq], fmpq, int]] = {}
    starts: dict[Expr, tuple[int, fmpq]] = {}
    for left, right in statement.equations:
        nodes = {node for e in (left, right) for node in functions(e)}
        if any(len(m.args) != 2 for m in nodes):
            return None
        if n in symbols(left) | symbols(right):
            row = _row(left, right, nodes, n)
            if row is None or row[0] in rows:
                return None
            rows[row[0]] = row[1:]
            continue
        value = tidied(right if left in nodes else left)
        if len(nodes) != 1 or value.op != "number" or not nodes & {left, right}:
            return None
        (node,) = nodes
        k = integer(tidied(node.args[1]))
        if k is None or node.args[0] in starts:
            return None
        starts[node.args[0]] = k, value.args[0]
    if len(rows) != 2 or rows.keys() != starts.keys():
        return None
    one, two = rows
    lows = {low for _, _, low in rows.values()}
    firsts = {k for k, _ in starts.values()}
    if len(lows) != 1 or len(firsts) != 1:
        return None
    if any(set(c) - {one, two} for c, _, _ in rows.values()):
        return None
    matrix = {x: [rows[x][0].get(y, fmpq(0)) for y in (one, two)] for x in rows}
    trace = matrix[one][0] + matrix[two][1]
    determinant = matrix[one][0] * matrix[two][1] - matrix[one][1] * matrix[two][0]
    if determinant == 0:
        return None
    constants = [rows[x][1] for x in (one, two)]
    first_values = [starts[x][1] for x in (one, two)]
    found = {}
    for x in (one, two):
        moved = sum((m * c for m, c in zip(matrix[x], constants, strict=True)), fmpq(0))
        step = sum((m * v for m, v in zip(matrix[x], first_values, strict=True)), rows[x][1])
        constant = moved + rows[x][1] - trace * rows[x][1]
        (first,), (low,) = firsts, lows
        values = (starts[x][1], step)
        found[x] = Solved(x, n, first, low, (-determinant, trace), constant, values)
    return found


def _row(
    left: Expr, right: Expr, nodes: set[Expr], n: str
) -> tuple[Expr, dict[Expr, fmpq], fmpq, int] | None:
    """Return x, its coefficients of x(n) and y(n), the constant, and the lower shift."""
    places = {m: integer(tidied(normal_form(m.args[1] - symbol(n), Given()))) for m in nodes}
    known = [k for k in places.values() if k is not None]
    if len(known) != len(nodes):
        return None
    high = [m for m, k in places.items() if k == max(known)]
    if len(high) != 1 or {k for m, k in places.items() if m != high[0]} != {max(known) - 1}:
        return None
    marks = {m: symbol(f"[{i}]") for i, m in enumerate(nodes)}
    whole = replaced(left - right, marks)
    names = {str(mark.args[0]) for mark in marks.values()}
    if not elementary(whole) or not symbols(whole) <= names:
        return None
    slopes = {
        m: tidied(normal_form(differentiate(whole, str(mark.args[0])), Given()))
        for m, mark in marks.items()
    }
    rest = tidied(normal_form(substitute(whole, dict.fromkeys(names, ZERO)), Given()))
    if rest.op != "number" or any(e.op != "number" for e in slopes.values()):
        return None
    lead = slopes.pop(high[0]).args[0]
    if lead == 0:
        return None
    coefficients = {m.args[0]: -e.args[0] / lead for m, e in slopes.items()}
    return high[0].args[0], coefficients, -rest.args[0] / lead, max(known) - 1
