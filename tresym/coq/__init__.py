"""Coq as a second kernel: statements printed for it, and proofs that it checks"""
