intros a b A B G; pose proof PI_RGT_0; assert (0 < b * / a) by positive.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
pose proof (increasing_tanh 0 (PI * sqrt (a * b)) ltac:(positive)) as U; rewrite tanh_0 in U.
assert (V : 0 < sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))))).
{ assert (0 < sqrt (b * / a)) by (apply sqrt_lt_R0; assumption).
  assert (0 < atan (sqrt (b * / a) * tanh (PI * sqrt (a * b)))) by (apply atan_above; positive); positive. }
pose proof (sinh_lt 0 _ V) as X; rewrite sinh_0 in X; assert (0 < a * b) by positive.
repeat (split; [lra |]); eexists; reflexivity.
