intros; assert (S : 0 < sinh v_T) by (rewrite <- sinh_0; apply sinh_lt; lra).
pose proof (cosh_pos v_T) as C; assert (U : 0 < tanh v_T) by (apply Rdiv_lt_0_compat; lra).
assert (0 < / b) by (apply Rinv_0_lt_compat; lra); assert (0 < / a) by (apply Rinv_0_lt_compat; lra).
assert (0 < b * / a * tanh v_T ^ 2 + 1).
{ pose proof (pow2_ge_0 (tanh v_T)); assert (0 < b * / a) by (apply Rmult_lt_0_compat; lra); nra. }
assert (0 < / (b * / a * tanh v_T ^ 2 + 1)) by (apply Rinv_0_lt_compat; lra).
apply Rlt_gt, Rplus_lt_0_compat; repeat first [assumption | lra | apply Rmult_lt_0_compat].
