intros p q a b e D E E0 E1 D2 A B B1 _ _ _ N.
assert (Q3 : q > 3) by (apply (claim_newton_pi_goes_on q a b e); assumption).
assert (P3 : 3 < p).
{ pose proof pi_between; assert (0 < asin (sqrt (b * / (a + b)) * cos e)); [| lra].
  apply asin_above, Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | apply cos_gt_0; lra]. }
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (R0 : 0 < b * / a) by positive; assert (W : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
assert (W2 : sqrt (b * / a + 1) ^ 2 = b * / a + 1) by (apply pow2_sqrt; lra).
pose proof (sinh_pos (p * sqrt (a * b)) ltac:(nra)) as S; pose proof (sinh_pos (q * sqrt (a * b)) ltac:(nra)) as T.
set (w := sqrt (b * / a + 1)) in *; rewrite <- W2 in *; set (s := sinh (p * _)) in *; set (t := sinh (q * _)) in *.
apply atan_difference; [positive | positive |].
replace (1 + w * s * (w * t)) with (w ^ 2 * s * t + 1) by ring; ring.
