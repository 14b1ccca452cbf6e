"""Benchmark of deciders: how many claims tresym and other tools decide within a time, and how well.

The claims are a fixed sample of lists whose truth is known: identities, inequalities, limits and
orders of growth, and asymptotics of integrals, sums, roots and special functions; about a third
are false. Each tool is asked what its user would type:

- SymPy: ``simplify(l - r) == 0`` and ``equals`` for identities; ``limit`` of the difference or of
  the ratio for limits and orders; ``simplify`` of the relation for inequalities.
- Maxima: ``trigsimp(radcan(l - r))``, ``limit``, and ``is`` under ``assume``.
- z3: inequalities and identities between polynomials; everything else is open.
- numerical testing with mpmath: 100 random points for claims at points, points down to 1e-8 from
  the end of the path for limits and orders. It says true where no test fails, which is no proof.

An answer counts as right only if it says which of true and false the claim is. Each answer is
computed in a process of its own, with a limit of processor time; the time is that of the child.
Conditions are passed on where the tool has a place for them (SymPy: positive symbols; Maxima:
``assume``; z3: all); claims about a root that an equation defines are put to tresym and z3 alone.
Maxima's start, a fifth of a second, is subtracted.
"""

from __future__ import annotations

import json
import os
import re
import resource
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from random import Random
from shutil import which
from typing import Any, NamedTuple

import mpmath
import sympy

import tresym
from tresym.checking.dispatch import decide_claim
from tresym.dev.bench.run import Tables, Timing, Workload
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.verdict import Verdict

LIMIT = 10
"""Seconds of processor time for an answer."""
KINDS = {
    "identities": ("claims/simplifications", 40),
    "inequalities": ("claims/inequalities", 40),
    "limits and orders": ("claims/orders", 40),
    "integrals and sums along a path": ("asymptotics/lemmas", 40),
    "roots along a path": ("asymptotics/roots", 30),
    "special functions": ("claims/special", 40),
}
"""Kinds of claims: the list in tests/data from which they are, and how many."""

ALONG = ("->", "O", "o", "~")
"""Relations along a path; for others, such as > from some point on, the tools have no form."""
_LINE = re.compile(r"(true|false|HOLDS|FALSE) (?:\| )?([^|]+)")
Answered = bool | None
"""True, false, or open."""


class Claim(NamedTuple):
    """A claim of a list, with its kind and its truth."""

    kind: str
    truth: bool
    text: str


def claims() -> Iterator[Claim]:
    """Yield the sample: every k-th claim of each list, so that the number is as wanted."""
    home = Path(tresym.__file__).resolve().parent.parent / "tests" / "data"
    for kind, (name, wanted) in KINDS.items():
        path = home / f"{name}.txt"
        lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
        rows = [found.groups() for found in map(_LINE.match, lines) if found]
        for k in range(min(wanted, len(rows))):
            truth, text = rows[k * len(rows) // wanted if len(rows) > wanted else k]
            yield Claim(kind, truth in ("true", "HOLDS"), text)


def by_tresym(claim: Claim) -> Answered:
    """Ask tresym."""
    verdict = decide_claim(claim.text).verdict
    return None if verdict is Verdict.UNDECIDED else verdict.holds


_NAMES = {
    "integral": lambda f, x, *ends: sympy.Integral(f, (x, *ends)) if ends else sympy.Integral(f, x),
    "sum": lambda f, k, low, high: sympy.Sum(f, (k, low, high)),
    "product": lambda f, k, low, high: sympy.Product(f, (k, low, high)),
    "cbrt": lambda x: sympy.real_root(x, 3),
    "abs": sympy.Abs,
    "max": sympy.Max,
    "min": sympy.Min,
    "elliptic_k": sympy.elliptic_k,
    "elliptic_e": sympy.elliptic_e,
    "lambertw": sympy.LambertW,
    "E1": lambda x: sympy.expint(1, x),
}
_POINT = {True: sympy.oo, False: -sympy.oo}


def _in_sympy(e: Expr, statement: Statement) -> Any:
    """Return an expression of the sample, which we wrote ourselves, as SymPy reads its text."""
    positive = {
        str(e)
        for e, relation, bound in statement.given.comparisons
        if e.op == "symbol" and relation in (">", ">=") and str(bound) == "0"
    }
    names = {
        name: sympy.Symbol(name, integer=True, positive=name in positive or None)
        if name in statement.integers
        else sympy.Symbol(name, real=True, positive=name in positive or None)
        for name in (*symbols(e), "t", "k", "x", "n")
    }
    return sympy.sympify(str(e), locals=_NAMES | names)


def by_sympy(claim: Claim) -> Answered:
    """Ask SymPy, in the form that its documentation suggests for the kind of claim."""
    statement = read(claim.text)
    if statement.equations or statement.uniformly:
        return None
    return _together(_one_by_sympy(comparison, statement) for comparison in statement.comparisons)


def _together(answers: Iterator[Answered]) -> Answered:
    found = [*answers]
    return False if False in found else None if None in found else True


def _one_by_sympy(c: Comparison, statement: Statement) -> Answered:
    left, right = (_in_sympy(side, statement) for side in (c.left, c.right))
    if statement.path is None:
        if c.relation == "==":
            gap = (left - right).doit()
            if sympy.simplify(gap) == 0:
                return True
            return False if gap.equals(0) is False else None
        relation = sympy.Rel(left, right, {"!=": "ne"}.get(c.relation, c.relation))
        found = sympy.simplify(relation)
        return {sympy.true: True, sympy.false: False}.get(found)
    path = statement.path
    if c.relation not in ALONG:
        return None
    x = next((s for s in left.free_symbols | right.free_symbols if s.name == path.name), None)
    answers = []
    for side in path.sides:
        point = _POINT[side > 0] if path.point is None else _in_sympy(path.point, statement)
        direction = "+" if side > 0 else "-"
        if c.relation == "->":
            value = sympy.limit(left.doit(), x, point, direction)
            known = not value.has(sympy.Limit, sympy.AccumBounds)
            answers.append(sympy.simplify(value - right) == 0 if known else None)
            continue
        value = sympy.limit(left.doit() / right.doit(), x, point, direction)
        if value.has(sympy.Limit):
            answers.append(None)
        elif c.relation == "O":
            answers.append(not value.is_infinite)
        else:
            answers.append(bool(value == {"o": 0, "~": 1}.get(c.relation)))
    return _together(iter(answers))


def by_maxima(claim: Claim) -> Answered:
    """Ask Maxima for the normal form, the limit, or the truth of a comparison."""
    statement = read(claim.text)
    if statement.equations or statement.uniformly:
        return None
    return _together(_one_by_maxima(comparison, statement) for comparison in statement.comparisons)


def _maxima(e: Any) -> str:
    text = str(e).replace("**", "^")
    text = re.sub(r"\bpi\b", "%pi", re.sub(r"\boo\b", "inf", re.sub(r"\bE\b", "%e", text)))
    text = re.sub(r"\bintegral\b", "integrate", text)
    return re.sub(r"\bcbrt\(", "cuberoot(", text)


def _one_by_maxima(c: Comparison, statement: Statement) -> Answered:
    left, right = _maxima(c.left), _maxima(c.right)
    assumed = "".join(
        f"assume({_maxima(e)} {relation} {_maxima(bound)})$"
        for e, relation, bound in statement.given.comparisons
        if relation in ("<", "<=", ">", ">=")
    )
    if statement.path is None and c.relation == "==":
        asked = f"trigsimp(radcan(({left}) - ({right})))"
    elif statement.path is not None and c.relation not in ALONG:
        return None
    elif statement.path is None:
        asked = f"is(({left}) {'#' if c.relation == '!=' else c.relation} ({right}))"
    else:
        path = statement.path
        side = path.sides[0]
        point = ("inf" if side > 0 else "minf") if path.point is None else _maxima(path.point)
        direction = "" if path.point is None else f", {'plus' if side > 0 else 'minus'}"
        body = left if c.relation == "->" else f"({left})/({right})"
        asked = f"limit({body}, {path.name}, {point}{direction})"
        if c.relation == "->":
            asked = f"({asked}) - ({right})"
    out = _run_maxima(f"cuberoot(x) := signum(x)*abs(x)^(1/3)$ {assumed} display2d:false$ {asked};")
    if statement.path is None and c.relation == "==":
        return True if out == "0" else None
    if statement.path is None:
        return {"true": True, "false": False}.get(out)
    if out in ("", "und", "ind") or "limit" in out:
        return None
    if c.relation == "O":
        return out not in ("inf", "minf", "infinity")
    return out == {"~": "1"}.get(c.relation, "0")


def _run_maxima(program: str) -> str:
    done = subprocess.run(
        ["maxima", "--very-quiet", "--batch-string", program],
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
    )
    lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
    return "" if not lines or "incorrect syntax" in done.stdout else lines[-1]


def by_z3(claim: Claim) -> Answered:
    """Ask z3 whether the negation of a polynomial claim can be satisfied."""
    import z3

    statement = read(claim.text)
    if statement.path is not None:
        return None
    names: dict[str, Any] = {}

    def term(e: Expr) -> Any:
        if e.op == "number":
            return z3.Q(int(e.args[0].p), int(e.args[0].q))
        if e.op == "symbol":
            real = z3.Int if e.args[0] in statement.integers else z3.Real
            return names.setdefault(e.args[0], real(e.args[0]))
        args = [term(arg) for arg in e.args]
        if e.op == "+":
            return sum(args[1:], args[0])
        if e.op == "*":
            product = args[0]
            for arg in args[1:]:
                product = product * arg
            return product
        if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
            n = int(e.args[1].args[0])
            if 0 < n < 20:
                return args[0] ** n
        raise LookupError(e.op)

    def formula(left: Expr, relation: str, right: Expr) -> Any:
        x, y = term(left), term(right)
        relations = {"<": x < y, "<=": x <= y, ">": x > y, ">=": x >= y, "==": x == y}
        return relations.get(relation, x != y)

    try:
        solver = z3.Solver()
        for condition in statement.given.comparisons:
            solver.add(formula(*condition))
        solver.add(z3.Or([z3.Not(formula(*c[:3])) for c in map(_sides, statement.comparisons)]))
        found = solver.check()
    except (LookupError, z3.Z3Exception):
        return None
    return True if found == z3.unsat else False if found == z3.sat else None


def _sides(c: Comparison) -> tuple[Expr, str, Expr]:
    return c.left, c.relation, c.right


def by_testing(claim: Claim) -> Answered:
    """Test numerically with mpmath: no failure counts as true."""
    statement = read(claim.text)
    if statement.equations or statement.uniformly:
        return None
    return _together(_tested(comparison, statement) for comparison in statement.comparisons)


def _tested(c: Comparison, statement: Statement) -> Answered:
    random = Random(1)
    sides = [_in_sympy(side, statement) for side in (c.left, c.right)]
    free = sorted(sides[0].free_symbols | sides[1].free_symbols, key=str)
    values = sympy.lambdify(free, sides, "mpmath")
    conditions = [
        sympy.lambdify(free, [_in_sympy(e, statement), _in_sympy(b, statement)], "mpmath")
        for e, _, b in statement.given.comparisons
        if symbols(e) | symbols(b) <= {s.name for s in free}
    ]
    relations = [relation for _, relation, _ in statement.given.comparisons]
    compare: dict[str, Callable[[Any, Any], bool]] = {
        "<": lambda x, y: x < y,
        "<=": lambda x, y: x <= y,
        ">": lambda x, y: x > y,
        ">=": lambda x, y: x >= y,
        "!=": lambda x, y: abs(x - y) > 1e-20 * max(1, abs(x)),
        "==": lambda x, y: abs(x - y) <= 1e-20 * max(1, abs(x)),
    }
    seen = 0
    with mpmath.workdps(40):
        if statement.path is not None:
            return _tested_along(values, free, c, statement)
        for _ in range(300):
            point = [
                mpmath.mpf(random.randint(1, 20))
                if s.name in statement.integers
                else mpmath.mpf(random.uniform(-5, 5))
                for s in free
            ]
            with suppress(Exception):
                if not all(
                    compare[r](*map(mpmath.mpf, f(*point)))
                    for r, f in zip(relations, conditions, strict=False)
                ):
                    continue
                x, y = map(mpmath.mpf, values(*point))
                seen += 1
                if not compare[c.relation](x, y):
                    return False
            if seen >= 100:
                break
    return True if seen else None


def _tested_along(values: Any, free: list[Any], c: Comparison, statement: Statement) -> Answered:
    path = statement.path
    if path is None or c.relation not in ALONG:
        return None
    found = []
    point = None if path.point is None else mpmath.mpf(str(sympy.N(str(path.point), 40)))
    for exponent in (2, 4, 6, 8):
        step = mpmath.mpf(10) ** -exponent
        x = path.sides[0] / step if point is None else point + path.sides[0] * step
        at = [x if s.name == path.name else mpmath.mpf("0.7") for s in free]
        with suppress(Exception):
            left, right = map(mpmath.mpf, values(*at))
            found.append(left - right if c.relation == "->" else left / right)
    if len(found) < 3:
        return None
    last = found[-1]
    if c.relation == "->" or c.relation == "o":
        return bool(abs(last) < 0.05)
    if c.relation == "~":
        return bool(abs(last - 1) < 0.05)
    return bool(abs(last) <= 2 * abs(found[-2]) + 1e-30)


METHODS: dict[str, Callable[[Claim], Answered]] = {
    "tresym check": by_tresym,
    "SymPy": by_sympy,
    "Maxima": by_maxima,
    "z3": by_z3,
    "testing with mpmath": by_testing,
}


def timed(method: Callable[[Claim], Answered], claim: Claim) -> tuple[str, float]:
    """Answer in a child process: true, false, open or stopped, and its processor time."""
    sys.stdout.flush()
    reading, writing = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(reading)
        resource.setrlimit(resource.RLIMIT_CPU, (LIMIT + 1, LIMIT + 2))
        resource.setrlimit(resource.RLIMIT_AS, (4 * 10**9, 4 * 10**9))
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, 1)
        os.dup2(null, 2)
        answer: Any = None
        start = _used()
        with suppress(Exception):
            answer = method(claim)
        answer = None if answer is None else bool(answer)
        os.write(writing, json.dumps([answer, _used() - start]).encode())
        os._exit(0)
    os.close(writing)
    data = b""
    while block := os.read(reading, 4096):
        data += block
    os.close(reading)
    os.waitpid(pid, 0)
    if not data:
        return "stopped", float(LIMIT)
    answer, seconds = json.loads(data)
    if seconds > LIMIT:
        return "stopped", float(LIMIT)
    return {True: "true", False: "false", None: "open"}[answer], seconds


def _used() -> float:
    own = resource.getrusage(resource.RUSAGE_SELF)
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def tables(_: list[Timing]) -> Iterator[tuple[str, Any]]:
    """Yield an answer of each method to each claim."""
    start = 0.0
    if which("maxima"):
        begun = _used()
        _run_maxima("1+1;")
        start = _used() - begun
    sample = [*claims()]
    for claim in sample:
        for name, method in METHODS.items():
            if name == "Maxima" and not which("maxima"):
                continue
            answer, seconds = timed(method, claim)
            if name == "Maxima":
                seconds = max(0.001, seconds - start)
            yield (
                "answers",
                {
                    "kind": claim.kind,
                    "truth": claim.truth,
                    "claim": claim.text,
                    "method": name,
                    "answer": answer,
                    "seconds": float(f"{seconds:.3g}"),
                },
            )


def notes(_: list[Timing], found: Tables) -> dict[str, Any]:
    """Return for each method and kind how many answers are right, wrong and open."""
    counts: dict[str, Any] = {}
    for row in found.get("answers", []):
        said = {"true": True, "false": False}.get(row["answer"])
        outcome = "open" if said is None else "right" if said is row["truth"] else "wrong"
        kinds = counts.setdefault(row["method"], {})
        kind = kinds.setdefault(row["kind"], {"right": 0, "wrong": 0, "open": 0})
        kind[outcome] += 1
    maxima = ""
    if which("maxima"):
        done = subprocess.run(["maxima", "--version"], capture_output=True, text=True, check=False)
        maxima = done.stdout.strip().removeprefix("Maxima ")
    return {"counts": counts, "limit": LIMIT, "maxima": maxima}


WORKLOAD = Workload(tables=tables, notes=notes)
