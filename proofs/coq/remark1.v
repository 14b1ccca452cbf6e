intros a b e D P Q A B B1 AB; intros.
pose proof (claim_leading_by_defect _ a b e _ eq_refl D P Q (fun _ _ _ _ => eq_refl) A B B1) as L.
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
pose proof (defect_by_exp a b e A B P Q D) as U; pose proof PI_RGT_0 as J.
pose proof (defect_boxes a b e A B P Q D B1 AB) as X; set (r := b * / a) in *; set (k := sqrt (a * b)) in *.
pose proof (exp_pos (PI * k)) as Z.
assert (I : exp (- (PI * k)) * exp (PI * k) = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
split; [| nra].
assert (E42 : e <= 42 / 100) by (decompose [and or] X; lra).
pose proof (ratio_above b r k e B B1 R0 R4 K0 KR P E42) as V.
destruct (ratio_below b r k e) as [_ V']; try lra.
set (q := k * asin _ + _ + _) in *; rewrite (inverse_root a b) in L by lra; fold r in L.
rewrite (turn_from_top a b) in L by lra; fold r in L; clearbody r k.
assert (q0 : 0 < sqrt r) by (apply sqrt_lt_R0; lra).
assert (T : k * atan (sqrt r) <= atan (sqrt r) / sqrt r).
{ pose proof (atan_above _ q0); apply (Rmult_le_reg_r (sqrt r)); [exact q0 |].
  replace (atan (sqrt r) / sqrt r * sqrt r) with (atan (sqrt r)) by (field; lra).
  replace (k * atan (sqrt r) * sqrt r) with (k * sqrt r * atan (sqrt r)) by ring; rewrite KR; nra. }
assert (W : e * exp (PI * k) = exp q * (2 * / sqrt (r + 1) * exp (- (k * atan (sqrt r))))).
{ replace e with (e * exp ((-1) * q) * exp q) at 1
    by (replace ((-1) * q) with (- q) by ring; rewrite exp_Ropp; pose proof (exp_pos q); field; lra).
  rewrite <- L; replace ((-1) * k * (PI + atan (sqrt r))) with (- (PI * k) + - (k * atan (sqrt r))) by ring.
  rewrite exp_plus; transitivity (exp q * (2 * / sqrt (r + 1) * exp (- (k * atan (sqrt r)))) * (exp (- (PI * k)) * exp (PI * k)));
    [ring | rewrite I; ring]. }
assert (M : exp q * (2 * / sqrt (r + 1) * exp (- (atan (sqrt r) / sqrt r))) <= e * exp (PI * k)).
{ rewrite W; apply Rmult_le_compat_l; [left; apply exp_pos |]; apply Rmult_le_compat_l.
  - assert (0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra); left; positive.
  - apply exp_rises; lra. }
apply Rlt_gt; eapply Rlt_le_trans; [| exact M]; set (c := 2 * / sqrt (r + 1) * exp (- (atan (sqrt r) / sqrt r))) in *.
assert (c0 : 0 < c) by (unfold c; assert (0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra); pose proof (exp_pos (- (atan (sqrt r) / sqrt r))); positive).

assert (F : forall y, 0 <= y -> exp q >= y -> 13 / 25 < y * c -> 13 / 25 < exp q * c) by (intros; nra).
assert (Fine : 35 / 10 <= r <= 4 /\ e <= 1165 / 10000 -> 13 / 25 < exp q * c).
{ intros [R3 E3].
  assert (k1 : k <= / sqrt r).
  { apply (Rmult_le_reg_r (sqrt r)); [exact q0 |]; rewrite KR, Rinv_l by lra; lra. }
  assert (Low : 95 / 1000 <= e).
  { replace e with (e * exp ((-1) * q) * exp q)
      by (replace ((-1) * q) with (- q) by ring; rewrite exp_Ropp; pose proof (exp_pos q); field; lra).
    rewrite <- L; apply Rle_trans with (2 * / sqrt (r + 1) * exp (- (/ sqrt r * (PI + atan (sqrt r)))) * (1 - (1165 / 10000) ^ 2 / 4)).
    - clear - R3; interval with (i_bisect r).
    - apply Rmult_le_compat; [| lra | | nra].
      + assert (0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra); left; apply Rmult_lt_0_compat; [positive | apply exp_pos].
      + apply Rmult_le_compat_l; [assert (0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra); left; positive |].
        apply exp_rises; pose proof (atan_above _ q0); nra. }
  assert (b2 : sqrt r / 2 <= b) by (rewrite <- KR; nra).
  apply (F ((1 + sqrt r / 2 * sin e ^ 2 / (sqrt (r * sin e ^ 2 + 1) + cos e)) * (1 + e ^ 2 / 6)
    * (1 / 2 * sqrt (r * sin e ^ 2 + 1) + 1 / 2 * cos e))).
  - assert (0 <= sqrt (r * sin e ^ 2 + 1)) by apply sqrt_pos.
    assert (0 <= sqrt r / 2 * sin e ^ 2 / (sqrt (r * sin e ^ 2 + 1) + cos e)) by (apply Rdiv_le_0_compat; nra).
    assert (0 <= e ^ 2) by nra; repeat apply Rmult_le_pos; lra.
  - apply Rle_ge; eapply Rle_trans; [| exact V].
    assert (0 <= sqrt (r * sin e ^ 2 + 1)) by apply sqrt_pos.
    apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_r; [nra |]; apply Rplus_le_compat_l.
    unfold Rdiv; apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | apply Rmult_le_compat_r; nra].
  - unfold c; clear - R3 E3 Low; interval with (i_bisect r, i_bisect e, i_depth 20). }
assert (G : forall l h m, l <= r <= h -> e <= m -> 13 / 25 < (1 - m ^ 2 / 4) * c -> m <= 42 / 100 -> 13 / 25 < exp q * c).
{ clear - P E42 V' F; intros l h m _ E1 H5 M1; assert (e ^ 2 <= m ^ 2) by nra; assert (m ^ 2 <= (42 / 100) ^ 2) by nra.
  apply (F (1 - m ^ 2 / 4)); [lra | lra | exact H5]. }
destruct X as [[X Y]|[[X Y]|[[X Y]|[[X Y]|[[X Y]|[[X Y]|[X Y]]]]]]];
  try (apply Fine; lra).
- destruct (Rle_or_lt r (1 / 2)) as [H5|H5].
  + apply (G 0 (1 / 2) (42 / 100)); try lra; unfold c.
    assert (atan (sqrt r) / sqrt r <= 1).
    { apply (Rmult_le_reg_r (sqrt r)); [exact q0 |]; replace (atan (sqrt r) / sqrt r * sqrt r) with (atan (sqrt r)) by (field; lra).
      rewrite Rmult_1_l; enough (0 <= sqrt r - atan (sqrt r)) by lra.
      apply (from_left_ge (fun t : R => t - atan t) (fun t : R => t * t * / (1 + t * t)) 0 (sqrt r)); try lra.
      - intros t _; eapply d_eq; [derive |]; cbv beta; field; nra.
      - intros t _; apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra].
      - rewrite atan_0; lra. }
    apply Rlt_le_trans with ((1 - (42 / 100) ^ 2 / 4) * (2 * / sqrt (r + 1) * exp (- 1))).
    * clear - X H5; interval.
    * apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [| apply exp_rises; lra].
      assert (0 < sqrt (r + 1)) by (apply sqrt_lt_R0; lra); left; positive.
  + apply (G (1 / 2) 1 (42 / 100)); try lra; unfold c; clear - X H5; interval with (i_bisect r).
- apply (G 1 2 (213 / 1000)); try lra; unfold c; clear - X; interval with (i_bisect r).
- apply (G 2 3 (164 / 1000)); try lra; unfold c; clear - X; interval with (i_bisect r).
- apply (G 3 (35 / 10) (138 / 1000)); try lra; unfold c; clear - X; interval with (i_bisect r).
