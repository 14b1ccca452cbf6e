"""Claims of every relation about anything the grammar has: each ends in an answer or one line."""

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import tresym
from tresym.reals.language.expression import FUNCTIONS
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

CONSTANTS = ("0", "1", "2", "-1", "1/2", "pi", "E", "10**(-30)", "sqrt(2)")
LEAVES = st.sampled_from(("x", "x", "x", "y", *CONSTANTS))
EXPONENTS = st.sampled_from(("2", "3", "-1", "1/2", "1/3", "-2", "x"))


def _larger(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(
        st.builds("{}({})".format, st.sampled_from(sorted(FUNCTIONS)), inner),
        st.builds("({} {} {})".format, inner, st.sampled_from("+-*/"), inner),
        st.builds("({})**({})".format, inner, EXPONENTS),
        st.builds("max({}, {})".format, inner, inner),
        st.builds("diff({}, x)".format, inner),
    )


SIDES = st.recursive(LEAVES, _larger, max_leaves=4)
CLAIMS = st.builds(
    "{} {} {}".format, SIDES, st.sampled_from(("==", "!=", ">", ">=", "<", "<=")), SIDES
)
ORDERS = st.builds(
    "{} {}".format,
    SIDES.map(lambda e: e.replace("y", "2")),
    st.one_of(
        st.builds("== {}({})".format, st.sampled_from("Oo"), SIDES), st.builds("~ {}".format, SIDES)
    ).map(lambda e: e.replace("y", "3")),
)
CONDITIONS = st.sampled_from(("", "x > 0", "0 <= x <= 1", "-1 < x < 2", "x != 0", "x**2 >= y"))
PATHS = st.builds(
    "x -> {}".format, st.sampled_from(("0", "0+", "0-", "oo", "-oo", "1", "pi/2", "sqrt(2)"))
)


def _said(claim: str, **more: str) -> str:
    """What is said of the claim: a verdict and its reason, or why it is not read."""
    try:
        answer = tresym.check(claim, **more)
    except InputError as error:
        return str(error)
    assert isinstance(answer.verdict, Verdict)
    return answer.why


@given(CLAIMS, CONDITIONS)
@example("cos(x) != 1", "0 < x < 7")
@example("pi != tan(y)", "x > 0")
@example("cosh(x/2)*tanh(10**(-30))/pi > cosh(x/2)*tanh(10**(-30))/pi*1", "x != 0")
@example("cosh(x)*tanh(x/10**9) == sinh(x)*tanh(x/10**9)/tanh(x)", "")
@example("sin(x) + sin(sqrt(2)*x) < 2", "")
@settings(max_examples=100)
def test_any_comparison_is_answered(claim: str, conditions: str) -> None:
    assert len(_said(claim, given=conditions).splitlines()) == 1


@pytest.mark.slow
@given(ORDERS, PATHS)
@settings(max_examples=30)
def test_any_order_is_answered(claim: str, path: str) -> None:
    assert len(_said(claim, path=path).splitlines()) == 1
