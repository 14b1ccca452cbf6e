intros I1 I2 I3 M a D G_1 G_2 G_3 G_4; intros; intros [_ U].
assert (I1 * (I2 * / I1) = I2) by (field; lra); subst a; nra.
