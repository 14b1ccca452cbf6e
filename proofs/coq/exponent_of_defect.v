intros a b e A B G_3 G_4 G_5 S C; pose proof (root_above a b e A B) as W; unfold root_of in W.
assert (T : 0 < b * / a) by positive; pose proof (root_square a b e A B) as V; unfold root_of in V.
assert (R2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; lra).
assert (R0 : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; lra).
set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *; set (r := sqrt (b * / a)) in *.
assert (U : 0 <= r * / (w + cos e) * sin e ^ 2 <= 1).
{ assert (I : 0 < / (w + cos e)) by positive; split; [left; positive |].
  apply (Rmult_le_reg_r (w + cos e)); [lra |].
  replace (r * / (w + cos e) * sin e ^ 2 * (w + cos e)) with (r * sin e ^ 2) by (field; lra).
  assert (r * sin e ^ 2 <= r * sin e) by (pose proof (SIN_bound e); assert (sin e ^ 2 <= sin e) by nra; nra).
  assert (r * sin e <= w) by (apply below_sqrt; rewrite Rpow_mult_distr, R2; lra); lra. }
pose proof (pow2_ge_0 (sin e)); assert (0 <= b * / a * sin e ^ 2) by (apply Rmult_le_pos; lra).
assert (0 < e * / sin e) by positive; assert (0 < a * b) by positive.
repeat (split; [lra |]); eexists; reflexivity.
