"""Table 1: every printed cell, judged by what its row prints.

Inputs and outputs are intervals of half a unit in the last printed place. For each row:

- `…_order`: the moments are in the order I₁ < I₂ < I₃ that the paper assumes;
- `…_realizable`: a rigid body can have these moments;
- `…_a`, `…_b`: the shape from the printed moments;
- `…_epsilon0`, `…_flip`: the flip defect by the exact equation,
  `…_epsilon0_formula`, `…_flip_formula`: the same by the paper's asymptotic formula, and
  `…_flip_from_epsilon0`: the last column computed from the column before it.

They are computed from the moments if the row has usable ones, else from its printed a and b.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from tresym.proofs.euler_angles import d08
from tresym.proofs.flip_definition import eqdefect
from tresym.proofs.printed import MOMENTS, ROW_LINES, TABLE_1, inputs, moments, number, share_of_pi
from tresym.proofs.separatrix import flip_defect, leading_defect, one_flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *
from tresym.reals.numbers.exact import printed as printed_interval

Given = tuple[Basic, ...]


def as_printed(**texts: str) -> tuple[Basic, ...]:
    """Conditions that symbols lie in the intervals their printed decimals stand for."""
    conditions: list[Basic] = []
    for name, text in texts.items():
        read = printed_interval(text)
        symbol = Symbol(name, real=True)
        conditions += [symbol >= _rational(read.low), symbol <= _rational(read.high)]
    return tuple(conditions)


def _rational(x: fmpq) -> Rational:
    return Rational(int(x.p), int(x.q))


def _cell(
    row: str, column: str, x: str, formula: Expr, given: Given, reading: str, *claims: Claim
) -> Claim:
    """One printed number; ``reading`` is empty, ``formula`` or ``from_epsilon0``."""
    name = {"epsilon0": "ε₀", "flip": "1 − Δψ/π"}.get(column, column)
    how = {
        "": "",
        "formula": " by the asymptotic formula",
        "from_epsilon0": " from the printed ε₀",
    }[reading]
    return number(
        f"Table 1, {row}: {name} = {{}}{how}.",
        formula,
        x,
        given,
        *claims,
        label="_".join(p for p in ("table", row.replace("-", "_"), column, reading) if p),
        where=Place(line=ROW_LINES[row], cell=column),
    )


def _order(row: str) -> Claim:
    """The moments as printed are in the order that the paper assumes."""
    texts = dict(zip(MOMENTS, TABLE_1[row][:3], strict=True))
    return Claim(
        label=f"table_{row.replace('-', '_')}_order",
        says=f"Table 1, {row}: I₁ < I₂ < I₃.",
        given=as_printed(**texts),
        means=Tuple(I1 < I2, I2 < I3),
        proof=formally(),
        where=Place(line=ROW_LINES[row], cell="I1, I2, I3"),
    )


def _defects(row: str, given: Given, *claims: Claim) -> list[Claim]:
    """The last two columns of a row, by the exact equation and by the formula."""
    x, share = TABLE_1[row][5:]
    cells = []
    for reading, defect, of in (
        ("", epsilon0, (flip_defect, one_flip_defect)),
        ("formula", epsilon_printed, (leading_defect,)),
    ):
        known = (*claims, *of)
        cells.append(_cell(row, "epsilon0", x, defect, given, reading, *known))
        flip = share_of_pi(defect)
        cells.append(_cell(row, "flip", share, flip, given, reading, *known, eqdefect))
    flip = share_of_pi(epsilon0)
    cells.append(_cell(row, "flip", share, flip, inputs(epsilon0=x), "from_epsilon0", eqdefect))
    return cells


def _row(row: str) -> tuple[Claim, ...]:
    """All cells of a row whose moments are printed and usable."""
    one, two, three = MOMENTS
    first, second = TABLE_1[row][3:5]
    shape_a = _cell(row, "a", first, a, moments(row, one, two), "", d08)
    shape_b = _cell(row, "b", second, b, moments(row, two, three), "", d08)
    return (_order(row), shape_a, shape_b, *_defects(row, moments(row), d08))


def _realizable(row: str, label: str, **rest: Any) -> Claim:
    """The moments as printed are those of a rigid body: none exceeds the sum of the two others."""
    texts = dict(zip(MOMENTS, TABLE_1[row][:3], strict=True))
    return Claim(
        label=label,
        says=f"Table 1, {row}: a rigid body can have these moments.",
        given=as_printed(**texts),
        means=Tuple(I3 <= I1 + I2, I2 <= I1 + I3, I1 <= I2 + I3),
        proof=formally(),
        where=Place(line=ROW_LINES[row], cell="I1, I2, I3"),
        **rest,
    )


def _excess(row: str, least: int, relation: Basic) -> Claim:
    """By how much one of the printed moments exceeds the sum of the two others."""
    texts = dict(zip(MOMENTS, TABLE_1[row][:3], strict=True))
    return Claim(
        label=f"{row.replace('-', '_')}_excess",
        says=f"With the moments printed for {row} the largest exceeds the sum of the others by "
        f"{least} or more.",
        kind="bound",
        given=as_printed(**texts),
        means=relation,
        proof=formally(),
    )


def _impossible(row: str, least: int, relation: Basic) -> tuple[Claim, Claim]:
    """That no rigid body has the moments of a row, and by how much."""
    excess = _excess(row, least, relation)
    label = f"table_{row.replace('-', '_')}_realizable"
    refuted: dict[str, Any] = {"expect": Verdict.REFUTED, "amended_by": (excess,)}
    return excess, _realizable(row, label, **refuted)


str_realizable = _realizable("str", "table_str_realizable")
racket_1_realizable = _impossible("racket-1", 1046, I3 - I1 - I2 >= 1046)
racket_2_realizable = _impossible("racket-2", 409, I3 - I1 - I2 >= 409)
racket_3_realizable = _impossible("racket-3", 4858, I2 - I1 - I3 >= 4858)

standard_racket = _row("str")
racket_1 = _row("racket-1")
racket_2 = _row("racket-2")

_third = dict(zip(MOMENTS, TABLE_1["racket-3"][:3], strict=True))
_needed = (*as_printed(I2=_third["I2"], b=TABLE_1["racket-3"][4]),)

racket_3_third_moment = Claim(
    says="With the printed I₂, the printed b = 0.12 needs an I₃ between 8051 and 8145, not 1818.",
    kind="bound",
    given=_needed,
    means=Tuple(8051 * (1 - b) < I2, 8145 * (1 - b) > I2),
    proof=formally(),
)

racket_3_swapped_b = number(
    "With I₃ = 8118 racket 3 has b = {}.", b, "0.1222", inputs(I2=7126, I3=8118), d08
)

racket_3_swapped_order = Claim(
    says="With I₃ = 8118 racket 3 has I₁ < I₂ < I₃, and I₃ exceeds the sum of the others.",
    given=as_printed(I1=_third["I1"], I2=_third["I2"]),
    means=Tuple(I1 < I2, I2 < 8118, I1 + I2 < 8118),
    proof=formally(),
)

racket_3_swapped = Claim(
    **jointly(racket_3_swapped_order, racket_3_swapped_b),
    note="No rigid body has these moments either.",
)

racket_3_a = number(
    "With the printed moments of racket 3, a = {} to two decimals.",
    a,
    "14.91",
    moments("racket-3", "I1", "I2"),
    d08,
)

_SHAPES = {row: inputs(a=TABLE_1[row][3], b=TABLE_1[row][4]) for row in ("racket-3", "book")}

racket_3 = (
    replace(
        _order("racket-3"),
        expect=Verdict.REFUTED,
        amended_by=(racket_3_third_moment, racket_3_swapped),
        fault=Fault.MISPRINT,
    ),
    replace(
        _cell("racket-3", "a", "14.88", a, moments("racket-3", "I1", "I2"), "", d08),
        expect=Verdict.REFUTED,
        amended_by=(racket_3_a,),
        fault=Fault.ROUNDING,
    ),
    replace(  # Its moments are out of order, so that its shape has no name.
        _cell("racket-3", "b", "0.12", 1 - I2 / I3, moments("racket-3", "I2", "I3"), ""),
        expect=Verdict.REFUTED,
        amended_by=(racket_3_third_moment, racket_3_swapped),
        fault=Fault.MISPRINT,
    ),
    *_defects("racket-3", _SHAPES["racket-3"]),
)

book = tuple(_defects("book", _SHAPES["book"]))

label_claims(globals())
