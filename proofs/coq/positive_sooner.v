intros a A _ _ _ _ _; pose proof PI_RGT_0.
pose proof (asin_bound (/ (a + 1) * tanh PI)).
assert (I : 0 < / (a + 1)) by positive; assert (J : / (a + 1) * (a + 1) = 1) by (field; lra).
assert (K : / (a + 1) < 1) by nra; rewrite <- pow_inv; set (u := / (a + 1)) in *.
assert (0 < sqrt ((-1) * u ^ 2 + 1)) by (apply sqrt_lt_R0; nra).
apply Rlt_gt, Rmult_lt_0_compat; [positive | lra].
