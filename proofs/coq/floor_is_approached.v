intros a b e D E F A B N1 N2; assert (A0 : a > 0) by lra; assert (B0 : 0 < b) by (rewrite B; positive).
assert (B1 : b <= 1) by (rewrite B, <- Rinv_1; apply Rinv_le_contravar; lra).
specialize (D A0 B0 B1); specialize (E A0 B0 B1); specialize (F A0 B0 B1); pose proof PI_RGT_0.
destruct (claim_above_is_an_angle a A N1) as [X [Y [S C]]].
assert (I : 0 < / (a + 1)) by positive; assert (J : / (a + 1) * (a + 1) = 1) by (field; lra).
assert (V : / (a + 1) < 1) by nra.
assert (W : 0 < b * / a) by positive; assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (R : 0 < (-1) * / ((a + 1) ^ 2) + 1) by (rewrite <- pow_inv; nra).
assert (R2 : a * / (a + / (a + 2)) = (-1) * / ((a + 1) ^ 2) + 1) by (field; repeat split; nra).
assert (R3 : / a * / (a + 2) = b * / a) by (rewrite B; ring).
assert (G : 0 < turn_short a b (/ (a + 1) + 2 * atan (exp ((-1) * PI)))).
{ rewrite turn_short_is by lra.
  pose proof (claim_tangents_above a A) as L; pose proof (claim_inverse_above a A) as M.
  rewrite R2, R3 in M; set (f := / (a + 1) + 2 * atan (exp ((-1) * PI))) in *.
  assert (Z : 0 < cos f ^ 2 * / (sin f ^ 2)) by positive; pose proof (COS_bound f); pose proof (pow2_ge_0 (sin f)).
  assert (Q : sqrt (b * / (a + b)) = / (a + 1)).
  { apply sqrt_unique; [lra |]; rewrite B; field; repeat split; nra. }
  assert (O : sqrt (a * b) = / (/ (a + 1) + 1) * sqrt ((-1) * / ((a + 1) ^ 2) + 1)).
  { apply sqrt_unique; [positive |]; rewrite Rpow_mult_distr, pow2_sqrt, B by lra; field; repeat split; lra. }
  rewrite Q, O; set (r := (-1) * / ((a + 1) ^ 2) + 1) in *.
  replace (r * cos f ^ 2 * / (sin f ^ 2)) with (cos f ^ 2 * / (sin f ^ 2) * r) in M by ring.
  specialize (L ltac:(nra) ltac:(nra) N1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(nra)).
  assert (0 < / (a + 2)) by positive.
  specialize (M N1 ltac:(nra) N2 ltac:(lra) ltac:(lra) ltac:(nra) ltac:(nra) ltac:(lra)); lra. }
assert (T : turn_short a b 0 < 0).
{ unfold turn_short; rewrite sin_0, cos_0; replace (b * / a * 0 ^ 2 + 1) with 1 by ring; rewrite sqrt_1, Rinv_1.
  assert (P : forall x, 0 < 2 / (exp x + 1)) by (intro x; pose proof (exp_pos x); apply Rdiv_lt_0_compat; lra).
  match goal with |- 1 - 2 / (exp ?x + 1) - _ < _ => pose proof (P x) end; lra. }
destruct (defect_exists a b 0 (/ (a + 1) + 2 * atan (exp ((-1) * PI))) A0 B0 ltac:(lra) ltac:(lra) ltac:(lra)) as [z [Z L]].
rewrite turn_short_is in G, T by lra.
assert (z <> 0) by (intro Q; rewrite Q in L; lra).
assert (z <> / (a + 1) + 2 * atan (exp ((-1) * PI))) by (intro Q; rewrite Q in L; lra).
destruct (claim_defect_is_one a b A0 B0 B1) as [y [_ U]]; try lra; try (left; positive).
rewrite <- (U e) by (repeat split; lra); rewrite (U z) by (repeat split; lra); lra.
