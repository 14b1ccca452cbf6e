intros x G_1 G_2 N_1 N_2 N_3 N_4; unfold atanh; replace ((1 + x) / (1 - x)) with (/ ((-1) * x + 1) * (x + 1)) by (field; lra); field.
