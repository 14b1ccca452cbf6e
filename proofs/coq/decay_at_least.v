intros a b A B B1 _ _ _ _ _; pose proof (asin_bound (sqrt (b * / (a + b)))) as [_ H].
pose proof (sqrt_pos (a * b)) as K; set (k := sqrt (a * b)) in *; set (t := asin _) in *.
split; apply Rle_ge, exp_rises; nra.
