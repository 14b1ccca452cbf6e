intros; f_equal; try subst v_P; ring.
