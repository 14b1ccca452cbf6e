intros [K [d [D H]]]; pose proof (Rabs_pos K); pose proof pi_between as PB.
set (y := Rabs K + / d + 1); assert (0 < / d) by (apply Rinv_0_lt_compat; lra).
assert (Y : 1 <= y) by (unfold y; lra); assert (I : 0 < / y) by (apply Rinv_0_lt_compat; lra).
assert (X : / y < d).
{ rewrite <- (Rinv_inv d); apply Rinv_lt_contravar; [nra | unfold y; lra]. }
specialize (H (- / y) 0 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
replace ((-1) * / - / y * (PI + 0 + asin 0)) with (y * PI) in H by (rewrite asin_0; field; lra).
replace ((-1) * 0 ^ 2 + 1) with 1 in H by ring; rewrite sqrt_1, Rabs_R1, Rmult_1_r, Rmult_1_r in H.
pose proof (exp_ineq1 (y * PI) ltac:(nra)) as E; pose proof (exp_pos (y * PI)).
rewrite Rabs_pos_eq in H by lra; pose proof (Rle_abs K); assert (y <= y * PI) by nra; unfold y in *; lra.
