(* The flip defect of a body: one root for every shape, and fifty digits for each named body.

   With k = sqrt (a b) and r = sqrt (b/a) the phase T solves T = k (pi + atan (r tanh T)), and the
   defect is the angle whose tangent is sqrt (a/(a + b)) / sinh T. *)

Section Root.
Variables k r : R.
Hypotheses (K : 0 < k) (P : 0 < r) (Q : k * r <= 1).

Definition excess (T : R) : R := T - k * (PI + atan (r * tanh T)).
Definition excess_slope (T : R) : R :=
  1 - k * (r * / (cosh T * cosh T) * / (1 + r * tanh T * (r * tanh T))).

Lemma excess_derive T : is_derive excess T (excess_slope T).
Proof.
  unfold excess, excess_slope; pose proof (cosh_pos T); eapply d_eq; [derive |].
  cbv beta; field; repeat split; try lra.
  all: pose proof (Rle_0_sqr (r * tanh T)); unfold Rsqr in *; nra.
Qed.
Lemma sinh_pos T : 0 < T -> 0 < sinh T.
Proof.
  intros H; unfold sinh; assert (exp (- T) < exp T) by (apply exp_increasing; lra); lra.
Qed.
Lemma excess_rises T : 0 < T -> 0 < excess_slope T.
Proof.
  intros H; unfold excess_slope, tanh; pose proof (cosh_pos T) as C; pose proof (sinh_pos T H) as S.
  pose proof (cosh_sinh T) as E.
  assert (H1 : 0 < cosh T * cosh T + r * sinh T * (r * sinh T)) by nra.
  set (D := cosh T * cosh T + r * sinh T * (r * sinh T)) in *.
  replace (1 - _) with ((D - k * r) / D) by (unfold D; field; split; nra).
  apply Rdiv_lt_0_compat; [unfold D | exact H1].
  assert (0 < sinh T * sinh T) by nra; assert (0 < r * sinh T) by nra; nra.
Qed.
Lemma excess_continuous T : continuous excess T.
Proof. exact (continuous_derive _ _ _ (excess_derive T)). Qed.
(* For every shape, 0 < b <= 1. *)
Theorem one_root : exists! T, 0 < T < 3 * PI * k / 2 /\ excess T = 0.
Proof.
  pose proof PI_RGT_0; apply (exactly_one excess excess_slope).
  - nra.
  - intros; apply excess_continuous.
  - intros; apply excess_derive.
  - intros; now apply excess_rises.
  - unfold excess; rewrite tanh_0, Rmult_0_r, atan_0; split; [nra |].
    pose proof (atan_bound (r * tanh (3 * PI * k / 2))); nra.
Qed.
Lemma between l u T : 0 < l -> 0 < u -> excess l < 0 -> 0 < excess u -> 0 < T -> excess T = 0 -> l < T < u.
Proof.
  intros L U A B X E.
  assert (M : forall x y, 0 <= x -> x < y -> excess x < excess y).
  { intros x y X0 XY; apply (rising excess excess_slope x y); try lra.
    - intros; apply excess_continuous.
    - intros; apply excess_derive.
    - intros t T0; apply excess_rises; lra. }
  split.
  - destruct (Rle_or_lt T l) as [[H|H]|H]; [| subst; lra | exact H].
    assert (excess T < excess l) by (apply M; lra); lra.
  - destruct (Rle_or_lt u T) as [[H|H]|H]; [| subst; lra | exact H].
    assert (excess u < excess T) by (apply M; lra); lra.
Qed.
End Root.

Lemma tanh_exp x : tanh x = 1 - 2 * / (exp (2 * x) + 1).
Proof.
  unfold tanh, sinh, cosh; assert (P := exp_pos x).
  replace (2 * x) with (x + x) by ring; rewrite exp_plus, exp_Ropp.
  field; repeat split; nra.
Qed.

Lemma product_of_roots a b : 0 < a -> 0 < b -> sqrt (a * b) * sqrt (b / a) = b.
Proof.
  intros A B; rewrite <- sqrt_mult_alt by nra.
  replace (a * b * (b / a)) with (b ^ 2) by (field; lra); apply sqrt_pow2; lra.
Qed.
Theorem one_phase a b : 0 < a -> 0 < b -> b <= 1 ->
  exists! T, 0 < T < 3 * PI * sqrt (a * b) / 2
    /\ T - sqrt (a * b) * (PI + atan (sqrt (b / a) * tanh T)) = 0.
Proof.
  intros A B L; apply (one_root (sqrt (a * b)) (sqrt (b / a))).
  - apply sqrt_lt_R0; nra.
  - apply sqrt_lt_R0, Rdiv_lt_0_compat; assumption.
  - rewrite product_of_roots; lra.
Qed.
Definition defect (a b T : R) : R := atan (sqrt (a / (a + b)) / sinh T).
