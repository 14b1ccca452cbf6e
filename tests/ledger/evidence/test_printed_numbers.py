"""Printed numbers: accepted with inputs that give them, refuted where none do."""

from dataclasses import replace
from functools import partial
from typing import Any

import pytest
from derivations import by, derived, step
from flint import arb, fmpq
from sympy import Basic, Eq, Expr, Integer, Integral, Symbol, Tuple, cos, pi, sin, sqrt
from sympy_statements import AtMostOne, ExactlyOne, Rounds, TheRoot

from tresym.ledger.claim import (
    Claim,
    Definition,
    Monotone,
    Printed,
    Root,
)
from tresym.ledger.evidence import printed_numbers as checker
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.printed_numbers import judge_printed, number_of
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import differentiating_integral
from tresym.reals.language import expression
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, printed
from tresym.reals.verdict import Verdict

equal = partial(Eq, evaluate=False)

ENCLOSED, REFUTED, UNDECIDED = Verdict.ENCLOSED, Verdict.REFUTED, Verdict.UNDECIDED

p, q, x, y, z = (Symbol(name, real=True) for name in "pqxyz")
ZERO, ONE, TWO = map(Integer, (0, 1, 2))


def number(
    term: Expr, text: str, *given: Basic, using: tuple[Claim, ...] = (), half_units: int = 1
) -> Claim:
    means = Rounds(term, text, half_units)
    return Claim("number", "a number", Printed(using), given=given, means=means)


def verdict(claim: Claim) -> Verdict:
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    return found[claim.label].verdict


TABLE: list[tuple[str, Expr, dict[Symbol, str | int], Verdict]] = [
    ("3.1416", pi, {}, ENCLOSED),
    ("3.1415", pi, {}, REFUTED),
    ("3.141592653589793238462643", pi, {}, ENCLOSED),
    ("3.141592653589793238462644", pi, {}, REFUTED),
    ("1.414", sqrt(p), {p: 2}, ENCLOSED),
    ("1.41", sqrt(p), {p: "2.0"}, ENCLOSED),
    ("1.425", sqrt(p), {p: "2.0"}, ENCLOSED),  # of 2.03, which rounds to 2.0
    ("1.435", sqrt(p), {p: "2.0"}, REFUTED),
    ("1.435", sqrt(p), {p: "2"}, ENCLOSED),
    ("0.50", p / 2, {p: "1.0"}, ENCLOSED),
    ("0.54", p / 2, {p: "1.0"}, REFUTED),
    ("0.55", p / 2, {p: 1}, REFUTED),
    ("6.3", p * q, {p: "2.1", q: "3.0"}, ENCLOSED),
    ("6.5", p * q, {p: "2.1", q: "3.0"}, ENCLOSED),
    ("6.7", p * q, {p: "2.1", q: "3.0"}, REFUTED),
    ("-0.5", p / 2, {p: "-1.0"}, ENCLOSED),
    ("0.5", p / 2, {p: "-1.0"}, REFUTED),
    ("0.250", p * (1 - p), {p: "0.5"}, ENCLOSED),
    ("0.252", p * (1 - p), {p: "0.5"}, REFUTED),
    ("0.2481234", p * (1 - p), {p: "0.5"}, ENCLOSED),  # no point of the grid gives it
    ("0.33", Integral(x**2, (x, 0, p)), {p: "1.00"}, ENCLOSED),
    ("0.36", Integral(x**2, (x, 0, p)), {p: "1.00"}, REFUTED),
]


def as_given(inputs: dict[Symbol, str | int]) -> tuple[Basic, ...]:
    return tuple(Rounds(s, v) if isinstance(v, str) else equal(s, v) for s, v in inputs.items())


@pytest.mark.parametrize(("text", "term", "inputs", "expected"), TABLE)
def test_printed_numbers(
    text: str, term: Expr, inputs: dict[Symbol, str | int], expected: Verdict
) -> None:
    claim = number(term, text, *as_given(inputs))
    found = judge_printed(claim)
    assert found.verdict is expected
    assert found.value is not None
    assert found.witness is not None
    low, high = printed(text)[:2]
    with ball_precision(200):
        value = number_of(claim).value(tuple(map(arb, found.witness.values())))
        assert bool(value > low and value < high) is (expected is ENCLOSED)
    for symbol, given in inputs.items():
        if isinstance(given, str):
            assert printed(given).holds(found.witness[symbol.name])


def test_a_printed_number_is_taken_to_its_last_place() -> None:
    assert verdict(number(pi, "3.15")) is REFUTED
    assert verdict(number(pi, "3.15", half_units=2)) is ENCLOSED
    assert "within 2 half units" in judge_printed(number(pi, "3.15", half_units=2)).why
    for half_units in (0, -1, 3, 1000):
        assert verdict(number(pi, "4.00", half_units=half_units)) is UNDECIDED
    wide = Rounds(p, "1.0", 1000)
    assert verdict(number(p, "4.0", wide)) is UNDECIDED


def test_at_the_edge_of_a_rounding_nothing_is_said() -> None:
    for edge, text in ((Integer(55) / 100, "0.5"), (TWO + ONE / 2, "2"), (TWO - ONE / 2, "2")):
        assert verdict(number(edge, text)) is UNDECIDED


def test_what_is_undefined_at_the_inputs_does_not_hold() -> None:
    for term in (sqrt(p), 1 / (p + 2)):
        assert verdict(number(term, "1.0", Rounds(p, "-2.0"))) is UNDECIDED


def test_what_is_given_is_given_once_and_plays_a_part() -> None:
    one = Rounds(p, "1.0")
    assert verdict(number(p, "1.0", one)) is ENCLOSED
    assert verdict(number(p, "1.0", one, Rounds(p, "1.04"))) is UNDECIDED
    assert verdict(number(p, "1.0", one, equal(p, 2))) is UNDECIDED
    assert verdict(number(p, "1.0", one, Rounds(q, "1.0"))) is UNDECIDED
    assert verdict(number(p, "1.0", one, equal(p + q, 2))) is UNDECIDED
    assert verdict(number(p, "1.0", Rounds(p + 0 * q, "1.0"), Rounds(q + p, "1"))) is UNDECIDED


def test_a_condition_must_be_shown_at_the_inputs() -> None:
    one = Rounds(p, "1.0")
    assert verdict(number(p, "1.0", one, p > 0)) is ENCLOSED
    assert verdict(number(p, "1.0", one, p > 2)) is UNDECIDED
    assert verdict(number(p, "7.0", one, p > 2)) is UNDECIDED
    assert verdict(number(p, "1.0", one, q > 2)) is UNDECIDED


# -- symbols that are defined ---------------------------------------------------------------------

ROOT_OF = Claim("root of", equal(y, sqrt(x)), Definition(), given=(x > 1,))
AGAIN = Claim("again", equal(z, y + q), Definition(), given=(x > 1, q > 0))


def test_a_symbol_is_what_its_definition_says() -> None:
    two = Rounds(x, "2.00")
    assert verdict(number(y, "1.41", two, using=(ROOT_OF,))) is ENCLOSED
    assert verdict(number(y, "1.43", two, using=(ROOT_OF,))) is REFUTED
    assert verdict(number(y, "1.41", two)) is UNDECIDED
    chained = number(z, "2.41", two, equal(q, 1), using=(AGAIN, ROOT_OF))
    assert verdict(chained) is ENCLOSED
    pinned = number(y, "3.00", equal(p, 3), equal(x, p**2), using=(ROOT_OF,))
    assert verdict(pinned) is ENCLOSED


def test_a_definition_says_nothing_outside_its_conditions() -> None:
    for text in ("0.71", "0.90"):
        assert verdict(number(y, text, Rounds(x, "0.500"), using=(ROOT_OF,))) is UNDECIDED
    assert verdict(number(z, "2.41", Rounds(x, "2.00"), using=(AGAIN, ROOT_OF))) is UNDECIDED


def test_a_condition_may_speak_of_what_is_defined() -> None:
    """No point of the inputs alone tells: y is √x."""
    large = Claim("large", equal(z, y + 1), Definition(), given=(y > 2,))
    using = (large, ROOT_OF)
    assert verdict(number(z, "4.0", Rounds(x, "9.0"), using=using)) is ENCLOSED
    for text in ("2.4", "9.0"):
        assert verdict(number(z, text, Rounds(x, "2.0"), using=using)) is UNDECIDED
    said = number(x, "9.0", Rounds(x, "9.0"), y > 2, using=(ROOT_OF,))
    assert verdict(said) is ENCLOSED
    assert verdict(replace(said, given=(Rounds(x, "9.0"), y > 4))) is UNDECIDED


def test_the_variables_of_a_claim_have_values_that_its_conditions_allow() -> None:
    free = Claim("free", equal(z, x + 1), Definition(), given=(x > 0, q > x, q < x + 1))
    assert verdict(number(z, "2.0", Rounds(x, "1.0"), using=(free,))) is ENCLOSED
    none = replace(free, given=(x > 0, q > x, q < 0))
    with pytest.raises(InputError, match="no exact point"):
        number_of(number(z, "2.0", Rounds(x, "1.0"), using=(none,)))


def test_what_nobody_speaks_of_has_no_value() -> None:
    place = checker.Place({}, {}, {})
    assert not place.value(expression.symbol("p")).is_finite()


def test_why_is_in_words() -> None:
    at_centre = judge_printed(number(sqrt(p), "1.41", Rounds(p, "2.0")))
    assert at_centre.why == "the inputs as printed give a value that rounds to 1.41"
    near = judge_printed(number(sqrt(p), "1.425", Rounds(p, "2.0"))).why
    assert near == "inputs that round to them give a value that rounds to 1.425"


def test_a_symbol_is_not_given_and_defined(monkeypatch: pytest.MonkeyPatch) -> None:
    named = Claim("named p", equal(p, x), Definition())
    squared = Decided((named, ROOT_OF))
    square = Claim("square", equal(p, y**2), squared, given=(x > 1,))
    said = number(p, "4.00", Rounds(y, "2.000"), using=(square,))
    assert verdict(said) is UNDECIDED
    monkeypatch.setattr(checker, "defined", lambda claim: frozenset())
    assert verdict(said) is ENCLOSED


def test_what_is_defined_by_itself_has_no_value() -> None:
    circle = Claim("circle", equal(y, y * x), Definition())
    with pytest.raises(InputError):
        number_of(number(z, "1.0", Rounds(x, "1.0"), using=(circle,)))
    claim = number(y, "0", Rounds(x, "1.0"), using=(circle,))
    assert judge_printed(claim).verdict is UNDECIDED


# -- roots ----------------------------------------------------------------------------------------

ROOT = y, ZERO, x, equal(y**3 + y - x, 0)
CUBIC = Claim(
    "cubic",
    "one root",
    Decided(),
    expect=Verdict.PROVED,
    means=ExactlyOne(*ROOT),
    given=(x > 0,),
)
NAMED = Claim("named", Root(z, CUBIC).says, Root(z, CUBIC), given=(x > 0,))
LEAST = y, ZERO, Integer(3), equal(y**3 + y, x)
AT_MOST = Claim(
    "at most",
    "one root at most",
    Monotone(Decided()),
    means=AtMostOne(*LEAST),
    given=(x > 0,),
)
WAY = Integral(1 / sqrt(p + q**2), (q, 0, y))
LONG = y, ZERO, Integer(100), equal(WAY, x)
LONGER = Claim(
    "longer",
    "a longer way",
    Monotone(by(differentiating_integral(ZERO))),
    means=AtMostOne(*LONG),
    given=(p > 0,),
)


def test_a_root_is_enclosed_by_its_equation() -> None:
    ten = Rounds(x, "10.00")
    assert verdict(number(z, "2.000", ten, using=(NAMED,))) is ENCLOSED
    assert verdict(number(z, "2.005", ten, using=(NAMED,))) is REFUTED
    the = TheRoot(*ROOT)
    assert verdict(number(the, "2.000", ten, using=(CUBIC,))) is ENCLOSED
    assert verdict(number(the + x, "12.0", ten, using=(CUBIC,))) is ENCLOSED
    least = TheRoot(*LEAST)
    assert verdict(number(least, "2.000", ten, using=(AT_MOST,))) is ENCLOSED
    assert verdict(number(least, "2.005", ten, using=(AT_MOST,))) is REFUTED


def test_an_equation_may_hold_an_integral() -> None:
    the = TheRoot(*LONG)
    here = (Rounds(x, "1.000"), equal(p, 1))
    assert verdict(number(the, "1.175", *here, using=(LONGER,))) is ENCLOSED
    assert verdict(number(the, "1.185", *here, using=(LONGER,))) is REFUTED


def test_a_root_is_one_only_where_a_claim_says_so() -> None:
    ten = Rounds(x, "10.00")
    the = TheRoot(*ROOT)
    assert verdict(number(the, "2.000", ten)) is UNDECIDED
    other = TheRoot(y, ZERO, x + 1, equal(y**3 + y, x))
    assert verdict(number(other, "2.000", ten, using=(CUBIC,))) is UNDECIDED
    two = TheRoot(y, ZERO, 4, equal((y - 1) * (y - 3), 0))
    assert verdict(number(two, "1.0", using=(CUBIC,))) is UNDECIDED
    # The conditions of the claim, and a root that is there.
    for text in ("-2.0", "0.0"):
        assert verdict(number(z, text, Rounds(x, "-10.0"), using=(NAMED,))) is UNDECIDED
    least = TheRoot(*LEAST)
    assert verdict(number(least, "3.0", Rounds(x, "30.00"), using=(AT_MOST,))) is UNDECIDED


def test_a_root_is_one_only_under_the_conditions_of_its_claim() -> None:
    # 3 < y is √x < 3, a condition on what is defined.
    some = replace(AT_MOST, label="some", given=(x > 0, q > 3))
    named = Claim("named q", equal(q, x / 2), Definition())
    the = TheRoot(*LEAST)
    for text, given, expected in (("10.00", "2.000", ENCLOSED), ("4.000", "1.379", UNDECIDED)):
        said = number(the, given, Rounds(x, text), using=(some, named))
        assert verdict(said) is expected


def test_a_root_inside_an_integral_is_no_exception() -> None:
    two = TheRoot(y, ZERO, 4, equal((y - 1) * (y - 3), 0))
    assert verdict(number(Integral(two * x, (x, 0, 1)), "0.5")) is UNDECIDED
    assert verdict(number(Integral(two * x, (x, 0, 1)), "0.7")) is UNDECIDED


def test_without_the_guard_a_root_that_is_not_the_one_passes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    two = TheRoot(y, ZERO, 4, equal((y - 1) * (y - 3), 0))
    said = number(two, "1.0")
    monkeypatch.setattr(checker.Place, "_is_one", lambda *at: True)
    monkeypatch.setattr(checker, "roots_by", lambda claims: _Anything())
    assert judge_printed(said).verdict is not UNDECIDED


class _Anything(dict[Any, Any]):
    def __contains__(self, key: object) -> bool:
        return True

    def __missing__(self, key: Any) -> checker.Rule:
        return checker.Rule(key, (), None)


@pytest.mark.parametrize(
    ("means", "slope"),
    [
        (AtMostOne(y, ZERO, 4, equal((y - 1) * (y - 3), 0)), 2 * y - 4),  # two roots
        (AtMostOne(y, ZERO, 4, equal((y - 1) * (y - 3), 0)), 1 + y),
        (AtMostOne(y, ZERO, 3, equal(x, y**3 + y)), 3 * y**2 + 1),  # it falls
        (AtMostOne(y, -ONE, ONE, equal(-1 / y, x)), 1 / y**2),  # a pole between
        (AtMostOne(y, ZERO, pi, equal(-cos(2 * y), x)), 2 * sin(2 * y)),
        (AtMostOne(y, ZERO, y + 3, equal(y**3 + y, x)), 3 * y**2 + 1),
        (ExactlyOne(y, ZERO, 3, equal(y**3 + y, x)), 3 * y**2 + 1),
        (AtMostOne(y, ZERO, 3, y**3 + y > x), 3 * y**2 + 1),
        (Tuple(equal(x, x)), 3 * y**2 + 1),
    ],
)
def test_one_root_at_most_is_shown_by_a_rise(means: Basic, slope: Expr) -> None:
    claim = Claim("m", "at most one", Monotone(derived(step(slope))), means=means, given=(x > 0,))
    assert verdict(claim) is UNDECIDED


def test_one_root_at_most_holds() -> None:
    assert verdict(AT_MOST) is Verdict.PROVED
    assert verdict(LONGER) is Verdict.PROVED
    assert number_of(number(TWO, "2")).target == printed("2")
    assert judge_printed(number(TWO, "2")).witness == dict[str, fmpq]()


def test_no_other_statement_is_a_printed_number() -> None:
    for means in (equal(x, x), None, AtMostOne(y, ZERO, 3, equal(y, x))):
        claim = Claim("n", "a number", Printed(), means=means)
        assert verdict(claim) is UNDECIDED
