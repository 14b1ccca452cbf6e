intros s a b e A B B1 B2 E F S C H Z.
exists (- zero_rate s a b e), (-1).
split; [apply (over_by_end s a b A B); lra |].
split; [apply (over_by_value s a b A B e); lra |].
apply value_solution; try lra; try assumption.
- intros; ring.
