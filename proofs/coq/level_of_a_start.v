intros v_E v_I1 v_I2 v_I3 v_M v_M1 v_M2 v_M3 v_Omega1 v_Omega2 v_Omega3 a b v_dphi_dt v_dpsi_dphi v_dpsi_dt v_dtheta_dt gamma phi psi theta.
intros D_1 D_2 D_3 D_4 D_5 D_6 D_7 D_8 D_9 D_10 D_11 D_12 D_13 D_14 G_1 G_2 G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10 G_11 G_12 G_13 G_14 N_1.
assert (T : sin psi ^ 2 <= 1) by (rewrite sin_square; pose proof (pow2_ge_0 (cos psi)); lra).
assert (B : (-1) * b * sin psi ^ 2 + 1 <> 0) by (apply Rgt_not_eq; pose proof (Rmult_le_compat_l b _ _ ltac:(lra) T); lra).
pose (v_dtheta_dphi := v_dtheta_dt * / v_dphi_dt).
destruct (claim_eq_Euler v_I1 v_I2 v_I3 v_M v_M1 v_M2 v_M3 v_Omega1 v_Omega2 v_Omega3 a b v_dphi_dt v_dpsi_dphi v_dpsi_dt v_dtheta_dphi v_dtheta_dt phi psi theta) as [_ ->]; try give.
rewrite (claim_eq_gamma v_E v_I1 v_I2 v_I3 v_M v_M1 v_M2 v_M3 v_Omega1 v_Omega2 v_Omega3 a b gamma psi theta) by assumption.
rewrite (sin_square theta); field; repeat split; first [assumption | lra].
