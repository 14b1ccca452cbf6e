(* Integrals, sums and limits: what claims of users about them say, and lemmas for their proofs. *)

(* The sum of [count] terms, f low + ... + f (low + count - 1). *)
Fixpoint terms (f : nat -> R) (low count : nat) : R :=
  match count with O => 0 | S n => terms f low n + f (low + n)%nat end.

Ltac whole_numbers :=
  repeat match goal with
  | n : nat |- _ => lazymatch goal with H : 0 <= INR n |- _ => fail | _ => pose proof (pos_INR n) end
  | H : (?m <= ?n)%nat |- _ => apply le_INR in H; cbn [INR] in H
  end.
Ltac powers := repeat match goal with
  | |- context [?x ^ ?n] => is_var n; generalize (pow_nonzero x n); generalize (pow_lt x n);
      generalize (x ^ n); intros
  end.
Ltac unfold_whole :=
  cbn [terms]; cbv beta;
  rewrite ?Nat.add_succ_r, ?Nat.add_succ_l, ?Nat.add_0_r, ?Nat.add_0_l;
  rewrite ?fact_simpl;
  rewrite ?pow_add, ?pow_mult, ?mult_INR, ?plus_INR;
  cbn [pow fact]; rewrite ?plus_INR, ?mult_INR, ?S_INR; cbn [INR].
Ltac nat_pow_nonzero := repeat match goal with
  | |- context [?x ^ ?n] => is_var n; lazymatch goal with H : x ^ n <> 0 |- _ => fail | _ =>
      assert (x ^ n <> 0) by (apply pow_nonzero; first [lra | assumption | apply Rgt_not_eq; positive]) end
  end.
Ltac equal_whole :=
  whole_numbers; try nat_pow_nonzero;
  first [ ring | lra | field; repeat split; try (apply Rgt_not_eq); side
        | field; repeat split; first [side | nra | apply Rlt_not_eq; nra | apply Rgt_not_eq; nra] ].
Ltac nonzero_whole := intros; whole_numbers;
  first [side | nra | apply Rgt_not_eq; positive | apply Rgt_not_eq; nra | apply pow_nonzero; lra].
Ltac by_induction n IH :=
  induction n as [|n IH]; [unfold_whole; equal_whole | unfold_whole; rewrite IH; unfold_whole; equal_whole].

(* Integrals through antiderivatives. *)
Lemma by_antiderivative (f F : R -> R) (a b v : R) :
  (forall x, Rmin a b <= x <= Rmax a b -> continuous f x) ->
  (forall x, Rmin a b <= x <= Rmax a b -> continuous F x) ->
  (forall x, Rmin a b < x < Rmax a b -> is_derive F x (f x)) -> F b - F a = v -> is_RInt f a b v.
Proof.
  intros C G D E; rewrite <- E, <- (fundamental f F a b C G D); now apply integral_correct.
Qed.
Lemma improper (f F : R -> R) (Fa Fb : (R -> Prop) -> Prop) {PFa : ProperFilter Fa}
  {PFb : ProperFilter Fb} (la lb v : R) :
  filter_prod Fa Fb (fun ab => forall x, Rmin (fst ab) (snd ab) <= x <= Rmax (fst ab) (snd ab) ->
    is_derive F x (f x) /\ continuous f x) ->
  filterlim F Fa (locally la) -> filterlim F Fb (locally lb) -> lb - la = v ->
  is_RInt_gen f Fa Fb v.
Proof.
  intros H A B E.
  assert (T : filterlim (fun ab : R * R => F (snd ab) - F (fst ab)) (filter_prod Fa Fb) (locally v)).
  { rewrite <- E; apply (filterlim_comp_2 (G := locally lb) (H := locally (- la)))
      with (f := fun ab : R * R => F (snd ab)) (g := fun ab : R * R => - F (fst ab)).
    - apply filterlim_comp with (2 := B), filterlim_snd.
    - apply filterlim_comp with (g := Ropp) (G := locally la).
      + apply filterlim_comp with (2 := A), filterlim_fst.
      + apply (filterlim_opp la).
    - apply (filterlim_plus lb (- la)). }
  intros P HP; specialize (T P HP); unfold filtermapi, filtermap in *.
  generalize (filter_and _ _ H T); apply filter_imp; intros [x y] [D Q]; simpl in *.
  exists (F y - F x); split; [| exact Q].
  apply (is_RInt_derive F f x y); intros z Z; now destruct (D z Z).
Qed.

(* Limits along a filter; the ends are at_right 0 and infinity, and all others by substitution. *)
Section Tends.
Context (F : (R -> Prop) -> Prop) {FF : Filter F}.
Implicit Types (f g h : R -> R) (k l m : Rbar).
Lemma t_const (c : R) : filterlim (fun _ : R => c) F (Rbar_locally c).
Proof. apply filterlim_const. Qed.
Lemma t_plus f g k m l : filterlim f F (Rbar_locally k) -> filterlim g F (Rbar_locally m) ->
  is_Rbar_plus k m l -> filterlim (fun x => f x + g x) F (Rbar_locally l).
Proof. intros A B C; eapply filterlim_comp_2; [exact A | exact B | now apply filterlim_Rbar_plus]. Qed.
Lemma t_mult f g k m l : filterlim f F (Rbar_locally k) -> filterlim g F (Rbar_locally m) ->
  is_Rbar_mult k m l -> filterlim (fun x => f x * g x) F (Rbar_locally l).
Proof. intros A B C; eapply filterlim_comp_2; [exact A | exact B | now apply filterlim_Rbar_mult]. Qed.
Lemma t_inv f k : filterlim f F (Rbar_locally k) -> k <> Finite 0 ->
  filterlim (fun x => / f x) F (Rbar_locally (Rbar_inv k)).
Proof. intros A C; apply (filterlim_comp _ _ _ _ _ _ _ _ A), filterlim_Rbar_inv, C. Qed.
Lemma t_inv_infinite f k : filterlim f F (Rbar_locally k) -> Rbar_inv k = 0 -> k <> Finite 0 ->
  filterlim (fun x => / f x) F (Rbar_locally 0).
Proof. intros A E C; rewrite <- E; now apply t_inv. Qed.
Lemma t_inv_above f : filterlim f F (Rbar_locally 0) -> F (fun x => 0 < f x) ->
  filterlim (fun x => / f x) F (Rbar_locally p_infty).
Proof.
  intros A P; apply (filterlim_comp _ _ _ f Rinv F (at_right 0)); [| exact filterlim_Rinv_0_right].
  intros Q [d D]; specialize (A _ (ex_intro _ d (fun y B => B))); unfold filtermap in *.
  generalize (filter_and _ _ A P); apply filter_imp; intros x [X Y]; now apply D.
Qed.
Lemma t_inv_below f : filterlim f F (Rbar_locally 0) -> F (fun x => f x < 0) ->
  filterlim (fun x => / f x) F (Rbar_locally m_infty).
Proof.
  intros A P; apply (filterlim_comp _ _ _ f Rinv F (at_left 0)); [| exact filterlim_Rinv_0_left].
  intros Q [d D]; specialize (A _ (ex_intro _ d (fun y B => B))); unfold filtermap in *.
  generalize (filter_and _ _ A P); apply filter_imp; intros x [X Y]; now apply D.
Qed.
Lemma t_outer (h f : R -> R) (k : R) : filterlim f F (Rbar_locally k) -> continuous h k ->
  filterlim (fun x => h (f x)) F (Rbar_locally (h k)).
Proof. intros A C; exact (filterlim_comp _ _ _ _ _ _ _ _ A C). Qed.
Lemma t_far (h f : R -> R) k l : filterlim f F (Rbar_locally k) ->
  filterlim h (Rbar_locally k) (Rbar_locally l) -> filterlim (fun x => h (f x)) F (Rbar_locally l).
Proof. intros A C; exact (filterlim_comp _ _ _ _ _ _ _ _ A C). Qed.
Lemma t_ln_0 f : filterlim f F (Rbar_locally 0) -> F (fun x => 0 < f x) ->
  filterlim (fun x => ln (f x)) F (Rbar_locally m_infty).
Proof.
  intros A P; apply (filterlim_comp _ _ _ f ln F (at_right 0)); [| exact is_lim_ln_0].
  intros Q [d D]; specialize (A _ (ex_intro _ d (fun y B => B))); unfold filtermap in *.
  generalize (filter_and _ _ A P); apply filter_imp; intros x [X Y]; now apply D.
Qed.
Lemma t_beside f g l : F (fun x => f x = g x) -> filterlim f F (Rbar_locally l) ->
  filterlim g F (Rbar_locally l).
Proof. exact (filterlim_ext_loc f g). Qed.
Lemma t_value f l m : filterlim f F (Rbar_locally l) -> l = m -> filterlim f F (Rbar_locally m).
Proof. now intros A <-. Qed.
Lemma t_bounded f g (c : R) : F (fun x => Rabs (f x) <= c) -> filterlim g F (Rbar_locally 0) ->
  filterlim (fun x => f x * g x) F (Rbar_locally 0).
Proof.
  intros B A; apply filterlim_locally; intros e.
  assert (P : 0 < e / (Rabs c + 1)).
  { apply Rdiv_lt_0_compat; [apply cond_pos | pose proof (Rabs_pos c); lra]. }
  assert (N := proj1 (filterlim_locally g 0) A (mkposreal _ P)).
  generalize (filter_and _ _ B N); apply filter_imp; intros x [X Y].
  change (Rabs (g x - 0) < e / (Rabs c + 1)) in Y; change (Rabs (f x * g x - 0) < e).
  rewrite Rminus_0_r in *; rewrite Rabs_mult.
  pose proof (Rle_abs c); pose proof (Rabs_pos (f x)); pose proof (Rabs_pos (g x)).
  pose proof (Rabs_pos c).
  apply Rle_lt_trans with ((Rabs c + 1) * Rabs (g x)); [nra |].
  apply (Rmult_lt_compat_l (Rabs c + 1)) in Y; [| lra].
  replace ((Rabs c + 1) * (e / (Rabs c + 1))) with (pos e) in Y by (field; lra); exact Y.
Qed.
End Tends.

#[global] Instance filter_infinity : Filter (Rbar_locally p_infty).
Proof. apply Rbar_locally_filter. Qed.
#[global] Instance filter_right : Filter (at_right 0).
Proof. apply at_right_proper_filter. Qed.

Lemma t_exp_infinity : filterlim exp (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof. exact is_lim_exp_p. Qed.
Lemma t_exp_below : filterlim exp (Rbar_locally m_infty) (Rbar_locally 0).
Proof. exact is_lim_exp_m. Qed.
Lemma t_ln_infinity : filterlim ln (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof. exact is_lim_ln_p. Qed.
Lemma atan_left x : 0 < x -> atan x = PI / 2 - atan (/ x).
Proof. intros X; rewrite atan_inv by exact X; lra. Qed.
Lemma t_atan_infinity : filterlim atan (Rbar_locally p_infty) (Rbar_locally (PI / 2)).
Proof.
  assert (Z : filterlim (fun x => / x) (Rbar_locally p_infty) (Rbar_locally 0)).
  { apply (t_inv_infinite (Rbar_locally p_infty) (fun x => x) p_infty); [apply filterlim_id | reflexivity | easy]. }
  apply (t_beside (Rbar_locally p_infty) (fun x => PI / 2 - atan (/ x))).
  { exists 0; intros x X; rewrite (atan_left x X); ring. }
  apply (t_value _ _ (PI / 2 - atan 0)); [| rewrite atan_0; apply f_equal; ring].
  apply (t_outer (Rbar_locally p_infty) (fun y => PI / 2 - atan y) (fun x => / x) 0 Z).
  continues.
Qed.
Lemma t_sqrt_infinity : filterlim sqrt (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof. exact filterlim_sqrt_p. Qed.
Lemma t_pow_infinity n : filterlim (fun x => x ^ S n) (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof.
  induction n.
  - apply (t_beside (Rbar_locally p_infty) (fun x => x)); [exists 0; intros; ring | apply filterlim_id].
  - apply (t_mult (Rbar_locally p_infty) (fun x => x) (fun x => x ^ S n) p_infty p_infty);
    [apply filterlim_id | exact IHn | reflexivity].
Qed.

(* Other ends by substitution. *)
Lemma ends_right (a : R) (f : R -> R) G : filterlim (fun t => f (a + t)) (at_right 0) G ->
  filterlim f (at_right a) G.
Proof.
  intros H P Q; destruct (H P Q) as [d D]; exists d; intros y B Y.
  change (Rabs (y - a) < d) in B.
  assert (E : forall u v : R, u + (v - u) = v) by (intros; ring).
  specialize (D (y - a)); rewrite E in D; apply D; [| lra].
  change (Rabs (y - a - 0) < d); now rewrite Rminus_0_r.
Qed.
Lemma ends_left (a : R) (f : R -> R) G : filterlim (fun t => f (a + (-1) * t)) (at_right 0) G ->
  filterlim f (at_left a) G.
Proof.
  intros H P Q; destruct (H P Q) as [d D]; exists d; intros y B Y.
  change (Rabs (y - a) < d) in B.
  assert (E : forall u v : R, u + (-1) * (u - v) = v) by (intros; ring).
  specialize (D (a - y)); rewrite E in D; apply D; [| lra].
  change (Rabs (a - y - 0) < d); rewrite Rminus_0_r, Rabs_minus_sym; exact B.
Qed.
Lemma ends_both (a : R) (f : R -> R) G : filterlim f (at_right a) G -> filterlim f (at_left a) G ->
  filterlim f (locally' a) G.
Proof.
  intros A B P Q; destruct (A P Q) as [d D]; destruct (B P Q) as [e E].
  exists (mkposreal _ (Rmin_pos _ _ (cond_pos d) (cond_pos e))); intros y Y N.
  change (Rabs (y - a) < Rmin d e) in Y.
  pose proof (Rmin_l d e); pose proof (Rmin_r d e).
  destruct (Rtotal_order y a) as [L|[L|L]]; [| contradiction |].
  - apply E; [change (Rabs (y - a) < e); lra | exact L].
  - apply D; [change (Rabs (y - a) < d); lra | exact L].
Qed.
Lemma ends_below (f : R -> R) G : filterlim (fun t => f ((-1) * t)) (Rbar_locally p_infty) G ->
  filterlim f (Rbar_locally m_infty) G.
Proof.
  intros H P Q; destruct (H P Q) as [M D]; exists (- M); intros y Y.
  assert (E : forall v : R, (-1) * - v = v) by (intros; ring).
  specialize (D (- y)); rewrite E in D; apply D; lra.
Qed.
Lemma near_right (P : R -> Prop) r : 0 < r -> (forall t, 0 < t < r -> P t) -> at_right 0 P.
Proof.
  intros R H; exists (mkposreal r R); intros y B Y; apply H; change (Rabs (y - 0) < r) in B.
  rewrite Rminus_0_r in B; apply Rabs_def2 in B; lra.
Qed.
Lemma near_infinity (P : R -> Prop) M : (forall t, M < t -> P t) -> Rbar_locally p_infty P.
Proof. intros H; exists M; exact H. Qed.
Lemma t_right : filterlim (fun t : R => t) (at_right 0) (Rbar_locally 0).
Proof. intros P [d D]; exists d; intros y B _; now apply D. Qed.
Lemma t_infinity : filterlim (fun t : R => t) (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof. apply filterlim_id. Qed.

(* L'Hopital's rule. *)
Lemma right_eps (h : R -> R) (l : R) : filterlim h (at_right 0) (locally l) <->
  forall e, 0 < e -> exists d, 0 < d /\ forall x, 0 < x < d -> Rabs (h x - l) < e.
Proof.
  split.
  - intros H e E; destruct (proj1 (filterlim_locally h l) H (mkposreal e E)) as [d D].
    exists d; split; [apply cond_pos |]; intros x X; apply D; [| lra].
    change (Rabs (x - 0) < d); rewrite Rminus_0_r, Rabs_pos_eq; lra.
  - intros H; apply filterlim_locally; intros e; destruct (H e (cond_pos e)) as [d [P D]].
    now apply (near_right _ d P).
Qed.
Section Hopital.
Variables (f g df dg : R -> R) (l r : R).
Hypotheses (R0 : 0 < r) (Df : forall x, 0 < x < r -> is_derive f x (df x))
  (Dg : forall x, 0 < x < r -> is_derive g x (dg x)) (N : forall x, 0 < x < r -> dg x <> 0)
  (L : filterlim (fun x => df x * / dg x) (at_right 0) (locally l)).
Lemma increments e : 0 < e -> exists d, 0 < d /\ d <= r /\
  forall y x, 0 < y -> y < x -> x < d -> Rabs (f x - f y - l * (g x - g y)) <= e * Rabs (g x - g y).
Proof.
  intros E; destruct (proj1 (right_eps _ l) L e E) as [d [P D]].
  exists (Rmin d r); split; [now apply Rmin_pos | split; [apply Rmin_r |]].
  intros y x Y X B; pose proof (Rmin_l d r); pose proof (Rmin_r d r).
  destruct (MVT_cor2 (fun t => (f x - f y) * g t - (g x - g y) * f t)
    (fun t => (f x - f y) * dg t - (g x - g y) * df t) y x X) as [c [Q C]].
  - intros t T; apply is_derive_Reals.
    apply (is_derive_minus (fun t => (f x - f y) * g t) (fun t => (g x - g y) * f t));
      apply is_derive_scal; [apply Dg | apply Df]; lra.
  - assert (Z : (f x - f y) * dg c = (g x - g y) * df c) by nra.
    assert (M : dg c <> 0) by (apply N; lra).
    replace (f x - f y - l * (g x - g y)) with ((df c * / dg c - l) * (g x - g y)).
    + rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos | left; apply D; lra].
    + replace (f x - f y) with ((f x - f y) * dg c * / dg c) by (field; exact M).
      rewrite Z; ring.
Qed.
Lemma hopital_0 : (forall x, 0 < x < r -> g x <> 0) -> filterlim f (at_right 0) (locally 0) ->
  filterlim g (at_right 0) (locally 0) ->
  filterlim (fun x => f x * / g x) (at_right 0) (locally l).
Proof.
  intros G A B; apply right_eps; intros e E.
  destruct (increments (e / 2) ltac:(lra)) as [d [P [Q D]]]; exists d; split; [exact P |].
  intros x X; assert (K : Rabs (f x - l * g x) <= e / 2 * Rabs (g x)).
  { apply Rnot_lt_le; intros H.
    set (m := (Rabs (f x - l * g x) - e / 2 * Rabs (g x)) / (2 * (1 + Rabs l + e))).
    pose proof (Rabs_pos l) as PL.
    assert (M : 0 < m) by (apply Rdiv_lt_0_compat; lra).
    destruct (proj1 (right_eps _ 0) A m M) as [u [U V]].
    destruct (proj1 (right_eps _ 0) B m M) as [v [W Y]].
    set (y := Rmin (x / 2) (Rmin (u / 2) (v / 2))).
    assert (0 < y) by (repeat apply Rmin_pos; lra).
    assert (y <= x / 2) by apply Rmin_l.
    assert (y <= u / 2) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
    assert (y <= v / 2) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_r]).
    specialize (D y x ltac:(lra) ltac:(lra) ltac:(lra)).
    specialize (V y ltac:(lra)); specialize (Y y ltac:(lra)); rewrite Rminus_0_r in V, Y.
    assert (T1 : Rabs (f x - l * g x) <= Rabs (f x - f y - l * (g x - g y)) + Rabs (f y) + Rabs l * Rabs (g y)).
    { replace (f x - l * g x) with ((f x - f y - l * (g x - g y)) + f y + - (l * g y)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp, Rabs_mult.
      pose proof (Rabs_triang (f x - f y - l * (g x - g y)) (f y)); lra. }
    assert (T2 : Rabs (g x - g y) <= Rabs (g x) + Rabs (g y)).
    { replace (g x - g y) with (g x + - g y) by ring; eapply Rle_trans; [apply Rabs_triang |].
      rewrite Rabs_Ropp; lra. }
    assert (T3 : m * (2 * (1 + Rabs l + e)) = Rabs (f x - l * g x) - e / 2 * Rabs (g x)).
    { unfold m; field; lra. }
    pose proof (Rabs_pos (g y)); nra. }
  assert (H := G x ltac:(lra)); assert (0 < Rabs (g x)) by now apply Rabs_pos_lt.
  replace (f x * / g x - l) with ((f x - l * g x) * / g x) by (field; exact H).
  rewrite Rabs_mult, Rabs_inv.
  apply Rle_lt_trans with (e / 2 * Rabs (g x) * / Rabs (g x)).
  - apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat | exact K].
  - rewrite Rmult_assoc, Rinv_r; lra.
Qed.
Lemma hopital_infinite : filterlim g (at_right 0) (Rbar_locally p_infty) ->
  filterlim (fun x => f x * / g x) (at_right 0) (locally l).
Proof.
  intros B; apply right_eps; intros e E.
  destruct (increments (e / 4) ltac:(lra)) as [d [P [Q D]]].
  set (x := d / 2).
  set (c := Rabs (f x - l * g x) + e / 4 * Rabs (g x)).
  assert (C : 0 <= c).
  { unfold c; pose proof (Rabs_pos (f x - l * g x)); pose proof (Rabs_pos (g x)); nra. }
  destruct (B (fun y => 2 * c / e + 1 < y)) as [u U]; [now exists (2 * c / e + 1) |].
  exists (Rmin x u); split; [apply Rmin_pos; [unfold x; lra | apply cond_pos] |].
  intros y Y; pose proof (Rmin_l x u); pose proof (Rmin_r x u).
  assert (G : 2 * c / e + 1 < g y).
  { apply U; [| lra]; change (Rabs (y - 0) < u); rewrite Rminus_0_r, Rabs_pos_eq; lra. }
  assert (0 <= 2 * c / e) by (apply Rdiv_le_0_compat; lra).
  specialize (D y x ltac:(lra) ltac:(lra) ltac:(unfold x; lra)).
  assert (K : Rabs (f y - l * g y) <= c + e / 4 * g y).
  { assert (T1 : Rabs (f y - l * g y) <= Rabs (f x - l * g x) + Rabs (f x - f y - l * (g x - g y))).
    { replace (f y - l * g y) with ((f x - l * g x) + - (f x - f y - l * (g x - g y))) by ring.
      eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra. }
    assert (T2 : Rabs (g x - g y) <= Rabs (g x) + g y).
    { replace (g x - g y) with (g x + - g y) by ring; eapply Rle_trans; [apply Rabs_triang |].
      rewrite Rabs_Ropp, (Rabs_pos_eq (g y)); lra. }
    unfold c; nra. }
  replace (f y * / g y - l) with ((f y - l * g y) * / g y) by (field; lra).
  rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (g y)) by lra.
  apply Rle_lt_trans with ((c + e / 4 * g y) * / g y).
  - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | exact K].
  - assert (c < e / 2 * g y).
    { apply Rlt_trans with (e / 2 * (2 * c / e + 1)); [| apply Rmult_lt_compat_l; lra].
      replace (e / 2 * (2 * c / e + 1)) with (c + e / 2) by (field; lra); lra. }
    apply (Rmult_lt_reg_r (g y)); [lra |]; rewrite Rmult_assoc, Rinv_l by lra; nra.
Qed.
End Hopital.

(* The same at infinity, by x = 1/t. *)
Lemma from_infinity (f : R -> R) G : filterlim f (Rbar_locally p_infty) G ->
  filterlim (fun t => f (/ t)) (at_right 0) G.
Proof. intros H; exact (filterlim_comp _ _ _ _ _ _ _ _ filterlim_Rinv_0_right H). Qed.
Lemma to_infinity (f : R -> R) G : filterlim (fun t => f (/ t)) (at_right 0) G ->
  filterlim f (Rbar_locally p_infty) G.
Proof.
  intros H P Q; destruct (H P Q) as [d D]; exists (Rmax 1 (/ d)); intros y Y.
  assert (1 < y) by (eapply Rle_lt_trans; [apply Rmax_l | exact Y]).
  assert (/ d < y) by (eapply Rle_lt_trans; [apply Rmax_r | exact Y]).
  rewrite <- (Rinv_inv y); apply D; [| apply Rinv_0_lt_compat; lra].
  change (Rabs (/ y - 0) < d); rewrite Rminus_0_r, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra).
  rewrite <- (Rinv_inv d); apply Rinv_lt_contravar; [| assumption].
  apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat, cond_pos | lra].
Qed.
Section HopitalFar.
Variables (f g df dg : R -> R) (l M : R).
Hypotheses (M0 : 0 < M) (Df : forall x, M < x -> is_derive f x (df x))
  (Dg : forall x, M < x -> is_derive g x (dg x)) (N : forall x, M < x -> dg x <> 0)
  (L : filterlim (fun x => df x * / dg x) (Rbar_locally p_infty) (locally l)).
Lemma beyond_M t : 0 < t < / M -> M < / t.
Proof.
  intros T; rewrite <- (Rinv_inv M); apply Rinv_lt_contravar; [| lra].
  apply Rmult_lt_0_compat; [lra | now apply Rinv_0_lt_compat].
Qed.
Lemma d_far (h dh : R -> R) t : (forall x, M < x -> is_derive h x (dh x)) -> 0 < t < / M ->
  is_derive (fun t => h (/ t)) t (- / (t * t) * dh (/ t)).
Proof.
  intros D T; apply (d_comp (fun t => / t)); [| apply D, beyond_M, T].
  apply (d_eq _ _ (- 1 / (t * t))); [| unfold Rdiv; field; lra].
  apply (d_inv (fun t => t)); [apply d_id | lra].
Qed.
Lemma slopes_far : filterlim (fun t => (- / (t * t) * df (/ t)) * / (- / (t * t) * dg (/ t)))
  (at_right 0) (locally l).
Proof.
  apply (t_beside (at_right 0) (fun t => df (/ t) * / dg (/ t)) _ l); [| exact (from_infinity _ _ L)].
  apply (near_right _ (/ M)); [now apply Rinv_0_lt_compat |]; intros t T.
  assert (dg (/ t) <> 0) by (apply N, beyond_M, T); field; lra.
Qed.
Lemma slopes_apart t : 0 < t < / M -> - / (t * t) * dg (/ t) <> 0.
Proof.
  intros T; apply Rmult_integral_contrapositive; split; [| apply N, beyond_M, T].
  apply Ropp_neq_0_compat, Rinv_neq_0_compat; nra.
Qed.
Lemma hopital_0_far : (forall x, M < x -> g x <> 0) -> filterlim f (Rbar_locally p_infty) (locally 0) ->
  filterlim g (Rbar_locally p_infty) (locally 0) ->
  filterlim (fun x => f x * / g x) (Rbar_locally p_infty) (locally l).
Proof.
  intros G A B; apply to_infinity.
  apply (hopital_0 (fun t => f (/ t)) (fun t => g (/ t)) (fun t => - / (t * t) * df (/ t))
    (fun t => - / (t * t) * dg (/ t)) l (/ M)).
  - now apply Rinv_0_lt_compat.
  - intros t T; now apply d_far.
  - intros t T; now apply d_far.
  - exact slopes_apart.
  - exact slopes_far.
  - intros t T; apply G, beyond_M, T.
  - now apply from_infinity.
  - now apply from_infinity.
Qed.
Lemma hopital_infinite_far : filterlim g (Rbar_locally p_infty) (Rbar_locally p_infty) ->
  filterlim (fun x => f x * / g x) (Rbar_locally p_infty) (locally l).
Proof.
  intros B; apply to_infinity.
  apply (hopital_infinite (fun t => f (/ t)) (fun t => g (/ t)) (fun t => - / (t * t) * df (/ t))
    (fun t => - / (t * t) * dg (/ t)) l (/ M)).
  - now apply Rinv_0_lt_compat.
  - intros t T; now apply d_far.
  - intros t T; now apply d_far.
  - exact slopes_apart.
  - exact slopes_far.
  - now apply from_infinity.
Qed.
End HopitalFar.
Lemma t_tanh_infinity : filterlim tanh (Rbar_locally p_infty) (Rbar_locally 1).
Proof.
  apply (t_beside (Rbar_locally p_infty) (fun x => 1 + (-2) * / (exp x * exp x + 1))).
  { exists 0; intros x X; rewrite tanh_law; pose proof (exp_pos x).
    assert (0 < exp x * exp x) by (now apply Rmult_lt_0_compat); field; split; nra. }
  pose proof t_exp_infinity as E.
  assert (S : filterlim (fun x => exp x * exp x + 1) (Rbar_locally p_infty) (Rbar_locally p_infty)).
  { apply (t_plus (Rbar_locally p_infty) (fun x => exp x * exp x) (fun _ => 1) p_infty 1);
      [| apply (t_const (Rbar_locally p_infty)) | reflexivity].
    apply (t_mult (Rbar_locally p_infty) exp exp p_infty p_infty); [exact E | exact E | reflexivity]. }
  apply (t_inv_infinite _ _ p_infty) in S; [| reflexivity | easy].
  apply (t_value _ _ (1 + -2 * 0)); [| apply f_equal; ring].
  apply (t_plus (Rbar_locally p_infty) (fun _ => 1) (fun x => (-2) * / (exp x * exp x + 1)) 1 (-2 * 0));
    [apply (t_const (Rbar_locally p_infty)) | | reflexivity].
  apply (t_mult (Rbar_locally p_infty) (fun _ => -2) (fun x => / (exp x * exp x + 1)) (-2) 0);
    [apply (t_const (Rbar_locally p_infty)) | exact S | reflexivity].
Qed.

(* What the scripts of limits leave. *)
Lemma asin_half : asin (1 / 2) = PI / 6.
Proof. rewrite <- sin_PI6; apply asin_sin; pose proof PI_RGT_0; lra. Qed.
Ltac at_values := repeat match goal with
  | |- context [exp ?u] => worth exp u 0 1 exp_0
  | |- context [ln ?u] => worth ln u 1 0 ln_1
  | |- context [sin ?u] => worth sin u 0 0 sin_0
  | |- context [cos ?u] => worth cos u 0 1 cos_0
  | |- context [sin ?u] => worth sin u PI 0 sin_PI
  | |- context [cos ?u] => worth cos u PI (-1) cos_PI
  | |- context [sin ?u] => worth sin u (PI / 2) 1 sin_PI2
  | |- context [cos ?u] => worth cos u (PI / 2) 0 cos_PI2
  | |- context [sin ?u] => worth sin u (2 * PI) 0 sin_2PI
  | |- context [tan ?u] => worth tan u 0 0 tan_0
  | |- context [atan ?u] => worth atan u 0 0 atan_0
  | |- context [ln ?u] => worth ln u (exp 1) 1 (ln_exp 1)
  | |- context [atan ?u] => worth atan u 1 (PI / 4) atan_1
  | |- context [asin ?u] => worth asin u 0 0 asin_0
  | |- context [asin ?u] => worth asin u 1 (PI / 2) asin_1
  | |- context [asin ?u] => worth asin u (1 / 2) (PI / 6) asin_half
  | |- context [sinh ?u] => worth sinh u 0 0 sinh_0
  | |- context [cosh ?u] => worth cosh u 0 1 cosh_0
  | |- context [tanh ?u] => worth tanh u 0 0 tanh_0
  | |- context [sqrt ?u] => worth sqrt u 1 1 sqrt_1
  | |- context [sqrt ?u] => worth sqrt u 0 0 sqrt_0
  end.
(* Equal arguments are made the same, and signs taken out of even and odd functions. *)
Ltac same_argument f := repeat match goal with
  | |- context [f ?u] => match goal with |- context [f ?v] =>
      tryif constr_eq u v then fail else
        replace (f u) with (f v) by (f_equal; first [ring | field; repeat split; assumption]) end
  end.
Ltac merge :=
  rewrite ?Rplus_0_l;
  repeat match goal with
  | |- context [sin ((-1) * ?u)] => replace (sin ((-1) * u)) with (- sin u) by (rewrite <- sin_neg; f_equal; ring)
  | |- context [cos ((-1) * ?u)] => replace (cos ((-1) * u)) with (cos u) by (rewrite <- cos_neg; f_equal; ring)
  end;
  same_argument sin; same_argument cos; same_argument exp; same_argument ln; same_argument sqrt;
  same_argument atan; same_argument asin.
Ltac equal_numbers :=
  cbv beta; first [reflexivity | ring | lra | field; repeat split; side
    | progress at_values; first [reflexivity | ring | lra | field; repeat split; side]
    | at_values; rewrite ?Rabs_pos_eq by lra; merge;
      first [reflexivity | ring | lra | field; repeat split; side]
    | rewrite ?exp_ln, ?ln_exp by side; first [ring | field; side]].
Ltac equal_limits := apply f_equal; equal_numbers.
Ltac product_value := first
  [ reflexivity
  | apply is_Rbar_mult_p_infty_pos; simpl; first [side | interval] | apply is_Rbar_mult_p_infty_neg; simpl; first [side | interval]
  | apply is_Rbar_mult_m_infty_pos; simpl; first [side | interval] | apply is_Rbar_mult_m_infty_neg; simpl; first [side | interval]
  | apply is_Rbar_mult_sym; first
      [ apply is_Rbar_mult_p_infty_pos; simpl; first [side | interval] | apply is_Rbar_mult_p_infty_neg; simpl; first [side | interval]
      | apply is_Rbar_mult_m_infty_pos; simpl; first [side | interval] | apply is_Rbar_mult_m_infty_neg; simpl; first [side | interval] ] ].
Ltac apart_ := cbv beta; pose proof pi_between;
  first
    [ side | nra
    | facts; first [side | nra]
    | lazymatch goal with
      | |- _ * _ <> 0 => apply Rmult_integral_contrapositive; split; apart_
      | |- _ ^ _ <> 0 => apply pow_nonzero; apart_
      | |- / _ <> 0 => apply Rinv_neq_0_compat; apart_
      | |- _ <> 0 => first [apply Rgt_not_eq; solve [apart_ | beside] | apply Rlt_not_eq; solve [apart_ | beside]]
      | |- _ /\ _ => split; apart_
      | |- 0 < _ * _ => apply Rmult_lt_0_compat; apart_
      | |- 0 < / _ => apply Rinv_0_lt_compat; apart_
      | |- 0 < Rabs _ => apply Rabs_pos_lt; apart_
      | |- _ > 0 => apply Rlt_gt; apart_
      | |- 0 < sqrt _ => apply sqrt_lt_R0; apart_
      | |- 0 < _ ^ _ => apply pow_lt; apart_
      end
    | beside
    | interval ].
Lemma Rpower_less x n : 0 < x -> Rpower x (n + (-1)) = Rpower x n * / x.
Proof.
  intros X; rewrite Rpower_plus; f_equal.
  replace (-1) with (- (1)) by ring; now rewrite Rpower_Ropp, Rpower_1.
Qed.
Lemma t_point (f : R -> R) (a : R) : filterlim f (at_point a) (locally (f a)).
Proof. intros P H; exact (locally_singleton _ _ H). Qed.
Lemma t_point_value (f : R -> R) (a v : R) : f a = v -> filterlim f (at_point a) (locally v).
Proof. intros <-; apply t_point. Qed.
Ltac exp_minus := repeat match goal with
  | |- context [exp ((-1) * ?u)] => replace (exp ((-1) * u)) with (/ exp u) by (rewrite <- exp_Ropp; f_equal; ring)
  | |- context [exp ((-1) * ?a * ?u)] =>
      replace (exp ((-1) * a * u)) with (/ exp (a * u)) by (rewrite <- exp_Ropp; f_equal; ring)
  end.
Ltac exp_apart := repeat match goal with
  | |- context [exp ?u] => lazymatch goal with H : 0 < exp u |- _ => fail | _ => pose proof (exp_pos u) end
  end.
Ltac equal_near := cbv beta; pose proof pi_between; merge; exp_minus; exp_apart; first
  [ reflexivity | ring | field; repeat split; apart_
  | unfold Rpower, tan, cot, sec, csc; rewrite ?exp_Ropp, ?exp_plus; first [ring | field; repeat split; first [apply Rgt_not_eq, exp_pos | apart_]]
  | rewrite Rpower_less by apart_; field; repeat split; apart_
  | unfold tan; match goal with |- context [sin ?u] => field [(sin_square u)]; repeat split; apart_ end
  | f_equal; solve [ring | field; repeat split; apart_]
  | unfold Rpower; rewrite <- ?exp_Ropp, <- ?exp_plus; f_equal; ring
  | match goal with |- context [sqrt ?u] =>
      let P := fresh in let E := fresh in let g := fresh in
      assert (P : 0 < sqrt u) by (apply sqrt_lt_R0; apart_);
      assert (E : sqrt u ^ 2 = u) by (apply pow2_sqrt; apart_);
      set (g := sqrt u) in *; clearbody g; field [E]; repeat split; apart_
    end ].
Ltac slope_near := eapply d_eq; [derive; cbv beta; apart_ | tidy; first [equal_near | slope]].
Ltac bounded_near := cbv beta; apply Rabs_le; first [apply SIN_bound | apply COS_bound | split; apart_].
Ltac ends_here := cbv beta in *; unfold Rmin, Rmax in *;
  repeat match goal with
  | X : context [Rle_dec ?a ?b] |- _ => destruct (Rle_dec a b)
  | X : context [exp ?u] |- _ => new_fact (1 + u <= exp u) ltac:(apply exp_ineq1_le)
  end.
Ltac inside_ := cbv beta; try lra; ends_here;
  first [lra | side | apart_ | exfalso; first [lra | nra]].
Ltac inside := intros; inside_.
Ltac continues_inside := intros; unfold Rpower; continues; inside_.
Lemma sum_induction (c : nat) (f : nat -> R) (low : nat) (F : nat -> R) :
  F O = terms f low c -> (forall n, F (S n) = F n + f (low + (c + n))%nat) ->
  forall n, terms f low (c + n) = F n.
Proof.
  intros Z D n; induction n as [|n IH]; [now rewrite Nat.add_0_r |].
  rewrite Nat.add_succ_r; cbn [terms]; now rewrite IH, D.
Qed.
Lemma natural_minus c n : (c <= n)%nat -> exists m, n = (c + m)%nat.
Proof. intros H; exists (n - c)%nat; lia. Qed.
Ltac equal_terms := unfold_whole; first [equal_whole | whole_numbers; equal_numbers].
