intros a b e E E0 E1 A B B1 AB _ _ _ _ _ _ _ _; pose proof pi_between as P.
pose proof (leading_of_defect a b e A B E0 ltac:(lra) E) as D.
destruct (defect_small a b e A B B1 ltac:(lra) E0 ltac:(lra) E) as [E2 U].
assert (R0 : 0 < b * / a) by positive; assert (K0 : 0 < a * b) by positive.
assert (R4 : b * / a <= 4).
{ apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; nra. }
assert (X : exponent a b e <= 16 / 10 * e ^ 2 - 0 * e ^ 4).
{ apply (slope_below a b 1 4 (16 / 10) 0 e (21 / 100)); try lra; [nra |].
  intros v V; unfold slope_rest, sine_top; interval with (i_bisect v). }
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
pose proof (product_root a b A B) as KR; assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact K0).
assert (Q : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; exact R0).
assert (Q2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; lra).
pose proof (turn_of_share a b 0 A B) as T; rewrite cos_0, sin_0, !Rmult_1_r in T.
replace (b * / a * 0 ^ 2 + 1) with 1 in T by ring; rewrite sqrt_1 in T.
replace (sqrt (b * / a) * / 1) with (sqrt (b * / a)) in T by field; rewrite T in D; clear T.
set (k := sqrt (a * b)) in *; set (r := sqrt (b * / a)) in *; set (x := exponent a b e) in *.
pose proof (printed_turn r Q) as F; rewrite Q2 in F.
assert (W : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
replace (1 + b * / a) with (b * / a + 1) in F by ring; set (w := sqrt (b * / a + 1)) in *.
replace (ln _) with (k * atan r - b * / w - x).
2: { rewrite <- (ln_exp (k * atan r - b * / w - x)); f_equal; unfold Rminus; rewrite !exp_plus.
  replace (k * atan r) with (k * (PI + atan r) + (-1) * PI * k) by ring; rewrite exp_plus.
  replace (- (b * / w)) with ((-1) * b * / w) by ring; replace (- x) with ((-1) * x) by ring.
  assert (Y : exp ((-1) * x) = 2 * / e * sqrt (a * / (a + b)) * exp ((-1) * k * (PI + atan r)))
    by (apply (Rmult_eq_reg_l e); [rewrite <- D; field; lra | lra]).
  rewrite Y; replace ((-1) * k * (PI + atan r)) with (- (k * (PI + atan r))) by ring; rewrite exp_Ropp.
  pose proof (exp_pos (k * (PI + atan r))); field; lra. }
assert (G : 0 <= k * atan r - b * / w <= b ^ 2 * / a / 6).
{ replace (k * atan r - b * / w) with (k * (atan r - r * / w)) by (rewrite <- KR; ring).
  replace (b ^ 2 * / a / 6) with (k * (r * (b * / a) / 6)) by (replace (k * (r * (b * / a) / 6)) with (k * r * (b * / a) / 6) by (field; lra); rewrite KR; field; lra).
  split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]. }
destruct (exponent_low a b e A B R4 E0 E2) as [L L5]; fold x in L, L5.
assert (I : 0 < / a * / b) by positive; assert (J : a * b * (/ a * / b) = 1) by (field; lra).
assert (Y : b ^ 2 * / a / 6 = b ^ 3 / 6 * (/ a * / b)) by (field; lra); rewrite Y in G.
assert (V : e ^ 2 <= 51 / 1000 * (/ a * / b)).
{ apply (Rmult_le_reg_r (a * b)); [exact K0 |]; replace (51 / 1000 * (/ a * / b) * (a * b)) with (51 / 1000) by (field; lra); exact U. }
replace (17 / 100 * / a * / b) with (17 / 100 * (/ a * / b)) by ring; set (j := / a * / b) in *; clearbody j.
apply Rabs_le; split; [lra |].
destruct (Rle_or_lt (1 / 2) b) as [H|H].
- specialize (L5 H); assert (b ^ 3 <= 1) by (apply pow_below; lra); nra.
- assert (b ^ 3 <= 1 / 8) by (replace (1 / 8) with ((1 / 2) ^ 3) by field; apply pow_incr; lra); nra.
