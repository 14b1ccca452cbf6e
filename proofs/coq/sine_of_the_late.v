intros a b A B B1 L N; assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
apply claim_hyperbolic_sine_at_most; [exact K |].
rewrite <- sqrt_1; apply sqrt_le_1_alt; exact L.
