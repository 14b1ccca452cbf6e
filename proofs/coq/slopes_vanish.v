intros k K; set (c := 12 * (13 / 2) ^ 13); assert (C : 0 < c) by (unfold c; lra).
exists (k / c); split; [apply Rdiv_lt_0_compat; lra |]; intros x X L _.
assert (I : 0 < / x) by (apply Rinv_0_lt_compat; lra).
assert (E : (2 * / x / 13) ^ 13 <= exp (2 * / x)).
{ replace (exp (2 * / x)) with (exp (2 * / x / 13) ^ 13) by (simpl; rewrite Rmult_1_r, <- !exp_plus; f_equal; field; lra).
  apply pow_incr; pose proof (exp_ineq1 (2 * / x / 13) ltac:(lra)); lra. }
replace ((-2) * / x) with (- (2 * / x)) by ring; rewrite exp_Ropp; pose proof (exp_pos (2 * / x)) as P.
assert (0 < / x ^ 2) by (apply Rinv_0_lt_compat; nra); pose proof (Rinv_0_lt_compat _ P).
rewrite !Rabs_pos_eq by (first [apply pow_le; lra | left; positive]).
apply (Rmult_le_reg_r (exp (2 * / x))); [lra |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
apply Rle_trans with (k * x ^ 10 * (2 * / x / 13) ^ 13).
- apply (Rmult_le_reg_r (x ^ 3)); [apply pow_lt; lra |].
  replace (k * x ^ 10 * (2 * / x / 13) ^ 13 * x ^ 3) with (12 * (k / c)) by (unfold c; field; lra).
  replace (12 * / x ^ 2 * x ^ 3) with (12 * x) by (field; lra); lra.
- apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra | apply pow_le; lra] | exact E].
