"""Claims are printed with their terms in the order and the form in which they were typed."""

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from tresym.papers.reading import PaperClaim, read_paper
from tresym.reals.language.as_typed import as_typed
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse_claim
from tresym.reals.language.typesetting import to_latex

CASES = [
    ("(1 + t)**n == 1 + n*t + O(t**2) as t -> 0", r"(1 + t)^{n} = 1 + n \, t + O(t^{2})"),
    ("1/2*x + x/3 - 3/4 <= 0.5*x", r"\frac{x}{2} + \frac{x}{3} - \frac{3}{4} \le 0.5 \, x"),
    ("binomial(2*n, n) <= 4**n", r"\binom{2 \, n}{n} \le 4^{n}"),
    ("2*sqrt(x)/(3*x) == 2/3/sqrt(x)", r"\frac{2 \, \sqrt{x}}{3 \, x} = \frac{2}{3 \, \sqrt{x}}"),
    ("-(1 - x)**2 <= 0 given x > 1", r"-(1 - x)^{2} \le 0"),
    ("sin(2*(y + x))**2 >= 0", r"\sin^{2}(2 \, (y + x)) \ge 0"),
    ("eps*(2 + eps) > 0", r"\epsilon \, (2 + \epsilon) > 0"),
    ("x - (y - x) == 2*x - y", r"x - (y - x) = 2 \, x - y"),
]


def links(text: str) -> tuple[PaperClaim, ...]:
    names = "n, t, x, y, eps real\n"
    paper = read_paper(f"{names}a: {text}")
    assert not paper.problems
    return tuple(item for item in paper.items if isinstance(item, PaperClaim))


@pytest.mark.parametrize(("text", "shown"), CASES)
def test_terms_keep_their_order(text: str, shown: str) -> None:
    (claim,) = links(text)
    assert to_latex(as_typed(claim.text, claim.shown)) == shown


def test_another_text_than_what_is_decided_is_not_printed() -> None:
    (claim,) = links("1 + x > x")
    assert as_typed("2 + x > x", claim.shown) is claim.shown
    assert as_typed("1 + x > x > 0", claim.shown) is claim.shown


ATOMS = st.sampled_from(["x", "y", "2", "3", "0.5", "7"])
TEXTS = st.recursive(
    ATOMS,
    lambda e: st.one_of(
        st.tuples(e, st.sampled_from(["+", "-", "*", "/"]), e).map(lambda p: f"({' '.join(p)})"),
        e.map(lambda p: f"(-{p})"),
        e.map(lambda p: f"{p if p[0] == '(' or p.isalnum() else f'({p})'}**2"),
    ),
    max_leaves=6,
)


def value(e: Expr) -> arb:
    """The value of a tree for print at x = 3, y = 7, by its operations alone."""
    if e.op == "symbol":
        return {"x": arb(3), "y": arb(7)}.get(e.args[0]) or arb(e.args[0])
    if e.op == "number":
        return arb(e.args[0])
    values = [value(arg) for arg in e.args]
    if e.op == "^":
        return values[0] ** values[1]
    total = values[0]
    for other in values[1:]:
        total = total + other if e.op == "+" else total * other
    return total


@given(TEXTS)
def test_a_tree_for_print_has_the_value_of_the_text(text: str) -> None:
    claim = f"{text} == 1"
    try:
        decided = tuple(parse_claim(claim))
    except ValueError:  # divided by zero
        return
    ((left, _, _),) = as_typed(claim, decided)
    (expected, found) = value(decided[0][0]), value(left)
    assert expected.overlaps(found) or not found.is_finite()
