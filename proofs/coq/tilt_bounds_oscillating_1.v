intros; assert (sqrt (/ (a + b) * (b + gamma)) <= 1); [| lra].
rewrite <- sqrt_1; apply sqrt_le_1_alt; apply (Rmult_le_reg_l (a + b)); [lra |].
rewrite <- Rmult_assoc, Rinv_r by lra; lra.
