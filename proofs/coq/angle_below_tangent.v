intros e G_1 G_2 S C N.
assert (P : forall t, e <= t <= 1 / 2 * PI -> 0 < sin t) by (intros; apply sin_gt_0; pose proof PI_RGT_0; lra).
destruct (mean_value (fun t => t + cos t * / sin t) (fun t => 1 - / (sin t) ^ 2) e (1 / 2 * PI)) as [c [C1 C2]].
{ lra. }
{ intros t T; specialize (P t T); eapply d_eq; [derive; lra |]; cbv beta.
  replace (1 * - sin t * / sin t + cos t * (- (1 * cos t) / (sin t * sin t)))
    with (- (sin t ^ 2 + cos t ^ 2) * / sin t ^ 2) by (field; lra).
  replace (sin t ^ 2 + cos t ^ 2) with 1 by (rewrite sin_square; ring); lra. }
cbv beta in C2; replace (1 / 2 * PI) with (PI / 2) in * by field; rewrite cos_PI2, Rmult_0_l in C2.
assert (1 <= / sin c ^ 2).
{ specialize (P c C1); pose proof (SIN_bound c); apply (Rmult_le_reg_r (sin c ^ 2)); [positive |].
  rewrite Rinv_l by (apply Rgt_not_eq; positive); nra. }
nra.
