"""Export claims to Coq, and find proofs that Coq checks."""
