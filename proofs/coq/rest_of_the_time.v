intros; rewrite acos_asin by lra; field.
