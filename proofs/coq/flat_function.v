intros [K [d [D H]]]; pose proof (Rabs_pos K).
set (y := Rabs K + / d + 1); assert (0 < / d) by (apply Rinv_0_lt_compat; lra).
assert (Y : 1 <= y) by (unfold y; lra); assert (I : 0 < / y) by (apply Rinv_0_lt_compat; lra).
assert (X : / y < d).
{ rewrite <- (Rinv_inv d); apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | unfold y; lra]. }
specialize (H (- / y) ltac:(lra) ltac:(lra) ltac:(lra)).
replace ((-1) * / - / y) with y in H by (field; lra).
pose proof (exp_ineq1 y ltac:(lra)) as E; rewrite Rabs_pos_eq in H by (left; apply exp_pos).
rewrite Rabs_Ropp, (Rabs_pos_eq (/ y)) in H by lra.
assert (/ y <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
pose proof (Rle_abs K); assert (K * / y <= Rabs K * 1) by (apply Rle_trans with (Rabs K * / y); [apply Rmult_le_compat_r; lra | apply Rmult_le_compat_l; lra]).
revert E; unfold y at 1; intros; lra.
