intros; pose proof (increasing_tanh v_T (v_T + x) ltac:(lra)); lra.
