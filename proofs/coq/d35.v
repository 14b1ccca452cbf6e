intros a b epsilon x0 D_1 D_2 G_1 G_2 G_3 G_4 G_5 G_6 G_7.
assert (B : 0 < sqrt b) by (apply sqrt_lt_R0; lra).
assert (B2 : sqrt b ^ 2 = b) by (apply pow2_sqrt; lra).
assert (K : 0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra).
assert (K2 : sqrt (a + b) ^ 2 = a + b) by (apply pow2_sqrt; lra).
assert (M : sqrt (b * / (a + b)) = sqrt b * / sqrt (a + b)).
{ apply sqrt_unique; [left; positive |]; rewrite Rpow_mult_distr, B2, pow_inv, K2; reflexivity. }
rewrite M in D_1; set (m := sqrt b * / sqrt (a + b)) in *.
assert (P : 0 < m) by (unfold m; positive).
assert (M2 : m ^ 2 * (a + b) = b).
{ unfold m; rewrite Rpow_mult_distr, B2, pow_inv, K2; field; lra. }
assert (S : forall t, epsilon <= t <= PI + (-1) * epsilon -> 0 < sin t).
{ intros; apply sin_gt_0; lra. }
assert (RT : forall t, sqrt ((-1) * (m * cos t) ^ 2 + 1) = sqrt (a + b * sin t ^ 2) * / sqrt (a + b)).
{ intros t; pose proof (pow2_ge_0 (sin t)).
  assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; nra).
  apply sqrt_unique; [left; positive |].
  rewrite Rpow_mult_distr, pow_inv, K2, pow2_sqrt by nra.
  pose proof (sin_square t) as Q; rewrite Rpow_mult_distr.
  apply (Rmult_eq_reg_r (a + b)); [| lra]; rewrite Rmult_assoc, Rinv_l by lra.
  replace (((-1) * (m ^ 2 * cos t ^ 2) + 1) * (a + b)) with (a + b - m ^ 2 * (a + b) * cos t ^ 2)
    by ring; rewrite M2, Q; ring. }
assert (Z : forall t, (-1) * / b * (m * cos t) ^ 2 * (a + b) + 1 = sin t ^ 2).
{ intros t; rewrite Rpow_mult_distr.
  replace ((-1) * / b * (m ^ 2 * cos t ^ 2) * (a + b)) with
    ((-1) * / b * (m ^ 2 * (a + b)) * cos t ^ 2) by ring.
  rewrite M2, (sin_square t); field; lra. }
pose (f := fun x : R => / sqrt ((-1) * x ^ 2 + 1) * / ((-1) * / b * x ^ 2 * (a + b) + 1)
  + (-1) * b * / sqrt ((-1) * x ^ 2 + 1)).
assert (C : forall t, epsilon <= t <= PI + (-1) * epsilon -> continuous f (m * cos t)).
{ intros t T; specialize (S t T); pose proof (pow2_ge_0 (sin t)).
  assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; nra).
  assert (0 < sqrt (a + b * sin t ^ 2) * / sqrt (a + b)) by positive.
  assert (0 < sin t ^ 2) by positive.
  unfold f; continues; cbv beta; rewrite ?RT, ?Z; apply Rgt_not_eq; assumption. }
assert (L : epsilon <= PI + (-1) * epsilon) by lra.
assert (N : RInt f x0 ((-1) * x0) = (-2) * PI * b).
{ pose proof (integral_new_variable f (fun t => m * cos t) (fun t => m * - sin t)
    epsilon (PI + (-1) * epsilon)) as E; cbv beta in E.
  replace (cos (PI + (-1) * epsilon)) with (- cos epsilon) in E
    by (replace (PI + (-1) * epsilon) with (- (epsilon - PI)) by ring;
        rewrite cos_neg, cos_minus, cos_PI, sin_PI; ring).
  replace (m * - cos epsilon) with ((-1) * x0) in E by (rewrite D_1; ring).
  rewrite <- D_1 in E; rewrite E.
  - apply is_RInt_unique; replace ((-2) * PI * b) with (scal (- b) (2 * PI))
      by (unfold scal; simpl; unfold mult; simpl; ring).
    eapply is_RInt_ext; [| exact (is_RInt_scal _ _ _ (- b) _ D_2)].
    rewrite Rmin_left, Rmax_right by exact L; intros t T.
    assert (U : 0 < sin t) by (apply S; lra); pose proof (pow2_ge_0 (sin t)).
    assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; nra).
    unfold f; rewrite RT, Z; unfold scal; simpl; unfold mult; simpl; unfold m.
    set (q := sqrt b) in *; set (p := sqrt (a + b)) in *; set (w := sqrt (a + b * _)) in *.
    rewrite <- B2; field; repeat split; lra.
  - intros t _; eapply d_eq; [derive |]; ring.
  - intros t _; continues.
  - rewrite Rmin_left, Rmax_right by exact L; exact C. }
rewrite <- N; apply (RInt_correct f), integral_exists.
intros x X; assert (0 < x0) by (rewrite D_1; positive).
rewrite Rmin_right, Rmax_left in X by lra.
assert (H1 : 0 < (-1) * x0 ^ 2 + 1).
{ rewrite D_1; rewrite Rpow_mult_distr; pose proof (sin_square epsilon).
  assert (m ^ 2 < 1) by nra; assert (0 < m ^ 2) by positive; nra. }
assert (H2 : 0 < (-1) * / b * x0 ^ 2 * (a + b) + 1) by (rewrite D_1, Z; positive).
assert (H3 : x ^ 2 <= x0 ^ 2) by nra.
assert (H4 : / b * x ^ 2 * (a + b) <= / b * x0 ^ 2 * (a + b)).
{ apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_l; [| exact H3]; left; positive. }
assert (H5 : 0 < sqrt ((-1) * x ^ 2 + 1)) by (apply sqrt_lt_R0; lra).
unfold f; continues; cbv beta; lra.
