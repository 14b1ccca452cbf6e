intros a b e D P Q A B B1 AB; intros; destruct (slope_within a b e A B P Q D B1 AB) as [s [v [V [E [[L U] _]]]]].
match goal with |- Rabs ?x <= _ => change (Rabs (slope_rest_of a b e) <= 63 / 20 * e * / b * sqrt (a * b)) end.
assert (K : 0 < e * sqrt (a * b)) by (apply Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; positive]).
assert (F : slope_rest_of a b e = e * sqrt (a * b) * s * / (4 * b * v)) by (rewrite <- E; field; lra).
assert (M : 0 < / (4 * b * v)) by (apply Rinv_0_lt_compat; positive).
replace (63 / 20 * e * / b * sqrt (a * b)) with (e * sqrt (a * b) * (63 / 5 * v) * / (4 * b * v)) by (field; lra).
rewrite F; apply Rabs_le; split; [rewrite Ropp_mult_distr_l |]; apply Rmult_le_compat_r; try lra;
  [rewrite Ropp_mult_distr_r |]; apply Rmult_le_compat_l; lra.
