intros a b k e s D E E0 E1 C A B B1 AB N; assert (A0 : 1 / 4 <= a) by nra.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (second_of_leading a b k e s (149 / 50) C ltac:(lra) D).
second_part (149 / 50) a b e E (1 / 4) (98291 / 100000) 1 (22337 / 200000) (61609 / 5000000) (1949 / 156250).
second_part (149 / 50) a b e E (1 / 4) (15329 / 20000) (98291 / 100000) (162603 / 1000000) (15841 / 625000) (132199 / 5000000).
second_part (149 / 50) a b e E (1 / 4) (35927 / 100000) (15329 / 20000) (82419 / 200000) (29143 / 250000) (169823 / 1000000).
second_part_flat (149 / 50) a b e E (1 / 4) (11437 / 100000) (35927 / 100000) (925103 / 1000000) (106977 / 125000) (39 / 100).
second_rest (149 / 50) a b e (1 / 4) (11437 / 100000) (1089 / 5000).
