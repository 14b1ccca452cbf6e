"""Published statements that fail: refuted as printed, and true as corrected."""

import random
import re
from pathlib import Path

import pytest
from in_mpmath import is_true_at_points, value

from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import mp_precision
from tresym.reals.numbers.exact import InputError
from tresym.report.pages.published_errors import LIST, Failure, judged, read

DOCS = Path(__file__).parents[3] / "docs"
ALL = list(read((DOCS / LIST).read_text(encoding="utf-8")))
QUICK = random.Random(71).sample(ALL, 4)


@pytest.mark.parametrize("one", QUICK, ids=lambda one: one.source)
def test_what_is_printed_fails_and_the_correction_holds(one: Failure) -> None:
    judged(one)


@pytest.mark.night
@pytest.mark.parametrize("one", ALL, ids=lambda one: one.source)
def test_every_printed_statement_fails(one: Failure) -> None:
    judged(one)


def test_by_mpmath_at_points() -> None:
    """What needs no integral, limit or O, without tresym's decision."""
    elementary = [
        one for one in ALL if not any(word in one.printed for word in ("integral", " as ", "sum("))
    ]
    assert len(elementary) > 5
    for one in elementary:
        claim, _, given = one.printed.partition(" given ")
        assert not is_true_at_points(claim if "==" in given else one.printed), one.printed
        assert is_true_at_points(one.true), one.true


DEFINITE = re.compile(r"integral\((.*), (\w), ([^,]+), ([^,]+)\) (==|>) (.*)$")


def test_by_quadrature() -> None:
    """Definite integrals without parameters, by mpmath on 24 pieces."""
    checked = 0
    for one in ALL:
        printed, true = DEFINITE.match(one.printed), DEFINITE.match(one.true)
        if printed is None or true is None or "oo" in one.printed or " given " in one.printed:
            continue
        checked += 1
        assert not _agrees(printed), one.printed
        assert _agrees(true), one.true
    assert checked > 10


def _agrees(claim: re.Match[str]) -> bool:
    body, name, *ends, sign, right = claim.groups()
    with mp_precision(15) as m:
        low, high = (value(m, parse(end), {}) for end in ends)
        f, points = parse(body), m.linspace(low, high, 25)
        found = m.quad(lambda x: value(m, f, {name: x}), points, maxdegree=3)
        wanted = value(m, parse(right), {})
        return bool(abs(found - wanted) < 1e-3 if sign == "==" else 0 < found - wanted < 1e-3)


@pytest.mark.parametrize(
    ("printed", "true"),
    [("cos(x) == cos(-x)", "cos(x) == cos(-x)"), ("cos(x) == sin(x)", "sin(x) == cos(x + pi/2)")],
)
def test_nobody_is_accused_wrongly(printed: str, true: str) -> None:
    with pytest.raises(InputError, match="not REFUTED and true"):
        judged(Failure("", "a book", printed, true))
