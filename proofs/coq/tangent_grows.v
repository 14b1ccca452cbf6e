intros T x _ X; pose proof (increasing_tanh T (T + x) ltac:(lra)); lra.
