"""Labels, definitions and what rests on what: no ledger holds a claim that breaks their order."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from sympy import Basic, Eq, Gt, Integer, Integral, Symbol

from tresym.commands import main
from tresym.ledger.claim import Claim, Definition, all_of, by, equal, formally, step
from tresym.ledger.definitions import conflict
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.reasons import integrating, substituting
from tresym.ledger.verification import verify
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

t, x, y, z = (Symbol(name, real=True) for name in "txyz")
ONE, TWO = Integer(1), Integer(2)


def new(label: str, says: Basic, *given: Basic, assumes: str = "") -> Claim:
    return Claim(label, says, Definition(assumes), given=given)


def area(f: Basic) -> Integral:
    return Integral(f, (t, 0, x))


def judged(claim: Claim) -> Verdict:
    """The verdict with everything beneath judged first."""
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    return found[claim.label].verdict


ledger = pytest.fixture(lambda monkeypatch: _ledger(monkeypatch))


def _ledger(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    def hold(*claims: Claim) -> None:
        monkeypatch.setattr("tresym.ledger.paper.all_claims", lambda: claims)

    return hold


def test_a_claim_is_its_value_and_not_its_label() -> None:
    right = next(claim for claim in all_claims() if claim.label == "eq_gamma")
    twin = replace(right, says=equal(x, 7), proof=by(), given=())
    assert twin != right
    assert replace(right) == right
    found = {row.claim.label: row.finding for row in verify(["eq_gamma"]).rows}
    for proof in (by(substituting(twin)), formally(equal(x, 7), using=(twin,)), all_of(twin)):
        says = "x = 7" if not isinstance(proof, tuple) else equal(x, 7)
        assert not judge(Claim("user", says, proof), found).verdict.holds


def test_twins_are_refused(ledger: Callable[..., None], capsys: pytest.CaptureFixture) -> None:
    one = Claim("same", equal(x - x + y, y), by())
    two = Claim("same", equal(x, y), by())
    user = Claim("user", "x = y", all_of(two))
    for claims in ((one, two), (one, user)):
        ledger(*claims)
        with pytest.raises(InputError, match="two claims are labelled"):
            verify()
        assert main(["verify"]) == 2
        assert "two claims are labelled" in capsys.readouterr().err


TWICE = {
    "explicit": (new("one", equal(x, 1)), new("two", equal(x, 2))),
    "by another": (new("one", equal(x, y)), new("two", equal(x, y + 1))),
    "an assumption against a definition": (
        new("one", equal(x, 1)),
        new("two", equal(x, 2), assumes="so I say"),
    ),
    "two conditions that do not exclude each other": (
        new("one", equal(x, 1), y > 0),
        new("two", equal(x, 2), y > 1),
    ),
    "implicit": (
        new("one", equal(area(2 * t), 4), x > 0),
        new("two", equal(area(2 * t), 9), x > 0),
    ),
}
CIRCLES = {
    "of two": (new("one", equal(x, y + 1)), new("two", equal(y, x + 1))),
    "of three": (
        new("one", equal(x, y + 1)),
        new("two", equal(y, z)),
        new("three", equal(z, x)),
    ),
}


@pytest.mark.parametrize("claims", [*TWICE.values(), *CIRCLES.values()], ids=[*TWICE, *CIRCLES])
def test_symbols_are_defined_once(claims: tuple[Claim, ...], ledger: Callable[..., None]) -> None:
    ledger(*claims)
    with pytest.raises(InputError, match=r"the ledger: .* is defined by"):
        verify()
    sides = [Eq(*part.args, evaluate=False).args[1] for part in (c.says for c in claims)]
    says = equal(*sides[:2])
    left = claims[0].says.args[0]
    steps = (step(left, substituting(claims[0])), step(sides[1], substituting(claims[1])))
    for user in (
        Claim("user", says, steps, given=claims[1].given),
        Claim("user", "…", formally(says, using=claims), given=claims[1].given),
        Claim("user", "…", all_of(*claims)),
    ):
        assert not judged(user).holds or claims == TWICE["implicit"]


def test_four_is_not_nine_by_equations_for_integrals() -> None:
    """∫₀ˣ 2t dt = 4 makes x = 2, ∫₀ˣ 3t² dt = 27 makes it 3, and each may stand alone."""
    given = (x > 0,)
    double, treble = area(2 * t), area(3 * t**2)
    four, cubed = new("four", equal(double, 4), *given), new("cubed", equal(treble, 27), *given)
    nine, three = new("nine", equal(double, 9), *given), new("three", equal(x, 3))
    assert {judged(claim) for claim in (four, cubed, nine, three)} == {Premise.DEFINED}
    middle = Claim("middle", equal(double, 4), by(substituting(four)), given=given)
    assert judged(middle) is Verdict.PROVED
    square, cube = integrating(t**2), integrating(t**3)
    for first in (four, middle):
        start = step(double, substituting(first)), step(x**2, square)
        sixth = step(double**3, substituting(first)), step(x**6, square), step(treble**2, cube)
        for right, steps in (
            (9, (start[0], step(None, substituting(nine)))),
            (9, (*start, step(None, substituting(three)))),
        ):
            assert not judged(Claim("user", equal(4, right), steps, given=given)).holds
        steps = (*sixth, step(None, substituting(cubed)))
        assert not judged(Claim("user", equal(64, 729), steps, given=given)).holds


def test_definitions_for_different_cases_and_assumptions_stand_together() -> None:
    cases = new("one", equal(x, 1), y > 0), new("two", equal(x, 2), y < 0)
    assumed = new("body", equal(x, y * z), y > 0), new("space", equal(x, t), assumes="the axes")
    assert conflict(cases) is conflict(assumed) is None


def test_what_is_assumed_must_be_possible_as_the_other_symbols_are_defined() -> None:
    two, same = new("two", equal(y, 2)), new("same", equal(x, y))
    three = new("three", equal(x, 3), assumes="so I say")
    assert conflict((same, three)) is None
    assert conflict((two, same, three)) is not None
    to, fro = new("to", equal(x, y), assumes="this"), new("fro", equal(y, x + 1), assumes="that")
    assert conflict((to, fro)) is not None


def test_what_rests_on_itself_is_refused(ledger: Callable[..., None]) -> None:
    claims = [Claim(label, label, all_of()) for label in "abc"]
    for claim, used in zip(claims, [*claims[1:], claims[0]], strict=True):
        object.__setattr__(claim, "proof", all_of(used))
    ledger(claims[0])
    with pytest.raises(InputError, match="rests on itself"):
        verify()
    bound = Claim("d", Gt(x, 0, evaluate=False), by())
    object.__setattr__(bound, "proof", by(substituting(bound)))
    ledger(bound)
    with pytest.raises(InputError, match="d rests on itself"):
        verify()
