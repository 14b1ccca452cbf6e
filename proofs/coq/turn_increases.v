intros a b e G_1 G_2 G_3 G_4 G_5 S C N_1 N_2 N_3 N_4 N_5 N_6.
assert (0 < sqrt (b * / (a + b))) by (apply sqrt_lt_R0; positive).
exists (sqrt (b * / (a + b)) * sin e * / sqrt ((-1) * (sqrt (b * / (a + b)) * cos e) ^ 2 + 1)); split.
- eapply d_eq; [derive; lra |]; cbv beta; ring.
- apply Rlt_gt; assert (0 < (-1) * (sqrt (b * / (a + b)) * cos e) ^ 2 + 1) by nra; positive.
