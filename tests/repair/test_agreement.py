"""Whether values of a changed claim agree with those of the original."""

from tresym.reals.language.parsing import as_written, parse
from tresym.repair.agreement import without_integrals


def test_an_equation_of_indefinite_integrals_is_one_of_their_derivatives() -> None:
    link = as_written("integral(2*x, x)"), "==", parse("x**2")
    assert without_integrals(link) == (parse("2*x"), "==", parse("2*x"))
    plain = parse("x"), "==", parse("x**2")
    assert without_integrals(plain) == plain
