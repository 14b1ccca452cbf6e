"""Write polynomials as sums of squares of two terms with nonnegative factors.

The search is a linear program: find non-negative coefficients of products of the conditions and of
squares of m ± n, with monomials m and n, that add up to the polynomial. It is solved exactly by the
simplex method. Coq is given the squares that occur and finds the coefficients by linear arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, product

from tresym.coq.equations import quotient, unfolded
from tresym.coq.linear_dependence import Monomial, Vector, as_expression, expanded
from tresym.coq.statement import Theorem, term
from tresym.reals.language.expression import ONE, Expr, multiply

MOST_COLUMNS, MOST_ROWS, MOST_PIVOTS = 420, 90, 120


def square_proofs(theorem: Theorem, d: Expr, strict: bool) -> Iterator[str]:
    """Yield proofs of d ≥ 0 or d > 0 by sums of squares."""
    top, bottom = quotient(unfolded(d))
    try:
        polynomial = expanded(top)
        for most in (0, 1, 2):
            found = certificate(polynomial, conditions(theorem), most)
            if found is not None:
                yield _proof(d, top, bottom, found, strict)
                return
    except OverflowError:
        return


def conditions(theorem: Theorem) -> list[tuple[Expr, Vector]]:
    """Return the conditions as polynomials that are not negative."""
    found = []
    for x, relation, y in theorem.given:
        if relation != "!=":
            e = x - y if relation in (">", ">=") else y - x
            found.append((e, expanded(e)))
    for e, relation in theorem.defined:
        if relation != "!=":
            found.append((e, expanded(e)))
    return found


def certificate(
    polynomial: Vector, known: list[tuple[Expr, Vector]], most: int
) -> list[tuple[list[Expr], Expr]] | None:
    """Find products of conditions with their squares that add up to the polynomial, or None."""
    columns: list[tuple[Vector, list[Expr], Expr]] = []
    for n in range(most + 1):
        for chosen in combinations_with_replacement(known, n):
            factor: Vector = {frozenset(): Fraction(1)}
            for _, vector in chosen:
                factor = _times(factor, vector)
            for base, square in _squares(polynomial, factor):
                columns.append((_times(factor, square), [e for e, _ in chosen], base))
                if len(columns) > MOST_COLUMNS:
                    return None
    rows = sorted({m for v, *_ in columns for m in v} | set(polynomial), key=str)
    if len(rows) > MOST_ROWS or not columns:
        return None
    matrix = [[v.get(m, Fraction(0)) for v, *_ in columns] for m in rows]
    solution = nonnegative(matrix, [polynomial.get(m, Fraction(0)) for m in rows])
    if solution is None:
        return None
    return [(chosen, base) for (_, chosen, base), c in zip(columns, solution, strict=True) if c]


def _times(x: Vector, y: Vector) -> Vector:
    return expanded(multiply(as_expression(x), as_expression(y)))


def _degree(m: Monomial) -> int:
    return sum(n for _, n in m)


def _squares(polynomial: Vector, factor: Vector) -> Iterator[tuple[Expr, Vector]]:
    """Return monomials, their sums and differences whose squares fit, and these squares."""
    if not factor or not polynomial or any(n < 0 for m in polynomial for _, n in m):
        return
    degrees, own = [_degree(m) for m in polynomial], [_degree(m) for m in factor]
    low, high = (min(degrees) - min(own) + 1) // 2, (max(degrees) - max(own)) // 2
    parts = sorted({part for m in polynomial for part, _ in m}, key=str)
    ends = [
        max((n for m in polynomial for p, n in m if p == part), default=0) // 2 for part in parts
    ]
    if len(parts) > 7 or high < 0 or max(ends, default=0) > 6:
        return
    monomials = [
        multiply(*(p**n for p, n in zip(parts, exponents, strict=True) if n))
        for exponents in product(*(range(end + 1) for end in ends))
        if low <= sum(exponents) <= high
    ]
    for m in monomials:
        yield m, expanded(m**2)
    for m, n in combinations(monomials, 2):
        for e in (m - n, m + n):
            yield e, expanded(multiply(e, e))


def nonnegative(matrix: list[list[Fraction]], b: list[Fraction]) -> list[Fraction] | None:
    """Find a solution x ≥ 0 of A·x = b by the first phase of the simplex method, or None.

    Source: G. B. Dantzig, Linear Programming and Extensions (1963), chapter 5.
    """
    rows, n = len(matrix), len(matrix[0])
    table = []
    for i, (row, value) in enumerate(zip(matrix, b, strict=True)):
        s = -1 if value < 0 else 1
        own = [Fraction(int(i == j)) for j in range(rows)]
        table.append([*(s * x for x in row), *own, s * value])
    basis = [n + i for i in range(rows)]
    cost = [sum((row[j] for row in table), Fraction(0)) for j in range(n)]
    for _ in range(MOST_PIVOTS):
        best = max(cost)
        if best <= 0:
            break
        j = cost.index(best)
        ratios = [(row[-1] / row[j], basis[i], i) for i, row in enumerate(table) if row[j] > 0]
        if not ratios:
            return None
        i = min(ratios)[2]
        pivot = table[i][j]
        table[i] = [x / pivot if x else x for x in table[i]]
        for k, row in enumerate(table):
            if k != i and row[j]:
                c = row[j]
                table[k] = [x - c * y if y else x for x, y in zip(row, table[i], strict=True)]
        c = cost[j]
        cost = [x - c * y if y else x for x, y in zip(cost, table[i], strict=False)]
        basis[i] = j
    if any(row[-1] and basis[i] >= n for i, row in enumerate(table)):
        return None
    solution = [Fraction(0)] * n
    for i, row in enumerate(table):
        if basis[i] < n:
            solution[basis[i]] = row[-1]
    return solution


def _proof(
    d: Expr, top: Expr, bottom: Expr, found: list[tuple[list[Expr], Expr]], strict: bool
) -> str:
    """Return a script with the squares as premises, for the numerator over the denominator."""
    relation = "<" if strict else "<="
    lines = ["intros; saturate; laws."]
    for chosen, base in found:
        text = " * ".join([*(term(e, 3) for e in chosen), f"{term(base, 3)} ^ 2"])
        weak = f"assert (0 <= {text}) by squared"
        above = f"first [assert (0 < {text}) by positive | {weak}]"
        lines.append(f"{above if strict else weak}.")
    lines.append(f"assert (main : 0 {relation} {term(top)}) by lra.")
    if bottom == ONE or bottom.op == "number":
        return "\n".join([*lines, "lra."])
    law = "Rdiv_lt_0_compat" if strict else "from_quotient"
    u = unfolded(d)
    lines += [
        f"assert (den : 0 < {term(bottom)}) by (first [positive | facts; first [positive | nra]]).",
        f"assert (0 {relation} {term(u)}).",
        f"{{ replace ({term(u)}) with ({term(top, 3)} / {term(bottom, 3)}) by (field; side). "
        f"now apply {law}. }}",
        "lra.",
    ]
    return "\n".join(lines)
