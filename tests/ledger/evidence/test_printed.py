"""Printed numbers: accepted with inputs that give them, refuted where none do."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from flint import arb, fmpq

from tresym.ledger.claim import Printed
from tresym.ledger.evidence.printed import judge_printed
from tresym.reals.numbers.arithmetic import balls
from tresym.reals.numbers.exact import printed
from tresym.reals.verdict import Verdict

ENCLOSED, REFUTED = Verdict.ENCLOSED, Verdict.REFUTED

Formula = Callable[..., arb]


def half(x: arb, m: Any) -> arb:
    return x / 2


def root(x: arb, m: Any) -> arb:
    return m.sqrt(x)


def product_(x: arb, y: arb, m: Any) -> arb:
    return x * y


def bump(x: arb, m: Any) -> arb:
    return x * (1 - x)


TABLE: list[tuple[str, Formula, dict[str, str | fmpq], Verdict]] = [
    ("3.1416", lambda m: m.pi, {}, ENCLOSED),
    ("3.1415", lambda m: m.pi, {}, REFUTED),
    ("3.141592653589793238462643", lambda m: m.pi, {}, ENCLOSED),
    ("3.141592653589793238462644", lambda m: m.pi, {}, REFUTED),
    ("1.414", root, {"x": fmpq(2)}, ENCLOSED),
    ("1.41", root, {"x": "2.0"}, ENCLOSED),
    ("1.425", root, {"x": "2.0"}, ENCLOSED),  # of 2.03, which rounds to 2.0
    ("1.435", root, {"x": "2.0"}, REFUTED),
    ("1.435", root, {"x": "2"}, ENCLOSED),
    ("0.50", half, {"x": "1.0"}, ENCLOSED),
    ("0.54", half, {"x": "1.0"}, REFUTED),
    ("0.55", half, {"x": fmpq(1)}, REFUTED),
    ("6.3", product_, {"x": "2.1", "y": "3.0"}, ENCLOSED),
    ("6.5", product_, {"x": "2.1", "y": "3.0"}, ENCLOSED),
    ("6.7", product_, {"x": "2.1", "y": "3.0"}, REFUTED),
    ("-0.5", half, {"x": "-1.0"}, ENCLOSED),
    ("0.5", half, {"x": "-1.0"}, REFUTED),
    ("0.250", bump, {"x": "0.5"}, ENCLOSED),
    ("0.252", bump, {"x": "0.5"}, REFUTED),
    ("0.2481234", bump, {"x": "0.5"}, ENCLOSED),  # no point of the grid gives it
]


@pytest.mark.parametrize(("text", "formula", "inputs", "verdict"), TABLE)
def test_printed_numbers(
    text: str, formula: Formula, inputs: dict[str, str | fmpq], verdict: Verdict
) -> None:
    found = judge_printed(Printed(text, formula, inputs))
    assert found.verdict is verdict
    assert found.value is not None
    assert found.witness is not None
    low, high = printed(text)[:2]
    value = formula(*(arb(x) for x in found.witness.values()), balls)
    for name, given in inputs.items():
        ends = printed(given) if isinstance(given, str) else (given, given)
        assert ends[0] <= found.witness[name] <= ends[1]
    if len(text) < 12:
        assert bool(value > low and value < high) is (verdict is ENCLOSED)


def test_more_half_units_allow_more() -> None:
    assert judge_printed(Printed("3.15", lambda m: m.pi)).verdict is REFUTED
    assert judge_printed(Printed("3.15", lambda m: m.pi, half_units=2)).verdict is ENCLOSED


def test_at_the_edge_of_a_rounding_nothing_is_said() -> None:
    assert judge_printed(Printed("0.5", lambda m: arb(fmpq(55, 100)))).verdict is not ENCLOSED


def test_what_is_undefined_at_the_inputs_does_not_hold() -> None:
    assert not judge_printed(Printed("1.0", root, {"x": "-2.0"})).verdict.holds
