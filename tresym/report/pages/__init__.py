"""The documents generated from the ledger.

``documents`` lists all of them and checks that they are up to date. Each other module writes one
kind of document from the findings of the ledger, from saved measurements, or from the source
code.
"""
