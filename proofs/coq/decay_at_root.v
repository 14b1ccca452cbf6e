intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2 N_3 N_4 N_5; rewrite <- D_1 in D_2.
replace ((-1) * P * sqrt (a * b)) with (- (sqrt (a * b) * P)) by ring.
apply decay; try assumption; [apply sin_gt_0 | apply cos_gt_0]; lra.
