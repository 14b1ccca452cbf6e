intros a b e D E F A B _ _ _ _; rewrite <- D; pose proof PI_RGT_0.
assert (K : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; positive).
destruct (share_below a b e A B) as [L U].
assert (S : 0 < sqrt (b * / (a + b)) * cos e).
{ apply Rmult_lt_0_compat; [apply sqrt_lt_R0; positive | apply cos_gt_0; lra]. }
assert (0 < asin (sqrt (b * / (a + b)) * cos e)).
{ rewrite (asin_by_atan _ (conj L U)), <- atan_0; apply atan_increasing, Rdiv_lt_0_compat; [exact S |].
  apply sqrt_lt_R0; nra. }
apply Rlt_gt, increasing_tanh; nra.
