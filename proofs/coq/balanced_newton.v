intros p a b e v D P P1 E -> A B B1 _; exact (newton_line_from_four a b e p D P P1 A B B1 E).
