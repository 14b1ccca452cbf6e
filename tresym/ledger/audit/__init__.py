"""Compare the paper's displays, theorems, tables and figures with the claims about them."""
