"""The generated documents, built from the ledger."""
