"""Orders from each side of a path: constants that bound, ranges that hold, and near falsehoods."""

import pytest
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


PAIRS = [
    ("sin(x) - x == O(x**3) as x -> 0", "sin(x) - x == O(x**4) as x -> 0"),
    ("sin(x) - x == o(x**2) as x -> 0", "sin(x) - x == o(x**3) as x -> 0"),
    ("sin(x) - x ~ -x**3/6 as x -> 0", "sin(x) - x ~ -x**3/7 as x -> 0"),
    ("1 - cos(x) ~ x**2/2 as x -> 0", "1 - cos(x) ~ x**2/2 + x**2/10**9 as x -> 0"),
    ("abs(x) ~ x as x -> 0+", "abs(x) ~ x as x -> 0"),
    ("abs(x) ~ -x as x -> 0-", "abs(x) ~ x as x -> 0-"),
    ("exp(1/x) == O(1) as x -> 0-", "exp(1/x) == O(1) as x -> 0"),
    ("sqrt(x) == O(1) as x -> 0+", "sqrt(x) == O(x) as x -> 0+"),
    ("x*log(x) == o(sqrt(x)) as x -> 0+", "x*log(x) == O(x) as x -> 0+"),
    ("log(x) == o(x**(1/10)) as x -> oo", "log(x) == O(1) as x -> oo"),
    ("exp(-x) == o(x**(-3)) as x -> oo", "exp(-x) == O(exp(-2*x)) as x -> oo"),
    ("sqrt(x**2 + 1) - x ~ 1/(2*x) as x -> oo", "sqrt(x**2 + 1) - x ~ 1/(2*x) as x -> -oo"),
    ("sqrt(x**2 + 1) + x ~ -1/(2*x) as x -> -oo", "sqrt(x**2 + 1) + x ~ 1/x as x -> -oo"),
    ("cos(x) ~ pi/2 - x as x -> pi/2", "cos(x) ~ x - pi/2 as x -> pi/2"),
    ("log(x) ~ x - 1 as x -> 1", "log(x) ~ 2*x - 2 as x -> 1"),
    ("x**2 - 2 == O(x - sqrt(2)) as x -> sqrt(2)", "x**2 - 2 == o(x - sqrt(2)) as x -> sqrt(2)"),
    ("tanh(x) - 1 ~ -2*exp(-2*x) as x -> oo", "tanh(x) - 1 == o(exp(-2*x)) as x -> oo"),
    ("0*x == o(x) as x -> 0", "x == o(0*x + x) as x -> 0"),
    ("1/x == O(1/x**2) as x -> 0", "1/x**2 == O(1/x) as x -> 0"),
    ("sin(x)*log(x) == O(log(x)) as x -> oo", "sin(x)*log(x) == o(log(x)) as x -> oo"),
    ("log(log(x)) == o(log(x)) as x -> oo", "log(log(x)) == O(1) as x -> oo"),
    ("exp(1/2*log(log(x)**2)) ~ -log(x) as x -> 0+", "exp(1/2*log(log(x)**2)) ~ log(x) as x -> 0+"),
    (
        "exp(1/2*log(log(x)**2)) + log(x) == O(1) as x -> 0+",
        "exp(1/2*log(log(x)**2)) - log(x) == O(1) as x -> 0+",
    ),
]


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


OPEN = [
    "x == O(x*sin(1/x)) as x -> 0",  # zeros of the gauge towards the end
    "sqrt(x) == O(x) as x -> 0-",  # not real there
    "log(x) == O(log(x)) as x -> -oo",
    "x == O(0*x) as x -> 0",
    "1/(x - x) == O(1) as x -> 0",
    "acos(1 + x) == O(1) as x -> 0",  # real on one side only
    "diff(log(-x), x) == O(1/x) as x -> 0+",  # the formal derivative of what is not real
    "diff(log(x**2 - 1), x) == O(1) as x -> 0",
    "diff(acos(x), x)**2 == O(1) as x -> 3",
    "diff(log(x*sin(1/x)), x) == O(1/x**2) as x -> 0+",
]


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


SMOOTH = [
    ("sin(x) - x == O(x**3) as x -> 0", True),
    ("sin(x) - x == O(x**4) as x -> 0", False),
    ("sin(x) - x == o(x**2) as x -> 0", True),
    ("sin(x) - x == o(x**3) as x -> 0", False),
    ("sin(x) - x ~ -x**3/6 as x -> 0", True),
    ("sin(x) - x ~ x**3/6 as x -> 0", False),
    ("sin(x) - x ~ -x**3/6*(1 + 10**(-30)) as x -> 0", False),
    ("x**2 - 2 ~ 2*sqrt(2)*(x - sqrt(2)) as x -> sqrt(2)", True),
    ("x**2 - 2 ~ 3*(x - sqrt(2)) as x -> sqrt(2)", False),
    ("log(x/3) ~ x/3 - 1 as x -> 3", True),
    ("tan(x) - 2 == O(x - atan(2)) as x -> atan(2)", True),
    ("tan(x) - 2 == O((x - atan(2))**2) as x -> atan(2)", False),
    ("cos(x) == O(1) as x -> pi/2", True),
    ("sin(x) == O(x*(1/8 - x)) as x -> 0", True),
    ("cos(x) == o(1) as x -> pi/2", True),
    ("x**2 ~ 2*x as x -> 0", False),
    ("sin(x) ~ x**3/6 + x**2/2 as x -> 0", False),
    ("x**2 == O(2*x) as x -> 0", True),
    ("x == O(x**2/2) as x -> 0", False),
    ("x + abs(x)**3 ~ x as x -> 0", True),
    ("(1/x + 1/2)*log(1 + x) - 1 ~ x**2/12 as x -> 0", True),  # a step of Stirling's series
    ("(1/x + 1/2)*log(1 + x) - 1 == O(x**3) as x -> 0", False),
]


@pytest.mark.parametrize(("claim", "truth"), SMOOTH)
def test_smooth_functions_compare_by_their_first_derivatives(claim: str, truth: bool) -> None:
    assert decided(claim).verdict is (Verdict.ENCLOSED if truth else Verdict.REFUTED)


SUPREMA = [
    ("exp(-x) == O(1) as x -> 0+", "1"),
    ("x**2*exp(-3*x) == O(x) as x -> 0+", "exp(-1)/3"),
    ("x + 3*x**3 == O(x) as x -> 0+", "4"),
    ("x*(1 - x)*(1 - x) == O(1) as x -> 0+", "4/27"),
    ("0*x == O(x) as x -> 0+", "0"),
    ("sin(x) - x == O(x**3) as x -> 0", "1/6"),
]
"""The supremum of the ratio on (0, 1]: in the limit, inside, at the end."""


@pytest.mark.parametrize(("claim", "expected"), SUPREMA)
def test_the_supremum_lies_in_the_constant(claim: str, expected: str) -> None:
    found = decided(claim)
    assert found.constant is not None
    assert (found.region or "").endswith("<= 1") or expected == "0"
    mid, rad = map(parse_number, found.constant)
    with ball_precision():
        assert arb(mid, rad).overlaps(evaluate(parse(expected), {}))
    assert rad <= mid / 100


def test_a_range_ends_where_a_side_does() -> None:
    for claim in ("log(1 - 4*x) == O(x) as x -> 0+", "x == O(sqrt(1 - 4*x)) as x -> 0+"):
        found = decided(claim)
        assert found.verdict is Verdict.ENCLOSED
        assert parse_number((found.region or "").split()[-1]) < fmpq(1, 4)
