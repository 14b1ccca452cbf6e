intros a b e s D E E0 E1 A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (ratio_of_leading a b e s (37 / 40)); [lra | lra | lra | lra | exact D | lra |].
ratio_part (37 / 40) a b e E (1 / 2) (92501060 / 100000000) 1 (743094 / 10000000) (552243 / 100000000) (917152 / 1000000) (72737 / 100000).
ratio_part_beyond (37 / 40) a b e E (1 / 2) (40483900 / 100000000) (92501060 / 100000000) (265950 / 1000000) (239355 / 1000000) (572963 / 10000000) (848761 / 1000000) (56117 / 100000).
ratio_rest_part (37 / 40) a b e (1 / 2) (40483900 / 100000000) (344947 / 1000000) (51310 / 1000000).
