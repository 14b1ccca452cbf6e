"""Trees of orders: found for polynomials without negative values, and for no others."""

from fractions import Fraction

import pytest

from tresym.coq.polynomial_certificates import Span, cone_lines
from tresym.reals.language.parsing import parse

POSITIVE = Span(Fraction(0))
TRUE = [
    ("x**4*y**2 + x**2*y**4 - 3*x**2*y**2 + 1", {}, None),
    ("a**2*b + b**2*c + c**2*a - 3*a*b*c", dict.fromkeys("abc", POSITIVE), None),
    ("4/27 - x**2*(1 - x)", {"x": Span(Fraction(0), Fraction(1))}, None),
    ("1/27 - x*y*z", dict.fromkeys("xyz", POSITIVE), "1 - x - y - z"),
]
FALSE = [
    ("x**4*y**2 + x**2*y**4 - 3*x**2*y**2 + 999999/1000000", {}, None),
    ("a**2*b + b**2*c + c**2*a - 3*a*b*c", {}, None),
    ("4/27 - x**2*(1 - x)", {"x": Span(None, Fraction(1))}, None),
    ("1/27 - x*y*z - 1/10**9", dict.fromkeys("xyz", POSITIVE), "1 - x - y - z"),
    ("1/27 - x*y*z", dict.fromkeys("xyz", POSITIVE), "2 - x - y - z"),
]


def _lines(text: str, spans: dict[str, Span], total: str | None) -> list[str] | None:
    known = {parse(name): span for name, span in spans.items()}
    return cone_lines(parse(text), known, None if total is None else parse(total))


@pytest.mark.parametrize(("text", "spans", "total"), TRUE)
def test_a_tree_is_found(text: str, spans: dict[str, Span], total: str | None) -> None:
    lines = _lines(text, spans, total)
    assert lines is not None
    assert "cone." in "\n".join(lines)


@pytest.mark.parametrize(("text", "spans", "total"), FALSE)
def test_none_is_found_for_a_falsehood(
    text: str, spans: dict[str, Span], total: str | None
) -> None:
    assert _lines(text, spans, total) is None
