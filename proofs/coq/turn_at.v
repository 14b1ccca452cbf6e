intros a b e A B G_3 G_4 G_5 S C N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12.
rewrite (Rplus_comm (sqrt (b * / a * ((-1) * cos e ^ 2 + 1) + 1)) (cos e)) in *.
rewrite (Rmult_comm (sqrt (b * / (a + b))) (cos e)).
apply claim_turn_by_cosine; try assumption; try lra; pose proof (sin_square e); nra.
