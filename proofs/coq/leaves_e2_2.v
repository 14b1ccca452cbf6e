intros; subst v_dM3_dt v_dM1_dt; apply Rle_ge.
assert (P : sqrt (/ v_I1 + (-1) * / v_I2) ^ 2 = / v_I1 + (-1) * / v_I2) by (apply pow2_sqrt; assumption).
assert (Q : sqrt (/ v_I2 + (-1) * / v_I3) ^ 2 = / v_I2 + (-1) * / v_I3) by (apply pow2_sqrt; assumption).
set (p := sqrt (/ v_I1 + (-1) * / v_I2)) in *; set (q := sqrt (/ v_I2 + (-1) * / v_I3)) in *.
assert (A : / v_I1 = p ^ 2 + / v_I2) by lra; assert (B : / v_I3 = / v_I2 - q ^ 2) by lra.
rewrite A, B; match goal with |- 0 <= ?e =>
  replace e with (v_M2 ^ 2 * (v_M1 * p + v_M3 * q) ^ 2) by ring end.
apply Rmult_le_pos; apply pow2_ge_0.
