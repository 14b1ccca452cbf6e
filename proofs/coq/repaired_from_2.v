intros a b e s D E E0 E1 A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (ratio_of_leading a b e s (543 / 1000)); [lra | lra | lra | lra | exact D | lra |].
ratio_part (543 / 1000) a b e E 2 (57830350 / 100000000) 1 (353402 / 10000000) (124906 / 100000000) (541903 / 1000000) (71125 / 1000000).
ratio_part (543 / 1000) a b e E 2 (11566100 / 1000000000) (57830350 / 100000000) (110441 / 100000) (121983 / 100000) (310917 / 1000000) (54149 / 1000000).
ratio_rest_part (543 / 1000) a b e 2 (11566100 / 1000000000) (500001 / 1000000000000) (18237 / 100000000000).
