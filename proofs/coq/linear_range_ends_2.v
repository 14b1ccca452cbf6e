intros; field; lra.
