"""Claims with known answers, for tests and measurements."""
