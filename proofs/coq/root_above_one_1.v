intros; assert (0 < b * / a) by (apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]).
assert (1 < sqrt (b * / a * sin epsilon ^ 2 + 1)); [| lra].
rewrite <- sqrt_1 at 1; apply sqrt_lt_1_alt; split; [lra |].
assert (0 < sin epsilon ^ 2) by (apply pow_lt; lra); nra.
