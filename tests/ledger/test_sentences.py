"""Every change of what the ledger says is noticed: of a formula by the judge, of words by hash."""

from dataclasses import replace
from typing import Any

import pytest

from tresym.ledger import formulas
from tresym.ledger.claim import (
    AllOf,
    Claim,
    Follows,
    in_words,
)
from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import Tending, in_order, mapped, parts_of
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.sentences import changed, digest, uncompared
from tresym.ledger.verification import verify
from tresym.reals.language.compound import Count, Shape, Together
from tresym.reals.language.expression import Expr, replaced
from tresym.reals.language.formula import Relation
from tresym.reals.language.named_claims import Equilibrium
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.language.paths import Path
from tresym.reals.verdict import Verdict
from tresym.report.pages.templates import theorems

CLAIMS = {claim.label: claim for claim in all_claims()}
MOST_WORDS = 15


OPPOSITE = {"increasing": "decreasing", "stable": "unstable"}
OPPOSITE |= {other: one for one, other in OPPOSITE.items()}


def turned(part: Any) -> Any:
    """The opposite of a statement: another direction, or unstable for stable."""
    if isinstance(part, formulas.Under):
        return formulas.Under(turned(part.formula), part.given)
    if isinstance(part, Shape | Equilibrium):
        return part._replace(how=OPPOSITE[part.how])
    return part.negated


def parts(label: str) -> tuple[Any, ...]:
    return CLAIMS[label].parts


def without(label: str, *gone: Any) -> tuple[Any, ...]:
    return tuple(c for c in CLAIMS[label].given if c not in gone)


def said(text: str) -> Any:
    """The relations of a text, in the symbols of the paper."""
    links = parse_given(text)
    return formulas.together(
        Relation(*(in_order(e) if isinstance(e, Expr) else e for e in link)) for link in links
    )


def where(text: str) -> tuple[Any, ...]:
    return parts_of(said(text))


def instead(label: str, old: str, new: str) -> Any:
    """The statement of a claim with another expression in place of one."""
    put = {in_order(parse(old)): in_order(parse(new))}
    return mapped(CLAIMS[label].says, lambda e: in_order(replaced(e, put)))


def part_instead(label: str, old: str, new: str) -> Any:
    """The statement of a claim with another relation in place of one, conditions included."""
    return _exchanged(CLAIMS[label].says, {said(old): said(new)})


def _exchanged(says: Any, put: dict[Any, Any]) -> Any:
    if says in put:
        return put[says]
    if isinstance(says, Together):
        return Together(tuple(_exchanged(part, put) for part in says.parts))
    if isinstance(says, formulas.Under):
        given = tuple(_exchanged(c, put) for c in says.given)
        return formulas.Under(_exchanged(says.formula, put), given)
    return says


def conserved(label: str, function: str) -> Any:
    whole = CLAIMS[label].says
    found = (part._replace(function=parse(function)) for part in parts_of(whole))
    return formulas.together(found)


def order(text: str, gauge: str) -> Tending:
    """An order as a*b tends to infinity."""
    equation = Relation(parse(text), "==", Expr(gauge[0], (parse(gauge[1:]),)))
    return Tending(equation, Path("", None, (1,), expression=in_order(parse("a*b"))))


IN_A, IN_B = parts("monotonicity")
BELOW = parts("leading_below")
FLOOR = "2*atan(exp(-pi))"
OSCILLATING = {part: turned(part) for part in CLAIMS["oscillating_case"].parts}


def _longer(says: Any) -> Any:
    """A count of roots up to pi."""
    if isinstance(says, Count):
        return says._replace(high=parse("pi"))
    if isinstance(says, formulas.Under):
        return formulas.Under(_longer(says.formula), says.given)
    return Together(tuple(map(_longer, says.parts))) if isinstance(says, Together) else says


def _other_digits(says: Any) -> Any:
    """Printed numbers with another last digit."""
    if isinstance(says, formulas.Rounded):
        return replace(says, text=says.text[:-1] + "9")
    if isinstance(says, formulas.Under):
        return formulas.Under(_other_digits(says.formula), says.given)
    return Together(tuple(map(_other_digits, says.parts))) if isinstance(says, Together) else says


ANY_SHAPE = where("a > 0, b > 0, b <= 1")
CHANGES: list[tuple[str, str, dict[str, Any]]] = [
    ("monotonicity", "a", {"says": Together((turned(IN_A), IN_B))}),
    ("monotonicity", "b", {"says": Together((IN_A, turned(IN_B)))}),
    ("monotonicity", "beyond b = 1", {"given": where("a > 0, b > 0")}),
    ("monotonicity", "of ε₀²",
     {"says": Together((IN_A._replace(function=parse("epsilon0**2")), IN_B))}),
    ("robustness_at_fixed_b", "direction", {"says": turned(CLAIMS["robustness_at_fixed_b"].says)}),
    ("robustness_at_fixed_b", "b for a",
     {"says": CLAIMS["robustness_at_fixed_b"].says._replace(name="b")}),
    ("rigid_body_floor", "constant", {"says": said("epsilon0 > 3/2")}),
    ("rigid_body_floor", "slightly larger", {"says": said(f"epsilon0 > {FLOOR} + 1/100")}),
    ("rigid_body_floor", "direction", {"says": said(f"epsilon0 < {FLOOR}")}),
    ("rigid_body_floor", "every shape", {"given": ANY_SHAPE}),
    ("floor_of_shapes", "every shape", {"given": ANY_SHAPE}),
    ("floor_is_approached", "direction", {"says": said(f"epsilon0 > {FLOOR} + 1/(a + 1)")}),
    ("floor_is_approached", "constant", {"says": said(f"epsilon0 < {FLOOR} + 1/(9*a + 9)")}),
    ("floor_of_every_body", "constant",
     {"says": CLAIMS["floor_of_every_body"].says._replace(value=parse("2*atan(exp(-4))"))}),
    ("floor_of_every_body", "larger",
     {"says": CLAIMS["floor_of_every_body"].says._replace(value=parse("2*atan(exp(-3))"))}),
    ("floor_of_every_body", "not only bodies", {"given": CLAIMS["floor_of_every_body"].given[:-1]}),
    ("floor_of_every_body", "only some bodies",
     {"given": (*CLAIMS["floor_of_every_body"].given, said("I2 - 2*I1 <= 0"))}),
    ("stable_e1", "unstable", {"says": turned(CLAIMS["stable_e1"].says)}),
    ("stable_e3", "unstable", {"says": turned(CLAIMS["stable_e3"].says)}),
    ("unstable_e2", "stable", {"says": turned(CLAIMS["unstable_e2"].says)}),
    ("stable_e1", "any moments", {"given": where("I1 > 0, I2 > 0, I3 > 0")}),
    ("stable_e1", "about e₂", {"says": CLAIMS["unstable_e2"].says._replace(how="stable")}),
    ("points_of_the_sphere", "exchanged",
     {"says": Together(tuple(map(turned, parts("points_of_the_sphere"))))}),
    ("equilibria_phase_portrait", "exchanged",
     {"says": Together(tuple(map(turned, parts("equilibria_phase_portrait"))))}),
    ("two_first_integrals", "M₁", {"says": conserved("two_first_integrals", "M1")}),
    ("no_external_moment", "M₁² + M₂²", {"says": conserved("no_external_moment", "M1**2 + M2**2")}),
    ("planar_system", "θ", {"says": conserved("planar_system", "theta")}),
    ("planar_system", "sin ψ", {"says": conserved("planar_system", "psi")}),
    ("leading_below", "direction", {"says": Together(tuple(map(turned, BELOW)))}),
    ("leading_below", "constant",
     {"says": Together((BELOW[0], said("epsilon0/epsilon_star > 1 - epsilon_star**2/900")))}),
    ("b_to_zero", "direction", {"says": Together(tuple(map(turned, parts("b_to_zero"))))}),
    ("b_to_zero", "constant",
     {"says": Together((parts("b_to_zero")[0],
                        said("pi/2 - epsilon0 <= sqrt(1 + b/a)*sqrt(a*b)")))}),
    ("b_to_zero", "every product", {"given": without("b_to_zero", said("a*b <= 1"))}),
    ("zero_asymptotic", "faster", {"says": order("epsilon0", "o exp(-4*sqrt(a*b))")}),
    ("printed_leading_term", "faster", {"says": instead("printed_leading_term", "1/(a*b)",
                                                        "1/(a*b)**2")}),
    ("nearly_hyperbolic", "constant",
     {"says": Together((*parts("nearly_hyperbolic")[:2],
                        parts("nearly_hyperbolic")[2]._replace(right=parse("0.4303"))))}),
    ("nearly_hyperbolic", "every product", {"given": ANY_SHAPE}),
    ("tre_if_eps0_small", "larger", {"given": (*ANY_SHAPE, said("epsilon0 <= pi/11"))}),
    ("tre_if_eps0_small", "narrower",
     {"says": Together((parts("tre_if_eps0_small")[0], said("pi - 2*epsilon0 <= pi - pi/100")))}),
    ("planar_constraint", "other shapes",
     {"says": instead("planar_constraint", "1/(a + 2)", "1/(a + 3)")}),
    ("planar_constraint", "other bodies",
     {"says": instead("planar_constraint", "I1 + I2", "I1 + 2*I2")}),
    ("one_line_side", "direction", {"says": turned(CLAIMS["one_line_side"].says)}),
    ("uniform_formulas", "constant", {"says": instead("uniform_formulas", "7/250", "1/250")}),
    ("uniform_formulas", "class", {"given": where("a > 0, b > 0")}),
    ("d11", "constant", {"says": part_instead("d11", "b <= 1", "b <= 1/2")}),
    ("shapes_of_bodies", "every body",
     {"says": part_instead("shapes_of_bodies", "I1 + I2 - I3 >= 0", "I1 + 2*I2 - I3 >= 0")}),
    ("three_regimes", "direction",
     {"says": _exchanged(CLAIMS["three_regimes"].says, OSCILLATING)}),
    ("one_flip_defect", "another interval", {"says": _longer(CLAIMS["one_flip_defect"].says)}),
    ("levels_of_the_thresholds", "digits",
     {"says": _other_digits(CLAIMS["levels_of_the_thresholds"].says)}),
]  # fmt: skip


@pytest.fixture(scope="module")
def found() -> dict[str, Finding]:
    return {label: Finding(claim.expect, "") for label, claim in CLAIMS.items()}


@pytest.mark.parametrize(
    ("label", "change"), [pytest.param(n, c, id=f"{n}: {what}") for n, what, c in CHANGES]
)
def test_a_changed_formula_is_noticed(
    label: str, change: dict[str, Any], found: dict[str, Finding]
) -> None:
    claim = CLAIMS[label]
    assert judge(replace(claim, **change), found).verdict in (Verdict.REFUTED, Verdict.UNDECIDED)
    assert replace(claim, **change).statement != claim.statement or "given" in change


def test_a_true_formula_passes_by_the_same_way(found: dict[str, Finding]) -> None:
    for label in dict.fromkeys(label for label, _, _ in CHANGES):
        assert judge(CLAIMS[label], found).verdict.holds, label


def test_few_claims_are_left_in_words() -> None:
    words = [claim for claim in CLAIMS.values() if not is_formal(claim)]
    assert len(words) <= MOST_WORDS, [claim.label for claim in words]


def test_no_conjunction_stands_for_a_sentence() -> None:
    """A sentence that rests on several claims has a formula of its own, or is left in words."""
    for claim in CLAIMS.values():
        if isinstance(claim.proof, AllOf | Follows) and isinstance(claim.says, str):
            assert isinstance(claim.proof, AllOf), claim.label
            assert claim.proof.words, claim.label
            assert not is_formal(claim)


SENTENCES = [claim for claim in CLAIMS.values() if isinstance(claim.says, str)]


@pytest.mark.parametrize("claim", SENTENCES, ids=lambda claim: claim.label)
def test_a_changed_sentence_is_noticed(claim: Claim) -> None:
    assert uncompared(claim) is None
    assert uncompared(replace(claim, says=f"{claim.says} Not."))
    if claim.means is not None:
        assert uncompared(replace(claim, means=formulas.Under(claim.means, where("E_0 > 0"))))
        assert uncompared(replace(claim, given=(*claim.given, said("E_0 > 0"))))
    else:
        assert uncompared(replace(claim, proof=in_words(*claim.uses[:-1])))


def test_a_changed_sentence_or_formula_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    claim = CLAIMS["tre_only_if"]
    assert verify("tre_only_if")["tre_only_if"].as_expected
    monkeypatch.setitem(claim.__dict__, "says", claim.says.replace("between", "outside of"))
    row = verify("tre_only_if")["tre_only_if"]
    assert row.finding.verdict is Verdict.UNDECIDED
    assert "--save-sentences tre_only_if" in row.finding.why


def test_a_changed_theorem_of_the_article_is_noticed() -> None:
    for label, sentence in theorems().items():
        assert changed(f"theorem {label}", sentence, CLAIMS[label]) is None, label
        assert changed(f"theorem {label}", f"{sentence} Not.", CLAIMS[label])
    opposite = replace(CLAIMS["monotonicity"], says=Together((turned(IN_A), IN_B)))
    assert digest("…", opposite) != digest("…", CLAIMS["monotonicity"])
