"""What the charts share: captions, line styles that work without colour, times as text."""

from __future__ import annotations

import textwrap
from decimal import Decimal
from typing import Any, NamedTuple


class Mark(NamedTuple):
    """The style of a method: colour, marker and line; markers of other libraries are open."""

    colour: str
    marker: str
    line: Any
    filled: bool

    @property
    def options(self) -> dict[str, Any]:
        """Return the keyword arguments for ``plot``."""
        return {
            "color": self.colour,
            "marker": self.marker,
            "linestyle": self.line,
            "markerfacecolor": self.colour if self.filled else "white",
            "markeredgecolor": self.colour,
        }


BLUE, SKY, GREEN, ORANGE, RED, PURPLE, YELLOW, BLACK = (
    "#0072b2",
    "#3a9fd6",
    "#009e73",
    "#b87500",
    "#d55e00",
    "#a6558a",
    "#8a7d00",
    "#000000",
)
"""After the palette of Okabe and Ito, the light ones darkened so that they print."""

SOLID, DASHED, DOTTED, DASHDOT = "-", (0, (4, 1.5)), (0, (1, 1.2)), (0, (5, 1.4, 1, 1.4))


_WORDS = (
    ("tresym.flip_map, numpy", "tresym, arrays in float64"),
    ("tresym.flip_angle, 15 digits certified", "tresym, one by one, 15 digits proved"),
    ("tresym, certified", "tresym, every digit proved"),
    ("tresym, Gauss transformation", "tresym, Gauss transformation, proved"),
    ("tresym, FLINT's R_F and R_J", "tresym, Carlson integrals, proved"),
    ("findroot on the printed equation", "mpmath, the printed equation"),
    ("our phase equation in mpmath", "mpmath, the stable equation"),
    ("our phase equation in scipy newton", "scipy, the stable equation"),
    ("mpmath Newton, phase equation", "mpmath, the stable equation"),
    ("mpmath findroot, printed equation", "mpmath, the printed equation"),
    ("mpmath findroot over", "mpmath, a root of"),
    ("findroot over", "mpmath, a root of"),
    ("scipy brentq over", "scipy, a root of"),
    ("scipy brentq, printed equation", "scipy brentq, the printed equation"),
    ("brentq in a loop, printed equation", "scipy brentq, the printed equation"),
    ("scipy find_root, printed equation", "scipy find_root, the printed equation"),
    ("scipy newton, printed equation", "scipy newton, the printed equation"),
    ("mpmath quad of our substitution", "mpmath, quadrature of a smooth integrand"),
    ("mpmath quad, tanh-sinh", "mpmath, quadrature (tanh-sinh)"),
    ("mpmath quad, Gauss-Legendre", "mpmath, quadrature (Gauss)"),
    ("mpmath R_F and R_J", "mpmath, Carlson integrals"),
    ("mpmath odefun", "mpmath, differential equation"),
    ("scipy solve_ivp,", "scipy, differential equation,"),
    ("heyoka,", "heyoka, differential equation,"),
    ("R_F, R_J", "Carlson integrals"),
    ("over quad", "of a quadrature"),
    (" of quad", " of a quadrature"),
    ("of str to", "of the standard racket to"),
    ("of str on", "of the standard racket on"),
    (", gmpy2", " (gmpy2)"),
    (", python", " (python)"),
)


def worded(method: str) -> str:
    """Return the name of a method in words of a reader: what is computed, and by which library."""
    for name, words in _WORDS:
        method = method.replace(name, words)
    return method


def span(values: list[float], digits: int = 2) -> str:
    """Return the range of some numbers in words: ``3 to 40``, or ``3`` if they are equal."""
    low, high = (f"{Decimal(f'{x:.{digits}g}'):,f}" for x in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def time_span(seconds: list[float]) -> str:
    """Return the range of some times in words: ``3 µs to 4 ms``."""
    low, high = time_text(min(seconds)), time_text(max(seconds))
    return low if low == high else f"{low} to {high}"


def measured_with(data: dict[str, Any]) -> str:
    """Return the machine and the versions with which the data were measured."""
    machine, found = data["machine"], data["versions"]
    words = [f"{name} {v}" for name, v in found.items() if v != "not installed"]
    part = "" if data.get("complete", True) else " The run was interrupted."
    return (
        f"Measured on {machine['processor']}, {machine['cores']} cores, {', '.join(words)}.{part}"
    )


def below(figure: Any, caption: str) -> None:
    """Set the caption below the picture, in a strip that the layout leaves free."""
    width, height = figure.get_size_inches()
    lines = textwrap.wrap(caption, int(width * 19.5))
    strip = 0.125 * len(lines) + 0.14
    figure.set_size_inches(width, height + strip)
    share = strip / (height + strip)
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    figure.text(
        0.08 / width,
        share - 0.05 / (height + strip),
        "\n".join(lines),
        va="top",
        fontsize=6.6,
        color="0.25",
        linespacing=1.25,
    )


def time_text(seconds: float) -> str:
    """Return a time with three digits and its unit."""
    for scale, unit in ((1e9, "ns"), (1e6, "µs"), (1e3, "ms")):
        if seconds * scale < 999.5:
            return f"{seconds * scale:.3g} {unit}"
    return f"{seconds:.3g} s"


def time_axis(axis: Any, low: float, high: float) -> None:
    """Make a logarithmic axis of seconds, with ticks at common units."""
    import math

    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    step = 1 if last - first <= 5 else 2 if last - first <= 10 else 3
    exponents = [n for n in range(first, last + 1) if n % step == 0]
    axis.set_ticks([10.0**n for n in exponents], [tick_text(n) for n in exponents])
    axis.set_ticks([], minor=True)


def tick_text(exponent: int) -> str:
    """Return 10ⁿ seconds as a round number of a unit."""
    unit, base = next(
        (u, n) for u, n in (("s", 0), ("ms", -3), ("µs", -6), ("ns", -9)) if exponent >= n
    )
    return f"{10 ** (exponent - base)} {unit}"
