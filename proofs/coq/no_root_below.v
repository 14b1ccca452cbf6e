intros T k r G_1 G_2 G_3 G_4.
assert (P : 0 < tanh T).
{ unfold tanh; apply Rdiv_lt_0_compat; [rewrite <- sinh_0; now apply sinh_lt | apply cosh_pos]. }
assert (A : 0 < atan (r * tanh T)) by (rewrite <- atan_0; apply atan_increasing; nra).
nra.
