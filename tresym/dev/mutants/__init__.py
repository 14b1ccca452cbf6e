"""False variants of the claims, none of which may pass.

``slips`` changes the line of a claim at one place, ``mutants`` reads it again with its evidence,
and ``report`` judges the changed claims and lists those that pass. ``seeded_faults`` holds false
claims that pass when one guard of the judge is deleted.
"""
