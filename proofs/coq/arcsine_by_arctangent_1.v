intros; pose proof (share_below a b 0 ltac:(lra) ltac:(lra)) as S; rewrite cos_0, Rmult_1_r in S.
rewrite (asin_by_atan _ S); f_equal.
assert (0 < / a) by (apply Rinv_0_lt_compat; lra).
assert (0 < / (a + b)) by (apply Rinv_0_lt_compat; lra).
set (m := sqrt (b * / (a + b))) in *.
assert (M : m ^ 2 = b * / (a + b)) by (apply pow2_sqrt; apply Rmult_le_pos; lra).
assert (P : 0 < 1 - m * m) by nra.
assert (0 < sqrt (1 - m * m)) by (apply sqrt_lt_R0; exact P).
symmetry; apply sqrt_unique.
- apply Rmult_le_pos; [apply sqrt_pos | left; apply Rinv_0_lt_compat; lra].
- unfold Rdiv; rewrite Rpow_mult_distr, pow_inv, pow2_sqrt by lra.
  replace (m * m) with (b * / (a + b)) by (rewrite <- M; ring); rewrite M; field; lra.
