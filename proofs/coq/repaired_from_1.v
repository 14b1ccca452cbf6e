intros a b e s D E E0 E1 A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (ratio_of_leading a b e s (669 / 1000)); [lra | lra | lra | lra | exact D | lra |].
ratio_part (669 / 1000) a b e E 1 (76286270 / 100000000) 1 (518195 / 10000000) (268553 / 100000000) (666739 / 1000000) (28973 / 100000).
ratio_part (669 / 1000) a b e E 1 (19079640 / 100000000) (76286270 / 100000000) (391526 / 1000000) (153308 / 1000000) (522811 / 1000000) (81479 / 1000000).
ratio_rest_part (669 / 1000) a b e 1 (19079640 / 100000000) (146953 / 1000000) (10858 / 1000000).
