intros T k r G_1 G_2 G_3 G_4.
pose proof (atan_bound (r * tanh T)) as [_ B]; nra.
