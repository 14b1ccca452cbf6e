intros a b e D E F A B B1 L; pose proof PI_RGT_0 as PP; assert (P3 : 31 / 10 < PI < 32 / 10) by (split; interval).
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
rewrite (turn_of_share a b e A B) in D.
pose proof (sinh_at_root a b _ e A B S C D) as H.
assert (K : 1 / 2 <= sqrt (a * b)) by (apply below_sqrt; lra).
pose proof (product_root a b A B) as KR; assert (Rp : 0 < b * / a) by positive.
assert (R2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; lra).
assert (RR : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; exact Rp).
assert (Q2 : sqrt (b * / a + 1) ^ 2 = sqrt (b * / a) ^ 2 + 1) by (rewrite R2; apply pow2_sqrt; lra).
assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
set (k := sqrt (a * b)) in *; set (r := sqrt (b * / a)) in *.
set (q := sqrt (b * / a + 1)) in *; rewrite <- R2 in H.
assert (r <= 2 * b) by nra.
assert (G0 : forall y, 0 < 4 * b ^ 2 * sin y ^ 2 + 1) by (intro y; pose proof (pow2_ge_0 (b * sin y)); nra).
assert (G1 : 0 < r ^ 2 * sin e ^ 2 + 1) by (pose proof (pow2_ge_0 (r * sin e)); nra).
assert (W : forall M, e <= M -> M <= PI / 2 -> e <= atan (/ (sqrt (4 * b ^ 2 + 1)
  * sinh (1 / 2 * PI + 1 / 2 * atan (2 * b * (/ sqrt (4 * b ^ 2 * sin M ^ 2 + 1) * cos M)))))).
{ intros M EM MP; assert (SM : sin e <= sin M) by (apply sin_incr_1; lra).
  assert (CM : 0 <= cos M <= cos e) by (split; [apply cos_ge_0; lra | apply cos_decr_1; lra]).
  set (G := / sqrt (4 * b ^ 2 * sin M ^ 2 + 1) * cos M).
  assert (GG : 0 <= G <= / sqrt (r ^ 2 * sin e ^ 2 + 1) * cos e).
  { split; [apply Rmult_le_pos; [left; apply Rinv_0_lt_compat, sqrt_lt_R0, G0 | lra] |].
    apply Rmult_le_compat; [left; apply Rinv_0_lt_compat, sqrt_lt_R0, G0 | lra | | lra].
    apply Rinv_le_contravar; [apply sqrt_lt_R0, G1 | apply sqrt_le_1_alt].
    assert (r ^ 2 <= 4 * b ^ 2) by nra; assert (sin e ^ 2 <= sin M ^ 2) by nra; nra. }
  set (th := 1 / 2 * atan (2 * b * G)).
  assert (T0 : 0 <= th).
  { unfold th; assert (0 <= 2 * b * G) by nra; destruct (Req_dec (2 * b * G) 0) as [Z | Z]; [rewrite Z, atan_0; lra |].
    pose proof (atan_above (2 * b * G) ltac:(lra)); lra. }
  assert (T : th <= k * atan (r * (/ sqrt (r ^ 2 * sin e ^ 2 + 1) * cos e))).
  { pose proof (atan_share (/ (2 * k)) (2 * b * G)) as X.
    assert (I : 0 < / (2 * k)) by positive; assert (J : / (2 * k) * (2 * k) = 1) by (field; lra).
    specialize (X ltac:(nra) ltac:(nra)); replace (/ (2 * k) * (2 * b * G)) with (r * G) in X by (rewrite <- KR; field; lra).
    assert (Y : atan (r * G) <= atan (r * (/ sqrt (r ^ 2 * sin e ^ 2 + 1) * cos e))).
    { apply arctangent_rises, Rmult_le_compat_l; lra. }
    apply Rle_trans with (k * atan (r * G)); [| apply Rmult_le_compat_l; lra].
    unfold th; replace (1 / 2 * atan (2 * b * G)) with (k * (/ (2 * k) * atan (2 * b * G))) by (field; lra).
    apply Rmult_le_compat_l; lra. }
  assert (U : 0 <= sinh (2 * k * (1 / 2 * PI) + th) - 2 * k * sinh (1 / 2 * PI + th)).
  { apply (from_left_ge (fun s : R => sinh (s * (1 / 2 * PI) + th) - s * sinh (1 / 2 * PI + th))
      (fun s : R => 1 / 2 * PI * cosh (s * (1 / 2 * PI) + th) - sinh (1 / 2 * PI + th)) 1 (2 * k)); [lra | | |].
    - intros s _; eapply d_eq; [derive |]; ring.
    - intros s X; assert (sinh (1 / 2 * PI + th) <= sinh (s * (1 / 2 * PI) + th)) by (apply sinh_grows; nra).
      assert (sinh (s * (1 / 2 * PI) + th) < cosh (s * (1 / 2 * PI) + th)).
      { unfold sinh, cosh; pose proof (exp_pos (- (s * (1 / 2 * PI) + th))); lra. }
      pose proof (cosh_pos (s * (1 / 2 * PI) + th)); nra.
    - rewrite Rmult_1_l; lra. }
  assert (V : sinh (2 * k * (1 / 2 * PI) + th) <= sinh (k * (PI + atan (r * (/ sqrt (r ^ 2 * sin e ^ 2 + 1) * cos e))))).
  { apply sinh_grows; lra. }
  assert (S0 : 0 < sinh (1 / 2 * PI + th)) by (rewrite <- sinh_0; apply sinh_lt; lra).
  assert (N : sqrt (4 * b ^ 2 + 1) * sinh (1 / 2 * PI + th) <= / sin e * cos e).
  { replace (/ sin e * cos e) with (q * (/ q * / sin e * cos e)) by (field; lra); rewrite <- H.
    set (s0 := sinh (1 / 2 * PI + th)) in *; set (s1 := sinh (k * _)) in *.
    assert (X : 2 * k * s0 <= s1) by lra; assert (s0 <= s1) by nra.
    assert (Y : 0 <= q * s1) by (apply Rmult_le_pos; lra).
    apply Rsqr_incr_0_var; [| exact Y]; rewrite !Rsqr_pow2, !(Rpow_mult_distr _ _ 2), pow2_sqrt by (pose proof (pow2_ge_0 b); nra).
    rewrite Q2; replace (4 * b ^ 2 + 1) with (r ^ 2 * (2 * k) ^ 2 + 1) by (rewrite <- KR; ring).
    assert (0 <= 2 * k * s0) by (apply Rmult_le_pos; lra).
    assert (s0 ^ 2 <= s1 ^ 2) by (apply pow_incr; lra); assert ((2 * k * s0) ^ 2 <= s1 ^ 2) by (apply pow_incr; lra).
    assert (r ^ 2 * (2 * k * s0) ^ 2 <= r ^ 2 * s1 ^ 2) by (apply Rmult_le_compat_l; [apply pow2_ge_0 | lra]).
    replace ((r ^ 2 * (2 * k) ^ 2 + 1) * s0 ^ 2) with (r ^ 2 * (2 * k * s0) ^ 2 + s0 ^ 2) by ring; lra. }
  assert (Z : 0 < sqrt (4 * b ^ 2 + 1)) by (apply sqrt_lt_R0; nra).
  rewrite <- (atan_tan e) at 1 by lra; apply arctangent_rises.
  unfold tan; replace (sin e / cos e) with (/ (/ sin e * cos e)) by (field; lra).
  apply Rinv_le_contravar; [positive | exact N]. }
clear D H KR R2 Q2 G1 Rp RR Q.
assert (E1 : e <= 42 / 100).
{ eapply Rle_trans; [apply (W (PI / 2)); lra |]; rewrite cos_PI2, !Rmult_0_r, atan_0; unfold sinh; interval with (i_bisect b). }
assert (E2 : e <= 42 / 100 - 28 / 100 * b).
{ eapply Rle_trans; [apply (W (42 / 100)); lra |]; clear W G0 E1; unfold sinh; apply Rminus_le; interval with (i_bisect b, i_taylor b, i_depth 20). }
eapply Rle_trans; [apply (W (42 / 100 - 28 / 100 * b)); lra |]; clear W G0 E1 E2; unfold sinh; apply Rminus_le.
interval with (i_bisect b, i_taylor b, i_depth 20).
