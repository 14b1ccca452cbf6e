intros S a b e A B G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9.
destruct (claim_d53 S a b e A B G_3 G_4 G_5 G_6 G_7) as [v1 [v2 [D [I E]]]].
eapply d_eq; [exact D |]; rewrite E, <- (is_RInt_unique _ _ _ _ I); clear D I E v1 v2.
assert (P : forall t, e <= t <= 1 / 2 * PI -> 0 < sin t) by (intros; apply sin_gt_0; pose proof PI_RGT_0; lra).
assert (Q : forall t, e <= t <= 1 / 2 * PI -> 0 <= cos t) by (intros; apply cos_ge_0; pose proof PI_RGT_0; lra).
assert (SB : 0 < sqrt b) by (apply sqrt_lt_R0; exact B).
assert (SA : 0 < sqrt a) by (apply sqrt_lt_R0; exact A).
assert (B2 : sqrt b ^ 2 = b) by (apply pow2_sqrt; lra).
assert (A2 : sqrt a ^ 2 = a) by (apply pow2_sqrt; lra).
rewrite sqrt_mult by lra; set (p := sqrt a) in *; set (q := sqrt b) in *.
set (w := fun t : R => sqrt (a + b * sin t ^ 2)).
assert (W : forall t, 0 < w t) by (intros t; apply sqrt_lt_R0, reach; assumption).
assert (W2 : forall t, w t ^ 2 = a + b * sin t ^ 2).
{ intros t; apply pow2_sqrt; left; apply reach; assumption. }
rewrite (fundamental_closed _ (fun t => 1 / 4 * S * / (p * q) ^ 3 * (a + (-1) * b + (-2) * a * b)
    * ln (/ sin t * (w t + p * cos t)) + 1 / 4 * S * / a * / q ^ 3 * w t * / sin t ^ 2 * cos t)).
- unfold w; replace (1 / 2 * PI) with (PI / 2) by field; rewrite sin_PI2, cos_PI2, Rinv_1, Rmult_0_r, !Rmult_1_l.
  replace (a + b * 1 ^ 2) with (a + b) by ring; rewrite Rplus_0_r; over_reals; field; repeat split; lra.
- intros t T; rewrite Rmin_left, Rmax_right in T by lra; specialize (P t T); specialize (W t); fold (w t).
  continues; try (apply pow_nonzero); try (apply Rgt_not_eq; assumption); apply Rgt_not_eq; exact W.
- intros t T; rewrite Rmin_left, Rmax_right in T by lra; specialize (P t T); specialize (Q t T).
  pose proof (reach a b A B t) as H; specialize (W t); specialize (W2 t).
  assert (0 < w t + p * cos t) by (assert (0 <= p * cos t) by (apply Rmult_le_pos; lra); lra).
  unfold w; eapply d_eq; [derive; fold (w t); try exact H; try positive; try (apply pow_nonzero); lra |].
  tidy; fold (w t); pose proof (sin_square t) as C; set (s := sin t) in *; set (c := cos t) in *; set (v := w t) in *.
  assert (V : v ^ 2 = p ^ 2 + q ^ 2 * s ^ 2) by (rewrite A2, B2; exact W2).
  rewrite <- A2, <- B2; field [C V]; repeat split; lra.
