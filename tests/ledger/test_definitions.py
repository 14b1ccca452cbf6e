"""Labels, definitions and what rests on what: no ledger holds a claim that breaks their order."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from derivations import by, derived, step
from sympy import (
    Abs,
    Basic,
    Derivative,
    Dummy,
    Gt,
    Integer,
    Integral,
    Rational,
    Subs,
    Symbol,
    Tuple,
    default_sort_key,
    exp,
    expand,
    log,
    sqrt,
)
from sympy_statements import ExactlyOne, TheRoot, equal

from tresym.commands import main
from tresym.ledger.claim import (
    Claim,
    Definition,
    ImplicitFunction,
    Place,
    Root,
    all_of,
)
from tresym.ledger.definitions import captured, conflict, restrictions, table
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.formulas import in_trees, is_equation, parts_of, relations_of
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.reasons import (
    changing_variable,
    citing,
    differentiation,
    evaluating,
    integrating,
    substituting,
)
from tresym.ledger.verification import verify
from tresym.reals.language.binders import outermost
from tresym.reals.language.compound import Together
from tresym.reals.language.expression import Expr, replaced, symbol
from tresym.reals.language.formula import Relation
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

t, x, y, z = (Symbol(name, real=True) for name in "txyz")
ZERO, ONE, TWO = Integer(0), Integer(1), Integer(2)


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
        monkeypatch.setattr("tresym.ledger.paper.all_claims", lambda *_: claims)

    return hold


def test_a_claim_is_its_value_and_not_its_label() -> None:
    right = next(claim for claim in all_claims() if claim.label == "eq_gamma")
    twin = replace(right, says=equal(x, 7), proof=by(), given=())
    assert twin != right
    assert replace(right) == right
    found = {row.claim.label: row.finding for row in verify(["eq_gamma"]).rows}
    for proof in (by(substituting(twin)), Decided((twin,)), all_of(twin)):
        says = "x = 7" if proof == all_of(twin) else equal(x, 7)
        assert not judge(Claim("user", says, proof), found).verdict.holds


def test_what_is_used_needs_a_finding() -> None:
    hidden = Claim("hidden", equal(x, x), by())
    for proof in (by(substituting(hidden)), all_of(hidden)):
        user = Claim("user", "so it is" if proof == all_of(hidden) else equal(x, x), proof)
        with pytest.raises(InputError, match=r"^user uses hidden, which has not been judged yet$"):
            judge(user, {})


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
    with pytest.raises(InputError, match=r"the ledger: .* is defined (by|in terms of)"):
        verify()
    sides = [next(relations_of(c.says)).right for c in claims]
    says = Relation(sides[0], "==", sides[1])
    left = next(relations_of(claims[0].says)).left
    steps = derived(step(left, substituting(claims[0])), step(sides[1], substituting(claims[1])))
    for user in (
        Claim("user", says, steps, given=claims[1].given),
        Claim("user", says, Decided(claims), given=claims[1].given),
        Claim("user", "…", all_of(*claims)),
    ):
        assert not judged(user).holds or claims == TWICE["implicit"]


def test_four_is_not_nine_by_equations_for_integrals() -> None:
    """∫₀ˣ 2t dt = 4 makes x = 2, ∫₀ˣ 3t² dt = 27 makes it 3, and each may stand alone."""
    given = (x > 0,)
    double, treble = area(2 * t), area(3 * t**2)
    four, nine, cubed = (
        new(f"to be {n}", equal(area, n), *given, assumes="so I say")
        for area, n in ((double, 4), (double, 9), (treble, 27))
    )
    three = new("three", equal(x, 3))
    assert {judged(claim) for claim in (four, cubed, nine)} == {Premise.ASSUMED}
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


UNDEFINED = {
    "a pole": equal(y, 1 / x),
    "an integral across a pole": equal(y, Integral(1 / t, (t, -1, 1))),
    "an integral whose end has no value": equal(y, Integral(t, (t, 0, log(x)))),
    "an integral of what is a root of less than nothing": equal(y, Integral(sqrt(t), (t, -1, 1))),
    "a derivative at a kink": equal(y, Derivative(Abs(x), x)),
    "a derivative where nothing is": equal(y, Derivative(log(x), x)),
    "a derivative of an integral up to a pole": equal(y, Derivative(area(1 / (t - 1)), x)),
    "a value at a pole": equal(y, Subs(1 / x, x, 0)),
    "a slope at a kink": equal(y, Subs(Derivative(Abs(x), x), x, 0)),
    "a value at a pole of the value": equal(y, Subs(x, x, 1 / z)),
}


@pytest.mark.parametrize("says", UNDEFINED.values(), ids=UNDEFINED)
def test_what_is_defined_exists(says: Basic) -> None:
    assert judged(new("none", says)) is Verdict.UNDECIDED
    assert judged(new("none", says, assumes="so I say")) is Verdict.UNDECIDED


def test_what_is_defined_exists_under_its_conditions() -> None:
    for says, given in (
        (equal(y, 1 / x), (x > 0,)),
        (equal(y, Integral(1 / (1 + t), (t, 0, x))), (x > 0,)),
        (equal(y, Derivative(log(x), x)), (x > 0,)),
        (equal(y, Derivative(area(1 / (1 + t)), x)), (x > 0,)),
        (equal(y, Subs(Derivative(log(z), z), z, x)), (x > 0,)),
        (equal(y, Subs(Derivative(area(exp(z * t)), z), z, 0)), ()),
    ):
        assert judged(Claim("there", says, Definition(), given=given)).holds


NO_DEFINITION = {
    "what nothing satisfies": new("none", equal(y, 1), x > 0, x < 0),
    "a bound": new("bound", Gt(y, 0, evaluate=False)),
    "an equation and a bound": new("both", Tuple(equal(y, 1), Gt(z, 0, evaluate=False))),
    "nothing": new("nothing", Tuple()),
    "a product": new("product", equal(x * y, 1)),
    "a product beside a symbol": new("beside", Tuple(equal(z, 1), equal(x * y, 1))),
    "a product beside an integral": new(
        "beside", Tuple(equal(area(2 * t), 4), equal(y * z, 1)), x > 0, assumes="so I say"
    ),
    "one symbol twice": new("twice", Tuple(equal(x, 1), equal(x, 2))),
    "itself": new("itself", equal(x, x + 1)),
    "itself beside another": new("itself", Tuple(equal(y, 1), equal(x, x * y))),
}


@pytest.mark.parametrize("claim", NO_DEFINITION.values(), ids=NO_DEFINITION)
def test_what_defines_nothing_is_refused(claim: Claim) -> None:
    assert judged(claim) is Verdict.UNDECIDED


def test_what_is_on_the_table() -> None:
    square, root = new("square", equal(y, x**2)), new("four", equal(area(2 * t), 4), assumes="x")
    bounded = new("bounded", Tuple(equal(z, 1), Gt(z, 0, evaluate=False)))
    assert [entry.written for entry in table((square, bounded))] == [
        in_trees(square.says),
        in_trees(equal(z, 1)),
    ]
    assert table((Claim("shown", square.says, by()),)) == ()
    assert [entry.explicit for entry in table((square, root, ROOT))] == [True, False, False]
    less, least = equal(area(2 * t), -(z**2) - 1), equal(area(2 * t), z)
    assert restrictions((square, new("less", less, assumes="so I say"))) == (in_trees(less),)
    assert restrictions((new("own", least, assumes="z"),)) == ()
    assert judge(square, {}).why == "introduces y"
    assert judge(root, {}).why == "assumed: x"


def test_a_definition_does_not_ask_for_itself() -> None:
    """x := y for x > 5 says nothing for a y below 5: the condition is on the symbol itself."""
    early = new("early", equal(x, y), x > 5)
    assert judged(early) is Verdict.UNDECIDED
    assert "in terms of itself" in judge(early, {}).why
    user = Claim("user", x > 5, by(), given=(x > 5,))
    assert judged(user) is Verdict.PROVED


def test_an_equation_defines_nothing_that_is_not_assumed_by_name() -> None:
    says = equal(area(2 * t), 4)
    assert judged(new("root", says, x > 0)) is Verdict.UNDECIDED
    assert judged(new("root", says, x > 0, assumes="x is there")) is Premise.ASSUMED
    assert judged(new("root", equal(area(2 * t), -1), assumes="there is none")) is Verdict.UNDECIDED


def test_a_claim_is_not_proved_of_what_an_assumed_equation_excludes() -> None:
    four = new("four", equal(area(2 * t), 4), x > 0, assumes="x is 2")
    steps = derived(step(area(2 * t), integrating(t**2)), step(None, substituting(four)))
    assert judged(Claim("user", equal(x**2, 4), steps, given=(x > 1,))) is Verdict.PROVED
    assert not judged(Claim("user", equal(x**2, 4), steps, given=(x > 5,))).holds
    for meaning, more in ((-(y**2) - 1, ()), (y, (new("less", equal(y, -ONE)),))):
        odd = new("odd", equal(area(2 * t), meaning), assumes="so I say")
        steps = derived(
            step(area(2 * t), integrating(t**2)),
            step(None, *map(substituting, (odd, *more))),
        )
        says = equal(x**2, meaning.subs(y, -1) if more else meaning)
        assert not judged(Claim("user", says, steps)).holds


def test_two_definitions_of_which_none_is_assumed_conflict() -> None:
    one, two = new("one", equal(x, y)), new("two", equal(x, z))
    assert conflict((one, two)) is not None
    assert conflict((one, replace(two, proof=Definition("so it is")))) is None
    assert conflict((one, replace(one, label="again"), two)) is not None
    turn = new("p", equal(x, y)), new("q", equal(z, x)), new("r", equal(y, z + 1))
    assert "itself" in (conflict(turn) or "")
    assert "itself" in (conflict((new("fine", equal(t, ONE)), *turn)) or "")


def _planted() -> dict[str, Claim]:
    """What a bound on x = 1/2 would prove of every x that is bound, or that only looks like it."""
    below = _below_three()
    twice = Claim("twice", Gt(4 - x, 0, evaluate=False), by(citing(below)))

    def across(v: Symbol, bound: Claim = below) -> Claim:
        says = equal(Integral((3 - v) ** -2, (v, 0, 10)), -Rational(10, 21))
        return Claim("across", says, by(integrating(1 / (3 - v), bound)))

    def positive_area(v: Symbol, bound: Claim = below) -> Claim:
        says = Gt(Integral(4 - v, (v, 0, 100)), 0, evaluate=False)
        return Claim("area", says, by(citing(bound)))

    return {
        "under an integral": across(x),
        "through two uses": positive_area(x, twice),
        "at a value": Claim("at", equal(Subs(Abs(x - 3), x, 5), -2), by(citing(below), evaluating)),
        "in a derivative": Claim(
            "slope", equal(Derivative(Abs(x - 3), x), -1), by(citing(below), differentiation)
        ),
        "by a new variable": Claim(
            "new",
            equal(Integral(1 / (3 - y) ** 2, (y, 0, 10)), -Rational(10, 21)),
            derived(
                step(Integral(1 / (3 - x) ** 2, (x, 0, 10)), changing_variable(y, below)),
                step(None, integrating(1 / (3 - x), below)),
            ),
        ),
        "beside it": Claim("by", Gt(1 - x, 0, evaluate=False), by(citing(below))),
    }


def _below_three() -> Claim:
    half = new("half", equal(x, Rational(1, 2)))
    shown = derived(step(Rational(5, 2), substituting(half)))
    return Claim("below", Gt(3 - x, 0, evaluate=False), shown)


@pytest.mark.parametrize("other", [Symbol("x", positive=True), Dummy("x", real=True)])
def test_a_symbol_of_another_kind_is_refused(other: Symbol) -> None:
    with pytest.raises(InputError, match="SymPy assumes more"):
        Claim("kind", equal(Integral((3 - other) ** -2, (other, 0, 10)), -Rational(10, 21)))


@pytest.mark.parametrize("claim", _planted().values(), ids=_planted())
def test_what_is_defined_is_bound_nowhere(claim: Claim) -> None:
    assert judged(_below_three()) is Verdict.PROVED
    assert not judged(claim).holds


def _hidden() -> dict[str, Claim]:
    """What would be proved of y = x² as if x were not in it, where x is bound."""
    square = new("square", equal(y, x**2))
    fourth = new("fourth", equal(z, y**2))
    put_in = step(None, substituting(square))
    constant = step(y, integrating(y * x))
    sign_of_x = new("sign of x", equal(z, 1), x > 0)
    return {
        "a derivative": Claim(
            "d", equal(Derivative(y, x), y - x**2), derived(step(ZERO, differentiation), put_in)
        ),
        "a value": Claim(
            "v", equal(Subs(x * y, x, 5), 5 * x**2), derived(step(5 * y, evaluating), put_in)
        ),
        "an integral": Claim("i", equal(Integral(y, (x, 0, 1)), x**2), derived(constant, put_in)),
        "a new variable": Claim(
            "n",
            equal(Integral(y, (x, 0, 1)), x**2),
            derived(
                step(Integral(y, (t, 0, 1)), changing_variable(x)),
                step(y, integrating(y * t)),
                put_in,
            ),
        ),
        "two definitions": Claim(
            "t",
            equal(Derivative(z, x), z - x**4),
            derived(step(ZERO, differentiation), step(None, substituting(fourth, square))),
        ),
        "a condition": Claim(
            "c",
            equal(Integral(z, (x, -1, 1)), 2),
            derived(step(2 * z, integrating(z * x)), step(None, substituting(sign_of_x))),
            given=(x > 0,),
        ),
    }


@pytest.mark.parametrize("claim", _hidden().values(), ids=_hidden())
def test_what_is_defined_depends_on_what_defines_it(claim: Claim) -> None:
    assert not judged(claim).holds
    assert "occurs where a variable is bound on which its definition depends" in str(
        captured(claim)
    )
    assert captured(Claim("free", claim.says, by())) is None  # of a variable y it may be true


def test_a_symbol_has_no_value_at_a_point_of_what_it_may_depend_on() -> None:
    """That z at x = 0 is z is false of a z that varies with x."""
    for says in (
        equal(Subs(z, x, 0), z),
        equal(1 + 2 * Subs(z, x, 0), 1 + 2 * Subs(z, t, 0)),
        equal(Integral(Subs(z + t, x, 0), (t, 0, 1)), z + Rational(1, 2)),
    ):
        assert not judged(Claim("z", says, by(evaluating))).holds
        assert "does not say how it depends on" in str(captured(Claim("z", says, by())))
    assert judged(Claim("z", equal(Subs(z * x, x, 2), 2 * z), by(evaluating))).holds
    inside = equal(Integral(Subs(t * x, x, 2), (t, 0, 1)), 1)
    assert captured(Claim("z", inside, by())) is None


def test_whichever_symbol_is_bound_of_many() -> None:
    square, one, half = new("square", equal(y, x**2)), new("1", equal(t, 1)), new("h", equal(z, x))
    both = by(substituting(one, square, half))
    third = Symbol("w", real=True)
    whole = equal(Integral(x, (x, 0, 1)), Rational(1, 2))
    caught = captured(Claim("x", equal(Integral(y, (y, 0, 1)), z), both))
    assert caught == "y is defined by square, so it must not be used as a bound variable"
    assert captured(Claim("free", whole, both)) is None
    roots = [TheRoot(third, 0, 1, equal(third, t)), TheRoot(x, 0, z, equal(third * x, y))]
    both_sides = [equal(roots[0], roots[1]), equal(roots[1], roots[0])]
    for says in (*both_sides, equal(roots[1], z), equal(roots[1], third)):
        assert "occurs where a variable is bound on which its definition depends" in str(
            captured(Claim("r", says, both))
        )
    assert captured(Claim("r", equal(roots[0], t), both)) is None
    for says in (
        Tuple(ExactlyOne(third, 0, 1, equal(third, t)), ExactlyOne(x, 0, 1, equal(x, t * y))),
        ExactlyOne(x, 0, z, equal(x * third, t)),
    ):
        why = captured(Claim("e", says, both))
        assert why is not None
        assert "occurs where a variable is bound on which its definition depends" in why


def test_what_is_defined_is_not_generalised() -> None:
    """y is x², and no variable by which an implicit function of it could be differentiated."""
    square = new("square", equal(y, x**2), x > 0)
    level = Claim("level", equal(x**2 - y, 0), by(substituting(square)), given=(x > 0,))
    left, slope = x**2 - y, Symbol("r", real=True)
    at_one = left.xreplace({y: ONE})
    says = equal(slope, -Subs(Derivative(left, y), y, 1) / Derivative(at_one, x))
    proof = ImplicitFunction(level, x, y, ONE)
    user = Claim("user", says, proof, given=(x > 0,))
    assert judged(user) is Verdict.UNDECIDED
    assert captured(user) == "y is defined by square, so it must not be used as a bound variable"


def test_a_conflict_names_both_places(ledger: Callable[..., None]) -> None:
    one = Claim("one", equal(x, 1), Definition(), where=Place(display=8))
    two = Claim("two", equal(x, 2), Definition(), where=Place(line=30))
    ledger(one, two)
    with pytest.raises(
        InputError, match=r"x is defined by one \(display 8\) and by two \(line 30\)"
    ):
        verify()


WRITTEN_OUT = {"eq_Mi"}
"""What is put in as a product of matrices, and said entry by entry."""


def _shapes(claim: Claim) -> list[frozenset[tuple[Basic, Basic]] | None]:
    """Each equation of a claim as left side minus right side, up to a factor; None for others."""
    shapes: list[frozenset[tuple[Basic, Basic]] | None] = []
    for part in parts_of(claim.says):
        if not is_equation(part):
            shapes.append(None)
            continue
        for entry in relations_of(part):
            difference = expand(to_sympy(replaced(entry.left - entry.right, _as_symbols(entry))))
            terms = difference.as_coefficients_dict()
            unit = terms[min(terms, key=default_sort_key)]
            shapes.append(frozenset((term, factor / unit) for term, factor in terms.items()))
    return shapes


def _as_symbols(entry: Relation) -> dict[Expr, Expr]:
    """Integrals, roots and values at points, each as a symbol."""
    return {node: symbol(f"<{node}>") for node in outermost(entry.left, entry.right)}


def _said_by_premises(claim: Claim) -> bool:
    """Whether all that the claim says is among the definitions and assumptions it rests on."""
    if isinstance(claim.says, str) or isinstance(claim.proof, Definition | ImplicitFunction):
        return False
    premises = (c for c in claim.rests_on if isinstance(c.proof, Definition | ImplicitFunction))
    put_in = {shape for premise in premises for shape in _shapes(premise)}
    return all(shape in put_in for shape in _shapes(claim))


@pytest.mark.slow
def test_no_claim_says_what_was_put_in() -> None:
    total = new("total", equal(x, y + t * z))
    moved = Claim("moved", equal(x - y, t * z), by(substituting(total)))
    twice = Claim("twice", equal(2 * x, 2 * y + 2 * t * z), by(substituting(total)))
    other = Claim("other", equal(x**2, (y + t * z) ** 2), by(substituting(total)))
    assert [_said_by_premises(claim) for claim in (moved, twice, other)] == [True, True, False]
    said = {claim.label for claim in all_claims() if _said_by_premises(claim)}
    assert said == WRITTEN_OUT


def test_what_rests_on_itself_is_refused(ledger: Callable[..., None]) -> None:
    claims = [Claim(label, label, all_of()) for label in "abc"]
    for claim, used in zip(claims, [*claims[1:], claims[0]], strict=True):
        object.__setattr__(claim, "proof", all_of(used))
    ledger(claims[0])
    with pytest.raises(InputError, match="depends on itself"):
        verify()
    bound = Claim("d", Gt(x, 0, evaluate=False), by())
    object.__setattr__(bound, "proof", by(substituting(bound)))
    ledger(bound)
    with pytest.raises(InputError, match="d depends on itself"):
        verify()


# -- roots ----------------------------------------------------------------------------------------

POSITIVE = (x > 0,)
ONE_ROOT = Claim(
    label="one root",
    says=ExactlyOne(t, 0, x + 1, equal(t**3, x)),
    given=POSITIVE,
    proof=Decided(),
    expect=Verdict.PROVED,
)
ROOT = Claim("root", Root(y, ONE_ROOT).says, Root(y, ONE_ROOT), given=POSITIVE)


def finding(claim: Claim) -> Finding:
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    return found[claim.label]


def test_a_symbol_may_name_the_one_root() -> None:
    assert finding(FROM_Z).verdict is Verdict.PROVED
    assert finding(ROOT).verdict is Premise.DEFINED
    bounded = Claim("y > 0", y + 1 > 0, by(citing(ROOT)), given=POSITIVE)
    assert finding(bounded).verdict is Verdict.PROVED


FROM_Z = Claim(
    label="one root from -z²",
    says=ExactlyOne(t, -(z**2), x + 1, equal(t**3 + t, x)),
    given=POSITIVE,
    proof=Decided(),
    expect=Verdict.PROVED,
)
"""Of which z is no name: its end would be the root's own."""
NO_ROOT = {
    "without the conditions": replace(ROOT, given=()),
    "under other conditions": replace(ROOT, given=(x < 0,)),
    "without the ends": replace(ROOT, says=equal(y**3, x)),
    "another equation": replace(
        ROOT, says=Together((in_trees(equal(y**3, x + 1)), *ROOT.proof.says.parts[1:]))
    ),
    "another end": replace(
        ROOT,
        says=Together((ROOT.proof.says.parts[0], in_trees(Gt(y, 1)), ROOT.proof.says.parts[2])),
    ),
    "a symbol of the equation": replace(ROOT, says=Root(x, ONE_ROOT).says, proof=Root(x, ONE_ROOT)),
    "the bound symbol": replace(ROOT, says=Root(t, ONE_ROOT).says, proof=Root(t, ONE_ROOT)),
    "a symbol of the end": replace(ROOT, says=Root(z, FROM_Z).says, proof=Root(z, FROM_Z)),
}


@pytest.mark.parametrize("claim", NO_ROOT.values(), ids=NO_ROOT)
def test_what_is_no_name_for_the_one_root_is_refused(claim: Claim) -> None:
    shown = {"one root": Finding(Verdict.PROVED, "")}
    shown[FROM_Z.label] = Finding(Verdict.PROVED, "")
    assert judge(claim, shown).verdict is Verdict.UNDECIDED


def test_a_root_is_defined_once() -> None:
    other = new("y = 1", equal(y, ONE))
    twin = replace(ROOT, label="twin")
    both = Claim("both", all_of(ROOT, other).claims[0].says, all_of(ROOT, other))
    assert conflict((ROOT, other)) is not None
    assert conflict((ROOT, twin)) is None
    assert finding(both).verdict is Verdict.UNDECIDED
    says = ExactlyOne(t, 0, x + 1, equal(t**2, x))
    unlike = replace(ONE_ROOT, label="unlike", says=says)
    assert conflict((ROOT, replace(ROOT, label="u", proof=Root(y, unlike)))) is not None
