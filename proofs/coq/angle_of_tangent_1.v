intros; apply atan_tan; lra.
