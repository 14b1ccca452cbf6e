"""One claim in other spellings, which are generated: ``python tests/spellings.py [N [SEED]]``

A spelling says the same of the same points: sin(x) <= x given x >= 0 is 0 <= x - sin(x), is
2*sin(x) <= 2*x, and is sin(u**3) <= u**3 given u**3 >= 0. Claims of known truth are taken from the
lists of ``tests/data``, and each is spelled by one to three rewritings in a row that are chosen by
the seed. No spelling of a true claim may be refuted, and none of a false one may be granted; how
many are left open is counted. As a hunt of ``deep.py`` the chunk gives the seed.
"""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple
from zlib import crc32

import hunt

from tresym.reals.language.claims import Written, read_claim
from tresym.reals.language.expression import (
    LEAVES,
    Expr,
    fresh,
    opened,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.parsing import parse
from tresym.reals.language.typesetting import to_latex
from tresym.reals.numbers.exact import InputError

DATA = Path(__file__).parent / "data"
LONGEST = 110
"""Characters of the longest claim that is spelled: longer ones are mostly left open."""
_TRUTHS = {"true": True, "T": True, "HOLDS": True, "UNIFORM": True, "holds": True, "TRUE": True}
_TRUTHS |= {"false": False, "F": False, "FALSE": False, "refuted": False, "REFUTED": False}
_TRUTHS |= {"PROVED": True, "ENCLOSED": True}
_LINE = re.compile(rf"({'|'.join(_TRUTHS)}) (?:\| )?(.*)")
_MIRRORED = {"==": "==", "!=": "!=", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
_TREND = ("~", "->")
_ORDER = re.compile(r"(?<![A-Za-z])(?:[oO]|Theta|omega)\(")
_DISCRETE = re.compile(r"\b(factorial|binomial|sum|product|coefficient|integer|ZZ|floor|ceiling)\b")
_BOUND = re.compile(r"\b(diff|derivative|at)\b|'|\b(?![Oo]\()[a-zA-Z]\(")


class Known(NamedTuple):
    """A claim and whether it is true."""

    claim: str
    truth: bool


@cache
def known() -> tuple[Known, ...]:
    """Every claim of known truth in the lists that can be read and is not made of claims."""
    found: dict[str, bool] = {}
    for file in sorted(DATA.glob("**/*.txt")):
        truth: bool | None = None
        for line in file.read_text(encoding="utf-8").splitlines():
            said = _LINE.fullmatch(line)
            if line.startswith("["):
                truth = _TRUTHS.get(line.strip("[]")) if "checking" in file.parts else None
            elif said is not None:
                found[said[2].split(" | ")[0].strip()] = _TRUTHS[said[1]]
            elif truth is not None and line and " | " not in line and not line.startswith("#"):
                found[line] = truth
    return tuple(Known(*pair) for pair in found.items() if len(pair[0]) <= LONGEST)


class Claim(NamedTuple):
    """A claim in parts, as text: both sides, what is between them, conditions, path and region."""

    left: str
    relation: str
    right: str
    given: tuple[str, ...] = ()
    path: str = ""
    on: str = ""
    uniformly: bool = False

    def __str__(self) -> str:
        given = ", ".join(self.given)
        text = f"{self.left} {self.relation} {self.right}{given and f' given {given}'}"
        text += " uniformly" if self.uniformly else ""
        return f"{text}{self.path and f' as {self.path}'}{self.on and f' on {self.on}'}"


def parted(text: str) -> Claim | None:
    """The parts of a claim of one comparison; None for others and for what is not read."""
    try:
        written = read_claim(text)
    except InputError:
        return None
    if len(written.comparisons) != 1:
        return None
    return _in_parts(written)


def _in_parts(written: Written) -> Claim:
    left, relation, right = written.comparisons[0]
    given = tuple(chained([link]) for link in written.given)
    path = "" if written.path is None else str(written.path)
    return Claim(
        *(str(left), relation, str(right), given, path, chained(written.on), written.uniformly)
    )


def _names(c: Claim) -> list[str]:
    """The free variables, in the order of the alphabet."""
    sides = re.sub(r"\b[oO]\(", "(", f"({c.left}) + ({c.right})")
    try:
        return sorted(symbols(parse(sides)) - {"oo"})
    except InputError:
        return []


def _everywhere(c: Claim, write: Callable[[str], str]) -> Claim:
    """The claim with all its parts written otherwise, but for the path."""
    sides = write(c.left), c.relation, write(c.right)
    return c._replace(
        left=sides[0],
        right=sides[2],
        given=tuple(map(write, c.given)),
        on=write(c.on) if c.on else "",
    )


def _word(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w.]){re.escape(name)}(?!\w)")


Spelling = Callable[[Claim, random.Random], Claim | None]


def renamed(c: Claim, r: random.Random) -> Claim | None:
    """Call a variable by another letter."""
    whole = str(c)
    # In diff(f, x, n) n is an order, while y would be a variable; gamma may be the constant.
    names = [n for n in _names(c) if n != "gamma" and not re.search(rf"diff\(.*, {n}\)", whole)]
    free = [n for n in ("u", "v", "w", "q", "s", "alpha", "x_1", "rho", "e", "Z", "c") if n]
    free = [n for n in free if not _word(n).search(whole)]
    if not names or not free:
        return None
    name, other = r.choice(names), r.choice(free)
    new = _everywhere(c, lambda text: _word(name).sub(other, text))
    return new._replace(path=_word(name).sub(other, c.path))


def exchanged(c: Claim, r: random.Random) -> Claim | None:
    """Exchange the sides of a claim without a trend."""
    if c.relation in _TREND or _ORDER.search(c.right):
        return None
    return c._replace(left=c.right, relation=_MIRRORED[c.relation], right=c.left)


def _term(c: Claim, r: random.Random) -> str:
    """Something that is real wherever the variables are."""
    names = _names(c)
    terms = ["2", "1/3", "pi"]
    if names:
        x = r.choice(names)
        terms += [x, f"{x}**2", f"3*{x}/2", f"sin({x})"]
    return r.choice(terms)


def moved(c: Claim, r: random.Random) -> Claim | None:
    """Take a term, or the left side, from both sides."""
    if c.relation == "~" or (c.relation == "->" and r.random() < 2):
        return None
    if not _ORDER.search(c.right) and r.random() < 0.4:
        return c._replace(left="0", right=f"({c.right}) - ({c.left})")
    term = _term(c, r)
    return c._replace(left=f"{c.left} - {term}", right=f"{c.right} - {term}")


def multiplied(c: Claim, r: random.Random) -> Claim | None:
    """Multiply both sides by something positive, or by a negative number."""
    if c.relation == "->":
        factor = r.choice(["2", "3/7", "(-1)"])
        if "oo" in c.right:
            return None
        return c._replace(left=f"{factor}*({c.left})", right=f"{factor}*({c.right})")
    if r.random() < 0.3:
        relation = c.relation if c.relation == "~" else _MIRRORED[c.relation]
        return c._replace(left=f"-({c.left})", relation=relation, right=f"-({c.right})")
    factors = ["2", "3/7", "sqrt(2)"]
    for x in _names(c)[:2]:
        factors += [f"(1 + {x}**2)", f"exp(-{x})", f"(2 + cos({x}))"]
    factor = r.choice(factors)
    return c._replace(left=f"{factor}*({c.left})", right=f"{factor}*({c.right})")


def divided(c: Claim, r: random.Random) -> Claim | None:
    """Divide by the right side, for a trend without a sum: ~ claims each of its terms."""
    if c.relation != "~" or re.search(r" [+-] ", c.right):
        return None
    return c._replace(left=f"({c.left})/({c.right})", relation="->", right="1")


def in_one_function(c: Claim, r: random.Random) -> Claim | None:
    """Apply an increasing function of all reals to both sides."""
    if c.relation in _TREND or _ORDER.search(c.right):
        return None
    f = r.choice(["exp({})", "atan({})", "({})**3", "sinh({})", "({})/(1 + abs({}))"])
    return c._replace(left=f.replace("{}", c.left), right=f.replace("{}", c.right))


def by_absolute_value(c: Claim, r: random.Random) -> Claim | None:
    """Say of an equation that the distance is at most 0."""
    if c.relation != "==" or _ORDER.search(c.right):
        return None
    f = r.choice(["abs({})", "({})**2"])
    return c._replace(left=f.format(f"({c.left}) - ({c.right})"), relation="<=", right="0")


def in_another_variable(c: Claim, r: random.Random) -> Claim | None:
    """Put a one-to-one function of all reals for a real variable."""
    whole = str(c)
    names = [n for n in _names(c) if n not in c.path]
    if not names or _BOUND.search(whole) or _DISCRETE.search(whole):
        return None
    name = r.choice(names)
    new = r.choice(["(-{})", "(2*{})", "({} + 1)", "({} - 1/2)", "({}**3)", "sinh({})"])
    return _substituted(c, name, new.format(name))


def _substituted(c: Claim, name: str, new: str) -> Claim | None:
    value = parse(new)
    orders: list[str] = []

    def write(text: str) -> str:
        if re.search(r"==|!=|<|>|~", text):
            parts = re.split(r"(==|!=|<=|>=|<|>)", text)
            return "".join(p if n % 2 else f" {write(p)} " for n, p in enumerate(parts)).strip()
        if _ORDER.search(text):
            return _word(name).sub(f"({new})", text)
        return str(substitute(parse(text), {name: value}))

    try:
        return _everywhere(c, write) if not orders else None
    except InputError:
        return None


def along_another_path(c: Claim, r: random.Random) -> Claim | None:
    """Put 1/t, -t, 2*t or a + t for the variable that tends somewhere."""
    whole = str(c)
    tends = re.fullmatch(r"(\w+) -> (-?oo|[^+-]+)([+-]?)", c.path)
    if tends is None or _BOUND.search(whole) or _DISCRETE.search(whole):
        return None
    x, point, side = tends.groups()
    t = fresh("t", {*re.findall(r"\w+", whole)})
    if point == "oo":
        new, path = r.choice(
            [(f"1/{t}", "0+"), (f"-{t}", "-oo"), (f"2*{t}", "oo"), (f"{t}**2", "oo")]
        )
    elif point == "-oo":
        new, path = r.choice([(f"-{t}", "oo"), (f"1/{t}", "0-")])
    elif point == "0":
        other = {"+": "-", "-": "+", "": ""}[side]
        ways = [(f"-{t}", f"0{other}"), (f"3*{t}", f"0{side}"), (f"{t} - 1", f"1{side}")]
        ways += [(f"1/{t}", "oo" if side == "+" else "-oo")] if side else []
        ways += [(f"sinh({t})", f"0{side}"), (f"{t}**3", f"0{side}")]
        new, path = r.choice(ways)
    else:
        new, path = f"{point} + {t}", f"0{side}"
    found = _substituted(c, x, new)
    return None if found is None else found._replace(path=f"{t} -> {path}")


def gammas(c: Claim, r: random.Random) -> Claim | None:
    """Write n! of an integer as the gamma function, or the other way round."""
    whole = str(c)
    if "factorial(" not in whole:
        return None
    letters = {n for n in re.findall(r"factorial\((\w+)\)", whole) if not n.isdigit()}
    said = {f"{n} integer" for n in letters} - set(c.given)
    new = _everywhere(c, lambda text: re.sub(r"factorial\((\w+)\)", r"gamma(\1 + 1)", text))
    return new._replace(given=(*new.given, *sorted(said)))


DEFINITIONS: dict[str, tuple[str, ...]] = {
    "tan": ("sin({0})/cos({0})",),
    "sinh": ("(exp({0}) - exp(-({0})))/2",),
    "cosh": ("(exp({0}) + exp(-({0})))/2",),
    "tanh": ("(exp(2*({0})) - 1)/(exp(2*({0})) + 1)", "sinh({0})/cosh({0})"),
    "sin": ("cos(pi/2 - ({0}))", "2*sin(({0})/2)*cos(({0})/2)"),
    "cos": ("sin(({0}) + pi/2)", "1 - 2*sin(({0})/2)**2"),
    "asinh": ("log(({0}) + sqrt(({0})**2 + 1))",),
    "atanh": ("log((1 + ({0}))/(1 - ({0})))/2",),
    "acosh": ("log(({0}) + sqrt(({0}) - 1)*sqrt(({0}) + 1))",),
    "acos": ("pi/2 - asin({0})",),
    "atan": ("asin(({0})/sqrt(1 + ({0})**2))",),
    "exp": ("E**({0})", "1/exp(-({0}))"),
    "abs": ("sqrt(({0})**2)",),
    "erf": ("2/sqrt(pi)*integral(exp(-tau**2), tau, 0, {0})", "1 - erfc({0})"),
    "erfc": ("1 - erf({0})",),
    "sqrt": ("exp(log({0})/2)",),
}


def by_definition(c: Claim, r: random.Random) -> Claim | None:
    """Write a function by its definition, in every place or in one."""
    sides = f"{c.left} # {c.right}"
    there = sorted(name for name in DEFINITIONS if re.search(rf"\b{name}\(", sides))
    there = [name for name in there if name != "sqrt"]
    if not there:
        return None
    name = r.choice(there)
    form = r.choice(DEFINITIONS[name])
    one = r.random() < 0.5
    left, changed = _defined(c.left, name, form, one)
    right = c.right if one and changed else _defined(c.right, name, form, one)[0]
    return c._replace(left=left, right=right)


def _defined(text: str, name: str, form: str, one: bool) -> tuple[str, bool]:
    """Text with calls of a function written out: the calls end where their bracket closes."""
    done, out, at = False, "", 0
    for call in re.finditer(rf"\b{name}\(", text):
        if call.start() < at:
            continue
        end, depth = call.end(), 1
        while depth:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        out += text[at : call.start()] + f"({form.format(text[call.end() : end - 1])})"
        at, done = end, True
        if one:
            break
    return out + text[at:], done


def _binders(e: Expr, op: str) -> Iterator[Expr]:
    if e.op == op and not e.loose:
        yield e
    if e.op not in LEAVES:
        for arg in e.args:
            yield from _binders(arg, op)


def _rewritten(c: Claim, op: str, write: Callable[[Expr], str | None]) -> Claim | None:
    """The claim with one sum or integral of the left side written otherwise."""
    try:
        left = parse(c.left)
    except InputError:
        return None
    for node in _binders(left, op):
        new, old = write(node), str(node)
        if new is not None and old in c.left:
            return c._replace(left=c.left.replace(old, new, 1))
    return None


def reindexed(c: Claim, r: random.Random) -> Claim | None:
    """Count a sum from another place, or backwards, or by another letter."""
    how = r.choice(["later", "backwards", "first"])

    def write(node: Expr) -> str | None:
        (name,), body = opened(node, {*re.findall(r"\w+", str(c))} - {*node.names})
        first, last = node.args[1:]
        k = symbol(name)
        endless = "oo" in symbols(last) or str(last) == "oo"
        if how == "backwards" and not endless:
            back = substitute(body, {name: first + last - k})
            return f"sum({back}, {name}, {first}, {last})"
        if how == "first" and str(first).isdigit() and endless:
            one = substitute(body, {name: first})
            return f"(({one}) + sum({body}, {name}, {first + 1}, {last}))"
        later = substitute(body, {name: k - 1})
        end = "oo" if endless else last + 1
        return f"sum({later}, {name}, {first + 1}, {end})"

    return _rewritten(c, "sum", write)


def in_another_integral(c: Claim, r: random.Random) -> Claim | None:
    """Shift, mirror or halve the variable of an integral, or exchange its ends."""
    how = r.choice(["shift", "mirror", "scale", "ends"])

    def write(node: Expr) -> str | None:
        if len(node.names) != 1 or len(node.args) != 3:
            return None
        (name,), body = opened(node, {*re.findall(r"\w+", str(c))} - {*node.names})
        a, b = node.args[1:]
        far = [str(end) in ("oo", "-oo") for end in (a, b)]
        t = symbol(name)
        if how == "ends":
            return f"(-integral({body}, {name}, {b}, {a}))"
        if how == "mirror":
            ends = [{"oo": "-oo", "-oo": "oo"}.get(str(end), str(-end)) for end in (b, a)]
            return f"integral({substitute(body, {name: -t})}, {name}, {ends[0]}, {ends[1]})"
        if how == "scale":
            ends = [str(end) if out else str(end / 2) for end, out in zip((a, b), far, strict=True)]
            return f"integral(2*({substitute(body, {name: 2 * t})}), {name}, {ends[0]}, {ends[1]})"
        if far[0]:
            return None
        end = "oo" if far[1] else str(b - a)
        return f"integral({substitute(body, {name: a + t})}, {name}, 0, {end})"

    return _rewritten(c, "integral", write)


def in_latex(c: Claim, r: random.Random) -> Claim | None:
    """Typeset the comparison of a claim without the variable e, which is a number in print."""
    if _word("e").search(str(c)):
        return None
    try:
        said: tuple[Compared, ...] = read_claim(str(c)).comparisons
        text = to_latex(said)
    except InputError:
        return None
    return Claim(f"{text}", "", "", *c[3:])


def with_other_conditions(c: Claim, r: random.Random) -> Claim | None:
    """Say a condition twice, or with its sides exchanged, or multiplied."""
    plain = [n for n, link in enumerate(c.given) if re.fullmatch(r"[^<>=!]+ [<>]=? [^<>=!]+", link)]
    if not plain or "oo" in ", ".join(c.given):
        return None
    n = r.choice(plain)
    left, relation, right = re.split(r" ([<>]=?) ", c.given[n])
    new = r.choice(
        [
            f"{right} {_MIRRORED[relation]} {left}",
            f"3*({left}) {relation} 3*({right})",
            f"{left} - ({right}) {relation} 0",
            f"exp({left}) {relation} exp({right})",
        ]
    )
    given = [*c.given[:n], new, *c.given[n + 1 :]]
    r.shuffle(given)
    return c._replace(given=tuple(given))


SPELLINGS: tuple[Spelling, ...] = (
    *(renamed, exchanged, moved, multiplied, divided, in_one_function, by_absolute_value),
    *(in_another_variable, along_another_path, gammas, by_definition, reindexed),
    *(in_another_integral, with_other_conditions, in_latex),
)


MORE = (renamed, exchanged, moved, multiplied, with_other_conditions)


def spelled(spelling: Spelling, claim: str, r: random.Random) -> str | None:
    """A claim after this rewriting, and perhaps after others; None where it does not apply."""
    first = parted(claim)
    new = None if first is None else spelling(first, r)
    if new is None or new == first:
        return None
    for other in r.sample(MORE, r.choice([0, 0, 1, 2])):
        new = (None if spelling is in_latex else other(new, r)) or new
    return str(new)


def sample(spelling: Spelling, count: int, seed: int) -> list[tuple[str, bool]]:
    """Spellings of so many claims, which mostly stay the same where the lists grow."""
    found: list[tuple[str, bool]] = []
    for pair in sorted(known(), key=lambda pair: crc32(f"{seed} {pair.claim}".encode())):
        text = spelled(spelling, pair.claim, random.Random(f"{seed} {pair.claim}"))
        if text is not None:
            found.append((text, pair.truth))
        if len(found) == count:
            break
    return found


def _kind(spelling: Spelling) -> Callable[[random.Random], hunt.Claim]:
    def kind(r: random.Random) -> hunt.Claim:
        while True:
            pair = r.choice(known())
            text = spelled(spelling, pair.claim, r)
            if text is not None:
                return text, pair.truth

    kind.__name__ = spelling.__name__
    return kind


KINDS = tuple(map(_kind, SPELLINGS))
TEST = "tests/spellings.py::claims"

if __name__ == "__main__":
    sys.exit(hunt.run(KINDS, TEST))
