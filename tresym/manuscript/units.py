r"""Quantities with units: ``\SI{24}{\hour} = \SI{86400}{\second}`` compares the same unit.

The numbers of a display are compared without their units where all of these are the same, or are
those of the international system without prefix (m, kg, s, A, ...), which need no factors. Units
are written with the package siunitx, or upright behind a number: ``5\,\mathrm{km}``. Where
one of them is another, each quantity is its number times the factor of its unit: 24 hours are
24 · 3600, and 6371 kilometres 6371 · 10^3. Where a unit is not known, the quantities are left
unread, since their numbers alone say nothing.
"""

from __future__ import annotations

import re

from tresym.manuscript.macros import group
from tresym.reals.numbers.exact import InputError

Dimension = tuple[int, int, int, int, int, int, int]
UNREAD = r" \unknownunit "
"""A command that the reader of formulas does not know."""
_QUANTITY = re.compile(r"\\(?:SI|qty)(?![a-zA-Z])\s*(?:\[[^\[\]]*\])?\s*(?=\{)")
_SPOKEN = re.compile(r"\\(?:mathrm|text|textrm|rm|si|unit|mbox)(?![a-zA-Z])")
_PREFIXES = {
    **{"pico": -12, "nano": -9, "micro": -6, "milli": -3, "centi": -2, "deci": -1, "hecto": 2},
    **{"kilo": 3, "mega": 6, "giga": 9, "tera": 12},
}
_SHORT = {"p": -12, "n": -9, "u": -6, "m": -3, "c": -2, "d": -1, "k": 3, "M": 6, "G": 9, "T": 12}
_SYMBOLS = {
    name: symbol
    for pair in [
        "m metre",
        "m meter",
        "s second",
        "A ampere",
        "K kelvin",
        "mol mole",
        "N newton",
        "J joule",
        "W watt",
        "V volt",
        "Pa pascal",
        "Hz hertz",
        "C coulomb",
        "F farad",
        "H henry",
        "T tesla",
        "Wb weber",
        "rad radian",
        "g gram",
        "l litre",
        "L liter",
        "min minute",
        "h hour",
    ]
    for name, symbol in [pair.split()]
}
_OTHER = {"gram": (1, -3), "litre": (1, -3), "liter": (1, -3), "tonne": (1, 3), "bar": (1, 5)}
_OTHER |= {"minute": (6, 1), "hour": (36, 2), "day": (864, 2)}
"""Units with a factor, a number times a power of ten: an hour is 36 · 10^2 seconds."""
_NONE: Dimension = (0, 0, 0, 0, 0, 0, 0)
_DIMENSIONS: dict[str, Dimension] = {
    "meter": (1, 0, 0, 0, 0, 0, 0),
    "kilogram": (0, 1, 0, 0, 0, 0, 0),
    "second": (0, 0, 1, 0, 0, 0, 0),
    "ampere": (0, 0, 0, 1, 0, 0, 0),
    "kelvin": (0, 0, 0, 0, 1, 0, 0),
    "mole": (0, 0, 0, 0, 0, 1, 0),
    "candela": (0, 0, 0, 0, 0, 0, 1),
    "radian": _NONE,
    "newton": (1, 1, -2, 0, 0, 0, 0),
    "joule": (2, 1, -2, 0, 0, 0, 0),
    "watt": (2, 1, -3, 0, 0, 0, 0),
    "volt": (2, 1, -3, -1, 0, 0, 0),
    "pascal": (-1, 1, -2, 0, 0, 0, 0),
    "hertz": (0, 0, -1, 0, 0, 0, 0),
    "coulomb": (0, 0, 1, 1, 0, 0, 0),
    "farad": (-2, -1, 4, 2, 0, 0, 0),
    "henry": (2, 1, -2, -2, 0, 0, 0),
    "tesla": (0, 1, -2, -1, 0, 0, 0),
    "weber": (2, 1, -2, -1, 0, 0, 0),
    "ohm": (2, 1, -3, -2, 0, 0, 0),
    "siemens": (-2, -1, 3, 2, 0, 0, 0),
    "litre": (3, 0, 0, 0, 0, 0, 0),
}
"""The units that are known, with their dimensions: powers of length, mass, time, current,
temperature, amount and light."""
_DIMENSIONS |= {"metre": _DIMENSIONS["meter"], "liter": _DIMENSIONS["litre"]}
_DIMENSIONS |= dict.fromkeys(("gram", "tonne"), _DIMENSIONS["kilogram"])
_DIMENSIONS |= dict.fromkeys(("minute", "hour", "day"), _DIMENSIONS["second"])
_DIMENSIONS |= {"bar": _DIMENSIONS["pascal"]}
_CHAINS = re.compile(r"\\\\(?!\s*&?\s*(?:=|\\approx|\\simeq))|\\q?quad(?![a-zA-Z])|\\text(?=\s*\{)")
"""Where a chain of a display ends and another begins."""
_PLAIN = re.compile(
    "\x00\\d+\x01|/\\s*[\\d.]+|\\\\(?:[dt]?frac|cdot|times)(?![a-zA-Z])|\\\\[ ,;:!]|[\\d.,\\s&^~]"
)
"""What may stand beside the quantities of a product without changing its dimension."""
_TERMS = re.compile(
    r"[=<>+-]|\\(?:leq?|geq?|approx|simeq|sim|equiv|neq?|ll|gg|pm|mp|to|Rightarrow|implies)"
    r"(?![a-zA-Z])"
)
_UPRIGHT = re.compile(
    r"(?<=[\d})])(?P<space>(?:\s|~|\\[ ,;:!])*)(?:\\(?:text|mathrm|textrm|mbox|rm)\s*\{"
    r"(?P<unit>\s*(?:\\[ ,])?(?:[a-zA-Z/.\s^\d-]|\\cdot|\\mu|\\[ ,]|\^\{-?\d\})*?[a-zA-Z\d}]\s*)\}"
    r"(?P<power>\s*\^\s*(?:\{\s*-?\d\s*\}|-?\d))?|(?P<ohm>\\Omega(?![a-zA-Z])))"
)
"""Upright letters behind a number, which may be its unit."""
_COMMAND = re.compile(
    r"\s*(?:\\([a-zA-Z]+)(?:\s*\{\s*(-?\d+)\s*\})?|([a-zA-Z]+)|(\^\s*\{?\s*(-?\d+)\s*\}?)|([/.~])"
    r"|(\\[ ,]))\s*"
)


def in_one_system(text: str) -> str:
    """Return the display with its quantities as numbers in one system of units."""
    apart = _dimensions_differ(text)
    upright = text if apart else _without_upright_units(text)
    one_notation = upright == text and not re.search(r"\\(?:si|unit)(?![a-zA-Z])", text)
    comparable = one_notation and not apart
    text = upright
    found = list(_quantities(text))
    units = {unit for *_, unit in found}
    factors = {unit: factor_of(unit) for unit in units}
    if comparable and (len(units) < 2 or all(factor == (1, 0) for factor in factors.values())):
        return text
    known = comparable and None not in factors.values() and not _SPOKEN.search(text)
    for start, end, value, unit in reversed(found):
        factor = factors[unit]
        made = UNREAD if not known or factor is None else _times(value, factor)
        if text[:start].rstrip().endswith("/") or text[end:].lstrip().startswith("^"):
            made = f"({made})"
        text = f"{text[:start]} {made} {text[end:]}"
    return text


def _without_upright_units(text: str) -> str:
    """Write ``5\\,\\mathrm{km}`` as a number of metres if all upright words behind numbers are
    units of the international system, up to a power of ten."""
    found = [mark for mark in _UPRIGHT.finditer(text) if not _is_below(text, mark.start())]
    powers = [_factor_behind(mark) for mark in found]
    if not any(mark["unit"] for mark in found) or None in powers:
        return text
    scaled = [mark for mark, power in zip(found, powers, strict=True) if power]
    if any("/" in re.split(r"[=<>&]", text[: mark.start()])[-1] for mark in scaled):
        return text
    for mark in reversed(found):
        exponent = _factor_behind(mark)
        times = rf" \times 10^{{{exponent}}} " if exponent else " "
        text = text[: mark.start()] + times + text[mark.end() :]
    return text


def _factor_behind(mark: re.Match[str]) -> int | None:
    """Return the power of ten of the unit behind a number; None if it is not known."""
    if mark["ohm"]:
        return 0
    unit = _plain_unit(mark)
    spaced = mark["unit"][:1].isspace() or mark["space"].strip() or len(unit) > 1
    power = mark["power"] or ""
    found = factor_of(f"{unit}{power}") if spaced else None
    return found[1] if found and found[0] == 1 else None


def _plain_unit(mark: re.Match[str]) -> str:
    """Return an upright unit with points for products and u for micro."""
    plain = re.sub(
        r"\\cdot|\\[ ,]|\\mu(?![a-z])\s*", lambda m: "u" if "mu" in m[0] else ".", mark["unit"]
    )
    return plain.strip()


def _is_below(text: str, at: int) -> bool:
    """Whether a place is in an index, ``v_{2\\,\\text{s}}``."""
    return bool(re.search(r"_\s*\{[^{}]*\Z", text[:at]))


def _quantities(text: str) -> list[tuple[int, int, str, str]]:
    """Return where the quantities of a text are, with their numbers and units."""
    found = []
    for mark in _QUANTITY.finditer(text):
        try:
            value, end = group(text, mark.end())
            if not text[end:].lstrip().startswith("{"):
                continue  # \qty of another package is a bracket
            unit, end = group(text, end)
        except InputError:
            continue
        found.append((mark.start(), end, value, "".join(unit.split())))
    return found


def _times(value: str, factor: tuple[int, int]) -> str:
    """Return a number times a factor; a rounded number of hours is left unread."""
    number, exponent = factor
    mantissa, _, own = value.lower().partition("e")
    if number != 1 and "." in mantissa:
        return UNREAD
    power = exponent + (int(own) if re.fullmatch(r"[-+]?\d+", own) else 0)
    if own and not re.fullmatch(r"[-+]?\d+", own):
        return UNREAD
    times = rf" \times {number}" if number != 1 else ""
    return f"{mantissa}{times}" + (rf" \times 10^{{{power}}}" if power else "")


def factor_of(unit: str) -> tuple[int, int] | None:
    """Return the factor of a unit as a number and a power of ten; None if it is not known."""
    found = _read(unit)
    return None if found is None else found[:2]


def _read(unit: str) -> tuple[int, int, Dimension] | None:
    """Return number, power of ten and dimension of a unit."""
    number, exponent, sign, prefix, last, at = 1, 0, 1, 0, (1, 0), 0
    pending, dimension, own = 1, _NONE, _NONE
    while at < len(unit):
        mark = _COMMAND.match(unit, at)
        if mark is None:
            return None
        at, word, short = mark.end(), mark[1], mark[3]
        if mark[6] or mark[7] or word == "per":
            pending = -1 if word == "per" or mark[6] == "/" else 1
            continue
        if word in _PREFIXES:
            prefix = _PREFIXES[word]
            continue
        power = {"squared": 2, "cubed": 3}.get(word or "", 0) or int(mark[5] or mark[2] or 0)
        if word in ("squared", "cubed", "tothe") or mark[4]:
            power = (power - 1) * sign  # one was counted with the unit
        elif word in ("square", "cubic"):
            return None
        else:
            one = _named(word, short)
            if one is None:
                return None
            own = _DIMENSIONS[word or _SYMBOLS.get(short) or _SYMBOLS[short[1:]]]
            last, sign, power = (one[0], one[1] + prefix), pending, pending
            prefix, pending = 0, 1
        if power < 0 and last[0] != 1:
            return None  # km/h
        number, exponent = number * last[0] ** max(power, 0), exponent + last[1] * power
        dimension = _product(dimension, own, power)
    return number, exponent, dimension


def _product(one: Dimension, other: Dimension, power: int) -> Dimension:
    """The dimension of a product with a power."""
    length, mass, time, current, heat, amount, light = (
        x + power * y for x, y in zip(one, other, strict=True)
    )
    return length, mass, time, current, heat, amount, light


def _dimensions_differ(text: str) -> bool:
    """Whether two sides of a chain, or two terms of a sum, are known to have other dimensions.

    A term is known if it is a product of numbers and quantities. Terms with letters, fractions
    or powers of quantities may have any dimension.
    """
    places = [(start, end, _read(unit)) for start, end, _, unit in _quantities(text)]
    places += [
        (mark.start(), mark.end(), _read(f"{_plain_unit(mark)}{mark['power'] or ''}"))
        for mark in _UPRIGHT.finditer(text)
        if mark["unit"] and not _is_below(text, mark.start())
    ]
    marked, known = text, {}
    for n, (start, end, found) in enumerate(sorted(places, key=lambda place: place[0])[::-1]):
        known[n] = found
        marked = f"{marked[:start]} \x00{n}\x01 {marked[end:]}"
    for chain in _CHAINS.split(marked):
        seen = {
            dimension
            for term in _TERMS.split(re.sub(r"\{[^{}]*\}", "", chain))
            if (dimension := _dimension_of_term(term, known)) is not None
        }
        if len(seen) > 1:
            return True
    return False


def _dimension_of_term(
    term: str, known: dict[int, tuple[int, int, Dimension] | None]
) -> Dimension | None:
    quantities = [known[int(n)] for n in re.findall("\x00(\\d+)\x01", term)]
    plain = _PLAIN.sub("", term)
    dimension = _NONE
    if plain or not quantities or re.search("\x01\\s*\\^", term):
        return None
    for found in quantities:
        if found is None:
            return None
        dimension = _product(dimension, found[2], 1)
    return dimension


def _named(word: str | None, short: str | None) -> tuple[int, int] | None:
    """Return the factor of one unit, by its name or its symbol."""
    if word:
        return _factor(word)
    if short in _SYMBOLS:
        return _factor(_SYMBOLS[short])
    if short and short[0] in _SHORT and short[1:] in _SYMBOLS:
        number, exponent = _factor(_SYMBOLS[short[1:]]) or (1, 0)
        return number, exponent + _SHORT[short[0]]
    return None


def _factor(name: str) -> tuple[int, int] | None:
    return _OTHER.get(name) or ((1, 0) if name in _DIMENSIONS else None)
