"""Section 7, end: the book as a box, and the units and columns of Table 1.

A box of length L, width W and height H has the principal axes e₁, e₂, e₃ along its edges.

- display (30), `d30`: the a and b of a book;
- `box_a`, `box_b`: the shape of a box; `box_order`: its moments are ordered as in the paper;
- `book_length`, `book_height`: the proportions that the printed a and b require; such a box exists;
- `table_units`: the printed unit is not a unit of a moment of inertia;
- `last_column`: the last column is π − 2ε₀.
"""

from __future__ import annotations

from tresym.proofs.printed import inputs, number
from tresym.proofs.table_of_objects import book, racket_1, racket_2, racket_3, standard_racket

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

mass, length, width, height = (Symbol(name, real=True) for name in ("m", "L", "W", "H"))
_box = (mass > 0, length > 0, width > 0, height > 0, width - height > 0, length - width > 0)

_across = ((width, height), (length, height), (length, width))
"""The sides of the box across each axis."""


def _spread(side: Symbol) -> Integral:
    """The mean of the squared distance from the middle of a side."""
    return Integral(x**2 / side, (x, -side / 2, side / 2))


box_moments = Claim(
    says=equations((I1, I2, I3), tuple(mass * (p**2 + q**2) / 12 for p, q in _across)),
    proof=Definition(),
    where=line(291),
    note="A homogeneous box: length along e₁, width along e₂, height along e₃. That these are its "
    "moments is shown in `moments_of_a_box`.",
)


def _spread_of(label: str, side: Symbol) -> Claim:
    return Claim(
        label=label,
        says=equal(_spread(side), side**2 / 12),
        given=(side > 0,),
        proof=by(integrating(x**3 / (3 * side))),
    )


spreads = tuple(
    _spread_of(f"spread_over_{name}", side)
    for name, side in (("length", length), ("width", width), ("height", height))
)

moments_of_a_box = Claim(
    says=equations(tuple(mass * _spread(p) + mass * _spread(q) for p, q in _across), (I1, I2, I3)),
    given=_box,
    proof=by(substituting(box_moments, *spreads)),
    where=line(291),
    note="The moment about an axis is the integral of the squared distance from it over the mass, "
    "which is spread evenly: the sum of its means over the two directions across the axis.",
)

box_order = Claim(
    says=Tuple(I1 > 0, I2 - I1 > 0, I3 - I2 > 0),
    given=_box,
    proof=by(substituting(box_moments)),
    where=line(291),
    note="With L > W > H the axes are in the order that the paper assumes.",
)

_a, _b = printed.shape(I1, I2, I3)
_a_of_box = (length**2 - width**2) / (width**2 + height**2)
_b_of_box = (width**2 - height**2) / (length**2 + width**2)

box_a = Claim(
    says=equal(_a, _a_of_box), given=_box, proof=by(substituting(box_moments)), where=line(291)
)

box_b = Claim(
    says=equal(_b, _b_of_box), given=_box, proof=by(substituting(box_moments)), where=line(291)
)

_PRINTED = inputs(a="1.11", b="0.31")
_length_squared = (1 + 2 * a - a * b) / (1 + a * b)
"""(L/W)² of the box with the shape (a, b)."""
_height_squared = (1 - 2 * b - a * b) / (1 + a * b)
"""(H/W)²."""

box_of_a_shape = Claim(
    says="The box with (L/W)² = (1 + 2a − ab)/(1 + ab), (H/W)² = (1 − 2b − ab)/(1 + ab) has the "
    "shape (a, b).",
    means=Tuple(
        equal(_length_squared - 1, a * (1 + _height_squared)),
        equal(1 - _height_squared, b * (_length_squared + 1)),
    ),
    given=(a > 0, b > 0),
    proof=formally(),
)

book_length = number(
    "The printed a and b need a book with L/W = {}.", sqrt(_length_squared), "1.46", _PRINTED
)

book_height = number(
    "The printed a and b need a book with H/W = {}.", sqrt(_height_squared), "0.16", _PRINTED
)

_PROPORTIONS = (Rounds(length, "1.46"), Rounds(height, "0.16"), equal(width, 1))

book_a = number(
    "A book with L/W = 1.46 and H/W = 0.16 has a = {}.", _a_of_box, "1.11", _PROPORTIONS
)

book_b = number(
    "A book with L/W = 1.46 and H/W = 0.16 has b = {}.", _b_of_box, "0.31", _PROPORTIONS
)

d30 = Claim(
    kind="number",
    **jointly(box_a, box_b, box_of_a_shape, book_length, book_height, book_a, book_b),
    where=display(30),
    note="No dimensions are printed, so this is all that can be checked.",
)

_x, _y = (Symbol(name, real=True) for name in "xy")
_changed = (_x > 0, _y > 0)

unit_of_inertia = Claim(
    says="1 kg m² is 10⁶ kg mm²: a unit that changes by the square of the length unit.",
    means=equal(10**6 * at(_y**2, {_y: _x / 1000}), _x**2),
    given=_changed,
    proof=by(evaluating),
)

table_units = Claim(
    says="kg mm⁻¹ s⁻² is a unit of a moment of inertia: with a length unit x times and a time "
    "unit y times as large it changes by x².",
    given=_changed,
    means=equal(1 / (_x * _y**2), _x**2),
    proof=formally(),
    where=line(295),
    expect=Verdict.REFUTED,
    amended_by=(unit_of_inertia,),
    note="The printed unit is a unit of pressure; the numbers agree with those of the "
    "bibliography in kg mm².",
    fault=Fault.MISPRINT,
)


def _named(claims: tuple[Claim, ...], end: str) -> list[Claim]:
    return [claim for claim in claims if claim.label.endswith(end)]


last_column = Claim(
    kind="number",
    **jointly(
        *(
            claim
            for row in (standard_racket, racket_1, racket_2, racket_3, book)
            for claim in _named(row, "_flip_from_epsilon0")
        )
    ),
    where=line(293),
)

fig_compar_racket = Claim(
    kind="number",
    **jointly(
        *(
            claim
            for row in (standard_racket, racket_1, racket_2, racket_3, book)
            for claim in _named(row, "_epsilon0")
            if not claim.label.endswith("_from_epsilon0")
        )
    ),
    where=line(314),
    note="The ε₀ of each body, by the exact equation.",
)

label_claims(globals())
