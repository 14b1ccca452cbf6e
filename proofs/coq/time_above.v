intros a b e D E F A B B1 N1 N2 N3 N4 N5 N6 N7; rewrite <- D; apply claim_tangent_of_time; assumption.
