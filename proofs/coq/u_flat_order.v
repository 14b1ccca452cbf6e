intros a b e l m u Dl Dm Du D P Q A B B1 AB; intros.
assert (Ds : exists s, s = 2 * sqrt (a * / (a + b)) * exp ((-1) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)))))) by (eexists; reflexivity).
destruct Ds as [s Ds].
pose proof (claim_leading_by_defect _ a b e s Ds D P Q (fun _ _ _ _ => eq_refl) A B B1) as L.
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
set (r := b * / a) in *; set (k := sqrt (a * b)) in *.
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
replace (9 / 1000 * l ^ 2) with (l * (9 / 1000 * l)) by ring; apply Rmult_le_compat_l; [lra |].
assert (KL : k * l = 1) by (rewrite Dl; field; lra).
pose proof (flat_exponent a b e A B P Q D B1 AB q eq_refl) as Kq; fold k in Kq.
replace q with (k * q * l) by (rewrite (Rmult_comm k q), Rmult_assoc, KL; ring); apply Rabs_le; nra.
