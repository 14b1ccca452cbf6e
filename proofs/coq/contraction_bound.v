intros a b epsilon G_1 G_2 G_3 G_4 G_5 G_6 G_7.
pose proof (sin_square epsilon); assert (0 < sin epsilon ^ 2) by (apply pow_lt; lra).
assert (0 < cos epsilon ^ 2) by (apply pow_lt; lra).
split; nra.
