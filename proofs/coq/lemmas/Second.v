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
