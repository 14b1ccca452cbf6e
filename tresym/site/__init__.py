"""The documentation site: pages made from the ledger and the command line, for Sphinx.

``extension`` is loaded by Sphinx. It writes a page for every claim (``claims``), the command
reference (``commands``), and runs the examples of the pages; ``mathematics`` converts formulas to
MathML.
"""
