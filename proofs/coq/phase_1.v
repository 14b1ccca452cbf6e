intros; pose proof (share_below a b epsilon0 ltac:(lra) ltac:(lra)); lra.
