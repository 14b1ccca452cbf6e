(* Sweeps of the phase equation and Newton's steps from them, for every shape. *)
Ltac hyperbolic := lazymatch goal with
  | |- is_derive sinh ?t _ => exact (d_sinh (fun y : R => y) t 1 (d_id t))
  | |- is_derive cosh ?t _ => exact (d_cosh (fun y : R => y) t 1 (d_id t))
  | |- is_derive tanh ?t _ => exact (d_tanh (fun y : R => y) t 1 (d_id t))
  | |- is_derive (fun t : R => @?f t + @?g t) _ _ => eapply (d_plus f g); hyperbolic
  | |- is_derive (fun t : R => @?f t - @?g t) _ _ => eapply (d_minus f g); hyperbolic
  | |- is_derive (fun t : R => @?f t * @?g t) _ _ => eapply (d_mult f g); hyperbolic
  | |- _ => derive end.
Lemma sinh_slope u v : u <= v -> exists c, u <= c <= v /\ sinh v - sinh u = cosh c * (v - u).
Proof.
  intros H; destruct (mean_value sinh cosh u v H) as [c [C E]]; [| exists c; split; assumption].
  intros t _; eapply d_eq; [hyperbolic |]; tidy; ring.
Qed.
Lemma sinh_share u v : 0 <= u -> u <= v -> v * sinh u <= u * sinh v.
Proof.
  intros U H; destruct (sinh_slope u v H) as [c [C E]]; destruct (sinh_slope 0 u U) as [d [D F]].
  rewrite sinh_0 in F; pose proof (cosh_rises d c ltac:(lra) ltac:(lra)).
  assert (u * (v - u) * cosh d <= u * (v - u) * cosh c) by (apply Rmult_le_compat_l; nra); nra.
Qed.
Lemma sinh_below_cosh x : 0 <= x -> sinh x <= x * cosh x.
Proof.
  intros X; destruct (sinh_slope 0 x X) as [c [C E]]; rewrite sinh_0 in E.
  pose proof (cosh_rises c x ltac:(lra) ltac:(lra)); nra.
Qed.
Lemma sinh_back x h : 0 <= h -> h <= x -> sinh x - h * cosh x <= sinh (x - h).
Proof.
  intros H X; destruct (sinh_slope (x - h) x ltac:(lra)) as [c [C E]].
  pose proof (cosh_rises c x ltac:(lra) ltac:(lra)); nra.
Qed.
Lemma coth_by_cosh x : 0 <= x -> 3 * x * cosh x <= (1 + 2 * cosh x) * sinh x.
Proof.
  intros X; enough (0 <= (1 + 2 * cosh x) * sinh x - 3 * x * cosh x) by lra.
  apply (from_left_ge (fun t : R => (1 + 2 * cosh t) * sinh t - 3 * t * cosh t)
    (fun t : R => 2 * sinh t ^ 2 + (1 + 2 * cosh t) * cosh t - 3 * cosh t - 3 * t * sinh t) 0 x X).
  - intros t _; eapply d_eq; [hyperbolic |]; tidy; ring.
  - intros t [T _]; pose proof (cosh_square t); pose proof (sinh_above t T); pose proof (cosh_above t); nra.
  - rewrite sinh_0; lra.
Qed.
Lemma atan_least z : 0 <= z -> z / (1 + z ^ 2) <= atan z.
Proof.
  intros Z; enough (0 <= atan z - z / (1 + z ^ 2)) by lra.
  apply (from_left_ge (fun t : R => atan t - t / (1 + t ^ 2)) (fun t : R => 2 * t ^ 2 / (1 + t ^ 2) ^ 2) 0 z Z).
  - intros t _; auto_derive; [nra | field; nra].
  - intros t _; apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra].
  - rewrite atan_0; lra.
Qed.
(* The hyperbolic functions of x + h against those of x. *)
Lemma sinh_ahead x h : 0 < x -> 0 <= h -> h <= 1 / 10 ->
  sinh (x + h) <= sinh x * (1 + 51 / 100 * h ^ 2) + cosh x * (h * (1 + 17 / 100 * h ^ 2))
  /\ cosh (x + h) <= cosh x * (1 + 51 / 100 * h ^ 2) + sinh x * (h * (1 + 17 / 100 * h ^ 2)).
Proof.
  intros X H H1.
  assert (A : sinh (x + h) = sinh x * cosh h + cosh x * sinh h) by
    (rewrite !sinh_law, !cosh_law, exp_plus; pose proof (exp_pos x); pose proof (exp_pos h); field; lra).
  assert (B : cosh (x + h) = cosh x * cosh h + sinh x * sinh h) by
    (rewrite !cosh_law, !sinh_law, exp_plus; pose proof (exp_pos x); pose proof (exp_pos h); field; lra).
  assert (S1 : forall t, 0 <= t <= h -> sinh t <= 102 / 100 * t).
  { intros t T; destruct (sinh_slope 0 t ltac:(lra)) as [c [C E]]; rewrite sinh_0 in E.
    pose proof (cosh_rises c (1 / 10) ltac:(lra) ltac:(lra)).
    assert (cosh (1 / 10) <= 102 / 100) by (unfold cosh; interval); nra. }
  assert (S2 : forall t, 0 <= t <= h -> cosh t <= 1 + 51 / 100 * t ^ 2).
  { intros t T; enough (0 <= 1 + 51 / 100 * t ^ 2 - cosh t) by lra.
    apply (from_left_ge (fun t : R => 1 + 51 / 100 * t ^ 2 - cosh t) (fun t : R => 102 / 100 * t - sinh t) 0 t); [lra | | |].
    - intros y _; eapply d_eq; [hyperbolic |]; tidy; field.
    - intros y Y; pose proof (S1 y ltac:(lra)); lra.
    - rewrite cosh_0; lra. }
  assert (S3 : sinh h <= h * (1 + 17 / 100 * h ^ 2)).
  { enough (0 <= h * (1 + 17 / 100 * h ^ 2) - sinh h) by lra.
    apply (from_left_ge (fun t : R => t * (1 + 17 / 100 * t ^ 2) - sinh t) (fun t : R => 1 + 51 / 100 * t ^ 2 - cosh t) 0 h H).
    - intros y _; eapply d_eq; [hyperbolic |]; tidy; field.
    - intros y Y; pose proof (S2 y Y); lra.
    - rewrite sinh_0; lra. }
  pose proof (S2 h ltac:(lra)); pose proof (cosh_pos x); pose proof (sinh_pos x X); rewrite A, B; split; nra.
Qed.
Lemma one_more y : 0 < y ^ 2 + 1.
Proof. pose proof (pow2_ge_0 y); lra. Qed.
Lemma square_in y : 0 < y < 1 -> 0 < y ^ 2 < 1.
Proof. intros Y; nra. Qed.
Lemma sinh_under y : sinh y < cosh y.
Proof. unfold sinh, cosh; pose proof (exp_pos (- y)); lra. Qed.
(* An angle against the one whose cotangent is smaller by a share. *)
Lemma angle_gain w v y : 0 < w -> 0 <= y < 1 -> w * (1 - y) <= v ->
  atan (/ v) - atan (/ w) <= y / (1 - y) * (w / (1 + w ^ 2)).
Proof.
  intros W Y V; assert (Q : 0 < w * (1 - y)) by (apply Rmult_lt_0_compat; lra).
  assert (I : / v <= / (w * (1 - y))) by (apply Rinv_le_contravar; lra).
  pose proof (arctangent_rises _ _ I); assert (0 < / (w * (1 - y))) by positive; assert (0 < / w) by positive.
  set (z := / (1 + / (w * (1 - y)) * / w) * (/ (w * (1 - y)) - / w)).
  pose proof (atan_difference (/ (w * (1 - y))) (/ w) z ltac:(lra) ltac:(lra) eq_refl) as E.
  assert (F : z = w * y / (w ^ 2 * (1 - y) + 1)) by (unfold z; field; repeat split; nra).
  assert (G : 0 <= w * y / (w ^ 2 * (1 - y) + 1)).
  { apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra]. }
  pose proof (atan_at_most z ltac:(rewrite F; exact G)) as M.
  assert (L : z <= y / (1 - y) * (w / (1 + w ^ 2))); [| lra].
  rewrite F; replace (y / (1 - y) * (w / (1 + w ^ 2))) with (w * y / ((1 - y) * (1 + w ^ 2))) by (field; repeat split; nra).
  apply Rmult_le_compat_l; [nra |]; apply Rinv_le_contravar; nra.
Qed.
Lemma angle_loss w v y : 0 < w -> 0 <= y -> w <= v -> v <= w * (1 + y) ->
  atan (/ w) - atan (/ v) <= w * y / ((1 + y) * w ^ 2 + 1).
Proof.
  intros W Y V1 V; assert (Q : 0 < w * (1 + y)) by (apply Rmult_lt_0_compat; lra).
  assert (I : / (w * (1 + y)) <= / v) by (apply Rinv_le_contravar; lra).
  pose proof (arctangent_rises _ _ I); assert (0 < / (w * (1 + y))) by positive; assert (0 < / w) by positive.
  set (z := / (1 + / w * / (w * (1 + y))) * (/ w - / (w * (1 + y)))).
  pose proof (atan_difference (/ w) (/ (w * (1 + y))) z ltac:(lra) ltac:(lra) eq_refl) as E.
  assert (F : z = w * y / ((1 + y) * w ^ 2 + 1)) by (unfold z; field; repeat split; nra).
  assert (G : 0 <= w * y / ((1 + y) * w ^ 2 + 1)).
  { apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra]. }
  pose proof (atan_at_most z ltac:(rewrite F; exact G)) as M; rewrite F in M; rewrite F in E; lra.
Qed.

(* The gap left by a sweep from s, where the phase is PI + q = x / k; u stands for 1 / cosh x. *)
Definition gap (d s q u : R) : R :=
  d * (sin q * cos q) * (u + 2) / (3 * (PI + q) * (s + d * cos q ^ 2 * u)).
Definition angle_of (q u : R) : R :=
  atan (cos q * u / sqrt (1 - (cos q * u) ^ 2)) / (cos q * u * sqrt (1 - (cos q * u) ^ 2)).
Definition newton_gap (y q u : R) : R :=
  sin q * cos q * (u * (u + 2)) / (3 * (PI + q)) * (1 - (cos q * u) ^ 2) * y ^ 2
  / ((1 - 2 * y) * (1 - 2 * y - sin q * cos q * (u * (u + 2)) / (3 * (PI + q)))).
(* The same gap more sharply, where the sweep begins beyond the phase. *)
Definition sharp_gap (t q x : R) : R :=
  sin q * cos q * t / (((1 + x ^ 2 * (1 / 6 + x ^ 2 / 120)) ^ 2 + t * (sinh x ^ 2 + sin q ^ 2) / (1 + x ^ 2 / 3)) * (PI + q)).
Definition ahead (y u : R) : R := y * (1 + 52 / 100 * y * (1 - u ^ 2)).

Lemma tanh_between_cubics v : 0 <= v -> v - v ^ 3 / 3 <= tanh v /\ tanh v <= v * (1 - v ^ 2 * (1 / 3 - 2 / 15 * v ^ 2)).
Proof.
  intros V; assert (d : forall t, is_derive tanh t (1 - tanh t ^ 2)).
  { intros t; eapply d_eq; [hyperbolic |]; tidy; unfold tanh; pose proof (cosh_pos t); pose proof (cosh_square t) as E.
    replace (1 - (sinh t / cosh t) ^ 2) with ((cosh t ^ 2 - sinh t ^ 2) / cosh t ^ 2) by (field; lra).
    replace (cosh t ^ 2 - sinh t ^ 2) with 1 by lra; field; lra. }
  assert (A : forall t, 0 <= t -> 0 <= t - tanh t).
  { intros t T; apply (from_left_ge (fun y : R => y - tanh y) (fun y : R => tanh y ^ 2) 0 t T).
    - intros y _; eapply d_eq; [apply (d_minus (fun y : R => y) tanh); [derive | apply d] |]; ring.
    - intros y _; apply pow2_ge_0.
    - rewrite tanh_0; lra. }
  assert (P : forall t, 0 <= t -> 0 <= tanh t) by (intros t [T|<-]; [left; apply tanh_pos, T | rewrite tanh_0; lra]).
  assert (B : forall t, 0 <= t -> 0 <= tanh t - (t - t ^ 3 / 3)).
  { intros t T; apply (from_left_ge (fun y : R => tanh y - (y - y ^ 3 / 3)) (fun y : R => y ^ 2 - tanh y ^ 2) 0 t T).
    - intros y _; eapply d_eq; [apply (d_minus tanh (fun y : R => y - y ^ 3 / 3)); [apply d | derive; lra] |]; tidy; field.
    - intros y Y; pose proof (A y (proj1 Y)); pose proof (P y (proj1 Y)); nra.
    - rewrite tanh_0; lra. }
  split; [pose proof (B v V); lra |].
  enough (0 <= (v - v ^ 3 / 3 + 2 / 15 * v ^ 5) - tanh v) by nra.
  apply (from_left_ge (fun y : R => (y - y ^ 3 / 3 + 2 / 15 * y ^ 5) - tanh y) (fun y : R => tanh y ^ 2 - y ^ 2 + 2 / 3 * y ^ 4) 0 v V).
  - intros y _; eapply d_eq; [apply (d_minus (fun y : R => y - y ^ 3 / 3 + 2 / 15 * y ^ 5) tanh); [derive; lra | apply d] |]; tidy; field.
  - intros y [Y _]; pose proof (B y Y) as L; destruct (Rle_or_lt (y ^ 2) (3 / 2)) as [H|H].
    + assert (0 <= y - y ^ 3 / 3) by (replace (y - y ^ 3 / 3) with (y * (1 - y ^ 2 / 3)) by field; apply Rmult_le_pos; lra).
      assert (M : (y - y ^ 3 / 3) ^ 2 <= tanh y ^ 2) by (apply pow_incr; lra).
      replace ((y - y ^ 3 / 3) ^ 2) with (y ^ 2 - 2 / 3 * y ^ 4 + (y ^ 3) ^ 2 / 9) in M by field; pose proof (pow2_ge_0 (y ^ 3)); lra.
    + pose proof (pow2_ge_0 (tanh y)); replace (y ^ 4) with (y ^ 2 * y ^ 2) by ring; nra.
  - rewrite tanh_0; lra.
Qed.
Lemma sinh_least v : 0 <= v -> v * (1 + v ^ 2 * (1 / 6 + v ^ 2 / 120)) <= sinh v.
Proof.
  intros V; assert (A : forall t, 0 <= t -> 0 <= cosh t - (1 + t ^ 2 / 2)).
  { intros t T; apply (from_left_ge (fun y : R => cosh y - (1 + y ^ 2 / 2)) (fun y : R => sinh y - y) 0 t T).
    - intros y _; eapply d_eq; [apply (d_minus cosh (fun y : R => 1 + y ^ 2 / 2)); [hyperbolic | derive; lra] |]; tidy; field.
    - intros y Y; pose proof (sinh_above y (proj1 Y)); lra.
    - rewrite cosh_0; lra. }
  assert (B : forall t, 0 <= t -> 0 <= sinh t - (t + t ^ 3 / 6)).
  { intros t T; apply (from_left_ge (fun y : R => sinh y - (y + y ^ 3 / 6)) (fun y : R => cosh y - (1 + y ^ 2 / 2)) 0 t T).
    - intros y _; eapply d_eq; [apply (d_minus sinh (fun y : R => y + y ^ 3 / 6)); [hyperbolic | derive; lra] |]; tidy; field.
    - intros y Y; exact (A y (proj1 Y)).
    - rewrite sinh_0; lra. }
  assert (C : forall t, 0 <= t -> 0 <= cosh t - (1 + t ^ 2 / 2 + t ^ 4 / 24)).
  { intros t T; apply (from_left_ge (fun y : R => cosh y - (1 + y ^ 2 / 2 + y ^ 4 / 24)) (fun y : R => sinh y - (y + y ^ 3 / 6)) 0 t T).
    - intros y _; eapply d_eq; [apply (d_minus cosh (fun y : R => 1 + y ^ 2 / 2 + y ^ 4 / 24)); [hyperbolic | derive; lra] |]; tidy; field.
    - intros y Y; exact (B y (proj1 Y)).
    - rewrite cosh_0; lra. }
  enough (0 <= sinh v - (v + v ^ 3 / 6 + v ^ 5 / 120)) by lra.
  apply (from_left_ge (fun y : R => sinh y - (y + y ^ 3 / 6 + y ^ 5 / 120)) (fun y : R => cosh y - (1 + y ^ 2 / 2 + y ^ 4 / 24)) 0 v V).
  - intros y _; eapply d_eq; [apply (d_minus sinh (fun y : R => y + y ^ 3 / 6 + y ^ 5 / 120)); [hyperbolic | derive; lra] |]; tidy; field.
  - intros y Y; exact (C y (proj1 Y)).
  - rewrite sinh_0; lra.
Qed.
Lemma coth_by_square x : 0 <= x -> x * cosh x <= (1 + x ^ 2 / 3) * sinh x.
Proof.
  intros X; enough (0 <= (1 + x ^ 2 / 3) * sinh x - x * cosh x) by lra.
  apply (from_left_ge (fun y : R => (1 + y ^ 2 / 3) * sinh y - y * cosh y) (fun y : R => y / 3 * (y * cosh y - sinh y)) 0 x X).
  - intros y _; eapply d_eq.
    + apply (d_minus (fun y : R => (1 + y ^ 2 / 3) * sinh y) (fun y : R => y * cosh y)); [| hyperbolic].
      apply (d_mult (fun y : R => 1 + y ^ 2 / 3) sinh); [derive; lra | hyperbolic].
    + tidy; field.
  - intros y [Y _]; pose proof (sinh_below_cosh y Y); apply Rmult_le_pos; lra.
  - rewrite sinh_0; lra.
Qed.
Section Sweep.
Variables k r q s : R.
Hypotheses (K : 0 < k) (R0 : 0 < r) (B1 : k * r <= 1) (Q : 0 < q < PI / 2) (S0 : 0 < s).
Let x := k * (PI + q).
Hypothesis T : atan (r * tanh x) = q.
Let u := / cosh x.
Let p1 := PI + atan (r * tanh (k * s)).
Let w := sqrt (r ^ 2 + 1) * sinh x.

Lemma sweep_signs : 0 < x /\ 0 < sinh x /\ 1 < cosh x /\ cosh x ^ 2 = 1 + sinh x ^ 2 /\ 0 < u < 1
  /\ 0 < sin q /\ 0 < cos q /\ sin q ^ 2 = 1 - cos q ^ 2 /\ r * sinh x * cos q = sin q * cosh x.
Proof.
  pose proof PI_RGT_0; assert (X : 0 < x) by (unfold x; positive).
  pose proof (sinh_pos x X) as S; pose proof (cosh_beyond x ltac:(lra)) as C; pose proof (cosh_square x).
  assert (U : 0 < u < 1).
  { unfold u; split; [apply Rinv_0_lt_compat; lra |]; rewrite <- Rinv_1; apply Rinv_lt_contravar; lra. }
  assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra).
  repeat split; try lra; [apply sin_square |].
  assert (E : tan q = r * tanh x) by (rewrite <- T; apply tan_atan); unfold tan, tanh in E.
  replace (sin q * cosh x) with (sin q / cos q * (cos q * cosh x)) by (field; lra); rewrite E; field; lra.
Qed.
Lemma sweep_w : 0 < w /\ (1 + w ^ 2) * (cos q * u) ^ 2 = 1 /\ w ^ 2 * (cos q * u) ^ 2 = 1 - (cos q * u) ^ 2.
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]].
  assert (W : 0 < w) by (unfold w; apply Rmult_lt_0_compat; [apply sqrt_lt_R0, one_more | exact S]).
  assert (W2 : (1 + w ^ 2) * cos q ^ 2 = cosh x ^ 2).
  { unfold w; rewrite Rpow_mult_distr, pow2_sqrt by (left; apply one_more).
    replace ((1 + (r ^ 2 + 1) * sinh x ^ 2) * cos q ^ 2) with ((1 + sinh x ^ 2) * cos q ^ 2 + (r * sinh x * cos q) ^ 2) by ring.
    rewrite E, <- C2, Rpow_mult_distr, S2; ring. }
  split; [exact W |]; assert (G : (1 + w ^ 2) * (cos q * u) ^ 2 = 1).
  { rewrite Rpow_mult_distr, <- Rmult_assoc, W2; unfold u; field; lra. }
  split; [exact G | lra].
Qed.
Lemma sweep_angle : atan (/ w) = angle_of q u * (w / (1 + w ^ 2)) /\ 1 <= angle_of q u.
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_w as [W [G H]].
  assert (N : 0 < cos q * u) by (apply Rmult_lt_0_compat; lra).
  set (g := cos q * u) in *.
  assert (V : sqrt (1 - g ^ 2) = w * g).
  { apply sqrt_unique; [nra |]; rewrite Rpow_mult_distr; exact H. }
  assert (F : w / (1 + w ^ 2) = g * (w * g)).
  { apply (Rmult_eq_reg_r (1 + w ^ 2)); [| nra]; replace (w / (1 + w ^ 2) * (1 + w ^ 2)) with w by (field; nra).
    replace (g * (w * g) * (1 + w ^ 2)) with (w * ((1 + w ^ 2) * g ^ 2)) by ring; rewrite G; ring. }
  unfold angle_of; fold g; rewrite V, F; replace (g / (w * g)) with (/ w) by (field; lra); split.
  - field; split; lra.
  - apply (Rmult_le_reg_r (g * (w * g))); [positive |].
    replace (atan (/ w) / (g * (w * g)) * (g * (w * g))) with (atan (/ w)) by (field; lra); rewrite Rmult_1_l, <- F.
    replace (w / (1 + w ^ 2)) with (/ w / (1 + (/ w) ^ 2)) by (field; repeat split; nra).
    apply atan_least; left; positive.
Qed.

Let d := PI + q - s.
Lemma sinh_minus y z : sinh (y - z) = sinh y * cosh z - cosh y * sinh z.
Proof.
  unfold Rminus at 1; rewrite !sinh_law, !cosh_law, exp_plus, exp_Ropp.
  pose proof (exp_pos y); pose proof (exp_pos z); field; lra.
Qed.
Lemma sweep_tangents : 0 < sinh (k * s) /\ 0 < cosh (k * s) /\ q = atan (sin q / cos q) /\ 0 < sin q / cos q
  /\ r * tanh (k * s) = sin q / cos q * (cosh x * sinh (k * s) / (sinh x * cosh (k * s)))
  /\ 0 < r * tanh (k * s).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]].
  assert (Y : 0 < k * s) by positive; pose proof (sinh_pos _ Y) as A; pose proof (cosh_pos (k * s)) as D.
  assert (F : sin q / cos q = r * tanh x).
  { unfold tanh; apply (Rmult_eq_reg_r (cos q * cosh x)); [| apply Rgt_not_eq; positive].
    replace (sin q / cos q * (cos q * cosh x)) with (sin q * cosh x) by (field; lra); rewrite <- E; field; lra. }
  repeat split; try assumption.
  - rewrite F; symmetry; exact T.
  - apply Rdiv_lt_0_compat; lra.
  - rewrite F; unfold tanh; field; repeat split; lra.
  - apply Rmult_lt_0_compat; [exact R0 | apply tanh_pos, Y].
Qed.
(* k coth x against cosh x alone. *)
Lemma sweep_coth z : 0 <= z -> z * k * cosh x / sinh x <= z * (u + 2) / (3 * (PI + q) * u).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; intros Z; pose proof PI_RGT_0.
  replace (z * k * cosh x / sinh x) with (z * (3 * (k * (PI + q)) * cosh x) / (3 * (PI + q) * sinh x)) by (field; split; lra).
  replace (z * (u + 2) / (3 * (PI + q) * u)) with (z * ((1 + 2 * cosh x) * sinh x) / (3 * (PI + q) * sinh x)) by (unfold u; field; repeat split; lra).
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; positive |].
  apply Rmult_le_compat_l; [exact Z | fold x; apply coth_by_cosh; lra].
Qed.
Lemma sweep_short : 0 <= d -> d <= s -> 0 <= k * (PI + q - p1)
  /\ k * (PI + q - p1) * cosh x / sinh x <= gap d s q u.
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_tangents as [A [D [F [G [H I]]]]].
  intros D0 D1; pose proof PI_RGT_0.
  pose proof (sinh_share (k * d) (k * s) ltac:(apply Rmult_le_pos; lra) ltac:(apply Rmult_le_compat_l; lra)) as V.
  assert (M : sinh (k * d) = sinh x * cosh (k * s) - cosh x * sinh (k * s)).
  { rewrite <- sinh_minus; f_equal; unfold d, x; ring. }
  assert (V' : s * sinh (k * d) <= d * sinh (k * s)) by (apply (Rmult_le_reg_l k); lra).
  assert (N : 0 <= sinh (k * d)) by (rewrite <- sinh_0; apply sinh_grows, Rmult_le_pos; lra).
  set (z := / (1 + sin q / cos q * (r * tanh (k * s))) * (sin q / cos q - r * tanh (k * s))).
  pose proof (atan_difference _ _ z G I eq_refl) as J.
  assert (L : z = sin q * cos q * sinh (k * d) / (cosh x * sinh (k * s) + cos q ^ 2 * sinh (k * d))).
  { unfold z; rewrite H, M; replace (cosh x * sinh (k * s) + cos q ^ 2 * (sinh x * cosh (k * s) - cosh x * sinh (k * s)))
      with (cos q ^ 2 * (sinh x * cosh (k * s)) + sin q ^ 2 * (cosh x * sinh (k * s))) by (rewrite S2; ring).
    field; repeat split; try lra; apply Rgt_not_eq; positive. }
  assert (P : 0 < cosh x * sinh (k * s) + cos q ^ 2 * sinh (k * d)) by (assert (0 < cosh x * sinh (k * s)) by positive; assert (0 <= cos q ^ 2 * sinh (k * d)) by positive; lra).
  assert (Z : 0 <= z) by (rewrite L; apply Rmult_le_pos; [apply Rmult_le_pos; [left; positive | exact N] | left; positive]).
  pose proof (atan_at_most z Z) as W.
  assert (Z2 : z <= d * (sin q * cos q) * u / (s + d * cos q ^ 2 * u)).
  { rewrite L; unfold u; assert (Q1 : 0 < s * cosh x + d * cos q ^ 2) by (assert (0 < s * cosh x) by positive; assert (0 <= d * cos q ^ 2) by positive; lra).
    replace (d * (sin q * cos q) * / cosh x / (s + d * cos q ^ 2 * / cosh x)) with (d * (sin q * cos q) / (s * cosh x + d * cos q ^ 2)) by (field; split; lra).
    apply (Rmult_le_reg_r ((s * cosh x + d * cos q ^ 2) * (cosh x * sinh (k * s) + cos q ^ 2 * sinh (k * d)))); [positive |].
    match goal with |- ?l <= ?m => replace l with (sin q * cos q * (sinh (k * d) * (s * cosh x + d * cos q ^ 2))) by (field; lra);
      replace m with (sin q * cos q * (d * (cosh x * sinh (k * s) + cos q ^ 2 * sinh (k * d)))) by (field; lra) end.
    apply Rmult_le_compat_l; [left; positive |].
    assert (cosh x * (s * sinh (k * d)) <= cosh x * (d * sinh (k * s))) by (apply Rmult_le_compat_l; lra); lra. }
  assert (O : PI + q - p1 = atan z) by (unfold p1; rewrite F at 1; lra).
  assert (O1 : 0 <= atan z) by (destruct Z as [Z|Z]; [left; apply atan_above, Z | rewrite <- Z, atan_0; lra]).
  rewrite O; split; [apply Rmult_le_pos; lra |].
  apply Rle_trans with (z * k * cosh x / sinh x).
  { apply Rmult_le_compat_r; [left; positive |]; apply Rmult_le_compat_r; [lra |]; rewrite (Rmult_comm z k); apply Rmult_le_compat_l; lra. }
  eapply Rle_trans; [apply sweep_coth, Z |].
  unfold gap; replace (d * (sin q * cos q) * (u + 2) / (3 * (PI + q) * (s + d * cos q ^ 2 * u)))
    with (d * (sin q * cos q) * u / (s + d * cos q ^ 2 * u) * (u + 2) / (3 * (PI + q) * u)) by
    (assert (0 < s + d * cos q ^ 2 * u) by (assert (0 <= d * cos q ^ 2 * u) by positive; lra); field; repeat split; lra).
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; positive |].
  apply Rmult_le_compat_r; lra.
Qed.
Lemma sweep_long : d <= 0 -> - d < s -> 0 <= k * (p1 - PI - q)
  /\ k * (p1 - PI - q) * cosh x / sinh x <= - gap d s q u.
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_tangents as [A [D [F [G [H I]]]]].
  intros D0 D1; pose proof PI_RGT_0; set (m := - d) in *.
  assert (M0 : 0 <= m) by (unfold m; lra).
  pose proof (sinh_share (k * m) (k * s) ltac:(apply Rmult_le_pos; lra) ltac:(apply Rmult_le_compat_l; lra)) as V.
  assert (M : sinh (k * m) = cosh x * sinh (k * s) - sinh x * cosh (k * s)).
  { replace (k * m) with (k * s - x) by (unfold m, d, x; ring); rewrite sinh_minus; ring. }
  assert (V' : s * sinh (k * m) <= m * sinh (k * s)) by (apply (Rmult_le_reg_l k); lra).
  assert (N : 0 <= sinh (k * m)) by (rewrite <- sinh_0; apply sinh_grows, Rmult_le_pos; lra).
  assert (C0 : cos q ^ 2 <= 1) by (rewrite <- (Rplus_0_l (cos q ^ 2)); pose proof (pow2_ge_0 (sin q)); lra).
  assert (N1 : sinh (k * m) < sinh (k * s)) by (apply sinh_rises, Rmult_lt_compat_l; lra).
  set (z := / (1 + r * tanh (k * s) * (sin q / cos q)) * (r * tanh (k * s) - sin q / cos q)).
  pose proof (atan_difference _ _ z I G eq_refl) as J.
  assert (P : 0 < cosh x * sinh (k * s) - cos q ^ 2 * sinh (k * m)).
  { assert (cos q ^ 2 * sinh (k * m) <= 1 * sinh (k * m)) by (apply Rmult_le_compat_r; lra).
    assert (1 * sinh (k * s) <= cosh x * sinh (k * s)) by (apply Rmult_le_compat_r; lra); lra. }
  assert (L : z = sin q * cos q * sinh (k * m) / (cosh x * sinh (k * s) - cos q ^ 2 * sinh (k * m))).
  { unfold z; rewrite H, M; replace (cosh x * sinh (k * s) - cos q ^ 2 * (cosh x * sinh (k * s) - sinh x * cosh (k * s)))
      with (cos q ^ 2 * (sinh x * cosh (k * s)) + sin q ^ 2 * (cosh x * sinh (k * s))) by (rewrite S2; ring).
    field; repeat split; try lra; apply Rgt_not_eq; positive. }
  assert (Z : 0 <= z) by (rewrite L; apply Rmult_le_pos; [apply Rmult_le_pos; [left; positive | exact N] | left; apply Rinv_0_lt_compat; exact P]).
  pose proof (atan_at_most z Z) as W.
  assert (Q1 : 0 < s * cosh x - m * cos q ^ 2).
  { assert (m * cos q ^ 2 <= m * 1) by (apply Rmult_le_compat_l; lra); assert (s * 1 <= s * cosh x) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Z2 : z <= m * (sin q * cos q) * u / (s - m * cos q ^ 2 * u)).
  { rewrite L; unfold u.
    replace (m * (sin q * cos q) * / cosh x / (s - m * cos q ^ 2 * / cosh x)) with (m * (sin q * cos q) / (s * cosh x - m * cos q ^ 2)) by (field; split; lra).
    apply (Rmult_le_reg_r ((s * cosh x - m * cos q ^ 2) * (cosh x * sinh (k * s) - cos q ^ 2 * sinh (k * m)))); [apply Rmult_lt_0_compat; lra |].
    match goal with |- ?l <= ?o => replace l with (sin q * cos q * (sinh (k * m) * (s * cosh x - m * cos q ^ 2))) by (field; lra);
      replace o with (sin q * cos q * (m * (cosh x * sinh (k * s) - cos q ^ 2 * sinh (k * m)))) by (field; lra) end.
    apply Rmult_le_compat_l; [left; positive |].
    assert (cosh x * (s * sinh (k * m)) <= cosh x * (m * sinh (k * s))) by (apply Rmult_le_compat_l; lra); lra. }
  assert (O : p1 - PI - q = atan z) by (unfold p1; rewrite F at 1; lra).
  assert (O1 : 0 <= atan z) by (destruct Z as [Z|Z]; [left; apply atan_above, Z | rewrite <- Z, atan_0; lra]).
  rewrite O; split; [apply Rmult_le_pos; lra |].
  apply Rle_trans with (z * k * cosh x / sinh x).
  { apply Rmult_le_compat_r; [left; positive |]; apply Rmult_le_compat_r; [lra |]; rewrite (Rmult_comm z k); apply Rmult_le_compat_l; lra. }
  eapply Rle_trans; [apply sweep_coth, Z |].
  assert (U1 : 0 < s - m * cos q ^ 2 * u).
  { replace (s - m * cos q ^ 2 * u) with ((s * cosh x - m * cos q ^ 2) * u) by (unfold u; field; lra); apply Rmult_lt_0_compat; lra. }
  unfold gap; replace (- (d * (sin q * cos q) * (u + 2) / (3 * (PI + q) * (s + d * cos q ^ 2 * u))))
    with (m * (sin q * cos q) * u / (s - m * cos q ^ 2 * u) * (u + 2) / (3 * (PI + q) * u)).
  - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; positive |]; apply Rmult_le_compat_r; lra.
  - replace d with (- m) by (unfold m; ring).
    replace (s + - m * cos q ^ 2 * u) with (s - m * cos q ^ 2 * u) by ring; field; repeat split; lra.
Qed.
Lemma sweep_long_sharp t : d < 0 -> - d < s -> 0 < t -> tanh (k * - d) <= x * t ->
  k * (p1 - PI - q) * cosh x / sinh x <= sharp_gap t q x.
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_tangents as [A [D [F [G [H I]]]]].
  intros D0 D1 T0 T1; pose proof PI_RGT_0; set (m := - d) in *.
  pose proof (cosh_pos (k * m)) as CM; assert (KM : 0 < k * m) by (apply Rmult_lt_0_compat; unfold m; lra).
  pose proof (sinh_pos _ KM) as SM; pose proof (tanh_pos _ KM) as TM; set (v := tanh (k * m)) in *.
  assert (VE : sinh (k * m) = v * cosh (k * m)) by (unfold v, tanh; field; lra).
  assert (M : sinh (k * m) = cosh x * sinh (k * s) - sinh x * cosh (k * s)).
  { replace (k * m) with (k * s - x) by (unfold m, d, x; ring); rewrite sinh_minus; ring. }
  assert (M2 : sinh (k * s) = sinh x * cosh (k * m) + cosh x * sinh (k * m)).
  { replace (k * s) with (x + k * m) by (unfold m, d, x; ring).
    rewrite !sinh_law, !cosh_law, exp_plus; pose proof (exp_pos x); pose proof (exp_pos (k * m)); field; lra. }
  set (z := / (1 + r * tanh (k * s) * (sin q / cos q)) * (r * tanh (k * s) - sin q / cos q)).
  pose proof (atan_difference _ _ z I G eq_refl) as J.
  set (o := sinh x ^ 2 + sin q ^ 2); assert (O0 : 0 < o) by (unfold o; positive).
  assert (P : cosh x * sinh (k * s) - cos q ^ 2 * sinh (k * m) = cosh (k * m) * (cosh x * sinh x + v * o)).
  { rewrite M2, VE; unfold o; replace (cosh x * (sinh x * cosh (k * m) + cosh x * (v * cosh (k * m))) - cos q ^ 2 * (v * cosh (k * m)))
      with (cosh (k * m) * (cosh x * sinh x + v * (cosh x ^ 2 - cos q ^ 2))) by ring; rewrite C2, S2; ring. }
  assert (L : z = sin q * cos q * v / (cosh x * sinh x + v * o)).
  { replace (sin q * cos q * v / (cosh x * sinh x + v * o))
      with (sin q * cos q * sinh (k * m) / (cosh x * sinh (k * s) - cos q ^ 2 * sinh (k * m))) by (rewrite P, VE; field; split; [apply Rgt_not_eq; positive | lra]).
    unfold z; rewrite H, M; replace (cosh x * sinh (k * s) - cos q ^ 2 * (cosh x * sinh (k * s) - sinh x * cosh (k * s)))
      with (cos q ^ 2 * (sinh x * cosh (k * s)) + sin q ^ 2 * (cosh x * sinh (k * s))) by (rewrite S2; ring).
    field; repeat split; try lra; apply Rgt_not_eq; positive. }
  assert (W0 : 0 < cosh x * sinh x) by positive; assert (W1 : 0 < x * t) by positive.
  assert (Z : 0 < z) by (rewrite L; positive).
  assert (Z2 : z <= sin q * cos q * (x * t) / (cosh x * sinh x + x * t * o)).
  { rewrite L; apply (Rmult_le_reg_r ((cosh x * sinh x + v * o) * (cosh x * sinh x + x * t * o))); [positive |].
    match goal with |- ?l <= ?i => replace l with (sin q * cos q * (v * (cosh x * sinh x + x * t * o))) by (field; apply Rgt_not_eq; positive);
      replace i with (sin q * cos q * (x * t * (cosh x * sinh x + v * o))) by (field; apply Rgt_not_eq; positive) end.
    apply Rmult_le_compat_l; [left; positive |].
    assert (v * (cosh x * sinh x) <= x * t * (cosh x * sinh x)) by (apply Rmult_le_compat_r; lra); lra. }
  assert (O : p1 - PI - q = atan z) by (unfold p1; rewrite F at 1; lra).
  pose proof (atan_at_most z ltac:(lra)) as W; pose proof (atan_above z Z).
  pose proof (sinh_least x ltac:(lra)) as SL; pose proof (coth_by_square x ltac:(lra)) as CL.
  set (g := 1 + x ^ 2 * (1 / 6 + x ^ 2 / 120)) in *; assert (G0 : 1 <= g).
  { pose proof (pow2_ge_0 x); assert (0 <= x ^ 2 * (1 / 6 + x ^ 2 / 120)) by (apply Rmult_le_pos; lra); unfold g; lra. }
  rewrite O; apply Rle_trans with (k * (sin q * cos q * (x * t) / (cosh x * sinh x + x * t * o)) * cosh x / sinh x).
  { apply Rmult_le_compat_r; [left; positive |]; apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_l; lra. }
  replace (k * (sin q * cos q * (x * t) / (cosh x * sinh x + x * t * o)) * cosh x / sinh x)
    with (sin q * cos q * t / (((sinh x / x) ^ 2 + t * o * (sinh x / (x * cosh x))) * (PI + q))).
  - unfold sharp_gap; fold g o; apply Rmult_le_compat_l; [left; positive |].
    assert (0 < 1 + x ^ 2 / 3) by (pose proof (pow2_ge_0 x); lra).
    apply Rinv_le_contravar; [positive |]; apply Rmult_le_compat_r; [lra |]; apply Rplus_le_compat.
    + apply pow_incr; split; [lra |]; apply (Rmult_le_reg_r x); [lra |]; replace (sinh x / x * x) with (sinh x) by (field; lra); lra.
    + unfold Rdiv at 1; apply Rmult_le_compat_l; [left; positive |].
      apply (Rmult_le_reg_r ((1 + x ^ 2 / 3) * (x * cosh x))); [positive |].
      replace (/ (1 + x ^ 2 / 3) * ((1 + x ^ 2 / 3) * (x * cosh x))) with (x * cosh x) by (field; lra).
      replace (sinh x / (x * cosh x) * ((1 + x ^ 2 / 3) * (x * cosh x))) with ((1 + x ^ 2 / 3) * sinh x) by (field; lra); exact CL.
  - replace k with (x / (PI + q)) by (unfold x; field; lra); field; repeat split; try lra; apply Rgt_not_eq; positive.
Qed.
Lemma end_of_long lim Y : d < 0 -> - d < s -> Y <= 1 / 20 -> k * (p1 - PI - q) * cosh x / sinh x <= Y ->
  ahead Y u <= lim * angle_of q u * (1 + ahead Y u * (1 - (cos q * u) ^ 2)) ->
  0 <= atan (/ w) - atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p1))) <= lim * atan (/ w).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_w as [W [WG WH]]; destruct sweep_angle as [AE A1].
  intros D0 D1 Y1; destruct (sweep_long ltac:(lra) D1) as [H0 _]; intros Y2 L; pose proof PI_RGT_0.
  set (h := k * (p1 - PI - q)) in *; set (y := h * cosh x / sinh x) in *.
  assert (Y0 : 0 <= y) by (unfold y; apply Rmult_le_pos; [positive | left; positive]).
  assert (HS : h * cosh x = y * sinh x) by (unfold y; field; lra).
  assert (HY : h <= y).
  { apply (Rmult_le_reg_r (cosh x)); [lra |]; rewrite HS; pose proof (sinh_under x); apply Rmult_le_compat_l; lra. }
  destruct (sinh_ahead x h X H0 ltac:(lra)) as [SA _]; replace (x + h) with (k * p1) in SA by (unfold h, x; ring).
  assert (HU : h ^ 2 = y ^ 2 * (1 - u ^ 2)).
  { assert (UC : u * cosh x = 1) by (unfold u; field; lra).
    apply (Rmult_eq_reg_r (cosh x ^ 2)); [| apply Rgt_not_eq; positive].
    replace (h ^ 2 * cosh x ^ 2) with ((h * cosh x) ^ 2) by ring; rewrite HS.
    replace (y ^ 2 * (1 - u ^ 2) * cosh x ^ 2) with (y ^ 2 * (cosh x ^ 2 - (u * cosh x) ^ 2)) by ring; rewrite UC, C2; ring. }
  set (f := 1 - u ^ 2) in *; assert (F0 : 0 < f < 1) by (unfold f; pose proof (square_in u U); lra).
  assert (YF : 0 <= y * f) by (apply Rmult_le_pos; lra).
  assert (V : sinh (k * p1) <= sinh x * (1 + ahead Y u)).
  { eapply Rle_trans; [exact SA |]; rewrite <- Rmult_assoc, (Rmult_comm (cosh x)), HS, HU; unfold ahead; fold f.
    replace (sinh x * (1 + 51 / 100 * (y ^ 2 * f)) + y * sinh x * (1 + 17 / 100 * (y ^ 2 * f)))
      with (sinh x * (1 + y * (1 + y * f * (51 / 100 + 17 / 100 * y)))) by field.
    apply Rmult_le_compat_l; [lra |]; apply Rplus_le_compat_l; apply Rmult_le_compat; try lra; [apply Rplus_le_le_0_compat; [lra |]; apply Rmult_le_pos; [exact YF | lra] |].
    apply Rplus_le_compat_l; apply Rle_trans with (y * f * (52 / 100)); [apply Rmult_le_compat_l; [exact YF | lra] |].
    assert (y * f <= Y * f) by (apply Rmult_le_compat_r; lra); lra. }
  assert (V1 : sinh x <= sinh (k * p1)) by (apply sinh_grows; unfold h in H0; unfold x; lra).
  assert (RR : 0 < sqrt (r ^ 2 + 1)) by (apply sqrt_lt_R0, one_more).
  set (v := sqrt (r ^ 2 + 1) * sinh (k * p1)); set (a := ahead Y u) in *.
  assert (A0 : 0 <= a) by (unfold a, ahead; fold f; assert (0 <= Y * f) by (apply Rmult_le_pos; lra); apply Rmult_le_pos; lra).
  assert (WV : w <= v) by (unfold w, v; apply Rmult_le_compat_l; lra).
  assert (VW : v <= w * (1 + a)) by (unfold w, v; rewrite Rmult_assoc; apply Rmult_le_compat_l; lra).
  split.
  - enough (atan (/ v) <= atan (/ w)) by lra; apply arctangent_rises, Rinv_le_contravar; lra.
  - eapply Rle_trans; [apply (angle_loss w v a W A0 WV VW) |].
    set (g := (cos q * u) ^ 2) in *; assert (G0 : 0 < g) by (unfold g; positive).
    assert (G1 : 0 < 1 - g) by (rewrite <- WH; positive); assert (W1 : 0 < 1 + w ^ 2) by (pose proof (pow2_ge_0 w); lra).
    assert (A2 : 0 < 1 + a * (1 - g)) by (assert (0 <= a * (1 - g)) by (apply Rmult_le_pos; lra); lra).
    rewrite AE; replace (lim * (angle_of q u * (w / (1 + w ^ 2)))) with (lim * angle_of q u * (w / (1 + w ^ 2))) by ring.
    apply (Rmult_le_reg_r ((1 + w ^ 2) * (1 + a * (1 - g)) / w)); [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact W] |].
    replace (w * a / ((1 + a) * w ^ 2 + 1) * ((1 + w ^ 2) * (1 + a * (1 - g)) / w)) with a.
    + replace (lim * angle_of q u * (w / (1 + w ^ 2)) * ((1 + w ^ 2) * (1 + a * (1 - g)) / w))
        with (lim * angle_of q u * (1 + a * (1 - g))) by (field; split; lra); exact L.
    + replace ((1 + w ^ 2) * (1 + a * (1 - g))) with ((1 + a) * w ^ 2 + 1); [field; split; [lra |]; assert (0 <= (1 + a) * w ^ 2) by positive; lra |].
      assert (H1 : (1 + w ^ 2) * (1 - g) = w ^ 2) by lra; replace ((1 + w ^ 2) * (1 + a * (1 - g))) with (1 + w ^ 2 + a * ((1 + w ^ 2) * (1 - g))) by ring; rewrite H1; ring.
Qed.
Lemma end_of_sweep lim : 0 <= d -> d <= s -> gap d s q u < 1 ->
  gap d s q u / (1 - gap d s q u) <= lim * angle_of q u ->
  0 <= atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p1))) - atan (/ w) <= lim * atan (/ w).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_w as [W _]; destruct sweep_angle as [AE A1].
  intros D0 D1 G1 L; destruct (sweep_short D0 D1) as [H0 Y1].
  set (h := k * (PI + q - p1)) in *; set (y := h * cosh x / sinh x) in *; set (g := gap d s q u) in *.
  assert (Y0 : 0 <= y) by (unfold y; apply Rmult_le_pos; [positive | left; positive]).
  assert (HS : h * cosh x = y * sinh x) by (unfold y; field; lra).
  pose proof (sinh_below_cosh x ltac:(lra)) as N.
  assert (HX : h <= x).
  { apply (Rmult_le_reg_r (cosh x)); [lra |]; rewrite HS; assert (y * sinh x <= 1 * sinh x) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (sinh_back x h H0 HX) as V; replace (x - h) with (k * p1) in V by (unfold h, x; ring).
  assert (V1 : sinh (k * p1) <= sinh x) by (apply sinh_grows; unfold x; unfold h in H0; lra).
  assert (RR : 0 < sqrt (r ^ 2 + 1)) by (apply sqrt_lt_R0, one_more).
  assert (WV : w * (1 - y) <= sqrt (r ^ 2 + 1) * sinh (k * p1)).
  { unfold w; rewrite Rmult_assoc; apply Rmult_le_compat_l; lra. }
  assert (V0 : 0 < sqrt (r ^ 2 + 1) * sinh (k * p1)).
  { apply Rmult_lt_0_compat; [exact RR |]; assert (0 < sinh x * (1 - y)) by (apply Rmult_lt_0_compat; lra); lra. }
  split.
  - enough (atan (/ w) <= atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p1)))) by lra.
    apply arctangent_rises, Rinv_le_contravar; [exact V0 | unfold w; apply Rmult_le_compat_l; lra].
  - eapply Rle_trans; [apply (angle_gain w _ y W ltac:(lra) WV) |].
    rewrite AE, <- Rmult_assoc; apply Rmult_le_compat_r; [left; apply Rdiv_lt_0_compat; [exact W | pose proof (pow2_ge_0 w); lra] |].
    eapply Rle_trans; [| exact L]; unfold Rdiv; apply Rmult_le_compat; try lra;
      [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra].
Qed.

(* A step of Newton's from the phase p1. *)
Let D t := 1 + (r ^ 2 + 1) * sinh (k * t) ^ 2.
Let p2 := p1 - (p1 - PI - atan (r * tanh (k * p1))) / (1 - k * r / D p1).
Lemma phase_slope t : is_derive (fun y : R => y - PI - atan (r * tanh (k * y))) t (1 - k * r / D t).
Proof.
  pose proof (cosh_pos (k * t)) as C; pose proof (cosh_square (k * t)) as E.
  eapply d_eq.
  - apply (d_minus (fun y : R => y - PI) (fun y : R => atan (r * tanh (k * y)))).
    + derive.
    + apply (d_atan (fun y : R => r * tanh (k * y))); apply (d_mult (fun _ : R => r) (fun y : R => tanh (k * y))); [apply d_const |].
      apply (d_tanh (fun y : R => k * y)); derive.
  - tidy; unfold D, tanh; replace (1 + (r ^ 2 + 1) * sinh (k * t) ^ 2) with (cosh (k * t) ^ 2 + r ^ 2 * sinh (k * t) ^ 2) by (rewrite E; ring).
    field; split; [apply Rgt_not_eq; nra | lra].
Qed.
Lemma D_above t : 0 < t -> 1 < D t.
Proof. intros H; pose proof (sinh_pos (k * t) ltac:(nra)); unfold D; nra. Qed.
Lemma D_apart lo hi y z : 0 <= lo -> lo <= y -> y <= z -> z <= hi ->
  0 <= D z - D y <= 2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi) * (z - y).
Proof.
  intros L Y Z H; destruct (sinh_slope (k * y) (k * z) ltac:(nra)) as [c [C E]].
  pose proof (cosh_rises c (k * hi) ltac:(nra) ltac:(nra)) as V; pose proof (cosh_pos c).
  pose proof (sinh_grows (k * y) (k * hi) ltac:(nra)); pose proof (sinh_grows (k * z) (k * hi) ltac:(nra)).
  assert (P : 0 <= sinh (k * y)) by (rewrite <- sinh_0; apply sinh_grows; nra).
  assert (P1 : 0 <= sinh (k * z)) by (rewrite <- sinh_0; apply sinh_grows; nra).
  assert (F : D z - D y = (r ^ 2 + 1) * ((sinh (k * z) + sinh (k * y)) * (cosh c * (k * (z - y))))).
  { replace (k * (z - y)) with (k * z - k * y) by ring; rewrite <- E; unfold D; ring. }
  assert (N : 0 <= k * (z - y)) by nra; rewrite F; split; [apply Rmult_le_pos; [nra |]; apply Rmult_le_pos; [lra |]; apply Rmult_le_pos; [lra | exact N] |].
  replace (2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi) * (z - y))
    with ((r ^ 2 + 1) * ((2 * sinh (k * hi)) * (cosh (k * hi) * (k * (z - y))))) by ring.
  apply Rmult_le_compat_l; [nra |]; apply Rmult_le_compat; [lra | apply Rmult_le_pos; lra | lra |].
  apply Rmult_le_compat_r; lra.
Qed.
Lemma newton_step lo hi : 0 < lo -> lo <= p1 <= hi -> lo <= PI + q <= hi ->
  0 <= p2 - (PI + q) <= k * r * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi)
    * (p1 - (PI + q)) ^ 2 / (D lo * (D p1 - k * r)).
Proof.
  intros L P1 P; pose proof (D_above lo L) as DL; pose proof (D_above p1 ltac:(lra)) as DP.
  set (M := k * r * (2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi)) / (D lo * D p1)).
  set (F := fun t : R => t - PI - atan (r * tanh (k * t))).
  assert (F0 : F (PI + q) = 0) by (unfold F; fold x; rewrite T; ring).
  assert (KR : 0 < k * r) by (apply Rmult_lt_0_compat; lra); set (N := 1 - k * r / D p1).
  assert (N0 : N = (D p1 - k * r) / D p1) by (unfold N; field; lra).
  set (f := fun t : R => t - PI - atan (r * tanh (k * t)) - N * (t - p1) - F p1).
  assert (df : forall t, is_derive f t (k * r / D p1 - k * r / D t)).
  { intros t; unfold f; eapply d_eq.
    - apply (d_minus (fun t : R => t - PI - atan (r * tanh (k * t)) - N * (t - p1)) (fun _ : R => F p1)); [| apply d_const].
      apply (d_minus (fun t : R => t - PI - atan (r * tanh (k * t))) (fun t : R => N * (t - p1))); [apply phase_slope | derive].
    - tidy; unfold N; ring. }
  set (g := fun t : R => M / 2 * (t - p1) ^ 2 - f t).
  assert (dg : forall t, is_derive g t (M * (t - p1) - (k * r / D p1 - k * r / D t))).
  { intros t; unfold g; eapply d_eq.
    - apply (d_minus (fun t : R => M / 2 * (t - p1) ^ 2) f); [derive | apply df].
    - tidy; generalize (k * r / D p1) (k * r / D t); intros; field. }
  assert (f1 : f p1 = 0) by (unfold f, F; ring).
  assert (Fo : forall t, lo <= t -> k * r / D p1 - k * r / D t = k * r * (D t - D p1) / (D t * D p1)).
  { intros t Ht; pose proof (D_above t ltac:(lra)); field; lra. }
  assert (V : 0 <= f (PI + q) <= M / 2 * (PI + q - p1) ^ 2).
  { destruct (Rle_or_lt p1 (PI + q)) as [O|O]; split.
    - apply (from_left_ge f _ p1 (PI + q) O (fun t _ => df t)); [| rewrite f1; lra].
      intros t Ht; rewrite Fo by lra; destruct (D_apart lo hi p1 t) as [A1 A2]; try lra; pose proof (D_above t ltac:(lra)).
      apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra].
    - enough (0 <= g (PI + q)) by (unfold g in *; lra).
      apply (from_left_ge g _ p1 (PI + q) O (fun t _ => dg t)); [| unfold g; rewrite f1; lra].
      intros t Ht; rewrite Fo by lra; destruct (D_apart lo hi p1 t) as [A1 A2]; try lra; pose proof (D_above t ltac:(lra)).
      destruct (D_apart lo hi lo t) as [A3 _]; try lra.
      enough (k * r * (D t - D p1) / (D t * D p1) <= M * (t - p1)) by lra.
      unfold M; replace (k * r * (2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi)) / (D lo * D p1) * (t - p1))
        with (k * r * (2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi) * (t - p1)) / (D lo * D p1)) by (field; lra).
      apply Rmult_le_compat; [nra | left; apply Rinv_0_lt_compat; nra | apply Rmult_le_compat_l; lra | apply Rinv_le_contravar; nra].
    - apply (from_right_ge f _ p1 (PI + q) ltac:(lra) (fun t _ => df t)); [| rewrite f1; lra].
      intros t Ht; rewrite Fo by lra; destruct (D_apart lo hi t p1) as [A1 A2]; try lra; pose proof (D_above t ltac:(lra)).
      enough (0 <= k * r * (D p1 - D t) / (D t * D p1)) by (replace (k * r * (D t - D p1) / (D t * D p1)) with (- (k * r * (D p1 - D t) / (D t * D p1))) by (field; lra); lra).
      apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra].
    - enough (0 <= g (PI + q)) by (unfold g in *; lra).
      apply (from_right_ge g _ p1 (PI + q) ltac:(lra) (fun t _ => dg t)); [| unfold g; rewrite f1; lra].
      intros t Ht; rewrite Fo by lra; destruct (D_apart lo hi t p1) as [A1 A2]; try lra; pose proof (D_above t ltac:(lra)).
      destruct (D_apart lo hi lo t) as [A3 _]; try lra.
      enough (k * r * (D p1 - D t) / (D t * D p1) <= M * (p1 - t)) by
        (replace (k * r * (D t - D p1) / (D t * D p1)) with (- (k * r * (D p1 - D t) / (D t * D p1))) by (field; lra); lra).
      unfold M; replace (k * r * (2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi)) / (D lo * D p1) * (p1 - t))
        with (k * r * (2 * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi) * (p1 - t)) / (D lo * D p1)) by (field; lra).
      apply Rmult_le_compat; [nra | left; apply Rinv_0_lt_compat; nra | apply Rmult_le_compat_l; lra | apply Rinv_le_contravar; nra]. }
  assert (G : f (PI + q) = - F p1 - N * (PI + q - p1)) by (rewrite <- (Rplus_0_l (- F p1 - _)), <- F0; unfold f, F; ring).
  assert (NP : 0 < D p1 - k * r) by lra.
  assert (H : p2 - (PI + q) = f (PI + q) * D p1 / (D p1 - k * r)).
  { rewrite G; unfold p2; fold (F p1); fold N; rewrite N0; field; split; lra. }
  rewrite H; split.
  - apply Rmult_le_pos; [positive | left; positive].
  - replace (k * r * k * (r ^ 2 + 1) * sinh (k * hi) * cosh (k * hi) * (p1 - (PI + q)) ^ 2 / (D lo * (D p1 - k * r)))
      with (M / 2 * (PI + q - p1) ^ 2 * D p1 / (D p1 - k * r)) by (unfold M; field; lra).
    apply Rmult_le_compat_r; [left; positive |]; apply Rmult_le_compat_r; lra.
Qed.
Let g := (cos q * u) ^ 2.
Let B := sin q * cos q * (u * (u + 2)) / (3 * (PI + q)).
Lemma product_small : 0 < k * r * g <= B /\ 0 < g < 1.
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; pose proof PI_RGT_0.
  assert (G : 0 < g) by (unfold g; positive).
  assert (G1 : g < 1).
  { unfold g; rewrite Rpow_mult_distr; assert (0 < cos q ^ 2) by positive; pose proof (pow2_ge_0 (sin q)); assert (u ^ 2 < 1) by nra; nra. }
  repeat split; try assumption; [assert (0 < k * r) by positive; nra |].
  pose proof (sweep_coth (sin q * cos q * u ^ 2) ltac:(left; positive)) as V.
  replace (k * r * g) with (sin q * cos q * u ^ 2 * k * cosh x / sinh x).
  - eapply Rle_trans; [exact V |]; unfold B; right; field; lra.
  - unfold g; replace (sin q * cos q * u ^ 2 * k * cosh x / sinh x) with (sin q * cosh x * (cos q * u ^ 2 * k) / sinh x) by (field; lra).
    rewrite <- E; field; lra.
Qed.
Lemma end_of_newton lim y G : 0 <= y <= G -> 0 < 1 - 2 * G - B ->
  0 <= p2 - (PI + q) ->
  k * (p2 - (PI + q)) * cosh x / sinh x <= k * r * g * (1 - g) * y ^ 2 / ((1 - 2 * y) * (1 - 2 * y - k * r * g)) ->
  newton_gap G q u < 1 -> newton_gap G q u / (1 - newton_gap G q u) <= lim * angle_of q u ->
  0 <= atan (/ w) - atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p2))) <= lim * atan (/ w).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_w as [W _]; destruct sweep_angle as [AE A1].
  destruct product_small as [BG GG]; intros Y GB P Y2 N1 L.
  assert (Z : k * (p2 - (PI + q)) * cosh x / sinh x <= newton_gap G q u).
  { eapply Rle_trans; [exact Y2 |]; unfold newton_gap; fold B; fold g.
    assert (KG : 0 <= k * r * g * (1 - g)) by (apply Rmult_le_pos; lra).
    assert (PY : 0 < (1 - 2 * G) * (1 - 2 * G - B)) by (apply Rmult_lt_0_compat; lra).
    unfold Rdiv; apply Rmult_le_compat; [apply Rmult_le_pos; [exact KG | apply pow2_ge_0] | left; apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra | |].
    - apply Rmult_le_compat; [exact KG | apply pow2_ge_0 | apply Rmult_le_compat_r; lra | apply pow_incr; lra].
    - apply Rinv_le_contravar; [exact PY |]; apply Rmult_le_compat; lra. }
  set (m := newton_gap G q u) in *; set (h := k * (p2 - (PI + q))) in *; set (z := h * cosh x / sinh x) in *.
  assert (H0 : 0 <= h) by (unfold h; apply Rmult_le_pos; lra).
  assert (Z0 : 0 <= z) by (unfold z; apply Rmult_le_pos; [positive | left; positive]).
  assert (HS : h * cosh x = z * sinh x) by (unfold z; field; lra).
  assert (XP : k * p2 = x + h) by (unfold h, x; ring).
  assert (V : sinh x <= sinh (k * p2)) by (apply sinh_grows; lra).
  assert (V1 : sinh (k * p2) * (1 - z) <= sinh x).
  { pose proof (sinh_back (k * p2) h H0 ltac:(lra)) as O; replace (k * p2 - h) with x in O by lra.
    assert (O1 : 0 <= sinh (k * p2 - x)) by (rewrite <- sinh_0; apply sinh_grows; lra).
    rewrite sinh_minus in O1; pose proof (cosh_pos (k * p2)).
    assert (h * cosh (k * p2) <= z * sinh (k * p2)); [| lra].
    apply (Rmult_le_reg_r (sinh x)); [exact S |].
    replace (z * sinh (k * p2) * sinh x) with (h * (cosh x * sinh (k * p2))) by (rewrite <- Rmult_assoc, HS; ring).
    rewrite Rmult_assoc; apply Rmult_le_compat_l; lra. }
  assert (RR : 0 < sqrt (r ^ 2 + 1)) by (apply sqrt_lt_R0, one_more).
  set (v := sqrt (r ^ 2 + 1) * sinh (k * p2)).
  assert (WV : w <= v) by (unfold w, v; apply Rmult_le_compat_l; lra).
  set (y2 := z / (1 - z)).
  assert (Y20 : 0 <= y2) by (unfold y2; apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
  assert (VW : v <= w * (1 + y2)).
  { replace (1 + y2) with (/ (1 - z)) by (unfold y2; field; lra).
    apply (Rmult_le_reg_r (1 - z)); [lra |]; replace (w * / (1 - z) * (1 - z)) with w by (field; lra).
    unfold w, v; rewrite Rmult_assoc; apply Rmult_le_compat_l; lra. }
  split.
  - enough (atan (/ v) <= atan (/ w)) by lra; apply arctangent_rises, Rinv_le_contravar; lra.
  - eapply Rle_trans; [apply (angle_loss w v y2 W Y20 WV VW) |].
    assert (M2 : y2 <= m / (1 - m)).
    { unfold y2, Rdiv; apply Rmult_le_compat; [lra | left; apply Rinv_0_lt_compat; lra | lra | apply Rinv_le_contravar; lra]. }
    apply Rle_trans with (y2 * (w / (1 + w ^ 2))).
    + assert (W1 : 0 < 1 + w ^ 2) by (pose proof (pow2_ge_0 w); lra); assert (0 <= y2 * w ^ 2) by positive.
      replace (y2 * (w / (1 + w ^ 2))) with (w * y2 / (1 + w ^ 2)) by (field; lra).
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |]; apply Rinv_le_contravar; lra.
    + rewrite AE, <- Rmult_assoc; apply Rmult_le_compat_r; [left; apply Rdiv_lt_0_compat; [exact W | pose proof (pow2_ge_0 w); lra] |]; lra.
Qed.
Lemma newton_short lim : 0 <= d -> d <= s -> 0 < 1 - 2 * gap d s q u - B ->
  newton_gap (gap d s q u) q u < 1 ->
  newton_gap (gap d s q u) q u / (1 - newton_gap (gap d s q u) q u) <= lim * angle_of q u ->
  0 <= atan (/ w) - atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p2))) <= lim * atan (/ w).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_w as [W [WG WH]].
  destruct product_small as [BG GG]; destruct (sweep_tangents) as [_ [_ [_ [_ [_ I]]]]].
  intros D0 D1 GB; destruct (sweep_short D0 D1) as [H0 Y1]; pose proof PI_RGT_0.
  set (h := k * (PI + q - p1)) in *; set (y := h * cosh x / sinh x) in *.
  assert (Y0 : 0 <= y) by (unfold y; apply Rmult_le_pos; [positive | left; positive]).
  assert (HS : h * cosh x = y * sinh x) by (unfold y; field; lra).
  pose proof (sinh_below_cosh x ltac:(lra)) as N.
  assert (HX : h <= x).
  { apply (Rmult_le_reg_r (cosh x)); [lra |]; rewrite HS; assert (y * sinh x <= 1 * sinh x) by (apply Rmult_le_compat_r; lra); lra. }
  pose proof (sinh_back x h H0 HX) as V; replace (x - h) with (k * p1) in V by (unfold h, x; ring).
  assert (P1 : PI < p1) by (unfold p1; pose proof (atan_above _ I); lra).
  assert (P2 : p1 <= PI + q) by (apply (Rmult_le_reg_l k); [lra |]; unfold h in H0; lra).
  destruct (newton_step p1 (PI + q) ltac:(lra) ltac:(lra) ltac:(lra)) as [Z1 Z2]; fold x in Z2.
  intros N1 L; apply (end_of_newton lim y (gap d s q u)); try lra; fold g in WG, WH.
  assert (DP : (1 - 2 * y) * / g <= D p1).
  { assert (1 + w ^ 2 = / g) as <- by (apply (Rmult_eq_reg_r g); [rewrite WG; field; lra | lra]).
    apply Rle_trans with (1 + (w * (1 - y)) ^ 2); [assert (0 <= w ^ 2 * y ^ 2) by positive; lra |]; unfold D, w.
    assert (O : (sinh x * (1 - y)) ^ 2 <= sinh (k * p1) ^ 2) by (apply pow_incr; split; [apply Rmult_le_pos; lra | lra]).
    replace ((sqrt (r ^ 2 + 1) * sinh x * (1 - y)) ^ 2) with (sqrt (r ^ 2 + 1) ^ 2 * (sinh x * (1 - y)) ^ 2) by ring.
    rewrite pow2_sqrt by (left; apply one_more); apply Rplus_le_compat_l, Rmult_le_compat_l; [left; apply one_more | exact O]. }
  assert (Q1 : 0 < (1 - 2 * y) * / g) by (apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]).
  assert (Q2 : 0 < (1 - 2 * y) * / g - k * r).
  { replace ((1 - 2 * y) * / g - k * r) with ((1 - 2 * y - k * r * g) * / g) by (field; lra).
    apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]. }
  apply Rle_trans with (k * r * w ^ 2 * y ^ 2 / (D p1 * (D p1 - k * r))).
  - replace (k * r * w ^ 2 * y ^ 2 / (D p1 * (D p1 - k * r))) with
      (k * (k * r * k * (r ^ 2 + 1) * sinh x * cosh x * (p1 - (PI + q)) ^ 2 / (D p1 * (D p1 - k * r))) * cosh x / sinh x).
    + unfold Rdiv at 1; apply Rmult_le_compat_r; [left; positive |]; apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_l; lra.
    + replace (w ^ 2) with ((r ^ 2 + 1) * sinh x ^ 2) by (unfold w; rewrite Rpow_mult_distr, pow2_sqrt by (left; apply one_more); reflexivity).
      replace (p1 - (PI + q)) with (- (h / k)) by (unfold h; field; lra); unfold y; field; repeat split; lra.
  - replace (k * r * g * (1 - g) * y ^ 2 / ((1 - 2 * y) * (1 - 2 * y - k * r * g)))
      with (k * r * w ^ 2 * y ^ 2 / ((1 - 2 * y) * / g * ((1 - 2 * y) * / g - k * r))).
    + unfold Rdiv; apply Rmult_le_compat_l; [apply Rmult_le_pos; [apply Rmult_le_pos; [left; positive | apply pow2_ge_0] | apply pow2_ge_0] |].
      apply Rinv_le_contravar; [positive | apply Rmult_le_compat; lra].
    + rewrite <- WH; field; repeat split; try lra.
Qed.
Lemma newton_long lim : d <= 0 -> - d < s -> - gap d s q u <= 1 / 20 -> 0 < 1 - 2 * - gap d s q u - B ->
  newton_gap (- gap d s q u) q u < 1 ->
  newton_gap (- gap d s q u) q u / (1 - newton_gap (- gap d s q u) q u) <= lim * angle_of q u ->
  0 <= atan (/ w) - atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p2))) <= lim * atan (/ w).
Proof.
  destruct sweep_signs as [X [S [C [C2 [U [SQ [CQ [S2 E]]]]]]]]; destruct sweep_w as [W [WG WH]].
  destruct product_small as [BG GG]; destruct (sweep_tangents) as [_ [_ [_ [_ [_ I]]]]].
  intros D0 D1 GS GB; destruct (sweep_long D0 D1) as [H0 Y1]; pose proof PI_RGT_0.
  set (h := k * (p1 - PI - q)) in *; set (y := h * cosh x / sinh x) in *.
  assert (Y0 : 0 <= y) by (unfold y; apply Rmult_le_pos; [positive | left; positive]).
  assert (HS : h * cosh x = y * sinh x) by (unfold y; field; lra).
  pose proof (sinh_under x) as SC.
  assert (HY : h <= y).
  { apply (Rmult_le_reg_r (cosh x)); [lra |]; rewrite HS; pose proof (sinh_under x); apply Rmult_le_compat_l; lra. }
  destruct (sinh_ahead x h X H0 ltac:(lra)) as [SA CA]; replace (x + h) with (k * p1) in SA, CA by (unfold h, x; ring).
  set (o := 1 + 51 / 100 * y ^ 2 + y * (1 + 17 / 100 * y ^ 2)).
  assert (H2 : h ^ 2 <= y ^ 2) by (apply pow_incr; lra).
  assert (OS : sinh (k * p1) <= sinh x * o).
  { eapply Rle_trans; [exact SA |]; rewrite <- Rmult_assoc, (Rmult_comm (cosh x)), HS; unfold o.
    assert (y * sinh x * (17 / 100 * h ^ 2) <= y * sinh x * (17 / 100 * y ^ 2)) by (apply Rmult_le_compat_l; [positive | lra]).
    assert (sinh x * (51 / 100 * h ^ 2) <= sinh x * (51 / 100 * y ^ 2)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (OC : cosh (k * p1) <= cosh x * o).
  { eapply Rle_trans; [exact CA |]; unfold o.
    assert (sinh x * (h * (1 + 17 / 100 * h ^ 2)) <= cosh x * (y * (1 + 17 / 100 * y ^ 2))).
    - pose proof (pow2_ge_0 h); apply Rmult_le_compat; [lra | apply Rmult_le_pos; lra | lra |]; apply Rmult_le_compat; lra.
    - assert (cosh x * (51 / 100 * h ^ 2) <= cosh x * (51 / 100 * y ^ 2)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (O0 : 1 <= o).
  { pose proof (pow2_ge_0 y); assert (0 <= y * (1 + 17 / 100 * y ^ 2)) by (apply Rmult_le_pos; lra); unfold o; lra. }
  assert (OO : o ^ 2 * (1 - 2 * y) <= 1).
  { unfold o; assert (Y2 : 0 <= y <= 1 / 20) by lra; clearbody y; clear - Y2.
    enough (0 <= y ^ 2 * (196 / 100 - y * 3)) by nra; apply Rmult_le_pos; nra. }
  assert (P1 : PI + q <= p1) by (apply (Rmult_le_reg_l k); [lra |]; unfold h in H0; lra).
  destruct (newton_step (PI + q) p1 ltac:(lra) ltac:(lra) ltac:(lra)) as [Z1 Z2].
  intros N1 L; apply (end_of_newton lim y (- gap d s q u)); try lra; fold g in WG, WH.
  assert (DP : D (PI + q) = / g).
  { apply (Rmult_eq_reg_r g); [| lra]; replace (/ g * g) with 1 by (field; lra); rewrite <- WG; unfold D, w; fold x.
    rewrite Rpow_mult_distr, pow2_sqrt by (left; apply one_more); reflexivity. }
  destruct (D_apart (PI + q) p1 (PI + q) p1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as [D2 _].
  assert (Q1 : 0 < / g - k * r).
  { replace (/ g - k * r) with ((1 - k * r * g) * / g) by (field; lra).
    apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]. }
  assert (SP : 0 < sinh (k * p1)) by (apply sinh_pos, Rmult_lt_0_compat; lra).
  assert (SO : sinh (k * p1) * cosh (k * p1) <= sinh x * cosh x * o ^ 2).
  { replace (sinh x * cosh x * o ^ 2) with (sinh x * o * (cosh x * o)) by ring.
    pose proof (cosh_pos (k * p1)); apply Rmult_le_compat; lra. }
  set (a := k * r * k * (r ^ 2 + 1) * (p1 - (PI + q)) ^ 2).
  assert (A0 : 0 <= a) by (unfold a; apply Rmult_le_pos; [| apply pow2_ge_0]; left; pose proof (one_more r); positive).
  assert (Z3 : p2 - (PI + q) <= a * (sinh x * cosh x * o ^ 2) / (/ g * (/ g - k * r))).
  { eapply Rle_trans; [exact Z2 |].
    replace (k * r * k * (r ^ 2 + 1) * sinh (k * p1) * cosh (k * p1) * (p1 - (PI + q)) ^ 2)
      with (a * (sinh (k * p1) * cosh (k * p1))) by (unfold a; ring).
    pose proof (cosh_pos (k * p1)); assert (0 < / g) by positive.
    unfold Rdiv; apply Rmult_le_compat; [apply Rmult_le_pos; [exact A0 | apply Rmult_le_pos; lra] | left; apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra
      | apply Rmult_le_compat_l; lra |].
    apply Rinv_le_contravar; [positive |]; rewrite DP; apply Rmult_le_compat_l; lra. }
  apply Rle_trans with (k * r * g * (1 - g) * y ^ 2 * (o ^ 2 / (1 - k * r * g))).
  - apply Rle_trans with (k * (a * (sinh x * cosh x * o ^ 2) / (/ g * (/ g - k * r))) * cosh x / sinh x).
    + unfold Rdiv at 1; apply Rmult_le_compat_r; [left; positive |]; apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_l; lra.
    + right; rewrite <- WH; replace (w ^ 2) with ((r ^ 2 + 1) * sinh x ^ 2) by (unfold w; rewrite Rpow_mult_distr, pow2_sqrt by (left; apply one_more); reflexivity).
      unfold a; replace (p1 - (PI + q)) with (h / k) by (unfold h; field; lra); unfold y; field; repeat split; lra.
  - unfold Rdiv at 2; apply Rmult_le_compat_l; [apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply pow2_ge_0] |].
    apply (Rmult_le_reg_r ((1 - k * r * g) * ((1 - 2 * y) * (1 - 2 * y - k * r * g)))); [apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra] |].
    replace (o ^ 2 / (1 - k * r * g) * ((1 - k * r * g) * ((1 - 2 * y) * (1 - 2 * y - k * r * g))))
      with (o ^ 2 * (1 - 2 * y) * (1 - 2 * y - k * r * g)) by (field; lra).
    replace (/ ((1 - 2 * y) * (1 - 2 * y - k * r * g)) * ((1 - k * r * g) * ((1 - 2 * y) * (1 - 2 * y - k * r * g))))
      with (1 - k * r * g) by (field; lra).
    assert (o ^ 2 * (1 - 2 * y) * (1 - 2 * y - k * r * g) <= 1 * (1 - 2 * y - k * r * g)) by (apply Rmult_le_compat_r; lra); lra.
Qed.
End Sweep.
(* The gaps by intervals. *)
Ltac boxes q u n := unfold newton_gap, gap, angle_of; interval with (i_bisect q, i_bisect u, i_depth n).
Lemma from_angle y A lim l : 0 <= y -> y <= l -> l <= lim * (1 - l) -> 0 <= lim -> l < 1 -> 1 <= A -> y / (1 - y) <= lim * A.
Proof.
  intros Y L M P O A1; apply (Rmult_le_reg_r (1 - y)); [lra |].
  replace (y / (1 - y) * (1 - y)) with y by (field; lra).
  assert (lim * 1 * (1 - y) <= lim * A * (1 - y)) by (apply Rmult_le_compat_r; [lra | apply Rmult_le_compat_l; lra]).
  assert (lim * (1 - l) <= lim * (1 - y)) by (apply Rmult_le_compat_l; lra); lra.
Qed.
Lemma from_angle_2 y A lim : y < 1 -> 0 <= lim * (1 - y) * A - y -> y / (1 - y) <= lim * A.
Proof.
  intros O L; apply (Rmult_le_reg_r (1 - y)); [lra |].
  replace (y / (1 - y) * (1 - y)) with y by (field; lra); lra.
Qed.
Lemma gap_pi q u : 0 < q < PI / 2 -> 0 < u < 1 -> 0 <= gap q PI q u <= 34 / 1000.
Proof.
  intros Q U; assert (Q1 : 0 <= q <= 15708 / 10000) by (split; [lra | apply Rle_trans with (PI / 2); [lra | interval]]).
  assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra); pose proof PI_RGT_0.
  split; [unfold gap; apply Rmult_le_pos; [repeat apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; positive] |].
  clear SQ CQ; boxes q u 30%nat.
Qed.
Lemma line_pi q u : 0 < q < PI / 2 -> 0 < u < 1 -> 1 <= angle_of q u ->
  gap q PI q u / (1 - gap q PI q u) <= 7 / 250 * angle_of q u.
Proof.
  intros Q U A; pose proof (gap_pi q u Q U) as G.
  assert (Q1 : 0 <= q <= 15708 / 10000) by (split; [lra | apply Rle_trans with (PI / 2); [lra | interval]]).
  destruct (Rle_or_lt q (6 / 10)) as [H|H]; [| destruct (Rle_or_lt (14 / 10) q) as [I|I]; [| destruct (Rle_or_lt u (35 / 100)) as [J|J]]].
  - apply (from_angle _ _ _ (272 / 10000)); try lra; boxes q u 30%nat.
  - apply (from_angle _ _ _ (272 / 10000)); try lra; boxes q u 30%nat.
  - apply (from_angle _ _ _ (272 / 10000)); try lra; boxes q u 30%nat.
  - apply from_angle_2; [lra |]; boxes q u 40%nat.
Qed.
Lemma newton_pi_gap q u : 0 < q < PI / 2 -> 0 < u < 1 -> 1 <= angle_of q u ->
  0 <= newton_gap (gap q PI q u) q u <= 11 / 100000 /\
  newton_gap (gap q PI q u) q u / (1 - newton_gap (gap q PI q u) q u) <= 1 / 10000 * angle_of q u.
Proof.
  intros Q U A; pose proof (gap_pi q u Q U) as G.
  assert (Q1 : 0 <= q <= 15708 / 10000) by (split; [lra | apply Rle_trans with (PI / 2); [lra | interval]]).
  assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra); pose proof PI_RGT_0.
  assert (N : 0 <= newton_gap (gap q PI q u) q u <= 11 / 100000).
  { split; [| clear SQ CQ; boxes q u 30%nat].
    assert (B : sin q * cos q * (u * (u + 2)) / (3 * (PI + q)) <= 2 / 10) by (clear SQ CQ; interval with (i_bisect q)).
    unfold newton_gap; apply Rmult_le_pos; [| left; apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra].
    apply Rmult_le_pos; [| apply pow2_ge_0]; apply Rmult_le_pos.
    - apply Rmult_le_pos; [repeat apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; positive].
    - assert (C1 : cos q <= 1) by apply COS_bound; assert (cos q * u <= 1) by nra; assert (0 < cos q * u) by positive; nra. }
  split; [exact N |].
  destruct (Rle_or_lt q (8 / 10)) as [H2|H2]; [| destruct (Rle_or_lt (12 / 10) q) as [I|I]; [| destruct (Rle_or_lt u (9 / 10)) as [J|J]]].
  - apply (from_angle _ _ _ (9999 / 100000000)); try lra; clear SQ CQ; boxes q u 30%nat.
  - apply (from_angle _ _ _ (9999 / 100000000)); try lra; clear SQ CQ; boxes q u 30%nat.
  - apply (from_angle _ _ _ (9999 / 100000000)); try lra; clear SQ CQ; boxes q u 30%nat.
  - apply from_angle_2; [lra |]; clear SQ CQ; boxes q u 40%nat.
Qed.
Ltac sharply q x n := unfold ahead, sharp_gap, angle_of, sinh, cosh; interval with (i_bisect q, i_bisect x, i_depth n).
Lemma gap_4 q u : 4 - PI <= q < PI / 2 -> 0 < u < 1 -> 0 <= gap (PI + q - 4) 4 q u <= 7 / 1000.
Proof.
  intros Q U; pose proof PI_RGT_0; assert (Q0 : 0 < q) by (assert (PI < 315 / 100) by interval; lra).
  assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra).
  split.
  - unfold gap; apply Rmult_le_pos; [repeat apply Rmult_le_pos; lra |]; left; apply Rinv_0_lt_compat.
    assert (0 <= (PI + q - 4) * cos q ^ 2 * u) by (repeat apply Rmult_le_pos; try lra; apply pow2_ge_0); positive.
  - assert (Q1 : 858 / 1000 <= q <= 15708 / 10000) by (split; [apply Rle_trans with (4 - PI); [interval | lra] | apply Rle_trans with (PI / 2); [lra | interval]]).
    clear SQ CQ Q0 Q; boxes q u 30%nat.
Qed.
Lemma line_4 q u : 4 - PI <= q < PI / 2 -> 0 < u < 1 -> 1 <= angle_of q u ->
  gap (PI + q - 4) 4 q u / (1 - gap (PI + q - 4) 4 q u) <= 13 / 2000 * angle_of q u.
Proof.
  intros Q U A; pose proof (gap_4 q u Q U) as G.
  assert (Q1 : 858 / 1000 <= q <= 15708 / 10000) by (split; [apply Rle_trans with (4 - PI); [interval | lra] | apply Rle_trans with (PI / 2); [lra | interval]]).
  destruct (Rle_or_lt q (105 / 100)) as [H|H]; [| destruct (Rle_or_lt (14 / 10) q) as [I|I]; [| destruct (Rle_or_lt u (8 / 10)) as [J|J]]].
  - apply (from_angle _ _ _ (645 / 100000)); try lra; boxes q u 30%nat.
  - apply (from_angle _ _ _ (645 / 100000)); try lra; boxes q u 30%nat.
  - apply (from_angle _ _ _ (645 / 100000)); try lra; boxes q u 30%nat.
  - apply from_angle_2; [lra |]; boxes q u 40%nat.
Qed.
Lemma product_most q u : 0 <= q <= 15708 / 10000 -> 0 < u < 1 -> sin q * cos q * (u * (u + 2)) / (3 * (PI + q)) <= 2 / 10.
Proof. intros Q U; interval with (i_bisect q). Qed.
Lemma newton_gap_above y q u : 0 < q < PI / 2 -> 0 < u < 1 -> 0 <= y <= 1 / 10 -> 0 <= newton_gap y q u.
Proof.
  intros Q U Y; assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra); pose proof PI_RGT_0.
  assert (B : sin q * cos q * (u * (u + 2)) / (3 * (PI + q)) <= 2 / 10).
  { apply product_most; [| lra]; split; [lra | apply Rle_trans with (PI / 2); [lra | interval]]. }
  unfold newton_gap; apply Rmult_le_pos; [| left; apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra].
  apply Rmult_le_pos; [| apply pow2_ge_0]; apply Rmult_le_pos.
  - apply Rmult_le_pos; [repeat apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; positive].
  - assert (C1 : cos q <= 1) by apply COS_bound; assert (cos q * u <= 1) by nra; assert (0 < cos q * u) by positive; nra.
Qed.
Lemma newton_4_gap q u : 4 - PI <= q < PI / 2 -> 0 < u < 1 -> 1 <= angle_of q u ->
  newton_gap (gap (PI + q - 4) 4 q u) q u < 1 /\
  newton_gap (gap (PI + q - 4) 4 q u) q u / (1 - newton_gap (gap (PI + q - 4) 4 q u) q u) <= 1 / 250000 * angle_of q u.
Proof.
  intros Q U A; pose proof (gap_4 q u Q U) as G.
  assert (Q1 : 858 / 1000 <= q <= 15708 / 10000) by (split; [apply Rle_trans with (4 - PI); [interval | lra] | apply Rle_trans with (PI / 2); [lra | interval]]).
  assert (N : newton_gap (gap (PI + q - 4) 4 q u) q u <= 399 / 100000000) by (clear Q G; boxes q u 30%nat).
  pose proof (newton_gap_above (gap (PI + q - 4) 4 q u) q u ltac:(lra) U ltac:(lra)).
  split; [lra |]; apply (from_angle _ _ _ (399 / 100000000)); lra.
Qed.
Lemma gap_4_back q u : 0 < q -> q <= 4 - PI -> 0 < u < 1 -> 0 <= - gap (PI + q - 4) 4 q u <= 14 / 1000.
Proof.
  intros Q R U; pose proof PI_RGT_0; assert (Q0 : q < PI / 2) by (assert (314 / 100 < PI) by interval; lra).
  assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra).
  assert (Q1 : 0 <= q <= 859 / 1000) by (split; [lra |]; apply Rle_trans with (4 - PI); [lra | interval]).
  split.
  - unfold gap; replace (- ((PI + q - 4) * (sin q * cos q) * (u + 2) / (3 * (PI + q) * (4 + (PI + q - 4) * cos q ^ 2 * u))))
      with ((4 - PI - q) * (sin q * cos q) * (u + 2) * / (3 * (PI + q) * (4 + (PI + q - 4) * cos q ^ 2 * u))) by (unfold Rdiv; ring).
    apply Rmult_le_pos; [repeat apply Rmult_le_pos; lra |]; left; apply Rinv_0_lt_compat.
    assert (0 < 4 + (PI + q - 4) * cos q ^ 2 * u) by (clear SQ CQ Q Q0; interval with (i_bisect q)); positive.
  - clear SQ CQ Q0 Q R; boxes q u 30%nat.
Qed.
Lemma newton_4_back q u : 0 < q -> q <= 4 - PI -> 0 < u < 1 -> 1 <= angle_of q u ->
  newton_gap (- gap (PI + q - 4) 4 q u) q u < 1 /\
  newton_gap (- gap (PI + q - 4) 4 q u) q u / (1 - newton_gap (- gap (PI + q - 4) 4 q u) q u) <= 1 / 250000 * angle_of q u.
Proof.
  intros Q R U A; pose proof (gap_4_back q u Q R U) as G.
  assert (Q0 : q < PI / 2) by (assert (314 / 100 < PI) by interval; lra).
  assert (Q1 : 0 <= q <= 859 / 1000) by (split; [lra |]; apply Rle_trans with (4 - PI); [lra | interval]).
  pose proof (newton_gap_above (- gap (PI + q - 4) 4 q u) q u ltac:(lra) U ltac:(lra)) as N.
  assert (M : newton_gap (- gap (PI + q - 4) 4 q u) q u <= 1 / 1000) by (clear N G R Q Q0; boxes q u 30%nat).
  split; [lra |].
  destruct (Rle_or_lt q (15 / 100)) as [H2|H2]; [| destruct (Rle_or_lt (75 / 100) q) as [I|I]; [| destruct (Rle_or_lt u (2 / 10)) as [J|J]]].
  - apply (from_angle _ _ _ (399 / 100000000)); try lra; clear N M G R Q Q0; boxes q u 30%nat.
  - apply (from_angle _ _ _ (399 / 100000000)); try lra; clear N M G R Q Q0; boxes q u 30%nat.
  - apply (from_angle _ _ _ (399 / 100000000)); try lra; clear N M G R Q Q0; boxes q u 30%nat.
  - apply from_angle_2; [lra |]; clear N M G R Q Q0; boxes q u 40%nat.
Qed.
Lemma sharp_4 q x : 0 < q -> q < 4 - PI -> 0 < x -> 1 <= angle_of q (/ cosh x) ->
  exists t, 0 < t /\ tanh (x * ((4 - PI - q) / (PI + q))) <= x * t /\ sharp_gap t q x <= 1 / 20 /\
  ahead (sharp_gap t q x) (/ cosh x) <= 13 / 2000 * angle_of q (/ cosh x) * (1 + ahead (sharp_gap t q x) (/ cosh x) * (1 - (cos q * / cosh x) ^ 2)).
Proof.
  intros Q R X A; assert (Q1 : 0 <= q <= 859 / 1000) by (split; [lra |]; apply Rle_trans with (4 - PI); [lra | interval]).
  assert (Q0 : q < PI / 2) by (assert (314 / 100 < PI) by interval; lra); pose proof PI_RGT_0.
  set (m := (4 - PI - q) / (PI + q)); assert (M : 0 < m) by (apply Rdiv_lt_0_compat; lra).
  destruct (tanh_between_cubics (x * m) ltac:(nra)) as [_ T].
  assert (U : 0 < / cosh x < 1).
  { pose proof (cosh_beyond x ltac:(lra)); split; [apply Rinv_0_lt_compat; lra |]; rewrite <- Rinv_1; apply Rinv_lt_contravar; lra. }
  assert (SQ : 0 < sin q) by (apply sin_gt_0; lra); assert (CQ : 0 < cos q) by (apply cos_gt_0; lra).
  assert (simple : forall t, 0 < t -> sharp_gap t q x <= 642 / 100000 ->
    ahead (sharp_gap t q x) (/ cosh x) <= 13 / 2000 * angle_of q (/ cosh x) * (1 + ahead (sharp_gap t q x) (/ cosh x) * (1 - (cos q * / cosh x) ^ 2))).
  { intros t T0 L; set (u := / cosh x) in *; set (y := sharp_gap t q x) in *.
    assert (Y0 : 0 <= y).
    { unfold y, sharp_gap; apply Rmult_le_pos; [left; positive |]; left; apply Rinv_0_lt_compat.
      assert (0 < 1 + x ^ 2 * (1 / 6 + x ^ 2 / 120)) by (assert (0 < x ^ 2) by positive; positive).
      pose proof (sinh_pos x X); assert (0 < t * (sinh x ^ 2 + sin q ^ 2) / (1 + x ^ 2 / 3)) by (assert (0 < x ^ 2) by positive; positive); positive. }
    assert (Y1 : 0 <= ahead y u <= 13 / 2000) by (unfold ahead; assert (0 < 1 - u ^ 2 < 1) by nra; nra).
    assert (C1 : cos q <= 1) by apply COS_bound; assert (0 <= 1 - (cos q * u) ^ 2) by (assert (cos q * u <= 1) by nra; assert (0 < cos q * u) by positive; nra).
    assert (0 <= ahead y u * (1 - (cos q * u) ^ 2)) by nra; nra. }
  destruct (Rle_or_lt x 2) as [H1|H1].
  - exists (m * (1 - (x * m) ^ 2 * (1 / 3 - 2 / 15 * (x * m) ^ 2))).
    assert (T0 : 0 < m * (1 - (x * m) ^ 2 * (1 / 3 - 2 / 15 * (x * m) ^ 2))) by (apply Rmult_lt_0_compat; [exact M | nra]).
    assert (Y : sharp_gap (m * (1 - (x * m) ^ 2 * (1 / 3 - 2 / 15 * (x * m) ^ 2))) q x <= 14 / 1000).
    { unfold m; clear - Q1 X H1; assert (0 <= x) by lra; sharply q x 30%nat. }
    repeat split; [exact T0 | rewrite <- Rmult_assoc; exact T | lra |].
    destruct (Rle_or_lt q (6 / 100)) as [H2|H2].
    + apply simple; [exact T0 |]; unfold m; clear - Q1 X H1 H2; assert (0 <= x) by lra; sharply q x 30%nat.
    + apply Rminus_le_0; unfold m; clear - Q1 X H1 H2; assert (0 <= x) by lra; sharply q x 40%nat.
  - exists m.
    assert (Y : sharp_gap m q x <= 62 / 10000).
    { apply Rle_trans with (sin q * cos q * m / ((1 + x ^ 2 * (1 / 6 + x ^ 2 / 120)) ^ 2 * (PI + q))).
      - unfold sharp_gap; apply Rmult_le_compat_l; [left; positive |].
        assert (0 < x ^ 2) by positive; apply Rinv_le_contravar; [positive |]; apply Rmult_le_compat_r; [lra |].
        pose proof (sinh_pos x X); assert (0 < m * (sinh x ^ 2 + sin q ^ 2) / (1 + x ^ 2 / 3)) by positive; lra.
      - unfold m; clear - Q1 X H1; assert (2 <= x) by lra; sharply q x 30%nat. }
    repeat split; [exact M | | lra | apply simple; lra].
    assert (tanh (x * m) <= x * m); [| exact H0].
    assert (P : 0 < x * m) by positive; pose proof (sinh_below_cosh (x * m) ltac:(lra)); pose proof (cosh_pos (x * m)).
    unfold tanh; apply (Rmult_le_reg_r (cosh (x * m))); [lra |]; replace (sinh (x * m) / cosh (x * m) * cosh (x * m)) with (sinh (x * m)) by (field; lra); lra.
Qed.

(* A defect in these terms. *)
Lemma defect_chart a b e : is_defect a b e -> e > 0 -> e < 1 / 2 * PI -> a > 0 -> b > 0 -> b <= 1 ->
  exists k r q, k = sqrt (a * b) /\ r = sqrt (b * / a) /\ 0 < k /\ 0 < r /\ k * r = b /\ 0 < q < PI / 2
  /\ atan (r * tanh (k * (PI + q))) = q /\ r ^ 2 = b * / a /\ e = atan (/ (sqrt (r ^ 2 + 1) * sinh (k * (PI + q)))).
Proof.
  unfold is_defect; intros D P P1 A B B1; exists (sqrt (a * b)), (sqrt (b * / a)), (asin (sqrt (b * / (a + b)) * cos e)).
  assert (I : 0 < b * / a) by positive; assert (R2 : sqrt (b * / a) ^ 2 = b * / a) by (apply pow2_sqrt; lra).
  pose proof (defect_turn a b e A B P P1) as T; pose proof (product_root a b A B) as KR.
  repeat split; try lra; try (apply sqrt_lt_R0; positive).
  - rewrite D, turn_of_share by assumption; f_equal; ring.
  - rewrite R2; exact (defect_angle a b e A B P P1 D).
Qed.
Lemma within e lim v : e > 0 -> 0 <= v - e <= lim * e -> Rabs ((-1) * v * / e + 1) <= lim.
Proof.
  intros P H; replace ((-1) * v * / e + 1) with (- ((v - e) * / e)) by (field; lra).
  assert (I : 0 < / e) by positive; rewrite Rabs_Ropp, Rabs_pos_eq by (apply Rmult_le_pos; lra).
  apply (Rmult_le_reg_r e); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Lemma within_below e lim v : e > 0 -> 0 <= e - v <= lim * e -> Rabs ((-1) * v * / e + 1) <= lim.
Proof.
  intros P H; replace ((-1) * v * / e + 1) with ((e - v) * / e) by (field; lra).
  assert (I : 0 < / e) by positive; rewrite Rabs_pos_eq by (apply Rmult_le_pos; lra).
  apply (Rmult_le_reg_r e); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
(* The formulas as they are printed. *)
Lemma sweep_printed r k s c : 0 < r -> 0 < k -> 0 < s -> r ^ 2 = c ->
  atan (/ sqrt (c + 1) * / sinh (k * (PI + atan (r * tanh (s * k))))) = atan (/ (sqrt (r ^ 2 + 1) * sinh (k * (PI + atan (r * tanh (k * s)))))).
Proof. intros R0 K S <-; rewrite Rinv_mult, (Rmult_comm s k); reflexivity. Qed.
Lemma newton_printed r k s b c p : 0 < r -> 0 < k -> 0 < s -> k * r = b -> b <= 1 -> r ^ 2 = c ->
  p = PI + (-1) * / ((-1) * b + sinh (k * (PI + atan (r * tanh (s * k)))) ^ 2 * (c + 1) + 1)
    * (cosh (k * (PI + atan (r * tanh (s * k)))) ^ 2 + c * sinh (k * (PI + atan (r * tanh (s * k)))) ^ 2)
    * ((-1) * atan (r * tanh (k * (PI + atan (r * tanh (s * k))))) + atan (r * tanh (s * k))) + atan (r * tanh (s * k)) ->
  p = PI + atan (r * tanh (k * s)) - (PI + atan (r * tanh (k * s)) - PI - atan (r * tanh (k * (PI + atan (r * tanh (k * s))))))
      / (1 - k * r / (1 + (r ^ 2 + 1) * sinh (k * (PI + atan (r * tanh (k * s)))) ^ 2)).
Proof.
  intros R0 K S KR B1 <- E; pose proof PI_RGT_0; rewrite (Rmult_comm s k) in E.
  assert (I : 0 < r * tanh (k * s)) by (apply Rmult_lt_0_compat; [exact R0 | apply tanh_pos; positive]).
  pose proof (atan_above _ I); set (y := atan (r * tanh (k * s))) in *.
  assert (X : 0 < sinh (k * (PI + y))) by (apply sinh_pos; positive).
  rewrite cosh_square in E; rewrite E, <- KR; set (z := sinh _) in *; assert (0 < z ^ 2) by positive; assert (0 < r ^ 2) by positive.
  assert (0 < r ^ 2 * z ^ 2) by positive; field; repeat split; apply Rgt_not_eq; nra.
Qed.
Lemma angle_printed r k c p : 0 < r -> 0 < k -> 0 < p -> r ^ 2 = c ->
  1 / 2 * PI + (-1) * atan (sqrt (c + 1) * sinh (p * k)) = atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p))).
Proof.
  intros R0 K P <-; rewrite (Rmult_comm p k), atan_inv; [field |].
  apply Rmult_lt_0_compat; [apply sqrt_lt_R0; nra | apply sinh_pos; nra].
Qed.
(* The four bounds. *)
Lemma line_from_pi a b e : is_defect a b e -> e > 0 -> e < 1 / 2 * PI -> a > 0 -> b > 0 -> b <= 1 ->
  Rabs ((-1) * atan (/ sqrt (b * / a + 1) * / sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b)))))) * / e + 1) <= 7 / 250.
Proof.
  intros D P P1 A B B1; destruct (defect_chart a b e D P P1 A B B1) as [k [r [q [<- [<- [K [R0 [KR [Q [T [R2 EE]]]]]]]]]]].
  pose proof PI_RGT_0 as H; destruct (sweep_signs k r q K Q T) as [_ [_ [_ [_ [U _]]]]].
  destruct (sweep_angle k r q K Q T) as [_ A1]; pose proof (gap_pi q _ Q U) as G; pose proof (line_pi q _ Q U A1) as L.
  apply within; [exact P |]; rewrite (sweep_printed r k PI _ R0 K H R2), EE.
  apply (end_of_sweep k r q PI); replace (PI + q - PI) with q by ring; try assumption; lra.
Qed.
Lemma line_from_four a b e : is_defect a b e -> e > 0 -> e < 1 / 2 * PI -> a > 0 -> b > 0 -> b <= 1 ->
  Rabs ((-1) * atan (/ sqrt (b * / a + 1) * / sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b)))))) * / e + 1) <= 13 / 2000.
Proof.
  intros D P P1 A B B1; destruct (defect_chart a b e D P P1 A B B1) as [k [r [q [<- [<- [K [R0 [KR [Q [T [R2 EE]]]]]]]]]]].
  pose proof PI_RGT_0 as H; destruct (sweep_signs k r q K Q T) as [X [_ [_ [_ [U _]]]]].
  destruct (sweep_angle k r q K Q T) as [_ A1]; rewrite (sweep_printed r k 4 _ R0 K ltac:(lra) R2).
  assert (PP : 3 < PI < 32 / 10) by (split; interval).
  destruct (Rle_or_lt (4 - PI) q) as [O|O].
  - pose proof (gap_4 q _ ltac:(lra) U) as G; pose proof (line_4 q _ ltac:(lra) U A1) as L.
    apply within; [exact P |]; rewrite EE; apply (end_of_sweep k r q 4); try assumption; lra.
  - destruct (sharp_4 q _ ltac:(lra) O X A1) as [t [T0 [T1 [Y L]]]].
    replace (k * (PI + q) * ((4 - PI - q) / (PI + q))) with (k * - (PI + q - 4)) in T1 by (field; lra).
    apply within_below; [exact P |]; rewrite EE.
    apply (end_of_long k r q 4) with (Y := sharp_gap t q (k * (PI + q))); try assumption; try lra.
    apply (sweep_long_sharp k r q 4); try assumption; lra.
Qed.
(* That the phase after the step is the one of [newton_step], and not below the root. *)
Lemma newton_ends r k q s b c p lim e : 0 < r -> 0 < k -> 0 < s -> k * r = b -> b <= 1 -> r ^ 2 = c -> 0 < q < PI / 2 ->
  atan (r * tanh (k * (PI + q))) = q -> e = atan (/ (sqrt (r ^ 2 + 1) * sinh (k * (PI + q)))) -> e > 0 ->
  p = PI + (-1) * / ((-1) * b + sinh (k * (PI + atan (r * tanh (s * k)))) ^ 2 * (c + 1) + 1)
    * (cosh (k * (PI + atan (r * tanh (s * k)))) ^ 2 + c * sinh (k * (PI + atan (r * tanh (s * k)))) ^ 2)
    * ((-1) * atan (r * tanh (k * (PI + atan (r * tanh (s * k))))) + atan (r * tanh (s * k))) + atan (r * tanh (s * k)) ->
  (let p2 := PI + atan (r * tanh (k * s)) - (PI + atan (r * tanh (k * s)) - PI - atan (r * tanh (k * (PI + atan (r * tanh (k * s))))))
      / (1 - k * r / (1 + (r ^ 2 + 1) * sinh (k * (PI + atan (r * tanh (k * s)))) ^ 2)) in
    0 <= atan (/ (sqrt (r ^ 2 + 1) * sinh (k * (PI + q)))) - atan (/ (sqrt (r ^ 2 + 1) * sinh (k * p2)))
      <= lim * atan (/ (sqrt (r ^ 2 + 1) * sinh (k * (PI + q))))) ->
  Rabs ((-1) * (1 / 2 * PI + (-1) * atan (sqrt (c + 1) * sinh (p * k))) * / e + 1) <= lim.
Proof.
  intros R0 K S KR B1 R2 Q T EE P E L; pose proof PI_RGT_0.
  apply (newton_printed r k s b c p R0 K S KR B1 R2) in E; cbv zeta in L; rewrite <- E in L.
  assert (I : 0 < r * tanh (k * s)) by (apply Rmult_lt_0_compat; [exact R0 | apply tanh_pos; positive]).
  pose proof (atan_above _ I) as Y; set (p1 := PI + atan (r * tanh (k * s))) in *.
  assert (P2 : 0 < p).
  { destruct (newton_step k r q s) with (lo := Rmin p1 (PI + q)) (hi := Rmax p1 (PI + q)) as [N _]; try assumption; try lra.
    - apply Rmin_pos; unfold p1; lra.
    - split; [apply Rmin_l | apply Rmax_l].
    - split; [apply Rmin_r | apply Rmax_r].
    - fold p1 in N; rewrite <- E in N; lra. }
  rewrite (angle_printed r k c p R0 K P2 R2); apply within_below; [exact P |]; rewrite EE; exact L.
Qed.
Lemma newton_line_from_pi a b e p : is_defect a b e -> e > 0 -> e < 1 / 2 * PI -> a > 0 -> b > 0 -> b <= 1 ->
  p = PI + (-1) * / ((-1) * b + sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))))) ^ 2 * (b * / a + 1) + 1)
    * (cosh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))))) ^ 2
      + b * / a * sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))))) ^ 2)
    * ((-1) * atan (sqrt (b * / a) * tanh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))))))
      + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b)))) + atan (sqrt (b * / a) * tanh (PI * sqrt (a * b))) ->
  Rabs ((-1) * (1 / 2 * PI + (-1) * atan (sqrt (b * / a + 1) * sinh (p * sqrt (a * b)))) * / e + 1) <= 1 / 10000.
Proof.
  intros D P P1 A B B1; destruct (defect_chart a b e D P P1 A B B1) as [k [r [q [<- [<- [K [R0 [KR [Q [T [R2 EE]]]]]]]]]]].
  intros E; pose proof PI_RGT_0 as H; destruct (sweep_signs k r q K Q T) as [_ [_ [_ [_ [U _]]]]].
  destruct (sweep_angle k r q K Q T) as [_ A1]; pose proof (gap_pi q _ Q U) as G; destruct (newton_pi_gap q _ Q U A1) as [M L].
  pose proof (product_most q _ ltac:(split; [lra | apply Rle_trans with (PI / 2); [lra | interval]]) U) as BB.
  apply (newton_ends r k q PI b (b * / a) p _ e); trivial; cbv zeta.
  apply (newton_short k r q PI); replace (PI + q - PI) with q by ring; try assumption; lra.
Qed.
Lemma newton_line_from_four a b e p : is_defect a b e -> e > 0 -> e < 1 / 2 * PI -> a > 0 -> b > 0 -> b <= 1 ->
  p = PI + (-1) * / ((-1) * b + sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b))))) ^ 2 * (b * / a + 1) + 1)
    * (cosh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b))))) ^ 2
      + b * / a * sinh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b))))) ^ 2)
    * ((-1) * atan (sqrt (b * / a) * tanh (sqrt (a * b) * (PI + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b))))))
      + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b)))) + atan (sqrt (b * / a) * tanh (4 * sqrt (a * b))) ->
  Rabs ((-1) * (1 / 2 * PI + (-1) * atan (sqrt (b * / a + 1) * sinh (p * sqrt (a * b)))) * / e + 1) <= 1 / 250000.
Proof.
  intros D P P1 A B B1; destruct (defect_chart a b e D P P1 A B B1) as [k [r [q [<- [<- [K [R0 [KR [Q [T [R2 EE]]]]]]]]]]].
  intros E; destruct (sweep_signs k r q K Q T) as [_ [_ [_ [_ [U _]]]]].
  destruct (sweep_angle k r q K Q T) as [_ A1].
  pose proof (product_most q _ ltac:(split; [lra | apply Rle_trans with (PI / 2); [lra | interval]]) U) as BB.
  assert (PP : 3 < PI < 32 / 10) by (split; interval).
  apply (newton_ends r k q 4 b (b * / a) p _ e); trivial; try lra; cbv zeta.
  destruct (Rle_or_lt (4 - PI) q) as [O|O].
  - pose proof (gap_4 q _ ltac:(lra) U) as G; destruct (newton_4_gap q _ ltac:(lra) U A1) as [M L].
    apply (newton_short k r q 4); try assumption; lra.
  - pose proof (gap_4_back q _ ltac:(lra) ltac:(lra) U) as G; destruct (newton_4_back q _ ltac:(lra) ltac:(lra) U A1) as [M L].
    apply (newton_long k r q 4); try assumption; lra.
Qed.
