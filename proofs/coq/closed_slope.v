intros F0 S a b e g u x D_1 [v1 [v2 [E_1 [E_2 E]]]] D_3 D_4 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11.
rewrite E, <- (is_derive_unique _ _ _ E_2), (is_derive_unique _ _ _ (claim_slope_of_turn S a b e A B G_3 G_5 G_6 G_7 G_8 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9)).
assert (0 < Rabs (sin e)) by (rewrite Rabs_pos_eq; lra); pose proof (reach a b A B e).
rewrite (claim_slope_by_end_at_zero S a b e v1 E_1 A B G_3 G_4 G_5 G_6 G_7 G_8) by lra.
rewrite (Rabs_pos_eq (sin e)) by lra.
assert (0 < sqrt b) by (apply sqrt_lt_R0; exact B).
assert (0 < sqrt (a + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact N_7).
pose proof (forward b B e G_4).
set (l := ln _); set (m := ln _); field; repeat split; lra.
