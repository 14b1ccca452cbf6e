one_defect claim_defect_is_one 1 (3 / 10) (24 / 100) (25 / 100) x X E.
one_defect claim_defect_is_one 10 (1 * (3 / 10) * / 10) (34 / 100) (35 / 100) y Y F.
exists 1, 10, (3 / 10); repeat (split; [lra |]).
exists x, y; split; [exact E | split; [| lra]].
replace (10 * 1 * (3 / 10) * / 10) with (10 * (1 * (3 / 10) * / 10)) by field; exact F.
