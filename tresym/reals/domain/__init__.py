"""Where a claim speaks: conditions, exact points in them, domains, and values in balls."""
