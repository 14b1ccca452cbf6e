intros a b e A B G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3.
assert (P : forall t, e <= t <= 1 / 2 * PI -> 0 < sin t) by (intros; apply sin_gt_0; pose proof PI_RGT_0; lra).
set (f := fun t : R => / sqrt b * / sqrt (a + b * sin t ^ 2) * / sin t * ((-1) * b * sin t ^ 2 + 1)).
assert (C : continuous_on f e (1 / 2 * PI)).
{ intros t T; rewrite Rmin_left, Rmax_right in T by lra; specialize (P t T); pose proof (reach a b A B t).
  unfold f; continues; [apply Rgt_not_eq, sqrt_lt_R0; assumption | lra]. }
exists (RInt f e (1 / 2 * PI)); split; [apply integral_correct, C |].
assert (SB : 0 < sqrt b) by (apply sqrt_lt_R0; exact B).
assert (SA : 0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra).
(* cos t / sin t - b sin t cos t is below the cosecant and its share *)
set (h := fun t : R => / sqrt b * / sqrt (a + b) * (cos t * / sin t - b * sin t * cos t)).
assert (H : continuous_on h e (1 / 2 * PI)).
{ intros t T; rewrite Rmin_left, Rmax_right in T by lra; specialize (P t T); unfold h; continues; lra. }
assert (V : RInt h e (1 / 2 * PI) = / sqrt b * / sqrt (a + b) * ((-1) * ln (sin e) + (-1) / 2 * b * cos e ^ 2)).
{ rewrite (fundamental_closed h (fun t => / sqrt b * / sqrt (a + b) * (ln (sin t) + b / 2 * cos t ^ 2))).
  - replace (1 / 2 * PI) with (PI / 2) by field; rewrite sin_PI2, cos_PI2, ln_1; over_reals; field; lra.
  - exact H.
  - intros t T; rewrite Rmin_left, Rmax_right in T by lra; specialize (P t T); unfold h.
    eapply d_eq; [derive; lra |]; tidy; field; lra. }
rewrite <- V; apply Rle_ge, integral_le; [lra | exact H | exact C |].
intros t T; specialize (P t ltac:(lra)); unfold h, f; pose proof (reach a b A B t).
pose proof (COS_bound t); pose proof (SIN_bound t); pose proof (sin_square t).
assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
assert (L : / sqrt (a + b) <= / sqrt (a + b * sin t ^ 2)).
{ apply Rinv_le_contravar; [assumption | apply sqrt_le_1_alt; nra]. }
assert (0 <= (-1) * b * sin t ^ 2 + 1) by nra.
replace (/ sqrt b * / sqrt (a + b) * (cos t * / sin t - b * sin t * cos t))
  with (/ sqrt b * / sin t * ((-1) * b * sin t ^ 2 + 1) * (/ sqrt (a + b) * cos t)) by (field; lra).
replace (/ sqrt b * / sqrt (a + b * sin t ^ 2) * / sin t * ((-1) * b * sin t ^ 2 + 1))
  with (/ sqrt b * / sin t * ((-1) * b * sin t ^ 2 + 1) * / sqrt (a + b * sin t ^ 2)) by (field; lra).
apply Rmult_le_compat_l; [apply Rmult_le_pos; [left; positive | assumption] |].
assert (0 < / sqrt (a + b)) by positive; nra.
