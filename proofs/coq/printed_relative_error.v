intros a b e E E0 E1 A B B1 AB B4 _ _ _ _ _ _; pose proof pi_between as P.
pose proof (leading_of_defect a b e A B E0 ltac:(lra) E) as D.
destruct (defect_small a b e A B B1 ltac:(lra) E0 ltac:(lra) E) as [E2 _].
pose proof (defect_smaller a b e A B B1 ltac:(lra) E0 ltac:(lra) E) as U.
assert (R0 : 0 < b * / a) by positive; assert (K0 : 0 < a * b) by positive.
assert (I : 0 < / a) by positive; assert (J : a * / a = 1) by (field; lra).
assert (R4 : b * / a <= b ^ 2 / 4) by (apply (Rmult_le_reg_r a); [lra |]; nra).
assert (B2 : b ^ 2 <= 1) by nra.
assert (X : exponent a b e <= 16 / 10 * e ^ 2 - 0 * e ^ 4).
{ apply (slope_below a b 1 4 (16 / 10) 0 e (21 / 100)); try lra; [nra |].
  intros v V; unfold slope_rest, sine_top; interval with (i_bisect v). }
destruct (exponent_low a b e A B ltac:(lra) E0 E2) as [L _].
pose proof (product_root a b A B) as KR; assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact K0).
assert (Q : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; exact R0).
assert (Q2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; lra).
pose proof (turn_of_share a b 0 A B) as T; rewrite cos_0, sin_0, !Rmult_1_r in T.
replace (b * / a * 0 ^ 2 + 1) with 1 in T by ring; rewrite sqrt_1 in T.
replace (sqrt (b * / a) * / 1) with (sqrt (b * / a)) in T by field; rewrite T in D; clear T.
assert (Y4 : sqrt (b * / a) ^ 2 <= 1 / 4) by lra.
set (k := sqrt (a * b)) in *; set (r := sqrt (b * / a)) in *; set (x := exponent a b e) in *.
pose proof (printed_turn_sharp r Q Y4) as F.
assert (W : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
replace (1 + r ^ 2) with (b * / a + 1) in F by lra; set (w := sqrt (b * / a + 1)) in *.
match goal with |- ?p + _ > _ /\ _ => replace p with (exp (k * atan r - b * / w - x)) end.
2: { unfold Rminus; rewrite !exp_plus.
  replace (k * atan r) with (k * (PI + atan r) + (-1) * PI * k) by ring; rewrite exp_plus.
  replace (- (b * / w)) with ((-1) * b * / w) by ring; replace (- x) with ((-1) * x) by ring.
  assert (Y : exp ((-1) * x) = 2 * / e * sqrt (a * / (a + b)) * exp ((-1) * k * (PI + atan r)))
    by (apply (Rmult_eq_reg_l e); [rewrite <- D; field; lra | lra]).
  rewrite Y; replace ((-1) * k * (PI + atan r)) with (- (k * (PI + atan r))) by ring; rewrite exp_Ropp.
  pose proof (exp_pos (k * (PI + atan r))); field; lra. }
set (v := b * / a * / b ^ 2); set (y := b ^ 3 * v).
assert (V : 0 < v <= 1 / 4).
{ assert (0 < / b ^ 2) by positive; unfold v; split; [positive |].
  apply (Rmult_le_reg_r (b ^ 2)); [nra |]; rewrite Rmult_assoc, Rinv_l by (apply Rgt_not_eq; nra); lra. }
assert (RV : r ^ 2 = b ^ 2 * v) by (rewrite Q2; unfold v; field; split; lra).
replace (133 / 1000 * / a * b ^ 2) with (133 / 1000 * y) by (unfold y, v; field; split; lra).
replace (21 / 125 * / a * b ^ 2) with (21 / 125 * y) by (unfold y, v; field; split; lra).
assert (B3 : 0 < b ^ 3) by (apply pow_lt; lra); assert (Y0 : 0 < y) by (unfold y; nra).
assert (H : e ^ 2 <= 6 / 100000 * (/ b ^ 3) * y).
{ replace (6 / 100000 * / b ^ 3 * y) with (6 / 100000 * v) by (unfold y; field; lra).
  apply (Rmult_le_reg_r (a * b)); [exact K0 |]; replace (6 / 100000 * v * (a * b)) with (6 / 100000) by (unfold v; field; lra); exact U. }
assert (G : forall c, k * (r ^ 3 * c) = y * c).
{ intros c; replace (k * (r ^ 3 * c)) with (k * r * r ^ 2 * c) by ring; rewrite KR, RV; unfold y; ring. }
assert (Z : k * atan r - b * / w = k * (atan r - r * / w)) by (rewrite <- KR; ring).
destruct F as [F1 F2]; apply (Rmult_le_compat_l k) in F1; [| lra]; apply (Rmult_le_compat_l k) in F2; [| lra].
rewrite G in F1, F2; rewrite <- Z in F1, F2; replace (r ^ 4) with ((r ^ 2) ^ 2) in F1 by ring; rewrite RV in F1, F2.
set (d := k * atan r - b * / w) in *; assert (J3 : 0 < / b ^ 3) by positive.
set (p := 1666 / 10000 - 173 / 1000 * (b ^ 2 * v) + 1238 / 10000 * (b ^ 2 * v) ^ 2 - 96 / 1000000 * / b ^ 3).
set (q := 16674 / 100000 - 12 / 100 * (b ^ 2 * v) + 17 / 1000000 * / b ^ 3).
assert (D1 : y * p <= d - x) by (unfold p; lra).
assert (D2 : d - x <= y * q) by (unfold q; lra).
assert (BB : 1 / 4 <= b <= 1) by lra; assert (VV : 0 <= v <= 1 / 4) by lra.
assert (P0 : 0 <= p) by (unfold p; clear - BB VV; interval with (i_bisect b, i_bisect v)).
assert (P1 : 133 / 1000 < p * (1 + b ^ 3 * v * p / 2))
  by (unfold p; clear - BB VV; interval with (i_bisect b, i_bisect v, i_depth 30)).
assert (R1 : q * (1 + b ^ 3 * v * q / 2 + (b ^ 3 * v * q) ^ 2 / 6 + (b ^ 3 * v * q) ^ 3 / 19) < 21 / 125)
  by (unfold q; clear - BB VV; interval with (i_bisect b, i_bisect v, i_depth 30)).
assert (R2 : 0 <= q <= 1) by (unfold q; clear - BB VV; split; interval with (i_bisect b, i_bisect v)).
fold y in P1, R1; assert (Y1 : y <= 1 / 4) by (unfold y; assert (b ^ 3 <= 1) by (apply pow_below; lra); nra).
split.
- assert (M : 1 + y * p + (y * p) ^ 2 / 2 <= exp (d - x)).
  { eapply Rle_trans; [| apply exp_rises, D1]; apply exp_above_square; nra. }
  nra.
- apply Rle_lt_trans with (exp (y * q) + -1); [apply exp_rises in D2; lra |].
  pose proof (exp_nearer (y * q) ltac:(nra) ltac:(nra)) as M.
  replace (y * q * (1 + y * q / 2 + (y * q) ^ 2 / 6 + (y * q) ^ 3 / 19))
    with (y * (q * (1 + y * q / 2 + (y * q) ^ 2 / 6 + (y * q) ^ 3 / 19))) in M by ring; nra.
