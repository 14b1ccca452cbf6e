intros a b e A B G_3 G_4 G_5 S C N_1 N_2 N_3 N_4.
replace (sin e ^ 2) with ((-1) * cos e ^ 2 + 1) by (rewrite sin_square; ring).
intros; apply (claim_turn_at a b e); try assumption.
