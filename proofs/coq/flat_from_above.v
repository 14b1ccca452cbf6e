intros k K; exists (k / 11 ^ 11); split; [apply Rdiv_lt_0_compat; lra |]; intros x X L _.
rewrite !Rabs_pos_eq by (first [apply pow_le; lra | left; apply exp_pos]).
assert (I : 0 < / x) by (apply Rinv_0_lt_compat; lra).
assert (E : (/ x / 11) ^ 11 <= exp (/ x)).
{ replace (exp (/ x)) with (exp (/ x / 11) ^ 11) by (simpl; rewrite Rmult_1_r, <- !exp_plus; f_equal; field; lra).
  apply pow_incr; pose proof (exp_ineq1 (/ x / 11) ltac:(lra)); lra. }
replace ((-1) * / x) with (- / x) by ring; rewrite exp_Ropp; pose proof (exp_pos (/ x)).
apply (Rmult_le_reg_r (exp (/ x))); [lra |]; rewrite Rinv_l by lra.
apply Rle_trans with (k * x ^ 10 * (/ x / 11) ^ 11).
- replace (k * x ^ 10 * (/ x / 11) ^ 11) with (k / 11 ^ 11 * / x) by (field; lra).
  apply (Rmult_le_reg_r x); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra.
- apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra | apply pow_le; lra] | exact E].
