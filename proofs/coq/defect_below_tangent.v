intros a b e D E F A B B1 S.
apply claim_angle_below_tangent; try assumption; [apply sin_gt_0 | apply cos_gt_0]; lra.
