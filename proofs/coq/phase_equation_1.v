intros; assumption.
