"""Formulas and routes against each other: errors, constants, digits."""
