intros [K [n [N H]]]; pose proof PI_RGT_0 as PP; pose proof pi_between as PB.
set (a := Rmin (n / 2) (Rmin (1 / 3600) (/ (4 * (Rabs K + 1))))).
pose proof (Rabs_pos K) as K0; pose proof (Rle_abs K) as K1.
assert (A : 0 < a /\ a < n /\ a <= 1 / 3600 /\ a <= / (4 * (Rabs K + 1))).
{ assert (0 < / (4 * (Rabs K + 1))) by (apply Rinv_0_lt_compat; lra); unfold a; repeat split.
  - repeat apply Rmin_glb_lt; lra.
  - eapply Rle_lt_trans; [apply Rmin_l | lra].
  - eapply Rle_trans; [apply Rmin_r | apply Rmin_l].
  - eapply Rle_trans; [apply Rmin_r | apply Rmin_r]. }
clearbody a; destruct A as [A [A1 [A2 A3]]].
assert (Tanh : forall x, 0 <= x -> tanh x <= x).
{ intros x X; enough (0 <= x - tanh x) by lra.
  apply (from_left_ge (fun t => t - tanh t) (fun t => 1 - 1 * / (cosh t * cosh t)) 0 x X).
  - intros t _; exact (d_minus (fun t => t) tanh t _ _ (d_id t) (d_tanh (fun t => t) t 1 (d_id t))).
  - intros t _; pose proof (cosh_above t); enough (/ (cosh t * cosh t) <= 1) by lra.
    rewrite <- Rinv_1; apply Rinv_le_contravar; nra.
  - rewrite tanh_0; lra. }
assert (K2 : sqrt (a * 1) ^ 2 = a) by (rewrite Rmult_1_r; apply pow2_sqrt; lra).
assert (Kp : 0 < sqrt (a * 1)) by (apply sqrt_lt_R0; lra).
assert (E : exists e, 1 / 10 <= e <= PI / 2 /\ tanh (sqrt (a * 1) * (PI + asin (sqrt (1 * / (a + 1)) * cos e)))
  = / sqrt (1 * / a * sin e ^ 2 + 1) * cos e).
{ apply defect_exists; try lra; rewrite turn_short_is by lra.
  - apply Rle_minus; set (m := asin _); assert (M : - (PI / 2) <= m <= PI / 2) by apply asin_bound.
    eapply Rle_trans; [apply Tanh; nra |].
    assert (I : 0 < 1 * / a) by (assert (0 < / a) by positive; lra).
    assert (W : 0 < sqrt (1 * / a * sin (1 / 10) ^ 2 + 1)) by (apply sqrt_lt_R0; pose proof (pow2_ge_0 (sin (1 / 10))); nra).
    assert (W2 : sqrt (1 * / a * sin (1 / 10) ^ 2 + 1) ^ 2 = 1 * / a * sin (1 / 10) ^ 2 + 1)
      by (apply pow2_sqrt; pose proof (pow2_ge_0 (sin (1 / 10))); nra).
    set (w := sqrt (1 * / a * _ + 1)) in *; set (k := sqrt (a * 1)) in *.
    assert (V : k * w <= 102 / 1000).
    { assert (k ^ 2 * w ^ 2 <= (102 / 1000) ^ 2); [| nra].
      rewrite K2, W2; replace (a * (1 * / a * sin (1 / 10) ^ 2 + 1)) with (sin (1 / 10) ^ 2 + a) by (field; lra).
      assert (sin (1 / 10) ^ 2 <= 1 / 100) by interval; lra. }
    apply (Rmult_le_reg_r w); [exact W |]; replace (/ w * cos (1 / 10) * w) with (cos (1 / 10)) by (field; lra).
    assert (9 / 10 <= cos (1 / 10)) by interval; assert (0 < k * w) by nra.
    apply Rle_trans with (k * w * (3 * PI / 2)); nra.
  - rewrite cos_PI2, Rmult_0_r, Rmult_0_r, asin_0, Rminus_0_r; pose proof (increasing_tanh 0 (sqrt (a * 1) * (PI + 0)) ltac:(nra)) as T; rewrite tanh_0 in T; lra. }
destruct E as [e [[E0 E1] E]].
assert (E2 : e < PI / 2).
{ destruct E1 as [E1|E1]; [exact E1 | exfalso]; rewrite E1, cos_PI2, !Rmult_0_r, asin_0, Rplus_0_r in E.
  pose proof (increasing_tanh 0 (sqrt (a * 1) * PI) ltac:(nra)) as T; rewrite tanh_0 in T; lra. }
pose proof (share_below a 1 0 A ltac:(lra)) as S; rewrite cos_0, Rmult_1_r in S.
assert (J : 0 < / (a + 1)) by positive; assert (J1 : / (a + 1) <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
assert (Q : 0 < a * / (a + 1) <= a) by nra.
specialize (H a 1 e E ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) A1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(apply Rgt_not_eq; lra) ltac:(lra) ltac:(lra)).
set (m := asin _) in *; assert (M : - (PI / 2) <= m <= PI / 2) by apply asin_bound.
assert (R : 0 < sqrt (a * / (a + 1)) <= 1 / 60).
{ split; [apply sqrt_lt_R0; lra | apply above_sqrt; lra]. }
set (q := sqrt (a * / (a + 1))) in *; set (k := sqrt (a * 1)) in *.
assert (X : 1 <= exp (k * (PI + m))) by (rewrite <- exp_0 at 1; apply exp_rises; nra).
assert (Y : exp (-2 * k * (PI + m)) <= 1) by (rewrite <- exp_0; apply exp_rises; nra).
pose proof (exp_pos (-2 * k * (PI + m))) as Y0; set (x := exp (k * (PI + m))) in *; set (y := exp (-2 * k * (PI + m))) in *.
assert (I : 60 <= / q) by (replace 60 with (/ (1 / 60)) by field; apply Rinv_le_contravar; lra).
assert (L : 3 <= 1 / 2 * e * / q * x).
{ assert (3 <= 1 / 2 * e * / q) by nra; assert (0 < 1 / 2 * e * / q) by lra; nra. }
rewrite Rabs_pos_eq in H by lra.
assert (Z : 0 <= 4 * a * / (a + 1) * y <= 4 * a) by (assert (0 <= a * / (a + 1) * y <= a) by (split; [apply Rmult_le_pos; lra | nra]); lra).
rewrite (Rabs_pos_eq (4 * _ * _ * _)) in H by lra.
assert (G : 4 * a * (Rabs K + 1) <= 1).
{ apply Rmult_le_compat_r with (r := 4 * (Rabs K + 1)) in A3; [| lra]; rewrite Rinv_l in A3 by lra; lra. }
set (z := 4 * a * / (a + 1) * y) in *; nra.
