intros a b e D P Q A B B1 AB B2; intros; destruct (slope_within a b e A B P Q D B1 AB) as [s [v [V [E [[_ U] L]]]]].
specialize (L ltac:(lra)).
match goal with |- ?x > _ /\ _ => change (slope_rest_of a b e > 3 / 8 * e * / b * sqrt (a * b) /\ slope_rest_of a b e < 63 / 20 * e * / b * sqrt (a * b)) end.
assert (K : 0 < e * sqrt (a * b)) by (apply Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; positive]).
assert (F : slope_rest_of a b e = e * sqrt (a * b) * s * / (4 * b * v)) by (rewrite <- E; field; lra).
assert (M : 0 < / (4 * b * v)) by (apply Rinv_0_lt_compat; positive).
replace (63 / 20 * e * / b * sqrt (a * b)) with (e * sqrt (a * b) * (63 / 5 * v) * / (4 * b * v)) by (field; lra).
replace (3 / 8 * e * / b * sqrt (a * b)) with (e * sqrt (a * b) * (3 / 2 * v) * / (4 * b * v)) by (field; lra).
rewrite F; split; apply Rmult_lt_compat_r; try assumption; apply Rmult_lt_compat_l; lra.
