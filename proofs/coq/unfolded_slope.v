intros a b x g A B B1 G G0 X X1 S Z.
exists (turned a b g x), (RInt (turned_slope a b g) 0 x).
split; [apply turned_by_angle; lra |].
split; [apply turned_by_levels; lra |].
apply turned_solution; try lra; try assumption.
- intros; ring.
