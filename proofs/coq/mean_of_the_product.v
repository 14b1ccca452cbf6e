intros c u z C0 C1 U UC Z ZC; intros.
set (M := fun y : R => / (sqrt (u + (-1) * y ^ 2 + 1)) + u ^ 2 * / ((sqrt (u + (-1) * y ^ 2 + 1)) ^ 5) + (-2) * u * / ((sqrt (u + (-1) * y ^ 2 + 1)) ^ 3)).
set (w := fun y : R => / (sqrt ((-1) * y ^ 2 + 1))).
assert (In : forall y, 0 <= y <= c -> 0 < u + (-1) * y ^ 2 + 1 /\ 0 < (-1) * y ^ 2 + 1) by (intros y Y; assert (y ^ 2 <= c ^ 2) by (apply pow_incr; lra); nra).
assert (W : forall y, 0 <= y <= c -> 0 < w y) by (intros y Y; apply Rinv_0_lt_compat, sqrt_lt_R0; apply In, Y).
assert (Mono : forall x y, 0 <= x -> x <= y -> y <= c -> M x <= M y).
{ intros x y X XY Y; destruct (In x) as [X1 _]; [lra |]; destruct (In y) as [Y1 _]; [lra |].
  unfold M; assert (S : sqrt (u + (-1) * y ^ 2 + 1) <= sqrt (u + (-1) * x ^ 2 + 1)) by (apply sqrt_le_1_alt; assert (x ^ 2 <= y ^ 2) by (apply pow_incr; lra); lra).
  pose proof (sqrt_lt_R0 _ Y1) as S0; set (p := sqrt (u + (-1) * y ^ 2 + 1)) in *; set (q := sqrt (u + (-1) * x ^ 2 + 1)) in *; clearbody p q.
  assert (V : forall n, / q ^ n <= / p ^ n) by (intros n; apply Rinv_le_contravar; [apply pow_lt | apply pow_incr]; lra).
  pose proof (V 1%nat) as V1; rewrite !pow_1 in V1; pose proof (V 3%nat) as V3; pose proof (V 5%nat) as V5.
  pose proof (Rmult_le_compat_l (u ^ 2) _ _ (pow2_ge_0 u) V5); pose proof (Rmult_le_compat_l ((-2) * u) _ _ ltac:(lra) V3); lra. }
assert (Cont : forall y, 0 <= y <= c -> continuous (fun y : R => w y * (y + (-1) * z) * M y) y).
{ intros y Y; destruct (In y Y) as [Y1 Y2]; pose proof (sqrt_lt_R0 _ Y1); pose proof (sqrt_lt_R0 _ Y2); unfold w, M; continues; cbv beta; try (apply pow_nonzero); lra. }
exists (RInt (fun y : R => w y * (y + (-1) * z) * M y) 0 c).
assert (I1 : is_RInt (fun y : R => w y * (y + (-1) * z) * M y) 0 c (RInt (fun y : R => w y * (y + (-1) * z) * M y) 0 c)).
{ apply (RInt_correct (V := R_CompleteNormedModule)), integral_exists; intros y; rewrite Rmin_left, Rmax_right by lra; apply Cont. }
split; [exact I1 |].
assert (I2 : is_RInt (fun y : R => w y * (y + (-1) * z) * M z) 0 c (M z * (1 - sqrt ((-1) * c ^ 2 + 1) - z * asin c))).
{ evar_last.
  - apply (is_RInt_derive (fun y : R => M z * ((-1) * sqrt ((-1) * y ^ 2 + 1) + (-1) * z * asin y))); intros y; rewrite Rmin_left, Rmax_right by lra; intros Y; destruct (In y Y) as [Y1 Y2]; pose proof (sqrt_lt_R0 _ Y2).
    + eapply d_eq; [derive; cbv beta; first [exact Y2 | nra] |]; tidy; unfold w; field; lra.
    + unfold w; continues; cbv beta; lra.
  - unfold minus, plus, opp; simpl; rewrite asin_0; replace (-1 * (0 * (0 * 1)) + 1) with 1 by ring; rewrite sqrt_1; ring. }
match goal with |- (-1) * ?p * ?m + _ >= 0 => change m with (M z) end.
assert (L := is_RInt_le _ _ 0 c _ _ (Rlt_le _ _ C0) I2 I1); cbv beta in L.
enough (M z * (1 - sqrt ((-1) * c ^ 2 + 1) - z * asin c) <= RInt (fun y : R => w y * (y + (-1) * z) * M y) 0 c) by lra.
apply L; intros y Y; rewrite !Rmult_assoc; apply Rmult_le_compat_l; [left; apply W; lra |].
destruct (Rle_or_lt z y) as [D|D].
- assert (M z <= M y) by (apply Mono; lra); nra.
- assert (M y <= M z) by (apply Mono; lra); nra.
