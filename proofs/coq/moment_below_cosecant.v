intros u x G_1 G_2 N_1 N_2; set (w := sqrt (u + x ^ 2)).
assert (W : w ^ 2 = u + x ^ 2) by (apply pow2_sqrt; lra).
assert (P : 0 < w) by (apply sqrt_lt_R0; exact N_1).
assert (L : x <= w) by (apply below_sqrt; lra).
replace (/ x + (-1) * x ^ 4 * / w ^ 5) with ((w ^ 5 - x ^ 5) * (/ x * / w ^ 5)) by (field; lra).
apply Rle_ge, Rmult_le_pos; [| left; positive]; assert (x ^ 5 <= w ^ 5) by (apply pow_incr; lra); lra.
