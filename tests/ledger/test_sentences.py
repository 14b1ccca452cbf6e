"""Every change of what the ledger says is noticed: of a formula by the judge, of words by hash."""

from dataclasses import replace
from typing import Any

import pytest
from sympy import Function, Le, Lt, Rational, Tuple, atan, exp, oo, pi, sqrt, symbols

from tresym.ledger.claim import AllOf, Claim, Follows, equal, in_words
from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.sentences import changed, digest, uncompared
from tresym.ledger.statements import (
    Conserved,
    ExactlyOne,
    Infimum,
    Rounds,
    StableEquilibrium,
    StrictlyDecreasing,
    StrictlyIncreasing,
    Under,
    UnstableEquilibrium,
    order,
)
from tresym.ledger.verification import verify
from tresym.reals.verdict import Verdict
from tresym.report.pages.templates import theorems

CLAIMS = {claim.label: claim for claim in all_claims()}
MOST_WORDS = 15
NAMES = "I1 I2 I3 M1 M2 E a b epsilon0 epsilon_star psi theta"
I1, I2, I3, M1, M2, E, a, b, epsilon0, epsilon_star, psi, theta = symbols(NAMES, real=True)


def turned(part: Any) -> Any:
    """The opposite of a statement: another direction, or unstable for stable."""
    match part:
        case StrictlyDecreasing():
            return StrictlyIncreasing(*part.args)
        case StrictlyIncreasing():
            return StrictlyDecreasing(*part.args)
        case StableEquilibrium():
            return UnstableEquilibrium(*part.args)
        case UnstableEquilibrium():
            return StableEquilibrium(*part.args)
        case Under():
            return Under(turned(part.args[0]), part.args[1])
    return part.negated


def parts(label: str) -> tuple[Any, ...]:
    return CLAIMS[label].parts


def without(label: str, *gone: Any) -> tuple[Any, ...]:
    return tuple(c for c in CLAIMS[label].given if c not in gone)


small, big = Function("o"), Function("O")
IN_A, IN_B = parts("monotonicity")
BELOW = parts("leading_below")
FLOOR = 2 * atan(exp(-pi))
SHAPES = CLAIMS["shapes_of_bodies"].says
CHANGES: list[tuple[str, str, dict[str, Any]]] = [
    ("monotonicity", "a", {"says": Tuple(turned(IN_A), IN_B)}),
    ("monotonicity", "b", {"says": Tuple(IN_A, turned(IN_B))}),
    ("monotonicity", "beyond b = 1", {"given": (a > 0, b > 0)}),
    ("monotonicity", "of ε₀²", {"says": Tuple(StrictlyDecreasing(epsilon0**2, a), IN_B)}),
    ("robustness_at_fixed_b", "direction", {"says": StrictlyDecreasing(1 / (4 * b * epsilon0), a)}),
    ("robustness_at_fixed_b", "b for a", {"says": StrictlyIncreasing(1 / (4 * b * epsilon0), b)}),
    ("rigid_body_floor", "constant", {"says": epsilon0 > Rational(3, 2)}),
    ("rigid_body_floor", "slightly larger", {"says": epsilon0 > FLOOR + Rational(1, 100)}),
    ("rigid_body_floor", "direction", {"says": epsilon0 < FLOOR}),
    ("rigid_body_floor", "every shape", {"given": (a > 0, b > 0, b <= 1)}),
    ("floor_of_shapes", "every shape", {"given": (a > 0, b > 0, b <= 1)}),
    ("floor_is_approached", "direction", {"says": epsilon0 > FLOOR + 1 / (a + 1)}),
    ("floor_is_approached", "constant", {"says": epsilon0 < FLOOR + 1 / (9 * a + 9)}),
    ("floor_of_every_body", "constant", {"says": Infimum(epsilon0, 2 * atan(exp(-4)))}),
    ("floor_of_every_body", "larger", {"says": Infimum(epsilon0, 2 * atan(exp(-3)))}),
    ("floor_of_every_body", "not only bodies", {"given": CLAIMS["floor_of_every_body"].given[:-1]}),
    ("floor_of_every_body", "only some bodies",
     {"given": (*CLAIMS["floor_of_every_body"].given, I2 - 2 * I1 <= 0)}),
    ("stable_e1", "unstable", {"says": turned(CLAIMS["stable_e1"].says)}),
    ("stable_e3", "unstable", {"says": turned(CLAIMS["stable_e3"].says)}),
    ("unstable_e2", "stable", {"says": turned(CLAIMS["unstable_e2"].says)}),
    ("stable_e1", "any moments", {"given": (I1 > 0, I2 > 0, I3 > 0)}),
    ("stable_e1", "about e₂", {"says": StableEquilibrium(*CLAIMS["unstable_e2"].says.args)}),
    ("points_of_the_sphere", "exchanged",
     {"says": Tuple(*map(turned, parts("points_of_the_sphere")))}),
    ("equilibria_phase_portrait", "exchanged",
     {"says": Tuple(*map(turned, parts("equilibria_phase_portrait")))}),
    ("two_first_integrals", "M₁",
     {"says": Tuple(*(Conserved(M1, *part.args[1:]) for part in parts("two_first_integrals")))}),
    ("no_external_moment", "M₁² + M₂²",
     {"says": Conserved(M1**2 + M2**2, *CLAIMS["no_external_moment"].says.args[1:])}),
    ("planar_system", "θ", {"says": Conserved(theta, *CLAIMS["planar_system"].says.args[1:])}),
    ("planar_system", "sin ψ", {"says": Conserved(psi, *CLAIMS["planar_system"].says.args[1:])}),
    ("leading_below", "direction", {"says": Tuple(*map(turned, BELOW))}),
    ("leading_below", "constant",
     {"says": Tuple(BELOW[0], epsilon0 / epsilon_star > 1 - epsilon_star**2 / 900)}),
    ("b_to_zero", "direction", {"says": Tuple(*map(turned, parts("b_to_zero")))}),
    ("b_to_zero", "constant",
     {"says": Tuple(parts("b_to_zero")[0], pi / 2 - epsilon0 <= sqrt(1 + b / a) * sqrt(a * b))}),
    ("b_to_zero", "every product", {"given": without("b_to_zero", a * b <= 1)}),
    ("zero_asymptotic", "faster",
     {"says": order(equal(epsilon0, small(exp(-4 * sqrt(a * b)))), a * b, oo)}),
    ("printed_leading_term", "faster",
     {"says": order(CLAIMS["printed_leading_term"].says.args[0].xreplace(
         {big(1 / (a * b)): big(1 / (a * b) ** 2)}), a * b, oo)}),
    ("nearly_hyperbolic", "constant",
     {"says": Tuple(*parts("nearly_hyperbolic")[:2],
                    Lt(parts("nearly_hyperbolic")[2].lhs, Rational("0.4303"), evaluate=False))}),
    ("nearly_hyperbolic", "every product", {"given": (a > 0, b > 0, b <= 1)}),
    ("tre_if_eps0_small", "larger", {"given": (a > 0, b > 0, b <= 1, epsilon0 <= pi / 11)}),
    ("tre_if_eps0_small", "narrower",
     {"says": Tuple(parts("tre_if_eps0_small")[0], Le(pi - 2 * epsilon0, pi - pi / 100))}),
    ("planar_constraint", "other shapes",
     {"says": CLAIMS["planar_constraint"].says.xreplace({1 / (a + 2): 1 / (a + 3)})}),
    ("planar_constraint", "other bodies",
     {"says": CLAIMS["planar_constraint"].says.xreplace({I1 + I2: I1 + 2 * I2})}),
    ("one_line_side", "direction", {"says": turned(CLAIMS["one_line_side"].says)}),
    ("uniform_formulas", "constant",
     {"says": CLAIMS["uniform_formulas"].says.xreplace({Rational(7, 250): Rational(1, 250)})}),
    ("uniform_formulas", "class", {"given": (a > 0, b > 0)}),
    ("d11", "constant", {"says": CLAIMS["d11"].says.xreplace({b <= 1: b <= Rational(1, 2)})}),
    ("shapes_of_bodies", "every body",
     {"says": SHAPES.xreplace({I1 + I2 - I3 >= 0: I1 + 2 * I2 - I3 >= 0})}),
    ("three_regimes", "direction", {"says": CLAIMS["three_regimes"].says.xreplace(
        {part: turned(part) for part in CLAIMS["oscillating_case"].parts})}),
    ("one_flip_defect", "another interval",
     {"says": CLAIMS["one_flip_defect"].says.xreplace(
         {x: ExactlyOne(x.args[0], 0, pi, x.args[3])
          for x in CLAIMS["one_flip_defect"].says.atoms(ExactlyOne)})}),
    ("levels_of_the_thresholds", "digits",
     {"says": CLAIMS["levels_of_the_thresholds"].says.xreplace(
         {x: Rounds(x.term, x.text[:-1] + "9") for x in
          CLAIMS["levels_of_the_thresholds"].says.atoms(Rounds)})}),
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
        assert uncompared(replace(claim, means=Under(claim.means, Tuple(E > 0))))
        assert uncompared(replace(claim, given=(*claim.given, E > 0)))
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
    opposite = replace(CLAIMS["monotonicity"], says=StrictlyIncreasing(epsilon0, a))
    assert digest("…", opposite) != digest("…", CLAIMS["monotonicity"])
