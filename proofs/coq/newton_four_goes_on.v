intros p a b e _ _ _ D A B B1; pose proof PI_RGT_0 as P; pose proof pi_between as P3.
assert (R0 : 0 < b * / a) by positive; assert (AB : 0 < a * b) by positive.
pose proof (product_root a b A B) as KR.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; exact AB); set (k := sqrt (a * b)) in *.
assert (Q : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; exact R0).
assert (Q2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; lra); set (r := sqrt (b * / a)) in *.
rewrite <- Q2 in *; clear Q2.
set (u := atan (r * tanh (4 * k))) in *; set (x := k * (PI + u)) in *; set (v := atan (r * tanh x)) in *.
assert (T : 0 < tanh (4 * k)) by (rewrite <- tanh_0; apply increasing_tanh; nra).
assert (U : 0 < u) by (apply atan_above; nra).
assert (X : PI * k < x) by (unfold x; nra); assert (X0 : 0 < x) by nra.
pose proof (sinh_above x ltac:(lra)) as S.
assert (V : 78 / 100 * u <= v).
{ apply Rle_trans with (atan (78 / 100 * (r * tanh (4 * k)))); [apply atan_share; nra |].
  apply arctangent_rises; replace (78 / 100 * (r * tanh (4 * k))) with (r * (78 / 100 * tanh (4 * k))) by ring.
  apply Rmult_le_compat_l; [lra |].
  destruct (Rle_or_lt x (4 * k)) as [L|L].
  - pose proof (tanh_share x (4 * k) ltac:(lra) L ltac:(lra)) as Y.
    apply (Rmult_le_reg_l (4 * k)); [lra |]; apply Rle_trans with (x * tanh (4 * k)); [| exact Y].
    replace (4 * k * (78 / 100 * tanh (4 * k))) with (k * (4 * (78 / 100)) * tanh (4 * k)) by ring.
    apply Rmult_le_compat_r; [lra |]; assert (312 / 100 < PI) by interval; nra.
  - pose proof (increasing_tanh _ _ L); lra. }
pose proof (cosh_square x) as C.
set (d := cosh x ^ 2 + r ^ 2 * sinh x ^ 2) in *.
assert (E : (-1) * b + sinh x ^ 2 * (r ^ 2 + 1) + 1 = d - b) by (unfold d; rewrite C; ring).
rewrite E in D; clear E.
assert (F : 1 + 9 * b ^ 2 <= d).
{ assert (3 * k <= sinh x) by nra; assert (9 * k ^ 2 <= sinh x ^ 2) by nra.
  unfold d; rewrite C, <- KR; assert (0 <= r ^ 2) by nra; nra. }
pose proof (pow2_ge_0 (3 * b - 1)); assert (0 < b ^ 2) by nra.
assert (M : 0 < d - b) by nra; assert (N : d <= 12 / 10 * (d - b)) by nra.
assert (I : / (d - b) * d <= 12 / 10).
{ apply (Rmult_le_reg_l (d - b)); [exact M |]; rewrite <- Rmult_assoc, Rinv_r by lra; lra. }
assert (J : 0 < / (d - b) * d) by (assert (0 < d) by nra; positive); set (m := / (d - b) * d) in *.
rewrite D; replace (PI + (-1) * / (d - b) * d * ((-1) * v + u) + u) with (PI + u - m * (u - v)) by (unfold m; ring).
assert (m * (u - v) <= 12 / 10 * (22 / 100 * u)); [| lra].
destruct (Rle_or_lt u v); [| apply Rmult_le_compat; lra].
assert (0 <= m * (v - u)) by (apply Rmult_le_pos; lra); lra.
