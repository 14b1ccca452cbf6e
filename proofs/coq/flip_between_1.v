intros; assert (M : v_psi_max = PI + (-1) * v_psi_min) by lra; rewrite M; clear M.
rewrite Rabs_left in * by assumption; assert (0 < / b) by (apply Rinv_0_lt_compat; lra).
assert (B : 0 <= sqrt (/ b) * sqrt (- gamma) <= 1).
{ rewrite <- sqrt_mult by lra; split; [apply sqrt_pos |]; rewrite <- sqrt_1; apply sqrt_le_1_alt;
  apply (Rmult_le_reg_l b); [lra |]; rewrite <- Rmult_assoc, Rinv_r by lra; lra. }
assert (U : sin v_psi_min = sqrt (/ b) * sqrt (- gamma)) by (subst v_psi_min; apply sin_asin; lra).
assert (U2 : sin v_psi_min ^ 2 * b = - gamma).
{ rewrite U, <- sqrt_mult, pow2_sqrt by (try apply Rmult_le_pos; lra); field; lra. }
replace (psi + -1 * (PI + -1 * v_psi_min)) with (- PI + (psi + v_psi_min)) by ring;
  replace (psi + -1 * v_psi_min) with (psi + - v_psi_min) by ring.
rewrite (sin_plus (- PI)), (sin_plus psi), (sin_plus psi), !sin_neg, !cos_neg, sin_PI, cos_PI.
replace gamma with (- (sin v_psi_min ^ 2 * b)) by lra.
ring [(sin_square v_psi_min) (sin_square psi)].
