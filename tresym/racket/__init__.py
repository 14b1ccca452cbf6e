"""The freely rotating rigid body of the paper: formulas, motion and flip."""
