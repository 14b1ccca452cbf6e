intros T k r x G_1 G_2 G_3 G_4 N.
set (D := fun t : R => cosh t ^ 2 + r ^ 2 * sinh t ^ 2).
assert (P : forall t, 0 < D t).
{ intros t; unfold D; pose proof (cosh_pos t); pose proof (pow2_ge_0 (sinh t)); pose proof (pow2_ge_0 r).
  assert (0 < cosh t ^ 2) by positive; nra. }
set (f := fun t : R => 2 * k * r * / D t ^ 2 * (r ^ 2 + 1) * (T + (-1) * t) * cosh t * sinh t).
assert (C : continuous_on f x T).
{ intros t _; unfold f, D; continues; apply pow_nonzero, Rgt_not_eq, P. }
set (F := fun t : R => (-1) * (T + (-1) * t) * k * r * / D t - k * atan (r * tanh t)).
assert (E : RInt f x T = F T - F x).
{ apply fundamental_closed; [exact C |]; intros t _; pose proof (cosh_pos t); specialize (P t).
  assert (B : is_derive (fun t : R => atan (r * tanh t)) t (r * / D t)).
  { eapply d_eq; [derive |]; tidy; unfold D, tanh in *; field; split; [| lra]; apply Rgt_not_eq; nra. }
  unfold F; eapply d_eq.
  - apply (d_minus (fun t => (-1) * (T + (-1) * t) * k * r * / D t) (fun t => k * atan (r * tanh t))).
    + unfold D in *; derive; lra.
    + apply (d_mult (fun _ => k) (fun t => atan (r * tanh t))); [apply d_const | exact B].
  - tidy; unfold f; fold (D t); field; lra. }
match goal with |- is_RInt _ _ _ ?v => replace v with (RInt f x T) end; [apply integral_correct, C |].
rewrite E; unfold F; fold (D x); pose proof (P x); pose proof (P T); over_reals; field; lra.
