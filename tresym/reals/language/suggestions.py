"""Suggest what to write instead of text that cannot be parsed."""

from __future__ import annotations

import keyword
import re
from difflib import get_close_matches

MAX_TEXT = 300
_OUTSIDE = frozenset(
    (
        *("conjugate", "re", "im"),
        *("mod", "gcd", "lcm", "isprime", "rand", "random"),
    )
)
_FORMS = {
    **dict.fromkeys(
        ("integrate", "int", "integral", "Integral"), "integral(f, x, a, b), or integral(f, x) == F"
    ),
    **dict.fromkeys(("sum", "Sum", "summation"), "sum(f, k, 1, n)"),
    **dict.fromkeys(("product", "Product", "prod"), "product(f, k, 1, n)"),
    **dict.fromkeys(("limit", "lim", "Limit"), "limit(f, x, a), at one side limit(f, x, a, 1)"),
    **dict.fromkeys(("erfinv", "inverse_erf"), "the inverse y as a condition: erf(y) == x"),
    **dict.fromkeys(("erfcinv", "inverse_erfc"), "the inverse y as a condition: erfc(y) == x"),
    "max": "max(a, b) of two or more arguments",
    "min": "min(a, b) of two or more arguments",
    "coefficient": "coefficient(f, z, n), the coefficient of z**n",
    "root": "root(f, x, a, b), the zero of f between a and b",
    **{"factorial": "factorial(n)", "binomial": "binomial(n, k)", "derivative": "diff(f, x)"},
}
"""How to write operations that bind a variable, and functions of integers."""
_SLIPS: tuple[tuple[str, str], ...] = (
    (r"^\s*\w[\w.]*\s*:(?!=)", "labels are for files of claims; write the claim alone"),
    (
        r"^\s*\w+\s+(natural|positive|integer|real)\s*$",
        "this declares a variable: write CLAIM given n integer, n >= 1",
    ),
    (r"\bd\s*/\s*d[a-z]\b|\w'", "a derivative is written diff(f, x)"),
    (r"\bapprox(?:imately)?\b", "write abs(a - b) <= 0.005, or a ~ b with a path"),
    (r"->\s*$", "the path has no end: write as x -> 0"),
    (r"^\s*not\b", "write the contrary, such as x <= 0 for not x > 0"),
    (r"[-+*/^]\s*$", "something is missing after its last sign"),
    (r"[=<>!]\s*$|^\s*[=<>]", "one side of the comparison is missing"),
    (r"<>", "write !="),
    (r"=>", "write >=, or CLAIM given CONDITION"),
    (r"=<", "write <="),
    (r":=", "write =="),
    (r"\*{4}|\^\^", "write one ^ or **"),
    (r"\d\s*%", "write a percentage as a fraction"),
    (r"!(?!=)", "a factorial is written n! or factorial(n)"),
    (r";", "conditions are separated by commas"),
    (r"&&|\|\|", "conditions are separated by commas, claims go one by one"),
    (r"->", "a path goes after the word as, or to --as"),
    (r"\bgiven\s*$", "conditions are missing after the word given"),
    (r"^\s*given\b", "a claim is missing before the word given"),
    (r"\b(for all|forall|for|if|when|where|with)\b", "write the conditions after the word given"),
    (r"[\[{]", "use parentheses"),
    (r"(?<![=<>!])=(?!=)", "a condition uses one of > >= < <= !="),
)
_NAME = re.compile(r"[A-Za-z_]\w*")
_PRODUCT = re.compile(
    r"(?<![\w.])(\d+(?:\.\d*)?)\s*([A-Za-z_]\w*|\()|(\))\s*(\w+|\()|([A-Za-z_]\w*)\s+(\w+|\()"
)


def hint(text: str, functions: frozenset[str]) -> str:
    """Return advice on text that is not an expression, in parentheses after a space, or ""."""
    found = _advice(text[:MAX_TEXT], functions) or _parentheses(text)
    return f" ({found})" if found else ""


def _advice(text: str, functions: frozenset[str]) -> str:
    for pattern, advice in _SLIPS:
        if re.search(pattern, text):
            return advice
    power = re.search(r"\b([a-z]+)\s*\*\*\s*(?:\(?-\s*1\)?|\w+)\s*\(", text)
    if power and power[1] in functions:
        return f"a power of a function is {power[1]}(x)**2, its inverse a{power[1]}(x)"
    for word in _NAME.findall(text):
        if keyword.iskeyword(word) and word not in ("and", "or", "not", "in", "is"):
            return f"{word} cannot be a name; {word}_ can"
    for match in _PRODUCT.finditer(text):
        if match[3]:
            return f"write * between factors: (…)*{match[4]}"
        first, second = (part for part in match.groups() if part)
        if first in functions:
            return f"arguments go in parentheses: {first}({second})"
        if first != "(" and not keyword.iskeyword(second):
            return f"write * between factors: {first}*{second}"
    return ""


def _parentheses(text: str) -> str:
    """Return a message about a parenthesis without a partner, or ""."""
    opened: list[int] = []
    for i, character in enumerate(text):
        if character == "(":
            opened.append(i)
        elif character == ")":
            if not opened:
                return f"the parenthesis that closes at character {i + 1} was not opened"
            opened.pop()
    return f"the parenthesis at character {opened[-1] + 1} is not closed" if opened else ""


def about_function(name: str, known: frozenset[str]) -> str:
    """Return advice about an unknown function."""
    if name in _FORMS:
        return f"write {_FORMS[name]}"
    if name in _OUTSIDE:
        return f"{name} is not supported"
    if re.fullmatch(r"log_?\d+", name):
        return f"write log(x, {name.lstrip('log_')}) for {name}(x)"
    if name in ("O", "o"):
        return f"{name}(…) stands at the right end of a claim, as in f == g + {name}(h)"
    if len(name) == 1:
        return f"{name} is not a function; for a product write {name}*(…)"
    near = get_close_matches(name, sorted(known), 1, 0.75)
    return f"did you mean {near[0]}?" if near else _SOME


_SOME = (
    "known functions are abs, sqrt, cbrt, exp, log, sin and its kin, sinh and its kin, asin, "
    "atan2, max, min, sign, gamma, zeta, erf, Ei, Si, besselj, airyai, elliptic_k, lambertw, "
    "polylog, integral, sum, product, limit, root, factorial, binomial and others (page Functions)"
)
"""Shown where no known name is near."""


def about_name(name: str) -> str:
    """Return advice about a function without its argument."""
    return f"{name} needs its argument, as in {name}(x); a power of it is {name}(x)**2"
