(* Lemmas of analysis that proofs apply: roots by their residual, sums, integrals, differential inequalities. *)

(* A root of f is near h if f h is small and the slope is at least m > 0 between them. *)
Lemma root_by_residual (f df : R -> R) x h m g : 0 < m ->
  (forall y, Rmin h x <= y <= Rmax h x -> is_derive f y (df y)) ->
  (forall y, Rmin h x <= y <= Rmax h x -> m <= df y) ->
  f x = 0 -> Rabs (f h) <= m * g -> Rabs (x - h) <= g.
Proof.
  intros M D L Z B; destruct (MVT_gen f h x df) as [c [I E]].
  - intros y Y; apply D; lra.
  - intros y Y; apply continuity_pt_filterlim, (ex_derive_continuous f y); exists (df y); apply D; lra.
  - specialize (L c ltac:(lra)); rewrite Z in E; apply (Rmult_le_reg_l m); [exact M |].
    eapply Rle_trans; [| exact B]; replace (f h) with (- (df c * (x - h))) by lra.
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (df c)) by lra.
    apply Rmult_le_compat_r; [apply Rabs_pos | exact L].
Qed.
Lemma between a b y : Rmin a b <= y <= Rmax a b -> (a <= y <= b) \/ (b <= y <= a).
Proof. unfold Rmin, Rmax; destruct (Rle_dec a b); lra. Qed.
Ltac between_ := cbv beta; first
  [ lra | assumption
  | match goal with H : _ \/ _ |- _ => destruct H; first [lra | split_Rabs; lra | nra] end | inside_ ].

(* Sums of a function that rises or falls, against its integral: the difference is at most the
   larger of the values at the ends. *)
Lemma terms_first (f : nat -> R) low n : terms f low (S n) = terms f low n + f (low + n)%nat.
Proof. reflexivity. Qed.
Lemma step_between (f F : R -> R) a : (forall y, a <= y <= a + 1 -> is_derive F y (f y)) ->
  exists c, a <= c <= a + 1 /\ F (a + 1) - F a = f c.
Proof.
  intros D; destruct (MVT_gen F a (a + 1) f) as [c [I E]].
  - intros y Y; rewrite Rmin_left, Rmax_right in Y by lra; apply D; lra.
  - intros y Y; rewrite Rmin_left, Rmax_right in Y by lra.
    apply continuity_pt_filterlim, (ex_derive_continuous F y); exists (f y); apply D; lra.
  - rewrite Rmin_left, Rmax_right in I by lra; exists c; split; [exact I | rewrite E; ring].
Qed.
Lemma sum_falls (f F : R -> R) (low : nat) : (forall y, INR low <= y -> is_derive F y (f y)) ->
  (forall x y, INR low <= x -> x <= y -> f y <= f x) ->
  forall n, F (INR (low + n)) - F (INR low) <= terms (fun k => f (INR k)) low (S n) - f (INR (low + n))
    /\ terms (fun k => f (INR k)) low (S n) <= F (INR (low + n)) - F (INR low) + f (INR low).
Proof.
  intros D M n; induction n as [|n [IH1 IH2]].
  - rewrite Nat.add_0_r; simpl terms; rewrite Nat.add_0_r; lra.
  - rewrite (terms_first _ low (S n)), Nat.add_succ_r, S_INR.
    assert (B : INR low <= INR (low + n)) by (apply le_INR; lia).
    destruct (step_between f F (INR (low + n))) as [c [C E]]; [intros y Y; apply D; lra |].
    pose proof (M c (INR (low + n) + 1) ltac:(lra) ltac:(lra)).
    pose proof (M (INR (low + n)) c ltac:(lra) ltac:(lra)); lra.
Qed.
Lemma sum_rises (f F : R -> R) (low : nat) : (forall y, INR low <= y -> is_derive F y (f y)) ->
  (forall x y, INR low <= x -> x <= y -> f x <= f y) ->
  forall n, F (INR (low + n)) - F (INR low) + f (INR low) <= terms (fun k => f (INR k)) low (S n)
    /\ terms (fun k => f (INR k)) low (S n) - f (INR (low + n)) <= F (INR (low + n)) - F (INR low).
Proof.
  intros D M n; induction n as [|n [IH1 IH2]].
  - rewrite Nat.add_0_r; simpl terms; rewrite Nat.add_0_r; lra.
  - rewrite (terms_first _ low (S n)), Nat.add_succ_r, S_INR.
    assert (B : INR low <= INR (low + n)) by (apply le_INR; lia).
    destruct (step_between f F (INR (low + n))) as [c [C E]]; [intros y Y; apply D; lra |].
    pose proof (M c (INR (low + n) + 1) ltac:(lra) ltac:(lra)).
    pose proof (M (INR (low + n)) c ltac:(lra) ltac:(lra)); lra.
Qed.

(* Stolz: where b rises to infinity, a/b has the limit of the quotient of the differences. *)
Lemma stolz_near (a b : nat -> R) (l e : R) N : 0 <= e ->
  (forall n, (N <= n)%nat -> 0 < b (S n) - b n) ->
  (forall n, (N <= n)%nat -> Rabs (a (S n) - a n - l * (b (S n) - b n)) <= e * (b (S n) - b n)) ->
  forall n, (N <= n)%nat -> Rabs (a n - a N - l * (b n - b N)) <= e * (b n - b N).
Proof.
  intros E B A n L; induction L as [|n L IH].
  - replace (a N - a N - l * (b N - b N)) with 0 by ring; rewrite Rabs_R0; lra.
  - specialize (A n L); specialize (B n L).
    replace (a (S n) - a N - l * (b (S n) - b N)) with
      (a (S n) - a n - l * (b (S n) - b n) + (a n - a N - l * (b n - b N))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]; lra.
Qed.
Lemma stolz (a b : nat -> R) (l : R) : eventually (fun n => 0 < b (S n) - b n) ->
  filterlim b eventually (Rbar_locally p_infty) ->
  filterlim (fun n => (a (S n) - a n) * / (b (S n) - b n)) eventually (Rbar_locally l) ->
  filterlim (fun n => a n * / b n) eventually (Rbar_locally l).
Proof.
  intros B I Q; apply filterlim_locally; intros eps; pose proof (cond_pos eps) as E.
  pose proof (proj1 (filterlim_locally _ l) Q (mkposreal (eps / 2) ltac:(lra))) as C.
  destruct (filter_and _ _ B C) as [N H].
  set (K := Rabs (a N - l * b N) + eps / 2 * Rabs (b N)).
  assert (J : eventually (fun n => Rmax 1 (4 * K / eps + 1) < b n)) by (apply I; exists (Rmax 1 (4 * K / eps + 1)); trivial).
  assert (G : eventually (fun n => (N <= n)%nat)) by now exists N.
  generalize (filter_and _ _ J G); apply filter_imp; intros n [X L].
  pose proof (Rmax_l 1 (4 * K / eps + 1)); pose proof (Rmax_r 1 (4 * K / eps + 1)).
  assert (S1 : Rabs (a n - a N - l * (b n - b N)) <= eps / 2 * (b n - b N)).
  { apply stolz_near; [lra | intros m M; apply (H m M) | | exact L].
    intros m M; destruct (H m M) as [P W]; change (Rabs ((a (S m) - a m) * / (b (S m) - b m) - l) < eps / 2) in W.
    replace (a (S m) - a m - l * (b (S m) - b m)) with
      (((a (S m) - a m) * / (b (S m) - b m) - l) * (b (S m) - b m)) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (b (S m) - b m)) by lra; apply Rmult_le_compat_r; lra. }
  change (Rabs (a n * / b n - l) < eps).
  replace (a n * / b n - l) with ((a n - l * b n) * / b n) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ b n)) by (left; apply Rinv_0_lt_compat; lra).
  apply (Rmult_lt_reg_r (b n)); [lra |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (S2 : Rabs (a n - l * b n) <= eps / 2 * b n + K).
  { replace (a n - l * b n) with (a n - a N - l * (b n - b N) + (a N - l * b N)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]; unfold K.
    assert (- b N <= Rabs (b N)) by (rewrite <- Rabs_Ropp; apply Rle_abs).
    assert (eps / 2 * - b N <= eps / 2 * Rabs (b N)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (K0 : 0 <= K).
  { unfold K; pose proof (Rabs_pos (a N - l * b N)); pose proof (Rabs_pos (b N)); assert (0 <= eps / 2 * Rabs (b N)) by (apply Rmult_le_pos; lra); lra. }
  assert (S3 : 4 * K < eps * b n).
  { apply (Rmult_lt_reg_r (/ eps)); [apply Rinv_0_lt_compat; lra |].
    replace (eps * b n * / eps) with (b n) by (field; lra); unfold Rdiv in *; lra. }
  lra.
Qed.

(* Gronwall: |y'| <= k |y| + c bounds y by the solution of the equation with equality. *)
Lemma gronwall (y dy : R -> R) (k c T : R) : 0 < k -> 0 <= c ->
  (forall t, 0 <= t <= T -> is_derive y t (dy t)) ->
  (forall t, 0 <= t <= T -> dy t <= k * y t + c) ->
  forall t, 0 <= t <= T -> y t <= (y 0 + c / k) * exp (k * t) - c / k.
Proof.
  intros K C D L t H.
  set (u := fun s => (y s + c / k) * exp (- k * s)).
  assert (U : forall s, 0 <= s <= T -> is_derive u s ((dy s - k * (y s + c / k)) * exp (- k * s))).
  { intros s S1; unfold u; eapply d_eq.
    - apply (d_mult (fun s => y s + c / k) (fun s => exp (- k * s))).
      + eapply d_eq; [apply (d_plus y (fun _ => c / k)); [exact (D s S1) | apply d_const] | reflexivity].
      + derive.
    - cbv beta; ring. }
  assert (M : u t <= u 0).
  { destruct (MVT_gen u 0 t (fun s => (dy s - k * (y s + c / k)) * exp (- k * s))) as [s [I E]].
    - intros s S1; rewrite Rmin_left, Rmax_right in S1 by lra; apply U; lra.
    - intros s S1; rewrite Rmin_left, Rmax_right in S1 by lra.
      apply continuity_pt_filterlim, (ex_derive_continuous u s); eexists; apply U; lra.
    - rewrite Rmin_left, Rmax_right in I by lra; specialize (L s ltac:(lra)).
      pose proof (exp_pos (- k * s)) as P; assert (Q : k * (y s + c / k) = k * y s + c) by (field; lra).
      rewrite Q in E; assert (0 <= (k * y s + c - dy s) * exp (- k * s)) by (apply Rmult_le_pos; lra).
      assert (0 <= (k * y s + c - dy s) * exp (- k * s) * t) by (apply Rmult_le_pos; lra); lra. }
  unfold u in M; rewrite Rmult_0_r, exp_0, Rmult_1_r in M.
  pose proof (exp_pos (k * t)) as P; assert (Q : exp (- k * t) * exp (k * t) = 1).
  { rewrite <- exp_plus; replace (- k * t + k * t) with 0 by ring; apply exp_0. }
  apply (Rmult_le_compat_r (exp (k * t))) in M; [| lra]; rewrite Rmult_assoc, Q in M; lra.
Qed.
Lemma sum_near (f F : R -> R) (low : nat) : (forall y, INR low <= y -> is_derive F y (f y)) ->
  (forall x y, INR low <= x -> x <= y -> f y <= f x) \/ (forall x y, INR low <= x -> x <= y -> f x <= f y) ->
  forall n m, (low + n)%nat = m ->
  Rabs (terms (fun k => f (INR k)) low (S n) - (F (INR m) - F (INR low))) <= Rabs (f (INR low)) + Rabs (f (INR m)).
Proof.
  intros D M n m <-; pose proof (Rle_abs (f (INR low))); pose proof (Rle_abs (f (INR (low + n)))).
  pose proof (Rabs_maj2 (f (INR low))); pose proof (Rabs_maj2 (f (INR (low + n)))).
  apply Rabs_le; destruct M as [M | M].
  - destruct (sum_falls f F low D M n); lra.
  - destruct (sum_rises f F low D M n); lra.
Qed.

(* The trapezoids of Euler and Maclaurin: where the slope of f rises or falls, a sum differs from its
   integral and half of the values at the ends by at most half of the change of that slope. *)
Lemma trapezoid_step (f F f1 : R -> R) a : (forall y, a <= y <= a + 1 -> is_derive F y (f y)) ->
  (forall y, a <= y <= a + 1 -> is_derive f y (f1 y)) ->
  (forall x y, a <= x -> x <= y -> y <= a + 1 -> f1 x <= f1 y) ->
  Rabs (F (a + 1) - F a - (f a + f (a + 1)) / 2) <= (f1 (a + 1) - f1 a) / 2.
Proof.
  intros D D1 M; pose proof (M a (a + 1) ltac:(lra) ltac:(lra) ltac:(lra)) as W.
  destruct (MVT_gen (fun t : R => F (a + t) - F a - t * ((f a + f (a + t)) / 2)) 0 1
    (fun t => f (a + t) - (f a + f (a + t)) / 2 - t * (f1 (a + t) / 2))) as [c [C E]].
  - intros t T; rewrite Rmin_left, Rmax_right in T by lra.
    pose proof (D (a + t) ltac:(lra)) as X; pose proof (D1 (a + t) ltac:(lra)) as Y.
    auto_derive; [repeat split; eexists; eassumption |].
    replace (Derive (fun x : R => F x) (a + t)) with (f (a + t)) by (symmetry; apply is_derive_unique, X).
    replace (Derive (fun x : R => f x) (a + t)) with (f1 (a + t)) by (symmetry; apply is_derive_unique, Y).
    field.
  - intros t T; rewrite Rmin_left, Rmax_right in T by lra; apply continuity_pt_filterlim.
    apply (ex_derive_continuous (fun t : R => F (a + t) - F a - t * ((f a + f (a + t)) / 2))).
    pose proof (D (a + t) ltac:(lra)) as X; pose proof (D1 (a + t) ltac:(lra)) as Y.
    auto_derive; repeat split; eexists; eassumption.
  - rewrite Rmin_left, Rmax_right in C by lra; rewrite Rplus_0_r in E.
    replace (F (a + 1) - F a - (f a + f (a + 1)) / 2)
      with (f (a + c) - (f a + f (a + c)) / 2 - c * (f1 (a + c) / 2)) by lra.
    destruct (MVT_gen f a (a + c) f1) as [d [I G]].
    + intros t T; rewrite Rmin_left, Rmax_right in T by lra; apply D1; lra.
    + intros t T; rewrite Rmin_left, Rmax_right in T by lra.
      apply continuity_pt_filterlim, (ex_derive_continuous f t); exists (f1 t); apply D1; lra.
    + rewrite Rmin_left, Rmax_right in I by lra.
      pose proof (M a d ltac:(lra) ltac:(lra) ltac:(lra)); pose proof (M d (a + c) ltac:(lra) ltac:(lra) ltac:(lra)).
      pose proof (M (a + c) (a + 1) ltac:(lra) ltac:(lra) ltac:(lra)).
      replace (f (a + c) - (f a + f (a + c)) / 2 - c * (f1 (a + c) / 2))
        with (- (c * (f1 (a + c) - f1 d)) / 2) by (replace (a + c - a) with c in G by ring; lra).
      assert (0 <= c * (f1 (a + c) - f1 d) <= f1 (a + 1) - f1 a) by (split; nra); apply Rabs_le; lra.
Qed.
Lemma trapezoids (f F f1 : R -> R) (low : nat) : (forall y, INR low <= y -> is_derive F y (f y)) ->
  (forall y, INR low <= y -> is_derive f y (f1 y)) ->
  (forall x y, INR low <= x -> x <= y -> f1 x <= f1 y) -> forall n,
  Rabs (terms (fun k => f (INR k)) low (S n) - (F (INR (low + n)) - F (INR low))
    - (f (INR low) + f (INR (low + n))) / 2) <= (f1 (INR (low + n)) - f1 (INR low)) / 2.
Proof.
  intros D D1 M n; induction n as [|n IH].
  - rewrite Nat.add_0_r; simpl terms; rewrite Nat.add_0_r; apply Rabs_le; lra.
  - rewrite (terms_first _ low (S n)), Nat.add_succ_r, S_INR.
    assert (B : INR low <= INR (low + n)) by (apply le_INR; lia).
    pose proof (trapezoid_step f F f1 (INR (low + n)) ltac:(intros; apply D; lra)
      ltac:(intros; apply D1; lra) ltac:(intros; apply M; lra)) as T.
    apply Rabs_le_between in IH; apply Rabs_le_between in T; apply Rabs_le; lra.
Qed.
Lemma trapezoids_near (f F f1 : R -> R) (low : nat) : (forall y, INR low <= y -> is_derive F y (f y)) ->
  (forall y, INR low <= y -> is_derive f y (f1 y)) ->
  (forall x y, INR low <= x -> x <= y -> f1 y <= f1 x) \/ (forall x y, INR low <= x -> x <= y -> f1 x <= f1 y) ->
  forall n m, (low + n)%nat = m ->
  Rabs (terms (fun k => f (INR k)) low (S n) - (F (INR m) - F (INR low) + (f (INR low) + f (INR m)) / 2))
    <= Rabs (f1 (INR low)) + Rabs (f1 (INR m)).
Proof.
  intros D D1 M n m <-; pose proof (Rle_abs (f1 (INR low))); pose proof (Rle_abs (f1 (INR (low + n)))).
  pose proof (Rabs_maj2 (f1 (INR low))); pose proof (Rabs_maj2 (f1 (INR (low + n)))).
  destruct M as [M | M].
  - pose proof (trapezoids (fun y => - f y) (fun y => - F y) (fun y => - f1 y) low
      ltac:(intros; apply (d_opp F); auto) ltac:(intros; apply (d_opp f); auto)
      ltac:(intros x y X Y; specialize (M x y X Y); lra) n) as T.
    assert (E : forall k, terms (fun k => - f (INR k)) low k = - terms (fun k => f (INR k)) low k).
    { induction k as [|k IH]; [simpl; ring | rewrite !terms_first, IH; ring]. }
    rewrite E in T; apply Rabs_le_between in T; apply Rabs_le; lra.
  - pose proof (trapezoids f F f1 low D D1 M n) as T; apply Rabs_le_between in T; apply Rabs_le; lra.
Qed.

(* Watson's lemma. The integrals of t^n e^(-x t) from 0 to T are n!/x^(n+1) and a rest that vanishes
   as T grows; so a function whose difference from a polynomial is at most C t^n e^(c t) has an
   integral with e^(-x t) that is the sum of these, up to C n!/(x - c)^(n+1). *)
Fixpoint power_rest (n : nat) (x t : R) : R := match n with
  | O => - exp (- x * t) / x
  | S m => - t ^ S m * exp (- x * t) / x + INR (S m) / x * power_rest m x t
  end.
Lemma power_rest_slope n x t : 0 < x -> is_derive (power_rest n x) t (t ^ n * exp (- x * t)).
Proof.
  intros X; induction n as [|n IH]; cbn [power_rest].
  - auto_derive; [exact I | field; lra].
  - eapply d_eq.
    + apply (d_plus (fun t => - t ^ S n * exp (- x * t) / x) (fun t => INR (S n) / x * power_rest n x t)).
      * apply (d_div (fun t => - t ^ S n * exp (- x * t)) (fun _ => x)); [| apply d_const | lra].
        apply (d_mult (fun t => - t ^ S n) (fun t => exp (- x * t))).
        { apply (d_opp (fun t => t ^ S n)), (d_pow (fun t => t)), d_id. }
        apply (d_exp (fun t => - x * t)), (d_mult (fun _ => - x) (fun t => t)); [apply d_const | apply d_id].
      * apply (d_mult (fun _ => INR (S n) / x) (power_rest n x)); [apply d_const | exact IH].
    + simpl pred; field; lra.
Qed.
Lemma power_rest_start n x : 0 < x -> power_rest n x 0 = - (INR (fact n) / x ^ S n).
Proof.
  intros X; induction n as [|n IH]; cbn [power_rest].
  - rewrite Rmult_0_r, exp_0; simpl; field; lra.
  - rewrite IH, fact_simpl, mult_INR, pow_i by lia; rewrite <- !(tech_pow_Rmult x); field.
    split; [apply pow_nonzero; lra | lra].
Qed.
Lemma power_rest_sign n x t : 0 < x -> 0 <= t -> power_rest n x t <= 0.
Proof.
  intros X T; pose proof (exp_pos (- x * t)) as E; assert (J : 0 < / x) by now apply Rinv_0_lt_compat.
  induction n as [|n IH]; cbn [power_rest]; unfold Rdiv.
  - apply Rle_trans with (- (exp (- x * t) * / x)); [right; ring |].
    pose proof (Rmult_lt_0_compat _ _ E J); lra.
  - assert (P : 0 <= t ^ S n * exp (- x * t) * / x) by (repeat apply Rmult_le_pos; try lra; now apply pow_le).
    assert (Q : 0 <= INR (S n) * / x) by (apply Rmult_le_pos; [apply pos_INR | lra]).
    replace (- t ^ S n * exp (- x * t) * / x) with (- (t ^ S n * exp (- x * t) * / x)) by ring.
    pose proof (Rmult_le_compat_l _ _ _ Q IH); lra.
Qed.
Lemma power_vanishes n : forall x, 0 < x -> is_lim (fun t => t ^ n * exp (- x * t)) p_infty 0.
Proof.
  assert (L : forall x, 0 < x -> is_lim (fun t => - x * t) p_infty m_infty).
  { intros x X; replace m_infty with (Rbar_mult (- x) p_infty).
    - apply is_lim_scal_l, is_lim_id.
    - simpl; destruct (Rle_dec 0 (- x)); [exfalso; lra |]; reflexivity. }
  induction n as [|n IH]; intros x X.
  - apply (is_lim_ext (fun t => exp (- x * t))); [intros t; simpl; ring |].
    apply (is_lim_comp exp (fun t => - x * t) p_infty 0 m_infty is_lim_exp_m (L x X)).
    exists 0; intros t _; discriminate.
  - apply (is_lim_ext (fun t => (- 2 / x) * ((- (x / 2) * t) * exp (- (x / 2) * t)) * (t ^ n * exp (- (x / 2) * t)))).
    { intros t; replace (- x * t) with (- (x / 2) * t + - (x / 2) * t) by field.
      rewrite exp_plus, <- tech_pow_Rmult; field; lra. }
    replace (Finite 0) with (Rbar_mult 0 0) by (simpl; f_equal; ring).
    apply is_lim_mult; [| apply IH; lra | exact I].
    pose proof (is_lim_scal_l (fun t => - (x / 2) * t * exp (- (x / 2) * t)) (- 2 / x) p_infty 0) as K.
    simpl in K; rewrite Rmult_0_r in K; apply K.
    apply (is_lim_comp (fun y => y * exp y) (fun t => - (x / 2) * t) p_infty 0 m_infty is_lim_mul_exp_m (L (x / 2) ltac:(lra))).
    exists 0; intros t _; discriminate.
Qed.
Lemma lim_scaled (f : R -> R) k : is_lim f p_infty 0 -> is_lim (fun t => k * f t) p_infty 0.
Proof.
  intros H; pose proof (is_lim_scal_l f k p_infty 0 H) as L; simpl in L; rewrite Rmult_0_r in L; exact L.
Qed.
Lemma lim_sum (f g : R -> R) : is_lim f p_infty 0 -> is_lim g p_infty 0 -> is_lim (fun t => f t + g t) p_infty 0.
Proof.
  intros H K; replace (Finite 0) with (Finite (0 + 0)) by (f_equal; ring); now apply is_lim_plus'.
Qed.
Lemma power_rest_vanishes n x : 0 < x -> is_lim (power_rest n x) p_infty 0.
Proof.
  intros X; induction n as [|n IH]; cbn [power_rest].
  - apply (is_lim_ext (fun t => (- / x) * (t ^ 0 * exp (- x * t)))); [intros t; simpl; field; lra |].
    apply lim_scaled, power_vanishes, X.
  - apply (is_lim_ext (fun t => (- / x) * (t ^ S n * exp (- x * t)) + INR (S n) / x * power_rest n x t)).
    { intros t; field; lra. }
    apply lim_sum; apply lim_scaled; [apply power_vanishes, X | exact IH].
Qed.
Lemma power_integral n x T : 0 < x ->
  is_RInt (fun t => t ^ n * exp (- x * t)) 0 T (INR (fact n) / x ^ S n + power_rest n x T).
Proof.
  intros X; replace (INR (fact n) / x ^ S n + power_rest n x T) with (minus (power_rest n x T) (power_rest n x 0)).
  - apply (is_RInt_derive (power_rest n x)); intros t _; [apply power_rest_slope, X |].
    apply (ex_derive_continuous (fun t : R => t ^ n * exp (- x * t))); auto_derive; exact I.
  - rewrite power_rest_start by exact X; unfold minus, plus, opp; simpl; ring.
Qed.
Lemma terms_integral (a : nat -> R) n x T : 0 < x ->
  is_RInt (fun t => terms (fun k => a k * t ^ k) 0 n * exp (- x * t)) 0 T
    (terms (fun k => a k * (INR (fact k) / x ^ S k)) 0 n + terms (fun k => a k * power_rest k x T) 0 n).
Proof.
  intros X; induction n as [|n IH].
  - apply (is_RInt_ext (fun _ => 0)); [intros t _; simpl; ring |].
    replace (_ + _) with (scal (T - 0) 0) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_const (V := R_NormedModule)).
  - rewrite !terms_first, Nat.add_0_l.
    apply (is_RInt_ext (fun t => plus (terms (fun k => a k * t ^ k) 0 n * exp (- x * t)) (scal (a n) (t ^ n * exp (- x * t))))).
    { intros t _; rewrite terms_first, Nat.add_0_l; unfold plus, scal; simpl; unfold mult; simpl; ring. }
    replace (_ + _) with (plus (terms (fun k => a k * (INR (fact k) / x ^ S k)) 0 n + terms (fun k => a k * power_rest k x T) 0 n)
      (scal (a n) (INR (fact n) / x ^ S n + power_rest n x T))) by (unfold plus, scal; simpl; unfold mult; simpl; ring).
    exact (is_RInt_plus (V := R_NormedModule) _ _ 0 T _ _ IH (is_RInt_scal (V := R_NormedModule) _ 0 T (a n) _ (power_integral n x T X))).
Qed.
Lemma terms_vanish (a : nat -> R) n x : 0 < x ->
  is_lim (fun T => terms (fun k => a k * power_rest k x T) 0 n) p_infty 0.
Proof.
  intros X; induction n as [|n IH]; [exact (is_lim_const 0 p_infty) |].
  apply (is_lim_ext (fun T => terms (fun k => a k * power_rest k x T) 0 n + a n * power_rest n x T)).
  { intros T; rewrite terms_first; reflexivity. }
  apply lim_sum; [exact IH | apply lim_scaled, power_rest_vanishes, X].
Qed.
Lemma watson (f : R -> R) (a : nat -> R) (n : nat) (c x bound whole : R) : 0 < x -> c < x -> 0 <= bound ->
  (forall t, 0 <= t -> continuous f t) ->
  (forall t, 0 <= t -> Rabs (f t - terms (fun k => a k * t ^ k) 0 n) <= bound * t ^ n * exp (c * t)) ->
  is_lim (fun T => RInt (fun t => f t * exp (- x * t)) 0 T) p_infty whole ->
  Rabs (whole - terms (fun k => a k * (INR (fact k) / x ^ S k)) 0 n) <= bound * (INR (fact n) / (x - c) ^ S n).
Proof.
  intros X Y B C D L.
  set (S0 := terms (fun k => a k * (INR (fact k) / x ^ S k)) 0 n).
  assert (W : forall T, 0 <= T -> Rabs (RInt (fun t => f t * exp (- x * t)) 0 T - (S0 + terms (fun k => a k * power_rest k x T) 0 n))
    <= bound * (INR (fact n) / (x - c) ^ S n)).
  { intros T H; pose proof (terms_integral a n x T X) as P; fold S0 in P.
    assert (E : is_RInt (fun t => f t * exp (- x * t)) 0 T (RInt (fun t => f t * exp (- x * t)) 0 T)).
    { apply (RInt_correct (V := R_CompleteNormedModule)), ex_RInt_continuous; intros t I0.
      rewrite Rmin_left in I0 by lra; apply (continuous_mult f (fun t => exp (- x * t))); [apply C; lra |].
      apply (ex_derive_continuous (fun t : R => exp (- x * t))); auto_derive; exact I. }
    pose proof (is_RInt_minus (V := R_NormedModule) _ _ 0 T _ _ E P) as M.
    pose proof (is_RInt_scal (V := R_NormedModule) _ 0 T bound _ (power_integral n (x - c) T ltac:(lra))) as Q.
    assert (N : forall t, 0 <= t <= T -> norm (minus (f t * exp (- x * t)) (terms (fun k => a k * t ^ k) 0 n * exp (- x * t)))
      <= scal bound (t ^ n * exp (- (x - c) * t))).
    { intros t I0; change (Rabs (f t * exp (- x * t) - terms (fun k => a k * t ^ k) 0 n * exp (- x * t)) <= bound * (t ^ n * exp (- (x - c) * t))).
      replace (f t * exp (- x * t) - terms (fun k => a k * t ^ k) 0 n * exp (- x * t))
        with ((f t - terms (fun k => a k * t ^ k) 0 n) * exp (- x * t)) by ring.
      pose proof (exp_pos (- x * t)) as Z; rewrite Rabs_mult, (Rabs_pos_eq (exp _)) by lra.
      replace (- (x - c) * t) with (c * t + - x * t) by ring; rewrite exp_plus.
      pose proof (D t ltac:(lra)) as D1; apply (Rmult_le_compat_r (exp (- x * t))) in D1; lra. }
    pose proof (norm_RInt_le (V := R_NormedModule) _ _ 0 T _ _ H N M Q) as G.
    eapply Rle_trans; [exact G | change (bound * (INR (fact n) / (x - c) ^ S n + power_rest n (x - c) T) <= bound * (INR (fact n) / (x - c) ^ S n))].
    pose proof (power_rest_sign n (x - c) T ltac:(lra) H); apply Rmult_le_compat_l; lra. }
  assert (M : is_lim (fun T => Rabs (RInt (fun t => f t * exp (- x * t)) 0 T - (S0 + terms (fun k => a k * power_rest k x T) 0 n)))
    p_infty (Rabs (whole - S0))).
  { apply (is_lim_Rabs _ p_infty (whole - S0)).
    replace (Finite (whole - S0)) with (Finite (whole - (S0 + 0))) by (f_equal; ring).
    apply is_lim_minus'; [exact L | apply is_lim_plus'; [exact (is_lim_const S0 p_infty) | apply terms_vanish, X]]. }
  refine (is_lim_le_loc (fun T => Rabs (RInt (fun t => f t * exp (- x * t)) 0 T - (S0 + terms (fun k => a k * power_rest k x T) 0 n)))
    (fun _ => bound * (INR (fact n) / (x - c) ^ S n)) p_infty _ _ _ M (is_lim_const _ p_infty)).
  exists 0; intros T H; apply W; lra.
Qed.
Section Sums.
Implicit Types (s u v w g : nat -> R).
Lemma O_sum s u v w g : eventually (fun n => Rabs (s n - u n) <= Rabs (v n) + Rabs (w n)) ->
  (exists C, eventually (fun n => Rabs (v n) <= C * Rabs (g n))) ->
  (exists C, eventually (fun n => Rabs (w n) <= C * Rabs (g n))) ->
  (exists C, eventually (fun n => Rabs (u n) <= C * Rabs (g n))) ->
  exists C, eventually (fun n => Rabs (s n) <= C * Rabs (g n)).
Proof.
  intros B [C1 V] [C2 W] [C3 U]; exists (C1 + C2 + C3).
  generalize (filter_and _ _ B (filter_and _ _ V (filter_and _ _ W U))); apply filter_imp; intros n [H1 [H2 [H3 H4]]].
  pose proof (Rabs_triang (s n - u n) (u n)) as H5; replace (s n - u n + u n) with (s n) in H5 by ring; lra.
Qed.
Lemma o_sum s u v w g : eventually (fun n => Rabs (s n - u n) <= Rabs (v n) + Rabs (w n)) ->
  (forall eps, 0 < eps -> eventually (fun n => Rabs (v n) <= eps * Rabs (g n))) ->
  (forall eps, 0 < eps -> eventually (fun n => Rabs (w n) <= eps * Rabs (g n))) ->
  (forall eps, 0 < eps -> eventually (fun n => Rabs (u n) <= eps * Rabs (g n))) ->
  forall eps, 0 < eps -> eventually (fun n => Rabs (s n) <= eps * Rabs (g n)).
Proof.
  intros B V W U eps E; assert (E3 : 0 < eps / 3) by lra.
  generalize (filter_and _ _ B (filter_and _ _ (V _ E3) (filter_and _ _ (W _ E3) (U _ E3)))).
  apply filter_imp; intros n [H1 [H2 [H3 H4]]].
  pose proof (Rabs_triang (s n - u n) (u n)) as H5; replace (s n - u n + u n) with (s n) in H5 by ring; lra.
Qed.
Lemma O_none g : exists C, eventually (fun n => Rabs ((fun _ => 0) n) <= C * Rabs (g n)).
Proof. exists 0; exists O; intros n _; rewrite Rabs_R0; lra. Qed.
Lemma o_none g : forall eps, 0 < eps -> eventually (fun n => Rabs ((fun _ => 0) n) <= eps * Rabs (g n)).
Proof.
  intros eps E; exists O; intros n _; rewrite Rabs_R0; apply Rmult_le_pos; [lra | apply Rabs_pos].
Qed.
End Sums.
Ltac sum_equal := first [ring | rewrite ?ln_1, ?sqrt_1; first [ring | field; inside_] | field; inside_].
Ltac sum_defined := first
  [ intros; whole_numbers; repeat split; nonzero_whole
  | exists 1%nat; intros; whole_numbers; repeat split; nonzero_whole ].
Lemma apart_from_infinite (b : nat -> R) : filterlim b eventually (Rbar_locally p_infty) ->
  eventually (fun n => b n <> 0).
Proof. intros H; apply (H (fun y => y <> 0)); exists 0; intros y Y; lra. Qed.
Lemma stolz_terms (f : nat -> R) (b Q : nat -> R) (l : R) : eventually (fun n => 0 < b (S n) - b n) ->
  filterlim b eventually (Rbar_locally p_infty) ->
  eventually (fun n => f (S n) * / (b (S n) - b n) = Q n) -> filterlim Q eventually (Rbar_locally l) ->
  filterlim (fun n => terms f 1 n * / b n) eventually (Rbar_locally l).
Proof.
  intros B I E L; apply (stolz (fun n => terms f 1 n) b l B I).
  apply (whole_beside _ Q); [| exact L]; revert E; apply filter_imp; intros n <-.
  rewrite terms_first; replace (terms f 1 n + f (1 + n)%nat - terms f 1 n) with (f (S n)) by (cbn [Nat.add]; ring); reflexivity.
Qed.
