intros S a b e A B G_3 G_4 G_5 G_6 G_7.
destruct (unturned b B 0 e) as [p [u [v [H1 [H2 [H3 H4]]]]]]; try lra.
{ rewrite Rplus_0_l; positive. }
assert (P : forall t, e <= t <= 1 / 2 * PI -> 0 < sin t) by (intros; apply sin_gt_0; pose proof PI_RGT_0; lra).
assert (E : forall t, e <= t <= 1 / 2 * PI -> rate_slope S a b 0 t
  = (-1) / 2 * S * / sqrt b ^ 3 * / sqrt (a + b * sin t ^ 2) * / sin t ^ 3 * ((-1) * b * sin t ^ 2 + 1)).
{ intros t T; specialize (P t T); pose proof (reach a b A B t); unfold rate_slope.
  rewrite Rplus_0_l, sqrt_mult, sqrt_pow2 by (first [lra | apply pow2_ge_0]).
  assert (0 < sqrt b) by (apply sqrt_lt_R0; exact B).
  assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
  field; repeat split; lra. }
exists (RInt (rate_slope S a b 0) e (1 / 2 * PI)), (RInt (rate_slope S a b 0) e (1 / 2 * PI)).
split; [| split]; [| | reflexivity].
- apply (turn_by_level S a b A B 0 p u v); try lra; exact H4.
- apply (is_RInt_ext (rate_slope S a b 0)).
  + rewrite Rmin_left, Rmax_right by lra; intros t T; apply E; lra.
  + apply integral_correct; intros t T; rewrite Rmin_left, Rmax_right in T by lra.
    apply rate_slope_continuous; [assumption | assumption |]; specialize (P t T).
    rewrite Rplus_0_l; positive.
