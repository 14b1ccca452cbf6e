intros; subst; match goal with H : _ ^ 2 = _ |- _ => rewrite H end; apply Rle_ge.
match goal with |- 0 <= ?e => replace e with (v_M1 ^ 2 * / v_I1 * (v_I3 + -1 * v_I1) + v_M2 ^ 2 *
  / v_I2 * (v_I3 + -1 * v_I2)) by (field; lra) end.
assert (0 < / v_I1) by (apply Rinv_0_lt_compat; lra); assert (0 < / v_I2)
  by (apply Rinv_0_lt_compat; lra).
apply Rplus_le_le_0_compat; (apply Rmult_le_pos; [apply Rmult_le_pos;
  [apply pow2_ge_0 | lra] | lra]).
