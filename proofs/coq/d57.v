intros a b e D P Q A B B1 AB; intros; exact (slope_small a b e A B P Q D B1 AB).
