intros; rewrite turn_of_share, Rmult_assoc by lra; reflexivity.
