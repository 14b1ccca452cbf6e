(* What the turning of the racket and its rates are on the unfolded curve. *)
Section OnTheCurve.
Variables a b g x : R.
Hypotheses (A : 0 < a) (B : 0 < b) (B1 : b <= 1) (L : - b < g) (G : g < 0).
Lemma u_over_is : u_over a b g x = u_under a b g x - u_root a b g x.
Proof. unfold u_over, u_under, u_root; rewrite (sin_square x); ring. Qed.
Lemma u_share_square : 1 + u_share a b g x ^ 2 = b * u_under a b g x * / u_root a b g x.
Proof.
  pose proof (u_root_above a b A B g x G) as P; pose proof (sqrt_lt_R0 _ P) as S.
  assert (E : u_share a b g x ^ 2 = (a + b) * (b + g) * / u_root a b g x * sin x ^ 2).
  { unfold u_share; rewrite !Rpow_mult_distr, pow_inv, !pow2_sqrt by lra; reflexivity. }
  rewrite E; apply (Rmult_eq_reg_r (u_root a b g x)); [| lra]; field_simplify; [| lra | lra].
  unfold u_root, u_under; rewrite (sin_square x); ring.
Qed.
Lemma u_angle_sine : sin (u_angle a b g x) ^ 2 = / (b * u_under a b g x) * u_root a b g x.
Proof.
  pose proof (u_root_above a b A B g x G) as P; pose proof (u_under_above a b A B g x G) as Q.
  unfold u_angle; replace (1 / 2 * PI + (-1) * atan (u_share a b g x)) with (PI / 2 - atan (u_share a b g x)) by field.
  rewrite sin_shift; set (u := u_share a b g x).
  assert (W : 0 < 1 + u ^ 2) by nra; pose proof (sqrt_lt_R0 _ W) as S.
  destruct (turn_atan u (sqrt (1 + u ^ 2)) S ltac:(apply pow2_sqrt; lra)) as [_ ->].
  unfold Rdiv; rewrite Rmult_1_l, pow_inv, pow2_sqrt by lra; unfold u; rewrite u_share_square; field; lra.
Qed.
Lemma u_angle_level : g + b * sin (u_angle a b g x) ^ 2
  = / u_under a b g x * ((a - g) * (b + g) * cos x ^ 2).
Proof.
  pose proof (u_under_above a b A B g x G) as Q; rewrite u_angle_sine.
  apply (Rmult_eq_reg_r (u_under a b g x)); [| lra]; field_simplify; [| lra | lra].
  unfold u_root, u_under; rewrite (sin_square x); ring.
Qed.
Lemma u_angle_reach : a + b * sin (u_angle a b g x) ^ 2 = / u_under a b g x * ((a + b) * (a - g)).
Proof.
  pose proof (u_under_above a b A B g x G) as Q; rewrite u_angle_sine.
  apply (Rmult_eq_reg_r (u_under a b g x)); [| lra]; field_simplify; [| lra | lra].
  unfold u_root, u_under; rewrite (sin_square x); ring.
Qed.
Lemma u_angle_forward : (-1) * b * sin (u_angle a b g x) ^ 2 + 1 = / u_under a b g x * u_over a b g x.
Proof.
  pose proof (u_under_above a b A B g x G) as Q; rewrite u_angle_sine, u_over_is; field; lra.
Qed.
(* How fast the racket turns, with the sign of the precession back. *)
Lemma u_angle_rate : is_derive (fun t : R => u_angle a b g t) x
  ((-1) * (sqrt (a + b) * sqrt (b + g) * (a - g) * / (u_under a b g x) * / sqrt (u_root a b g x)) * cos x).
Proof.
  pose proof (u_root_above a b A B g x G) as P; pose proof (sqrt_lt_R0 _ P) as S.
  pose proof (u_under_above a b A B g x G) as Q.
  eapply d_eq; [apply (u_angle_by_end a b A B B1 g x L G) |]; unfold u_inner.
  replace (u_share a b g x * u_share a b g x) with (u_share a b g x ^ 2) by ring; rewrite u_share_square.
  pose proof (pow2_sqrt (u_root a b g x) ltac:(lra)) as E; rewrite <- E at 1.
  set (r := sqrt (u_root a b g x)) in *; field; repeat split; lra.
Qed.
End OnTheCurve.

(* A motion that does not turn, at the level c, along the curve of the level g. *)
Section AlongTheCurve.
Variables a b g : R.
Hypotheses (A : 0 < a) (B : 0 < b) (B1 : b <= 1) (L : - b < g) (G : g < 0).
Definition u_plain (c t : R) : R :=
  / (sqrt (a + b * sin t ^ 2)) * / (sqrt (c + b * sin t ^ 2)) * ((-1) * b * sin t ^ 2 + 1).
Lemma u_plain_continuous c t : 0 < c + b * sin t ^ 2 -> continuous (u_plain c) t.
Proof.
  intros C; assert (0 < a + b * sin t ^ 2) by (pose proof (pow2_ge_0 (sin t)); nra).
  unfold u_plain; continues; apply Rgt_not_eq, sqrt_lt_R0; assumption.
Qed.
Lemma u_plain_along c x : 0 <= cos x -> 0 < c + b * sin (u_angle a b g x) ^ 2 ->
  u_plain c (u_angle a b g x) * ((-1) * (sqrt (a + b) * sqrt (b + g) * (a - g) * / (u_under a b g x) * / sqrt (u_root a b g x)) * cos x)
  = (-1) * (u_rate a b g x * (sqrt (g + b * sin (u_angle a b g x) ^ 2) * / sqrt (c + b * sin (u_angle a b g x) ^ 2))).
Proof.
  intros X C; pose proof (u_root_above a b A B g x G) as P; pose proof (sqrt_lt_R0 _ P) as S.
  pose proof (u_under_above a b A B g x G) as Q; pose proof (sqrt_lt_R0 _ C) as D.
  unfold u_plain, u_rate; rewrite u_angle_reach, u_angle_forward, (u_angle_level a b g x) by assumption.
  set (q := u_under a b g x) in *; set (r := sqrt (u_root a b g x)) in *.
  set (d := sqrt (c + _)) in *; assert (V : 0 < a - g) by lra; assert (U : 0 < a + b) by lra; assert (W : 0 < b + g) by lra.
  assert (I : 0 < / q) by (apply Rinv_0_lt_compat; exact Q).
  rewrite (sqrt_mult_alt (/ q)), (sqrt_mult_alt (/ q)), (sqrt_mult_alt (a + b)) by lra.
  rewrite (sqrt_mult_alt ((a - g) * (b + g))), (sqrt_mult_alt (a - g)), (sqrt_pow2 (cos x)) by (try lra; nra).
  pose proof (sqrt_lt_R0 _ I); pose proof (sqrt_lt_R0 _ U); pose proof (sqrt_lt_R0 _ V); pose proof (sqrt_lt_R0 _ W).
  pose proof (pow2_sqrt (a - g) ltac:(lra)) as E; rewrite <- E at 2.
  pose proof (pow2_sqrt (/ q) ltac:(lra)) as F.
  assert (F' : q = / sqrt (/ q) ^ 2) by (rewrite F, Rinv_inv; reflexivity).
  set (i := sqrt (/ q)) in *; set (v := sqrt (a - g)) in *; clearbody i v d r; rewrite F'; field; repeat split; lra.
Qed.
Lemma u_angle_between x : 0 <= sin x -> 0 < u_angle a b g x <= PI / 2.
Proof.
  intros X; pose proof (u_root_above a b A B g x G) as P; pose proof (sqrt_lt_R0 _ P) as S.
  assert (U : 0 <= u_share a b g x).
  { unfold u_share; pose proof (sqrt_pos (a + b)); pose proof (sqrt_pos (b + g)).
    assert (0 < / sqrt (u_root a b g x)) by (apply Rinv_0_lt_compat, S); repeat apply Rmult_le_pos; lra. }
  unfold u_angle; pose proof (atan_bound (u_share a b g x)); destruct U as [U|<-]; [pose proof (atan_above _ U) | rewrite atan_0]; lra.
Qed.
Lemma u_angle_start : u_angle a b g 0 = 1 / 2 * PI.
Proof. unfold u_angle, u_share; rewrite sin_0, Rmult_0_r, atan_0; ring. Qed.
Lemma u_turn_along c y : 0 <= y -> y <= PI / 2 ->
  (forall x, 0 <= x <= y -> 0 < c + b * sin (u_angle a b g x) ^ 2) ->
  is_RInt (u_plain c) (u_angle a b g y) (1 / 2 * PI)
    (RInt (fun x => u_rate a b g x * (sqrt (g + b * sin (u_angle a b g x) ^ 2) * / sqrt (c + b * sin (u_angle a b g x) ^ 2))) 0 y).
Proof.
  intros Y Z C; pose proof (u_angle_between y ltac:(apply sin_ge_0; lra)) as W.
  assert (K : continuous_on (u_plain c) (u_angle a b g y) (1 / 2 * PI)).
  { intros t; rewrite Rmin_left, Rmax_right by lra; intros T; apply u_plain_continuous.
    assert (0 < sin (u_angle a b g y)) by (apply sin_gt_0; lra).
    assert (sin (u_angle a b g y) <= sin t) by (apply sin_incr_1; lra).
    assert (sin (u_angle a b g y) ^ 2 <= sin t ^ 2) by (apply pow_incr; lra); specialize (C y ltac:(lra)); nra. }
  assert (N : forall x, 0 <= x <= y -> continuous
    (fun x => u_rate a b g x * (sqrt (g + b * sin (u_angle a b g x) ^ 2) * / sqrt (c + b * sin (u_angle a b g x) ^ 2))) x).
  { intros x X; specialize (C x X); pose proof (sqrt_lt_R0 _ C).
    pose proof (continuous_derive _ _ _ (u_angle_rate a b g x A B B1 L G)) as M.
    apply c_mult; [apply (u_rate_continuous a b A B g x G) |].
    apply (c_comp (fun t => sqrt (g + b * sin t ^ 2) * / sqrt (c + b * sin t ^ 2)) (u_angle a b g) x M).
    continues; lra. }
  set (F := fun x => u_rate a b g x * _) in *.
  replace (RInt F 0 y) with (RInt (u_plain c) (u_angle a b g y) (1 / 2 * PI)); [now apply integral_correct |].
  rewrite <- u_angle_start in *.
  rewrite (integral_flip (u_plain c) (u_angle a b g 0) (u_angle a b g y)).
  - rewrite (integral_new_variable (u_plain c) (u_angle a b g)
      (fun x => (-1) * (sqrt (a + b) * sqrt (b + g) * (a - g) * / (u_under a b g x) * / sqrt (u_root a b g x)) * cos x)).
    + rewrite (integral_under _ (fun x => (-1) * F x)).
      * rewrite integral_scale; [over_reals; ring |]; intros x; rewrite Rmin_left, Rmax_right by lra; apply N.
      * intros x; rewrite Rmin_left, Rmax_right by lra; intros X; apply u_plain_along; [apply cos_ge_0; lra | apply C; lra].
    + intros x _; apply (u_angle_rate a b g x A B B1 L G).
    + intros x _; pose proof (u_root_above a b A B g x G) as P; pose proof (sqrt_lt_R0 _ P) as S.
      pose proof (u_under_above a b A B g x G) as Q; unfold u_under, u_root in *; continues; lra.
    + intros x; rewrite Rmin_left, Rmax_right by lra; intros X; apply u_plain_continuous, C, X.
  - intros t T; apply K; rewrite Rmin_comm, Rmax_comm; exact T.
Qed.
(* Until it turns, the motion of the level g is the one along the curve. *)
Lemma u_turn_is_phase y : 0 <= y -> y < PI / 2 ->
  is_RInt (u_plain g) (u_angle a b g y) (1 / 2 * PI) (RInt (u_rate a b g) 0 y).
Proof.
  intros Y Z; assert (C : forall x, 0 <= x <= y -> 0 < g + b * sin (u_angle a b g x) ^ 2).
  { intros x X; rewrite u_angle_level by assumption; pose proof (u_under_above a b A B g x G).
    assert (0 < cos x) by (apply cos_gt_0; lra); assert (0 < a - g) by lra; assert (0 < b + g) by lra; positive. }
  rewrite (integral_under (u_rate a b g)
    (fun x => u_rate a b g x * (sqrt (g + b * sin (u_angle a b g x) ^ 2) * / sqrt (g + b * sin (u_angle a b g x) ^ 2)))).
  - apply u_turn_along; [exact Y | lra | exact C].
  - intros x; rewrite Rmin_left, Rmax_right by exact Y; intros X; specialize (C x ltac:(lra)).
    pose proof (sqrt_lt_R0 _ C); field; lra.
Qed.
(* At a higher level the racket is faster at every angle. *)
Lemma u_turn_below c : g < c -> exists v, is_RInt (u_plain c) (u_angle a b g (PI / 2)) (1 / 2 * PI) v
  /\ v <= RInt (u_rate a b g) 0 (PI / 2).
Proof.
  intros H; pose proof PI_RGT_0 as J.
  assert (D : forall x, 0 <= g + b * sin (u_angle a b g x) ^ 2).
  { intros x; rewrite u_angle_level by assumption; pose proof (u_under_above a b A B g x G).
    apply Rmult_le_pos; [left; apply Rinv_0_lt_compat; lra |]; apply Rmult_le_pos; [nra | apply pow2_ge_0]. }
  assert (C : forall x, 0 < c + b * sin (u_angle a b g x) ^ 2) by (intros x; specialize (D x); lra).
  eexists; split; [apply (u_turn_along c (PI / 2)); [lra | lra | intros x _; apply C] |].
  apply integral_le; [lra | | |].
  - intros x _; specialize (C x); pose proof (sqrt_lt_R0 _ C).
    pose proof (continuous_derive _ _ _ (u_angle_rate a b g x A B B1 L G)) as M.
    apply c_mult; [apply (u_rate_continuous a b A B g x G) |].
    apply (c_comp (fun t => sqrt (g + b * sin t ^ 2) * / sqrt (c + b * sin t ^ 2)) (u_angle a b g) x M).
    continues; lra.
  - intros x _; apply (u_rate_continuous a b A B g x G).
  - intros x _; specialize (C x); specialize (D x); pose proof (sqrt_lt_R0 _ C) as K.
    assert (sqrt (g + b * sin (u_angle a b g x) ^ 2) <= sqrt (c + b * sin (u_angle a b g x) ^ 2)) by (apply sqrt_le_1_alt; lra).
    assert (R0 : 0 <= u_rate a b g x).
    { pose proof (u_root_above a b A B g x G) as P; pose proof (sqrt_lt_R0 _ P) as S.
      pose proof (u_under_above a b A B g x G) as Q; pose proof (u_over_least a b A B B1 g x G L).
      unfold u_rate; apply Rmult_le_pos; [left; positive | assumption]. }
    rewrite <- (Rmult_1_r (u_rate a b g x)) at 2; apply Rmult_le_compat_l; [exact R0 |].
    apply (Rmult_le_reg_r (sqrt (c + b * sin (u_angle a b g x) ^ 2))); [exact K |].
    rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
End AlongTheCurve.
Lemma u_angle_at_turn a b e : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e < PI / 2 ->
  u_angle a b (- b * sin e ^ 2) (PI / 2) = e.
Proof.
  intros A B B1 E0 E1; pose proof PI_RGT_0 as J; assert (S : 0 < sin e) by (apply sin_gt_0; lra).
  assert (T : sin e < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra).
  assert (T2 : 0 < sin e ^ 2 < 1) by nra.
  assert (L : - b < - b * sin e ^ 2) by nra; assert (G : - b * sin e ^ 2 < 0) by nra.
  pose proof (u_angle_between a b _ A B G (PI / 2) ltac:(rewrite sin_PI2; lra)) as W.
  pose proof (u_angle_sine a b (- b * sin e ^ 2) (PI / 2) A B L G) as H.
  unfold u_under, u_root in H; rewrite sin_PI2, cos_PI2 in H.
  assert (0 < sin (u_angle a b (- b * sin e ^ 2) (PI / 2))) by (apply sin_gt_0; lra).
  apply same_sin; [lra | lra |]; apply same_square; [lra | lra |]; rewrite H; field; lra.
Qed.
Lemma u_longest a b d e : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e < PI / 2 -> 0 < d ->
  exists v, is_RInt (fun t => / (sqrt (a + b * sin t ^ 2)) * / (sqrt (d + b * sin t ^ 2 + (-1) * b * sin e ^ 2))
      * ((-1) * b * sin t ^ 2 + 1)) e (1 / 2 * PI) v
    /\ v <= RInt (u_rate a b (- b * sin e ^ 2)) 0 (1 / 2 * PI).
Proof.
  intros A B B1 E0 E1 D; pose proof PI_RGT_0 as J; assert (S : 0 < sin e) by (apply sin_gt_0; lra).
  assert (T : sin e < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra).
  assert (T2 : 0 < sin e ^ 2 < 1) by nra.
  assert (L : - b < - b * sin e ^ 2) by nra; assert (G : - b * sin e ^ 2 < 0) by nra.
  destruct (u_turn_below a b _ A B B1 L G (d - b * sin e ^ 2) ltac:(lra)) as [v [V W]].
  rewrite u_angle_at_turn in V by assumption.
  exists v; split; [| replace (1 / 2 * PI) with (PI / 2) by field; exact W].
  eapply is_RInt_ext; [| exact V]; intros t _; unfold u_plain; do 3 f_equal; f_equal; ring.
Qed.
(* An integral without parameters, to three digits. *)
Ltac estimated := match goal with |- context [RInt ?f ?u ?v] =>
  let H := fresh "M" in integral_intro (RInt f u v) with (i_prec 30, i_relwidth 10, i_degree 8) as H;
  generalize dependent (RInt f u v); intros end.
(* How long a turn from a start takes, by those from the ends of an interval on one level each. *)
Section Starts.
Variables a b : R.
Hypotheses (A : 0 < a) (B : 0 < b) (B1 : b <= 1).
Lemma u_plain_positive c t : 0 < c -> 0 <= u_plain a b c t.
Proof.
  intros C; pose proof (sine_square_at_most_one t); assert (P : 0 < a + b * sin t ^ 2) by nra.
  assert (Q : 0 < c + b * sin t ^ 2) by nra; pose proof (sqrt_lt_R0 _ P); pose proof (sqrt_lt_R0 _ Q).
  unfold u_plain; apply Rmult_le_pos; [left; positive | nra].
Qed.
Lemma u_plain_falls c d t : 0 < c -> c <= d -> u_plain a b d t <= u_plain a b c t.
Proof.
  intros C D; pose proof (sine_square_at_most_one t); assert (P : 0 < a + b * sin t ^ 2) by nra.
  assert (Q : 0 < c + b * sin t ^ 2) by nra; pose proof (sqrt_lt_R0 _ P); pose proof (sqrt_lt_R0 _ Q).
  unfold u_plain; apply Rmult_le_compat_r; [nra |]; apply Rmult_le_compat_l; [left; positive |].
  apply Rinv_le_contravar; [assumption | apply sqrt_le_1_alt; lra].
Qed.
Lemma u_plain_on c p q : 0 < c -> continuous_on (u_plain a b c) p q.
Proof. intros C t _; pose proof (pow2_ge_0 (sin t)); apply (u_plain_continuous a b (- b / 2)); nra. Qed.
Lemma u_plain_wider c p x y q : 0 < c -> p <= x -> x <= y -> y <= q ->
  RInt (u_plain a b c) x y <= RInt (u_plain a b c) p q.
Proof.
  intros C X Y Q; rewrite (integral_cut _ p x q), (integral_cut _ x y q) by now apply u_plain_on.
  assert (K : forall l h, l <= h -> 0 <= RInt (u_plain a b c) l h).
  { intros l h H; apply integral_nonnegative; [exact H | now apply u_plain_on |]; intros t _; now apply u_plain_positive. }
  pose proof (K p x X); pose proof (K y q Q); lra.
Qed.
Lemma starts_below c d p x q y : 0 < c -> c <= d -> p <= x -> x <= q -> 0 <= y ->
  RInt (u_plain a b d) x (x + y) <= RInt (u_plain a b c) p (q + y).
Proof.
  intros C D X Q Y; apply Rle_trans with (RInt (u_plain a b c) x (x + y)); [| apply u_plain_wider; lra].
  apply integral_le; [lra | apply u_plain_on; lra | now apply u_plain_on |]; intros t _; now apply u_plain_falls.
Qed.
Lemma starts_above c d p x q y : 0 < c -> c <= d -> p <= x -> x <= q -> q <= p + y ->
  RInt (u_plain a b d) q (p + y) <= RInt (u_plain a b c) x (x + y).
Proof.
  intros C D X Q Y; apply Rle_trans with (RInt (u_plain a b d) x (x + y)); [apply u_plain_wider; lra |].
  apply integral_le; [lra | apply u_plain_on; lra | now apply u_plain_on |]; intros t _; now apply u_plain_falls.
Qed.
(* The level of a start. *)
Definition start_level (x v : R) : R :=
  (-1) * b * sin x ^ 2 + v ^ 2 * ((-1) * b * sin x ^ 2 + 1) ^ 2 * / (a + b * sin x ^ 2).
Lemma start_turn x v y : 0 < start_level x v ->
  is_RInt (fun t : R => / (sqrt (a + b * sin t ^ 2)) * / (sqrt (b * sin t ^ 2 + (-1) * b * sin x ^ 2
    + v ^ 2 * ((-1) * b * sin x ^ 2 + 1) ^ 2 * / (a + b * sin x ^ 2))) * ((-1) * b * sin t ^ 2 + 1))
    x (x + y) (RInt (u_plain a b (start_level x v)) x (x + y)).
Proof.
  intros C; eapply is_RInt_ext; [| apply integral_correct, u_plain_on, C].
  intros t _; unfold u_plain, start_level; do 4 f_equal; ring.
Qed.
End Starts.
