"""Wrong constants, regions and orders in place of the right ones: none is ever ENCLOSED.

They were written by hand, by what the paper and its proofs say, and not by the code that makes
mutants. What is said is changed and the evidence left as it is; of some bounds the margins are
changed along, and searched anew.
"""

from dataclasses import replace
from typing import Any

import pytest
from cases import cases
from flint import fmpq

from tresym.ledger.claim import Claim, saying
from tresym.ledger.formulas import Rounded, Tending, in_order, mapped
from tresym.ledger.judge import judge_evidence
from tresym.ledger.paper import all_claims
from tresym.reals.language.binders import outermost
from tresym.reals.language.expression import Expr, number, replaced, substitute, symbol
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import as_written, parse_given
from tresym.reals.language.paths import read_path
from tresym.reals.numbers.exact import as_rational
from tresym.reals.verdict import Verdict

BY_LABEL = {claim.label: claim for claim in all_claims()}
quarter = "a*b >= 1/4"

CONSTANTS = cases(__file__, "CONSTANTS")
"""Label, the constant that is said, and a wrong one."""

REGIONS: list[tuple[str, str, str | None]] = [
    ("printed_error", quarter, "a*b >= 1/100"),
    ("repaired", quarter, "a*b >= 1/25"),
    ("second_order", quarter, None),
    ("third_order", quarter, "a*b >= 1/5"),
    ("repaired_from_1_100", "a >= 1/100", "a >= 1/1000"),
    ("repaired_from_1", "a >= 1", "a >= 1/2"),
    ("repaired_from_10", "a >= 10", "a >= 1"),
    ("second_order_from_5", "a >= 5", "a >= 4"),
    ("bend_leaves", "epsilon0 <= 3/4", "epsilon0 <= 3"),
    ("d38", "4*a - b >= 0", "9*a - b >= 0"),
    ("eqnew", "4*a - b >= 0", None),
    ("one_line", "b <= 1", "b <= 2"),
    ("everywhere", "b <= 1", None),
    ("newton_line", "b <= 1", "b <= 3"),
    ("d52", quarter, None),
    ("remark1", quarter, None),
    ("majorant_exists", quarter, "a*b >= 1/100"),
    ("bend_carries", "gamma <= 1/500", "gamma <= 1/100"),
    ("bend_carries", "gamma >= -1/500", "gamma >= -1/100"),
    ("printed_relative_error", "b >= 1/4", "b >= 1/1000"),
    ("printed_relative_error", "a*b >= 4", "a*b >= 1/4"),
    ("repaired", quarter, None),
    ("d57", quarter, "a*b >= 1/400"),
    ("d56", quarter, None),
    ("d52_true_order", "b >= 1/2", "b >= 1/100"),
    ("d56_true_order", "b >= 3/4", None),
    ("d57_true_order", "b >= 3/4", "b >= 1/10"),
    ("slope_leading_term", quarter, None),
    ("terms_decrease", quarter, "a*b >= 1/16"),
    ("repaired_from_1_2", "a >= 1/2", "a >= 1/10"),
    ("second_order_from_1", "a >= 1", "a >= 1/4"),
    ("u_flat_order", quarter, None),
    ("balanced_line", "b <= 1", "b <= 5"),
]
"""Label, the condition that is given, and a wider one, or none."""

NUMBERS = cases(__file__, "NUMBERS")
"""Label, and another number than is printed."""


def _said(text: str) -> Relation:
    ((left, sign, right),) = parse_given(text)
    return Relation(in_order(left), sign, in_order(right))


def _named(text: str) -> Expr:
    """An expression with λ, which the grammar keeps for itself."""
    return in_order(substitute(as_written(text), {"lam": symbol("lambda")}))


def _ordered(label: str, by: str, of: str = "1", to: str = "") -> Claim:
    """The order that is claimed with another gauge in o(…), the left side ``of`` times as large."""
    claim = BY_LABEL[label]
    says = claim.statement
    assert isinstance(says, Tending)
    left, sign, right = says.relation
    (node,) = (e for e in outermost(right) if e.op == "o")
    right = replaced(right, {node: Expr("o", (_named(by),))})
    path = says.path
    if to:
        new = read_path(f"{path.name or 'z'} -> {to}")
        path = replace(path, point=new.point, sides=new.sides)
    factor = _named(of)
    left = left if of == "1" else in_order(factor * left)
    return saying(claim, Tending(Relation(left, sign, right), path))


def _orders() -> list[Claim]:
    return [
        _ordered("flat_from_above", "x**10", to="0-"),
        _ordered("flat_from_above", "exp(-1/x)"),
        _ordered("flat_from_above", "exp(-2/x)"),
        _ordered("flat_from_above", "x**10", of="exp(1/x)"),
        _ordered("flat_from_above", "x**10", of="x**10", to="oo"),
        _ordered("flat_from_above", "x**10", to="1+"),
        _ordered("slopes_vanish", "exp(-2/lam)"),
        _ordered("slopes_vanish", "exp(-3/lam)"),
        _ordered("slopes_vanish", "lam**10", to="0-"),
        _ordered("product_is_approached", "1/a"),
        _ordered("product_is_approached", "1/a**2"),
        _ordered("product_is_approached", "1", of="2"),
        _ordered("product_is_approached", "1", of="a"),
        _ordered("product_is_approached", "1", to="0+"),
        _ordered("flat_from_above", "exp(-1/x)*x"),
        _ordered("flat_from_above", "exp(-1/x**2)"),
        _ordered("flat_from_above", "x**10", of="exp(2/x)"),
        _ordered("flat_from_above", "x**10", to="2+"),
        _ordered("slopes_vanish", "exp(-2/lam)/lam"),
        _ordered("slopes_vanish", "lam**10", of="exp(2/lam)"),
        _ordered("slopes_vanish", "1/lam**3", to="oo"),
        _ordered("product_is_approached", "1/(a + 1)"),
    ]


def _verdict(claim: Claim) -> Verdict:
    found = judge_evidence(claim)
    assert found is not None
    return found.verdict


def _with_constant(label: str, right: str, wrong: str) -> Claim:
    claim = BY_LABEL[label]
    assert claim.statement is not None
    put = {number(as_rational(right)): number(as_rational(wrong))}
    changed = mapped(claim.statement, lambda e: replaced(e, put))
    assert changed != claim.statement, label
    return saying(claim, changed)


@pytest.mark.parametrize(("label", "right", "wrong"), CONSTANTS)
@pytest.mark.slow
def test_no_wrong_constant(label: str, right: str, wrong: str) -> None:
    assert not _verdict(_with_constant(label, right, wrong)).holds


@pytest.mark.parametrize(("label", "right", "wrong"), REGIONS, ids=str)
def test_no_wrong_region(label: str, right: str, wrong: str | None) -> None:
    claim, said = BY_LABEL[label], _said(right)
    assert said in claim.given
    wider = () if wrong is None else (_said(wrong),)
    given = tuple(each for c in claim.given for each in (wider if c == said else (c,)))
    assert not _verdict(replace(claim, given=given)).holds


@pytest.mark.parametrize(("label", "text"), NUMBERS)
def test_no_wrong_number(label: str, text: str) -> None:
    claim = BY_LABEL[label]
    says = claim.statement
    assert isinstance(says, Rounded)
    assert says.text != text
    assert not _verdict(saying(claim, Rounded(says.term, text, says.half_units))).holds


@pytest.mark.parametrize("claim", _orders(), ids=lambda c: f"{c.label}: {c.statement}")
def test_no_wrong_order(claim: Claim) -> None:
    assert not _verdict(claim).holds


@pytest.mark.parametrize(
    ("label", "right", "wrong"),
    [
        ("printed_error", "17/100", "3/20"),
        ("repaired", "1451/1000", "7/5"),
        ("second_order", "149/50", "29/10"),
        ("one_line", "7/250", "1/40"),
        ("u_flat_order", "9/1000", "1/125"),
    ],
)
def test_no_wrong_constant_in_the_margins_too(label: str, right: str, wrong: str) -> None:
    claim = _with_constant(label, right, wrong)
    less: fmpq = as_rational(right) - as_rational(wrong)
    proof: Any = claim.proof
    on = tuple(
        replace(
            place,
            shown=tuple(
                replace(shown, margin=lambda *at, margin=shown.margin: margin(*at) - less)
                for shown in place.shown
            ),
        )
        for place in proof.on
    )
    assert not _verdict(replace(claim, proof=replace(proof, on=on, stored=None, budget=200))).holds
