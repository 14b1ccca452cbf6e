intros a b e g A B G_3 G_4 G_5 G_6 G_7.
destruct (unturned b B g e) as [p [u [v [H1 [H2 [H3 P]]]]]]; try lra.
exists (- plain a b g e), (RInt (rate_slope 1 a b g) e (1 / 2 * PI)); split.
- apply (plain_by_start a b A B g u v); try lra; intros t; apply P; lra.
- apply (plain_by_level a b A B g p u v); try lra; exact P.
