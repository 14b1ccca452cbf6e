intros; assert (sqrt (gamma * / a) <= 1); [| lra].
rewrite <- sqrt_1; apply sqrt_le_1_alt; apply (Rmult_le_reg_r a); [lra |].
rewrite Rmult_assoc, Rinv_l by lra; lra.
