"""Export claims to Coq, and find proofs that Coq checks.

``ledger_statements`` and ``statement`` turn a claim into a theorem; they import no prover.
``ledger_proofs`` searches for a script, and ``coqtop`` asks Coq about every candidate. ``export``
writes the stored theorems with their scripts as files that ``make`` compiles. ``claim_export``
does the same for one claim of a user.
"""
