"""Proofs that Coq accepts, and falsehoods of which it accepts none."""

import json
import re
from pathlib import Path

import pytest
from cases import cases

from tresym.commands import main
from tresym.coq.allowed_axioms import assumptions
from tresym.coq.candidate_search import export, file_of, prelude, proofs
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import HEAD, Dialogue, declares
from tresym.dev.corpus.lists import known, pairs
from tresym.reals.decisions.claim_parsing import read

BEYOND = re.compile(r"\b(Admitted|Axiom|Axioms|Parameter|Parameters|Conjecture|admit|Abort)\b")


@pytest.mark.slow
def test_nothing_is_assumed_in_what_is_exported() -> None:
    assert not BEYOND.search(prelude())
    for claim in [*(k.claim for k in known("inequalities")[::9]), *(p.claim for p in pairs()[::9])]:
        found = theorems(read(claim))
        text = file_of(found, [next(proofs(t), None) for t in found])
        assert not BEYOND.search(text)


def test_what_is_assumed_is_said() -> None:
    reals = "ClassicalDedekindReals.sig_not_dec : forall P"
    assert assumptions(reals) == "it rests on the classical reals alone"
    assert "machine" in assumptions(f"{reals}\nPrimFloat.add : float -> float")
    assert "Claim.mine" in assumptions(f"{reals}\nClaim.mine : 0 = 1")
    said = "make[1]: Entering directory '/build'\nmake: Leaving directory '/build'"
    assert assumptions(f"{said}\n{reals}") == "it rests on the classical reals alone"


@pytest.mark.parametrize(
    "name",
    cases(__file__, "an_axiom_of_another_name_is_reported"),
)
def test_an_axiom_of_another_name_is_reported(name: str) -> None:
    """Also one whose name begins as make's lines or as Coq's modules for machine numbers do."""
    reals = "Axioms:\nClassicalDedekindReals.sig_not_dec : forall P"
    assert assumptions(f"{reals}\n{name} : False") == f"it rests on {name}"
    assert assumptions(f"{reals}\n{name}\n  : False") == f"it rests on {name}"


@pytest.mark.parametrize(
    ("script", "found"),
    [
        ("intros x.\n{ lra. }\n2: { now field. }", False),
        ("intros x.\nAxiom a : 0 = 1.\nexact a.", True),
        ("{ lra. } Admitted", True),
        ("lra.} Parameter a : False.", True),
    ],
)
def test_a_proof_is_tactics_alone(script: str, found: bool) -> None:
    assert declares(script) is found


@pytest.mark.coq
def test_what_coq_kept_is_the_statement() -> None:
    with Dialogue(lemmas=HEAD) as coq:
        assert coq.accepts(f"{coq.goal('0 < 1')}\nlra.\nQed.", 20)
        assert coq.proved("0 < 1")
        assert not coq.proved("0 < 2")
        assert not coq.accepts(f"{coq.goal('1 < 0')}\nlra.\nQed.", 20)
        assert not coq.proved("1 < 0")


@pytest.mark.coq
def test_true_claims_are_accepted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for claim in ("sin(2*x) == 2*sin(x)*cos(x)", "diff(sqrt(a + x), x) == 1/(2*sqrt(a + x))"):
        target = tmp_path / "proof.v"
        assert main(["check", claim, "--coq", str(target), "--json"]) == 0
        answer = json.loads(capsys.readouterr().out)
        assert answer["coq"]["accepted"] is True
        assert "Print Assumptions claim." in target.read_text()


@pytest.mark.coq
def test_of_a_file_it_is_said_which_claims_are_proved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "mine.tresym"
    file.write_text(
        "# Mine\n\n"
        "square: (x + 1)^2 == x^2 + 2*x + 1\n"
        "both: exp(x) >= 1 + x and sin(x) <= x given x > 0\n"
        "wrong: x^2 >= x given x > 0 expect refuted\n"
        "bessel: besselj(0, x) <= 1 given 0 <= x <= 1\n"
    )
    assert main(["verify", str(file), "--coq", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["coq"]
    assert [row["accepted"] for row in found.values()] == [True, True, None, None]
    assert "refuted" in found["wrong"]["says"].lower()


@pytest.mark.coq
def test_a_falsehood_is_not_accepted() -> None:
    outcome = export(theorems(read("sin(2*x) == 2*sin(x)*cos(x) + x/10**9")))
    assert outcome.accepted is False


@pytest.mark.parametrize(
    ("claim", "says"),
    [
        ("x == x + 1", "only claims that are PROVED"),
        ("gamma(x) ~ 1/x as x -> 0", "gamma"),
    ],
)
def test_what_is_not_exported_is_said(
    claim: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "proof.v"
    main(["check", claim, "--coq", str(target), "--json"])
    answer = json.loads(capsys.readouterr().out)
    assert answer["coq"]["accepted"] is None
    assert says in answer["coq"]["says"]
    assert not target.exists()


@pytest.mark.parametrize(
    ("claim", "word"),
    [
        ("sum(x**k, k, 0, oo) == 1/(1 - x) given -1 < x < 1", "series"),
        ("integral(exp(-x**2), x, 0, 1) < 1", "one side of an equation"),
        ("integral(x, x, 0, 1) + integral(x**2, x, 0, 1) == 5/6", "one side of an equation"),
    ],
)
def test_a_kind_without_a_search_is_said_at_once(
    claim: str, word: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tresym.coq.candidate_search.Dialogue", None)  # Coq is not started
    found = export(theorems(read(claim)))
    assert found.accepted is False
    assert word in found.says
    assert "Theorem claim :" not in found.text


@pytest.mark.coq
@pytest.mark.parametrize(
    "claim",
    [
        "sum(k, k, 1, n) == n*(n + 1)/2 given n >= 1",
        "sum(k**2, k, 1, n) == n*(n + 1)*(2*n + 1)/6 given n >= 0, n > -1",
    ],
)
def test_a_condition_on_n_that_is_not_needed_does_not_stop_an_induction(claim: str) -> None:
    assert export(theorems(read(claim))).accepted


@pytest.mark.coq
def test_a_sum_that_holds_only_under_its_condition_gets_no_proof() -> None:
    assert (
        export(theorems(read("sum(k, k, 1, n) == n*(n + 1)/2 + 1 given n >= 1"))).accepted is False
    )
