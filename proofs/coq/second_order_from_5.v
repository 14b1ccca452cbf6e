intros a b k e s D E E0 E1 C A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (second_of_leading a b k e s (467 / 1000) C ltac:(lra) D).
second_part (467 / 1000) a b e E 5 (12201 / 12500) 1 (353173 / 500000000) (249463 / 10000000000000) (19957 / 40000000000).
second_part (467 / 1000) a b e E 5 (30931 / 50000) (12201 / 12500) (414769 / 100000000) (167919 / 200000000000) (86017 / 5000000000).
second_part_flat (467 / 1000) a b e E 5 (453 / 20000) (30931 / 50000) (164157 / 250000) (431161 / 1000000) (277 / 2500).
second_rest (467 / 1000) a b e 5 (453 / 20000) (1001 / 1000000).
