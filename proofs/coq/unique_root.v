intros k r G_1 G_2 G_3; pose proof PI_RGT_0 as P.
destruct (exactly_one (fun t => t + (-1) * k * (PI + atan (r * tanh t)))
  (fun t => 1 - k * r / (cosh t ^ 2 + r ^ 2 * sinh t ^ 2)) 0 ((3 / 2) * PI * k)) as [T [[X E] U]].
{ nra. }
{ intros x _; continues. }
{ intros x [X _]; pose proof (cosh_pos x); eapply d_eq; [derive |]; cbv beta; unfold tanh.
  field; split; [| lra]; apply Rgt_not_eq; nra. }
{ intros x [X _]; pose proof (sinh_lt 0 x X) as S; rewrite sinh_0 in S.
  assert (C : cosh x ^ 2 = 1 + sinh x ^ 2).
  { rewrite sinh_law, cosh_law; pose proof (exp_pos x); field; lra. }
  assert (D : 1 < cosh x ^ 2 + r ^ 2 * sinh x ^ 2) by nra.
  replace (1 - _) with ((cosh x ^ 2 + r ^ 2 * sinh x ^ 2 - k * r) / (cosh x ^ 2 + r ^ 2 * sinh x ^ 2))
    by (field; lra).
  apply Rdiv_lt_0_compat; lra. }
{ rewrite tanh_0, Rmult_0_r, atan_0; pose proof (atan_bound (r * tanh ((3 / 2) * PI * k))).
  split; nra. }
exists T; split; [split; [lra | split; lra] |].
intros y [Y [Z V]]; apply U; split; lra.
