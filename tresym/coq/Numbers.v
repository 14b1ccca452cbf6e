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
Lemma between l u T : 0 < l -> 0 < u -> excess l < 0 -> 0 < excess u -> 0 < T ->
  excess T = 0 -> l < T < u.
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

(* The floor of every rigid body, I3 <= I1 + I2: its defect is above atan (1 / sinh pi). *)
Lemma sinh_convex c x : 0 <= c -> c <= 1 -> 0 <= x -> sinh (c * x) <= c * sinh x.
Proof.
  intros A B X.
  enough (0 <= c * sinh x - sinh (c * x)) by lra.
  apply (from_left_ge (fun t : R => c * sinh t - sinh (c * t))
    (fun t : R => c * (cosh t - cosh (c * t))) 0 x).
  - exact X.
  - intros t _; eapply d_eq; [derive | ring].
  - intros t T; apply Rmult_le_pos; [exact A |].
    assert (cosh (c * t) <= cosh t) by (apply cosh_rises; nra); lra.
  - rewrite Rmult_0_r, sinh_0; lra.
Qed.
Theorem floor a b T : 0 < a -> 0 < b -> b * (a + 2) <= 1 -> 0 < T ->
  T - sqrt (a * b) * (PI + atan (sqrt (b / a) * tanh T)) = 0 -> atan (/ sinh PI) < defect a b T.
Proof.
  intros A B L P E; pose proof PI_RGT_0 as Q.
  set (c := sqrt (a / (a + b))); set (k := sqrt (a * b)) in *; set (r := sqrt (b / a)) in *.
  assert (AB : 0 < a / (a + b)) by (apply Rdiv_lt_0_compat; lra).
  assert (C : 0 < c) by now apply sqrt_lt_R0.
  assert (C2 : c ^ 2 = a / (a + b)) by (apply pow2_sqrt; lra).
  assert (K : 0 < k) by (apply sqrt_lt_R0; nra).
  assert (K2 : k ^ 2 = a * b) by (apply pow2_sqrt; nra).
  assert (R0 : 0 < r) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; lra).
  assert (R2 : r ^ 2 = b / a) by (apply pow2_sqrt; left; apply Rdiv_lt_0_compat; lra).
  assert (KR : k * r = b) by now apply product_of_roots.
  assert (C1 : c <= 1).
  { assert (c ^ 2 <= 1); [rewrite C2; apply (Rmult_le_reg_r (a + b)); [lra |] | nra].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (S : sin (atan r) = r * c).
  { rewrite sin_atan; unfold Rdiv; f_equal.
    replace (1 + r²) with (/ (a / (a + b))) by (unfold Rsqr; replace (r * r) with (b / a)
      by (rewrite <- R2; ring); field; lra).
    rewrite sqrt_inv, Rinv_inv; reflexivity. }
  assert (kc : k <= c * (1 - b / 2)).
  { assert (0 <= c * (1 - b / 2)) by (apply Rmult_le_pos; nra).
    assert (k ^ 2 <= (c * (1 - b / 2)) ^ 2); [| nra].
    rewrite Rpow_mult_distr, K2, C2; apply (Rmult_le_reg_r (a + b)); [lra |].
    replace (a / (a + b) * (1 - b / 2) ^ 2 * (a + b)) with (a * (1 - b / 2) ^ 2) by (field; lra).
    rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra | nra]. }
  assert (J : atan r <= PI / 2 * (r * c)).
  { rewrite <- S; apply jordan; pose proof (atan_bound r).
    split; [left; rewrite <- atan_0; now apply atan_increasing | lra]. }
  assert (X : 0 < excess k r (c * PI)).
  { unfold excess.
    assert (W : r * tanh (c * PI) < r).
    { assert (tanh (c * PI) < 1); [| nra].
      unfold tanh; pose proof (cosh_pos (c * PI)); apply (Rmult_lt_reg_r (cosh (c * PI))); [lra |].
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra.
      unfold sinh, cosh; pose proof (exp_pos (- (c * PI))); lra. }
    apply atan_increasing in W.
    assert (H : k * (PI + atan (r * tanh (c * PI))) < k * (PI + PI / 2 * (r * c)))
      by (apply Rmult_lt_compat_l; lra).
    replace (k * (PI + PI / 2 * (r * c))) with (PI * (k + (k * r) * c / 2)) in H by field.
    rewrite KR in H; assert (k + b * c / 2 <= c) by lra.
    assert (PI * (k + b * c / 2) <= PI * c) by (apply Rmult_le_compat_l; lra); lra. }
  assert (T1 : T < c * PI).
  { destruct (Rle_or_lt (c * PI) T) as [H|H]; [exfalso | exact H].
    assert (M : excess k r (c * PI) <= excess k r T).
    { destruct H as [H|H]; [left | rewrite H; lra].
      apply (rising (excess k r) (excess_slope k r) (c * PI) T); try lra.
      - intros; now apply excess_continuous.
      - intros; now apply excess_derive.
      - intros t I; apply excess_rises; try assumption; try nra. }
    unfold excess in M; unfold excess in X; lra. }
  unfold defect; apply atan_increasing; fold c.
  assert (0 < sinh T) by now apply sinh_pos.
  assert (sinh T < sinh (c * PI)) by now apply sinh_rises.
  assert (sinh (c * PI) <= c * sinh PI) by (apply sinh_convex; lra).
  assert (0 < sinh PI) by now apply sinh_pos.
  apply (Rmult_lt_reg_r (sinh T * sinh PI)); [nra |].
  replace (/ sinh PI * (sinh T * sinh PI)) with (sinh T) by (field; lra).
  replace (c / sinh T * (sinh T * sinh PI)) with (c * sinh PI) by (field; lra); lra.
Qed.
Theorem floor_value : 0.08637409704956 < atan (/ sinh PI) < 0.08637409704957.
Proof. unfold sinh; split; interval with (i_prec 90). Qed.
