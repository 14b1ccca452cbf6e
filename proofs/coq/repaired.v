intros a b e s D E P Q A B B1 AB N; pose proof PI_RGT_0 as PP.
set (r := b * / a); set (k := sqrt (a * b)); set (p := PI + asin (sqrt (b * / (a + b)) * cos e)).
assert (I : 0 < / a) by positive; assert (R0 : 0 < r) by (unfold r; positive).
assert (R4 : r <= 4).
{ unfold r; apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; nra. }
assert (K : 1 / 2 <= k) by (apply below_sqrt; lra).
assert (KR : k * sqrt r = b) by (apply product_root; lra).
assert (Step : forall l M, 0 <= l -> l <= r -> e <= M -> M <= PI / 2 ->
  e <= atan (/ (sqrt (l + 1) * sinh ((PI + asin (sqrt (l * / (l + 1)) * cos M)) / 2)))).
{ intros l M L LR EM M1.
  assert (Z : 0 < p).
  { unfold p; pose proof (asin_bound (sqrt (b * / (a + b)) * cos e)); lra. }
  assert (Y : e = atan (/ sqrt (r + 1) * / sinh (p * k))).
  { apply (claim_defect_by_phase p a b e); trivial; try lra; try nra; fold r; try lra.
    fold k; apply Rgt_not_eq, sinh_pos; nra. }
  assert (V : 0 <= l * / (l + 1) <= b * / (a + b)).
  { replace (b * / (a + b)) with (r * / (r + 1)) by (unfold r; field; lra).
    assert (0 < / (l + 1)) by positive; split; [nra |].
    apply (Rmult_le_reg_r ((l + 1) * (r + 1))); [nra |].
    replace (l * / (l + 1) * ((l + 1) * (r + 1))) with (l * (r + 1)) by (field; lra).
    replace (r * / (r + 1) * ((l + 1) * (r + 1))) with (r * (l + 1)) by (field; lra); nra. }
  assert (C : 0 <= cos M <= cos e) by (split; [apply cos_ge_0; lra | apply cos_decr_1; lra]).
  pose proof (share_below a b e A B) as [_ S1].
  assert (X : sqrt (l * / (l + 1)) * cos M <= sqrt (b * / (a + b)) * cos e).
  { apply Rmult_le_compat; [apply sqrt_pos | lra | apply sqrt_le_1_alt, V | lra]. }
  assert (X0 : 0 <= sqrt (l * / (l + 1)) * cos M) by (pose proof (sqrt_pos (l * / (l + 1))); nra).
  assert (T : asin (sqrt (l * / (l + 1)) * cos M) <= asin (sqrt (b * / (a + b)) * cos e)).
  { destruct X as [X|X]; [left; apply asin_rises; lra | rewrite X; lra]. }
  assert (T0 : 0 <= asin (sqrt (l * / (l + 1)) * cos M)).
  { destruct X0 as [X0|X0]; [left; apply asin_above; exact X0 | rewrite <- X0, asin_0; lra]. }
  rewrite Y at 1; apply arctangent_rises; rewrite <- Rinv_mult; apply Rinv_le_contravar.
  - apply Rmult_lt_0_compat; [apply sqrt_lt_R0; lra | apply sinh_pos; lra].
  - apply Rmult_le_compat; [apply sqrt_pos | left; apply sinh_pos; lra | apply sqrt_le_1_alt; lra |].
    apply sinh_grows; assert (G : PI + asin (sqrt (l * / (l + 1)) * cos M) <= p) by (unfold p; lra).
    apply Rle_trans with (p / 2); [lra | nra]. }
assert (E0 : e <= 42 / 100).
{ eapply Rle_trans; [apply (Step 0 (PI / 2)); lra | unfold sinh; inverse_sines; interval]. }
pose proof pi_between as PB.
assert (U : up_all r (e ^ 2) * (1 + e ^ 2 * up_all r (e ^ 2)) ^ 2 <= 1451 / 1000).
{ assert (0 <= e ^ 2) by nra.
  destruct (Rle_or_lt (399 / 100) r) as [L|L]; [| destruct (Rle_or_lt (39 / 10) r) as [L'|L'];
    [| destruct (Rle_or_lt (35 / 10) r) as [M|M]; [| destruct (Rle_or_lt 3 r) as [M'|M'];
    [| destruct (Rle_or_lt 2 r) as [O|O]; [| destruct (Rle_or_lt 1 r) as [O'|O']]]]]].
  - assert (X : e <= 121 / 1000) by sharper Step (399 / 100) (42 / 100).
    assert (Y : e <= 1091 / 10000) by sharper Step (399 / 100) (121 / 1000).
    assert (Z : e <= 1089 / 10000) by sharper Step (399 / 100) (1091 / 10000).
    all_below (1089 / 10000).
  - assert (X : e <= 122 / 1000) by sharper Step (39 / 10) (42 / 100).
    assert (Y : e <= 1104 / 10000) by sharper Step (39 / 10) (122 / 1000).
    assert (Z : e <= 1102 / 10000) by sharper Step (39 / 10) (1104 / 10000).
    all_below (1102 / 10000).
  - assert (X : e <= 129 / 1000) by sharper Step (35 / 10) (42 / 100).
    assert (Y : e <= 1165 / 10000) by sharper Step (35 / 10) (129 / 1000).
    all_below (1165 / 10000).
  - assert (X : e <= 138 / 1000) by sharper Step 3 (42 / 100).
    all_below (138 / 1000).
  - assert (X : e <= 164 / 1000) by sharper Step 2 (42 / 100).
    all_below (164 / 1000).
  - assert (X : e <= 213 / 1000) by sharper Step 1 (42 / 100).
    all_below (213 / 1000).
  - all_below (42 / 100). }
pose proof (claim_leading_by_defect _ a b e s D E P Q (fun _ _ _ _ => eq_refl)
  ltac:(lra) ltac:(lra) ltac:(lra)) as L.
destruct (ratio_below b r k e) as [X Y]; try lra; unfold r, k in X, Y; set (q := _ + ln _ + ln _) in X, Y, L.
rewrite L; replace ((-1) * q) with (- q) by ring; rewrite exp_Ropp.
pose proof (exp_pos q) as Z; set (x := exp q) in *; fold r in X.
replace (e * / (e * / x) + -1) with (x - 1) by (field; lra).
apply (Rmult_le_reg_r (x ^ 2)); [nra |].
replace (1451 / 1000 * (e * / x) ^ 2 * x ^ 2) with (1451 / 1000 * e ^ 2) by (field; lra).
assert (u0 : 0 < e ^ 2) by nra; set (u := e ^ 2) in *; set (A' := up_all r u) in *.
destruct (Rle_or_lt 1 x) as [H|H].
- rewrite Rabs_pos_eq by lra; apply Rle_trans with (u * A' * (1 + u * A') ^ 2); [| nra].
  apply Rmult_le_compat; [lra | nra | lra | apply pow_incr; lra].
- rewrite Rabs_left by lra; assert (x ^ 2 <= 1) by nra; assert (0 <= x ^ 2) by nra; nra.
