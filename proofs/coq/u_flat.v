intros; cbv beta; f_equal; f_equal; field; lra.
