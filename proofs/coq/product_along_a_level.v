interval.
