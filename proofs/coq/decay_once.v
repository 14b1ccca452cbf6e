intros a b e D_1 D_2 D_3 A B G_3 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9.
replace ((-1) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  with (- (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))) by ring.
apply decay; try assumption; [apply sin_gt_0 | apply cos_gt_0]; lra.
