intros; assert (P : 0 < sinh v_T) by (rewrite <- sinh_0; apply sinh_lt; lra).
pose proof (cosh_sinh v_T); assert (0 < b * / a) by (apply Rmult_lt_0_compat;
  [lra | apply Rinv_0_lt_compat; lra]).
assert (1 < cosh v_T ^ 2 + b * / a * sinh v_T ^ 2) by nra.
set (D := cosh v_T ^ 2 + b * / a * sinh v_T ^ 2) in *; clearbody D.
replace (-1 * b * / D + 1) with ((D - b) / D) by (field; lra); apply Rlt_gt.
apply Rdiv_lt_0_compat; lra.
