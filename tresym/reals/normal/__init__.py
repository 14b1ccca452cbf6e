"""The exact normal form: equal expressions have a difference that is 0."""
