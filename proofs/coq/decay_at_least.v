intros a b A B B1; intros; pose proof (asin_bound (sqrt (b * / (a + b)))) as U.
pose proof (sqrt_pos (a * b)) as K; split; apply Rle_ge, exp_rises; nra.
