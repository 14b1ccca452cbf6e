intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2; rewrite <- D_1 in D_2.
assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
replace (b * / sqrt (a * b)) with (sqrt (b * / a)) by (rewrite <- (product_root a b A B) at 2; field; lra).
rewrite (Rmult_comm P), D_2, <- (turn_of_share a b e A B), D_1; ring.
