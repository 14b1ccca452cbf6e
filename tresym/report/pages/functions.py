"""Write the reference of all functions, from their rows in the table of functions."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from flint import arb, fmpq

from tresym.reals.domain.operation_domains import needs_of
from tresym.reals.functions.row import Function
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import Expr, as_expr, number, symbol, trees
from tresym.reals.language.formula import Compared
from tresym.reals.language.typesetting import to_latex
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text

WIDTH, HEIGHT, STEPS = 240, 120, 160
PLOTTED = {"elliptic_k": (-3, 1), "elliptic_e": (-3, 1), "lambertwm1": (-1, 0)}
"""The interval of a plot; by default from −5 to 5."""
FIRST = {
    "polygamma": 1, "zetaderiv": 1, "expint": 1, "uppergamma": 2, "lowergamma": 2, "besselj": 0,
    "bessely": 0, "besseli": 0, "besselk": 0, "polylog": 2, "elliptic_f": 1, "elliptic_e_inc": 1,
    "elliptic_pi": fmpq(1, 2), "atan2": 1,
}  # fmt: skip
"""The first argument in the plot of a function of two arguments."""
TERMS = 4
"""Terms of an asymptotic series that are shown."""


def page() -> str:
    """Return the reference as Markdown: a section for each family, an entry for each function."""
    public = [row for row in TABLE.values() if not row.internal]
    lines = []
    for family, rows in groupby(public, lambda row: row.family):
        lines.append(f"### {family[0].upper()}{family[1:]}\n")
        lines += ["\n".join(_entry(row)) for row in rows]
    return "\n".join(lines) + "\n"


def _arguments(row: Function) -> tuple[Expr, ...]:
    if row.constant:
        return (number(1),)
    names = ("x",) if row.arity == 1 else ("nu", "x") if row.subscripted else ("a", "x")
    return tuple(map(symbol, names))


def _entry(row: Function) -> Iterator[str]:
    args = _arguments(row)
    node = Expr(row.name, args)
    yield f"**`{node}`**\n"
    yield f"$${row.definition}$$\n" if row.definition else ""
    yield _plot(row)
    facts = [f"Source: {row.source}."] if row.source else []
    where = [_latex((part, relation, number(0))) for part, relation in needs_of(node)]
    facts += (
        [f"Defined where ${', '.join(where)}$."] if where else ["Defined for all real numbers."]
    )
    facts += [_range(row)] if row.range.low is not None or row.range.high is not None else []
    facts += [word for word, holds in (
        ("Odd.", row.odd), ("Even.", row.even), ("Strictly increasing.", row.rising),
        ("Strictly decreasing.", row.falling), ("Never zero.", row.never_zero),
    ) if holds]  # fmt: skip
    for formula, x in zip(row.derivatives, args, strict=True):
        if formula is not None and not row.constant:
            slope = as_expr(formula(*args, trees))
            facts.append(rf"$\frac{{\partial}}{{\partial {x}}} {_latex((node, '==', slope))}$.")
    for place, formula in row.near.items():
        here, found = node, formula(*args, trees)
        if found is None:  # it holds for single orders
            here = Expr(row.name, (number(fmpq(FIRST[row.name])), args[-1]))
            found = formula(*here.args, trees)
        if found is not None:
            facts.append(f"As $x \\to {_end(place)}$: ${_latex((here, '==', as_expr(found)))}$.")
            facts += _expansion_factors(as_expr(found))
    facts += [f"Theorem used: {theorem}." for theorem in row.theorems]
    systems = (("SymPy", row.sympy), ("Mathematica", row.mathematica), ("Maple", row.maple),
               ("Coq", row.coq))  # fmt: skip
    facts.append("; ".join(f"{system} `{name}`" for system, name in systems if name) + ".")
    also = ", ".join(f"`{alias}`" for alias in (*row.aliases, *row.of_reciprocal))
    facts += [f"Also written {also}."] if also else []
    false = ", ".join(f"`{claim}`" for claim in row.falsehoods)
    facts += [f"False, and refuted in the tests: {false}."] if false else []
    yield "\n".join(f"- {fact}" for fact in facts) + "\n"


def _latex(comparison: Compared) -> str:
    return to_latex((comparison,))


def _end(place: str) -> str:
    if "oo" in place:
        return place.replace("oo", r"\infty")
    return f"{place[:-1]}^{place[-1]}"


def _range(row: Function) -> str:
    low = r"-\infty" if row.range.low is None else fraction_text(row.range.low)
    high = r"\infty" if row.range.high is None else fraction_text(row.range.high)
    opening = "(" if row.range.low is None or row.range.low_open else "["
    closing = ")" if row.range.high is None or row.range.high_open else "]"
    return f"Its values lie in ${opening}{low}, {high}{closing}$."


def _expansion_factors(e: Expr) -> list[str]:
    """Return the series of the factors of expansions in a formula, each once."""
    found: dict[str, str] = {}

    def walk(node: Expr) -> None:
        row = TABLE.get(node.op)
        if row is not None and row.internal and row.taylor is not None and row.remainder:
            v, terms = symbol("v"), number(0)
            for k in range(TERMS):
                term = row.taylor(*node.args[:-1], k, trees)
                if term is not None and term != 0:
                    terms = terms + as_expr(term) * (v**k if k else 1)
            whole = _latex((Expr(node.op, (*node.args[:-1], v)), "==", terms))
            found[node.op] = rf"Here ${whole} + \dots$ as $v \to 0^+$ ({row.source})."
        for arg in node.args:
            if isinstance(arg, Expr):
                walk(arg)

    walk(e)
    return list(found.values())


def _plot(row: Function) -> str:
    """Return a curve as SVG, on a grid of whole pixels."""
    if row.constant:
        return ""
    low, high = PLOTTED.get(row.name, (-5, 5))
    values: list[float | None] = []
    with ball_precision(64):
        for k in range(STEPS + 1):
            x = arb(fmpq(low) + fmpq(high - low) * fmpq(2 * k + 1, 2 * STEPS + 2))
            args = (x,) if row.arity == 1 else (arb(FIRST[row.name]), x)
            y = row.ball(*args)
            known = y.is_finite() and abs(y) < 20
            values.append(float(y.mid()) if known else None)
    seen = sorted(v for v in values if v is not None)
    if not seen:
        return ""
    top = max(abs(seen[len(seen) // 50]), abs(seen[-1 - len(seen) // 50]), 0.5)
    lines, current = [], ""
    for k, value in enumerate([*values, None]):
        if value is None or abs(value) > 1.1 * top:
            lines += [current] if current else []
            current = ""
            continue
        across, down = round(WIDTH * k / STEPS), round(HEIGHT / 2 * (1 - value / (1.15 * top)))
        current += f"{'L' if current else 'M'}{across} {down}"
    zero = round(WIDTH * -low / (high - low))
    axes = f"M0 {HEIGHT // 2}H{WIDTH}" + (f"M{zero} 0V{HEIGHT}" if low < 0 < high else "")
    return (
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" role="img" '
        f'aria-label="{row.name} for x from {low} to {high}, height {top:.2g}">'
        f'<path d="{axes}" fill="none" stroke="#888"/>'
        f'<path d="{"".join(lines)}" fill="none" stroke="#1667b7" stroke-width="2"/></svg>\n'
    )
