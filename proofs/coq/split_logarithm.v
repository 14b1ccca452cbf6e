intros u x0 G_1 G_2 G_3 N_1 N_2 N_3 N_4.
set (w := fun x : R => sqrt (u + x ^ 2)).
assert (P : forall x, x0 <= x <= 1 -> 0 < u + x ^ 2) by (intros; nra).
assert (W : forall x, x0 <= x <= 1 -> 0 < w x) by (intros; apply sqrt_lt_R0, P; assumption).
assert (C : continuous_on (fun x : R => / sqrt (u + x ^ 2)) x0 1).
{ intros x X; rewrite Rmin_left, Rmax_right in X by lra; specialize (W x X); continues; cbv beta; unfold w in W; lra. }
replace (ln (/ (x0 + sqrt (u + x0 ^ 2)) * (sqrt (u + 1) + 1))) with (RInt (fun x : R => / sqrt (u + x ^ 2)) x0 1).
{ apply integral_correct, C. }
assert (0 < x0 + w x0) by (specialize (W x0 ltac:(lra)); lra).
rewrite (fundamental_closed _ (fun x => ln (x + w x))).
- replace (u + 1) with (u + 1 ^ 2) by ring; specialize (W 1 ltac:(lra)); fold (w 1) (w x0).
  rewrite ln_mult, ln_Rinv by (first [lra | positive]); rewrite (Rplus_comm (w 1)); over_reals; ring.
- exact C.
- intros x X; rewrite Rmin_left, Rmax_right in X by lra; pose proof (P x X); specialize (W x X); unfold w in *.
  eapply d_eq; [derive; lra |]; tidy; field; lra.
