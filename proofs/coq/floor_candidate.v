intros u U V G N_1 N_2 N_3; pose proof (claim_concave_at_the_floor u U V G) as C; pose proof PI_RGT_0.
set (q := sqrt ((-1) * u ^ 2 + 1)) in *; assert (Q : 0 < q) by (apply sqrt_lt_R0; nra).
assert (T : 0 < tanh PI < 1).
{ unfold tanh; pose proof (cosh_pos PI) as P; pose proof (sinh_pos PI PI_RGT_0).
  split; [positive | apply (Rmult_lt_reg_r (cosh PI)); [lra |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra].
  unfold sinh, cosh; pose proof (exp_pos (- PI)); lra. }
set (x := u * tanh PI); assert (X : 0 < x < u) by (unfold x; nra).
assert (A : asin x <= PI / 2 * x).
{ pose proof (asin_bound x); pose proof (asin_above x ltac:(lra)).
  rewrite <- (sin_asin x) at 2 by lra; apply jordan; lra. }
assert (I : 0 < / (u + 1)) by positive.
enough (/ (u + 1) * q * (PI + asin x) < PI * q) by lra.
apply (Rmult_lt_reg_l (u + 1)); [lra |].
replace ((u + 1) * (/ (u + 1) * q * (PI + asin x))) with (q * (PI + asin x)) by (field; lra).
replace ((u + 1) * (PI * q)) with (q * (PI + PI * u)) by ring; apply Rmult_lt_compat_l; [exact Q | nra].
