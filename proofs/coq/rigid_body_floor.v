intros a b e D E F A B N; assert (B0 : 0 < b) by (rewrite B; positive).
assert (B1 : b <= 1) by (rewrite B, <- Rinv_1; apply Rinv_le_contravar; lra).
specialize (D B0 B1); specialize (E B0 B1); specialize (F B0 B1); pose proof PI_RGT_0.
destruct floor_angles as [X [Y S]]; set (f := 2 * atan (exp ((-1) * PI))) in *.
assert (M : / 100 <= f <= / 10) by (unfold f; split; interval).
assert (I : 0 < / (a + 1)) by positive; assert (J : / (a + 1) * (a + 1) = 1) by (field; lra).
assert (V : / (a + 1) < 1) by nra.
assert (T : -1 < tanh PI < 1) by (split; interval); assert (P3 : 3 < PI) by interval.
assert (W : 0 < b * / a) by positive; assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (G : turn_short a b f < 0).
{ rewrite turn_short_is by lra; rewrite Y.
  assert (R : 0 < (-1) * / ((a + 1) ^ 2) + 1) by (rewrite <- pow_inv; nra).
  assert (Z : 0 < sinh PI ^ 2 * ((-1) * / ((a + 1) ^ 2) + 1) + 1) by (pose proof (pow2_ge_0 (sinh PI)); nra).
  pose proof (claim_tangents_at_the_floor a A Z ltac:(lra) ltac:(lra) ltac:(nra) ltac:(nra) ltac:(lra)) as L.
  assert (Q : sqrt (b * / (a + b)) = / (a + 1)).
  { apply sqrt_unique; [lra |]; rewrite B; field; repeat split; nra. }
  assert (O : sqrt (a * b) = / (/ (a + 1) + 1) * sqrt ((-1) * / ((a + 1) ^ 2) + 1)).
  { apply sqrt_unique; [positive |]; rewrite Rpow_mult_distr, pow2_sqrt, B by lra; field; repeat split; lra. }
  rewrite Q, O; set (t := tanh (/ (/ (a + 1) + 1) * _ * _)) in *.
  assert (U : 0 < sinh PI) by (rewrite <- sinh_0; apply sinh_lt; lra).
  assert (P : (1 + sinh PI ^ 2) * sin f ^ 2 = 1) by (pose proof (sin_square f); rewrite <- X in *; nra).
  set (r := (-1) * / ((a + 1) ^ 2) + 1) in *; set (h := sinh PI) in *; rewrite <- Y, <- X.
  assert (H0 : sqrt (h ^ 2 * r + 1) * sin f = sqrt r * sqrt (b * / a * sin f ^ 2 + 1)).
  { apply same_square; [left; positive | apply Rmult_le_pos; apply sqrt_pos |].
    rewrite !Rpow_mult_distr, !pow2_sqrt by nra.
    transitivity (r * (h ^ 2 * sin f ^ 2) + sin f ^ 2); [ring |].
    replace (h ^ 2 * sin f ^ 2) with (1 - sin f ^ 2) by lra.
    unfold r; rewrite B; field; repeat split; lra. }
  assert (0 < sqrt (h ^ 2 * r + 1)) by positive.
  assert (0 < sqrt (b * / a * sin f ^ 2 + 1)) by (apply sqrt_lt_R0; nra).
  replace (/ sqrt (b * / a * sin f ^ 2 + 1) * (h * sin f)) with (sqrt r * / sqrt (h ^ 2 * r + 1) * h); [lra |].
  apply (Rmult_eq_reg_r (sqrt (h ^ 2 * r + 1) * sqrt (b * / a * sin f ^ 2 + 1))); [| apply Rgt_not_eq; positive].
  transitivity (h * (sqrt r * sqrt (b * / a * sin f ^ 2 + 1))); [field; lra |].
  rewrite <- H0; field; lra. }
assert (C : 0 < turn_short a b (PI / 2)).
{ rewrite turn_short_is by lra; rewrite cos_PI2, !Rmult_0_r, asin_0, <- tanh_0.
  pose proof (increasing_tanh 0 (sqrt (a * b) * (PI + 0)) ltac:(nra)) as L; rewrite tanh_0 in *; lra. }
destruct (defect_exists a b f (PI / 2) A B0 ltac:(lra) ltac:(lra) ltac:(lra)) as [z [Z L]].
rewrite turn_short_is in G, C by lra.
assert (z <> f) by (intro Q; rewrite Q in L; lra); assert (z <> PI / 2) by (intro Q; rewrite Q in L; lra).
destruct (claim_defect_is_one a b A B0 B1) as [y [_ U]]; try lra; try (left; positive).
rewrite <- (U e) by (repeat split; lra); rewrite (U z) by (repeat split; lra); lra.
