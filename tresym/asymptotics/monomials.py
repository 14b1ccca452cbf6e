"""Decide X = O(Y) for sums of monomials in positive parameters, without a path.

``a**2*b == O(a**3 + b**3) given a > 0, b > 0`` asks for a constant that serves for all values of
the parameters. A monomial with exponents x is bounded by a sum of monomials c_j m_j exactly if x
lies in the convex hull of their exponents, x = Σ w_j m_j with weights w_j ≥ 0 of sum 1. Then the
weighted inequality of arithmetic and geometric means gives the constant Π (w_j/c_j)^{w_j}.
Otherwise a direction d with d·x > d·m_j for all j exists, and along the curve of the values t^{d_i}
the ratio is unbounded as t → ∞. (G. H. Hardy, J. E. Littlewood, G. Pólya, *Inequalities*, 1952,
section 2.5; A. Schrijver, *Theory of Linear and Integer Programming*, 1986, section 7.1.)

The weights and the direction are found by exact elimination on small subsets (Carathéodory), so
that both are proofs. Limit: parameters and monomials are few.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

from flint import arb, fmpq, fmpq_mat

from tresym.asymptotics.constants import rounded
from tresym.reals.decisions.answer import Answer, constant_ball
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, symbol, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MOST = 12
"""The number of monomials on the right side."""
LARGEST = fmpq(1000)
Exponents = tuple[fmpq, ...]
LEMMA = "weighted means (Hardy, Littlewood, Pólya 1952, section 2.5)"


def decide_monomials(claim: Comparison, statement: Statement) -> Answer:
    """Decide an order without a path between sums of monomials in positive parameters."""
    names = sorted(symbols(claim.left) | symbols(claim.right))
    left, right = (_monomials(e, names) for e in (claim.left, claim.right))
    positive = all(sign(symbol(n), statement.given, ">") == "+" for n in names)
    if left is None or right is None or not right or len(right) > MOST or claim.relation != "O":
        return Answer(
            Verdict.UNDECIDED,
            "an order without a path is decided for sums of powers of positive parameters with "
            "positive coefficients on the right side; otherwise give its path, such as x -> 0+",
        )
    if not positive:
        return Answer(
            Verdict.UNDECIDED,
            f"an order without a path needs positive parameters: given "
            f"{', '.join(f'{n} > 0' for n in names)}",
        )
    if any(c <= 0 for c in right.values()):
        return Answer(Verdict.UNDECIDED, "the coefficients of the right side must be positive")
    with ball_precision():
        constant = arb(0)
        for x, c in left.items():
            weights = _weights(x, list(right))
            if weights is None:
                return _unbounded(claim, statement, names, x, left, list(right))
            part = arb(abs(c))
            for m, w in weights.items():
                if w:
                    part *= (arb(w) / arb(right[m])) ** arb(w)
            constant += part
        why = f"|left| <= C |right| with C = {rounded(constant, 1)} for all positive parameters"
        return Answer(
            Verdict.PROVED,
            f"{why}, by weighted arithmetic and geometric means",
            constant=constant_ball(constant),
            lemma=LEMMA,
            uniform=True,
        )


def _monomials(e: Expr, names: list[str]) -> dict[Exponents, fmpq] | None:
    """Return a sum of monomials as coefficients by exponents; None if it is none."""
    found: dict[Exponents, fmpq] = {}
    for term in e.args if e.op == "+" else (e,):
        one = _monomial(term, names)
        if one is None:
            return None
        exponents, c = one
        found[exponents] = found.get(exponents, fmpq(0)) + c
    return {m: c for m, c in found.items() if c}


def _monomial(e: Expr, names: list[str]) -> tuple[Exponents, fmpq] | None:
    if e.op == "number":
        return (fmpq(0),) * len(names), e.args[0]
    if e.op == "symbol":
        return tuple(fmpq(int(n == e.args[0])) for n in names), fmpq(1)
    if e.op == "*":
        exponents, c = (fmpq(0),) * len(names), fmpq(1)
        for part in e.args:
            one = _monomial(part, names)
            if one is None:
                return None
            exponents = tuple(x + y for x, y in zip(exponents, one[0], strict=True))
            c *= one[1]
        return exponents, c
    if e.op == "^" and e.args[1].op == "number":
        one, r = _monomial(e.args[0], names), e.args[1].args[0]
        if one is None or (one[1] != 1 and r.q != 1):
            return None
        return tuple(x * r for x in one[0]), one[1] ** int(r.p) if r.q == 1 else fmpq(1)
    return None


def _weights(x: Exponents, points: list[Exponents]) -> dict[Exponents, fmpq] | None:
    """Return weights of a convex combination of points that is x; None if there is none."""
    n = len(x)
    for size in range(1, min(len(points), n + 1) + 1):
        for chosen in combinations(points, size):
            rows = [[m[i] for m in chosen] + [x[i]] for i in range(n)]
            rows.append([fmpq(1)] * size + [fmpq(1)])
            solution = _solved(rows, size)
            if solution is not None and all(w >= 0 for w in solution):
                return dict(zip(chosen, solution, strict=True))
    return None


def _solved(rows: list[list[fmpq]], size: int) -> list[fmpq] | None:
    """Return the unique solution of a linear system; None if there is none or several."""
    reduced, rank = fmpq_mat(rows).rref()
    if rank != size or any(reduced[i, i] != 1 for i in range(size)):
        return None
    return [reduced[i, size] for i in range(size)]


def _unbounded(
    claim: Comparison,
    statement: Statement,
    names: list[str],
    x: Exponents,
    left: dict[Exponents, fmpq],
    points: list[Exponents],
) -> Answer:
    """Return a refutation along a curve of powers, of the monomial that grows fastest there."""
    d = _direction(x, points)
    open_answer = Answer(Verdict.UNDECIDED, "no curve of counterexamples was found")
    if d is None:
        return open_answer
    growth = {m: sum((a * b for a, b in zip(d, m, strict=True)), fmpq(0)) for m in left}
    top = max(growth.values())
    if sum(value == top for value in growth.values()) > 1:
        return open_answer  # two terms that may cancel
    right = max(sum((a * b for a, b in zip(d, m, strict=True)), fmpq(0)) for m in points)
    curve = ", ".join(
        f"{n} = t**{_shown(k)}" if k not in (0, 1) else f"{n} = {'t' if k else '1'}"
        for n, k in zip(names, d, strict=True)
    )
    allowed = _stays(statement, names)
    if not allowed:
        return replace(open_answer, why="the conditions bound the parameters on both sides")
    why = f"along {curve} the ratio left/right grows like t**{_shown(top - right)} as t -> oo"
    return Answer(Verdict.REFUTED, why, witness={}, lemma=LEMMA, uniform=False)


def _shown(x: fmpq) -> str:
    text = fraction_text(x)
    return text if x.q == 1 and x > 0 else f"({text})"


def _stays(statement: Statement, names: list[str]) -> bool:
    """Return whether the conditions say nothing but that the parameters are positive."""
    box = statement.given.box
    return all(
        symbols(left) | symbols(right) <= {*names}
        and len(symbols(left) | symbols(right)) == 1
        and relation != "!="
        for left, relation, right in statement.given.comparisons
    ) and all(box[n].high is None and box[n].low == 0 for n in names if n in box)


def _direction(x: Exponents, points: list[Exponents]) -> Exponents | None:
    """Return d with d·x > d·m for all points m, with small whole components; None if not found.

    It is the way from the nearest point of the convex hull to x (E. G. Gilbert, SIAM J. Control 4
    (1966) 61), rounded and verified exactly.
    """
    near = [float(v) for v in points[0]]
    goal = [float(v) for v in x]
    others = [[float(v) for v in m] for m in points]
    for _ in range(2000):
        d = [a - b for a, b in zip(goal, near, strict=True)]
        best = max(others, key=lambda m: sum(a * b for a, b in zip(d, m, strict=True)))
        step = [a - b for a, b in zip(best, near, strict=True)]
        size = sum(s * s for s in step)
        along = sum(a * b for a, b in zip(d, step, strict=True))
        if size == 0 or along <= 1e-12:
            break
        part = min(1.0, along / size)
        near = [a + part * s for a, s in zip(near, step, strict=True)]
    d = [a - b for a, b in zip(goal, near, strict=True)]
    largest = max(map(abs, d), default=0.0)
    if not largest:
        return None
    for scale in (1, 2, 3, 4, 5, 6, 8, 10, 12, 20, 50, 100, 1000):
        whole = tuple(fmpq(round(scale * v / largest)) for v in d)
        dot = sum((a * b for a, b in zip(whole, x, strict=True)), fmpq(0))
        if all(dot > sum((a * b for a, b in zip(whole, m, strict=True)), fmpq(0)) for m in points):
            return whole
    return None
