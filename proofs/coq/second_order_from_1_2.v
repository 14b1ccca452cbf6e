intros a b k e s D E E0 E1 C A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (second_of_leading a b k e s (281 / 200) C ltac:(lra) D).
second_part (281 / 200) a b e E (1 / 2) (23767 / 25000) 1 (44091 / 625000) (248219 / 100000000) (497669 / 100000000).
second_part (281 / 200) a b e E (1 / 2) (22363 / 50000) (23767 / 25000) (58601 / 250000) (254691 / 10000000) (549453 / 10000000).
second_part_flat (281 / 200) a b e E (1 / 2) (5319 / 100000) (22363 / 50000) (3234 / 3125) (53549 / 50000) (1949 / 5000).
second_rest (281 / 200) a b e (1 / 2) (5319 / 100000) (1001 / 1000000).
