intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2 N_3 N_4; rewrite <- D_1 in D_2.
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
rewrite (inverse_root a b A B), <- (sinh_at_root a b _ e A B S C D_2), arcsinh_sinh.
assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact N_4); field; lra.
