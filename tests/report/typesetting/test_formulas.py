"""Formulas within sentences: what is one, what is not, and how each is written."""

import pytest

from tresym.ledger.paper import all_claims
from tresym.report.typesetting.formulas import pieces
from tresym.report.typesetting.titles import title


def _set(sentence: str) -> str:
    return "".join(
        f"⟦{p.latex.strip()}⟧" if p.latex else f"‹{p.text}›" if p.code else p.text
        for p in pieces(sentence)
    )


@pytest.mark.parametrize(
    ("sentence", "shown"),
    [
        ("so −1/(4bε₀) of ε(γ)", r"so ⟦- 1/(4 b \epsilon_{0})⟧ of ⟦\epsilon (\gamma)⟧"),
        ("so −t² e^{π/t}/(3e) it is", r"so ⟦- t^{2} e^{\pi/t}/(3 e)⟧ it is"),
        ("√(b/(a+b)) cos ψ", r"⟦\sqrt{b/(a + b)} \cos \psi⟧"),
        ("γ + b sin²ε > 0", r"⟦\gamma + b \sin^{2} \epsilon > 0⟧"),
        ("|γ|/b ≤ 1", r"⟦\vert \gamma\vert /b \le 1⟧"),
        ("ε₀ ~ ε*(1 + c₁ε*²)", r"⟦\epsilon_{0} \sim \epsilon_{*} (1 + c_{1} \epsilon_{*}^{2})⟧"),
        ("on (−b, a], or in [0, π/2)", r"on ⟦(- b, a]⟧, or in ⟦[0, \pi/2)⟧"),
        ("Ṙ and d²ψ/dφ²", r"⟦\dot R⟧ and ⟦d^{2} \psi/d \phi^{2}⟧"),
        ("dε/dγ|_{γ = 0}", r"⟦d \epsilon/d \gamma\vert _{\gamma = 0}⟧"),
    ],
)  # fmt: skip
def test_a_formula_is_set(sentence: str, shown: str) -> None:
    assert _set(sentence) == shown


@pytest.mark.parametrize(
    "sentence",
    [
        "A body turns, and a racket is a body: 60 % of 848 in Table 1, racket-1.",
        "W. Rudin, Principles of Mathematical Analysis, 3rd ed. (1976), Theorem 9.28",
        "L. Van Damme, Physica D 338 (2017) 17, e.g. Ref. [3], App. A, eq. (A.7), DLMF 19.2.4",
        "the label eq_gamma and d24, the T2000, 16380 kg mm², 1 kg m²",
    ],
)
def test_words_stay_words(sentence: str) -> None:
    assert _set(sentence) == sentence


def test_the_article_is_told_from_the_letter() -> None:
    assert _set("a root for a body b") == "a root for a body ⟦b⟧"
    assert _set("at fixed a it falls with a and b") == "at fixed ⟦a⟧ it falls with ⟦a⟧ and ⟦b⟧"
    assert _set("at a γ > 0, γ = a the end") == r"at a ⟦\gamma > 0⟧, ⟦\gamma = a⟧ the end"
    assert _set("`d24`, not a") == "‹d24›, not ⟦a⟧"


def test_brackets_that_do_not_close_are_words() -> None:
    assert _set("(here ε") == r"(here ⟦\epsilon⟧"
    assert _set("F (see above) = |x") == "⟦F⟧ (see above) = |⟦x⟧"
    assert _set("x^{and so}") == "⟦x⟧^{and so}"


def test_nothing_is_lost() -> None:
    for claim in all_claims():
        for sentence in filter(None, (str(claim.says), claim.note, claim.paper_says)):
            told = "".join(piece.text for piece in pieces(sentence))
            assert told.replace("\u0307", "") == sentence.replace("`", "").replace("Ṙ", "R")


def test_every_claim_has_a_title_of_its_own() -> None:
    titles = {claim.label: title(claim.label) for claim in all_claims()}
    assert len(set(titles.values())) == len(titles)
    assert titles["d24"] == "The remainder of the theorem"
    assert titles["repaired_from_1_4"] == "The theorem repaired, with a constant from a = 1/4"
    for label, text in titles.items():
        assert text[0].upper() == text[0] or not text[0].isascii(), label
        assert not set("_.$") & set(text), label


def test_titles_by_hand_are_of_claims_that_are_there() -> None:
    from tresym.report.typesetting.titles import by_hand

    labels = {claim.label for claim in all_claims()}
    assert by_hand().keys() <= labels
    displays = {
        c.label for c in all_claims() if c.where and c.label[:1] == "d" and c.label[1:].isdigit()
    }
    assert displays <= by_hand().keys()
