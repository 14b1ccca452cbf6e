intros; assert (S : 0 <= sqrt (b * / (a + b)) * cos epsilon0).
{ apply Rmult_le_pos; [apply sqrt_pos | lra]. }
pose proof (share_below a b epsilon0 ltac:(lra) ltac:(lra)); apply Rle_ge.
destruct S as [P|P]; [left; apply asin_positive; lra | rewrite <- P, asin_0; lra].
