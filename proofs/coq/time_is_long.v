intros a b e D E F A B B1 L N1 N2 N3 N4 N5 N6; pose proof PI_RGT_0.
assert (K : 0 < a * b) by positive; assert (S : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact K).
pose proof (claim_phase_by_defect _ a b e eq_refl D E F A B B1 N5 N6 N4 K) as P.
pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)).
assert (J : 1 / 2 <= sqrt (a * b)) by (apply below_sqrt; lra).
set (p := PI + asin (sqrt (b * / (a + b)) * cos e)) in *; set (s := arcsinh _) in *.
assert (Q : s = sqrt (a * b) * p) by (rewrite P; field; lra).
rewrite Q; replace (1 / 2 * PI + 1 / 2 * asin (sqrt (b * / (a + b)) * cos e)) with (1 / 2 * p) by (unfold p; field).
apply Rmult_le_compat_r; [unfold p; lra | exact J].
