intros [C [n [n0 N]]].
pose proof (Rabs_pos C) as C0; set (M := Rabs C) in *.
set (a := Rmin (n / 2) (Rmin (1 / 10000) (/ (8 * M + 1)))).
assert (i0 : 0 < / (8 * M + 1)) by (apply Rinv_0_lt_compat; lra).
assert (A : 0 < a) by (unfold a; repeat apply Rmin_pos; lra).
assert (An : a <= n / 2 /\ a <= 1 / 10000 /\ a <= / (8 * M + 1)).
{ unfold a; pose proof (Rmin_l (n / 2) (Rmin (1 / 10000) (/ (8 * M + 1)))).
  pose proof (Rmin_r (n / 2) (Rmin (1 / 10000) (/ (8 * M + 1)))).
  pose proof (Rmin_l (1 / 10000) (/ (8 * M + 1))); pose proof (Rmin_r (1 / 10000) (/ (8 * M + 1))); lra. }
clearbody a; destruct An as [A1 [A2 A3]].
assert (I : 0 < 1 * / (a + 1)) by positive; assert (I' : 0 < 1 * / a) by positive; assert (I2 : 0 < a * / (a + 1)) by positive.
destruct (claim_defect_is_one a 1) as [e [[P [Q D]] _]]; try lra.
pose proof (share_below a 1 0 A ltac:(lra)) as H0; rewrite cos_0, Rmult_1_r in H0.
specialize (N a 1 e D P Q ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
assert (B0 : 1 > 0) by lra; pose proof (defect_turn a 1 e A B0 P Q) as T; pose proof pi_between as J; pose proof PI_4 as J4.
pose proof (defect_angle a 1 e A B0 P Q D) as V.
assert (M4 : 8 * (M * a) <= 1).
{ apply (Rmult_le_compat_r (8 * M + 1)) in A3; [| lra]; rewrite Rinv_l in A3 by lra; nra. }
assert (K2 : sqrt (a * 1) ^ 2 = a) by (rewrite pow2_sqrt by lra; ring).
assert (K0 : 0 < sqrt (a * 1)) by (apply sqrt_lt_R0; lra).
set (k := sqrt (a * 1)) in *; assert (K1 : k <= 1 / 100) by nra.
set (x := k * (PI + asin (sqrt (1 * / (a + 1)) * cos e))) in *.
assert (P3 : 3 / 2 * PI <= 472 / 100) by interval.
assert (X : 0 < x <= 472 / 100 * k) by (unfold x; split; [apply Rmult_lt_0_compat; lra | nra]).
assert (Sx : 0 < sinh x <= 2 * x).
{ split; [apply sinh_pos; lra |]; pose proof (exp_below x) as E1; pose proof (exp_ineq1_le (- x)) as E2.
  unfold sinh; assert (exp x <= 1 + 2 * x); [| lra].
  assert (0 < exp x) by apply exp_pos; nra. }
set (c := sqrt (a * / (a + 1))) in *; assert (c0 : 0 < c) by (apply sqrt_lt_R0; exact I2).
assert (c2 : c ^ 2 = a * / (a + 1)) by (apply pow2_sqrt; lra).
assert (ia : 9999 / 10000 <= / (a + 1) <= 1).
{ split; apply (Rmult_le_reg_r (a + 1)); try lra; rewrite Rinv_l; lra. }
assert (ck : 99 / 100 * k <= c <= k) by (split; nra).
assert (L : 1 / 10 <= e).
{ apply Rle_trans with (atan (104 / 1000)); [interval |]; rewrite V; apply arctangent_rises.
  rewrite Rinv_mult; replace (/ sqrt (1 * / a + 1)) with c by (apply inverse_root; lra).
  apply (Rmult_le_reg_r (sinh x)); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; nra. }
set (s := asin (sqrt (1 * / (a + 1)))) in *.
assert (s0 : 0 < s) by (apply asin_above, sqrt_lt_R0; lra).
assert (ks : 0 < k * (PI + s)) by (apply Rmult_lt_0_compat; lra).
assert (E1 : 1 <= exp (k * (PI + s))) by (rewrite <- exp_0; apply exp_rises; lra).
assert (E2 : 0 < exp ((-2) * k * (PI + s)) <= 1).
{ split; [apply exp_pos | rewrite <- exp_0; apply exp_rises; lra]. }
set (y := exp (k * (PI + s))) in *; set (z := exp ((-2) * k * (PI + s))) in *.
assert (ic : 100 <= / c) by (apply (Rmult_le_reg_r c); [lra | rewrite Rinv_l by lra; lra]).
assert (Left : 5 <= 1 / 2 * e * / c * y) by (assert (5 <= 1 / 2 * e * / c) by nra; nra).
rewrite Rabs_pos_eq in N by lra.
replace (4 * a * / (a + 1) * z) with (4 * (a * (/ (a + 1) * z))) in N by ring.
assert (0 <= / (a + 1) * z <= 1) by nra; set (q := / (a + 1) * z) in *.
rewrite Rabs_pos_eq in N by nra; pose proof (Rle_abs C) as Cm; fold M in Cm.
assert (C * (4 * (a * q)) <= M * (4 * (a * q))) by (apply Rmult_le_compat_r; nra).
assert (M * (4 * (a * q)) <= M * (4 * a)); [apply Rmult_le_compat_l; [lra | assert (a * q <= a * 1) by (apply Rmult_le_compat_l; lra); lra] | lra].
