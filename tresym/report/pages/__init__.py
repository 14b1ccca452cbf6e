"""The documents generated from the ledger."""
