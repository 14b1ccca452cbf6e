intros a b epsilon G_1 G_2 G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11.
pose proof (sin_square epsilon) as Q; unfold tan.
set (s := sin epsilon) in *; set (c := cos epsilon) in *.
set (R1 := sqrt (b * / a * s ^ 2 + 1)) in *; set (m := sqrt (a * / (a + b))).
assert (0 < b * / a) by positive.
assert (R2 : R1 ^ 2 = b * / a * s ^ 2 + 1) by (apply pow2_sqrt; exact N_9).
assert (R3 : 0 < R1) by (apply sqrt_lt_R0; nra).
assert (M2 : m ^ 2 = a * / (a + b)) by (apply pow2_sqrt; exact N_7).
assert (M : 0 < m) by (apply sqrt_lt_R0; positive).
assert (T : 0 < sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * c))).
{ pose proof (asin_bound (sqrt (b * / (a + b)) * c)); pose proof PI_RGT_0.
  apply Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | lra]. }
replace ((-2) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * c)))
  with (- (2 * (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * c))))) by ring.
set (t := sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * c))) in *; clearbody t.
assert (S : 0 < sinh t) by (rewrite <- sinh_0; now apply sinh_lt).
assert (E : exp (- (2 * t)) = / (exp t ^ 2)).
{ rewrite exp_Ropp; f_equal; replace (2 * t) with (t + t) by ring; rewrite exp_plus; ring. }
rewrite E, sinh_law in *; pose proof (exp_pos t) as X; set (x := exp t) in *; clearbody x.
assert (Y : 1 < x ^ 2).
{ assert (0 < (x + (-1) * / x) * (1 / 2) * (2 * x)) by (apply Rmult_lt_0_compat; lra).
  replace ((x + (-1) * / x) * (1 / 2) * (2 * x)) with (x ^ 2 - 1) in H0 by (field; lra); lra. }
assert (Z : s ^ 2 = m ^ 2 * (R1 ^ 2 - c ^ 2)) by (rewrite M2, R2, Q; field; lra).
assert (first : m * / ((x + (-1) * / x) * (1 / 2)) = s / c <-> 2 * x * c * m = s * (x ^ 2 - 1)).
{ assert (W : m * / ((x + (-1) * / x) * (1 / 2)) = 2 * x * m / (x ^ 2 - 1)) by (field; lra).
  rewrite W; split; intro H0.
  - apply (Rmult_eq_compat_r (c * (x ^ 2 - 1))) in H0.
    replace (2 * x * m / (x ^ 2 - 1) * (c * (x ^ 2 - 1))) with (2 * x * c * m) in H0 by (field; lra).
    rewrite H0; field; lra.
  - apply (Rmult_eq_reg_r (c * (x ^ 2 - 1))); [| apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    replace (2 * x * m / (x ^ 2 - 1) * (c * (x ^ 2 - 1))) with (2 * x * c * m) by (field; lra).
    rewrite H0; field; lra. }
assert (second : / (R1 + c) * (R1 + (-1) * c) = / x ^ 2 <-> c * (x ^ 2 + 1) = R1 * (x ^ 2 - 1)).
{ split; intro H0.
  - apply (Rmult_eq_compat_r ((R1 + c) * x ^ 2)) in H0.
    replace (/ (R1 + c) * (R1 + (-1) * c) * ((R1 + c) * x ^ 2)) with ((R1 - c) * x ^ 2) in H0
      by (field; lra).
    replace (/ x ^ 2 * ((R1 + c) * x ^ 2)) with (R1 + c) in H0 by (field; lra); lra.
  - apply (Rmult_eq_reg_r ((R1 + c) * x ^ 2)); [| apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    replace (/ (R1 + c) * (R1 + (-1) * c) * ((R1 + c) * x ^ 2)) with ((R1 - c) * x ^ 2)
      by (field; lra).
    replace (/ x ^ 2 * ((R1 + c) * x ^ 2)) with (R1 + c) by (field; lra); lra. }
rewrite first, second; split; intro H0.
- apply same_square; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra |].
  apply (f_equal (fun y : R => y ^ 2)) in H0; rewrite !Rpow_mult_distr, Z in H0.
  apply (Rmult_eq_reg_l (m ^ 2)); [| apply Rgt_not_eq, Rlt_gt; positive]; rewrite !Rpow_mult_distr.
  replace (m ^ 2 * (c ^ 2 * (x ^ 2 + 1) ^ 2)) with
    (2 ^ 2 * x ^ 2 * c ^ 2 * m ^ 2 + m ^ 2 * c ^ 2 * (x ^ 2 - 1) ^ 2) by ring; rewrite H0; ring.
- apply same_square; [left; positive | apply Rmult_le_pos; lra |].
  apply (f_equal (fun y : R => y ^ 2)) in H0; rewrite !Rpow_mult_distr in H0.
  rewrite !Rpow_mult_distr, Z.
  replace (m ^ 2 * (R1 ^ 2 - c ^ 2) * (x ^ 2 - 1) ^ 2) with
    (m ^ 2 * (R1 ^ 2 * (x ^ 2 - 1) ^ 2 - c ^ 2 * (x ^ 2 - 1) ^ 2)) by ring.
  rewrite <- H0; ring.
