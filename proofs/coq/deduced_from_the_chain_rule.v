intros b lambda u B B1 L; intros.
assert (R0 : 0 < b ^ 2 * lambda ^ 2 + 1) by nra.
set (m := fun t : R => b * t * / (sqrt (b ^ 2 * t ^ 2 + 1))).
assert (Sq : forall t, 0 < b ^ 2 * t ^ 2 + 1 /\ (-1) * m t ^ 2 + 1 = (-1) * b ^ 2 * t ^ 2 * / (b ^ 2 * t ^ 2 + 1) + 1).
{ intros t; assert (R1 : 0 < b ^ 2 * t ^ 2 + 1) by nra; split; [exact R1 |]; pose proof (sqrt_lt_R0 _ R1).
  assert (W : sqrt (b ^ 2 * t ^ 2 + 1) ^ 2 = b ^ 2 * t ^ 2 + 1) by (apply pow2_sqrt; lra).
  unfold m; rewrite !Rpow_mult_distr, pow_inv, W; field; lra. }
assert (D : exists dm, is_derive m lambda dm) by (eexists; unfold m; derive; cbv beta; [lra | apply Rgt_not_eq, sqrt_lt_R0; lra]).
destruct D as [dm D].
assert (M : -1 < m lambda < 1).
{ destruct (Sq lambda) as [_ E]; assert (0 < (-1) * b ^ 2 * lambda ^ 2 * / (b ^ 2 * lambda ^ 2 + 1) + 1) by assumption; nra. }
destruct (chain_of_G m lambda u dm D L M) as [v3 [v4 [X1 [X3 X4]]]].
exists v4, (dm * v3 + v4), dm, v3; split; [exact X4 | split; [| split; [exact D | split; [exact X3 | ring]]]].
eapply is_derive_ext; [| exact X1]; intros t; cbv beta; rewrite (proj2 (Sq t)); reflexivity.
