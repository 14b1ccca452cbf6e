intros P a b e Q D E F A B B1; pose proof PI_RGT_0.
destruct (claim_phase_range P a b e Q D E F A B B1) as [V U]; intros.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
replace (3 / 2 * PI * sqrt (a * b)) with (P * sqrt (a * b) + (3 / 2 * PI + (-1) * P) * sqrt (a * b)) by ring.
apply claim_hyperbolic_sine_rises; nra.
