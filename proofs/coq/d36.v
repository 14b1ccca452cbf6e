intros a b epsilon x0 D_1 D_2 G_1 G_2 G_3 G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8.
pose proof (claim_d35 a b epsilon x0 D_1 D_2 G_1 G_2 G_3 G_4 G_5 G_6 G_7) as I.
assert (X0 : 0 < x0).
{ rewrite D_1; assert (0 < sqrt (b * / (a + b))) by (apply sqrt_lt_R0; positive); positive. }
assert (K : 0 < sqrt (a * / b)) by (apply sqrt_lt_R0; positive).
assert (K2 : sqrt (a * / b) ^ 2 * b = a) by (rewrite pow2_sqrt by exact N_4; field; lra).
set (k := sqrt (a * / b)) in *.
assert (S0 : 0 < sqrt ((-1) * x0 ^ 2 + 1)) by (apply sqrt_lt_R0; exact N_3).
assert (S2 : sqrt ((-1) * x0 ^ 2 + 1) ^ 2 = (-1) * x0 ^ 2 + 1) by (apply pow2_sqrt; lra).
assert (U0 : k * x0 < sqrt ((-1) * x0 ^ 2 + 1)).
{ apply (Rmult_lt_reg_r (/ sqrt ((-1) * x0 ^ 2 + 1))); [now apply Rinv_0_lt_compat |].
  rewrite Rinv_r by lra; lra. }
assert (V0 : k ^ 2 * x0 ^ 2 < (-1) * x0 ^ 2 + 1) by (assert (0 < k * x0) by positive; nra).
pose (F := fun x : R => / k * atanh (x * k * / sqrt ((-1) * x ^ 2 + 1)) + (-1) * b * asin x).
assert (near : forall x, - x0 <= x <= x0 -> 0 < (-1) * x ^ 2 + 1 /\ k ^ 2 * x ^ 2 < (-1) * x ^ 2 + 1).
{ intros x X; assert (x ^ 2 <= x0 ^ 2) by nra; split; [lra |].
  assert (k ^ 2 * x ^ 2 <= k ^ 2 * x0 ^ 2) by (apply Rmult_le_compat_l; [nra | assumption]); lra. }
assert (small : forall x, - x0 <= x <= x0 ->
  0 < 1 - x * k * / sqrt ((-1) * x ^ 2 + 1) /\ 0 < 1 + x * k * / sqrt ((-1) * x ^ 2 + 1)).
{ intros x X; destruct (near x X) as [P Q].
  assert (S : 0 < sqrt ((-1) * x ^ 2 + 1)) by (apply sqrt_lt_R0; exact P).
  assert (S' : sqrt ((-1) * x ^ 2 + 1) ^ 2 = (-1) * x ^ 2 + 1) by (apply pow2_sqrt; lra).
  set (s := sqrt ((-1) * x ^ 2 + 1)) in *.
  assert (W : (x * k * / s) ^ 2 < 1).
  { rewrite !Rpow_mult_distr, pow_inv, S'; apply (Rmult_lt_reg_r ((-1) * x ^ 2 + 1)); [exact P |].
    rewrite Rmult_assoc, Rinv_l by lra; lra. }
  split; nra. }
assert (E : RInt (fun x : R => / sqrt ((-1) * x ^ 2 + 1) * / ((-1) * / b * x ^ 2 * (a + b) + 1)
  + (-1) * b * / sqrt ((-1) * x ^ 2 + 1)) x0 ((-1) * x0) = F ((-1) * x0) - F x0).
{ apply fundamental_closed; rewrite ?Rmin_right, ?Rmax_left by lra; intros x X.
  - rewrite Rmin_right, Rmax_left in X by lra; destruct (near x) as [P Q]; [lra |].
    assert (0 < sqrt ((-1) * x ^ 2 + 1)) by (apply sqrt_lt_R0; exact P).
    assert (0 < (-1) * / b * x ^ 2 * (a + b) + 1).
    { rewrite <- K2; replace (_ + 1) with ((-1) * x ^ 2 + 1 - k ^ 2 * x ^ 2) by (field; lra); lra. }
    continues; cbv beta; lra.
  - destruct (near x) as [P Q]; [lra |]; destruct (small x) as [L M]; [lra |].
    assert (S : 0 < sqrt ((-1) * x ^ 2 + 1)) by (apply sqrt_lt_R0; exact P).
    assert (S' : sqrt ((-1) * x ^ 2 + 1) ^ 2 = (-1) * x ^ 2 + 1) by (apply pow2_sqrt; lra).
    assert (J : -1 < x < 1) by (split; nra).
    unfold F; eapply d_eq; [derive; cbv beta; first [assumption | lra] |]; tidy.
    set (s := sqrt ((-1) * x ^ 2 + 1)) in *; clearbody s.
    assert (T : x ^ 2 = 1 - s ^ 2) by lra; rewrite <- K2.
    assert (s ^ 2 - k ^ 2 * x ^ 2 <> 0) by lra.
    assert (H' : -1 * x ^ 2 * (k ^ 2 * b + b) + b <> 0).
    { replace (_ + b) with (b * (s ^ 2 - k ^ 2 * x ^ 2)) by ring [T]; nonzero. }
    field [T]; repeat split; lra. }
rewrite (is_RInt_unique _ _ _ _ I) in E.
assert (O : F ((-1) * x0) = - F x0).
{ unfold F; replace ((-1) * x0) with (- x0) by ring; rewrite asin_opp.
  replace ((- x0) ^ 2) with (x0 ^ 2) by ring.
  replace (- x0 * k * / sqrt ((-1) * x0 ^ 2 + 1)) with (- (x0 * k * / sqrt ((-1) * x0 ^ 2 + 1)))
    by ring.
  assert (A : forall y, 0 < 1 - y -> 0 < 1 + y -> atanh (- y) = - atanh y).
  { intros y P Q; unfold atanh; replace ((1 + - y) / (1 - - y)) with (/ ((1 + y) / (1 - y)))
      by (field; lra); rewrite ln_Rinv by positive; field. }
  destruct (small x0) as [L M]; [lra |]; rewrite A by assumption; ring. }
rewrite O in E; unfold F in E.
assert (R1 : sqrt (a * b) = k * b).
{ apply sqrt_unique; [left; positive |]; rewrite <- K2; ring. }
rewrite R1; assert (Y : / k * atanh (x0 * k * / sqrt ((-1) * x0 ^ 2 + 1)) = b * PI + b * asin x0) by lra.
apply (Rmult_eq_compat_l k) in Y; rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l in Y by lra.
rewrite Y; ring.
