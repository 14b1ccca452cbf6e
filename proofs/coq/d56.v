intros a b e D P Q A B B1 AB; intros; clear - D P Q A B B1 AB.
pose proof (defect_boxes a b e A B P Q D B1 AB) as X.
assert (E1 : e <= 42 / 100) by (decompose [and or] X; lra).
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
destruct (phase_between a b e A B P Q) as [P1 P2].
destruct (factors_between a b e A B P Q B1 R4 E1) as [U [_ [_ [_ [W _]]]]].
pose proof (corner_bound a b e A B P Q D B1 AB) as Z.
pose proof (phase_below_log a b e A B P Q D B1 R4 E1) as L.
destruct (level_part_between a b e A B P Q B1 R4 E1) as [H1 H2].
match goal with |- Rabs ?x <= _ => replace x with (turn_slope a b e + 1 / 4 * / b * / e ^ 2 * / sqrt (a * b)) by (unfold turn_slope; ring) end.
rewrite (turn_slope_is a b e A B P Q D).
set (r := b * / a) in *; set (k := sqrt (a * b)) in *; set (p := PI + asin _) in *; set (u := e ^ 2) in *.
set (w := sqrt (r * sin e ^ 2 + 1)) in *.
replace (/ (4 * b * k) * _ + _) with (/ (4 * b * k) * (/ u - w * cos e * / sin e ^ 2 + (2 * b + r - 1) * (k * p))) by (field; lra).
set (h := / u - w * cos e * / sin e ^ 2) in *.
assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
assert (W0 : 0 <= u * up_w r u) by lra.
clearbody h w p.
rewrite Rabs_mult, Rabs_pos_eq by (left; positive).
replace (6 / 25 * / b * / e * / k) with (/ (4 * b * k) * (96 / 100 * / e)) by (field; lra).
apply Rmult_le_compat_l; [left; positive |].
assert (H0 : 0 < / (2 + u * up_w r u)) by (apply Rinv_0_lt_compat; lra).
assert (h0 : h <= 1 / 6 + u / 9) by (assert (0 <= r * (1 - u / 2) * / (2 + u * up_w r u)) by (apply Rmult_le_pos; [apply Rmult_le_pos |]; lra); lra).
assert (KP : 0 < k * p) by (apply Rmult_lt_0_compat; lra).
enough (Y : - (96 / 100) <= e * (h + (2 * b + r - 1) * (k * p)) <= 96 / 100).
{ assert (0 < / e) by positive; set (z := h + _) in *; replace z with (e * z * / e) by (field; lra).
  apply Rabs_le; split; [rewrite Ropp_mult_distr_l |]; apply Rmult_le_compat_r; lra. }
assert (Next : forall m n, e <= m -> m <= PI / 2 -> corner_defect m r <= n -> e <= n)
  by (intros m n M M1 N; destruct (Z m M M1); nra).
split.
- assert (e * (r / 2 - 1 / 6) <= 96 / 100) by (clear - X P R0; decompose [and or] X; nra).
  destruct (Rle_or_lt 0 (2 * b + r - 1)) as [J|J].
  + assert (0 <= (2 * b + r - 1) * (k * p)) by (apply Rmult_le_pos; lra); nra.
  + destruct (Z (42 / 100) ltac:(lra) ltac:(interval)) as [Z1 Z0].
    assert (V : (1 - r) * (corner_defect (42 / 100) r / 2 * (PI + atan (sqrt r))) <= 82 / 100)
      by (assert (Hr : r <= 1) by lra; clear - R0 Hr; corner_by; interval with (i_bisect r)).
    set (c := corner_defect _ r) in *; assert (0 < p <= PI + atan (sqrt r)) by lra; set (p1 := PI + atan (sqrt r)) in *.
    assert (e * (k * p) <= c / 2 * p1) by (replace (e * (k * p)) with (2 * k * e / 2 * p) by field; apply Rmult_le_compat; lra || nra).
    assert (0 <= e * (k * p)) by nra.
    assert ((1 - 2 * b - r) * (e * (k * p)) <= (1 - r) * (c / 2 * p1)) by (apply Rmult_le_compat; lra).
    assert (e * (1 / 6 - r / 2) <= e * h) by (apply Rmult_le_compat_l; lra).
    assert (e * (1 / 6 - r / 2) >= - (14 / 100)) by (assert (r <= 1) by lra; nra); nra.
- destruct (Rle_or_lt (2 * b + r - 1) 0) as [J|J].
  { assert ((2 * b + r - 1) * (k * p) <= 0) by nra; assert (h + (2 * b + r - 1) * (k * p) <= 1 / 2) by lra; nra. }
  assert (Part : forall m, e <= m -> m <= PI / 2 ->
    (forall s, 0 <= s <= 1 -> let c := corner_defect m r in let v := (s * c) ^ 2 in
      s * c * (1 / 6 + v / 9 - r * (1 - v / 2) * / (2 + v * up_w r v))
      + (1 + r) * c * (s * (ln (2 * / (sqrt (r + 1) * c)) + v * (up_root r v + up_sine v) - 1) + 1) <= 96 / 100) ->
    e * (h + (2 * b + r - 1) * (k * p)) <= 96 / 100).
  { intros m M M1 G; destruct (Z m M M1) as [Z1 Z0]; set (c := corner_defect m r) in *; assert (e <= c) by nra.
    assert (Hs : 0 <= e * / c <= 1).
    { split; [left; positive |]; apply (Rmult_le_reg_r c); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra. }
    specialize (G (e * / c) Hs); cbv zeta in G; replace (e * / c * c) with e in G by (field; lra); fold u in G.
    assert (Q1 : 0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra).
    assert (LC : ln (2 * / (sqrt (r + 1) * e)) <= ln (2 * / (sqrt (r + 1) * c)) + c * / e - 1).
    { replace (2 * / (sqrt (r + 1) * e)) with (2 * / (sqrt (r + 1) * c) * (c * / e)) by (field; lra).
      rewrite ln_mult by positive; pose proof (ln_below (c * / e) ltac:(positive)); lra. }
    set (l1 := ln (2 * / (sqrt (r + 1) * c))) in *; set (rs := up_root r u + up_sine u) in *.
    assert (EL : e * (k * p) <= e * (l1 + u * rs - 1) + c).
    { apply Rle_trans with (e * (l1 + c * / e - 1 + u * rs)); [apply Rmult_le_compat_l; lra |].
      right; field; lra. }
    replace ((1 + r) * c * (e * / c * (l1 + u * rs - 1) + 1)) with ((1 + r) * (e * (l1 + u * rs - 1) + c)) in G by (field; lra).
    assert (e * h <= e * (1 / 6 + u / 9 - r * (1 - u / 2) * / (2 + u * up_w r u))) by (apply Rmult_le_compat_l; lra).
    assert (0 < e * (k * p)) by (apply Rmult_lt_0_compat; lra).
    assert ((2 * b + r - 1) * (e * (k * p)) <= (1 + r) * (e * (l1 + u * rs - 1) + c)) by (apply Rmult_le_compat; lra).
    replace (e * (h + (2 * b + r - 1) * (k * p))) with (e * h + (2 * b + r - 1) * (e * (k * p))) by ring; lra. }
  clear - Part Next R0 R4 E1.
  destruct (Rle_or_lt r 1) as [L1|L1].
  { apply (Part (42 / 100)); [lra | interval |]; intros s Hs; unfold up_w; corner_by.
    interval with (i_bisect r, i_bisect s, i_depth 30). }
  assert (E2 : e <= 213 / 1000) by (apply (Next (42 / 100)); [lra | interval | corner_by; interval with (i_bisect r)]).
  destruct (Rle_or_lt r 3) as [L2|L2].
  { apply (Part (213 / 1000)); [lra | interval |]; intros s Hs; unfold up_w; corner_by.
    interval with (i_bisect r, i_bisect s, i_depth 30). }
  assert (E3 : e <= 135 / 1000) by (apply (Next (213 / 1000)); [lra | interval | corner_by; interval with (i_bisect r)]).
  destruct (Rle_or_lt r (36 / 10)) as [L3|L3].
  { apply (Part (135 / 1000)); [lra | interval |]; intros s Hs; unfold up_w; corner_by.
    interval with (i_bisect r, i_bisect s, i_depth 30). }
  assert (E4 : e <= 116 / 1000) by (apply (Next (135 / 1000)); [lra | interval | corner_by; interval with (i_bisect r)]).
  apply (Part (116 / 1000)); [lra | interval |]; intros s Hs; unfold up_w; corner_by.
  interval with (i_bisect r, i_bisect s, i_depth 30).
