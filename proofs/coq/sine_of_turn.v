intros a b e G_1 G_2 G_3 G_4 G_5 S C N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10.
pose proof (sin_square e) as Q; set (s := sin e) in *; set (c := cos e) in *.
assert (0 < / a) by positive; assert (0 < / (a + b)) by positive.
set (m := sqrt (b * / (a + b))) in *; set (r := sqrt (b * / a)) in *.
assert (M : m ^ 2 = b * / (a + b)) by (apply pow2_sqrt; lra).
assert (R2 : r ^ 2 = b * / a) by (apply pow2_sqrt; lra).
set (w := sqrt (b * / a * s ^ 2 + 1)) in *.
assert (W : w ^ 2 = b * / a * s ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (P : 0 < w) by (apply sqrt_lt_R0; assert (0 < b * / a) by positive; nra).
assert (0 < m) by (apply sqrt_lt_R0; positive); assert (0 < r) by (apply sqrt_lt_R0; positive).
(* the root of the share's complement *)
assert (V : forall t u, 0 <= t -> t ^ 2 = 1 - (m * u) ^ 2 -> -1 <= m * u <= 1 -> cos (asin (m * u)) = t).
{ intros t u T E B; rewrite cos_asin by exact B; apply sqrt_unique; [exact T | rewrite E; unfold Rsqr; ring]. }
set (v := m * / r).
assert (V0 : 0 < v) by (unfold v; positive).
assert (V2 : v ^ 2 = a * / (a + b)).
{ unfold v; rewrite Rpow_mult_distr, pow_inv, M, R2; field; repeat split; lra. }
assert (I : forall u, v ^ 2 * (b * / a * (1 - u ^ 2) + 1) = 1 - (m * u) ^ 2).
{ intros u; rewrite Rpow_mult_distr, M, V2; field; lra. }
replace ((-1) * asin (m * c) + asin m) with (asin (m * 1) - asin (m * c)) by (rewrite Rmult_1_r; ring).
rewrite sin_minus, !sin_asin by lra.
rewrite (V v 1), (V (v * w) c).
- rewrite Rmult_1_r; unfold v; replace (m * (m * / r * w) - m * / r * (m * c)) with (m ^ 2 * / r * (w - c)) by ring.
  apply (Rmult_eq_reg_r (r * (w + c))); [| apply Rgt_not_eq; positive].
  replace (m ^ 2 * / r * (w - c) * (r * (w + c))) with (m ^ 2 * (w ^ 2 - c ^ 2)) by (field; lra).
  replace (r * / (w + c) * s ^ 2 * (r * (w + c))) with (r ^ 2 * s ^ 2) by (field; lra).
  rewrite M, W, R2, Q; field; lra.
- apply Rmult_le_pos; lra.
- rewrite Rpow_mult_distr, W, Q; apply I.
- lra.
- lra.
- rewrite <- I; replace (1 - 1 ^ 2) with 0 by ring; lra.
- lra.
