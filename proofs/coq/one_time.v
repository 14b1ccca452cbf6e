intros a b x y g A B C L G H X1 X2 E Y1 Y2 F; apply (u_phase_once a b A B C g); try lra.
transitivity PI; [exact F | symmetry; exact E].
