"""The ledger: the claims of a paper, their evidence, and the judge of both."""
