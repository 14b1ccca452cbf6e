one_defect claim_defect_is_one 1 (1 / 100) (125 / 100) (126 / 100) x X E.
one_defect claim_defect_is_one 1 (3 / 10) (24 / 100) (25 / 100) y Y F.
exists 1, 1, (1 / 100), (3 / 10); repeat (split; [numeric |]).
exists x, y; split; [exact E | split; [exact F | numeric]].
