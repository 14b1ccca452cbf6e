intros a b e s D E E0 E1 A B B1 A0 N.
rewrite (leading_of_defect a b e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) in D.
apply (ratio_of_leading a b e s (443 / 1000)); [lra | lra | lra | lra | exact D | lra |].
ratio_part (443 / 1000) a b e E 10 (25010580 / 100000000) 1 (107207 / 10000000) (114944 / 1000000000) (442286 / 1000000) 0.
ratio_rest_part (443 / 1000) a b e 10 (25010580 / 100000000) (125795 / 1000000) (95517 / 10000000).
