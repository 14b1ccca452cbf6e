intros; assert (0 < b * / a) by (apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]).
assert (0 < sin epsilon ^ 2) by (apply pow_lt; lra); assert (0 < cos epsilon ^ 2) by (apply pow_lt; lra).
assert (0 < sqrt (b * / a * sin epsilon ^ 2 + 1)) by (apply sqrt_lt_R0; nra).
apply Rlt_gt, Rmult_lt_0_compat; [apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; lra | nra].
