intros a b e v D P P1 -> A B B1 _; exact (line_from_four a b e D P P1 A B B1).
