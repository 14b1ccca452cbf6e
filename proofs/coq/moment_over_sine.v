intros u x0 G_1 G_2 G_3 N_1 N_2 N_3 N_4 N_5 N_6.
set (w := fun x : R => sqrt (u + x ^ 2)).
assert (P : forall x, x0 <= x <= 1 -> 0 < u + x ^ 2) by (intros; nra).
assert (W : forall x, x0 <= x <= 1 -> 0 < w x) by (intros; apply sqrt_lt_R0, P; assumption).
assert (W2 : forall x, x0 <= x <= 1 -> w x ^ 2 = u + x ^ 2) by (intros; apply pow2_sqrt; left; apply P; assumption).
set (f := fun x : R => x ^ 4 * / sqrt (u + x ^ 2) ^ 5).
assert (C : continuous_on f x0 1).
{ intros x X; rewrite Rmin_left, Rmax_right in X by lra; specialize (W x X); unfold f; continues.
  apply pow_nonzero; unfold w in W; lra. }
assert (E : RInt f x0 1 = ln (1 + w 1) - / w 1 - / 3 * / w 1 ^ 3 - (ln (x0 + w x0) - x0 * / w x0 - / 3 * x0 ^ 3 * / w x0 ^ 3)).
{ rewrite (fundamental_closed _ (fun x => ln (x + w x) - x * / w x - / 3 * x ^ 3 * / w x ^ 3)).
  - over_reals; ring.
  - exact C.
  - intros x X; rewrite Rmin_left, Rmax_right in X by lra; pose proof (P x X) as H; specialize (W x X); specialize (W2 x X).
    unfold w; eapply d_eq; [derive; fold (w x); try exact H; try (apply pow_nonzero); lra |].
    tidy; unfold f; fold (w x); set (v := w x) in *; field [W2]; lra. }
replace (_ + _ + _ + _ + _ + _) with (RInt f x0 1); [apply integral_correct, C |].
rewrite E; unfold w; replace (u + 1 ^ 2) with (u + 1) by ring; rewrite (Rplus_comm 1).
specialize (W x0 ltac:(lra)); assert (0 < sqrt (u + 1)) by (apply sqrt_lt_R0; lra); unfold w in W.
set (l := ln _); set (m := ln _); over_reals; field; lra.
