intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2 N_3 N_4 N_5.
assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; exact N_3).
assert (T : 0 < P * sqrt (a * b)).
{ pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)); pose proof PI_RGT_0.
  apply Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; positive]. }
pose proof (sinh_lt 0 _ T) as S; rewrite sinh_0 in S.
rewrite <- (claim_angle_and_cotangent (sqrt (b * / a + 1) * sinh (P * sqrt (a * b)))).
- f_equal; field; split; lra.
- apply Rlt_gt; positive.
- apply Rgt_not_eq; positive.
