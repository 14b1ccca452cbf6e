intros a b p v A B G_3 G_4 N; pose proof (forward b B p G_3); pose proof (reach a b A B p).
exists (2 * v * ((-1) * b * sin p ^ 2 + 1) ^ 2 * / (a + b * sin p ^ 2)); split.
- eapply d_eq; [derive |]; tidy; ring.
- apply Rlt_gt; positive.
