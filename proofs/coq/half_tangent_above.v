intros a b e s D E F Ds A B B1 N1.
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
pose proof (claim_leading_positive a b s Ds A B B1) as P.
destruct (root_facts a b e A B) as [W [Q G]].
assert (R : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; positive).
assert (M : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; left; positive).
assert (V : sqrt (b * / a * sin e ^ 2 + 1) ^ 2 = b * / a * sin e ^ 2 + 1).
{ apply pow2_sqrt; assert (0 < b * / a) by positive; nra. }
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
pose proof (claim_half_tangent_everywhere a b e s D E F Ds A B B1 N1) as T.
set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *; set (r := sqrt (b * / a)) in *.
assert (I : 0 < / (w + cos e)) by positive.
set (y := r * / (w + cos e) * sin e ^ 2) in *.
assert (Y : 0 < y) by (unfold y; positive).
assert (Z : y < 1).
{ apply (Rmult_lt_reg_r (w + cos e)); [lra |].
  replace (y * (w + cos e)) with (r * sin e * sin e) by (unfold y; field; lra).
  pose proof (SIN_bound e); assert (r * sin e < w) by nra; nra. }
assert (J : 0 < asin y).
{ rewrite (asin_by_atan y) by lra; rewrite <- atan_0; apply atan_increasing, Rdiv_lt_0_compat; [exact Y |].
  apply sqrt_lt_R0; nra. }
assert (X : 1 < exp (sqrt (a * b) * asin y)).
{ rewrite <- exp_0; apply exp_increasing; nra. }
assert (N : (-1) * r * / (w + cos e) * sin e ^ 2 = - y) by (unfold y; ring).
assert (0 < b * / a) by positive; assert (0 < a * b) by positive; pose proof (pow2_ge_0 (sin e)).
rewrite T by (first [lra | rewrite N; lra | nra]).
assert (O : 1 <= / (cos e + 1) * (w + cos e)).
{ apply (Rmult_le_reg_r (cos e + 1)); [lra |]; rewrite Rmult_assoc, (Rmult_comm (w + cos e)), <- Rmult_assoc, Rinv_l by lra; lra. }
set (p := / (cos e + 1) * (w + cos e)) in *; set (x := exp (sqrt (a * b) * asin y)) in *.
replace (1 / 2 * s * / (cos e + 1) * (w + cos e) * x) with (1 / 2 * s * (p * x)) by (unfold p; ring).
assert (1 < p * x) by nra; nra.
