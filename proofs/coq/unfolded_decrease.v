intros a b c x y g D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6 G_7 G_8.
assert (v1 > 0).
{ set (h := fun t : R => / sqrt ((-1) * g * (b + a * sin t ^ 2) + a * b * cos t ^ 2)
    * / (a + b * sin t ^ 2 + (-1) * g * cos t ^ 2)
    * (cos t ^ 2 * ((-1) * b + 1) * (a + (-1) * g) + sin t ^ 2 * (g + 1) * (a + b))).
  assert (P : forall t, 0 < (-1) * g * (b + a * sin t ^ 2) + a * b * cos t ^ 2).
  { intros t; assert (0 <= a * b * cos t ^ 2) by (apply Rmult_le_pos; [left; positive | apply pow2_ge_0]).
    assert (0 < (-1) * g * (b + a * sin t ^ 2)); [| lra].
    apply Rmult_lt_0_compat; [lra |]; pose proof (pow2_ge_0 (sin t)); nra. }
  assert (Q : forall t, 0 < a + b * sin t ^ 2 + (-1) * g * cos t ^ 2).
  { intros t; pose proof (pow2_ge_0 (sin t)); pose proof (pow2_ge_0 (cos t)).
    assert (0 <= b * sin t ^ 2) by (apply Rmult_le_pos; lra).
    assert (0 <= (-1) * g * cos t ^ 2) by (apply Rmult_le_pos; lra); lra. }
  assert (W : v1 = h x).
  { rewrite <- (is_derive_unique _ _ _ E_1); apply is_derive_unique; apply (d_upper_end h 0 (-1) (PI + 1)).
    - rewrite Rmin_left; lra.
    - rewrite Rmax_right; lra.
    - intros t _; unfold h; continues; [apply Rgt_not_eq, sqrt_lt_R0, P | apply Rgt_not_eq, Q]. }
  rewrite W; unfold h; pose proof (P x); pose proof (Q x).
  assert (0 < sqrt ((-1) * g * (b + a * sin x ^ 2) + a * b * cos x ^ 2)) by (apply sqrt_lt_R0; assumption).
  assert (0 <= cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * g)).
  { apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0 | lra] | lra]. }
  assert (0 < sin x ^ 2 * (g + 1) * (a + b)).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt; lra | lra] | lra]. }
  apply Rlt_gt, Rmult_lt_0_compat; [positive | lra]. }
pose proof (claim_phase_rises_in_gamma v2 a b x g E_2 A B G_3 G_4 G_5 G_6 G_7 G_8).
assert (0 < / v1) by (apply Rinv_0_lt_compat; lra); rewrite E; nra.
