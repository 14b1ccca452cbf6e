"""The certified tables of the racket, by name.

Every digit in them is proved by a ball (an interval given by midpoint and radius).
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from difflib import get_close_matches
from fractions import Fraction
from math import ceil, floor, log10

from flint import arb, fmpq

from tresym.accuracy.table import Table
from tresym.accuracy.table import written as in_format
from tresym.racket.body import NAMED_BODIES, Shape
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, as_rational, fraction_text, quoted


def digits_of(x: arb, digits: int) -> str:
    """Return ``x`` as text, with only the digits that its ball proves.

    Args:
        x: a ball.
        digits: the most digits to show. The last one shown is correct to within one unit.
    """
    return str(x.str(digits, radius=False))


def rounded_to(x: arb, digits: int, way: str) -> str:
    """Return ``x`` as a decimal with so many significant digits that is not above, or not below, x.

    Args:
        x: a ball that does not contain 0.
        digits: the number of significant digits.
        way: ``"down"`` or ``"up"``.
    """
    mantissa, power = (x.lower() if way == "down" else x.upper()).man_exp()
    exact = Fraction(int(mantissa)) * Fraction(2) ** int(power)
    scale = digits - 1 - floor(log10(abs(exact)))
    scaled = exact * Fraction(10) ** scale
    whole = floor(scaled) if way == "down" else ceil(scaled)
    return f"{Decimal(whole).scaleb(-scale):f}"


def _percent(x: arb) -> str:
    return digits_of(100 * x, 3) + " %"


def objects() -> Table:
    """Compute Table 1 of the paper, with 50 certified digits of each defect."""
    from tresym.racket.flip.separatrix import solve

    rows = []
    for name, body in NAMED_BODIES.items():
        found = solve(*body.shape, 50)
        with ball_precision(256):
            share = 2 * found.defect / arb.pi()
        rows.append(
            (
                name,
                _short(body.shape.a),
                _short(body.shape.b),
                "yes" if body.shape.realizable else "no",
                digits_of(found.defect, 50),
                digits_of(share, 6),
            )
        )
    return Table(
        "Flip defect on the separatrix of the named bodies, from exactly the printed data: ε₀ in "
        "radians by the exact equation, and x in Δψ = π(1 − x).",
        ("body", "a", "b", "rigid body", "ε₀", "x"),
        tuple(rows),
    )


def _shapes(widths: tuple[fmpq, ...]) -> list[tuple[str, Shape]]:
    """The shapes of the tables: ab from 10⁻³ to 10⁴ for each b in ``widths``, and the bodies."""
    from tresym.racket.comparison.errors import PRODUCTS

    grid = [
        (f"ab = {_power(p)}, b = {fraction_text(b)}", Shape(p / b, b))
        for b in widths
        for p in PRODUCTS
    ]
    return grid + [(name, body.shape) for name, body in NAMED_BODIES.items()]


def errors() -> Table:
    """Compute the relative error of each formula for ε₀ against the exact equation."""
    from tresym.racket.comparison.errors import FORMULAS, WIDTHS, errors_at

    rows = []
    for name, shape in _shapes(WIDTHS):
        found = errors_at(*shape)
        rows.append((name, *(_signed(found[f]) for f in FORMULAS)))
    return Table(
        "Relative error, formula/ε₀ − 1, of each explicit formula for the flip defect on the "
        "separatrix; every digit certified.",
        ("shape", *FORMULAS),
        tuple(rows),
    )


def constants() -> Table:
    """Compute the constants in the bounds on ε₀/ε* for a ≥ a₀, and how far each can be improved."""
    from tresym.racket.comparison.constants import CONSTANTS, excesses

    rows = []
    for row in CONSTANTS:
        cells = []
        for proved, found in zip(row[1:], excesses(as_rational(row.least), fmpq(1)), strict=True):
            with ball_precision(64):
                over = _percent(arb(as_rational(proved)) / found - 1)
            cells += [proved, digits_of(found, 5), over]
        rows.append((row.least, *cells))
    return Table(
        "Constants of |ε₀/ε* − 1| ≤ K ε*² and |ε₀/ε* − 1 − c₁ε*²| ≤ K₂ ε*⁴ on a ≥ a₀, 0 < b ≤ 1, "
        "proved by interval subdivision; the ratio at a = a₀, b = 1, which is a lower bound for "
        "the constant; and by how much the constant exceeds it.",
        ("a₀", "K", "at a₀", "excess", "K₂", "at a₀", "excess"),
        tuple(rows),
    )


def slope() -> Table:
    """Compute dε/dγ at γ = 0 exactly and by its leading term."""
    from tresym.racket.comparison.errors import WIDTHS, slope_with_error

    rows = []
    for name, shape in _shapes(WIDTHS):
        exact, leading, off = slope_with_error(*shape)
        rows.append((name, digits_of(exact, 15), digits_of(leading, 15), _percent(off)))
    return Table(
        "Slope dε/dγ at γ = 0: the closed form, its leading term −1/(4bε₀) with the exact ε₀, and "
        "the relative error of the latter.",
        ("shape", "dε/dγ", "−1/(4bε₀)", "error"),
        tuple(rows),
    )


def thresholds() -> Table:
    """Compute the levels γ at which the flip is off by π/6, exactly and by the linear formula."""
    from tresym.racket.angle import parse_angle
    from tresym.racket.comparison.errors import linear_thresholds
    from tresym.racket.flip.levels import level_of, turning_level

    ends = {"-pi/12": 0, "pi/12": 1}
    rows = []
    for name, shape in _shapes((fmpq(1), fmpq(1, 10))):
        turn = turning_level(*shape, 20)
        linear = linear_thresholds(*shape)
        cells = []
        for text, n in ends.items():
            try:
                cells.append(digits_of(level_of(*shape, parse_angle(text), 20), 12))
            except InputError:
                cells.append("none")
            cells.append(digits_of(linear[n], 12))
        rows.append((name, *cells, "none" if turn is None else digits_of(turn, 12)))
    return Table(
        "Levels γ at which ε(γ) = ∓π/12, exactly and by the linear formula with the exact ε₀, and "
        "the level γ* below which the trajectory reaches a turning point of ψ first. None: "
        "ε(γ) does not take that value where it is monotone.",
        ("shape", "ε = −π/12", "linear", "ε = π/12", "linear", "γ*"),
        tuple(rows),
    )


def routes() -> Table:
    """Compute ε(γ) by independent methods: how many digits of each agree with the ball."""
    from tresym.racket.comparison.routes import ROUTES, compare

    rows = tuple(
        (row.body, row.gamma, digits_of(row.ball, 20), *map(str, row.digits)) for row in compare()
    )
    heads = tuple(f"{route.name} (of {route.digits})" for route in ROUTES[1:])
    return Table(
        "ε(γ) by independent methods, which share only f or the differential equations: how many "
        "of the digits that each is designed to give agree with the ball.",
        ("body", "γ", "ε(γ)", *heads),
        rows,
        keys=2,
    )


TABLES: dict[str, Callable[[], Table]] = {
    "objects": objects,
    "errors": errors,
    "constants": constants,
    "slope": slope,
    "thresholds": thresholds,
    "routes": routes,
}
"""The tables of ``tresym table``, by name."""


def table(name: str) -> Table:
    """Compute the table ``name``, one of :data:`TABLES`.

    Raises:
        InputError: there is no table of that name; the nearest name is suggested.
    """
    if name not in TABLES:
        near = get_close_matches(name, TABLES, n=1)
        hint = f"did you mean {near[0]}? " if near else ""
        tables = ", ".join(TABLES)
        raise InputError(f"table: there is no table {quoted(name)}; {hint}tables: {tables}")
    return TABLES[name]()._replace(name=name)


LONGEST = 22
"""Characters of a number in LaTeX."""


def written(found: Table, form: str) -> str:
    """Return a table as ``form``: text, markdown, latex, csv or html."""
    from tresym.report.pages.derivation import prose

    return in_format(found, form, prose, LONGEST)


def _short(x: fmpq) -> str:
    return digits_of(arb(x), 6)


def _signed(x: arb) -> str:
    return ("+" if x > 0 else "") + digits_of(x, 3)


def _power(x: fmpq) -> str:
    return str(float(x)) if float(x) < 1 else str(int(x.p))
