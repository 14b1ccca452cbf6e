one_defect claim_defect_is_one 1 (3 / 10) (24 / 100) (25 / 100) x X E.
one_defect claim_defect_is_one 10 (31 / 1000) (33 / 100) (34 / 100) y Y F.
exists 1, 10, (3 / 10), (31 / 1000); repeat (split; [lra |]).
exists x, y; split; [exact E | split; [exact F | lra]].
