"""The rules of Tresym.v in use: an integral, Leibniz's rule, one root, and what each refuses."""

import pytest
from cases import cases
from coq_runs import run

from tresym.coq.candidate_search import prelude

USED = r"""
Goal forall x0 u, 0 < x0 < 1 -> 0 < u ->
  RInt (fun x => / sqrt (u + x ^ 2)) x0 1
  = ln ((sqrt (u + 1) + 1) / (x0 + sqrt (u + x0 ^ 2))).
Proof.
  intros x0 u X U; assert (0 < sqrt (u + x0 ^ 2)) by positive.
  assert (0 < sqrt (u + 1)) by positive.
  rewrite (fundamental_closed _ (fun x => ln (x + sqrt (u + x ^ 2)))).
  - rewrite ln_div by positive; replace (u + 1 ^ 2) with (u + 1) by ring.
    replace (1 + sqrt (u + 1)) with (sqrt (u + 1) + 1) by ring; reflexivity.
  - intros x; rewrite Rmin_left, Rmax_right by lra; intros T; continues.
    assert (0 < sqrt (u + x ^ 2)) by positive; lra.
  - intros x; rewrite Rmin_left, Rmax_right by lra; intros T.
    assert (0 < sqrt (u + x ^ 2)) by positive.
    eapply d_eq; [derive; hard | tidy; field; lra].
Qed.
Goal forall a b g, 0 < a -> 0 < b -> 0 < g ->
  is_derive (fun q => RInt (fun t => (1 - b * sin t ^ 2) / sqrt (q + b * sin t ^ 2)) 1 2) g
    (RInt (fun t => - (1 - b * sin t ^ 2) / (2 * sqrt (g + b * sin t ^ 2) ^ 3)) 1 2).
Proof.
  intros a b g A B G.
  apply (leibniz _ (fun g t => - (1 - b * sin t ^ 2) / (2 * sqrt (g + b * sin t ^ 2) ^ 3))
    1 2 g 0 (g + 1)).
  - lra.
  - intros q t Q T; assert (0 < sqrt (q + b * sin t ^ 2)) by positive.
    eapply d_eq; [derive; side | tidy; field; lra].
  - intros t T; continues_2d; side.
  - intros q Q s S; continues; assert (0 < sqrt (q + b * sin s ^ 2)) by positive; lra.
Qed.
Goal exists! x, 0 < x < 1 /\ x + exp x - 2 = 0.
Proof.
  apply (exactly_one (fun x => x + exp x - 2) (fun x => 1 + exp x) 0 1); [lra | | | |].
  - intros; continues.
  - intros; eapply d_eq; [derive | ring].
  - intros; positive.
  - rewrite exp_0; pose proof (exp_ineq1 1 ltac:(lra)); lra.
Qed.
"""
REFUSED = cases(__file__, "REFUSED")


@pytest.mark.coq
def test_the_rules_serve() -> None:
    accepted, said = run(prelude() + USED, 120)
    assert accepted, said


@pytest.mark.coq
def test_what_lacks_a_condition_is_refused() -> None:
    for text in REFUSED:
        assert not run(f"{prelude()}\nGoal {text}\nQed.\n", 120)[0]
