"""Random claims around exceptional values: ``python tests/exceptional_claims.py [N [SEED]]``

As in ``hunt.py``, by whose means they are decided. A claim that is true in general position is
multiplied by something that is 1 but where an expression u of the parameters vanishes, divided by a
coefficient that may be 0, or given coinciding ends, an empty sum, a hole. Whether u can vanish
under the conditions says whether the claim is true. For claims about polynomials with sign, abs,
max and min the truth is that of z3 (L. de Moura, N. Bjørner, TACAS 2008, LNCS 4963, 337).
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from typing import Any

import hunt

Claim = tuple[str, bool | None]

# What vanishes at an exceptional value


def vanishing(r: random.Random, names: str = "ab") -> tuple[str, str, bool]:
    """An expression u in parameters, conditions on them, and whether u is 0 somewhere there."""
    a, b = names[0], names[1]
    c = r.choice(["9", "7", "-4", "1/2", "13", "-3/2", "0", "100", "2/3"])
    u, free = r.choice(
        [
            (f"{a} - ({c})", True),
            (f"2*{a} - ({c})", True),
            (f"({c}) - {a}", True),
            (f"{a} - {b}", True),
            (f"{a}*{b}", True),
            (f"{a}*({a} - 5)", True),
            (f"{a}**2 - 4", True),
            (f"{a}**2 - 2", True),
            (f"{a} + {b} - 1", True),
            (f"{a}**2 + 1", False),
            (f"exp({a}) - 1", True),
            (f"exp({a})", False),
            (f"abs({a}) + 1/3", False),
            (f"{a}**3", True),
            (f"abs({a} - ({c}))", True),
            (f"{a} - {b}**2", True),
            (f"{a}**2 + {b}**2", True),
        ]
    )
    how = r.choice(["", "", ">", ">=", "!=", "<", "<="])
    given = f"{u} {how} 0" if how else ""
    never = u.startswith("abs") or u.endswith("**2 + 1") or "**2 + b**2" in u or u == "exp(a)"
    if never and how in ("<", "<="):  # no point would be left
        given = how = ""
    return u, given, free and how in ("", ">=", "<=")


SLOTS = (
    *("sign({u})**2", "abs(sign({u}))", "sign(({u})**2)", "max(sign({u}), -sign({u}))"),
    *("sign({u})**4", "(1 - 3*(1 - sign({u})**2))", "cos(pi*(1 - sign({u})**2))"),
    "(1 + atan2({u}, -1) + atan2(-({u}), -1))",
)
"""Each is 1, but where u is 0."""
ZEROS = 5
"""So many of them are 0 there."""


def slot(r: random.Random, slots: tuple[str, ...] = SLOTS) -> tuple[str, str, bool]:
    """A factor that is 1 in general position, conditions, and whether it is always 1."""
    u, given, vanishes = vanishing(r)
    return r.choice(slots).format(u=u), given, not vanishes


def with_conditions(claim: str, *conditions: str) -> str:
    """The claim with its conditions, before its path."""
    given = ", ".join(filter(None, conditions))
    head, word, path = claim.partition(" as ")
    return f"{head}{f' given {given}' if given else ''}{word}{path}"


# Along paths


PATHS = (
    *("{s}*(2 + 1/x) -> 2 as x -> oo", "{s} + sin(x)/x -> 1 as x -> oo"),
    *("x*{s} ~ x as x -> oo", "{s}*sin(x)/x -> 1 as x -> 0", "1/x + 1 - {s} == o(1) as x -> oo"),
    *("x*(1 - {s}) == O(1) as x -> oo", "(1 - {s})*exp(x) == o(x) as x -> oo"),
    *("x - x**2*(1 - {s}) > 0 as x -> oo", "x**2*{s} > x as x -> oo", "{s} > 1/x as x -> oo"),
    *("x*{s} == Theta(x) as x -> oo", "log(x)*{s} -> oo as x -> oo"),
    *("cos(x) == {s} + O(x**2) as x -> 0", "exp(x) == {s} + x + O(x**2) as x -> 0"),
    *("n*(1 - {s}) -> 0 as n -> oo given n integer", "(1 + {s}/n)**n -> E as n -> oo"),
    *("log(1 + x)*{s}/x -> 1 as x -> 0+", "{s}*x == o(x**2) + x as x -> 0"),
    "integral(exp(-t**2)*{s}, t, 0, x)/x -> 1 as x -> 0",
)


def paths(r: random.Random) -> Claim:
    """Limits, orders and eventual inequalities with a jump of a parameter."""
    claim = r.choice(PATHS)
    larger = any(part in claim for part in ("Theta", "-> oo", " > "))
    s, given, true = slot(r, SLOTS[:ZEROS] if larger else SLOTS)
    claim = claim.format(s=s)
    if " given n integer" in claim:
        claim = claim.replace(" given n integer", "")
        return with_conditions(claim, "n integer", given), true
    return with_conditions(claim, given), true


def coefficients(r: random.Random) -> Claim:
    """Limits whose value hangs on whether a coefficient is 0."""
    given, zero = r.choice([("", True), ("a > 0", False), ("a >= 0", True), ("a != 0", False)])
    claim, at_zero = r.choice(
        [
            ("(a*x + 1)/(a*x + 2) -> 1 as x -> oo", False),
            ("(a*x + sqrt(x))/(a*x + 2*sqrt(x)) -> 1 as x -> oo", False),
            ("sin(a*x)/(a*x) -> 1 as x -> 0", True),
            ("sin(a*x)/x -> a as x -> 0", True),
            ("exp(-a**2*x) -> 0 as x -> oo", False),
            ("sign(a*x)**2 -> 1 as x -> oo", False),
            ("a*x**2 + x ~ a*x**2 as x -> oo", True),
            ("x == o(a**2*x**2) as x -> oo", False),
            ("1/(1 + a**2*x) -> 0 as x -> oo", False),
            ("abs(a)*x -> oo as x -> oo", False),
            ("x == O(a*x) as x -> oo", False),
            ("atan(a**2*x) -> pi/2 as x -> oo", False),
            ("tanh(a*x)**2 -> 1 as x -> oo", False),
        ]
    )
    if "~ a*x" in claim or "O(a*x" in claim or "o(a**2" in claim:
        return with_conditions(claim, given), None if zero else True  # ratios to 0 are undefined
    return with_conditions(claim, given), (not zero) or at_zero


# Series, products, derivatives of order n, dotted series


EQUATIONS = (
    *(
        "diff(exp(x), x, n):exp(x)",
        "diff(sin(x), x, n):sin(x + n*pi/2)",
        "diff(2**x, x, n):log(2)**n*2**x",
    ),
    *("sum(x**k, k, 0, oo):1/(1 - x):-1 < x < 1", "sum(x**k/factorial(k), k, 0, oo):exp(x)"),
    *(
        "sum(1/k**2, k, 1, oo):pi**2/6",
        "sum(1/2**k, k, 0, oo):2",
        "product(1 - 1/(4*k**2), k, 1, oo):2/pi",
    ),
    *("sum(k, k, 1, n):n*(n + 1)/2:n >= 1", "product(1 + 1/k, k, 1, n):n + 1:n >= 1"),
    *("(1 + x + x**2 + ...):1/(1 - x):-1 < x < 1", "(x - x**3/6 + x**5/120 - ...):sin(x)"),
    *(
        "integral(exp(-t), t, 0, oo):1",
        "integral(x*t, t, 0, 1):x/2",
        "factorial(n + 1):(n + 1)*factorial(n)",
    ),
    *(
        "f(x + 0):f(x)",
        "diff(f(x)**2, x):2*f(x)*diff(f(x), x)",
        "sum(k*x**k, k, 1, oo):x/(1 - x)**2:-1 < x < 1",
    ),
    "sum((-1)**k*x**(2*k)/factorial(2*k), k, 0, oo):cos(x)",
)


def equations(r: random.Random) -> Claim:
    """An equation L == R multiplied on one side, or on both with a rest that hangs on a zero."""
    left, right, *given = r.choice(EQUATIONS).split(":")
    if r.random() < 0.6:
        s, more, true = slot(r)
        sides = [f"{s}*{left}", right]
        r.shuffle(sides)
        return with_conditions(" == ".join(sides), *given, more), true
    more, true = r.choice(
        [
            ("a*b == 0", False),
            ("a*b == 0, a > 0", True),
            ("b == 0", True),
            ("a*b == 0, a != 0", True),
        ]
    )
    return with_conditions(f"a*{left} == a*({right}) + b", *given, more), true


HOLES = (
    "integral(cos(a*x), x, 0, 1) < 1",
    "integral(exp(a*x), x, 0, 1) != 1",
    "a*integral(exp(a*x), x, 0, 1) != 0",
    "sum(a**k, k, 0, n) != n + 1",
    "sum(x**k/(k + 1), k, 0, oo) != 1",
    "sign(a)**2*sum(1/(n**2 + a**2), n, 1, oo) == sum(1/(n**2 + a**2), n, 1, oo)",
    "sign(a)**2*product(1 - a**2/n**2, n, 1, oo) == product(1 - a**2/n**2, n, 1, oo)",
    "sign(a)**2*integral(exp(a*x), x, 0, 1) == integral(exp(a*x), x, 0, 1)",
    "sum(x**k/(k + 1), k, 0, oo)*sign(x)**2 == sum(x**k/(k + 1), k, 0, oo)",
    "sum(x**k/factorial(k), k, 0, oo)*sign(x)**2 == exp(x)",
    "integral(x**a, x, 1, 2)*sign(a + 1)**2 == integral(x**a, x, 1, 2)",
    "integral(cos(a*x), x, 0, pi)*abs(sign(a)) == integral(cos(a*x), x, 0, pi)",
)


def holes(r: random.Random) -> Claim:
    """What fails only where the formula of a value has a removable hole."""
    claim = r.choice(HOLES)
    name, place = ("x", "0") if "(x**k" in claim else ("a", "-1" if "a + 1" in claim else "0")
    place = "1" if "a**k" in claim else place
    how, true = r.choice([("", False), (">", True), (">=", False), ("!=", True), ("<", True)])
    own = ["-1 < x < 1"] if "/(k + 1)" in claim else ["n >= 1"] if "a**k" in claim else []
    if "a**2/n**2" in claim or ("a**k" in claim and how in ("!=", "<")):
        how, true = "", False
    return with_conditions(claim, *own, f"{name} {how} {place}" if how else ""), true


def derivatives(r: random.Random) -> Claim:
    """Derivatives with a removable hole of their formula."""
    c = r.choice(["0", "2", "-1/2", "a"])
    u = f"(x - ({c}))"
    f, value = r.choice(
        [
            (f"abs({u})**2", "0"),
            (f"{u}*abs({u})", "0"),
            (f"abs({u})**3", "0"),
            (f"sqrt({u}**4)", "0"),
            (f"{u}**2*sign({u})", "0"),
            (f"abs({u})**2 + x", "1"),
            (f"sign({u})*{u}**4", "0"),
            (f"cbrt({u})**6", "0"),
            (f"exp(-abs({u})**3)", "0"),
            (f"abs({u}**3)", "0"),
        ]
    )
    given, hole = r.choice([("", True), (f"x > {c}", False), (f"x >= {c}", True)])
    if r.random() < 0.5:
        return with_conditions(f"diff({f}, x) != {value}", given), not hole
    claimed = r.choice([value, value, "5", "-1/9"])
    claim = f"diff({f}, x) == diff({f}, x)*sign({u})**2 + ({claimed})*(1 - sign({u})**2)"
    return with_conditions(claim, given), claimed == value or not hole


# Ends and empty sums


def ends(r: random.Random) -> Claim:
    """Coinciding ends of integrals, empty sums and products, 0**0."""
    return r.choice(
        [
            ("integral(exp(t), t, a, b) > 0 given b > a", True),
            ("integral(exp(t), t, a, b) > 0 given b >= a", False),
            ("integral(t**2, t, 0, b) > 0 given b >= 0", False),
            ("integral(t**2, t, 0, b) >= 0 given b >= 0", True),
            ("integral(1/t, t, 1, b) != 0 given b > 0", False),
            ("integral(1/t, t, 1, b) != 0 given b > 1", True),
            ("sum(k**2, k, 1, n) > 0 given n >= 0", False),
            ("sum(k**2, k, 1, n) > 0 given n >= 1", True),
            ("product(k + 1, k, 1, n) > 1 given n >= 0", False),
            ("product(k + 1, k, 1, n) > 1 given n >= 1", True),
            ("sum(2**k, k, 0, n) == 2**(n + 1) - 1 given n >= 0", True),
            ("n*sum(1, k, 1, n) == n**2 given n >= 0", True),
            ("sum(k, k, 1, n)/n == (n + 1)/2 given n >= 0", True),
            ("integral(sin(t)**2, t, 0, b) > 0 given b != 0", False),
            ("integral(sin(t)**2, t, 0, b) > 0 given b > 0", True),
            ("integral(f(t), t, a, a) == 0", True),
            ("integral(f(t), t, a, b) == integral(f(t), t, a, b)*sign(a - b)**2", True),
            ("factorial(n) > n - 1 given n >= 0", True),
            ("factorial(n) > n given n >= 3", True),
            ("factorial(n) > n given n >= 2", False),
            ("1/n**2 <= 1 given n integer", True),
            ("n**2 > n given n integer", False),
            ("n**2 >= n given n integer", True),
            ("(n - 30)*(n - 31) > 0 given n integer", False),
            ("(n - 30)*(n - 31) >= 0 given n integer", True),
            (f"(n - {(k := r.randint(-60, 60))})**2 > 0 given n integer", False),
            (f"(2*n - {2 * k + 1})**2 > 0 given n integer", True),
            (f"sign(n - ({k}))**2 == 1 given n integer", False),
            (f"sign(2*n - ({2 * k + 1}))**2 == 1 given n integer", True),
        ]
    )


def terms(r: random.Random) -> Claim:
    """Expansions, of which every term is asserted."""
    f, parts, path = r.choice(
        [
            ("sin(x)", ["x", "-x**3/6", "x**5/120"], "0"),
            ("cos(x)", ["1", "-x**2/2", "x**4/24"], "0"),
            ("exp(x)", ["1", "x", "x**2/2"], "0"),
            ("log(1 + x)", ["x", "-x**2/2", "x**3/3"], "0"),
            ("tanh(x)", ["x", "-x**3/3", "2*x**5/15"], "0"),
            ("sqrt(1 + x)", ["1", "x/2", "-x**2/8"], "0+"),
            ("log(x + 1)", ["log(x)", "1/x", "-1/(2*x**2)"], "oo"),
            ("sqrt(x**2 + x)", ["x", "1/2", "-1/(8*x)"], "oo"),
            ("x/(x - 1)", ["1", "1/x", "1/x**2"], "oo"),
            ("1/(1 + a*x)", ["1", "-a*x"], "0"),
        ]
    )
    count = r.randint(2, len(parts))
    chosen, true = parts[:count], True
    if r.random() < 0.6:
        true, n = False, r.randrange(1, count)
        chosen = [
            *chosen[:n],
            f"{r.choice(['3/2', '-1', '2', '99/100'])}*({chosen[n]})",
            *chosen[n + 1 :],
        ]
    given = " given a > 0" if "a*x" in f else ""
    return f"{f} ~ {' + '.join(chosen)}{given} as x -> {path}", true


# Polynomials with sign, abs, max and min


def _polynomial(r: random.Random, depth: int) -> tuple[str, Callable[[Any, Any], Any]]:
    """A piecewise polynomial in x and y, as text and for z3."""
    import z3

    if depth == 0:
        kind = r.choice(["x", "y", "number"])
        if kind == "number":
            n = r.choice([-3, -2, -1, 1, 2, 3])
            return f"({n})", lambda x, y: z3.RealVal(n)
        return kind, (lambda x, y: x) if kind == "x" else (lambda x, y: y)
    op = r.choice(["+", "-", "*", "+", "sign", "abs", "max", "min", "square"])
    f, one = _polynomial(r, depth - 1)
    if op == "square":
        return f"({f})**2", lambda x, y: one(x, y) * one(x, y)
    if op == "sign":
        return (
            f"sign({f})",
            lambda x, y: z3.If(one(x, y) > 0, 1, z3.If(one(x, y) < 0, -1, 0)) * z3.RealVal(1),
        )
    if op == "abs":
        return f"abs({f})", lambda x, y: z3.If(one(x, y) >= 0, one(x, y), -one(x, y))
    g, two = _polynomial(r, depth - 1)
    if op in ("max", "min"):

        def folded(x: Any, y: Any) -> Any:
            p, q = one(x, y), two(x, y)
            return z3.If(p >= q, p, q) if op == "max" else z3.If(p <= q, p, q)

        return f"{op}({f}, {g})", folded
    join = {"+": lambda p, q: p + q, "-": lambda p, q: p - q, "*": lambda p, q: p * q}[op]
    return f"(({f}) {op} ({g}))", lambda x, y: join(one(x, y), two(x, y))


RELATIONS: dict[str, Callable[[Any, Any], Any]] = {
    "==": lambda p, q: p == q,
    "!=": lambda p, q: p != q,
    ">": lambda p, q: p > q,
    ">=": lambda p, q: p >= q,
}
CONDITIONS: dict[str, Callable[[Any, Any], Any]] = {
    "": lambda x, y: True,
    "x > 0": lambda x, y: x > 0,
    "x >= 0": lambda x, y: x >= 0,
    "x > y": lambda x, y: x > y,
    "x >= 0, y >= 0": lambda x, y: (x >= 0, y >= 0),
    "x**2 + y**2 <= 1": lambda x, y: x * x + y * y <= 1,
    "x*y > 0": lambda x, y: x * y > 0,
    "x == y": lambda x, y: x == y,
    "x*y == 0": lambda x, y: x * y == 0,
    "x + y == 1": lambda x, y: x + y == 1,
}


def polynomials(r: random.Random) -> Claim:
    """A relation between piecewise polynomials, with the verdict of z3."""
    import z3

    x, y = z3.Reals("x y")
    f, one = _polynomial(r, r.choice([1, 2]))
    g, two = _polynomial(r, r.choice([1, 2]))
    if r.random() < 0.5:  # nearer to a true one
        h, three = g, two
        if r.random() < 0.5:
            g, two = f"({f})*sign({h})**2", lambda x, y: z3.If(three(x, y) == 0, 0, one(x, y))
        else:
            size = z3.If(three(x, y) >= 0, three(x, y), -three(x, y))
            g, two = f"({f}) - abs({h})", lambda x, y: one(x, y) - size
    relation, condition = r.choice(list(RELATIONS)), r.choice(list(CONDITIONS))
    solver = z3.Solver()
    solver.set("rlimit", 2_000_000)
    said = CONDITIONS[condition](x, y)
    for part in said if isinstance(said, tuple) else (said,):
        solver.add(part)
    solver.add(z3.Not(RELATIONS[relation](one(x, y), two(x, y))))
    found = solver.check()
    truth = None if found == z3.unknown else found == z3.unsat
    return with_conditions(f"{f} {relation} {g}", condition), truth


KINDS: tuple[Callable[[random.Random], Claim], ...] = (
    *(
        paths,
        coefficients,
        equations,
        holes,
        derivatives,
        ends,
        terms,
        polynomials,
        paths,
        equations,
    ),
)
TEST = "tests/exceptional_claims.py::claims"

if __name__ == "__main__":
    sys.exit(hunt.run(KINDS, TEST))
