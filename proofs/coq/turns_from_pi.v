intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2 N_3 N_4; pose proof PI_RGT_0.
assert (R2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; exact N_2).
assert (R0 : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; positive).
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (T : 0 < P * sqrt (a * b)).
{ pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)); apply Rmult_lt_0_compat; lra. }
pose proof (increasing_tanh 0 _ T) as S; rewrite tanh_0 in S.
pose proof (increasing_tanh 0 (PI * sqrt (a * b)) ltac:(positive)) as U; rewrite tanh_0 in U.
set (r := sqrt (b * / a)) in *; set (t := tanh (P * sqrt (a * b))) in *; set (u := tanh (PI * sqrt (a * b))) in *.
replace (b * / a * u * t + 1) with (r * t * (r * u) + 1) in * by (rewrite <- R2; ring).
rewrite <- (claim_difference_of_turns (r * t) (r * u)); [do 2 f_equal; ring | | | exact N_4]; apply Rlt_gt; positive.
