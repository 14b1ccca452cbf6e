(* What the proofs of several claims share. *)

Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import Tresym.
Open Scope R_scope.

(* The defect of a shape between two numbers, by the signs of what is left of its equation. *)
Lemma share_below a b e : 0 < a -> 0 < b -> -1 < sqrt (b * / (a + b)) * cos e < 1.
Proof.
  intros A B; assert (Q : 0 <= b * / (a + b) < 1).
  { split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra] |].
    apply (Rmult_lt_reg_r (a + b)); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  pose proof (sqrt_lt_1 _ 1 (proj1 Q) ltac:(lra) (proj2 Q)) as M; rewrite sqrt_1 in M.
  pose proof (sqrt_pos (b * / (a + b))); pose proof (COS_bound e); split; nra.
Qed.
Definition turn_short (a b e : R) : R :=
  1 - 2 / (exp (2 * (sqrt (a * b) * (PI + atan (sqrt (b * / (a + b)) * cos e
    / sqrt (1 - sqrt (b * / (a + b)) * cos e * (sqrt (b * / (a + b)) * cos e)))))) + 1)
  - / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Lemma turn_short_is a b e : 0 < a -> 0 < b -> turn_short a b e
  = tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
    - / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Proof.
  intros A B; unfold turn_short; rewrite (asin_by_atan _ (share_below a b e A B)); f_equal.
  set (x := sqrt (a * b) * _); replace (2 * x) with (x + x) by ring; rewrite exp_plus, tanh_law.
  pose proof (exp_pos x); field; split; nra.
Qed.
Lemma defect_exists a b lo hi : 0 < a -> 0 < b -> lo <= hi ->
  turn_short a b lo <= 0 -> 0 <= turn_short a b hi ->
  exists e, lo <= e <= hi /\ tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
    = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Proof.
  intros A B L S T.
  assert (I : forall e, 0 < b * / a * sin e ^ 2 + 1).
  { intros e; pose proof (pow2_ge_0 (sin e)); assert (0 < b * / a).
    { apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]. } nra. }
  destruct (root_exists (fun e => tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
    - / sqrt (b * / a * sin e ^ 2 + 1) * cos e) lo hi L) as [e [E Z]].
  - intros e _; pose proof (share_below a b e A B); continues; cbv beta; try lra.
    apply Rgt_not_eq, sqrt_lt_R0, I.
  - cbv beta; rewrite <- !turn_short_is by assumption; nra.
  - exists e; split; [exact E |]; cbv beta in Z; lra.
Qed.
(* The one defect of a shape between two numbers, as a zero. *)
Lemma defect_between a b lo hi : 0 < a -> 0 < b ->
  (exists! e, e > 0 /\ e < 1 / 2 * PI /\ tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
    = / sqrt (b * / a * sin e ^ 2 + 1) * cos e) ->
  0 < lo -> lo <= hi -> hi < 1 / 2 * PI -> turn_short a b lo <= 0 -> 0 <= turn_short a b hi ->
  exists e, lo <= e <= hi
    /\ is_root (fun e => tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
      + (-1) * / sqrt (b * / a * sin e ^ 2 + 1) * cos e) 0 (1 / 2 * PI) e.
Proof.
  intros A B [z [_ U]] L M H S T; destruct (defect_exists a b lo hi A B M S T) as [e [X E]].
  exists e; split; [exact X |]; split; [split; lra |]; intros y Y F.
  rewrite <- (U e), <- (U y); repeat split; lra.
Qed.
Ltac one_defect unique a b lo hi x X E :=
  destruct (defect_between a b lo hi) as [x [X E]];
    [lra | lra | apply unique; numeric | lra | lra | interval | unfold turn_short; numeric
    | unfold turn_short; numeric |].

(* The turn of a defect as an arc tangent, and the phase that it belongs to. *)
Lemma turn_of_share a b e : 0 < a -> 0 < b -> asin (sqrt (b * / (a + b)) * cos e)
  = atan (sqrt (b * / a) * (/ sqrt (b * / a * sin e ^ 2 + 1) * cos e)).
Proof.
  intros A B; pose proof (share_below a b e A B) as S.
  rewrite (asin_by_atan _ S); f_equal.
  set (c := cos e) in *; pose proof (sin_square e) as Q; fold c in Q.
  set (m := sqrt (b * / (a + b))) in *; set (r := sqrt (b * / a)).
  assert (0 < / a) by positive; assert (0 < / (a + b)) by positive.
  assert (M : m ^ 2 = b * / (a + b)) by (apply pow2_sqrt; apply Rmult_le_pos; lra).
  assert (R2 : r ^ 2 = b * / a) by (apply pow2_sqrt; apply Rmult_le_pos; lra).
  assert (0 <= m) by apply sqrt_pos; assert (0 <= r) by apply sqrt_pos.
  assert (P : 0 < 1 - m * c * (m * c)) by nra.
  assert (P1 : 0 < b * / a * sin e ^ 2 + 1).
  { pose proof (pow2_ge_0 (sin e)); assert (0 < b * / a) by positive; nra. }
  set (v := sqrt (1 - m * c * (m * c))); set (w := sqrt (_ + 1)).
  assert (0 < v) by (apply sqrt_lt_R0; exact P); assert (0 < w) by (apply sqrt_lt_R0; exact P1).
  assert (V : v ^ 2 = 1 - m * c * (m * c)) by (apply pow2_sqrt; lra).
  assert (W : w ^ 2 = b * / a * sin e ^ 2 + 1) by (apply pow2_sqrt; lra).
  assert (E : r * v = m * w).
  { apply same_square; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra |].
    rewrite !Rpow_mult_distr, V, W, R2, Q.
    replace (m * c * (m * c)) with (m ^ 2 * c ^ 2) by ring; rewrite M; field; lra. }
  apply (Rmult_eq_reg_r (v * w)); [| apply Rgt_not_eq, Rmult_lt_0_compat; lra].
  replace (r * (/ w * c) * (v * w)) with (r * v * c) by (field; lra).
  rewrite E; field; lra.
Qed.
Lemma cosh_square x : cosh x ^ 2 = 1 + sinh x ^ 2.
Proof. rewrite sinh_law, cosh_law; pose proof (exp_pos x); field; lra. Qed.
Lemma one_phase k r x y : 0 < k -> 0 < r -> k * r <= 1 -> 0 < x -> 0 < y ->
  x = k * (PI + atan (r * tanh x)) -> y = k * (PI + atan (r * tanh y)) -> x = y.
Proof.
  intros K P L; assert (M : forall x y, 0 < x -> x < y ->
    x - k * (PI + atan (r * tanh x)) < y - k * (PI + atan (r * tanh y))).
  { intros u v U V; apply (rising (fun t : R => t - k * (PI + atan (r * tanh t)))
      (fun t => 1 - k * r / (cosh t ^ 2 + r ^ 2 * sinh t ^ 2)) u v); try lra.
    - intros t _; continues.
    - intros t T; pose proof (cosh_pos t); eapply d_eq; [derive |]; cbv beta; unfold tanh.
      field; split; [| lra]; apply Rgt_not_eq; nra.
    - intros t T; pose proof (sinh_lt 0 t ltac:(lra)) as S; rewrite sinh_0 in S.
      pose proof (cosh_square t); assert (D : 1 < cosh t ^ 2 + r ^ 2 * sinh t ^ 2) by nra.
      replace (1 - _) with
        ((cosh t ^ 2 + r ^ 2 * sinh t ^ 2 - k * r) / (cosh t ^ 2 + r ^ 2 * sinh t ^ 2)) by (field; lra).
      apply Rdiv_lt_0_compat; lra. }
  intros X Y E F; destruct (Rtotal_order x y) as [H|[H|H]]; [| exact H |].
  - specialize (M x y X H); lra.
  - specialize (M y x Y H); lra.
Qed.

(* The angle 2 atan (exp (-pi)) of the floor. *)
Lemma floor_angles : sinh PI * sin (2 * atan (exp ((-1) * PI))) = cos (2 * atan (exp ((-1) * PI)))
  /\ cos (2 * atan (exp ((-1) * PI))) = tanh PI /\ 0 < sin (2 * atan (exp ((-1) * PI))).
Proof.
  pose proof (exp_pos ((-1) * PI)) as P; set (x := exp ((-1) * PI)) in *.
  assert (X : exp PI = / x) by (unfold x; rewrite <- exp_Ropp; f_equal; ring).
  assert (X' : exp (- PI) = x) by (unfold x; f_equal; ring).
  assert (Q : 0 < 1 + x ^ 2) by nra.
  assert (W : 0 < sqrt (1 + x ^ 2)) by (apply sqrt_lt_R0; exact Q).
  assert (W2 : sqrt (1 + x ^ 2) ^ 2 = 1 + x ^ 2) by (apply pow2_sqrt; lra).
  destruct (turn_atan x (sqrt (1 + x ^ 2)) W W2) as [S C].
  assert (SS : sin (2 * atan x) = 2 * x / (1 + x ^ 2)).
  { rewrite sin_2a, S, C; field_simplify; [rewrite W2; field | |]; nra. }
  assert (CC : cos (2 * atan x) = (1 - x ^ 2) / (1 + x ^ 2)).
  { rewrite cos_2a, S, C; field_simplify; [rewrite W2; field | |]; nra. }
  rewrite SS, CC; unfold tanh, sinh, cosh; rewrite X, X'; repeat split;
    [field | field | apply Rdiv_lt_0_compat]; repeat split; nra.
Qed.

(* The root of its factors, what its equation says of exp and of sinh. *)
Lemma product_root a b : 0 < a -> 0 < b -> sqrt (a * b) * sqrt (b * / a) = b.
Proof.
  intros A B; rewrite <- sqrt_mult by (left; positive).
  replace (a * b * (b * / a)) with (b ^ 2) by (field; lra); apply sqrt_pow2; lra.
Qed.
Lemma inverse_root a b : 0 < a -> 0 < b -> sqrt (a * / (a + b)) = / sqrt (b * / a + 1).
Proof.
  intros A B; assert (0 < b * / a) by positive; rewrite <- sqrt_inv.
  f_equal; field; lra.
Qed.
Section AtRoot.
Variables a b x e : R.
Hypotheses (A : 0 < a) (B : 0 < b) (S : 0 < sin e) (C : 0 < cos e).
Let w := sqrt (b * / a * sin e ^ 2 + 1).
Let q := sqrt (b * / a + 1).
Hypothesis E : tanh x = / w * cos e.

Lemma root_facts : 1 <= w /\ 0 < q /\ q ^ 2 * sin e ^ 2 = w ^ 2 - cos e ^ 2.
Proof.
  assert (H : 0 < b * / a) by positive; pose proof (pow2_ge_0 (sin e)).
  split; [apply below_sqrt; nra |]; split; [apply sqrt_lt_R0; lra |].
  unfold q, w; rewrite !pow2_sqrt by nra; rewrite sin_square; ring.
Qed.
Lemma decay : exp (- x) = q * / (w + cos e) * sin e.
Proof.
  destruct root_facts as [W [Q F]]; pose proof (exp_pos (- x)) as Y.
  assert (X : exp x = / exp (- x)) by (rewrite exp_Ropp, Rinv_inv; reflexivity).
  unfold tanh, sinh, cosh in E; rewrite X in E; set (y := exp (- x)) in *.
  apply same_square; [lra | left; positive |].
  assert (G : w * (1 - y ^ 2) = cos e * (1 + y ^ 2)).
  { assert (0 < 1 + y ^ 2) by nra.
    replace (1 - y ^ 2) with ((/ y - y) / 2 / ((/ y + y) / 2) * (1 + y ^ 2)) by (field; nra).
    rewrite E; field; lra. }
  assert (G2 : y ^ 2 * (w + cos e) ^ 2 = w ^ 2 - cos e ^ 2) by nra.
  apply (Rmult_eq_reg_r ((w + cos e) ^ 2)); [| apply Rgt_not_eq; positive].
  rewrite G2, <- F; field; lra.
Qed.
Lemma sinh_at_root : sinh x = / q * / sin e * cos e.
Proof.
  destruct root_facts as [W [Q F]]; pose proof decay as D.
  assert (X : exp x = / exp (- x)) by (rewrite exp_Ropp, Rinv_inv; reflexivity).
  unfold sinh; rewrite X, D.
  replace (/ (q * / (w + cos e) * sin e)) with ((w + cos e) * / (q * sin e)) by (field; repeat split; lra).
  replace (q * / (w + cos e) * sin e) with (q ^ 2 * sin e ^ 2 * / (w + cos e) * / (q * sin e)) by (field; repeat split; lra).
  rewrite F; field; repeat split; lra.
Qed.
End AtRoot.

(* A step of Newton's for the phase does not pass the root, from either side. *)
Lemma convex_step k r x T : k > 0 -> r > 0 -> (-1) * k * r + 1 >= 0 -> T > 0 -> x > 0 ->
  sinh x ^ 2 * (r ^ 2 + 1) + (-1) * k * r + 1 <> 0 ->
  x + (-1) * T
  + / (sinh x ^ 2 * (r ^ 2 + 1) + (-1) * k * r + 1) * (T + (-1) * k * (PI + atan (r * tanh T)))
    * (cosh x ^ 2 + r ^ 2 * sinh x ^ 2)
  + (-1) * / (sinh x ^ 2 * (r ^ 2 + 1) + (-1) * k * r + 1) * (x + (-1) * k * (PI + atan (r * tanh x)))
    * (cosh x ^ 2 + r ^ 2 * sinh x ^ 2) >= 0.
Proof.
  intros K P L TP X N; set (D := fun t : R => cosh t ^ 2 + r ^ 2 * sinh t ^ 2).
  set (f := fun t : R => t - k * (PI + atan (r * tanh t))).
  assert (D1 : forall t, 0 < t -> 1 < D t).
  { intros t H; pose proof (sinh_lt 0 t H) as S; rewrite sinh_0 in S; pose proof (cosh_square t); unfold D; nra. }
  assert (M : forall u v, 0 < u -> u <= v -> D u <= D v).
  { intros u v U V; assert (sinh u <= sinh v).
    { destruct V as [V|V]; [left; now apply sinh_lt | subst; lra]. }
    pose proof (sinh_lt 0 u U) as S; rewrite sinh_0 in S.
    unfold D; rewrite !cosh_square; assert (sinh u ^ 2 <= sinh v ^ 2) by nra; pose proof (pow2_ge_0 r); nra. }
  assert (df : forall t, 0 < t -> is_derive f t (1 - k * r * / D t)).
  { intros t H; specialize (D1 t H); pose proof (cosh_pos t); unfold f; eapply d_eq; [derive |].
    cbv beta; unfold tanh, D in *; field; split; [| lra]; apply Rgt_not_eq; nra. }
  assert (KR : 0 < k * r) by positive.
  assert (den : sinh x ^ 2 * (r ^ 2 + 1) + (-1) * k * r + 1 = D x - k * r).
  { unfold D; rewrite cosh_square; ring. }
  rewrite den in *; pose proof (D1 x X); fold (D x).
  assert (Q : 0 <= (f T - f x) - (1 - k * r * / D x) * (T - x)).
  { assert (I : forall u v, 0 < u -> u <= v -> 1 - k * r * / D u <= 1 - k * r * / D v).
    { intros u v U V; pose proof (M u v U V); pose proof (D1 u U).
      assert (/ D v <= / D u) by (apply Rinv_le_contravar; lra); nra. }
    destruct (Rle_or_lt x T) as [H1|H1].
    - destruct (mean_value f (fun t => 1 - k * r * / D t) x T H1) as [c [C E]].
      { intros t H2; apply df; lra. }
      rewrite E; pose proof (I x c X ltac:(lra)); nra.
    - destruct (mean_value f (fun t => 1 - k * r * / D t) T x ltac:(lra)) as [c [C E]].
      { intros t H2; apply df; lra. }
      replace (f T - f x) with ((1 - k * r * / D c) * (T - x)) by lra.
      pose proof (I c x ltac:(lra) ltac:(lra)); nra. }
  match goal with |- ?v >= 0 => replace v with (D x * / (D x - k * r) * ((f T - f x) - (1 - k * r * / D x) * (T - x)))
    by (unfold f; field; lra) end.
  apply Rle_ge, Rmult_le_pos; [left; apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra] | exact Q].
Qed.

(* The exponent of a defect and its slope. *)
Definition root_of (a b e : R) : R := sqrt (b * / a * sin e ^ 2 + 1).
Definition exponent (a b e : R) : R :=
  sqrt (a * b) * ((-1) * asin (sqrt (b * / (a + b)) * cos e) + asin (sqrt (b * / (a + b))))
  + ln (e * / sin e) + ln (1 / 2 * root_of a b e + 1 / 2 * cos e).
Lemma root_above a b e : 0 < a -> 0 < b -> 1 <= root_of a b e.
Proof.
  intros A B; apply below_sqrt; assert (0 < b * / a) by positive; pose proof (pow2_ge_0 (sin e)); nra.
Qed.
Lemma root_square a b e : 0 < a -> 0 < b -> root_of a b e ^ 2 = b * / a * sin e ^ 2 + 1.
Proof.
  intros A B; apply pow2_sqrt; assert (0 < b * / a) by positive; pose proof (pow2_ge_0 (sin e)); nra.
Qed.
(* k m = b w, with w the root of the share's complement *)
Lemma share_root a b e : 0 < a -> 0 < b -> sqrt (a * b) * sqrt (b * / (a + b))
  * / sqrt ((-1) * (sqrt (b * / (a + b)) * cos e) ^ 2 + 1) = b * / root_of a b e.
Proof.
  intros A B; pose proof (share_below a b e A B) as S; pose proof (root_above a b e A B).
  pose proof (root_square a b e A B) as W; set (w := root_of a b e) in *.
  assert (0 < / (a + b)) by positive; set (m := sqrt (b * / (a + b))) in *.
  assert (M : m ^ 2 = b * / (a + b)) by (apply pow2_sqrt; left; positive).
  assert (0 < m) by (apply sqrt_lt_R0; positive).
  assert (V0 : 0 < (-1) * (m * cos e) ^ 2 + 1) by nra; set (v := sqrt (_ + 1)).
  assert (V : v ^ 2 = (-1) * (m * cos e) ^ 2 + 1) by (apply pow2_sqrt; lra).
  assert (0 < v) by (apply sqrt_lt_R0; exact V0).
  assert (K : sqrt (a * b) ^ 2 = a * b) by (apply pow2_sqrt; left; positive).
  assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive); set (k := sqrt (a * b)) in *.
  apply (Rmult_eq_reg_r (v * w)); [| apply Rgt_not_eq; positive].
  replace (k * m * / v * (v * w)) with (k * m * w) by (field; lra).
  replace (b * / w * (v * w)) with (b * v) by (field; lra).
  apply same_square; [left; positive | left; positive |].
  rewrite !Rpow_mult_distr, K, M, W, V, Rpow_mult_distr, M, sin_square; field; lra.
Qed.
Lemma exponent_derive a b e : 0 < a -> 0 < b -> 0 < e -> 0 < sin e -> 0 < cos e ->
  is_derive (exponent a b) e (/ e + (-1) * / root_of a b e * / sin e * ((-1) * b * sin e ^ 2 + 1)).
Proof.
  intros A B E S C; pose proof (share_below a b e A B) as H; pose proof (root_above a b e A B) as W1.
  pose proof (root_square a b e A B) as W; pose proof (share_root a b e A B) as K.
  set (m := sqrt (b * / (a + b))) in *; set (k := sqrt (a * b)) in *.
  assert (D : is_derive (exponent a b) e (k * m * / sqrt ((-1) * (m * cos e) ^ 2 + 1) * sin e
    + (/ e - cos e * / sin e)
    + (b * / a * sin e * cos e * / root_of a b e - sin e) * / (root_of a b e + cos e))).
  { unfold exponent; fold m k; unfold root_of; eapply d_eq.
    - derive; fold (root_of a b e); first [lra | positive].
    - tidy; fold (root_of a b e); set (w := root_of a b e) in *; assert (0 < (-1) * (m * cos e) ^ 2 + 1) by nra.
      assert (0 < sqrt ((-1) * (m * cos e) ^ 2 + 1)) by (apply sqrt_lt_R0; assumption).
      field; repeat split; lra. }
  eapply d_eq; [exact D |]; rewrite K; clear D K H; set (w := root_of a b e) in *.
  pose proof (sin_square e) as Q; set (s := sin e) in *; set (c := cos e) in *.
  replace ((b * / a * s * c * / w - s) * / (w + c)) with ((b * / a * s ^ 2 * c - s ^ 2 * w) * (/ s * / w * / (w + c)))
    by (field; repeat split; lra).
  replace (b * / a * s ^ 2 * c - s ^ 2 * w) with (c * w * (w + c) - (w + c))
    by (replace (b * / a * s ^ 2) with (w ^ 2 - 1) by lra; rewrite Q; ring).
  field; repeat split; lra.
Qed.

(* What the exponent of an angle exceeds its logarithm by, as that of one number. *)
Lemma exponent_parts a b e : 0 < a -> 0 < b -> 0 < e -> 0 < sin e -> 0 < cos e ->
  exists w, 0 < w /\ w - / w = 2 * (sqrt (a * / (a + b)) * cos e * / sin e)
  /\ sqrt (a * b) * ((-1) * asin (sqrt (b * / (a + b)) * cos e) + asin (sqrt (b * / (a + b))))
      + ln (e * / sin e) + ln (1 / 2 * sqrt (b * / a * sin e ^ 2 + 1) + 1 / 2 * cos e)
    = ln (1 / 2 * e * / sqrt (a * / (a + b)) * exp (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b))))))
      + ln w - sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)).
Proof.
  intros A B E S C; pose proof (sin_square e) as Q; pose proof (root_above a b e A B) as R1.
  pose proof (root_square a b e A B) as R2; unfold root_of in *.
  set (s := sin e) in *; set (c := cos e) in *; set (r := sqrt (b * / a * s ^ 2 + 1)) in *.
  assert (M0 : 0 < a * / (a + b)) by positive; set (m := sqrt (a * / (a + b))).
  assert (M2 : m ^ 2 = a * / (a + b)) by (apply pow2_sqrt; lra).
  assert (M : 0 < m) by (apply sqrt_lt_R0; exact M0); assert (J : 0 < / s) by positive.
  assert (Z : s ^ 2 = m ^ 2 * (r ^ 2 - c ^ 2)) by (rewrite M2, R2, Q; field; lra).
  exists (m * (r + c) * / s); assert (W : 0 < m * (r + c) * / s) by (apply Rmult_lt_0_compat; [nra | exact J]).
  split; [exact W | split].
  - assert (I : / (m * (r + c) * / s) = m * (r - c) * / s); [| rewrite I; ring].
    apply (Rmult_eq_reg_l (m * (r + c) * / s)); [| lra]; rewrite Rinv_r by lra.
    replace (m * (r + c) * / s * (m * (r - c) * / s)) with (m ^ 2 * (r ^ 2 - c ^ 2) * / (s ^ 2)) by (field; lra).
    rewrite <- Z; field; lra.
  - set (x := sqrt (a * b) * (PI + asin (sqrt (b * / (a + b))))); pose proof (exp_pos x).
    replace (1 / 2 * e * / m * exp x) with (/ 2 * (e * (/ m * exp x))) by (field; lra).
    replace (1 / 2 * r + 1 / 2 * c) with (/ 2 * (r + c)) by field.
    assert (0 < / m) by positive.
    rewrite (ln_mult (/ 2) (e * _)), (ln_mult e (/ m * _)), (ln_mult (/ m)), ln_exp, (ln_mult e (/ s)),
      (ln_mult (/ 2) (r + c)), (ln_mult _ (/ s)), (ln_mult m), !ln_Rinv by (first [lra | positive]).
    unfold x; ring.
Qed.

(* The rate dphi/dpsi of precession on a level, and how its integral changes. *)
Definition rate (s a b g t : R) : R :=
  s * / sqrt (a + b * sin t ^ 2) * / sqrt (g + b * sin t ^ 2) * ((-1) * b * sin t ^ 2 + 1).
Definition rate_slope (s a b g t : R) : R :=
  (-1) / 2 * s * / sqrt (a + b * sin t ^ 2) * / sqrt (g + b * sin t ^ 2) ^ 3
  * ((-1) * b * sin t ^ 2 + 1).

Section Turn.
Variables s a b : R.
Hypotheses (A : a > 0) (B : b > 0).

Lemma reach t : 0 < a + b * sin t ^ 2.
Proof. pose proof (pow2_ge_0 (sin t)); nra. Qed.
Lemma forward t : b < 1 -> 0 < (-1) * b * sin t ^ 2 + 1.
Proof.
  intros L; pose proof (SIN_bound t); assert (0 <= sin t ^ 2 <= 1) by (split; nra); nra.
Qed.
Lemma rate_continuous g t : 0 < g + b * sin t ^ 2 -> continuous (rate s a b g) t.
Proof.
  intros H; pose proof (reach t); unfold rate; continues; apply Rgt_not_eq, sqrt_lt_R0; assumption.
Qed.
Lemma rate_slope_continuous g t : 0 < g + b * sin t ^ 2 -> continuous (rate_slope s a b g) t.
Proof.
  intros H; pose proof (reach t); unfold rate_slope; continues;
    [| apply pow_nonzero]; apply Rgt_not_eq, sqrt_lt_R0; assumption.
Qed.
Lemma rate_slope_near g t : 0 < g + b * sin t ^ 2 ->
  continuity_2d_pt (rate_slope s a b) g t.
Proof.
  intros H; pose proof (reach t); unfold rate_slope; continues_2d;
    [| apply pow_nonzero]; apply Rgt_not_eq, sqrt_lt_R0; assumption.
Qed.
Lemma rate_by_level g t : 0 < g + b * sin t ^ 2 ->
  is_derive (fun c : R => rate s a b c t) g (rate_slope s a b g t).
Proof.
  intros H; pose proof (reach t); unfold rate, rate_slope.
  assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
  assert (0 < sqrt (g + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
  eapply d_eq; [derive; lra |]; tidy; field; lra.
Qed.
Lemma between_ends (P : R -> Prop) u v p q : u < p < v -> u < q < v -> (forall t, u < t < v -> P t) ->
  forall t, Rmin p q <= t <= Rmax p q -> P t.
Proof. intros X Y H t T; apply H; unfold Rmin, Rmax in T; destruct (Rle_dec p q); lra. Qed.

Lemma turn_by_start g u v e q : u < e < v -> u < q < v ->
  (forall t, u < t < v -> 0 < g + b * sin t ^ 2) ->
  is_derive (fun x : R => RInt (rate s a b g) x q) e (- rate s a b g e).
Proof.
  intros X Y P; apply (d_lower_end _ _ u v).
  - unfold Rmin; destruct (Rle_dec e q); lra.
  - unfold Rmax; destruct (Rle_dec e q); lra.
  - intros t T; apply rate_continuous, P, T.
Qed.
Lemma turn_by_end g u v e q : u < e < v -> u < q < v ->
  (forall t, u < t < v -> 0 < g + b * sin t ^ 2) ->
  is_derive (fun x : R => RInt (rate s a b g) e x) q (rate s a b g q).
Proof.
  intros X Y P; apply (d_upper_end _ _ u v).
  - unfold Rmin; destruct (Rle_dec e q); lra.
  - unfold Rmax; destruct (Rle_dec e q); lra.
  - intros t T; apply rate_continuous, P, T.
Qed.
Lemma turn_by_level g p u v e q : p < g -> u < e < v -> u < q < v ->
  (forall c t, p < c -> u < t < v -> 0 < c + b * sin t ^ 2) ->
  is_derive (fun c : R => RInt (rate s a b c) e q) g (RInt (rate_slope s a b g) e q).
Proof.
  intros L X Y P.
  apply (leibniz (rate s a b) (rate_slope s a b) e q g p (g + 1)); [lra | | |].
  - intros c t C T; apply rate_by_level, P; [lra |].
    exact (between_ends _ u v e q X Y (fun _ H => H) t T).
  - intros t T; apply rate_slope_near, P; [lra |].
    exact (between_ends _ u v e q X Y (fun _ H => H) t T).
  - intros c C t T; apply rate_continuous, P; [lra |].
    exact (between_ends _ u v e q X Y (fun _ H => H) t T).
Qed.

(* Where the square of the sine keeps a level positive, it does so a little beyond. *)
Lemma rotating g : 0 < g -> forall c t, 0 < c -> 0 < c + b * sin t ^ 2.
Proof. intros _ c t C; pose proof (pow2_ge_0 (sin t)); nra. Qed.
Lemma sine_near x y : Rabs (sin x ^ 2 - sin y ^ 2) <= Rabs (x - y).
Proof.
  destruct (MVT_gen (fun t : R => sin t ^ 2) y x (fun t => 2 * sin t * cos t)) as [c [_ E]].
  - intros t _; eapply d_eq; [derive |]; tidy; ring.
  - intros z _; apply continuity_pt_filterlim; change (continuous (fun t : R => sin t ^ 2) z); continues.
  - cbv beta in E; rewrite E, Rabs_mult; pose proof (Rabs_pos (x - y)).
    assert (Rabs (2 * sin c * cos c) <= 1); [| nra].
    rewrite <- sin_2a; apply Rabs_le, SIN_bound.
Qed.
Lemma unturned g e : b <= 1 -> 0 < e -> e < PI / 2 -> 0 < g + b * sin e ^ 2 ->
  exists p u v, p < g /\ u < e < v /\ u < PI / 2 < v
  /\ forall c t, p < c -> u < t < v -> 0 < c + b * sin t ^ 2.
Proof.
  intros L E F H; set (d := (g + b * sin e ^ 2) / 4); assert (D : 0 < d) by (unfold d; lra).
  exists (g - d), (e - d), (PI - e); repeat split; try lra.
  intros c t C [T U]; destruct (Rle_or_lt e t) as [K|K].
  - assert (sin e <= sin t).
    { destruct (Rle_or_lt t (PI / 2)) as [M|M]; [apply sin_incr_1; lra |].
      rewrite <- (sin_PI_x t); apply sin_incr_1; lra. }
    assert (0 < sin e) by (apply sin_gt_0; lra); assert (sin e ^ 2 <= sin t ^ 2) by nra.
    unfold d in *; nra.
  - pose proof (sine_near e t) as S; rewrite (Rabs_pos_eq (e - t)) in S by lra.
    apply Rabs_le_between in S; unfold d in *; nra.
Qed.
End Turn.

(* The same with one sign, and on the separatrix. *)
Definition plain (a b g t : R) : R :=
  / sqrt (a + b * sin t ^ 2) * / sqrt (g + b * sin t ^ 2) * ((-1) * b * sin t ^ 2 + 1).
Definition zero_rate (s a b t : R) : R :=
  s * / sqrt b * / sqrt (a + b * sin t ^ 2) * / Rabs (sin t) * ((-1) * b * sin t ^ 2 + 1).

Section Plain.
Variables s a b : R.
Hypotheses (A : a > 0) (B : b > 0).

Lemma plain_is g t : rate 1 a b g t = plain a b g t.
Proof. unfold rate, plain; ring. Qed.
Lemma plain_turn g p q : RInt (rate 1 a b g) p q = RInt (plain a b g) p q.
Proof. apply RInt_ext; intros; apply plain_is. Qed.
Lemma plain_continuous g t : 0 < g + b * sin t ^ 2 -> continuous (plain a b g) t.
Proof.
  intros H; pose proof (reach a b A B t); unfold plain; continues;
    apply Rgt_not_eq, sqrt_lt_R0; assumption.
Qed.
Lemma plain_by_start g u v e q : u < e < v -> u < q < v ->
  (forall t, u < t < v -> 0 < g + b * sin t ^ 2) ->
  is_derive (fun x : R => RInt (plain a b g) x q) e (- plain a b g e).
Proof.
  intros X Y P; rewrite <- plain_is; apply (is_derive_ext (fun x => RInt (rate 1 a b g) x q)).
  - intros x; apply plain_turn.
  - exact (turn_by_start 1 a b A B g u v e q X Y P).
Qed.
Lemma plain_by_level g p u v e q : p < g -> u < e < v -> u < q < v ->
  (forall c t, p < c -> u < t < v -> 0 < c + b * sin t ^ 2) ->
  is_derive (fun c : R => RInt (plain a b c) e q) g (RInt (rate_slope 1 a b g) e q).
Proof.
  intros L X Y P; apply (is_derive_ext (fun c => RInt (rate 1 a b c) e q)).
  - intros x; apply plain_turn.
  - exact (turn_by_level 1 a b A B g p u v e q L X Y P).
Qed.
Lemma room e : b <= 1 -> e < PI / 2 -> exists t, e < t < PI / 2 /\ b * sin t ^ 2 < 1.
Proof.
  intros L E; pose proof PI_RGT_0; pose proof (Rmax_l e 0); pose proof (Rmax_r e 0).
  assert (M : Rmax e 0 < PI / 2) by (apply Rmax_lub_lt; lra).
  exists ((Rmax e 0 + PI / 2) / 2); split; [lra |].
  set (t := (Rmax e 0 + PI / 2) / 2); assert (0 < t < PI / 2) by (unfold t; lra).
  assert (0 < sin t) by (apply sin_gt_0; lra).
  assert (sin t < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra); nra.
Qed.
(* A higher level turns faster: the integral falls. *)
Lemma turn_falls g p q : 0 < s -> b <= 1 -> p < q ->
  (forall t, p <= t <= q -> 0 < g + b * sin t ^ 2) ->
  (exists t, p < t < q /\ b * sin t ^ 2 < 1) -> RInt (rate_slope s a b g) p q < 0.
Proof.
  intros S L H P [z [Z W]].
  assert (N : forall t, p < t < q -> rate_slope s a b g t <= 0).
  { intros t T; unfold rate_slope; pose proof (reach a b A B t); specialize (P t ltac:(lra)).
    assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
    assert (0 < sqrt (g + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
    assert (0 <= (-1) * b * sin t ^ 2 + 1) by (pose proof (SIN_bound t); nra).
    assert (0 <= 1 / 2 * s * / sqrt (a + b * sin t ^ 2) * / sqrt (g + b * sin t ^ 2) ^ 3
      * ((-1) * b * sin t ^ 2 + 1)) by (apply Rmult_le_pos; [left; positive | assumption]).
    lra. }
  assert (C : forall t, p <= t <= q -> continuous (rate_slope s a b g) t).
  { intros t T; apply rate_slope_continuous; [assumption | assumption | now apply P]. }
  assert (Y : rate_slope s a b g z < 0).
  { unfold rate_slope; pose proof (reach a b A B z); specialize (P z ltac:(lra)).
    assert (0 < sqrt (a + b * sin z ^ 2)) by (apply sqrt_lt_R0; assumption).
    assert (0 < sqrt (g + b * sin z ^ 2)) by (apply sqrt_lt_R0; assumption).
    assert (0 < 1 / 2 * s * / sqrt (a + b * sin z ^ 2) * / sqrt (g + b * sin z ^ 2) ^ 3
      * ((-1) * b * sin z ^ 2 + 1)); [| lra].
    apply Rmult_lt_0_compat; [positive | lra]. }
  exact (integral_below _ p q z H C N Z Y).
Qed.

Lemma zero_rate_is t : 0 < sin t -> zero_rate s a b t = rate s a b 0 t.
Proof.
  intros T; unfold zero_rate, rate; pose proof (reach a b A B t).
  rewrite Rplus_0_l, sqrt_mult, sqrt_pow2, Rabs_pos_eq by (first [lra | apply pow2_ge_0]).
  assert (0 < sqrt b) by (apply sqrt_lt_R0; exact B).
  assert (0 < sqrt (a + b * sin t ^ 2)) by (apply sqrt_lt_R0; assumption).
  field; repeat split; lra.
Qed.
Lemma zero_continuous t : 0 < sin t -> continuous (zero_rate s a b) t.
Proof.
  intros T; pose proof (reach a b A B t); unfold zero_rate; continues.
  - apply Rgt_not_eq, sqrt_lt_R0; assumption.
  - rewrite Rabs_pos_eq; lra.
Qed.
Lemma zero_on p q : 0 < p -> p < PI -> 0 < q -> q < PI -> continuous_on (zero_rate s a b) p q.
Proof.
  intros P P' Q Q' t T; apply zero_continuous, sin_gt_0; unfold Rmin, Rmax in T;
    destruct (Rle_dec p q); lra.
Qed.
Lemma zero_by_start e q : 0 < e -> e < PI -> 0 < q -> q < PI ->
  is_derive (fun x : R => RInt (zero_rate s a b) x q) e (- zero_rate s a b e).
Proof.
  intros X Y Z W; apply (d_lower_end _ _ 0 PI).
  - unfold Rmin; destruct (Rle_dec e q); lra.
  - unfold Rmax; destruct (Rle_dec e q); lra.
  - intros t T; apply zero_continuous, sin_gt_0; lra.
Qed.
(* What exceeds a number, as an integral. *)
Definition over (w e t : R) : R := (-1) * w * / (1 / 2 * PI + (-1) * e) + zero_rate s a b t.
Lemma over_integral w e x : e < PI / 2 -> 0 < x -> x < PI / 2 ->
  RInt (over w e) x (1 / 2 * PI)
  = (-1) * w * (1 / 2 * PI - x) * / (1 / 2 * PI + (-1) * e) + RInt (zero_rate s a b) x (1 / 2 * PI).
Proof.
  intros E X Y; unfold over; rewrite (integral_plus (fun _ => (-1) * w * / (1 / 2 * PI + (-1) * e))).
  - rewrite integral_const; over_reals; ring.
  - intros t _; apply continuous_const.
  - apply zero_on; lra.
Qed.
Lemma over_by_value e v : 0 < e -> e < PI / 2 ->
  is_derive (fun w : R => RInt (over w e) e (1 / 2 * PI)) v (-1).
Proof.
  intros E F; apply (is_derive_ext (fun w : R => (-1) * w + RInt (zero_rate s a b) e (1 / 2 * PI))).
  - intros w; rewrite (over_integral w e e) by lra; over_reals; field; lra.
  - eapply d_eq; [derive |]; ring.
Qed.
Lemma over_by_end e w : 0 < e -> e < PI / 2 ->
  is_derive (fun x : R => RInt (over w x) x (1 / 2 * PI)) e (- zero_rate s a b e).
Proof.
  intros E F; apply (is_derive_ext_loc (fun x : R => (-1) * w + RInt (zero_rate s a b) x (1 / 2 * PI))).
  - assert (P : 0 < Rmin e (PI / 2 - e)) by (apply Rmin_pos; lra).
    exists (mkposreal _ P); intros x X; change (Rabs (x - e) < Rmin e (PI / 2 - e)) in X.
    pose proof (Rmin_l e (PI / 2 - e)); pose proof (Rmin_r e (PI / 2 - e)); apply Rabs_def2 in X.
    rewrite (over_integral w x x) by lra; over_reals; field; lra.
  - apply (d_eq _ _ (0 + - zero_rate s a b e)); [| ring].
    apply (d_plus (fun _ => (-1) * w)); [apply d_const | apply zero_by_start; lra].
Qed.
End Plain.

(* The one level on which a half turn takes what it takes, between two of them. *)
Lemma turn_by_rising_level a b e x y : a > 0 -> b > 0 -> b <= 1 -> e < 1 / 2 * PI -> 0 < x -> x < y ->
  RInt (plain a b y) e (1 / 2 * PI) < RInt (plain a b x) e (1 / 2 * PI).
Proof.
  intros A B L E X Y; apply Ropp_lt_cancel.
  assert (P : forall c t, 0 < c -> 0 < c + b * sin t ^ 2).
  { intros c t C; pose proof (pow2_ge_0 (sin t)); nra. }
  assert (D : forall g, 0 < g -> is_derive (fun c => - RInt (plain a b c) e (1 / 2 * PI)) g
    (- RInt (rate_slope 1 a b g) e (1 / 2 * PI))).
  { intros g G; apply (d_opp (fun c => RInt (plain a b c) e (1 / 2 * PI)) g (RInt (rate_slope 1 a b g) e (1 / 2 * PI))).
    apply (plain_by_level a b A B g 0 (e - 1) (PI / 2 + 1)); try lra; intros c t C _; apply P, C. }
  apply (rising (fun c => - RInt (plain a b c) e (1 / 2 * PI))
    (fun g => - RInt (rate_slope 1 a b g) e (1 / 2 * PI)) x y); try lra.
  - intros g G; exact (continuous_derive _ _ _ (D g ltac:(lra))).
  - intros g G; apply D; lra.
  - intros g G; enough (RInt (rate_slope 1 a b g) e (1 / 2 * PI) < 0) by lra; apply turn_falls; try lra.
    + intros t _; apply P; lra.
    + destruct (room b e) as [t [T1 T2]]; try lra; exists t; split; lra.
Qed.
Lemma level_between a b e l u : a > 0 -> b > 0 -> b <= 1 -> e < 1 / 2 * PI -> 0 < l -> l < u -> u < a ->
  RInt (plain a b u) e (1 / 2 * PI) < PI < RInt (plain a b l) e (1 / 2 * PI) ->
  exists c, l <= c <= u /\ is_root (fun c => PI + (-1) * RInt (plain a b c) e (1 / 2 * PI)) 0 a c.
Proof.
  intros A B L E X Y Z [U V].
  destruct (root_exists (fun c => PI + (-1) * RInt (plain a b c) e (1 / 2 * PI)) l u) as [c [C F]]; [lra | | nra |].
  - intros g G; apply (continuous_plus (fun _ => PI) (fun c => (-1) * RInt (plain a b c) e (1 / 2 * PI)));
      [apply continuous_const | apply (c_mult (fun _ => -1)); [apply continuous_const |]].
    apply (continuous_derive (fun c => RInt (plain a b c) e (1 / 2 * PI))
      (RInt (rate_slope 1 a b g) e (1 / 2 * PI))), (plain_by_level a b A B g 0 (e - 1) (PI / 2 + 1)); try lra.
    intros c t C _; pose proof (pow2_ge_0 (sin t)); nra.
  - exists c; split; [exact C |]; split; [split; lra |]; intros y W K.
    destruct (Rtotal_order y c) as [M|[M|M]]; [exfalso | exact M | exfalso].
    + pose proof (turn_by_rising_level a b e y c A B L E (proj1 W) M); lra.
    + pose proof (turn_by_rising_level a b e c y A B L E ltac:(lra) M); lra.
Qed.
(* With greater a and b the turn is smaller. *)
Lemma turn_by_shape a b x y c e : 0 < x -> x <= a -> 0 < y -> y <= b -> b <= 1 -> 0 < c -> e <= 1 / 2 * PI ->
  RInt (plain a b c) e (1 / 2 * PI) <= RInt (plain x y c) e (1 / 2 * PI).
Proof.
  intros X A Y B L C E; assert (P : forall u t, 0 < u -> 0 < c + u * sin t ^ 2).
  { intros u t U; pose proof (pow2_ge_0 (sin t)); nra. }
  assert (I : forall p q r s, 0 < p -> p <= q -> 0 < r -> r <= s -> / sqrt q * / sqrt s <= / sqrt p * / sqrt r).
  { intros p q r s H1 H2 H3 H4; apply Rmult_le_compat; try (left; positive).
    - apply Rinv_le_contravar; [positive | now apply sqrt_le_1_alt].
    - apply Rinv_le_contravar; [positive | now apply sqrt_le_1_alt]. }
  apply integral_le; [exact E | | |].
  - intros t _; apply plain_continuous; try lra; apply P; lra.
  - intros t _; apply plain_continuous; try lra; apply P; lra.
  - intros t _; unfold plain; pose proof (SIN_bound t) as S; pose proof (pow2_ge_0 (sin t)) as Q.
    assert (sin t ^ 2 <= 1) by nra; specialize (P y t Y).
    apply Rmult_le_compat; [| nra | | nra].
    + assert (0 < c + b * sin t ^ 2) by nra; assert (0 < a + b * sin t ^ 2) by nra; left; positive.
    + apply I; nra.
Qed.

(* The ratio of the defect to its leading term, by the square of the defect: small angles first. *)
Lemma small_sine e : 0 <= e -> e <= 1 ->
  e * (1 - e ^ 2 / 6) <= sin e <= e * (1 - e ^ 2 / 6 + e ^ 4 / 120)
  /\ 1 - e ^ 2 / 2 <= cos e <= 1 - e ^ 2 / 2 + e ^ 4 / 24.
Proof.
  intros E F; pose proof pi_between as J.
  destruct (pre_sin_bound e 0) as [A B]; try lra.
  destruct (pre_cos_bound e 0) as [G K]; try lra.
  unfold sin_approx, cos_approx, sin_term, cos_term in *; cbn in A, B, G, K.
  repeat split; [eapply Rle_trans, A | eapply Rle_trans; [exact B |] | eapply Rle_trans, G | eapply Rle_trans; [exact K |]]; right; field.
Qed.
Definition up_time (u : R) : R := 1 - u / 3 + 2 * u ^ 2 / 45.
Definition up_root (r u : R) : R :=
  (r * up_time u / 2 - r ^ 2 * u * up_time u ^ 2 / 8 + r ^ 3 * u ^ 2 * up_time u ^ 3 / 16 - 1 / 2 + u / 24) / 2.
Definition low_sum (r u : R) : R :=
  2 + r * (u - u ^ 2 / 3) / 2 - (r * (u - u ^ 2 / 3)) ^ 2 / 8 - u / 2.
Definition up_turn (r u : R) : R := up_time u / low_sum r u * (1 + r * u ^ 2 / 15).
Definition up_exp (r u : R) : R := up_turn r u + u * up_turn r u ^ 2 / 2 + u ^ 2 * up_turn r u ^ 3 / 5.
Definition up_sine (u : R) : R := 1 / 6 + u / 34.
Definition up_all (r u : R) : R :=
  up_sine u + up_root r u + up_exp r u
  + u * (up_sine u * up_root r u + up_sine u * up_exp r u + up_root r u * up_exp r u)
  + u ^ 2 * up_sine u * up_root r u * up_exp r u.
Lemma asin_near y : 0 <= y -> y <= 3 / 10 -> asin y <= y * (1 + y ^ 2 / 5).
Proof.
  intros A B; enough (0 <= y * (1 + y ^ 2 / 5) - asin y) by lra.
  apply (from_left_ge (fun t : R => t * (1 + t ^ 2 / 5) - asin t)
    (fun t : R => 1 + 3 * t ^ 2 / 5 - / sqrt (1 - t ^ 2)) 0 y).
  - exact A.
  - intros t T; assert (0 < 1 - t ^ 2) by nra; assert (0 < sqrt (1 - t ^ 2)) by (apply sqrt_lt_R0; lra).
    eapply d_eq; [derive; lra |]; cbv beta; tidy.
    replace ((-1) * t ^ 2 + 1) with (1 - t ^ 2) by ring; field; lra.
  - intros t T; assert (P : 0 < 1 - t ^ 2) by nra; assert (S : 0 < sqrt (1 - t ^ 2)) by (apply sqrt_lt_R0; lra).
    assert (Q : sqrt (1 - t ^ 2) ^ 2 = 1 - t ^ 2) by (apply pow2_sqrt; lra).
    enough (/ sqrt (1 - t ^ 2) <= 1 + 3 * t ^ 2 / 5) by lra.
    apply (Rmult_le_reg_r (sqrt (1 - t ^ 2))); [exact S |]; rewrite Rinv_l by lra.
    set (q := sqrt (1 - t ^ 2)) in *; set (m := 1 + 3 * t ^ 2 / 5).
    assert (M : 1 <= m ^ 2 * q ^ 2) by (rewrite Q; unfold m; assert (0 <= t ^ 2 <= 9 / 100) by nra;
      set (x := t ^ 2) in *; nra).
    assert (0 < m) by (unfold m; nra); assert (0 < m * q) by nra; nra.
  - rewrite asin_0; lra.
Qed.
Lemma exp_near z : 0 <= z -> z <= 1 / 2 -> exp z <= 1 + z + z ^ 2 / 2 + z ^ 3 / 5.
Proof.
  intros A B.
  assert (H : 0 <= (1 + z + z ^ 2 / 2 + z ^ 3 / 5) * exp (- z) - 1).
  { apply (from_left_ge (fun t : R => (1 + t + t ^ 2 / 2 + t ^ 3 / 5) * exp (- t) - 1)
      (fun t : R => t ^ 2 * (1 / 10 - t / 5) * exp (- t)) 0 z).
    - exact A.
    - intros t T; eapply d_eq; [derive; lra |]; tidy; field.
    - intros t T; pose proof (exp_pos (- t)); apply Rmult_le_pos; [nra | lra].
    - rewrite Ropp_0, exp_0; lra. }
  rewrite exp_Ropp in H; pose proof (exp_pos z) as P; apply (Rmult_le_compat_r (exp z)) in H; [| lra].
  rewrite Rmult_0_l, Rmult_minus_distr_r, Rmult_assoc, Rinv_l in H; lra.
Qed.
Section Ratio.
Variables b r k e : R.
Hypotheses (B0 : 0 < b) (B1 : b <= 1) (R0 : 0 < r) (R4 : r <= 4) (K : 0 < k) (KR : k * sqrt r = b).
Hypotheses (E0 : 0 < e) (E1 : e <= 42 / 100).
Let u := e ^ 2.
Let w := sqrt (r * sin e ^ 2 + 1).
Let y := sqrt r * / (w + cos e) * sin e ^ 2.
Lemma square_between : 0 < u <= 1764 / 10000.
Proof. unfold u; nra. Qed.
Lemma sine_square_between : u - u ^ 2 / 3 <= sin e ^ 2 <= u * up_time u /\ sin e ^ 2 <= u /\ 0 < sin e.
Proof.
  pose proof square_between as U; destruct (small_sine e) as [[A B] _]; try lra; unfold up_time.
  replace (e ^ 4) with (u ^ 2) in B by (unfold u; ring); fold u in A, B.
  assert (X : 0 < e * (1 - u / 6)) by nra; assert (S : 0 < sin e) by lra.
  assert (Y : (e * (1 - u / 6)) ^ 2 <= sin e ^ 2) by nra.
  assert (Z : sin e ^ 2 <= (e * (1 - u / 6 + u ^ 2 / 120)) ^ 2) by nra.
  rewrite Rpow_mult_distr in Y, Z; fold u in Y, Z.
  assert (0 <= u ^ 2) by nra; assert (0 <= u ^ 3) by (apply pow_le; lra).
  assert (M : (1 - u / 6 + u ^ 2 / 120) ^ 2 <= 1 - u / 3 + 2 * u ^ 2 / 45).
  { enough (0 <= u ^ 3 * (1 / 360 - u / 14400)) by lra; apply Rmult_le_pos; lra. }
  assert (1 - u / 3 + 2 * u ^ 2 / 45 <= 1) by nra; repeat split; nra.
Qed.
Lemma sum_between : low_sum r u <= w + cos e /\ 1 / 2 * w + 1 / 2 * cos e <= 1 + u * up_root r u
  /\ 18 / 10 <= low_sum r u /\ 1 <= w.
Proof.
  pose proof square_between as U; destruct sine_square_between as [[A B] [C D]].
  destruct (small_sine e) as [_ [F G]]; try lra.
  replace (e ^ 4) with (u ^ 2) in G by (unfold u; ring); fold u in F, G.
  assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
  assert (W1 : w <= 1 + r * u * up_time u / 2 - (r * u * up_time u) ^ 2 / 8 + (r * u * up_time u) ^ 3 / 16).
  { set (x := r * u * up_time u); assert (X : 0 <= x <= 1).
    { unfold x; assert (0 <= r * u <= 1) by nra; nra. }
    assert (0 <= x ^ 2 <= 1) by nra; assert (0 <= x ^ 3) by (apply pow_le; lra).
    apply above_sqrt; [nra |]; apply Rle_trans with (1 + x); [unfold x; nra |].
    enough (0 <= x ^ 4 * (5 / 64 - x / 64 + x ^ 2 / 256)) by nra.
    apply Rmult_le_pos; [apply pow_le; lra | nra]. }
  assert (W2 : 1 + r * (u - u ^ 2 / 3) / 2 - (r * (u - u ^ 2 / 3)) ^ 2 / 8 <= w).
  { set (x := r * (u - u ^ 2 / 3)); assert (X : 0 <= x <= 1).
    { unfold x; assert (0 <= u - u ^ 2 / 3 <= 1764 / 10000) by nra; nra. }
    apply below_sqrt; apply Rle_trans with (1 + x); [| unfold x; nra].
    assert (0 <= x ^ 3) by (apply pow_le; lra); nra. }
  assert (L : low_sum r u <= w + cos e) by (unfold low_sum; lra).
  repeat split.
  - exact L.
  - unfold up_root; replace (r ^ 2 * u * up_time u ^ 2) with (u * (r * up_time u) ^ 2) by ring.
    apply Rle_trans with (1 / 2 * (1 + r * u * up_time u / 2 - (r * u * up_time u) ^ 2 / 8
      + (r * u * up_time u) ^ 3 / 16) + 1 / 2 * (1 - u / 2 + u ^ 2 / 24)); [lra |].
    right; field.
  - unfold low_sum; clear - R0 R4 U; destruct U; interval.
  - apply below_sqrt; nra.
Qed.
Lemma turn_below : k * asin y <= u * up_turn r u /\ 0 <= k * asin y /\ k * asin y <= 1 / 2.
Proof.
  pose proof square_between as U; destruct sine_square_between as [[A B] [C D]].
  destruct sum_between as [F [_ [G W]]]; set (L := low_sum r u) in *.
  assert (P : 0 < / (w + cos e) <= / L).
  { split; [apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]. }
  assert (I : / L <= 10 / 18) by (replace (10 / 18) with (/ (18 / 10)) by field; apply Rinv_le_contravar; lra).
  assert (Q : 0 < sqrt r) by (apply sqrt_lt_R0; lra); assert (Q2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  assert (S : 0 < sin e ^ 2) by nra.
  assert (V : 0 < / (w + cos e) * sin e ^ 2 <= 10 / 18 * u) by nra.
  assert (Y0 : 0 < y) by (unfold y; rewrite Rmult_assoc; nra).
  assert (Y1 : y ^ 2 <= r * (10 / 18 * u) ^ 2).
  { unfold y; rewrite Rmult_assoc, Rpow_mult_distr, Q2; apply Rmult_le_compat_l; [lra | nra]. }
  assert (Y2 : y <= 3 / 10) by (assert (y ^ 2 <= 4 * (10 / 18 * (1764 / 10000)) ^ 2); nra).
  pose proof (asin_near y ltac:(lra) Y2) as N.
  assert (Z : k * y <= u * (up_time u * / L)).
  { unfold y; replace (k * (sqrt r * / (w + cos e) * sin e ^ 2))
      with (b * (/ (w + cos e) * sin e ^ 2)) by (rewrite <- KR; ring).
    assert (/ (w + cos e) * sin e ^ 2 <= / L * (u * up_time u)) by nra; nra. }
  assert (M : k * asin y <= u * up_turn r u).
  { unfold up_turn; fold L; apply Rle_trans with (k * y * (1 + y ^ 2 / 5)); [nra |].
    replace (u * (up_time u / L * (1 + r * u ^ 2 / 15)))
      with (u * (up_time u * / L) * (1 + r * u ^ 2 / 15)) by (unfold Rdiv; ring).
    assert (0 < k * y) by nra; assert (0 <= u ^ 2) by nra; apply Rmult_le_compat; nra. }
  assert (X : 0 < asin y) by (apply asin_above; exact Y0).
  repeat split; [exact M | nra |]; eapply Rle_trans; [exact M |].
  unfold up_turn, L, low_sum, up_time; clear - R0 R4 U; destruct U; interval.
Qed.
Lemma ratio_below : exp (k * asin y + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e)) <= 1 + u * up_all r u
  /\ 1 - u / 4 <= exp (k * asin y + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e)).
Proof.
  pose proof square_between as U; destruct sine_square_between as [_ [_ S]].
  destruct sum_between as [F [G [L W]]]; destruct turn_below as [T [T0 T1]].
  destruct (small_sine e) as [[A B] [C _]]; try lra; fold u in A, C.
  rewrite !exp_plus, !exp_ln by (first [lra | positive]).
  assert (I : 0 < / sin e) by (apply Rinv_0_lt_compat; lra).
  assert (V : 1 <= e * / sin e <= 1 + u * up_sine u).
  { split; apply (Rmult_le_reg_r (sin e)); try lra; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    - destruct (small_sine e) as [[_ J] _]; try lra; replace (e ^ 4) with (u ^ 2) in J by (unfold u; ring);
        fold u in J; nra.
    - unfold up_sine; apply Rle_trans with (e * (1 - u / 6) * (1 + u * (1 / 6 + u / 34))); [| nra].
      assert (0 <= u ^ 2 * (1 / 34 - 1 / 36 - u / 204)) by (apply Rmult_le_pos; nra); nra. }
  assert (X : 1 <= exp (k * asin y) <= 1 + u * up_exp r u).
  { split; [rewrite <- exp_0; apply exp_rises, T0 |]; eapply Rle_trans; [apply exp_near; assumption |].
    set (z := k * asin y) in *; set (q := u * up_turn r u) in *.
    replace (1 + u * up_exp r u) with (1 + q + q ^ 2 / 2 + q ^ 3 / 5) by (unfold q, up_exp; field).
    assert (z ^ 2 <= q ^ 2) by nra; assert (z ^ 3 <= q ^ 3) by (apply pow_incr; lra); lra. }
  set (p := e * / sin e) in *; set (x := exp (k * asin y)) in *; set (d := 1 / 2 * w + 1 / 2 * cos e) in *.
  assert (D : 1 - u / 4 <= d) by (unfold d; lra).
  split.
  - replace (1 + u * up_all r u) with ((1 + u * up_exp r u) * (1 + u * up_sine u) * (1 + u * up_root r u))
      by (unfold up_all; ring).
    repeat apply Rmult_le_compat; try lra; nra.
  - assert (1 <= x * p) by nra; nra.
Qed.
End Ratio.
(* A bound of an angle from a weaker one, and what it says of the ratio. *)
Ltac sharper step l m := eapply Rle_trans;
  [apply (step l m); lra | unfold sinh; inverse_sines; interval].
Ltac all_below m := lazymatch goal with |- up_all ?r (?e ^ 2) * _ <= _ =>
  assert (0 <= e ^ 2 <= m ^ 2) by nra; set (u := e ^ 2) in *; clearbody u r;
  unfold up_all, up_exp, up_turn, low_sum, up_root, up_sine, up_time;
  interval with (i_bisect u, i_bisect r, i_depth 30) end.

(* Bounds on boxes. *)
Lemma sinh_above x : 0 <= x -> x <= sinh x.
Proof.
  intros X; enough (0 <= sinh x - x) by lra; apply (from_left_ge (fun t => sinh t - t) (fun t => cosh t - 1) 0 x).
  - exact X.
  - intros t _; eapply d_eq; [exact (d_minus sinh (fun u => u) t _ _ (d_sinh (fun u => u) t 1 (d_id t)) (d_id t)) |]; cbv beta; over_reals; ring.
  - intros t _; pose proof (cosh_above t); lra.
  - rewrite sinh_0; lra.
Qed.
Lemma tanh_share x y : 0 <= x -> x <= y -> 0 < y -> x * tanh y <= y * tanh x.
Proof.
  intros X L Y; enough (0 <= y * tanh x - x * tanh y) by lra.
  apply (concave (fun t => y * tanh t - t * tanh y) (fun t => y * / (cosh t * cosh t) - tanh y)
    (fun t => y * (- 2 * sinh t * / (cosh t * cosh t * cosh t))) 0 y x).
  - lra.
  - intros t _; pose proof (cosh_pos t); eapply d_eq; [exact (d_minus (fun u => y * tanh u) (fun u => u * tanh y) t _ _ (d_mult (fun _ => y) tanh t _ _ (d_const y t) (d_tanh (fun u => u) t 1 (d_id t))) (d_mult (fun u => u) (fun _ => tanh y) t _ _ (d_id t) (d_const _ t))) |]; cbv beta; over_reals; field; lra.
  - intros t _; pose proof (cosh_pos t); assert (0 < cosh t * cosh t) by nra; pose proof (d_cosh (fun u => u) t 1 (d_id t)) as DC; eapply d_eq; [exact (d_minus (fun u => y * / (cosh u * cosh u)) (fun _ => tanh y) t _ _ (d_mult (fun _ => y) (fun u => / (cosh u * cosh u)) t _ _ (d_const y t) (d_inv (fun u => cosh u * cosh u) t _ (d_mult cosh cosh t _ _ DC DC) ltac:(lra))) (d_const _ t)) |]; cbv beta; over_reals; field; lra.
  - intros t T; pose proof (cosh_pos t); assert (0 <= sinh t) by (pose proof (sinh_above t (proj1 T)); lra).
    assert (0 < / (cosh t * cosh t * cosh t)) by positive; set (j := / (cosh t * cosh t * cosh t)) in *.
    assert (0 <= sinh t * j) by (apply Rmult_le_pos; lra); nra.
  - rewrite tanh_0; lra.
  - lra.
Qed.
Lemma atan_share c z : 0 <= c <= 1 -> 0 <= z -> c * atan z <= atan (c * z).
Proof.
  intros C Z; enough (0 <= atan (c * z) - c * atan z) by lra.
  apply (concave (fun s : R => atan (s * z) - s * atan z) (fun s => z * / (1 + (s * z) ^ 2) - atan z)
    (fun s => - 2 * s * z ^ 3 * / (1 + (s * z) ^ 2) ^ 2) 0 1 c).
  - exact C.
  - intros t _; auto_derive; [exact I | field; nra].
  - intros t _; auto_derive; [nra | field; nra].
  - intros t T; assert (0 < / (1 + (t * z) ^ 2) ^ 2) by (apply Rinv_0_lt_compat; nra).
    set (j := / _) in *; assert (0 <= z ^ 3) by (apply pow_le; lra).
    assert (0 <= t * z ^ 3) by (apply Rmult_le_pos; lra); assert (0 <= t * z ^ 3 * j) by (apply Rmult_le_pos; lra); lra.
  - rewrite Rmult_0_l, atan_0; lra.
  - rewrite Rmult_1_l; lra.
Qed.
Lemma atan_difference x y z : 0 < x -> 0 < y -> z = / (1 + x * y) * (x - y) -> atan z = (-1) * atan y + atan x.
Proof.
  intros X Y E; pose proof (atan_bound x); pose proof (atan_bound y).
  pose proof (atan_above x X); pose proof (atan_above y Y); apply atan_unique; [lra |].
  replace ((-1) * atan y + atan x) with (atan x - atan y) by ring.
  rewrite sin_minus, cos_minus, E; assert (P : 0 < 1 + x * y) by nra.
  assert (CX : 0 < cos (atan x)) by (apply cos_gt_0; lra); assert (CY : 0 < cos (atan y)) by (apply cos_gt_0; lra).
  assert (SX : sin (atan x) = x * cos (atan x)) by (rewrite <- (sin_over_cos x) at 2; field; lra).
  assert (SY : sin (atan y) = y * cos (atan y)) by (rewrite <- (sin_over_cos y) at 2; field; lra).
  rewrite SX, SY; field; lra.
Qed.
Lemma mean_value_open (f df : R -> R) a b : a < b -> (forall x, a <= x <= b -> continuous f x) ->
  (forall x, a < x < b -> is_derive f x (df x)) -> exists c, a < c < b /\ f b - f a = df c * (b - a).
Proof.
  intros L C D; assert (pr : forall c, a < c < b -> derivable_pt f c).
  { intros c I; exists (df c); apply is_derive_Reals, D; lra. }
  destruct (MVT f id a b pr (fun c _ => derivable_pt_id c) L) as [c [I E]].
  - intros t T; apply continuity_pt_filterlim, C; lra.
  - intros t _; apply derivable_continuous_pt, derivable_pt_id.
  - assert (V : derive_pt f c (pr c I) = df c) by (apply derive_pt_eq_0, is_derive_Reals, D; lra).
    assert (U : derive_pt id c (derivable_pt_id c) = 1) by apply derive_pt_id.
    rewrite V, U in E; unfold id in E; exists c; split; [exact I | lra].
Qed.
(* The angle that a shape turns through on the separatrix from t on: it decreases in t, a and b. *)
Definition turn_from (a b t : R) : R :=
  (exponent a b t - ln t + ln (2 * / sqrt (b * / a + 1))) * / sqrt (a * b) - asin (sqrt (b * / (a + b))).
Definition turn_rate (a b t : R) : R := (1 - b * sin t ^ 2) * / root_of a b t * / sin t.
Lemma turn_from_is a b t : 0 < a -> 0 < b -> 0 < t -> 0 < sin t -> 0 <= cos t ->
  turn_from a b t = ln ((root_of a b t + cos t) * / (sqrt (b * / a + 1) * sin t)) * / sqrt (a * b)
    - asin (sqrt (b * / (a + b)) * cos t).
Proof.
  intros A B T S C; unfold turn_from, exponent; pose proof (root_above a b t A B) as W.
  assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
  assert (R0 : 0 < b * / a) by positive; assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  set (w := root_of a b t) in *; set (q := sqrt (b * / a + 1)) in *.
  replace (1 / 2 * w + 1 / 2 * cos t) with (/ 2 * (w + cos t)) by field.
  assert (0 < / sin t) by positive; assert (0 < / q) by positive.
  rewrite (ln_mult t), (ln_mult (/ 2)), (ln_mult 2), (ln_mult (w + cos t)), !ln_Rinv, (ln_mult q)
    by (first [lra | positive]); field; lra.
Qed.
Lemma turn_from_derive a b t : 0 < a -> 0 < b -> 0 < t -> 0 < sin t -> 0 < cos t ->
  is_derive (turn_from a b) t (- turn_rate a b t * / sqrt (a * b)).
Proof.
  intros A B T S C; assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
  pose proof (root_above a b t A B); unfold turn_from; eapply d_eq.
  - apply (d_minus (fun u => (exponent a b u - ln u + ln (2 * / sqrt (b * / a + 1))) * / sqrt (a * b))
      (fun _ => asin (sqrt (b * / (a + b))))); [| apply d_const].
    apply (d_mult (fun u => exponent a b u - ln u + ln (2 * / sqrt (b * / a + 1))) (fun _ => / sqrt (a * b)));
      [| apply d_const].
    apply (d_plus (fun u => exponent a b u - ln u) (fun _ => ln (2 * / sqrt (b * / a + 1)))); [| apply d_const].
    apply (d_minus (exponent a b) ln); [apply exponent_derive; assumption | apply is_derive_ln, T].
  - cbv beta; unfold turn_rate; over_reals; field; lra.
Qed.
Lemma turn_from_end a b : 0 < a -> 0 < b -> turn_from a b (PI / 2) = 0.
Proof.
  intros A B; pose proof PI_RGT_0; rewrite turn_from_is; rewrite ?sin_PI2, ?cos_PI2; try lra.
  assert (R0 : 0 < b * / a) by positive; unfold root_of; rewrite sin_PI2.
  replace (b * / a * 1 ^ 2 + 1) with (b * / a + 1) by ring.
  assert (0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  replace ((sqrt (b * / a + 1) + 0) * / (sqrt (b * / a + 1) * 1)) with 1 by (field; lra).
  rewrite ln_1, Rmult_0_r, asin_0; ring.
Qed.
Lemma turn_from_continuous a b t : 0 < a -> 0 < b -> 0 < t -> t <= PI / 2 -> continuous (turn_from a b) t.
Proof.
  intros A B T L; pose proof PI_RGT_0; assert (S : 0 < sin t) by (apply sin_gt_0; lra).
  assert (C : 0 <= cos t) by (apply cos_ge_0; lra); pose proof (root_above a b t A B) as W; unfold root_of in W.
  pose proof (share_below a b t A B) as M.
  unfold turn_from, exponent, root_of; continues; cbv beta; try lra; try positive.
Qed.
Lemma rate_falls a b x y t : 0 < x -> x <= a -> 0 < y -> y <= b -> b <= 1 -> 0 < sin t ->
  turn_rate a b t * / sqrt (a * b) <= turn_rate x y t * / sqrt (x * y).
Proof.
  intros X A Y B L S; pose proof (SIN_bound t) as [_ S1].
  assert (E : forall u v, 0 < u -> 0 < v -> / root_of u v t * / sqrt (u * v) = / sqrt (v * (u + v * sin t ^ 2))).
  { intros u v U V; rewrite <- Rinv_mult; f_equal; unfold root_of; rewrite <- sqrt_mult.
    - f_equal; field; lra.
    - assert (0 < v * / u) by positive; pose proof (pow2_ge_0 (sin t)); nra.
    - nra. }
  unfold turn_rate.
  replace ((1 - b * sin t ^ 2) * / root_of a b t * / sin t * / sqrt (a * b))
    with ((1 - b * sin t ^ 2) * / sin t * (/ root_of a b t * / sqrt (a * b))) by ring.
  replace ((1 - y * sin t ^ 2) * / root_of x y t * / sin t * / sqrt (x * y))
    with ((1 - y * sin t ^ 2) * / sin t * (/ root_of x y t * / sqrt (x * y))) by ring.
  rewrite !E by lra; assert (0 < / sin t) by positive; assert (0 < sin t ^ 2 <= 1) by nra.
  assert (D : 0 < y * (x + y * sin t ^ 2)) by nra.
  apply Rmult_le_compat.
  - apply Rmult_le_pos; nra.
  - left; apply Rinv_0_lt_compat, sqrt_lt_R0; nra.
  - apply Rmult_le_compat_r; nra.
  - apply Rinv_le_contravar; [apply sqrt_lt_R0; exact D |]; apply sqrt_le_1_alt.
    apply Rmult_le_compat; nra.
Qed.
Lemma turn_falls_by_shape a b x y t : 0 < x -> x <= a -> 0 < y -> y <= b -> b <= 1 -> 0 < t -> t < PI / 2 ->
  turn_from a b t <= turn_from x y t.
Proof.
  intros X A Y B L T U.
  destruct (mean_value_open (fun u => turn_from a b u - turn_from x y u)
    (fun u => - turn_rate a b u * / sqrt (a * b) - (- turn_rate x y u * / sqrt (x * y))) t (PI / 2) U) as [c [C E]].
  - intros u V; apply (continuous_minus (turn_from a b) (turn_from x y)); apply turn_from_continuous; lra.
  - intros u V; apply (d_minus (turn_from a b) (turn_from x y)); apply turn_from_derive; try lra;
      first [apply sin_gt_0; lra | apply cos_gt_0; lra].
  - cbv beta in E; rewrite !turn_from_end in E by lra.
    pose proof (rate_falls a b x y c X A Y B L ltac:(apply sin_gt_0; lra)) as F; nra.
Qed.
Definition is_defect (a b e : R) : Prop := tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Lemma turn_of_defect a b e : 0 < a -> 0 < b -> 0 < e -> e < PI / 2 -> is_defect a b e -> turn_from a b e = PI.
Proof.
  unfold is_defect; intros A B E0 E1 E; assert (SE : 0 < sin e) by (apply sin_gt_0; lra); assert (CE : 0 < cos e) by (apply cos_gt_0; lra).
    rewrite turn_from_is by lra; pose proof (decay a b _ e A B SE CE E) as D.
    assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
    pose proof (root_above a b e A B) as W; unfold root_of in *.
    assert (0 < b * / a) by positive.
    assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
    set (w := sqrt (b * / a * sin e ^ 2 + 1)) in *; set (q := sqrt (b * / a + 1)) in *.
    replace ((w + cos e) * / (q * sin e)) with (/ (q * / (w + cos e) * sin e)) by (field; lra).
    rewrite <- D, <- exp_Ropp, ln_exp; field; lra.
Qed.
Lemma leading_of_defect a b e : 0 < a -> 0 < b -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  2 * sqrt (a * / (a + b)) * exp ((-1) * sqrt (a * b) * (PI + asin (sqrt (b * / (a + b))))) = e * exp ((-1) * exponent a b e).
Proof.
  intros A B E0 E1 E; pose proof (turn_of_defect a b e A B E0 E1 E) as T; unfold turn_from in T.
  assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
  assert (R0 : 0 < b * / a) by positive; assert (Q : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  rewrite (inverse_root a b A B); set (q := sqrt (b * / a + 1)) in *; assert (I : 0 < 2 * / q) by positive.
  set (t := asin (sqrt (b * / (a + b)))) in *; set (k := sqrt (a * b)) in *; set (x := exponent a b e) in *.
  assert (M : (-1) * x = (-1) * k * (PI + t) - ln e + ln (2 * / q)).
  { assert (V : (x - ln e + ln (2 * / q)) * / k = PI + t) by lra.
    assert (W : x - ln e + ln (2 * / q) = k * (PI + t)) by (rewrite <- V; field; lra); lra. }
  rewrite M; unfold Rminus; rewrite !exp_plus, exp_Ropp, !exp_ln by lra; field; lra.
Qed.
(* Where the equation of a smaller shape has the sign beyond its root, the root of a shape is not above. *)
Lemma defect_at_most a b x y c e : 0 < x -> x <= a -> 0 < y -> y <= b -> b <= 1 -> 0 < e -> e < PI / 2 ->
  tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e))) = / sqrt (b * / a * sin e ^ 2 + 1) * cos e ->
  0 < c -> c < PI / 2 -> 0 <= turn_short x y c -> e <= c.
Proof.
  intros X A Y B L E0 E1 E C0 C1 S; destruct (Rle_or_lt e c) as [H|H]; [exact H | exfalso].
  pose proof (turn_of_defect a b e ltac:(lra) ltac:(lra) E0 E1 E) as Ta.
  assert (Ts : turn_from x y c <= PI).
  { rewrite turn_short_is in S by lra.
    assert (SC : 0 < sin c) by (apply sin_gt_0; lra); assert (CC : 0 < cos c) by (apply cos_gt_0; lra).
    rewrite turn_from_is by lra; assert (K : 0 < sqrt (x * y)) by (apply sqrt_lt_R0; nra).
    pose proof (root_above x y c ltac:(lra) ltac:(lra)) as W; pose proof (root_square x y c ltac:(lra) ltac:(lra)) as W2.
    unfold root_of in *; assert (R0 : 0 < y * / x) by (positive).
    assert (Q : 0 < sqrt (y * / x + 1)) by (apply sqrt_lt_R0; lra).
    assert (Q2 : sqrt (y * / x + 1) ^ 2 = y * / x + 1) by (apply pow2_sqrt; lra).
    pose proof (sin_square c) as S2.
    set (w := sqrt (y * / x * sin c ^ 2 + 1)) in *; set (q := sqrt (y * / x + 1)) in *.
    set (m := asin (sqrt (y * / (x + y)) * cos c)) in *; set (v := (w + cos c) * / (q * sin c)).
    assert (V : 0 < v) by (unfold v; assert (0 < q * sin c) by nra; positive).
    assert (U : tanh (ln v) = / w * cos c).
    { unfold tanh, sinh, cosh; rewrite exp_Ropp, exp_ln by exact V; unfold v.
      assert (P : q ^ 2 * sin c ^ 2 = (w - cos c) * (w + cos c)).
      { replace ((w - cos c) * (w + cos c)) with (w ^ 2 - cos c ^ 2) by ring; rewrite W2, Q2, S2; ring. }
      assert (Z : / ((w + cos c) * / (q * sin c)) = (w - cos c) * / (q * sin c)).
      { replace ((w - cos c) * / (q * sin c)) with ((w - cos c) * (w + cos c) * / (q * sin c) * / (w + cos c)) by (field; lra).
        rewrite <- P; field; lra. }
      rewrite Z; assert (0 < q * sin c) by nra.
      set (j := / (q * sin c)); assert (0 < j) by (unfold j; positive); field; repeat split; try lra; nra. }
    assert (N : ln v <= sqrt (x * y) * (PI + m)).
    { destruct (Rle_or_lt (ln v) (sqrt (x * y) * (PI + m))) as [N|N]; [exact N |].
      apply increasing_tanh in N; lra. }
    apply (Rmult_le_reg_r (sqrt (x * y))); [exact K |].
    replace ((ln v * / sqrt (x * y) - m) * sqrt (x * y)) with (ln v - m * sqrt (x * y)) by (field; lra); lra. }
  pose proof (turn_falls_by_shape a b x y c X A Y B L C0 C1) as M.
  destruct (mean_value_open (turn_from a b) (fun t => - turn_rate a b t * / sqrt (a * b)) c e H) as [t [T V]].
  - intros t T; apply turn_from_continuous; lra.
  - intros t T; apply turn_from_derive; try lra; first [apply sin_gt_0; lra | apply cos_gt_0; lra].
  - assert (ST : 0 < sin t) by (apply sin_gt_0; lra); pose proof (SIN_bound t).
    assert (0 < turn_rate a b t * / sqrt (a * b)); [| nra].
    assert (CT : 0 < cos t) by (apply cos_gt_0; lra); pose proof (sin_square t).
    assert (0 < 1 - b * sin t ^ 2) by nra; pose proof (root_above a b t ltac:(lra) ltac:(lra)).
    assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; nra); unfold turn_rate; positive.
Qed.
(* The exponent of an angle below a polynomial, by their slopes. *)
Lemma exponent_below a b p dp e : 0 < a -> 0 < b -> 0 < e -> e < PI / 2 ->
  p 0 = 0 -> (forall t, 0 <= t <= e -> is_derive p t (dp t)) ->
  (forall t, 0 < t < e -> / t - turn_rate a b t <= dp t) -> exponent a b e <= p e.
Proof.
  intros A B E0 E1 P0 P D; destruct (Rle_or_lt (exponent a b e) (p e)) as [H|H]; [exact H | exfalso].
  set (g := fun t => p t - (sqrt (a * b) * ((-1) * asin (sqrt (b * / (a + b)) * cos t) + asin (sqrt (b * / (a + b))))
    + ln (1 / 2 * root_of a b t + 1 / 2 * cos t))).
  set (h := exponent a b e - p e) in *; assert (H0 : 0 < h) by (unfold h; lra).
  assert (G0 : g 0 = 0).
  { unfold g, root_of; rewrite P0, sin_0, cos_0, Rmult_1_r; replace (b * / a * 0 ^ 2 + 1) with 1 by ring.
    rewrite sqrt_1; replace (1 / 2 * 1 + 1 / 2 * 1) with 1 by field; rewrite ln_1; ring. }
  assert (GC : continuous g 0).
  { unfold g; apply (continuous_minus p (fun t : R => sqrt (a * b) * ((-1) * asin (sqrt (b * / (a + b)) * cos t)
      + asin (sqrt (b * / (a + b)))) + ln (1 / 2 * root_of a b t + 1 / 2 * cos t)));
      [apply (continuous_derive p (dp 0)), P; lra |].
    pose proof (share_below a b 0 A B); pose proof (root_above a b 0 A B); unfold root_of in *.
    continues; cbv beta; rewrite ?cos_0 in *; try lra. }
  apply continuity_pt_filterlim in GC.
  destruct (GC (h / 2) ltac:(lra)) as [d [D0 N]]; cbn in N.
  set (t := Rmin (d / 2) (Rmin (e / 2) (Rmin (h / 4) (1 / 2)))).
  assert (T : 0 < t /\ t < d /\ t < e /\ t <= h / 4 /\ t <= 1 / 2).
  { unfold t; repeat split.
    - repeat apply Rmin_glb_lt; lra.
    - eapply Rle_lt_trans; [apply Rmin_l | lra].
    - eapply Rle_lt_trans; [apply Rmin_r |]; eapply Rle_lt_trans; [apply Rmin_l | lra].
    - eapply Rle_trans; [apply Rmin_r |]; eapply Rle_trans; [apply Rmin_r |]; apply Rmin_l.
    - eapply Rle_trans; [apply Rmin_r |]; eapply Rle_trans; [apply Rmin_r |]; apply Rmin_r. }
  clearbody t; destruct T as [T0 [T1 [T2 [T3 T4]]]].
  specialize (N t); unfold dist in N; cbn in N; unfold R_dist in N; rewrite G0 in N.
  assert (GT : - (h / 2) < g t).
  { enough (Rabs (g t - 0) < h / 2) as Z by (apply Rabs_def2 in Z; lra).
    apply N; split; [split; [exact I | lra] | rewrite Rminus_0_r, Rabs_pos_eq by lra; exact T1]. }
  assert (SE : forall u, 0 < u -> u <= e -> 0 < sin u /\ 0 < cos u).
  { intros u U V; split; [apply sin_gt_0; lra | apply cos_gt_0; lra]. }
  destruct (SE t T0 ltac:(lra)) as [S C].
  assert (LS : ln (t * / sin t) <= t).
  { destruct (small_sine t) as [[X _] _]; try lra.
    assert (I : 0 < / sin t) by positive.
    assert (V : 0 < t * / sin t) by positive.
    eapply Rle_trans; [apply ln_below; exact V |].
    apply (Rmult_le_reg_r (sin t)); [exact S |].
    replace ((t * / sin t - 1) * sin t) with (t - sin t) by (field; lra).
    assert (t - sin t <= t ^ 3 / 6) by lra; assert (t ^ 3 / 6 <= t * (t * (1 - t ^ 2 / 6))); [| nra].
    assert (0 <= t ^ 2 <= 1 / 4) by nra; nra. }
  destruct (mean_value_open (fun u => p u - exponent a b u) (fun u => dp u - (/ u - turn_rate a b u)) t e T2) as [c [CC V]].
  - intros u U; destruct (SE u ltac:(lra) ltac:(lra)).
    apply (continuous_derive _ (dp u - (/ u - turn_rate a b u))).
    apply (d_minus p (exponent a b)); [apply P; lra |].
    eapply d_eq; [apply exponent_derive; lra |]; unfold turn_rate; ring.
  - intros u U; destruct (SE u ltac:(lra) ltac:(lra)).
    apply (d_minus p (exponent a b)); [apply P; lra |].
    eapply d_eq; [apply exponent_derive; lra |]; unfold turn_rate; ring.
  - specialize (D c ltac:(lra)); cbv beta in V.
    assert (p t - exponent a b t = g t - ln (t * / sin t)) by (unfold exponent, g; ring).
    unfold h in *; nra.
Qed.
(* The slope of the exponent in the square v of the angle, for all shapes up to b and b / a = r. *)
Definition sine_top (v : R) : R := 1 - v / 6 + v ^ 2 / 120.
Definition slope_rest (b r p q v : R) : R :=
  let w := sqrt (1 + r * (sine_top v ^ 2 * v)) in
  1 / 6 - v / 120 - b * sine_top v ^ 2 - r * sine_top v ^ 3 / (1 + w) + sine_top v * w * (2 * p - 4 * q * v).
Lemma sine_below_top t : 0 <= t -> t <= PI / 2 -> sin t <= t * sine_top (t ^ 2) /\ 0 < sine_top (t ^ 2).
Proof.
  intros T L; assert (P : PI <= 4) by interval; destruct (pre_sin_bound t 0) as [_ U]; try lra.
  unfold sin_approx, sin_term in U; cbn in U; unfold sine_top; split.
  - eapply Rle_trans; [exact U |]; right; field.
  - assert (0 <= t ^ 2 <= 4) by nra; set (v := t ^ 2) in *; nra.
Qed.
Lemma slope_below a b z r p q e m : 0 < a -> 0 < b -> b <= z -> z <= 1 -> b * / a <= r -> 0 < e -> e < PI / 2 ->
  e ^ 2 <= m -> (forall v, 0 <= v <= m -> 0 <= slope_rest z r p q v) ->
  exponent a b e <= p * e ^ 2 - q * e ^ 4.
Proof.
  intros A B Z Z1 RR E0 E1 M H.
  apply (exponent_below a b (fun t => p * t ^ 2 - q * t ^ 4) (fun t => 2 * p * t - 4 * q * t ^ 3)); trivial.
  - ring.
  - intros t _; auto_derive; [exact I | ring].
  - intros t T; set (v := t ^ 2); assert (V : 0 < v <= m) by (unfold v; nra).
    specialize (H v ltac:(lra)); unfold slope_rest in H; cbv zeta in H.
    destruct (sine_below_top t) as [S M0]; try lra; fold v in S, M0; set (n := sine_top v) in *.
    assert (S0 : 0 < sin t) by (apply sin_gt_0; lra).
    assert (R0 : 0 < b * / a) by positive; pose proof (root_above a b t A B) as W1.
    assert (S2 : sin t ^ 2 <= n ^ 2 * v) by (unfold v; rewrite <- Rpow_mult_distr; nra).
    assert (Y0 : 0 <= r * (n ^ 2 * v)) by (apply Rmult_le_pos; nra).
    assert (WW : root_of a b t <= sqrt (1 + r * (n ^ 2 * v))).
    { unfold root_of; apply sqrt_le_1_alt; assert (0 <= sin t ^ 2) by nra; nra. }
    assert (W2 : sqrt (1 + r * (n ^ 2 * v)) ^ 2 = 1 + r * (n ^ 2 * v)) by (apply pow2_sqrt; lra).
    set (w := sqrt (1 + _)) in *; set (x := root_of a b t) in *.
    set (k := 1 - 2 * p * v + 4 * q * v ^ 2).
    assert (F : n * w * k <= 1 - z * (n ^ 2 * v)).
    { assert (N : n = 1 - v / 6 + v ^ 2 / 120) by reflexivity.
      assert (G : 1 - z * (n ^ 2 * v) - n * w * k
        = v * (1 / 6 - v / 120 - z * n ^ 2 - r * n ^ 3 / (1 + w) + n * w * (2 * p - 4 * q * v))
          + (1 - n - v * (1 / 6 - v / 120)) + n / (1 + w) * (1 + r * (n ^ 2 * v) - w ^ 2)).
      { unfold k; field; lra. }
      rewrite W2 in G; assert (1 - n - v * (1 / 6 - v / 120) = 0) by (rewrite N; field).
      assert (0 <= v * (1 / 6 - v / 120 - z * n ^ 2 - r * n ^ 3 / (1 + w) + n * w * (2 * p - 4 * q * v)))
        by (apply Rmult_le_pos; lra).
      replace (1 + r * (n ^ 2 * v) - (1 + r * (n ^ 2 * v))) with 0 in G by ring; rewrite Rmult_0_r in G; lra. }
    assert (J : / t * k <= turn_rate a b t).
    { unfold turn_rate; fold x; assert (I : 0 < / t) by positive; assert (I1 : 0 < / x * / sin t) by positive.
      assert (B2 : 1 - z * (n ^ 2 * v) <= 1 - b * sin t ^ 2) by (assert (0 <= sin t ^ 2) by nra; nra).
      assert (B3 : 0 <= 1 - b * sin t ^ 2) by (pose proof (SIN_bound t); assert (sin t ^ 2 <= 1) by nra; nra).
      apply (Rmult_le_reg_r (t * (x * sin t))); [apply Rmult_lt_0_compat; [lra | nra] |].
      replace (/ t * k * (t * (x * sin t))) with (k * (x * sin t)) by (field; lra).
      replace ((1 - b * sin t ^ 2) * / x * / sin t * (t * (x * sin t))) with (t * (1 - b * sin t ^ 2)) by (field; lra).
      destruct (Rle_or_lt k 0) as [K|K].
      - assert (0 < x * sin t) by nra; nra.
      - apply Rle_trans with (k * (w * (t * n))); [| assert (t * (n * w * k) <= t * (1 - b * sin t ^ 2)) by nra; lra].
        apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat; lra. }
    assert (/ t * k = / t - (2 * p * t - 4 * q * t ^ 3)) by (unfold k, v; field; lra); lra.
Qed.
Lemma exp_nearer z : 0 <= z -> z <= 8 / 10 -> exp z <= 1 + z * (1 + z / 2 + z ^ 2 / 6 + z ^ 3 / 19).
Proof.
  intros A B; set (p := fun t : R => 1 + t * (1 + t / 2 + t ^ 2 / 6 + t ^ 3 / 19)).
  assert (H : 0 <= p z * exp (- z) - 1).
  { apply (from_left_ge (fun t : R => p t * exp (- t) - 1) (fun t : R => t ^ 3 * (4 / 19 - 1 / 6 - t / 19) * exp (- t)) 0 z).
    - exact A.
    - intros t T; unfold p; auto_derive; [exact I | field].
    - intros t T; pose proof (exp_pos (- t)); apply Rmult_le_pos; [| lra]; apply Rmult_le_pos; [apply pow_le |]; lra.
    - unfold p; rewrite Ropp_0, exp_0; lra. }
  rewrite exp_Ropp in H; pose proof (exp_pos z) as P; apply (Rmult_le_compat_r (exp z)) in H; [| lra].
  rewrite Rmult_0_l, Rmult_minus_distr_r, Rmult_assoc, Rinv_l in H; unfold p in *; lra.
Qed.
(* What a bound of the exponent says of the ratio of the defect to its leading term. *)
Definition ratio_rest (p q v : R) : R :=
  let x := v * (p - q * v) in (p - q * v) * (1 + x / 2 + x ^ 2 / 6 + x ^ 3 / 19) * exp (2 * x).
Definition within_ratio (K a b e : R) : Prop :=
  (exp (exponent a b e) - 1) * exp (2 * exponent a b e) <= K * e ^ 2.
Lemma ratio_under a b z r p q e m K : 0 < a -> 0 < b -> b <= z -> z <= 1 -> b * / a <= r -> 0 < e -> e < PI / 2 ->
  e ^ 2 <= m -> 0 < K -> (forall v, 0 <= v <= m -> 0 <= slope_rest z r p q v) ->
  (forall v, 0 <= v <= m -> 0 <= p - q * v /\ v * (p - q * v) <= 8 / 10 /\ ratio_rest p q v <= K) -> within_ratio K a b e.
Proof.
  intros A B Z Z1 RR E0 E1 M K0 H N; pose proof (slope_below a b z r p q e m A B Z Z1 RR E0 E1 M H) as L.
  assert (V : 0 < e ^ 2) by nra; destruct (N (e ^ 2) ltac:(lra)) as [N1 [N2 N3]]; unfold within_ratio.
  replace (p * e ^ 2 - q * e ^ 4) with (e ^ 2 * (p - q * e ^ 2)) in L by ring.
  set (v := e ^ 2) in *; set (g := p - q * v) in *; unfold ratio_rest in N3; fold g in N3; cbv zeta in N3.
  set (x := exponent a b e) in *; assert (X0 : 0 <= v * g) by nra.
  pose proof (exp_nearer (v * g) X0 N2) as Y; pose proof (exp_rises x (v * g) L) as U.
  assert (T : exp (2 * x) <= exp (2 * (v * g))) by (apply exp_rises; lra).
  pose proof (exp_pos (2 * x)); pose proof (exp_pos (2 * (v * g))).
  destruct (Rle_or_lt (exp x) 1) as [P|P]; [nra |].
  apply Rle_trans with (v * g * (1 + v * g / 2 + (v * g) ^ 2 / 6 + (v * g) ^ 3 / 19) * exp (2 * (v * g))).
  - apply Rmult_le_compat; lra.
  - replace (v * g * (1 + v * g / 2 + (v * g) ^ 2 / 6 + (v * g) ^ 3 / 19) * exp (2 * (v * g)))
      with (v * (g * (1 + v * g / 2 + (v * g) ^ 2 / 6 + (v * g) ^ 3 / 19) * exp (2 * (v * g)))) by ring; nra.
Qed.
Lemma ratio_cell a b e a0 y z c m p q K : 0 < a0 -> a0 <= a -> 0 < y -> y <= b -> b <= z -> z <= 1 -> 0 < e -> e < PI / 2 ->
  is_defect a b e -> 0 < c -> c ^ 2 <= m -> c < PI / 2 -> 0 <= turn_short a0 y c -> 0 < K ->
  (forall v, 0 <= v <= m -> 0 <= slope_rest z (z / a0) p q v) ->
  (forall v, 0 <= v <= m -> 0 <= p - q * v /\ v * (p - q * v) <= 8 / 10 /\ ratio_rest p q v <= K) -> within_ratio K a b e.
Proof.
  intros A0 A Y B Z Z1 E0 E1 D C0 M C1 T K0 H N.
  pose proof (defect_at_most a b a0 y c e A0 A Y B ltac:(lra) E0 E1 D C0 C1 T) as L.
  apply (ratio_under a b z (z / a0) p q e m K); try lra; try assumption; [| nra].
  unfold Rdiv; apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra].
Qed.
Lemma ratio_of_leading a b e s K : 0 < a -> 0 < b -> 0 < e -> e < PI / 2 -> s = e * exp ((-1) * exponent a b e) ->
  1 / 4 <= K -> within_ratio K a b e -> Rabs (e * / s + (-1)) <= K * s ^ 2.
Proof.
  intros A B E0 E1 S K4 H; unfold within_ratio in H; rewrite S; clear S.
  assert (S0 : 0 < sin e) by (apply sin_gt_0; lra); assert (C0 : 0 < cos e) by (apply cos_gt_0; lra).
  assert (L : 1 - e ^ 2 / 4 <= exp (exponent a b e)).
  { unfold exponent; rewrite !exp_plus; pose proof (root_above a b e A B) as W.
    rewrite !exp_ln by (first [lra | positive]).
    assert (X : 1 <= exp (sqrt (a * b) * (-1 * asin (sqrt (b * / (a + b)) * cos e) + asin (sqrt (b * / (a + b)))))).
    { rewrite <- exp_0 at 1; apply exp_rises, Rmult_le_pos; [apply sqrt_pos |].
      pose proof (share_below a b e A B); pose proof (share_below a b 0 A B) as Y; rewrite cos_0, Rmult_1_r in Y.
      pose proof (sqrt_pos (b * / (a + b))); pose proof (COS_bound e).
      destruct (Rle_lt_or_eq_dec (sqrt (b * / (a + b)) * cos e) (sqrt (b * / (a + b))) ltac:(nra)) as [P|P];
        [assert (asin (sqrt (b * / (a + b)) * cos e) < asin (sqrt (b * / (a + b)))) by (apply asin_rises; lra); lra | rewrite P; lra]. }
    assert (Y : 1 <= e * / sin e).
    { assert (sin e <= e) by (left; apply sin_lt_x; lra); apply (Rmult_le_reg_r (sin e)); [lra |].
      rewrite Rmult_assoc, Rinv_l by lra; lra. }
    assert (Z : 1 - e ^ 2 / 4 <= 1 / 2 * root_of a b e + 1 / 2 * cos e).
    { assert (PI <= 4) by interval; destruct (pre_cos_bound e 0) as [V _]; try lra.
      unfold cos_approx, cos_term in V; cbn in V; assert (1 - e ^ 2 / 2 <= cos e) by (eapply Rle_trans, V; right; field); lra. }
    match goal with |- _ <= exp ?q * _ * _ => set (u := exp q) in * end; set (j := e * / sin e) in *; set (d := 1 / 2 * _ + _) in *.
    assert (0 < d) by (unfold d; lra); assert (1 <= u * j) by nra; nra. }
  pose proof (exp_pos (exponent a b e)) as P; set (x := exponent a b e) in *.
  replace (2 * x) with (x + x) in H by ring; rewrite exp_plus in H.
  replace ((-1) * x) with (- x) by ring; rewrite exp_Ropp; set (X := exp x) in *.
  replace (e * / (e * / X) + -1) with (X - 1) by (field; lra).
  apply (Rmult_le_reg_r (X ^ 2)); [nra |].
  replace (K * (e * / X) ^ 2 * X ^ 2) with (K * e ^ 2) by (field; lra).
  destruct (Rle_or_lt 1 X) as [G|G].
  - rewrite Rabs_pos_eq by lra; lra.
  - rewrite Rabs_left by lra; assert (X ^ 2 <= 1) by nra; assert (0 <= e ^ 2) by nra; nra.
Qed.
Lemma exponent_grows a b x z e : 0 < a -> 0 < b -> 0 < x -> b <= z -> z <= 1 -> b * / a <= z * / x -> 0 < e -> e < PI / 2 ->
  exponent a b e <= exponent x z e.
Proof.
  intros A B X Z Z1 RR E0 E1.
  set (g := fun (a b t : R) => sqrt (a * b) * ((-1) * asin (sqrt (b * / (a + b)) * cos t) + asin (sqrt (b * / (a + b))))
    + ln (1 / 2 * root_of a b t + 1 / 2 * cos t)).
  assert (P : forall u v t, exponent u v t = g u v t + ln (t * / sin t)) by (intros; unfold exponent, g; ring).
  assert (G0 : forall u v, g u v 0 = 0).
  { intros u v; unfold g, root_of; rewrite sin_0, cos_0, Rmult_1_r; replace (v * / u * 0 ^ 2 + 1) with 1 by ring.
    rewrite sqrt_1; replace (1 / 2 * 1 + 1 / 2 * 1) with 1 by field; rewrite ln_1; ring. }
  assert (SE : forall t, 0 < t -> t < PI / 2 -> 0 < sin t /\ 0 < cos t).
  { intros t U V; split; [apply sin_gt_0; lra | apply cos_gt_0; lra]. }
  assert (GC : forall u v t, 0 < u -> 0 < v -> 0 <= t -> t <= e -> continuous (g u v) t).
  { intros u v t U V T0 T1; pose proof (share_below u v t U V); pose proof (root_above u v t U V).
    assert (0 < cos t) by (apply cos_gt_0; lra); unfold g, root_of in *; continues; cbv beta; lra. }
  assert (GD : forall u v t, 0 < u -> 0 < v -> 0 < t -> t < PI / 2 -> is_derive (g u v) t (cot t - turn_rate u v t)).
  { intros u v t U V T0 T1; destruct (SE t T0 T1) as [S C].
    apply (is_derive_ext (fun s => exponent u v s - ln (s * / sin s))); [intros s; rewrite P; over_reals; ring |].
    eapply d_eq; [apply (d_minus (exponent u v) (fun s => ln (s * / sin s)));
      [apply exponent_derive; assumption | derive; first [lra | positive]] |].
    unfold turn_rate, cot; over_reals; pose proof (root_above u v t U V); field; lra. }
  rewrite !P; enough (g a b e <= g x z e) by lra.
  destruct (mean_value_open (fun t => g x z t - g a b t)
    (fun t => cot t - turn_rate x z t - (cot t - turn_rate a b t)) 0 e E0) as [c [C V]].
  - intros t T; apply (continuous_minus (g x z) (g a b)); apply GC; lra.
  - intros t T; apply (d_minus (g x z) (g a b)); apply GD; lra.
  - cbv beta in V; rewrite !G0 in V; destruct (SE c ltac:(lra) ltac:(lra)) as [S _].
    assert (turn_rate x z c <= turn_rate a b c); [| nra].
    unfold turn_rate; pose proof (root_above a b c A B) as W; pose proof (SIN_bound c); assert (0 < / sin c) by positive.
    assert (0 < sin c ^ 2 <= 1) by nra.
    apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat; try nra.
    + left; apply Rinv_0_lt_compat; pose proof (root_above x z c X ltac:(lra)); lra.
    + apply Rinv_le_contravar; [lra |]; apply sqrt_le_1_alt; nra.
Qed.
(* The ratio itself, for angles that are not near 0. *)
Definition ratio_at (x z e : R) : R :=
  let k := sqrt (x * z) in let n := sqrt (z / (x + z)) in let c := cos e in
  exp (k * (atan (sqrt (z / x)) - atan (n * c / sqrt (1 - n * c * (n * c))))) * (e / sin e)
    * ((sqrt (z / x * sin e ^ 2 + 1) + c) / 2).
Lemma ratio_at_is x z e : 0 < x -> 0 < z -> 0 < e -> e < PI / 2 -> exp (exponent x z e) = ratio_at x z e.
Proof.
  intros X Z E0 E1; assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
  pose proof (root_above x z e X Z) as W; unfold exponent; rewrite !exp_plus, !exp_ln by (first [lra | positive]).
  pose proof (share_below x z e X Z) as H; rewrite (asin_by_atan _ H).
  pose proof (turn_of_share x z 0 X Z) as T; rewrite cos_0, sin_0, !Rmult_1_r in T.
  replace (z * / x * 0 ^ 2 + 1) with 1 in T by ring; rewrite sqrt_1 in T; replace (sqrt (z * / x) * / 1) with (sqrt (z * / x)) in T by field.
  rewrite T; unfold ratio_at, root_of, Rdiv; cbv zeta.
  replace (-1 * atan (sqrt (z * / (x + z)) * cos e * / sqrt (1 - sqrt (z * / (x + z)) * cos e * (sqrt (z * / (x + z)) * cos e))) + atan (sqrt (z * / x)))
    with (atan (sqrt (z * / x)) - atan (sqrt (z * / (x + z)) * cos e * / sqrt (1 - sqrt (z * / (x + z)) * cos e * (sqrt (z * / (x + z)) * cos e)))) by ring.
  ring.
Qed.
Lemma ratio_cell_2 a b e a0 y z c d m p q K : 0 < a0 -> a0 <= a -> 0 < y -> y <= b -> b <= z -> z <= 1 -> 0 < e -> e < PI / 2 ->
  is_defect a b e -> 0 < c -> d ^ 2 <= m -> 0 < d -> d < PI / 2 -> c < PI / 2 -> 0 <= turn_short a0 y c -> 0 < K ->
  (forall v, 0 <= v <= m -> 0 <= slope_rest z (z / a0) p q v) ->
  (forall v, 0 <= v <= m -> 0 <= p - q * v /\ v * (p - q * v) <= 8 / 10 /\ ratio_rest p q v <= K) ->
  (forall t, d <= t <= c -> 1 <= ratio_at a0 z t /\ (ratio_at a0 z t - 1) * ratio_at a0 z t ^ 2 * / t ^ 2 <= K) -> within_ratio K a b e.
Proof.
  intros A0 A Y B Z Z1 E0 E1 D C0 M D0 D1 C1 T K0 H N V.
  pose proof (defect_at_most a b a0 y c e A0 A Y B ltac:(lra) E0 E1 D C0 C1 T) as L.
  assert (RR : b * / a <= z * / a0).
  { apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]. }
  destruct (Rle_or_lt e d) as [G|G].
  - apply (ratio_under a b z (z / a0) p q e m K); try lra; try assumption; nra.
  - destruct (V e ltac:(lra)) as [V1 V2]; assert (P2 : 0 < e ^ 2) by nra.
    apply (Rmult_le_compat_r (e ^ 2)) in V2; [| lra]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r in V2 by lra; rewrite <- ratio_at_is in V1, V2 by lra.
    pose proof (exponent_grows a b a0 z e ltac:(lra) ltac:(lra) A0 Z Z1 RR E0 E1) as X; apply exp_rises in X.
    unfold within_ratio; replace (2 * exponent a b e) with (exponent a b e + exponent a b e) by ring.
    rewrite exp_plus; pose proof (exp_pos (exponent a b e)); set (u := exp (exponent a b e)) in *.
    set (x := exp (exponent a0 z e)) in *; destruct (Rle_or_lt u 1); [assert (0 <= u * u) by nra; assert (0 <= e ^ 2) by nra; nra |].
    apply Rle_trans with ((x - 1) * x ^ 2); [| exact V2]; apply Rmult_le_compat; nra.
Qed.
Ltac slopes_by := let v := fresh "v" in let V := fresh "V" in intros v V; unfold slope_rest, sine_top; interval with (i_bisect v).
Ltac ratios_by := let v := fresh "v" in let V := fresh "V" in intros v V; repeat split;
  [interval | unfold ratio_rest; interval with (i_bisect v) | unfold ratio_rest; interval with (i_bisect v)].
(* The part y <= b <= z of a >= a0: the defect is at most c, by slopes p, q up to the angle d or c. *)
Ltac ratio_part K a b e E a0 y z c m p q := destruct (Rle_or_lt y b) as [?|?];
  [apply (ratio_cell a b e a0 y z c m p q K); try lra; [exact E | interval | unfold turn_short; interval with (i_prec 60) | slopes_by | ratios_by] |].
Ltac ratio_part_beyond K a b e E a0 y z c d m p q := destruct (Rle_or_lt y b) as [?|?];
  [apply (ratio_cell_2 a b e a0 y z c d m p q K); try lra; [exact E | interval | interval | unfold turn_short; interval with (i_prec 60) | slopes_by | ratios_by
  | let t := fresh "t" in let T := fresh "T" in intros t T; unfold ratio_at; cbv zeta; split; interval with (i_bisect t, i_depth 30)] |].
Ltac ratio_rest_part K a b e a0 z p q :=
  apply (ratio_under a b z (z / a0) p q e (24675 / 10000) K); try lra;
  [unfold Rdiv; apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]
  | assert (PI / 2 <= 15708 / 10000) by interval; nra | slopes_by | ratios_by].
(* The sine of a defect by the product of the shape, and its square against that product. *)
Lemma defect_small a b e : 0 < a -> 0 < b -> b <= 1 -> 1 / 4 <= a * b -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  e <= 45 / 100 /\ e ^ 2 * (a * b) <= 51 / 1000.
Proof.
  intros A B B1 AB E0 E1 E; pose proof PI_RGT_0 as P.
  assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
  pose proof (sinh_at_root a b _ e A B S C E) as H.
  assert (K : 1 / 2 <= sqrt (a * b)) by (apply below_sqrt; lra).
  assert (K2 : sqrt (a * b) ^ 2 = a * b) by (apply pow2_sqrt; lra).
  assert (R0 : 0 < b * / a) by positive; assert (Q : 1 <= sqrt (b * / a + 1)) by (apply below_sqrt; lra).
  assert (M : 0 < asin (sqrt (b * / (a + b)) * cos e)).
  { apply asin_above, Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | exact C]. }
  set (k := sqrt (a * b)) in *; set (q := sqrt (b * / a + 1)) in *; set (m := asin _) in *.
  assert (L : 2 * k * sinh (PI / 2) <= sinh (k * (PI + m))).
  { apply Rle_trans with (sinh (k * PI)); [| apply sinh_grows; nra].
    enough (0 <= sinh (k * PI) - 2 * k * sinh (PI / 2)) by lra.
    apply (from_left_ge (fun t : R => sinh (t * PI) - 2 * t * sinh (PI / 2)) (fun t => PI * cosh (t * PI) - 2 * sinh (PI / 2)) (1 / 2) k K).
    - intros t _; eapply d_eq; [derive |]; cbv beta; over_reals; ring.
    - intros t T; pose proof (cosh_rises (PI / 2) (t * PI) ltac:(lra) ltac:(nra)).
      assert (2 * sinh (PI / 2) <= PI * cosh (PI / 2)) by (unfold sinh, cosh; interval); nra.
    - replace (1 / 2 * PI) with (PI / 2) by field; lra. }
  assert (N : 23 / 10 <= sinh (PI / 2)) by (unfold sinh; interval).
  assert (G : sin e * (46 / 10 * k) <= cos e).
  { assert (J : sin e * sinh (k * (PI + m)) <= cos e).
    { rewrite H; replace (sin e * (/ q * / sin e * cos e)) with (/ q * cos e) by (field; lra).
      assert (/ q <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra); nra. }
    assert (46 / 10 * k <= sinh (k * (PI + m))) by nra; nra. }
  assert (T : e * (46 / 10 * k) <= 1).
  { assert (F : e * cos e <= sin e).
    { enough (0 <= sin e - e * cos e) by lra.
      apply (from_left_ge (fun t : R => sin t - t * cos t) (fun t => t * sin t) 0 e); [lra | | |].
      - intros t _; auto_derive; [exact I | ring].
      - intros t T; apply Rmult_le_pos; [lra | apply sin_ge_0; lra].
      - rewrite sin_0; lra. }
    apply (Rmult_le_reg_r (cos e)); [exact C |]; nra. }
  split; [nra |]; rewrite <- K2; assert (0 < e * k) by nra; assert ((e * k) ^ 2 <= (10 / 46) ^ 2) by nra; nra.
Qed.
(* What the printed leading term adds to the logarithm of the true one. *)
Lemma printed_turn r : 0 < r -> 0 <= atan r - r * / sqrt (1 + r ^ 2) <= r * r ^ 2 / 6.
Proof.
  intros R0; assert (W : forall t, 1 <= sqrt (1 + t ^ 2) /\ sqrt (1 + t ^ 2) ^ 2 = 1 + t ^ 2).
  { intros t; pose proof (pow2_ge_0 t); split; [apply below_sqrt; lra | apply pow2_sqrt; lra]. }
  set (d := fun t : R => / (1 + t ^ 2) * (1 - / sqrt (1 + t ^ 2))).
  assert (D : forall t, is_derive (fun t : R => atan t - t * / sqrt (1 + t ^ 2)) t (d t)).
  { intros t; destruct (W t) as [W1 W2]; pose proof (pow2_ge_0 t); unfold d.
    auto_derive; [repeat split; try (apply Rgt_not_eq; simpl in *; lra); simpl in *; lra |].
    replace (1 + t * (t * 1)) with (1 + t ^ 2) by ring; set (w := sqrt (1 + t ^ 2)) in *.
    rewrite <- W2; field_simplify; [| lra | lra].
    replace (t ^ 2) with (w ^ 2 - 1) by lra; field; lra. }
  assert (I : forall t, 0 <= d t <= t ^ 2 / 2).
  { intros t; destruct (W t) as [W1 W2]; pose proof (pow2_ge_0 t) as Y; unfold d; set (w := sqrt (1 + t ^ 2)) in *.
    rewrite <- W2; replace (t ^ 2) with (w ^ 2 - 1) by lra.
    assert (J : 0 < / w <= 1) by (split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]).
    assert (V : w * / w = 1) by (field; lra); replace (/ w ^ 2) with (/ w * / w) by (field; lra); split; [apply Rmult_le_pos; nra |].
    assert (0 <= (w - 1) * (w ^ 3 + w ^ 2 - 2)) by (apply Rmult_le_pos; nra).
    apply (Rmult_le_reg_r (w ^ 3)); [apply pow_lt; lra |].
    replace (/ w * / w * (1 - / w) * w ^ 3) with (w - 1) by (field; lra); nra. }
  split.
  - apply (from_left_ge (fun t : R => atan t - t * / sqrt (1 + t ^ 2)) d 0 r); [lra | intros; apply D | intros; apply I |].
    rewrite atan_0; lra.
  - enough (0 <= r * r ^ 2 / 6 - (atan r - r * / sqrt (1 + r ^ 2))) by lra.
    apply (from_left_ge (fun t : R => t * t ^ 2 / 6 - (atan t - t * / sqrt (1 + t ^ 2))) (fun t => t ^ 2 / 2 - d t) 0 r).
    + lra.
    + intros t _; apply (d_minus (fun t : R => t * t ^ 2 / 6) (fun t : R => atan t - t * / sqrt (1 + t ^ 2))); [| apply D].
      auto_derive; [exact Logic.I | field].
    + intros t _; specialize (I t); lra.
    + rewrite atan_0; lra.
Qed.
Lemma asin_apart u v : 0 <= v -> v <= u -> u < 1 -> u - v <= asin u - asin v.
Proof.
  intros V U L; destruct (Req_dec u v) as [->|N]; [lra |].
  enough (0 <= asin u - asin v - (u - v)) by lra.
  apply (from_left_ge (fun t : R => asin t - asin v - (t - v)) (fun t => / sqrt ((-1) * t ^ 2 + 1) - 1) v u U).
  - intros t T; eapply d_eq; [apply (d_minus (fun t : R => asin t - asin v) (fun t : R => t - v));
      [apply (d_minus asin (fun _ => asin v)); [apply (d_asin (fun t : R => t)); [apply d_id | lra | lra] | apply d_const]
      | apply (d_minus (fun t : R => t) (fun _ => v)); [apply d_id | apply d_const]] |]; cbv beta; over_reals; ring.
  - intros t T; assert (0 < (-1) * t ^ 2 + 1) by nra; assert (0 < sqrt ((-1) * t ^ 2 + 1)) by (apply sqrt_lt_R0; lra).
    assert (sqrt ((-1) * t ^ 2 + 1) <= 1) by (apply above_sqrt; nra).
    enough (1 <= / sqrt ((-1) * t ^ 2 + 1)) by lra; rewrite <- Rinv_1 at 1; apply Rinv_le_contravar; lra.
  - lra.
Qed.
Lemma exponent_low a b e : 0 < a -> 0 < b -> b * / a <= 4 -> 0 < e -> e <= 45 / 100 ->
  - (27 / 100) * e ^ 2 <= exponent a b e /\ (1 / 2 <= b -> 0 <= exponent a b e).
Proof.
  intros A B R4 E0 E1; pose proof pi_between as P.
  assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
  destruct (small_sine e) as [[_ S1] [C1 C2]]; try lra; pose proof (sin_square e) as S2.
  pose proof (root_above a b e A B) as W; pose proof (root_square a b e A B) as W2.
  pose proof (share_below a b 0 A B) as M; rewrite cos_0, Rmult_1_r in M; pose proof (sqrt_pos (b * / (a + b))) as M0.
  assert (R0 : 0 < b * / a) by positive; pose proof (product_root a b A B) as KR.
  assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
  assert (KM : sqrt (a * b) * sqrt (b * / (a + b)) = b * / sqrt (b * / a + 1)).
  { rewrite <- (inverse_root a b A B); rewrite <- sqrt_mult by (left; positive).
    apply same_square; [apply sqrt_pos | pose proof (sqrt_pos (a * / (a + b))); nra |].
    rewrite Rpow_mult_distr, !pow2_sqrt by (left; positive); field; lra. }
  pose proof (asin_apart (sqrt (b * / (a + b))) (sqrt (b * / (a + b)) * cos e) ltac:(nra)
    ltac:(pose proof (COS_bound e); nra) ltac:(lra)) as T.
  unfold exponent; set (w := root_of a b e) in *; set (c := cos e) in *; set (m := sqrt (b * / (a + b))) in *.
  assert (U : 0 < 1 - c <= e ^ 2 / 2).
  { split; [unfold c; assert (cos e < cos 0) by (apply cos_decreasing_1; lra); rewrite cos_0 in *; lra | lra]. }
  assert (C9 : 89 / 100 <= c) by nra.
  assert (Q1 : 0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  assert (Q2 : sqrt (b * / a + 1) ^ 2 = b * / a + 1) by (apply pow2_sqrt; lra).
  assert (X : b * (1 - c) * / sqrt (b * / a + 1) <= sqrt (a * b) * ((-1) * asin (m * c) + asin m)).
  { replace (b * (1 - c) * / sqrt (b * / a + 1)) with (sqrt (a * b) * (m * (1 - c))) by (replace (sqrt (a * b) * (m * (1 - c))) with (sqrt (a * b) * m * (1 - c)) by ring; rewrite KM; ring).
    apply Rmult_le_compat_l; lra. }
  assert (Low : forall y, 0 < y -> 1 - / y <= ln y).
  { intros y Y; pose proof (ln_below (/ y) ltac:(positive)) as Z; rewrite ln_Rinv in Z by exact Y; lra. }
  assert (Y : 3 / 10 * (1 - c) <= ln (e * / sin e)).
  { assert (V : 0 < e * / sin e) by positive; eapply Rle_trans; [| apply Low, V].
    replace (/ (e * / sin e)) with (sin e * / e) by (field; lra).
    assert (sin e * / e <= 1 - e ^ 2 / 6 + e ^ 4 / 120).
    { apply (Rmult_le_reg_r e); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; lra. }
    assert (e ^ 4 <= 21 / 100 * e ^ 2) by (replace (e ^ 4) with (e ^ 2 * e ^ 2) by ring; apply Rmult_le_compat_r; nra); lra. }
  assert (D0 : 0 < 1 / 2 * w + 1 / 2 * c) by lra; pose proof (Low _ D0) as Z.
  set (d := 1 / 2 * w + 1 / 2 * c) in *; assert (D1 : 94 / 100 <= d) by (unfold d; lra).
  assert (I : / d * d = 1) by (field; lra); assert (I0 : 0 < / d) by positive; assert (I1 : / d <= 107 / 100) by nra.
  assert (X0 : 0 <= b * (1 - c) * / sqrt (b * / a + 1)) by (left; positive).
  split.
  - assert (0 <= (d - 1 + 1 / 2 * (1 - c)) * / d) by (apply Rmult_le_pos; [unfold d; lra | lra]).
    assert (0 <= 1 / 2 * (1 - c) * (107 / 100 - / d)) by (apply Rmult_le_pos; lra); lra.
  - intros B5; set (r := b * / a) in *; set (q := sqrt (r + 1)) in *.
    assert (J : 1 - r / 2 <= / q).
    { apply (Rmult_le_reg_r q); [exact Q1 |]; rewrite Rinv_l by lra.
      destruct (Rle_or_lt 2 r); [nra |]; assert (q <= 1 + r / 2) by (apply above_sqrt; nra); nra. }
    assert (J0 : 0 < / q) by positive.
    assert (G : (1 - c) * (1 / 2 * / q) <= b * (1 - c) * / q)
      by (assert (0 <= (b - 1 / 2) * ((1 - c) * / q)) by (repeat apply Rmult_le_pos; lra); lra).
    assert (W3 : 39 / 100 * r * (1 - c) <= 1 / 2 * (w - 1)).
    { assert (F : w ^ 2 - 1 = r * ((1 - c) * (1 + c))) by (rewrite W2, S2; ring).
      assert (w <= 14 / 10).
      { unfold w, root_of; apply above_sqrt; [lra |]; fold r; rewrite S2; assert ((1 - c ^ 2) <= 21 / 100) by nra; nra. }
      assert (0 < r * (1 - c)) by nra; assert (F2 : (w - 1) * (w + 1) = r * (1 - c) * (1 + c)) by lra; nra. }
    destruct (Rle_or_lt 1 d) as [L|L].
    + assert (0 <= ln d) by (apply ln_nonnegative, L); nra.
    + assert (0 <= (1 - d) * (107 / 100 - / d)) by (apply Rmult_le_pos; lra).
      assert (1 - / d >= - (107 / 100) * (1 - d)) by lra.
      assert (1 - d <= 1 / 2 * (1 - c) - 39 / 100 * r * (1 - c)) by (unfold d; lra).
      assert ((1 - c) * (1 / 2 * / q) >= (1 - c) * (1 / 2 * (1 - r / 2))) by nra.
      assert (0 <= r * (1 - c)) by nra; lra.
Qed.
Lemma printed_turn_sharp r : 0 < r -> r ^ 2 <= 1 / 4 ->
  r ^ 3 * (1666 / 10000 - 173 / 1000 * r ^ 2 + 1238 / 10000 * r ^ 4) <= atan r - r * / sqrt (1 + r ^ 2)
  <= r ^ 3 * (16674 / 100000 - 12 / 100 * r ^ 2).
Proof.
  intros R0 R1; assert (W : forall t, 1 <= sqrt (1 + t ^ 2) /\ sqrt (1 + t ^ 2) ^ 2 = 1 + t ^ 2).
  { intros t; pose proof (pow2_ge_0 t); split; [apply below_sqrt; lra | apply pow2_sqrt; lra]. }
  set (d := fun t : R => t ^ 2 * / ((1 + t ^ 2) * (sqrt (1 + t ^ 2) * (1 + sqrt (1 + t ^ 2))))).
  assert (D : forall t, is_derive (fun t : R => atan t - t * / sqrt (1 + t ^ 2)) t (d t)).
  { intros t; destruct (W t) as [W1 W2]; pose proof (pow2_ge_0 t); unfold d.
    auto_derive; [repeat split; try (apply Rgt_not_eq; simpl in *; lra); simpl in *; lra |].
    replace (1 + t * (t * 1)) with (1 + t ^ 2) by ring; set (w := sqrt (1 + t ^ 2)) in *.
    replace (1 * / w + t * (- (1 * ((1 + 1) * (t * 1)) * / (2 * w)) * / (w * w))) with ((w ^ 2 - t ^ 2) * / w ^ 3) by (field; lra).
    rewrite <- W2; replace (t ^ 2) with (w ^ 2 - 1) by lra; field; lra. }
  assert (I : forall y, 0 <= y <= 1 / 4 -> 4998 / 10000 - 865 / 1000 * y + 8666 / 10000 * y ^ 2
    <= / ((1 + y) * (sqrt (1 + y) * (1 + sqrt (1 + y)))) <= 50022 / 100000 - 6 / 10 * y).
  { intros y Y; split; apply not_below; interval with (i_bisect y, i_prec 60, i_depth 20). }
  assert (J : forall t, 0 <= t <= r -> t ^ 2 * (4998 / 10000 - 865 / 1000 * t ^ 2 + 8666 / 10000 * t ^ 4) <= d t
    <= t ^ 2 * (50022 / 100000 - 6 / 10 * t ^ 2)).
  { intros t T; assert (Y : 0 <= t ^ 2 <= 1 / 4) by nra; destruct (I _ Y); unfold d.
    replace (t ^ 4) with ((t ^ 2) ^ 2) by ring; split; apply Rmult_le_compat_l; lra. }
  split.
  - enough (0 <= (atan r - r * / sqrt (1 + r ^ 2)) - r ^ 3 * (1666 / 10000 - 173 / 1000 * r ^ 2 + 1238 / 10000 * r ^ 4)) by lra.
    apply (from_left_ge (fun t : R => (atan t - t * / sqrt (1 + t ^ 2)) - t ^ 3 * (1666 / 10000 - 173 / 1000 * t ^ 2 + 1238 / 10000 * t ^ 4))
      (fun t => d t - t ^ 2 * (4998 / 10000 - 865 / 1000 * t ^ 2 + 8666 / 10000 * t ^ 4)) 0 r).
    + lra.
    + intros t _; apply (d_minus (fun t : R => atan t - t * / sqrt (1 + t ^ 2))
        (fun t : R => t ^ 3 * (1666 / 10000 - 173 / 1000 * t ^ 2 + 1238 / 10000 * t ^ 4))); [apply D |].
      auto_derive; [exact Logic.I | field].
    + intros t T; specialize (J t T); lra.
    + rewrite atan_0; lra.
  - enough (0 <= r ^ 3 * (16674 / 100000 - 12 / 100 * r ^ 2) - (atan r - r * / sqrt (1 + r ^ 2))) by lra.
    apply (from_left_ge (fun t : R => t ^ 3 * (16674 / 100000 - 12 / 100 * t ^ 2) - (atan t - t * / sqrt (1 + t ^ 2)))
      (fun t => t ^ 2 * (50022 / 100000 - 6 / 10 * t ^ 2) - d t) 0 r).
    + lra.
    + intros t _; apply (d_minus (fun t : R => t ^ 3 * (16674 / 100000 - 12 / 100 * t ^ 2))
        (fun t : R => atan t - t * / sqrt (1 + t ^ 2))); [| apply D].
      auto_derive; [exact Logic.I | field].
    + intros t T; specialize (J t T); lra.
    + rewrite atan_0; lra.
Qed.
(* The square of a defect against the product of its shape, where that is at least 4. *)
Lemma defect_smaller a b e : 0 < a -> 0 < b -> b <= 1 -> 4 <= a * b -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  e ^ 2 * (a * b) <= 6 / 100000.
Proof.
  intros A B B1 AB E0 E1 E; pose proof PI_RGT_0 as P.
  assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
  pose proof (sinh_at_root a b _ e A B S C E) as H.
  assert (K : 2 <= sqrt (a * b)) by (apply below_sqrt; lra).
  assert (K2 : sqrt (a * b) ^ 2 = a * b) by (apply pow2_sqrt; lra).
  assert (R0 : 0 < b * / a) by positive; assert (Q : 1 <= sqrt (b * / a + 1)) by (apply below_sqrt; lra).
  assert (M : 0 < asin (sqrt (b * / (a + b)) * cos e)).
  { apply asin_above, Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | exact C]. }
  set (k := sqrt (a * b)) in *; set (q := sqrt (b * / a + 1)) in *; set (m := asin _) in *.
  assert (L : k * (sinh (2 * PI) / 2) <= sinh (k * (PI + m))).
  { apply Rle_trans with (sinh (k * PI)); [| apply sinh_grows; nra].
    enough (0 <= sinh (k * PI) - k * (sinh (2 * PI) / 2)) by lra.
    apply (from_left_ge (fun t : R => sinh (t * PI) - t * (sinh (2 * PI) / 2)) (fun t => PI * cosh (t * PI) - sinh (2 * PI) / 2) 2 k K).
    - intros t _; eapply d_eq; [derive |]; cbv beta; over_reals; ring.
    - intros t T; pose proof (cosh_rises (2 * PI) (t * PI) ltac:(lra) ltac:(nra)).
      assert (sinh (2 * PI) / 2 <= PI * cosh (2 * PI)) by (unfold sinh, cosh; interval); nra.
    - lra. }
  assert (N : 267 <= sinh (2 * PI)) by (unfold sinh; interval).
  assert (G : sin e * (1335 / 10 * k) <= cos e).
  { assert (J : sin e * sinh (k * (PI + m)) <= cos e).
    { rewrite H; replace (sin e * (/ q * / sin e * cos e)) with (/ q * cos e) by (field; lra).
      assert (/ q <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra); nra. }
    assert (1335 / 10 * k <= sinh (k * (PI + m))) by nra; nra. }
  assert (T : e * (1335 / 10 * k) <= 1).
  { assert (F : e * cos e <= sin e).
    { enough (0 <= sin e - e * cos e) by lra.
      apply (from_left_ge (fun t : R => sin t - t * cos t) (fun t => t * sin t) 0 e); [lra | | |].
      - intros t _; auto_derive; [exact I | ring].
      - intros t T; apply Rmult_le_pos; [lra | apply sin_ge_0; lra].
      - rewrite sin_0; lra. }
    apply (Rmult_le_reg_r (cos e)); [exact C |]; nra. }
  rewrite <- K2; assert (0 < e * k) by nra; assert ((e * k) ^ 2 <= (10 / 1335) ^ 2) by nra; nra.
Qed.
Lemma exp_above_square x : 0 <= x -> 1 + x + x ^ 2 / 2 <= exp x.
Proof.
  intros X; enough (0 <= exp x - (1 + x + x ^ 2 / 2)) by lra.
  apply (from_left_ge (fun t : R => exp t - (1 + t + t ^ 2 / 2)) (fun t => exp t - (1 + t)) 0 x X).
  - intros t _; auto_derive; [exact I | field].
  - intros t _; pose proof (exp_ineq1_le t); lra.
  - rewrite exp_0; lra.
Qed.

(* A motion that turns: its precession by the angle of the turning, and the level of a half turn. *)
Definition turned (a b c x : R) : R :=
  / (sqrt ((-1) * c * (b + a * (sin x) ^ 2) + a * b * (cos x) ^ 2))
  * / (a + b * (sin x) ^ 2 + (-1) * c * (cos x) ^ 2)
  * ((cos x) ^ 2 * ((-1) * b + 1) * (a + (-1) * c) + (sin x) ^ 2 * (c + 1) * (a + b)).
Definition turned_slope (a b c x : R) : R :=
  / 2 * (b + a * sin x ^ 2) * / sqrt ((-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2) ^ 3
    * / (a + b * sin x ^ 2 + (-1) * c * cos x ^ 2)
    * (cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * c) + sin x ^ 2 * (c + 1) * (a + b))
  + cos x ^ 2 * / sqrt ((-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2)
    * / (a + b * sin x ^ 2 + (-1) * c * cos x ^ 2) ^ 2
    * (cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * c) + sin x ^ 2 * (c + 1) * (a + b))
  + / sqrt ((-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2)
    * / (a + b * sin x ^ 2 + (-1) * c * cos x ^ 2)
    * (sin x ^ 2 * (a + b) - cos x ^ 2 * ((-1) * b + 1)).
Definition share_turned (a b e c : R) : R :=
  sqrt (b * / (a + b * (sin e) ^ 2) * / (c + b * (cos e) ^ 2 + b * (sin e) ^ 2) * (a + (-1) * c))
  * Rabs (cos e).
Definition end_turned (a b e c : R) : R := PI + (-1) * asin (share_turned a b e c).

Ltac weigh := repeat (apply Rmult_le_pos; [| lra]); lra.

Section Turned.
Variables a b : R.
Hypotheses (A : a > 0) (B : b > 0) (L : b <= 1).

Lemma squares x : 0 <= sin x ^ 2 /\ 0 <= cos x ^ 2 /\ sin x ^ 2 + cos x ^ 2 = 1.
Proof.
  pose proof (sin2_cos2 x); unfold Rsqr in *; repeat split; try apply pow2_ge_0; nra.
Qed.
Lemma under_root c x : - b < c < 0 -> 0 < (-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2.
Proof.
  intros C; destruct (squares x) as [S [K _]].
  assert (0 <= a * b * cos x ^ 2) by weigh.
  assert (0 <= a * sin x ^ 2) by weigh.
  assert (0 < (-1) * c * (b + a * sin x ^ 2)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.
Lemma below_line c x : - b < c < 0 -> 0 < a + b * sin x ^ 2 + (-1) * c * cos x ^ 2.
Proof.
  intros C; destruct (squares x) as [S [K _]].
  assert (0 <= b * sin x ^ 2) by weigh.
  assert (0 <= (-1) * c * cos x ^ 2) by weigh; lra.
Qed.
Lemma above_line c x : - b < c < 0 ->
  0 <= cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * c) + sin x ^ 2 * (c + 1) * (a + b).
Proof.
  intros C; destruct (squares x) as [S [K _]].
  apply Rplus_le_le_0_compat; weigh.
Qed.
Lemma turned_continuous c x : - b < c < 0 -> continuous (turned a b c) x.
Proof.
  intros C; pose proof (under_root c x C); pose proof (below_line c x C); unfold turned; continues;
    apply Rgt_not_eq; [apply sqrt_lt_R0 |]; assumption.
Qed.
Lemma turned_positive c x : - b < c < 0 -> 0 < sin x -> 0 < turned a b c x.
Proof.
  intros C S; pose proof (under_root c x C); pose proof (below_line c x C); unfold turned.
  destruct (squares x) as [_ [K _]].
  assert (0 <= cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * c)) by weigh.
  assert (0 < sin x ^ 2 * (c + 1) * (a + b)).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt; lra | lra] | lra]. }
  assert (0 < sqrt ((-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2)) by now apply sqrt_lt_R0.
  apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; now apply Rinv_0_lt_compat | lra].
Qed.
Lemma turned_rises c d x : - b < c -> c < d -> d < 0 -> turned a b c x <= turned a b d x.
Proof.
  intros X Y Z; assert (C : - b < c < 0) by lra; assert (D : - b < d < 0) by lra.
  pose proof (under_root c x C) as U; pose proof (under_root d x D) as V.
  pose proof (below_line c x C) as P; pose proof (below_line d x D) as Q.
  pose proof (above_line c x C) as M; destruct (squares x) as [S [K SK]].
  assert (0 <= a * sin x ^ 2) by weigh.
  unfold turned; rewrite !(Rmult_assoc (/ sqrt _)).
  apply Rmult_le_compat.
  - left; positive.
  - apply Rmult_le_pos; [left; positive | exact M].
  - apply Rinv_le_contravar; [now apply sqrt_lt_R0 | apply sqrt_le_1_alt].
    assert (0 <= (d - c) * (b + a * sin x ^ 2)) by weigh; lra.
  - apply (Rmult_le_reg_l (a + b * sin x ^ 2 + (-1) * c * cos x ^ 2)); [exact P |].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
    apply (Rmult_le_reg_l (a + b * sin x ^ 2 + (-1) * d * cos x ^ 2)); [exact Q |].
    match goal with |- ?l <= ?q * (?p * (/ ?q * ?n)) =>
      replace (q * (p * (/ q * n))) with (p * n) by (field; lra) end.
    assert (0 <= (d - c) * (a + b) * (a + b) * sin x ^ 2).
    { weigh. }
    replace (cos x ^ 2) with (1 - sin x ^ 2) in * by lra; set (s := sin x ^ 2) in *; lra.
Qed.
Lemma slope_near c x : - b < c < 0 -> continuity_2d_pt (turned_slope a b) c x.
Proof.
  intros C; pose proof (under_root c x C) as U; pose proof (below_line c x C) as P.
  assert (0 < sqrt ((-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2)) by now apply sqrt_lt_R0.
  unfold turned_slope; continues_2d; try apply pow_nonzero; lra.
Qed.
Lemma turned_by_level c x : - b < c < 0 ->
  is_derive (fun g : R => turned a b g x) c (turned_slope a b c x).
Proof.
  intros C; pose proof (under_root c x C) as U; pose proof (below_line c x C) as P.
  assert (0 < sqrt ((-1) * c * (b + a * sin x ^ 2) + a * b * cos x ^ 2)) by now apply sqrt_lt_R0.
  unfold turned, turned_slope; eapply d_eq; [derive; lra |]; tidy; field; lra.
Qed.

(* Where the motion has come to, and how that and its precession grow with the level. *)
Variable e : R.
Hypotheses (E : 0 < e) (F : e < 1 / 2 * PI).
Lemma share_between c : - b * sin e ^ 2 < c < 0 -> - b < c < 0 /\ 0 < share_turned a b e c < 1
  /\ 0 < b * / (a + b * sin e ^ 2) * / (c + b * cos e ^ 2 + b * sin e ^ 2) * (a + (-1) * c).
Proof.
  intros [X Y]; destruct (squares e) as [S [K SK]].
  assert (0 < cos e) by (apply cos_gt_0; lra); assert (0 < cos e ^ 2) by (apply pow_lt; lra).
  assert (0 <= b * sin e ^ 2) by weigh.
  assert (0 < b * cos e ^ 2) by (apply Rmult_lt_0_compat; lra).
  assert (b * cos e ^ 2 + b * sin e ^ 2 = b) by (rewrite <- Rmult_plus_distr_l, (Rplus_comm (cos e ^ 2)), SK; ring).
  assert (- b < c) by lra; assert (P : 0 < c + b * cos e ^ 2 + b * sin e ^ 2) by lra.
  assert (Q : 0 < b * / (a + b * sin e ^ 2) * / (c + b * cos e ^ 2 + b * sin e ^ 2) * (a + (-1) * c)).
  { apply Rmult_lt_0_compat; [| lra]; apply Rmult_lt_0_compat; [| apply Rinv_0_lt_compat; lra].
    apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]. }
  split; [lra |]; split; [| exact Q]; unfold share_turned; rewrite Rabs_pos_eq by lra; split.
  - apply Rmult_lt_0_compat; [now apply sqrt_lt_R0 | lra].
  - match type of Q with 0 < ?q => assert (W : q * cos e ^ 2 < 1); [| set (p := q) in *] end.
    { apply (Rmult_lt_reg_l ((a + b * sin e ^ 2) * (c + b * cos e ^ 2 + b * sin e ^ 2))).
      { apply Rmult_lt_0_compat; lra. }
      match goal with |- ?l < _ => replace l with (b * (a + (-1) * c) * cos e ^ 2) by (field; lra) end.
      assert (0 < (a + b) * (c + b * sin e ^ 2)) by (apply Rmult_lt_0_compat; lra).
      replace (cos e ^ 2) with (1 - sin e ^ 2) in * by lra; set (s := sin e ^ 2) in *; lra. }
    pose proof (sqrt_lt_R0 p Q); pose proof (sqrt_sqrt p ltac:(lra)).
    assert (0 < sqrt p * cos e) by (apply Rmult_lt_0_compat; lra).
    assert ((sqrt p * cos e) * (sqrt p * cos e) < 1).
    { replace ((sqrt p * cos e) * (sqrt p * cos e)) with (sqrt p * sqrt p * cos e ^ 2) by ring.
      replace (sqrt p * sqrt p) with p; exact W. }
    nra.
Qed.
Lemma end_between c : - b * sin e ^ 2 < c < 0 -> 1 / 2 * PI < end_turned a b e c < PI.
Proof.
  intros C; destruct (share_between c C) as [_ [[S T] _]]; unfold end_turned.
  pose proof (asin_rises 0 (share_turned a b e c) ltac:(lra) S ltac:(lra)) as U; rewrite asin_0 in U.
  pose proof (asin_rises (share_turned a b e c) 1 ltac:(lra) T ltac:(lra)) as V; rewrite asin_1 in V; lra.
Qed.
Lemma end_rises c d : - b * sin e ^ 2 < c -> c < d -> d < 0 -> end_turned a b e c < end_turned a b e d.
Proof.
  intros X Y Z; destruct (share_between c ltac:(lra)) as [C1 [C2 C3]].
  destruct (share_between d ltac:(lra)) as [D1 [D2 D3]]; destruct (squares e) as [S [K SK]].
  assert (0 <= b * sin e ^ 2) by weigh.
  unfold end_turned; apply Rplus_lt_compat_l, Rmult_lt_gt_compat_neg_l; [lra |].
  apply asin_rises; [lra | | lra]; unfold share_turned.
  apply Rmult_lt_compat_r; [apply Rabs_pos_lt, Rgt_not_eq, cos_gt_0; lra |].
  apply sqrt_lt_1_alt; split; [lra |].
  assert (0 < cos e ^ 2) by (apply pow_lt, cos_gt_0; lra).
  assert (0 < b * cos e ^ 2) by (apply Rmult_lt_0_compat; lra).
  assert (0 < / (a + b * sin e ^ 2)) by (apply Rinv_0_lt_compat; lra).
  assert (0 < b * / (a + b * sin e ^ 2)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < / (d + b * cos e ^ 2 + b * sin e ^ 2)) by (apply Rinv_0_lt_compat; lra).
  apply Rmult_le_0_lt_compat; [apply Rmult_le_pos; lra | lra | | lra].
  apply Rmult_lt_compat_l; [lra |]; apply Rinv_lt_contravar; [apply Rmult_lt_0_compat |]; lra.
Qed.
Lemma half_turn_rises c d : - b * sin e ^ 2 < c -> c < d -> d < 0 ->
  RInt (turned a b c) 0 (end_turned a b e c) < RInt (turned a b d) 0 (end_turned a b e d).
Proof.
  intros X Y Z; destruct (share_between c ltac:(lra)) as [C _]; destruct (share_between d ltac:(lra)) as [D _].
  pose proof (end_between c ltac:(lra)); pose proof (end_between d ltac:(lra)).
  pose proof (end_rises c d X Y Z) as M.
  assert (K : forall g p q, - b < g < 0 -> continuous_on (turned a b g) p q).
  { intros g p q G x _; now apply turned_continuous. }
  apply (Rle_lt_trans _ (RInt (turned a b d) 0 (end_turned a b e c))).
  - apply integral_le; try (apply K; assumption); [lra |]; intros x _; apply turned_rises; lra.
  - rewrite (integral_cut (turned a b d) 0 (end_turned a b e c) (end_turned a b e d)) by (apply K; assumption).
    enough (0 < RInt (turned a b d) (end_turned a b e c) (end_turned a b e d)) by lra.
    apply integral_positive; [exact M | apply K; assumption |]; intros x W.
    apply turned_positive; [exact D | apply sin_gt_0; lra].
Qed.
Lemma half_turn_continuous c : - b * sin e ^ 2 < c < 0 ->
  continuous (fun g : R => RInt (turned a b g) 0 (end_turned a b e g)) c.
Proof.
  intros C; destruct (share_between c C) as [P [[S T] Q]]; pose proof (end_between c C).
  destruct (squares e) as [S2 [K SK]].
  assert (0 < cos e ^ 2) by (apply pow_lt, cos_gt_0; lra).
  assert (0 <= b * sin e ^ 2) by weigh.
  assert (0 < b * cos e ^ 2) by (apply Rmult_lt_0_compat; lra).
  assert (W : exists v, is_derive (end_turned a b e) c v).
  { unfold end_turned, share_turned in *; eexists; derive; lra. }
  destruct W as [v V].
  eapply continuous_derive, (leibniz_ends (turned a b) (turned_slope a b) (fun _ => 0) (end_turned a b e)
    0 v c (- b) 0 (-1) (PI + 1)); try lra.
  - apply d_const.
  - exact V.
  - intros; now apply turned_by_level.
  - intros; now apply slope_near.
  - intros; now apply turned_continuous.
Qed.
Lemma turned_level l u : - b * sin e ^ 2 < l -> l <= u -> u < 0 ->
  RInt (turned a b l) 0 (end_turned a b e l) < PI < RInt (turned a b u) 0 (end_turned a b e u) ->
  exists c, l <= c <= u
    /\ is_root (fun c => RInt (turned a b c) 0 (end_turned a b e c) + (-1) * PI) ((-1) * b * sin e ^ 2) 0 c.
Proof.
  intros X Y Z [U V].
  destruct (root_exists (fun c => RInt (turned a b c) 0 (end_turned a b e c) + (-1) * PI) l u) as [c [C R]];
    [lra | | nra |].
  - intros g G; apply (continuous_plus (fun c => RInt (turned a b c) 0 (end_turned a b e c)) (fun _ => (-1) * PI));
      [apply half_turn_continuous; lra | apply continuous_const].
  - exists c; split; [exact C |]; split; [split; [lra | exact R] |]; intros y W M.
    destruct (Rtotal_order y c) as [N|[N|N]]; [exfalso | exact N | exfalso].
    + pose proof (half_turn_rises y c ltac:(lra) N ltac:(lra)); lra.
    + pose proof (half_turn_rises c y ltac:(lra) N ltac:(lra)); lra.
Qed.
End Turned.

(* The defect of a shape with a b >= 1/4: how small it is for each ratio b/a. *)
Section Defect.
Variables a b e : R.
Hypotheses (A : a > 0) (B : b > 0) (P : e > 0) (Q : e < 1 / 2 * PI).
Hypothesis D : tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Let r := b * / a.
Let k := sqrt (a * b).
Let p := PI + asin (sqrt (b * / (a + b)) * cos e).

Lemma defect_signs : 0 < sin e /\ 0 < cos e /\ 0 < r /\ 0 < k /\ k * sqrt r = b /\ k ^ 2 = a * b.
Proof.
  unfold r, k; repeat split; try positive.
  - apply sin_gt_0; lra.
  - apply cos_gt_0; lra.
  - apply product_root; lra.
  - apply pow2_sqrt; left; positive.
Qed.
Lemma defect_turn : PI < p < 3 / 2 * PI.
Proof.
  destruct defect_signs as [S [C _]]; pose proof (share_below a b e A B) as H; unfold p.
  assert (M : 0 < sqrt (b * / (a + b)) * cos e) by (apply Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | exact C]).
  pose proof (asin_above _ M); pose proof (asin_rises (sqrt (b * / (a + b)) * cos e) 1 ltac:(lra) (proj2 H) ltac:(lra)) as U.
  rewrite asin_1 in U; lra.
Qed.
Lemma defect_angle : e = atan (/ (sqrt (r + 1) * sinh (k * p))).
Proof.
  destruct defect_signs as [S [C [R0 [K0 _]]]]; pose proof defect_turn as T; pose proof PI_RGT_0.
  unfold r, k, p in *; rewrite (sinh_at_root a b _ e A B S C D).
  assert (0 < sqrt (b * / a + 1)) by (apply sqrt_lt_R0; lra).
  replace (sqrt (b * / a + 1) * (/ sqrt (b * / a + 1) * / sin e * cos e)) with (cos e * / sin e) by (field; lra).
  rewrite Rinv_mult, Rinv_inv, Rmult_comm; symmetry; apply (atan_tan e); lra.
Qed.
Lemma defect_by_exp : e <= 2 * exp (- (PI * k)).
Proof.
  destruct defect_signs as [S [C [R0 [K0 _]]]]; pose proof defect_turn as T; pose proof PI_RGT_0 as J.
  assert (X : 0 < PI * k) by positive; assert (Y : 0 < sinh (PI * k)) by (apply sinh_pos; exact X).
  assert (Z : sinh (PI * k) < sinh (k * p)) by (apply sinh_rises; nra).
  assert (W : 1 <= sqrt (r + 1)) by (apply below_sqrt; lra).
  apply Rle_trans with (atan (/ sinh (PI * k))).
  { rewrite defect_angle; apply arctangent_rises, Rinv_le_contravar; [exact Y | nra]. }
  pose proof (exp_pos (- (PI * k))) as V; set (x := exp (- (PI * k))) in *.
  assert (V1 : x < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
  assert (E : exp (PI * k) = / x) by (unfold x; rewrite exp_Ropp, Rinv_inv; reflexivity).
  assert (AX : atan x <= x).
  { enough (0 <= x - atan x) by lra.
    apply (from_left_ge (fun t : R => t - atan t) (fun t : R => t * t * / (1 + t * t)) 0 x); try lra.
    - intros t _; eapply d_eq; [derive |]; cbv beta; field; nra.
    - intros t _; apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra].
    - rewrite atan_0; lra. }
  replace (atan (/ sinh (PI * k))) with (2 * atan x); [lra |].
  symmetry; apply atan_unique.
  - pose proof (atan_above x V); pose proof (atan_increasing x 1 V1) as M; rewrite atan_1 in M; lra.
  - assert (G : 0 < 1 + x ^ 2) by nra; assert (W2 : 0 < sqrt (1 + x ^ 2)) by now apply sqrt_lt_R0.
    assert (W3 : sqrt (1 + x ^ 2) ^ 2 = 1 + x ^ 2) by (apply pow2_sqrt; lra).
    destruct (turn_atan x _ W2 W3) as [SX CX]; rewrite sin_2a, cos_2a, SX, CX.
    assert (Hsh : sinh (PI * k) = (1 - x ^ 2) / (2 * x)) by (unfold sinh; fold x; rewrite E; field; lra).
    rewrite Hsh; set (w := sqrt (1 + x ^ 2)) in *; field; nra.
Qed.
Hypotheses (B1 : b <= 1) (AB : a * b >= 1 / 4).
Lemma defect_shape : 1 / 2 <= k /\ r <= 4 /\ r <= 4 * b ^ 2.
Proof.
  assert (0 < / a) by positive; assert (I : a * / a = 1) by (field; lra); unfold k, r; repeat split.
  - apply below_sqrt; lra.
  - apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, (Rmult_comm (/ a)), I; nra.
  - apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, (Rmult_comm (/ a)), I; nra.
Qed.
Lemma defect_step l M : 0 <= l -> l <= r -> e <= M -> M <= PI / 2 ->
  e <= atan (/ (sqrt (l + 1) * sinh ((PI + asin (sqrt (l * / (l + 1)) * cos M)) / 2))).
Proof.
  destruct defect_signs as [S [C [R0 [K0 _]]]]; destruct defect_shape as [K [R4 _]].
  intros L LR EM M1; pose proof defect_turn as Z; pose proof PI_RGT_0 as J.
  assert (V : 0 <= l * / (l + 1) <= b * / (a + b)).
  { replace (b * / (a + b)) with (r * / (r + 1)) by (unfold r; field; lra).
    assert (0 < / (l + 1)) by positive; split; [nra |].
    apply (Rmult_le_reg_r ((l + 1) * (r + 1))); [nra |].
    replace (l * / (l + 1) * ((l + 1) * (r + 1))) with (l * (r + 1)) by (field; lra).
    replace (r * / (r + 1) * ((l + 1) * (r + 1))) with (r * (l + 1)) by (field; lra); nra. }
  assert (G : 0 <= cos M <= cos e) by (split; [apply cos_ge_0; lra | apply cos_decr_1; lra]).
  pose proof (share_below a b e A B) as [_ S1].
  assert (X : sqrt (l * / (l + 1)) * cos M <= sqrt (b * / (a + b)) * cos e).
  { apply Rmult_le_compat; [apply sqrt_pos | lra | apply sqrt_le_1_alt, V | lra]. }
  assert (X0 : 0 <= sqrt (l * / (l + 1)) * cos M) by (pose proof (sqrt_pos (l * / (l + 1))); nra).
  assert (T : asin (sqrt (l * / (l + 1)) * cos M) <= asin (sqrt (b * / (a + b)) * cos e)).
  { destruct X as [X|X]; [left; apply asin_rises; lra | rewrite X; lra]. }
  assert (T0 : 0 <= asin (sqrt (l * / (l + 1)) * cos M)).
  { destruct X0 as [X0|X0]; [left; apply asin_above; exact X0 | rewrite <- X0, asin_0; lra]. }
  rewrite defect_angle at 1; apply arctangent_rises; apply Rinv_le_contravar.
  - apply Rmult_lt_0_compat; [apply sqrt_lt_R0; lra | apply sinh_pos; lra].
  - apply Rmult_le_compat; [apply sqrt_pos | left; apply sinh_pos; lra | apply sqrt_le_1_alt; lra |].
    apply sinh_grows; assert (PI + asin (sqrt (l * / (l + 1)) * cos M) <= p) by (unfold p; lra).
    apply Rle_trans with (p / 2); [lra | nra].
Qed.
Lemma defect_boxes :
  (0 < r <= 1 /\ e <= 42 / 100) \/ (1 <= r <= 2 /\ e <= 213 / 1000) \/ (2 <= r <= 3 /\ e <= 164 / 1000)
  \/ (3 <= r <= 35 / 10 /\ e <= 138 / 1000) \/ (35 / 10 <= r <= 39 / 10 /\ e <= 1165 / 10000)
  \/ (39 / 10 <= r <= 399 / 100 /\ e <= 1102 / 10000) \/ (399 / 100 <= r <= 4 /\ e <= 1089 / 10000).
Proof.
  destruct defect_signs as [_ [_ [R0 _]]]; destruct defect_shape as [_ [R4 _]]; pose proof PI_RGT_0 as PP.
  pose proof pi_between as PB.
  assert (E0 : e <= 42 / 100) by sharper defect_step 0 (PI / 2).
  destruct (Rle_or_lt (399 / 100) r) as [L|L]; [| destruct (Rle_or_lt (39 / 10) r) as [L'|L'];
    [| destruct (Rle_or_lt (35 / 10) r) as [M|M]; [| destruct (Rle_or_lt 3 r) as [M'|M'];
    [| destruct (Rle_or_lt 2 r) as [O|O]; [| destruct (Rle_or_lt 1 r) as [O'|O']]]]]].
  - assert (e <= 121 / 1000) by sharper defect_step (399 / 100) (42 / 100).
    assert (e <= 1091 / 10000) by sharper defect_step (399 / 100) (121 / 1000).
    assert (e <= 1089 / 10000) by sharper defect_step (399 / 100) (1091 / 10000).
    do 6 right; split; lra.
  - assert (e <= 122 / 1000) by sharper defect_step (39 / 10) (42 / 100).
    assert (e <= 1104 / 10000) by sharper defect_step (39 / 10) (122 / 1000).
    assert (e <= 1102 / 10000) by sharper defect_step (39 / 10) (1104 / 10000).
    do 5 right; left; split; lra.
  - assert (e <= 129 / 1000) by sharper defect_step (35 / 10) (42 / 100).
    assert (e <= 1165 / 10000) by sharper defect_step (35 / 10) (129 / 1000).
    do 4 right; left; split; lra.
  - assert (e <= 138 / 1000) by sharper defect_step 3 (42 / 100).
    do 3 right; left; split; lra.
  - assert (e <= 164 / 1000) by sharper defect_step 2 (42 / 100).
    do 2 right; left; split; lra.
  - assert (e <= 213 / 1000) by sharper defect_step 1 (42 / 100).
    right; left; split; lra.
  - left; split; lra.
Qed.
End Defect.

(* The ratio of such a defect to its leading term, from both sides. *)
Lemma turn_from_top a b : 0 < a -> 0 < b -> asin (sqrt (b * / (a + b))) = atan (sqrt (b * / a)).
Proof.
  intros A B; pose proof (turn_of_share a b 0 A B) as H; rewrite sin_0, cos_0, Rmult_1_r in H; rewrite H.
  f_equal; replace (b * / a * 0 ^ 2 + 1) with 1 by (field; lra); rewrite sqrt_1; field.
Qed.
Lemma asin_least y : 0 <= y -> y <= 1 -> y <= asin y.
Proof.
  intros [Y|Y] Z; [| subst; rewrite asin_0; lra]; pose proof (asin_above y Y).
  rewrite <- (sin_asin y) at 1 by lra; left; now apply sin_lt_x.
Qed.
Section AtLeast.
Variables b r k e : R.
Hypotheses (B0 : 0 < b) (B1 : b <= 1) (R0 : 0 < r) (R4 : r <= 4) (K : 0 < k) (KR : k * sqrt r = b).
Hypotheses (E0 : 0 < e) (E1 : e <= 42 / 100).
Let w := sqrt (r * sin e ^ 2 + 1).
Lemma ratio_above : (1 + b * sin e ^ 2 / (w + cos e)) * (1 + e ^ 2 / 6) * (1 / 2 * w + 1 / 2 * cos e)
  <= exp (k * asin (sqrt r * / (w + cos e) * sin e ^ 2) + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e)).
Proof.
  destruct (sine_square_between e E0 E1) as [[A1 B2] [C D]].
  destruct (sum_between b r k e B0 B1 R0 R4 KR E0 E1) as [F [G [L W]]]; fold w in F, G, W.
  destruct (small_sine e) as [[SA SB] [SC SD]]; try lra.
  assert (Cs : 0 < cos e) by nra; assert (J : 0 < / (w + cos e)) by positive.
  assert (q0 : 0 < sqrt r) by (apply sqrt_lt_R0; lra).
  set (y := sqrt r * / (w + cos e) * sin e ^ 2).
  assert (Y0 : 0 <= y) by (unfold y; left; positive).
  assert (Y1 : y <= 1).
  { unfold y; assert (sqrt r * sin e <= w).
    { apply below_sqrt; rewrite Rpow_mult_distr, pow2_sqrt; lra. }
    assert (sqrt r * sin e * sin e <= w * 1) by (apply Rmult_le_compat; try lra; nra).
    apply (Rmult_le_reg_r (w + cos e)); [lra |].
    replace (sqrt r * / (w + cos e) * sin e ^ 2 * (w + cos e)) with (sqrt r * sin e * sin e) by (field; lra); lra. }
  rewrite !exp_plus, !exp_ln by (first [lra | positive]).
  assert (M1 : 0 <= b * sin e ^ 2 / (w + cos e)) by (unfold Rdiv; left; positive).
  assert (V : 1 + e ^ 2 / 6 <= e * / sin e).
  { apply (Rmult_le_reg_r (sin e)); [lra |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rle_trans with ((1 + e ^ 2 / 6) * (e * (1 - e ^ 2 / 6 + e ^ 4 / 120))); [nra |].
    enough (0 <= e * e ^ 4 * (1 / 36 - 1 / 120 - e ^ 2 / 720)) by nra.
    assert (0 <= e ^ 4) by (apply pow_le; lra); apply Rmult_le_pos; [apply Rmult_le_pos; lra | nra]. }
  assert (X : 1 + b * sin e ^ 2 / (w + cos e) <= exp (k * asin y)).
  { eapply Rle_trans; [| apply exp_ineq1_le]; pose proof (asin_least y Y0 Y1).
    replace (b * sin e ^ 2 / (w + cos e)) with (k * y) by (unfold y; rewrite <- KR; field; lra); nra. }
  apply Rmult_le_compat_r; [lra |]; assert (0 <= e ^ 2) by nra; apply Rmult_le_compat; lra.
Qed.
End AtLeast.
(* The logarithm of a number a little above one. *)
Lemma ln_near z : 0 <= z -> ln (1 + z) <= z - z ^ 2 / 2 + z ^ 3 / 3.
Proof.
  intros Z; enough (0 <= z - z ^ 2 / 2 + z ^ 3 / 3 - ln (1 + z)) by lra.
  apply (from_left_ge (fun t : R => t - t ^ 2 / 2 + t ^ 3 / 3 - ln (1 + t)) (fun t : R => t ^ 3 * / (1 + t)) 0 z); try lra.
  - intros t T; eapply d_eq; [derive; lra |]; tidy; field; lra.
  - intros t T; apply Rmult_le_pos; [apply pow_le; lra | left; apply Rinv_0_lt_compat; lra].
  - rewrite Rplus_0_r, ln_1; lra.
Qed.
(* An inequality between the ratio of the moments and the square of the defect, on a box of them. *)
Ltac boxed r e m :=
  let u := fresh "u" in assert (0 <= e ^ 2 <= m ^ 2) by nra; set (u := e ^ 2) in *; clearbody u;
  unfold up_all, up_exp, up_turn, low_sum, up_root, up_sine, up_time;
  interval with (i_bisect u, i_bisect r, i_depth 30).

(* The unfolded motion: how fast the precession goes, and how that grows with the level. *)
Section Unfolded.
Variables a b : R.
Hypotheses (A : 0 < a) (B : 0 < b) (B1 : b <= 1).
Definition u_root (g x : R) : R := (-1) * g * (b + a * sin x ^ 2) + a * b * cos x ^ 2.
Definition u_under (g x : R) : R := a + b * sin x ^ 2 + (-1) * g * cos x ^ 2.
Definition u_over (g x : R) : R := cos x ^ 2 * ((-1) * b + 1) * (a + (-1) * g) + sin x ^ 2 * (g + 1) * (a + b).
Definition u_rate (g x : R) : R := / (sqrt (u_root g x)) * / (u_under g x) * u_over g x.
Definition u_growth (g x : R) : R :=
  / sqrt (u_root g x) * / u_under g x * / u_under g x * (sin x ^ 2 * (a + b) ^ 2)
  + / 2 * (/ sqrt (u_root g x) * / sqrt (u_root g x) * / sqrt (u_root g x)) * (b + a * sin x ^ 2)
    * / u_under g x * u_over g x.
Lemma u_root_above g x : g < 0 -> 0 < u_root g x.
Proof.
  intros G; unfold u_root; assert (0 <= a * b * cos x ^ 2) by (apply Rmult_le_pos; [left; positive | apply pow2_ge_0]).
  assert (0 < (-1) * g * (b + a * sin x ^ 2)); [| lra].
  apply Rmult_lt_0_compat; [lra |]; pose proof (pow2_ge_0 (sin x)); nra.
Qed.
Lemma u_under_above g x : g < 0 -> 0 < u_under g x.
Proof.
  intros G; unfold u_under; pose proof (pow2_ge_0 (sin x)); pose proof (pow2_ge_0 (cos x)).
  assert (0 <= b * sin x ^ 2) by (apply Rmult_le_pos; lra).
  assert (0 <= (-1) * g * cos x ^ 2) by (apply Rmult_le_pos; lra); lra.
Qed.
Lemma u_over_least g x : g < 0 -> - b < g -> 0 <= u_over g x.
Proof.
  intros G L; unfold u_over; apply Rplus_le_le_0_compat.
  - apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0 | lra] | lra].
  - apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0 | lra] | lra].
Qed.
Lemma u_over_above g x : g < 0 -> - b < g -> b < 1 \/ 0 < sin x -> 0 < u_over g x.
Proof.
  intros G L [H|H]; unfold u_over.
  - assert (C : sin x ^ 2 + cos x ^ 2 = 1) by (pose proof (sin_square x); lra).
    pose proof (pow2_ge_0 (sin x)); pose proof (pow2_ge_0 (cos x)).
    assert (0 < ((-1) * b + 1) * (a + (-1) * g)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < (g + 1) * (a + b)) by (apply Rmult_lt_0_compat; lra).
    rewrite !Rmult_assoc; destruct (Req_dec (sin x ^ 2) 0) as [Z|Z].
    + rewrite Z in *; replace (cos x ^ 2) with 1 by lra; lra.
    + apply Rplus_le_lt_0_compat; [apply Rmult_le_pos; lra | apply Rmult_lt_0_compat; lra].
  - apply Rplus_le_lt_0_compat.
    + apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0 | lra] | lra].
    + apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt; lra | lra] | lra].
Qed.
Lemma u_rate_continuous g x : g < 0 -> continuous (u_rate g) x.
Proof.
  intros G; pose proof (u_root_above g x G) as P; pose proof (u_under_above g x G) as Q.
  assert (sqrt (u_root g x) <> 0) by (apply Rgt_not_eq, sqrt_lt_R0, P).
  assert (u_under g x <> 0) by (apply Rgt_not_eq, Q).
  unfold u_rate, u_root, u_under, u_over in *; continues; assumption.
Qed.
Lemma u_rate_by_level g x : g < 0 -> is_derive (fun c : R => u_rate c x) g (u_growth g x).
Proof.
  intros G; pose proof (u_root_above g x G) as P; pose proof (u_under_above g x G) as Q.
  assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  unfold u_rate, u_growth in *; eapply d_eq.
  - unfold u_root, u_under, u_over in *; derive; cbv beta; first [assumption | apply Rgt_not_eq; assumption].
  - cbv beta; fold (u_root g x); fold (u_under g x); fold (u_over g x).
    assert (E : sqrt (u_root g x) ^ 2 = u_root g x) by (apply pow2_sqrt; lra).
    set (s := sqrt (u_root g x)) in *.
    assert (K : cos x ^ 2 * u_over g x + u_under g x * (cos x ^ 2 * ((-1) * b + 1) * (-1) + sin x ^ 2 * (a + b)) = sin x ^ 2 * (a + b) ^ 2).
    { unfold u_over, u_under; rewrite (sin_square x); ring. }
    rewrite <- K; field; repeat split; lra.
Qed.
Lemma u_growth_continuous g x : g < 0 -> continuity_2d_pt u_growth g x.
Proof.
  intros G; pose proof (u_root_above g x G) as P; pose proof (u_under_above g x G) as Q.
  assert (sqrt (u_root g x) <> 0) by (apply Rgt_not_eq, sqrt_lt_R0, P).
  assert (u_under g x <> 0) by (apply Rgt_not_eq, Q).
  unfold u_growth, u_root, u_under, u_over in *; continues_2d; assumption.
Qed.
Lemma u_phase_by_level g y : - b < g -> g < 0 ->
  is_derive (fun c : R => RInt (u_rate c) 0 y) g (RInt (u_growth g) 0 y).
Proof.
  intros L G; apply (leibniz u_rate u_growth 0 y g (- b) 0); [lra | | |].
  - intros q t Q _; apply u_rate_by_level; lra.
  - intros t _; now apply u_growth_continuous.
  - intros q Q t _; apply u_rate_continuous; lra.
Qed.
Lemma u_growth_above g x : - b < g -> g < 0 -> 0 < sin x -> 0 < u_growth g x.
Proof.
  intros L G X; pose proof (u_root_above g x G) as P; pose proof (u_under_above g x G) as Q.
  assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  pose proof (u_over_above g x G L (or_intror X)); assert (0 < a + b) by lra.
  assert (0 < b + a * sin x ^ 2) by (pose proof (pow2_ge_0 (sin x)); nra).
  unfold u_growth; apply Rplus_lt_0_compat; positive.
Qed.
Lemma u_phase_rises g y : - b < g -> g < 0 -> 0 < y -> y < PI -> 0 < RInt (u_growth g) 0 y.
Proof.
  intros L G Y T; apply integral_positive; [exact Y | |].
  - intros x X.
    assert (C := u_growth_continuous g x G).
    intros V HV; destruct HV as [e He]; destruct (C e) as [d D]; exists d; intros z Z; apply He.
    apply (D g z); [rewrite Rminus_eq_0, Rabs_R0; apply cond_pos | exact Z].
  - intros x X; apply u_growth_above; trivial; apply sin_gt_0; lra.
Qed.
Lemma u_phase_by_end g y : g < 0 -> is_derive (fun t : R => RInt (u_rate g) 0 t) y (u_rate g y).
Proof.
  intros G; apply (d_upper_end (u_rate g) 0 (Rmin 0 y - 1) (Rmax 0 y + 1)); try lra.
  intros t _; now apply u_rate_continuous.
Qed.
Lemma u_rate_above g x : - b < g -> g < 0 -> b < 1 \/ 0 < sin x -> 0 < u_rate g x.
Proof.
  intros L G H; pose proof (u_root_above g x G) as P; pose proof (u_under_above g x G) as Q.
  assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  pose proof (u_over_above g x G L H); unfold u_rate; positive.
Qed.
Lemma u_phase_once g x y : - b < g -> g < 0 -> b < 1 -> RInt (u_rate g) 0 x = RInt (u_rate g) 0 y -> x = y.
Proof.
  intros L G H E.
  assert (C : forall p q, continuous_on (u_rate g) p q) by (intros p q t _; now apply u_rate_continuous).
  assert (K : forall p q, p < q -> RInt (u_rate g) 0 p < RInt (u_rate g) 0 q).
  { intros p q Q; rewrite (integral_cut (u_rate g) 0 p q) by apply C.
    pose proof (integral_positive (u_rate g) p q Q (C p q)) as I.
    specialize (I ltac:(intros t _; apply u_rate_above; trivial; now left)); lra. }
  destruct (Rtotal_order x y) as [T|[T|T]]; [apply K in T | exact T | apply K in T]; lra.
Qed.
Definition u_share (g x : R) : R := sqrt (a + b) * sqrt (b + g) * / (sqrt (u_root g x)) * sin x.
Definition u_angle (g x : R) : R := (1 / 2) * PI + (-1) * atan (u_share g x).
Definition u_inner (g x : R) : R := / (1 + u_share g x * u_share g x) * sqrt (a + b).
Lemma u_inner_above g x : 0 < u_inner g x.
Proof.
  unfold u_inner; pose proof (Rle_0_sqr (u_share g x)) as J; unfold Rsqr in J.
  apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat | apply sqrt_lt_R0]; lra.
Qed.
Lemma u_angle_by_end g x : - b < g -> g < 0 -> is_derive (fun t : R => u_angle g t) x
  (- (u_inner g x * (sqrt (b + g) * (b * (a - g)) * (/ sqrt (u_root g x) * / sqrt (u_root g x) * / sqrt (u_root g x)))) * cos x).
Proof.
  intros L G; pose proof (u_root_above g x G) as P; assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  unfold u_angle, u_inner; eapply d_eq.
  - unfold u_share, u_root in *; derive; cbv beta; first [assumption | apply Rgt_not_eq; assumption].
  - cbv beta; fold (u_root g x); fold (u_share g x).
    assert (E : sqrt (u_root g x) ^ 2 = u_root g x) by (apply pow2_sqrt; lra).
    pose proof (Rle_0_sqr (u_share g x)) as J; unfold Rsqr in J.
    set (u := u_share g x) in *; set (s := sqrt (u_root g x)) in *.
    assert (K : s ^ 2 + sin x ^ 2 * (g * a + a * b) = b * (a - g)).
    { rewrite E; unfold u_root; rewrite (sin_square x); ring. }
    rewrite <- K; clearbody u s; tidy; field; repeat split; lra.
Qed.
Lemma u_angle_by_level g x : - b < g -> g < 0 -> is_derive (fun c : R => u_angle c x) g
  (- (u_inner g x * (/ (2 * sqrt (b + g)) * / sqrt (u_root g x) + sqrt (b + g) * (b + a * sin x ^ 2)
    * / 2 * (/ sqrt (u_root g x) * / sqrt (u_root g x) * / sqrt (u_root g x)))) * sin x).
Proof.
  intros L G; pose proof (u_root_above g x G) as P; assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  assert (T : 0 < sqrt (b + g)) by (apply sqrt_lt_R0; lra); assert (0 < b + g) by lra.
  unfold u_angle, u_inner; eapply d_eq.
  - unfold u_share, u_root in *; derive; cbv beta; first [assumption | apply Rgt_not_eq; assumption].
  - cbv beta; fold (u_root g x); fold (u_share g x).
    pose proof (Rle_0_sqr (u_share g x)) as J; unfold Rsqr in J.
    set (u := u_share g x) in *; set (s := sqrt (u_root g x)) in *; clearbody u s; field; repeat split; lra.
Qed.
Lemma u_level_above g x : - b < g -> g < 0 ->
  0 < u_inner g x * (/ (2 * sqrt (b + g)) * / sqrt (u_root g x) + sqrt (b + g) * (b + a * sin x ^ 2)
    * / 2 * (/ sqrt (u_root g x) * / sqrt (u_root g x) * / sqrt (u_root g x))).
Proof.
  intros L G; pose proof (u_root_above g x G) as P; pose proof (u_inner_above g x).
  assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  assert (T : 0 < sqrt (b + g)) by (apply sqrt_lt_R0; lra).
  assert (0 < b + a * sin x ^ 2) by (pose proof (pow2_ge_0 (sin x)); nra).
  positive.
Qed.
Lemma u_end_above g x : - b < g -> g < 0 ->
  0 < u_inner g x * (sqrt (b + g) * (b * (a - g)) * (/ sqrt (u_root g x) * / sqrt (u_root g x) * / sqrt (u_root g x))).
Proof.
  intros L G; pose proof (u_root_above g x G) as P; pose proof (u_inner_above g x).
  assert (S : 0 < sqrt (u_root g x)) by (apply sqrt_lt_R0, P).
  assert (T : 0 < sqrt (b + g)) by (apply sqrt_lt_R0; lra); assert (0 < a - g) by lra.
  positive.
Qed.
End Unfolded.
(* The equation of a half turn near a point of it, solved for its start, its value and its end. *)
Lemma turn_solution (F : R -> R -> R) (s a b g p u v e q v1 v2 : R) (away : R -> R) :
  a > 0 -> b > 0 -> (forall c t, F c t = rate s a b c t) -> p < g -> u < e < v -> u < q < v ->
  (forall c t, p < c -> u < t < v -> 0 < c + b * sin t ^ 2) -> 0 < s -> 0 < (-1) * b * sin e ^ 2 + 1 ->
  is_RInt (F g) e q PI -> (forall c, away c = c - g) ->
  v1 = - rate s a b g e -> v2 = RInt (rate_slope s a b g) e q ->
  (exists f : R -> R, f g = e
    /\ (exists near : R, 0 < near /\ forall x c : R, Rabs (away c) < near -> x = f c -> is_RInt (F c) x q PI)
    /\ is_derive f g ((-1) * / v1 * v2)) /\
  (forall f : R -> R, f g = e -> continuous f g ->
    (exists near : R, 0 < near /\ forall x c : R, Rabs (away c) < near -> x = f c -> is_RInt (F c) x q PI) ->
    is_derive f g ((-1) * / v1 * v2)).
Proof.
  intros A B Fs L X Y P S K Z Aw V1 V2.
  assert (R0 : 0 < rate s a b g e).
  { pose proof (reach a b A B e); specialize (P g e L X); unfold rate.
    assert (0 < sqrt (a + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
    assert (0 < sqrt (g + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption); positive. }
  assert (d0 : 0 < Rmin (g - p) (Rmin (e - u) (v - e))) by (repeat apply Rmin_pos; lra).
  assert (near : forall x c, Rabs (x - e) < Rmin (g - p) (Rmin (e - u) (v - e)) ->
    Rabs (c - g) < Rmin (g - p) (Rmin (e - u) (v - e)) -> u < x < v /\ p < c).
  { intros x c H1 H2; pose proof (Rmin_l (g - p) (Rmin (e - u) (v - e))).
    pose proof (Rmin_r (g - p) (Rmin (e - u) (v - e))); pose proof (Rmin_l (e - u) (v - e)).
    pose proof (Rmin_r (e - u) (v - e)); apply Rabs_def2 in H1; apply Rabs_def2 in H2; lra. }
  apply (implicit_equation (fun x c => RInt (rate s a b c) x q) (fun x c => - rate s a b c x) _ away e g PI
    (RInt (rate_slope s a b g) e q)).
  - exists (mkposreal _ d0); simpl; intros x c H1 H2; destruct (near x c H1 H2) as [H3 H4].
    apply (turn_by_start s a b A B c u v x q H3 Y); intros t T; now apply P.
  - apply continuity_2d_pt_opp; pose proof (reach a b A B e); specialize (P g e L X); unfold rate; continues_2d;
      apply Rgt_not_eq, sqrt_lt_R0; assumption.
  - lra.
  - exists (mkposreal _ d0); intros x H1; assert (H2 : Rabs (g - g) < Rmin (g - p) (Rmin (e - u) (v - e))).
    { rewrite Rminus_eq_0, Rabs_R0; exact d0. }
    destruct (near x g H1 H2) as [H3 _].
    exact (continuous_derive _ _ _ (turn_by_level s a b A B g p u v x q L H3 Y P)).
  - exact (turn_by_level s a b A B g p u v e q L X Y P).
  - exists (mkposreal _ d0); simpl; intros x c H1 H2; destruct (near x c H1 H2) as [H3 H4].
    assert (I : is_RInt (F c) x q (RInt (rate s a b c) x q)).
    { apply (is_RInt_ext (rate s a b c)); [intros t _; symmetry; apply Fs |].
      apply integral_correct; intros t T; apply rate_continuous; try assumption; apply P; [exact H4 |].
      revert T; unfold Rmin, Rmax; destruct (Rle_dec x q); lra. }
    split; intros H5; [| rewrite <- H5; exact I].
    rewrite <- (is_RInt_unique _ _ _ _ H5); symmetry; apply is_RInt_unique, I.
  - exact Z.
  - exact Aw.
  - rewrite V1, V2; field; lra.
Qed.
Lemma value_solution (s a b e v1 v2 : R) (away : R -> R) : a > 0 -> b > 0 -> b < 1 -> 0 < e -> e < PI / 2 -> 0 < s ->
  is_RInt (over s a b PI e) e (1 / 2 * PI) 0 -> (forall c, away c = c - PI) ->
  v1 = - zero_rate s a b e -> v2 = -1 ->
  (exists f : R -> R, f PI = e
    /\ (exists near : R, 0 < near /\ forall x c : R, Rabs (away c) < near -> x = f c ->
      is_RInt (over s a b c x) x (1 / 2 * PI) 0)
    /\ is_derive f PI ((-1) * / v1 * v2)) /\
  (forall f : R -> R, f PI = e -> continuous f PI ->
    (exists near : R, 0 < near /\ forall x c : R, Rabs (away c) < near -> x = f c ->
      is_RInt (over s a b c x) x (1 / 2 * PI) 0) ->
    is_derive f PI ((-1) * / v1 * v2)).
Proof.
  intros A B B1 E0 E1 S Z Aw V1 V2; pose proof PI_RGT_0 as J.
  assert (Sn : 0 < sin e) by (apply sin_gt_0; lra).
  assert (R0 : 0 < rate s a b 0 e).
  { pose proof (reach a b A B e); unfold rate; assert (0 < 0 + b * sin e ^ 2) by (rewrite Rplus_0_l; apply Rmult_lt_0_compat; [lra | apply pow_lt; exact Sn]).
    assert (0 < sqrt (a + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
    assert (0 < sqrt (0 + b * sin e ^ 2)) by (apply sqrt_lt_R0; assumption).
    pose proof (forward b B e B1); positive. }
  assert (d0 : 0 < Rmin e (PI / 2 - e)) by (apply Rmin_pos; lra).
  assert (near : forall x, Rabs (x - e) < Rmin e (PI / 2 - e) -> 0 < x < PI / 2).
  { intros x H1; pose proof (Rmin_l e (PI / 2 - e)); pose proof (Rmin_r e (PI / 2 - e)); apply Rabs_def2 in H1; lra. }
  apply (implicit_equation (fun x c => RInt (over s a b c x) x (1 / 2 * PI)) (fun x c => - rate s a b 0 x) _ away e PI 0 (-1)).
  - exists (mkposreal _ d0); simpl; intros x c H1 H2; destruct (near x H1) as [H3 H4].
    rewrite <- zero_rate_is by (first [assumption | apply sin_gt_0; lra]); apply over_by_end; assumption.
  - apply continuity_2d_pt_opp; pose proof (reach a b A B e); assert (0 < 0 + b * sin e ^ 2) by (rewrite Rplus_0_l; apply Rmult_lt_0_compat; [lra | apply pow_lt; exact Sn]); unfold rate; continues_2d;
      apply Rgt_not_eq, sqrt_lt_R0; assumption.
  - lra.
  - exists (mkposreal _ d0); intros x H1; destruct (near x H1) as [H3 H4].
    exact (continuous_derive _ _ _ (over_by_value s a b A B x PI H3 H4)).
  - exact (over_by_value s a b A B e PI E0 E1).
  - exists (mkposreal _ d0); simpl; intros x c H1 H2; destruct (near x H1) as [H3 H4].
    assert (I : is_RInt (over s a b c x) x (1 / 2 * PI) (RInt (over s a b c x) x (1 / 2 * PI))).
    { apply integral_correct; intros t T; unfold over; apply (continuous_plus (fun _ => (-1) * c * / (1 / 2 * PI + (-1) * x))).
      - apply continuous_const.
      - apply (zero_on s a b A B x (1 / 2 * PI)); try lra; exact T. }
    split; intros H5; [| rewrite <- H5; exact I].
    rewrite <- (is_RInt_unique _ _ _ _ H5); symmetry; apply is_RInt_unique, I.
  - exact Z.
  - exact Aw.
  - rewrite V1, V2, zero_rate_is by assumption; field; lra.
Qed.
Lemma turned_by_angle a b c x : a > 0 -> b > 0 -> b <= 1 -> - b < c < 0 ->
  is_derive (fun t : R => RInt (turned a b c) 0 t) x (turned a b c x).
Proof.
  intros A B L C; apply (d_upper_end (turned a b c) 0 (Rmin 0 x - 1) (Rmax 0 x + 1)); try lra.
  intros t _; now apply turned_continuous.
Qed.
Lemma turned_by_levels a b g x : a > 0 -> b > 0 -> b <= 1 -> - b < g < 0 ->
  is_derive (fun c : R => RInt (turned a b c) 0 x) g (RInt (turned_slope a b g) 0 x).
Proof.
  intros A B L C; apply (leibniz (turned a b) (turned_slope a b) 0 x g (- b) 0 C).
  - intros c t H _; now apply turned_by_level.
  - intros t _; now apply slope_near.
  - intros c H t _; now apply turned_continuous.
Qed.
Lemma turned_solution (a b g e v1 v2 : R) (away : R -> R) : a > 0 -> b > 0 -> b <= 1 -> - b < g < 0 -> 0 < sin e ->
  is_RInt (turned a b g) 0 e PI -> (forall c, away c = c - g) ->
  v1 = turned a b g e -> v2 = RInt (turned_slope a b g) 0 e ->
  (exists f : R -> R, f g = e
    /\ (exists near : R, 0 < near /\ forall x c : R, Rabs (away c) < near -> x = f c -> is_RInt (turned a b c) 0 x PI)
    /\ is_derive f g ((-1) * / v1 * v2)) /\
  (forall f : R -> R, f g = e -> continuous f g ->
    (exists near : R, 0 < near /\ forall x c : R, Rabs (away c) < near -> x = f c -> is_RInt (turned a b c) 0 x PI) ->
    is_derive f g ((-1) * / v1 * v2)).
Proof.
  intros A B L G S Z Aw V1 V2; pose proof (turned_positive a b A B L g e G S) as T.
  assert (d0 : 0 < Rmin (g + b) (- g)) by (apply Rmin_pos; lra).
  assert (near : forall c, Rabs (c - g) < Rmin (g + b) (- g) -> - b < c < 0).
  { intros c H2; pose proof (Rmin_l (g + b) (- g)); pose proof (Rmin_r (g + b) (- g)); apply Rabs_def2 in H2; lra. }
  apply (implicit_equation (fun x c => RInt (turned a b c) 0 x) (fun x c => turned a b c x) _ away e g PI
    (RInt (turned_slope a b g) 0 e)).
  - exists (mkposreal _ d0); simpl; intros x c _ H2; apply turned_by_angle; auto.
  - pose proof (under_root a b A B g e G) as U; pose proof (below_line a b A B g e G) as W.
    assert (0 < sqrt ((-1) * g * (b + a * sin e ^ 2) + a * b * cos e ^ 2)) by now apply sqrt_lt_R0.
    unfold turned; continues_2d; lra.
  - lra.
  - apply filter_forall; intros x; exact (continuous_derive _ _ _ (turned_by_levels a b g x A B L G)).
  - exact (turned_by_levels a b g e A B L G).
  - exists (mkposreal _ d0); simpl; intros x c _ H2; specialize (near c H2).
    assert (I : is_RInt (turned a b c) 0 x (RInt (turned a b c) 0 x)).
    { apply integral_correct; intros t _; now apply turned_continuous. }
    split; intros H5; [| rewrite <- H5; exact I].
    rewrite <- (is_RInt_unique _ _ _ _ H5); symmetry; apply is_RInt_unique, I.
  - exact Z.
  - exact Aw.
  - rewrite V1, V2; field; lra.
Qed.

(* For b = 1 the printed formula exceeds the defect by about its square over 6 a, which is far
   more than the square of the exponential. *)
Lemma cosine_least e : 0 <= e -> 1 - e ^ 2 / 2 <= cos e.
Proof.
  intros E; enough (0 <= cos e - (1 - e ^ 2 / 2)) by lra.
  apply (from_left_ge (fun t : R => cos t - (1 - t ^ 2 / 2)) (fun t : R => t - sin t) 0 e); try assumption.
  - intros t _; eapply d_eq; [derive; lra |]; tidy; field.
  - intros t T; destruct (Req_dec t 0) as [->|N]; [rewrite sin_0; lra | pose proof (sin_lt_x t ltac:(lra)); lra].
  - rewrite cos_0; lra.
Qed.
Lemma atan_at_most x : 0 <= x -> atan x <= x.
Proof.
  intros X; enough (0 <= x - atan x) by lra.
  apply (from_left_ge (fun t : R => t - atan t) (fun t : R => t * t * / (1 + t * t)) 0 x); try lra.
  - intros t _; eapply d_eq; [derive |]; cbv beta; field; nra.
  - intros t _; apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra].
  - rewrite atan_0; lra.
Qed.
Lemma asin_cubic y : 0 <= y -> y <= 1 / 2 -> y + y ^ 3 / 6 <= asin y.
Proof.
  intros Y Z; enough (0 <= asin y - (y + y ^ 3 / 6)) by lra.
  apply (from_left_ge (fun t : R => asin t - (t + t ^ 3 / 6)) (fun t : R => / sqrt (1 - t ^ 2) - (1 + t ^ 2 / 2)) 0 y); try assumption.
  - intros t T; assert (0 < 1 - t ^ 2) by nra; assert (0 < sqrt (1 - t ^ 2)) by (apply sqrt_lt_R0; lra).
    eapply d_eq; [derive; lra |]; tidy; replace ((-1) * t ^ 2 + 1) with (1 - t ^ 2) by ring; field; lra.
  - intros t T; assert (P : 0 < 1 - t ^ 2) by nra; assert (S : 0 < sqrt (1 - t ^ 2)) by (apply sqrt_lt_R0; lra).
    enough (1 + t ^ 2 / 2 <= / sqrt (1 - t ^ 2)) by lra.
    apply (Rmult_le_reg_r (sqrt (1 - t ^ 2))); [exact S |]; rewrite Rinv_l by lra.
    assert (Q : sqrt (1 - t ^ 2) ^ 2 = 1 - t ^ 2) by (apply pow2_sqrt; lra); set (q := sqrt _) in *.
    assert (((1 + t ^ 2 / 2) * q) ^ 2 <= 1); [| nra].
    rewrite Rpow_mult_distr, Q; assert (0 <= t ^ 2 <= 1 / 4) by nra; set (x := t ^ 2) in *; nra.
  - rewrite asin_0; lra.
Qed.

(* The chain rule along a curve for the equation of the flip defect. *)
Lemma chain_of_G (m : R -> R) (l u dm : R) : is_derive m l dm -> 0 < l -> -1 < m l < 1 ->
  exists v3 v4 : R,
  is_derive (fun t : R => u + (-1) * asin (m t * cos (2 * sqrt ((-1) * m t ^ 2 + 1) * exp ((-1) * / t * (PI + u + asin (m t))))) + asin (m t)) l (dm * v3 + v4) /\
  is_derive (fun mu : R => u + (-1) * asin (mu * cos (2 * sqrt ((-1) * mu ^ 2 + 1) * exp ((-1) * / l * (PI + u + asin mu)))) + asin mu) (m l) v3 /\
  is_derive (fun t : R => u + (-1) * asin (m l * cos (2 * sqrt ((-1) * m l ^ 2 + 1) * exp ((-1) * / t * (PI + u + asin (m l))))) + asin (m l)) l v4.
Proof.
  intros D L M.
  assert (0 < (-1) * m l ^ 2 + 1) by nra.
  assert (C : forall x, -1 < m l * cos x < 1).
  { intros x; pose proof (COS_bound x) as B; destruct (Rtotal_order (cos x) 0) as [Z|[Z|Z]]; [| rewrite Z; lra |]; split; nra. }
  eexists; eexists; split; [| split].
  2: { derive; cbv beta; match goal with |- context [cos ?x] => pose proof (C x) | _ => idtac end; lra. }
  2: { derive; cbv beta; match goal with |- context [cos ?x] => pose proof (C x) | _ => idtac end; lra. }
  eapply d_eq.
  { let rec go := lazymatch goal with
    | |- is_derive (fun _ : R => ?c) _ _ => apply d_const
    | |- is_derive (fun t : R => t) _ _ => apply d_id
    | |- is_derive (fun t : R => @?f t + @?g t) _ _ => eapply (d_plus f g); go
    | |- is_derive (fun t : R => @?f t * @?g t) _ _ => eapply (d_mult f g); go
    | |- is_derive (fun t : R => / @?f t) _ _ => eapply (d_inv f); [go |]
    | |- is_derive (fun t : R => @?f t ^ ?n) _ _ => eapply (d_pow f); go
    | |- is_derive (fun t : R => exp (@?f t)) _ _ => eapply (d_exp f); go
    | |- is_derive (fun t : R => cos (@?f t)) _ _ => eapply (d_cos f); go
    | |- is_derive (fun t : R => sqrt (@?f t)) _ _ => eapply (d_sqrt f); [go |]
    | |- is_derive (fun t : R => asin (@?f t)) _ _ => eapply (d_asin f); [go | |]
    | _ => exact D
    end in go.
    all: cbv beta; match goal with |- context [cos ?x] => pose proof (C x) | _ => idtac end; lra. }
  tidy; ring.
Qed.

(* The defect of a shape with ab >= 1/4 as ab grows: its product with 2 sqrt(ab) is at most the value at ab = 1/4. *)
Lemma hyperbolic_sine_below x : 0 <= x -> sinh x <= x * cosh x.
Proof.
  intros X; enough (0 <= x * cosh x - sinh x) by lra.
  apply (from_left_ge (fun t : R => t * cosh t - sinh t) (fun t : R => t * sinh t) 0 x); try assumption.
  - intros t _; eapply d_eq; [derive |]; cbv beta; ring.
  - intros t [[T|<-] _]; [pose proof (sinh_pos t T); nra | lra].
  - unfold sinh; rewrite Ropp_0, exp_0; lra.
Qed.
Lemma hyperbolic_cosine_above x : sinh x <= cosh x.
Proof. unfold sinh, cosh; pose proof (exp_pos (- x)); lra. Qed.
Lemma sinh_stretched t x : 3 / 2 <= x -> 1 <= t -> t ^ 3 * sinh x <= sinh (t ^ 2 * x).
Proof.
  intros X T.
  assert (Convex : forall s, 1 <= s -> s * sinh x <= sinh (s * x)).
  { intros s S; enough (0 <= sinh (s * x) - s * sinh x) by lra.
    apply (from_left_ge (fun t : R => sinh (t * x) - t * sinh x) (fun t : R => x * cosh (t * x) - sinh x) 1 s S).
    - intros t' _; eapply d_eq; [derive |]; cbv beta; ring.
    - intros t' T'; pose proof (hyperbolic_sine_below x ltac:(lra)).
      assert (cosh x <= cosh (t' * x)) by (apply cosh_rises; nra); nra.
    - rewrite Rmult_1_l; lra. }
  enough (0 <= sinh (t ^ 2 * x) - t ^ 3 * sinh x) by lra.
  apply (from_left_ge (fun t : R => sinh (t ^ 2 * x) - t ^ 3 * sinh x)
    (fun t : R => 2 * t * x * cosh (t ^ 2 * x) - 3 * t ^ 2 * sinh x) 1 t T).
  - intros s _; eapply d_eq; [derive |]; tidy; ring.
  - intros s [S _]; pose proof (Convex (s ^ 2) ltac:(nra)) as C; pose proof (hyperbolic_cosine_above (s ^ 2 * x)).
    pose proof (sinh_pos x ltac:(lra)); set (c := cosh (s ^ 2 * x)) in *.
    assert (s * sinh x <= s ^ 2 * sinh x) by (apply Rmult_le_compat_r; nra).
    assert (0 < s * sinh x <= c) by (split; [nra | lra]); assert (3 * s * (s * sinh x) <= 2 * s * x * c); [| nra].
    replace (3 * s * (s * sinh x)) with (s * 3 * (s * sinh x)) by ring; replace (2 * s * x * c) with (s * (2 * x) * c) by ring; apply Rmult_le_compat; nra.
  - rewrite pow1, Rmult_1_l, pow1; lra.
Qed.
Lemma atan_stretched t z : 1 <= t -> 0 <= z -> z <= 1 / 2 -> t ^ 2 * atan (z * / t ^ 3) <= atan z.
Proof.
  intros T Z Z1; enough (0 <= atan z - t ^ 2 * atan (z * / t ^ 3)) by lra.
  apply (from_left_ge (fun t : R => atan z - t ^ 2 * atan (z * / t ^ 3))
    (fun t : R => t * (3 * (z * / t ^ 3) * / (1 + (z * / t ^ 3) * (z * / t ^ 3)) - 2 * atan (z * / t ^ 3))) 1 t T).
  - intros s [S _]; assert (s ^ 3 <> 0) by (apply pow_nonzero; lra).
    eapply d_eq; [derive; assumption |]; tidy; assert (0 < s ^ 3) by (apply pow_lt; lra).
    field; repeat split; try lra; apply Rgt_not_eq; nra.
  - intros s [S _]; apply Rmult_le_pos; [lra |].
    assert (S3 : 1 <= s ^ 3) by (rewrite <- (pow1 3); apply pow_incr; lra).
    assert (I : 0 < / s ^ 3 <= 1) by (split; [positive | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]).
    set (y := z * / s ^ 3); assert (Y : 0 <= y <= 1 / 2) by (unfold y; nra); pose proof (atan_at_most y (proj1 Y)).
    enough (2 * y <= 3 * y * / (1 + y * y)) by lra.
    apply (Rmult_le_reg_r (1 + y * y)); [nra |]; rewrite (Rmult_assoc (3 * y)), Rinv_l by nra; nra.
  - rewrite !pow1, Rinv_1, !Rmult_1_r; lra.
Qed.
Definition corner_tangent (m r : R) : R :=
  / (sqrt (r + 1) * sinh ((PI + atan (sqrt r * (/ sqrt (r * sin m ^ 2 + 1) * cos m))) / 2)).
Definition corner_defect (m r : R) : R := atan (corner_tangent m r).
Section Corner.
Variables a b e : R.
Hypotheses (A : a > 0) (B : b > 0) (P : e > 0) (Q : e < 1 / 2 * PI).
Hypothesis D : tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Hypotheses (B1 : b <= 1) (AB : a * b >= 1 / 4).
Let r := b * / a.
Let k := sqrt (a * b).
Lemma corner_bound m : e <= m -> m <= PI / 2 -> 2 * k * e <= corner_defect m r /\ 0 < corner_defect m r.
Proof.
  intros M M1; destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 _]]]].
  destruct (defect_shape a b A B B1 AB) as [K _]; pose proof (defect_angle a b e A B P Q D) as E; pose proof pi_between as PB.
  fold r in R0, E; fold k in K0, K, E.
  set (v := atan (sqrt r * (/ sqrt (r * sin m ^ 2 + 1) * cos m))).
  assert (Sm : 0 <= sin e <= sin m) by (split; [lra | apply sin_incr_1; lra]).
  assert (V : 0 <= v <= asin (sqrt (b * / (a + b)) * cos e)).
  { rewrite (turn_of_share a b e A B); fold r; unfold v.
    assert (0 <= cos m) by (apply cos_ge_0; lra); pose proof (sqrt_pos r).
    assert (W : 0 < sqrt (r * sin e ^ 2 + 1)) by (apply sqrt_lt_R0; pose proof (pow2_ge_0 (sin e)); nra).
    assert (sin e ^ 2 <= sin m ^ 2) by (apply pow_incr; lra).
    assert (W1 : sqrt (r * sin e ^ 2 + 1) <= sqrt (r * sin m ^ 2 + 1)) by (apply sqrt_le_1_alt; nra).
    assert (I : 0 < / sqrt (r * sin m ^ 2 + 1)) by (apply Rinv_0_lt_compat; lra).
    assert (0 <= / sqrt (r * sin m ^ 2 + 1) * cos m) by nra.
    split; [rewrite <- atan_0; apply arctangent_rises; nra | apply arctangent_rises].
    apply Rmult_le_compat_l; [assumption |]; apply Rmult_le_compat; try lra.
    - apply Rinv_le_contravar; lra.
    - apply cos_decr_1; lra. }
  set (z := corner_tangent m r); set (t := sqrt (2 * k)).
  assert (T2 : t ^ 2 = 2 * k) by (apply pow2_sqrt; lra).
  assert (T : 1 <= t) by (apply below_sqrt; lra).
  assert (R1 : 1 <= sqrt (r + 1)) by (apply below_sqrt; lra).
  assert (X : 3 / 2 <= (PI + v) / 2) by lra.
  assert (Y0 : 0 < sinh ((PI + v) / 2)) by (apply sinh_pos; lra).
  assert (Y2 : 2 <= sinh ((PI + v) / 2)).
  { apply Rle_trans with (sinh (PI / 2)); [unfold sinh; interval | apply sinh_grows; lra]. }
  assert (Z : 0 < z <= 1 / 2).
  { unfold z, corner_tangent; fold v; split; [apply Rinv_0_lt_compat; nra |].
    replace (1 / 2) with (/ 2) by field; apply Rinv_le_contravar; nra. }
  assert (T3 : 1 <= t ^ 3) by (rewrite <- (pow1 3); apply pow_incr; lra).
  assert (L : e <= atan (z * / t ^ 3)).
  { rewrite E at 1; apply arctangent_rises; unfold z, corner_tangent; fold v; rewrite <- Rinv_mult.
    apply Rinv_le_contravar; [apply Rmult_lt_0_compat; nra |].
    rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra |]; rewrite Rmult_comm.
    eapply Rle_trans; [apply sinh_stretched; assumption |]; apply sinh_grows; rewrite T2; nra. }
  pose proof (atan_stretched t z T (Rlt_le _ _ (proj1 Z)) (proj2 Z)) as G; rewrite T2 in G.
  split; [unfold corner_defect; fold z; nra | unfold corner_defect; fold z; apply atan_above; lra].
Qed.
End Corner.

(* The logarithm of the ratio of a defect to its leading term, with the shape in one factor. *)
Section Flat.
Variables b r k e : R.
Hypotheses (B0 : 0 < b) (B1 : b <= 1) (R0 : 0 < r) (R4 : r <= 4) (K : 0 < k) (KR : k * sqrt r = b).
Hypotheses (E0 : 0 < e) (E1 : e <= 42 / 100).
Let u := e ^ 2.
Let w := sqrt (r * sin e ^ 2 + 1).
Let y := sqrt r * / (w + cos e) * sin e ^ 2.
Lemma turn_by_shape_below : k * asin y <= b * (u * up_turn r u) /\ 0 <= up_turn r u.
Proof.
  pose proof (square_between e E0 E1) as U; destruct (sine_square_between e E0 E1) as [[A B] [C D]].
  destruct (sum_between b r k e B0 B1 R0 R4 KR E0 E1) as [F [_ [G W]]]; fold u in U, A, B, F, G; fold w in F, W.
  set (L := low_sum r u) in *.
  assert (P : 0 < / (w + cos e) <= / L).
  { split; [apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]. }
  assert (I : / L <= 10 / 18) by (replace (10 / 18) with (/ (18 / 10)) by field; apply Rinv_le_contravar; lra).
  assert (Q : 0 < sqrt r) by (apply sqrt_lt_R0; lra); assert (Q2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  assert (S : 0 < sin e ^ 2) by nra.
  assert (V : 0 < / (w + cos e) * sin e ^ 2 <= 10 / 18 * u) by (fold u in C; nra).
  assert (Y0 : 0 < y) by (unfold y; rewrite Rmult_assoc; nra).
  assert (Y1 : y ^ 2 <= r * (10 / 18 * u) ^ 2).
  { unfold y; rewrite Rmult_assoc, Rpow_mult_distr, Q2; apply Rmult_le_compat_l; [lra | nra]. }
  assert (Y2 : y <= 3 / 10) by (assert (y ^ 2 <= 4 * (10 / 18 * (1764 / 10000)) ^ 2); nra).
  pose proof (asin_near y ltac:(lra) Y2) as N.
  assert (T0 : 0 <= up_time u * / L) by (unfold up_time; assert (0 < / L) by lra; nra).
  assert (Z : k * y <= b * (u * (up_time u * / L))).
  { unfold y; replace (k * (sqrt r * / (w + cos e) * sin e ^ 2))
      with (b * (/ (w + cos e) * sin e ^ 2)) by (rewrite <- KR; ring).
    apply Rmult_le_compat_l; [lra |]; assert (/ (w + cos e) * sin e ^ 2 <= / L * (u * up_time u)) by nra; nra. }
  assert (u2 : 0 <= u ^ 2) by nra.
  assert (X : 0 <= r * u ^ 2 / 15) by nra.
  split; [| unfold up_turn; fold L; unfold Rdiv at 1; apply Rmult_le_pos; lra].
  unfold up_turn; fold L; apply Rle_trans with (k * y * (1 + y ^ 2 / 5)); [nra |].
  replace (b * (u * (up_time u / L * (1 + r * u ^ 2 / 15))))
    with (b * (u * (up_time u * / L)) * (1 + r * u ^ 2 / 15)) by (unfold Rdiv; ring).
  assert (0 < k * y) by nra; apply Rmult_le_compat; nra.
Qed.
Lemma exponent_by_shape : let q := k * asin y + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e) in
  q <= b * (u * up_turn r u) + u * (up_sine u + up_root r u) /\ - (u * (1 / 10)) <= q.
Proof.
  intros q; pose proof (square_between e E0 E1) as U; destruct (sine_square_between e E0 E1) as [_ [_ S]].
  destruct (sum_between b r k e B0 B1 R0 R4 KR E0 E1) as [F [G [L W]]]; destruct turn_by_shape_below as [T _].
  pose proof (ratio_above b r k e B0 B1 R0 R4 K KR E0 E1) as Above.
  fold u in U, F, G, L; fold w in F, G, L, W.
  destruct (small_sine e) as [[A B] [C _]]; try lra; fold u in A, B, C.
  assert (I : 0 < / sin e) by (apply Rinv_0_lt_compat; lra).
  assert (V : ln (e * / sin e) <= u * up_sine u).
  { apply Rle_trans with (e * / sin e - 1); [apply ln_below; positive |].
    enough (e * / sin e <= 1 + u * up_sine u) by lra.
    apply (Rmult_le_reg_r (sin e)); try lra; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    unfold up_sine; apply Rle_trans with (e * (1 - u / 6) * (1 + u * (1 / 6 + u / 34))); [| nra].
    assert (0 <= u ^ 2 * (1 / 34 - 1 / 36 - u / 204)) by (apply Rmult_le_pos; nra); nra. }
  assert (X : ln (1 / 2 * w + 1 / 2 * cos e) <= u * up_root r u).
  { apply Rle_trans with (1 / 2 * w + 1 / 2 * cos e - 1); [apply ln_below; lra | lra]. }
  split; [unfold q; fold w in T; lra |].
  fold w y u in Above; fold q in Above.
  assert (Z : (1 + u / 6) * (1 - u / 4) <= exp q).
  { eapply Rle_trans; [| exact Above]; rewrite Rmult_assoc.
    assert (J : 0 < / (w + cos e)) by (apply Rinv_0_lt_compat; lra); assert (S2 : 0 <= sin e ^ 2) by nra.
    assert (H1 : 0 <= b * sin e ^ 2 / (w + cos e)) by (unfold Rdiv; apply Rmult_le_pos; nra).
    assert (H2 : (1 + u / 6) * (1 - u / 4) <= (1 + u / 6) * (1 / 2 * w + 1 / 2 * cos e)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= (1 + u / 6) * (1 - u / 4)) by nra; nra. }
  set (x := (1 + u / 6) * (1 - u / 4)) in *; assert (X0 : 98 / 100 <= x) by (unfold x; nra).
  apply Rle_trans with (ln x); [| rewrite <- (ln_exp q); apply ln_rises; lra].
  pose proof (ln_below (/ x) ltac:(positive)) as N; rewrite ln_Rinv in N by lra.
  enough (/ x <= 1 + u * (1 / 10)) by lra.
  apply (Rmult_le_reg_r x); [lra |]; rewrite Rinv_l by lra; unfold x; nra.
Qed.
End Flat.
Ltac corner_by := unfold corner_defect, corner_tangent, sinh, up_turn, low_sum, up_root, up_sine, up_time.

(* It is small against the square root of ab. *)
Section FlatExponent.
Variables a b e : R.
Hypotheses (A : a > 0) (B : b > 0) (P : e > 0) (Q : e < 1 / 2 * PI).
Hypothesis D : tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Hypotheses (B1 : b <= 1) (AB : a * b >= 1 / 4).
Let r := b * / a.
Let k := sqrt (a * b).
Let w := sqrt (r * sin e ^ 2 + 1).
Lemma flat_exponent q : q = k * asin (sqrt r * / (w + cos e) * sin e ^ 2) + ln (e * / sin e) + ln (1 / 2 * w + 1 / 2 * cos e) ->
  - (9 / 1000) <= k * q <= 9 / 1000.
Proof.
intros Dq.
destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR K2]]]]].
destruct (defect_shape a b A B B1 AB) as [K [R4 RB]].
pose proof (defect_boxes a b e A B P Q D B1 AB) as X; fold r k in R0, K0, KR, K2, K, R4, RB, X.
assert (E42 : e <= 42 / 100) by (decompose [and or] X; lra); clear X.
destruct (exponent_by_shape b r k e) as [V V']; try lra; cbv zeta in V, V'; fold w in V, V'; rewrite <- Dq in V, V'; clear Dq.
pose proof (corner_bound a b e A B P Q D B1 AB (42 / 100) E42 ltac:(interval)) as [Z Z0]; fold r k in Z, Z0.
set (h := e ^ 2) in *; assert (U0 : 0 < h) by (unfold h; nra).
split.
- assert (corner_defect (42 / 100) r <= 41 / 100) by (clear - R0 R4; corner_by; interval with (i_bisect r)).
  assert (k * h <= (41 / 100) ^ 2 / 2) by (unfold h; nra); nra.
- assert (B2 : k * (b * h) = (2 * k * e) ^ 2 / 4 * sqrt r) by (unfold h; rewrite <- KR; field).
  pose proof (turn_by_shape_below b r k e B B1 R0 R4 K0 KR P E42) as [_ T]; fold h in T.
  assert (Part : forall n, corner_defect n r <= n -> 2 * k * e <= corner_defect n r -> 0 < corner_defect n r ->
    (forall v, 0 <= v <= n ^ 2 -> corner_defect n r ^ 2 / 4 * sqrt r * up_turn r v <= 9 / 1000
      /\ corner_defect n r ^ 2 / 4 * sqrt r * up_turn r v + corner_defect n r ^ 2 / 2 * (up_sine v + up_root r v) <= 9 / 1000) ->
    k * q <= 9 / 1000).
  { intros n M F F0 G; set (c := corner_defect n r) in *; assert (e <= c) by nra.
    destruct (G h ltac:(unfold h; nra)) as [G1 G2].
    assert (J : (2 * k * e) ^ 2 <= c ^ 2) by (apply pow_incr; nra).
    apply Rle_trans with (k * (b * h) * up_turn r h + k * h * (up_sine h + up_root r h)); [nra |].
    rewrite B2; pose proof (sqrt_pos r).
    assert ((2 * k * e) ^ 2 / 4 * sqrt r * up_turn r h <= c ^ 2 / 4 * sqrt r * up_turn r h)
      by (repeat apply Rmult_le_compat_r; lra).
    destruct (Rle_or_lt 0 (up_sine h + up_root r h)) as [S1|S1].
    - assert (k * h <= c ^ 2 / 2) by (unfold h; nra).
      assert (k * h * (up_sine h + up_root r h) <= c ^ 2 / 2 * (up_sine h + up_root r h)) by (apply Rmult_le_compat_r; lra); lra.
    - assert (0 < k * h) by nra; nra. }
  assert (Next : forall n n', e <= n -> n <= PI / 2 -> corner_defect n r <= n' -> e <= n').
  { intros n n' M M1 M2; destruct (corner_bound a b e A B P Q D B1 AB n M M1) as [W W0]; fold r k in W, W0; nra. }
  assert (Fine : forall n, e <= n -> n <= PI / 2 -> corner_defect n r <= n ->
    (forall v, 0 <= v <= n ^ 2 -> corner_defect n r ^ 2 / 4 * sqrt r * up_turn r v <= 9 / 1000
      /\ corner_defect n r ^ 2 / 4 * sqrt r * up_turn r v + corner_defect n r ^ 2 / 2 * (up_sine v + up_root r v) <= 9 / 1000) ->
    k * q <= 9 / 1000).
  { intros n M M1 M2 G; destruct (corner_bound a b e A B P Q D B1 AB n M M1) as [W W0]; fold r k in W, W0; now apply (Part n). }
  clear - Next Fine R0 R4 E42.
  destruct (Rle_or_lt r (4 / 10)) as [L1|L1].
  { apply (Fine (42 / 100)); [lra | interval | corner_by; interval with (i_bisect r) |].
    intros v V; split; corner_by; interval with (i_bisect r, i_bisect v). }
  assert (E2 : e <= 3 / 10) by (apply (Next (42 / 100)); [lra | interval | corner_by; interval with (i_bisect r)]).
  destruct (Rle_or_lt r 1) as [L2|L2].
  { apply (Fine (3 / 10)); [lra | interval | corner_by; interval with (i_bisect r) |].
    intros v V; split; corner_by; interval with (i_bisect r, i_bisect v, i_depth 30). }
  assert (E3 : e <= 213 / 1000) by (apply (Next (3 / 10)); [lra | interval | corner_by; interval with (i_bisect r)]).
  destruct (Rle_or_lt r (3 / 2)) as [L3|L3].
  { apply (Fine (213 / 1000)); [lra | interval | corner_by; interval with (i_bisect r) |].
    intros v V; split; corner_by; interval with (i_bisect r, i_bisect v, i_depth 30). }
  assert (E4 : e <= 185 / 1000) by (apply (Next (213 / 1000)); [lra | interval | corner_by; interval with (i_bisect r)]).
  apply (Fine (185 / 1000)); [lra | interval | corner_by; interval with (i_bisect r) |].
  intros v V; split; corner_by; interval with (i_bisect r, i_bisect v, i_depth 30).
Qed.
End FlatExponent.

(* The factors of the slope of the defect at the separatrix, by the square of the defect. *)
Definition up_w (r u : R) : R := r * up_time u / 2 - r ^ 2 * u * up_time u ^ 2 / 8 + r ^ 3 * u ^ 2 * up_time u ^ 3 / 16.
Definition sine_loss (u : R) : R := 1 / 6 - u / 120.
Definition turn_slope (a b e : R) : R :=
  (-1) / 4 * / sqrt (a * b) ^ 3 * (a + (-1) * b + (-2) * a * b) * ln (/ sin e * (sqrt (a + b * sin e ^ 2) + sqrt a * cos e))
  + 1 / 4 * / sqrt (a * b) ^ 3 * (a + (-1) * b + (-2) * a * b) * ln (sqrt (a + b))
  + (-1) / 4 * / a * / sqrt b ^ 3 * sqrt (a + b * sin e ^ 2) * / sin e ^ 2 * cos e.
Section Slope.
Variables a b e : R.
Hypotheses (A : a > 0) (B : b > 0) (P : e > 0) (Q : e < 1 / 2 * PI).
Hypothesis D : tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Let r := b * / a.
Let k := sqrt (a * b).
Let w := sqrt (r * sin e ^ 2 + 1).
Let p := PI + asin (sqrt (b * / (a + b)) * cos e).
Lemma roots_of_shape : sqrt a ^ 2 = a /\ sqrt b ^ 2 = b /\ 0 < sqrt a /\ 0 < sqrt b /\ k = sqrt a * sqrt b
  /\ sqrt (a + b * sin e ^ 2) = sqrt a * w /\ sqrt (a + b) = sqrt a * sqrt (r + 1).
Proof.
  destruct (defect_signs a b e A B P Q) as [S [C [R0 _]]]; fold r in R0; pose proof (pow2_ge_0 (sin e)).
  repeat split; try (apply pow2_sqrt; lra); try (apply sqrt_lt_R0; lra).
  - unfold k; apply sqrt_mult; lra.
  - unfold w; rewrite <- sqrt_mult by nra; f_equal; unfold r; field; lra.
  - rewrite <- sqrt_mult by nra; f_equal; unfold r; field; lra.
Qed.
Lemma per_turn_is : sqrt b * / ((-1) * b * sin e ^ 2 + 1) * sqrt (a + b * sin e ^ 2) * sin e
  = k * (w * sin e * / (1 - b * sin e ^ 2)).
Proof.
  destruct roots_of_shape as [_ [_ [_ [_ [K [E _]]]]]]; rewrite E, K.
  replace ((-1) * b * sin e ^ 2 + 1) with (1 - b * sin e ^ 2) by ring; ring.
Qed.
Lemma turn_slope_is : turn_slope a b e = / (4 * b * k) * (- (w * cos e * / sin e ^ 2) + (2 * b + r - 1) * (k * p)).
Proof.
  destruct roots_of_shape as [A2 [B2 [A0 [B0 [K [E F]]]]]].
  destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [_ K2]]]]]; fold r in R0; fold k in K0, K2.
  destruct (root_facts a b e A B) as [W [Q0 _]]; fold r in W, Q0; fold w in W.
  pose proof (decay a b _ e A B S C D) as Y; fold r k p in Y; fold w in Y.
  assert (L : ln (/ sin e * (sqrt (a + b * sin e ^ 2) + sqrt a * cos e)) - ln (sqrt (a + b)) = k * p).
  { rewrite E, F; replace (/ sin e * (sqrt a * w + sqrt a * cos e)) with (sqrt a * ((w + cos e) * / sin e)) by ring.
    rewrite !ln_mult by (first [positive | apply Rmult_lt_0_compat; [lra | positive]]).
    assert (Z : k * p = - ln (sqrt (r + 1) * / (w + cos e) * sin e)) by (rewrite <- Y, ln_exp; ring).
    rewrite Z; rewrite !ln_mult, !ln_Rinv by (first [lra | positive | apply Rinv_0_lt_compat; lra | apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]]); ring. }
  unfold turn_slope; fold k; rewrite <- L, E.
  set (l1 := ln _); set (l2 := ln _).
  replace ((-1) / 4 * / a * / sqrt b ^ 3 * (sqrt a * w) * / sin e ^ 2 * cos e) with (/ (4 * b * k) * (- (w * cos e * / sin e ^ 2))).
  - replace (/ k ^ 3) with (/ k * / (a * b)) by (rewrite <- K2; field; lra).
    unfold r; field; repeat split; lra.
  - rewrite K; replace (sqrt b ^ 3) with (sqrt b * b) by (rewrite <- B2 at 2; ring).
    replace (/ a) with (/ (sqrt a * sqrt a)) by (f_equal; rewrite <- A2 at 3; ring); field; repeat split; lra.
Qed.
Hypotheses (B1 : b <= 1) (R4 : r <= 4) (E1 : e <= 42 / 100).
Let u := e ^ 2.
Lemma factors_between : 0 < u <= 1764 / 10000 /\ e * (1 - u / 6) <= sin e <= e * (1 - u * sine_loss u)
  /\ u - u ^ 2 / 3 <= sin e ^ 2 <= u * up_time u /\ sin e ^ 2 <= u
  /\ 1 <= w <= 1 + u * up_w r u /\ 1 - u / 2 <= cos e /\ 0 < sin e /\ 0 < cos e.
Proof.
  destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR _]]]]]; fold r in R0, KR; fold k in K0, KR.
  pose proof (square_between e P E1) as U; destruct (sine_square_between e P E1) as [[S1 S2] [S3 _]]; fold u in U, S1, S2, S3.
  destruct (small_sine e) as [[S4 S5] [S6 _]]; try lra; fold u in S4, S5, S6.
  replace (e ^ 4) with (u ^ 2) in S5 by (unfold u; ring).
  destruct (sum_between b r k e B B1 R0 R4 KR P E1) as [_ [_ [_ W]]]; fold w in W.
  assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
  repeat split; try lra; try (unfold sine_loss; nra); try assumption.
  set (x := r * u * up_time u); assert (X : 0 <= x <= 1).
  { unfold x; assert (0 <= r * u <= 1) by nra; nra. }
  replace (1 + u * up_w r u) with (1 + x / 2 - x ^ 2 / 8 + x ^ 3 / 16) by (unfold x, up_w; field).
  assert (0 <= x ^ 2 <= 1) by nra; assert (0 <= x ^ 3) by (apply pow_le; lra).
  apply above_sqrt; [nra |]; apply Rle_trans with (1 + x); [unfold x; nra |].
  enough (0 <= x ^ 4 * (5 / 64 - x / 64 + x ^ 2 / 256)) by nra.
  apply Rmult_le_pos; [apply pow_le; lra | nra].
Qed.
Lemma per_turn_between : let t := w * sin e * / (1 - b * sin e ^ 2) in
  e * (1 - u / 6) * (1 + b * (u - u ^ 2 / 3)) <= t
  /\ t * (1 - b * (u * up_time u)) <= e * (1 - u * sine_loss u) * (1 + u * up_w r u) /\ 0 < t
  /\ 0 < 1 - b * (u * up_time u).
Proof.
  intros t; destruct factors_between as [U [S [S2 [S3 [W [C [S0 C0]]]]]]].
  assert (T : 0 <= up_time u <= 1) by (unfold up_time; nra).
  assert (V : 0 < 1 - b * (u * up_time u) <= 1 - b * sin e ^ 2) by (assert (0 <= u * up_time u <= 1764 / 10000) by nra; nra).
  assert (J : t * (1 - b * sin e ^ 2) = w * sin e) by (unfold t; field; lra).
  assert (J1 : 0 < t) by (unfold t; apply Rmult_lt_0_compat; [nra | apply Rinv_0_lt_compat; lra]).
  repeat split; try lra.
  - apply Rle_trans with (sin e * (1 + b * sin e ^ 2)).
    + assert (V2 : 0 <= u - u ^ 2 / 3) by nra; assert (V3 : 0 < e * (1 - u / 6)) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= b * (u - u ^ 2 / 3)) by (apply Rmult_le_pos; lra); apply Rmult_le_compat; try lra.
      apply Rplus_le_compat_l, Rmult_le_compat_l; lra.
    + assert (X : 0 <= b * sin e ^ 2) by nra; assert (Y : sin e <= t * (1 - b * sin e ^ 2)) by (rewrite J; nra).
      set (x := b * sin e ^ 2) in *; clearbody x; apply (Rmult_le_compat_r (1 + x)) in Y; [| lra].
      assert (0 <= t * x ^ 2) by (apply Rmult_le_pos; nra); nra.
  - apply Rle_trans with (sin e * w); [nra |]; apply Rmult_le_compat; lra.
Qed.
End Slope.

(* The derivative of the turn by the level, and the slope, by their leading terms. *)
Section Level.
Variables a b e : R.
Hypotheses (A : a > 0) (B : b > 0) (P : e > 0) (Q : e < 1 / 2 * PI).
Hypothesis D : tanh (sqrt (a * b) * (PI + asin (sqrt (b * / (a + b)) * cos e)))
  = / sqrt (b * / a * sin e ^ 2 + 1) * cos e.
Let r := b * / a.
Let k := sqrt (a * b).
Let w := sqrt (r * sin e ^ 2 + 1).
Let p := PI + asin (sqrt (b * / (a + b)) * cos e).
Let t := w * sin e * / (1 - b * sin e ^ 2).
Let y := cos e * sin e * / (1 - b * sin e ^ 2).
Let u := e ^ 2.
Hypotheses (B1 : b <= 1) (R4 : r <= 4) (E1 : e <= 42 / 100).
Lemma phase_between : PI <= p <= PI + atan (sqrt r).
Proof.
  destruct (defect_signs a b e A B P Q) as [S [C [R0 _]]]; fold r in R0; pose proof (COS_bound e) as C1.
  unfold p; rewrite (turn_of_share a b e A B); fold r w.
  destruct (root_facts a b e A B) as [W _]; fold r in W; fold w in W; pose proof (sqrt_pos r).
  assert (I : 0 < / w <= 1) by (split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_le_contravar; lra]).
  assert (J : 0 <= / w * cos e <= 1) by nra.
  split; apply Rplus_le_compat_l || rewrite <- (Rplus_0_r PI) at 1; [| apply arctangent_rises; nra].
  apply Rplus_le_compat_l; rewrite <- atan_0; apply arctangent_rises; nra.
Qed.
Lemma phase_below_log : k * p <= ln (2 * / (sqrt (r + 1) * e)) + u * (up_root r u + up_sine u).
Proof.
  destruct (defect_signs a b e A B P Q) as [S [C [R0 [K0 [KR _]]]]]; fold r in R0, KR; fold k in K0, KR.
  destruct (root_facts a b e A B) as [W [Q0 _]]; fold r in W, Q0; fold w in W.
  pose proof (decay a b _ e A B S C D) as Y; fold r k p in Y; fold w in Y.
  destruct (sum_between b r k e B B1 R0 R4 KR P E1) as [_ [G _]]; fold u in G; fold w in G.
  pose proof (square_between e P E1) as U; fold u in U.
  destruct (small_sine e) as [[A1 _] _]; try lra; fold u in A1.
  assert (I : 0 < / sin e) by (apply Rinv_0_lt_compat; lra).
  assert (V : ln (e * / sin e) <= u * up_sine u).
  { apply Rle_trans with (e * / sin e - 1); [apply ln_below; positive |].
    enough (e * / sin e <= 1 + u * up_sine u) by lra.
    apply (Rmult_le_reg_r (sin e)); try lra; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    unfold up_sine; apply Rle_trans with (e * (1 - u / 6) * (1 + u * (1 / 6 + u / 34))); [| nra].
    assert (0 <= u ^ 2 * (1 / 34 - 1 / 36 - u / 204)) by (apply Rmult_le_pos; nra); nra. }
  assert (X : ln (1 / 2 * w + 1 / 2 * cos e) <= u * up_root r u).
  { apply Rle_trans with (1 / 2 * w + 1 / 2 * cos e - 1); [apply ln_below; lra | lra]. }
  assert (Z : k * p = - ln (sqrt (r + 1) * / (w + cos e) * sin e)) by (rewrite <- Y, ln_exp; ring).
  assert (Z2 : sqrt (r + 1) * / (w + cos e) * sin e = / (2 * / (sqrt (r + 1) * e) * (1 / 2 * w + 1 / 2 * cos e) * (e * / sin e)))
    by (field; repeat split; lra).
  assert (P1 : 0 < 2 * / (sqrt (r + 1) * e)) by (apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra]).
  assert (P3 : 0 < e * / sin e) by (apply Rmult_lt_0_compat; lra).
  rewrite Z, Z2; set (x1 := 2 * / _) in *; set (x2 := 1 / 2 * w + _) in *; set (x3 := e * / _) in *.
  assert (P2 : 0 < x2) by (unfold x2; lra); clearbody x1 x2 x3.
  rewrite ln_Rinv, !ln_mult by (repeat first [assumption | apply Rmult_lt_0_compat]); lra.
Qed.
Lemma level_part_between : let h := / u - w * cos e * / sin e ^ 2 in
  1 / 6 - r / 2 <= h /\ h <= 1 / 6 + u / 9 - r * (1 - u / 2) * / (2 + u * up_w r u).
Proof.
  intros h; destruct (factors_between a b e A B P Q B1 R4 E1) as [U [S [S2 [S3 [W [C [S0 C0]]]]]]].
  fold r in W; fold w u in W; fold u in U, S, S2, S3, C.
  destruct (small_sine e) as [_ [_ C1]]; try lra; fold u in C1; replace (e ^ 4) with (u ^ 2) in C1 by (unfold u; ring).
  destruct (defect_signs a b e A B P Q) as [_ [_ [R0 _]]]; fold r in R0; pose proof (COS_bound e) as C2.
  assert (J0 : 0 < sin e ^ 2) by (apply pow_lt; lra).
  assert (W2 : w ^ 2 = r * sin e ^ 2 + 1) by (apply pow2_sqrt; apply Rplus_le_le_0_compat; [apply Rmult_le_pos |]; lra).
  assert (H : h = / u - cos e * / sin e ^ 2 - r * cos e * / (w + 1)).
  { unfold h; replace (w * cos e * / sin e ^ 2) with (cos e * / sin e ^ 2 + cos e * ((w - 1) * (w + 1)) * / (w + 1) * / sin e ^ 2)
      by (field; split; lra).
    replace ((w - 1) * (w + 1)) with (r * sin e ^ 2) by lra; field; repeat split; lra. }
  assert (H1 : 1 / 6 <= / u - cos e * / sin e ^ 2 <= 1 / 6 + u / 9).
  { assert (E : / u - cos e * / sin e ^ 2 = (sin e ^ 2 - u * cos e) * / (u * sin e ^ 2)) by (field; lra).
    rewrite E; split; apply (Rmult_le_reg_r (u * sin e ^ 2)); try (apply Rmult_lt_0_compat; lra);
      rewrite ?(Rmult_assoc _ (/ _)), Rinv_l, Rmult_1_r by (apply Rgt_not_eq, Rmult_lt_0_compat; lra).
    - apply Rle_trans with (sin e ^ 2 - u * (1 - u / 2 + u ^ 2 / 24)); [| apply Rplus_le_compat_l, Ropp_le_contravar, Rmult_le_compat_l; lra].
      enough (u * (1 - u / 2 + u ^ 2 / 24) <= sin e ^ 2 * (1 - u / 6)) by lra.
      assert ((e * (1 - u / 6)) ^ 2 <= sin e ^ 2) by (apply pow_incr; split; [apply Rmult_le_pos; lra | lra]).
      apply Rle_trans with ((e * (1 - u / 6)) ^ 2 * (1 - u / 6)); [| apply Rmult_le_compat_r; lra].
      rewrite Rpow_mult_distr; fold u; rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra |].
      assert (0 <= u ^ 2 * (1 / 24 - u / 216)) by (apply Rmult_le_pos; nra); nra.
    - apply Rle_trans with (sin e ^ 2 - u * (1 - u / 2)); [apply Rplus_le_compat_l, Ropp_le_contravar, Rmult_le_compat_l; lra |].
      enough (sin e ^ 2 * (1 - u / 6 - u ^ 2 / 9) <= u * (1 - u / 2)) by lra.
      apply Rle_trans with (u * up_time u * (1 - u / 6 - u ^ 2 / 9)); [apply Rmult_le_compat_r; nra |].
      rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra |]; unfold up_time; clear - U.
      assert (0 <= u ^ 2 * (1 / 90 - 8 / 270 * u + 2 / 405 * u ^ 2)) by (apply Rmult_le_pos; nra); nra. }
  rewrite H; assert (I : 0 < / (w + 1) <= 1 / 2).
  { split; [apply Rinv_0_lt_compat; lra |]; replace (1 / 2) with (/ 2) by field; apply Rinv_le_contravar; lra. }
  assert (I2 : / (2 + u * up_w r u) <= / (w + 1)) by (apply Rinv_le_contravar; lra).
  assert (I3 : 0 < / (2 + u * up_w r u)) by (apply Rinv_0_lt_compat; lra).
  assert (cos e * / (w + 1) <= 1 / 2) by nra.
  assert ((1 - u / 2) * / (2 + u * up_w r u) <= cos e * / (w + 1)) by (apply Rmult_le_compat; lra).
  rewrite !(Rmult_assoc r); split; nra.
Qed.
End Level.

Lemma printed_above a e : a >= 100 -> e > 0 -> e < 1 / 2 * PI ->
  tanh (sqrt (a * 1) * (PI + asin (sqrt (1 * / (a + 1)) * cos e))) = / sqrt (1 * / a * sin e ^ 2 + 1) * cos e ->
  exp (- (PI * sqrt (a * 1))) ^ 2
  < 2 * sqrt (a * / (a + 1)) * exp (- sqrt (a * / (a + 1))) * exp (- (PI * sqrt (a * 1))) - e.
Proof.
  intros A P Q D; assert (A0 : a > 0) by lra; assert (B0 : 1 > 0) by lra; pose proof pi_between as J.
  destruct (defect_signs a 1 e A0 B0 P Q) as [S [C [R0 [K0 [KR K2]]]]].
  pose proof (defect_by_exp a 1 e A0 B0 P Q D) as U; pose proof (defect_angle a 1 e A0 B0 P Q D) as V.
  pose proof (defect_turn a 1 e A0 B0 P Q) as T; pose proof (share_below a 1 e ltac:(lra) ltac:(lra)) as H0.
  set (k := sqrt (a * 1)) in *; set (c := sqrt (a * / (a + 1))) in *.
  assert (K : 10 <= k) by (apply below_sqrt; lra).
  assert (m0 : 0 < 1 * / (a + 1)) by positive.
  assert (M2 : sqrt (1 * / (a + 1)) ^ 2 = / (a + 1)) by (rewrite pow2_sqrt by lra; ring).
  set (m := sqrt (1 * / (a + 1))) in *; assert (m1 : 0 < m) by (apply sqrt_lt_R0; exact m0).
  assert (I1 : / (a + 1) <= / 101) by (apply Rinv_le_contravar; lra).
  assert (I2 : / (606 / 100 * a) <= / (6 * (a + 1))) by (apply Rinv_le_contravar; lra).
  assert (Ia : 0 < / a <= / 100) by (split; [positive | apply Rinv_le_contravar; lra]).
  assert (C0 : 0 < a * / (a + 1)) by positive.
  assert (C2 : c ^ 2 = 1 - / (a + 1)) by (unfold c; rewrite pow2_sqrt by lra; field; lra).
  assert (c0 : 0 < c) by (apply sqrt_lt_R0; exact C0).
  assert (c1 : 99 / 100 <= c <= 1) by (split; nra).
  assert (km : k * m = c).
  { apply same_square; [nra | lra |]; rewrite Rpow_mult_distr, K2, M2, C2; field; lra. }
  set (t := exp (- (PI * k))) in *; assert (t0 : 0 < t) by apply exp_pos.
  assert (t1 : t * (156 * a) <= 1).
  { assert (X : (1 + k / 2) ^ 6 <= exp (PI * k)).
    { apply Rle_trans with (exp (k / 2) ^ 6).
      - apply pow_incr; split; [lra | apply exp_ineq1_le].
      - replace (exp (k / 2) ^ 6) with (exp (6 * (k / 2))) by (simpl; rewrite Rmult_1_r, <- !exp_plus; f_equal; field).
        apply exp_rises; nra. }
    assert (Y : t * exp (PI * k) = 1) by (unfold t; rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
    assert (Z : 156 * a <= (1 + k / 2) ^ 6); [| nra].
    replace a with (k ^ 2) by lra; apply Rle_trans with ((k / 2) ^ 6).
    - replace ((k / 2) ^ 6) with (k ^ 2 * (k ^ 2) ^ 2 / 64) by field; assert (100 <= k ^ 2) by nra; nra.
    - apply pow_incr; lra. }
  assert (t2 : t <= / a / 156).
  { apply (Rmult_le_reg_r (156 * a)); [lra |]; replace (/ a / 156 * (156 * a)) with 1 by (field; lra); exact t1. }
  pose proof (cosine_least e ltac:(lra)) as Ce; pose proof (COS_bound e) as Cb.
  assert (E2 : e ^ 2 <= 4 * t ^ 2) by nra.
  assert (T2 : t ^ 2 <= / a * / 2433600) by nra.
  set (z := asin (m * cos e)) in *.
  assert (m2 : m <= 1 / 2) by nra.
  pose proof (asin_cubic (m * cos e) ltac:(nra) ltac:(nra)) as As; fold z in As.
  assert (Ex : c + / (8 * a) <= k * z).
  { apply Rle_trans with (k * (m * cos e + (m * cos e) ^ 3 / 6)); [| apply Rmult_le_compat_l; lra].
    replace (k * (m * cos e + (m * cos e) ^ 3 / 6)) with (k * m * cos e * (1 + m ^ 2 * cos e ^ 2 / 6)) by field.
    rewrite km, M2; set (x := cos e) in *; assert (X : 1 - 2 * t ^ 2 <= x) by lra.
    assert (X2 : 1 - 4 * t ^ 2 <= x ^ 2) by nra.
    assert (i0 : 0 < / (a + 1)) by positive; set (i := / (a + 1)) in *.
    assert (I3 : / (6 * (a + 1)) = i / 6) by (unfold i; field; lra).
    assert (I4 : / (606 / 100 * a) = / a * (100 / 606)) by (field; lra).
    assert (I5 : / (8 * a) = / a / 8) by (field; lra).
    assert (I6 : i <= / a) by (apply Rinv_le_contravar; lra).
    set (j := / a) in *; clearbody i j; rewrite I5.
    assert (Y : 1 + i / 6 - 4 * t ^ 2 <= x * (1 + i * x ^ 2 / 6)).
    { apply Rle_trans with ((1 - 2 * t ^ 2) * (1 + i * (1 - 4 * t ^ 2) / 6)).
      - assert (0 <= t ^ 2 * i) by nra; assert (0 <= t ^ 2 * t ^ 2 * i) by (apply Rmult_le_pos; nra); nra.
      - apply Rmult_le_compat; try lra; nra. }
    apply Rle_trans with (c * (1 + i / 6 - 4 * t ^ 2)); [nra |].
    rewrite Rmult_assoc; apply Rmult_le_compat_l; lra. }
  set (x := k * (PI + z)) in *.
  assert (X0 : PI * k <= x) by (unfold x; nra).
  assert (Ee : e <= c * / sinh x).
  { assert (0 < sqrt (1 * / a + 1)) by (apply sqrt_lt_R0; positive).
    assert (0 < sinh x) by (apply sinh_pos; nra); rewrite V.
    unfold c; rewrite (inverse_root a 1 ltac:(lra) ltac:(lra)), <- Rinv_mult.
    apply atan_at_most; left; positive. }
  set (d := / (8 * a)) in *; assert (d0 : 0 < d) by (unfold d; positive).
  assert (F : exp (- x) <= t * exp (- c) * / (1 + d)).
  { apply Rle_trans with (t * exp (- c) * exp (- d)).
    - unfold t; rewrite <- !exp_plus; apply exp_rises; unfold x; lra.
    - apply Rmult_le_compat_l; [pose proof (exp_pos (- c)); nra |].
      rewrite exp_Ropp; apply Rinv_le_contravar; [lra | apply exp_ineq1_le]. }
  pose proof (exp_pos (- x)) as y0; set (y := exp (- x)) in *; pose proof (exp_pos (- c)) as g0; set (g := exp (- c)) in *.
  assert (y1 : y <= t) by (apply exp_rises; lra).
  assert (Sh : sinh x = (/ y - y) / 2) by (unfold sinh, y; rewrite exp_Ropp, Rinv_inv; reflexivity).
  assert (t3 : t <= 1 / 1000) by lra.
  assert (Y2 : 0 < 1 - y ^ 2) by nra.
  assert (Sf : c * / sinh x = 2 * c * y * / (1 - y ^ 2)) by (rewrite Sh; field; split; [nra | lra]).
  assert (g1 : 36 / 100 <= g).
  { unfold g; apply Rle_trans with (exp (- 1)); [interval | apply exp_rises; lra]. }
  assert (d1 : d <= 1 / 800) by (unfold d; replace (/ (8 * a)) with (/ a / 8) by (field; lra); lra).
  assert (d2 : t <= d / 19) by (unfold d; replace (/ (8 * a)) with (/ a / 8) by (field; lra); lra).
  rewrite Sf in Ee.
  assert (G : y * / (1 - y ^ 2) <= t * g * (1 - d / 2)).
  { apply (Rmult_le_reg_r (1 - y ^ 2)); [exact Y2 |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rle_trans with (t * g * / (1 + d)); [exact F |]; rewrite Rmult_assoc, (Rmult_assoc (t * g)), (Rmult_assoc t).
    apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [lra |].
    apply (Rmult_le_reg_r (1 + d)); [lra |]; rewrite Rinv_l by lra.
    assert (y ^ 2 <= t / 1000) by nra; assert (0 <= y ^ 2) by nra; nra. }
  assert (Fin : e <= 2 * c * (t * g * (1 - d / 2))) by (eapply Rle_trans; [exact Ee |]; rewrite Rmult_assoc; apply Rmult_le_compat_l; lra).
  assert (36 / 100 * (99 / 100) <= c * g) by nra.
  assert (t ^ 2 < c * g * t * d); [| nra].
  assert (t < c * g * d) by nra; nra.
Qed.

(* The decay of a small defect by the defect. *)
Lemma share_of_sum r e : 0 < r -> r <= 4 -> 0 < e -> e <= 1 / 4 ->
  (1 - 23 / 25 * e ^ 2) / 2 * e <= sin e * / (sqrt (r * sin e ^ 2 + 1) + cos e) <= (1 + e ^ 2 / 4) / 2 * e.
Proof.
  intros R0 R4 E0 E1; destruct (small_sine e) as [[S1 S2] [C1 C2]]; try lra.
  destruct (sine_square_between e E0 ltac:(lra)) as [_ [Sq S0]].
  set (w := sqrt (r * sin e ^ 2 + 1)).
  assert (W : 1 <= w <= 1 + r * e ^ 2 / 2).
  { unfold w; split; [apply below_sqrt | apply above_sqrt]; nra. }
  replace (e ^ 4) with ((e ^ 2) ^ 2) in S2, C2 by ring; assert (V : 0 < e ^ 2 <= 1 / 16) by nra.
  set (v := e ^ 2) in *; set (s := sin e) in *; set (c := cos e) in *; assert (0 < w + c) by nra.
  split; apply (Rmult_le_reg_r (w + c)); try assumption; rewrite (Rmult_assoc s), Rinv_l, Rmult_1_r by lra.
  - apply Rle_trans with (e * (1 - v / 6)); [| exact S1].
    replace ((1 - 23 / 25 * v) / 2 * e * (w + c)) with (e * ((1 - 23 / 25 * v) / 2 * (w + c))) by ring.
    apply Rmult_le_compat_l; [lra |].
    apply Rle_trans with ((1 - 23 / 25 * v) / 2 * (2 + 3 / 2 * v + v ^ 2 / 24)); [apply Rmult_le_compat_l; nra | nra].
  - apply Rle_trans with (e * (1 - v / 6 + v ^ 2 / 120)); [exact S2 |].
    replace ((1 + v / 4) / 2 * e * (w + c)) with (e * ((1 + v / 4) / 2 * (w + c))) by ring.
    apply Rmult_le_compat_l; [lra |].
    apply Rle_trans with ((1 + v / 4) / 2 * (2 - v / 2)); [nra | apply Rmult_le_compat_l; lra].
Qed.
