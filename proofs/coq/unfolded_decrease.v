intros a b c x y g D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6 G_7 G_8.
pose proof (claim_phase_rises_in_time v1 a b x g E_1 A B G_3 G_4 G_5 G_6 G_7 G_8).
pose proof (claim_phase_rises_in_gamma v2 a b x g E_2 A B G_3 G_4 G_5 G_6 G_7 G_8).
assert (0 < / v1) by (apply Rinv_0_lt_compat; lra); rewrite E; nra.
