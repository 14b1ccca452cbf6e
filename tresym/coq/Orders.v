(* Orders and limits along a path: lemmas for their proofs; the statements need no definition. *)

(* What orders follow from: limits of quotients. *)
Section Orders.
Context {T : Type} {F : (T -> Prop) -> Prop} {FF : Filter F}.
Implicit Types (f g h : T -> R).
Lemma q_near f g (l eps : R) : 0 < eps -> F (fun x => g x <> 0) ->
  filterlim (fun x => f x * / g x) F (Rbar_locally l) -> F (fun x => Rabs (f x - l * g x) <= eps * Rabs (g x)).
Proof.
  intros E N L; pose proof (proj1 (filterlim_locally _ l) L (mkposreal eps E)) as B.
  generalize (filter_and _ _ N B); apply filter_imp; intros x [G H].
  change (Rabs (f x * / g x - l) < eps) in H.
  replace (f x - l * g x) with ((f x * / g x - l) * g x) by (field; exact G).
  rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos | lra].
Qed.
Lemma o_of_limit f g : F (fun x => g x <> 0) -> filterlim (fun x => f x * / g x) F (Rbar_locally 0) ->
  forall eps, 0 < eps -> F (fun x => Rabs (f x) <= eps * Rabs (g x)).
Proof.
  intros N L eps E; generalize (q_near f g 0 eps E N L); apply filter_imp; intros x H.
  now replace (f x) with (f x - 0 * g x) by ring.
Qed.
Lemma like_of_limit f g : F (fun x => g x <> 0) -> filterlim (fun x => f x * / g x) F (Rbar_locally 1) ->
  forall eps, 0 < eps -> F (fun x => Rabs (f x - g x) <= eps * Rabs (g x)).
Proof.
  intros N L eps E; generalize (q_near f g 1 eps E N L); apply filter_imp; intros x H.
  now replace (f x - g x) with (f x - 1 * g x) by ring.
Qed.
Lemma O_of_limit f g (l : R) : F (fun x => g x <> 0) ->
  filterlim (fun x => f x * / g x) F (Rbar_locally l) -> exists C, F (fun x => Rabs (f x) <= C * Rabs (g x)).
Proof.
  intros N L; exists (Rabs l + 1); generalize (q_near f g l 1 Rlt_0_1 N L); apply filter_imp; intros x H.
  replace (f x) with (f x - l * g x + l * g x) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite (Rabs_mult l); lra.
Qed.
Lemma Theta_of_limit f g (l : R) : l <> 0 -> F (fun x => g x <> 0) ->
  filterlim (fun x => f x * / g x) F (Rbar_locally l) ->
  exists c C, 0 < c /\ F (fun x => c * Rabs (g x) <= Rabs (f x) /\ Rabs (f x) <= C * Rabs (g x)).
Proof.
  intros Z N L; pose proof (Rabs_pos_lt l Z) as P.
  exists (Rabs l / 2), (Rabs l + Rabs l / 2); split; [lra |].
  generalize (q_near f g l (Rabs l / 2) ltac:(lra) N L); apply filter_imp; intros x H.
  pose proof (Rabs_triang_inv (l * g x) (l * g x - f x)) as A; rewrite Rabs_minus_sym in H.
  replace (l * g x - (l * g x - f x)) with (f x) in A by ring.
  pose proof (Rabs_triang (f x - l * g x) (l * g x)) as B; rewrite Rabs_minus_sym in B.
  replace (f x - l * g x + l * g x) with (f x) in B by ring; rewrite !(Rabs_mult l) in *; lra.
Qed.
Lemma omega_of_limit f g : F (fun x => f x <> 0) ->
  filterlim (fun x => g x * / f x) F (Rbar_locally 0) -> forall M, F (fun x => M * Rabs (g x) < Rabs (f x)).
Proof.
  intros N L M; pose proof (Rabs_pos M) as P.
  assert (E : 0 < / (Rabs M + 1)) by (apply Rinv_0_lt_compat; lra).
  generalize (filter_and _ _ N (o_of_limit g f N L _ E)); apply filter_imp; intros x [Z H].
  pose proof (Rabs_pos_lt _ Z) as Q; pose proof (Rabs_pos (g x)) as G.
  assert ((Rabs M + 1) * Rabs (g x) <= Rabs (f x)).
  { apply (Rmult_le_compat_l (Rabs M + 1)) in H; [| lra].
    now replace ((Rabs M + 1) * (/ (Rabs M + 1) * Rabs (f x))) with (Rabs (f x)) in H by (field; lra). }
  pose proof (Rle_abs M); destruct (Req_dec (g x) 0) as [-> | K]; [rewrite Rabs_R0 in *; lra |].
  pose proof (Rabs_pos_lt _ K); nra.
Qed.
Lemma O_plus f g h : (exists C, F (fun x => Rabs (f x) <= C * Rabs (h x))) ->
  (exists C, F (fun x => Rabs (g x) <= C * Rabs (h x))) ->
  exists C, F (fun x => Rabs (f x + g x) <= C * Rabs (h x)).
Proof.
  intros [C A] [D B]; exists (C + D); generalize (filter_and _ _ A B); apply filter_imp; intros x [P Q].
  pose proof (Rabs_triang (f x) (g x)); lra.
Qed.
Lemma O_bounded f g h (c : R) : F (fun x => Rabs (f x) <= c) ->
  (exists C, F (fun x => Rabs (g x) <= C * Rabs (h x))) -> exists C, F (fun x => Rabs (f x * g x) <= C * Rabs (h x)).
Proof.
  intros A [C B]; exists (Rabs c * C); generalize (filter_and _ _ A B); apply filter_imp; intros x [P Q].
  rewrite Rabs_mult, Rmult_assoc; pose proof (Rabs_pos (f x)); pose proof (Rabs_pos (g x)); pose proof (Rle_abs c).
  apply Rmult_le_compat; lra.
Qed.
Lemma O_beside f g h : F (fun x => f x = g x) -> (exists C, F (fun x => Rabs (g x) <= C * Rabs (h x))) ->
  exists C, F (fun x => Rabs (f x) <= C * Rabs (h x)).
Proof.
  intros E [C B]; exists C; generalize (filter_and _ _ E B); apply filter_imp; intros x [-> Q]; exact Q.
Qed.
End Orders.

(* Sequences, as functions at whole numbers. *)
Lemma along_whole (P : R -> Prop) : Rbar_locally p_infty P -> eventually (fun n : nat => P (INR n)).
Proof.
  intros [M H]; destruct (nfloor_ex (Rmax 0 M) (Rmax_l 0 M)) as [k [_ K]].
  exists (S k); intros n N; apply H; apply le_INR in N; rewrite S_INR in N; pose proof (Rmax_r 0 M); lra.
Qed.
Lemma whole_limit (f : R -> R) (G : (R -> Prop) -> Prop) : filterlim f (Rbar_locally p_infty) G ->
  filterlim (fun n : nat => f (INR n)) eventually G.
Proof. intros H P Q; exact (along_whole (fun x => P (f x)) (H P Q)). Qed.
Lemma whole_beside (f g : nat -> R) (G : (R -> Prop) -> Prop) : eventually (fun n => f n = g n) ->
  filterlim g eventually G -> filterlim f eventually G.
Proof. intros E; apply filterlim_ext_loc; revert E; apply filter_imp; intros n H; now symmetry. Qed.
Lemma whole_power x n : 0 < x -> x ^ n = exp (INR n * ln x).
Proof. intros X; rewrite <- (Rpower_pow n x X); reflexivity. Qed.

(* Expansions: f = P + O(t^n) as t -> 0 from above, with P bounded. *)
Fixpoint taylor (n : nat) (c : nat -> R) (u : R) : R :=
  match n with O => 0 | S m => taylor m c u + c m * u ^ m end.
Lemma taylor_at_0 n c : taylor (S n) c 0 = c O.
Proof.
  induction n as [|n IH]; [simpl; ring |].
  change (taylor (S n) c 0 + c (S n) * 0 ^ S n = c O); rewrite IH; simpl; ring.
Qed.
Lemma taylor_derive n c u :
  is_derive (taylor (S n) (fun k => c k / INR (fact k))) u (taylor n (fun k => c (S k) / INR (fact k)) u).
Proof.
  induction n as [|n IH]; [simpl; auto_derive; [trivial | ring] |].
  change (is_derive (fun u => taylor (S n) (fun k => c k / INR (fact k)) u + c (S n) / INR (fact (S n)) * u ^ S n) u
    (taylor n (fun k => c (S k) / INR (fact k)) u + c (S n) / INR (fact n) * u ^ n)).
  apply (d_plus (taylor (S n) (fun k => c k / INR (fact k))) (fun u => c (S n) / INR (fact (S n)) * u ^ S n)); [exact IH |].
  assert (D : is_derive (fun u : R => u ^ S n) u (INR (S n) * 1 * u ^ n)) by apply (is_derive_pow (fun u => u) (S n) u 1 (d_id u)).
  eapply d_eq; [exact (is_derive_scal _ _ (c (S n) / INR (fact (S n))) _ D) |].
  rewrite fact_simpl, mult_INR; field; split; [apply INR_fact_neq_0 | apply not_0_INR; lia].
Qed.
Lemma taylor_rest n : forall (h : nat -> R -> R) (a r : R), 0 < r ->
  (forall k u, (k < n)%nat -> Rabs (u - a) < r -> is_derive (h k) u (h (S k) u)) -> continuous (h n) a ->
  exists C d, 0 <= C /\ 0 < d /\ forall u, Rabs u < d ->
    Rabs (h O (a + u) - taylor n (fun k => h k a / INR (fact k)) u) <= C * Rabs u ^ n.
Proof.
  induction n as [|n IH]; intros h a r R0 D K.
  - destruct (proj1 (filterlim_locally _ _) K (mkposreal 1 Rlt_0_1)) as [d B].
    exists (Rabs (h O a) + 1), d; split; [pose proof (Rabs_pos (h O a)); lra | split; [apply cond_pos |]].
    intros u U; simpl; assert (Q : Rabs (a + u - a) < d) by now replace (a + u - a) with u by ring.
    specialize (B (a + u) Q); change (Rabs (h O (a + u) - h O a) < 1) in B.
    pose proof (Rabs_triang (h O (a + u) - h O a) (h O a)) as H.
    replace (h O (a + u) - h O a + h O a) with (h O (a + u) - 0) in H by ring; lra.
  - destruct (IH (fun k => h (S k)) a r R0) as [C [d [C0 [P B]]]].
    { intros k u L U; apply (D (S k)); [lia | exact U]. }
    { exact K. }
    exists C, (Rmin d r); split; [exact C0 | split; [now apply Rmin_pos |]]; intros u U.
    pose proof (Rmin_l d r); pose proof (Rmin_r d r).
    set (g := fun u => h O (a + u) - taylor (S n) (fun k => h k a / INR (fact k)) u).
    set (dg := fun u => h (S O) (a + u) - taylor n (fun k => h (S k) a / INR (fact k)) u).
    assert (G : forall s, Rabs s < Rmin d r -> is_derive g s (dg s)).
    { intros s Q; apply (d_minus (fun u => h O (a + u)) (taylor (S n) (fun k => h k a / INR (fact k)))).
      - assert (I : is_derive (fun u : R => a + u) s 1) by (eapply d_eq; [derive | ring]).
        assert (J : is_derive (h O) (a + s) (h 1%nat (a + s))) by (apply D; [lia | replace (a + s - a) with s by ring; lra]).
        eapply d_eq; [exact (is_derive_comp (h O) (fun u => a + u) s _ _ J I) |].
        change (1 * h 1%nat (a + s) = h 1%nat (a + s)); ring.
      - exact (taylor_derive n (fun k => h k a) s). }
    assert (Z : g 0 = 0).
    { unfold g; rewrite taylor_at_0, Rplus_0_r; simpl; field. }
    assert (inside : forall s, Rmin 0 u <= s <= Rmax 0 u -> Rabs s <= Rabs u).
    { intros s; unfold Rmin, Rmax, Rabs; destruct (Rle_dec 0 u), (Rcase_abs s), (Rcase_abs u); lra. }
    destruct (MVT_gen g 0 u dg) as [c [I E]].
    + intros s Q; apply G; specialize (inside s ltac:(lra)); lra.
    + intros s Q; apply continuity_pt_filterlim, (ex_derive_continuous g s); exists (dg s); apply G.
      specialize (inside s Q); lra.
    + specialize (inside c I); fold (g u); replace (g u) with (dg c * u) by (rewrite Z in E; lra).
      rewrite Rabs_mult; simpl; rewrite (Rmult_comm (Rabs u)), <- Rmult_assoc.
      apply Rmult_le_compat_r; [apply Rabs_pos |].
      specialize (B c ltac:(lra)); fold (dg c) in B; eapply Rle_trans; [exact B |].
      apply Rmult_le_compat_l; [assumption |]; apply pow_incr; split; [apply Rabs_pos | exact inside].
Qed.
Definition germ (n : nat) (f P : R -> R) : Prop :=
  exists C, at_right 0 (fun t => Rabs (P t) <= C /\ Rabs (f t - P t) <= C * t ^ n).
Lemma right_bounded (S : R -> R) : continuous S 0 -> exists C, 0 <= C /\ at_right 0 (fun t => Rabs (S t) <= C).
Proof.
  intros K; destruct (proj1 (filterlim_locally _ _) K (mkposreal 1 Rlt_0_1)) as [d B].
  exists (Rabs (S 0) + 1); split; [pose proof (Rabs_pos (S 0)); lra |].
  exists d; intros t T _; specialize (B t T); change (Rabs (S t - S 0) < 1) in B.
  pose proof (Rabs_triang (S t - S 0) (S 0)) as H; replace (S t - S 0 + S 0) with (S t) in H by ring; lra.
Qed.
Lemma right_small : at_right 0 (fun t : R => 0 < t < 1).
Proof. apply (near_right _ 1 Rlt_0_1); intros t T; exact T. Qed.
Lemma g_ext n f g P : at_right 0 (fun t => f t = g t) -> germ n g P -> germ n f P.
Proof. intros E [C H]; exists C; generalize (filter_and _ _ E H); apply filter_imp; intros t [-> Q]; exact Q. Qed.
Lemma g_self n P : continuous P 0 -> germ n P P.
Proof.
  intros K; destruct (right_bounded P K) as [C [C0 H]]; exists C.
  generalize (filter_and _ _ H right_small); apply filter_imp; intros t [Q T]; split; [exact Q |].
  rewrite Rminus_eq_0, Rabs_R0; apply Rmult_le_pos; [exact C0 | apply pow_le; lra].
Qed.
Lemma g_const n c : germ n (fun _ => c) (fun _ => c).
Proof. apply (g_self n (fun _ => c)), (continuous_const c). Qed.
Lemma g_id n : germ n (fun t => t) (fun t => t).
Proof. apply (g_self n (fun t => t)), continuous_id. Qed.
Lemma g_plus n f g P Q : germ n f P -> germ n g Q -> germ n (fun t => f t + g t) (fun t => P t + Q t).
Proof.
  intros [C A] [D B]; exists (C + D); generalize (filter_and _ _ A B); apply filter_imp; intros t [[A1 A2] [B1 B2]].
  pose proof (Rabs_triang (P t) (Q t)); pose proof (Rabs_triang (f t - P t) (g t - Q t)).
  replace (f t + g t - (P t + Q t)) with (f t - P t + (g t - Q t)) by ring; lra.
Qed.
Lemma g_mult n f g P Q : germ n f P -> germ n g Q -> germ n (fun t => f t * g t) (fun t => P t * Q t).
Proof.
  intros [C A] [D B]; exists (3 * (Rabs C * Rabs D)).
  generalize (filter_and _ _ (filter_and _ _ A B) right_small); apply filter_imp; intros t [[[A1 A2] [B1 B2]] T].
  pose proof (Rle_abs C) as C1; pose proof (Rle_abs D) as D1; pose proof (Rabs_pos C); pose proof (Rabs_pos D).
  assert (0 <= t ^ n) by (apply pow_le; lra); assert (t ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
  pose proof (Rabs_pos (P t)); pose proof (Rabs_pos (Q t)); pose proof (Rabs_pos (f t - P t)); pose proof (Rabs_pos (g t - Q t)).
  assert (A3 : Rabs (P t) <= Rabs C) by lra; assert (B3 : Rabs (Q t) <= Rabs D) by lra.
  assert (A4 : Rabs (f t - P t) <= Rabs C * t ^ n) by nra; assert (B4 : Rabs (g t - Q t) <= Rabs D * t ^ n) by nra.
  split.
  - rewrite Rabs_mult; assert (Rabs (P t) * Rabs (Q t) <= Rabs C * Rabs D) by (apply Rmult_le_compat; assumption).
    assert (0 <= Rabs C * Rabs D) by (apply Rmult_le_pos; assumption); lra.
  - replace (f t * g t - P t * Q t) with ((f t - P t) * Q t + P t * (g t - Q t) + (f t - P t) * (g t - Q t)) by ring.
    assert (H7 : Rabs ((f t - P t) * Q t) <= Rabs C * t ^ n * Rabs D) by (rewrite Rabs_mult; apply Rmult_le_compat; assumption).
    assert (H8 : Rabs (P t * (g t - Q t)) <= Rabs C * (Rabs D * t ^ n)) by (rewrite Rabs_mult; apply Rmult_le_compat; assumption).
    assert (H9 : Rabs ((f t - P t) * (g t - Q t)) <= Rabs C * t ^ n * (Rabs D * 1)).
    { rewrite Rabs_mult; apply Rmult_le_compat; trivial; eapply Rle_trans; [exact B4 |]; now apply Rmult_le_compat_l. }
    eapply Rle_trans; [apply Rabs_triang |]; pose proof (Rabs_triang ((f t - P t) * Q t) (P t * (g t - Q t))).
    replace (3 * (Rabs C * Rabs D) * t ^ n) with (Rabs C * t ^ n * Rabs D + Rabs C * (Rabs D * t ^ n) + Rabs C * t ^ n * (Rabs D * 1)) by ring; lra.
Qed.
Lemma g_cut n m f P W S : (n <= m)%nat -> germ m f P -> continuous W 0 -> continuous S 0 ->
  (forall t, P t = W t + t ^ n * S t) -> germ n f W.
Proof.
  intros L [C A] KW KS E; destruct (right_bounded W KW) as [D [D0 B]]; destruct (right_bounded S KS) as [G [G0 H]].
  exists (D + (Rabs C + G)); generalize (filter_and _ _ (filter_and _ _ A (filter_and _ _ B H)) right_small).
  apply filter_imp; intros t [[[A1 A2] [B1 H1]] T].
  assert (X : 0 <= t ^ n) by (apply pow_le; lra).
  assert (Y : t ^ m <= t ^ n).
  { replace m with (n + (m - n))%nat by lia; rewrite pow_add.
    assert (t ^ (m - n) <= 1) by (rewrite <- (pow1 (m - n)); apply pow_incr; lra); nra. }
  assert (0 <= t ^ m) by (apply pow_le; lra); pose proof (Rle_abs C); pose proof (Rabs_pos C).
  split; [lra |]; replace (f t - W t) with (f t - P t + t ^ n * S t) by (rewrite E; ring).
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_mult, (Rabs_pos_eq _ X).
  assert (C * t ^ m <= Rabs C * t ^ n) by nra; nra.
Qed.
Lemma g_product n f g P Q W S : germ n f P -> germ n g Q -> continuous W 0 -> continuous S 0 ->
  (forall t, P t * Q t = W t + t ^ n * S t) -> germ n (fun t => f t * g t) W.
Proof.
  intros A B KW KS E.
  exact (g_cut n n _ (fun t => P t * Q t) W S (le_n n) (g_mult n f g P Q A B) KW KS E).
Qed.
Lemma g_shift n k f P Q : germ (k + n) f P -> continuous Q 0 -> (forall t, P t = t ^ k * Q t) ->
  germ n (fun t => f t * / t ^ k) Q.
Proof.
  intros [C A] K E; destruct (right_bounded Q K) as [D [D0 B]]; exists (D + Rabs C).
  generalize (filter_and _ _ (filter_and _ _ A B) right_small); apply filter_imp; intros t [[[A1 A2] B1] T].
  assert (X : 0 < t ^ k) by (apply pow_lt; lra); assert (Y : 0 <= t ^ n) by (apply pow_le; lra).
  pose proof (Rle_abs C); pose proof (Rabs_pos C); split; [lra |].
  replace (f t * / t ^ k - Q t) with ((f t - P t) * / t ^ k) by (rewrite E; field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ t ^ k)) by (left; now apply Rinv_0_lt_compat).
  apply (Rmult_le_reg_r (t ^ k)); [exact X |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  rewrite pow_add in A2; assert (Z : 0 <= t ^ k * t ^ n) by (apply Rmult_le_pos; lra).
  replace ((D + Rabs C) * t ^ n * t ^ k) with (D * (t ^ k * t ^ n) + Rabs C * (t ^ k * t ^ n)) by ring.
  assert (0 <= D * (t ^ k * t ^ n)) by (apply Rmult_le_pos; assumption).
  assert (C * (t ^ k * t ^ n) <= Rabs C * (t ^ k * t ^ n)) by (apply Rmult_le_compat_r; assumption); lra.
Qed.
Lemma g_raise n k f P : germ n f P -> germ (k + n) (fun t => f t * t ^ k) (fun t => P t * t ^ k).
Proof.
  intros [C A]; exists (Rabs C); generalize (filter_and _ _ A right_small); apply filter_imp; intros t [[A1 A2] T].
  assert (X : 0 <= t ^ k) by (apply pow_le; lra); assert (X1 : t ^ k <= 1) by (rewrite <- (pow1 k); apply pow_incr; lra).
  assert (Y : 0 <= t ^ n) by (apply pow_le; lra).
  pose proof (Rle_abs C); pose proof (Rabs_pos C); pose proof (Rabs_pos (P t)).
  split; [rewrite Rabs_mult, (Rabs_pos_eq _ X); nra |].
  replace (f t * t ^ k - P t * t ^ k) with ((f t - P t) * t ^ k) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq _ X), pow_add.
  assert (C * t ^ n <= Rabs C * t ^ n) by nra; assert (0 <= Rabs (f t - P t)) by apply Rabs_pos; nra.
Qed.
Lemma g_limit n f P : germ (S n) f P -> continuous P 0 -> filterlim f (at_right 0) (Rbar_locally (P 0)).
Proof.
  intros [C A] K; apply right_eps; intros e E.
  assert (K' : filterlim P (at_right 0) (locally (P 0))).
  { intros Q HQ; destruct (K Q HQ) as [d D]; exists d; intros y Y _; exact (D y Y). }
  destruct (proj1 (right_eps _ _) K' (e / 2) ltac:(lra)) as [d1 [D1 H1]].
  destruct A as [d A]; pose proof (cond_pos d); pose proof (Rabs_pos C); pose proof (Rle_abs C).
  set (d2 := e / (2 * (Rabs C + 1))); assert (D2 : 0 < d2) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin (Rmin d 1) (Rmin d1 d2)); split; [repeat apply Rmin_pos; lra |]; intros x X.
  pose proof (Rmin_l (Rmin d 1) (Rmin d1 d2)); pose proof (Rmin_r (Rmin d 1) (Rmin d1 d2)).
  pose proof (Rmin_l d1 d2); pose proof (Rmin_r d1 d2); pose proof (Rmin_l d 1); pose proof (Rmin_r d 1).
  assert (B : ball 0 d x) by (change (Rabs (x - 0) < d); rewrite Rminus_0_r, Rabs_pos_eq; lra).
  destruct (A x B ltac:(lra)) as [_ A2]; specialize (H1 x ltac:(lra)).
  assert (Y : x ^ S n <= x).
  { simpl; assert (x ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra); nra. }
  assert (0 <= x ^ S n) by (apply pow_le; lra).
  assert (C * x ^ S n <= Rabs C * d2) by nra.
  assert (Rabs C * d2 < e / 2).
  { apply Rlt_le_trans with ((Rabs C + 1) * d2); [nra | right; unfold d2; field; lra]. }
  replace (f x - P 0) with (f x - P x + (P x - P 0)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang |]; lra.
Qed.
Lemma taylor_ext n c d u : (forall k, (k < n)%nat -> c k = d k) -> taylor n c u = taylor n d u.
Proof.
  induction n as [|n IH]; intros H; [reflexivity |]; simpl; rewrite IH, (H n); [reflexivity | lia | intros; apply H; lia].
Qed.
Lemma g_power n v V m : germ n v V -> germ n (fun t => v t ^ m) (fun t => V t ^ m).
Proof. intros H; induction m as [|m IM]; [apply (g_const n 1) | simpl; now apply (g_mult n v (fun t => v t ^ m))]. Qed.
Lemma g_taylor n m c v V : germ n v V -> germ n (fun t => taylor m c (v t)) (fun t => taylor m c (V t)).
Proof.
  intros H; induction m as [|m IH]; [apply (g_const n 0) |]; simpl.
  apply (g_plus n (fun t => taylor m c (v t)) (fun t => c m * v t ^ m)); [exact IH |].
  apply (g_mult n (fun _ => c m) (fun t => v t ^ m)); [apply g_const | now apply g_power].
Qed.
Lemma g_outer n (h : nat -> R -> R) (c : nat -> R) (a r : R) f P V W S : 0 < r ->
  (forall k u, (k < n)%nat -> Rabs (u - a) < r -> is_derive (h k) u (h (Datatypes.S k) u)) -> continuous (h n) a ->
  (forall k, (k < n)%nat -> h k a = c k * INR (fact k)) ->
  germ n f P -> continuous V 0 -> (forall t, P t = a + t * V t) -> continuous W 0 -> continuous S 0 ->
  (forall t, taylor n c (t * V t) = W t + t ^ n * S t) -> (0 < n)%nat -> germ n (fun t => h O (f t)) W.
Proof.
  intros R0 D K N A KV E KW KS Q L.
  destruct (taylor_rest n h a r R0 D K) as [C [d [C0 [d0 T]]]].
  assert (B : germ n (fun t => f t - a) (fun t => t * V t)).
  { apply (g_ext n _ (fun t => f t + - a)); [apply filter_forall; intros; ring |].
    apply (g_cut n n _ (fun t => P t + - a) (fun t => t * V t) (fun _ => 0)); [lia | | | apply (continuous_const 0) |].
    - apply (g_plus n f (fun _ => - a) P (fun _ => - a) A (g_const n (- a))).
    - apply (c_mult (fun t => t) V); [apply continuous_id | exact KV].
    - intros t; rewrite E; ring. }
  pose proof (g_taylor n n c _ _ B) as G.
  apply (g_cut n n _ (fun t => taylor n c (t * V t)) W S); [lia | | exact KW | exact KS | exact Q].
  destruct G as [C1 G]; destruct B as [C2 B]; destruct (right_bounded V KV) as [C3 [C30 B3]].
  set (M := Rabs C2 + C3); assert (M0 : 0 <= M) by (unfold M; pose proof (Rabs_pos C2); lra).
  exists (Rabs C1 + C * M ^ n).
  assert (near : at_right 0 (fun t : R => 0 < t < d / (M + 1))).
  { apply (near_right _ (d / (M + 1))); [apply Rdiv_lt_0_compat; lra | trivial]. }
  generalize (filter_and _ _ (filter_and _ _ G (filter_and _ _ B B3)) (filter_and _ _ right_small near)).
  apply filter_imp; intros t [[[G1 G2] [[B1 B2] B4]] [T1 T2]].
  assert (X : 0 <= t ^ n) by (apply pow_le; lra); assert (Y : t ^ n <= t).
  { destruct n as [|m]; [lia |]; simpl; assert (t ^ m <= 1) by (rewrite <- (pow1 m); apply pow_incr; lra); nra. }
  pose proof (Rle_abs C1); pose proof (Rabs_pos C1); pose proof (Rle_abs C2); pose proof (Rabs_pos C2).
  assert (Z : 0 <= C * M ^ n) by (apply Rmult_le_pos; [exact C0 | now apply pow_le]).
  split; [lra |].
  assert (U : Rabs (f t - a) <= M * t).
  { replace (f t - a) with (f t - a - t * V t + t * V t) by ring; eapply Rle_trans; [apply Rabs_triang |].
    rewrite Rabs_mult, (Rabs_pos_eq t) by lra; unfold M; assert (C2 * t ^ n <= Rabs C2 * t) by nra; nra. }
  assert (U1 : Rabs (f t - a) < d).
  { eapply Rle_lt_trans; [exact U |]; destruct T2 as [_ T2].
    apply (Rmult_lt_compat_l (M + 1)) in T2; [| lra].
    replace ((M + 1) * (d / (M + 1))) with d in T2 by (field; lra); nra. }
  specialize (T (f t - a) U1); replace (a + (f t - a)) with (f t) in T by ring.
  rewrite (taylor_ext n _ c) in T.
  2: { intros k Hk; rewrite (N k Hk); field; apply INR_fact_neq_0. }
  assert (U2 : Rabs (f t - a) ^ n <= M ^ n * t ^ n).
  { rewrite <- Rpow_mult_distr; apply pow_incr; split; [apply Rabs_pos | exact U]. }
  replace (h O (f t) - taylor n c (t * V t)) with
    (h O (f t) - taylor n c (f t - a) + (taylor n c (f t - a) - taylor n c (t * V t))) by ring.
  eapply Rle_trans; [apply Rabs_triang |].
  assert (C * Rabs (f t - a) ^ n <= C * (M ^ n * t ^ n)) by now apply Rmult_le_compat_l.
  assert (C1 * t ^ n <= Rabs C1 * t ^ n) by nra.
  replace ((Rabs C1 + C * M ^ n) * t ^ n) with (C * (M ^ n * t ^ n) + Rabs C1 * t ^ n) by ring; lra.
Qed.
Lemma g_less n m f P : (n <= m)%nat -> germ m f P -> germ n f P.
Proof.
  intros L [C A]; exists (Rabs C); generalize (filter_and _ _ A right_small); apply filter_imp; intros t [[A1 A2] T].
  assert (Y : t ^ m <= t ^ n).
  { replace m with (n + (m - n))%nat by lia; rewrite pow_add.
    assert (t ^ (m - n) <= 1) by (rewrite <- (pow1 (m - n)); apply pow_incr; lra).
    assert (0 <= t ^ n) by (apply pow_le; lra); nra. }
  assert (0 <= t ^ m) by (apply pow_le; lra); pose proof (Rle_abs C); pose proof (Rabs_pos C).
  split; [lra |]; assert (C * t ^ m <= Rabs C * t ^ n) by nra; lra.
Qed.
Fixpoint whole_fact (n : nat) : R := match n with O => 1 | S m => whole_fact m * IZR (Z.of_nat (S m)) end.
Lemma whole_fact_R n : INR (fact n) = whole_fact n.
Proof. induction n as [|n IH]; [reflexivity | rewrite fact_simpl, mult_INR, IH; cbn [whole_fact]; rewrite <- INR_IZR_INZ; ring]. Qed.
Lemma g_above n f P : germ (S n) f P -> continuous P 0 -> 0 < P 0 -> at_right 0 (fun t => 0 < f t).
Proof.
  intros A K Z; pose proof (g_limit n f P A K) as L; apply (L (fun y => 0 < y)); simpl.
  exists (mkposreal _ Z); intros y Y; change (Rabs (y - P 0) < P 0) in Y; apply Rabs_def2 in Y; lra.
Qed.
Lemma g_apart n f P : germ (S n) f P -> continuous P 0 -> P 0 <> 0 -> at_right 0 (fun t => f t <> 0).
Proof.
  intros A K Z; pose proof (g_limit n f P A K) as L; apply (L (fun y => y <> 0)); simpl.
  exists (mkposreal _ (Rabs_pos_lt _ Z)); intros y Y ->; change (Rabs (0 - P 0) < Rabs (P 0)) in Y.
  rewrite Rminus_0_l, Rabs_Ropp in Y; lra.
Qed.
Lemma g_infinite n k f P : germ (S n) (fun t => f t * t ^ S k) P -> continuous P 0 -> 0 < P 0 ->
  filterlim f (at_right 0) (Rbar_locally p_infty).
Proof.
  intros A K Z; pose proof (g_limit n _ P A K) as L.
  apply (t_beside (at_right 0) (fun t => f t * t ^ S k * / t ^ S k) f p_infty).
  { apply (near_right _ 1 Rlt_0_1); intros t T; field; apply pow_nonzero; lra. }
  apply (t_mult (at_right 0) (fun t => f t * t ^ S k) (fun t => / t ^ S k) (P 0) p_infty p_infty); [exact L | |].
  - apply (t_inv_above (at_right 0) (fun t => t ^ S k)).
    + pose proof (t_outer (at_right 0) (fun u => u ^ S k) (fun t => t) 0 t_right) as H; simpl in H.
      rewrite Rmult_0_l in H; apply H; simpl.
      apply (c_mult (fun u => u) (fun u => u ^ k)); [apply continuous_id | apply (c_pow (fun u => u) k), continuous_id].
    + apply (near_right _ 1 Rlt_0_1); intros t T; apply pow_lt; lra.
  - apply is_Rbar_mult_sym, is_Rbar_mult_p_infty_pos; exact Z.
Qed.
Lemma g_infinite_below n k f P : germ (S n) (fun t => f t * t ^ S k) P -> continuous P 0 -> P 0 < 0 ->
  filterlim f (at_right 0) (Rbar_locally m_infty).
Proof.
  intros A K Z; assert (B : filterlim (fun t => - f t) (at_right 0) (Rbar_locally p_infty)).
  { apply (g_infinite n k (fun t => - f t) (fun t => - 1 * P t)); [| apply (c_mult (fun _ => - 1) P); [apply (continuous_const (- 1)) | exact K] | lra].
    apply (g_ext _ _ (fun t => - 1 * (f t * t ^ S k))); [apply filter_forall; intros t; ring |].
    apply (g_mult _ (fun _ => - 1) (fun t => f t * t ^ S k) (fun _ => - 1) P); [apply g_const | exact A]. }
  apply (filterlim_ext (fun t => - - f t)); [intros; ring |].
  exact (filterlim_comp _ _ _ _ _ _ _ _ B (filterlim_Rbar_opp p_infty)).
Qed.
Lemma sqrt_by y x : 0 < y -> sqrt (y * y * x) = y * sqrt x.
Proof. intros Y; rewrite sqrt_mult_alt by nra; now rewrite R_sqrt.sqrt_square by lra. Qed.
Lemma sqrt_out t m x : 0 < t -> sqrt x * / t ^ m = sqrt (x * / t ^ (m + m)).
Proof.
  intros T; assert (X : 0 < t ^ m) by now apply pow_lt.
  replace (x * / t ^ (m + m)) with (/ t ^ m * / t ^ m * x) by (rewrite pow_add, Rinv_mult; ring).
  rewrite (sqrt_by (/ t ^ m) x); [ring | now apply Rinv_0_lt_compat].
Qed.
Lemma sqrt_in t m x : 0 < t -> sqrt x * t ^ m = sqrt (x * t ^ (m + m)).
Proof.
  intros T; replace (x * t ^ (m + m)) with (t ^ m * t ^ m * x) by (rewrite pow_add; ring).
  rewrite (sqrt_by (t ^ m) x); [ring | now apply pow_lt].
Qed.

(* What holds near the ends, from what holds near 0. *)
Lemma near_from_right (a : R) (P : R -> Prop) : at_right 0 (fun t => P (a + t)) -> at_right a P.
Proof.
  intros [d D]; exists d; intros y B Y; replace y with (a + (y - a)) by ring; apply D; [| lra].
  change (Rabs (y - a - 0) < d); rewrite Rminus_0_r; exact B.
Qed.
Lemma near_from_left (a : R) (P : R -> Prop) : at_right 0 (fun t => P (a + (-1) * t)) -> at_left a P.
Proof.
  intros [d D]; exists d; intros y B Y; replace y with (a + (-1) * (a - y)) by ring; apply D; [| lra].
  change (Rabs (a - y - 0) < d); rewrite Rminus_0_r, Rabs_minus_sym; exact B.
Qed.
Lemma near_from_both (a : R) (P : R -> Prop) : at_right a P -> at_left a P -> locally' a P.
Proof.
  intros [d D] [e E]; exists (mkposreal (Rmin d e) (Rmin_pos d e (cond_pos d) (cond_pos e))); intros y B Y.
  change (Rabs (y - a) < Rmin d e) in B; pose proof (Rmin_l d e); pose proof (Rmin_r d e).
  destruct (Rtotal_order y a) as [L | [L | L]]; [apply E | contradiction | apply D]; try exact L;
    [change (Rabs (y - a) < e) | change (Rabs (y - a) < d)]; lra.
Qed.
Lemma near_from_infinity (P : R -> Prop) : at_right 0 (fun t => P (/ t)) -> Rbar_locally p_infty P.
Proof.
  intros [d D]; exists (/ d); intros y Y; pose proof (cond_pos d).
  assert (0 < / d) by now apply Rinv_0_lt_compat.
  rewrite <- (Rinv_inv y); apply D; [| apply Rinv_0_lt_compat; lra].
  change (Rabs (/ y - 0) < d); rewrite Rminus_0_r, Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra).
  rewrite <- (Rinv_inv d); apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | exact Y].
Qed.
Lemma near_from_below (P : R -> Prop) : Rbar_locally p_infty (fun t => P ((-1) * t)) -> Rbar_locally m_infty P.
Proof.
  intros [M D]; exists (- M); intros y Y; replace y with ((-1) * ((-1) * y)) by ring; apply D; lra.
Qed.
Lemma near_from_square (P : R -> Prop) : at_right 0 (fun t => P (t ^ 2)) -> at_right 0 P.
Proof.
  intros [d D]; exists (mkposreal (d * d) (Rmult_lt_0_compat _ _ (cond_pos d) (cond_pos d))); intros y B Y.
  change (Rabs (y - 0) < d * d) in B; rewrite Rminus_0_r, Rabs_pos_eq in B by lra; pose proof (cond_pos d).
  rewrite <- (pow2_sqrt y) by lra; apply D; [| now apply sqrt_lt_R0].
  change (Rabs (sqrt y - 0) < d); rewrite Rminus_0_r, Rabs_pos_eq by apply sqrt_pos.
  rewrite <- (R_sqrt.sqrt_square d) by lra; apply sqrt_lt_1; lra.
Qed.
Lemma ends_square (f : R -> R) G : filterlim (fun t => f (t ^ 2)) (at_right 0) G -> filterlim f (at_right 0) G.
Proof. intros H P Q; exact (near_from_square (fun x => P (f x)) (H P Q)). Qed.

(* Tactics of the scripts. *)
Ltac g_side := cbv beta; first [assumption | lra | nra | side | apart_].
Ltac g_field := first [ring | field; repeat split; g_side | at_values; field; repeat split; g_side].
Ltac g_near := apply (near_right _ 1 Rlt_0_1); intros t T; cbv beta.
Ltac g_poly := intros; cbn [taylor]; cbv beta iota; first [g_field | at_values; g_field].
Ltac g_each k tac := first [exfalso; lia | destruct k as [|k]; [cbv beta iota; tac () | g_each k tac]].
Ltac g_slopes := let k := fresh in let u := fresh in intros k u ? U; apply Rabs_def2 in U;
  g_each k ltac:(fun _ => eapply d_eq; [derive; g_side | tidy; first [ring | field; repeat split; g_side | slope]]).
Ltac g_values := let k := fresh in intros k ?; rewrite whole_fact_R;
  g_each k ltac:(fun _ => cbn [whole_fact Z.of_nat Pos.of_succ_nat Pos.succ]; first [g_field | at_values; rewrite ?sqrt_1; g_field]).
Ltac g_continues := cbv beta iota; continues; g_side.

(* Orders with a constant on a region: Taylor's theorem from the right. *)
Lemma rises (f df : R -> R) r : (forall u, 0 <= u <= r -> is_derive f u (df u)) ->
  (forall u, 0 <= u <= r -> 0 <= df u) -> f 0 = 0 -> forall t, 0 <= t <= r -> 0 <= f t.
Proof.
  intros D P Z t T; destruct (MVT_gen f 0 t df) as [c [I E]].
  - intros u U; rewrite Rmin_left, Rmax_right in U by lra; apply D; lra.
  - intros u U; rewrite Rmin_left, Rmax_right in U by lra.
    apply continuity_pt_filterlim, (ex_derive_continuous f u); exists (df u); apply D; lra.
  - rewrite Rmin_left, Rmax_right in I by lra; specialize (P c ltac:(lra)); nra.
Qed.
Lemma taylor_right n : forall (h : nat -> R -> R) (M r : R),
  (forall k u, (k < n)%nat -> 0 <= u <= r -> is_derive (h k) u (h (S k) u)) ->
  (forall k, (k < n)%nat -> h k 0 = 0) -> (forall u, 0 <= u <= r -> Rabs (h n u) <= M) ->
  forall t, 0 <= t <= r -> Rabs (h O t) <= M / INR (fact n) * t ^ n.
Proof.
  induction n as [|n IH]; intros h M r D Z B t T.
  - specialize (B t T); simpl; lra.
  - assert (B1 : forall u, 0 <= u <= r -> Rabs (h 1%nat u) <= M / INR (fact n) * u ^ n).
    { intros u U; refine (IH (fun k => h (S k)) M r _ _ _ u U).
      - intros k v K V; apply (D (S k)); [lia | exact V].
      - intros k K; apply Z; lia.
      - exact B. }
    assert (P : forall u, is_derive (fun u : R => M / INR (fact (S n)) * u ^ S n) u (M / INR (fact n) * u ^ n)).
    { intros u; assert (Q : is_derive (fun u : R => u ^ S n) u (INR (S n) * 1 * u ^ n))
        by apply (is_derive_pow (fun u => u) (S n) u 1 (d_id u)).
      eapply d_eq; [exact (is_derive_scal _ _ (M / INR (fact (S n))) _ Q) |].
      rewrite fact_simpl, mult_INR; field; split; [apply INR_fact_neq_0 | apply not_0_INR; lia]. }
    assert (Z0 : h O 0 = 0) by (apply Z; lia).
    assert (E : M / INR (fact (S n)) * 0 ^ S n = 0) by (simpl; ring).
    assert (D0 : forall u, 0 <= u <= r -> is_derive (h O) u (h 1%nat u)) by (intros; apply D; [lia | assumption]).
    apply Rabs_le; split.
    + assert (0 <= M / INR (fact (S n)) * t ^ S n + h O t); [| lra].
      apply (rises (fun u => M / INR (fact (S n)) * u ^ S n + h O u) (fun u => M / INR (fact n) * u ^ n + h 1%nat u) r); [| | lra | exact T].
      * intros u U; exact (d_plus _ _ _ _ _ (P u) (D0 u U)).
      * intros u U; specialize (B1 u U); apply Rabs_le_between in B1; lra.
    + assert (0 <= M / INR (fact (S n)) * t ^ S n - h O t); [| lra].
      apply (rises (fun u => M / INR (fact (S n)) * u ^ S n - h O u) (fun u => M / INR (fact n) * u ^ n - h 1%nat u) r); [| | lra | exact T].
      * intros u U; exact (d_minus _ _ _ _ _ (P u) (D0 u U)).
      * intros u U; specialize (B1 u U); apply Rabs_le_between in B1; lra.
Qed.
Lemma taylor_within n (h : nat -> R -> R) (C r : R) :
  (forall k u, (k < n)%nat -> 0 <= u <= r -> is_derive (h k) u (h (S k) u)) ->
  (forall k, (k < n)%nat -> h k 0 = 0) -> (forall u, 0 <= u <= r -> Rabs (h n u) <= C * whole_fact n) ->
  forall t, 0 <= t <= r -> Rabs (h O t) <= C * t ^ n.
Proof.
  intros D Z B t T; rewrite <- whole_fact_R in B; pose proof (taylor_right n h _ r D Z B t T) as A.
  eapply Rle_trans; [exact A |]; right; field; apply INR_fact_neq_0.
Qed.
Lemma scaled (f g h c C t : R) n k : 0 < t -> h = f * t ^ k -> g * t ^ k = c * t ^ n ->
  Rabs h <= C * Rabs c * t ^ n -> Rabs f <= C * Rabs g.
Proof.
  intros T H G B; assert (K : 0 < t ^ k) by now apply pow_lt.
  assert (N : 0 < t ^ n) by now apply pow_lt.
  apply (f_equal Rabs) in H; apply (f_equal Rabs) in G; rewrite !Rabs_mult, ?(Rabs_pos_eq (t ^ k)), ?(Rabs_pos_eq (t ^ n)) in * by lra.
  apply (Rmult_le_reg_r (t ^ k)); [exact K |]; rewrite <- H, Rmult_assoc, G; lra.
Qed.
Lemma two_sides (u v : R) : 0 <= v + u -> 0 <= v - u -> Rabs u <= v.
Proof. intros; apply Rabs_le; lra. Qed.
Lemma sqrt_pull t j x y : 0 < t -> y = x * t ^ (j + j) -> sqrt x = sqrt y * / t ^ j.
Proof.
  intros T ->; rewrite <- sqrt_in by exact T; assert (0 < t ^ j) by now apply pow_lt.
  field; lra.
Qed.
Ltac w_side := cbv beta; first
  [ assumption | lra | nra | positive
  | apply Rgt_not_eq; first [positive | nra | interval]
  | apply Rlt_not_eq; first [nra | interval] | interval | apart_ ].
Ltac w_slopes := let k := fresh in let u := fresh in intros k u ? U;
  g_each k ltac:(fun _ => eapply d_eq; [derive; w_side | tidy; first [ring | field; repeat split; w_side | slope]]).
Ltac w_values := let k := fresh in intros k ?;
  g_each k ltac:(fun _ => first [g_field | at_values; rewrite ?sqrt_1; g_field | equal_numbers]).
Ltac w_equal := cbv beta; first [ring | field; repeat split; w_side].
Lemma far_side x X r : 0 < X -> X <= x -> / X = r -> 0 < / x <= r.
Proof.
  intros P L <-; split; [apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; assumption].
Qed.
Lemma asin_turned x : asin ((-1) * x) = (-1) * asin x.
Proof. replace ((-1) * x) with (- x) by ring; rewrite asin_opp; ring. Qed.
Lemma without_signs (f g C u v : R) : Rabs f = u -> Rabs g = v -> u <= C * v -> Rabs f <= C * Rabs g.
Proof. intros -> ->; exact (fun H => H). Qed.
Ltac w_region := first [w_side | split_Rabs; w_side].
Ltac w_positive := first [left; positive | lra | nra | left; apply exp_pos | left; apply Rinv_0_lt_compat; lra
  | apply Rmult_le_pos; w_positive | apply pow_le; w_positive].
