intros F0 S a b e u x D_1 D_2 D_3 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 N.
assert (0 < Rabs (sin e)) by (rewrite Rabs_pos_eq; lra).
assert (0 < sqrt b) by (apply sqrt_lt_R0; exact B); pose proof (reach a b A B e).
assert (0 < sqrt (a + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
pose proof (forward b B e G_4).
rewrite (claim_defect_by_turn F0 S a b e x D_1 D_2 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9) by lra.
rewrite (claim_slope_by_end_at_zero S a b e u D_3 A B G_3 G_4 G_5 G_6 G_7 G_8) by lra.
field; repeat split; lra.
