intros a b k e s D E E0 E1 C A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (second_of_leading a b k e s (107 / 250) C ltac:(lra) D).
second_part (107 / 250) a b e E 10 (6073 / 6250) 1 (51967 / 1250000000) (2738 / 63365988340473) (172837 / 100000000000000).
second_part (107 / 250) a b e E 10 (28989 / 50000) (6073 / 6250) (570783 / 1000000000) (791419 / 100000000000000) (162897 / 500000000000).
second_part_flat (107 / 250) a b e E 10 (1571 / 100000) (28989 / 50000) (553197 / 1000000) (306027 / 1000000) (3383 / 50000).
second_rest (107 / 250) a b e 10 (1571 / 100000) (1001 / 1000000).
