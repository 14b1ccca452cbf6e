intros; assert (0 < / a) by (apply Rinv_0_lt_compat; lra).
assert (B : 0 <= sqrt (gamma * / a) <= 1).
{ split; [apply sqrt_pos |]; rewrite <- sqrt_1; apply sqrt_le_1_alt.
  apply (Rmult_le_reg_l a); [lra |]; replace (a * (gamma * / a)) with (gamma) by (field; lra); lra. }
assert (U : cos v_theta_max ^ 2 * a = gamma).
{ replace (cos v_theta_max) with (sqrt (gamma * / a)) by (subst v_theta_max; rewrite cos_acos by lra; reflexivity).
  rewrite pow2_sqrt by (apply Rmult_le_pos; lra); field; lra. }
replace gamma with (cos v_theta_max ^ 2 * a) at 1 by lra.
replace (theta + -1 * v_theta_max) with (theta + - v_theta_max) by ring.
rewrite !sin_plus, sin_neg, cos_neg; ring [(sin_square v_theta_max) (sin_square theta)].
