"""Random claims of limits, integrals, sums and the like: ``python tests/hunt.py [N [SEED]]``

Each claim is built together with its truth; N of them, 3000 unless told, are decided, and every
verdict that is wrong is printed. The counts of verdicts, by kind and truth, come at the end. As a
hunt of ``deep.py`` the chunk, of 500 claims, gives the seed.
"""

import random
import sys
import time
from collections import Counter
from collections.abc import Callable

import chunks

from tresym.checking.time_limited import Task, check_all
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import substitute
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

Claim = tuple[str, bool | None]
"""A text and whether it is true; None where nothing may be said but that it is not proved."""
LIMIT = 5.0


def rational(r: random.Random) -> str:
    return str(r.choice([1, 2, 3, 5, -1, -2, -3, "1/2", "-1/3", "3/2"]))


def moved(r: random.Random, text: str) -> str:
    """A value that is another one."""
    return f"({text}) + ({r.choice(['1', '-1', '1/7', '-1/100', '1/10**9'])})"


def shifted(text: str, name: str, value: str) -> str:
    """An expression with ``value`` in place of a variable."""
    return str(substitute(parse(text), {name: parse(value)}))


AT_ZERO = (
    *("sin({a}*x)/x:{a}", "(exp({a}*x) - 1)/x:{a}", "log(1 + {a}*x)/x:{a}", "tan({a}*x)/x:{a}"),
    *("(1 - cos({a}*x))/x**2:({a})**2/2", "(1 + {a}*x)**(1/x):exp({a})", "cos({a}*x):1"),
    *("(sqrt(1 + {a}*x) - 1)/x:({a})/2", "atan({a}*x)/x:{a}", "x + {a}:{a}", "exp({a}*x):1"),
    "(exp({a}*x) - 1 - ({a})*x)/x**2:({a})**2/2",
)
FROM_ABOVE = (
    *("x*log(x):0", "x**x:1", "exp(-1/x):0", "atan(1/x):pi/2", "sqrt(x):0", "x*sin(1/x):0"),
    *("tanh(1/x):1", "abs(x)/x:1", "log(x)*x**(1/2):0", "exp(-1/x)/x**3:0", "1/log(x):0"),
)


def limits(r: random.Random) -> Claim:
    one_sided = r.random() < 0.5
    f, value = "0", "0"
    for n in range(r.choice([1, 2, 2, 3])):
        part, v = r.choice(AT_ZERO + (FROM_ABOVE if one_sided else ())).split(":")
        a = rational(r)
        part, v = part.format(a=f"({a})"), v.format(a=f"({a})")
        how = r.choice("+*-") if n else "+"
        f, value = f"({f}) {how} ({part})", f"({value}) {how} ({v})"
    wrap = r.choice(["{}", "{}", "exp({})", "atan({})", "({})**2"])
    f, value = wrap.format(f), wrap.format(value)
    path = "x -> 0+" if one_sided else "x -> 0"
    if r.random() < 0.3:
        f, path = (
            str(parse(f.replace("x", "(x-2)").replace("e(x-2)p", "exp"))),
            path.replace("0", "2"),
        )
    elif one_sided and r.random() < 0.4:
        f, path = f.replace("x", "(1/x)").replace("e(1/x)p", "exp"), "x -> oo"
    true = r.random() < 0.5
    return f"{f} -> {value if true else moved(r, value)} as {path}", true


def one_sided_values(r: random.Random) -> Claim:
    """What has two limits, one of them or none."""
    a, c = r.choice("123"), rational(r)
    f, above, below = r.choice(
        [
            (f"{c} + {a}*abs(x)/x", f"{c} + {a}", f"{c} - {a}"),
            (f"{c} + atan({a}/x)", f"{c} + pi/2", f"{c} - pi/2"),
            (f"{c} + 1/(1 + exp({a}/x))", f"{c}", f"{c} + 1"),
            (f"{c} + sign(x**3)", f"{c} + 1", f"{c} - 1"),
        ]
    )
    path, value = r.choice(
        [("0+", above), ("0-", below), ("0", above), ("0", below), ("0+", below), ("0-", above)]
    )
    true = (path, value) in (("0+", above), ("0-", below))
    return f"{f} -> {value} as x -> {path}", true


def infinite(r: random.Random) -> Claim:
    sign, power = r.choice([1, -1]), r.choice([1, 2, 3])
    side = r.choice(["+", "-"])
    up = sign if side == "+" or power == 2 else -sign
    claimed = r.choice([1, -1])
    f = f"{sign}*{r.choice('123')}/x**{power} + {rational(r)}/sqrt(abs(x)) + {rational(r)}"
    return f"{f} -> {'-' * (claimed < 0)}oo as x -> 0{side}", up == claimed


def growth(r: random.Random) -> Claim:
    def scale() -> tuple[str, tuple[int, int, int]]:
        e, p, q = r.choice([0, 0, 1, -1]), r.randint(-2, 3), r.choice([0, 0, 1, 2])
        c = r.choice(["1", "2", "1/3", "5"])
        return f"{c}*exp({e}*x)*x**{p}*log(x)**{q}", (e, p, q)

    (f, one), (g, two) = scale(), scale()
    if r.random() < 0.3:
        g, two = f"7*({f}) + 1/x**9*exp(-2*x)", one
    kind = r.choice(["O", "o", "Theta", "omega", ">", "<"])
    truth = {
        **{"O": one <= two, "o": one < two, "Theta": one == two, "omega": one > two},
        **{">": one > two, "<": one < two},
    }[kind]
    if kind in "<>" and one == two:
        return f"{f} < 8*({f}) + 1 as x -> oo", True
    claim = f"{f} {kind} {g}" if kind in "<>" else f"{f} == {kind}({g})"
    return f"{claim} as x -> oo", truth


SMOOTH = (
    *("x**2", "x**3 - x", "exp(x)", "sin(x)", "cos(2*x)", "x*exp(-x)", "log(1 + x**2)", "atan(x)"),
    *("sqrt(1 + x**2)", "x*sin(x)", "exp(-x**2)", "1/(1 + x**2)", "x/(2 + cos(x))", "tanh(x)"),
)
BROKEN = (
    *("1/(x - {c})", "1/(x - {c})**2", "log(abs(x - {c}))", "atan(1/(x - {c}))", "sign(x - {c})"),
    *("tan(pi/2*(x - {c} + 1))", "atan(tan(pi/2*(x - {c} + 1)))", "abs(x - {c})/(x - {c})"),
)


def integrals(r: random.Random) -> Claim:
    a, b = r.choice([("0", "1"), ("-1", "2"), ("0", "pi"), ("1", "3"), ("2", "1"), ("-1/2", "1/2")])
    broken = r.random() < 0.25
    function = f"{rational(r)}*{r.choice(SMOOTH)} + {rational(r)}*{r.choice(SMOOTH)}"
    if broken:
        function += " + " + r.choice(BROKEN).format(c=f"(({a}) + ({b}))/2")
    F = parse(function)
    f = differentiate(F, "x")
    value = f"({function.replace('x', f'({b})').replace(f'e({b})p', 'exp')}) - "
    value += f"({function.replace('x', f'({a})').replace(f'e({a})p', 'exp')})"
    true = r.random() < 0.5
    claim = f"integral({f}, x, {a}, {b}) == {value if true else moved(r, value)}"
    return claim, (None if broken else true)


def improper(r: random.Random) -> Claim:
    a = r.choice(["1", "2", "3", "1/2", "a"])
    f, ends, value = r.choice(
        [
            ("exp(-{a}*x)", "0, oo", "1/{a}"),
            ("x*exp(-{a}*x)", "0, oo", "1/({a})**2"),
            ("1/(x**2 + ({a})**2)", "-oo, oo", "pi/{a}"),
            ("1/(x**2 + ({a})**2)", "0, oo", "pi/(2*{a})"),
            ("x**({a} - 1)", "0, 1", "1/({a})"),
            ("log({a}*x)", "0, 1", "log({a}) - 1"),
            ("1/sqrt({a}*x)", "0, 1", "2/sqrt({a})"),
            ("1/x**(1 + {a})", "1, oo", "1/({a})"),
            ("{a}/sqrt(1 - x**2)", "-1, 1", "{a}*pi"),
        ]
    )
    true = r.random() < 0.5
    f, value = f.format(a=f"({a})"), value.format(a=f"({a})")
    claim = f"integral({f}, x, {ends}) == {value if true else moved(r, value)}"
    return f"{claim} given a > 0" if a == "a" else claim, true


def divergent(r: random.Random) -> Claim:
    a = rational(r)
    f, ends = r.choice(
        [
            ("1/x", "-1, 1"),
            ("1/x**2", "-1, 1"),
            ("1/x", "1, oo"),
            ("1/x", "0, 1"),
            ("tan(x)", "0, pi"),
            ("1/(x**2 - 1)", "0, 2"),
            ("exp(x)", "0, oo"),
            ("cos(x)", "0, oo"),
            ("1/(x - 1)**3", "0, 2"),
            ("1/(x*log(x))", "0, 1/2"),
            ("log(x)/x", "0, 1"),
        ]
    )
    return f"integral({f}, x, {ends}) == {r.choice(['0', a, '-2', 'log(2)'])}", None


def totals(r: random.Random) -> Claim:
    c = r.choice(
        [
            *("n**2", "n**3 - n", "n*(n + 1)/2", "2**n", "n*2**n", "(-1)**n*n", "1/(n + 1)"),
            *("x**n", "n*x**n", "n/(n + 2)", "3**n - n", "(-1)**n", "a*n**2 + n", "1/(n + 1)**2"),
            *("sin(n*x)", "cos((2*n + 1)*x)", "log(n + 1)", "sqrt(n + 1)"),
        ]
    )
    total = r.random() < 0.75 or "x" in c or "a" in c
    scale = rational(r)
    form = f"({scale})*({c})" if total else f"1 + ({c})**2"
    here, before, start = (
        form.replace("n", f"({t})").replace(f"si({t})", "sin") for t in ("k", "k - 1", "0")
    )
    true = r.random() < 0.5
    error = r.choice(["1/3", "n", "n*(n - 1)", "(-1)**n", "n*(n - 1)*(n - 2)*(n - 3)"])
    extra = "" if true else f" + ({error})"
    if total:
        claim = f"sum(({here}) - ({before}), k, 1, n) == ({form}) - ({start}){extra}"
    else:
        claim = f"product(({here})/({before}), k, 1, n) == ({form})/({start}){extra}"
    given = " given n >= 1" + (", x > 0" if "x" in c and "(" not in c else "")
    return claim + given, true


def integers(r: random.Random) -> Claim:
    def turned(function: str, quarters: int) -> str:
        signs = {"sin": ("sin", "cos", "-sin", "-cos"), "cos": ("cos", "-sin", "-cos", "sin")}
        return f"{signs[function][quarters % 4]}(x)"

    function, k = r.choice(["sin", "cos"]), r.randint(0, 3)
    m = r.choice([1, 2, -1, 3])
    true = r.random() < 0.5
    right = turned(function, k if true else k + r.choice([1, 2, 3]))
    if r.random() < 0.5:
        left = f"{function}(x + {2 * m}*n*pi + {k}*pi/2)"
        return f"{left} == {right} given n integer", true
    factor = r.choice(
        ["(-1)**n", "cos(n*pi)", "(-1)**(3*n)", "(-1)**(n + 2)", "sin((2*n + 1)*pi/2)"]
    )
    left = f"{function}(x + {2 * m - 1}*n*pi + {k}*pi/2)"
    if r.random() < 0.3:
        true, factor = False, "(-1)**(2*n)"
    return f"{left} == {factor}*({right}) given n integer", true


def equations(r: random.Random) -> Claim:
    e, given = r.choice(
        [
            ("a + b + c - 1", ""),
            ("a*b - 1", ", a > 0"),
            ("a**2 + b**2 - 1", ""),
            ("2*a - b**2", ""),
            ("exp(a) - b", ", b > 0"),
            ("a**2 - b", ""),
            ("log(a) - b", ""),
            ("a*c - b", ", c != 0"),
            ("a - 1/2", ""),
        ]
    )
    forms = ["a", "b", "a*b", "a**2 + b", "b**3 - 2*a", "exp(b)", "(a - b)**2", "sin(a)"]
    first = f"{rational(r)}*({r.choice(forms)}) + {rational(r)}*({r.choice(forms)})"
    second = f"({first}) + ({e})*({r.choice(forms)})"
    kind = r.choice(["==", "==", ">=", ">"])
    true = r.random() < 0.5
    if kind == "==":
        return f"{first} == {second if true else moved(r, second)} given {e} == 0{given}", true
    square = f"{'' if true else '-'}({r.choice(forms)})**2"
    low = "" if true and kind == ">=" else " + 1" if true else " - 1/5"
    return f"{square}{low} + ({e})*({first}) {kind} 0 given {e} == 0{given}", true


def unknowns(r: random.Random) -> Claim:
    left, right = r.choice(
        [
            ("diff(f(x)*g(x), x)", "diff(f(x), x)*g(x) + f(x)*diff(g(x), x)"),
            ("diff(f(x)/g(x), x)", "(diff(f(x), x)*g(x) - f(x)*diff(g(x), x))/g(x)**2"),
            ("diff(f(x)**3, x)", "3*f(x)**2*diff(f(x), x)"),
            ("diff(exp(f(x)), x)", "exp(f(x))*diff(f(x), x)"),
            ("diff(f(3*x), x)", "3*at(diff(f(y), y), y, 3*x)"),
            ("(f(x) + g(x))**2", "f(x)**2 + 2*f(x)*g(x) + g(x)**2"),
            ("f(2*x - x)", "f(x)"),
            ("diff(log(f(x)), x)", "diff(f(x), x)/f(x)"),
            ("diff(f(x), x, 2)", "diff(diff(f(x), x), x)"),
        ]
    )
    true = r.random() < 0.5
    wrong = r.choice(["f(x)", "diff(f(x), x)", "f(-x)", "1/9", "f(x)*g(x)"])
    return f"{left} == {right}{'' if true else ' + ' + wrong}", true


KINDS: tuple[Callable[[random.Random], Claim], ...] = (
    *(limits, one_sided_values, infinite, growth, integrals, improper, divergent, totals),
    *(integers, equations, unknowns),
)


TEST = "tests/hunt.py::claims"


Kinds = tuple[Callable[[random.Random], Claim], ...]


def built(count: int, seed: int, kinds: Kinds) -> list[tuple[str, str, bool | None]]:
    """The kind, the text and the truth of random claims."""
    r = random.Random(seed)
    found = []
    for n in range(count):
        kind = kinds[n % len(kinds)]
        try:
            found.append((kind.__name__, *kind(r)))
        except InputError as error:
            print("not built:", kind.__name__, error)
    return found


def is_wrong(truth: bool | None, verdict: str) -> bool:
    """Whether a verdict contradicts the truth."""
    holds = verdict in (Verdict.PROVED.value, Verdict.ENCLOSED.value)
    return (holds and truth is not True) or (verdict == Verdict.REFUTED.value and truth is True)


def main(count: int, seed: int, kinds: Kinds, name: str, limit: float = LIMIT) -> int:
    """Decide random claims and print what is wrong; returns how many verdicts are."""
    asked, wrong = built(count, seed, kinds), 0
    counts: Counter[tuple[str, bool | None, str]] = Counter()
    answers = check_all((Task(text) for _, text, _ in asked), limit)
    for (kind, text, truth), (_, found) in zip(asked, answers, strict=True):
        said = "not read" if isinstance(found, InputError) else found.verdict.value
        counts[kind, truth, said] += 1
        if said == "not read":
            print("NOT READ", text, found)
        elif is_wrong(truth, said):
            wrong += 1
            print("WRONG", kind, truth, said, text, "|", found.why[:300], flush=True)
        elif "please report" in found.why or "was taken to be" in found.why:
            print("AT FAULT", truth, text, "|", found.why[:400], flush=True)
    for (kind, truth, said), number in sorted(counts.items(), key=str):
        print(f"{kind:22}{truth!s:7}{said:12}{number:6}")
    chunks.EXAMPLES[name] = counts.total()
    chunks.DECIDED[name] = sum(n for (_, _, said), n in counts.items() if said != "UNDECIDED")
    return wrong


def run(kinds: Kinds, test: str, alone: int = 3000, each: int = 500, limit: float = LIMIT) -> int:
    """What a script of such claims does: its exit status, 1 where a verdict is wrong.

    Args:
        kinds: what builds the claims.
        test: the name under which a chunk is recorded.
        alone: how many claims, where the command line does not say it.
        each: how many in a chunk.
        limit: seconds for each.
    """
    if test in chunks.done():
        return 0
    began = time.perf_counter()
    given = sys.argv[1:3] or ((each, 1 + chunks.CHUNK) if chunks.IN_CHUNKS else (alone, 1))
    count, seed = map(int, (*given, 1)[:2])
    failed = main(count, seed, kinds, test.rpartition("::")[2], limit)
    chunks.record(test, "failed" if failed else "passed", time.perf_counter() - began)
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(run(KINDS, TEST))
