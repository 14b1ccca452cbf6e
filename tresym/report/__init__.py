"""Documents, figures and charts generated from the ledger and from computations."""
