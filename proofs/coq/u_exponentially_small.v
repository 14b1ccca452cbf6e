intros a b e s l m u Dl Dm Du Ds D P Q A B B1 AB; intros.
pose proof (claim_leading_by_defect _ a b e s Ds D P Q (fun _ _ _ _ => eq_refl) A B B1) as L.
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
pose proof (defect_boxes a b e A B P Q D B1 AB) as X; set (r := b * / a) in *; set (k := sqrt (a * b)) in *.
assert (E42 : e <= 42 / 100) by (decompose [and or] X; lra).
destruct (ratio_below b r k e) as [V V']; try lra.
set (q := k * asin _ + _ + _) in *.
assert (s0 : 0 < s) by (rewrite L; apply Rmult_lt_0_compat; [lra | apply exp_pos]).
assert (Eq : u = - (l * q)).
{ assert (M0 : 0 <= m < 1).
  { rewrite Dm; pose proof (share_below a b 0 A B) as H5; rewrite cos_0 in H5; split; [apply sqrt_pos | lra]. }
  rewrite Du by (first [lra | rewrite Dl; apply Rlt_gt, Rinv_0_lt_compat; exact K0]).
  assert (H5 : (-1) * m ^ 2 + 1 = a * / (a + b)).
  { rewrite Dm, pow2_sqrt by (left; positive); field; lra. }
  rewrite H5; assert (z : 0 < sqrt (a * / (a + b))) by (apply sqrt_lt_R0; positive).
  replace e with (s * exp q) by (rewrite L, Rmult_assoc, <- exp_plus; replace ((-1) * q + q) with 0 by ring; rewrite exp_0; ring).
  rewrite Ds, <- Dm; set (c := sqrt (a * / (a + b))) in *.
  replace (1 / 2 * (2 * c * exp ((-1) * k * (PI + asin m)) * exp q) * / c) with (exp ((-1) * k * (PI + asin m) + q))
    by (rewrite exp_plus; field; lra).
  rewrite ln_exp, Dl; field; lra. }
assert (l0 : 0 < l) by (rewrite Dl; apply Rinv_0_lt_compat; exact K0).
rewrite Eq, Rabs_Ropp, Rabs_mult, (Rabs_pos_eq l) by lra.
replace (36 / 25 * l * s ^ 2) with (l * (36 / 25 * s ^ 2)) by ring; apply Rmult_le_compat_l; [lra |].
replace (s ^ 2) with (e ^ 2 * / exp q ^ 2)
  by (rewrite L; replace ((-1) * q) with (- q) by ring; rewrite exp_Ropp; pose proof (exp_pos q); field; lra).
pose proof (exp_pos q) as x0; assert (Lx : ln (exp q) = q) by apply ln_exp.
set (x := exp q) in *; assert (E2 : 0 < e ^ 2) by nra.
clearbody x q k r; apply (Rmult_le_reg_r (x ^ 2)); [nra |].
replace (36 / 25 * (e ^ 2 * / x ^ 2) * x ^ 2) with (36 / 25 * e ^ 2) by (field; lra).
destruct (Rle_or_lt 1 x) as [H1|H1].
- rewrite Rabs_pos_eq by (rewrite <- Lx; apply ln_nonnegative; exact H1).
  set (z := x - 1) in *; assert (Z : 0 <= z <= e ^ 2 * up_all r (e ^ 2)) by (unfold z; lra).
  assert (G : q <= z - z ^ 2 / 2 + z ^ 3 / 3) by (rewrite <- Lx; replace x with (1 + z) by (unfold z; ring); apply ln_near; lra).
  replace (x ^ 2) with ((1 + z) ^ 2) by (unfold z; ring).
  apply Rle_trans with ((z - z ^ 2 / 2 + z ^ 3 / 3) * (1 + z) ^ 2); [apply Rmult_le_compat_r; nra |].
  replace ((z - z ^ 2 / 2 + z ^ 3 / 3) * (1 + z) ^ 2) with (z * ((1 - z / 2 + z ^ 2 / 3) * (1 + z) ^ 2)) by field.
  set (y := e ^ 2 * up_all r (e ^ 2)) in *.
  apply Rle_trans with (y * ((1 - y / 2 + y ^ 2 / 3) * (1 + y) ^ 2)).
  + assert (0 <= y) by lra; apply Rmult_le_compat; try lra; [apply Rmult_le_pos; nra |].
    enough (0 <= (y - z) * (3 / 2 + (y + z) / 3 + (y ^ 2 + y * z + z ^ 2) / 6 + (y ^ 3 + y ^ 2 * z + y * z ^ 2 + z ^ 3) / 3)) by lra.
    assert (0 <= y * z) by nra; assert (0 <= y ^ 2 * z) by nra; assert (0 <= y * z ^ 2) by nra.
    assert (0 <= y ^ 3) by (apply pow_le; lra); assert (0 <= z ^ 3) by (apply pow_le; lra).
    apply Rmult_le_pos; nra.
  + unfold y; rewrite Rmult_assoc, (Rmult_comm (36 / 25)); apply Rmult_le_compat_l; [lra |].
    clear - X P; destruct X as [[X Y]|[[X Y]|[[X Y]|[[X Y]|[[X Y]|[[X Y]|[X Y]]]]]]].
    * boxed r e (42 / 100).
    * boxed r e (213 / 1000).
    * boxed r e (164 / 1000).
    * boxed r e (138 / 1000).
    * boxed r e (1165 / 10000).
    * boxed r e (1102 / 10000).
    * boxed r e (1089 / 10000).
- assert (q < 0) by (rewrite <- Lx, <- ln_1; apply ln_increasing; lra).
  rewrite Rabs_left by lra.
  assert (N : ln (/ x) <= / x - 1) by (apply ln_below; positive); rewrite ln_Rinv, Lx in N by lra.
  assert (e ^ 2 <= 1764 / 10000) by nra.
  apply Rle_trans with ((/ x - 1) * x ^ 2); [apply Rmult_le_compat_r; nra |].
  replace ((/ x - 1) * x ^ 2) with ((1 - x) * x) by (field; lra); nra.
