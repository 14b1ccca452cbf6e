intros [K [d [D H]]]; pose proof pi_between as J.
pose (angle := fun t : R => 2 * sqrt ((-1) * t ^ 2 + 1) * exp ((-1) * / - t * (PI + 0 + asin t))).
pose (r := / (/ d + 2)); assert (d0 : 0 < / d) by (apply Rinv_0_lt_compat; lra).
assert (r0 : 0 < r) by (apply Rinv_0_lt_compat; lra).
assert (r1 : r <= 1 / 2) by (unfold r; replace (1 / 2) with (/ 2) by field; apply Rinv_le_contravar; lra).
assert (r2 : r < d) by (unfold r; rewrite <- (Rinv_inv d) at 2; apply Rinv_lt_contravar; nra).
pose proof (Rabs_pos (angle r)); pose proof (Rabs_pos K); destruct (archimed (Rabs (angle r) + Rabs K)) as [N _].
assert (M : INR (Z.to_nat (up (Rabs (angle r) + Rabs K))) = IZR (up (Rabs (angle r) + Rabs K))).
{ rewrite INR_IZR_INZ, Z2Nat.id; [reflexivity | apply le_IZR; lra]. }
set (n := Z.to_nat _) in M; rewrite <- M in N; clearbody n; clear M; pose (T := PI / 2 + 2 * INR n * PI).
assert (T0 : Rabs (angle r) + Rabs K < T) by (unfold T; nra).
pose (s := / (T + / r)); assert (i0 : 0 < / r) by (apply Rinv_0_lt_compat; exact r0).
assert (s0 : 0 < s) by (apply Rinv_0_lt_compat; lra).
assert (s1 : s <= r) by (unfold s; rewrite <- (Rinv_inv r) at 2; apply Rinv_le_contravar; lra).
assert (near : forall t, s <= t <= r -> 0 < t <= 1 / 2 /\ 0 < (-1) * t ^ 2 + 1 /\ 0 < asin t).
{ intros t X; assert (0 < t) by lra; repeat split; try nra; apply asin_above; assumption. }
assert (S : T <= angle s).
{ destruct (near s ltac:(lra)) as [A [B C]]; unfold angle.
  assert (1 / 2 <= sqrt ((-1) * s ^ 2 + 1)) by (apply below_sqrt; nra).
  replace ((-1) * / - s * (PI + 0 + asin s)) with ((T + / r) * (PI + asin s)) by (unfold s at 2; rewrite <- Rinv_opp, Rinv_inv; ring).
  assert (T <= exp ((T + / r) * (PI + asin s))); [| pose proof (exp_pos ((T + / r) * (PI + asin s))); nra].
  eapply Rle_trans; [| apply exp_ineq1_le]; assert (0 <= T) by lra; nra. }
destruct (root_exists (fun t => angle t - T) s r s1) as [t [X Z]].
{ intros t X; destruct (near t X) as [A [B C]]; unfold angle; continues; lra. }
{ pose proof (Rle_abs (angle r)); nra. }
destruct (near t X) as [A [B C]]; assert (Y : angle t = T) by lra; unfold angle in Y.
assert (c0 : cos T = 0) by (unfold T; rewrite cos_period; apply cos_PI2).
assert (s2 : sin T = 1) by (unfold T; rewrite sin_period; apply sin_PI2).
specialize (H (- t) t 0); rewrite Y, c0 in H.
destruct H as [v [V W]]; try lra.
assert (E : v = T * (PI + asin t) * / t).
{ rewrite <- (is_derive_unique _ _ _ V); apply is_derive_unique; eapply d_eq.
  - derive; cbv beta; rewrite ?Y, ?c0; lra.
  - cbv beta; rewrite ?Y, ?c0, ?s2; replace ((-1) * (t * 0) ^ 2 + 1) with 1 by ring; rewrite sqrt_1, <- Y; field; lra. }
rewrite Rabs_R1, Rmult_1_r in W; pose proof (Rle_abs K); pose proof (Rle_abs v).
assert (F : 1 <= / t) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
assert (T * 3 <= T * (PI + asin t)) by (apply Rmult_le_compat_l; lra).
assert (T <= v) by (rewrite E; nra); lra.
