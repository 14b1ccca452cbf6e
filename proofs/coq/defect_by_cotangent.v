intros P a b e D_1 D_2 D_3 D_4 A B G_3 N_1 N_2 N_3; rewrite <- D_4 in D_1.
assert (S : 0 < sin e) by (apply sin_gt_0; lra); assert (C : 0 < cos e) by (apply cos_gt_0; lra).
destruct (root_facts a b e A B) as [W [Q F]].
rewrite (Rmult_comm P), (sinh_at_root a b _ e A B S C D_1).
rewrite (atan_unique _ (PI / 2 - e)); [field | lra |].
rewrite sin_shift, cos_shift; field; lra.
