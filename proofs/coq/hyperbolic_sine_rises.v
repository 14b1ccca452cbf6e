intros T x _ G; apply Rge_le in G; destruct G as [G | Z].
{ pose proof (sinh_lt T (T + x) ltac:(lra)); lra. }
rewrite <- Z, Rplus_0_r; lra.
