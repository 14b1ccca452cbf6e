"""One row for each function: what the readers, deciders and printers know about it.

:mod:`tresym.reals.functions.row` defines a row, :mod:`tresym.reals.functions.table` collects the
rows of all families. A function is added by adding a row to the module of its family.
"""
