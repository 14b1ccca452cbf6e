"""False variants of the claims, none of which may pass.

``mutants`` changes a true claim by one typical slip (``mutations``, ``number_mutations``);
``report`` judges the changed claims and lists those that pass. ``seeded_faults`` holds false
statements that pass when one guard of the judge is deleted.
"""
