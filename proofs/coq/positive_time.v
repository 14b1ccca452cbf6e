intros a b e A B _ _ _ _ _ _; pose proof PI_RGT_0.
pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)).
apply Rlt_gt, Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | lra].
