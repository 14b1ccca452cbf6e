intros; rewrite Rmult_0_l, Rplus_0_r in *; eapply d_eq; [derive; rewrite ?Rmult_0_l, ?Rplus_0_r; lra |].
cbv beta; rewrite !Rmult_0_l, !Rplus_0_r.
replace ((-1) * (mu * cos epsilon) ^ 2 + 1) with ((-1) * mu ^ 2 * cos epsilon ^ 2 + 1) by ring.
field; apply Rgt_not_eq, sqrt_lt_R0; lra.
