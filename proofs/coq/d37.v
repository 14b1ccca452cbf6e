intros a b epsilon G_1 G_2 G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12 N_13.
pose proof (sin_square epsilon) as Q.
set (s := sin epsilon) in *; set (c := cos epsilon) in *; set (u := asin _); set (k := sqrt (a * b)).
assert (I : 0 < b * / a) by positive.
assert (C : c < 1) by nra.
set (R1 := sqrt (b * / a * s ^ 2 + 1)) in *.
assert (R2 : R1 ^ 2 = b * / a * s ^ 2 + 1) by (apply pow2_sqrt; exact N_1).
assert (R3 : 0 < R1) by (apply sqrt_lt_R0; nra).
assert (R4 : c < R1) by nra.
assert (K : sqrt (a * / b) * sqrt (b * / (a + b)) * / sqrt ((-1) * b * / (a + b) * c ^ 2 + 1) * c
  = c * / R1).
{ set (p := sqrt (a * / b)); set (q := sqrt (b * / (a + b))); set (w := sqrt (_ + 1)).
  assert (p ^ 2 = a * / b) by (apply pow2_sqrt; exact N_12).
  assert (q ^ 2 = b * / (a + b)) by (apply pow2_sqrt; exact N_6).
  assert (w ^ 2 = (-1) * b * / (a + b) * c ^ 2 + 1) by (apply pow2_sqrt; lra).
  assert (0 < p) by (apply sqrt_lt_R0; positive).
  assert (0 < q) by (apply sqrt_lt_R0; positive).
  assert (0 < w) by (apply sqrt_lt_R0; exact N_11).
  assert (W : p * q * R1 = w).
  { apply same_square; [left; positive | lra |]; rewrite !Rpow_mult_distr, R2, H, H0, H1.
    replace (c ^ 2) with (1 - s ^ 2) by lra; field; lra. }
  rewrite <- W; field; repeat split; lra. }
rewrite K; unfold atanh; set (q := / (R1 + c) * (R1 + (-1) * c)).
assert (V : 0 < q) by (unfold q; apply Rmult_lt_0_compat; [positive | lra]).
replace ((1 + c * / R1) / (1 - c * / R1)) with (/ q) by (unfold q; field; repeat split; lra).
rewrite ln_Rinv by exact V; split; intro H.
- rewrite H, ln_exp; field.
- replace ((-2) * k * (PI + u)) with (ln q) by lra; now rewrite exp_ln.
