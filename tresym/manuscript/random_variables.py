r"""Expected values and probabilities as integrals: ``\mathbb{E}[X^2]`` for a uniform X is one.

"Let $X$ be uniformly distributed on $[0, 1]$" says what ``\mathbb{E}[X^2]``,
``\operatorname{Var}(X)`` and ``P(X > 1/3)`` are: integrals of a function of x times the density of
X, or sums over its values. They are written so before the display is taken apart. A variable of
which the text does not say one of these distributions, or that has an index, is left alone, and so
its formula is unread; so is a probability whose ends may lie outside of the range of its variable.

Example:
    >>> from tresym.manuscript.random_variables import Distributions
    >>> told = Distributions()
    >>> told.hear(r"Let $X$ be uniformly distributed on $[0, 2]$.")
    ('',)
    >>> told.in_integrals(r"\mathbb{E}[X^2] = \frac43")
    '\\left(\\int_{0}^{2} \\left(x^2\\right) \\frac{1}{(2)-(0)} \\, dx\\right) = \\frac43'
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple


class Distribution(NamedTuple):
    """A distribution of one variable.

    Attributes:
        weight: its density, or the probability of a value, of ``@``.
        low: the least value.
        high: the greatest value.
        discrete: whether its values are integers.
        needs: what its parameters satisfy, as the text of an inline formula.
    """

    weight: str
    low: str
    high: str
    discrete: bool = False
    needs: str = ""


_TERM = r"[^$,;()\[\]{}]|\\[a-zA-Z]+|\{[^{}]*\}|\([^()]*\)"
_ENDS = rf"[\[(]\s*((?:{_TERM})+?)\s*,\s*((?:{_TERM})+?)\s*[\])]"
_NAME = r"(?:\\(?:mathcal|mathrm|text|operatorname|mathbf|mathsf)\s*\{?\s*)?"
_BE = (
    r"(?:\s*(?:be|is|are|being|has|have|follows?|denotes?|having|with)\b)?"
    r"(?:\s+(?:an?|the|continuous|real|random|variable|that|which|is|has|with|distribution))*\s*"
)
_PARAMETER = r"\s*(?:with\s+)?(?:the\s+)?(?:parameter|rate)\s*\$\s*([^$=]+?)\s*\$"
_VARIABLE = r"\$\s*([A-Z])\s*\$"
_SIMILAR = r"\$\s*([A-Z])\s*\\sim\s*" + _NAME
_PAIR = rf"\}}?\s*(?:\\left\s*)?\(\s*((?:{_TERM})+?)\s*,\s*((?:{_TERM})+?)\s*(?:\\right\s*)?\)"
_ONE = rf"\}}?\s*(?:\\left\s*)?\(\s*((?:{_TERM})+?)\s*(?:\\right\s*)?\)"


def _uniform(low: str, high: str) -> Distribution:
    needs = "" if _are_numbers(low, high) else f"{low} < {high}"
    return Distribution(rf"\frac{{1}}{{({high})-({low})}}", low, high, needs=needs)


def _exponential(rate: str) -> Distribution:
    needs = "" if _are_numbers(rate) else f"{rate} > 0"
    return Distribution(rf"({rate}) e^{{-({rate}) @}}", "0", r"\infty", needs=needs)


def _poisson(mean: str) -> Distribution:
    needs = "" if _are_numbers(mean) else f"{mean} > 0"
    return Distribution(
        rf"e^{{-({mean})}} \frac{{({mean})^{{@}}}}{{@!}}", "0", r"\infty", True, needs
    )


def _binomial(number: str, chance: str) -> Distribution:
    needs = [] if _are_numbers(number) else [rf"{number} \in \mathbb{{N}}"]
    needs += [] if _are_numbers(chance) else [f"0 < {chance} < 1"]
    weight = rf"\binom{{{number}}}{{@}} ({chance})^{{@}} (1-({chance}))^{{{number}-@}}"
    return Distribution(weight, "0", number, True, ", ".join(needs))


def _normal(mean: str, variance: str) -> Distribution | None:
    square = re.fullmatch(r"(\\?[a-zA-Z]+)\s*\^\s*\{?2\}?", variance)
    if square is None and not _are_numbers(variance):
        return None  # some authors write the standard deviation
    if square is None and variance != "1":
        return None
    scale = square[1] if square else "1"
    weight = rf"\frac{{1}}{{{scale} \sqrt{{2\pi}}}} e^{{-\frac{{(@-({mean}))^2}}{{2 ({scale})^2}}}}"
    return Distribution(weight, r"-\infty", r"\infty", needs=f"{scale} > 0" if square else "")


def _are_numbers(*terms: str) -> bool:
    return all(re.fullmatch(r"-?[\d./]+", term) for term in terms)


_KNOWN = (
    (
        rf"{_VARIABLE}{_BE}uniform(?:ly)?(?:\s+distribut\w+)?\s*(?:on|over|in|between)?\s*"
        rf"(?:the\s+interval\s*)?\$\s*{_ENDS}\s*\$",
        _uniform,
    ),
    (rf"{_SIMILAR}(?:Unif(?:orm)?|U){_PAIR}", _uniform),
    (
        rf"{_VARIABLE}{_BE}exponential(?:ly)?(?:\s+(?:random\s+variable|distribut\w+))?{_PARAMETER}",
        _exponential,
    ),
    (rf"{_SIMILAR}Exp(?:onential)?\}}?\s*\(\s*(\\lambda)\s*\)", _exponential),
    (rf"{_VARIABLE}{_BE}Poisson(?:\s+(?:random\s+variable|distribut\w+))?{_PARAMETER}", _poisson),
    (rf"{_SIMILAR}(?:Poisson|Poi|Pois|Po){_ONE}", _poisson),
    (rf"{_SIMILAR}(?:Bin(?:om(?:ial)?)?|B){_PAIR}", _binomial),
    (
        rf"{_VARIABLE}{_BE}binomial(?:ly)?(?:\s+(?:random\s+variable|distribut\w+))?\s*(?:with\s+)?"
        r"(?:the\s+)?parameters\s*\$\s*([^$,]+?)\s*(?:\$\s*and\s*\$|,)\s*([^$,]+?)\s*\$",
        _binomial,
    ),
    (rf"{_SIMILAR}N(?:ormal)?{_PAIR}", _normal),
    (rf"{_VARIABLE}{_BE}standard\s+(?:normal|Gaussian)\b", lambda: _normal("0", "1")),
)
_PATTERNS = tuple((re.compile(words), made) for words, made in _KNOWN)
_DENSITY = re.compile(
    rf"{_VARIABLE}{_BE}(?:probability\s+)?density(?:\s+function)?\s*\$\s*"
    r"[a-zA-Z](?:_\{?[A-Z]\}?)?\s*\(\s*([a-z])\s*\)\s*=\s*([^$=]+?)\s*\$\s*(?:for|on|when|if|where)\s*"
    rf"(?:\$\s*(?:\2\s*\\in\s*)?{_ENDS}\s*\$|\$\s*([^$<>\\]+?)\s*(?:<|\\leq?)\s*\2\s*(?:<|\\leq?)"
    r"\s*([^$<>\\]+?)\s*\$|\$\s*\2\s*(?:>|\\geq?)\s*(\d+)\s*\$)"
)
"""A density with its range, as in "X has density $f(x) = 2x$ for $0 < x < 1$"."""
_NAMED = re.compile(r"\$\s*([A-Z])\s*(?:\$|\\sim|=|_|\\in|,)|,\s*([A-Z])\s*\$")
_SAID = re.compile(
    r"\b(?:let|suppose|assume|consider|if|now|another|takes?|define|denote|where|with)\b",
    re.IGNORECASE,
)
_OTHERWISE = re.compile(
    r"\b(?:condition\w*|given|knowing|known|restrict\w*|truncat\w*|uniform\w*|distribut\w*|densit\w*"
    r"|law|normal\w*|gaussian|exponential\w*|poisson|binomial\w*|geometric\w*|measures?)\b",
    re.IGNORECASE,
)
"""Words by which a sentence may give a variable another distribution than the one stated before."""
_SENTENCE = re.compile(r"(?<=[.;])\s+(?=[A-Z])")
_EXPECTED = (
    r"(?:\\math(?:bb|bf|rm|sf)\s*\{?\s*E\s*\}?|\\operatorname\*?\s*\{\s*E\s*\}"
    r"|(?<![a-zA-Z\\])E)"
)
_VARIANCE = (
    r"(?:\\(?:operatorname\*?|mathrm|text|mathbb)\s*\{\s*(?:[Vv]ar|V)\s*\}|\\[Vv]ar(?![a-zA-Z])"
    r"|(?<![a-zA-Z\\])Var)"
)
_PROBABILITY = (
    r"(?:\\math(?:bb|bf|rm|sf)\s*\{?\s*P\s*\}?|\\operatorname\*?\s*\{\s*P\s*\}|\\Pr(?![a-zA-Z])"
    r"|\\Prob(?![a-zA-Z])|(?<![a-zA-Z\\])P)"
)
_COMMAND = re.compile(r"\\[a-zA-Z]+")
_OPERATOR = re.compile(
    rf"(?:(?P<mean>{_EXPECTED})|(?P<variance>{_VARIANCE})|(?P<probability>{_PROBABILITY}))\s*"
    r"(?P<size>\\left|\\[bB]igg?l?)?\s*(?P<open>[\[(]|\\[{\[(])"
)
_CLOSES = {"[": "]", "(": ")", "\\{": "\\}", "\\[": "\\]", "\\(": "\\)"}
_LETTERS = ("x", "t", "u", "v", "w", "y", "z", "s")
_INDICES = ("k", "j", "m", "l")
_RELATION = re.compile(r"(<|>|=|\\(?:le|ge)(?:q|qslant)?(?![a-zA-Z]))")
_SIGNS = {"<": "<", ">": ">", "=": "="} | {
    f"\\{sign}{more}": relation
    for sign, relation in (("le", "<="), ("ge", ">="))
    for more in ("", "q", "qslant")
}
_BETWEEN = re.compile(
    r"\s*(?:\\left\s*)?\|\s*([A-Z])\s*(?:\\right\s*)?\|\s*(<|\\leq?(?:slant)?(?![a-zA-Z]))\s*"
    r"(\\[dt]?frac\s*(?:\{\d+\}|\d)\s*(?:\{\d+\}|\d)|[\d.]+)\s*\Z"
)
"""``|X| < 2``."""
_TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "=": "="}
_FRACTION = re.compile(
    r"(-?)\s*(?:\\[dt]?frac\s*(?:\{(\d+)\}|(\d))\s*(?:\{(\d+)\}|(\d))|([\d.]+(?:/\d+)?))"
)


class Distributions:
    """The distributions that the text has stated so far."""

    def __init__(self) -> None:
        """Begin without one."""
        self.known: dict[str, Distribution] = {}

    def close(self) -> None:
        """End a section, or a statement: what was said of variables ends."""
        self.known.clear()

    def hear(self, text: str) -> tuple[str, ...]:
        """Note the distributions that a text states, and return what their parameters satisfy."""
        needs = []
        for sentence in _SENTENCE.split(text):
            found = dict(_stated(sentence))
            if not found and _OTHERWISE.search(sentence):
                self.known.clear()
            elif not found and _SAID.search(sentence):
                for mark in _NAMED.finditer(sentence):
                    self.known.pop(mark[1] or mark[2], None)
            self.known |= found
            needs += [one.needs for one in found.values()]
        return tuple(needs)

    def in_integrals(self, text: str, words: str = "") -> str:
        """Return a display with expected values and the like of known variables as integrals.

        Args:
            words: the sentence around it, which may say that an end of a range is positive.
        """
        if not self.known:
            return text
        at = 0
        while (mark := _OPERATOR.search(text, at)) is not None:
            at = mark.end()
            end = _partner(text, mark.end(), mark["open"])
            if end < 0:
                continue
            inside = re.sub(r"\\right\s*\Z|\\[bB]igg?r?\s*\Z", "", text[mark.end() : end])
            if mark["probability"]:
                made = self._probability(inside, f"{text} {words}")
            else:
                made = self._written(inside, bool(mark["variance"]), text)
            if made:
                end += len(_CLOSES[mark["open"]])
                text = f"{text[: mark.start()]}{made}{text[end:]}"
                at = mark.start() + len(made)
        return text

    def _written(self, inside: str, variance: bool, text: str) -> str:
        """Return an expected value, or a variance, as integrals; empty if it is of no known one."""
        names = {*re.findall("[A-Z]", _COMMAND.sub(" ", inside))}
        if len(names) != 1 or re.search(r"\||\\mid(?![a-z])|[A-Z]\s*_|[=<>]", inside):
            return ""
        name = min(names)
        one = self.known.get(name)
        if one is None or (variance and inside.strip() != name):
            return ""
        letter = _new_letter(one, text)
        if not letter:
            return ""
        value = re.sub(rf"(\\[a-zA-Z]+)|{name}", lambda m: m[1] or letter, inside)
        if not variance:
            return _mean(one, letter, value)
        return rf"\left({_mean(one, letter, letter + '^2')} - {_mean(one, letter, letter)}^2\right)"

    def _probability(self, inside: str, text: str) -> str:
        """Return the probability of a range of a known variable; empty if it is none."""
        inside = _BETWEEN.sub(r"-\3 \2 \1 \2 \3", inside)
        sides = [side.strip() for side in _RELATION.split(inside)]
        names = {*re.findall("[A-Z]", _COMMAND.sub(" ", inside))}
        one = self.known.get(min(names, default=""))
        if one is None or len(names) != 1 or len(sides) not in (3, 5):
            return ""
        name = min(names)
        if re.search(r"[|,;]|\\mid(?![a-z])|\\[a-z]*(?:cap|cup|land|lor|text)(?![a-z])", inside):
            return ""
        terms, relations = sides[::2], [_SIGNS[sign] for sign in sides[1::2]]
        if terms.count(name) != 1 or (len(terms) == 3 and terms[1] != name):
            return ""
        at = terms.index(name)
        bounds = [(_TURNED[relations[k]], terms[k]) for k in range(at)]
        bounds += [(relations[k], terms[k + 1]) for k in range(at, len(relations))]
        letter = _new_letter(one, text)
        ends = _ends(one, bounds, text) if letter else None
        if ends is None:
            return ""
        low, high = ends
        if one.discrete and low == high:
            return rf"\left({one.weight.replace('@', f'{{{low}}}')}\right)"
        if not one.discrete and low == high:
            return "0"
        return _mean(one._replace(low=low, high=high), letter, "1")


def _new_letter(one: Distribution, text: str) -> str:
    """Return a letter for the values of a variable that the text does not use; empty if none."""
    letters = _INDICES if one.discrete else _LETTERS
    plain = _COMMAND.sub(" ", f"{text} {one.weight} {one.low} {one.high}")
    return next((letter for letter in letters if letter not in plain), "")


def _ends(one: Distribution, bounds: list[tuple[str, str]], text: str) -> tuple[str, str] | None:
    """Return the ends of the range in which the bounds hold; None if it may reach outside of the
    values of the variable, or is empty."""
    low, high = one.low, one.high
    for relation, end in bounds:
        value = _value(end)
        if one.discrete:
            whole = value is not None and value.denominator == 1 and value >= 0
            index = relation == "=" and re.fullmatch(r"[kjmnrx]", end)
            if not (whole or index):
                return None
            if relation == "=":
                low = high = end
            elif value is not None and relation in (">", ">="):
                low = str(max(value + (relation == ">"), 0))
            elif value is not None:
                high = str(value - (relation == "<"))
        elif not _is_inside(one, end, text):
            return None
        elif relation == "=":
            low = high = end
        elif relation in (">", ">="):
            low = end
        else:
            high = end
    first, last = _value(low), _value(high)
    if first is not None and last is not None and first > last:
        return None
    limit = _value(one.high)
    if one.discrete and limit is None and one.high != r"\infty" and high != one.high:
        return None  # of n trials, with n not known
    if one.discrete and limit is not None and last is not None and last > limit:
        return None
    return low, high


def _is_inside(one: Distribution, end: str, text: str) -> bool:
    """Whether the end of a range is a value of a continuous variable."""
    value, low, high = _value(end), _value(one.low), _value(one.high)
    if not end or not re.fullmatch(r"[\w\s\\{}./+*^-]+", end) or re.search("[A-Z]", end):
        return False
    if value is not None:
        below = one.low == r"-\infty" or (low is not None and low <= value)
        return below and (one.high == r"\infty" or (high is not None and value <= high))
    if (one.low, one.high) == (r"-\infty", r"\infty"):
        return True
    if (one.low, one.high) != ("0", r"\infty"):
        return False
    letter = re.escape(end)
    positive = rf"(?<![a-zA-Z\\]){letter}\s*(?:>|\\geq?(?:slant)?(?![a-zA-Z]))\s*0(?![.\d])"
    turned = rf"(?<![.\d])0\s*(?:<|\\leq?(?:slant)?(?![a-zA-Z]))\s*{letter}(?![a-zA-Z\d_^])"
    return bool(re.search(rf"{positive}|{turned}", text))


def _value(end: str) -> Fraction | None:
    """Return the number that an end is, None if it is none."""
    found = _FRACTION.fullmatch(end.strip())
    if found is None:
        return None
    top, below = found[2] or found[3] or found[6], found[4] or found[5] or "1"
    try:
        value = Fraction(top) / Fraction(below)
    except (ValueError, ZeroDivisionError):
        return None
    return -value if found[1] else value


def _mean(one: Distribution, letter: str, value: str) -> str:
    """Return the expected value of a function of the variable, whose values the letter takes."""
    weight = one.weight.replace("@", f"{{{letter}}}" if one.discrete else letter)
    if one.discrete:
        ends = f"_{{{letter}={one.low}}}^{{{one.high}}}"
        return rf"\left(\sum{ends} \left({value}\right) {weight}\right)"
    return (
        rf"\left(\int_{{{one.low}}}^{{{one.high}}} \left({value}\right) {weight} "
        rf"\, d{letter}\right)"
    )


def _stated(sentence: str) -> list[tuple[str, Distribution]]:
    """Return the variables of which a sentence states the distribution."""
    found = []
    for pattern, made in _PATTERNS:
        for mark in pattern.finditer(sentence):
            one = made(*(term.strip() for term in mark.groups()[1:]))
            if one is not None:
                found.append((mark[1], one))
    for mark in _DENSITY.finditer(sentence):
        name, letter, weight = mark[1], mark[2], mark[3]
        low, high = mark[4] or mark[6] or mark[8], mark[5] or mark[7] or r"\infty"
        weight = re.sub(rf"(?<![a-zA-Z\\]){letter}(?![a-zA-Z])", "@", weight)
        found.append((name, Distribution(rf"\left({weight}\right)", low, high)))
    return found


def _partner(text: str, at: int, opening: str) -> int:
    """Return where the bracket that opens before a place is closed; -1 if it is not."""
    closing, depth = _CLOSES[opening], 1
    while at < len(text):
        if text.startswith(closing, at):
            depth -= 1
            if not depth:
                return at
        elif text.startswith(opening, at):
            depth += 1
        at += 1
    return -1
