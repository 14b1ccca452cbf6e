"""Growth by one idea: the most rapidly varying part, expanded with certified remainders."""
