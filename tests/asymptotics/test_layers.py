"""Boundary layers: problems with exact solutions, true composites and planted mistakes.

The truth comes from the exact solution of linear equations with constant coefficients, in mpmath.
"""

import random
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import mpmath
import pytest

from tresym.checking.dispatch import decide_claim


def _problems(seed: int, count: int) -> Iterator[tuple[int, int, int, int, int]]:
    """Yield a, b, f and the values at 0 and 1 for e*y'' + a*y' + b*y == f."""
    chance = random.Random(seed)
    while count:
        a, b = chance.choice((-2, -1, 0, 1, 2, 3)), chance.choice((-2, -1, 0, 1, 2))
        f, low, high = (chance.randint(-2, 2) for _ in range(3))
        if a == 0 and b >= 0:
            continue
        layer = low != high if a == 0 == f else True
        count -= 1
        if layer:
            yield a, b, f, low, high


def _outer(a: int, b: int, f: int, point: int, value: int) -> str:
    """Return the solution of a*y' + b*y == f with a value at a point."""
    if a == 0:
        return f"({f})/({b})"
    if b == 0:
        return f"{value} + ({f})/({a})*(x - {point})"
    return f"({f})/({b}) + ({value} - ({f})/({b}))*exp(-({b})/({a})*(x - {point}))"


def _at(e: str, x: int) -> str:
    return re.sub(r"\bx\b", f"({x})", e)


def _claims(a: int, b: int, f: int, low: int, high: int) -> Iterator[tuple[str, str]]:
    """Yield right sides of claims O(e), uniform in 0 <= x <= 1, with what is wrong in each."""
    if a == 0:
        outer, rate = _outer(0, b, f, 0, 0), f"sqrt({-b})"
        left, right = f"({low} - ({outer}))", f"({high} - ({outer}))"
        near, far = f"exp(-{rate}*x/sqrt(e))", f"exp(-{rate}*(1 - x)/sqrt(e))"
        yield "", f"{outer} + {left}*{near} + {right}*{far}"
        if low * b != f:
            yield "missing layer", f"{outer} + {right}*{far}"
            yield "wrong rate", f"{outer} + {left}*exp(-2*{rate}*x/sqrt(e)) + {right}*{far}"
        return
    end, other = (1, 0) if a > 0 else (0, 1)
    values = (low, high)
    outer = _outer(a, b, f, end, values[end])
    gap = f"({values[other]} - ({_at(outer, other)}))"
    distance = "x" if a > 0 else "(1 - x)"
    yield "", f"{outer} + {gap}*exp(-({abs(a)})*{distance}/e)"
    yield "wrong constant", f"{outer} + x*(1 - x) + {gap}*exp(-({abs(a)})*{distance}/e)"
    size = eval_at_zero(outer, values[other], other)
    if abs(size) > 1e-9:
        yield "wrong rate", f"{outer} + {gap}*exp(-({2 * abs(a)})*{distance}/e)"
        yield "missing layer", outer
        wrong = _outer(a, b, f, other, values[other])
        away = "(1 - x)" if a > 0 else "x"
        yield "wrong side", f"{wrong} + ({values[end]} - ({_at(wrong, end)}))*exp(-{away}/e)"


def eval_at_zero(outer: str, value: int, point: int) -> float:
    """Return the height of the layer."""
    return float(value - _function(outer)(mpmath.mpf(point), mpmath.mpf(1)))


def _function(text: str) -> Callable[[mpmath.mpf, mpmath.mpf], mpmath.mpf]:
    code = compile(re.sub(r"\b(\d+)\b", r"mpf(\1)", text.replace("^", "**")), "claim", "eval")
    names = {"exp": mpmath.exp, "sqrt": mpmath.sqrt, "mpf": mpmath.mpf}
    return lambda x, e: eval(code, {"__builtins__": {}}, {**names, "x": x, "e": e})


def _exact(
    a: int, b: int, f: int, low: int, high: int, e: mpmath.mpf
) -> Callable[[mpmath.mpf], mpmath.mpf]:
    """Return the exact solution."""
    root = mpmath.sqrt(mpmath.mpc(a * a - 4 * e * b))
    one, two = (-a + root) / (2 * e), (-a - root) / (2 * e)
    if b:
        start = mpmath.mpf(f) / b
        special: Callable[[mpmath.mpf], mpmath.mpf] = lambda x: start  # noqa: E731
    else:
        special = lambda x: mpmath.mpf(f) / a * x  # noqa: E731
    terms = [(rate, 1 if mpmath.re(rate) > 0 else 0) for rate in (one, two)]

    def basis(x: mpmath.mpf) -> list[mpmath.mpc]:
        return [mpmath.exp(rate * (x - start)) for rate, start in terms]

    matrix = mpmath.matrix([basis(mpmath.mpf(0)), basis(mpmath.mpf(1))])
    factors = mpmath.lu_solve(matrix, mpmath.matrix([low - special(0), high - special(1)]))
    return lambda x: mpmath.re(
        special(x) + sum(c * u for c, u in zip(factors, basis(x), strict=True))
    )


def _error(problem: tuple[int, int, int, int, int], right: str, e: mpmath.mpf) -> mpmath.mpf:
    exact, claimed = _exact(*problem, e), _function(right)
    points = [mpmath.mpf(k) / 40 for k in range(41)]
    near = [step for k in range(1, 12) if (step := mpmath.mpf(k) * e / 4) < 1]
    points += [*near, *(1 - step for step in near)]
    return max(abs(exact(x) - claimed(x, e)) for x in points)


def _given(a: int, b: int, f: int, low: int, high: int) -> str:
    equation = f"e*diff(y(x), x, 2) + ({a})*diff(y(x), x) + ({b})*y(x) == {f}"
    return f"{equation}, y(0) == {low}, y(1) == {high}, 0 <= x <= 1"


@pytest.mark.parametrize("problem", [*_problems(11, 4)])
def test_planted_mistakes_are_refuted_and_constants_bound_the_exact_error(
    problem: tuple[int, int, int, int, int],
) -> None:
    with mpmath.workdps(60):
        for mistake, right in _claims(*problem):
            claim = f"y(x) == {right} + O(e) uniformly given {_given(*problem)} as e -> 0+"
            answer = decide_claim(claim)
            small = [_error(problem, right, mpmath.mpf(10) ** -k) * 10**k for k in (2, 4)]
            assert (small[1] > 3 * small[0] + 1) == bool(mistake), (claim, small)
            if mistake:
                assert answer.verdict.value == "REFUTED", (mistake, claim)
                continue
            assert answer.verdict.value == "ENCLOSED", claim
            assert answer.constant is not None
            assert answer.region is not None
            reach = mpmath.mpf(eval(answer.region.split()[-1]))
            constant = mpmath.mpf(answer.constant.mid) * (1 + mpmath.mpf(10) ** -6)
            for e in (reach, reach / 3, reach / 20):
                assert _error(problem, right, e) <= constant * e


def test_the_textbook_problems_of_the_page_are_decided() -> None:
    mistaken, verdicts = False, []
    text = Path(__file__).parents[2].joinpath("docs/examples/layers.txt").read_text()
    for line in text.splitlines()[2:]:
        if line.startswith("#"):
            mistaken = line != "# Slow times."
            continue
        verdicts.append((mistaken, decide_claim(line).verdict.value))
    assert len(verdicts) == 20
    assert all((value == "REFUTED") == wrong for wrong, value in verdicts)
    assert "UNDECIDED" not in {value for _, value in verdicts}
