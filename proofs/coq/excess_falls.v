intros S a b e F D A B G_3 G_4 G_5 G_6 G_7 G_8 G_9; pose proof (reach a b A B e).
rewrite (claim_excess_by_end S a b e F D A B G_3 G_4 G_5 G_6 G_7 G_8 G_9) by (first [lra | rewrite Rabs_pos_eq; lra]).
assert (0 < Rabs (sin e)) by (rewrite Rabs_pos_eq; lra); pose proof (forward b B e G_4).
assert (0 < S * / sqrt b * / sqrt (a + b * sin e ^ 2) * / Rabs (sin e) * ((-1) * b * sin e ^ 2 + 1)) by positive.
lra.
