intros a b e D P Q A B B1 AB BH; intros; clear - D P Q A B B1 AB BH.
pose proof (defect_boxes a b e A B P Q D B1 AB) as X.
assert (E1 : e <= 42 / 100) by (decompose [and or] X; lra).
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
destruct (phase_between a b e A B P Q) as [P1 P2].
destruct (factors_between a b e A B P Q B1 R4 E1) as [U [_ [_ [_ [W _]]]]].
pose proof (slope_is a b e A B P Q D B1 R4 E1) as SI; pose proof (per_turn_is a b e A B P Q) as TI.
destruct (per_turn_between a b e A B P Q B1 R4 E1) as [T1 [T2 [T0 Q0]]].
destruct (slope_parts a b e A B P Q B1 R4 E1) as [[G1 G2] [Y1 [Y2 [Y0 YT]]]].
match goal with |- ?x > _ /\ ?x < _ => replace x with (/ (4 * b * e) + sqrt b * / ((-1) * b * sin e ^ 2 + 1) * sqrt (a + b * sin e ^ 2) * sin e * turn_slope a b e)
  by (unfold turn_slope; replace (/ (4 * b * e)) with (1 / 4 * / b * / e) by (field; lra); ring) end.
set (r := b * / a) in *; set (k := sqrt (a * b)) in *; set (p := PI + asin _) in *; set (u := e ^ 2) in *.
set (w := sqrt (r * sin e ^ 2 + 1)) in *; set (t := w * sin e * / (1 - b * sin e ^ 2)) in *.
set (y := cos e * sin e * / (1 - b * sin e ^ 2)) in *; set (g := / e - cos e * / sin e) in *.
assert (W0 : 0 <= u * up_w r u) by lra.
assert (T : 0 <= up_time u <= 1) by (unfold up_time; clear - U; clearbody u; nra).
rewrite TI, SI; clear SI TI; clearbody g y t.
assert (q1 : 0 <= u * up_time u <= 1764 / 10000).
{ split; [apply Rmult_le_pos; lra |]; apply Rle_trans with (1764 / 10000 * 1); [apply Rmult_le_compat; lra | lra]. }
assert (ke : 0 < k * e) by (apply Rmult_lt_0_compat; lra).
assert (qb : b * (u * up_time u) <= 1 * (u * up_time u)) by (apply Rmult_le_compat_r; lra).
set (p1 := PI + atan (sqrt r)) in *; pose proof (sqrt_pos r) as r0; pose proof pi_between as PB.
set (ta := (1 - u * sine_loss u) * (1 + u * up_w r u) * / (1 - u * up_time u)).
assert (TT : t <= e * ta).
{ apply (Rmult_le_reg_r (1 - u * up_time u)); [lra |]; unfold ta; apply Rle_trans with (t * (1 - b * (u * up_time u))).
  - apply Rmult_le_compat_l; lra.
  - eapply Rle_trans; [exact T2 |]; right; field; lra. }
assert (ta0 : 0 < ta) by (apply (Rmult_lt_reg_l e); [lra |]; lra).
assert (KP : 0 < k * p) by (apply Rmult_lt_0_compat; lra).
assert (TK : t * (k * p) <= k * e * (ta * p)).
{ replace (k * e * (ta * p)) with (e * ta * (k * p)) by ring; apply Rmult_le_compat_r; lra. }
assert (TP : 0 < t * (k * p)) by (apply Rmult_lt_0_compat; lra).
assert (yb : 0 <= (r + b) * y) by (apply Rmult_le_pos; lra).
assert (Up : g - (r + b) * y + (2 * b + r - 1) * (t * (k * p)) < 63 / 5 * (k * e)).
{ assert (J : (2 * b + r - 1) * (t * (k * p)) <= (1 + r) * (t * (k * p))) by (apply Rmult_le_compat_r; lra).
  assert (J1 : (1 + r) * (t * (k * p)) <= (1 + r) * (k * e * (ta * p))) by (apply Rmult_le_compat_l; lra).
  assert (g1 : e * (1 / 3 + u / 15) <= k * e * (2 * (1 / 3 + u / 15))).
  { replace (k * e * (2 * (1 / 3 + u / 15))) with (2 * k * (e * (1 / 3 + u / 15))) by ring.
    rewrite <- (Rmult_1_l (e * _)) at 1; apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra. }
  destruct (Rle_or_lt r 1) as [L1|L1].
  - assert (V : 2 * (1 / 3 + u / 15) + (1 + r) * (ta * p1) < 63 / 5).
    { unfold ta, p1; clear - R0 L1 U; clearbody u; unfold up_w, sine_loss, up_time; interval with (i_bisect r, i_bisect u). }
    assert ((1 + r) * (ta * p) <= (1 + r) * (ta * p1)) by (apply Rmult_le_compat_l; [lra | apply Rmult_le_compat_l; lra]).
    assert (k * e * (2 * (1 / 3 + u / 15) + (1 + r) * (ta * p)) < k * e * (63 / 5)) by (apply Rmult_lt_compat_l; lra); lra.
  - set (Y := (1 - 2 / 3 * u) * (1 + sqrt r / 2 * (u - u ^ 2 / 3))).
    set (Kr := 1 / 3 + u / 15 - r * Y).
    assert (V : Kr <= 0 /\ sqrt r * (Kr - Y) + (1 + r) * (ta * p) < 63 / 5).
    { unfold p; rewrite (turn_of_share a b e A B); fold r; unfold Kr, Y, ta, u; clear - X L1 R4 P.
      clearbody r; unfold up_w, sine_loss, up_time; decompose [and or] X; try lra;
        split; interval with (i_bisect r, i_bisect e, i_depth 30). }
    destruct V as [V1 V2].
    assert (u2 : 0 <= u - u ^ 2 / 3) by (clear - U; clearbody u; nra).
    assert (kr : sqrt r / 2 <= b) by (rewrite <- KR; assert (1 / 2 * sqrt r <= k * sqrt r) by (apply Rmult_le_compat_r; lra); lra).
    assert (Y3 : e * Y <= y).
    { apply Rle_trans with (2 := Y1); unfold Y; rewrite <- Rmult_assoc; apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |].
      apply Rplus_le_compat_l, Rmult_le_compat_r; lra. }
    assert (Y4 : (r + b) * (e * Y) <= (r + b) * y) by (apply Rmult_le_compat_l; lra).
    assert (Kb : e * Kr <= e * (Kr * b)).
    { apply Rmult_le_compat_l; [lra |]; assert (0 <= - Kr * (1 - b)) by (apply Rmult_le_pos; lra); lra. }
    assert (Z1 : k * e * (sqrt r * (Kr - Y) + (1 + r) * (ta * p)) < k * e * (63 / 5)) by (apply Rmult_lt_compat_l; lra).
    assert (Z2 : k * e * (sqrt r * (Kr - Y)) = e * (Kr * b) - b * (e * Y)) by (rewrite <- KR; ring).
    assert (Z3 : e * (1 / 3 + u / 15) = e * Kr + r * (e * Y)) by (unfold Kr; ring); lra. }
assert (i0 : 0 < / (4 * b)) by positive.
replace (3 / 8 * e * / b * k) with (/ (4 * b) * (3 / 2 * (k * e))) by (field; lra).
replace (63 / 20 * e * / b * k) with (/ (4 * b) * (63 / 5 * (k * e))) by (field; lra).
split; [apply Rmult_lt_compat_l; [exact i0 |] | apply Rmult_lt_compat_l; [exact i0 | exact Up]].
set (V := (2 * b + r - 1) * (k * (157 / 50)) - (r + b)).
assert (k2r : k ^ 2 * r = b ^ 2) by (rewrite K2; unfold r; field; lra).
assert (b2 : 9 / 16 <= b ^ 2) by (clear - BH; nra).
assert (V1 : k ^ 2 * V >= 157 / 100 * k ^ 3 - 3 / 4 * k ^ 2 + 9 / 16 * (157 / 50 * k - 1)).
{ assert (E : k ^ 2 * V = k ^ 2 * ((157 / 25 * k - 1) * b) - 157 / 50 * k ^ 3 + k ^ 2 * r * (157 / 50 * k - 1)) by (unfold V; clearbody k r; field).
  rewrite k2r in E.
  assert ((157 / 25 * k - 1) * (3 / 4) <= (157 / 25 * k - 1) * b) by (apply Rmult_le_compat_l; lra).
  assert (k ^ 2 * ((157 / 25 * k - 1) * (3 / 4)) <= k ^ 2 * ((157 / 25 * k - 1) * b)) by (apply Rmult_le_compat_l; [apply pow2_ge_0 | assumption]).
  assert (9 / 16 * (157 / 50 * k - 1) <= b ^ 2 * (157 / 50 * k - 1)) by (apply Rmult_le_compat_r; lra).
  rewrite E; replace (k ^ 3) with (k ^ 2 * k) by ring; lra. }
assert (k2 : 0 < k ^ 2) by (apply pow_lt; lra).
assert (Pol : 0 < 99 / 100 * (157 / 100 * k ^ 3 - 3 / 4 * k ^ 2 + 9 / 16 * (157 / 50 * k - 1)) + 1 / 3 * k ^ 2 - 3 / 2 * k ^ 3).
{ clear - K; set (x := k - 1 / 2) in *; assert (0 <= x) by (unfold x; lra); replace k with (1 / 2 + x) by (unfold x; ring); clearbody x.
  assert (0 <= x * (x - 3) ^ 2) by (apply Rmult_le_pos; [assumption | apply pow2_ge_0]); nra. }
assert (V2 : 3 / 2 * k < 1 / 3 + 99 / 100 * V).
{ apply (Rmult_lt_reg_l (k ^ 2)); [exact k2 |]; replace (k ^ 2 * (3 / 2 * k)) with (3 / 2 * k ^ 3) by ring.
  rewrite Rmult_plus_distr_l; replace (k ^ 2 * (99 / 100 * V)) with (99 / 100 * (k ^ 2 * V)) by ring; lra. }
assert (V0 : 0 <= V).
{ assert (3 / 2 * (157 / 50 * k) - 3 / 2 + 0 <= 157 / 50 * k * (2 * b)) by (assert (157 / 50 * k * (3 / 2) <= 157 / 50 * k * (2 * b)) by (apply Rmult_le_compat_l; lra); lra).
  unfold V; assert (0 <= r * (157 / 50 * k - 1)) by (apply Rmult_le_pos; lra).
  assert ((157 / 25 * k - 1) * (3 / 4) <= (157 / 25 * k - 1) * b) by (apply Rmult_le_compat_l; lra); lra. }
assert (yl : e * (99 / 100) <= y).
{ apply Rle_trans with (2 := Y1); rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra |].
  assert (u2 : 0 <= u - u ^ 2 / 3) by (clear - U; clearbody u; nra).
  assert (3 / 4 * (u - u ^ 2 / 3) <= b * (u - u ^ 2 / 3)) by (apply Rmult_le_compat_r; lra).
  apply Rle_trans with ((1 - 2 / 3 * u) * (1 + 3 / 4 * (u - u ^ 2 / 3))); [clear - U; clearbody u; interval with (i_bisect u) | apply Rmult_le_compat_l; lra]. }
assert (p3 : 157 / 50 <= p) by (apply Rle_trans with (2 := P1); interval).
assert (yt : y * ((2 * b + r - 1) * (k * (157 / 50))) <= (2 * b + r - 1) * (t * (k * p))).
{ replace ((2 * b + r - 1) * (t * (k * p))) with (t * ((2 * b + r - 1) * (k * p))) by ring.
  apply Rmult_le_compat; [lra | apply Rmult_le_pos; lra | lra |].
  apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; lra. }
assert (e * (99 / 100) * V <= y * V) by (apply Rmult_le_compat_r; lra).
assert (e * (3 / 2 * k) < e * (1 / 3 + 99 / 100 * V)) by (apply Rmult_lt_compat_l; lra).
unfold V in *; lra.
