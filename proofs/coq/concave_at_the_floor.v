intros u G_1 G_2 N; pose proof PI_RGT_0.
pose proof (sinh_lt 0 PI ltac:(lra)) as S; rewrite sinh_0 in S.
pose proof (claim_arsinh_concave (sqrt ((-1) * u ^ 2 + 1)) (sinh PI) ltac:(lra)
  ltac:(apply Rlt_gt, sqrt_lt_R0; nra) ltac:(apply above_sqrt; nra)) as E.
rewrite arcsinh_sinh in E; lra.
