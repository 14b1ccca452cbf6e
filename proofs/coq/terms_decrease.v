intros a b e s D _ _ _ A B B1 AB _ _ _ N1 N2.
assert (I : 0 < / a) by positive; assert (J : a * / a = 1) by (field; lra).
assert (R0 : 0 < b * / a <= 4) by (split; [positive | apply (Rmult_le_reg_r a); nra]).
assert (K : 1 / 2 <= sqrt (a * b)) by (apply below_sqrt; lra).
pose proof (product_root a b A B) as KR.
assert (T0 : 0 < atan (sqrt (b * / a))) by (apply atan_above, sqrt_lt_R0; lra); pose proof pi_between as P.
assert (S2 : s ^ 2 = 4 * / (1 + b * / a) * exp ((-2) * sqrt (a * b) * (PI + atan (sqrt (b * / a))))).
{ pose proof (turn_of_share a b 0 A B) as T; rewrite cos_0, sin_0, !Rmult_1_r in T.
  replace (b * / a * 0 ^ 2 + 1) with 1 in T by ring; rewrite sqrt_1 in T.
  replace (sqrt (b * / a) * / 1) with (sqrt (b * / a)) in T by field.
  rewrite D, T, !Rpow_mult_distr, (pow2_sqrt (a * / (a + b))) by (left; positive).
  replace (exp ((-2) * sqrt (a * b) * (PI + atan (sqrt (b * / a)))))
    with (exp ((-1) * sqrt (a * b) * (PI + atan (sqrt (b * / a)))) ^ 2)
    by (simpl; rewrite Rmult_1_r, <- exp_plus; f_equal; ring).
  field; lra. }
replace (9 * b * / a + 4) with (9 * (b * / a) + 4) in * by ring.
replace ((9 / 4) * b * / a + 1) with ((9 / 4) * (b * / a) + 1) by ring.
replace ((-1) * b * / a * (sinh (2 * sqrt (/ (9 * (b * / a) + 4)))) ^ 2 + 1)
  with (1 - (b * / a) * (sinh (2 * sqrt (/ (9 * (b * / a) + 4)))) ^ 2) in * by ring.
set (k := sqrt (a * b)) in *; clearbody k; set (r := b * / a) in *; clearbody r.
set (t := PI + atan (sqrt r)) in *; set (z := 2 * sqrt (/ (9 * r + 4))) in *.
assert (Z : 31 / 100 <= z <= 11 / 10) by (unfold z; split; interval).
assert (S : 0 < sinh z) by (apply sinh_pos; lra); assert (T : 0 < sin z) by (apply sin_gt_0; lra).
assert (W : 0 < sqrt (1 - r * sinh z ^ 2)) by (apply sqrt_lt_R0; exact N2).
set (g := sqrt (/ (9 * r + 4)) * / sqrt (1 - r * sinh z ^ 2) * / sin z).
assert (G0 : 0 < g).
{ assert (0 < sqrt (/ (9 * r + 4))) by (apply sqrt_lt_R0; positive); unfold g; positive. }
assert (S3 : 0 < sinh z ^ 2) by nra; assert (Q0 : 0 <= sqrt r) by apply sqrt_pos.
assert (G : g * (sqrt r * sinh z ^ 2) <= 3) by (unfold g, z, sinh; clear - R0; interval with (i_bisect r)).
split.
- rewrite S2; replace (z * / sqrt (1 - r * sinh z ^ 2) * / sin z * (b * sinh z ^ 2 + 1) + -1)
    with (2 * (g * (b * sinh z ^ 2 + 1)) + -1) by (unfold g, z; ring).
  match goal with |- 4 * / (1 + r) * exp ?x * ?c * exp ?y < _ => replace (4 * / (1 + r) * exp x * c * exp y)
    with (4 * / (1 + r) * c * exp (x + y)) by (rewrite exp_plus; ring) end.
  apply Rle_lt_trans with (4 * / (1 + r) * (9 / 4 * r + 1) * exp (- t + (2 * (g * (sqrt r / 2 * sinh z ^ 2 + 1)) + -1))).
  + apply Rmult_le_compat_l; [assert (0 < / (1 + r)) by (apply Rinv_0_lt_compat; lra); nra |].
    apply exp_rises; rewrite <- KR; assert (3 <= t) by (unfold t; lra).
    assert (0 <= (2 * k - 1) * (t - g * (sqrt r * sinh z ^ 2))) by (apply Rmult_le_pos; lra); nra.
  + unfold g, t, z, sinh; clear - R0; interval with (i_bisect r).
- replace (sqrt (/ (9 * r + 4)) * / sqrt (1 - r * sinh z ^ 2) * / sin z * (b * sinh z ^ 2 + 1)) with (g * (b * sinh z ^ 2 + 1))
    by (unfold g; ring).
  apply Rle_lt_trans with (exp (g * (1 * sinh z ^ 2 + 1) + -1 / 2)).
  + apply exp_rises, Rplus_le_compat_r, Rmult_le_compat_l; [lra | nra].
  + unfold g, z, sinh; clear - R0; interval with (i_bisect r).
