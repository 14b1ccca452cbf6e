intros a b e D_1 D_2 D_3 A B G_3 N_1 N_2 N_3 N_4.
replace (sin e ^ 2) with ((-1) * cos e ^ 2 + 1) by (rewrite sin_square; ring).
intros; apply (claim_turn_at_root a b e); try assumption.
