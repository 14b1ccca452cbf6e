intros; f_equal; pose proof PI_RGT_0.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; apply Rmult_lt_0_compat; lra).
assert (X : 0 < v_P * sqrt (a * b)) by (apply Rmult_lt_0_compat; lra).
set (x := v_P * sqrt (a * b)) in *; assert (S : 0 < sinh x) by (rewrite <- sinh_0; apply sinh_lt; lra).
pose proof (cosh_pos x) as C; pose proof (cosh_sinh x) as D.
assert (E : sqrt ((-1) * tanh x ^ 2 + 1) = / cosh x).
{ apply sqrt_unique; [left; apply Rinv_0_lt_compat; lra |].
  unfold tanh; set (s := sinh x) in *; set (c := cosh x) in *.
  replace ((-1) * (s / c) ^ 2 + 1) with ((c * c - s * s) / c ^ 2) by (field; lra).
  rewrite D; field; lra. }
rewrite E; unfold tanh; assert (0 < sqrt (b * / a + 1)).
{ apply sqrt_lt_R0; assert (0 < b * / a); [| lra].
  apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]. }
field; repeat split; lra.
