"""What only developers run, in a source checkout; the wheel does not contain it.

``bench`` times tresym against other tools, ``corpus`` holds claims with known truth, and
``mutants`` makes false variants of the ledger's claims. A command that needs one of them says so
in one line where it is missing. Tools that the package does not import are scripts in ``tests``.
"""
