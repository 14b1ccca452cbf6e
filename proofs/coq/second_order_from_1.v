intros a b k e s D E E0 E1 C A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (second_of_leading a b k e s (83 / 100) C ltac:(lra) D).
second_part (83 / 100) a b e E 1 (47791 / 50000) 1 (311213 / 10000000) (60519 / 250000000) (121067 / 125000000).
second_part (83 / 100) a b e E 1 (9177 / 25000) (47791 / 50000) (184491 / 1000000) (403411 / 50000000) (34037 / 1000000).
second_part_flat (83 / 100) a b e E 1 (27 / 12500) (9177 / 25000) (28497 / 20000) (10151 / 5000) (1949 / 5000).
second_rest (83 / 100) a b e 1 (27 / 12500) (1001 / 1000000).
