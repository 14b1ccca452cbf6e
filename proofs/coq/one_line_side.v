intros a b e p Dp D E F A B B1.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive); pose proof PI_RGT_0.
assert (R : 0 < b * / a) by positive.
set (P := PI + asin (sqrt (b * / (a + b)) * cos e)).
pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)).
assert (Q : P = PI + asin (sqrt (b * / (a + b)) * cos e)) by reflexivity.
assert (W : PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))) < P).
{ apply (claim_swept_phase_below P a b e Q D E F A B B1); try lra; positive. }
set (w := PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b)))) in *.
assert (T : 0 < w).
{ pose proof (atan_bound (sqrt (b * / a) * tanh (PI * sqrt (a * b)))); unfold w; lra. }
assert (Z : forall x, 0 < x -> 0 < sinh x) by (intros x X; rewrite <- sinh_0; apply sinh_lt; exact X).
pose proof (Z (sqrt (a * b) * w) ltac:(nra)); pose proof (Z (P * sqrt (a * b)) ltac:(nra)).
rewrite (claim_defect_by_phase P a b e D E F Q A B B1) by (first [lra | positive]).
rewrite Dp; apply Rlt_gt, atan_increasing, Rmult_lt_compat_l; [positive |].
apply Rinv_lt_contravar; [positive |]; apply sinh_lt; nra.
