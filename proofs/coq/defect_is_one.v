intros a b A B L N_1 N_2 N_3 N_4; pose proof PI_RGT_0.
set (T := fun e : R => sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))).
set (w := fun e : R => sqrt (b * / a * sin e ^ 2 + 1)).
assert (I : forall e, 0 < b * / a * sin e ^ 2 + 1).
{ intros e; pose proof (pow2_ge_0 (sin e)); assert (0 < b * / a) by positive; nra. }
assert (W : forall e, 0 < w e) by (intros e; apply sqrt_lt_R0, I).
assert (W2 : forall e, w e ^ 2 = b * / a * sin e ^ 2 + 1) by (intros e; apply pow2_sqrt; left; apply I).
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
assert (P : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; positive).
assert (KP : sqrt (a * b) * sqrt (b * / a) <= 1).
{ rewrite <- sqrt_mult by (left; positive).
  replace (a * b * (b * / a)) with (b ^ 2) by (field; lra); rewrite sqrt_pow2; lra. }
assert (TP : forall e, 0 < T e).
{ intros e; unfold T; pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)).
  apply Rmult_lt_0_compat; lra. }
assert (one : forall e d, 0 < e < PI / 2 -> 0 < d < PI / 2 -> tanh (T e) = / w e * cos e ->
  tanh (T d) = / w d * cos d -> e = d).
{ intros e d X Y E D.
  assert (S : forall u, tanh (T u) = / w u * cos u ->
    T u = sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (T u)))).
  { intros u U; rewrite U; unfold T at 1; rewrite turn_of_share by lra; reflexivity. }
  assert (H1 : T e = T d) by (apply (one_phase _ _ _ _ K P KP (TP e) (TP d) (S e E) (S d D))).
  rewrite H1, D in E; assert (0 < cos e) by (apply cos_gt_0; lra); assert (0 < cos d) by (apply cos_gt_0; lra).
  pose proof (W e); pose proof (W d); pose proof (W2 e) as V; pose proof (W2 d) as U.
  rewrite sin_square in V, U.
  assert (F : w e * cos d = w d * cos e).
  { replace (w e * cos d) with (w e * w d * (/ w d * cos d)) by (field; lra); rewrite E; field; lra. }
  assert (G : w e ^ 2 * cos d ^ 2 = w d ^ 2 * cos e ^ 2) by (rewrite <- !Rpow_mult_distr, F; reflexivity).
  rewrite V, U in G; assert (0 < b * / a) by positive.
  apply same_cos; [lra | lra |]; apply same_square; [lra | lra | nra]. }
destruct (root_exists (fun e => tanh (T e) - / w e * cos e) 0 (PI / 2)) as [e [E Z]].
{ lra. }
{ intros e _; pose proof (share_below a b e A B); unfold T, w; continues; cbv beta; try lra.
  apply Rgt_not_eq, W. }
{ assert (L0 : tanh (T 0) < 1).
  { unfold tanh; pose proof (cosh_pos (T 0)); apply (Rmult_lt_reg_r (cosh (T 0))); [lra |].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r by lra.
    unfold sinh, cosh; pose proof (exp_pos (- T 0)); lra. }
  assert (L1 : 0 < tanh (T (PI / 2))).
  { rewrite <- tanh_0; apply increasing_tanh, TP. }
  replace (/ w 0 * cos 0) with 1.
  - rewrite cos_PI2, Rmult_0_r; nra.
  - unfold w; rewrite sin_0, cos_0; replace (b * / a * 0 ^ 2 + 1) with 1 by ring; rewrite sqrt_1; field. }
assert (R0 : tanh (T e) = / w e * cos e) by lra.
assert (X : 0 < e < PI / 2).
{ destruct E as [[E1|E1] [E2|E2]]; try lra; exfalso; subst e.
  - rewrite cos_PI2, Rmult_0_r in R0; pose proof (increasing_tanh 0 (T (PI / 2)) (TP _)) as Y.
    rewrite tanh_0 in Y; lra.
  - unfold w in R0; rewrite sin_0, cos_0 in R0; replace (b * / a * 0 ^ 2 + 1) with 1 in R0 by ring.
    rewrite sqrt_1 in R0; unfold tanh in R0; pose proof (cosh_pos (T 0)); pose proof (exp_pos (- T 0)).
    assert (Y : sinh (T 0) = cosh (T 0)).
    { replace (sinh (T 0)) with (sinh (T 0) / cosh (T 0) * cosh (T 0)) by (field; lra); rewrite R0; field. }
    unfold sinh, cosh in Y; lra. }
exists e; split; [repeat split; try lra; exact R0 |].
intros d [D1 [D2 D3]]; apply one; try lra; assumption.
