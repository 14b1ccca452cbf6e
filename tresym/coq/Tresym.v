(* The language of statements over Coq's real numbers, and what their proofs use of them.

   Coq's functions are total: 1/0, sqrt (-1) and ln 0 have values of which nothing is known. A
   statement therefore has what makes its parts defined among its premises. *)

Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Open Scope R_scope.

(* Functions of the language that Coq's library does not have. *)

Definition root (n : nat) (x : R) : R := sign x * Rpower (Rabs x) (/ INR n).
Definition cot (x : R) : R := cos x / sin x.
Definition sec (x : R) : R := / cos x.
Definition csc (x : R) : R := / sin x.
Definition coth (x : R) : R := cosh x / sinh x.
Definition sech (x : R) : R := / cosh x.
Definition csch (x : R) : R := / sinh x.
Definition acosh (x : R) : R := ln (x + sqrt (x ^ 2 - 1)).
Definition atanh (x : R) : R := ln ((1 + x) / (1 - x)) / 2.
Definition atan2 (y x : R) : R :=
  if Req_EM_T y 0 then if Rlt_dec x 0 then PI else 0 else 2 * atan (y / (sqrt (x ^ 2 + y ^ 2) + x)).

(* Signs and roots. *)

Lemma sign_pos x : 0 < x -> sign x = 1.
Proof. intros; unfold sign; destruct (total_order_T 0 x) as [[?|?]|?]; lra. Qed.
Lemma sign_neg x : x < 0 -> sign x = -1.
Proof. intros; unfold sign; destruct (total_order_T 0 x) as [[?|?]|?]; lra. Qed.
Lemma sign_zero : sign 0 = 0.
Proof. unfold sign; destruct (total_order_T 0 0) as [[?|?]|?]; lra. Qed.

Lemma root_pos n x : 0 < x -> root n x = Rpower x (/ INR n).
Proof. intros; unfold root; rewrite sign_pos, Rabs_pos_eq by lra; ring. Qed.
Lemma root_lt n x : 0 < x -> 0 < root n x.
Proof. intros; rewrite root_pos by lra; apply exp_pos. Qed.
Lemma root_zero n : root n 0 = 0.
Proof. unfold root; rewrite sign_zero; ring. Qed.
Lemma root_le n x : 0 <= x -> 0 <= root n x.
Proof. intros [H|H]; [left; now apply root_lt | subst; rewrite root_zero; lra]. Qed.
Lemma root_neg n x : x < 0 -> root n x = - root n (- x).
Proof.
  intros; unfold root; rewrite sign_neg, (sign_pos (- x)), Rabs_Ropp by lra; ring.
Qed.

Lemma root_pow_pos n x : 0 < x -> (n <> 0)%nat -> root n x ^ n = x.
Proof.
  intros H Hn; rewrite root_pos by lra.
  rewrite <- Rpower_pow by apply exp_pos; rewrite Rpower_mult, Rinv_l, Rpower_1; trivial.
  now apply not_0_INR.
Qed.
Lemma root_pow n x : 0 <= x -> (n <> 0)%nat -> root n x ^ n = x.
Proof.
  intros [H|H] Hn; [now apply root_pow_pos | subst; rewrite root_zero; now apply pow_i; lia].
Qed.
Lemma root_3_pow x : root 3 x ^ 3 = x.
Proof.
  destruct (Rle_or_lt 0 x); [apply root_pow; [lra | lia] |].
  rewrite root_neg by lra.
  replace ((- root 3 (- x)) ^ 3) with (- (root 3 (- x) ^ 3)) by ring.
  rewrite root_pow; [ring | lra | lia].
Qed.
Lemma root_nonzero n x : x <> 0 -> root n x <> 0.
Proof.
  intros H; destruct (Rle_or_lt 0 x) as [P|P].
  - apply Rgt_not_eq, root_lt; lra.
  - rewrite root_neg by lra; assert (0 < root n (- x)) by (apply root_lt; lra); lra.
Qed.

Lemma root_mult n x y : 0 < x -> 0 < y -> root n (x * y) = root n x * root n y.
Proof.
  intros; rewrite !root_pos; try lra; [| now apply Rmult_lt_0_compat].
  now apply eq_sym, Rpower_mult_distr.
Qed.
Lemma root_inv n x : 0 < x -> root n (/ x) = / root n x.
Proof.
  intros; rewrite !root_pos; try lra; [| now apply Rinv_0_lt_compat].
  unfold Rpower; rewrite ln_Rinv by lra; rewrite <- exp_Ropp; f_equal; ring.
Qed.

Lemma sqrt_unique x y : 0 <= y -> y ^ 2 = x -> sqrt x = y.
Proof. intros H E; rewrite <- E; now apply sqrt_pow2. Qed.
Lemma root_unique n x y : (n <> 0)%nat -> 0 < y -> y ^ n = x -> root n x = y.
Proof.
  intros N H E; rewrite <- E, root_pos by now apply pow_lt.
  rewrite <- Rpower_pow by exact H; rewrite Rpower_mult, Rinv_r, Rpower_1; trivial.
  now apply not_0_INR.
Qed.

(* Derivatives, one rule for each operation: [derive] leaves the conditions. *)

Lemma d_eq (f : R -> R) (x l m : R) : is_derive f x l -> l = m -> is_derive f x m.
Proof. intros H E; now rewrite <- E. Qed.
Lemma d_const (c x : R) : is_derive (fun _ : R => c) x 0.
Proof. exact (is_derive_const c x). Qed.
Lemma d_id (x : R) : is_derive (fun t : R => t) x 1.
Proof. exact (is_derive_id x). Qed.

Section Rules.
Variables (f g : R -> R) (x k l : R).
Hypotheses (Hf : is_derive f x k) (Hg : is_derive g x l).
Lemma d_plus : is_derive (fun t => f t + g t) x (k + l).
Proof. exact (is_derive_plus f g x k l Hf Hg). Qed.
Lemma d_minus : is_derive (fun t => f t - g t) x (k - l).
Proof. exact (is_derive_minus f g x k l Hf Hg). Qed.
Lemma d_opp : is_derive (fun t => - f t) x (- k).
Proof. exact (is_derive_opp f x k Hf). Qed.
Lemma d_mult : is_derive (fun t => f t * g t) x (k * g x + f x * l).
Proof. exact (is_derive_mult f g x k l Hf Hg Rmult_comm). Qed.
Lemma d_inv : f x <> 0 -> is_derive (fun t => / f t) x (- k / (f x * f x)).
Proof.
  intros H; apply (d_eq _ _ (- k / f x ^ 2)); [now apply is_derive_inv | now field].
Qed.
Lemma d_div : g x <> 0 -> is_derive (fun t => f t / g t) x ((k * g x - f x * l) / (g x * g x)).
Proof.
  intros H; apply (d_eq _ _ ((k * g x - f x * l) / g x ^ 2)); [now apply is_derive_div |].
  now field.
Qed.
Lemma d_pow n : is_derive (fun t => f t ^ n) x (INR n * k * f x ^ (pred n)).
Proof. now apply is_derive_pow. Qed.
Lemma d_comp (h : R -> R) m : is_derive h (f x) m -> is_derive (fun t => h (f t)) x (k * m).
Proof. intros H; exact (is_derive_comp h f x m k H Hf). Qed.
Lemma d_exp : is_derive (fun t => exp (f t)) x (k * exp (f x)).
Proof. apply d_comp, is_derive_exp. Qed.
Lemma d_ln : 0 < f x -> is_derive (fun t => ln (f t)) x (k * / f x).
Proof. intros; now apply d_comp, is_derive_ln. Qed.
Lemma d_sin : is_derive (fun t => sin (f t)) x (k * cos (f x)).
Proof. apply d_comp, is_derive_sin. Qed.
Lemma d_cos : is_derive (fun t => cos (f t)) x (k * - sin (f x)).
Proof. apply d_comp, is_derive_cos. Qed.
Lemma d_sqrt : 0 < f x -> is_derive (fun t => sqrt (f t)) x (k * / (2 * sqrt (f x))).
Proof.
  intros H; apply d_comp, is_derive_Reals, derivable_pt_lim_sqrt, H.
Qed.
Lemma d_atan : is_derive (fun t => atan (f t)) x (k * / (1 + f x * f x)).
Proof. apply d_comp, is_derive_atan. Qed.
Lemma d_asin : 0 < 1 - f x -> 0 < 1 + f x ->
  is_derive (fun t => asin (f t)) x (k * / sqrt ((-1) * f x ^ 2 + 1)).
Proof.
  intros H1 H2; apply d_comp; assert (H : -1 < f x < 1) by lra.
  replace ((-1) * f x ^ 2 + 1) with (1 - f x * f x) by ring.
  apply (d_eq _ _ (derive_pt asin (f x) (derivable_pt_asin (f x) H))).
  - apply is_derive_Reals; unfold derive_pt; exact (proj2_sig (derivable_pt_asin (f x) H)).
  - rewrite derive_pt_asin; unfold Rsqr, Rdiv; ring.
Qed.
Lemma d_acos : 0 < 1 - f x -> 0 < 1 + f x ->
  is_derive (fun t => acos (f t)) x (- k * / sqrt ((-1) * f x ^ 2 + 1)).
Proof.
  intros H1 H2; assert (H : -1 < f x < 1) by lra.
  replace ((-1) * f x ^ 2 + 1) with (1 - f x * f x) by ring.
  apply (d_eq _ _ (k * derive_pt acos (f x) (derivable_pt_acos (f x) H))).
  - apply d_comp, is_derive_Reals; unfold derive_pt.
    exact (proj2_sig (derivable_pt_acos (f x) H)).
  - rewrite derive_pt_acos; unfold Rsqr, Rdiv; ring.
Qed.
Lemma d_arcsinh : is_derive (fun t => arcsinh (f t)) x (k * / sqrt (f x ^ 2 + 1)).
Proof.
  apply d_comp, is_derive_Reals, derivable_pt_lim_arcsinh.
Qed.
Lemma d_sinh : is_derive (fun t => sinh (f t)) x (k * cosh (f x)).
Proof. apply d_comp, is_derive_Reals, derivable_pt_lim_sinh. Qed.
Lemma d_cosh : is_derive (fun t => cosh (f t)) x (k * sinh (f x)).
Proof. apply d_comp, is_derive_Reals, derivable_pt_lim_cosh. Qed.
Lemma d_Rabs : f x <> 0 -> is_derive (fun t => Rabs (f t)) x (k * sign (f x)).
Proof.
  intros H; apply (d_eq _ _ (sign (f x) * k)); [now apply is_derive_Rabs | ring].
Qed.
Lemma d_sign : f x <> 0 -> is_derive (fun t => sign (f t)) x 0.
Proof.
  intros H; apply (d_eq _ _ (k * 0)); [| ring]; apply d_comp.
  destruct (Rtotal_order (f x) 0) as [P|[P|P]]; [| contradiction |].
  - apply (is_derive_ext_loc (fun _ => -1)); [| exact (is_derive_const (-1) (f x))].
    exists (mkposreal (- f x) ltac:(lra)); intros y Hy; apply eq_sym, sign_neg.
    change (Rabs (y - f x) < - f x) in Hy; apply Rabs_def2 in Hy; lra.
  - apply (is_derive_ext_loc (fun _ => 1)); [| exact (is_derive_const 1 (f x))].
    exists (mkposreal (f x) P); intros y Hy; apply eq_sym, sign_pos.
    change (Rabs (y - f x) < f x) in Hy; apply Rabs_def2 in Hy; lra.
Qed.
End Rules.

Lemma d_Rpower (f g : R -> R) (x k l : R) : is_derive f x k -> is_derive g x l -> 0 < f x ->
  is_derive (fun t => Rpower (f t) (g t)) x
    ((l * ln (f x) + g x * (k * / f x)) * Rpower (f x) (g x)).
Proof.
  intros Hf Hg H; apply (d_exp (fun t => g t * ln (f t))).
  apply (d_mult g (fun t => ln (f t))); [exact Hg | now apply d_ln].
Qed.
Lemma d_atanh (f : R -> R) (x k : R) : is_derive f x k -> 0 < 1 - f x -> 0 < 1 + f x ->
  is_derive (fun t => atanh (f t)) x (k * / (1 - f x * f x)).
Proof.
  intros Hf H1 H2; unfold atanh.
  eapply d_eq.
  - apply (d_div (fun t => ln ((1 + f t) / (1 - f t))) (fun _ => 2)); [| apply d_const | lra].
    apply (d_ln (fun t => (1 + f t) / (1 - f t))); [| now apply Rdiv_lt_0_compat].
    apply (d_div (fun t => 1 + f t) (fun t => 1 - f t)); [| | lra].
    + apply (d_plus (fun _ => 1)); [apply d_const | exact Hf].
    + apply (d_minus (fun _ => 1)); [apply d_const | exact Hf].
  - field; repeat split; try lra.
    replace (1 - f x * f x) with ((1 - f x) * (1 + f x)) by ring.
    apply Rmult_integral_contrapositive; split; lra.
Qed.
Lemma cosh_pos x : 0 < cosh x.
Proof. unfold cosh; pose proof (exp_pos x); pose proof (exp_pos (- x)); lra. Qed.
Lemma cosh_sinh x : cosh x * cosh x - sinh x * sinh x = 1.
Proof.
  unfold cosh, sinh; assert (E : exp x * exp (- x) = 1)
    by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  rewrite <- E; field.
Qed.
Lemma d_tanh (f : R -> R) (x k : R) : is_derive f x k ->
  is_derive (fun t => tanh (f t)) x (k * / (cosh (f x) * cosh (f x))).
Proof.
  intros Hf; unfold tanh; pose proof (cosh_pos (f x)) as C; eapply d_eq.
  - apply (d_div (fun t => sinh (f t)) (fun t => cosh (f t)));
      [apply (d_sinh f _ _ Hf) | apply (d_cosh f _ _ Hf) | lra].
  - replace (k * cosh (f x) * cosh (f x) - sinh (f x) * (k * sinh (f x)))
      with (k * (cosh (f x) * cosh (f x) - sinh (f x) * sinh (f x))) by ring.
    rewrite cosh_sinh; field; lra.
Qed.
Lemma d_tan (f : R -> R) (x k : R) : is_derive f x k -> cos (f x) <> 0 ->
  is_derive (fun t => tan (f t)) x (k * / (cos (f x) * cos (f x))).
Proof.
  intros Hf H; unfold tan; eapply d_eq.
  - apply (d_div (fun t => sin (f t)) (fun t => cos (f t)));
      [apply (d_sin f _ _ Hf) | apply (d_cos f _ _ Hf) | exact H].
  - replace (k * cos (f x) * cos (f x) - sin (f x) * (k * - sin (f x)))
      with (k * (sin (f x) * sin (f x) + cos (f x) * cos (f x))) by ring.
    pose proof (sin2_cos2 (f x)) as E; unfold Rsqr in E; rewrite E; now field.
Qed.
Lemma d_root n (f : R -> R) (x k : R) : is_derive f x k -> (n <> 0)%nat -> f x <> 0 ->
  is_derive (fun t => root n (f t)) x (k * (root n (f x) / (INR n * f x))).
Proof.
  intros Hf Hn H; unfold root; eapply d_eq.
  - apply (d_mult (fun t => sign (f t)) (fun t => Rpower (Rabs (f t)) (/ INR n)));
      [eapply d_sign; eassumption |].
    apply (d_Rpower (fun t => Rabs (f t)) (fun _ => / INR n)).
    + eapply d_Rabs; eassumption.
    + apply d_const.
    + now apply Rabs_pos_lt.
  - cbv beta; assert (N : INR n <> 0) by now apply not_0_INR.
    assert (A : Rabs (f x) <> 0) by now apply Rabs_no_R0.
    set (p := Rpower _ _); clearbody p.
    destruct (Rtotal_order (f x) 0) as [P|[P|P]]; [| contradiction |].
    + rewrite sign_neg, Rabs_left in * by lra; field; auto.
    + rewrite sign_pos, Rabs_pos_eq in * by lra; field; auto.
Qed.


Lemma d_acosh (f : R -> R) (x k : R) : is_derive f x k -> 0 < f x - 1 ->
  is_derive (fun t => acosh (f t)) x (k * / (sqrt (f x - 1) * sqrt (f x + 1))).
Proof.
  intros Hf H; unfold acosh.
  assert (M : 0 < sqrt (f x - 1)) by now apply sqrt_lt_R0.
  assert (P : 0 < sqrt (f x + 1)) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt (f x ^ 2 - 1) = sqrt (f x - 1) * sqrt (f x + 1)).
  { rewrite <- sqrt_mult by lra; f_equal; ring. }
  pose proof (Rmult_lt_0_compat _ _ M P) as MP; eapply d_eq.
  - apply (d_ln (fun t => f t + sqrt (f t ^ 2 - 1))).
    + eapply (d_plus f (fun t => sqrt (f t ^ 2 - 1))); [exact Hf |].
      eapply (d_sqrt (fun t => f t ^ 2 - 1)); [| nra].
      apply (d_minus (fun t => f t ^ 2) (fun _ => 1)); [exact (d_pow f x k Hf 2) | apply d_const].
    + rewrite E; lra.
  - rewrite E; simpl; field; lra.
Qed.

(* Functions by the few that are left: sin, cos, exp, sign. *)

Lemma tan_law x : tan x = sin x * / cos x.
Proof. reflexivity. Qed.
Lemma cot_law x : cot x = cos x * / sin x.
Proof. reflexivity. Qed.
Lemma sinh_law x : sinh x = (exp x + (-1) * / exp x) * (1 / 2).
Proof. unfold sinh; rewrite exp_Ropp; unfold Rdiv; ring. Qed.
Lemma cosh_law x : cosh x = (exp x + / exp x) * (1 / 2).
Proof. unfold cosh; rewrite exp_Ropp; unfold Rdiv; ring. Qed.
Lemma exp_sum x : 0 < exp x + / exp x.
Proof. apply Rplus_lt_0_compat; [| apply Rinv_0_lt_compat]; apply exp_pos. Qed.
Lemma tanh_law x : tanh x = (exp x + (-1) * / exp x) * / (exp x + / exp x).
Proof.
  unfold tanh, Rdiv; rewrite sinh_law, cosh_law; pose proof (exp_sum x) as H.
  assert (P := exp_pos x); generalize dependent (exp x + / exp x); intros s H.
  field; split; lra.
Qed.
Lemma Rabs_law x : Rabs x = sign x * x.
Proof.
  destruct (Rtotal_order x 0) as [P|[P|P]].
  - rewrite sign_neg, Rabs_left by lra; ring.
  - subst; rewrite Rabs_R0; ring.
  - rewrite sign_pos, Rabs_pos_eq by lra; ring.
Qed.
Lemma sign_square x : x <> 0 -> sign x ^ 2 = 1.
Proof.
  intros H; destruct (Rtotal_order x 0) as [P|[P|P]]; [| contradiction |].
  - rewrite sign_neg by lra; ring.
  - rewrite sign_pos by lra; ring.
Qed.
Lemma sign_cube x : sign x ^ 3 = sign x.
Proof.
  destruct (Rtotal_order x 0) as [P|[P|P]].
  - rewrite sign_neg by lra; ring.
  - rewrite P, sign_zero; ring.
  - rewrite sign_pos by lra; ring.
Qed.

Ltac laws :=
  unfold sec, csc, sech, csch, coth, Rpower in *;
  rewrite ?tan_law, ?cot_law, ?sinh_law, ?cosh_law, ?tanh_law, ?Rabs_law in *.

Ltac derive :=
  lazymatch goal with
  | |- is_derive (fun _ : R => ?c) _ _ => apply d_const
  | |- is_derive (fun t : R => t) _ _ => apply d_id
  | |- is_derive (fun t : R => @?f t + @?g t) _ _ => eapply (d_plus f g); derive
  | |- is_derive (fun t : R => @?f t - @?g t) _ _ => eapply (d_minus f g); derive
  | |- is_derive (fun t : R => - @?f t) _ _ => eapply (d_opp f); derive
  | |- is_derive (fun t : R => @?f t * @?g t) _ _ => eapply (d_mult f g); derive
  | |- is_derive (fun t : R => @?f t / @?g t) _ _ => eapply (d_div f g); [derive | derive |]
  | |- is_derive (fun t : R => / @?f t) _ _ => eapply (d_inv f); [derive |]
  | |- is_derive (fun t : R => @?f t ^ ?n) _ _ => eapply (d_pow f); derive
  | |- is_derive (fun t : R => exp (@?f t)) _ _ => eapply (d_exp f); derive
  | |- is_derive (fun t : R => ln (@?f t)) _ _ => eapply (d_ln f); [derive |]
  | |- is_derive (fun t : R => sin (@?f t)) _ _ => eapply (d_sin f); derive
  | |- is_derive (fun t : R => cos (@?f t)) _ _ => eapply (d_cos f); derive
  | |- is_derive (fun t : R => tan (@?f t)) _ _ => eapply (d_tan f); [derive |]
  | |- is_derive (fun t : R => sqrt (@?f t)) _ _ => eapply (d_sqrt f); [derive |]
  | |- is_derive (fun t : R => root ?n (@?f t)) _ _ => eapply (d_root n f); [derive | lia |]
  | |- is_derive (fun t : R => atan (@?f t)) _ _ => eapply (d_atan f); derive
  | |- is_derive (fun t : R => asin (@?f t)) _ _ => eapply (d_asin f); [derive | |]
  | |- is_derive (fun t : R => acos (@?f t)) _ _ => eapply (d_acos f); [derive | |]
  | |- is_derive (fun t : R => sinh (@?f t)) _ _ => eapply (d_sinh f); derive
  | |- is_derive (fun t : R => cosh (@?f t)) _ _ => eapply (d_cosh f); derive
  | |- is_derive (fun t : R => tanh (@?f t)) _ _ => eapply (d_tanh f); derive
  | |- is_derive (fun t : R => arcsinh (@?f t)) _ _ => eapply (d_arcsinh f); derive
  | |- is_derive (fun t : R => atanh (@?f t)) _ _ => eapply (d_atanh f); [derive | |]
  | |- is_derive (fun t : R => Rabs (@?f t)) _ _ => eapply (d_Rabs f); [derive |]
  | |- is_derive (fun t : R => sign (@?f t)) _ _ => eapply (d_sign f); [derive |]
  | |- is_derive (fun t : R => Rpower (@?f t) (@?g t)) _ _ =>
      eapply (d_Rpower f g); [derive | derive |]
  | |- is_derive (fun t : R => cot (@?f t)) _ _ => unfold cot; derive
  | |- is_derive (fun t : R => sec (@?f t)) _ _ => unfold sec; derive
  | |- is_derive (fun t : R => csc (@?f t)) _ _ => unfold csc; derive
  | |- is_derive (fun t : R => coth (@?f t)) _ _ => unfold coth; derive
  | |- is_derive (fun t : R => sech (@?f t)) _ _ => unfold sech; derive
  | |- is_derive (fun t : R => csch (@?f t)) _ _ => unfold csch; derive
  | |- is_derive (fun t : R => acosh (@?f t)) _ _ => eapply (d_acosh f); [derive |]
  end.

(* Facts that follow from the premises, side by side with them. *)

Lemma factor_l a b : a * b <> 0 -> a <> 0.
Proof. intros H E; apply H; rewrite E; ring. Qed.
Lemma factor_r a b : a * b <> 0 -> b <> 0.
Proof. intros H E; apply H; rewrite E; ring. Qed.
Lemma base_nonzero a n : a ^ S n <> 0 -> a <> 0.
Proof. intros H E; apply H; rewrite E; apply pow_i; lia. Qed.
Lemma inverse_nonzero a : / a <> 0 -> a <> 0.
Proof. intros H E; apply H; rewrite E; apply Rinv_0. Qed.
Lemma sqrt_positive a : sqrt a <> 0 -> 0 < a.
Proof.
  intros H; destruct (Rle_or_lt a 0) as [L|L]; [| exact L]; contradict H; now apply sqrt_neg_0.
Qed.
Lemma root_nonzero_base n a : root n a <> 0 -> a <> 0.
Proof. intros H E; apply H; rewrite E; apply root_zero. Qed.
Lemma positive_inverse a : 0 < / a -> 0 < a.
Proof. intros H; rewrite <- (Rinv_inv a); now apply Rinv_0_lt_compat. Qed.

Ltac known P := match goal with H : P |- _ => idtac end.
Ltac add P proof := tryif known P then fail else assert P by proof.

(* What a product, a power, a root that is not 0 says of its parts. *)
Ltac saturate :=
  repeat match goal with
  | H : ?a > ?b |- _ => apply Rgt_lt in H
  | H : ?a >= ?b |- _ => apply Rge_le in H
  | H : _ /\ _ |- _ => destruct H
  | H : ?a * ?b <> 0 |- _ => add (a <> 0) ltac:(exact (factor_l a b H))
  | H : ?a * ?b <> 0 |- _ => add (b <> 0) ltac:(exact (factor_r a b H))
  | H : ?a ^ ?n <> 0 |- _ => add (a <> 0) ltac:(exact (base_nonzero a (pred n) H))
  | H : / ?a <> 0 |- _ => add (a <> 0) ltac:(exact (inverse_nonzero a H))
  | H : sqrt ?a <> 0 |- _ => add (0 < a) ltac:(exact (sqrt_positive a H))
  | H : root ?n ?a <> 0 |- _ => add (a <> 0) ltac:(exact (root_nonzero_base n a H))
  | H : 0 < / ?a |- _ => add (0 < a) ltac:(exact (positive_inverse a H))
  | H : 0 < ?a |- _ => add (a <> 0) ltac:(apply Rgt_not_eq; exact H)
  end.

Lemma top_nonzero e p q : e <> 0 -> e = p / q -> p <> 0.
Proof. intros H E Z; apply H; rewrite E, Z; unfold Rdiv; ring. Qed.

Lemma even_power x n : Nat.even n = true -> 0 <= x ^ n.
Proof.
  intros E; apply Nat.even_spec in E; destruct E as [m E]; subst.
  rewrite pow_mult; apply pow_le, pow2_ge_0.
Qed.

(* Positivity by structure. *)
Ltac positive :=
  lazymatch goal with
  | |- 0 < _ * _ => apply Rmult_lt_0_compat; positive
  | |- 0 < / _ => apply Rinv_0_lt_compat; positive
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat; positive
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < cosh _ => apply cosh_pos
  | |- 0 < sqrt _ => apply sqrt_lt_R0; positive
  | |- 0 < root _ _ => apply root_lt; positive
  | |- 0 < PI => exact PI_RGT_0
  | |- 0 < _ ^ _ => apply pow_lt; positive
  | |- 0 < _ => solve [assumption | lra | sum]
  | |- 0 <= _ * _ => first [assumption | lra | apply Rmult_le_pos; positive]
  | |- 0 <= / _ => left; positive
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 <= Rabs _ => apply Rabs_pos
  | |- 0 <= _ ^ _ => first [apply even_power; reflexivity | apply pow_le; positive]
  | |- 0 <= exp _ => left; apply exp_pos
  | |- 0 <= _ + _ =>
      first [assumption | lra | apply Rplus_le_le_0_compat; positive | left; positive]
  | |- 0 <= _ => solve [assumption | lra | left; positive]
  end
with sum :=
  first [ apply Rplus_lt_0_compat; positive
        | apply Rplus_lt_le_0_compat; positive
        | apply Rplus_le_lt_0_compat; positive ].

(* The conditions that [field] and [derive] leave. *)
Ltac same_nonzero :=
  match goal with
  | H : ?a <> 0 |- ?b <> 0 =>
      let Z := fresh in intro Z; apply H; first [lra | transitivity b; [ring | exact Z] | transitivity (- b); [ring | lra]]
  end.
Ltac nonzero :=
  lazymatch goal with
  | |- _ /\ _ => split; nonzero
  | |- ?a <> 0 =>
      first [ assumption
            | lra
            | lazymatch goal with
              | |- _ * _ <> 0 => apply Rmult_integral_contrapositive; split; nonzero
              | |- _ ^ _ <> 0 => apply pow_nonzero; nonzero
              | |- / _ <> 0 => apply Rinv_neq_0_compat; nonzero
              end
            | same_nonzero
            | apply Rgt_not_eq; positive ]
  | |- True => exact I
  end.
Ltac side := cbv beta; first [assumption | lra | nonzero | positive].
Ltac hard := first [side | nra].

(* Whole powers of what is derived have their exponents as numbers of two kinds. *)
Ltac tidy :=
  cbv beta; rewrite ?INR_IZR_INZ; cbn [Z.of_nat Pos.of_succ_nat Pos.succ Init.Nat.pred].

(* Sums of angles and of exponents. *)
Ltac angles :=
  rewrite ?sin_plus, ?cos_plus, ?sin_neg, ?cos_neg, ?sin_0, ?cos_0; ring.
Ltac exponents :=
  rewrite ?exp_plus, ?exp_Ropp, ?exp_0; field; repeat split; apply Rgt_not_eq, exp_pos.
Lemma sin_square x : sin x ^ 2 = 1 - cos x ^ 2.
Proof. pose proof (sin2_cos2 x) as H; unfold Rsqr in H; lra. Qed.

(* What [side] leaves, by an equation with a premise that [equal] proves. *)
Ltac sides equal :=
  repeat split;
  match goal with
  | H : ?a <> 0 |- ?b <> 0 =>
      let Z := fresh in
      intro Z; apply H; first
        [ transitivity b; [equal () | exact Z]
        | transitivity (- b); [equal () | rewrite Z; ring]
        | transitivity (b * b); [equal () | rewrite Z; ring] ]
  | _ => side
  end.

(* From the value at one point and the sign of the derivative: to its right, and to its left. *)

Lemma mean_value f df a b : a <= b -> (forall t, a <= t <= b -> is_derive f t (df t)) ->
  exists c, a <= c <= b /\ f b - f a = df c * (b - a).
Proof.
  intros H D; destruct (MVT_gen f a b df) as [c [C E]].
  - rewrite Rmin_left, Rmax_right by lra; intros t T; apply D; lra.
  - rewrite Rmin_left, Rmax_right by lra; intros t T.
    apply derivable_continuous_pt; exists (df t); apply is_derive_Reals, D; lra.
  - rewrite Rmin_left, Rmax_right in C by lra; exists c; split; assumption.
Qed.
Lemma from_left_ge f df c x : c <= x -> (forall t, c <= t <= x -> is_derive f t (df t)) ->
  (forall t, c <= t <= x -> 0 <= df t) -> 0 <= f c -> 0 <= f x.
Proof. intros H D S B; destruct (mean_value f df c x H D) as [t [T E]]; specialize (S t T); nra. Qed.
Lemma from_left_le f df c x : c <= x -> (forall t, c <= t <= x -> is_derive f t (df t)) ->
  (forall t, c <= t <= x -> df t <= 0) -> f c <= 0 -> f x <= 0.
Proof. intros H D S B; destruct (mean_value f df c x H D) as [t [T E]]; specialize (S t T); nra. Qed.
Lemma from_right_ge f df c x : x <= c -> (forall t, x <= t <= c -> is_derive f t (df t)) ->
  (forall t, x <= t <= c -> df t <= 0) -> 0 <= f c -> 0 <= f x.
Proof. intros H D S B; destruct (mean_value f df x c H D) as [t [T E]]; specialize (S t T); nra. Qed.
Lemma from_right_le f df c x : x <= c -> (forall t, x <= t <= c -> is_derive f t (df t)) ->
  (forall t, x <= t <= c -> 0 <= df t) -> f c <= 0 -> f x <= 0.
Proof. intros H D S B; destruct (mean_value f df x c H D) as [t [T E]]; specialize (S t T); nra. Qed.

Lemma pi_between : 3 < PI <= 4.
Proof. pose proof PI2_3_2; pose proof PI_4; lra. Qed.

(* What is known of the values of functions that stand in the goal. *)
Ltac facts :=
  repeat match goal with
  | |- context [PI] => add (3 < PI <= 4) ltac:(exact pi_between)
  | |- context [sin ?u] => add (-1 <= sin u <= 1) ltac:(apply SIN_bound)
  | |- context [cos ?u] => add (-1 <= cos u <= 1) ltac:(apply COS_bound)
  | |- context [sin ?u] => add (sin u ^ 2 + cos u ^ 2 = 1)
      ltac:(let E := fresh in pose proof (sin_square u) as E; lra)
  | |- context [Rabs ?u] => add (0 <= Rabs u) ltac:(apply Rabs_pos)
  | |- context [exp ?u] => add (0 < exp u) ltac:(apply exp_pos)
  | |- context [cosh ?u] => add (0 < cosh u) ltac:(apply cosh_pos)
  | |- context [sqrt ?u] => add (0 <= sqrt u) ltac:(apply sqrt_pos)
  | |- context [cos ?u] => add (0 <= cos u) ltac:(apply cos_ge_0; lra)
  | |- context [sin ?u] => add (0 <= sin u) ltac:(apply sin_ge_0; lra)
  end.
Lemma tanh_0 : tanh 0 = 0.
Proof. unfold tanh; rewrite sinh_0; unfold Rdiv; ring. Qed.
Ltac equals := first [ring | field; side | field_simplify; lra].
Ltac worth f u y c law :=
  replace (f u) with c by (replace u with y by equals; symmetry; apply law).
Ltac base_value :=
  cbv beta; rewrite ?ln_exp; rewrite ?exp_ln by side;
  repeat match goal with
  | |- context [exp ?u] => worth exp u 0 1 exp_0
  | |- context [ln ?u] => worth ln u 1 0 ln_1
  | |- context [sin ?u] => worth sin u 0 0 sin_0
  | |- context [cos ?u] => worth cos u 0 1 cos_0
  | |- context [tan ?u] => worth tan u 0 0 tan_0
  | |- context [atan ?u] => worth atan u 0 0 atan_0
  | |- context [asin ?u] => worth asin u 0 0 asin_0
  | |- context [acos ?u] => worth acos u 1 0 acos_1
  | |- context [sinh ?u] => worth sinh u 0 0 sinh_0
  | |- context [cosh ?u] => worth cosh u 0 1 cosh_0
  | |- context [tanh ?u] => worth tanh u 0 0 tanh_0
  | |- context [sqrt ?u] => worth sqrt u 1 1 sqrt_1
  | |- context [sqrt ?u] => worth sqrt u 0 0 sqrt_0
  end;
  repeat match goal with
  | |- context [ln ?u] =>
      match goal with |- context [ln ?v] =>
        tryif constr_eq u v then fail else replace (ln u) with (ln v) by (f_equal; equals)
      end
  end;
  first [lra | right; equals | left; positive | facts; nra | interval].
Ltac slope := first [ring | field; side | laws; field; side].
Ltac absolute := unfold Rabs in *; repeat match goal with
  | |- context [Rcase_abs ?u] => destruct (Rcase_abs u)
  | H : context [Rcase_abs ?u] |- _ => destruct (Rcase_abs u)
  end.

Ltac positive_root := first [positive | hard].
Ltac logs :=
  repeat first [rewrite ln_mult by positive | rewrite ln_Rinv by positive]; ring.
Ltac trigonometric := repeat match goal with
  | |- context [sin ?u ^ 2] => rewrite (sin_square u)
  end.

(* Relations of numbers. *)
Lemma above x y : 0 < y - x -> x < y.
Proof. lra. Qed.
Lemma not_below x y : 0 <= y - x -> x <= y.
Proof. lra. Qed.
Ltac numeric :=
  first
    [ lra
    | interval with (i_prec 90)
    | lazymatch goal with
      | |- _ <> 0 =>
          first [apply Rgt_not_eq; interval with (i_prec 90) | apply Rlt_not_eq; interval with (i_prec 90)]
      | |- _ <> _ => apply Rminus_not_eq; numeric
      | |- _ < _ => apply above; interval with (i_prec 90)
      | |- _ > _ => apply above; interval with (i_prec 90)
      | |- _ <= _ => apply not_below; interval with (i_prec 90)
      | |- _ = _ => first [field; lra | base_value]
      end ].

(* One-to-one functions, for equations of which both sides are put into one. *)

Section Injective.
Variable f : R -> R.
Hypothesis increasing : forall x y, x < y -> f x < f y.
Lemma injective x y : f x = f y -> x = y.
Proof.
  intros E; destruct (Rtotal_order x y) as [L|[L|L]]; [| exact L |];
  apply increasing in L; lra.
Qed.
End Injective.
Lemma sinh_injective x y : sinh x = sinh y -> x = y.
Proof. apply injective; exact sinh_lt. Qed.
Lemma arcsinh_injective x y : arcsinh x = arcsinh y -> x = y.
Proof. apply injective; exact arcsinh_lt. Qed.
Lemma atan_injective x y : atan x = atan y -> x = y.
Proof. apply injective; exact atan_increasing. Qed.
Lemma tanh_injective x y : tanh x = tanh y -> x = y.
Proof.
  apply injective; clear x y; intros x y L; rewrite !tanh_law.
  pose proof (exp_pos x); pose proof (exp_increasing x y L).
  apply Rminus_gt_0_lt.
  replace (_ - _) with (2 * (exp y ^ 2 - exp x ^ 2) / ((exp x ^ 2 + 1) * (exp y ^ 2 + 1))).
  - apply Rdiv_lt_0_compat; [nra | apply Rmult_lt_0_compat; nra].
  - field; repeat split; nra.
Qed.
Lemma ln_injective x y : ln x = ln y -> 0 < x -> 0 < y -> x = y.
Proof. intros; now apply ln_inv. Qed.
Lemma sqrt_injective x y : sqrt x = sqrt y -> 0 <= x -> 0 <= y -> x = y.
Proof. intros; now apply sqrt_inj. Qed.
Lemma square_injective x y : x ^ 2 = y ^ 2 -> 0 <= x -> 0 <= y -> x = y.
Proof. intros E P Q; nra. Qed.

(* The premises of a lemma, or of a theorem that is applied, from those at hand. *)
Ltac give :=
  cbv beta;
  first [ assumption | reflexivity | lra | nonzero | positive | apply Rgt_lt; positive | nra ].
