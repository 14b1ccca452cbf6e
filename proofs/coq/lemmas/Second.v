(* The ratio of the defect to its leading term beyond the first order. *)
Definition first_term (a b : R) : R := 1 / 2 * b + 1 / 4 * b * / a + (-1) / 12.
Lemma exponent_first a b e : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e < PI / 2 -> exponent a b e <= first_term a b * e ^ 2.
Proof.
  intros A B B1 E0 E1; pose proof pi_between as PB.
  apply (exponent_below a b (fun t => first_term a b * t ^ 2) (fun t => 2 * first_term a b * t)); trivial.
  - ring.
  - intros t _; auto_derive; [exact I | ring].
  - intros t T; assert (S : 0 < sin t) by (apply sin_gt_0; lra).
    pose proof (root_above a b t A B) as W1; pose proof (root_square a b t A B) as W2.
    assert (R0 : 0 < b * / a) by positive; set (r := b * / a) in *; unfold turn_rate; set (w := root_of a b t) in *.
    destruct (sine_below_top t) as [U _]; try lra; unfold sine_top in U.
    pose proof (SIN_bound t) as S1; set (s := sin t) in *; assert (S2 : 0 < s ^ 2 <= 1) by nra.
    assert (F : first_term a b = b / 2 + r / 4 - 1 / 12) by (unfold first_term, r; field; lra); rewrite F; clear F.
    assert (I : 1 - r * s ^ 2 / 2 <= / w).
    { apply (Rmult_le_reg_r w); [lra |]; rewrite Rinv_l by lra.
      set (u := r * s ^ 2) in *; assert (U0 : 0 < u) by (unfold u; nra).
      destruct (Rle_or_lt (1 - u / 2) 0) as [N|N]; [nra |].
      assert (((1 - u / 2) * w) ^ 2 <= 1) by (rewrite Rpow_mult_distr, W2; nra); nra. }
    assert (J : 1 - (b + r / 2) * s ^ 2 <= (1 - b * s ^ 2) * / w).
    { apply Rle_trans with ((1 - b * s ^ 2) * (1 - r * s ^ 2 / 2)).
      - assert (0 <= b * s ^ 2) by nra; assert (0 <= r * s ^ 2) by nra; nra.
      - apply Rmult_le_compat_l; [nra | exact I]. }
    assert (V : 0 < t ^ 2 < 4) by nra.
    assert (L : / t + t / 6 <= / s).
    { apply (Rmult_le_reg_r (t * s)); [nra |]; replace (/ s * (t * s)) with t by (field; lra).
      replace ((/ t + t / 6) * (t * s)) with (s * (1 + t ^ 2 / 6)) by (field; lra).
      apply Rle_trans with (t * (1 - t ^ 2 / 6 + (t ^ 2) ^ 2 / 120) * (1 + t ^ 2 / 6)); [apply Rmult_le_compat_r; lra |].
      set (v := t ^ 2) in *.
      replace (t * (1 - v / 6 + v ^ 2 / 120) * (1 + v / 6)) with (t - t * (v ^ 2 * (7 / 360 - v / 720))) by field.
      assert (0 <= t * (v ^ 2 * (7 / 360 - v / 720))) by (repeat apply Rmult_le_pos; nra); lra. }
    assert (M : (1 - (b + r / 2) * s ^ 2) * / s <= (1 - b * s ^ 2) * / w * / s).
    { apply Rmult_le_compat_r; [left; positive | exact J]. }
    replace ((1 - (b + r / 2) * s ^ 2) * / s) with (/ s - (b + r / 2) * s) in M by (field; lra).
    assert (X : s <= t) by (left; apply sin_lt_x; lra).
    assert ((b + r / 2) * s <= (b + r / 2) * t) by nra; lra.
Qed.
Section Parts.
Variables a b e : R.
Hypotheses (A : 0 < a) (B : 0 < b) (E0 : 0 < e) (E1 : e < PI / 2).
Let r := b * / a.
Let w := root_of a b e.
Lemma parts_signs : 0 < sin e /\ 0 < cos e /\ 0 < r /\ 1 < w /\ w ^ 2 = r * sin e ^ 2 + 1 /\ sin e ^ 2 = 1 - cos e ^ 2.
Proof.
  pose proof (root_square a b e A B) as W; assert (R0 : 0 < r) by (unfold r; positive).
  assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (0 < r * sin e ^ 2) by positive.
  pose proof (root_above a b e A B) as W1; fold w r in W, W1.
  repeat split; try assumption; [apply cos_gt_0; lra | nra | apply sin_square].
Qed.
Lemma turn_parts : (-1) * asin (sqrt (b * / (a + b)) * cos e) + asin (sqrt (b * / (a + b)))
  = asin (sqrt r * / (w + cos e) * sin e ^ 2).
Proof.
  destruct parts_signs as [S [C [R0 [W1 [W2 S2]]]]].
  rewrite turn_from_top, turn_of_share by assumption; change (sqrt (_ + 1)) with w; fold r.
  assert (Q : 0 < sqrt r) by (apply sqrt_lt_R0; exact R0); assert (Q2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  set (q := sqrt r) in *; set (c := cos e) in *; set (s := sin e) in *.
  set (y := q * / (w + c) * s ^ 2).
  assert (Y : y = q * (w - c) * / (1 + r)).
  { unfold y; apply (Rmult_eq_reg_r ((w + c) * (1 + r))); [| nra].
    replace (q * / (w + c) * s ^ 2 * ((w + c) * (1 + r))) with (q * (s ^ 2 * (1 + r))) by (field; lra).
    replace (q * (w - c) * / (1 + r) * ((w + c) * (1 + r))) with (q * (w ^ 2 - c ^ 2)) by (field; lra).
    rewrite W2, S2; ring. }
  assert (Z : 1 - y * y = ((w + r * c) * / (1 + r)) ^ 2).
  { rewrite Y; replace (1 - q * (w - c) * / (1 + r) * (q * (w - c) * / (1 + r))) with (((1 + r) ^ 2 - q ^ 2 * (w - c) ^ 2) * / (1 + r) ^ 2) by (field; lra).
    rewrite Q2; replace ((1 + r) ^ 2 - r * (w - c) ^ 2) with ((w + r * c) ^ 2); [field; lra |].
    replace (w ^ 2) with (r * (1 - c ^ 2) + 1) by (rewrite <- S2; lra).
    replace ((w + r * c) ^ 2) with (w ^ 2 + 2 * r * w * c + r ^ 2 * c ^ 2) by ring.
    replace (r * (w - c) ^ 2) with (r * w ^ 2 - 2 * r * w * c + r * c ^ 2) by ring; rewrite W2, S2; ring. }
  assert (V : 0 < (w + r * c) * / (1 + r)) by (assert (0 < r * c) by positive; positive).
  assert (H : -1 < y < 1) by (split; nra).
  rewrite (asin_by_atan y H), Z, sqrt_pow2 by lra.
  symmetry; apply atan_difference; [exact Q | positive |].
  rewrite Y; assert (0 < r * c) by positive.
  replace (1 + q * (q * (/ w * c))) with (1 + q ^ 2 * (/ w * c)) by ring; rewrite Q2; field; repeat split; lra.
Qed.
End Parts.
(* One bound for all shapes: the ratio's distance from one against (1 + b / a) sqrt (1 + b / a) times the square. *)
Lemma three_below x X : x <= X -> 0 <= X -> (exp x - 1) * exp (2 * x) <= (exp X - 1) * exp (2 * X).
Proof.
  intros H P; pose proof (exp_rises x X H) as U; pose proof (exp_rises (2 * x) (2 * X) ltac:(lra)) as V.
  pose proof (exp_pos (2 * x)); assert (1 <= exp X) by (rewrite <- exp_0; apply exp_rises, P).
  destruct (Rle_or_lt (exp x) 1); [assert (0 <= exp (2 * X)) by lra; nra |].
  apply Rmult_le_compat; lra.
Qed.
Lemma three_near X m : 0 <= X -> X <= m -> m <= 4 / 10 ->
  (exp X - 1) * exp (2 * X) <= X * (1 + X * (5 / 2 + 19 / 6 * m + 4 * m ^ 2)).
Proof.
  intros X0 XM M; pose proof (exp_nearer X X0 ltac:(lra)) as E; pose proof (exp_pos X) as P.
  replace (2 * X) with (X + X) by ring; rewrite exp_plus.
  set (p := 1 + X * (1 / 2 + X / 6 + X ^ 2 / 19)).
  assert (P0 : 1 + X * (1 + X / 2 + X ^ 2 / 6 + X ^ 3 / 19) = 1 + X * p) by (unfold p; field); rewrite P0 in E.
  assert (P1 : 1 <= p) by (unfold p; assert (0 <= 1 / 2 + X / 6 + X ^ 2 / 19) by nra; nra).
  assert (Y : 0 <= X * p) by nra; assert (U : 1 <= exp X) by (rewrite <- exp_0; apply exp_rises, X0).
  apply Rle_trans with (X * p * ((1 + X * p) * (1 + X * p))).
  - apply Rmult_le_compat; [lra | nra | lra | apply Rmult_le_compat; lra].
  - rewrite Rmult_assoc; apply Rmult_le_compat_l; [exact X0 |]; assert (X4 : X <= 4 / 10) by lra.
    assert (G : 155 / 57 + X * (409 / 228 + X * (1291 / 1368 + X * (61 / 152 + X * (1207 / 8664 + X * (3061 / 77976
      + X * (37 / 4332 + X * (1 / 722 + X / 6859))))))) <= 4) by interval.
    match type of G with ?g <= _ => assert (N : p * ((1 + X * p) * (1 + X * p)) = 1 + X * (5 / 2 + 19 / 6 * X + X ^ 2 * g))
      by (unfold p; field); set (q := g) in * end.
    rewrite N; apply Rplus_le_compat_l, Rmult_le_compat_l; [exact X0 |].
    assert (X ^ 2 <= m ^ 2) by (apply pow_incr; lra); assert (0 <= X ^ 2) by nra; nra.
Qed.
Definition stretched (a b : R) : R := 5 / 12 * ((1 + b * / a) * sqrt (1 + b * / a)).
Lemma stretched_least r : 0 < r -> 1 + 3 / 2 * r <= (1 + r) * sqrt (1 + r) /\ r * sqrt r <= (1 + r) * sqrt (1 + r).
Proof.
  intros R0; assert (Q : sqrt (1 + r) ^ 2 = 1 + r) by (apply pow2_sqrt; lra); assert (1 <= sqrt (1 + r)) by (apply below_sqrt; lra).
  split; [| apply Rmult_le_compat; try lra; [apply sqrt_pos | apply sqrt_le_1_alt; lra]].
  set (q := sqrt (1 + r)) in *; replace r with (q ^ 2 - 1) by lra.
  enough (0 <= (q - 1) ^ 2 * (q + 1 / 2)) by nra; apply Rmult_le_pos; nra.
Qed.
Lemma stretched_far a b e : 0 < a -> 0 < b -> b <= 1 -> 1 / 4 <= a * b -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  within_ratio (stretched a b) a b e.
Proof.
  intros A B B1 AB E0 E1 D; destruct (defect_small a b e A B B1 AB E0 E1 D) as [S1 S2].
  pose proof (exponent_first a b e A B B1 E0 E1) as F; unfold within_ratio.
  assert (R0 : 0 < b * / a) by positive; set (x := exponent a b e) in *; unfold stretched.
  assert (C : first_term a b = (6 * b - 1 + 3 * (b * / a)) / 12) by (unfold first_term; field; lra); rewrite C in F; clear C.
  assert (R4 : b * / a <= 4 * b ^ 2).
  { apply (Rmult_le_reg_r a); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; nra. }
  assert (V : e ^ 2 * b ^ 2 <= 51 / 1000 * (b * / a)).
  { replace (e ^ 2 * b ^ 2) with (e ^ 2 * (a * b) * (b * / a)) by (field; lra); apply Rmult_le_compat_r; lra. }
  set (r := b * / a) in *; assert (V0 : 0 < e ^ 2 <= 2025 / 10000) by nra; set (v := e ^ 2) in *.
  destruct (stretched_least r R0) as [Q _]; set (q := (1 + r) * sqrt (1 + r)) in *; set (c := (6 * b - 1 + 3 * r) / 12) in *.
  destruct (Rle_or_lt c 0) as [C|C].
  { assert (exp x <= 1) by (rewrite <- exp_0; apply exp_rises; nra); pose proof (exp_pos (2 * x)); nra. }
  assert (CX : 0 <= c * v <= 3 / 10) by (split; [nra | unfold c; assert ((6 * b - 1 + 3 * r) / 12 <= 17 / 12) by nra; nra]).
  eapply Rle_trans; [apply (three_below x (c * v) F); lra |].
  eapply Rle_trans; [apply (three_near (c * v) (3 / 10)); lra |].
  replace (5 / 12 * q * v) with (v * (5 / 12 * q)) by ring.
  replace (c * v * (1 + c * v * (5 / 2 + 19 / 6 * (3 / 10) + 4 * (3 / 10) ^ 2))) with (v * (c * (1 + 381 / 100 * (c * v)))) by field.
  apply Rmult_le_compat_l; [lra |].
  destruct (Rle_or_lt b (1 / 2)) as [H|H].
  - assert (c <= 1 / 6 + r / 4) by (unfold c; lra); assert (r <= 1) by nra.
    assert (c * v <= 5 / 12 * (2025 / 10000)) by (apply Rmult_le_compat; lra).
    apply Rle_trans with (c * (133 / 100)); [apply Rmult_le_compat_l; lra | lra].
  - assert (W : v <= 204 / 1000 * r).
    { apply (Rmult_le_reg_r (b ^ 2)); [nra |]; apply Rle_trans with (51 / 1000 * r); [exact V | assert (1 / 4 <= b ^ 2) by nra; nra]. }
    assert (L : c <= 5 / 12 + r / 4) by (unfold c; lra).
    destruct (Rle_or_lt r 1) as [H1|H1].
    + assert (c * v <= (5 / 12 + r / 4) * (204 / 1000 * r)) by (apply Rmult_le_compat; lra).
      apply Rle_trans with ((5 / 12 + r / 4) * (1 + 381 / 100 * ((5 / 12 + r / 4) * (204 / 1000 * r)))); [apply Rmult_le_compat; nra |].
      apply Rle_trans with (5 / 12 * (1 + 3 / 2 * r)); [| lra]; nra.
    + assert (r <= 4) by nra; assert (c * v <= (5 / 12 + r / 4) * (2025 / 10000)) by (apply Rmult_le_compat; lra).
      apply Rle_trans with ((5 / 12 + r / 4) * (1 + 381 / 100 * ((5 / 12 + r / 4) * (2025 / 10000)))); [apply Rmult_le_compat; nra |].
      unfold q; clear - H1 H0; enough (0 <= 5 / 12 * ((1 + r) * sqrt (1 + r)) - (5 / 12 + r / 4) * (1 + 381 / 100 * ((5 / 12 + r / 4) * (2025 / 10000)))) by lra.
      interval with (i_bisect r).
Qed.
(* Near the equilibria of small products: first where the root is near one, by the first coefficient. *)
Lemma stretched_near a b e : 0 < a -> 0 < b -> b <= 1 -> a * b <= 1 / 4 -> 0 < e -> e < PI / 2 ->
  b * / a * e ^ 2 <= 8 / 10 -> within_ratio (stretched a b) a b e.
Proof.
  intros A B B1 AB E0 E1 S; pose proof (exponent_first a b e A B B1 E0 E1) as F; unfold within_ratio.
  assert (R0 : 0 < b * / a) by positive; set (x := exponent a b e) in *; unfold stretched.
  assert (C : first_term a b = (6 * b - 1 + 3 * (b * / a)) / 12) by (unfold first_term; field; lra); rewrite C in F; clear C.
  assert (K : b <= 1 / 2 * sqrt (b * / a)).
  { apply Rmult_le_reg_l with 2; [lra |]; replace (2 * (1 / 2 * sqrt (b * / a))) with (sqrt (b * / a)) by field; apply below_sqrt.
    apply (Rmult_le_reg_r a); [lra |]; replace (b * / a * a) with b by (field; lra); nra. }
  set (r := b * / a) in *; assert (Z0 : 0 < sqrt r) by (apply sqrt_lt_R0; exact R0); assert (Z2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  assert (V0 : 0 < e ^ 2) by nra; assert (PB : PI / 2 <= 1571 / 1000) by interval.
  destruct (stretched_least r R0) as [Q1 Q2]; set (q := (1 + r) * sqrt (1 + r)) in *; set (z := sqrt r) in *; set (c := (6 * b - 1 + 3 * r) / 12) in *.
  destruct (Rle_or_lt c 0) as [C|C].
  { assert (exp x <= 1) by (rewrite <- exp_0; apply exp_rises; nra); pose proof (exp_pos (2 * x)); nra. }
  assert (L : c <= (3 * z - 1 + 3 * r) / 12) by (unfold c; lra).
  assert (CX : 0 <= c * e ^ 2 <= 36 / 100).
  { split; [nra |]; apply Rle_trans with ((3 * z - 1 + 3 * r) / 12 * e ^ 2); [apply Rmult_le_compat_r; lra |].
    assert (Y : z * e <= 895 / 1000) by (assert (0 <= z * e) by nra; assert ((z * e) ^ 2 <= 8 / 10) by (rewrite Rpow_mult_distr, Z2; exact S); nra).
    assert (z * e ^ 2 <= 895 / 1000 * e) by nra; pose proof (pow2_ge_0 (e - 134 / 100)); lra. }
  eapply Rle_trans; [apply (three_below x (c * e ^ 2) F); lra |].
  eapply Rle_trans; [apply (three_near (c * e ^ 2) (36 / 100)); lra |].
  set (v := e ^ 2) in *; replace (5 / 12 * q * v) with (v * (5 / 12 * q)) by ring.
  replace (c * v * (1 + c * v * (5 / 2 + 19 / 6 * (36 / 100) + 4 * (36 / 100) ^ 2))) with (v * (c * (1 + 41584 / 10000 * (c * v)))) by field.
  apply Rmult_le_compat_l; [lra |].
  apply Rle_trans with (c * (25 / 10)); [apply Rmult_le_compat_l; lra |].
  apply Rle_trans with ((3 * z - 1 + 3 * r) / 12 * (25 / 10)); [apply Rmult_le_compat_r; lra |].
  destruct (Rle_or_lt z 4) as [H|H].
  - enough (0 <= 5 / 12 * ((1 + z ^ 2) * sqrt (1 + z ^ 2)) - (3 * z - 1 + 3 * z ^ 2) / 12 * (25 / 10)) as G by (rewrite Z2 in G; fold q in G; lra).
    clear - H Z0; interval with (i_bisect z).
  - assert (r * z >= 4 * r) by nra; assert (z <= r / 4) by nra; lra.
Qed.
(* Beyond: the ratio over q e, with q = sqrt (1 + b / a), as a function of the angle and of m = sqrt (4 / 5 + e^2) / (q e). *)
Lemma asin_share m t : 0 <= m -> m <= 1 -> 0 <= t -> t <= PI / 2 -> asin (m * sin t) <= m * t.
Proof.
  intros M0 M1 T0 T1; pose proof PI_RGT_0.
  assert (S : m * sin t <= sin (m * t)).
  { enough (0 <= sin (m * t) - m * sin t) by lra.
    apply (concave (fun s : R => sin (s * t) - s * sin t) (fun s => t * cos (s * t) - sin t) (fun s => - t ^ 2 * sin (s * t)) 0 1 m); [lra | | | | |].
    - intros s _; auto_derive; [exact I | ring].
    - intros s _; auto_derive; [exact I | ring].
    - intros s U; assert (0 <= sin (s * t)) by (apply sin_ge_0; nra); assert (0 <= t ^ 2) by nra; nra.
    - rewrite Rmult_0_l, sin_0; lra.
    - rewrite Rmult_1_l; lra. }
  assert (0 <= sin t) by (apply sin_ge_0; lra); assert (sin (m * t) <= 1) by (pose proof (SIN_bound (m * t)); lra).
  rewrite <- (asin_sin (m * t)) by nra.
  destruct S as [S|S]; [left; apply asin_rises; nra | rewrite S; lra].
Qed.
Definition tail_ratio (k t m g : R) : R :=
  let l := m / sqrt (4 / 5 + t ^ 2) in let z := sqrt (1 - (l * t) ^ 2) * g in let q := sqrt (l ^ 2 + z ^ 2) + l * cos t in
  exp (k * (z / q)) / g * q / 2.
Lemma ratio_beyond a b e k : 0 < a -> 0 < b -> 0 < e -> e < PI / 2 -> sqrt (a * b) * e <= k ->
  let l := / (sqrt (1 + b * / a) * e) in exp (exponent a b e) * l <= tail_ratio k e (l * sqrt (4 / 5 + e ^ 2)) (sin e / e).
Proof.
  intros A B E0 E1 K l; destruct (parts_signs a b e A B E0 E1) as [S [C [R0 [W1 [W2 S2]]]]].
  unfold exponent; rewrite (turn_parts a b e A B E0 E1), !exp_plus, !exp_ln by (first [lra | positive]).
  set (w := root_of a b e) in *; set (r := b * / a) in *; set (c := cos e) in *.
  assert (Q : 0 < sqrt (1 + r)) by (apply sqrt_lt_R0; lra); assert (Q2 : sqrt (1 + r) ^ 2 = 1 + r) by (apply pow2_sqrt; lra).
  assert (Z : 0 < sqrt r) by (apply sqrt_lt_R0; exact R0); assert (Z2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  assert (D : 0 < sqrt (4 / 5 + e ^ 2)) by (apply sqrt_lt_R0; nra).
  assert (LD : l = / (sqrt (1 + r) * e)) by reflexivity; clearbody l; set (q := sqrt (1 + r)) in *.
  assert (L : 0 < l) by (rewrite LD; positive); set (s := sin e) in *.
  unfold tail_ratio; cbv zeta; fold c; set (d := sqrt (4 / 5 + e ^ 2)) in *.
  replace (l * d / d) with l by (field; lra).
  assert (LE : (l * e) ^ 2 = / (1 + r)).
  { rewrite LD, <- Q2; field; lra. }
  assert (Y : sqrt (1 - (l * e) ^ 2) * (s / e) = l * sqrt r * s).
  { replace (sqrt (1 - (l * e) ^ 2)) with (sqrt r * / q); [rewrite LD; field; lra |].
    symmetry; rewrite LE; apply same_square; [apply sqrt_pos | left; positive |].
    rewrite Rpow_mult_distr, Z2, pow2_sqrt, pow_inv, Q2; [field; lra |].
    replace (1 - / (1 + r)) with (r * / (1 + r)) by (field; lra); left; positive. }
  rewrite Y; assert (X : sqrt (l ^ 2 + (l * sqrt r * s) ^ 2) = l * w).
  { apply same_square; [apply sqrt_pos | left; positive |]; rewrite pow2_sqrt by nra.
    rewrite !Rpow_mult_distr, W2, Z2; ring. }
  rewrite X; replace (l * w + l * c) with (l * (w + c)) by ring.
  replace (l * sqrt r * s / (l * (w + c))) with (sqrt r * s / (w + c)) by (field; lra).
  set (m := sqrt r * s / (w + c)).
  assert (M : 0 <= m <= 1).
  { unfold m; assert (sqrt r * s <= w) by (assert ((sqrt r * s) ^ 2 <= w ^ 2) by (rewrite Rpow_mult_distr, W2, Z2; lra); assert (0 < sqrt r * s) by positive; nra).
    split; [unfold Rdiv; left; positive |]; apply (Rmult_le_reg_r (w + c)); [lra |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  pose proof (asin_share m e (proj1 M) (proj2 M) ltac:(lra) ltac:(lra)) as T; fold s in T.
  replace (m * s) with (sqrt r * / (w + c) * s ^ 2) in T by (unfold m; field; lra).
  set (x := asin _) in *; assert (U : sqrt (a * b) * x <= k * m).
  { assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive); apply Rle_trans with (sqrt (a * b) * (m * e)); [apply Rmult_le_compat_l; lra |].
    replace (sqrt (a * b) * (m * e)) with (sqrt (a * b) * e * m) by ring; apply Rmult_le_compat_r; lra. }
  apply exp_rises in U; set (y := exp (k * m)) in *; set (g := exp (sqrt (a * b) * x)) in *.
  apply Rle_trans with (y * (e * / s * (1 / 2 * w + 1 / 2 * c) * l)); [| right; field; lra].
  apply Rle_trans with (g * (e * / s * (1 / 2 * w + 1 / 2 * c) * l)); [right; ring |].
  apply Rmult_le_compat_r; [left; positive | exact U].
Qed.
Lemma beyond_large t m : 4 / 10 <= t -> t <= 1571 / 1000 -> 0 <= m -> m <= 1 ->
  let g := tail_ratio (t / PI * ln (2 / t)) t m (sin t / t) in t * (g ^ 2 * (g - m / sqrt (4 / 5 + t ^ 2))) <= 5 / 12.
Proof. intros T0 T1 M0 M1; unfold tail_ratio; cbv zeta; interval with (i_bisect t, i_bisect m, i_depth 30). Qed.
Lemma beyond_small t m g : 0 <= t -> t <= 4 / 10 -> 0 <= m -> m <= 1 -> 97 / 100 <= g -> g <= 1 ->
  let h := tail_ratio (t / 2) t m g in t * (h ^ 2 * (h - m / sqrt (4 / 5 + t ^ 2))) <= 5 / 12.
Proof. intros T0 T1 M0 M1 G0 G1; unfold tail_ratio; cbv zeta; interval with (i_bisect t, i_bisect m, i_bisect g, i_depth 30). Qed.
Lemma stretched_beyond a b e : 0 < a -> 0 < b -> a * b <= 1 / 4 -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  8 / 10 <= b * / a * e ^ 2 -> within_ratio (stretched a b) a b e.
Proof.
  intros A B AB E0 E1 D S; pose proof (defect_by_exp a b e A B E0 ltac:(lra) D) as X; pose proof PI_RGT_0 as PP.
  assert (K : sqrt (a * b) <= 1 / 2) by (apply above_sqrt; lra); assert (PB : PI / 2 <= 1571 / 1000) by interval.
  assert (R0 : 0 < b * / a) by positive; unfold within_ratio, stretched; set (r := b * / a) in *.
  assert (Q : 0 < sqrt (1 + r)) by (apply sqrt_lt_R0; lra); assert (Q2 : sqrt (1 + r) ^ 2 = 1 + r) by (apply pow2_sqrt; lra).
  assert (D2 : sqrt (4 / 5 + e ^ 2) ^ 2 = 4 / 5 + e ^ 2) by (apply pow2_sqrt; nra); assert (D0 : 0 < sqrt (4 / 5 + e ^ 2)) by (apply sqrt_lt_R0; nra).
  pose proof (ratio_beyond a b e) as G; cbv zeta in G; fold r in G; set (q := sqrt (1 + r)) in *; set (d := sqrt (4 / 5 + e ^ 2)) in *.
  assert (L0 : 0 < / (q * e)) by positive; assert (LE : / (q * e) * (q * e) = 1) by (field; lra); set (l := / (q * e)) in *.
  assert (M : 0 <= l * d <= 1).
  { split; [nra |]; assert (d <= q * e) by (assert (d ^ 2 <= (q * e) ^ 2) by (rewrite Rpow_mult_distr, D2, Q2; lra); assert (0 < q * e) by nra; nra); nra. }
  assert (N : exists g, exp (exponent a b e) * l <= g /\ e * (g ^ 2 * (g - l)) <= 5 / 12).
  { destruct (Rle_or_lt (4 / 10) e) as [H|H].
    - assert (U : sqrt (a * b) * e <= e / PI * ln (2 / e)).
      { assert (V : PI * sqrt (a * b) <= ln (2 / e)).
        { rewrite <- (ln_exp (PI * sqrt (a * b))); apply ln_le; [apply exp_pos |].
          apply (Rmult_le_reg_r (e * exp (- (PI * sqrt (a * b))))); [pose proof (exp_pos (- (PI * sqrt (a * b)))); nra |].
          replace (2 / e * (e * exp (- (PI * sqrt (a * b))))) with (2 * exp (- (PI * sqrt (a * b)))) by (field; lra).
          replace (exp (PI * sqrt (a * b)) * (e * exp (- (PI * sqrt (a * b))))) with (exp (PI * sqrt (a * b)) * exp (- (PI * sqrt (a * b))) * e) by ring.
          rewrite <- exp_plus, Rplus_opp_r, exp_0; lra. }
        apply (Rmult_le_reg_r PI); [exact PP |]; replace (e / PI * ln (2 / e) * PI) with (e * ln (2 / e)) by (field; lra); nra. }
      eexists; split; [exact (G _ A B E0 E1 U) |].
      pose proof (beyond_large e (l * d) H ltac:(lra) (proj1 M) (proj2 M)) as Z; cbv zeta in Z; fold d in Z.
      replace (l * d / d) with l in Z by (field; lra); exact Z.
    - eexists; split; [exact (G (e / 2) A B E0 E1 ltac:(nra)) |].
      assert (SN : 97 / 100 <= sin e / e <= 1).
      { destruct (small_sine e ltac:(lra) ltac:(lra)) as [[S1 _] _]; pose proof (sin_lt_x e E0).
        split; apply (Rmult_le_reg_r e); try lra; replace (sin e / e * e) with (sin e) by (field; lra); nra. }
      pose proof (beyond_small e (l * d) (sin e / e) ltac:(lra) ltac:(lra) (proj1 M) (proj2 M) (proj1 SN) (proj2 SN)) as Z; cbv zeta in Z; fold d in Z.
      replace (l * d / d) with l in Z by (field; lra); exact Z. }
  destruct N as [g [N1 N2]]; replace (2 * exponent a b e) with (exponent a b e + exponent a b e) by ring; rewrite exp_plus.
  pose proof (exp_pos (exponent a b e)) as E; set (x := exp (exponent a b e)) in *.
  destruct (Rle_or_lt x 1) as [H|H]; [assert (0 <= 5 / 12 * ((1 + r) * q) * e ^ 2) by (left; positive); nra |].
  assert (V : (x * l) ^ 2 * (x * l - l) <= g ^ 2 * (g - l)) by (apply Rmult_le_compat; [nra | nra | apply pow_incr; nra | lra]).
  assert (W : e * ((x * l) ^ 2 * (x * l - l)) <= 5 / 12) by nra.
  rewrite <- Q2; apply (Rmult_le_reg_r (e * l ^ 3)); [assert (0 < l ^ 3) by (apply pow_lt; exact L0); nra |].
  replace ((x - 1) * (x * x) * (e * l ^ 3)) with (e * ((x * l) ^ 2 * (x * l - l))) by ring.
  replace (5 / 12 * (q ^ 2 * q) * e ^ 2 * (e * l ^ 3)) with (5 / 12 * (l * (q * e)) ^ 3) by ring; rewrite LE; lra.
Qed.
Lemma stretched_within a b e : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e < PI / 2 -> is_defect a b e -> within_ratio (stretched a b) a b e.
Proof.
  intros A B B1 E0 E1 D; destruct (Rle_or_lt (1 / 4) (a * b)); [apply stretched_far; assumption |].
  destruct (Rle_or_lt (b * / a * e ^ 2) (8 / 10)); [apply stretched_near | apply stretched_beyond]; try assumption; lra.
Qed.
(* The ratio from below: what stays of the first order is at least -(37/100) e^4. *)
Definition excess (a b e : R) : R := (exp (exponent a b e) - 1) * exp (exponent a b e) ^ 2 - first_term a b * e ^ 2.
Lemma low_polynomial p b v : 0 <= b -> b <= 1 -> 0 <= v -> v <= 24675 / 10000 ->
  let h := p + b * v / 2 - v / 12 + v * p / 6 - v ^ 2 / 24 - b * v ^ 2 / 12 - b * v ^ 3 / 36 in
  p * (1 + p) * (1 + v / 3 + v ^ 2 / 9) + b * v / 2 - v / 12 <= h + 2 * h ^ 2 + 37 / 100 * v ^ 2.
Proof.
  intros B0 B1 V0 V1 h.
  set (g := b / 2 - 1 / 12 - v / 24 - b * v / 12 - b * v ^ 2 / 36).
  set (A := 2 * (1 + v / 6) ^ 2 - (1 + v / 3 + v ^ 2 / 9)).
  set (L := 1 / 6 + 4 * g * (1 + v / 6) - 1 / 3 - v / 9).
  set (c := 2 * g ^ 2 - 1 / 24 - b / 12 - b * v / 36 + 37 / 100).
  assert (A0 : 0 < A) by (unfold A; clear - V0 V1; interval with (i_bisect v)).
  assert (N : 0 <= 4 * A * c - L ^ 2) by (unfold A, c, L, g; clear - B0 B1 V0 V1; interval with (i_bisect v, i_bisect b, i_depth 20)).
  apply (Rmult_le_reg_l (4 * A)); [lra |].
  enough (0 <= 4 * A * (h + 2 * h ^ 2 + 37 / 100 * v ^ 2 - (p * (1 + p) * (1 + v / 3 + v ^ 2 / 9) + b * v / 2 - v / 12))) by lra.
  replace (4 * A * (h + 2 * h ^ 2 + 37 / 100 * v ^ 2 - (p * (1 + p) * (1 + v / 3 + v ^ 2 / 9) + b * v / 2 - v / 12)))
    with ((2 * A * p + v * L) ^ 2 + v ^ 2 * (4 * A * c - L ^ 2)) by (unfold A, c, L, g, h; field).
  assert (0 <= v ^ 2) by nra; pose proof (pow2_ge_0 (2 * A * p + v * L)); nra.
Qed.
Section Low.
Variables a b e : R.
Hypotheses (A : 0 < a) (B : 0 < b) (B1 : b <= 1) (E0 : 0 < e) (E1 : e < PI / 2).
Let r := b * / a.
Let w := root_of a b e.
Let v := e ^ 2.
Let E := exp (exponent a b e).
Lemma square_at_most : 0 < v <= 24675 / 10000.
Proof. unfold v; assert (PI / 2 <= 1570797 / 1000000) by interval; split; nra. Qed.
Lemma sine_at_least : v - v ^ 2 / 3 <= sin e ^ 2 /\ v <= sin e ^ 2 * (1 + v / 3 + v ^ 2 / 9).
Proof.
  pose proof square_at_most as V; pose proof pi_between as PB.
  assert (S : e * (1 - v / 6 + v ^ 2 / 120 - v ^ 3 / 5040) <= sin e).
  { destruct (pre_sin_bound e 1) as [X _]; try lra; unfold sin_approx, sin_term in X; cbn in X.
    eapply Rle_trans; [| exact X]; right; unfold v; field. }
  set (g := 1 - v / 6 + v ^ 2 / 120 - v ^ 3 / 5040) in *.
  assert (G0 : 1 - v / 6 <= g) by (unfold g; replace (1 - v / 6 + v ^ 2 / 120 - v ^ 3 / 5040) with (1 - v / 6 + v ^ 2 * (1 / 120 - v / 5040)) by field;
    assert (0 <= v ^ 2 * (1 / 120 - v / 5040)) by (apply Rmult_le_pos; nra); lra).
  assert (G : 0 < e * g) by nra.
  assert (S2 : v * g ^ 2 <= sin e ^ 2) by (unfold v; rewrite <- Rpow_mult_distr; apply pow_incr; lra).
  split.
  - eapply Rle_trans; [| exact S2]; assert ((1 - v / 6) ^ 2 <= g ^ 2) by (apply pow_incr; lra); nra.
  - apply Rle_trans with (v * g ^ 2 * (1 + v / 3 + v ^ 2 / 9)); [| apply Rmult_le_compat_r; nra].
    enough (1 <= g ^ 2 * (1 + v / 3 + v ^ 2 / 9)) by nra.
    set (q := 2 / 45 + v * (- 8 / 315 + v * (3643 / 907200 + v * (- 47 / 151200 + v * (1067 / 76204800 + v * (- 1 / 2822400 + v / 228614400)))))).
    assert (Q : 0 <= q) by (unfold q; clear - V; interval with (i_bisect v)).
    replace (g ^ 2 * (1 + v / 3 + v ^ 2 / 9)) with (1 + v ^ 2 * q) by (unfold g, q; field); nra.
Qed.
Lemma ratio_parts : exists p, 0 <= p /\ r * sin e ^ 2 = 4 * p * (1 + p)
  /\ (1 + v / 6) * (1 + p - v / 4 + b * (v - v ^ 2 / 3) / 2) <= E.
Proof.
  destruct (parts_signs a b e A B E0 E1) as [S [C [R0 [W1 [W2 S2]]]]]; pose proof square_at_most as V; pose proof pi_between as PB.
  assert (EX : E = exp (sqrt (a * b) * asin (sqrt (b * / a) * / (root_of a b e + cos e) * sin e ^ 2)) * (e * / sin e) * (1 / 2 * root_of a b e + 1 / 2 * cos e)).
  { unfold E, exponent; rewrite (turn_parts a b e A B E0 E1), !exp_plus, !exp_ln by (first [lra | positive]); reflexivity. }
  fold r w in R0, W1, W2, EX; rewrite EX; clear EX; exists ((w - 1) / 2); repeat split; [lra | lra |].
  assert (Z : 0 < sqrt r) by (apply sqrt_lt_R0; exact R0); assert (Z2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  set (y := sqrt r * / (w + cos e) * sin e ^ 2).
  assert (Y0 : 0 <= y) by (unfold y; left; positive).
  assert (Y1 : y <= 1).
  { unfold y; assert (sqrt r * sin e <= w) by (assert ((sqrt r * sin e) ^ 2 <= w ^ 2) by (rewrite Rpow_mult_distr, W2, Z2; lra); assert (0 < sqrt r * sin e) by positive; nra).
    pose proof (SIN_bound e); apply (Rmult_le_reg_r (w + cos e)); [lra |].
    replace (sqrt r * / (w + cos e) * sin e ^ 2 * (w + cos e)) with (sqrt r * sin e * sin e) by (field; lra); nra. }
  assert (X : 1 + b * sin e ^ 2 / (w + cos e) <= exp (sqrt (a * b) * asin y)).
  { eapply Rle_trans; [| apply exp_ineq1_le]; pose proof (asin_least y Y0 Y1).
    assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
    replace (b * sin e ^ 2 / (w + cos e)) with (sqrt (a * b) * y); [nra |].
    rewrite <- (product_root a b A B) at 2; unfold y; fold r; field; lra. }
  assert (T : 1 + v / 6 <= e * / sin e).
  { apply (Rmult_le_reg_r (sin e)); [lra |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    destruct (sine_below_top e) as [U _]; try lra; unfold sine_top in U; fold v in U.
    apply Rle_trans with ((1 + v / 6) * (e * (1 - v / 6 + v ^ 2 / 120))); [apply Rmult_le_compat_l; lra |].
    replace ((1 + v / 6) * (e * (1 - v / 6 + v ^ 2 / 120))) with (e - e * (v ^ 2 * (7 / 360 - v / 720))) by field.
    assert (0 <= e * (v ^ 2 * (7 / 360 - v / 720))) by (repeat apply Rmult_le_pos; nra); lra. }
  destruct sine_at_least as [N _]; pose proof (cosine_least e ltac:(lra)) as M; fold v in M.
  apply Rle_trans with ((1 + v / 6) * ((1 + b * sin e ^ 2 / (w + cos e)) * (1 / 2 * w + 1 / 2 * cos e))).
  - apply Rmult_le_compat_l; [lra |].
    replace ((1 + b * sin e ^ 2 / (w + cos e)) * (1 / 2 * w + 1 / 2 * cos e)) with ((w + cos e + b * sin e ^ 2) / 2) by (field; lra); nra.
  - set (q := 1 + b * sin e ^ 2 / (w + cos e)) in *.
    assert (Q : 0 <= q) by (unfold q, Rdiv; assert (0 < b * sin e ^ 2 * / (w + cos e)) by positive; lra).
    set (d := 1 / 2 * w + 1 / 2 * cos e); assert (D : 0 < d) by (unfold d; lra).
    replace ((1 + v / 6) * (q * d)) with (q * (1 + v / 6) * d) by ring.
    apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat; lra.
Qed.
Lemma ratio_low : - (37 / 100) * v ^ 2 <= excess a b e /\ (E < 1 -> 1 - E <= v * (1 / 12 + v / 24)).
Proof.
  pose proof square_at_most as V; destruct ratio_parts as [p [P0 [P1 P2]]]; destruct sine_at_least as [_ N].
  assert (R0 : 0 < r) by (unfold r; positive); unfold excess; fold v E.
  set (h := p + b * v / 2 - v / 12 + v * p / 6 - v ^ 2 / 24 - b * v ^ 2 / 12 - b * v ^ 3 / 36).
  assert (H : 1 + h <= E) by (eapply Rle_trans; [| exact P2]; right; unfold h; field).
  assert (C : first_term a b * v <= p * (1 + p) * (1 + v / 3 + v ^ 2 / 9) + b * v / 2 - v / 12).
  { replace (first_term a b * v) with (r * v / 4 + b * v / 2 - v / 12) by (unfold first_term, r; field; lra).
    assert (r * v <= 4 * p * (1 + p) * (1 + v / 3 + v ^ 2 / 9)) by (rewrite <- P1; nra); lra. }
  assert (G : 0 <= b * (v * (1 / 2 - v / 12 - v ^ 2 / 36))).
  { apply Rmult_le_pos; [lra |]; apply Rmult_le_pos; [lra |]; clear - V; interval. }
  assert (PL : p * (1 + v / 6) - v * (1 / 12 + v / 24) <= h) by (unfold h; lra).
  set (g := v * (1 / 12 + v / 24)) in *; assert (G0 : 0 < g) by (unfold g; nra).
  split.
  - pose proof (low_polynomial p b v ltac:(lra) B1 ltac:(lra) ltac:(lra)) as L; cbv zeta in L; fold h in L.
    destruct (Rle_or_lt 1 E) as [X|X].
    + assert (Y : (E - 1) + 2 * (E - 1) ^ 2 <= (E - 1) * E ^ 2) by (assert (0 <= (E - 1) * (E - 1) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]); nra).
      assert (h + 2 * h ^ 2 <= (E - 1) + 2 * (E - 1) ^ 2); [| lra].
      destruct (Rle_or_lt 0 h) as [Z|Z]; [assert (h ^ 2 <= (E - 1) ^ 2) by (apply pow_incr; lra); lra |].
      assert (- (1 / 2) <= h) by (assert (g <= 1 / 2) by (unfold g; clear - V; interval); nra).
      assert (h * (1 + 2 * h) <= 0) by nra; pose proof (pow2_ge_0 (E - 1)); nra.
    + assert (EP : 0 < E) by apply exp_pos; assert (Y : E - 1 <= (E - 1) * E ^ 2) by (assert (E ^ 2 <= 1) by nra; nra).
      enough (first_term a b * v - h <= 37 / 100 * v ^ 2) by lra.
      assert (PG : p <= g) by nra.
      apply Rle_trans with (g * (1 + g) * (1 + v / 3 + v ^ 2 / 9) - g * (1 + v / 6) + v ^ 2 / 24 + b * v ^ 2 / 12 + b * v ^ 3 / 36).
      * eapply Rle_trans; [apply Rplus_le_compat_r, C |]; unfold h.
        assert (p * p <= g * g) by nra; assert (0 <= v / 3 + v ^ 2 / 9) by nra; nra.
      * unfold g; replace (v * (1 / 12 + v / 24) * (1 + v * (1 / 12 + v / 24)) * (1 + v / 3 + v ^ 2 / 9) - v * (1 / 12 + v / 24) * (1 + v / 6) + v ^ 2 / 24 + b * v ^ 2 / 12 + b * v ^ 3 / 36)
          with (v ^ 2 * ((1 / 12 + v / 24) ^ 2 * (1 + v / 3 + v ^ 2 / 9) + (1 / 12 + v / 24) * (1 / 6 + v / 9) + 1 / 24 + b / 12 + b * v / 36)) by field.
        rewrite (Rmult_comm (37 / 100)); apply Rmult_le_compat_l; [nra |]; clear - V B B1; interval with (i_bisect v).
  - intros X; nra.
Qed.
End Low.
(* The ratio from above, with 1 + 2 p = sqrt (1 + b e^2 / a): it is at most (1 + p) (1 + e^2 eta). *)
Section Up.
Variables b p v : R.
Let j := / (1 + p).
Let W := 1 + 2 * p.
Definition up_gap : R := p / (3 * W) + j / 4 - 1 / 3 + 75 / 1000 * v.
Definition up_gain : R := p * j / 5 + up_gap * (1 + v * (p * j) / 5).
Definition up_power : R := b * j / 2 * (1 + v * up_gain).
Definition up_first : R := up_power * (1 + v * up_power * (1 / 2 + v / 8)).
Definition up_second : R := 1 / 6 + v * (7 / 360 + v / 450).
Definition up_third : R := - (p * (1 / 3 - 2 * v / 45) / W + j * (1 / 4 - v / 48)).
Definition up_both : R := up_third + up_second * (1 + v * up_third).
Definition up_eta : R := up_both + up_first * (1 + v * up_both).
Definition up_rest : R := b * j / 2 * up_gain + up_power ^ 2 * (1 / 2 + v / 8) + 7 / 360 + v / 450 + 2 * p / (45 * W) + j / 48
  + up_second * up_third + up_first * up_both.
Definition up_slope (R0 : R) : R := R0 / 4 + b * (2 + 15 / 10 * p) + (- (5 + p * (7 + 3 * p)) / 12 + (1 + p) * (1 + 3 * p) / 4 - (1 + p) ^ 2 * (1 + 3 * p) / (3 * W)).
(* What the excess is at most over e^4, times the square of the ratio, where b / a <= R0. *)
Definition up_second_order (R0 : R) : R := (1 + p) ^ 2 * (1 + v * up_eta) ^ 2 * (j / 8 * R0 * (up_slope R0 + Rabs (up_slope R0))
  + (1 + p) ^ 2 * ((1 + 3 * p) * up_rest + up_eta ^ 2 * (2 + 3 * p + v * (1 + p) * up_eta))).
Hypotheses (P0 : 0 <= p).
Lemma up_eta_is : (1 + v * up_first) * (1 + v * up_second) * (1 + v * up_third) = 1 + v * up_eta.
Proof. unfold up_eta, up_both; ring. Qed.
Lemma up_excess r : r * v = 4 * p * (1 + p) ->
  ((1 + p) * (1 + v * up_eta) - 1) * ((1 + p) * (1 + v * up_eta)) ^ 2 - (b * v / 2 + r * v / 4 - v / 12)
  = v ^ 2 * (j / 4 * r * up_slope r + (1 + p) ^ 2 * ((1 + 3 * p) * up_rest + up_eta ^ 2 * (2 + 3 * p + v * (1 + p) * up_eta))).
Proof.
  intros E.
  assert (EP : v * r * j / 4 = p) by (replace (v * r * j / 4) with (r * v * (j / 4)) by field; rewrite E; unfold j; field; lra).
  assert (EE : up_eta = b / 2 - 1 / 12 + p * (j * (1 / 4 - b / 2) - / (3 * W)) + v * up_rest).
  { assert (F : up_first + (up_second + up_third) = b / 2 - 1 / 12 + p * (j * (1 / 4 - b / 2) - / (3 * W))
      + v * (b * j / 2 * up_gain + up_power ^ 2 * (1 / 2 + v / 8) + 7 / 360 + v / 450 + 2 * p / (45 * W) + j / 48)).
    { replace up_first with (b * j / 2 * (1 + v * up_gain) + v * (up_power ^ 2 * (1 / 2 + v / 8)))
        by (change (b * j / 2 * (1 + v * up_gain)) with up_power; unfold up_first; ring).
      set (g := up_gain); set (y := up_power); clearbody g y; unfold up_second, up_third, j, W; field; lra. }
    replace up_eta with (up_first + (up_second + up_third) + v * (up_second * up_third + up_first * up_both)) by (unfold up_eta, up_both; ring).
    unfold up_rest; rewrite F; ring. }
  replace (r * v / 4) with (p * (1 + p)) by lra.
  replace (v ^ 2 * (j / 4 * r * up_slope r + (1 + p) ^ 2 * ((1 + 3 * p) * up_rest + up_eta ^ 2 * (2 + 3 * p + v * (1 + p) * up_eta))))
    with (v * r * j / 4 * (v * up_slope r) + (1 + p) ^ 2 * ((1 + 3 * p) * (v * (v * up_rest)) + (v * up_eta) ^ 2 * (2 + 3 * p) + (1 + p) * (v * up_eta) ^ 3)) by field.
  rewrite EP; replace (v * (v * up_rest)) with (v * (up_eta - (b / 2 - 1 / 12 + p * (j * (1 / 4 - b / 2) - / (3 * W))))) by (rewrite EE; ring).
  unfold up_slope; replace (v * (r / 4 + b * (2 + 15 / 10 * p) + (- (5 + p * (7 + 3 * p)) / 12 + (1 + p) * (1 + 3 * p) / 4 - (1 + p) ^ 2 * (1 + 3 * p) / (3 * W))))
    with (p * (1 + p) + v * (b * (2 + 15 / 10 * p) + (- (5 + p * (7 + 3 * p)) / 12 + (1 + p) * (1 + 3 * p) / 4 - (1 + p) ^ 2 * (1 + 3 * p) / (3 * W)))) by lra.
  set (x := up_eta); clearbody x; unfold j, W; field; lra.
Qed.
End Up.
Lemma root_series x : 0 <= x -> x <= 1 -> 1 - x / 2 - x ^ 2 / 2 <= sqrt (1 - x).
Proof.
  intros X0 X1; apply below_sqrt.
  enough (0 <= x ^ 2 * (3 / 4 - x / 2 - x ^ 2 / 4)) by lra; apply Rmult_le_pos; nra.
Qed.
Section UpBy.
Variables a b e p : R.
Hypotheses (A : 0 < a) (B : 0 < b) (B1 : b <= 1) (E0 : 0 < e) (E1 : e ^ 2 <= 17 / 100) (P0 : 0 <= p) (P1 : p <= 11 / 10).
Let r := b * / a.
Let v := e ^ 2.
Hypothesis RV : r * v = 4 * p * (1 + p).
Let w := root_of a b e.
Let j := / (1 + p).
Let W := 1 + 2 * p.
Let m := / (1 + p) * (((1 + 2 * p) * (4 * p * (1 + p) / (3 * (1 + 2 * p) ^ 2)) + 1) / 4 + v * (1 + 2 * p) * (4 * p * (1 + p) / (3 * (1 + 2 * p) ^ 2)) ^ 2 / 4).
Lemma up_signs : 0 < v <= 17 / 100 /\ 0 < j <= 1 /\ j * (1 + p) = 1 /\ 1 <= W /\ 0 < e <= 42 / 100 /\ e < PI / 2 /\ 0 < m <= 26 / 100.
Proof.
  assert (J : 0 < j) by (unfold j; positive); assert (JP : j * (1 + p) = 1) by (unfold j; field; lra).
  pose proof pi_between; assert (V : 0 < v <= 17 / 100) by (unfold v; nra); assert (EE : e <= 42 / 100) by (destruct (Rle_or_lt e (42 / 100)); [assumption | unfold v in V; nra]).
  repeat split; try assumption; try lra; try nra; try (unfold W; lra).
  - unfold m; clear - V P0 P1; assert (0 < / (1 + p)) by positive.
    assert (0 <= 4 * p * (1 + p) / (3 * (1 + 2 * p) ^ 2)) by (unfold Rdiv; apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra]).
    set (z := 4 * p * (1 + p) / (3 * (1 + 2 * p) ^ 2)) in *; pose proof (pow2_ge_0 z).
    assert (0 <= (1 + 2 * p) * z) by nra; assert (0 <= v * (1 + 2 * p) * z ^ 2) by (apply Rmult_le_pos; nra); nra.
  - unfold m; clear - V P0 P1; interval with (i_bisect p).
Qed.
Lemma sum_low : 2 * (1 + p) * (1 - v * m) <= w + cos e.
Proof.
  destruct up_signs as [V [J [JP [W1 [EE [EP M]]]]]]; pose proof (parts_signs a b e A B E0 EP) as [S [C [R0 [_ [W2 _]]]]]; fold w r in R0, W2.
  destruct (sine_square_between e E0 ltac:(lra)) as [[L _] _]; fold v in L; pose proof (cosine_least e ltac:(lra)) as CL; fold v in CL.
  assert (WW : W ^ 2 = 1 + r * v) by (unfold W; rewrite RV; ring).
  set (z := 4 * p * (1 + p) / (3 * W ^ 2)).
  assert (Z0 : 0 <= z) by (unfold z, Rdiv; apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; nra]).
  assert (Z : z * (3 * W ^ 2) = 4 * p * (1 + p)) by (unfold z; field; lra).
  assert (Z1 : z <= 1 / 3) by (assert (4 * p * (1 + p) <= W ^ 2) by (unfold W; nra); nra).
  assert (X : 0 <= v * z <= 1) by nra.
  assert (N : W * (1 - v * z / 2 - (v * z) ^ 2 / 2) <= w).
  { pose proof (root_series (v * z) (proj1 X) (proj2 X)) as Q; apply Rle_trans with (W * sqrt (1 - v * z)); [nra |].
    assert (Q2 : sqrt (1 - v * z) ^ 2 = 1 - v * z) by (apply pow2_sqrt; lra).
    unfold w, root_of; apply below_sqrt; rewrite Rpow_mult_distr, Q2; fold r.
    replace (W ^ 2 * (1 - v * z)) with (W ^ 2 - v / 3 * (z * (3 * W ^ 2))) by field; rewrite Z, <- RV, WW; nra. }
  replace (2 * (1 + p) * (1 - v * m)) with (W * (1 - v * z / 2 - (v * z) ^ 2 / 2) + (1 - v / 2)); [lra |].
  unfold m; fold W; fold z; unfold W; field; lra.
Qed.
Lemma share_up : sin e ^ 2 / (w + cos e) <= v * j / 2 * (1 + v * up_gap p v) /\ up_gap p v <= 0.
Proof.
  destruct up_signs as [V [J [JP [W1 [EE [EP M]]]]]]; pose proof sum_low as S.
  pose proof (parts_signs a b e A B E0 EP) as [S0 [C [R0 [W0 _]]]]; fold w in W0.
  destruct (sine_square_between e E0 ltac:(lra)) as [[_ L] _]; fold v in L; unfold up_time in L.
  split.
  - set (z := v * m) in *; assert (Z : 0 < z <= 6 / 100) by (unfold z; nra).
    assert (I : / (w + cos e) <= j / 2 * (1 + z + 12 / 10 * z ^ 2)).
    { apply (Rmult_le_reg_r (w + cos e)); [lra |]; rewrite Rinv_l by lra.
      apply Rle_trans with (j / 2 * (1 + z + 12 / 10 * z ^ 2) * (2 * (1 + p) * (1 - z))).
      - replace (j / 2 * (1 + z + 12 / 10 * z ^ 2) * (2 * (1 + p) * (1 - z))) with (j * (1 + p) * (1 + z ^ 2 * (2 / 10 - 12 / 10 * z))) by field.
        rewrite JP; assert (0 <= z ^ 2 * (2 / 10 - 12 / 10 * z)) by (apply Rmult_le_pos; nra); lra.
      - apply Rmult_le_compat_l; [nra | exact S]. }
    apply Rle_trans with (v * (1 - v / 3 + 2 * v ^ 2 / 45) * (j / 2 * (1 + z + 12 / 10 * z ^ 2))).
    { unfold Rdiv at 1; apply Rmult_le_compat; try nra; left; positive. }
    replace (v * (1 - v / 3 + 2 * v ^ 2 / 45) * (j / 2 * (1 + z + 12 / 10 * z ^ 2)))
      with (v * j / 2 * ((1 - v / 3 + 2 * v ^ 2 / 45) * (1 + z + 12 / 10 * z ^ 2))) by field.
    apply Rmult_le_compat_l; [nra |]; unfold z, up_gap; fold j W.
    assert (MU : m <= p / (3 * W) + j / 4 + 35 / 1000 * v).
    { replace m with (p / (3 * W) + j / 4 + v * (4 * p ^ 2 * (1 + p) / (9 * W ^ 3))) by (unfold m, j, W; field; lra).
      assert (4 * p ^ 2 * (1 + p) / (9 * W ^ 3) <= 35 / 1000); [unfold W; clear - P0 P1; interval with (i_bisect p) | nra]. }
    enough (m - 1 / 3 + v * (2 / 45 + 12 / 10 * m ^ 2 - m / 3 + v * m * (2 / 45 - 4 / 10 * m + v * m * (12 / 10 * (2 / 45)))) <= p / (3 * W) + j / 4 - 1 / 3 + 75 / 1000 * v) by nra.
    assert (ML : 16 / 100 <= m).
    { unfold m; clear - V P0 P1; assert (0 <= v) by lra.
      apply Rle_trans with (/ (1 + p) * (((1 + 2 * p) * (4 * p * (1 + p) / (3 * (1 + 2 * p) ^ 2)) + 1) / 4)); [interval with (i_bisect p) |].
      assert (0 < / (1 + p)) by positive; apply Rmult_le_compat_l; [lra |].
      assert (0 <= v * (1 + 2 * p) * (4 * p * (1 + p) / (3 * (1 + 2 * p) ^ 2)) ^ 2) by (apply Rmult_le_pos; [nra | apply pow2_ge_0]); lra. }
    assert (2 / 45 + 12 / 10 * m ^ 2 - m / 3 + v * m * (2 / 45 - 4 / 10 * m + v * m * (12 / 10 * (2 / 45))) <= 40 / 1000) by (clear - V M ML; interval with (i_bisect m)).
    nra.
  - unfold up_gap; clear - V P0 P1; interval with (i_bisect p, i_bisect v).
Qed.
Lemma sum_up : 1 / 2 * w + 1 / 2 * cos e <= (1 + p) * (1 + v * up_third p v).
Proof.
  destruct up_signs as [V [J [JP [W1 [EE [EP M]]]]]]; pose proof (parts_signs a b e A B E0 EP) as [S [C [R0 [W0 [W2 _]]]]]; fold w r in R0, W0, W2.
  destruct (sine_square_between e E0 ltac:(lra)) as [[_ L] _]; fold v in L; unfold up_time in L.
  destruct (small_sine e) as [_ [_ G]]; try lra; replace (e ^ 4) with (v ^ 2) in G by (unfold v; ring); fold v in G.
  assert (WW : W ^ 2 = 1 + r * v) by (unfold W; rewrite RV; ring).
  assert (N : w <= W - r * (v ^ 2 * (1 / 3 - 2 * v / 45)) / (2 * W)).
  { set (d := r * (v ^ 2 * (1 / 3 - 2 * v / 45))).
    assert (D : w ^ 2 <= W ^ 2 - d) by (rewrite W2, WW; unfold d; nra).
    assert (K : d / (2 * W) * (2 * W) = d) by (field; lra); set (x := d / (2 * W)) in *.
    assert (XW : x <= W / 2) by (assert (0 <= w ^ 2) by apply pow2_ge_0; nra); destruct (Rle_or_lt w (W - x)) as [H|H]; [exact H | exfalso].
    assert ((W - x) ^ 2 < w ^ 2) by nra; pose proof (pow2_ge_0 x); nra. }
  replace (r * (v ^ 2 * (1 / 3 - 2 * v / 45)) / (2 * W)) with (r * v * (v * (1 / 3 - 2 * v / 45)) / (2 * W)) in N by (field; lra).
  rewrite RV in N; unfold up_third; fold j W.
  apply Rle_trans with (1 / 2 * (W - 4 * p * (1 + p) * (v * (1 / 3 - 2 * v / 45)) / (2 * W)) + 1 / 2 * (1 - v / 2 + v ^ 2 / 24)); [lra |].
  right; unfold j, W; field; lra.
Qed.
Lemma quotient_up : e * / sin e <= 1 + v * up_second v.
Proof.
  destruct up_signs as [V [_ [_ [_ [EE [EP _]]]]]]; pose proof pi_between as PB; assert (S : 0 < sin e) by (apply sin_gt_0; lra).
  destruct (pre_sin_bound e 1) as [X _]; try lra; unfold sin_approx, sin_term in X; cbn in X.
  set (g := 1 - v / 6 + v ^ 2 / 120 - v ^ 3 / 5040).
  assert (G : e * g <= sin e) by (eapply Rle_trans; [| exact X]; right; unfold g, v; field).
  apply (Rmult_le_reg_r (sin e)); [exact S |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; unfold up_second.
  set (q := 1 + v * (1 / 6 + v * (7 / 360 + v / 450))); assert (Q : 1 <= q) by (unfold q; assert (0 <= 7 / 360 + v / 450) by lra; nra).
  apply Rle_trans with (q * (e * g)); [| nra].
  enough (1 <= q * g) by nra; unfold q, g.
  replace ((1 + v * (1 / 6 + v * (7 / 360 + v / 450))) * (1 - v / 6 + v ^ 2 / 120 - v ^ 3 / 5040))
    with (1 + v ^ 3 * (13 / 75600 + v * (- 73 / 302400 + v * (19 / 1296000 - v / 2268000)))) by field.
  assert (0 <= v ^ 3 * (13 / 75600 + v * (- 73 / 302400 + v * (19 / 1296000 - v / 2268000)))); [| lra].
  apply Rmult_le_pos; [apply pow_le; lra | clear - V; interval].
Qed.
End UpBy.
Lemma ratio_up a b e p : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e ^ 2 <= 17 / 100 -> 0 <= p -> p <= 11 / 10 ->
  b * / a * e ^ 2 = 4 * p * (1 + p) -> exp (exponent a b e) <= (1 + p) * (1 + e ^ 2 * up_eta b p (e ^ 2)).
Proof.
  intros A B B1 E0 E1 P0 P1 RV; destruct (up_signs e p E0 E1 P0 P1) as [V [J [JP [_ [EE [EP _]]]]]].
  destruct (share_up a b e p A B E0 E1 P0 P1 RV) as [S1 S2]; pose proof (sum_up a b e p A B E0 E1 P0 P1 RV) as S3; pose proof (quotient_up e p E0 E1 P0 P1) as S4.
  destruct (parts_signs a b e A B E0 EP) as [S [C [R0 [W0 [W2 C2]]]]].
  assert (EX : exp (exponent a b e) = exp (sqrt (a * b) * asin (sqrt (b * / a) * / (root_of a b e + cos e) * sin e ^ 2)) * (e * / sin e) * (1 / 2 * root_of a b e + 1 / 2 * cos e)).
  { unfold exponent; rewrite (turn_parts a b e A B E0 EP), !exp_plus, !exp_ln by (first [lra | positive]); reflexivity. }
  rewrite EX; clear EX; rewrite <- up_eta_is; set (w := root_of a b e) in *; set (r := b * / a) in *; set (v := e ^ 2) in *; set (j := / (1 + p)) in *.
  assert (Z : 0 < sqrt r) by (apply sqrt_lt_R0; exact R0); assert (Z2 : sqrt r ^ 2 = r) by (apply pow2_sqrt; lra).
  set (h := sin e ^ 2 / (w + cos e)) in *; assert (H0 : 0 < h) by (unfold h, Rdiv; positive).
  set (g := up_gap p v) in *; assert (H1 : h <= v * j / 2) by (assert (0 <= v * j / 2) by nra; assert (v * g <= 0) by nra; nra).
  replace (sqrt r * / (w + cos e) * sin e ^ 2) with (sqrt r * h) by (unfold h; field; lra); set (y := sqrt r * h).
  assert (Y0 : 0 < y) by (unfold y; positive).
  assert (Y2 : y ^ 2 <= v * (p * j)).
  { unfold y; rewrite Rpow_mult_distr, Z2; apply Rle_trans with (r * (v * j / 2) ^ 2); [apply Rmult_le_compat_l; [lra | apply pow_incr; lra] |].
    replace (r * (v * j / 2) ^ 2) with (r * v * (v * j ^ 2 / 4)) by field; rewrite RV.
    replace (4 * p * (1 + p) * (v * j ^ 2 / 4)) with (v * (p * j) * (j * (1 + p))) by field; rewrite JP; lra. }
  assert (PJ : 0 <= p * j <= 11 / 21).
  { split; [nra |]; apply (Rmult_le_reg_r (1 + p)); [lra |]; rewrite Rmult_assoc, JP; lra. }
  assert (Y3 : y <= 3 / 10) by nra; pose proof (asin_near y ltac:(lra) Y3) as N; pose proof (asin_above y Y0) as N0.
  assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive); assert (KY : sqrt (a * b) * y = b * h).
  { pose proof (product_root a b A B) as PR; fold r in PR; unfold y; rewrite <- Rmult_assoc, PR; reflexivity. }
  assert (X : sqrt (a * b) * asin y <= v * up_power b p v).
  { apply Rle_trans with (b * h * (1 + v * (p * j) / 5)).
    - apply Rle_trans with (sqrt (a * b) * (y * (1 + y ^ 2 / 5))); [apply Rmult_le_compat_l; lra |].
      rewrite <- Rmult_assoc, KY; apply Rmult_le_compat_l; [left; positive | lra].
    - unfold up_power, up_gain; fold j g; apply Rle_trans with (b * (v * j / 2 * (1 + v * g)) * (1 + v * (p * j) / 5)); [| right; field].
      apply Rmult_le_compat_r; [nra |]; apply Rmult_le_compat_l; lra. }
  assert (X0 : 0 <= sqrt (a * b) * asin y) by (left; positive).
  assert (X1 : v * up_power b p v <= 1 / 2).
  { unfold up_power, up_gain; fold j g; replace (v * (b * j / 2 * (1 + v * (p * j / 5 + g * (1 + v * (p * j) / 5)))))
      with (b * (v * j / 2 * (1 + v * g)) * (1 + v * (p * j) / 5)) by field.
    assert (0 <= v * j / 2 * (1 + v * g) <= 17 / 200) by (split; [lra |]; assert (v * j / 2 <= 17 / 200) by nra; assert (0 <= v * j / 2) by nra; assert (v * g <= 0) by nra; assert (v * j / 2 * (v * g) <= 0) by nra; lra).
    set (q := v * j / 2 * (1 + v * g)) in *; assert (0 <= b * q <= 17 / 200) by nra; nra. }
  set (q := up_power b p v) in *; assert (F : exp (sqrt (a * b) * asin y) <= 1 + v * up_first b p v).
  { eapply Rle_trans; [apply exp_near; lra |]; set (x := sqrt (a * b) * asin y) in *.
    assert (QQ : q <= 5 / 8).
    { unfold q, up_power; fold j; unfold up_gain; fold j g.
      assert (p * j / 5 + g * (1 + v * (p * j) / 5) <= 11 / 105) by (assert (0 <= v * (p * j)) by nra; nra).
      assert (0 < b * j <= 1) by nra; set (n := p * j / 5 + g * (1 + v * (p * j) / 5)) in *; assert (v * n <= 17 / 100 * (11 / 105)) by nra; nra. }
    assert (QP : 0 <= v * q) by lra.
    unfold up_first; fold q; apply Rle_trans with (1 + v * q + (v * q) ^ 2 / 2 + (v * q) ^ 3 / 5).
    2: { replace (1 + v * (q * (1 + v * q * (1 / 2 + v / 8)))) with (1 + v * q + (v * q) ^ 2 / 2 + (v * q) ^ 2 * (v / 8)) by field.
      apply Rplus_le_compat_l; replace ((v * q) ^ 3 / 5) with ((v * q) ^ 2 * (v * q / 5)) by field; apply Rmult_le_compat_l; [apply pow2_ge_0 | nra]. }
    assert (x ^ 2 <= (v * q) ^ 2) by (apply pow_incr; lra); assert (x ^ 3 <= (v * q) ^ 3) by (apply pow_incr; lra); lra. }
  pose proof (exp_pos (sqrt (a * b) * asin y)); assert (0 < e * / sin e) by positive; assert (0 < 1 / 2 * w + 1 / 2 * cos e) by lra.
  replace ((1 + p) * ((1 + v * up_first b p v) * (1 + v * up_second v) * (1 + v * up_third p v)))
    with ((1 + v * up_first b p v) * (1 + v * up_second v) * ((1 + p) * (1 + v * up_third p v))) by ring.
  apply Rmult_le_compat; [left; positive | lra | | exact S3]; apply Rmult_le_compat; lra.
Qed.
Definition within_second (K a b e : R) : Prop := Rabs (excess a b e) * exp (exponent a b e) ^ 2 <= K * (e ^ 2) ^ 2.
Lemma second_of_leading a b c e s K : c = first_term a b -> 0 < e -> s = e * exp ((-1) * exponent a b e) -> within_second K a b e ->
  Rabs (c * s ^ 2 + (-1) * e * / s + 1) <= K * s ^ 4.
Proof.
  intros C E0 S W; rewrite C, S; clear C S; unfold within_second, excess in W.
  replace ((-1) * exponent a b e) with (- exponent a b e) by ring; rewrite exp_Ropp.
  pose proof (exp_pos (exponent a b e)) as P; set (x := exp (exponent a b e)) in *; set (t := first_term a b) in *.
  replace (t * (e * / x) ^ 2 + (-1) * e * / (e * / x) + 1) with (- (((x - 1) * x ^ 2 - t * e ^ 2) * / x ^ 2)) by (field; lra).
  assert (X2 : 0 < x ^ 2) by (apply pow_lt; exact P); assert (I : 0 < / x ^ 2) by (apply Rinv_0_lt_compat; exact X2).
  rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (/ x ^ 2)) by lra; set (q := Rabs _) in *.
  apply (Rmult_le_reg_r (x ^ 4)); [apply pow_lt; exact P |].
  replace (q * / x ^ 2 * x ^ 4) with (q * x ^ 2) by (field; lra).
  replace (K * (e * / x) ^ 4 * x ^ 4) with (K * (e ^ 2) ^ 2) by (field; lra); exact W.
Qed.
Lemma within_sides a b e K : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e < PI / 2 ->
  37 / 100 * exp (exponent a b e) ^ 2 <= K -> excess a b e * exp (exponent a b e) ^ 2 <= K * (e ^ 2) ^ 2 -> within_second K a b e.
Proof.
  intros A B B1 E0 E1 L U; destruct (ratio_low a b e A B B1 E0 E1) as [H _]; unfold within_second.
  pose proof (exp_pos (exponent a b e)) as P; set (x := exp (exponent a b e)) in *; assert (X : 0 < x ^ 2) by (apply pow_lt; exact P).
  assert (0 <= (e ^ 2) ^ 2) by apply pow2_ge_0; unfold Rabs; destruct (Rcase_abs (excess a b e)) as [N|N]; [| exact U].
  apply Rle_trans with (37 / 100 * (e ^ 2) ^ 2 * x ^ 2); [apply Rmult_le_compat_r; lra | nra].
Qed.
Lemma negative_second a b e K : 0 < a -> 0 < b -> b <= 1 -> 0 < e -> e < PI / 2 -> 37 / 100 <= K -> first_term a b <= 0 -> within_second K a b e.
Proof.
  intros A B B1 E0 E1 K0 C; pose proof (exponent_first a b e A B B1 E0 E1) as F.
  destruct (ratio_low a b e A B B1 E0 E1) as [_ H]; pose proof (square_at_most b e B B1 E0 E1) as V.
  assert (X : exp (exponent a b e) <= 1) by (rewrite <- exp_0; apply exp_rises; nra).
  assert (D : - (1 / 12) <= first_term a b) by (unfold first_term; assert (0 < b * / a) by positive; lra).
  pose proof (exp_pos (exponent a b e)) as P; apply within_sides; try assumption; [assert (exp (exponent a b e) ^ 2 <= 1) by nra; lra |].
  unfold excess; set (v := e ^ 2) in *; set (c := first_term a b) in *.
  assert (T : exp (exponent a b e) <= 1 + c * v + (c * v) ^ 2 / 2).
  { apply Rle_trans with (exp (c * v)); [apply exp_rises, F |]; pose proof (exp_above_square (- (c * v)) ltac:(nra)) as G.
    rewrite exp_Ropp in G; pose proof (exp_pos (c * v)) as Z; set (z := exp (c * v)) in *; set (y := - (c * v)) in *.
    replace (c * v) with (- y) by (unfold y; ring); assert (Y : 0 <= y) by (unfold y; nra).
    assert (Q : (1 + y + y ^ 2 / 2) * z <= 1) by (apply (Rmult_le_compat_r z) in G; [rewrite Rinv_l in G by lra; exact G | lra]).
    apply (Rmult_le_reg_l (1 + y + y ^ 2 / 2)); [nra |].
    replace ((1 + y + y ^ 2 / 2) * (1 + - y + (- y) ^ 2 / 2)) with (1 + (y ^ 2) ^ 2 / 4) by field; pose proof (pow2_ge_0 (y ^ 2)); lra. }
  assert (Y : 1 - exp (exponent a b e) <= v * (1 / 12 + v / 24)) by (destruct (Rle_lt_or_eq_dec _ _ X) as [L|L]; [exact (H L) | rewrite L; nra]).
  set (x := exp (exponent a b e)) in *; assert (Z : 1 - x <= v * (19 / 100)) by nra.
  assert (Q : (1 - x) ^ 2 <= (v * (19 / 100)) ^ 2) by (apply pow_incr; lra).
  assert (U : (x - 1) * x ^ 2 - c * v <= 1 / 10 * v ^ 2).
  { assert ((x - 1) * x ^ 2 <= (x - 1) + 2 * (1 - x) ^ 2) by (assert (0 <= (1 - x) * (1 - x) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]); nra).
    assert ((c * v) ^ 2 <= v ^ 2 / 144) by (assert (0 <= - (c * v) <= v / 12) by nra; nra); nra. }
  assert (W : 0 < x ^ 2 <= 1) by nra; assert (0 <= v ^ 2) by apply pow2_ge_0; destruct (Rle_or_lt ((x - 1) * x ^ 2 - c * v) 0); nra.
Qed.
(* What a bound y of the ratio says. *)
Lemma second_by a b e y K : 0 <= first_term a b -> 0 <= K -> exp (exponent a b e) <= y ->
  ((y - 1) * y ^ 2 - first_term a b * e ^ 2) * y ^ 2 <= K * (e ^ 2) ^ 2 -> excess a b e * exp (exponent a b e) ^ 2 <= K * (e ^ 2) ^ 2.
Proof.
  intros C K0 Y H; unfold excess; pose proof (exp_pos (exponent a b e)) as P; set (x := exp (exponent a b e)) in *; set (c := first_term a b) in *.
  assert (V : 0 <= e ^ 2) by nra; set (v := e ^ 2) in *.
  assert (I : 0 < / y <= / x) by (split; [apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]).
  assert (G : y - 1 <= c * v * (/ y) ^ 2 + K * v ^ 2 * ((/ y) ^ 2) ^ 2).
  { apply (Rmult_le_reg_r (y ^ 4)); [apply pow_lt; lra |].
    replace ((c * v * (/ y) ^ 2 + K * v ^ 2 * ((/ y) ^ 2) ^ 2) * y ^ 4) with (c * v * y ^ 2 + K * v ^ 2) by (field; lra); lra. }
  assert (S : (/ y) ^ 2 <= (/ x) ^ 2) by (apply pow_incr; lra); assert (S1 : 0 <= (/ y) ^ 2) by apply pow2_ge_0.
  assert (S2 : ((/ y) ^ 2) ^ 2 <= ((/ x) ^ 2) ^ 2) by (apply pow_incr; lra).
  assert (L : x - 1 <= c * v * (/ x) ^ 2 + K * v ^ 2 * ((/ x) ^ 2) ^ 2).
  { assert (c * v * (/ y) ^ 2 <= c * v * (/ x) ^ 2) by (apply Rmult_le_compat_l; nra).
    assert (K * v ^ 2 * ((/ y) ^ 2) ^ 2 <= K * v ^ 2 * ((/ x) ^ 2) ^ 2) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; nra | exact S2]); lra. }
  apply (Rmult_le_compat_r (x ^ 4)) in L; [| left; apply pow_lt; exact P].
  replace ((c * v * (/ x) ^ 2 + K * v ^ 2 * ((/ x) ^ 2) ^ 2) * x ^ 4) with (c * v * x ^ 2 + K * v ^ 2) in L by (field; lra); lra.
Qed.
(* Cells y <= b <= z of a >= x, where the defect is at most c. *)
Lemma first_at_most a b x z : 0 < x -> x <= a -> 0 < b -> b <= z -> b * / a <= z / x /\ first_term a b <= 1 / 2 * z + 1 / 4 * (z / x) - 1 / 12.
Proof.
  intros X A B Z; assert (H : b * / a <= z / x).
  { unfold Rdiv; apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]. }
  split; [exact H | unfold first_term; lra].
Qed.
Lemma second_in a b e x z P m K : 0 < x -> x <= a -> 0 < b -> b <= z -> b <= 1 -> 0 < e -> e < PI / 2 ->
  e ^ 2 <= m -> m <= 17 / 100 -> 1 + z / x * m <= (1 + 2 * P) ^ 2 -> 0 <= P -> P <= 11 / 10 -> 37 / 100 <= K ->
  37 / 100 * exp (2 * ((1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) * m)) <= K ->
  (forall p v, 0 <= p <= P -> 0 <= v <= m -> up_second_order b p v (z / x) <= K) -> within_second K a b e.
Proof.
  intros X A B Z B1 E0 E1 M M1 PM P0 P1 K0 L H.
  destruct (first_at_most a b x z X A B Z) as [R1 C1]; assert (A0 : 0 < a) by lra; assert (R0 : 0 < b * / a) by positive.
  destruct (Rle_or_lt (first_term a b) 0) as [C|C]; [apply negative_second; assumption |].
  assert (V : 0 < e ^ 2) by nra; set (p := (sqrt (1 + b * / a * e ^ 2) - 1) / 2).
  assert (S1 : 1 <= sqrt (1 + b * / a * e ^ 2)) by (apply below_sqrt; nra).
  assert (S2 : sqrt (1 + b * / a * e ^ 2) ^ 2 = 1 + b * / a * e ^ 2) by (apply pow2_sqrt; nra).
  assert (RM : b * / a * e ^ 2 <= z / x * m) by (apply Rmult_le_compat; lra).
  assert (S3 : sqrt (1 + b * / a * e ^ 2) <= 1 + 2 * P) by (apply above_sqrt; lra).
  assert (PB : 0 <= p <= P) by (unfold p; lra).
  assert (RV : b * / a * e ^ 2 = 4 * p * (1 + p)) by (unfold p; lra).
  pose proof (ratio_up a b e p A0 B B1 E0 ltac:(lra) ltac:(lra) ltac:(lra) RV) as U.
  specialize (H p (e ^ 2) PB ltac:(lra)).
  apply within_sides; try assumption.
  - eapply Rle_trans; [| exact L]; apply Rmult_le_compat_l; [lra |].
    replace (exp (exponent a b e) ^ 2) with (exp (exponent a b e) * exp (exponent a b e)) by ring; rewrite <- exp_plus; apply exp_rises.
    pose proof (exponent_first a b e A0 B B1 E0 E1) as F.
    assert (first_term a b * e ^ 2 <= (1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) * m) by (apply Rmult_le_compat; lra); lra.
  - apply (second_by a b e ((1 + p) * (1 + e ^ 2 * up_eta b p (e ^ 2)))); [lra | lra | exact U |].
    replace (first_term a b * e ^ 2) with (b * e ^ 2 / 2 + b * / a * e ^ 2 / 4 - e ^ 2 / 12) by (unfold first_term; field; lra).
    rewrite (up_excess b p (e ^ 2) (proj1 PB) (b * / a) RV).
    set (v := e ^ 2) in *; set (r := b * / a) in *; set (t := up_eta b p v) in *.
    assert (J : 0 < / (1 + p)) by (apply Rinv_0_lt_compat; lra).
    assert (G : / (1 + p) / 4 * r * up_slope b p r <= / (1 + p) / 8 * (z / x) * (up_slope b p (z / x) + Rabs (up_slope b p (z / x)))).
    { assert (up_slope b p r <= up_slope b p (z / x)) by (unfold up_slope; lra); set (s := up_slope b p r) in *; set (y := up_slope b p (z / x)) in *.
      set (j := / (1 + p)) in *; replace (j / 4 * r * s) with (j / 4 * (r * s)) by field.
      replace (j / 8 * (z / x) * (y + Rabs y)) with (j / 4 * (z / x * ((y + Rabs y) / 2))) by (field; lra); apply Rmult_le_compat_l; [lra |].
      pose proof (Rle_abs y); assert (0 <= y + Rabs y) by (pose proof (Rle_abs (- y)) as Q; rewrite Rabs_Ropp in Q; lra).
      destruct (Rle_or_lt s 0); [assert (0 <= z / x * ((y + Rabs y) / 2)) by (apply Rmult_le_pos; lra); assert (r * s <= 0) by nra; lra | apply Rmult_le_compat; lra]. }
    unfold up_second_order in H; fold t in H.
    set (q := (1 + p) ^ 2 * ((1 + 3 * p) * up_rest b p v + t ^ 2 * (2 + 3 * p + v * (1 + p) * t))) in *.
    replace (((1 + p) * (1 + v * t)) ^ 2) with ((1 + p) ^ 2 * (1 + v * t) ^ 2) by ring.
    assert (N : 0 <= (1 + p) ^ 2 * (1 + v * t) ^ 2) by (rewrite <- Rpow_mult_distr; apply pow2_ge_0).
    set (n := (1 + p) ^ 2 * (1 + v * t) ^ 2) in *.
    replace (v ^ 2 * (/ (1 + p) / 4 * r * up_slope b p r + q) * n) with (n * (/ (1 + p) / 4 * r * up_slope b p r + q) * v ^ 2) by ring.
    apply Rmult_le_compat_r; [apply pow2_ge_0 |]; eapply Rle_trans; [| exact H]; apply Rmult_le_compat_l; lra.
Qed.
Lemma second_cell a b e x y z c P m K : 0 < x -> x <= a -> 0 < y -> y <= b -> b <= z -> z <= 1 -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  0 < c -> c < PI / 2 -> c ^ 2 <= m -> 0 <= turn_short x y c -> m <= 17 / 100 -> 1 + z / x * m <= (1 + 2 * P) ^ 2 -> 0 <= P -> P <= 11 / 10 -> 37 / 100 <= K ->
  37 / 100 * exp (2 * ((1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) * m)) <= K ->
  (forall b p v, y <= b <= z -> 0 <= p <= P -> 0 <= v <= m -> up_second_order b p v (z / x) <= K) -> within_second K a b e.
Proof.
  intros X A Y B Z Z1 E0 E1 D C0 C1 M T M1 PM P0 P1 K0 L H.
  pose proof (defect_at_most a b x y c e X A Y B ltac:(lra) E0 E1 D C0 C1 T) as EC.
  apply (second_in a b e x z P m K); try assumption; try lra; [nra |]; intros p v PB VB; apply H; lra.
Qed.
Lemma second_cell_2 a b e x y z c d P m K : 0 < x -> x <= a -> 0 < y -> y <= b -> b <= z -> z <= 1 -> 0 < e -> e < PI / 2 -> is_defect a b e ->
  0 < c -> c < PI / 2 -> 0 < d -> d ^ 2 <= m -> 0 <= turn_short x y c -> m <= 17 / 100 -> 1 + z / x * m <= (1 + 2 * P) ^ 2 -> 0 <= P -> P <= 11 / 10 -> 37 / 100 <= K ->
  37 / 100 * exp (2 * ((1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) * m)) <= K ->
  (forall b p v, y <= b <= z -> 0 <= p <= P -> 0 <= v <= m -> up_second_order b p v (z / x) <= K) ->
  (forall t, d <= t <= c -> 0 <= K * t ^ 4 - (ratio_at x z t - 1) * ratio_at x z t ^ 4 /\ 37 / 100 * ratio_at x z t ^ 2 <= K) -> within_second K a b e.
Proof.
  intros X A Y B Z Z1 E0 E1 D C0 C1 D0 M T M1 PM P0 P1 K0 L H N.
  pose proof (defect_at_most a b x y c e X A Y B ltac:(lra) E0 E1 D C0 C1 T) as EC; assert (A0 : 0 < a) by lra.
  destruct (Rle_or_lt e d) as [G|G].
  { apply (second_in a b e x z P m K); try assumption; try lra; [nra |]; intros p v PB VB; apply H; lra. }
  destruct (Rle_or_lt (first_term a b) 0) as [C|C]; [apply negative_second; try assumption; lra |].
  destruct (N e ltac:(lra)) as [N1 N2]; rewrite <- ratio_at_is in N1, N2 by lra.
  destruct (first_at_most a b x z X A ltac:(lra) Z) as [R1 _].
  pose proof (exponent_grows a b x z e A0 ltac:(lra) X Z Z1 R1 E0 E1) as U; apply exp_rises in U.
  pose proof (exp_pos (exponent a b e)) as Q; set (u := exp (exponent x z e)) in *.
  apply within_sides; try assumption; try lra.
  - eapply Rle_trans; [| exact N2]; apply Rmult_le_compat_l; [lra |]; apply pow_incr; lra.
  - apply (second_by a b e u); [lra | lra | exact U |].
    assert (0 <= first_term a b * e ^ 2) by (apply Rmult_le_pos; [lra | nra]); assert (0 <= u ^ 2) by apply pow2_ge_0.
    replace ((e ^ 2) ^ 2) with (e ^ 4) by ring; apply Rle_trans with ((u - 1) * u ^ 4); [| lra].
    replace ((u - 1) * u ^ 4) with ((u - 1) * u ^ 2 * u ^ 2) by ring; apply Rmult_le_compat_r; lra.
Qed.
Lemma second_flat a b e x z m M K : 0 < x -> x <= a -> 0 < b -> b <= z -> b <= 1 -> 0 < e -> e < PI / 2 -> e ^ 2 <= m ->
  (1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) * m <= M -> 0 <= M -> M <= 4 / 10 -> 37 / 100 * exp (2 * M) <= K -> 37 / 100 <= K ->
  (1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) ^ 2 * exp (2 * M) * (5 / 2 + 19 / 6 * M + 4 * M ^ 2) <= K -> within_second K a b e.
Proof.
  intros X A B Z B1 E0 E1 EM CM M0 M1 L K0 H; assert (A0 : 0 < a) by lra.
  destruct (first_at_most a b x z X A B Z) as [_ C1].
  destruct (Rle_or_lt (first_term a b) 0) as [C|C]; [apply negative_second; assumption |].
  pose proof (exponent_first a b e A0 B B1 E0 E1) as F; set (d := 1 / 2 * z + 1 / 4 * (z / x) - 1 / 12) in *; set (t := first_term a b) in *.
  assert (V : 0 < e ^ 2) by nra; assert (T : 0 <= t * e ^ 2 <= M) by (split; [nra |]; apply Rle_trans with (d * m); [apply Rmult_le_compat; lra | exact CM]).
  assert (X2 : exp (t * e ^ 2) ^ 2 = exp (2 * (t * e ^ 2))) by (replace (2 * (t * e ^ 2)) with (t * e ^ 2 + t * e ^ 2) by ring; rewrite exp_plus; ring).
  assert (X3 : exp (2 * (t * e ^ 2)) <= exp (2 * M)) by (apply exp_rises; lra).
  pose proof (exp_rises _ _ F) as U; pose proof (exp_pos (exponent a b e)) as Q.
  apply within_sides; try assumption.
  - eapply Rle_trans; [| exact L]; apply Rmult_le_compat_l; [lra |].
    apply Rle_trans with (exp (t * e ^ 2) ^ 2); [apply pow_incr; lra | rewrite X2; exact X3].
  - apply (second_by a b e (exp (t * e ^ 2))); [fold t; lra | lra | exact U |]; fold t.
    pose proof (three_near (t * e ^ 2) M (proj1 T) (proj2 T) M1) as W; rewrite <- X2 in W; set (q := 5 / 2 + 19 / 6 * M + 4 * M ^ 2) in *.
    assert (Q0 : 0 < q) by (unfold q; nra); rewrite <- X2 in X3; set (y := exp (t * e ^ 2)) in *; pose proof (exp_pos (2 * M)) as Y0; set (g := exp (2 * M)) in *.
    assert (Y2 : 0 <= y ^ 2) by apply pow2_ge_0; assert (T2 : 0 <= (t * e ^ 2) ^ 2 * q) by (apply Rmult_le_pos; [apply pow2_ge_0 | lra]).
    apply Rle_trans with ((t * e ^ 2) ^ 2 * q * y ^ 2); [apply Rmult_le_compat_r; [exact Y2 | lra] |].
    apply Rle_trans with ((t * e ^ 2) ^ 2 * q * g); [apply Rmult_le_compat_l; lra |].
    replace ((t * e ^ 2) ^ 2 * q * g) with (t ^ 2 * (g * q) * (e ^ 2) ^ 2) by ring; apply Rmult_le_compat_r; [apply pow2_ge_0 |].
    eapply Rle_trans; [| exact H]; rewrite Rmult_assoc; apply Rmult_le_compat_r; [nra | apply pow_incr; lra].
Qed.
Ltac second_bounds := let b := fresh "b" in let p := fresh "p" in let v := fresh "v" in let B := fresh "B" in let P := fresh "P" in let V := fresh "V" in
  intros b p v B P V; unfold up_second_order, up_slope, up_rest, up_eta, up_both, up_first, up_second, up_third, up_power, up_gain, up_gap;
  interval with (i_bisect p, i_bisect v, i_depth 60).
Ltac second_part K a b e E x y z c P m := destruct (Rle_or_lt y b) as [?|?];
  [apply (second_cell a b e x y z c P m K); try lra; [exact E | interval | unfold turn_short; interval with (i_prec 60) | interval | second_bounds] |].
Ltac second_part_beyond K a b e E x y z c d P m := destruct (Rle_or_lt y b) as [?|?];
  [apply (second_cell_2 a b e x y z c d P m K); try lra; [exact E | interval | unfold turn_short; interval with (i_prec 60) | interval | second_bounds
  | let t := fresh "t" in let T := fresh "T" in intros t T; unfold ratio_at; cbv zeta; split; interval with (i_bisect t, i_depth 30)] |].
Ltac second_part_flat K a b e E x y z c m M := destruct (Rle_or_lt y b) as [?|?];
  [apply (second_flat a b e x z m M K); try lra; [assert (e <= c) by (apply (defect_at_most a b x y c e); try exact E; try lra; [interval | unfold turn_short; interval with (i_prec 60)]); nra | interval | interval] |].
Ltac second_rest K a b e x z M :=
  apply (second_flat a b e x z (24675 / 10000) M K); try lra; [assert (PI / 2 <= 1570797 / 1000000) by interval; nra | interval | interval].
