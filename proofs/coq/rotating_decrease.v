intros a b c e x g D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6.
pose proof (claim_rotating_falls_in_defect v1 a b e g E_1 A B G_3 G_4 G_5 G_6).
pose proof (claim_rotating_falls_in_gamma v2 a b e g E_2 A B G_3 G_4 G_5 G_6).
assert (/ v1 < 0) by (apply Rinv_lt_0_compat; assumption); rewrite E; nra.
