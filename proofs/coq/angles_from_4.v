intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8; pose proof PI_RGT_0.
assert (Q2 : sqrt (b * / a + 1) ^ 2 = b * / a + 1) by (apply pow2_sqrt; lra).
assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; exact N_3).
assert (R0 : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; positive).
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (T : 0 < P * sqrt (a * b)).
{ pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)); apply Rmult_lt_0_compat; lra. }
pose proof (increasing_tanh 0 (4 * sqrt (a * b)) ltac:(positive)) as U; rewrite tanh_0 in U.
assert (V : 0 < sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b))))).
{ assert (0 < atan (sqrt (b * / a) * tanh (4 * sqrt (a * b)))) by (apply atan_above; positive); positive. }
pose proof (sinh_lt 0 _ T) as S; rewrite sinh_0 in S; pose proof (sinh_lt 0 _ V) as X; rewrite sinh_0 in X.
set (q := sqrt (b * / a + 1)) in *; set (t := sinh (P * sqrt (a * b))) in *; set (u := sinh (sqrt (a * b) * _)) in *.
replace (/ (b * / a + 1) * / t * / u + 1) with (/ q * / u * (/ q * / t) + 1) in *
  by (rewrite <- Q2; field; repeat split; lra).
rewrite <- (claim_difference_of_turns (/ q * / u) (/ q * / t)); [do 2 f_equal; ring | | | exact N_7];
  apply Rlt_gt; positive.
