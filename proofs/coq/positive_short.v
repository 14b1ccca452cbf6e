intros a A _ S _; assert (I : 0 < / (a + 1)) by positive; assert (J : / (a + 1) <= / 8) by (apply Rinv_le_contravar; lra).
assert (M : / 100 <= 2 * atan (exp ((-1) * PI)) <= / 10) by (split; interval).
assert (P : 3 < PI) by interval; rewrite <- pow_inv; set (u := / (a + 1)) in *.
assert (0 < sin (u + 2 * atan (exp ((-1) * PI)))) by (apply sin_gt_0; lra).
assert (0 < cos (u + 2 * atan (exp ((-1) * PI)))) by (apply cos_gt_0; lra).
assert (0 < sqrt ((-1) * u ^ 2 + 1)) by (apply sqrt_lt_R0; nra).
apply Rlt_gt; rewrite <- arcsinh_0; apply arcsinh_lt; positive.
