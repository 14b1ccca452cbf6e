intros; apply claim_hyperbolic_tangent_below, claim_positive_time; assumption.
