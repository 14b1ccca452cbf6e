intros; pose proof (share_below a b epsilon0 ltac:(lra) ltac:(lra)) as S.
rewrite (asin_by_atan _ S); symmetry; f_equal; f_equal.
set (c := cos epsilon0) in *; pose proof (sin_square epsilon0) as Q; fold c in Q.
set (m := sqrt (b * / (a + b))) in *; set (r := sqrt (b * / a)).
assert (0 < / a) by (apply Rinv_0_lt_compat; lra).
assert (0 < / (a + b)) by (apply Rinv_0_lt_compat; lra).
assert (M : m ^ 2 = b * / (a + b)) by (apply pow2_sqrt; apply Rmult_le_pos; lra).
assert (R2 : r ^ 2 = b * / a) by (apply pow2_sqrt; apply Rmult_le_pos; lra).
assert (0 <= m) by apply sqrt_pos; assert (0 <= r) by apply sqrt_pos.
assert (P : 0 < 1 - m * c * (m * c)) by nra.
assert (P1 : 0 < b * / a * sin epsilon0 ^ 2 + 1).
{ pose proof (pow2_ge_0 (sin epsilon0)); assert (0 < b * / a) by (apply Rmult_lt_0_compat; lra); nra. }
set (v := sqrt (1 - m * c * (m * c))); set (w := sqrt (_ + 1)).
assert (0 < v) by (apply sqrt_lt_R0; exact P); assert (0 < w) by (apply sqrt_lt_R0; exact P1).
assert (V : v ^ 2 = 1 - m * c * (m * c)) by (apply pow2_sqrt; lra).
assert (W : w ^ 2 = b * / a * sin epsilon0 ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (E : r * v = m * w).
{ apply same_square; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra |].
  rewrite !Rpow_mult_distr, V, W, R2, Q.
  replace (m * c * (m * c)) with (m ^ 2 * c ^ 2) by ring; rewrite M; field; lra. }
apply (Rmult_eq_reg_r (v * w)); [| apply Rgt_not_eq, Rmult_lt_0_compat; lra].
replace (r * / w * c * (v * w)) with (r * v * c) by (field; lra).
rewrite E; field; lra.
