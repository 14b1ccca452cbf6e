(* The slope of the defect at the separatrix beside -1/(4 b e), by shares that are all near one. *)
Definition slope_rest_of (a b e : R) : R := 1 / 4 * / b * / e + sqrt b * / ((-1) * b * sin e ^ 2 + 1) * sqrt (a + b * sin e ^ 2)
  * ((-1) / 4 * / sqrt (a * b) ^ 3 * (a + (-1) * b + (-2) * a * b) * ln (/ sin e * (sqrt (a + b * sin e ^ 2) + sqrt a * cos e))
    + 1 / 4 * / sqrt (a * b) ^ 3 * (a + (-1) * b + (-2) * a * b) * ln (sqrt (a + b))
    + (-1) / 4 * / a * / sqrt b ^ 3 * sqrt (a + b * sin e ^ 2) * / sin e ^ 2 * cos e) * sin e.
Definition slope_share (n c b u d t z : R) : R :=
  c * (1 / 3 + t - (b + n ^ 2) * (1 - u / 6 + d) ^ 2 + n ^ 2 * (1 - u / 6 + d) ^ 2 * (1 / 3 + t) * u)
  - (PI + atan (n * (1 - u / 2 + z) / sqrt (1 + n ^ 2 * (1 - u / 6 + d) ^ 2 * u))) * sqrt (1 + n ^ 2 * (1 - u / 6 + d) ^ 2 * u)
    * (1 - u / 6 + d) * (1 - n ^ 2 - 2 * b).
Ltac shares_within n b u part := destruct part as [? [? [? [? [? ?]]]]]; try lra; unfold slope_share;
  repeat split; intros; first [apply not_below | apply above]; interval with (i_bisect n, i_bisect b, i_bisect u).
Ltac times_within n b u cn fin part := let W := fresh "W" in
  destruct part as [? [? [? [? [? [? W]]]]]]; try lra; [interval |]; apply (fin _ W); rewrite cn;
  split; apply not_below; interval with (i_bisect n, i_bisect b, i_bisect u).
Section SlopeShares.
Variables a b e : R.
Hypotheses (A : a > 0) (B : b > 0) (P : e > 0) (Q : e < 1 / 2 * PI).
Hypothesis D : tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Hypotheses (B1 : b <= 1) (AB : a * b >= 1 / 4).
Let w := sqrt (b * / a * sin e ^ 2 + 1).
Let p := PI + asin (sqrt (b * / (a + b)) * cos e).
Lemma slope_by_turn : slope_rest_of a b e * (4 * b * (1 - b * sin e ^ 2))
  = (1 - b * sin e ^ 2) * / e - w ^ 2 * cos e * / sin e - sqrt (a * b) * p * w * sin e * (1 - b * / a - 2 * b).
Proof.
  destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [_ K2]]]]].
  pose proof (sine_square_at_most_one e) as S1; assert (W0 : 0 < b * / a * sin e ^ 2 + 1) by nra.
  pose proof (sqrt_lt_R0 _ W0) as W; pose proof (pow2_sqrt _ (Rlt_le _ _ W0)) as W2; fold w in W, W2.
  assert (q0 : 0 < b * / a + 1) by lra; pose proof (sqrt_lt_R0 _ q0) as q; pose proof (pow2_sqrt _ (Rlt_le _ _ q0)) as q2.
  pose proof (sqrt_lt_R0 _ A) as a0; pose proof (pow2_sqrt _ (Rlt_le _ _ A)) as a2.
  pose proof (sqrt_lt_R0 _ B) as b0; pose proof (pow2_sqrt _ (Rlt_le _ _ B)) as b2.
  assert (E1 : sqrt (a + b * sin e ^ 2) = sqrt a * w).
  { apply sqrt_unique; [nra |]; rewrite Rpow_mult_distr, a2, W2; field; lra. }
  assert (E2 : sqrt (a + b) = sqrt a * sqrt (b * / a + 1)).
  { apply sqrt_unique; [nra |]; rewrite Rpow_mult_distr, a2, q2; field; lra. }
  assert (E3 : ln (/ sin e * (sqrt (a + b * sin e ^ 2) + sqrt a * cos e)) = sqrt (a * b) * p + ln (sqrt (a + b))).
  { pose proof (decay a b _ e A B S C D) as X; fold p w in X.
    assert (Y : exp (sqrt (a * b) * p) = / sin e * (w + cos e) * / sqrt (b * / a + 1)).
    { rewrite <- (Ropp_involutive (sqrt (a * b) * p)), exp_Ropp, X; field; lra. }
    rewrite <- (ln_exp (sqrt (a * b) * p)), <- ln_mult, Y, E1, E2 by (first [apply exp_pos | rewrite E2; positive]).
    f_equal; field; lra. }
  assert (E4 : sqrt (a * b) = sqrt a * sqrt b) by (apply sqrt_mult; lra).
  assert (F : 0 < 1 - b * sin e ^ 2).
  { assert (sin e ^ 2 < 1) by (pose proof (sin_square e); assert (0 < cos e ^ 2) by (apply pow_lt; lra); lra); nra. }
  unfold slope_rest_of; rewrite E3, E1, E4; set (m := ln _); set (x := sqrt a) in *; set (y := sqrt b) in *.
  replace (b * / a) with (y ^ 2 * / x ^ 2) by (rewrite a2, b2; reflexivity).
  clearbody m x y p w; clear E1 E2 E3 E4 D q0 q q2 W0 W2 K2 K0 R0; subst a b; field.
  repeat split; try lra; apply Rgt_not_eq; lra.
Qed.
Lemma slope_by_shares : exists n u d t z : R, 0 < n /\ n ^ 2 = b * / a /\ sqrt (a * b) * n = b /\ u = e ^ 2
  /\ 0 <= d <= u ^ 2 / 120 /\ 0 <= t <= u / 15 /\ 0 <= z <= u ^ 2 / 24 /\ 0 < 1 - b * (1 - u / 6 + d) ^ 2 * u
  /\ slope_rest_of a b e * (4 * b * (1 - b * (1 - u / 6 + d) ^ 2 * u))
    = e * sqrt (a * b) * slope_share n (n * / b) b u d t z.
Proof.
  destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
  assert (E0 : e <= 42 / 100) by (destruct (defect_boxes a b e A B P Q D B1 AB) as [H|[H|[H|[H|[H|[H|H]]]]]]; lra).
  destruct (small_sine e) as [[SA SB] [CA CB]]; try lra.
  assert (n0 : 0 < sqrt (b * / a)) by (apply sqrt_lt_R0; exact R0); pose proof (pow2_sqrt _ (Rlt_le _ _ R0)) as n2.
  set (n := sqrt (b * / a)) in *; assert (u0 : 0 < e ^ 2 <= 1764 / 10000) by (split; [apply pow_lt; lra | nra]).
  replace (e ^ 4) with ((e ^ 2) ^ 2) in SB, CB by ring; set (u := e ^ 2) in *.
  pose (h := sin e * / e); assert (H : 1 - u / 6 <= h <= 1 - u / 6 + u ^ 2 / 120).
  { unfold h; split; apply (Rmult_le_reg_r e); try lra; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; lra. }
  exists n, u, (h - 1 + u / 6), ((1 - / h * cos e) * / u - 1 / 3), (cos e - 1 + u / 2).
  assert (h0 : 9 / 10 <= h) by lra.
  replace (1 - u / 6 + (h - 1 + u / 6)) with h by ring; replace (1 - u / 2 + (cos e - 1 + u / 2)) with (cos e) by ring.
  assert (F : h ^ 2 * u = sin e ^ 2) by (unfold h, u; field; lra).
  assert (G : 0 < 1 - b * sin e ^ 2).
  { assert (sin e ^ 2 < 1) by (pose proof (sin_square e); assert (0 < cos e ^ 2) by (apply pow_lt; lra); lra); nra. }
  replace (b * h ^ 2 * u) with (b * sin e ^ 2) by (rewrite <- F; ring).
  split; [exact n0 |]; split; [exact n2 |]; split; [exact KR |]; split; [reflexivity |]; split; [lra |].
  assert (V : / h * cos e = 1 - u * ((1 - / h * cos e) * / u)) by (field; lra).
  assert (Lo : / h * cos e <= 1 - u / 3).
  { apply (Rmult_le_reg_l h); [lra |]; rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra; nra. }
  assert (Up : 1 - u * (1 / 3 + u / 15) <= / h * cos e).
  { apply (Rmult_le_reg_l h); [lra |]; rewrite <- (Rmult_assoc h), Rinv_r, Rmult_1_l by lra.
    apply Rle_trans with ((1 - u / 6 + u ^ 2 / 120) * (1 - u * (1 / 3 + u / 15))); [apply Rmult_le_compat_r; nra | nra]. }
  set (q := (1 - / h * cos e) * / u) in *; split; [split; nra |]; split; [split; lra |]; split; [exact G |].
  rewrite slope_by_turn; unfold slope_share; replace (1 - u / 6 + (h - 1 + u / 6)) with h by ring.
  replace (1 - u / 2 + (cos e - 1 + u / 2)) with (cos e) by ring.
  replace (1 / 3 + (q - 1 / 3)) with q by ring.
  replace (1 + n ^ 2 * h ^ 2 * u) with (b * / a * sin e ^ 2 + 1) by (rewrite n2, <- F; ring).
  unfold p; rewrite turn_of_share by lra; fold n w.
  replace (n * (/ w * cos e)) with (n * cos e / w) by (unfold Rdiv; ring); set (T := PI + atan _).
  assert (W0 : 0 < b * / a * sin e ^ 2 + 1) by nra; pose proof (pow2_sqrt _ (Rlt_le _ _ W0)) as W2; fold w in W2.
  assert (k0 : sqrt (a * b) * (n * / b) = 1) by (rewrite <- Rmult_assoc, KR; field; lra).
  rewrite n2; set (k := sqrt (a * b)) in *; set (r := b * / a) in *.
  replace (e * k * (n * / b * (q - (b + r) * h ^ 2 + r * h ^ 2 * q * u) - T * w * h * (1 - r - 2 * b)))
    with (e * (k * (n * / b)) * (q - (b + r) * h ^ 2 + r * h ^ 2 * q * u) - k * T * w * (h * e) * (1 - r - 2 * b)) by ring.
  replace (h * e) with (sin e) by (unfold h; field; lra); rewrite k0, Rmult_1_r, W2.
  enough (X : (1 - b * sin e ^ 2) * / e - (r * sin e ^ 2 + 1) * cos e * / sin e
    = e * (q - (b + r) * h ^ 2 + r * h ^ 2 * q * u)) by (rewrite X; ring).
  unfold q, h, u; field; lra.
Qed.
Lemma slope_within : exists s v : R, 0 < v /\ slope_rest_of a b e * (4 * b * v) = e * sqrt (a * b) * s
  /\ - (63 / 5) * v <= s < 63 / 5 * v /\ (3 / 4 <= b -> 3 / 2 * v < s).
Proof.
  destruct slope_by_shares as [n [u [d [t [z [n0 [n2 [kn [ue [[d0 D1] [[t0 T1] [[z0 Z1] [v0 E]]]]]]]]]]]]].
  exists (slope_share n (n * / b) b u d t z), (1 - b * (1 - u / 6 + d) ^ 2 * u); split; [exact v0 |]; split; [exact E |].
  destruct (defect_shape a b A B B1 AB) as [k0 _]; assert (nb : n <= 2 * b) by nra.
  assert (C : 0 <= n * / b <= 2).
  { split; [left; positive |]; apply (Rmult_le_reg_r b); [lra |]; rewrite Rmult_assoc, Rinv_l; lra. }
  assert (u0 : 0 <= u) by (rewrite ue; apply pow2_ge_0).
  assert (part : forall l h m, 0 <= l -> l ^ 2 <= b * / a -> 0 <= h -> b * / a <= h ^ 2 -> e <= m -> m <= 42 / 100 ->
    l <= n <= h /\ l / 2 <= b <= 1 /\ 0 <= u <= m ^ 2 /\ 0 <= d <= (m ^ 2) ^ 2 / 120 /\ 0 <= t <= m ^ 2 / 15 /\ 0 <= z <= (m ^ 2) ^ 2 / 24).
  { intros l h m l0 L h0 H M M'; rewrite <- n2 in L, H; assert (u <= m ^ 2) by (rewrite ue; apply pow_incr; lra).
    assert (u ^ 2 <= (m ^ 2) ^ 2) by (apply pow_incr; lra); assert (l <= n) by nra; assert (n <= h) by nra; repeat split; lra. }
  destruct (defect_boxes a b e A B P Q D B1 AB) as [[H M]|[[H M]|[[H M]|[[H M]|[[H M]|[[H M]|[H M]]]]]]].
  - destruct (part 0 1 (42 / 100)) as [N [b0 [U [D2 [T2 Z2]]]]]; try lra; unfold slope_share; split.
    + set (c := n * / b) in *; split; [apply not_below | apply above]; interval with (i_bisect n, i_bisect b, i_bisect c, i_bisect u).
    + intros K; apply above; interval with (i_bisect n, i_bisect b, i_bisect u).
  - shares_within n b u (part 1 (14143 / 10000) (213 / 1000)).
  - shares_within n b u (part (14142 / 10000) (17321 / 10000) (164 / 1000)).
  - shares_within n b u (part (1732 / 1000) (1871 / 1000) (138 / 1000)).
  - shares_within n b u (part (187 / 100) (1975 / 1000) (1165 / 10000)).
  - shares_within n b u (part (19748 / 10000) (19975 / 10000) (1102 / 10000)).
  - shares_within n b u (part (19974 / 10000) 2 (1089 / 10000)).
Qed.
Lemma defect_times g : 0 <= g -> g <= / w * cos e -> 0 < e * sqrt (a * b) <= sqrt (a * b)
  * / (sqrt (b * / a + 1) * ((exp (sqrt (a * b) * (PI + atan (sqrt (b * / a) * g)))
    - exp (- (sqrt (a * b) * (PI + atan (sqrt (b * / a) * g))))) / 2)).
Proof.
  intros g0 G; destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]]; pose proof (defect_angle a b e A B P Q D) as E.
  cbv zeta in E; rewrite turn_of_share in E by lra; fold w in E; pose proof (sqrt_lt_R0 _ R0) as n0; pose proof PI_RGT_0 as J.
  assert (q0 : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  assert (T : 0 <= atan (sqrt (b * / a) * g) <= atan (sqrt (b * / a) * (/ w * cos e))).
  { split; [rewrite <- atan_0 |]; apply arctangent_rises; nra. }
  set (x := sqrt (a * b) * (PI + atan (sqrt (b * / a) * g))); assert (x0 : 0 < x) by (apply Rmult_lt_0_compat; lra).
  change ((exp x - exp (- x)) / 2) with (sinh x); pose proof (sinh_pos x x0) as X.
  assert (Y : sinh x <= sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * (/ w * cos e))))) by (apply sinh_grows, Rmult_le_compat_l; lra).
  split; [nra |]; rewrite (Rmult_comm e); apply Rmult_le_compat_l; [lra |]; rewrite E at 1.
  eapply Rle_trans; [apply atan_at_most; left; positive |]; apply Rinv_le_contravar; nra.
Qed.
Lemma slope_small : Rabs (slope_rest_of a b e) <= 9 / 50 * / b.
Proof.
  destruct (defect_signs a b e A B P Q) as [S [Ce [R0 [K0 [KR K2]]]]]; destruct (defect_shape a b A B B1 AB) as [k0 _].
  assert (I : 0 < / b) by (apply Rinv_0_lt_compat; lra).
  destruct (Rle_or_lt 5 (sqrt (a * b))) as [K|K].
  { destruct slope_within as [s [v [V [E [[L U] _]]]]].
    assert (T : 18 * (e * sqrt (a * b)) <= 1).
    { pose proof (defect_by_exp a b e A B P Q D) as H; cbv zeta in H; set (k := sqrt (a * b)) in *.
      rewrite exp_Ropp in H; assert (X : (1 + k) ^ 3 <= exp (PI * k)).
      { apply Rle_trans with (exp k ^ 3); [apply pow_incr; split; [lra | apply exp_ineq1_le] |].
        replace (exp k ^ 3) with (exp (3 * k)) by (simpl; rewrite Rmult_1_r, <- !exp_plus; f_equal; ring).
        apply exp_rises; pose proof pi_between; nra. }
      assert (Y : e * (1 + k) ^ 3 <= 2).
      { apply Rle_trans with (e * exp (PI * k)); [apply Rmult_le_compat_l; lra |]; pose proof (exp_pos (PI * k)).
        apply (Rmult_le_reg_r (/ exp (PI * k))); [positive |]; rewrite Rmult_assoc, Rinv_r by lra; lra. }
      assert (0 <= e * k) by nra; assert (36 * k <= (1 + k) ^ 3) by nra; nra. }
    assert (F : slope_rest_of a b e = (e * sqrt (a * b)) * (s * / v) * / 4 * / b).
    { apply (Rmult_eq_reg_r (4 * b * v)); [| apply Rgt_not_eq; positive]; rewrite E; field; lra. }
    assert (J : - (63 / 5) <= s * / v <= 63 / 5).
    { split; apply (Rmult_le_reg_r v); try assumption; rewrite Rmult_assoc, Rinv_l by lra; lra. }
    assert (e0 : 0 < e * sqrt (a * b)) by positive.
    rewrite F, Rabs_mult, (Rabs_pos_eq (/ b)) by lra; apply Rmult_le_compat_r; [lra |]; apply Rabs_le.
    set (x := e * _) in *; set (y := s * / v) in *; split; nra. }
  destruct slope_by_shares as [n [u [d [t [z [n0 [n2 [kn [ue [[d0 D1] [[t0 T1] [[z0 Z1] [v0 E]]]]]]]]]]]]].
  assert (nr : sqrt (b * / a) = n) by (apply sqrt_unique; lra); assert (nb : n <= 2 * b) by nra.
  assert (kb : sqrt (a * b) = b * / n) by (rewrite <- kn at 2; field; lra).
  set (c := n * / b); assert (kc : sqrt (a * b) = / c) by (unfold c; rewrite kb; field; lra).
  assert (bc : b = n * / c) by (unfold c; field; lra).
  assert (C : 2 / 10 <= c <= 2).
  { unfold c; split; apply (Rmult_le_reg_r b); try lra; rewrite Rmult_assoc, Rinv_l by lra; nra. }
  assert (u0 : 0 <= u) by (rewrite ue; apply pow2_ge_0).
  assert (part : forall l h m g, 0 <= l -> l ^ 2 <= b * / a -> 0 <= h -> b * / a <= h ^ 2 -> e <= m -> m <= 42 / 100 -> 0 <= g ->
    g <= / sqrt (h ^ 2 * m ^ 2 + 1) * (1 - m ^ 2 / 2) ->
    l <= n <= h /\ l / 2 <= b <= 1 /\ 0 <= u <= m ^ 2 /\ 0 <= d <= (m ^ 2) ^ 2 / 120 /\ 0 <= t <= m ^ 2 / 15 /\ 0 <= z <= (m ^ 2) ^ 2 / 24
    /\ 0 < e * / c <= / c * / (sqrt (n ^ 2 + 1) * ((exp (/ c * (PI + atan (n * g))) - exp (- (/ c * (PI + atan (n * g))))) / 2))).
  { intros l h m g l0 L h0 H M M' g0 G; rewrite <- n2 in L, H; assert (um : u <= m ^ 2) by (rewrite ue; apply pow_incr; lra).
    assert (u ^ 2 <= (m ^ 2) ^ 2) by (apply pow_incr; lra); assert (l <= n) by nra; assert (n <= h) by nra.
    assert (W : g <= / w * cos e).
    { eapply Rle_trans; [exact G |]; unfold w; pose proof (cosine_least e ltac:(lra)); rewrite <- n2.
      assert (sin e ^ 2 <= m ^ 2) by (apply pow_incr; split; [lra | apply Rle_trans with e; [left; apply sin_lt_x; lra | lra]]).
      assert (0 <= n ^ 2 * sin e ^ 2 <= h ^ 2 * m ^ 2) by (split; [nra | apply Rmult_le_compat; nra]).
      assert (0 < sqrt (n ^ 2 * sin e ^ 2 + 1)) by (apply sqrt_lt_R0; lra).
      assert (0 < sqrt (h ^ 2 * m ^ 2 + 1)) by (apply sqrt_lt_R0; lra).
      apply Rmult_le_compat; [left; positive | nra | apply Rinv_le_contravar; [assumption | apply sqrt_le_1_alt; lra] | lra]. }
    pose proof (defect_times g g0 W) as T; rewrite nr, kc, <- n2 in T; repeat split; try lra; apply T. }
  fold c in E; rewrite kc in E; set (v := 1 - b * (1 - u / 6 + d) ^ 2 * u) in *.
  assert (fin : forall y, 0 < e * / c <= y -> - (18 / 25) * v <= y * slope_share n c b u d t z <= 18 / 25 * v ->
    Rabs (slope_rest_of a b e) <= 9 / 50 * / b).
  { intros y [Y0 Y] [L U]; set (s := slope_share n c b u d t z) in *; set (x := e * / c) in *.
    assert (F : slope_rest_of a b e = (x * s * / v) * / 4 * / b).
    { apply (Rmult_eq_reg_r (4 * b * v)); [| apply Rgt_not_eq; positive]; rewrite E; field; lra. }
    assert (J : - (18 / 25) * v <= x * s <= 18 / 25 * v) by (destruct (Rle_or_lt 0 s); split; nra).
    assert (J' : - (18 / 25) <= x * s * / v <= 18 / 25).
    { split; apply (Rmult_le_reg_r v); try assumption; rewrite (Rmult_assoc (x * s)), Rinv_l by lra; lra. }
    rewrite F, Rabs_mult, (Rabs_pos_eq (/ b)) by lra; apply Rmult_le_compat_r; [lra |]; apply Rabs_le; lra. }
  assert (cn : c = n * / b) by reflexivity; clearbody c; unfold v, slope_share in fin;
  destruct (defect_boxes a b e A B P Q D B1 AB) as [[H M]|[[H M]|[[H M]|[[H M]|[[H M]|[[H M]|[H M]]]]]]].
  - destruct (part 0 1 (42 / 100) (84 / 100)) as [? [? [? [? [? [? W]]]]]]; try lra; [interval |]; apply (fin _ W); rewrite bc.
    split; apply not_below; interval with (i_bisect n, i_bisect c, i_bisect u).
  - times_within n b u cn fin (part 1 (14143 / 10000) (213 / 1000) (93 / 100)).
  - times_within n b u cn fin (part (14142 / 10000) (17321 / 10000) (164 / 1000) (94 / 100)).
  - times_within n b u cn fin (part (1732 / 1000) (1871 / 1000) (138 / 1000) (95 / 100)).
  - times_within n b u cn fin (part (187 / 100) (1975 / 1000) (1165 / 10000) (96 / 100)).
  - times_within n b u cn fin (part (19748 / 10000) (19975 / 10000) (1102 / 10000) (97 / 100)).
  - times_within n b u cn fin (part (19974 / 10000) 2 (1089 / 10000) (97 / 100)).
Qed.
End SlopeShares.
