intros; rewrite Rabs_left by assumption; assert (0 < / b) by (apply Rinv_0_lt_compat; lra).
assert (sqrt (/ b * - gamma) <= 1).
{ rewrite <- sqrt_1; apply sqrt_le_1_alt; apply (Rmult_le_reg_l b); [lra |];
  rewrite <- Rmult_assoc, Rinv_r by lra; lra. }
rewrite sqrt_mult in * by lra; lra.
