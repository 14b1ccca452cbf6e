intros a b s D A B B1; assert (S : s > 0) by (exact (claim_leading_positive a b s D A B B1)).
pose proof (claim_arctangent_above (1 / 2 * s) ltac:(lra)); lra.
