"""Signs that are seen: what is written of sums with a premise, and of sines and cosines."""

from tresym.coq.equations import fewest_terms
from tresym.coq.linear_dependence import expanded
from tresym.coq.statement import Theorem, term
from tresym.coq.structural_signs import factored, manifest_proofs, premise_lines
from tresym.reals.language.expression import ZERO, symbol
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import parse


def test_a_sum_with_a_premise_is_the_premise_and_the_rest() -> None:
    t = Theorem(
        "t",
        ("a", "b", "x"),
        (),
        (Relation(parse("a - b"), ">=", ZERO),),
        (),
        Relation(parse("a*(a - b + x**2)"), ">=", ZERO),
    )
    (line,) = [line for line in premise_lines(t, t.left) if "replace" in line]
    assert "by ring" in line
    assert next(manifest_proofs(t)).startswith("intros; saturate.")


def test_the_numerator_is_factored_without_a_square() -> None:
    d = parse("cos(p)**2*sin(q)**2 + cos(q)**2 + sin(p)**2 - 1")
    forms = [term(top) for top, _ in factored(d)]
    assert any("+" not in form and "-" not in form for form in forms), forms


def test_fewer_terms_are_taken() -> None:
    u = parse("(m*cos(p)*sin(q))**2 + (m*sin(p)*sin(q))**2")
    assert len(expanded(fewest_terms(u))) == 1
    assert fewest_terms(symbol("m")) == symbol("m")
