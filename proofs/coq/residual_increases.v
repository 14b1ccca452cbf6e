intros a b e A B L G_4 G_5 G_6 G_7 N_1 N_2 N_3 N_4 N_5 N_6 N_7 N_8 N_9 N_10 N_11 N_12 N_13.
exists (/ root_of a b e * / sin e * ((-1) * b * sin e ^ 2 + 1)); split.
- apply (is_derive_ext (fun t : R => ln t - exponent a b t)).
  + intros t; unfold exponent, root_of; over_reals; ring.
  + eapply d_eq; [apply (d_minus ln (exponent a b)) | ].
    * apply is_derive_ln; lra.
    * apply (exponent_derive a b e A B); lra.
    * ring.
- pose proof (root_above a b e A B); pose proof (sin_square e).
  assert (0 < (-1) * b * sin e ^ 2 + 1) by nra; apply Rlt_gt; positive.
