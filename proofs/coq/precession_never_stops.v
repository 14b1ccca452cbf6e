intros a b x g A B G_3 G_4 G_5 G_6; apply claim_precession_goes_on; try lra.
- apply Rle_ge, pow2_ge_0.
- pose proof (SIN_bound x); nra.
