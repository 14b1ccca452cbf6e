intros a b e D P Q A B B1 AB BH; intros.
replace ((-1) * e * sqrt (a * b) + _) with (sqrt b * / ((-1) * b * sin e ^ 2 + 1) * sqrt (a + b * sin e ^ 2) * sin e - e * sqrt (a * b)) by ring.
rewrite (per_turn_is a b e A B P Q).
pose proof (defect_boxes a b e A B P Q D B1 AB) as X.
assert (E1 : e <= 42 / 100) by (decompose [and or] X; lra).
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
destruct (per_turn_between a b e A B P Q B1 R4 E1) as [L [U [T0 T1]]].
set (r := b * / a) in *; set (k := sqrt (a * b)) in *; set (t := sqrt _ * _ * _) in *; clearbody t.
replace (k * t - e * k) with (k * (t - e)) by ring.
set (u := e ^ 2) in *; assert (u0 : 0 < u <= 1764 / 10000) by (unfold u; nra).
assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
enough (1 / 4 * u * e < t - e < 29 / 10 * u * e) by (replace (e ^ 3) with (u * e) by (unfold u; ring);
  rewrite (Rmult_comm _ k), (Rmult_comm _ k), <- !(Rmult_assoc _ u e); split; apply Rmult_lt_compat_l; lra).
split.
- assert (0 <= u - u ^ 2 / 3) by nra.
  apply Rlt_le_trans with (e * (1 - u / 6) * (1 + b * (u - u ^ 2 / 3)) - e); [| lra].
  apply Rlt_le_trans with (e * ((1 - u / 6) * (1 + 1 / 2 * (u - u ^ 2 / 3)) - 1)).
  + replace (1 / 4 * u * e) with (e * (1 / 4 * u)) by ring; apply Rmult_lt_compat_l; [lra |]; clear - u0; nra.
  + rewrite Rmult_minus_distr_l, Rmult_1_r, <- Rmult_assoc; apply Rplus_le_compat_r, Rmult_le_compat_l; [apply Rmult_le_pos; lra | nra].
- enough (t < e * (1 + 29 / 10 * u)) by lra.
  set (q := b * (u * up_time u)) in *; apply (Rmult_lt_reg_r (1 - q)); [lra |].
  eapply Rle_lt_trans; [exact U |]; rewrite Rmult_assoc, (Rmult_assoc e); apply Rmult_lt_compat_l; [lra |].
  assert (q <= u * up_time u) by (unfold q; rewrite <- (Rmult_1_l (u * up_time u)) at 2; apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra).
  apply Rlt_le_trans with ((1 + 29 / 10 * u) * (1 - u * up_time u)); [| apply Rmult_le_compat_l; lra].
  enough (Y : up_w r u - sine_loss u - u * sine_loss u * up_w r u + up_time u + 29 / 10 * u * up_time u < 29 / 10)
    by (apply Rminus_gt_0_lt; eapply Rlt_le_trans; [apply (Rmult_lt_0_compat u); [lra | apply Rlt_Rminus, Y] | right; ring]).
  assert (V : forall m, e <= m -> 0 <= u <= m ^ 2) by (intros m M; unfold u in *; nra).
  decompose [and or] X; match goal with M : e <= ?m |- _ => specialize (V m M) end;
    unfold up_w, sine_loss, up_time; clearbody u; interval with (i_bisect r, i_bisect u).
