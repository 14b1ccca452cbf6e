intros; match goal with H : tanh _ = _ |- _ => rename H into E end; f_equal.
replace (v_P * sqrt (a * b)) with (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos epsilon0)))
  by (subst v_P; ring).
rewrite E; set (s := sin epsilon0) in *; set (c := cos epsilon0) in *.
assert (I : 0 < b * / a) by (apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]).
assert (P : 0 < b * / a * s ^ 2 + 1) by nra.
assert (W : 0 < sqrt (b * / a * s ^ 2 + 1)) by (apply sqrt_lt_R0; lra).
assert (V : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
replace ((/ sqrt (b * / a * s ^ 2 + 1) * c) ^ 2) with (/ (b * / a * s ^ 2 + 1) * c ^ 2).
- rewrite <- Rmult_assoc; set (q := sqrt (_ * c ^ 2 + 1)); set (w := sqrt (_ * s ^ 2 + 1)) in *.
  set (v := sqrt (_ + 1)) in *; field; lra.
- rewrite Rpow_mult_distr, pow_inv, pow2_sqrt by lra; reflexivity.
