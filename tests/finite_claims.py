"""Random claims of sums, products, integrals, integers, powers and unknown functions.

``python tests/finite_claims.py [N [SEED]]`` builds N claims, 300 unless told, together with their
truth, decides them and prints every wrong verdict; the counts come at the end. As a hunt of
``deep.py`` the chunk gives the seed. A true claim is put under any conditions; a false one is false
wherever both sides are defined, or is made true or false by the very conditions beside it.
"""

import random
import sys
from collections.abc import Callable
from functools import wraps

import hunt

Claim = tuple[str, str, bool | None]
"""A claim, its conditions, and whether it is true; None where it may not be proved."""
TEST = "tests/finite_claims.py::finite"
NONZERO = ("1", "-1", "1/7", "-1/1000", "(a**2 + 1)", "exp(b)", "1/10**9", "(2 + sin(a))", "pi")
"""What is added to make a claim false everywhere."""


def beside(r: random.Random, *more: str) -> str:
    """Conditions, some of them of no use."""
    pool = [
        *("a > 0", "0 < a <= 3", "a >= -2", "a != 1", "b < 5", "a**2 + b**2 < 9", "a == 3"),
        *("b == 2*a", "a + b == 1", "m integer", "m == 2*j, m integer, j integer", "b >= a"),
        *("m integer, m >= 2", "a*b != 0", "exp(a) > 1/2", "u > 1", "abs(b) <= 2", "a == b"),
    ]
    chosen = [c for c in more if c] + r.sample(pool, r.choice([0, 0, 1, 1, 2]))
    return ", ".join(chosen)


def wrong(r: random.Random, true: bool) -> str:
    return "" if true else f" + {r.choice(NONZERO)}"


def sums(r: random.Random) -> Claim:
    form = r.choice(
        [
            *(
                "{k}**2",
                "{k}**3 - {k}",
                "2**{k}",
                "{k}*2**{k}",
                "(-1)**{k}*{k}",
                "a*{k}**2 + b*{k}",
            ),
            *(
                "1/({k} + 1)",
                "x**{k}",
                "a**2*3**{k}",
                "{k}/({k} + 2)",
                "factorial({k})",
                "log({k} + 1)",
            ),
            *(
                "1/factorial({k})",
                "sin({k}*x)",
                "cos({k}*a)",
                "sqrt({k} + 1)",
                "(-1)**{k}/({k} + 1)",
            ),
        ]
    )
    here, before = (form.format(k=t) for t in ("k", "(k - 1)"))
    top, low = r.choice([("n", 1), ("n + 1", 1), ("n", 2), ("n", 3)])
    end = form.format(k="n" if top == "n" else "(n + 1)")
    true = r.random() < 0.5
    what = ["x > 0", "n >= 3", r.choice(["", "n integer", "n <= 50", "n != 7"])]
    error = wrong(r, true)
    if not true and r.random() < 0.4:
        error = r.choice(
            [" + (n - 3)*(n - 4)", " + n - 4", " + (-1)**n + 1", " + (n-3)*(n-5)*(n-7)"]
        )
    left = f"sum(({here}) - ({before}), k, {low}, {top})"
    return f"{left} == ({end}) - ({form.format(k=low - 1)}){error}", beside(r, *what), true


def products(r: random.Random) -> Claim:
    form = r.choice(
        ["{k} + 1", "2**{k}", "{k}**2 + 1", "({k} + 1)/({k} + 3)", "factorial({k})", "a**2 + {k}"]
    )
    here, before, end, start = (form.format(k=t) for t in ("k", "(k - 1)", "n", "0"))
    true = r.random() < 0.5
    claim = f"product(({here})/({before}), k, 1, n) == ({end})/({start})"
    return claim + wrong(r, true), beside(r, "n >= 1", "a != 0"), true


def undefined_terms(r: random.Random) -> Claim:
    low = r.choice([0, 1])
    j = low + r.randint(1, 3)
    term = r.choice(
        [
            *(
                "1/(k - {j})",
                "(k - {j})/(k - {j})",
                "sqrt(k - {j})**2",
                "log(k - {j}) - log(k - {j})",
            ),
            *("0/(k - {j})", "k/(k**2 - {j}**2)", "exp(log(k - {j}))", "asin(2 - k/k - 2*k) + k"),
        ]
    ).format(j=j)
    end, relation, right = r.choice(
        [
            ("n", "==", f"sum({term}, k, {low}, n)"),
            ("n", ">=", "-100 - n**2"),
            ("n", "==", "0"),
            ("n", "==", f"n*(n + 1)/2 - {j}*n"),
            ("n", "<", "100 + n**2"),
            ("n", "!=", "-100 - n"),
        ]
    )
    kind = r.choice(["sum", "sum", "product"])
    return f"{kind}({term}, k, {low}, {end}) {relation} {right}", beside(r, "n >= 5"), None


def integrals(r: random.Random) -> Claim:
    f, F = r.choice(
        [
            *(
                ("2*x", "{x}**2"),
                ("cos(x)", "sin({x})"),
                ("exp(x)", "exp({x})"),
                ("a*x", "a*{x}**2/2"),
            ),
            *(
                ("1/(1 + x**2)", "atan({x})"),
                ("3*x**2 - b", "{x}**3 - b*{x}"),
                ("sinh(x)", "cosh({x})"),
            ),
            *(("x*exp(x)", "({x} - 1)*exp({x})"), ("abs(x)", "{x}*abs({x})/2"), ("0*x + 1", "{x}")),
        ]
    )
    low, high = r.choice(
        [
            ("0", "a"),
            ("a", "b"),
            ("b", "a"),
            ("0", "1"),
            ("-a", "a"),
            ("a", "a"),
            ("1", "b**2"),
            ("a", "2*a"),
        ]
    )
    true = r.random() < 0.5
    above, below = (F.format(x=f"({end})") for end in (high, low))
    claim = f"integral({f}, x, {low}, {high}) == ({above}) - ({below})"
    return claim + wrong(r, true), beside(r), true


def infinite_integrals(r: random.Random) -> Claim:
    p = r.choice(["1", "2", "3/2", "1/2", "1/3"])
    diverges = p in ("1", "2", "3/2")
    bound, meets = r.choice(
        [("a > 0", False), ("a >= 0", True), ("0 < a <= 3", False), ("a >= 1", False)]
    )
    value = (
        r.choice(["oo", f"a**(1 - {p})/(1 - {p})", "1", "0"])
        if p != "1"
        else r.choice(["oo", "1", "log(a)"])
    )
    f = r.choice([f"1/x**({p})", f"(1 + 0*b)/x**({p})"])
    if value == "oo":
        true: bool | None = diverges and not meets
        if diverges and meets:
            true = None  # at a = 0 it is 0
    elif value.startswith("a**"):
        true = None if diverges else True
    else:
        true = None
    # other conditions may exclude a = 0, and make true what may not be proved
    given = bound if true is None else beside(r, bound)
    return f"integral({f}, x, 0, a) == {value}", given, true


def integers(r: random.Random) -> Claim:
    parity = r.choice(["even", "odd", "any", "real"])
    said = {
        **{"even": "n == 2*p, n integer, p integer", "odd": "n == 2*p + 1, n integer, p integer"},
        **{"any": "n integer", "real": "n > 1/2"},
    }[parity]
    left, right, when = r.choice(
        [
            ("cos(n*pi)", "1", ("even",)),
            ("cos(n*pi)", "-1", ("odd",)),
            ("sin(n*pi)", "0", ("even", "odd", "any")),
            ("sin(n*pi/2)", "0", ("even",)),
            ("cos(n*pi)**2", "1", ("even", "odd", "any")),
            ("cos(n*pi/2)", "0", ("odd",)),
            ("cos(2*n*pi + a)", "cos(a)", ("even", "odd", "any")),
            ("tan(a + n*pi)", "tan(a)", ("even", "odd", "any")),
            ("sin(a + n*pi)", "sin(a)", ("even",)),
            ("sin(n*pi)**2 + cos(n*pi)**2", "1", ("even", "odd", "any", "real")),
            ("f(cos(n*pi))", "f(1)", ("even",)),
            ("f(cos(n*pi)**2)", "f(1)", ("even", "odd", "any")),
            ("f(n*(n + 1))", "f(n + n**2)", ("even", "odd", "any", "real")),
            ("f(n)", "f(n + 1)", ()),
        ]
    )
    if parity in ("even", "odd", "any") and r.random() < 0.4:
        left, right, when = r.choice(
            [
                ("(-1)**n", "1", ("even",)),
                ("(-1)**n", "-1", ("odd",)),
                ("(-1)**(2*n)", "1", ("even", "odd", "any")),
                ("(-1)**n", "cos(n*pi)", ("even", "odd", "any")),
                ("(-1)**(n + 1)", "-(-1)**n", ("even", "odd", "any")),
                ("(-a)**n", "(-1)**n*a**n", ("even", "odd", "any")),
                ("(-a)**n", "a**n", ("even",)),
            ]
        )
    extra = r.choice(["", "", "n >= 3", "n > 0"])
    return f"{left} == {right}", beside(r, said, extra), parity in when


def integer_inequalities(r: random.Random) -> Claim:
    claim, least, said = r.choice(
        [
            ("n**2 > n", 2, "n integer"),
            ("2**n > n**2", 5, "n integer"),
            ("n**2 >= n", -99, "n integer"),
            ("n**3 > 2*n**2", 3, "n integer"),
            ("(n - 1)*(n - 2) >= 0", -99, "n integer"),
            ("factorial(n) > 2**n", 4, ""),
            ("sum(k, k, 1, n) > 10", 5, ""),
            ("product(k, k, 1, n) >= 24", 4, ""),
            ("n*(n - 1)*(n - 2)*(n - 3) != 0", 4, "n integer"),
            ("product(sin(k*pi/n), k, 1, n - 1) <= 1", 1, ""),
            ("sum(1/k**2, k, 1, n) <= 2 - 1/n", 1, ""),
        ]
    )
    start = r.choice([least, least + 1, least - 1, least - 2])
    if least == -99:
        return claim, beside(r, said, r.choice(["", "n > -5", "n < 9"])), True
    if least == 1:
        start = 1
    if start < 1:
        return claim, beside(r, said, f"n >= {least}"), True
    return claim, beside(r, said, f"n >= {start}"), start >= least


def unknowns(r: random.Random) -> Claim:
    left, right, true = r.choice(
        [
            ("f(a + b)", "f(b + a)", True),
            ("f(sqrt(a)**2)", "f(a)", True),
            ("f(a)*g(b)", "g(b)*f(a)", True),
            ("diff(f(x)*g(x), x)", "diff(f(x), x)*g(x) + f(x)*diff(g(x), x)", True),
            ("f((a + 1)**2)", "f(a**2 + 2*a + 1)", True),
            ("f(a)**2 - g(a)**2", "(f(a) - g(a))*(f(a) + g(a))", True),
            ("f(a)", "f(a + 1)", False),
            ("f(a)", "g(a)", False),
            ("f(a)*f(b)", "f(a*b) + 1/2*f(a)", False),
            ("f(a)**2", "f(a**2 + a + 9)", False),
            ("diff(f(x), x)", "f(x)", False),
            ("f(f(a))", "f(a) + 1", False),
        ]
    )
    if true and r.random() < 0.3:
        true, right = False, f"{right} + 1/3"
    return f"{left} == {right}", beside(r, r.choice(["", "x > 0", "a > 0"])), true


def nowhere(r: random.Random) -> Claim:
    """What has no point at which it is defined."""
    claim, given = r.choice(
        [
            ("f(sqrt(x)**2) == f(x)", "x < 0"),
            ("f(log(x)) == f(log(x))", "x <= 0"),
            ("f(1/(x - x)) == f(1/(x - x))", "x > 0"),
            ("f(acos(x)) - f(acos(x)) == 0", "x > 1"),
            ("sum(sqrt(x)**2, k, 1, n) == n*x", "x < 0, n >= 1"),
            ("sum(1/k, k, 0, n) == sum(1/k, k, 0, n)", "n >= 0"),
            ("sum(k*log(x), k, 1, n) == log(x)*n*(n + 1)/2", "x < 0, n >= 1"),
            ("product(sqrt(x)**2, k, 1, n) == x**n", "x < 0, n >= 1"),
            ("integral(sqrt(t)**2, t, a, a + 1) == a + 1/2", "a < -2"),
            ("integral(log(t), t, -2, -1) == 0*x", "x > 0"),
            ("sqrt(x)**2 == x", "x < 0"),
            ("(x**(1/2))**n == x**(n/2)", "x < 0, n integer"),
        ]
    )
    return claim, beside(r, given), None


def powers(r: random.Random) -> Claim:
    base = r.choice(["x", "x", "(x + y)", "(x - 1)", "x*y"])
    left, right, everywhere = r.choice(
        [
            ("{b}**p*{b}**q", "{b}**(p + q)", True),
            ("{b}**p/{b}**q", "{b}**(p - q)", True),
            ("({b}**p)**q", "{b}**(p*q)", False),
            ("({b}**2)**p", "{b}**(2*p)", False),
            ("sqrt({b}**(2*p))", "{b}**p", False),
            ("abs({b}**p)", "abs({b})**p", True),
            ("abs({b}**p)", "{b}**p", False),
            ("({b}**p)**2", "{b}**(2*p)", True),
            ("{b}**p*y**2", "y**2*{b}**p", True),
            ("({b}**p)**q + y", "{b}**(p*q) + y", False),
            ("({b}**p)**q*z", "{b}**(p*q)*z", False),
            ("{b}**p*abs({b})", "abs({b}**p)*{b}", False),
            ("{b}**p + z**q", "z**q + {b}**p", True),
        ]
    )
    b = base if base != "x*y" else "(x*y)"
    positive = r.random() < 0.4
    whole = r.random() < 0.3
    true = everywhere or positive
    if whole and not true:
        true = left in ("({b}**2)**p", "({b}**p)**q") or None  # with integers some hold
        if left == "({b}**p)**q" or left.startswith("({b}**p)**q"):
            true = True
    said = [f"{b} > 0" if positive else "", "p integer, q integer" if whole else ""]
    claim = f"{left.format(b=b)} == {right.format(b=b)}"
    if true and r.random() < 0.3:
        return claim + " + 1/5", beside(r, *said), False
    if true is None:
        return claim, beside(r, *said), None
    return claim, beside(r, *said), true


def equations(r: random.Random) -> Claim:
    e, given = r.choice(
        [
            *(("v - 2*w", ""), ("v*w - 1", "v > 0"), ("v**2 + w**2 - 1", ""), ("v**2 - w", "")),
            *(("v - 3", ""), ("exp(v) - w", "w > 0"), ("v + w + a", ""), ("v - w**2", "w integer")),
        ]
    )
    forms = ["v", "w", "v*w", "v**2 + w", "w**3 - 2*v", "(v - w)**2", "sin(v)", "exp(w)"]
    first = f"{r.choice(['2', '-1', '1/3'])}*({r.choice(forms)}) + ({r.choice(forms)})"
    true = r.random() < 0.5
    kind = r.choice(["==", "==", ">=", ">"])
    if kind == "==":
        claim = f"{first} == {first} + ({e})*({r.choice(forms)}){wrong(r, true)}"
    else:
        low = "" if true and kind == ">=" else "1" if true else "-1/5"
        claim = (
            f"{'' if true else '-'}({r.choice(forms)})**2 + ({low or 0}) + ({e})*({first}) {kind} 0"
        )
    return claim, beside(r, f"{e} == 0", given), true


def repeated(r: random.Random) -> Claim:
    f, g = r.choice(
        [
            ("exp(c*x)", "c**n*exp(c*x)"),
            ("sin(x)", "sin(x + n*pi/2)"),
            ("1/(1 - x)", "factorial(n)/(1 - x)**(n + 1)"),
            ("x*exp(x)", "(x + n)*exp(x)"),
            ("cos(2*x)", "2**n*cos(2*x + n*pi/2)"),
        ]
    )
    true = r.random() < 0.5
    error = "" if true else r.choice([" + 1", " + x**2 + 1", " + n*(n - 1)*exp(x)", "*2"])
    return f"diff({f}, x, n) == {g}{error}", beside(r, "c > 0", "n >= 1"), true


def series(r: random.Random) -> Claim:
    left, right, given = r.choice(
        [
            ("sum(z**k, k, 0, oo)", "1/(1 - z)", "abs(z) < 1"),
            ("sum(z**k, k, 1, oo)", "z/(1 - z)", "-1 < z, z < 1"),
            ("sum(k*z**k, k, 0, oo)", "z/(1 - z)**2", "abs(z) < 1/2"),
            ("sum(z**k/factorial(k), k, 0, oo)", "exp(z)", ""),
            ("sum((-1)**k*z**(2*k)/factorial(2*k), k, 0, oo)", "cos(z)", ""),
            ("sum(1/(k*(k + 1)), k, 1, oo)", "1", ""),
            ("sum((-1)**k/2**k, k, 0, oo)", "2/3", ""),
            ("sum(1/k**2, k, 1, oo)", "pi**2/6", ""),
        ]
    )
    true = r.random() < 0.5
    claim = f"{left} == {right}" + ("" if true else f" + {r.choice(['1', '1/7', '-1/1000'])}")
    if given == "abs(z) < 1" and r.random() < 0.2:
        return claim, "abs(z) < 2", None
    extra = r.choice(["", "", "z != 0", "z > -1/2"]) if "z" in left else ""
    return claim, ", ".join(c for c in (given, extra) if c), true


def as_text(kind: Callable[[random.Random], Claim]) -> Callable[[random.Random], hunt.Claim]:
    """The same claims with their conditions in one text."""

    @wraps(kind)
    def one(r: random.Random) -> hunt.Claim:
        claim, given, truth = kind(r)
        return f"{claim} given {given}" if given else claim, truth

    return one


KINDS: hunt.Kinds = (
    *map(as_text, (sums, products, undefined_terms, integrals, infinite_integrals, integers)),
    *map(as_text, (powers, integer_inequalities, unknowns, nowhere, equations, repeated, series)),
)


if __name__ == "__main__":
    sys.exit(hunt.run(KINDS, TEST, alone=300, each=300, limit=6.0))
