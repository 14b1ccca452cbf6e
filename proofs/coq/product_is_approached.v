intros k K; exists (2 / k + 1); split; [assert (0 < / k) by (apply Rinv_0_lt_compat; lra); lra |]; intros a A N.
assert (I : 0 < 2 / k) by (apply Rdiv_lt_0_compat; lra); rewrite Rabs_R1, Rmult_1_r.
replace (a * / (a + 2) + (-1)) with (- (2 * / (a + 2))) by (field; lra).
assert (0 < / (a + 2)) by (apply Rinv_0_lt_compat; lra); rewrite Rabs_Ropp, Rabs_pos_eq by lra.
apply (Rmult_le_reg_r (a + 2)); [lra |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
assert (2 = k * (2 / k)) by (field; lra); nra.
