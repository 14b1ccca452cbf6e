"""Compare formulas and methods: errors, constants and digits."""
