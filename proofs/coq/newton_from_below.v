intros T k r x G_1 G_2 G_3 G_4 G_5 G_6 N; apply (convex_step k r x T); trivial; lra.
