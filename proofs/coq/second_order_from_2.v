intros a b k e s D E E0 E1 C A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (second_of_leading a b k e s (297 / 500) C ltac:(lra) D).
second_part (297 / 500) a b e E 2 (24011 / 25000) 1 (182469 / 20000000) (52023 / 5000000000) (416187 / 5000000000).
second_part (297 / 500) a b e E 2 (16941 / 50000) (24011 / 25000) (25283 / 250000) (122639 / 100000000) (102277 / 10000000).
second_part_flat (297 / 500) a b e E 2 (273 / 100000) (16941 / 50000) (33499 / 25000) (3591 / 2000) (2307 / 10000).
second_rest (297 / 500) a b e 2 (273 / 100000) (1001 / 1000000).
