"""Proofs of inequalities: found by the ways of the prover of signs, and accepted by Coq."""

import pytest

from tresym.coq.candidate_search import export
from tresym.coq.claim_export import theorems
from tresym.coq.inequalities import inequality_proofs
from tresym.coq.reductions import reductions
from tresym.coq.statement import formula
from tresym.reals.decisions.claim_parsing import read


@pytest.mark.parametrize(
    ("claim", "left"),
    [
        ("x**x >= exp(-1/E) given x > 0", "(-1) * / (exp 1) <= x * ln x"),
        ("tanh(x) >= x/(1 + x) given x >= 0", "0 <= tanh x * (x + 1) + (-1) * x"),
        ("abs(sin(2*x)) <= 2*abs(sin(x))", "Rabs (sin (2 * x)) <= 2 * sin x"),
    ],
)
def test_what_implies_it(claim: str, left: str) -> None:
    (theorem,) = theorems(read(claim))
    assert left in [formula(step.says) for way in reductions(theorem) for step in way.steps]


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        ("sin(x) >= 2*x/pi given 0 <= x <= pi/2", "concave fun_0"),
        ("x**4*y**2 + x**2*y**4 - 3*x**2*y**2 + 1 >= 0", "cone."),
        ("(x + y + z)/3 >= cbrt(x*y*z) given x > 0, y > 0, z > 0", "some_root_lt 3"),
        ("x*y*z <= 1/27 given x > 0, y > 0, z > 0, x + y + z <= 1", "cone."),
        ("x**3 + y**3 + z**3 >= 3 given x > 0, y > 0, z > 0, x + y + z >= 3", "by squared"),
        ("exp(x) >= 1 + x", "from_left_ge"),
        ("tanh(x) < x given x > 0", "from_left_gt"),
        ("exp(x) > 1 + x given x < 0", "from_right_gt"),
        ("exp(x) > x given x >= 0", "from_left_start_gt"),
        ("sinh(x)/x > 1 given x > 0", "sig_2"),
    ],
)
def test_the_way_of_the_prover_of_signs(claim: str, words: str) -> None:
    (theorem,) = theorems(read(claim))
    assert any(words in proof for proof in list(inequality_proofs(theorem))[:5])


@pytest.mark.coq
@pytest.mark.parametrize(
    ("claim", "true"),
    [
        ("a**2*b + b**2*c + c**2*a >= 3*a*b*c given a > 0, b > 0, c > 0", True),
        ("log(x) >= 1 - 1/x", True),
        ("x/(1+x) < log(1+x) given x > 0", True),
        ("sin(x) < x given x > 0", True),
        ("x*exp(-x) <= 1/exp(1)", True),
        ("sinh(x)/x > 1 given x > 0", True),
        ("sinh(x) > x given x > -1", False),
        ("sin(x) < x given x >= 0", False),
        ("x*exp(-x) <= 9/25", False),
        ("x/(1+x) < log(1+x) given x > -1", False),
        ("exp(x) >= 1 + x + x**2/2 given x >= -1/100", False),
    ],
)
def test_coq_accepts_what_is_true_alone(claim: str, true: bool) -> None:
    assert export(theorems(read(claim)), 300).accepted is true
