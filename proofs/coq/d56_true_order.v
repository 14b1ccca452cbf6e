intros a b e D P Q A B B1 AB BH; intros; clear - D P Q A B B1 AB BH.
pose proof (defect_boxes a b e A B P Q D B1 AB) as X.
assert (E1 : e <= 42 / 100) by (decompose [and or] X; lra).
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
destruct (phase_between a b e A B P Q) as [P1 P2].
destruct (factors_between a b e A B P Q B1 R4 E1) as [U [_ [_ [_ [W _]]]]].
destruct (level_part_between a b e A B P Q B1 R4 E1) as [H1 H2].
match goal with |- ?x > _ /\ ?x < _ => replace x with (turn_slope a b e + 1 / 4 * / b * / e ^ 2 * / sqrt (a * b)) by (unfold turn_slope; ring) end.
rewrite (turn_slope_is a b e A B P Q D).
set (r := b * / a) in *; set (k := sqrt (a * b)) in *; set (p := PI + asin _) in *; set (u := e ^ 2) in *.
set (w := sqrt (r * sin e ^ 2 + 1)) in *.
replace (/ (4 * b * k) * _ + _) with (/ (4 * b * k) * (/ u - w * cos e * / sin e ^ 2 + (2 * b + r - 1) * (k * p))) by (field; lra).
set (h := / u - w * cos e * / sin e ^ 2) in *.
assert (W0 : 0 <= u * up_w r u) by lra.
clearbody h w p.
replace (3 / 8 * / b) with (/ (4 * b * k) * (3 / 2 * k)) by (field; lra).
replace (9 / 2 * / b) with (/ (4 * b * k) * (18 * k)) by (field; lra).
assert (V : 0 < / (4 * b * k)) by positive; pose proof pi_between as PB.
enough (3 / 2 * k < h + (2 * b + r - 1) * (k * p) < 18 * k) by (split; apply Rmult_lt_compat_l; lra).
split.
- assert ((1 / 2 + r) * (k * 3) <= (2 * b + r - 1) * (k * p)) by (apply Rmult_le_compat; [lra | lra | lra | apply Rmult_le_compat_l; lra]).
  assert (r * (1 / 2) <= r * k) by (apply Rmult_le_compat_l; lra); lra.
- set (p1 := PI + atan (sqrt r)) in *; assert (p0 : 0 < p1) by lra; pose proof (sqrt_pos r) as q0.
  assert (Y : (2 * b + r - 1) * (k * p) <= k * ((1 + r) * p1)).
  { replace (k * ((1 + r) * p1)) with ((1 + r) * (k * p1)) by ring; apply Rmult_le_compat; [lra | apply Rmult_le_pos; lra | lra | apply Rmult_le_compat_l; lra]. }
  set (H := 1 / 6 + u / 9 - r * (1 - u / 2) * / (2 + u * up_w r u)) in *.
  destruct (Rle_or_lt r 1) as [L1|L1].
  + assert (h <= 1 / 4).
    { assert (0 < / (2 + u * up_w r u)) by (apply Rinv_0_lt_compat; lra).
      assert (0 <= r * (1 - u / 2) * / (2 + u * up_w r u)) by (apply Rmult_le_pos; [apply Rmult_le_pos |]; lra); unfold H in H2; lra. }
    assert (p1 <= 5) by (unfold p1; clear - R0 L1; interval).
    assert ((1 + r) * p1 <= 10) by (apply Rle_trans with ((1 + 1) * 5); [apply Rmult_le_compat; lra | lra]).
    assert (k * ((1 + r) * p1) <= k * 10) by (apply Rmult_le_compat_l; lra); lra.
  + assert (Z : H <= 0 /\ H * sqrt r + (1 + r) * p1 < 18).
    { unfold H, p1; clear - X L1 R4 P.
      assert (Vm : forall m, e <= m -> 0 <= u <= m ^ 2) by (intros m M; unfold u; split; [apply pow2_ge_0 | apply pow_incr; lra]).
      decompose [and or] X; try lra; match goal with M : e <= ?m |- _ => specialize (Vm m M) end;
        unfold up_w, up_time; clearbody u; split; interval with (i_bisect r, i_bisect u). }
    destruct Z as [Z1 Z2]; assert (H <= k * (H * sqrt r)).
    { replace (k * (H * sqrt r)) with (H * b) by (rewrite <- KR; ring); nra. }
    assert (k * (H * sqrt r + (1 + r) * p1) < k * 18) by (apply Rmult_lt_compat_l; lra); lra.
