intros T x G_1 G_2; pose proof (sinh_lt T (T + 2 * x) ltac:(lra)); lra.
