r"""Rewrite notation that only looks different: ``\sum^n_{k=0}``, ``\dot{x}_1``, ``\mathrm{e}^x``.

Physicists write the same real quantity in many ways: a subscript behind the braces of an accent,
the upper limit of a sum first, ``v^+`` for the value behind a shock, macros of the packages physics
and commath without their packages. Each is rewritten to the form that the reader knows, before a
formula is taken apart. What a formula means is never changed here.

Example:
    >>> from tresym.manuscript.notation import plain_notation
    >>> plain_notation(r"\sum^{n}_{k=0} \dot{x}_1 \enskip v^+")
    '\\sum_{k=0}^{n} \\dot{x_1}   v_{plus}'
"""

from __future__ import annotations

import re

from tresym.manuscript.macros import group
from tresym.manuscript.units import in_one_system
from tresym.reals.numbers.exact import InputError

_WIDE = re.compile(r"(?:\\[;:,> ]\s*|~\s*){4,}")
"""Spaces that set two formulas apart."""
_SPELLED = re.compile(
    r"(?P<before>\\[;:,> ]\s*|~|\\q?quad\s*)(?P<word>for|if|when|where|and|or|with)\s*"
    r"(?=\\[;:,> ]|~|\\q?quad)"
)
"""Words in italic letters between spaces, ``\\;for\\; x > 0``."""
_SPACES = re.compile(r"\\(?:>|enskip(?![a-zA-Z])|thinspace(?![a-zA-Z])|medspace(?![a-zA-Z])|:)")
_EMPTY = re.compile(r"(?<![_^a-zA-Z}\]])\{\s*\}")
_CANCELLED = re.compile(r"\\(?:b|x)?cancel(?![a-zA-Z])")
_WORDS = re.compile(r"\\mathit\s*\{\s*((?:[^{}~\\]*~[^{}\\]*)|(?:if|for|and|or|otherwise)\s*)\}")
_ITALIC = re.compile(r"\\(?:mathit|mathnormal)\s*\{\s*([a-zA-Z])([a-zA-Z]*)\s*\}")
_GREEK = re.compile(r"\\(?:mathit|mathnormal)\s*\{\s*(\\[a-zA-Z]+)\s*\}")
_BRACED_DIFFERENTIAL = re.compile(
    r"(?<![a-zA-Z\\}])(?<!frac)(?<!frac )(?:d|\\mathrm\s*\{\s*d\s*\})\s*\{\s*"
    r"([a-zA-Z]|\\[a-zA-Z]+)\s*\}"
)
_UPPER_BEHIND = re.compile(r"(?<=\])\s*\^")
_BOLD_NUMBER = re.compile(r"\\(?:boldsymbol|mathbf|bm)\s*\{\s*(-?[\d.]+)\s*\}")
_POWER_FIRST = re.compile(
    r"(?<![a-zA-Z\\])([a-zA-Z]|\\[a-zA-Z]+)\s*\^\s*(\d|\{\s*\d+\s*\})\s*_\s*(\w|\{[^{}]*\})"
)
_VARIANT = re.compile(
    r"\\var(Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Upsilon|Phi|Psi|Omega)(?![a-zA-Z])"
)
_LETTER = r"(?:[a-zA-Z]|\\[a-zA-Z]+)"
_ACCENTED = re.compile(
    rf"\\(dot|ddot|tilde|hat|bar|overline|widehat|widetilde)\s*\{{\s*({_LETTER})\s*\}}"
    r"\s*_\s*(\{[^{}]*\}|[a-zA-Z0-9])"
)
_SHOCK = re.compile(
    rf"(?<![a-zA-Z\\])({_LETTER})\s*(?:_\s*(\w|\{{\w+\}}))?\s*\^\s*(?:\{{\s*([+-])\s*\}}|([+-]))"
    r"(?=\s*(?:[-+=)\]}},;.&|<>^(/]|\\(?!infty)|\$|\Z|[a-zA-Z]))"
)
_UPPER_FIRST = re.compile(r"\\(sum|prod|int|iint|oint)(?![a-zA-Z])\s*(?:\\limits\s*)?\^")
_AND = re.compile(
    r"(\\q?quad(?![a-zA-Z])|\\[ ,;])\s*\\(?:text|mbox|textrm|mathrm)\s*"
    r"\{\s*(?:e|et|und|y|i|ed)\s*\}"
    r"(?=\s*(?:\\q?quad(?![a-zA-Z])|\\[ ,;]))"
)
"""The word "and" of other languages between two formulas."""
_EULER = re.compile(r"\\(?:mathrm|text|textrm|operatorname|mathup)\s*\{\s*e\s*\}")
_PARTIAL = re.compile(r"\\pd(?![a-zA-Z])(?!\s*[\[{*])")
_DIFFERENTIAL = re.compile(r"\\(?:dif|dd|diff)(?![a-zA-Z])\s*")
_DERIVATIVE = re.compile(
    r"\\(dv|od|pdv|pd|odv)(?![a-zA-Z])\s*\*?\s*(?:\[\s*([1-9])\s*\])?\s*(?=\{)"
)
_NAMED_BEHIND = re.compile(
    rf"(?<![a-zA-Z\\])({_LETTER})\s*(?:_\s*(\w|\{{\w+\}}))?\s*(\([^()]{{1,20}}\))\s*_\s*"
    r"(?:\\(?:mathrm|text|textrm|rm)\s*\{\s*([a-zA-Z]{2,8})\s*\}"
    r"|\{\s*\\(?:mathrm|text|textrm|rm)\s*\{?\s*([a-zA-Z]{2,8})\s*\}?\s*\}|([LR])(?![a-zA-Z]))"
)
"""A name behind the argument, ``y(x)_\\mathrm{out}``, which belongs to the function."""
_PRIME_FIRST = re.compile(r"(?<![a-zA-Z\\])([a-zA-Z])('+)\s*_\s*(\w|\{\w+\})")
_STAR_FIRST = re.compile(
    rf"(?<![a-zA-Z\\])({_LETTER})\s*\^\s*\{{?\s*(?:\\ast|\*|\\star)\s*\}}?\s*_\s*(\w|\{{\w+\}})"
)
_HALF_BELOW = re.compile(
    r"(_\s*\{[^{}]*)\\[dts]?frac\s*(?:\{\s*(\d)\s*\}\s*\{\s*(\d)\s*\}|(\d)\s*(\d))(?=[^{}]*\})"
)
_BRACED_HALF = re.compile(r"(?<=[-+,{])(\s*)\{\s*(\\[dts]?frac\s*\{\s*\d\s*\}\s*\{\s*\d\s*\})\s*\}")
_POINT_NAMED = re.compile(r"(?<=[a-zA-Z}\d'])\s*\(\s*[a-zA-Z]\s*=\s*(\d+)\s*\)")
_ORDER_LABEL = re.compile(
    r"(?:(?<=\\\\)|\A)\s*(?:\{?\\(?:mathcal|cal)\s*\{?)?O\}?\s*"
    r"(?:\\left\s*)?\((?:[^()]|\([^()]*\))*?(?:\\right\s*)?\)\s*(&?)\s*:(?!\s*=)"
)
"""The label of an order in a list, ``O(\\epsilon^2):``."""
_MORE_TERMS = re.compile(
    r"(?<=[a-zA-Z0-9})\]!])\s*(\\(?:dots|ldots|cdots|dotsb)(?![a-zA-Z]))"
    r"(?=\s*(?:\}|\)|\]|\\right|\\\\|&|\Z|=|\\sim|\\approx|\.|\\nonumber|\\label|\n))"
)
_ONE_LINE = re.compile(r"\\substack\s*\{((?:(?!\\\\)[^{}]|\{(?:(?!\\\\)[^{}])*\})*)\}")
_FROM_ONE_SIDE = re.compile(
    r"\\substack\s*\{\s*([a-zA-Z]|\\[a-zA-Z]+)\s*\\(?:to|rightarrow)(?![a-zA-Z])\s*([^\\{}]{1,20}?)\s*"
    r"\\\\\s*\1\s*([<>])\s*\2\s*\}"
)
"""A limit from one side, ``\\substack{x \\to 0 \\\\ x > 0}``."""
_TWO_LINES = re.compile(
    r"\\(sum|prod)(?![a-zA-Z])\s*(?:\\limits\s*)?_\s*\{\s*\\substack\s*\{((?:[^{}\\]|\{[^{}]*\}"
    r"|\\(?!\\)[a-zA-Z]+|\\[ ,;:!])+)\\\\((?:[^{}\\]|\{[^{}]*\}|\\[a-zA-Z]+|\\[ ,;:!])+)\}\s*\}"
    r"(\s*\^\s*(?:\{[^{}]*\}|\w))?"
)
"""A sum with two lines below it."""
_PARITY = re.compile(
    r"\s*([a-zA-Z])\s*(?:\\[ ,;:!]\s*)*\\(?:text|mathrm|textrm|mbox|textit)\s*\{\s*(?:is\s+)?"
    r"(odd|even)\s*\}\s*"
)
_RANGE = re.compile(
    r"[^=<>\\]*(?:<|\\leq?(?:slant)?(?![a-zA-Z]))\s*([a-zA-Z])\s*(?:<|\\leq?(?:slant)?(?![a-zA-Z])).*"
)
_BETWEEN_ENDS = re.compile(
    r"\\(sum|prod)(?![a-zA-Z])\s*(?:\\limits\s*)?_\s*\{\s*([^{}<>=\\]{1,20}?)\s*"
    r"(<|\\leq?(?:slant)?(?![a-zA-Z]))\s*([i-n])\s*(<|\\leq?(?:slant)?(?![a-zA-Z]))\s*"
    r"((?:[^{}<>=\\,]|\\infty(?![a-zA-Z])){1,20}?)\s*\}(?!\s*\^)"
)
"""A sum over ``0 \\le k < n``."""
_PART = re.compile(
    r"\\(?:operatorname\*?|mathrm|text|textrm|mathop\s*\{\s*\\(?:rm|mathrm))\s*\{?\s*(Re|Im)\s*\}(?:\s*\})?(?![a-zA-Z])"
)
_FROM_ON = re.compile(
    r"\\(sum|prod)(?![a-zA-Z])\s*(?:\\limits\s*)?_\s*\{\s*([i-n])\s*(>|\\geq?(?:slant)?(?![a-zA-Z]))\s*"
    r"(\d+|[a-zA-Z](?:\s*_\s*\w)?(?:\s*[+-]\s*\d+)?)\s*\}(?!\s*\^)"
)
"""A sum over ``k \\ge 1``."""
_OVERLAY = re.compile(r"\\(?:uncover|onslide|visible|alert|pause)\s*(?:<[\d,\s-]*>|(?![a-zA-Z<]))")
"""What makes parts of a slide appear one after another."""
_PLAINER = str.maketrans(
    {"\uff0c": ",", "\uff1b": ";", "\uff08": "(", "\uff09": ")", "\uff1d": "=", "\u2212": "-"}
    | {"\u3002": " ", "\u00b0": "^\\circ "}
)
"""Punctuation of full width, a minus sign and a degree sign, as they are written in LaTeX."""
_LG = re.compile(r"\\lg(?![a-zA-Z])(?!\s*_)")
"""A logarithm whose base, 2 or 10, depends on the text: any base, then."""
_SETTING = re.compile(r"\\(?:re)?newcommand\s*(?:\{[^{}]*\}|\\?\w+|[\d.]+)\s*\{[^{}]*\}")
_CANCELLED_TO = re.compile(r"\\cancelto(?![a-zA-Z])")
_NUMBER = re.compile(r"\\(?:SI|qty|num)\s*(?:\[[^\[\]]*\])?\s*\{([^{}]*)\}")
_UNIT_BEHIND = re.compile(r"\s*(?:\[[^\[\]]*\])?\s*\{[^{}]*\}")
_BRACKET_SIZED = re.compile(r"\\qty(?![a-zA-Z])")
"""Of the package physics, before a bracket."""
_UNITS = re.compile(r"\\(?:si|unit)\s*\{[^{}]*\}")


def plain_notation(text: str) -> str:
    """Return a formula in the notation that the reader of LaTeX knows."""
    text = text if text.isascii() else text.translate(_PLAINER)
    if not any(mark in text for mark in "\\^{('"):
        return text
    text = _OVERLAY.sub(" ", text)
    text = _LG.sub(r"\\log_{b_{lg}}", text)
    text = _AND.sub(r"\1\\text{and}", text)
    text = _SPELLED.sub(r"\g<before>\\text{ \g<word> }", text)
    text = _WIDE.sub(r" \\quad ", text)
    text = _SPACES.sub(" ", text)
    text = _SETTING.sub(" ", text)
    text = _PART.sub(r"\\\1 ", text)
    text = _EMPTY.sub(" ", text)
    if "\\substack" in text:
        text = _FROM_ONE_SIDE.sub(lambda m: _from_one_side(*m.groups()), text)
        text = _ONE_LINE.sub(r" \1 ", text)
        text = _TWO_LINES.sub(_with_both_lines, text)
    text = _FROM_ON.sub(lambda m: _from_on(*m.groups()), text)
    text = _BETWEEN_ENDS.sub(lambda m: _with_ends(*m.groups()), text)
    text = _without_targets(text)
    text = _ORDER_LABEL.sub(r" \1 ", text)
    text = _MORE_TERMS.sub(_with_sign, text)
    text = _NAMED_BEHIND.sub(_with_name_inside, text)
    text = _PRIME_FIRST.sub(r"\1_\3\2", text)
    text = _STAR_FIRST.sub(lambda m: f"{m[1]}_{{{m[2].strip('{}')}star}}", text)
    text = _HALF_BELOW.sub(
        lambda m: f"{m[1]}{m[2] or m[4]}/{m[3] or m[5]}", _BRACED_HALF.sub(r"\1\2", text)
    )
    text = _POINT_NAMED.sub(r"(\1)", text)
    text = _BRACED_DIFFERENTIAL.sub(r"\\mathrm{d} \1 ", text)
    text = _BOLD_NUMBER.sub(r" \1 ", text)
    text = _with_lower_end_first(text, _UPPER_BEHIND)
    text = _CANCELLED.sub(" ", text)
    text = _WORDS.sub(lambda m: rf"\text{{{m[1].replace('~', ' ')}}}", text)
    text = _ITALIC.sub(lambda m: f"{m[1]}_{{{m[2]}}}" if m[2] else f" {m[1]} ", text)
    text = _GREEK.sub(r" \1 ", text)
    text = _POWER_FIRST.sub(r"\1_\3^\2", text)
    text = _VARIANT.sub(r"\\\1 ", text)
    text = _ACCENTED.sub(lambda m: rf"\{m[1]}{{{m[2]}_{m[3]}}}", text)
    text = _with_numbers(in_one_system(text))
    text = _with_derivatives(text)
    text = _PARTIAL.sub(r"\\partial ", text)
    text = _DIFFERENTIAL.sub(lambda m: r"\mathrm{d}", text)
    text = _with_lower_end_first(text, _UPPER_FIRST)
    text = _with_euler(text)
    return _SHOCK.sub(_beside_a_shock, text)


def _from_one_side(name: str, end: str, sign: str) -> str:
    return rf"{name} \to {end}^{'+' if sign == '>' else '-'}"


def _with_both_lines(found: re.Match[str]) -> str:
    r"""Return a sum over two ranges as two sums, and one over the odd k with the factor
    ``(1 - (-1)^k)/2``; products are left."""
    sign, first, second, above = found[1], found[2], found[3], found[4] or ""
    own = re.match(r"\s*([a-zA-Z])\s*=", first) or _RANGE.fullmatch(first)
    if own is None or (sign != "sum" and not _RANGE.fullmatch(second)):
        return found[0]
    parity = _PARITY.fullmatch(second)
    if parity is not None and parity[1] == own[1] and not _adds_on(found.string, found.end()):
        plus = "+" if parity[2] == "even" else "-"
        return rf"\sum_{{{first}}}{above} \frac{{1 {plus} (-1)^{{{own[1]}}}}}{{2}} \cdot "
    other = _RANGE.fullmatch(second)
    if other is None or other[1] == own[1] or above:
        return found[0]
    if re.search(rf"(?<![a-zA-Z\\]){other[1]}(?![a-zA-Z])", first):
        first, second = second, first  # the ends of the inner sum may depend on the outer index
        if re.search(rf"(?<![a-zA-Z\\]){own[1]}(?![a-zA-Z])", first):
            return found[0]
    return rf"\{sign}_{{{first}}} \{sign}_{{{second}}}"


def _adds_on(text: str, at: int) -> bool:
    """Whether a sum goes on with a plus or minus sign, which may still belong to the summand."""
    depth = 0
    for token in re.findall(r"\\[a-zA-Z]+|\\.|.", text[at:], re.DOTALL):
        depth += (token in "([{") - (token in ")]}")
        if depth < 0 or (depth == 0 and token in ("=", "<", ">", "&", "\\\\", "\\le", "\\ge")):
            return False
        if depth == 0 and token in ("+", "-", "\\pm", "\\mp"):
            return True
    return False


def _with_ends(sign: str, low: str, above: str, name: str, below: str, high: str) -> str:
    low += "+1" if above == "<" else ""
    high += "-1" if below == "<" and high != "\\infty" else ""
    return rf"\{sign}_{{{name}={low}}}^{{{high}}}"


def _from_on(sign: str, name: str, relation: str, low: str) -> str:
    low += "+1" if relation == ">" else ""
    return rf"\{sign}_{{{name}={low}}}^{{\infty}}"


def _with_sign(found: re.Match[str]) -> str:
    """Dots behind a term of a sum stand for further terms: ``1 + x \\dots``."""
    start = max(found.string.rfind(mark, 0, found.start()) for mark in ("\\\\", "=", "&"))
    before = found.string[max(start, 0) : found.start()]
    return f" + {found[1]}" if re.search(r"[^\s{(\[=&^_]\s*[-+]", before) else found[0]


def _with_name_inside(found: re.Match[str]) -> str:
    below = (found[2] or "").strip("{}")
    return f"{found[1]}_{{{below}{found[4] or found[5] or found[6]}}}{found[3]}"


def _without_targets(text: str) -> str:
    r"""``\cancelto{1}{x}`` is x, which the text says to be 1."""
    while (found := _CANCELLED_TO.search(text)) is not None:
        try:
            _, end = group(text, found.end())
            value, end = group(text, end)
        except InputError:
            return text
        text = f"{text[: found.start()]} {value} {text[end:]}"
    return text


def _beside_a_shock(found: re.Match[str]) -> str:
    letter, below, sign = found[1], (found[2] or "").strip("{}"), found[3] or found[4]
    if letter.startswith("\\") and letter in _NO_SYMBOLS:
        return found[0]
    return f"{letter}_{{{below}{'plus' if sign == '+' else 'minus'}}}"


_NO_SYMBOLS = frozenset(("\\to", "\\infty", "\\in", "\\right", "\\left", "\\mathbb", "\\mathrm"))


def _with_numbers(text: str) -> str:
    """Numbers of the package siunitx without their units."""
    while (found := _NUMBER.search(text)) is not None:
        end = found.end()
        if not found[0].startswith("\\num"):
            unit = _UNIT_BEHIND.match(text, end)
            end = unit.end() if unit else end
        value = re.sub(r"[eE]\s*([+-]?\d+)", r" \\times 10^{\1}", found[1])
        text = f"{text[: found.start()]} {value} {text[end:]}"
    return _BRACKET_SIZED.sub(" ", _UNITS.sub(" ", text))


def _with_derivatives(text: str) -> str:
    r"""``\dv{f}{x}``, ``\pdv[2]{f}{x}`` and ``\dv{x}`` as fractions of differentials."""
    at = 0
    while (found := _DERIVATIVE.search(text, at)) is not None:
        d = r"\partial " if found[1].startswith("p") else "d "
        power = f"^{found[2]}" if found[2] else ""
        try:
            first, end = group(text, found.end())
            braced = re.match(r"\s*\{", text[end:])
            second, past = group(text, end) if braced else ("", end)
        except InputError:
            return text
        above, below = (first, second) if braced else ("", first)
        made = rf"\frac{{{d.strip()}{power} {above}}}{{{d}{below}{power}}}"
        text, at = text[: found.start()] + made + text[past:], found.start() + len(made)
    return text


def _with_lower_end_first(text: str, upper_first: re.Pattern[str]) -> str:
    r"""Write ``\sum^{n}_{k=0}`` as ``\sum_{k=0}^{n}``, and ``[x^2]^1_0`` as ``[x^2]_0^1``."""
    at = 0
    while (found := upper_first.search(text, at)) is not None:
        at = found.end()
        try:
            upper, end = group(text, at)
            below = re.match(r"\s*_", text[end:])
            if below is None:
                continue
            lower, end = group(text, end + below.end())
        except InputError:
            return text
        head = f"\\{found[1]}" if found.re.groups else ""
        text = f"{text[: found.start()]}{head}_{{{lower}}}^{{{upper}}}{text[end:]}"
    return text


def _with_euler(text: str) -> str:
    r"""An upright e, which is Euler's number even where an italic e is a variable."""
    at = 0
    while (found := _EULER.search(text, at)) is not None:
        at, end, made = found.start(), found.end(), r" \exp(1) "
        if re.search(r"_\s*\{?\s*\Z", text[:at]):
            at = end  # a subscript
            continue
        if (above := re.match(r"\s*\^", text[end:])) is not None:
            try:
                exponent, end = group(text, end + above.end())
            except InputError:
                return text
            made = rf" \exp({exponent}) "
        text = text[:at] + made + text[end:]
        at += 1
    return text
