"""The paper's displays, theorems, tables and figures against the claims that answer them."""
