intros a b c x y g D_1 D_2 A B G_3 G_4 G_5 G_6 G_7 G_8 G_9 G_10 N_1 N_2 N_3 N_4.
assert (Y : y < 0) by (apply (claim_unfolded_decrease a b c x y g); assumption).
eexists; eexists; split; [apply (u_angle_by_end a b A B G_3 g x); lra |]; split.
{ apply (u_angle_by_level a b A B G_3 g x); lra. }
pose proof (u_end_above a b A B g x ltac:(lra) G_5) as U.
pose proof (u_level_above a b A B G_3 g x ltac:(lra) G_5) as V.
set (u := u_inner a b g x * _) in U; fold u; revert V; set (v := u_inner a b g x * _); intros V.
clearbody u v; assert (0 <= u * (- cos x)) by (apply Rmult_le_pos; lra).
assert (0 < v * sin x) by (apply Rmult_lt_0_compat; lra).
replace (y * (- u * cos x) + - v * sin x) with (- ((- y) * (u * (- cos x))) - v * sin x) by ring.
assert (0 <= (- y) * (u * (- cos x))) by (apply Rmult_le_pos; lra); lra.
