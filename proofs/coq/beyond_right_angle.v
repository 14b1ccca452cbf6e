intros a b x g A B G_3 G_4 G_5 S N_1 N_2 N_3.
enough (atan (sqrt (a + b) * sqrt (b + g) * / sqrt ((-1) * g * (b + a * sin x ^ 2) + a * b * cos x ^ 2) * sin x) < 0) by lra.
apply atan_below; assert (0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra).
assert (0 < sqrt (b + g)) by (apply sqrt_lt_R0; lra).
assert (0 < / sqrt ((-1) * g * (b + a * sin x ^ 2) + a * b * cos x ^ 2)) by (apply Rinv_0_lt_compat, sqrt_lt_R0; exact N_1).
set (q := / sqrt _) in *; assert (0 < sqrt (a + b) * sqrt (b + g) * q) by positive; nra.
