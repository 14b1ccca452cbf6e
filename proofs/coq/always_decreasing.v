assert (S : sin ((3 / 2) * PI) = -1).
{ replace ((3 / 2) * PI) with (PI / 2 + PI) by field; rewrite neg_sin, sin_PI2; ring. }
assert (C : cos ((3 / 2) * PI) = 0).
{ replace ((3 / 2) * PI) with (PI / 2 + PI) by field; rewrite neg_cos, cos_PI2; ring. }
exists 1, (1 / 2), 0, (- (1 / 4)).
repeat (split; [try rewrite S, C; lra |]).
eexists; eexists; split; [apply (u_angle_by_end 1 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) (- (1 / 4)) ((3 / 2) * PI)); lra |].
split; [apply (u_angle_by_level 1 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) (- (1 / 4)) ((3 / 2) * PI)); lra |].
pose proof (u_level_above 1 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) (- (1 / 4)) ((3 / 2) * PI) ltac:(lra) ltac:(lra)) as V.
revert V; set (v := u_inner 1 (1 / 2) (- (1 / 4)) ((3 / 2) * PI) * (_ + _)); intros V; clearbody v.
rewrite S; lra.
