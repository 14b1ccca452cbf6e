"""Random limits and orders of known truth: ``python tests/asymptotic_claims.py [N [SEED]]``

As in ``hunt.py``, by whose means they are decided; of waves, parameters, integers, equations as
conditions, domains, integrals and sequences. A side is a product of a monomial, whose growth is
known, and of waves, whose zeros are: f = O(g) holds if no zero of g has a higher order than that of
f there and the monomial of f does not grow faster.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from fractions import Fraction

import hunt

Claim = tuple[str, bool | None]

PHASES = (
    *(("oo", "x"), ("oo", "x/3"), ("oo", "x**2"), ("oo", "sqrt(x)"), ("oo", "log(x)")),
    *(("oo", "pi*x"), ("oo", "x + 1"), ("0+", "1/x"), ("0", "1/x**2"), ("0-", "1/x"), ("-oo", "x")),
    *(("oo", "x*log(x)"), ("0+", "log(x)"), ("oo", "exp(x)")),
)
GROWTHS = {
    "oo": ("1", "log(x)", "sqrt(x)", "x", "x*log(x)", "x**2", "exp(x/2)", "exp(x)", "exp(x)*x"),
    "0+": ("exp(-1/x)", "x**2", "x", "sqrt(x)", "1", "1/x", "1/x**2", "exp(1/x)"),
}
"""From the slowest to the fastest."""


class Wave:
    """A product of powers of sines and cosines of multiples of one phase, and where it vanishes."""

    def __init__(self, r: random.Random, factors: int) -> None:
        self.parts = [
            (r.choice(["sin", "cos", "one"]), r.choice([1, 1, 2, 3]), r.choice([1, 1, 2, 3]))
            for _ in range(factors)
        ]

    def text(self, phase: str) -> str:
        shown = {"sin": "sin({})", "cos": "cos({})", "one": "(1 - cos({}))"}
        powers = (
            shown[kind].format(f"{k}*({phase})" if k > 1 else phase) + (f"**{m}" if m > 1 else "")
            for kind, k, m in self.parts
        )
        return "*".join(powers) or "1"

    def order(self, at: Fraction) -> int:
        """The order of the zero at π times ``at``."""
        zero: dict[str, Callable[[Fraction], int]] = {
            "sin": lambda u: int(u.denominator == 1),
            "cos": lambda u: int((u - Fraction(1, 2)).denominator == 1),
            "one": lambda u: 2 * int((u / 2).denominator == 1),
        }
        return sum(m * zero[kind](k * at) for kind, k, m in self.parts)

    def covers(self, other: Wave) -> bool:
        """Whether the quotient by the other is bounded."""
        return all(self.order(Fraction(k, 12)) >= other.order(Fraction(k, 12)) for k in range(24))


def around(r: random.Random) -> str:
    """A factor between positive bounds, or nothing."""
    return r.choice(["", "", "*(3 + sin(x))", "*(2 + cos(1/x)*sin(x)/2)", "*(1 + exp(-abs(1/x)))"])


def waves(r: random.Random) -> Claim:
    """Orders of monomials times waves of one phase, perhaps with one of another in both."""
    end, phase = r.choice(PHASES)
    side = "oo" if end in ("oo", "-oo") else "0+"
    signed = end in ("-oo", "0", "0-")
    growths = ("1", "x**2", "x**4") if end == "-oo" else GROWTHS[side]
    growths = ("x**4", "x**2", "1", "1/x**2") if end in ("0", "0-") else growths
    i, j = r.randrange(len(growths)), r.randrange(len(growths))
    j = i if r.random() < 0.5 else j
    one, two = Wave(r, r.choice([0, 1, 1, 2])), Wave(r, r.choice([0, 1, 1, 2]))
    if r.random() < 0.4:
        one.parts += two.parts
    f, g = growths[i] + "*" + one.text(phase), growths[j] + "*" + two.text(phase)
    if not signed and r.random() < 0.2 and phase in ("x", "x/3") and end == "oo":
        common = r.choice(["sin(sqrt(2)*x)", "cos(x**2)", "sin(log(x))"])
        f, g = f"{f}*{common}", f"{g}*{common}"
    kind = r.choice(["O", "O", "o", "omega", "Theta"])
    small, large = one.covers(two), two.covers(one)
    truth = {
        "O": i <= j and small,
        "o": i < j and small,
        "omega": j < i and large,
        "Theta": i == j and small and large,
    }[kind]
    return f"{r.choice('123')}*{f} == {kind}({g}) as x -> {end}", truth


def identities(r: random.Random) -> Claim:
    """What waves of one phase are equal to."""
    end, phase = r.choice(PHASES)
    left, right = r.choice(
        [
            ("sin(2*u)", "2*sin(u)*cos(u)"),
            ("1 - cos(2*u)", "2*sin(u)**2"),
            ("sin(3*u)", "3*sin(u) - 4*sin(u)**3"),
            ("sin(u)**2 + cos(u)**2", "1"),
            ("cos(u)**2 - sin(u)**2", "cos(2*u)"),
            ("(1 + cos(u))*(1 - cos(u))", "sin(u)**2"),
            ("sqrt(sin(u)**2)", "abs(sin(u))"),
            ("sin(u + pi/3)", "sin(u)/2 + sqrt(3)/2*cos(u)"),
            ("tan(u)*cos(u)", "sin(u)"),
        ]
    )
    true = r.random() < 0.5
    small = r.choice(["x", "1", "x**2"]) if end in ("oo", "-oo") else r.choice(["1", "1/x**2"])
    wrong = r.choice([f"2*({right})", f"({right}) + 1/3", f"({right})*cos({phase})", "7/8"])
    left, right, wrong = (
        t.replace("(u", f"(({phase})").replace("*u", f"*({phase})") for t in (left, right, wrong)
    )
    shown = right if true else wrong
    form = r.choice(
        [
            "({s})*({f}) ~ ({s})*({g}) as x -> {e}",
            "({s})*(({f}) - ({g})) -> 0 as x -> {e}",
            "({f}) - ({g}) == o({z}) as x -> {e}",
        ]
    )
    tiny = "exp(-abs(x))" if end in ("oo", "-oo") else "x**4"
    return form.format(s=small, f=left, g=shown, e=end, z=tiny), true


def domains(r: random.Random) -> Claim:
    """Sides that are real in places, or on one side alone."""
    end, phase = r.choice(PHASES)
    if r.random() < 0.5:
        c = Fraction(r.choice([-3, -1, 1, 2]), 4)
        root = r.choice(["sqrt({})", "({})**(3/2)", "log({})*({})"])
        inner = f"sin({phase}) - ({c})"
        f = root.replace("{}", inner)
        g, kind = r.choice([("sin({p})", "zero"), ("1", "one"), ("2 + sin({p})", "one")])
        true = c > 0 or kind == "one"  # sin is away from 0 where the root is real
        return f"{f} == O({g.format(p=phase)}) as x -> {end}", true
    f, value = r.choice(
        [
            *(("sqrt(x)", "0"), ("x*log(x)", "0"), ("sqrt(x)*sin(1/x)", "0"), ("x**(3/2)/x", "0")),
            *(("log(1 + sqrt(x))/sqrt(x)", "1"), ("acos(1 - x)/sqrt(x)", "sqrt(2)")),
            *(("sqrt(-x)", "0"), ("sqrt(x**2 + x)/sqrt(x)", "1"), ("exp(-1/sqrt(x))", "0")),
            *(("sqrt(x)/sqrt(sin(x))", "1"), ("x**2*log(-x)", "0"), ("(1 + x)**(1/sqrt(x))", "1")),
        ]
    )
    true = r.random() < 0.5
    at = r.choice(["0", "1", "-2", "pi"])
    f = hunt.shifted(f, "x", f"x - ({at})")
    return f"{f} -> {value if true else hunt.moved(r, value)} as x -> {at}", true


def integers(r: random.Random) -> Claim:
    """Powers, exponentials and waves with an integer parameter."""
    low, m = r.randint(-2, 3), r.randint(-2, 4)
    bound = r.choice([f"n >= {low}", f"n > {low} - 1", f"n > {low} - 1/2", f"2*n > {2 * low - 1}"])
    given = f"n integer, {bound}"
    if r.random() < 0.25:
        given += r.choice([", b > 0", ", m integer", f", n < {low + 9}"])
    kind = r.randrange(6)
    if kind == 0:
        return f"x**n == O(x**({m})) as x -> 0+ given {given}", low >= m
    if kind == 1:
        return f"exp(-n*x) == o(exp(-({m})*x)) as x -> oo given {given}", low > m
    if kind == 2:
        k = r.randint(1, 3)
        f = r.choice(["sin(n*x)", "tan(n*x)", "sin(n*x)*cos(x)", "cos(n*x + pi/2)", "sin(2*n*x)"])
        half = f == "sin(2*n*x)" and r.random() < 0.5
        true = r.random() < 0.5
        end = f"{k}*pi/2" if half else f"{k}*pi"
        return f"{f} -> {'0' if true else hunt.moved(r, '0')} as x -> {end} given {given}", true
    if kind == 3:
        true = r.random() < 0.5
        value = r.choice(["1", "(-1)**(2*n)"]) if true else r.choice(["-1", "0", "2"])
        return f"cos(2*n*x) -> {value} as x -> pi given {given}", true
    if kind == 4:
        return f"x**n -> 0 as x -> 0 given {given}", low > 0
    f = r.choice(["(-1)**n*x", "cos(n*pi)*x", "x + sin(n*pi)", "x*cos(2*n*pi)"])
    g, true = r.choice([("x", True), ("x**2", False), ("abs(x)", True), ("x/9", True)])
    return f"{f} == O({g}) as x -> 0 given {given}", true


def sequences(r: random.Random) -> Claim:
    """Claims on the integers n → oo."""
    growths = ("1/2**n", "1/n**2", "1/n", "1", "log(n)", "n", "n**2", "2**n")
    i, j = r.randrange(8), r.randrange(8)
    turn, parity = r.choice(
        [
            *(("(-1)**n", -1), ("cos(n*pi)", -1), ("cos(2*n*pi)", 1), ("(-1)**(2*n)", 1)),
            *(("(-1)**(3*n + 1)", -1), ("(2 + (-1)**n)", 2), ("sin((2*n + 1)*pi/2)", -1)),
            *(("sin(n*pi)", 0), ("(1 + sin(3*n*pi))", 1)),
        ]
    )
    f, end = f"{turn}*{growths[i]}", "as n -> oo given n integer"
    kind = r.choice(["O", "o", "->", "oo", ">", "~"])
    if kind in "Oo" and kind != "oo":
        true = parity == 0 or (i <= j if kind == "O" else i < j)
        return f"{f} == {kind}({growths[j]}) {end}", true
    if kind == "->":
        return f"{f} -> 0 {end}", parity == 0 or i < 3
    if kind == "oo":
        return f"{f} -> oo {end}", parity > 0 and i > 3
    if kind == ">":
        return f"{f} > 0 {end}", parity > 0
    return f"{f} ~ {growths[i]} {end}", parity == 1


EQUATIONS = (
    *(("a == 3", "a", "3"), ("a == 1/2", "a", "1/2"), ("a + b == 3, b == 1", "a", "2")),
    *(("a - 2*b == 0, b == 2", "a", "4"), ("a**2 == 4, a > 0", "a", "2"), ("2*a == b", "a", "b/2")),
    *(("a*b == 6, b == 3", "a", "2"), ("exp(a) == 2", "a", "log(2)"), ("a == b + 1", "a", "b + 1")),
    *(("a + b == 1", "a", "1 - b"), ("a == c, c == 5", "a", "5"), ("a**3 == 8", "a", "2")),
)
FORMS = (
    *(("sin(a*x)/x", "a"), ("(exp(a*x) - 1)/x", "a"), ("(1 + a*x)**(1/x)", "exp(a)")),
    *(("a*x + a", "a"), ("(1 - cos(a*x))/x**2", "a**2/2"), ("log(1 + a*x)/x", "a")),
    *(("a*cos(x) + x*sin(1/x)", "a"), ("tan(a*x)/(2*x)", "a/2"), ("atan(a*x)/x + 1", "a + 1")),
    ("(sin(a*x) - a*x)/x**3", "-a**3/6"),
)


def equations(r: random.Random) -> Claim:
    """Limits under equations, by their value and with the equations used on the right side."""
    given, name, value = r.choice(EQUATIONS)
    f, limit = r.choice(FORMS)
    put = hunt.shifted(limit, name, value)
    true = r.random() < 0.5
    shown = r.choice([limit, put])
    if r.random() < 0.3:
        given += r.choice([", w > 0", ", w == 7", ", m integer"])
    return f"{f} -> {shown if true else hunt.moved(r, shown)} as x -> 0 given {given}", true


def parameters(r: random.Random) -> Claim:
    """Limits and orders with parameters under inequalities, some of no use."""
    unused = r.choice(["", ", b > 0", ", b integer", ", 0 < b < 1", ", b == 2", ", b != c"])
    if r.random() < 0.4:
        f, limit = r.choice(FORMS)
        true = r.random() < 0.5
        return (
            f"{f} -> {limit if true else hunt.moved(r, limit)} as x -> 0 given a != 0{unused}",
            true,
        )
    low = r.choice([0, 1, -1])
    f, kind, g, truth = r.choice(
        [
            ("a*x", "->", "oo", low >= 0),
            ("x**a", "O", "x", False),
            ("exp(-a*x)", "->", "0", low >= 0),
            ("a*x*sin(x)", "O", "x", True),
            ("a*x + x*sin(x)", ">", "0", low >= 1),
            ("x**a*exp(-x)", "->", "0", True),
            ("sin(a*x)", "O", "1", True),
            ("sin(2*a*x)", "O", "sin(a*x)", True),
            ("log(x)**a", "o", "x", True),
            ("x + a", "~", "x", True),
            ("a*x", "~", "x", False),
            ("sin(x + a)", "O", "sin(x)", False),
        ]
    )
    right = g if kind in ("->", "~", ">") else f"{kind}({g})"
    relation = kind if kind in ("->", "~", ">") else "=="
    return f"{f} {relation} {right} as x -> oo given a > {low}{unused}", truth


def eventually(r: random.Random) -> Claim:
    """Inequalities of monomials and waves from somewhere on."""
    end, phase = r.choice([p for p in PHASES if p[0] in ("oo", "0+")])
    growths = GROWTHS[end]
    i, j = r.randrange(len(growths)), r.randrange(len(growths))
    j = i if r.random() < 0.6 else j
    a, b = r.choice([1, 2, 3]), r.choice([1, 2, 3])
    wave = r.choice(["sin({})", "cos({})", "sin(2*({}))", "-cos({})"]).format(phase)
    relation = r.choice([">", ">=", "<", "!="])
    larger = i > j or (i == j and a > b)
    touches = i == j and a == b
    truth = {">": larger, ">=": larger or touches, "<": False, "!=": larger}[relation]
    return f"{a}*{growths[i]} + {b}*{growths[j]}*{wave} {relation} 0 as x -> {end}", truth


def integrals(r: random.Random) -> Claim:
    """Limits of integrals over what shrinks to a point, or of known antiderivatives."""
    f, at = r.choice(
        [
            ("exp(t**2)", "0:1"),
            ("cos(w*t)", "0:1"),
            ("sqrt(1 + t**4)", "0:1"),
            ("exp(t)/(1 + t)", "0:1"),
            ("1/(2 + cos(t))", "0:1/3"),
            ("t**2 + w", "1:1 + w"),
            ("sin(t)**2", "pi/2:1"),
            ("log(t)", "1:0"),
        ]
    )
    point, value = at.split(":")
    c = r.choice([1, 2, 3])
    true = r.random() < 0.5
    end = f"{point} + {c}*(x - ({point}))"
    value = f"{c}*({value})"
    claim = f"integral({f}, t, {point}, {end})/(x - ({point})) -> "
    return f"{claim}{value if true else hunt.moved(r, value)} as x -> {point}", true


KINDS: tuple[Callable[[random.Random], Claim], ...] = (
    *(waves, waves, identities, domains, integers, sequences, equations, parameters, eventually),
    integrals,
)
TEST = "tests/asymptotic_claims.py::claims"

if __name__ == "__main__":
    sys.exit(hunt.run(KINDS, TEST))
