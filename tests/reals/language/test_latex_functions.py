"""Functions with their arguments in LaTeX: where an argument ends, and roots and binomials."""

import pytest

from tresym.reals.language.latex import read_latex
from tresym.reals.language.parsing import as_written

READ = {
    r"\sin 2x = 1": "sin(2*x)",
    r"\sin x + 1 = 1": "1 + sin(x)",
    r"\sin^2 x = 1": "sin(x)**2",
    r"\sqrt[3]{x} = 1": "cbrt(x)",
    r"\binom{n}{2} = 1": "n*(n - 1)/2",
    r"\ln\left(1 + x\right) = 1": "log(1 + x)",
}


@pytest.mark.parametrize("source", READ)
def test_functions_take_their_arguments(source: str) -> None:
    (chain,) = read_latex(source)
    left, _, _ = next(iter(chain.links))
    assert left == as_written(READ[source])
