"""The site: pages made of the saved ledger and of the command line, and how Sphinx sets them."""
