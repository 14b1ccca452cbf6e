intros a b e s D E F Ds A B B1; pose proof PI_RGT_0.
assert (C : 0 < cos (1 / 2 * e)) by (apply cos_gt_0; lra).
pose proof (claim_half_tangent_above a b e s D E F Ds A B B1 ltac:(lra)) as T.
rewrite <- (atan_tan (1 / 2 * e)) by lra; apply Rlt_gt, atan_increasing; lra.
