intros a b e D P Q A B B1 AB; intros.
replace (e * sqrt (a * b) + _) with (e * sqrt (a * b) - sqrt b * / ((-1) * b * sin e ^ 2 + 1) * sqrt (a + b * sin e ^ 2) * sin e) by ring.
rewrite (per_turn_is a b e A B P Q).
pose proof (defect_boxes a b e A B P Q D B1 AB) as X.
assert (E1 : e <= 42 / 100) by (decompose [and or] X; lra); clear X.
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
destruct (per_turn_between a b e A B P Q B1 R4 E1) as [L [U [T0 T1]]].
pose proof (corner_bound a b e A B P Q D B1 AB) as Z.
set (r := b * / a) in *; set (k := sqrt (a * b)) in *; set (t := sqrt _ * _ * _) in *; clearbody t.
replace (e * k - k * t) with (k * (e - t)) by ring.
rewrite Rabs_mult, (Rabs_pos_eq k) by lra.
replace (31 / 100 * e ^ 2 * k) with (k * (31 / 100 * e ^ 2)) by ring; apply Rmult_le_compat_l; [lra |].
set (u := e ^ 2) in *; assert (u0 : 0 < u <= 1764 / 10000) by (unfold u; nra); apply Rabs_le; split.
- enough (t <= e + 31 / 100 * u) by lra.
  set (q := b * (u * up_time u)) in *; apply (Rmult_le_reg_r (1 - q)); [lra |].
  eapply Rle_trans; [exact U |]; unfold q.
  assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
  assert (Part : forall m, e <= m -> m <= PI / 2 ->
    (forall s, 0 <= s <= 1 -> let c := corner_defect m r in let v := (s * c) ^ 2 in
      s * c * (up_w r v - sine_loss v - v * sine_loss v * up_w r v) + c * sqrt r / 2 * up_time v * (1 + 31 / 100 * (s * c)) <= 31 / 100) ->
    e * (1 - u * sine_loss u) * (1 + u * up_w r u) <= (e + 31 / 100 * u) * (1 - b * (u * up_time u))).
  { intros m M M1 G; destruct (Z m M M1) as [Z1 Z0]; set (c := corner_defect m r) in *.
    assert (J : 0 <= e * / c <= 1).
    { split; [left; positive |]; apply (Rmult_le_reg_r c); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; nra. }
    specialize (G (e * / c) J); cbv zeta in G; replace (e * / c * c) with e in G by (field; lra); fold u in G.
    assert (be : b * e <= c * sqrt r / 2) by (rewrite <- KR; pose proof (sqrt_pos r); nra).
    assert (b * e * (up_time u * (1 + 31 / 100 * e)) <= c * sqrt r / 2 * (up_time u * (1 + 31 / 100 * e)))
      by (apply Rmult_le_compat_r; [nra | exact be]).
    enough (0 <= u * (31 / 100 - (e * (up_w r u - sine_loss u - u * sine_loss u * up_w r u) + b * e * (up_time u * (1 + 31 / 100 * e))))) as Y
      by (unfold u in *; nra).
    apply Rmult_le_pos; lra. }
  assert (Next : forall m n, e <= m -> m <= PI / 2 -> corner_defect m r <= n -> e <= n)
    by (intros m n M M1 N; destruct (Z m M M1); nra).
  clear - Part Next R0 R4 E1.
  destruct (Rle_or_lt r 1) as [L1|L1].
  { apply (Part (42 / 100)); [lra | interval |]; intros s S; unfold up_w, sine_loss, up_time; corner_by.
    interval with (i_bisect r, i_bisect s). }
  assert (E2 : e <= 213 / 1000) by (apply (Next (42 / 100)); [lra | interval | corner_by; interval with (i_bisect r)]).
  destruct (Rle_or_lt r 3) as [L2|L2].
  { apply (Part (213 / 1000)); [lra | interval |]; intros s S; unfold up_w, sine_loss, up_time; corner_by.
    interval with (i_bisect r, i_bisect s). }
  assert (E3 : e <= 135 / 1000) by (apply (Next (213 / 1000)); [lra | interval | corner_by; interval with (i_bisect r)]).
  apply (Part (135 / 1000)); [lra | interval |]; intros s S; unfold up_w, sine_loss, up_time; corner_by.
  interval with (i_bisect r, i_bisect s, i_depth 30).
- enough (e - 31 / 100 * u <= t) by lra; eapply Rle_trans; [| exact L].
  assert (0 <= u - u ^ 2 / 3) by nra; assert (0 <= b * (u - u ^ 2 / 3)) by nra.
  assert (0 <= e * (1 - u / 6)) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (e * (1 - u / 6) * 1); [unfold u; nra | apply Rmult_le_compat_l; lra].
