intros a b c g p G_1 G_2 G_3 G_4 G_5 N_1 N_2 N_3.
pose proof (SIN_bound p); assert (0 <= (-1) * b * sin p ^ 2 + 1) by nra.
assert (L : / sqrt (g + b * sin p ^ 2) <= / sqrt (c + b * sin p ^ 2)).
{ apply Rinv_le_contravar; [apply sqrt_lt_R0; lra | apply sqrt_le_1_alt; lra]. }
assert (0 < / sqrt (a + b * sin p ^ 2)) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra).
apply Rle_ge, Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_l; lra.
