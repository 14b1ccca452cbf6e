intros F0 S a b e x D_1 [v1 [v2 [E_1 [E_2 E]]]] A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 N_1 N_2 N_3 N_4.
assert (0 < Rabs (sin e)) by (rewrite Rabs_pos_eq; lra).
assert (0 < sqrt b) by (apply sqrt_lt_R0; exact B); pose proof (reach a b A B e).
assert (0 < sqrt (a + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
rewrite E, (claim_excess_by_value S a b e v2 E_2 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9).
rewrite (claim_excess_by_end S a b e v1 E_1 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9) by lra.
field; repeat split; lra.
