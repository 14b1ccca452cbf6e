"""Charts in which the margins of the bounds have no singular edge."""
