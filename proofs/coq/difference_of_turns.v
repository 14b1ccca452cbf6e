intros x y G_1 G_2 N.
assert (C : forall t, 0 < t -> cos (atan t) <> 0).
{ intros t _; pose proof (atan_bound t); apply Rgt_not_eq, cos_gt_0; lra. }
pose proof (atan_bound x); pose proof (atan_bound y).
assert (0 < atan x) by (apply atan_above; lra); assert (0 < atan y) by (apply atan_above; lra).
rewrite <- (atan_tan ((-1) * atan y + atan x)) by lra; f_equal.
replace ((-1) * atan y + atan x) with (atan x - atan y) by ring.
rewrite tan_minus, !tan_atan; [field; lra | apply C; lra | apply C; lra | | rewrite !tan_atan; nra].
apply Rgt_not_eq, cos_gt_0; lra.
