intros; assert (0 < / (a + b)) by (apply Rinv_0_lt_compat; lra).
assert (B : 0 <= sqrt (/ (a + b) * (b + gamma)) <= 1).
{ split; [apply sqrt_pos |]; rewrite <- sqrt_1; apply sqrt_le_1_alt.
  apply (Rmult_le_reg_l (a + b)); [lra |]; replace ((a + b) * (/ (a + b) * (b + gamma))) with (b + gamma) by (field; lra); lra. }
assert (U : cos v_theta_min ^ 2 * (a + b) = b + gamma).
{ replace (cos v_theta_min) with (sqrt (/ (a + b) * (b + gamma))) by (subst v_theta_min; rewrite cos_acos by lra; reflexivity).
  rewrite pow2_sqrt by (apply Rmult_le_pos; lra); field; lra. }
replace (b + gamma) with (cos v_theta_min ^ 2 * (a + b)) by lra.
replace (theta + -1 * v_theta_min) with (theta + - v_theta_min) by ring.
rewrite !sin_plus, sin_neg, cos_neg; ring [(sin_square v_theta_min) (sin_square theta)].
