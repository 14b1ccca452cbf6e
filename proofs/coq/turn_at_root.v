intros a b e D_1 D_2 D_3 A B G_3 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12.
assert (0 < sin e) by (apply sin_gt_0; lra); assert (0 < cos e) by (apply cos_gt_0; lra).
rewrite (Rplus_comm (sqrt (b * / a * ((-1) * cos e ^ 2 + 1) + 1)) (cos e)) in *.
rewrite (Rmult_comm (sqrt (b * / (a + b))) (cos e)).
apply claim_turn_by_cosine; try assumption; try lra; pose proof (sin_square e); nra.
