intros v_E v_I1 v_I2 v_I3 v_M chi; intros.
set (p := v_I2 + (-1) * v_I1) in *; set (q := v_I3 + (-1) * v_I2) in *; set (r := v_I3 + (-1) * v_I1) in *.
set (n := (-1) * v_M ^ 2 + 2 * v_E * v_I3) in *; set (m := v_M ^ 2 + (-2) * v_E * v_I1) in *.
assert (P : p = v_I2 - v_I1) by (unfold p; ring); assert (Q : q = v_I3 - v_I2) by (unfold q; ring).
assert (RR : r = v_I3 - v_I1) by (unfold r; ring); clearbody p q r n m.
set (d := sqrt ((-1) * / p * / n * (sin chi) ^ 2 * q * m + 1)) in *; assert (0 < d) by (apply sqrt_lt_R0; assumption).
set (w := sqrt (/ v_I1 * / v_I2 * / v_I3 * p * n)) in *; set (a1 := sqrt (v_I1 * / r * n)) in *.
set (a2 := sqrt (v_I2 * / p * m)) in *; set (a3 := sqrt (v_I3 * / r * m)) in *.
assert (0 < w) by (apply sqrt_lt_R0; positive); assert (0 < a1) by (apply sqrt_lt_R0; positive).
assert (0 < a2) by (apply sqrt_lt_R0; positive); assert (0 < a3) by (apply sqrt_lt_R0; positive).
assert (W : w ^ 2 = / v_I1 * / v_I2 * / v_I3 * p * n) by (apply pow2_sqrt; left; positive).
assert (S1 : a1 ^ 2 = v_I1 * / r * n) by (apply pow2_sqrt; left; positive).
assert (S2 : a2 ^ 2 = v_I2 * / p * m) by (apply pow2_sqrt; left; positive).
assert (S3 : a3 ^ 2 = v_I3 * / r * m) by (apply pow2_sqrt; left; positive).
assert (K1 : w * a1 * (q * m * / (p * n)) = a2 * a3 * (q * / (v_I2 * v_I3))).
{ apply same_square; [left; positive | left; positive |]; rewrite !Rpow_mult_distr, W, S1, S2, S3; field; repeat split; lra. }
assert (K2 : w * a2 = a1 * a3 * (r * / (v_I1 * v_I3))).
{ apply same_square; [left; positive | left; positive |]; rewrite !Rpow_mult_distr, W, S1, S2, S3; field; repeat split; lra. }
assert (K3 : w * a3 = a1 * a2 * (p * / (v_I1 * v_I2))).
{ apply same_square; [left; positive | left; positive |]; rewrite !Rpow_mult_distr, W, S1, S2, S3; field; repeat split; lra. }
clear W S1 S2 S3; clearbody w a1 a2 a3.
assert (D : is_derive (fun chi : R => sqrt ((-1) * / p * / n * (sin chi) ^ 2 * q * m + 1)) chi (- (q * m * / (p * n)) * sin chi * cos chi * / d)).
{ eapply d_eq; [derive; assumption | cbv beta; fold d; tidy; field; repeat split; lra]. }
split; [| split].
{ exists (a1 * (- (q * m * / (p * n)) * sin chi * cos chi * / d)); split.
  { eapply d_eq; [apply (d_mult (fun _ => a1) _ chi 0 _ (d_const a1 chi) D) | cbv beta; ring]. }
  transitivity (- (w * a1 * (q * m * / (p * n))) * cos chi * sin chi); [field; repeat split; lra | rewrite K1, Q; field; repeat split; lra]. }
{ exists (a2 * cos chi); split; [eapply d_eq; [derive | cbv beta; ring] |].
  transitivity (w * a2 * d * cos chi); [ring | rewrite K2, RR; field; repeat split; lra]. }
{ exists (a3 * - sin chi); split; [eapply d_eq; [derive | cbv beta; ring] |].
  transitivity (- (w * a3) * d * sin chi); [ring | rewrite K3, P; field; repeat split; lra]. }
