"""Sums, integrals, limits and derivatives in LaTeX, and what is refused of them."""

import pytest

from tresym.reals.language.latex import read_latex
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.exact import InputError

READ = {
    r"\int_0^1 x\,dx = 1": "integral(x, x, 0, 1)",
    r"\sum_{k=1}^n k = 1": "sum(k, k, 1, n)",
    r"\prod_{k=1}^n k = 1": "product(k, k, 1, n)",
    r"\lim_{x \to 0^+} \ln x = 1": "limit(log(x), x, 0, 1)",
    r"\frac{d}{dx} \sin x = 1": "diff(sin(x), x)",
}
REFUSED = [r"\int_0^1 x = 1", r"\sum^n k = 1", r"\lim \ln x = 1"]


@pytest.mark.parametrize("source", READ)
def test_what_binds_a_variable_is_read(source: str) -> None:
    (chain,) = read_latex(source)
    left, _, _ = next(iter(chain.links))
    assert left == as_written(READ[source])


@pytest.mark.parametrize("source", REFUSED)
def test_what_binds_no_variable_is_refused(source: str) -> None:
    with pytest.raises(InputError):
        read_latex(source)
