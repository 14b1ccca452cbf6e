intros v_E v_I1 v_I2 v_I3 v_M v_M1 v_M2 v_M3 v_Omega1 v_Omega2 v_Omega3 v_S2 a b gamma psi theta.
intros D_1 D_2 D_3 D_4 D_5 D_6 D_7 D_8 D_9 D_10 D_11 G_1 G_2 G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10 G_11 G_12 G_13 N_1 N_2 N_3.
rewrite (claim_root_argument v_E v_I1 v_I2 v_I3 v_M v_M1 v_M2 v_M3 v_Omega1 v_Omega2 v_Omega3 a b gamma psi theta) by assumption.
assert (E : sqrt (b ^ 2 * cos psi ^ 2 * sin psi ^ 2 * sin theta ^ 4) = b * Rabs (cos psi * sin psi) * sin theta ^ 2).
{ apply sqrt_unique; [pose proof (Rabs_pos (cos psi * sin psi)); pose proof (pow2_ge_0 (sin theta)); repeat apply Rmult_le_pos; lra |].
  rewrite !Rpow_mult_distr, pow2_abs; ring. }
rewrite E, D_1.
assert (A : Rabs (cos psi * sin psi) <> 0) by (apply Rabs_no_R0; intros Z; replace (cos psi ^ 2 * sin psi ^ 2) with ((cos psi * sin psi) ^ 2) in G_13 by ring; rewrite Z in G_13; lra).
field; repeat split; assumption.
