intros a b e g D1 D2 D3 A B G1 G2 N1 N2; rewrite A, B in *; clear A B N2; pose proof pi_between as J.
specialize (D1 ltac:(lra) ltac:(lra) ltac:(lra)); specialize (D2 ltac:(lra) ltac:(lra) ltac:(lra)); specialize (D3 ltac:(lra) ltac:(lra) ltac:(lra)).
assert (E : 114940 / 1000000 <= e <= 114950 / 1000000).
{ pose proof (defect_angle (1517 / 121) (55 / 874) e ltac:(lra) ltac:(lra) D2 D3 D1) as E; cbv zeta in E.
  rewrite sinh_law, asin_by_atan in E by (apply share_below; lra).
  assert (L1 : e <= 2) by lra; assert (L2 : e <= 15 / 100) by (rewrite E; interval).
  assert (L3 : 114 / 1000 <= e <= 116 / 1000) by (split; rewrite E; interval).
  split; rewrite E; interval. }
clear D1 D2 D3.
pose (k := / sqrt (1517 / 121)); pose (s := sqrt (55 / 874)); pose (c := 12 / 100); pose (m := 19 / 100).
pose (S := fun g t : R => sqrt (g + 55 / 874 * sin t ^ 2)).
pose (top := fun t : R => / sqrt (1517 / 121 + 55 / 874 * sin t ^ 2) * ((-1) * (55 / 874) * sin t ^ 2 + 1) - cos t * (k + c * sin t ^ 2)).
pose (rest := fun g t : R => top t * / S g t).
pose (main := fun g t : R => (k * / s - c * g / (2 * (55 / 874) * s)) * ln (s * sin t + S g t) + c / (2 * (55 / 874)) * sin t * S g t).
assert (s0 : 0 < s) by (apply sqrt_lt_R0; lra); assert (s2 : s ^ 2 = 55 / 874) by (apply pow2_sqrt; lra).
assert (low : forall t, 4 / 100 <= t <= 1 / 2 * PI -> 0 <= top t) by (intros t T; unfold top, k, c; interval with (i_bisect t, i_autodiff t)).
assert (high : forall t, 4 / 100 <= t <= m -> top t <= 25 / 100000) by (intros t T; unfold top, k, c, m in *; interval with (i_bisect t, i_autodiff t)).
assert (rises : forall y t, 4 / 100 <= y -> y <= t -> t <= 1 / 2 * PI -> 0 < sin y ^ 2 <= sin t ^ 2).
{ intros y t Y T Z; assert (0 < sin y) by (apply sin_gt_0; lra); assert (sin y <= sin t) by (apply sin_incr_1; lra).
  split; [apply pow_lt; lra | apply pow_incr; lra]. }
assert (nice : forall h y, 4 / 100 <= y -> y <= 1 / 2 * PI -> 0 < h + 55 / 874 * sin y ^ 2 -> continuous_on (rest h) y (1 / 2 * PI)).
{ intros h y Y Z P t; rewrite Rmin_left, Rmax_right by lra; intros T; pose proof (rises y t Y ltac:(lra) ltac:(lra)).
  assert (0 < S h t) by (apply sqrt_lt_R0; lra); unfold rest, top, S in *.
  assert (0 < sqrt (1517 / 121 + 55 / 874 * sin t ^ 2)) by (apply sqrt_lt_R0; lra); continues; lra. }
assert (turn : forall y, 4 / 100 <= y -> y <= m -> 0 < g + 55 / 874 * sin y ^ 2 -> exists v : R, is_RInt (fun psi : R =>
  / sqrt (1517 / 121 + 55 / 874 * sin psi ^ 2) * / sqrt (g + 55 / 874 * sin psi ^ 2) * ((-1) * (55 / 874) * sin psi ^ 2 + 1)) y (1 / 2 * PI) v
  /\ v = main g (1 / 2 * PI) - main g y + RInt (rest g) y (1 / 2 * PI)).
{ unfold m; intros y Y Z P; eexists; split; [| reflexivity].
  eapply is_RInt_ext; [| apply (is_RInt_plus (fun t => cos t * (k + c * sin t ^ 2) * / S g t) (rest g)); [apply (is_RInt_derive (main g)) |]].
  - intros t T; apply (eq_trans (y := cos t * (k + c * sin t ^ 2) * / S g t + rest g t)); [reflexivity |].
    unfold rest, top, S; over_reals; ring.
  - intros t; rewrite Rmin_left, Rmax_right by lra; intros T; pose proof (rises y t Y ltac:(lra) ltac:(lra)).
    assert (Q : 0 < g + 55 / 874 * sin t ^ 2) by lra; assert (R : 0 < S g t) by (apply sqrt_lt_R0; exact Q).
    pose proof (pow2_sqrt _ (Rlt_le _ _ Q)) as R2.
    assert (0 < sin t) by (apply sin_gt_0; lra); assert (0 < s * sin t) by (apply Rmult_lt_0_compat; lra).
    eapply d_eq; [unfold main, S in *; derive; lra |]; unfold S in *; tidy.
    set (r := sqrt (g + _)) in *; clearbody r; assert (H2 : g = r ^ 2 - s ^ 2 * sin t ^ 2) by (rewrite R2, s2; ring).
    rewrite H2, <- s2; field; lra.
  - intros t; rewrite Rmin_left, Rmax_right by lra; intros T; pose proof (rises y t Y ltac:(lra) ltac:(lra)).
    assert (Q : 0 < g + 55 / 874 * sin t ^ 2) by lra; assert (R : 0 < S g t) by (apply sqrt_lt_R0; exact Q).
    unfold S in *; continues; lra.
  - apply integral_correct, nice; lra. }
assert (part : forall h p q, 0 < h + 55 / 874 * sin p ^ 2 -> 4 / 100 <= p -> p <= q -> q <= 1 / 2 * PI -> continuous_on (rest h) p q).
{ intros h p q P Y Z T t; rewrite Rmin_left, Rmax_right by lra; intros X; apply (nice h p); try lra; rewrite Rmin_left, Rmax_right; lra. }
assert (above : forall h t, 0 < h + 55 / 874 * sin t ^ 2 -> 0 < / S h t) by (intros h t H; apply Rinv_0_lt_compat, sqrt_lt_R0, H).
assert (falls : forall h i t, 4 / 100 <= t -> t <= 1 / 2 * PI -> 0 < h + 55 / 874 * sin t ^ 2 -> h <= i -> rest i t <= rest h t).
{ intros h i t Y Z H I; unfold rest; apply Rmult_le_compat_l; [apply low; lra |].
  apply Rinv_le_contravar; [apply sqrt_lt_R0, H | apply sqrt_le_1_alt; lra]. }
assert (far : forall h, - (1 / 500) <= h -> 0 < h + 55 / 874 * sin m ^ 2).
{ intros h H; assert (2 / 1000 < 55 / 874 * sin m ^ 2) by (unfold m; interval); lra. }
assert (end_ : sin (1 / 2 * PI) = 1) by (replace (1 / 2 * PI) with (PI / 2) by field; apply sin_PI2).
split.
- set (y := 103 / 100 * e + _); assert (Y : 4 / 100 <= y <= m) by (unfold y, m; split; interval).
  assert (P : 1 / 10000 <= g + 55 / 874 * sin y ^ 2) by (unfold y; interval with (i_bisect g, i_autodiff g)).
  destruct (turn y ltac:(lra) ltac:(lra) ltac:(lra)) as [v [V W]]; exists v; split; [exact V |]; rewrite W.
  assert (I : RInt (rest g) y (1 / 2 * PI) <= (m - y) * (25 / 100000 * / S g y) + RInt (rest (- (1 / 500))) m (1 / 2 * PI)).
  { unfold m in *; rewrite (integral_cut (rest g) y (19 / 100) (1 / 2 * PI)); [| apply part; lra |].
    - apply Rplus_le_compat.
      + rewrite <- integral_const; apply integral_le; [lra | apply part; lra | intros t _; apply continuous_const |].
        intros t T; pose proof (rises y t ltac:(lra) ltac:(lra) ltac:(lra)).
        apply Rmult_le_compat; [apply low; lra | left; apply above; lra | apply high; lra |].
        apply Rinv_le_contravar; [apply sqrt_lt_R0; lra | apply sqrt_le_1_alt; lra].
      + apply integral_le; [lra | apply part; try lra; apply far; lra | apply part; try lra; apply far; lra |].
        intros t T; pose proof (rises (19 / 100) t ltac:(lra) ltac:(lra) ltac:(lra)).
        pose proof (far (- (1 / 500)) ltac:(lra)); apply falls; lra.
    - apply part; try lra; apply far; lra. }
  assert (K : RInt (rest (- (1 / 500))) m (1 / 2 * PI) <= 479 / 1000) by (unfold rest, top, S, k, c, m; estimated; interval).
  apply Rle_lt_trans with (main g (1 / 2 * PI) - main g y + ((m - y) * (25 / 100000 * / S g y) + 479 / 1000)); [lra |].
  unfold main, S; rewrite end_; unfold y, k, s, c, m; interval with (i_bisect g, i_autodiff g).
- set (y := 97 / 100 * e + _); assert (Y : 4 / 100 <= y <= m) by (unfold y, m; split; interval).
  assert (P : 1 / 100000 <= g + 55 / 874 * sin y ^ 2) by (unfold y; interval with (i_bisect g, i_autodiff g)).
  destruct (turn y ltac:(lra) ltac:(lra) ltac:(lra)) as [v [V W]]; exists v; split; [exact V |]; rewrite W.
  assert (I : RInt (rest (1 / 500)) m (1 / 2 * PI) <= RInt (rest g) y (1 / 2 * PI)).
  { unfold m in *; rewrite (integral_cut (rest g) y (19 / 100) (1 / 2 * PI)); [| apply part; lra |].
    - enough (0 <= RInt (rest g) y (19 / 100) /\ RInt (rest (1 / 500)) (19 / 100) (1 / 2 * PI) <= RInt (rest g) (19 / 100) (1 / 2 * PI)) by lra.
      split.
      + apply integral_nonnegative; [lra | apply part; lra |]; intros t T; pose proof (rises y t ltac:(lra) ltac:(lra) ltac:(lra)).
        apply Rmult_le_pos; [apply low; lra | left; apply above; lra].
      + apply integral_le; [lra | apply part; try lra; apply far; lra | apply part; try lra; apply far; lra |].
        intros t T; pose proof (rises (19 / 100) t ltac:(lra) ltac:(lra) ltac:(lra)).
        pose proof (far g ltac:(lra)); apply falls; lra.
    - apply part; try lra; apply far; lra. }
  assert (K : 457 / 1000 <= RInt (rest (1 / 500)) m (1 / 2 * PI)) by (unfold rest, top, S, k, c, m; estimated; interval).
  apply Rlt_le_trans with (main g (1 / 2 * PI) - main g y + 457 / 1000); [| lra].
  unfold main, S; rewrite end_; unfold y, k, s, c, m; interval with (i_bisect g, i_autodiff g).
