destruct floor_angles as [F [G P]]; split; [rewrite <- F; field; lra | exact G].
