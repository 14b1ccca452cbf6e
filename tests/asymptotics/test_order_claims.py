"""Orders from each side of a path: constants that bound, ranges that hold, and near falsehoods."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.asymptotics.order_claims import decide_order
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict


def _read(claim: str) -> Statement:
    return read(claim)


def decided(claim: str) -> Answer:
    statement = _read(claim)
    assert statement.path is not None
    return decide_order(statement.comparisons[0], statement.path)


PAIRS = cases(__file__, "PAIRS")


@pytest.mark.parametrize(("true", "_"), PAIRS, ids=[p[0] for p in PAIRS])
def test_true_orders_are_enclosed_with_a_range(true: str, _: str) -> None:
    found = decided(true)
    assert found.verdict is Verdict.ENCLOSED
    assert found.region


@pytest.mark.parametrize(("_", "false"), PAIRS, ids=[p[1] for p in PAIRS])
def test_near_falsehoods_do_not_hold(_: str, false: str) -> None:
    assert not decided(false)


@pytest.mark.parametrize(
    ("claim", "order"),
    [
        ("sin(x) - x == O(x**4) as x -> 0", "x**3"),
        ("cos(x) - 1 == o(x**2) as x -> 0", "x**2"),
        ("sqrt(x) == O(x) as x -> 0+", "sqrt(x)"),
    ],
)
def test_the_true_order_is_named(claim: str, order: str) -> None:
    found = decided(claim)
    assert found.verdict is Verdict.REFUTED
    assert order in found.why
    assert found.witness is not None


CONSTANTS = [
    ("sin(x) - x == O(x**3) as x -> 0", 0),
    ("exp(x) - 1 == O(x) as x -> 0", 0),
    ("x + 1 == O(x) as x -> oo", None),
    ("abs(x) + x == O(x) as x -> 0", 0),
    ("sqrt(1 + x) == O(1) as x -> 0-", 0),
    ("log(x) == O(x - 1) as x -> 1", 1),
]


@pytest.mark.parametrize(("claim", "point"), CONSTANTS)
def test_the_constant_bounds_the_ratio_on_the_whole_range(claim: str, point: int | None) -> None:
    statement, found = _read(claim), decided(claim)
    assert statement.path is not None
    assert found.constant is not None
    comparison = statement.comparisons[0]
    reach = parse_number((found.region or "").split()[-1].lstrip("-"))
    with ball_precision(200):
        mid, rad = (arb(parse_number(text)) for text in found.constant)
        largest = arb(0)
        for side in statement.path.sides:
            for n in range(1, 60):
                x = side * reach * 60 / n if point is None else point + side * reach * fmpq(n, 60)
                at = {"x": arb(x)}
                ratio = abs(evaluate(comparison.left, at) / evaluate(comparison.right, at))
                largest = largest.max(ratio)
        assert largest.lower() <= mid + rad
        assert largest > (mid - rad) * 0.9  # and no more than it must be


OPEN = cases(__file__, "OPEN")


@pytest.mark.parametrize("claim", OPEN)
def test_what_is_not_real_on_the_way_does_not_hold(claim: str) -> None:
    assert not decided(claim)


@pytest.mark.parametrize(
    ("path", "start"),
    [
        ("0", "0 < |x|"),
        ("0+", "0 < x"),
        ("0-", "0 < -x"),
        ("1", "0 < |x - 1|"),
        ("oo", "x >="),
        ("-oo", "x <= -"),
        ("pi/2", "0 < |x - pi/2|"),
    ],
)
def test_the_range_is_said_in_the_variable(path: str, start: str) -> None:
    found = decided(f"x + 3 == O(x**2 + 3) as x -> {path}")
    assert (found.region or "").startswith(start)


@pytest.mark.parametrize("path", ["0-", "1", "oo", "-oo"])
def test_a_witness_is_on_the_path(path: str) -> None:
    claim = f"x**2 + 3 == o(1) as x -> {path}"
    found = decided(claim)
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    assert found.values is not None
    ((name, text),) = found.witness.items()
    x, point = parse_number(text), path.rstrip("-").replace("oo", "0") or "0"
    assert name == "x"
    assert (x < 0) is (path in ("0-", "-oo"))
    assert abs(x - int(point)) <= 1 or "oo" in path
    ratio = parse_number(found.values[0].mid) / parse_number(found.values[1].mid)
    assert ratio == x**2 + 3


SMOOTH = cases(__file__, "SMOOTH")


@pytest.mark.parametrize(("claim", "truth"), SMOOTH)
def test_smooth_functions_compare_by_their_first_derivatives(claim: str, truth: bool) -> None:
    assert decided(claim).verdict is (Verdict.ENCLOSED if truth else Verdict.REFUTED)


SUPREMA = cases(__file__, "SUPREMA")
"""The supremum of the ratio on (0, 1]: in the limit, inside, at the end."""


@pytest.mark.parametrize(("claim", "expected"), SUPREMA)
def test_the_supremum_lies_in_the_constant(claim: str, expected: str) -> None:
    found = decided(claim)
    assert found.constant is not None
    assert (found.region or "").endswith("<= 1")
    mid, rad = map(parse_number, found.constant)
    with ball_precision():
        assert arb(mid, rad).overlaps(evaluate(parse(expected), {}))
    assert rad <= mid / 100


def test_a_range_ends_where_a_side_does() -> None:
    for claim in ("log(1 - 4*x) == O(x) as x -> 0+", "x == O(sqrt(1 - 4*x)) as x -> 0+"):
        found = decided(claim)
        assert found.verdict is Verdict.ENCLOSED
        assert parse_number((found.region or "").split()[-1]) < fmpq(1, 4)
