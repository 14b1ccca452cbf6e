intros a A _; assert (I : 0 < / (a + 1)) by positive; assert (J : / (a + 1) <= / 8) by (apply Rinv_le_contravar; lra).
assert (M : / 100 <= 2 * atan (exp ((-1) * PI)) <= / 10) by (split; interval).
pose proof PI_RGT_0; assert (P : 3 < PI) by interval.
repeat split; try lra; [apply sin_gt_0 | apply cos_gt_0]; lra.
