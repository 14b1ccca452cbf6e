intros a b e D P Q A B B1 AB; intros; clear - D P Q A B B1 AB.
pose proof (defect_boxes a b e A B P Q D B1 AB) as X.
assert (E1 : e <= 42 / 100) by (decompose [and or] X; lra).
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
destruct (phase_between a b e A B P Q) as [P1 P2].
destruct (factors_between a b e A B P Q B1 R4 E1) as [U [_ [_ [_ [W _]]]]].
pose proof (corner_bound a b e A B P Q D B1 AB) as Z.
pose proof (phase_below_log a b e A B P Q D B1 R4 E1) as L.
pose proof (slope_is a b e A B P Q D B1 R4 E1) as SI; pose proof (per_turn_is a b e A B P Q) as TI.
destruct (per_turn_between a b e A B P Q B1 R4 E1) as [T1 [T2 [T0 Q0]]].
destruct (slope_parts a b e A B P Q B1 R4 E1) as [[G1 G2] [Y1 [Y2 [Y0 YT]]]].
match goal with |- Rabs ?x <= _ => replace x with (/ (4 * b * e) + sqrt b * / ((-1) * b * sin e ^ 2 + 1) * sqrt (a + b * sin e ^ 2) * sin e * turn_slope a b e)
  by (unfold turn_slope; replace (/ (4 * b * e)) with (1 / 4 * / b * / e) by (field; lra); ring) end.
set (r := b * / a) in *; set (k := sqrt (a * b)) in *; set (p := PI + asin _) in *; set (u := e ^ 2) in *.
set (w := sqrt (r * sin e ^ 2 + 1)) in *; set (t := w * sin e * / (1 - b * sin e ^ 2)) in *.
set (y := cos e * sin e * / (1 - b * sin e ^ 2)) in *; set (g := / e - cos e * / sin e) in *.
assert (W0 : 0 <= u * up_w r u) by lra.
assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
rewrite TI, SI; clear SI TI; clearbody g y t w p.
rewrite Rabs_mult, Rabs_pos_eq by (left; positive).
replace (9 / 50 * / b) with (/ (4 * b) * (72 / 100)) by (field; lra).
apply Rmult_le_compat_l; [left; positive |].
assert (KP : 3 / 2 <= k * p) by (pose proof pi_between; apply Rle_trans with (1 / 2 * 3); [lra | apply Rmult_le_compat; lra]).
assert (EC : forall c, 2 * k * e <= c -> e <= c).
{ intros c Hc; apply Rle_trans with (2 := Hc); rewrite <- (Rmult_1_l e) at 1; apply Rmult_le_compat_r; lra. }
assert (Next : forall m n, e <= m -> m <= PI / 2 -> corner_defect m r <= n -> e <= n)
  by (intros m n M M1 N; destruct (Z m M M1) as [N1 _]; pose proof (EC _ N1); lra).
assert (BE : forall c, 2 * k * e <= c -> b * e <= c * sqrt r / 2).
{ intros c Hc; rewrite <- KR; pose proof (sqrt_pos r); replace (k * sqrt r * e) with (sqrt r / 2 * (2 * k * e)) by field.
  replace (c * sqrt r / 2) with (sqrt r / 2 * c) by field; apply Rmult_le_compat_l; lra. }
assert (q1 : 0 <= u * up_time u <= 1764 / 10000).
{ split; [apply Rmult_le_pos; lra |]; apply Rle_trans with (1764 / 10000 * 1); [apply Rmult_le_compat; lra | lra]. }
assert (ke : 0 < k * e) by (apply Rmult_lt_0_compat; lra).
assert (E2 : 1 <= r -> e <= 213 / 1000)
  by (intros L1; apply (Next (42 / 100)); [lra | interval | clear - L1 R4; corner_by; interval with (i_bisect r)]).
apply Rabs_le; split.
- destruct (Rle_or_lt 0 (2 * b + r - 1)) as [J|J].
  + assert (0 <= (2 * b + r - 1) * (t * (k * p))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
    enough ((r + b) * y <= 72 / 100) by (assert (0 < e * (1 / 3)) by lra; lra).
    assert (y * (1 - 1764 / 10000) <= e).
    { apply Rle_trans with (2 := Y2), Rmult_le_compat_l; [lra |]; assert (b * (u * up_time u) <= 1 * (u * up_time u)) by (apply Rmult_le_compat_r; lra); lra. }
    assert (Part : forall m, e <= m -> m <= PI / 2 -> (r + sqrt r / 2) * corner_defect m r * (10000 / 8236) <= 72 / 100 -> (r + b) * y <= 72 / 100).
    { intros m M M1 V; destruct (Z m M M1) as [Z1 Z0]; set (c := corner_defect m r) in *; pose proof (sqrt_pos r).
      pose proof (BE c Z1); assert (r * e <= r * c) by (apply Rmult_le_compat_l; [lra | apply EC, Z1]).
      apply Rle_trans with ((r + b) * (e * (10000 / 8236))); [apply Rmult_le_compat_l; lra | lra]. }
    destruct (Rle_or_lt r 1) as [L1|L1].
    * apply (Part (42 / 100)); [lra | interval | clear - R0 L1; corner_by; interval with (i_bisect r)].
    * apply (Part (213 / 1000)); [apply E2; lra | interval | clear - R4 L1; corner_by; interval with (i_bisect r)].
  + assert (L1 : r <= 1) by lra; destruct (Z (42 / 100) ltac:(lra) ltac:(interval)) as [Z1 Z0].
    assert (V : forall v, 0 <= v <= 1764 / 10000 -> (r + sqrt r / 2) * corner_defect (42 / 100) r * (100 / 91)
      + (1 - r) * (1 + v * up_w r v) * (corner_defect (42 / 100) r / 2 * (PI + atan (sqrt r))) <= 72 / 100)
      by (clear - R0 L1; intros v Hv; unfold up_w; corner_by; interval with (i_bisect r, i_bisect v)).
    specialize (V u ltac:(lra)); set (c := corner_defect _ r) in *; set (p1 := PI + atan (sqrt r)) in *; pose proof (sqrt_pos r).
    set (q := b * (u * up_time u)) in *; assert (qb : 0 <= q <= b * (1764 / 10000)) by (unfold q; split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]).
    assert (y * (91 / 100) <= e) by (apply Rle_trans with (2 := Y2), Rmult_le_compat_l; lra).
    pose proof (BE c Z1); assert (r * e <= r * c) by (apply Rmult_le_compat_l; [lra | apply EC, Z1]).
    assert ((r + b) * y <= (r + sqrt r / 2) * c * (100 / 91))
      by (apply Rle_trans with ((r + b) * (e * (100 / 91))); [apply Rmult_le_compat_l; lra | lra]).
    assert (EP : e * (k * p) <= c / 2 * p1) by (replace (e * (k * p)) with (2 * k * e / 2 * p) by field; apply Rmult_le_compat; lra).
    assert (s1 : 0 <= u * sine_loss u) by (unfold sine_loss; apply Rmult_le_pos; lra).
    assert (s0 : e * (1 - u * sine_loss u) <= e * 1) by (apply Rmult_le_compat_l; lra); rewrite Rmult_1_r in s0.
    assert (TE : t * (1 - q) <= e * (1 + u * up_w r u)) by (apply Rle_trans with (1 := T2); apply Rmult_le_compat_r; lra).
    assert (J2 : 1 - 2 * b - r <= (1 - r) * (1 - q)) by (assert (0 <= r * q) by (apply Rmult_le_pos; lra); lra).
    assert (F : (1 - 2 * b - r) * t <= (1 - r) * (e * (1 + u * up_w r u))).
    { apply Rle_trans with ((1 - r) * (1 - q) * t); [apply Rmult_le_compat_r; lra |].
      rewrite Rmult_assoc, (Rmult_comm (1 - q)); apply Rmult_le_compat_l; lra. }
    assert ((1 - 2 * b - r) * t * (k * p) <= (1 - r) * (1 + u * up_w r u) * (c / 2 * p1)).
    { apply Rle_trans with ((1 - r) * (e * (1 + u * up_w r u)) * (k * p)); [apply Rmult_le_compat_r; lra |].
      replace ((1 - r) * (e * (1 + u * up_w r u)) * (k * p)) with ((1 - r) * (1 + u * up_w r u) * (e * (k * p))) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact EP]. }
    assert (0 < e * (1 / 3)) by lra; lra.
- destruct (Rle_or_lt (2 * b + r - 1) 0) as [J|J].
  { assert (0 <= t * (k * p)) by (apply Rmult_le_pos; lra); assert (0 <= - (2 * b + r - 1) * (t * (k * p))) by (apply Rmult_le_pos; lra).
    assert (0 <= (r + b) * y) by (apply Rmult_le_pos; lra); assert (e * (1 / 3 + u / 15) <= 42 / 100 * (1 / 2)) by (apply Rmult_le_compat; lra); lra. }
  set (ta := (1 - u * sine_loss u) * (1 + u * up_w r u) * / (1 - u * up_time u)).
  assert (TT : t <= e * ta).
  { apply (Rmult_le_reg_r (1 - u * up_time u)); [lra |]; unfold ta; apply Rle_trans with (t * (1 - b * (u * up_time u))).
    - apply Rmult_le_compat_l; [lra |]; assert (b * (u * up_time u) <= 1 * (u * up_time u)) by (apply Rmult_le_compat_r; lra); lra.
    - eapply Rle_trans; [exact T2 |]; right; field; lra. }
  assert (sl : 0 <= u * sine_loss u <= 1 / 30).
  { unfold sine_loss; split; [apply Rmult_le_pos; lra | apply Rle_trans with (1764 / 10000 * (1 / 6)); [apply Rmult_le_compat; lra | lra]]. }
  assert (t1 : 9 / 10 <= ta).
  { unfold ta; assert (1 <= / (1 - u * up_time u)) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
    apply Rle_trans with (29 / 30 * 1 * 1); [lra |]; apply Rmult_le_compat; try lra; apply Rmult_le_compat; lra. }
  assert (Y3 : e * (1 - 2 / 3 * u) <= y).
  { apply Rle_trans with (2 := Y1); rewrite <- (Rmult_1_r (e * _)) at 1; apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |].
    assert (0 <= b * (u - u ^ 2 / 3)) by (apply Rmult_le_pos; [lra | nra]); lra. }
  set (z := e * (k * p)); assert (z0 : 3 / 2 * e <= z) by (unfold z; rewrite (Rmult_comm e); apply Rmult_le_compat_r; lra).
  assert (Main : g - (r + b) * y + (2 * b + r - 1) * (t * (k * p)) <= e * (1 / 3 + u / 15 - (r + 1) * (1 - 2 / 3 * u)) + (1 + r) * ta * z).
  { assert (t * (k * p) <= ta * z) by (unfold z; replace (ta * (e * (k * p))) with (e * ta * (k * p)) by ring; apply Rmult_le_compat_r; lra).
    assert ((2 * b + r - 1) * (t * (k * p)) <= (2 * b + r - 1) * (ta * z)) by (apply Rmult_le_compat_l; lra).
    assert ((r + b) * (e * (1 - 2 / 3 * u)) <= (r + b) * y) by (apply Rmult_le_compat_l; lra).
    assert (e <= ta * z) by (apply Rle_trans with (9 / 10 * (3 / 2 * e)); [lra | apply Rmult_le_compat; lra]).
    assert (e * (1 - 2 / 3 * u) <= e * 1) by (apply Rmult_le_compat_l; lra).
    assert (0 <= (1 - b) * (2 * (ta * z) - e * (1 - 2 / 3 * u))) by (apply Rmult_le_pos; lra); lra. }
  assert (Part : forall m, e <= m -> m <= PI / 2 ->
    (forall s, 0 <= s <= 1 -> let c := corner_defect m r in let v := (s * c) ^ 2 in
      s * c * (1 / 3 + v / 15 - (r + 1) * (1 - 2 / 3 * v))
      + (1 + r) * ((1 - v * sine_loss v) * (1 + v * up_w r v) * / (1 - v * up_time v)) * c
        * (s * (ln (2 * / (sqrt (r + 1) * c)) + v * (up_root r v + up_sine v) - 1) + 1) <= 72 / 100) ->
    g - (r + b) * y + (2 * b + r - 1) * (t * (k * p)) <= 72 / 100).
  { intros m M M1 G; destruct (Z m M M1) as [Z1 Z0]; set (c := corner_defect m r) in *; pose proof (EC c Z1).
    assert (Hs : 0 <= e * / c <= 1).
    { split; [left; positive |]; apply (Rmult_le_reg_r c); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra. }
    specialize (G (e * / c) Hs); cbv zeta in G; replace (e * / c * c) with e in G by (field; lra); fold u in G; fold ta in G.
    assert (q2 : 0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra).
    assert (LC : ln (2 * / (sqrt (r + 1) * e)) <= ln (2 * / (sqrt (r + 1) * c)) + c * / e - 1).
    { replace (2 * / (sqrt (r + 1) * e)) with (2 * / (sqrt (r + 1) * c) * (c * / e)) by (field; lra).
      rewrite ln_mult by positive; pose proof (ln_below (c * / e) ltac:(positive)); lra. }
    set (l1 := ln (2 * / (sqrt (r + 1) * c))) in *; set (rs := up_root r u + up_sine u) in *.
    assert (EL : z <= e * (l1 + u * rs - 1) + c).
    { unfold z; apply Rle_trans with (e * (l1 + c * / e - 1 + u * rs)); [apply Rmult_le_compat_l; lra |].
      right; field; lra. }
    replace ((1 + r) * ta * c * (e * / c * (l1 + u * rs - 1) + 1)) with ((1 + r) * ta * (e * (l1 + u * rs - 1) + c)) in G by (field; lra).
    assert ((1 + r) * ta * z <= (1 + r) * ta * (e * (l1 + u * rs - 1) + c)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos |]; lra); lra. }
  clear - Part E2 R0 R4 E1.
  destruct (Rle_or_lt r 1) as [L1|L1].
  { apply (Part (42 / 100)); [lra | interval |]; intros s Hs; unfold up_w, sine_loss; corner_by.
    interval with (i_bisect r, i_bisect s, i_depth 30). }
  apply (Part (213 / 1000)); [apply E2; lra | interval |]; intros s Hs; unfold up_w, sine_loss; corner_by.
  interval with (i_bisect r, i_bisect s, i_depth 30).
