"""Claims with known truth, for tests and measurements."""
