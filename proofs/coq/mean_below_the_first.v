intros c G_1 G_2 N_1 N_2 N_3.
destruct (mean_value (fun t => sqrt ((-1) * t ^ 2 + 1) + t * asin t) asin 0 c) as [u [U1 U2]].
{ lra. }
{ intros t T; assert (0 < (-1) * t ^ 2 + 1) by nra.
  eapply d_eq; [derive; nra |]; tidy; field; apply Rgt_not_eq, sqrt_lt_R0; lra. }
cbv beta in U2; replace ((-1) * 0 ^ 2 + 1) with 1 in U2 by ring; rewrite sqrt_1 in U2.
assert (0 <= asin u); [| nra].
destruct (Rle_lt_or_eq_dec 0 u ltac:(lra)) as [P|P]; [left; apply asin_positive; lra |].
rewrite <- P, asin_0; lra.
