intros a b x G_1 G_2 G_3 G_4 G_5 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12.
assert (0 < / a) by positive; assert (0 < / (a + b)) by positive.
set (m := sqrt (b * / (a + b))) in *; set (r := sqrt (b * / a)) in *.
assert (M : m ^ 2 = b * / (a + b)) by (apply pow2_sqrt; lra).
assert (R2 : r ^ 2 = b * / a) by (apply pow2_sqrt; lra).
set (w := sqrt (b * / a * ((-1) * x ^ 2 + 1) + 1)) in *.
assert (W : w ^ 2 = b * / a * ((-1) * x ^ 2 + 1) + 1) by (apply pow2_sqrt; lra).
assert (P : 0 < w) by (apply sqrt_lt_R0; assert (0 <= b * / a * ((-1) * x ^ 2 + 1)) by (apply Rmult_le_pos; nra); lra).
assert (0 < m) by (apply sqrt_lt_R0; positive); assert (0 < r) by (apply sqrt_lt_R0; positive).
assert (M1 : m < 1).
{ assert (b * / (a + b) < 1); [| nra].
  apply (Rmult_lt_reg_r (a + b)); [lra |]; rewrite Rmult_assoc, Rinv_l; lra. }
assert (V : forall t u, 0 <= t -> t ^ 2 = 1 - u ^ 2 -> -1 <= u <= 1 -> cos (asin u) = t).
{ intros t u T E B; rewrite cos_asin by exact B; apply sqrt_unique; [exact T | rewrite E; unfold Rsqr; ring]. }
set (v := m * / r).
assert (V0 : 0 < v) by (unfold v; positive).
assert (V2 : v ^ 2 = a * / (a + b)).
{ unfold v; rewrite Rpow_mult_distr, pow_inv, M, R2; field; repeat split; lra. }
assert (A : asin (x * m) < asin m).
{ apply asin_rises; nra. }
assert (A0 : 0 < asin (x * m)) by (apply asin_above; positive).
pose proof (asin_bound m); pose proof (asin_bound (x * m)).
enough (E : asin (r * / (x + w) * ((-1) * x ^ 2 + 1)) = asin m - asin (x * m)) by lra.
apply asin_unique; [lra |]; rewrite sin_minus, !sin_asin by nra.
rewrite (V v m), (V (v * w) (x * m)).
- unfold v; replace (m * (m * / r * w) - m * / r * (x * m)) with (m ^ 2 * / r * (w - x)) by ring.
  apply (Rmult_eq_reg_r (r * (x + w))); [| apply Rgt_not_eq; positive].
  replace (m ^ 2 * / r * (w - x) * (r * (x + w))) with (m ^ 2 * (w ^ 2 - x ^ 2)) by (field; lra).
  replace (r * / (x + w) * ((-1) * x ^ 2 + 1) * (r * (x + w))) with (r ^ 2 * (1 - x ^ 2)) by (field; lra).
  rewrite M, W, R2; field; lra.
- apply Rmult_le_pos; lra.
- rewrite !Rpow_mult_distr, V2, W, M; field; lra.
- nra.
- lra.
- rewrite V2, M; field; lra.
- lra.
