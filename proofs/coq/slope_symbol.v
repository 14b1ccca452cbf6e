intros S a b e g A B G_3 G_4 G_5 G_6 G_7 G_8.
exists (- rate S a b g e); apply (turn_by_start S a b A B g (e - 1) (PI / 2 + 1)); try lra.
intros t _; pose proof (pow2_ge_0 (sin t)); nra.
