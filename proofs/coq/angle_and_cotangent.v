intros x G N; rewrite atan_inv by lra; field.
