intros a b epsilon G_1 G_2 G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12 N_13 N_14 N_15.
pose proof (sin_square epsilon) as Q; rewrite arcsinh_law.
set (s := sin epsilon) in *; set (c := cos epsilon) in *.
set (R1 := sqrt (b * / a * s ^ 2 + 1)) in *; set (m := sqrt (a * / (a + b))) in *.
assert (A0 : 0 < b * / a) by positive.
assert (R2 : R1 ^ 2 = b * / a * s ^ 2 + 1) by (apply pow2_sqrt; exact N_2).
assert (R3 : 0 < R1) by (apply sqrt_lt_R0; nra).
assert (M2 : m ^ 2 = a * / (a + b)) by (apply pow2_sqrt; exact N_15).
assert (M : 0 < m) by (apply sqrt_lt_R0; exact N_14).
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
set (k := sqrt (a * b)) in *; set (mu := sqrt (b * / (a + b))) in *.
assert (T : 0 < k * (PI + asin (mu * c))).
{ pose proof (asin_bound (mu * c)); pose proof PI_RGT_0; apply Rmult_lt_0_compat; lra. }
assert (Z : s ^ 2 = m ^ 2 * (R1 ^ 2 - c ^ 2)) by (rewrite M2, R2, Q; field; lra).
replace (1 / 2 * epsilon * / m * exp (k * (PI + asin mu)))
  with (/ 2 * (epsilon * (/ m * exp (k * (PI + asin mu))))) by (field; lra).
replace (1 / 2 * R1 + 1 / 2 * c) with (/ 2 * (R1 + c)) by field.
pose proof (exp_pos (k * (PI + asin mu))) as X.
assert (I : 0 < / m) by positive.
assert (J : 0 < / s) by positive.
rewrite (ln_mult (/ 2) (epsilon * _)), (ln_mult epsilon (/ m * _)), (ln_mult (/ m)), ln_exp,
  (ln_mult epsilon (/ s)), (ln_mult (/ 2) (R1 + c)), !ln_Rinv by (first [lra | positive]).
clear X I J; set (t := k * (PI + asin (mu * c))) in *.
set (w := m * (R1 + c) * / s).
assert (W : 0 < w) by (unfold w; positive).
assert (L : ln w = ln m + ln (R1 + c) - ln s).
{ unfold w; rewrite !ln_mult, ln_Rinv by positive; ring. }
assert (V : w - / w = 2 * (m * c * / s)).
{ assert (E : / w = m * (R1 - c) * / s); [| rewrite E; unfold w; ring].
  apply (Rmult_eq_reg_l w); [| lra]; rewrite Rinv_r by lra; unfold w.
  replace (m * (R1 + c) * / s * (m * (R1 - c) * / s)) with (m ^ 2 * (R1 ^ 2 - c ^ 2) * / (s ^ 2))
    by (field; lra).
  rewrite <- Z; field; lra. }
assert (C : m * / s * c + sqrt ((m * / s * c) ^ 2 + 1) = w).
{ assert (E : sqrt ((m * / s * c) ^ 2 + 1) = m * R1 * / s); [| rewrite E; unfold w; ring].
  apply sqrt_unique; [left; positive |].
  replace ((m * / s * c) ^ 2 + 1) with ((m ^ 2 * c ^ 2 + s ^ 2) * / (s ^ 2)) by (field; lra).
  replace (m ^ 2 * c ^ 2 + s ^ 2) with (m ^ 2 * R1 ^ 2) by (rewrite Z; ring); field; lra. }
rewrite C, L; unfold t; ring.
