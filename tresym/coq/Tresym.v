(* The language of statements over Coq's real numbers, and what their proofs use of them.

   Coq's functions are total: 1/0, sqrt (-1) and ln 0 have values of which nothing is known. A
   statement therefore has what makes its parts defined among its premises. *)

Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Open Scope R_scope.

(* Functions of the language that Coq's library does not have. *)

(* The nth root; of a negative number that of its absolute value with its sign. *)
Definition root (n : nat) (x : R) : R := sign x * Rpower (Rabs x) (/ INR n).
(* The cotangent. *)
Definition cot (x : R) : R := cos x / sin x.
(* The secant. *)
Definition sec (x : R) : R := / cos x.
(* The cosecant. *)
Definition csc (x : R) : R := / sin x.
(* The hyperbolic cotangent. *)
Definition coth (x : R) : R := cosh x / sinh x.
(* The hyperbolic secant. *)
Definition sech (x : R) : R := / cosh x.
(* The hyperbolic cosecant. *)
Definition csch (x : R) : R := / sinh x.
(* The inverse hyperbolic cosine. *)
Definition acosh (x : R) : R := ln (x + sqrt (x ^ 2 - 1)).
(* The inverse hyperbolic tangent. *)
Definition atanh (x : R) : R := ln ((1 + x) / (1 - x)) / 2.
(* The angle of the point (x, y), above -PI and at most PI. *)
Definition atan2 (y x : R) : R :=
  if Req_EM_T y 0 then if Rlt_dec x 0 then PI else 0 else 2 * atan (y / (sqrt (x ^ 2 + y ^ 2) + x)).
(* x is the only zero of f between low and high. *)
Definition is_root (f : R -> R) (low high x : R) : Prop :=
  (low < x < high /\ f x = 0) /\ forall y, low < y < high -> f y = 0 -> y = x.

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

Lemma root_unique_le n x y : (n <> 0)%nat -> 0 <= y -> y ^ n = x -> root n x = y.
Proof.
  intros N [H|H] E; [now apply root_unique |]; subst; rewrite pow_i by lia; apply root_zero.
Qed.
Lemma some_root n x : (n <> 0)%nat -> 0 <= x -> exists y, 0 <= y /\ x = y ^ n.
Proof. intros N H; exists (root n x); split; [now apply root_le | now rewrite root_pow]. Qed.
Lemma some_root_lt n x : (n <> 0)%nat -> 0 < x -> exists y, 0 < y /\ x = y ^ n.
Proof. intros N H; exists (root n x); split; [now apply root_lt | rewrite root_pow; lra || trivial]. Qed.

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

Lemma even_above x n : Nat.even n = true -> x <> 0 -> 0 < x ^ n.
Proof.
  intros E H; destruct (even_power x n E) as [P|P]; [exact P |].
  now elim (pow_nonzero x n H).
Qed.

(* Positivity by structure. *)
Ltac positive :=
  first [assumption | lazymatch goal with
  | |- _ > 0 => apply Rlt_gt; positive
  | |- 0 < _ * _ => first [apply Rmult_lt_0_compat; positive | lra]
  | |- 0 < / _ => apply Rinv_0_lt_compat; positive
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat; positive
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < cosh _ => apply cosh_pos
  | |- 0 < sqrt _ => apply sqrt_lt_R0; positive
  | |- 0 < root _ _ => apply root_lt; positive
  | |- 0 < PI => exact PI_RGT_0
  | |- 0 < _ ^ _ =>
      first [apply even_above; [reflexivity | assumption] | apply pow_lt; positive]
  | |- 0 < _ => solve [lra | sum]
  | |- 0 <= _ * _ => first [lra | apply Rmult_le_pos; positive]
  | |- 0 <= / _ => left; positive
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 <= Rabs _ => apply Rabs_pos
  | |- 0 <= _ ^ _ => first [apply even_power; reflexivity | apply pow_le; positive]
  | |- 0 <= exp _ => left; apply exp_pos
  | |- 0 <= _ + _ =>
      first [lra | apply Rplus_le_le_0_compat; positive | left; positive]
  | |- 0 <= _ => solve [lra | left; positive]
  end ]
with sum :=
  first [ apply Rplus_lt_0_compat; positive
        | apply Rplus_lt_le_0_compat; positive
        | apply Rplus_le_lt_0_compat; positive ].

(* A sum of products of powers of what is known not to be negative. *)
Ltac cone :=
  first
    [ assumption
    | lazymatch goal with
      | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; cone
      | |- 0 <= _ * _ => apply Rmult_le_pos; cone
      | |- 0 <= _ ^ _ => apply pow_le; cone
      end
    | lra ].

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
            | apply Rgt_not_eq, Rlt_gt; positive ]
  | |- True => exact I
  end.
Ltac side := cbv beta; first [assumption | lra | nonzero | positive].

(* Whole powers of what is derived have their exponents as numbers of two kinds. *)
Ltac tidy :=
  cbv beta; rewrite ?INR_IZR_INZ; cbn [Z.of_nat Pos.of_succ_nat Pos.succ Init.Nat.pred].

(* Sums of angles and of exponents. *)
Ltac angles :=
  repeat first [rewrite sin_plus | rewrite cos_plus];
  rewrite ?sin_neg, ?cos_neg, ?sin_PI2, ?cos_PI2, ?sin_0, ?cos_0; ring.
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

(* A variable as a sine or a cosine. *)
Lemma some_asin x : -1 <= x -> x <= 1 -> exists t, - (PI / 2) <= t <= PI / 2 /\ x = sin t.
Proof. intros A B; exists (asin x); split; [apply asin_bound | now rewrite sin_asin]. Qed.
Lemma some_asin_above x : 0 <= x -> x <= 1 -> exists t, 0 <= t <= PI / 2 /\ x = sin t.
Proof.
  intros A B; exists (asin x); split; [| rewrite sin_asin; lra]; pose proof (asin_bound x).
  split; [| lra]; destruct (Rle_or_lt 0 (asin x)) as [H'|H']; [exact H' |].
  assert (S : sin (asin x) < 0) by (apply sin_lt_0_var; pose proof PI_RGT_0; lra).
  rewrite sin_asin in S; lra.
Qed.
Lemma some_acos x : -1 <= x -> x <= 1 -> exists t, 0 <= t <= PI /\ x = cos t.
Proof. intros A B; exists (acos x); split; [apply acos_bound | now rewrite cos_acos]. Qed.
Lemma some_acos_above x : 0 <= x -> x <= 1 -> exists t, 0 <= t <= PI / 2 /\ x = cos t.
Proof.
  intros A B; exists (acos x); split; [| rewrite cos_acos; lra]; pose proof (acos_bound x).
  split; [lra |]; destruct (Rle_or_lt (acos x) (PI / 2)) as [H'|H']; [exact H' |].
  assert (S : cos (acos x) < 0) by (apply cos_lt_0; pose proof PI_RGT_0; lra).
  rewrite cos_acos in S; lra.
Qed.

(* From the value at one point and the sign of the derivative: to its right, and to its left. *)

Lemma mean_value (f df : R -> R) a b : a <= b -> (forall t, a <= t <= b -> is_derive f t (df t)) ->
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

(* The same without equality: from a sign at the point itself, or from that of the derivative. *)
Lemma mean_value_inside (f df : R -> R) a b : a < b ->
  (forall t, a <= t <= b -> is_derive f t (df t)) ->
  exists c, a < c < b /\ f b - f a = df c * (b - a).
Proof.
  intros H D; destruct (MVT_cor2 f df a b H) as [c [E C]].
  - intros t T; apply is_derive_Reals, D, T.
  - exists c; split; assumption.
Qed.
Lemma from_left_gt f df c x : c < x -> (forall t, c <= t <= x -> is_derive f t (df t)) ->
  (forall t, c < t <= x -> 0 < df t) -> 0 <= f c -> 0 < f x.
Proof.
  intros H D S B; destruct (mean_value_inside f df c x H D) as [t [T E]].
  specialize (S t ltac:(lra)); nra.
Qed.
Lemma from_right_gt f df c x : x < c -> (forall t, x <= t <= c -> is_derive f t (df t)) ->
  (forall t, x <= t < c -> df t < 0) -> 0 <= f c -> 0 < f x.
Proof.
  intros H D S B; destruct (mean_value_inside f df x c H D) as [t [T E]].
  specialize (S t ltac:(lra)); nra.
Qed.
Lemma from_right_lt f df c x : x < c -> (forall t, x <= t <= c -> is_derive f t (df t)) ->
  (forall t, x <= t < c -> 0 < df t) -> f c <= 0 -> f x < 0.
Proof.
  intros H D S B; destruct (mean_value_inside f df x c H D) as [t [T E]].
  specialize (S t ltac:(lra)); nra.
Qed.
Lemma from_left_start_gt f df c x : c <= x -> (forall t, c <= t <= x -> is_derive f t (df t)) ->
  (forall t, c <= t <= x -> 0 <= df t) -> 0 < f c -> 0 < f x.
Proof. intros H D S B; destruct (mean_value f df c x H D) as [t [T E]]; specialize (S t T); nra. Qed.
Lemma from_right_start_gt f df c x : x <= c -> (forall t, x <= t <= c -> is_derive f t (df t)) ->
  (forall t, x <= t <= c -> df t <= 0) -> 0 < f c -> 0 < f x.
Proof. intros H D S B; destruct (mean_value f df x c H D) as [t [T E]]; specialize (S t T); nra. Qed.
Lemma from_right_start_lt f df c x : x <= c -> (forall t, x <= t <= c -> is_derive f t (df t)) ->
  (forall t, x <= t <= c -> 0 <= df t) -> f c < 0 -> f x < 0.
Proof. intros H D S B; destruct (mean_value f df x c H D) as [t [T E]]; specialize (S t T); nra. Qed.

Lemma pi_between : 3 < PI <= 4.
Proof. pose proof PI2_3_2; pose proof PI_4; lra. Qed.

Lemma cosh_above x : 1 <= cosh x.
Proof.
  pose proof (cosh_sinh x); pose proof (cosh_pos x); pose proof (Rle_0_sqr (sinh x)).
  unfold Rsqr in *; nra.
Qed.
Lemma ln_below x : 0 < x -> ln x <= x - 1.
Proof. intros X; pose proof (exp_ineq1_le (ln x)) as E; rewrite exp_ln in E by exact X; lra. Qed.
Lemma ln_nonnegative x : 1 <= x -> 0 <= ln x.
Proof. intros X; pose proof (ln_below (/ x) ltac:(apply Rinv_0_lt_compat; lra)) as E.
  rewrite ln_Rinv in E by lra; assert (/ x <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  lra.
Qed.

(* What is known of the values of functions that stand in the goal. *)
Lemma asin_positive u : 0 < u -> u <= 1 -> 0 < asin u.
Proof.
  intros P Q; destruct (Rlt_or_le 0 (asin u)) as [H|H]; [exact H |].
  pose proof (sin_asin u) as S; pose proof (asin_bound u); pose proof PI_RGT_0.
  assert (0 <= sin (- asin u)) by (apply sin_ge_0; lra); rewrite sin_neg, S in * by lra; lra.
Qed.
Ltac facts :=
  repeat match goal with
  | |- context [PI] => add (3 < PI <= 4) ltac:(exact pi_between)
  | |- context [sin ?u] => add (-1 <= sin u <= 1) ltac:(apply SIN_bound)
  | |- context [cos ?u] => add (-1 <= cos u <= 1) ltac:(apply COS_bound)
  | |- context [sin ?u] => add (sin u ^ 2 + cos u ^ 2 = 1)
      ltac:(let E := fresh in pose proof (sin_square u) as E; lra)
  | |- context [Rabs ?u] => add (0 <= Rabs u) ltac:(apply Rabs_pos)
  | |- context [exp ?u] => add (0 < exp u) ltac:(apply exp_pos)
  | |- context [exp ?u] => add (1 + u <= exp u) ltac:(apply exp_ineq1_le)
  | |- context [ln ?u] => add (ln u <= u - 1) ltac:(apply ln_below; solve [assumption | lra | positive])
  | |- context [ln ?u] => add (0 <= ln u) ltac:(apply ln_nonnegative; solve [assumption | lra | nra])
  | |- context [atan ?u] => add (- PI / 2 < atan u < PI / 2) ltac:(apply atan_bound)
  | |- context [asin ?u] => add (- PI / 2 <= asin u <= PI / 2) ltac:(apply asin_bound)
  | |- context [asin ?u] => add (0 < asin u) ltac:(apply asin_positive; solve [positive | lra])
  | |- context [acos ?u] => add (0 <= acos u <= PI) ltac:(apply acos_bound)
  | |- context [acos ?u] => add (0 < acos u < PI) ltac:(apply acos_bound_lt; lra)
  | |- context [cosh ?u] => add (1 <= cosh u) ltac:(apply cosh_above)
  | |- context [sqrt ?u] => add (0 <= sqrt u) ltac:(apply sqrt_pos)
  | |- context [sin (PI * ?u)] => add (0 <= sin (PI * u)) ltac:(apply sin_ge_0; nra)
  | |- context [cos ?u] => add (0 < cos u) ltac:(apply cos_gt_0; lra)
  | |- context [sin ?u] => add (0 < sin u) ltac:(apply sin_gt_0; lra)
  | |- context [cos ?u] => add (0 <= cos u) ltac:(apply cos_ge_0; lra)
  | |- context [sin ?u] => add (0 <= sin u) ltac:(apply sin_ge_0; lra)
  end.
Ltac hard := first [side | nra | facts; first [side | nra]].
Lemma tanh_0 : tanh 0 = 0.
Proof. unfold tanh; rewrite sinh_0; unfold Rdiv; ring. Qed.
Ltac equals := first [ring | field; side | field_simplify; lra].
Ltac worth f u y c law :=
  replace (f u) with c by (replace u with y by equals; symmetry; apply law).
Lemma cosh_beyond x : x <> 0 -> 1 < cosh x.
Proof.
  intros N; unfold cosh; assert (D : exp x <> exp (- x)) by (intros E; apply exp_inv in E; lra).
  assert (P : exp x * exp (- x) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  assert (S : 0 < (exp x - exp (- x)) * (exp x - exp (- x))) by (apply Rlt_0_sqr; lra).
  pose proof (exp_pos x); pose proof (exp_pos (- x)); nra.
Qed.

(* What functions are beside 0, without equality. *)
Ltac new_fact P proof :=
  lazymatch goal with H : P |- _ => fail | _ => assert P by proof end.
Ltac beside :=
  repeat match goal with
  | |- context [exp ?u] => new_fact (exp u < 1) ltac:(rewrite <- exp_0; apply exp_increasing; lra)
  | |- context [exp ?u] => new_fact (1 < exp u) ltac:(rewrite <- exp_0; apply exp_increasing; lra)
  | |- context [ln ?u] => new_fact (ln u < 0) ltac:(rewrite <- ln_1; apply ln_increasing; lra)
  | |- context [ln ?u] => new_fact (0 < ln u) ltac:(rewrite <- ln_1; apply ln_increasing; lra)
  | |- context [cosh ?u] => new_fact (1 < cosh u) ltac:(apply cosh_beyond; first [apply Rlt_not_eq; lra | apply Rgt_not_eq; lra])
  | |- context [sin ?u] => new_fact (sin u < u) ltac:(apply sin_lt_x; lra)
  end; first [lra | nra].

Ltac base_value :=
  cbv beta; repeat rewrite ln_Rinv by positive; rewrite ?ln_exp; rewrite ?exp_ln by side;
  repeat match goal with
  | |- context [exp ?u] => worth exp u 0 1 exp_0
  | |- context [ln ?u] => worth ln u 1 0 ln_1
  | |- context [sin ?u] => worth sin u 0 0 sin_0
  | |- context [cos ?u] => worth cos u 0 1 cos_0
  | |- context [sin ?u] => worth sin u (PI / 2) 1 sin_PI2
  | |- context [cos ?u] => worth cos u (PI / 2) 0 cos_PI2
  | |- context [sin ?u] => worth sin u PI 0 sin_PI
  | |- context [cos ?u] => worth cos u PI (-1) cos_PI
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
Ltac squared :=
  first [ assumption
        | lazymatch goal with
          | |- 0 <= _ * _ => apply Rmult_le_pos; squared
          | |- 0 <= _ ^ 2 => apply pow2_ge_0
          end
        | lra ].
Ltac slope_root :=
  match goal with |- context [sqrt ?u] =>
    let P := fresh in let E := fresh in let g := fresh in
    assert (P : 0 < sqrt u) by (apply sqrt_lt_R0; hard);
    assert (E : sqrt u ^ 2 = u) by (apply pow2_sqrt; hard);
    set (g := sqrt u) in *; clearbody g; field [E]; repeat split; first [side | nra]
  end.
Ltac slope := first [ring | field; side | laws; field; side | slope_root].
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

(* An inequality from one that implies it. *)
Lemma from_ln_le x y : 0 < x -> 0 < y -> ln x <= ln y -> x <= y.
Proof. intros X Y [H|H]; [left; now apply ln_lt_inv | right; now apply ln_inv]. Qed.
Lemma from_ln_lt x y : 0 < x -> 0 < y -> ln x < ln y -> x < y.
Proof. apply ln_lt_inv. Qed.
Lemma ln_rises x y : 0 < x -> x <= y -> ln x <= ln y.
Proof. intros X [H|H]; [left; now apply ln_increasing | subst; right; reflexivity]. Qed.
Lemma exp_rises x y : x <= y -> exp x <= exp y.
Proof. intros [H|H]; [left; now apply exp_increasing | subst; right; reflexivity]. Qed.
Lemma below_sqrt x y : x ^ 2 <= y -> x <= sqrt y.
Proof.
  intros H; destruct (Rle_or_lt x 0); [pose proof (sqrt_pos y); lra |].
  rewrite <- (sqrt_pow2 x) by lra; apply sqrt_le_1_alt, H.
Qed.
Lemma above_sqrt x y : 0 <= y -> x <= y ^ 2 -> sqrt x <= y.
Proof. intros Y H; rewrite <- (sqrt_pow2 y) by exact Y; apply sqrt_le_1_alt, H. Qed.
Lemma pow_below x n : 0 <= x -> x <= 1 -> x ^ n <= 1.
Proof. intros A B; rewrite <- (pow1 n); apply pow_incr; lra. Qed.
Lemma from_quotient p q : 0 <= p -> 0 < q -> 0 <= p / q.
Proof. intros; now apply Rdiv_le_0_compat. Qed.

(* Concave between two points at which it is not negative. *)
Lemma concave f df ddf a b x : a <= x <= b ->
  (forall t, a <= t <= b -> is_derive f t (df t)) ->
  (forall t, a <= t <= b -> is_derive df t (ddf t)) -> (forall t, a <= t <= b -> ddf t <= 0) ->
  0 <= f a -> 0 <= f b -> 0 <= f x.
Proof.
  intros X D E S A B; destruct (Rle_or_lt 0 (f x)) as [H|H]; [exact H | exfalso].
  destruct (mean_value f df a x) as [p [P U]]; [lra | intros; apply D; lra |].
  destruct (mean_value f df x b) as [q [Q V]]; [lra | intros; apply D; lra |].
  destruct (mean_value df ddf p q) as [r [R W]]; [lra | intros; apply E; lra |].
  assert (Z := S r ltac:(lra)).
  assert (a < x) by (destruct (Req_dec a x) as [<-|]; lra).
  assert (x < b) by (destruct (Req_dec x b) as [->|]; lra).
  assert (df p < 0) by (apply (Rmult_lt_reg_r (x - a)); lra).
  assert (0 < df q) by (apply (Rmult_lt_reg_r (b - x)); lra).
  assert (ddf r * (q - p) <= 0) by (apply Rmult_le_0_r; lra || trivial); lra.
Qed.

(* Logarithms of products, powers and exponentials, by positive factors. *)
Lemma ln_pow_ x n : 0 < x -> ln (x ^ n) = INR n * ln x.
Proof.
  intros X; induction n; [simpl; rewrite ln_1; ring |].
  rewrite S_INR; simpl; rewrite ln_mult, IHn; [ring | exact X | now apply pow_lt].
Qed.
Lemma ln_sqrt_ x : 0 < x -> ln (sqrt x) = / 2 * ln x.
Proof.
  intros X; assert (S := sqrt_lt_R0 x X).
  enough (ln x = 2 * ln (sqrt x)) by lra.
  rewrite <- (pow2_sqrt x) at 1 by lra; rewrite ln_pow_ by exact S; simpl; ring.
Qed.
Lemma ln_root_ n x : (n <> 0)%nat -> 0 < x -> ln (root n x) = / INR n * ln x.
Proof. intros N X; rewrite root_pos by exact X; unfold Rpower; apply ln_exp. Qed.
Ltac log_parts :=
  repeat first
    [ rewrite ln_mult by positive
    | rewrite ln_div by positive
    | rewrite ln_Rinv by positive
    | rewrite ln_pow_ by positive
    | rewrite ln_sqrt_ by positive
    | rewrite ln_root_ by (first [lia | positive])
    | rewrite ln_exp
    | rewrite ln_1 ];
  rewrite ?INR_IZR_INZ; cbn [Z.of_nat Pos.of_succ_nat Pos.succ].

(* Equations step by step: what is a function of what has a name gets a name, out of the way. *)
Definition same (x y : R) : Prop := x = y.
Definition both (P Q : Prop) : Prop := P /\ Q.
Lemma some_name (x : R) : exists y, x = y.
Proof. now exists x. Qed.

Lemma acosh_law x : acosh x = ln (x + sqrt (x ^ 2 + (-1))).
Proof. reflexivity. Qed.
Lemma arcsinh_law x : arcsinh x = ln (x + sqrt (x ^ 2 + 1)).
Proof. reflexivity. Qed.
Lemma atanh_law x : atanh x = ln ((1 + x) * / (1 + (-1) * x)) * (1 / 2).
Proof.
  unfold atanh, Rdiv; replace (1 + (-1) * x) with (1 - x) by ring; now rewrite Rmult_1_l.
Qed.
Ltac spell_plainly :=
  unfold sec, csc, sech, csch, coth, Rpower in *;
  rewrite ?tan_law, ?cot_law, ?sinh_law, ?cosh_law, ?tanh_law in *.
Ltac spell := spell_plainly; rewrite ?acosh_law, ?arcsinh_law, ?atanh_law in *.

Lemma root_unique_3 x y : y ^ 3 = x -> root 3 x = y.
Proof.
  intros E; assert (C := root_3_pow x); rewrite <- E in C at 2.
  set (r := root 3 x) in *; clearbody r; clear E.
  assert (F : (r - y) * (r ^ 2 + r * y + y ^ 2) = 0) by (replace ((r - y) * (r ^ 2 + r * y + y ^ 2)) with (r ^ 3 - y ^ 3) by ring; lra).
  apply Rmult_integral in F; destruct F as [F|F]; [lra |].
  pose proof (pow2_ge_0 (r + y / 2)); pose proof (pow2_ge_0 y).
  assert (Y : y = 0) by (apply Rsqr_0_uniq; unfold Rsqr; nra).
  rewrite Y in *; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.
Lemma exp_part q x v : (q <> 0)%nat -> 0 < x -> 0 < v -> v ^ q = x -> exp (/ INR q * ln x) = v.
Proof.
  intros N X V E; change (Rpower x (/ INR q) = v); rewrite <- root_pos by exact X.
  now apply root_unique.
Qed.
Lemma ln_of_root q v x y : (q <> 0)%nat -> 0 < v -> v ^ q = x -> ln x = INR q * y -> ln v = y.
Proof.
  intros N V E L; rewrite <- E, ln_pow_ in L by exact V.
  apply (Rmult_eq_reg_l (INR q)); [exact L | now apply not_0_INR].
Qed.
Lemma ln_like m n x y z : (m <> 0)%nat -> 0 < x -> 0 < y -> x ^ m = y ^ n ->
  INR m * z = INR n * ln y -> ln x = z.
Proof.
  intros M X Y E Z; apply (Rmult_eq_reg_l (INR m)); [| now apply not_0_INR].
  rewrite Z, <- !ln_pow_ by assumption; now rewrite E.
Qed.
Lemma ln_unlike m n x y z : (m <> 0)%nat -> 0 < x -> 0 < y -> x ^ m * y ^ n = 1 ->
  INR m * z = - (INR n * ln y) -> ln x = z.
Proof.
  intros M X Y E Z; apply (Rmult_eq_reg_l (INR m)); [| now apply not_0_INR].
  rewrite Z, <- !ln_pow_ by assumption.
  assert (P : ln (x ^ m * y ^ n) = 0) by (rewrite E; apply ln_1).
  rewrite ln_mult in P by now apply pow_lt.
  lra.
Qed.

Lemma turn_atan u w : 0 < w -> w ^ 2 = 1 + u ^ 2 -> sin (atan u) = u / w /\ cos (atan u) = 1 / w.
Proof.
  intros W E; rewrite sin_atan, cos_atan; replace (1 + u²) with (w ^ 2) by (unfold Rsqr; lra).
  rewrite sqrt_pow2 by lra; split; reflexivity.
Qed.
Lemma turn_asin u w : -1 <= u <= 1 -> 0 <= w -> w ^ 2 = 1 - u ^ 2 ->
  sin (asin u) = u /\ cos (asin u) = w.
Proof.
  intros U W E; rewrite sin_asin, cos_asin by exact U; replace (1 - u²) with (w ^ 2) by (unfold Rsqr; lra).
  rewrite sqrt_pow2 by lra; split; reflexivity.
Qed.
Lemma atan_unique w g : - PI / 2 < g < PI / 2 -> sin g = w * cos g -> atan w = g.
Proof.
  intros B E; assert (C : 0 < cos g) by (apply cos_gt_0; lra).
  rewrite <- (atan_tan g) by lra; f_equal; unfold tan; rewrite E; field; lra.
Qed.
Lemma atan_unique_le w g : - PI / 2 <= g <= PI / 2 -> 0 < cos g -> sin g = w * cos g -> atan w = g.
Proof.
  intros B C E; apply atan_unique; [| exact E].
  destruct B as [[A|A] [B|B]]; try lra; exfalso; revert C.
  - rewrite B, cos_PI2; lra.
  - rewrite <- A; replace (- PI / 2) with (- (PI / 2)) by field; rewrite cos_neg, cos_PI2; lra.
  - rewrite B, cos_PI2; lra.
Qed.
Lemma asin_unique w g : - PI / 2 <= g <= PI / 2 -> sin g = w -> asin w = g.
Proof. intros B E; rewrite <- E; apply asin_sin; lra. Qed.
Lemma half_angle w g : - PI < g < PI -> w * (1 + cos g) = sin g -> atan w = g / 2.
Proof.
  intros B E; apply atan_unique; [lra |].
  assert (C : 0 < cos (g / 2)) by (apply cos_gt_0; lra).
  replace g with (2 * (g / 2)) in E by field; rewrite sin_2a, cos_2a_cos in E.
  apply (Rmult_eq_reg_l (2 * cos (g / 2))); [lra | lra].
Qed.
Lemma turn_special s c p q g : sqrt p = sin g -> sqrt q = cos g -> 0 <= s -> 0 <= c ->
  s ^ 2 = p -> c ^ 2 = q -> both (sin g = s) (cos g = c).
Proof.
  intros P Q S C E F; rewrite <- P, <- Q, <- E, <- F, !sqrt_pow2 by assumption; split; reflexivity.
Qed.
Lemma turn_special_3 s c : 0 <= s -> 0 <= c -> s ^ 2 = 3 / 4 -> c ^ 2 = 1 / 4 ->
  both (sin (PI / 3) = s) (cos (PI / 3) = c).
Proof.
  apply turn_special; apply sqrt_unique; rewrite ?sin_PI3, ?cos_PI3; try lra;
  [pose proof (sqrt_pos 3); lra | pose proof (pow2_sqrt 3); lra].
Qed.
Lemma turn_special_6 s c : 0 <= s -> 0 <= c -> s ^ 2 = 1 / 4 -> c ^ 2 = 3 / 4 ->
  both (sin (PI / 6) = s) (cos (PI / 6) = c).
Proof.
  apply turn_special; apply sqrt_unique; rewrite ?sin_PI6, ?cos_PI6; try lra;
  [pose proof (sqrt_pos 3); lra | pose proof (pow2_sqrt 3); lra].
Qed.
Lemma turn_special_4 s c : 0 <= s -> 0 <= c -> s ^ 2 = 1 / 2 -> c ^ 2 = 1 / 2 ->
  both (sin (PI / 4) = s) (cos (PI / 4) = c).
Proof.
  assert (S : 0 < sin (PI / 4)) by (apply sin_gt_0; pose proof PI_RGT_0; lra).
  assert (E : sin (PI / 4) = cos (PI / 4)) by (now rewrite sin_PI4, cos_PI4).
  pose proof (sin_square (PI / 4)).
  apply turn_special; apply sqrt_unique; try lra; nra.
Qed.
Lemma exp_below x : (1 - x) * exp x <= 1.
Proof.
  pose proof (exp_ineq1_le (- x)) as E; rewrite exp_Ropp in E; pose proof (exp_pos x) as P.
  apply (Rmult_le_reg_r (/ exp x)); [now apply Rinv_0_lt_compat |].
  rewrite Rmult_assoc, Rinv_r by lra; lra.
Qed.
Lemma atan_above x : 0 < x -> 0 < atan x.
Proof. intros X; rewrite <- atan_0; now apply atan_increasing. Qed.
Lemma atan_below x : x < 0 -> atan x < 0.
Proof. intros X; rewrite <- atan_0; now apply atan_increasing. Qed.
Lemma asin_above x : 0 < x -> 0 < asin x.
Proof.
  intros X; destruct (Rlt_or_le 1 x) as [B|B].
  - unfold asin; destruct (Rle_dec x (-1)); [lra |]; destruct (Rle_dec 1 x); lra || apply PI2_RGT_0.
  - destruct (some_asin_above x) as [t [T E]]; [lra | exact B |]; rewrite E, asin_sin by lra.
    destruct (proj1 T) as [P|P]; [exact P |]; rewrite <- P, sin_0 in E; lra.
Qed.
Lemma asin_below x : x < 0 -> asin x < 0.
Proof.
  intros X; rewrite <- (Ropp_involutive x), asin_opp; pose proof (asin_above (- x)); lra.
Qed.
Ltac turns :=
  repeat first [rewrite sin_plus | rewrite cos_plus];
  rewrite ?sin_neg, ?cos_neg, ?sin_0, ?cos_0, ?sin_PI2, ?cos_PI2; ring.
Ltac signed := first [assumption | lra | side | nra | hard].
Ltac in_numbers := unfold same in *; subst; interval with (i_prec 60).
Ltac away equal := repeat split; first [side | sides equal | nra].
Ltac inverses_below :=
  repeat match goal with
  | H : context [/ ?b] |- _ => add (/ b < 0) ltac:(apply Rinv_lt_0_compat; lra)
  end.
(* What cannot be zero, since a product would not be. *)
Ltac vanish := match goal with H : 0 = ?u |- ?x = 0 =>
  let Z := fresh "Z" in destruct (Req_dec x 0) as [Z|Z]; [exact Z |];
  exfalso; assert (u <> 0) as Z' by side; apply Z'; symmetry; exact H end.
(* Absolute values without signs. *)
Lemma sign_abs u : sign u * Rabs u = u.
Proof.
  destruct (Rtotal_order u 0) as [P|[P|P]];
    [rewrite sign_neg, Rabs_left | subst; rewrite sign_zero | rewrite sign_pos, Rabs_pos_eq]; lra.
Qed.
Lemma sign_sqrt u v : u ^ 2 = v -> sign u * sqrt v = u.
Proof. intros <-; rewrite <- Rsqr_pow2, sqrt_Rsqr_abs; apply sign_abs. Qed.
Lemma sign_root n u : sign u * root n (Rabs u) = root n u.
Proof.
  destruct (Req_dec u 0) as [->|N]; [rewrite sign_zero, root_zero; ring |].
  unfold root; rewrite (sign_pos (Rabs u)), Rabs_Rabsolu by now apply Rabs_pos_lt.
  ring.
Qed.
Lemma sin_over_cos u : sin (atan u) * / cos (atan u) = u.
Proof. exact (tan_atan u). Qed.
(* Two factors that make one by a law. *)
Ltac factors law a b :=
  generalize law; generalize a b; let L := fresh in intros ? ? L; rewrite <- L; ring.
Lemma sqrt_square u v w : 0 <= w -> v ^ 2 * w ^ 2 = u -> sqrt u = Rabs v * w.
Proof.
  intros W E; apply sqrt_unique.
  - apply Rmult_le_pos; [apply Rabs_pos | exact W].
  - rewrite Rpow_mult_distr, pow2_abs; exact E.
Qed.
Lemma atanh_odd u v : u = - v -> -1 < v < 1 -> atanh u = - atanh v.
Proof.
  intros -> B; unfold atanh.
  replace ((1 + - v) / (1 - - v)) with (/ ((1 + v) / (1 - v))) by (field; lra).
  rewrite ln_Rinv by (apply Rdiv_lt_0_compat; lra); field.
Qed.
Lemma arcsinh_odd u v : u = - v -> arcsinh u = - arcsinh v.
Proof.
  intros ->; rewrite <- (sinh_arcsinh v) at 1; rewrite <- (arcsinh_sinh (- arcsinh v)).
  f_equal; unfold sinh; rewrite Ropp_involutive; field.
Qed.
Lemma arcsinh_atanh u v w : 0 < w -> w ^ 2 = 1 + u ^ 2 -> v * w = u -> arcsinh u = atanh v.
Proof.
  intros W E V; unfold arcsinh, atanh.
  assert (B : (1 - v) * (1 + v) * w ^ 2 = 1) by (rewrite <- V in E; nra).
  assert (L : - w < u < w) by (split; nra).
  assert (-1 < v < 1) by (rewrite <- V in L; split; nra).
  replace (sqrt (u ^ 2 + 1)) with w by (symmetry; apply sqrt_unique; lra).
  replace ((1 + v) / (1 - v)) with ((u + w) ^ 2).
  - rewrite ln_pow_ by lra; simpl; field.
  - apply (Rmult_eq_reg_r (1 - v)); [| lra]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra.
    apply (Rmult_eq_reg_r w); [| lra].
    replace ((u + w) ^ 2 * (1 - v) * w) with ((u + w) ^ 2 * (w - v * w)) by ring.
    replace ((1 + v) * 1 * w) with (w + v * w) by ring; rewrite V; nra.
Qed.
Ltac absurd_ := first [lra | nra | progress inverses_below; nra | match goal with H : ?a <> 0 |- _ => apply H; first [ring | field; side | nra] end].
Ltac split_logs :=
  repeat match goal with
  | |- context [ln (?a * ?b)] => rewrite (ln_mult a b) by first [assumption | positive]
  | |- context [ln (/ ?a)] => rewrite (ln_Rinv a) by first [assumption | positive]
  end.
Ltac apart H :=
  repeat first [rewrite ln_mult in H by first [assumption | positive | signed]].
Lemma factor_above x y : 0 < y -> 0 < x * y -> 0 < x.
Proof. intros Y P; apply (Rmult_lt_reg_r y); [exact Y | now rewrite Rmult_0_l]. Qed.
Ltac plainly := first [assumption | lra | positive].
(* An equation put into the goal and into the premises that are no equations. *)
Ltac put E :=
  try rewrite E;
  repeat match goal with
  | H : _ <> _ |- _ => rewrite E in H
  | H : _ < _ |- _ => rewrite E in H
  | H : _ <= _ |- _ => rewrite E in H
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

(* Integrals: each rule with the conditions under which it holds. *)

(* An equation of integrals is one of real numbers. *)
Ltac over_reals := match goal with |- @eq _ ?x ?y => change (@eq R x y) end.

Section Integrals.
Implicit Types (f g h dg F : R -> R) (a b c d u v x y : R).

Definition continuous_on (f : R -> R) (a b : R) : Prop :=
  forall x, Rmin a b <= x <= Rmax a b -> continuous f x.

Lemma on_interval (P : R -> Prop) a b : a <= b ->
  (forall x, a <= x <= b -> P x) -> forall x, Rmin a b <= x <= Rmax a b -> P x.
Proof. intros H D x; rewrite Rmin_left, Rmax_right by exact H; apply D. Qed.
Lemma continuous_derive (f : R -> R) (df x : R) : is_derive f x df -> continuous f x.
Proof. intros H; apply (ex_derive_continuous f); now exists df. Qed.
Lemma continuous_part f a b c d :
  Rmin a b <= Rmin c d -> Rmax c d <= Rmax a b -> continuous_on f a b -> continuous_on f c d.
Proof. intros L U C x X; apply C; lra. Qed.

Lemma integral_exists f a b : continuous_on f a b -> ex_RInt f a b.
Proof. intros C; apply (ex_RInt_continuous f); exact C. Qed.
Lemma integral_correct f a b : continuous_on f a b -> is_RInt f a b (RInt f a b).
Proof. intros C; now apply (RInt_correct f), integral_exists. Qed.
Lemma integral_value f a b v : is_RInt f a b v -> RInt f a b = v.
Proof. exact (is_RInt_unique f a b v). Qed.
Lemma integral_point f a : RInt f a a = 0.
Proof. exact (RInt_point a f). Qed.
Lemma integral_flip f a b : continuous_on f a b -> RInt f b a = - RInt f a b.
Proof.
  intros C; apply (is_RInt_unique f b a (- RInt f a b)), (is_RInt_swap f b a), integral_correct, C.
Qed.

(* Under a binder: the two integrands agree strictly inside. *)
Lemma integral_under f g a b :
  (forall x, Rmin a b < x < Rmax a b -> f x = g x) -> RInt f a b = RInt g a b.
Proof. exact (RInt_ext f g a b). Qed.

Lemma continuous_hull f a b c : continuous_on f a b -> continuous_on f b c -> continuous_on f a c.
Proof.
  intros L U x X; unfold Rmin, Rmax in X; destruct (Rle_dec a c).
  - destruct (Rle_or_lt x b).
    + apply L; unfold Rmin, Rmax; destruct (Rle_dec a b); lra.
    + apply U; unfold Rmin, Rmax; destruct (Rle_dec b c); lra.
  - destruct (Rle_or_lt x b).
    + apply U; unfold Rmin, Rmax; destruct (Rle_dec b c); lra.
    + apply L; unfold Rmin, Rmax; destruct (Rle_dec a b); lra.
Qed.
Lemma integral_cut f a b c : continuous_on f a b -> continuous_on f b c ->
  RInt f a c = RInt f a b + RInt f b c.
Proof. intros L U; symmetry; apply (RInt_Chasles f); now apply integral_exists. Qed.

Lemma integral_plus f g a b : continuous_on f a b -> continuous_on g a b ->
  RInt (fun x => f x + g x) a b = RInt f a b + RInt g a b.
Proof. intros F G; apply (RInt_plus f g); now apply integral_exists. Qed.
Lemma integral_minus f g a b : continuous_on f a b -> continuous_on g a b ->
  RInt (fun x => f x - g x) a b = RInt f a b - RInt g a b.
Proof. intros F G; apply (RInt_minus f g); now apply integral_exists. Qed.
Lemma integral_scale c f a b : continuous_on f a b ->
  RInt (fun x => c * f x) a b = c * RInt f a b.
Proof. intros F; apply (RInt_scal f a b c); now apply integral_exists. Qed.
Lemma integral_opp f a b : continuous_on f a b -> RInt (fun x => - f x) a b = - RInt f a b.
Proof. intros F; apply (RInt_opp f); now apply integral_exists. Qed.
Lemma integral_const c a b : RInt (fun _ => c) a b = (b - a) * c.
Proof. exact (RInt_const a b c). Qed.

(* A new variable x = g(u). *)
Lemma integral_new_variable f g dg a b :
  (forall u, Rmin a b <= u <= Rmax a b -> is_derive g u (dg u)) ->
  continuous_on dg a b -> (forall u, Rmin a b <= u <= Rmax a b -> continuous f (g u)) ->
  RInt f (g a) (g b) = RInt (fun u => f (g u) * dg u) a b.
Proof.
  intros D C F; rewrite <- (RInt_comp f g dg a b F).
  - apply RInt_ext; intros; unfold scal; simpl; unfold mult; simpl; ring.
  - intros u U; split; [now apply D | now apply C].
Qed.

(* The fundamental theorem: the antiderivative is continuous on the closed interval and has the
   integrand for its derivative strictly inside. *)
Lemma constant_inside h a b : a < b -> (forall x, a <= x <= b -> continuous h x) ->
  (forall x, a < x < b -> is_derive h x 0) -> h b = h a.
Proof.
  intros H C D; destruct (MVT_gen h a b (fun _ => 0)) as [c [_ E]].
  - rewrite Rmin_left, Rmax_right by lra; exact D.
  - rewrite Rmin_left, Rmax_right by lra; intros x X.
    now apply continuity_pt_filterlim, C.
  - lra.
Qed.

(* f on [a, b], and its values at the ends beyond them. *)
Definition beyond (f : R -> R) (a b : R) : R -> R := extension_C0 f a b.
Lemma beyond_inside f a b x : a <= x <= b -> beyond f a b x = f x.
Proof. intros X; apply (extension_C0_ext f); simpl; lra. Qed.
Lemma beyond_continuous f a b : a <= b -> (forall x, a <= x <= b -> continuous f x) ->
  forall x, continuous (beyond f a b) x.
Proof.
  intros H C; apply (extension_C0_continuous f a b); simpl; [exact H |].
  intros x L U; apply C; split; [exact L | exact U].
Qed.

Lemma upper_end g a x : (forall t, continuous g t) -> is_derive (fun t => RInt g a t) x (g x).
Proof.
  intros C; apply (is_derive_RInt g (fun t => RInt g a t) a x); [| apply C].
  apply filter_forall; intros y; apply integral_correct; intros z _; apply C.
Qed.

Lemma fundamental_up f F a b : a <= b -> (forall x, a <= x <= b -> continuous f x) ->
  (forall x, a <= x <= b -> continuous F x) -> (forall x, a < x < b -> is_derive F x (f x)) ->
  RInt f a b = F b - F a.
Proof.
  intros [H|H] C CF D; [| subst; rewrite integral_point; over_reals; ring].
  assert (G := beyond_continuous f a b (Rlt_le _ _ H) C).
  rewrite (RInt_ext f (beyond f a b)).
  2: { rewrite Rmin_left, Rmax_right by lra; intros; symmetry; apply beyond_inside; lra. }
  assert (E : F b - RInt (beyond f a b) a b = F a - RInt (beyond f a b) a a).
  { apply (constant_inside (fun x => F x - RInt (beyond f a b) a x)); [exact H | |].
    - intros x X; apply (continuous_minus F (fun t => RInt (beyond f a b) a t));
        [now apply CF |].
      exact (continuous_derive _ _ _ (upper_end (beyond f a b) a x G)).
    - intros x X; apply (d_eq _ _ (f x - beyond f a b x)).
      + apply (d_minus F (fun t => RInt (beyond f a b) a t)); [now apply D | now apply upper_end].
      + rewrite beyond_inside by lra; apply Rminus_diag_eq; reflexivity. }
  rewrite integral_point in E; lra.
Qed.
Lemma fundamental f F a b : continuous_on f a b -> continuous_on F a b ->
  (forall x, Rmin a b < x < Rmax a b -> is_derive F x (f x)) -> RInt f a b = F b - F a.
Proof.
  intros C CF D; destruct (Rle_or_lt a b) as [H|H].
  - unfold continuous_on in *; rewrite Rmin_left, Rmax_right in * by lra.
    now apply fundamental_up.
  - assert (X : continuous_on f b a).
    { intros x X; apply C; rewrite Rmin_comm, Rmax_comm; exact X. }
    rewrite (integral_flip f b a X), (fundamental_up f F b a); [over_reals; ring | lra | | |];
      unfold continuous_on in *; rewrite Rmin_right, Rmax_left in * by lra; assumption.
Qed.
Lemma fundamental_closed f F a b : continuous_on f a b ->
  (forall x, Rmin a b <= x <= Rmax a b -> is_derive F x (f x)) -> RInt f a b = F b - F a.
Proof.
  intros C D; apply fundamental; [exact C | |].
  - intros x X; exact (continuous_derive _ _ _ (D x X)).
  - intros x X; apply D; lra.
Qed.

(* Comparison. *)
Lemma integral_le f g a b : a <= b -> continuous_on f a b -> continuous_on g a b ->
  (forall x, a < x < b -> f x <= g x) -> RInt f a b <= RInt g a b.
Proof. intros H F G L; apply RInt_le; trivial; now apply integral_exists. Qed.
Lemma integral_nonnegative f a b : a <= b -> continuous_on f a b ->
  (forall x, a < x < b -> 0 <= f x) -> 0 <= RInt f a b.
Proof. intros H C P; apply RInt_ge_0; [exact H | now apply integral_exists | exact P]. Qed.
Lemma integral_positive f a b : a < b -> continuous_on f a b ->
  (forall x, a < x < b -> 0 < f x) -> 0 < RInt f a b.
Proof.
  intros H C P; apply RInt_gt_0; [exact H | exact P |].
  intros x X; apply C; rewrite Rmin_left, Rmax_right; lra.
Qed.
Lemma integral_lt f g a b : a < b -> continuous_on f a b -> continuous_on g a b ->
  (forall x, a < x < b -> f x < g x) -> RInt f a b < RInt g a b.
Proof.
  intros H F G P; apply Rminus_gt_0_lt; rewrite <- integral_minus by assumption.
  apply integral_positive; [exact H | |].
  - intros x X; apply (continuous_minus g f); [now apply G | now apply F].
  - intros x X; specialize (P x X); lra.
Qed.

Lemma integral_below f p q z : p < q -> (forall x, p <= x <= q -> continuous f x) ->
  (forall x, p < x < q -> f x <= 0) -> p < z < q -> f z < 0 -> RInt f p q < 0.
Proof.
  intros H C N Z Y.
  destruct (C z ltac:(lra) (fun y => y < 0)) as [d D].
  { exists (mkposreal (- f z) ltac:(lra)); intros y K; change (Rabs (y - f z) < - f z) in K.
    apply Rabs_def2 in K; lra. }
  set (e := Rmin (d / 2) (Rmin ((z - p) / 2) ((q - z) / 2))).
  assert (E : 0 < e) by (unfold e; pose proof (cond_pos d); repeat apply Rmin_pos; lra).
  assert (E1 : e <= d / 2) by apply Rmin_l.
  assert (E2 : e <= (z - p) / 2) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
  assert (E3 : e <= (q - z) / 2) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_r]).
  pose proof (cond_pos d) as P.
  assert (K : forall u v, p <= u -> u <= v -> v <= q -> continuous_on f u v).
  { intros u v U V W x X; rewrite Rmin_left, Rmax_right in X by lra; apply C; lra. }
  assert (G : forall u v, p <= u -> u <= v -> v <= q -> RInt f u v <= 0).
  { intros u v U V W; replace 0 with (RInt (fun _ : R => 0) u v) by (rewrite integral_const; over_reals; ring).
    apply integral_le; [lra | apply K; lra | intros x _; apply continuous_const |].
    intros x X; apply N; lra. }
  assert (M : RInt f (z - e) (z + e) < 0).
  { replace 0 with (RInt (fun _ : R => 0) (z - e) (z + e)) by (rewrite integral_const; over_reals; ring).
    apply integral_lt; [lra | apply K; lra | intros x _; apply continuous_const |].
    intros x X; apply D; change (Rabs (x - z) < d); apply Rabs_def1; lra. }
  pose proof (G p (z - e) ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (G (z + e) q ltac:(lra) ltac:(lra) ltac:(lra)).
  rewrite (integral_cut f p (z - e) q), (integral_cut f (z - e) (z + e) q) by (apply K; lra); lra.
Qed.

(* Symmetry about the middle, and about 0. *)
Lemma integral_mirror f a b : continuous_on f a b ->
  RInt f a b = RInt (fun x => f (a + b - x)) a b.
Proof.
  intros C.
  assert (E : RInt f b a = RInt (fun u => f (a + b - u) * -1) a b).
  { pose proof (integral_new_variable f (fun u => a + b - u) (fun _ => -1) a b) as E.
    cbv beta in E; replace (a + b - a) with b in E by ring.
    replace (a + b - b) with a in E by ring; apply E.
    - intros u _; apply (d_eq _ _ (0 - 1)); [| ring].
      apply (d_minus (fun _ => a + b) (fun u => u)); [apply d_const | apply d_id].
    - intros u _; apply continuous_const.
    - intros u U; apply C; unfold Rmin, Rmax in *; destruct (Rle_dec a b); lra. }
  rewrite (integral_flip f a b C) in E.
  rewrite (RInt_ext (fun u => f (a + b - u) * -1) (fun u => - f (a + b - u))) in E
    by (intros; over_reals; ring).
  rewrite (integral_opp (fun u => f (a + b - u))) in E; [lra |].
  intros x X; apply (continuous_comp (fun u => a + b - u) f).
  - apply (continuous_minus (fun _ : R => a + b) (fun u => u)); [apply continuous_const |].
    apply continuous_id.
  - apply C; unfold Rmin, Rmax in *; destruct (Rle_dec a b); lra.
Qed.
Lemma integral_halves f a b : a <= b -> continuous_on f a b ->
  (forall x, a <= x <= b -> f (a + b - x) = f x) -> RInt f a b = 2 * RInt f a ((a + b) / 2).
Proof.
  intros H C S; set (m := (a + b) / 2).
  assert (L : continuous_on f a m).
  { apply (continuous_part f a b); [| | exact C]; unfold m;
    [rewrite !Rmin_left by lra | rewrite !Rmax_right by lra]; lra. }
  assert (U : continuous_on f m b).
  { apply (continuous_part f a b); [| | exact C]; unfold m;
    [rewrite !Rmin_left by lra | rewrite !Rmax_right by lra]; lra. }
  rewrite (integral_cut f a m b L U).
  enough (E : RInt f m b = RInt f a m) by lra.
  assert (V : continuous_on f b m).
  { intros x X; apply U; rewrite Rmin_comm, Rmax_comm; exact X. }
  assert (E : RInt f b m = RInt (fun u => f (a + b - u) * -1) a m).
  { pose proof (integral_new_variable f (fun u => a + b - u) (fun _ => -1) a m) as E.
    cbv beta in E; replace (a + b - a) with b in E by ring.
    replace (a + b - m) with m in E by (unfold m; field); apply E.
    - intros u _; apply (d_eq _ _ (0 - 1)); [| ring].
      apply (d_minus (fun _ => a + b) (fun u => u)); [apply d_const | apply d_id].
    - intros u _; apply continuous_const.
    - intros u T; apply C; unfold m in T; rewrite Rmin_left, Rmax_right in * by lra; lra. }
  rewrite (integral_flip f m b U) in E.
  rewrite (RInt_ext (fun u => f (a + b - u) * -1) (fun u => - f u)) in E.
  - rewrite (integral_opp f a m L) in E; lra.
  - unfold m; rewrite Rmin_left, Rmax_right by lra; intros x X; rewrite S by lra; over_reals; ring.
Qed.

(* The derivative by an end. *)
Lemma d_upper_end f a u v x : Rmin a x > u -> Rmax a x < v ->
  (forall t, u < t < v -> continuous f t) -> is_derive (fun t => RInt f a t) x (f x).
Proof.
  intros L U C; pose proof (Rmin_l a x); pose proof (Rmin_r a x).
  pose proof (Rmax_l a x); pose proof (Rmax_r a x).
  apply (is_derive_RInt f (fun t => RInt f a t) a x); [| apply C; lra].
  assert (P : 0 < Rmin (x - u) (v - x)) by (apply Rmin_pos; lra).
  exists (mkposreal _ P); intros y Y; change (Rabs (y - x) < Rmin (x - u) (v - x)) in Y.
  apply Rabs_def2 in Y; pose proof (Rmin_l (x - u) (v - x)); pose proof (Rmin_r (x - u) (v - x)).
  apply integral_correct; intros z Z; apply C.
  unfold Rmin, Rmax in Z; destruct (Rle_dec a y); lra.
Qed.
Lemma d_lower_end f b u v x : Rmin x b > u -> Rmax x b < v ->
  (forall t, u < t < v -> continuous f t) -> is_derive (fun t => RInt f t b) x (- f x).
Proof.
  intros L U C; pose proof (Rmin_l x b); pose proof (Rmin_r x b).
  pose proof (Rmax_l x b); pose proof (Rmax_r x b).
  apply (is_derive_RInt' f (fun t => RInt f t b) x b); [| apply C; lra].
  assert (P : 0 < Rmin (x - u) (v - x)) by (apply Rmin_pos; lra).
  exists (mkposreal _ P); intros y Y; change (Rabs (y - x) < Rmin (x - u) (v - x)) in Y.
  apply Rabs_def2 in Y; pose proof (Rmin_l (x - u) (v - x)); pose proof (Rmin_r (x - u) (v - x)).
  apply integral_correct; intros z Z; apply C.
  unfold Rmin, Rmax in Z; destruct (Rle_dec y b); lra.
Qed.

(* The derivative by a parameter: Leibniz's rule. *)
Definition clamp (a b v : R) : R := Rmax (Rmin a b) (Rmin (Rmax a b) v).
Lemma clamp_between a b v : Rmin a b <= clamp a b v <= Rmax a b.
Proof.
  unfold clamp; pose proof (Rmin_l a b); pose proof (Rmax_l a b); split; [apply Rmax_l |].
  apply Rmax_lub; [lra | apply Rmin_l].
Qed.
Lemma clamp_inside a b v : Rmin a b <= v <= Rmax a b -> clamp a b v = v.
Proof. intros [L U]; unfold clamp; rewrite (Rmin_right (Rmax a b)), Rmax_right; lra. Qed.
Lemma clamp_near a b t v : Rmin a b <= t <= Rmax a b -> Rabs (clamp a b v - t) <= Rabs (v - t).
Proof.
  intros [L U]; unfold clamp; set (l := Rmin a b) in *; set (u := Rmax a b) in *.
  unfold Rmin, Rmax, Rabs; repeat first [destruct (Rle_dec _ _) | destruct (Rcase_abs _)]; lra.
Qed.

Lemma leibniz (f df : R -> R -> R) a b (p p1 p2 : R) : p1 < p < p2 ->
  (forall q t, p1 < q < p2 -> Rmin a b <= t <= Rmax a b -> is_derive (fun u => f u t) q (df q t)) ->
  (forall t, Rmin a b <= t <= Rmax a b -> continuity_2d_pt df p t) ->
  (forall q, p1 < q < p2 -> continuous_on (f q) a b) ->
  is_derive (fun q => RInt (f q) a b) p (RInt (df p) a b).
Proof.
  intros P D C E.
  pose (g := fun u v => f u (clamp a b v)).
  assert (N : 0 < Rmin (p - p1) (p2 - p)) by (apply Rmin_pos; lra).
  set (d := mkposreal _ N).
  assert (near : forall q, Rabs (q - p) < d -> p1 < q < p2).
  { intros q Q; change (Rabs (q - p) < Rmin (p - p1) (p2 - p)) in Q; apply Rabs_def2 in Q.
    pose proof (Rmin_l (p - p1) (p2 - p)); pose proof (Rmin_r (p - p1) (p2 - p)); lra. }
  assert (G : forall q v, p1 < q < p2 -> is_derive (fun u => g u v) q (df q (clamp a b v))).
  { intros q v Q; apply D; [exact Q | apply clamp_between]. }
  assert (same : forall q, RInt (f q) a b = RInt (g q) a b).
  { intros q; apply RInt_ext; intros x X; unfold g; rewrite clamp_inside; [reflexivity | lra]. }
  apply (is_derive_ext (fun q => RInt (g q) a b)); [intros q; symmetry; apply same |].
  rewrite (RInt_ext (df p) (fun t => Derive (fun u => g u t) p)).
  2: { intros x X; symmetry.
       replace (df p x) with (df p (clamp a b x)) by (rewrite clamp_inside by lra; reflexivity).
       apply is_derive_unique, G, P. }
  apply (is_derive_RInt_param g a b p).
  - exists d; intros q Q t T; exists (df q (clamp a b t)); apply G, near, Q.
  - intros t T; apply (continuity_2d_pt_ext_loc (fun u v => df u (clamp a b v))).
    + exists d; intros u v U V; symmetry; apply is_derive_unique, G, near, U.
    + intros e; destruct (C t T e) as [r R]; exists r; intros u v U V.
      rewrite (clamp_inside a b t) by exact T; apply R; [exact U |].
      apply Rle_lt_trans with (2 := V), clamp_near, T.
  - exists d; intros q Q; apply (ex_RInt_ext (f q)).
    + intros x X; unfold g; rewrite clamp_inside; [reflexivity | lra].
    + apply integral_exists, E, near, Q.
Qed.

(* By both ends and a parameter, all of it on an open rectangle. *)
Lemma leibniz_ends (f df : R -> R -> R) (a b : R -> R) (da db p p1 p2 t1 t2 : R) : p1 < p < p2 ->
  t1 < a p < t2 -> t1 < b p < t2 -> is_derive a p da -> is_derive b p db ->
  (forall q t, p1 < q < p2 -> t1 < t < t2 -> is_derive (fun u => f u t) q (df q t)) ->
  (forall q t, p1 < q < p2 -> t1 < t < t2 -> continuity_2d_pt df q t) ->
  (forall q t, p1 < q < p2 -> t1 < t < t2 -> continuous (f q) t) ->
  is_derive (fun q => RInt (f q) (a q) (b q)) p
    (RInt (df p) (a p) (b p) + - f p (a p) * da + f p (b p) * db).
Proof.
  intros P A B DA DB D C E.
  assert (N : 0 < Rmin (p - p1) (p2 - p)) by (apply Rmin_pos; lra).
  assert (near : forall q, Rabs (q - p) < mkposreal _ N -> p1 < q < p2).
  { intros q Q; change (Rabs (q - p) < Rmin (p - p1) (p2 - p)) in Q; apply Rabs_def2 in Q.
    pose proof (Rmin_l (p - p1) (p2 - p)); pose proof (Rmin_r (p - p1) (p2 - p)); lra. }
  assert (N2 : 0 < Rmin (Rmin (a p - t1) (t2 - a p)) (Rmin (b p - t1) (t2 - b p)) / 2).
  { apply Rdiv_lt_0_compat; [| lra]; repeat apply Rmin_pos; lra. }
  set (m := Rmin (Rmin (a p - t1) (t2 - a p)) (Rmin (b p - t1) (t2 - b p)) / 2) in *.
  assert (M : t1 < a p - m /\ a p + m < t2 /\ t1 < b p - m /\ b p + m < t2).
  { pose proof (Rmin_l (Rmin (a p - t1) (t2 - a p)) (Rmin (b p - t1) (t2 - b p))).
    pose proof (Rmin_r (Rmin (a p - t1) (t2 - a p)) (Rmin (b p - t1) (t2 - b p))).
    pose proof (Rmin_l (a p - t1) (t2 - a p)); pose proof (Rmin_r (a p - t1) (t2 - a p)).
    pose proof (Rmin_l (b p - t1) (t2 - b p)); pose proof (Rmin_r (b p - t1) (t2 - b p)).
    unfold m in *; lra. }
  assert (inner : forall q c d t, p1 < q < p2 -> t1 < c < t2 -> t1 < d < t2 ->
    Rmin c d <= t <= Rmax c d -> t1 < t < t2).
  { intros q c d t _ X Y Z; unfold Rmin, Rmax in Z; destruct (Rle_dec c d); lra. }
  assert (whole : forall q c d, p1 < q < p2 -> t1 < c < t2 -> t1 < d < t2 ->
    ex_RInt (fun t => f q t) c d).
  { intros q c d Q X Y; apply integral_exists; intros t T; apply E; [exact Q |].
    now apply (inner q c d). }
  assert (C' : forall q t, p1 < q < p2 -> t1 < t < t2 ->
    continuity_2d_pt (fun u v => Derive (fun z => f z v) u) q t).
  { intros q t Q T; apply (continuity_2d_pt_ext_loc df); [| now apply C].
    assert (W : 0 < Rmin (Rmin (q - p1) (p2 - q)) (Rmin (t - t1) (t2 - t)))
      by (repeat apply Rmin_pos; lra).
    exists (mkposreal _ W); intros u v U V; symmetry; apply is_derive_unique.
    change (Rabs (u - q) < Rmin (Rmin (q - p1) (p2 - q)) (Rmin (t - t1) (t2 - t))) in U.
    change (Rabs (v - t) < Rmin (Rmin (q - p1) (p2 - q)) (Rmin (t - t1) (t2 - t))) in V.
    apply Rabs_def2 in U; apply Rabs_def2 in V.
    pose proof (Rmin_l (Rmin (q - p1) (p2 - q)) (Rmin (t - t1) (t2 - t))).
    pose proof (Rmin_r (Rmin (q - p1) (p2 - q)) (Rmin (t - t1) (t2 - t))).
    pose proof (Rmin_l (q - p1) (p2 - q)); pose proof (Rmin_r (q - p1) (p2 - q)).
    pose proof (Rmin_l (t - t1) (t2 - t)); pose proof (Rmin_r (t - t1) (t2 - t)).
    apply D; lra. }
  assert (beside : forall c, t1 < c < t2 -> locally_2d (fun x' t =>
    continuity_2d_pt (fun u v => Derive (fun z => f z v) u) x' t) p c).
  { intros c T.
    assert (W : 0 < Rmin (Rmin (p - p1) (p2 - p)) (Rmin (c - t1) (t2 - c)))
      by (repeat apply Rmin_pos; lra).
    exists (mkposreal _ W); intros u v U V.
    change (Rabs (u - p) < Rmin (Rmin (p - p1) (p2 - p)) (Rmin (c - t1) (t2 - c))) in U.
    change (Rabs (v - c) < Rmin (Rmin (p - p1) (p2 - p)) (Rmin (c - t1) (t2 - c))) in V.
    apply Rabs_def2 in U; apply Rabs_def2 in V.
    pose proof (Rmin_l (Rmin (p - p1) (p2 - p)) (Rmin (c - t1) (t2 - c))).
    pose proof (Rmin_r (Rmin (p - p1) (p2 - p)) (Rmin (c - t1) (t2 - c))).
    pose proof (Rmin_l (p - p1) (p2 - p)); pose proof (Rmin_r (p - p1) (p2 - p)).
    pose proof (Rmin_l (c - t1) (t2 - c)); pose proof (Rmin_r (c - t1) (t2 - c)).
    apply C'; lra. }
  assert (R : RInt (df p) (a p) (b p) = RInt (fun t => Derive (fun u => f u t) p) (a p) (b p)).
  { apply RInt_ext; intros t T; symmetry; apply is_derive_unique, D; [exact P |].
    apply (inner p (a p) (b p)); trivial; lra. }
  rewrite R; apply is_derive_RInt_param_bound_comp; trivial.
  - exists (mkposreal _ N); intros q Q; apply whole; trivial; apply near, Q.
  - exists (mkposreal _ N2); exists (mkposreal _ N); intros q Q; apply whole; simpl; try lra.
    apply near, Q.
  - exists (mkposreal _ N2); exists (mkposreal _ N); intros q Q; apply whole; simpl; try lra.
    apply near, Q.
  - exists (mkposreal _ N2); exists (mkposreal _ N); intros q Q t T; exists (df q t).
    apply D; [apply near, Q |]; simpl in T; revert T.
    unfold Rmin, Rmax; destruct (Rle_dec _ _); destruct (Rle_dec _ _); lra.
  - intros t T; apply C'; [exact P |]; apply (inner p (a p) (b p)); trivial.
  - now apply beside.
  - now apply beside.
  - apply continuity_pt_filterlim, E; trivial.
  - apply continuity_pt_filterlim, E; trivial.
Qed.

(* Continuity by structure; of a term by its variable, and of one by two variables. *)
Lemma c_mult f g x : continuous f x -> continuous g x -> continuous (fun t => f t * g t) x.
Proof. exact (continuous_mult f g x). Qed.
Lemma c_inv f x : continuous f x -> f x <> 0 -> continuous (fun t => / f t) x.
Proof. exact (continuous_Rinv_comp f x). Qed.
Lemma c_div f g x : continuous f x -> continuous g x -> g x <> 0 ->
  continuous (fun t => f t / g t) x.
Proof. intros F G H; apply c_mult; [exact F | now apply c_inv]. Qed.
Lemma c_pow f n x : continuous f x -> continuous (fun t => f t ^ n) x.
Proof.
  intros F; induction n; simpl; [apply continuous_const | now apply c_mult].
Qed.
Lemma c_comp h f x : continuous f x -> continuous h (f x) -> continuous (fun t => h (f t)) x.
Proof. exact (continuous_comp f h x). Qed.
Lemma c_outer h d f x : is_derive h (f x) d -> continuous f x -> continuous (fun t => h (f t)) x.
Proof. intros H F; apply c_comp; [exact F | exact (continuous_derive _ _ _ H)]. Qed.
Lemma c_exp f x : continuous f x -> continuous (fun t => exp (f t)) x.
Proof. apply c_outer with (1 := d_exp (fun t => t) _ _ (d_id _)). Qed.
Lemma c_sin f x : continuous f x -> continuous (fun t => sin (f t)) x.
Proof. apply c_outer with (1 := d_sin (fun t => t) _ _ (d_id _)). Qed.
Lemma c_cos f x : continuous f x -> continuous (fun t => cos (f t)) x.
Proof. apply c_outer with (1 := d_cos (fun t => t) _ _ (d_id _)). Qed.
Lemma c_atan f x : continuous f x -> continuous (fun t => atan (f t)) x.
Proof. apply c_outer with (1 := d_atan (fun t => t) _ _ (d_id _)). Qed.
Lemma c_sinh f x : continuous f x -> continuous (fun t => sinh (f t)) x.
Proof. apply c_outer with (1 := d_sinh (fun t => t) _ _ (d_id _)). Qed.
Lemma c_cosh f x : continuous f x -> continuous (fun t => cosh (f t)) x.
Proof. apply c_outer with (1 := d_cosh (fun t => t) _ _ (d_id _)). Qed.
Lemma c_tanh f x : continuous f x -> continuous (fun t => tanh (f t)) x.
Proof. apply c_outer with (1 := d_tanh (fun t => t) _ _ (d_id _)). Qed.
Lemma c_arcsinh f x : continuous f x -> continuous (fun t => arcsinh (f t)) x.
Proof. apply c_outer with (1 := d_arcsinh (fun t => t) _ _ (d_id _)). Qed.
Lemma c_ln f x : continuous f x -> 0 < f x -> continuous (fun t => ln (f t)) x.
Proof. intros F H; apply c_outer with (1 := d_ln (fun t => t) _ _ (d_id _) H); exact F. Qed.
Lemma c_tan f x : continuous f x -> cos (f x) <> 0 -> continuous (fun t => tan (f t)) x.
Proof. intros F H; apply c_outer with (1 := d_tan (fun t => t) _ _ (d_id _) H); exact F. Qed.
Lemma c_asin f x : continuous f x -> 0 < 1 - f x -> 0 < 1 + f x ->
  continuous (fun t => asin (f t)) x.
Proof. intros F H K; apply c_outer with (1 := d_asin (fun t => t) _ _ (d_id _) H K); exact F. Qed.
Lemma c_acos f x : continuous f x -> 0 < 1 - f x -> 0 < 1 + f x ->
  continuous (fun t => acos (f t)) x.
Proof. intros F H K; apply c_outer with (1 := d_acos (fun t => t) _ _ (d_id _) H K); exact F. Qed.
Lemma c_atanh f x : continuous f x -> 0 < 1 - f x -> 0 < 1 + f x ->
  continuous (fun t => atanh (f t)) x.
Proof. intros F H K; apply c_outer with (1 := d_atanh (fun t => t) _ _ (d_id _) H K); exact F. Qed.
Lemma c_sqrt f x : continuous f x -> continuous (fun t => sqrt (f t)) x.
Proof. exact (continuous_sqrt_comp f x). Qed.
Lemma c_Rabs f x : continuous f x -> continuous (fun t => Rabs (f t)) x.
Proof. exact (continuous_Rabs_comp f x). Qed.

End Integrals.

Ltac continues :=
  cbv beta;
  lazymatch goal with
  | |- continuous (fun _ : R => ?c) _ => apply (continuous_const c)
  | |- continuous (fun t : R => t) _ => apply continuous_id
  | |- continuous (fun t : R => @?f t + @?g t) _ => apply (continuous_plus f g); continues
  | |- continuous (fun t : R => @?f t - @?g t) _ => apply (continuous_minus f g); continues
  | |- continuous (fun t : R => - @?f t) _ => apply (continuous_opp f); continues
  | |- continuous (fun t : R => @?f t * @?g t) _ => apply (c_mult f g); continues
  | |- continuous (fun t : R => @?f t / @?g t) _ => apply (c_div f g); [continues | continues |]
  | |- continuous (fun t : R => / @?f t) _ => apply (c_inv f); [continues |]
  | |- continuous (fun t : R => @?f t ^ ?n) _ => apply (c_pow f n); continues
  | |- continuous (fun t : R => exp (@?f t)) _ => apply (c_exp f); continues
  | |- continuous (fun t : R => sin (@?f t)) _ => apply (c_sin f); continues
  | |- continuous (fun t : R => cos (@?f t)) _ => apply (c_cos f); continues
  | |- continuous (fun t : R => atan (@?f t)) _ => apply (c_atan f); continues
  | |- continuous (fun t : R => sinh (@?f t)) _ => apply (c_sinh f); continues
  | |- continuous (fun t : R => cosh (@?f t)) _ => apply (c_cosh f); continues
  | |- continuous (fun t : R => tanh (@?f t)) _ => apply (c_tanh f); continues
  | |- continuous (fun t : R => arcsinh (@?f t)) _ => apply (c_arcsinh f); continues
  | |- continuous (fun t : R => sqrt (@?f t)) _ => apply (c_sqrt f); continues
  | |- continuous (fun t : R => Rabs (@?f t)) _ => apply (c_Rabs f); continues
  | |- continuous (fun t : R => ln (@?f t)) _ => apply (c_ln f); [continues |]
  | |- continuous (fun t : R => tan (@?f t)) _ => apply (c_tan f); [continues |]
  | |- continuous (fun t : R => asin (@?f t)) _ => apply (c_asin f); [continues | |]
  | |- continuous (fun t : R => acos (@?f t)) _ => apply (c_acos f); [continues | |]
  | |- continuous (fun t : R => atanh (@?f t)) _ => apply (c_atanh f); [continues | |]
  | |- continuous ?f _ => first [assumption | unfold f; continues]
  end.

Lemma c2_comp (h : R -> R) (d : R) (f : R -> R -> R) (x y : R) : is_derive h (f x y) d ->
  continuity_2d_pt f x y -> continuity_2d_pt (fun u v => h (f u v)) x y.
Proof.
  intros H F; apply (continuity_1d_2d_pt_comp h); [| exact F].
  apply continuity_pt_filterlim; exact (continuous_derive _ _ _ H).
Qed.
Lemma c2_sqrt (f : R -> R -> R) (x y : R) :
  continuity_2d_pt f x y -> continuity_2d_pt (fun u v => sqrt (f u v)) x y.
Proof.
  intros F; apply (continuity_1d_2d_pt_comp sqrt); [| exact F].
  apply continuity_pt_filterlim, continuous_sqrt.
Qed.
Lemma c2_pow n (f : R -> R -> R) (x y : R) :
  continuity_2d_pt f x y -> continuity_2d_pt (fun u v => f u v ^ n) x y.
Proof.
  intros F; induction n; simpl; [apply continuity_2d_pt_const | now apply continuity_2d_pt_mult].
Qed.
Lemma c2_div (f g : R -> R -> R) (x y : R) : continuity_2d_pt f x y -> continuity_2d_pt g x y ->
  g x y <> 0 -> continuity_2d_pt (fun u v => f u v / g u v) x y.
Proof. intros F G H; apply continuity_2d_pt_mult; [exact F | now apply continuity_2d_pt_inv]. Qed.

Ltac continues_2d :=
  cbv beta;
  lazymatch goal with
  | |- continuity_2d_pt (fun _ _ : R => ?c) _ _ => apply (continuity_2d_pt_const _ _ c)
  | |- continuity_2d_pt (fun u _ : R => u) _ _ => apply continuity_2d_pt_id1
  | |- continuity_2d_pt (fun _ v : R => v) _ _ => apply continuity_2d_pt_id2
  | |- continuity_2d_pt (fun u v : R => @?f u v + @?g u v) _ _ =>
      apply (continuity_2d_pt_plus f g); continues_2d
  | |- continuity_2d_pt (fun u v : R => @?f u v - @?g u v) _ _ =>
      apply (continuity_2d_pt_minus f g); continues_2d
  | |- continuity_2d_pt (fun u v : R => - @?f u v) _ _ =>
      apply (continuity_2d_pt_opp f); continues_2d
  | |- continuity_2d_pt (fun u v : R => @?f u v * @?g u v) _ _ =>
      apply (continuity_2d_pt_mult f g); continues_2d
  | |- continuity_2d_pt (fun u v : R => / @?f u v) _ _ =>
      apply (continuity_2d_pt_inv f); [continues_2d |]
  | |- continuity_2d_pt (fun u v : R => @?f u v / @?g u v) _ _ =>
      apply (c2_div f g); [continues_2d | continues_2d |]
  | |- continuity_2d_pt (fun u v : R => @?f u v ^ ?n) _ _ => apply (c2_pow n f); continues_2d
  | |- continuity_2d_pt (fun u v : R => sqrt (@?f u v)) _ _ => apply (c2_sqrt f); continues_2d
  | |- continuity_2d_pt (fun u v : R => ?h (@?f u v)) _ _ =>
      eapply (c2_comp h _ f);
        [lazymatch goal with |- is_derive _ ?z ?d => change (is_derive (fun t : R => h t) z d) end;
         derive | .. | continues_2d]
  | |- continuity_2d_pt ?f _ _ => first [assumption | unfold f; continues_2d]
  end.

Section Limits.
Implicit Types (f g h dg F : R -> R) (a b c d u v x y : R).

(* Limits. *)
Lemma lim_value f x : continuous f x -> is_lim f x (f x).
Proof. intros C; apply is_lim_continuity, continuity_pt_filterlim, C. Qed.
Lemma lim_beside f g (p l : Rbar) : Rbar_locally' p (fun y => f y = g y) ->
  is_lim f p l -> is_lim g p l.
Proof. exact (is_lim_ext_loc f g p l). Qed.
Lemma lim_between f g h (p l : Rbar) : Rbar_locally' p (fun y => f y <= h y <= g y) ->
  is_lim f p l -> is_lim g p l -> is_lim h p l.
Proof. exact (is_lim_le_le_loc f g h p l). Qed.
Lemma lim_only f (p l m : Rbar) : is_lim f p l -> is_lim f p m -> l = m.
Proof. intros L M; now rewrite <- (is_lim_unique f p l L), <- (is_lim_unique f p m M). Qed.

(* Exactly one root: it exists by the signs at the ends, and it is the only one by direction. *)
Lemma root_exists f a b : a <= b -> (forall x, a <= x <= b -> continuous f x) ->
  f a * f b <= 0 -> exists x, a <= x <= b /\ f x = 0.
Proof.
  intros H C S; assert (G := beyond_continuous f a b H C).
  destruct (IVT_gen_consistent (beyond f a b) a b 0 G) as [x [X E]].
  - rewrite !beyond_inside by lra; unfold Rmin, Rmax; destruct (Rle_dec (f a) (f b)); nra.
  - rewrite Rmin_left, Rmax_right in X by lra; exists x; split; [exact X |].
    now rewrite beyond_inside in E by exact X.
Qed.
Lemma rising f df a b : (forall x, a <= x <= b -> continuous f x) ->
  (forall x, a < x < b -> is_derive f x (df x)) -> (forall x, a < x < b -> 0 < df x) ->
  forall x y, a <= x -> x < y -> y <= b -> f x < f y.
Proof.
  intros C D P x y X L Y.
  assert (pr : forall c, x < c < y -> derivable_pt f c).
  { intros c I; exists (df c); apply is_derive_Reals, D; lra. }
  destruct (MVT f id x y pr (fun c _ => derivable_pt_id c) L) as [c [I E]].
  - intros t T; apply continuity_pt_filterlim, C; lra.
  - intros t _; apply derivable_continuous_pt, derivable_pt_id.
  - assert (V : derive_pt f c (pr c I) = df c).
    { apply derive_pt_eq_0, is_derive_Reals, D; lra. }
    assert (U : derive_pt id c (derivable_pt_id c) = 1) by apply derive_pt_id.
    rewrite V, U in E; unfold id in E.
    assert (0 < df c) by (apply P; lra); nra.
Qed.
Lemma exactly_one f df a b : a < b -> (forall x, a <= x <= b -> continuous f x) ->
  (forall x, a < x < b -> is_derive f x (df x)) -> (forall x, a < x < b -> 0 < df x) ->
  f a < 0 < f b -> exists! x, a < x < b /\ f x = 0.
Proof.
  intros H C D P [A B]; assert (M := rising f df a b C D P).
  destruct (root_exists f a b (Rlt_le _ _ H) C) as [x [X E]]; [nra |].
  exists x; split.
  - split; [| exact E]; split.
    + destruct (proj1 X) as [L|L]; [exact L | subst; lra].
    + destruct (proj2 X) as [L|L]; [exact L | subst; lra].
  - intros y [Y Z]; destruct (Rtotal_order x y) as [L|[L|L]]; [| exact L |].
    + assert (f x < f y) by (apply M; lra); lra.
    + assert (f y < f x) by (apply M; lra); lra.
Qed.
Lemma exactly_one_down f df a b : a < b -> (forall x, a <= x <= b -> continuous f x) ->
  (forall x, a < x < b -> is_derive f x (df x)) -> (forall x, a < x < b -> df x < 0) ->
  f b < 0 < f a -> exists! x, a < x < b /\ f x = 0.
Proof.
  intros H C D P [A B].
  destruct (exactly_one (fun x => - f x) (fun x => - df x) a b H) as [x [[X E] U]].
  - intros x X; apply (continuous_opp f), C, X.
  - intros x X; apply (d_opp f), D, X.
  - intros x X; specialize (P x X); lra.
  - lra.
  - exists x; split; [split; [exact X | lra] |]; intros y [Y Z]; apply U; split; [exact Y | lra].
Qed.

(* Locally constant: derivative 0 on an interval, and the value at one point of it. *)
Lemma locally_constant f c : forall x, (forall t, Rmin c x <= t <= Rmax c x -> is_derive f t 0) ->
  f x = f c.
Proof.
  intros x D; destruct (MVT_gen f c x (fun _ => 0)) as [y [_ E]].
  - intros t T; apply D; lra.
  - intros t T; apply continuity_pt_filterlim; exact (continuous_derive _ _ _ (D t T)).
  - lra.
Qed.

(* Both sides: functions that are one to one, where they are. *)
Lemma same_exp x y : exp x = exp y -> x = y.
Proof. apply exp_inv. Qed.
Lemma same_ln x y : 0 < x -> 0 < y -> ln x = ln y -> x = y.
Proof. apply ln_inv. Qed.
Lemma same_sqrt x y : 0 <= x -> 0 <= y -> sqrt x = sqrt y -> x = y.
Proof. apply sqrt_inj. Qed.
Lemma same_square x y : 0 <= x -> 0 <= y -> x ^ 2 = y ^ 2 -> x = y.
Proof. intros; nra. Qed.
Lemma same_factor c x y : c <> 0 -> c * x = c * y -> x = y.
Proof. intros; now apply (Rmult_eq_reg_l c). Qed.
Lemma same_inverse x y : / x = / y -> x = y.
Proof. intros E; rewrite <- (Rinv_inv x), E; apply Rinv_inv. Qed.
Lemma same_atan x y : atan x = atan y -> x = y.
Proof. intros E; rewrite <- (tan_atan x), E; apply tan_atan. Qed.
Lemma same_tan x y : - PI / 2 < x < PI / 2 -> - PI / 2 < y < PI / 2 -> tan x = tan y -> x = y.
Proof. intros X Y E; rewrite <- (atan_tan x), E by lra; apply atan_tan; lra. Qed.
Lemma same_sin x y : - PI / 2 <= x <= PI / 2 -> - PI / 2 <= y <= PI / 2 -> sin x = sin y -> x = y.
Proof. intros X Y E; rewrite <- (asin_sin x), E by lra; apply asin_sin; lra. Qed.
Lemma same_cos x y : 0 <= x <= PI -> 0 <= y <= PI -> cos x = cos y -> x = y.
Proof. intros X Y E; rewrite <- (acos_cos x), E by lra; apply acos_cos; lra. Qed.
Lemma same_sinh x y : sinh x = sinh y -> x = y.
Proof. intros E; rewrite <- (arcsinh_sinh x), E; apply arcsinh_sinh. Qed.
Lemma increasing_tanh x y : x < y -> tanh x < tanh y.
Proof.
  intros L; apply (rising tanh (fun t => 1 * / (cosh t * cosh t)) x y); try lra.
  - intros t _; apply (c_tanh (fun t => t)), continuous_id.
  - intros t _; apply (d_tanh (fun t => t)), d_id.
  - intros t _; pose proof (cosh_pos t); rewrite Rmult_1_l; apply Rinv_0_lt_compat; nra.
Qed.
Lemma same_tanh x y : tanh x = tanh y -> x = y.
Proof.
  intros E; destruct (Rtotal_order x y) as [L|[L|L]]; [| exact L |];
    apply increasing_tanh in L; lra.
Qed.

(* The slope of what an equation defines: h(x(p), p) = 0 along a curve that has a slope. *)
Lemma implicit_slope (h : R -> R -> R) (x : R -> R) (dx p lx lp : R) :
  locally p (fun q => h (x q) q = 0) -> is_derive x p dx ->
  differentiable_pt_lim h (x p) p lx lp -> lx <> 0 -> dx = - lp / lx.
Proof.
  intros Z X D N.
  assert (K : derivable_pt_lim (fun q => h (x q) q) p (lx * dx + lp * 1)).
  { apply (derivable_pt_lim_comp_2d h x (fun q => q)); [exact D | now apply is_derive_Reals |].
    apply derivable_pt_lim_id. }
  apply is_derive_Reals in K.
  assert (E : lx * dx + lp * 1 = 0).
  { rewrite <- (is_derive_unique _ _ _ K); apply is_derive_unique.
    apply (is_derive_ext_loc (fun _ => 0)); [| apply d_const].
    revert Z; apply filter_imp; intros q Q; symmetry; exact Q. }
  apply (Rmult_eq_reg_l lx); [| exact N].
  replace (lx * (- lp / lx)) with (- lp) by (field; exact N).
  lra.
Qed.
End Limits.
(* The premises of a lemma, or of a theorem that is applied, from those at hand. *)
Ltac seen :=
  repeat match goal with H : _ = _ |- _ => clear H end;
  lazymatch goal with
  | |- _ <> 0 => first [apply Rgt_not_eq; facts; nra | apply Rlt_not_eq; facts; nra]
  | |- _ => facts; nra
  end.
Ltac give :=
  cbv beta;
  first [ assumption | reflexivity | lra | nonzero | positive | apply Rgt_lt; positive
        | seen | nra ].
(* What is said, from what it is when values are put in and worked out. *)
Ltac worked_out W :=
  cbv beta;
  first [exact W | lra | etransitivity; [| etransitivity; [exact W |]]; first [ring | field; side]].

(* An arc sine for the arithmetic of intervals. *)
Lemma asin_by_atan x : -1 < x < 1 -> asin x = atan (x / sqrt (1 - x * x)).
Proof. intros H; rewrite asin_atan by exact H; reflexivity. Qed.
Ltac inverse_sines := repeat match goal with
  | |- context [asin ?u] => rewrite (asin_by_atan u) by (split; interval with (i_prec 90))
  end.
(* The premises as the arithmetic of intervals takes them. *)
Ltac weakly := repeat match goal with H : _ < _ |- _ => apply Rlt_le in H end.
(* That an integral exists, by the continuity of what is under it. *)
Ltac integrable := apply (RInt_correct (V := R_CompleteNormedModule)), integral_exists;
  intros ? ?; continues; cbv beta; give.
(* Integrals of what has no parameters: that they exist, and between which numbers they are. *)
Ltac integrated := apply integral_correct; intros ? _; continues; cbv beta; numeric.
Ltac measured := repeat match goal with |- context [RInt ?f ?u ?v] =>
  let H := fresh "M" in integral_intro (RInt f u v) with (i_prec 50, i_relwidth 20) as H;
  generalize dependent (RInt f u v); intros end.

Lemma asin_rises x y : -1 <= x -> x < y -> y <= 1 -> asin x < asin y.
Proof.
  intros X L Y; destruct (Rlt_or_le (asin x) (asin y)) as [H|H]; [exact H | exfalso].
  pose proof (asin_bound x); pose proof (asin_bound y).
  pose proof (sin_incr_1 (asin y) (asin x)) as M; rewrite !sin_asin in M by lra; lra.
Qed.

(* How the hyperbolic sine, the arc tangent and the sine grow. *)
Lemma sinh_pos x : 0 < x -> 0 < sinh x.
Proof.
  intros H; unfold sinh; assert (exp (- x) < exp x) by (apply exp_increasing; lra); lra.
Qed.
Lemma cosh_rises x y : 0 <= x -> x <= y -> cosh x <= cosh y.
Proof.
  intros X [L|L]; [| subst; lra].
  destruct (mean_value cosh sinh x y (Rlt_le _ _ L)) as [c [C E]].
  - intros t _; apply (d_eq _ _ (1 * sinh t)); [apply (d_cosh (fun t => t)), d_id | ring].
  - assert (0 <= sinh c) by (destruct (Req_dec c 0) as [->|];
      [rewrite sinh_0; lra | left; apply sinh_pos; lra]).
    nra.
Qed.
Lemma sinh_rises x y : x < y -> sinh x < sinh y.
Proof.
  intros L; destruct (mean_value sinh cosh x y (Rlt_le _ _ L)) as [c [C E]].
  - intros t _; apply (d_eq _ _ (1 * cosh t)); [apply (d_sinh (fun t => t)), d_id | ring].
  - pose proof (cosh_pos c); nra.
Qed.
Lemma sinh_grows x y : x <= y -> sinh x <= sinh y.
Proof.
  intros L; unfold sinh; pose proof (exp_rises x y L); pose proof (exp_rises (- y) (- x) ltac:(lra)); lra.
Qed.
Lemma arctangent_rises x y : x <= y -> atan x <= atan y.
Proof. intros [L|L]; [left; now apply atan_increasing | rewrite L; lra]. Qed.

(* That a part is defined: a sign by structure, and bounds of functions at the leaves. *)
Lemma share_at_most_one a b : 0 < a -> 0 <= b -> b * / (a + b) <= 1.
Proof.
  intros A B; apply (Rmult_le_reg_r (a + b)); [lra |].
  rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Lemma share_under_one a b : 0 < a -> 0 <= b -> b * / (a + b) < 1.
Proof.
  intros A B; apply (Rmult_lt_reg_r (a + b)); [lra |].
  rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Lemma other_share_at_most_one a b : 0 <= a -> 0 < b -> a * / (a + b) <= 1.
Proof.
  intros A B; apply (Rmult_le_reg_r (a + b)); [lra |].
  rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Lemma quotient_at_most_one a b : 0 < b -> a <= b -> a * / b <= 1.
Proof.
  intros B H; apply (Rmult_le_reg_r b); [exact B |]; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Lemma inverse_difference a b : 0 < a -> a <= b -> 0 <= / a + (-1) * / b.
Proof. intros A H; pose proof (Rinv_le_contravar a b A H); lra. Qed.
Lemma sqrt_at_most_one u : u <= 1 -> sqrt u <= 1.
Proof. intros H; rewrite <- sqrt_1; now apply sqrt_le_1_alt. Qed.
Lemma sqrt_under_one u : u < 1 -> sqrt u < 1.
Proof.
  intros H; destruct (Rle_or_lt u 0) as [L|L]; [rewrite sqrt_neg_0 by exact L; lra |].
  rewrite <- sqrt_1; apply sqrt_lt_1_alt; lra.
Qed.
Lemma tanh_pos x : 0 < x -> 0 < tanh x.
Proof. intros H; rewrite <- tanh_0; now apply increasing_tanh. Qed.
Lemma tanh_between x : -1 < tanh x < 1.
Proof.
  rewrite tanh_law; pose proof (exp_pos x) as P; pose proof (exp_sum x) as S.
  pose proof (Rinv_0_lt_compat _ P) as I.
  split; apply (Rmult_lt_reg_r (exp x + / exp x)); trivial; rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma atan_pos x : 0 < x -> 0 < atan x.
Proof. intros H; rewrite <- atan_0; now apply atan_increasing. Qed.
Lemma sine_square_at_most_one x : 0 <= sin x ^ 2 <= 1.
Proof. pose proof (SIN_bound x); nra. Qed.
Lemma cosine_square_at_most_one x : 0 <= cos x ^ 2 <= 1.
Proof. pose proof (COS_bound x); nra. Qed.
Ltac at_most_one := first
  [ assumption | lra
  | apply share_at_most_one; solve [assumption | lra | positive]
  | apply other_share_at_most_one; solve [assumption | lra | positive]
  | apply quotient_at_most_one; lra
  | match goal with |- ?s * ?a * / ?b <= 1 => apply (quotient_at_most_one (s * a) b); lra end
  | nra ].
Ltac under_one := first
  [ assumption | lra | apply share_under_one; solve [assumption | lra | positive] | nra ].
Ltac bounds := repeat match goal with
  | |- context [sqrt ?u] => add (sqrt u < 1) ltac:(apply sqrt_under_one; under_one)
  | |- context [sqrt ?u] => add (sqrt u <= 1) ltac:(apply sqrt_at_most_one; at_most_one)
  | |- context [asin ?u] => add (- (PI / 2) <= asin u <= PI / 2) ltac:(apply asin_bound)
  | |- context [tanh ?u] => add (-1 < tanh u < 1) ltac:(apply tanh_between)
  | |- context [sin ?u ^ 2] => add (0 <= sin u ^ 2 <= 1) ltac:(apply sine_square_at_most_one)
  | |- context [cos ?u ^ 2] => add (0 <= cos u ^ 2 <= 1) ltac:(apply cosine_square_at_most_one)
  end.
Ltac bounded := facts; bounds; first [assumption | lra | nra].
Ltac structure leaf :=
  first [ assumption | lra | lazymatch goal with
  | |- _ > _ => apply Rlt_gt; structure leaf
  | |- _ >= _ => apply Rle_ge; structure leaf
  | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified; structure leaf
  | |- _ ^ _ <> 0 => apply pow_nonzero; structure leaf
  | |- / _ <> 0 => apply Rinv_neq_0_compat; structure leaf
  | |- Rabs _ <> 0 => apply Rabs_no_R0; structure leaf
  | |- _ <> 0 => first [apply Rgt_not_eq, Rlt_gt; structure leaf | apply Rlt_not_eq; leaf ()]
  | |- 0 < _ * _ => first [apply Rmult_lt_0_compat; structure leaf | leaf ()]
  | |- 0 < / _ => apply Rinv_0_lt_compat; structure leaf
  | |- 0 < _ ^ _ => first
      [apply even_above; [reflexivity | structure leaf] | apply pow_lt; structure leaf | leaf ()]
  | |- 0 < sqrt _ => apply sqrt_lt_R0; structure leaf
  | |- 0 < root _ _ => apply root_lt; structure leaf
  | |- 0 < sinh _ => apply sinh_pos; structure leaf
  | |- 0 < tanh _ => apply tanh_pos; structure leaf
  | |- 0 < cosh _ => apply cosh_pos
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < PI => exact PI_RGT_0
  | |- 0 < atan _ => first [apply atan_pos; structure leaf | leaf ()]
  | |- 0 < asin _ => apply asin_positive; structure leaf
  | |- 0 < sin _ => first [apply sin_gt_0; structure leaf | leaf ()]
  | |- 0 < cos _ => first [apply cos_gt_0; structure leaf | leaf ()]
  | |- 0 < _ + _ => first
      [ leaf () | apply Rplus_lt_0_compat; structure leaf
      | apply Rplus_lt_le_0_compat; structure leaf | apply Rplus_le_lt_0_compat; structure leaf ]
  | |- 0 <= _ * _ => first [apply Rmult_le_pos; structure leaf | leaf ()]
  | |- 0 <= / ?a + (-1) * / ?b => apply (inverse_difference a b); structure leaf
  | |- 0 <= / _ => apply Rlt_le, Rinv_0_lt_compat; structure leaf
  | |- 0 <= _ ^ _ => first [apply even_power; reflexivity | apply pow_le; structure leaf]
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 <= Rabs _ => apply Rabs_pos
  | |- 0 <= _ + _ => first
      [leaf () | apply Rplus_le_le_0_compat; structure leaf | apply Rlt_le; structure leaf]
  | |- 0 <= _ => first [leaf () | apply Rlt_le; structure leaf]
  | |- _ => leaf ()
  end ].
Ltac values := repeat match goal with H : ?x = _ |- _ => is_var x; subst x end.
Ltac collected := match goal with
  | |- ?u <> 0 => ring_simplify u | |- 0 < ?u => ring_simplify u | |- 0 <= ?u => ring_simplify u
  end.
Ltac definedness := saturate; structure ltac:(fun _ => solve [bounded]).

Lemma jordan t : 0 <= t <= PI / 2 -> t <= PI / 2 * sin t.
Proof.
  intros T; pose proof PI_RGT_0 as P.
  assert (H : 0 <= sin t - 2 / PI * t).
  { apply (concave (fun t : R => sin t - 2 / PI * t) (fun t : R => cos t - 2 / PI)
      (fun t : R => - sin t) 0 (PI / 2) t); trivial.
    - intros; eapply d_eq; [derive | ring].
    - intros; eapply d_eq; [derive | ring].
    - intros s S; pose proof (sin_ge_0 s ltac:(lra) ltac:(lra)); lra.
    - rewrite sin_0; lra.
    - rewrite sin_PI2; right; field; lra. }
  apply (Rmult_le_compat_l (PI / 2)) in H; [| lra].
  replace (PI / 2 * (sin t - 2 / PI * t)) with (PI / 2 * sin t - t) in H by (field; lra); lra.
Qed.

(* The implicit function theorem in one dimension: the derivative of any continuous solution, and
   a solution, the greatest point at which the left side is not yet above the right one. *)
Lemma implicit_derive (h : R -> R -> R) (f : R -> R) (x0 p0 lx lp : R) :
  differentiable_pt_lim h x0 p0 lx lp -> lx <> 0 -> f p0 = x0 -> continuous f p0 ->
  locally p0 (fun p => h (f p) p = h x0 p0) -> is_derive f p0 (- lp / lx).
Proof.
  intros D N E C [d2 L]; apply is_derive_Reals; intros eps Eps.
  set (m := Rabs lx); assert (M : 0 < m) by now apply Rabs_pos_lt.
  pose proof (Rabs_pos lp) as P; set (K := (2 * Rabs lp + m) / m).
  assert (K0 : 0 < K) by (unfold K; apply Rdiv_lt_0_compat; lra).
  assert (Eta : 0 < Rmin (m / 2) (eps * m / (2 * (K + 1)))).
  { apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; nra]. }
  destruct (D (mkposreal _ Eta)) as [d Hd]; simpl in Hd.
  assert (C' : locally (f p0) (fun y => Rabs (y - x0) < d)) by (rewrite E; exists d; intros y Y; exact Y).
  destruct (C _ C') as [d1 H1]; pose proof (cond_pos d); pose proof (cond_pos d1); pose proof (cond_pos d2).
  assert (D0 : 0 < Rmin d (Rmin d1 d2)) by (repeat apply Rmin_pos; assumption).
  exists (mkposreal _ D0); simpl; intros t T B.
  pose proof (Rmin_l d (Rmin d1 d2)); pose proof (Rmin_r d (Rmin d1 d2)).
  pose proof (Rmin_l d1 d2); pose proof (Rmin_r d1 d2).
  assert (Q : p0 + t - p0 = t) by ring.
  assert (B1 : ball p0 d1 (p0 + t)) by (change (Rabs (p0 + t - p0) < d1); rewrite Q; lra).
  assert (B2 : ball p0 d2 (p0 + t)) by (change (Rabs (p0 + t - p0) < d2); rewrite Q; lra).
  specialize (H1 _ B1); specialize (L _ B2); simpl in H1, L.
  specialize (Hd (f (p0 + t)) (p0 + t) H1 ltac:(rewrite Q; lra)); rewrite L, Q in Hd.
  rewrite E; set (y := f (p0 + t) - x0) in *.
  replace (h x0 p0 - h x0 p0 - (lx * y + lp * t)) with (- (lx * y + lp * t)) in Hd by ring.
  rewrite Rabs_Ropp in Hd; set (eta := Rmin (m / 2) (eps * m / (2 * (K + 1)))) in *.
  pose proof (Rmin_l (m / 2) (eps * m / (2 * (K + 1)))) as E1.
  pose proof (Rmin_r (m / 2) (eps * m / (2 * (K + 1)))) as E2; fold eta in E1, E2.
  pose proof (Rabs_pos y) as Y0; pose proof (Rabs_pos_lt t T) as T0.
  assert (X : Rmax (Rabs y) (Rabs t) <= Rabs y + Rabs t) by (apply Rmax_lub; lra).
  assert (Z : Rabs (lx * y + lp * t) <= eta * (Rabs y + Rabs t)) by nra.
  assert (W : m * Rabs y <= Rabs (lx * y + lp * t) + Rabs lp * Rabs t).
  { unfold m; rewrite <- !Rabs_mult; replace (lx * y) with ((lx * y + lp * t) + - (lp * t)) at 1 by ring.
    eapply Rle_trans; [apply Rabs_triang | rewrite (Rabs_Ropp (lp * t)); lra]. }
  assert (V : Rabs y <= K * Rabs t).
  { apply (Rmult_le_reg_l m); [exact M |]; replace (m * (K * Rabs t)) with (2 * Rabs lp * Rabs t + m * Rabs t)
      by (unfold K; field; lra); nra. }
  replace (y / t - - lp / lx) with ((lx * y + lp * t) / (lx * t)) by (field; split; assumption).
  unfold Rdiv; rewrite Rabs_mult, Rabs_inv, Rabs_mult; fold m.
  apply (Rmult_lt_reg_r (m * Rabs t)); [nra |]; rewrite Rmult_assoc, Rinv_l by nra; rewrite Rmult_1_r.
  apply Rle_lt_trans with (eta * ((K + 1) * Rabs t)); [eapply Rle_trans; [exact Z |]; apply Rmult_le_compat_l; lra |].
  apply Rle_lt_trans with (eps * m / (2 * (K + 1)) * ((K + 1) * Rabs t)); [apply Rmult_le_compat_r; nra |].
  replace (eps * m / (2 * (K + 1)) * ((K + 1) * Rabs t)) with (eps * (m * Rabs t) / 2) by (field; lra).
  assert (0 < eps * (m * Rabs t)) by (apply Rmult_lt_0_compat; nra); lra.
Qed.
Lemma implicit_solution_up (h hx : R -> R -> R) (x0 p0 : R) :
  locally_2d (fun x p => is_derive (fun t => h t p) x (hx x p)) x0 p0 ->
  continuity_2d_pt hx x0 p0 -> 0 < hx x0 p0 -> locally x0 (fun x => continuous (h x) p0) ->
  exists f, f p0 = x0 /\ continuous f p0 /\ locally p0 (fun p => h (f p) p = h x0 p0).
Proof.
  intros [d1 D] C S [d2 P]; destruct (C (mkposreal _ S)) as [d3 C3]; simpl in C3.
  set (d := Rmin d1 (Rmin d2 d3)); set (r := h x0 p0).
  assert (d0 : 0 < d) by (repeat apply Rmin_pos; apply cond_pos).
  assert (L : d <= d1 /\ d <= d2 /\ d <= d3).
  { unfold d; pose proof (Rmin_l d1 (Rmin d2 d3)); pose proof (Rmin_r d1 (Rmin d2 d3)).
    pose proof (Rmin_l d2 d3); pose proof (Rmin_r d2 d3); lra. }
  assert (near : forall x, x0 - d / 2 <= x <= x0 + d / 2 -> Rabs (x - x0) < d) by (intros; apply Rabs_def1; lra).
  assert (Dx : forall p x, Rabs (p - p0) < d -> x0 - d / 2 <= x <= x0 + d / 2 -> is_derive (fun t => h t p) x (hx x p)).
  { intros p x Hp X; specialize (near x X); apply D; lra. }
  assert (up : forall p x y, Rabs (p - p0) < d -> x0 - d / 2 <= x -> x < y -> y <= x0 + d / 2 -> h x p < h y p).
  { intros p x y Hp X XY Y; apply (rising (fun t => h t p) (fun t => hx t p) x y); try lra.
    - intros t T; apply (continuous_derive _ (hx t p)), Dx; [exact Hp | lra].
    - intros t T; apply Dx; [exact Hp | lra].
    - intros t T; specialize (near t ltac:(lra)); specialize (C3 t p ltac:(lra) ltac:(lra)).
      apply Rabs_def2 in C3; lra. }
  set (E := fun p x => x0 - d / 2 <= x <= x0 + d / 2 /\ h x p <= r).
  exists (fun p => real (Lub_Rbar (E p))).
  assert (one : forall p x, Rabs (p - p0) < d -> x0 - d / 2 <= x <= x0 + d / 2 -> h x p = r -> real (Lub_Rbar (E p)) = x).
  { intros p x Hp X Z; rewrite (is_lub_Rbar_unique (E p) (Finite x)); [reflexivity |]; split.
    - intros y [Y1 Y2]; simpl; destruct (Rle_or_lt y x) as [H|H]; [exact H |].
      specialize (up p x y Hp ltac:(lra) H ltac:(lra)); lra.
    - intros b B; apply B; split; [exact X | lra]. }
  assert (roots : forall e, 0 < e -> e <= d / 2 ->
    locally p0 (fun p => Rabs (real (Lub_Rbar (E p)) - x0) <= e /\ h (real (Lub_Rbar (E p))) p = r)).
  { intros e e0 ed.
    assert (Z : Rabs (p0 - p0) < d) by (rewrite Rminus_eq_0, Rabs_R0; exact d0).
    pose proof (up p0 (x0 - e) x0 Z ltac:(lra) ltac:(lra) ltac:(lra)) as U1; fold r in U1.
    pose proof (up p0 x0 (x0 + e) Z ltac:(lra) ltac:(lra) ltac:(lra)) as U2; fold r in U2.
    assert (B1 : ball x0 d2 (x0 - e)) by (change (Rabs (x0 - e - x0) < d2); apply Rabs_def1; lra).
    assert (B2 : ball x0 d2 (x0 + e)) by (change (Rabs (x0 + e - x0) < d2); apply Rabs_def1; lra).
    pose proof (P _ B1) as C1; pose proof (P _ B2) as C2.
    assert (N1 : locally p0 (fun p => h (x0 - e) p < r)).
    { apply (C1 (fun y => y < r)); apply open_lt; exact U1. }
    assert (N2 : locally p0 (fun p => r < h (x0 + e) p)).
    { apply (C2 (fun y => r < y)); apply open_gt; exact U2. }
    assert (N3 : locally p0 (fun p => Rabs (p - p0) < d)) by (exists (mkposreal d d0); intros y Y; exact Y).
    generalize (filter_and _ _ N1 (filter_and _ _ N2 N3)); apply filter_imp; intros p [H1 [H2 H3]].
    destruct (root_exists (fun t => h t p - r) (x0 - e) (x0 + e)) as [x [X R0]]; [lra | | nra |].
    - intros t T; apply (continuous_minus (fun t => h t p) (fun _ => r)); [| apply continuous_const].
      apply (continuous_derive _ (hx t p)), Dx; [exact H3 | lra].
    - rewrite (one p x H3 ltac:(lra) ltac:(lra)); split; [apply Rabs_le; lra | lra]. }
  split; [apply one; [rewrite Rminus_eq_0, Rabs_R0; exact d0 | lra | reflexivity] | split].
  - intros Q HQ; rewrite (one p0 x0) in HQ; [| rewrite Rminus_eq_0, Rabs_R0; exact d0 | lra | reflexivity].
    destruct HQ as [q HQ]; pose proof (cond_pos q) as q0.
    assert (e0 : 0 < Rmin (q / 2) (d / 2)) by (apply Rmin_pos; lra).
    pose proof (Rmin_l (q / 2) (d / 2)); pose proof (Rmin_r (q / 2) (d / 2)).
    change (locally p0 (fun p => Q (real (Lub_Rbar (E p))))).
    generalize (roots _ e0 ltac:(lra)); apply filter_imp; intros p [H1 _]; apply HQ.
    change (Rabs (real (Lub_Rbar (E p)) - x0) < q); lra.
  - generalize (roots (d / 2) ltac:(lra) ltac:(lra)); apply filter_imp; intros p [_ H1]; exact H1.
Qed.
Lemma implicit_function (h hx : R -> R -> R) (x0 p0 lp : R) :
  locally_2d (fun x p => is_derive (fun t => h t p) x (hx x p)) x0 p0 ->
  continuity_2d_pt hx x0 p0 -> hx x0 p0 <> 0 -> locally x0 (fun x => continuous (h x) p0) ->
  is_derive (h x0) p0 lp ->
  (exists f, f p0 = x0 /\ continuous f p0 /\ locally p0 (fun p => h (f p) p = h x0 p0)
    /\ is_derive f p0 (- lp / hx x0 p0)) /\
  (forall f, f p0 = x0 -> continuous f p0 -> locally p0 (fun p => h (f p) p = h x0 p0) ->
    is_derive f p0 (- lp / hx x0 p0)).
Proof.
  intros D C N P Lp.
  assert (F : differentiable_pt_lim h x0 p0 (hx x0 p0) lp).
  { apply filterdiff_differentiable_pt_lim.
    apply (is_derive_filterdiff h x0 p0 hx lp); [| exact Lp |].
    - apply (locally_2d_locally (fun x p => is_derive (fun t => h t p) x (hx x p))), D.
    - apply (continuity_2d_pt_filterlim hx), C. }
  assert (U : forall f, f p0 = x0 -> continuous f p0 -> locally p0 (fun p => h (f p) p = h x0 p0) ->
    is_derive f p0 (- lp / hx x0 p0)) by (intros f; now apply implicit_derive).
  split; [| exact U].
  assert (X : exists f, f p0 = x0 /\ continuous f p0 /\ locally p0 (fun p => h (f p) p = h x0 p0)).
  { destruct (Rlt_or_le 0 (hx x0 p0)) as [S|S]; [exact (implicit_solution_up h hx x0 p0 D C S P) |].
    destruct (implicit_solution_up (fun x p => - h x p) (fun x p => - hx x p) x0 p0) as [f [F1 [F2 F3]]].
    - revert D; apply locally_2d_impl, locally_2d_forall; intros u v H; now apply (d_opp (fun t => h t v)).
    - now apply continuity_2d_pt_opp.
    - lra.
    - revert P; apply filter_imp; intros x H; now apply (continuous_opp (h x)).
    - exists f; split; [exact F1 | split; [exact F2 |]]; revert F3; apply filter_imp; intros p H; lra. }
  destruct X as [f [F1 [F2 F3]]]; exists f; exact (conj F1 (conj F2 (conj F3 (U f F1 F2 F3)))).
Qed.
(* The same where an equation is said of x and p. *)
Lemma implicit_equation (h hx : R -> R -> R) (says : R -> R -> Prop) (away : R -> R) (x0 p0 r lp s : R) :
  locally_2d (fun x p => is_derive (fun t => h t p) x (hx x p)) x0 p0 ->
  continuity_2d_pt hx x0 p0 -> hx x0 p0 <> 0 -> locally x0 (fun x => continuous (h x) p0) ->
  is_derive (h x0) p0 lp -> locally_2d (fun x p => says x p <-> h x p = r) x0 p0 -> says x0 p0 ->
  (forall p, away p = p - p0) -> s = - lp / hx x0 p0 ->
  (exists f : R -> R, f p0 = x0
    /\ (exists near : R, 0 < near /\ forall x p : R, Rabs (away p) < near -> x = f p -> says x p)
    /\ is_derive f p0 s) /\
  (forall f : R -> R, f p0 = x0 -> continuous f p0 ->
    (exists near : R, 0 < near /\ forall x p : R, Rabs (away p) < near -> x = f p -> says x p) ->
    is_derive f p0 s).
Proof.
  intros D C N P Lp [d Eq] Z Aw ->; pose proof (cond_pos d).
  assert (Z' : h x0 p0 = r) by (apply Eq; trivial; rewrite Rminus_eq_0, Rabs_R0; assumption).
  destruct (implicit_function h hx x0 p0 lp D C N P Lp) as [[f [F1 [F2 [F3 F4]]]] U].
  assert (close : forall g, g p0 = x0 -> continuous g p0 -> locally p0 (fun p => Rabs (g p - x0) < d)).
  { intros g G K; apply (K (fun y => Rabs (y - x0) < d)); rewrite G; exists d; intros y Y; exact Y. }
  assert (beside : locally p0 (fun p => Rabs (p - p0) < d)) by (exists d; intros y Y; exact Y).
  split.
  - exists f; split; [exact F1 | split; [| exact F4]].
    destruct (filter_and _ _ F3 (filter_and _ _ (close f F1 F2) beside)) as [e E]; exists e.
    split; [apply cond_pos |]; intros x p Q ->; rewrite Aw in Q; destruct (E p Q) as [E1 [E2 E3]].
    apply Eq; [exact E2 | exact E3 | rewrite E1; exact Z'].
  - intros g G1 G2 [near [n0 G3]]; apply U; [exact G1 | exact G2 |].
    assert (B : locally p0 (fun p => Rabs (p - p0) < near)) by (exists (mkposreal near n0); intros y Y; exact Y).
    generalize (filter_and _ _ B (filter_and _ _ (close g G1 G2) beside)); apply filter_imp.
    intros p [B1 [B2 B3]]; rewrite Z'; apply Eq; [exact B2 | exact B3 |].
    apply G3; [rewrite Aw; exact B1 | reflexivity].
Qed.

(* The value of a difference at a point, where powers of e cancel. *)
Ltac base_powers :=
  apply Req_le; rewrite <- ?exp_Ropp;
  repeat match goal with |- context [exp ?u] => progress ring_simplify u end; ring.
