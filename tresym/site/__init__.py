"""The documentation site: pages made from the ledger and the command line, for Sphinx."""
