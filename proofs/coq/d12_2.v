intros; subst; f_equal; symmetry; apply sqrt_unique; [apply Rabs_pos |].
pose proof (pow2_ge_0 (sin psi)); assert (0 < a + b * sin psi ^ 2) by nra.
rewrite RPow_abs, Rabs_pos_eq by apply pow2_ge_0; rewrite (sin_square theta); field; lra.
